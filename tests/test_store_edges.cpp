// As tests/test_store_sweep.cpp, of models with more behind them: contact on demand, bodies that contact alone holds, layers
// whose displacements are unknowns of the contact system, cycles of loads, two load cases, states taken up with another
// friction.
#include "contact2d_cycle.h"
#include "on_demand.hpp"
#include "store_places.hpp"

#include <set>

using namespace runs;

namespace {

using Loads = std::vector<std::vector<double>>;

struct Told {
  std::string name;
  many::Model model;
  Loads loads;            // one after the other
  std::vector<double> mu; // each from the beginning
  Loads cycle = {};
  uint64_t bytes = 0; // of workspace, where the least does not do
};

// The solver of one life, in the least workspace.
struct Solver {
  std::vector<c2d_body_limits> list;
  c2d_limits limits;
  uint64_t bytes = 0;
  c2d_port port = C2D_INIT(c2d_port);
  std::unique_ptr<Machine> machine;
  Solver(const Told& told, RamStore& store) : limits(many::limits_of(told.model, list)) {
    store.serve(port);
    REQUIRE(c2d_memory_need(&limits, &bytes, nullptr, nullptr) == C2D_OK);
    bytes = std::max(2 * bytes, told.bytes);
    machine = std::make_unique<Machine>(limits, bytes, &port);
    REQUIRE(machine->created == C2D_OK);
  }
};

struct Looker {
  c2d_solver* s;
  Caller& did;
  Numbers& to;

  void keep(const double* from, size_t count) const { to.boundary.insert(to.boundary.end(), from, from + count); }
  bool pairs() const {
    const int32_t count = summary_of(s).pairs;
    for (const int32_t field : {C2D_TN, C2D_TT, C2D_UN1, C2D_UT2, C2D_STATUS, C2D_GAP}) {
      std::vector<double> out(static_cast<size_t>(count));
      if (!did("c2d_get", c2d_get(s, field, 0, 1, count, out.data(), 1))) return false;
      keep(out.data(), out.size());
    }
    return true;
  }
  bool energies() const {
    c2d_summary sum = C2D_INIT(c2d_summary);
    if (!did("c2d_get_summary", c2d_get_summary(s, &sum))) return false;
    const double all[] = {sum.work, sum.elastic, sum.dissipated, sum.energy_defect};
    keep(all, 4);
    return true;
  }
  bool zones() const {
    for (int32_t zone = 1; zone <= summary_of(s).zones; ++zone) {
      c2d_zone_state out = C2D_INIT(c2d_zone_state);
      if (!did("c2d_get_zone_state", c2d_get_zone_state(s, zone, &out))) return false;
    }
    return true;
  }
  bool body(int32_t number) const {
    c2d_body_result own = C2D_INIT(c2d_body_result);
    c2d_body_state moved = C2D_INIT(c2d_body_state);
    if (!did("c2d_get_body_result", c2d_get_body_result(s, number, &own))) return false;
    if (!did("c2d_get_body_state", c2d_get_body_state(s, number, &moved))) return false;
    keep(own.contact, 3), keep(moved.contact, 3);
    std::vector<double> off(static_cast<size_t>(own.elements) * C2D_OFF_FIELDS), in(2 * C2D_POINT_FIELDS);
    if (own.elements == 0) return true;
    if (!did("c2d_indicators", c2d_indicators(s, number, 1, own.elements, off.data(), C2D_OFF_FIELDS))) return false;
    double at[4] = {}, ends[8];
    for (int32_t k = 0; k < 2; ++k) // two points, of the middle of the first elements, just within
      for (int32_t c = 0; c < 2; ++c) {
        if (!did("c2d_get", c2d_get(s, C2D_END_X + c, number, 2 * k + 1, 2, ends, 1))) return false;
        at[2 * k + c] = 0.5 * (ends[0] + ends[1]);
      }
    const double dx = at[2] - at[0], dy = at[3] - at[1];
    for (int32_t k = 0; k < 2; ++k) at[2 * k] -= 0.05 * dy, at[2 * k + 1] += 0.05 * dx;
    if (!did("c2d_interior", c2d_interior(s, number, 2, at, 2, in.data(), C2D_POINT_FIELDS))) return false;
    keep(off.data(), off.size()), keep(in.data(), in.size());
    return true;
  }
  bool all() const {
    if (!pairs() || !energies() || !zones()) return false;
    for (int32_t number = 1; number <= summary_of(s).bodies; ++number)
      if (!body(number)) return false;
    return true;
  }
};

bool advance(c2d_solver* s, Caller& did, const std::vector<double>& load) {
  c2d_outcome outcome = C2D_REACHED;
  return did("c2d_advance", c2d_advance(s, load.data(), static_cast<int32_t>(load.size()), &outcome));
}
bool follow_cycle(c2d_solver* s, Caller& did, const Loads& cycle) {
  std::vector<double> all;
  for (const std::vector<double>& corner : cycle) all.insert(all.end(), corner.begin(), corner.end());
  c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
  c2d_cycle_state state = C2D_INIT(c2d_cycle_state);
  request.corners = static_cast<int32_t>(cycle.size());
  request.cases = static_cast<int32_t>(cycle[0].size());
  request.load = all.data();
  request.limit = 12;
  const auto each = [](void* to, const c2d_cycle_state*) -> int32_t {
    const Looker& look = *static_cast<const Looker*>(to);
    return look.zones() ? 0 : 1;
  };
  Looker look{s, did, did.life.numbers};
  const c2d_status status = c2d_cycle(s, &request, each, &look, &state);
  return did("c2d_cycle", status);
}

Life live(const Told& told, RamStore& store) {
  Life life;
  Solver own(told, store);
  c2d_solver* const s = own.machine->solver;
  Caller did{s, life};
  const Looker look{s, did, life.numbers};
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = told.model.elimination, options.keep_factors = 1;
  did("c2d_set_options", c2d_set_options(s, &options));
  if (did("feed", many::feed(s, told.model))) did("c2d_prepare", c2d_prepare(s));
  if (life.status == C2D_OK) CHECK((s->model.columns > 0) == (told.model.touching > 0));
  for (const double mu : told.mu) {
    did("c2d_begin", life.status == C2D_OK ? c2d_begin(s, &mu, 1) : C2D_OK);
    for (const std::vector<double>& load : told.loads)
      if (life.status != C2D_OK || !advance(s, did, load)) break;
    if (life.status == C2D_OK) look.all();
    if (!told.cycle.empty() && life.status == C2D_OK && advance(s, did, told.cycle.back())) follow_cycle(s, did, told.cycle);
    if (life.status == C2D_OK && mu == told.mu[0]) did("c2d_save", c2d_save(s));
  }
  std::vector<double> forth(told.loads[0].size(), 1.0);
  double step = 0;
  if (life.status == C2D_OK) did("c2d_next_event", c2d_next_event(s, forth.data(), static_cast<int32_t>(forth.size()), &step));
  if (life.status == C2D_OK) did("c2d_restore", c2d_restore(s));
  if (life.status == C2D_OK && advance(s, did, told.loads[0])) look.all();
  if (life.status == C2D_OK) did("c2d_change_loads", c2d_change_loads(s));
  if (life.status == C2D_OK) did("c2d_prepare", c2d_prepare(s));
  if (life.status == C2D_OK) did("c2d_begin", c2d_begin(s, &told.mu[0], 1));
  for (const std::vector<double>& load : told.loads)
    if (life.status != C2D_OK || !advance(s, did, load)) break;
  if (life.status == C2D_OK) did("c2d_get", get_boundary(s, life.numbers));
  CHECK(own.machine->guards_are_whole());
  return life;
}

// What a failing operation leads to.
void check_failure(const Told& told, size_t n, const Life& clean) {
  RamStore store;
  RamStore::Operation failed{};
  store.before = [&](const RamStore::Operation& operation, size_t i) {
    if (i != n) return 0;
    failed = operation;
    return 1000 + operation.kind;
  };
  const Life life = live(told, store);
  CAPTURE(n);
  CAPTURE(failed.kind);
  CAPTURE(failed.tape);
  CAPTURE(life.call);
  check_failed_life(life, clean, failed);
}

// Over all models a place needs to fail once; in short every call that leads to one.
std::set<uint64_t> seen;
std::set<uintptr_t> seen_calls;
bool is_new(const std::vector<uintptr_t>& calls) {
  bool some = false;
  for (const uintptr_t call : calls) some = seen_calls.insert(call).second || some;
  return seen.insert(asker(calls)).second && (some || test::in_full());
}

void sweep(Told told) {
  CAPTURE(told.name);
  RamStore first;
  told.bytes = live(told, first).error.bytes_needed;
  std::set<size_t> failing;
  RamStore whole;
  whole.before = [&](const RamStore::Operation&, size_t n) {
    if (is_new(calls_to_here())) failing.insert(n);
    return 0;
  };
  const Life clean = live(told, whole);
  CAPTURE(clean.call);
  CAPTURE(clean.error.text);
  REQUIRE(clean.status == C2D_OK);
  CHECK(whole.done.size() > 1000);
  for (const size_t n : failing) check_failure(told, n, clean);
  MESSAGE(told.name << ": " << failing.size() << " places failed");
}

// ---- models

many::Model floating(int32_t pairs, double pressure) {
  many::Model m = many::rough(pairs);
  m.set(2, 3, many::end_of(many::kPulled, 0, -pressure));
  return m;
}
// A second load case pushes the upper block along.
many::Model with_push(many::Model m, const many::End& end) {
  m.cases = 2;
  for (many::Body& body : m.bodies) body.second.assign(body.ends.size(), many::End());
  m.set_second(1, 1, many::end_of(many::kHeld));
  m.set_second(2, 3, end);
  return m;
}

constexpr int32_t kPairs = 84, kTouching = 60;

} // namespace

TEST_CASE("store edges: contact on demand" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = with_push(many::rough(kPairs), many::end_of(many::kHeld, 0, 0, 1e-5, 0));
  m.cycle_states = 8;
  sweep({"held", demand::on_demand(m, kTouching), {{1, 0}, {1, 1}}, {0.3, 0.1}, {{0.9, 0}, {1, 1}}});
}

TEST_CASE("store edges: bodies on demand that contact alone holds" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = with_push(floating(kPairs, 0.03), many::end_of(many::kPulled, 0.002, 0));
  m.cycle_states = 8;
  sweep({"floating", demand::on_demand(m, kTouching), {{1, 0}, {1, 1}}, {0.3, 0.2}, {{0.9, 0}, {1, 1}}});
  m = floating(kPairs, 0.03); // slides on a line of symmetry
  for (int32_t body : {1, 2}) m.set(body, 4, many::end_of("1001"));
  m.friction = 0;
  sweep({"sliding", demand::on_demand(m, kTouching), {{1}}, {0.0, 0.3}});
  m = many::rough(kPairs);
  m.set(2, 3, many::End());
  many::Body& body = m.body(2);
  body.rigid = 1, body.is_free[0] = body.is_free[1] = body.is_free[2] = 1;
  body.point[0] = body.point[1] = 0.5, body.load[1] = -0.03;
  sweep({"rigid", demand::on_demand(m, kTouching), {{1}}, {0.3}});
}

// A rigid table, and beside it a block and a rigid body that meet nothing.
TEST_CASE("store edges: a body on demand on a rigid one, and bodies without contact" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = floating(kPairs, 0.03);
  m.set(1, 1, many::End());
  m.body(1).rigid = 1;
  m.add(many::rectangle(5, 0, 6, 1, {4, 4, 4, 4}));
  m.set(3, 1, many::end_of(many::kHeld));
  m.set(3, 3, many::end_of(many::kPulled, 0, 1));
  m.add(many::rectangle(8, 0, 9, 1, {4, 4, 4, 4}));
  m.body(4).rigid = 1;
  sweep({"beside", demand::on_demand(m, kTouching), {{1}}, {0.3}});
}

TEST_CASE("store edges: a body on demand that overlaps push off" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = with_push(floating(kPairs, 0.03), many::end_of(many::kPulled));
  for (size_t i = 1; i < m.body(2).xy.size(); i += 2) m.body(2).xy[i] -= 5e-6;
  m.interference = 2;
  sweep({"overlaps", demand::on_demand(m, kTouching), {{1, 1}}, {0.3}});
}

TEST_CASE("store edges: layers whose displacements are unknowns" * doctest::skip(c2d::kSmallCode)) {
  sweep({"layers", many::pressed_layers(2, 1e-4, C2D_ZONE_MATCHING, 6), {{1}}, {0.5, 0.0}});
  sweep({"tied layers", many::pressed_layers(3, 1e-4, C2D_ZONE_MATCHING + C2D_ZONE_TIED, 6), {{1}}, {0.5}});
  sweep({"free layers", many::pressed_layers(2, 1e-5, C2D_ZONE_FREE, 6), {{1}}, {0.5}});
}
