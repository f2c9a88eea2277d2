// Decks of the free form, and conversion between the two forms.
#include "deck_recorder.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>

using namespace deck_test;

namespace {

using List = std::vector<std::string>;

// squares() of deck_recorder.hpp, typed by hand in the free form.
List free_squares() {
  return {"*FREE                 ! two squares, one on the other",
          "",
          "1",
          "TWO SQUARES",
          "! type of problem, output",
          "0, 1",
          "2 1 2",
          "1 2 4 4    ! regions, nodes of an element, elements, points",
          "1,2,4,4",
          "1 4",
          "1 4",
          "100 .3",
          "200,0.2",
          "1 0.5",
          "0 0",
          "1 0 0",
          "2 1 0",
          "3 1 1",
          "\t4\t0\t1",
          "0 1",
          "1 0 0",
          "  2  1  0",
          "3 1 1",
          "4 0 1",
          "2",
          "1 1 1100 0 0 0 0",
          "1 1 2 1 1 0 0 0,0,,0",
          "0",
          "1",
          "3 1 0011 0 -1 0 0",
          "1",
          "1 0.5 0.5 0 -2",
          "1 2 2 1",
          "3 3 1 1",
          "3 4 2 1",
          "2 1",
          "2 1",
          "1 10",
          "4 1"};
}

bool is_same_model(const Recorder& a, const Recorder& b) {
  if (a.title != b.title || a.units != b.units || a.calls.size() != b.calls.size()) return false;
  for (size_t i = 0; i < a.calls.size(); ++i)
    if (a.calls[i].name != b.calls[i].name || a.calls[i].numbers != b.calls[i].numbers) return false;
  return true;
}

// The one fault of free_squares() with line `line` (from 1) replaced.
Fault the_fault(size_t line, const std::string& text) {
  List deck = free_squares();
  deck[line - 1] = text;
  const Reading r = read(joined(deck));
  CAPTURE(text);
  CHECK(r.status == C2D_ERR_INPUT);
  REQUIRE(r.faults.size() >= 1);
  CHECK(r.faults.size() == 1);
  CHECK(r.faults[0].line == static_cast<int>(line));
  return r.faults[0];
}

void check_fault(size_t line, const std::string& text, int column, int column_end, const std::string& words) {
  const Fault fault = the_fault(line, text);
  CAPTURE(fault.text);
  CHECK(fault.column == column);
  CHECK(fault.column_end == column_end);
  CHECK(fault.text.find(words) != std::string::npos);
}

struct Told {
  int kind, line, column, width;
  std::string text;
  double value;
};

void keep_card(void* context, const c2d_card* card) {
  static_cast<std::vector<Told>*>(context)->push_back({card->kind, card->line, card->column, card->width,
                                                       std::string(card->text, static_cast<size_t>(card->length)),
                                                       card->value});
}

std::vector<Told> walk(const std::string& bytes) {
  Bytes deck;
  deck.bytes = bytes;
  std::vector<Told> told;
  c2d_body_limits room[2] = {};
  CHECK(c2d_walk_deck(read_bytes, &deck, room, 2, keep_card, &told, nullptr, nullptr) == C2D_OK);
  return told;
}

test::Result convert(const std::string& deck, const std::string& options = "") {
  const test::Folder folder;
  test::write_file(folder / "deck", deck);
  return test::run_shell("'" + paths::program() + "' convert '" + (folder / "deck") + "' " + options);
}

} // namespace

TEST_CASE("a free deck is the same model") {
  const Reading fixed = read(joined(squares())), free = read(joined(free_squares()));
  for (const Fault& f : free.faults) MESSAGE(f.line << ": " << f.text);
  REQUIRE(fixed.status == C2D_OK);
  REQUIRE(free.status == C2D_OK);
  CHECK(is_same_model(fixed.model, free.model));
  CHECK(host::same_numbers(fixed.sizes, free.sizes));
  CHECK(read(joined(free_squares(), "\r\n")).status == C2D_OK);
  std::string bytes = joined(free_squares());
  bytes.pop_back(); // no newline at the end
  CHECK(read(bytes).status == C2D_OK);
}

TEST_CASE("what may differ from card to card in the free form") {
  const Reading plain = read(joined(free_squares()));
  const auto is_unchanged = [&](size_t line, const std::string& text) {
    List deck = free_squares();
    deck[line - 1] = text;
    const Reading r = read(joined(deck));
    CAPTURE(text);
    CHECK(r.status == C2D_OK);
    CHECK(is_same_model(r.model, plain.model));
  };
  is_unchanged(1, "  *free");
  is_unchanged(1, "*Free ! gr\xc3\xbc\xc3\x9f"
                  "e"); // any bytes in a remark
  is_unchanged(6, "  0,1 !" + std::string(400, 'x'));
  is_unchanged(6, ", 1");                                           // nothing before the comma: 0
  is_unchanged(6, std::string(c2d::kFreeColumns - 3, ' ') + "0,1"); // up to the last column
}

TEST_CASE("coefficients of friction on as many cards as one likes") {
  List deck = free_squares();
  deck[13] = "9 .1 .2 .3 .4 .5 .6 .7 .8 .9";
  const Reading one = read(joined(deck));
  REQUIRE(one.status == C2D_OK);
  CHECK(one.sizes.coefficients == 9);
  deck[13] = "9\n.1\n.2 .3 .4 .5 ! some\n\n! others\n.6 .7 .8 .9";
  const Reading many = read(joined(deck));
  REQUIRE(many.status == C2D_OK);
  CHECK(is_same_model(one.model, many.model));
  std::string row = "70";
  for (int i = 1; i <= 70; ++i) row += (i % 20 == 0 ? " &\n" : " ") + std::to_string(i); // more than are split at a time
  deck[13] = row;
  const Reading broken = read(joined(deck));
  REQUIRE(broken.status == C2D_OK);
  deck[13] = "70";
  for (int i = 1; i <= 70; ++i) deck[13] += " " + std::to_string(i);
  CHECK(is_same_model(read(joined(deck)).model, broken.model));
  CHECK(broken.sizes.coefficients == 70);
  List fixed = squares();
  fixed[10] = "    9       0.1       0.2       0.3       0.4       0.5       0.6       0.7\n"
              "            0.8       0.9";
  CHECK(is_same_model(read(joined(fixed)).model, one.model));
  // a card too many is found where it stands: it is read as an origin
  check_fault(14, "2 0.5 0.3 0.1", 11, 13, "the card has 4 fields, expected 3");
  check_fault(14, "2 0.5 -.3", 7, 9, "coefficient of friction is -0.3");
}

TEST_CASE("coefficients of a zone go on over fields and lines of any number") {
  constexpr int kCount = 70;
  std::string row = std::to_string(kCount), zone = "1", broken = "1 &\n";
  std::vector<double> expected;
  for (int i = 1; i <= kCount; ++i) {
    row += i % 20 == 0 ? " &\n0.5" : " 0.5";
    zone += " " + std::to_string(i);
    broken += std::to_string(i) + (i % 9 == 0 ? " &\n" : " ");
    expected.push_back(i);
  }
  const auto read_with = [&](const std::string& cards) {
    List deck = free_squares();
    deck[13] = row;
    deck.insert(deck.end(), {"*FRICTION", cards, "*UNITS mm N"});
    return read(joined(deck));
  };
  for (const std::string& cards : {zone, broken}) {
    const Reading r = read_with(cards);
    for (const Fault& f : r.faults) MESSAGE(f.line << ": " << f.text);
    REQUIRE(r.status == C2D_OK);
    std::vector<double> found;
    for (const Call& call : r.model.calls)
      if (call.name == "zone friction") found.push_back(call.numbers[2]);
    CHECK(found == expected);
  }
  const auto fault_with = [&](const std::string& cards) {
    const Reading r = read_with(cards);
    REQUIRE(r.faults.size() == 1);
    return r.faults[0];
  };
  const int first = static_cast<int>(free_squares().size()) + 3 + 2; // the coefficients take 3 lines more
  Fault f = fault_with("1 0.1 &\n0.2 x");
  CHECK(f.text == "column 5 contains 'x', expected a number: coefficient of friction");
  CHECK(f.line == first + 1);
  f = fault_with(broken + "&\n 7"); // one too many
  CHECK(f.text == "the card goes on, expected its end after 70 coefficients of friction");
  CHECK(f.column == 2);
  f = fault_with("1 0.1 &\n-0.2" + zone.substr(5));
  CHECK(f.text.find("the coefficient of friction is negative") == 0);
  CHECK(f.line == first + 1);
  f = fault_with("2 0.1 &\n0.2 &\n0.3"); // the rest of a card with a fault is no card
  CHECK(f.text.find("contact zone") != std::string::npos);
  CHECK(f.line == first);
}

TEST_CASE("polar and generated nodes, generated conditions") {
  List fixed = squares(), free = free_squares();
  fixed.erase(fixed.begin() + 13, fixed.begin() + 15); // nodes 2 and 3 of body 1
  fixed[12] = "P   1      1.0       0.0";
  fixed[13] = "P   4      1.0     270.0";
  free.erase(free.begin() + 16, free.begin() + 18);
  free[15] = "P 1 1 0";
  free[16] = "p, 4, 1, 270";
  const Reading a = read(joined(fixed)), b = read(joined(free));
  REQUIRE(a.status == C2D_OK);
  for (const Fault& f : b.faults) MESSAGE(f.line << ": " << f.text);
  REQUIRE(b.status == C2D_OK);
  CHECK(is_same_model(a.model, b.model));
}

TEST_CASE("wrong fields in the free form: the column and what was expected") {
  check_fault(6, "0 x1", 3, 4, "columns 3-4 contain 'x1', expected an integer: type of output");
  check_fault(6, "3, 1", 1, 1, "problem type (IPTYPE, 0 plane strain, 1 plane stress, 2 axisymmetric) is 3, expected 0 to 2");
  check_fault(6, "0  ! no more", 2, 2, "the card ends here, expected type of output");
  check_fault(6, "0 1 2 3", 5, 7, "the card has 4 fields, expected 2");
  check_fault(7, "2 1.5 2", 3, 5, "columns 3-5 contain '1.5', expected an integer without point or exponent");
  check_fault(7, "2", 2, 2, "the card ends here, expected number of contact zones; the rest cannot be read");
  check_fault(8, "0 2 4 4", 1, 1, "number of regions is 0, expected at least 1; the rest cannot be read");
  check_fault(10, "1 3", 3, 3, "last element of the region is 3, expected 4");
  check_fault(12, "-100 .3", 1, 4, "Young's modulus is -100, expected more than 0");
  check_fault(12, "100 .7", 5, 6, "Poisson's ratio is 0.7");
  check_fault(12, "100 .3,,", 8, 8, "the card has 3 fields, expected 2");
}

TEST_CASE("wrong nodes and conditions in the free form") {
  check_fault(16, "X 1 0 0", 1, 1, "column 1 contains 'X', expected a coordinate letter, which is blank or P");
  check_fault(16, "POLAR 1 0 0", 1, 5, "columns 1-5 contain 'POLAR', expected a coordinate letter");
  check_fault(16, "C 1 0 0", 1, 1, "column 1 contains 'C', expected a coordinate letter");
  check_fault(16, "1 0 1e999", 5, 9, "expected a number of less than 1e100 in size: y of a node");
  check_fault(16, "1 0", 4, 4, "the card ends here, expected y of a node");
  check_fault(17, "P 2 -1 0", 5, 6, "radius is -1, expected at least 0");
  check_fault(17, "  7 0 0", 3, 3, "node number is 7, expected 2 to 4");
  check_fault(26, "1 1 1200 0 0 0 0", 5, 8, "codes are '1200', expected four digits 0 (known) or 1 (unknown)");
  check_fault(26, "1 1 110 0 0 0 0", 5, 7, "codes are '110', expected four digits");
  check_fault(26, "1 1 1100 2 0 0 0", 10, 10, "the x traction is 2, but its code is 1 (unknown), expected 0, or the code 0");
  check_fault(26, "1 1 0 0 1 1 0 0 0 -1e-9", 19, 23, "the y displacement is -1e-09, but its code is 1 (unknown)");
  check_fault(26, "1 1 1 1 0 2 0 0 0 0", 11, 11, "code of the y displacement (0 known, 1 unknown) is 2");
  check_fault(26, "1 1 1100 0 0 0", 15, 15, "the card has 6 fields, expected 7: element, node, four codes");
  check_fault(26, "9 1 1100 0 0 0 0", 1, 1, "element number is 9, expected 1 to 4");
  check_fault(27, "2 1 2 1100 0 0 0 0", 1, 1, "flag for generated conditions (blank, 0 or 1) is 2");
  check_fault(27, "1 1 1 1100 0 0 0 0", 3, 5, "conditions are generated up to element 1 node 1, expected an end");
  check_fault(32, "1 .5 .5 0 -2 7", 14, 14, "the card has 6 fields, expected 5");
  check_fault(34, "3 2 1 1", 1, 3, "contact elements 3 to 2 of body 1 make 2, expected 1");
  check_fault(36, "1 1", 1, 1, "number of contact nodes of body 1 is 1, expected 2, the sum of the zones");
  check_fault(38, "1 0", 3, 3, "limit of iterations is 0, expected at least 1");
}

TEST_CASE("what may not stand in a free deck") {
  check_fault(1, "*FREE 1", 7, 7, "the card has 2 fields, expected 1");
  List deck = free_squares();
  deck[0] = "*FRE";
  Reading r = read(joined(deck));
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].text == "a keyword card stands first, expected *FREE or the number of heading cards");
  CHECK(r.faults[0].column == 1);
  CHECK(r.faults[0].column_end == 4);
  check_fault(12, "*UNITS mm N", 1, 6, "found a keyword card, expected the elastic constants");
  constexpr int kColumns = c2d::kFreeColumns;
  check_fault(6, std::string(kColumns, ' ') + "0,1", kColumns + 1, kColumns + 3,
              ("the card extends beyond column " + std::to_string(kColumns)).c_str());
  CHECK(the_fault(6, "0 1 \x80").text.find("contains the byte 128, expected plain ASCII text") != std::string::npos);
  for (size_t cards = 1; cards < free_squares().size(); ++cards) {
    deck = free_squares();
    deck.resize(cards);
    r = read(joined(deck));
    CAPTURE(cards);
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults[0].text.find("the deck ends here, expected ") == 0);
  }
  for (int line = 1; line <= static_cast<int>(free_squares().size()); ++line) {
    r = read(joined(free_squares()), -1, C2D_OK, 0, line);
    CHECK(r.status == C2D_ERR_READ);
    CHECK(r.faults.size() == 1);
  }
  deck = free_squares();
  deck.push_back("*UNITS mm N");
  CHECK(read(joined(deck)).model.units == "mm N");
  deck.push_back("C no comment of this form");
  CHECK(read(joined(deck)).status == C2D_ERR_INPUT);
}

TEST_CASE("faults of the model point at the fields of a free card") {
  // a workspace made for other functional nodes: told at the third field of its card
  const Reading r = read(joined(free_squares()), -1, C2D_OK, 3);
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].line == 7);
  CHECK(r.faults[0].column == 5);
  CHECK(r.faults[0].column_end == 5);
}

TEST_CASE("walking over the fields of a deck") {
  const std::vector<Told> fixed = walk(joined(squares())), free = walk(joined(free_squares()));
  REQUIRE(!free.empty());
  CHECK(free[0].kind == C2D_CARD_FREE);
  const auto fields = [](const std::vector<Told>& told) {
    std::vector<Told> list;
    for (const Told& t : told)
      if (t.kind >= C2D_CARD_INTEGER && t.kind <= C2D_CARD_LETTER && !(t.width == 1 && t.column == 1 && t.value == 0))
        list.push_back(t);
    return list;
  };
  const std::vector<Told> a = fields(fixed), b = fields(free);
  REQUIRE(a.size() == b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    CAPTURE(a[i].line);
    CHECK(a[i].kind == b[i].kind);
    CHECK(a[i].column == b[i].column);
    CHECK(a[i].width == b[i].width);
    CHECK(a[i].value == b[i].value);
  }
  std::vector<std::string> comments;
  for (const Told& t : free)
    if (t.kind == C2D_CARD_COMMENT) comments.push_back(t.text);
  CHECK(comments ==
        List{"two squares, one on the other", "type of problem, output", "regions, nodes of an element, elements, points"});
  c2d_body_limits room[2] = {};
  CHECK(c2d_walk_deck(nullptr, nullptr, room, 2, keep_card, nullptr, nullptr, nullptr) == C2D_ERR_ARGUMENT);
}

TEST_CASE("mutated free decks neither crash nor loop, and every refusal says where") {
  std::mt19937 random(5);
  const auto below = [&](size_t n) { return static_cast<size_t>(random() % n); };
  List deck = free_squares();
  deck.push_back("*UNITS mm N");
  const std::string source = joined(deck);
  static const char kBytes[] = " 0123456789-+.,ECPx*!\n\t\r\x80";
  int accepted = 0;
  for (int i = 0; i < 10000; ++i) {
    std::string bytes = source;
    for (size_t k = below(4) + 1; k > 0; --k) {
      const size_t at = below(bytes.size());
      const char byte = kBytes[below(sizeof kBytes - 1)];
      switch (below(4)) {
      case 0: bytes[at] = byte; break;
      case 1: bytes.insert(at, 1, byte); break;
      case 2: bytes.erase(at, 1 + below(20)); break;
      default: bytes.insert(at, bytes.substr(below(bytes.size()), below(60))); break;
      }
      if (bytes.empty()) bytes = "1";
    }
    const int lines = 1 + static_cast<int>(std::count(bytes.begin(), bytes.end(), '\n'));
    const Reading r = read(bytes);
    bool sound = r.faults.size() <= 101 && (r.status == C2D_OK) == r.faults.empty();
    for (const Fault& f : r.faults)
      sound = sound && f.line >= 1 && f.line <= lines && f.column >= 0 && f.column_end >= f.column && !f.text.empty() &&
              f.text.size() < 300;
    CAPTURE(i);
    CAPTURE(bytes);
    CHECK(sound);
    if (r.status == C2D_OK) ++accepted;
  }
  CHECK(accepted > 0); // blanks and remarks
  CHECK(accepted < 7500);
}

TEST_CASE("the example of DECK.md is solved") {
  const std::string page = test::read_file(paths::root() + "/src/deck/DECK.md");
  const size_t first = page.find("```\n*FREE") + 4, last = page.find("```", first);
  REQUIRE(last != std::string::npos);
  const std::string deck = page.substr(first, last - first);
  REQUIRE(deck.compare(0, 5, "*FREE") == 0);
  CHECK(read(deck).status == C2D_OK);
  const test::Folder folder;
  test::write_file(folder / "deck", deck);
  const test::Result r =
      test::run_shell("'" + paths::program() + "' run " + (folder / "deck") + " --listing /dev/null --csv -");
  CHECK(r.status == 0);
  CHECK(lines_of(r.out).size() == 1 + 4 * 2); // increments times pairs
}

TEST_CASE("convert: every sample deck there and back") {
  const test::Folder folder;
  std::vector<std::string> decks;
  for (const std::string& path : {paths::root() + "/examples", paths::data() + "/decks"})
    for (const auto& entry : test::fs::directory_iterator(path))
      if (entry.path().extension() == ".dat") decks.push_back(entry.path().string());
  CHECK(decks.size() >= 20);
  int converted = 0;
  for (const std::string& deck : decks) {
    CAPTURE(deck);
    const std::string bytes = test::read_file(deck);
    const bool is_free = bytes.compare(0, 6, "*FREE\n") == 0;
    const test::Result first = convert(bytes);
    if (is_free && first.status != 0) { // numbers with more digits than the fixed form has columns
      CHECK(test::contains(first.err, "cannot be written in"));
      continue;
    }
    ++converted;
    const test::Result second = convert(first.out);
    const test::Result &free = is_free ? second : first, &fixed = is_free ? first : second;
    REQUIRE(first.status == 0);
    REQUIRE(second.status == 0);
    CHECK(free.out.compare(0, 6, "*FREE\n") == 0);
    const Reading a = read(bytes), b = read(free.out), c = read(fixed.out);
    REQUIRE(a.status == C2D_OK);
    CHECK(b.status == C2D_OK);
    CHECK(c.status == C2D_OK);
    CHECK(is_same_model(a.model, b.model));
    CHECK(is_same_model(a.model, c.model));
    CHECK(host::same_numbers(a.sizes, b.sizes));
    CHECK(convert(fixed.out).out == free.out);
  }
  CHECK(converted >= 15);
}

TEST_CASE("convert: a sketch is refused as one") {
  const test::Folder folder;
  test::write_file(folder / "a.c2s", "title none\n");
  const test::Result run = test::run_shell("'" + paths::program() + "' convert '" + (folder / "a.c2s") + "'");
  CHECK(run.status == 2);
  CHECK(test::contains(run.err, "a.c2s: error: is a sketch, expected a deck; contact2d mesh makes one of a sketch\n"));
}

TEST_CASE("convert: a run of the converted deck writes the same bytes") {
  const test::Folder folder;
  for (const char* name : {"sample.dat", "layer_mu.dat", "plate.dat", "ring3.dat"}) {
    CAPTURE(name);
    const std::string deck = paths::data() + "/decks/" + name;
    const std::string free = folder / "free", fixed = folder / "fixed";
    const std::string program = "'" + paths::program() + "' ";
    CHECK(test::run_shell(program + "convert '" + deck + "' -o " + free).status == 0);
    CHECK(test::run_shell(program + "convert " + free + " -o " + fixed).status == 0);
    std::string first_rows, first_listing;
    for (const std::string& path : {deck, free, fixed}) {
      const std::string csv = folder / "rows.csv", boundary = folder / "boundary.csv";
      const test::Result r = test::run_shell(program + "run '" + path + "' --listing " + (folder / "listing") + " --csv " +
                                             csv + " --boundary " + boundary);
      CHECK(r.status == 0);
      const std::string rows = test::read_file(csv) + test::read_file(boundary);
      const std::string listing = test::read_file(folder / "listing").substr(0, 500); // headings and title
      if (path == deck) {
        first_rows = rows;
        first_listing = listing;
      }
      CHECK(!rows.empty());
      CHECK(rows == first_rows);
      CHECK(listing == first_listing);
    }
  }
}

TEST_CASE("convert: comments, remarks, keywords and headings stay") {
  List deck = squares();
  deck.insert(deck.begin() + 2, "C Type of problem");
  deck[4] += "  two bodies";
  deck.push_back("C the end of the loads");
  deck.push_back("*UNITS  mm N ! as drawn");
  const test::Result free = convert(joined(deck));
  REQUIRE(free.status == 0);
  CHECK(test::contains(free.out, "\n! Type of problem\n0 1\n"));
  CHECK(test::contains(free.out, "\n2 1 2 ! two bodies\n"));
  CHECK(test::contains(free.out, "\n! the end of the loads\n*UNITS  mm N ! as drawn\n"));
  CHECK(test::contains(free.out, "\nTWO SQUARES\n"));
  const test::Result fixed = convert(free.out);
  REQUIRE(fixed.status == 0);
  CHECK(test::contains(fixed.out, "\nC Type of problem\n    0    1\n"));
  CHECK(test::contains(fixed.out, "\nC two bodies\n    2    1    2\n"));
  CHECK(test::contains(fixed.out, "\n*UNITS  mm N ! as drawn\n"));
  CHECK(read(fixed.out).model.units == "mm N");

  List people = free_squares();
  people.insert(people.begin() + 15, "! 12 nodes, gr\xc3\xbc\xc3\x9f"
                                     "e"); // C  12 would be a node card
  const test::Result cards = convert(joined(people));
  REQUIRE(cards.status == 0);
  CHECK(cards.out.compare(0, 18, "    1\nTWO SQUARES\n") == 0);
  CHECK(test::contains(cards.out, "TWO SQUARES\nC two squares, one on the other\n"));
  CHECK(test::contains(cards.out, "12 nodes, gr????e\n"));
  CHECK(is_same_model(read(cards.out).model, read(joined(squares())).model));
  CHECK(convert(joined(people), "--to free").out.compare(0, 6, "*FREE\n") == 0);
  CHECK(convert(joined(squares()), "--to fixed").out.compare(0, 6, "    1\n") == 0);
}

TEST_CASE("convert: numbers that the fixed form can and cannot hold") {
  const auto with_number = [](const std::string& number) {
    List deck = free_squares();
    deck[14] = number + " 0"; // origin of body 1
    return joined(deck);
  };
  for (const std::string number :
       {"0.333333333333e-3", "1.00000000000", "-0.000012500000000", "123456789012", "1e-99", "-1.2345e-50",
        "0.1000000000000000055511151231257827", "1e23", "-1234567000000", "0.00000000000", "12345678.5", "+.1e+01",
        "-0.12345678", "1.5+3", "9007199254740992.000", "9999999900000"}) {
    CAPTURE(number);
    const test::Result fixed = convert(with_number(number));
    const bool fits = number != "0.333333333333e-3" && number != "123456789012" && number != "9007199254740992.000";
    REQUIRE(fixed.status == (fits ? 0 : 2));
    if (!fits) {
      CHECK(test::contains(fixed.err, "deck:15:1: error: the number " + number + " cannot be written"));
      CHECK(fixed.out.empty());
      continue;
    }
    CHECK(is_same_model(read(with_number(number)).model, read(fixed.out).model));
  }
  // at random: whatever is written is the same double
  std::mt19937 random(11);
  List deck = free_squares();
  for (int i = 0; i < 60; ++i) {
    char x[40], y[40];
    std::snprintf(x, sizeof x, "%.*e", static_cast<int>(random() % 6), std::ldexp(double(random()), int(random() % 200) - 130));
    std::snprintf(y, sizeof y, "%.*f00000000", static_cast<int>(random() % 8), double(random() % 1000) / 7);
    deck[14] = std::string(x) + " -" + y;
    CAPTURE(deck[14]);
    const test::Result fixed = convert(joined(deck));
    if (fixed.status == 0)
      CHECK(is_same_model(read(joined(deck)).model, read(fixed.out).model));
    else
      CHECK(test::contains(fixed.err, "cannot be written in 10 columns"));
  }
  deck = free_squares();
  deck[31] = "123456 .5 .5 0 -2"; // number of a point load: five columns
  const test::Result wide = convert(joined(deck));
  CHECK(wide.status == 2);
  CHECK(test::contains(wide.err, "deck:32:1: error: the number 123456 does not fit in the 5 columns"));
}

TEST_CASE("convert: comments of every kind, beside cards and keywords, and fields that are blank") {
  List people = free_squares();
  people.insert(people.begin() + 15, {"!", "! a\tb\x7f\x01", "!       9 boards", "! x"});
  people.insert(people.end(), {"*CASES 2", "! of what", "!", "CASE 2", "condition 1 3 1 0 1 0 0"});
  const test::Result fixed = convert(joined(people));
  REQUIRE_MESSAGE(fixed.status == 0, fixed.err);
  CHECK_MESSAGE(test::contains(fixed.out, "\nC\nC a b??\nC 9 boards\nC x\n"), fixed.out);
  CHECK(test::contains(fixed.out, "\n! of what\n!\n CASE 2\n")); // a C would make a comment of it
  CHECK(is_same_model(read(fixed.out).model, read(joined(people)).model));
  const test::Result free = convert(fixed.out);
  REQUIRE(free.status == 0);
  CHECK(test::contains(free.out, "\n!\n! a b??\n"));
  CHECK(is_same_model(read(free.out).model, read(joined(people)).model));
  // What is left blank stays so in its own form.
  const test::Result same = convert(joined(squares()), "--to fixed");
  REQUIRE(same.status == 0);
  CHECK(is_same_model(read(same.out).model, read(joined(squares())).model));
  // A heading of any length.
  people[3] = std::string(3000, 'h');
  const test::Result heading = convert(joined(people));
  CHECK(heading.status == 0);
  CHECK(test::contains(heading.out, people[3].substr(0, 72)));
}

TEST_CASE("convert: coefficients are dealt out anew") {
  List deck = free_squares();
  deck[13] = "9 .1\n.2 .3 .4 .5 .6\n.7 .8 .9";
  const test::Result fixed = convert(joined(deck));
  REQUIRE(fixed.status == 0);
  CHECK(test::contains(fixed.out, "\n    9         .1        .2        .3        .4        .5        .6        .7\n"
                                  "              .8        .9\n"));
  CHECK(is_same_model(read(fixed.out).model, read(joined(deck)).model));
  CHECK(is_same_model(read(convert(fixed.out).out).model, read(joined(deck)).model));
}

TEST_CASE("convert: bad usage, bad decks, bad files") {
  const test::Folder folder;
  const std::string program = "'" + paths::program() + "' convert ";
  const std::string deck = "'" + paths::root() + "/examples/hertz.dat' ";
  for (const std::string& words :
       {std::string(""), deck + "--to other", deck + "--to", deck + "-o", deck + "--csv x", deck + deck}) {
    CAPTURE(words);
    CHECK(test::run_shell(program + words).status == 64);
  }
  test::write_file(folder / "bad", "*FREE\n1\nTITLE\n0 x\n");
  test::Result r = test::run_shell(program + (folder / "bad") + " -o " + (folder / "out"));
  CHECK(r.status == 2);
  CHECK(test::contains(r.err, "bad:4:3: error: column 3 contains 'x', expected an integer"));
  CHECK(folder.names() == List{"bad"});
  CHECK(test::run_shell(program + (folder / "nowhere")).status == 2);
  r = test::run_shell(program + deck + "-o " + (folder / "no/such/folder"));
  CHECK(r.status == 3);
  r = test::run_shell(program + deck + "-o " + (folder / "out"));
  CHECK(r.status == 0);
  CHECK(r.out.empty());
  CHECK(test::read_file(folder / "out") == test::run_shell(program + deck).out);
}
