// Keyword cards behind the load cards.
#include "deck_recorder.hpp"

#include "deck/keywords.hpp"
#include "deck/words.hpp"

#include <doctest/doctest.h>

#include <cstring>

using namespace deck_test;

namespace {

c2d::Words split(const char* text) {
  c2d::Words words = {};
  c2d::split_words(text, static_cast<int32_t>(std::strlen(text)), words);
  CHECK(!words.is_part);
  return words;
}

std::vector<std::string> fields(const char* text) {
  const c2d::Words words = split(text);
  std::vector<std::string> list;
  for (int32_t i = 0; i < words.count; ++i) {
    char field[200];
    c2d::copy_word(words, i, field, sizeof field);
    list.push_back(field);
  }
  return list;
}

using List = std::vector<std::string>;

Reading with_cards(const List& cards) {
  List deck = squares();
  deck.insert(deck.end(), cards.begin(), cards.end());
  return read(joined(deck));
}

// The one fault of these cards behind a deck, its line counted from the first of them (1).
Fault the_fault(const List& cards) {
  const Reading r = with_cards(cards);
  CAPTURE(cards[0]);
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(r.faults.size() == 1);
  Fault fault = r.faults[0];
  fault.line -= static_cast<int>(squares().size());
  return fault;
}

} // namespace

TEST_CASE("fields between blanks and commas") {
  CHECK(fields("") == List{});
  CHECK(fields("   ") == List{});
  CHECK(fields("1 2") == List{"1", "2"});
  CHECK(fields("  1,2") == List{"1", "2"});
  CHECK(fields("1 , 2") == List{"1", "2"});
  CHECK(fields("1\t2") == List{"1", "2"});
  CHECK(fields("1,,2") == List{"1", "", "2"});
  CHECK(fields("1, ,2") == List{"1", "", "2"});
  CHECK(fields(",1") == List{"", "1"});
  CHECK(fields("1,2,") == List{"1", "2"});
  CHECK(fields("1,2,,") == List{"1", "2", ""});
  CHECK(fields("1 2 ! 3") == List{"1", "2"});
  CHECK(fields("1 2! 3") == List{"1", "2"});
  CHECK(fields("! 3") == List{});
  const c2d::Words words = split("  ab, -1.5e3 ,,x");
  REQUIRE(words.count == 4);
  CHECK(words.word[0].column == 3);
  CHECK(words.word[0].column_end == 4);
  CHECK(words.word[1].column == 7);
  CHECK(words.word[1].column_end == 12);
  CHECK(words.word[2].column_end == words.word[2].column - 1);
  CHECK(words.word[3].column == 16);
  CHECK(words.end == 17);
  CHECK(c2d::word_is(words, 0, "AB"));
  CHECK(!c2d::word_is(words, 0, "A"));
  CHECK(!c2d::word_is(words, 0, "ABC"));
  CHECK(!c2d::word_is(words, 9, "AB"));
  std::string many;
  for (int i = 0; i < c2d::kMaximumWords; ++i) many += "1 ";
  c2d::Words all = {};
  const auto split_all = [&](int32_t from) { c2d::split_words(many.c_str(), static_cast<int32_t>(many.size()), all, from); };
  split_all(0);
  CHECK(!all.is_part);
  many += ",,2 3"; // the empty field behind the 32nd is not lost
  split_all(0);
  CHECK(all.is_part);
  CHECK(all.count == c2d::kMaximumWords);
  split_all(all.end - 1);
  CHECK(!all.is_part);
  REQUIRE(all.count == 3);
  CHECK(all.word[0].column_end < all.word[0].column);
  CHECK(c2d::word_is(all, 2, "3"));
  many = "1 2 &";
  split_all(0);
  CHECK(all.is_part);
  CHECK(all.count == 2);
  split_all(all.end - 1);
  CHECK(all.is_part);
  CHECK(all.count == 0);
}

TEST_CASE("units") {
  for (const char* card : {"*UNITS mm N", "*units mm,N ! as drawn", "  *Units\tmm\tN",
                           "*UNITS mm N ! gr\xc3\xb6\xc3\x9f"
                           "e"}) {
    CAPTURE(card);
    const Reading r = with_cards({"C a remark of the old kind", "", card, "C another", "! and one more"});
    CHECK(r.status == C2D_OK);
    CHECK(r.faults.empty());
    CHECK(r.model.units == "mm N");
    CHECK(r.model.line == static_cast<int>(squares().size()) + 3);
  }
  CHECK(with_cards({}).model.units == "");
}

TEST_CASE("wrong keyword cards") {
  Fault f = the_fault({"*SYMETRY X 0", "1 2 3", "! nothing"});
  CHECK(f.line == 1);
  CHECK(f.column == 1);
  CHECK(f.column_end == 8);
  f = the_fault({"*UNIT mm N"});
  CHECK(f.text == "*UNIT is not a known keyword; did you mean *UNITS?");
  CHECK(f.column_end == 5);
  CHECK(the_fault({"*unist"}).text == "*UNIST is not a known keyword; did you mean *UNITS?");
  f = the_fault({" *XYZXYZ"});
  CHECK(f.column == 2);
  CHECK(f.text.find("*XYZXYZ is not a known keyword; known are *") == 0);
  CHECK(f.text.find("*UNITS") != std::string::npos);
  CHECK(the_fault({"*"}).text.find("* is not a known keyword") == 0);
  CHECK(the_fault({"*" + std::string(150, 'A')}).text.find("is not a known keyword") != std::string::npos);
  f = the_fault({"*UNITS mm N", "", "*UNITS cm N"});
  CHECK(f.line == 3);
  CHECK(f.text == "*UNITS appears twice in the deck, expected it once");
  f = the_fault({"1 2 3"});
  CHECK(f.text == "a card follows the last load card, expected a keyword card or the end of the deck");
  f = the_fault({"*UNITS mm N", "1 2 3", "4 5"});
  CHECK(f.line == 2);
  CHECK(f.text == "the card does not belong to *UNITS above it, expected a keyword card or the end of the deck");
}

TEST_CASE("keywords that say a thing twice, or nothing") {
  Fault f = the_fault({"*CASES 2", "case 2", "case 1", " case 2"});
  CHECK(f.text == "case 2 appears twice below *CASES, expected it once");
  CHECK(f.line == 4);
  CHECK(f.column == 7);
  f = the_fault({"*PATH", "*UNITS mm N"});
  CHECK(f.text == "*PATH without cards, expected at least one: increments f1 ... fn");
  CHECK(f.line == 1);
  f = the_fault({"", "*FRICTION", "", "*UNITS mm N"});
  CHECK(f.text == "*FRICTION without cards, expected at least one: zone mu ...");
  CHECK(f.line == 2);
  f = the_fault({"*UNITS"}); // two fields are missing, which is told once
  CHECK(f.text == "the card ends here, expected name of the unit of length");
}

TEST_CASE("wrong fields on a keyword card") {
  Fault f = the_fault({"*UNITS mm   ! no force"});
  CHECK(f.text == "the card ends here, expected name of the unit of force");
  CHECK(f.column == 10);
  f = the_fault({"*UNITS mm N kg s"});
  CHECK(f.text == "the card has 4 fields, expected 2");
  CHECK(f.column == 13);
  CHECK(f.column_end == 16);
  f = the_fault({"*UNITS mm sixteenletterslo"});
  CHECK(f.text == "name of the unit of force has 16 characters, expected at most 15");
  CHECK(f.column == 11);
  CHECK(f.column_end == 26);
  CHECK(with_cards({"*UNITS mm fifteenletterslo"}).status == C2D_ERR_INPUT);
  CHECK(with_cards({"*UNITS mm fifteenletters."}).status == C2D_OK);
}

TEST_CASE("lines too long and too many fields") {
  constexpr size_t kColumns = c2d::kFreeColumns;
  CHECK(with_cards({"*UNITS mm" + std::string(kColumns - 10, ' ') + "N"}).status == C2D_OK); // the last column
  const Fault f = the_fault({"*UNITS mm" + std::string(kColumns - 11, ' ') + "cwt"});
  CHECK(f.text.find("the card extends beyond column " + std::to_string(kColumns)) == 0);
  CHECK(f.column == static_cast<int>(kColumns) + 1);
  CHECK(f.column_end == static_cast<int>(kColumns) + 1);
  CHECK(with_cards({"*UNITS mm N" + std::string(kColumns + 140, ' ')}).status == C2D_OK);
  CHECK(with_cards({"*UNITS mm N !" + std::string(kColumns + 140, 'x')}).status == C2D_OK);
  std::string many = "*UNITS";
  for (int i = 0; i < 40; ++i) many += " 1";
  const Reading r = with_cards({many});
  REQUIRE(!r.faults.empty());
  CHECK(r.faults[0].text == "the card has more than 32 fields");
}

// Of each path segment the increments, then its factors.
std::vector<std::vector<double>> segments(const Reading& reading) {
  std::vector<std::vector<double>> list;
  for (const Call& call : reading.model.calls) {
    if (call.name == "path") list.push_back(call.numbers);
    if (call.name != "more factors") continue;
    CHECK(call.numbers[0] == static_cast<double>(list.back().size() - 1)); // those given before
    list.back().insert(list.back().end(), call.numbers.begin() + 1, call.numbers.end());
  }
  list.erase(list.begin()); // the load card
  return list;
}

TEST_CASE("load factors go on over fields and lines of any number") {
  for (const int cases : {2, 31, 32, 33, 64, 400}) {
    CAPTURE(cases);
    std::string one_line = "7", many_lines = "7 &\n! not yet\n&\n";
    std::vector<double> expected = {7};
    for (int k = 1; k <= cases; ++k) {
      one_line += (k % 3 == 0 ? "," : " ") + std::to_string(k);
      many_lines += std::to_string(k) + (k < cases && k % 5 == 1 ? " &\n" : " ");
      expected.push_back(k);
    }
    List cards = {"*CASES " + std::to_string(cases), "*PATH", many_lines, many_lines};
    if (one_line.size() <= c2d::kFreeColumns) cards.push_back(one_line);
    cards.push_back("*UNITS mm N");
    const Reading r = with_cards(cards);
    REQUIRE(r.status == C2D_OK);
    CHECK(segments(r) == std::vector<std::vector<double>>(cards.size() - 3, expected));
  }
}

TEST_CASE("what is wrong with a card that goes on") {
  Fault f = the_fault({"*PATH", "1 1 &", "x"});
  CHECK(f.text == "column 1 contains 'x', expected a number: load factor");
  CHECK(f.line == 3);
  f = the_fault({"*PATH", "1 &"});
  CHECK(f.text == "the deck ends here, expected the fields that follow '&'");
  const Reading other = with_cards({"*UNITS mm &", "N"});
  REQUIRE(!other.faults.empty());
  CHECK(other.faults[0].text.find("the card ends in '&', expected that only where a list goes on") == 0);
  CHECK(other.faults[0].column == 11);
}

TEST_CASE("scanning walks the keyword cards too") {
  List deck = squares();
  deck.push_back("*UNIT mm N");
  Bytes bytes;
  bytes.bytes = joined(deck);
  host::Limits sizes;
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_scan_deck(read_bytes, &bytes, &sizes, &why) == C2D_ERR_INPUT);
  CHECK(why.line == static_cast<int>(deck.size()));
  CHECK(std::string(why.text) == "*UNIT is not a known keyword; did you mean *UNITS?");
}

TEST_CASE("a cycle below *PATH") {
  const auto last_call = [](const List& cards) {
    const Reading r = with_cards(cards);
    CHECK(r.status == C2D_OK);
    REQUIRE(!r.model.calls.empty());
    for (const Call& call : r.model.calls)
      if (call.name == "repeat paths") return call.numbers;
    return std::vector<double>{};
  };
  CHECK(last_call({"*PATH", "1 1", "1 0.5", "1 1"}).empty());
  CHECK(last_call({"*PATH", "1 1", "cycle", "1 0.5", "1 1"}) == std::vector<double>{2, 0, 0, 0});
  CHECK(last_call({"*PATH", "1 1", "CYCLE 12 ! twelve", "1 0.5", "2 0.6", "1 1"}) == std::vector<double>{3, 12, 0, 0});
  CHECK(last_call({"*PATH", "1 1", "cycle 7 frictionless", "1 0.5", "1 1", "*UNITS mm N"}) == std::vector<double>{2, 7, 0, 1});
  CHECK(last_call({"*PATH", "1 1", "cycle frictionless", "1 0.5", "1 1"}) == std::vector<double>{2, 0, 0, 1});
  CHECK(last_call({"*PATH", "1 1", "cycle digits 5", "1 0.5", "1 1"}) == std::vector<double>{2, 0, 5, 0});
  CHECK(last_call({"*PATH", "1 1", "cycle 9 digits 5 frictionless", "1 0.5", "1 1"}) == std::vector<double>{2, 9, 5, 1});
  // A fault of a segment is reported alone.
  const Fault f = the_fault({"*PATH", "1 1", "cycle", "1 x", "1 1"});
  CHECK(f.line == 4);
}

TEST_CASE("units in a solver") {
  host::Limits sizes;
  List deck = squares();
  deck.push_back("*UNITS mm kN");
  Bytes bytes;
  bytes.bytes = joined(deck);
  REQUIRE(c2d_scan_deck(read_bytes, &bytes, &sizes, nullptr) == C2D_OK);
  uint64_t need = 0;
  REQUIRE(c2d_memory_need(&sizes, &need, nullptr, nullptr) == C2D_OK);
  std::vector<char> memory(need);
  c2d_solver* solver = nullptr;
  REQUIRE(c2d_create(&solver, memory.data(), memory.size(), &sizes, nullptr, nullptr) == C2D_OK);
  bytes.at = 0;
  REQUIRE(c2d_read_deck(solver, read_bytes, &bytes) == C2D_OK);
  host::Summary summary;
  REQUIRE(host::get_summary(solver, summary) == C2D_OK);
  CHECK(std::string(summary.unit_length) == "mm");
  CHECK(std::string(summary.unit_force) == "kN");
  CHECK(c2d_set_units(solver, "sixteenletterslo", "N") == C2D_ERR_ARGUMENT);
  REQUIRE(host::get_summary(solver, summary) == C2D_OK);
  CHECK(std::string(summary.unit_length) == "mm");
  CHECK(c2d_set_units(solver, "m", nullptr) == C2D_OK);
  REQUIRE(host::get_summary(solver, summary) == C2D_OK);
  CHECK(std::string(summary.unit_length) == "m");
  CHECK(std::string(summary.unit_force) == "");
  CHECK(summary.state == C2D_STATE_MODEL);
  c2d_close(solver);
}
