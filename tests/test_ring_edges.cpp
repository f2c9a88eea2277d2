// Bodies of revolution with double nodes and functions of all orders: a column under
// uniform pressure, whose state is linear.
#include "many_bodies.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

constexpr double kE = 1000, kNu = 0.3;

many::Model column(const many::Body& body, int32_t nodes, int32_t upper) {
  many::Model m;
  m.plane = C2D_AXISYMMETRIC;
  m.function_nodes = nodes;
  m.add(body);
  m.body(1).ends.assign(static_cast<size_t>(body.elements() * nodes), many::End());
  m.set(1, 1, many::end_of("0110"));
  m.set(1, upper, many::end_of(many::kPulled, 0, -1));
  return m;
}

// The largest error of a displacement, over the largest.
double error_of(const many::Result& r) {
  double most = 0;
  for (const many::EndResult& e : r.boundary.at(0)) {
    most = std::max(most, std::fabs(e.uy + e.y / kE));
    most = std::max(most, std::fabs(e.ux - kNu * e.x / kE));
  }
  return most * kE / 2;
}

many::Result run(const many::Model& m, bool plain = false) {
  many::Machine machine(m);
  c2d_error why = C2D_INIT(c2d_error);
  c2d_last_error(machine.solver, &why);
  REQUIRE_MESSAGE(machine.status == C2D_OK, std::string(why.text));
  if (plain) machine.solver->instructions = c2d::Instructions::plain;
  const many::Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

} // namespace

TEST_CASE("ring edges: functions of all orders, with vectors of sources and one by one") {
  for (const int32_t nodes : {1, 2, 3, 4})
    for (const bool plain : {false, true}) {
      CAPTURE(nodes);
      const many::Body open = many::open_polygon({{0, 0, 3}, {1, 0, 4}, {1, 2, 3}, {0, 2, 0}}, kE, kNu);
      CHECK(error_of(run(column(open, nodes, 3), plain)) < (nodes == 1 ? 0.1 : 1e-9));
    }
}

TEST_CASE("ring edges: double nodes at corners") {
  for (const bool plain : {false, true}) { // an element without length at each corner off the axis
    const many::Body open = many::open_polygon({{0, 0, 3}, {1, 0, 1}, {1, 0, 4}, {1, 2, 1}, {1, 2, 3}, {0, 2, 0}}, kE, kNu);
    CHECK(error_of(run(column(open, 2, 5), plain)) < 1e-9);
  }
}

TEST_CASE("ring edges: the axis takes no elements") {
  many::Model m = column(many::polygon({{0, 0, 3}, {1, 0, 4}, {1, 2, 3}, {0, 2, 4}}, kE, kNu), 2, 3);
  many::Machine machine(m);
  CHECK(machine.status == C2D_ERR_INPUT);
  c2d_error why = C2D_INIT(c2d_error);
  c2d_last_error(machine.solver, &why);
  CHECK(std::string(why.text) == "element 11 of body 1 lies on the axis x = 0, expected no elements there: leave them out");
}
