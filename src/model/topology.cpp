// Connectivity of nodes, elements, element ends, zones and pairs.
//
// Every region is a curve of its own: closed, or open between symmetry lines. Numbering is by formula, without tables: element
// e of a closed region has the geometry nodes e (n-1) ... (e+1) (n-1), the last node of its last element being the first of its
// first; an open region has one node more, so all regions after it are shifted by one (Region::shift). This costs no memory,
// which matters on microcontrollers, and a search over the few regions of a body.
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/geometry.hpp"
#include "model/model.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

namespace {

// Increment of functional node numbers from one end of an element to the other.
int32_t nodes_per_element(const Model& m) { return m.head->function_nodes == 1 ? 1 : m.head->function_nodes - 1; }

// A functional node as a local node of the element that begins at it or contains it; the end of an open region is the last
// local node of its last element.
struct NodePlace {
  int32_t element, local;
  const Region* region; // null for constant functions, whose nodes are the elements
};

NodePlace place_of_node(const Model& m, int b, int32_t node) {
  if (m.head->function_nodes == 1) return NodePlace{node, 0, nullptr};
  const int32_t steps = nodes_per_element(m), regions = body_of(m, b).regions;
  const Region* r = m.region[b];
  for (int32_t i = 0; i + 1 < regions && node > (r->last + 1) * steps - 1 + r->shift + r->open; ++i) ++r;
  const int32_t place = node - r->shift;
  if (place == (r->last + 1) * steps) return NodePlace{r->last, steps, r};
  return NodePlace{place / steps, place % steps, r};
}

// The element that ends where the node's begins; -1 at the start of an open region.
int32_t element_before(const NodePlace& at) {
  if (at.element != at.region->first) return at.element - 1;
  return at.region->open ? -1 : at.region->last;
}

// Local to this file, so that the compiler can inline it: it is called for every node.
const Region* region_with(const Model& m, int b, int32_t element) {
  const Region* r = m.region[b];
  for (const Region* const last = r + body_of(m, b).regions - 1; r < last && element > r->last;) ++r;
  return r;
}

// Position k = 0, 1, ... of `number` in the sequence first, first + step, ... over the cyclic range first_in ... last_in, or -1
// beyond the end of an open range.
int32_t place_in_range(int32_t number, int32_t first, int32_t step, int32_t first_in, int32_t last_in, bool open) {
  if (number < first_in || number > last_in) return -1;
  const int32_t place = step > 0 ? number - first : first - number;
  if (place < 0) return open ? -1 : place + (last_in - first_in + 1);
  return place;
}

int32_t number_in_range(int32_t k, int32_t first, int32_t step, int32_t first_in, int32_t last_in) {
  const int32_t size = last_in - first_in + 1;
  const int32_t place = (first - first_in + (step > 0 ? k : -k)) % size;
  return first_in + (place < 0 ? place + size : place);
}

bool ends_coincide(const Model& m, int b, int32_t element, double near) {
  if (body_of(m, b).element_nodes != 2) return false;
  const double* p = m.xy[b] + 2 * geometry_node(m, b, element, 0);
  const double* q = m.xy[b] + 2 * geometry_node(m, b, element, 1);
  return fabs(p[0] - q[0]) <= near && fabs(p[1] - q[1]) <= near;
}

// As is_zero_length, local to this file. After measure_elements the result is stored; while the model is built, and points may
// still be missing, the ends are compared.
bool has_no_length(const Model& m, int b, int32_t element) {
  const uint8_t code = m.end_code[b][element * m.head->function_nodes];
  return (code & kMeasured) != 0 ? (code & kNoLength) != 0 : ends_coincide(m, b, element, 0.0);
}

bool joins_twins(const Model& m, int b, int32_t element) {
  return is_zero_length(m, b, element) && !is_axis_element(m, b, element);
}

} // namespace

int32_t region_of_element(const Model& m, int b, int32_t element) {
  return static_cast<int32_t>(region_with(m, b, element) - m.region[b]);
}

void nodes_of_region(const Model& m, int b, int32_t region, int32_t* first, int32_t* last) {
  const Region& r = m.region[b][region];
  const int32_t steps = nodes_per_element(m);
  const bool shared = m.head->function_nodes > 1; // constant elements have no nodes at their ends
  *first = r.first * steps + (shared ? r.shift : 0);
  *last = (r.last + 1) * steps - 1 + (shared ? r.shift + r.open : 0);
}

int32_t element_after(const Model& m, int b, int32_t element) {
  const Region& r = *region_with(m, b, element);
  if (element != r.last) return element + 1;
  return r.open ? -1 : r.first;
}

int32_t geometry_node(const Model& m, int b, int32_t element, int k) {
  const int32_t steps = body_of(m, b).element_nodes - 1;
  const Region& r = *region_with(m, b, element);
  if (k == steps && element == r.last && !r.open) return r.first * steps + r.shift;
  return element * steps + k + r.shift;
}

int32_t functional_node(const Model& m, int b, int32_t element, int l) {
  if (m.head->function_nodes == 1) return element;
  const int32_t steps = nodes_per_element(m);
  const Region& r = *region_with(m, b, element);
  if (l == steps && element == r.last && !r.open) return r.first * steps + r.shift;
  return element * steps + l + r.shift;
}

int all_ends_at_node(const Model& m, int b, int32_t node, int32_t ends[2]) {
  const int32_t f = m.head->function_nodes;
  const NodePlace at = place_of_node(m, b, node);
  int count = 0;
  if (f > 1 && at.local == 0) {
    const int32_t before = element_before(at);
    if (before >= 0 && !has_no_length(m, b, before)) ends[count++] = before * f + f - 1;
  }
  if (!has_no_length(m, b, at.element)) ends[count++] = at.element * f + at.local;
  return count;
}

int ends_at_node(const Model& m, int b, int32_t node, int32_t ends[2]) {
  return ends_off_axis(m, b, ends, all_ends_at_node(m, b, node, ends));
}

int ends_off_axis(const Model& m, int b, int32_t ends[2], int count) {
  if (m.body[b].lines == 0) return count;
  int kept = 0;
  for (int i = 0; i < count; ++i)
    if (!is_axis_element(m, b, ends[i] / m.head->function_nodes)) ends[kept++] = ends[i];
  return kept;
}

int32_t corner_point(const Model& m, int b, int32_t node) {
  const int32_t f = m.head->function_nodes;
  if (f == 1) return -1;
  const NodePlace at = place_of_node(m, b, node);
  if (at.local == 0) return geometry_node(m, b, at.element, 0);
  return at.local == f - 1 ? geometry_node(m, b, at.element, body_of(m, b).element_nodes - 1) : -1;
}

bool is_zero_length(const Model& m, int b, int32_t element) { return has_no_length(m, b, element); }

// Zero length is decided once, with a tolerance of the whole body, and stored: the decision must be the same everywhere.
void measure_elements(const Model& m) {
  for (int b = 0; b < m.head->bodies; ++b) {
    const double near = coincidence_of(m, b);
    for (int32_t e = 0; e < body_of(m, b).elements; ++e) {
      uint8_t& code = m.end_code[b][e * m.head->function_nodes];
      code = static_cast<uint8_t>(code | kMeasured | (ends_coincide(m, b, e, near) ? kNoLength : 0));
    }
  }
}

const Zone& tie_of_platen(const Model& m, int b) {
  int32_t i = 0;
  while (m.zone[i].body[0] != b) ++i;
  return m.zone[i];
}

bool is_integrated(const Model& m, int b, int32_t element) {
  return !is_zero_length(m, b, element) && !is_axis_element(m, b, element);
}

int32_t twin_node(const Model& m, int b, int32_t node) {
  if (m.head->function_nodes != 2) return -1;
  const NodePlace at = place_of_node(m, b, node);
  if (at.local == 0 && joins_twins(m, b, at.element)) return functional_node(m, b, at.element, 1);
  const int32_t before = at.local == 0 ? element_before(at) : at.element;
  return before >= 0 && joins_twins(m, b, before) ? functional_node(m, b, before, 0) : -1;
}

bool is_second_twin(const Model& m, int b, int32_t node) {
  const int32_t twin = twin_node(m, b, node); // the zero-length element begins at the first node and ends at the second
  return twin >= 0 && functional_node(m, b, place_of_node(m, b, twin).element, 1) == node;
}

void element_coordinates(const Model& m, int b, int32_t element, double x[kElementNodes], double y[kElementNodes]) {
  const int32_t steps = body_of(m, b).element_nodes - 1;
  const Region& r = *region_with(m, b, element);
  const int32_t first = element * steps + r.shift,
                end = element == r.last && !r.open ? r.first * steps + r.shift : first + steps;
  for (int32_t k = 0; k <= steps; ++k) { // as geometry_node() for every k, with one search for the region
    const double* p = m.xy[b] + 2 * (k < steps ? first + k : end);
    x[k] = p[0];
    y[k] = p[1];
  }
}

void node_position(const Model& m, int b, int32_t node, double* x, double* y) {
  const int32_t f = m.head->function_nodes, corner = corner_point(m, b, node);
  if (corner >= 0) { // at element ends exactly the boundary point, without round-off of the shape functions
    const double* p = m.xy[b] + 2 * corner;
    *x = p[0];
    *y = p[1];
    return;
  }
  const NodePlace at = place_of_node(m, b, node);
  const CurvePoint p = curve_point(m, b, at.element, node_eta(f, at.local));
  *x = p.x;
  *y = p.y;
}

int32_t zone_element(const Model& m, const Zone& z, int side, int32_t k) {
  const Region& r = m.region[z.body[side]][z.region[side]];
  return number_in_range(k, z.first_element[side], z.element_step[side], r.first, r.last);
}

int32_t zone_node(const Model& m, const Zone& z, int side, int32_t k) {
  int32_t first, last;
  nodes_of_region(m, z.body[side], z.region[side], &first, &last);
  return number_in_range(k, z.first_node[side], z.node_step[side], first, last);
}

bool find_contact_element(const Model& m, int b, int32_t element, ZonePlace* out) {
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const Zone& z = m.zone[i];
    for (int side = 0; side < 2; ++side) {
      if (z.body[side] != b) continue;
      const Region& r = m.region[b][z.region[side]];
      const int32_t k = place_in_range(element, z.first_element[side], z.element_step[side], r.first, r.last, r.open != 0);
      if (k < 0 || k >= zone_elements(z, side)) continue;
      *out = ZonePlace{i, side, k};
      return true;
    }
  }
  return false;
}

namespace {

int32_t pair_in_zone(const Model& m, const Zone& z, int side, int32_t node) {
  if (z.is_free != 0 && side == 0) return -1;
  const int b = z.body[side];
  int32_t first, last;
  nodes_of_region(m, b, z.region[side], &first, &last);
  const bool open = m.region[b][z.region[side]].open != 0;
  const int32_t k = place_in_range(node, z.first_node[side], z.node_step[side], first, last, open);
  return k >= 0 && k < z.pairs ? z.first_pair + k : -1;
}

// Is the node at this end of a matching zone, or the one that it faces, in a pair of another zone?
bool meets_another_zone(const Model& m, const Zone& z, const ZonePlace& at, int l) {
  for (int side = is_platen(m, z.body[0]) ? 1 : 0; side < 2; ++side) {
    const bool same_way = z.element_step[side] == z.element_step[at.side];
    const int32_t element = zone_element(m, z, side, at.place);
    if (pair_of_node(m, z.body[side], functional_node(m, z.body[side], element, same_way ? l : m.head->function_nodes - 1 - l))
            .pair >= 0)
      return true;
  }
  return false;
}

} // namespace

// At most one zone contains a node (validate_zones), so the first hit is the only one.
PairSide pair_of_node(const Model& m, int b, int32_t node) {
  for (int32_t i = 0; i < m.head->zones; ++i)
    for (int side = 0; side < 2; ++side) {
      const int32_t pair = m.zone[i].body[side] == b ? pair_in_zone(m, m.zone[i], side, node) : -1;
      if (pair >= 0) return PairSide{pair, side};
    }
  return PairSide{-1, 0};
}

PairSide pair_of_end(const Model& m, int b, int32_t element, int l) {
  ZonePlace at;
  if (!find_contact_element(m, b, element, &at)) return PairSide{-1, 0};
  const Zone& z = m.zone[at.zone];
  const int32_t pair = pair_in_zone(m, z, at.side, functional_node(m, b, element, l));
  if (pair >= 0 || m.head->function_nodes == 1) return PairSide{pair, at.side};
  if (z.is_free != 0 ? at.side == 0 : !meets_another_zone(m, z, at, l)) return PairSide{-1, at.side};
  const int nearest = l == 0 ? 1 : m.head->function_nodes - 2; // the node is the first or last of the zone
  return PairSide{pair_in_zone(m, z, at.side, functional_node(m, b, element, nearest)), at.side};
}

void pair_position(const Model& m, const Pair& pair, int side, double* x, double* y) {
  if (pair.node[side] >= 0)
    node_position(m, body_on(m, pair, side), pair.node[side], x, y);
  else
    kFreeZonePart.faced_position(m, pair, x, y);
}

} // namespace c2d
