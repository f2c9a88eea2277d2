// A program that names no call of an optional part (src/memory/parts.hpp), with a library compiled with
// C2D_PARTS_BY_CALL: what it is told when a deck, an option, a workspace or a saved state wants one (test_parts.cpp).
//   parts deck DECK             parts images, parts compressed
//   parts attach WORKSPACE      parts restore DECK FOLDER
//   parts follow DECK FOLDER MU LOAD
//   parts state DECK FOLDER MU LOAD    parts free
//   parts prepare WORKSPACE FOLDER MU LOAD
#include <c2d_posix.h>
#include <contact2d.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

alignas(64) unsigned char workspace[1 << 22];

int32_t next_card(void* deck, char* text, int32_t size) {
  std::FILE* const file = static_cast<std::FILE*>(deck);
  if (std::fgets(text, size, file) == nullptr) return -1;
  text[std::strcspn(text, "\n")] = '\0';
  return static_cast<int32_t>(std::strlen(text));
}

void tell(void*, const c2d_error* e) {
  if (e->severity == C2D_FAULT) std::printf("line %d, columns %d-%d: %s\n", e->line, e->column, e->column_end, e->text);
}

int end(c2d_solver* solver, c2d_status status) {
  c2d_error why = C2D_INIT(c2d_error);
  if (solver != nullptr && status != C2D_OK && c2d_last_error(solver, &why) == C2D_OK) std::printf("%s\n", why.text);
  std::printf("status %d\n", status);
  return 0;
}

c2d_status read_model(const char* name, c2d_port& port, c2d_solver** solver, void (*log)(void*, const c2d_error*) = tell) {
  c2d_body_limits bodies[2];
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 2, limits.body = bodies;
  std::FILE* const deck = std::fopen(name, "r");
  if (deck == nullptr) return C2D_ERR_READ;
  port.log = log;
  c2d_status status = c2d_scan_deck(next_card, deck, &limits, nullptr);
  std::rewind(deck);
  if (status == C2D_OK) status = c2d_create(solver, workspace, sizeof workspace, &limits, &port, nullptr);
  if (status == C2D_OK) status = c2d_read_deck(*solver, next_card, deck);
  std::fclose(deck);
  return status;
}

int ask_for(int32_t symmetry, int32_t elimination) {
  c2d_body_limits body = {4, 4, 1, 0};
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_options options = C2D_INIT(c2d_options);
  c2d_solver* solver = nullptr;
  limits.bodies = 1;
  limits.body = &body;
  limits.function_nodes = 2;
  if (c2d_create(&solver, workspace, sizeof workspace, &limits, nullptr, nullptr) != C2D_OK) return 1;
  options.symmetry = symmetry;
  options.elimination = elimination;
  return end(solver, c2d_set_options(solver, &options));
}

c2d_status take_up(const char* name, const c2d_port& port, c2d_solver** solver) {
  std::FILE* const file = std::fopen(name, "rb");
  if (file == nullptr) return C2D_ERR_READ;
  const size_t bytes = std::fread(workspace, 1, sizeof workspace, file);
  std::fclose(file);
  c2d_error why = C2D_INIT(c2d_error);
  const c2d_status status = c2d_attach(solver, workspace, bytes, &port, &why);
  if (status != C2D_OK) std::printf("%s\n", why.text);
  return status;
}

int attach(const char* name) {
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store store; // of no use: nothing is read
  c2d_solver* solver = nullptr;
  c2d_posix_store_port(&store, &port);
  return end(nullptr, take_up(name, port, &solver));
}

int restore(const char* deck, const char* folder) {
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store store;
  c2d_solver* solver = nullptr;
  if (c2d_posix_store_init(&store, folder) != 0) return 1;
  c2d_posix_store_port(&store, &port);
  if (read_model(deck, port, &solver) != C2D_OK) return 1;
  const c2d_status status = c2d_restore(solver);
  end(solver, status);
  return c2d_posix_store_done(&store) != 0;
}

void tell_warning(void*, const c2d_error* e) {
  if (e->severity == C2D_WARNING) std::printf("warning %d\n", e->status);
}

// Adds a free zone by its call: two bodies of one element each, of which the last and the first face each other.
int add_free_zone() {
  c2d_body_limits bodies[2] = {{4, 4, 1, 0}, {4, 4, 1, 0}};
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 2, limits.body = bodies, limits.function_nodes = 2;
  limits.zones = 1, limits.pairs = limits.free_pairs = 2, limits.contact_elements = 1;
  c2d_solver* solver = nullptr;
  if (c2d_create(&solver, workspace, sizeof workspace, &limits, nullptr, nullptr) != C2D_OK) return 1;
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = 4, body.regions = 1, body.youngs_modulus = 1;
  for (int32_t b = 1; b <= 2; ++b)
    if (c2d_set_body(solver, b, &body) != C2D_OK || c2d_add_region(solver, b, 1, 4) != C2D_OK) return 1;
  c2d_zone zone = C2D_INIT(c2d_zone);
  zone.kind = C2D_ZONE_FREE;
  zone.side1.body = 1, zone.side1.first_element = zone.side1.last_element = 3, zone.side1.elements = 1;
  zone.side2.body = 2, zone.side2.first_element = zone.side2.last_element = 1, zone.side2.elements = 1;
  return end(solver, c2d_add_zone(solver, &zone));
}

c2d_status advance(c2d_solver* solver, double mu, double load) {
  c2d_status status = c2d_prepare(solver);
  if (status == C2D_OK) status = c2d_begin(solver, &mu, 1);
  c2d_outcome outcome = C2D_REACHED;
  if (status == C2D_OK) status = c2d_advance(solver, &load, 1, &outcome);
  std::printf("outcome %d\n", outcome);
  double pressure;
  for (int32_t i = 1; i <= 64 && c2d_get(solver, C2D_TN, 0, i, 1, &pressure, 1) == C2D_OK; ++i) std::printf("%.9g\n", pressure);
  return status;
}

// The same from the workspace of another program.
int prepare(const char* name, const char* folder, double mu, double load) {
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store store;
  c2d_solver* solver = nullptr;
  if (c2d_posix_store_init(&store, folder) != 0) return 1;
  c2d_posix_store_port(&store, &port);
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) port.open(port.context, tape, 1, 64); // they are open, the workspace says
  c2d_status status = take_up(name, port, &solver);
  if (status == C2D_OK) status = advance(solver, mu, load);
  end(solver, status);
  return c2d_posix_store_done(&store) != 0;
}

// Advances to one load factor: how it ended, where, and the statuses of the pairs there; `state`: what zone 1 has dissipated,
// and whether the workspace can be taken up again.
int follow(const char* deck, const char* folder, double mu, double load, bool state) {
  c2d_port port = C2D_INIT(c2d_port);
  c2d_posix_store store;
  c2d_solver* solver = nullptr;
  if (c2d_posix_store_init(&store, folder) != 0) return 1;
  c2d_posix_store_port(&store, &port);
  c2d_status status = read_model(deck, port, &solver, tell_warning);
  if (status == C2D_OK) status = advance(solver, mu, load);
  if (state) {
    c2d_zone_state zone = C2D_INIT(c2d_zone_state);
    status = c2d_get_zone_state(solver, 1, &zone);
    std::printf("slips %d, dissipated %s\n", zone.slip > 0, zone.dissipated > 0 ? "more" : "nothing");
    if (status == C2D_OK) status = c2d_attach(&solver, workspace, sizeof workspace, &port, nullptr);
  }
  end(solver, status);
  return c2d_posix_store_done(&store) != 0;
}

} // namespace

int main(int count, char** argument) {
  const auto is = [&](const char* what, int arguments) {
    return count == 2 + arguments && std::strcmp(argument[1], what) == 0;
  };
  if (is("images", 0)) return ask_for(C2D_SYMMETRY_IMAGES, C2D_ELIMINATION_DENSE);
  if (is("compressed", 0)) return ask_for(C2D_SYMMETRY_DECK, C2D_ELIMINATION_COMPRESSED);
  if (is("attach", 1)) return attach(argument[2]);
  if (is("restore", 2)) return restore(argument[2], argument[3]);
  if (is("free", 0)) return add_free_zone();
  if (is("prepare", 4)) return prepare(argument[2], argument[3], std::atof(argument[4]), std::atof(argument[5]));
  if (is("follow", 4) || is("state", 4))
    return follow(argument[2], argument[3], std::atof(argument[4]), std::atof(argument[5]), is("state", 4));
  if (!is("deck", 1)) return 64;
  c2d_port port = C2D_INIT(c2d_port);
  c2d_solver* solver = nullptr;
  return end(nullptr, read_model(argument[2], port, &solver));
}
