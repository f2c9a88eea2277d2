// Bad input about bodies, their zones and ties: refused with the card, the numbers, and what was expected.
#include "many_bodies.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace many;

namespace {

// Three squares, one on the other, of one element a side; the lowest is held, the highest pressed.
struct Squares {
  std::string numbers = "3 2 2", second = "1 2 2 1\n3 3 1 1\n3 4 2 1\n2 3 2 1\n3 3 1 1\n3 4 2 1\n", keywords;
  std::string held = "2\n1 1 1100 0 0 0 0\n1 2 1100 0 0 0 0\n0\n";
  std::string in_contact = "2 1\n4 2\n2 1\n";

  std::string deck() const {
    std::string text = "*FREE\n1\nTHREE SQUARES\n0 1\n" + numbers + "\n1 2 4 4\n1 2 4 4\n1 2 4 4\n1 4\n1 4\n1 4\n" +
                       "100 0.3\n200 0.2\n300 0.3\n1 0.5\n";
    for (int i = 0; i < 3; ++i) {
      const std::string low = std::to_string(i), high = std::to_string(i + 1);
      text += "0 0\n1 0 " + low + "\n2 1 " + low + "\n3 1 " + high + "\n4 0 " + high + "\n";
    }
    return text + held + "0\n0\n2\n3 1 0011 0 -1 0 0\n3 2 0011 0 -1 0 0\n0\n" + second + in_contact + "1 10\n1 1.0\n" +
           keywords;
  }
};

struct Told {
  c2d_status status;
  std::string text;
  c2d_error first;
};
Told read(const Squares& squares) {
  Machine machine(squares.deck());
  std::string all;
  for (const c2d_error& e : machine.told) all += e.text + std::string("\n");
  return {machine.status, all, machine.told.empty() ? C2D_INIT(c2d_error) : machine.told.front()};
}
bool says(const Told& told, const std::string& words) { return told.text.find(words) != std::string::npos; }

} // namespace

TEST_CASE("bad bodies: the deck of the others is good") {
  const Result r = solve_deck(Squares().deck());
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.outcome == C2D_REACHED);
  CHECK(r.bodies.size() == 3);
}

namespace {

void check_refused(const Squares& squares, int32_t line, const std::string& words) {
  const Told told = read(squares);
  INFO(told.text);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(told.first.line == line);
  CHECK(says(told, words));
}

} // namespace

TEST_CASE("bad bodies: a zone that names a body twice without saying so") {
  Squares s;
  s.second = "1 1 2 1\n3 3 1 1\n3 4 2 1\n2 3 2 1\n3 3 1 1\n3 4 2 1\n";
  check_refused(s, 41, "both bodies of the zone are 1, expected two different ones, or -1 for self-contact");
  s = Squares();
  s.keywords = "*ZONE BODIES 2 2 2 2 4 4\n";
  check_refused(s, 52, "bodies of the zone are 2 and 2, expected two different ones, or the second as -2");
  s.keywords = "*ZONE BODIES 2 -2 2 2 4 4\n"; // says so; these sides do not face each other
  const Told told = read(s);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(!says(told, "two different ones"));
}

TEST_CASE("bad bodies: a zone of bodies that are not there is told of once, with what may stand there") {
  Squares s;
  s.keywords = "*ZONE BODIES 4 4 2 2 4 4\n";
  Told told = read(s);
  INFO(told.text);
  CHECK(told.text == "first body of the zone is 4, expected 1 to 3\n");
  for (const int body : {4, 0, -1, -4}) {
    CAPTURE(body);
    s.keywords = "*ZONE BODIES 2 " + std::to_string(body) + " 2 2 4 4\n";
    told = read(s);
    CHECK(told.first.column == 16);
    CHECK(told.text == "second body of the zone is " + std::to_string(body) + ", expected 1 to 3, or -2 for self-contact\n");
  }
}

TEST_CASE("bad bodies: numbers of bodies that are not there") {
  Squares s;
  s.second = "1 4 2 1\n3 3 1 1\n3 4 2 1\n2 3 2 1\n3 3 1 1\n3 4 2 1\n";
  check_refused(s, 41, "expected 1 to 3");
  s = Squares();
  s.numbers = "0 2 2";
  check_refused(s, 5, "expected");
  for (const char* card :
       {"*RIGID 4\n", "*RIGID LOAD 4 0 0\n", "*ZONE BODIES 1 4 2 2 4 4\n", "*BODY FORCE 4 1 0 -1\n", "*TIE 3\n"}) {
    CAPTURE(card);
    s = Squares();
    s.keywords = card;
    check_refused(s, 52, "expected");
  }
}

TEST_CASE("bad bodies: a tie and a contact on one node") {
  Squares s; // the same sides once more
  s.keywords = "*ZONE BODIES 1 2 3 3 1 1\n*TIE 3\n";
  const Told told = read(s);
  INFO(told.text);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(told.first.line == 52);
  CHECK(told.first.zone == 3);
  CHECK(says(told, "element 3 of body 1 is in zones 1 and 3, expected in one only"));
}

namespace {

Squares unconnected() { // the third square is in no zone: zone 2 is left out
  Squares s;
  s.numbers = "3 1 2";
  s.second = "1 2 2 1\n3 3 1 1\n3 4 2 1\n";
  s.in_contact = "2 1\n2 1\n0 0\n";
  return s;
}

} // namespace

TEST_CASE("bad bodies: a body that nothing connects and nothing holds is named") {
  const Result r = solve_deck(unconnected().deck());
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  CHECK(r.outcome == C2D_FREE_MOTION);
  CHECK(r.summary.outcome_body == 3);
  // Nor the lowest: it floats with those above it.
  Squares loose;
  loose.held = "0\n0\n";
  const Result all = solve_deck(loose.deck());
  REQUIRE_MESSAGE(all.status == C2D_OK, all.messages());
  CHECK(all.outcome == C2D_FREE_MOTION);
  CHECK(all.summary.outcome_body > 0);
}

TEST_CASE("bad bodies: and how it moves") {
  const Result r = solve_deck(unconnected().deck());
  CHECK(r.summary.free_motion[0] == 0);
  CHECK(r.summary.free_motion[1] < 0);
  CHECK(std::fabs(r.summary.free_motion[2]) < 1e-9);
}

namespace {

Model loose_plates(double middle, double side) {
  Model m;
  m.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}));
  m.add(rectangle(0, 1, 2, 2, {4, 2, 4, 2}, 300));
  m.set(1, 1, end_of(kPulled, 0, middle));
  m.set(1, 2, end_of(kPulled, 0, side));
  m.join(C2D_ZONE_MATCHING | C2D_ZONE_TIED, 1, 3, 2, 1);
  return m;
}

} // namespace

TEST_CASE("bad bodies: loose plates that are tied move together, as their loads push them") {
  for (const double up : {-1.0, 1.0})
    for (const double side : {0.0, 1.0}) {
      CAPTURE(up);
      CAPTURE(side);
      const Model m = loose_plates(up, side * up);
      const Result a = solve(m), b = solve(with_bodies_in_order(m, {2, 1}));
      CHECK(a.outcome == C2D_FREE_MOTION);
      const double *one = a.summary.free_motion, *other = b.summary.free_motion; // of the lower and of the upper plate
      CHECK(one[1] * up > 0.1);
      CHECK(one[2] * up >= 0.01 * side);
      for (int k = 0; k < 3; ++k) CHECK(std::fabs(one[k] * other[1] - other[k] * one[1]) < 1e-9);
      if (side == 0) CHECK(std::hypot(one[0], one[2]) < 1e-9);
    }
  const Result still = solve(loose_plates(0, 0)); // nothing pushes: any motion
  CHECK(still.outcome == C2D_FREE_MOTION);
  CHECK(std::hypot(still.summary.free_motion[0], still.summary.free_motion[1]) > 0.1);
}

TEST_CASE("bad bodies: a loop of ties that says the same twice") {
  const int32_t tied = C2D_ZONE_FREE | C2D_ZONE_TIED;
  // Four squares about a point, each on side 2 once: every corner there is in one pair, and the four ties close a ring.
  const auto four = [&](int32_t ties) {
    Model m;
    for (const double at : {0.0, 1.0}) m.add(rectangle(at, 0, at + 1, 1, {3, 3, 3, 3}));
    for (const double at : {1.0, 0.0}) m.add(rectangle(at, 1, at + 1, 2, {3, 3, 3, 3}));
    m.set(1, 4, end_of(kHeld));
    m.set(3, 3, end_of(kPulled, 0, -1));
    for (int32_t i = 1; i <= ties; ++i) m.join(tied, i, i % 4 + 1, i % 4 + 1, (i + 2) % 4 + 1);
    return m;
  };
  const Result ring = solve(four(4));
  INFO(ring.messages());
  CHECK(ring.status == C2D_ERR_INPUT);
  CHECK(ring.messages().find("ties close a ring at (1, 1), of zones 4, 3, 2, 1") != std::string::npos);
  const Result open = solve(four(3));
  REQUIRE_MESSAGE(open.status == C2D_OK, open.messages());
  CHECK(open.outcome == C2D_REACHED);
}

TEST_CASE("bad bodies: more of them than the limits say") {
  Model m;
  for (int i = 0; i < 3; ++i) m.add(rectangle(0, i, 1, i + 1, {1, 1, 1, 1}));
  m.set(1, 1, end_of(kHeld));
  m.set(3, 3, end_of(kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.join(C2D_ZONE_MATCHING, 2, 3, 3, 1);
  std::vector<c2d_body_limits> list;
  c2d_limits limits = limits_of(m, list);
  limits.bodies = 2;
  uint64_t minimum = 0, in_core = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
  std::vector<unsigned char> memory(minimum);
  c2d_solver* s = nullptr;
  c2d_error why = C2D_INIT(c2d_error);
  REQUIRE(c2d_create(&s, memory.data(), memory.size(), &limits, nullptr, &why) == C2D_OK);
  const c2d_status status = feed(s, m);
  CHECK((status == C2D_ERR_ARGUMENT || status == C2D_ERR_LIMIT));
  c2d_last_error(s, &why);
  INFO(why.text);
  CHECK(std::string(why.text).find("body") != std::string::npos);
  CHECK(std::string(why.text).find("1 to 2") != std::string::npos);
  c2d_close(s);
  // A deck of three in a list for two: how many there are.
  struct Cards {
    std::string text;
    size_t at = 0;
    static int32_t read(void* c, char* out, int32_t size) {
      Cards& cards = *static_cast<Cards*>(c);
      if (cards.at >= cards.text.size()) return -1;
      const size_t end = cards.text.find('\n', cards.at);
      const std::string line = cards.text.substr(cards.at, end - cards.at);
      cards.at = end + 1;
      line.copy(out, static_cast<size_t>(size) - 1);
      out[line.size()] = '\0';
      return static_cast<int32_t>(line.size());
    }
  } cards;
  cards.text = Squares().deck();
  std::vector<c2d_body_limits> two(2);
  c2d_limits scanned = C2D_INIT(c2d_limits);
  scanned.bodies = 2, scanned.body = two.data();
  CHECK(c2d_scan_deck(Cards::read, &cards, &scanned, &why) == C2D_ERR_LIMIT);
  CHECK(scanned.bodies == 3);
}

TEST_CASE("bad bodies: a traction in a zone, which is the contact's, is refused") {
  for (const int32_t kind : {0, 1, 2, 3})
    for (const int32_t body : {1, 2})
      for (const bool in_case_2 : {false, true}) {
        CAPTURE(kind);
        CAPTURE(body);
        CAPTURE(in_case_2);
        Model m;
        for (int i = 0; i < 2; ++i) m.add(rectangle(0, i, 1, i + 1, {2, 1, 2, 1}));
        m.set(1, 1, end_of(kHeld));
        m.set(2, 3, end_of(kPulled, 0, -1));
        m.join(kind, 1, 3, 2, 1);
        m.friction = 0.5;
        if (in_case_2) {
          m.cases = 2;
          for (Body& b : m.bodies) b.second = b.ends;
        }
        CHECK(solve(m).status == C2D_OK);
        std::vector<End>& ends = in_case_2 ? m.body(body).second : m.body(body).ends;
        ends[static_cast<size_t>(2 * m.side(body, body == 1 ? 3 : 1).first - 1)] = end_of(kPulled, 0.25);
        const Result r = solve(m);
        INFO(r.messages());
        if ((kind & C2D_ZONE_FREE) != 0 && body == 1) { // it adds to the contact's
          CHECK(r.status == C2D_OK);
          continue;
        }
        CHECK(r.status != C2D_OK);
      }
}

TEST_CASE("bad bodies: a displacement that a rigid body gives and a card as well") {
  Model m;
  m.add(rectangle(0, 0, 1, 1, {2, 1, 2, 1}));
  m.add(rectangle(0, 1, 1, 2, {2, 1, 2, 1}));
  m.set(1, 1, end_of(kHeld));
  m.set(1, 3, end_of("1001"));
  m.body(2).rigid = 1;
  m.body(2).motion[1] = -0.001;
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.5;
  const Result r = solve(m);
  INFO(r.messages());
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.told_of(": ux is prescribed on body 1 only, expected it on neither: what meets the rigid body 2 follows it"));
}

TEST_CASE("bad bodies: rigid bodies alone, and one that is both rigid and loaded") {
  Squares s;
  s.keywords = "*RIGID 1\n*RIGID 2\n*RIGID 3\n";
  Told told = read(s);
  INFO(told.text);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(says(told, "are both rigid"));
  s.keywords = "*RIGID 3\n"; // its side is pressed
  told = read(s);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(says(told, "body 3 is rigid, expected no tractions"));
  s.keywords = "*RIGID LOAD 3 0 0 Z\n";
  told = read(s);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(says(told, "expected the free motions X, Y or TURN"));
  s.keywords = "*RIGID LOAD 3 0 0 X X\n";
  told = read(s);
  CHECK(told.status == C2D_ERR_INPUT);
  CHECK(says(told, "each at most once"));
}
