// A problem of a family as data, and the deck written from it.
#pragma once

#include "program/families/mesh.hpp"

#include <string>
#include <vector>

namespace families {

struct BodyModel {
  double youngs_modulus = 0, poisson_ratio = 0;
  Point origin{0, 0};           // of the coordinates on the cards; arcs are about it
  std::vector<Outline> regions; // closed curves
  std::string name;             // for the comments of the deck
};

// Contact between the elements of one side of each body's first region, which run oppositely.
struct ContactZone {
  int side1, side2; // sides of the outlines, from 0
};

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
  std::vector<ContactZone> zones;
  std::vector<double> friction{0.0};
  std::vector<Load> loads{{1, 1.0}};
  std::vector<std::string> keywords; // cards behind the load cards
};

// The deck in the free form. Geometry is that of straight elements between the nodes, or of arcs through an added middle
// node where function_nodes > 2 and a region has arcs.
std::string write_deck(const ProblemModel& model);

} // namespace families
