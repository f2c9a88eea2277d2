// `contact2d run` of a deck with a cycle below *PATH: listing, JSON, exit statuses, faults, and resume within the cycles.
#include "json.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace test;

namespace {

const std::string kProgram = "'" + paths::program() + "' ";

// Like bodies pressed together and sheared to and fro, as `contact2d make mindlin`; `card` stands before the shear.
std::string deck_with(const std::string& card, const std::string& last = "2 1 0") {
  static const std::string plain = run_shell(kProgram + "make mindlin n=5").out;
  const size_t at = plain.find("*PATH");
  REQUIRE(at != std::string::npos);
  return plain.substr(0, at) + "*PATH\n1 1 0\n" + card + "2 1 1\n2 1 -1\n" + last + "\n";
}

// A rigid cylinder on a block, pressed to 1, 0.4 and 1.
std::string rigid_cylinder(const std::string& card) {
  static std::string plain;
  if (plain.empty()) {
    const Folder folder;
    write_file(folder / "s.c2s", "body block E {1-(2/7)^2} nu {2/7}\nfrom -1 -2\nline bottom to 1 -2\nline right to 1 0\n"
                                 "line top to -1 0\nline left close\nbody cylinder rigid\nfrom -0.3 {1-sqrt(0.91)}\n"
                                 "arc face to 0.3 {1-sqrt(0.91)} radius 1\nline right to 0.3 0.5\nline above to -0.3 0.5\n"
                                 "line left close\ncontact block.top cylinder.face mu 0.3\ncase normal\n"
                                 "platen block.bottom about 0 -2 fx 0 fy {pi/400} turn 0\nhistory normal 1\ntolerance off\n"
                                 "elements cylinder.face 30\n");
    plain = run_shell(kProgram + "mesh '" + (folder / "s.c2s") + "'").out;
  }
  const size_t at = plain.find("*PATH");
  REQUIRE(at != std::string::npos);
  return plain.substr(0, at) + "*PATH\n2 1\n" + card + "1 0.4\n1 1\n";
}

// "FILE:12:1: error: text" of the first fault, without the file's name.
std::string fault_of(const std::string& deck) {
  const Folder folder;
  write_file(folder / "d.dat", deck);
  const Result result = run_shell(kProgram + "check '" + (folder / "d.dat") + "'");
  CHECK(result.status == 2);
  const size_t at = result.err.find("d.dat:");
  return at == std::string::npos ? result.err : result.err.substr(at + 6, result.err.find('\n', at) - at - 6);
}

int line_of(const std::string& deck, const std::string& card) {
  int line = 1;
  for (const std::string& one : lines_of(deck)) {
    if (one == card) return line;
    ++line;
  }
  return 0;
}

} // namespace

TEST_CASE("program, cycle: listing and JSON say what the cycle came to; like bodies are steady in the second one") {
  const Folder folder;
  const std::string name = folder / "d.dat";
  write_file(name, deck_with("cycle\n"));
  const Result whole = run_shell(kProgram + "run '" + name + "' --listing - --json '" + (folder / "j") + "' --csv '" +
                                 (folder / "c") + "' --trace '" + (folder / "t") + "'");
  CHECK(whole.status == 0);
  CHECK(contains(whole.out, "\nCycles\n"));
  CHECK(contains(whole.out, "  steady in cycle 2: pairs slip forth and back by the same amount\n"));
  CHECK(contains(whole.out, "  the cycle is steady in cycle 2: pairs slip"));
  CHECK(contains(whole.out, "\n   cycle "));
  const std::string json = read_file(folder / "j");
  const Json cycles = JsonReader::read(json).members.at("cycles");
  CHECK((cycles.items.size() == 1 && cycles.items[0].members.at("cycles").items.size() == 2));
  CHECK(contains(json, "\"result\": \"slips\""));
  CHECK(contains(json, "\"cycle\": 2, \"extrapolations\": 0"));
  CHECK(contains(json, "\"outcome\": \"reached\""));
  // Without the card: the second time round is the steady one, and the numbers of its last state are the same.
  write_file(folder / "p.dat", deck_with("") + "2 1 1\n2 1 -1\n2 1 0\n");
  REQUIRE(run_shell(kProgram + "run '" + (folder / "p.dat") + "' --quiet --csv '" + (folder / "q") + "'").status == 0);
  const std::vector<std::string> a = lines_of(read_file(folder / "c")), b = lines_of(read_file(folder / "q"));
  REQUIRE(a.size() < b.size());
  const auto column = [](const std::string& row, size_t n) {
    size_t at = 0;
    for (size_t i = 0; i < n; ++i) at = row.find(',', at) + 1;
    return std::atof(row.c_str() + at);
  };
  const size_t pairs = static_cast<size_t>(column(a.back(), 3));
  double largest = 0, apart = 0;
  for (size_t i = 1; i <= pairs; ++i) {
    largest = std::fmax(largest, std::fabs(column(b[b.size() - i], 7)));
    apart = std::fmax(apart, std::fabs(column(a[a.size() - i], 8) - column(b[b.size() - i], 8)));
  }
  CHECK((largest > 0 && apart < 1e-9 * largest));
}

TEST_CASE("program, cycle: not steady at its limit is exit status 1, with all that was reached") {
  const Folder folder;
  const std::string name = folder / "d.dat";
  write_file(name, rigid_cylinder("cycle 3\n"));
  const Result result =
      run_shell(kProgram + "run '" + name + "' --listing '" + (folder / "l") + "' --json '" + (folder / "j") + "'");
  CHECK(result.status == 1);
  CHECK(contains(result.err,
                 "the cycle is not steady after 3 cycles: over the last one pressures, friction or gaps changed by "));
  const std::string json = read_file(folder / "j"), listing = read_file(folder / "l");
  CHECK(JsonReader::read(json).has("cycles"));
  CHECK((contains(json, "\"outcome\": \"not steady\"") && contains(json, "\"result\": \"not steady\"")));
  CHECK((contains(listing, "  not steady after 3 cycles: ") && contains(listing, "Contact in numbers")));
}

TEST_CASE(
    "program, cycle: compared with a start without friction, a contact that sticks ends elsewhere, one that slides does not") {
  const Folder folder;
  const auto compared = [&folder](const std::string& deck, const std::string& words) {
    write_file(folder / "d.dat", deck);
    const Result run = run_shell(kProgram + "run '" + (folder / "d.dat") + "' --listing - --json '" + (folder / "j") + "'");
    CHECK_MESSAGE(contains(run.out, words), run.out);
    return JsonReader::read(read_file(folder / "j")).members.at("cycles").items[0];
  };
  const auto number = [](const Json& json, const char* name) { return json.members.at(name).number; };

  const Json unlike = compared(rigid_cylinder("cycle 30 Compare ! both starts\n"),
                               "  a start without friction ends in another cycle: the state depends on how the loads began; "
                               "pressures and friction differ by 0.");
  const Json& other = unlike.members.at("frictionless");
  CHECK((number(other, "same") == 0 && number(other, "difference") > 1e-2));
  // The same as a run that starts so.
  const Json alone = compared(rigid_cylinder("cycle 30 frictionless\n"), "  steady in cycle ");
  CHECK(!alone.has("frictionless"));
  const double expected = number(alone.members.at("cycles").items.back(), "dissipated");
  CHECK(std::fabs(number(other.members.at("last"), "dissipated") - expected) <= 1e-9 * expected);
  CHECK(std::fabs(number(unlike.members.at("cycles").items.back(), "dissipated") - expected) > 1e-3 * expected);

  // Where all pairs slide to and fro nothing is left of the start.
  std::string sliding = deck_with("");
  sliding = sliding.substr(0, sliding.find("*PATH")) + "*PATH\n1 1 0\ncycle compare\n1 1 2\n1 1 -2\n1 1 0\n";
  const Json like = compared(sliding, "  a start without friction ends in the same cycle; ");
  const Json& same = like.members.at("frictionless");
  CHECK((number(same, "same") == 1 && number(same, "difference") < 1e-9));
}

TEST_CASE("program, cycle: faults of the card and of the cycle, with line and column") {
  const auto at = [](const std::string& deck, const std::string& card, const std::string& rest) {
    return std::to_string(line_of(deck, card)) + rest;
  };
  std::string deck = deck_with("cycle 20\n", "2 1 0.1");
  CHECK(fault_of(deck) ==
        at(deck, "cycle 20", ":1: error: the cycle does not close: its last load is not the one at which it begins"));
  deck = deck_with("cycle 0\n");
  CHECK(fault_of(deck) == at(deck, "cycle 0", ":7: error: limit of cycles is 0, expected 1 to 1000000"));
  deck = deck_with("cycle 5 smooth\n");
  CHECK(contains(fault_of(deck), at(deck, "cycle 5 smooth", ":9: error: ")));
  deck = deck_with("cycle\ncycle 3\n");
  CHECK(fault_of(deck) == at(deck, "cycle 3", ":1: error: a second cycle below *PATH, expected one"));
  deck = deck_with("", "cycle\n2 1 0");
  CHECK(fault_of(deck) ==
        at(deck, "cycle", ":1: error: the cycle has 1 card below it, expected two or more: increments f1 ... fn"));
  deck = deck_with("", "1 1 0\ncycle");
  CHECK(fault_of(deck) ==
        at(deck, "cycle", ":1: error: the cycle has 0 cards below it, expected two or more: increments f1 ... fn"));
  deck = deck_with("");
  deck.insert(deck.find("1 1 0\n2 1 1\n"), "cycle\n");
  CHECK(fault_of(deck) == at(deck, "cycle",
                             ":1: error: the cycle has no segment of the path before it, expected one that leads "
                             "to its first load"));
}

TEST_CASE("program, cycle: stopped within the cycles and resumed, the outputs are those of one run") {
  const Folder folder;
  const std::string name = folder / "d.dat";
  write_file(name, rigid_cylinder("cycle 30\n"));
  const auto files = [&](const std::string& which) {
    std::string out;
    for (const char* file : {"csv", "json", "listing", "bodies"})
      for (const std::string& line : lines_of(read_file(folder / (which + "." + file))))
        if (!contains(line, "\"seconds\"")) out += line + "\n";
    return out;
  };
  const auto options = [&](const std::string& which) {
    std::string out = " --no-progress --save-every 0 --store 'file:" + (folder / which) + "'";
    for (const char* file : {"csv", "json", "listing", "bodies"})
      out += std::string(" --") + file + " '" + (folder / (which + "." + file)) + "'";
    return out;
  };
  REQUIRE(run_shell(kProgram + "run '" + name + "'" + options("whole")).status == 0);
  const std::string expected = files("whole");
  CHECK(contains(expected, "\"cycle\": 3"));
  // A signal ends the run at the next state that can be saved, which the limit of processor time makes any of them.
  int resumed = 0;
  for (int n = 1; n <= 5; n += 2) {
    const std::string which = "part" + std::to_string(n), delay = "0.0" + std::to_string(2 * n);
    const Result stopped = run_shell("timeout -s TERM " + delay + " " + kProgram + "run '" + name + "'" + options(which));
    const bool is_stopped = fs::exists((folder / which) + "/contact2d.store/job");
    if (is_stopped) {
      const Result result = run_shell(kProgram + "resume '" + (folder / which) + "'");
      CHECK_MESSAGE(result.status == 0, result.err);
      ++resumed;
    }
    if (fs::exists(folder / (which + ".json"))) CHECK(files(which) == expected);
  }
  MESSAGE("resumed: " << resumed);
}
