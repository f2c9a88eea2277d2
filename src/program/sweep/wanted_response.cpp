// The name of a requested number contains names of curves and depths, which may look like the words that follow it: "SWT of x",
// "SWT of top at depth 1". So the words are compared with the numbers of the run, first all of them as a name, then without the
// last words.
#include "program/sweep/wanted_response.hpp"

#include "program/words/read_number.hpp"

#include <cmath>

namespace app {
namespace {

// The last word and what is before it; false: there is only one.
bool split_last(const std::string& text, std::string& before, std::string& last) {
  const size_t blank = text.rfind(' ');
  if (blank == std::string::npos) return false;
  last = text.substr(blank + 1), before = text.substr(0, blank); // `before` may be `text`
  return true;
}

// Of a number: its place, or the angle of its plane.
struct WantedPart {
  const char* word;
  double (*of)(const Stated&);
};
constexpr WantedPart kWantedParts[] = {{"x", [](const Stated& s) { return s.at[0]; }},
                                       {"y", [](const Stated& s) { return s.at[1]; }},
                                       {"plane", [](const Stated& s) { return s.angle; }}};
const WantedPart* find_wanted_part(const std::string& word) {
  for (const WantedPart& part : kWantedParts)
    if (word == part.word) return &part;
  return nullptr;
}

// Number `item` of those with this name, from 1 in the order of the statements.
const Stated* find_named(const std::string& name, int32_t item, const std::vector<Stated>& stated) {
  for (const Stated& s : stated)
    if (s.name() == name && s.has_value() && --item == 0) return &s;
  return nullptr;
}

// The same, or one number of several: "stress xx 2".
const Stated* find_counted(const std::string& text, const std::vector<Stated>& stated) {
  if (const Stated* const s = find_named(text, 1, stated)) return s;
  std::string name, last;
  int32_t item = 0;
  return split_last(text, name, last) && read_number(last, item) && item > 0 ? find_named(name, item, stated) : nullptr;
}

bool begins_with(const std::string& text, const std::string& name) { return text.compare(0, name.size(), name) == 0; }

} // namespace

bool is_name_of_wanted(const std::string& text) {
  for (size_t i = 0; i < kMeasures; ++i) {
    const Measure what = static_cast<Measure>(i);
    const std::string name = name_of(what);
    if (name.empty()) continue;
    const bool ends_in_curve = name.back() == ' ';
    if (ends_in_curve ? begins_with(text, name) : text == name) return true;
    if (what >= Measure::kSwt && begins_with(text, name + " of ")) return true; // a fatigue parameter along a curve
  }
  return false;
}

bool take_wanted_words(const std::vector<std::string>& words, Response& r) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  r.of = Response::Of::kWanted, r.number = text;
  for (std::string name = text, last; !name.empty();) {
    if (is_name_of_wanted(name)) return find_measure(name.c_str()) == nullptr;
    int32_t number = 0;
    const bool is_more = split_last(name, name, last);
    if (!is_more || (find_wanted_part(last) == nullptr && !(read_number(last, number) && number > 0))) return false;
  }
  return false;
}

double of_wanted(const Response& r, const std::vector<Stated>& stated) {
  if (const Stated* const s = find_counted(r.number, stated)) return s->value;
  std::string name, last;
  const WantedPart* const part = split_last(r.number, name, last) ? find_wanted_part(last) : nullptr;
  const Stated* const s = part != nullptr ? find_counted(name, stated) : nullptr;
  return s != nullptr ? part->of(*s) : NAN;
}

} // namespace app
