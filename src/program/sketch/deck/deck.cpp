// The deck of a sketch with its mesh, in free form (Writer::write). Phases:
// 1. Find the zones and the conditions at the nodes of all elements (zones_of, ends).
// 2. Write heading, control cards, boundary points, conditions and matching zones (heading to matching_zones).
// 3. Write the keyword cards: names, symmetry, zones, platens, exact curves, rigid bodies, body forces, load cases, load
//    history, interior points.
#include "program/sketch/mesh.hpp"

#include "program/sketch/deck/deck_number.hpp"
#include "program/sketch/deck/idle_cases.hpp"
#include "program/sketch/deck/zones.hpp"
#include "program/sketch/moving.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sketch {
namespace {

std::string number(double value) {
  if (std::fabs(value) < kMostInDeck) return deck_number(value);
  throw Fault{{}, "the deck would contain the number" + deck_number(value) + ", expected a magnitude below 1e100"};
}

using Values = std::array<double, 4>; // tx ty ux uy

// The condition at a node of an element, in all load cases.
struct End {
  int element, local;          // from 1
  std::array<bool, 2> fixed{}; // prescribed by a statement on this element: its traction is unknown
  std::array<bool, 2> known{}; // is the displacement known? At a joint, the neighbouring element may prescribe it
  std::vector<Values> values;  // of each case
};

class Writer {
public:
  Writer(const Sketch& sketch, const Mesh& mesh) : s_(sketch), mesh_(mesh) {}
  std::string write();

private:
  void card(const std::string& text) { out_ += text + "\n"; }
  void comment(const std::string& text) { card("! " + text); }
  bool is_curved(size_t b) const;
  int elements(size_t b) const;
  int geometry_nodes(size_t b) const;
  int nodes() const { return s_.order + 1; } // per element
  void heading();
  void control();
  double common_friction() const;
  void points(size_t b);
  std::vector<End> ends(size_t b) const;
  void apply(const Condition& c, const MeshedCurve& curve, double s, End& end) const;
  void conditions(size_t b);
  void cases();
  size_t interference_case() const;
  void history();
  int first_node(size_t b, int element) const;
  size_t matching() const;
  void matching_zones();
  void zones();
  std::string curve_card(size_t b, const Shape& shape, int first, int last) const;
  void curves();
  void rigid_bodies();
  void platens();

  const Sketch& s_;
  const Mesh& mesh_;
  std::vector<Zone> zones_;
  std::vector<std::vector<End>> ends_;
  std::string out_;
};

bool Writer::is_curved(size_t b) const {
  if (mesh_.given && s_.order == 1 && !s_.bodies[b].rigid) return false;
  for (const Outline& outline : s_.bodies[b].outlines)
    for (const Curve& curve : outline.curves)
      if (curve.shape->form() != Form::kLine) return true;
  return false;
}

int Writer::elements(size_t b) const {
  size_t count = 0;
  for (const MeshedOutline& outline : mesh_.bodies[b]) count += outline.elements();
  return static_cast<int>(count);
}

int Writer::geometry_nodes(size_t b) const {
  int count = elements(b) * (is_curved(b) ? 2 : 1);
  for (const MeshedOutline& outline : mesh_.bodies[b]) count += outline.open ? 1 : 0;
  return count;
}

void Writer::heading() {
  card("*FREE");
  card("2");
  card("Made from a sketch");
  card(s_.title.empty() ? "SKETCH" : s_.title);
}

void Writer::control() {
  const std::string bodies = std::to_string(s_.bodies.size());
  comment(s_.axisymmetric ? "axisymmetric; output" : s_.plane_stress ? "plane stress; output" : "plane strain; output");
  card(s_.axisymmetric ? "2 2" : s_.plane_stress ? "1 2" : "0 2"); // the load path is followed even without zones
  comment("bodies, matching zones, functional nodes per element");
  card(bodies + " " + std::to_string(matching()) + " " + std::to_string(nodes()));
  comment("per body: curves, boundary points per element, elements, boundary points");
  for (size_t b = 0; b < s_.bodies.size(); ++b)
    card(std::to_string(mesh_.bodies[b].size()) + (is_curved(b) ? " 3 " : " 2 ") + std::to_string(elements(b)) + " " +
         std::to_string(geometry_nodes(b)));
  comment("per curve: first and last element");
  for (size_t b = 0; b < s_.bodies.size(); ++b) {
    size_t first = 1;
    for (const MeshedOutline& outline : mesh_.bodies[b]) {
      card(std::to_string(first) + " " + std::to_string(first + outline.elements() - 1));
      first += outline.elements();
    }
  }
  comment("per body: Young's modulus, Poisson's ratio");
  for (const Body& body : s_.bodies) card(body.rigid ? " 1 0" : number(body.youngs_modulus) + number(body.poisson_ratio));
  comment("coefficients of friction");
  card("1" + number(common_friction()));
}

// That of all contacts, if it is one and finite; the others are on the card *FRICTION.
double Writer::common_friction() const {
  double out = NAN;
  for (const Zone& zone : zones_) {
    const Interface& interface = s_.interfaces[zone.contact->interface];
    if (interface.tied) continue;
    if (std::isnan(out)) out = interface.friction;
    if (interface.friction != out || std::isinf(out)) return 0;
  }
  return std::isnan(out) ? 0 : out;
}

void Writer::points(size_t b) {
  int first = 1; // element
  for (const MeshedOutline& outline : mesh_.bodies[b])
    for (const MeshedCurve& curve : outline.curves) {
      const int last = first + static_cast<int>(curve.elements()) - 1;
      const std::string name = s_.bodies[b].name + (curve.curve->name.empty() ? "" : "." + curve.curve->name);
      comment("curve of body " + std::to_string(b + 1) + ": " + name + ", elements " + std::to_string(first) + " to " +
              std::to_string(last) + ", nodes " + std::to_string(first_node(b, first)) + " to " +
              std::to_string(first_node(b, last) + s_.order));
      first = last + 1;
    }
  comment("origin and boundary points of " + s_.bodies[b].name);
  card("0 0");
  int node = 0;
  const auto add = [&](Point p) { card(std::to_string(++node) + number(p.x) + number(p.y)); };
  for (const MeshedOutline& outline : mesh_.bodies[b]) {
    for (const MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e) {
        add(curve.curve->shape->at(curve.measure.u_at(curve.ends[e])));
        if (is_curved(b)) add(curve.curve->shape->at(curve.measure.u_at((curve.ends[e] + curve.ends[e + 1]) / 2)));
      }
    if (outline.open) add(outline.curves.back().curve->shape->at(1));
  }
}

// Adds the values of a condition at a place of its curve.
void Writer::apply(const Condition& c, const MeshedCurve& curve, double s, End& end) const {
  if (c.part == Condition::kStart && (s > 0 || !curve.curve->is_first)) return;
  if (c.part == Condition::kEnd && (s < (1 - 1e-12) * curve.ends.back() || !curve.curve->is_last)) return;
  Values& values = end.values[static_cast<size_t>(c.load_case)];
  const Shape& shape = *curve.curve->shape;
  const double u = curve.measure.u_at(s);
  const Point value = c.value_at(shape.at(u));
  if (c.kind == Condition::kPressure) {
    const Point normal = -1.0 * turned_left(shape.tangent(u));
    values[0] -= value.x * normal.x, values[1] -= value.x * normal.y;
  }
  for (size_t i = 0; i < 2 && c.kind != Condition::kPressure; ++i) {
    if (!c.value[i]) continue;
    if (c.kind == Condition::kDisplacement) end.fixed[i] = true;
    values[i + (c.kind == Condition::kDisplacement ? 2 : 0)] += i == 0 ? value.x : value.y;
  }
}

std::vector<End> Writer::ends(size_t b) const {
  std::vector<End> out;
  int element = 0;
  for (const MeshedOutline& outline : mesh_.bodies[b]) {
    const size_t first = out.size();
    for (const MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e) {
        ++element;
        for (int local = 1; local <= nodes(); ++local) {
          End end{element, local, {}, {}, std::vector<Values>(s_.cases.size(), Values{})};
          const double s = curve.ends[e] + (curve.ends[e + 1] - curve.ends[e]) * (local - 1) / (nodes() - 1);
          for (const Condition& c : s_.conditions)
            if (c.side.body == static_cast<int>(b) && c.side.has(curve.curve->name)) apply(c, curve, s, end);
          end.known = end.fixed;
          out.push_back(end);
        }
      }
    // A displacement prescribed at a joint is known for the elements on both sides of it.
    const size_t count = out.size() - first, step = static_cast<size_t>(nodes());
    for (size_t k = step - 1; k < count; k += step) {
      const size_t other = k + 1 < count ? k + 1 : 0;
      if (other == 0 && outline.open) break;
      End &p = out[first + k], &q = out[first + other];
      for (size_t i = 0; i < 2; ++i) {
        if (p.fixed[i] == q.fixed[i]) continue;
        End &from = p.fixed[i] ? p : q, &to = p.fixed[i] ? q : p;
        to.known[i] = true;
        for (size_t c = 0; c < to.values.size(); ++c) to.values[c][i + 2] = from.values[c][i + 2];
      }
    }
  }
  return out;
}

void Writer::conditions(size_t b) {
  const std::vector<End>& all = ends_[b];
  std::vector<std::string> cards;
  const auto text_of = [&](size_t k) {
    std::string text = " ";
    for (size_t i = 0; i < 2; ++i) text += all[k].fixed[i] ? '1' : '0';
    for (size_t i = 0; i < 2; ++i) text += all[k].known[i] ? '0' : '1';
    for (size_t i = 0; i < 4; ++i) { // unknowns are written as 0
      const bool known = i < 2 ? !all[k].fixed[i] : static_cast<bool>(all[k].known[i - 2]);
      text += number(known ? all[k].values[0][i] : 0.0);
    }
    return text;
  };
  const std::string free = " 0011 0 0 0 0";
  for (size_t k = 0, next; k < all.size(); k = next) {
    const std::string text = text_of(k);
    for (next = k + 1; next < all.size() && text_of(next) == text;) ++next;
    if (text == free) continue;
    const auto add = [&](size_t i, bool range) {
      cards.push_back((range ? "1 " : "") + std::to_string(all[i].element) + " " + std::to_string(all[i].local) + text);
    };
    add(k, false);
    if (next - k > 1) add(next - 1, next - k > 2);
  }
  comment("conditions of " + s_.bodies[b].name + ": element, end, codes and values of tx ty ux uy");
  card(std::to_string(cards.size()));
  for (const std::string& text : cards) card(text);
  std::vector<std::string> loads;
  for (const PointLoad& p : s_.point_loads)
    if (p.body == static_cast<int>(b) && p.load_case == 0)
      loads.push_back(std::to_string(loads.size() + 1) + number(p.where.x) + number(p.where.y) + number(p.force.x) +
                      number(p.force.y));
  comment("point loads");
  card(std::to_string(loads.size()));
  for (const std::string& text : loads) card(text);
}

// Load cases after the first: their values of the known quantities.
void Writer::cases() {
  if (s_.cases.size() < 2) return;
  card("*CASES " + std::to_string(s_.cases.size()));
  for (size_t c = 1; c < s_.cases.size(); ++c) {
    card("case " + std::to_string(c + 1) + (s_.cases[c].name.empty() ? "" : " ! " + s_.cases[c].name));
    for (size_t b = 0; b < s_.bodies.size(); ++b) {
      const std::vector<End>& all = ends_[b];
      for (const End& end : all) {
        const Values& v = end.values[c];
        if (v == Values{}) continue;
        std::string text =
            "condition " + std::to_string(b + 1) + " " + std::to_string(end.element) + " " + std::to_string(end.local);
        for (const double value : v) text += number(value);
        card(text);
      }
    }
    for (const PointLoad& p : s_.point_loads)
      if (p.load_case == static_cast<int>(c))
        card("load " + std::to_string(p.body + 1) + number(p.where.x) + number(p.where.y) + number(p.force.x) +
             number(p.force.y));
  }
}

// The load case that closes overlaps: one after those of the sketch, or its only case if that has no loads. 0: none.
size_t Writer::interference_case() const {
  const bool alone = s_.cases.size() == 1 && !acts(s_, 0);
  return !s_.interference ? 0 : alone ? 1 : s_.cases.size() + 1;
}

// After so many columns a card of load factors goes on on the next line.
constexpr size_t kFactorColumns = 120;

void Writer::history() {
  card("*PATH");
  const std::string fitted = interference_case() > s_.cases.size() ? " 1" : "";
  if (s_.pieces == 0) {
    std::string text = std::to_string(s_.steps.front()) + " 1";
    for (size_t c = 1; c < s_.cases.size(); ++c) text += " 0";
    return card(text + fitted);
  }
  for (size_t piece = 0; piece < static_cast<size_t>(s_.pieces); ++piece) {
    if (s_.cycle && piece == static_cast<size_t>(s_.cycle->before))
      card("cycle " + std::to_string(s_.cycle->limit) +
           (s_.cycle->digits > 0 ? " digits " + std::to_string(s_.cycle->digits) : "") +
           (s_.cycle->frictionless ? " frictionless"
            : s_.cycle->compare    ? " compare"
                                   : ""));
    std::string text = std::to_string(s_.steps[std::min(piece, s_.steps.size() - 1)]);
    for (const LoadCase& c : s_.cases) {
      if (text.size() > kFactorColumns) {
        card(text + " &");
        text.clear();
      }
      text += number(c.factors[piece]);
    }
    card(text + fitted);
  }
}

// The first node of an element, from 1 within its body.
int Writer::first_node(size_t b, int element) const {
  int node = (element - 1) * s_.order + 1, before = 0;
  for (const MeshedOutline& outline : mesh_.bodies[b]) {
    before += static_cast<int>(outline.elements());
    if (element > before && outline.open) ++node;
  }
  return node;
}

size_t Writer::matching() const {
  return static_cast<size_t>(std::count_if(zones_.begin(), zones_.end(), [](const Zone& zone) { return zone.matching; }));
}

void Writer::matching_zones() {
  std::vector<int> nodes_in(s_.bodies.size(), 0), elements_in(s_.bodies.size(), 0);
  for (const Zone& zone : zones_) {
    if (!zone.matching) continue;
    const size_t one = static_cast<size_t>(zone.contact->side[0].body), two = static_cast<size_t>(zone.contact->side[1].body);
    const int count = zone.two.count, at_begin = zone.leaves[0], at_end = zone.leaves[1];
    const int pairs = count * s_.order + 1 - at_begin - at_end;
    const auto four = [](int a, int b, int c, int d) {
      return std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " + std::to_string(d);
    };
    comment("matching zone: bodies, pairs, elements; its elements; its nodes");
    card(four(static_cast<int>(one) + 1, static_cast<int>(two) + 1, pairs, count));
    card(four(zone.one.first, zone.one.last, zone.two.last, zone.two.first));
    const int from = first_node(one, zone.one.first) + at_end, to = first_node(two, zone.two.first) + at_begin;
    card(four(from, from + pairs - 1, to + pairs - 1, to));
    for (const size_t b : {one, two}) nodes_in[b] += pairs, elements_in[b] += count;
  }
  comment("per body: nodes and elements in matching zones");
  for (size_t b = 0; b < s_.bodies.size(); ++b) card(std::to_string(nodes_in[b]) + " " + std::to_string(elements_in[b]));
}

// Where a zone begins on the second side of its statement: the length along the outline from the start of the first curve of
// the statement to the first element, and of a closed outline its length, in which lengths are then counted.
std::string begin_on_statement(const Mesh& mesh, const Interface& interface, const Zone& zone) {
  const bool turned = zone.contact->turned;
  const Side& side = interface.side[1];
  int before = 0;
  const int first = (turned ? zone.one : zone.two).first;
  for (const MeshedOutline& outline : mesh.bodies[static_cast<size_t>(side.body)]) {
    const int own = first - before;
    before += static_cast<int>(outline.elements());
    if (first > before) continue;
    double begin = 0, whole = 0, fixed = NAN, best = HUGE_VAL;
    int passed = 0;
    for (const MeshedCurve& curve : outline.curves) {
      const auto named = std::find(side.names.begin(), side.names.end(), curve.curve->name);
      const auto rank = static_cast<double>(named - side.names.begin());
      if (named != side.names.end() && curve.curve->is_first && rank < best) best = rank, fixed = whole;
      const int element = own - 1 - passed;
      passed += static_cast<int>(curve.elements());
      if (element >= 0 && own <= passed) begin = whole + curve.ends[static_cast<size_t>(element)];
      whole += curve.ends.back();
    }
    const double from = begin - (std::isnan(fixed) ? 0 : fixed);
    return number(outline.open || from >= 0 ? from : from + whole) + (outline.open ? "" : " of" + number(whole));
  }
  return number(0);
}

// The reason why a zone ends although contact may continue there; empty: it cannot.
std::string end_of(const Zone& zone, size_t end) {
  return zone.whole[end] ? zone.contact->ends[end]
                         : "on coarser meshes the surfaces did not touch there, and a limit ended the mesh refinement";
}

void Writer::zones() {
  int number_of_zone = 0;
  std::string ties, frictions;
  for (const Zone& zone : zones_) {
    const Interface& interface = s_.interfaces[zone.contact->interface];
    const int one = zone.contact->side[0].body, two = zone.contact->side[1].body;
    const std::string index = std::to_string(++number_of_zone);
    std::string text = "*ZONE BODIES " + std::to_string(one + 1) + (two == one ? " -" : " ") + std::to_string(two + 1);
    for (const Stretch& s : {zone.one, zone.two}) text += " " + std::to_string(s.first) + " " + std::to_string(s.last);
    if (zone.one.last < zone.one.first || zone.two.last < zone.two.first)
      text += " " + std::to_string(zone.one.count) + " " + std::to_string(zone.two.count);
    for (size_t end = 0; end < 2; ++end)
      if (const std::string why = end_of(zone, end); !why.empty()) comment("zone " + index + " may extend farther: " + why);
    if (zone.contact->turned) comment("zone " + index + ": side 2 is the first of its statement");
    if (!interface.tied) comment("zone " + index + ": the second side begins at" + begin_on_statement(mesh_, interface, zone));
    if (!zone.matching) card(text);
    const std::string name =
        !interface.name.empty() ? interface.name : interface.side[0].names[0] + " on " + interface.side[1].names[0];
    ties += (interface.tied ? "*TIE " + index + "\n" : "") + "*NAME ZONE " + index + " " + name.substr(0, 31) + "\n";
    if (!interface.tied && interface.friction != common_friction())
      frictions += index + (std::isinf(interface.friction) ? " INF" : number(interface.friction)) + "\n";
  }
  out_ += ties;
  if (!frictions.empty()) out_ += "*FRICTION\n" + frictions;
}

std::string Writer::curve_card(size_t b, const Shape& shape, int first, int last) const {
  std::string text = shape.form() == Form::kLine ? "LINE " : shape.form() == Form::kArc ? "ARC " : "SPLINE ";
  text += std::to_string(b + 1) + " " + std::to_string(first) + " " + std::to_string(last);
  if (shape.form() == Form::kArc) {
    const double bend = shape.curvature(0.5);
    const Point centre = shape.at(0.5) + (1 / bend) * turned_left(shape.tangent(0.5));
    text += number(centre.x) + number(centre.y) + number(1 / std::fabs(bend));
  }
  return "*CURVE " + text;
}

// The exact curves of sides in contact. All pieces of a drawn curve are on one card.
void Writer::curves() {
  const auto touches = [&](const Curve& curve) {
    return curve.contact >= 0 && !s_.interfaces[s_.contacts[static_cast<size_t>(curve.contact)].interface].tied;
  };
  for (size_t b = 0; b < s_.bodies.size(); ++b) {
    if (mesh_.given && !s_.bodies[b].rigid) continue;
    int element = 0;
    for (const MeshedOutline& outline : mesh_.bodies[b])
      for (size_t i = 0; i < outline.curves.size();) {
        const int first = element + 1;
        bool any = false;
        const Shape& shape = *outline.curves[i].curve->shape;
        for (bool same = true; same; ++i) {
          element += static_cast<int>(outline.curves[i].elements());
          any = any || touches(*outline.curves[i].curve);
          same = !outline.curves[i].curve->is_last && i + 1 < outline.curves.size();
        }
        if (any) card(curve_card(b, shape, first, element));
      }
  }
}

// Rigid bodies: motions without a given value are free; a rigid body without a statement `drive` is fixed.
void Writer::rigid_bodies() {
  for (size_t b = 0; b < s_.bodies.size(); ++b) {
    if (!s_.bodies[b].rigid) continue;
    std::array<bool, 3> given{};
    Point about;
    bool driven = false;
    std::string motions, loads;
    for (const Drive& d : s_.drives) {
      if (d.side || d.body != static_cast<int>(b)) continue;
      about = d.about, driven = true;
      std::string motion = std::to_string(d.load_case + 1), load = motion;
      for (size_t i = 0; i < 3; ++i) {
        given[i] = given[i] || d.motion[i];
        motion += number(d.motion[i].value_or(0)), load += number(d.load[i].value_or(0));
      }
      if (d.motion[0] || d.motion[1] || d.motion[2]) motions += motion + number(about.x) + number(about.y) + "\n";
      if (d.load[0] || d.load[1] || d.load[2]) loads += load + "\n";
    }
    const std::string body = " " + std::to_string(b + 1);
    const bool free = driven && !(given[0] && given[1] && given[2]);
    if (!free || !motions.empty()) out_ += "*RIGID" + body + "\n" + motions;
    if (!free) continue;
    const char* const words[3] = {" X", " Y", " TURN"};
    out_ += "*RIGID LOAD" + body + number(about.x) + number(about.y);
    for (size_t i = 0; i < 3; ++i) out_ += given[i] ? "" : words[i];
    out_ += "\n" + loads;
  }
}

// Platens in the order of the statements. Statements on the same side are one platen in several load cases.
void Writer::platens() {
  const char* const motions[3] = {" UX", " UY", " TURN"};
  const char* const loads[3] = {" FX", " FY", " MOMENT"};
  for (size_t i = 0; i < s_.drives.size(); ++i) {
    const Drive& first = s_.drives[i];
    if (!first.side) continue;
    bool done = false;
    for (size_t k = 0; k < i; ++k) done = done || same_target(first, s_.drives[k]);
    if (done) continue;
    const std::vector<Stretch> all = stretches_of(mesh_, *first.side);
    if (all.size() != 1)
      throw Fault{first.at, "the curves of a platen are not consecutive, expected one stretch of the outline"};
    card("*PLATEN " + std::to_string(first.body + 1) + " " + std::to_string(all[0].first) + " " + std::to_string(all[0].last) +
         number(first.about.x) + number(first.about.y) +
         (all[0].last < all[0].first ? " " + std::to_string(all[0].count) : ""));
    for (size_t k = i; k < s_.drives.size(); ++k) {
      const Drive& d = s_.drives[k];
      if (!same_target(first, d)) continue;
      std::string text = std::to_string(d.load_case + 1);
      for (size_t c = 0; c < 3; ++c) {
        if (d.motion[c]) text += motions[c] + number(*d.motion[c]);
        if (d.load[c]) text += loads[c] + number(*d.load[c]);
      }
      card(text);
    }
  }
}

std::string Writer::write() {
  zones_ = zones_of(s_, mesh_);
  for (size_t b = 0; b < s_.bodies.size(); ++b) ends_.push_back(ends(b));
  heading();
  control();
  for (size_t b = 0; b < s_.bodies.size(); ++b) points(b);
  for (size_t b = 0; b < s_.bodies.size(); ++b) conditions(b);
  matching_zones();
  comment("load cards, limit of iterations");
  card("1 50");
  card("1 1");
  if (s_.torsion.any()) comment("loads round the axis are not part of the deck");
  if (!s_.units[0].empty()) card("*UNITS " + s_.units[0] + " " + s_.units[1]);
  for (size_t b = 0; b < s_.bodies.size(); ++b) card("*NAME BODY " + std::to_string(b + 1) + " " + s_.bodies[b].name);
  for (size_t axis = 0; axis < 2; ++axis)
    if (s_.symmetry[axis] && (axis == 1 || !s_.axisymmetric))
      card(std::string("*SYMMETRY ") + (axis == 0 ? "X" : "Y") + number(*s_.symmetry[axis]));
  zones();
  platens();
  curves();
  rigid_bodies();
  for (const BodyForce& f : s_.body_forces)
    card("*BODY FORCE " + std::to_string(f.body + 1) + " " + std::to_string(f.load_case + 1) + number(f.weight.x) +
         number(f.weight.y) + (f.rho_omega2 == 0 ? "" : number(f.rho_omega2) + number(f.centre.x) + number(f.centre.y)));
  cases();
  if (s_.interference) card("*INTERFERENCE " + std::to_string(interference_case()));
  history();
  if (!s_.points.empty()) {
    card("*POINTS");
    for (const WantedPoint& p : s_.points) card("point " + std::to_string(p.body + 1) + number(p.at.x) + number(p.at.y));
  }
  return out_;
}

} // namespace

std::string deck_of(const Sketch& sketch, const Mesh& mesh) {
  if (has_moving_loads(sketch)) return deck_of(with_positions(sketch), mesh);
  for (size_t c = 0; c < sketch.cases.size() && sketch.cases.size() > 1; ++c)
    if (!acts(sketch, c)) return Writer(without_idle_cases(sketch), mesh).write();
  return Writer(sketch, mesh).write();
}

} // namespace sketch
