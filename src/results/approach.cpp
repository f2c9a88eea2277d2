// How far the bodies of a zone have come closer, and past each other (METHOD 16.8).
#include "results/approach.hpp"

#include <math.h>

#include "bie/measure.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "results/back.hpp"
#include "results/table.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

constexpr double kNoDirection = 1e-6; // a mean of unit normals below that is round-off: they go all round

// Is there a traction in any load case, or does a platen move the element?
bool is_loaded(const Model& m, int b, int32_t element) {
  ZonePlace at;
  if (find_contact_element(m, b, element, &at)) return is_platen(m, m.zone[at.zone].body[0]);
  for (int32_t end = element * m.head->function_nodes; end < (element + 1) * m.head->function_nodes; ++end)
    for (int32_t k = 0; k < m.head->load_cases; ++k)
      for (int c = 0; c < 2; ++c)
        if (traction_known(m, b, end, c) && given_traction(m, b, end, c, k) != 0.0) return true;
  return false;
}

struct Mean {
  double length = 0.0, u[2] = {0.0, 0.0}; // u: times length
};

void add_element(const Session& session, int b, int32_t element, Mean& out) {
  const Model& m = session.model;
  EndResultant weight[kElementNodes];
  end_resultants(m, b, element, Measure::own_length, weight);
  for (int l = 0; l < m.head->function_nodes; ++l) {
    double u[2];
    get_displacement(session, b, functional_node(m, b, element, l), u);
    out.length += weight[l].w;
    for (int c = 0; c < 2; ++c) out.u[c] += weight[l].w * u[c];
  }
}

// Of a rigid body its own, of another the mean over what is loaded of its boundary, or over all of it.
void body_motion(const Session& session, int b, double u[2]) {
  const Model& m = session.model;
  if (is_rigid(m, b)) {
    double motion[3];
    kRigidPart.rigid_motion_now(session, b, motion);
    u[0] = motion[0], u[1] = motion[1];
    return;
  }
  Mean all, loaded;
  for (int32_t element = 0; element < m.body[b].elements; ++element) {
    if (!is_integrated(m, b, element)) continue;
    add_element(session, b, element, all);
    if (is_loaded(m, b, element)) add_element(session, b, element, loaded);
  }
  const Mean& mean = loaded.length > 0.0 ? loaded : all;
  for (int c = 0; c < 2; ++c) // the image moves the other way across a line of symmetry
    u[c] = (m.body[b].lines >> c & 1) != 0 ? 0.0 : mean.u[c] / mean.length;
}

// Lines of symmetry that a zone ends on: it goes on in its image.
int32_t lines_of_zone(const Model& m, const Zone& z) {
  int32_t out = 0;
  if ((m.body[z.body[0]].lines & m.body[z.body[1]].lines) == 0) return out;
  for (int end = 0; end < 2; ++end) {
    const int32_t element = zone_element(m, z, 1, end == 0 ? 0 : zone_elements(z, 1) - 1);
    for (int k = 0; k < body_of(m, z.body[1]).element_nodes; ++k) {
      const double* p = m.xy[z.body[1]] + 2 * static_cast<int64_t>(geometry_node(m, z.body[1], element, k));
      out |= lines_through(*m.head, p[0], p[1]);
    }
  }
  return out;
}

// The mean normal from side 1 to side 2; of a zone that goes all round the direction of its force, which may have none.
bool find_direction(const Model& m, const Zone& z, const double force[2], double n[2]) {
  double sum = 0.0;
  n[0] = n[1] = 0.0;
  for (int32_t i = z.first_pair; i < z.first_pair + z.pairs; ++i) {
    const Pair& pair = m.pair[i];
    sum += pair.weight, n[0] += pair.weight * pair.nx, n[1] += pair.weight * pair.ny;
  }
  const int32_t lines = lines_of_zone(m, z);
  for (int c = 0; c < 2; ++c)
    if ((lines >> c & 1) != 0) n[c] = 0.0;
  double size = hypot(n[0], n[1]);
  if (size < kNoDirection * sum) {
    size = hypot(force[0], force[1]);
    n[0] = force[0], n[1] = force[1];
  }
  if (!(size > 0.0)) return false;
  n[0] /= size, n[1] /= size;
  return true;
}

} // namespace

c2d_status find_approach(Session& session, const Zone& zone, c2d_zone_state& out) {
  const Model& m = session.model;
  double n[2];
  if (zone.is_tied != 0 || zone.body[0] == zone.body[1] || !find_direction(m, zone, out.force, n)) return C2D_OK;
  const bool rigid = is_rigid(m, zone.body[0]) && is_rigid(m, zone.body[1]);
  c2d_status status = session.solver->table_is_current ? c2d_status{C2D_OK} : fill_table(session);
  if (status == C2D_OK && !rigid) status = back_substitute_all(session);
  if (status != C2D_OK) return status;
  double u[2][2];
  for (int side = 0; side < 2; ++side) body_motion(session, zone.body[side], u[side]);
  out.approach = (u[0][0] - u[1][0]) * n[0] + (u[0][1] - u[1][1]) * n[1];
  out.shift = (u[1][0] - u[0][0]) * n[1] - (u[1][1] - u[0][1]) * n[0];
  return C2D_OK;
}

} // namespace c2d
