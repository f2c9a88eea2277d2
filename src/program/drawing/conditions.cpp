#include "program/drawing/conditions.hpp"

#include "program/drawing/text.hpp"

#include <algorithm>

namespace drawing {
namespace {

bool is_one_of(std::string_view word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

// The words of a statement, without its comment.
std::vector<std::string> statement_of(std::string_view line) {
  std::string text(line.substr(0, line.find('!')));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ',' || c == '='; }, ' ');
  std::vector<std::string> out;
  for (const std::string_view word : words_of(text)) out.emplace_back(word);
  return out;
}

} // namespace

Conditions read_conditions(std::string_view text) {
  struct Line {
    std::string text;
    std::vector<std::string> words;
    int number;
  };
  std::vector<Line> lines;
  Lines all(text);
  for (std::string_view line; all.next(line);) lines.push_back({std::string(line), statement_of(line), all.number()});
  Conditions out;
  out.given = true;
  for (size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    const std::string word = line.words.empty() ? "" : line.words[0];
    out.has_title = out.has_title || word == "title";
    out.has_units = out.has_units || word == "units";
    size_t next = i + 1;
    while (next < lines.size() && lines[next].words.empty()) ++next;
    const bool draws = next < lines.size() && is_one_of(lines[next].words[0], {"from", "outline", "hole", "circle", "ellipse",
                                                                               "spline", "curve", "arc"});
    if (is_one_of(word, {"title", "units", "plane", "functions", "parameter", "symmetry"})) {
      out.head += line.text + "\n";
    } else if (word == "body" && line.words.size() > 1 && !draws) {
      const std::string& name = line.words[1];
      const size_t behind = line.text.find(name, line.text.find("body") + 4) + name.size();
      out.materials.push_back({name, std::string(trimmed(std::string_view(line.text).substr(behind))), line.number});
    } else {
      out.tail += line.text + "\n";
    }
  }
  return out;
}

} // namespace drawing
