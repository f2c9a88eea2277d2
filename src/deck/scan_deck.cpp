// c2d_scan_deck, c2d_check_deck: sizes and faults of a deck without a workspace.
#include "deck/deck.hpp"
#include "memory/structs.hpp"

#include <string.h>

namespace c2d {
namespace {

void keep_first(void* context, const c2d_error* entry) {
  c2d_error* why = static_cast<c2d_error*>(context);
  if (why->status == C2D_OK) copy_out(entry, sizeof *entry, why);
}

c2d_error fault_with(c2d_status status) {
  c2d_error e;
  memset(&e, 0, sizeof e);
  e.struct_size = static_cast<uint32_t>(sizeof e);
  e.status = status;
  e.severity = C2D_FAULT;
  return e;
}

// Not part of scan: its frame would add to that of the reader.
[[gnu::noinline]] c2d_status refuse(c2d_report report, void* report_context, const char* name, const void* argument) {
  c2d_error e = fault_with(C2D_ERR_ARGUMENT);
  Text text = text_in(e.text);
  put_not_begun(text, name, argument);
  if (report != nullptr) report(report_context, &e);
  return C2D_ERR_ARGUMENT;
}

c2d_status scan(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context) {
  if (read == nullptr) return refuse(report, report_context, "read_line", nullptr);
  if (!is_begun(out)) return refuse(report, report_context, "c2d_limits", out);
  c2d_limits theirs, sizes;
  copy_in(out, &theirs, sizeof theirs);
  sizes = theirs;
  const c2d_status status = read_deck_cards(nullptr, read, context, report, report_context, &sizes);
  if (status == C2D_ERR_LIMIT) { // the list of bodies is too short: only their number is returned
    theirs.bodies = sizes.bodies;
    copy_out(&theirs, sizeof theirs, out);
  }
  if (status == C2D_OK) copy_out(&sizes, sizeof sizes, out);
  return status;
}

} // namespace
} // namespace c2d

c2d_status c2d_check_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context) {
  return c2d::scan(read, context, out, report, report_context);
}

c2d_status c2d_scan_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_error* why) {
  if (why == nullptr) return c2d::scan(read, context, out, nullptr, nullptr);
  // `why` must have room for its status at least, by which the first fault is recognised.
  if (!c2d::is_begun(why) || why->struct_size < 2 * sizeof(uint32_t)) return C2D_ERR_ARGUMENT;
  why->status = C2D_OK;
  return c2d::scan(read, context, out, c2d::keep_first, why);
}

c2d_status c2d_walk_deck(c2d_read_line read, void* context, c2d_body_limits* body, int32_t bodies, c2d_card_fn card,
                         void* card_context, c2d_report report, void* report_context) {
  if (read == nullptr) return c2d::refuse(report, report_context, "read_line", nullptr);
  c2d_limits sizes = c2d_limits();
  sizes.body = body;
  sizes.bodies = bodies;
  return c2d::read_deck_cards(nullptr, read, context, report, report_context, &sizes, card, card_context);
}
