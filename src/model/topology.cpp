// Which nodes, elements and ends belong together. Every region is a closed curve of its own.
#include "model/geometry.hpp"
#include "model/model.hpp"

#include <math.h>

namespace c2d {

namespace {

// Steps from one end of an element to the other, in the numbering of functional nodes.
int32_t nodes_per_element(const Model& m) {
  return m.head->function_nodes == 1 ? 1 : m.head->function_nodes - 1;
}

// The element of whose local nodes but the last this is one.
int32_t element_of_node(const Model& m, int32_t node) {
  return node / nodes_per_element(m);
}

int32_t element_before(const Model& m, int b, int32_t element) {
  const Region& r = m.region[b][region_of_element(m, b, element)];
  return element == r.first ? r.last : element - 1;
}

// Position k = 0, 1, ... of `number` in the sequence first, first + step, ... that wraps round first_in ...
// last_in.
int32_t place_in_range(int32_t number, int32_t first, int32_t step, int32_t first_in, int32_t last_in) {
  if (number < first_in || number > last_in) return -1;
  const int32_t place = step > 0 ? number - first : first - number;
  return place < 0 ? place + (last_in - first_in + 1) : place;
}

int32_t number_in_range(int32_t k, int32_t first, int32_t step, int32_t first_in, int32_t last_in) {
  const int32_t size = last_in - first_in + 1;
  const int32_t place = (first - first_in + (step > 0 ? k : -k)) % size;
  return first_in + (place < 0 ? place + size : place);
}

void node_range(const Model& m, const Zone& z, int b, int32_t* first, int32_t* last) {
  const Region& r = m.region[b][z.region[b]];
  const int32_t steps = nodes_per_element(m);
  *first = r.first * steps;
  *last = (r.last + 1) * steps - 1;
}

} // namespace

int32_t region_of_element(const Model& m, int b, int32_t element) {
  const int32_t regions = body_of(m, b).regions;
  int32_t r = 0;
  while (r + 1 < regions && element > m.region[b][r].last) ++r;
  return r;
}

int32_t geometry_node(const Model& m, int b, int32_t element, int k) {
  const int32_t steps = body_of(m, b).element_nodes - 1;
  if (k == steps) {
    const Region& r = m.region[b][region_of_element(m, b, element)];
    if (element == r.last) return r.first * steps;
  }
  return element * steps + k;
}

int32_t functional_node(const Model& m, int b, int32_t element, int l) {
  if (m.head->function_nodes == 1) return element;
  const int32_t steps = nodes_per_element(m);
  if (l == steps) {
    const Region& r = m.region[b][region_of_element(m, b, element)];
    if (element == r.last) return r.first * steps;
  }
  return element * steps + l;
}

int ends_at_node(const Model& m, int b, int32_t node, int32_t ends[2]) {
  const int32_t f = m.head->function_nodes, element = element_of_node(m, node);
  const int32_t local = f == 1 ? 0 : node % nodes_per_element(m);
  int count = 0;
  if (f > 1 && local == 0) {
    const int32_t before = element_before(m, b, element);
    if (!is_zero_length(m, b, before)) ends[count++] = before * f + f - 1;
  }
  if (!is_zero_length(m, b, element)) ends[count++] = element * f + local;
  return count;
}

bool is_zero_length(const Model& m, int b, int32_t element) {
  if (body_of(m, b).element_nodes != 2) return false;
  const double* p = m.xy[b] + 2 * geometry_node(m, b, element, 0);
  const double* q = m.xy[b] + 2 * geometry_node(m, b, element, 1);
  const double tolerance = kCoincident * m.head->length_unit;
  return fabs(p[0] - q[0]) <= tolerance && fabs(p[1] - q[1]) <= tolerance;
}

int32_t twin_node(const Model& m, int b, int32_t node) {
  if (m.head->function_nodes != 2) return -1;
  if (is_zero_length(m, b, node)) return functional_node(m, b, node, 1);
  const int32_t before = element_before(m, b, node);
  return is_zero_length(m, b, before) ? before : -1;
}

bool is_second_twin(const Model& m, int b, int32_t node) {
  return m.head->function_nodes == 2 && !is_zero_length(m, b, node) &&
         is_zero_length(m, b, element_before(m, b, node));
}

void element_coordinates(const Model& m, int b, int32_t element, double x[4], double y[4]) {
  for (int k = 0; k < body_of(m, b).element_nodes; ++k) {
    const double* p = m.xy[b] + 2 * geometry_node(m, b, element, k);
    x[k] = p[0];
    y[k] = p[1];
  }
}

void node_position(const Model& m, int b, int32_t node, double* x, double* y) {
  const int32_t f = m.head->function_nodes, element = element_of_node(m, node);
  if (f > 1 && node % nodes_per_element(m) == 0) { // a corner of the mesh: exactly the boundary point
    const double* p = m.xy[b] + 2 * geometry_node(m, b, element, 0);
    *x = p[0];
    *y = p[1];
    return;
  }
  const CurvePoint p = curve_point(m, b, element, local_eta(f, f == 1 ? 0 : node % nodes_per_element(m)));
  *x = p.x;
  *y = p.y;
}

int32_t zone_element(const Model& m, const Zone& z, int b, int32_t k) {
  const Region& r = m.region[b][z.region[b]];
  return number_in_range(k, z.first_element[b], z.element_step[b], r.first, r.last);
}

int32_t zone_node(const Model& m, const Zone& z, int b, int32_t k) {
  int32_t first, last;
  node_range(m, z, b, &first, &last);
  return number_in_range(k, z.first_node[b], z.node_step[b], first, last);
}

bool find_contact_element(const Model& m, int b, int32_t element, int32_t* zone, int32_t* place) {
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const Zone& z = m.zone[i];
    const Region& r = m.region[b][z.region[b]];
    const int32_t k = place_in_range(element, z.first_element[b], z.element_step[b], r.first, r.last);
    if (k < 0 || k >= z.elements) continue;
    *zone = i;
    *place = k;
    return true;
  }
  return false;
}

namespace {

int32_t pair_in_zone(const Model& m, const Zone& z, int b, int32_t node) {
  int32_t first, last;
  node_range(m, z, b, &first, &last);
  const int32_t k = place_in_range(node, z.first_node[b], z.node_step[b], first, last);
  return k >= 0 && k < z.pairs ? z.first_pair + k : -1;
}

} // namespace

int32_t pair_of_node(const Model& m, int b, int32_t node) {
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const int32_t pair = pair_in_zone(m, m.zone[i], b, node);
    if (pair >= 0) return pair;
  }
  return -1;
}

int32_t pair_of_end(const Model& m, int b, int32_t element, int l) {
  int32_t zone, place;
  if (!find_contact_element(m, b, element, &zone, &place)) return -1;
  return pair_in_zone(m, m.zone[zone], b, functional_node(m, b, element, l));
}

} // namespace c2d
