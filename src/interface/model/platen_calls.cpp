// c2d_add_platen: creates a rigid body and ties it to elements.
#include <string.h>

#include "interface/model/zone_calls.hpp"

using namespace c2d;

namespace {

// Arguments of the call, numbers from 1.
struct GivenPlaten {
  c2d_side side;
  const int32_t* is_free;
  const double* point;
};

// Number of the next platen, from 0; -1: no room, which was reported.
int32_t next_platen(c2d_solver* s) {
  const int32_t meshed = static_cast<int32_t>(s->sizes.bodies - s->sizes.platens);
  for (int32_t b = meshed; b < s->sizes.bodies; ++b)
    if (body_numbered(s, b + 1).is_set == 0) return b;
  refuse_limit(s, "platens", s->sizes.platens, s->sizes.platens + 1);
  return -1;
}

c2d_status check_platen(c2d_solver* s, const GivenPlaten& given) {
  const int32_t meshed = static_cast<int32_t>(s->sizes.bodies - s->sizes.platens);
  c2d_status status = check_ranges(s, {{"body number", given.side.body, 1, meshed}});
  if (status == C2D_OK) status = check_pointers(s, {{"is_free", given.is_free}, {"point", given.point}});
  if (status == C2D_OK) status = check_numbers(s, {{"point[0]", given.point[0]}, {"point[1]", given.point[1]}});
  if (status == C2D_OK) status = check_whole_body(s, given.side.body);
  if (status != C2D_OK) return status;
  if (s->model.zones >= s->sizes.zones) return refuse_limit(s, "zones", s->sizes.zones, int64_t{s->model.zones} + 1);
  return check_side_elements(s, given.side);
}

// Both sides of the tie are the same range; its nodes are the pairs.
c2d_status fill_tie(c2d_solver* s, const c2d_side& side, int32_t platen, Zone& z) {
  const Model m = model_of(s);
  const int32_t b = side.body - 1, count = side_elements(side), steps = s->sizes.function_nodes - 1;
  const int32_t first = side.first_element - 1, region = region_of_element(m, b, first);
  const Region& r = m.region[b][region];
  const int32_t size = r.last - r.first + 1;
  if (count < 1 || count > size || range_step(first, side.last_element - 1, count, r.first, r.open ? 0 : size, 1) != 1)
    return refuse_range(s, "element", side.body, ", in one region and in the direction of its boundary");
  memset(&z, 0, sizeof z);
  z.elements = count;
  z.pairs = steps == 0 ? count : count * steps + (count == size && r.open == 0 ? 0 : 1);
  z.is_tied = 1;
  z.body[0] = platen, z.body[1] = b;
  z.region[1] = region; // the region list of the platen begins at this region
  for (int k = 0; k < 2; ++k) {
    z.first_element[k] = first;
    z.first_node[k] = functional_node(m, b, first, 0);
    z.element_step[k] = z.node_step[k] = 1;
  }
  const int64_t room = room_taken(s, false) + z.pairs, elements = int64_t{s->model.contact_elements} + count;
  if (room > s->sizes.pairs) return refuse_limit(s, "pairs", s->sizes.pairs, room);
  if (elements > s->sizes.contact_elements) return refuse_limit(s, "contact_elements", s->sizes.contact_elements, elements);
  return C2D_OK;
}

// The platen shares the mesh of the other side, from the region of the zone on.
void lend_mesh(const Body& from, int32_t region, Body& to) {
  for (const int32_t array : kMeshArrays) to.array[array] = from.array[array];
  to.array[kRegions] += region * static_cast<int64_t>(sizeof(Region));
  to.element_nodes = from.element_nodes;
}

void name_platen(int32_t number, char (&name)[32]) {
  Text text = text_in(name);
  put_all(text, "platen ", number);
}

} // namespace

extern "C" c2d_status c2d_add_platen(c2d_solver* s, int32_t body, int32_t first_element, int32_t last_element, int32_t elements,
                                     const int32_t is_free[3], const double point[2]) {
  const GivenPlaten given = {{body, first_element, last_element, elements, 0, 0}, is_free, point};
  c2d_status status = enter_building(s);
  if (status == C2D_OK) status = check_platen(s, given);
  if (status != C2D_OK) return status;
  const int32_t platen = next_platen(s);
  if (platen < 0) return C2D_ERR_LIMIT;
  Zone z;
  status = fill_tie(s, given.side, platen, z);
  if (status != C2D_OK) return status;
  Body& own = body_numbered(s, platen + 1);
  lend_mesh(body_numbered(s, body), z.region[1], own);
  own.is_set = 1;
  const int32_t number = platen + 1 - static_cast<int32_t>(s->sizes.bodies - s->sizes.platens);
  name_platen(number, own.name);
  name_platen(number, z.name);
  keep_zone(s, z);
  return c2d_set_rigid_load(s, platen + 1, 0, is_free, nullptr, point); // links the part for rigid bodies
}
