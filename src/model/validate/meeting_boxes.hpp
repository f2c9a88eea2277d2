#pragma once
// Pairs of elements or points whose bounding boxes overlap, found by recursive bisection.
#include "memory/math.hpp"
#include "model/geometry.hpp"

namespace c2d {

constexpr int32_t kBoxes = 32;

inline void widen(Box& box, const Box& by) {
  box.x_min = fmin(box.x_min, by.x_min);
  box.x_max = fmax(box.x_max, by.x_max);
  box.y_min = fmin(box.y_min, by.y_min);
  box.y_max = fmax(box.y_max, by.y_max);
}

struct IndexRange {
  int32_t first, end;
  int32_t count() const { return end - first; }
  int32_t middle() const { return first + count() / 2; }
  IndexRange half(int which) const { return which == 0 ? IndexRange{first, middle()} : IndexRange{middle(), end}; }
};

template <class BoxOf> Box box_around_all(const IndexRange& range, BoxOf box_of) {
  Box all = box_of(range.first);
  for (int32_t i = range.first + 1; i < range.end; ++i) widen(all, box_of(i));
  return all;
}

// Calls visit(i, j) for i in `a` and j in `b`, i <= j, whose boxes overlap, until it returns true; returns whether it did. The
// ranges are equal or disjoint. Halves whose boxes do not overlap are skipped. Boxes are recomputed instead of stored: no
// memory, and O(n log n) of them for a boundary.
template <class BoxOf, class Visit> bool visit_meeting(const IndexRange& a, const IndexRange& b, BoxOf box_of, Visit visit) {
  const bool same = a.first == b.first;
  if (!same && !boxes_meet(box_around_all(a, box_of), box_around_all(b, box_of))) return false;
  if (a.count() > kBoxes || b.count() > kBoxes) {
    for (int i = 0; i < 2; ++i)
      for (int j = same ? i : 0; j < 2; ++j)
        if (visit_meeting(a.half(i), b.half(j), box_of, visit)) return true;
    return false;
  }
  Box box[kBoxes];
  for (int32_t j = b.first; j < b.end; ++j) box[j - b.first] = box_of(j);
  for (int32_t i = a.first; i < a.end; ++i) {
    const Box own = same ? box[i - a.first] : box_of(i);
    for (int32_t j = same ? i : b.first; j < b.end; ++j)
      if (boxes_meet(own, box[j - b.first]) && visit(i, j)) return true;
  }
  return false;
}

} // namespace c2d
