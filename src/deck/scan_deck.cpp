// Sizes and faults of a deck without any workspace.
#include "deck/deck.hpp"

#include <string.h>

namespace c2d {
namespace {

// Copy what both sides know of a struct that begins with its size; the receiver's size stays.
template <class T> void hand_out(const T& from, T* to) {
  const uint32_t size = to->struct_size;
  memcpy(to, &from, size < sizeof from ? size : sizeof from);
  to->struct_size = size;
}

void keep_first(void* context, const c2d_error* entry) {
  c2d_error* why = static_cast<c2d_error*>(context);
  if (why->status == C2D_OK) hand_out(*entry, why);
}

c2d_status scan(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context) {
  if (read == nullptr || out == nullptr || out->struct_size < sizeof out->struct_size) return C2D_ERR_ARGUMENT;
  c2d_limits sizes = c2d_limits();
  const c2d_status status = read_deck_cards(nullptr, read, context, report, report_context, &sizes);
  if (status == C2D_OK) hand_out(sizes, out);
  return status;
}

} // namespace
} // namespace c2d

c2d_status c2d_check_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context) {
  return c2d::scan(read, context, out, report, report_context);
}

c2d_status c2d_scan_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_error* why) {
  if (why == nullptr) return c2d::scan(read, context, out, nullptr, nullptr);
  // `why` must hold at least its status, by which the first fault is recognised.
  if (why->struct_size < 2 * sizeof(uint32_t)) return C2D_ERR_ARGUMENT;
  why->status = C2D_OK;
  const c2d_status status = c2d::scan(read, context, out, c2d::keep_first, why);
  if (status == C2D_ERR_ARGUMENT) why->status = status;
  return status;
}

c2d_status c2d_walk_deck(c2d_read_line read, void* context, c2d_card_fn card, void* card_context, c2d_report report,
                         void* report_context) {
  if (read == nullptr) return C2D_ERR_ARGUMENT;
  return c2d::read_deck_cards(nullptr, read, context, report, report_context, nullptr, card, card_context);
}
