// Displacements and stresses at interior points (METHOD 16.3).
//
// Equations. Somigliana's identity for displacements and its derivative for stresses (Brebbia, Telles and Wrobel, Boundary
// Element Techniques, 1984), thesis (3.32) to (3.34):
//   u(P) = int U t ds - int T u ds,   sigma(P) = int D t ds - int S u ds,
// here in Muskhelishvili's complex notation, METHOD (16.2) and METHOD (16.3).
//
// Phases:
//   1. Back substitution, so that u and t are known on all boundaries.
//   2. Placing, per body: nearest boundary point and winding number decide whether a point is inside, on the boundary, or
//      outside (results/interior/interior_placing.cpp).
//   3. Integrals of every element over the inside points (results/interior/interior_elements.cpp), or of cells of elements for
//   large
//      bodies (results/interior/interior_cells.cpp). The displacement of the nearest boundary point is subtracted from u first.
//      A translation has no stress, so the result is unchanged, but the strongly singular integrals stay small near the
//      boundary.
//   4. Add the known fields: point loads, body forces, the reference displacement, and the rigid-body terms rho and omega of
//   the
//      balanced equations METHOD (2.5).
//   5. Write displacements, stresses and derived quantities. Points on the boundary take the boundary state.
//
// Order of loops. Points in blocks that fit in the cache, elements inside: each element is prepared once per block. Sums of a
// point are accumulated in its own row of the caller's output array, so the memory needed does not grow with the number of
// points.
#include "results/interior/interior.hpp"

#include <string.h>

#include "bie/body_force.hpp"
#include "bie/boundary_stress.hpp"
#include "bie/integrals/interior_detail.hpp"
#include "bie/integrals/kernels.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "memory/workers.hpp"
#include "results/back.hpp"
#include "results/interior/interior_cells.hpp"
#include "results/interior/interior_elements.hpp"
#include "results/rigid.hpp"
#include "results/transferred.hpp"
#include "solver/particular.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(BodyForcePart);
C2D_USES(RigidPart);
C2D_USES(RingPart);
C2D_USES(CompressedPart);

namespace {

[[gnu::noinline]] void take_field(const Session& session, const Transfer& piece, double stress, FieldElement& out) {
  Complex t[kElementNodes];
  out.in = piece.in;
  for (int k = 0; k < piece.in.functions; ++k) {
    double value[2];
    kFreeZonePart.transferred_values(session, piece, k, value);
    t[k] = {stress * value[0], stress * value[1]};
  }
  prepare_field(t, nullptr, out);
}

// The traction of one piece of a free zone as a field element. Not inlined: its frame must not add to that of the search for
// the next piece, nor to that of the integration.
[[gnu::noinline]] void field_of_piece(const Session& session, const TransferWalk& walk, FieldElement& out) {
  Transfer piece;
  kFreeZonePart.make_transfer(session.model, Quadrature::accurate, walk, piece);
  take_field(session, piece, 1.0 / (2.0 * shear_modulus(session.model, walk.body)), out);
}

[[gnu::noinline]] void act_on_points(const Session& session, const TransferWalk& walk, const Points& points) {
  Acting acting;
  acting.session = &session;
  acting.b = walk.body;
  acting.element = walk.piece.element1;
  acting.smoothing = nullptr;
  field_of_piece(session, walk, acting.e);
  add_element(acting, points);
}

// Adds the mortar-transferred tractions of free zones to a body. They are polynomial on the pieces between the nodes of both
// sides, not on its elements, and are therefore integrated piece by piece (METHOD 9.2).
[[gnu::noinline]] c2d_status add_transferred(const Session& session, int b, const Points& points) {
  TransferWalk walk{};
  walk.body = b;
  while (kFreeZonePart.next_transfer(session.model, walk)) {
    const c2d_status status = pause_at_points(session, b, walk.piece.element1);
    if (status != C2D_OK) return status;
    act_on_points(session, walk, points);
  }
  return C2D_OK;
}

// Field of the point loads of the body at a point: Kelvin's solution, in closed form, or round the axis.
PointField known_field(const Session& session, int b, double x, double y) {
  const Model& m = session.model;
  const double nu = strain_poisson_ratio(m, b), unit = m.head->length_unit;
  PointField sum = {};
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& load = m.point_load[i];
    if (load.body != b) continue;
    const double scale = balance_scale(m) * session.follower.load[load.load_case] / (2.0 * shear_modulus(m, b) * unit);
    const double force[2] = {scale * load.fx, scale * load.fy}, from[2] = {load.x / unit, load.y / unit}, at[2] = {x, y};
    if (is_axisymmetric(m))
      kRingPart.add_ring_force(force, nu, from, at, sum);
    else
      add_force_field({force[0], force[1]}, nu, from[0], from[1], x, y, sum);
  }
  return sum;
}

// Stress round the axis from the others, trace and deviator, and the radial displacement, in units of 2G: Hooke's law.
double round_stress(const Session& session, int b, double r, double ur, const double stress[3]) {
  const double nu = strain_poisson_ratio(session.model, b);
  return r > 0.0 ? nu * stress[0] + (1.0 + nu) * ur / r : 0.5 * (stress[0] + stress[1]);
}

// Adds to the integrals of a point: point loads and their images, body forces, the subtracted reference displacement, and the
// rigid-body terms rho + omega e_z x (x - x0), which absorb the collocation error and cause no stress.
[[gnu::noinline]] void complete_sums(const Session& session, int b, const Points& points, PointSums& p) {
  const double x = p.x, y = p.y;
  const double unit = session.model.head->length_unit;
  const double* rigid = results_of(session.solver, b).multiplier;
  const double* centre = session.model.body[b].centre;
  const int32_t lines = points.images(b);
  for (int image = 0; image <= lines; ++image) {
    if (!is_image(lines, image)) continue;
    const PointField known = known_field(session, b, points.seen(image, 0, x), points.seen(image, 1, y));
    add_displacement(image, known, p);
    add_stress(image, known, p);
  }
  if (has_body_force(session.model, b)) {
    const double at[2] = {x * unit, y * unit};
    double u[2] = {0.0, 0.0}, stress[3] = {0.0, 0.0, 0.0};
    kBodyForcePart.add_particular_at(session, b, at, u, stress);
    for (int c = 0; c < 2; ++c) p.u[c] += u[c];
    for (int c = 0; c < 3; ++c) p.stress[c] += stress[c];
    if (is_axisymmetric(session.model)) p.round += round_stress(session, b, x, u[0], stress);
  }
  if (is_axisymmetric(session.model) && x > 0.0) { // the stress of the motion that was subtracted, in units of 2G
    const double stretch = p.reference[0] / x;
    p.stress[0] -= stretch;
    p.stress[1] += 3.0 * stretch;
    p.round += stretch;
  }
  p.u[0] += p.reference[0] + rigid[0] - rigid[2] * (y - centre[1] / unit);
  p.u[1] += p.reference[1] + rigid[1] + rigid[2] * (x - centre[0] / unit);
}

// ---- results ------------------------------------------------------------------------------------------------------

void write_point(const double u[2], const PlaneStress& s, double szz, int32_t flag, double* out) {
  const double shear = largest_shear(s), mean = 0.5 * (s.xx + s.yy);
  out[C2D_POINT_UX] = u[0];
  out[C2D_POINT_UY] = u[1];
  out[C2D_POINT_SXX] = s.xx;
  out[C2D_POINT_SYY] = s.yy;
  out[C2D_POINT_SXY] = s.xy;
  out[C2D_POINT_SZZ] = szz;
  out[C2D_POINT_VON_MISES] = von_mises(s, szz);
  out[C2D_POINT_MAX_SHEAR] = shear;
  out[C2D_POINT_PRINCIPAL1] = mean + shear;
  out[C2D_POINT_PRINCIPAL2] = mean - shear;
  out[C2D_POINT_FLAG] = flag;
}

// Results of a point inside body b or on its boundary. Points of a symmetric model were folded into the modelled part: the
// signs fx, fy reflect the results back.
void finish_point(const Session& session, int b, const Points& points, int32_t i) {
  const Model& m = session.model;
  const double fx = points.folding(i, 0), fy = points.folding(i, 1);
  int32_t flag = static_cast<int32_t>(points.place(i) - place_of(b, 0));
  double u[2];
  PlaneStress stress = {0.0, 0.0, 0.0};
  double across = 0.0; // strain
  if (flag == C2D_POINT_BOUNDARY) {
    const PointSearch& p = points.search(i);
    const int32_t element = static_cast<int32_t>(p.element);
    const BoundaryState s = boundary_state(session, b, element, p.eta);
    for (int c = 0; c < 2; ++c) u[c] = s.u[c];
    stress = joint_stress(session, b, element, p.eta);
    stress.xy *= fx * fy;
    across = s.across;
  } else if (is_rigid(m, b)) {
    kRigidPart.rigid_displacement_now(session, b, points.x(i) * points.unit, points.y(i) * points.unit, u);
    flag = C2D_POINT_INSIDE;
  } else {
    PointSums& p = points.sums(i);
    const double g = shear_modulus(m, b);
    complete_sums(session, b, points, p);
    for (int c = 0; c < 2; ++c) u[c] = p.u[c] * points.unit;
    stress = {g * (p.stress[0] + p.stress[1]), g * (p.stress[0] - p.stress[1]), -g * p.stress[2]};
    stress.xy *= fx * fy;
  }
  u[0] *= fx;
  u[1] *= fy;
  double szz = stress_across(session, b, stress);
  if (is_axisymmetric(m))
    szz = flag != C2D_POINT_BOUNDARY ? 2.0 * shear_modulus(m, b) * points.sums(i).round
                                     : szz + body_of(m, b).youngs_modulus * across;
  write_point(u, stress, szz, flag, points.out + i * points.out_stride);
}

enum class Pass { afar, placing, integrals, displacements };

[[gnu::noinline, maybe_unused]] void place_from_afar(const Session& session, int b, int32_t element, const Points& points) {
  Integrator in;
  make_integrator(session.model, b, element, Quadrature::accurate, Measure::own_length, in);
  look_from_afar(in.element, points);
}

// One pass of one element over the points. The pass `afar` only saves time, and small code omits it.
template <Pass pass> void act(const Session& session, int b, int32_t element, const Points& points) {
  if constexpr (pass == Pass::integrals)
    integrate_element(session, b, element, points);
  else if constexpr (pass == Pass::displacements)
    integrate_displacements(session, b, element, points);
  else if constexpr (pass == Pass::placing || kSmallCode)
    place_by_element(session, b, element, points);
  else
    place_from_afar(session, b, element, points);
}

// Points are processed in blocks that stay in the cache while all elements act on them; threads take different blocks, so the
// order of summation for a point, and with it every bit of the result, does not depend on their number. Elements are processed
// in runs, and progress is reported between runs.
constexpr int32_t kBlockOfPoints = 1024, kRunOfElements = 32; // the first a multiple of kBatch

struct BlockJob {
  const Session* session;
  const Points* points;
  int b;
  int32_t first_point, first_element, last_element; // elements up to but excluding last_element

  Points block(int32_t i) const { return some_points(*points, first_point + i * kBlockOfPoints, kBlockOfPoints); }
};

// Task `i` of a BlockJob: one block of points and a run of elements.
template <Pass pass> void run_block(void* argument, int32_t i) {
  const BlockJob& job = *static_cast<const BlockJob*>(argument);
  const Points points = job.block(i);
  for (int32_t element = job.first_element; element < job.last_element; ++element)
    if (is_integrated(job.session->model, job.b, element)) act<pass>(*job.session, job.b, element, points);
}

template <Pass pass> c2d_status run_plain_pass(const Session& session, int b, const Points& points) {
  for (int32_t element = 0; element < session.model.body[b].elements; ++element) {
    if (!is_integrated(session.model, b, element)) continue;
    const c2d_status status = pause_at_points(session, b, element);
    if (status != C2D_OK) return status;
    act<pass>(session, b, element, points);
  }
  return C2D_OK;
}

// One pass of all elements of the body over all points.
template <Pass pass> c2d_status run_pass(const Session& session, int b, const Points& points) {
  const int32_t elements = session.model.body[b].elements;
  if constexpr (kSmallCode) return run_plain_pass<pass>(session, b, points);
  const int32_t blocks = (points.count + kBlockOfPoints - 1) / kBlockOfPoints;
  const Workers workers = workers_of(&session.solver->port);
  for (int32_t block = 0; block < blocks; block += workers.count) {
    const int32_t tasks = blocks - block < workers.count ? blocks - block : workers.count;
    for (int32_t first = 0; first < elements; first += kRunOfElements) {
      const int32_t last = elements - first < kRunOfElements ? elements : first + kRunOfElements;
      const int64_t done = (static_cast<int64_t>(block) * elements + static_cast<int64_t>(tasks) * first) / blocks;
      const c2d_status status = pause_at_points(session, b, static_cast<int32_t>(done));
      if (status != C2D_OK) return status;
      BlockJob job{&session, &points, b, block * kBlockOfPoints, first, last};
      run_tasks(workers, tasks, run_block<pass>, &job);
    }
  }
  return C2D_OK;
}

c2d_status place_points(const Session& session, int b, const Points& points) {
  begin_placing(points);
  c2d_status status = C2D_OK;
  if (!kSmallCode) {
    status = run_pass<Pass::afar>(session, b, points);
    if (status == C2D_OK) leave_afar(points);
  }
  if (status == C2D_OK) status = run_pass<Pass::placing>(session, b, points);
  if (status == C2D_OK) end_placing(session, b, points);
  return status;
}

// Evaluates the points of one body that no earlier body contains, except for writing them. Not inlined, like the next: their
// frames would add to that of back substitution.
[[gnu::noinline]] c2d_status evaluate_body(const Session& session, int b, const Points& points) {
  if (!kSmallCode && kCompressedPart.has_far_cells(session, b)) return kCompressedPart.evaluate_by_cells(session, b, points);
  c2d_status status = place_points(session, b, points);
  if (status == C2D_OK && !is_rigid(session.model, b)) status = run_pass<Pass::integrals>(session, b, points);
  if (status == C2D_OK && session.model.body[b].free_rows > 0) status = add_transferred(session, b, points);
  return status;
}

[[gnu::noinline]] void finish_points(const Session& session, const Points& points) {
  for (int32_t i = 0; i < points.count; ++i) {
    const double place = points.place(i);
    if (place == kUnplaced || place == kNowhere) {
      double* out = points.out + i * points.out_stride;
      for (int c = 0; c < C2D_POINT_FLAG; ++c) out[c] = 0.0;
      out[C2D_POINT_FLAG] = C2D_POINT_OUTSIDE;
    } else {
      finish_point(session, static_cast<int>(place) / 4 - 1, points, i);
    }
  }
}

// Excludes NaN, infinity and coordinates whose squares would overflow.
bool may_lie_inside(const Points& points, int32_t i) {
  const double bound = kBeyondAll * points.unit, *at = points.xy + i * points.xy_stride;
  return fabs(at[0]) < bound && fabs(at[1]) < bound;
}

// Zero boundary results, for states without a solution (unsupported rigid-body motions).
void clear_boundary(const Session& session) {
  const ModelHeader& head = *session.model.head;
  for (int b = 0; b < head.bodies; ++b) {
    const Body& body = session.model.body[b];
    const int64_t ends = static_cast<int64_t>(body.elements) * head.function_nodes;
    memset(session.area.displacement + 2 * body.first_node, 0, 2 * sizeof(Real) * static_cast<size_t>(body.nodes));
    memset(session.area.traction + 2 * body.first_end, 0, 2 * sizeof(Real) * static_cast<size_t>(ends));
    for (double& multiplier : results_of(session.solver, b).multiplier) multiplier = 0.0;
  }
}

// Distance from the boundary, in half lengths of the element, at which the limit from inside is evaluated. The displacement
// changes over it by about 1e-7 of the strain times the element length, far below the residuals of interest; much smaller
// distances would lose digits in the near-singular integrals.
constexpr double kInside = 1e-7;

[[gnu::noinline]] void place_inside(const Session& session, int b, const BoundaryPlace& at, const double u[2], PointSums& out) {
  const Model& m = session.model;
  const Element e = element_of(m, b, at.element);
  const Point p = element_point(e, at.eta);
  const double depth = kInside * e.half_length, unit = m.head->length_unit;
  double known[2] = {0.0, 0.0};
  if (has_body_force(m, b)) kBodyForcePart.interpolated_particular(session, b, at.element, at.eta, known);
  out = PointSums{};
  out.x = (p.x - depth * p.nx) / unit;
  out.y = (p.y - depth * p.ny) / unit;
  for (int c = 0; c < 2; ++c) out.reference[c] = (u[c] - known[c]) / unit;
  reference_motion(m, b, at.element, at.eta, out.x, out.y, out.reference);
  out.place = place_of(b, C2D_POINT_INSIDE);
}

// Not inlined: its frame, with elements, must not add to those of the following calls.
[[gnu::noinline]] c2d_status add_displacements(const Session& session, int b, const Points& points) {
  return run_pass<Pass::displacements>(session, b, points);
}

} // namespace

void interpolated_displacement(const Session& session, int b, const BoundaryPlace& at, double u[2]) {
  double value[kElementNodes], nodal[2];
  shape(session.model.head->function_nodes, at.eta, value);
  u[0] = u[1] = 0.0;
  for (int l = 0; l < session.model.head->function_nodes; ++l) {
    get_displacement(session, b, functional_node(session.model, b, at.element, l), nodal);
    for (int c = 0; c < 2; ++c) u[c] += value[l] * nodal[c];
  }
}

c2d_status off_interpolation(const Session& session, int b, int32_t count, const BoundaryPlace* at, double* out) {
  PointSums rows[kPlacesAtOnce];
  const double unit = session.model.head->length_unit;
  const Points points = {count,
                         nullptr,
                         0,
                         reinterpret_cast<double*>(rows),
                         C2D_POINT_FIELDS,
                         unit,
                         &session.model,
                         kSmallCode ? nullptr : batch_for(session.solver->instructions)};
  for (int32_t i = 0; i < count; ++i) {
    interpolated_displacement(session, b, at[i], out + 2 * i);
    place_inside(session, b, at[i], out + 2 * i, rows[i]);
  }
  c2d_status status = add_displacements(session, b, points);
  if (status == C2D_OK && session.model.body[b].free_rows > 0) status = add_transferred(session, b, points);
  for (int32_t i = 0; i < count && status == C2D_OK; ++i) {
    complete_sums(session, b, points, rows[i]);
    // The limit from inside contains half of the residual of the equation, METHOD (16.8).
    for (int c = 0; c < 2; ++c) out[2 * i + c] = 2.0 * (rows[i].u[c] * unit - out[2 * i + c]);
  }
  return status;
}

c2d_status evaluate_points(Session& session, int32_t body, const PointsAsked& asked) {
  c2d_solver* s = session.solver;
  if (s->blocked || s->floating) clear_boundary(session);
  c2d_status status = back_substitute_all(session);
  if (status != C2D_OK) return fail_store(s, status);
  const Points points = {asked.count,      asked.xy,
                         asked.xy_stride,  asked.out,
                         asked.out_stride, s->model.length_unit,
                         &session.model,   kSmallCode ? nullptr : batch_for(session.solver->instructions)};
  for (int32_t i = 0; i < points.count; ++i) points.place(i) = may_lie_inside(points, i) ? kUnplaced : kNowhere;
  for (int b = 0; b < s->model.bodies && status == C2D_OK; ++b)
    if (body == 0 || body == b + 1) status = evaluate_body(session, b, points);
  if (status == C2D_OK) finish_points(session, points);
  return status;
}

} // namespace c2d
