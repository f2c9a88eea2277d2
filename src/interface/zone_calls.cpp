// Contact zones by calls.
#include <string.h>

#include "interface/zone_calls.hpp"
#include "model/model.hpp"

using namespace c2d;

namespace c2d {

int32_t range_step(int32_t first, int32_t last, int32_t count, int32_t start, int32_t size, int32_t preferred) {
  for (int32_t step = preferred, tried = 0; tried < 2; step = -step, ++tried) {
    int32_t place = first - start + step * (count - 1);
    while (place < 0 && count <= size) place += size;
    while (place >= size && count <= size) place -= size;
    if (place + start == last) return step;
  }
  return 0;
}

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

} // namespace c2d

namespace {

c2d_status fill_zone(c2d_solver* s, const Model& m, const c2d_zone& given, Zone& z) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = m.head->body[b];
    const int32_t elements[2] = {given.first_element[b], given.last_element[b]};
    const int32_t nodes[2] = {given.first_node[b], given.last_node[b]};
    for (int32_t element : elements)
      if (!in_range(element, 1, body.elements))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact element of body 1" : "contact element of body 2", element,
                             1, body.elements);
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
    const int32_t ring = region.open ? 0 : region.last - region.first + 1;
    const int32_t node_ring = region.open ? 0 : last_node - first_node + 1;
    // Half of a ring is reached both ways, by its elements or by its nodes, not by both: the other ones tell.
    const int32_t by_numbers = given.last_node[b] >= given.first_node[b] ? 1 : -1;
    const int32_t by_nodes =
        range_step(z.first_node[b], given.last_node[b] - 1, given.pairs, first_node, node_ring, by_numbers);
    z.element_step[b] = range_step(z.first_element[b], given.last_element[b] - 1, given.elements, region.first, ring,
                                   by_nodes == 0 ? by_numbers : by_nodes);
    z.node_step[b] = range_step(z.first_node[b], given.last_node[b] - 1, given.pairs, first_node, node_ring,
                                z.element_step[b] == 0 ? 1 : z.element_step[b]);
    if (z.element_step[b] == 0)
      return refuse(s, C2D_ERR_ARGUMENT,
                    b == 0 ? "the element range of body 1 does not hold the number of elements given"
                           : "the element range of body 2 does not hold the number of elements given");
    if (z.node_step[b] == 0)
      return refuse(s, C2D_ERR_ARGUMENT,
                    b == 0 ? "the node range of body 1 does not hold the number of nodes given"
                           : "the node range of body 2 does not hold the number of nodes given");
  }
  return C2D_OK;
}

} // namespace

extern "C" c2d_status c2d_add_zone(c2d_solver* s, const c2d_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_zone given;
  if (status != C2D_OK) return status;
  status = take(s, "c2d_zone", zone, given);
  if (status != C2D_OK) return status;
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
