// Facing parts of sides in rare places: bodies between and behind one another, corners, waves that hang over, faces that meet
// at one point, overlaps from rounded coordinates.
#include "sketches.hpp"

#include <cmath>
#include <vector>

using namespace sketch;
using namespace sketches;

namespace {

// Of each facing part: the number of its interface, and its lengths along both outlines.
std::string parts(const std::string& text) {
  const Reading r = read(text);
  if (!r.faults.empty()) return r.faults[0].text;
  std::string out;
  for (const Contact& c : r.sketch.contacts) {
    out += std::to_string(c.interface) + (c.turned ? "t" : "");
    for (const Contact::Strip& s : c.side) out += " [" + rounded(s.from) + " " + rounded(s.to) + "]";
    out += "; ";
  }
  return out;
}

void faces(const std::string& text, const std::string& expected) {
  CAPTURE(text);
  CHECK(parts(text) == expected);
}
void says(const std::string& text, const std::string& expected) {
  const std::string said = parts(text);
  CAPTURE(text);
  CHECK_MESSAGE(said.find(expected) != std::string::npos, said);
}

// From x -2 to 2; its top n has the lengths 5 to 9, to the left.
const std::string kFloor =
    "body f E 1 nu 0\nfrom -2 -1\nline s to 2 -1\nline e to 2 0\nline n to -2 0\nline w close\nfix f.s\n";

std::string block(const std::string& name, double x0, double y0, double x1, double y1) {
  const std::string a = show(x0), b = show(y0), c = show(x1), d = show(y1);
  return "body " + name + " E 1 nu 0\nfrom " + a + " " + b + "\nline s to " + c + " " + b + "\nline e to " + c + " " + d +
         "\nline n to " + a + " " + d + "\nline w close\n";
}

std::string wedge(double tip, double half_width) {
  return "body b E 1 nu 0\nfrom 0 " + show(tip) + "\nline r to " + show(half_width) + " 1\nline n to " + show(-half_width) +
         " 1\nline l close\n";
}

// A floor with a ridge of 45 degrees.
const std::string kRidge = "body f E 1 nu 0\nfrom -2 -1\nline s to 2 -1\nline e to 2 0\nline n1 to 0.3 0\nline n2 to 0 0.3\n"
                           "line n3 to -0.3 0\nline n4 to -2 0\nline w close\nfix f.s\n";

} // namespace

TEST_CASE("sketch facing: sides that do not face each other say where they are nearest, and whether a corner is there") {
  const std::string above = kFloor + block("b", -1, 0.5, 1, 1);
  says(above + "contact f.s+e b.n+w\n", "no part of f.s+e faces b.n+w: they lie beside each other");
  says(above + "contact f.s+e b.n+w\n", "their smallest distance is 1.41421 at (2, 0)");
  says(above + "contact f.n+e b.n+w\n", "their smallest distance is 0.5 at (-1, 0)");
  says(kFloor + block("b", -1, -3, 1, -2) + "contact f.n b.s\n", "their smallest distance is 3 at");
  says(above + "contact f.n f.n\n", "f.n is on both sides, expected different curves");
  const std::string steep = "they are inclined to each other by 73 degrees or more";
  for (const double tip : {0.0, 0.01}) {
    CAPTURE(tip);
    says(kFloor + wedge(tip, 0.3) + "contact b.l+r f.n\n", steep);
    says(kFloor + wedge(tip, 0.3) + "contact b.l+r f.n\n", ", a corner; add a fillet if contact is expected there");
    says(kFloor + wedge(tip, 0.3) + "contact f.n b.l+r\n", steep);
  }
}

TEST_CASE("sketch facing: a body between two others hides what is behind it") {
  const std::string above = kFloor + block("b", -1, 0.5, 1, 1);
  says(above + block("c", -3, 0.2, 3, 0.3) + "fix c.s\ncontact f.n b.s\n", "or another curve lies between them");
  faces(above + block("c", 0, 0.2, 3, 0.3) + "fix c.s\ncontact f.n b.s\n", "0 [6.95 8.05] [0 1]; ");
  says("body a E 1 nu 0\ncircle o centre 0 0 radius 1\nbody b E 1 nu 0\ncircle o centre 5 0 radius 1\n" +
           block("c", 2, -9, 3, 9) + "contact a.o b.o\nfix a.o.start\nfix b.o.start\nfix c.s\n",
       "their smallest distance is 3");
}

TEST_CASE("sketch facing: a stretch behind a thin body belongs to that body, whichever statement comes first") {
  const std::string thin = kFloor + block("m", -1, 0, 1, 0.01);
  const auto over = [&](double x0, double x1, const std::string& contacts) {
    return thin + block("b", x0, 0.01, x1, 1) + contacts;
  };
  const std::string mf = "contact m.s f.n\n", fm = "contact f.n m.s\n", bf = "contact b.s f.n\n", fb = "contact f.n b.s\n";
  // Wider than the thin body: what remains is the larger end beside it.
  faces(over(-1.5, 1.5, fm + fb), "0 [6 8.1] [0 2]; 1 [5.475 6] [2.5 3]; ");
  faces(over(-1.5, 1.5, fb + fm), "0 [5.475 6] [2.5 3]; 1 [6 8.1] [0 2]; ");
  faces(over(-0.5, 1.5, fb + fm), "0 [5.475 6] [1.5 2]; 1 [6 8.1] [0 2]; ");
  faces(over(-1.5, 0.5, fb + fm), "0 [8 8.525] [0 0.5]; 1 [5.9 8] [0 2]; ");
  faces(over(-1.5, 1.2, bf + mf), "0 [0 0.5] [8 8.5]; 1 [0 2] [6 8]; ");
  faces(over(-1.5, 1.2, mf + bf), "0 [0 2] [6 8]; 1 [0 0.5] [8 8.5]; ");
  // No wider: nothing remains.
  for (const double half : {0.5, 1.0})
    for (const std::string& first : {fb, bf})
      for (const std::string& second : {fm, mf}) {
        CAPTURE(half);
        const bool turned = second == mf;
        faces(over(-half, half, first + second), turned ? "1 [0 2] [6 8]; " : "1 [5.9 8.1] [0 2]; ");
        faces(over(-half, half, second + first), turned ? "0 [0 2] [6 8]; " : "0 [5.9 8.1] [0 2]; ");
      }
}

TEST_CASE("sketch facing: faces that meet at a point above the floor share it evenly") {
  const std::string two = kFloor + "body a E 1 nu 0\nfrom -1 0\nline s to 0 0.1\nline n to -1 1\nline w close\n"
                                   "body b E 1 nu 0\nfrom 0 0.1\nline s to 1 0\nline e to 1 1\nline n close\n";
  faces(two + "contact f.n a.s\ncontact f.n b.s\n", "0 [7 8.05] [0 1]; 1 [5.95 7] [0.00498756 1.00499]; ");
  faces(two + "contact a.s f.n\ncontact b.s f.n\n", "0 [0 0.997506] [7.00249 8]; 1 [0.00249378 1.00499] [6 7.00249]; ");
  faces(two + "contact f.n a.s\ncontact b.s f.n\n", "0 [7 8.05] [0 1]; 1 [0.00498756 1.00499] [6 7]; ");
}

TEST_CASE("sketch facing: corners in a side, and grooves, which end it") {
  faces(kFloor + block("b", -1, 0, 1, 1) + "contact f.n b.w+s+e\n", "0 [5.9 8.1] [6 8]; ");
  faces(kFloor + block("b", -1, 0.1, 1, 1) + "contact f.n b.w+s+e\n", "0 [5.9 8.1] [5.8 7.8]; ");
  faces(kFloor + block("b", -1, 0.1, 1, 1) + "contact b.w+s+e f.n\n", "0 [5.7 7.9] [6 8]; ");
  faces("body f E 1 nu 0\nfrom -2 -1\nline s to 2 -1\nline e to 2 1\nline to 0.5 1\nline r to 0.5 0\nline n to -0.5 0\n"
        "line l to -0.5 1\nline to -2 1\nline w close\nfix f.s\n" +
            block("b", -0.5, 0, 0.5, 1) + "contact f.l+n+r b.w+s+e\n",
        "0 [7.5 8.5] [5 6]; 0 [8.5 9.5] [4 5]; 0 [9.5 10.5] [3 4]; ");
  faces(kRidge + block("b", -1, 0.3, 1, 1) + "contact f.n2+n3 b.s\n", "0 [6.7 7.54853] [0.7 1.3]; ");
  const std::string ridge = kRidge + block("b", -1, 0.5, 1, 1);
  faces(ridge + "contact f.n1+n2+n3+n4 b.s\n",
        "0 [5.965 6.7] [1.3 2]; 0 [6.7 7.54853] [0.7 1.3]; 0 [7.54853 8.28353] [0 0.7]; ");
  faces(ridge + "contact b.s f.n1+n2+n3+n4\n", "0 [1.3 2] [6 6.7]; 0 [0.7 1.3] [6.7 7.54853]; 0 [0 0.7] [7.54853 8.24853]; ");
  // Beyond a joint of few degrees the surface is too steep.
  const Sketch bent =
      sound(kFloor + "body b E 1 nu 0\nfrom 0 0\nline s to 0.1 0\nline v by 0.1 0.1\n"
                     "line u by {0.1*cos(56*deg)} {0.1*sin(56*deg)}\nline n to 0 1\nline w close\ncontact f.n b.s+v+u\n");
  REQUIRE(bent.contacts.size() == 1);
  CHECK(bent.contacts[0].side[1].to == doctest::Approx(0.1 + 0.1 * std::sqrt(2.0)).epsilon(0.01));
  CHECK(bent.contacts[0].ends[1] != "");
}

TEST_CASE("sketch facing: waves face a flat in several parts, that mirror each other") {
  const std::string wave = kFloor + "body b E 1 nu 0\nfrom 1 1\nline n to -1 1\nline w to -1 0\n"
                                    "curve c t -1 1 x {t} y {0.2*(1-cos(2*pi*t))}\nline e close\n";
  for (const char* contact : {"contact f.n b.c\n", "contact b.c f.n\n"}) {
    CAPTURE(contact);
    const Sketch s = sound(wave + contact);
    const std::vector<Contact>& all = s.contacts;
    REQUIRE(all.size() == 7); // three crests of the upper body, and pairs beside its two valleys
    const size_t flat = contact[8] == 'f' ? 0 : 1;
    for (size_t k = 0; k < all.size(); ++k) { // the floor's middle has the length 7
      const Contact::Strip &one = all[k].side[flat], &mirrored = all[all.size() - 1 - k].side[flat];
      CHECK(one.from + mirrored.to == doctest::Approx(14).epsilon(1e-6));
    }
  }
  // A wave that hangs over: what its crests hide does not face the block above.
  const std::string breaking = "body f E 1 nu 0\nfrom -2.5 -1\nline s to 2.5 -1\nline e to 2.5 0\nline to 2 0\n"
                               "curve n t 2 -2 x {t + 0.45*sin(2*pi*t)} y {0.4*sin(2*pi*t)}\nline to -2.5 0\nline w close\n"
                               "fix f.s\n" +
                               block("b", -1, 1, 1, 2);
  for (const char* contact : {"contact f.n b.s\n", "contact b.s f.n\n"}) {
    CAPTURE(contact);
    const Sketch s = sound(breaking + contact);
    REQUIRE(s.contacts.size() >= 2);
    const size_t flat = contact[8] == 'b' ? 0 : 1;
    double covered = 0;
    for (const Contact& c : s.contacts) covered += c.side[flat].to - c.side[flat].from;
    CHECK(covered > 0.5);
    CHECK(covered < 2.2);
  }
}

TEST_CASE("sketch facing: overlaps from rounded coordinates move one of the bodies, within the lines of symmetry") {
  const auto groove = [](const std::string& half) {
    return "body f E 1 nu 0\nfrom -2 -1\nline s to 2 -1\nline e to 2 1\nline to 0.5 1\nline r to 0.5 0\nline n to -0.5 0\n"
           "line l to -0.5 1\nline to -2 1\nline w close\nfix f.s\nbody b E 1 nu 0\nfrom -" +
           half + " 0\nline s to " + half + " 0\nline e to " + half + " 1\nline n to -" + half +
           " 1\nline w close\ncontact f.r b.e\ncontact f.l b.w\n";
  };
  faces(groove("0.5000001"), "0 [7.5 8.5] [1 2]; 1 [9.5 10.5] [3 4]; "); // too wide for the groove, wherever it goes
  const auto corner = [](const Sketch& s, size_t body) { return s.bodies[body].outlines[0].curves[0].shape->at(0); };
  // Along the line of symmetry a body may move.
  const Sketch on_x = sound("symmetry x 0\nbody f E 1 nu 0\nfrom 0 -1\nline s to 2 -1\nline e to 2 0\nline n to 0 0\nfix f.s\n"
                            "body b E 1 nu 0\nfrom 0 -0.000001\nline s to 1 -0.000001\nline e to 1 1\nline n to 0 1\n"
                            "contact f.n b.s\n");
  CHECK(std::fabs(corner(on_x, 1).x) < 1e-12);
  CHECK(std::fabs(corner(on_x, 1).y) < 1e-8);
  const Sketch on_y = sound("symmetry y 0\nbody f E 1 nu 0\nfrom 1 0\nline e to 1 2\nline n to -1 2\nline w to -1 0\nfix f.w\n"
                            "body b E 1 nu 0\nfrom 2 0\nline e to 2 1\nline n to 0.999999 1\nline w to 0.999999 0\n"
                            "contact f.e b.w\n");
  CHECK(corner(on_y, 1).x == doctest::Approx(2.000001).epsilon(1e-8));
  // From it, it may not: the other moves.
  const std::string half = "body b E 1 nu 0\nfrom 0 0\nline s to 1.000001 0\nline e to 2.000001 1\nline n to 0 1\n",
                    free = "body c E 1 nu 0\nfrom 1 0\nline s to 2 0\nline n to 2 1\nline w close\nfix c.s\n";
  for (const bool half_first : {false, true})
    for (const char* contact : {"contact c.w b.e\n", "contact b.e c.w\n"}) {
      CAPTURE(contact);
      const Sketch s = sound("symmetry x 0\n" + (half_first ? half + free : free + half) + contact);
      CHECK(std::fabs(corner(s, half_first ? 0 : 1).x) < 1e-12);
      const Point moved = corner(s, half_first ? 1 : 0);
      CHECK(moved.x - 1 == doctest::Approx(5e-7).epsilon(1e-3));
      CHECK(moved.y == doctest::Approx(-5e-7).epsilon(1e-3));
    }
}

TEST_CASE("sketch facing: ends at supports of one side, of both, and of unlike directions") {
  const std::string two = kFloor + block("b", -2, 0, 2, 1) + "contact f.n b.s\n";
  const auto supported = [&](const std::string& fixes) { return sound(two + fixes).contacts[0].is_supported[1]; };
  CHECK(supported("fix f.e x\nfix b.e x y\n"));
  CHECK_FALSE(supported("fix f.e x\nfix b.e x\n")); // as a line of symmetry
  CHECK(supported("fix f.e y\nfix b.e x\n"));
}

TEST_CASE("sketch facing: facing parts shorter than what divides an outline") {
  const std::string short_one = "is shorter than 1e-12 of the outline, expected a longer one";
  says(kFloor + "body b E 1 nu 0\nfrom {2-5e-13} 0\nline s to {2+2e-6} 0\nline e to 3 1\nline n to 2 1\nline w close\n"
                "contact f.n b.s\n",
       short_one);
  says(kFloor + "body b E 1 nu 0\nfrom {2-5e-11} 0\nline s to {2+3.1e-4} 0\nline e to 300 100\nline n to 2 300\nline w close\n"
                "contact f.n b.s\n",
       short_one);
}

TEST_CASE("sketch facing: the ends of a curve that contacts divide are its own ends") {
  const std::string text = kFloor + block("b", -1, 0, 1, 1) + "contact f.n b.s\n";
  const auto supported = [&](const std::string& supports) { // element ends beyond the foot, as many as of one node
    const std::string all = deck(text + supports);
    size_t count = 0, begin = all.find("conditions of f");
    const size_t end = all.find("point loads", begin);
    while ((begin = all.find(" 1100 ", begin + 1)) < end) ++count;
    return count - 2;
  };
  for (const char* one : {"fix f.n.start\n", "fix f.n.end\n", "fix f.e.end\n", "fix f.w.start\n"}) CHECK(supported(one) == 1);
  CHECK(supported("fix f.n.start\nfix f.n.end\n") == 2);
  CHECK(supported("") == 0);
}

TEST_CASE("sketch facing: both faces of a notch, which meet at its tip") {
  const Sketch s = sound("body a E 1 nu 0\nfrom 0 0\nline s to 2 0\nline e1 to 2 1\nline l to 1 1.1\nline u to 2 1.2\n"
                         "line e2 to 2 2\nline n to 0 2\nline w close\nfix a.s\npressure a.n 1\ncontact a.l a.u\n");
  REQUIRE(s.contacts.size() == 1);
  CHECK(s.contacts[0].side[0].to - s.contacts[0].side[0].from > 0.9);
  const std::string text = deck_of(s, first_mesh(s, 1));
  CHECK(text.find("*ZONE BODIES 1 -1 ") != std::string::npos);
}
