// Save, restore, and attach to a moved workspace.
#include "fortran77.hpp"

#include <string.h>

using namespace c2d::fortran;

void c2save_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_save(call.solver);
  call.leave(ierr);
}

void c2rest_(Work work, Out ierr) {
  Call call(work);
  if (call.ready()) call.status = c2d_restore(call.solver);
  call.leave(ierr);
}

// Files and arrays have new handles and addresses: those in the block store may belong to another process.
void c2atch_(Work work, In nwords, In icheck, In rlit, Out store, Out ierr) {
  if (!check_caller(icheck, rlit, ierr)) return;
  Host* host = moved_host_of(work);
  const int64_t words = integer_at(nwords);
  if (!host) return put_integer(ierr, kNotOpen);
  if (words <= static_cast<int64_t>(kHostSlack / 8)) return put_integer(ierr, C2D_ERR_MEMORY);
  host->bytes = static_cast<uint64_t>(words) * 8;
  if (host->store_kind == kMemoryStore) host->store.memory.region = static_cast<unsigned char*>(store);
  if (host->store_kind == kFileStore) memset(host->store.files.file, 0, sizeof host->store.files.file);
  Call call(work);
  if (host->solver_at != 0) {
    const c2d_port port = port_of(host);
    c2d_error why = blank_error();
    c2d_solver* solver = nullptr;
    call.status =
        c2d_attach(&solver, static_cast<char*>(work) + kHostSlack, static_cast<size_t>(host->bytes - kHostSlack), &port, &why);
    call.solver = solver;
    if (solver) host->solver_at = static_cast<uint64_t>(reinterpret_cast<char*>(solver) - static_cast<char*>(work));
    if (!solver) call.tell(why);
  }
  call.leave(ierr);
}
