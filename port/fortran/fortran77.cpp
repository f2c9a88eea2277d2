// Numbers and texts at any address, and access to the solver in WORK.
#include "fortran77.hpp"

#include <string.h>

namespace c2d {
namespace fortran {

namespace {

constexpr uint64_t kMark = UINT64_C(0x3737467232644332); // the bytes 2Cd2rF77

// The first two words of WORK; they alone show whether WORK is open.
struct Mark {
  uint64_t magic, host_at;
};

uint64_t host_place(uintptr_t address) { return (address + sizeof(Mark) + 63) / 64 * 64 - address; }

} // namespace

int32_t integer_at(In from, int32_t i) {
  int32_t value;
  memcpy(&value, static_cast<const char*>(from) + static_cast<ptrdiff_t>(i) * 4, sizeof value);
  return value;
}

double real_at(In from, int32_t i) {
  double value;
  memcpy(&value, static_cast<const char*>(from) + static_cast<ptrdiff_t>(i) * 8, sizeof value);
  return value;
}

void put_integer(Out to, int32_t value, int32_t i) {
  memcpy(static_cast<char*>(to) + static_cast<ptrdiff_t>(i) * 4, &value, sizeof value);
}

void put_real(Out to, double value, int32_t i) {
  memcpy(static_cast<char*>(to) + static_cast<ptrdiff_t>(i) * 8, &value, sizeof value);
}

void put_text(Out to, int32_t length, const char* text) {
  char* out = static_cast<char*>(to);
  for (int32_t i = 0; i < length; ++i) out[i] = *text != '\0' ? *text++ : ' ';
}

bool get_text(Text from, int32_t length, char* to, int32_t room) {
  const char* in = static_cast<const char*>(from);
  while (length > 0 && (in[length - 1] == ' ' || in[length - 1] == '\0')) --length;
  if (length >= room) return false;
  if (length > 0) memcpy(to, in, static_cast<size_t>(length));
  to[length > 0 ? length : 0] = '\0';
  return length > 0;
}

bool is_aligned(In reals) { return reinterpret_cast<uintptr_t>(reals) % alignof(double) == 0; }

Reals::Reals(In from, int32_t count) : data_(copy_), ok_(true) {
  if (is_aligned(from)) {
    data_ = static_cast<const double*>(from);
  } else if (count > 0 && count <= 64) {
    memcpy(copy_, from, static_cast<size_t>(count) * sizeof(double));
  } else {
    ok_ = count <= 0; // the library reports such a count
  }
}

Host* host_of(Work work) {
  Mark mark;
  memcpy(&mark, work, sizeof mark);
  if (mark.magic != kMark || mark.host_at >= 16 + 64) return nullptr;
  const uintptr_t address = reinterpret_cast<uintptr_t>(work);
  if ((address + mark.host_at) % 64 != 0) return nullptr;
  Host* host = reinterpret_cast<Host*>(static_cast<char*>(work) + mark.host_at);
  return host->address == address ? host : nullptr;
}

Host* moved_host_of(Work work) {
  Mark mark;
  memcpy(&mark, work, sizeof mark);
  if (mark.magic != kMark || mark.host_at >= 16 + 64) return nullptr;
  const uintptr_t address = reinterpret_cast<uintptr_t>(work);
  char* old = static_cast<char*>(work) + mark.host_at;
  mark.host_at = host_place(address);
  Host* host = reinterpret_cast<Host*>(static_cast<char*>(work) + mark.host_at);
  memmove(static_cast<void*>(host), old, sizeof *host);
  memcpy(work, &mark, sizeof mark);
  host->address = address;
  return host;
}

c2d_error blank_error() {
  c2d_error error;
  memset(&error, 0, sizeof error);
  error.struct_size = static_cast<uint32_t>(sizeof error);
  return error;
}

int32_t words_of(uint64_t bytes) {
  const uint64_t words = bytes / 8 + (bytes % 8 != 0);
  return words > INT32_MAX ? 0 : static_cast<int32_t>(words);
}
int32_t words_for(uint64_t solver_bytes) { return words_of(solver_bytes + kHostSlack); }

int32_t at_most(uint64_t count) { return count > INT32_MAX ? INT32_MAX : static_cast<int32_t>(count); }

Entry entry_of(const c2d_error& e) {
  const int32_t words = e.bytes_needed > 0 ? words_for(e.bytes_needed) : 0;
  const int32_t info[kInfo] = {e.status, e.severity, e.host_code, e.line, e.column, e.column_end, e.body,
                               e.zone,   e.pair,     e.element,   e.node, e.tape,   words};
  Entry entry;
  memcpy(entry.info, info, sizeof info);
  memcpy(entry.text, e.text, sizeof entry.text);
  return entry;
}

Call::Call(Work work) : host(host_of(work)) {
  if (!host) {
    status = kNotOpen;
  } else if (host->solver_at != 0) {
    solver = reinterpret_cast<c2d_solver*>(static_cast<char*>(work) + host->solver_at);
  }
}

bool Call::ready() {
  if (host && !solver) status = C2D_ERR_STATE;
  return solver != nullptr;
}

// The last error of the solver, if it is this failure or the one that broke it; else the code and its message.
void Call::keep_failure() {
  c2d_error error = blank_error();
  if (solver) c2d_last_error(solver, &error);
  if (solver && (error.status == status || c2d_get_state(solver) == C2D_STATE_BROKEN)) {
    host->error = entry_of(error);
  } else if (!reported) {
    error = blank_error();
    error.status = status;
    error.severity = C2D_FAULT;
    put_text(error.text, static_cast<int32_t>(strlen(message(status))), message(status));
    host->error = entry_of(error);
  }
  if (status == C2D_ERR_STORE_OPEN && host->store_kind == kMemoryStore)
    host->error.info[kInfo - 1] = words_of(c2d_memory_store_need(&host->store.memory));
}

void Call::tell(const c2d_error& error) {
  host->error = entry_of(error);
  reported = true;
}

void Call::leave(Out ierr) {
  if (host && status != C2D_OK) keep_failure();
  put_integer(ierr, status);
}

} // namespace fortran
} // namespace c2d

using namespace c2d::fortran;

namespace {

// The check values of README.md: INTEGER ICHECK(2), and a literal. Options that change the length of 0.3D0 may keep that of
// REAL*8 or change it too: the literal detects both. No number of 16 bytes begins like one of 8.
constexpr int32_t kIntegers[2] = {1987, 64};
constexpr double kLiteral = 1987.015625;

void open_work(Work work, int64_t words) {
  const uintptr_t address = reinterpret_cast<uintptr_t>(work);
  const Mark mark = {kMark, host_place(address)};
  memcpy(work, &mark, sizeof mark);
  Host* host = reinterpret_cast<Host*>(static_cast<char*>(work) + mark.host_at);
  memset(static_cast<void*>(host), 0, sizeof *host);
  host->address = address;
  host->bytes = static_cast<uint64_t>(words) * 8;
  host->options.struct_size = static_cast<uint32_t>(sizeof host->options);
}

} // namespace

// An array of two 8-byte integers begins with 1987, 0 or 0, 1987 in units of 4 bytes, whichever end is first.
// IERR has then 8 bytes too, and all of them are set.
bool c2d::fortran::check_caller(In icheck, In rlit, Out ierr) {
  const int32_t first = integer_at(icheck), second = integer_at(icheck, 1);
  const bool wide = (first == kIntegers[0] && second == 0) || (first == 0 && second == kIntegers[0]);
  if (wide) {
    const int64_t error = kBadInteger;
    memcpy(ierr, &error, sizeof error);
    return false;
  }
  int32_t status = C2D_OK;
  if (first != kIntegers[0] || second != kIntegers[1])
    status = kBadCheck;
  else if (real_at(rlit) != kLiteral)
    status = kBadReal;
  put_integer(ierr, status);
  return status == C2D_OK;
}

void c2open_(Work work, In nwords, In icheck, In rlit, Out ierr) {
  if (!check_caller(icheck, rlit, ierr)) return;
  const int64_t words = integer_at(nwords);
  if (words > static_cast<int64_t>(kHostSlack / 8))
    open_work(work, words);
  else
    put_integer(ierr, C2D_ERR_MEMORY);
}

namespace {

void close_work(Work work, Out ierr, bool drop) {
  Call call(work);
  if (call.solver) call.status = c2d_close(call.solver);
  if (call.status == C2D_ERR_BUSY || !call.host) return call.leave(ierr);
  call.solver = nullptr; // no solver is left
  if (drop && call.host->store_kind == kFileStore && c2d_stdio_store_remove(&call.host->store.files) != 0 &&
      call.status == C2D_OK)
    call.status = C2D_ERR_STORE_CLOSE;
  put_integer(ierr, call.status);
  const Mark none = {0, 0};
  memcpy(work, &none, sizeof none);
}

} // namespace

void c2clos_(Work work, Out ierr) { close_work(work, ierr, false); }
void c2drop_(Work work, Out ierr) { close_work(work, ierr, true); }
