#include "contact/frictionless.hpp"

#include "contact/body_unknowns.hpp"

namespace c2d {

namespace {

// The pair of a contact unknown.
int32_t pair_of_slot(const Model& m, int32_t dof) {
  int32_t first = 0, last = m.head->pairs - 1;
  while (first < last) {
    const int32_t middle = last - (last - first) / 2;
    if (m.pair[middle].dof <= dof)
      first = middle;
    else
      last = middle - 1;
  }
  return first;
}

} // namespace

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

c2d_status read_form(const ContactTape& tape, Real* column, bool* sliding) {
  const Model& m = *tape.model;
  int32_t pair = 0;
  while (pair < m.head->path_pairs && m.pair[pair].tangential == 0) ++pair;
  *sliding = has_sliding_form(m) && pair < m.head->path_pairs;
  if (!*sliding) return C2D_OK;
  const c2d_status status = read_column(tape, ContactMatrix::stiffness, m.pair[pair].dof + 1, column);
  for (int32_t i = 0; i < m.head->contact && status == C2D_OK; ++i) *sliding = *sliding && column[i] == 0;
  return status;
}

} // namespace c2d
