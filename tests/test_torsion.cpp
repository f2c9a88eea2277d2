// Torsion of bodies of revolution: kernels against quadrature in space, bars and planes of symmetry, the path of stick and slip
// against models of springs.
#include "dice.hpp"

#include "post/torsion/twist_kernels.hpp"
#include "post/torsion/twist_system.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

using random_decks::Dice;

namespace {

const double kPi = std::acos(-1.0);

struct Straight : app::TwistCurve {
  app::Point a, b;
  Straight(app::Point from, app::Point to) : a(from), b(to) {}
  double length() const { return app::distance(a, b); }
  Local local(double s) const override {
    const app::Point along = (1 / length()) * (b - a);
    return {a + s * along, along, 0};
  }
  bool is_straight() const override { return true; }
};

// A body with straight sides, each in equal elements.
struct Polygon {
  std::vector<std::unique_ptr<Straight>> sides;
  app::TwistModel model;
  size_t per_side;
  Polygon(size_t order, size_t elements, const std::vector<app::Point>& corners) : per_side(elements) {
    app::TwistBody body;
    body.order = order;
    for (size_t i = 0; i + 1 < corners.size(); ++i) {
      sides.push_back(std::make_unique<Straight>(corners[i], corners[i + 1]));
      for (size_t k = 0; k < elements; ++k) {
        app::TwistElement e;
        e.curve = sides.back().get();
        e.from = sides.back()->length() * static_cast<double>(k) / static_cast<double>(elements);
        e.to = sides.back()->length() * static_cast<double>(k + 1) / static_cast<double>(elements);
        for (size_t n = 0; n <= order; ++n) e.node[n] = body.nodes + n;
        body.nodes += order;
        body.elements.push_back(e);
      }
    }
    ++body.nodes;
    model.rigid.push_back(0);
    model.angle.emplace_back(body.nodes);
    model.ends.emplace_back(body.elements.size() * (order + 1));
    model.bodies.push_back(body);
  }
  void hold(size_t side, double angle) {
    each(side, [&](size_t end, size_t node, const app::Point&) {
      model.ends[0][end].kind = app::TwistEnd::kHeld;
      model.angle[0][node] = {angle};
    });
  }
  template <class Visit> void each(size_t side, const Visit& visit) {
    const size_t local = model.bodies[0].order + 1;
    for (size_t e = side * per_side; e < (side + 1) * per_side; ++e)
      for (size_t i = 0; i < local; ++i) {
        const app::TwistElement& element = model.bodies[0].elements[e];
        visit(e * local + i, element.node[i],
              element.at(-1 + 2.0 * static_cast<double>(i) / static_cast<double>(local - 1)).at);
      }
  }
  double torque(const app::TwistSystem& system, const app::TwistField& field, size_t side) {
    double sum = 0;
    each(side, [&](size_t end, size_t, const app::Point&) { sum += system.equations(0).torque[end] * field.traction[0][end]; });
    return sum;
  }
};

app::TwistField solve(const app::TwistSystem& system) {
  app::SlipState state;
  state.factors = {1};
  return system.field(state);
}

} // namespace

TEST_CASE("torsion: kernels against quadrature round the axis") {
  const double places[][3] = {{1, 0.5, 0.3},  {1, 0.01, -0.02}, {2, -1.7, 0.1}, {0, 0.8, 0.3},
                              {1e-9, 1, 0.5}, {3, 0.1, 9},      {1, 1.2, 0.6}};
  for (const double* p : places) {
    const double radius = p[0], r = radius + p[1], z = p[2], n[2] = {0.6, -0.8};
    const int count = 40000;
    double u = 0, t = 0; // both over R, by the kernels of space after partial integration
    for (int k = 0; k < count; ++k) {
      const double f = 2 * kPi * (k + 0.5) / count, rho2 = r * r + radius * radius - 2 * r * radius * std::cos(f) + z * z;
      const double rho = std::sqrt(rho2), sine = std::sin(f), dn = n[0] * (r - radius * std::cos(f)) + n[1] * z;
      u += r * r * sine * sine / (rho2 * rho), t -= 3 * r * r * r * sine * sine * dn / (rho2 * rho2 * rho);
    }
    const double step = 2 * kPi / count / (4 * kPi);
    const app::TwistKernels k = app::twist_kernels(radius, p[1], z, n);
    CHECK(k.u == doctest::Approx(u * step).epsilon(1e-11));
    CHECK(k.t == doctest::Approx(t * step).epsilon(1e-11));
  }
  // The identity of Green itself: the kernel is int cos f/rho df, with the measure r, over 4 pi R.
  const double radius = 0.7, r = 1.1, z = 0.4, n[2] = {1, 0};
  double sum = 0;
  for (int k = 0; k < 4000; ++k) {
    const double f = 2 * kPi * k / 4000;
    sum += std::cos(f) / std::sqrt(r * r + radius * radius - 2 * r * radius * std::cos(f) + z * z);
  }
  CHECK(app::twist_kernels(radius, r - radius, z, n).u ==
        doctest::Approx(sum * 2 * kPi / 4000 * r / (4 * kPi * radius)).epsilon(1e-11));
}

TEST_CASE("torsion: bars and tubes of every order") {
  for (const size_t order : {size_t{1}, size_t{2}, size_t{3}})
    for (const double inner : {0.0, 0.4}) {
      std::vector<app::Point> corners = {{inner, 0}, {1, 0}, {1, 2}, {inner, 2}};
      if (inner > 0) corners.push_back({inner, 0});
      Polygon bar(order, 3, corners);
      if (inner > 0) { // a closed outline
        app::TwistBody& body = bar.model.bodies[0];
        body.elements.back().node[order] = 0, --body.nodes, bar.model.angle[0].pop_back();
      }
      bar.model.bodies[0].modulus = 3;
      bar.hold(0, 0), bar.hold(2, 0.01);
      const app::TwistSystem system(bar.model);
      REQUIRE(!system.is_singular());
      const app::TwistField field = solve(system);
      const double torque = 3 * kPi / 2 * (1 - std::pow(inner, 4)) * 0.01 / 2;
      CHECK(bar.torque(system, field, 2) == doctest::Approx(torque).epsilon(1e-10));
      CHECK(bar.torque(system, field, 0) + bar.torque(system, field, 2) == doctest::Approx(0).epsilon(1e-13 * torque));
      bar.each(
          1, [&](size_t, size_t node, const app::Point& at) { CHECK(std::fabs(field.angle[0][node] - 0.005 * at.y) < 1e-12); });
      bar.each(2, [&](size_t end, size_t, const app::Point& at) {
        CHECK(std::fabs(field.traction[0][end] - 0.015 * at.x) < 1e-10);
      });
    }
}

TEST_CASE("torsion: half a body with a plane of symmetry is the whole body") {
  Polygon whole(2, 4, {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}}), half(2, 4, {{1, 0}, {1, 1}, {0, 1}});
  half.model.bodies[0].mirror = 0.0;
  half.hold(1, 0), whole.hold(0, 0), whole.hold(3, 0);
  const auto load = [](Polygon& body, size_t side) {
    body.each(side, [&](size_t end, size_t, const app::Point& at) { body.model.ends[0][end].traction = {2 - at.y * at.y}; });
  };
  load(half, 0), load(whole, 1), load(whole, 2);
  const app::TwistSystem one(half.model), two(whole.model);
  const app::TwistField a = solve(one), b = solve(two);
  half.each(0, [&](size_t, size_t node, const app::Point& at) {
    whole.each(2, [&](size_t, size_t other, const app::Point& there) {
      if (std::fabs(at.y - there.y) < 1e-12) CHECK(a.angle[0][node] == doctest::Approx(b.angle[0][other]).epsilon(1e-10));
    });
  });
  CHECK(half.torque(one, a, 1) == doctest::Approx(-half.torque(one, a, 0)).epsilon(1e-12));
}

TEST_CASE("torsion: a body that nothing holds is refused") {
  Polygon bar(1, 2, {{0, 0}, {1, 0}, {1, 2}, {0, 2}});
  bar.each(1, [&](size_t end, size_t, const app::Point&) { bar.model.ends[0][end].traction = {1}; });
  CHECK(app::TwistSystem(bar.model).is_singular());
}

TEST_CASE("torsion: slip of springs side by side: loops of load and unload") {
  const size_t n = 5;
  app::SlipProblem problem{app::TwistMatrix(n, n), app::TwistMatrix(n, 1), {}};
  for (size_t i = 0; i < n; ++i) {
    problem.stiffness.row(i)[i] = problem.load.row(i)[0] = 1 + static_cast<double>(i);
    problem.limit.push_back(1.5 * static_cast<double>(n - i));
  }
  app::SlipPath path(problem);
  std::vector<double> spring(n, 0.0); // by hand
  double at = 0;
  for (const double target : {0.7, 4.0, -1.0, 2.0, -9.0}) {
    CHECK(path.go_to({target}, [](const app::SlipState&) {}));
    for (size_t i = 0; i < n; ++i) {
      const double limit = problem.limit[i];
      spring[i] = std::min(limit, std::max(-limit, spring[i] + problem.load.row(i)[0] * (target - at)));
      CHECK(path.state().traction[i] == doctest::Approx(spring[i]).epsilon(1e-12));
    }
    at = target;
  }
  CHECK(path.residual() < 1e-13);
}

TEST_CASE("torsion: slip of coupled pairs: the law holds, one step or many, any order of the pairs") {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Dice dice(seed);
    const size_t n = 6;
    app::SlipProblem problem{app::TwistMatrix(n, n), app::TwistMatrix(n, 1), {}}, turned = problem;
    double root[6][6];
    for (auto& row : root)
      for (double& v : row) v = dice.between(-1, 1);
    for (size_t i = 0; i < n; ++i) {
      for (size_t j = 0; j < n; ++j) {
        double sum = i == j ? 0.2 : 0;
        for (size_t k = 0; k < n; ++k) sum += root[i][k] * root[j][k];
        problem.stiffness.row(i)[j] = sum, turned.stiffness.row(n - 1 - i)[n - 1 - j] = sum;
      }
      problem.load.row(i)[0] = turned.load.row(n - 1 - i)[0] = dice.between(-2, 2);
      problem.limit.push_back(dice.between(0.2, 1));
    }
    turned.limit.assign(problem.limit.rbegin(), problem.limit.rend());
    app::SlipPath one(problem), many(problem), other(turned);
    double at = 0;
    for (const double target : {2.0, -3.0, 1.0}) {
      app::SlipState before = one.state();
      const auto check = [&](const app::SlipState& now) { // between events slip is against friction
        for (size_t i = 0; i < n; ++i) {
          CHECK(std::fabs(now.traction[i]) <= problem.limit[i] * (1 + 1e-10));
          CHECK((now.slip[i] - before.slip[i]) * now.traction[i] <= 1e-12);
        }
        before = now;
      };
      CHECK(one.go_to({target}, check));
      check(one.state());
      CHECK(other.go_to({target}, [](const app::SlipState&) {}));
      for (int k = 1; k <= 7; ++k)
        CHECK(many.go_to({k == 7 ? target : at + (target - at) * k / 7}, [](const app::SlipState&) {}));
      at = target;
      for (size_t i = 0; i < n; ++i) {
        CHECK(std::fabs(one.state().slip[i] - many.state().slip[i]) < 1e-10);
        CHECK(std::fabs(one.state().slip[i] - other.state().slip[n - 1 - i]) < 1e-10);
      }
      CHECK(one.residual() < 1e-11);
    }
  }
}

TEST_CASE("torsion: a path ends where the last pair turns through") {
  app::SlipProblem problem{app::TwistMatrix(2, 2), app::TwistMatrix(2, 1), {1, 2}};
  const double matrix[2][2] = {{1, -1}, {-1, 1}}; // a common slip meets no resistance
  for (size_t i = 0; i < 2; ++i)
    for (size_t j = 0; j < 2; ++j) problem.stiffness.row(i)[j] = matrix[i][j];
  problem.load.row(0)[0] = problem.load.row(1)[0] = 1;
  app::SlipPath path(problem);
  CHECK(!path.go_to({5}, [](const app::SlipState&) {}));
  CHECK(path.state().factors[0] == doctest::Approx(1.5).epsilon(1e-13)); // the sum of the limits over two
}
