// Completeness of the data and usable numbers. All other checks rely on it, so it runs first.
#include "memory/math.hpp"
#include "model/validate/validate.hpp"
#include "model/validate/validate_finding.hpp"

#include <string.h>

namespace c2d {

bool is_usable(double number) {
  // By its bits: a comparison with a NaN may trap on hosts that enable floating-point exceptions.
  uint64_t pattern;
  memcpy(&pattern, &number, sizeof pattern);
  if ((pattern >> 52 & 0x7ff) == 0x7ff) return false;
  return fabs(number) <= 1e100;
}

namespace {

void check_material(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  if (!is_usable(body.youngs_modulus) || !(body.youngs_modulus >= 1e-100))
    report(reporter, in_body(b), "Young's modulus of body ", body_named(m, b), " is ", body.youngs_modulus,
           ", expected a positive number");
  const bool stress = m.head->plane == C2D_PLANE_STRESS;
  const double nu = body.poisson_ratio, lowest = stress ? -0.5 : -1;
  if (!is_usable(nu) || !(nu > lowest && nu <= 0.5))
    report(reporter, in_body(b), "Poisson's ratio of body ", body_named(m, b), " is ", nu, ", expected more than ", lowest,
           " and at most 0.5", stress ? " in plane stress" : "");
}

void report_region(const Model& m, int b, int32_t region, const char* found, int32_t number, const char* expected,
                   int32_t wanted, Reporter& reporter) {
  Where where = in_body(b);
  where.element = m.region[b][region].first + 1;
  report(reporter, where, "region ", region + 1, " of body ", body_named(m, b), found, number, expected, wanted);
}

void check_regions(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  if (body.region_count != body.regions)
    return report(reporter, in_body(b), "body ", body_named(m, b), " has ", body.region_count, " regions, expected ",
                  body.regions);
  for (int32_t r = 0; r < body.regions; ++r) {
    const Region& region = m.region[b][r];
    const int32_t least = region.open ? 1 : (body.element_nodes == 2 ? 3 : 2);
    if (region.last - region.first + 1 < least)
      report_region(m, b, r, " has elements: ", region.last - region.first + 1, ", expected for a closed curve at least ",
                    least, reporter);
  }
}

void check_points(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  for (int32_t i = 0; i < body.geometry_nodes; ++i) {
    if (m.node_line[b][i] != -1) continue;
    int32_t last = i; // one fault for a run of missing points
    while (last + 1 < body.geometry_nodes && m.node_line[b][last + 1] == -1) ++last;
    Finding f(at_point(m, b, i));
    say(f, "body ", body_named(m, b), ": boundary point ", i + 1);
    if (last > i) say(f, " to ", last + 1);
    say(f, last > i ? " have no coordinates" : " has no coordinates");
    report(reporter, f);
    i = last;
  }
}

void check_body(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  if (body.is_set == 0) return report(reporter, in_body(b), "body ", body_named(m, b), " is missing");
  if (is_platen(m, b)) return;
  check_material(m, b, reporter);
  const int32_t before = reporter.faults;
  check_regions(m, b, reporter);
  if (reporter.faults != before) return;
  check_points(m, b, reporter);
}

// A constant function cannot represent the linear displacement of a uniform stress: constant elements fail the patch test near
// the boundary by the same amount on any uniform mesh; only the far field converges.
void warn_constant_functions(const Model& m, Reporter& reporter) {
  if (m.head->function_nodes != 1) return;
  warn(reporter, C2D_WARN_CONSTANT, Where(),
       "1 functional node per element: with constant functions even a uniform stress is in error by 3 to 20 % near the "
       "boundary; use linear functions");
}

} // namespace

bool validate_data(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int b = 0; b < m.head->bodies; ++b) check_body(m, b, reporter);
  warn_constant_functions(m, reporter);
  return reporter.faults == before;
}

} // namespace c2d
