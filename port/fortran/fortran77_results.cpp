// Results: fields, interior points, summary, lists of the model.
#include "fortran77.hpp"

#include <cmath>
#include <string.h>

using namespace c2d::fortran;

namespace {

const char* behind(In from, int64_t reals) { return static_cast<const char*>(from) + reals * 8; }
char* behind(Out to, int64_t reals) { return static_cast<char*>(to) + reals * 8; }

constexpr int32_t kChunk = 32; // entries fetched at a time if the array of the caller is not aligned

c2d_status get_in_chunks(c2d_solver* solver, int32_t field, int32_t body, int32_t first, int32_t count, Out a, int64_t stride) {
  double some[kChunk] = {};
  // The last entry is read first: if there are fewer, the call fails before anything is written.
  if (first < 1 || first > INT32_MAX - count) return C2D_ERR_ARGUMENT;
  c2d_status status = c2d_get(solver, field, body, count > 0 ? first + count - 1 : first, count > 0 ? 1 : 0, some, 1);
  for (int32_t done = 0; done < count && status == C2D_OK; done += kChunk) {
    const int32_t now = count - done < kChunk ? count - done : kChunk;
    status = c2d_get(solver, field, body, first + done, now, some, 1);
    for (int32_t i = 0; i < now; ++i) put_real(behind(a, (done + i) * stride), some[i]);
  }
  return status;
}

c2d_status points_one_by_one(c2d_solver* solver, int32_t body, int32_t count, In xy, int64_t xy_stride, Out a, int64_t stride) {
  double row[C2D_POINT_FIELDS];
  for (int32_t i = 0; i < count; ++i) { // a wrong one is refused before anything is written
    const double point[2] = {real_at(behind(xy, i * xy_stride)), real_at(behind(xy, i * xy_stride), 1)};
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
      return c2d_interior(solver, body, 1, point, 2, row, C2D_POINT_FIELDS);
  }
  for (int32_t i = 0; i < count; ++i) {
    const double point[2] = {real_at(behind(xy, i * xy_stride)), real_at(behind(xy, i * xy_stride), 1)};
    const c2d_status status = c2d_interior(solver, body, 1, point, 2, row, C2D_POINT_FIELDS);
    if (status != C2D_OK) return status;
    memcpy(behind(a, i * stride), row, sizeof row);
  }
  return C2D_OK;
}

// The last element is read first: if there are fewer, the call fails before anything is written.
c2d_status indicators_one_by_one(c2d_solver* solver, int32_t body, int32_t first, int32_t count, Out a, int64_t stride) {
  double row[C2D_OFF_FIELDS];
  if (first < 1 || first > INT32_MAX - count) return C2D_ERR_ARGUMENT;
  for (int32_t i = count - 1; i >= 0; --i) {
    const c2d_status status = c2d_indicators(solver, body, first + i, 1, row, C2D_OFF_FIELDS);
    if (status != C2D_OK) return status;
    memcpy(behind(a, i * stride), row, sizeof row);
  }
  return C2D_OK;
}

// The last point is read first: if there are fewer, the call fails before anything is written.
c2d_status expand_one_by_one(const c2d_points& points, int32_t first, int32_t count, Out xy, int64_t stride, int32_t& total) {
  double point[2];
  if (count < 0 || first > INT32_MAX - count) return C2D_ERR_ARGUMENT;
  c2d_status status = c2d_expand_points(&points, first, 0, point, 2, &total);
  for (int32_t i = count - 1; i >= 0 && status == C2D_OK; --i) {
    status = c2d_expand_points(&points, first + i, 1, point, 2, &total);
    if (status == C2D_OK) memcpy(behind(xy, i * stride), point, sizeof point);
  }
  return status;
}

// All counts and reals of a result.
template <size_t N, size_t M> void put_numbers(const int32_t (&counts)[N], Out icount, const double (&reals)[M], Out r) {
  memcpy(icount, counts, sizeof counts);
  memcpy(r, reals, sizeof reals);
}

// The first `count` of a list of numbers, or all of it.
template <class T, class Put> void put_list(Out to, int32_t count, const T* list, int32_t length, Put put) {
  for (int32_t i = 0; i < count && i < length; ++i) put(to, list[i], i);
}

void put_summary(const c2d_summary& s, const c2d_body_result (&body)[2], Out isum, int32_t ni, Out rsum, int32_t nr) {
  const int32_t integers[] = {s.state,
                              s.outcome,
                              s.outcome_body,
                              s.outcome_pair,
                              s.bodies,
                              s.function_nodes,
                              s.pairs,
                              s.zones,
                              s.steps,
                              s.coefficients,
                              body[0].elements,
                              body[1].elements,
                              body[0].nodes,
                              body[1].nodes,
                              body[0].unknowns,
                              body[1].unknowns,
                              s.contact_unknowns,
                              s.paths,
                              s.load_cases,
                              s.warnings,
                              at_most(static_cast<uint64_t>(s.events))};
  double reals[28] = {
      s.load,      s.mu,   s.force_applied, s.force_contact, s.force_error,   s.max_residual, s.elimination_residual,
      s.condition, s.work, s.dissipated,    s.elastic,       s.energy_defect, s.tension_ratio};
  for (int32_t b = 0; b < 2; ++b) {
    memcpy(reals + 13 + 3 * b, body[b].applied, sizeof body[b].applied);
    memcpy(reals + 19 + 3 * b, body[b].contact, sizeof body[b].contact);
  }
  memcpy(reals + 25, s.free_motion, sizeof s.free_motion);
  put_list(isum, ni, integers, static_cast<int32_t>(sizeof integers / sizeof *integers), put_integer);
  put_list(rsum, nr, reals, static_cast<int32_t>(sizeof reals / sizeof *reals), put_real);
}

} // namespace

void c2get_(Work work, In ifield, In ibody, In ifirst, In n, Out a, In lda, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t field = integer_at(ifield), body = integer_at(ibody), first = integer_at(ifirst), count = integer_at(n);
    const int64_t stride = integer_at(lda);
    if (is_aligned(a) || count < 0 || stride < 1) // the latter are refused
      call.status = c2d_get(call.solver, field, body, first, count, static_cast<double*>(a), stride);
    else
      call.status = get_in_chunks(call.solver, field, body, first, count, a, stride);
  }
  call.leave(ierr);
}

void c2intr_(Work work, In ibody, In n, In xy, In ldxy, Out a, In lda, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t body = integer_at(ibody), count = integer_at(n);
    const int64_t xy_stride = integer_at(ldxy), stride = integer_at(lda);
    const bool right = count >= 0 && xy_stride >= 2 && stride >= C2D_POINT_FIELDS;
    if ((is_aligned(xy) && is_aligned(a)) || !right)
      call.status =
          c2d_interior(call.solver, body, count, static_cast<const double*>(xy), xy_stride, static_cast<double*>(a), stride);
    else
      call.status = points_one_by_one(call.solver, body, count, xy, xy_stride, a, stride);
  }
  call.leave(ierr);
}

void c2indi_(Work work, In ibody, In ifirst, In n, Out a, In lda, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t body = integer_at(ibody), first = integer_at(ifirst), count = integer_at(n);
    const int64_t stride = integer_at(lda);
    if (is_aligned(a) || count < 1 || stride < C2D_OFF_FIELDS) // the latter are refused
      call.status = c2d_indicators(call.solver, body, first, count, static_cast<double*>(a), stride);
    else
      call.status = indicators_one_by_one(call.solver, body, first, count, a, stride);
  }
  call.leave(ierr);
}

void c2summ_(Work work, Out isum, In ni, Out rsum, In nr, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_summary summary = C2D_INIT(c2d_summary);
    c2d_body_result body[2] = {C2D_INIT(c2d_body_result), C2D_INIT(c2d_body_result)};
    call.status = c2d_get_summary(call.solver, &summary);
    for (int32_t b = 0; b < summary.bodies && b < 2 && call.status == C2D_OK; ++b)
      call.status = c2d_get_body_result(call.solver, b + 1, &body[b]);
    if (call.status == C2D_OK) put_summary(summary, body, isum, integer_at(ni), rsum, integer_at(nr));
  }
  call.leave(ierr);
}

void c2bsta_(Work work, In ibody, Out icount, Out r, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_body_result body = C2D_INIT(c2d_body_result);
    call.status = c2d_get_body_result(call.solver, integer_at(ibody), &body);
    const int32_t counts[] = {body.element_nodes, body.elements, body.regions, body.open_regions,
                              body.points,        body.nodes,    body.unknowns};
    const double reals[] = {body.youngs_modulus, body.poisson_ratio, body.applied[0], body.applied[1],
                            body.applied[2],     body.contact[0],    body.contact[1], body.contact[2]};
    if (call.status == C2D_OK) put_numbers(counts, icount, reals, r);
  }
  call.leave(ierr);
}

void c2zsta_(Work work, In izone, Out icount, Out r, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_zone_state state = C2D_INIT(c2d_zone_state);
    call.status = c2d_get_zone_state(call.solver, integer_at(izone), &state);
    const int32_t counts[] = {state.open, state.stick, state.slip, state.near_change};
    const double reals[] = {state.force[0], state.force[1],         state.moment,           state.approach,
                            state.shift,    state.largest_pressure, state.largest_friction, state.length};
    if (call.status == C2D_OK) put_numbers(counts, icount, reals, r);
  }
  call.leave(ierr);
}

void c2bnow_(Work work, In ibody, Out irigid, Out r, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_body_state state = C2D_INIT(c2d_body_state);
    call.status = c2d_get_body_state(call.solver, integer_at(ibody), &state);
    const int32_t rigid[] = {state.is_rigid};
    const double reals[] = {state.contact[0], state.contact[1], state.contact[2], state.motion[0],
                            state.motion[1],  state.motion[2],  state.point[0],   state.point[1],
                            state.load[0],    state.load[1],    state.load[2]};
    if (call.status == C2D_OK) put_numbers(rigid, irigid, reals, r);
  }
  call.leave(ierr);
}

void c2gmu_(Work work, In izone, In i, Out fmu, Out ierr) {
  Call call(work);
  if (call.ready()) {
    double mu = 0.0;
    call.status = c2d_get_friction(call.solver, integer_at(izone), integer_at(i), &mu);
    if (call.status == C2D_OK) put_real(fmu, mu);
  }
  call.leave(ierr);
}

void c2gpth_(Work work, In i, Out ninc, Out factor, In ncases, Out ierr) {
  Call call(work);
  if (call.ready()) {
    double some[64];
    const int32_t cases = integer_at(ncases);
    const bool direct = is_aligned(factor);
    int32_t increments = 0;
    if (!direct && cases > 64)
      call.status = C2D_ERR_LIMIT;
    else
      call.status = c2d_get_path(call.solver, integer_at(i), &increments, direct ? static_cast<double*>(factor) : some, cases);
    if (call.status == C2D_OK && !direct) memcpy(factor, some, static_cast<size_t>(cases) * sizeof(double));
    if (call.status == C2D_OK) put_integer(ninc, increments);
  }
  call.leave(ierr);
}

void c2gzon_(Work work, In i, Out ikind, Out npairs, Out iside1, Out iside2, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    call.status = c2d_get_zone(call.solver, integer_at(i), &zone);
    if (call.status == C2D_OK) {
      put_integer(ikind, zone.kind);
      put_integer(npairs, zone.pairs);
      memcpy(iside1, &zone.side1, sizeof zone.side1);
      memcpy(iside2, &zone.side2, sizeof zone.side2);
    }
  }
  call.leave(ierr);
}

void c2greg_(Work work, In ibody, In i, Out ifirst, Out ilast, Out ierr) {
  Call call(work);
  if (call.ready()) {
    int32_t first = 0, last = 0;
    call.status = c2d_get_region(call.solver, integer_at(ibody), integer_at(i), &first, &last);
    if (call.status == C2D_OK) put_integer(ifirst, first), put_integer(ilast, last);
  }
  call.leave(ierr);
}

void c2gcon_(Work work, In ibody, In ielem, In ilocal, In icase, Out icodes, Out values, Out ierr) {
  Call call(work);
  if (call.ready()) {
    int32_t codes[4];
    double known[4];
    call.status = c2d_get_condition(call.solver, integer_at(ibody), integer_at(ielem), integer_at(ilocal), integer_at(icase),
                                    codes, known);
    if (call.status == C2D_OK) {
      memcpy(icodes, codes, sizeof codes);
      memcpy(values, known, sizeof known);
    }
  }
  call.leave(ierr);
}

void c2gpld_(Work work, In i, Out ibody, Out icase, Out xy, Out force, Out ierr) {
  Call call(work);
  if (call.ready()) {
    int32_t body = 0, load_case = 0;
    double at[2], load[2];
    call.status = c2d_get_point_load(call.solver, integer_at(i), &body, &load_case, at, load);
    if (call.status == C2D_OK) {
      put_integer(ibody, body);
      put_integer(icase, load_case);
      memcpy(xy, at, sizeof at);
      memcpy(force, load, sizeof load);
    }
  }
  call.leave(ierr);
}

void c2gbfo_(Work work, In ibody, In icase, Out force, Out rhom2, Out axis, Out ierr) {
  Call call(work);
  if (call.ready()) {
    double weight[2], turning = 0.0, centre[2];
    call.status = c2d_get_body_force(call.solver, integer_at(ibody), integer_at(icase), weight, &turning, centre);
    if (call.status == C2D_OK) {
      memcpy(force, weight, sizeof weight);
      put_real(rhom2, turning);
      memcpy(axis, centre, sizeof centre);
    }
  }
  call.leave(ierr);
}

void c2grig_(Work work, In ibody, In icase, Out irigid, Out motion, Out axis, Out ierr) {
  Call call(work);
  if (call.ready()) {
    int32_t rigid = 0;
    double moved[3], centre[2];
    call.status = c2d_get_rigid(call.solver, integer_at(ibody), integer_at(icase), &rigid, moved, centre);
    if (call.status == C2D_OK) {
      put_integer(irigid, rigid);
      memcpy(motion, moved, sizeof moved);
      memcpy(axis, centre, sizeof centre);
    }
  }
  call.leave(ierr);
}

void c2gint_(Work work, Out icase, Out ierr) {
  Call call(work);
  if (call.ready()) {
    int32_t load_case = 0;
    call.status = c2d_get_interference(call.solver, &load_case);
    if (call.status == C2D_OK) put_integer(icase, load_case);
  }
  call.leave(ierr);
}

void c2gnam_(Work work, In ikind, In i, Out name, In lname, Out ierr) {
  Call call(work);
  if (call.ready()) {
    char text[32];
    call.status = c2d_get_name(call.solver, integer_at(ikind), integer_at(i), text);
    if (call.status == C2D_OK) put_text(name, integer_at(lname), text);
  }
  call.leave(ierr);
}

void c2gcrv_(Work work, In i, Out ikind, Out ibody, Out ielem, Out iline, Out circle, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_curve curve = C2D_INIT(c2d_curve);
    call.status = c2d_get_curve(call.solver, integer_at(i), &curve);
    if (call.status == C2D_OK) {
      const int32_t elements[2] = {curve.first_element, curve.last_element};
      const double numbers[3] = {curve.centre[0], curve.centre[1], curve.radius};
      put_integer(ikind, curve.kind);
      put_integer(ibody, curve.body);
      put_integer(iline, curve.line);
      memcpy(ielem, elements, sizeof elements);
      memcpy(circle, numbers, sizeof numbers);
    }
  }
  call.leave(ierr);
}

void c2gpts_(Work work, In i, Out ikind, Out ibody, Out icount, Out iline, Out from, Out to, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_points points = C2D_INIT(c2d_points);
    call.status = c2d_get_points(call.solver, integer_at(i), &points);
    if (call.status == C2D_OK) {
      put_integer(ikind, points.kind);
      put_integer(ibody, points.body);
      put_integer(iline, points.line);
      memcpy(icount, points.count, sizeof points.count);
      memcpy(from, points.from, sizeof points.from);
      memcpy(to, points.to, sizeof points.to);
    }
  }
  call.leave(ierr);
}

void c2xpts_(Work work, In i, In ifirst, In n, Out xy, In ldxy, Out ntotal, Out ierr) {
  Call call(work);
  if (call.ready()) {
    c2d_points points = C2D_INIT(c2d_points);
    const int32_t first = integer_at(ifirst), count = integer_at(n);
    const int64_t stride = integer_at(ldxy);
    int32_t total = 0;
    call.status = count > 0 && stride < 2 ? C2D_ERR_ARGUMENT : c2d_get_points(call.solver, integer_at(i), &points);
    if (call.status == C2D_OK)
      call.status = is_aligned(xy) ? c2d_expand_points(&points, first, count, static_cast<double*>(xy), stride, &total)
                                   : expand_one_by_one(points, first, count, xy, stride, total);
    if (call.status == C2D_OK) put_integer(ntotal, total);
  }
  call.leave(ierr);
}
