// Loads that move, at the ends of their statements: several in one case, components alone, closed courses, cycles of courses.
#include "program/sketch/deck/idle_cases.hpp"
#include "program/sketch/moving.hpp"
#include "sketches.hpp"

#include <algorithm>
#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

// Two blocks, one on the other: 13 lines.
const std::string kTwo = "body b E 100 nu 0.3\nfrom -3 -1\nline s to 3 -1\nline e to 3 0\nline n to -3 0\nline w close\n"
                         "body c E 100 nu 0.3\nfrom -3 0\nline s to 3 0\nline e to 3 1\nline n to -3 1\nline w close\n"
                         "tie c.s b.n\nfix b.s\n";
const char kMoves[] = "history roll 1; roll to 1\n";

const BodyForce* weight_of(const Sketch& s, int body, int load_case) {
  for (const BodyForce& f : s.body_forces)
    if (f.body == body && f.load_case == load_case) return &f;
  return nullptr;
}

const Drive* drive_of(const Sketch& s, const std::string& curve, int load_case) {
  for (const Drive& d : s.drives)
    if (d.side->has(curve) && d.load_case == load_case) return &d;
  return nullptr;
}

} // namespace

TEST_CASE("moving loads: weights and platens of several loads add up, each for its body and curves") {
  const std::vector<double> share = {1, 2, 0, 3};
  const Sketch s =
      with_positions(sound(kTwo +
                           "case roll round 0 0 positions 3 loads 4 shares 1 2 0 3\nweight b fy -1\nweight c fx 2\n"
                           "platen c.n about 0 1 fx 1 fy 2 moment 3\nplaten c.e about 3 1 x 0.1 y 0.2 turn 0.5\n" +
                           kMoves));
  REQUIRE(s.cases.size() == 12);
  for (int k = 0; k < 12; ++k) {
    CAPTURE(k);
    Point b, c, load, motion;
    double moment = 0, turn = 0;
    for (int i = 0; i < 4; ++i) {
      const double angle = std::acos(-1.0) / 2 * (k / 3.0 + i), f = share[static_cast<size_t>(i)];
      const auto turned = [&](double x, double y) {
        return f * Point{std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y};
      };
      b = b + turned(0, -1), c = c + turned(2, 0), load = load + turned(1, 2), motion = motion + turned(0.1, 0.2);
      moment += 3 * f, turn += 0.5 * f;
    }
    REQUIRE(weight_of(s, 0, k) != nullptr);
    REQUIRE(weight_of(s, 1, k) != nullptr);
    CHECK(length(weight_of(s, 0, k)->weight - b) < 1e-12);
    CHECK(length(weight_of(s, 1, k)->weight - c) < 1e-12);
    const Drive *const n = drive_of(s, "n", k), *const e = drive_of(s, "e", k);
    REQUIRE(n != nullptr);
    REQUIRE(e != nullptr);
    CHECK(length(Point{*n->load[0], *n->load[1]} - load) < 1e-12);
    CHECK(*n->load[2] == doctest::Approx(moment));
    CHECK_FALSE(n->motion[0].has_value());
    CHECK(length(Point{*e->motion[0], *e->motion[1]} - motion) < 1e-12);
    CHECK(*e->motion[2] == doctest::Approx(turn));
    CHECK_FALSE(e->load[2].has_value());
  }
  CHECK(s.body_forces.size() == 24);
  CHECK(s.drives.size() == 24);
}

TEST_CASE("moving loads: one component alone, and what it lacks") {
  const auto fault_at_17 = [](const std::string& words, const std::string& load, const std::string& told) {
    CAPTURE(load);
    tells(kTwo + "case roll " + words + "\n" + load + "\n" + kMoves, told);
  };
  // A traction along y alone is a load as one along x is.
  const Sketch along_y =
      with_positions(sound(kTwo + "case roll travel 2 0 positions 4\ntraction c.n fy {exp(-(x + 1)^2)}\n" + kMoves));
  const Condition& last = along_y.conditions.back();
  CHECK(last.load_case == 4);
  CHECK(last.value_at({1.5, 1}).y == doctest::Approx(std::exp(-0.25)));
  CHECK(last.value_at({1.5, 1}).x == 0);
  fault_at_17("travel 9 0 positions 4", "traction c.n fy {max(0, 1 - x^2)}",
              "16:1 the load has left its curves at position 3 of 5");
  fault_at_17("travel 2 0 positions 4", "traction c.n fx 1 fy {sqrt(x + 4)}",
              "16:1 the formula has no finite value on its curves at position 4 of 5");
  fault_at_17("travel 2 0 positions 4", "move c.n y 0.1", "16:1 a displacement does not move");
  fault_at_17("round 0 0 positions 4", "platen c.n about 0 1 x 0.1", "16:1 what turns has two components");
  fault_at_17("round 0 0 positions 4", "platen c.n about 0 1 fx 0.1", "16:1 what turns has two components");
  fault_at_17("round 0 0 positions 4", "platen c.n about 0 1 moment 1", "16:1 what turns has two components");
  fault_at_17("round 0 0 positions 4", "spin c 1", "16:1 of the loads of a body its weight can turn");
  // One that no place of the first position sees may be too narrow for the places looked at.
  CHECK(read(kTwo + "case roll travel 0.5 0 positions 4\npressure c.n {max(0, 1 - (1e6*(x + 1.001))^2)}\n" + kMoves)
            .faults.empty());
}

TEST_CASE("moving loads: words that are missing or wrong on the statements of courses") {
  const std::string load = "pressure c.n {exp(-x^2)}\n", travels = "case roll travel 2 0 positions 4\n";
  CHECK(read(kTwo + "case roll round 0 0 positions 4 loads 3 shares none\n" + load + kMoves)
            .faults.front()
            .text.find("expected a share for each load") != std::string::npos);
  tells(kTwo + travels + load + "history roll 1; roll to -0.5\n", "17:25 -0.5: expected a part of the course, from 0 to 1");
  tells(kTwo + travels + load + kMoves + "case push\ncase push round 0 0 positions 3\n", "19:11 'round' is not expected here");
  tells("axisymmetric\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nfix b.s\n"
        "case roll travel 0 0.1 positions 4\nplaten b.n fy 1\n" +
            std::string(kMoves),
        "the loads of a rigid part can turn, not travel");
  tells("case roll round 0 0 positions 4\naxisymmetric\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\n"
        "line n to 0 1\nfix b.s\npressure b.n {x}\n" +
            std::string(kMoves),
        "1:1 loads of a body of revolution do not go round in its half section");
  // A curve that is faulty has its fault where it is drawn.
  const Reading faulty = read("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\narc n to 0 0 radius 0.1\nline w close\nfix b.s\n"
                              "case roll along b.n positions 4\npressure b.s {x}\n" +
                              std::string(kMoves));
  REQUIRE_FALSE(faulty.faults.empty());
  CHECK(faulty.faults.front().at.line == 4);
}

TEST_CASE("moving loads: a course along a closed curve returns, one along an open curve does not") {
  const std::string disc = "body b E 1 nu 0\ncircle rim centre 0 0 radius 2\nhole\ncircle bore centre 0 0 radius 1\nfix b.rim\n"
                           "case roll along b.bore positions 6\npressure b.bore {exp(x)}\n";
  const Sketch s = sound(disc + "history roll 1; roll to 2.5\n");
  CHECK(s.cases[0].course->returns());
  CHECK(with_positions(s).cases.size() == 6);
  CHECK(with_positions(s).pieces == 16);
  // Sixteen positions of the same circle turn about its centre by 2.5 turns: against the sense of the bore's outline.
  const Sketch moved = with_positions(s);
  const auto value = [&](int load_case, Point at) {
    for (const Condition& c : moved.conditions)
      if (c.load_case == load_case && c.kind == Condition::kPressure) return c.value_at(at).x;
    return std::nan("");
  };
  CHECK(value(3, {-1, 0}) == doctest::Approx(std::exp(1.0)).epsilon(1e-6));
  CHECK(value(3, {0, 1}) == doctest::Approx(1).epsilon(1e-6));
}

TEST_CASE("moving loads: cycles of courses that close, that do not, and that ask for digits") {
  const std::string round = kTwo + "case press\npressure c.n 1\ncase roll round 0 0 positions 4\ntraction c.e fx 1\n";
  const Sketch own = sound(round + "history press 1; roll 1\ncycle roll to 1 until steady digits 7\n");
  REQUIRE(own.cycle.has_value());
  CHECK(own.cycle->digits == 7);
  CHECK(own.cycle->before == 2);
  CHECK(sound(round + "history press 1; roll 1\ncycle roll to 1 until steady\nwant walk 5 %\n").wants.size() == 1);
  const Sketch set = sound(round + "history press 1; roll 1\ncycle roll to 1 until steady\n");
  CHECK(set.cycle->digits == 5);
  const Sketch first =
      sound(kTwo + "case roll round 0 0 positions 4\ntraction c.e fx 1\ncycle roll 1; roll to 1 until steady\n");
  CHECK(first.cycle->before == 1);
  tells(round + "history press 1; roll 1\ncycle roll to 0.3, 0.5 until steady\n", "the cycle does not close");
  tells(round + "history press 1; roll 1\ncycle roll to 0.3 until steady\n", "the cycle has no other loads");
  const std::string travel = kTwo + "case roll travel 2 0 positions 4\npressure c.n {exp(-(x + 1)^2)}\n";
  tells(travel + "history roll 1\ncycle roll to 0.5, 1 until steady\n", "the cycle does not close");
  CHECK(sound(travel + "history roll 1\ncycle roll to 1, 0 until steady\n").cycle->before == 1);
  const std::string still = kTwo + "case press\npressure c.n 1\n";
  tells(still + "history press 0.5\ncycle press 0.5, 0.5 until steady\n", "the cycle has no other loads");
  tells(still + "history press 0.5\ncycle press 0.5 until steady\n", "the cycle has no other loads");
}

TEST_CASE("sketch: cases without loads leave the deck, and what they moved goes on in the others") {
  const std::string rigid = "body c rigid\nfrom -1 0\nline s to 1 0\nline e to 1 1\nline n to -1 1\nline w close\n"
                            "body d rigid\nfrom 4 0\nline s to 5 0\nline e to 5 1\nline n to 4 1\nline w close\n"
                            "body b E 100 nu 0.3\nfrom -3 -1\nline s to 6 -1\nline e to 6 0\nline n to -3 0\nline w close\n"
                            "contact c.s b.n\ncontact d.s b.n\nfix b.s\n";
  // `rest` moves nothing: its statements join those of the first case, for each body alone.
  const std::string text = rigid + "case push\ndrive c fy -1\ndrive d fy -2\ncase rest\ndrive c fy 0\ndrive d fy 0\n"
                                   "case shear\ndrive c fx 1 fy 0\nhistory push 1; rest 1; shear 1\n";
  const Sketch all = sound(text), left = without_idle_cases(all);
  REQUIRE(all.cases.size() == 3);
  REQUIRE(left.cases.size() == 2);
  CHECK(left.drives.size() == 3);
  for (const Drive& d : left.drives) CHECK(d.load[1].has_value());
  CHECK(*left.drives[0].load[1] == -1);
  CHECK(*left.drives[1].load[1] == -2);
  CHECK(deck_of(all, first_mesh(all, 1)).find("*CASES 2") != std::string::npos);
  // Forces and weights of one component alone act.
  const std::string held = std::string(kSquare) + "fix b.s\n";
  for (const char* load : {"force b at 0.5 0.5 fx 0 fy -1\n", "weight b fx 0 fy -1\n", "spin b 1\n"}) {
    CAPTURE(load);
    CHECK(acts(sound(held + load), 0));
  }
  CHECK_FALSE(acts(read(held + "force b at 0.5 0.5 fx 0 fy 0\nweight b fx 0 fy 0\n").sketch, 0));
  // Where no case acts, the first stays.
  const Sketch idle = sound(held + "case one\ncase two\nmove b.n x 0\nhistory one 1; two 1\n");
  CHECK(without_idle_cases(idle).cases.size() == 1);
  CHECK(without_idle_cases(sound(held + "pressure b.n 1\n")).cases.size() == 1);
}
