#include "program/sketch/deck/actions.hpp"

#include "program/sketch/deck/cycle.hpp"
#include "program/sketch/shapes/region.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

const char* const kAlong[2] = {"x", "y"};

std::string line_of(Place at) { return "line " + std::to_string(at.line); }

bool is_zero(Point p) { return p.x == 0 && p.y == 0; }

// The first common curve of two sides; empty: none.
std::string shared(const Side& a, const Side& b) {
  for (const std::string& name : a.names)
    if (a.body == b.body && b.has(name)) return name;
  return "";
}

class ActionCheck {
public:
  explicit ActionCheck(const Sketch& sketch) : s_(sketch) {}
  std::vector<Fault> run();

private:
  void fault(Place at, const std::string& text) { faults_.push_back({at, text}); }
  const Body& body(int b) const { return s_.bodies[static_cast<size_t>(b)]; }
  std::string curve(int b, const std::string& name) const { return body(b).name + "." + name; }
  bool takes_pressure(const Condition& c, size_t fixed_axis) const;
  void check_pair(const Condition& a, const Condition& b);
  void check_joints(int b, const Outline& outline);
  void check_rigid();
  void check_interface(size_t index);
  void check_platen(const Drive& platen, size_t before);
  void check_case(size_t load_case);
  void check_field(const Condition& c, size_t axis);
  void check_place(int b, Point p, Place at, const std::string& what);
  void check_across(const PointLoad& p);
  void check_wants();
  void check_supports();
  void mark_supported(int b, std::vector<bool>& supported) const;

  const Sketch& s_;
  std::vector<Fault> faults_;
};

// Does a pressure have a component in the free direction, anywhere on its curves? The displacement along `fixed_axis` is given.
bool ActionCheck::takes_pressure(const Condition& c, size_t fixed_axis) const {
  for (const Outline& outline : body(c.side.body).outlines)
    for (const Curve& curve : outline.curves)
      for (int i = 0; i <= 8 && c.side.has(curve.name); ++i) {
        const Point normal = turned_left(curve.shape->tangent(i / 8.0));
        if (std::fabs(fixed_axis == 0 ? normal.y : normal.x) > 1e-9) return true;
      }
  return false;
}

// Errors for two displacements in the same direction, or for a displacement and a traction, of which one must be unknown.
void ActionCheck::check_pair(const Condition& a, const Condition& b) {
  const std::string name = shared(a.side, b.side);
  if (name.empty()) return;
  const Condition &u = a.kind == Condition::kDisplacement ? a : b, &t = a.kind == Condition::kDisplacement ? b : a;
  if (u.kind != Condition::kDisplacement) return;                                         // tractions add
  if (a.part != b.part && a.part != Condition::kAll && b.part != Condition::kAll) return; // start and end
  if (t.kind != Condition::kDisplacement && u.part != Condition::kAll) return;            // a point of a loaded curve
  if (t.kind == Condition::kPressure) {
    const size_t fixed_axis = u.value[0] ? 0 : 1;
    if ((u.value[0] && u.value[1]) || !takes_pressure(t, fixed_axis))
      fault(b.at, curve(a.side.body, name) + " has " + (&u == &a ? "a displacement" : "a pressure") + " in " + line_of(a.at) +
                      ", expected a displacement or a pressure, not both");
    return;
  }
  for (size_t i = 0; i < 2; ++i) {
    if (!u.value[i] || !t.value[i]) continue;
    const bool both = t.kind == Condition::kDisplacement;
    if (both && (a.load_case != b.load_case || (*u.value[i] == 0 && *t.value[i] == 0))) continue;
    return fault(b.at, curve(a.side.body, name) + " has a " + (&u == &a ? "displacement" : "traction") + " along " + kAlong[i] +
                           " in " + line_of(a.at) +
                           (both ? ", expected only one" : ", expected a displacement or a traction, not both"));
  }
}

// The displacement given at the first or the last point of a curve.
struct AtEnd {
  bool known = false;
  double value = 0;
  Place at; // of the last statement that gives it
};
AtEnd given_at_end(const Sketch& s, int b, const Curve& curve, bool last, size_t axis, size_t load_case) {
  AtEnd out;
  for (const Condition& c : s.conditions) {
    if (c.kind != Condition::kDisplacement || c.side.body != b || !c.side.has(curve.name) || !c.value[axis]) continue;
    if (c.part == (last ? Condition::kStart : Condition::kEnd)) continue;
    out.known = true;
    if (c.load_case == static_cast<int>(load_case)) out.value += *c.value[axis], out.at = c.at;
    if (out.at.line == 0) out.at = c.at;
  }
  return out;
}

// At the joint of two curves, both must prescribe the same displacement.
void ActionCheck::check_joints(int b, const Outline& outline) {
  const size_t n = outline.curves.size();
  for (size_t i = 0; i < n - (outline.open ? 1 : 0); ++i)
    for (size_t axis = 0; axis < 2; ++axis)
      for (size_t c = 0; c < s_.cases.size(); ++c) {
        const Curve &one = outline.curves[i], &next = outline.curves[(i + 1) % n];
        const AtEnd p = given_at_end(s_, b, one, true, axis, c), q = given_at_end(s_, b, next, false, axis, c);
        if (!p.known || !q.known || p.value == q.value) continue;
        return fault(p.at.line > q.at.line ? p.at : q.at,
                     curve(b, one.name) + " and " + curve(b, next.name) + " meet, but have the displacements " + show(p.value) +
                         " and " + show(q.value) + " along " + kAlong[axis] + ", expected equal values");
      }
}

// Only contact and its statement `drive` may act on a rigid body.
void ActionCheck::check_rigid() {
  const auto check = [&](int b, Place at, const std::string& text) {
    if (body(b).rigid) fault(at, "body " + in_quotes(body(b).name) + " is rigid: " + text);
  };
  const char* const moves = "expected 'drive' for its motion and loads; without 'drive' it does not move";
  for (const Condition& c : s_.conditions) check(c.side.body, c.at, moves);
  for (const PointLoad& p : s_.point_loads) check(p.body, p.at, moves);
  for (const BodyForce& f : s_.body_forces) check(f.body, f.at, moves);
  for (const Want& w : s_.wants)
    if (w.of == WantOf::kPair)
      for (const int b : {w.body, w.other})
        check(b, w.at, "its motion is one of the contact numbers, expected an elastic body");
    else if (w.of != WantOf::kContact && (w.of != WantOf::kTorsion || w.side))
      check(w.body, w.at, "it has no stresses, expected an elastic body");
}

void ActionCheck::check_interface(size_t index) {
  const Interface& i = s_.interfaces[index];
  for (size_t k = 0; k < index; ++k)
    for (size_t side = 0; side < 2; ++side) {
      const Side &one = s_.interfaces[k].side[side], &two = s_.interfaces[k].side[1 - side];
      const std::string first = shared(i.side[0], one), second = shared(i.side[1], two);
      if (!first.empty() && !second.empty())
        return fault(i.at, curve(one.body, first) + " and " + curve(two.body, second) +
                               " are already the sides of the interface in " + line_of(s_.interfaces[k].at));
    }
  if (const std::string name = shared(i.side[0], i.side[1]); !name.empty())
    fault(i.at, curve(i.side[0].body, name) + " is on both sides, expected different curves");
  else if (body(i.side[0].body).rigid && body(i.side[1].body).rigid)
    fault(i.at, "both bodies are rigid, expected at least one elastic body");
}

// The curves of a platen have no contact and no other condition.
void ActionCheck::check_platen(const Drive& platen, size_t before) {
  const auto check = [&](const Side& other, Place at, const char* what) {
    const std::string name = shared(*platen.side, other);
    if (name.empty()) return false;
    fault(platen.at,
          curve(platen.body, name) + " is " + what + " in " + line_of(at) + ", expected curves without another condition");
    return true;
  };
  for (const Interface& i : s_.interfaces)
    for (const Side& side : i.side)
      if (check(side, i.at, "on a side of an interface")) return;
  for (const Condition& c : s_.conditions)
    if (check(c.side, c.at, "given a displacement or a load")) return;
  for (size_t k = 0; k < before; ++k)
    if (s_.drives[k].side && !same_target(platen, s_.drives[k]) && check(*s_.drives[k].side, s_.drives[k].at, "on a platen"))
      return;
}

// Error for a load case with loads but without a factor in the history.
void ActionCheck::check_case(size_t load_case) {
  const LoadCase& one = s_.cases[load_case];
  const bool acts =
      s_.pieces == 0 ? load_case == 0 : std::any_of(one.factors.begin(), one.factors.end(), [](double f) { return f != 0; });
  if (acts) return;
  Place at; // of its first load
  const auto load = [&](int of, Place place, bool any) {
    if (of == static_cast<int>(load_case) && any && (at.line == 0 || place.line < at.line)) at = place;
  };
  for (const Condition& c : s_.conditions) load(c.load_case, c.at, c.value[0].value_or(0) != 0 || c.value[1].value_or(0) != 0);
  for (const PointLoad& p : s_.point_loads) load(p.load_case, p.at, !is_zero(p.force));
  for (const BodyForce& f : s_.body_forces) load(f.load_case, f.at, !is_zero(f.weight) || f.rho_omega2 != 0);
  for (const Drive& d : s_.drives)
    for (size_t i = 0; i < 3; ++i) load(d.load_case, d.at, d.motion[i].value_or(0) != 0 || d.load[i].value_or(0) != 0);
  if (at.line == 0) return;
  if (one.name.empty())
    fault(at, "this load stands before the first load case, so no history can apply it, expected a statement 'case' before it");
  else
    fault(at, "load case " + in_quotes(one.name) + " is never applied, expected a statement 'history' that gives it a factor");
}

// Error for a formula without a finite value at some place of its curves.
void ActionCheck::check_field(const Condition& c, size_t axis) {
  for (const Outline& outline : body(c.side.body).outlines)
    for (const Curve& curve : outline.curves)
      for (int i = 0; i <= 64 && c.side.has(curve.name); ++i) {
        const Point p = curve.shape->at(i / 64.0);
        if (std::isfinite(c.field[axis]->at(p.x, p.y))) continue;
        return fault(c.at, "the formula has no finite value at (" + rounded(p.x) + ", " + rounded(p.y) + ") of " +
                               this->curve(c.side.body, curve.name));
      }
}

// A point must lie inside the material, not on the boundary.
void ActionCheck::check_place(int b, Point p, Place at, const std::string& what) {
  const Region region(s_, body(b));
  const double depth = region.depth(p);
  if (depth <= kJoint * region.size())
    fault(at, what + " (" + show(p.x) + ", " + show(p.y) + ") is not inside body " + in_quotes(body(b).name) + ": " +
                  (depth < 0 ? rounded(-depth) + " outside it" : "on its boundary"));
}

void ActionCheck::check_wants() {
  for (const Want& w : s_.wants) {
    if (w.of == WantOf::kContact && want_row(w.word).needs_interface && s_.interfaces.empty())
      fault(w.at, "the sketch has no contact, expected a statement 'contact' or 'tie'");
    if (w.of == WantOf::kFatigue && (w.fatigue.kind == FatigueKind::kRuiz1 || w.fatigue.kind == FatigueKind::kRuiz2) &&
        s_.interfaces.empty())
      fault(w.at, "the sketch has no contact, expected a statement 'contact' or 'tie'");
    if (w.word == "walk" && !s_.cycle)
      fault(w.at, "a walk is that of a steady cycle, expected a statement such as 'cycle shear 1, -1, 1 until steady'");
    if ((w.cycle || w.of == WantOf::kFatigue || w.word == "loss") && cycle_start(s_) == 0)
      fault(w.at,
            "the load history has no cycle, expected a history that returns to the load factors of an earlier piece after "
            "other factors");
  }
  for (const WantedPoint& p : s_.points) check_place(p.body, p.at, p.place, "the point");
  for (const WantedPoint& p : s_.fatigue_points) check_place(p.body, p.at, p.place, "the point");
  for (const PointLoad& p : s_.point_loads) {
    check_place(p.body, p.where, p.at, "the force at");
    check_across(p);
  }
}

// On a line of symmetry a force coincides with its image: what acts across the line would cancel.
void ActionCheck::check_across(const PointLoad& p) {
  const double at[2] = {p.where.x, p.where.y}, force[2] = {p.force.x, p.force.y};
  for (int axis = 0; axis < 2; ++axis)
    if (s_.symmetry[axis] && at[axis] == *s_.symmetry[axis] && force[axis] != 0.0)
      fault(p.at, "the force at (" + show(p.where.x) + ", " + show(p.where.y) + ") acts across the " +
                      (axis == 0 && s_.axisymmetric ? "axis" : "line of symmetry") + " " + (axis == 0 ? "x" : "y") + " = " +
                      show(at[axis]) + ", expected one along it");
}

// Marks a body and all bodies connected to it by interfaces.
void ActionCheck::mark_supported(int b, std::vector<bool>& supported) const {
  if (supported[static_cast<size_t>(b)]) return;
  supported[static_cast<size_t>(b)] = true;
  for (const Interface& i : s_.interfaces)
    for (int side = 0; side < 2; ++side)
      if (i.side[side].body == b) mark_supported(i.side[1 - side].body, supported);
}

// Errors for unsupported bodies: neither they nor bodies connected to them have a support, a prescribed motion, or a line of
// symmetry. Whether the supports suffice in every direction is reported when the sketch is run.
void ActionCheck::check_supports() {
  if (s_.interfaces.empty() && s_.conditions.empty() && s_.drives.empty() && s_.point_loads.empty() && s_.body_forces.empty())
    return; // shapes only
  std::vector<bool> supported(s_.bodies.size(), false);
  for (const Condition& c : s_.conditions)
    if (c.kind == Condition::kDisplacement) mark_supported(c.side.body, supported);
  for (const Drive& d : s_.drives)
    if (d.motion[0] || d.motion[1]) mark_supported(d.body, supported);
  for (size_t b = 0; b < s_.bodies.size(); ++b) {
    const Body& one = s_.bodies[b];
    const bool is_driven = std::any_of(s_.drives.begin(), s_.drives.end(),
                                       [&](const Drive& d) { return !d.side && d.body == static_cast<int>(b); });
    const bool is_on_line = std::any_of(one.outlines.begin(), one.outlines.end(), [](const Outline& o) { return o.open; });
    if ((one.rigid && !is_driven) || is_on_line) mark_supported(static_cast<int>(b), supported);
  }
  for (size_t b = 0; b < s_.bodies.size(); ++b)
    if (!supported[b])
      fault(
          s_.bodies[b].at,
          "body " + in_quotes(s_.bodies[b].name) +
              " has no support, expected fix, move or platen on one of its curves, or contact or a tie with a supported body");
}

std::vector<Fault> ActionCheck::run() {
  check_rigid();
  for (size_t j = 0; j < s_.conditions.size(); ++j)
    for (size_t i = 0; i < j; ++i) check_pair(s_.conditions[i], s_.conditions[j]);
  for (size_t b = 0; b < s_.bodies.size() && faults_.empty(); ++b)
    for (const Outline& outline : s_.bodies[b].outlines) check_joints(static_cast<int>(b), outline);
  for (size_t i = 0; i < s_.interfaces.size(); ++i) check_interface(i);
  for (size_t i = 0; i < s_.drives.size(); ++i)
    if (s_.drives[i].side) check_platen(s_.drives[i], i);
  for (size_t c = 0; c < s_.cases.size(); ++c) check_case(c);
  for (const Condition& c : s_.conditions)
    for (size_t axis = 0; axis < 2; ++axis)
      if (c.field[axis]) check_field(c, axis);
  check_wants();
  check_supports();
  return faults_;
}

} // namespace

std::vector<Fault> faults_of_actions(const Sketch& sketch) { return ActionCheck(sketch).run(); }

} // namespace sketch
