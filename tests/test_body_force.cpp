// Body forces: weight and rotation against closed forms, equilibrium inside, symmetry, contact under own weight.
#include "deck_recorder.hpp"
#include "model_fixture.hpp"
#include "problem.hpp"

#include "bie/body_force.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace problem;

namespace {

constexpr double kPi = 3.14159265358979323846;

struct State {
  double ux, uy, sxx, syy, sxy;
};
using Field = test::Callable<State(double x, double y)>;

struct Elastic { // plane constants: exx = (sxx - nu syy)/e
  double e, nu;
};
Elastic plane_constants(const Problem& p) {
  const double e = p.bodies[0].youngs_modulus, nu = p.bodies[0].poisson_ratio;
  if (p.plane == C2D_PLANE_STRESS) return {e, nu};
  return {e / (1 - nu * nu), nu / (1 - nu)};
}

Result solved(const Problem& p, const Setup& setup = Setup()) {
  Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

Problem one_body(int32_t element_nodes, int32_t function_nodes, int32_t plane, double nu) {
  Problem p;
  p.plane = plane;
  p.analysis = C2D_ANALYSIS_STRESS;
  p.function_nodes = function_nodes;
  p.bodies.resize(1);
  p.bodies[0].element_nodes = element_nodes;
  p.bodies[0].poisson_ratio = nu;
  return p;
}

// Conditions with the values of a field: `fixed` says which displacements are given.
using Choice = test::Callable<bool(double nx, double ny, int component)>;
void give(Problem& p, const Field& field, const Choice& fixed) {
  set_ends(p, 1, [&](double x, double y, double nx, double ny, End& end) {
    const State s = field(x, y);
    const double t[2] = {s.sxx * nx + s.sxy * ny, s.sxy * nx + s.syy * ny}, u[2] = {s.ux, s.uy};
    for (int c = 0; c < 2; ++c) {
      const bool is_fixed = fixed(nx, ny, c);
      end.codes[c] = is_fixed ? 1 : 0;
      end.codes[2 + c] = is_fixed ? 0 : 1;
      end.values[is_fixed ? 2 + c : c] = is_fixed ? u[c] : t[c];
    }
  });
}

struct Error {
  double u = 0, t = 0; // relative to the largest
};
Error boundary_error(const Problem& p, const Result& r, const Field& field) {
  Problem wanted = p; // tractions of the field at every end, for the normals
  Error worst;
  // An incompressible column does not move at all: displacements are measured by stress over modulus.
  double du = 0, dt = 0, u = 12 / p.bodies[0].youngs_modulus, t = 0;
  std::vector<double> values;
  set_ends(wanted, 1, [&](double x, double y, double nx, double ny, End&) {
    const State s = field(x, y);
    values.insert(values.end(), {s.ux, s.uy, s.sxx * nx + s.sxy * ny, s.sxy * nx + s.syy * ny});
  });
  REQUIRE(values.size() == 4 * r.boundary[0].size());
  for (size_t i = 0; i < r.boundary[0].size(); ++i) {
    const EndResult& end = r.boundary[0][i];
    const double* w = &values[4 * i];
    u = std::max({u, std::fabs(w[0]), std::fabs(w[1])}), t = std::max({t, std::fabs(w[2]), std::fabs(w[3])});
    du = std::max({du, std::fabs(end.ux - w[0]), std::fabs(end.uy - w[1])});
    dt = std::max({dt, std::fabs(end.tx - w[2]), std::fabs(end.ty - w[3])});
  }
  worst.u = du / u, worst.t = dt / t;
  return worst;
}
double interior_error(const Problem& p, const Setup& setup, const Result& r, const Field& field, int32_t flag) {
  double worst = 0, stress = 0, displacement = 12 / p.bodies[0].youngs_modulus, du = 0;
  for (size_t i = 0; i < setup.points.size() / 2; ++i) {
    const double* row = r.interior.data() + i * C2D_POINT_FIELDS;
    const State s = field(setup.points[2 * i], setup.points[2 * i + 1]);
    CHECK(row[C2D_POINT_FLAG] == flag);
    du = std::max({du, std::fabs(row[C2D_POINT_UX] - s.ux), std::fabs(row[C2D_POINT_UY] - s.uy)});
    worst = std::max({worst, std::fabs(row[C2D_POINT_SXX] - s.sxx), std::fabs(row[C2D_POINT_SYY] - s.syy),
                      std::fabs(row[C2D_POINT_SXY] - s.sxy)});
    displacement = std::max({displacement, std::fabs(s.ux), std::fabs(s.uy)});
    stress = std::max({stress, std::fabs(s.sxx), std::fabs(s.syy), std::fabs(s.sxy)});
  }
  return std::max(worst / stress, du / displacement);
}

// A column of height h above y = base under its weight, by < 0; sides free, or guided (ux = 0).
Field free_column(const Elastic& m, double by, double base, double h) {
  return [=](double x, double y) {
    const double z = y - base, s = by * (h - z);
    return State{-m.nu * s * x / m.e, by * (h * z - z * z / 2) / m.e - m.nu * by * x * x / (2 * m.e), 0, s, 0};
  };
}
Field guided_column(const Elastic& m, double by, double base, double h) {
  return [=](double, double y) {
    const double z = y - base, s = by * (h - z);
    return State{0, (1 - m.nu * m.nu) * by * (h * z - z * z / 2) / m.e, m.nu * s, s, 0};
  };
}

const std::pair<int32_t, double> kMaterials[] = {
    {C2D_PLANE_STRAIN, 0.3}, {C2D_PLANE_STRAIN, 0.5}, {C2D_PLANE_STRAIN, -0.4}, {C2D_PLANE_STRESS, 0.3}};

} // namespace

TEST_CASE("body force: a column under its weight is exact") {
  const int32_t orders[][2] = {{2, 3}, {3, 3}, {2, 4}, {4, 4}}; // geometry, functions
  for (const auto& order : orders)
    for (const auto& material : kMaterials) {
      CAPTURE(order[0]);
      CAPTURE(order[1]);
      CAPTURE(material.second);
      Problem p = one_body(order[0], order[1], material.first, material.second);
      add_polygon(p.bodies[0], {{-1, 7, 3}, {1, 7, 4}, {1, 10, 2}, {-1, 10, 5}});
      p.body_forces = {{1, 1, 0, -4}};
      const Elastic m = plane_constants(p);
      Setup setup;
      setup.points = {0.3, 8.1, -0.7, 9.5, 0.9, 7.2, -0.99999, 8.4};
      const Field free = free_column(m, -4, 7, 3), guided = guided_column(m, -4, 7, 3);
      give(p, free, [](double, double ny, int) { return ny < -0.5; });
      Result r = solved(p, setup);
      Error e = boundary_error(p, r, free);
      CHECK(e.u < 1e-10);
      CHECK(e.t < 1e-10);
      CHECK(interior_error(p, setup, r, free, C2D_POINT_INSIDE) < 1e-9);
      CHECK(std::fabs(r.summary.body[0].applied[1]) < 1e-11 * 24); // support and weight
      give(p, guided, [](double nx, double ny, int c) { return c == 0 ? std::fabs(nx) > 0.5 : ny < -0.5; });
      r = solved(p, setup);
      e = boundary_error(p, r, guided);
      CHECK(e.u < 1e-10);
      CHECK(e.t < 1e-10);
      CHECK(interior_error(p, setup, r, guided, C2D_POINT_INSIDE) < 1e-9);
      setup.points = {0.334, 7.002, -0.9999, 9.9999, 0.9999, 7.7501, 0.01, 9.999}; // close to nodes
      CHECK(interior_error(p, setup, solved(p, setup), guided, C2D_POINT_NEAR_NODE) < 1e-9);
      // Nothing but the weight does work: half of its force times displacement, 2 wide, 3 high.
      const double stored = (1 - m.nu * m.nu) / m.e * 4 * 4 * 2 * 3 * 3 * 3 / 6;
      CHECK(r.summary.work == doctest::Approx(stored).epsilon(1e-9).scale(1 / m.e));
      CHECK(r.summary.elastic == doctest::Approx(stored).epsilon(1e-9).scale(1 / m.e));
    }
}

TEST_CASE("body force: weight along x, and load factors") {
  Problem p = one_body(2, 3, C2D_PLANE_STRESS, 0.25);
  add_polygon(p.bodies[0], {{2, -1, 4}, {5, -1, 2}, {5, 1, 5}, {2, 1, 3}});
  p.body_forces = {{1, 1, -2, 0}};
  p.paths = {{1, 2.5}};
  const Field upright = free_column(plane_constants(p), -5, 2, 3); // turned by a quarter
  const Field field = [&](double x, double y) {
    const State s = upright(y, x);
    return State{s.uy, s.ux, s.syy, s.sxx, s.sxy};
  };
  give(p, field, [](double nx, double, int) { return nx < -0.5; });
  for (End& end : p.bodies[0].ends)
    for (double& value : end.values) value /= 2.5;
  const Error e = boundary_error(p, solved(p), field);
  CHECK(e.u < 1e-10);
  CHECK(e.t < 1e-10);
}

TEST_CASE("body force: equilibrium and Hooke's law hold inside, whatever the mesh") {
  // Independent of any closed form: differences of the answers at interior points, from a body of odd shape.
  for (int32_t f : {1, 2, 3})
    for (const auto& material : kMaterials) {
      CAPTURE(f);
      CAPTURE(material.second);
      Problem p = one_body(2, f, material.first, material.second);
      add_polygon(p.bodies[0], {{0, 0, 4}, {3, 0.5, 4}, {2, 3, 3}, {-1, 2, 3}});
      set_ends(p, 1, [](double, double, double, double ny, End& end) {
        if (ny > -0.9) return;
        for (int c = 0; c < 2; ++c) end.codes[c] = 1, end.codes[2 + c] = 0;
      });
      const double bx = 0.7, by = -2, w = 1.3, x0 = 0.4, y0 = -0.6;
      p.body_forces = {{1, 1, bx, by, w, x0, y0}};
      const double x = 1.1, y = 1.4, h = 1e-3;
      Setup setup;
      setup.points = {x, y, x + h, y, x - h, y, x, y + h, x, y - h};
      const Result r = solved(p, setup);
      const auto at = [&](size_t i, int field) { return r.interior[i * C2D_POINT_FIELDS + static_cast<size_t>(field)]; };
      const auto dx = [&](int field) { return (at(1, field) - at(2, field)) / (2 * h); };
      const auto dy = [&](int field) { return (at(3, field) - at(4, field)) / (2 * h); };
      const double load = std::hypot(bx + w * (x - x0), by + w * (y - y0));
      // Central differences: h^2 times third derivatives of a smooth field, and round-off over h.
      CHECK(std::fabs(dx(C2D_POINT_SXX) + dy(C2D_POINT_SXY) + bx + w * (x - x0)) < 1e-5 * load);
      CHECK(std::fabs(dx(C2D_POINT_SXY) + dy(C2D_POINT_SYY) + by + w * (y - y0)) < 1e-5 * load);
      const Elastic m = plane_constants(p);
      const double sxx = at(0, C2D_POINT_SXX), syy = at(0, C2D_POINT_SYY), sxy = at(0, C2D_POINT_SXY);
      const double size = (std::fabs(sxx) + std::fabs(syy) + std::fabs(sxy)) / m.e;
      CHECK(std::fabs(dx(C2D_POINT_UX) - (sxx - m.nu * syy) / m.e) < 1e-5 * size);
      CHECK(std::fabs(dy(C2D_POINT_UY) - (syy - m.nu * sxx) / m.e) < 1e-5 * size);
      CHECK(std::fabs(dy(C2D_POINT_UX) + dx(C2D_POINT_UY) - 2 * (1 + m.nu) * sxy / m.e) < 1e-5 * size);
      // Supports carry the exact resultants: area 7, from the corners.
      CHECK(std::fabs(r.summary.body[0].applied[0]) + std::fabs(r.summary.body[0].applied[1]) < 1e-11 * 7 * load);
      CHECK(std::fabs(r.summary.body[0].applied[2]) < 1e-11 * 20 * load);
    }
}

namespace {

// Rotating ring a < r < b about its own middle; a = 0: a disc. In plane constants.
struct Spinning {
  Elastic m;
  double a, b, w;
  double radial(double r) const {
    const double hole = a > 0 ? a * a * b * b / (r * r) : 0;
    return (3 + m.nu) / 8 * w * (a * a + b * b - hole - r * r);
  }
  double hoop(double r) const {
    const double hole = a > 0 ? a * a * b * b / (r * r) : 0;
    return (3 + m.nu) / 8 * w * (a * a + b * b + hole) - (1 + 3 * m.nu) / 8 * w * r * r;
  }
  double displacement(double r) const { return r * (hoop(r) - m.nu * radial(r)) / m.e; }
};

// Worst error of displacements on the boundary and of stresses inside, relative to the largest.
double spin_error(const Problem& p, const Spinning& s, double cx, double cy) {
  Setup setup;
  const double from = s.a > 0 ? s.a : 0, middle = 0.5 * (from + s.b);
  for (double angle : {0.3, 1.2}) {
    setup.points.push_back(cx + middle * std::cos(angle));
    setup.points.push_back(cy + middle * std::sin(angle));
  }
  const Result r = solved(p, setup);
  const double largest = s.w * s.b * s.b * s.b / s.m.e; // incompressible discs do not move
  // Work: half of w r times u over what is modelled.
  double stored = 0;
  const int slices = 2000;
  for (int i = 0; i < slices; ++i) {
    const double radius = s.a + (i + 0.5) / slices * (s.b - s.a);
    stored += 0.5 * s.w * radius * s.displacement(radius) * (p.symmetry == 3 ? 0.5 : 2) * kPi * radius * (s.b - s.a) / slices;
  }
  CHECK(r.summary.work == doctest::Approx(stored).epsilon(2e-2).scale(0.01 * s.w * s.b * s.b * s.b * largest));
  CHECK(std::fabs(r.summary.energy_defect) < 1e-9);
  double worst = 0;
  for (const EndResult& end : r.boundary[0]) {
    const double x = end.x - cx, y = end.y - cy, radius = std::hypot(x, y), u = s.displacement(radius);
    worst = std::max({worst, std::fabs(end.ux - u * x / radius) / largest, std::fabs(end.uy - u * y / radius) / largest});
  }
  for (size_t i = 0; i < 2; ++i) {
    const double* row = r.interior.data() + i * C2D_POINT_FIELDS;
    const double c = (setup.points[2 * i] - cx) / middle, t = (setup.points[2 * i + 1] - cy) / middle;
    const double sr = s.radial(middle), st = s.hoop(middle);
    CHECK(row[C2D_POINT_FLAG] == C2D_POINT_INSIDE);
    worst = std::max({worst, std::fabs(row[C2D_POINT_SXX] - sr * c * c - st * t * t) / st,
                      std::fabs(row[C2D_POINT_SYY] - sr * t * t - st * c * c) / st,
                      std::fabs(row[C2D_POINT_SXY] - (sr - st) * c * t) / st});
  }
  return worst;
}

// A quarter of a ring or disc, or the whole, with n elements per quarter and curve.
Problem spinning(int32_t n, bool quarter, double a, double b, double cx, double cy, int32_t plane, double nu) {
  Problem p = one_body(3, 3, plane, nu);
  Body& body = p.bodies[0];
  const auto arc = [&](double radius, double from, double to) {
    const int32_t elements = quarter ? n : 4 * n, points = 2 * elements;
    const int32_t first = body.regions.empty() ? 1 : body.regions.back().last + 1;
    for (int32_t i = 0; i < points + (quarter ? 1 : 0); ++i) {
      const double angle = from + (to - from) * i / points;
      double c = std::cos(angle), s = std::sin(angle);
      if (quarter && std::fabs(c) < 1e-12) c = 0;
      if (quarter && std::fabs(s) < 1e-12) s = 0;
      body.xy.push_back(cx + radius * c), body.xy.push_back(cy + radius * s);
    }
    body.regions.push_back({first, first + elements - 1});
    if (quarter) ++body.open_regions;
  };
  arc(b, 0, quarter ? kPi / 2 : 2 * kPi);
  if (a > 0) arc(a, quarter ? kPi / 2 : 0, quarter ? 0 : -2 * kPi);
  if (quarter) p.symmetry = 3, p.symmetry_at[0] = cx, p.symmetry_at[1] = cy;
  body.ends.assign(static_cast<size_t>(p.elements(1) * 3), End());
  if (!quarter) {
    const auto hold = [&](int32_t element, int c) {
      End& end = p.end(1, element, 1);
      end.codes[c] = 1, end.codes[2 + c] = 0;
    };
    hold(1, 1), hold(1 + n, 0), hold(1 + 2 * n, 1);
  }
  p.body_forces = {{1, 1, 0, 0, 6.0, cx, cy}};
  return p;
}

} // namespace

TEST_CASE("body force: spinning disc and ring, whole and by images") {
  for (const auto& material : kMaterials)
    for (bool quarter : {true, false})
      for (double a : {0.0, 1.0}) {
        CAPTURE(material.second);
        CAPTURE(quarter);
        CAPTURE(a);
        double before = 1;
        for (int32_t n : {3, 6, 12}) {
          if (n == 12 && !quarter) continue;
          const Problem p = spinning(n, quarter, a, 2, 0.7, -0.4, material.first, material.second);
          const double error = spin_error(p, {plane_constants(p), a, 2, 6.0}, 0.7, -0.4);
          CAPTURE(n);
          CAPTURE(error);
          CHECK(error < before / 5); // quadratic elements: third order or better
          CHECK(error < 0.02);
          before = error;
        }
        CHECK(before < (quarter ? 2e-4 : 2e-3));
      }
}

TEST_CASE("body force: half a column by images") {
  Problem p = one_body(2, 3, C2D_PLANE_STRAIN, 0.3);
  p.symmetry = 1;
  Body& body = p.bodies[0];
  const double corners[][3] = {{0, 7, 2}, {1, 7, 4}, {1, 10, 2}, {0, 10, 0}};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < corners[i][2]; ++k) {
      const double s = k / corners[i][2];
      body.xy.push_back(corners[i][0] + s * (corners[i + 1][0] - corners[i][0]));
      body.xy.push_back(corners[i][1] + s * (corners[i + 1][1] - corners[i][1]));
    }
  body.xy.insert(body.xy.end(), {0.0, 10.0});
  body.regions = {{1, 8}};
  body.open_regions = 1;
  p.body_forces = {{1, 1, 0, -4}};
  const Field exact = free_column(plane_constants(p), -4, 7, 3);
  body.ends.assign(24, End());
  for (size_t i = 0; i < 6; ++i) { // the base: uy as the exact field has it
    End& end = body.ends[i];
    const double x = 0.5 * static_cast<double>(i / 3) + 0.25 * static_cast<double>(i % 3);
    end.codes[1] = 1, end.codes[3] = 0;
    end.values[3] = exact(x, 7).uy;
  }
  const Result r = solved(p);
  double worst = 0;
  for (const EndResult& end : r.boundary[0]) {
    const State s = exact(end.x, end.y);
    worst = std::max({worst, std::fabs(end.ux - s.ux), std::fabs(end.uy - s.uy)});
  }
  CHECK(worst < 1e-10 * std::fabs(exact(0, 10).uy));
  CHECK(std::fabs(r.summary.body[0].applied[1]) < 1e-11 * 12);
}

TEST_CASE("body force: what is not symmetric is refused") {
  Problem p = spinning(4, true, 1, 2, 0.7, -0.4, C2D_PLANE_STRAIN, 0.3);
  CHECK(solve(p).status == C2D_OK);
  p.body_forces = {{1, 1, 0, 0, 6.0, 0.7, 0}};
  Result r = solve(p);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.messages().find("turns about a point off the line of symmetry y = -0.4") != std::string::npos);
  p.body_forces = {{1, 1, 3, 0}};
  r = solve(p);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.messages().find("acts across the line of symmetry x = 0.7") != std::string::npos);
}

// ---- contact ------------------------------------------------------------------------------------------------------

namespace {

// A block, 2 wide and 1 high, on a clamped foundation, `gap` above it. `guided`: its sides do not move along x.
Problem block(double mu, double gap, bool guided, int32_t f) {
  Problem p;
  p.function_nodes = 2;
  p.bodies.resize(2);
  add_polygon(p.bodies[0], {{-2, -2, 4}, {2, -2, 2}, {2, 0, 2}, {1, 0, 8}, {-1, 0, 2}, {-2, 0, 2}});
  add_polygon(p.bodies[1], {{-1, gap, 8}, {1, gap, 3}, {1, 1 + gap, 4}, {-1, 1 + gap, 3}});
  set_ends(p, 1, [](double, double, double, double ny, End& end) {
    if (ny > -0.5) return;
    for (int c = 0; c < 2; ++c) end.codes[c] = 1, end.codes[2 + c] = 0;
  });
  set_ends(p, 2, [&](double, double y, double nx, double, End& end) {
    if (!guided || nx < 0.5 || y < 0.5 + gap) return;
    end.codes[0] = 1, end.codes[2] = 0;
  });
  problem::Zone zone = problem::Zone();
  zone.pairs = 9, zone.elements = 8;
  zone.first_element[0] = 9, zone.last_element[0] = 16, zone.first_node[0] = 9, zone.last_node[0] = 17;
  zone.first_element[1] = 8, zone.last_element[1] = 1, zone.first_node[1] = 9, zone.last_node[1] = 1;
  p.zones = {zone};
  p.friction = {mu};
  p.bodies[1].youngs_modulus = 300;
  p.body_forces = {{2, 1, 0, -5}};
  return f == 2 ? p : with_functions(p, f);
}

} // namespace

TEST_CASE("body force: a block rests on a foundation with its whole weight") {
  for (int32_t f : {1, 2, 3})
    for (double mu : {0.0, 0.4}) {
      CAPTURE(f);
      CAPTURE(mu);
      const Result r = solved(block(mu, 0, mu == 0, f));
      CHECK(r.outcome == C2D_REACHED);
      CHECK(r.summary.body[1].contact[1] == doctest::Approx(10).epsilon(1e-12));
      CHECK(r.summary.body[0].contact[1] == doctest::Approx(-10).epsilon(1e-12));
      CHECK(std::fabs(r.summary.body[1].contact[0]) < 1e-11);
      CHECK(r.summary.body[1].applied[1] == doctest::Approx(-10).epsilon(1e-12));
      CHECK(r.summary.force_error < 1e-12);
      CHECK(r.summary.work > 0);
      CHECK(std::fabs(r.summary.energy_defect) < 0.05);
    }
  // A gap: the block falls, without turning, until it touches; then the same again.
  const Result r = solved(block(0, 0.25, true, 2)), flat = solved(block(0, 0, true, 2));
  REQUIRE(r.outcome == C2D_REACHED);
  CHECK(r.summary.body[1].contact[1] == doctest::Approx(10).epsilon(1e-12));
  for (int i = 0; i < 9; ++i)
    CHECK(r.steps.back().at(i, C2D_TN) == doctest::Approx(flat.steps.back().at(i, C2D_TN)).epsilon(1e-9));
}

TEST_CASE("body force: a weight turns with the bodies, whatever the functions") {
  for (int32_t f : {1, 2, 3}) {
    CAPTURE(f);
    const Problem p = block(0.4, 0, false, f);
    const Result straight = solved(p), turned = solved(rotated(p, 37.3));
    REQUIRE(straight.outcome == C2D_REACHED);
    REQUIRE(turned.outcome == C2D_REACHED);
    const Step &a = straight.steps.back(), &b = turned.steps.back();
    double pressure = 0, motion = 0;
    for (int i = 0; i < a.pairs(); ++i) {
      pressure = std::fmax(pressure, std::fabs(a.at(i, C2D_TN)));
      motion = std::fmax(motion, std::fabs(a.at(i, C2D_UN2)));
    }
    for (int i = 0; i < a.pairs(); ++i) {
      for (const int field : {C2D_TN, C2D_TT}) CHECK(std::fabs(a.at(i, field) - b.at(i, field)) < 1e-9 * pressure);
      for (const int field : {C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2})
        CHECK(std::fabs(a.at(i, field) - b.at(i, field)) < 1e-9 * motion);
    }
  }
}

TEST_CASE("body force: weight as a load case of its own") {
  Problem p = block(0.4, 0, false, 2);
  p.body_forces = {{2, 2, 0, -5}};
  set_ends(p, 2, [](double, double, double, double ny, End& end) {
    if (ny > 0.5) end.values[1] = -1;
  });
  p.bodies[1].second_case = p.bodies[1].ends;
  for (End& end : p.bodies[1].second_case) end.values[1] = 0;
  p.bodies[0].second_case = p.bodies[0].ends;
  Setup setup;
  setup.advance_mu = 0.4;
  setup.advance_loads = {0, 3, 0};
  setup.advance_second = {1, 1, 2};
  const Result r = solved(p, setup);
  CHECK(r.outcome == C2D_REACHED);
  const auto sum = [&](size_t step) { // the foundation's pairs are evenly spaced, linear functions
    double force = 0;
    for (int i = 0; i < 9; ++i) force += r.steps[step].at(i, C2D_TN) * (i == 0 || i == 8 ? 0.125 : 0.25);
    return force;
  };
  CHECK(sum(0) == doctest::Approx(10).epsilon(1e-11));
  CHECK(sum(1) == doctest::Approx(16).epsilon(1e-11));
  CHECK(sum(2) == doctest::Approx(20).epsilon(1e-11));
}

TEST_CASE("body force: work does not depend on the order of loads") {
  // Weight, a point load inside and a traction: what one does while another is applied (Betti).
  for (bool half : {false, true}) {
    CAPTURE(half);
    Problem p = one_body(2, 3, C2D_PLANE_STRAIN, 0.3);
    Body& body = p.bodies[0];
    if (half) {
      for (int i = 0; i < 6; ++i) body.xy.insert(body.xy.end(), {i / 6.0, 0});
      for (int i = 0; i < 12; ++i) body.xy.insert(body.xy.end(), {1, i / 6.0});
      for (int i = 0; i <= 6; ++i) body.xy.insert(body.xy.end(), {1 - i / 6.0, 2});
      body.regions = {{1, 24}};
      body.open_regions = 1;
      p.symmetry = 1;
    } else {
      add_polygon(body, {{-1, 0, 12}, {1, 0, 12}, {1, 2, 12}, {-1, 2, 12}});
    }
    body.ends.assign(static_cast<size_t>(p.elements(1) * 3), End());
    const int32_t top = half ? 18 : 24, below = half ? 6 : 12;
    for (int32_t e = 1; e <= below; ++e)
      for (int l = 1; l <= 3; ++l)
        for (int c = 0; c < 2; ++c) p.end(1, e, l).codes[c] = 1, p.end(1, e, l).codes[2 + c] = 0;
    for (int32_t e = top + 1; e <= top + below; ++e)
      for (int l = 1; l <= 3; ++l) p.end(1, e, l).values[1] = 2;
    body.second_case = body.ends;
    for (End& end : body.second_case) end.values[1] = 0;
    p.point_loads = {{1, 0.5, 1.1, 3, -4}};
    if (!half) p.point_loads.push_back({1, -0.5, 1.1, -3, -4});
    p.body_forces = {{1, 2, 0, -5, 2, 0, 1.7}};
    Setup first, second, alone;
    first.advance_loads = {1, 1}, first.advance_second = {0, 1};
    second.advance_loads = {0, 1}, second.advance_second = {1, 1};
    alone.advance_loads = {0}, alone.advance_second = {1};
    const double a = solved(p, first).summary.work, b = solved(p, second).summary.work;
    first.advance_loads = {1}, first.advance_second = {0};
    const double parts = solved(p, first).summary.work + solved(p, alone).summary.work;
    CHECK(std::fabs(a - parts) > 0.1 * parts); // the loads do work on each other
    CHECK(std::fabs(a - b) < 2e-3 * parts);
  }
}

TEST_CASE("body force: work goes with the square of the force, however small") {
  for (double rho_omega2 : {0.0, 0.7}) {
    const auto work = [&](double part) {
      fixture::ModelData d(2);
      d.body(2, {fixture::rectangle(0.3, 0.1, 1.1, 1.7, 3, 4)});
      d.body_forces[0][0] = {0.2 * part, -1.3 * part, rho_omega2 * part, 0.1, 0.6};
      return c2d::body_force_work(d.view(), 0, 0, 0);
    };
    CHECK(work(1) != 0);
    CHECK(work(0x1p-60) == 0x1p-120 * work(1));
  }
}

TEST_CASE("body force: the keyword card") {
  const auto with = [](const std::string& card) {
    std::vector<std::string> deck = deck_test::squares();
    deck.push_back(card);
    return deck_test::read(deck_test::joined(deck));
  };
  CHECK(with("*BODY FORCE 1 1 0 -9.81").status == C2D_OK);
  CHECK(with("*body force 2, 1, 0, 0, 3.5, 1, 2 ! turning").status == C2D_OK);
  CHECK(with("*BODY FORCE 3 1 0 -9.81").status == C2D_ERR_INPUT);
  CHECK(with("*BODY FORCE 1 1 0").status == C2D_ERR_INPUT);
  CHECK(with("*BODY FORCE 1 1 0 -9.81 2").status == C2D_ERR_INPUT);
  CHECK(with("*BODY FORCE 1 0 0 -9.81").status == C2D_ERR_INPUT);
  CHECK(with("*BODY FORCE 1 1 0 -9.81\n*BODY FORCE 2 1 0 -9.81\n*BODY FORCE 1 2 0 -9.81").status == C2D_OK);
  const deck_test::Reading twice = with("*BODY FORCE 1 2 0 -9.81\n*BODY FORCE 1 2 0 -9.81");
  CHECK(twice.status == C2D_ERR_INPUT);
  REQUIRE(twice.faults.size() == 1);
  CHECK(twice.faults[0].text == "body 1 has two body forces in load case 2, expected one card per body and load case");
  CHECK(twice.faults[0].line == static_cast<int>(deck_test::squares().size()) + 2);
  CHECK(twice.faults[0].column == 15);
  const deck_test::Reading near = with("*BODYFORCE 1 1 0 -9.81");
  REQUIRE(near.faults.size() == 1);
  CHECK(near.faults[0].text == "*BODYFORCE is not a known keyword; did you mean *BODY FORCE?");
}
