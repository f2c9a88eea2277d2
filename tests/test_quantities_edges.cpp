// Numbers of contacts by hand on lines that are rare: closed ones that do not touch, or in two stretches; between two lines of
// symmetry; without pairs; of bodies of revolution.
#include "post/edges.hpp"
#include "quantity_runs.hpp"

#include <cmath>
#include <string>
#include <vector>

using namespace quantities_test;

namespace {

ZoneLine line_of(size_t n, bool round) {
  ZoneLine line;
  line.zone = 1, line.round = round, line.length = static_cast<double>(round ? n : n - 1);
  line.end[1].s = line.length;
  for (size_t i = 0; i < n; ++i)
    line.s.push_back(static_cast<double>(i)), line.pair.push_back(static_cast<int32_t>(i)), line.corner.push_back(0);
  line.weight.assign(n, n > 0 ? line.length / static_cast<double>(n) : 0);
  return line;
}

// The states of the pairs as letters: . open, s stick, x slip; all that touch press alike.
std::vector<Quantity> numbers(const ZoneLine& line, const std::string& states) {
  std::vector<double> table(states.size() * C2D_PAIR_FIELDS, 0.0);
  for (size_t i = 0; i < states.size(); ++i) {
    double* row = table.data() + i * C2D_PAIR_FIELDS;
    row[C2D_STATUS] = states[i] == '.' ? C2D_OPEN : states[i] == 's' ? C2D_STICK : C2D_SLIP;
    row[C2D_TN] = states[i] == '.' ? 0 : 2, row[C2D_TT] = states[i] == 'x' ? 0.6 : states[i] == 's' ? 0.1 : 0;
    row[C2D_GAP] = states[i] == '.' ? 1 : 0;
  }
  return quantities_of({line}, table.data(), C2D_PAIR_FIELDS, {C2D_INIT(c2d_zone_state)}, 0);
}

double value(const std::vector<Quantity>& all, Measure what) {
  const std::vector<Quantity> found = Run::all(all, what);
  return found.empty() ? -1 : found[0].value;
}

} // namespace

TEST_CASE("quantities: closed lines that touch nowhere, everywhere, in one stretch or two") {
  const ZoneLine round = line_of(24, true);
  const std::vector<Quantity> none = numbers(round, std::string(24, '.')), all = numbers(round, std::string(24, 'x'));
  CHECK(value(none, Measure::kContactWidth) == -1);
  CHECK(value(none, Measure::kMeanPressure) == -1);
  CHECK(value(all, Measure::kContactWidth) == 24);
  for (const char state : {'.', 's', 'x'}) {
    ZoneLine ring = round;
    ring.revolved = true;
    CHECK(value(numbers(ring, std::string(24, state)), Measure::kContactWidth) == (state == '.' ? -1 : 24));
  }
  CHECK(value(all, Measure::kMeanPressure) == doctest::Approx(2));
  // Turned round, a contact keeps its numbers, of plane bodies and of bodies of revolution.
  ZoneLine revolved = round;
  revolved.revolved = true;
  for (const std::string states : {"....xxxxxxxx............", "..xxssxx......xxssssxx..", ".sssss..................",
                                   "xxx.....................", ".....................xxx"}) {
    CAPTURE(states);
    const double width = value(numbers(round, states), Measure::kContactWidth),
                 stuck = value(numbers(round, states), Measure::kStuckWidth);
    CHECK(width > 0);
    for (size_t by = 1; by < 24; ++by) {
      CAPTURE(by);
      const std::string turned = states.substr(by) + states.substr(0, by);
      CHECK(value(numbers(round, turned), Measure::kContactWidth) == doctest::Approx(width));
      CHECK(value(numbers(round, turned), Measure::kStuckWidth) == doctest::Approx(stuck));
      CHECK(value(numbers(revolved, turned), Measure::kContactWidth) == doctest::Approx(width));
    }
  }
}

TEST_CASE("quantities: contacts that lines of symmetry cut at one end, or at both") {
  ZoneLine line = line_of(13, false);
  const std::string states(13, 's');
  CHECK(value(numbers(line, states), Measure::kContactWidth) == 12);
  line.end[0].mirror = true;
  CHECK(value(numbers(line, states), Measure::kContactWidth) == 24);
  CHECK(value(numbers(line, states), Measure::kHalfWidth) == 12);
  line.end[1].mirror = true; // four images make the whole
  CHECK(value(numbers(line, states), Measure::kContactWidth) == 48);
  CHECK(value(numbers(line, states), Measure::kStuckWidth) == 48);
  CHECK(Run::all(numbers(line, states), Measure::kContactWidth).at(0).images == 2);
  // Slip at one end of the line, stick at the other.
  CHECK(value(numbers(line_of(13, false), "xxxxxxxssssss"), Measure::kStuckWidth) == doctest::Approx(5.5).epsilon(0.1));
  CHECK(value(numbers(line_of(13, false), "ssssssxxxxxxx"), Measure::kStuckWidth) == doctest::Approx(5.5).epsilon(0.1));
}

TEST_CASE("quantities: lines without pairs, of plane bodies and of bodies of revolution, have no numbers of a contact") {
  for (const bool revolved : {false, true}) {
    ZoneLine line = line_of(0, false);
    line.revolved = revolved, line.length = 0, line.end[1].s = 0;
    const std::vector<Quantity> all = numbers(line, "");
    for (const Measure what : {Measure::kPeakPressure, Measure::kMeanPressure, Measure::kContactWidth, Measure::kHalfWidth})
      CHECK(value(all, what) == -1);
  }
}

TEST_CASE("quantities: edges between pairs that press and one open pair, on short lines") {
  for (const bool round : {false, true})
    for (const std::string states : {"x", ".", "x.", ".x", "xx", "x.x", ".x.", "x..", "..x", "xsx", "s.s"}) {
      CAPTURE(states);
      CAPTURE(round);
      if (round && states.size() < 3) continue;
      ZoneLine line = line_of(states.size(), round);
      if (states.size() == 1) line.length = line.end[1].s = 1, line.weight[0] = 1;
      const std::vector<Quantity> all = numbers(line, states);
      const double width = value(all, Measure::kContactWidth);
      CHECK(width <= line.length * (1 + 1e-12));
      if (states.find_first_not_of('.') == std::string::npos) CHECK(width == -1);
      for (const Quantity& q : Run::all(all, Measure::kContactEdge)) CHECK((q.value >= 0 && q.value <= line.length));
    }
}
