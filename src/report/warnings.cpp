#include "report/warnings.hpp"

#include <algorithm>

namespace app {
namespace {

// The part of the results to which a warning refers.
enum class Weight { kAll, kContact, kMesh, kPlace };

Weight weight_of(int32_t kind) {
  switch (kind) {
  case C2D_WARN_ZONE_END:
  case C2D_WARN_LARGE_SLIP:
  case C2D_WARN_LEFT_OUT:
  case C2D_WARN_OVERLAP:
  case C2D_WARN_STRAIN:
  case C2D_WARN_FRICTION:
  case C2D_WARN_FAR:
  case C2D_WARN_BETWEEN:
  case C2D_WARN_OVERLAPPING:
  case C2D_WARN_SIDEWAYS:
  case C2D_WARN_ROTATION:
  case C2D_WARN_SURFACE: return Weight::kContact;
  case C2D_WARN_FEW_PAIRS:
  case C2D_WARN_NORMALS:
  case C2D_WARN_KINK:
  case C2D_WARN_TENSION:
  case C2D_WARN_OFFSET:
  case C2D_WARN_SHIFTED:
  case C2D_WARN_CONSTANT:
  case C2D_WARN_SLIT:
  case C2D_WARN_SIZES: return Weight::kMesh;
  case C2D_WARN_POINT_LOAD:
  case C2D_WARN_CORNER:
  case C2D_WARN_TIE_END: return Weight::kPlace;
  default: return Weight::kAll; // residuals, energies, solutions that are not unique
  }
}

bool goes_before(const c2d_error& a, const c2d_error& b) {
  const Weight first = weight_of(a.status), second = weight_of(b.status);
  return first != second ? first < second : a.status < b.status;
}

} // namespace

void order_warnings(std::vector<c2d_error>& warnings) { std::stable_sort(warnings.begin(), warnings.end(), goes_before); }

} // namespace app
