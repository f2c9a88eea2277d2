#pragma once
// Contact unknowns of a body among those of the model.
#include "model/model.hpp"

namespace c2d {

// Those of one zone, on one side: `count` of them follow each other on all lists.
struct UnknownRange {
  int32_t own, all, count; // the first: of the body, of the model
  int32_t zone, side;
  int32_t other, other_own; // the body on the other side, the first there
  double sign() const { return sign_of_side(side); }
};
// The next zone of body b, on any side; starts with no_range(). False after the last one.
constexpr UnknownRange no_range() { return {0, 0, 0, 0, -1, 0, 0}; }
bool next_range(const Model& m, int b, UnknownRange& range);
// visit(range) for every zone of body b.
template <class Visit> void for_ranges(const Model& m, int b, Visit visit) {
  for (UnknownRange range = no_range(); next_range(m, b, range);) visit(range);
}
// The next pair that body b has on a side; starts with first_pair_side(). False after the last one.
constexpr PairSide first_pair_side() { return {-1, 1}; }
bool next_pair_of(const Model& m, int b, PairSide& at);
// visit(pair, side) for every one.
template <class Visit> void for_pairs_of(const Model& m, int b, Visit visit) {
  for (PairSide at = first_pair_side(); next_pair_of(m, b, at);) visit(m.pair[at.pair], at.side);
}
// Does a body of the zone keep its equations (contact/reduction/reduction_plan.hpp)?
bool has_kept(const Model& m, int32_t zone);

} // namespace c2d
