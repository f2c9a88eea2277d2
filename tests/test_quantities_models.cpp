// What sums up a contact, told in other units, mirrored and swapped; round closed sides, in self-contact, of constant
// functions.
#include "callable.hpp"
#include "quantity_runs.hpp"

#include <algorithm>
#include <cmath>
#include <string>

using namespace quantities_test;

// ---- the same contact, told otherwise
namespace {

// A cylinder's segment (a body) pressed on a block (the body before it) by its flat top, with friction, off the middle of the
// block, at `x`; its top is drawn aside by `aside`.
void add_pressed_segment(many::Model& m, double x, double aside) {
  const int32_t n = 40;
  const double half = 1, radius = 20;
  const int32_t block = static_cast<int32_t>(m.bodies.size()) + 1, pressed = block + 1;
  m.add(many::polygon({{x - 6, -8, 8}, {x + 7, -8, 6}, {x + 7, 0, 5}, {x + half, 0, n}, {x - half, 0, 5}, {x - 6, 0, 6}}));
  many::Body segment;
  segment.element_nodes = 2;
  std::vector<many::Corner> corners;
  for (int32_t i = 0; i < n; ++i) {
    const double at = -half + 2 * half * i / n;
    corners.push_back({x + at, at * at / (2 * radius), 1});
  }
  corners.push_back({x + half, half * half / (2 * radius), 5});
  corners.push_back({x + half, 2, 10});
  corners.push_back({x - half, 2, 5});
  segment = many::polygon(corners, 2000, 0.2);
  const int32_t first = 1, last = n;
  m.add(segment);
  const many::Range under = m.side(block, 4);
  m.zones.push_back({C2D_ZONE_MATCHING, {{block, under.first, under.last}, {pressed, last, first}}, -1, {0, 0}});
  m.set(block, 1, many::end_of(many::kHeld));
  const int32_t top = n + 2;
  m.set(pressed, top, many::end_of("1100", 0, 0, aside, -0.02));
}

many::Model pressed_segment(int32_t function_nodes = 2) {
  many::Model m;
  m.function_nodes = function_nodes;
  add_pressed_segment(m, 0, 0.006);
  m.friction = 0.2;
  m.paths = {{2, 1.0}};
  return m;
}

struct Expected {
  std::vector<double> value;
  std::vector<double> x, y;
};
Expected values_of(const Run& run, Measure what) {
  Expected out;
  for (const Quantity& q : run.all(what)) out.value.push_back(q.value), out.x.push_back(q.at[0]), out.y.push_back(q.at[1]);
  return out;
}

const Measure kWithPlace[] = {Measure::kPeakPressure, Measure::kContactEdge, Measure::kStickBorder, Measure::kEdgePressure};

// All quantities with a place, in the order of the line or against it: values by `scale`, lengths along the side by `length`.
void compare(const Run& a, const Run& b, double scale, const test::Callable<void(double&, double&)>& place, double length) {
  double first_x = values_of(a, Measure::kContactEdge).x.at(0), first_y = 0;
  place(first_x, first_y);
  const bool backwards = std::fabs(values_of(b, Measure::kContactEdge).x.at(0) - first_x) > 1e-3 * length;
  for (const Measure what : kWithPlace) {
    CAPTURE(std::string(name_of(what)));
    const Expected one = values_of(a, what), two = values_of(b, what);
    REQUIRE(one.value.size() == two.value.size());
    CHECK(!one.value.empty());
    for (size_t i = 0; i < one.value.size(); ++i) {
      const size_t k = backwards ? one.value.size() - 1 - i : i;
      double x = one.x[i], y = one.y[i];
      place(x, y);
      CHECK(std::fabs(two.x[k] - x) < 1e-7 * length);
      CHECK(std::fabs(two.y[k] - y) < 1e-7 * length);
      const bool is_length = what == Measure::kContactEdge || what == Measure::kStickBorder;
      if (!is_length)
        CHECK(
            two.value[k] ==
            doctest::Approx(one.value[i] * scale * (what == Measure::kEdgePressure ? 1 / std::sqrt(length) : 1)).epsilon(1e-6));
      if (is_length && !backwards) CHECK(two.value[k] == doctest::Approx(one.value[i] * length).epsilon(1e-7));
    }
  }
}

} // namespace

TEST_CASE("quantities: other units, mirrored, sides swapped, bodies renumbered") {
  for (const int32_t nodes : {2, 3}) {
    const many::Model model = pressed_segment(nodes);
    const Run run = follow(model);
    const c2d_zone_state state = run.record.steps.back().zones.at(0);
    CAPTURE(state.stick);
    CAPTURE(state.slip);
    REQUIRE(run.all(Measure::kContactEdge).size() == 2);
    REQUIRE(!run.all(Measure::kStickBorder).empty());
    const auto same = [](double&, double&) {};
    compare(
        run, follow(many::scaled(model, 1e6, 1e-6)), 1e-6, [](double& x, double& y) { x *= 1e6, y *= 1e6; }, 1e6);
    compare(
        run, follow(many::reflected(model)), 1, [](double& x, double&) { x = -x; }, 1);
    compare(run, follow(many::with_bodies_in_order(model, {2, 1})), 1, same, 1);
    // With sides swapped lengths are those of the other surface: places differ by the gap, along it.
    const Run swapped = follow(many::with_swapped_sides(model, 1));
    for (const Measure what : kWithPlace) {
      const Expected one = values_of(run, what);
      Expected two = values_of(swapped, what);
      REQUIRE(one.value.size() == two.value.size());
      const size_t n = one.value.size();
      for (size_t i = 0; i < n; ++i) {
        const size_t k = n > 1 && std::fabs(two.x[0] - one.x[0]) > std::fabs(two.x[n - 1] - one.x[0]) ? n - 1 - i : i;
        CHECK(std::fabs(two.x[k] - one.x[i]) < 2e-3);
      }
    }
  }
}

// ---- closed sides, self-contact, constant functions
namespace {

// A rigid disc, moved downwards in a hole of radius 1 of a ring that is held outside. Sides are whole closed curves that begin
// `before` elements ahead of 0.3 left of the pole, or as many elements from there on.
many::Model disc_in_ring(int32_t before = 0, int32_t elements = 0) {
  const int32_t n = 120;
  const double offset = 0.3 + before * 2 * kPi / n;
  many::Model m;
  many::Body ring, disc;
  const auto circle = [offset](double radius, double turn) {
    return [=](double s, double& x, double& y) {
      const double angle = turn * 2 * kPi * s - kPi / 2 - offset;
      x = radius * std::cos(angle), y = radius * std::sin(angle);
    };
  };
  ring.element_nodes = disc.element_nodes = 3;
  many::add_curve(ring, 40, circle(2, 1));
  many::add_curve(ring, n, circle(1, -1));
  many::add_curve(disc, n, circle(0.999, 1));
  m.add(ring);
  m.add(disc);
  m.set(1, 1, many::end_of(many::kHeld));
  m.body(2).rigid = 1, m.body(2).motion[1] = -0.002;
  const int32_t all = elements > 0 ? elements : n, last = m.side(1, 2).last; // those of the hole run clockwise
  many::Zone zone;
  zone.kind = C2D_ZONE_MATCHING;
  zone.side[0] = {1, last, last - all + 1, all};
  zone.side[1] = {2, 1, all, all};
  m.zones.push_back(zone);
  return m;
}

} // namespace

TEST_CASE("quantities: a disc in a ring, round the whole circle or on a part of it") {
  const Run whole = follow(disc_in_ring()), part = follow(disc_in_ring(18, 50));
  CHECK(whole.lines.at(0).round);
  CHECK(!part.lines.at(0).round);
  CHECK(whole.lines.at(0).size() == 120);
  CHECK(whole.lines.at(0).length == doctest::Approx(2 * kPi * 0.999).epsilon(1e-6));
  for (const Measure what : {Measure::kContactEdge, Measure::kPeakPressure, Measure::kMeanPressure, Measure::kEdgePressure}) {
    const std::vector<Quantity> a = whole.all(what), b = part.all(what);
    REQUIRE(a.size() == b.size());
    CHECK(!a.empty());
    for (const Quantity& q : b) {
      const auto same = [&](const Quantity& other) {
        const bool value = what == Measure::kContactEdge || std::fabs(other.value / q.value - 1) < 1e-6;
        return value && (std::isnan(q.at[0]) || std::hypot(other.at[0] - q.at[0], other.at[1] - q.at[1]) < 1e-7);
      };
      CHECK(std::any_of(a.begin(), a.end(), same));
    }
  }
  const std::vector<Quantity> edges = whole.all(Measure::kContactEdge);
  REQUIRE(edges.size() == 2);
  CHECK(std::fabs(edges[0].at[0] + edges[1].at[0]) < 2e-3); // the pole is within an element
  CHECK(std::fabs(whole.one(Measure::kPeakPressure).at[0]) < 1e-3);
}

TEST_CASE("quantities: a slot that closes on itself, against a wall on its line of symmetry") {
  const auto fork = [](bool whole) {
    many::Model m;
    m.function_nodes = 3;
    if (whole) {
      m.add(many::polygon(
          {{0, 0, 8}, {4, 0, 3}, {4, 0.95, 18}, {1, 0.95, 2}, {1, 1.05, 18}, {4, 1.05, 3}, {4, 2, 8}, {0, 2, 6}}, 100));
      m.set(1, 7, many::end_of(many::kPulled, 0, -1.2));
      m.set(1, 8, many::end_of(many::kHeld));
      m.join(C2D_ZONE_MATCHING + C2D_ZONE_SELF, 1, 3, 1, 5);
    } else {
      m.add(many::polygon({{0, 0, 8}, {4, 0, 3}, {4, 0.95, 18}, {1, 0.95, 1}, {1, 1, 4}, {0, 1, 3}}, 100));
      m.add(many::rectangle(1, 1, 4.5, 1.5, {18, 1, 3, 1}));
      m.body(2) = many::rectangle(1, 1, 4, 1.5, {18, 1, 3, 1});
      m.body(2).rigid = 1;
      m.body(2).ends.resize(static_cast<size_t>(m.body(2).elements() * 3));
      m.set(1, 6, many::end_of(many::kHeld));
      m.set(1, 5, many::end_of("0110"));
      m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    }
    m.set(1, 1, many::end_of(many::kPulled, 0, 1.2));
    return m;
  };
  const Run whole = follow(fork(true)), half = follow(fork(false));
  const std::vector<Quantity> a = whole.all(Measure::kContactEdge), b = half.all(Measure::kContactEdge);
  REQUIRE(a.size() == b.size());
  REQUIRE(!a.empty());
  for (size_t i = 0; i < a.size(); ++i) {
    const auto near = [&](const Quantity& q) { return std::fabs(q.at[0] - a[i].at[0]) < 2e-3; };
    CHECK(std::any_of(b.begin(), b.end(), near));
  }
}

TEST_CASE("quantities: constant functions") {
  const Run linear = follow(pressed_segment(2)), constant = follow(pressed_segment(1));
  const std::vector<Quantity> a = linear.all(Measure::kContactEdge), b = constant.all(Measure::kContactEdge);
  REQUIRE(a.size() == 2);
  REQUIRE(b.size() == 2);
  for (size_t i = 0; i < 2; ++i) CHECK(std::fabs(a[i].at[0] - b[i].at[0]) < 0.05); // an element
  CHECK(constant.lines.at(0).end[0].s < 0);
  CHECK(constant.lines.at(0).length == doctest::Approx(linear.lines.at(0).length).epsilon(1e-12));
  const Run stack = follow([] { // a block on a rigid base of its width: the contact ends at the corners, beyond the last pairs
    many::Model m;
    m.function_nodes = 1;
    m.add(many::rectangle(0, -1, 2, 0, {8, 4, 8, 4}));
    m.body(1).rigid = 1;
    m.add(many::rectangle(0, 0, 2, 1, {8, 4, 8, 4}));
    m.set(2, 3, many::end_of(many::kPulled, 0, -1));
    m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    m.friction = 0.5;
    return m;
  }());
  const std::vector<Quantity> edges = stack.all(Measure::kContactEdge);
  REQUIRE(edges.size() == 2);
  CHECK(std::fabs(edges[0].at[0] - edges[1].at[0]) == doctest::Approx(2).epsilon(1e-12));
  CHECK(stack.one(Measure::kMeanPressure).value == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("quantities: a block on a wider base, either of them on side 1, meshes that match or not") {
  for (const bool block_first : {true, false})
    for (const int32_t kind : {C2D_ZONE_MATCHING, C2D_ZONE_FREE}) {
      many::Model m;
      const int32_t n = kind == C2D_ZONE_FREE ? 13 : 10;
      const int32_t base = 1, block = 2;
      m.add(many::polygon({{-4, -3, 8}, {4, -3, 6}, {4, 0, 7}, {1, 0, 10}, {-1, 0, 7}, {-4, 0, 6}}));
      m.add(many::rectangle(-1, 0, 1, 1, {n, 4, 8, 4}));
      m.set(base, 1, many::end_of(many::kHeld));
      m.set(block, 3, many::end_of(many::kPulled, 0, -1));
      if (block_first)
        m.join(kind, block, 1, base, 4);
      else
        m.join(kind, base, 4, block, 1);
      m.friction = 0.5;
      CAPTURE(block_first);
      CAPTURE(kind);
      const Run run = follow(m);
      const std::vector<Quantity> edges = run.all(Measure::kContactEdge);
      REQUIRE(edges.size() == 2);
      for (const Quantity& q : edges) CHECK(std::fabs(q.at[0]) == doctest::Approx(1).epsilon(1e-9));
      CHECK(run.all(Measure::kEdgePressure).empty());
      CHECK(std::fabs(run.one(Measure::kMeanPressure).value - 1) < 0.02);
    }
}

TEST_CASE("quantities: a corner of side 1 opposite the middle of an element of side 2") {
  for (const double at : {-3.77, -3.9, -4.1}) { // where the base begins: its elements are 0.16 long
    many::Model m;
    m.add(many::rectangle(-1, 0, 1, 1, {13, 4, 8, 4}));
    m.add(many::rectangle(at, -3, at + 8, 0, {8, 6, 50, 6}));
    m.set(2, 1, many::end_of(many::kHeld));
    m.set(1, 3, many::end_of(many::kPulled, 0, -1));
    m.join(C2D_ZONE_FREE, 1, 1, 2, 3);
    m.friction = 0.5;
    const Run run = follow(m);
    const std::vector<Quantity> edges = run.all(Measure::kContactEdge);
    REQUIRE(edges.size() == 2);
    for (const Quantity& q : edges) CHECK(std::fabs(q.at[0]) == doctest::Approx(1).epsilon(1e-6));
  }
}

namespace {

// What friction does in a zone between two states, by the trapezoidal rule: only as good as the steps are short.
double rubbed_between(const ZoneLine& line, const double* before, const double* after) {
  double sum = 0;
  for (size_t i = 0; i < line.size(); ++i) {
    const size_t at = static_cast<size_t>(line.pair[i]) * C2D_PAIR_FIELDS;
    const double slip = after[at + C2D_SLIP_SUM] - before[at + C2D_SLIP_SUM];
    sum += line.weight[i] * std::fabs(0.5 * (before[at + C2D_TT] + after[at + C2D_TT]) * slip);
  }
  return sum;
}

} // namespace

TEST_CASE("quantities: what is dissipated in a zone is what its pairs rub, as if it were alone, and together it is all") {
  const double aside[2] = {0.006, 0.012};
  many::Model both;
  for (int i = 0; i < 2; ++i) add_pressed_segment(both, 40.0 * i, aside[i]);
  both.friction = 0.2;
  both.paths = {{200, 1.0}};
  many::Machine machine(both);
  REQUIRE(machine.status == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  Run run;
  REQUIRE(get_summary(machine.solver, run.summary) == C2D_OK);
  REQUIRE(find_zone_lines(machine.solver, run.summary, run.lines) == C2D_OK);
  struct Followed {
    Run& run;
    c2d_solver* solver;
    std::vector<double> before;
    double rubbed[2] = {0, 0};
  } followed{run, machine.solver, {}, {}};
  const auto note = [](void* context, const c2d_step* step) {
    Followed& f = *static_cast<Followed*>(context);
    keep_history(f.run.record, *step, f.solver, {}, f.run.lines);
    REQUIRE(step->stride == C2D_PAIR_FIELDS);
    if (step->kind == C2D_STEP_CHANGE) return int32_t{0};
    for (size_t z = 0; z < 2 && !f.before.empty(); ++z)
      f.rubbed[z] += rubbed_between(f.run.lines[z], f.before.data(), step->table);
    f.before.assign(step->table, step->table + step->pairs * step->stride);
    return int32_t{0};
  };
  REQUIRE(c2d_run(machine.solver, note, &followed) == C2D_OK);
  double sum = 0;
  for (int32_t z = 0; z < 2; ++z) {
    const double zone = run.one(Measure::kDissipated, z + 1).value;
    CHECK(zone > 0);
    CHECK(zone == doctest::Approx(followed.rubbed[z]).epsilon(2e-3));
    many::Model one;
    add_pressed_segment(one, 40.0 * z, aside[z]);
    one.friction = 0.2;
    one.paths = {{4, 1.0}};
    CHECK(zone == doctest::Approx(follow(one).one(Measure::kDissipated).value).epsilon(1e-8));
    sum += zone;
  }
  CHECK(sum == doctest::Approx(run.one(Measure::kDissipated, 0).value).epsilon(1e-12));
}
