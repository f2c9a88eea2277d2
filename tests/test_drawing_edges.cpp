// Entities of drawings as files of others may have them: seen from behind, slanting, of no length, cut off, not flat; and
// meshes.
#include "program/drawing/dxf.hpp"
#include "program/drawing/loops.hpp"
#include "program/drawing/msh.hpp"
#include "program/drawing/text.hpp"

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
      CHECK(has_note(d, "1 '" + std::string(type) + "' was passed over"));
    }
  const std::string corners = " 0 VERTEX 10 0 20 0 0 VERTEX 10 1 20 0 70 16 0 VERTEX 10 2 20 0 0 SEQEND";
  CHECK(has_note(drawn("0 POLYLINE 70 64" + corners), "1 'POLYLINE that is not flat' was passed over"));
  CHECK(has_note(drawn("0 POLYLINE 220 1" + corners), "1 'POLYLINE that is not flat' was passed over"));
  const Drawing flat = drawn("0 POLYLINE 70 0" + corners); // without what only frames a spline
  REQUIRE(flat.curves.size() == 1);
  CHECK(flat.curves[0].end.x == 2);
  CHECK(has_note(drawn("0 LINE 67 1 10 0 20 0 11 1 21 1"), "1 'LINE on paper' was passed over"));
  CHECK(drawn("0 VERTEX 10 0 0 SEQEND 0 ATTRIB 1 x").notes.empty());
  CHECK(has_note(drawn("0 LINE 10 0 20 0 30 0 11 1 21 1 31 5"), "1 line has ends of different z: seen along z"));
  CHECK(has_note(drawn("0 LINE 10 0 20 0 30 0 11 1 21 1 31 5 0 LINE 10 0 20 0 30 0 11 1 21 1 31 5"),
                 "2 lines have ends of different z: seen along z"));
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
  // All control points in one place.
  const Curve none = drawn("0 SPLINE 71 1 40 0 40 0 40 1 40 1 10 3 20 4 10 3 20 4").curves.at(0);
  CHECK(none.kind == Curve::kLine);
  CHECK(none.begin.x == 3);
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
  for (const char* words : {" 41 0", " 41 2 42 1", " 210 1 230 0"})
    CHECK(has_note(copies(words), "1 'INSERT' was passed over"));
  for (const char* words : {" 70 -1", " 71 -1", " 70 10001", " 71 10001", " 70 101 71 101"})
    CHECK(fault_of(block + section("ENTITIES", "0 INSERT 2 part 10 0 20 0" + std::string(words))) ==
          "INSERT: more than 10000 copies of a block");
  // 101 copies of 100 of 100.
  const std::string deep = section("BLOCKS", "0 BLOCK 2 a 0 ENDBLK 0 BLOCK 2 b 0 INSERT 2 a 10 0 20 0 70 10000 0 ENDBLK");
  CHECK(fault_of(deep + section("ENTITIES", "0 INSERT 2 b 10 0 20 0 70 101")) ==
        "INSERT: more than 1000000 copies of blocks in all");
}

TEST_CASE("drawing: units, and files that are cut off") {
  const std::string line = section("ENTITIES", "0 LINE 10 0 20 0 11 1 21 1") + groups("0 EOF");
  CHECK(read_dxf(section("HEADER", "9 $INSUNITS 70 4") + line).unit == "mm");
  CHECK(read_dxf(section("HEADER", "9 $INSUNITS 70 99") + line).unit == "");
  CHECK(read_dxf(section("HEADER", "9 $INSUNITS 40 4") + line).unit == "");
  CHECK(read_dxf(groups("0 COMMENT") + line).curves.size() == 1);
  CHECK(fault_of(groups("0 SECTION 3 HEADER 0 ENDSEC")) == "expected the name of a section, group 2");
  CHECK(fault_of(groups("0 SECTION 2 HEADER")) == "section 'HEADER' without ENDSEC: the file is cut off");
  CHECK(fault_of(section("HEADER", "")) == "no section ENTITIES");
  for (const char* end : {"", " 0 LINE 10 0 20 0 11 1 21 1"})
    CHECK(fault_of(section("ENTITIES", "0 POLYLINE 0 VERTEX 10 0 20 0" + std::string(end))) ==
          "POLYLINE without SEQEND behind its corners");
  CHECK(fault_of(section("ENTITIES", "0 LWPOLYLINE 90 3 10 0 20 0 10 1 20 0")) == "LWPOLYLINE: 2 corners, expected 3");
  CHECK(fault_of(section("ENTITIES", "0 SPLINE 11 0 21 0")) == "SPLINE with neither control points nor two fit points");
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
  CHECK(solid.notes == std::vector<std::string>{"1 elements of type 4 were passed over"});
  CHECK(read_mesh(format + "$Nodes\n0\n$EndNodes\n$Elements\n0\n$EndElements\n").nodes.empty());
  CHECK(order_of(99) == 0);
  CHECK(corners_of(99) == 0);
  const struct {
    std::string text, told;
  } wrong[] = {{"$MeshFormat\n3 0 8\n$EndMeshFormat\n", "MSH format '3', expected 2.2 or 4.1"},
               {format + "$Nodes\n0\n\nx\n", "'x', expected $EndNodes"},
               {format + "$Nodes\n0\n", "the file ends without $EndNodes: it is cut off"},
               {format + "$Other\nx\n", "the file ends without $EndOther: it is cut off"},
               {format + "nodes\n", "'nodes', expected the begin of a section, such as $Nodes"},
               {format + triangle, "no section $Nodes"},
               {format + nodes, "no section $Elements"},
               {format + "$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n$Elements\n0\n$EndElements\n", "node 1 stands there twice"},
               {format + "$Nodes\n2\n1 0 0 0\n2 1 0 5\n$EndNodes\n$Elements\n0\n$EndElements\n",
                "the mesh is not flat: z runs from 0 to 5, expected a plane of constant z"}};
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
