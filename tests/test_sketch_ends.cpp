// Sketches at the ends of what their parser, their shapes and their zones take: formulas and lengths where a curve halts, lines
// of symmetry on either side, sides that adjoin, wrap round an outline's begin or lie on rigid bodies.
#include "problem.hpp"
#include "program/sketch/deck/zones.hpp"
#include "program/sketch/refine.hpp"
#include "program/sketch/shapes/region.hpp"
#include "sketches.hpp"

#include <algorithm>
#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

const double kPi = std::acos(-1.0);
const std::string kHeld = std::string(kSquare) + "fix b.s\n"; // 7 lines
const std::string kBegun = "body b E 1 nu 0\nfrom 0 0\n";

Expression formula_of(const std::string& text, const std::string& variable = "t") {
  return Expression(Word{text, {}, false}, {}, {variable, ""});
}
ShapePtr curve_of(const char* x, const char* y) { return formula(formula_of(x), formula_of(y), 0, 1); }

bool has_card(const std::string& deck, const std::string& card) { return deck.find("\n" + card + "\n") != std::string::npos; }

// A block of a name and a width from x0 to x1, its curves named for their sides; below y 0, or above it.
std::string block(const std::string& name, double x0, double x1, bool above, const std::string& face) {
  const std::string a = show(x0), b = show(x1), y = above ? "1" : "-1";
  if (above)
    return "body " + name + " E 1 nu 0\nfrom " + a + " 0\n" + face + "line r to " + b + " 1\nline top to " + a +
           " 1\nline l close\n";
  return "body " + name + " E 1 nu 0\nfrom " + a + " " + y + "\nline s to " + b + " " + y + "\nline r to " + b + " 0\n" + face +
         "line l close\n";
}

// Every node of a body is in one pair at most: elements of second sides are in one zone each.
void share_nothing(const std::vector<Zone>& zones) {
  std::vector<std::pair<int, int>> seen; // body and element
  for (const Zone& zone : zones) {
    const int body = zone.contact->side[1].body;
    for (int e = zone.two.first; e <= zone.two.last; ++e) {
      CHECK(std::count(seen.begin(), seen.end(), std::pair(body, e)) == 0);
      seen.push_back({body, e});
    }
  }
}

} // namespace

TEST_CASE("sketch: derivatives where a formula has none of the first order, and powers of 0 and 1") {
  const struct {
    const char* text;
    double v, d, dd; // at t = 0
  } cases[] = {{"2^(t^2)", 1, 0, 2 * std::log(2.0)},
               {"(1+t)^0", 1, 0, 0},
               {"(1+t)^1", 1, 1, 0},
               {"sqrt(1+t^2)", 1, 0, 1},
               {"asin(t^2)", 0, 0, 2},
               {"abs(t+3)", 3, 1, 0},
               {"abs(t-3)", 3, -1, 0}};
  for (const auto& c : cases) {
    CAPTURE(c.text);
    const Jet j = formula_of(c.text).at(0);
    CHECK(j.v == doctest::Approx(c.v));
    CHECK(j.d == doctest::Approx(c.d));
    CHECK(j.dd == doctest::Approx(c.dd));
  }
}

TEST_CASE("sketch: directions, bends and lengths of a curve that halts") {
  const ShapePtr begins = curve_of("t^2", "t^2"), ends = curve_of("1-(1-t)^2", "0*t"), amid = curve_of("(2*t-1)^3", "0*t");
  CHECK(length(begins->tangent(0) - Point{std::sqrt(0.5), std::sqrt(0.5)}) < 1e-12);
  CHECK(length(ends->tangent(1) - Point{1, 0}) < 1e-12);
  CHECK(begins->curvature(0) == 0);
  const Measure measure(amid), slow(curve_of("t^9", "0*t"));
  CHECK(measure.length() == doctest::Approx(2));
  CHECK(measure.u_at(measure.length_to(0.5)) == doctest::Approx(0.5));
  for (const double u : {0.001, 0.1, 0.4, 0.499, 0.501, 0.9})
    CHECK(measure.u_at(measure.length_to(u)) == doctest::Approx(u).epsilon(1e-4));
  for (const double u : {0.004, 0.007, 0.02, 0.3})
    CHECK(slow.length_to(slow.u_at(std::pow(u, 9))) == doctest::Approx(std::pow(u, 9)));
}

TEST_CASE("sketch: fillets that do not fit by a hair, or whose neighbours have no bend") {
  const struct {
    std::string text;
    const char* told;
  } cases[] = {
      {kBegun + "line s to 1 0\nfillet radius 1\nline to 1 2\n", "a fillet of radius 1 does not fit"},
      {kBegun + "line s to 2 0\nfillet radius 1\nline to 2 1\n", "a fillet of radius 1 does not fit"},
      {"body b E 1 nu 0\nfrom 1 0\narc to 0 1 centre 0 0\nfillet radius 1\nline to -1 0\n",
       "a fillet of radius 1 does not fit"},
      {kBegun + "line s to 1 0\nfillet radius 0.1\ncurve t 0 1 x 1+t y sqrt(t)\n", "a fillet of radius 0.1 does not fit"}};
  for (const auto& c : cases) {
    CAPTURE(c.text);
    tells(c.text, c.told);
  }
}

TEST_CASE("sketch: outlines that cross themselves, open amid, or have holes the wrong way round") {
  tells(kBegun + "line s to 2 0\nline e to 2 2\nline n to 0 2\nline w close\nhole\nfrom 0.5 0.5\nline to 1 0.5\nline to 1 1\n"
                 "line close\nfix b.s\n",
        "the hole is drawn counter-clockwise, expected clockwise");
  tells(kBegun + "line s to 1 0\ncurve t 0 1 x 1+0*t y 0*t\nline e to 1 1\nline close\nfix b.s\n", "has length zero");
  tells(kBegun + "line s to 1 0\ncurve t 0 1 x 1 y 0.5+t/2\nline n to 0 1\nline close\nfix b.s\n",
        "the outline is open: curve 's' ends at (1, 0), a curve begins at (1, 0.5); the gap is 0.5");
  tells("body b E 1 nu 0\nspline a through 0 0 2 2 2 0 0 2 closed\nfix b.a\n", "curve 'a' crosses itself near");
  tells("body r rigid\nfrom 0 0\nline a to 1 0\nline c to 1 1\nline close\ncopy q of r shift 0 -1\ncontact r.a q.c\n",
        "both bodies are rigid, expected at least one elastic body");
  // A tie closes what overlaps a little, whichever of the bodies is told first.
  for (const char* tie : {"tie b.n c.s\n", "tie c.s b.n\n"})
    CHECK(read(kHeld + "copy c of b shift 0 0.995\n" + tie).faults.empty());
  tells(kHeld + "copy c of b shift 0 0.995\ncontact b.n c.s\n", "overlap by 0.005");
  // 'from' begins another outline, 'outline' alone none.
  const Sketch two =
      sound(kHeld.substr(0, kHeld.find("fix")) + "from 3 0\nline s to 4 0\nline to 4 1\nline close\noutline\nfix b.s\n");
  CHECK(two.bodies.at(0).outlines.size() == 2);
}

TEST_CASE("sketch: lines of symmetry, with what is drawn on either side of them, on one of two, or in a corner") {
  const auto area = [](const std::string& text) {
    const Sketch s = sound(text);
    return Region(s, s.bodies.at(0)).area();
  };
  const std::string both = "symmetry x 0\nsymmetry y 0\n", material = "body b E 1 nu 0\n";
  CHECK(area(both + material + "from 1 0\narc c to 0 1 centre 0 0\n") == doctest::Approx(kPi / 4).epsilon(1e-3));
  CHECK(area(both + material + "from 3 0\narc c to 1 0 centre 2 0\n") == doctest::Approx(kPi / 2).epsilon(1e-3));
  CHECK(area(both + material + "from 0 1\narc c to 0 3 centre 0 2\n") == doctest::Approx(kPi / 2).epsilon(1e-3));
  CHECK(area(both + material + "from -1 0\narc c to 0 -1 centre 0 0\n") == doctest::Approx(kPi / 4).epsilon(1e-3));
  // A point of the line is in the body, on whichever side that lies; the line's other side is not.
  for (const double side : {1.0, -1.0})
    for (const size_t axis : {size_t{0}, size_t{1}}) {
      CAPTURE(side);
      CAPTURE(axis);
      const std::string half =
          axis == 0 ? (side > 0 ? "from 0 -1\narc c to 0 1 centre 0 0\n" : "from 0 1\narc c to 0 -1 centre 0 0\n")
                    : (side > 0 ? "from 1 0\narc c to -1 0 centre 0 0\n" : "from -1 0\narc c to 1 0 centre 0 0\n");
      const Sketch s = sound((axis == 0 ? "symmetry x 0\n" : "symmetry y 0\n") + material + half + "fix b.c\n");
      REQUIRE(s.bodies[0].outlines[0].open);
      CHECK(Region(s, s.bodies[0]).depth({0, 0}) == doctest::Approx(1));
    }
  // A closed hole in a half, and half a hole.
  const std::string disc = "symmetry y 0\n" + material + "from 3 0\narc out to -3 0 centre 0 0\n";
  CHECK(area(disc + "hole\nfrom 0 2\nline to 0.5 1\nline to -0.5 1\nline close\nfix b.out\n") ==
        doctest::Approx(4.5 * kPi - 0.5).epsilon(1e-3));
  CHECK(area(disc + "hole\nfrom -1 0\narc in to 1 0 centre 0 0 right\nfix b.out\n") == doctest::Approx(4 * kPi).epsilon(1e-3));
  // Beyond the line alone, and what begins upon it and leaves it later.
  CHECK(sound("symmetry x 0\n" + material + "from -2 0\nline s to -1 0\nline to -1 1\nline close\nfix b.s\n")
            .bodies[0]
            .outlines[0]
            .open == false);
  const std::string leaves = fault("symmetry x 0\n" + material +
                                   "curve a t 0 1 x max(0,t-0.6) y -t\nline s to 2 -1\nline to 2 0\nline close\nfix b.s\n");
  CHECK(leaves.find("lies on the line of symmetry") == std::string::npos);
  tells("symmetry y 0\n" + material + "from 0 0\nline s to 1 1\nline to 0 1\nfix b.s\n", "the outline is open");
}

TEST_CASE("sketch: words at the ends of what they may be") {
  tells(kHeld + "fix b.\n", "body 'b' has no curve ''");
  tells("body b E 1 nu 0\nfrom 0 0\nline to 1 0\nline e to 1 1\nline close\nfix b.x\n", "expected 'e'");
  tells("body b E 1 nu 0\nfrom 0 0\nline to 1 0\nline to 1 1\nline close\nfix b.\n", "has no curve ''");
  tells(kHeld + "history \"\" 1\n", "no load case is called ''");
  tells(kHeld + "steps 100001\n",
        "100001: expected the number of steps of each piece of the history, a whole number from 1 to 100000");
  tells(kHeld + "steps 2.5\n", "2.5: expected the number of steps");
  tells("body \"b\" E 1 nu 0\n", "'b': expected the name of a body");
  tells("parameter a .\n" + kHeld, "expected a number in the range of double precision");
  tells("parameter a (sqrt(1 2))\n" + kHeld, "expected a closing bracket");
  tells("parameter a (1 2)\n" + kHeld, "expected a closing bracket");
  tells("title a\x7f b\n" + kHeld, "the title has a character that is not printable ASCII");
  CHECK(sound("title \"a\" b c\n" + kHeld).title == "a b c");
  CHECK(sound("parameter a (1\t+\t0)! tabs\n" + kHeld).bodies.size() == 1);
  const Sketch points = sound(kHeld + "stress b 0.2 0.2 0.3 0.4\n");
  REQUIRE(points.points.size() == 2);
  CHECK((points.points[1].at.x == 0.3 && points.points[1].at.y == 0.4));
  CHECK(is_sketch("! what it is\n\n  ! of whom\nbody b E 1 nu 0\n", "deck"));
  CHECK_FALSE(is_sketch("! what it is\n*FREE\n", "deck"));
  // A circle's part from just before its begin, to round-off, begins there.
  const Sketch part =
      sound("body b E 1 nu 0\ncircle c centre 0 0 radius 1\npart p of c from angle -90.0000000001 to angle 0\nfix b.p\n");
  REQUIRE(part.bodies[0].outlines[0].curves.size() == 2);
  CHECK(Measure(part.bodies[0].outlines[0].curves[0].shape).length() == doctest::Approx(kPi / 2));
  CHECK(sound(kHeld + "copy c of b turn 180\nfix c.s\n").bodies.at(1).outlines[0].curves[1].shape->at(1).x ==
        doctest::Approx(-1));
  // Points of a file: blank lines and comments are left out.
  const auto file = [](const std::string&, std::string& text) {
    text = "# one\n! two\n\n \t\nname\n0 0\n1;0.5\n2,0\n";
    return true;
  };
  const Reading read_file = read_sketch("body b E 1 nu 0\nspline a file p.csv\nline to 1 2\nline close\nfix b.a\n", {}, file);
  REQUIRE(read_file.faults.empty());
  CHECK(length(read_file.sketch.bodies[0].outlines[0].curves[0].shape->at(0.5) - Point{1, 0.5}) < 1e-12);
}

TEST_CASE("sketch: decks of rigid bodies and platens whose statements are alike or few, and of loads of several cases") {
  const std::string rigid =
      kHeld + "body r rigid\nfrom 0 1\nline f to 1 1\nline g to 1 2\nline h to 0 2\nline i close\ncontact b.n r.f\n";
  const std::string turned = deck(rigid + "drive r about 0.5 1 y -0.01 x 0\n");
  CHECK(has_card(turned, "*RIGID 2\n1 0 -0.01 0 0.5 1"));
  CHECK(has_card(turned, "*RIGID LOAD 2 0.5 1 TURN"));
  CHECK(has_card(deck(rigid + "drive r about 0.5 1 moment 3 x 0 y -0.01\n"), "*RIGID LOAD 2 0.5 1 TURN\n1 0 0 3"));
  const std::string twice = deck(
      kHeld +
      "case a\nplaten b.n about 0.5 1 fy -1\ncase c\nplaten b.n fx 2\nforce b at 0.5 0.5 y 1\ncase d\nforce b at 0.5 0.5 x 3\n"
      "history a 1; c 1; d 1\n");
  CHECK(has_card(twice, "1 FY -1\n2 FX 2"));
  CHECK(twice.find("*PLATEN") == twice.rfind("*PLATEN"));
  CHECK(has_card(twice, "load 1 0.5 0.5 0 1\ncase 3 ! d\nload 1 0.5 0.5 3 0"));
  // Curves of a platen that adjoin where the outline begins have their elements in a row; opposite ones have no row.
  const Sketch round = sound(std::string(kSquare) + "fix b.e\nplaten b.w+s about 0 0 fx -1\n");
  const std::string wrapped = deck_of(round, first_mesh(round, 1));
  CHECK(wrapped.find("*PLATEN 1 ") != std::string::npos);
  const Sketch apart = sound(std::string(kSquare) + "fix b.e\nplaten b.n+s about 0 0 fx -1\n");
  CHECK_THROWS_AS(deck_of(apart, first_mesh(apart, 1)), Fault);
  // A disc between two flats, as the first side: its outline is run through from where no part that faces a flat goes on.
  const Sketch disc =
      sound("body b E 1 nu 0\nfrom -4 -4\nline s to 4 -4\nline to 4 0\nline n to -4 0\nline close\ncopy u of b mirror y 1\n"
            "body d E 1 nu 0\ncircle c centre 0 1 radius 1\ncontact d.c b.n\ncontact d.c u.n\nfix b.s\nfix u.s\n");
  const Mesh mesh = first_mesh(disc, 1);
  const std::vector<Zone> zones = zones_of(disc, mesh);
  REQUIRE(zones.size() == 2);
  const Stretch &one = zones[0].one, &two = zones[0].two;
  CHECK(one.count == one.last - one.first + 1);
  CHECK(has_card(deck_of(disc, mesh), "*ZONE BODIES 3 1 " + std::to_string(one.first) + " " + std::to_string(one.last) + " " +
                                          std::to_string(two.first) + " " + std::to_string(two.last)));
  // Numbers that are too large only together.
  const Sketch large = sound(kHeld + "traction b.n y 9e99\ntraction b.n y 9e99\n");
  try {
    deck_of(large, first_mesh(large, 1));
    FAIL("nothing told");
  } catch (const Fault& f) {
    CHECK(f.text == "the deck would contain the number 1.8E+100, expected a magnitude below 1e100");
  }
}

TEST_CASE("sketch zones: three interfaces in a row, that coincide, or of which a short one makes way") {
  const std::string above = "line a to 1 0\nline m to 2 0\nline c to 3 0\n";
  const std::string lower = block("b", 0, 3, false, "line c to 2 0\nline m to 1 0\nline a to 0 0\n") + "fix b.s\n";
  for (const char* order :
       {"contact b.a d.a\ntie b.m d.m\ncontact b.c d.c\n", "contact b.c d.c\ncontact b.a d.a\ntie b.m d.m\n"}) {
    CAPTURE(order);
    const Sketch s = sound(lower + block("d", 0, 3, true, above) + order);
    const Mesh mesh = first_mesh(s, 1);
    const std::vector<Zone> zones = zones_of(s, mesh);
    REQUIRE(zones.size() == 3);
    int pairs = 0, elements = 0;
    for (const Zone& zone : zones) {
      CHECK(zone.matching);
      CHECK(zone.one.count == zone.two.count);
      elements += zone.two.count;
      pairs += zone.two.count + 1 - zone.leaves[0] - zone.leaves[1];
    }
    CHECK(pairs == elements + 1); // every node of the floor in one pair
    share_nothing(zones);
    CHECK(deck_of(s, mesh).find("! matching zone") != std::string::npos);
  }
  // On a rigid floor nothing matches, and neighbours share nodes: one of a single linear element comes to nothing.
  const std::string rigid =
      "body b rigid\nfrom 0 -1\nline s to 3 -1\nline r to 3 0\nline c to 2 0\nline m to 1 0\nline a to 0 0\nline l close\n";
  for (const char* order :
       {"contact b.a d.a\ncontact b.m d.m\ncontact b.c d.c\n", "contact b.a d.a\ncontact b.c d.c\ncontact b.m d.m\n",
        "contact b.m d.m\ncontact b.a d.a\ncontact b.c d.c\n"})
    for (const bool short_one : {false, true}) {
      CAPTURE(order);
      CAPTURE(short_one);
      const Sketch s = sound(rigid + block("d", 0, 3, true, above) + order + "fix d.top\n");
      Mesh mesh = first_mesh(s, 1);
      if (short_one)
        for (MeshedCurve& curve : mesh.bodies[1][0].curves)
          if (curve.curve->name == "m") curve.ends = {0, curve.measure.length()};
      const std::vector<Zone> zones = zones_of(s, mesh);
      const bool is_last = std::string(order).find("b.m") > std::string(order).find("b.c");
      const bool comes_to_nothing = short_one && is_last; // it gives up both nodes
      CHECK(zones.size() == (comes_to_nothing ? 2 : 3));
      for (const Zone& zone : zones) CHECK_FALSE(zone.matching);
      share_nothing(zones);
    }
}

TEST_CASE("sketch zones: a neighbour that does not coincide takes the last element, not the node") {
  // The block stands on an elastic one of its own mesh, with two interfaces that coincide, and at its side on a rigid one.
  for (const bool left : {true, false}) {
    CAPTURE(left);
    const std::string floor = left ? block("f", 1, 3, false, "line c to 2 0\nline m to 1 0\n")
                                   : block("f", 0, 2, false, "line m to 1 0\nline c to 0 0\n");
    const std::string stone = left ? "body r rigid\nfrom 0 -1\nline s to 1 -1\nline e to 1 0\nline a to 0 0\nline w close\n"
                                   : "body r rigid\nfrom 2 -1\nline s to 3 -1\nline e to 3 0\nline a to 2 0\nline w close\n";
    const std::string face =
        left ? "line a to 1 0\nline m to 2 0\nline c to 3 0\n" : "line c to 1 0\nline m to 2 0\nline a to 3 0\n";
    const Sketch s =
        sound(stone + floor + block("d", 0, 3, true, face) + "contact f.c d.c\ncontact r.a d.a\ncontact f.m d.m\nfix f.s\n");
    const std::vector<Zone> zones = zones_of(s, first_mesh(s, 1));
    REQUIRE(zones.size() == 3);
    int matching = 0;
    for (const Zone& zone : zones) {
      matching += zone.matching ? 1 : 0;
      if (zone.matching) CHECK(zone.one.count == zone.two.count);
    }
    CHECK(matching == 2);
    share_nothing(zones);
  }
}

TEST_CASE("sketch zones: a slit in one body, and rings within holes, in the middle of a body's numbers") {
  // A slit whose faces are of one body: its zones are between the body and itself.
  const Sketch slit = sound(
      "body b E 1 nu 0\nfrom 0 0\nline s to 4 0\nline e to 4 1\nline a to 3 1\nline m to 2 1\nline n to 3 1\nline d to 4 1\n"
      "line f to 4 2\nline top to 0 2\nline w close\nfix b.w\ncontact b.a b.d\ncontact b.m b.n\n");
  const Mesh slit_mesh = first_mesh(slit, 1);
  const std::vector<Zone> faces = zones_of(slit, slit_mesh);
  REQUIRE(faces.size() == 2);
  for (const Zone& zone : faces) CHECK_FALSE(zone.matching);
  share_nothing(faces);
  CHECK(deck_of(slit, slit_mesh).find("*ZONE BODIES 1 -1 ") != std::string::npos);
  // A disc in a hole, held by a tie on one half and in contact on the other: node numbers count what lies before the hole.
  for (const bool half : {false, true}) {
    CAPTURE(half);
    const std::string ring =
        half ? "symmetry y 0\nbody b E 1 nu 0\nfrom 3 0\narc out to -3 0 centre 0 0\nhole\nfrom -1 0\narc "
               "l to 0 1 centre 0 0 right\n"
               "arc r to 1 0 centre 0 0 right\nfix b.out\nbody d E 1 nu 0\nfrom 1 0\narc r to 0 1 centre "
               "0 0\narc l to -1 0 centre 0 0\n"
             : "body b E 1 nu 0\nfrom -3 -3\nline out to 3 -3\nline to 3 3\nline to -3 3\nline close\nhole\nfrom -1 0\n"
               "arc a to 0 1 centre 0 0 right\narc l to 1 0 centre 0 0 right\narc r to 0 -1 centre 0 0 right\n"
               "arc z to -1 0 centre 0 0 right\nfix b.out\nbody d E 1 nu 0\nfrom -1 0\narc z to 0 -1 centre 0 0\n"
               "arc r to 1 0 centre 0 0\narc l to 0 1 centre 0 0\narc a to -1 0 centre 0 0\n";
    const Sketch s = sound(ring + "tie b.l d.l\ncontact b.r d.r\n");
    const Mesh mesh = first_mesh(s, 1);
    const std::vector<Zone> zones = zones_of(s, mesh);
    REQUIRE(zones.size() == 2);
    for (const Zone& zone : zones) CHECK(zone.matching);
    const std::string text = deck_of(s, mesh);
    CHECK(text.find("! matching zone") != std::string::npos);
    CHECK(problem::solve_text(text, {}).status == C2D_OK); // the reader checks that the nodes of pairs lie on each other
  }
  // All round nothing matches: numbers of nodes would have to go on from the last to the first.
  const Sketch round =
      sound("body b E 1 nu 0\nfrom -3 -3\nline out to 3 -3\nline to 3 3\nline to -3 3\nline close\nhole\nfrom -1 0\n"
            "arc l to 1 0 centre 0 0 right\narc r to -1 0 centre 0 0 right\nfix b.out\nbody d E 1 nu 0\nfrom -1 0\n"
            "arc r to 1 0 centre 0 0\narc l to -1 0 centre 0 0\ntie b.l d.l\ncontact b.r d.r\n");
  for (const Zone& zone : zones_of(round, first_mesh(round, 1))) CHECK_FALSE(zone.matching);
}

TEST_CASE("sketch: meshes of two sides whose ends hardly meet, and places of bodies that touch nothing") {
  // The upper block begins where the lower one nearly ends: no end goes there.
  const Sketch s = sound(block("b", 0, 10, false, "line n to 0 0\n") + "fix b.s\n" +
                         block("d", 0.1, 20, true, "line a to 20 0\n") + "contact b.n d.a\n");
  Mesh mesh = first_mesh(s, 1);
  const auto curve = [&mesh](size_t body, const std::string& name) -> MeshedCurve& {
    for (MeshedCurve& c : mesh.bodies[body][0].curves)
      if (c.curve->name == name) return c;
    FAIL("no curve " << name);
    return mesh.bodies[body][0].curves[0];
  };
  curve(0, "n").ends = {0, 10}, curve(1, "a").ends = {0, 9.9};
  align(0, mesh);
  CHECK(curve(0, "n").ends == std::vector<double>{0, 10});
  // Elements that are much shorter than the one they face are not bisected with it.
  curve(0, "n").ends = {0, 5, 10};
  std::vector<double>& fine = curve(1, "a").ends;
  fine.clear();
  for (int i = 0; i <= 100; ++i) fine.push_back(0.099 * i);
  const auto levels_of = [](const Mesh& m) {
    Levels out;
    for (const auto& outlines : m.bodies) {
      size_t count = 0;
      for (const MeshedOutline& o : outlines) count += o.elements();
      out.emplace_back(count);
    }
    return out;
  };
  Levels levels = levels_of(mesh);
  size_t first = 0;
  for (const MeshedCurve& c : mesh.bodies[0][0].curves) {
    if (c.curve->name == "n") levels[0][first].level = levels[0][first + 1].level = 1;
    first += c.elements();
  }
  const Mesh finer = refined(s, mesh, levels);
  for (const MeshedCurve& c : finer.bodies[1][0].curves) // (at the ends neighbours may ask for more)
    if (c.curve->name == "a")
      for (int i = 2; i <= 98; ++i) CHECK(std::count(c.ends.begin(), c.ends.end(), 0.099 * i - 0.0495) == 0);
  // A place on a body that no interface names moves nothing.
  const Sketch alone = sound(kHeld);
  Mesh still = first_mesh(alone, 1);
  const size_t before = still.bodies[0][0].elements();
  place_ends(alone, {{0, {0.3, 0}}}, still);
  CHECK(still.bodies[0][0].elements() == before);
  CHECK(locate(alone, {0, {0.3, 0}}, true, still).curve == nullptr);
}
