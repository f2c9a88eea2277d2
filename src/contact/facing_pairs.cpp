#include "contact/facing_pairs.hpp"

#include "model/geometry.hpp"

namespace c2d {

bool surface_faced(const Model& m, int32_t pair, Surface& out) {
  const Pair& p = m.pair[pair];
  FacePoint at{p.element, 0, p.eta};
  int32_t zone;
  if (!find_contact_element(m, 0, p.element, &zone, &at.place)) return false;
  face_normal(m, m.zone[zone], at, out.n);
  out.length = element_length(m, 0, p.element);
  return make_unit(out.n);
}

double bulges(const Model& m, int32_t pair, double* doubt) {
  const Pair& p = m.pair[pair];
  const int32_t f = m.head->function_nodes;
  const Zone& z = m.zone[p.zone];
  FacePoint at{p.element, 0, p.eta};
  int32_t zone, ends[2];
  if (!find_contact_element(m, 0, at.element, &zone, &at.place)) return 0;
  const double first = bulge_at(m, z, 0, at, doubt);
  const int count = ends_at_node(m, 1, p.node[1], ends);
  for (int i = 0; i < count; ++i) {
    if (pair_of_end(m, 1, ends[i] / f, ends[i] % f) != pair) continue;
    at.element = ends[i] / f;
    at.eta = local_eta(f, ends[i] % f);
    find_contact_element(m, 1, at.element, &zone, &at.place);
    double other;
    const double second = bulge_at(m, z, 1, at, &other);
    *doubt += other;
    return first + second;
  }
  return first;
}

void face_node(const Model& m, const Zone& z, Pair& p) {
  double x, y;
  FacePoint at{z.first_element[0], 0, 0};
  node_position(m, 1, p.node[1], &x, &y);
  face_point(m, z, x, y, at); // there is one: the zone was fitted
  p.element = at.element;
  p.eta = at.eta;
}

int32_t faced_node(const Model& m, const Pair& p) {
  return node_at(m, FacePoint{p.element, 0, p.eta});
}

void warn_unsure(const Model& m, int32_t zone, const Unsure& unsure, Reporter& reporter) {
  Finding f = warning(C2D_WARN_OVERLAP);
  locate_pair(f, m, unsure.pair);
  say(f, "zone ", zone + 1, ": ", unsure.count,
      " overlaps are smaller than what the elements may be off the surfaces, ");
  say_pair(f, m, unsure.pair);
  say(f, ": ", unsure.overlap, " against ", unsure.doubt);
  tell(reporter, f);
}

} // namespace c2d
