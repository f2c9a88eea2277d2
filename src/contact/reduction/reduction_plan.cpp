#include "contact/reduction/reduction_plan.hpp"

#include "memory/math.hpp"
#include "model/geometry.hpp"

namespace c2d {

namespace {

constexpr int32_t kUndecided = -1;
constexpr int32_t kFarMore = 4, kMostSlender = 100000000;
// More slender ones lose digits when they are solved for, held or not: with linear functions a hundred times fewer.
constexpr int32_t kSlender = 30, kSlenderLinear = 1000;

// A body that meets itself is as good as one that meets another.
bool meets_kept(const Model& m, int b) {
  for (int32_t i = 0; i < m.head->zones; ++i)
    for (int side = 0; side < 2; ++side)
      if (m.zone[i].body[side] == b && (m.zone[i].body[1 - side] == b || keeps_equations(m, m.zone[i].body[1 - side])))
        return true;
  return false;
}

// A ring that widens gives way like a strip that is shorter by the root of this: it does not bend.
constexpr double kOfRing = 32.0;

// How many squares of its thickness a strip is long: the square of the body's size over its area. About 2 for stout bodies. Of
// a ring also that of its distance from the axis.
int32_t slenderness(const Model& m, int b) {
  double area = 0.0;
  for (int32_t region = 0; region < m.body[b].regions; ++region) area += region_area(m, b, region);
  const Box box = box_of_body(m, b);
  const double dx = box.x_max - box.x_min, dy = box.y_max - box.y_min, far = is_axisymmetric(m) ? box.x_max : 0.0;
  const double size = fmax(dx * dx + dy * dy, far * far / kOfRing);
  return size < kMostSlender * area ? static_cast<int32_t>(size / area) : kMostSlender;
}

// Is it by far more slender? It bends, then, under its own tractions by many times what it gives way locally (METHOD 10.2).
bool is_more_slender(const Model& m, int a, int b) {
  return !kSmallCode && m.body[a].first_border > kFarMore * static_cast<int64_t>(m.body[b].first_border);
}

bool goes_before(const Model& m, int a, int b) {
  const bool a_floats = m.body[a].free_motions > 0, b_floats = m.body[b].free_motions > 0;
  if (a_floats != b_floats) return a_floats;
  if (is_more_slender(m, a, b) || is_more_slender(m, b, a)) return is_more_slender(m, a, b);
  return shear_modulus(m, a) < shear_modulus(m, b);
}

// Would digits be lost if it were solved for? first_border is its slenderness.
bool bends_much(const Model& m, int b) {
  return !kSmallCode && m.body[b].first_border > (m.head->function_nodes > 2 ? kSlender : kSlenderLinear);
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
    m.body[b].keeps_equations = m.body[b].contact == 0 || is_rigid(m, b) ? kSolvedFor : kUndecided;
  for (int b = 0; !kSmallCode && b < m.head->bodies; ++b) // stands there until the plan is made
    if (m.body[b].keeps_equations == kUndecided) m.body[b].first_border = slenderness(m, b);
  for (int b = next_body(m); b >= 0; b = next_body(m))
    m.body[b].keeps_equations = !meets_kept(m, b) ? kKept : bends_much(m, b) ? kDisplacements : kSolvedFor;
  m.head->border = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    m.body[b].first_border = m.head->border;
    if (m.body[b].contact > 0 && !keeps_equations(m, b)) m.head->border += m.body[b].free_motions;
  }
}

} // namespace c2d
