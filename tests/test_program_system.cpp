// What the system refuses the program: its calls fail one by one in this process (tests/refused_calls.hpp), and what is told,
// left behind and done instead is looked at.
#include "paths.hpp"
#include "program_options.hpp"
#include "refused_calls.hpp"
#include "shell.hpp"
#include "system_calls.hpp"

#include "program/commands/commands.hpp"
#include "program/commands/job.hpp"
#include "program/files/deck_file.hpp"
#include "program/files/output_file.hpp"
#include "program/files/sealed_file.hpp"
#include "program/files/store_choice.hpp"
#include "program/files/system_file.hpp"
#include "program/messages.hpp"
#include "program/outputs/outputs.hpp"
#include "program/run.hpp"
#include "program/sweep/answer.hpp"
#include "program/sweep/journal.hpp"
#include "program/words/voice.hpp"
#include "program/workspace.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <new>

using namespace test;

namespace {

const std::string& sample() {
  static const std::string name = paths::data() + "/decks/sample.dat";
  return name;
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
Ran run(const std::vector<std::string>& words) { return run(options_of(words)); }

// An output of so many bytes under a name that may be taken.
std::string written(const std::string& name, size_t bytes = 3) {
  std::string error;
  return app::write_output(name, std::string(bytes, 'x'), error) ? "" : error;
}

} // namespace

TEST_CASE("system: outputs are held where there are locks, and go elsewhere where another run takes their names") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Folder folder;
  const std::string name = folder / "a.csv";
  const auto clear = [&folder] {
    for (const std::string& left : folder.names()) fs::remove(folder / left);
  };
  for (const int code : {ENOLCK, EOPNOTSUPP, EINTR, EWOULDBLOCK}) {
    CAPTURE(code);
    clear();
    const System one("flock", 1, code);
    CHECK(written(name) == "");
    CHECK(read_file(name) == "xxx");
    CHECK(folder.names().size() == (code == EWOULDBLOCK ? 2 : 1)); // that one is another run's
  }
  clear();
  {
    const System all("flock", [] { return EIO; });
    CHECK(written(name) == name + ": cannot be written: Input/output error");
    CHECK(folder.names().empty());
  }
  {
    const System stat("fstat", 1, EIO);
    CHECK(written(name) == name + ": cannot be written: Input/output error");
    CHECK(folder.names().empty());
  }
  { // another run takes it for one that was left, between its making and its holding
    const System held("flock", [&folder, first = true]() mutable {
      if (first) fs::remove(folder / folder.names().at(0));
      first = false;
      return int(kDone);
    });
    CHECK(written(name) == "");
    CHECK(folder.names().size() == 1);
  }
  { // one that is there, and cannot even be opened
    const System open("open", [n = 0]() mutable { return ++n == 1 ? EEXIST : n == 2 ? EACCES : int(kDone); });
    CHECK(written(name) == "");
  }
  for (const char* call : {"access", "realpath"}) { // of one that is there
    const System refused(call, 1, EACCES);
    CHECK(written(name) == name + ": cannot be written: Permission denied");
  }
  for (const char* call : {"write", "fsync", "rename"}) {
    const System refused(call, 1, ENOSPC);
    const std::string told = written(name);
    CHECK_MESSAGE(contains(told, "No space left on device"), told);
    CHECK(read_file(name) == "xxx");
    CHECK(folder.names().size() == 1);
  }
  {
    const System nothing("write", 1, kNothing);
    CHECK(written(name) == name + ": write failed: Input/output error");
  }
  { // what is large goes out in pieces
    app::OutputFile file;
    std::string error;
    REQUIRE(file.open(name, error));
    file.text.assign(300000, 'y');
    const System full("write", 1, ENOSPC);
    CHECK_FALSE(file.flush(error));
    CHECK(error == name + ": write failed: No space left on device");
  }
  // What is written directly is gone, and cannot be told once more.
  app::OutputFile direct;
  std::string error, all;
  REQUIRE(direct.open("/dev/null", error));
  for (int i = 0; i < 2; ++i) {
    direct.text = "last";
    CHECK(direct.so_far(all, error) == (i == 0));
    direct.text.assign((size_t{1} << 26) + 1, 'z');
    CHECK(direct.flush(error));
  }
  CHECK(error == "");
}

TEST_CASE("system: files, folders and names of them") {
  using app::list_folder;
  const Folder folder;
  std::vector<std::string> names;
  CHECK(list_folder(folder / "none", names) == ENOENT);
  CHECK_THROWS_AS(app::system_text(ENOMEM), std::bad_alloc);
  CHECK(app::is_absolute("/a"));
  CHECK_FALSE(app::is_absolute("a/b"));
  std::string error;
  CHECK_FALSE(app::remove_file(folder.path(), error));
  CHECK(contains(error, folder.path() + ": cannot be removed: "));
  CHECK_FALSE(app::remove_way(folder / "none", error));
  CHECK(error == (folder / "none") + ": cannot be read: No such file or directory");
  write_file(folder / "file", "");
  std::string text;
  CHECK(app::read_sealed(folder / "file/job", "kind", text, error) == app::Sealed::kAbsent);
  if (!can_refuse_calls() || !can_judge_calls()) return;
  {
    const System interrupted("opendir", 1, EINTR);
    CHECK(list_folder(folder.path(), names) == 0);
    CHECK(names == std::vector<std::string>{"file"});
  }
  for (const int code : {EINVAL, ENOTSUP, EIO}) { // what cannot sync folders has no need of it
    const System refused("fsync", 1, code);
    CHECK(app::sync_folder(folder.path()) == (code == EIO ? EIO : 0));
  }
  {
    const System unreadable("open", 1, EACCES);
    CHECK(app::sync_folder(folder.path()) == 0);
  }
  // Of a sealed file every call: the file is what it was, but for its name, which may be there and not safe.
  REQUIRE(app::write_sealed(folder / "job", "kind", "first", error));
  for (const char* call : {"open", "write", "fsync", "rename"})
    for (const int n : {1, 2}) {
      const System refused(call, n, EIO);
      const bool done = app::write_sealed(folder / "job", "kind", "first", error);
      CHECK(done == (refused.calls() < n));
      if (!done) CHECK_MESSAGE(contains(error, "Input/output error"), error);
      CHECK(app::read_sealed(folder / "job", "kind", text, error) == app::Sealed::kWhole);
      CHECK(text == "first");
    }
}

TEST_CASE("system: names of files that are one, or only look so") {
  const Folder folder;
  fs::copy_file(sample(), folder / "deck");
  write_file(folder / "a.csv", "");
  const auto clash = [&](const std::vector<std::string>& words) { return app::find_clash(options_of(words)); };
  CHECK(clash({"run", folder / "deck", "--points", "/proc/version", "--csv", folder / "a.csv"}) == ""); // of two devices
  CHECK(clash({"run", "-", "--points", folder / "a.csv"}) == "");
  CHECK(clash({"run", "-", "--points", "-"}) == "the deck and --points both come from standard input");
  CHECK(clash({"run", folder / "deck", "--figures", folder / "f", "--csv", folder / "a.svg"}) == "");
  CHECK(contains(clash({"run", folder / "deck", "--figures", folder / "f", "--csv", folder / "f/a.svg"}),
                 "an SVG file in the folder"));
  // The interior's table of --out is written where there are points.
  write_file(folder / "points", "1,1,1\n");
  for (const bool points : {false, true}) {
    std::vector<std::string> words = {"run", sample(), "-q", "--no-progress", "--out", folder / (points ? "with" : "without")};
    if (points) words.insert(words.end(), {"--points", folder / "points"});
    CHECK(run(words).exit == 0);
    CHECK(fs::exists(words[5] + "/interior.csv") == points);
  }
}

TEST_CASE("system: every output's safety, one call after the other") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Folder folder;
  const auto words = [&](const std::string& out) {
    return std::vector<std::string>{"run", sample(), "-q", "--no-progress", "--csv", out + ".csv", "--figures", out};
  };
  int calls = 0;
  {
    const System counted("fsync", [] { return int(kDone); });
    REQUIRE(run(words(folder / "whole")).exit == 0);
    calls = counted.calls();
  }
  CHECK(calls > 4);
  const size_t before = folder.names().size();
  for (int n = 1; n <= calls; ++n) {
    CAPTURE(n);
    const std::string out = folder / std::to_string(n);
    const System refused("fsync", n, EIO);
    const Ran failed = run(words(out));
    CHECK(failed.exit == 3);
    CHECK_MESSAGE(contains(failed.reason, "cannot be flushed to disk: Input/output error"), failed.reason);
  }
  CHECK(folder.names().size() >= before); // what has its name already stays
}

TEST_CASE("system: tapes where memory, TMPDIR or the budget end") {
  std::string error;
  app::StoreChoice empty;
  REQUIRE(empty.choose("memory", 1, false, error));
  CHECK(empty.open(0, 0, 64) == 0);
  CHECK(empty.open(1, 4, 0) == 0);
  CHECK(empty.system_text(C2D_POSIX_STORE_END) == "a file of the store is truncated");
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  for (const bool set : {false, true}) { // then it is /tmp
    REQUIRE((set ? ::setenv("TMPDIR", "", 1) : ::unsetenv("TMPDIR")) == 0);
    app::StoreChoice store;
    REQUIRE(store.choose("", 0, false, error));
    REQUIRE(store.open(0, 2, 64) == 0);
    CHECK(store.folder().compare(0, 15, "/tmp/contact2d-") == 0);
    CHECK(store.remove_tapes(error));
  }
  REQUIRE((kept.empty() ? ::unsetenv("TMPDIR") == 0 : ::setenv("TMPDIR", kept.c_str(), 1) == 0));
  app::StoreChoice shrunk; // for a run with less to spare what the one before it has in memory counts
  REQUIRE(shrunk.choose("", 1000, false, error));
  REQUIRE(shrunk.open(0, 10, 64) == 0);
  REQUIRE(shrunk.choose("", 100, false, error));
  REQUIRE(shrunk.open(1, 1, 64) == 0);
  CHECK(contains(shrunk.file_of(1), "/tape1.c2d"));
  CHECK(shrunk.remove_tapes(error));
  app::StoreChoice held; // but not what it has of the tape itself
  REQUIRE(held.choose("memory", 0, false, error));
  REQUIRE(held.reserve(0, 20, 64));
  CHECK(held.bytes_in_memory() == 20 * 64);
  REQUIRE(held.choose("", 100, false, error));
  REQUIRE(held.open(0, 10, 64) == 0);
  CHECK(held.folder() == "");
  held.drop_tapes();
  CHECK(held.bytes_in_memory() == 0);
  app::StoreChoice mostly_unwritten; // only what is expected counts, of the tape beside it, too
  REQUIRE(mostly_unwritten.choose("", 1000, false, error));
  mostly_unwritten.expect(0, 900);
  REQUIRE(mostly_unwritten.open(0, 1000, 64) == 0);
  CHECK(mostly_unwritten.file_of(0) == "");
  REQUIRE(mostly_unwritten.open(1, 1, 64) == 0);
  CHECK(mostly_unwritten.file_of(1) == "");
  REQUIRE(mostly_unwritten.open(2, 1, 64) == 0);
  CHECK(contains(mostly_unwritten.file_of(2), "/tape2.c2d"));
  CHECK(mostly_unwritten.remove_tapes(error));
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const System none("calloc", [] { return ENOMEM; });
  app::StoreChoice store;
  REQUIRE(store.choose("memory", 0, false, error));
  const int32_t code = store.open(0, 2, 64);
  CHECK(store.system_text(code) == "not enough memory for the tapes; --store file:DIR keeps them in files");
  CHECK(store.file_of(0) == "");
}

TEST_CASE("system: memory that is free, and a workspace or threads that cannot be had") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  {
    const System closed("open", 1, ENOENT);
    CHECK(app::free_memory() > 0);
  }
  {
    const System unread("read", 1, EIO);
    CHECK(app::free_memory() > 0);
  }
  {
    const System closed("open", 1, ENOENT);
    const uint64_t pages = app::free_memory();
    CHECK(pages % 4096 == 0);
  }
  const Ran threads = [] {
    const System refused("pthread_create", [] { return EAGAIN; });
    return run({"run", sample(), "-q", "--no-progress", "--threads", "2"});
  }();
  CHECK(threads.exit == 4);
  CHECK(threads.reason == "2 threads: Resource temporarily unavailable");
  const Ran memory = [] {
    const System refused("malloc", [] { return ENOMEM; });
    return run({"run", sample(), "-q", "--no-progress"});
  }();
  CHECK(memory.exit == 4);
  CHECK_MESSAGE(contains(memory.reason, "bytes of memory: a workspace of "), memory.reason);
  const app::Muted muted;
  const System refused("malloc", [] { return ENOMEM; });
  CHECK(app::check_decks(options_of({"check", "-q", sample()})) == 4);
  const Ran tapes = [] {
    const System none("calloc", [] { return ENOMEM; });
    return run({"run", sample(), "-q", "--no-progress", "--store", "memory"});
  }();
  CHECK(tapes.exit == 3);
  CHECK(tapes.reason != "");
}

TEST_CASE("system: answers of a run, and rows of many, that cannot be written") {
  const Folder folder;
  std::vector<std::string> words = {"run",        sample(), "-q",        "--no-progress",
                                    "--response", "load",   "--results", folder / "none/r"};
  const Ran solved = run(words);
  CHECK(solved.exit == 3);
  CHECK(solved.reason == (folder / "none/r") + ": cannot be written: No such file or directory");
  words[1] = folder / "no deck";
  CHECK(run(words).exit == 2); // why it failed goes before
  if (!can_refuse_calls() || !can_judge_calls()) return;
  std::string error;
  const std::string rows = folder / "rows";
  REQUIRE(app::append_row(rows, "a\n", "1\n", {}, error));
  const struct {
    const char* call;
    int n, code;
    const char* told;
  } refused[] = {{"flock", 1, EIO, "Input/output error"},
                 {"fstat", 1, EIO, "Input/output error"},
                 {"pread", 1, EIO, "Input/output error"},
                 {"write", 1, ENOSPC, "No space left on device"},
                 {"fsync", 1, EIO, "Input/output error"}};
  for (const auto& r : refused) {
    CAPTURE(r.call);
    const System system(r.call, r.n, r.code);
    CHECK_FALSE(app::append_row(rows, "a\n", "2\n", {}, error));
    CHECK(error == rows + ": a row cannot be added: " + r.told);
  }
  {
    const System interrupted("flock", 1, EINTR);
    CHECK(app::append_row(rows, "a\n", "3\n", {}, error));
  }
  write_file(folder / "short", "a");
  CHECK_FALSE(app::append_row(folder / "short", "a,b,c\n", "1\n", {}, error));
  CHECK(error == (folder / "short") + ": has other columns, expected a,b,c");
  // The rows of a sweep, kept beside its results.
  for (const auto& [name, code] :
       {std::pair("flock", EIO), std::pair("read", EIO), std::pair("ftruncate", EIO), std::pair("write", ENOSPC)}) {
    const std::string call = name;
    CAPTURE(call);
    fs::remove(folder / "j");
    app::Journal journal;
    const System system(name, 1, code);
    CHECK(journal.open(folder / "j", 1, false, error) == 3);
    CHECK(contains(error, (folder / "j") + ": "));
  }
  fs::remove(folder / "j");
  app::Journal journal;
  REQUIRE(journal.open(folder / "j", 1, false, error) == 0);
  const System full("write", 1, ENOSPC);
  CHECK_FALSE(journal.add(0, "row", error));
  CHECK(error == (folder / "j") + ": a row cannot be added: No space left on device");
}

TEST_CASE("messages: what is told, what is kept, and what is too much") {
  app::DeckFile deck;
  deck.call("deck");
  deck.replace("one\n");
  CHECK(deck.card(0).empty());
  app::Messages messages(deck);
  const auto entry = [](int32_t severity, int32_t status, const std::string& text) {
    c2d_error e = C2D_INIT(c2d_error);
    e.severity = severity, e.status = status;
    text.copy(e.text, sizeof e.text - 1);
    return e;
  };
  const auto log = [&](const c2d_error& e) {
    const app::Muted muted;
    app::forget_reason();
    app::Messages::log(&messages, &e);
    return app::reason_told();
  };
  messages.quiet = true;
  CHECK(log(entry(C2D_WARNING, C2D_WARN_COMPRESSED, "coarse")) == "");
  CHECK(messages.warnings().size() == 1);
  messages.note("nothing"); // is told of nothing
  CHECK(log(entry(C2D_NOTE, C2D_OK, "by the way")) == "");
  CHECK(messages.latest() == "by the way");
  CHECK(log(entry(C2D_FAULT, C2D_OK, "none of a deck")) == "");
  CHECK(log(entry(C2D_FAULT, C2D_ERR_MEMORY, "nor this")) == "");
  CHECK(messages.latest() == "by the way");
  for (int i = 1; i <= 1000; ++i) CHECK(log(entry(C2D_FAULT, C2D_ERR_INPUT, "wrong")) == "wrong");
  CHECK(log(entry(C2D_FAULT, C2D_ERR_INPUT, "wrong")) == "too many errors; the others are not printed");
  CHECK(log(entry(C2D_FAULT, C2D_ERR_INPUT, "wrong")) == "");
}

TEST_CASE("system: the program's smaller words, each by its exit status and what it prints") {
  const Folder folder;
  const std::string program = "'" + paths::program() + "' ";
  const auto told = [&](const std::string& words) { return run_shell("cd '" + folder.path() + "' && " + program + words); };
  write_file(folder / "p", "load = 1\n");
  std::string deck = read_file(sample());
  write_file(folder / "deck", deck);
  CHECK(told("make hertz -h").status == 0);
  CHECK(contains(told("make hertz -h").out, "elements over the half width"));
  CHECK(contains(told("help help").out, "usage: contact2d COMMAND"));
  CHECK(told("check deck deck -q").status == 0);
  CHECK(told("check deck deck > /dev/full").status == 3);
  CHECK(contains(told("check deck --params - < p").err, "no parameter load"));
  write_file(folder / "named", deck + (deck.back() == '\n' ? "" : "\n") + "*NAME ZONE 1 face\n");
  CHECK(contains(told("check named").out, "zone 1 (face)"));
  CHECK(told("mesh deck").status == 2);
  CHECK(contains(told("mesh deck").err, "the file is a deck and has a mesh, expected a sketch"));
  CHECK(contains(told("mesh none").err, "No such file or directory"));
  write_file(folder / "s.c2s", "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix "
                               "b.s\ntraction b.n y 1\ntolerance off\n");
  CHECK(told("mesh s.c2s -o m").status == 0);
  CHECK(told("mesh s.c2s -o none/m").status == 3);
  write_file(folder / "d.dxf", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n1\n0\nENDSEC\n0\nEOF\n");
  CHECK(told("sketch d.dxf -o none/s").status == 3);
  CHECK(told("sketch d.dxf -o d.c2s").status == 0);
  // Kept, and gone on with, without a word.
  CHECK(told("run deck -q --no-progress --store file:kept --keep --csv c").err == "");
  for (const char* words : {"resume kept -q --no-progress", "resume kept --no-progress"}) CHECK(told(words).status == 0);
}

TEST_CASE("system: points over bodies beside lines of symmetry, points without end, and many of them") {
  const Folder folder;
  const auto sketch = [&](const std::string& text) {
    write_file(folder / "s.c2s", text + "tolerance off\n");
    fs::remove(folder / "v.vtk");
    const Ran ran = run({"run", folder / "s.c2s", "-q", "--no-progress", "--vtk", folder / "v.vtk"});
    REQUIRE_MESSAGE(ran.exit == 0, ran.reason);
    std::vector<double> xy; // of all points of the file
    std::istringstream in(read_file(folder / "v.vtk"));
    for (std::string word; in >> word;)
      if (word == "POINTS") {
        int count = 0;
        in >> count >> word;
        for (double v = 0; count-- > 0;)
          for (int c = 0; c < 3 && in >> v; ++c)
            if (c < 2) xy.push_back(v);
      }
    REQUIRE(xy.size() > 100);
    return xy;
  };
  const auto range = [](const std::vector<double>& xy, size_t axis) {
    double low = HUGE_VAL, high = -HUGE_VAL, least = HUGE_VAL;
    for (size_t i = axis; i < xy.size(); i += 2)
      low = std::min(low, xy[i]), high = std::max(high, xy[i]), least = std::min(least, std::fabs(xy[i]));
    return std::array<double, 3>{low, high, least};
  };
  const std::string body = "body b E 1000 nu 0.3\n", both = "symmetry x 0\nsymmetry y 0\n";
  // It meets x = 0 and is seen whole there; beyond y = 0 is its image.
  const std::vector<double> corner =
      sketch(both + body +
             "from 0 1\narc c to 0 3 centre 0 2\nfix b.c\nbody d E 1 nu 0\nfrom 6 0\narc c to 4 0 centre 5 0\nfix d.c\n");
  CHECK(range(corner, 0)[0] == doctest::Approx(-range(corner, 0)[1]));
  CHECK(range(corner, 1)[0] == doctest::Approx(-3));
  CHECK(range(corner, 1)[1] == doctest::Approx(3));
  CHECK(range(corner, 0)[1] == doctest::Approx(6)); // and the other way round of the other
  // On the other side of a line that it does not meet.
  const std::vector<double> beside =
      sketch("symmetry x 0\n" + body +
             "from -2 0\nline s to -1 0\nline e to -1 1\nline n to -2 1\nline w close\nfix b.s\ntraction b.n y 1\n" +
             "body d E 1 nu 0\nfrom 0 -4\narc c to 0 -6 centre 0 -5\nfix d.c\n");
  CHECK(range(beside, 0)[0] == doctest::Approx(-2));
  CHECK(range(beside, 0)[1] == doctest::Approx(2));
  // A grid of more points than can be, and one of more than the library is asked for at once.
  std::string deck = read_file(sample());
  write_file(folder / "endless", deck + "*POINTS\nGRID 1 0 0 1 1 4000 4000\n");
  const Ran endless = run({"run", folder / "endless", "-q", "--no-progress", "--interior", folder / "i"});
  CHECK(endless.exit == 2);
  CHECK_MESSAGE(contains(endless.reason, "more than 10000000 points under *POINTS"), endless.reason);
  std::string many;
  for (int i = 0; i < 5000; ++i) many += "1,90," + std::to_string(i) + "\n"; // far outside, in no other body
  write_file(folder / "points", many);
  CHECK(run({"run", sample(), "-q", "--no-progress", "--points", folder / "points", "--interior", folder / "i"}).exit == 0);
  CHECK(lines_of(read_file(folder / "i")).size() == 5001);
  if (!can_refuse_calls() || !can_judge_calls()) return;
  write_file(folder / "points", "1,0.1,-0.1\n1,90,0\n2,90,0\n");
  for (const char* output : {"--interior", "--stresses", "--ranges"}) {
    const std::vector<std::string> words = {"run",      sample(),          "-q",   "--no-progress",
                                            "--points", folder / "points", output, folder / "o"};
    refuse_call(0);
    REQUIRE(run(words).exit == 0);
    for (const int64_t n : calls_of("c2d_interior")) {
      CAPTURE(output);
      CAPTURE(n);
      fs::remove(folder / "o");
      refuse_call(n);
      CHECK(run(words).exit != 0);
      CHECK_FALSE(fs::exists(folder / "o"));
    }
  }
  refuse_call(0);
}

TEST_CASE("system: a deck is not written in its other form if that cannot be read again") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Folder folder;
  const app::Muted muted;
  const app::Options options = options_of({"convert", sample(), "-o", folder / "d"});
  refuse_call(0);
  REQUIRE(app::convert_deck(options) == 0);
  const int64_t last = calls_of("c2d_walk_deck").back();
  fs::remove(folder / "d");
  refuse_call(last);
  app::forget_reason();
  CHECK(app::convert_deck(options) == 3);
  CHECK(contains(app::reason_told(), "the converted deck would not give the same model"));
  CHECK_FALSE(fs::exists(folder / "d"));
  refuse_call(0);
  REQUIRE(app::check_decks(options_of({"check", "-q", sample()})) == 0);
  for (const int64_t n : calls_of("c2d_get_summary")) {
    refuse_call(n);
    CHECK(app::check_decks(options_of({"check", "-q", sample()})) == 3);
  }
  refuse_call(0);
}

TEST_CASE("system: estimates that have no memory, or whose calls fail, are not stated, and the run goes on") {
  if (!can_refuse_calls() || !can_judge_calls()) return;
  const Folder folder;
  const std::vector<std::string> words = {"run", sample(), "-q", "--no-progress", "--csv", folder / "c", "--estimate"};
  refuse_call(0);
  REQUIRE(run(words).exit == 0);
  const std::string whole = read_file(folder / "c");
  std::vector<int64_t> calls;
  for (const char* name : {"c2d_get_summary", "c2d_get", "c2d_get_region", "c2d_get_friction"}) {
    const std::vector<int64_t> all = calls_of(name);
    for (size_t i = 0; i < all.size(); i += 1 + all.size() / 20) calls.push_back(all[i]);
  }
  for (const int64_t n : calls) {
    CAPTURE(n);
    fs::remove(folder / "c");
    refuse_call(n);
    const Ran ran = run(words);
    CHECK((ran.exit == 0 ? read_file(folder / "c") == whole : !fs::exists(folder / "c")));
    CHECK((ran.exit == 0) == ran.reason.empty());
  }
  refuse_call(0);
  for (int n = 1; n <= 4; ++n) {
    const System none("calloc", n, ENOMEM);
    CHECK(run(words).exit == 0);
    CHECK(read_file(folder / "c") == whole);
  }
  // The first mesh of a sketch, for which the memory that is given does not do.
  write_file(folder / "s.c2s",
             "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\nfix b.s\ntraction b.n y 1\n"
             "want stress b 0.5 0.5 50 %\nlimit seconds 1000\n");
  const std::vector<std::string> sketch = {"run", folder / "s.c2s", "-q", "--no-progress", "--csv", folder / "c"};
  std::vector<std::string> small = sketch;
  small.insert(small.end(), {"--memory", "1K"});
  const Ran failed = run(small);
  CHECK(failed.exit == 4);
  CHECK(contains(failed.reason, "is too small"));
  refuse_call(0);
  REQUIRE(run(sketch).exit == 0);
  for (const char* name : {"c2d_get_summary", "c2d_get", "c2d_interior", "c2d_indicators"}) {
    refuse_call(0);
    REQUIRE(run(sketch).exit == 0);
    const std::vector<int64_t> all = calls_of(name);
    for (size_t i = 0; i < all.size(); i += 1 + all.size() / 20) {
      CAPTURE(name);
      CAPTURE(i);
      fs::remove(folder / "c");
      refuse_call(all[i]);
      const Ran ran = run(sketch);
      const bool has_results = ran.exit == 0 || ran.exit == 5; // 5: nothing can be stated
      CHECK(has_results == fs::exists(folder / "c"));
      CHECK(has_results == ran.reason.empty());
    }
  }
  refuse_call(0);
}
