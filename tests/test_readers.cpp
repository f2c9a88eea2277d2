// What the readers of the program and of the library do with hostile input: numbers near 2^31, faults beyond the last that is
// told, files of blank lines, signals amid a read, text that no deck can hold.
#include "paths.hpp"
#include "shell.hpp"

#include "program/files/deck_file.hpp"
#include "program/options.hpp"
#include "program/sketch/read/read.hpp"

#include <contact2d.h>

#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <thread>

using namespace test;

namespace {

// Two squares, one on the other, with a zone between them, quadratic functions.
std::string two_squares(const std::string& zone_card, const std::string& keywords) {
  std::string out = "*FREE\n1\nTWO SQUARES\n0 2\n2 1 3\n1 2 4 4\n1 2 4 4\n1 4\n1 4\n1000 0.3\n2000 0.25\n1 0.3\n";
  for (int body = 0; body < 2; ++body) {
    const std::string low = std::to_string(body), high = std::to_string(body + 1);
    out += "0 0\n1 0 " + low + "\n2 1 " + low + "\n3 1 " + high + "\n4 0 " + high + "\n";
  }
  return out + "2\n1 1 1100 0 0 0 0\n1 1 3 1100 0 0 0 0\n0\n1\n3 1 0011 0 -1 0 0\n0\n" + zone_card +
         "\n3 3 1 1\n7 5 1 3\n3 1\n3 1\n1 10\n2 1\n" + keywords;
}

int32_t next_line(void* context, char* text, int32_t size) { return app::DeckFile::read_line(context, text, size); }

struct Told {
  std::vector<std::string> texts;
  static void add(void* context, const c2d_error* entry) { static_cast<Told*>(context)->texts.push_back(entry->text); }
};

struct Checked {
  c2d_status status;
  std::vector<std::string> faults;
  c2d_limits limits = C2D_INIT(c2d_limits);
  std::vector<c2d_body_limits> bodies;
};

Checked check(const std::string& deck) {
  app::DeckFile file;
  file.replace(deck);
  Checked out;
  out.bodies.resize(4);
  out.limits.bodies = 4, out.limits.body = out.bodies.data();
  Told told;
  out.status = c2d_check_deck(next_line, &file, &out.limits, Told::add, &told);
  out.faults = told.texts;
  return out;
}

std::vector<std::string> faults_of_sketch(const std::string& text) {
  std::vector<std::string> out;
  const auto no_file = [](const std::string&, std::string&) { return false; };
  for (const sketch::Fault& fault : sketch::read_sketch(text, {}, no_file).faults)
    out.push_back(std::to_string(fault.at.line) + ": " + fault.text);
  return out;
}

const std::string kSquare =
    "body a E 1 nu 0.3\n from 0 0\n line b to 1 0\n line r to 1 1\n line top to 0 1\n line l close\nfix a.b\npressure a.r 1\n";
const std::string kOther = "body b E 1 nu 0.3\n from 0 1\n line b to 1 1\n line r to 1 2\n line top to 0 2\n line l close\n";

} // namespace

TEST_CASE("readers: a zone of elements near 2^31 is told with its numbers, none of which has gone round") {
  REQUIRE(check(two_squares("1 2 3 1", "")).status == C2D_OK);
  const Checked most = check(two_squares("1 2 4 1", ""));
  REQUIRE(most.status == C2D_ERR_INPUT);
  CHECK(contains(most.faults[0], "expected at most 3 on 1 elements"));
  // Twice 2^30 is -2^31 in 32 bits, and what is expected would be less than what is there.
  for (const char* elements : {"1073741824", "2147483647"}) {
    const Checked large = check(two_squares(std::string("1 2 3 ") + elements, ""));
    REQUIRE(large.status == C2D_ERR_INPUT);
    for (const std::string& fault : large.faults) CHECK(!contains(fault, "number of contact nodes of the zone is 3"));
    CHECK(contains(large.faults[0], "contact elements 3 to 3 of body 1 make 1, expected " + std::string(elements)));
  }
}

TEST_CASE("readers: what has faults beyond the last that is told reaches no call of the model") {
  Checked sound = check(two_squares("1 2 3 1", "*POINTS\npoint 1 0.5 0.5\n*BODY FORCE 1 1 0 -1\n"));
  REQUIRE(sound.status == C2D_OK);
  std::string hundred = "*POINTS\n";
  for (int i = 0; i < 100; ++i) hundred += "point 9 0.5 0.5\n";
  for (const char* last :
       {"*BODY FORCE 9 0 0 -1\n", "*RIGID LOAD 9 0 0\n1 0 0 0\n", "*RIGID 9\n", "*PLATEN 1 9 9 0 0\n1 UX 1\n"}) {
    INFO(last);
    app::DeckFile file;
    file.replace(two_squares("1 2 3 1", hundred + last));
    uint64_t bytes = 0;
    REQUIRE(c2d_memory_need(&sound.limits, &bytes, nullptr, nullptr) == C2D_OK);
    std::vector<unsigned char> memory(bytes);
    Told told;
    c2d_port port = C2D_INIT(c2d_port);
    port.context = &told;
    port.log = Told::add;
    c2d_solver* solver = nullptr;
    REQUIRE(c2d_create(&solver, memory.data(), memory.size(), &sound.limits, &port, nullptr) == C2D_OK);
    CHECK(c2d_read_deck(solver, next_line, &file) == C2D_ERR_INPUT);
    REQUIRE(told.texts.size() == 101);
    CHECK(contains(told.texts[99], "body number is 9, expected 1 to 2"));
    CHECK(told.texts[100] == "too many faults, the rest of the deck was not read");
    c2d_close(solver);
  }
}

TEST_CASE("readers: cards of a file, in turn and at random") {
  std::string text;
  for (int line = 1; line <= 1000; ++line) text += std::to_string(line) + (line % 3 == 0 ? "\r\n" : "\n");
  app::DeckFile file;
  file.replace(text + "last");
  REQUIRE(file.cards() == 1001);
  for (size_t line = 1; line <= 1000; ++line) CHECK(file.card(line) == std::to_string(line));
  for (size_t line : {1000u, 1u, 64u, 65u, 63u, 64u, 128u, 129u, 999u, 2u, 2u, 1u})
    CHECK(file.card(line) == std::to_string(line));
  CHECK(file.card(1001) == "last");
  CHECK(file.card(0).empty());
  CHECK(file.card(1002).empty());
  file.replace("a\n\n\nb\n");
  REQUIRE(file.cards() == 4);
  CHECK(file.card(4) == "b");
  CHECK(file.card(2).empty());
  file.replace("");
  CHECK(file.cards() == 0);
  CHECK(file.card(1).empty());
}

TEST_CASE("readers: the list of bodies is as long as the deck says, and not longer than its cards allow") {
  app::DeckFile file;
  file.replace(two_squares("1 2 3 1", ""));
  CHECK(app::room_for_bodies(file).size() == 2);
  file.replace("*FREE\n1\nT\n0 0\n2147483647 0 2\n" + std::string(8000, '\n'));
  CHECK(app::room_for_bodies(file).size() == app::most_bodies(file));
  CHECK(app::most_bodies(file) < 1010);
  file.replace(std::string(1000000, '\n'));
  CHECK(app::room_for_bodies(file).size() == 1);
  file.replace("");
  CHECK(app::room_for_bodies(file).size() == 1);
}

TEST_CASE("readers: 48 MB of blank lines take little memory, and reading takes little stack") {
  if (paths::sanitized()) return; // the sanitizer has memory of its own
  const Folder folder;
  const std::string program = "'" + paths::program() + "' ", blank = folder / "blank.dat";
  write_file(blank, std::string(48 << 20, '\n'));
  const Result result = run_shell("ulimit -v 300000; " + program + "check '" + blank + "'");
  CHECK(result.status == 2);
  CHECK(contains(result.err, "blank.dat:1:"));
  CHECK(!contains(result.err, "no memory left"));
  CHECK(run_shell("ulimit -s 64; " + program + "check '" + paths::root() + "/examples/hertz.dat'").status == 0);
}

TEST_CASE("readers: more increments than can be kept are refused before anything is solved") {
  const Folder folder;
  const std::string command =
      "'" + paths::program() + "' run '" + (folder / "deck.dat") + "' --csv '" + (folder / "out.csv") + "'";
  const auto with_path = [](const std::string& cards) { return two_squares("1 2 3 1", "*PATH\n" + cards); };
  for (const char* cards : {"2147483647 1\n", "2147483647 1\n2147483647 2\n", "400000 1\n100001 0\n"}) {
    write_file(folder / "deck.dat", with_path(cards));
    const Result result = run_shell("ulimit -t 20; " + command);
    CHECK(result.status == 2);
    CHECK(contains(result.err, "expected at most 500000 in all"));
    CHECK(folder.names().size() == 1);
  }
  write_file(folder / "deck.dat", with_path("3 1\n2 0.5\n"));
  CHECK(run_shell(command).status == 0);
}

namespace {
volatile std::sig_atomic_t g_alarms = 0;
void count_alarm(int) { g_alarms = g_alarms + 1; }
} // namespace

TEST_CASE("readers: a signal amid a read does not end it") {
  const Folder folder;
  const std::string pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  struct sigaction act = {}, before = {};
  act.sa_handler = count_alarm; // without SA_RESTART: a read that waits returns with EINTR
  ::sigaction(SIGALRM, &act, &before);
  std::thread writer([&] {
    sigset_t all;
    sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, nullptr);
    const int file = ::open(pipe.c_str(), O_WRONLY);
    for (const char* part : {"first\n", "second\n"}) {
      std::this_thread::sleep_for(std::chrono::milliseconds(120));
      if (::write(file, part, std::char_traits<char>::length(part)) < 0) break;
    }
    ::close(file);
  });
  const itimerval often = {{0, 20000}, {0, 60000}}, never = {};
  app::DeckFile file;
  c2d_error fault = C2D_INIT(c2d_error);
  const int kept = ::open(pipe.c_str(), O_RDONLY); // so that the opening below does not wait: it is not what is tested
  g_alarms = 0;
  ::setitimer(ITIMER_REAL, &often, nullptr);
  const bool read = file.read(pipe, fault);
  ::setitimer(ITIMER_REAL, &never, nullptr);
  ::close(kept);
  writer.join();
  ::sigaction(SIGALRM, &before, nullptr);
  CHECK(g_alarms > 0);
  CHECK_MESSAGE(read, fault.text);
  CHECK(file.text() == "first\nsecond\n");
}

TEST_CASE("readers: a zero byte is told with its place") {
  const Folder folder;
  write_file(folder / "a", std::string("1\nab\0c\n", 7));
  write_file(folder / "b", std::string("\0", 1));
  for (const auto& [name, line, column] : {std::tuple<const char*, int, int>{"a", 2, 3}, {"b", 1, 1}}) {
    app::DeckFile file;
    c2d_error fault = C2D_INIT(c2d_error);
    CHECK(!file.read(folder / name, fault));
    CHECK(fault.status == C2D_ERR_INPUT);
    CHECK(fault.line == line);
    CHECK(fault.column == column);
  }
}

TEST_CASE("readers: a folder to resume may begin with a dash") {
  const auto read = [](std::vector<const char*> words, app::Options& options) {
    words.insert(words.begin(), {"contact2d", "resume"});
    std::string error;
    app::read_options(static_cast<int>(words.size()), words.data(), options, error);
    return error;
  };
  app::Options options;
  CHECK(read({"--", "-dir"}, options) == "");
  CHECK(options.folder == "-dir");
  options = {};
  CHECK(read({"--no-progress", "--", "--help"}, options) == "");
  CHECK(options.folder == "--help");
  CHECK(options.command == app::Command::kResume);
  options = {};
  CHECK(read({"--"}, options) == "resume needs a folder");
  options = {};
  CHECK(read({"--", "a", "--"}, options) == "more than one folder: a and --");
}

TEST_CASE("readers: a sketch says what its deck could not hold") {
  CHECK(faults_of_sketch("title plain\tand ! caf\xe9\nunits mm N\n" + kSquare).empty());
  const auto only = [](const std::string& text, const std::string& expected) {
    const std::vector<std::string> faults = faults_of_sketch(text);
    INFO(text);
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0], expected));
  };
  only("title caf\xc3\xa9\n" + kSquare, "1: the title has a character that is not printable ASCII");
  only(std::string("title a\x01") + "b\n" + kSquare, "1: the title has a character");
  for (const char* unit : {"\"\"", "\"m m\"", "\"m,\"", "\xc2\xb5m", "\"!\""})
    only("units " + std::string(unit) + " N\n" + kSquare, "1: the name of a unit is not one word");
  const std::string tie = "tie a.top b.b name ";
  CHECK(faults_of_sketch(kSquare + kOther + tie + "\"gr\xc3\xb6\xc3\x9f te\"\n").empty());
  only(kSquare + kOther + tie + "gr\xf6\xdf\n", "15: the name of the interface is not text in UTF-8");
  only(kSquare + kOther + tie + "a\xed\xa0\x80\n", "15: the name of the interface is not text in UTF-8");
  only(kSquare + kOther + tie + "a\x7f\n", "15: the name of the interface is not text in UTF-8");
  for (const char* name : {"\"\"", "\" a\"", "\",a\""})
    only(kSquare + kOther + tie + name + "\n", "without a blank or a comma at its start");
  only("parameter much 1e100\n" + kSquare, "1: '1e100' is too large, expected a magnitude below 1e100");
  CHECK(contains(faults_of_sketch("parameter least 1e-310\nbody a E least nu 0.3\n").at(0), "2:")); // none, on a card
  only("parameter much -10^200\n" + kSquare, "1: '-10^200' is too large, expected a magnitude below 1e100");
}
