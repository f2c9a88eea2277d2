// What the hostile build (memory/hostile.hpp) does to a port: it uses every freedom that a port has. While the solver
// transfers blocks it does what was begun when it is waited for, spoils what is to be read until then, and traps where the
// solver does not keep its side of the rules. Tasks run from the last to the first. Every model is prepared twice, first
// with a store that fails on the way. Compiled with -DC2D_HOSTILE=width, which no other file is told.
#include "contact2d.h"
#include "memory/hostile.hpp"
#include "memory/parts.hpp"
#include "solver/model_hash.hpp"
#include "solver/phases.hpp"
#include "solver/port.hpp"
#include "solver/solver.hpp"
#include "store/block.hpp"

namespace c2d {

namespace {

// A transfer that was begun and has not been waited for.
struct LateTransfer {
  bool under_way, writes, happened;
  int32_t tape;
  int32_t code; // the caller's answer, once it has happened
  uint64_t block, bytes;
  uint64_t start; // counts
  uint64_t sum;   // of the buffer: until it has been waited for nobody else may touch it
  void* data;
};

// A solver's store: `port` has this struct for its context.
struct HostilePort {
  c2d_solver* solver;
  uint64_t used; // when, in calls
  c2d_port caller, port;
  LateTransfer late[kMostTransfers];
  uint64_t starts;
  bool failing;
  int64_t left; // failing: questions until then
};

HostilePort& self(void* context) { return *static_cast<HostilePort*>(context); }

constexpr int32_t kRehearsedFailure = 4711;
bool fails_now(HostilePort& h) { return h.failing && h.left-- <= 0; }

// ---- transfers ------------------------------------------------------------------------------------------------------

void happen(HostilePort& h, LateTransfer& t) {
  C2D_ASSERT(checksum(0, t.data, t.bytes) == t.sum);
  const c2d_port& port = h.caller;
  t.code = t.writes ? port.write(port.context, t.tape, t.block, t.data, t.bytes)
                    : port.read(port.context, t.tape, t.block, t.data, t.bytes);
  t.sum = checksum(0, t.data, t.bytes);
  t.happened = true;
}

// Those of this block that were begun before start number `end` happen now, in the order of their start: a transfer sees
// the earlier ones.
void happen_before(HostilePort& h, int32_t tape, uint64_t block, uint64_t end) {
  for (;;) {
    LateTransfer* oldest = nullptr;
    for (LateTransfer& t : h.late)
      if (t.under_way && !t.happened && t.tape == tape && t.block == block && t.start < end &&
          (!oldest || t.start < oldest->start))
        oldest = &t;
    if (!oldest) return;
    happen(h, *oldest);
  }
}

bool is_at_rest(const HostilePort& h, int32_t tape) {
  for (const LateTransfer& t : h.late)
    if (t.under_way && t.tape == tape) return false;
  return true;
}

// Any number may be a ticket, zero and negative ones among them.
int32_t ticket_of(int32_t place) { return 5 * (place - 1); }

int32_t start(HostilePort& h, bool writes, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  if (fails_now(h)) return kRehearsedFailure;
  int32_t place = 0;
  while (place < kMostTransfers && h.late[place].under_way) ++place;
  C2D_ASSERT(place < kMostTransfers); // what the port was promised
  if (!writes) poison(data, bytes);
  h.late[place] = {true, writes, false, tape, 0, block, bytes, h.starts++, checksum(0, data, bytes), data};
  *ticket = ticket_of(place);
  return 0;
}

// (A start that fails has no ticket.)
int32_t start_late_read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  return start(self(c), false, tape, block, data, bytes, ticket);
}
int32_t start_late_write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
  return start(self(c), true, tape, block, const_cast<void*>(data), bytes, ticket);
}
int32_t wait_late(void* c, int32_t ticket) {
  HostilePort& h = self(c);
  int32_t place = 0;
  while (place < kMostTransfers && ticket_of(place) != ticket) ++place;
  C2D_ASSERT(place < kMostTransfers && h.late[place].under_way);
  LateTransfer& t = h.late[place];
  happen_before(h, t.tape, t.block, t.start + 1);
  C2D_ASSERT(checksum(0, t.data, t.bytes) == t.sum);
  t.under_way = false;
  return fails_now(h) ? kRehearsedFailure : t.code; // over all the same
}

// ---- the caller's functions -----------------------------------------------------------------------------------------

int32_t hostile_open(void* c, int32_t tape, uint64_t blocks, uint64_t bytes) {
  HostilePort& h = self(c);
  if (fails_now(h)) return kRehearsedFailure;
  C2D_ASSERT(is_at_rest(h, tape));
  return h.caller.open(h.caller.context, tape, blocks, bytes);
}
int32_t hostile_read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  HostilePort& h = self(c);
  if (fails_now(h)) return kRehearsedFailure;
  happen_before(h, tape, block, h.starts);
  poison(data, bytes);
  return h.caller.read(h.caller.context, tape, block, data, bytes);
}
int32_t hostile_write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  HostilePort& h = self(c);
  if (fails_now(h)) return kRehearsedFailure;
  happen_before(h, tape, block, h.starts);
  return h.caller.write(h.caller.context, tape, block, data, bytes);
}
int32_t hostile_sync(void* c, int32_t tape) {
  HostilePort& h = self(c);
  if (fails_now(h)) return kRehearsedFailure;
  C2D_ASSERT(is_at_rest(h, tape));
  return h.caller.sync(h.caller.context, tape);
}
int32_t hostile_close(void* c, int32_t tape) {
  HostilePort& h = self(c);
  C2D_ASSERT(is_at_rest(h, tape));
  return h.caller.close(h.caller.context, tape);
}
int32_t callers_start_read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  if (fails_now(self(c))) return kRehearsedFailure;
  const c2d_port& port = self(c).caller;
  return port.start_read(port.context, tape, block, data, bytes, ticket);
}
int32_t callers_start_write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
  if (fails_now(self(c))) return kRehearsedFailure;
  const c2d_port& port = self(c).caller;
  return port.start_write(port.context, tape, block, data, bytes, ticket);
}
int32_t callers_wait(void* c, int32_t ticket) {
  const int32_t code = self(c).caller.wait(self(c).caller.context, ticket);
  return fails_now(self(c)) ? kRehearsedFailure : code;
}

void tasks_backward(void*, int32_t n, void (*task)(void* argument, int32_t i), void* argument) {
  for (int32_t i = n - 1; i >= 0; --i) task(argument, i);
}

// ---- a solver's port ------------------------------------------------------------------------------------------------

// That of this solver, or the one that has not been asked for longest.
HostilePort& port_of(const c2d_solver* s) {
  static HostilePort ports[64];
  static uint64_t calls;
  static bool locked;
  while (__atomic_test_and_set(&locked, __ATOMIC_ACQUIRE)) {
  }
  HostilePort* found = ports;
  for (HostilePort& h : ports) {
    if (h.used < found->used) found = &h;
    if (h.solver != s) continue;
    found = &h;
    break;
  }
  found->used = ++calls;
  __atomic_clear(&locked, __ATOMIC_RELEASE);
  return *found;
}

void wrap_store(const c2d_port& callers, HostilePort& h) { // a port without a store stays one
  c2d_port& port = h.port;
  port.context = &h;
  port.open = hostile_open;
  port.read = hostile_read;
  port.write = hostile_write;
  port.sync = hostile_sync;
  port.close = hostile_close;
  const bool ahead = callers.start_read && callers.start_write && callers.wait; // the caller's own stay
  port.start_read = ahead ? callers_start_read : start_late_read;
  port.start_write = ahead ? callers_start_write : start_late_write;
  port.wait = ahead ? callers_wait : wait_late;
}

} // namespace

void make_port_hostile(c2d_solver* s) {
  HostilePort& h = port_of(s);
  for (const LateTransfer& t : h.late) C2D_ASSERT(!t.under_way);
  h.solver = s;
  h.caller = h.port = s->port;
  h.failing = false;
  c2d_port& port = h.port;
  if (s->port.open) wrap_store(s->port, h);
  s->tapes.port = &port;
  if (s->port.parallel_for && s->port.threads > 1) return;
  s->port.parallel_for = tasks_backward;
  s->port.threads = 3;
}

void make_memory_hostile(Sizes& sizes, Layout& layout, size_t& bytes) {
  c2d_limits narrow = limits_of(sizes);
  if (narrow.panel_columns == 0) narrow.panel_columns = kHostileWidth;
  Sizes narrow_sizes;
  Layout narrow_layout;
  uint64_t least = 0;
  if (c2d_memory_need(&narrow, &least, nullptr, nullptr) != C2D_OK || least > bytes ||
      derive_sizes(narrow, narrow_sizes) != C2D_OK || lay_out(narrow_sizes, sizeof(c2d_solver), narrow_layout) != C2D_OK)
    return;
  sizes = narrow_sizes;
  layout = narrow_layout;
  int64_t rows = 0;
  for (int b = 0; b < sizes.bodies; ++b) {
    const int64_t of_body = sizes_of_body(sizes, b).rows;
    if (of_body > rows) rows = of_body;
  }
  least += round_up(kBlockHeaderBytes + static_cast<uint64_t>(rows) * sizeof(Real));
  // (Compressed elimination needs more; who gives so much may want it.)
  const uint64_t compressed =
      layout.persistent + kCompressedPart.compression_that_will_do(phase_sizes(sizes), 0) + kAlignment - 1;
  if (bytes >= compressed && least < compressed) least = compressed;
  if (least < bytes) bytes = static_cast<size_t>(least);
}

void rehearse(c2d_solver* s, c2d_status (*prepare)(c2d_solver* s)) {
  if (s->factors != 0 || s->loads_changed != 0) return; // what went before must not be lost
  if (is_cancelled(s)) return; // for the call itself; one that comes later is left there, or given back
  const c2d_port port = s->port;
  const c2d_error error = s->error;
  const int32_t warnings = s->warnings;
  HostilePort& h = port_of(s);
  const uint64_t chance = hash_model(model_of(s), s->options);
  h.failing = true;
  h.left = static_cast<int64_t>(chance / 2 % (chance % 2 == 0 ? 61 : 997)); // early, or far into it
  s->port.progress = nullptr;
  s->port.cancel = nullptr;
  s->port.log = nullptr;
  s->port.clock = nullptr;
  const c2d_status status = prepare(s);
  C2D_ASSERT(status == C2D_OK || is_store_error(status) || status == C2D_ERR_SINGULAR || status == C2D_ERR_MEMORY ||
             status == C2D_ERR_CANCELLED);
  C2D_ASSERT(s->state == (status == C2D_OK ? C2D_STATE_PREPARED : is_store_error(status) ? C2D_STATE_BROKEN : C2D_STATE_MODEL));
  close_all(s->tapes);
  h.failing = false;
  s->port = port;
  s->error = error;
  s->has_fault = 0;
  s->warnings = warnings;
  if (status == C2D_ERR_CANCELLED) set_cancelled(s, 1);
  s->factors = 0;
  s->state = C2D_STATE_MODEL;
}

} // namespace c2d
