// c2d_read_deck: reads a deck through the calls of the C interface.
#include <string.h>

#include "deck/deck.hpp"
#include "interface/model/refuse.hpp"
#include "memory/parts.hpp"

namespace c2d {

C2D_MEETS(SymmetryPart, c2d_set_symmetry);
C2D_MEETS(RigidPart, c2d_set_rigid);
C2D_MEETS(BodyForcePart, c2d_set_body_force);
C2D_MEETS(FreeZonePart, c2d_link_free_zones);
C2D_MEETS_IN_FULL(CyclePart, c2d_repeat_paths);

namespace {

// The caller's deck and the solver. Every inner call clears the last error, so the first fault is stored here.
struct Reading {
  c2d_solver* solver;
  c2d_read_line read;
  void* context;
  c2d_error first;
};

void keep_first(Reading& reading, const c2d_error& entry) {
  if (reading.first.status == C2D_OK) reading.first = entry;
}

void model_refused(void* context) {
  Reading& reading = *static_cast<Reading*>(context);
  keep_first(reading, reading.solver->error);
}

void deck_fault(void* context, const c2d_error* entry) {
  Reading& reading = *static_cast<Reading*>(context);
  keep_first(reading, *entry);
  report_fault(reading.solver, *entry);
}

// Inside the caller's read_line no call on this solver is legal.
int32_t read_line(void* context, char* text, int32_t size) {
  Reading& reading = *static_cast<Reading*>(context);
  reading.solver->busy = 1;
  const int32_t length = reading.read(reading.context, text, size);
  reading.solver->busy = 0;
  return length;
}

// Before results exist their memory stores the notes of the reader about every body.
static_assert(sizeof(BodyResults) >= sizeof(c2d_body_limits) + 2 * sizeof(double), "one after the other");

c2d_status walk(Reading& reading) {
  const int32_t bodies = reading.solver->sizes.bodies;
  BodyResults* const notes = array_of<BodyResults>(reading.solver, kBodyResults);
  c2d_limits sizes = c2d_limits();
  sizes.body = reinterpret_cast<c2d_body_limits*>(notes);
  sizes.bodies = bodies;
  DeckSink sink = DeckSink();
  sink.solver = reading.solver;
  sink.function_nodes = reading.solver->sizes.function_nodes;
  sink.bodies = static_cast<int32_t>(bodies - reading.solver->sizes.platens);
  sink.origin = reinterpret_cast<double(*)[2]>(sizes.body + bodies);
  sink.refused = model_refused;
  sink.context = &reading;
  sink.add_load_card = add_load_card;
  sink.add_factors = add_factors;
  sink.set_symmetry = kSymmetryPart.set_symmetry;
  sink.set_rigid = kRigidPart.set_rigid;
  sink.set_rigid_load = kRigidPart.set_rigid_load;
  sink.add_platen = kRigidPart.add_platen;
  sink.set_body_force = kBodyForcePart.set_body_force;
  sink.repeat_paths = kSmallCode ? nullptr : kCyclePart.repeat_paths;
  sink.has_free_zones = kFreeZonePart.linked;
  const c2d_status status = read_deck_cards(&sink, read_line, &reading, deck_fault, &reading, &sizes);
  memset(notes, 0, static_cast<size_t>(bodies) * sizeof *notes);
  return status;
}

} // namespace
} // namespace c2d

using namespace c2d;

c2d_status c2d_read_deck(c2d_solver* solver, c2d_read_line read, void* context) {
  c2d_status status = enter(solver, state_bit(C2D_STATE_EMPTY));
  if (status != C2D_OK) return status;
  if (read == nullptr) return fail(solver, C2D_ERR_ARGUMENT, "read_line is null, expected a function");
  const double start = clock_now(solver);
  Reading reading = Reading();
  reading.solver = solver;
  reading.read = read;
  reading.context = context;
  status = walk(reading);
  if (status == C2D_OK) {
    status = c2d_complete(solver);
    if (status != C2D_OK) model_refused(&reading);
  }
  if (status != C2D_OK) {
    clear_model(solver);
    solver->error = reading.first;
    solver->has_fault = 1;
  }
  solver->seconds[C2D_PHASE_READ] = clock_now(solver) - start;
  return status;
}
