// Decks that are right: every call they lead to, against a parser written for this test alone.
#include "deck/number.hpp"
#include "deck_recorder.hpp"
#include "effort.hpp"
#include "memory/text.hpp"
#include "model/polar.hpp"

#include <doctest/doctest.h>

#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

using namespace deck_test;

namespace {

// What a deck means, read naively: whole file in memory, substr and strtod, no checks.
struct NaiveParser {
  std::vector<std::string> cards;
  size_t at = 0;
  std::string card;
  std::vector<Call> calls;

  void next() {
    do {
      card = at < cards.size() ? cards[at++] : "";
      card.resize(80, ' ');
    } while (card[0] == 'C');
  }
  double real(int first, int width = 10) const {
    return std::strtod(card.substr(static_cast<size_t>(first - 1), static_cast<size_t>(width)).c_str(), nullptr);
  }
  int integer(int first, int width = 5) const { return static_cast<int>(real(first, width)); }

  void parse() {
    next();
    at += static_cast<size_t>(integer(1));
    next();
    const double plane = integer(1), analysis = integer(6);
    calls.push_back({"problem", {plane, analysis, 0}});
    next();
    const int bodies = integer(1), zones = integer(6), order = integer(11);
    int regions[2], element_nodes[2], elements[2], nodes[2];
    for (int b = 0; b < bodies; ++b) {
      next();
      regions[b] = integer(1), element_nodes[b] = integer(6), elements[b] = integer(11), nodes[b] = integer(16);
      calls.push_back({"body", {b + 1.0, double(element_nodes[b]), double(elements[b]), double(regions[b]), 1, 0}});
    }
    int element_shift = 0, node_shift = 0;
    for (int b = 0; b < bodies; ++b)
      for (int r = 0; r < regions[b]; ++r) {
        next();
        if (b == 1 && r == 0 && integer(1) > elements[0]) element_shift = elements[0];
        const int shift = b == 1 ? element_shift : 0;
        calls.push_back({"region", {b + 1.0, double(integer(1) - shift), double(integer(6) - shift)}});
      }
    for (int b = 0; b < bodies; ++b) {
      next();
      calls.push_back(
          {"body", {b + 1.0, double(element_nodes[b]), double(elements[b]), double(regions[b]), real(1), real(11)}});
    }
    next();
    const int coefficients = integer(1);
    for (int i = 0; i < coefficients; ++i) {
      if (i > 0 && i % 7 == 0) next();
      calls.push_back({"friction", {real(7 + 10 * (i % 7))}});
    }
    double origin[2][2];
    for (int b = 0; b < bodies; ++b) {
      next();
      origin[b][0] = real(1), origin[b][1] = real(11);
      double x0 = 0, y0 = 0, a0 = 0;
      for (int n0 = 0; n0 < nodes[b];) {
        next();
        int n = integer(2, 4);
        if (b == 1 && n0 == 0 && n > nodes[0]) node_shift = nodes[0];
        if (b == 1) n -= node_shift;
        const bool polar = card[0] == 'P';
        const double p = real(7), q = real(17), degree = std::acos(-1.0) / 180;
        for (int k = n0 + 1; k <= n; ++k) {
          const double share = double(k - n0) / (n - n0);
          const double angle = (a0 + (q - a0) * share) * degree;
          const double x = polar ? p * std::cos(k == n ? q * degree : angle) : k == n ? p : x0 + (p - x0) * share;
          const double y = polar ? p * std::sin(k == n ? q * degree : angle) : k == n ? q : y0 + (q - y0) * share;
          calls.push_back({"node", {b + 1.0, double(k), x + origin[b][0], y + origin[b][1]}});
        }
        x0 = polar ? p * std::cos(q * degree) : p;
        y0 = polar ? p * std::sin(q * degree) : q;
        a0 = q;
        n0 = n;
      }
    }
    for (int b = 0; b < bodies; ++b) {
      next();
      const int conditions = integer(1);
      int e0 = 0, l0 = 0;
      for (int i = 0; i < conditions; ++i) {
        next();
        const int e = integer(2, 4) - (b == 1 ? element_shift : 0), l = integer(6);
        if (card[0] != '1') e0 = e, l0 = l - 1;
        for (int end = (e0 - 1) * order + l0 + 1; end <= (e - 1) * order + l; ++end)
          calls.push_back({"condition",
                           {b + 1.0, double((end - 1) / order + 1), double((end - 1) % order + 1), real(12, 4), real(17),
                            real(27), real(37), real(47), 1}});
        e0 = e, l0 = l;
      }
      next();
      const int loads = integer(1);
      for (int i = 0; i < loads; ++i) {
        next();
        calls.push_back({"point load", {b + 1.0, real(7) + origin[b][0], real(17) + origin[b][1], real(27), real(37), 1}});
      }
    }
    for (int z = 0; z < zones; ++z) {
      next();
      std::vector<double> numbers = {double(integer(11)), double(integer(16))};
      next();
      for (int k = 0; k < 4; ++k) numbers.push_back(integer(1 + 5 * k) - (k > 1 ? element_shift : 0));
      next();
      const int shift = node_shift > 0 ? (order > 1 ? elements[0] * (order - 1) : elements[0]) : 0;
      for (int k = 0; k < 4; ++k) numbers.push_back(integer(1 + 5 * k) - (k > 1 ? shift : 0));
      calls.push_back({"zone", numbers});
    }
    for (int b = 0; b < bodies; ++b) next();
    next();
    const int paths = integer(1);
    calls.push_back({"problem", {plane, analysis, double(integer(6))}});
    for (int i = 0; i < paths; ++i) {
      next();
      calls.push_back({"path", {double(integer(1)), real(7)}});
    }
  }
};

// Both do a handful of operations on numbers of size 10: 1e-13 is some hundred roundings.
void check_same(const std::vector<Call>& found, const std::vector<Call>& expected) {
  REQUIRE(found.size() == expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    REQUIRE(found[i].name == expected[i].name);
    REQUIRE(found[i].numbers.size() == expected[i].numbers.size());
    for (size_t k = 0; k < found[i].numbers.size(); ++k) {
      CAPTURE(k);
      REQUIRE(std::fabs(found[i].numbers[k] - expected[i].numbers[k]) <= 1e-13 * (1 + std::fabs(expected[i].numbers[k])));
    }
  }
}

void check_deck(const std::string& bytes) {
  NaiveParser naive;
  naive.cards = lines_of(bytes);
  naive.parse();
  const Reading r = read(bytes);
  for (const Fault& f : r.faults) MESSAGE(f.line << ":" << f.column << ": " << f.text);
  REQUIRE(r.status == C2D_OK);
  CHECK(r.faults.empty());
  check_same(r.model.calls, naive.calls);
}

int count_calls(const Reading& r, const char* name, double body = 0) {
  int n = 0;
  for (const Call& c : r.model.calls)
    if (c.name == name && (body == 0 || c.numbers[0] == body)) ++n;
  return n;
}

} // namespace

TEST_CASE("sample decks lead to the calls that a naive parser finds") {
  for (const char* name : {"sample.dat", "sample56.dat", "half_cylinder.dat", "layer_mu.dat", "layer_t.dat", "rect.dat",
                           "block.dat", "plate.dat", "ring3.dat", "hertz_lin_l.dat"}) {
    CAPTURE(name);
    const std::string bytes = load(name);
    REQUIRE(!bytes.empty());
    check_deck(bytes);
  }
}

TEST_CASE("sizes of the sample deck") {
  Bytes deck;
  deck.bytes = load("sample.dat");
  host::Limits sizes;
  c2d_error why = C2D_INIT(c2d_error);
  REQUIRE(c2d_scan_deck(read_bytes, &deck, &sizes, &why) == C2D_OK);
  CHECK(why.status == C2D_OK);
  CHECK(sizes.struct_size == sizeof(c2d_limits));
  CHECK(sizes.bodies == 2);
  CHECK(sizes.function_nodes == 2);
  CHECK(sizes.body[0].points == 46);
  CHECK(sizes.body[1].points == 58);
  CHECK(sizes.body[0].elements == 46);
  CHECK(sizes.body[1].elements == 58);
  CHECK(sizes.body[0].regions == 1);
  CHECK(sizes.body[1].regions == 1);
  CHECK(sizes.zones == 1);
  CHECK(sizes.pairs == 15);
  CHECK(sizes.contact_elements == 14);
  CHECK(sizes.point_loads == 0);
  CHECK(sizes.coefficients == 2);
  CHECK(sizes.paths == 14);
  CHECK(sizes.load_cases == 1);

  // An older caller's smaller struct: nothing behind it is touched.
  host::Limits small;
  small.struct_size = offsetof(c2d_limits, zones);
  small.zones = 0x55555555;
  deck.at = 0;
  REQUIRE(c2d_scan_deck(read_bytes, &deck, &small, nullptr) == C2D_OK);
  CHECK(small.struct_size == offsetof(c2d_limits, zones));
  CHECK(small.function_nodes == 2);
  CHECK(small.body[0].points == 46);
  CHECK(small.zones == 0x55555555);
  CHECK(c2d_scan_deck(nullptr, &deck, &small, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_scan_deck(read_bytes, &deck, nullptr, nullptr) == C2D_ERR_ARGUMENT);
}

TEST_CASE("titles keep 72 columns") {
  CHECK(read(load("sample.dat")).model.title == "HERTZ'S PROBLEM. F= 0.4 & 0.3, EQ. SIZE ELEM = .2 LOAD STEPS = 14*2");
  std::vector<std::string> deck = squares();
  deck[1] = std::string(100, 'x');
  CHECK(read(joined(deck)).model.title == std::string(72, 'x'));
}

TEST_CASE("line ends, a missing last line end, comments and trailing blank lines change nothing") {
  const std::vector<std::string> lines = lines_of(load("sample.dat"));
  const Reading plain = read(joined(lines));
  REQUIRE(plain.status == C2D_OK);
  std::string open = joined(lines);
  open.pop_back();
  std::vector<std::string> commented(lines.begin(), lines.begin() + 15);
  for (size_t i = 15; i < lines.size(); ++i) {
    commented.push_back("C - \ta comment 123");
    commented.push_back(lines[i]);
    commented.push_back("C");
  }
  std::vector<std::string> longer = lines;
  for (size_t i = 15; i < lines.size(); ++i) {
    longer[i].resize(72, ' ');
    longer[i] += "SEQ 00012345 " + std::string(300, '7');
  }
  for (const std::string& deck : {joined(lines, "\r\n"), open, joined(commented), joined(longer),
                                  joined(lines) + "\n   \nC end\n", joined(lines) + "\x1a"}) {
    const Reading r = read(deck);
    for (const Fault& f : r.faults) MESSAGE(f.line << ":" << f.column << ": " << f.text);
    CHECK(r.status == C2D_OK);
    check_same(r.model.calls, plain.model.calls);
  }
}

TEST_CASE("numbers of body 2 that continue mean the same") {
  std::vector<std::string> deck = squares();
  const Reading restarting = read(joined(deck));
  REQUIRE(restarting.status == C2D_OK);
  check_deck(joined(deck));
  deck[7] = "    5    8";
  deck[26] = "    7    1 0011       0.0      -1.0";
  deck[30] = "    3    3    5    5";
  const Reading elements = read(joined(deck));
  CHECK(elements.status == C2D_OK);
  check_same(elements.model.calls, restarting.model.calls);
  for (size_t i = 17; i <= 20; ++i) deck[i][4] = static_cast<char>(deck[i][4] + 4);
  deck[31] = "    3    4    6    5";
  const Reading both = read(joined(deck));
  CHECK(both.status == C2D_OK);
  check_same(both.model.calls, restarting.model.calls);
}

TEST_CASE("coefficients of friction continue on further cards") {
  std::vector<std::string> deck = squares();
  deck[10] = "   16       0.1       0.2       0.3       0.4       0.5       0.6       0.7";
  deck.insert(deck.begin() + 11, "             0.8       0.9       1.0       1.1       1.2       1.3       1.4");
  deck.insert(deck.begin() + 12, "             1.5       1.6");
  const Reading r = read(joined(deck));
  REQUIRE(r.status == C2D_OK);
  CHECK(r.sizes.coefficients == 16);
  check_deck(joined(deck));
}

TEST_CASE("generated points lie on lines and arcs") {
  std::vector<std::string> deck = squares();
  deck[4] = "    1    2  101  101";
  deck[6] = "    1  101";
  deck[30] = "   10   10    1    1";
  deck[31] = "   10   11    2    1";
  deck.erase(deck.begin() + 12, deck.begin() + 16);
  deck[11] = "       3.0      -2.0";
  for (const char* card :
       {"P  91       2.0     360.0", "   81       8.0       4.0", "P  61       2.0      90.0", "P   1       2.0     -90.0"})
    deck.insert(deck.begin() + 12, card);
  deck.insert(deck.begin() + 16, "  101       3.0       3.0");
  const Reading r = read(joined(deck));
  REQUIRE(!r.faults.empty()); // node 91 is on an arc that begins at a Cartesian card
  CHECK(r.faults[0].line == 16);

  deck[15] = "   91       6.0       0.0";
  const Reading s = read(joined(deck));
  REQUIRE(s.status == C2D_OK);
  REQUIRE(count_calls(s, "node", 1) == 101);
  for (const Call& c : s.model.calls) {
    if (c.name != "node" || c.numbers[0] != 1) continue;
    const double n = c.numbers[1], x = c.numbers[2] - 3, y = c.numbers[3] + 2;
    CAPTURE(n);
    if (n <= 61) {
      const double a = (-90 + 3 * (n - 1)) * std::acos(-1.0) / 180;
      CHECK(std::fabs(x - 2 * std::cos(a)) < 1e-15 * 8);
      CHECK(std::fabs(y - 2 * std::sin(a)) < 1e-15 * 8);
    } else if (n <= 81) {
      CHECK(x == doctest::Approx(8 * (n - 61) / 20).epsilon(1e-14));
      CHECK(y == doctest::Approx(2 + 2 * (n - 61) / 20).epsilon(1e-14));
    } else if (n <= 91) {
      CHECK(x == doctest::Approx(8 - 2 * (n - 81) / 10).epsilon(1e-14));
    }
    // The ends of the diameter and its middle are exact.
    if (n == 1) CHECK((x == 0 && y == -2));
    if (n == 31) CHECK((x == 2 && y == 0));
    if (n == 61) CHECK((x == 0 && y == 2));
  }
}

TEST_CASE("angles in degrees keep the symmetries of the circle") {
  for (int k = -8; k <= 8; ++k)
    for (double d = 0; d <= 90; d += 0.625) {
      double c, s, c2, s2;
      c2d::cosine_and_sine(d, &c, &s);
      CHECK(std::fabs(c - std::cos(d * std::acos(-1.0) / 180)) < 3e-16);
      CHECK(std::fabs(s - std::sin(d * std::acos(-1.0) / 180)) < 3e-16);
      c2d::cosine_and_sine(90 - d, &c2, &s2);
      CHECK((c2 == s && s2 == c));
      c2d::cosine_and_sine(d + 90 * k, &c2, &s2);
      const int q = ((k % 4) + 4) % 4;
      CHECK(c2 == (q == 0 ? c : q == 1 ? -s : q == 2 ? -c : s));
      CHECK(s2 == (q == 0 ? s : q == 1 ? c : q == 2 ? -s : -c));
    }
  double c, s;
  c2d::cosine_and_sine(30, &c, &s);
  CHECK(s == 0.5);
  c2d::cosine_and_sine(1e99, &c, &s);
  CHECK(c * c + s * s == doctest::Approx(1));
}

TEST_CASE("real fields are the nearest double") {
  std::mt19937 random(1987);
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  int compared = 0;
  for (int i = 0; i < test::effort(200000, 1000000); ++i) {
    char field[16];
    size_t n = 0;
    const unsigned form = below(4);
    if (below(3) == 0) field[n++] = '-';
    const unsigned digits = 1 + below(form == 0 ? 9 : 5), point = below(digits + 2);
    for (unsigned k = 0; k < digits && n < 10; ++k) {
      if (k == point && n < 9) field[n++] = '.';
      field[n++] = static_cast<char>('0' + below(10));
    }
    if (form > 0 && n < 8) {
      field[n++] = "EDed"[below(4)];
      if (below(2)) field[n++] = "+-"[below(2)];
      while (n < 10 && (below(2) || field[n - 1] < '0' || field[n - 1] > '9')) field[n++] = static_cast<char>('0' + below(10));
    }
    if (field[n - 1] < '0' || field[n - 1] > '9') continue;
    field[n] = '\0';
    double value = -1;
    const c2d::FieldFault fault = c2d::real_field(field, static_cast<int32_t>(n), &value);
    for (size_t k = 0; k < n; ++k)
      if (field[k] == 'D' || field[k] == 'd') field[k] = 'E';
    const double expected = std::strtod(field, nullptr);
    const bool same = std::isinf(expected)            ? fault == c2d::FieldFault::too_large
                      : std::fabs(expected) < DBL_MIN ? fault == c2d::FieldFault::none && value == 0
                                                      : fault == c2d::FieldFault::none && value == expected;
    if (!same) FAIL_CHECK("'" << field << "' gives " << value << ", strtod " << expected);
    ++compared;
  }
  CHECK(compared > test::effort(140000, 700000));
}

TEST_CASE("what number fields accept and refuse") {
  const auto real = [](const char* field) {
    double value = -1;
    return c2d::real_field(field, static_cast<int32_t>(std::strlen(field)), &value) == c2d::FieldFault::none ? value : -99;
  };
  CHECK(real("          ") == 0);
  CHECK(real("         5") == 5);
  CHECK(real("5         ") == 5);
  CHECK(real("    1.5+3 ") == 1500);
  CHECK(real("   1.5D-3 ") == 0.0015);
  CHECK(real("     -.5  ") == -0.5);
  CHECK(real("   +00012.") == 12);
  for (const char* bad : {"1 2", "1.2.3", ".", "-", "+", "E5", "1E", "1E+", "1.5E3.0", "NaN", "inf", "-Infinity", "0x1p3",
                          "1,5", "1e999", "--1", "1-", "- 1", "12a"}) {
    CAPTURE(bad);
    CHECK(real(bad) == -99);
  }
  int32_t value = -1;
  CHECK(c2d::integer_field(" -012 ", 6, &value) == c2d::FieldFault::none);
  CHECK(value == -12);
  CHECK(c2d::integer_field("     ", 5, &value) == c2d::FieldFault::none);
  CHECK(value == 0);
  CHECK(c2d::integer_field("1 2", 3, &value) == c2d::FieldFault::blank_inside);
  CHECK(c2d::integer_field("5.", 2, &value) == c2d::FieldFault::not_an_integer);
  CHECK(c2d::integer_field("1E2", 3, &value) == c2d::FieldFault::not_an_integer);
  CHECK(c2d::integer_field("x", 1, &value) == c2d::FieldFault::not_a_number);
  CHECK(c2d::integer_field("-", 1, &value) == c2d::FieldFault::not_a_number);
  CHECK(c2d::integer_field("2147483648", 10, &value) == c2d::FieldFault::too_large);
  CHECK(value == 0);
}

TEST_CASE("numbers in messages are those of printf") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200000; ++i) {
    const uint64_t pattern = random();
    double value;
    std::memcpy(&value, &pattern, sizeof value);
    if (i % 2 == 0) value = static_cast<double>(static_cast<int64_t>(pattern % 2000001) - 1000000) / (1 << (i % 20));
    if (!std::isfinite(value)) continue;
    const int digits = 1 + i % 17;
    char found[64], expected[64];
    c2d::Text text = c2d::text_in(found);
    c2d::put(text, value, digits);
    std::snprintf(expected, sizeof expected, "%.*g", digits, value);
    if (value == 0) expected[0] = '0', expected[1] = '\0'; // -0 is shown as it is by printf only
    if (std::strcmp(found[0] == '-' && value == 0 ? found + 1 : found, expected) != 0)
      FAIL_CHECK(found << " instead of " << expected);
  }
  char shown[64];
  c2d::Text text = c2d::text_in(shown);
  c2d::put(text, std::numeric_limits<double>::infinity());
  c2d::put(text, " ");
  c2d::put(text, -std::numeric_limits<double>::infinity());
  c2d::put(text, " ");
  c2d::put(text, std::numeric_limits<double>::quiet_NaN());
  c2d::put(text, " ");
  c2d::put(text, INT64_MIN);
  CHECK(std::string(shown) == "inf -inf nan -9223372036854775808");
  char narrow[6];
  text = c2d::text_in(narrow);
  c2d::put(text, "abc");
  c2d::put(text, int32_t{123456});
  CHECK(std::string(narrow) == "abc12");
  c2d::Text none = c2d::text_in(nullptr, 0);
  c2d::put(none, "abc");
  CHECK(none.used == 0);
}
