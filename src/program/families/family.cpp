#include "program/families/family.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>

namespace families {
namespace {

bool read_number(const std::string& text, double& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

bool is_choice(const char* meaning, const std::string& word) {
  const std::string list(meaning, std::strcspn(meaning, ":"));
  return !word.empty() && word.find('|') == std::string::npos && ("|" + list + "|").find("|" + word + "|") != std::string::npos;
}

// Of the kinds of numbers, in their order.
const struct {
  const char* expected;
  bool (*fits)(double);
} kNumbers[] = {{"a number above 0", [](double v) { return v > 0; }},
                {"a number above 1", [](double v) { return v > 1; }},
                {"a number", [](double) { return true; }},
                {"a whole number from 1 to 2000", [](double v) { return v >= 1 && v <= 2000 && v == std::floor(v); }},
                {"1, 2 or 3", [](double v) { return v == 1 || v == 2 || v == 3; }},
                {"a number from 0 to 1", [](double v) { return v >= 0 && v <= 1; }},
                {"a number above -1, at most 0.5", [](double v) { return v > -1 && v <= 0.5; }},
                {"a number from 0, or inf", [](double v) { return v >= 0; }}};
static_assert(std::size(kNumbers) == static_cast<size_t>(Kind::kChoice),
              "words are the last kind, behind all kinds of numbers");

const Parameter* find_parameter(const Family& family, const std::string& key) {
  for (const Parameter& parameter : family.parameters)
    if (key == parameter.key) return &parameter;
  return nullptr;
}

bool set_one(const Family& family, const std::string& setting, std::map<std::string, bool>& seen, Values& values,
             std::string& error) {
  const size_t equals = setting.find('=');
  const std::string key = setting.substr(0, equals);
  const Parameter* parameter = find_parameter(family, key);
  if (equals == std::string::npos)
    error = "'" + setting + "': expected key=value";
  else if (parameter == nullptr)
    error = "'" + key + "' is not a key of this family";
  else if (seen[key])
    error = key + " is given twice";
  if (!error.empty()) return false;
  seen[key] = true;
  std::string expected;
  if (values.set(*parameter, setting.substr(equals + 1), expected)) return true;
  error = setting + ": expected " + expected;
  return false;
}

} // namespace

bool Values::set(const Parameter& parameter, const std::string& text, std::string& expected) {
  words_[parameter.key] = text;
  if (parameter.kind == Kind::kChoice) {
    expected = "one of " + std::string(parameter.meaning, std::strcspn(parameter.meaning, ":"));
    return is_choice(parameter.meaning, text);
  }
  const auto& number = kNumbers[static_cast<size_t>(parameter.kind)];
  expected = number.expected;
  double value = 0;
  if (parameter.kind == Kind::kFriction && text == "inf")
    value = HUGE_VAL;
  else if (!read_number(text, value) || !number.fits(value))
    return false;
  numbers_[parameter.key] = value;
  return true;
}

ProblemModel unfit(const std::string& why) {
  ProblemModel model;
  model.title = why;
  return model;
}

const std::vector<Family>& all_families() {
  static const std::vector<Family> families = {
      hertz_family(),   receding_layer_family(),    layer_lifted_family(), layer_pressed_family(), disc_in_hole_family(),
      punch_family(),   cylinder_friction_family(), mindlin_family(),      rough_plates_family(),  ring_family(),
      hole_family(),    cantilever_family(),        stack_family(),        rollers_family(),       bearing_family(),
      coating_family(), bimaterial_family(),        shrink_family(),       crack_family()};
  return families;
}

const Family* find_family(const std::string& name) {
  for (const Family& family : all_families())
    if (name == family.name) return &family;
  return nullptr;
}

std::string describe(const Family& family) {
  std::string out = std::string(family.name) + ": " + family.summary + "\n";
  for (const Parameter& p : family.parameters) {
    std::string left = std::string("  ") + p.key + "=" + p.value;
    left.resize(std::max<size_t>(left.size() + 2, 22), ' ');
    out += left + p.meaning + "\n";
  }
  return out;
}

std::string list_families() {
  std::string out;
  for (const Family& family : all_families()) {
    out += describe(family);
    out += "\n";
  }
  out += "usage: contact2d make NAME key=value ... > DECK\n"
         "keys that are not given have the values shown; they are in any consistent units\n";
  return out;
}

bool make_model(const std::string& name, const std::vector<std::string>& settings, ProblemModel& model, std::string& error) {
  const Family* family = find_family(name);
  if (family == nullptr) {
    error = "make: '" + name + "' is not a known family; known are";
    for (const Family& known : all_families()) error += std::string(" ") + known.name;
    error += "; dovetail, gear and lap_joint are sketches, in examples/families";
    return false;
  }
  Values values;
  std::string expected, wrong;
  for (const Parameter& parameter : family->parameters) values.set(parameter, parameter.value, expected);
  std::map<std::string, bool> seen;
  bool good = true;
  for (const std::string& setting : settings) good = good && set_one(*family, setting, seen, values, wrong);
  if (good) {
    model = family->build(values);
    good = !model.bodies.empty();
    if (!good) wrong = model.title;
  }
  if (!good) {
    error = "make " + name + ": " + wrong + "\n" + describe(*family);
    error.pop_back();
    return false;
  }
  model.heading.push_back("Written by: contact2d make " + name + (settings.empty() ? "" : " with"));
  std::string line;
  for (const std::string& setting : settings) {
    if (line.size() + setting.size() > 68) model.heading.push_back(line), line.clear();
    line += (line.empty() ? "  " : " ") + setting;
  }
  if (!line.empty()) model.heading.push_back(line);
  return true;
}

bool make_deck(const std::string& name, const std::vector<std::string>& settings, std::string& deck, std::string& error) {
  ProblemModel model;
  if (!make_model(name, settings, model, error)) return false;
  deck = write_deck(model);
  return true;
}

} // namespace families
