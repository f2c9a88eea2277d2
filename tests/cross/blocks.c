/* blocks write FOLDER: solve the first load cards of the sample, blocks in files, and keep the state.
   blocks read FOLDER: go on from there. Prints the status and what the library says of it.
   blocks solve FOLDER: all of the sample. Prints the table of its pairs. */
#include "c2d_stdio.h"
#include "contact2d.h"
#include <stdio.h>
#include <string.h>

static unsigned char memory[1 << 19];

static int32_t next_card(void* deck, char* text, int32_t size) {
  if (fgets(text, (int)size, (FILE*)deck) == NULL) return -1;
  text[strcspn(text, "\r\n")] = '\0';
  return (int32_t)strlen(text);
}

static int32_t print_step(void* context, const c2d_step* step) {
  static const char* const names[] = {"open", "stick", "slip"};
  int32_t pair, column;
  (void)context;
  for (pair = 0; pair < step->pairs; ++pair) {
    const double* row = step->table + pair * step->stride;
    printf("%.12g,%ld,%.12g,%ld", step->mu, (long)step->step, step->load, (long)pair + 1);
    for (column = C2D_X; column <= C2D_SLIP_SUM; ++column)
      if (column == C2D_STATUS)
        printf(",%s", names[(int)row[column]]);
      else
        printf(",%.12g", row[column]);
    printf("\n");
  }
  return 0;
}

static c2d_status solve(c2d_solver* solver) {
  const c2d_status status = c2d_prepare(solver);
  printf("mu,step,load,pair,x,y,status,tn,tt,un1,ut1,un2,ut2,gap,slip\n");
  return status == C2D_OK ? c2d_run(solver, print_step, NULL) : status;
}

int main(int count, char** argument) {
  FILE* deck = fopen("examples/hertz.dat", "r");
  c2d_body_limits bodies[2];
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_error why = C2D_INIT(c2d_error);
  c2d_stdio_store store;
  c2d_solver* solver = NULL;
  c2d_outcome outcome;
  const double mu = 0.4, load = 0.5, further = 1.0;
  c2d_status status;
  int writes, solves;
  if (count != 3 || deck == NULL) return 64;
  limits.bodies = 2;
  limits.body = bodies;
  writes = strcmp(argument[1], "write") == 0;
  solves = strcmp(argument[1], "solve") == 0;
  c2d_stdio_store_init(&store, argument[2]);
  c2d_stdio_store_port(&store, &port);
  status = c2d_scan_deck(next_card, deck, &limits, &why);
  rewind(deck);
  if (status == C2D_OK) status = c2d_create(&solver, memory, sizeof memory, &limits, &port, &why);
  if (status == C2D_OK) status = c2d_read_deck(solver, next_card, deck);
  if (solves) {
    if (status == C2D_OK) status = solve(solver);
  } else if (writes) {
    if (status == C2D_OK) status = c2d_prepare(solver);
    if (status == C2D_OK) status = c2d_begin(solver, &mu, 1);
    if (status == C2D_OK) status = c2d_advance(solver, &load, 1, &outcome);
    if (status == C2D_OK) status = c2d_save(solver);
  } else {
    if (status == C2D_OK) status = c2d_restore(solver);
    if (status == C2D_OK) status = c2d_advance(solver, &further, 1, &outcome);
  }
  if (solver != NULL) c2d_last_error(solver, &why);
  if (!solves || status != C2D_OK) printf("%d %s\n", (int)status, status == C2D_OK ? "as one's own" : why.text);
  if (solver != NULL) c2d_close(solver);
  fclose(deck);
  return status == C2D_OK ? 0 : 1;
}
