// The pairs of a zone in order along side 2, by the length of that side: for edges and borders between nodes.
#pragma once

#include "post/body_curve.hpp"
#include "post/summary.hpp"

#include <contact2d.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace app {

// A position along a zone of this length, or a coordinate, for output: round-off about 0 becomes 0.
inline double told_place(double at, double length) { return std::fabs(at) < 1e-10 * length ? 0 : at; }

// Limit of a possible contact, which need not be a pair: with constant functions pairs lie in the middle of elements.
struct ZoneEnd {
  double s = 0;        // as below; a corner of side 1 may lie beyond the elements of a free zone
  bool mirror = false; // on a line of symmetry: the contact goes on in the image
  bool corner = false; // a body has a corner there: contact may end there, and then has no smooth edge
  bool cut = false;    // the surfaces go on, but belong to no zone: they cannot touch there, as if a corner were in the way
};

// The pairs of a zone in order along side 2, and the length along the surface from the first to each.
struct ZoneLine {
  int32_t zone = 0;
  std::vector<int32_t> pair; // from 0: rows of a step's table
  std::vector<double> s;
  std::vector<double> x, y;        // on side 2
  bool round = false;              // the side is a whole closed curve
  double length = 0;               // of side 2; of a round one all of it
  double beta = 0;                 // how unlike the bodies are: of Dundurs, of body 1 over body 2; 0 of like ones
  bool tied = false, self = false; // self: of a body with itself
  bool turned = false;             // force and moment of the contact are given of side 1: the second of a sketch's statement
  ZoneEnd end[2];
  std::vector<char> corner;   // has one of the bodies a corner at the pair?
  std::vector<double> weight; // integrals of the pairs' shape functions along side 2, of bodies of revolution over its area
  bool revolved = false;      // of bodies of revolution
  struct Piece {              // an element of side 2, in its own direction or against it
    double s;                 // where it begins
    bool up;
    ElementCurve curve;
  };
  std::vector<Piece> pieces;

  // Distances along the second side of the contact statement from its fixed point, in the order of elements; of a deck along
  // side 2 from its first element. They depend on neither the mesh nor the order of the pairs. A turned zone measures along
  // side 1.
  double from = 0;          // distance at the beginning of the side
  double around = 0;        // length of the closed curve that the side is part of; 0: it is open
  std::vector<Piece> faced; // side 1, in the order of elements
  double along(double at) const;

  size_t size() const { return pair.size(); }
  // The point of side 2 at a length; of a round side any length.
  void place(double at, double out[2]) const;
  // Area that side 2 of bodies of revolution describes from the first pair to a length.
  double area(double to) const;
};

// Gives the force and the moment of turned zones the sign of side 1.
void turn_forces(const std::vector<ZoneLine>& lines, std::vector<c2d_zone_state>& states);

// Of a complete model, in the order of the zones.
c2d_status find_zone_lines(c2d_solver* solver, const Summary& summary, std::vector<ZoneLine>& out);

} // namespace app
