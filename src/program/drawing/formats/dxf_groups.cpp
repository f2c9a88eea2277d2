#include "program/drawing/formats/dxf_groups.hpp"

namespace drawing {

std::vector<Group> groups_of(std::string_view text) {
  std::vector<Group> out;
  Lines lines(text);
  std::string_view code, value;
  while (lines.next(code)) {
    const int at = lines.number();
    if (!lines.next(value)) {
      if (trimmed(code).empty()) break; // blank lines at the end
      throw Fault{at, "the file ends between a group code and its value: it is truncated"};
    }
    const int64_t number = whole_number(code, at, "a group code");
    if (number < -5 || number > 1071) throw Fault{at, "group code " + std::to_string(number) + ", expected 0 to 1071"};
    out.push_back({static_cast<int>(number), trimmed(value), lines.number()});
    if (number == 0 && trimmed(value) == "EOF") return out;
  }
  throw Fault{lines.number(), "the file ends without EOF: it is truncated"};
}

const Group* Entity::find(int code) const {
  for (const Group* g = first; g != last; ++g)
    if (g->code == code) return g;
  return nullptr;
}

double Entity::number(int code, const char* what) const {
  const Group* g = find(code);
  if (g == nullptr) throw Fault{line, std::string(what) + " is missing, expected group " + std::to_string(code)};
  return real(g->value, g->line, what);
}

double Entity::number(int code, double other, const char* what) const { return has(code) ? number(code, what) : other; }

int64_t Entity::flags(int code) const {
  const Group* g = find(code);
  return g == nullptr ? 0 : whole_number(g->value, g->line, "a flag");
}

Point Entity::point(int code, const char* what) const { return {number(code, what), number(code + 10, what)}; }

std::string_view Entity::text(int code) const {
  const Group* g = find(code);
  return g == nullptr ? std::string_view() : g->value;
}

std::vector<double> Entity::numbers(int code, const char* what) const {
  std::vector<double> out;
  for (const Group* g = first; g != last; ++g)
    if (g->code == code) out.push_back(real(g->value, g->line, what));
  return out;
}

std::vector<Point> Entity::points(int code, const char* what) const {
  const std::vector<double> x = numbers(code, what), y = numbers(code + 10, what);
  if (x.size() != y.size()) throw Fault{line, std::string(what) + " has an x without y, or a y without x"};
  std::vector<Point> out;
  for (size_t i = 0; i < x.size(); ++i) out.push_back({x[i], y[i]});
  return out;
}

} // namespace drawing
