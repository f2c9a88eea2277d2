#include "program/sketch/deck/actions.hpp"
#include "program/sketch/deck/contacts.hpp"
#include "program/sketch/moving.hpp"
#include "program/sketch/read/reader.hpp"
#include "program/sketch/shapes/outline.hpp"
#include "program/sketch/torsion.hpp"
#include "program/words/near_word.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

const Reader::Keyword Reader::kKeywords[] = {{"title", &Reader::title},
                                             {"units", &Reader::units},
                                             {"plane", &Reader::plane},
                                             {"axisymmetric", &Reader::axisymmetric},
                                             {"functions", &Reader::functions},
                                             {"parameter", &Reader::parameter},
                                             {"symmetry", &Reader::symmetry},
                                             {"body", &Reader::body},
                                             {"outline", &Reader::outline},
                                             {"hole", &Reader::hole},
                                             {"from", &Reader::from},
                                             {"line", &Reader::straight},
                                             {"arc", &Reader::arc},
                                             {"circle", &Reader::circle},
                                             {"ellipse", &Reader::ellipse},
                                             {"curve", &Reader::curve},
                                             {"spline", &Reader::spline},
                                             {"fillet", &Reader::fillet},
                                             {"chamfer", &Reader::chamfer},
                                             {"mirror", &Reader::mirror},
                                             {"copy", &Reader::copy},
                                             {"part", &Reader::part_of},
                                             {"contact", &Reader::contact},
                                             {"tie", &Reader::tie},
                                             {"case", &Reader::load_case},
                                             {"fix", &Reader::fix},
                                             {"move", &Reader::move},
                                             {"traction", &Reader::traction},
                                             {"pressure", &Reader::pressure},
                                             {"force", &Reader::force},
                                             {"weight", &Reader::weight},
                                             {"spin", &Reader::spin},
                                             {"platen", &Reader::platen},
                                             {"drive", &Reader::drive},
                                             {"history", &Reader::history},
                                             {"cycle", &Reader::cycle},
                                             {"interference", &Reader::interference},
                                             {"steps", &Reader::steps},
                                             {"stress", &Reader::stress},
                                             {"want", &Reader::want},
                                             {"tolerance", &Reader::tolerance},
                                             {"limit", &Reader::limit},
                                             {"elements", &Reader::elements},
                                             {"require", &Reader::require}};

bool is_sketch(const std::string& text, const std::string& name) {
  constexpr std::string_view kEnding = ".c2s";
  if (name.size() > kEnding.size() && name.compare(name.size() - kEnding.size(), kEnding.size(), kEnding) == 0) return true;
  size_t at = 0;
  while (at < text.size()) { // the first word after comments
    const size_t end = std::min(text.find('\n', at), text.size());
    const size_t first = text.find_first_not_of(" \t\r", at);
    if (first < end && text[first] != '!') {
      const std::string word = text.substr(first, text.find_first_of(" \t\r\n=,;!", first) - first);
      const std::vector<std::string> known = Reader::words();
      return std::find(known.begin(), known.end(), word) != known.end();
    }
    at = end + 1;
  }
  return false;
}

std::vector<std::string> Reader::words() {
  std::vector<std::string> out;
  for (const Keyword& keyword : kKeywords) out.push_back(keyword.name);
  out.push_back("when");
  return out;
}

void Reader::statement(Statement& s) {
  for (const Keyword& keyword : kKeywords)
    if (s.keyword().text == keyword.name && !s.keyword().quoted) {
      (this->*keyword.read)(s);
      return s.end();
    }
  is_lost_ = true;
  const std::string near = app::did_you_mean(s.keyword().text, words());
  throw Fault{s.at(), in_quotes(s.keyword().text) + ": expected a statement" +
                          (near.empty() ? ", such as body, line, contact, fix, platen, pressure or history" : near)};
}

void Reader::read(const std::string& text) {
  size_t at = 0;
  for (int line = 1; at < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', at), text.size());
    try {
      std::vector<Word> words = words_of(std::string_view(text).substr(at, end - at), line);
      if (applies(words)) {
        Statement s(std::move(words), s_.parameters);
        statement(s);
      }
    } catch (const Fault& fault) {
      if (!broken_ && !fault.text.empty()) faults_.push_back(fault);
      broken_ = in_body_;
      if (in_body_) broken_bodies_.insert(static_cast<int>(s_.bodies.size()) - 1);
    }
    at = end + 1;
  }
  finish();
}

// `when value statement`: the statement applies if the value is not 0.
bool Reader::applies(std::vector<Word>& words) {
  while (!words.empty() && words[0].is("when")) {
    Statement condition(words, s_.parameters);
    if (condition.number("a value: 0 to ignore the statement after it") == 0) return false;
    if (!condition.has_more()) condition.missing("a statement");
    words.erase(words.begin(), words.begin() + 2);
  }
  return !words.empty();
}

// Checks of the whole sketch, if all statements could be read.
void Reader::finish() {
  end_body();
  if (!faults_.empty()) return;
  if (s_.bodies.empty()) faults_.push_back({{}, "the sketch has no body, expected at least one"});
  for (Fault& fault : take_torsion(s_)) faults_.push_back(std::move(fault));
  if (!faults_.empty()) return;
  for (Fault& fault : faults_of_shapes(s_)) faults_.push_back(std::move(fault));
  for (Fault& fault : faults_of_actions(s_)) faults_.push_back(std::move(fault));
  if (faults_.empty())
    for (Fault& fault : faults_of_moving_loads(s_)) faults_.push_back(std::move(fault));
  if (!faults_.empty()) return;
  for (Fault& fault : cut_contacts(s_)) faults_.push_back(std::move(fault));
}

// For statements allowed once.
void Reader::once(Statement& s, const std::string& what) {
  if (!once_.insert(what).second) throw Fault{s.at(), what + " is given twice, expected once"};
}

void Reader::title(Statement& s) {
  once(s, "the title");
  if (!s.has_more()) return;
  s_.title = s.rest();
  std::replace(s_.title.begin(), s_.title.end(), '\t', ' ');
  if (!is_ascii(s_.title)) s.fail("the title has a character that is not printable ASCII, expected only printable ASCII");
  if (s_.title.size() > kLongestTitle)
    s.fail("the title has " + std::to_string(s_.title.size()) + " bytes, expected at most " + std::to_string(kLongestTitle));
}

void Reader::units(Statement& s) {
  once(s, "the statement 'units'");
  for (std::string& unit : s_.units) {
    unit = s.take("the names of the units of length and force").text;
    if (unit.size() > 15) s.fail(in_quotes(unit) + ": expected at most 15 characters");
    if (unit.empty() || !is_ascii(unit) || unit.find_first_of(" ,!") != std::string::npos)
      s.fail("the name of a unit is not one word of plain ASCII text, expected a name such as mm, N or lbf");
  }
}

void Reader::plane(Statement& s) {
  once(s, "the statement 'plane' or 'axisymmetric'");
  s_.plane_stress =
      s.is_number() ? s.whole("0 for plane strain, 1 for plane stress", 0, 1) == 1 : s.choice({"strain", "stress"}) == 1;
}

// The axis is a line on which outlines end, as on one of symmetry.
void Reader::axisymmetric(Statement& s) {
  once(s, "the statement 'plane' or 'axisymmetric'");
  if (!s_.bodies.empty()) throw Fault{s.at(), "'axisymmetric' stands after a body, expected it before the first body"};
  if (s_.symmetry[0]) s.fail("a line of symmetry x is given, bodies of revolution have the axis x = 0");
  s_.axisymmetric = true;
  s_.symmetry[0] = 0.0;
}

void Reader::functions(Statement& s) {
  once(s, "the statement 'functions'");
  const int order = s.is_number() ? s.whole("1 for linear, 2 for quadratic, 3 for cubic functions, 0 for the default", 0, 3)
                                  : static_cast<int>(s.choice({"linear", "quadratic", "cubic"})) + 1;
  s_.order = std::max(order, 1);
  s_.chooses_order = order == 0;
}

// Pairs of a name and a value; later values may use earlier ones. A value given on the command line takes precedence.
void Reader::parameter(Statement& s) {
  do {
    const std::string name = s.name("the name of a parameter");
    if (name.find('-') != std::string::npos)
      s.fail(in_quotes(name) + ": expected letters, digits and _; '-' means subtraction");
    if (used_.count(name) > 0) s.fail("parameter " + in_quotes(name) + " is defined twice");
    if (name == "pi" || name == "deg" || name == "inf")
      s.fail(in_quotes(name) + " is reserved, expected a name other than pi, deg and inf");
    used_.insert(name);
    if (s.is_next(kTolerance)) s.missing("the value of " + name + " before its tolerance");
    s.divide_at(kTolerance);
    const double value = s.number("the value of " + name, true);
    const auto given = given_.find(name);
    s_.parameters[name] = given == given_.end() ? value : given->second;
    tolerance_of_parameter(s, name);
  } while (s.has_more());
}

// `+- 0.01`, or `+- 1 %` of the value. One given on the command line takes precedence.
void Reader::tolerance_of_parameter(Statement& s, const std::string& name) {
  const double value = s_.parameters[name];
  Tolerance out{name, value, 0, s.last()};
  if (s.accept(kTolerance) || s.accept_prefix(kTolerance)) {
    const std::string expected = "the tolerance of " + name;
    out.at = s.last();
    if (!std::isfinite(value)) s.fail(name + " is infinite, expected a finite value before a tolerance");
    const bool percent = s.is_share();
    out.size = s.share(expected) * (percent ? std::fabs(value) : 1);
    if (out.size < 0) s.fail(show(out.size) + ": expected " + expected + ", not below 0");
  }
  if (const auto given = given_tolerances_.find(name); given != given_tolerances_.end()) out.size = given->second;
  if (out.size > 0) s_.tolerances.push_back(out);
}

// require value text: the text is an error if the value is below 0.
void Reader::require(Statement& s) {
  const bool is_met = s.number("a value that must not be below 0") >= 0;
  const std::string why = s.take("the error message, in quotes").text;
  if (!is_met) throw Fault{s.at(), why};
}

void Reader::symmetry(Statement& s) {
  const size_t axis = s.choice({"x", "y"});
  if (s_.symmetry[axis]) s.fail(std::string("the line of symmetry ") + (axis == 0 ? "x" : "y") + " is given twice");
  if (!s_.bodies.empty()) throw Fault{s.at(), "the line of symmetry stands after a body, expected it before the first body"};
  s_.symmetry[axis] = s.number("the coordinate of the line");
}

Reading read_sketch(const std::string& text, const Parameters& given, const Reader::File& file, const Parameters& tolerances) {
  Reader reader(given, file, tolerances);
  reader.read(text);
  return reader.take();
}

} // namespace sketch
