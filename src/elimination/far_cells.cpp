// Binary tree of clusters of elements with multipole series (METHOD 16.7): circles, series and chains of a leaf and of a
// parent.
//
// A parent takes the series of its halves over by translation (bie/far_field.cpp), so the elements are integrated once, at the
// leaves. A chain is a run of elements of which only the two ends matter: a uniform displacement on it has a closed form
// between its ends, METHOD (2.4). A closed chain contributes nothing, and chains that touch merge.
// Literature: Greengard and Rokhlin, J. Comput. Phys. 73 (1987).
#include "elimination/far_cells.hpp"

#include "memory/math.hpp"

namespace c2d {

double length_of(Complex v) { return sqrt(dot(v, v)); }

namespace {

bool are_same(Complex a, Complex b) { return a.re == b.re && a.im == b.im; }

// Adds a chain behind those of the cluster. A chain that returns to its start vanishes. Three chains mean "too many": such a
// cluster counts as near to every point.
void append(FarCell& cell, const Chain& next) {
  Chain* const last = cell.chains > 0 && cell.chains < 3 ? &cell.chain[cell.chains - 1] : nullptr;
  if (last && are_same(last->to, next.from)) {
    last->to = next.to;
    if (are_same(last->from, last->to)) --cell.chains;
  } else if (cell.chains < 2) {
    cell.chain[cell.chains++] = next;
  } else {
    cell.chains = 3;
  }
}

} // namespace

void Hull::take(Complex middle, double radius) {
  low = {fmin(low.re, middle.re - radius), fmin(low.im, middle.im - radius)};
  high = {fmax(high.re, middle.re + radius), fmax(high.im, middle.im + radius)};
}

void clear(FarCell& cell, Complex middle) {
  cell.field = FarField{};
  cell.field.middle = middle;
  cell.chains = 0;
}

void take_element(const Integrator& in, FarCell& cell) {
  const Element& e = in.element;
  // The circle must contain the whole element: the series converges only outside of it.
  cell.field.radius = fmax(cell.field.radius, length_of(middle_of(e) - cell.field.middle) + in.radius);
  append(cell, Chain{{e.x[0], e.y[0]}, {e.x[e.nodes - 1], e.y[e.nodes - 1]}});
}

void make_parent(const FarCell* child, double kappa, FarCell& cell) {
  Hull hull;
  for (int k = 0; k < 2; ++k)
    if (child[k].field.radius > 0.0) hull.take(child[k].field.middle, child[k].field.radius);
  clear(cell, hull.middle());
  if (hull.is_empty()) return;
  for (int k = 0; k < 2; ++k)
    if (child[k].field.radius > 0.0)
      cell.field.radius = fmax(cell.field.radius, length_of(child[k].field.middle - cell.field.middle) + child[k].field.radius);
  for (int k = 0; k < 2; ++k) {
    add_to_far_field(child[k].field, kappa, cell.field);
    for (int64_t i = 0; i < child[k].chains && i < 2; ++i) append(cell, child[k].chain[i]);
    if (child[k].chains > 2) cell.chains = 3;
  }
}

} // namespace c2d
