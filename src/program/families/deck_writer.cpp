// The deck of a model, in the free form: every number with all its digits.
#include "program/families/model.hpp"
#include "program/sketch/deck_number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

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

std::string number(double value) { return sketch::deck_number(value); }

// One element end of a body with its condition.
struct End {
  int element, local; // from 1
  std::array<int, 4> codes;
  std::array<std::string, 4> values; // as on the card
  bool is_free() const { return codes == std::array<int, 4>{{0, 0, 1, 1}} && values[0] == number(0) && values[1] == number(0); }
  bool same(const End& other) const { return codes == other.codes && values == other.values; }
};

// A boundary curve of the deck: a closed outline, or, by images, what of it lies between lines of symmetry.
struct Curve {
  const Outline* outline;
  size_t first_side, sides;
  int first, elements; // of the outline's elements, from 0
  bool open;
};

std::vector<Curve> curves_of(const Outline& outline, bool images) {
  std::vector<Curve> out;
  const std::vector<Outline::Side>& sides = outline.sides();
  bool inside = false, any = false;
  for (size_t i = 0; i < sides.size(); ++i) {
    const bool left_out = images && sides[i].axis != 0;
    any = any || left_out;
    if (!left_out && !inside) out.push_back({&outline, i, 0, sides[i].first, 0, false});
    if (!left_out) out.back().sides += 1, out.back().elements += sides[i].elements;
    inside = !left_out;
  }
  for (Curve& curve : out) curve.open = any;
  return out;
}

class Writer {
public:
  explicit Writer(const ProblemModel& model) : m_(model) {
    for (const BodyModel& body : m_.bodies) {
      curves_.emplace_back();
      for (const Outline& region : body.regions)
        for (const Curve& curve : curves_of(region, m_.images)) curves_.back().push_back(curve);
    }
  }
  std::string write();

private:
  void card(const std::string& text) { out_ += text + "\n"; }
  void comment(const std::string& text) { card("! " + text); }
  bool is_curved(const BodyModel& body) const;
  int elements(size_t body) const;
  int nodes_along(const Curve& curve, int steps) const { return curve.elements * steps + (curve.open ? 1 : 0); }
  int geometry_nodes(size_t body) const;
  void control();
  void nodes(size_t b);
  void conditions(size_t b);
  std::vector<End> ends(size_t b) const;
  struct Range { // first element, and first and last node of a side of a zone, from 1
    int element, elements, first_node, last_node;
  };
  Range range_of(const ZoneSide& side, bool without_first = false, bool without_last = false) const;
  void hold(const Outline& region, int element, int local, std::array<int, 4>& codes, std::array<double, 4>& values) const;
  End end(const Outline& region, size_t side, int element, int local) const;
  void zones();
  void loads();
  void free_zones();
  void ties();
  void friction();
  void symmetry();
  void rigid_bodies();

  const ProblemModel& m_;
  std::vector<std::vector<Curve>> curves_; // per body
  std::string out_;
};

bool Writer::is_curved(const BodyModel& body) const {
  if (m_.function_nodes < 3) return false;
  for (const Outline& region : body.regions)
    for (const Outline::Node& node : region.nodes())
      if (node.polar) return true;
  return false;
}

int Writer::elements(size_t b) const {
  int count = 0;
  for (const Curve& curve : curves_[b]) count += curve.elements;
  return count;
}

int Writer::geometry_nodes(size_t b) const {
  int count = 0;
  for (const Curve& curve : curves_[b]) count += nodes_along(curve, is_curved(m_.bodies[b]) ? 2 : 1);
  return count;
}

void Writer::control() {
  card("*FREE");
  card(std::to_string(m_.heading.size() + 1));
  for (const std::string& line : m_.heading) card(line);
  card(m_.title);
  const int bodies = static_cast<int>(m_.bodies.size());
  const int matching =
      static_cast<int>(std::count_if(m_.zones.begin(), m_.zones.end(), [](const ContactZone& zone) { return !zone.free; }));
  comment(m_.plane == 0 ? "plane strain; output" : "plane stress; output");
  card(formatted("%d %d", m_.plane, m_.zones.empty() ? 0 : 1));
  comment("bodies, contact zones, functional nodes per element");
  card(formatted("%d %d %d", bodies, matching, m_.function_nodes));
  comment("per body: closed curves, boundary points per element, elements, boundary points");
  for (size_t b = 0; b < m_.bodies.size(); ++b)
    card(formatted("%d %d %d %d", static_cast<int>(curves_[b].size()), is_curved(m_.bodies[b]) ? 3 : 2, elements(b),
                   geometry_nodes(b)));
  comment("per curve: first and last element");
  for (const std::vector<Curve>& curves : curves_) {
    int first = 1;
    for (const Curve& curve : curves) {
      card(formatted("%d %d", first, first + curve.elements - 1));
      first += curve.elements;
    }
  }
  comment("per body: Young's modulus, Poisson's ratio");
  for (const BodyModel& body : m_.bodies) card(number(body.youngs_modulus) + number(body.poisson_ratio));
  comment("coefficients of friction");
  std::string friction = std::to_string(m_.friction.size());
  for (size_t i = 0; i < m_.friction.size(); ++i) {
    if (i > 0 && i % 5 == 0) card(friction), friction.clear();
    friction += number(std::min(m_.friction[i], 1e9));
  }
  card(friction);
}

// A point of an element at fraction f from its first to its last node; of an arc, on the arc.
Point place(const Outline::Node& a, const Outline::Node& b, double f) {
  const Point at{a.at.x + (b.at.x - a.at.x) * f, a.at.y + (b.at.y - a.at.y) * f};
  if (!a.polar || !b.polar) return at;
  const double degree = std::acos(-1.0) / 180.0, angle = (a.angle + (b.angle - a.angle) * f) * degree;
  const Point centre{a.at.x - a.radius * std::cos(a.angle * degree), a.at.y - a.radius * std::sin(a.angle * degree)};
  return {centre.x + a.radius * std::cos(angle), centre.y + a.radius * std::sin(angle)};
}

// Points of a curve in the order of the cards, middle points of curved elements included.
std::vector<Outline::Node> points_of(const Curve& curve, bool curved) {
  std::vector<Outline::Node> out;
  const std::vector<Outline::Node>& n = curve.outline->nodes();
  for (int i = curve.first; i < curve.first + curve.elements; ++i) {
    const Outline::Node &a = n[static_cast<size_t>(i)], &b = n[static_cast<size_t>(i) + 1];
    out.push_back(a);
    if (!curved) continue;
    Outline::Node middle{{(a.at.x + b.at.x) / 2, (a.at.y + b.at.y) / 2}, false, 0, 0, {}, {}};
    // Both ends polar and not on one ray: an arc (a side along a ray has one polar end at most).
    if (a.polar && b.polar) middle = {middle.at, true, a.radius, (a.angle + b.angle) / 2, {}, {}};
    out.push_back(middle);
  }
  if (curve.open) out.push_back(n[static_cast<size_t>(curve.first + curve.elements)]);
  return out;
}

bool is_between(double a, double b, double value, double fraction, double scale) {
  return std::fabs(a + (b - a) * fraction - value) <= 1e-15 * scale;
}

// Do the points first+1 ... last-1 follow from the cards of first and last?
bool is_generated(const std::vector<Outline::Node>& p, size_t first, size_t last) {
  const Outline::Node &a = p[first], &b = p[last];
  for (size_t i = first + 1; i < last; ++i) {
    const double f = static_cast<double>(i - first) / static_cast<double>(last - first);
    if (b.polar && !(a.polar && p[i].polar && is_between(a.angle, b.angle, p[i].angle, f, 360.0))) return false;
    const double scale = std::max({std::fabs(a.at.x), std::fabs(a.at.y), std::fabs(b.at.x), std::fabs(b.at.y)});
    if (!b.polar &&
        (p[i].polar || !is_between(a.at.x, b.at.x, p[i].at.x, f, scale) || !is_between(a.at.y, b.at.y, p[i].at.y, f, scale)))
      return false;
  }
  return true;
}

void Writer::nodes(size_t b) {
  const BodyModel& body = m_.bodies[b];
  comment("origin and boundary points of " + body.name);
  card(number(body.origin.x) + number(body.origin.y));
  size_t first = 1;
  for (const Curve& curve : curves_[b]) {
    const auto p = points_of(curve, is_curved(body));
    for (size_t i = 0, next; i < p.size(); i = next) {
      card((p[i].polar ? "P " : "") + std::to_string(first + i) +
           (p[i].polar ? number(p[i].radius) + number(p[i].angle)
                       : number(p[i].at.x - body.origin.x) + number(p[i].at.y - body.origin.y)));
      next = i + 1;
      while (next + 1 < p.size() && is_generated(p, i, next + 1)) ++next;
    }
    first += p.size();
  }
}

// A point that is held: what holds it is a traction of the element that begins there.
void Writer::hold(const Outline& region, int element, int local, std::array<int, 4>& codes,
                  std::array<double, 4>& values) const {
  const auto& n = region.nodes();
  const bool begins = local == 1, ends = local == m_.function_nodes;
  if (!begins && !ends) return;
  const size_t at = static_cast<size_t>(element) + (ends ? 1 : 0), last = n.size() - 1;
  const Outline::Node &node = n[at], &same = n[at == 0 ? last : at == last ? 0 : at];
  for (size_t i = 0; i < 2; ++i)
    if ((node.held[i] || same.held[i]) && codes[i + 2] == 1) {
      codes[i + 2] = 0, codes[i] = begins ? 1 : 0;
      values[i + 2] = node.held[i] ? node.moved[i] : same.moved[i];
    }
}

// A displacement is known at a corner if either of its sides knows it.
End Writer::end(const Outline& region, size_t side, int element, int local) const {
  const std::vector<Outline::Side>& sides = region.sides();
  const Outline::Side& own = sides[side];
  const auto& n = region.nodes();
  const Point at =
      place(n[static_cast<size_t>(element)], n[static_cast<size_t>(element) + 1], (local - 1.0) / (m_.function_nodes - 1.0));
  End out{element + 1, local, own.condition.codes, {}};
  std::array<double, 4> values{};
  if (own.condition.values) values = own.condition.values(at);
  const bool first = element == own.first && local == 1;
  const bool last = element == own.first + own.elements - 1 && local == m_.function_nodes;
  const auto join = [&](const Outline::Side& other) {
    if (m_.images && other.axis != 0) return;
    for (size_t i = 2; i < 4; ++i)
      if (out.codes[i] == 1 && other.condition.codes[i] == 0) {
        out.codes[i] = 0;
        values[i] = other.condition.values ? other.condition.values(at)[i] : 0.0;
      }
  };
  if (first) join(sides[side == 0 ? sides.size() - 1 : side - 1]);
  if (last) join(sides[side + 1 == sides.size() ? 0 : side + 1]);
  hold(region, element, local, out.codes, values);
  for (size_t i = 0; i < 4; ++i) out.values[i] = number(out.codes[i] == 1 ? 0.0 : values[i]); // what is unknown has none
  return out;
}

std::vector<End> Writer::ends(size_t b) const {
  std::vector<End> out;
  int offset = 0;
  for (const Curve& curve : curves_[b]) {
    for (size_t i = curve.first_side; i < curve.first_side + curve.sides; ++i) {
      const Outline::Side& side = curve.outline->sides()[i];
      for (int e = side.first; e < side.first + side.elements; ++e)
        for (int local = 1; local <= m_.function_nodes; ++local) {
          out.push_back(end(*curve.outline, i, e, local));
          out.back().element += offset - curve.first;
        }
    }
    offset += curve.elements;
  }
  return out;
}

Writer::Range Writer::range_of(const ZoneSide& side, bool without_first, bool without_last) const {
  const size_t at = static_cast<size_t>(side.side), b = static_cast<size_t>(side.body);
  const Outline* const outline = &m_.bodies[b].regions[static_cast<size_t>(side.region)];
  const int order = m_.function_nodes - 1;
  Range out{1, outline->sides()[at].elements, 1, 1};
  for (const Curve& curve : curves_[b]) {
    const int nodes = nodes_along(curve, order);
    if (curve.outline == outline && at >= curve.first_side && at < curve.first_side + curve.sides) {
      const int before = outline->sides()[at].first - curve.first, end = (before + out.elements) * order - without_last;
      out.element += before;
      out.last_node = out.first_node + (end == nodes ? 0 : end); // a closed curve ends where it begins
      out.first_node += before * order + without_first;
      return out;
    }
    out.element += curve.elements;
    out.first_node += nodes;
  }
  return out;
}

void Writer::conditions(size_t b) {
  const BodyModel& body = m_.bodies[b];
  const std::vector<End> all = ends(b);
  std::vector<std::string> cards;
  const auto add = [&](const End& e, bool generated) {
    cards.push_back(formatted("%s%d %d %d%d%d%d", generated ? "1 " : "", e.element, e.local, e.codes[0], e.codes[1], e.codes[2],
                              e.codes[3]) +
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
  card(formatted("%d", static_cast<int>(cards.size())));
  for (const std::string& text : cards) card(text);
  comment("point loads of " + body.name);
  card("0");
}

void Writer::zones() {
  std::vector<int> pairs(m_.bodies.size(), 0), elements(m_.bodies.size(), 0);
  for (const ContactZone& zone : m_.zones) {
    if (zone.free) continue;
    const Range a = range_of(zone.side1, zone.without_first, zone.without_last),
                b = range_of(zone.side2, zone.without_last, zone.without_first);
    const int n = a.elements, count = n * (m_.function_nodes - 1) + 1 - zone.without_first - zone.without_last;
    comment("contact zone: bodies, pairs, elements; its elements; its nodes");
    card(formatted("%d %d %d %d", zone.side1.body + 1, zone.side2.body + 1, count, n));
    card(formatted("%d %d %d %d", a.element, a.element + n - 1, b.element + n - 1, b.element));
    card(formatted("%d %d %d %d", a.first_node, a.last_node, b.last_node, b.first_node));
    for (const int body : {zone.side1.body, zone.side2.body}) {
      elements[static_cast<size_t>(body)] += n;
      pairs[static_cast<size_t>(body)] += count;
    }
  }
  comment("per body: nodes and elements in contact");
  for (size_t b = 0; b < m_.bodies.size(); ++b) card(formatted("%d %d", pairs[b], elements[b]));
}

void Writer::free_zones() {
  for (const ContactZone& zone : m_.zones) {
    if (!zone.free) continue;
    const Range a = range_of(zone.side1), b = range_of(zone.side2);
    card(formatted("*ZONE BODIES %d %d %d %d %d %d", zone.side1.body + 1, zone.side2.body + 1, a.element,
                   a.element + a.elements - 1, b.element, b.element + b.elements - 1));
  }
}

void Writer::ties() {
  for (size_t i = 0; i < m_.zones.size(); ++i)
    if (m_.zones[i].tied) card("*TIE " + std::to_string(i + 1));
}

void Writer::loads() {
  comment("load cards, limit of iterations; increments and load factor at their end");
  card(formatted("%d %d", static_cast<int>(m_.loads.size()), 50));
  for (const Load& load : m_.loads) card(std::to_string(load.increments) + number(load.factor));
}

// The card of coefficients has no word for adhesion; a keyword card has, for each zone.
void Writer::friction() {
  if (std::none_of(m_.friction.begin(), m_.friction.end(), [](double mu) { return std::isinf(mu); })) return;
  card("*FRICTION");
  for (size_t i = 0; i < m_.zones.size(); ++i) {
    if (m_.zones[i].tied) continue;
    std::string text = std::to_string(i + 1);
    for (const double mu : m_.friction) text += std::isinf(mu) ? " INF" : number(mu);
    card(text);
  }
}

void Writer::rigid_bodies() {
  for (size_t b = 0; b < m_.bodies.size(); ++b) {
    const RigidModel& rigid = m_.bodies[b].rigid;
    const std::string body = " " + std::to_string(b + 1);
    if (rigid.kind == RigidModel::kHeld) card("*RIGID" + body);
    if (rigid.kind != RigidModel::kLoaded) continue;
    card("*RIGID LOAD" + body + number(rigid.point.x) + number(rigid.point.y) + (rigid.free.empty() ? "" : " " + rigid.free));
    card("1" + number(rigid.load[0]) + number(rigid.load[1]) + number(rigid.load[2]));
  }
}

void Writer::symmetry() {
  bool told[2] = {false, false};
  for (const BodyModel& body : m_.bodies)
    for (const Outline& region : body.regions)
      for (const Outline::Side& side : region.sides()) {
        if (side.axis == 0 || told[side.axis - 'X']) continue;
        const Point at = region.nodes()[static_cast<size_t>(side.first)].at;
        card(formatted("*SYMMETRY %c", side.axis) + number(side.axis == 'X' ? at.x : at.y));
        told[side.axis - 'X'] = true;
      }
}

std::string Writer::write() {
  control();
  for (size_t b = 0; b < m_.bodies.size(); ++b) nodes(b);
  for (size_t b = 0; b < m_.bodies.size(); ++b) conditions(b);
  zones();
  loads();
  free_zones();
  ties();
  friction();
  if (m_.images) symmetry();
  rigid_bodies();
  for (const std::string& text : m_.keywords) card(text);
  return out_;
}

} // namespace

std::string write_deck(const ProblemModel& model) { return Writer(model).write(); }

} // namespace families
