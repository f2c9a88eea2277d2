// Names of bodies and zones. They only accompany the numbers in messages and outputs.
#include <string.h>

#include "interface/model/refuse.hpp"
#include "memory/characters.hpp"

using namespace c2d;

namespace {

constexpr uint32_t kLegal = kBuilding | kComplete;
constexpr size_t kRoom = 32;
static_assert(sizeof Body::name == kRoom && sizeof Zone::name == kRoom && kLongestName + 1 == kRoom, "as the header says");

// Storage of the name; null: no such body or zone, which was reported.
char* find_name(c2d_solver* s, int32_t kind, int32_t i, c2d_status& status) {
  status = check_ranges(s, {{"kind", kind, C2D_NAME_BODY, C2D_NAME_ZONE}});
  if (status == C2D_OK && kind == C2D_NAME_BODY) status = check_body_number(s, i);
  if (status == C2D_OK && kind == C2D_NAME_ZONE)
    status = s->model.zones == 0 ? refuse(s, C2D_ERR_ARGUMENT, "there is no zone to name yet")
                                 : check_ranges(s, {{"zone", i, 1, s->model.zones}});
  if (status != C2D_OK) return nullptr;
  return kind == C2D_NAME_BODY ? body_numbered(s, i).name : array_of<Zone>(s, kZones)[i - 1].name;
}

} // namespace

extern "C" c2d_status c2d_set_name(c2d_solver* s, int32_t kind, int32_t i, const char* name) {
  c2d_status status = enter(s, kLegal);
  char* const place = status == C2D_OK ? find_name(s, kind, i, status) : nullptr;
  if (place == nullptr) return status;
  const char* const given = name != nullptr ? name : "";
  const char* const fault = fault_of_name(given);
  if (fault != nullptr) {
    Refusal r;
    start_refusal(r, s, C2D_ERR_ARGUMENT);
    put_all(r.text, "the name ", fault);
    report_fault(s, r.error);
    return C2D_ERR_ARGUMENT;
  }
  memset(place, 0, kRoom);
  memcpy(place, given, static_cast<size_t>(text_length(given)));
  if (s->state != C2D_STATE_EMPTY) return C2D_OK;
  return built(s);
}

extern "C" c2d_status c2d_get_name(c2d_solver* s, int32_t kind, int32_t i, char out[32]) {
  c2d_status status = enter(s, kLegal);
  if (status == C2D_OK) status = check_pointers(s, {{"out", out}});
  const char* const place = status == C2D_OK ? find_name(s, kind, i, status) : nullptr;
  if (place != nullptr) memcpy(out, place, kRoom);
  return status;
}
