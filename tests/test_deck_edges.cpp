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
};

std::vector<Told> walk(const List& lines) {
  Bytes deck;
  deck.bytes = joined(lines);
  std::vector<Told> told;
  c2d_body_limits room[2] = {};
  const auto keep = [](void* context, const c2d_card* card) {
    static_cast<std::vector<Told>*>(context)->push_back({card->kind, card->line, card->column, card->width});
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
      ++seen;
    }
  CHECK(seen == 4);
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
    CHECK(the_fault(behind({"*BODY FORCE 1 3 0 -1", card, card})).text.find("twice") != std::string::npos);
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
  CHECK(the_fault(behind({"*NAME BODY 2 b", "*NAME BODY 2 c"})).text.find("body 2 is named twice") != std::string::npos);
  CHECK(the_fault(behind({"*NAME ZONE 1 b", "*NAME ZONE 1 c"})).text.find("zone 1 is named twice") != std::string::npos);
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
  CHECK(the_fault(behind({"*BODY FORCE 1 2 0 -1", "*BODY FORCE 1 2 0 -1"})).text.find("twice") != std::string::npos);
  CHECK(behind({"*BODY FORCE 1 200 0 -1", "*BODY FORCE 1 200 0 -1"}).status == C2D_OK);
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
  CHECK(contains_text(f.text, "column 12 holds the byte 1, expected plain ASCII text"));
}

TEST_CASE("deck edges: load cases beyond the first 256 may stand below *CASES more than once") {
  const List cards = {"*CASES 300", "case 257", "load 1 0 0 1 0", "case 257", "load 1 0 0 2 0"};
  const Reading r = behind(cards);
  CHECK(r.sizes.load_cases == 300);
  CHECK(last_call(r, "point load") == std::vector<double>{1, 0, 0, 2, 0, 257});
  List twice = cards;
  twice[1] = twice[3] = "case 256";
  CHECK(contains_text(the_fault(behind(twice)).text, "case 256 stands below *CASES twice"));
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
