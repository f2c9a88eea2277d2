// Thin layers upon each other between blocks, pressed: pressure, displacements and energy are those of uniform stress, whatever
// the number of layers and their thickness, the order of functions, the joint, the units and the way the loads came.
#include "many_bodies.hpp"
#include "memory/config.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;

namespace {

enum class Joint { matching, free, tied };

// Blocks of size 1 with layers of thickness t of other materials between them; nu = 0, pressure 1: all stress is uniform.
Model layered(int32_t layers, double t, int32_t function_nodes, Joint joint) {
  const double moduli[] = {500, 100, 700, 300, 900, 200};
  Model m;
  m.function_nodes = function_nodes;
  m.add(rectangle(0, 0, 1, 1, {8, 4, 8, 4}, 1000, 0));
  for (int32_t i = 0; i < layers; ++i) m.add(rectangle(0, 1 + t * i, 1, 1 + t * (i + 1), {8, 1, 8, 1}, moduli[i], 0));
  m.add(rectangle(0, 1 + t * layers, 1, 2 + t * layers, {8, 4, 8, 4}, 2000, 0));
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * function_nodes), End());
  m.set(1, 1, end_of(kHeld));
  m.set(layers + 2, 3, end_of(kPulled, 0, -1));
  for (int32_t b = 1; b <= layers + 1; ++b)
    m.join((joint == Joint::free ? C2D_ZONE_FREE : C2D_ZONE_MATCHING) + (joint == Joint::tied ? C2D_ZONE_TIED : 0), b, 3, b + 1,
           1);
  m.friction = 0.5;
  return m;
}

// By how much less is there between the lower end and the upper one, in lengths of a block.
double shortening(const Model& m, double t) {
  double sum = 0;
  for (size_t b = 0; b < m.bodies.size(); ++b) sum += (b == 0 || b + 1 == m.bodies.size() ? 1 : t) / m.bodies[b].youngs_modulus;
  return sum;
}

struct Errors {
  double pressure = 0, motion = 0, work = 0;
};
// Of a model in which lengths count `length` times; a pressure `pressure` stands for 1.
Errors errors_of(const Model& m, const Result& r, double t, double length = 1, double pressure = 1) {
  Errors e;
  const double shortened = pressure * length * shortening(m, t),
               top = length * (2 + t * static_cast<double>(m.bodies.size() - 2));
  for (const Row& row : r.last().rows) e.pressure = std::max(e.pressure, std::fabs(row[C2D_TN] / pressure - 1));
  for (const EndResult& end : r.boundary.back())
    if (std::fabs(end.y - top) < 1e-9 * length) e.motion = std::max(e.motion, std::fabs(-end.uy / shortened - 1));
  e.work = std::fabs(r.last().work / (0.5 * pressure * length * shortened) - 1);
  return e;
}

void check_layers(const Model& m, double t, double length = 1, double pressure = 1) {
  CAPTURE(t);
  CAPTURE(m.function_nodes);
  CAPTURE(m.bodies.size());
  CAPTURE(m.zones.front().kind);
  const Result r = solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE(r.outcome == C2D_REACHED);
  const Errors e = errors_of(m, r, t, length, pressure);
  CHECK(e.pressure < 1e-11);
  CHECK(e.motion < 1e-11);
  CHECK(e.work < 1e-11);
  CHECK(r.summary.max_residual < 1e-13);
}

} // namespace

TEST_CASE("slender: one layer between blocks is right at any thickness" * doctest::skip(c2d::kSmallCode)) {
  for (const int32_t nodes : {2, 3, 4})
    for (const double t : {1e-3, 1e-6}) check_layers(layered(1, t, nodes, Joint::matching), t);
}

TEST_CASE("slender: layers upon each other are right at any thickness" * doctest::skip(c2d::kSmallCode)) {
  for (const Joint joint : {Joint::matching, Joint::free, Joint::tied})
    for (const int32_t nodes : {2, 3, 4})
      for (const double t : {1e-2, 1e-6}) check_layers(layered(2, t, nodes, joint), t);
  for (const double t : {1e-3, 1e-4, 1e-5}) check_layers(layered(3, t, 4, Joint::tied), t);
  check_layers(layered(5, 1e-3, 4, Joint::matching), 1e-3);
  check_layers(layered(6, 1e-5, 3, Joint::free), 1e-5);
}

// Shells are held where symmetry cuts them, and bend as easily.
TEST_CASE("slender: layers that supports hold" * doctest::skip(c2d::kSmallCode)) {
  for (const Joint joint : {Joint::matching, Joint::tied})
    for (const double t : {1e-3, 1e-5}) {
      Model m = layered(3, t, 3, joint);
      double below = -1 / m.body(1).youngs_modulus; // uy of the layer's lower face
      for (int32_t b = 2; b <= 4; ++b) {
        Body& layer = m.body(b);
        const double middle = below - 0.5 * t / layer.youngs_modulus;
        for (const int32_t side : {2, 4}) // in the middle of its ends, to where it goes
          layer.ends[static_cast<size_t>(3 * (m.side(b, side).first - 1) + 1)] =
              end_of(side == 4 ? "1100" : "0110", 0, 0, 0, middle);
        below -= t / layer.youngs_modulus;
      }
      check_layers(m, t);
    }
}

TEST_CASE("slender: layers in other units, and turned" * doctest::skip(c2d::kSmallCode)) {
  const Model m = layered(2, 3e-5, 4, Joint::tied);
  check_layers(scaled(m, 3, 1), 3e-5, 3, 1);
  check_layers(scaled(m, 1e3, 1e6), 3e-5, 1e3, 1e6);
  const Result r = solve(turned(m, 37));
  REQUIRE(r.outcome == C2D_REACHED);
  for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-11);
}

TEST_CASE("slender: layers that go along have no pressure" * doctest::skip(c2d::kSmallCode)) {
  for (const Joint joint : {Joint::matching, Joint::tied}) {
    Model m = layered(2, 1e-4, 3, joint);
    m.set(1, 1, end_of(kHeld, 0, 0, 0.25, 0.5));
    m.set(4, 3, end_of(kHeld, 0, 0, 0.25, 0.5));
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    for (const Row& row : r.last().rows) {
      CHECK(std::fabs(row[C2D_TN]) < 1e-10);
      CHECK(row[C2D_UN1] == doctest::Approx(0.5).epsilon(1e-9));
    }
  }
}

// The load is in the equations of the strip that it moves, the support in those of the other one.
TEST_CASE("slender: a strip that drags another one away from its support" * doctest::skip(c2d::kSmallCode)) {
  for (const int32_t nodes : {2, 3, 4})
    for (const bool mirrored : {false, true}) {
      CAPTURE(nodes);
      CAPTURE(mirrored);
      Model m;
      m.function_nodes = nodes;
      for (const double y : {0.0, 0.1}) m.add(rectangle(0, y, 4, y + 0.1, {8, 2, 8, 2}, 1000, 0.3));
      for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * nodes), End());
      const int32_t dragged = mirrored ? 2 : 1, held = 3 - dragged;
      m.set(dragged, mirrored ? 3 : 1, end_of(kHeld, 0, 0, 1e-3, 0));
      const int32_t first = nodes * (m.side(held, 4).first - 1); // in the middle of its end, along x
      m.body(held).ends[static_cast<size_t>(first + nodes - 1)] = end_of("0001");
      m.body(held).ends[static_cast<size_t>(first + nodes)] = end_of("1001");
      m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 1, 3, 2, 1);
      const Result r = solve(m);
      REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
      REQUIRE(r.outcome == C2D_REACHED);
      double support = 0, stuck = 0;
      for (const EndResult& end : r.boundary[static_cast<size_t>(held - 1)])
        if (std::fabs(end.x) < 1e-9) support = std::max(support, std::fabs(end.tx));
      for (const Row& row : r.last().rows) stuck = std::max(stuck, std::fabs(row[C2D_TT]));
      CHECK(support > 0.1);
      CHECK(stuck > 0.01);
      CHECK(imbalance(m, r) < 1e-10);
    }
}

TEST_CASE("slender: layers take more than the least memory, by a number that is reported" * doctest::skip(c2d::kSmallCode)) {
  Model m = layered(5, 1e-3, 4, Joint::matching);
  m.bytes = 1;
  const Result refused = solve(m);
  REQUIRE(refused.status == C2D_ERR_MEMORY);
  REQUIRE(refused.told_of(" for slender bodies upon each other: "));
  const auto fault =
      std::find_if(refused.told.begin(), refused.told.end(), [](const c2d_error& e) { return e.bytes_needed > 0; });
  REQUIRE(fault != refused.told.end());
  const auto is_fault = [](const c2d_error& e) { return e.severity == C2D_FAULT; };
  CHECK(std::count_if(refused.told.begin(), refused.told.end(), is_fault) == 1);
  m.bytes = fault->bytes_needed - 64; // less than an alignment's worth
  CHECK(solve(m).status == C2D_ERR_MEMORY);
  m.bytes = fault->bytes_needed;
  check_layers(m, 1e-3);
}

TEST_CASE("slender: other loads on layers" * doctest::skip(c2d::kSmallCode)) {
  const Model m = layered(3, 1e-4, 3, Joint::free);
  Machine machine(m, 1);
  REQUIRE(machine.run().outcome == C2D_REACHED);
  REQUIRE(c2d_change_loads(machine.solver) == C2D_OK);
  const Range top = m.side(5, 3);
  for (int32_t element = top.first; element <= top.last; ++element)
    for (int32_t local = 1; local <= 3; ++local) {
      const double values[4] = {0, -2.5, 0, 0};
      REQUIRE(c2d_set_values(machine.solver, 5, element, local, 1, values) == C2D_OK);
    }
  const Result r = machine.run();
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  const Errors e = errors_of(m, r, 1e-4, 1, 2.5);
  CHECK(e.pressure < 1e-11);
  CHECK(e.motion < 1e-11);
  CHECK(e.work < 1e-11);
}

// Beams of two layers that slide on each other bend like two, tied ones like one of twice the height.
TEST_CASE("slender: layers that slide on each other" * doctest::skip(c2d::kSmallCode)) {
  for (const double mu : {0.0, 0.3}) {
    Model m = layered(2, 1e-3, 3, Joint::matching);
    m.friction = mu;
    m.set(4, 3, end_of(kPulled, 0.1, -1));
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    if (mu == 0.0) {
      CHECK(r.outcome == C2D_FREE_MOTION);
      continue;
    }
    REQUIRE(r.outcome == C2D_REACHED);
    CHECK(breach(m, r) == "");
    CHECK(imbalance(m, r) < 1e-11);
  }
}

// Blocks with thin tongues between two others: by their areas they are stout.
TEST_CASE("slender: bodies of which a part is thin are refused by the reported number" * doctest::skip(c2d::kSmallCode)) {
  for (const double t : {0.3, 1e-5}) {
    Model m;
    m.function_nodes = 3;
    m.add(rectangle(0, 0, 3, 1, {6, 4, 12, 4}, 1000, 0));
    m.add(polygon({{-1.5, 0.5, 2},
                   {-0.5, 0.5, 2},
                   {-0.5, 1, 2},
                   {0, 1, 12},
                   {3, 1, 1},
                   {3, 1 + t, 12},
                   {0, 1 + t, 2},
                   {-0.5, 1 + t, 2},
                   {-0.5, 2, 2},
                   {-1.5, 2, 2}},
                  500, 0));
    m.add(polygon({{0, 1 + t, 12},
                   {3, 1 + t, 2},
                   {3.5, 1 + t, 2},
                   {3.5, 0.5, 2},
                   {4.5, 0.5, 2},
                   {4.5, 2, 2},
                   {3.5, 2, 2},
                   {3.5, 1 + 2 * t, 2},
                   {3, 1 + 2 * t, 12},
                   {0, 1 + 2 * t, 1}},
                  700, 0));
    m.add(rectangle(0, 1 + 2 * t, 3, 2 + 2 * t, {12, 4, 6, 4}, 1000, 0));
    for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * 3), End());
    m.set(1, 1, end_of(kHeld));
    m.set(4, 3, end_of(kPulled, 0, -1));
    m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 1, 3, 2, 4);
    m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 2, 6, 3, 1);
    m.join(C2D_ZONE_MATCHING + C2D_ZONE_TIED, 3, 9, 4, 1);
    const Result r = solve(m);
    CAPTURE(t);
    CHECK_MESSAGE(r.status == (t > 0.1 ? C2D_OK : C2D_ERR_SINGULAR), r.messages());
    CHECK(r.told_of("so slender that round-off may be up to ") == (t < 0.1));
    const auto is_fault = [](const c2d_error& e) { return e.severity == C2D_FAULT; };
    CHECK(std::count_if(r.told.begin(), r.told.end(), is_fault) == (t < 0.1 ? 1 : 0));
  }
}
