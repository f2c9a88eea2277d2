#include "program/families/shapes.hpp"

#include <charconv>
#include <cmath>

namespace families {

double first_size(const std::vector<double>& s) { return s[1] - s[0]; }
double last_size(const std::vector<double>& s) { return s.back() - s[s.size() - 2]; }

std::vector<double> mirrored(const std::vector<double>& s) {
  std::vector<double> out;
  for (auto at = s.rbegin(); at != s.rend(); ++at) out.push_back(s.back() - *at);
  for (size_t i = 1; i < s.size(); ++i) out.push_back(s.back() + s[i]);
  return out;
}

std::string show(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr);
}

Outline half_block(const BlockMesh& m) {
  const double w = m.zone.back(), size = m.size, coarse = size / 4;
  Outline out({0, -size});
  out.line({size, -size}, graded(size, 0, 0, m.ratio, coarse), roller_y());
  out.line({size, 0}, graded(size, 0, 0, m.ratio, coarse));
  out.line({w, 0}, graded(size - w, 0, last_size(m.zone), m.ratio, coarse));
  out.line({0, 0}, reversed(m.zone));
  out.axis_x({0, -size}, graded(size, first_size(m.zone), 0, m.ratio, coarse));
  return out;
}

Outline whole_block(const BlockMesh& m) {
  const double w = m.zone.back(), size = m.size, coarse = size / 4;
  Outline out({-size, -size});
  out.line({size, -size}, graded(2 * size, 0, 0, m.ratio, coarse), clamped());
  out.line({size, 0}, graded(size, 0, 0, m.ratio, coarse));
  out.line({w, 0}, graded(size - w, 0, last_size(m.zone), m.ratio, coarse));
  out.line({-w, 0}, mirrored(m.zone));
  out.line({-size, 0}, graded(size - w, last_size(m.zone), 0, m.ratio, coarse));
  out.line({-size, -size}, graded(size, 0, 0, m.ratio, coarse));
  return out;
}

namespace {

const double kDegrees = 180.0 / std::acos(-1.0);

// Angles in degrees from the lowest point of nodes at the distances x from the axis.
std::vector<double> angles(const std::vector<double>& x, double radius) {
  std::vector<double> out;
  for (const double at : x) out.push_back(std::asin(at / radius) * kDegrees);
  return out;
}

} // namespace

// The angle at the end of every run is one that the cards tell exactly: those between are generated from it. Rounded
// angles would show in the pressure, as gaps of 1e-8 of the radius do.
std::vector<double> cylinder_zone(double radius, const std::vector<ZoneRun>& runs) {
  std::vector<double> out{0.0};
  double from = 0, reached = 0;
  for (const ZoneRun& run : runs) {
    reached += run.size * run.elements;
    const double to = std::asin(reached / radius) * kDegrees;
    for (int i = 1; i <= run.elements; ++i)
      out.push_back(radius * std::sin((from + (to - from) * i / run.elements) / kDegrees));
    from = to;
  }
  return out;
}

Outline half_cylinder(const std::vector<double>& zone, double radius, double ratio, const Condition& top) {
  const std::vector<double> angle = angles(zone, radius);
  const double edge = angle.back(), coarse = radius / 6;
  Outline out({0, 0});
  out.arc({0, radius}, radius, -90, edge - 90, angle);
  out.arc({0, radius}, radius, edge - 90, 0, graded((90 - edge) / kDegrees * radius, last_size(zone), 0, ratio, coarse));
  out.line({0, radius}, graded(radius, 0, 0, ratio, coarse), top);
  out.axis_x({0, 0}, graded(radius, 0, first_size(zone), ratio, coarse));
  return out;
}

Outline whole_cylinder_arcs(const std::vector<double>& zone, double radius, double ratio) {
  const std::vector<double> angle = angles(zone, radius);
  const double edge = angle.back(), coarse = radius / 6;
  const std::vector<double> outside = graded((90 - edge) / kDegrees * radius, last_size(zone), 0, ratio, coarse);
  Outline out({-radius, radius});
  out.arc({0, radius}, radius, -180, -90 - edge, reversed(outside));
  out.arc({0, radius}, radius, -90 - edge, -90 + edge, mirrored(angle));
  out.arc({0, radius}, radius, -90 + edge, 0, outside);
  return out;
}

} // namespace families
