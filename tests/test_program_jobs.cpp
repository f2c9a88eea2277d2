// Kept jobs, sketches whose search for a mesh is kept, and signals, in this process: calls of the library and of the system
// fail, files are replaced, and a child is told to stop at one call after the other.
#include "paths.hpp"
#include "program_options.hpp"
#include "refused_calls.hpp"
#include "shell.hpp"
#include "system_calls.hpp"

#include "effort.hpp"
#include "program/commands/drawn_deck.hpp"
#include "program/commands/job.hpp"
#include "program/exit_code.hpp"
#include "program/files/sealed_file.hpp"
#include "program/files/store_choice.hpp"
#include "program/files/system_file.hpp"
#include "program/interrupt.hpp"
#include "program/run.hpp"
#include "program/sweep/sweep.hpp"
#include "program/words/voice.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <doctest/doctest.h>

extern "C" int __llvm_profile_write_file(void) __attribute__((weak)); // where branches are counted

using namespace test;

namespace {

using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Ran {
  int exit;
  std::string reason;
};
Ran run(const app::Options& options) {
  const app::Muted muted;
  app::forget_reason();
  const int exit = app::run_deck(options);
  return {exit, app::reason_told()};
}
Ran run(const Words& words) { return run(options_of(Words{"run"} + words + Words{"-q", "--no-progress"})); }

// What `contact2d resume` does.
Ran resume(const std::string& folder) {
  app::Options options;
  options.folder = folder;
  options.quiet = true;
  options.progress = app::Progress::kNever;
  std::string error;
  if (const int exit = app::find_job(options, error); exit != 0) return {exit, error};
  options.quiet = true;
  return run(options);
}

const std::string& sample() {
  static const std::string name = paths::data() + "/decks/sample.dat";
  return name;
}

// A square that is pulled, its upper side through the points of a file; on a mesh for which nothing much is asked.
const char kPulled[] =
    "body b E 1000 nu 0.3\nfrom 0 0\nline s to 1 0\nline e to 1 1\nspline n file p.csv\nline w close\nfix b.s\n"
    "traction b.e x 1\nwant stress b 0.5 0.5 40 %\n";
const char kPoints[] = "1 1\n0.5 1.1\n0 1\n";
// Two blocks in contact.
const char kPressed[] = "body b E 1000 nu 0.3\nfrom -2 -2\nline s to 2 -2\nline to 2 0\nline n to -2 0\nline close\n"
                        "body d E 1000 nu 0.3\nfrom -1 0\nline f to 1 0\nline to 1 1\nline n to -1 1\nline close\n"
                        "contact b.n d.f mu 0.3\nfix b.s\nplaten d.n about 0 1 fy -1 x 0 turn 0\nsteps 1\n";

struct Drawn { // a folder with a sketch
  Folder folder;
  std::string sketch = folder / "s.c2s";
  explicit Drawn(const std::string& text = kPulled) {
    write_file(sketch, text);
    write_file(folder / "p.csv", kPoints);
  }
};

int taken(const std::string& text, const Words& settings, std::string& reason,
          const std::vector<app::NamedText>* files = nullptr, const std::string& name = "s.c2s") {
  const app::Muted muted;
  app::DeckFile deck;
  deck.call(name);
  deck.replace(text);
  app::MeshLoop loop;
  app::Drawing drawing{settings};
  drawing.files = files;
  app::forget_reason();
  const int exit = app::take_sketch(deck, drawing, loop);
  reason = app::reason_told();
  return exit;
}

} // namespace

TEST_CASE("drawn decks: settings and files that are wrong, told in a word") {
  std::string reason;
  const std::string square =
      "parameter mu 1\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline to 1 1\nline to 0 mu\nline close\nfix b.s\n"
      "tolerance off\n";
  for (const char* wrong : {"mu", "=3", "mu=", "mu=1e999", "mu=1x"}) {
    CAPTURE(wrong);
    CHECK(taken(square, {wrong}, reason) == app::kExitUsage);
    CHECK(reason == std::string(wrong) + ": expected the name of a parameter, = and a number");
  }
  CHECK(taken(square, {"mu=2"}, reason) == 0);
  CHECK(taken("*FREE\n1\n{a}\n", {"a"}, reason, nullptr, "deck") == app::kExitUsage);
  CHECK(reason == "a: expected the name of a parameter, = and a value without blanks");
  CHECK(taken("*FREE\n1\n{a}\n", {"a=1"}, reason, nullptr, "deck") == 0);
  // Files are seen from the sketch, unless their names lead there from everywhere; or they are given.
  const Drawn drawn;
  const auto with_file = [](const std::string& name) {
    std::string text = kPulled;
    return text.replace(text.find("p.csv"), 5, name) + "tolerance off\n";
  };
  CHECK(taken(with_file("p.csv"), {}, reason, nullptr, drawn.sketch) == 0);
  CHECK(taken(with_file(drawn.folder / "p.csv"), {}, reason, nullptr, "s.c2s") == 0);
  for (const std::string& name : {std::string("none.csv"), drawn.folder / "none.csv", std::string("\"\"")}) {
    CHECK(taken(with_file(name), {}, reason, nullptr, drawn.sketch) == app::kExitInput);
    CHECK_MESSAGE(contains(reason, "cannot be read"), reason);
  }
  const std::vector<app::NamedText> files = {{"there/other", ""}, {"there/p.csv", kPoints}};
  CHECK(taken(with_file("p.csv"), {}, reason, &files, "there/s.c2s") == 0);
  CHECK(taken(with_file("p.csv"), {}, reason, &files, "s.c2s") == app::kExitInput);
  CHECK(contains(reason, "the file 'p.csv' cannot be read"));
}

TEST_CASE("drawn decks: meshes are told as they are solved, and numbers without errors") {
  const Drawn drawn(std::string(kPressed) + "want forces 50 %\n");
  const std::string program = "cd '" + drawn.folder.path() + "' && '" + paths::program() + "' ";
  const Result shown = run_shell(program + "run s.c2s --progress --csv c");
  CHECK_MESSAGE(shown.status == 0, shown.err);
  CHECK(contains(shown.err, "contact2d: mesh 1: "));
  CHECK(contains(shown.err, ", tractions changed by "));
  write_file(drawn.sketch, std::string(kPressed) + "want pressure 1 %\nlimit elements 60\n");
  const Result limited = run_shell(program + "run s.c2s --no-progress --csv c");
  CHECK_MESSAGE(limited.status == 5, limited.err);
  CHECK_MESSAGE(contains(limited.err, "note: "), limited.err);
  for (const char* limit : {"20", "40", "60", "90", "130", "200", "300"}) { // wherever it comes, the mesh before it is taken
    write_file(drawn.sketch, std::string(kPressed) + "want pressure 0.1 %\nlimit elements " + limit + "\n");
    CHECK(run({drawn.sketch, "--csv", drawn.folder / "c"}).exit == 5);
    CHECK_FALSE(read_file(drawn.folder / "c").empty());
  }
  write_file(drawn.sketch, std::string(kPulled) + "tolerance 0.01 %\nlimit elements 200\n");
  const Result of_body = run_shell(program + "run s.c2s --no-progress --csv c --estimate");
  CHECK_MESSAGE(of_body.status == 0, of_body.err);
}

TEST_CASE("jobs: the words of a run, and what stands elsewhere or is of the moment") {
  const app::Options all = options_of({"run",
                                       "d",
                                       "--stepping",
                                       "deck",
                                       "--quadrature",
                                       "thesis",
                                       "--symmetry",
                                       "images",
                                       "--elimination",
                                       "dense",
                                       "--threads",
                                       "2",
                                       "--response",
                                       "load",
                                       "--results",
                                       "/r",
                                       "--save-every",
                                       "0",
                                       "--store",
                                       "file:x",
                                       "--memory",
                                       "1M",
                                       "--no-progress",
                                       "--points",
                                       "p",
                                       "--set",
                                       "a=1",
                                       "--params",
                                       "q",
                                       "--listing",
                                       "-",
                                       "--csv",
                                       "/a/b.csv",
                                       "--keep",
                                       "-q"});
  CHECK(app::words_of(all) == Words{"--stepping=deck", "--quadrature=thesis", "--symmetry=images", "--elimination=dense",
                                    "--threads=2", "--response=load", "--results=/r", "--save-every=0", "--listing=-",
                                    "--csv=/a/b.csv", "--keep", "--quiet"});
  CHECK(app::words_of(options_of({"run", "d", "--progress", "--csv", "/c"})) == Words{"--csv=/c"});
  const fs::path here = fs::current_path();
  std::string name;
  {
    const Folder gone;
    name = gone / "below";
    fs::create_directory(name);
    fs::current_path(name);
    fs::remove(name);
    CHECK(app::words_of(options_of({"run", "d", "--csv", "c"})) == Words{"--csv=c"}); // nobody knows where that is
    fs::current_path(here);
  }
}

TEST_CASE("jobs: those of other versions, that are damaged within, or that another run has replaced") {
  const Folder folder;
  const std::string store = folder / "contact2d.store";
  fs::create_directory(store);
  std::string error;
  REQUIRE(app::write_sealed(store + "/job", "contact2d job 5", "junk", error));
  CHECK(resume(folder.path()).exit == 3);
  CHECK(resume(folder.path()).reason == store + "/job: has another version");
  app::Job job;
  job.deck_name = "deck", job.deck = read_file(sample());
  job.meshes.rounds.resize(1), job.meshes.taken = 5; // a round that is none
  REQUIRE(app::keep_job(store, job, error));
  CHECK(resume(folder.path()).exit == 3);
  CHECK(app::is_kept(store, job));
  app::Job other = job;
  other.deck += "\n";
  CHECK_FALSE(app::is_kept(store, other));
  CHECK_FALSE(app::is_kept(folder / "none", job));
  // Of a sketch that is none, and of points that are none.
  fs::remove_all(store);
  const auto kept = [&](app::JobForm form, const std::string& text, bool points) {
    const Folder one;
    fs::create_directory(one / "contact2d.store");
    app::Job made;
    made.form = form, made.deck_name = "s.c2s", made.deck = text, made.has_points = points, made.points = "1,x,0\n";
    REQUIRE(app::keep_job(one / "contact2d.store", made, error));
    return resume(one.path());
  };
  const Ran sketch = kept(app::JobForm::kSketch, "body b E 1 nu 0\n", false);
  CHECK(sketch.exit == 2);
  CHECK(sketch.reason == "body 'b' has no outline, expected curves after its statement");
  const Ran points = kept(app::JobForm::kDeck, read_file(sample()), true);
  CHECK(points.exit == 2);
  CHECK(contains(points.reason, "x is 'x', expected a number"));
  // One that is replaced between being found and going on.
  const Folder two;
  const std::string tapes = two / "t";
  REQUIRE(run({sample(), "--store", "file:" + tapes, "--keep", "--csv", two / "c"}).exit == 0);
  app::Options options;
  options.folder = tapes;
  REQUIRE(app::find_job(options, error) == 0);
  other.meshes = app::MeshLoop();
  REQUIRE(app::keep_job(tapes + "/contact2d.store", other, error));
  options.quiet = true;
  const Ran replaced = run(options);
  CHECK(replaced.exit == 3);
  CHECK(replaced.reason == tapes + ": another process has finished or replaced this run");
}

TEST_CASE("jobs: what the steps have left is of another model, and tapes are cut short: the run begins anew") {
  const Folder folder;
  const std::string tapes = folder / "t", store = tapes + "/contact2d.store/";
  const Words words = {sample(), "--store", "file:" + tapes, "--keep", "--save-every", "0", "--csv", folder / "c"};
  REQUIRE(run(words).exit == 0);
  const std::string whole = read_file(folder / "c");
  std::string error, text;
  int records = 0;
  for (const char* name : {"path0", "path1"}) {
    if (app::read_sealed(store + name, "contact2d path 4", text, error) != app::Sealed::kWhole) continue;
    ++records;
    REQUIRE(app::write_sealed(store + name, "contact2d path 4", text.substr(0, text.find('\n') + 1) + "junk", error));
  }
  REQUIRE(records > 0);
  for (const char* cut : {"", "tape0.c2d", "tape1.c2d", "tape2.c2d", "tape3.c2d"}) {
    CAPTURE(cut);
    fs::remove(folder / "c");
    if (*cut != '\0' && fs::exists(store + cut)) fs::resize_file(store + cut, fs::file_size(store + cut) / 2);
    const Ran again = resume(tapes);
    CHECK_MESSAGE(again.exit == 0, again.reason);
    CHECK(read_file(folder / "c") == whole);
  }
}

TEST_CASE("jobs: a sketch is kept before its mesh is looked for, or the run says why not") {
  const Drawn drawn;
  const std::string tapes = drawn.folder / "t";
  const Words words = {drawn.sketch, "--store", "file:" + tapes, "--save-every", "0", "--csv", drawn.folder / "c"};
  const auto clear = [&] {
    fs::remove_all(tapes);
    fs::remove(drawn.folder / "c");
  };
  const Ran no_points = run(words + Words{"--points", drawn.folder / "none", "--stresses", drawn.folder / "st"});
  CHECK(no_points.exit == 2);
  CHECK(contains(no_points.reason, "cannot be read"));
  write_file(drawn.folder / "file", "");
  const Ran no_store = run({drawn.sketch, "--store", "file:" + (drawn.folder / "file/x"), "--csv", drawn.folder / "c"});
  CHECK(no_store.exit == 3);
  // What is wrong with it only its mesh shows: nothing is kept to go on with.
  const Drawn broken(std::string(kPulled) +
                     "body d E 1 nu 0\nfrom 5 0\nline s to 6 0\nline e to 6 1\nline n to 5 1\nline w close\nfix d.e\n"
                     "platen d.s+n about 5 0 fx 1\n");
  const Ran wrong = run({broken.sketch, "--store", "file:" + (broken.folder / "t"), "--csv", broken.folder / "c"});
  CHECK(wrong.exit == 2);
  CHECK(contains(wrong.reason, "the curves of a platen are not consecutive"));
  CHECK_FALSE(fs::exists(broken.folder / "t/contact2d.store/job"));
  clear();
  REQUIRE(run(words).exit == 0);
  const std::string whole = read_file(drawn.folder / "c");
  CHECK_FALSE(fs::exists(tapes));
  CHECK(run({drawn.sketch, "--estimate", "--csv", drawn.folder / "c"}).exit == 0); // it states errors without being asked
  if (!can_refuse_calls() || !can_judge_calls()) return;
  for (const char* call : {"open", "write", "fsync", "rename", "unlink", "opendir"})
    for (int n = 1; n < 40; n += n < 6 ? 1 : 5) {
      clear();
      CAPTURE(call);
      CAPTURE(n);
      const System refused(call, n, EIO);
      const Ran ran = run(words);
      if (refused.calls() < n) break;
      CHECK((ran.exit == 0 ? read_file(drawn.folder / "c") == whole : ran.exit == 3 || ran.exit == 2));
      CHECK((ran.exit == 0) == ran.reason.empty());
      CHECK((!fs::exists(drawn.folder / "c") ||
             read_file(drawn.folder / "c") == whole)); // (where its name cannot be flushed to disk)
    }
}

TEST_CASE("jobs: one that goes on has its meshes and its files, with every mesh that was kept of another run left aside") {
  const Drawn drawn;
  const std::string tapes = drawn.folder / "t", store = tapes + "/contact2d.store";
  const Words words = {drawn.sketch, "--store", "file:" + tapes, "--save-every", "0", "--csv", drawn.folder / "c"};
  REQUIRE(run(words).exit == 0);
  const std::string whole = read_file(drawn.folder / "c");
  if (!can_refuse_calls() || !can_judge_calls()) return;
  // The third file that gets its name is that of the second mesh: it fails, and with it the run.
  for (const bool foreign : {false, true}) {
    fs::remove_all(tapes);
    fs::remove(drawn.folder / "c");
    {
      const System refused("rename", 3, EIO);
      const Ran cut = run(words);
      CHECK(cut.exit == 3);
      CHECK(contains(cut.reason, "/mesh2: cannot be written: Input/output error"));
    }
    REQUIRE(fs::exists(store + "/mesh1"));
    std::string error, text;
    if (foreign) {
      REQUIRE(app::read_sealed(store + "/mesh1", "contact2d mesh 4", text, error) == app::Sealed::kWhole);
      for (const std::string& other : {std::string("junk"), "1\nx\n" + text}) {
        REQUIRE(app::write_sealed(store + "/mesh1", "contact2d mesh 4", other, error));
        estimate::TrialKeeper keeper;
        keeper.begin(store, "job", 0);
        estimate::Trial trial;
        CHECK_FALSE(keeper.recall("deck", trial));
      }
    }
    fs::remove(drawn.folder / "p.csv"); // it stands in the job
    const Ran on = resume(tapes);
    CHECK_MESSAGE(on.exit == 0, on.reason);
    CHECK(read_file(drawn.folder / "c") == whole);
    write_file(drawn.folder / "p.csv", kPoints);
  }
  // Of the job, of its deck, whole: each has to be this one's.
  const Folder folder;
  estimate::TrialKeeper keeper, again;
  estimate::Trial trial, back;
  trial.seconds = 1;
  keeper.begin(folder.path(), "job", 0);
  CHECK_FALSE(keeper.recall("deck", back));
  REQUIRE(keeper.keep("deck", trial));
  for (const auto& [job, deck] : {std::pair("job", "deck"), std::pair("other", "deck"), std::pair("job", "other")}) {
    again = estimate::TrialKeeper();
    again.begin(folder.path(), job, 0);
    CHECK(again.recall(deck, back) == (std::string(job) + deck == "jobdeck"));
  }
}

TEST_CASE("jobs: calls of the library that fail with every kind of failure") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Folder folder;
  const Words words = {sample(),     "--csv",     folder / "c", "--boundary", folder / "b", "--vtk",     folder / "v", "--json",
                       folder / "j", "--listing", folder / "l", "--response", "load",       "--results", folder / "r"};
  refuse_call(0);
  REQUIRE(run(words).exit == 0);
  const auto first_of = [](const char* name) {
    const std::vector<int64_t> calls = calls_of(name);
    REQUIRE(!calls.empty());
    return calls.front();
  };
  const int64_t prepare = first_of("c2d_prepare"), create = first_of("c2d_create"), close = first_of("c2d_close");
  const std::vector<int64_t> summaries = calls_of("c2d_get_summary");
  // No equations to go on with: all is written, and no number in it.
  refuse_call(prepare, C2D_ERR_SINGULAR);
  const Ran singular = run(words);
  CHECK(singular.exit == 1);
  CHECK(singular.reason != "");
  CHECK(contains(read_file(folder / "r"), "FAIL "));
  CHECK(fs::exists(folder / "v"));
  CHECK(lines_of(read_file(folder / "b")).size() == 1); // its heading
  const struct {
    int64_t call;
    c2d_status status;
    int exit;
  } cases[] = {{prepare, C2D_ERR_MEMORY, 4},      {prepare, C2D_ERR_STORE_READ, 3}, {prepare, C2D_ERR_MISMATCH, 3},
               {prepare, C2D_ERR_CANCELLED, 130}, {create, C2D_ERR_MEMORY, 4},      {create, C2D_ERR_OVERFLOW, 4},
               {close, C2D_ERR_STORE_CLOSE, 3}};
  for (const auto& c : cases) {
    CAPTURE(c.call);
    CAPTURE(c.status);
    fs::remove(folder / "c");
    refuse_call(c.call, c.status);
    const Ran ran = run(words);
    CHECK(ran.exit == c.exit);
    CHECK_FALSE(fs::exists(folder / "c"));
  }
  for (const int64_t n : summaries) {
    CAPTURE(n);
    fs::remove(folder / "c");
    refuse_call(n);
    CHECK(run(words).exit != 0);
    CHECK_FALSE(fs::exists(folder / "c"));
  }
  // Of a run that goes on, each: it goes on all the same the next time, or begins anew.
  const std::string tapes = folder / "t";
  refuse_call(0);
  REQUIRE(run({sample(), "--store", "file:" + tapes, "--keep", "--save-every", "0", "--csv", folder / "c"}).exit == 0);
  const std::string whole = read_file(folder / "c");
  refuse_call(0);
  REQUIRE(resume(tapes).exit == 0);
  const std::vector<int64_t> all = calls_to_refuse();
  const std::vector<int64_t> restores = calls_of("c2d_restore");
  REQUIRE(restores.size() == 1);
  for (const int64_t n : all) {
    CAPTURE(n);
    fs::remove(folder / "c");
    refuse_call(n);
    const Ran ran = resume(tapes);
    CHECK((ran.exit == 0 ? read_file(folder / "c") == whole : !fs::exists(folder / "c")));
  }
  for (const c2d_status status : {C2D_ERR_STORE_CHECKSUM, C2D_ERR_STORE_READ, C2D_ERR_STORE_STALE, C2D_ERR_MISMATCH}) {
    fs::remove(folder / "c");
    refuse_call(restores[0], status);
    CHECK(resume(tapes).exit == 0);
    CHECK(read_file(folder / "c") == whole);
  }
  refuse_call(0);
  CHECK(resume(tapes).exit == 0);
  // Ranges alone: the stresses of every step are kept, and not written.
  refuse_call(0);
  const Words ranges = {sample(), "--ranges", folder / "ra"};
  REQUIRE(run(ranges).exit == 0);
  for (const int64_t n : calls_to_refuse()) {
    fs::remove(folder / "ra");
    refuse_call(n);
    const Ran ran = run(ranges);
    CHECK((ran.exit != 0) == !fs::exists(folder / "ra"));
    CHECK((ran.exit != 0) == !ran.reason.empty());
  }
  refuse_call(0);
}

namespace {

// In a child, as signals are kept: told to stop at the n-th call of a name, which is done, or interrupted. Its exit status.
template <class Job> int told_to_stop(const char* call, int n, int signal, bool interrupts, const Job& job) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    app::catch_interrupts();
    int status = 0;
    try {
      const app::Muted muted;
      const System system(call, [=, count = 0]() mutable {
        if (++count != n) return int(kDone);
        ::raise(signal);
        return interrupts ? EINTR : int(kDone);
      });
      status = job();
      if (system.calls() < n) status = 99;
    } catch (...) {
      status = 98;
    }
    if (__llvm_profile_write_file != nullptr) __llvm_profile_write_file();
    ::_exit(status);
  }
  int raw = 0;
  ::waitpid(child, &raw, 0);
  return WIFEXITED(raw) ? WEXITSTATUS(raw) : 128 + WTERMSIG(raw);
}

} // namespace

TEST_CASE("signals: whatever waits for the system, a run that is told to stop leaves nothing") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Drawn drawn;
  write_file(drawn.folder / "points", "1,1,1\n");
  const std::string out = drawn.folder / "c", tapes = drawn.folder / "t";
  const Words deck = {sample(), "--points", drawn.folder / "points", "--stresses", drawn.folder / "st", "--csv",
                      out,      "--store",  "file:" + tapes};
  const Words sketch = {drawn.sketch, "--points",      drawn.folder / "points", "--stresses", drawn.folder / "st", "--csv", out,
                        "--store",    "file:" + tapes, "--save-every",          "0"};
  for (const Words& words : {deck, sketch}) {
    REQUIRE(run(words).exit == 0);
    const std::string whole = read_file(out);
    for (const char* call : {"open", "read", "fsync", "opendir"})
      for (const bool interrupts : {true, false})
        for (int n = 1; n < 30; ++n) {
          if (n % effort(16, 4) != 1 && (!interrupts || std::string(call) != "open" || n % effort(6, 1) != 0))
            continue; // a sample
          fs::remove_all(tapes);
          fs::remove(out);
          const std::string name = call;
          CAPTURE(name);
          CAPTURE(n);
          CAPTURE(interrupts);
          const int signal = n % 2 == 0 ? SIGTERM : SIGINT;
          const int status = told_to_stop(call, n, signal, interrupts, [&] { return run(words).exit; });
          if (status == 99) break;
          CAPTURE(status);
          CHECK((status == 0 || status == 130 || (status == 143 && signal == SIGTERM)));
          CHECK((!fs::exists(out) || read_file(out) == whole)); // told while names are made safe it is there
        }
  }
}

TEST_CASE("signals: a sweep that is told to stop keeps its rows, where it has results to keep them beside") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Folder folder;
  std::string deck = run_shell("'" + paths::program() + "' make hertz n=4").out;
  const size_t at = deck.find("\n1 50\n1 1\n");
  REQUIRE(at != std::string::npos);
  write_file(folder / "deck", deck.replace(at, 10, "\n1 50\n{steps=2} {load}\n"));
  write_file(folder / "table", "load\n1\n2\n3\n");
  const Words words = {"sweep", folder / "table", folder / "deck", "--response", "load", "-q", "--threads", "1"};
  const auto sweep = [&](const Words& more) { return [words, more] { return app::sweep_table(options_of(words + more)); }; };
  const Words kept = {"--results", folder / "r"};
  CHECK(told_to_stop("calloc", 2, SIGINT, false, sweep({})) == 130);
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove(folder / "r.rows");
    CHECK(told_to_stop("calloc", 2, signal, false, sweep(kept)) == (signal == SIGTERM ? 143 : 130));
    CHECK(fs::exists(folder / "r.rows"));
    CHECK_FALSE(fs::exists(folder / "r"));
  }
  const app::Muted muted;
  CHECK(app::sweep_table(options_of(words + kept + Words{"--resume", "--progress"})) == 0);
  CHECK(lines_of(read_file(folder / "r")).size() == 4);
  // The same names twice, parameters of all rows, points, results on standard output or nowhere, rows that cannot be kept.
  CHECK(app::sweep_table(options_of(
            {"sweep", folder / "table", folder / "deck", "--response", "load", "--results", folder / "table"})) == 64);
  write_file(folder / "points", "1,1,-3\n");
  CHECK(app::sweep_table(options_of(words + kept + Words{"--set", "steps=1", "--points", folder / "points"})) == 0);
  CHECK(app::sweep_table(options_of(words + Words{"--results", folder / "none/r"})) == 3);
  for (int n = 2; n <= 5; ++n) {
    fs::remove(folder / "r.rows");
    fs::remove(folder / "r");
    const System full("write", n, ENOSPC);
    CHECK(app::sweep_table(options_of(words + kept)) == 3);
    CHECK_FALSE(fs::exists(folder / "r"));
  }
}
