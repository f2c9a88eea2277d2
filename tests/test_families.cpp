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
    CHECK_MESSAGE(contains(list.out, std::string(family.name) + ": " + families::summary_of(family)), family.name);
    for (const families::Parameter& p : families::parameters_of(family)) {
      CHECK_MESSAGE(contains(list.out, "  " + p.key + "=" + p.value), family.name << " " << p.key);
      CHECK_MESSAGE(contains(list.out, p.meaning), family.name << " " << p.key);
    }
  }
}

TEST_CASE("families: wrong names, keys and values end with 64 and list the keys") {
  struct Wrong {
    const char *arguments, *said;
  };
  const Wrong wrong[] = {{"", "needs the name of a family"},
                         {"herz", "'herz' is not a known family, did you mean 'hertz'?"},
                         {"wheel", "'wheel' is not a known family, expected one of bearing "},
                         {"--list hertz", "not a known family"},
                         {"hertz m=20", "'m' is not a key of this family"},
                         {"punch muu=0.3", "'muu' is not a key of this family, did you mean 'mu'?"},
                         {"hertz n", "'n': expected key=value"},
                         {"hertz =20", "'' is not a key"},
                         {"hertz n=10 n=20", "n is given twice"},
                         {"hertz n=2.5", "expected the number of elements, a whole number from 1 to 20000"},
                         {"hertz n=0", "n is below 1"},
                         {"hertz n=1e9", "expected the number of elements"},
                         {"hertz n=", "n=: expected a number"},
                         {"hertz E1=-5", "E"},
                         {"hertz E1=nan", "E1=nan: expected a number"},
                         {"hertz E1=12x", "E1=12x: expected a number"},
                         {"hertz nu1=0.6", "0.6"},
                         {"hertz edge=1.5", "edge is not from 0 to 1"},
                         {"hertz order=4", "1 for linear, 2 for quadratic, 3 for cubic functions"},
                         {"hertz a=50", "a is above R/10"},
                         {"hertz L=1", "L is below 3"},
                         {"punch mu=-1", "expected a coefficient of friction, 0 or above"},
                         {"punch grading=1", "grading is to be from 0.25 to below 1"},
                         {"mindlin Q=0", "mu and Q are to be above 0"},
                         {"receding_layer zone=0.001", "zone is below one element"},
                         {"receding_layer strip=10", "strip is above 0.5"},
                         {"ring plane=flat", "plane=flat: expected one of strain|stress"},
                         {"ring b=0.5", "b is not above a"},
                         {"stack q=0.3", "q is not below mu p"},
                         {"bearing Z=4", "Z is not from 5 to 18"},
                         {"bearing R=2", "rollers touch"},
                         {"bearing a=0.1", "a is above r/20"},
                         {"coating t=0.05", "t is below 0.1"},
                         {"bimaterial L=1", "L is below 2"},
                         {"shrink c=1", "a, b, c, d are to rise"},
                         {"crack W=1", "W is below 1.2"},
                         {"crack n=5", "n is below 10"},
                         {"crack ratio=1.01", "ratio is to be from 1.05 to 2"},
                         {"hertz ratio=1", "1: expected a growth above 1"}};
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
               {"mindlin", "mu=inf", "mu is to be finite"},
               {"mindlin", "mu=0", "mu and Q are to be above 0"},
               {"mindlin", "Q=1", "Q is to be below 1"},
               {"punch", "L=2", "L is below 3"},
               {"punch", "grading=0.2", "grading is to be from 0.25 to below 1"},
               {"receding_layer", "L=5", "L is below twice the length of the layer"},
               {"ring", "plane=strain|stress", "plane=strain|stress: expected one of strain|stress"},
               {"rollers", "a=50", "a is above R/10"},
               {"roller_between", "L=2", "L is below 3"},
               {"rollers", "pitch=2", "pitch is below 2.01"},
               {"shrink", "a=2", "a, b, c, d are to rise"},
               {"shrink", "d=2", "a, b, c, d are to rise"},
               {"shrink", "delta=0.1", "delta is above 0.01"},
               {"stack", "plates=8", "plates is not from 2 to 7"},
               {"bearing", "Z=61", "Z is not from 5 to 18"},
               {"coating", "nu1=-1", "-1"},
               {"hertz", "edge=-1", "edge is not from 0 to 1"},
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

TEST_CASE("families: in plane stress nothing of a deck changes but that") {
  for (const char* family : {"hole", "ring", "crack", "shrink"}) {
    CAPTURE(family);
    std::string strain, stress, error;
    REQUIRE(families::make_deck(family, {"n=10"}, strain, error));
    REQUIRE(families::make_deck(family, {"n=10", "plane=stress"}, stress, error));
    std::istringstream one(strain), other(stress);
    int differ = 0;
    for (std::string a, b; std::getline(one, a) && std::getline(other, b);) differ += a != b;
    CHECK(differ == 2); // its comment, its number
    CHECK(contains(stress, "plane stress; output"));
    CHECK(contains(strain, "plane strain; output"));
  }
}

TEST_CASE("families: cracks that close in part, slip nearly everywhere, sizes that jump") {
  std::string deck, error, open;
  REQUIRE(families::make_deck("crack", {"tension=0.1", "bending=1", "n=20"}, deck, error));
  REQUIRE(families::make_deck("crack", {"tension=1", "n=20"}, open, error));
  CHECK(lines_of(deck).size() > lines_of(open).size()); // small elements where the faces close
  REQUIRE(families::make_deck("mindlin", {"Q=0.95", "n=6"}, deck, error));
  REQUIRE(families::make_deck("cylinder_friction", {"n=5"}, deck, error));
  CHECK_FALSE(families::make_deck("cylinder_friction", {"n=5", "sizes=jump"}, deck, error));
  CHECK(contains(error, "n is below 6: too few elements for several sizes"));
}

TEST_CASE("families: every one can be solved with its defaults") {
  for (const families::Family& family : families::all_families()) {
    CAPTURE(family.name);
    std::string deck, error;
    REQUIRE_MESSAGE(families::make_deck(family.name, {}, deck, error), error);
    const families_test::Solution solution = families_test::solve_deck(deck);
    CHECK_MESSAGE(solution.error.empty(), solution.error);
  }
}

TEST_CASE("families: a zone that ends within a contact closed from the start is warned of") {
  const auto warned = [](const std::string& arguments) {
    const Result run =
        run_shell("'" + paths::program() + "' make " + arguments + " | '" + paths::program() + "' run - --listing /dev/null");
    CHECK_MESSAGE(run.status == 0, run.err);
    return contains(run.err, "at an end of a contact zone is closed");
  };
  CHECK(warned("receding_layer zone=0.5"));
  CHECK(!warned("receding_layer"));
  CHECK(!warned("punch"));
  CHECK(!warned("layer_pressed"));
}
