// `contact2d resume`: after a crash at any moment the outputs are those of a run that was not interrupted.
#include "effort.hpp"
#include "paths.hpp"
#include "program/commands/job.hpp"
#include "program/estimate/kept.hpp"
#include "program/files/sealed_file.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <map>
#include <thread>

using namespace test;

namespace {

const std::string kProgram = "'" + paths::program() + "' ";

struct Outputs {
  Folder folder;
  // Small panels, so that there is much to transfer.
  std::string options() const {
    return " --memory 800K --csv '" + (folder / "csv") + "' --boundary '" + (folder / "boundary") + "' --json '" +
           (folder / "json") + "' --listing '" + (folder / "listing") + "' --vtk '" + (folder / "vtk") + "' --no-progress";
  }
  // Every file but for the times in it, the names without the folder.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
      if (!entry.is_regular_file()) continue;
      std::string text;
      for (const std::string& line : lines_of(read_file(entry.path().string())))
        if (!contains(line, "\"seconds\"")) text += line + "\n";
      out[entry.path().string().substr(folder.path().size())] = text;
    }
    return out;
  }
};

const std::string& deck() {
  static const Folder folder;
  static const std::string path = folder / "deck.dat";
  if (!fs::exists(path)) REQUIRE(run_shell(kProgram + "make disc_in_hole n=40 > '" + path + "'").status == 0);
  return path;
}

std::string run_command(const std::string& tapes, const Outputs& outputs, const std::string& more = "") {
  return "'" + paths::program() + "' run '" + deck() + "' --store 'file:" + tapes + "'" + outputs.options() + " " + more;
}

// Start the command and kill it after a while; false if it had ended before.
// With `file` the while begins when it has appeared.
bool killed(const std::string& command, const std::string& file, int microseconds, int signal) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    ::dup2(nowhere, 1);
    ::dup2(nowhere, 2);
    ::execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  int status = 0;
  bool ended = false;
  while (!file.empty() && !ended && !fs::exists(file)) ended = ::waitpid(child, &status, WNOHANG) == child;
  if (ended) return false;
  std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
  ::kill(child, signal);
  ::waitpid(child, &status, 0);
  return signal == SIGKILL ? WIFSIGNALED(status) : WIFEXITED(status) && WEXITSTATUS(status) == 130;
}

} // namespace

TEST_CASE("resume: killed at any moment, resumed, the outputs are those of one run") {
  Outputs whole;
  const Folder tapes;
  REQUIRE(run_shell(run_command(tapes / "whole", whole)).status == 0);
  const auto expected = whole.files();
  REQUIRE(expected.size() == 8); // with what two tables and the VTK file are made from
  int kills = 0, resumed = 0, finished = 0, early = 0;
  for (int n = 0; n < 14; n += test::effort(3, 1)) {
    CAPTURE(n);
    Outputs outputs;
    const std::string folder = tapes / std::to_string(n);
    const int microseconds = n * n * 150; // 0 to 25 ms
    const std::string sign = n < 2 ? "" : folder + "/contact2d.store/job";
    if (!killed(run_command(folder, outputs, n % 2 == 0 ? "--keep" : ""), sign, microseconds, n % 3 == 2 ? SIGINT : SIGKILL)) {
      ++finished;
      continue;
    }
    ++kills;
    for (const auto& file : outputs.files()) { // whole under its own name, or still aside
      const auto same = expected.find(file.first);
      CHECK((same != expected.end() ? file.second == same->second : file.first.find("/.contact2d-") != std::string::npos));
      if (same != expected.end()) fs::remove(outputs.folder.path() + file.first); // the others go when the names come again
    }
    if (!fs::exists(folder + "/contact2d.store/job")) { // it had hardly begun, or had nothing left to do
      CHECK(run_shell(kProgram + "resume '" + folder + "'").status == 2);
      ++early;
      continue;
    }
    ++resumed;
    const Result result = run_shell(kProgram + "resume '" + folder + "'");
    CHECK_MESSAGE(result.status == 0, result.err);
    CHECK(outputs.files() == expected);
    CHECK(fs::exists(folder + "/contact2d.store/tape0.c2d") == (n % 2 == 0));
    CHECK(fs::exists(folder + "/contact2d.store/job") == (n % 2 == 0));
  }
  MESSAGE("killed " << kills << ", of these resumed " << resumed << " and too early " << early << "; ended before "
                    << finished);
}

TEST_CASE("resume: a factorisation that is there is not computed again; one that is damaged is") {
  Outputs outputs;
  const Folder tapes;
  const std::string folder = tapes / "t";
  REQUIRE(run_shell(run_command(folder, outputs, "--keep")).status == 0);
  const auto expected = outputs.files();
  const auto resume = [&] { // from another folder, with the tapes under another name
    fs::rename(folder, tapes / "u");
    const Result result = run_shell("cd / && " + kProgram + "resume '" + (tapes / "u") + "'");
    fs::rename(tapes / "u", folder);
    return result;
  };
  const auto again = [&] {
    for (const auto& file : expected) fs::remove(outputs.folder.path() + file.first);
    const Result result = resume();
    CHECK_MESSAGE(result.status == 0, result.err);
    CHECK(outputs.files() == expected);
    return result;
  };
  const std::string own = folder + "/contact2d.store";
  for (const char* name : {"/tape1.c2d", "/tape2.c2d", "/tape3.c2d"}) {
    const std::string tape = own + name;
    if (!fs::exists(tape)) continue;
    const auto before = fs::last_write_time(tape);
    again();
    CHECK(fs::last_write_time(tape) == before);
  }
  for (const char* name : {"/tape0.c2d", "/tape2.c2d", "/tape3.c2d"}) {
    CAPTURE(std::string(name));
    const std::string tape = own + name;
    const auto size = fs::file_size(tape);
    fs::resize_file(tape, size / 2); // the end is gone
    CHECK(contains(again().err, "restarts from the beginning"));
    std::string bytes = read_file(tape);
    for (size_t i = 150; i < bytes.size(); i += 997) bytes[i] = static_cast<char>(bytes[i] ^ 1);
    write_file(tape, bytes);
    CHECK(contains(again().err, "restarts from the beginning"));
    fs::remove(tape);
    CHECK(contains(again().err, "restarts from the beginning"));
    CHECK_FALSE(contains(again().err, "restarts from the beginning"));
  }
  // Other options on the same tapes, killed by a store that is full: the new ones count.
  Outputs others;
  const Result full = run_shell("ulimit -f 60; " + run_command(folder, others, "--keep --stepping deck"));
  CHECK(full.status == 3);
  CHECK(others.files().empty());
  CHECK(run_shell(kProgram + "resume '" + folder + "'").status == 0);
  Outputs direct;
  REQUIRE(run_shell(run_command(tapes / "v", direct, "--stepping deck")).status == 0);
  CHECK(others.files() == direct.files());
}

TEST_CASE("resume: what cannot be resumed is said") {
  const Folder folder;
  Outputs outputs;
  CHECK(run_shell(kProgram + "resume").status == 64);
  CHECK(run_shell(kProgram + "resume a b").status == 64);
  CHECK(run_shell(kProgram + "resume a --csv b").status == 64);
  CHECK(run_shell(kProgram + "resume --help").status == 0);
  const Result none = run_shell(kProgram + "resume '" + folder.path() + "'");
  CHECK(none.status == 2);
  CHECK(contains(none.err, "no run"));
  // A name with everything in it comes back as it was.
  const std::string strange = folder / "a \\ b\nc=d";
  fs::copy_file(deck(), strange);
  const std::string tapes = folder / "tapes";
  const auto run = [&](const std::string& command) { return run_shell("cd '" + folder.path() + "' && " + kProgram + command); };
  const Result first = run("run 'a \\ b\nc=d' --keep --store 'file:" + tapes + "' --report 'r \\ n\ns.html'");
  REQUIRE_MESSAGE(first.status == 0, first.err);
  const std::string page = read_file(folder / "r \\ n\ns.html");
  fs::remove(folder / "r \\ n\ns.html");
  const Result second = run_shell("cd / && " + kProgram + "resume '" + tapes + "'");
  REQUIRE_MESSAGE(second.status == 0, second.err);
  CHECK(second.out == first.out);
  CHECK(read_file(folder / "r \\ n\ns.html").size() > page.size() / 2);
}

TEST_CASE("resume: a sketch's run tells again what errors were stated") {
  Outputs outputs;
  const Folder tapes;
  const std::string folder = tapes / "t", sketch = paths::root() + "/examples/fretting_pad.c2s";
  const std::string command = kProgram + "run '" + sketch + "' --store 'file:" + folder + "' --keep" + outputs.options() +
                              " --summary '" + (outputs.folder / "summary") + "' --report '" + (tapes / "page") + "'";
  const Result first = run_shell(command + " --memory 600000 --set q=10");
  REQUIRE_MESSAGE(first.status == 5, first.err);
  CHECK(contains(first.err, "the tolerance is 1 %, workspace of 600000 bytes is too small"));
  const auto expected = outputs.files(); // seconds of the meshes, too
  CHECK(contains(expected.at("/listing"), "cycle range of stress along top"));
  CHECK(contains(expected.at("/json"), "\"relative_error\""));
  for (const auto& file : expected) fs::remove(outputs.folder.path() + file.first);
  fs::remove(tapes / "page");
  CHECK(run_shell(kProgram + "resume '" + folder + "'").status == 5);
  CHECK(outputs.files() == expected);
  CHECK(contains(read_file(tapes / "page"), "Convergence over the meshes")); // there are times in it
  // The tapes begin anew, with what was stated.
  for (const auto& entry : fs::directory_iterator(folder + "/contact2d.store"))
    if (entry.path().extension() == ".c2d") fs::resize_file(entry.path(), fs::file_size(entry.path()) / 2);
  CHECK(run_shell(kProgram + "resume '" + folder + "'").status == 5);
  CHECK(outputs.files() == expected);
}

TEST_CASE("resume: a job of which a byte is wrong or missing is refused, and nothing is lost") {
  Outputs outputs;
  const Folder tapes;
  const std::string folder = tapes / "t", job = folder + "/contact2d.store/job";
  REQUIRE(run_shell(run_command(folder, outputs, "--keep")).status == 0);
  const auto expected = outputs.files();
  const std::string text = read_file(job);
  const auto refused = [&](const std::string& bytes) {
    write_file(job, bytes);
    const Result result = run_shell(kProgram + "resume '" + folder + "'");
    CHECK(result.status == 3);
    CHECK(contains(result.err, job + ": is "));
    CHECK(outputs.files() == expected);
  };
  for (size_t i = 0; i < text.size(); i += 1 + text.size() / 37) {
    CAPTURE(i);
    std::string flipped = text;
    flipped[i] = static_cast<char>(flipped[i] ^ (1 << i % 8));
    refused(flipped);
    refused(text.substr(0, i));
  }
  refused(text + "x");
  for (const auto& file : expected) fs::remove(outputs.folder.path() + file.first);
  write_file(job, text);
  CHECK(run_shell(kProgram + "resume '" + folder + "'").status == 0);
  CHECK(outputs.files() == expected);
}

TEST_CASE("resume: a job of another version, and one of other words") {
  const Folder folder;
  std::string error;
  fs::create_directory(folder / "contact2d.store");
  const std::string job = folder / "contact2d.store/job";
  const auto resumed = [&] { return run_shell(kProgram + "resume '" + folder.path() + "'"); };
  REQUIRE(app::write_sealed(job, "contact2d job 1", "", error));
  CHECK((resumed().status == 3 && contains(resumed().err, "has another version: 'contact2d job 1', expected")));
  REQUIRE(app::write_sealed(job, "contact2d job 2", "1\n", error));
  CHECK((resumed().status == 3 && contains(resumed().err, "has another version")));
  app::Job other;
  other.words = {"--no-such-option=3"};
  REQUIRE(app::keep_job(folder / "contact2d.store", other, error));
  CHECK((resumed().status == 3 && contains(resumed().err, "run takes no option --no-such-option")));
}

TEST_CASE("sealed files: every flipped bit and every length but the whole one is found") {
  const Folder folder;
  const std::string path = folder / "a", words = "some words\nend\n";
  std::string error, back;
  CHECK(app::read_sealed(path, "kind 1", back, error) == app::Sealed::kAbsent);
  write_file(path + ".new", "what a write that was cut off has left");
  REQUIRE(app::write_sealed(path, "kind 1", words, error));
  CHECK_FALSE(fs::exists(path + ".new"));
  REQUIRE(app::read_sealed(path, "kind 1", back, error) == app::Sealed::kWhole);
  CHECK(back == words);
  const std::string text = read_file(path);
  int found = 0;
  for (size_t i = 0; i < 8 * text.size(); ++i) {
    std::string flipped = text;
    flipped[i / 8] = static_cast<char>(flipped[i / 8] ^ (1 << i % 8));
    write_file(path, flipped);
    found += app::read_sealed(path, "kind 1", back, error) == app::Sealed::kFailed;
  }
  CHECK(found == static_cast<int>(8 * text.size()));
  for (size_t length = 0; length < text.size(); ++length) {
    write_file(path, text.substr(0, length));
    CHECK(app::read_sealed(path, "kind 1", back, error) == app::Sealed::kFailed);
  }
  CHECK_FALSE(app::write_sealed(folder / "no/such/folder", "kind 1", words, error));
  CHECK(contains(error, "no/such/folder: cannot be written: "));
  CHECK(app::remove_sealed(path, error));
  CHECK(app::remove_sealed(path, error));
}

TEST_CASE("resume: what a loop over meshes found, as a text and back") {
  app::MeshLoop loop;
  loop.rounds.resize(2);
  loop.rounds[0].elements = 12, loop.rounds[0].pressure = 0.1, loop.rounds[0].adapted = true;
  loop.rounds[1].seconds = 1.0 / 3, loop.rounds[1].curves = {{2, true, {{0.1, -1e300}, {HUGE_VAL, 5e-324}}}, {}};
  loop.taken = 1, loop.stopped = "a\nb\n";
  app::Stated number;
  number.what = app::Measure::kRangeAlong, number.of = "top", number.zone = 3, number.body = 1, number.value = -2.0 / 3;
  loop.stated = loop.rounds[1].stated = {number, app::Stated()};
  const std::string text = estimate::text_of(loop);
  app::MeshLoop back;
  REQUIRE(estimate::read_meshes(text, back));
  CHECK(estimate::text_of(back) == text);
  REQUIRE((back.rounds.size() == 2 && back.rounds[1].curves.size() == 2 && back.stated.size() == 2));
  CHECK((back.rounds[0].elements == 12 && back.rounds[0].pressure == 0.1 && back.rounds[0].adapted));
  CHECK((back.rounds[1].curves[0].closed && back.rounds[1].curves[0].ends == loop.rounds[1].curves[0].ends));
  CHECK((back.rounds[1].seconds == 1.0 / 3 && std::isnan(back.rounds[1].pressure) && !back.rounds[1].adapted));
  CHECK((back.stated[0].name() == "range of stress along top" && back.stated[0].value == -2.0 / 3 &&
         std::isnan(back.stated[0].error)));
  CHECK((back.taken == 1 && back.stopped == loop.stopped));
  for (size_t length = 0; length < text.size(); ++length) {
    CAPTURE(length);
    CHECK_FALSE(estimate::read_meshes(text.substr(0, length), back));
  }
  CHECK_FALSE(estimate::read_meshes(text + "1\n", back));
  CHECK_FALSE(estimate::read_meshes("99999999999999\n" + text, back)); // more rounds than there are bytes
  loop.taken = 2;
  CHECK_FALSE(estimate::read_meshes(estimate::text_of(loop), back));
}
