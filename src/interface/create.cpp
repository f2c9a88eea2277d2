// c2d_memory_need and c2d_create.
#include <stddef.h>
#include <string.h>

#include "contact2d_memory.h"
#include "interface/entry.hpp"
#include "linalg/kernel.hpp"
#include "memory/hostile.hpp"
#include "memory/text.hpp"
#include "solver/phases.hpp"
#include "solver/port.hpp"

namespace c2d {

namespace {

static_assert(sizeof(c2d_solver) <= C2D_SOLVER_BYTES && C2D_SOLVER_BYTES <= sizeof(c2d_solver) + 512,
              "C2D_SOLVER_BYTES of contact2d_memory.h bounds the solver's own struct, and not by much");

// Bytes needed for these limits if the workspace is aligned.
c2d_status aligned_need(const Sizes& sizes, Layout& layout, uint64_t* minimum, uint64_t* in_core) {
  c2d_status status = lay_out(sizes, sizeof(c2d_solver), layout);
  if (status != C2D_OK) return status;
  // Row and column numbers are 32-bit throughout; phase_need relies on it.
  for (int b = 0; b < sizes.bodies; ++b) {
    const BodySizes body = sizes_of_body(sizes, b);
    if (body.rows + 2 * sizes.contact + sizes.load_cases >= INT32_MAX || body.ends > INT32_MAX / 4) return C2D_ERR_OVERFLOW;
  }
  status = phase_need(sizes, minimum, in_core);
  if (status != C2D_OK) return status;
  uint64_t* const needs[] = {minimum, in_core};
  for (uint64_t* need : needs) {
    if (!add_bytes(*need, 1, layout.persistent + kAlignment)) return C2D_ERR_OVERFLOW;
    *need -= kAlignment;
  }
#if SIZE_MAX < UINT64_MAX
  if (*minimum > SIZE_MAX - kAlignment) return C2D_ERR_OVERFLOW;
#endif
  return C2D_OK;
}

// Copies the caller's limits; false with the reason if they are invalid.
bool take_limits(const c2d_limits* limits, c2d_limits& ours, Text& fault) {
  if (!is_begun(limits)) {
    put_not_begun(fault, "c2d_limits", limits);
    return false;
  }
  copy_in(limits, &ours, sizeof ours);
  WrongLimit wrong;
  if (!find_wrong_limit(ours, wrong)) return true;
  if (wrong.member == nullptr) {
    put(fault, "c2d_limits.body is null, expected an array of bodies");
    return false;
  }
  put(fault, "c2d_limits.");
  if (wrong.body >= 0) put_all(fault, "body[", wrong.body, "].");
  put_all(fault, wrong.member, " is ", wrong.value, ", expected ", wrong.least);
  if (wrong.most == INT32_MAX)
    put(fault, " or more");
  else
    put_all(fault, " to ", wrong.most);
  return false;
}

// Bytes that the caller's limits need in an aligned workspace; the fault goes to `why` if there is no such number.
struct Need {
  Sizes sizes;
  Layout layout;
  uint64_t least, most;
};
c2d_status find_need(const c2d_limits* limits, Need& out, c2d_error* why) {
  c2d_limits ours;
  char what[128] = "";
  Text fault = text_in(what);
  if (!take_limits(limits, ours, fault)) {
    explain(why, C2D_ERR_ARGUMENT, 0, what);
    return C2D_ERR_ARGUMENT;
  }
  out.least = out.most = 0;
  derive_sizes(ours, out.sizes);
  const c2d_status status = aligned_need(out.sizes, out.layout, &out.least, &out.most);
  if (status != C2D_OK) explain(why, status, 0);
  return status;
}

void fill_header(c2d_solver* s, uint64_t bytes, uint32_t slack, const Sizes& sizes, const Layout& layout) {
  memset(static_cast<void*>(s), 0, static_cast<size_t>(layout.offset[kBodies])); // including the list of limits
  s->magic = kSolverMagic;
  s->maker = solver_maker();
  s->slack = slack;
  s->bytes = bytes;
  s->sizes = sizes;
  s->sizes.body = nullptr; // the list belongs to the caller
  s->layout = layout;
  c2d_body_limits* const kept = array_of<c2d_body_limits>(s, kBodyLimits);
  for (int b = 0; b < sizes.bodies - sizes.platens; ++b)
    kept[b] = c2d_body_limits{sizes.body[b].points, sizes.body[b].elements, sizes.body[b].regions, 0};
  s->options.struct_size = static_cast<uint32_t>(sizeof s->options);
  s->error = blank_error();
}

// Sets the offsets of the arrays of each body and their non-zero initial values.
void lay_out_bodies(c2d_solver* s) {
  const Sizes sizes = sizes_of(s);
  const Model m = model_of(s);
  const int64_t list = static_cast<int64_t>(s->layout.offset[kBodies]);
  uint64_t at = s->layout.offset[kArraysOfBodies];
  for (int b = 0; b < sizes.bodies; ++b) {
    at = lay_out_body(sizes, b, at, m.body[b].array);
    for (int64_t& place : m.body[b].array) place -= list;
    for (int64_t i = 0; i < sizes.body[b].points; ++i) m.node_line[b][i] = -1;
  }
}

} // namespace

void explain(c2d_error* why, c2d_status status, uint64_t needed, const char* what, const char* end) {
  if (!is_begun(why)) return;
  c2d_error e = blank_error();
  e.status = status;
  e.severity = C2D_FAULT;
  e.bytes_needed = needed;
  Text text = text_in(e.text);
  put(put(text, what ? what : c2d_message(status)), end);
  if (needed > 0) {
    put_all(text, ": ", needed, " bytes would do");
  }
  copy_out(&e, sizeof e, why);
}

void clear_model(c2d_solver* s) {
  // Everything before the model is kept: memory, limits, port, tapes, last error and options, and also
  // the list of body limits, which precedes the arrays of the bodies.
  const c2d_options options = s->options;
  const int32_t warnings = s->warnings;
  memset(static_cast<void*>(&s->model), 0, sizeof *s - offsetof(c2d_solver, model));
  s->state = C2D_STATE_EMPTY;
  s->busy = 0;
  s->peak_bytes = s->layout.persistent;
  s->options = options;
  s->warnings = warnings;
  s->model.function_nodes = s->sizes.function_nodes;
  s->model.load_cases = s->sizes.load_cases;
  s->model.length_unit = s->model.stress_unit = 1.0;
  const uint64_t first = s->layout.offset[kBodies];
  memset(array_of<char>(s, kBodies), 0, static_cast<size_t>(s->layout.persistent - first));
  lay_out_bodies(s);
}

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_memory_need(const c2d_limits* limits, uint64_t* minimum, uint64_t* in_core, c2d_error* why) {
  Need need;
  if (why && !is_begun(why)) return C2D_ERR_ARGUMENT;
  const c2d_status status = find_need(limits, need, why);
  if (status != C2D_OK) return status;
  if (minimum) *minimum = need.least + kAlignment - 1;
  if (in_core) *in_core = need.most + kAlignment - 1;
  return C2D_OK;
}

extern "C" c2d_status c2d_create(c2d_solver** out, void* memory, size_t bytes, const c2d_limits* limits, const c2d_port* port,
                                 c2d_error* why) {
  if (!out) return C2D_ERR_ARGUMENT;
  *out = nullptr;
  if (why && !is_begun(why)) return C2D_ERR_ARGUMENT;
  Need need;
  const c2d_status status = find_need(limits, need, why);
  if (status != C2D_OK) return status;
  c2d_port our_port;
  char what[128] = "memory is null";
  Text fault = text_in(what);
  if (!take_port(port, our_port, fault) || (!memory && bytes > 0)) {
    explain(why, C2D_ERR_ARGUMENT, 0, what);
    return C2D_ERR_ARGUMENT;
  }
  if (bytes < need.least + kAlignment - 1) { // the result does not depend on the alignment
    explain(why, C2D_ERR_MEMORY, need.least + kAlignment - 1);
    return C2D_ERR_MEMORY;
  }
  const uintptr_t address = reinterpret_cast<uintptr_t>(memory);
  const uint32_t slack = static_cast<uint32_t>((kAlignment - address % kAlignment) % kAlignment);
  poison(memory, bytes);
  if constexpr (kHostile) make_memory_hostile(need.sizes, need.layout, bytes);
  c2d_solver* s = reinterpret_cast<c2d_solver*>(static_cast<char*>(memory) + slack);
  fill_header(s, bytes - (kAlignment - 1), slack, need.sizes, need.layout); // it may later move to any alignment
  s->port = our_port;
  s->instructions = best_instructions();
  connect_port(s);
  clear_model(s);
  *out = s;
  return C2D_OK;
}

extern "C" c2d_status c2d_close(c2d_solver* s) {
  if (!s || s->magic != kSolverMagic) return C2D_ERR_ARGUMENT;
  if (s->busy) return C2D_ERR_BUSY;
  connect_port(s);
  const c2d_status status = s->port.close ? close_all(s->tapes) : c2d_status{C2D_OK};
  if (status != C2D_OK) fail_store(s, status); // log it: there will be no solver to query
  poison(s, s->bytes);
  s->magic = 0;
  return status;
}
