#pragma once
// What the pairs can do to the free motions of the bodies, as a cone of forces, and how much of a load it balances.
#include "contact/body_unknowns.hpp"
#include "contact/contact_tape.hpp"
#include "contact/path.hpp"

namespace c2d {

// A pair's p or q works on the motions of the two bodies that meet there.
struct Ray {
  int32_t first[2], count[2]; // on a side: the body's motions
  double of[2][kMostMotions];
};
double work(const Ray& a, const double* motion);
double length(const Ray& a);
void add_to(double* to, double factor, const Ray& a);
// Of numbers for all motions.
double length(const double* a, int32_t n);
void copy(const double* from, int32_t n, double* to);

enum class Friction { own, none, rough, ties }; // a pair's own, or as if there were none, or no bound; nothing but ties

// In use: which ray of which pair.
struct Chosen {
  int32_t pair, ray;
};

// What the analysis works with, in the place of the rate problem.
struct ForceCone {
  Follower& f;
  const Model& m;
  PathScales scales;
  int32_t motions;
  Friction law;
  Real* resultant;                // [2 sides][m][kMostMotions]: what a pair's p or q does to the motions of the body there
  double* load;                   // [motions] what is to be balanced,
  double* rest;                   // [motions] what of it is not,
  double* handed;                 // [motions] or what ties alone hand on to other motions
  double *unit, *triangle;        // [motions][motions]: orthonormal basis of the rays in use
  double *factor, *wanted, *part; // [motions] of the rays in use
  Chosen* chosen;                 // [motions]
  int32_t count, based;           // of rays in use; of the first of them, whose units stand already

  Real* resultants_of(const Pair& pair, int side, int slot) const {
    return resultant + (static_cast<int64_t>(side) * f.t->m + pair.dof + slot) * kMostMotions;
  }
  Ray of(const Pair& pair, int slot) const;
  int rays_of(const Doubt& d, bool in_doubt, Ray out[4]) const;
  double* unit_of(int32_t k) const { return unit + static_cast<int64_t>(k) * motions; }
  double& in_triangle(int32_t i, int32_t k) const { return triangle[static_cast<int64_t>(k) * motions + i]; }
};

// One for this state, with the place for a column of all unknowns of a body. The second stands where the tableau does, too.
// `load` is null if there is no room for it (bodies that a few pairs hold, one by one).
ForceCone force_cone(Follower& f, Real** column);
ForceCone cone_for_tableau(Follower& f, Real** column);
// visit(pair, side, slot) for the contact unknowns of body b.
template <class Visit> void for_slots_of(const Model& m, int b, Visit visit) {
  for (PairSide at = first_pair_side(); next_pair_of(m, b, at);)
    for (int slot = 0; slot <= m.pair[at.pair].tangential; ++slot) visit(m.pair[at.pair], at.side, slot);
}
// Columns of body b from the tape, one for each of its motions, to the resultants. Errors: the block store's.
c2d_status read_columns(const ForceCone& cone, int b, BodyMatrix matrix, Real* column);
// A row of resultants combined anew: row . mix.
void mix_row(Real* row, int32_t count, const double mix[kMostMotions][kMostMotions]);

// What of the load the pairs cannot balance, to `rest`; false: nothing. The rest is the motion on which the loads do work that
// no force of a pair opposes, in the metric of the motions.
bool is_unbalanced(ForceCone& cone, Friction law);
// What keeps the bodies from their equilibrium: friction, if without bounds there is one (gross sliding); that one turns over,
// if pressure takes part of the load (tipping); that it comes off (free motion). Changes `rest`.
c2d_outcome kind_of_motion(ForceCone& cone);
// Whose part in `rest` is the largest? -1: nobody's.
int32_t body_in_motion(const ForceCone& cone);

} // namespace c2d
