/* Solves a deck in a static array: no heap, no files but the deck. C99, and valid C++.

     cc -std=c99 -Iinclude -Iport/memory examples/static_array.c build/libcontact2d.a -lm -o build/static_array
     build/static_array examples/hertz.dat

   after make in the project, or with an installed library `cc -std=c99 static_array.c -lcontact2d -lm`.          */
#include "c2d_memory.h"
#include "contact2d.h"
#include "contact2d_memory.h"

#include <stdio.h>
#include <string.h>

/* Workspace of the solver, for decks up to the size of examples/hertz.dat. The arguments are the members of c2d_limits. */
#define PANEL 8 /* columns eliminated at a time; a given number makes the sizes of the tapes constants */
static unsigned char memory[C2D_LIMITS_BYTES(2, 60, 60, 60, 60, 1, 1, 1, 20, 19, 0, 4, 20, 1, PANEL, 0, 0, 0)];
static unsigned char tapes[           /* blocks that could also be files */
    2 * C2D_LOWER_BLOCKS(2, 60, 60, 1, 20, 1, PANEL, 0) * C2D_LOWER_BLOCK_BYTES(2, 60, 60, 1, 0, PANEL) +
    2 * C2D_UPPER_BLOCKS(2, 60, 60, 1, 20, 1, PANEL) * C2D_UPPER_BLOCK_BYTES(2, 60, 60, 1, PANEL) +
    C2D_CONTACT_BLOCKS(2, 20, 1) * C2D_CONTACT_BLOCK_BYTES(20) + C2D_CONTROL_BLOCK_BYTES /* no saved states */];

/* Reads the next card, without its line end; returns its length. */
static int32_t read_card(void* context, char* text, int32_t size) {
  FILE* deck = (FILE*)context;
  int32_t length = 0;
  int c = fgetc(deck);
  if (c == EOF) return ferror(deck) ? -2 : -1;
  for (; c != EOF && c != '\n'; c = fgetc(deck)) {
    if (c == '\r') continue;
    if (length + 1 < size) text[length] = (char)c;
    ++length;
  }
  text[length < size ? length : size - 1] = '\0';
  return length;
}

/* Receives every error and every warning. */
static void report(void* context, const c2d_error* entry) {
  (void)context;
  fprintf(stderr, "%s: ", entry->severity == C2D_FAULT ? "error" : "warning");
  if (entry->line > 0) fprintf(stderr, "line %d, column %d: ", (int)entry->line, (int)entry->column);
  fprintf(stderr, "%s\n", entry->text);
}

/* Prints the largest pressure of all pairs after every increment. */
static int32_t show_step(void* context, const c2d_step* step) {
  double peak = 0.0;
  int32_t pair;
  (void)context;
  if (step->kind == C2D_STEP_STOPPED) printf("the path ended: %s\n", c2d_outcome_message(step->outcome));
  for (pair = 0; pair < step->pairs; ++pair) {
    const double tn = step->table[pair * step->stride + C2D_TN];
    if (tn > peak) peak = tn;
  }
  printf("mu %g  step %3d  load %8.4f  peak pressure %10.4f\n", step->mu, (int)step->step, step->load, peak);
  return 0;
}

static int failed(const char* what, c2d_status status, const c2d_error* why) {
  fprintf(stderr, "%s: %s (%s)\n", what, c2d_message(status), why->text);
  if (status == C2D_ERR_MEMORY) fprintf(stderr, "%llu bytes are needed\n", (unsigned long long)why->bytes_needed);
  return 1;
}

static int solve(c2d_solver* solver, FILE* deck) {
  c2d_error why = C2D_INIT(c2d_error);
  c2d_summary summary = C2D_INIT(c2d_summary);
  c2d_status status = c2d_read_deck(solver, read_card, deck);
  if (status == C2D_OK) status = c2d_prepare(solver);
  if (status == C2D_OK) status = c2d_run(solver, show_step, NULL);
  if (status != C2D_OK) {
    c2d_last_error(solver, &why);
    return failed("solver", status, &why);
  }
  status = c2d_get_summary(solver, &summary);
  if (status != C2D_OK) return 1;
  printf("%s: %s, %llu of %llu bytes used\n", summary.title, c2d_outcome_message(summary.outcome),
         (unsigned long long)summary.peak_bytes, (unsigned long long)sizeof memory);
  return 0;
}

int main(int argc, char** argv) {
  FILE* deck = argc == 2 ? fopen(argv[1], "r") : NULL;
  c2d_body_limits bodies[2];
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_error why = C2D_INIT(c2d_error);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store store;
  c2d_solver* solver = NULL;
  c2d_status status;
  int result;

  limits.bodies = 2; /* room for two bodies */
  limits.body = bodies;
  if (deck == NULL) {
    fprintf(stderr, "usage: static_array DECK\n");
    return 1;
  }
  status = c2d_scan_deck(read_card, deck, &limits, &why);
  if (status != C2D_OK) {
    fclose(deck);
    return failed("deck", status, &why);
  }
  rewind(deck);

  limits.panel_columns = PANEL;
  c2d_memory_store_init(&store, tapes, sizeof tapes);
  c2d_memory_store_port(&store, &port); /* also sets port.context, which log receives too */
  port.log = report;
  status = c2d_create(&solver, memory, sizeof memory, &limits, &port, &why);
  if (status != C2D_OK) {
    fclose(deck);
    return failed("workspace", status, &why);
  }
  result = solve(solver, deck);
  fclose(deck);
  status = c2d_close(solver);
  if (status != C2D_OK) fprintf(stderr, "close: %s\n", c2d_message(status));
  return status != C2D_OK ? 1 : result;
}
