// Numbering of a body after every element is bisected: elements, boundary points and functional nodes of each region, and the
// ranges of contact zones.
#include "program/estimate/mesh/cut_body.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace estimate {
namespace {

// Points closer than this fraction of the size of the body coincide, as in the library.
constexpr double kCoincident = 1e-10;

std::vector<Point> field(c2d_solver* solver, int32_t x, int32_t y, int32_t body, int32_t count) {
  std::vector<Point> out(static_cast<size_t>(count));
  if (count == 0) return out;
  need(c2d_get(solver, x, body, 1, count, &out[0].x, 2));
  need(c2d_get(solver, y, body, 1, count, &out[0].y, 2));
  return out;
}

// Step of the functional node numbers from element to element and the first number of a region, for the given elements
// (`children` null) or the bisected ones.
struct NodeCount {
  int32_t first, ring; // ring: number of nodes of a closed region; 0: open
};
NodeCount nodes_before(const CutBody& body, int32_t region, bool cut) {
  const int32_t step = std::max(body.function_nodes - 1, 1);
  int32_t first = 0;
  for (int32_t r = 0;; ++r) {
    const CutRegion& own = body.regions[CutBody::at(r)];
    const int32_t elements =
        cut ? body.children[CutBody::at(own.last) + 1] - body.children[CutBody::at(own.first)] : own.elements();
    if (r == region) return {first, own.open ? 0 : elements * step};
    first += elements * step + (own.open && body.function_nodes > 1 ? 1 : 0);
  }
}

} // namespace

void need(c2d_status status) {
  if (status != C2D_OK) throw std::runtime_error(c2d_message(status));
}

int32_t CutBody::region_of(int32_t element) const {
  int32_t r = 0;
  while (regions[at(r)].last < element) ++r;
  return r;
}

int32_t CutBody::first_point(int32_t region, int32_t element) const {
  int32_t open = 0;
  for (int32_t r = 0; r < region; ++r) open += regions[at(r)].open ? 1 : 0;
  return element * (element_nodes - 1) + open;
}

std::vector<Point> CutBody::points_of(int32_t region, int32_t element) const {
  const CutRegion& own = regions[at(region)];
  const int32_t first = first_point(region, element);
  std::vector<Point> out;
  for (int32_t k = 0; k < element_nodes; ++k) {
    const bool closes = element == own.last && k == element_nodes - 1 && !own.open;
    out.push_back(points[at(closes ? first_point(region, own.first) : first + k)]);
  }
  return out;
}

CutBody cut_body(c2d_solver* solver, int32_t body, int32_t function_nodes) {
  c2d_body_result sizes = C2D_INIT(c2d_body_result);
  need(c2d_get_body_result(solver, body, &sizes));
  CutBody out;
  out.element_nodes = sizes.element_nodes, out.function_nodes = function_nodes;
  out.youngs_modulus = sizes.youngs_modulus, out.poisson_ratio = sizes.poisson_ratio;
  for (int32_t r = 0; r < sizes.regions; ++r) {
    int32_t first = 0, last = 0;
    need(c2d_get_region(solver, body, r + 1, &first, &last));
    out.regions.push_back({first - 1, last - 1, r < sizes.open_regions});
  }
  out.points = field(solver, C2D_NODE_X, C2D_NODE_Y, body, sizes.points);
  out.surface = field(solver, C2D_SURFACE_X, C2D_SURFACE_Y, body, sizes.elements);
  out.in_contact.assign(static_cast<size_t>(sizes.elements), false);
  out.curve.assign(static_cast<size_t>(sizes.elements), -1);
  const double least = kCoincident * length(app::extent_of(out.points));
  out.children.push_back(0);
  for (int32_t e = 0; e < sizes.elements; ++e) {
    const std::vector<Point> p = out.points_of(out.region_of(e), e);
    const bool no_length = std::hypot(p.back().x - p.front().x, p.back().y - p.front().y) <= least;
    out.children.push_back(out.children.back() + (no_length ? 1 : 2));
  }
  return out;
}

bool goes_up(const CutBody& body, const Range& elements, int32_t count) {
  const bool by_numbers = elements.last >= elements.first;
  if (count == 0) return by_numbers;
  const CutRegion& region = body.regions[CutBody::at(body.region_of(elements.first))];
  const int32_t ring = region.elements(), distance = elements.last - elements.first;
  const auto fits = [&](int32_t way) { return (distance - way * (count - 1)) % ring == 0; };
  return by_numbers ? fits(1) : !fits(-1);
}

Range cut_elements(const CutBody& body, const Range& elements, bool up) {
  const auto first = [&](int32_t e) { return body.children[CutBody::at(e)]; };
  const auto last = [&](int32_t e) { return body.children[CutBody::at(e) + 1] - 1; };
  if (up) return {first(elements.first), last(elements.last)};
  return {last(elements.first), first(elements.last)};
}

bool goes_up(const CutBody& body, const c2d_zone& zone, int side) {
  const c2d_side& own = side == 1 ? zone.side1 : zone.side2;
  if (own.elements > 1) return goes_up(body, Range{own.first_element - 1, own.last_element - 1}, own.elements);
  return own.last_node == own.first_node ? side == 1 : own.last_node > own.first_node;
}

std::vector<int32_t> elements_of(const CutBody& body, const Range& elements, bool up) {
  const CutRegion& region = body.regions[CutBody::at(body.region_of(elements.first))];
  std::vector<int32_t> out = {elements.first};
  while (out.back() != elements.last) {
    int32_t next = out.back() + (up ? 1 : -1);
    if (next > region.last) next = region.first;
    if (next < region.first) next = region.last;
    out.push_back(next);
  }
  return out;
}

int32_t count_cut(const CutBody& body, const Range& elements, bool up) {
  int32_t count = 0;
  for (const int32_t e : elements_of(body, elements, up)) count += body.child_count(e);
  return count;
}

Range cut_nodes(const CutBody& body, const Range& elements, const Range& nodes, bool up) {
  const int32_t step = std::max(body.function_nodes - 1, 1), shared = body.function_nodes > 1 ? 1 : 0;
  const int32_t region = body.region_of(elements.first), from = body.regions[CutBody::at(region)].first;
  const NodeCount before = nodes_before(body, region, false), after = nodes_before(body, region, true);
  const Range cut = cut_elements(body, elements, up);
  const int32_t cut_from = body.children[CutBody::at(from)], way = up ? 1 : -1;
  // The node at the begin or end of a range of elements, and the offset of the first or last node of the zone inside it.
  const auto moved = [&](int32_t element, int32_t cut_element, int32_t node, bool begins) {
    const int32_t beyond = begins == up ? 0 : shared * step;
    const auto in_ring = [](int32_t i, int32_t ring) { return ring == 0 ? i : ((i % ring) + ring) % ring; };
    const int32_t inward = begins ? way : -way;
    int32_t inside = inward * (node - before.first - in_ring((element - from) * step + beyond, before.ring));
    if (before.ring > 0) inside = in_ring(inside, before.ring);
    return after.first + in_ring((cut_element - cut_from) * step + beyond + inward * inside, after.ring);
  };
  return {moved(elements.first, cut.first, nodes.first, true), moved(elements.last, cut.last, nodes.last, false)};
}

} // namespace estimate
