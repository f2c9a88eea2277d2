// A problem of a family as data, and the deck written from it.
#pragma once

#include "program/families/mesh.hpp"

#include <array>
#include <string>
#include <vector>

namespace families {

// A rigid body: held, or with free motions of a point that follow from a force and a moment in load case 1.
struct RigidModel {
  enum Kind { kElastic, kHeld, kLoaded } kind = kElastic;
  Point point{0, 0};
  std::string free{};           // words of *RIGID LOAD, such as "Y TURN"; empty: all motions
  std::array<double, 3> load{}; // fx, fy, moment
};

struct BodyModel {
  double youngs_modulus = 0, poisson_ratio = 0;
  Point origin{0, 0};           // of the coordinates on the cards; arcs are about it
  std::vector<Outline> regions; // closed curves
  std::string name;             // for the comments of the deck
  RigidModel rigid{};
};

// A side of a body's outline, all from 0.
struct ZoneSide {
  int body, side, region = 0;
};

// Contact between the elements of two sides, which run oppositely; of a matching zone as many on both.
struct ContactZone {
  ZoneSide side1, side2;
  bool free = false, tied = false;
  // Of a matching zone: the nodes at the first or last end of side 1 make no pair, as those at a crack's tip, which are tied.
  bool without_first = false, without_last = false;
};
// Between bodies 1 and 2.
inline ContactZone contact(int side1, int side2) { return {{0, side1}, {1, side2}}; }
// A bond.
inline ContactZone tie(ZoneSide side1, ZoneSide side2, bool free = false) { return {side1, side2, free, true}; }

struct Load {
  int increments;
  double factor;
};

struct ProblemModel {
  std::vector<std::string> heading; // cards of text; the title comes behind them
  std::string title;
  int plane = 0;          // 0 plane strain, 1 plane stress
  int function_nodes = 2; // per element
  bool images = false;    // lines of symmetry by images, without elements there
  std::vector<BodyModel> bodies;
  std::vector<ContactZone> zones; // those that match before those that are free
  std::vector<double> friction{0.0};
  std::vector<Load> loads{{1, 1.0}};
  std::vector<std::string> keywords; // cards behind the load cards
};

// The deck in the free form. Geometry is that of straight elements between the nodes, or of arcs through an added middle
// node where function_nodes > 2 and a region has arcs.
std::string write_deck(const ProblemModel& model);

} // namespace families
