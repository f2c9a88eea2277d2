#include "effort.hpp"
#include "gauss_points.hpp"

#include "bie/integrals/integrals.hpp"
#include "bie/integrals/integrals_detail.hpp"
#include "bie/integrals/interior.hpp"
#include "model/shape.hpp"
#include "quadrature/gauss.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <complex>
#include <cstring>
#include <initializer_list>
#include <vector>

using namespace c2d;

namespace {

using Long = long double;

// Reference integrals: the kernels written out from their definition, extended precision, panels halved until
// they are short compared with their distance from the source. Positions are measured from the parameter
// `origin`, so that they stay exact next to it.
struct Reference {
  Element e;
  int functions;
  Long nu;
  Long origin;
  Long coefficient[4][2]; // x(origin + t) - x(origin) = sum_k t^k
  Long delta[2];          // x(origin) - source
  const Element* arc;
  bool reversed;
  Long h[4][2][2], g[4][2][2], scale_h, scale_g;

  void kernel_point(Long t, Long weight) {
    Long r[2], d[2] = {0, 0};
    for (int i = 0; i < 2; ++i) {
      r[i] = delta[i] + t * (coefficient[1][i] + t * (coefficient[2][i] + t * coefficient[3][i]));
      d[i] = coefficient[1][i] + t * (2 * coefficient[2][i] + 3 * t * coefficient[3][i]);
    }
    const Long eta = origin + t, radius = hypotl(r[0], r[1]), own = hypotl(d[0], d[1]);
    Long jacobian = own;
    if (arc != nullptr) {
      const Long other = reversed ? -eta : eta;
      Long s[2] = {0, 0};
      for (int l = 0; l < arc->nodes; ++l) {
        const double* c = shape_coefficients(arc->nodes, l);
        Long slope = 0;
        for (int k = 1; k < arc->nodes; ++k) slope += k * c[k] * powl(other, k - 1);
        s[0] += slope * arc->x[l];
        s[1] += slope * arc->y[l];
      }
      jacobian = hypotl(s[0], s[1]);
    }
    const Long n[2] = {d[1] / own, -d[0] / own}, e_r[2] = {r[0] / radius, r[1] / radius};
    const Long drdn = e_r[0] * n[0] + e_r[1] * n[1], pi = 3.14159265358979323846264338L;
    for (int l = 0; l < functions; ++l) {
      const double* c = shape_coefficients(functions, l);
      Long m = 0;
      for (int k = functions - 1; k >= 0; --k) m = m * eta + c[k];
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          const Long same = i == j ? 1 : 0;
          const Long T =
              -(drdn * ((1 - 2 * nu) * same + 2 * e_r[i] * e_r[j]) - (1 - 2 * nu) * (e_r[i] * n[j] - e_r[j] * n[i])) /
              (4 * pi * (1 - nu) * radius);
          const Long U = ((3 - 4 * nu) * -logl(radius) * same + e_r[i] * e_r[j]) / (4 * pi * (1 - nu));
          h[l][i][j] += weight * T * m * own;
          g[l][i][j] += weight * U * m * jacobian;
        }
      }
    }
  }

  Long distance(Long t) const {
    Long r[2];
    for (int i = 0; i < 2; ++i) {
      r[i] = delta[i] + t * (coefficient[1][i] + t * (coefficient[2][i] + t * coefficient[3][i]));
    }
    return hypotl(r[0], r[1]);
  }

  void panel(Long a, Long b, int depth) {
    Long nearest = distance(a), arc_length = 0, previous = 0;
    for (int i = 1; i <= 4; ++i) {
      const Long t = a + (b - a) * i / 4;
      nearest = fminl(nearest, distance(t));
      Long step[2] = {0, 0};
      previous = a + (b - a) * (i - 1) / 4;
      for (int k = 1; k < 4; ++k) {
        for (int j = 0; j < 2; ++j) step[j] += coefficient[k][j] * (powl(t, k) - powl(previous, k));
      }
      arc_length += hypotl(step[0], step[1]);
    }
    const bool coarse = b - a > 0.26L; // the Jacobian of strongly curved elements
    if ((coarse || arc_length > nearest) && depth < 70) {
      panel(a, (a + b) / 2, depth + 1);
      panel((a + b) / 2, b, depth + 1);
      return;
    }
    for (int i = 0; i < 18; ++i) { // the nearest singularity is at least 2 half-lengths from the middle
      const GaussPoint p = test::reference_gauss_point(18, i);
      kernel_point((a + b) / 2 + (b - a) / 2 * p.x, (b - a) / 2 * p.w);
    }
  }

  // Source (sx,sy); `near` = parameter close to its nearest point; at_source: the source is that point.
  Reference(const Element& element, int order, double poisson, double near, double sx, double sy, bool at_source,
            const Element* other = nullptr, bool backwards = false)
      : e(element), functions(order), nu(poisson), origin(near), coefficient(), delta(), arc(other), reversed(backwards), h(),
        g(), scale_h(0), scale_g(0) {
    const Long source[2] = {sx, sy};
    for (int i = 0; i < 2; ++i) {
      Long c[4] = {0, 0, 0, 0};
      const int end = near > 0 ? e.nodes - 1 : 0; // measured from an end, exact there
      const double* node = i == 0 ? e.x : e.y;
      for (int l = 0; l < e.nodes; ++l) {
        const double* s = shape_coefficients(e.nodes, l);
        for (int k = 0; k < e.nodes; ++k) c[k] += static_cast<Long>(s[k]) * (static_cast<Long>(node[l]) - node[end]);
      }
      const Long o = origin, u = near > 0 ? 1 : -1;
      Long at = 0; // x(origin) - x(end) = sum c_k (o^k - u^k)
      for (int k = 1; k < 4; ++k) at += c[k] * (powl(o, k) - powl(u, k));
      delta[i] = at_source ? 0 : (static_cast<Long>(node[end]) - source[i]) + at;
      coefficient[1][i] = c[1] + o * (2 * c[2] + 3 * o * c[3]);
      coefficient[2][i] = c[2] + 3 * o * c[3];
      coefficient[3][i] = c[3];
    }
    if (1 - origin > 0) panel(0, 1 - origin, 0);
    if (1 + origin > 0) panel(-1 - origin, 0, 0);
    for (int l = 0; l < functions; ++l) {
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          scale_h = fmaxl(scale_h, fabsl(h[l][i][j]));
          scale_g = fmaxl(scale_g, fabsl(g[l][i][j]));
        }
      }
    }
  }
};

struct Errors {
  double h, g;
};

// Largest error relative to the largest entry; the own node of a singular source is compared for g only.
Errors compare(const Reference& r, const Blocks& b, int singular) {
  Errors worst = {0, 0};
  Long scale_h = 0;
  for (int l = 0; l < r.functions; ++l) {
    for (int i = 0; i < 4; ++i) {
      if (l != singular) scale_h = fmaxl(scale_h, fabsl(r.h[l][i / 2][i % 2]));
    }
  }
  for (int l = 0; l < r.functions; ++l) {
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) {
        if (l == singular) {
          CHECK(b.h[l][i][j] == 0.0);
        } else {
          worst.h = std::fmax(worst.h, static_cast<double>(fabsl(b.h[l][i][j] - r.h[l][i][j]) / scale_h));
        }
        worst.g = std::fmax(worst.g, static_cast<double>(fabsl(b.g[l][i][j] - r.g[l][i][j]) / r.scale_g));
      }
    }
  }
  return worst;
}

std::vector<Element> straight_elements() {
  const double x2[] = {0.3, 1.7}, y2[] = {-0.2, 0.9};
  const double x3[] = {-1.0, 0.0, 1.0}, y3[] = {0.5, 0.25, 0.0};
  const double x4[] = {2.0, 2.0, 2.0, 2.0}, y4[] = {3.0, 2.5, 2.0, 1.5};
  return {make_element(2, x2, y2), make_element(3, x3, y3), make_element(4, x4, y4)};
}

Element circular_arc(int nodes, double radius, double from, double to) {
  double x[4], y[4];
  for (int i = 0; i < nodes; ++i) {
    const double angle = from + (to - from) * i / (nodes - 1);
    x[i] = radius * std::cos(angle);
    y[i] = radius * std::sin(angle);
  }
  return make_element(nodes, x, y);
}

std::vector<Element> curved_elements() {
  const double x3[] = {0.0, 0.4, 1.0}, y3[] = {0.0, 0.0, 0.0};              // straight line, uneven nodes
  const double x4[] = {0.0, 0.3, 0.7, 1.0}, y4[] = {0.0, 0.12, -0.1, 0.05}; // an S
  return {circular_arc(3, 2.0, 0.1, 0.4), circular_arc(3, 1.0, 0.0, kPi / 2),
          circular_arc(4, 1.5, 1.0, 1.9), circular_arc(4, 1.0, 0.0, kPi),
          make_element(3, x3, y3),        make_element(4, x4, y4)};
}

// Sources around an element: from parameter eta, `distance` element lengths away under `angle` to the
// tangent.
struct Place {
  double x, y;
};

Place place(const Element& e, double eta, double distance, double angle) {
  const Point p = element_point(e, eta);
  double px = p.x, py = p.y;
  if (eta == -1.0) px = e.x[0], py = e.y[0];
  if (eta == 1.0) px = e.x[e.nodes - 1], py = e.y[e.nodes - 1];
  const double length = 2 * e.half_length, tx = p.dx / p.jacobian, ty = p.dy / p.jacobian;
  return {px + distance * length * (std::cos(angle) * tx - std::sin(angle) * ty),
          py + distance * length * (std::cos(angle) * ty + std::sin(angle) * tx)};
}

constexpr double kDistances[] = {1e-9, 1e-6, 1e-3, 0.03, 0.2, 0.6, 1.2, 1.6, 2.0, 3.1, 5.5, 20, 300, 1e4, 1e6};

void check_place(const Integrator& in, double nu, double eta, const Place& s, double limit) {
  const Reference r(in.element, in.functions, nu, eta, s.x, s.y, false);
  Blocks b;
  integrate(in, s.x, s.y, -1, true, true, b);
  const Errors error = compare(r, b, -1);
  CAPTURE(in.functions);
  CAPTURE(eta);
  CAPTURE(s.x);
  CAPTURE(s.y);
  CHECK(error.h <= limit);
  CHECK(error.g <= limit);
}

// Sources at both ends and beside the element, at all distances, directions changing from one to the next.
void check_around(const Element& e, double nu, double limit) {
  int turn = 0;
  for (int functions = 1; functions <= 4; ++functions) {
    Integrator in;
    prepare(in, e, functions, nu, Quadrature::accurate);
    for (const double distance : kDistances) {
      for (const double eta : {-1.0, 1.0}) {
        for (int side = turn % test::effort(2, 1); side < 4; side += test::effort(2, 1)) {
          // Outwards and sideways: the end is the nearest point.
          const double angle = (eta > 0 ? 0.0 : kPi) + (side - 1.5) * 1.0 + 0.01 * (turn++ % 20);
          check_place(in, nu, eta, place(e, eta, distance, angle), limit);
        }
      }
      for (const double eta : {-0.999, 0.999999, 0.37}) {
        ++turn;
        const double angle = (turn % 2 == 0 ? 1 : -1) * (0.5 * kPi + 0.02 * (turn % 7));
        check_place(in, nu, eta, place(e, eta, distance, angle), limit);
      }
    }
  }
}

} // namespace

TEST_CASE("straight elements: blocks at all distances and directions against graded integration") {
  for (const Element& e : straight_elements()) {
    REQUIRE(e.straight);
    check_around(e, 0.3, 1e-12);
  }
  check_around(straight_elements()[0], 0.5, 1e-12);
  check_around(straight_elements()[0], -0.9, 1e-12);
}

TEST_CASE("curved elements: blocks at all distances and directions against graded integration") {
  for (const Element& e : curved_elements()) {
    REQUIRE(!e.straight);
    check_around(e, 0.3, 1e-12);
  }
  check_around(curved_elements()[0], 0.5, 1e-12);
}

TEST_CASE("curved elements: sources so close that what is integrated has to begin at the nearest point") {
  for (const Element& e : curved_elements()) {
    Integrator in;
    prepare(in, e, 3, 0.3, Quadrature::accurate);
    for (const double distance : {1e-9, 1e-6})
      for (const double side : {-0.5 * kPi, 0.5 * kPi})
        for (const double eta : {-0.61, 0.37}) check_place(in, 0.3, eta, place(e, eta, distance, side), 1e-12);
  }
}

// The search for the nearest point goes by the zeros of the curve's complex polynomial; seen from there, its first step ends
// where the polynomial's slope is none.
TEST_CASE("curved elements: a source at the centre of curvature of a parabola") {
  const double x[] = {-1.0, 0.0, 1.0}, y[] = {0.0, 1.0, 0.0};
  for (int functions = 1; functions <= 4; ++functions) {
    Integrator in;
    prepare(in, make_element(3, x, y), functions, 0.3, Quadrature::accurate);
    check_place(in, 0.3, 0.0, {0.0, 0.5}, 1e-12);
  }
}

TEST_CASE("straight elements: a source on the line beyond the ends, near and far") {
  const double x[] = {0.0, 2.0}, y[] = {0.0, 0.0};
  const Element e = make_element(2, x, y);
  for (int functions = 1; functions <= 4; ++functions) {
    Integrator in;
    prepare(in, e, functions, 0.25, Quadrature::accurate);
    for (const double distance : {1e-12, 1e-9, 1e-3, 0.5, 1.0, 2.0, 10.0, 1e4, 1e6}) {
      check_place(in, 0.25, 1.0, {2.0 + distance, 0.0}, 1e-12);
      check_place(in, 0.25, -1.0, {-distance, 0.0}, 1e-12);
      check_place(in, 0.25, -1.0, {-distance, 1e-7 * distance}, 1e-12);
    }
  }
}

TEST_CASE("the angle under which a line is seen jumps by the full turn across it") {
  const double x[] = {-1.0, 1.0}, y[] = {0.0, 0.0};
  const Element e = make_element(2, x, y);
  Integrator in;
  prepare(in, e, 1, 0.3, Quadrature::accurate);
  Blocks above, below;
  integrate(in, 0.2, 1e-14, -1, true, false, above);
  integrate(in, 0.2, -1e-14, -1, true, false, below);
  // Material lies on the left, above: inside T integrates to -1/2 on the flat piece, outside to +1/2.
  CHECK(std::fabs(above.h[0][0][0] + 0.5) < 1e-13);
  CHECK(std::fabs(below.h[0][0][0] - 0.5) < 1e-13);
}

TEST_CASE("source at a functional node: g against graded integration, h of the other nodes, own h zero") {
  std::vector<Element> elements = straight_elements();
  for (const Element& e : curved_elements()) elements.push_back(e);
  for (const Element& e : elements) {
    for (int functions = 1; functions <= 4; ++functions) {
      Integrator in;
      prepare(in, e, functions, 0.3, Quadrature::accurate);
      for (int l = 0; l < functions; ++l) {
        const double eta = node_eta(functions, l);
        const Point p = element_point(e, eta);
        const Reference r(e, functions, 0.3, eta, p.x, p.y, true);
        Blocks b;
        integrate(in, p.x, p.y, l, true, true, b);
        // The reference stops 2^-70 from the source, where h of other nodes is bounded and g integrable.
        const Errors error = functions > 1 ? compare(r, b, l) : Errors{0.0, compare(r, b, l).g};
        CAPTURE(functions);
        CAPTURE(l);
        CHECK(error.h <= 1e-12);
        CHECK(error.g <= 1e-12);
      }
    }
  }
}

TEST_CASE("halves can be asked for separately and give the same numbers") {
  for (const Element& e : {straight_elements()[0], curved_elements()[1]}) {
    for (const Quadrature mode : {Quadrature::accurate, Quadrature::thesis}) {
      Integrator in;
      prepare(in, e, 3, 0.3, mode);
      for (const double sx : {0.5, 1.2, 30.0}) {
        Blocks both, h, g;
        integrate(in, sx, 0.4, -1, true, true, both);
        integrate(in, sx, 0.4, -1, true, false, h);
        integrate(in, sx, 0.4, -1, false, true, g);
        for (int l = 0; l < 3; ++l) {
          for (int i = 0; i < 4; ++i) {
            // Panels of h alone may be longer, so the two may differ by the error allowed.
            CHECK(std::fabs(h.h[l][i / 2][i % 2] - both.h[l][i / 2][i % 2]) < 1e-13);
            CHECK(std::fabs(g.g[l][i / 2][i % 2] - both.g[l][i / 2][i % 2]) < 1e-13);
          }
        }
      }
    }
  }
}

TEST_CASE("points of the rules kept from one source to the next give every source the same numbers, to the last bit") {
  std::vector<Element> elements = curved_elements();
  const double x[] = {0.1, 0.45, 0.9}, y[] = {0.2, 0.15, 0.3}; // J along it varies
  elements.push_back(make_element(3, x, y));
  for (const Element& e : elements)
    for (int functions = 1; functions <= 4; ++functions) {
      Integrator in;
      prepare(in, e, functions, 0.3, Quadrature::accurate);
      Samples samples;
      for (int k = 0; k < 60; ++k) { // from the neighbourhood of the element to far away, and back on the other side
        const double away = 0.03 * std::pow(1.2, k < 30 ? k : 60 - k), sign = k < 30 ? 1 : -1;
        const double sx = e.c[0][0] + sign * away * std::cos(1.0 + k), sy = e.c[0][1] + sign * away * std::sin(1.0 + k);
        Blocks once = {}, kept = {};
        integrate(in, sx, sy, -1, true, true, once);
        integrate(in, sx, sy, -1, true, true, kept, &samples);
        CHECK(std::memcmp(&once, &kept, sizeof once) == 0);
      }
      for (int at = 0; at < functions; ++at) {
        const Point own = element_point(e, node_eta(functions, at));
        Blocks once = {}, kept = {};
        integrate(in, own.x, own.y, at, true, true, once);
        integrate(in, own.x, own.y, at, true, true, kept, &samples);
        CHECK(std::memcmp(&once, &kept, sizeof once) == 0);
      }
    }
}

namespace {

std::vector<Element> polygon() {
  const double x[] = {0.0, 2.0, 2.5, 1.0, 0.2}, y[] = {0.0, -0.3, 1.0, 1.8, 1.1};
  std::vector<Element> all;
  for (int i = 0; i < 5; ++i) {
    const double ex[] = {x[i], x[(i + 1) % 5]}, ey[] = {y[i], y[(i + 1) % 5]};
    all.push_back(make_element(2, ex, ey));
  }
  return all;
}

std::vector<Element> disc() {
  std::vector<Element> all;
  for (int i = 0; i < 6; ++i) all.push_back(circular_arc(3, 1.0, i * kPi / 3, (i + 1) * kPi / 3));
  return all;
}

} // namespace

TEST_CASE("tractions of a unit translation integrate to minus identity inside, zero outside") {
  for (const std::vector<Element>& body : {polygon(), disc()}) {
    struct Case {
      double x, y, expected;
    };
    const double in_x = body[1].x[0] * 0.5 + 0.1, in_y = body[1].y[0] * 0.5 + 0.2;
    // The last is 1e-7 inside the boundary of either body.
    const Point p = element_point(body[1], 0.3);
    for (const Case& c : {Case{in_x, in_y, -1.0}, Case{5.0, 1.0, 0.0}, Case{-300.0, 20.0, 0.0},
                          Case{p.x - 1e-7 * p.nx, p.y - 1e-7 * p.ny, -1.0}, Case{p.x + 1e-7 * p.nx, p.y + 1e-7 * p.ny, 0.0}}) {
      double sum[2][2] = {{0, 0}, {0, 0}}, quick[2][2] = {{0, 0}, {0, 0}};
      for (const Element& e : body) {
        Integrator in;
        prepare(in, e, 3, 0.3, Quadrature::accurate);
        Blocks b;
        double s[2][2];
        integrate(in, c.x, c.y, -1, true, false, b);
        rigid_sum(in, c.x, c.y, -1, s);
        for (int i = 0; i < 2; ++i) {
          for (int j = 0; j < 2; ++j) {
            double total = 0;
            for (int l = 0; l < 3; ++l) total += b.h[l][i][j];
            CHECK(std::fabs(total - s[i][j]) < 1e-12);
            sum[i][j] += total;
            quick[i][j] += s[i][j];
          }
        }
      }
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          CHECK(std::fabs(sum[i][j] - (i == j ? c.expected : 0.0)) < 1e-12);
          CHECK(std::fabs(quick[i][j] - (i == j ? c.expected : 0.0)) < 1e-12);
        }
      }
    }
  }
}

TEST_CASE("rigid_sum at an own node adds the other nodes' h, in both modes") {
  for (const Element& e : {straight_elements()[1], curved_elements()[0]}) {
    for (const Quadrature mode : {Quadrature::accurate, Quadrature::thesis}) {
      for (int functions = 1; functions <= 4; ++functions) {
        Integrator in;
        prepare(in, e, functions, 0.3, mode);
        for (int l = 0; l < functions; ++l) {
          const Point p = element_point(e, node_eta(functions, l));
          Blocks b;
          double s[2][2];
          integrate(in, p.x, p.y, l, true, false, b);
          rigid_sum(in, p.x, p.y, l, s);
          for (int i = 0; i < 4; ++i) {
            double total = 0;
            for (int m = 0; m < functions; ++m) total += b.h[m][i / 2][i % 2];
            CHECK(std::fabs(total - s[i / 2][i % 2]) < 1e-14);
          }
        }
      }
    }
  }
}

TEST_CASE("rotation and uniform strain of a body without the tractions' help: Somigliana's identity") {
  // u = linear field; c u(P) + int T u = int U t / (2G) on a closed polygon, linear elements exact for it.
  const double nu = 0.3, lambda = 2.0 * nu / (1.0 - 2.0 * nu) * 0.5; // lambda/2G
  for (const bool rotation : {true, false}) {
    const double a[2][2] = {{rotation ? 0.0 : 0.7, rotation ? -1.0 : 0.2}, {rotation ? 1.0 : 0.5, rotation ? 0.0 : -0.4}};
    const double trace = a[0][0] + a[1][1];
    double stress[2][2]; // over 2G
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) stress[i][j] = 0.5 * (a[i][j] + a[j][i]) + (i == j ? lambda * trace : 0.0);
    }
    const double px = 1.1, py = 0.7;
    double left[2] = {0, 0}, size = 0;
    for (const Element& e : polygon()) {
      Integrator in;
      prepare(in, e, 2, nu, Quadrature::accurate);
      Blocks b;
      integrate(in, px, py, -1, true, true, b);
      const Point p = element_point(e, 0.0);
      for (int l = 0; l < 2; ++l) {
        for (int i = 0; i < 2; ++i) {
          for (int j = 0; j < 2; ++j) {
            const double u = a[j][0] * e.x[l] + a[j][1] * e.y[l], t = stress[j][0] * p.nx + stress[j][1] * p.ny;
            left[i] += b.h[l][i][j] * u - b.g[l][i][j] * t;
            size += std::fabs(b.h[l][i][j] * u);
          }
        }
      }
    }
    for (int i = 0; i < 2; ++i) CHECK(std::fabs(left[i] + a[i][0] * px + a[i][1] * py) < 1e-14 * size);
  }
}

TEST_CASE("blocks turn, reflect and scale with the geometry") {
  std::vector<Element> elements = {straight_elements()[0], curved_elements()[5]};
  for (const Element& e : elements) {
    for (const double distance : {1e-3, 0.4, 2.0, 50.0}) {
      const Place s = place(e, 0.37, distance, 1.3);
      const double c = std::cos(0.7), d = std::sin(0.7), factor = 3.7;
      double x[4], y[4], mx[4], my[4];
      for (int i = 0; i < e.nodes; ++i) {
        x[i] = factor * (c * e.x[i] - d * e.y[i]);
        y[i] = factor * (d * e.x[i] + c * e.y[i]);
        mx[i] = -e.x[e.nodes - 1 - i]; // mirrored, and run backwards to keep the material on the left
        my[i] = e.y[e.nodes - 1 - i];
      }
      Integrator in, turned, mirrored;
      prepare(in, e, 3, 0.2, Quadrature::accurate);
      prepare(turned, make_element(e.nodes, x, y), 3, 0.2, Quadrature::accurate);
      prepare(mirrored, make_element(e.nodes, mx, my), 3, 0.2, Quadrature::accurate);
      Blocks b, t, m;
      integrate(in, s.x, s.y, -1, true, true, b);
      integrate(turned, factor * (c * s.x - d * s.y), factor * (d * s.x + c * s.y), -1, true, true, t);
      integrate(mirrored, -s.x, s.y, -1, true, true, m);
      const double q[2][2] = {{c, -d}, {d, c}};
      // Rounding the turned coordinates moves source and element by eps times their size.
      const double tolerance = 1e-12 + 1e-15 / distance;
      for (int l = 0; l < 3; ++l) {
        double weight, w[4], wx[4], wy[4];
        resultants(in, 0.0, 0.0, w, wx, wy);
        weight = w[l];
        for (int i = 0; i < 2; ++i) {
          for (int j = 0; j < 2; ++j) {
            double h = 0, g = 0;
            for (int k = 0; k < 2; ++k) {
              for (int n = 0; n < 2; ++n) {
                h += q[i][k] * b.h[l][k][n] * q[j][n];
                g += q[i][k] * b.g[l][k][n] * q[j][n];
              }
            }
            if (i == j) g -= in.k * in.kappa * std::log(factor) * weight;
            CHECK(std::fabs(t.h[l][i][j] - h) < tolerance);
            CHECK(std::fabs(t.g[l][i][j] - factor * g) < tolerance * 10);
            const double sign = i == j ? 1.0 : -1.0;
            CHECK(std::fabs(m.h[2 - l][i][j] - sign * b.h[l][i][j]) < tolerance);
            CHECK(std::fabs(m.g[2 - l][i][j] - sign * b.g[l][i][j]) < tolerance);
          }
        }
      }
    }
  }
}

TEST_CASE("the circle about the middle of a chord holds the element, and no more of a straight one's line") {
  std::vector<Element> elements = straight_elements();
  for (const Element& e : curved_elements()) elements.push_back(e);
  for (const Element& e : elements) {
    Integrator in;
    prepare(in, e, 3, 0.3, Quadrature::accurate);
    const int last = e.nodes - 1;
    const double x = 0.5 * (e.x[0] + e.x[last]), y = 0.5 * (e.y[0] + e.y[last]);
    for (int k = -20; k <= 20; ++k) {
      const Point p = element_point(e, 0.05 * k);
      CHECK(std::hypot(p.x - x, p.y - y) <= in.radius * (1.0 + 1e-14));
    }
    if (e.straight) CHECK(in.radius <= e.half_length * (1.0 + 1e-14));
  }
}

TEST_CASE("arc mode: g and resultants per length of the other element, h untouched") {
  std::vector<Element> own = {straight_elements()[0], curved_elements()[0], curved_elements()[5]};
  std::vector<Element> other = {straight_elements()[2], circular_arc(3, 0.8, 0.0, 1.0), curved_elements()[5]};
  const double far[] = {0.0, 0.4, 0.6, 1.0}, none[] = {0.0, 0.0, 0.0, 0.0}; // of a length per parameter without linear part
  other.push_back(make_element(4, far, none));
  other.push_back(make_element(4, none, far));
  for (const Element& e : own) {
    for (const Element& arc : other) {
      for (const bool reversed : {false, true}) {
        Integrator plain, in;
        prepare(plain, e, 3, 0.3, Quadrature::accurate);
        prepare(in, e, 3, 0.3, Quadrature::accurate);
        set_arc(in, arc, reversed);
        for (const double distance : {0.0, 1e-6, 0.1, 1.0, 30.0}) {
          const int singular = distance == 0.0 ? 2 : -1;
          const double eta = singular < 0 ? 0.37 : 1.0;
          const Place s = place(e, eta, distance, 1.6);
          const Reference r(e, 3, 0.3, eta, s.x, s.y, singular >= 0, &arc, reversed);
          Blocks b, p;
          integrate(in, s.x, s.y, singular, true, true, b);
          integrate(plain, s.x, s.y, singular, true, false, p);
          const Errors error = compare(r, b, singular);
          CHECK(error.g <= 1e-12);
          CHECK(error.h <= 1e-12);
          for (int l = 0; l < 3; ++l) CHECK(std::fabs(b.h[l][0][1] - p.h[l][0][1]) < 1e-13);
        }
        double w[4], wx[4], wy[4], sum = 0, arc_length = 0;
        resultants(in, 0.0, 0.0, w, wx, wy);
        for (int l = 0; l < 3; ++l) sum += w[l];
        for (int i = 0; i < 320; ++i) { // ten panels of 32 points
          const GaussPoint p = test::reference_gauss_point(32, i % 32);
          arc_length += 0.1 * p.w * element_point(arc, -0.9 + 0.2 * (i / 32) + 0.1 * p.x).jacobian;
        }
        CHECK(std::fabs(sum - arc_length) < 1e-13);
      }
    }
  }
}

TEST_CASE("resultants: forces and first moments of every functional order") {
  std::vector<Element> elements = straight_elements();
  for (const Element& e : curved_elements()) elements.push_back(e);
  for (const Element& e : elements) {
    for (int functions = 1; functions <= 4; ++functions) {
      Integrator in;
      prepare(in, e, functions, 0.3, Quadrature::accurate);
      double w[4], wx[4], wy[4], f[4][3] = {};
      resultants(in, 0.3, -0.4, w, wx, wy);
      for (int i = 0; i < 320; ++i) {
        const GaussPoint g = test::reference_gauss_point(32, i % 32);
        const double eta = -0.9 + 0.2 * (i / 32) + 0.1 * g.x;
        const Point p = element_point(e, eta);
        double N[4];
        shape(functions, eta, N);
        for (int l = 0; l < functions; ++l) {
          f[l][0] += 0.1 * g.w * p.jacobian * N[l];
          f[l][1] += 0.1 * g.w * p.jacobian * N[l] * (p.x - 0.3);
          f[l][2] += 0.1 * g.w * p.jacobian * N[l] * (p.y + 0.4);
        }
      }
      for (int l = 0; l < functions; ++l) {
        CHECK(std::fabs(w[l] - f[l][0]) < 1e-13);
        CHECK(std::fabs(wx[l] - f[l][1]) < 1e-13);
        CHECK(std::fabs(wy[l] - f[l][2]) < 1e-13);
      }
    }
  }
}

TEST_CASE("thesis rule: 10, 4, 2 points by distance to the nodes, and the logarithmic formula at the own node") {
  const double x[] = {0.0, 1.0}, y[] = {0.0, 0.0};
  const Element e = make_element(2, x, y);
  Integrator in, exact;
  prepare(in, e, 2, 0.3, Quadrature::thesis);
  prepare(exact, e, 2, 0.3, Quadrature::accurate);
  struct Case {
    double sx;
    int points;
  };
  // Distances to the nearer node: 1.5, 1.501, 5, 5.001.
  for (const Case& c : {Case{2.5, 10}, Case{2.501, 4}, Case{6.0, 4}, Case{6.001, 2}}) {
    double g = 0; // U_11 M_2: r = (eta+1)/2 - sx
    for (int i = 0; i < c.points; ++i) {
      const GaussPoint p = gauss_point(gauss_legendre(c.points), i);
      const double r = c.sx - 0.5 * (1.0 + p.x);
      g += p.w * 0.5 * 0.5 * (1.0 + p.x) * (-(3.0 - 1.2) * std::log(r) + 1.0) / (4 * kPi * 0.7);
    }
    Blocks b;
    integrate(in, c.sx, 0.0, -1, true, true, b);
    CHECK(std::fabs(b.g[1][0][0] - g) < 1e-15);
  }
  // The logarithmic formula is exact on straight elements up to cubic functions: polynomials times
  // logarithms.
  for (int functions = 1; functions <= 4; ++functions) {
    prepare(in, e, functions, 0.3, Quadrature::thesis);
    prepare(exact, e, functions, 0.3, Quadrature::accurate);
    for (int l = 0; l < functions; ++l) {
      const double sx = 0.5 * (1.0 + node_eta(functions, l));
      Blocks b, s;
      integrate(in, sx, 0.0, l, true, true, b);
      integrate(exact, sx, 0.0, l, true, true, s);
      CHECK(std::fabs(b.g[l][0][0] - s.g[l][0][0]) < 1e-14);
      CHECK(std::fabs(b.g[l][1][1] - s.g[l][1][1]) < 1e-14);
      CHECK(b.h[l][0][1] == 0.0);
      for (int m = 0; m < functions; ++m) CHECK(std::fabs(b.h[m][0][1] - s.h[m][0][1]) < 1e-14);
      // Ten points on a logarithm that is not split off: some 1e-3 of the node next door, and not less.
      for (int m = 0; m < functions; ++m) CHECK(std::fabs(b.g[m][0][0] - s.g[m][0][0]) < 2e-3);
    }
  }
  // Curved geometry of another order than the functions: errata, item 4. 10 points on a mild arc see g to
  // 1e-6.
  const Element arc = circular_arc(3, 2.0, 0.1, 0.5);
  for (const int functions : {1, 2, 4}) {
    prepare(in, arc, functions, 0.3, Quadrature::thesis);
    prepare(exact, arc, functions, 0.3, Quadrature::accurate);
    for (int l = 0; l < functions; ++l) {
      const Point p = element_point(arc, node_eta(functions, l));
      Blocks b, s;
      integrate(in, p.x, p.y, l, false, true, b);
      integrate(exact, p.x, p.y, l, false, true, s);
      for (int i = 0; i < 4; ++i) CHECK(std::fabs(b.g[l][i / 2][i % 2] - s.g[l][i / 2][i % 2]) < 1e-9);
    }
  }
}

TEST_CASE("thesis rule: a source on a point of the rule gets what the other points give") {
  const double x[] = {-1.0, 1.0}, y[] = {0.0, 0.0};
  Integrator in;
  prepare(in, make_element(2, x, y), 1, 0.3, Quadrature::thesis);
  const GaussRule rule = gauss_legendre(10);
  for (int k = 0; k < 10; ++k) {
    const double at = gauss_point(rule, k).x;
    double g = 0;
    for (int i = 0; i < 10; ++i) {
      const GaussPoint p = gauss_point(rule, i);
      if (i != k) g += p.w * (-(3.0 - 1.2) * std::log(std::fabs(p.x - at)) + 1.0) / (4 * kPi * 0.7);
    }
    Blocks b;
    integrate(in, at, 0.0, -1, true, true, b);
    CHECK(std::fabs(b.g[0][0][0] - g) < 1e-14);
    CHECK(b.h[0][0][0] == 0.0);
  }
}

// Where inner nodes stand changes the parameter, and nothing else: constant functions do not see it.
TEST_CASE("straight elements whose nodes are not evenly spaced are still straight lines") {
  struct Spaced {
    int nodes;
    double at[4]; // from 0 to 1
    double tolerance;
  };
  const Spaced all[] = {{3, {0, 0.4, 1}, 1e-13},
                        {4, {0, 0.3, 0.7, 1}, 1e-13},
                        {4, {0, 0.4, 0.6, 1}, 1e-13},
                        {3, {0, 0.25 + 2e-8, 1}, 1e-9}}; // the last hardly moves at its beginning
  const double ends[3][2] = {{2, 0}, {0, 2}, {1.2, 1.6}};
  for (const Spaced& s : all)
    for (const double(&end)[2] : ends) {
      double x[4], y[4], x2[2] = {0.5, 0.5 + end[0]}, y2[2] = {0.25, 0.25 + end[1]};
      for (int k = 0; k < s.nodes; ++k) x[k] = 0.5 + s.at[k] * end[0], y[k] = 0.25 + s.at[k] * end[1];
      Integrator own, even;
      prepare(own, make_element(s.nodes, x, y), 1, 0.3, Quadrature::accurate);
      prepare(even, make_element(2, x2, y2), 1, 0.3, Quadrature::accurate);
      for (int way = 0; way < 2; ++way)
        for (const double size : {-5.0, -1.0, -0.1, -1e-3, 1e-3, 0.3}) {
          const double *off = ends[way], sx = 0.5 + size * off[0] - 0.0007 * end[1],
                       sy = 0.25 + size * off[1] + 0.0007 * end[0];
          Blocks b, exact;
          integrate(own, sx, sy, -1, true, true, b);
          integrate(even, sx, sy, -1, true, true, exact);
          CAPTURE(size);
          for (int i = 0; i < 4; ++i) {
            CHECK(std::fabs(b.g[0][i / 2][i % 2] - exact.g[0][i / 2][i % 2]) < s.tolerance);
            CHECK(std::fabs(b.h[0][i / 2][i % 2] - exact.h[0][i / 2][i % 2]) < s.tolerance);
          }
        }
    }
}

// One cubic element is the whole boundary; it ends where it begins.
TEST_CASE("a loop of one element: minus identity inside, zero outside") {
  const double x[] = {0, 1, -1, 0}, y[] = {0, 1, 1, 0};
  Integrator in;
  prepare(in, make_element(4, x, y), 2, 0.3, Quadrature::accurate);
  REQUIRE(in.chord2 == 0.0);
  for (const bool inside : {true, false}) {
    double sum[2][2];
    rigid_sum(in, inside ? 0.1 : 0.3, inside ? 0.6 : 3.0, -1, sum);
    for (int i = 0; i < 4; ++i) CHECK(std::fabs(sum[i / 2][i % 2] - (inside && i % 3 == 0 ? -1.0 : 0.0)) < 1e-10);
  }
}

TEST_CASE("double nodes: zero length gives zero blocks; sources on ends stay finite; nothing traps") {
  const double x[] = {1.0, 1.0}, y[] = {2.0, 2.0};
  std::feclearexcept(FE_ALL_EXCEPT);
  for (const Quadrature mode : {Quadrature::accurate, Quadrature::thesis}) {
    Integrator in;
    prepare(in, make_element(2, x, y), 2, 0.3, mode);
    for (const int singular : {-1, 0, 1}) {
      Blocks b;
      for (int l = 0; l < 2; ++l)
        for (int i = 0; i < 4; ++i) b.g[l][i / 2][i % 2] = b.h[l][i / 2][i % 2] = 7.0; // of another element
      double sum[2][2], w[4], wx[4], wy[4];
      integrate(in, 1.0, 2.0, singular, true, true, b);
      rigid_sum(in, 1.0, 2.0, singular, sum);
      resultants(in, 0.0, 0.0, w, wx, wy);
      for (int l = 0; l < 2; ++l) {
        for (int i = 0; i < 4; ++i) CHECK((b.g[l][i / 2][i % 2] == 0.0 && b.h[l][i / 2][i % 2] == 0.0));
        CHECK(w[l] == 0.0);
      }
      CHECK(sum[0][1] == 0.0);
      integrate(in, 1.0, 2.0, singular, false, true, b);
      for (int i = 0; i < 4; ++i) CHECK(b.g[1][i / 2][i % 2] == 0.0);
    }
    // The point nearest to any other is where it stands, and nothing acts from there.
    CHECK(std::fabs(nearest_point(in.element, 4.0, 6.0).distance - 5.0) < 1e-15);
    FieldElement field;
    field.in = in;
    const Complex t[kElementNodes] = {{1, 2}, {3, 4}};
    prepare_field(t, t, field);
    PointField f = {};
    add_field(field, {0, 0}, 1.5, 2.0, f);
    CHECK((f.u.re == 0.0 && f.u.im == 0.0 && f.trace == 0.0));
    std::vector<Element> elements = straight_elements();
    for (const Element& e : curved_elements()) elements.push_back(e);
    for (const Element& e : elements) {
      for (int functions = 1; functions <= 4; ++functions) {
        prepare(in, e, functions, 0.5, mode);
        for (const double distance : {0.0, 1e-300, 1e-100, 1e-15, 1.0, 1e10, 1e40}) {
          const Place s = place(e, 1.0, distance, 0.0);
          for (const int singular : {-1, functions - 1}) {
            Blocks b;
            integrate(in, s.x, s.y, singular, true, true, b);
            CHECK(std::isfinite(b.h[0][0][0]));
            CHECK(std::isfinite(b.g[0][0][0]));
          }
        }
      }
    }
  }
  CHECK(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
}

namespace {

// Zeros of c[0] + c[1] z + c[2] z^2 + c[3] z^3, all at once (Weierstrass).
std::vector<std::complex<double>> zeros_of_cubic(const std::complex<double> (&c)[4]) {
  std::vector<std::complex<double>> z = {{1.0, 0.0}, {0.4, 0.9}, {-0.65, 0.72}};
  for (int turn = 0; turn < 200; ++turn)
    for (size_t i = 0; i < 3; ++i) {
      const std::complex<double> value = c[0] + z[i] * (c[1] + z[i] * (c[2] + z[i] * c[3]));
      z[i] -= value / (c[3] * (z[i] - z[(i + 1) % 3]) * (z[i] - z[(i + 2) % 3]));
    }
  return z;
}

} // namespace

TEST_CASE("panels: where the rule is said to do, no complex zero of the distance lies in the disc about their ellipse") {
  uint64_t state = 7;
  const auto random = [&](double from, double to) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return from + (to - from) * static_cast<double>(state >> 11) * 0x1p-53;
  };
  int resolved_panels = 0, others = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const double x[] = {-1, random(-0.8, 0.4), random(-0.4, 0.8), 1}, y[] = {0, random(-1, 1), random(-1, 1), random(-1, 1)};
    Integrator in;
    prepare(in, make_element(4, x, y), 2, 0.3, Quadrature::accurate);
    const double sx = random(-3, 3), sy = random(-3, 3), origin = random(-1, 1);
    const Expansion seen = expand(in, origin, sx, sy, false);
    Stretch panel = {random(0, 1), 0, random(-1, 1) < 0 ? -1.0 : 1.0};
    panel.to = panel.from + random(0.01, 0.5);
    if (!resolved(in, seen, panel, false)) {
      ++others;
      continue;
    }
    ++resolved_panels;
    const double middle = origin + panel.sign * 0.5 * (panel.from + panel.to),
                 radius = in.semi_axis * 0.5 * (panel.to - panel.from);
    for (const double sign : {-1.0, 1.0}) { // of x - sx and y - sy as one complex number and as its conjugate
      std::complex<double> d[4], c[4] = {};
      for (int i = 0; i < 4; ++i) d[i] = {x[i] - sx, sign * (y[i] - sy)};
      for (int order = 1; order < 4; ++order) // divided differences at -1, -1/3, 1/3, 1
        for (int i = 3; i >= order; --i) d[i] = (d[i] - d[i - 1]) / (2.0 / 3.0 * order);
      for (int i = 3; i >= 0; --i) { // to powers of the parameter
        for (int k = 3; k > 0; --k) c[k] = c[k - 1] - (-1.0 + 2.0 / 3.0 * i) * c[k];
        c[0] = d[i] - (-1.0 + 2.0 / 3.0 * i) * c[0];
      }
      for (const std::complex<double>& zero : zeros_of_cubic(c)) CHECK(std::abs(zero - middle) >= radius * (1 - 1e-9));
    }
  }
  CHECK(resolved_panels > 300);
  CHECK(others > 300);
}
