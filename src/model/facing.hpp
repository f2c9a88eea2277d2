#pragma once
// What the files of free_zones.hpp share: a zone's surfaces, bounds that spare most of a search, what it looks for.
#include "model/free_zones.hpp"

namespace c2d::facing {

constexpr double kSnap = 1e-9; // local coordinates nearer to a node are the node's

// ---- zone_surface.cpp

// Does a side go round a closed curve?
bool is_ring(const Model& m, const Zone& z, int side);
// The place of the element that meets the one at a place at its start (-1) or end (1), -1: none in the zone.
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

// ---- facing_bounds.cpp. None of them is inlined where it is called: what looks for a facing point goes deep.

// Of an element of 2 to 4 points: no less than element_length(), and no more than 1.26 or 2.02 of the chords, at a small part
// of its price.
double length_at_most(int nodes, const double* x, const double* y);
// Is every point of a surface over an element farther off than the root of `square`? False may be wrong, true is not: the
// surface stays within half the element's length of it.
[[gnu::noinline]] bool is_beyond(const Model& m, int b, int32_t element, const SurfacePoint& from, double square);
// Are values at the ends of an element within kSnap of its length of zero?
struct Closeness {
  bool start, end;
};
[[gnu::noinline]] Closeness closeness(const Model& m, int b, int32_t element, double start, double end);
// The element of a side whose middle is nearest: what faces a point is most likely on it, and all that is farther off than
// that need not be looked at.
[[gnu::noinline]] int32_t nearest_place(const Model& m, const Zone& z, int side, const SurfacePoint& from);

// ---- facing_points.cpp

// What an element of a side has opposite a place of the other.
struct Search {
  const Model& m;
  const Zone& z;
  const Place& from;
  int side;
  int32_t element, place;
  SurfaceElement surface;

  // How far side 1's point lies ahead, for a point of the element. (Not inlined, like the bounds.)
  [[gnu::noinline]] double operator()(double eta) const;
};
Search search_in(const Model& m, const Zone& z, const Place& from, int side, int32_t place);
// Zero of f between a and b, where it has the values fa and fb of unlike sign: false position, with the value
// at an end that stays halved (Illinois), exact for a linear f. A value within the last digit of those at the ends is zero:
// halved a hundred times, they would become as small, and the zero wander off.
double zero_between(double a, double b, double fa, double fb, const Search& f);

// ---- facing_pieces.cpp

// In the order of the zone, one unit per element.
double position(const Zone& z, const FacePoint& p);
// The `stop`-th place at which an element of side 1 is cut for its own nodes, from 0; false beyond its end.
bool own_cut(const Model& m, const Zone& z, int32_t stop, double* eta);

// ---- free_zones.cpp

// Tells the ends of side 0 that nothing faces, in the zone as it is kept (kFacesNothing). Every state's tractions ask for it.
void mark_unfaced_ends(const Model& m, int32_t zone);

} // namespace c2d::facing
