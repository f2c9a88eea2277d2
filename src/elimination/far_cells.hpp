#pragma once
// Binary tree of clusters over the elements of a body in the order of its contour. Far away a cluster acts through a short
// series (bie/far_field.hpp). Used for right-hand sides and diagonals of large bodies (elimination/far_sums.hpp) and for
// interior points (results/interior/interior_cells.hpp).
#include "bie/far_field.hpp"
#include "bie/measure.hpp"
#include "elimination/cells.hpp"
#include "memory/hostile.hpp"
#include "model/model.hpp"

namespace c2d {

constexpr int32_t kCellElements = kHostile ? 3 : 40, kLeastElements = kHostile ? 12 : 400; // of a leaf; of a body with a tree

// A cluster of consecutive elements. A uniform displacement on it depends on its ends alone. A whole closed region has no
// ends, so a cluster has two chains at most, except where lines of symmetry cut off many.
struct FarCell {
  FarField field;
  Chain chain[2];
  int64_t chains; // 3: more than are stored; such a cluster counts as near to all points
};

// All clusters, from the root on, depth by depth.
struct FarCells {
  Complex* rest; // a displacement that is subtracted from all others
  FarCell* cell;
  int32_t elements, depth;
  FarCell& at(int32_t d, int32_t i) const { return cell[(int64_t{1} << d) - 1 + i]; }
};

inline bool may_have_far_cells(int32_t elements) { return elements >= kLeastElements; }
inline uint64_t far_cells_bytes(int32_t elements) {
  if (!may_have_far_cells(elements)) return 0;
  return sizeof(Complex) + ((uint64_t{2} << tree_depth(elements, kCellElements)) - 1) * sizeof(FarCell);
}
inline FarCells far_cells_in(void* memory, int32_t elements) {
  char* const from = static_cast<char*>(memory);
  return FarCells{reinterpret_cast<Complex*>(from), reinterpret_cast<FarCell*>(from + sizeof(Complex)), elements,
                  tree_depth(elements, kCellElements)};
}

// Circle, chains and series of a cluster from its two halves. Material: kappa = 3 - 4 nu.
void make_parent(const FarCell* child, double kappa, FarCell& cell);

// ---- circles of leaves ----------------------------------------------------------------------------------------------------

double length_of(Complex v);
inline Complex middle_of(const Element& e) { return {e.c[0][0], e.c[0][1]}; }

// The bounding box of circles; its centre is that of the enclosing circle.
struct Hull {
  Complex low = {1e300, 1e300}, high = {-1e300, -1e300};
  void take(Complex middle, double radius);
  bool is_empty() const { return low.re > high.re; }
  Complex middle() const { return 0.5 * (low + high); }
};
// A cluster without series and chains.
void clear(FarCell& cell, Complex middle);
// Adds one element of a leaf, behind those before it: its circle and its chain.
void take_element(const Integrator& in, FarCell& cell);

// Circle and chains of a leaf from those of the elements first ... last-1 that count. A radius of 0: there are none.
template <class Counts> void bound_leaf(const Model& m, int b, int32_t first, int32_t last, Counts counts, FarCell& cell) {
  Integrator in;
  Hull hull;
  for (int32_t element = first; element < last; ++element) {
    if (!counts(element)) continue;
    make_integrator(m, b, element, Quadrature::accurate, Measure::own_length, in);
    hull.take(middle_of(in.element), in.radius);
  }
  clear(cell, hull.middle());
  for (int32_t element = first; element < last; ++element) {
    if (!counts(element)) continue;
    make_integrator(m, b, element, Quadrature::accurate, Measure::own_length, in);
    take_element(in, cell);
  }
}

// ---- traversal ------------------------------------------------------------------------------------------------------------

constexpr int32_t kDeepest = 31;
constexpr int32_t kBlockOfPoints = 1024; // so many stay in the cache

// Points of a block, the first `count` rows of `order`, descend from the root. Those that are near a cluster move to the front
// and meet both of its halves, or at a leaf the elements themselves.
template <class Visitor> void walk(const FarCells& cells, uint16_t* order, int32_t count, const Visitor& visitor) {
  int32_t left[kDeepest + 1];
  left[0] = count;
  for (int32_t d = 0, i = 0;;) {
    const FarCell& cell = cells.at(d, i);
    int32_t near = 0;
    for (int32_t k = 0; k < left[d]; ++k) {
      const uint16_t row = order[k];
      if (!visitor.is_near(cell, row)) {
        visitor.meet(cell, row);
        continue;
      }
      order[k] = order[near];
      order[near++] = row;
    }
    if (near > 0 && d < cells.depth) {
      left[++d] = near;
      i *= 2;
      continue;
    }
    if (near > 0) visitor.meet_elements(leaf_begin(cells.elements, d, i), leaf_begin(cells.elements, d, i + 1), order, near);
    for (; (i & 1) != 0; i /= 2) --d;
    if (d == 0) return;
    ++i;
  }
}

} // namespace c2d
