// Runs of the program with all pictures, and what every picture and page must satisfy.
#pragma once

#include "paths.hpp"
#include "report/drawn/axes.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace test {

inline std::string example(const std::string& name) { return paths::root() + "/examples/" + name; }

inline std::string quoted(const std::string& path) { return "'" + path + "'"; }

// ---------------------------------------------------------------- a small XML reader
struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
};

inline bool good_entities(const std::string& text) {
  for (size_t i = text.find('&'); i != std::string::npos; i = text.find('&', i + 1)) {
    const size_t end = text.find(';', i);
    if (end == std::string::npos) return false;
    const std::string name = text.substr(i + 1, end - i - 1);
    const bool number = name.size() > 1 && name[0] == '#' && name.find_first_not_of("0123456789", 1) == std::string::npos;
    if (!number && name != "amp" && name != "lt" && name != "gt" && name != "quot") return false;
  }
  return text.find('<') == std::string::npos;
}

// All elements in order; why it is not well-formed, empty if it is.
inline std::string read_xml(const std::string& xml, std::vector<Element>& out) {
  std::vector<size_t> open;
  size_t at = 0;
  while (at < xml.size()) {
    const size_t tag = xml.find('<', at);
    const std::string text = xml.substr(at, tag == std::string::npos ? std::string::npos : tag - at);
    if (!good_entities(text)) return "bad text: " + text;
    if (!open.empty()) out[open.back()].text += text;
    if (open.empty() && text.find_first_not_of(" \n") != std::string::npos) return "text outside: " + text;
    if (tag == std::string::npos) break;
    const bool comment = xml.compare(tag, 4, "<!--") == 0;
    const size_t last = comment ? xml.find("-->", tag + 4) : tag, end = last == std::string::npos ? last : xml.find('>', last);
    if (end == std::string::npos) return "tag without end";
    if (comment) {
      at = end + 1;
      continue;
    }
    std::string inside = xml.substr(tag + 1, end - tag - 1);
    at = end + 1;
    if (!inside.empty() && inside[0] == '/') {
      if (open.empty() || out[open.back()].name != inside.substr(1)) return "unexpected end " + inside;
      open.pop_back();
      continue;
    }
    const bool empty = !inside.empty() && inside.back() == '/';
    if (empty) inside.pop_back();
    Element e;
    size_t i = inside.find(' ');
    e.name = inside.substr(0, i);
    while (i != std::string::npos && (i = inside.find_first_not_of(' ', i)) != std::string::npos) {
      const size_t equals = inside.find("=\"", i);
      const size_t close = equals == std::string::npos ? equals : inside.find('"', equals + 2);
      if (close == std::string::npos) return "bad attribute in " + inside;
      const std::string name = inside.substr(i, equals - i), value = inside.substr(equals + 2, close - equals - 2);
      if (!e.attributes.emplace(name, value).second) return "attribute twice: " + name;
      if (!good_entities(value)) return "bad value: " + value;
      i = close + 1;
    }
    if (open.empty() && !out.empty()) return "a second root";
    out.push_back(e);
    if (!empty) open.push_back(out.size() - 1);
  }
  return open.empty() ? "" : "not closed: " + out[open.back()].name;
}

inline double number_of(const Element& e, const char* name) {
  const auto found = e.attributes.find(name);
  return found == e.attributes.end() ? 0.0 : std::atof(found->second.c_str());
}

// The box that a text is sure to stay within: 0.6 em a character is more than a common sans-serif needs.
inline app::Box box_of(const Element& e) {
  size_t characters = 0;
  for (size_t i = 0; i < e.text.size(); ++i, ++characters)
    if (e.text[i] == '&') i = e.text.find(';', i);
  const double size = number_of(e, "font-size"), x = number_of(e, "x"), y = number_of(e, "y");
  const double wide = 0.6 * size * static_cast<double>(characters);
  const auto found = e.attributes.find("text-anchor");
  const double part = found == e.attributes.end() ? 0.0 : found->second == "middle" ? 0.5 : 1.0;
  if (e.attributes.count("transform")) return {x - 0.75 * size, y - (1.0 - part) * wide, x + 0.2 * size, y + part * wide};
  return {x - part * wide, y - 0.75 * size, x + (1.0 - part) * wide, y + 0.2 * size};
}

// The largest number in an attribute with coordinates or sizes, 0 in others.
inline double largest_number(const std::string& name, const std::string& value) {
  static const std::set<std::string> kNames = {"d",  "points", "x",  "y", "x1",    "y1",     "x2",
                                               "y2", "cx",     "cy", "r", "width", "height", "transform"};
  double most = 0.0;
  if (kNames.count(name) == 0) return most;
  const std::string digits = "0123456789.";
  for (size_t at = 0; (at = value.find_first_of(digits, at)) != std::string::npos;) {
    const size_t end = std::min(value.find_first_not_of(digits, at), value.size());
    most = std::max(most, std::stod(value.substr(at, end - at)));
    at = end;
  }
  return most;
}

inline void check_picture(const std::string& name, const std::string& svg) {
  std::vector<Element> elements;
  const std::string fault = read_xml(svg, elements);
  CHECK_MESSAGE(fault.empty(), name << ": " << fault);
  if (!fault.empty()) return;
  REQUIRE(elements[0].name == "svg");
  const double width = number_of(elements[0], "width"), height = number_of(elements[0], "height");
  std::vector<std::pair<std::string, app::Box>> texts;
  for (const Element& e : elements) {
    for (const auto& attribute : e.attributes) {
      CHECK_MESSAGE(!contains(attribute.second, "nan"), name << ": " << attribute.second);
      CHECK_MESSAGE(!contains(attribute.second, "inf"), name << ": " << attribute.second);
      // Renderers with fixed-point coordinates draw what is far out wrongly.
      CHECK_MESSAGE(largest_number(attribute.first, attribute.second) <= 1e5, name << ": " << e.name);
    }
    if (e.name != "text") continue;
    CHECK_MESSAGE(number_of(e, "font-size") >= 11.0, name << ": " << e.text);
    const app::Box box = box_of(e);
    CHECK_MESSAGE(box.left >= 0.0, name << ": " << e.text);
    CHECK_MESSAGE(box.right <= width, name << ": " << e.text);
    CHECK_MESSAGE(box.top >= 0.0, name << ": " << e.text);
    CHECK_MESSAGE(box.bottom <= height, name << ": " << e.text);
    for (const auto& other : texts) {
      const bool apart = box.right <= other.second.left || other.second.right <= box.left || box.bottom <= other.second.top ||
                         other.second.bottom <= box.top;
      CHECK_MESSAGE(apart, name << ": '" << e.text << "' over '" << other.first << "'");
    }
    texts.emplace_back(e.text, box);
  }
}

// ---------------------------------------------------------------- a run with all pictures
struct Shown {
  Folder folder;
  Result result;
  std::string page, vtk;
  std::map<std::string, std::string> figures; // by name without .svg
};

// A figure's file as the page has it: its last line tells whose it is.
inline std::string without_mark(const std::string& svg) {
  const size_t mark = svg.rfind("<!-- contact2d ");
  REQUIRE(mark != std::string::npos);
  return svg.substr(0, mark);
}

inline void show(Shown& out, const std::string& deck, const std::string& options = "") {
  out.result = run_shell("'" + paths::program() + "' run " + quoted(deck) + " --listing /dev/null --csv " +
                         quoted(out.folder / "c.csv") + " --report " + quoted(out.folder / "r.html") + " --figures " +
                         quoted(out.folder / "figures") + " --vtk " + quoted(out.folder / "b.vtk") + " --boundary " +
                         quoted(out.folder / "b.csv") + " " + options);
  out.page = read_file(out.folder / "r.html");
  out.vtk = read_file(out.folder / "b.vtk");
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(out.folder / "figures", none))
    out.figures[entry.path().stem().string()] = without_mark(read_file(entry.path().string()));
}

inline std::set<std::string> names_of(const Shown& shown) {
  std::set<std::string> out;
  for (const auto& figure : shown.figures) out.insert(figure.first);
  return out;
}

inline void check_page(const Shown& shown) {
  const std::string& page = shown.page;
  CHECK(page.compare(0, 15, "<!DOCTYPE html>") == 0);
  CHECK(contains(page, "</html>"));
  CHECK(contains(page, "@media print"));
  for (const char* never : {"<script", "src=", "@import", "url(http"}) CHECK_MESSAGE(!contains(page, never), never);
  // Links lead to a place of the page alone.
  const std::string link = "href=\"";
  for (size_t at = page.find(link); at != std::string::npos; at = page.find(link, at + 1)) {
    const std::string to = page.substr(at + link.size(), page.find('"', at + link.size()) - at - link.size());
    CHECK_MESSAGE((to[0] == '#' && contains(page, " id=\"" + to.substr(1) + "\"")), to);
  }
  std::map<std::string, size_t> inline_pictures; // those of the frames of a load path are in the page alone
  for (const char* name : {"<svg", "<input type=\"radio\""})
    for (size_t at = page.find(name); at != std::string::npos; at = page.find(name, at + 1)) ++inline_pictures[name];
  CHECK(inline_pictures["<svg"] - inline_pictures["<input type=\"radio\""] == shown.figures.size());
  for (const auto& figure : shown.figures) {
    CHECK_MESSAGE(contains(page, figure.second), figure.first);
    check_picture(figure.first, figure.second);
  }
  std::set<std::string> ids;
  for (size_t at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1)) {
    const std::string id = page.substr(at + 5, page.find('"', at + 5) - at - 5);
    CHECK_MESSAGE(ids.insert(id).second, id);
  }
}

inline std::string caption_of(const Shown& shown, const std::string& name) {
  const size_t section = shown.page.find("<section id=\"" + name + "\">");
  REQUIRE(section != std::string::npos);
  const size_t start = shown.page.find("<figcaption>", section) + 12;
  return shown.page.substr(start, shown.page.find("</figcaption>", start) - start);
}

struct PairRow {
  double mu, load, x, y, tn;
  int step, pair;
  std::string status;
};
// Rows of the last recorded step of one coefficient.
inline std::vector<PairRow> last_rows(const std::string& csv, double mu) {
  std::vector<PairRow> out;
  for (const std::string& line : lines_of(csv)) {
    std::istringstream in(line);
    std::vector<std::string> f;
    for (std::string field; std::getline(in, field, ',');) f.push_back(field);
    if (f.size() != 18 || f[0] == "mu" || std::stod(f[0]) != mu) continue;
    const PairRow row{std::stod(f[0]), std::stod(f[2]), std::stod(f[4]), std::stod(f[5]),
                      std::stod(f[7]), std::stoi(f[1]), std::stoi(f[3]), f[6]};
    if (!out.empty() && out.back().step != row.step) out.clear();
    out.push_back(row);
  }
  return out;
}

inline std::string six(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

} // namespace test
