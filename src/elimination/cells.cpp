#include "elimination/cells.hpp"

#include "memory/math.hpp"

namespace c2d {

namespace {

constexpr int kSamples = 48; // of a cell's nodes, to compare cuts

struct Place {
  double x, y;
};

struct Cell {
  const double* point;
  int32_t* order;
  int32_t first, count;
  Place at(int32_t k) const {
    const double* p = point + 2 * static_cast<int64_t>(order[first + k]);
    return Place{p[0], p[1]};
  }
  double coordinate(int32_t k, int axis) const { return axis == 0 ? at(k).x : at(k).y; }
};

// The k-th smallest (from 0) coordinate of a cell's nodes. `room` [count] is used.
double kth_coordinate(const Cell& cell, int axis, int32_t k, int32_t* room) {
  const auto value = [&](int32_t i) { return cell.coordinate(room[i], axis); };
  for (int32_t i = 0; i < cell.count; ++i) room[i] = i;
  int32_t low = 0, high = cell.count - 1;
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

// How near two halves are to each other: the sum over samples of their share of the curve over the distance to the other half.
// (Where many nodes have the middle's coordinate, all samples may be on one side of it: such a cut is no good.)
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

int best_cut(const Cell& cell, const double middle[2]) {
  Place p[kSamples];
  bool upper[kSamples];
  const int samples = cell.count < kSamples ? cell.count : kSamples;
  double least = -1.0;
  int best = kAlongContour;
  for (int i = 0; i < samples; ++i) p[i] = cell.at(static_cast<int32_t>(static_cast<int64_t>(cell.count) * i / samples));
  for (int cut = kAlongContour; cut >= 0; --cut) { // of two that are as good the first
    for (int i = 0; i < samples; ++i)
      upper[i] = cut == kAlongContour ? 2 * i >= samples : (cut == 0 ? p[i].x : p[i].y) > middle[cut];
    const double near = nearness(p, upper, samples);
    if (least >= 0.0 && !(near < 0.75 * least)) continue;
    least = near;
    best = cut;
  }
  return best;
}

// The nodes with the `half` smallest coordinates first, otherwise as they were; of equal ones the first.
void part_by(const Cell& cell, int axis, double middle, int32_t half, int32_t* room) {
  int32_t below = 0;
  for (int32_t k = 0; k < cell.count; ++k) below += cell.coordinate(k, axis) < middle ? 1 : 0;
  int32_t equal = half - below, low = 0, high = half;
  for (int32_t k = 0; k < cell.count; ++k) {
    const double at = cell.coordinate(k, axis);
    const bool first = at < middle || (at == middle && equal-- > 0);
    room[first ? low++ : high++] = cell.order[cell.first + k];
  }
  for (int32_t k = 0; k < cell.count; ++k) cell.order[cell.first + k] = room[k];
}

void halve(const Cell& cell, int32_t half, int32_t* room) {
  if (half == 0) return;
  double middle[2];
  for (int axis = 0; axis < 2; ++axis) middle[axis] = kth_coordinate(cell, axis, half, room);
  const int cut = best_cut(cell, middle);
  if (cut != kAlongContour) part_by(cell, cut, middle[cut], half, room);
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
      halve(Cell{point, order, first, end - first}, middle - first, room);
    }
}

} // namespace c2d
