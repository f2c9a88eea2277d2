// Entities of drawings as files of others may have them: seen from behind, slanting, of no length, cut off, not flat; and
// meshes.
#include "program/drawing/chain.hpp"
#include "program/drawing/conditions.hpp"
#include "program/drawing/formats/dxf.hpp"
#include "program/drawing/formats/msh.hpp"
#include "program/drawing/formats/names.hpp"
#include "program/drawing/formats/nurbs.hpp"
#include "program/drawing/loops.hpp"
#include "program/drawing/placing.hpp"
#include "program/drawing/text.hpp"
#include "program/drawing/write.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace drawing;

namespace {

// Codes and values, one behind the other with blanks between, as lines.
std::string groups(const std::string& words) {
  std::string out = words + "\n";
  std::replace(out.begin(), out.end(), ' ', '\n');
  return out;
}
std::string section(const std::string& name, const std::string& words) {
  return groups("0 SECTION 2 " + name) + (words.empty() ? "" : groups(words)) + groups("0 ENDSEC");
}
Drawing drawn(const std::string& entities, const std::string& before = "") {
  return read_dxf(before + section("ENTITIES", entities) + groups("0 EOF"));
}
std::string fault_of(const std::string& text) {
  try {
    is_msh(text) ? static_cast<void>(read_mesh(text)) : static_cast<void>(read_dxf(text + groups("0 EOF")));
  } catch (const Fault& fault) {
    return fault.text;
  }
  return "";
}
bool tells(const Drawing& d, const std::string& part) {
  return std::any_of(d.notes.begin(), d.notes.end(), [&](const std::string& n) { return n.find(part) != std::string::npos; });
}
bool has_note(const Drawing& d, const std::string& note) {
  return std::find(d.notes.begin(), d.notes.end(), note) != d.notes.end();
}

} // namespace

TEST_CASE("drawing: whether a file is a drawing, by its beginning") {
  CHECK(is_dxf("  0\nSECTION\n"));
  CHECK(is_dxf("999\nmade by hand\n 0\r\nSECTION\r\n"));
  CHECK_FALSE(is_dxf("999\nmade by hand\n"));
  CHECK_FALSE(is_dxf("999\n"));
  CHECK_FALSE(is_dxf("0\nEOF\n"));
  CHECK_FALSE(is_dxf("1\nSECTION\n"));
  CHECK(is_msh("\n\t\n$MeshFormat\n"));
  CHECK(is_msh("$NOD\n"));
  CHECK_FALSE(is_msh("body\n"));
  CHECK_FALSE(is_msh("\n \n"));
  CHECK_FALSE(is_msh(""));
}

TEST_CASE("drawing: entities that do not lie in the plane that is looked at are passed over") {
  for (const char* type : {"ARC", "CIRCLE", "LWPOLYLINE", "ELLIPSE"})
    for (const char* normal : {"210 1 230 0", "220 1 230 0", "230 0"}) {
      const Drawing d = drawn("0 " + std::string(type) + " 10 0 20 0 40 1 " + normal);
      CHECK(d.curves.empty());
      CHECK(has_note(d, "left out: 1 " + std::string(type) + " (line 6): its plane is inclined to the plane of the drawing"));
    }
  const std::string corners = " 0 VERTEX 10 0 20 0 0 VERTEX 10 1 20 0 70 16 0 VERTEX 10 2 20 0 0 SEQEND";
  CHECK(has_note(drawn("0 POLYLINE 70 64" + corners), "left out: 1 POLYLINE (line 6): a three-dimensional mesh"));
  CHECK(has_note(drawn("0 POLYLINE 220 1" + corners),
                 "left out: 1 POLYLINE (line 6): its plane is inclined to the plane of the drawing"));
  const Drawing flat = drawn("0 POLYLINE 70 0" + corners); // without what only frames a spline
  REQUIRE(flat.curves.size() == 1);
  CHECK(flat.curves[0].end.x == 2);
  CHECK(has_note(drawn("0 LINE 67 1 10 0 20 0 11 1 21 1"), "left out: 1 LINE (line 6): in paper space"));
  CHECK(drawn("0 VERTEX 10 0 0 SEQEND 0 ATTRIB 1 x").notes.empty());
  CHECK(has_note(drawn("0 LINE 10 0 20 0 30 0 11 1 21 1 31 5"),
                 "repaired: 1 LINE (line 6): projected along z, because its points differ in z"));
  CHECK(has_note(drawn("0 LINE 10 0 20 0 30 0 11 1 21 1 31 5 0 LINE 10 0 20 0 30 0 11 1 21 1 31 5"),
                 "repaired: 2 LINE (from line 6): projected along z, because its points differ in z"));
}

TEST_CASE("drawing: what is seen from behind, and ellipses that are circles") {
  const Drawing behind = drawn("0 ELLIPSE 10 0 20 0 11 2 21 0 40 0.5 41 0 42 1.5707963267948966 230 -1");
  REQUIRE(behind.curves.size() == 1);
  CHECK(behind.curves[0].end.y == doctest::Approx(-1));
  const Drawing round = drawn("0 ELLIPSE 10 1 20 0 11 0 21 2 40 1 41 0 42 1.5707963267948966");
  REQUIRE(round.curves.size() == 1);
  CHECK(round.curves[0].kind == Curve::kArc);
  CHECK(round.curves[0].begin.y == doctest::Approx(2));
  CHECK(round.curves[0].end.x == doctest::Approx(-1));
  // Of a closed polyline that repeats its first corner one side less.
  CHECK(drawn("0 LWPOLYLINE 90 4 70 1 10 0 20 0 10 1 20 0 10 1 20 1 10 0 20 0").curves.size() == 3);
  CHECK(drawn("0 LWPOLYLINE 70 0 10 0 20 0 10 1 20 0").curves.size() == 1); // does not tell how many corners
}

TEST_CASE("drawing: splines that are known by the points they go through") {
  const std::string three = " 11 0 21 0 11 1 21 1 11 2 21 0";
  CHECK(drawn("0 SPLINE 11 0 21 0 11 2 21 0").curves.at(0).kind == Curve::kLine);
  CHECK(drawn("0 SPLINE 11 0 21 0 11 0 21 0 11 2 21 0").curves.at(0).kind == Curve::kLine); // a point stands there twice
  CHECK_FALSE(drawn("0 SPLINE" + three).curves.at(0).whole);
  CHECK(drawn("0 SPLINE 70 1" + three).curves.at(0).whole);
  const Curve again = drawn("0 SPLINE 70 1" + three + " 11 0 21 0").curves.at(0);
  CHECK(again.whole);
  CHECK(again.points.size() == 3);
  CHECK(drawn("0 SPLINE" + three + " 11 0 21 0").curves.at(0).points.size() == 4);
  CHECK(drawn("0 SPLINE" + three + " 11 3 21 0").curves.at(0).points.size() == 4);
  CHECK_FALSE(drawn("0 SPLINE 70 1 11 0 21 0 11 2 21 0").curves.at(0).whole);
  // All control points in one place, and all fit points.
  CHECK(has_note(drawn("0 SPLINE 71 1 40 0 40 0 40 1 40 1 10 3 20 4 10 3 20 4"),
                 "left out: 1 SPLINE (line 6): all of its control points coincide"));
  CHECK(has_note(drawn("0 SPLINE 11 3 21 4 11 3 21 4"), "left out: 1 SPLINE (line 6): all of its fit points coincide"));
}

TEST_CASE("drawing: blocks, their copies, and which of them are passed over") {
  const std::string block =
      section("BLOCKS", "0 LINE 10 9 20 9 11 8 21 8 0 BLOCK 2 part 10 0 20 0 0 LINE 8 0 10 1 20 0 11 2 21 0 0 ENDBLK");
  const auto copies = [&](const std::string& words) { return drawn("0 INSERT 2 part 10 0 20 0" + words, block); };
  CHECK(copies("").curves.size() == 1);
  CHECK(copies(" 70 0 71 0").curves.size() == 1);
  CHECK(copies(" 70 2 71 3 44 5 45 6").curves.size() == 6);
  CHECK(copies(" 230 -1").curves.at(0).end.x == doctest::Approx(-2));
  CHECK(copies(" 41 -1 42 1").curves.at(0).end.x == doctest::Approx(-2));
  CHECK(copies(" 41 2 42 3").curves.at(0).end.x == doctest::Approx(4));
  CHECK(tells(copies(" 41 0"), ": its scale is 0"));
  CHECK(tells(copies(" 210 1 230 0"), ": its plane is inclined to the plane of the drawing"));
  for (const char* words : {" 70 -1", " 71 -1", " 70 10001", " 71 10001", " 70 101 71 101"})
    CHECK(tells(copies(words), ": more than 10000 copies of a block"));
  // 101 copies of 100 of 100.
  const std::string deep = section("BLOCKS", "0 BLOCK 2 a 0 ENDBLK 0 BLOCK 2 b 0 INSERT 2 a 10 0 20 0 70 10000 0 ENDBLK");
  CHECK(fault_of(deep + section("ENTITIES", "0 INSERT 2 b 10 0 20 0 70 101")) ==
        "INSERT: more than 1000000 copies of blocks in total");
}

TEST_CASE("drawing: units, and files that are cut off") {
  const std::string line = section("ENTITIES", "0 LINE 10 0 20 0 11 1 21 1") + groups("0 EOF");
  CHECK(read_dxf(section("HEADER", "9 $INSUNITS 70 4") + line).unit == "mm");
  CHECK(read_dxf(section("HEADER", "9 $INSUNITS 70 99") + line).unit == "");
  CHECK(read_dxf(section("HEADER", "9 $INSUNITS 40 4") + line).unit == "");
  CHECK(read_dxf(groups("0 COMMENT") + line).curves.size() == 1);
  CHECK(fault_of(groups("0 SECTION 3 HEADER 0 ENDSEC")) == "expected the name of a section, group 2");
  CHECK(fault_of(groups("0 SECTION 2 HEADER")) == "section 'HEADER' without ENDSEC: the file is truncated");
  CHECK(fault_of(section("HEADER", "")) == "no section ENTITIES");
  for (const char* end : {"", " 0 LINE 10 0 20 0 11 1 21 1"})
    CHECK(has_note(drawn("0 POLYLINE 0 VERTEX 10 0 20 0" + std::string(end)),
                   "left out: 1 POLYLINE (line 6): no SEQEND after its vertices"));
  CHECK(has_note(drawn("0 LWPOLYLINE 90 3 10 0 20 0 10 1 20 0"), "left out: 1 LWPOLYLINE (line 6): 2 vertices, expected 3"));
  CHECK(has_note(drawn("0 SPLINE 11 0 21 0"), "left out: 1 SPLINE (line 6): it has neither control points nor two fit points"));
}

TEST_CASE("drawing: numbers and lines of files") {
  CHECK(real("+1.5", 1, "x") == 1.5);
  CHECK(whole_number("+7", 1, "n") == 7);
  CHECK(trimmed(" \t a b\t \r") == "a b");
  for (const char* text : {"+-1", "1e101", "-1e101", "inf", "nan", "1e999", "", "1x", "+"}) {
    CAPTURE(text);
    CHECK_THROWS_AS(real(text, 1, "x"), Fault);
  }
  for (const char* text : {"+-1", "1.5", "", "+"}) CHECK_THROWS_AS(whole_number(text, 1, "n"), Fault);
}

TEST_CASE("drawing: sections of meshes") {
  const std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  const std::string nodes = "$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n",
                    triangle = "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n";
  CHECK(read_mesh(format + nodes + triangle).faces.size() == 1);
  CHECK(read_mesh("$MeshFormat\n2 0 8\n$EndMeshFormat\n\n \n" + nodes + triangle).faces.size() == 1);
  // What is not known is passed over: $Entities of another release, and elements that are no lines or faces.
  const Mesh more = read_mesh(format + "$Entities\nanything\n$EndEntities\n" + nodes +
                              "$Elements\n2\n1 2 2 0 1 1 2 3\n2 15 2 0 1 1\n$EndElements\n");
  CHECK(more.faces.size() == 1);
  const Mesh solid = read_mesh(format + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n$EndNodes\n$Elements\n2\n1 2 2 0 1 1 2 "
                                        "3\n2 4 2 0 1 1 2 3 4\n$EndElements\n");
  CHECK(solid.notes ==
        std::vector<std::string>{"read: 1 face", "left out: 1 element (line 14): of type 4, neither a line nor a face"});
  CHECK(read_mesh(format + "$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements\n").nodes.empty());
  CHECK(order_of(99) == 0);
  CHECK(corners_of(99) == 0);
  const struct {
    std::string text, told;
  } wrong[] = {{"$MeshFormat\n3 0 8\n$EndMeshFormat\n", "MSH format '3', expected 2.2 or 4.1"},
               {format + "$Nodes\n0\n\nx\n", "'x', expected $EndNodes"},
               {format + "$Nodes\n0\n", "the file ends without $EndNodes: it is truncated"},
               {format + "$Other\nx\n", "the file ends without $EndOther: it is truncated"},
               {format + "nodes\n", "'nodes', expected the start of a section, such as $Nodes"},
               {format + triangle, "no section $Nodes"},
               {format + nodes, "no section $Elements"},
               {format + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n$Elements\n0\n$EndElements\n", "node 1 is defined twice"},
               {format + "$Nodes\n2\n1 0 0 0\n2 1 0 5\n$EndNodes\n$Elements\n0\n$EndElements\n",
                "the mesh is not plane: z ranges from 0 to 5, expected constant z"}};
  for (const auto& w : wrong) CHECK(fault_of(w.text) == w.told);
}

TEST_CASE("drawing: curves of one name that go on as one are one, wherever the loop begins") {
  using namespace drawing;
  const auto tidied = [](std::vector<Curve> curves) {
    for (Curve& c : curves)
      if (c.name.empty()) c.name = "n";
    Loop loop;
    loop.curves = std::move(curves);
    tidy(loop);
    return loop.curves;
  };
  const auto named = [](Curve c, const char* name) {
    c.name = name;
    return c;
  };
  const Point a{0, 0}, b{1, 0}, c{2, 0}, d{2, 2}, e{0, 2};
  // Half of the lower side at either end of the loop; the right side bears another name.
  const std::vector<Curve> box =
      tidied({straight(b, c), named(straight(c, d), "e"), straight(d, e), straight(e, a), straight(a, b)});
  REQUIRE(box.size() == 4);
  CHECK((sketch::length(box[0].begin - a) == 0 && sketch::length(box[0].end - c) == 0));
  CHECK(tidied({straight(a, b), straight(b, d), straight(d, a)}).size() == 3); // a corner
  // There and back along one line, and onwards beyond its beginning: no line from the first to the last point.
  for (const double x : {-1.0, 0.0, 0.5})
    CHECK(tidied({straight(a, b), straight(b, {x, 0}), straight({x, 0}, d), straight(d, e), straight(e, a)}).size() == 5);
  CHECK(tidied({named(straight(a, b), "p"), named(straight(b, c), "q"), straight(c, d), straight(d, a)}).size() == 4);
  // Arcs: halves of a circle are a whole one, either way, wherever they meet; those of unlike circles are none.
  for (const double way : {1.0, -1.0}) {
    CAPTURE(way);
    for (const int parts : {2, 3}) {
      std::vector<Curve> arcs;
      for (int i = 0; i < parts; ++i) arcs.push_back(circular(b, 1, way * (30 + 360.0 / parts * i), way * 360.0 / parts));
      const std::vector<Curve> circle = tidied(arcs);
      REQUIRE(circle.size() == 1);
      CHECK((circle[0].whole && circle[0].a == 1 && circle[0].name == "n"));
      CHECK(sketch::length(circle[0].begin - arcs[0].begin) < 1e-12);
    }
    CHECK(tidied({circular(b, 1, 0, way * 180), circular(b, 1, 180, -way * 90)}).size() == 2);
  }
  CHECK(tidied({circular(b, 1, 0, 90), circular({1, 0.5}, 0.5, 90, 90), straight({0.5, 0.5}, c)}).size() == 3);
  CHECK(tidied({circular(b, 1, 0, 90), circular({1, 2}, 1, -90, 90), straight(d, c)}).size() == 3);
  CHECK(tidied({circular(a, 1, 0, 360), circular(a, 1, 0, 360)}).size() == 2);
  CHECK(tidied({circular(a, 1, 0, 180), straight({-1, 0}, b)}).size() == 2);
  CHECK(tidied({smooth({a, d, b}, false), smooth({b, {1, -1}, a}, false)}).size() == 2);
}

namespace {

const double kPi = std::acos(-1.0);

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Clamped knots of a degree, whole numbers inside, up to 1.
Nurbs clamped(int degree, std::vector<Point> points) {
  Nurbs n;
  n.degree = degree, n.points = std::move(points);
  const size_t p = static_cast<size_t>(degree), spans = n.points.size() - p;
  n.knots.assign(p, 0);
  for (size_t i = 0; i <= spans; ++i) n.knots.push_back(static_cast<double>(i) / static_cast<double>(spans));
  n.knots.insert(n.knots.end(), p, 1);
  REQUIRE(n.fault() == "");
  return n;
}

// The farthest that a point of the B-spline is from the curves that stand for it.
double farthest(const Nurbs& n, const std::vector<Curve>& curves) {
  std::vector<Point> polygon;
  for (const Curve& c : curves)
    for (int i = 0; i <= 4000; ++i) polygon.push_back(shape_of(c)->at(i / 4000.0));
  double most = 0;
  for (int i = 0; i <= 60; ++i) {
    double least = HUGE_VAL;
    for (const Point& p : polygon) least = std::min(least, sketch::length(p - n.at(i / 60.0)));
    most = std::max(most, least);
  }
  return most;
}

// Elements of faces, each with its group and corners, on nodes numbered from 1; lines likewise, with an entity of their own.
struct Faces {
  std::vector<Point> points;
  std::vector<std::pair<int, std::vector<int>>> faces, lines;
  std::string names;
  Drawing drawing() const {
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + "$Nodes\n" + std::to_string(points.size()) + "\n";
    for (size_t i = 0; i < points.size(); ++i)
      text += std::to_string(i + 1) + " " + sketch::show(points[i].x) + " " + sketch::show(points[i].y) + " 0\n";
    text += "$EndNodes\n$Elements\n" + std::to_string(faces.size() + lines.size()) + "\n";
    int number = 0;
    for (const auto& list : {lines, faces})
      for (const auto& [group, nodes] : list) {
        const int type = nodes.size() == 2 ? 1 : nodes.size() == 3 ? 2 : 3;
        text += std::to_string(++number) + " " + std::to_string(type) + " 2 " + std::to_string(group) + " 7";
        for (const int node : nodes) text += " " + std::to_string(node);
        text += "\n";
      }
    return drawing_of(read_mesh(text + "$EndElements\n"));
  }
};

double area_of(const Body& body) {
  double sum = 0;
  for (const Loop& loop : body.loops) {
    std::vector<Point> polygon;
    for (const Curve& c : loop.curves)
      for (int i = 0; i < 2000; ++i) polygon.push_back(shape_of(c)->at(i / 2000.0));
    const double area = sketch::area_of(polygon); // (a whole curve turns left, in a hole too)
    sum += loop.hole ? -std::fabs(area) : std::fabs(area);
  }
  return sum;
}

Drawing joined(std::vector<Curve> curves, double join = 0) {
  Drawing d;
  d.curves = std::move(curves);
  join_curves(d, join);
  return d;
}

} // namespace

TEST_CASE("drawing: B-splines that stand still, go back, have knots twice or no corner where they might") {
  // All of it in one point: a line without length, which is left out later.
  const std::vector<Curve> none = curves_of(clamped(1, {{0, 0}, {0, 0}}), 1e-3);
  REQUIRE(none.size() == 1);
  CHECK((none[0].kind == Curve::kLine && none[0].begin.x == 0 && none[0].end.x == 0));
  // Knots that repeat the ends further than the degree asks.
  Nurbs line = clamped(1, {{7, 7}, {0, 0}, {1, 2}, {8, 8}});
  line.knots = {0, 0, 0, 1, 1, 1};
  REQUIRE(line.fault() == "");
  const std::vector<Curve> one = curves_of(line, 1e-3);
  REQUIRE(one.size() == 1);
  CHECK((one[0].kind == Curve::kLine && one[0].begin.x == 0 && one[0].end.y == 2));
  CHECK(line.at(1).y == 2);
  // A knot of a corner, handles of which lie on one line.
  Nurbs smooth = clamped(2, {{0, 0}, {0, 1}, {1, 1}, {2, 1}, {2, 0}});
  smooth.knots = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
  const std::vector<Curve> whole = curves_of(smooth, 1e-4);
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].kind == Curve::kSpline);
  CHECK(farthest(smooth, whole) < 1e-3);
  // A drop: closed, with its corner where it begins.
  const Nurbs drop = clamped(3, {{0, 0}, {3, 0}, {0, 3}, {0, 0}});
  const std::vector<Curve> closed = curves_of(drop, 1e-4);
  REQUIRE(closed.size() == 1);
  CHECK_FALSE(closed[0].whole);
  CHECK(sketch::length(closed[0].begin - closed[0].end) == 0);
  CHECK(farthest(drop, closed) < 1e-3);
  // On a line, but beyond its end and back: no line. What it begins with straight is one.
  const std::vector<Curve> back = curves_of(clamped(2, {{0, 0}, {3, 0}, {1, 0}}), 1e-3);
  REQUIRE(back.size() == 1);
  CHECK(back[0].kind == Curve::kSpline);
  CHECK(back[0].end.x == 1);
  const Nurbs hook = clamped(2, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 2}, {4, 4}});
  CHECK(farthest(hook, curves_of(hook, 1e-3)) < 2e-3);
  // Control points that lie on each other, within and at the end: the curve stands still there for a while.
  const Nurbs still = clamped(2, {{0, 0}, {1, 1}, {2, 1}, {2, 1}, {2, 1}, {3, 0}, {4, 0}, {4, 0}, {4, 0}});
  for (const double tolerance : {1e-3, 0.0}) {
    const std::vector<Curve> follows = curves_of(still, tolerance);
    REQUIRE(follows.size() == 2); // with a corner between them
    for (const Curve& c : follows) CHECK((c.points.size() < 2000 && c.doubt <= std::max(tolerance, 1e-5)));
    CHECK(farthest(still, follows) < 2e-3);
    CHECK(sketch::length(follows[1].begin - Point{2, 1}) == 0);
  }
  // More knots than points may be, and a tolerance that no number of points meets.
  std::vector<Point> many;
  for (int i = 0; i < 700; ++i) many.push_back({0.1 * i, std::sin(0.1 * i)});
  const std::vector<Curve> long_one = curves_of(clamped(2, many), 1e-3);
  REQUIRE(long_one.size() == 1);
  CHECK(long_one[0].points.size() <= 1002);
  const std::vector<Curve> fine = curves_of(clamped(2, {{0, 0}, {1, 3}, {2, 0}, {3, 1}}), 1e-18);
  REQUIRE(fine.size() == 1);
  CHECK(fine[0].points.size() >= 1000);
  CHECK(fine[0].points.size() <= 2000);
  CHECK(fine[0].doubt > 1e-18);
  Nurbs high;
  high.degree = 16;
  CHECK(high.fault() == "degree 16, expected 1 to 15");
}

TEST_CASE("drawing: points on a circle that go round more than once, and runs that end on a line") {
  const auto on_circle = [](int count, double step) {
    std::vector<Point> out;
    for (int i = 0; i < count; ++i) out.push_back({std::cos(step * i * kPi / 180), std::sin(step * i * kPi / 180)});
    return out;
  };
  // Open: one and a half turns, and just one, are no arc. Closed: two turns are none.
  for (const int count : {37, 25}) {
    const std::vector<Curve> turns = curves_of(on_circle(count, 15), false, 2);
    REQUIRE(turns.size() == 1);
    CHECK(turns[0].kind == Curve::kSpline);
  }
  CHECK(curves_of(on_circle(15, 48), true, 2).size() == 15); // a star
  CHECK(curves_of(on_circle(24, 15), true, 2).at(0).kind == Curve::kArc);
  // A quarter, and on along the tangent.
  std::vector<Point> run = on_circle(7, 15);
  for (int i = 1; i <= 5; ++i) run.push_back({-0.2 * i, 1});
  const std::vector<Curve> two = curves_of(run, false, 2);
  REQUIRE(two.size() == 2);
  CHECK((two[0].kind == Curve::kArc && two[1].kind == Curve::kLine));
  CHECK(two[0].a == doctest::Approx(1));
  CHECK(two[0].sweep == doctest::Approx(90));
  // Half a disc: an arc between corners, and a line.
  std::vector<Point> half = on_circle(13, 15);
  const std::vector<Curve> disc = curves_of(half, true, 2);
  REQUIRE(disc.size() == 2);
  CHECK(disc[0].kind != disc[1].kind);
}

TEST_CASE("drawing: curves that are moved, halved, placed and told") {
  // An ellipse through other ends is a spline that tells how far it is off; one whose ends hardly move stays.
  const Curve quarter = elliptic({0, 0}, 2, 1, 0, 0, 90);
  Curve moved = quarter, kept = quarter;
  move_ends(moved, {2, 1e-3}, quarter.end);
  CHECK((moved.kind == Curve::kSpline && moved.doubt == doctest::Approx(1e-3) && moved.points.size() == 65));
  CHECK((moved.points.front().y == 1e-3 && moved.points.back().y == 1));
  move_ends(kept, {2, 1e-9}, quarter.end);
  CHECK((kept.kind == Curve::kEllipse && kept.begin.y == 1e-9));
  const auto meet = [](const std::vector<Curve>& two, Point at) {
    REQUIRE(two.size() == 2);
    CHECK(sketch::length(two[0].end - at) < 1e-12);
    CHECK(sketch::length(two[1].begin - at) < 1e-12);
    CHECK(sketch::length(shape_of(two[0])->at(1) - shape_of(two[1])->at(0)) < 1e-12);
  };
  meet(halves(straight({0, 0}, {2, 4})), {1, 2});
  meet(halves(circular({0, 0}, 1, 0, 180)), {0, 1});
  meet(halves(smooth({{0, 0}, {1, 0}, {2, 0}}, false)), {1, 0});
  meet(halves(smooth({{0, 0}, {1, 0}, {2, 0}, {3, 1}}, false)), {2, 0});
  // Turned by 90 degrees and mirrored before: whole ones keep their sense.
  const Motion turned = placing({0, 0}, {1, 1}, 2, -2, 90);
  const Curve spline = placed(smooth({{0, 0}, {1, 0}, {2, 1}}, false), turned);
  CHECK(sketch::length(spline.points[2] - Point{3, 5}) < 1e-12);
  CHECK(sketch::length(spline.end - spline.points[2]) == 0);
  CHECK(placed(circular({0, 0}, 1, 0, 360), turned).sweep == 360);
  CHECK(placed(circular({0, 0}, 1, 0, 90), turned).sweep == -90);
  Curve whole = elliptic({0, 0}, 2, 1, 0, 0, 360);
  CHECK(text_of(whole) == "ellipse");
  whole.line = 7, whole.name = "rim";
  CHECK(text_of(whole) == "ellipse of 'rim' in line 7");
  CHECK(text_of(circular({0, 0}, 1, 0, 360)) == "circle");
  CHECK(text_of(circular({0, 0}, 1, 0, 90)) == "arc");
}

TEST_CASE("drawing: joints where curves touch, overlap or leave one way, and outlines of no area") {
  // A crescent: both arcs leave the origin along x.
  const Drawing crescent = joined({circular({0, 2}, 2, -90, 180), straight({0, 4}, {0, 2}), circular({0, 1}, 1, -90, 180)});
  REQUIRE(crescent.bodies.size() == 1);
  CHECK(area_of(crescent.bodies[0]) == doctest::Approx(1.5 * kPi).epsilon(1e-4));
  // Lines that lie on each other in part: what they go round has no area.
  const Drawing flat = joined({straight({0, 0}, {2, 0}), straight({0, 0}, {1, 0}), straight({1, 0}, {2, 0})});
  CHECK(flat.bodies.empty());
  // A line that is there twice in the same direction, and circles, ellipses and splines that are.
  const std::vector<Point> loop = {{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 1}};
  const Drawing twice =
      joined({straight({0, 0}, {1, 0}), straight({0, 0}, {1, 0}), straight({1, 0}, {0, 1}), straight({0, 1}, {0, 0})});
  REQUIRE(twice.bodies.size() == 1);
  CHECK(has_note(twice, "line from (0, 0) to (1, 0) coincides with line and was left out"));
  const Drawing same = joined({elliptic({0, 0}, 2, 1, 0, 0, 360), elliptic({0, 0}, 2, 1, 0, 0, 360)});
  CHECK(same.bodies.size() == 1);
  CHECK(has_note(same, "ellipse coincides with ellipse and was left out"));
  const Drawing within = joined({elliptic({0, 0}, 2, 1, 0, 0, 360), elliptic({0, 0}, 2, 0.5, 0, 0, 360)});
  CHECK(within.notes.empty());
  const Drawing splines = joined({smooth(loop, true), smooth({{10, 0}, {12, 0}, {13, 2}, {11, 3}, {9, 1}}, true)});
  CHECK((splines.bodies.size() == 2 && splines.notes.empty()));
  // One that is drawn to the right is run through to the left.
  const Drawing right = joined({smooth({loop.rbegin(), loop.rend()}, true)});
  REQUIRE(right.bodies.size() == 1);
  std::vector<Point> polygon;
  append_polygon(polygon, right.bodies[0].loops.at(0).curves.at(0));
  CHECK(sketch::area_of(polygon) > 0);
  // An open end on an arc that turns right.
  const Drawing open = joined({circular({0, 0}, 1, 180, -180), straight({-1, 0}, {1, 0}), straight({0, 1}, {0, 3})});
  REQUIRE(open.bodies.size() == 1);
  CHECK(std::any_of(open.notes.begin(), open.notes.end(),
                    [](const std::string& n) { return has(n, "it lies on arc; split that curve there"); }));
}

TEST_CASE("drawing: holes with curves across them, or in two bodies, and notes of which there are many") {
  const auto box = [](double x, double y, double w, double h) {
    return std::vector<Curve>{straight({x, y}, {x + w, y}), straight({x + w, y}, {x + w, y + h}),
                              straight({x + w, y + h}, {x, y + h}), straight({x, y + h}, {x, y})};
  };
  std::vector<Curve> crossed = box(0, 0, 10, 10);
  const std::vector<Curve> hole = {straight({4, 4}, {6, 4}), straight({6, 4}, {6, 6}), straight({6, 6}, {4, 6}),
                                   straight({4, 6}, {4, 4}), straight({4, 4}, {6, 6})};
  crossed.insert(crossed.end(), hole.begin(), hole.end());
  const Drawing a = joined(crossed);
  REQUIRE(a.bodies.size() == 1);
  CHECK(area_of(a.bodies[0]) == doctest::Approx(96));
  CHECK(std::any_of(a.notes.begin(), a.notes.end(),
                    [](const std::string& n) { return has(n, "a hole around ") && has(n, "is crossed by curves"); }));
  // Two bodies side by side: a circle in one of them, and one upon the line between them.
  std::vector<Curve> pair = {straight({0, 0}, {5, 0}),    straight({5, 0}, {10, 0}),  straight({10, 0}, {10, 10}),
                             straight({10, 10}, {5, 10}), straight({5, 10}, {0, 10}), straight({0, 10}, {0, 0}),
                             straight({5, 0}, {5, 10})};
  pair.push_back(circular({7.5, 5}, 1, 0, 360));
  const Drawing b = joined(pair);
  REQUIRE(b.bodies.size() == 2);
  CHECK(area_of(b.bodies[0]) + area_of(b.bodies[1]) == doctest::Approx(100 - kPi).epsilon(1e-4));
  pair.back() = circular({5, 5}, 1, 0, 360);
  const Drawing c = joined(pair);
  REQUIRE(c.bodies.size() == 2);
  CHECK((c.bodies[0].loops.size() == 1 && c.bodies[1].loops.size() == 1));
  CHECK(std::any_of(c.notes.begin(), c.notes.end(),
                    [](const std::string& n) { return has(n, "lies in several bodies and was left out"); }));
  std::vector<Curve> dots = box(0, 0, 10, 10);
  for (int i = 0; i < 25; ++i) dots.push_back(straight({20.0 + i, 0}, {20.0 + i, 0}));
  const Drawing d = joined(dots);
  CHECK(d.notes.size() == 21);
  CHECK(has_note(d, "and 5 other curves without length were left out"));
  // A depth of z that is told of what is no line is of no account; a closed spline may be drawn through end points alone.
  CHECK(drawn("0 CIRCLE 10 0 20 0 40 1 30 0 31 5").notes == std::vector<std::string>{"read: 1 CIRCLE"});
}

TEST_CASE("drawing: line elements that branch, turn, lie twice or within bodies") {
  Faces mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {2, 1}};
  mesh.faces = {{1, {1, 2, 3, 4}}, {1, {2, 5, 6, 3}}};
  mesh.lines = {{5, {1, 2}}, {6, {2, 1}}, {5, {2, 3}}};
  mesh.names = "$PhysicalNames\n2\n2 1 \"plate\"\n1 5 \"foot\"\n$EndPhysicalNames\n";
  const Drawing joined_ones = mesh.drawing();
  REQUIRE(joined_ones.bodies.size() == 1);
  CHECK(joined_ones.bodies[0].name == "plate");
  CHECK(has_note(joined_ones, "1 line elements are repeated: the name of the first one is used"));
  CHECK(has_note(joined_ones, "1 line elements inside bodies were left out"));
  mesh.faces[1].first = 2; // a line between bodies is a side of both
  mesh.lines = {{5, {2, 3}}};
  const Drawing two = mesh.drawing();
  CHECK((two.bodies.size() == 2 && two.notes == std::vector<std::string>{"read: 2 faces, 1 line element"}));
  for (const Body& body : two.bodies)
    CHECK(std::count_if(body.loops[0].curves.begin(), body.loops[0].curves.end(),
                        [](const Curve& c) { return c.name == "foot"; }) == 1);
  // Of one group, but apart: names with numbers. No name: none.
  mesh.points.insert(mesh.points.end(), {{5, 0}, {6, 0}, {5, 1}});
  mesh.faces = {{1, {1, 2, 3, 4}}, {1, {7, 8, 9}}, {2, {2, 5, 6, 3}}};
  const Drawing apart = mesh.drawing();
  REQUIRE(apart.bodies.size() == 3);
  CHECK((apart.bodies[0].name == "plate1" && apart.bodies[1].name == "plate2" && apart.bodies[2].name == ""));
  // Line elements alone: in any order and direction, one that ends openly, three that meet.
  Faces lines;
  lines.points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 3}, {3, -3}, {0, 5}, {1, 6}};
  lines.lines = {{5, {1, 2}}, {5, {4, 3}}, {5, {2, 3}}, {5, {4, 5}}, {5, {4, 6}}, {6, {7, 8}}};
  const Drawing loose = lines.drawing();
  CHECK(loose.bodies.empty());
  REQUIRE(loose.curves.size() == 4);
  CHECK(std::any_of(loose.curves.begin(), loose.curves.end(), [](const Curve& c) {
    return sketch::length(c.end - c.begin) == 3 && c.begin.y == 0 && c.end.y == 0; // three elements, one line
  }));
}

TEST_CASE("drawing: surfaces of meshes with smooth holes, holes that touch the outside, and no extent") {
  // A ring between ellipses: both sides are whole splines, the hole runs to the right in the mesh.
  Faces ring;
  const int n = 24;
  for (const double size : {1.0, 2.0})
    for (int i = 0; i < n; ++i) {
      const double t = 2 * kPi * i / n;
      ring.points.push_back({2 * size * std::cos(t), size * std::sin(t)});
    }
  for (int i = 0; i < n; ++i) ring.faces.push_back({1, {i + 1, n + i + 1, n + (i + 1) % n + 1, (i + 1) % n + 1}});
  const Drawing elliptic_ring = ring.drawing();
  REQUIRE(elliptic_ring.bodies.size() == 1);
  REQUIRE(elliptic_ring.bodies[0].loops.size() == 2);
  CHECK_FALSE(elliptic_ring.bodies[0].loops[0].hole);
  CHECK(elliptic_ring.bodies[0].loops[1].hole);
  for (const Loop& loop : elliptic_ring.bodies[0].loops) {
    REQUIRE(loop.curves.size() == 1);
    CHECK((loop.curves[0].whole && loop.curves[0].kind == Curve::kSpline));
    std::vector<Point> polygon;
    append_polygon(polygon, loop.curves[0]);
    CHECK(sketch::area_of(polygon) > 0); // a whole one turns left
  }
  CHECK(area_of(elliptic_ring.bodies[0]) == doctest::Approx(6 * kPi).epsilon(1e-3));
  // Three by three squares without the one in the middle and one at a corner: the hole opens in one node.
  Faces grid;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) grid.points.push_back({double(x), double(y)});
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      if (!(x == 1 && y == 1) && !(x == 0 && y == 0))
        grid.faces.push_back({1, {4 * y + x + 1, 4 * y + x + 2, 4 * y + x + 6, 4 * y + x + 5}});
  const Drawing pinched = grid.drawing();
  REQUIRE(pinched.bodies.size() == 1);
  CHECK(area_of(pinched.bodies[0]) == doctest::Approx(7));
  // Corners on one line, to round-off: no surface.
  Faces thin;
  thin.points = {{0.6, 0.3}, {1.6, 0.7}, {1.1, 0.5}};
  thin.faces = {{1, {1, 2, 3}}};
  CHECK(thin.drawing().bodies.empty());
}

TEST_CASE("drawing: what a sketch makes of names, notes, units and sizes of a drawing") {
  Names names;
  CHECK(names.name("_x") == "c_x");
  CHECK(names.name("\x80\x81") == "c_"); // the inside of a letter alone
  CHECK(names.name("[a]") == "c_a_");
  CHECK(names.name("body2") == "body2");
  CHECK(names.numbered("body") == "body1");
  CHECK(names.numbered("body") == "body3");
  const auto plate = [](double size) {
    Drawing d;
    d.kind = "DXF";
    d.bodies = {{"", {{{straight({0, 0}, {size, 0}), straight({size, 0}, {0, size}), straight({0, size}, {0, 0})}, false}}}};
    return d;
  };
  CHECK(has(sketch_of(plate(1), "a(b)\x01\xc3.dxf", {}), "title a_b___.dxf\n"));
  const struct {
    const char *unit, *units, *modulus;
  } units[] = {{"in", "units in lbf\n", "E 30e6 "},
               {"m", "units m N\n", "E 210e9 "},
               {"um", "units um N\n", "E 0.21 "},
               {"mm", "units mm N\n", "E 210e3 "}};
  for (const auto& u : units) {
    Drawing d = plate(1);
    d.unit = u.unit;
    const std::string text = sketch_of(d, "d", {});
    CHECK(has(text, u.units));
    CHECK(has(text, u.modulus));
  }
  CHECK(has(sketch_of(plate(1e13), "d", {}), " to 1e+13 0\n"));
  CHECK(has(sketch_of(plate(1e-7), "d", {}), " to 1e-07 0\n"));
  // Notes are broken at blanks, long words are not.
  Drawing noted = plate(1);
  const std::string word(150, 'x');
  noted.notes = {"aa " + word + " b", word, std::string(60, 'y') + " " + std::string(60, 'z') + " end"};
  const std::string text = sketch_of(noted, "d", {});
  CHECK(has(text, "! aa\n!   " + word + " b\n"));
  CHECK(has(text, "\n! " + word + "\n"));
  CHECK(has(text, "! " + std::string(60, 'y') + "\n!   " + std::string(60, 'z') + " end\n"));
  // An arc whose ends lie beside its circle is told by its middle; a drop is a loop of one curve that is not whole.
  Curve arc = circular({0, 0}, 1, 0, 180);
  move_ends(arc, {1.001, 0}, arc.end);
  Drawing lens = plate(1);
  lens.bodies[0].loops[0].curves = {arc, straight(arc.end, arc.begin)};
  CHECK(has(sketch_of(lens, "d", {}), "arc c1 to -1 0  through 0 1\n"));
  Drawing drop = plate(1);
  drop.bodies[0].loops[0].curves = {smooth({{0, 0}, {2, 1}, {0, 2}, {0, 0}}, false)};
  CHECK(has(sketch_of(drop, "d", {}), "from 0 0\n  spline c1 through  2 1  0 2  0 0\n"));
  // Of many bodies those that are near each other touch, the others have a support each.
  for (const double apart : {1.01, 2.0}) {
    Drawing many = plate(1);
    for (int i = 1; i < 12; ++i) { // triangles on each other's corners, no side of which faces another; squares would
      many.bodies.push_back(many.bodies[0]);
      for (Curve& c : many.bodies.back().loops[0].curves) c = placed(c, placing({0, 0}, {apart * i, 0}, 1, 1, 0));
    }
    const std::string apart_ones = sketch_of(many, "d", {});
    CHECK((has(apart_ones, "! fix body12.") && !has(apart_ones, "! contact")));
    for (Body& body : many.bodies) {
      const Point p = body.loops[0].curves[0].begin, x{1, 0}, y{0, 1};
      body.loops[0].curves = {straight(p, p + x), straight(p + x, p + x + y), straight(p + x + y, p + y), straight(p + y, p)};
    }
    const std::string row = sketch_of(many, "d", {});
    CHECK(has(row, "! contact body11.c2 body12.c4") == (apart == 1.01));
    CHECK(has(row, "! platen body12.c2  about " + sketch::show(11 * apart + 1).substr(0, 5) + " 0.5  y 0 fx -1  turn 0") ==
          (apart == 1.01));
    CHECK(has(row, "! fix body12.c1") == (apart == 2.0));
  }
}

TEST_CASE("drawing: statements beside a drawing, with a byte order mark, blank lines and bodies of their own") {
  const Conditions c =
      read_conditions("\xef\xbb\xbftitle one\nbody\nbody plate E 1 nu 0 ! steel\n\n\nbody own E 2 nu 0\n\n\n  from 0 "
                      "0\n  line to 1 0\nfix plate.c1\n");
  CHECK((c.given && c.has_title && !c.has_units));
  CHECK(c.head == "title one\n");
  REQUIRE(c.materials.size() == 1);
  CHECK((c.materials[0].body == "plate" && c.materials[0].text == "E 1 nu 0 ! steel" && c.materials[0].line == 3));
  CHECK(c.tail == "body\n\n\nbody own E 2 nu 0\n\n\n  from 0 0\n  line to 1 0\nfix plate.c1\n");
}

TEST_CASE("drawing: types of entities and layers in rare notations, blocks of no height, elements that repeat a node") {
  CHECK(tells(drawn("0 FOO~ 10 0 0 FOO~ 10 0"), "left out: 2 FOO~ (from line 6)"));
  const std::string block = section("BLOCKS", "0 BLOCK 2 part 0 LINE 10 0 20 0 11 1 21 0 0 ENDBLK");
  for (const char* scale : {" 41 0", " 42 0", " 41 2 42 0"}) {
    CAPTURE(scale);
    const Drawing d = drawn("0 INSERT 2 part 10 0 20 0" + std::string(scale), block);
    CHECK(tells(d, "its scale is 0"));
    CHECK(d.curves.empty());
  }
  // A flag of another program behind LibreCAD's name is not LibreCAD's.
  const std::string layers = section("TABLES", "0 TABLE 2 LAYER 0 LAYER 2 a 70 0 62 7 1001 LibreCad 1001 OTHER 1070 1 "
                                               "0 LAYER 2 b 70 0 62 7 1001 LibreCad 1070 1 0 ENDTAB");
  const Drawing two = drawn("0 LINE 8 a 10 0 20 0 11 1 21 0 0 LINE 8 b 10 0 20 1 11 1 21 1", layers);
  REQUIRE(two.curves.size() == 1);
  CHECK(two.curves[0].begin.y == 0);
  CHECK(fault_of("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 1 1 0\n$EndNodes\n"
                 "$Elements\n1\n1 3 2 0 1 1 2 1 4\n$EndElements\n") == "");
}
