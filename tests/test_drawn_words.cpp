// Messages of a generated mesh in words of its drawing: what is replaced, and what only looks like it.
#include "program/commands/drawn_words.hpp"

#include <doctest/doctest.h>

#include <cstring>

using namespace app;

namespace {

const char kDeck[] =
    "*FREE\n! curve of body 1: block.top, elements 5 to 8, nodes 5 to 9\n"
    "! curve of body 2: pad.flat, elements 1 to 4, nodes 1 to 5\n"
    "! curve of body x\n! curve of body 3 has none\n! curve of body 3: words of a title\n"
    "! zone 1 may extend farther: pad.flat ends at (1, 0)\n! zone 1 may extend farther: block.top ends at (2, 0)\n"
    "! zone 2: side 2 is the first of its statement\n! zone 2: the second side begins at 2.5 of 10\n"
    "! zone 1: the second side begins at 1.5\n! zone 0: the second side begins at 7\n"
    "! zone 9: the second side begins at 7\n! zone of a title\n";

std::string drawn(const std::string& text) { return in_words_of_drawing(text, kDeck); }

} // namespace

TEST_CASE("drawn words: elements, nodes and pairs become curves") {
  CHECK(drawn("at element 6 of body 1 (block)") == "at block.top");
  CHECK(drawn("at node 5 of body 2") == "at pad.flat");
  CHECK(drawn("(node 5 of body 2, element 5 of body 1)") == "(pad.flat, block.top)");
  CHECK(drawn("pair 3 (on element 6 of body 1 (block), node 2 of body 2 (pad)): open") == "block.top and pad.flat: open");
  CHECK(drawn("pair 3 (element 6 of body 1, node 2 of body 2): open") == "block.top and pad.flat: open");
  CHECK(drawn("pair 4, too far") == "too far");
  CHECK(drawn("in pair 4, too far") == "in too far");
  CHECK(drawn("at pair 4, too far") == "at one place, too far");
}

TEST_CASE("drawn words: what only begins like an element, a node or a pair stays") {
  for (const char* text : {"element 6", "element x of body 1", "element 6 of body x", "element 6 of body 1 (block",
                           "element 9 of body 1", "node 4 of body 1", "element 6 of body 7", "pair x", "pair 3 of 5",
                           "pair 3 (far away)", "pair 3 (on element 60 of body 1, node 2 of body 2)"}) {
    CAPTURE(text);
    CHECK(drawn(text).find(std::string(text).substr(0, 6)) == 0);
  }
  CHECK(drawn("pair 3 (on element 6 of body 1; node 2 of body 2)") == "pair 3 (on block.top; pad.flat)");
  CHECK(drawn("pair 3 (on element 6 of body 1, node 2 of body 9)") == "pair 3 (on block.top, node 2 of body 9)");
  CHECK(drawn("pair 3 (on element 6 of body 1, node 2 of body 2 and more)") == "pair 3 (on block.top, pad.flat and more)");
}

TEST_CASE("drawn words: zones and their statements") {
  std::vector<ZoneLine> lines(2);
  take_statements(kDeck, lines);
  CHECK_FALSE(lines[0].turned);
  CHECK(lines[0].from == 1.5);
  CHECK(lines[0].around == 0);
  CHECK(lines[1].turned);
  CHECK(lines[1].from == 2.5);
  CHECK(lines[1].around == 10);
  c2d_error warning = C2D_INIT(c2d_error);
  warning.status = C2D_WARN_ZONE_END, warning.zone = 1;
  CHECK_FALSE(is_at_natural_end(warning, kDeck));
  warning.zone = 2;
  CHECK(is_at_natural_end(warning, kDeck));
  const std::string
      closed = "the last pair at an end of a contact zone is closed: the contact may extend beyond the zone; lengthen it",
      reaches = "contact reaches the end of the facing parts and may extend beyond it";
  CHECK(drawn("zone 1: " + closed) == "zone 1: " + reaches + ": pad.flat ends at (1, 0); block.top ends at (2, 0)");
  CHECK(drawn("zone 2: " + closed) == "zone 2: " + reaches);
  CHECK(drawn(closed) == reaches);
}
