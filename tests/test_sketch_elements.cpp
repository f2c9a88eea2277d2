// Given divisions of curves, and statements that count under a condition.
#include "program/sketch/mesh.hpp"
#include "sketches.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

const std::string kPlate = "body b E 1 nu 0.3\n  from 0 0\n  line foot to 3 0\n  line right to 3 1\n  line top to 0 1\n"
                           "  line left close\nfix b.foot\n";

std::vector<double> ends_of(const std::string& text, const std::string& name) {
  const Sketch s = sound(text);
  const Mesh mesh = given_mesh(s);
  for (const auto& outlines : mesh.bodies)
    for (const MeshedOutline& outline : outlines)
      for (const MeshedCurve& curve : outline.curves)
        if (curve.curve->name == name) return curve.ends;
  return {};
}

} // namespace

TEST_CASE("sketch elements: equal ones, in stretches; the last statement counts") {
  const auto are = [](const std::vector<double>& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (size_t i = 0; i < found.size(); ++i) CHECK(std::fabs(found[i] - expected[i]) < 1e-14);
  };
  are(ends_of(kPlate + "elements b.foot+top 3\n", "top"), {0, 1, 2, 3});
  are(ends_of(kPlate + "elements b.foot 9\nelements b.foot 2 until 1  4\n", "foot"), {0, 0.5, 1, 1.5, 2, 2.5, 3});
  CHECK(ends_of(kPlate, "foot") != ends_of(kPlate + "elements b.foot 3\n", "foot"));
  const Sketch s = sound(kPlate + "elements b.foot 3\n");
  CHECK(first_mesh(s, 1).bodies[0][0].curves[0].ends.size() != 4); // a search begins with a mesh of its own
}

TEST_CASE("sketch elements: sizes that grow are those asked for, scaled a little, none by more than the factor") {
  const struct {
    double first, last, growth, most;
  } rows[] = {{0.01, 0, 1.3, 0.4}, {0.01, 0.02, 1.5, 1}, {0, 1e-4, 1.2, 0.25}, {0, 0, 2, 0.5}, {5, 5, 1.1, 9}};
  for (const auto& row : rows) {
    const std::string statement = "elements b.foot from " + show(row.first) + " to " + show(row.last) + " growth " +
                                  show(row.growth) + " most " + show(row.most) + "\n";
    CAPTURE(statement);
    const std::vector<double> ends = ends_of(kPlate + statement, "foot");
    CHECK(ends.front() == 0);
    CHECK(std::fabs(ends.back() - 3) < 1e-14);
    std::vector<double> sizes;
    for (size_t i = 1; i < ends.size(); ++i) sizes.push_back(ends[i] - ends[i - 1]);
    const double most = std::min(row.most, 3.0);
    CHECK(*std::max_element(sizes.begin(), sizes.end()) < most * (1 + 1e-9));
    for (size_t i = 1; i < sizes.size(); ++i)
      CHECK(std::max(sizes[i] / sizes[i - 1], sizes[i - 1] / sizes[i]) < row.growth * (1 + 1e-9));
    // An element as long as the integral of ds / h counts one is between h at its ends; scaling divides by at most (n + 1) / n.
    const double scale = 1 + 1.0 / static_cast<double>(sizes.size());
    if (row.first > 0 && row.first < most) CHECK(sizes.front() > row.first / scale);
    if (row.first > 0) CHECK(sizes.front() < std::min(row.first * row.growth, most) * (1 + 1e-9));
    if (row.last > 0 && row.last < most) CHECK(sizes.back() > row.last / scale);
    if (row.last > 0) CHECK(sizes.back() < std::min(row.last * row.growth, most) * (1 + 1e-9));
  }
}

TEST_CASE("sketch elements: what faces given elements has its nodes opposite, and both match") {
  const std::string two = kPlate + "body c E 1 nu 0.3\n  from 0 1\n  line face to 3 1\n  line side to 3 2\n  line back to 0 2\n"
                                   "  line other close\ncontact b.top c.face mu 0.2\ntraction c.back fy -1\n";
  const std::vector<double> top = ends_of(two + "elements c.face from 0.01 to 0\n", "top"),
                            face = ends_of(two + "elements c.face from 0.01 to 0\n", "face");
  REQUIRE(top.size() == face.size());
  for (size_t i = 0; i < top.size(); ++i) CHECK(std::fabs(top[top.size() - 1 - i] - (3 - face[i])) < 1e-9);
  const auto zones = [&](const std::string& statement) {
    const Sketch s = sound(two + statement);
    const std::string text = deck_of(s, given_mesh(s));
    const size_t at = text.find("! bodies, matching zones");
    return text.substr(text.find('\n', at) + 1, 3) + (text.find("*ZONE BODIES") != std::string::npos ? " and free" : "");
  };
  CHECK(zones("elements c.face 5\n") == "2 1");
  CHECK(zones("elements c.face 5\nelements b.top 5\n") == "2 1");
  CHECK(zones("elements c.face 5\nelements b.top 6\n") == "2 0 and free");
  CHECK(zones("") == "2 0 and free");
}

TEST_CASE("sketch elements: a curve that a contact cuts has them whole") {
  const std::string cut = kPlate + "body c E 1 nu 0.3\n  from 1 1\n  line face to 2 1\n  line side to 2 2\n  line back to 1 2\n"
                                   "  line other close\ncontact b.top c.face\ntraction c.back fy -1\nelements b.top 6\n";
  const Sketch s = sound(cut);
  std::vector<double> ends(1, 0.0);
  const Mesh mesh = given_mesh(s);
  for (const MeshedCurve& curve : mesh.bodies[0][0].curves)
    if (curve.curve->name == "top")
      for (size_t i = 1; i < curve.ends.size(); ++i) ends.push_back(curve.curve->begin - 4 + curve.ends[i]);
  for (int k = 0; k <= 6; ++k) // and where the contact ends
    CHECK(std::any_of(ends.begin(), ends.end(), [k](double end) { return std::fabs(end - 0.5 * k) < 1e-9; }));
}

TEST_CASE("sketch elements: faults") {
  tells(kPlate + "elements b.foot 2.5\n", "2.5: expected the number of elements, a whole number from 1 to 20000");
  tells(kPlate + "elements b.foot\n", "the number of elements");
  tells(kPlate + "elements b.foot from 1 to 0 growth 1\n", "1: expected a growth above 1");
  tells(kPlate + "elements b.foot from 1\n", "to and the size of the last element");
  tells(kPlate + "elements b.foot 2 until 0 3\n", "above 0");
  tells(kPlate + "elements b.nose 2\n", "has no curve 'nose'");
  for (const char* statement : {"elements b.foot 2 until 4  3\n", "elements b.foot 2 until 1  2 until 0.5  3\n"}) {
    const Sketch s = sound(kPlate + statement);
    CHECK_THROWS_AS(given_mesh(s), Fault);
  }
  const Sketch s = sound(kPlate + "elements b.foot from 1e-9 to 1e-9 growth 1.0001 most 1e-9\n");
  CHECK_THROWS_AS(given_mesh(s), Fault);
}

TEST_CASE("sketch: statements that count under a condition, and values that are required") {
  const std::string choice = "parameter p 1\nwhen p title First\nwhen {1 - p} title Second\nwhen {1 - p} nonsense 1 2\n";
  CHECK(sound(choice + kPlate).title == "First");
  CHECK(sound("parameter p 1\nwhen p when 0 title None\nwhen p when p title Both\n" + kPlate).title == "Both");
  tells("when\n" + kPlate, "a value: 0 to ignore the statement after it");
  tells("when 1\n" + kPlate, "a statement");
  tells("parameter p 1\nrequire {p - 2} \"p, or q, is below 2\"\n" + kPlate, "p, or q, is below 2");
  sound("parameter p 1\nrequire {p - 1} \"p is below 1\"\n" + kPlate);
  tells("require 1\n" + kPlate, "the error message");
  CHECK(sound("plane 1\n" + kPlate).plane_stress);
  CHECK_FALSE(sound("plane 0\n" + kPlate).plane_stress);
  tells("plane 2\n" + kPlate, "0 for plane strain, 1 for plane stress");
  CHECK(sound("functions 3\n" + kPlate).order == 3);
  CHECK(sound("functions 0\n" + kPlate).chooses_order);
  CHECK(sound("parameter x {floor(-1.5)}\n" + kPlate).parameters.at("x") == -2);
}

TEST_CASE("sketch: displacements by a formula, and steps of each piece") {
  const std::string moved = "body b E 1 nu 0\n  from 0 0\n  line foot to 2 0\n  line right to 2 1\n  line top to 0 1\n"
                            "  line left close\n";
  const std::string text = moved + "case one\nfix b.foot\nmove b.top x {0.1*x} y {0.2*y + 0.1}\ncase two\nmove b.top x 0.5\n"
                                   "history one 1; two 1; one 2; two 2\nsteps 1 4 8\nelements b.top 2\n";
  const Sketch s = sound(text);
  const std::string deck = deck_of(s, given_mesh(s));
  CHECK(deck.find(" 1100 0 0 0.2 0.3") != std::string::npos); // at (2, 1)
  CHECK(deck.find(" 1100 0 0 0.1 0.3") != std::string::npos); // at (1, 1)
  const size_t path = deck.find("*PATH\n");
  REQUIRE(path != std::string::npos);
  CHECK(deck.substr(path, 30) == "*PATH\n1 1 0\n4 1 1\n8 2 1\n8 2 2\n");
}
