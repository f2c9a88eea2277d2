// Statements that say what is between bodies, what acts on them, and in which order.
#include "program/sketch/read/reader.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

int Reader::body_named(const Word& word) const {
  for (size_t b = 0; b < s_.bodies.size(); ++b)
    if (s_.bodies[b].name == word.text) return static_cast<int>(b);
  if (is_lost_ || std::any_of(s_.bodies.begin(), s_.bodies.end(), [](const Body& b) { return b.name.empty(); })) throw Fault{};
  throw Fault{word.at, "no body is called " + in_quotes(word.text)};
}

// body.curve, body.curve+curve: every curve that bears one of the names. Where `part` may be told: body.curve.start as well.
Side Reader::side(Statement& s, Condition::Part* part) {
  const Word word = s.take("curves of a body, such as pad.tip or pad.tip+flank");
  const size_t dot = word.text.find('.');
  if (dot == std::string::npos || word.quoted)
    throw Fault{word.at, in_quotes(word.text) + ": expected a body, a point and its curves, such as pad.tip"};
  Side out;
  out.at = word.at;
  out.body = body_named({word.text.substr(0, dot), word.at, false});
  const size_t second = word.text.find('.', dot + 1), names_end = std::min(second, word.text.size());
  for (size_t at = dot + 1, end; at <= names_end; at = end + 1) {
    end = std::min(word.text.find('+', at), names_end);
    const std::string name = word.text.substr(at, end - at);
    if (out.has(name)) throw Fault{word.at, in_quotes(name) + " stands there twice"};
    out.names.push_back(name);
    if (curves_named(out.body, name) == 0 && broken_bodies_.count(out.body) == 0)
      throw Fault{word.at, "body " + in_quotes(s_.bodies[static_cast<size_t>(out.body)].name) + " has no curve " +
                               in_quotes(name) + ", expected " + names_of(out.body)};
  }
  if (second == std::string::npos) return out;
  const std::string end = word.text.substr(second + 1);
  if (part == nullptr)
    throw Fault{word.at, in_quotes(word.text) + ": expected a body, a point and its curves, such as pad.tip"};
  if (end != "start" && end != "end")
    throw Fault{word.at, in_quotes(word.text) + ": expected start or end behind the curve, such as pad.tip.start"};
  if (out.names.size() > 1 || curves_named(out.body, out.names[0]) > 1)
    throw Fault{word.at, in_quotes(word.text) + ": there are several of these curves, expected one that has the name alone"};
  *part = end == "start" ? Condition::kStart : Condition::kEnd;
  return out;
}

int Reader::curves_named(int body, const std::string& name) const {
  int count = 0;
  for (const Outline& outline : s_.bodies[static_cast<size_t>(body)].outlines)
    for (const Curve& curve : outline.curves) count += !name.empty() && curve.name == name ? 1 : 0;
  return count;
}

// The names of a body's curves, as many as can be told.
std::string Reader::names_of(int body) const {
  std::vector<std::string> names;
  for (const Outline& outline : s_.bodies[static_cast<size_t>(body)].outlines)
    for (const Curve& curve : outline.curves)
      if (!curve.name.empty() && std::find(names.begin(), names.end(), curve.name) == names.end()) names.push_back(curve.name);
  if (names.empty()) return "names behind the words line, arc, ... that draw it";
  std::string out;
  for (size_t i = 0; i < names.size() && i < 8; ++i)
    out += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + in_quotes(names[i]);
  return out + (names.size() > 8 ? ", ..." : "");
}

void Reader::interface(Statement& s, bool tied) {
  end_body();
  Interface out;
  out.tied = tied;
  out.at = s.at();
  out.side[0] = side(s);
  out.side[1] = side(s);
  while (s.has_more()) {
    const size_t kind = tied ? s.choice({"name"}) + 1 : s.choice({"mu", "name"});
    if (kind == 1) {
      out.name = s.take("the name of the interface").text;
      if (out.name.size() > kLongestName)
        s.fail(in_quotes(out.name) + ": expected at most " + std::to_string(kLongestName) + " bytes");
      if (out.name.find('!') != std::string::npos) s.fail(in_quotes(out.name) + ": expected a name without '!'");
      if (!is_one_line(out.name)) s.fail("the name of the interface is not text in UTF-8, or has control characters");
      if (out.name.empty() || out.name[0] == ' ' || out.name[0] == ',')
        s.fail(in_quotes(out.name) + ": expected a name that begins with neither a blank nor a comma");
    } else {
      out.friction = s.number("the coefficient of friction", true);
      if (out.friction < 0) s.fail(show(out.friction) + ": expected a coefficient of friction, 0 or above");
    }
  }
  s_.interfaces.push_back(out);
}

// Statements behind it belong to the load case.
void Reader::load_case(Statement& s) {
  end_body();
  const std::string name = s.name("the name of a load case");
  for (size_t c = 0; c < s_.cases.size(); ++c)
    if (s_.cases[c].name == name) {
      case_ = static_cast<int>(c);
      return;
    }
  const auto loads = [](const Condition& c) { return c.value[0].value_or(0) != 0 || c.value[1].value_or(0) != 0; };
  const bool first_is_unused = s_.cases.size() == 1 && s_.cases[0].name.empty() && s_.point_loads.empty() &&
                               s_.body_forces.empty() && s_.drives.empty() &&
                               std::none_of(s_.conditions.begin(), s_.conditions.end(), loads); // supports hold in all cases
  if (!first_is_unused) s_.cases.push_back({});
  case_ = static_cast<int>(s_.cases.size()) - 1;
  s_.cases.back().name = name;
  s_.cases.back().factors.assign(static_cast<size_t>(s_.pieces), 0); // of one behind the history
}

// Of forces and loads fx and fy; x and y are older words for them.
size_t Reader::force_axis(Statement& s, const std::optional<double> value[2]) {
  const size_t axis = s.is_next("x") || s.is_next("y") ? s.choice({"x", "y"}) : s.choice({"fx", "fy"});
  if (value[axis]) s.fail(std::string(axis == 0 ? "fx" : "fy") + " is given twice");
  return axis;
}

Point Reader::force_vector(Statement& s) {
  std::optional<double> value[2];
  do {
    const size_t axis = force_axis(s, value);
    value[axis] = s.number("its value");
  } while (s.has_more());
  return {value[0].value_or(0), value[1].value_or(0)};
}

void Reader::components(Statement& s, Condition& c) {
  do {
    const size_t axis = s.choice({"x", "y"});
    if (c.value[axis]) s.fail(std::string(axis == 0 ? "x" : "y") + " is given twice");
    field(s, c, axis, "its value");
  } while (s.has_more());
}

void Reader::fix(Statement& s) {
  end_body();
  Condition c;
  c.at = s.at(), c.load_case = case_, c.side = side(s, &c.part);
  if (!s.has_more()) c.value[0] = c.value[1] = 0;
  while (s.has_more()) {
    c.value[s.choice({"x", "y"})] = 0;
    if (s.is_next("x") || s.is_next("y")) continue; // a parameter may be called so
    if (double value = 0; s.accept_number(value) && value != 0) s.fail(show(value) + ": expected 0, or move instead of fix");
  }
  s_.conditions.push_back(c);
}

// Components along curves: of a displacement, which a point of them may have, or of a traction.
void Reader::given(Statement& s, Condition::Kind kind) {
  end_body();
  Condition c;
  c.at = s.at(), c.load_case = case_, c.kind = kind;
  c.side = side(s, kind == Condition::kDisplacement ? &c.part : nullptr);
  if (kind == Condition::kDisplacement) components(s, c);
  while (kind == Condition::kTraction && (s.has_more() || (!c.value[0] && !c.value[1]))) {
    field(s, c, force_axis(s, c.value), "its value");
  }
  s_.conditions.push_back(c);
}

// A load that may be a formula of the place.
void Reader::field(Statement& s, Condition& c, size_t axis, const std::string& what) {
  const Expression load = s.field(what);
  c.value[axis] = load.varies() ? NAN : load.value();
  if (load.varies()) c.field[axis] = load;
}

void Reader::pressure(Statement& s) {
  end_body();
  Condition c;
  c.at = s.at(), c.load_case = case_, c.kind = Condition::kPressure, c.side = side(s);
  field(s, c, 0, "the pressure");
  s_.conditions.push_back(c);
}

void Reader::force(Statement& s) {
  end_body();
  PointLoad p;
  p.at = s.at(), p.load_case = case_;
  p.body = body_named(s.take("the name of a body"));
  if (!s.accept("at")) s.missing("at x y, and fx and fy");
  p.where = s.point("where it acts");
  p.force = force_vector(s);
  s_.point_loads.push_back(p);
}

// Weight and rotation of one body in one case are one force.
BodyForce& Reader::body_force(Statement& s) {
  end_body();
  const int body = body_named(s.take("the name of a body"));
  for (BodyForce& f : s_.body_forces)
    if (f.body == body && f.load_case == case_) return f;
  s_.body_forces.push_back({});
  s_.body_forces.back().body = body, s_.body_forces.back().load_case = case_, s_.body_forces.back().at = s.at();
  return s_.body_forces.back();
}

void Reader::weight(Statement& s) {
  BodyForce& f = body_force(s);
  if (f.weight.x != 0 || f.weight.y != 0) s.fail("the body has a weight in this load case already");
  f.weight = force_vector(s);
}

void Reader::spin(Statement& s) {
  BodyForce& f = body_force(s);
  if (f.rho_omega2 != 0) s.fail("the body turns in this load case already");
  f.rho_omega2 = s.positive("density times the square of the angular velocity");
  if (s.accept("about")) f.centre = s.point("the axis");
}

// Of x, y and turn each has a motion that is given, or it is free and has a load, 0 if none is told.
void Reader::drive_of(Statement& s, Drive d) {
  const char* const words[3] = {"x", "y", "turn"};
  d.at = s.at(), d.load_case = case_;
  const Drive* before = nullptr; // the same one, in another load case
  for (const Drive& other : s_.drives) {
    if (!same_target(d, other)) continue;
    before = &other;
    if (other.load_case == case_) s.fail("this moves in this load case already, by line " + std::to_string(other.at.line));
  }
  if (before != nullptr) d.about = before->about;
  if (s.accept("about")) {
    d.about = s.point("the point that the motion and the moment belong to");
    if (before != nullptr && length(d.about - before->about) != 0)
      s.fail("another point than that of line " + std::to_string(before->at.line) + ", expected one for all load cases");
  }
  const auto set = [&s](std::optional<double>& to, const std::string& what) {
    if (to) s.fail(what + " is given twice");
    to = s.number(what);
  };
  while (s.has_more()) {
    const size_t kind = s.choice({"x", "y", "turn", "force", "fx", "fy", "moment"});
    if (kind < 3) set(d.motion[kind], kind < 2 ? "how far it moves" : "how far it turns, in radians");
    if (kind == 3 || kind == 4) set(d.load[0], "the force along x");
    if (kind == 3 || kind == 5) set(d.load[1], "the force along y");
    if (kind == 6) set(d.load[2], "the moment");
  }
  for (size_t i = 0; i < 3; ++i) {
    if (d.motion[i] && d.load[i]) s.fail("a motion and its load are both given, expected one of them");
    for (const Drive& other : s_.drives)
      if (same_target(d, other) && ((d.motion[i] && other.load[i]) || (d.load[i] && other.motion[i])))
        s.fail(std::string("of ") + words[i] + " the " + (d.load[i] ? "motion" : "load") + " is given in line " +
               std::to_string(other.at.line) + ", expected " + (d.load[i] ? "motions" : "loads") + " in all load cases");
  }
  s_.drives.push_back(d);
}

void Reader::platen(Statement& s) {
  end_body();
  Drive d;
  d.side = side(s);
  d.body = d.side->body;
  if (s_.bodies[static_cast<size_t>(d.body)].rigid)
    s.fail("body " + in_quotes(s_.bodies[static_cast<size_t>(d.body)].name) + " is rigid, expected drive and its name");
  drive_of(s, d);
}

void Reader::drive(Statement& s) {
  end_body();
  Drive d;
  d.body = body_named(s.take("the name of a rigid body"));
  if (!s_.bodies[static_cast<size_t>(d.body)].rigid)
    s.fail("body " + in_quotes(s_.bodies[static_cast<size_t>(d.body)].name) + " is not rigid, expected platen and its curves");
  drive_of(s, d);
}

std::string Reader::names_of_cases() const {
  std::string out;
  for (const LoadCase& c : s_.cases)
    if (!c.name.empty()) out += (out.empty() ? ", expected " : " or ") + in_quotes(c.name);
  return out;
}

// normal 1; shear 1, -1, 1: one case after the other goes to the factors told, the others stay. A second statement goes on.
void Reader::history(Statement& s) {
  end_body();
  std::vector<double> now;
  for (const LoadCase& c : s_.cases) now.push_back(c.factors.empty() ? 0 : c.factors.back());
  do {
    const Word word = s.take("the name of a load case");
    const auto found = std::find_if(s_.cases.begin(), s_.cases.end(),
                                    [&](const LoadCase& c) { return !word.text.empty() && c.name == word.text; });
    if (found == s_.cases.end()) throw Fault{word.at, "no load case is called " + in_quotes(word.text) + names_of_cases()};
    double factor = s.number("a load factor");
    do {
      now[static_cast<size_t>(found - s_.cases.begin())] = factor;
      for (size_t c = 0; c < now.size(); ++c) s_.cases[c].factors.push_back(now[c]);
      ++s_.pieces;
    } while (s.accept_number(factor));
  } while (s.accept(";") && s.has_more());
}

// Bodies that overlap as drawn are pressed into each other before the history begins.
void Reader::interference(Statement& s) {
  end_body();
  if (s_.interference) s.fail("interference is there already");
  s_.interference = true;
}

} // namespace sketch
