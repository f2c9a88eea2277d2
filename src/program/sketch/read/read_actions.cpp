// Statements of contacts and ties, supports and loads, and the load history.
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

// body.curve or body.curve+curve: all curves with one of these names. If `part` is not null, also body.curve.start and .end.
Side Reader::side(Statement& s, Condition::Part* part) {
  const Word word = s.take("curves of a body, such as pad.tip or pad.tip+flank");
  const size_t dot = word.text.find('.');
  if (dot == std::string::npos || word.quoted)
    throw Fault{word.at, in_quotes(word.text) + ": expected a body, a dot and curves of the body, such as pad.tip"};
  Side out;
  out.at = word.at;
  out.body = body_named({word.text.substr(0, dot), word.at, false});
  const size_t second = word.text.find('.', dot + 1), names_end = std::min(second, word.text.size());
  for (size_t at = dot + 1, end; at <= names_end; at = end + 1) {
    end = std::min(word.text.find('+', at), names_end);
    const std::string name = word.text.substr(at, end - at);
    if (out.has(name)) throw Fault{word.at, in_quotes(name) + " is named twice, expected each curve once"};
    out.names.push_back(name);
    if (curves_named(out.body, name) == 0 && broken_bodies_.count(out.body) == 0)
      throw Fault{word.at, "body " + in_quotes(s_.bodies[static_cast<size_t>(out.body)].name) + " has no curve " +
                               in_quotes(name) + ", expected " + names_of(out.body)};
  }
  if (second == std::string::npos) return out;
  const std::string end = word.text.substr(second + 1);
  if (part == nullptr)
    throw Fault{word.at, in_quotes(word.text) + ": expected a body, a dot and curves of the body, such as pad.tip"};
  if (end != "start" && end != "end")
    throw Fault{word.at, in_quotes(word.text) + ": expected start or end after the curve, such as pad.tip.start"};
  if (out.names.size() > 1 || curves_named(out.body, out.names[0]) > 1)
    throw Fault{word.at, in_quotes(word.text) + ": several curves are named, expected a single one"};
  *part = end == "start" ? Condition::kStart : Condition::kEnd;
  return out;
}

int Reader::curves_named(int body, const std::string& name) const {
  int count = 0;
  for (const Outline& outline : s_.bodies[static_cast<size_t>(body)].outlines)
    for (const Curve& curve : outline.curves) count += !name.empty() && curve.name == name ? 1 : 0;
  return count;
}

// The names of the curves of a body, for an error message.
std::string Reader::names_of(int body) const {
  std::vector<std::string> names;
  for (const Outline& outline : s_.bodies[static_cast<size_t>(body)].outlines)
    for (const Curve& curve : outline.curves)
      if (!curve.name.empty() && std::find(names.begin(), names.end(), curve.name) == names.end()) names.push_back(curve.name);
  if (names.empty()) return "curves with names, such as 'line top'";
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
    const size_t kind = tied ? s.choice({"name"}) + 1
                             : s.choice(s_.axisymmetric || s.is_next("turn") ? std::vector<const char*>{"mu", "name", "turn"}
                                                                             : std::vector<const char*>{"mu", "name"});
    if (kind == 2) {
      out.friction_round = s.number("the coefficient of friction round the axis", true);
      if (!s_.axisymmetric) s.fail("only bodies of revolution turn round an axis, expected 'axisymmetric' before the bodies");
      if (*out.friction_round < 0) s.fail(show(*out.friction_round) + ": expected a coefficient of friction, 0 or above");
    } else if (kind == 1) {
      out.name = s.take("the name of the interface").text;
      if (out.name.size() > kLongestName)
        s.fail(in_quotes(out.name) + ": expected at most " + std::to_string(kLongestName) + " bytes");
      if (out.name.find('!') != std::string::npos) s.fail(in_quotes(out.name) + ": expected a name without '!'");
      if (!is_one_line(out.name))
        s.fail("the name of the interface is not text in UTF-8 or has control characters, expected printable text");
      if (out.name.empty() || out.name[0] == ' ' || out.name[0] == ',')
        s.fail(in_quotes(out.name) + ": expected a name without a blank or a comma at its start");
    } else {
      out.friction = s.number("the coefficient of friction", true);
      if (out.friction < 0) s.fail(show(out.friction) + ": expected a coefficient of friction, 0 or above");
    }
  }
  s_.interfaces.push_back(out);
}

// Later statements belong to this load case.
void Reader::load_case(Statement& s) {
  end_body();
  const std::string name = s.name("the name of a load case");
  for (size_t c = 0; c < s_.cases.size(); ++c)
    if (s_.cases[c].name == name) {
      if (s.has_more() && s_.cases[c].course) s.missing("no more words: " + in_quotes(name) + " has a course");
      case_ = static_cast<int>(c);
      return;
    }
  const auto loads = [](const Condition& c) { return c.value[0].value_or(0) != 0 || c.value[1].value_or(0) != 0; };
  const bool first_is_unused = s_.cases.size() == 1 && s_.cases[0].name.empty() && s_.point_loads.empty() &&
                               s_.body_forces.empty() && s_.drives.empty() &&
                               std::none_of(s_.conditions.begin(), s_.conditions.end(), loads); // supports apply in all cases
  if (!first_is_unused) s_.cases.push_back({});
  case_ = static_cast<int>(s_.cases.size()) - 1;
  s_.cases.back().name = name;
  s_.cases.back().factors.assign(static_cast<size_t>(s_.pieces), 0); // of a case after a history
  s_.cases.back().places = s_.cases.back().factors;
  if (s.has_more()) course(s, s_.cases.back());
}

// fx or fy of a force or load; x and y are older names.
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

// Directions of a displacement; `turn` is offered for bodies of revolution alone, and read in others for its own message.
std::vector<const char*> Reader::axes_of(const Statement& s) const {
  if (s_.axisymmetric || s.is_next("turn")) return {"x", "y", "turn"};
  return {"x", "y"};
}

// The value after the word `turn`: radians, or of a traction a formula too.
void Reader::turn(Statement& s, const std::optional<Side>& side, int body, bool is_traction, int load_case) {
  if (!s_.axisymmetric) s.fail("only bodies of revolution turn round an axis, expected 'axisymmetric' before the bodies");
  Turn t;
  t.side = side, t.body = body, t.is_traction = is_traction, t.load_case = load_case, t.at = s.at();
  if (is_traction) {
    const Expression value = s.field("the shear traction round the axis");
    t.value = value.varies() ? NAN : value.value();
    if (value.varies()) t.field = value;
  } else if (load_case >= 0) {
    t.value = s.number("the angle of rotation in radians");
  }
  s_.torsion.turns.push_back(t);
}

// Of a rotation round the axis the component alone: false, and nothing is left of the condition.
bool Reader::components(Statement& s, Condition& c) {
  if (s.accept("turn")) {
    if (c.part != Condition::kAll) s.fail("a point is turned, expected curves");
    turn(s, c.side, c.side.body, false, case_);
    if (s.has_more()) s.missing("nothing after the angle, x and y in a statement of their own");
    return false;
  }
  do {
    const size_t axis = s.choice(axes_of(s));
    if (axis == 2) s.fail("'turn' stands behind x or y, expected a statement 'move' of its own");
    if (c.value[axis]) s.fail(std::string(axis == 0 ? "x" : "y") + " is given twice");
    field(s, c, axis, "its value");
  } while (s.has_more());
  return true;
}

void Reader::fix(Statement& s) {
  end_body();
  Condition c;
  c.at = s.at(), c.load_case = case_, c.side = side(s, &c.part);
  if (!s.has_more()) {
    c.value[0] = c.value[1] = 0;
    if (s_.axisymmetric && c.part == Condition::kAll) turn(s, c.side, c.side.body, false, -1);
  }
  while (s.has_more()) {
    const size_t axis = s.choice(axes_of(s));
    if (axis == 2 && c.part != Condition::kAll) s.fail("a point is kept from turning, expected curves");
    if (axis == 2)
      turn(s, c.side, c.side.body, false, -1);
    else
      c.value[axis] = 0;
    if (s.is_next("x") || s.is_next("y") || s.is_next("turn")) continue; // a parameter may have this name
    if (double value = 0; s.accept_number(value) && value != 0)
      s.fail(show(value) + ": expected 0, or the statement 'move' for another value");
  }
  if (c.value[0] || c.value[1]) s_.conditions.push_back(c);
}

// Components of a displacement (also at an end of a curve) or of a traction.
void Reader::given(Statement& s, Condition::Kind kind) {
  end_body();
  Condition c;
  c.at = s.at(), c.load_case = case_, c.kind = kind;
  c.side = side(s, kind == Condition::kDisplacement ? &c.part : nullptr);
  if (kind == Condition::kDisplacement && !components(s, c)) return;
  if (kind == Condition::kTraction && s.accept("turn")) {
    turn(s, c.side, c.side.body, true, case_);
    if (s.has_more()) s.missing("nothing after the traction, fx and fy in a statement of their own");
    return;
  }
  while (kind == Condition::kTraction && (s.has_more() || (!c.value[0] && !c.value[1]))) {
    field(s, c, force_axis(s, c.value), "its value");
  }
  const bool turns = kind == Condition::kTraction && s_.cases[static_cast<size_t>(case_)].course;
  for (size_t i = 0; i < 2 && turns; ++i) c.value[i] = c.value[i].value_or(0);
  s_.conditions.push_back(c);
}

// A value that may be a formula of the place.
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
  if (!s.accept("at")) s.missing("at x y, then fx and fy");
  p.where = s.point("where it acts");
  p.force = force_vector(s);
  s_.point_loads.push_back(p);
}

// Weight and rotation of a body in a load case share one BodyForce.
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
  if (f.weight.x != 0 || f.weight.y != 0) s.fail("the weight of the body in this load case is given twice");
  f.weight = force_vector(s);
  if (s_.axisymmetric && f.weight.x != 0) s.fail("a weight along x on a body of revolution, expected one along its axis, fy");
}

void Reader::spin(Statement& s) {
  BodyForce& f = body_force(s);
  if (f.rho_omega2 != 0) s.fail("the rotation of the body in this load case is given twice");
  f.rho_omega2 = s.positive("density times the square of the angular velocity");
  if (s.accept("about")) f.centre = s.point("the axis");
  if (s_.axisymmetric && f.centre.x != 0) s.fail("a body of revolution turns about x = 0, expected an axis there");
}

// For each of x, y and turn, the motion is given, or it is free with a load (default: 0). Round an axis only y is possible.
void Reader::drive_of(Statement& s, Drive d) {
  const char* const words[3] = {"x", "y", "turn"};
  d.at = s.at(), d.load_case = case_;
  const Drive* before = nullptr; // the same platen or body in another load case
  for (const Drive& other : s_.drives) {
    if (!same_target(d, other)) continue;
    before = &other;
    if (other.load_case == case_)
      s.fail(std::string("the same ") + (d.side ? "platen" : "body") + " has a statement in line " +
             std::to_string(other.at.line) + " in this load case, expected only one");
  }
  if (before != nullptr) d.about = before->about;
  if (s.accept("about")) {
    d.about = s.point("the reference point of motion and moment");
    if (before != nullptr && length(d.about - before->about) != 0)
      s.fail("the reference point differs from that of line " + std::to_string(before->at.line) +
             ", expected one point for all load cases");
  }
  bool turns = false; // round the axis
  const auto set = [&s](std::optional<double>& to, const std::string& what) {
    if (to) s.fail(what + " is given twice");
    to = s.number(what);
  };
  while (s.has_more()) {
    const size_t kind = s.choice({"x", "y", "turn", "force", "fx", "fy", "moment"});
    if (kind == 2 && s_.axisymmetric) {
      if (turns) s.fail("the angle of rotation is given twice");
      turn(s, d.side, d.body, false, case_);
      turns = true;
      continue;
    }
    if (kind < 3) set(d.motion[kind], kind < 2 ? "the displacement" : "the angle of rotation in radians");
    if (kind == 3 || kind == 4) set(d.load[0], "the force along x");
    if (kind == 3 || kind == 5) set(d.load[1], "the force along y");
    if (kind == 6) set(d.load[2], "the moment");
  }
  for (size_t i = 0; i < 3 && s_.axisymmetric; i += 2) {
    if (d.load[i] || d.motion[i].value_or(0) != 0)
      s.fail("a rigid part of a body of revolution moves along y and turns round the axis, expected y, fy or turn");
    d.motion[i] = 0;
  }
  if (s_.axisymmetric && before == nullptr) turn(s, d.side, d.body, false, -1); // rigid parts turn only as given
  for (size_t i = 0; i < 3; ++i) {
    if (d.motion[i] && d.load[i]) s.fail("both a motion and its load are given, expected one of them");
    for (const Drive& other : s_.drives)
      if (same_target(d, other) && ((d.motion[i] && other.load[i]) || (d.load[i] && other.motion[i])))
        s.fail(std::string("the ") + (d.load[i] ? "motion" : "load") + " of " + words[i] + " is given in line " +
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
    s.fail("body " + in_quotes(s_.bodies[static_cast<size_t>(d.body)].name) +
           " is rigid, expected the statement 'drive' for it");
  drive_of(s, d);
}

void Reader::drive(Statement& s) {
  end_body();
  Drive d;
  d.body = body_named(s.take("the name of a rigid body"));
  if (!s_.bodies[static_cast<size_t>(d.body)].rigid)
    s.fail("body " + in_quotes(s_.bodies[static_cast<size_t>(d.body)].name) +
           " is not rigid, expected the statement 'platen' with its curves");
  drive_of(s, d);
}

std::string Reader::names_of_cases() const {
  std::string out;
  for (const LoadCase& c : s_.cases)
    if (!c.name.empty()) out += (out.empty() ? ", expected " : " or ") + in_quotes(c.name);
  return out;
}

// normal 1; shear 1, -1, 1: each case in turn goes to its load factors while the others stay constant. `ring to 3`: its loads
// move until they have gone three periods. A second statement continues.
void Reader::history(Statement& s) {
  end_body();
  if (s_.cycle) s.fail("a history after the cycle, expected the statement 'cycle' last");
  pieces_of_history(s);
}

void Reader::pieces_of_history(Statement& s) {
  const auto last = [](const std::vector<double>& values) { return values.empty() ? 0.0 : values.back(); };
  do {
    const Word word = s.take("the name of a load case");
    const auto found = std::find_if(s_.cases.begin(), s_.cases.end(),
                                    [&](const LoadCase& c) { return !word.text.empty() && c.name == word.text; });
    if (found == s_.cases.end()) throw Fault{word.at, "no load case is called " + in_quotes(word.text) + names_of_cases()};
    const bool moves = s.accept("to");
    if (moves && !found->course)
      s.fail("the loads of case " + in_quotes(word.text) +
             " do not move, expected 'round', 'travel' or 'along' on its statement");
    double value = s.number(moves ? "how many periods the loads have gone" : "a load factor");
    do {
      if (moves) check_place(s, *found->course, value);
      for (LoadCase& c : s_.cases) c.factors.push_back(last(c.factors)), c.places.push_back(last(c.places));
      (moves ? found->places : found->factors).back() = value;
      ++s_.pieces;
    } while (s.accept_number(value));
  } while (s.accept(";") && s.has_more());
}

// Do two pieces end at the same loads? Those that go round are where they were after whole periods.
bool Reader::is_at(size_t piece, size_t other) const {
  constexpr double kSameLoads = 1e-12;
  for (const LoadCase& c : s_.cases) {
    const double a = c.factors[piece], b = c.factors[other];
    if (std::fabs(a - b) > kSameLoads * std::max(std::fabs(a), std::fabs(b))) return false;
    const double way = c.places[piece] - c.places[other];
    const double whole = c.course && c.course->returns() ? std::round(way) : 0.0;
    if (c.course && std::fabs(way - whole) > 1e-9) return false;
  }
  return true;
}

void Reader::drop_piece(size_t piece) {
  const auto at = static_cast<std::ptrdiff_t>(piece);
  for (LoadCase& c : s_.cases) c.factors.erase(c.factors.begin() + at), c.places.erase(c.places.begin() + at);
  --s_.pieces;
}

constexpr int kDigitsOfMovingLoads = 5;

// cycle shear 1, -1, 1 until steady digits 8 limit 80 compare: pieces as in a history. The first leads to the loads at
// which the cycle begins, unless they are reached already.
void Reader::cycle(Statement& s) {
  end_body();
  if (s_.cycle) s.fail("the statement 'cycle' is given twice, expected once");
  Repeat repeat;
  repeat.at = s.at();
  const auto before = static_cast<size_t>(s_.pieces);
  pieces_of_history(s);
  if (!s.accept("until")) s.missing("'until steady'");
  s.choice({"steady"});
  if (s.accept("digits")) repeat.digits = s.whole("the number of digits", 1, 12);
  if (s.accept("limit")) repeat.limit = s.whole("the limit of cycles", 1, 1000000);
  repeat.frictionless = s.accept("frictionless");
  repeat.compare = !repeat.frictionless && s.accept("compare");
  const auto last = [&] { return static_cast<size_t>(s_.pieces) - 1; };
  const bool moves = s_.cases.end() != std::find_if(s_.cases.begin(), s_.cases.end(), [&](const LoadCase& c) {
                       return c.places[last()] != (before > 0 ? c.places[before - 1] : 0.0);
                     });
  if (before > 0 && !moves && is_at(before, before - 1)) drop_piece(before); // (shear 1 after shear 1)
  const bool is_there = before > 0 && is_at(before - 1, last());
  repeat.before = static_cast<int>(is_there ? before : before + 1);
  if (!is_there && !is_at(before, last()))
    throw Fault{repeat.at,
                "the cycle does not close: its last loads are neither those reached before it nor those of its first number"};
  const size_t pieces = last() + 1 - static_cast<size_t>(repeat.before);
  if (pieces == 0 || (pieces == 1 && !moves))
    throw Fault{repeat.at, "the cycle has no other loads than those at which it begins, expected numbers such as 1, -1, 1"};
  const bool drifts = moves && repeat.digits == 0; // surfaces that walk change what the mesh makes of their shape
  if (drifts) repeat.digits = kDigitsOfMovingLoads;
  s_.cycle = repeat;
}

// Bodies that overlap as drawn are press fits, closed before the load history begins.
void Reader::interference(Statement& s) {
  end_body();
  if (s_.interference) s.fail("the statement 'interference' is given twice, expected once");
  s_.interference = true;
}

} // namespace sketch
