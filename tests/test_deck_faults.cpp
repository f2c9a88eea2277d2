// Decks that are wrong: what is reported, and where.
#include "deck_recorder.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <random>

using namespace deck_test;

namespace {

struct Field {
  size_t line; // from 0
  int first, last;
};

// Every numeric field that a right deck's cards have, by the formats of Appendix B.
std::vector<Field> fields_of(const std::vector<std::string>& deck) {
  std::vector<Field> fields;
  size_t at = 0;
  const auto integer = [&](size_t line, int first, int width) {
    return std::atoi(deck[line].substr(static_cast<size_t>(first - 1), static_cast<size_t>(width)).c_str());
  };
  const auto add = [&](std::initializer_list<int> widths, int first = 1) {
    for (const int width : widths) {
      if (width > 0) fields.push_back({at, first, first + width - 1}); // < 0: columns without a field
      first += width > 0 ? width : -width;
    }
    return at++;
  };
  at = 0;
  const int headings = integer(add({5}), 1, 5);
  at += static_cast<size_t>(headings);
  add({5, 5});
  const size_t control = add({5, 5, 5});
  const int bodies = integer(control, 1, 5), zones = integer(control, 6, 5);
  int regions[2], nodes[2];
  for (int b = 0; b < bodies; ++b) {
    const size_t line = add({5, 5, 5, 5});
    regions[b] = integer(line, 1, 5), nodes[b] = integer(line, 16, 5);
  }
  for (int b = 0; b < bodies; ++b)
    for (int r = 0; r < regions[b]; ++r) add({5, 5});
  for (int b = 0; b < bodies; ++b) add({10, 10});
  const int coefficients = integer(at, 1, 5);
  add({5});
  --at;
  for (int i = 0; i < coefficients; ++i) add({10}, 7 + 10 * i), --at;
  ++at;
  for (int b = 0; b < bodies; ++b) {
    add({10, 10});
    while (integer(add({-1, 4, -1, 10, 10}), 2, 4) < nodes[b]) {
    }
  }
  for (int b = 0; b < bodies; ++b) {
    const int conditions = integer(add({5}), 1, 5);
    for (int i = 0; i < conditions; ++i) add({1, 4, 5, -1, 1, 1, 1, 1, -1, 10, 10, 10, 10});
    const int loads = integer(add({5}), 1, 5);
    for (int i = 0; i < loads; ++i) add({5, -1, 10, 10, 10, 10});
  }
  for (int z = 0; z < 3 * zones; ++z) add({5, 5, 5, 5});
  for (int b = 0; b < bodies; ++b) add({5, 5});
  const int paths = integer(add({5, 5}), 1, 5);
  for (int i = 0; i < paths; ++i) add({5, -1, 10});
  REQUIRE(at == deck.size());
  return fields;
}

// Put text into a field, to its right end.
std::vector<std::string> with(std::vector<std::string> deck, const Field& field, const std::string& text) {
  std::string& card = deck[field.line];
  if (card.size() < 80) card.resize(80, ' ');
  const size_t width = static_cast<size_t>(field.last - field.first + 1);
  std::string entry = text.size() < width ? std::string(width - text.size(), ' ') + text : text;
  card.replace(static_cast<size_t>(field.first - 1), width, entry.substr(0, width));
  return deck;
}

bool has(const Fault& fault, const char* words) { return fault.text.find(words) != std::string::npos; }

void check_first(const std::vector<std::string>& deck, int line, int column, int column_end, const char* words) {
  const Reading r = read(joined(deck));
  CAPTURE(line);
  CAPTURE(words);
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(!r.faults.empty());
  CAPTURE(r.faults[0].text);
  CHECK(r.faults[0].line == line);
  CHECK(r.faults[0].column == column);
  CHECK(r.faults[0].column_end == column_end);
  CHECK(has(r.faults[0], words));
  CHECK(r.faults.size() == 1);
}

// One card of the squares replaced: the first and only fault is there.
void check_squares(size_t line, const char* card, int column, int column_end, const char* words) {
  std::vector<std::string> deck = squares();
  deck[line - 1] = card;
  check_first(deck, static_cast<int>(line), column, column_end, words);
}

} // namespace

TEST_CASE("the deck that the faults are put into is right") { CHECK(read(joined(squares())).status == C2D_OK); }

TEST_CASE("a wrong number of cards is one fault, at the card that gives it") {
  const std::vector<std::string> sample = lines_of(load("sample.dat"));
  const struct {
    size_t line;
    const char *card, *words;
    int column;
  } wrong[] = {{72, "   14", "number of boundary condition cards is 14, but line 86 contains another kind of card after 13", 1},
               {72, "   12", "number of boundary condition cards is 12, but line 85 contains one more, or a wrong card", 1},
               {86, "    1", "number of point loads is 1, but line 87 contains another kind of card after 0", 1},
               {87, "    9", "number of boundary condition cards is 9, but line 96", 1},
               {87, "    7", "number of boundary condition cards is 7, but line 95", 1},
               {96, "    1", "number of point loads is 1, but line 97", 1},
               {17, "    2    2    2", "number of contact zones is 2, but line 100 contains another kind of card after 1", 6},
               {17, "    2    0    2", "number of contact zones is 0, but line 97 contains one more", 6}};
  for (const auto& w : wrong) {
    std::vector<std::string> deck = sample;
    deck[w.line - 1] = w.card;
    check_first(deck, static_cast<int>(w.line), w.column, w.column + 4, w.words);
  }
}

TEST_CASE("an empty deck") {
  const Reading r = read("");
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(r.faults.size() == 1);
  CHECK(has(r.faults[0], "empty"));
  CHECK(read("\n\n\n").status == C2D_ERR_INPUT);
}

TEST_CASE("a deck that ends early says so, wherever it ends") {
  for (const std::vector<std::string>& deck : {squares(), lines_of(load("sample.dat")), lines_of(load("ring3.dat"))})
    for (size_t n = 0; n < deck.size(); ++n) {
      CAPTURE(n);
      const Reading r = read(joined(std::vector<std::string>(deck.begin(), deck.begin() + static_cast<long>(n))));
      CHECK(r.status == C2D_ERR_INPUT);
      REQUIRE(r.faults.size() == 1);
      CHECK(r.faults[0].line == static_cast<int>(n > 0 ? n : 1));
      CHECK(has(r.faults[0], n > 0 ? "the deck ends here, expected " : "empty"));
    }
}

TEST_CASE("letters in any number field are found there") {
  for (const std::vector<std::string>& deck : {squares(), lines_of(load("sample.dat"))})
    for (const Field& field : fields_of(deck)) {
      CAPTURE(field.line + 1);
      CAPTURE(field.first);
      const Reading r = read(joined(with(deck, field, "x")));
      CHECK(r.status == C2D_ERR_INPUT);
      REQUIRE(r.faults.size() == 1);
      CAPTURE(r.faults[0].text);
      CHECK(r.faults[0].line == static_cast<int>(field.line + 1));
      CHECK(r.faults[0].column == field.first);
      CHECK(r.faults[0].column_end == field.last);
      CHECK(has(r.faults[0], "'x', expected a"));
    }
}

TEST_CASE("what is no finite number is refused in any real field") {
  const std::vector<std::string> deck = squares();
  for (const Field& field : fields_of(deck)) {
    if (field.last - field.first != 9) continue;
    for (const char* text : {"NaN", "Inf", "-Infinity", "1e999", "1 2", "1.2.3", "1e", "."}) {
      CAPTURE(field.line + 1);
      CAPTURE(text);
      const Reading r = read(joined(with(deck, field, text)));
      CHECK(r.status == C2D_ERR_INPUT);
      REQUIRE(r.faults.size() == 1);
      CHECK(r.faults[0].line == static_cast<int>(field.line + 1));
      CHECK(r.faults[0].column == field.first);
      CHECK(r.faults[0].column_end == field.last);
      CHECK(has(r.faults[0], text));
    }
  }
}

TEST_CASE("several faults are all told, in order") {
  std::vector<std::string> deck = squares();
  deck[8] = "      -1.0       0.7";
  deck[10] = "    1      -0.5";
  deck[13] = "    2        x.        1.";
  deck[22] = "    5    3 1120";
  const Reading r = read(joined(deck));
  CHECK(r.status == C2D_ERR_INPUT);
  std::vector<int> lines;
  for (const Fault& f : r.faults) lines.push_back(f.line * 100 + f.column);
  // The generated condition of line 24 follows a card without a known place: it is no fault of its own.
  CHECK(lines == std::vector<int>{901, 911, 1107, 1407, 2302, 2306, 2314});
}

TEST_CASE("a wrong count is one fault: what only seems wrong after it is not told") {
  const auto told = [](size_t line, const char* card) {
    std::vector<std::string> deck = squares();
    deck[line] = card;
    const Reading r = read(joined(deck));
    CHECK(r.status == C2D_ERR_INPUT);
    REQUIRE(r.faults.size() == 1);
    CHECK(has(r.faults[0], "; the rest cannot be read without it"));
    return r.faults[0].line;
  };
  CHECK(told(0, "    2") > 1);
  CHECK(told(3, "    1    1    2") == 6); // a body may meet itself: the second one's card is the first that is wrong
  CHECK(told(4, "    1    2    5    5") >= 5);
  CHECK(told(4, "    2    2    4    4") >= 5);
}

TEST_CASE("sizes") {
  check_squares(1, "    0", 1, 5, "number of heading cards is 0, expected at least 1");
  check_squares(3, "    3    1", 1, 5, "is 3, expected 0 to 2");
  check_squares(4, "   -1    1    2", 1, 5, "number of bodies is -1, expected at least 1");
  check_squares(4, "    0    1    2", 1, 5, "number of bodies is 0");
  check_squares(4, "    2   -1    2", 6, 10, "number of contact zones is -1, expected at least 0");
  check_squares(4, "    2    1    5", 11, 15, "is 5, expected 1 to 4");
  check_squares(4, "    2    1     ", 11, 15, "is 0, expected 1 to 4");
  check_squares(5, "    0    2    4    4", 1, 5, "number of regions is 0");
  check_squares(5, "    5    2    4    4", 1, 5, "number of regions is 5, expected at most 4");
  check_squares(5, "    1    5    4    4", 6, 10, "is 5, expected 2 to 4");
  check_squares(5, "    1    2   -4    4", 11, 15, "number of elements is -4");
  check_squares(5, "    1    2    0    4", 11, 15, "number of elements is 0");
  check_squares(5, "    1    2    4    0", 16, 20, "number of boundary points is 0");
  check_squares(5, "    1    3    4    4", 16, 20, "number of boundary points is 4, expected 8");
  check_squares(11, "    0", 1, 5, "number of coefficients of friction is 0, expected at least 1");
  check_squares(22, "   -1", 1, 5, "number of boundary condition cards is -1");
  check_squares(25, "   -1", 1, 5, "number of point loads is -1");
  check_squares(35, "    0   10", 1, 5, "number of load cards is 0, expected at least 1");
  check_squares(35, "    1    0", 6, 10, "limit of iterations is 0, expected at least 1");
  check_squares(36, "    0       1.0", 1, 5, "number of load increments is 0, expected at least 1");
}

TEST_CASE("contact needs two bodies and IOUT 1 or more") {
  std::vector<std::string> deck = squares();
  deck[2] = "    0    0";
  check_first(deck, 4, 6, 10, "a stress analysis");
  deck = lines_of(load("plate.dat"));
  deck[3] = "    1    1    2"; // a body alone may meet itself, but the zone's card is not there
  const Reading r = read(joined(deck));
  REQUIRE(!r.faults.empty());
  CHECK(has(r.faults[0], "number of contact zones is 1"));
}

TEST_CASE("regions") {
  check_squares(7, "    2    4", 1, 5, "first element of the region is 2, expected 1");
  check_squares(7, "    1    3", 6, 10, "last element of the region is 3, expected 4");
  check_squares(7, "    1    5", 6, 10, "last element of the region is 5, expected 4");
  check_squares(8, "    2    4", 1, 5, "first element of the region is 2, expected 1");
  // Numbers that go on in body 2: so they must on the condition and zone cards.
  std::vector<std::string> deck = squares();
  deck[7] = "    6    8";
  deck[26] = "    7    1 0011";
  deck[30] = "    3    3    5    5";
  check_first(deck, 8, 1, 5, "first element of the region is 6, expected 5");
}

TEST_CASE("materials and friction") {
  check_squares(9, "       0.0       0.3", 1, 10, "Young's modulus is 0, expected more than 0");
  check_squares(9, "     -10.0       0.3", 1, 10, "Young's modulus is -10");
  check_squares(9, "                 0.3", 1, 10, "Young's modulus is 0");
  check_squares(9, "     100.0      0.51", 11, 20, "Poisson's ratio is 0.51, expected more than -1 and at most 0.5");
  check_squares(9, "     100.0      -1.0", 11, 20, "Poisson's ratio is -1");
  check_squares(11, "    1      -0.1", 7, 16, "coefficient of friction is -0.1, expected at least 0");
  std::vector<std::string> deck = squares();
  deck[8] = "     100.0      -0.6";
  CHECK(read(joined(deck)).status == C2D_OK);
  deck[2] = "    1    1";
  check_first(deck, 9, 11, 20, "plane stress");
  deck[8] = "     100.0       0.5";
  CHECK(read(joined(deck)).status == C2D_OK);
}

TEST_CASE("nodes") {
  check_squares(13, "    2        0.        0.", 2, 5, "first node number is 2, expected 1");
  check_squares(14, "    1        1.        0.", 2, 5, "node number is 1, expected 2 to 4");
  check_squares(15, "    9        1.        1.", 2, 5, "node number is 9, expected 3 to 4");
  check_squares(16, "    3        0.        1.", 2, 5, "node number is 3, expected 4");
  check_squares(14, "Q   2        1.        0.", 1, 1, "'Q', expected a coordinate letter, which is blank or P");
  check_squares(14, "p   2        1.        0.", 1, 1, "'p', expected a coordinate letter");
  check_squares(14, "C   2        1.        0.", 1, 1, "coordinate letter, which is blank or P");
  check_squares(14, "    2 1      1.        0.", 7, 16, "'1      1.', expected a number without a blank");
  check_squares(14, "    2x       1.        0.", 6, 6, "expected a blank");
  check_squares(14, "P   2       -1.        0.", 7, 16, "radius is -1");
  std::vector<std::string> deck = squares();
  deck[13] = "P   2        1.        0.";
  deck.erase(deck.begin() + 14);
  deck[14] = "P   4      1.01       90.";
  check_first(deck, 15, 7, 16, "radius is 1.01, expected 1");
  deck[14] = "P   4  1.000001       90.";
  CHECK(read(joined(deck)).status == C2D_OK);
  deck[13] = "    2        1.        0.";
  check_first(deck, 15, 1, 1, "expected a P card before this one too");
  // The last node is missing: the next card, an origin, cannot be a node card.
  deck = squares();
  deck.erase(deck.begin() + 15);
  const Reading r = read(joined(deck));
  REQUIRE(!r.faults.empty());
  CHECK(r.faults[0].line == 16);
}

TEST_CASE("conditions and point loads") {
  check_squares(23, "    5    1 1100", 2, 5, "element number is 5, expected 1 to 4");
  check_squares(23, "    0    1 1100", 2, 5, "element number is 0, expected 1 to 4");
  check_squares(24, "1   1    3 1100", 6, 10, "local node number is 3, expected 1 to 2");
  check_squares(23, "    1    1 1102", 15, 15, "is 2, expected 0 to 1");
  check_squares(23, "    1    11100 ", 11, 11, "expected a blank");
  check_squares(23, "1   1    1 1100", 1, 1, "generates conditions");
  check_squares(24, "1   1    1 1100", 2, 10, "expected an end after that of the card before (element 1 node 1)");
  check_squares(24, "3   1    2 1100", 1, 1, "is 3, expected 0 to 1");
  check_squares(23, "    1    1 11005", 16, 16, "expected a blank");
  std::vector<std::string> deck = squares();
  deck[7] = "    5    8";
  deck[26] = "    9    1 0011";
  deck[30] = "    3    3    5    5";
  check_first(deck, 27, 2, 5, "element number is 9, expected 5 to 8");
}

TEST_CASE("contact zones") {
  check_squares(30, "    2    2    2    1", 6, 10, "both bodies of the zone are 2, expected two different ones");
  check_squares(30, "    1    1    2    1", 6, 10, "both bodies of the zone are 1, expected two different ones");
  check_squares(30, "    3    2    2    1", 1, 5, "is 3, expected 1 to 2");
  check_squares(30, "    1    0    2    1", 6, 10, "is 0, expected 1 to 2");
  check_squares(30, "    1    2    0    1", 11, 15, "number of contact nodes of the zone is 0, expected at least 1");
  check_squares(30, "    1    2    3    1", 11, 15, "number of contact nodes of the zone is 3, expected at most 2");
  check_squares(31, "    2    3    1    1", 1, 10, "2 to 3 of body 1 make 2, expected 1");
  check_squares(31, "    3    3    0    1", 11, 15, "is 0, expected 1 to 4");
  check_squares(32, "    3    4    2    4", 11, 20, "2 to 4 of body 2 make 3, expected 2");
  check_squares(32, "    3    5    2    1", 6, 10, "is 5, expected 1 to 4");
  check_squares(33, "    3    1", 1, 5, "number of contact nodes of body 1 is 3, expected 2, the sum of the zones");
  check_squares(34, "    2    2", 6, 10, "number of contact elements of body 2 is 2, expected 1, the sum of the zones");
  check_squares(34, "   -2    1", 1, 5, "number of contact nodes of body 2 is -2, expected at least 0");
  std::vector<std::string> deck = squares(); // a shorter list of nodes is legal
  deck[29] = "    1    2    1    1";
  deck[31] = "    4    4    1    1";
  deck[32] = deck[33] = "    1    1";
  CHECK(read(joined(deck)).status == C2D_OK);
  deck = squares(); // so are its bodies in the other order: the first is side 1
  deck[29] = "    2    1    2    1";
  deck[30] = "    1    1    3    3";
  deck[31] = "    2    1    3    4";
  const Reading other = read(joined(deck));
  CHECK(other.status == C2D_OK);
  for (const Call& call : other.model.calls)
    if (call.name == "zone") CHECK(call.numbers == std::vector<double>{2, 1, 1, 1, 3, 3, 2, 1, 3, 4, 2, 1});
}

TEST_CASE("numbers out of their columns") {
  check_squares(3, "    0    1     0", 16, 16, "these columns are outside all fields");
  check_squares(9, "        100.0       0.3", 21, 23, "these columns are outside all fields");
  check_squares(36, "    4 1     1.0", 7, 16, "blank inside");
  check_squares(36, "    41      1.0", 6, 6, "expected a blank");
  std::vector<std::string> deck = squares();
  deck[2] += " plane strain";
  CHECK(read(joined(deck)).status == C2D_OK);
}

TEST_CASE("tabs, binary files, long lines") {
  check_squares(3, "\t0    1", 1, 1, "tab");
  check_squares(14, "    2\t1.\t0.", 6, 6, "tab");
  std::vector<std::string> deck = squares();
  deck[5] = std::string("    1\x01   2    4    4");
  check_first(deck, 6, 6, 6, "contains the byte 1");
  deck[5] = "    1    2    4    4  \xc3\xa9l\xc3\xa9ments";
  check_first(deck, 6, 23, 23, "contains the byte 195");
  check_first({"\xef\xbb\xbf    1"}, 1, 1, 1, "byte order mark");
  std::string binary;
  for (int i = 0; i < 4000; ++i) binary += static_cast<char>(i * 37 % 251);
  CHECK(read(binary).faults.size() == 1);
  CHECK(read(std::string(4000, '\0')).faults.size() == 1);
  CHECK(read(std::string(100000, '1')).status == C2D_ERR_INPUT);
  deck = squares();
  deck[2] += std::string(100000, ' ') + "7";
  CHECK(read(joined(deck)).status == C2D_OK);
}

TEST_CASE("comments, keywords and what follows the last card") {
  std::vector<std::string> deck = squares();
  deck.insert(deck.begin() + 5, "C  12 is a number");
  check_first(deck, 6, 1, 1, "coordinate letter, which is blank or P");
  deck = squares();
  deck.push_back("C the end");
  deck.push_back("");
  CHECK(read(joined(deck)).status == C2D_OK);
  deck.push_back("*POINTSX   3");
  deck.push_back("     1.0       2.0");
  check_first(deck, static_cast<int>(deck.size()) - 1, 1, 8, "*POINTSX is not a known keyword");
  deck = squares();
  deck.push_back("    1       2.0");
  check_first(deck, static_cast<int>(deck.size()), 0, 0, "follows the last load card");
  check_first({"*FREE"}, 1, 0, 0, "the deck ends here, expected the number of heading cards");
}

TEST_CASE("a hundred faults are enough") {
  std::vector<std::string> deck = squares();
  deck[21] = "  999";
  deck.insert(deck.begin() + 22, 997, "    9    1 1100");
  const Reading r = read(joined(deck));
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(r.faults.size() == 101);
  CHECK(has(r.faults.back(), "too many faults"));
}

TEST_CASE("a line that cannot be read") {
  for (int line = 1; line <= 36; ++line) {
    const Reading r = read(joined(squares()), -1, C2D_OK, 0, line);
    CAPTURE(line);
    CHECK(r.status == C2D_ERR_READ);
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults[0].status == C2D_ERR_READ);
    CHECK(r.faults[0].host_code == -77);
  }
}

TEST_CASE("calls that the model refuses") {
  const int calls = static_cast<int>(read(joined(squares())).model.calls.size());
  for (int i = 0; i < calls; ++i) {
    CAPTURE(i);
    const Reading limit = read(joined(squares()), i, C2D_ERR_LIMIT);
    CHECK(limit.status == C2D_ERR_LIMIT);
    CHECK(limit.model.calls.size() == static_cast<size_t>(i + 1)); // nothing after it
    CHECK(limit.faults.empty());                                   // the model has told it
    const Reading input = read(joined(squares()), i, C2D_ERR_ARGUMENT);
    CHECK(input.status == C2D_ERR_INPUT);
    CHECK(input.model.calls.size() == static_cast<size_t>(calls)); // goes on
  }
}

TEST_CASE("a workspace made for other functional nodes or bodies") {
  CHECK(read(joined(squares()), -1, C2D_OK, 2).status == C2D_OK);
  const Reading r = read(joined(squares()), -1, C2D_OK, 3);
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(r.faults.size() == 1);
  CHECK(has(r.faults[0], "the workspace was made for 3"));
  Bytes deck;
  deck.bytes = joined(squares());
  Recorder model;
  c2d::DeckSink sink = recording_sink(model);
  sink.bodies = 1;
  std::vector<Fault> faults;
  host::Limits room;
  CHECK(c2d::read_deck_cards(&sink, read_bytes, &deck, keep_fault, &faults, &room) == C2D_ERR_INPUT);
  REQUIRE(faults.size() == 1);
  CHECK(has(faults[0], "number of bodies is 2, but the workspace was made for 1"));
}

TEST_CASE("scan keeps the first fault, check tells all") {
  std::vector<std::string> lines = squares();
  lines[8] = "      -1.0       0.7";
  Bytes deck;
  deck.bytes = joined(lines);
  host::Limits sizes;
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_scan_deck(read_bytes, &deck, &sizes, &why) == C2D_ERR_INPUT);
  CHECK(sizes.bodies == 2);        // the room it was given: untouched
  CHECK(sizes.body == sizes.list); // the list itself holds anything now
  CHECK(sizes.function_nodes == 0);
  CHECK(sizes.pairs == 0);
  CHECK(why.status == C2D_ERR_INPUT);
  CHECK(why.line == 9);
  CHECK(why.column == 1);
  CHECK(why.column_end == 10);
  CHECK(why.body == 1);
  CHECK(std::string(why.text) == "Young's modulus is -1, expected more than 0");
  deck.at = 0;
  std::vector<Fault> faults;
  CHECK(c2d_check_deck(read_bytes, &deck, &sizes, keep_fault, &faults) == C2D_ERR_INPUT);
  CHECK(faults.size() == 2);
}

TEST_CASE("mutated decks neither crash nor loop, and every refusal says where") {
  std::mt19937 random(56);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  const std::string sources[2] = {load("sample.dat"), joined(squares())};
  static const char kBytes[] = " 0123456789-+.ECPx*\n\t\r\x80";
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string bytes = sources[i % 2];
    for (size_t k = below(4) + 1; k > 0; --k) {
      const size_t at = below(bytes.size());
      const char byte = kBytes[below(sizeof kBytes - 1)];
      switch (below(4)) {
      case 0: bytes[at] = byte; break;
      case 1: bytes.insert(at, 1, byte); break;
      case 2: bytes.erase(at, 1 + below(40)); break;
      default: bytes.insert(at, bytes.substr(below(bytes.size()), below(60))); break;
      }
      if (bytes.empty()) bytes = "1";
    }
    const int lines = 1 + static_cast<int>(std::count(bytes.begin(), bytes.end(), '\n'));
    const Reading r = read(bytes);
    CAPTURE(i);
    bool sound = r.faults.size() <= 101 && (r.status == C2D_OK) == r.faults.empty();
    for (const Fault& f : r.faults)
      sound = sound && f.line >= 1 && f.line <= lines && f.column >= 0 && f.column_end >= f.column && !f.text.empty() &&
              f.text.size() < 300;
    CHECK(sound);
    if (r.status == C2D_OK) ++accepted;
  }
  CHECK(accepted > 0); // a blank more at a line's end is no fault
  CHECK(accepted < 15000);
}

TEST_CASE("a boundary point more than a closed region has asks for a line of symmetry") {
  std::vector<std::string> deck = squares();
  deck[4] = "    1    2    4    5";
  deck.insert(deck.begin() + 16, "    5        0.       0.5");
  check_first(deck, 5, 0, 0, "number of boundary points is 5, expected 4: 4 elements of 2 nodes");
}
