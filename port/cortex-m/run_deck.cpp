// Solves a deck on a board and prints the contact results as the desktop program's --csv does.
// Command line (by semihosting): the deck, the folder for the tapes, the file for the results ("-": the
// console). Ends with 0, or with the c2d_status of the call that failed.
#include "c2d_semihosting.h"
#include "contact2d.h"
#include "contact2d_memory.h"
#include "semihosting.hpp"
#include "startup.hpp"

#include "memory/config.hpp"
#include "memory/text.hpp"

#include <string.h>

#ifndef RUN_DECK_BYTES // of workspace: default for examples/hertz.dat
#define RUN_DECK_BYTES C2D_MEMORY_BYTES(2, 46, 58, 46, 58, 1, 1, 1, 15, 14, 0, 2, 14, 1)
#endif
#ifndef RUN_DECK_BODIES // at most
#define RUN_DECK_BODIES 2
#endif

namespace {

alignas(64) unsigned char workspace[RUN_DECK_BYTES];
c2d_semihosting_store store;
c2d_semihosting_deck deck;
char arguments[104];
char line[312];
int32_t results;
c2d_error why;

void put_line(c2d::Text& text) {
  c2d::put_character(text, '\n');
  host::write(results, text.data, static_cast<uint32_t>(text.used));
  text = c2d::text_in(line);
}

// The next word of the command line, ended by a zero byte.
char* next_word(char** rest) {
  char* word = *rest;
  while (*word == ' ') ++word;
  char* end = word;
  while (*end != ' ' && *end != '\0') ++end;
  *rest = *end == ' ' ? end + 1 : end;
  *end = '\0';
  return word;
}

int32_t print_step(void*, const c2d_step* step) {
  static const char* const kStatus[] = {"open", "stick", "slip"};
  c2d::Text text = c2d::text_in(line);
  for (int32_t p = 0; p < step->pairs; ++p) {
    const double* row = step->table + p * step->stride;
    c2d::put(text, step->mu, 15);
    c2d::put_character(text, ',');
    c2d::put(text, step->step);
    c2d::put_character(text, ',');
    c2d::put(text, step->load, 15);
    c2d::put_character(text, ',');
    c2d::put(text, p + 1);
    for (int32_t column = C2D_X; column <= C2D_SLIP_SUM; ++column) {
      c2d::put_character(text, ',');
      if (column == C2D_STATUS)
        c2d::put(text, kStatus[static_cast<int32_t>(row[column])]);
      else
        c2d::put(text, row[column], 15);
    }
    put_line(text);
  }
  return 0;
}

void tell(void*, const c2d_error* entry) {
  host::say(entry->severity == C2D_FAULT ? "error: " : "warning: ");
  host::say(entry->text);
  host::say("\n");
}

int failed(const char* what, c2d_status status) {
  host::say(what);
  host::say(": ");
  host::say(c2d_message(status));
  host::say(": ");
  host::say(why.text);
  host::say("\n");
  return status;
}

// Reports the memory used on the board to the host.
void tell_memory() {
  c2d::Text text = c2d::text_in(line);
  c2d::put(text, "memory: workspace ");
  c2d::put(text, sizeof workspace);
  c2d::put(text, ", stack ");
  c2d::put(text, stack_size());
  c2d::put(text, ", of it painted over ");
  c2d::put(text, stack_used());
  c2d::put(text, "\n");
  host::say(line);
}

int solve(c2d_solver* solver) {
  c2d_status status = c2d_read_deck(solver, c2d_semihosting_next_card, &deck);
  if (status == C2D_OK) status = c2d_prepare(solver);
  if (status == C2D_OK) status = c2d_run(solver, print_step, nullptr);
  if (status != C2D_OK) {
    c2d_last_error(solver, &why);
    return failed("solving", status);
  }
  tell_memory();
  return 0;
}

} // namespace

int main() {
  static c2d_limits limits;
  static c2d_body_limits bodies[RUN_DECK_BODIES];
  static c2d_port port;
  limits.struct_size = sizeof limits;
  limits.bodies = RUN_DECK_BODIES;
  limits.body = bodies;
  port.struct_size = sizeof port;
  why.struct_size = sizeof why;
  host::command_line(arguments, sizeof arguments);
  char* rest = arguments;
  const char* const deck_name = next_word(&rest);
  const char* const folder = next_word(&rest);
  const char* name = next_word(&rest);
  if (name[0] == '-' || name[0] == '\0') name = ":tt";
  if (c2d_semihosting_open_deck(&deck, deck_name) != 0) return failed(deck_name, C2D_ERR_READ);
  if (c2d_semihosting_store_init(&store, folder) != 0) return failed(folder, C2D_ERR_STORE_OPEN);
  c2d_semihosting_store_port(&store, &port);
  port.log = tell;
  results = host::open(name, host::Mode::write);

  c2d::Text text = c2d::text_in(line);
  c2d::put(text, "mu,step,load,pair,x,y,status,tn,tt,un1,ut1,un2,ut2,gap,slip");
  put_line(text);
  c2d_solver* solver = nullptr;
  c2d_status status = c2d_scan_deck(c2d_semihosting_next_card, &deck, &limits, &why);
  if (c2d_semihosting_rewind_deck(&deck) != 0) status = C2D_ERR_READ;
  if (status == C2D_OK) status = c2d_create(&solver, workspace, sizeof workspace, &limits, &port, &why);
  const int ended = status == C2D_OK ? solve(solver) : failed(deck_name, status);
  if (solver != nullptr) c2d_close(solver);
  c2d_semihosting_close_deck(&deck);
  host::close(results);
  return ended;
}
