// Statements that say what is between bodies, what acts on them, and in which order.
#include "program/sketch/reader.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

int Reader::body_named(const Word& word) const {
  for (size_t b = 0; b < s_.bodies.size(); ++b)
    if (s_.bodies[b].name == word.text) return static_cast<int>(b);
  throw Fault{word.at, "no body is called " + quoted(word.text)};
}

// body.curve, body.curve+curve: every curve that bears one of the names.
Side Reader::side(Statement& s) {
  const Word word = s.take("curves of a body, such as pad.tip or pad.tip+flank");
  const size_t dot = word.text.find('.');
  if (dot == std::string::npos)
    throw Fault{word.at, quoted(word.text) + ": expected a body, a point and its curves, such as pad.tip"};
  Side out;
  out.at = word.at;
  out.body = body_named({word.text.substr(0, dot), word.at, false});
  const Body& body = s_.bodies[static_cast<size_t>(out.body)];
  for (size_t at = dot + 1, end; at <= word.text.size(); at = end + 1) {
    end = std::min(word.text.find('+', at), word.text.size());
    out.names.push_back(word.text.substr(at, end - at));
    bool known = false;
    for (const Outline& outline : body.outlines)
      for (const Curve& curve : outline.curves) known = known || curve.name == out.names.back();
    if (!known || out.names.back().empty())
      throw Fault{word.at, "body " + quoted(body.name) + " has no curve " + quoted(out.names.back())};
  }
  return out;
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
    } else if (s.accept("inf")) {
      out.friction = HUGE_VAL;
    } else {
      out.friction = s.number("the coefficient of friction");
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
  const bool first_is_unused = s_.cases.size() == 1 && s_.cases[0].name.empty() && s_.conditions.empty() &&
                               s_.point_loads.empty() && s_.body_forces.empty() && s_.drives.empty();
  if (!first_is_unused) s_.cases.push_back({});
  case_ = static_cast<int>(s_.cases.size()) - 1;
  s_.cases.back().name = name;
}

void Reader::components(Statement& s, std::optional<double> value[2]) {
  do {
    const size_t axis = s.choice({"x", "y"});
    if (value[axis]) s.fail(std::string(axis == 0 ? "x" : "y") + " is given twice");
    value[axis] = s.number("its value");
  } while (s.has_more());
}

void Reader::fix(Statement& s) {
  end_body();
  Condition c{side(s), Condition::kDisplacement, {}, case_, s.at()};
  if (!s.has_more()) c.value[0] = c.value[1] = 0;
  while (s.has_more()) c.value[s.choice({"x", "y"})] = 0;
  s_.conditions.push_back(c);
}

void Reader::move(Statement& s) {
  end_body();
  Condition c{side(s), Condition::kDisplacement, {}, case_, s.at()};
  components(s, c.value);
  s_.conditions.push_back(c);
}

void Reader::traction(Statement& s) {
  end_body();
  Condition c{side(s), Condition::kTraction, {}, case_, s.at()};
  components(s, c.value);
  s_.conditions.push_back(c);
}

void Reader::pressure(Statement& s) {
  end_body();
  Condition c{side(s), Condition::kPressure, {}, case_, s.at()};
  c.value[0] = s.number("the pressure");
  s_.conditions.push_back(c);
}

void Reader::force(Statement& s) {
  end_body();
  PointLoad p;
  p.at = s.at(), p.load_case = case_;
  p.body = body_named(s.take("the name of a body"));
  if (!s.accept("at")) s.fail("expected at x y, and x and y of the force");
  p.where = s.point("where it acts");
  std::optional<double> value[2];
  components(s, value);
  p.force = {value[0].value_or(0), value[1].value_or(0)};
  s_.point_loads.push_back(p);
}

void Reader::weight(Statement& s) {
  end_body();
  BodyForce f;
  f.at = s.at(), f.load_case = case_;
  f.body = body_named(s.take("the name of a body"));
  std::optional<double> value[2];
  components(s, value);
  f.weight = {value[0].value_or(0), value[1].value_or(0)};
  s_.body_forces.push_back(f);
}

void Reader::spin(Statement& s) {
  end_body();
  BodyForce f;
  f.at = s.at(), f.load_case = case_;
  f.body = body_named(s.take("the name of a body"));
  f.rho_omega2 = s.number("density times the square of the angular velocity");
  if (s.accept("about")) f.centre = s.point("the axis");
  s_.body_forces.push_back(f);
}

// Of x, y and turn each has a motion that is given, or it is free and has a load, 0 if none is told.
void Reader::drive_of(Statement& s, Drive d) {
  d.at = s.at(), d.load_case = case_;
  if (s.accept("about")) d.about = s.point("the point that the motion and the moment belong to");
  while (s.has_more()) {
    const size_t kind = s.choice({"x", "y", "turn", "force", "fx", "fy", "moment"});
    if (kind < 3) d.motion[kind] = s.number("how far it moves");
    if (kind == 3) d.load[0] = s.number("the force along x"), d.load[1] = s.number("the force along y");
    if (kind > 3) d.load[kind - 4] = s.number(kind == 6 ? "the moment" : "the force");
  }
  for (size_t i = 0; i < 3; ++i)
    if (d.motion[i] && d.load[i]) s.fail("a motion and its load are both given, expected one of them");
  s_.drives.push_back(d);
}

void Reader::platen(Statement& s) {
  end_body();
  Drive d;
  d.side = side(s);
  d.body = d.side->body;
  drive_of(s, d);
}

void Reader::drive(Statement& s) {
  end_body();
  Drive d;
  d.body = body_named(s.take("the name of a rigid body"));
  if (!s_.bodies[static_cast<size_t>(d.body)].rigid)
    s.fail("body " + quoted(s_.bodies[static_cast<size_t>(d.body)].name) + " is not rigid");
  drive_of(s, d);
}

// normal 1; shear 1, -1, 1: one case after the other goes to the factors told, the others stay.
void Reader::history(Statement& s) {
  end_body();
  std::vector<double> now;
  for (const LoadCase& c : s_.cases) now.push_back(c.factors.empty() ? 0 : c.factors.back());
  do {
    const Word word = s.take("the name of a load case");
    const auto found = std::find_if(s_.cases.begin(), s_.cases.end(), [&](const LoadCase& c) { return c.name == word.text; });
    if (found == s_.cases.end()) throw Fault{word.at, "no load case is called " + quoted(word.text)};
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

// Where displacements and stresses are wanted.
void Reader::stress(Statement& s) {
  end_body();
  const int body = body_named(s.take("the name of a body"));
  do {
    const Point p = s.point("a point");
    s_.points.push_back({static_cast<double>(body), p.x, p.y});
  } while (s.has_more());
}

} // namespace sketch
