// A sketch: bodies drawn as named curves, what is between them, what acts on them, and what is wanted. No mesh.
#pragma once

#include "program/sketch/shape.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sketch {

constexpr size_t kLongestName = 31; // in bytes, of bodies and interfaces
constexpr size_t kLongestTitle = 72;

struct Curve {
  std::string name; // several curves of a body may bear one name
  ShapePtr shape;
  Place at;
  ShapePtr drawn{};           // what it is cut from by a statement `part`, null if by none,
  double first = 0, last = 1; // and which part of that
  // What cut_contacts() adds: an outline's curves are cut where parts that may touch end.
  double begin = 0;                     // length along the outline
  bool is_first = true, is_last = true; // of the pieces of one drawn curve
  int contact = -1;                     // the part of an interface that it belongs to; -1: none
  int side = 0;                         // which side of that; contact conditions hold at nodes of side 1
};

// A boundary, run through with the material on the left; of a hole too.
struct Outline {
  std::vector<Curve> curves;
  bool hole = false;
  bool open = false; // from line of symmetry to line of symmetry
  Place at;
};

struct Body {
  std::string name;
  double youngs_modulus = 0, poisson_ratio = 0;
  bool rigid = false;
  std::vector<Outline> outlines;
  Place at;
};

// Curves of one body, by name.
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
  std::string name;
  Place at;
};

// Parts of two outlines that face each other and may touch, or are bonded.
struct Contact {
  size_t interface = 0;
  struct Strip { // lengths along an outline, beyond its end where a closed one goes on at its begin
    int body = 0;
    size_t outline = 0;
    double from = 0, to = 0;
    double round = 0; // the length after which the outline begins again; 0 of an open one
  } side[2];
  bool ring = false;                      // all round both
  bool turned = false;                    // side 1 is the first of the statement
  bool is_held[2] = {false, false};       // something prescribes displacements where side 1 begins, ends
  std::string ends[2];                    // why the part ends there, though contact might go on; empty: it does not
  std::vector<std::array<double, 2>> map; // lengths that face each other, falling on side 0, rising on side 1
};

// What is given along curves, in one load case.
struct Condition {
  Side side;
  enum Part { kAll, kStart, kEnd } part = kAll; // or only the first or the last point of the curve, which is one then
  enum Kind { kDisplacement, kTraction, kPressure } kind = kDisplacement;
  std::optional<double> value[2];     // along x and y, where something is given; of a pressure the first
  std::optional<Expression> field[2]; // of a traction or a pressure that is a formula of x and y; its value is NaN
  int load_case = 0;
  Place at;
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

// Ends of a body that move as one rigid body, or a rigid body: of ux, uy and the turn each is given, or its load is.
struct Drive {
  std::optional<Side> side; // of a platen
  int body = 0;
  Point about;
  std::array<std::optional<double>, 3> motion, load;
  int load_case = 0;
  Place at;
};

// A point inside where displacements and stresses are wanted.
struct WantedPoint {
  int body = 0;
  Point at;
  Place place; // of its statement
};

// Do two statements move the same body or the same curves?
bool same_target(const Drive& a, const Drive& b);

struct LoadCase {
  std::string name;
  std::vector<double> factors; // at the end of each piece of the history
};

// Elements of a stretch of a curve: equal ones, or sizes at its ends that grow from there.
struct Stretches {
  int count = 0;              // 0: graded
  double first = 0, last = 0; // sizes at the ends; 0: any
  double growth = 1.3;        // of an element against the one before
  double most = 0;            // size; 0: any
  double to = 0;              // where the next stretch begins, a length from the curve's begin
};

// How curves are divided in the mesh that no tolerance asks for.
struct Division {
  Side side;
  std::vector<Stretches> stretches;
};

// A number that is wanted, and how accurately. Without any: pressures, edges, forces and approach.
struct Want {
  enum Kind { kPressure, kEdges, kForces, kApproach, kDissipation, kStress, kHoop, kPressureAt } kind = kPressure;
  std::optional<double> tolerance; // relative; the sketch's where it is not told
  int body = 0;                    // of kStress, kHoop and kPressureAt
  Point where;                     // of kStress and kPressureAt
  std::optional<Side> side; // of kHoop: the largest and the smallest along it; of kPressureAt: the place is the nearest on it
  bool cycle = false;       // of kStress and kHoop: nothing but the range over the last cycle of the history
  Place at;
};

struct Sketch {
  std::string title;
  std::string units[2];
  Parameters parameters;
  bool plane_stress = false;
  bool interference = false;         // overlaps of what is drawn are press fits, closed before the history
  int order = 1;                     // of the functions
  bool chooses_order = true;         // the loop over meshes may take another one: no statement names it
  std::optional<double> symmetry[2]; // x = , y =
  std::vector<Body> bodies;
  std::vector<Interface> interfaces;
  std::vector<Contact> contacts; // of the interfaces, in their order
  std::vector<Condition> conditions;
  std::vector<PointLoad> point_loads;
  std::vector<BodyForce> body_forces;
  std::vector<Drive> drives;
  std::vector<LoadCase> cases{{"", {}}}; // the first is there without a card
  int pieces = 0;                        // of the history; 0: factor 1 of the first case
  std::vector<WantedPoint> points;
  std::vector<int> steps{10}; // increments of the pieces of the history, the last number of all further ones
  std::vector<Want> wants;
  std::vector<Division> divisions;
  double tolerance = 0.01;   // of all wants that have none of their own
  bool adapts = true;        // no: the first mesh is the mesh
  double most_seconds = 0;   // 0: no limit
  double most_work = 1e13;   // multiplications, of all meshes, unless there is a limit of time
  int most_elements = 20000; // of all bodies together
};

} // namespace sketch
