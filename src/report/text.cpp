#include "report/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace app {
namespace {

enum class Form { kGeneral, kScientific };

constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

// value / 10^exponent for a power of at most 10^44: one or two roundings.
double scaled(double value, int exponent) {
  if (exponent >= 0) return value / kPowers[exponent];
  if (exponent >= -22) return value * kPowers[-exponent];
  return value * 1e22 * kPowers[-exponent - 22];
}

// The `digits` (at most 15) leading decimal digits of value > 0 as an integer, rounded, and the exponent of
// the first of them. Off by one unit only where the value is within 1e-3 units of a tie. False where `scaled`
// does not reach.
bool leading_digits(double value, int digits, uint64_t& integer, int& exponent) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  const int binary = static_cast<int>(bits >> 52) - 1023;
  // Rounded down: not above the decimal exponent, at most one below.
  exponent = static_cast<int>(binary * 0.30103 + 400) - 400;
  const uint64_t limit = static_cast<uint64_t>(kPowers[digits]);
  for (int attempt = 0; attempt < 2; ++attempt, ++exponent) {
    const int shift = exponent - (digits - 1);
    if (shift > 22 || shift < -44) return false;
    integer = static_cast<uint64_t>(scaled(value, shift) + 0.5);
    if (integer < limit) return true;
  }
  return false;
}

char* print_exponent(char* at, int exponent) {
  *at++ = 'e';
  *at++ = exponent < 0 ? '-' : '+';
  const int size = exponent < 0 ? -exponent : exponent; // below 100 here
  *at++ = static_cast<char>('0' + size / 10);
  *at++ = static_cast<char>('0' + size % 10);
  return at;
}

// "00", "01", ... "99".
struct DigitPairs {
  char text[200];
};
constexpr DigitPairs make_pairs() {
  DigitPairs pairs = {};
  for (int i = 0; i < 100; ++i) {
    pairs.text[2 * i] = static_cast<char>('0' + i / 10);
    pairs.text[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}
constexpr DigitPairs kDigitPairs = make_pairs();

constexpr int kMostDigits = 16; // copied whole, which is quicker than as many as there are

// The `count` digits of an integer, an even number from 2 to 16 of them, with zeros in front.
void spell(char* digits, int count, uint64_t integer) {
  for (int i = count; i > 0; i -= 2, integer /= 100) std::memcpy(digits + i - 2, kDigitPairs.text + 2 * (integer % 100), 2);
}

// d.ddd or ddd.d or 0.00ddd from `count` of kMostDigits digits, the first of which stands for 10^exponent; those behind
// them are zeros as far as they stand before the point. Writes up to 24 characters beyond those.
char* print_digits(char* at, const char* digits, int count, int exponent) {
  if (exponent < 0) {
    std::memcpy(at, "0.000", 5);
    std::memcpy(at + 1 - exponent, digits, kMostDigits);
    return at + 1 - exponent + count;
  }
  std::memcpy(at, digits, kMostDigits);
  const int before = exponent + 1;
  if (count <= before) return at + before;
  at[before] = '.';
  std::memcpy(at + before + 1, digits + before, kMostDigits);
  return at + count + 1;
}

// Conversion by the standard library.
int print_slowly(char* text, double value, Form form, int digits) {
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  const auto format = form == Form::kGeneral ? std::chars_format::general : std::chars_format::scientific;
  return static_cast<int>(std::to_chars(text, text + 40, value, format, digits).ptr - text);
#else
  return std::snprintf(text, 40, form == Form::kGeneral ? "%.*g" : "%.*e", digits, value);
#endif
}

// Writes value to text[0 .. 40) as %.<digits>g or %.<digits>e would; returns the length. A run prints tens of
// thousands of numbers, hence the way around the library's exact but slow conversion.
int print_double(char* text, double value, Form form, int digits) {
  if (value == 0.0) value = 0.0; // minus zero has no meaning here
  const double size = std::fabs(value);
  const int significant = form == Form::kGeneral ? digits : digits + 1;
  uint64_t integer = 0;
  int exponent = 0;
  const bool fast = size <= 1e30 && significant <= 15 && (size == 0.0 || leading_digits(size, significant, integer, exponent));
  if (!fast) return print_slowly(text, value, form, digits);
  char all[2 * kMostDigits] = {}; // with room behind them to copy from
  const int odd = significant & 1;
  spell(all, significant + odd, odd ? integer * 10 : integer);
  int count = significant;
  if (form == Form::kGeneral)
    while (count > 1 && all[count - 1] == '0') --count;
  char* at = text;
  if (value < 0.0) *at++ = '-';
  if (form == Form::kGeneral && exponent >= -4 && exponent < digits) {
    at = print_digits(at, all, count, exponent);
  } else {
    at = print_digits(at, all, count, 0);
    at = print_exponent(at, exponent);
  }
  return static_cast<int>(at - text);
}

void append_right(std::string& out, const char* text, int length, int width) {
  if (length < width) out.append(static_cast<size_t>(width - length), ' ');
  out.append(text, static_cast<size_t>(length));
}

} // namespace

void append_number(std::string& out, double value) {
  char text[40];
  out.append(text, static_cast<size_t>(print_double(text, value, Form::kGeneral, 12)));
}

void append_integer(std::string& out, int64_t value) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value);
  out.append(text, static_cast<size_t>(end.ptr - text));
}

std::string shortest(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

std::string rounded(double value, int digits) {
  char text[40];
  return std::string(text, static_cast<size_t>(print_slowly(text, value, Form::kGeneral, digits)));
}

void append_column(std::string& out, int64_t value, int width) {
  char text[24];
  const auto end = std::to_chars(text, text + sizeof text, value);
  append_right(out, text, static_cast<int>(end.ptr - text), width);
}

void append_column(std::string& out, const char* word, int width) {
  append_right(out, word, static_cast<int>(std::strlen(word)), width);
}

void append_scientific(std::string& out, double value, int width, int digits) {
  char text[40];
  append_right(out, text, print_double(text, value, Form::kScientific, digits), width);
}

void append_general(std::string& out, double value, int width, int digits) {
  char text[40];
  append_right(out, text, print_double(text, value, Form::kGeneral, digits), width);
}

const char* status_word(int32_t status) {
  switch (status) {
  case C2D_OPEN: return "open";
  case C2D_STICK: return "stick";
  case C2D_SLIP: return "slip";
  case C2D_TIED: return "tied";
  default: return "none";
  }
}

const char* outcome_word(int32_t outcome) {
  switch (outcome) {
  case C2D_REACHED: return "reached";
  case C2D_FREE_MOTION: return "free motion";
  case C2D_GROSS_SLIDING: return "gross sliding";
  case C2D_NO_ADMISSIBLE_CHANGE: return "no admissible change";
  case C2D_NO_PROGRESS: return "changes without progress";
  case C2D_UNDECIDED: return "could not be decided";
  case C2D_TIPPING: return "tipping";
  case C2D_BEYOND_LIMITS: return "beyond the limits of accuracy";
  default: return "unknown";
  }
}

const char* breach_word(int32_t breach) {
  switch (breach) {
  case C2D_BREACH_TABLEAU: return "residual of the contact tableau";
  case C2D_BREACH_EQUATIONS: return "residual of the contact equations";
  case C2D_BREACH_BALANCE: return "balance of forces";
  case C2D_BREACH_SIGN: return "pressure or gap below zero";
  case C2D_BREACH_CONE: return "friction above its bound";
  case C2D_BREACH_SLIP: return "slip along its friction";
  case C2D_BREACH_SINGULAR: return "no unique solution";
  default: return "none";
  }
}

const char* tape_word(int32_t tape) {
  switch (tape) {
  case C2D_TAPE_CONTROL: return "control";
  case C2D_TAPE_LOWER: return "lower";
  case C2D_TAPE_UPPER: return "upper";
  case C2D_TAPE_CONTACT: return "contact";
  default: return "unknown";
  }
}

namespace {

std::string with_name(const char* what, int64_t number, const std::vector<std::string>& names) {
  const std::string text = what + std::to_string(number);
  const bool named = number >= 1 && number <= static_cast<int64_t>(names.size());
  const std::string name = named ? names[static_cast<size_t>(number) - 1] : "";
  return name.empty() ? text : text + " (" + name + ")";
}

} // namespace

std::string body_text(const Summary& s, int64_t body) { return with_name("body ", body, s.body_name); }

std::string zone_text(const Summary& s, int64_t zone) { return with_name("zone ", zone, s.zone_name); }

std::string bodies_text(const Summary& s, const c2d_zone& zone) {
  return body_text(s, zone.side1.body) + " on " + body_text(s, zone.side2.body);
}

size_t character_at(const std::string& text, size_t i) {
  const auto byte = [&](size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(i);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const size_t bytes = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  unsigned code = first & (0x7fu >> bytes);
  for (size_t k = 1; k < bytes; ++k) {
    if ((byte(i + k) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i + k) & 0x3f);
  }
  const unsigned least[] = {0, 0, 0xa0, 0x800, 0x10000};
  const bool shown = code >= least[bytes] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) && (code | 1) != 0xffff;
  return shown ? bytes : 0;
}

size_t characters_in(const std::string& text) {
  size_t count = 0;
  for (size_t i = 0; i < text.size(); i += std::max<size_t>(character_at(text, i), 1)) ++count;
  return count;
}

std::string shown(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const size_t bytes = character_at(text, i);
    out += bytes == 0 ? "?" : text.substr(i, bytes);
    i += std::max<size_t>(bytes, 1);
  }
  return out;
}

int32_t mirror_lines(const Summary& s) { return s.plane == C2D_AXISYMMETRIC ? s.symmetry & ~1 : s.symmetry; }

std::string symmetry_text(const Summary& s) {
  std::string out;
  for (int axis = 0; axis < 2; ++axis) {
    if ((mirror_lines(s) >> axis & 1) == 0) continue;
    if (!out.empty()) out += ", ";
    out += axis == 0 ? "x = " : "y = ";
    append_number(out, s.symmetry_at[axis]);
  }
  return out.empty() ? "none" : out;
}

} // namespace app
