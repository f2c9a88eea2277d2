// Warnings about meshes that are too coarse for the contact that came out (tests/data/coarse).
#include "many_bodies.hpp"
#include "paths.hpp"
#include "problem.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using problem::Problem;
using problem::Result;
using problem::Step;

namespace {

std::string deck(const std::string& name) { return test::read_file(paths::data() + "/" + name + ".dat"); }

// The first warning of its kind; empty: none was given.
std::string said(const Result& r, int32_t number) {
  for (const c2d_error& e : r.told)
    if (e.status == number) return e.text;
  return "";
}
std::string coarse(const Result& r) { return said(r, C2D_WARN_FEW_PAIRS); }
std::string energy(const Result& r) { return said(r, C2D_WARN_ENERGY); }

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Without the numbers of pairs.
std::string figures(std::string text) {
  for (const char* before : {"pair ", "pairs ", " to "})
    for (size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
      const size_t from = at + std::string(before).size();
      size_t end = from;
      while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
      text.erase(from, end - from);
    }
  return text;
}

// A block on a table, pressed, then pushed to and fro by the traction on a wall.
Problem block(int32_t cycles) {
  Problem p = problem::from_text(deck("coarse/block_cycles")); // without its second load case
  for (problem::Body& body : p.bodies) {
    body.second_case = body.ends;
    for (problem::End& end : body.second_case)
      for (double& value : end.values) value = 0;
  }
  for (size_t end = 18; end < 26; ++end) p.bodies[1].second_case[end].values[0] = 1; // elements 10 to 13
  p.paths = {{1, 1, 0}};
  for (int32_t i = 0; i < cycles; ++i)
    for (double push : {0.2, -0.2}) p.paths.push_back({1, 1, push});
  return p;
}

} // namespace

TEST_CASE("coarse contact: the same is told of a deck and of its mirror image") {
  for (const Problem& p : {problem::from_text(deck("hard/D5_hang_3-740")), block(1)}) {
    const std::string one = coarse(problem::solve(p)), other = coarse(problem::solve(problem::reflected(p)));
    CHECK(!one.empty());
    CHECK(figures(one) == figures(other));
  }
}

TEST_CASE("coarse contact: in a ring the last pair and the first one are neighbours") {
  const std::string one = coarse(problem::solve_text(deck("coarse/ring")));
  const std::string other = coarse(problem::solve_text(deck("coarse/ring_mirror")));
  CHECK(holds(one, "between the contact edge and the highest pressure"));
  CHECK(holds(one, "the stick zone of pairs"));
  CHECK(figures(one) == figures(other));
}

TEST_CASE("coarse contact: all of the width is 100 %") {
  const std::string text = coarse(problem::solve_text(deck("hard/nonunique_9")));
  CHECK(holds(text, " (100 % of the width)"));
  CHECK(!holds(text, "e+"));
}

// The peak of a rounded pad is three times as high on fine meshes, where it ends is known to 5 %.
TEST_CASE("coarse contact: a pressure that stands up at an edge is told to be as uncertain as it is") {
  const Result r = problem::solve_text(deck("coarse/pad"));
  double most = 0;
  for (const Step& s : r.recorded())
    if (s.step == 2)
      for (int i = 0; i < s.pairs(); ++i) most = std::max(most, s.at(i, C2D_TN));
  const double fine = 765; // on elements of a tenth of the size, and still growing
  CHECK(most < 0.4 * fine);
  CHECK(holds(coarse(r), "the edge is uncertain by 0.509 (5.3 % of the width), this pressure by 65 %"));
}

TEST_CASE("coarse contact: one or two pairs that slip up to a corner, and no others") {
  CHECK(holds(coarse(problem::solve(block(1))), "the slip zone of pairs 1 to 1 is only 1 element wide"));
  const Result beside = problem::solve_text(test::read_file(paths::root() + "/examples/sliding_block.dat"));
  CHECK(coarse(beside) == ""); // nine slip at one corner, one at the other
}

// A strip of two flats is the zone, at whose ends both go on: one pair slips at one of them.
TEST_CASE("coarse contact: nothing is said of what slips up to the end of a zone that is no corner") {
  for (const bool right : {false, true}) {
    many::Model m;
    m.friction = 0.6;
    m.cases = 2;
    m.add(many::rectangle(-4, -2, 4, 0, {4, 2, 32, 2}));
    m.add(many::rectangle(-4, 0, 4, 2, {32, 2, 8, 2}));
    m.set(1, 1, many::end_of(many::kHeld));
    m.set(2, 3, [](double x, double) { return many::end_of(many::kPulled, 0, std::fabs(x) < 1.01 ? -1 : 0); });
    m.set_second(2, right ? 2 : 4, many::end_of(many::kPulled, right ? -1 : 1));
    m.zones.push_back({C2D_ZONE_MATCHING, {{1, 15, 30}, {2, 24, 9}}});
    m.paths = {{1, 1, 0}, {1, 1, 0.4132}};
    const many::Result r = many::solve(m);
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    const std::vector<many::Row> rows = r.zone_rows(1);
    int slip = 0;
    for (const many::Row& row : rows) slip += static_cast<int>(row[C2D_STATUS]) == C2D_SLIP ? 1 : 0;
    CHECK(slip == 1);
    CHECK((right ? rows.front() : rows.back())[C2D_STATUS] == C2D_SLIP);
    CHECK(!r.told_of("the slip zone"));
  }
}

// Spence: the pressure of a sharp punch has no bound. Equal elements are 30 to 70 % wrong near its edge, those that shrink
// towards it are not.
TEST_CASE("coarse contact: an element at a corner that carries much of the force") {
  const auto made = [](const std::string& arguments) {
    return test::run_shell("'" + paths::program() + "' make punch " + arguments + " | '" + paths::program() +
                           "' run - --listing /dev/null")
        .err;
  };
  for (const char* order : {"order=1", "order=2"}) {
    const std::string told = made(std::string("edge=0.025 grading=0.95 ") + order);
    CHECK(holds(told, "the last element before the corner at pair"));
    CHECK(holds(told, " carries 1"));
    CHECK(!holds(made(order), "coarse"));
  }
  CHECK(holds(made("edge=0.025 grading=0.95"), "carries 13 % of the force, and the pressure rises there to 5.1 times"));
}

TEST_CASE("energy of cycles: work that friction does not account for is told") {
  const Problem p = block(20);
  const Result r = problem::solve(p);
  CHECK(energy(problem::solve_text(deck("coarse/block_cycles"))) == energy(r));
  const std::string text = energy(r);
  CHECK(holds(text, "friction dissipated 1.49e-05 over the last load segment"));
  CHECK(holds(text, "but work minus the change of elastic energy is 1.07e-05, 28 % apart"));
  // As the steps have it.
  const std::vector<Step> steps = r.recorded();
  const auto left = [&](size_t i) { return steps[i].work - steps[i].elastic - (steps[i - 1].work - steps[i - 1].elastic); };
  CHECK(left(2) == doctest::Approx(1.07e-5).epsilon(0.01));
  CHECK(steps[2].dissipated - steps[1].dissipated == doctest::Approx(1.49e-5).epsilon(0.01));
  CHECK(energy(problem::solve(problem::split(p, 3))) == text); // however the path is divided
  Problem held = p;                                            // nor is the last digit of a factor that is held a turn
  held.paths.resize(1);
  double last = 1e-15, from = 0;
  for (size_t i = 1; i < p.paths.size(); from = p.paths[i++].second)
    for (int part = 1; part <= 3; ++part)
      held.paths.push_back({1, 1 + (last = -last), from + (p.paths[i].second - from) * part / 3});
  REQUIRE(held.paths[1].load != held.paths[2].load);
  CHECK(energy(problem::solve(held)) == text);
}

TEST_CASE("energy of cycles: at the end of the path as well, and not before there is a cycle") {
  CHECK(energy(problem::solve(block(0))) == "");
  CHECK(energy(problem::solve(block(1))) != "");
}

TEST_CASE("energy of cycles: nothing is told where they close") {
  const auto made = [](const std::string& arguments) {
    return test::run_shell("'" + paths::program() + "' make " + arguments + " | '" + paths::program() +
                           "' run - --listing /dev/null");
  };
  for (const char* name : {"mindlin", "mindlin Q=0.1", "mindlin n=6 move=0.0006"}) CHECK(!holds(made(name).err, "energy:"));
}

TEST_CASE("arcs of chords are no corners, neither in a zone nor where they are held") {
  const auto count = [](const std::string& name, int32_t number) {
    int found = 0;
    for (const c2d_error& e : problem::solve_text(deck(name)).told) found += e.status == number;
    return found;
  };
  CHECK(count("coarse/ring", C2D_WARN_KINK) == 0);
  CHECK(count("hard/D2_loose_41-21", C2D_WARN_CORNER) == 0);
  CHECK(count("hard/D1_4pairs_endless_24", C2D_WARN_KINK) == 2); // a roof
}

TEST_CASE("tension: bodies that touch without force have no pressure that could be negative") {
  CHECK(said(problem::solve_text(deck("coarse/parted")), C2D_WARN_TENSION) == "");
}

TEST_CASE("far: bodies that touch before any load are near, whatever the loads do") {
  for (const char* name : {"coarse/corner", "coarse/parted", "hard/D1_4pairs_endless_24"})
    CHECK_MESSAGE(said(problem::solve_text(deck(name)), C2D_WARN_FAR) == "", name);
}
