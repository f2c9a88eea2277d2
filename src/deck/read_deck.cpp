// A deck into a solver, through the calls of the C interface.
#include "deck/deck.hpp"
#include "solver/solver.hpp"

namespace c2d {
namespace {

void tell_solver(void* context, const c2d_error* entry) {
  report_fault(static_cast<c2d_solver*>(context), *entry);
}

// In a function of its own: the summary is large, and gone from the stack when the reading begins.
int32_t function_nodes_of(c2d_solver* solver) {
  c2d_summary summary = c2d_summary();
  summary.struct_size = static_cast<uint32_t>(sizeof summary);
  return c2d_get_summary(solver, &summary) == C2D_OK ? summary.function_nodes : 0;
}

c2d_status refuse(c2d_solver* solver, c2d_status status, const char* why) {
  c2d_error entry = c2d_error();
  entry.struct_size = static_cast<uint32_t>(sizeof entry);
  entry.status = status;
  entry.severity = C2D_FAULT;
  Text text = text_in(entry.text);
  put(text, why);
  report_fault(solver, entry);
  return status;
}

} // namespace
} // namespace c2d

c2d_status c2d_read_deck(c2d_solver* solver, c2d_read_line read, void* context) {
  const int32_t state = c2d_get_state(solver);
  if (state < 0) return C2D_ERR_ARGUMENT;
  if (read == nullptr) return c2d::refuse(solver, C2D_ERR_ARGUMENT, "read_line is null, expected a function");
  if (state != C2D_STATE_EMPTY)
    return c2d::refuse(solver, C2D_ERR_STATE, "a deck is read into an empty solver; this one holds a model");
  // Also refused here: a call from inside one of the solver's own callbacks.
  c2d_status status = c2d_set_line(solver, 0, 0, 0);
  if (status != C2D_OK) return status;

  const c2d::DeckSink sink = {solver,
                              c2d::function_nodes_of(solver),
                              c2d_set_line,
                              c2d_set_problem,
                              c2d_set_body,
                              c2d_add_region,
                              c2d_set_nodes,
                              c2d_set_condition,
                              c2d_add_point_load,
                              c2d_add_zone,
                              c2d_add_friction,
                              c2d_add_path};
  status = c2d::read_deck_cards(&sink, read, context, c2d::tell_solver, solver, nullptr);
  if (status == C2D_OK) {
    c2d_set_line(solver, 0, 0, 0);
    status = c2d_complete(solver);
  }
  if (status != C2D_OK) c2d::clear_model(solver);
  return status;
}
