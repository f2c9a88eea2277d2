// Reads a deck from a file or an array of cards, finds its sizes, and creates the solver.
#include "fortran77.hpp"

#include <errno.h>
#include <stdio.h>
#include <string.h>

namespace c2d {
namespace fortran {

namespace {

// Source of cards: a file, or CHARACTER*(length) CARDS(count).
struct Cards {
  FILE* file;
  const char* first;
  int64_t length, count, next;
};

int32_t next_of_file(FILE* file, char* text, int32_t size) {
  int32_t length = 0;
  int c = fgetc(file);
  if (c == EOF) return ferror(file) ? -2 : -1;
  for (; c != EOF && c != '\n'; c = fgetc(file)) {
    if (length + 1 < size) text[length] = static_cast<char>(c);
    ++length;
  }
  if (length > 0 && length < size && text[length - 1] == '\r') --length;
  text[length < size ? length : size - 1] = '\0';
  return length;
}

int32_t next_card(void* context, char* text, int32_t size) {
  Cards& cards = *static_cast<Cards*>(context);
  if (cards.file) return next_of_file(cards.file, text, size);
  if (cards.next >= cards.count) return -1;
  const char* card = cards.first + cards.next++ * cards.length;
  int32_t length = static_cast<int32_t>(cards.length);
  while (length > 0 && card[length - 1] == ' ') --length; // trailing blanks
  const int32_t kept = length < size ? length : size - 1;
  if (kept > 0) memcpy(text, card, static_cast<size_t>(kept));
  text[kept] = '\0';
  return length;
}

void rewind_cards(Cards& cards) {
  cards.next = 0;
  if (cards.file) rewind(cards.file);
}

bool open_file(Call& call, Text name, int32_t length, Cards& cards) {
  char path[512];
  cards = Cards{nullptr, nullptr, 0, 0, 0};
  if (!get_text(name, length, path, static_cast<int32_t>(sizeof path))) {
    call.status = kBadName;
    return false;
  }
  errno = 0;
  cards.file = fopen(path, "rb");
  if (cards.file) return true;
  c2d_error error = blank_error();
  call.status = error.status = C2D_ERR_READ;
  error.severity = C2D_FAULT;
  error.host_code = errno;
  const char text[] = "the deck's file cannot be opened";
  memcpy(error.text, text, sizeof text);
  call.tell(error);
  return false;
}

c2d_status sizes_of(Call& call, Cards& cards, c2d_limits& limits) {
  c2d_error why = blank_error();
  call.status = c2d_scan_deck(next_card, &cards, &limits, &why);
  if (call.status != C2D_OK) call.tell(why);
  return call.status;
}

// Reads the deck, and discards the solver if that fails: the next deck has other sizes.
void read_cards(Call& call, Work work, Cards& cards) {
  Limits limits;
  if (call.solver) call.status = C2D_ERR_STATE;
  if (call.status != C2D_OK || sizes_of(call, cards, limits) != C2D_OK) return;
  rewind_cards(cards);
  make_solver(call, work, limits);
  if (call.status != C2D_OK) return;
  call.status = c2d_read_deck(call.solver, next_card, &cards);
  if (call.status == C2D_OK) return;
  c2d_error why = blank_error();
  c2d_last_error(call.solver, &why);
  call.tell(why);
  c2d_close(call.solver);
  call.forget_solver();
}

// ISIZE: bodies, functional nodes, then boundary points, elements and regions, each of all bodies (of one as of two), and the
// rest of c2d_limits.
bool limits_from(In isize, int32_t count, Limits& limits) {
  int32_t* const rest[] = {&limits.zones,        &limits.pairs,      &limits.contact_elements, &limits.point_loads,
                           &limits.coefficients, &limits.paths,      &limits.load_cases,       &limits.panel_columns,
                           &limits.free_pairs,   &limits.point_sets, &limits.curves,           &limits.platens,
                           &limits.touching};
  int32_t c2d_body_limits::*const of_body[] = {&c2d_body_limits::points, &c2d_body_limits::elements, &c2d_body_limits::regions};
  if (count < 1) return false;
  limits.bodies = integer_at(isize);
  if (limits.bodies > kMostBodies) return false;
  const int32_t listed = limits.bodies > 2 ? limits.bodies : 2, first = 2 + 3 * listed;
  if (count > first + static_cast<int32_t>(sizeof rest / sizeof *rest)) return false;
  if (count > 1) limits.function_nodes = integer_at(isize, 1);
  for (int32_t i = 2; i < count && i < first; ++i)
    limits.bodies_of[(i - 2) % listed].*of_body[(i - 2) / listed] = integer_at(isize, i);
  for (int32_t i = first; i < count; ++i) *rest[i - first] = integer_at(isize, i);
  return true;
}

// Those of the deck in a file. False: no deck was read.
bool sizes_of_file(Call& call, Text name, In length, c2d_limits& limits) {
  Cards cards;
  if (!call.has_host() || !open_file(call, name, integer_at(length), cards)) return false;
  sizes_of(call, cards, limits);
  fclose(cards.file);
  return true;
}

void tell_words(Call& call, const c2d_limits& limits, Out nmin, Out nall) {
  uint64_t least = 0, most = 0;
  if (call.status != C2D_OK) return;
  c2d_error why = blank_error();
  call.status = c2d_memory_need(&limits, &least, &most, &why);
  if (call.status != C2D_OK) return call.tell(why);
  const int32_t least_words = words_for(least);
  if (least_words == 0) {
    call.status = C2D_ERR_OVERFLOW;
    return;
  }
  put_integer(nmin, least_words);
  put_integer(nall, at_most((most + kHostSlack + 7) / 8));
}

// For a solver created in the array as opened, with the current options.
void tell_tape(Call& call, const c2d_limits& limits, int32_t tape, Out nblock, Out nwords) {
  uint64_t blocks = 0, bytes = 0;
  if (call.status != C2D_OK) return;
  c2d_error why = blank_error();
  call.status = c2d_tape_need(&limits, &call.host->options, call.host->bytes - kHostSlack, tape, &blocks, &bytes, &why);
  if (call.status != C2D_OK) return call.tell(why);
  if (blocks > INT32_MAX || bytes / 8 >= INT32_MAX) call.status = C2D_ERR_OVERFLOW;
  if (call.status != C2D_OK) return;
  put_integer(nblock, static_cast<int32_t>(blocks));
  put_integer(nwords, words_of(bytes));
}

// For the current solver and later ones.
void take_options(Call& call, const c2d_options& options) {
  if (call.solver) call.status = c2d_set_options(call.solver, &options);
  if (call.status == C2D_OK) call.host->options = options;
}

void keep_entry(void* context, const c2d_error* error) {
  Host* host = static_cast<Host*>(context);
  if (host->entries < kEntriesKept) host->entry[host->entries] = entry_of(*error);
  ++host->entries;
}

} // namespace

Limits::Limits() : c2d_limits(C2D_INIT(c2d_limits)), bodies_of() {
  bodies = kMostBodies;
  body = bodies_of;
}

c2d_port port_of(Host* host) {
  c2d_port port = C2D_INIT(c2d_port);
  if (host->store_kind == kMemoryStore) c2d_memory_store_port(&host->store.memory, &port);
  if (host->store_kind == kFileStore) c2d_stdio_store_port(&host->store.files, &port);
  port.context = host;
  port.log = keep_entry;
  return port;
}

void make_solver(Call& call, Work work, const c2d_limits& limits) {
  Host* host = call.host;
  const c2d_port port = port_of(host);
  host->entries = 0;
  char* memory = static_cast<char*>(work) + kHostSlack;
  c2d_error why = blank_error();
  c2d_solver* solver = nullptr;
  call.status = c2d_create(&solver, memory, static_cast<size_t>(host->bytes - kHostSlack), &limits, &port, &why);
  if (call.status != C2D_OK) {
    call.tell(why);
    return;
  }
  call.solver = solver;
  host->solver_at = static_cast<uint64_t>(reinterpret_cast<char*>(solver) - static_cast<char*>(work));
  call.status = c2d_set_options(solver, &host->options);
}

} // namespace fortran
} // namespace c2d

using namespace c2d::fortran;

void c2tape_(Work work, Text name, In lname, Out ierr) {
  Call call(work);
  char folder[sizeof(c2d_stdio_store::folder)];
  if (call.solver) call.status = C2D_ERR_STATE;
  if (call.status == C2D_OK && !get_text(name, integer_at(lname), folder, static_cast<int32_t>(sizeof folder)))
    call.status = kBadName;
  if (call.status == C2D_OK) {
    c2d_stdio_store_init(&call.host->store.files, folder);
    call.host->store_kind = kFileStore;
  }
  call.leave(ierr);
}

void c2core_(Work work, Out store, In nstore, Out ierr) {
  Call call(work);
  const int64_t words = integer_at(nstore);
  if (call.solver) call.status = C2D_ERR_STATE;
  if (call.status == C2D_OK && words < 1) call.status = C2D_ERR_ARGUMENT;
  if (call.status == C2D_OK) {
    c2d_memory_store_init(&call.host->store.memory, store, static_cast<uint64_t>(words) * 8);
    call.host->store_kind = kMemoryStore;
  }
  call.leave(ierr);
}

void c2opts_(Work work, In iquad, In istep, In ichang, In isymm, Out ierr) {
  Call call(work);
  if (call.has_host()) {
    c2d_options options = call.host->options;
    options.quadrature = integer_at(iquad);
    options.stepping = integer_at(istep);
    options.every_change = integer_at(ichang);
    options.symmetry = integer_at(isymm);
    take_options(call, options);
  }
  call.leave(ierr);
}

void c2keep_(Work work, In ikeep, Out ierr) {
  Call call(work);
  if (call.has_host()) {
    c2d_options options = call.host->options;
    options.keep_factors = integer_at(ikeep);
    take_options(call, options);
  }
  call.leave(ierr);
}

void c2deck_(Work work, Text name, In lname, Out ierr) {
  Call call(work);
  Cards cards;
  if (call.has_host() && open_file(call, name, integer_at(lname), cards)) {
    read_cards(call, work, cards);
    fclose(cards.file);
  }
  call.leave(ierr);
}

void c2card_(Work work, Text text, In lcard, In ncards, Out ierr) {
  Call call(work);
  Cards cards = {nullptr, static_cast<const char*>(text), integer_at(lcard), integer_at(ncards), 0};
  if (call.has_host() && (cards.length < 1 || cards.count < 1)) call.status = C2D_ERR_ARGUMENT;
  if (call.status == C2D_OK) read_cards(call, work, cards);
  call.leave(ierr);
}

void c2need_(Work work, Text name, In lname, Out nmin, Out nall, Out ierr) {
  Call call(work);
  Limits limits;
  if (sizes_of_file(call, name, lname, limits)) tell_words(call, limits, nmin, nall);
  call.leave(ierr);
}

void c2tned_(Work work, Text name, In lname, In itape, Out nblock, Out nwords, Out ierr) {
  Call call(work);
  Limits limits;
  if (sizes_of_file(call, name, lname, limits)) tell_tape(call, limits, integer_at(itape), nblock, nwords);
  call.leave(ierr);
}

void c2tnds_(Work work, In isize, In nisize, In itape, Out nblock, Out nwords, Out ierr) {
  Call call(work);
  Limits limits;
  if (call.has_host()) {
    if (!limits_from(isize, integer_at(nisize), limits)) call.status = C2D_ERR_ARGUMENT;
    tell_tape(call, limits, integer_at(itape), nblock, nwords);
  }
  call.leave(ierr);
}

void c2neds_(Work work, In isize, In nisize, Out nmin, Out nall, Out ierr) {
  Call call(work);
  Limits limits;
  if (call.has_host()) {
    if (!limits_from(isize, integer_at(nisize), limits)) call.status = C2D_ERR_ARGUMENT;
    tell_words(call, limits, nmin, nall);
  }
  call.leave(ierr);
}

void c2size_(Work work, In isize, In nisize, Out ierr) {
  Call call(work);
  Limits limits;
  if (call.solver) call.status = C2D_ERR_STATE;
  if (call.status == C2D_OK && !limits_from(isize, integer_at(nisize), limits)) call.status = C2D_ERR_ARGUMENT;
  if (call.status == C2D_OK) make_solver(call, work, limits);
  call.leave(ierr);
}
