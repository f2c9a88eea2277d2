// The engines of examples/jobs end with the numbers of the program's own sweep. What is not installed is left out, and said.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

using namespace test;
namespace fs = std::filesystem;

namespace {

// examples/jobs in a place of its own, beside the sketch it solves.
struct Place {
  Folder folder;
  std::string jobs;
  Place() : jobs(folder / "jobs") {
    fs::copy(paths::root() + "/examples/jobs", jobs);
    fs::copy(paths::root() + "/examples/roller.c2s", folder / "roller.c2s");
  }
  Result run(const std::string& command) const {
    return run_shell("cd '" + jobs + "' && PATH='" + fs::path(paths::program()).parent_path().string() + "':$PATH && " +
                     command);
  }
};

// "value,value" of the two numbers of every row.
std::set<std::string> of_sweep(const Place& place) {
  const Result sweep = place.run("contact2d sweep table.csv ../roller.c2s --response 'max tn; contact edge 1 x'");
  REQUIRE_MESSAGE(sweep.status == 0, sweep.err);
  std::set<std::string> all;
  for (const std::string& line : lines_of(sweep.out)) {
    if (line.compare(0, 3, "row") == 0) continue;
    std::istringstream in(line);
    std::string row, mu, load, tn, edge;
    std::getline(in, row, ','), std::getline(in, mu, ','), std::getline(in, load, ','), std::getline(in, tn, ','),
        std::getline(in, edge, ',');
    all.insert(tn + "," + edge);
  }
  REQUIRE(all.size() == 4);
  return all;
}

// The same of files with a line for each number.
std::set<std::string> of_results(const std::vector<std::string>& texts) {
  std::set<std::string> all;
  for (const std::string& text : texts) {
    const std::vector<std::string> lines = lines_of(text);
    REQUIRE(lines.size() == 2);
    all.insert(lines[0].substr(0, lines[0].find(' ')) + "," + lines[1].substr(0, lines[1].find(' ')));
  }
  return all;
}

bool has_engine(const char* command) {
  if (run_shell("PATH=$PATH:/usr/sbin:/sbin command -v " + std::string(command)).status == 0) return true;
  const char* all = std::getenv("C2D_ALL_HOSTS");
  CHECK_MESSAGE((all == nullptr || *all == '\0'), command);
  MESSAGE("skipped: there is no " << std::string(command));
  return false;
}

} // namespace

TEST_CASE("jobs: GNU parallel") {
  if (!has_engine("parallel")) return;
  const Place place;
  const Result run = place.run("sh parallel.sh");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  std::set<std::string> all;
  for (const std::string& line : lines_of(read_file(place.jobs + "/jobs.csv")))
    if (line.compare(0, 3, "ok,") == 0) all.insert(line.substr(line.find(',', line.find(',', 3) + 1) + 1));
  CHECK(all == of_sweep(place));
}

TEST_CASE("jobs: a Slurm array, task by task, does what is missing") {
  const Place place;
  for (const char* i : {"1", "2", "3"})
    REQUIRE(place.run(std::string("SLURM_ARRAY_TASK_ID=") + i + " sh array.sh").status == 0);
  write_file(place.jobs + "/row-1.txt", "kept\n");
  write_file(place.jobs + "/row-2.txt", "FAIL no licence\n");
  for (const char* i : {"1", "2", "3", "4"}) REQUIRE(place.run(std::string("sh array.sh ") + i).status == 0);
  CHECK(read_file(place.jobs + "/row-1.txt") == "kept\n");
  fs::remove(place.jobs + "/row-1.txt");
  REQUIRE(place.run("sh array.sh 1").status == 0);
  std::vector<std::string> texts;
  for (const char* i : {"1", "2", "3", "4"}) texts.push_back(read_file(place.jobs + "/row-" + i + ".txt"));
  CHECK(of_results(texts) == of_sweep(place));
}

TEST_CASE("jobs: a Slurm array, by Slurm on one node; submitted again, it does what is missing") {
  for (const char* each : {"munged", "slurmctld", "slurmd", "sbatch"})
    if (!has_engine(each)) return;
  const Place place;
  write_file(place.jobs + "/row-1.txt", "kept\n");
  write_file(place.jobs + "/row-2.txt", "FAIL no licence\n");
  const Result run =
      place.run("timeout 600 sh '" + paths::root() + "/tests/slurm_node.sh' '" + (place.folder / "node") +
                "' sh -c 'sbatch --wait array.sh && cp row-1.txt first && rm row-1.txt && sbatch --wait array.sh'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  CHECK(read_file(place.jobs + "/first") == "kept\n");
  std::vector<std::string> texts;
  for (const char* i : {"1", "2", "3", "4"}) texts.push_back(read_file(place.jobs + "/row-" + i + ".txt"));
  CHECK(of_results(texts) == of_sweep(place));
}

TEST_CASE("jobs: Snakemake") {
  if (!has_engine("snakemake")) return;
  const Place place;
  const Result run = place.run("HOME='" + place.jobs + "' snakemake --cores 2 --quiet");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  std::vector<std::string> texts;
  for (const auto& entry : fs::directory_iterator(place.jobs))
    if (entry.path().filename().string().compare(0, 2, "mu") == 0 && entry.path().extension() == ".txt") // not their inputs
      texts.push_back(read_file(entry.path().string()));
  CHECK(of_results(texts) == of_sweep(place));
}

TEST_CASE("jobs: a driver for Dakota's fork interface, whose results always exist") {
  const Place place;
  const auto evaluated = [&place](const std::string& params) {
    write_file(place.jobs + "/params.in", params);
    fs::remove(place.jobs + "/results.out");
    REQUIRE(place.run("sh driver.sh params.in results.out").status == 0);
    return read_file(place.jobs + "/results.out");
  };
  std::vector<std::string> texts;
  for (const char* mu : {"1.0e-01", "3.0e-01"})
    for (const char* load : {"50", "100"})
      texts.push_back(evaluated("    2 variables\n    " + std::string(mu) + " mu\n    " + load +
                                " P\n    2 functions\n    1 ASV_1:max_tn\n    1 ASV_2:edge\n    0 derivative_variables\n"));
  CHECK(of_results(texts) == of_sweep(place));
  CHECK(evaluated("    1 variables\n    1 nothing\n").compare(0, 5, "FAIL ") == 0);
  CHECK(evaluated("    1 variables\n    one mu\n").compare(0, 5, "FAIL ") == 0);
}
