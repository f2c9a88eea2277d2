// c2d_add_zone and c2d_tie_zone.
#include <string.h>

#include "interface/model/zone_calls.hpp"
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

int64_t room_taken(c2d_solver* s, bool free_alone) {
  int64_t taken = 0;
  for (int32_t i = 0; i < s->model.zones; ++i) {
    const Zone& z = model_of(s).zone[i];
    if (z.is_free != 0 || !free_alone) taken += room_of(z.pairs, z.is_self != 0);
  }
  return taken;
}

int32_t side_elements(const c2d_side& side) {
  if (side.elements != 0) return side.elements;
  const int64_t distance = int64_t{side.last_element} - side.first_element;
  return static_cast<int32_t>(distance <= -INT32_MAX || distance >= INT32_MAX ? -1 : (distance < 0 ? -distance : distance) + 1);
}

namespace {

// Message: "contact element of body 3 (bolt) is NUMBER, expected 1 to MOST".
c2d_status check_contact_number(c2d_solver* s, const char* kind, int32_t body, int32_t number, int32_t most) {
  if (in_range(number, 1, most)) return C2D_OK;
  char what[80];
  Text text = text_in(what);
  put_all(text, kind, Named{body, body_numbered(s, body).name});
  return refuse_number(s, C2D_ERR_ARGUMENT, what, number, 1, most);
}

} // namespace

c2d_status refuse_range(c2d_solver* s, const char* kind, int32_t body, const char* expected) {
  Refusal r;
  start_refusal(r, s, C2D_ERR_ARGUMENT);
  put_all(r.text, "the ", kind, " range of body ", Named{body, body_numbered(s, body).name}, " does not contain the number of ",
          kind, "s given", expected);
  report_fault(s, r.error);
  return C2D_ERR_ARGUMENT;
}

c2d_status check_side_elements(c2d_solver* s, const c2d_side& side) {
  const int32_t elements = body_numbered(s, side.body).elements;
  const c2d_status first = check_contact_number(s, "contact element of body ", side.body, side.first_element, elements);
  if (first != C2D_OK) return first;
  return check_contact_number(s, "contact element of body ", side.body, side.last_element, elements);
}

void keep_zone(c2d_solver* s, Zone& z) {
  ModelHeader& head = s->model;
  z.first_pair = head.pairs;
  z.line = head.line;
  model_of(s).zone[head.zones++] = z;
  head.pairs += z.pairs;
  head.contact_elements += z.elements;
}

C2D_MEETS(FreeZonePart, c2d_link_free_zones);

} // namespace c2d

namespace {

c2d_status fill_zone(c2d_solver* s, const Model& m, const c2d_zone& given, Zone& z) {
  for (int k = 0; k < 2; ++k) {
    const c2d_side& side = k == 0 ? given.side1 : given.side2;
    const int b = side.body - 1;
    const int32_t nodes[2] = {side.first_node, side.last_node};
    c2d_status status = check_side_elements(s, side);
    for (int i = 0; i < 2 && status == C2D_OK; ++i)
      status = check_contact_number(s, "contact node of body ", side.body, nodes[i], m.body[b].nodes);
    if (status != C2D_OK) return status;
    z.body[k] = b;
    z.first_element[k] = side.first_element - 1;
    z.first_node[k] = side.first_node - 1;
    z.region[k] = region_of_element(m, b, z.first_element[k]);
    const Region region = m.region[b][z.region[k]];
    int32_t first_node, last_node;
    nodes_of_region(m, b, z.region[k], &first_node, &last_node);
    // The range of an open region cannot cross its end.
    const int32_t ring = region.open ? 0 : region.last - region.first + 1;
    const int32_t node_ring = region.open ? 0 : last_node - first_node + 1;
    // Half of a ring fits in both directions by its elements or by its nodes, but not by both: the other numbers decide.
    const int32_t by_numbers = side.last_node >= side.first_node ? 1 : -1;
    const int32_t by_nodes = range_step(z.first_node[k], side.last_node - 1, given.pairs, first_node, node_ring, by_numbers);
    z.element_step[k] = range_step(z.first_element[k], side.last_element - 1, z.elements, region.first, ring,
                                   by_nodes == 0 ? by_numbers : by_nodes);
    z.node_step[k] = range_step(z.first_node[k], side.last_node - 1, given.pairs, first_node, node_ring,
                                z.element_step[k] == 0 ? 1 : z.element_step[k]);
    if (z.element_step[k] == 0) return refuse_range(s, "element", side.body, "");
    if (z.node_step[k] == 0) return refuse_range(s, "node", side.body, "");
  }
  return C2D_OK;
}

// Not part of c2d_add_zone, like the next function: their frames would add to that of free zones.
// Checks for all kinds of zones: two known bodies, and room.
[[gnu::noinline]] c2d_status check_zone(c2d_solver* s, const c2d_zone& zone) {
  const int32_t bodies = s->sizes.bodies;
  const bool self = (zone.kind & C2D_ZONE_SELF) != 0;
  if (bodies < 2 && !self) return refuse(s, C2D_ERR_ARGUMENT, "a contact zone needs two bodies");
  const c2d_status status = check_ranges(
      s, {{"c2d_zone.side1.body", zone.side1.body, 1, bodies}, {"c2d_zone.side2.body", zone.side2.body, 1, bodies}});
  if (status != C2D_OK) return status;
  if ((zone.side1.body == zone.side2.body) != self)
    return refuse(s, C2D_ERR_ARGUMENT,
                  self ? "the sides of a zone of kind C2D_ZONE_SELF are on two bodies, expected one body"
                       : "both sides of a contact zone are on one body, expected two different bodies, or C2D_ZONE_SELF");
  const int32_t numbers[2] = {zone.side1.body, zone.side2.body};
  for (const int32_t number : numbers) {
    const Body& body = body_numbered(s, number);
    if (!body.is_set || body.region_count < body.regions)
      return refuse(s, C2D_ERR_ARGUMENT, "give both bodies and all their regions before the contact zones");
  }
  if (s->model.zones >= s->sizes.zones) return refuse_limit(s, "zones", s->sizes.zones, s->model.zones + 1);
  return C2D_OK;
}

[[gnu::noinline]] c2d_status add_matching_zone(c2d_solver* s, const c2d_zone& given) {
  ModelHeader& head = s->model;
  const int32_t elements = side_elements(given.side1), others = side_elements(given.side2);
  if (elements != others)
    return refuse_number(s, C2D_ERR_ARGUMENT, "number of contact elements of side 2", others, elements, elements);
  if (given.pairs < 1) return refuse_number(s, C2D_ERR_LIMIT, "number of contact pairs", given.pairs, 1, s->sizes.pairs);
  const int64_t room = room_taken(s, false) + room_of(given.pairs, (given.kind & C2D_ZONE_SELF) != 0);
  if (room > s->sizes.pairs) return refuse_limit(s, "pairs", s->sizes.pairs, room);
  if (elements < 1)
    return refuse_number(s, C2D_ERR_LIMIT, "number of contact elements", elements, 1, s->sizes.contact_elements);
  if (elements > s->sizes.contact_elements - head.contact_elements)
    return refuse_limit(s, "contact_elements", s->sizes.contact_elements, int64_t{head.contact_elements} + elements);
  Zone z;
  memset(&z, 0, sizeof z);
  z.pairs = given.pairs;
  z.elements = elements;
  z.is_self = (given.kind & C2D_ZONE_SELF) != 0 ? 1 : 0;
  const c2d_status status = fill_zone(s, model_of(s), given, z);
  if (status != C2D_OK) return status;
  keep_zone(s, z);
  return built(s);
}

} // namespace

extern "C" c2d_status c2d_add_zone(c2d_solver* s, const c2d_zone* zone) {
  c2d_status status = enter_building(s);
  c2d_zone given;
  if (status == C2D_OK) status = take(s, "c2d_zone", zone, given);
  if (status != C2D_OK) return status;
  if (!in_range(given.kind, C2D_ZONE_MATCHING, C2D_ZONE_FREE + C2D_ZONE_TIED + C2D_ZONE_SELF))
    return refuse(s, C2D_ERR_ARGUMENT, "kind of a zone: expected C2D_ZONE_MATCHING or _FREE, and _TIED and _SELF added or not");
  status = check_zone(s, given);
  if (status != C2D_OK) return status;
  const bool is_free = (given.kind & C2D_ZONE_FREE) != 0;
  if (is_free && !kFreeZonePart.linked) return refuse_part(s, "a free zone", "c2d_link_free_zones");
  status = is_free ? kFreeZonePart.add_free_zone(s, given) : add_matching_zone(s, given);
  if (status != C2D_OK) return status;
  Zone& added = model_of(s).zone[s->model.zones - 1];
  added.is_tied = (given.kind & C2D_ZONE_TIED) != 0 ? 1 : 0;
  return status;
}

extern "C" c2d_status c2d_tie_zone(c2d_solver* s, int32_t zone) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK && s->model.zones == 0) return refuse(s, C2D_ERR_ARGUMENT, "there is no zone to tie yet");
  if (status == C2D_OK) status = check_ranges(s, {{"zone", zone, 1, s->model.zones}});
  if (status != C2D_OK) return status;
  model_of(s).zone[zone - 1].is_tied = 1;
  return built(s);
}
