// Error codes and messages.
#include "fortran77.hpp"

#include <string.h>

namespace c2d {
namespace fortran {

const char* message(int32_t status) {
  switch (status) {
  case kBadInteger: return "INTEGER has 8 bytes here: compile the calling program with INTEGER*4";
  case kBadReal: return "the literal given to C2OPEN is not 1987.015625D0 of 8 bytes: compile without -fdefault-real-8";
  case kBadCheck: return "ICHECK does not contain the values required by C2OPEN";
  case kNotOpen: return "C2OPEN has not been called for this array, or it has been moved or overwritten";
  case kBadName: return "a name is empty or too long";
  default: return c2d_message(status);
  }
}

} // namespace fortran
} // namespace c2d

using namespace c2d::fortran;

namespace {

void put_entry(const Entry& entry, Out info, int32_t count, Out text, int32_t length) {
  for (int32_t i = 0; i < count && i < kInfo; ++i) put_integer(info, entry.info[i], i);
  put_text(text, length, entry.text);
}

} // namespace

void c2stat_(Work work, Out istate) {
  Call call(work);
  put_integer(istate, call.solver ? c2d_get_state(call.solver) : call.host ? C2D_STATE_EMPTY : -1);
}

void c2why_(Work work, Out info, In ninfo, Out text, In ltext) {
  const Host* host = host_of(work);
  if (host) return put_entry(host->error, info, integer_at(ninfo), text, integer_at(ltext));
  for (int32_t i = 0; i < integer_at(ninfo) && i < kInfo; ++i) put_integer(info, i == 0 ? kNotOpen : 0, i);
  put_text(text, integer_at(ltext), message(kNotOpen));
}

void c2note_(Work work, In i, Out info, In ninfo, Out text, In ltext, Out ierr) {
  const Host* host = host_of(work);
  const int32_t kept = !host ? 0 : host->entries < kEntriesKept ? host->entries : kEntriesKept;
  const int32_t which = integer_at(i);
  c2d_status status = C2D_OK;
  if (!host)
    status = kNotOpen;
  else if (which < 1 || which > kept)
    status = C2D_ERR_ARGUMENT; // not recorded as a failure: it is the end of the list
  else
    put_entry(host->entry[which - 1], info, integer_at(ninfo), text, integer_at(ltext));
  put_integer(ierr, status);
}

void c2msg_(In icode, Out text, In ltext) { put_text(text, integer_at(ltext), message(integer_at(icode))); }
void c2omsg_(In iout, Out text, In ltext) { put_text(text, integer_at(ltext), c2d_outcome_message(integer_at(iout))); }
void c2vers_(Out text, In ltext) { put_text(text, integer_at(ltext), c2d_version()); }
