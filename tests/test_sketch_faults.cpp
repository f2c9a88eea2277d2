// What is wrong with sketches: statements, shapes, statements that contradict each other, and sketches with words at random.
#include "paths.hpp"
#include "shell.hpp"
#include "sketches.hpp"

#include <cstdint>
#include <fstream>
#include <sstream>

using namespace sketch;
using namespace sketches;

namespace {

const std::string kHeld = std::string(kSquare) + "fix b.s\n";                // 7 lines
const std::string kTwo = kHeld + "copy c of b shift 0 1\ncontact b.n c.s\n"; // 9 lines

} // namespace

TEST_CASE("sketch: what is wrong is told at its place") {
  tells("boddy b E 1 nu 0\n", "1:1 'boddy': expected a statement, did you mean 'body'?");
  tells("Title x\n" + kHeld, "did you mean 'title'?");
  tells("parameters a 1\n" + kHeld, "did you mean 'parameter'?");
  tells("load a 1\n" + kHeld, "'load': expected a statement, such as body");
  // What follows from a fault is not told.
  tells("boddy b E 1 nu 0\nfrom 0 0\nline s to 1 0\nfix b.s\n", "1:1");
  tells("body b E 1 v 0\nfrom 0 0\nline s to 1 0\nline to 0 1\nline close\nfix b.s\n", "1:12 'v': expected E, nu or fatigue");
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1\nline to 0 1\nline close\nfix b.s\n", "3:12 the statement ends here");
  tells("body 7 E 1 nu 0\nfrom 0 0\nline s to 1 0\nline to 0 1\nline close\nfix b.s\n", "1:6 '7': expected the name of a body");
  tells("body a E 1 nu 0\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline to 0 1\nline close\nfix b.s\n", "1:1 body 'a' has no");
  tells("body b E 1 nu 0\nfrom 0 0\nline s 1 0\nline to 0 1\nline close\n", "3:8 '1': expected to x y, by dx dy, or close");
  tells("body b E 1 nu 0\nfrom (0, 0)\nline to 1 0\nline to 0 1\nline close\n", "a bracket contains one value");
  tells("line a to 1 0\n", "1:1 'line' stands outside a body");
  tells("body b nu 0.3\n", "expected E and a value, or rigid");
  tells("body b E -1 nu 0.3\n", "1:10 -1: expected Young's modulus, above 0");
  tells("body b E 1 nu 0.6\n", "at most 0.5");
  tells("parameter a 1 a 2\n", "1:15 parameter 'a' is defined twice");
  tells("parameter a\n", "1:12 the statement ends here, expected the value of a");
  tells(std::string(kSquare) + "fix b.top\n", "7:5 body 'b' has no curve 'top'");
  tells(std::string(kSquare) + "fix c.n\n", "no body is called 'c'");
  tells(std::string(kSquare) + "fix n\n", "expected a body, a dot and curves of the body");
  tells(std::string(kSquare) + "history pull 1\n", "no load case is called 'pull'");
  tells(std::string(kSquare) + "drive b x 1\n", "body 'b' is not rigid");
  tells(std::string(kSquare) + "platen b.n x 1 force 1 0\n", "both a motion and its load are given");
  tells(std::string(kSquare) + "fix b.n z\n", "7:9 'z': expected x or y");
  tells(std::string(kSquare) + "fix b.n x 3\n", "3: expected 0, or the statement 'move'");
  CHECK(read(std::string(kSquare) + "fix b.n x=0, y=0\n").faults.empty());
  CHECK(read("parameter y 3\n" + std::string(kSquare) + "fix b.n x y\n").faults.empty());
  tells(std::string(kSquare) + "body b E 1 nu 0\n", "another body is called 'b', expected a new name");
  tells("body b E 1 nu 0\nfrom 0 0\narc to 1 0 radius 0.2\nline close\n", "expected at most twice the radius");
  tells("body b E 1 nu 0\nfrom 0 0\narc to 1 0 through 2 0\nline close\n", "on one line, expected points of an arc");
  tells("body b E 1 nu 0\nspline file nothing.csv closed\n", "the file 'nothing.csv' cannot be read");
  tells("title nothing\n", "the sketch has no body, expected at least one");
  CHECK(read(kSquare, {{"mu", 1}}).parameters.empty());
  const sketch::Reading given = read(std::string("parameter mu 2\n") + kSquare, {{"mu", 1}});
  CHECK(given.sketch.parameters.at("mu") == 1);
  CHECK(given.parameters == std::set<std::string>{"mu"});
}

TEST_CASE("sketch: what is wrong with shapes") {
  tells("body b E 1 nu 0\nfrom 0 0\nline to 1 0\nline to 1 1\nline last to 0 1\n",
        "5:1 body 'b': the outline is open: curve 'last' ends at (0, 1)");
  tells("body b E 1 nu 0\nfrom 0 0\nline to 0 1\nline to 1 1\nline to 1 0\nline close\n", "is drawn clockwise");
  tells("body b E 1 nu 0\nfrom 0 0\nline to 2 0\nline to 0 1\nline up to 2 1\nline close\n", "crosses");
  tells(std::string(kSquare) + "circle centre 0.5 0.5 radius 0.1\n",
        "7:1 body 'b': the outline lies inside the outline of line 2");
  tells(std::string(kSquare) + "hole\ncircle centre 3 3 radius 0.1\n", "the hole lies outside the outline of the body");
  tells(std::string(kSquare) + "body c E 1 nu 0\nfrom 0.5 0.5\nline to 2 0.5\nline to 2 2\nline to 0.5 2\nline close\n",
        "bodies 'b' and 'c' overlap by 0.5 at (0.5, 0.5)");
  tells("body b E 1 nu 0\nfrom 0 0\nline to 1 0\nfillet radius 3\nline to 1 1\nline to 0 1\nline close\n", "does not fit");
}

TEST_CASE("sketch: names, and statements that stand once") {
  const std::string long_name(32, 'n');
  tells("body " + long_name + " E 1 nu 0\n", "expected at most 31 bytes");
  tells(kHeld + "copy " + long_name + " of b shift 3 0\n", "8:6 '" + long_name + "': expected at most 31 bytes");
  tells(kTwo + "contact b.e c.w name " + long_name + "\n", "expected at most 31 bytes");
  tells(kTwo + "contact b.e c.w name \"a!b\"\n", "expected a name without '!'");
  tells("body \"my body\" E 1 nu 0\n", "1:6 'my body': expected the name of a body");
  tells("parameter a-b 1\n", "expected letters, digits and _");
  tells("title a\ntitle b\n" + kHeld, "2:1 the title is given twice");
  tells("title " + std::string(73, 'x') + "\n" + kHeld, "the title has 73 bytes, expected at most 72");
  tells("units mm N\nunits mm kN\n" + kHeld, "is given twice");
  tells("functions linear\nfunctions cubic\n" + kHeld, "is given twice");
  tells("plane stress\nplane strain\n" + kHeld, "is given twice");
  tells("steps 5\nsteps 6\n" + kHeld, "is given twice");
  tells("tolerance 1 %\ntolerance off\n" + kHeld, "is given twice");
  tells("limit seconds 5 seconds 6\n" + kHeld, "the limit 'seconds' is given twice");
}

TEST_CASE("sketch: bodies of revolution and their axis") {
  tells("plane strain\naxisymmetric\n" + kHeld, "2:1 the statement 'plane' or 'axisymmetric' is given twice, expected once");
  tells(kHeld + "axisymmetric\n", "8:1 'axisymmetric' stands after a body, expected it before the first body");
  tells("symmetry x 0\naxisymmetric\n", "a line of symmetry x is given, bodies of revolution have the axis x = 0");
  tells("axisymmetric\nsymmetry x 1\n", "the line of symmetry x is given twice");
  const std::string revolved = "axisymmetric\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\n";
  CHECK(read(revolved + "fix b.s y\nforce b at 0.5 0.5 fy -1\n").faults.empty());
  for (const char* motion : {"x 1", "moment 1", "fx 2"})
    tells(revolved + "platen b.n " + motion + "\n",
          "a rigid part of a body of revolution moves along y and turns round the axis, expected y, fy or turn");
  CHECK(read(revolved + "fix b.s y\nplaten b.n fy -1\n").faults.empty());
  tells(revolved + "weight b fx 1 fy -1\n", "a weight along x on a body of revolution, expected one along its axis, fy");
  tells(revolved + "spin b 1 about 0.5 0\n", "a body of revolution turns about x = 0, expected an axis there");
  CHECK(read(revolved + "fix b.s y\nweight b fy -1\nspin b 1\n").faults.empty());
  tells("axisymmetric\n" + kHeld, "lies on the axis x = 0; do not draw this curve");
  tells("axisymmetric\nbody b E 1 nu 0\nfrom -1 0\nline s to 1 0\nline e to 1 1\nline n to -1 1\nline w close\nfix b.s\n",
        "the outline crosses the axis x = 0, expected a half section at x >= 0");
  tells("axisymmetric\nbody b E 1 nu 0\nfrom -2 0\nline s to -1 0\nline e to -1 1\nline n to -2 1\nline w close\nfix b.s\n",
        "the outline crosses the axis x = 0, expected a half section at x >= 0");
}

TEST_CASE("sketch: conditions that contradict each other") {
  tells(kHeld + "case one\nmove b.s x 1\n", "9:1 b.s has a displacement along x in line 7, expected only one");
  CHECK(read(std::string(kSquare) + "case one\nfix b.s\ncase two\nmove b.s x 1\nhistory two 1\n").faults.empty());
  tells(kHeld + "move b.s x 0.1\n", "8:1 b.s has a displacement along x in line 7, expected only one");
  tells(kHeld + "move b.s.end y 1\n", "8:1 b.s has a displacement along y in line 7, expected only one");
  tells(kHeld + "traction b.s y 3\n",
        "8:1 b.s has a displacement along y in line 7, expected a displacement or a traction, not both");
  tells(std::string(kSquare) + "fix b.s\ncase two\ntraction b.s y 3\nhistory two 1\n", "9:1 b.s has a displacement");
  tells(std::string(kSquare) + "traction b.n+s x 1\nfix b.e+s x\n", "8:1 b.s has a traction along x in line 7");
  tells(kHeld + "pressure b.s 3\n", "8:1 b.s has a displacement in line 7, expected a displacement or a pressure, not both");
  tells(std::string(kSquare) + "fix b.s y\npressure b.s 3\n", "8:1 b.s has a displacement in line 7");
  CHECK(read(std::string(kSquare) + "fix b.s x\npressure b.s 3\nfix b.n y\n").faults.empty()); // along its normal
  CHECK(read(kHeld + "fix b.s x\ncase two\nmove b.n x 1\nhistory two 1\n").faults.empty());
  CHECK(read(kHeld + "traction b.n x 1\npressure b.n 1\ntraction b.n x 1 y 2\n").faults.empty()); // loads add
  CHECK(read(std::string(kSquare) + "fix b.s.start\ntraction b.s y 1\nfix b.s.end y\n").faults.empty());
  tells(kHeld + "move b.e y 2\n", "8:1 b.s and b.e meet, but have the displacements 0 and 2 along y, expected equal values");
  tells(kHeld + "move b.w.end x 2\n", "8:1 b.w and b.s meet, but have the displacements 2 and 0 along x");
  CHECK(read(kHeld + "move b.w.start x 2\n").faults.empty());
  tells(kHeld + "weight b y 1\nweight b x 1\n", "the weight of the body in this load case is given twice");
  tells(kHeld + "spin b 1 about 0 0\nspin b 2\n", "the rotation of the body in this load case is given twice");
  tells(kHeld + "spin b 0\n", "expected density times the square of the angular velocity, above 0");
}

TEST_CASE("sketch: what moves bodies contradicts itself") {
  const std::string platen = kHeld + "platen b.n about 0 1 fy 1 turn 0\n",
                    rigid = kTwo.substr(0, kTwo.find("copy")) +
                            "body r rigid\nfrom 0 1\nline f to 1 1\nline to 1 2\nline to 0 2\nline close\ncontact b.n r.f\n";
  tells(platen + "platen b.n fx 1\n", "9:8 the same platen has a statement in line 8 in this load case");
  tells(platen + "case two\nplaten b.n about 0 2 fx 1\nhistory two 1\n", "the reference point differs from that of line 8");
  tells(platen + "case two\nplaten b.n y 2\nhistory two 1\n", "the load of y is given in line 8, expected loads in all");
  tells(platen + "case two\nplaten b.n moment 2\nhistory two 1\n", "the motion of turn is given in line 8");
  tells(kHeld + "platen b.n fx 1 force 1 2\n", "the force along x is given twice");
  tells(kHeld + "platen b.n+e fx 1\nplaten b.e fx 1\n", "9:1 b.e is on a platen in line 8");
  tells(kHeld + "platen b.s fx 1\n", "8:1 b.s is given a displacement or a load in line 7");
  tells(kHeld + "platen b.n fy 1\nfix b.n.end x\n", "8:1 b.n is given a displacement or a load in line 9");
  tells(kTwo + "platen c.s fx 1\n", "10:1 c.s is on a side of an interface in line 9");
  tells(rigid + "platen r.f x 1\n", "body 'r' is rigid, expected the statement 'drive'");
  tells(rigid + "drive r x 1\ndrive r y 1\n", "the same body has a statement in line");
  tells(rigid + "fix r.f\n", "body 'r' is rigid: expected 'drive' for its motion and loads");
  tells(rigid + "weight r x 1\n", "body 'r' is rigid");
  tells(rigid + "force r at 0.5 1.5 x 1\n", "body 'r' is rigid");
  tells(rigid + "want stress r 0.5 1.5\n", "body 'r' is rigid: it has no stresses");
}

TEST_CASE("sketch: loads that nothing applies, points that lie nowhere, bodies that nothing holds") {
  tells(kHeld + "traction b.n y 1\ncase two\ntraction b.n y 1\nhistory two 1\n",
        "8:1 this load stands before the first load case");
  tells(kHeld + "case one\ntraction b.n y 1\ncase two\ntraction b.n y 1\n", "11:1 load case 'two' is never applied, expected");
  tells(kHeld + "case one\ntraction b.n y 1\ncase two\nforce b at 0.5 0.5 x 1\nhistory one 1\n",
        "11:1 load case 'two' is never applied, expected");
  CHECK(read(kHeld + "case one\ntraction b.n y 1\nhistory one 1\n").faults.empty()); // supports before the first case
  const std::string second = kHeld + "case one\ntraction b.n y 1\ncase two\n";       // 10 lines
  for (const char* loads : {"spin b 3 about 1 0\n", "weight b y -1\n", "force b at 0.5 0.5 y 2\ntraction b.e x 1\n",
                            "traction b.e x 1\nforce b at 0.5 0.5 y 2\n", "platen b.w fy 1\n", "platen b.w x 1\n"})
    tells(second + loads + "history one 1\n", "11:1 load case 'two' is never applied, expected");   // the first of the loads
  CHECK(read(second + "force b at 0.5 0.5 x 0\nweight b x 0 y 0\nhistory one 1\n").faults.empty()); // no loads
  CHECK_FALSE(read(std::string(kSquare) + "weight b y -1\n").faults.empty());                       // nothing holds it
  tells(kHeld + "pressure b.n 1\nfix b.n\n",
        "9:1 b.n has a pressure in line 8, expected a displacement or a pressure, not both");
  tells(kHeld + "move b.n x 0.1\nmove b.n x 0.2\n", "9:1 b.n has a displacement along x in line 8, expected only one");
  tells(kHeld + "want stress b 0.5 1.25\n", "8:1 the point (0.5, 1.25) is not inside body 'b': 0.25 outside it");
  tells(kHeld + "want stress b 0.5 1\n", "on its boundary");
  tells(kHeld + "stress b 2 0.5\n", "8:1 the point (2, 0.5) is not inside body 'b': 1 outside it");
  tells(kHeld + "force b at 5 5 x 1\n", "the force at (5, 5) is not inside body 'b'");
  tells("symmetry x 0\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nfix b.s\n"
        "force b at 0 0.5 x 1 y 2\n",
        "8:1 the force at (0, 0.5) acts across the line of symmetry x = 0, expected one along it");
  tells(kHeld + "want pressure\n", "the sketch has no contact");
  tells(std::string(kSquare) + "platen b.n turn 0 fy 1\n", "1:1 body 'b' has no support");
  tells(std::string(kSquare) + "traction b.n y 1\n", "1:1 body 'b' has no support, expected fix");
  tells(kTwo + "body d E 1 nu 0\ncircle centre 9 9 radius 1\n", "10:1 body 'd' has no support");
  tells(std::string(kSquare) + "platen b.n fy 1 x 0\ncopy c of b shift 0 3\ncopy d of c shift 0 1\ntie c.n d.s\nfix b.s\n",
        "2 faults"); // c and d hold each other
  tells(kTwo + "contact c.s+e b.n\n", "10:1 c.s and b.n are already the sides of the interface in line 9");
  tells(kHeld + "case pull\nhistory push 1\n", "9:9 no load case is called 'push', expected 'pull'");
  tells(kTwo + "contact b.e b.e\n", "10:1 b.e is on both sides");
  CHECK(read(kTwo + "copy d of c shift 0 1\ntie c.n d.s\n").faults.empty());
}

TEST_CASE("sketch: supports and sides that are not there") {
  tells(std::string(kSquare) + "fix b.top\n", "'top', expected 's', 'e', 'n' or 'w'");
  tells("body b E 1 nu 0\ncircle centre 0 0 radius 1\nfix b.face\n", "expected curves with names");
  tells(kHeld + "fix b.n.middle\n", "8:5 'b.n.middle': expected start or end");
  tells(kHeld + "fix b.n+e.start\n", "several curves are named, expected a single one");
  tells(kHeld + "traction b.n.start y 1\n", "expected a body, a dot and curves of the body");
  tells(kHeld + "traction b.n+n y 1\n", "'n' is named twice");
}

TEST_CASE("sketch: tolerances, limits, wants") {
  tells("tolerance 1\n" + kHeld, "1:11 1: expected a tolerance above 0 and at most 50 %");
  tells("tolerance 0\n" + kHeld, "expected a tolerance above 0");
  tells("tolerance fine\n" + kHeld, "'fine': expected a tolerance, such as 1 %, or off");
  tells("limit memory 3\n" + kHeld, "expected seconds, elements or work");
  tells("limit elements 2.5\n" + kHeld, "a whole number");
  tells("steps 0\n" + kHeld, "a whole number");
  tells(kTwo + "want peak\n", "'peak': expected pressure, edges");
  tells(kTwo + "want presure\n", "hoop, fatigue or cycle, did you mean 'pressure'?");
  tells(kTwo + "want contact edges\n", "'contact': expected pressure, edges");
  tells(kTwo + "want stress b 0.5\n", "expected y of a point");
  tells(kTwo + "want hoop b\n", "expected a body, a dot and curves of the body");
  tells(kTwo + "want pressure 1 % 2 %\n", "'2': expected pressure, edges");
}

TEST_CASE("sketch: a misspelt parameter is answered by the one that may be meant, a short word is not") {
  const std::string with = "parameter friction 0.2 t 1\n" + std::string(kTwo);
  tells(with + "steps frictoin\n", "'frictoin': expected ");
  tells(with + "steps frictoin\n", ", did you mean 'friction'?");
  tells(with + "steps tt\n", "'tt': expected");
  CHECK(fault(with + "steps tt\n").find("did you mean") == std::string::npos);
}

TEST_CASE("sketch: the name of a number in tables requests it") {
  const std::vector<std::pair<std::string, const char*>> names = {
      {"contact width", "width"}, {"half width 2 %", "width"}, {"stuck width", "stick"},      {"eccentricity", "stick"},
      {"stick border", "edges"},  {"force x", "forces"},       {"peak pressure", "pressure"}, {"dissipated", "dissipation"}};
  for (const auto& [name, word] : names) {
    CAPTURE(name);
    const Sketch s = sound(kTwo + "want " + name + "  approach\n");
    REQUIRE(s.wants.size() == 2);
    CHECK((s.wants[0].word == word && s.wants[1].word == "approach"));
  }
}

TEST_CASE("sketch: parts of curves that are not there") {
  const auto part = [](const std::string& text) { return std::string(kSquare) + "part " + text + "\n"; };
  tells(part("m of top from x 0.2 to x 0.5"), "7:11 body 'b' has no curve 'top' before this statement");
  tells(part("m of s from x 0.5 to x 0.2"), "the end of the part is not after its start");
  tells(part("m of s from 0.2 to 3"), "the length 3 is not on the curve, expected a length from 0 to 1");
  tells(part("m of s from x 0.5 to x 7"), "the curve has no point with x = 7");
  tells(part("m of s from angle 0 to x 0.5"), "expected an arc or a circle");
  tells(part("m of s from x 0.2 to x 0.5\npart k of s from x 0.4 to x 0.8"),
        "8:29 this range contains a part with another name");
  tells(part("s of s from 0 to 0.5"), "expected another name");
  tells("body b E 1 nu 0\ncircle f centre 0 0 radius 1\npart m of f from x -0.5 to x 0.5\n", "2 points with x = -0.5");
  tells("body b E 1 nu 0\nfrom 0 0\narc f to 2 0 through 1 -1\npart m of f from angle -90 to angle 30\nline close\n",
        "the arc goes from 180 to 360 degrees, 30 degrees is not on it");
  tells("body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nfillet radius 0.1\npart m of s from 0 to 0.5\nline to 1 1\nline close\n",
        "5:1 'part' stands between a fillet or chamfer");
  tells("part m of s from 0 to 1\n", "1:1 'part' stands outside a body");
}

TEST_CASE("sketch: lines of symmetry and what is drawn") {
  tells("symmetry x 0\nbody b E 1 nu 0\ncircle centre 0 3 radius 1\n", "crosses the line of symmetry x = 0");
  tells("symmetry x 0\nbody b E 1 nu 0\nfrom 0 0\nline to 1 0\nline to 1 1\nline to 0 1\nline left close\n",
        "7:1 body 'b': curve 'left' lies on the line of symmetry x = 0");
  tells("symmetry x 0\nbody b E 1 nu 0\nfrom 0 1\nline to 1 1\nline to 1 0\nline to 0 0\n", "is drawn clockwise");
  tells(std::string(kSquare) + "symmetry x 0\n",
        "7:1 the line of symmetry stands after a body, expected it before the first body");
  CHECK(read("symmetry x 0\nbody b E 1 nu 0\ncircle centre 2 3 radius 1\n").faults.empty()); // beside its image
  // A quarter of a ring: its outer arc and its inner one go from line to line.
  const std::string ring = "symmetry x 0\nsymmetry y 0\nbody b E 1 nu 0\nfrom 2 0\narc out centre 0 0 turn 90\n"
                           "outline\nfrom 0 1\narc in centre 0 0 turn -90\n";
  CHECK(read(ring + "want stress b 1 1\nforce b at 0 1.5 y 1\nforce b at 1.5 0 x 1\n").faults.empty()); // on the lines, too
  tells(ring + "force b at 0 0.5 y 1\n", "is not inside body 'b': 0.5 outside it");
  tells(ring + "want stress b 0.5 0.5\n", "is not inside body 'b': 0.292893 outside it");
}

TEST_CASE("sketch: how much bodies overlap, between lines of symmetry, along curves, and crosswise") {
  // Two circles, their centres 1.9 apart: by 0.1, in the middle.
  tells("body b E 1 nu 0\ncircle centre 0 0 radius 1 from 0\nbody c E 1 nu 0\ncircle centre 1.9 0 radius 1 from 180\n",
        "3:1 bodies 'b' and 'c' overlap by 0.1 at (0.9, ");
  CHECK(
      read("body b E 1 nu 0\ncircle centre 0 0 radius 1 from 0\nbody c E 1 nu 0\ncircle centre 2 0 radius 1\n").faults.empty());
  // A pin in a hole as large as it; a thousandth larger.
  const auto pin = [](const std::string& radius) {
    return "body b E 1 nu 0\ncircle centre 0 0 radius 3\nhole\ncircle centre 0 0 radius 1\nbody c E 1 nu 0\n"
           "circle centre 0 0 radius " +
           radius + "\n";
  };
  CHECK(read(pin("1")).faults.empty());
  tells(pin("1.001"), "overlap by 0.001");
  CHECK(read("interference\n" + pin("1.001")).faults.empty()); // a press fit
  tells("symmetry x 0\nbody b E 1 nu 0\nfrom 0 0\nline to 1 0\nline to 1 1\nline to 0 1\n"
        "body c E 1 nu 0\nfrom 0 0.75\nline to 1 0.75\nline to 1 2\nline to 0 2\n",
        "7:1 bodies 'b' and 'c' overlap by 0.25");
  // A cross: no corner of either lies in the other.
  tells("body b E 1 nu 0\nfrom -5 -1\nline to 5 -1\nline to 5 1\nline to -5 1\nline close\n"
        "body c E 1 nu 0\nfrom -1 -5\nline to 1 -5\nline to 1 5\nline to -1 5\nline close\n",
        "7:1 bodies 'b' and 'c' overlap by ");
}

namespace {

uint32_t drawn(uint32_t& state) { // xorshift
  state ^= state << 13, state ^= state >> 17, state ^= state << 5;
  return state;
}

// The page's sketch and statements that it has not, as words of lines.
std::vector<std::vector<std::string>> lines_of_page() {
  std::ifstream file(paths::root() + "/src/program/sketch/SKETCH.md");
  std::ostringstream page;
  page << file.rdbuf();
  const size_t begin = page.str().find("```\n") + 4;
  std::istringstream text(page.str().substr(begin, page.str().find("```", begin) - begin) +
                          "body ring E 1 nu 0.3\ncircle out centre 40 0 radius 9\nhole\ncircle in centre 40 0 radius 5\n"
                          "part seat of in from angle 45 to angle 0\nbody lens rigid\nspline s through 60 0 70 5 60 9 closed\n"
                          "fix ring.out.start\npressure ring.seat 1\nwant pressure 1 % stress block 0 -3 hoop ring.in 2 %\n");
  std::vector<std::vector<std::string>> out;
  for (std::string line; std::getline(text, line);) {
    out.emplace_back();
    std::istringstream words(line.substr(0, line.find('!')));
    for (std::string word; words >> word;) out.back().push_back(word);
    if (out.back().empty()) out.pop_back();
  }
  return out;
}

} // namespace

TEST_CASE("sketch: the program tells faults at their places, and takes parameters") {
  const test::Folder folder;
  const std::string file = folder / "a.c2s", command = "'" + paths::program() + "' ";
  test::write_file(file, "boddy b E 1 nu 0\n");
  const test::Result wrong = test::run_shell(command + "check '" + file + "'");
  CHECK(wrong.status == 2);
  CHECK(test::contains(wrong.err,
                       "a.c2s:1:1: error: 'boddy': expected a statement, did you mean 'body'?\nboddy b E 1 nu 0\n^~~~~"));
  test::write_file(file, "parameter a 2 b 3*a\n" + kHeld + "pressure b.n b\nstress b 0.5 a/10\n");
  const test::Result five = test::run_shell(command + "mesh --set a=5 '" + file + "'");
  CHECK(five.status == 0);
  CHECK((test::contains(five.out, " 0 -15 0 0\n") && test::contains(five.out, "point 1 0.5 0.5\n")));
  const test::Result unknown = test::run_shell(command + "mesh --set c=5 '" + file + "'");
  CHECK(unknown.status == 64); // as of a deck, below
  CHECK(test::contains(unknown.err, "no parameter of this sketch is called 'c'"));
  CHECK(test::run_shell(command + "mesh '" + file + "' a=5").out == five.out);
  const test::Result word = test::run_shell(command + "run '" + file + "' a=five");
  CHECK(word.status == 64);
  CHECK(test::contains(word.err, "a=five: expected the name of a parameter, = and a number"));
  CHECK(test::contains(test::run_shell(command + "run '" + file + "' a").err, "more than one deck"));
  CHECK(test::contains(test::run_shell(command + "convert '" + file + "' a=5").err, "more than one deck"));
  const test::Result deck = test::run_shell(command + "check '" + paths::root() + "/examples/hertz.dat' a=5");
  CHECK(deck.status == 64);
  CHECK(test::contains(deck.err, "the deck has no parameter a: expected {a} in a card"));
}

TEST_CASE("sketch: words left out, doubled and exchanged are told, or make a deck") {
  const std::vector<std::vector<std::string>> whole = lines_of_page();
  uint32_t state = 20260;
  int told = 0, made = 0;
  for (int round = 0; round < 60; ++round) {
    auto lines = whole;
    for (uint32_t k = 0; k < 1 + drawn(state) % 2; ++k) {
      auto& line = lines[drawn(state) % lines.size()];
      const auto word = line.begin() + static_cast<std::ptrdiff_t>(drawn(state) % line.size());
      const auto& other = whole[drawn(state) % whole.size()];
      const uint32_t what = drawn(state) % 3;
      if (what == 0 && line.size() > 1) line.erase(word);
      if (what == 1) line.insert(word, std::string(*word));
      if (what == 2) *word = other[drawn(state) % other.size()];
    }
    std::string text;
    for (const auto& line : lines)
      for (size_t i = 0; i < line.size(); ++i) text += line[i] + (i + 1 == line.size() ? "\n" : " ");
    CAPTURE(text);
    const Reading r = read(text);
    for (const Fault& f : r.faults) CHECK((f.at.line <= static_cast<int>(lines.size()) && !f.text.empty()));
    try {
      if (!r.faults.empty()) throw r.faults[0];
      CHECK(deck_of(r.sketch, first_mesh(r.sketch, 0.5)).size() > 100);
      ++made;
    } catch (const Fault&) {
      ++told;
    }
  }
  CHECK(told > 20);
  CHECK(made > 3);
}
