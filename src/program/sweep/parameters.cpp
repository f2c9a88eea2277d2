#include "program/sweep/parameters.hpp"

#include "program/words/near_word.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

namespace app {
namespace {

bool is_name(const std::string& text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !text.empty() && letter(text[0]) && std::all_of(text.begin(), text.end(), [&letter](char c) {
    return letter(c) || std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

bool is_value(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 0x7f && c != '{' && c != '}'; });
}

std::string trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? std::string() : text.substr(begin, end - begin + 1);
}

std::vector<std::string> lines_of_text(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// The two words of `a = b`, `a b`, `{ a = b }`.
bool two_words(std::string line, std::string& first, std::string& second) {
  line = trimmed(line);
  if (line.size() > 1 && line.front() == '{' && line.back() == '}') line = trimmed(line.substr(1, line.size() - 2));
  const size_t end = line.find_first_of(" \t=");
  if (end == std::string::npos) return false;
  first = line.substr(0, end);
  second = line.substr(line.find_first_not_of(" \t", end)); // the line ends with no blank
  if (second[0] == '=') second = trimmed(second.substr(1));
  return !second.empty();
}

// How many variables a file of Dakota says it has, on its first line; -1: it is none such.
long variables_of(const std::string& line) {
  std::string first, second;
  if (!two_words(line, first, second)) return -1;
  if (first == "DAKOTA_VARS") return std::strtol(second.c_str(), nullptr, 10);
  char* end = nullptr;
  const long count = std::strtol(first.c_str(), &end, 10);
  return *end == '\0' && second == "variables" ? count : -1;
}

// One `{...}` of a card.
struct Place {
  size_t begin, end; // of the line; end is behind the brace
  std::string name, standard;
  bool has_standard;
};

// The next one from `at` on; false: there is none.
bool find_place(const std::string& line, size_t at, Place& place) {
  for (size_t open = line.find('{', at); open != std::string::npos; open = line.find('{', open + 1)) {
    const size_t close = line.find('}', open);
    if (close == std::string::npos) return false;
    const std::string inside = line.substr(open + 1, close - open - 1);
    const size_t equals = inside.find('=');
    place = {open, close + 1, inside.substr(0, equals), "", equals != std::string::npos};
    if (place.has_standard) place.standard = inside.substr(equals + 1);
    if (is_name(place.name) && (!place.has_standard || is_value(place.standard))) return true;
  }
  return false;
}

class Filler {
public:
  Filler(const std::vector<Setting>& settings, bool free, std::vector<DeckFault>& faults) : free_(free), faults_(faults) {
    for (const auto& [name, value] : settings) values_[name] = value; // the last one counts
  }
  void fill(std::string& line, int32_t number);
  const std::set<std::string>& names() const { return names_; }
  const std::map<std::string, std::string>& used() const { return used_; }

private:
  void put(std::string& line, int32_t number, const Place& place, const std::string& value, size_t& at);
  void fault(int32_t number, const Place& place, const std::string& text) {
    const int32_t begin = static_cast<int32_t>(place.begin) + shift_, end = static_cast<int32_t>(place.end) + shift_;
    faults_.push_back({number, begin + 1, end, text});
  }
  std::map<std::string, std::string> values_;
  std::set<std::string> names_;
  std::map<std::string, std::string> used_;
  bool free_;
  int32_t shift_ = 0; // columns by which the line that is filled has become shorter
  std::vector<DeckFault>& faults_;
};

void Filler::put(std::string& line, int32_t number, const Place& place, const std::string& value, size_t& at) {
  const size_t width = place.end - place.begin;
  size_t begin = place.begin;
  if (!free_)
    while (place.end - begin < value.size() && begin > 0 && line[begin - 1] == ' ') --begin;
  if (!free_ && place.end - begin < value.size()) {
    at = place.end;
    return fault(number, place,
                 "the value " + value + " of " + place.name + " has " + std::to_string(value.size()) +
                     " characters, but there is room for " + std::to_string(place.end - begin) +
                     ": add blanks before the braces");
  }
  const std::string padded = free_ || value.size() >= width ? value : std::string(width - value.size(), ' ') + value;
  line.replace(begin, place.end - begin, padded);
  at = begin + padded.size();
  Place around;
  if (find_place(line, 0, around) && around.begin < begin && around.end > begin)
    fault(number, place, "{" + place.name + "} is inside other braces, expected one name and one value in each pair of braces");
  shift_ += static_cast<int32_t>(place.end) - static_cast<int32_t>(at);
}

void Filler::fill(std::string& line, int32_t number) {
  Place place;
  shift_ = 0;
  for (size_t at = 0; find_place(line, at, place);) {
    names_.insert(place.name);
    const auto given = values_.find(place.name);
    if (given == values_.end() && !place.has_standard) {
      fault(number, place, "{" + place.name + "} has no value, expected --set " + place.name + "=VALUE");
      at = place.end;
    } else {
      const std::string& value = given != values_.end() ? given->second : place.standard;
      used_.emplace(place.name, value);
      put(line, number, place, value, at);
    }
  }
}

bool is_free(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    std::string word = trimmed(line).substr(0, 5);
    for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (!word.empty()) return word == "*FREE";
  }
  return false;
}

// Puts values into cards, and returns the names that stand there.
std::set<std::string> fill_all(std::vector<std::string>& lines, const std::vector<Setting>& settings,
                               std::vector<DeckFault>& faults, std::vector<Setting>* used = nullptr) {
  const bool free = is_free(lines);
  Filler filler(settings, free, faults);
  for (size_t i = 0; i < lines.size(); ++i) {
    const bool comment = free ? trimmed(lines[i]).substr(0, 1) == "!" : lines[i].substr(0, 1) == "C";
    if (!comment) filler.fill(lines[i], static_cast<int32_t>(i) + 1);
  }
  if (used != nullptr) used->assign(filler.used().begin(), filler.used().end());
  return filler.names();
}

} // namespace

bool read_setting(const std::string& word, Setting& setting) {
  const size_t equals = word.find('=');
  if (equals == std::string::npos) return false;
  setting = {word.substr(0, equals), word.substr(equals + 1)};
  return is_name(setting.first) && is_value(setting.second);
}

bool read_parameters(const std::string& text, std::vector<std::string>& words, std::string& error) {
  const std::vector<std::string> lines = lines_of_text(text);
  long left = lines.empty() ? -1 : variables_of(lines[0]);
  const bool dakota = left >= 0;
  for (size_t i = dakota ? 1 : 0; i < lines.size() && (!dakota || left > 0); ++i) {
    std::string line = trimmed(lines[i].substr(0, lines[i].find('#'))), first, second;
    if (line.empty()) continue;
    Setting setting;
    const bool two = two_words(line, first, second);
    if (two && dakota && line[0] != '{') std::swap(first, second); // a value, then its name
    if (!two || !read_setting(first + "=" + second, setting))
      return error = "line " + std::to_string(i + 1) + ": expected the name of a parameter and its value", false;
    words.push_back(first + "=" + second);
    --left;
  }
  if (dakota && left > 0) error = "ends before the last variable";
  return error.empty();
}

std::set<std::string> parameters_of(const std::string& deck) {
  std::vector<std::string> lines = lines_of_text(deck);
  std::vector<DeckFault> ignored;
  return fill_all(lines, {}, ignored);
}

std::string offer_parameters(const std::string& name, const std::set<std::string>& parameters) {
  return offer(name, {parameters.begin(), parameters.end()});
}

std::vector<Setting> values_of_parameters(const std::string& deck, const std::vector<Setting>& settings) {
  std::vector<std::string> lines = lines_of_text(deck);
  std::vector<DeckFault> ignored;
  std::vector<Setting> used;
  fill_all(lines, settings, ignored, &used);
  return used;
}

bool put_parameters(std::string& deck, const std::vector<Setting>& settings, std::vector<DeckFault>& faults) {
  std::vector<std::string> lines = lines_of_text(deck);
  const std::set<std::string> names = fill_all(lines, settings, faults);
  for (const Setting& setting : settings)
    if (names.count(setting.first) == 0)
      faults.push_back(
          {0, 0, 0,
           "the deck has no parameter " + setting.first +
               (names.empty() ? ": expected {" + setting.first + "} in a card" : offer_parameters(setting.first, names))});
  if (names.empty()) return faults.empty();
  const bool ends = deck.back() == '\n';
  deck.clear();
  for (size_t i = 0; i < lines.size(); ++i) deck += lines[i] + (i + 1 < lines.size() || ends ? "\n" : "");
  return faults.empty();
}

} // namespace app
