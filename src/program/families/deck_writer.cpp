// The deck of a model, in fixed columns.
#include "program/families/model.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace families {
namespace {

__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...) {
  char text[256];
  va_list list;
  va_start(list, format);
  std::vsnprintf(text, sizeof text, format, list);
  va_end(list);
  return text;
}

std::string in_10(double value) {
  const std::string text = number_in(10, value);
  return std::string(10 - text.size(), ' ') + text;
}

// One element end of a body with its condition.
struct End {
  int element, local; // from 1
  std::array<int, 4> codes;
  std::array<std::string, 4> values; // as on the card
  bool is_free() const {
    return codes == std::array<int, 4>{{0, 0, 1, 1}} && values[0] == in_10(0) && values[1] == in_10(0);
  }
  bool same(const End& other) const { return codes == other.codes && values == other.values; }
};

class Writer {
public:
  explicit Writer(const ProblemModel& model) : m_(model) {}
  std::string write();

private:
  void card(const std::string& text) { out_ += text + "\n"; }
  void comment(const std::string& text) { card("C  " + text); }
  bool is_curved(const BodyModel& body) const;
  int geometry_nodes(const BodyModel& body) const;
  void control();
  void nodes(const BodyModel& body);
  void conditions(const BodyModel& body);
  std::vector<End> ends(const BodyModel& body) const;
  End end(const Outline& region, size_t side, int element, int local) const;
  void zones();
  void loads();

  const ProblemModel& m_;
  std::string out_;
};

bool Writer::is_curved(const BodyModel& body) const {
  if (m_.function_nodes < 3) return false;
  for (const Outline& region : body.regions)
    for (const Outline::Node& node : region.nodes())
      if (node.polar) return true;
  return false;
}

int Writer::geometry_nodes(const BodyModel& body) const {
  int count = 0;
  for (const Outline& region : body.regions) count += region.elements() * (is_curved(body) ? 2 : 1);
  return count;
}

void Writer::control() {
  card(formatted("%5d", static_cast<int>(m_.heading.size()) + 1));
  for (const std::string& line : m_.heading) card(line);
  card(m_.title);
  const int bodies = static_cast<int>(m_.bodies.size());
  comment(m_.plane == 0 ? "plane strain; output" : "plane stress; output");
  card(formatted("%5d%5d", m_.plane, bodies == 2 ? 1 : 0));
  comment("bodies, contact zones, functional nodes per element");
  card(formatted("%5d%5d%5d", bodies, static_cast<int>(m_.zones.size()), m_.function_nodes));
  comment("per body: closed curves, boundary points per element, elements, boundary points");
  for (const BodyModel& body : m_.bodies) {
    int count = 0;
    for (const Outline& region : body.regions) count += region.elements();
    card(formatted("%5d%5d%5d%5d", static_cast<int>(body.regions.size()), is_curved(body) ? 3 : 2, count,
                   geometry_nodes(body)));
  }
  comment("per curve: first and last element");
  for (const BodyModel& body : m_.bodies) {
    int first = 1;
    for (const Outline& region : body.regions) {
      card(formatted("%5d%5d", first, first + region.elements() - 1));
      first += region.elements();
    }
  }
  comment("per body: Young's modulus, Poisson's ratio");
  for (const BodyModel& body : m_.bodies) card(in_10(body.youngs_modulus) + in_10(body.poisson_ratio));
  comment("coefficients of friction");
  std::string friction = formatted("%5d ", static_cast<int>(m_.friction.size()));
  for (size_t i = 0; i < m_.friction.size(); ++i) {
    if (i > 0 && i % 7 == 0) card(friction), friction = "      ";
    friction += in_10(std::min(m_.friction[i], 1e9));
  }
  card(friction);
}

// A point of an element at fraction f from its first to its last node; of an arc, on the arc.
Point place(const Outline::Node& a, const Outline::Node& b, double f) {
  const Point at{a.at.x + (b.at.x - a.at.x) * f, a.at.y + (b.at.y - a.at.y) * f};
  if (!a.polar || !b.polar) return at;
  const double degree = std::acos(-1.0) / 180.0, angle = (a.angle + (b.angle - a.angle) * f) * degree;
  const Point centre{a.at.x - a.radius * std::cos(a.angle * degree),
                     a.at.y - a.radius * std::sin(a.angle * degree)};
  return {centre.x + a.radius * std::cos(angle), centre.y + a.radius * std::sin(angle)};
}

// Points of a curve in the order of the cards, middle points of curved elements included.
std::vector<Outline::Node> points_of(const Outline& region, bool curved) {
  std::vector<Outline::Node> out;
  const std::vector<Outline::Node>& n = region.nodes();
  for (int i = 0; i < region.elements(); ++i) {
    const Outline::Node &a = n[static_cast<size_t>(i)], &b = n[static_cast<size_t>(i) + 1];
    out.push_back(a);
    if (!curved) continue;
    Outline::Node middle{{(a.at.x + b.at.x) / 2, (a.at.y + b.at.y) / 2}, false, 0, 0};
    // Both ends polar and not on one ray: an arc (a side along a ray has one polar end at most).
    if (a.polar && b.polar) middle = {middle.at, true, a.radius, (a.angle + b.angle) / 2};
    out.push_back(middle);
  }
  return out;
}

bool is_between(double a, double b, double value, double fraction, double scale) {
  return std::fabs(a + (b - a) * fraction - value) <= 1e-12 * scale;
}

// Do the points first+1 ... last-1 follow from the cards of first and last?
bool is_generated(const std::vector<Outline::Node>& p, size_t first, size_t last) {
  const Outline::Node &a = p[first], &b = p[last];
  for (size_t i = first + 1; i < last; ++i) {
    const double f = static_cast<double>(i - first) / static_cast<double>(last - first);
    if (b.polar && !(a.polar && p[i].polar && is_between(a.angle, b.angle, p[i].angle, f, 360.0)))
      return false;
    const double scale =
        std::max({std::fabs(a.at.x), std::fabs(a.at.y), std::fabs(b.at.x), std::fabs(b.at.y)});
    if (!b.polar && (p[i].polar || !is_between(a.at.x, b.at.x, p[i].at.x, f, scale) ||
                     !is_between(a.at.y, b.at.y, p[i].at.y, f, scale)))
      return false;
  }
  return true;
}

void Writer::nodes(const BodyModel& body) {
  comment("origin and boundary points of " + body.name);
  card(in_10(body.origin.x) + in_10(body.origin.y));
  int number = 1;
  for (const Outline& region : body.regions) {
    const auto p = points_of(region, is_curved(body));
    for (size_t i = 0, next; i < p.size(); i = next) {
      card((p[i].polar ? "P" : " ") + formatted("%4d ", number + static_cast<int>(i)) +
           (p[i].polar ? in_10(p[i].radius) + in_10(p[i].angle)
                       : in_10(p[i].at.x - body.origin.x) + in_10(p[i].at.y - body.origin.y)));
      next = i + 1;
      while (next + 1 < p.size() && is_generated(p, i, next + 1)) ++next;
    }
    number += static_cast<int>(p.size());
  }
}

// A displacement is known at a corner if either of its sides knows it.
End Writer::end(const Outline& region, size_t side, int element, int local) const {
  const std::vector<Outline::Side>& sides = region.sides();
  const Outline::Side& own = sides[side];
  const auto& n = region.nodes();
  const Point at = place(n[static_cast<size_t>(element)], n[static_cast<size_t>(element) + 1],
                         (local - 1.0) / (m_.function_nodes - 1.0));
  End out{element + 1, local, own.condition.codes, {}};
  std::array<double, 4> values{};
  if (own.condition.values) values = own.condition.values(at);
  const bool first = element == own.first && local == 1;
  const bool last = element == own.first + own.elements - 1 && local == m_.function_nodes;
  const auto join = [&](const Outline::Side& other) {
    for (size_t i = 2; i < 4; ++i)
      if (out.codes[i] == 1 && other.condition.codes[i] == 0) {
        out.codes[i] = 0;
        values[i] = other.condition.values ? other.condition.values(at)[i] : 0.0;
      }
  };
  if (first) join(sides[side == 0 ? sides.size() - 1 : side - 1]);
  if (last) join(sides[side + 1 == sides.size() ? 0 : side + 1]);
  for (size_t i = 0; i < 4; ++i)
    out.values[i] = formatted("%10s", number_in(9, values[i]).c_str()); // a blank between them
  return out;
}

std::vector<End> Writer::ends(const BodyModel& body) const {
  std::vector<End> out;
  int offset = 0;
  for (const Outline& region : body.regions) {
    for (size_t s = 0; s < region.sides().size(); ++s) {
      const Outline::Side& side = region.sides()[s];
      for (int e = side.first; e < side.first + side.elements; ++e)
        for (int local = 1; local <= m_.function_nodes; ++local) {
          out.push_back(end(region, s, e, local));
          out.back().element += offset;
        }
    }
    offset += region.elements();
  }
  return out;
}

void Writer::conditions(const BodyModel& body) {
  const std::vector<End> all = ends(body);
  std::vector<std::string> cards;
  const auto add = [&](const End& e, bool generated) {
    cards.push_back(formatted("%c%4d%5d %d%d%d%d ", generated ? '1' : ' ', e.element, e.local, e.codes[0],
                              e.codes[1], e.codes[2], e.codes[3]) +
                    e.values[0] + e.values[1] + e.values[2] + e.values[3]);
  };
  for (size_t i = 0, next; i < all.size(); i = next) {
    next = i + 1;
    while (next < all.size() && all[next].same(all[i])) ++next;
    if (all[i].is_free()) continue;
    add(all[i], false);
    if (next - i > 1) add(all[next - 1], next - i > 2);
  }
  comment("conditions of " + body.name + ": element, end, codes and values of tx ty ux uy");
  card(formatted("%5d", static_cast<int>(cards.size())));
  for (const std::string& text : cards) card(text);
  comment("point loads of " + body.name);
  card("    0");
}

void Writer::zones() {
  int elements_in_contact = 0;
  const int f = m_.function_nodes - 1;
  int pairs = 0;
  for (const ContactZone& zone : m_.zones) {
    const Outline::Side& s1 = m_.bodies[0].regions[0].sides()[static_cast<size_t>(zone.side1)];
    const Outline::Side& s2 = m_.bodies[1].regions[0].sides()[static_cast<size_t>(zone.side2)];
    const int n = s1.elements;
    comment("contact zone: bodies, pairs, elements; its elements; its nodes");
    card(formatted("    1    2%5d%5d", n * f + 1, n));
    card(formatted("%5d%5d%5d%5d", s1.first + 1, s1.first + n, s2.first + n, s2.first + 1));
    card(formatted("%5d%5d%5d%5d", s1.first * f + 1, (s1.first + n) * f + 1, (s2.first + n) * f + 1,
                   s2.first * f + 1));
    elements_in_contact += n;
    pairs += n * f + 1;
  }
  comment("per body: nodes and elements in contact");
  for (size_t body = 0; body < m_.bodies.size(); ++body)
    card(formatted("%5d%5d", pairs, elements_in_contact));
}

void Writer::loads() {
  comment("load cards, limit of iterations; increments and load factor at their end");
  card(formatted("%5d%5d", static_cast<int>(m_.loads.size()), 50));
  for (const Load& load : m_.loads) card(formatted("%5d ", load.increments) + in_10(load.factor));
}

std::string Writer::write() {
  control();
  for (const BodyModel& body : m_.bodies) nodes(body);
  for (const BodyModel& body : m_.bodies) conditions(body);
  zones();
  loads();
  for (const std::string& text : m_.keywords) card(text);
  return out_;
}

} // namespace

// As few digits as tell the number; plain rather than with an exponent where both are as near.
std::string number_in(int columns, double value) {
  if (value == 0) return "0.0";
  std::string best;
  double error = HUGE_VAL;
  const auto consider = [&](const std::string& text) {
    if (text.size() > static_cast<size_t>(columns)) return;
    const double now = std::fabs(std::strtod(text.c_str(), nullptr) - value);
    if (now < error) error = now, best = text;
  };
  for (int digits = 1; digits < columns; ++digits) {
    const std::string text = formatted("%.*f", digits, value);
    consider(text);
    if (text.compare(0, 2, "0.") == 0) consider(text.substr(1));
    if (text.compare(0, 3, "-0.") == 0) consider("-" + text.substr(2));
  }
  for (int digits = 0; digits <= 8; ++digits) { // 1.2345E-06 as 1.2345E-6
    const std::string text = formatted("%.*E", digits, value);
    const size_t e = text.find('E');
    size_t power = e + 2;
    while (power + 1 < text.size() && text[power] == '0') ++power;
    consider(text.substr(0, e) + (digits == 0 ? "." : "") + "E" + (text[e + 1] == '-' ? "-" : "") +
             text.substr(power));
  }
  return best;
}

std::string write_deck(const ProblemModel& model) {
  return Writer(model).write();
}

} // namespace families
