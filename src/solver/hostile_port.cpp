#include "solver/hostile_port.hpp"

#include "memory/hostile.hpp"
#include "store/block.hpp"

namespace c2d {

#ifdef C2D_HOSTILE

namespace {

HostilePort& self(void* context) { return *static_cast<HostilePort*>(context); }

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
  int32_t place = 0;
  while (place < kMostTransfers && h.late[place].under_way) ++place;
  C2D_ASSERT(place < kMostTransfers); // what the port was promised
  if (!writes) poison(data, bytes);
  h.late[place] = {true, writes, false, tape, 0, block, bytes, h.starts++, checksum(0, data, bytes), data};
  *ticket = ticket_of(place);
  return 0;
}

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
  return t.code;
}

// ---- the caller's functions -----------------------------------------------------------------------------------------

int32_t hostile_open(void* c, int32_t tape, uint64_t blocks, uint64_t bytes) {
  HostilePort& h = self(c);
  C2D_ASSERT(is_at_rest(h, tape));
  return h.caller.open(h.caller.context, tape, blocks, bytes);
}
int32_t hostile_read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  HostilePort& h = self(c);
  happen_before(h, tape, block, h.starts);
  poison(data, bytes);
  return h.caller.read(h.caller.context, tape, block, data, bytes);
}
int32_t hostile_write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  HostilePort& h = self(c);
  happen_before(h, tape, block, h.starts);
  return h.caller.write(h.caller.context, tape, block, data, bytes);
}
int32_t hostile_sync(void* c, int32_t tape) {
  HostilePort& h = self(c);
  C2D_ASSERT(is_at_rest(h, tape));
  return h.caller.sync(h.caller.context, tape);
}
int32_t hostile_close(void* c, int32_t tape) {
  HostilePort& h = self(c);
  C2D_ASSERT(is_at_rest(h, tape));
  return h.caller.close(h.caller.context, tape);
}
int32_t callers_start_read(void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  const c2d_port& port = self(c).caller;
  return port.start_read(port.context, tape, block, data, bytes, ticket);
}
int32_t callers_start_write(void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
  const c2d_port& port = self(c).caller;
  return port.start_write(port.context, tape, block, data, bytes, ticket);
}
int32_t callers_wait(void* c, int32_t ticket) { return self(c).caller.wait(self(c).caller.context, ticket); }

void tasks_backward(void*, int32_t n, void (*task)(void* argument, int32_t i), void* argument) {
  for (int32_t i = n - 1; i >= 0; --i) task(argument, i);
}

} // namespace

HostilePort::HostilePort(Tapes& tapes)
    : caller(*tapes.port), port(caller), late(), starts(0), tapes_(tapes), before_(tapes.port) {
  port.context = this;
  port.open = hostile_open;
  port.read = hostile_read;
  port.write = hostile_write;
  port.sync = hostile_sync;
  port.close = hostile_close;
  const bool ahead = caller.start_read && caller.start_write && caller.wait; // the caller's own stay
  port.start_read = ahead ? callers_start_read : start_late_read;
  port.start_write = ahead ? callers_start_write : start_late_write;
  port.wait = ahead ? callers_wait : wait_late;
  tapes.port = &port;
}

HostilePort::~HostilePort() {
  for (const LateTransfer& t : late) C2D_ASSERT(!t.under_way);
  tapes_.port = before_;
}

int32_t hostile_width() { return C2D_HOSTILE; }

void make_tasks_hostile(c2d_port& port) {
  if (port.parallel_for && port.threads > 1) return;
  port.parallel_for = tasks_backward;
  port.threads = 3;
}

#endif

} // namespace c2d
