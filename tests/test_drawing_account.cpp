// Drawings lose nothing in silence: what is hidden, rounded, stretched, partitioned, crossing or a press fit, in files of tools
// and in drawings written here, and what the head of a sketch says of it.
#include "paths.hpp"
#include "program/drawing/loops.hpp"
#include "program/drawing/placing.hpp"
#include "program/drawing/read.hpp"
#include "program/drawing/write.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"
#include "shell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>

using sketch::Point;

namespace {

const double kPi = std::acos(-1.0);

struct Sketched {
  std::string text, notes; // of the sketch; all notes, a line each
  sketch::Sketch sketch;
  std::vector<double> areas; // of the bodies
};

// By Gauss's rule along every curve.
double area_within(const sketch::Body& body) {
  double sum = 0;
  for (const sketch::Outline& outline : body.outlines)
    for (const sketch::Curve& curve : outline.curves) {
      const int n = curve.shape->form() == sketch::Form::kLine ? 1 : 400;
      for (int i = 0; i < n; ++i)
        for (const double g : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) {
          const sketch::Shape::Local p = curve.shape->local((i + 0.5 + 0.5 * g) / n);
          sum += (g == 0 ? 4.0 : 2.5) / 9 * sketch::cross(p.at, p.d) / (2 * n);
        }
    }
  return sum;
}

sketch::Reading reading_of(const std::string& text) {
  return sketch::read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
}

Sketched sketched(const std::string& drawing) {
  Sketched out;
  std::vector<std::string> notes;
  out.text = drawing::sketch_of(drawing::read_drawing(drawing, 0, notes), "a drawing", {}, &notes);
  for (const std::string& note : notes) out.notes += note + "\n";
  const sketch::Reading reading = reading_of(out.text);
  INFO(out.text);
  for (const sketch::Fault& fault : reading.faults) MESSAGE(fault.text);
  REQUIRE(reading.faults.empty());
  out.sketch = reading.sketch;
  for (const sketch::Body& body : out.sketch.bodies) out.areas.push_back(area_within(body));
  return out;
}

Sketched sketched_file(const std::string& name) { return sketched(test::read_file(paths::data() + "/drawings/" + name)); }

void check_note(const Sketched& d, const std::string& note) {
  INFO(d.notes);
  CHECK_MESSAGE(test::contains(d.notes, note), note);
}

// What is wrong with a drawing that has no body.
std::string refusal(const std::string& drawing) {
  std::vector<std::string> notes;
  try {
    drawing::read_drawing(drawing, 0, notes);
  } catch (const drawing::Fault& fault) {
    return std::to_string(fault.line) + ": " + fault.text;
  }
  return "";
}

// Codes and values with blanks between, as the lines of a DXF file.
std::string in_lines(std::string words) {
  std::replace(words.begin(), words.end(), ' ', '\n');
  return words + "\n";
}
std::string file_of(const std::string& entities, const std::string& before = "") {
  return before + in_lines("0 SECTION 2 ENTITIES") + in_lines(entities) + in_lines("0 ENDSEC 0 EOF");
}
const char* const kPlate = "0 LWPOLYLINE 8 plate 70 1 10 0 20 0 10 10 20 0 10 10 20 6 10 0 20 6"; // of area 60

// The area between a cubic Bezier curve and the rays to its ends from the origin, by the closed form of its polynomials.
double bezier_area(Point a, Point b, Point c, Point d) {
  return 0.3 * (sketch::cross(a, b) + sketch::cross(c, d)) +
         0.15 * (sketch::cross(a, c) + sketch::cross(b, c) + sketch::cross(b, d)) + 0.05 * sketch::cross(a, d);
}

// The sketch with its examples, without the ! before them.
std::string with_examples(const std::string& text) {
  std::string out;
  bool examples = false;
  for (const std::string& line : test::lines_of(text)) {
    out += (examples ? line.substr(2) : line) + "\n";
    examples = examples || test::contains(line, "Examples; remove");
  }
  return out;
}

// The sketch read as a press fit: as its comments say.
std::string as_press_fit(const std::string& text) {
  std::vector<std::string> out;
  bool outline = false;
  for (const std::string& line : test::lines_of(text)) {
    outline = outline && line.compare(0, 4, "!   ") == 0;
    if (line == "! In a press fit, instead of the outline above:") {
      out.pop_back(); // a circle
      outline = true;
    } else {
      const bool stands = outline || line == "! interference" || line.compare(0, 9, "! contact") == 0;
      out.push_back(stands ? line.substr(2) : line);
    }
    if (test::contains(line, "Examples; remove")) break;
  }
  std::string all;
  for (const std::string& line : out) all += line + "\n";
  return all;
}

} // namespace

TEST_CASE("drawing: what is not to be seen is left out, and said") {
  const Sketched d = sketched_file("layers.dxf");
  REQUIRE(d.areas.size() == 1);
  CHECK(d.areas[0] == doctest::Approx(800 - 5 * kPi).epsilon(1e-10)); // a hole of its own and one in a block
  CHECK(test::contains(d.text, "line plate to 40 0"));                // the layer of the table, not as the entity spells it
  for (const char* note : {"read: 2 CIRCLE, 1 INSERT, 1 LWPOLYLINE", ": layer 'off' is off", ": layer 'frozen' is frozen",
                           "left out: 1 LINE (line", ": layer 'helper' is not plotted", "left out: 1 XLINE (line",
                           "left out: 1 RAY (line", ": a construction line", "left out: 1 INSERT (line", ": in paper space"})
    check_note(d, note);
  CHECK(test::contains(d.text, "! left out: 1 RAY (line"));
}

TEST_CASE("drawing: layers of construction, and entities of blocks on layers of their own") {
  const std::string tables =
      in_lines("0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 plate 70 4 62 7 "
               "0 LAYER 2 lines 70 0 62 7 1001 ACAD 1070 0 1001 LibreCad 1070 1 "
               "0 LAYER 2 plain 70 0 62 7 290 1 1001 LibreCad 1070 0 1001 OTHER 1070 1 0 ENDTAB 0 ENDSEC");
  const std::string block = in_lines(
      "0 SECTION 2 BLOCKS 0 BLOCK 2 B 10 0 20 0 0 CIRCLE 8 0 10 3 20 3 40 1 0 CIRCLE 8 plain 10 6 20 3 "
      "40 1 0 CIRCLE 8 lines 10 8 20 3 40 1 0 ENDBLK 0 BLOCK 2 far 70 4 0 ENDBLK 0 BLOCK 2 odd 10 x 0 ENDBLK 0 ENDSEC");
  const auto with = [&](const std::string& entities) {
    return sketched(file_of(std::string(kPlate) + " " + entities, tables + block));
  };
  const Sketched seen = with("0 INSERT 8 plate 2 b 10 0 20 0 0 CIRCLE 8 LINES 10 2 20 2 40 1");
  CHECK(seen.areas[0] == doctest::Approx(60 - 2 * kPi));
  check_note(seen, "left out: 2 CIRCLE (from line");
  check_note(seen, ": layer 'lines' is a construction layer");
  // What is on layer 0 of a block that is put on a layer goes with that one.
  const Sketched half = with("0 INSERT 8 lines 2 b 10 0 20 0");
  CHECK(half.areas[0] == doctest::Approx(60 - kPi));
  check_note(with("0 INSERT 8 plate 2 far 10 0 20 0"), ": block 'far': it is in another file");
  check_note(with("0 INSERT 8 plate 2 odd 10 0 20 0"), ": block 'odd': its base point is 'x', expected a number");
  const Sketched dim = with("0 INSERT 8 plate 60 1 2 b 10 0 20 0 0 CIRCLE 8 plate 60 1 10 5 20 3 40 1");
  CHECK(dim.areas[0] == doctest::Approx(60));
  check_note(dim, "left out: 1 INSERT (line");
  check_note(dim, ": invisible");
}

TEST_CASE("drawing: one odd entity is left out by its line, the others are read") {
  const struct {
    const char *entity, *note;
  } cases[] = {
      {"0 CIRCLE 8 a 10 5 20 2 40 0", "1 CIRCLE (line 28): radius 0, expected a value above 0"},
      {"0 CIRCLE 8 a 10 5 20 2", "1 CIRCLE (line 28): the radius is missing, expected group 40"},
      {"0 CIRCLE 8 a 10 5 20 2 40 x", "1 CIRCLE (line 36): the radius is 'x', expected a number"},
      {"0 ARC 8 a 10 5 20 2 40 -1 50 0 51 90", "1 ARC (line 28): radius -1, expected a value above 0"},
      {"0 ELLIPSE 8 a 10 5 20 2 11 0 21 0 40 1", "1 ELLIPSE (line 28): the major axis has no length"},
      {"0 LWPOLYLINE 8 a 90 2 70 1 10 5 20 2 10 5 20 2", "1 LWPOLYLINE (line 28): all of its vertices coincide"},
      {"0 SPLINE 8 a 71 3 40 0 40 1 10 0 20 0", "1 SPLINE (line 28): 1 control points, expected more than its degree 3"},
      {"0 POLYLINE 8 a 70 1 0 VERTEX 10 0 20 0 0 LINE 10 0 20 0 11 1 21 1",
       "1 POLYLINE (line 28): no SEQEND after its vertices"},
      {"0 INSERT 8 a 2 none 10 0 20 0", "1 INSERT (line 28): block 'none' is missing"},
      {"0 HATCH 8 a 10 0 20 0", "1 HATCH (line 28): not a supported curve"},
  };
  for (const auto& c : cases) {
    CAPTURE(c.entity);
    const Sketched d = sketched(file_of(std::string(kPlate) + " " + c.entity));
    REQUIRE(d.areas.size() == 1);
    CHECK(d.areas[0] == doctest::Approx(60));
    check_note(d, std::string("left out: ") + c.note);
    CHECK(test::contains(d.text, std::string("! left out: ") + c.note));
  }
  std::string many = kPlate; // more reasons than are told one by one
  for (int i = 1; i <= 30; ++i) many += " 0 CIRCLE 8 a 10 5 20 2 40 -" + std::to_string(i);
  check_note(sketched(file_of(many)), "left out: 10 other entities (from line 228): for other reasons");
}

TEST_CASE("drawing: splines whose control points lie on each other, and angles that are rounded") {
  const Sketched d = sketched_file("rounded.dxf");
  REQUIRE(d.areas.size() == 4);
  CHECK(d.areas[0] == doctest::Approx(50 + 18).epsilon(1e-7));  // the crown: 54 (16 B(4, 3) + 2 B(5, 2)) = 18
  const Point o{20, 5}, a{30, 5}, b{30, 8}, c{25, 9}, e{22, 9}; // handles retracted at both sides of a corner
  const auto from = [&](Point p) { return p - o; };
  CHECK(d.areas[1] ==
        doctest::Approx(50 + bezier_area(from(a), from(b), from(c), from(c)) + bezier_area(from(c), from(c), from(e), from(o)))
            .epsilon(1e-6));
  CHECK(d.sketch.bodies[1].outlines[0].curves.size() == 5);
  CHECK(d.areas[2] == doctest::Approx(kPi * (8 * 4 - 2 * 1)).epsilon(1e-10));
  CHECK(d.areas[3] == doctest::Approx(kPi * (25 - 4)).epsilon(1e-10));
  check_note(d, "repaired: 2 ELLIPSE (from line");
  check_note(d, "repaired: 2 ARC (from line");
}

TEST_CASE("drawing: handles that are retracted at the begin, the end, both, in the middle, and with weights") {
  const auto spline = [](const std::vector<Point>& points, const char* weights) {
    std::string text = "0 SPLINE 8 top 71 3";
    for (size_t i = 0; i < points.size() + 4; ++i) text += " 40 " + std::to_string((std::max<size_t>(i, 3) - 1) / 3 * 1);
    for (const Point& p : points) text += " 10 " + sketch::show(p.x) + " 20 " + sketch::show(p.y);
    return text + weights;
  };
  const std::string base = "0 LINE 8 base 10 0 20 0 11 10 21 0 ";
  const Point a{10, 0}, b{0, 0}, p{9, 6}, q{2, 8};
  for (const auto& [first, second] : {std::pair(a, q), std::pair(p, b), std::pair(p, p), std::pair(q, q)}) {
    const Sketched d = sketched(file_of(base + spline({a, first, second, b}, "")));
    REQUIRE(d.areas.size() == 1);
    CHECK(d.areas[0] == doctest::Approx(bezier_area(a, first, second, b)).epsilon(1e-6));
  }
  // Two pieces that go on smoothly, with handles of no length between them; and a corner.
  const Point m{5, 6};
  for (const double y : {6.0, 8.0}) {
    const Point before{8, 6}, behind{2, y};
    const Sketched d = sketched(file_of(base + spline({a, before, m, m, m, behind, b}, "")));
    REQUIRE(d.areas.size() == 1);
    CHECK(d.areas[0] == doctest::Approx(bezier_area(a, before, m, m) + bezier_area(m, m, behind, b)).epsilon(1e-6));
    CHECK(d.sketch.bodies[0].outlines[0].curves.size() == (y == 6 ? 2 : 3));
  }
  // Weights that are all alike change nothing; a straight one with both handles retracted is a line.
  const Sketched weighted = sketched(file_of(base + spline({a, a, q, b}, " 41 2 41 2 41 2 41 2")));
  CHECK(weighted.areas[0] == doctest::Approx(bezier_area(a, a, q, b)).epsilon(1e-6));
  const Sketched straight = sketched(file_of(base + spline({a, a, m, m}, "") + " 0 LINE 8 base 10 5 20 6 11 0 21 0"));
  CHECK(straight.areas[0] == doctest::Approx(30).epsilon(1e-12));
}

TEST_CASE("drawing: angles that are a whole turn apart but for digits, and small arcs that are none") {
  const auto notes_of = [](const std::string& entity, double hole) {
    const Sketched d = sketched(file_of(std::string(kPlate) + " " + entity));
    REQUIRE(d.areas.size() == 1);
    CHECK(d.areas[0] == doctest::Approx(60 - hole).epsilon(1e-10));
    return d.notes;
  };
  const char* const repaired = ": closed, because its end angles differ only by rounding";
  for (const char* last : {"6.28", "6.2832", "6.28319", "6.283185", "6.2831853", "6.2831854", "6.283185307179586"}) {
    CAPTURE(last);
    const bool is_whole = std::string(last) != "6.28", is_exact = std::string(last).size() > 12;
    const std::string ellipse = "0 ELLIPSE 8 slot 10 5 20 3 11 2 21 0 40 0.5 41 0 42 " + std::string(last);
    const std::string notes = notes_of(ellipse, is_whole ? 2 * kPi : 0);
    CHECK(test::contains(notes, repaired) == (is_whole && !is_exact));
    CHECK(test::contains(notes, "has an open end") != is_whole);
  }
  for (const char* angles :
       {"50 0 51 360", "50 0 51 0", "50 0 51 359.9999", "50 90 51 450.0002", "50 -180 51 180", "50 30 51 29.9999"}) {
    CAPTURE(angles);
    notes_of("0 ARC 8 slot 10 5 20 3 40 2 " + std::string(angles), 4 * kPi);
  }
  const std::string small = notes_of("0 ARC 8 slot 10 5 20 3 40 2 50 30 51 30.001", 0); // 0.00003 long, of 10
  CHECK(test::contains(small, "has an open end"));
}

TEST_CASE("drawing: stretched blocks of a file of ezdxf: areas go with both scales") {
  const Sketched d = sketched_file("stretched.dxf");
  REQUIRE(d.areas.size() == 12);
  const double scales[] = {1, 1, 3, 0.25};
  for (size_t i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(d.areas[3 * i] == doctest::Approx(scales[i] * (12 + kPi / 2)).epsilon(1e-10)); // less a circle and an ellipse
    CHECK(d.areas[3 * i + 1] == doctest::Approx(scales[i] * 2.7).epsilon(1e-5));
    CHECK(d.areas[3 * i + 2] == doctest::Approx(scales[i] * d.areas[2]).epsilon(1e-5));
  }
  check_note(d, "4 INSERT");
}

TEST_CASE("drawing: where points of stretched arcs and ellipses go") {
  const std::string block =
      in_lines("0 SECTION 2 BLOCKS 0 BLOCK 2 b 10 1 20 2 0 ARC 8 rim 10 4 20 2 40 2 50 20 51 200 0 ELLIPSE 8 rim 10 4 20 2 "
               "11 1 21 1 40 0.4 41 0.3 42 2.5 0 ENDBLK 0 ENDSEC");
  for (const std::array<double, 3>& scales : {std::array<double, 3>{2, 3, 0}, {-2, 0.5, 40}, {0.3, -4, 250}, {-1, -7, 10}})
    for (const double normal : {1.0, -1.0}) {
      const double x = scales[0], y = scales[1], turn = scales[2];
      std::vector<std::string> notes;
      drawing::Drawing d;
      const std::string insert = "0 INSERT 2 b 10 7 20 -3 41 " + sketch::show(x) + " 42 " + sketch::show(y) + " 50 " +
                                 sketch::show(turn) + " 230 " + sketch::show(normal);
      try {
        d = drawing::read_drawing(file_of(insert + " " + kPlate, block), 0, notes);
      } catch (const drawing::Fault& fault) {
        FAIL(fault.text);
      }
      const drawing::Motion motion = [&] {
        const double c = std::cos(turn * kPi / 180), s = std::sin(turn * kPi / 180);
        return drawing::Motion{c * x, -s * y, s * x, c * y, 7, -3};
      }();
      const auto placed = [&](Point p) {
        Point q = motion(p - Point{1, 2});
        return normal < 0 ? Point{-q.x, q.y} : q;
      };
      const double angle = 20 * kPi / 180;
      const Point end = placed({4 + 2 * std::cos(angle), 2 + 2 * std::sin(angle)});
      bool found = false; // the open ends are told with their places
      for (const std::string& note : notes)
        found = found || test::contains(note, "has an open end at (" + sketch::rounded(end.x));
      CHECK_MESSAGE(found, sketch::show(end.x));
      const Point tip = placed({4 + std::cos(0.3) - 0.4 * std::sin(0.3), 2 + std::cos(0.3) + 0.4 * std::sin(0.3)});
      found = false;
      for (const std::string& note : notes)
        found = found || test::contains(note, "has an open end at (" + sketch::rounded(tip.x));
      CHECK_MESSAGE(found, sketch::show(tip.x));
    }
}

TEST_CASE("drawing: partitioned meshes of both versions, and meshes that another tool wrote, are what was meshed") {
  for (const char* name : {"pad-parts-v4.msh", "pad-order2-v2.msh", "pad-meshio.msh"}) {
    CAPTURE(name);
    const Sketched d = sketched_file(name);
    REQUIRE(d.areas.size() == 2);
    CHECK((d.sketch.bodies[0].name == "block" && d.sketch.bodies[1].name == "pad"));
    CHECK(d.areas[0] == doctest::Approx(600).epsilon(1e-12));
    CHECK(d.areas[1] == doctest::Approx(140 - 8 * (1 - kPi / 4)).epsilon(1e-10));
    for (const char* curve : {"line bottom", "line top", "line sides", "line loaded", "line flanks", "arc face"})
      CHECK(test::contains(d.text, curve));
  }
  const Sketched parts = sketched_file("pad-parts-v4.msh");
  check_note(parts, ": it separates partitions");
  const Sketched joined = sketched_file("joined-parts-v2.msh");
  REQUIRE(joined.areas.size() == 2);
  CHECK(joined.areas[0] == doctest::Approx(8 - kPi / 4).epsilon(1e-10));
  CHECK(joined.areas[1] == doctest::Approx(4).epsilon(1e-12));
}

TEST_CASE("drawing: odd elements of meshes") {
  const std::string head =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 2 0 0\n3 2 1 0\n4 0 1 0\n5 1 2 0\n$EndNodes\n"
      "$Elements\n";
  // A quadrangle with two corners in one node is a triangle; one with three is nothing.
  const Sketched d =
      sketched(head + "4\n1 3 2 0 1 1 2 3 4\n2 3 2 0 1 4 3 5 5\n3 3 2 0 1 4 5 5 5\n4 1 2 0 7 1 9\n$EndElements\n");
  REQUIRE(d.areas.size() == 1);
  CHECK(d.areas[0] == doctest::Approx(3));
  check_note(d, "left out: 1 face (line 16): it has fewer than three corners");
  check_note(d, "left out: 1 line element (line 17): node 9 is missing");
  check_note(d, "read: 2 faces");
  const std::string cut = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PartitionedEntities\n2\n0\n0 1 0 0\n";
  CHECK(refusal(cut + "9 1 2 1 2 0 0 0 1 0 0\n") == "8: too few numbers for an entity");
  CHECK(refusal(cut + "9 1 2 1 2 0 0 0 1 0 0 3 1\n") == "8: too few numbers for an entity");
  CHECK(refusal(cut + "9 1 2\n") == "8: $PartitionedEntities: 3 numbers in a line, expected 5 or more");
}

TEST_CASE("drawing: outlines that cross are named as crossing") {
  const std::string eight = "0 LWPOLYLINE 8 e 90 4 70 1 10 0 20 0 10 10 20 0 10 0 20 10 10 10 20 10";
  CHECK(refusal(file_of(eight)) ==
        "6: the outline of 'e' in line 6 crosses itself near (5, 5): outlines that cross bound no body");
  // Two lines that cross, and no outline.
  CHECK(test::contains(refusal(file_of("0 LINE 10 0 20 0 11 4 21 4 0 LINE 10 0 20 4 11 4 21 0")),
                       "crosses line in line 6 near (2, 2)"));
  const auto crossings = [](const std::string& entities) {
    std::vector<std::string> notes;
    drawing::read_drawing(file_of(std::string(kPlate) + " " + entities), 0, notes);
    std::string all;
    for (const std::string& note : notes)
      if (test::contains(note, "crosses")) all += note + "\n";
    return all;
  };
  CHECK(crossings("0 CIRCLE 8 r 10 10 20 3 40 1") ==
        "circle of 'r' in line 28 crosses line of 'plate' in line 6 near (10, 2): outlines that cross bound no body\n"
        "circle of 'r' in line 28 crosses line of 'plate' in line 6 near (10, 4): outlines that cross bound no body\n");
  CHECK(test::contains(crossings("0 ELLIPSE 8 r 10 5 20 6 11 2 21 0 40 0.5"),
                       "ellipse of 'r' in line 28 crosses line of 'plate'"));
  CHECK(crossings("0 CIRCLE 8 r 10 5 20 7 40 1").empty());                                   // touches from outside
  CHECK(crossings("0 CIRCLE 8 r 10 5 20 5 40 1").empty());                                   // from inside
  CHECK(crossings("0 CIRCLE 8 r 10 5 20 6.999999 40 1").empty());                            // but for rounding
  CHECK(crossings("0 LINE 8 r 10 2 20 6 11 5 21 9 0 LINE 8 r 10 5 20 9 11 8 21 6").empty()); // open ends on the plate's side
  CHECK_FALSE(crossings("0 CIRCLE 8 r 10 5 20 6.99 40 1").empty());
  // A closed spline that crosses itself once.
  const std::string loop = "0 SPLINE 8 s 70 1 11 20 21 0 11 24 21 4 11 28 21 0 11 24 21 -1 11 20 21 4";
  CHECK(test::contains(crossings(loop), "the outline of 's' in line 28 crosses itself near ("));
}

TEST_CASE("drawing: outlines that nearly are one: doubles, turned ellipses, clearances") {
  const auto with = [](const std::string& entities) { return sketched(file_of(std::string(kPlate) + " " + entities)); };
  // One hole drawn as a circle and as two half circles; a circle that is there twice; ellipses that are turned.
  const Sketched twice = with("0 CIRCLE 10 5 20 3 40 1 0 ARC 10 5 20 3 40 1 50 30 51 210 0 ARC 10 5 20 3 40 1 50 210 51 30");
  REQUIRE(twice.areas.size() == 1);
  CHECK(twice.areas[0] == doctest::Approx(60 - kPi));
  check_note(twice, "left out: an outline around (5, 3)");
  CHECK_FALSE(test::contains(twice.text, "press fit"));
  const std::string ellipse = "0 ELLIPSE 10 5 20 3 11 2 21 0 40 0.5";
  CHECK(with(ellipse + " " + ellipse).areas[0] == doctest::Approx(60 - 2 * kPi));
  std::vector<std::string> notes;
  drawing::read_drawing(file_of(std::string(kPlate) + " " + ellipse + " 0 ELLIPSE 10 5 20 3 11 0 21 2 40 0.5"), 0, notes);
  CHECK(std::none_of(notes.begin(), notes.end(), [](const std::string& n) { return test::contains(n, "coincides with"); }));
  // A pin that is smaller by little, drawn by other curves than its hole: nested as it is, whichever polygon is larger.
  for (const char* pin :
       {"0 CIRCLE 10 5 20 3 40 1.999", "0 ARC 10 5 20 3 40 1.999 50 10 51 190 0 ARC 10 5 20 3 40 1.999 50 190 51 10"})
    for (const char* hole : {"0 CIRCLE 10 5 20 3 40 2", "0 ARC 10 5 20 3 40 2 50 0 51 90 0 ARC 10 5 20 3 40 2 50 90 51 360"}) {
      CAPTURE(pin);
      CAPTURE(hole);
      const Sketched d = with(std::string(pin) + " " + hole);
      REQUIRE(d.areas.size() == 2);
      CHECK(d.areas[0] == doctest::Approx(60 - 4 * kPi));
      CHECK(d.areas[1] == doctest::Approx(kPi * 1.999 * 1.999));
      check_note(d, "at most 0.001 apart: this is read as a clearance; for a press fit use the outlines in comments");
    }
  CHECK_FALSE(test::contains(with("0 CIRCLE 10 5 20 3 40 2 0 CIRCLE 10 5 20 3 40 1.8").text, "press fit")); // far smaller
}

TEST_CASE("drawing: a press fit stands in the started sketch beside the clearance, and is one when it is taken") {
  const Sketched d = sketched_file("press-fit.dxf");
  REQUIRE(d.areas.size() == 2);
  CHECK(d.areas[0] == doctest::Approx(kPi * (400 - 10.01 * 10.01)).epsilon(1e-10));
  CHECK(d.areas[1] == doctest::Approx(kPi * (100 - 25)).epsilon(1e-10));
  CHECK(test::contains(d.text, "  circle pin centre 0 0  radius 10.01\n! In a press fit, instead of the outline above:\n"
                               "!   circle hole centre 0 0  radius 10\n"));
  CHECK(test::contains(d.text, "! In a press fit also:\n! interference\n! contact body1.hole body2.pin  mu 0.3\n"));
  const std::string text = as_press_fit(d.text);
  INFO(text);
  const sketch::Reading fit = reading_of(text + "fix body1.rim\nmove body2.bore x 0 y 0\n");
  for (const sketch::Fault& fault : fit.faults) MESSAGE(fault.text);
  REQUIRE(fit.faults.empty());
  CHECK(area_within(fit.sketch.bodies[0]) == doctest::Approx(kPi * (400 - 100)).epsilon(1e-10));
  CHECK(area_within(fit.sketch.bodies[1]) == doctest::Approx(kPi * (10.01 * 10.01 - 25)).epsilon(1e-10));
  CHECK(fit.sketch.interference);
  // The pressure by Lame, the rim held: displacements of both at radius 10 for a pressure of 1.
  const double nu = 0.3, by = (1 + nu) / 210e3, a = 5, b = 10, c = 20;
  const double hub = by * (1 - 2 * nu) / (1 + (1 - 2 * nu) * c * c / b / b) * (c * c / b - b);
  const double pin = by * b * ((1 - 2 * nu) * b * b + a * a) / (b * b - a * a);
  const test::Folder folder;
  test::write_file(folder / "fit.c2s", text + "fix body1.rim\nwant pressure 1 %\n");
  const test::Result run =
      test::run_shell("cd '" + folder.path() + "' && '" + paths::program() +
                      "' run fit.c2s --listing fit.lst 2> /dev/null && grep 'peak pressure' fit.lst | head -1");
  REQUIRE(run.status == 0);
  const size_t number = run.out.find_first_of("0123456789.", run.out.find("pressure"));
  CHECK(std::strtod(run.out.c_str() + number, nullptr) == doctest::Approx(0.01 / (hub + pin)).epsilon(0.01));
}

TEST_CASE("drawing: files of OpenSCAD and of Inkscape") {
  const Sketched washer = sketched_file("washer.dxf"); // of 64 sides, six digits
  REQUIRE(washer.areas.size() == 1);
  const auto edge = [](double y) { // its right side, up to the second corner
    return y < 0.980171 ? 10 - 0.0481527 * y / 0.980171 : 9.951847 - 0.1439943 * (y - 0.980171) / 0.970732;
  };
  const double slot = 0.980171 * (1 + edge(0.980171) - 9) + 0.019829 * (edge(0.980171) + edge(1) - 18);
  CHECK(washer.areas[0] == doctest::Approx(3200 * std::sin(kPi / 32) - 36 - slot).epsilon(1e-5));
  const Sketched link = sketched_file("link.dxf"); // Bezier curves for circles: 2.7e-4 of the radius off
  REQUIRE(link.areas.size() == 1);
  CHECK(link.areas[0] == doctest::Approx(800 + 100 * kPi - 16 * kPi).epsilon(1e-3));
  CHECK(test::contains(link.text, "bores"));
}

TEST_CASE("drawing: the examples of files of tools make a problem when they are taken as they stand") {
  for (const char* name :
       {"joined.msh", "press-fit.dxf", "layers.dxf", "shapes.dxf", "blocks.dxf", "rounded.dxf", "link.dxf", "washer.dxf"}) {
    CAPTURE(name);
    const std::string text = with_examples(sketched_file(name).text);
    const sketch::Reading reading = reading_of(text);
    INFO(text);
    for (const sketch::Fault& fault : reading.faults) MESSAGE(fault.text);
    REQUIRE(reading.faults.empty());
    std::string deck;
    try {
      deck = sketch::deck_of(reading.sketch, sketch::first_mesh(reading.sketch, 1));
    } catch (const sketch::Fault& fault) {
      FAIL_CHECK(fault.text);
    }
    CHECK_FALSE(deck.empty());
  }
}
