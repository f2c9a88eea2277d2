// Words of sketches in rare places: at the end of a line, in quotes, under names that mean something else.
#include "program/sketch/read/point_rows.hpp"
#include "program/sketch/torsion.hpp"
#include "sketches.hpp"

#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

const std::string kHeld = std::string(kSquare) + "fix b.s\n"; // 7 lines
const std::string kRound = "axisymmetric\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\n";

// Points of a file of rows, or the message with its line.
std::string points(const std::string& rows) {
  try {
    std::string out;
    for (const PointRow& row : point_rows(rows)) out += "(" + show(row.at.x) + " " + show(row.at.y) + ")";
    return out;
  } catch (const Fault& f) {
    return std::to_string(f.at.line) + ": " + f.text;
  }
}

} // namespace

TEST_CASE("sketch words: the end of a line, quotes and bodies with the names of words") {
  tells(kHeld + "want stress zz\n", "8:15 the statement ends here, expected the name of a body");
  tells(kHeld + "want stress zz \"b.n\"\n", "'b.n'");
  tells(kHeld + "want stress zz 0.5 0.5\n", "8:16 no body is called '0.5'");
  const std::string zz = "body zz E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix zz.s\n";
  CHECK_FALSE(sound(zz + "pressure zz.n 1\nwant stress zz 0.5 0.5\n").wants.back().is_zz);
  tells("parameter \"R\" 1\n" + kHeld, "1:");
  tells("parameter R \"1\"\n" + kHeld, "1:13");
  tells("parameter R +- 0.1\n" + kHeld, "1:13 '+-': expected the value of R before its tolerance");
  tells("parameter R \"\"\n" + kHeld, "1:13");
  tells("parameter R 1 \"+-\" 0.1\n" + kHeld, "1:15");
  tells("parameter R 1+-\n" + kHeld, "expected the tolerance of R");
  tells("parameter R 1 +-0.1 pi 3\n" + kHeld, "'pi' is reserved");
  tells("parameter inf 3\n" + kHeld, "'inf' is reserved");
  CHECK(sound("parameter R 1+-0.1 Q 2 +-5%\n" + kHeld + "pressure b.n 1\n").tolerances.size() == 2);
  CHECK(sound("parameter R 1+-0.1 Q 2 +-5%\n" + kHeld + "pressure b.n 1\n").tolerances[1].size == doctest::Approx(0.1));
}

TEST_CASE("sketch words: curves whose names are words, and names that two curves share") {
  for (const char* second : {"to 0 1", "by -1 0", "close 0 0"})
    tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline close " + std::string(second) + "\n",
          "5:6 'close': expected another name of the curve");
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline close radius 1\n", "5:12 'radius'");
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline to to 0 1\n", "another name of the curve");
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline s to 1 1\nline close\nfix b.none\n", "expected 's'");
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline s to 1 1\nline close\nfix b.s\npart p of s from start to end\n", "");
}

TEST_CASE("sketch words: bodies of revolution, their supports and drives") {
  CHECK(sound(kRound + "fix b.s\nfix b.n.end\npressure b.n 1\n").conditions.size() == 3);
  CHECK(sound(kRound + "fix b.s\nfix b.n.end x\npressure b.n 1\n").conditions.size() == 3);
  CHECK(sound(kRound + "fix b.s y turn\npressure b.n 1\n").conditions.size() == 2);
  const std::string rigid =
      kRound + "body c rigid\nfrom 0 1\nline s to 1 1\nline e to 1 2\nline n to 0 2\ncontact c.s b.n\nfix b.s\n";
  const Sketch s = sound(rigid + "case push\ndrive c fy -1\ncase more\ndrive c fy -2\nhistory push 1; more 1\n");
  CHECK(s.drives.size() == 2);
  CHECK(*s.drives[1].load[1] == -2);
  // A force across the axis, and one at a line of symmetry of either kind.
  tells(kRound + "fix b.s\nforce b at 0 0.5 fx 1\n", "acts across the axis x = 0");
  const auto half = [](const std::string& axis, const std::string& outline) {
    return "symmetry " + axis + " 0\nbody b E 1 nu 0\n" + outline + "fix b.c\n";
  };
  tells(half("x", "from 0 -1\narc c to 0 1 centre 0 0\n") + "force b at 0 0.5 fx 1\n",
        "acts across the line of symmetry x = 0");
  tells(half("y", "from 1 0\narc c to -1 0 centre 0 0\n") + "force b at 0.5 0 fy 1\n",
        "acts across the line of symmetry y = 0");
}

TEST_CASE("sketch words: requests that need a contact or a cycle") {
  tells(kHeld + "pressure b.n 1\nwant fatigue ruiz1 b.n\n", "2 faults");
  const Reading two = read(kHeld + "pressure b.n 1\nwant fatigue ruiz2 b.n\n");
  REQUIRE(two.faults.size() == 2);
  CHECK(two.faults[0].text.find("the sketch has no contact") != std::string::npos);
  CHECK(two.faults[1].text.find("cycle") != std::string::npos);
  tells(kHeld + "pressure b.n 1\nwant fatigue crack b.n depth\n", "the length of the crack");
  tells(kHeld + "pressure b.n 1\nwant fatigue ruiz2 b 0.5 0.5\n", "9:20 'b': expected a body, a dot and curves");
  tells(kHeld + "pressure b.n 1\nwant fatigue crack b 0.5 0.5\n", "9:20 'b': expected a body, a dot and curves");
}

TEST_CASE("sketch words: rows of points in other notations") {
  CHECK(points("1,5;2\n3;4,5\n") == "(1.5 2)(3 4.5)");
  CHECK(points("1,5 2,5\n") == "(1.5 2.5)");
  CHECK(points("1 ,2\n") == "(1 2)");
  CHECK(points("1, 2\n") == "(1 2)");
  CHECK(points(",1 2\n").find("1: ") == 0);
  CHECK(points("\"1.5\",\"2\"\n") == "(1.5 2)");
  CHECK(points("1.5,\"2\n").find("1: ") == 0);
  CHECK(points("x1 y1\n1 2\n") == "(1 2)");
  CHECK(points("x y\n1 2\n") == "(1 2)");
  CHECK(points("1;\n").find("1: ") == 0);
  CHECK(points(";\n1 2\n") == "(1 2)");
  CHECK(points("x~ 5\n").find("1: ") == 0);
  CHECK(points("\xef\xbb\xbf"
               "1 2\n") == "(1 2)");
  for (const std::string& wide : {std::string("\xff\xfe"
                                              "1"),
                                  std::string("\xfe\xff"
                                              "1"),
                                  std::string("1\0"
                                              "2\0",
                                              4)})
    CHECK(points(wide) == "1: the file has two bytes per character, expected text in UTF-8 or ASCII");
}

TEST_CASE("sketch words: loads round the axis in histories of several cases") {
  const std::string bar = kRound + "fix b.s\n";
  const Sketch s =
      sound(bar + "case push\nforce b at 0 0.5 fy 1\ncase pull\nforce b at 0 0.6 fy 1\ncase twist\ntraction b.n turn 1\n"
                  "history push 1; pull 1; twist 1\n");
  CHECK(s.cases.size() == 2);
  CHECK(s.point_loads.size() == 2);
  CHECK(s.point_loads[1].load_case == 1);
  REQUIRE(s.torsion.cases.size() == 1);
  // Two cases round the axis: without a history the first acts, so the second never would.
  tells(bar + "case a\ntraction b.n turn 1\ncase c\ntraction b.e turn 1\n", "load case 'c' is never applied");
  tells(bar + "case a\npressure b.n 1\ncase t\ntraction b.n turn 1\nhistory t 1; a 1\n", "loads round the axis");
  tells(bar + "move b.e turn 1\ntraction b.n turn 1\ntraction b.e turn 2\n", "expected an angle or a traction, not both");
  const std::string base = kRound + "body c rigid\nfrom 0 1\nline s to 1 1\nline e to 1 2\nline n to 0 2\n";
  tells(base + "contact b.n c.s\nfix b.s x y\ntraction b.e turn 1\n", "a coefficient of friction of its contact ('mu')");
  // An angle of 0 in a case of its own turns with no other.
  const Sketch still = sound(bar + "case a\nmove b.e turn 0\npressure b.n 1\ncase t\ntraction b.n turn 1\nhistory a 1; t 1\n");
  CHECK(still.torsion.cases.size() == 1);
  CHECK(still.cases.size() == 1);
  // A body beside a contact of others has no friction that could hold it.
  const std::string three = kRound +
                            "body c E 1 nu 0\nfrom 0 1\nline s to 1 1\nline e to 1 2\nline n to 0 2\n"
                            "body d E 1 nu 0\nfrom 0 5\nline s to 1 5\nline e to 1 6\nline n to 0 6\ncontact c.s b.n mu 0.1\n"
                            "fix b.s\nfix d.s x y\ntraction d.n turn 1\n";
  const Reading reading = read(three);
  REQUIRE_FALSE(reading.faults.empty());
  bool seen = false;
  for (const Fault& f : reading.faults) seen = seen || f.text.find("nothing keeps body 'd' from turning, expected a tie") == 0;
  CHECK(seen);
}
