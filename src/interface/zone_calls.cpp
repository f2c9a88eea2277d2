// Contact zones by calls.
#include <string.h>

#include "interface/zone_calls.hpp"
#include "memory/parts.hpp"
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
  if (head.zones >= s->sizes.zones) return refuse_limit(s, "zones", s->sizes.zones, head.zones + 1);
  return C2D_OK;
}

int32_t side_elements(const c2d_side& side) {
  if (side.elements != 0) return side.elements;
  const int64_t distance = int64_t{side.last_element} - side.first_element;
  return static_cast<int32_t>(distance <= -INT32_MAX || distance >= INT32_MAX ? -1 : (distance < 0 ? -distance : distance) + 1);
}

c2d_status check_side_elements(c2d_solver* s, int b, const c2d_side& side) {
  const int32_t elements = s->model.body[b].elements;
  const int32_t wrong = in_range(side.first_element, 1, elements) ? side.last_element : side.first_element;
  if (in_range(wrong, 1, elements)) return C2D_OK;
  return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact element of body 1" : "contact element of body 2", wrong, 1,
                       elements);
}

c2d_status keep_zone(c2d_solver* s, Zone& z) {
  ModelHeader& head = s->model;
  z.first_pair = head.pairs;
  z.line = head.line;
  model_of(s).zone[head.zones++] = z;
  head.pairs += z.pairs;
  head.contact_elements += z.elements;
  return built(s);
}

C2D_MEETS(FreeZonePart, c2d_link_free_zones);

} // namespace c2d

namespace {

c2d_status fill_zone(c2d_solver* s, const Model& m, const c2d_zone& given, Zone& z) {
  for (int b = 0; b < 2; ++b) {
    const Body& body = m.head->body[b];
    const c2d_side& side = b == 0 ? given.side1 : given.side2;
    const int32_t nodes[2] = {side.first_node, side.last_node};
    const c2d_status status = check_side_elements(s, b, side);
    if (status != C2D_OK) return status;
    for (int32_t node : nodes)
      if (!in_range(node, 1, body.nodes))
        return refuse_number(s, C2D_ERR_ARGUMENT, b == 0 ? "contact node of body 1" : "contact node of body 2", node, 1,
                             body.nodes);
    z.first_element[b] = side.first_element - 1;
    z.first_node[b] = side.first_node - 1;
    z.region[b] = region_of_element(m, b, z.first_element[b]);
    const Region region = m.region[b][z.region[b]];
    int32_t first_node, last_node;
    nodes_of_region(m, b, z.region[b], &first_node, &last_node);
    // An open region is no ring to go round.
    const int32_t ring = region.open ? 0 : region.last - region.first + 1;
    const int32_t node_ring = region.open ? 0 : last_node - first_node + 1;
    // Half of a ring is reached both ways, by its elements or by its nodes, not by both: the other ones tell.
    const int32_t by_numbers = side.last_node >= side.first_node ? 1 : -1;
    const int32_t by_nodes = range_step(z.first_node[b], side.last_node - 1, given.pairs, first_node, node_ring, by_numbers);
    z.element_step[b] = range_step(z.first_element[b], side.last_element - 1, z.elements, region.first, ring,
                                   by_nodes == 0 ? by_numbers : by_nodes);
    z.node_step[b] = range_step(z.first_node[b], side.last_node - 1, given.pairs, first_node, node_ring,
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

// Each side names its body. The contact system has body 1 below and body 2 above yet.
c2d_status check_sides(c2d_solver* s, const c2d_zone& zone) {
  if (zone.side1.body != 1) return refuse_number(s, C2D_ERR_ARGUMENT, "c2d_zone.side1.body", zone.side1.body, 1, 1);
  if (zone.side2.body != 2) return refuse_number(s, C2D_ERR_ARGUMENT, "c2d_zone.side2.body", zone.side2.body, 2, 2);
  return C2D_OK;
}

c2d_status add_matching_zone(c2d_solver* s, const c2d_zone& given) {
  ModelHeader& head = s->model;
  const int32_t elements = side_elements(given.side1), others = side_elements(given.side2);
  if (elements != others)
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of contact elements of side 2", others, elements, elements);
  if (given.pairs < 1) return refuse_number(s, C2D_ERR_LIMIT, "number of contact pairs", given.pairs, 1, s->sizes.pairs);
  if (given.pairs > s->sizes.pairs - head.pairs)
    return refuse_limit(s, "pairs", s->sizes.pairs, int64_t{head.pairs} + given.pairs);
  if (elements < 1)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact elements", elements, 1, s->sizes.contact_elements);
  if (elements > s->sizes.contact_elements - head.contact_elements)
    return refuse_limit(s, "contact_elements", s->sizes.contact_elements, int64_t{head.contact_elements} + elements);
  Zone z;
  memset(&z, 0, sizeof z);
  z.pairs = given.pairs;
  z.elements = elements;
  const c2d_status status = fill_zone(s, model_of(s), given, z);
  return status == C2D_OK ? keep_zone(s, z) : status;
}

} // namespace

extern "C" c2d_status c2d_add_zone(c2d_solver* s, const c2d_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_zone given;
  if (status == C2D_OK) status = take(s, "c2d_zone", zone, given);
  if (status != C2D_OK) return status;
  if (!in_range(given.kind, C2D_ZONE_MATCHING, C2D_ZONE_FREE))
    return refuse(s, C2D_ERR_ARGUMENT, "kind of a zone: expected C2D_ZONE_MATCHING or _FREE");
  status = check_room_for_zone(s);
  if (status == C2D_OK) status = check_sides(s, given);
  if (status != C2D_OK) return status;
  if (given.kind == C2D_ZONE_MATCHING) return add_matching_zone(s, given);
  if (!kFreeZonePart.linked)
    return refuse(s, C2D_ERR_ARGUMENT,
                  "this program is linked without free zones (C2D_PARTS_BY_CALL): c2d_link_free_zones links them");
  return kFreeZonePart.add_free_zone(s, given);
}
