// Slits in one body that are narrower than half an element.
#include "many_bodies.hpp"
#include "memory/config.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;

namespace {

std::string told(const Result& r) {
  for (const c2d_error& e : r.told)
    if (e.severity == C2D_WARNING && e.status == C2D_WARN_SLIT) return e.text;
  return "";
}

// A square of side 10, held below, pulled apart on both sides by 1, with a slit from the middle of the top to its centre whose
// walls have `walls` elements; everything else has elements of length 1.
Model split(double width, int32_t walls, int32_t right = 0) {
  const double half = 0.5 * width;
  Model m;
  m.add(polygon({{-5, -5, 10},
                 {5, -5, 10},
                 {5, 5, 5},
                 {half, 5, right != 0 ? right : walls},
                 {half, 0, 1},
                 {-half, 0, walls},
                 {-half, 5, 5},
                 {-5, 5, 10}},
                1000));
  m.body(1).ends.assign(static_cast<size_t>(2 * m.body(1).elements()), End());
  m.set(1, 1, end_of(kHeld));
  m.set(1, 2, end_of(kPulled, 1, 0));
  m.set(1, 8, end_of(kPulled, -1, 0));
  return m;
}

} // namespace

TEST_CASE("slits: the width, the elements and the consequence are told" * doctest::skip(c2d::kSmallCode)) {
  const Result r = solve(split(0.1, 5));
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  const std::string text = told(r);
  CHECK(text.find("element 26, 1 long, lies beside a slit 0.1 wide, opposite element 36") != std::string::npos);
  CHECK(text.find("open it too little") != std::string::npos);
}

// Functions with three nodes are within 2 % of themselves on a mesh finer by two to four, at every width.
TEST_CASE("slits: linear functions open one too little by one to two elements' share, as is told" *
          doctest::skip(c2d::kSmallCode)) {
  const auto opens = [](Model m, int32_t nodes) {
    m.function_nodes = nodes;
    m.body(1).ends.assign(static_cast<size_t>(nodes * m.body(1).elements()), End());
    m.set(1, 1, end_of(kHeld));
    m.set(1, 2, end_of(kPulled, 1, 0));
    m.set(1, 8, end_of(kPulled, -1, 0));
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(told(r).empty() == (nodes != 2));
    double least = 0, most = 0;
    for (const EndResult& e : r.boundary[0])
      if (e.y == 5 && std::fabs(e.x) < 0.5) least = std::min(least, e.ux), most = std::max(most, e.ux);
    return most - least;
  };
  for (const double width : {0.2, 0.1, 0.01})
    for (const int32_t walls : {5, 10}) {
      CAPTURE(width);
      CAPTURE(walls);
      const double right = opens(split(width, 20), 3), loss = 1 - opens(split(width, walls), 2) / right;
      CHECK(std::fabs(opens(split(width, walls), 3) / right - 1) < 0.02);
      CHECK(loss > 1.0 / walls);
      CHECK(loss < 2.5 / walls);
    }
}

TEST_CASE("slits: the longer of two facing elements counts" * doctest::skip(c2d::kSmallCode)) {
  CHECK(told(solve(split(0.1, 5, 100))).find("1 long, lies beside a slit 0.1 wide") != std::string::npos);
  CHECK(told(solve(split(0.1, 100, 100))).empty()); // elements half as long as it is wide
  CHECK(told(solve(split(0.6, 5))).empty());
}

TEST_CASE("slits: half of one beside a line of symmetry, opposite its image" * doctest::skip(c2d::kSmallCode)) {
  for (const double half : {0.05, 0.3}) {
    Model m;
    m.add(open_polygon({{0, -5, 5}, {5, -5, 10}, {5, 5, 5}, {half, 5, 5}, {half, 0, 1}, {0, 0, 0}}));
    m.body(1).ends.assign(static_cast<size_t>(2 * m.body(1).elements()), End());
    m.set(1, 1, end_of(kHeld));
    m.set(1, 2, end_of(kPulled, 1, 0));
    m.symmetry = 1;
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK((told(r).find("1 long, lies beside a slit 0.1 wide, opposite its image") != std::string::npos) == (half < 0.1));
  }
}

// Notches, thin parts, two bodies with a narrow gap, and faces of one body that may touch.
TEST_CASE("slits: what is none is not told" * doctest::skip(c2d::kSmallCode)) {
  const auto held = [](Model m) {
    for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(2 * b.elements()), End());
    for (int32_t b = 1; b <= static_cast<int32_t>(m.bodies.size()); ++b) m.set(b, 1, end_of(kHeld));
    return m;
  };
  Model notch, strip, two, closes = split(0.1, 5);
  notch.add(polygon({{-5, -5, 10}, {5, -5, 10}, {5, 5, 4}, {1, 5, 5}, {0, 0, 5}, {-1, 5, 4}, {-5, 5, 10}}));
  strip.add(rectangle(0, 0, 10, 0.1, {10, 1, 10, 1}));
  two.add(rectangle(0, 0, 10, 5, {10, 5, 10, 5}));
  two.add(rectangle(0, 5.1, 10, 10, {10, 5, 10, 5}));
  for (const Model& m : {held(notch), held(strip), held(two)}) {
    const Result r = solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(told(r).empty());
  }
  closes.join(C2D_ZONE_MATCHING | C2D_ZONE_SELF, 1, 4, 1, 6);
  const Result r = solve(closes);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(told(r).empty());
}
