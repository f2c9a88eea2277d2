#include "program/sketch/outline.hpp"
#include "program/sketch/reader.hpp"

#include <algorithm>

namespace sketch {

const Reader::Keyword Reader::kKeywords[] = {{"title", &Reader::title},
                                             {"units", &Reader::units},
                                             {"plane", &Reader::plane},
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
                                             {"stress", &Reader::stress},
                                             {"interference", &Reader::interference}};

bool is_sketch(const std::string& text) {
  size_t at = 0;
  while (at < text.size()) { // the first word behind comments
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
  return out;
}

void Reader::statement(Statement& s) {
  for (const Keyword& keyword : kKeywords)
    if (s.keyword().text == keyword.name && !s.keyword().quoted) {
      (this->*keyword.read)(s);
      return s.end();
    }
  throw Fault{s.at(), quoted(s.keyword().text) + ": expected a statement such as body, line, contact, fix or history"};
}

void Reader::read(const std::string& text) {
  size_t at = 0;
  for (int line = 1; at < text.size(); ++line) {
    const size_t end = std::min(text.find('\n', at), text.size());
    try {
      std::vector<Word> words = words_of(std::string_view(text).substr(at, end - at), line);
      if (!words.empty()) {
        Statement s(std::move(words), s_.parameters);
        statement(s);
      }
    } catch (const Fault& fault) {
      if (!broken_) faults_.push_back(fault);
      broken_ = in_body_;
    }
    at = end + 1;
  }
  finish();
}

// What only the whole sketch can tell. Shapes are judged if all statements could be read.
void Reader::finish() {
  try {
    end_body();
  } catch (const Fault& fault) {
    faults_.push_back(fault);
  }
  if (!faults_.empty()) return;
  if (s_.bodies.empty()) faults_.push_back({{}, "no body, expected one at least"});
  for (const auto& [name, value] : given_)
    if (used_.count(name) == 0) faults_.push_back({{}, "no parameter of this sketch is called " + quoted(name)});
  for (Fault& fault : faults_of_shapes(s_)) faults_.push_back(std::move(fault));
}

void Reader::title(Statement& s) { s_.title = s.rest(); }

void Reader::units(Statement& s) {
  for (std::string& unit : s_.units) {
    unit = s.take("the names of the units of length and force").text;
    if (unit.size() > 15) s.fail(quoted(unit) + ": expected at most 15 characters");
  }
}

void Reader::plane(Statement& s) { s_.plane_stress = s.choice({"strain", "stress"}) == 1; }

void Reader::functions(Statement& s) { s_.order = static_cast<int>(s.choice({"linear", "quadratic", "cubic"})) + 1; }

// Pairs of a name and a value; later values may use earlier ones. One that is given from outside keeps that value.
void Reader::parameter(Statement& s) {
  do {
    const std::string name = s.name("the name of a parameter");
    if (used_.count(name) > 0) s.fail("parameter " + quoted(name) + " is there already");
    if (name == "pi" || name == "deg") s.fail(quoted(name) + " has a value already");
    used_.insert(name);
    const double value = s.number("the value of " + name);
    if (given_.count(name) == 0) s_.parameters[name] = value;
  } while (s.has_more());
}

void Reader::symmetry(Statement& s) {
  const size_t axis = s.choice({"x", "y"});
  if (s_.symmetry[axis]) s.fail(std::string("a line of symmetry across ") + (axis == 0 ? "x" : "y") + " is there already");
  s_.symmetry[axis] = s.number("its place");
}

Reading read_sketch(const std::string& text, const Parameters& given, const Reader::File& file) {
  Reader reader(given, file);
  reader.read(text);
  return reader.take();
}

} // namespace sketch
