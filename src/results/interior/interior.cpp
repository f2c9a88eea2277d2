// Displacements and stresses at interior points (METHOD 16.3).
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

// What a piece of a free zone acts with. (None of this may stand below the search for the next piece, nor the piece below
// what it does.)
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

// Tractions that free zones hand over to a body.
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

// Whatever is known in closed form at a point: so far point loads.
PointField known_field(const Session& session, int b, double x, double y) {
  const Model& m = session.model;
  const double nu = strain_poisson_ratio(m, b), unit = m.head->length_unit;
  PointField sum = {};
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& load = m.point_load[i];
    if (load.body != b) continue;
    const double scale = session.follower.load[load.load_case] / (2.0 * shear_modulus(m, b) * unit);
    add_force_field({scale * load.fx, scale * load.fy}, nu, load.x / unit, load.y / unit, x, y, sum);
  }
  return sum;
}

// That, the reference, and rho + omega e_z x (x - x0) of the balanced equations.
[[gnu::noinline]] void complete_sums(const Session& session, int b, const Points& points, PointSums& p) {
  const double x = p.x, y = p.y;
  const double unit = session.model.head->length_unit;
  const double* rigid = results_of(session.solver, b).multiplier;
  const double* centre = session.model.body[b].centre;
  const int32_t lines = points.lines(b);
  for (int image = 0; image <= lines; ++image) {
    if (!is_image(lines, image)) continue;
    const PointField known = known_field(session, b, points.seen(image, 0, x), points.seen(image, 1, y));
    add_displacement(image, known, p);
    add_stress(image, known, p);
  }
  if (has_body_force(session.model, b)) {
    const double at[2] = {x * unit, y * unit};
    kBodyForcePart.add_particular_at(session, b, at, p.u, p.stress);
  }
  p.u[0] += p.reference[0] + rigid[0] - rigid[2] * (y - centre[1] / unit);
  p.u[1] += p.reference[1] + rigid[1] + rigid[2] * (x - centre[0] / unit);
}

// ---- results ------------------------------------------------------------------------------------------------------

void write_point(const Session& session, int b, const double u[2], const PlaneStress& s, int32_t flag, double* out) {
  const double szz = stress_across(session, b, s), shear = largest_shear(s), mean = 0.5 * (s.xx + s.yy);
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

// A point that lies in body b or on its boundary.
void finish_point(const Session& session, int b, const Points& points, int32_t i) {
  const Model& m = session.model;
  const double fx = points.folding(i, 0), fy = points.folding(i, 1);
  int32_t flag = static_cast<int32_t>(points.place(i) - place_of(b, 0));
  double u[2];
  PlaneStress stress = {0.0, 0.0, 0.0};
  if (flag == C2D_POINT_BOUNDARY) {
    const PointSearch& p = points.search(i);
    const int32_t element = static_cast<int32_t>(p.element);
    const BoundaryState s = boundary_state(session, b, element, p.eta);
    for (int c = 0; c < 2; ++c) u[c] = s.u[c];
    stress = joint_stress(session, b, element, p.eta);
    stress.xy *= fx * fy;
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
  write_point(session, b, u, stress, flag, points.out + i * points.out_stride);
}

enum class Pass { afar, placing, integrals, displacements };

[[gnu::noinline, maybe_unused]] void place_from_afar(const Session& session, int b, int32_t element, const Points& points) {
  Integrator in;
  make_integrator(session.model, b, element, Quadrature::accurate, Measure::own_length, in);
  look_from_afar(in.element, points);
}

// One element on these points. Small code does without the first pass.
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

// Points are taken in blocks that stay in the cache while all elements act on them, several blocks at once where there
// are threads for it; and elements in runs, between which the caller is told of the progress.
constexpr int32_t kBlockOfPoints = 1024, kRunOfElements = 32; // the first a multiple of kBatch

struct BlockJob {
  const Session* session;
  const Points* points;
  int b;
  int32_t first_point, first_element, last_element; // this one not

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

// All elements of the body on all points, in one of the passes.
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

// The points of one body that are not in an earlier one, complete but for writing them out. (Not inlined, like the next:
// their frames would stand below that of back substitution.)
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

// A number, and no absurd one.
bool may_lie_inside(const Points& points, int32_t i) {
  const double bound = kBeyondAll * points.unit, *at = points.xy + i * points.xy_stride;
  return fabs(at[0]) < bound && fabs(at[1]) < bound;
}

// Results while nothing is solved yet.
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

// Just inside the body, and in error by that part of an element times the strain.
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
  out.place = place_of(b, C2D_POINT_INSIDE);
}

// Not inlined: its elements must not stand below what follows.
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
