// Pictures and tables of a cycle that is repeated until it is steady: they agree with the JSON and the CSV.
#include "json.hpp"
#include "paths.hpp"
#include "picture_runs.hpp"

using namespace test;

namespace {

// Like bodies pressed together and sheared to and fro, as `contact2d make mindlin`.
void show_mindlin(Shown& shown) {
  std::string deck = run_shell("'" + paths::program() + "' make mindlin n=4").out;
  deck = deck.substr(0, deck.find("*PATH")) + "*PATH\n1 1 0\ncycle\n2 1 1\n2 1 -1\n2 1 0\n";
  write_file(shown.folder / "d.dat", deck);
  show(shown, shown.folder / "d.dat", "--json " + quoted(shown.folder / "j"));
}

const Json& number(const Json& object, const std::string& name) { return object.members.at(name); }

// The cells of the rows of a table on the page, behind this summary.
std::vector<std::vector<std::string>> rows_of_table(const std::string& page, const std::string& summary) {
  std::vector<std::vector<std::string>> out;
  const size_t from = page.find("<summary>" + summary);
  REQUIRE(from != std::string::npos);
  const size_t end = page.find("</table>", from);
  for (size_t row = page.find("<tr><td>", from); row < end; row = page.find("<tr><td>", row + 1)) {
    out.emplace_back();
    const size_t last = page.find("</tr>", row);
    for (size_t at = page.find("<td>", row); at < last; at = page.find("<td>", at + 1))
      out.back().push_back(page.substr(at + 4, page.find("</td>", at) - at - 4));
  }
  return out;
}

} // namespace

TEST_CASE("pictures: a steady cycle, cycle by cycle, step by step, the loop of a pair and all statuses") {
  Shown shown;
  show_mindlin(shown);
  REQUIRE_MESSAGE(shown.result.status == 0, shown.result.err);
  check_page(shown);
  for (const char* name : {"cycles", "cycle_steps", "cycle_loop", "cycle_status"})
    CHECK_MESSAGE(shown.figures.count(name) == 1, name);
  const Json json = JsonReader::read(read_file(shown.folder / "j"));
  const Json& cycles = number(number(json, "cycles").items[0], "cycles");
  const Json& last = cycles.items.back();
  const Json& zone = number(last, "zones").items[0];
  const auto words = [](double value, const char* of) { return std::to_string(static_cast<int>(value)) + of; };

  const std::string statuses = caption_of(shown, "cycle_status");
  CHECK(contains(statuses, words(number(zone, "stuck").number, " of ")));
  CHECK(contains(statuses, words(number(zone, "slipped").number, " slip at some time")));
  const std::string loop = caption_of(shown, "cycle_loop");
  CHECK(contains(loop, words(number(last, "slip_range_pair").number, " at x = ")));
  const std::string range = six(number(last, "slip_range").number).substr(0, 4); // of the caption's digits
  CHECK_MESSAGE(contains(loop, "moves over " + range), range << " in " << loop);
  CHECK(contains(caption_of(shown, "cycles"), "steady in cycle 2: pairs slip forth and back by the same amount"));
  CHECK(contains(shown.page, "The cycle is steady in cycle 2: "));

  CHECK(rows_of_table(shown.page, "Cycle by cycle").size() == cycles.items.size());
  const std::vector<std::vector<std::string>> steps = rows_of_table(shown.page, "Steps of the last cycle");
  REQUIRE(steps.size() == 7);
  CHECK((steps.front()[0] == "start" && steps.back()[0] == "7"));
  const double dissipated = number(last, "dissipated").number;
  CHECK(std::fabs(std::atof(steps.back().back().c_str()) - dissipated) < 1e-5 * dissipated);
  CHECK(std::fabs(std::atof(steps[0].back().c_str())) == 0);

  const std::string zone_loop = caption_of(shown, "loop");
  CHECK(contains(zone_loop, "The last cycle, steps 1 to 7, "));
  const size_t at = zone_loop.find("friction dissipated ");
  REQUIRE(at != std::string::npos);
  CHECK(std::fabs(std::atof(zone_loop.c_str() + at + 20) - dissipated) < 1e-5 * dissipated);
}
