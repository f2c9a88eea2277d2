// contact2d make: usage, and that every family's default deck can be solved and is the one in examples/.
#include "family_runs.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

using namespace test;

namespace {

Result make(const std::string& arguments) { return run_shell("'" + paths::program() + "' make " + arguments); }

} // namespace

TEST_CASE("families: make --list tells every family with its keys, meanings and defaults") {
  const Result list = make("--list");
  CHECK(list.status == 0);
  for (const families::Family& family : families::all_families()) {
    CHECK_MESSAGE(contains(list.out, std::string(family.name) + ": " + family.summary), family.name);
    for (const families::Parameter& p : family.parameters) {
      CHECK_MESSAGE(contains(list.out, std::string("  ") + p.key + "=" + p.value), family.name << " " << p.key);
      CHECK_MESSAGE(contains(list.out, p.meaning), family.name << " " << p.key);
    }
  }
}

TEST_CASE("families: wrong names, keys and values end with 64 and list the keys") {
  struct Wrong {
    const char *arguments, *said;
  };
  const Wrong wrong[] = {{"", "needs the name of a family"},
                         {"herz", "'herz' is not a known family; known are hertz "},
                         {"--list hertz", "not a known family"},
                         {"hertz m=20", "'m' is not a key of this family"},
                         {"hertz n", "'n': expected key=value"},
                         {"hertz =20", "'' is not a key"},
                         {"hertz n=10 n=20", "n is given twice"},
                         {"hertz n=2.5", "n=2.5: expected a whole number from 1 to 2000"},
                         {"hertz n=0", "n=0: expected a whole number"},
                         {"hertz n=1e9", "expected a whole number"},
                         {"hertz n=", "expected a whole number"},
                         {"hertz E1=-5", "E1=-5: expected a number above 0"},
                         {"hertz E1=nan", "expected a number above 0"},
                         {"hertz E1=12x", "expected a number above 0"},
                         {"hertz nu1=0.6", "expected a number above -1, at most 0.5"},
                         {"hertz edge=1.5", "expected a number from 0 to 1"},
                         {"hertz order=4", "order=4: expected 1, 2 or 3"},
                         {"hertz a=50", "a is above R/10"},
                         {"hertz L=1", "L is below 3"},
                         {"punch mu=-1", "expected a number from 0, or inf"},
                         {"punch grading=1", "grading is to be from 0.25 to below 1"},
                         {"mindlin Q=0", "Q is to be above 0"},
                         {"receding_layer zone=0.001", "zone is below one element"},
                         {"receding_layer strip=10", "strip is above 0.5"},
                         {"ring plane=flat", "plane=flat: expected one of strain|stress"},
                         {"ring b=0.5", "b is not above a"},
                         {"stack q=0.3", "q is not below mu p"},
                         {"rollers platens=elastic", "platens is to be rigid for several rollers"},
                         {"bearing Z=4", "Z is not from 5 to 60"},
                         {"bearing R=2", "rollers touch"},
                         {"bearing a=0.1", "a is above r/20"},
                         {"coating t=0.05", "t is below 0.1"},
                         {"bimaterial L=1", "L is below 2"},
                         {"shrink c=1", "a, b, c, d are to rise"},
                         {"crack W=1", "W is below 1.2"},
                         {"crack n=5", "n is below 10"},
                         {"crack ratio=1.01", "ratio is to be from 1.05 to 2"},
                         {"hertz ratio=1", "ratio=1: expected a number above 1"}};
  for (const Wrong& w : wrong) {
    const Result result = make(w.arguments);
    CHECK_MESSAGE(result.status == 64, w.arguments);
    CHECK_MESSAGE(result.out.empty(), w.arguments);
    CHECK_MESSAGE(result.err.compare(0, 11, "contact2d: ") == 0, w.arguments);
    CHECK_MESSAGE(contains(result.err, w.said), w.arguments << ": " << result.err);
  }
  const Result keys = make("hertz m=20"); // the keys stand below
  CHECK(contains(keys.err, "  n=20"));
  CHECK(contains(keys.err, "elements over the half width"));
}

TEST_CASE("families: numbers that do not go together are told, one by one") {
  const struct {
    const char *family, *setting, *told;
  } wrong[] = {{"coating", "a=50", "a is above R/10"},
               {"coating", "L=2", "L is below 3"},
               {"coating", "L=5", "L is below four times 1 + t"},
               {"crack", "ratio=3", "ratio is to be from 1.05 to 2"},
               {"cylinder_friction", "a=50", "a is above R/10"},
               {"cylinder_friction", "L=2", "L is below 3"},
               {"cylinder_friction", "n=1 edge=0", "n=1 needs an edge above 0"},
               {"cylinder_friction", "n=5 sizes=", "sizes=: expected one of "},
               {"disc_in_hole", "L=1", "L is below 2"},
               {"disc_in_hole", "Sx=0", "Sx and Sy are both 0"},
               {"hole", "L=1", "L is below 1.5"},
               {"layer_lifted", "L=5", "L is below zone + 2"},
               {"mindlin", "a=50", "a is above R/10"},
               {"mindlin", "L=2", "L is below 3"},
               {"mindlin", "mu=inf", "mu is to be above 0 and finite"},
               {"mindlin", "mu=0", "mu is to be above 0 and finite"},
               {"mindlin", "Q=1", "Q is to be below 1"},
               {"punch", "L=2", "L is below 3"},
               {"punch", "grading=0.2", "grading is to be from 0.25 to below 1"},
               {"receding_layer", "L=5", "L is below twice the length of the layer"},
               {"ring", "plane=strain|stress", "plane=strain|stress: expected one of strain|stress"},
               {"rollers", "a=50", "a is above R/10"},
               {"rollers", "L=2", "L is below 3"},
               {"rollers", "rollers=16", "rollers is above 15"},
               {"rollers", "pitch=2", "pitch is below 2.01"},
               {"shrink", "a=2", "a, b, c, d are to rise"},
               {"shrink", "d=2", "a, b, c, d are to rise"},
               {"shrink", "delta=0.1", "delta is above 0.01"},
               {"stack", "plates=51", "plates is above 50"},
               {"bearing", "Z=61", "Z is not from 5 to 60"},
               {"coating", "nu1=-1", "expected a number above -1"},
               {"hertz", "edge=-1", "expected a number from 0 to 1"},
               {"hertz", "n=1 m=1 L=2", "'m' is not a key"}}; // the first mistake is told
  for (const auto& w : wrong) {
    CAPTURE(w.family);
    CAPTURE(w.setting);
    std::vector<std::string> settings;
    std::istringstream words(w.setting);
    for (std::string word; words >> word;) settings.push_back(word);
    std::string deck, error;
    CHECK_FALSE(families::make_deck(w.family, settings, deck, error));
    CHECK(contains(error, w.told));
    CHECK(deck.empty());
  }
}

TEST_CASE("families: in plane stress nothing of a deck changes but that, and what is given as the displacements of a field") {
  for (const char* family : {"hole", "ring", "crack", "shrink"}) {
    CAPTURE(family);
    std::string strain, stress, error;
    REQUIRE(families::make_deck(family, {"n=10"}, strain, error));
    REQUIRE(families::make_deck(family, {"n=10", "plane=stress"}, stress, error));
    std::istringstream one(strain), other(stress);
    int differ = 0;
    for (std::string a, b; std::getline(one, a) && std::getline(other, b);) differ += a != b;
    CHECK(differ <= 4); // its comment, its number, what the heading says of how it was made
    CHECK(contains(stress, "plane stress; output"));
    CHECK(contains(strain, "plane strain; output"));
  }
}

TEST_CASE("families: decks of many coefficients, adhesion beside ties, rigid bodies that are free, points that are held") {
  families::ProblemModel model;
  std::string error;
  REQUIRE(families::make_model("shrink", {"n=4", "bond=free"}, model, error));
  model.friction = {0, 0.1, 0.2, HUGE_VAL, 0.4, 0.5, 0.6};
  const std::string many = families::write_deck(model);
  CHECK(contains(many, "\n7 0 0.1 0.2 "));
  CHECK(contains(many, " 0.4\n 0.5 0.6\n"));
  CHECK(contains(many, "\n*FRICTION\n1 0 0.1 0.2 INF 0.4 0.5 0.6\n")); // and nothing for the tie
  CHECK(contains(many, "*TIE 2"));
  model.bodies[2].rigid = {families::RigidModel::kLoaded, {0, 0}, "", {{1, 2, 3}}};
  CHECK(contains(families::write_deck(model), "\n*RIGID LOAD 3 0 0\n1 1 2 3\n"));
  // Held at the point where the outline begins and ends, at one beside it, and at one whose side is held already.
  families::Outline held({0, 0});
  held.hold_x(0.25).hold_y(0.5);
  held.line({2, 0}, {0, 1, 2}).hold_y(0.125);
  held.line({2, 1}, {0, 1}, families::clamped(3, 4)).hold_x(7);
  held.line({0, 1}, {0, 1}, families::roller_x(9));
  held.line({0, 0}, {0, 1});
  families::ProblemModel one;
  families::BodyModel body;
  body.youngs_modulus = 1;
  body.regions = {held};
  one.bodies = {body};
  const std::string deck = families::write_deck(one);
  CHECK(contains(deck, "\n1 1 1100 0 0 0.25 0.5\n")); // the element that begins there holds it
  CHECK(contains(deck, "\n5 2 0000 0 0 0.25 0.5\n")); // to the one that ends there it is known
  CHECK(contains(deck, "\n3 1 1100 0 0 3 4\n"));
  CHECK_FALSE(contains(deck, " 7 ")); // that side has said what it does
  // Zones on outlines that are not the first, at the end of one, and at an outline's end: the node is its first.
  families::Outline outer({-3, -3}), hole({1, 0}), disc({1, 0});
  outer.line({3, -3}, {0, 1}).line({3, 3}, {0, 1}).line({-3, 3}, {0, 1}).line({-3, -3}, {0, 1});
  hole.arc({0, 0}, 1, 360, 180, {0, 1, 2, 3}).arc({0, 0}, 1, 180, 0, {0, 1, 2, 3});
  disc.arc({0, 0}, 1, 0, 180, {0, 1, 2, 3}).arc({0, 0}, 1, 180, 360, {0, 1, 2, 3});
  families::ProblemModel ring;
  families::BodyModel plate, inner;
  plate.youngs_modulus = inner.youngs_modulus = 1;
  plate.regions = {outer, hole}, inner.regions = {disc};
  ring.bodies = {plate, inner};
  families::ContactZone zone{{0, 0, 1}, {1, 1}};
  zone.without_first = true;
  ring.zones = {zone, {{0, 1, 1}, {1, 0}}};
  const std::string zones = families::write_deck(ring);
  CHECK(contains(zones, "\n1 2 3 3\n5 7 6 4\n6 8 6 4\n"));
  CHECK(contains(zones, "\n1 2 4 3\n8 10 3 1\n8 5 4 1\n"));
  // A straight side of two elements between arcs: its middle point has a card of its own.
  families::Outline slot({1, 0});
  slot.arc({0, 0}, 1, 0, 180, {0, 1, 2}).line({-1, -4}, {0, 1, 2}).arc({0, -4}, 1, 180, 360, {0, 1, 2}).line({1, 0}, {0, 1, 2});
  families::ProblemModel slotted;
  body.regions = {slot};
  slotted.bodies = {body};
  CHECK(contains(families::write_deck(slotted), "\n4 -1 -2\n"));
}

TEST_CASE("families: cracks that close in part, deep edge cracks, slip nearly everywhere, beams in plane stress") {
  std::string deck, error;
  REQUIRE(families::make_deck("crack", {"tension=0.1", "bending=1", "n=20"}, deck, error));
  std::string open;
  REQUIRE(families::make_deck("crack", {"tension=1", "n=20"}, open, error));
  CHECK(lines_of(deck).size() > lines_of(open).size()); // small elements where the faces close
  REQUIRE(families::make_deck("crack", {"shape=edge", "W=1.5", "n=20"}, deck, error));
  CHECK(contains(deck, "Tension: K1 = "));
  CHECK_FALSE(contains(deck, "Bending: K1 = ")); // the formula ends at 0.6
  REQUIRE(families::make_deck("crack", {"shape=edge", "W=2", "n=20"}, deck, error));
  CHECK(contains(deck, "Bending: K1 = "));
  REQUIRE(families::make_deck("mindlin", {"Q=0.95", "n=6"}, deck, error));
  REQUIRE(families::make_deck("cylinder_friction", {"n=5"}, deck, error));
  CHECK_FALSE(families::make_deck("cylinder_friction", {"n=5", "sizes=jump"}, deck, error));
  CHECK(contains(error, "n is below 6: too few elements for several sizes"));
  std::string stress;
  REQUIRE(families::make_deck("cantilever", {"nu=0"}, deck, error));
  REQUIRE(families::make_deck("cantilever", {"nu=0", "plane=stress"}, stress, error));
  CHECK(contains(stress, "plane stress; output"));
  const auto displacement = [](const std::string& text) {
    const size_t at = text.find("in plane strain: ");
    REQUIRE(at != std::string::npos);
    return std::strtod(text.c_str() + at + 17, nullptr);
  };
  CHECK(displacement(stress) == displacement(deck)); // without contraction both are one
  REQUIRE(families::make_deck("cantilever", {"nu=0.5", "plane=strain"}, deck, error));
  REQUIRE(families::make_deck("cantilever", {"nu=0.5", "plane=stress"}, stress, error));
  CHECK(displacement(deck) / displacement(stress) == doctest::Approx(0.75));
}

TEST_CASE("families: what moves the flanks of mindlin is said as it is") {
  const std::string by_load = make("mindlin").out, by_hand = make("mindlin move=0.03").out;
  CHECK(contains(by_load, ", which makes Q about "));
  CHECK(contains(by_hand, "Flanks move by 0.03."));
  CHECK_FALSE(contains(by_hand, "which makes Q"));
}

TEST_CASE("families: the cards hold every number with all its digits") {
  families::ProblemModel model;
  families::BodyModel body;
  body.youngs_modulus = 1.0 / 3;
  body.poisson_ratio = 0.1 + 0.2;
  body.origin = {0.1, -1e-7 / 3};
  const double edge = 1 + 1e-14, far = 1e6 / 7;
  families::Outline outline({0.1, 0.2});
  outline.line({edge, 0.2}, {0, 1e-6 / 3, 0.7});
  outline.line({far, far}, {0, 1}, families::traction(-1e-5 / 7, 2.0 / 3));
  outline.line({0.1, 0.2}, {0, 1});
  body.regions = {outline};
  model.bodies = {body};
  std::istringstream deck(families::write_deck(model));
  std::vector<double> read;
  for (std::string word; deck >> word;) {
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (*end == '\0') read.push_back(value);
  }
  const auto has = [&](double value) { return std::count(read.begin(), read.end(), value) > 0; };
  CHECK(has(1.0 / 3));
  CHECK(has(0.1 + 0.2));
  CHECK(has(-1e-5 / 7));
  CHECK(has(-1e-7 / 3));
  for (const families::Outline::Node& node : outline.nodes()) {
    CHECK(has(node.at.x - body.origin.x));
    CHECK(has(node.at.y - body.origin.y));
  }
}

TEST_CASE("families: the ready decks are what make writes") {
  for (const families::Family& family : families::all_families()) {
    const std::string file = paths::root() + "/examples/make_" + family.name + ".dat";
    std::vector<std::string> settings;
    for (const std::string& line : lines_of(read_file(file)))
      if (line.compare(0, 2, "  ") == 0 && contains(line, "=")) {
        std::istringstream words(line);
        for (std::string word; words >> word;) settings.push_back(word);
      } else if (line.compare(0, 1, "!") == 0) {
        break; // the heading is over
      }
    std::string deck, error;
    REQUIRE_MESSAGE(families::make_deck(family.name, settings, deck, error), error);
    CHECK_MESSAGE(deck == read_file(file), file);
    const families_test::Solution solution = families_test::solve_deck(deck);
    CHECK_MESSAGE(solution.error.empty(), family.name << ": " << solution.error);
  }
}

// The receding contact is wider than this zone; punches and layers end where a body does.
TEST_CASE("families: a zone that ends within a contact closed from the start is warned of") {
  const auto warned = [](const std::string& arguments) {
    const Result run =
        run_shell("'" + paths::program() + "' make " + arguments + " | '" + paths::program() + "' run - --listing /dev/null");
    CHECK_MESSAGE(run.status == 0, run.err);
    return contains(run.err, "at an end of a contact zone carries pressure");
  };
  CHECK(warned("receding_layer zone=0.5"));
  CHECK(!warned("receding_layer"));
  CHECK(!warned("punch"));
  CHECK(!warned("layer_pressed"));
}
