// The FORTRAN 77 names (described in README.md) and their common helpers.
//
// Arguments may have any address: some compilers lay out COMMON blocks without gaps, so that a
// REAL*8 need not be a multiple of 8. Every number is therefore moved byte by byte. CHARACTER arguments come
// with an explicit length; the hidden length that compilers append is ignored.
#pragma once

#include "c2d_memory.h"
#include "c2d_stdio.h"
#include "contact2d.h"

namespace c2d {
namespace fortran {

using In = const void*;   // INTEGER*4 or REAL*8, or an array of them, read
using Out = void*;        // the same, written
using Work = void*;       // REAL*8 WORK(NWORDS): all state between calls
using Text = const void*; // CHARACTER*(*)

// Values of IERR besides those of c2d_status.
enum {
  kBadInteger = 51, // the INTEGER of the caller does not have 4 bytes
  kBadReal = 52,    // the literal of the caller does not have 8 bytes, or a wrong value
  kBadCheck = 53,   // the check values are not those of README.md
  kNotOpen = 54,    // C2OPEN has not been called for this array, or it was moved
  kBadName = 55     // a name that is empty or too long
};
const char* message(int32_t status); // for any of them

// A fault, warning or note, as returned by C2WHY and C2NOTE.
constexpr int32_t kInfo = 13;
struct Entry {
  int32_t info[kInfo];
  char text[sizeof(c2d_error::text)];
};

// The data before the solver in WORK. The block store is the first member, because c2d_port has one
// context for the store and for the log.
constexpr int32_t kEntriesKept = 6;
struct Host {
  union {
    c2d_memory_store memory;
    c2d_stdio_store files;
  } store;
  uint64_t address, bytes; // of WORK as it was opened
  uint64_t solver_at;      // bytes from WORK to the solver; 0: no solver yet
  c2d_options options;
  int32_t store_kind; // kNoStore ...
  int32_t entries;    // messages of the solver since its creation; the first kEntriesKept are kept
  Entry error;        // of the last call that failed
  Entry entry[kEntriesKept];
};
enum { kNoStore = 0, kMemoryStore = 1, kFileStore = 2 };
// Bytes before the memory of the solver. The host is at the first multiple of 64 after
// the mark; the memory of the solver has a fixed offset, so that WORK may be moved (C2ATCH).
constexpr uint64_t kHostSlack = 16 + 64 + sizeof(Host);

int32_t integer_at(In from, int32_t i = 0);
double real_at(In from, int32_t i = 0);
void put_integer(Out to, int32_t value, int32_t i = 0);
void put_real(Out to, double value, int32_t i = 0);
void put_text(Out to, int32_t length, const char* text); // padded with blanks
// Replaces the blanks after the last word by a zero byte; false if there is no room or no word.
bool get_text(Text from, int32_t length, char* to, int32_t room);

bool is_aligned(In reals);
// At most 64 numbers at an aligned address; more only if they are aligned already.
class Reals {
public:
  Reals(In from, int32_t count);
  bool ok() const { return ok_; }
  const double* data() const { return data_; }

private:
  double copy_[64];
  const double* data_;
  bool ok_;
};

// State of a call.
class Call {
public:
  explicit Call(Work work); // finds the host and the solver in WORK
  bool has_host() const { return host != nullptr; }
  bool ready();                      // has a solver; else the status is set
  void tell(const c2d_error& error); // records the failure, if the solver cannot
  void leave(Out ierr);              // writes IERR and stores the failure
  void forget_solver() { solver = nullptr, host->solver_at = 0; }

  Host* host = nullptr;
  c2d_solver* solver = nullptr;
  c2d_status status = C2D_OK;

private:
  void keep_failure();
  bool reported = false;
};

Host* host_of(Work work); // null: not open
// Finds the host in WORK also if it was opened at another address, and moves it to its place for this address; null:
// none.
Host* moved_host_of(Work work);
// Are these the check values of C2OPEN? If not, IERR is set to the reason.
bool check_caller(In icheck, In rlit, Out ierr);
Entry entry_of(const c2d_error& error);
c2d_error blank_error();
// Words of so many bytes, and words of WORK for a solver of so many bytes; 0 if they exceed INTEGER*4.
int32_t words_of(uint64_t bytes);
int32_t words_for(uint64_t solver_bytes);
int32_t at_most(uint64_t count); // the count, or the largest INTEGER*4
c2d_port port_of(Host* host);
// Creates the solver with these limits; sets call.status.
void make_solver(Call& call, Work work, const c2d_limits& limits);
// Limits and their list of bodies, on the stack: only WORK is kept between calls.
constexpr int32_t kMostBodies = 200;
struct Limits : c2d_limits {
  Limits();
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
  c2d_body_limits bodies_of[kMostBodies];
};

} // namespace fortran
} // namespace c2d

// Names of FORTRAN as compilers write them: small letters and an underscore.
extern "C" {
using c2d::fortran::In;
using c2d::fortran::Out;
using c2d::fortran::Text;
using c2d::fortran::Work;

// opening, decks, closing: fortran77.cpp, fortran77_deck.cpp
void c2open_(Work work, In nwords, In icheck, In rlit, Out ierr);
void c2tape_(Work work, Text name, In lname, Out ierr);
void c2core_(Work work, Out store, In nstore, Out ierr);
void c2opts_(Work work, In iquad, In istep, In ichang, In isymm, Out ierr);
void c2keep_(Work work, In ikeep, Out ierr);
void c2deck_(Work work, Text name, In lname, Out ierr);
void c2card_(Work work, Text cards, In lcard, In ncards, Out ierr);
void c2need_(Work work, Text name, In lname, Out nmin, Out nall, Out ierr);
void c2neds_(Work work, In isize, In nisize, Out nmin, Out nall, Out ierr);
void c2tned_(Work work, Text name, In lname, In itape, Out nblock, Out nwords, Out ierr);
void c2tnds_(Work work, In isize, In nisize, In itape, Out nblock, Out nwords, Out ierr);
void c2size_(Work work, In isize, In nisize, Out ierr);
void c2clos_(Work work, Out ierr);
void c2drop_(Work work, Out ierr);

// a model by calls: fortran77_model.cpp
void c2prob_(Work work, In iplane, In iout, In itmax, Text title, In ltitle, Out ierr);
void c2body_(Work work, In ibody, In nbn, In nel, In nren, In nopen, In young, In poiss, Out ierr);
void c2regn_(Work work, In ibody, In ifirst, In ilast, Out ierr);
void c2node_(Work work, In ibody, In ifirst, In n, In xy, In ldxy, Out ierr);
void c2nlin_(Work work, In ibody, In ifirst, In ilast, In origin, In from, In to, Out ierr);
void c2narc_(Work work, In ibody, In ifirst, In ilast, In centre, In radius, In angle1, In angle2, Out ierr);
void c2cond_(Work work, In ibody, In ielem, In ilocal, In icase, In icodes, In values, Out ierr);
void c2case_(Work work, In ibody, In ielem, In ilocal, In icase, In values, Out ierr);
void c2load_(Work work, In ibody, In icase, In x, In y, In fx, In fy, Out ierr);
void c2rigd_(Work work, In ibody, In icase, In motion, In axis, Out ierr);
void c2plat_(Work work, In ibody, In ielem, In ifree, In point, Out ierr);
void c2rgld_(Work work, In ibody, In icase, In ifree, In force, In point, Out ierr);
void c2intf_(Work work, In icase, Out ierr);
void c2bfor_(Work work, In ibody, In icase, In force, In rhom2, In axis, Out ierr);
void c2zone_(Work work, In ikind, In npairs, In iside1, In iside2, Out ierr);
void c2tie_(Work work, In izone, Out ierr);
void c2mu_(Work work, In fmu, Out ierr);
void c2muz_(Work work, In izone, In i, In fmu, Out ierr);
void c2symm_(Work work, In iaxis, In value, Out ierr);
void c2path_(Work work, In ninc, In factor, In ncases, Out ierr);
void c2clrp_(Work work, Out ierr);
void c2acrv_(Work work, In ikind, In ibody, In ielem, In circle, Out ierr);
void c2apts_(Work work, In ikind, In ibody, In icount, In from, In to, Out ierr);
void c2unit_(Work work, Text length, In llen, Text force, In lforce, Out ierr);
void c2name_(Work work, In ikind, In i, Text name, In lname, Out ierr);
void c2line_(Work work, In iline, In icol, In icol2, Out ierr);
void c2done_(Work work, Out ierr);

// solving: fortran77_solve.cpp, fortran77_keep.cpp
using c2_step = void (*)(const int32_t* kind, const int32_t* imu, const int32_t* istep, const int32_t* iout, const double* fmu,
                         const double* factor, const int32_t* npairs, const double* table, const int32_t* ldt, int32_t* istop,
                         const int32_t* ncases, const double* works, const double* energy);
void c2prep_(Work work, Out ierr);
void c2save_(Work work, Out ierr);
void c2rest_(Work work, Out ierr);
void c2atch_(Work work, In nwords, In icheck, In rlit, Out store, Out ierr);
void c2chld_(Work work, Out ierr);
void c2rpld_(Work work, In i, In x, In y, In fx, In fy, Out ierr);
void c2begn_(Work work, In fmu, In nzones, Out ierr);
void c2advn_(Work work, In factor, In ncases, Out iout, Out ierr);
void c2next_(Work work, In direct, In ncases, Out step, Out ierr);
void c2solv_(Work work, c2_step step, Out ierr);
void c2none_(const int32_t* kind, const int32_t* imu, const int32_t* istep, const int32_t* iout, const double* fmu,
             const double* factor, const int32_t* npairs, const double* table, const int32_t* ldt, int32_t* istop,
             const int32_t* ncases, const double* works, const double* energy);
void c2canc_(Work work, Out ierr);

// answers: fortran77_results.cpp
void c2get_(Work work, In ifield, In ibody, In ifirst, In n, Out a, In lda, Out ierr);
void c2intr_(Work work, In ibody, In n, In xy, In ldxy, Out a, In lda, Out ierr);
void c2indi_(Work work, In ibody, In ifirst, In n, Out a, In lda, Out ierr);
void c2summ_(Work work, Out isum, In ni, Out rsum, In nr, Out ierr);
void c2bsta_(Work work, In ibody, Out icount, Out r, Out ierr);
void c2zsta_(Work work, In izone, Out icount, Out r, Out ierr);
void c2bnow_(Work work, In ibody, Out irigid, Out r, Out ierr);
void c2gmu_(Work work, In izone, In i, Out fmu, Out ierr);
void c2gpth_(Work work, In i, Out ninc, Out factor, In ncases, Out ierr);
void c2gzon_(Work work, In i, Out ikind, Out npairs, Out iside1, Out iside2, Out ierr);
void c2greg_(Work work, In ibody, In i, Out ifirst, Out ilast, Out ierr);
void c2gcon_(Work work, In ibody, In ielem, In ilocal, In icase, Out icodes, Out values, Out ierr);
void c2gpld_(Work work, In i, Out ibody, Out icase, Out xy, Out force, Out ierr);
void c2gbfo_(Work work, In ibody, In icase, Out force, Out rhom2, Out axis, Out ierr);
void c2grig_(Work work, In ibody, In icase, Out irigid, Out motion, Out axis, Out ierr);
void c2gint_(Work work, Out icase, Out ierr);
void c2gnam_(Work work, In ikind, In i, Out name, In lname, Out ierr);
void c2gcrv_(Work work, In i, Out ikind, Out ibody, Out ielem, Out iline, Out circle, Out ierr);
void c2gpts_(Work work, In i, Out ikind, Out ibody, Out icount, Out iline, Out from, Out to, Out ierr);
void c2xpts_(Work work, In i, In ifirst, In n, Out xy, In ldxy, Out ntotal, Out ierr);

// errors and words: fortran77_words.cpp
void c2stat_(Work work, Out istate);
void c2why_(Work work, Out info, In ninfo, Out text, In ltext);
void c2note_(Work work, In i, Out info, In ninfo, Out text, In ltext, Out ierr);
void c2msg_(In icode, Out text, In ltext);
void c2omsg_(In iout, Out text, In ltext);
void c2vers_(Out text, In ltext);
}
