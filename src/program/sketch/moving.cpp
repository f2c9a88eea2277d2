// Loads that move (METHOD 22). A load at a position is the drawn one after a rigid motion, and between two positions both act,
// with factors that add to one: the load path stays a chain of straight pieces, whose events are found exactly, and what is
// left is the error of the chain, which falls with the number of positions.
//   1. with_positions replaces each moving case by one case for each position, and copies its loads, moved.
//   2. Every piece of the history becomes pieces between positions, with the factors of all cases.
#include "program/sketch/moving.hpp"

#include "program/sketch/shapes/region.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

const double kWholeTurn = 2 * std::acos(-1.0);

size_t index_of(int i) { return static_cast<size_t>(i); }

// Factors of two successive positions of a case.
struct Between {
  int first, second;
  double part; // of the second
};

Between between(const Course& course, double periods) {
  const double at = periods * course.positions;
  double below = std::floor(at);
  if (!course.returns()) below = std::clamp(below, 0.0, course.positions - 1.0);
  const auto wrapped = [&](double k) {
    const int n = course.different();
    return course.returns() ? (static_cast<int>(std::fmod(k, n)) + n) % n : static_cast<int>(k);
  };
  return {wrapped(below), wrapped(below + 1), at - below};
}

// The positions at which a way from one place to another has its turns, and its end.
std::vector<double> stops(const Course& course, double from, double to) {
  constexpr double kNear = 1e-9; // of a position
  std::vector<double> out;
  const double a = from * course.positions, b = to * course.positions;
  const double step = b > a ? 1 : -1;
  for (double k = step > 0 ? std::floor(a + kNear) + 1 : std::ceil(a - kNear) - 1; step * (b - k) > kNear; k += step)
    out.push_back(k / course.positions);
  out.push_back(to);
  return out;
}

class Expansion {
public:
  explicit Expansion(const Sketch& sketch) : from_(sketch), out_(sketch) {}
  Sketch run();

private:
  const std::optional<Course>& course_of(int load_case) const { return from_.cases[index_of(load_case)].course; }
  int number(int load_case, int position = 0) const { return first_[index_of(load_case)] + position; }
  template <class Statements, class Add> void replace(Statements& statements, const Add& add);
  void copy_loads();
  void make_cases();
  void make_history();
  void add_piece(const std::vector<double>& factors, const std::vector<double>& places, int increments);

  const Sketch& from_;
  Sketch out_;
  std::vector<int> first_; // number of the first new case of each case
};

void Expansion::make_cases() {
  out_.cases.clear();
  for (const LoadCase& one : from_.cases) {
    first_.push_back(static_cast<int>(out_.cases.size()));
    const int n = one.course ? one.course->different() : 1;
    for (int k = 0; k < n; ++k)
      out_.cases.push_back(
          {one.course ? one.name + ", position " + std::to_string(k + 1) + " of " + std::to_string(n) : one.name, {}, {}, {}});
  }
}

// Statements of cases that stay are renumbered; of the others `add` makes one for each load of each position.
template <class Statements, class Add> void Expansion::replace(Statements& statements, const Add& add) {
  Statements before;
  std::swap(before, statements);
  for (const auto& one : before) {
    const std::optional<Course>& course = course_of(one.load_case);
    if (!course) {
      statements.push_back(one);
      statements.back().load_case = number(one.load_case);
      continue;
    }
    for (int k = 0; k < course->different(); ++k)
      for (const MovedLoad& moved : course->loads_at(k)) {
        const auto copied = add(one, moved, number(one.load_case, k));
        if (copied) statements.push_back(*copied);
      }
  }
}

void Expansion::copy_loads() {
  replace(out_.conditions, [&](Condition c, const MovedLoad& moved, int load_case) -> std::optional<Condition> {
    const bool is_support = c.kind == Condition::kDisplacement; // of all cases
    if (is_support && load_case != number(c.load_case)) return std::nullopt;
    if (!is_support) c.moved = moved;
    c.load_case = load_case;
    return c;
  });
  replace(out_.point_loads, [&](PointLoad p, const MovedLoad& moved, int load_case) -> std::optional<PointLoad> {
    p.where = moved.to(p.where), p.force = moved.share * moved.turned(p.force), p.load_case = load_case;
    return p;
  });
  const auto add_to = [](auto& statements, const auto& same) {
    return std::find_if(statements.begin(), statements.end(), same);
  };
  replace(out_.body_forces, [&](BodyForce f, const MovedLoad& moved, int load_case) -> std::optional<BodyForce> {
    f.weight = moved.share * moved.turned(f.weight), f.load_case = load_case;
    const auto found =
        add_to(out_.body_forces, [&](const BodyForce& other) { return other.body == f.body && other.load_case == load_case; });
    if (found == out_.body_forces.end()) return f;
    found->weight = found->weight + f.weight;
    return std::nullopt;
  });
  replace(out_.drives, [&](Drive d, const MovedLoad& moved, int load_case) -> std::optional<Drive> {
    for (auto* pair : {&d.motion, &d.load}) {
      const Point turned = moved.share * moved.turned({(*pair)[0].value_or(0), (*pair)[1].value_or(0)});
      if ((*pair)[0] || (*pair)[1]) (*pair)[0] = turned.x, (*pair)[1] = turned.y;
      if ((*pair)[2]) *(*pair)[2] *= moved.share;
    }
    d.load_case = load_case;
    const auto found =
        add_to(out_.drives, [&](const Drive& other) { return same_target(other, d) && other.load_case == load_case; });
    if (found == out_.drives.end()) return d;
    for (size_t i = 0; i < 3; ++i) {
      if (d.motion[i]) *found->motion[i] += *d.motion[i];
      if (d.load[i]) *found->load[i] += *d.load[i];
    }
    return std::nullopt;
  });
}

void Expansion::add_piece(const std::vector<double>& factors, const std::vector<double>& places, int increments) {
  std::vector<double> all(out_.cases.size(), 0);
  for (size_t c = 0; c < from_.cases.size(); ++c) {
    const std::optional<Course>& course = from_.cases[c].course;
    const Between at = course ? between(*course, places[c]) : Between{0, 0, 0};
    all[index_of(first_[c] + at.first)] += (1 - at.part) * factors[c];
    if (course) all[index_of(first_[c] + at.second)] += at.part * factors[c];
  }
  for (size_t c = 0; c < all.size(); ++c) out_.cases[c].factors.push_back(all[c]);
  out_.steps.push_back(increments);
  ++out_.pieces;
}

void Expansion::make_history() {
  out_.pieces = 0;
  out_.steps.clear();
  std::vector<double> factors(from_.cases.size(), 0), places = factors;
  for (size_t piece = 0; piece < index_of(from_.pieces); ++piece) {
    if (from_.cycle && piece == index_of(from_.cycle->before)) out_.cycle->before = out_.pieces;
    std::vector<double> before = places;
    size_t moves = from_.cases.size();
    for (size_t c = 0; c < from_.cases.size(); ++c) {
      factors[c] = from_.cases[c].factors[piece];
      if (!from_.cases[c].course) continue;
      places[c] = from_.cases[c].places[piece];
      if (places[c] != before[c]) moves = c;
    }
    if (moves == from_.cases.size())
      add_piece(factors, places, from_.steps[std::min(piece, from_.steps.size() - 1)]);
    else
      for (const double stop : stops(*from_.cases[moves].course, before[moves], places[moves])) {
        before[moves] = stop;
        add_piece(factors, before, 1);
      }
  }
  if (out_.steps.empty()) out_.steps = from_.steps;
}

Sketch Expansion::run() {
  make_cases();
  copy_loads();
  make_history();
  return std::move(out_);
}

class MovingCheck {
public:
  explicit MovingCheck(const Sketch& sketch) : s_(sketch) {}
  std::vector<Fault> run();

private:
  const std::optional<Course>& course_of(int load_case) const { return s_.cases[index_of(load_case)].course; }
  void fault(Place at, const std::string& text) { faults_.push_back({at, text}); }
  void check_shares(const Course& course);
  void check_condition(const Condition& c, const Course& course);
  void check_force(const PointLoad& p, const Course& course);
  void check_drive(const Drive& d, const Course& course);
  void check_history(const LoadCase& one);

  const Sketch& s_;
  std::vector<Fault> faults_;
};

std::string position_of(int k, const Course& course) {
  return "position " + std::to_string(k + 1) + " of " + std::to_string(course.different());
}

void MovingCheck::check_shares(const Course& course) {
  for (int k = 0; k < course.different(); ++k) {
    double sum = 0;
    for (const MovedLoad& moved : course.loads_at(k)) {
      if (!std::isfinite(moved.share))
        return fault(course.at, "the share of a load at the angle " + show(moved.angle) + " is not a finite number");
      sum += std::fabs(moved.share);
    }
    if (sum == 0) return fault(course.at, "all shares are 0 at " + position_of(k, course) + ", expected loads that act");
  }
}

// How many of equal places on the curves of a condition have a load.
struct Seen {
  int loaded = 0;
  bool finite = true, varies = false;
};

Seen seen_on(const Body& body, const Condition& c, const std::vector<MovedLoad>& loads) {
  constexpr int kPlaces = 256;
  Seen out;
  std::optional<Point> first;
  Condition moved = c;
  for (const Outline& outline : body.outlines)
    for (const Curve& curve : outline.curves)
      for (int i = 0; i <= kPlaces && c.side.has(curve.name); ++i) {
        Point sum;
        for (const MovedLoad& one : loads) {
          moved.moved = one;
          sum = sum + moved.value_at(curve.shape->at(static_cast<double>(i) / kPlaces));
        }
        out.finite = out.finite && std::isfinite(sum.x) && std::isfinite(sum.y);
        out.loaded += sum.x != 0 || sum.y != 0 ? 1 : 0;
        if (!first) first = sum;
        out.varies = out.varies || sum.x != first->x || sum.y != first->y;
      }
  return out;
}

void MovingCheck::check_condition(const Condition& c, const Course& course) {
  constexpr int kSeen = 5; // at so many places of the first position a load is wide enough to be seen at any other
  if (c.kind == Condition::kDisplacement) {
    if (c.value[0].value_or(0) != 0 || c.value[1].value_or(0) != 0)
      fault(c.at, "a displacement does not move, expected it in a case without a course");
    return;
  }
  if (c.kind == Condition::kPressure && !c.field[0])
    return fault(c.at, "this pressure is the same in every position, expected a formula of x and y");
  const Body& body = s_.bodies[index_of(c.side.body)];
  bool is_wide = false;
  for (int k = 0; k < course.different(); ++k) {
    const Seen seen = seen_on(body, c, course.loads_at(k));
    if (!seen.finite) return fault(c.at, "the formula has no finite value on its curves at " + position_of(k, course));
    if (k == 0) is_wide = seen.loaded >= kSeen;
    if (seen.loaded == 0 && is_wide)
      return fault(c.at, "the load has left its curves at " + position_of(k, course) + ", expected a course along them");
  }
}

void MovingCheck::check_force(const PointLoad& p, const Course& course) {
  const Region region(s_, s_.bodies[index_of(p.body)]);
  for (int k = 0; k < course.different(); ++k)
    for (const MovedLoad& moved : course.loads_at(k)) {
      const Point at = moved.to(p.where);
      if (region.depth(at) <= 1e-9 * region.size())
        return fault(p.at, "at " + position_of(k, course) + " the force acts at (" + rounded(at.x) + ", " + rounded(at.y) +
                               "), not inside its body");
    }
}

void MovingCheck::check_drive(const Drive& d, const Course& course) {
  if (course.kind != Course::kRound)
    return fault(d.at, "the loads of a rigid part can turn, not travel, expected a case with 'round'");
  if (s_.axisymmetric) return fault(d.at, "a body of revolution has no load that turns");
  if (!(d.motion[0] && d.motion[1]) && !(d.load[0] && d.load[1]))
    fault(d.at, "what turns has two components, expected x and y, or fx and fy");
}

void MovingCheck::check_history(const LoadCase& one) {
  double factor = 0, place = 0;
  bool moves = false;
  for (size_t piece = 0; piece < index_of(s_.pieces); ++piece) {
    if (one.places[piece] != place && factor == 0)
      return fault(one.course->at,
                   "load case " + in_quotes(one.name) + " moves while its factor is 0, expected a factor before");
    moves = moves || one.places[piece] != place;
    factor = one.factors[piece], place = one.places[piece];
  }
  if (!moves)
    fault(one.course->at,
          "load case " + in_quotes(one.name) + " never moves, expected 'history " + one.name + " 1; " + one.name + " to 1'");
}

std::vector<Fault> MovingCheck::run() {
  for (const LoadCase& one : s_.cases) {
    if (!one.course) continue;
    if (s_.axisymmetric && one.course->kind == Course::kRound)
      fault(one.course->at, "loads of a body of revolution do not go round in its half section");
    check_shares(*one.course);
    check_history(one);
  }
  const auto each = [&](const auto& statements, const auto& check) {
    for (const auto& one : statements)
      if (const std::optional<Course>& course = course_of(one.load_case)) check(one, *course);
  };
  if (!faults_.empty()) return faults_;
  each(s_.conditions, [&](const Condition& c, const Course& course) { check_condition(c, course); });
  each(s_.point_loads, [&](const PointLoad& p, const Course& course) { check_force(p, course); });
  each(s_.body_forces, [&](const BodyForce& f, const Course& course) {
    if (course.kind != Course::kRound || f.rho_omega2 != 0)
      fault(f.at, "of the loads of a body its weight can turn, expected a case with 'round' and no spin");
  });
  each(s_.drives, [&](const Drive& d, const Course& course) { check_drive(d, course); });
  return faults_;
}

} // namespace

Point MovedLoad::turned(Point v) const {
  const double c = std::cos(angle), s = std::sin(angle);
  return angle == 0 ? v : Point{c * v.x - s * v.y, s * v.x + c * v.y};
}
Point MovedLoad::to(Point place) const { return turned(place) + shift; }
Point MovedLoad::from(Point place) const {
  MovedLoad back;
  back.angle = -angle;
  return back.turned(place - shift);
}

Point Condition::value_at(Point place) const {
  const Point p = moved ? moved->from(place) : place;
  double v[2];
  for (size_t i = 0; i < 2; ++i) v[i] = field[i] ? field[i]->at(p.x, p.y) : value[i].value_or(0);
  const Point drawn{v[0], v[1]};
  return !moved ? drawn : moved->share * (kind == kPressure ? drawn : moved->turned(drawn));
}

bool Course::returns() const {
  return kind == kRound || (kind == kAlong && length(curve->at(1) - curve->at(0)) <= 1e-9 * Measure(curve).length());
}

int Course::different() const {
  const int turns = kind == kRound && !shares.empty() ? loads : 1; // shares that differ come back after a whole turn
  return positions * turns + (returns() ? 0 : 1);
}

std::vector<MovedLoad> Course::loads_at(int position) const {
  const double part = static_cast<double>(position) / positions;
  std::vector<MovedLoad> out;
  for (int i = 0; i < loads; ++i) {
    MovedLoad one;
    if (kind == kTravel) one.shift = part * way;
    if (kind == kRound) one.angle = kWholeTurn * (part + i) / loads;
    if (kind == kAlong) {
      const double u = Measure(curve).u_at(part * Measure(curve).length());
      one.angle = angle_between(curve->tangent(0), curve->tangent(u));
      one.shift = curve->at(u) - one.turned(curve->at(0));
    }
    if (kind == kRound) one.shift = about - one.turned(about);
    const double a = std::fmod(one.angle, kWholeTurn);
    if (law) one.share = law->at(a, 0);
    if (!shares.empty()) one.share = shares[index_of(i)];
    if (one.share != 0) out.push_back(one);
  }
  return out;
}

bool has_moving_loads(const Sketch& sketch) {
  return std::any_of(sketch.cases.begin(), sketch.cases.end(), [](const LoadCase& c) { return c.course.has_value(); });
}

Sketch with_positions(const Sketch& sketch) { return Expansion(sketch).run(); }

Sketch with_twice_the_positions(Sketch sketch) {
  for (LoadCase& one : sketch.cases)
    if (one.course) one.course->positions *= 2;
  return sketch;
}

void take_positions(Sketch& to, const Sketch& from) {
  for (size_t c = 0; c < std::min(to.cases.size(), from.cases.size()); ++c)
    if (to.cases[c].course && from.cases[c].course) to.cases[c].course->positions = from.cases[c].course->positions;
}

std::vector<Fault> faults_of_moving_loads(const Sketch& sketch) { return MovingCheck(sketch).run(); }

} // namespace sketch
