// Thousands of small models made by calls from a handful of numbers, so that most of what can be wrong with a model is wrong
// somewhere, and much is right: a model is refused with faults that say something, or it is solved, and then every number of it
// is finite and its forces balance.
#include "effort.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <random>

using namespace runs;

namespace {

struct Dice {
  std::mt19937 generator;
  int32_t below(int32_t n) { return static_cast<int32_t>(generator() % static_cast<uint32_t>(n)); }
  int32_t from(int32_t first, int32_t last) { return first + below(last - first + 1); }
  bool one_in(int32_t n) { return below(n) == 0; }
  double place() { return 0.5 * from(-2, 4); }
};

struct Told {
  int faults = 0, empty = 0;
  static void take(void* context, const c2d_error* entry) {
    Told& to = *static_cast<Told*>(context);
    if (entry->severity == C2D_FAULT) ++to.faults;
    if (entry->text[0] == '\0') ++to.empty;
  }
};

struct Port : RamStore {
  Told told;
  c2d_port port = C2D_INIT(c2d_port);
  Port() {
    serve(port);
    port.log = [](void* context, const c2d_error* entry) { Told::take(&static_cast<Port&>(self(context)).told, entry); };
  }
};

// Squares side by side and upon each other, of `each` elements a side; a hole in the first, perhaps.
struct Sizes {
  int32_t bodies, each, function_nodes, element_nodes, cases, platens;
  bool hole;
  int32_t elements(int32_t b) const { return 4 * each + (hole && b == 1 ? 4 : 0); }
};

void give_square(c2d_solver* s, const Sizes& z, Dice& dice, int32_t b, double x0, double y0, double size) {
  c2d_body body = C2D_INIT(c2d_body);
  const bool hole = z.hole && b == 1;
  body.element_nodes = z.element_nodes;
  body.elements = z.elements(b);
  body.regions = hole ? 2 : 1;
  body.youngs_modulus = 1000;
  body.poisson_ratio = dice.one_in(8) ? 0.5 : 0.3;
  if (c2d_set_body(s, b, &body) != C2D_OK) return;
  c2d_add_region(s, b, 1, 4 * z.each);
  if (hole && !dice.one_in(30)) c2d_add_region(s, b, 4 * z.each + 1, 4 * z.each + 4);
  const int32_t steps = z.each * (z.element_nodes - 1);
  std::vector<double> xy;
  const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int side = 0; side < 4; ++side)
    for (int32_t i = 0; i < steps; ++i)
      for (int c = 0; c < 2; ++c) {
        const double part = static_cast<double>(i) / steps;
        xy.push_back((c == 0 ? x0 : y0) + size * ((1 - part) * corner[side][c] + part * corner[(side + 1) % 4][c]));
      }
  for (int side = 0; hole && side < 4; ++side) // clockwise
    for (int32_t i = 0; i < z.element_nodes - 1; ++i)
      for (int c = 0; c < 2; ++c) {
        const double part = static_cast<double>(i) / (z.element_nodes - 1), t = 0.25 + 0.5 * corner[(4 - side) % 4][c],
                     u = 0.25 + 0.5 * corner[(3 - side) % 4][c];
        xy.push_back((c == 0 ? x0 : y0) + size * ((1 - part) * t + part * u));
      }
  if (dice.one_in(30)) { // an element without length, as 1987 doubled its corners
    const size_t at = 2 * static_cast<size_t>(dice.below(static_cast<int32_t>(xy.size() / 2) - 1));
    xy[at + 2] = xy[at], xy[at + 3] = xy[at + 1];
  }
  if (dice.one_in(25)) xy[static_cast<size_t>(dice.below(static_cast<int32_t>(xy.size())))] += dice.place();
  int32_t count = static_cast<int32_t>(xy.size() / 2);
  if (dice.one_in(40)) count -= dice.from(1, 2); // some are missing
  c2d_set_nodes(s, b, 1, count, xy.data(), 2);
}

// A side of a square, or any range.
c2d_side side_of(const Sizes& z, Dice& dice, int32_t body, int32_t side, bool runs_down) {
  c2d_side out = {};
  out.body = body;
  const int32_t first = side * z.each + 1, last = first + z.each - 1;
  out.first_element = runs_down ? last : first;
  out.last_element = runs_down ? first : last;
  const int32_t nodes = 4 * z.each * (z.function_nodes == 1 ? 1 : z.function_nodes - 1);
  const int32_t per = z.function_nodes == 1 ? 1 : z.function_nodes - 1;
  const int32_t start = (first - 1) * per + 1, end = z.function_nodes == 1 ? last : last * per % nodes + 1;
  out.first_node = runs_down ? end : start;
  out.last_node = runs_down ? start : end;
  if (dice.one_in(10)) out.first_element = dice.from(0, 4 * z.each + 1);
  if (dice.one_in(10)) out.last_element = dice.from(0, 4 * z.each + 1);
  if (dice.one_in(12)) out.first_node = dice.from(0, nodes + 1);
  if (dice.one_in(12)) out.last_node = dice.from(0, nodes + 1);
  if (dice.one_in(12)) out.elements = dice.from(0, 2 * z.each);
  return out;
}

void give_conditions(c2d_solver* s, const Sizes& z, Dice& dice, int32_t b, int32_t side, const int32_t codes[4],
                     const double values[4]) {
  for (int32_t e = side * z.each + 1; e <= (side + 1) * z.each; ++e)
    for (int32_t local = 1; local <= z.function_nodes; ++local)
      if (!dice.one_in(60)) c2d_set_condition(s, b, e, local, dice.one_in(15) ? z.cases : 1, codes, values);
}

// What c2d_complete said of the model of a seed.
struct Outcome {
  c2d_status complete = C2D_OK, prepared = C2D_OK, ran = C2D_OK;
  c2d_outcome end = C2D_REACHED;
  int faults = 0, empty = 0;
  bool finite = true;
  double unbalanced = 0;
};

Outcome solve(uint32_t seed) {
  Dice dice{std::mt19937(seed)};
  Sizes z = {};
  z.bodies = dice.one_in(6) ? 3 : (dice.one_in(8) ? 1 : 2);
  z.each = dice.from(1, 3);
  z.function_nodes = dice.one_in(3) ? dice.from(1, 4) : 2;
  z.element_nodes = dice.one_in(4) ? dice.from(2, 4) : 2;
  z.cases = dice.one_in(3) ? 2 : 1;
  z.hole = dice.one_in(5);
  z.platens = dice.one_in(6) ? 1 : 0;
  host::Limits limits;
  limits.bodies = z.bodies;
  limits.function_nodes = z.function_nodes;
  for (int32_t b = 1; b <= z.bodies; ++b)
    limits.list[b - 1] = {z.elements(b) * (z.element_nodes - 1) + 2, z.elements(b), z.hole && b == 1 ? 2 : 1, 0};
  limits.zones = 4, limits.pairs = 80, limits.free_pairs = 40, limits.contact_elements = 30, limits.point_loads = 2;
  limits.coefficients = 1, limits.paths = 2, limits.load_cases = z.cases, limits.curves = 2, limits.platens = z.platens;
  uint64_t need = 0;
  REQUIRE(c2d_memory_need(&limits, nullptr, &need, nullptr) == C2D_OK);
  Port port;
  Machine machine(limits, need, &port.port);
  REQUIRE(machine.created == C2D_OK);
  c2d_solver* const s = machine.solver;
  c2d_options options = C2D_INIT(c2d_options);
  options.quadrature = dice.one_in(6);
  options.stepping = dice.one_in(6);
  options.symmetry = dice.one_in(8);
  options.keep_factors = dice.one_in(4);
  c2d_set_options(s, &options);
  c2d_problem problem = C2D_INIT(c2d_problem);
  problem.plane = dice.one_in(4);
  c2d_set_problem(s, &problem);
  for (int32_t b = 1; b <= z.bodies; ++b) {
    if (dice.one_in(60)) continue; // it is missing
    const double wide = dice.one_in(8) ? 0.5 : 1;
    give_square(s, z, dice, b, b == 3 ? 1 : (dice.one_in(12) ? dice.place() : 0),
                b == 2 ? -wide : (dice.one_in(12) ? dice.place() : 0), wide);
  }
  const int32_t held[4] = {1, 1, 0, 0}, pulled[4] = {0, 0, 1, 1}, rolls[4] = {0, 1, 1, 0}, glides[4] = {1, 0, 0, 1};
  const double none[4] = {}, press[4] = {dice.one_in(3) ? 0.1 * dice.from(-2, 2) : 0, -1, 0, 0},
               moved[4] = {0, 0, dice.one_in(20) ? 0.01 : 0, dice.one_in(4) ? -0.01 : 0};
  if (!dice.one_in(10))
    give_conditions(s, z, dice, z.bodies > 1 ? 2 : 1, 0, dice.one_in(5) ? rolls : held, dice.one_in(5) ? moved : none);
  if (!dice.one_in(10)) give_conditions(s, z, dice, 1, 2, pulled, press);
  if (dice.one_in(4))
    give_conditions(s, z, dice, dice.from(1, z.bodies), dice.one_in(2) ? 1 : 3, dice.one_in(2) ? rolls : glides, none);
  if (dice.one_in(6))
    c2d_add_point_load(s, dice.from(1, z.bodies), dice.from(1, z.cases), dice.place(), dice.place(), dice.from(-1, 1),
                       dice.from(-1, 1));
  const double force[2] = {0.1 * dice.from(-1, 1), -0.1}, axis[2] = {dice.place(), 0};
  if (dice.one_in(6))
    c2d_set_body_force(s, dice.from(1, z.bodies), dice.from(1, z.cases), force, dice.one_in(3) ? 0.01 : 0, axis);
  if (dice.one_in(5)) c2d_set_symmetry(s, dice.from(1, 2), dice.one_in(3) ? dice.place() : 0);
  if (dice.one_in(20)) c2d_set_symmetry(s, 2, dice.place());
  const double motion[3] = {0, dice.one_in(2) ? -0.01 : 0, dice.one_in(4) ? 0.001 : 0};
  const int32_t b_rigid = dice.from(1, z.bodies);
  if (dice.one_in(6)) c2d_set_rigid(s, b_rigid, dice.one_in(4) ? 0 : dice.from(1, z.cases), motion, axis);
  if (dice.one_in(10)) {
    const int32_t is_free[3] = {dice.below(2), dice.below(2), dice.below(2)};
    const double load[3] = {0, -1, 0}, centre[2] = {0.5, 0.5};
    c2d_set_rigid_load(s, b_rigid, 0, is_free, nullptr, centre);
    c2d_set_rigid_load(s, b_rigid, 1, nullptr, load, nullptr);
  }
  if (dice.one_in(20)) c2d_set_rigid(s, dice.from(1, z.bodies), 1, motion, axis);
  if (z.platens > 0 && !dice.one_in(10)) {
    const int32_t is_free[3] = {dice.below(2), dice.below(2), dice.below(2)};
    const double centre[2] = {dice.place(), dice.place()}, load[3] = {0, -1, 0};
    const c2d_side side = side_of(z, dice, dice.from(1, z.bodies), dice.one_in(3) ? dice.below(4) : 2, false);
    if (c2d_add_platen(s, side.body, side.first_element, side.last_element, side.elements, is_free, centre) == C2D_OK) {
      c2d_set_rigid_load(s, z.bodies + 1, 1, nullptr, load, nullptr);
      if (dice.one_in(2)) c2d_set_rigid(s, z.bodies + 1, 1, motion, centre);
    }
  }
  const int32_t zones = z.bodies == 3 ? 2 : (dice.one_in(10) ? 2 : (z.bodies == 1 && !dice.one_in(3) ? 0 : 1));
  for (int32_t i = 0; i < zones; ++i) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    zone.kind = dice.one_in(12) ? dice.from(0, 7) : (dice.one_in(2) ? C2D_ZONE_FREE : C2D_ZONE_MATCHING);
    if (dice.one_in(6)) zone.kind |= C2D_ZONE_TIED;
    zone.pairs = z.function_nodes == 1 ? z.each : z.each * (z.function_nodes - 1) + 1;
    if (dice.one_in(12)) zone.pairs = dice.from(1, zone.pairs + 1);
    zone.side1 = side_of(z, dice, 1, i == 0 ? 0 : 1, false);
    zone.side2 = side_of(z, dice, z.bodies < 2 || (zone.kind & C2D_ZONE_SELF) != 0 ? 1 : 2 + i, i == 0 ? 2 : 3, true);
    if (dice.one_in(8)) std::swap(zone.side1, zone.side2);
    c2d_add_zone(s, &zone);
  }
  if (dice.one_in(8)) {
    c2d_curve curve = C2D_INIT(c2d_curve);
    curve.kind = dice.from(0, 2), curve.body = dice.from(1, z.bodies);
    curve.first_element = dice.from(1, 2 * z.each), curve.last_element = curve.first_element + dice.below(z.each);
    curve.centre[0] = curve.centre[1] = 0.5, curve.radius = std::sqrt(0.5);
    c2d_add_curve(s, &curve);
  }
  if (dice.one_in(12)) c2d_set_interference(s, dice.from(1, z.cases));
  c2d_add_friction(s, dice.one_in(4) ? 0.0 : (dice.one_in(5) ? HUGE_VAL : 0.4));
  const double loads[2] = {1, 0.5};
  c2d_add_path(s, dice.from(1, 2), loads, z.cases);
  if (dice.one_in(4)) {
    const double back[2] = {-0.5, 0};
    c2d_add_path(s, 1, back, z.cases);
  }

  Outcome out;
  out.complete = c2d_complete(s);
  out.faults = port.told.faults;
  out.empty = port.told.empty;
  if (out.complete != C2D_OK) return out;
  out.prepared = c2d_prepare(s);
  if (out.prepared != C2D_OK) return out;
  out.ran = c2d_run(s, nullptr, nullptr);
  if (out.ran != C2D_OK) return out;
  Numbers numbers;
  out.ran = get_boundary(s, numbers);
  for (double number : numbers.boundary) out.finite = out.finite && std::isfinite(number);
  const host::Summary summary = summary_of(s);
  out.end = summary.outcome;
  const auto are_finite = [&out](const std::vector<double>& all) {
    for (double number : all) out.finite = out.finite && std::isfinite(number);
  };
  for (int32_t body = 1; body <= z.bodies + z.platens && out.ran == C2D_OK; ++body) {
    c2d_body_state stands = C2D_INIT(c2d_body_state);
    out.ran = c2d_get_body_state(s, body, &stands);
    if (out.ran != C2D_OK || body > z.bodies) break;
    c2d_body_result own = C2D_INIT(c2d_body_result);
    out.ran = c2d_get_body_result(s, body, &own);
    const int32_t count = own.elements * z.function_nodes;
    std::vector<double> ends(static_cast<size_t>(count));
    for (int32_t field = C2D_END_X; field <= C2D_END_PRINCIPAL2 && out.ran == C2D_OK; ++field) {
      out.ran = c2d_get(s, field, body, 1, count, ends.data(), 1);
      if (out.ran == C2D_OK) are_finite(ends);
    }
    std::vector<double> off(static_cast<size_t>(own.elements) * C2D_OFF_FIELDS);
    if (out.ran == C2D_OK) out.ran = c2d_indicators(s, body, 1, own.elements, off.data(), C2D_OFF_FIELDS);
    if (out.ran == C2D_OK) are_finite(off);
  }
  for (int32_t zone = 1; zone <= summary.zones && out.ran == C2D_OK; ++zone) {
    c2d_zone_state touch = C2D_INIT(c2d_zone_state);
    out.ran = c2d_get_zone_state(s, zone, &touch);
    CHECK(touch.open + touch.stick + touch.slip <= summary.pairs);
  }
  if (out.ran != C2D_OK) return out;
  double next = 0;
  const double ways[2] = {dice.one_in(2) ? 1.0 : -1.0, 0.5};
  out.ran = c2d_next_event(s, ways, z.cases, &next);
  CHECK(next >= 0);
  if (out.ran == C2D_OK && dice.one_in(4)) { // on from there
    const double to[2] = {0.5, -0.5};
    c2d_outcome outcome = C2D_REACHED;
    out.ran = c2d_advance(s, to, z.cases, &outcome);
    if (out.ran == C2D_OK) out.ran = c2d_save(s);
    if (out.ran == C2D_OK) out.ran = c2d_restore(s);
    out.end = outcome;
  }
  for (int32_t body = 1; body <= z.bodies && out.ran == C2D_OK; ++body) {
    double at[4] = {dice.place(), dice.place(), 0.4, 0.6}, stress[2 * C2D_POINT_FIELDS] = {}, off[C2D_OFF_FIELDS] = {};
    out.ran = c2d_interior(s, body, 2, at, 2, stress, C2D_POINT_FIELDS);
    for (double number : stress) out.finite = out.finite && std::isfinite(number);
    if (out.ran == C2D_OK) out.ran = c2d_indicators(s, body, 1, 1, off, C2D_OFF_FIELDS);
    c2d_body_result result = C2D_INIT(c2d_body_result);
    if (out.ran == C2D_OK) out.ran = c2d_get_body_result(s, body, &result);
    double most = 1e-3;
    for (int c = 0; c < 2; ++c) most = std::fmax(most, std::fabs(result.applied[c]) + std::fabs(result.contact[c]));
    if (summary.symmetry != 0) continue; // what the line carries is not told
    for (int c = 0; c < 2; ++c)
      out.unbalanced = std::fmax(out.unbalanced, std::fabs(result.applied[c] + result.contact[c]) / most);
  }
  return out;
}

} // namespace

TEST_CASE("model sweep: small models made from a handful of numbers are refused with words, or solved in balance") {
  int refused = 0, solved = 0, stopped = 0;
  const uint32_t seeds = test::effort<uint32_t>(2500, 20000);
  for (uint32_t seed = 1; seed <= seeds; ++seed) {
    CAPTURE(seed);
    const Outcome out = solve(seed);
    CHECK(out.empty == 0);
    if (out.complete != C2D_OK) {
      CHECK(out.complete == C2D_ERR_INPUT);
      CHECK(out.faults > 0);
      ++refused;
      continue;
    }
    CHECK((out.prepared == C2D_OK || out.prepared == C2D_ERR_SINGULAR));
    if (out.prepared != C2D_OK) continue;
    CHECK(out.ran == C2D_OK);
    CHECK(out.finite);
    (out.end == C2D_REACHED ? solved : stopped) += 1;
    if (out.end == C2D_REACHED) CHECK(out.unbalanced < 1e-6);
  }
  MESSAGE("refused " << refused << ", solved " << solved << ", stopped on their way " << stopped);
  CHECK(refused > static_cast<int>(seeds / 10));
  CHECK(solved > static_cast<int>(seeds / 25));
}
