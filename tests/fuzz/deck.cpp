// Card text through the library: sizes, faults, model, equations and load path. What c2d_check_deck accepts, c2d_read_deck
// reads within the limits that were told; what it refuses is told with its place.
#include "fuzz.hpp"

#include <c2d_memory.h>

#include <memory>

namespace {

constexpr int32_t kBodies = 64;
constexpr uint64_t kMostBytes = 8u << 20; // of workspace
constexpr int32_t kMostUnknowns = 120;    // of a body, when equations are solved
constexpr int32_t kMostPolls = 1500;      // then the run is cancelled

struct Heard {
  size_t lines;
  int32_t faults;
};

void hear(void* context, const c2d_error* entry) {
  Heard& heard = *static_cast<Heard*>(context);
  fuzz::require_message(*entry, heard.lines);
  if (entry->severity != C2D_FAULT) return;
  fuzz::require(entry->status != C2D_OK, "a fault has a status");
  ++heard.faults;
}

struct Host {
  c2d_memory_store store;
  Heard heard;
  int32_t polls;
};

c2d_port port_of(Host& host) {
  static c2d_port inner;
  inner = C2D_INIT(c2d_port);
  c2d_memory_store_port(&host.store, &inner);
  c2d_port port = inner;
  port.context = &host;
  port.open = [](void* c, int32_t t, uint64_t n, uint64_t bytes) {
    return inner.open(&static_cast<Host*>(c)->store, t, n, bytes);
  };
  port.read = [](void* c, int32_t t, uint64_t b, void* d, uint64_t n) {
    return inner.read(&static_cast<Host*>(c)->store, t, b, d, n);
  };
  port.write = [](void* c, int32_t t, uint64_t b, const void* d, uint64_t n) {
    return inner.write(&static_cast<Host*>(c)->store, t, b, d, n);
  };
  port.sync = [](void* c, int32_t t) { return inner.sync(&static_cast<Host*>(c)->store, t); };
  port.close = [](void* c, int32_t t) { return inner.close(&static_cast<Host*>(c)->store, t); };
  port.cancel = [](void* c) { return static_cast<int32_t>(++static_cast<Host*>(c)->polls > kMostPolls); };
  port.log = [](void* c, const c2d_error* entry) { hear(&static_cast<Host*>(c)->heard, entry); };
  return port;
}

bool is_small(c2d_solver* solver) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  fuzz::require(c2d_get_summary(solver, &summary) == C2D_OK, "a model has a summary");
  for (int32_t b = 1; b <= summary.bodies; ++b) {
    c2d_body_result body = C2D_INIT(c2d_body_result);
    fuzz::require(c2d_get_body_result(solver, b, &body) == C2D_OK, "a body of the model");
    if (body.unknowns > kMostUnknowns) return false;
  }
  return summary.bodies <= 4 && summary.coefficients <= 4 && summary.load_cases <= 8;
}

int32_t look(void* context, const c2d_step* step) {
  fuzz::require(step->pairs >= 0 && step->stride >= 1, "a table of pairs");
  return ++*static_cast<int32_t*>(context) > 200 ? 1 : 0;
}

void solve(c2d_solver* solver) {
  const c2d_status prepared = c2d_prepare(solver);
  if (prepared != C2D_OK) {
    fuzz::require(prepared == C2D_ERR_SINGULAR || prepared == C2D_ERR_CANCELLED, "prepared, singular or cancelled");
    return;
  }
  int32_t steps = 0;
  const c2d_status status = c2d_run(solver, look, &steps);
  fuzz::require(status == C2D_OK || status == C2D_ERR_CANCELLED || status == C2D_ERR_CALLBACK || status == C2D_ERR_ARGUMENT,
                "a path that is followed, cancelled or not there");
}

void read_and_solve(const std::string& text, const c2d_limits& limits) {
  uint64_t minimum = 0;
  c2d_error why = C2D_INIT(c2d_error);
  const c2d_status need = c2d_memory_need(&limits, &minimum, nullptr, &why);
  fuzz::require(need == C2D_OK || need == C2D_ERR_OVERFLOW, "a need of memory");
  if (need != C2D_OK || minimum > kMostBytes) return;
  std::vector<unsigned char> memory(static_cast<size_t>(minimum) + (1u << 16)), region(4u << 20);
  auto host = std::make_unique<Host>();
  c2d_memory_store_init(&host->store, region.data(), region.size());
  host->heard = {fuzz::count_lines(text), 0};
  host->polls = 0;
  const c2d_port port = port_of(*host);
  c2d_solver* solver = nullptr;
  fuzz::require(c2d_create(&solver, memory.data(), memory.size(), &limits, &port, &why) == C2D_OK, "a solver in its need");
  fuzz::Lines lines(text);
  const c2d_status status = c2d_read_deck(solver, fuzz::Lines::read, &lines);
  fuzz::require(status == C2D_OK || status == C2D_ERR_INPUT, "a deck read within the limits that were told");
  fuzz::require((status == C2D_OK) == (host->heard.faults == 0), "a deck that is refused has a fault that was told");
  fuzz::require(c2d_get_state(solver) == (status == C2D_OK ? C2D_STATE_MODEL : C2D_STATE_EMPTY), "a model, or none");
  host->polls = 0;
  if (status == C2D_OK && is_small(solver)) solve(solver);
  c2d_close(solver);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::text_of(data, size);
  std::vector<c2d_body_limits> body(kBodies), again(kBodies);
  c2d_limits limits = C2D_INIT(c2d_limits), scanned = C2D_INIT(c2d_limits);
  limits.bodies = scanned.bodies = kBodies;
  limits.body = body.data(), scanned.body = again.data();
  Heard heard = {fuzz::count_lines(text), 0};
  fuzz::Lines first(text), second(text);
  const c2d_status checked = c2d_check_deck(fuzz::Lines::read, &first, &limits, hear, &heard);
  c2d_error why = C2D_INIT(c2d_error);
  const c2d_status status = c2d_scan_deck(fuzz::Lines::read, &second, &scanned, &why);
  fuzz::require(checked == status, "check and scan agree");
  fuzz::require(status == C2D_OK || status == C2D_ERR_INPUT || status == C2D_ERR_LIMIT, "accepted or refused");
  fuzz::require((status == C2D_OK) == (heard.faults == 0), "what is refused has a fault that was told");
  fuzz::require(status == C2D_OK || why.status == status, "the first fault is kept");
  fuzz::require(heard.faults <= 101, "faults come to an end");
  if (status == C2D_OK) read_and_solve(text, limits);
  return 0;
}
