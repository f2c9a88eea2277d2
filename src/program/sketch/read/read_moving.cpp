// The course of a load case whose loads move.
#include "program/sketch/read/reader.hpp"

#include <cmath>

namespace sketch {

constexpr int kLeastPositions = 3, kMostPositions = 1000, kMostLoads = 200;

// case ring round 0 0 positions 24 loads 12 shares {max(0, cos(a))}
void Reader::course(Statement& s, LoadCase& moving) {
  Course course;
  course.kind = static_cast<Course::Kind>(s.choice({"round", "travel", "along"}));
  course.at = s.at();
  if (course.kind == Course::kRound) course.about = s.point("the point that the loads go round");
  if (course.kind == Course::kTravel) course.way = s.point("the way that the loads go");
  if (course.kind == Course::kTravel && length(course.way) == 0) s.fail("the way has no length, expected x and y of its end");
  if (course.kind == Course::kAlong) course.curve = single_curve(s);
  if (!s.accept("positions")) s.missing("positions and their number");
  course.positions = s.whole("the number of positions", 1, kMostPositions);
  if (course.kind == Course::kRound && s.accept("loads")) loads_of_course(s, course);
  if (course.positions * course.loads < kLeastPositions)
    s.fail("fewer than three positions, expected at least " + std::to_string((kLeastPositions - 1) / course.loads + 1));
  moving.course = course;
}

// Several loads at equal angles, with shares that each keeps or that depend on where it is.
void Reader::loads_of_course(Statement& s, Course& course) {
  course.loads = s.whole("the number of loads", 1, kMostLoads);
  if (!s.accept("shares")) return;
  if (!s.is_number()) s.missing("a share for each load, or a formula of the angle a");
  const Expression first = s.formula("the share of a load, or a formula of the angle a", "a");
  if (first.varies()) {
    course.law = first;
    return;
  }
  course.shares.push_back(first.value());
  while (static_cast<int>(course.shares.size()) < course.loads) course.shares.push_back(s.number("the share of each load"));
}

ShapePtr Reader::single_curve(Statement& s) {
  const Side named = side(s);
  const Curve* found = nullptr;
  for (const Outline& outline : s_.bodies[static_cast<size_t>(named.body)].outlines)
    for (const Curve& curve : outline.curves) {
      if (!named.has(curve.name)) continue;
      if (found != nullptr) s.fail("several curves are named, expected a single one");
      found = &curve;
    }
  if (found == nullptr) s.fail("the curve has an error"); // reported where it is drawn
  return found->shape;
}

// Is a place on the course?
void Reader::check_place(Statement& s, const Course& course, double periods) {
  if (!course.returns() && (periods < 0 || periods > 1)) s.fail(show(periods) + ": expected a part of the course, from 0 to 1");
  if (std::fabs(periods) > 1e4) s.fail(show(periods) + ": expected at most 10000 periods");
}

} // namespace sketch
