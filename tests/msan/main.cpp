// run STRANGERS DECK ...: decks solved, and states of strangers taken up, with memory in which nothing is defined: what reaches
// the block store, the host's arrays or a choice has been computed.
#include "../fuzz/forged_state.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sanitizer/msan_interface.h>
#include <vector>

namespace {

void defined(const void* data, size_t bytes) { __msan_check_mem_is_initialized(data, bytes); }

// Memory as malloc gives it, undefined.
struct Room {
  char* data;
  size_t size;
  explicit Room(size_t bytes) : data(static_cast<char*>(std::malloc(bytes))), size(bytes) {}
  ~Room() { std::free(data); }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
};

struct Tape {
  std::vector<char> bytes;
  uint64_t each = 0;
};
struct Tapes {
  Tape tapes[C2D_TAPES];
  c2d_port port = C2D_INIT(c2d_port);
  Tapes() {
    port.context = this;
    port.open = [](void* c, int32_t t, uint64_t blocks, uint64_t bytes) {
      Tape& tape = self(c).tapes[t];
      if (tape.each != bytes) tape.bytes.clear();
      tape.bytes.resize(static_cast<size_t>(blocks * bytes)), tape.each = bytes;
      return int32_t{0};
    };
    port.read = [](void* c, int32_t t, uint64_t block, void* data, uint64_t bytes) {
      const Tape& tape = self(c).tapes[t];
      std::memcpy(data, tape.bytes.data() + block * tape.each, static_cast<size_t>(bytes));
      return int32_t{0};
    };
    port.write = [](void* c, int32_t t, uint64_t block, const void* data, uint64_t bytes) {
      Tape& tape = self(c).tapes[t];
      defined(data, static_cast<size_t>(bytes));
      std::memcpy(tape.bytes.data() + block * tape.each, data, static_cast<size_t>(bytes));
      return int32_t{0};
    };
    port.sync = port.close = [](void*, int32_t) { return int32_t{0}; };
    port.log = [](void*, const c2d_error* e) { defined(e, sizeof *e); };
  }
  static Tapes& self(void* context) { return *static_cast<Tapes*>(context); }
};

int32_t next_card(void* context, char* text, int32_t size) {
  char line[1024];
  if (std::fgets(line, sizeof line, static_cast<FILE*>(context)) == nullptr) return -1;
  size_t length = std::strlen(line);
  while (length > 0 && (line[length - 1] == '\n' || line[length - 1] == '\r')) --length;
  const size_t fits = length < static_cast<size_t>(size) ? length : static_cast<size_t>(size) - 1;
  std::memcpy(text, line, fits);
  text[fits] = '\0';
  return static_cast<int32_t>(length);
}

int32_t on_step(void*, const c2d_step* step) {
  for (int32_t p = 0; p < step->pairs; ++p) defined(step->table + p * step->stride, 16 * sizeof(double));
  defined(step->loads, static_cast<size_t>(step->cases) * sizeof(double));
  defined(step->work_by_case, static_cast<size_t>(step->cases) * sizeof(double));
  defined(step, sizeof *step);
  return 0;
}

void ask(c2d_solver* s) {
  c2d_summary sum = C2D_INIT(c2d_summary);
  if (c2d_get_summary(s, &sum) != C2D_OK) return;
  defined(&sum, sizeof sum);
  if (c2d_get_state(s) != C2D_STATE_RUNNING) return;
  const auto column = [s](int32_t field, int32_t body, int32_t count) {
    Room room(static_cast<size_t>(count > 0 ? count : 1) * sizeof(double));
    double* out = reinterpret_cast<double*>(room.data);
    if (count > 0 && c2d_get(s, field, body, 1, count, out, 1) == C2D_OK) defined(out, room.size);
  };
  for (int32_t field = 0; field < C2D_PAIR_FIELDS; ++field) column(field, 0, sum.pairs);
  for (int32_t body = 1; body <= sum.bodies; ++body) {
    c2d_body_result result = C2D_INIT(c2d_body_result);
    c2d_body_state state = C2D_INIT(c2d_body_state);
    if (c2d_get_body_result(s, body, &result) != C2D_OK) continue;
    defined(&result, sizeof result);
    if (c2d_get_body_state(s, body, &state) == C2D_OK) defined(&state, sizeof state);
    for (int32_t field = C2D_END_X; field <= C2D_END_PRINCIPAL2; ++field)
      column(field, body, result.elements * sum.function_nodes);
    Room room(static_cast<size_t>(result.elements) * C2D_OFF_FIELDS * sizeof(double));
    double* off = reinterpret_cast<double*>(room.data);
    if (c2d_indicators(s, body, 1, result.elements, off, C2D_OFF_FIELDS) == C2D_OK) defined(off, room.size);
  }
  for (int32_t zone = 1; zone <= sum.zones; ++zone) {
    c2d_zone_state state = C2D_INIT(c2d_zone_state);
    if (c2d_get_zone_state(s, zone, &state) == C2D_OK) defined(&state, sizeof state);
  }
  const double xy[] = {0.1, -0.2, 0.3, 0.4, 1.0, -1.0, 0.0, 5.0};
  Room room(4 * C2D_POINT_FIELDS * sizeof(double));
  double* inside = reinterpret_cast<double*>(room.data);
  if (c2d_interior(s, 0, 4, xy, 2, inside, C2D_POINT_FIELDS) == C2D_OK) defined(inside, room.size);
}

bool solve(FILE* file, const c2d_limits& limits, uint64_t bytes, Tapes& tapes, bool restores) {
  Room memory(static_cast<size_t>(bytes));
  c2d_solver* s = nullptr;
  std::rewind(file);
  if (c2d_create(&s, memory.data, memory.size, &limits, &tapes.port, nullptr) != C2D_OK) return false;
  c2d_options options = C2D_INIT(c2d_options);
  options.every_change = 1;
  if (c2d_set_options(s, &options) != C2D_OK || c2d_read_deck(s, next_card, file) != C2D_OK) return false;
  c2d_status status = restores ? c2d_restore(s) : c2d_prepare(s);
  if (status == C2D_OK && restores) ask(s);
  if (status == C2D_OK) status = c2d_run(s, on_step, nullptr);
  ask(s);
  if (status == C2D_OK && !restores) status = c2d_save(s);
  c2d_close(s);
  return status == C2D_OK || status == C2D_ERR_SINGULAR || status == C2D_ERR_ARGUMENT; // (a model without a path)
}

bool solve(const char* name) {
  FILE* file = std::fopen(name, "r");
  c2d_body_limits bodies[64];
  std::memset(bodies, 0, sizeof bodies);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.body = bodies, limits.bodies = 64;
  uint64_t least = 0, most = 0;
  bool well = file != nullptr && c2d_scan_deck(next_card, file, &limits, nullptr) == C2D_OK &&
              c2d_memory_need(&limits, &least, &most, nullptr) == C2D_OK;
  for (const uint64_t bytes : {least, most}) {
    Tapes tapes;
    well = well && solve(file, limits, bytes, tapes, false);
    if (well && bytes == least) solve(file, limits, bytes, tapes, true);
  }
  if (file != nullptr) std::fclose(file);
  if (!well) std::fprintf(stderr, "%s: cannot be solved\n", name);
  return well;
}

} // namespace

int main(int argc, char** argv) {
  int failed = 0, strangers = argc > 1 ? std::atoi(argv[1]) : 0;
  for (int i = 2; i < argc; ++i) failed += solve(argv[i]) ? 0 : 1;
  uint32_t dice = 14;
  for (int i = 0; i < strangers; ++i) {
    uint8_t bytes[64];
    for (uint8_t& b : bytes) b = static_cast<uint8_t>((dice = dice * 1664525u + 1013904223u) >> 24);
    forged::run(bytes, sizeof bytes);
  }
  std::printf("memory sanitizer: %d decks, %d strangers, %d failed\n", argc - 2, strangers, failed);
  return failed == 0 ? 0 : 1;
}
