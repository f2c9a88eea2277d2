// Splits an element of side 1 of a free zone into pieces that face a single element of side 0 (METHOD 9.2).
//
// Tractions of side 1 are polynomial on its elements, kernels and functions of side 0 on its own. A product is smooth only
// between the nodes of both sides, so integrals over the transferred traction are computed piece by piece, as in segment-to-
// segment (mortar) methods. The walk proceeds along both sides at once: the next cut is the next node of side 1 or the next
// node of side 0, whichever comes first; the point that faces it on the other side is found by a root search.
#include "memory/math.hpp"
#include "model/facing.hpp"

#include "memory/hostile.hpp"
#include "model/geometry.hpp"

namespace c2d {
namespace facing {

double position(const Zone& z, const FacePoint& p) { return p.place + 0.5 * (1 + z.element_step[0] * p.eta); }

bool own_cut(const Model& m, const Zone& z, int32_t stop, double* eta) {
  const int f = m.head->function_nodes, cuts = f < 2 ? 3 : f;
  if (stop >= cuts) return false;
  const double at = node_eta(cuts, stop);
  *eta = z.element_step[1] > 0 ? at : -at;
  return true;
}

} // namespace facing

using namespace facing;

namespace {

// The point of side 0 that the `stop`-th cut faces. If a pair is there its facing point is stored and need not be searched.
bool face_own_cut(const Model& m, const Zone& z, int32_t stop, const FacePoint& at2, FacePoint& out) {
  const int32_t f = m.head->function_nodes, local = z.element_step[1] > 0 ? stop : f - 1 - stop;
  const int32_t pair = f > 1 ? pair_of_end(m, z.body[1], at2.element, local).pair : -1;
  const bool known = pair >= 0 && m.pair[pair].node[1] == functional_node(m, z.body[1], at2.element, local);
  if (!known) return face_point(m, z, at2, out);
  ZonePlace faced;
  out.element = m.pair[pair].element;
  out.eta = m.pair[pair].eta;
  const bool in_zone = find_contact_element(m, z.body[0], out.element, &faced);
  if (C2D_NEVER(!in_zone)) return false; // what a pair's node faces is
  out.place = faced.place;
  return true;
}

// The next node or end of the element of side 0 after `eta`, in the order of the zone.
double next_cut(const Model& m, const Zone& z, double eta) {
  const int f = m.head->function_nodes, step = z.element_step[0];
  double next = step;
  for (int l = 0; l < f; ++l) {
    const double node = node_eta(f, l);
    if (step * (node - eta) > kSnap && step * (node - next) < 0) next = node;
  }
  return next;
}

// Local coordinate on the element of side 1, between two known points, of the point that faces a node of side 0. Not inlined:
// its frame must not add to that of the search for the next target.
[[gnu::noinline]] double face_within(const PieceWalk& w, const FacePoint& at1) {
  const Model& m = *w.m;
  const Zone& z = *w.z;
  const Place p1 = place_at(m, z, 0, at1);
  const Search off = search_in(m, z, p1, 1, w.place2);
  return zero_between(w.eta2, w.target_eta2, off(w.eta2), off(w.target_eta2), off);
}

} // namespace

PieceWalk start_pieces(const Model& m, const Zone& z, int32_t place2) {
  PieceWalk walk{&m, &z, zone_element(m, z, 1, place2), place2, 1, {}, {}, 0, 0};
  own_cut(m, z, 0, &walk.eta2);
  if (!face_own_cut(m, z, 0, FacePoint{walk.element2, place2, walk.eta2}, walk.now)) walk.stop = INT32_MAX - 1;
  walk.target = walk.now;
  walk.target_eta2 = walk.eta2;
  return walk;
}

bool next_piece(PieceWalk& w, FacingPiece& out) {
  const Model& m = *w.m;
  const Zone& z = *w.z;
  const int32_t count = zone_elements(z, 0);
  if (w.eta2 == w.target_eta2) { // the next node of side 1 becomes the target
    if (!own_cut(m, z, w.stop, &w.target_eta2)) return false;
    if (!face_own_cut(m, z, w.stop, FacePoint{w.element2, w.place2, w.target_eta2}, w.target)) return false;
    ++w.stop;
  }
  if (z.element_step[0] * w.now.eta >= 1 - kSnap) { // continue on the next element of side 0
    w.now = point_at(m, z, 0, w.now.place + 1 < count ? w.now.place + 1 : 0, -z.element_step[0]);
  }
  double goal = position(z, w.target);
  if (goal < position(z, w.now) - 0.5 * count) goal += count; // the target lies beyond the start of a ring
  FacePoint cut = w.now;
  cut.eta = next_cut(m, z, w.now.eta);
  const double beyond = position(z, cut) - goal;
  out.element1 = w.now.element;
  out.eta1[0] = w.now.eta;
  out.eta2[0] = w.eta2;
  // The target comes before the next node of side 0: the piece ends at a node of side 1. Otherwise it ends at a node of side 0;
  // if both coincide within kSnap, at both.
  if (beyond > kSnap)
    w.now.eta = w.target.eta;
  else
    w.now.eta = cut.eta;
  w.eta2 = beyond >= -kSnap ? w.target_eta2 : face_within(w, cut);
  out.eta1[1] = w.now.eta;
  out.eta2[1] = w.eta2;
  return true;
}

} // namespace c2d
