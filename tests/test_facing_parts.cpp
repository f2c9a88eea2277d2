// Which parts of the sides of a sketch face each other and may touch, from the shapes: against closed forms, and the same in
// equivalent drawings.
#include "dice.hpp"
#include "effort.hpp"
#include "program/commands/drawn_words.hpp"
#include "program/estimate/loop.hpp"
#include "sketch_runs.hpp"

#include <doctest/doctest.h>

#include <cstdio>

using namespace sketch_test;

namespace {

const double kSin50 = std::sin(50 * std::acos(-1.0) / 180);

// A block of a width and a height whose top is y = 0.
std::string block(double w, double h) {
  return "parameter w " + std::to_string(w) + " h " + std::to_string(h) +
         "\nbody block E 1000 nu 0.3\nfrom {-w/2} -h\nline bottom to {w/2} -h\nline right to {w/2} 0\nline top to {-w/2} 0\n"
         "line left close\n";
}

// A whole circle on a block.
std::string roller(double w, double h, const std::string& sides = "block.top roller.rim", const std::string& body = "rigid") {
  return block(w, h) + "parameter R 1 P 1 x 0\nbody roller " + body + "\ncircle rim centre x R radius R\ncontact " + sides +
         "\nfix block.bottom\n";
}

const sketch::Contact& only(const sketch::Reading& drawn) {
  for (const sketch::Fault& fault : drawn.faults) MESSAGE(fault.text);
  REQUIRE(drawn.faults.empty());
  REQUIRE(drawn.sketch.contacts.size() == 1);
  return drawn.sketch.contacts[0];
}

double length_of(const sketch::Contact::Strip& strip) { return strip.to - strip.from; }

std::string fault_of(const std::string& text) {
  const sketch::Reading drawn = read_text(text);
  REQUIRE(drawn.faults.size() == 1);
  return drawn.faults[0].text;
}

} // namespace

TEST_CASE("facing parts: a whole circle on a block, of any size, in either order") {
  for (const char* sides : {"block.top roller.rim", "roller.rim block.top"})
    for (const double R : {1e-6, 1e-3, 0.3, 1.0, 30.0, 1e5}) {
      CAPTURE(R);
      const sketch::Reading drawn = read_text(roller(10, 4, sides) + "drive roller about 0 R x 0 turn 0 fy -P\n", {{"R", R}});
      const sketch::Contact& contact = only(drawn);
      CHECK(contact.side[1].body == 0); // a rigid body holds no pairs
      const double half = std::min(R * kSin50, 5.0);
      CHECK((contact.side[1].from + contact.side[1].to) / 2 == doctest::Approx(10 + 4 + 5).epsilon(1e-9)); // below the centre
      CHECK(length_of(contact.side[1]) == doctest::Approx(2 * half).epsilon(1e-6));
      CHECK(length_of(contact.side[0]) == doctest::Approx(1.1 * 2 * R * std::asin(half / R)).epsilon(1e-5));
      const sketch::Mesh mesh = sketch::first_mesh(drawn.sketch, 1);
      CHECK(sketch::deck_of(drawn.sketch, mesh).find("*ZONE BODIES 2 1 ") != std::string::npos);
    }
}

TEST_CASE("facing parts: units and mirrors cut at the same places") {
  const std::string text = block(10, 4) + "parameter u 1 m 1\nbody cam E 1000 nu 0.3\nellipse rim centre {m*u} {1.2*u} axes "
                                          "{2*u} {u} tilt {15*m}\ncontact block.top cam.rim\nfix block.bottom\n";
  const auto of = [&](double u, double m) { return only(read_text(text, {{"u", u}, {"m", m}, {"w", 10 * u}, {"h", 4 * u}})); };
  const sketch::Contact one = of(1, 1), large = of(1000, 1), mirrored = of(1, -1);
  for (size_t side = 0; side < 2; ++side) {
    CHECK(large.side[side].from / 1000 == doctest::Approx(one.side[side].from).epsilon(1e-6));
    CHECK(large.side[side].to / 1000 == doctest::Approx(one.side[side].to).epsilon(1e-6));
    CHECK(length_of(mirrored.side[side]) == doctest::Approx(length_of(one.side[side])).epsilon(1e-6));
  }
  // Of the top, from x = 5 to -5: what lies under the ellipse, left and right.
  const double begin = 10 + 4;
  CHECK(mirrored.side[0].from - begin == doctest::Approx(begin + 10 - one.side[0].to).epsilon(1e-6));
}

// A rigid cylinder: p0 = sqrt(P E* / (pi R)).
TEST_CASE("facing parts: the pressure under a whole circle is that of Hertz, from narrow to wide") {
  for (const double R : {0.1, 1.0, 10.0}) {
    const double w = 40, P = 1e-3 * 1000 * std::min(R, w), pi = std::acos(-1.0), stiffness = 1000 / (1 - 0.09);
    const Solution s = solve(read_text(roller(w, 40) + "drive roller about 0 R x 0 turn 0 fy -P\n", {{"R", R}, {"P", P}}), {6});
    REQUIRE_MESSAGE(s.error.empty(), s.error);
    CHECK(at_peak(s.last()).tn == doctest::Approx(std::sqrt(P * stiffness / (pi * R))).epsilon(0.02));
  }
}

TEST_CASE("facing parts: pairs are on the side that nothing holds, or end beside what holds it") {
  const std::string strip =
      "body strip E 1000 nu 0.3\nfrom 0 0\nline under to 8 0\nline tip to 8 1\nline top to 0 1\nline root "
      "close\nfix strip.root\npressure strip.top 1\nfix block.bottom\n";
  const sketch::Reading one = read_text(block(40, 10) + strip + "contact block.top strip.under mu 0.2\n");
  CHECK(only(one).side[1].body == 0);
  CHECK_FALSE((only(one).is_supported[0] || only(one).is_supported[1]));
  const Solution free = solve(one);
  REQUIRE_MESSAGE(free.error.empty(), free.error);
  // Held where its end lies in the corner of a wall that holds the strip, too: the pairs end an element before.
  const sketch::Reading both =
      read_text(block(16, 10) + strip + "contact block.top strip.under mu 0.2\nfix block.right\n", {{"w", 16}});
  CHECK(only(both).side[1].body == 1);
  CHECK((only(both).is_supported[0] || only(both).is_supported[1]));
  const Solution held = solve(both);
  REQUIRE_MESSAGE(held.error.empty(), held.error);
  CHECK(std::fabs(held.zones[0].force[1] / 8 - 1) < 0.5);
}

TEST_CASE("facing parts: sides that cannot face are named by their curves") {
  const std::string lid = "body lid E 1000 nu 0.3\nfrom -2 1\nline under to 2 1\nline side to 2 3\nline top to -2 3\nline edge "
                          "close\nfix block.bottom\nfix lid.edge\n";
  const std::string text = block(10, 4) + lid;
  CHECK(fault_of(text + "contact block.top lid.top\n") == "no part of block.top faces lid.top: their outward normals point the "
                                                          "same way; their smallest distance is 3 at (1.875, 0)");
  CHECK(fault_of(text + "contact block.top lid.side\n").find("inclined to each other by 90 degrees") != std::string::npos);
  CHECK(fault_of(block(1, 4) + "body lid E 1 nu 0\nfrom 9 1\nline under to 10 1\nline side to 10 3\nline top to 9 3\nline edge "
                               "close\nfix block.bottom\nfix lid.edge\ncontact block.top lid.under\n")
            .find("they lie beside each other, or farther apart than their radii of curvature, or another curve lies between "
                  "them") != std::string::npos);
}

TEST_CASE("facing parts: a load of zero, adhesion as a value, and what a drawing's digits overlap are no faults") {
  const std::string text = roller(40, 10) + "parameter mu 0 d 0\ncase normal\ndrive roller about 0 R x 0 fy -P turn 0\ncase "
                                            "shift\ndrive roller about 0 R x d\nhistory normal 1; shift 1\n";
  const Solution still = solve(read_text(text)), moved = solve(read_text(text, {{"d", 1e-12}}));
  REQUIRE_MESSAGE(still.error.empty(), still.error);
  CHECK(at_peak(still.last()).tn == doctest::Approx(at_peak(moved.last()).tn).epsilon(1e-6));
  CHECK(sketch::deck_of(read_text(text).sketch, sketch::first_mesh(read_text(text).sketch, 1)).find("*CASES") ==
        std::string::npos);

  const std::string first =
      "parameter mu 0.3\n" + roller(40, 10, "block.top roller.rim mu mu") + "drive roller about 0 R x 0 fy -P turn 0\n";
  const sketch::Reading adheres = read_text(first, {{"mu", HUGE_VAL}});
  REQUIRE(adheres.faults.empty());
  CHECK(sketch::deck_of(adheres.sketch, sketch::first_mesh(adheres.sketch, 1)).find("*FRICTION\n1 INF\n") != std::string::npos);

  const std::string two = block(200, 100) +
                          "parameter e 0\nbody up E 1000 nu 0.3\nfrom -50 -e\nline bottom to 50 -e\nline rr to "
                          "50 100\nline tp to -50 100\nline ll close\ncontact block.top up.bottom mu 0.3\nfix "
                          "block.bottom\nplaten up.tp about 0 100 x 0 y -0.5 turn 0\n";
  const Solution exact = solve(read_text(two));
  REQUIRE_MESSAGE(exact.error.empty(), exact.error);
  for (const double e : {1e-9, 1e-6, 9e-4}) {
    const Solution s = solve(read_text(two, {{"e", e}}));
    REQUIRE_MESSAGE(s.error.empty(), s.error);
    CHECK(s.zones[0].force[1] == doctest::Approx(exact.zones[0].force[1]).epsilon(1e-6 + e / 50)); // (it is higher by e)
  }
}

// Squeezed between flat covers; nu = 0.5 is the limit that nu -> 0.5 goes to.
TEST_CASE("facing parts: an incompressible ring between rigid covers") {
  const std::string text =
      "parameter R 2 sq 0.4 nu 0.5\nsymmetry x 0\nbody ring E 5 nu nu\nfrom 0 0\narc low to R R centre 0 R\n"
      "arc up to 0 {2*R} centre 0 R\nbody floor rigid\nfrom 0 -2\nline u to 4 -2\nline v to 4 0\nline face "
      "to 0 0\nbody cover rigid\nfrom 0 {2*R}\nline face to 4 {2*R}\nline v to 4 {2*R+2}\nline u to 0 "
      "{2*R+2}\ncontact floor.face ring.low\ncontact cover.face ring.up\ndrive cover about 0 {2*R} x 0 y "
      "-sq turn 0\n";
  const Solution limit = solve(read_text(text), {4}), near = solve(read_text(text, {{"nu", 0.49999}}), {4});
  REQUIRE_MESSAGE(limit.error.empty(), limit.error);
  CHECK(std::fabs(limit.zones[0].force[1]) == doctest::Approx(0.50274).epsilon(0.02)); // a deck of its own mesh
  CHECK(limit.zones[0].force[1] == doctest::Approx(near.zones[0].force[1]).epsilon(1e-3));
  CHECK(limit.zones[0].force[1] == doctest::Approx(-limit.zones[1].force[1]).epsilon(1e-6));
}

TEST_CASE("facing parts: messages about a mesh name curves") {
  const std::string deck =
      "! curve of body 1: block.top, elements 5 to 9, nodes 5 to 10\n! curve of body 2: pad.tip, elements 1 "
      "to 4, nodes 1 to 5\n";
  const auto words = [&](const std::string& text) { return app::in_words_of_drawing(text, deck); };
  CHECK(words("strains reach 0.055 at element 7 of body 1 (block): small") == "strains reach 0.055 at block.top: small");
  CHECK(words("pair 3 (on element 6 of body 1 (block), node 2 of body 2 (pad)): x") == "block.top and pad.tip: x");
  CHECK(words("zone 1 (a on b), pair 15, load factor 1") == "zone 1 (a on b), load factor 1");
  CHECK(words("moved sideways by 0.00186, 3.9 elements, most of it before they touched, but") ==
        "moved sideways by 0.00186, most of it before they touched, but");
  CHECK(words("node 99 of body 1 stays") == "node 99 of body 1 stays");
}

TEST_CASE("facing parts: warnings say what they mean for the model, and nothing of a mesh") {
  const auto words = [&](const std::string& text) { return app::in_words_of_drawing(text, ""); };
  CHECK(words("zone 1, pair 8, load factor 1: coarse contact: only 2 elements between the contact edge and the highest "
              "pressure; the edge "
              "is uncertain by 0.1 (12 % of the width), this pressure by 5 %; the last element before the corner at pair 8 "
              "carries 5 % "
              "of the force, and the pressure rises there to 4.2 times that of the next element; it may be unbounded: refine "
              "the mesh there") ==
        "zone 1, load factor 1: at a corner of the contact the pressure rises to 4.2 times the pressure beside it and may be "
        "unbounded: do not use the highest pressure there; forces and pressures farther away are correct");
  CHECK(words("slip since it last touched exceeds half a contact element and 5 % of the contact length: its nodes "
              "no longer face each "
              "other") ==
        "slip since it last touched exceeds 5 % of the contact length: pressures act at the positions before slip; "
        "moments and stresses have about the same relative error");
  CHECK(words("between the nodes of side 2 the bodies overlap by 0.1 at (1, 2): contact conditions are enforced at the nodes "
              "of side 2 "
              "only; refine side 2 there") ==
        "in contact the bodies overlap by 0.1 at (1, 2), and the pressure has an error there; use a smaller tolerance");
  const auto is_about_mesh = [](int32_t number, const char* text) {
    c2d_error warning = C2D_INIT(c2d_error);
    warning.status = number;
    std::snprintf(warning.text, sizeof warning.text, "%s", text);
    return app::is_about_mesh(warning);
  };
  CHECK(is_about_mesh(C2D_WARN_LEFT_OUT, ""));
  CHECK_FALSE(is_about_mesh(C2D_WARN_STRAIN, ""));
  CHECK(is_about_mesh(C2D_WARN_FEW_PAIRS, "coarse contact: the slip zone of pairs 7 to 7 is only 1 element wide"));
  CHECK_FALSE(is_about_mesh(C2D_WARN_FEW_PAIRS, "coarse contact: and the pressure rises there to 4.2 times that of the next"));
}

namespace {

app::Stated stated(const sketch::Reading& drawn, const std::string& name) {
  REQUIRE(drawn.faults.empty());
  const estimate::Adapted found = estimate::adapt(drawn.sketch, {}, [](const app::MeshRound&) {});
  REQUIRE_MESSAGE(found.status == C2D_OK, found.why);
  CHECK_MESSAGE(found.loop.stopped.empty(), found.loop.stopped);
  for (const app::Stated& s : found.loop.stated)
    if (s.name() == name) return s;
  FAIL("no number is called " << name);
  return {};
}

} // namespace

// The lowest point of a circle is where its outline begins: what lies far from the contact is left out round that, too.
TEST_CASE("facing parts: forces are those on the second side of the statement, whichever is rigid") {
  for (const bool rigid : {true, false})
    for (const bool roller_first : {true, false}) {
      CAPTURE(rigid);
      CAPTURE(roller_first);
      const std::string text =
          roller(10, 4, roller_first ? "roller.rim block.top" : "block.top roller.rim", rigid ? "rigid" : "E 1000 nu 0.3") +
          (rigid ? "drive roller about 0 R x 0 turn 0 fy -P\n" : "force roller at 0 R fx 0 fy -P\n") + "tolerance 10 %\n";
      const app::Stated force = stated(read_text(text), "force y");
      CHECK(force.value == doctest::Approx(roller_first ? -1 : 1).epsilon(1e-6));
    }
}

TEST_CASE("facing parts: a shaft in a hole of its size touches on one half, wherever their outlines begin") {
  for (const double from : {-90.0, 0.0, 90.0}) {
    const sketch::Reading drawn = read_text(
        "parameter a 0\nbody shaft rigid\ncircle rim centre 0 0 radius 1\nbody hub E 1000 nu 0.3\ncircle out centre 0 0 radius "
        "2\nhole\ncircle bore centre 0 0 radius 1 from a\ncontact shaft.rim hub.bore\nfix hub.out\ndrive shaft about 0 0 x 0 "
        "turn 0 fy -1\nwant forces 5 % pressure 10 %\n",
        {{"a", from}});
    CHECK(stated(drawn, "force y").value == doctest::Approx(-1).epsilon(1e-6));
  }
}

// A smooth rigid punch that a force off its centre tilts: of its half width 1 it touches the last 2 (1 - e).
TEST_CASE("facing parts: a punch that tilts off a coarse mesh is solved on a finer one") {
  const sketch::Reading drawn =
      read_text(block(200, 100) + "parameter e 0.9\nbody punch rigid\nfrom -1 0\nline flat to 1 0\nline side to 1 "
                                  "1\nline lid to -1 1\nline side close\ncontact block.top punch.flat\nfix "
                                  "block.bottom\ndrive punch about 0 0 x 0 fy -1 moment -e\nwant edges 3 %\n",
                {{"w", 200}});
  const app::Stated edge = stated(drawn, "contact edge");
  CHECK(std::fabs(edge.at[0] - 0.6) < edge.error + 0.002);
}

// Of a pad whose flat goes on smoothly in an arc, of one that ends at corners, of a block beside a wall that holds it.
TEST_CASE("facing parts: curves that contact may reach are named, and none where surfaces end") {
  const auto deck = [](const std::string& pad, const std::string& more = "") {
    const sketch::Reading drawn =
        read_text(block(40, 10) + "body pad E 1000 nu 0.3\nfrom -5 0\nline flat to 5 0\n" + pad +
                      "line left close\ncontact block.top pad.flat\nfix block.bottom\npressure pad.lid 1\n" + more,
                  {{"w", 40}});
    REQUIRE(drawn.faults.empty());
    return sketch::deck_of(drawn.sketch, sketch::first_mesh(drawn.sketch, 1));
  };
  const std::string corners = deck("line right to 5 4\nline lid to -5 4\n"),
                    toe = deck("arc toe to 7 2 centre 5 2\nline right to 7 4\nline lid to -5 4\n");
  c2d_error warning = C2D_INIT(c2d_error);
  warning.status = C2D_WARN_ZONE_END, warning.zone = 1;
  CHECK(app::is_at_natural_end(warning, corners));
  CHECK_FALSE(app::is_at_natural_end(warning, toe));
  CHECK(app::in_words_of_drawing(
            "zone 1 (top on flat), pair 9, load factor 1: the last pair at an end of a contact zone is closed: the "
            "contact may extend beyond the zone; lengthen it",
            toe) == "zone 1 (top on flat), load factor 1: contact reaches the end of the facing parts and may extend beyond "
                    "it: pad.flat ends at (5, 0), but pad.toe continues it smoothly: add this curve to the side");
}

TEST_CASE("facing parts: a sharp corner on a flat is refused as one") {
  const std::string text = block(10, 4) + "body wedge E 1000 nu 0.3\nfrom 0 0\nline skin to 1 2\nline lid to -1 2\nline skin "
                                          "close\ncontact block.top wedge.skin\nfix block.bottom\nfix wedge.lid\n";
  CHECK(fault_of(text).find("their smallest distance is 0 at (0, 0), a corner; add a fillet if contact is expected there") !=
        std::string::npos);
}

TEST_CASE("facing parts: two parts that meet at a place of the other side are cut there once") {
  // the ends of both are found by bisection, and differ in the last digits
  const sketch::Reading drawn = read_text(R"(
symmetry x 0
body plate E 1000 nu 0.3
  from 0 -5
  line foot to 30 -5
  line side to 30 0
  line top to 0 0
body bridge E 1000 nu 0.3
  from 0 2
  line under to 10 2
  line inner to 10 0.01
  line pad to 14 0.01
  line outer to 14 4
  line lid to 0 4
contact plate.top bridge.pad mu 0.3
contact plate.top bridge.under mu 0.3
fix plate.foot
traction bridge.lid fx 0 fy -0.02
tolerance 3 %
)");
  REQUIRE(drawn.faults.empty());
  const estimate::Adapted a = estimate::adapt(drawn.sketch, {}, [](const app::MeshRound&) {});
  REQUIRE_MESSAGE(a.status == C2D_OK, a.why);
  CHECK_MESSAGE(a.loop.stopped.empty(), a.loop.stopped);
  for (const sketch::MeshedOutline& outline : a.mesh.bodies[0])
    for (const sketch::MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e)
        CHECK(sketch::length(curve.curve->shape->at(curve.ends[e + 1]) - curve.curve->shape->at(curve.ends[e])) > 1e-6);
  // Contact stays away from the ends that were cut off.
  CHECK(a.deck.find("on coarser meshes the surfaces did not touch") == std::string::npos);
}

namespace {

std::string digits(double x) {
  char out[32];
  std::snprintf(out, sizeof out, "(%.17g)", x);
  return out;
}

// Two wavy surfaces. `near`: they just do not touch; else at any distance, also beyond their centres of curvature.
std::string waves(random_decks::Dice& dice, bool near) {
  const double most = near ? 0.1 : 0.25, a = dice.between(0, most), b = dice.between(0, most);
  const double k = dice.between(1, 9), l = dice.between(1, 9), from = dice.between(0, 6), begin = dice.between(0, 6);
  double touch = -1;
  for (int i = 0; i <= 3000; ++i) {
    const double t = -1.5 + 0.001 * i;
    touch = std::max(touch, a * std::cos(k * t + from) - b * std::cos(l * t + begin));
  }
  const double high = near ? touch + dice.between(0, 0.02) : 0.5 + dice.between(0.02, 0.4);
  const auto wave = [](double mean, double height, double number, double phase, const char* t) {
    return "{" + digits(mean) + "+" + digits(height) + "*cos(" + t + "*" + digits(number) + "+" + digits(phase) + ")}";
  };
  return "body below E 1000 nu 0\nfrom -2 -1\nline foot to 2 -1\nline right to 2 " + wave(0, a, k, from, "2") +
         "\ncurve n t 2 -2 x {t} y " + wave(0, a, k, from, "t") + "\nline left close\nbody above E 1000 nu 0\nfrom 1.5 3\n" +
         "line top to -1.5 3\nline left to -1.5 " + wave(high, b, l, begin, "(-1.5)") + "\ncurve s t -1.5 1.5 x {t} y " +
         wave(high, b, l, begin, "t") + "\nline right close\n" +
         (dice.chance(0.5) ? "contact below.n above.s mu 0.2\n" : "contact above.s below.n mu 0.2\n") +
         "fix below.foot\ncase push\nmove above.top x 0 y -0.01\nhistory push 1\ntolerance off\n";
}

} // namespace

TEST_CASE("facing parts: waves at any distance: points advance against each other, and the mesh faces where the shapes do") {
  for (int seed = 1; seed <= test::effort(1, 100); ++seed)
    for (const bool near : {true, false}) {
      random_decks::Dice dice(static_cast<uint64_t>(seed));
      const std::string text = waves(dice, near);
      CAPTURE(text);
      const sketch::Reading drawn = read_text(text);
      for (const sketch::Fault& fault : drawn.faults) FAIL_CHECK(fault.text);
      if (near) CHECK(!drawn.sketch.contacts.empty());
      for (const sketch::Contact& contact : drawn.sketch.contacts)
        for (size_t i = 1; i < contact.map.size(); ++i) {
          CHECK(contact.map[i][0] <= contact.map[i - 1][0] + 1e-7);
          CHECK(contact.map[i][1] >= contact.map[i - 1][1] - 1e-7);
        }
      const Solution s = solve(drawn);
      CHECK_MESSAGE(s.error.empty(), s.error);
    }
}
