// Prepare, new loads, load steps, the path of the deck.
#include "fortran77.hpp"

using namespace c2d::fortran;

namespace {

struct StepCall {
  c2_step routine;
};

int32_t pass_on(void* context, const c2d_step* step) {
  const int32_t stride = static_cast<int32_t>(step->stride);
  const double energy[] = {step->work, step->dissipated, step->elastic, step->energy_defect};
  int32_t stop = 0;
  // Later additions come last: routines with shorter argument lists keep working.
  static_cast<StepCall*>(context)->routine(&step->kind, &step->coefficient, &step->step, &step->outcome, &step->mu, step->loads,
                                           &step->pairs, step->table, &stride, &stop, &step->cases, step->work_by_case, energy);
  return stop;
}

} // namespace

void c2prep_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_prepare(call.solver);
  call.leave(ierr);
}

void c2chld_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_change_loads(call.solver);
  call.leave(ierr);
}

void c2rpld_(Work work, In i, In x, In y, In fx, In fy, Out ierr) {
  Call call(work);
  if (call.ready())
    call.status = c2d_replace_point_load(call.solver, integer_at(i), real_at(x), real_at(y), real_at(fx), real_at(fy));
  call.leave(ierr);
}

void c2begn_(Work work, In fmu, In nzones, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t zones = integer_at(nzones);
    const Reals mu(fmu, zones);
    call.status = mu.ok() ? c2d_begin(call.solver, mu.data(), zones) : C2D_ERR_LIMIT;
  }
  call.leave(ierr);
}

void c2advn_(Work work, In factor, In ncases, Out iout, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t cases = integer_at(ncases);
    const Reals load(factor, cases);
    c2d_outcome outcome = C2D_REACHED;
    call.status = load.ok() ? c2d_advance(call.solver, load.data(), cases, &outcome) : C2D_ERR_LIMIT;
    put_integer(iout, outcome);
  }
  call.leave(ierr);
}

void c2next_(Work work, In direct, In ncases, Out step, Out ierr) {
  Call call(work);
  if (call.ready()) {
    const int32_t cases = integer_at(ncases);
    const Reals direction(direct, cases);
    double length = 0.0;
    call.status = direction.ok() ? c2d_next_event(call.solver, direction.data(), cases, &length) : C2D_ERR_LIMIT;
    if (call.status == C2D_OK) put_real(step, length);
  }
  call.leave(ierr);
}

void c2solv_(Work work, c2_step step, Out ierr) {
  Call call(work);
  if (call.ready()) {
    StepCall context = {step};
    call.status = c2d_run(call.solver, pass_on, &context);
  }
  call.leave(ierr);
}

void c2none_(const int32_t*, const int32_t*, const int32_t*, const int32_t*, const double*, const double*, const int32_t*,
             const double*, const int32_t*, int32_t*, const int32_t*, const double*, const double*) {}

void c2canc_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_cancel(call.solver);
  call.leave(ierr);
}
