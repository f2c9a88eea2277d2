// The program with a sample of everything that can go wrong around it (tests/faults; the whole is `make faults`): operations
// that fail, lie, are cut off or killed, power that is lost, memory that is refused.
#include "faults/campaign.hpp"
#include "faults/disk.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

using namespace faults;

namespace {

// The jobs, in a folder of their own, each gone through once.
struct Workplace {
  test::Folder folder;
  Place place;
  std::vector<Job> jobs;
  Workplace() {
    const std::string sources = paths::root() + "/tests/faults/preload/";
    place.program = paths::program(), place.library = folder / "faults.so", place.base = folder / "base";
    test::fs::create_directories(place.base);
    const test::Result built =
        test::run_shell("cc -std=gnu11 -O1 -fPIC -shared -o '" + place.library + "' '" + sources + "'*.c -ldl -pthread");
    REQUIRE_MESSAGE(built.status == 0, built.err);
    std::string error;
    jobs = make_jobs(place, error);
    REQUIRE(error == "");
  }
  const Job& job(const std::string& name) const {
    const auto found = std::find_if(jobs.begin(), jobs.end(), [&name](const Job& j) { return j.name == name; });
    REQUIRE(found != jobs.end());
    return *found;
  }
};

const Workplace& workplace() {
  static const Workplace only;
  return only;
}

// The preloaded library takes the place of functions of glibc; a sanitizer does that itself.
bool can_preload() {
#if defined(__GLIBC__) && defined(__linux__)
  if (!paths::sanitized()) return true;
#endif
  MESSAGE("not run: functions of the C library cannot be replaced here");
  return false;
}

void nothing_found(const Tally& tally) {
  for (const auto& [what, count] : tally.how_often)
    FAIL_CHECK(count << " times: " << what << " (" << tally.example.at(what) << ")");
  CHECK(tally.faults == 0);
}

// The last operation of a kind on a path that contains `part`.
const Record& last_of(const Job& job, int op, const std::string& part) {
  const std::vector<Record>& all = job.ended.journal;
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const Record& r) {
    return r.op == op && (r.path.find(part) != std::string::npos || r.path2.find(part) != std::string::npos);
  });
  REQUIRE(found != all.rend());
  return *found;
}

} // namespace

TEST_CASE("faults: a sample of all: operations, lies, kills, power, memory") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  struct Part {
    const char* name;
    void (*go)(const Place&, const Job&, uint64_t, Tally&);
    uint64_t step, least;
  };
  const Part parts[] = {{"operations", fail_operations, 797, 30},
                        {"lies", lie, 797, 10},
                        {"kills", kill_at_operations, 797, 10},
                        {"power", lose_power, 397, 30},
                        {"memory", refuse_memory, 797, 20}};
  for (const Part& part : parts) {
    Tally tally;
    for (const Job& job : w.jobs) part.go(w.place, job, part.step, tally);
    INFO(std::string(part.name), ", ", tally.cases, " cases");
    CHECK(tally.cases >= part.least);
    nothing_found(tally);
  }
}

namespace {

// What is done to which file: numbers in names and letters of chance do not count.
std::string place_of(const Record& r, int kind, bool ever) {
  std::string name = r.path + ">" + r.path2;
  const size_t temporary = name.find("/contact2d-");
  if (temporary != std::string::npos) name.erase(temporary + 11, 6);
  for (char& c : name)
    if (c >= '0' && c <= '9') c = '#';
  return std::to_string(r.op) + " " + std::to_string(kind) + (ever ? " ever " : " once ") + std::to_string(r.flags) + " " +
         name;
}

} // namespace

TEST_CASE("faults: every place at which a job asks the system for something fails") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  std::vector<std::string> seen;
  Tally tally;
  for (const Job& job : w.jobs) {
    Judge judge(w.place, tally);
    for (const int kind : {FAULT_FAIL, FAULT_SHORT, FAULT_INTERRUPTED, FAULT_FULL})
      for (const Record& r : job.ended.journal) {
        if (!can_strike(r, kind, false)) continue;
        const std::string place = place_of(r, kind, false);
        if (std::find(seen.begin(), seen.end(), place) != seen.end()) continue;
        seen.push_back(place);
        judge.strike(job, {kind, r.number, false, ""});
      }
  }
  CHECK(tally.cases > 200);
  nothing_found(tally);
}

// A read of the store under an output, half of the store's mark on a disk that says it is whole, names that cannot be synced.
TEST_CASE("faults: a store that fails where outputs are written, where it begins and where it ends") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  const Job &outputs = w.job("store and outputs"), &store = w.job("store"), &temporary = w.job("temporary");
  Tally tally;
  int reads = 0;
  for (const Record& r : outputs.ended.journal)
    if (r.op == OP_READ && r.path.find("tape2") != std::string::npos && reads++ % 5 == 0)
      Judge(w.place, tally).strike(outputs, {FAULT_FAIL, r.number, false, ""});
  Judge(w.place, tally).strike(store, {FAULT_HALF, last_of(store, OP_WRITE, "/lock").number, true, "/tapes/"});
  Judge(w.place, tally).strike(temporary, {FAULT_FAIL, last_of(temporary, OP_SYNC, "contact2d.store").number, false, ""});
  CHECK(tally.cases > 5);
  nothing_found(tally);
}

TEST_CASE("faults: the last of what a run does has no memory") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  for (const char* name : {"standard input", "temporary"}) {
    const Job& job = w.job(name);
    Tally tally;
    Judge judge(w.place, tally);
    REQUIRE(job.ended.allocations > 100);
    for (uint64_t last = 0; last < 60; last += 3)
      judge.strike(job, {FAULT_MEMORY, job.ended.allocations - last, last % 2 != 0, ""});
    nothing_found(tally);
  }
}

TEST_CASE("faults: where memory is short tapes lie under TMPDIR, moved by begun transfers and threads, with the same numbers") {
  if (!can_preload()) return;
  const std::string library = workplace().place.library, deck = paths::data() + "/decks/hertz_lin_l.dat";
  const test::Folder folder;
  const std::string tmp = folder / "tmp";
  test::fs::create_directory(tmp);
  const auto run = [&](const std::string& surroundings, const std::string& words) {
    return test::run_shell(surroundings + "'" + paths::program() + "' run '" + deck + "' --no-progress --listing /dev/null " +
                           words);
  };
  const std::string is_short = "LD_PRELOAD='" + library + "' C2D_FAULT_FREE=100000 C2D_FAULT_THREADS=1 ";
  REQUIRE(run("", "--csv '" + (folder / "in_memory.csv") + "'").status == 0);
  for (const char* threads : {"1", "3"}) {
    CAPTURE(threads);
    const test::Result ended = run(is_short + "TMPDIR='" + tmp + "' ",
                                   "--memory 1M --threads " + std::string(threads) + " --csv '" + (folder / "a.csv") + "'");
    CHECK(ended.status == 0);
    CHECK(test::read_file(folder / "a.csv") == test::read_file(folder / "in_memory.csv"));
    CHECK(test::fs::is_empty(tmp));
  }
  // Asked to keep what nobody named, it tells where it is.
  const test::Result kept = run(is_short + "TMPDIR='" + tmp + "' ", "--memory 1M --keep");
  CHECK(kept.status == 0);
  CHECK(test::contains(kept.err, "tapes are kept in " + tmp + "/contact2d-"));
  CHECK_FALSE(test::fs::is_empty(tmp));
  const test::Result none = run(is_short + "TMPDIR='" + (folder / "none") + "' ", "--memory 1M");
  CHECK(none.status == 3);
  CHECK(test::contains(none.err, folder / "none"));
  const test::Result anyhow = run(is_short + "TMPDIR='" + (folder / "none") + "' ", "--memory 1M --store memory");
  CHECK(anyhow.status == 0); // asked for, whatever is said to be free
}

namespace {

// Power lost after each operation from the first that gives an output its name; once more only where that leaves another state.
void lose_power_at_the_end(const Place& place, const Job& job, const std::vector<Record>& journal, Tally& tally) {
  Judge judge(place, tally);
  Disk disk(job.start);
  std::vector<size_t> seen;
  bool begun = false;
  for (const Record& r : journal) {
    begun = begun || (r.op == OP_RENAME && r.path2.compare(0, 4, "out/") == 0);
    const bool done = &r == &journal.back();
    if ((!disk.apply(r) && !done) || !begun) continue;
    for (const Loss loss : {Loss::kAllUnsynced, Loss::kData, Loss::kEarlyNames, Loss::kNewestEmpty, Loss::kRandom}) {
      const Tree left = disk.after_crash(loss, static_cast<uint32_t>(r.number));
      const size_t hash = hash_of(left) + done;
      if (std::find(seen.begin(), seen.end(), hash) != seen.end()) continue;
      seen.push_back(hash);
      judge.crash(job, left, done, "power", "power lost after " + std::to_string(r.number) + " " + r.path);
    }
  }
  CHECK(!disk.is_wrong());
}

} // namespace

TEST_CASE("faults: outputs are safe under their names before the tapes go, wherever power is lost") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  for (const char* name : {"store", "resume what was killed"}) {
    const Job& job = w.job(name);
    Tally tally;
    lose_power_at_the_end(w.place, job, job.ended.journal, tally);
    CHECK(tally.cases > 20);
    nothing_found(tally);
    // Of a program that makes nothing safe the same judge finds that.
    std::vector<Record> careless = job.ended.journal;
    careless.erase(std::remove_if(careless.begin(), careless.end(), [](const Record& r) { return r.op == OP_SYNC; }),
                   careless.end());
    Tally found;
    lose_power_at_the_end(w.place, job, careless, found);
    CHECK(found.faults > 0);
  }
}

TEST_CASE("faults: a run that begins anew removes nothing before what takes its place is there") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  for (const char* name : {"standard input", "again"}) {
    const Job& job = w.job(name);
    Tally tally;
    Judge judge(w.place, tally);
    for (const Record& r : job.ended.journal) {
      if (r.op != OP_RENAME && r.op != OP_UNLINK && r.op != OP_RMDIR && r.op != OP_TRUNCATE) continue;
      put_tree(w.place.work(), job.start);
      CHECK(run(w.place, job.command, {FAULT_KILLED, r.number, false, ""}).status == 128 + 9);
      judge.crash(job, take_tree(w.place.work()), false, "killed", "killed at " + std::to_string(r.number) + " " + r.path);
    }
    CHECK(tally.cases > 3);
    nothing_found(tally);
  }
}

TEST_CASE("faults: the judge finds outputs that are wrong, missing or left aside") {
  if (!can_preload()) return;
  const Workplace& w = workplace();
  const Job& job = w.job("outputs");
  struct {
    int kind;
    const char* finding;
  } const lies[] = {{FAULT_FLIPPED, "is neither what it was"},
                    {FAULT_HALF, "is neither what it was"},
                    {FAULT_LOST, "is neither what it was"}};
  // The program cannot know what becomes of its outputs afterwards: here the disk lies, and the judge has to see it.
  const std::string csv = last_of(job, OP_RENAME, "out/a.csv").path; // as it is called before it has its name
  const auto written = std::find_if(job.ended.journal.begin(), job.ended.journal.end(),
                                    [&csv](const Record& r) { return r.op == OP_WRITE && r.path == csv; });
  REQUIRE(written != job.ended.journal.end());
  for (const auto& l : lies) {
    Tally tally;
    Judge(w.place, tally).strike(job, {l.kind, written->number, false, ""});
    REQUIRE(tally.how_often.size() > 0);
    CHECK(test::contains(tally.how_often.begin()->first, l.finding));
  }
  Tally tally;
  Judge judge(w.place, tally);
  Tree left = job.finish;
  left.erase("out/a.csv");
  judge.crash(job, left, true, "", "");
  left = job.finish;
  left["out/of others"].bytes += "!";
  judge.crash(job, left, true, "", "");
  left = job.start;
  left["out/new"] = {'f', "?"};
  judge.crash(job, left, false, "", "");
  CHECK(tally.faults == 3);
}
