// Calls with arguments at the ends of their ranges, and in the states at the ends of a solver's life: what is refused is told
// by its name, what is legal has its effect. Two squares, one upon the other, made by calls.
#include "callable.hpp"
#include "interface/entry.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace runs;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Body 1 on body 2: elements 1 lower, 2 right, 3 upper, 4 left; the lower side of 1 meets the upper side of 2.
struct Squares {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  host::Limits limits;
  std::unique_ptr<Machine> machine;
  c2d_solver* s = nullptr;

  explicit Squares(const test::Callable<void(host::Limits&)>& change = nullptr, bool stored = true) {
    limits.function_nodes = 2;
    limits.zones = 2, limits.pairs = 4, limits.contact_elements = 2, limits.point_loads = 1;
    limits.coefficients = 2, limits.paths = 2, limits.load_cases = 1;
    for (int b = 0; b < 2; ++b) limits.list[b] = {4, 4, 1, 0};
    if (change) change(limits);
    uint64_t in_core = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &in_core, nullptr) == C2D_OK);
    if (stored) store.serve(port);
    machine = std::make_unique<Machine>(limits, in_core, stored ? &port : nullptr);
    REQUIRE(machine->created == C2D_OK);
    s = machine->solver;
  }
  std::string why() const { return error_of(s).text; }
  c2d_status problem() {
    c2d_problem p = C2D_INIT(c2d_problem);
    return c2d_set_problem(s, &p);
  }
  c2d_status body(int32_t number, double y) {
    c2d_body b = C2D_INIT(c2d_body);
    b.element_nodes = 2, b.elements = 4, b.regions = 1, b.youngs_modulus = 1000, b.poisson_ratio = 0.3;
    c2d_status status = c2d_set_body(s, number, &b);
    if (status == C2D_OK) status = c2d_add_region(s, number, 1, 4);
    const double xy[8] = {0, y, 1, y, 1, y + 1, 0, y + 1};
    return status == C2D_OK ? c2d_set_nodes(s, number, 1, 4, xy, 2) : status;
  }
  void bodies() {
    REQUIRE(problem() == C2D_OK);
    REQUIRE(body(1, 0) == C2D_OK);
    REQUIRE(body(2, -1) == C2D_OK);
  }
  c2d_zone zone() const {
    c2d_zone z = C2D_INIT(c2d_zone);
    z.kind = C2D_ZONE_MATCHING, z.pairs = 2;
    z.side1 = {1, 1, 1, 0, 1, 2};
    z.side2 = {2, 3, 3, 0, 4, 3};
    return z;
  }
  void hold() { // body 2 below, body 1 is pressed from above
    const int32_t held[4] = {1, 1, 0, 0};
    const double zero[4] = {}, press[4] = {0, -1, 0, 0};
    const int32_t pulled[4] = {0, 0, 1, 1};
    for (int32_t local : {1, 2}) {
      REQUIRE(c2d_set_condition(s, 2, 1, local, 1, held, zero) == C2D_OK);
      REQUIRE(c2d_set_condition(s, 1, 3, local, 1, pulled, press) == C2D_OK);
    }
  }
  void complete() {
    bodies();
    hold();
    const c2d_zone z = zone();
    REQUIRE(c2d_add_zone(s, &z) == C2D_OK);
    REQUIRE(c2d_add_friction(s, 0.5) == C2D_OK);
    const double load = 1;
    REQUIRE(c2d_add_path(s, 1, &load, 1) == C2D_OK);
    const c2d_status status = c2d_complete(s);
    REQUIRE_MESSAGE(status == C2D_OK, why());
  }
};

} // namespace

TEST_CASE("call edges: every option is held to its range") {
  Squares q;
  for (int which = 0; which < 5; ++which)
    for (int32_t wrong : {-1, 2}) {
      c2d_options options = C2D_INIT(c2d_options);
      int32_t* const member[] = {&options.quadrature, &options.stepping, &options.every_change, &options.symmetry,
                                 &options.keep_factors};
      *member[which] = wrong;
      CHECK(c2d_set_options(q.s, &options) == C2D_ERR_ARGUMENT);
      CHECK(q.why() == "an option is out of range");
      *member[which] = 0;
      CHECK(c2d_set_options(q.s, &options) == C2D_OK);
    }
}

TEST_CASE("call edges: an analysis beyond the ends counts as the last one, as in 1987") {
  for (int32_t given : {-7, 9}) {
    Squares q;
    c2d_problem p = C2D_INIT(c2d_problem);
    p.analysis = given;
    REQUIRE(c2d_set_problem(q.s, &p) == C2D_OK);
    CHECK(summary_of(q.s).analysis == (given < 0 ? C2D_ANALYSIS_CHECK : C2D_ANALYSIS_ITERATIONS));
  }
}

TEST_CASE("call edges: no unit of length is an empty one, and a body given again keeps its sizes") {
  Squares q;
  q.bodies();
  CHECK(c2d_set_units(q.s, nullptr, "N") == C2D_OK);
  CHECK(std::string(summary_of(q.s).unit_length).empty());
  CHECK(std::string(summary_of(q.s).unit_force) == "N");
  CHECK(c2d_set_units(q.s, "mm", nullptr) == C2D_OK);
  CHECK(std::string(summary_of(q.s).unit_length) == "mm");
  CHECK(std::string(summary_of(q.s).unit_force).empty());
  c2d_body b = C2D_INIT(c2d_body);
  b.element_nodes = 2, b.elements = 4, b.regions = 1, b.youngs_modulus = 2000, b.poisson_ratio = 0.3;
  CHECK(c2d_set_body(q.s, 1, &b) == C2D_OK);
  c2d_body other = b;
  other.elements = 3;
  CHECK(c2d_set_body(q.s, 1, &other) == C2D_ERR_ARGUMENT);
  CHECK(q.why() == "this body was given before, with other numbers of elements or regions");
}

TEST_CASE("call edges: a body of other regions or open ends is another body") {
  Squares q([](host::Limits& limits) { limits.list[0] = {8, 6, 2, 0}; });
  REQUIRE(q.problem() == C2D_OK);
  c2d_body b = C2D_INIT(c2d_body);
  b.element_nodes = 2, b.elements = 6, b.regions = 1, b.youngs_modulus = 2000, b.poisson_ratio = 0.3;
  REQUIRE(c2d_set_body(q.s, 1, &b) == C2D_OK);
  c2d_body other = b;
  other.regions = 2;
  CHECK(c2d_set_body(q.s, 1, &other) == C2D_ERR_ARGUMENT);
  other = b;
  other.open_regions = 1;
  CHECK(c2d_set_body(q.s, 1, &other) == C2D_ERR_ARGUMENT);
  CHECK(q.why() == "this body was given before, with other numbers of elements or regions");
}

TEST_CASE("call edges: no points are given, and a coordinate that is none is refused, x or y") {
  Squares q;
  q.bodies();
  CHECK(c2d_set_nodes(q.s, 1, 1, 0, nullptr, 0) == C2D_OK);
  const double bad_x[4] = {0, 0, kInfinity, 0}, bad_y[4] = {0, 0, 0, std::nan("")};
  for (const double* xy : {bad_x, bad_y}) {
    CHECK(c2d_set_nodes(q.s, 1, 1, 2, xy, 2) == C2D_ERR_ARGUMENT);
    CHECK(q.why().find("coordinate") != std::string::npos);
  }
}

TEST_CASE("call edges: what is asked of a result is refused by its name, whatever the solver is") {
  c2d_body_result result = C2D_INIT(c2d_body_result);
  c2d_body_state moved = C2D_INIT(c2d_body_state);
  c2d_zone_state touch = C2D_INIT(c2d_zone_state);
  CHECK(c2d_get_body_result(nullptr, 1, &result) == C2D_ERR_ARGUMENT);
  alignas(64) unsigned char zeros[sizeof(c2d_solver)] = {};
  c2d_solver* const none = reinterpret_cast<c2d_solver*>(zeros);
  CHECK(c2d_get_body_result(none, 1, &result) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_body_state(none, 1, &moved) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_zone_state(none, 1, &touch) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_body_state(nullptr, 1, &moved) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_zone_state(nullptr, 1, &touch) == C2D_ERR_ARGUMENT);
}

TEST_CASE("call edges: inside a step callback wrong arguments are refused, and nothing is told") {
  Squares q;
  q.complete();
  REQUIRE(c2d_prepare(q.s) == C2D_OK);
  struct Inside {
    c2d_solver* s;
    int calls = 0;
  } inside{q.s};
  const auto look = [](void* context, const c2d_step*) -> int32_t {
    Inside& in = *static_cast<Inside*>(context);
    ++in.calls;
    c2d_body_state moved = C2D_INIT(c2d_body_state), blank = {};
    c2d_zone_state touch = C2D_INIT(c2d_zone_state);
    c2d_body_result result = C2D_INIT(c2d_body_result);
    CHECK(c2d_get_body_state(in.s, 1, &moved) == C2D_OK);
    CHECK(moved.contact[1] == doctest::Approx(1.0));
    for (int32_t body : {0, 3}) {
      CHECK(c2d_get_body_state(in.s, body, &moved) == C2D_ERR_ARGUMENT);
      CHECK(c2d_get_body_result(in.s, body, &result) == C2D_ERR_ARGUMENT);
    }
    for (int32_t zone : {0, 2}) CHECK(c2d_get_zone_state(in.s, zone, &touch) == C2D_ERR_ARGUMENT);
    CHECK(c2d_get_body_state(in.s, 1, &blank) == C2D_ERR_ARGUMENT);
    CHECK(c2d_get_body_state(in.s, 1, nullptr) == C2D_ERR_ARGUMENT);
    CHECK(error_of(in.s).status == C2D_OK);
    return 0;
  };
  CHECK(c2d_run(q.s, look, &inside) == C2D_OK);
  CHECK(inside.calls == 1);
  c2d_body_state blank = {};
  CHECK(c2d_get_body_state(q.s, 1, &blank) == C2D_ERR_ARGUMENT); // outside it is told
  CHECK(q.why().find("c2d_body_state") != std::string::npos);
}

TEST_CASE("call edges: points along a line that has one, both ends to the bit, and sets that are none") {
  c2d_points p = C2D_INIT(c2d_points);
  p.kind = C2D_POINTS_LINE, p.body = 1;
  p.from[0] = 0.1, p.from[1] = 0.2, p.to[0] = 0.7, p.to[1] = 0.9;
  double xy[6] = {};
  int32_t total = -1;
  for (int32_t count : {1, 3}) {
    p.count[0] = count;
    REQUIRE(c2d_expand_points(&p, 1, count, xy, 2, &total) == C2D_OK);
    CHECK(total == count);
    CHECK(xy[0] == 0.1);
    CHECK(xy[1] == 0.2);
  }
  CHECK(xy[4] == 0.7);
  CHECK(xy[5] == 0.9);
  CHECK(c2d_expand_points(&p, 5, 0, nullptr, 2, &total) == C2D_ERR_ARGUMENT); // 3 there are
  CHECK(c2d_expand_points(&p, 4, 0, nullptr, 2, &total) == C2D_OK);
  CHECK(c2d_expand_points(&p, 0, 1, xy, 2, &total) == C2D_ERR_ARGUMENT);
  CHECK(c2d_expand_points(&p, 1, -1, xy, 2, &total) == C2D_ERR_ARGUMENT);
  p.count[0] = 0;
  CHECK(c2d_expand_points(&p, 1, 0, nullptr, 2, &total) == C2D_ERR_ARGUMENT);
}

TEST_CASE("call edges: zones and platens wait for their bodies") {
  Squares q([](host::Limits& limits) {
    limits.platens = 1;
    limits.zones = 3, limits.pairs = 8, limits.contact_elements = 4;
  });
  REQUIRE(q.problem() == C2D_OK);
  const c2d_zone z = q.zone();
  const int32_t is_free[3] = {1, 1, 1};
  const double point[2] = {0, 0};
  CHECK(c2d_add_zone(q.s, &z) == C2D_ERR_ARGUMENT);
  CHECK(q.why() == "give both bodies and all their regions before the contact zones");
  CHECK(c2d_add_platen(q.s, 1, 3, 3, 0, is_free, point) == C2D_ERR_ARGUMENT);
  CHECK(q.why() == "give the body and all its regions first");
  c2d_body b = C2D_INIT(c2d_body);
  b.element_nodes = 2, b.elements = 4, b.regions = 1, b.youngs_modulus = 1000, b.poisson_ratio = 0.3;
  for (int32_t body : {1, 2}) REQUIRE(c2d_set_body(q.s, body, &b) == C2D_OK); // without regions
  CHECK(c2d_add_zone(q.s, &z) == C2D_ERR_ARGUMENT);
  CHECK(c2d_add_platen(q.s, 1, 3, 3, 0, is_free, point) == C2D_ERR_ARGUMENT);
}

TEST_CASE("call edges: ranges of elements at the ends of the integers are too long to be one") {
  Squares q;
  q.bodies();
  for (int32_t kind : {C2D_ZONE_MATCHING, C2D_ZONE_FREE})
    for (bool up : {true, false}) {
      c2d_zone z = q.zone();
      z.kind = kind;
      z.side1.first_element = up ? INT32_MIN : INT32_MAX, z.side1.last_element = up ? INT32_MAX : INT32_MIN;
      CHECK(c2d_add_zone(q.s, &z) != C2D_OK);
      z.side2.first_element = z.side1.first_element, z.side2.last_element = z.side1.last_element;
      CHECK(c2d_add_zone(q.s, &z) != C2D_OK);
      CHECK_FALSE(q.why().empty());
      z = q.zone();
      z.kind = kind, z.side1.elements = z.side2.elements = up ? -3 : INT32_MIN; // so many are none
      CHECK(c2d_add_zone(q.s, &z) != C2D_OK);
    }
}

TEST_CASE("call edges: friction and steps where there is nothing to rub") {
  Squares q([](host::Limits& limits) {
    limits.bodies = 1;
    limits.zones = limits.pairs = limits.contact_elements = limits.coefficients = 0;
  });
  REQUIRE(q.problem() == C2D_OK);
  REQUIRE(q.body(1, 0) == C2D_OK);
  const int32_t held[4] = {1, 1, 0, 0}, pulled[4] = {0, 0, 1, 1};
  const double zero[4] = {}, pull[4] = {0, 1, 0, 0};
  for (int32_t local : {1, 2}) {
    REQUIRE(c2d_set_condition(q.s, 1, 1, local, 1, held, zero) == C2D_OK);
    REQUIRE(c2d_set_condition(q.s, 1, 3, local, 1, pulled, pull) == C2D_OK);
  }
  const double load = 1;
  REQUIRE(c2d_add_path(q.s, 1, &load, 1) == C2D_OK);
  REQUIRE(c2d_complete(q.s) == C2D_OK);
  REQUIRE(c2d_prepare(q.s) == C2D_OK);
  CHECK(c2d_begin(q.s, nullptr, 1) == C2D_ERR_ARGUMENT);
  CHECK(q.why().find("mu is null") == 0);
  CHECK(c2d_begin(q.s, nullptr, 0) == C2D_OK);
  CHECK(summary_of(q.s).mu == 0.0);
  double step = 0;
  CHECK(c2d_next_event(q.s, &load, 1, &step) == C2D_OK);
  CHECK(step == kInfinity); // no pair ever changes
  c2d_outcome outcome = C2D_UNDECIDED;
  CHECK(c2d_advance(q.s, &load, 1, &outcome) == C2D_OK);
  CHECK(outcome == C2D_REACHED);
  CHECK(c2d_run(q.s, nullptr, nullptr) == C2D_OK); // once, for all coefficients
  CHECK(summary_of(q.s).outcome == C2D_REACHED);
}

TEST_CASE("call edges: a body that nothing holds goes nowhere, and the next event is at once") {
  Squares q([](host::Limits& limits) { limits.zones = 2; });
  q.bodies();
  // Nothing holds body 2 along x, and friction is none: contact cannot hold it.
  const double press[4] = {1, -1, 0, 0};
  const int32_t pulled[4] = {0, 0, 1, 1};
  for (int32_t local : {1, 2}) REQUIRE(c2d_set_condition(q.s, 1, 3, local, 1, pulled, press) == C2D_OK);
  const c2d_zone z = q.zone();
  REQUIRE(c2d_add_zone(q.s, &z) == C2D_OK);
  REQUIRE(c2d_add_friction(q.s, 0.0) == C2D_OK);
  const double load = 1;
  REQUIRE(c2d_add_path(q.s, 1, &load, 1) == C2D_OK);
  REQUIRE(c2d_complete(q.s) == C2D_OK);
  REQUIRE(c2d_prepare(q.s) == C2D_OK);
  const double mu = 0;
  REQUIRE(c2d_begin(q.s, &mu, 1) == C2D_OK);
  double step = 1;
  CHECK(c2d_next_event(q.s, &load, 1, &step) == C2D_OK);
  CHECK(step == 0.0);
  c2d_outcome outcome = C2D_REACHED;
  CHECK(c2d_advance(q.s, &load, 1, &outcome) == C2D_OK);
  CHECK(outcome == C2D_FREE_MOTION);
  CHECK(c2d_next_event(q.s, &load, 1, &step) == C2D_OK);
  CHECK(step == 0.0);
  c2d_zone_state touch = C2D_INIT(c2d_zone_state);
  CHECK(c2d_get_zone_state(q.s, 1, &touch) == C2D_OK);
  CHECK(touch.open == 2);
  CHECK(c2d_save(q.s) == C2D_OK); // there is a factorisation, or that there is none
  CHECK(c2d_restore(q.s) == C2D_OK);
}

TEST_CASE("call edges: without a store nothing is kept") {
  Squares q(nullptr, false);
  q.complete();
  CHECK(c2d_prepare(q.s) == C2D_ERR_ARGUMENT);
  CHECK(c2d_restore(q.s) == C2D_ERR_ARGUMENT);
  CHECK_FALSE(q.why().empty());
}

TEST_CASE("call edges: more increments than an integer counts are as many as it counts") {
  Squares q;
  q.bodies();
  const double load = 1;
  for (int i = 0; i < 2; ++i) REQUIRE(c2d_add_path(q.s, INT32_MAX, &load, 1) == C2D_OK);
  CHECK(summary_of(q.s).steps == INT32_MAX);
}

TEST_CASE("call edges: a curve is checked number by number") {
  Squares q([](host::Limits& limits) { limits.curves = 1; });
  q.bodies();
  for (int which = 0; which < 4; ++which) {
    c2d_curve arc = C2D_INIT(c2d_curve);
    arc.kind = C2D_CURVE_ARC, arc.body = 1, arc.first_element = 1, arc.last_element = 2;
    arc.centre[0] = 0, arc.centre[1] = 0, arc.radius = 1;
    if (which < 2) arc.centre[which] = kInfinity;
    if (which == 2) arc.radius = kInfinity;
    if (which == 3) arc.radius = 0;
    CHECK(c2d_add_curve(q.s, &arc) == C2D_ERR_ARGUMENT);
    CHECK_FALSE(q.why().empty());
  }
}

TEST_CASE("call edges: what a rigid body does may change with the loads, but not that it is one") {
  Squares q;
  REQUIRE(q.problem() == C2D_OK);
  REQUIRE(q.body(1, 0) == C2D_OK);
  REQUIRE(q.body(2, -1) == C2D_OK);
  q.hold();
  const double motion[3] = {0, 0, 0}, axis[2] = {0, 0};
  REQUIRE(c2d_set_rigid(q.s, 2, 1, motion, axis) == C2D_OK);
  const c2d_zone z = q.zone();
  REQUIRE(c2d_add_zone(q.s, &z) == C2D_OK);
  const double load = 1;
  REQUIRE(c2d_add_friction(q.s, 0.5) == C2D_OK);
  REQUIRE(c2d_add_path(q.s, 1, &load, 1) == C2D_OK);
  REQUIRE_MESSAGE(c2d_complete(q.s) == C2D_OK, q.why());
  CHECK(c2d_set_rigid(q.s, 2, 1, motion, axis) == C2D_OK); // in state model
  CHECK(c2d_set_rigid(q.s, 2, 0, nullptr, nullptr) == C2D_ERR_STATE);
  CHECK(c2d_set_rigid(q.s, 1, 1, motion, axis) == C2D_ERR_STATE);
  CHECK(q.why() == "a body can be made rigid only before c2d_complete");
}

TEST_CASE("call edges: numbers of coefficients, loads and coordinates that are none") {
  Squares q;
  q.bodies();
  q.hold();
  const c2d_zone z = q.zone();
  REQUIRE(c2d_add_zone(q.s, &z) == C2D_OK);
  REQUIRE(c2d_add_friction(q.s, 0.5) == C2D_OK);
  for (int32_t i : {0, 2}) CHECK(c2d_set_zone_friction(q.s, 1, i, 0.1) == C2D_ERR_ARGUMENT);
  CHECK(q.why().find("number of the coefficient of friction") == 0);
}

TEST_CASE("call edges: what is asked of points and loads is finite, x and y") {
  Squares q;
  q.bodies();
  q.hold();
  const c2d_zone z = q.zone();
  REQUIRE(c2d_add_zone(q.s, &z) == C2D_OK);
  REQUIRE(c2d_add_friction(q.s, 0.5) == C2D_OK);
  REQUIRE(c2d_add_point_load(q.s, 1, 1, 0.5, 0.9, 0, -0.1) == C2D_OK);
  const double load = 1;
  REQUIRE(c2d_add_path(q.s, 1, &load, 1) == C2D_OK);
  REQUIRE(c2d_complete(q.s) == C2D_OK);
  CHECK(c2d_replace_point_load(q.s, 1, kInfinity, 0.9, 0, -0.1) == C2D_ERR_ARGUMENT);
  CHECK(c2d_replace_point_load(q.s, 1, 0.5, 0.9, 0, -0.2) == C2D_OK);
  REQUIRE(c2d_prepare(q.s) == C2D_OK);
  REQUIRE(c2d_run(q.s, nullptr, nullptr) == C2D_OK);
  for (int which : {0, 1}) {
    double xy[2] = {0.5, 0.5}, out[C2D_POINT_FIELDS] = {};
    REQUIRE(c2d_interior(q.s, 1, 1, xy, 2, out, C2D_POINT_FIELDS) == C2D_OK);
    xy[which] = std::nan("");
    CHECK(c2d_interior(q.s, 1, 1, xy, 2, out, C2D_POINT_FIELDS) == C2D_ERR_ARGUMENT);
    CHECK(q.why().find("a coordinate in xy") == 0);
  }
}

TEST_CASE("call edges: one body that nothing holds and nothing touches") {
  Squares q([](host::Limits& limits) {
    limits.bodies = 1;
    limits.zones = limits.pairs = limits.contact_elements = limits.coefficients = 0;
  });
  REQUIRE(q.problem() == C2D_OK);
  REQUIRE(q.body(1, 0) == C2D_OK);
  const int32_t pulled[4] = {0, 0, 1, 1};
  const double pull[4] = {0, 1, 0, 0};
  for (int32_t local : {1, 2}) REQUIRE(c2d_set_condition(q.s, 1, 3, local, 1, pulled, pull) == C2D_OK);
  const double load = 1;
  REQUIRE(c2d_add_path(q.s, 1, &load, 1) == C2D_OK);
  if (c2d_complete(q.s) != C2D_OK || c2d_prepare(q.s) != C2D_OK) { // it may be refused at once: with a reason
    CHECK_FALSE(q.why().empty());
    return;
  }
  REQUIRE(c2d_begin(q.s, nullptr, 0) == C2D_OK);
  double step = 1;
  CHECK(c2d_next_event(q.s, &load, 1, &step) == C2D_OK);
  CHECK(step == 0.0); // no way on
  c2d_outcome outcome = C2D_REACHED;
  CHECK(c2d_advance(q.s, &load, 1, &outcome) == C2D_OK);
  CHECK(outcome == C2D_FREE_MOTION);
}

TEST_CASE("call edges: where pairs are in their elements, for functions of every order") {
  for (int32_t nodes : {1, 2, 3, 4}) {
    CAPTURE(nodes);
    Squares q([nodes](host::Limits& limits) { limits.function_nodes = nodes; });
    REQUIRE(q.problem() == C2D_OK);
    REQUIRE(q.body(1, 0) == C2D_OK);
    REQUIRE(q.body(2, -1) == C2D_OK);
    const int32_t held[4] = {1, 1, 0, 0}, pulled[4] = {0, 0, 1, 1};
    const double zero[4] = {}, press[4] = {0, -1, 0, 0};
    for (int32_t local = 1; local <= nodes; ++local) {
      REQUIRE(c2d_set_condition(q.s, 2, 1, local, 1, held, zero) == C2D_OK);
      REQUIRE(c2d_set_condition(q.s, 1, 3, local, 1, pulled, press) == C2D_OK);
    }
    c2d_zone z = q.zone();
    const int32_t steps = nodes == 1 ? 1 : nodes - 1;
    z.pairs = nodes == 1 ? 1 : nodes;
    z.side1.first_node = 1, z.side1.last_node = nodes == 1 ? 1 : nodes;
    z.side2.first_node = nodes == 1 ? 3 : 3 * steps + 1, z.side2.last_node = nodes == 1 ? 3 : 2 * steps + 1;
    REQUIRE_MESSAGE(c2d_add_zone(q.s, &z) == C2D_OK, q.why());
    REQUIRE(c2d_add_friction(q.s, 0.5) == C2D_OK);
    const double load = 1;
    REQUIRE(c2d_add_path(q.s, 1, &load, 1) == C2D_OK);
    REQUIRE_MESSAGE(c2d_complete(q.s) == C2D_OK, q.why());
    REQUIRE(c2d_prepare(q.s) == C2D_OK);
    REQUIRE(c2d_run(q.s, nullptr, nullptr) == C2D_OK);
    for (int32_t pair = 1; pair <= z.pairs; ++pair) {
      double element = 0, eta = 9;
      REQUIRE(c2d_get(q.s, C2D_PAIR_ELEMENT1, 0, pair, 1, &element, 1) == C2D_OK);
      REQUIRE(c2d_get(q.s, C2D_PAIR_ETA1, 0, pair, 1, &eta, 1) == C2D_OK);
      CHECK(element >= 1);
      CHECK(std::fabs(eta) <= (nodes == 1 ? 0 : 1));
    }
  }
}

TEST_CASE("call edges: so many loose bodies that there is no room for what their contact prevents: one of them is named") {
  constexpr int32_t kBodies = 160;
  std::vector<c2d_body_limits> each(kBodies, c2d_body_limits{4, 4, 1, 0});
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = kBodies, limits.body = each.data(), limits.function_nodes = 1;
  limits.zones = limits.pairs = limits.contact_elements = kBodies / 2; // two and two are joined
  limits.coefficients = limits.paths = 1;
  uint64_t least = 0;
  REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
  std::vector<unsigned char> memory(static_cast<size_t>(least));
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, memory.data(), memory.size(), &limits, &port, nullptr) == C2D_OK);
  c2d_problem problem = C2D_INIT(c2d_problem);
  REQUIRE(c2d_set_problem(s, &problem) == C2D_OK);
  for (int32_t b = 1; b <= kBodies; ++b) {
    c2d_body body = C2D_INIT(c2d_body);
    body.element_nodes = 2, body.elements = 4, body.regions = 1, body.youngs_modulus = 1000, body.poisson_ratio = 0.3;
    REQUIRE(c2d_set_body(s, b, &body) == C2D_OK);
    REQUIRE(c2d_add_region(s, b, 1, 4) == C2D_OK);
    const double x = b, xy[8] = {x, 0, x + 1, 0, x + 1, 1, x, 1};
    REQUIRE(c2d_set_nodes(s, b, 1, 4, xy, 2) == C2D_OK);
  }
  for (int32_t b = 1; b < kBodies; b += 2) {
    c2d_zone z = C2D_INIT(c2d_zone);
    z.kind = C2D_ZONE_MATCHING, z.pairs = 1;
    z.side1 = {b, 2, 2, 0, 2, 2};
    z.side2 = {b + 1, 4, 4, 0, 4, 4};
    REQUIRE(c2d_add_zone(s, &z) == C2D_OK);
  }
  const int32_t pulled[4] = {0, 0, 1, 1};
  const double up[4] = {0, 1, 0, 0}, load = 1, mu = 0;
  REQUIRE(c2d_set_condition(s, 7, 1, 1, 1, pulled, up) == C2D_OK);
  const int32_t rolls[4] = {0, 1, 1, 0}; // the first body has one motion less than the others: it is not the one that is named
  const double zero[4] = {};
  REQUIRE(c2d_set_condition(s, 1, 1, 1, 1, rolls, zero) == C2D_OK);
  REQUIRE(c2d_add_friction(s, mu) == C2D_OK);
  REQUIRE(c2d_add_path(s, 1, &load, 1) == C2D_OK);
  REQUIRE_MESSAGE(c2d_complete(s) == C2D_OK, error_of(s).text);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  c2d_outcome outcome = C2D_REACHED;
  REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
  CHECK(outcome == C2D_FREE_MOTION);
  const host::Summary summary = summary_of(s);
  CHECK(summary.outcome_body >= 2);
  double size = 0;
  for (double number : summary.free_motion) size += std::fabs(number);
  CHECK(size > 0);
}
