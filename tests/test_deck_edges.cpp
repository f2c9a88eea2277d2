// The deck reader at the edges of its columns, ranges and lists: what each card tells, and what follows from a fault and what
// does not. Numbers are taken from the card as it stands in the test.
#include "deck_recorder.hpp"

#include <doctest/doctest.h>

using namespace deck_test;

namespace {

using List = std::vector<std::string>;

Reading with(size_t line, const std::string& card) {
  List deck = squares();
  deck[line - 1] = card;
  return read(joined(deck));
}

Reading behind(const List& cards) {
  List deck = squares();
  deck.insert(deck.end(), cards.begin(), cards.end());
  return read(joined(deck));
}

bool contains_text(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The only fault there is.
Fault the_fault(const Reading& r) {
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(r.faults.size() == 1);
  CAPTURE(r.faults[0].text);
  return r.faults[0];
}

std::vector<double> last_call(const Reading& r, const char* name) {
  CHECK(r.status == C2D_OK);
  for (size_t i = r.model.calls.size(); i-- > 0;)
    if (r.model.calls[i].name == name) return r.model.calls[i].numbers;
  return {};
}

struct Told {
  int kind, line, column, width;
  std::string text;
};

std::vector<Told> walk(const List& lines) {
  Bytes deck;
  deck.bytes = joined(lines);
  std::vector<Told> told;
  c2d_body_limits room[2] = {};
  const auto keep = [](void* context, const c2d_card* card) {
    static_cast<std::vector<Told>*>(context)->push_back(
        {card->kind, card->line, card->column, card->width, std::string(card->text, static_cast<size_t>(card->length))});
  };
  CHECK(c2d_walk_deck(read_bytes, &deck, room, 2, keep, &told, nullptr, nullptr) == C2D_OK);
  return told;
}

// The column in which the remark of a line begins; 0: it has none.
int remark_column(const std::vector<Told>& told, int line) {
  for (const Told& t : told)
    if (t.line == line && t.kind == C2D_CARD_REMARK) return t.column;
  return 0;
}

} // namespace

TEST_CASE("deck edges: a workspace for other bodies is told with the columns of their number") {
  Recorder model;
  Bytes deck;
  deck.bytes = joined(squares());
  c2d::DeckSink sink = recording_sink(model);
  sink.bodies = 3;
  std::vector<Fault> faults;
  host::Limits sizes;
  sizes.bodies = host::Limits::kRoom;
  CHECK(c2d::read_deck_cards(&sink, read_bytes, &deck, keep_fault, &faults, &sizes) == C2D_ERR_INPUT);
  REQUIRE(!faults.empty());
  CHECK((faults[0].line == 4 && faults[0].column == 1 && faults[0].column_end == 5));
  CHECK(faults[0].text.find("number of bodies is 2, but the workspace was made for 3") != std::string::npos);
}

TEST_CASE("deck edges: the model is told the columns of what it is given, for what it may say about it") {
  static int32_t columns[2];
  static std::vector<int32_t> of_regions;
  of_regions.clear();
  Recorder model;
  Bytes deck;
  deck.bytes = joined(squares());
  c2d::DeckSink sink = recording_sink(model);
  sink.set_line = [](c2d_solver*, int32_t, int32_t column, int32_t column_end) -> c2d_status {
    columns[0] = column, columns[1] = column_end;
    return C2D_OK;
  };
  sink.add_region = [](c2d_solver*, int32_t, int32_t, int32_t) -> c2d_status {
    of_regions.insert(of_regions.end(), columns, columns + 2);
    return C2D_OK;
  };
  std::vector<Fault> faults;
  host::Limits sizes;
  sizes.bodies = host::Limits::kRoom;
  CHECK(c2d::read_deck_cards(&sink, read_bytes, &deck, keep_fault, &faults, &sizes) == C2D_OK);
  CHECK(of_regions == std::vector<int32_t>{1, 10, 1, 10});
}

TEST_CASE("deck edges: remarks begin behind the last field of a card") {
  const std::vector<Told> told = walk(squares());
  CHECK(remark_column(told, 4) == 16);  // bodies, zones, functional nodes
  CHECK(remark_column(told, 31) == 21); // two ranges of elements
  CHECK(remark_column(told, 32) == 21); // of nodes
}

TEST_CASE("deck edges: each code of a condition is a field of one column") {
  int32_t seen = 0;
  for (const Told& t : walk(squares()))
    if (t.line == 23 && t.kind == C2D_CARD_INTEGER && t.column >= 12 && t.column <= 15) {
      CHECK((t.width == 1 && t.column == 12 + seen));
      CHECK(t.text == std::string(1, "1100"[seen]));
      ++seen;
    }
  CHECK(seen == 4);
}

TEST_CASE("deck edges: codes in one field of the free form are told one by one") {
  std::string codes;
  for (const Told& t :
       walk({"*FREE", "1",     "SQUARE", "0 0",   "1 0 2", "1 2 4 4",          "1 4", "100 0.3", "1 0",  "0 0",
             "1 0 0", "2 1 0", "3 1 1",  "4 0 1", "1",     "1 1 1100 0 0 0 0", "0",   "0 0",     "1 10", "4 1"}))
    if (t.line == 16 && t.column >= 12 && t.column <= 15) codes += t.text + ";";
  CHECK(codes == "1;1;0;0;");
}

TEST_CASE("deck edges: lines may come with their ends") {
  const Reading plain = read(joined(squares()));
  for (const char* end : {"\n", "\r\n", "\r\r\n", "\r"}) {
    struct Lines {
      List lines;
      std::string end;
      size_t at;
    } lines = {squares(), end, 0};
    const auto next = [](void* context, char* text, int32_t size) -> int32_t {
      Lines& l = *static_cast<Lines*>(context);
      if (l.at == l.lines.size()) return -1;
      const std::string line = l.lines[l.at++] + l.end;
      REQUIRE(static_cast<int32_t>(line.size()) < size);
      std::copy(line.begin(), line.end(), text);
      text[line.size()] = 'x'; // what stands behind it does not count
      return static_cast<int32_t>(line.size());
    };
    Recorder model;
    const c2d::DeckSink sink = recording_sink(model);
    std::vector<Fault> faults;
    host::Limits sizes;
    sizes.bodies = host::Limits::kRoom;
    CHECK(c2d::read_deck_cards(&sink, next, &lines, keep_fault, &faults, &sizes) == C2D_OK);
    REQUIRE(model.calls.size() == plain.model.calls.size());
    for (size_t i = 0; i < model.calls.size(); ++i) CHECK(model.calls[i].numbers == plain.model.calls[i].numbers);
  }
}

TEST_CASE("deck edges: a polar node may have no radius, but not less") {
  CHECK(last_call(with(18, "P   1        0.       30."), "node").size() == 4);
  const Fault f = the_fault(with(18, "P   1       -1.       30."));
  CHECK((f.column == 7 && f.column_end == 16));
  CHECK(f.text.find("radius is -1") != std::string::npos);
}

TEST_CASE("deck edges: a condition that could not be read makes no second fault where others are generated from it") {
  const Fault f = the_fault(with(23, "    9    1 1100                            0.0       0.0"));
  CHECK(f.line == 23);
  // Nor do they reach the model: nobody knows from where on.
  for (const Call& call : with(23, "    9    1 1100                            0.0       0.0").model.calls)
    CHECK((call.name != "condition" || call.numbers[0] == 2));
}

TEST_CASE("deck edges: where a count of a body could not be read nothing is said of how it fits the others") {
  for (const char* card : {"    0    2    4    4", "    1    2    0    4", "    1    2   -4    4", "    1    2    x    4",
                           "    1    2    4    0"}) {
    const Fault fault = the_fault(with(5, card));
    CHECK(fault.line == 5);
    CHECK(contains_text(fault.text, "the rest cannot be read without it"));
  }
}

TEST_CASE("deck edges: a fault says of which body the card is") {
  for (int b = 1; b <= 2; ++b) {
    const Fault sizes = the_fault(with(static_cast<size_t>(4 + b), "    9    2    4    4"));
    CHECK(sizes.line == 4 + b);
    CHECK(sizes.body == b);
  }
  CHECK(the_fault(with(23, "    9    1 1100                            0.0       0.0")).body == 1);
  CHECK(the_fault(with(27, "    9    1 0011       0.0      -1.0")).body == 2);
}

TEST_CASE("deck edges: a body that meets itself has its pairs twice among those to make room for") {
  CHECK(read(joined(squares())).sizes.pairs == 2);
  List deck = squares();
  deck[29] = "    1   -1    2    1";
  deck[32] = "    4    2", deck[33] = "    0    0";
  const Reading r = read(joined(deck));
  CHECK(r.status == C2D_OK);
  CHECK(r.sizes.pairs == 4);
}

TEST_CASE("deck edges: elements of a free zone are numbered as those of its bodies are") {
  List deck = squares();
  deck[7] = "    5    8";
  deck[26] = "    7    1 0011       0.0      -1.0";
  deck[30] = "    3    3    5    5";
  deck.push_back("*ZONE 2 2 6 6");
  const std::vector<double> within = {2, 2, 2, 2, 0, 0};
  CHECK(last_call(read(joined(deck)), "free zone") == within);
  deck.back() = "*ZONE 2 2 2 2";
  const Reading r = read(joined(deck));
  REQUIRE(r.faults.size() == 2);
  for (const Fault& f : r.faults) CHECK(f.text.find("expected 5 to 8") != std::string::npos);
}

TEST_CASE("deck edges: behind blanks, too, the first card may have a remark in any script") {
  for (const char* blanks : {"", "   "}) {
    CAPTURE(std::string(blanks));
    const Reading r = read(blanks + std::string("*FREE ! f\xc3\xbcr alle\n1\nPLATE\n7 1\n"));
    REQUIRE(!r.faults.empty());
    CHECK(r.faults[0].line == 4);
  }
}

TEST_CASE("deck edges: in the free form, too, the cards behind a node with a wrong number are read") {
  List deck = {"*FREE", "1",     "SQUARE", "0 0",   "1 0 2", "1 2 4 4",          "1 4", "100 0.3", "1 0", "0 0",
               "1 0 0", "7 1 0", "3 1 1",  "4 0 1", "1",     "9 1 1100 0 0 0 0", "0",   "1 1",     "1 1"};
  const Reading r = read(joined(deck));
  REQUIRE(r.faults.size() >= 2);
  CHECK((r.faults[0].line == 12 && r.faults[1].line == 16));
}

TEST_CASE("deck edges: body numbers of keyword cards begin at 1") {
  for (const char* card : {"*BODY FORCE 0 1 0 -1", "*CURVE LINE 0 1 2", "*RIGID LOAD 0 0 0", "*NAME BODY 0 plate"}) {
    CAPTURE(card);
    const Reading r = behind({card});
    CHECK(r.status == C2D_ERR_INPUT);
    REQUIRE(!r.faults.empty());
    CHECK(r.faults[0].text.find("is 0, expected 1 to 2") != std::string::npos);
  }
}

TEST_CASE("deck edges: every number of a body force is told by its name") {
  const char* const names[] = {"body force bx", "body force by", "density times angular velocity squared",
                               "x of the axis of rotation", "y of the axis of rotation"};
  for (size_t i = 0; i < 5; ++i) {
    std::string card = "*BODY FORCE 1 1";
    for (size_t k = 0; k < 5; ++k) card += k == i ? " 1x" : " 2";
    CHECK(the_fault(behind({card})).text.find(names[i]) != std::string::npos);
  }
}

TEST_CASE("deck edges: a body force is given once for a body and a load case, the first included") {
  for (const char* card : {"*BODY FORCE 1 1 0 -1", "*BODY FORCE 2 1 0 -1", "*BODY FORCE 1 2 0 -1", "*BODY FORCE 2 2 0 -1"})
    CHECK(the_fault(behind({"*BODY FORCE 1 3 0 -1", card, card})).text.find("two body forces") != std::string::npos);
  CHECK(behind({"*BODY FORCE 1 1 0 -1", "*BODY FORCE 2 1 0 -1", "*BODY FORCE 1 2 0 -1", "*BODY FORCE 2 2 0 -1"}).status ==
        C2D_OK);
}

TEST_CASE("deck edges: free motions are told as they are named, all of them if none is") {
  using Numbers = std::vector<double>;
  CHECK(last_call(behind({"*RIGID LOAD 1 3.5 -2"}), "rigid load") == Numbers{1, 1, 1, 1, 3.5, -2});
  CHECK(last_call(behind({"*RIGID LOAD 1 3.5 -2 X"}), "rigid load") == Numbers{1, 1, 0, 0, 3.5, -2});
  CHECK(last_call(behind({"*RIGID LOAD 1 3.5 -2 Y"}), "rigid load") == Numbers{1, 0, 1, 0, 3.5, -2});
  CHECK(last_call(behind({"*RIGID LOAD 1 3.5 -2 TURN X"}), "rigid load") == Numbers{1, 1, 0, 1, 3.5, -2});
}

TEST_CASE("deck edges: bodies and zones are named apart") {
  CHECK(behind({"*NAME BODY 1 a", "*NAME BODY 2 b", "*NAME ZONE 1 c"}).status == C2D_OK);
  CHECK(the_fault(behind({"*NAME BODY 2 b", "*NAME BODY 2 c"})).text.find("body 2 has two names") != std::string::npos);
  CHECK(the_fault(behind({"*NAME ZONE 1 b", "*NAME ZONE 1 c"})).text.find("zone 1 has two names") != std::string::npos);
}

TEST_CASE("deck edges: ranges of elements have digits and one dash between them, nothing else") {
  for (const char* bad : {"1x2", "x1", "1-x2", "1-", "-1", "1--2", "2-1", "1-5", "0-1", "1-2-3"}) {
    CAPTURE(bad);
    const Reading r = behind({"*CASES 2", "case 2", std::string("condition 1 ") + bad + " 0 0 -1 0 0"});
    REQUIRE(!r.faults.empty());
    CHECK(r.faults[0].text.find("elements are '" + std::string(bad) + "'") != std::string::npos);
  }
  CHECK(behind({"*CASES 2", "case 2", "condition 1 1-2 0 0 0 0 0"}).status == C2D_OK);
}

TEST_CASE("deck edges: what *INTERFERENCE cannot read reaches no model, and no case is made for it") {
  for (const char* card : {"*INTERFERENCE x", "*INTERFERENCE 0", "*INTERFERENCE 10001"}) {
    const Reading r = behind({card});
    the_fault(r);
    CHECK(r.sizes.load_cases <= 1);
    for (const Call& call : r.model.calls) CHECK(call.name != "interference");
  }
  CHECK(behind({"*INTERFERENCE 3"}).sizes.load_cases == 3);
}

TEST_CASE("deck edges: what stands behind a fault on a keyword card is read, and told only where it is wrong itself") {
  CHECK(the_fault(behind({"*RIGID 9", "1 0 0 0 0 0"})).text.find("body number is 9") != std::string::npos);
  CHECK(the_fault(behind({"*SYMMETRY"})).text.find("the card ends here") != std::string::npos);
  CHECK(the_fault(behind({"*SYMMETRY Z 0"})).text.find("expected X or Y") != std::string::npos);
  CHECK(the_fault(behind({"*CURVE ARC 1 1 9 0 0 1"})).text.find("element of the curve is 9") != std::string::npos);
  CHECK(the_fault(behind({"*CURVE ARC 1 1 2 x 0 1"})).text.find("x of the centre") != std::string::npos);
  CHECK(the_fault(behind({"*CURVE ARC 1 1 2 0 y 1"})).text.find("y of the centre") != std::string::npos);
  CHECK(the_fault(behind({"*CURVE ARC 1 1 2 0 0 r"})).text.find("radius") != std::string::npos);
  CHECK(behind({"*CURVE ARC 1 1 2 x y r"}).faults.size() == 3);
}

TEST_CASE("deck edges: a number is as bad below -1e100 as above 1e100") {
  for (const char* number : {"-1.0e+200", " 1.0e+200"}) {
    CAPTURE(std::string(number));
    CHECK(the_fault(with(9, std::string(" ") + number + "       0.3")).column_end <= 10);
  }
}

TEST_CASE("deck edges: a second body force is told for the first numbers of bodies and cases, beyond them none is") {
  CHECK(the_fault(behind({"*BODY FORCE 1 2 0 -1", "*BODY FORCE 1 2 0 -1"})).text.find("two body forces") != std::string::npos);
  CHECK(behind({"*BODY FORCE 1 200 0 -1", "*BODY FORCE 1 200 0 -1"}).status == C2D_OK);
  CHECK(the_fault(behind({"*BODY FORCE 2 128 0 -1", "*BODY FORCE 2 128 0 -1"})).text.find("two body forces") !=
        std::string::npos);
  CHECK(behind({"*BODY FORCE 1 129 0 -1", "*BODY FORCE 1 129 0 -1"}).status == C2D_OK);
}

TEST_CASE("deck edges: an error that has no room for a status is no place to tell one") {
  Bytes deck;
  deck.bytes = joined(squares());
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_error why = C2D_INIT(c2d_error);
  why.struct_size = sizeof why.struct_size;
  CHECK(c2d_scan_deck(read_bytes, &deck, &limits, &why) == C2D_ERR_ARGUMENT);
  CHECK(why.struct_size == sizeof why.struct_size);
}

TEST_CASE("deck edges: a byte that is no text ends the reading, on any line") {
  const Fault f = the_fault(with(4, std::string("    2    1 \x01  2")));
  CHECK(f.line == 4);
  CHECK(f.column == 12);
  CHECK(contains_text(f.text, "column 12 contains the byte 1, expected plain ASCII text"));
}

TEST_CASE("deck edges: load cases beyond the first 256 may stand below *CASES more than once") {
  const List cards = {"*CASES 300", "case 257", "load 1 0 0 1 0", "case 257", "load 1 0 0 2 0"};
  const Reading r = behind(cards);
  CHECK(r.sizes.load_cases == 300);
  CHECK(last_call(r, "point load") == std::vector<double>{1, 0, 0, 2, 0, 257});
  List twice = cards;
  twice[1] = twice[3] = "case 256";
  CHECK(contains_text(the_fault(behind(twice)).text, "case 256 appears twice below *CASES"));
}

TEST_CASE("deck edges: a condition of a load case without elements names what it misses") {
  const Reading r = behind({"*CASES 2", "case 2", "condition 1"});
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(!r.faults.empty());
  CHECK(contains_text(r.faults[0].text, "elements are '', expected a number or a range e1-e2 within 1 to 4"));
}

TEST_CASE("deck edges: a model that refuses values of a later load case, new paths, or what a platen carries is not asked on") {
  const auto calls_to = [](const List& cards, const char* name, int nth, c2d_status refusal) {
    List deck = squares();
    deck.insert(deck.end(), cards.begin(), cards.end());
    const Reading whole = read(joined(deck));
    REQUIRE(whole.status == C2D_OK);
    int at = -1;
    for (size_t i = 0; i < whole.model.calls.size(); ++i)
      if (whole.model.calls[i].name == name && nth-- == 0) at = static_cast<int>(i);
    REQUIRE(at >= 0);
    const Reading refused = read(joined(deck), at, refusal);
    CHECK(refused.status == refusal);
    return static_cast<int>(refused.model.calls.size()) - at - 1; // that follow
  };
  const List cases = {"*CASES 2", "case 2", "condition 1 1-3 0 1 0 0 0"}, path = {"*PATH", "4 1", "4 0"};
  CHECK(calls_to(cases, "case values", 1, C2D_ERR_LIMIT) == 0);
  CHECK(calls_to(cases, "case values", 1, C2D_ERR_INPUT) == 0); // of the range the third would be
  CHECK(calls_to(path, "clear paths", 0, C2D_ERR_LIMIT) == 0);
}

TEST_CASE("deck edges: what stands below a rigid body that is told wrongly is read, and no model receives it") {
  const Reading r = behind({"*RIGID LOAD 3 0 0 X", "1 1 0 0"});
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.faults.size() == 1);
  for (const Call& call : r.model.calls) CHECK(call.name != "rigid load");
}

TEST_CASE("deck edges: a region that is not the last of its body ends within it") {
  List deck = squares();
  deck[4] = "    2    2    4    4";
  deck[6] = "    1    9";
  deck.insert(deck.begin() + 7, "    4    4");
  const Reading r = read(joined(deck));
  REQUIRE(!r.faults.empty());
  CHECK(r.faults[0].line == 7);
  CHECK(r.faults[0].column == 6);
  CHECK(contains_text(r.faults[0].text, "last element of the region is 9, expected 1 to 4"));
}

namespace {

// Three squares, one upon the other; two contact zones.
List three_squares() {
  return {"*FREE",
          "1",
          "THREE",
          "0 2",
          "3 2 2",
          "1 2 4 4",
          "1 2 4 4",
          "1 2 4 4",
          "1 4",
          "1 4",
          "1 4",
          "1e3 0.3",
          "1e3 0.3",
          "1e3 0.3",
          "1 0.3",
          "0 0",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "4 0 1",
          "0 0",
          "1 0 1",
          "2 1 1",
          "3 1 2",
          "4 0 2",
          "0 0",
          "1 0 2",
          "2 1 2",
          "3 1 3",
          "4 0 3",
          "2",
          "1 1 1100 0 0 0 0",
          "1 2 1100 0 0 0 0",
          "0",
          "0",
          "0",
          "2",
          "3 1 0011 0 -1 0 0",
          "3 2 0011 0 -1 0 0",
          "0",
          "1 2 2 1",
          "3 3 1 1",
          "3 4 2 1",
          "2 3 2 1",
          "3 3 1 1",
          "3 4 2 1",
          "2 1",
          "4 2",
          "2 1",
          "1 50",
          "1 1"};
}
constexpr size_t kSums = 46; // of the first card with numbers of contact nodes and elements, from 0

} // namespace

TEST_CASE(
    "deck edges: of three bodies the sums of contact nodes and elements are compared, at the last, if all could be read") {
  List deck = three_squares();
  CHECK(read(joined(deck)).status == C2D_OK);
  deck[kSums + 1] = "5 2";
  Fault f = the_fault(read(joined(deck)));
  CHECK(f.line == static_cast<int>(kSums) + 3);
  CHECK(contains_text(f.text, "numbers of contact nodes of all bodies make 9, expected 8"));
  deck[kSums + 1] = "4 x";
  f = the_fault(read(joined(deck)));
  CHECK(f.line == static_cast<int>(kSums) + 2); // that of the number that is none, and no other
}

TEST_CASE("deck edges: behind the first keyword card a C begins a remark only with a blank behind it") {
  CHECK(behind({"*UNITS mm N", "C no card", "C"}).status == C2D_OK);
  const Fault f = the_fault(behind({"*UNITS mm N", "Card"}));
  CHECK(contains_text(f.text, "the card does not belong to *UNITS above it"));
  CHECK(behind({"Card", "*UNITS mm N"}).status == C2D_OK); // before, it did in 1987
}

TEST_CASE("deck edges: a keyword that is long is told as far as there is room") {
  const Fault f = the_fault(behind({"*ANUMBEROFLETTERSWITHOUTEND WORD"}));
  CHECK(contains_text(f.text, "ANUMBEROFLETTERSWITHOU"));
  CHECK(!contains_text(f.text, "WORD"));
}

TEST_CASE("deck edges: one body has no free zone but with itself; with constant functions a zone has a pair for each element") {
  List deck = three_squares();
  deck[4] = "3 0 1";
  deck.erase(deck.begin() + 40, deck.begin() + 46);
  for (size_t i = 40; i < 43; ++i) deck[i] = "0 0";
  deck[36] = deck[30] = "1"; // a condition of an element's only node
  deck.erase(deck.begin() + 38);
  deck.erase(deck.begin() + 32);
  deck.push_back("*ZONE 3 3 1 1");
  const Reading r = read(joined(deck));
  CAPTURE((r.faults.empty() ? std::string() : r.faults[0].text));
  CHECK(r.status == C2D_OK);
  CHECK(r.sizes.pairs == 1);
  const List one = {"*FREE",
                    "1",
                    "ONE",
                    "0 2",
                    "1 0 2",
                    "1 2 4 4",
                    "1 4",
                    "1e3 0.3",
                    "1 0.3",
                    "0 0",
                    "1 0 0",
                    "2 1 0",
                    "3 1 1",
                    "4 0 1",
                    "2",
                    "1 1 1100 0 0 0 0",
                    "1 2 1100 0 0 0 0",
                    "0",
                    "0 0",
                    "1 50",
                    "1 1",
                    "*ZONE 3 3 1 1"};
  const Fault f = the_fault(read(joined(one)));
  CHECK(contains_text(f.text, "a contact zone in a deck of one body, expected two bodies, or BODIES 1 -1"));
}

TEST_CASE("deck edges: a heading is told without the blanks and tabs behind it") {
  List deck = squares();
  deck[1] = "TWO SQUARES \t";
  Bytes bytes;
  bytes.bytes = joined(deck);
  std::vector<std::string> headings;
  c2d_body_limits room[2] = {};
  const auto keep = [](void* context, const c2d_card* card) {
    if (card->kind == C2D_CARD_HEADING)
      static_cast<std::vector<std::string>*>(context)->emplace_back(card->text, static_cast<size_t>(card->length));
  };
  CHECK(c2d_walk_deck(read_bytes, &bytes, room, 2, keep, &headings, nullptr, nullptr) == C2D_OK);
  REQUIRE(headings.size() == 1);
  CHECK(headings[0] == "TWO SQUARES");
}

// Cards of point loads without numbers, so many that the last fault that is told stands on each of the cards behind them.
TEST_CASE("deck edges: wherever the hundredth fault is, the next ends the reading, and no model hears of what follows") {
  int ended = 0;
  for (int faults = 90; faults <= 101; ++faults) {
    CAPTURE(faults);
    List deck = squares();
    deck[27] = std::string(5 - std::to_string(faults).size(), ' ') + std::to_string(faults);
    deck.erase(deck.begin() + 28);
    deck.insert(deck.begin() + 28, static_cast<size_t>(faults), "    1         x       0.5       0.0      -2.0");
    const size_t zones = 28 + static_cast<size_t>(faults);
    deck[zones + 3] = "    7    x", deck[zones + 4] = "    7    x";
    deck[zones + 5] = "    1    x";
    deck[zones + 6] = "    x       1.0";
    const Reading r = read(joined(deck));
    CHECK(r.status == C2D_ERR_INPUT);
    const bool too_many = contains_text(r.faults.back().text, "too many faults");
    CHECK(r.faults.size() == (too_many ? 101 : r.faults.size()));
    ended += too_many;
    for (const Call& call : r.model.calls) CHECK(call.name != "path");
  }
  CHECK(ended >= 5);
  List deck = squares(); // nodes without a coordinate
  deck[4] = "    1    2  102  102", deck[6] = "    1  102";
  std::string number = "    0";
  deck.erase(deck.begin() + 12, deck.begin() + 16);
  for (int node = 102; node >= 1; --node) {
    number = std::string(5 - std::to_string(node).size(), ' ') + std::to_string(node);
    deck.insert(deck.begin() + 12, number + "        x        0.");
  }
  const Reading r = read(joined(deck));
  CHECK(r.faults.size() == 101);
  CHECK(contains_text(r.faults.back().text, "too many faults"));
  CHECK(r.faults.back().line == 12 + 101);
}

TEST_CASE("deck edges: a model that refuses everything is not asked for ever") {
  List deck = squares();
  deck[27] = "  150";
  deck.insert(deck.begin() + 28, 149, deck[28]);
  Bytes bytes;
  bytes.bytes = joined(deck);
  Reading r;
  r.sizes.bodies = host::Limits::kRoom;
  c2d::DeckSink sink = recording_sink(r.model);
  sink.add_point_load = [](c2d_solver* s, int32_t, int32_t, double, double, double, double) -> c2d_status {
    recorder(s)->record("point load", {});
    return C2D_ERR_INPUT;
  };
  CHECK(c2d::read_deck_cards(&sink, read_bytes, &bytes, keep_fault, &r.faults, &r.sizes) == C2D_ERR_INPUT);
  int asked = 0;
  for (const Call& call : r.model.calls) asked += call.name == "point load";
  CHECK(asked == 101);
}

TEST_CASE("deck edges: of the first 128 zones none is named twice; beyond them nothing is looked after") {
  List cards(140, "*ZONE 3 3 1 1");
  cards.insert(cards.end(), {"*NAME ZONE 129 a", "*NAME ZONE 129 b", "*NAME ZONE 128 a"});
  CHECK(behind(cards).status == C2D_OK);
  cards.emplace_back("*NAME ZONE 128 b");
  CHECK(contains_text(the_fault(behind(cards)).text, "zone 128 has two names, expected one"));
}

// The model cannot be told where a card stands, and then refuses what is on it.
TEST_CASE("deck edges: of two errors on a card the first is what the reading returns") {
  static int until;
  int met = 0;
  for (int n = 0; n < 40; ++n) {
    CAPTURE(n);
    Bytes deck;
    List cards = squares();
    cards.insert(cards.end(), {"*UNITS mm N", "*NAME BODY 1 low", "*POINTS", "LINE 1 0.1 0.1 0.9 0.9 3", "*INTERFERENCE 1"});
    deck.bytes = joined(cards);
    Recorder model;
    c2d::DeckSink sink = recording_sink(model);
    until = n;
    sink.set_line = [](c2d_solver* s, int32_t, int32_t, int32_t) -> c2d_status {
      if (until-- > 0) return C2D_OK;
      recorder(s)->refuse_call = static_cast<int>(recorder(s)->calls.size());
      recorder(s)->refusal = C2D_ERR_MEMORY;
      return C2D_ERR_STATE;
    };
    c2d_limits sizes = C2D_INIT(c2d_limits);
    c2d_body_limits room[2] = {};
    sizes.body = room, sizes.bodies = 2;
    const c2d_status status = c2d::read_deck_cards(&sink, read_bytes, &deck, nullptr, nullptr, &sizes);
    CHECK(status == (until < 0 ? C2D_ERR_STATE : C2D_OK));
    met += until < 0 ? 1 : 0;
  }
  CHECK(met > 5);
  CHECK(met < 40);
}

TEST_CASE("deck edges: lines beyond what there is room for are told as the last one") {
  c2d::Deck deck = {};
  c2d_body_limits room[2] = {};
  deck.body = room;
  for (const int32_t line : {1, (1 << 28) - 2, (1 << 28) - 1, INT32_MAX}) {
    CAPTURE(line);
    deck.cards.line = line;
    c2d::keep_body_card(deck, 1, 4);
    CHECK(c2d::element_nodes(deck, 1) == 4);
    CHECK(c2d::body_line(deck, 1) == std::min(line, (1 << 28) - 2));
  }
}

namespace {

const List kFreeSquare = {"*FREE", "1",     "SQUARE", "0 0",   "1 0 2", "1 2 4 4",          "1 4", "100 0.3", "1 0",  "0 0",
                          "1 0 0", "2 1 0", "3 1 1",  "4 0 1", "1",     "1 1 1100 0 0 0 0", "0",   "0 0",     "1 10", "4 1"};

// Two coefficients of friction, and so many point loads without numbers: each a fault.
List with_faults(int32_t faults, const List& behind) {
  List deck = squares();
  deck[10] = "    2       0.5       0.6";
  if (faults > 0) {
    deck[27] = std::string(5 - std::to_string(faults).size(), ' ') + std::to_string(faults);
    deck.erase(deck.begin() + 28);
    deck.insert(deck.begin() + 28, static_cast<size_t>(faults), "    1         x       0.5       0.0      -2.0");
  }
  deck.insert(deck.end(), behind.begin(), behind.end());
  return deck;
}

// The last fault of a deck that is not read to its end.
Fault last_fault(const Reading& r) {
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(!r.faults.empty());
  return r.faults.back();
}

} // namespace

TEST_CASE("deck edges: a card that is nothing but '&' goes on from nothing") {
  List deck = kFreeSquare;
  deck[9] = "&";
  const Reading within = read(joined(deck));
  CHECK(within.status == C2D_ERR_INPUT);
  REQUIRE(!within.faults.empty());
  CHECK((within.faults[0].line == 10 && within.faults[0].column == 1));
  CHECK(contains_text(within.faults[0].text, "the card ends in '&', expected that only where a list goes on"));
  const Reading behind_all = behind({"&"});
  CHECK(behind_all.status == C2D_ERR_INPUT);
  REQUIRE(!behind_all.faults.empty());
  CHECK((behind_all.faults[0].line == 37 && behind_all.faults[0].column == 1));
}

TEST_CASE("deck edges: a byte that is no text ends the reading of lists that go on") {
  for (const List& cards : {List{"*FRICTION", "1 0.3 &", "\x01"}, List{"*FRICTION", "1 0.3 0.4 &", "\x01", "2 0.3 0.4"},
                            List{"*FRICTION", "x 0.3 &", "\x01"}, List{"*PATH", "1 0.5 &", "\x01", "1 1"}}) {
    CAPTURE(cards[0] + "/" + cards[1]);
    const Fault f = last_fault(read(joined(with_faults(0, cards))));
    CHECK((f.line == 39 && f.column == 1));
    CHECK(contains_text(f.text, "contains the byte 1, expected plain ASCII text"));
  }
  List deck = kFreeSquare; // and of the coefficients of the deck itself
  deck[8] = "2 0.1 &";
  deck.insert(deck.begin() + 9, "\x01");
  const Fault f = last_fault(read(joined(deck)));
  CHECK((f.line == 10 && f.column == 1));
  CHECK(contains_text(f.text, "contains the byte 1"));
}

TEST_CASE("deck edges: the hundredth fault may stand above a cycle with another, which ends the reading") {
  const Reading r = read(joined(with_faults(100, {"*PATH", "1 1", "cycle x", "1 0.5", "1 1", "*UNITS"})));
  CHECK(r.faults.size() == 101);
  CHECK(contains_text(last_fault(r).text, "too many faults"));
  CHECK(r.faults.back().line == 36 + 99 + 3);
}

TEST_CASE("deck edges: a model that has no room for the first of its load factors is not asked for the rest") {
  const List path = {"*PATH", "1 0.5 &", "0.6", "1 1"};
  const Reading whole = read(joined(with_faults(0, path)));
  size_t at = whole.model.calls.size();
  while (at-- > 0 && !(whole.model.calls[at].name == "factors" || whole.model.calls[at].name == "path")) continue;
  REQUIRE(at < whole.model.calls.size());
  const std::string name = whole.model.calls[at].name;
  for (size_t call = 0; call <= at; ++call) {
    if (whole.model.calls[call].name != name) continue;
    CAPTURE(call);
    const Reading r = read(joined(with_faults(0, path)), static_cast<int>(call));
    CHECK(r.status == C2D_ERR_LIMIT);
    CHECK(r.model.calls.size() == call + 1); // nothing is asked behind it
  }
}

TEST_CASE("deck edges: a program without cycles says so of the card that asks for one") {
  Recorder model;
  Bytes deck;
  deck.bytes = joined(with_faults(0, {"*PATH", "1 1", "cycle 7", "1 0.5", "1 1"}));
  c2d::DeckSink sink = recording_sink(model);
  sink.repeat_paths = nullptr;
  std::vector<Fault> faults;
  host::Limits sizes;
  sizes.bodies = host::Limits::kRoom;
  CHECK(c2d::read_deck_cards(&sink, read_bytes, &deck, keep_fault, &faults, &sizes) == C2D_ERR_INPUT);
  REQUIRE(faults.size() == 1);
  CHECK((faults[0].line == 39 && faults[0].column == 1 && faults[0].column_end == 5));
  CHECK(contains_text(faults[0].text, "c2d_repeat_paths"));
}

TEST_CASE("deck edges: a number whose digits count to nothing in 64 bits is the number that it is") {
  CHECK(last_call(behind({"*PATH", "1 18446744073709551616", "1 36893488147419103232"}), "path").back() == 0x1p65);
  CHECK(last_call(behind({"*PATH", "1 18446744073709551616"}), "path").back() == 0x1p64);
}
