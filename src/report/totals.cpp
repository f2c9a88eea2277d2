#include "report/totals.hpp"
#include "report/text.hpp"

namespace app {
namespace {

// A force and its moment about the origin, with those of the image across the line x = at (axis 0) or y = at.
BodyTotal with_image(const std::string& of, const double (&part)[3], int axis, double at) {
  BodyTotal out{of, {0, 0, 0}};
  const int along = 1 - axis;
  out.force[along] = 2 * part[along];
  out.force[2] = (axis == 0 ? 2 : -2) * at * part[along]; // the moments of both about a point of the line cancel
  return out;
}

} // namespace

std::vector<BodyTotal> totals_of(const Summary& s, int32_t body) {
  const c2d_body_result& b = s.body[body - 1];
  const int32_t lines = mirror_lines(s);
  const bool cut = lines != 0 && b.open_regions > 0;
  std::vector<BodyTotal> out = {{"loads and supports", {b.applied[0], b.applied[1], b.applied[2]}}};
  if (s.pairs > 0) out.push_back({"contact", {b.contact[0], b.contact[1], b.contact[2]}});
  double sum[3];
  for (int k = 0; k < 3; ++k) sum[k] = b.applied[k] + b.contact[k];
  if (!cut) {
    out.push_back({"sum", {sum[0], sum[1], sum[2]}, true});
    return out;
  }
  out.push_back({"lines of symmetry", {-sum[0], -sum[1], -sum[2]}});
  if (lines == 3) return out; // which of them cut the body is not known here
  const int axis = lines == 1 ? 0 : 1;
  out.push_back(with_image("whole: loads and supports", b.applied, axis, s.symmetry_at[axis]));
  if (s.pairs > 0) out.push_back(with_image("whole: contact", b.contact, axis, s.symmetry_at[axis]));
  out.push_back(with_image("whole: sum", sum, axis, s.symmetry_at[axis]));
  out.back().is_sum = true;
  return out;
}

const char* words_of_totals(const Summary& s) {
  return mirror_lines(s) == 0 ? ""
                              : "totals of a body that a line of symmetry cuts cover the modelled part, whose balance the line "
                                "completes; \"whole\": with the image";
}

} // namespace app
