#include "program/commands/families.hpp"

#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"
#include "program/words/near_word.hpp"
#include "program/words/read_number.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace families {
namespace {

bool read_value(const std::string& text, double& value) { return app::read_number(text, value) && !std::isnan(value); }

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, separator);) {
    part.erase(0, part.find_first_not_of(' '));
    part.erase(part.find_last_not_of(' ') + 1);
    out.push_back(part);
  }
  return out;
}

// The words of a choice; none: the parameter is a number.
std::vector<std::string> words_of_choice(const Parameter& parameter) {
  const std::string list = parameter.meaning.substr(0, parameter.meaning.find(':'));
  if (list.find('|') == std::string::npos || list.find(' ') != std::string::npos) return {};
  return parts_of(list, '|');
}

// The number of a value in the sketch; for a choice, the index of its word.
bool read_value(const Parameter& parameter, const std::string& text, double& value, std::string& expected) {
  const std::vector<std::string> words = words_of_choice(parameter);
  const auto found = std::find(words.begin(), words.end(), text);
  expected = words.empty() ? "a number" : "one of " + parameter.meaning.substr(0, parameter.meaning.find(':'));
  if (words.empty()) return read_value(text, value);
  value = static_cast<double>(found - words.begin());
  return found != words.end();
}

std::vector<std::string> keys_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> keys;
  for (const Parameter& parameter : parameters) keys.push_back(parameter.key);
  return keys;
}

bool set_one(const std::vector<Parameter>& known, const std::string& setting, sketch::Parameters& given, std::string& error) {
  const size_t equals = setting.find('=');
  const std::string key = setting.substr(0, equals);
  const auto parameter = std::find_if(known.begin(), known.end(), [&](const Parameter& p) { return p.key == key; });
  std::string expected;
  if (equals == std::string::npos)
    error = "'" + setting + "': expected key=value";
  else if (parameter == known.end())
    error = "'" + key + "' is not a key of this family" + app::did_you_mean(key, keys_of(known));
  else if (given.count(key) > 0)
    error = key + " is given twice";
  else if (!read_value(*parameter, setting.substr(equals + 1), given[key], expected))
    error = setting + ": expected " + expected;
  return error.empty();
}

std::string text_of(const sketch::Fault& fault) {
  return (fault.at.line > 0 ? "line " + std::to_string(fault.at.line) + " of the sketch: " : "") + fault.text;
}

bool make(const Family& family, const std::vector<std::string>& settings, std::string& deck, std::string& error) {
  sketch::Parameters given;
  const std::vector<Parameter> known = parameters_of(family);
  for (const std::string& setting : settings)
    if (!set_one(known, setting, given, error)) return false;
  const auto no_file = [](const std::string&, std::string&) { return false; };
  sketch::Reading reading = sketch::read_sketch(family.sketch, given, no_file);
  reading.sketch.points.clear(); // points belong to runs with mesh refinement
  try {
    if (!reading.faults.empty()) throw reading.faults.front();
    deck = sketch::deck_of(reading.sketch, sketch::given_mesh(reading.sketch));
  } catch (const sketch::Fault& fault) {
    error = text_of(fault);
  }
  return error.empty();
}

} // namespace

const std::vector<Family>& all_families() {
  static const std::vector<Family> families = {
#include "program/family_sketches.inc" // made from examples/families by make relist
  };
  return families;
}

const Family* find_family(const std::string& name) {
  for (const Family& family : all_families())
    if (name == family.name) return &family;
  return nullptr;
}

std::vector<Parameter> parameters_of(const Family& family) {
  std::vector<Parameter> out;
  for (const std::string& line : parts_of(family.sketch, '\n')) {
    const std::vector<sketch::Word> words = sketch::words_of(line, 1);
    if (words.empty() || !words[0].is("parameter")) continue;
    const size_t comment = line.find('!');
    const std::vector<std::string> meanings = parts_of(comment == std::string::npos ? "" : line.substr(comment + 1), ';');
    for (size_t i = 1; i + 1 < words.size(); i += 2) {
      double number = 0;
      if (!read_value(words[i + 1].text, number) || i / 2 >= meanings.size()) continue;
      out.push_back({words[i].text, words[i + 1].text, meanings[i / 2]});
      const std::vector<std::string> choice = words_of_choice(out.back());
      if (!choice.empty()) out.back().value = choice.at(static_cast<size_t>(number));
    }
  }
  return out;
}

std::string summary_of(const Family& family) {
  const std::string first = parts_of(family.sketch, '\n').front();
  return first.substr(first.find_first_not_of(' ', first.find(' ')));
}

std::string describe(const Family& family) {
  std::string out = std::string(family.name) + ": " + summary_of(family) + "\n";
  for (const Parameter& p : parameters_of(family)) {
    std::string left = "  " + p.key + "=" + p.value;
    left.resize(std::max<size_t>(left.size() + 2, 22), ' ');
    out += left + p.meaning + "\n";
  }
  return out;
}

std::string list_families() {
  std::string out;
  for (const Family& family : all_families()) out += describe(family) + "\n";
  return out + "usage: contact2d make NAME key=value ... > DECK\n"
               "keys without a value have the defaults shown; any consistent units may be used\n";
}

bool make_deck(const std::string& name, const std::vector<std::string>& settings, std::string& deck, std::string& error) {
  const Family* const family = find_family(name);
  if (family == nullptr) {
    std::vector<std::string> names;
    for (const Family& known : all_families()) names.push_back(known.name);
    error = "make: '" + name + "' is not a known family" + app::offer(name, names);
    return false;
  }
  if (make(*family, settings, deck, error)) return true;
  error = "make " + name + ": " + error + "\n" + describe(*family);
  error.pop_back();
  return false;
}

} // namespace families
