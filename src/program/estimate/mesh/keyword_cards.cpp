#include "program/estimate/mesh/keyword_cards.hpp"

#include "program/sketch/deck/deck_number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace estimate {
namespace {

std::string capitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

// The library has accepted the card: a missing value is an omitted number.
int32_t integer(const std::vector<std::string>& words, size_t i) {
  const std::string& text = words.at(i);
  int32_t value = 0;
  std::from_chars(text.data() + (text[0] == '+' ? 1 : 0), text.data() + text.size(), value);
  return value;
}

std::string word(int32_t value) { return " " + std::to_string(value); }

} // namespace

std::vector<std::string> words_of(const std::string& card) {
  std::vector<std::string> out;
  std::string text = card.substr(0, card.find('!'));
  std::string at;
  bool ended = false; // a word was read since the last comma
  for (const char c : text + " ") {
    if (c != ' ' && c != '\t' && c != ',') {
      at += c;
      continue;
    }
    if (!at.empty()) out.push_back(at), at.clear(), ended = true;
    if (c == ',' && !ended) out.push_back("0");
    if (c == ',') ended = false;
  }
  return out;
}

bool is_keyword(const std::vector<std::string>& words, const char* name) {
  return !words.empty() && capitals(words[0]) == name;
}

FreeZoneCard free_zone_card(const std::vector<std::string>& words, const std::vector<int32_t>& offset) {
  std::vector<std::string> numbers(words.begin() + 1, words.end());
  FreeZoneCard out{{0, 1}, false, {}, {0, 0}};
  const auto named = std::find_if(numbers.begin(), numbers.end(), [](const std::string& w) { return capitals(w) == "BODIES"; });
  if (named != numbers.end()) {
    const size_t at = static_cast<size_t>(named - numbers.begin());
    out.body[0] = integer(numbers, at + 1) - 1;
    const int32_t second = integer(numbers, at + 2);
    out.is_self = second < 0;
    out.body[1] = std::abs(second) - 1;
    numbers.erase(named, named + 3);
  }
  for (size_t s = 0; s < 2; ++s) {
    const int32_t before = offset[CutBody::at(out.body[s])] + 1;
    out.elements[s] = {integer(numbers, 2 * s) - before, integer(numbers, 2 * s + 1) - before};
    if (numbers.size() > 4) out.count[s] = integer(numbers, 4 + s);
  }
  return out;
}

std::string free_zone_card(const FreeZoneCard& card, const std::vector<CutBody>& bodies) {
  std::string out = "*ZONE BODIES" + word(card.body[0] + 1) + word(card.is_self ? -card.body[0] - 1 : card.body[1] + 1);
  std::string counts;
  for (int s = 0; s < 2; ++s) {
    const CutBody& body = bodies[CutBody::at(card.body[s])];
    const bool up = goes_up(body, card.elements[s], card.count[s]);
    const Range cut = cut_elements(body, card.elements[s], up);
    out += word(cut.first + 1) + word(cut.last + 1);
    if (card.count[s] > 0) counts += word(count_cut(body, card.elements[s], up));
  }
  return out + counts;
}

std::string curve_card(const c2d_curve& curve, const CutBody& body) {
  const char* const kinds[] = {"LINE", "ARC", "SPLINE"};
  const Range cut = cut_elements(body, {curve.first_element - 1, curve.last_element - 1}, true);
  std::string out = std::string("*CURVE ") + kinds[curve.kind] + word(curve.body) + word(cut.first + 1) + word(cut.last + 1);
  if (curve.kind == C2D_CURVE_ARC)
    out += sketch::deck_number(curve.centre[0]) + sketch::deck_number(curve.centre[1]) + sketch::deck_number(curve.radius);
  return out;
}

std::string platen_card(const std::vector<std::string>& words, const std::vector<int32_t>& offset,
                        const std::vector<CutBody>& bodies) {
  const int32_t b = integer(words, 1) - 1, before = offset[CutBody::at(b)] + 1;
  const CutBody& body = bodies[CutBody::at(b)];
  const Range elements{integer(words, 2) - before, integer(words, 3) - before}, cut = cut_elements(body, elements, true);
  std::string out = "*PLATEN" + word(b + 1) + word(cut.first + 1) + word(cut.last + 1);
  for (size_t i = 4; i < 6; ++i) out += " " + (i < words.size() ? words[i] : "0");
  return words.size() > 6 ? out + word(count_cut(body, elements, true)) : out;
}

} // namespace estimate
