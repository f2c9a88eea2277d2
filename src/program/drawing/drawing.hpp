// The contents of a drawing: named curves, joined to loops and bodies.
#pragma once

#include "program/sketch/shapes/shape.hpp"

#include <string>
#include <vector>

namespace drawing {

using sketch::Point;

// Ends of curves closer than this fraction of the size of the drawing are joined.
constexpr double kJoin = 1e-6;
constexpr double kRound = 1e-8; // of the size: round-off of the digits in files
constexpr double kHalfTurn = 3.14159265358979323846;

// A fault of a file, thrown while it is read; line 0: the whole file.
struct Fault {
  int line = 0;
  std::string text;
};
struct TooLarge : Fault {}; // no entity is left out for this

struct Curve {
  enum Kind { kLine, kArc, kEllipse, kSpline } kind = kLine;
  std::string name;   // of its layer or physical group; empty: none
  int line = 0;       // where the file has it
  size_t order = 0;   // in the drawing
  bool whole = false; // closed by itself: a circle, an ellipse, a smooth closed spline
  Point begin, end;
  Point centre;               // of an arc and an ellipse
  double a = 0, b = 0;        // half axes; of an arc the radius
  double tilt = 0;            // of the axis a, in degrees
  double from = 0, sweep = 0; // eccentric angles in degrees; below 0: clockwise
  std::vector<Point> points;  // of a spline, both ends among them; of a whole one the begin stands once
  bool guessed = false;       // an arc through three or four points, which may stand for another curve
  double doubt = 0;           // of a spline: largest distance from the original curve
};

Curve straight(Point begin, Point end);
Curve circular(Point centre, double radius, double from, double sweep); // whole from 360 degrees on
Curve elliptic(Point centre, double a, double b, double tilt, double from, double sweep);
Curve smooth(std::vector<Point> points, bool whole);

sketch::ShapePtr shape_of(const Curve& curve);
Curve reversed(const Curve& curve);
// Puts the ends where joints are.
void move_ends(Curve& curve, Point begin, Point end);
// The two halves of a curve that is not whole.
std::vector<Curve> halves(const Curve& curve);
// Points along a curve, the end left out.
void append_polygon(std::vector<Point>& out, const Curve& curve);

struct Loop {
  std::vector<Curve> curves; // one after the other, with the material on the left; a single whole one turns left
  bool hole = false;
  // Of a pin in a hole that nearly is its size, or of that hole: the other's outline, which is this one's in a press fit.
  std::vector<Curve> press_fit = {};
  size_t fit = 0; // a number for both of them
};

struct Body {
  std::string name; // empty: none
  std::vector<Loop> loops;
};

struct Drawing {
  std::string kind;          // what the file is
  std::string unit;          // of length; empty: not given
  std::vector<Curve> curves; // that are to be joined
  std::vector<Body> bodies;  // defined by the file itself
  std::vector<std::string> notes;
  Fault crossing; // the first of outlines that cross; no text: none does
};

std::string text_of(double value); // with six digits
std::string text_of(Point p);      // (x, y)
std::string text_of(const Curve& curve);
// The larger side of the box around curves.
double size_of(const std::vector<Curve>& curves);

} // namespace drawing
