// Is everything there, and are the numbers numbers? The other checks rely on what is found here.
#include "model/validate.hpp"
#include "model/validate_finding.hpp"

#include <math.h>
#include <string.h>

namespace c2d {

bool is_usable(double number) {
  // By its bits: comparing with a signalling or quiet NaN may trap.
  uint64_t pattern;
  memcpy(&pattern, &number, sizeof pattern);
  if ((pattern >> 52 & 0x7ff) == 0x7ff) return false;
  return fabs(number) <= 1e100;
}

namespace {

constexpr const char* kNumber = ", expected a finite number of at most 1e100";

bool is_infinity(double number) {
  uint64_t pattern;
  memcpy(&pattern, &number, sizeof pattern);
  return pattern == uint64_t{0x7ff} << 52;
}

void check_material(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  if (!is_usable(body.youngs_modulus) || !(body.youngs_modulus >= 1e-100)) {
    Finding f = fault();
    f.entry.body = b + 1;
    say(f, "Young's modulus of body ", b + 1, " is ", body.youngs_modulus, ", expected a positive number");
    tell(reporter, f);
  }
  const bool stress = m.head->plane == C2D_PLANE_STRESS;
  const double nu = body.poisson_ratio, lowest = stress ? -0.5 : -1;
  if (!is_usable(nu) || !(nu > lowest && nu <= 0.5)) {
    Finding f = fault();
    f.entry.body = b + 1;
    say(f, "Poisson's ratio of body ", b + 1, " is ", nu, ", expected more than ", lowest, " and at most 0.5",
        stress ? " in plane stress" : "");
    tell(reporter, f);
  }
}

void tell_region(const Model& m, int b, int32_t region, const char* found, int32_t number, const char* expected, int32_t wanted,
                 Reporter& reporter) {
  Finding f = fault();
  f.entry.body = b + 1;
  if (region < body_of(m, b).region_count) f.entry.element = m.region[b][region].first + 1;
  say(f, "region ", region + 1, " of body ", b + 1, found, number, expected, wanted);
  tell(reporter, f);
}

void check_regions(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  if (body.region_count != body.regions) {
    Finding f = fault();
    f.entry.body = b + 1;
    say(f, "body ", b + 1, " has ", body.region_count, " regions, expected ", body.regions);
    return tell(reporter, f);
  }
  int32_t next = 0;
  for (int32_t r = 0; r < body.regions; ++r) {
    const Region& region = m.region[b][r];
    const int32_t least = region.open ? 1 : (body.element_nodes == 2 ? 3 : 2);
    if (kOnceMore && region.first != next)
      tell_region(m, b, r, " begins with element ", region.first + 1, ", expected ", next + 1, reporter);
    if (kOnceMore && region.last >= body.elements)
      tell_region(m, b, r, " ends with element ", region.last + 1, ", expected at most ", body.elements, reporter);
    if (region.last - region.first + 1 < least)
      tell_region(m, b, r, " has elements: ", region.last - region.first + 1, ", a closed curve needs at least ", least,
                  reporter);
    next = region.last + 1;
  }
  if (kOnceMore && next < body.elements)
    tell_region(m, b, body.regions - 1, " ends with element ", next, ", expected the body's last element ", body.elements,
                reporter);
}

void check_points(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  for (int32_t i = 0; i < body.geometry_nodes; ++i) {
    if (m.node_line[b][i] == -1) {
      int32_t last = i; // one fault for a run of missing points
      while (last + 1 < body.geometry_nodes && m.node_line[b][last + 1] == -1) ++last;
      Finding f = fault();
      locate_point(f, m, b, i);
      say(f, "body ", b + 1, ": boundary point ", i + 1);
      if (last > i) say(f, " to ", last + 1);
      say(f, last > i ? " have no coordinates" : " has no coordinates");
      tell(reporter, f);
      i = last;
      continue;
    }
    for (int c = 0; kOnceMore && c < 2; ++c) {
      const double number = m.xy[b][2 * i + c];
      if (is_usable(number)) continue;
      Finding f = fault();
      locate_point(f, m, b, i);
      say(f, c == 0 ? "x" : "y", " of boundary point ", i + 1, " is ", number, kNumber);
      tell(reporter, f);
    }
  }
}

// Prescribed values of all ends and nodes.
void check_values(const Model& m, int b, Reporter& reporter) {
  const int32_t f = m.head->function_nodes;
  const int64_t ends = int64_t{body_of(m, b).elements} * f, nodes = body_of(m, b).nodes;
  for (int64_t i = 0; i < 2 * ends * m.head->load_cases; ++i) {
    if (is_usable(m.end_traction[b][i])) continue;
    const int32_t end = static_cast<int32_t>(i / 2 % ends);
    Finding finding = fault();
    finding.entry.body = b + 1;
    finding.entry.element = end / f + 1;
    if (m.end_line[b][end] > 0) finding.entry.line = m.end_line[b][end];
    say(finding, i % 2 == 0 ? "tx" : "ty", " at end ", end % f + 1, " of element ", end / f + 1, " is ", m.end_traction[b][i],
        kNumber);
    tell(reporter, finding);
  }
  for (int64_t i = 0; i < 2 * nodes * m.head->load_cases; ++i) {
    if (is_usable(m.node_disp[b][i])) continue;
    const int32_t node = static_cast<int32_t>(i / 2 % nodes);
    Finding finding = fault();
    finding.entry.body = b + 1;
    finding.entry.node = node + 1;
    say(finding, i % 2 == 0 ? "ux" : "uy", " at node ", node + 1, " is ", m.node_disp[b][i], kNumber);
    tell(reporter, finding);
  }
}

void check_body(const Model& m, int b, Reporter& reporter) {
  const Body& body = body_of(m, b);
  if (body.is_set == 0) {
    Finding f = fault();
    f.entry.body = b + 1;
    say(f, "body ", b + 1, " is missing");
    return tell(reporter, f);
  }
  check_material(m, b, reporter);
  const int32_t before = reporter.faults;
  check_regions(m, b, reporter);
  if (reporter.faults != before) return;
  check_points(m, b, reporter);
  if (kOnceMore) check_values(m, b, reporter);
}

void check_friction(const Model& m, Reporter& reporter) {
  for (int32_t i = 0; kOnceMore && i < m.head->coefficients; ++i) {
    if (is_infinity(m.friction[i]) || (is_usable(m.friction[i]) && m.friction[i] >= 0)) continue;
    Finding f = fault();
    say(f, "coefficient of friction ", i + 1, " is ", m.friction[i], ", expected 0 or more");
    tell(reporter, f);
  }
}

void check_paths(const Model& m, Reporter& reporter) {
  for (int32_t i = 0; kOnceMore && i < m.head->paths; ++i) {
    if (m.path[i].increments < 1) {
      Finding f = fault();
      say(f, "load card ", i + 1, " has ", m.path[i].increments, " increments, expected at least 1");
      tell(reporter, f);
    }
    if (!is_usable(m.path[i].load)) {
      Finding f = fault();
      say(f, "load factor of load card ", i + 1, " is ", m.path[i].load, kNumber);
      tell(reporter, f);
    }
  }
  if (kOnceMore && m.head->iteration_limit < 0) {
    Finding f = fault();
    say(f, "iteration limit is ", m.head->iteration_limit, ", expected 1 or more (0: 50)");
    tell(reporter, f);
  }
}

void check_point_loads(const Model& m, Reporter& reporter) {
  for (int32_t i = 0; i < m.head->point_loads; ++i) {
    const PointLoad& p = m.point_load[i];
    const double numbers[4] = {p.x, p.y, p.fx, p.fy};
    constexpr const char* kNames[4] = {"x", "y", "fx", "fy"};
    for (int k = 0; k < 4; ++k) {
      if (is_usable(numbers[k])) continue;
      Finding f = fault();
      f.entry.body = p.body + 1;
      f.entry.line = p.line > 0 ? p.line : 0;
      say(f, kNames[k], " of point load ", i + 1, " is ", numbers[k], kNumber);
      tell(reporter, f);
    }
    if (p.body >= 0 && p.body < m.head->bodies && p.load_case >= 0 && p.load_case < m.head->load_cases) continue;
    Finding f = fault();
    f.entry.line = p.line > 0 ? p.line : 0;
    say(f, "point load ", i + 1, " is on body ", p.body + 1, " in load case ", p.load_case + 1, ", there are ", m.head->bodies,
        " bodies and ", m.head->load_cases, " load cases");
    tell(reporter, f);
  }
}

// One value on an element cannot follow a displacement that is linear along it, whatever the integrals: the patch test is
// missed by as much on any mesh of equal elements, and only the far field converges.
void warn_constant_functions(const Model& m, Reporter& reporter) {
  if (m.head->function_nodes != 1) return;
  Finding f = warning(C2D_WARN_CONSTANT);
  say(f, "1 functional node per element: constant functions miss even a uniform stress, by 3 to 20 % near the boundary; "
         "with 2 (linear functions) it is exact");
  tell(reporter, f);
}

} // namespace

bool validate_data(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int b = 0; b < m.head->bodies; ++b) check_body(m, b, reporter);
  if (kOnceMore) check_point_loads(m, reporter);
  check_friction(m, reporter);
  check_paths(m, reporter);
  warn_constant_functions(m, reporter);
  return reporter.faults == before;
}

} // namespace c2d
