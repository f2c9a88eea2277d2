// The shipped examples: they run, and warn of nothing but what they are there to show.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace test;

namespace {

const std::string kExamples = paths::root() + "/examples/";

// Warnings, by a part of their text. The decks of the dissertation are references, kept as they are; the others say in their
// first lines that they warn.
const std::map<std::string, std::vector<std::string>> kOfDissertation = {
    {"half_cylinder.dat", {"the normals of the two surfaces differ", "strains reach"}},
    {"hertz.dat", {"the normals of the two surfaces differ", "is closed", "strains reach"}},
    {"hertz_fine.dat", {"the normals of the two surfaces differ", "is closed", "strains reach"}},
    {"hertz_frictionless.dat", {"strains reach"}}};
const std::map<std::string, std::vector<std::string>> kOnPurpose = {
    {"roller.dat", {"coarse contact: the slip zone"}},
    {"roller_fine.dat", {"coarse contact: the slip zone"}},
    {"families/bimaterial.c2s", {"joins unlike materials"}},
    {"families/dovetail.c2s", {"at a corner of the contact"}},
    {"families/lap_joint.c2s", {"the surfaces stay far apart"}},
    {"tutorial/t13_o_ring.c2s", {"strains reach 0.07", "slip since it last touched", "have moved sideways"}},
    {"revolution/belleville.c2s", {"slip since it last touched", "have moved sideways"}},
    {"revolution/round_punch.c2s", {"at a corner of the contact"}},
    {"revolution/washer.c2s", {"at a corner of the contact"}}};
// Files that are not to be solved as they are, with their exit status.
const std::map<std::string, int> kWrong = {{"tutorial/t3_mistakes.c2s", 2}, {"tutorial/t12_sliding.c2s", 1}};

std::vector<std::string> allowed(const std::string& name) {
  for (const auto* table : {&kOfDissertation, &kOnPurpose})
    if (table->count(name) != 0) return table->at(name);
  return {};
}

void check_warnings(const std::string& name) {
  CAPTURE(name);
  const Result run = run_shell("'" + paths::program() + "' run --no-progress --listing /dev/null '" + kExamples + name + "'");
  const bool wrong = kWrong.count(name) != 0;
  CHECK_MESSAGE(run.status == (wrong ? kWrong.at(name) : 0), run.err);
  std::set<std::string> seen;
  for (const std::string& line : lines_of(run.err)) {
    if (!contains(line, ": warning:")) continue;
    bool known = false;
    for (const std::string& part : allowed(name))
      if (contains(line, part)) known = true, seen.insert(part);
    CHECK_MESSAGE(known, line);
  }
  CHECK(seen.size() == allowed(name).size()); // what is listed is still so
}

std::vector<std::string> models_in(const std::string& folder) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(kExamples + folder))
    if (entry.path().extension() == ".dat" || entry.path().extension() == ".c2s")
      out.push_back(folder + entry.path().filename().string());
  return out;
}

} // namespace

TEST_CASE("examples: decks warn of nothing but what they show") {
  for (const std::string& name : models_in(""))
    if (fs::path(name).extension() == ".dat") check_warnings(name);
}

TEST_CASE("examples: sketches warn of nothing but what they show") {
  for (const char* folder : {"", "tutorial/", "families/", "revolution/"})
    for (const std::string& name : models_in(folder))
      if (fs::path(name).extension() == ".c2s") check_warnings(name);
}

TEST_CASE("examples: those that warn on purpose say so in their first lines") {
  for (const auto& each : kOnPurpose) {
    const std::string& name = each.first;
    CAPTURE(name);
    const std::vector<std::string> lines = lines_of(read_file(kExamples + name));
    bool said = false;
    for (size_t i = 0; i < 6; ++i) said = said || contains(lines.at(i), "arn");
    CHECK(said);
  }
}

// `name` in the first column of a table, and behind it whether it warns: (W).
TEST_CASE("examples: the table of examples marks those that warn, and no others") {
  const std::string page = read_file(kExamples + "README.md");
  size_t marks = 0, listed = 0;
  for (size_t at = page.find("` (W)"); at != std::string::npos; at = page.find("` (W)", at + 1)) ++marks;
  for (const auto* table : {&kOfDissertation, &kOnPurpose})
    for (const auto& each : *table) {
      const bool family = each.first.rfind("families/", 0) == 0; // their table names the folder once
      const std::string name = family ? each.first.substr(9) : "examples/" + each.first;
      if (!contains(page, "`" + name + "`")) continue;
      ++listed;
      CAPTURE(name);
      CHECK((contains(page, "`" + name + "` (W)") || contains(page, "`" + name + "`, `examples/roller_fine.dat` (W)")));
    }
  CHECK(marks + 1 == listed); // one mark for both decks of the roller
}
