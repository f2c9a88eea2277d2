// Contact zones by calls.
#include <string.h>

#include "model/model.hpp"
#include "solver/refuse.hpp"

using namespace c2d;

namespace {

// Steps of +1 or -1 that lead from first to last in count-1 steps, round the ring [start, start + size) if there is one;
// 0: none does. `preferred` decides where both do.
int32_t range_step(int64_t first, int64_t last, int64_t count, int64_t start, int64_t size, int32_t preferred) {
  for (int32_t sign = 1; sign >= -1; sign -= 2)
    if (first + sign * (count - 1) == last && (count > 1 || sign == preferred)) return sign;
  for (int32_t sign = 1; sign >= -1 && size > 0; sign -= 2) {
    const int64_t turned = ((first - start + sign * (count - 1)) % size + size) % size + start;
    if (count <= size && turned == last) return sign;
  }
  return 0;
}

c2d_status fill_zone(c2d_solver* s, const Model& m, const c2d_zone& given, Zone& z) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = m.head->body[b];
    const int32_t elements[2] = {given.first_element[b], given.last_element[b]};
    const int32_t nodes[2] = {given.first_node[b], given.last_node[b]};
    for (int32_t element : elements)
      if (!in_range(element, 1, body.elements))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact element of body 1" : "contact element of body 2",
                             element, 1, body.elements);
    for (int32_t node : nodes)
      if (!in_range(node, 1, body.nodes))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact node of body 1" : "contact node of body 2", node, 1,
                             body.nodes);
    z.first_element[b] = given.first_element[b] - 1;
    z.first_node[b] = given.first_node[b] - 1;
    z.region[b] = region_of_element(m, b, z.first_element[b]);
    const Region region = m.region[b][z.region[b]];
    int32_t first_node, last_node;
    nodes_of_region(m, b, z.region[b], &first_node, &last_node);
    // An open region is no ring to go round.
    const int64_t ring = region.open ? 0 : region.last - region.first + 1;
    const int64_t node_ring = region.open ? 0 : last_node - first_node + 1;
    const int32_t by_nodes = given.last_node[b] >= given.first_node[b] ? 1 : -1;
    z.element_step[b] =
        range_step(z.first_element[b], given.last_element[b] - 1, given.elements, region.first, ring, by_nodes);
    z.node_step[b] = range_step(z.first_node[b], given.last_node[b] - 1, given.pairs,
                                first_node, node_ring,
                                z.element_step[b] == 0 ? 1 : z.element_step[b]);
    if (z.element_step[b] == 0)
      return refuse(s, C2D_ERR_ARGUMENT,
                    b == 0 ? "the element range of body 1 does not hold the number of elements given"
                           : "the element range of body 2 does not hold the number of elements given");
    if (z.node_step[b] == 0)
      return refuse(s, C2D_ERR_ARGUMENT, b == 0 ? "the node range of body 1 does not hold the number of nodes given"
                                                : "the node range of body 2 does not hold the number of nodes given");
  }
  return C2D_OK;
}

// What any kind of zone needs: two bodies that are known, and room.
c2d_status check_room_for_zone(c2d_solver* s) {
  const ModelHeader& head = s->model;
  if (s->sizes.bodies < 2) return refuse(s, C2D_ERR_ARGUMENT, "a contact zone needs two bodies");
  for (const Body& body : head.body)
    if (!body.is_set || body.region_count < body.regions)
      return refuse(s, C2D_ERR_ARGUMENT, "give both bodies and all their regions before the contact zones");
  if (head.zones >= s->sizes.zones)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact zones", head.zones + 1, 0, s->sizes.zones);
  return C2D_OK;
}

} // namespace

extern "C" c2d_status c2d_add_zone(c2d_solver* s, const c2d_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_zone given;
  if (status != C2D_OK) return status;
  if (!zone || !copy_in(zone, &given, sizeof given)) return refuse(s, C2D_ERR_ARGUMENT, "no zone given");
  ModelHeader& head = s->model;
  status = check_room_for_zone(s);
  if (status != C2D_OK) return status;
  if (!in_range(given.pairs, 1, s->sizes.pairs - head.pairs))
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact pairs", given.pairs, 1, s->sizes.pairs - head.pairs);
  if (!in_range(given.elements, 1, s->sizes.contact_elements - head.contact_elements))
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact elements", given.elements, 1,
                         s->sizes.contact_elements - head.contact_elements);
  const Model m = model_of(s);
  Zone z;
  memset(&z, 0, sizeof z);
  z.pairs = given.pairs;
  z.elements = given.elements;
  z.first_pair = head.pairs;
  z.line = head.line;
  status = fill_zone(s, m, given, z);
  if (status != C2D_OK) return status;
  m.zone[head.zones++] = z;
  head.pairs += z.pairs;
  head.contact_elements += z.elements;
  return built(s);
}

namespace {

// Ranges of a free zone: body 2's runs against body 1's, whichever way they were given.
c2d_status fill_free_zone(c2d_solver* s, const Model& m, const c2d_free_zone& given, Zone& z) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = m.head->body[b];
    const int32_t ends[2] = {given.first_element[b], given.last_element[b]};
    for (int32_t element : ends)
      if (!in_range(element, 1, body.elements))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact element of body 1" : "contact element of body 2",
                             element, 1, body.elements);
    const int32_t distance = ends[1] > ends[0] ? ends[1] - ends[0] : ends[0] - ends[1];
    const int32_t count = given.elements[b] == 0 ? distance + 1 : given.elements[b];
    z.region[b] = region_of_element(m, b, ends[0] - 1);
    const Region& region = m.region[b][z.region[b]];
    const int64_t ring = region.open ? 0 : region.last - region.first + 1;
    z.first_element[b] = ends[0] - 1;
    z.element_step[b] = count < 1 ? 0 : range_step(ends[0] - 1, ends[1] - 1, count, region.first, ring, 1);
    (b == 0 ? z.facing : z.elements) = count;
    if (z.element_step[b] == 0 || region_of_element(m, b, ends[1] - 1) != z.region[b])
      return refuse(s, C2D_ERR_ARGUMENT,
                    b == 0 ? "the element range of body 1 does not hold the number of elements given, in one region"
                           : "the element range of body 2 does not hold the number of elements given, in one region");
  }
  if (z.element_step[1] == z.element_step[0]) {
    z.first_element[1] = given.last_element[1] - 1;
    z.element_step[1] = -z.element_step[1];
  }
  return C2D_OK;
}

} // namespace

extern "C" c2d_status c2d_add_free_zone(c2d_solver* s, const c2d_free_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_free_zone given;
  if (status != C2D_OK) return status;
  if (!zone || !copy_in(zone, &given, sizeof given)) return refuse(s, C2D_ERR_ARGUMENT, "no zone given");
  ModelHeader& head = s->model;
  status = check_room_for_zone(s);
  if (status != C2D_OK) return status;
  const Model m = model_of(s);
  Zone z;
  memset(&z, 0, sizeof z);
  status = fill_free_zone(s, m, given, z);
  if (status != C2D_OK) return status;
  const int32_t f = s->sizes.function_nodes;
  const int64_t pairs = f == 1 ? z.elements : static_cast<int64_t>(z.elements) * (f - 1) + 1;
  int64_t others = 0; // pairs of the other free zones
  for (int32_t i = 0; i < head.zones; ++i) others += m.zone[i].is_free != 0 ? m.zone[i].pairs : 0;
  if (pairs > s->sizes.pairs - head.pairs)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact pairs", pairs, 1, s->sizes.pairs - head.pairs);
  if (pairs > s->sizes.free_pairs - others)
    return refuse_number(s, C2D_ERR_LIMIT, "number of pairs of free zones", pairs, 1, s->sizes.free_pairs - others);
  if (z.elements > s->sizes.contact_elements - head.contact_elements)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact elements", z.elements, 1,
                         s->sizes.contact_elements - head.contact_elements);
  z.is_free = 1;
  z.pairs = static_cast<int32_t>(pairs);
  z.node_step[1] = z.element_step[1];
  z.first_node[1] = functional_node(m, 1, z.first_element[1], z.element_step[1] > 0 ? 0 : f - 1);
  z.first_pair = head.pairs;
  z.line = head.line;
  m.zone[head.zones++] = z;
  head.pairs += z.pairs;
  head.contact_elements += z.elements;
  return built(s);
}
