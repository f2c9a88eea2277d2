// `contact2d resume` within the path: whatever ends a run, and wherever, the outputs are those of a run that was not cut off,
// and what was done up to the last saved load is not done again.
#include "callable.hpp"
#include "effort.hpp"
#include "faults/preload/control.h"
#include "paths.hpp"
#include "program/files/path_record.hpp"
#include "shell.hpp"
#include "slip_pads.hpp"

#include <c2d_posix.h>
#include <doctest/doctest.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <map>
#include <regex>

using namespace test;

namespace {

// The library that counts a program's operations on files and kills it at one of them.
const std::string& preload() {
  static const Folder folder;
  static const std::string path = folder / "faults.so";
  if (!fs::exists(path)) {
    const std::string command = paths::c_compiler() + " -std=gnu11 -O1 -fPIC -shared -o '" + path + "' '" + paths::root() +
                                "'/tests/faults/preload/*.c -ldl -pthread";
    const Result made = run_shell(command);
    REQUIRE_MESSAGE(made.status == 0, made.err);
  }
  return path;
}

using Files = std::map<std::string, std::string>;

// Without what depends on the clock.
std::string without_times(const std::string& name, const std::string& text) {
  static const std::regex phase("<td>(read|assemble|eliminate|reduce|contact|back substitution|write)</td><td>[^<]*</td>");
  static const std::regex meshes("(\n {4,}\\d+ +\\d+ +\\d+ +\\d+) +[-+.e0-9]+"), rows("<tr><td>\\d+</td>.*");
  std::string out;
  for (const std::string& line : lines_of(text))
    if (!contains(line, "\"seconds\"")) out += line + "\n";
  if (name == "listing") return std::regex_replace(out, meshes, "$1");
  return name == "page" ? std::regex_replace(std::regex_replace(out, phase, ""), rows, "") : out;
}

// Names of files that are not alike.
std::string differing(const Files& a, const Files& b) {
  std::string out;
  for (const auto& file : a)
    if (b.count(file.first) == 0 || b.at(file.first) != file.second) out += " " + file.first;
  for (const auto& file : b)
    if (a.count(file.first) == 0) out += " " + file.first + " (missing)";
  return out;
}

// A run in a folder of its own: its deck, its store, all of its outputs.
class Run {
public:
  Run(const std::string& name, const std::string& deck, const std::string& options) : name_(name) {
    write_file(folder_ / name, deck);
    write_file(folder_ / "points", "1,0.2,-0.5\n2,0.1,1.5\n");
    fs::create_directory(folder_ / "out");
    words_ = "run '" + name + "' --store file:. --no-progress " + options;
    for (const char* output :
         {"listing", "csv", "boundary", "json", "vtk", "trace", "bodies", "summary", "interior", "stresses", "ranges"})
      words_ += std::string(" --") + output + " out/" + output;
    words_ += " --report out/page --figures out/figures --points points";
  }
  // Killed at the n-th operation on a file; 0: never. The exit status, 128 + signal, and what it said.
  Result go(bool resumes, uint64_t n = 0, int kind = FAULT_KILLED) const {
    std::string command = "cd '" + folder_.path() + "' && exec env LD_PRELOAD='" + preload() + "' " + C2D_FAULT_ROOT "='" +
                          folder_.path() + "' " C2D_FAULT_LOG "='" + (logs_ / "log") + "' ";
    command += std::string(C2D_FAULT_KIND) + "=" + std::to_string(n > 0 ? kind : FAULT_NONE) + " " C2D_FAULT_AT "=" +
               std::to_string(n) + " '" + paths::program() + "' " + (resumes ? "resume ." : words_);
    return run_shell("( " + command + " )");
  }
  // Numbers of the operations of the last run on files of the store whose names begin so.
  std::vector<uint64_t> operations(const std::string& name) const {
    const std::string log = read_file(logs_ / "log"), part = "contact2d.store/" + name;
    std::vector<uint64_t> out;
    for (size_t at = 0; at + sizeof(fault_record) <= log.size();) {
      fault_record r;
      std::memcpy(&r, log.data() + at, sizeof r);
      at += sizeof r;
      if (contains(log.substr(at, r.path_bytes), part)) out.push_back(r.number);
      at += r.path_bytes + r.path2_bytes + r.data_bytes;
    }
    return out;
  }
  Files outputs() const {
    Files out;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out"))
      if (entry.is_regular_file()) {
        const std::string name = entry.path().filename().string();
        out[name] = without_times(name, read_file(entry.path().string()));
      }
    return out;
  }
  void forget_outputs() const {
    fs::remove_all(folder_ / "out");
    fs::create_directory(folder_ / "out");
  }
  std::string store(const std::string& name) const { return folder_ / "contact2d.store/" + name; }
  const Folder& folder() const { return folder_; }

private:
  std::string name_, words_;
  Folder folder_, logs_;
};

std::string family(const std::string& words) {
  const Result made = run_shell("'" + paths::program() + "' make " + words);
  REQUIRE_MESSAGE(made.status == 0, made.err);
  return made.out;
}

// Pressed, then pushed to and fro, with three coefficients of friction.
std::string cyclic_deck() {
  std::string deck = family("mindlin n=6 steps=2");
  const size_t at = deck.find("\n1 0.3\n");
  REQUIRE(at != std::string::npos);
  return deck.replace(at, 7, "\n3 0.3 0.2 0.8\n");
}

// A run that nothing ends, and what it leaves.
struct Whole {
  std::string name, deck, options;
  Run run;
  Files outputs;
  Whole(const std::string& name_, const std::string& deck_, const std::string& options_)
      : name(name_), deck(deck_), options(options_), run(name_, deck_, options_ + " --keep") {
    const Result once = run.go(false);
    REQUIRE_MESSAGE(once.status == 0, once.err);
    outputs = run.outputs();
    REQUIRE(outputs.size() > 10);
  }
};

// Kills at some of the operations on files whose names begin so, each with the resume that follows; every third resume is
// killed as well.
void kill_and_resume(const Whole& whole, const std::string& part, size_t kills, const std::string& sign, int least) {
  const std::vector<uint64_t> at = whole.run.operations(part);
  REQUIRE(at.size() > kills);
  int found = 0;
  for (size_t k = 0; k < kills; ++k) {
    const uint64_t n = at[(2 * k + 1) * at.size() / (2 * kills)];
    CAPTURE(n);
    const Run run(whole.name, whole.deck, whole.options);
    CHECK(run.go(false, n).status == 128 + SIGKILL);
    if (k % 3 == 2) run.go(true, n / 3 + 40 * k); // or it comes through, if that is behind its end
    if (!fs::exists(run.store("job"))) continue;
    const Result resumed = run.go(true);
    CHECK_MESSAGE(resumed.status == 0, resumed.err);
    CHECK(differing(run.outputs(), whole.outputs) == "");
    CHECK_FALSE(fs::exists(run.folder() / "contact2d.store"));
    found += contains(resumed.err, sign);
  }
  MESSAGE(whole.name << ": of " << kills << " kills " << found << " with '" << sign << "'");
  CHECK(found >= least);
}

const char kInPath[] = "continues after step";

} // namespace

TEST_CASE("resume in the path: killed at any operation, with several coefficients and a cyclic history") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const Whole whole("deck.dat", cyclic_deck(), "--save-every 0");
  kill_and_resume(whole, "path", effort<size_t>(1, 4), kInPath, effort(1, 2));
  kill_and_resume(whole, "tape0", effort<size_t>(1, 4), kInPath, effort(1, 2));
}

TEST_CASE("resume in the path: with the increments of the deck, and little memory") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const Whole whole("deck.dat", cyclic_deck(), "--save-every 0 --stepping deck --memory 180K");
  kill_and_resume(whole, "path", effort<size_t>(1, 3), kInPath, 1);
}

TEST_CASE("resume in the path: with a tie, and two coefficients of friction") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  std::string deck = family("coating n=3 L=8 ratio=2");
  const auto replace = [&deck](const std::string& what, const std::string& by) {
    const size_t at = deck.find(what);
    REQUIRE(at != std::string::npos);
    deck.replace(at, what.size(), by);
  };
  replace("\n1 0\n", "\n2 0.1 0.4\n");
  replace("\n1 50\n1 1\n", "\n2 50\n2 1\n2 0.4\n");
  REQUIRE(contains(deck, "*TIE 2"));
  const Whole whole("deck.dat", deck, "--save-every 0");
  kill_and_resume(whole, "path", 2, kInPath, 1);
}

TEST_CASE("resume in the path: with gaps that follow slip") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const Folder folder;
  write_file(folder / "pads.c2s", slip_pads() + "history normal 1; shift 1, -1\nsteps 3\ntolerance 9 %\n");
  const Result mesh = run_shell("'" + paths::program() + "' mesh '" + (folder / "pads.c2s") + "' mu=0.3 d=0.4");
  REQUIRE_MESSAGE(mesh.status == 0, mesh.err);
  const Whole whole("deck.dat", mesh.out, "--save-every 0");
  kill_and_resume(whole, "path", 1, kInPath, 1);
}

TEST_CASE("resume in the path: SIGTERM saves first, exit status 143") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const std::string deck = cyclic_deck();
  const Whole whole("deck.dat", deck, "--save-every 1000");
  const std::vector<uint64_t> prepared = whole.run.operations("tape0"); // of the path there is nothing saved
  REQUIRE(prepared.size() > 4);
  const auto ended = [&](uint64_t n) {
    const Run run("deck.dat", deck, "--save-every 1000");
    const Result result = run.go(false, n, FAULT_STOPPED);
    CHECK(result.status == 143);
    CHECK(run.outputs().empty());
    CHECK(contains(result.err, "note: stopped; "));
    CHECK(contains(result.err, "contact2d resume . continues"));
    const Result resumed = run.go(true);
    CHECK_MESSAGE(resumed.status == 0, resumed.err);
    CHECK(differing(run.outputs(), whole.outputs) == "");
    return std::make_pair(result, resumed);
  };
  CHECK_FALSE(contains(ended(whole.run.operations("job").back() + 1).second.err, kInPath)); // before the path began
  CHECK_FALSE(contains(ended(prepared[prepared.size() / 4]).second.err, kInPath));
  // At operations of the path itself, which only states that are saved make there: the first of the path's own.
  const Whole saving("deck.dat", deck, "--save-every 0");
  const std::vector<uint64_t> in_path = saving.run.operations("path");
  for (const size_t k : {in_path.size() / 2, size_t{0}, in_path.size() - 1}) {
    if (k != in_path.size() / 2 && !in_full()) break;
    const Run run("deck.dat", deck, "--save-every 0");
    const Result told = run.go(false, in_path[k], FAULT_STOPPED);
    CHECK(told.status == 143);
    CHECK(contains(told.err, "note: stopped; the state of step "));
    const Result on = run.go(true);
    CHECK((on.status == 0 && contains(on.err, kInPath)));
    CHECK(differing(run.outputs(), whole.outputs) == "");
  }
  // Nothing is kept: a cancel.
  const Folder folder;
  write_file(folder / "d", deck);
  const Result alone = run_shell("cd '" + folder.path() + "' && exec env LD_PRELOAD='" + preload() + "' C2D_FAULT_ROOT='" +
                                 folder.path() + "' " C2D_FAULT_KIND "=" + std::to_string(FAULT_STOPPED) +
                                 " " C2D_FAULT_AT "=2 '" + paths::program() + "' run d --csv c");
  CHECK((alone.status == 130 && contains(alone.err, "cancelled") && !fs::exists(folder / "c")));
}

TEST_CASE("resume in the path: states that are damaged, of another run or gone are told, and the numbers are the same") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const Whole whole("deck.dat", cyclic_deck(), "--save-every 0");
  const Run& run = whole.run; // kept: it can be resumed again and again
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(run.store("")))
    files[entry.path().filename().string()] = read_file(entry.path().string());
  REQUIRE(files.size() > 6);
  const auto resumed = [&](const std::string& file, const std::string& bytes, bool is_told) {
    for (const auto& [name, text] : files) write_file(run.store(name), name == file ? bytes : text);
    run.forget_outputs();
    const Result result = run.go(true);
    CHECK_MESSAGE(result.status == 0, result.err);
    CHECK(differing(run.outputs(), whole.outputs) == "");
    if (is_told) CHECK_MESSAGE(contains(result.err, "restarts from the beginning"), result.err);
    return result;
  };
  CHECK(contains(resumed("", "", false).err, kInPath));
  std::vector<std::string> latest; // the file of the last step, which the state on tape 0 needs
  for (const char* name : {"path0", "path1"})
    if (contains(resumed(name, "", false).err, "restarts from the beginning")) latest.push_back(name);
  REQUIRE(latest.size() == 1);
  const std::string& path = files.at(latest[0]);
  for (size_t k = 0; k < effort<size_t>(1, 4); ++k) {
    std::string bytes = path;
    const size_t at = k * (bytes.size() - 1) / 3;
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << k));
    CHECK(contains(resumed(latest[0], bytes, true).err, "damaged"));
  }
  resumed(latest[0], path.substr(0, path.size() / 2), true);
  for (const size_t part : {size_t{5}, size_t{2}}) { // of tape 0: the older state, or none
    if (part == 5 && !in_full()) continue;
    std::string bytes = files.at("tape0.c2d");
    for (size_t i = bytes.size() / part; i < bytes.size(); i += 97) bytes[i] = static_cast<char>(bytes[i] ^ 1);
    resumed("tape0.c2d", bytes, false);
  }
  // Of another run in the same folder.
  const Whole other("deck.dat", family("mindlin n=6 steps=2"), "--save-every 0");
  CHECK(contains(resumed(latest[0], read_file(other.run.store(latest[0])), true).err, "is missing"));
}

TEST_CASE("resume in the path: a sketch's loop over meshes takes up the meshes that were solved") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const std::string sketch = read_file(paths::root() + "/examples/fretting_pad.c2s");
  const std::string options = "--save-every 0 q=10 --set p=150";
  const std::string loose = std::regex_replace(sketch, std::regex("want  .*"), "want       pressure 20 %");
  const Whole whole("pad.c2s", loose, options);
  const std::vector<uint64_t> at = whole.run.operations("mesh");
  REQUIRE(at.size() > 8);
  for (const size_t k : {at.size() / 2, at.size() - 5}) {
    const Run run("pad.c2s", loose, options);
    CHECK(run.go(false, at[k]).status == 128 + SIGKILL);
    REQUIRE(fs::exists(run.store("job")));
    const bool has_mesh = fs::exists(run.store("mesh1"));
    const auto when = has_mesh ? fs::last_write_time(run.store("mesh1")) : fs::file_time_type();
    if (k == at.size() / 2) {
      CHECK(run.go(true, at.back() / 2).status == 128 + SIGKILL);
      if (has_mesh && fs::exists(run.store("mesh1"))) CHECK(fs::last_write_time(run.store("mesh1")) == when);
    }
    const Result resumed = run.go(true);
    CHECK_MESSAGE(resumed.status == 0, resumed.err);
    CHECK(differing(run.outputs(), whole.outputs) == "");
    CHECK_FALSE(fs::exists(run.folder() / "contact2d.store"));
  }
}

TEST_CASE("resume in the path: a folder that is in use, exit status 75") {
  if (paths::sanitized()) return; // whose run-time must be loaded first
  const Whole whole("deck.dat", family("hertz n=2 L=5 ratio=1.6"), "");
  c2d_posix_store other;
  REQUIRE(c2d_posix_store_init(&other, whole.run.folder().path().c_str()) == 0);
  for (const bool resumes : {false, true}) {
    const Result busy = whole.run.go(resumes);
    CHECK(busy.status == 75);
    CHECK(contains(busy.err, "in use by another process"));
  }
  c2d_posix_store_done(&other);
  CHECK(whole.run.go(true).status == 0);
}

TEST_CASE("resume in the path: how often states are saved is asked for with a number") {
  const auto refused = [](const std::string& words) { return run_shell("'" + paths::program() + "' run d " + words); };
  for (const char* wrong : {"-1", "x", "2x", "nan", "1e99", "inf"}) {
    const Result result = refused(std::string("--store file:. --save-every=") + wrong);
    CHECK((result.status == 64 && contains(result.err, "expected a number of seconds, 0 or more")));
  }
  const Result nowhere = refused("--save-every 3");
  CHECK((nowhere.status == 64 && contains(nowhere.err, "expected --store file:DIR")));
}

TEST_CASE("resume in the path: what the steps have left, as a text and back") {
  app::PathRecord record;
  record.coefficients.resize(2);
  app::CoefficientRecord& c = record.coefficients[0];
  c.mu = 0.1, c.loads = {1.0 / 3}, c.table.assign(2 * C2D_PAIR_FIELDS, -2.0 / 3), c.slip = {1, 2}, c.why = "a\nb";
  c.steps.resize(1);
  app::StepRecord& s = c.steps[0];
  s.loads = s.work_by_case = {HUGE_VAL};
  s.zones.push_back(C2D_INIT(c2d_zone_state));
  s.bodies.assign(2, C2D_INIT(c2d_body_state));
  s.corners.resize(1);
  s.corners[0].joint = "slip", s.corners[0].exponents = {{0.5, 0.09}};
  s.cracks.resize(1), s.quantities.resize(1);
  record.warnings.push_back(C2D_INIT(c2d_error));
  std::snprintf(record.warnings[0].text, sizeof record.warnings[0].text, "coarse");
  record.latest = "late", record.coefficient_shown = 1, record.outputs[1] = "x,y\n";
  const std::string text = app::text_of(record);
  app::Summary model;
  model.pairs = 2, model.zones = 1, model.bodies = 2, model.load_cases = 1;
  app::PathRecord back;
  REQUIRE(app::read_path_record(text, model, back));
  CHECK(app::text_of(back) == text);
  REQUIRE((back.coefficients.size() == 2 && back.coefficients[0].steps.size() == 1 && back.warnings.size() == 1));
  CHECK((back.coefficients[0].loads[0] == 1.0 / 3 && std::string(back.coefficients[0].steps[0].corners[0].joint) == "slip"));
  CHECK((std::string(back.warnings[0].text) == "coarse" && back.outputs[1] == "x,y\n" && back.latest == "late"));
  for (size_t length = 0; length < text.size(); length += 7) {
    app::PathRecord part;
    CHECK_FALSE(app::read_path_record(text.substr(0, length), model, part));
  }
  const auto fits = [&](int32_t pairs, int32_t zones, int32_t bodies, int32_t cases) {
    app::PathRecord other;
    model.pairs = pairs, model.zones = zones, model.bodies = bodies, model.load_cases = cases;
    return app::read_path_record(text, model, other);
  };
  CHECK((fits(2, 1, 2, 1) && !fits(3, 1, 2, 1) && !fits(2, 2, 2, 1) && !fits(2, 1, 3, 1) && !fits(2, 1, 2, 2)));
  // Each of its lists has the size of the model, or is empty.
  model.pairs = 2, model.zones = 1, model.bodies = 2, model.load_cases = 1;
  c2d_step step = C2D_INIT(c2d_step);
  const std::vector<double> table(2 * C2D_PAIR_FIELDS, 0.5);
  const double load = 1;
  step.kind = C2D_STEP_RECORDED, step.coefficient = 1, step.step = 1, step.pairs = 2, step.table = table.data();
  step.loads = &load, step.cases = 1, step.load = 1, step.stride = C2D_PAIR_FIELDS;
  const auto spoilt = [&](const test::Callable<void(app::PathRecord&)>& spoil) {
    app::PathRecord one, other;
    REQUIRE(app::read_path_record(text, model, one));
    spoil(one);
    return !app::read_path_record(app::text_of(one), model, other);
  };
  CHECK_FALSE(spoilt([](app::PathRecord&) {}));
  CHECK_FALSE(spoilt([](app::PathRecord& p) { p.coefficients[0].steps[0].corners[0].joint = "nobody knows"; }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].steps[0].loads.clear(); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].steps[0].work_by_case.clear(); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].steps[0].zones.resize(3); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].steps[0].bodies.resize(3); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].table.resize(3); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].slip.resize(3); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].slip_at_turn.resize(3); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].loads.resize(3); }));
  CHECK(spoilt([](app::PathRecord& p) { p.coefficients[0].table.resize(3), p.coefficients[1].table.resize(4); }));
  // Likewise of the states that pictures show: of a model with one pair or two load cases more.
  const auto drawn = [&](int32_t pairs, int32_t cases, int32_t steps, bool back_and_forth) {
    app::PathRecord one, other;
    one.history.begin(steps);
    const std::vector<double> large(static_cast<size_t>(pairs) * C2D_PAIR_FIELDS, 0.5);
    for (int32_t k = 1; k <= steps; ++k) {
      const std::vector<double> loads(static_cast<size_t>(cases), back_and_forth && k % 2 == 0 ? 0.25 : 0.1 * k);
      step.step = k, step.pairs = pairs, step.table = large.data(), step.loads = loads.data(), step.cases = cases;
      step.work_by_case = loads.data();
      step.load = loads[0];
      one.history.note(step);
    }
    return app::read_path_record(app::text_of(one), model, other);
  };
  for (const bool turns : {false, true})
    for (const int32_t steps : {1, 2, 8}) {
      CHECK(drawn(2, 1, steps, turns));
      CHECK_FALSE(drawn(3, 1, steps, turns));
      CHECK_FALSE(drawn(2, 3, steps, turns));
    }
}
