// Approach and shift of the two bodies of a contact zone (METHOD 16.8).
//
// Phases:
//   1. Motion of each body. Rigid body: the motion of its reference point. Deformable body: the mean displacement over the
//      loaded part of its boundary, u_mean = (1/L) int u ds; over the whole boundary if no element is loaded.
//   2. Direction n: the mean normal of the pairs, weighted by their lengths.
//   3. approach = (u_0 - u_1).n,  shift = (u_1 - u_0).t,  with t = (n_y, -n_x) and u_0, u_1 the motions of sides 0 and 1.
//
// Phase 1 does not back-substitute at every load. The mean is a linear functional of the unknowns of the body, and back
// substitution is linear in the contact displacements, contact tractions and load factors. If U x = V c gives the unknowns x
// from the coefficients c, then m.x = (V^T U^-T m).c: one adjoint (transposed) solve per component, stored once, replaces all
// later back substitutions by a scalar product. This is the adjoint method for sensitivities of linear systems.
//
// The mean over the loaded part is used because the displacement of a half plane under a line load grows logarithmically with
// distance (Johnson, Contact Mechanics, 1985, section 2.2): the approach of two bodies has no meaning without a reference.
#include "results/approach.hpp"

#include "bie/columns.hpp"
#include "bie/measure.hpp"
#include "contact/body_unknowns.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "results/back.hpp"
#include "results/table.hpp"
#include "solver/energy/energy_adjoint.hpp"

namespace c2d {

C2D_USES(RigidPart);

namespace {

// Around a closed curve the normals cancel: a mean unit normal shorter than this is round-off and has no direction.
constexpr double kNoDirection = 1e-6;

// Loaded: a non-zero prescribed traction in some load case, or motion by a platen. All load cases count, so that the reference
// does not change along a load path.
bool is_loaded(const Model& m, int b, int32_t element) {
  ZonePlace at;
  if (find_contact_element(m, b, element, &at)) return is_platen(m, m.zone[at.zone].body[0]);
  for (int32_t end = element * m.head->function_nodes; end < (element + 1) * m.head->function_nodes; ++end)
    for (int32_t k = 0; k < m.head->load_cases; ++k)
      for (int c = 0; c < 2; ++c)
        if (traction_known(m, b, end, c) && given_traction(m, b, end, c, k) != 0.0) return true;
  return false;
}

// ---- mean motion of a boundary as a linear functional, computed once -----------------------------------------------------

// Coefficients of the functional for each component, in the order of the trailing columns of the body (results/back.hpp).
struct MeanMotion {
  Real* of_contact[2]; // [2 contact]
  double* of_loads[2]; // [cases]
};

MeanMotion mean_motion(const Session& session, int b) {
  const Model& m = session.model;
  Real* contact = session.area.mean_motion;
  double* loads = array_of<double>(session.solver, kMotionOfLoads);
  for (int before = 0; before < b; ++before) {
    contact += 4 * static_cast<int64_t>(m.body[before].contact);
    loads += m.body[before].contact > 0 ? 2 * m.head->load_cases : 0;
  }
  return {{contact, contact + 2 * static_cast<int64_t>(m.body[b].contact)}, {loads, loads + m.head->load_cases}};
}

double length_of(const Model& m, int b, int32_t element) {
  EndResultant weight[kElementNodes];
  double length = 0.0;
  end_resultants(m, b, element, Measure::own_length, weight);
  for (int l = 0; l < m.head->function_nodes; ++l) length += weight[l].w;
  return length;
}

struct Part {
  bool loaded; // true: only loaded elements; false: the whole boundary
  double length;
};

bool is_within(const Model& m, int b, int32_t element, bool loaded) {
  return is_integrated(m, b, element) && (!loaded || is_loaded(m, b, element));
}

double length_within(const Model& m, int b, bool loaded) {
  double length = 0.0;
  for (int32_t element = 0; element < m.body[b].elements; ++element)
    if (is_within(m, b, element, loaded)) length += length_of(m, b, element);
  return length;
}

Part part_that_counts(const Model& m, int b) {
  const Part loaded{true, length_within(m, b, true)};
  return loaded.length > 0.0 ? loaded : Part{false, length_within(m, b, false)};
}

void add_mean(Adjoint& a, const Part& part, int c) {
  const Model& m = a.model();
  for (int32_t element = 0; element < m.body[a.b].elements; ++element) {
    if (!is_within(m, a.b, element, part.loaded)) continue;
    EndResultant weight[kElementNodes];
    end_resultants(m, a.b, element, Measure::own_length, weight);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const int32_t node = functional_node(m, a.b, element, l);
      add_displacement(a, node, c, unknown_at(m, a.b, node, c), weight[l].w / part.length);
    }
  }
}

// Work arrays of one functional.
struct Work {
  Real *own, *outer, *coefficient;
};

// The functional of component c in terms of all unknowns of the body: `outer` (eliminated), `own` (contact displacements),
// loads.
void begin_component(Session& session, int b, const Part& part, int c, const Work& work) {
  const Model& m = session.model;
  const MeanMotion out = mean_motion(session, b);
  for (int32_t k = 0; k < m.head->load_cases; ++k) out.of_loads[c][k] = 0.0;
  for (int32_t j = 0; j < m.body[b].contact; ++j) work.own[j] = 0;
  for (int32_t j = 0; j < outer_columns(m, b); ++j) work.outer[j] = 0;
  Adjoint a{&session,         b,  nullptr, nullptr, out.of_loads[c], nullptr, work.own, work.outer,
            work.coefficient, {}, false,   0,       nullptr};
  add_mean(a, part, c);
}

// After the transposed factors have moved the share of `outer` to the trailing columns. `own` is subtracted because the column
// of u_c represents -u_c.
void end_component(Session& session, int b, int c, const Work& work) {
  const Model& m = session.model;
  const MeanMotion out = mean_motion(session, b);
  const int32_t own = m.body[b].contact;
  for (int32_t j = 0; j < 2 * own; ++j) out.of_contact[c][j] = work.coefficient[j];
  for (int32_t j = 0; j < own; ++j) out.of_contact[c][j] -= work.own[j];
  for (int32_t k = 0; k < m.head->load_cases; ++k) out.of_loads[c][k] += static_cast<double>(work.coefficient[2 * own + k]);
}

c2d_status solve_outer(Session& session, int b, const Work* work, int32_t count) {
  Real *f[2], *w[2];
  for (int32_t i = 0; i < count; ++i) {
    f[i] = work[i].outer;
    w[i] = work[i].coefficient;
  }
  return solve_transposed(session, b, count, f, w);
}

// Across a line of symmetry the image moves in the opposite direction, so the mean of the complete body is zero.
bool is_mirrored(const Model& m, int b, int c) { return (m.body[b].lines >> c & 1) != 0; }

// Both components need one pass over the factors if there are arrays for two: where results of all bodies go that are not
// there.
bool has_room_for_two(const Session& session, int b) {
  if (kSmallCode || session.solver->back_substituted != 0) return false;
  const Model& m = session.model;
  const PhaseSizes sizes = model_sizes(m);
  return outer_columns(m, b) <= 2 * sizes.nodes && 3 * m.body[b].contact + m.head->load_cases <= 2 * sizes.ends;
}

c2d_status find_mean_motion(Session& session, int b) {
  const Model& m = session.model;
  const PathArea& area = session.area;
  const Part part = part_that_counts(m, b);
  const Work work[2] = {{area.own, area.outer, area.coefficient},
                        {area.traction, area.displacement, area.traction + m.body[b].contact}};
  if (!is_mirrored(m, b, 0) && !is_mirrored(m, b, 1) && has_room_for_two(session, b)) {
    for (int c = 0; c < 2; ++c) begin_component(session, b, part, c, work[c]);
    const c2d_status status = solve_outer(session, b, work, 2);
    for (int c = 0; c < 2; ++c) end_component(session, b, c, work[c]);
    return status;
  }
  c2d_status status = C2D_OK;
  for (int c = 0; c < 2 && status == C2D_OK; ++c) {
    if (is_mirrored(m, b, c)) continue;
    begin_component(session, b, part, c, work[0]);
    status = solve_outer(session, b, work, 1);
    end_component(session, b, c, work[0]);
  }
  return status;
}

// Tied surfaces do not approach, and in self-contact both sides have the same motion.
bool has_approach(const Zone& zone) { return zone.is_tied == 0 && zone.body[0] != zone.body[1]; }

bool takes_part(const Model& m, int b) {
  for (int32_t z = 0; z < m.head->zones; ++z)
    if (has_approach(m.zone[z]) && (m.zone[z].body[0] == b || m.zone[z].body[1] == b)) return !is_rigid(m, b);
  return false;
}

// The functionals are stored only if there is memory for them. With lazy columns (METHOD 10.12) the trailing columns do not
// exist yet. In both cases displacements are computed by back substitution and averaged directly.
bool has_functionals(const Model& m) { return C2D_MEAN_MOTION_(m.head->contact) > 0 && !is_on_demand(m); }

c2d_status make_ready(Session& session) {
  c2d_solver* s = session.solver;
  if (!has_functionals(session.model)) return back_substitute_all(session);
  c2d_status status = C2D_OK;
  for (int b = 0; b < session.model.head->bodies && status == C2D_OK && s->mean_motions == 0; ++b)
    if (takes_part(session.model, b)) status = find_mean_motion(session, b);
  if (status == C2D_OK) s->mean_motions = 1;
  return status;
}

double sum_of_displacements(const Session& session, int b, int c) {
  const Model& m = session.model;
  const Part part = part_that_counts(m, b);
  double sum = 0.0;
  for (int32_t element = 0; element < m.body[b].elements; ++element) {
    if (!is_within(m, b, element, part.loaded)) continue;
    EndResultant weight[kElementNodes];
    end_resultants(m, b, element, Measure::own_length, weight);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      double u[2];
      get_displacement(session, b, functional_node(m, b, element, l), u);
      sum += weight[l].w * u[c] / part.length;
    }
  }
  return sum;
}

// Scalar product of the functional with the current coefficients. Precondition: trailing_coefficients of the body.
double value_of(const Session& session, int b, int c) {
  const Model& m = session.model;
  const MeanMotion mean = mean_motion(session, b);
  const Real* now = session.area.coefficient;
  double sum = 0.0;
  for (int32_t j = 0; j < 2 * m.body[b].contact; ++j)
    sum += static_cast<double>(mean.of_contact[c][j]) * static_cast<double>(now[j]);
  for (int32_t k = 0; k < m.head->load_cases; ++k) sum += mean.of_loads[c][k] * session.follower.load[k];
  return sum * m.head->length_unit;
}

void body_motion(const Session& session, int b, double u[2]) {
  const Model& m = session.model;
  if (is_rigid(m, b)) {
    double motion[3];
    kRigidPart.rigid_motion_now(session, b, motion);
    u[0] = motion[0], u[1] = motion[1];
    return;
  }
  if (has_functionals(m)) trailing_coefficients(session, b, session.area.coefficient);
  for (int c = 0; c < 2; ++c)
    u[c] = is_mirrored(m, b, c) ? 0.0 : has_functionals(m) ? value_of(session, b, c) : sum_of_displacements(session, b, c);
}

// ---- directions ---------------------------------------------------------------------------------------------------------

// Lines of symmetry on which the zone ends. There the zone continues in its image, whose normals cancel one component.
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

// The mean normal from side 0 to side 1. If the zone closes on itself, as for a pin in a hole, the normals cancel and the
// direction of the contact force is used; without force there is no direction and the result is false.
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
  if (!has_approach(zone) || !find_direction(m, zone, out.force, n)) return C2D_OK;
  const bool rigid = is_rigid(m, zone.body[0]) && is_rigid(m, zone.body[1]);
  c2d_status status = session.solver->table_is_current ? c2d_status{C2D_OK} : fill_table(session);
  if (status == C2D_OK && !rigid) status = make_ready(session);
  if (status != C2D_OK) return status;
  double u[2][2]; // mean motions of both sides
  for (int side = 0; side < 2; ++side) body_motion(session, zone.body[side], u[side]);
  out.approach = (u[0][0] - u[1][0]) * n[0] + (u[0][1] - u[1][1]) * n[1];
  out.shift = (u[1][0] - u[0][0]) * n[1] - (u[1][1] - u[0][1]) * n[0];
  return C2D_OK;
}

} // namespace c2d
