// Symmetry by images: against closed forms, against the whole body meshed with the mirrored elements (the two
// discretisations are the same equations), against the reference of the disc in a hole, and against decks
// whose symmetry line is meshed.
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

using namespace problem;

namespace {

constexpr double kPi = 3.14159265358979323846;
using Curve = test::Callable<void(double s, double& x, double& y)>;

size_t at(int64_t i) { return static_cast<size_t>(i); }

// An open region through equally spaced parameters of a curve, or through the corners of several straight
// sides.
void add_open(Body& body, int32_t elements, const Curve& curve) {
  const int32_t first = body.regions.empty() ? 1 : body.regions.back().last + 1, steps = elements * (body.element_nodes - 1);
  for (int32_t i = 0; i <= steps; ++i) {
    double x, y;
    curve(static_cast<double>(i) / steps, x, y);
    body.xy.push_back(x);
    body.xy.push_back(y);
  }
  body.regions.push_back({first, first + elements - 1});
  ++body.open_regions;
}
struct Side {
  double x, y;
  int32_t elements;
};
Curve through(const std::vector<Side>& sides, int32_t* elements) {
  *elements = 0;
  for (size_t i = 0; i + 1 < sides.size(); ++i) *elements += sides[i].elements;
  const int32_t all = *elements;
  return [=](double s, double& x, double& y) {
    double place = s * all;
    size_t i = 0;
    while (i + 2 < sides.size() && place > sides[i].elements - 1e-9) place -= sides[i++].elements;
    const double part = place / sides[i].elements;
    x = sides[i].x + part * (sides[i + 1].x - sides[i].x);
    y = sides[i].y + part * (sides[i + 1].y - sides[i].y);
  };
}
void add_open(Body& body, const std::vector<Side>& sides) {
  int32_t elements;
  const Curve curve = through(sides, &elements);
  add_open(body, elements, curve);
}

// Geometry points of an element, by number from 1, open regions or not.
std::vector<double> element_points(const Body& body, int32_t element) {
  const int32_t steps = body.element_nodes - 1;
  size_t r = 0;
  while (body.regions[r].last < element) ++r;
  const bool open = static_cast<int32_t>(r) < body.open_regions;
  const int32_t shift = std::min(static_cast<int32_t>(r), body.open_regions);
  std::vector<double> xy;
  for (int32_t k = 0; k <= steps; ++k) {
    int32_t point = (element - 1) * steps + k + shift;
    if (k == steps && element == body.regions[r].last && !open) point = (body.regions[r].first - 1) * steps + shift;
    xy.push_back(body.xy[at(2 * point)]);
    xy.push_back(body.xy[at(2 * point + 1)]);
  }
  return xy;
}

// Sets every end's condition from its place and outward normal; places on curved elements by Lagrange
// interpolation.
using Setter = test::Callable<void(double x, double y, double nx, double ny, End& end)>;
void set_all(Problem& p, int number, const Setter& set) {
  Body& body = p.bodies[at(number - 1)];
  const int32_t f = p.function_nodes, nodes = body.element_nodes;
  body.ends.assign(at(p.elements(number) * f), End());
  for (int32_t e = 1; e <= p.elements(number); ++e) {
    const std::vector<double> xy = element_points(body, e);
    for (int32_t l = 0; l < f; ++l) {
      const double eta = f == 1 ? 0 : -1 + 2.0 * l / (f - 1);
      double x = 0, y = 0, dx = 0, dy = 0;
      for (int i = 0; i < nodes; ++i) {
        double value = 1, slope = 0;
        for (int j = 0; j < nodes; ++j) {
          if (j == i) continue;
          const double step = 2.0 * (i - j) / (nodes - 1), to = eta - (-1 + 2.0 * j / (nodes - 1));
          slope = slope * to / step + value / step;
          value *= to / step;
        }
        x += value * xy[at(2 * i)], y += value * xy[at(2 * i + 1)];
        dx += slope * xy[at(2 * i)], dy += slope * xy[at(2 * i + 1)];
      }
      if (f > 1 && l == 0) x = xy[0], y = xy[1]; // the same bits from both sides
      if (f > 1 && l == f - 1) x = xy[at(2 * nodes - 2)], y = xy[at(2 * nodes - 1)];
      const double length = std::hypot(dx, dy);
      set(x, y, dy / length, -dx / length, body.ends[at((e - 1) * f + l)]);
    }
  }
}

void fix(End& end, int component, double value) { // displacement known, traction not
  end.codes[component] = 1;
  end.values[component] = 0;
  end.codes[2 + component] = 0;
  end.values[2 + component] = value;
}

double mirror_of(double value, double line) { return 2 * line - value; }

// The body together with its image across a line; map[e - 1] is the whole body's element for element e. Every
// open region ends on this line with one end or both.
Body whole(const Body& half, int32_t function_nodes, int axis, double line, std::vector<int32_t>& map) {
  Body out = half;
  out.regions.clear();
  out.xy.clear();
  out.ends.clear();
  out.open_regions = 0;
  map.assign(static_cast<size_t>(half.regions.back().last), 0);
  const auto on_line = [&](const std::vector<double>& xy, size_t point) {
    return std::fabs(xy[2 * point + at(axis)] - line) < 1e-12;
  };
  int32_t next = 1;
  // One element of the result: an old one, or its image run backwards.
  const auto add = [&](int32_t e, bool image) {
    std::vector<double> xy = element_points(half, e);
    const int32_t points = half.element_nodes;
    for (int32_t k = 0; k + 1 < points; ++k)
      for (int c = 0; c < 2; ++c) {
        const double value = xy[at(2 * (image ? points - 1 - k : k) + c)];
        out.xy.push_back(image && c == axis ? mirror_of(value, line) : value);
      }
    for (int32_t l = 0; l < function_nodes; ++l) {
      End end = half.ends[at((e - 1) * function_nodes + (image ? function_nodes - 1 - l : l))];
      if (image) end.values[axis] *= -1, end.values[2 + axis] *= -1;
      out.ends.push_back(end);
    }
    if (!image) map[at(e - 1)] = next;
    ++next;
  };
  for (size_t r = 0; r < half.regions.size(); ++r) {
    const Range& range = half.regions[r];
    const int32_t first = next;
    const std::vector<double> head = element_points(half, range.first), tail = element_points(half, range.last);
    const bool starts = on_line(head, 0), ends = on_line(tail, at(half.element_nodes - 1));
    const auto images = [&] {
      for (int32_t e = range.last; e >= range.first; --e) add(e, true);
    };
    if (!ends) images();
    for (int32_t e = range.first; e <= range.last; ++e) add(e, false);
    if (ends) images();
    out.regions.push_back({first, next - 1});
    if (starts && ends) continue;
    ++out.open_regions;                                   // its last point
    const std::vector<double>& last = ends ? head : tail; // an image of the start, or the end itself
    const size_t point = ends ? 0 : at(half.element_nodes - 1);
    for (int c = 0; c < 2; ++c) {
      const double value = last[2 * point + at(c)];
      out.xy.push_back(ends && c == axis ? mirror_of(value, line) : value);
    }
  }
  return out;
}

// Largest difference of displacements and tractions of the half at its elements' places in the whole.
double difference(const Result& half, const Result& full, int body, const std::vector<int32_t>& map, int32_t f) {
  double du = 0, u = 0, dt = 0, t = 0;
  for (size_t i = 0; i < half.boundary[body - 1].size(); ++i) {
    const EndResult& a = half.boundary[body - 1][i];
    const EndResult& b = full.boundary[body - 1][at((map[at(a.element - 1)] - 1) * f) + i % at(f)];
    REQUIRE(a.x == doctest::Approx(b.x).epsilon(1e-9).scale(1));
    du = std::max({du, std::fabs(a.ux - b.ux), std::fabs(a.uy - b.uy)});
    dt = std::max({dt, std::fabs(a.tx - b.tx), std::fabs(a.ty - b.ty)});
    u = std::max({u, std::fabs(b.ux), std::fabs(b.uy)});
    t = std::max({t, std::fabs(b.tx), std::fabs(b.ty)});
  }
  REQUIRE(u > 0);
  REQUIRE(t > 0);
  return std::max(du / u, dt / t);
}

Problem single(int32_t function_nodes, int32_t element_nodes) {
  Problem p;
  p.function_nodes = function_nodes;
  p.bodies.resize(1);
  p.bodies[0].element_nodes = element_nodes;
  return p;
}

} // namespace

TEST_CASE("symmetry: a quarter of a plate in tension is exact, and needs no support") {
  for (int32_t f = 1; f <= 4; ++f) {
    for (double line : {0.0, 0.3}) {
      Problem p = single(f, f < 2 ? 2 : f);
      p.symmetry = 3;
      p.symmetry_at[0] = line, p.symmetry_at[1] = -line;
      add_open(p.bodies[0], {{line + 2, -line, 3}, {line + 2, 1 - line, 4}, {line, 1 - line, 0}});
      const double s = 7, e = 1000, nu = 0.3;
      set_all(p, 1, [&](double, double, double nx, double, End& end) { end.values[0] = s * nx; });
      const Result r = solve(p);
      REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
      CHECK(r.summary.symmetry == 3);
      double worst = 0;
      for (const EndResult& end : r.boundary[0]) {
        const double ux = s * (1 - nu * nu) / e * (end.x - line), uy = -s * nu * (1 + nu) / e * (end.y + line);
        worst = std::max({worst, std::fabs(end.ux - ux), std::fabs(end.uy - uy)});
      }
      // Constant elements represent no linear displacement; the others do, exactly.
      if (f > 1)
        CHECK(worst < 1e-9 * s * 2 / e);
      else
        CHECK(worst < 0.1 * s * 2 / e);
    }
  }
}

TEST_CASE("symmetry: a quarter of a thick ring under inner pressure") {
  Problem p = single(3, 3);
  p.symmetry = 3;
  const double a = 1, b = 2, pressure = 10, e = 1000, nu = 0.3;
  add_open(p.bodies[0], 12,
           [&](double s, double& x, double& y) { x = b * std::cos(s * kPi / 2), y = b * std::sin(s * kPi / 2); });
  add_open(p.bodies[0], 12,
           [&](double s, double& x, double& y) { x = a * std::sin(s * kPi / 2), y = a * std::cos(s * kPi / 2); });
  set_all(p, 1, [&](double x, double y, double nx, double ny, End& end) {
    if (std::hypot(x, y) > 1.5) return;
    end.values[0] = -pressure * nx, end.values[1] = -pressure * ny;
  });
  Setup setup;
  for (double angle : {0.0, 0.4, kPi / 2, 2.0, -0.7, kPi}) // in the modelled quarter, on its lines and beyond them
    setup.points.insert(setup.points.end(), {1.5 * std::cos(angle), 1.5 * std::sin(angle)});
  const Result r = solve(p, setup);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  // Lame: sr, st = A -+ B/r^2, u = (1 + nu)/E ((1 - 2nu) A r + B/r).
  const double A = pressure * a * a / (b * b - a * a), B = A * b * b;
  double worst = 0;
  for (const EndResult& end : r.boundary[0]) {
    const double radius = std::hypot(end.x, end.y), u = (1 + nu) / e * ((1 - 2 * nu) * A * radius + B / radius);
    worst = std::max({worst, std::fabs(end.ux - u * end.x / radius), std::fabs(end.uy - u * end.y / radius)});
  }
  CHECK(worst < 2e-5 * (1 + nu) / e * (A + B));
  for (size_t i = 0; i < setup.points.size() / 2; ++i) {
    const double* row = r.interior.data() + i * C2D_POINT_FIELDS;
    const double x = setup.points[2 * i], y = setup.points[2 * i + 1], radius = std::hypot(x, y);
    const double sr = A - B / (radius * radius), st = A + B / (radius * radius), c = x / radius, s = y / radius;
    const double u = (1 + nu) / e * ((1 - 2 * nu) * A * radius + B / radius);
    CAPTURE(i);
    CHECK(row[C2D_POINT_FLAG] == C2D_POINT_INSIDE);
    CHECK(row[C2D_POINT_UX] == doctest::Approx(u * c).epsilon(1e-4).scale(u));
    CHECK(row[C2D_POINT_UY] == doctest::Approx(u * s).epsilon(1e-4).scale(u));
    CHECK(row[C2D_POINT_SXX] == doctest::Approx(sr * c * c + st * s * s).epsilon(1e-4).scale(st));
    CHECK(row[C2D_POINT_SYY] == doctest::Approx(sr * s * s + st * c * c).epsilon(1e-4).scale(st));
    CHECK(row[C2D_POINT_SXY] == doctest::Approx((sr - st) * c * s).epsilon(1e-4).scale(st));
  }
}

namespace {

// A quarter of a plate with a hole, all orders, a closed side hole and a point load: the outer edge is moved.
Problem plate_with_holes(int32_t f, int32_t nodes, double vx, double vy) {
  Problem p = single(f, nodes);
  p.symmetry = 3;
  p.symmetry_at[0] = vx, p.symmetry_at[1] = vy;
  Body& body = p.bodies[0];
  add_open(body, {{vx + 2, vy, 3}, {vx + 2, vy + 1.5, 4}, {vx, vy + 1.5, 0}});
  add_open(body, 4,
           [&](double s, double& x, double& y) { x = vx + 0.7 * std::sin(s * kPi / 2), y = vy + 0.5 * std::cos(s * kPi / 2); });
  set_all(p, 1, [&](double x, double y, double nx, double, End& end) {
    const double X = x - vx, Y = y - vy;
    if (nx > 0.99) {
      fix(end, 0, 0.01 * X * (1 + 0.3 * Y * Y));
      fix(end, 1, -0.004 * Y);
    } else if (Y > 1.49) {
      end.values[1] = 3 + X * X;
      end.values[0] = X;
    }
  });
  p.point_loads.push_back({1, vx + 1.2, vy + 0.9, 2, -1});
  return p;
}

} // namespace

TEST_CASE("symmetry: quarter, half and whole are the same equations") {
  const int32_t orders[][2] = {{1, 2}, {2, 2}, {3, 2}, {4, 2}, {2, 3}, {3, 3}, {4, 4}};
  for (const auto& order : orders) {
    const int32_t f = order[0];
    CAPTURE(f);
    CAPTURE(order[1]);
    const double vx = 0.25, vy = -0.5;
    const Problem quarter = plate_with_holes(f, order[1], vx, vy);
    std::vector<int32_t> to_half, to_whole;
    Problem half = quarter; // mirrored across x = vx: the line y = vy remains
    half.symmetry = 2;
    half.bodies[0] = whole(quarter.bodies[0], f, 0, vx, to_half);
    half.point_loads.push_back({1, 2 * vx - quarter.point_loads[0].x, quarter.point_loads[0].y, -2, -1});
    Problem all = half;
    all.symmetry = 0;
    all.bodies[0] = whole(half.bodies[0], f, 1, vy, to_whole);
    for (size_t i = 0; i < 2; ++i) {
      PointLoad load = half.point_loads[i];
      load.y = 2 * vy - load.y, load.fy = -load.fy;
      all.point_loads.push_back(load);
    }
    Setup setup;
    for (double x : {-1.6, -0.7, 0.25, 1.1, 1.9})
      for (double y : {-1.7, -1.3, -0.5, -0.1, 0.6}) setup.points.insert(setup.points.end(), {x, y});
    // Near and on the boundary's points on the lines, where slopes and stresses come from both sides.
    // Constant elements have no displacement of their own where two of them meet.
    if (f > 1) setup.points.insert(setup.points.end(), {vx, vy + 0.5});
    for (double y : {0.5001, 0.503, 0.51, 1.4999}) setup.points.insert(setup.points.end(), {vx, vy + y});
    for (double x : {0.7, 0.7001, 1.9999}) setup.points.insert(setup.points.end(), {vx - x, vy + 1e-4});
    const Result a = solve(quarter, setup), b = solve(half, setup), c = solve(all, setup);
    REQUIRE_MESSAGE(a.status == C2D_OK, a.messages());
    REQUIRE_MESSAGE(b.status == C2D_OK, b.messages());
    REQUIRE_MESSAGE(c.status == C2D_OK, c.messages());
    CHECK(difference(a, b, 1, to_half, f) < 1e-9);
    CHECK(difference(b, c, 1, to_whole, f) < 1e-9);
    CHECK(2 * a.summary.work == doctest::Approx(b.summary.work).epsilon(1e-9));
    CHECK(4 * a.summary.work == doctest::Approx(c.summary.work).epsilon(1e-9));
    double most[C2D_POINT_FIELDS] = {}, worst[C2D_POINT_FIELDS] = {};
    for (size_t i = 0; i < c.interior.size(); ++i) {
      const size_t field = i % C2D_POINT_FIELDS;
      most[field] = std::max(most[field], std::fabs(c.interior[i]));
      worst[field] =
          std::max({worst[field], std::fabs(a.interior[i] - c.interior[i]), std::fabs(b.interior[i] - c.interior[i])});
    }
    for (size_t field = 0; field < C2D_POINT_FIELDS; ++field) {
      CAPTURE(field);
      CHECK(worst[field] <= 1e-9 * most[field]);
    }
  }
}

namespace {

// A parabolic stamp between smooth guides, pressed on a block whose foot is held; only x >= line.
Problem stamp(int32_t f, int32_t nodes, double line, double mu) {
  Problem p;
  p.function_nodes = f;
  p.symmetry = 1;
  p.symmetry_at[0] = line;
  p.friction = {mu};
  p.paths = {{3, 1.0}, {2, 0.2}};
  p.bodies.resize(2);
  const int32_t n = 6, steps = f > 1 ? f - 1 : 1;
  const auto shape = [](double x) { return 0.05 * x * x; };
  Body &block = p.bodies[0], &top = p.bodies[1];
  block.element_nodes = top.element_nodes = nodes;
  block.youngs_modulus = 3000;
  add_open(block, {{line, -1, 4}, {line + 2, -1, 2}, {line + 2, 0, 2}, {line + 1, 0, n}, {line, 0, 0}});
  int32_t count;
  const Curve sides = through({{0, 0, n}, {1, 0, 3}, {1, 1, 3}, {0, 1, 0}}, &count);
  add_open(top, count, [&](double s, double& x, double& y) {
    sides(s, x, y);
    if (s * count <= n + 1e-9)
      y = shape(x);
    else if (x > 1 - 1e-9)
      y = shape(1) + (1 - shape(1)) * y;
    x += line;
  });
  set_all(p, 1, [&](double, double y, double, double ny, End& end) {
    if (ny > -0.5 || y > -0.9) return;
    fix(end, 0, 0);
    fix(end, 1, 0);
  });
  set_all(p, 2, [&](double, double, double nx, double ny, End& end) {
    if (nx > 0.9) fix(end, 0, 0);
    if (ny > 0.9) end.values[1] = -40;
  });
  // The stamp's last element of n stays out of the contact: its corner is guided.
  const int32_t from = 9, nodes1 = from * steps, c = n - 1, pairs = f > 1 ? c * steps + 1 : c;
  problem::Zone zone = problem::Zone();
  zone.pairs = pairs, zone.elements = c;
  zone.first_element[0] = from + 1, zone.last_element[0] = from + c;
  zone.first_node[0] = nodes1 + 1, zone.last_node[0] = nodes1 + pairs;
  zone.first_element[1] = c, zone.last_element[1] = 1;
  zone.first_node[1] = pairs, zone.last_node[1] = 1;
  p.zones = {zone};
  return p;
}

// The same with both sides meshed. Pair k of the half is pair k of the whole.
Problem whole_stamp(const Problem& half, std::vector<int32_t> map[2]) {
  Problem p = half;
  p.symmetry = 0;
  const int32_t f = half.function_nodes, steps = f > 1 ? f - 1 : 1, n = half.zones[0].elements;
  for (size_t b = 0; b < 2; ++b) p.bodies[b] = whole(half.bodies[b], f, 0, half.symmetry_at[0], map[b]);
  const int32_t all = p.elements(2);
  problem::Zone& zone = p.zones[0];
  zone.elements = 2 * n;
  zone.pairs = f > 1 ? 2 * n * steps + 1 : 2 * n;
  zone.last_element[0] = zone.first_element[0] + 2 * n - 1;
  zone.last_node[0] = zone.first_node[0] + zone.pairs - 1;
  zone.last_element[1] = all - n + 1; // round the end of the region
  zone.last_node[1] = f > 1 ? all * steps - n * steps + 1 : all - n + 1;
  return p;
}

} // namespace

TEST_CASE("symmetry: contact of half a stamp is that of the whole one") {
  const int32_t orders[][2] = {{1, 2}, {2, 2}, {3, 2}, {4, 2}, {3, 3}};
  for (const auto& order : orders)
    for (double mu : {0.0, 0.2})
      for (double line : {0.0, 0.3}) {
        const int32_t f = order[0];
        CAPTURE(f);
        CAPTURE(mu);
        CAPTURE(line);
        const Problem half = stamp(f, order[1], line, mu);
        std::vector<int32_t> map[2];
        const Result a = solve(half), b = solve(whole_stamp(half, map));
        REQUIRE_MESSAGE(a.status == C2D_OK, a.messages());
        REQUIRE_MESSAGE(b.status == C2D_OK, b.messages());
        REQUIRE(a.recorded().size() == 5);
        REQUIRE(b.recorded().size() == 5);
        for (size_t k = 0; k < 5; ++k) {
          const Step sa = a.recorded()[k], sb = b.recorded()[k];
          double t = 0, u = 0, dt = 0, du = 0;
          for (int i = 0; i < sa.pairs(); ++i) {
            for (int field : {C2D_TN, C2D_TT}) {
              dt = std::max(dt, std::fabs(sa.at(i, field) - sb.at(i, field)));
              t = std::max(t, std::fabs(sb.at(i, field)));
            }
            for (int field : {C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2, C2D_GAP, C2D_SLIP_SUM}) {
              du = std::max(du, std::fabs(sa.at(i, field) - sb.at(i, field)));
              u = std::max(u, std::fabs(sb.at(i, field)));
            }
          }
          CAPTURE(k);
          CHECK(dt < 1e-9 * t);
          CHECK(du < 1e-9 * u);
        }
        for (int body = 1; body <= 2; ++body) CHECK(difference(a, b, body, map[body - 1], f) < 1e-9);
        CHECK(a.summary.force_error < 1e-12);
        CHECK(2 * a.summary.work == doctest::Approx(b.summary.work).epsilon(1e-9));
        CHECK(2 * a.summary.elastic == doctest::Approx(b.summary.elastic).epsilon(1e-9));
        CHECK(2 * a.summary.dissipated == doctest::Approx(b.summary.dissipated).epsilon(1e-9).scale(b.summary.work));
        CHECK(2 * a.summary.body[0].contact[1] == doctest::Approx(b.summary.body[0].contact[1]).epsilon(1e-10));
        // A pair on the line has no tangential freedom; constant elements have none there.
        CHECK(a.summary.contact_unknowns == 2 * half.zones[0].pairs - (f > 1 ? 1 : 0));
      }
}

TEST_CASE("symmetry: quarter turns and reflections change nothing") {
  const Problem upright = stamp(2, 2, 0, 0.2);
  const Result a = solve(upright);
  REQUIRE(a.status == C2D_OK);
  const auto turned = [&](double c, double s,
                          double mirror) { // x' = c x - s y, y' = s x + c y after x -> mirror x
    Problem p = upright;
    for (Body& body : p.bodies) {
      for (size_t i = 0; i < body.xy.size(); i += 2) {
        const double x = mirror * body.xy[i], y = body.xy[i + 1];
        body.xy[i] = c * x - s * y, body.xy[i + 1] = s * x + c * y;
      }
      for (End& end : body.ends) {
        const End old = end;
        const int first = std::fabs(c) > 0.5 ? 0 : 1;
        for (int k = 0; k < 4; k += 2) {
          end.codes[k] = old.codes[k + first], end.codes[k + 1] = old.codes[k + 1 - first];
          const double x = mirror * old.values[k], y = old.values[k + 1];
          end.values[k] = c * x - s * y, end.values[k + 1] = s * x + c * y;
        }
      }
    }
    p.symmetry = std::fabs(c) > 0.5 ? 1 : 2;
    return p;
  };
  const double turns[][2] = {{0, 1}, {0, -1}, {-1, 0}};
  for (const auto& turn : turns) {
    const Result b = solve(turned(turn[0], turn[1], 1));
    REQUIRE_MESSAGE(b.status == C2D_OK, b.messages());
    CHECK(compare(a, b).worst() < 1e-9);
  }
}

namespace {

// Disc (body 1) in the hole of a large plate (body 2) pulled along x; a quarter of both.
Problem disc_in_hole(int32_t n) {
  Problem p;
  p.symmetry = 3;
  p.bodies.resize(2);
  const double size = 400;
  add_open(p.bodies[0], n, [](double s, double& x, double& y) { x = std::cos(s * kPi / 2), y = std::sin(s * kPi / 2); });
  add_open(p.bodies[1], n, [](double s, double& x, double& y) { x = std::sin(s * kPi / 2), y = std::cos(s * kPi / 2); });
  add_open(p.bodies[1], {{size, 0, 4}, {size, size, 4}, {0, size, 0}});
  set_all(p, 1, [](double, double, double, double, End&) {});
  set_all(p, 2, [&](double x, double, double nx, double, End& end) {
    if (x > 2 && nx > 0.9) end.values[0] = 1;
  });
  problem::Zone zone = problem::Zone();
  zone.pairs = n + 1, zone.elements = n;
  zone.first_element[0] = 1, zone.last_element[0] = n, zone.first_node[0] = 1, zone.last_node[0] = n + 1;
  zone.first_element[1] = n, zone.last_element[1] = 1, zone.first_node[1] = n + 1, zone.last_node[1] = 1;
  p.zones = {zone};
  return p;
}

} // namespace

TEST_CASE("symmetry: a smooth disc in a hole comes to its reference at second order") {
  const double reference = 0.6090826759,
               angle = 19.62506; // pole pressure over sigma; half the contact, degrees
  double error[3];
  const int32_t elements[] = {30, 60, 120};
  for (int i = 0; i < 3; ++i) {
    const int32_t n = elements[i];
    const Result r = solve(disc_in_hole(n));
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    const Step last = r.recorded().back();
    error[i] = last.at(n, C2D_TN) / reference - 1;
    MESSAGE("elements " << n << ": pole pressure " << last.at(n, C2D_TN) << ", error " << error[i]);
    double open_from = 0, closed_to = 90; // angles from the pole
    for (int k = n; k >= 0; --k) {
      const double place = 90.0 - 90.0 * k / n;
      if (static_cast<int>(last.at(k, C2D_STATUS)) == C2D_OPEN) {
        open_from = place;
        break;
      }
      closed_to = place;
    }
    CHECK(angle > closed_to - 90.0 / n);
    CHECK(angle < open_from + 90.0 / n);
  }
  CHECK(std::fabs(error[1]) < 1e-3);
  CHECK(std::fabs(error[2]) < 3e-4);
  CHECK(std::log2(error[0] / error[2]) / 2 > 1.5);
}

TEST_CASE("symmetry: a deck with a meshed line, by images") {
  for (const char* name : {"sample", "hertz_lin_l"}) {
    CAPTURE(name);
    Setup images;
    images.symmetry = C2D_SYMMETRY_IMAGES;
    const Result meshed = solve_text(deck_text(std::string(name) + ".dat")),
                 r = solve_text(deck_text(std::string(name) + ".dat"), images);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(r.summary.symmetry == 1);
    CHECK(r.summary.force_error < 1e-12);
    REQUIRE(r.recorded().size() == meshed.recorded().size());
    for (size_t k = 0; k < r.recorded().size(); ++k) {
      const Step a = r.recorded()[k], b = meshed.recorded()[k];
      double most = 0, worst = 0;
      for (int i = 0; i < a.pairs(); ++i) {
        most = std::max(most, b.at(i, C2D_TN));
        worst = std::max(worst, std::fabs(a.at(i, C2D_TN) - b.at(i, C2D_TN)));
      }
      CAPTURE(k);
      CHECK(worst < 0.02 * most);
    }
    // Elements on the line carry nothing.
    for (const EndResult& end : r.boundary[0])
      if (end.x == 0 && end.y < -0.1 && end.y > -3.9) CHECK(std::fabs(end.uy) + std::fabs(end.tx) == 0);
  }
}

TEST_CASE("symmetry: forces at points inside a deck with a meshed line, by images") {
  Problem p = load("hertz_lin_l.dat");
  double x = 0, y = 0;
  const std::vector<double>& xy = p.bodies[1].xy;
  for (size_t i = 0; i < xy.size(); i += 2)
    x += 2 * xy[i] / static_cast<double>(xy.size()), y += 2 * xy[i + 1] / static_cast<double>(xy.size());
  const double pressed = resultant(p, solve(p), 2, 1).fy;
  p.point_loads.push_back({2, x, y, 0.1 * pressed, -0.3 * pressed});
  Setup images;
  images.symmetry = C2D_SYMMETRY_IMAGES;
  const Result meshed = solve(p), r = solve(p, images);
  REQUIRE_MESSAGE(meshed.status == C2D_OK, meshed.messages());
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.summary.symmetry == 1);
  const Resultant one = resultant(p, meshed, 2, 1), other = resultant(p, r, 2, 1);
  CHECK(std::fabs(one.fy - pressed) > 0.05 * std::fabs(pressed)); // the force is felt
  CHECK(other.fy == doctest::Approx(one.fy).epsilon(0.02));
}

TEST_CASE("symmetry: two lines of an old deck without contact") {
  Setup images;
  images.symmetry = C2D_SYMMETRY_IMAGES;
  const Result meshed = solve_text(deck_text("plate.dat")), r = solve_text(deck_text("plate.dat"), images);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.summary.symmetry == 3);
  double worst = 0, most = 0;
  for (size_t i = 0; i < r.boundary[0].size(); ++i) {
    const EndResult &a = r.boundary[0][i], &b = meshed.boundary[0][i];
    most = std::max({most, std::fabs(b.ux), std::fabs(b.uy)});
    if (a.x != r.summary.symmetry_at[0] && a.y != r.summary.symmetry_at[1])
      worst = std::max({worst, std::fabs(a.ux - b.ux), std::fabs(a.uy - b.uy)});
  }
  CHECK(worst < 1e-9 * most);
}

TEST_CASE("symmetry: what does not fit is told") {
  const auto told = [](const Problem& p, const char* text, const Setup& setup = Setup()) {
    const Result r = solve(p, setup);
    CHECK(r.status != C2D_OK);
    CHECK_MESSAGE(r.messages().find(text) != std::string::npos, r.messages());
  };
  const Problem good = stamp(2, 2, 0, 0.2);
  Problem p = good;
  p.symmetry = 0;
  told(p, "open regions end on a line of symmetry, but none is defined");
  p = good;
  p.symmetry = 2;
  told(p, "beyond the line of symmetry y = 0");
  p = good;
  p.symmetry = 3;
  p.symmetry_at[1] = -9;
  told(p, "the line of symmetry y = -9 meets no body, expected an open region that ends on it");
  p = good;
  p.bodies[0].xy[0] = 0.1;
  told(p, "ends an open region, expected it on a line of symmetry");
  p = good;
  p.bodies[0].xy[2 * 3] = -0.1;
  told(p, "beyond the line of symmetry x = 0");
  p = good;
  p.bodies[0].xy[2 * 3] = 0;
  told(p, "touches a line of symmetry");
  p = good;
  p.bodies[0].xy[2] = 0;
  told(p, "lies on the line of symmetry x = 0, expected no elements there");
  p = good;
  p.bodies[0].ends[0].values[2] = 0.5;
  told(p, "has a prescribed ux that is not 0");
  p = good;
  p.point_loads.push_back({1, 0, -0.5, 1, 0});
  told(p, "acts across it");
  p = good;
  p.zones[0].first_element[1] = p.elements(2), p.zones[0].last_element[1] = p.zones[0].elements - 1;
  told(p, "does not contain the number of elements given");
  Setup images;
  images.symmetry = C2D_SYMMETRY_IMAGES;
  told(load("block.dat"), "symmetry", images);
  Problem closed = load("sample.dat");
  closed.symmetry = 1;
  told(closed, "lies on the line of symmetry x = 0, expected no elements there");
  closed = load("sample.dat");
  End& end = closed.end(2, 16, 1); // on the axis of the cylinder
  end.codes[1] = 0, end.values[1] = 3;
  told(closed, "expected zero displacement across a line of symmetry and zero traction along it", images);
}

TEST_CASE("symmetry: the interface's rules") {
  std::vector<unsigned char> memory(1 << 20);
  host::Limits limits;
  limits.bodies = 1, limits.function_nodes = 2, limits.body[0].points = 8, limits.body[0].elements = 7;
  limits.body[0].regions = 1, limits.paths = 1;
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, memory.data(), memory.size(), &limits, nullptr, nullptr) == C2D_OK);
  CHECK(c2d_set_symmetry(s, 2, 0) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_symmetry(s, -1, 0) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_symmetry(s, 0, HUGE_VAL) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_symmetry(s, 0, 1) == C2D_OK);
  CHECK(c2d_set_symmetry(s, 0, 1) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_symmetry(s, 1, 1) == C2D_OK);
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = 7, body.regions = 1, body.youngs_modulus = 1;
  body.open_regions = 2;
  CHECK(c2d_set_body(s, 1, &body) == C2D_ERR_ARGUMENT);
  body.open_regions = 1;
  CHECK(c2d_set_body(s, 1, &body) == C2D_OK);
  c2d_close(s);
}

TEST_CASE("symmetry: the keyword card") {
  // A deck made from the sample: half of it, its axis elements left out, is tested through the program's own
  // reader.
  const std::string sample = deck_text("sample.dat") + "*SYMMETRY X 0\n";
  const Result axis = solve_text(sample);
  CHECK(axis.status == C2D_ERR_INPUT);
  CHECK_MESSAGE(axis.messages().find("expected no elements there") != std::string::npos, axis.messages());
  Setup images;
  images.symmetry = C2D_SYMMETRY_IMAGES;
  const Result a = solve_text(sample, images), b = solve_text(deck_text("sample.dat"), images);
  REQUIRE_MESSAGE(a.status == C2D_OK, a.messages());
  CHECK(identical(a, b));
  const auto refused = [](const std::string& text, const char* expected) {
    std::string said;
    try {
      said = solve_text(text).messages();
    } catch (const std::exception& fault) {
      said = fault.what();
    }
    CHECK_MESSAGE(said.find(expected) != std::string::npos, said);
  };
  const std::string deck = deck_text("sample.dat");
  refused(deck + "*SYMMETRY Z 0\n", "expected X or Y");
  refused(deck + "*SYMMETRY X\n", "expected place of the line of symmetry");
  refused(deck + "*SYMMETRY X zero\n", "place of the line of symmetry");
  refused(deck + "*SYMMETRY X 0 0\n", "expected");
  refused(deck + "*SYMMETRY X 0\n*SYMMETRY X 1\n", "appears twice in the deck");
  // A quarter of a plate in tension without elements on its axes: 7 elements, 8 points.
  const std::string quarter = "    1\nPLATE, A QUARTER\n    0    0\n    1    0    2\n    1    2    7    8\n    1    7\n"
                              "    1000.0       0.3\n    1       0.0\n       0.0       0.0\n"
                              "    1        2.0       0.0\n    4        2.0       1.0\n    8        0.0       1.0\n"
                              "    6\n    1    1 0011       7.0       0.0       0.0       0.0\n"
                              "    1    2 0011       7.0       0.0       0.0       0.0\n"
                              "    2    1 0011       7.0       0.0       0.0       0.0\n"
                              "    2    2 0011       7.0       0.0       0.0       0.0\n"
                              "    3    1 0011       7.0       0.0       0.0       0.0\n"
                              "    3    2 0011       7.0       0.0       0.0       0.0\n";
  const std::string end = "    0\n    0    0\n    1    1\n    1       1.0\n";
  const std::string lines = "*SYMMETRY X 0\n*symmetry y 0.0 ! the other one\n";
  const Result r = solve_text(quarter + end + lines);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.summary.body[0].points == 8);
  CHECK(r.summary.body[0].nodes == 8);
  for (const EndResult& place : r.boundary[0]) {
    CHECK(place.ux == doctest::Approx(7.0 * 0.91 / 1000 * place.x).epsilon(1e-9));
    CHECK(place.uy == doctest::Approx(-7.0 * 0.39 / 1000 * place.y).epsilon(1e-9));
  }
  refused(quarter + end, "number of boundary points is 8, expected 7: 7 elements of 2 nodes; more only with *SYMMETRY");
}
