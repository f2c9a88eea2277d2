// The trace of a load path: what it tells, replayed, gives the statuses of every recorded step.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <sstream>

using namespace test;

namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');) out.push_back(word);
  return out;
}

std::vector<Row> table(const std::string& path) {
  const std::vector<std::string> lines = lines_of(read_file(path));
  std::vector<Row> rows;
  REQUIRE(!lines.empty());
  const std::vector<std::string> names = words_of(lines[0]);
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> words = words_of(lines[i]);
    REQUIRE(words.size() == names.size());
    Row row;
    for (size_t k = 0; k < words.size(); ++k) row[names[k]] = words[k];
    rows.push_back(row);
  }
  return rows;
}

bool is_reason(const std::string& from, const std::string& to, const std::string& why) {
  if (from == "none") return why == "start";
  if (from == "open") return why == "gap closed" && to != "open";
  if (to == "open") return why == "no pressure left";
  if (from == "stick") return to == "slip" && why == "friction at its bound";
  return why == (to == "stick" ? "slip ended" : "slip turned");
}

struct Replayed {
  int events = 0, rows = 0, steps = 0;
};

Replayed replay(const std::string& deck, const std::string& options = "") {
  const Folder folder;
  const Result run = run_shell("'" + paths::program() + "' run '" + deck + "' --csv '" + (folder / "csv") + "' --trace '" +
                               (folder / "trace") + "' --listing /dev/null " + options);
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::vector<Row> trace = table(folder / "trace"), steps = table(folder / "csv");
  Replayed out;
  size_t next = 0;
  std::map<std::string, std::string> status; // of each pair
  std::vector<std::string> coefficients;     // as the path takes them
  for (const Row& step : steps)
    if (coefficients.empty() || coefficients.back() != step.at("mu")) coefficients.push_back(step.at("mu"));
  const auto place = [&](const Row& row) {
    const auto at = std::find(coefficients.begin(), coefficients.end(), row.at("mu"));
    return std::make_pair(at - coefficients.begin(), std::stoi(row.at("step")));
  };
  for (size_t i = 0; i < steps.size(); ++i) {
    const Row& step = steps[i];
    for (; next < trace.size(); ++next) {
      const Row& change = trace[next];
      const bool later = place(change) > place(step);
      if (later) break;
      CHECK(is_reason(change.at("from"), change.at("to"), change.at("why")));
      if (change.at("event") == "0")
        status.erase(change.at("pair"));
      else
        CHECK(status[change.at("pair")] == change.at("from"));
      status[change.at("pair")] = change.at("to");
      out.events = std::max(out.events, std::stoi(change.at("event")));
      ++out.rows;
    }
    CHECK_MESSAGE(status[step.at("pair")] == step.at("status"),
                  deck << " mu " << step.at("mu") << " step " << step.at("step") << " pair " << step.at("pair"));
    ++out.steps;
  }
  CHECK(next == trace.size());
  return out;
}

} // namespace

TEST_CASE("trace: replayed, it gives the statuses of every recorded step") {
  for (const std::string& deck : {made("mindlin"), paths::root() + "/examples/half_cylinder.dat", made("cylinder_friction"),
                                  paths::root() + "/examples/roller.dat"}) {
    CAPTURE(deck);
    const Replayed seen = replay(deck);
    CHECK(seen.events > 5);
    CHECK(seen.rows > seen.events);
  }
}

TEST_CASE("trace: of the increments of a deck, too") { CHECK(replay(made("mindlin"), "--stepping deck").events > 5); }

TEST_CASE("trace: a column for each load case, and it changes no result") {
  const Folder folder;
  const std::string run = "'" + paths::program() + "' run '" + made("mindlin") + "' --listing /dev/null --csv '";
  REQUIRE(run_shell(run + (folder / "a") + "' --trace '" + (folder / "t") + "'").status == 0);
  REQUIRE(run_shell(run + (folder / "b") + "'").status == 0);
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  CHECK(lines_of(read_file(folder / "t"))[0] == "mu,step,event,load,load2,pair,from,to,why");
}
