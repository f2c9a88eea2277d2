// Free zones in c2d_add_zone.
#include <string.h>

#include "bie/transfer.hpp"
#include "contact/pairs/facing_pairs.hpp"
#include "interface/model/zone_calls.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "results/transferred.hpp"
#include "solver/energy/energy_adjoint.hpp"

const c2d::FreeZonePart c2d::kFreeZonePart = {true,
                                              add_free_zone,
                                              fit_free_zone,
                                              faced_position,
                                              fill_transfer,
                                              next_transfer,
                                              make_transfer,
                                              surface_faced,
                                              faced_node,
                                              add_transferred_at,
                                              add_transferred_traction,
                                              transferred_values,
                                              add_transferred_force,
                                              face_point,
                                              facing_point};

namespace c2d {

namespace {

// Ranges of a free zone: stored in opposite directions, whatever directions were given.
c2d_status fill_free_zone(c2d_solver* s, const Model& m, const c2d_zone& given, Zone& z) {
  for (int k = 0; k < 2; ++k) {
    const c2d_side& side = k == 0 ? given.side1 : given.side2;
    const int b = side.body - 1;
    const int32_t ends[2] = {side.first_element, side.last_element};
    const c2d_status status = check_side_elements(s, side);
    if (status != C2D_OK) return status;
    const int32_t count = side_elements(side);
    z.body[k] = b;
    z.region[k] = region_of_element(m, b, ends[0] - 1);
    const Region& region = m.region[b][z.region[k]];
    const int32_t ring = region.open ? 0 : region.last - region.first + 1;
    z.first_element[k] = ends[0] - 1;
    z.element_step[k] =
        count < 1 ? 0 : range_step(ends[0] - 1, ends[1] - 1, count, region.first, ring, ends[1] >= ends[0] ? 1 : -1);
    (k == 0 ? z.facing : z.elements) = count;
    if (z.element_step[k] == 0 || region_of_element(m, b, ends[1] - 1) != z.region[k])
      return refuse_range(s, "element", side.body, ", in one region");
  }
  if (z.element_step[1] == z.element_step[0]) {
    z.first_element[1] = given.side2.last_element - 1;
    z.element_step[1] = -z.element_step[1];
  }
  return C2D_OK;
}

} // namespace

c2d_status add_free_zone(c2d_solver* s, const c2d_zone& given) {
  const ModelHeader& head = s->model;
  const Model m = model_of(s);
  Zone z;
  memset(&z, 0, sizeof z);
  const c2d_status status = fill_free_zone(s, m, given, z);
  if (status != C2D_OK) return status;
  const int32_t f = s->sizes.function_nodes;
  const int64_t pairs = f == 1 ? z.elements : static_cast<int64_t>(z.elements) * (f - 1) + 1;
  z.is_self = (given.kind & C2D_ZONE_SELF) != 0 ? 1 : 0;
  const int64_t room = room_of(pairs, z.is_self != 0), all = room_taken(s, false) + room, of_free = room_taken(s, true) + room;
  if (all > s->sizes.pairs) return refuse_limit(s, "pairs", s->sizes.pairs, all);
  if (of_free > s->sizes.free_pairs) return refuse_limit(s, "free_pairs", s->sizes.free_pairs, of_free);
  if (z.elements > s->sizes.contact_elements - head.contact_elements)
    return refuse_limit(s, "contact_elements", s->sizes.contact_elements, int64_t{head.contact_elements} + z.elements);
  z.is_free = 1;
  z.pairs = static_cast<int32_t>(pairs);
  z.node_step[1] = z.element_step[1];
  z.first_node[1] = functional_node(m, z.body[1], z.first_element[1], z.element_step[1] > 0 ? 0 : f - 1);
  keep_zone(s, z);
  return built(s);
}

} // namespace c2d

extern "C" void c2d_link_free_zones(void) {}
