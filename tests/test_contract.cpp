// The header's own words on errors, effects and states, against what the functions do: calls in any order with any arguments,
// in any state, with a store, callbacks and cancels that fail at every moment (tests/fuzz/calls.hpp goes on from here).
#include "fuzz/calls.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <regex>
#include <set>

using namespace calls;

namespace {

const std::string kHeader = test::read_file(paths::root() + "/include/contact2d.h");

// A function as the header tells it.
struct Told {
  uint32_t errors = 0;
  int32_t section = 0;
  bool of_solver = false;
};

uint32_t errors_of(const std::string& comment, const std::map<std::string, Told>& before) {
  const size_t at = comment.rfind("Errors");
  if (at == std::string::npos) return kNone;
  const std::string list = comment.substr(at);
  static const std::pair<const char*, Errors> words[] = {
      {"OVERFLOW", kOverflow},   {"MEMORY", kMemory},     {"LIMIT", kLimit},       {"INPUT", kInput},  {"READ", kRead},
      {"CANCELLED", kCancelled}, {"SINGULAR", kSingular}, {"CALLBACK", kCallback}, {"STORE_", kStore}, {"MISMATCH", kMismatch}};
  uint32_t out = kNone;
  for (const auto& [word, error] : words)
    if (std::regex_search(list, std::regex(std::string("(^|[^_A-Z])") + word))) out |= error;
  std::smatch other;
  if (std::regex_search(list, other, std::regex("as c2d_(\\w+)"))) out |= before.at(other[1].str()).errors;
  return out;
}

// All functions that return a status, with the comment that each stands below.
std::map<std::string, Told> told_functions() {
  std::map<std::string, Told> out;
  std::string comment;
  int32_t section = 0;
  bool inside = false, declared = false;
  for (const std::string& line : test::lines_of(kHeader)) {
    std::smatch found;
    if (std::regex_search(line, found, std::regex("^/\\* -+ ([1-9]) "))) section = std::stoi(found[1].str());
    if (line.compare(0, 2, "/*") == 0) inside = true, declared = false, comment.clear();
    if (line.empty() && declared) comment.clear();
    if (inside) comment += line + "\n";
    if (test::contains(line, "*/")) inside = false;
    if (!std::regex_search(line, found, std::regex("^c2d_status c2d_(\\w+)\\((const )?(c2d_solver\\*\\*?)?"))) continue;
    declared = true;
    Told& told = out[found[1].str()];
    told.errors = errors_of(comment, out), told.section = section, told.of_solver = found[3].str() == "c2d_solver*";
  }
  return out;
}

// Of section 9: the states in which each call is legal.
class States {
public:
  States() {
    const size_t from = kHeader.find("   State        legal calls"), to = kHeader.find("*/", from);
    static const std::pair<const char*, uint32_t> names[] = {
        {"State", 0},          {"empty", kEmpty},   {"building", kBuilding}, {"model", kModel}, {"prepared", kPrepared},
        {"running", kRunning}, {"broken", kBroken}, {"In", kComplete}};
    size_t row = 8;
    for (const std::string& line : test::lines_of(kHeader.substr(from, to - from))) {
      for (size_t i = 0; i < 8; ++i)
        if (line.compare(0, 4 + std::string(names[i].first).size(), "   " + (names[i].first + std::string(" "))) == 0) row = i;
      if (row < 8) rows_.emplace_back(names[row].second, row == 0 ? line : line.substr(0, line.find("->")));
    }
  }
  uint32_t legal(const std::string& name, const Told& told) const {
    if (!told.of_solver || is_in(0, name)) return kAlways;
    if (told.section == 5 && name != "set_units" && name != "get_name" && name != "set_name") { // (what comes as late as this)
      uint32_t out = name == "complete" ? kBuilding : kFirst;
      return is_in(kModel, name) ? out | kModel : out;
    }
    if (name == "get_name" || name == "set_name") return legal("set_units", told);
    uint32_t out = told.section == 5 ? kFirst : kNone;
    for (const uint32_t state : {kEmpty, kModel, kPrepared, kRunning, kBroken})
      if (is_in(state, name)) out |= state;
    return is_in(kComplete, name) ? out | kComplete : out;
  }

private:
  bool is_in(uint32_t state, const std::string& name) const {
    const bool of_list = name.compare(0, 4, "get_") == 0;
    for (const auto& [which, text] : rows_)
      if (which == state && (std::regex_search(text, std::regex("[ (,]" + name + "([ ,:;.)]|$)")) ||
                             (of_list && state == kComplete && test::contains(text + ",", " " + name.substr(3)))))
        return true;
    return false;
  }
  std::vector<std::pair<uint32_t, std::string>> rows_;
};

// A stranger whose bytes are at an end: every argument is as the model wants it.
Driver plain(int variant) {
  static uint8_t first[kVariants];
  first[variant] = static_cast<uint8_t>(variant);
  return Driver(&first[variant], 1);
}

const Function& function_of(const std::string& name) {
  for (const Function& f : Driver::functions())
    if (name == f.name) return f;
  REQUIRE(name == "is known");
  return Driver::functions().front();
}

} // namespace

TEST_CASE("contract: the errors that the tests allow each function are those of the header") {
  const std::map<std::string, Told> told = told_functions();
  const std::set<std::string> apart = {"create", "attach", "close", "scan_deck", "check_deck"}; // the next but one
  std::set<std::string> known;
  for (const Function& f : Driver::functions()) {
    INFO("c2d_", std::string(f.name));
    known.insert(f.name);
    REQUIRE(told.count(f.name) == 1);
    const Told& t = told.at(f.name);
    // "Each of these calls may return C2D_ERR_LIMIT"; "all but what only tells the model may return STORE_..."
    const uint32_t more = t.section == 5 && t.of_solver ? kLimit : t.section == 8 && t.of_solver ? kStore : kNone;
    CHECK((f.errors & ~(t.errors | more)) == 0);
    CHECK((t.errors & ~f.errors) == 0);
  }
  for (const auto& entry : told) CHECK_MESSAGE(known.count(entry.first) + apart.count(entry.first) == 1, entry.first);
  CHECK(told.at("create").errors == (kOverflow | kMemory));
  CHECK(told.at("close").errors == kStore);
  CHECK(told.at("attach").errors == (kMismatch | kMemory | kStore));
}

TEST_CASE("contract: the states in which each function is legal are those of the header") {
  const std::map<std::string, Told> told = told_functions();
  const States states;
  for (const Function& f : Driver::functions()) {
    INFO("c2d_", std::string(f.name));
    CHECK(states.legal(f.name, told.at(f.name)) == f.legal);
  }
}

TEST_CASE("contract: thousands of calls in any order, with any arguments, in any state: the header holds") {
  std::mt19937 random(14);
  std::map<std::string, std::set<c2d_status>> seen;
  std::map<std::string, std::set<int32_t>> went_through;
  int calls = 0;
  for (int i = 0; i < 1000; ++i) {
    Bytes bytes(200 + random() % 600);
    for (unsigned char& b : bytes) b = static_cast<unsigned char>(random());
    for (size_t k = 1; k < bytes.size(); k += 40)
      bytes[k] = static_cast<unsigned char>(224 + random() % 32); // from state to state
    Driver driver(bytes.data(), bytes.size());
    driver.seen = [&](const Driver::Seen& s) {
      ++calls;
      seen[s.function].insert(s.status);
      if (s.status == C2D_OK) went_through[s.function].insert(s.before);
    };
    driver.run();
    INFO("stranger ", i);
    REQUIRE(driver.violation == "");
  }
  CHECK(calls > 25000);
  for (const Function& f : Driver::functions()) {
    INFO("c2d_", std::string(f.name));
    CHECK(seen[f.name].count(C2D_ERR_STATE) + seen[f.name].count(C2D_ERR_ARGUMENT) + went_through[f.name].size() > 0);
    if (f.legal != kAlways && (f.legal & kEmpty) == 0) CHECK(seen[f.name].count(C2D_ERR_STATE) == 1);
    for (const int32_t state : went_through[f.name]) CHECK((f.legal & bit(state)) != 0);
  }
  CHECK(went_through.size() > 40); // (a model is made by the same calls in tests/fuzz/small_model.hpp)
  CHECK(seen["begin"].count(C2D_ERR_ARGUMENT) + seen["advance"].count(C2D_ERR_ARGUMENT) + seen["get"].count(C2D_ERR_ARGUMENT) ==
        3);
}

TEST_CASE("contract: the store, cancels and callbacks fail at every moment of every call; the memory is then as good as new") {
  struct Place {
    const char* name;
    int state; // of bring_on
  };
  const Place places[] = {{"read_deck", 0}, {"complete", 0},   {"prepare", 1},    {"begin", 2},          {"run", 2},
                          {"advance", 3},   {"next_event", 3}, {"save", 4},       {"restore", 5},        {"run", 5},
                          {"get", 4},       {"interior", 4},   {"indicators", 4}, {"get_zone_state", 4}, {"get_body_state", 4}};
  std::map<std::string, int> fired;
  int cases = 0;
  for (const int variant : {0, kTied | 0, kDeckStepping | 0, kKeepFactors | kFree | kStreamed})
    for (const Place& place : places)
      for (const char kind : std::string("orwscpqtl"))
        for (int n = 0; n < 100000; ++n) {
          Driver driver = plain(variant);
          driver.bring_on(place.state);
          driver.arm(kind, n);
          c2d_status status = C2D_OK;
          driver.seen = [&](const Driver::Seen& s) { status = s.status; };
          driver.one(function_of(place.name));
          const bool went_off = driver.went_off();
          INFO("c2d_", std::string(place.name), ", variant ", variant, ", '", kind, "' at ", n, ", status ", status);
          REQUIRE(driver.violation == "");
          if (!went_off) break;
          ++cases;
          ++fired[std::string(1, kind)];
          if (n % 7 == 0) { // once more from the beginning, and it goes through
            driver.bring_on(7);
            driver.bring_on(5);
            REQUIRE(driver.violation == "");
            REQUIRE(c2d_get_state(driver.solver()) == C2D_STATE_RUNNING);
          }
          if (n > 400) n += 36; // (cancels are asked for very often)
        }
  CHECK(cases > 3000);
  for (const char kind : std::string("orwscpqt")) CHECK_MESSAGE(fired[std::string(1, kind)] > 0, kind);
}
