#include "contact/pairs/facing_pairs.hpp"

#include "memory/hostile.hpp"
#include "model/geometry.hpp"

namespace c2d {

bool surface_faced(const Model& m, int32_t pair, Surface& out) {
  Pair& p = m.pair[pair];
  const Zone& z = m.zone[p.zone];
  const int32_t f = m.head->function_nodes;
  int32_t ends[2] = {0, 0};
  ZonePlace place;
  out = Surface{{0, 0}, 0, 0, -1, 0};
  ends_at_node(m, z.body[1], p.node[1], ends);
  const bool first = find_contact_element(m, z.body[1], ends[0] / f, &place) && place.zone == p.zone && place.side == 1;
  const int own = first ? 0 : 1;
  FacePoint at2{ends[own] / f, 0, node_eta(f, ends[own] % f)}, at;
  const bool in_zone = find_contact_element(m, z.body[1], at2.element, &place);
  if (C2D_NEVER(!in_zone)) return false; // a pair's element is
  at2.place = place.place;
  const bool faces = face_point(m, z, at2, at);
  if (C2D_NEVER(!faces)) return false; // zones whose nodes face nothing are refused before
  p.element = at.element;
  p.eta = at.eta;
  add_surface(m, z.body[0], at.element, at.eta, out);
  normal_in_zone(m, z, 0, at, out.n);
  return make_unit(out.n);
}

int32_t faced_node(const Model& m, const Pair& p) { return node_at(m, body_on(m, p, 0), FacePoint{p.element, 0, p.eta}); }

} // namespace c2d
