// The shipped sketches whose loads repeat until they are steady, against finer solutions.
#include "json.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace test;

namespace {

Json solved(const std::string& example) {
  const Folder folder;
  const Result run = run_shell("'" + paths::program() + "' run -q '" + paths::root() + "/examples/" + example + "' --json '" +
                               (folder / "j") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err); // all errors are within their tolerances
  return JsonReader::read(read_file(folder / "j"));
}

// A number with a stated error, which covers what it is off by.
void check_stated(const Json& json, const std::string& name, double expected, double doubt) {
  CAPTURE(name);
  bool seen = false;
  for (const Json& s : json["accuracy"]["stated"].items) {
    if (s["name"].text != name || !s.has("tolerance") || s["tolerance"].kind != Json::kNumber) continue;
    seen = true;
    CHECK(std::fabs(s["value"].number - expected) <= s["error"].number + doubt);
    CHECK(s["error"].number < 0.5 * expected); // so it has a sign
  }
  CHECK(seen);
}

const std::string& result_of(const Json& json) { return json["cycles"][0]["result"].text; }

} // namespace

// Uniform meshes of 80, 160 and 320 pairs with 96 positions give 0.505, 0.550 and 0.561 um, 160 pairs with 192 positions 0.580:
// 0.60 um with an error of 0.03.
TEST_CASE("cycle examples: a ring creeps in its housing, by as much as on uniform meshes") {
  const Json json = solved("creeping_ring.c2s");
  CHECK(result_of(json) == "ratchets");
  check_stated(json, "walk", 0.60e-3, 0.03e-3);
}

// By `tolerance 1 %`: four times the elements.
TEST_CASE("cycle examples: a fitted shaft slips at the edges of its hub, as on a finer mesh") {
  const Json json = solved("fitted_shaft.c2s");
  CHECK(result_of(json) == "slips");
  check_stated(json, "dissipated in the last cycle", 0.00315708, 0.00075 * 0.00315708);
  check_stated(json, "SWT of above", 1.47642, 0.0029 * 1.47642);
  check_stated(json, "Fatemi-Socie of above", 0.00528669, 0.0076 * 0.00528669);
}
