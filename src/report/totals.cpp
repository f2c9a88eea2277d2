#include "report/totals.hpp"
#include "report/text.hpp"

namespace app {
namespace {

// A force and its moment about the origin, with those of the image across the line x = at (axis 0) or y = at.
void add_image(double (&force)[3], int axis, double at) {
  const int along = 1 - axis;
  force[axis] = 0;
  force[along] *= 2;
  force[2] = (axis == 0 ? at : -at) * force[along]; // the moments of both about a point of the line cancel
}

} // namespace

int32_t lines_that_cut(const Summary& s, int32_t body) {
  const size_t i = static_cast<size_t>(body) - 1;
  return i < s.cut.size() ? s.cut[i] : 0;
}

BodyTotal whole_of(const Summary& s, int32_t body, const double (&part)[3], const std::string& of) {
  BodyTotal out{"whole: " + of, {part[0], part[1], part[2]}};
  for (int axis = 0; axis < 2; ++axis)
    if ((lines_that_cut(s, body) >> axis & 1) != 0) add_image(out.force, axis, s.symmetry_at[axis]);
  return out;
}

std::vector<BodyTotal> totals_of(const Summary& s, int32_t body) {
  const c2d_body_result& b = s.body[body - 1];
  const int32_t lines = lines_that_cut(s, body);
  std::vector<BodyTotal> out = {{"loads and supports", {b.applied[0], b.applied[1], b.applied[2]}}};
  if (s.pairs > 0) out.push_back({"contact", {b.contact[0], b.contact[1], b.contact[2]}});
  double sum[3];
  for (int k = 0; k < 3; ++k) sum[k] = b.applied[k] + b.contact[k];
  if (lines == 0) {
    out.push_back({"sum", {sum[0], sum[1], sum[2]}, true});
    return out;
  }
  // A line carries what is normal to it, and moments.
  const double normal[2] = {(lines & 1) != 0 ? sum[0] : 0, (lines & 2) != 0 ? sum[1] : 0};
  out.push_back({"lines of symmetry", {-normal[0], -normal[1], -sum[2]}});
  out.push_back(whole_of(s, body, b.applied, "loads and supports"));
  if (s.pairs > 0) out.push_back(whole_of(s, body, b.contact, "contact"));
  out.push_back(whole_of(s, body, sum, "sum"));
  out.back().is_sum = true;
  return out;
}

std::vector<TableNumber> with_wholes(const std::vector<Quantity>& all, const Summary& s) {
  std::vector<TableNumber> out;
  for (const Quantity& q : all) {
    out.push_back({q, ""});
    const int k = q.what == Measure::kForceX ? 0 : q.what == Measure::kForceY ? 1 : -1;
    if (k < 0 || q.zone <= 0 || static_cast<size_t>(q.zone) > s.zone.size()) continue;
    const int32_t body = s.zone[static_cast<size_t>(q.zone) - 1].side2.body;
    const int32_t lines = lines_that_cut(s, body);
    if (lines == 0 || (lines >> k & 1) != 0) continue; // what is normal to a line has an opposite image
    double part[3] = {0, 0, 0}, error[3] = {0, 0, 0};
    part[k] = q.value, error[k] = q.error;
    Quantity whole = q;
    whole.value = whole_of(s, body, part).force[k];
    whole.error = whole_of(s, body, error).force[k];
    out.push_back({whole, ", whole"});
  }
  return out;
}

std::string whose_forces(const Summary& s) {
  std::string out = s.plane == C2D_AXISYMMETRIC ? "of the whole circumference" : "";
  if (mirror_lines(s) != 0) out += out.empty() ? "of the modelled part" : " of the modelled part";
  return out;
}

const char* words_of_totals(const Summary& s) {
  return mirror_lines(s) == 0 ? ""
                              : "totals of a body that a line of symmetry cuts cover the modelled part, whose balance the line "
                                "completes; \"whole\": with the images of the part";
}

} // namespace app
