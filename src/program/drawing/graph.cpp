#include "program/drawing/graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drawing {
namespace {

// Sets of numbers that are joined step by step.
class Sets {
public:
  explicit Sets(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), size_t{0}); }
  size_t root(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(size_t i, size_t j) {
    const size_t a = root(i), b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<size_t> parent_;
};

Point end_point(const std::vector<Curve>& curves, size_t end) {
  return end % 2 == 0 ? curves[end / 2].begin : curves[end / 2].end;
}

Sets near_ends(const std::vector<Curve>& curves, double tolerance) {
  const size_t n = 2 * curves.size();
  Sets sets(n);
  std::vector<size_t> order(n);
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t i, size_t j) {
    const Point p = end_point(curves, i), q = end_point(curves, j);
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : i < j;
  });
  // Of equal ends only the first looks further, so that many curves that meet in one joint cost no more.
  for (size_t i = 0; i < n; ++i) {
    const Point p = end_point(curves, order[i]);
    for (size_t j = i + 1; j < n; ++j) {
      const Point q = end_point(curves, order[j]);
      if (q.x - p.x > tolerance) break;
      if (sketch::length(q - p) > tolerance) continue;
      sets.join(order[i], order[j]);
      if (q.x == p.x && q.y == p.y) break;
    }
  }
  return sets;
}

struct Leaving { // a half edge as it leaves a joint
  size_t half;
  double angle, curvature;
};

std::vector<Leaving> leaving(const Graph& graph) {
  std::vector<Leaving> out;
  for (size_t i = 0; i < graph.curves.size(); ++i) {
    const sketch::ShapePtr shape = shape_of(graph.curves[i]);
    const Point begin = shape->tangent(0), end = -1.0 * shape->tangent(1);
    out.push_back({2 * i, std::atan2(begin.y, begin.x), shape->curvature(0)});
    out.push_back({2 * i + 1, std::atan2(end.y, end.x), -shape->curvature(1)});
  }
  return out;
}

// Half edges that leave a joint, counter-clockwise: by angle, and those that touch by curvature.
void sort_around(std::vector<Leaving>& around) {
  constexpr double kTouch = 1e-6;
  std::sort(around.begin(), around.end(),
            [](const Leaving& a, const Leaving& b) { return a.angle != b.angle ? a.angle < b.angle : a.half < b.half; });
  // Angles of -pi and pi are one direction.
  if (around.size() > 1) {
    size_t gap = 0;
    while (gap + 1 < around.size() && around[gap + 1].angle - around[gap].angle < kTouch) ++gap;
    if (gap + 1 < around.size()) std::rotate(around.begin(), around.begin() + static_cast<ptrdiff_t>(gap) + 1, around.end());
  }
  for (size_t first = 0; first < around.size();) {
    size_t last = first + 1;
    while (last < around.size() &&
           std::fabs(std::remainder(around[last].angle - around[last - 1].angle, 2 * std::acos(-1.0))) < kTouch)
      ++last;
    std::stable_sort(around.begin() + static_cast<ptrdiff_t>(first), around.begin() + static_cast<ptrdiff_t>(last),
                     [](const Leaving& a, const Leaving& b) { return a.curvature < b.curvature; });
    first = last;
  }
}

} // namespace

void Graph::keep(const std::vector<bool>& kept) {
  size_t n = 0;
  for (size_t i = 0; i < curves.size(); ++i)
    if (kept[i]) {
      if (n != i) curves[n] = std::move(curves[i]);
      ends[n++] = ends[i];
    }
  curves.resize(n);
  ends.resize(n);
}

Graph graph_of(std::vector<Curve> curves, double tolerance) {
  Graph graph;
  Sets sets = near_ends(curves, tolerance);
  const size_t n = 2 * curves.size();
  std::vector<size_t> number(n, n);
  std::vector<bool> is_line;
  graph.ends.resize(curves.size());
  for (size_t end = 0; end < n; ++end) {
    const size_t root = sets.root(end);
    const bool line = curves[end / 2].kind == Curve::kLine;
    if (number[root] == n) {
      number[root] = graph.joints.size();
      graph.joints.push_back(end_point(curves, end));
      is_line.push_back(line);
    } else if (is_line[number[root]] && !line) {
      graph.joints[number[root]] = end_point(curves, end);
      is_line[number[root]] = false;
    }
    graph.ends[end / 2][end % 2] = number[root];
  }
  for (size_t end = 0; end < n; ++end)
    graph.moved.push_back(sketch::length(end_point(curves, end) - graph.joints[graph.ends[end / 2][end % 2]]));
  for (size_t i = 0; i < curves.size(); ++i)
    move_ends(curves[i], graph.joints[graph.ends[i][0]], graph.joints[graph.ends[i][1]]);
  graph.curves = std::move(curves);
  return graph;
}

std::vector<int> degrees(const Graph& graph) {
  std::vector<int> out(graph.joints.size(), 0);
  for (const auto& ends : graph.ends)
    for (const size_t end : ends) ++out[end];
  return out;
}

std::vector<std::vector<size_t>> faces_of(const Graph& graph) {
  std::vector<std::vector<Leaving>> around(graph.joints.size());
  for (const Leaving& one : leaving(graph)) around[graph.start(one.half)].push_back(one);
  std::vector<size_t> next(2 * graph.curves.size());
  for (std::vector<Leaving>& list : around) {
    sort_around(list);
    // Who arrives by the twin of one that leaves goes on with the one clockwise of it.
    for (size_t i = 0; i < list.size(); ++i) next[list[i].half ^ 1] = list[(i + list.size() - 1) % list.size()].half;
  }
  std::vector<std::vector<size_t>> faces;
  std::vector<bool> seen(next.size(), false);
  for (size_t half = 0; half < next.size(); ++half) {
    if (seen[half]) continue;
    faces.emplace_back();
    for (size_t h = half; !seen[h]; h = next[h]) {
      seen[h] = true;
      faces.back().push_back(h);
    }
  }
  return faces;
}

std::vector<size_t> parts_of(const Graph& graph) {
  Sets sets(graph.joints.size());
  for (const auto& ends : graph.ends) sets.join(ends[0], ends[1]);
  std::vector<size_t> out(graph.joints.size());
  for (size_t i = 0; i < out.size(); ++i) out[i] = sets.root(i);
  return out;
}

} // namespace drawing
