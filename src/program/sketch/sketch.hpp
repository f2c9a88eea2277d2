// A sketch: bodies with named curves, contacts and ties, supports and loads, and requested results. It has no mesh.
#pragma once

#include "program/sketch/shapes/shape.hpp"
#include "program/sketch/wants.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace sketch {

constexpr size_t kLongestName = 31; // in bytes, of bodies and interfaces
constexpr size_t kLongestTitle = 72;

struct Curve {
  std::string name; // several curves of a body may have the same name
  ShapePtr shape;
  Place at;
  ShapePtr drawn{};           // the curve that a statement `part` cut it from, or null
  double first = 0, last = 1; // and its range of u there
  // Added by cut_contacts(), which divides the curves of an outline at the ends of facing parts.
  double begin = 0;                     // length along the outline
  bool is_first = true, is_last = true; // among the pieces of one drawn curve
  int contact = -1;                     // index of its Contact; -1: none
  int side = 0;                         // side of that contact; contact conditions are imposed at the nodes of side 1
};

// A boundary with the material on the left, also around a hole.
struct Outline {
  std::vector<Curve> curves;
  bool hole = false;
  bool open = false; // begins and ends on lines of symmetry
  Place at;
};

// Fatigue constants of a material; NaN: not given.
struct FatigueConstants {
  double fatemi_socie = NAN, yield = NAN, findley = NAN, crossland = NAN, dang_van = NAN;
};

struct Body {
  std::string name;
  double youngs_modulus = 0, poisson_ratio = 0;
  FatigueConstants fatigue;
  bool rigid = false;
  std::vector<Outline> outlines;
  Place at;
};

// Curves of one body, given by name.
struct Side {
  int body = 0;
  std::vector<std::string> names;
  Place at;
  bool has(const std::string& name) const;
};

struct Interface {
  Side side[2];
  bool tied = false;
  double friction = 0;
  std::optional<double> friction_round; // round the axis, if it is another
  std::string name;
  Place at;
};

// Parts of two outlines that face each other: in contact or tied.
struct Contact {
  size_t interface = 0;
  struct Strip { // lengths along an outline, beyond its total length where a closed outline passes its start
    int body = 0;
    size_t outline = 0;
    double from = 0, to = 0;
    double round = 0; // the total length of a closed outline; 0 for an open one
  } side[2];
  bool ring = false;                      // the whole of both outlines
  bool turned = false;                    // side 1 is the first of the statement
  bool is_supported[2] = {false, false};  // does side 1 start, end at a prescribed displacement?
  std::string ends[2];                    // why the part ends there although the surface continues; empty: it does not continue
  std::vector<std::array<double, 2>> map; // facing lengths, decreasing on side 0 and increasing on side 1
};

// A rigid motion of a load from where it is drawn: turned about the origin, then shifted. `share`: its factor there.
struct MovedLoad {
  double angle = 0; // radians, counter-clockwise
  Point shift;
  double share = 1;
  Point turned(Point vector) const;
  Point to(Point place) const; // where the load at a place goes
  Point from(Point place) const;
};

// A condition on curves in one load case.
struct Condition {
  Side side;
  enum Part { kAll, kStart, kEnd } part = kAll; // or only the first or the last point of a single curve
  enum Kind { kDisplacement, kTraction, kPressure } kind = kDisplacement;
  std::optional<double> value[2];     // along x and y, if given; a pressure uses the first
  std::optional<Expression> field[2]; // set if the value is a formula of x and y; `value` is NaN then
  int load_case = 0;
  std::optional<MovedLoad> moved; // of a traction or pressure
  Place at;
  Point value_at(Point place) const; // along x and y; 0 where none is given; of a pressure x
};

// A rotation round the axis or a shear traction round it, of bodies of revolution.
struct Turn {
  std::optional<Side> side; // empty: a rigid body
  int body = 0;
  bool is_traction = false;
  double value = 0;                // radians, or the traction
  std::optional<Expression> field; // of a traction that is a formula of the place
  int load_case = -1;              // -1: it holds in every case
  Place at;
  bool loads() const { return load_case >= 0 && (field || value != 0); }
};

struct PointLoad {
  int body = 0;
  Point where, force;
  int load_case = 0;
  Place at;
};

struct BodyForce {
  int body = 0;
  Point weight;
  double rho_omega2 = 0;
  Point centre;
  int load_case = 0;
  Place at;
};

// A platen (curves of a body that move as one rigid body) or a rigid body. For ux, uy and the rotation, either the motion or
// the load is given.
struct Drive {
  std::optional<Side> side; // the curves of a platen; empty for a rigid body
  int body = 0;
  Point about;
  std::array<std::optional<double>, 3> motion, load;
  int load_case = 0;
  Place at;
};

// An interior point with requested displacements and stresses.
struct WantedPoint {
  int body = 0;
  Point at;
  Place place; // of its statement
};

// Do two statements drive the same body or the same curves?
bool same_target(const Drive& a, const Drive& b);

// How the loads of a case move: about a point, along a straight way, or along a curve of a body, with which they turn.
struct Course {
  enum Kind { kRound, kTravel, kAlong } kind = kRound;
  Point about, way;
  ShapePtr curve;
  int positions = 0;             // of a period: a whole turn, one pitch of several equal loads, the way, the curve
  int loads = 1;                 // of kRound: at equal angles
  std::vector<double> shares;    // which each load keeps; empty: all 1, or by the law
  std::optional<Expression> law; // the share at the angle in radians by which a load is turned
  Place at;
  bool returns() const;  // the position after the last is the first
  int different() const; // positions
  std::vector<MovedLoad> loads_at(int position) const;
};

struct LoadCase {
  std::string name;
  std::vector<double> factors; // at the end of each piece of the load history
  std::optional<Course> course;
  std::vector<double> places; // of a case with a course: the periods gone at the end of each piece
};

// Loads round the axis. Their cases act after all others, on the pressures of the last state.
struct Torsion {
  std::vector<Turn> turns;
  std::vector<LoadCase> cases;
  int first_piece = 0, pieces = 0; // of the history; the numbers of steps count from the first piece of all
  bool any() const { return !cases.empty(); }
};

// Elements of a stretch of a curve: equal, or graded from given sizes at its ends.
struct Stretches {
  int count = 0;              // 0: graded
  double first = 0, last = 0; // sizes at the ends; 0: free
  double growth = 1.3;        // largest ratio of neighbouring sizes
  double most = 0;            // largest size; 0: no limit
  double to = 0;              // length from the start of the curve to the end of the stretch
};

// Divisions of curves for the mesh used without a tolerance.
struct Division {
  Side side;
  std::vector<Stretches> stretches;
};

// Where a fatigue parameter is taken: the largest along curves, at a depth below that place, of the mean stresses down to this
// depth, at an interior point; for a crack its depth.
enum class FatiguePlace { kSurface, kDepth, kMean, kPoint };
struct FatigueWant {
  FatigueKind kind = FatigueKind::kSwt;
  FatiguePlace place = FatiguePlace::kSurface;
  double depth = 0;
};

// A requested result and its tolerance. Without any request: the rows of wants() by default.
struct Want {
  std::string word;                // of wants()
  WantOf of = WantOf::kContact;    // what it is a result of
  std::optional<double> tolerance; // relative; default: the tolerance of the sketch
  int body = 0;                    // unless of a contact
  Point where;                     // of kPoints, kPlaces and kPair
  int other = 0;                   // of kPair: the second point and its body
  Point to;
  std::optional<Side> side; // of kCurves: its largest and smallest values; of kPlaces: the nearest point on it
  bool cycle = false;       // of kPoints and kCurves: only the range over the last cycle of the history
  bool is_zz = false;       // of kPoints and kCurves: of the stress out of the plane alone
  FatigueWant fatigue;      // of kFatigue; with `side`, or with `where` at an interior point
  Place at;
};

// Of a parameter: its value may be off by `size`, above 0.
struct Tolerance {
  std::string parameter;
  double value = 0, size = 0;
  Place at;
};

// The cycle at the end of the load history, repeated until it is steady.
struct Repeat {
  Place at;
  int before = 0;            // pieces of the history before it
  int limit = 50;            // of cycles
  int digits = 0;            // steady: changes over a cycle below 10^-digits; 0: by default
  bool frictionless = false; // the start is without friction
  bool compare = false;      // a start without friction is compared with the one as loaded
};

struct Sketch {
  std::string title;
  std::string units[2];
  Parameters parameters;
  std::vector<Tolerance> tolerances; // in the order of the parameters
  bool plane_stress = false;
  bool axisymmetric = false;         // bodies of revolution; symmetry[0] is the axis
  bool interference = false;         // drawn overlaps are press fits, closed before the load history begins
  int order = 1;                     // of the shape functions
  bool chooses_order = true;         // mesh refinement may choose another order: no statement gives it
  std::optional<double> symmetry[2]; // x = , y =
  std::vector<Body> bodies;
  std::vector<Interface> interfaces;
  std::vector<Contact> contacts; // in the order of the interfaces
  std::vector<Condition> conditions;
  std::vector<PointLoad> point_loads;
  std::vector<BodyForce> body_forces;
  std::vector<Drive> drives;
  std::vector<LoadCase> cases{LoadCase{}}; // the first exists without a statement
  int pieces = 0;                          // of the history; 0: factor 1 of the first case
  Torsion torsion;
  std::optional<Repeat> cycle;
  std::vector<WantedPoint> points;
  std::vector<WantedPoint> fatigue_points; // of wants of fatigue parameters inside
  std::vector<int> steps{10};              // increments per piece of the history; the last number applies to all later pieces
  std::vector<Want> wants;
  std::vector<Division> divisions;
  double tolerance = 0.01;   // for wants without their own
  bool adapts = true;        // false: use the first mesh
  double most_seconds = 0;   // 0: no limit
  double most_work = 1e13;   // multiplications on all meshes, unless time is limited
  int most_elements = 20000; // of all bodies together
};

} // namespace sketch
