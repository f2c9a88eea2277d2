// Names of bodies and zones: calls, cards, and that they stand beside the numbers wherever these are told.
#include "contact2d_cards.h"
#include "json.hpp"
#include "memory/text.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <regex>

using namespace runs;
using test::contains;
using test::Folder;
using test::Result;

namespace {

// A stack of three plates, 2 wide and 1 high, as a deck; two zones. What can be wrong with it:
struct Stack {
  double overlap = 0, shift = 0; // of the second plate
  double top = -1, far = 1;      // traction on the third; factor of that
  int32_t plates_moved_in = 0;   // boundary point of body 2 that is moved into it
  const char* mu = "0.3";
  const char* points = "0"; // point loads of body 2: their number, and their cards
  bool held_side = false;   // ux of body 1 held up to the contact
  const char* keywords = "";

  Deck deck(const std::string& names = "") const;
};

const char* const kNames = "*NAME BODY 1 plate\n*NAME BODY 2 \xc3\x96lring \xe2\x9c\x93\n*NAME BODY 3 bolt, M8\n"
                           "*NAME ZONE 1 lower\n*name zone 2 upper ! of two\n";
const std::map<std::string, std::string> kNamed = {{"body 1", " (plate)"},
                                                   {"body 2", " (\xc3\x96lring \xe2\x9c\x93)"},
                                                   {"body 3", " (bolt, M8)"},
                                                   {"zone 1", " (lower)"},
                                                   {"zone 2", " (upper)"}};

std::string number(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

Deck deck_of(const std::string& text) {
  Deck deck;
  deck.lines = test::lines_of(text);
  return deck;
}

host::Limits limits_of(Deck deck) {
  host::Limits out;
  out.bodies = host::Limits::kRoom;
  c2d_error why = C2D_INIT(c2d_error);
  const c2d_status status = c2d_scan_deck(Deck::read, &deck, &out, &why);
  REQUIRE_MESSAGE(status == C2D_OK, why.text << ", line " << why.line);
  return out;
}

// Elements and boundary points of a plate: 4 below, 2 at the right, 4 above, 2 at the left.
Deck Stack::deck(const std::string& names) const {
  std::string out = "*FREE\n1\nSTACK\n0 2\n3 2 2\n1 2 12 12\n1 2 12 12\n1 2 12 12\n1 12\n1 12\n1 12\n";
  out += "100 0.3\n100 0.3\n100 0.3\n1 " + std::string(mu) + "\n";
  for (int b = 0; b < 3; ++b) {
    const double x = b == 1 ? shift : 0.0, y = b - (b == 1 ? overlap : 0.0);
    const double at[12][2] = {{0, 0}, {0.5, 0}, {1, 0}, {1.5, 0}, {2, 0}, {2, 0.5},
                              {2, 1}, {1.5, 1}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
    out += "0 0\n";
    for (int i = 0; i < 12; ++i) {
      const bool moved = b == 1 && i + 1 == plates_moved_in;
      out += std::to_string(i + 1) + " " + number(x + (moved ? 1.2 : at[i][0])) + " " + number(y + (moved ? 1.7 : at[i][1])) +
             "\n";
    }
  }
  std::vector<std::string> held, pressed;
  for (int e = 1; e <= 4; ++e)
    for (int l = 1; l <= 2; ++l) {
      held.push_back(std::to_string(e) + " " + std::to_string(l) + " 1100 0 0 0 0\n");
      pressed.push_back(std::to_string(e + 6) + " " + std::to_string(l) + " 0011 0 " + number(top * far) + " 0 0\n");
    }
  if (held_side)
    for (int e = 5; e <= 6; ++e)
      for (int l = 1; l <= 2; ++l) held.push_back(std::to_string(e) + " " + std::to_string(l) + " 1001 0 0 0 0\n");
  const std::vector<std::string>* const conditions[] = {&held, nullptr, &pressed};
  for (int b = 0; b < 3; ++b) {
    out += std::to_string(conditions[b] == nullptr ? 0 : conditions[b]->size()) + "\n";
    if (conditions[b] != nullptr)
      for (const std::string& each : *conditions[b]) out += each;
    out += std::string(b == 1 ? points : "0") + "\n";
  }
  out += "1 2 5 4\n7 10 4 1\n7 11 5 1\n2 3 5 4\n7 10 4 1\n7 11 5 1\n5 4\n10 8\n5 4\n1 10\n1 1\n";
  return deck_of(out + names + keywords);
}

// Everything that a whole run of a deck tells.
struct Told {
  std::vector<std::string> texts;
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);

  explicit Told(const Deck& deck) {
    store.serve(port);
    port.context = this;
    port.open = [](void* c, int32_t t, uint64_t n, uint64_t b) { return RamStore::open(&self(c).store, t, n, b); };
    port.read = [](void* c, int32_t t, uint64_t n, void* d, uint64_t b) { return RamStore::read(&self(c).store, t, n, d, b); };
    port.write = [](void* c, int32_t t, uint64_t n, const void* d, uint64_t b) {
      return RamStore::write(&self(c).store, t, n, d, b);
    };
    port.sync = [](void* c, int32_t t) { return RamStore::sync(&self(c).store, t); };
    port.close = [](void* c, int32_t t) { return RamStore::close(&self(c).store, t); };
    port.log = [](void* c, const c2d_error* entry) { self(c).texts.push_back(entry->text); };
    const host::Limits limits = limits_of(deck);
    uint64_t bytes = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &bytes, nullptr) == C2D_OK);
    Machine machine(limits, bytes, &port);
    REQUIRE(machine.created == C2D_OK);
    c2d_status status = read_deck(machine.solver, deck);
    if (status == C2D_OK) status = c2d_prepare(machine.solver);
    if (status == C2D_OK) c2d_run(machine.solver, nullptr, nullptr);
  }
  static Told& self(void* context) { return *static_cast<Told*>(context); }
};

// Every number of a body or a zone has its name behind it; without the names the text is what it was.
std::string without_names(const std::string& text, int& count) {
  std::string out = text;
  for (const auto& each : kNamed)
    for (size_t at = out.find(each.first); at != std::string::npos; at = out.find(each.first, at + 1)) {
      const size_t end = at + each.first.size();
      if (end < out.size() && std::isdigit(static_cast<unsigned char>(out[end]))) continue;
      CHECK_MESSAGE(out.compare(end, each.second.size(), each.second) == 0, text);
      out.erase(end, out.compare(end, each.second.size(), each.second) == 0 ? each.second.size() : 0);
      ++count;
    }
  return out;
}

// The rest of a list: "zones 1 (lower) and 2 (upper)".
std::string without_listed(std::string text, int& count) {
  for (const auto& each : kNamed)
    for (size_t at; (at = text.find(each.first.substr(5) + each.second)) != std::string::npos; ++count)
      text.erase(at + 1, each.second.size());
  return text;
}

bool is_utf8(const std::string& text) {
  static const std::regex kCharacter(
      "[\\x01-\\x7f]|[\\xc2-\\xdf][\\x80-\\xbf]|[\\xe0-\\xef][\\x80-\\xbf]{2}|[\\xf0-\\xf4][\\x80-\\xbf]{3}");
  size_t at = 0;
  std::smatch found;
  for (std::string rest = text; !rest.empty(); rest = text.substr(at)) {
    if (!std::regex_search(rest, found, kCharacter, std::regex_constants::match_continuous)) return false;
    at += static_cast<size_t>(found.length());
  }
  return true;
}

std::string name_of(c2d_solver* s, int32_t kind, int32_t i) {
  char name[32];
  std::memset(name, 'x', sizeof name);
  if (c2d_get_name(s, kind, i, name) != C2D_OK) return "?";
  size_t end = 0;
  while (end < 32 && name[end] != '\0') ++end;
  for (size_t k = end; k < 32; ++k)
    if (name[k] != '\0') return "not filled up";
  return std::string(name, end);
}

struct Small {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  Deck deck;
  host::Limits limits;
  uint64_t bytes = 0;
  std::unique_ptr<Machine> machine;
  c2d_solver* solver = nullptr;

  explicit Small(const Deck& d) : deck(d), limits(limits_of(d)) {
    store.serve(port);
    REQUIRE(c2d_memory_need(&limits, nullptr, &bytes, nullptr) == C2D_OK);
    fresh();
  }
  void fresh() {
    machine = std::make_unique<Machine>(limits, bytes, &port);
    REQUIRE(machine->created == C2D_OK);
    solver = machine->solver;
  }
};

// The fault of a deck that ends with this card: line, columns and text; where only the size is looked for, too.
c2d_error fault_of(const std::string& card, const char* keywords = "") {
  Stack stack;
  stack.keywords = keywords;
  Deck deck = stack.deck();
  deck.lines.push_back(card);
  host::Limits limits;
  limits.bodies = host::Limits::kRoom;
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_scan_deck(Deck::read, &deck, &limits, &why) == C2D_ERR_INPUT);
  CHECK(why.line == static_cast<int32_t>(deck.lines.size()));
  return why;
}

} // namespace

TEST_CASE("names by calls: given, read, taken away, in every state with a model") {
  Small s(Stack().deck());
  CHECK(c2d_set_name(s.solver, C2D_NAME_ZONE, 1, "a") == C2D_ERR_ARGUMENT); // there is none yet
  CHECK(std::string(error_of(s.solver).text) == "there is no zone to name yet");
  CHECK(c2d_get_state(s.solver) == C2D_STATE_EMPTY);
  CHECK(c2d_set_name(s.solver, C2D_NAME_BODY, 3, "bolt") == C2D_OK);
  CHECK(c2d_get_state(s.solver) == C2D_STATE_BUILDING);
  CHECK(name_of(s.solver, C2D_NAME_BODY, 3) == "bolt");
  CHECK(name_of(s.solver, C2D_NAME_BODY, 1) == "");
  s.fresh();
  REQUIRE(read_deck(s.solver, s.deck) == C2D_OK);
  const std::string longest = "1234567890123456789012345678901";
  REQUIRE(longest.size() == 31);
  CHECK(c2d_set_name(s.solver, C2D_NAME_ZONE, 2, longest.c_str()) == C2D_OK);
  CHECK(c2d_get_state(s.solver) == C2D_STATE_MODEL);
  REQUIRE(c2d_prepare(s.solver) == C2D_OK);
  CHECK(c2d_set_name(s.solver, C2D_NAME_BODY, 2, "ring") == C2D_OK);
  const double mu = 0.3;
  REQUIRE(c2d_begin(s.solver, &mu, 1) == C2D_OK);
  CHECK(c2d_set_name(s.solver, C2D_NAME_BODY, 2, "O-ring") == C2D_OK);
  CHECK(c2d_get_state(s.solver) == C2D_STATE_RUNNING);
  CHECK(name_of(s.solver, C2D_NAME_ZONE, 2) == longest);
  CHECK(name_of(s.solver, C2D_NAME_ZONE, 1) == "");
  CHECK(name_of(s.solver, C2D_NAME_BODY, 2) == "O-ring");
  CHECK(c2d_set_name(s.solver, C2D_NAME_BODY, 2, "x") == C2D_OK); // nothing of the longer one stays
  CHECK(name_of(s.solver, C2D_NAME_BODY, 2) == "x");
  CHECK(c2d_set_name(s.solver, C2D_NAME_BODY, 2, nullptr) == C2D_OK);
  CHECK(name_of(s.solver, C2D_NAME_BODY, 2) == "");
  CHECK(c2d_set_name(s.solver, C2D_NAME_ZONE, 2, "") == C2D_OK);
  CHECK(name_of(s.solver, C2D_NAME_ZONE, 2) == "");
}

TEST_CASE("names by calls: what is refused changes nothing") {
  Small s(Stack().deck(kNames));
  REQUIRE(read_deck(s.solver, s.deck) == C2D_OK);
  const auto refused = [&](int32_t kind, int32_t i, const std::string& name) {
    const bool is = c2d_set_name(s.solver, kind, i, name.c_str()) == C2D_ERR_ARGUMENT;
    CHECK(name_of(s.solver, C2D_NAME_BODY, 1) == "plate");
    CHECK(name_of(s.solver, C2D_NAME_ZONE, 2) == "upper");
    return is;
  };
  CHECK(refused(C2D_NAME_BODY, 1, "12345678901234567890123456789012"));
  CHECK(std::string(error_of(s.solver).text) == "the name is too long, expected at most 31 bytes");
  CHECK(refused(C2D_NAME_BODY, 1, "two\nlines"));
  CHECK(std::string(error_of(s.solver).text) == "the name contains a control character or no UTF-8, expected text");
  for (const char* wrong : {"\x01",
                            "a\tb",
                            "\x7f",
                            "\xc2\x85", // control characters
                            "\x80",
                            "\xc3",
                            "\xc3\x28",
                            "\xc0\xaf",
                            "\xc1\xbf",
                            "\xe2\x82",
                            "\xe2\x28\xa1",
                            "\xe0\x80\xaf",
                            "\xed\xa0\x80",
                            "\xef\xbf\xbe",
                            "\xef\xbf\xbf",
                            "\xf0\x9d\x84",
                            "\xf0\x8f\xbf\xbf",
                            "\xf4\x90\x80\x80",
                            "\xf5\x80\x80\x80",
                            "\xff",
                            "\xfe"}) {
    CAPTURE(wrong);
    CHECK(refused(C2D_NAME_BODY, 1, wrong));
    CHECK(refused(C2D_NAME_ZONE, 2, std::string("ab") + wrong));
  }
  for (const int32_t kind : {-1, 2, INT32_MAX}) CHECK(refused(kind, 1, "a"));
  for (const int32_t i : {INT32_MIN, -1, 0, 4, INT32_MAX}) CHECK(refused(C2D_NAME_BODY, i, "a"));
  for (const int32_t i : {-1, 0, 3}) CHECK(refused(C2D_NAME_ZONE, i, "a"));
  char out[32] = "as it was";
  CHECK(c2d_get_name(s.solver, C2D_NAME_BODY, 4, out) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_name(s.solver, 2, 1, out) == C2D_ERR_ARGUMENT);
  CHECK(std::string(out) == "as it was");
  CHECK(c2d_get_name(s.solver, C2D_NAME_BODY, 1, nullptr) == C2D_ERR_ARGUMENT);
  for (const char* right : {"\xc2\xa0", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbd",
                            "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "~ !\"#%&'<>\\", "\xe8\x9e\xba\xe6\xa0\x93"}) {
    CHECK(c2d_set_name(s.solver, C2D_NAME_BODY, 2, right) == C2D_OK);
    CHECK(name_of(s.solver, C2D_NAME_BODY, 2) == right);
  }
}

TEST_CASE("names in a deck: the rest of the card") {
  Small s(
      Stack().deck("*NAME BODY 1   bolt  head, \"M8\" \t ! remark: \xe4\n*Name,Zone, 2,\tleft\tflank\n*NAME BODY 2 a,b , c,\n"
                   "*NAME BODY 3 \xe8\x9e\xba\xe6\xa0\x93\n"));
  REQUIRE(read_deck(s.solver, s.deck) == C2D_OK);
  CHECK(name_of(s.solver, C2D_NAME_BODY, 1) == "bolt  head, \"M8\"");
  CHECK(name_of(s.solver, C2D_NAME_BODY, 2) == "a,b , c,");
  CHECK(name_of(s.solver, C2D_NAME_BODY, 3) == "\xe8\x9e\xba\xe6\xa0\x93");
  CHECK(name_of(s.solver, C2D_NAME_ZONE, 1) == "");
  CHECK(name_of(s.solver, C2D_NAME_ZONE, 2) == "left flank");
}

TEST_CASE("names in a deck: faults, with their columns") {
  c2d_error f = fault_of("*NAME BODY 2 12345678901234567890123456789012 ! too long");
  CHECK(std::string(f.text) == "the name is too long, expected at most 31 bytes");
  CHECK(f.column == 14);
  CHECK(f.column_end == 45);
  f = fault_of("*NAME ZONE 2 caf\xe9 bar");
  CHECK(std::string(f.text) == "the name contains a control character or no UTF-8, expected text");
  CHECK(f.column == 14);
  CHECK(f.column_end == 21);
  CHECK(std::string(fault_of("*NAME BODY 2").text) == "the card ends here, expected a name");
  CHECK(std::string(fault_of("*NAME BODY 2 ! bolt").text) == "the card ends here, expected a name");
  CHECK(std::string(fault_of("*NAME BODY").text) == "the card ends here, expected body number");
  CHECK(std::string(fault_of("*NAME").text) == "expected BODY or ZONE, its number and its name");
  f = fault_of("*NAME CASE 1 wind");
  CHECK(std::string(f.text) == "expected BODY or ZONE, its number and its name");
  CHECK(f.column == 7);
  CHECK(std::string(fault_of("*NAME BODY 4 bolt").text) == "body number is 4, expected 1 to 3");
  CHECK(std::string(fault_of("*NAME ZONE 3 thread").text) == "contact zone is 3, expected 1 to 2");
  CHECK(std::string(fault_of("*NAME BODY 2 nut", "*NAME BODY 2 bolt\n").text) == "body 2 has two names, expected one");
  CHECK(std::string(fault_of("*NAME ZONE 1 b", "*NAME BODY 1 x\n*NAME BODY 2 y\n*NAME ZONE 1 a\n").text) ==
        "zone 1 has two names, expected one");
  // Other cards are ASCII still, and behind a name no card may follow that belongs to nothing.
  CHECK(contains(fault_of("*UNITS \xc3\xa4 N").text, "contains the byte 195"));
  CHECK(contains(fault_of("*NAMES BODY 1 \xc3\xa4").text, "contains the byte 195"));
  CHECK(contains(fault_of("1 2 3", "*NAME BODY 1 a\n").text, "does not belong to *NAME"));
}

TEST_CASE("names in a deck without zones: those of zones are refused") {
  Deck deck = deck_of("*FREE\n1\nONE\n0 0\n1 0 2\n1 2 4 4\n1 4\n100 0.3\n1 0\n0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n"
                      "2\n1 1 1100 0 0 0 0\n1 2 1100 0 0 0 0\n0\n0 0\n1 10\n1 1\n*NAME ZONE 1 a");
  host::Limits limits;
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_scan_deck(Deck::read, &deck, &limits, &why) == C2D_ERR_INPUT);
  CHECK(std::string(why.text) == "no contact zone is defined yet, expected *NAME ZONE after the zones");
}

TEST_CASE("names in messages: behind every number of a body or a zone, and without them every text is as it was") {
  struct Case {
    const char* what;
    Stack stack;
  };
  const auto with = [](auto change) {
    Stack stack;
    change(stack);
    return stack;
  };
  const Case cases[] = {
      {"overlap", with([](Stack& s) { s.overlap = 0.1; })},
      {"a gap below, an overlap above", with([](Stack& s) { s.overlap = -0.1; })},
      {"nodes shifted a little", with([](Stack& s) { s.shift = 0.3; })},
      {"nodes shifted by an element", with([](Stack& s) { s.shift = 0.6; })},
      {"a point on the boundary", with([](Stack& s) { s.points = "1\n1 1.0 2.0 1 0"; })},
      {"a point outside", with([](Stack& s) { s.points = "1\n1 5.0 1.5 1 0"; })},
      {"a kink", with([](Stack& s) { s.plates_moved_in = 9; })},
      {"crossing elements", with([](Stack& s) { s.plates_moved_in = 6, s.shift = -1.5; })},
      {"a corner moved in", with([](Stack& s) { s.plates_moved_in = 7; })},
      {"rigid bodies", with([](Stack& s) { s.keywords = "*RIGID 2\n*RIGID 3\n"; })},
      {"a rigid body with loads", with([](Stack& s) { s.keywords = "*RIGID 3\n1 0 -0.01 0 0 0\n"; })},
      {"an arc that is none", with([](Stack& s) { s.keywords = "*CURVE ARC 2 1 4 0 0 1\n"; })},
      {"an element in two curves", with([](Stack& s) { s.keywords = "*CURVE LINE 3 1 4\n*CURVE LINE 3 4 4\n"; })},
      {"a line of symmetry in the middle", with([](Stack& s) { s.keywords = "*SYMMETRY X 1\n"; })},
      {"weight across the line", with([](Stack& s) { s.keywords = "*SYMMETRY X 0\n*BODY FORCE 2 1 1 0\n"; })},
      {"an element in two zones", with([](Stack& s) { s.keywords = "*ZONE BODIES 1 3 7 10 1 4\n"; })},
      {"sides that do not face", with([](Stack& s) { s.keywords = "*ZONE BODIES 1 3 5 6 5 6\n"; })},
      {"held sides", with([](Stack& s) { s.held_side = true; })},
      {"very high friction", with([](Stack& s) { s.mu = "100"; })},
      {"a tie of surfaces that are apart", with([](Stack& s) { s.overlap = 0.1, s.keywords = "*TIE 1\n*TIE 2\n"; })},
      {"squeezed", with([](Stack& s) { s.far = 40; })},
  };
  std::string all;
  for (const Case& each : cases) {
    CAPTURE(each.what);
    const Told plain(each.stack.deck()), named(each.stack.deck(kNames));
    REQUIRE(plain.texts.size() == named.texts.size());
    int count = 0;
    for (size_t i = 0; i < plain.texts.size(); ++i) {
      int in_lists = 0;
      REQUIRE(named.texts[i].size() + 1 < sizeof(c2d_error::text));
      const std::string text = without_listed(without_names(named.texts[i], count), in_lists);
      CHECK(text == plain.texts[i]);
      CHECK_FALSE(contains(plain.texts[i], "plate"));
      all += named.texts[i] + '\n';
    }
    CHECK(count > 0);
  }
  // Of each kind there was one.
  for (const char* part :
       {"zone 1 (lower), load factor ", "of body 3 (bolt, M8)", "node 7 of body 1 (plate)", "zone 2 (upper): "})
    CHECK_MESSAGE(contains(all, part), part);
}

TEST_CASE("names in messages: no text of the core puts a number of a body or a zone without its name") {
  // Where there is no body of that number, and where the number is that of a call: its name is not at hand.
  const char* const kExceptions[] = {"\": there is no body \", b + 1", "\"contact element of body \", side.body",
                                     "\"contact node of body \", side.body", "\"c2d_limits.body[\""};
  const std::regex says("\"[^\"\\n]*\\b([Bb]od(y|ies)|[Zz]ones?) \", *([a-z_0-9]+[^,)]*)");
  int named = 0;
  for (const char* folder : {"model", "contact", "solver", "results", "interface"})
    for (const auto& file : std::filesystem::recursive_directory_iterator(paths::root() + "/src/" + folder)) {
      if (!file.is_regular_file()) continue;
      const std::string text = test::read_file(file.path().string());
      for (std::sregex_iterator found(text.begin(), text.end(), says), end; found != end; ++found) {
        const std::string what = found->str(), number = (*found)[3].str();
        bool right = number.compare(0, 11, "body_named(") == 0 || number.compare(0, 11, "zone_named(") == 0 ||
                     number.compare(0, 6, "Named{") == 0;
        named += right;
        for (const char* exception : kExceptions) right = right || contains(what, exception);
        if (file.path().filename() == "free_zones.cpp") right = right || number == "one" || number == "two"; // Named, too
        CHECK_MESSAGE(right, file.path().filename().string() << ": " << what);
      }
    }
  CHECK(named > 50);
}

TEST_CASE("names in messages: a text that is too long is cut between characters, and nothing stands behind the cut") {
  const std::string whole = "zone 2 (\xc3\x96l \xe2\x9c\x93 \xf0\x9d\x84\x9e) of body 3 (bolt): more";
  std::set<size_t> sizes;
  for (size_t room = 1; room <= whole.size() + 2; ++room) {
    std::vector<char> bytes(room, 'x');
    c2d::Text text = c2d::text_in(bytes.data(), room);
    put_all(text, "zone ", c2d::Named{2, "\xc3\x96l \xe2\x9c\x93 \xf0\x9d\x84\x9e"}, " of body ", c2d::Named{3, "bolt"},
            ": more");
    const std::string cut = bytes.data();
    CAPTURE(room);
    CHECK(cut.size() < room);
    CHECK(whole.compare(0, cut.size(), cut) == 0);
    CHECK(is_utf8(cut));
    CHECK(cut.size() + 4 >= std::min(room - 1, whole.size())); // of one character
    sizes.insert(cut.size());
  }
  CHECK(sizes.count(whole.size()) == 1);
  CHECK(sizes.count(9) == 0); // amid the first letter of the name
  char room[32];
  c2d::Text text = c2d::text_in(room);
  put_all(text, "body ", c2d::Named{1, nullptr}, ", zone ", c2d::Named{2, ""});
  CHECK(std::string(room) == "body 1, zone 2");
}

TEST_CASE("names decide nothing: a state is taken up by the model under other names, and brings its own") {
  Small s(Stack().deck(kNames));
  REQUIRE(read_deck(s.solver, s.deck) == C2D_OK);
  REQUIRE(c2d_prepare(s.solver) == C2D_OK);
  REQUIRE(c2d_save(s.solver) == C2D_OK);
  s.fresh();
  s.deck = Stack().deck("*NAME BODY 1 another\n");
  REQUIRE(read_deck(s.solver, s.deck) == C2D_OK);
  CHECK(c2d_restore(s.solver) == C2D_OK);
  CHECK(c2d_get_state(s.solver) == C2D_STATE_PREPARED);
  CHECK(name_of(s.solver, C2D_NAME_BODY, 1) == "plate"); // as titles and units
  CHECK(name_of(s.solver, C2D_NAME_ZONE, 1) == "lower");
  CHECK(c2d_set_name(s.solver, C2D_NAME_ZONE, 2, "flank") == C2D_OK);
  Bytes image = s.machine->workspace();
  c2d_solver* other = nullptr;
  REQUIRE(c2d_attach(&other, image.data(), image.size(), &s.port, nullptr) == C2D_OK);
  CHECK(name_of(other, C2D_NAME_BODY, 3) == "bolt, M8");
  CHECK(name_of(other, C2D_NAME_ZONE, 2) == "flank");
  c2d_close(other);
}

namespace {

const std::string kProgram = "'" + paths::program() + "'";
const char* const kOddNames = "*NAME BODY 1 a \"b\" \\ <c> & 'd'\n*NAME BODY 3 \xc3\x96lring\n*NAME ZONE 2 x]]>/*\n";

std::string text_of(const Deck& deck) {
  std::string out;
  for (const std::string& line : deck.lines) out += line + "\n";
  return out;
}

} // namespace

TEST_CASE("names are carried by convert, there and back") {
  const Folder folder;
  test::write_file(folder / "a", text_of(Stack().deck(kNames)));
  const Result there = test::run_shell("cd '" + folder.path() + "' && " + kProgram + " convert a --to fixed -o b && " +
                                       kProgram + " convert b --to free -o c");
  REQUIRE_MESSAGE(there.status == 0, there.err);
  for (const char* file : {"b", "c"})
    for (const char* card :
         {"*NAME BODY 2 \xc3\x96lring \xe2\x9c\x93\n", "*NAME ZONE 1 lower\n", "*name zone 2 upper ! of two\n"})
      CHECK_MESSAGE(contains(test::read_file(folder / file), card), file);
  CHECK(contains(test::run_shell(kProgram + " check '" + (folder / "c") + "'").out,
                 "body 1 (plate), body 2 (\xc3\x96lring \xe2\x9c\x93), body 3 (bolt, M8), zone 1 (lower), zone 2 (upper)\n"));
  // Every card is told, as it stands.
  std::vector<std::string> told;
  c2d_body_limits room[4] = {};
  Deck deck = Stack().deck(kNames);
  const auto keep = [](void* to, const c2d_card* card) {
    if (card->kind == C2D_CARD_EXTENSION)
      static_cast<std::vector<std::string>*>(to)->emplace_back(card->text, static_cast<size_t>(card->length));
  };
  REQUIRE(c2d_walk_deck(Deck::read, &deck, room, 4, keep, &told, nullptr, nullptr) == C2D_OK);
  REQUIRE(told.size() == 5);
  CHECK(told[1] == "*NAME BODY 2 \xc3\x96lring \xe2\x9c\x93");
}

TEST_CASE("names in listing, JSON, page and pictures; rows of the CSV do not change") {
  const Folder folder;
  Stack stack;
  stack.mu = "0"; // they slip
  test::write_file(folder / "plain", text_of(stack.deck()));
  test::write_file(folder / "named", text_of(stack.deck(kOddNames)));
  for (const char* deck : {"plain", "named"}) {
    const std::string d = deck;
    const Result run =
        test::run_shell("cd '" + folder.path() + "' && " + kProgram + " run " + d + " --csv " + d + ".csv --json " + d +
                        ".json --report " + d + ".html --listing " + d + ".txt --figures " + d + ".d");
    REQUIRE_MESSAGE(run.status == 0, run.err);
  }
  CHECK(test::read_file(folder / "named.csv") == test::read_file(folder / "plain.csv"));
  const test::Json json = test::JsonReader::read(test::read_file(folder / "named.json"));
  CHECK(json["zones"][1]["name"].text == "x]]>/*");
  CHECK_FALSE(json["zones"][0].has("name"));
  CHECK(json["force"]["bodies"][0]["name"].text == "a \"b\" \\ <c> & 'd'");
  CHECK_FALSE(json["force"]["bodies"][1].has("name"));
  CHECK(json["force"]["bodies"][2]["name"].text == "\xc3\x96lring");
  const test::Json plain = test::JsonReader::read(test::read_file(folder / "plain.json"));
  for (size_t i = 0; i < 2; ++i) CHECK_FALSE((plain["zones"][i].has("name") || plain["force"]["bodies"][i].has("name")));
  const std::string listing = test::read_file(folder / "named.txt");
  for (const char* part :
       {"\nBody 1 (a \"b\" \\ <c> & 'd')\n", "\nBody 2\n", "\nContact zone of body 3 (\xc3\x96lring)\n",
        "  zone 2 (x]]>/*): body 2 on body 3 (\xc3\x96lring)\n", "body 3 (\xc3\x96lring): loads and supports"})
    CHECK_MESSAGE(contains(listing, part), part);
  const std::string page = test::read_file(folder / "named.html");
  for (const char* part :
       {"body 1 (a &quot;b&quot; \\ &lt;c&gt; &amp; 'd')", "Zone 2 (x]]&gt;/*): body 2 on body 3 (\xc3\x96lring)",
        "body 3 (\xc3\x96lring): loads and supports"})
    CHECK_MESSAGE(contains(page, part), part);
  CHECK_FALSE(contains(page, "<c>"));
  const std::string model = test::read_file(folder / "named.d/model.svg");
  CHECK(contains(model, ">body 3 (\xc3\x96lring)</text>"));
  CHECK(contains(test::read_file(folder / "named.d/balance.svg"), ">body 3 (\xc3\x96lring), fy</text>"));
  CHECK(contains(test::read_file(folder / "named.d/gap_zone2.svg"), "Slip of body 3 against body 2 along t, summed up"));
  // Columns of the balance stand under each other, whatever the names.
  std::set<size_t> ends;
  int rows = 0;
  for (const std::string& line : test::lines_of(listing))
    if (contains(line, ": loads and supports ") || (rows > 0 && rows < 9 && contains(line, "    "))) {
      size_t characters = 0;
      for (const char c : line) characters += (c & 0xc0) != 0x80;
      ends.insert(characters);
      ++rows;
    }
  CHECK(rows == 9);
  CHECK(ends.size() == 1);
}

TEST_CASE("names in the line that tells why a path ended, and of points outside") {
  const Folder folder;
  Stack stack;
  stack.top = 1;
  test::write_file(folder / "a", text_of(stack.deck(kNames)));
  const Result pulled = test::run_shell(kProgram + " run '" + (folder / "a") + "' --json '" + (folder / "j") + "'");
  CHECK(pulled.status == 1);
  CHECK_MESSAGE(contains(pulled.err, "; body 3 (bolt, M8) can move by (0, 1)"), pulled.err);
  CHECK(contains(test::JsonReader::read(test::read_file(folder / "j"))["incomplete"]["why"].text,
                 "; body 3 (bolt, M8) can move"));
  stack.top = -1;
  stack.keywords = "*POINTS\npoint 1 1 1.5\n";
  test::write_file(folder / "b", text_of(stack.deck(kNames)));
  const Result outside = test::run_shell(kProgram + " run '" + (folder / "b") + "' --interior /dev/null");
  CHECK(outside.status == 0);
  CHECK_MESSAGE(contains(outside.err, "lies outside body 1 (plate), but inside body 2 (\xc3\x96lring \xe2\x9c\x93)"),
                outside.err);
}
