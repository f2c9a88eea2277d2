// Right-hand sides and diagonals of large bodies by cells of elements, against the sums over all elements.
#include "bie/integrals/batch.hpp"
#include "bie/panel.hpp"
#include "effort.hpp"
#include "elimination/far_sums.hpp"
#include "model_fixture.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace fixture;

namespace {

// Both ways, of the first body: how far right-hand sides and diagonals are apart, over the largest.
struct Apart {
  double right, diagonal;
};
Apart compare(ModelData& d, bool batched) {
  const bool complete = d.complete();
  REQUIRE_MESSAGE(complete, d.all());
  const c2d::Model m = d.view();
  c2d::number_unknowns(m, 0);
  const size_t nodes = static_cast<size_t>(m.body[0].nodes);
  std::vector<double> diagonal(4 * nodes), point(2 * nodes), other(4 * nodes, 7.0);
  std::vector<int32_t> twin(nodes);
  const auto scratch = std::make_unique<c2d::AssemblyScratch>();
  c2d::ColumnSystem system = {m, 0, c2d::Quadrature::accurate, diagonal.data(), point.data(), twin.data(), scratch.get()};
  if (batched) system.batch = c2d::batch_for(c2d::best_instructions());
  system.some_passed_over = c2d::place_sources(system);
  REQUIRE(c2d::has_sums_by_cells(system));
  std::vector<double> work(c2d::far_sums_bytes(m.body[0].elements, 1) / 8 + 16);
  c2d::fill_diagonal(system, 0, m.body[0].nodes);
  const int64_t rows = c2d::system_rows(m, 0);
  std::vector<c2d::Real> expected(static_cast<size_t>(rows)), found(static_cast<size_t>(rows), 3);
  c2d::fill_columns(system, c2d::outer_columns(m, 0) + 2 * m.body[0].contact, 1, expected.data(), rows);
  c2d::fill_right_by_cells(system, found.data(), rows, work.data());
  c2d::ColumnSystem again = system;
  again.diagonal = other.data();
  c2d::fill_diagonal_by_cells(again, work.data());
  double size = 0, most = 0;
  Apart out = {0, 0};
  for (size_t i = 0; i < expected.size(); ++i) {
    size = std::max(size, std::fabs(static_cast<double>(expected[i])));
    most = std::max(most, std::fabs(static_cast<double>(expected[i] - found[i])));
  }
  for (size_t i = 0; i < diagonal.size(); ++i) out.diagonal = std::max(out.diagonal, std::fabs(diagonal[i] - other[i]));
  REQUIRE(size > 1e-3);
  out.right = most / size;
  return out;
}

constexpr double kSame = sizeof(c2d::Real) == 8 ? 1e-13 : 1e-5;

void check(ModelData& d) {
  for (const bool batched : {true, false}) {
    CAPTURE(batched);
    const Apart apart = compare(d, batched);
    CHECK(apart.right < kSame);
    CHECK(apart.diagonal < 2e-12); // of sums over 400 elements, each to 1e-13
  }
}

// Tractions on some elements and displacements on others, everywhere.
void prescribe(ModelData& d, int32_t functions) {
  const int elements = d.view().body[0].elements;
  for (int e = 1; e <= elements; ++e)
    for (int l = 1; l <= functions && e % 97 < 20; ++l) d.condition(1, e, l, "1100", 0.001 * std::sin(0.1 * e), 0.002);
  for (size_t i = 0; i < d.end_traction[0].size(); ++i)
    d.end_traction[0][i] = i % 350 < 200 ? 700 * std::cos(0.01 * static_cast<double>(i)) : 0.0;
}

} // namespace

TEST_CASE("far sums: of a ring with a hole beside its middle, elements and functions of every order") {
  for (int32_t functions = 1; functions <= 4; ++functions)
    for (int32_t element_nodes = 2; element_nodes <= 4; ++element_nodes) {
      if ((functions + element_nodes) % 2 != 0 && !test::in_full()) continue;
      CAPTURE(functions);
      CAPTURE(element_nodes);
      ModelData d(functions);
      Points outside, inside;
      arc_to(outside, 0.3, 0.2, 1.5, 0, 360, 311 * (element_nodes - 1));
      arc_to(inside, 0.9, 0.1, 0.6, 0, -360, 117 * (element_nodes - 1));
      d.body(element_nodes, {outside, inside}, 2600, 0.3);
      prescribe(d, functions);
      check(d);
    }
}

TEST_CASE("far sums: of a body with weight that turns, by its particular solutions") {
  for (int32_t functions = 1; functions <= 3; ++functions) {
    CAPTURE(functions);
    ModelData d(functions);
    Points outside, inside;
    arc_to(outside, 0.3, 0.2, 1.5, 0, 360, 622);
    arc_to(inside, 0.9, 0.1, 0.6, 0, -360, 234);
    d.body(3, {outside, inside}, 2600, 0.3);
    prescribe(d, functions);
    c2d::BodyForce& force = d.body_forces[0][0];
    force.bx = 40, force.by = -300, force.rho_omega2 = 200, force.x0 = 0.2, force.y0 = -0.1;
    d.bodies[0].has_force = 1;
    check(d);
  }
}

TEST_CASE("far sums: of a thin layer, and of elements from 1 to 1e-5") {
  ModelData layer(3);
  layer.body(2, {rectangle(0, 0, 200, 1, 205, 3)}, 1000, 0.45);
  prescribe(layer, 3);
  check(layer);

  ModelData graded(2);
  Points p;
  for (int side = 0; side < 4; ++side) {
    const double x = side == 0 || side == 3 ? 0 : 1, y = side < 2 ? 0 : 1;
    const double dx = side == 0 ? 1 : side == 2 ? -1 : 0, dy = side == 1 ? 1 : side == 3 ? -1 : 0;
    for (int i = 0; i < 120; ++i) {
      const double s = i < 60 ? 0.5 * std::pow(1e-5, 1 - i / 60.0) : 1 - 0.5 * std::pow(1e-5, (i - 60) / 60.0);
      p.insert(p.end(), {x + (i == 0 ? 0 : s) * dx, y + (i == 0 ? 0 : s) * dy});
    }
  }
  graded.body(2, {p}, 1000, 0.3);
  prescribe(graded, 2);
  check(graded);
}

TEST_CASE("far sums: one and two lines of symmetry by images, with a hole that they cut; nothing prescribed far away") {
  for (int lines = 1; lines <= 2; ++lines)
    for (int32_t functions = 1; functions <= 3; ++functions) {
      CAPTURE(lines);
      CAPTURE(functions);
      ModelData d = cut_by_symmetry(lines, functions, 4, 300);
      check(d);
    }
}
