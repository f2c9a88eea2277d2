#include "contact/reduction_plan.hpp"

namespace c2d {

namespace {

constexpr int32_t kUndecided = -1;

// A body that meets itself is as good as one that meets another.
bool meets_kept(const Model& m, int b) {
  for (int32_t i = 0; i < m.head->zones; ++i)
    for (int side = 0; side < 2; ++side)
      if (m.zone[i].body[side] == b && (m.zone[i].body[1 - side] == b || m.body[m.zone[i].body[1 - side]].keeps_equations == 1))
        return true;
  return false;
}

bool goes_before(const Model& m, int a, int b) {
  const bool a_floats = m.body[a].free_motions > 0, b_floats = m.body[b].free_motions > 0;
  if (a_floats != b_floats) return a_floats;
  return shear_modulus(m, a) < shear_modulus(m, b);
}

// The body to decide on next; -1: all are.
int next_body(const Model& m) {
  int best = -1;
  for (int b = m.head->bodies - 1; b >= 0; --b)
    if (m.body[b].keeps_equations == kUndecided && (best < 0 || goes_before(m, b, best))) best = b;
  return best;
}

} // namespace

void plan_reduction(const Model& m) {
  for (int b = 0; b < m.head->bodies; ++b)
    m.body[b].keeps_equations = m.body[b].contact == 0 || is_rigid(m, b) ? 0 : kUndecided;
  for (int b = next_body(m); b >= 0; b = next_body(m)) m.body[b].keeps_equations = meets_kept(m, b) ? 0 : 1;
  m.head->border = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    m.body[b].first_border = m.head->border;
    if (m.body[b].contact > 0 && m.body[b].keeps_equations == 0) m.head->border += m.body[b].free_motions;
  }
}

} // namespace c2d
