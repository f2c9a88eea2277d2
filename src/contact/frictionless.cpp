#include "contact/frictionless.hpp"

#include "contact/basis.hpp"
#include "contact/body_unknowns.hpp"

namespace c2d {

int32_t first_sliding_slot(const Model& m) {
  for (int32_t i = 0; i < m.head->path_pairs; ++i)
    if (m.pair[i].tangential != 0) return m.pair[i].dof + 1;
  return -1;
}

bool has_sliding_form(const Model& m) {
  return !kSmallCode && has_basis(m.head->contact) && m.head->motions < m.head->contact && first_sliding_slot(m) >= 0;
}

bool is_sliding_slot(const Model& m, int32_t dof) {
  return dof < m.head->path_unknowns && m.pair[pair_of_slot(m, dof)].dof != dof;
}

bool is_sliding_slot(const Model& m, int b, int32_t own) {
  bool sliding = false;
  for_ranges(m, b, [&](const UnknownRange& range) {
    if (own >= range.own && own < range.own + range.count) sliding = is_sliding_slot(m, range.all + own - range.own);
  });
  return sliding;
}

int32_t given_number(const Model& m, int32_t dof) {
  const int32_t tied = dof - m.head->path_unknowns;
  return tied < 0 ? pair_of_slot(m, dof) : m.head->path_pairs + tied;
}

} // namespace c2d
