#pragma once
// What the files of free_zones.hpp share: a zone's surfaces, bounds that spare most of a search, what it looks for.
#include "model/free_zones.hpp"

namespace c2d::facing {

constexpr double kSnap = 1e-9; // local coordinates nearer to a node are the node's

// ---- zone_surface.cpp

// Does a side cover a whole closed curve?
bool is_ring(const Model& m, const Zone& z, int side);
// The place of the neighbour at the start (-1) or end (1) of the element at a place; -1: none in the zone.
int32_t place_beside(const Model& m, const Zone& z, int side, int32_t place, int end);
inline FacePoint point_at(const Model& m, const Zone& z, int side, int32_t place, double eta) {
  return FacePoint{zone_element(m, z, side, place), place, eta};
}
// A point of a surface and the unit normal there, continuous along the zone.
struct Place {
  SurfacePoint point;
  double n[2];
};
Place place_at(const Model& m, const Zone& z, int side, const FacePoint& at);
Place place_at(const Model& m, const Zone& z, int side, const SurfaceElement& surface, const FacePoint& at);

// ---- facing_bounds.cpp. Not inlined, to limit the stack of the search for facing points.

// Upper bound of element_length() for 2 to 4 points, at most 1.26 or 2.02 times the chords, at a fraction of its cost.
double length_at_most(int nodes, const double* x, const double* y);
// Is every point of the surface over an element farther away than the root of `square`? True is certain, false is not: the
// surface stays within half the length of the element from it.
[[gnu::noinline]] bool is_beyond(const Model& m, int b, int32_t element, const SurfacePoint& from, double square);
// Are values at the ends of an element within kSnap of its length of zero?
struct Closeness {
  bool start, end;
};
[[gnu::noinline]] Closeness closeness(const Model& m, int b, int32_t element, double start, double end);
// The element of a side whose middle is nearest: the facing point is most likely on it, and then most others can be excluded by
// their distance.
[[gnu::noinline]] int32_t nearest_place(const Model& m, const Zone& z, int side, const SurfacePoint& from);

// ---- facing_points.cpp

// The function whose zero is the facing point on an element.
struct Search {
  const Model& m;
  const Zone& z;
  const Place& from;
  int side;
  int32_t element, place;
  SurfaceElement surface;

  // Distance by which the point of side 1 lies ahead, for a point of the element. Not inlined, like the bounds.
  [[gnu::noinline]] double operator()(double eta) const;
};
Search search_in(const Model& m, const Zone& z, const Place& from, int side, int32_t place);
// Zero of f between a and b with the values fa and fb of opposite sign: false position, with the value at an end that is kept
// halved (Illinois), exact for a linear f. A value below the last digit of those at the ends counts as zero: repeated halving
// would make the end values as small, and the zero would drift.
double zero_between(double a, double b, double fa, double fb, const Search& f);

// ---- facing_pieces.cpp

// In the order of the zone, one unit per element.
double position(const Zone& z, const FacePoint& p);
// The `stop`-th cut of an element of side 1 at its own nodes, from 0; false beyond its end.
bool own_cut(const Model& m, const Zone& z, int32_t stop, double* eta);

// ---- free_zones.cpp

// Marks the ends of side 0 that nothing faces in the fitted zone (kFacesNothing). Tractions need this at every state.
void mark_unfaced_ends(const Model& m, int32_t zone);

} // namespace c2d::facing
