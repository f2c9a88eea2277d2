// The surfaces that elements stand for (model/surface.hpp): closed forms, corners, kinks, jumps of curvature, convexity,
// and what must not matter.
#include "callable.hpp"
#include "model/surface.hpp"
#include "model_fixture.hpp"
#include "problem.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

using namespace fixture;

namespace {

constexpr double kOnce = 1; // load factor

using Curve = test::Callable<void(double t, double& x, double& y)>;
constexpr double kPi = 3.14159265358979323846;

// A ring of points on a closed curve, unequally spaced, t from 0 to 1.
Points sampled(int elements, const Curve& curve, double uneven = 0.3) {
  Points p;
  for (int i = 0; i < elements; ++i) {
    const double t = static_cast<double>(i) / elements;
    double x, y;
    curve(t + uneven / (2 * kPi * 3) * std::sin(6 * kPi * t), x, y);
    p.push_back(x);
    p.push_back(y);
  }
  return p;
}
ModelData body_of_points(const Points& p, int element_nodes = 2) {
  ModelData d(2);
  d.body(element_nodes, {p});
  return d;
}

// Largest |off| of the surface's points of elements first ... last (from 0), and of its normals from `normal`.
struct Errors {
  double off = 0, turned = 0;
};
Errors errors_of(ModelData& d, int32_t first, int32_t last, const test::Callable<double(double, double)>& off,
                 const test::Callable<void(double, double, double*)>& normal) {
  Errors worst;
  for (int32_t e = first; e <= last; ++e)
    for (int k = 0; k <= 20; ++k) {
      const c2d::SurfacePoint p = c2d::surface_point(d.view(), 0, e, -1 + k / 10.0);
      double n[2];
      normal(p.x, p.y, n);
      worst.off = std::max(worst.off, std::fabs(off(p.x, p.y)));
      worst.turned = std::max(worst.turned, std::fabs(p.nx * n[1] - p.ny * n[0]));
      CHECK(p.nx * n[0] + p.ny * n[1] > 0.5);
      CHECK(std::fabs(p.nx * p.nx + p.ny * p.ny - 1) < 1e-14);
    }
  return worst;
}

// Distance from an ellipse of half axes a, b to first order, and its normal.
double off_ellipse(double a, double b, double x, double y) {
  const double gx = 2 * x / (a * a), gy = 2 * y / (b * b);
  return (x * x / (a * a) + y * y / (b * b) - 1) / std::sqrt(gx * gx + gy * gy);
}
void ellipse_normal(double a, double b, double x, double y, double* n) {
  const double gx = x / (a * a), gy = y / (b * b), size = std::sqrt(gx * gx + gy * gy);
  n[0] = gx / size, n[1] = gy / size;
}

} // namespace

TEST_CASE("curves: points on a circle give the circle, out of it and as a hole") {
  for (int elements : {10, 17, 60})
    for (double sense : {1.0, -1.0}) {
      const Curve circle = [=](double t, double& x, double& y) {
        x = 3 + 7 * std::cos(2 * kPi * t), y = -2 + sense * 7 * std::sin(2 * kPi * t);
      };
      ModelData d = body_of_points(sampled(elements, circle, elements > 10 ? 0.3 : 0));
      const Errors e = errors_of(
          d, 0, elements - 1, [](double x, double y) { return std::hypot(x - 3, y + 2) - 7; },
          [&](double x, double y, double* n) { n[0] = sense * (x - 3) / 7, n[1] = sense * (y + 2) / 7; });
      CAPTURE(elements);
      CHECK(e.off < 1e-13);
      CHECK(e.turned < 1e-13);
    }
}

TEST_CASE("curves: an ellipse and a parabola to the fourth order, normals to the third") {
  // At least this order from each mesh to the next, asymptotically: the rate over two halvings.
  const auto check_orders = [](const char* name, const test::Callable<Errors(int)>& of) {
    Errors e[3];
    for (int i = 0; i < 3; ++i) e[i] = of(60 << i);
    CAPTURE(name);
    INFO(e[0].off, " ", e[1].off, " ", e[2].off, "; ", e[0].turned, " ", e[1].turned, " ", e[2].turned);
    CHECK(std::log2(e[0].off / e[2].off) > 2 * 3.7);
    CHECK(std::log2(e[0].turned / e[2].turned) > 2 * 2.7);
    CHECK(e[0].off < 2e-4);
  };
  check_orders("ellipse", [](int elements) {
    const Curve ellipse = [](double t, double& x, double& y) { x = 2 * std::cos(2 * kPi * t), y = std::sin(2 * kPi * t); };
    ModelData d = body_of_points(sampled(elements, ellipse));
    return errors_of(
        d, 0, elements - 1, [](double x, double y) { return off_ellipse(2, 1, x, y); },
        [](double x, double y, double* n) { ellipse_normal(2, 1, x, y, n); });
  });
  check_orders("parabola", [](int elements) { // y = x^2, from x = -1 to 1, closed by a straight line
    const Curve parabola = [](double t, double& x, double& y) { x = -1 + 2 * t, y = x * x; };
    Points p;
    for (int i = 0; i <= elements; ++i) {
      double x, y;
      parabola(static_cast<double>(i) / elements, x, y);
      p.push_back(x), p.push_back(y);
    }
    ModelData d = body_of_points(p);
    return errors_of(
        d, 0, elements - 1, [](double x, double y) { return (y - x * x) / std::sqrt(1 + 4 * x * x); },
        [](double x, double, double* n) {
          const double size = std::sqrt(1 + 4 * x * x);
          n[0] = 2 * x / size, n[1] = -1 / size;
        });
  });
}

TEST_CASE("curves: quadratic elements bent to one tangent are of a higher order than their own curve") {
  double off[2][3];
  for (int i = 0; i < 3; ++i) {
    const int elements = 20 << i;
    Points p;
    arc_to(p, 0, 0, 5, 0, 360, 2 * elements);
    ModelData d = body_of_points(p, 3);
    off[0][i] = off[1][i] = 0;
    for (int32_t e = 0; e < elements; ++e)
      for (double eta : {-0.9, -0.6, -0.3, 0.2, 0.5, 0.8}) {
        const c2d::SurfacePoint s = c2d::surface_point(d.view(), 0, e, eta);
        const c2d::CurvePoint c = c2d::curve_point(d.view(), 0, e, eta);
        off[0][i] = std::max(off[0][i], std::fabs(std::hypot(s.x, s.y) - 5));
        off[1][i] = std::max(off[1][i], std::fabs(std::hypot(c.x, c.y) - 5));
      }
  }
  CHECK(std::log2(off[0][0] / off[0][2]) > 2 * 5.5);
  CHECK(std::log2(off[1][0] / off[1][2]) < 2 * 4.5);
  CHECK(off[0][0] < 0.05 * off[1][0]);
}

TEST_CASE("curves: flats, corners, kinks and the beginning of a fillet are met exactly") {
  // From the corner (0, 0) a flat to (4, 0), a fillet of radius 1 to (5, 1), a flat up to (5, 3), a kink of 5 degrees, on.
  const double lean = 5 * kPi / 180;
  Points p;
  line_to(p, 0, 0, 4, 0, 5);
  arc_to(p, 4, 1, 1, -90, 0, 6);
  line_to(p, 5, 1, 5, 3, 3);
  line_to(p, 5, 3, 5 - 3 * std::sin(lean), 3 + 3 * std::cos(lean), 4);
  line_to(p, 5 - 3 * std::sin(lean), 3 + 3 * std::cos(lean), 0, 6, 1);
  line_to(p, 0, 6, 0, 0, 2);
  ModelData d = body_of_points(p);
  const auto on_line = [&](int32_t first, int32_t last, double x, double y, double nx, double ny) {
    const Errors e = errors_of(
        d, first, last, [=](double px, double py) { return (px - x) * nx + (py - y) * ny; },
        [=](double, double, double* n) { n[0] = nx, n[1] = ny; });
    CHECK(e.off < 1e-12);
    CHECK(e.turned < 1e-12);
  };
  on_line(0, 4, 0, 0, 0, -1);
  on_line(11, 13, 5, 0, 1, 0);
  on_line(14, 17, 5, 3, std::cos(lean), std::sin(lean));
  on_line(19, 20, 0, 0, -1, 0);
  const Errors fillet = errors_of(
      d, 5, 10, [](double x, double y) { return std::hypot(x - 4, y - 1) - 1; },
      [](double x, double y, double* n) { n[0] = x - 4, n[1] = y - 1; });
  CHECK(fillet.off < 1e-8); // what lies across the joint still has a weight, 1e-8 of the rest
  CHECK(fillet.turned < 1e-6);
}

TEST_CASE("curves: a joint within an element costs part of a sagitta there, and little beyond its neighbours") {
  // The fillet begins between two boundary points, anywhere.
  for (double share : {0.25, 0.5, 0.75}) {
    Points p;
    const double h = 0.2, start = -8 * h - share * h; // of the flat; the fillet of radius 1 about (0, 1) begins at 0
    for (int i = 0; i <= 8; ++i) p.push_back(start + i * h), p.push_back(0);
    for (int i = 0; i < 7; ++i) p.push_back(std::sin((i + 1 - share) * h)), p.push_back(1 - std::cos((i + 1 - share) * h));
    p.insert(p.end(), {1, 3, start, 3});
    ModelData d = body_of_points(p);
    double off[15];
    for (int32_t e = 0; e < 15; ++e) {
      off[e] = 0;
      for (double eta : {-0.8, -0.4, 0.0, 0.4, 0.8}) {
        const c2d::SurfacePoint s = c2d::surface_point(d.view(), 0, e, eta);
        off[e] = std::max(off[e], s.x < 0 ? std::fabs(s.y) : std::fabs(std::hypot(s.x, s.y - 1) - 1));
      }
    }
    CAPTURE(share);
    const double sagitta = h * h / 8;
    for (int32_t e = 0; e < 15; ++e) CHECK(off[e] < (e == 8 ? 0.5 : e == 7 || e == 9 ? 0.25 : 0.05) * sagitta);
  }
}

TEST_CASE("curves: convex where the points are") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 200; ++round) {
    // Points of a circle at random angles, stretched: a convex polygon, some of whose sides are much longer than others.
    const int elements = 12 + round % 30;
    std::vector<double> angle(static_cast<size_t>(elements));
    for (double& a : angle) a = 2 * kPi * unit(random);
    std::sort(angle.begin(), angle.end());
    const double stretch = 1 + 4 * unit(random);
    Points p;
    for (double a : angle) p.push_back(stretch * std::cos(a)), p.push_back(std::sin(a));
    ModelData d = body_of_points(p);
    double turn = 0, before[2] = {0, 0}, first[2] = {0, 0}, least = 0;
    for (int32_t e = 0; e < elements; ++e)
      for (int k = 0; k <= 16; ++k) {
        const c2d::SurfacePoint s = c2d::surface_point(d.view(), 0, e, -1 + k / 8.0);
        if (e > 0 || k > 0) {
          const double step = std::atan2(before[0] * s.ny - before[1] * s.nx, before[0] * s.nx + before[1] * s.ny);
          least = std::min(least, step);
          turn += step;
        } else {
          first[0] = s.nx, first[1] = s.ny;
        }
        before[0] = s.nx, before[1] = s.ny;
      }
    turn += std::atan2(before[0] * first[1] - before[1] * first[0], before[0] * first[0] + before[1] * first[1]);
    CAPTURE(round);
    CHECK(least > -1e-9);
    CHECK(turn == doctest::Approx(2 * kPi).epsilon(1e-9));
  }
}

TEST_CASE("curves: directions, units, mirrors and numbers do not matter") {
  const Curve egg = [](double t, double& x, double& y) {
    const double a = 2 * kPi * t, r = 2 + 0.5 * std::cos(a) + 0.2 * std::sin(3 * a);
    x = r * std::cos(a), y = 0.7 * r * std::sin(a);
  };
  const int elements = 23;
  const Points p = sampled(elements, egg);
  ModelData plain = body_of_points(p);
  struct Change {
    double angle, size;
    int shift;
    bool mirrored;
  };
  for (const Change& c : {Change{1.1, 1, 0, false},
                          {0, 1e-6, 0, false},
                          {0, 3e5, 0, false},
                          {0, 1, 9, false},
                          {0, 1, 0, true},
                          {2.3, 1e3, 5, true}}) {
    const double cosine = c.size * std::cos(c.angle), sine = c.size * std::sin(c.angle);
    Points q(p.size());
    const auto place = [&](int i) { // of element i in the other body
      const int moved = (i + c.shift) % elements;
      return c.mirrored ? (elements - 1 - moved) : moved;
    };
    const auto map = [&](double x, double y, double* out) {
      if (c.mirrored) x = -x;
      out[0] = cosine * x - sine * y, out[1] = sine * x + cosine * y;
    };
    for (int i = 0; i < elements; ++i) { // a mirrored element begins where the other ends
      const size_t from = static_cast<size_t>(c.mirrored ? (i + 1) % elements : i), to = static_cast<size_t>(place(i));
      map(p[2 * from], p[2 * from + 1], &q[2 * to]);
    }
    ModelData other = body_of_points(q);
    for (int32_t e = 0; e < elements; ++e)
      for (double eta : {-1.0, -0.35, 0.0, 0.6, 1.0}) {
        const c2d::SurfacePoint a = c2d::surface_point(plain.view(), 0, e, eta),
                                b = c2d::surface_point(other.view(), 0, place(e), c.mirrored ? -eta : eta);
        double point[2], normal[2];
        map(a.x, a.y, point);
        map(a.nx, a.ny, normal);
        CHECK(std::hypot(b.x - point[0], b.y - point[1]) < 1e-13 * c.size);
        CHECK(std::hypot(c.size * b.nx - normal[0], c.size * b.ny - normal[1]) < 1e-12 * c.size);
      }
  }
}

TEST_CASE("curves: no last digit turns the ends of flats of few chords") {
  // Land, a roof of two inclines of two chords each, land: turns that are no corners, and joints within flats that turn by
  // round-off, either way. Equal as they may be told, also in other directions.
  for (const double rise : {0.02, 0.05, 0.15, 0.25})
    for (const double fall : {0.03, 0.16}) {
      const Points flat = {0, 0,   1, 0, 1.5, rise, 2, 2 * rise, 2.6, 2 * rise - fall, 3.2, 2 * rise - 2 * fall,
                           4, 0.1, 4, 3, 0,   3};
      ModelData plain = body_of_points(flat);
      for (int turn = 1; turn < 100; ++turn) {
        const double cosine = std::cos(0.0628 * turn), sine = std::sin(0.0628 * turn);
        Points p(flat.size());
        for (size_t i = 0; i < p.size(); i += 2)
          p[i] = cosine * flat[i] - sine * flat[i + 1], p[i + 1] = sine * flat[i] + cosine * flat[i + 1];
        ModelData turned = body_of_points(p);
        double worst = 0;
        for (int32_t e = 0; e < 9; ++e)
          for (double eta : {-1.0, -0.4, 1.0}) {
            const c2d::SurfacePoint a = c2d::surface_point(plain.view(), 0, e, eta),
                                    b = c2d::surface_point(turned.view(), 0, e, eta);
            worst = std::max(worst, std::hypot(cosine * a.nx - sine * a.ny - b.nx, sine * a.nx + cosine * a.ny - b.ny));
          }
        CAPTURE(rise);
        CAPTURE(turn);
        CHECK(worst < 1e-10);
      }
    }
}

TEST_CASE("curves: at a line of symmetry a surface goes on as its own image") {
  const Curve ellipse = [](double t, double& x, double& y) { x = 2 * std::cos(2 * kPi * t), y = std::sin(2 * kPi * t); };
  const int quarter = 9;
  ModelData whole = body_of_points(sampled(4 * quarter, ellipse, 0));
  Points p = sampled(4 * quarter, ellipse, 0);
  p.resize(2 * (quarter + 1));
  ModelData part = body_of_points(p);
  part.bodies[0].elements = quarter;
  part.regions[0][0] = {0, quarter - 1, 1, 0};
  part.xy[0][2 * quarter] = 0; // on the line to the last digit
  part.head.symmetry = part.bodies[0].lines = 3;
  for (int32_t e = 0; e < quarter; ++e)
    for (double eta : {-1.0, -0.5, 0.3, 1.0}) {
      const c2d::SurfacePoint a = c2d::surface_point(whole.view(), 0, e, eta), b = c2d::surface_point(part.view(), 0, e, eta);
      CHECK(std::hypot(a.x - b.x, a.y - b.y) < 1e-13);
      CHECK(std::hypot(a.nx - b.nx, a.ny - b.ny) < 1e-12);
    }
}

TEST_CASE("curves: surfaces of the same points have no gap, however they go on beyond the zone") {
  // Body 1 goes on as a smooth arc on either side of the zone, body 2 ends there.
  for (int functions : {2, 3, 4})
    for (int nodes : {2, 3}) {
      const int steps = nodes - 1;
      ModelData d(functions);
      Points below, above;
      arc_to(below, 0, -6, 6, 30, 150, 12 * steps);
      line_to(below, 6 * std::cos(150 * kPi / 180), -3, 6 * std::cos(150 * kPi / 180), -8, steps);
      line_to(below, 6 * std::cos(150 * kPi / 180), -8, 6 * std::cos(30 * kPi / 180), -8, 4 * steps);
      line_to(below, 6 * std::cos(30 * kPi / 180), -8, 6 * std::cos(30 * kPi / 180), -3, steps);
      const auto at = [&below](int i) { return below[static_cast<size_t>(i)]; };
      for (int i = 8 * steps; i >= 4 * steps; --i) above.insert(above.end(), {at(2 * i), at(2 * i + 1)});
      const double left = above[0], right = -left;
      above.resize(above.size() - 2);
      line_to(above, right, at(8 * steps + 1), right, 3, 2 * steps);
      line_to(above, right, 3, left, 3, 2 * steps);
      line_to(above, left, 3, left, at(16 * steps + 1), 2 * steps);
      d.body(nodes, {below});
      d.body(nodes, {above});
      for (int l = 1; l <= functions; ++l) d.condition(1, 15, l, "1100");
      d.zone(4 * (functions - 1) + 1, 4, 5, 1, 4 * (functions - 1) + 1, 4, -1, 4 * (functions - 1) + 1, 30);
      CAPTURE(functions);
      CAPTURE(nodes);
      REQUIRE_MESSAGE(d.complete(), d.all());
      for (const c2d::Pair& p : d.pairs) CHECK(p.gap == 0);
    }
}

TEST_CASE("curves: a line, an arc and a spline that are told") {
  // A flat of two elements, a fillet of two (radius 1 about (4, 1)), a flat of two, and the rest.
  Points p;
  line_to(p, 0, 0, 4, 0, 2);
  arc_to(p, 4, 1, 1, -90, 0, 2);
  line_to(p, 5, 1, 5, 3, 2);
  line_to(p, 5, 3, 0, 3, 1);
  line_to(p, 0, 3, 0, 0, 1);
  const auto off_fillet = [](ModelData& d) {
    return errors_of(
        d, 2, 3, [](double x, double y) { return std::hypot(x - 4, y - 1) - 1; },
        [](double x, double y, double* n) { n[0] = x - 4, n[1] = y - 1; });
  };
  ModelData guessed = body_of_points(p);
  CHECK(off_fillet(guessed).off > 1e-3);
  ModelData told = body_of_points(p);
  told.surfaces = {{C2D_CURVE_ARC, 0, 2, 3, 0, 0, {4, 1}, 1}};
  CHECK(off_fillet(told).off < 1e-15);
  CHECK(off_fillet(told).turned < 1e-15);
  for (const int32_t flat : {0, 1, 4, 5}) { // what ends at the fillet is straight to its end
    const c2d::SurfacePoint s = c2d::surface_point(told.view(), 0, flat, 0.9);
    CHECK(std::min(std::fabs(s.y), std::fabs(s.x - 5)) < 1e-14);
  }
  // The same as quadratic elements, whose own curve is off the circle.
  Points q;
  for (size_t i = 0; i < p.size(); i += 2) {
    const size_t next = (i + 2) % p.size();
    double x = 0.5 * (p[i] + p[next]), y = 0.5 * (p[i + 1] + p[next + 1]);
    if (i == 4 || i == 6) {
      const double r = std::hypot(x - 4, y - 1);
      x = 4 + (x - 4) / r, y = 1 + (y - 1) / r;
    }
    q.insert(q.end(), {p[i], p[i + 1], x, y});
  }
  ModelData curved = body_of_points(q, 3);
  CHECK(off_fillet(curved).off > 1e-5);
  curved.surfaces = told.surfaces;
  CHECK(off_fillet(curved).off < 1e-15);
  // A hexagon told as a line stays one, as a spline it is the circle.
  Points hexagon;
  arc_to(hexagon, 0, 0, 2, 0, 360, 6);
  ModelData ring = body_of_points(hexagon);
  ring.surfaces = {{C2D_CURVE_SPLINE, 0, 0, 5, 0, 0, {0, 0}, 0}};
  const Errors circle = errors_of(
      ring, 0, 5, [](double x, double y) { return std::hypot(x, y) - 2; },
      [](double x, double y, double* n) { n[0] = x / 2, n[1] = y / 2; });
  CHECK(circle.off < 1e-14);
  ring.surfaces[0].kind = C2D_CURVE_LINE;
  ring.surfaces[0].last = 0;
  const c2d::SurfacePoint middle = c2d::surface_point(ring.view(), 0, 0, 0);
  CHECK(std::hypot(middle.x, middle.y) == doctest::Approx(std::sqrt(3.0)).epsilon(1e-15));
  // A spline of unequal steps is of the fourth order, too.
  double off[3];
  for (int i = 0; i < 3; ++i) {
    const int elements = 60 << i;
    ModelData d = body_of_points(
        sampled(elements, [](double t, double& x, double& y) { x = 2 * std::cos(2 * kPi * t), y = std::sin(2 * kPi * t); }));
    d.surfaces = {{C2D_CURVE_SPLINE, 0, 0, elements - 1, 0, 0, {0, 0}, 0}};
    off[i] = errors_of(
                 d, 0, elements - 1, [](double x, double y) { return off_ellipse(2, 1, x, y); },
                 [](double x, double y, double* n) { ellipse_normal(2, 1, x, y, n); })
                 .off;
  }
  CHECK(std::log2(off[0] / off[2]) > 2 * 3.7);
}

namespace {

// Two squares of four sides, the upper one on the lower, as in FREE.md.
const char* const kSquares = "*FREE\n1\nTWO SQUARES\n0 1\n2 1 2\n1 2 4 4\n1 2 4 4\n1 4\n1 4\n100 0.3\n200 0.2\n1 0.5\n0 0\n"
                             "1 0 0\n2 1 0\n3 1 1\n4 0 1\n0 1\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n2\n1 1 1100 0 0 0 0\n"
                             "1 1 2 1100 0 0 0 0\n0\n2\n3 1 0011 0 -1 0 0\n1 3 2 0011 0 -1 0 0\n0\n1 2 2 1\n3 3 1 1\n"
                             "3 4 2 1\n2 1\n2 1\n1 10\n4 1\n";

std::string told_of(const std::string& cards) {
  try {
    const problem::Result r = problem::solve_text(kSquares + cards);
    return (r.status == C2D_OK ? "solved " : "") + r.messages();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

} // namespace

TEST_CASE("curves: *CURVE cards, their faults and those of what they tell") {
  const auto says = [](const std::string& cards, const char* part) {
    const std::string said = told_of(cards);
    CHECK_MESSAGE(said.find(part) != std::string::npos, said);
  };
  says("*CURVE LINE 1 3 3\n*curve spline 2 1 1\n", "solved");
  says("*CURVE\n", "expected one of: line, arc, spline");
  says("*CURVE CIRCLE 1 3 3\n", "expected one of: line, arc, spline");
  says("*CURVE LINE 3 1 1\n", "body number");
  says("*CURVE LINE 1 1 5\n", "element of the curve");
  says("*CURVE LINE 1 1\n", "element of the curve");
  says("*CURVE LINE 1 1 1 1\n", "5 fields, expected 4");
  says("*CURVE ARC 1 1 1 0 0\n", "radius");
  says("*CURVE ARC 1 1 1 0 0 x\n", "radius");
  says("*CURVE ARC 1 1 1 0 0 -1\n", "a radius above zero");
  says("*CURVE LINE 1 3 2\n", "a range of one region, going up");
  says("*CURVE LINE 1 2 3\n", "line of elements 2 to 3 of body 1: point 3 is 0.7071");
  says("*CURVE ARC 1 3 3 0.5 0.5 0.8\n", "arc of elements 3 to 3 of body 1: point 3 is 0.0928");
  says("*CURVE LINE 1 3 3\n*CURVE SPLINE 1 2 4\n", "element 3 of body 1 is in curves 1 and 2, expected it in one curve only");
  // An arc that fits: the corners of the square lie on a circle. Middles of the sides have no node: nothing changes.
  const std::string plain = told_of(""), arc = told_of("*CURVE ARC 1 3 3 0.5 0.5 0.70710678\n");
  CHECK(plain.find("solved") == 0);
  CHECK(arc.find("overlap") == std::string::npos);
}

TEST_CASE("curves: a zone that nothing brings together is told") {
  const auto pushed = [](const char* place, const char* far) {
    std::string deck = kSquares;
    deck.replace(deck.find("0 1\n1 0 0"), 3, far);
    for (const char* card : {"3 1 0011 0 -1 0 0", "1 3 2 0011 0 -1 0 0"}) {
      const size_t at = deck.find(card);
      const std::string head = card[0] == '1' ? "1 3 2" : "3 1";
      deck.replace(at, std::strlen(card), head + " 1100 0 0 0 " + place);
    }
    const problem::Result r = problem::solve_text(deck);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    return r;
  };
  const problem::Result far = pushed("-0.01", "0 1.5"), near = pushed("-0.01", "0 1.05"), touching = pushed("-0.01", "0 1.005");
  CHECK(far.warned(C2D_WARN_FAR));
  CHECK(far.messages().find("the smallest gap is 0.49 at pair") != std::string::npos);
  CHECK(!near.warned(C2D_WARN_FAR)); // 0.04 left, 0.01 closed
  CHECK(!touching.warned(C2D_WARN_FAR));
}

TEST_CASE("curves: calls refuse what cannot be, and give back what they were told") {
  host::Limits limits;
  limits.bodies = 1, limits.function_nodes = 2;
  limits.body[0].points = limits.body[0].elements = 8, limits.body[0].regions = 2;
  limits.coefficients = limits.paths = 1, limits.curves = 2;
  uint64_t need = 0;
  REQUIRE(c2d_memory_need(&limits, &need, nullptr, nullptr) == C2D_OK);
  std::vector<unsigned char> memory(need);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_solver* s = nullptr;
  c2d_error why = C2D_INIT(c2d_error);
  REQUIRE(c2d_create(&s, memory.data(), memory.size(), &limits, &port, &why) == C2D_OK);
  c2d_problem problem = C2D_INIT(c2d_problem);
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = 8, body.regions = 2;
  body.youngs_modulus = 1000, body.poisson_ratio = 0.3;
  REQUIRE(c2d_set_problem(s, &problem) == C2D_OK);
  REQUIRE(c2d_set_body(s, 1, &body) == C2D_OK);
  REQUIRE(c2d_add_region(s, 1, 1, 4) == C2D_OK);
  REQUIRE(c2d_add_region(s, 1, 5, 8) == C2D_OK);
  c2d_curve good = C2D_INIT(c2d_curve);
  good.kind = C2D_CURVE_ARC, good.body = 1, good.first_element = 5, good.last_element = 8;
  good.centre[0] = 2, good.centre[1] = 3, good.radius = 0.25;
  const auto refused = [&](c2d_curve c, const char* part) {
    c2d_error last = C2D_INIT(c2d_error);
    CHECK(c2d_add_curve(s, &c) == C2D_ERR_ARGUMENT);
    REQUIRE(c2d_last_error(s, &last) == C2D_OK);
    CHECK_MESSAGE(std::strstr(last.text, part) != nullptr, last.text);
  };
  const auto with = [&](const test::Callable<void(c2d_curve&)>& change) {
    c2d_curve c = good;
    change(c);
    return c;
  };
  CHECK(c2d_add_curve(s, nullptr) == C2D_ERR_ARGUMENT);
  refused(with([](c2d_curve& c) { c.kind = 3; }), "kind of a curve");
  refused(with([](c2d_curve& c) { c.kind = -1; }), "kind of a curve");
  refused(with([](c2d_curve& c) { c.body = 2; }), "c2d_curve.body is 2, expected 1");
  refused(with([](c2d_curve& c) { c.first_element = 0; }), "element of a curve");
  refused(with([](c2d_curve& c) { c.last_element = 9; }), "element of a curve");
  refused(with([](c2d_curve& c) { c.first_element = 4; }), "a range of one region");
  refused(with([](c2d_curve& c) { c.last_element = 5, c.first_element = 6; }), "going up");
  refused(with([](c2d_curve& c) { c.radius = 0; }), "a radius above zero");
  refused(with([](c2d_curve& c) { c.centre[1] = HUGE_VAL; }), "a usable centre");
  REQUIRE(c2d_set_line(s, 17, 0, 0) == C2D_OK);
  REQUIRE(c2d_add_curve(s, &good) == C2D_OK);
  c2d_curve line = C2D_INIT(c2d_curve);
  line.body = line.first_element = line.last_element = 1;
  REQUIRE(c2d_add_curve(s, &line) == C2D_OK);
  CHECK(c2d_add_curve(s, &line) == C2D_ERR_LIMIT);
  const double hole[] = {2.25, 3, 2, 2.75, 1.75, 3, 2, 3.25}, square[] = {0, 0, 6, 0, 6, 6, 0, 6};
  REQUIRE(c2d_set_nodes(s, 1, 1, 4, square, 2) == C2D_OK);
  REQUIRE(c2d_set_nodes(s, 1, 5, 4, hole, 2) == C2D_OK);
  const int32_t held[4] = {1, 1, 0, 0};
  const double none[4] = {0, 0, 0, 0};
  REQUIRE(c2d_set_condition(s, 1, 1, 1, 1, held, none) == C2D_OK);
  REQUIRE(c2d_set_condition(s, 1, 1, 2, 1, held, none) == C2D_OK);
  REQUIRE(c2d_add_path(s, 1, &kOnce, 1) == C2D_OK);
  REQUIRE(c2d_complete(s) == C2D_OK);
  c2d_curve back = C2D_INIT(c2d_curve);
  REQUIRE(c2d_get_curve(s, 1, &back) == C2D_OK);
  CHECK((back.kind == good.kind && back.body == 1 && back.first_element == 5 && back.last_element == 8 && back.line == 17));
  CHECK((back.centre[0] == 2 && back.centre[1] == 3 && back.radius == 0.25));
  REQUIRE(c2d_get_curve(s, 2, &back) == C2D_OK);
  CHECK((back.kind == C2D_CURVE_LINE && back.radius == 0));
  CHECK(c2d_get_curve(s, 3, &back) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_curve(s, 1, nullptr) == C2D_ERR_ARGUMENT);
}
