// Far fields of groups of elements against the integrals over each. (Whole bodies: tests/test_compressed_solver.cpp.)
#include "bie/far_field.hpp"
#include "model/shape.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace c2d;

namespace {

const double kPi = std::acos(-1.0);

struct Drawn {
  std::mt19937 seed{5};
  double operator()(double low, double high) { return low + (high - low) * static_cast<double>(seed()) / 4294967296.0; }
};

// Elements that follow each other on a wavy line about `middle`, with densities of their own.
std::vector<FieldElement> chain_of(Drawn& draw, Complex middle, double size, int elements, int nodes, int functions, double nu,
                                   bool uniform) {
  std::vector<FieldElement> out(static_cast<size_t>(elements));
  const double phase = draw(0, 6);
  const auto at = [&](double s) { // 0 ... 1 from end to end
    return Complex{middle.re + size * (s - 0.5), middle.im + 0.2 * size * std::sin(phase + 4 * s)};
  };
  for (int i = 0; i < elements; ++i) {
    double x[kElementNodes] = {}, y[kElementNodes] = {};
    for (int k = 0; k < nodes; ++k) {
      const Complex p = at((i + k / (nodes - 1.0)) / elements);
      x[k] = p.re, y[k] = p.im;
    }
    FieldElement& e = out[static_cast<size_t>(i)];
    prepare(e.in, make_element(nodes, x, y), functions, nu, Quadrature::accurate);
    Complex t[kElementNodes] = {}, u[kElementNodes] = {};
    for (int l = 0; l < functions; ++l) {
      if (!uniform) t[l] = {draw(-1, 1), draw(-1, 1)};
      u[l] = uniform ? Complex{0.3, -0.7} : Complex{draw(-1, 1), draw(-1, 1)};
    }
    prepare_field(t, u, e);
  }
  return out;
}

struct Shares {
  PointField sum{};
  double u = 0, stress = 0; // the largest of an element
};
Shares direct(const std::vector<FieldElement>& elements, Complex reference, double x, double y) {
  Shares out;
  for (const FieldElement& e : elements) {
    PointField one{};
    add_field(e, reference, x, y, one);
    out.u = std::max({out.u, std::fabs(one.u.re), std::fabs(one.u.im)});
    out.stress = std::max({out.stress, std::fabs(one.trace), std::fabs(one.deviator.re), std::fabs(one.deviator.im)});
    add(out.sum.u, one.u);
    out.sum.trace += one.trace;
    add(out.sum.deviator, one.deviator);
  }
  return out;
}

// Of two fields, over the largest share of an element.
double apart(const Shares& a, const PointField& b) {
  const double u = std::max(std::fabs(a.sum.u.re - b.u.re), std::fabs(a.sum.u.im - b.u.im));
  const double stress = std::max({std::fabs(a.sum.trace - b.trace), std::fabs(a.sum.deviator.re - b.deviator.re),
                                  std::fabs(a.sum.deviator.im - b.deviator.im)});
  return std::max(u / a.u, stress / a.stress);
}

double radius_of(const std::vector<FieldElement>& elements, Complex middle) {
  double radius = 0;
  for (const FieldElement& e : elements)
    radius = std::max(radius, std::hypot(e.in.element.c[0][0] - middle.re, e.in.element.c[0][1] - middle.im) + e.in.radius);
  return radius;
}

FarField far_field_of(const std::vector<FieldElement>& elements, Complex middle, double radius, Complex rest) {
  FarField out{};
  out.middle = middle;
  out.radius = radius;
  for (const FieldElement& e : elements) add_to_far_field(e, rest, out);
  return out;
}

} // namespace

TEST_CASE("far field: what a group does far away is what its elements do") {
  Drawn draw;
  const Complex rest = {0.2, -0.1};
  double worst = 0;
  for (const int nodes : {2, 3, 4})
    for (int functions = 1; functions <= nodes; ++functions)
      for (const double nu : {0.0, 0.3, 0.5})
        for (const int count : {1, 5, 40}) {
          const Complex middle = {draw(-1, 1), draw(-1, 1)};
          const std::vector<FieldElement> elements = chain_of(draw, middle, 0.1, count, nodes, functions, nu, false);
          const double radius = radius_of(elements, middle), k = elements[0].in.k, kappa = elements[0].in.kappa;
          const FarField group = far_field_of(elements, middle, radius, rest);
          for (const double away : {kFarDistance, 3.5, 10.0, 1e3}) {
            const double angle = draw(0, 2 * kPi), x = middle.re + away * radius * std::cos(angle),
                         y = middle.im + away * radius * std::sin(angle);
            PointField sum{};
            add_far_field(group, k, kappa, x, y, sum);
            CAPTURE(nodes);
            CAPTURE(functions);
            CAPTURE(count);
            CAPTURE(away);
            worst = std::max(worst, apart(direct(elements, rest, x, y), sum));
          }
        }
  CHECK(worst > 0);
  CHECK(worst < 1e-10);
}

TEST_CASE("far field: groups of groups, over many depths") {
  Drawn draw;
  const double nu = 0.3;
  std::vector<FieldElement> all;
  FarField group{};
  Complex low = {0, 0};
  double radius = 0;
  for (int depth = 0; depth < 8; ++depth) { // each as large as all before it
    const double size = depth == 0 ? 1e-3 : 2 * radius;
    const Complex middle = {low.re + radius + size / 2, low.im + 0.1 * radius};
    const std::vector<FieldElement> next = chain_of(draw, middle, size, 6, 3, 2, nu, false);
    const double own = radius_of(next, middle);
    const FarField part = far_field_of(next, middle, own, Complex{0, 0});
    const Complex centre = {(low.re - radius + middle.re + own) / 2, (low.im + middle.im) / 2};
    FarField both{};
    both.middle = centre;
    both.radius = std::max(depth == 0 ? 0.0 : std::hypot(low.re - centre.re, low.im - centre.im) + radius,
                           std::hypot(middle.re - centre.re, middle.im - centre.im) + own);
    if (depth > 0) add_to_far_field(group, 3 - 4 * nu, both);
    add_to_far_field(part, 3 - 4 * nu, both);
    all.insert(all.end(), next.begin(), next.end());
    group = both;
    low = centre;
    radius = both.radius;
  }
  for (const double away : {kFarDistance, 4.0, 30.0})
    for (int i = 0; i < 8; ++i) {
      const double angle = i * kPi / 4 + 0.1, x = low.re + away * radius * std::cos(angle),
                   y = low.im + away * radius * std::sin(angle);
      PointField sum{};
      add_far_field(group, all[0].in.k, all[0].in.kappa, x, y, sum);
      CHECK(apart(direct(all, Complex{0, 0}, x, y), sum) < 1e-10);
    }
  // nothing changes nothing, nor does an element of no length
  FarField same = group;
  add_to_far_field(FarField{}, 3 - 4 * nu, same);
  FieldElement none = all[0];
  const double at[2] = {low.re, low.re}, height[2] = {low.im, low.im};
  prepare(none.in, make_element(2, at, height), 2, nu, Quadrature::accurate);
  const Complex values[kElementNodes] = {{1, 2}, {3, 4}};
  prepare_field(values, values, none);
  add_to_far_field(none, Complex{0, 0}, same);
  CHECK(same.f[0].re == group.f[0].re);
  CHECK(same.x[kFarTerms - 1].im == group.x[kFarTerms - 1].im);
}

TEST_CASE("far field: a uniform displacement of a chain is told by its ends") {
  Drawn draw;
  for (const int nodes : {2, 3})
    for (const double nu : {0.0, 0.3, 0.5}) {
      const std::vector<FieldElement> elements = chain_of(draw, Complex{0.1, 0.2}, 0.5, 12, nodes, 2, nu, true);
      const Element &first = elements.front().in.element, &last = elements.back().in.element;
      const Chain chain = {{first.x[0], first.y[0]}, {last.x[last.nodes - 1], last.y[last.nodes - 1]}};
      for (int i = 0; i < 12; ++i) {
        const double angle = 0.52 * i, x = 0.1 + 0.6 * std::cos(angle), y = 0.2 + 0.6 * std::sin(angle);
        PointField sum{};
        add_uniform_chain(chain, Complex{0.3, -0.7}, elements[0].in.k, elements[0].in.kappa, x, y, sum);
        CHECK(apart(direct(elements, Complex{0, 0}, x, y), sum) < 1e-11);
      }
    }
}
