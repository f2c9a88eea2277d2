// Binary tree of clusters over the nodes of a body (METHOD 7.6), by bisection.
//
// For each cluster, from the root down:
// 1. Find the median coordinate in x and in y (quickselect: Hoare, Communications of the ACM 4 (1961), Algorithm 65).
// 2. Compare three cuts into equal halves: along the contour, at the median x, at the median y. The measure is the sum over
//    sample nodes of (spacing in its own half) / (distance to the other half), an integral of ds / distance.
// 3. Take the cut with the smallest measure. The coupling of two halves has low rank only if they touch each other in few
//    places: in a thin layer a cut along the contour would separate its two faces, which are close everywhere.
// Equal halves keep all leaves at one depth, so the work area is known beforehand. Cluster trees by geometric bisection:
// Bebendorf, Hierarchical Matrices (Springer, 2008).
#include "elimination/cells.hpp"

#include "memory/math.hpp"

namespace c2d {

namespace {

constexpr int kSamples = 48; // nodes of a cluster that are compared: the measure costs their square

struct Place {
  double x, y;
};

struct Cluster {
  const double* point;
  int32_t* order;
  int32_t first, count;
  Place at(int32_t k) const {
    const double* p = point + 2 * static_cast<int64_t>(order[first + k]);
    return Place{p[0], p[1]};
  }
  double coordinate(int32_t k, int axis) const { return axis == 0 ? at(k).x : at(k).y; }
};

// The k-th smallest (from 0) coordinate of a cluster's nodes, by quickselect: linear time, and the order of the contour is not
// disturbed. `room` [count] is used.
double kth_coordinate(const Cluster& cluster, int axis, int32_t k, int32_t* room) {
  const auto value = [&](int32_t i) { return cluster.coordinate(room[i], axis); };
  for (int32_t i = 0; i < cluster.count; ++i) room[i] = i;
  int32_t low = 0, high = cluster.count - 1;
  while (low < high) {
    const double pivot = value(low + (high - low) / 2);
    int32_t i = low, j = high;
    while (i <= j) {
      while (value(i) < pivot) ++i;
      while (value(j) > pivot) --j;
      if (i > j) break;
      const int32_t kept = room[i];
      room[i++] = room[j];
      room[j--] = kept;
    }
    if (k <= j)
      high = j;
    else if (k >= i)
      low = i;
    else
      break;
  }
  return value(k);
}

// Measure of a cut: how close its halves are. A sample without a neighbour in the other half (all samples on one side, where
// many nodes have the median coordinate) counts fully, so that such a cut is rejected.
double nearness(const Place* p, const bool* upper, int samples) {
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    double nearest = -1.0, own = -1.0;
    for (int j = 0; j < samples; ++j) {
      const double d = hypot(p[i].x - p[j].x, p[i].y - p[j].y);
      double& to = upper[i] == upper[j] ? own : nearest;
      if (j != i && d > 0.0 && (to < 0.0 || d < to)) to = d;
    }
    sum += nearest > 0.0 && own > 0.0 && own < nearest ? own / nearest : 1.0;
  }
  return sum;
}

constexpr int kAlongContour = 2; // and 0, 1: by that coordinate

int best_cut(const Cluster& cluster, const double middle[2]) {
  Place p[kSamples];
  bool upper[kSamples];
  const int samples = cluster.count < kSamples ? cluster.count : kSamples;
  double least = -1.0;
  int best = kAlongContour;
  for (int i = 0; i < samples; ++i) p[i] = cluster.at(static_cast<int32_t>(static_cast<int64_t>(cluster.count) * i / samples));
  for (int cut = kAlongContour; cut >= 0; --cut) { // of equally good cuts the first
    for (int i = 0; i < samples; ++i)
      upper[i] = cut == kAlongContour ? 2 * i >= samples : (cut == 0 ? p[i].x : p[i].y) > middle[cut];
    const double near = nearness(p, upper, samples);
    // Only a clearly better cut replaces the contour's order, in which neighbours share elements.
    if (least >= 0.0 && !(near < 0.75 * least)) continue;
    least = near;
    best = cut;
  }
  return best;
}

// The `half` nodes with the smallest coordinates come first; within each half the order stays. Of nodes with the median
// coordinate the first ones go to the first half, so that no rounding decides.
void part_by(const Cluster& cluster, int axis, double middle, int32_t half, int32_t* room) {
  int32_t below = 0;
  for (int32_t k = 0; k < cluster.count; ++k) below += cluster.coordinate(k, axis) < middle ? 1 : 0;
  int32_t equal = half - below, low = 0, high = half;
  for (int32_t k = 0; k < cluster.count; ++k) {
    const double at = cluster.coordinate(k, axis);
    const bool first = at < middle || (at == middle && equal-- > 0);
    room[first ? low++ : high++] = cluster.order[cluster.first + k];
  }
  for (int32_t k = 0; k < cluster.count; ++k) cluster.order[cluster.first + k] = room[k];
}

void halve(const Cluster& cluster, int32_t half, int32_t* room) {
  if (half == 0) return;
  double middle[2];
  for (int axis = 0; axis < 2; ++axis) middle[axis] = kth_coordinate(cluster, axis, half, room);
  const int cut = best_cut(cluster, middle);
  if (cut != kAlongContour) part_by(cluster, cut, middle[cut], half, room);
}

} // namespace

int32_t tree_depth(int32_t nodes, int32_t leaf) {
  int32_t depth = 0;
  while (leaf_begin(nodes, depth, (1 << depth)) - leaf_begin(nodes, depth, (1 << depth) - 1) > leaf) ++depth;
  return depth;
}

// Each half of n has n / 2 or one more: leaf i begins at the floor of i nodes / 2^depth.
int32_t leaf_begin(int32_t nodes, int32_t depth, int32_t leaf) {
  return static_cast<int32_t>((static_cast<int64_t>(nodes) * leaf) >> depth);
}

void order_nodes(const double* point, int32_t nodes, int32_t depth, int32_t* order, int32_t* room) {
  for (int32_t d = 0; d < depth; ++d)
    for (int32_t i = 0; i < 1 << d; ++i) {
      const int32_t first = leaf_begin(nodes, d, i), end = leaf_begin(nodes, d, i + 1);
      const int32_t middle = leaf_begin(nodes, d + 1, 2 * i + 1);
      halve(Cluster{point, order, first, end - first}, middle - first, room);
    }
}

} // namespace c2d
