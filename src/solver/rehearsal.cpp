#include "solver/rehearsal.hpp"

#include "memory/hostile.hpp"

namespace c2d {

#ifdef C2D_HOSTILE

namespace {

// The caller's store if it may still be asked, else null.
const c2d_port* still(void* context) {
  FailingStore& store = *static_cast<FailingStore*>(context);
  return store.left-- > 0 ? &store.caller : nullptr;
}

int32_t open_until(void* context, int32_t tape, uint64_t blocks, uint64_t bytes) {
  const c2d_port* port = still(context);
  return port ? port->open(port->context, tape, blocks, bytes) : kRehearsedFailure;
}
int32_t read_until(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  const c2d_port* port = still(context);
  return port ? port->read(port->context, tape, block, data, bytes) : kRehearsedFailure;
}
int32_t write_until(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  const c2d_port* port = still(context);
  return port ? port->write(port->context, tape, block, data, bytes) : kRehearsedFailure;
}
// (A start that fails has no ticket.)
int32_t start_read_until(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
  const c2d_port* port = still(context);
  return port ? port->start_read(port->context, tape, block, data, bytes, ticket) : kRehearsedFailure;
}
int32_t start_write_until(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
  const c2d_port* port = still(context);
  return port ? port->start_write(port->context, tape, block, data, bytes, ticket) : kRehearsedFailure;
}
// It may have failed on its way, and is over all the same.
int32_t wait_until(void* context, int32_t ticket) {
  const c2d_port& caller = static_cast<FailingStore*>(context)->caller;
  const int32_t code = caller.wait(caller.context, ticket);
  return still(context) ? code : kRehearsedFailure;
}
int32_t sync_until(void* context, int32_t tape) {
  const c2d_port* port = still(context);
  return port ? port->sync(port->context, tape) : kRehearsedFailure;
}
int32_t close_always(void* context, int32_t tape) {
  const c2d_port& port = static_cast<FailingStore*>(context)->caller;
  return port.close(port.context, tape);
}

} // namespace

void make_failing(const c2d_port& caller, int64_t left, FailingStore& out) {
  memset(static_cast<void*>(&out), 0, sizeof out);
  out.caller = caller;
  out.left = left;
  out.port.struct_size = static_cast<uint32_t>(sizeof out.port);
  out.port.context = &out;
  out.port.open = open_until;
  out.port.read = read_until;
  out.port.write = write_until;
  out.port.start_read = start_read_until;
  out.port.start_write = start_write_until;
  out.port.wait = wait_until;
  out.port.sync = sync_until;
  out.port.close = close_always;
}

#endif

} // namespace c2d
