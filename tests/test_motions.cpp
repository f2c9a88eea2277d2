// How far bodies come closer and past each other, and how rigid ones move: motions of the bodies, whatever the mesh.
#include "callable.hpp"
#include "program/estimate/loop.hpp"
#include "program/estimate/trial.hpp"
#include "program/estimate/wanted.hpp"
#include "sketches.hpp"

#include <cmath>
#include <doctest/doctest.h>

using app::Measure;

namespace {

estimate::Trial solved(const std::string& text, double fineness = 1) {
  estimate::Trial out;
  std::string why;
  const c2d_status status = estimate::solve(sketches::deck(text, fineness), {}, out, why);
  REQUIRE_MESSAGE(status == C2D_OK, why);
  REQUIRE(out.outcome == C2D_REACHED);
  return out;
}

double value_of(const estimate::Trial& trial, Measure what, int32_t zone, int32_t item = 0) {
  for (const app::Quantity& q : trial.states.back().quantities)
    if (q.what == what && q.zone == zone && q.item == item) return q.value;
  return NAN;
}

// Of the displacements at the ends of a body's straight linear elements, by length.
double mean_displacement(const estimate::Trial& trial, size_t body, size_t component) {
  const std::vector<double>&length = trial.lengths[body], &u = trial.states.back().ends[body][component];
  double sum = 0, whole = 0;
  for (size_t e = 0; e < length.size(); ++e) sum += length[e] * (u[2 * e] + u[2 * e + 1]) / 2, whole += length[e];
  return sum / whole;
}

// Modulus 1000, height 1, pressure 10 above: it becomes lower by 0.01.
const char kLower[] = "body lower E 1000 nu 0\nfrom 0 0\nline floor to 2 0\nline e to 2 1\nline top to 0 1\nline w close\n"
                      "fix lower.floor\n";
const char kUpper[] = "body upper E 1000 nu 0\nfrom 0 1\nline face to 2 1\nline e to 2 3\nline lid to 0 3\nline w close\n"
                      "contact lower.top upper.face mu 1\n";

} // namespace

TEST_CASE("motions: a loaded body's is that of its loaded curve, another one's the mean over its outline") {
  // Upper block of height 2: its lid goes down by 0.03; the outline of the lower one by (2 * 0.01 + 2 * 0.005) / 6.
  for (const double fineness : {1.0, 3.0}) {
    const estimate::Trial t = solved(std::string(kLower) + kUpper + "traction upper.lid y -10\n", fineness);
    CHECK(value_of(t, Measure::kApproach, 1) == doctest::Approx(0.03 - 0.005).epsilon(1e-9));
    CHECK(std::fabs(value_of(t, Measure::kShift, 1)) < 1e-12);
  }
  // By a platen alike.
  const estimate::Trial t = solved(std::string(kLower) + kUpper + "platen upper.lid about 1 3 force 0 -20 turn 0\n");
  CHECK(value_of(t, Measure::kApproach, 1) == doctest::Approx(0.03 - 0.005).epsilon(1e-9));
  CHECK(value_of(t, Measure::kMotionY, 0, 3) == doctest::Approx(-0.03).epsilon(1e-9));
  CHECK(std::fabs(value_of(t, Measure::kRotation, 0, 3)) < 1e-12);
  CHECK(std::isnan(value_of(t, Measure::kApproach, 0, 3))); // of models without a contact
}

TEST_CASE("motions: a rigid body's is its own; signs are those of gap and slip") {
  const std::string rigid =
      "body lid rigid\nfrom 2 1.5\nline up to 0 1.5\nline left to 0 1\nline face to 2 1\nline right close\n";
  const char* const contacts[] = {"contact lower.top lid.face mu 0.5\n", "contact lid.face lower.top mu 0.5\n"};
  for (const char* contact : contacts) {
    const std::string text = std::string(kLower) + rigid + contact +
                             "case press\ndrive lid about 1 1 fx 0 fy -20 turn 0\n"
                             "case pull\ndrive lid about 1 1 fx 4\nhistory press 1; pull 1\n";
    const estimate::Trial t = solved(text);
    CAPTURE(contact);
    const double down = value_of(t, Measure::kMotionY, 0, 2), right = value_of(t, Measure::kMotionX, 0, 2);
    CHECK(right > 0);
    CHECK(down < 0);
    // Both bodies' motions go in; the block's is between that of its floor and of its top.
    const double approach = value_of(t, Measure::kApproach, 1), shift = value_of(t, Measure::kShift, 1);
    CHECK(approach == doctest::Approx(mean_displacement(t, 0, 1) - down).epsilon(1e-11));
    CHECK(shift == doctest::Approx(right - mean_displacement(t, 0, 0)).epsilon(1e-11));
    CHECK(approach > 0.3 * -down);
    CHECK(approach < -down);
    // t runs to the left of the lower body as its top does, to the left of the lid's face alike: (u2 - u1).t has one sign.
    CHECK(std::fabs(shift) > 0.3 * right);
    CHECK(std::fabs(shift) < right);
    double slip = 0;
    for (const app::Quantity& q : t.states.back().quantities)
      if (q.what == Measure::kFrictionForce) slip = q.value;
    CHECK(slip * shift < 0); // friction on body 2 is against its motion past body 1
  }
}

TEST_CASE("motions: of a zone that goes all round along its force, which a press fit has not") {
  const std::string ring =
      "body hub E 1000 nu 0.3\nfrom 3 0\narc rim to -3 0 centre 0 0\narc under close centre 0 0\nhole\n"
      "from 1 0\narc bore to -1 0 centre 0 0 right\narc below close centre 0 0 right\n"
      "body shaft E 1000 nu 0.3\nfrom 1.001 0\narc face to -1.001 0 centre 0 0\narc back close centre 0 0\n"
      "contact hub.bore+below shaft.face+back mu 0.5\ninterference\nfix hub.rim+under\n";
  const estimate::Trial t = solved(ring);
  CHECK(value_of(t, Measure::kPeakPressure, 1) > 0.1);
  CHECK(std::fabs(value_of(t, Measure::kApproach, 1)) < 1e-6);
}

TEST_CASE("loop: a platen's motion is wanted without a contact; Timoshenko's beam") {
  // Cantilever of length 100, height 10, nu 0, with the force that bends it by 1: and 0.6 (h/L)^2 by shear.
  const sketch::Sketch s = sketches::sound(
      "parameter L 100 h 10 Y 1000 I {h^3/12}\nplane stress\nbody beam E Y nu 0\nfrom 0 0\nline under to L 0\nline tip to L h\n"
      "line top to 0 h\nline root close\nfix beam.root\nplaten beam.tip about L {h/2} force 0 {-3*Y*I/L^3}\nwant approach 1 %\n"
      "functions quadratic\n");
  const estimate::Adapted found = estimate::adapt(s, {}, [](const app::MeshRound&) {});
  int wanted = 0, motions = 0;
  for (const app::Stated& number : found.loop.stated) {
    if (number.what == Measure::kApproach) {
      ++wanted;
      CHECK(number.value == doctest::Approx(1.006).epsilon(0.004));
      CHECK(number.is_met());
      CHECK(number.error >= 0.8 * (std::fabs(number.value - 1.006) - 2e-3)); // the root is held in both directions
    }
    if (number.what == Measure::kMotionY || number.what == Measure::kRotation) {
      ++motions;
      CHECK(std::isfinite(number.error));
    }
  }
  CHECK(wanted == 1);
  CHECK(motions == 2);
  CHECK(found.loop.stopped.empty());
}

// Of a flat pad with rounded ends, tilted as drawn by t and, as given, by w: by rigid motions known beforehand contact moves
// onto a rounded end, which the zone holds from the start (all that faces as drawn and is inclined by less than 50 degrees).
TEST_CASE("motions: a pad that is turned onto its rounded end presses like one that is drawn so") {
  const std::string text = R"(
parameter l 0 w 0 t 0.03 r 0.5 a 1 q 40
parameter cs {cos(t)} sn {sin(t)}
parameter x1 {a} y1 {0} xc {a} yc {r} x2 {a+r*sin(q*deg)} y2 {r-r*cos(q*deg)}
body block E 1000 nu 0.3
  from -8 -8
  line bottom to 8 -8
  line right to 8 0
  line top to -8 0
  line left close
body pad rigid
  from {-x2*cs-y2*sn} {-x2*sn+y2*cs+l}
  arc heel to {-x1*cs-y1*sn} {-x1*sn+y1*cs+l} centre {-xc*cs-yc*sn} {-xc*sn+yc*cs+l}
  line flat to {x1*cs-y1*sn} {x1*sn+y1*cs+l}
  arc toe to {x2*cs-y2*sn} {x2*sn+y2*cs+l} centre {xc*cs-yc*sn} {xc*sn+yc*cs+l}
  line up to {x2*cs-3*sn} {x2*sn+3*cs+l}
  line back to {-x2*cs-3*sn} {-x2*sn+3*cs+l}
  line down close
contact block.top pad.heel+flat+toe
fix block.bottom
drive pad about 0 {l} x 0 turn {w} y {0.02-l}
want pressure 1 % edges 1 %
)";
  double peak[2] = {0, 0}, force[2] = {0, 0}, error[2] = {0, 0};
  for (size_t drawn = 0; drawn < 2; ++drawn) {
    const double tilt = 0.03;
    const sketch::Sketch s =
        sketches::sound(text, {{"w", drawn != 0 ? 0 : tilt}, {"t", drawn != 0 ? tilt : 0}, {"l", drawn != 0 ? 0.1 : 0}});
    const estimate::Adapted found = estimate::adapt(s, {}, [](const app::MeshRound&) {});
    CHECK(found.loop.stopped.empty());
    for (const app::Stated& number : found.loop.stated) {
      if (number.what == Measure::kPeakPressure) {
        peak[drawn] = number.value, error[drawn] = number.error;
        CHECK(number.is_met());
      }
      if (number.what == Measure::kForceY) force[drawn] = number.value;
    }
  }
  CHECK(peak[0] > 0);
  CHECK(std::fabs(peak[0] - peak[1]) < error[0] + error[1]);
  CHECK(force[0] == doctest::Approx(force[1]).epsilon(3e-3)); // turns by 0.03: second order leaves 1e-3
}

TEST_CASE("motions: approach and shift of two points are wanted") {
  // Uniform stress: u = -0.01 y below y = 1, and the upper block alike; points 1.5 apart along y, and inclined ones.
  const std::string text = std::string(kLower) + kUpper + "traction upper.lid y -10\n";
  const sketch::Sketch s =
      sketches::sound(text + "want approach at lower 1 0.5 upper 1 2 1 %\n" + "want approach at upper 0.5 1.5 lower 1.5 0.5\n");
  REQUIRE(s.wants.size() == 2);
  CHECK((s.wants[0].of == sketch::WantOf::kPair && s.wants[0].tolerance == 0.01 && s.wants[1].other == 0));
  estimate::Demand demand;
  estimate::ask(s, demand);
  const estimate::Adapted found = estimate::adapt(s, demand, [](const app::MeshRound&) {});
  std::vector<app::Stated> numbers;
  for (const app::Stated& number : found.loop.stated)
    if (number.what == Measure::kApproachOf || number.what == Measure::kShiftOf) numbers.push_back(number);
  REQUIRE(numbers.size() == 4);
  const double root = std::sqrt(0.5), u = -0.01 * (1.5 - 0.5); // the first point relative to the second
  const double expected[] = {0.015, 0, -u * root, u * root};
  for (size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(numbers[i].value == doctest::Approx(expected[i]).epsilon(1e-6));
    CHECK(numbers[i].error < 1e-6);
    CHECK(numbers[i].is_met());
  }
  sketches::tells(text + "want approach at lower 1 0.5 upper 1 0.5\n", "both points are the same, expected two points");
  sketches::tells(text + "want approach at lower 1 0.5\n", "expected the name of the body of the second point");
  sketches::tells(text + "want approach at lower 1 0.5 upper 1 2 200 %\n", "expected a tolerance");
}
