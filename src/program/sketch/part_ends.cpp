#include "program/sketch/part_ends.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kAtEnd = 1e-9;    // of a chain
constexpr double kSmooth = 0.35;   // radians: a surface that turns less continues smoothly
constexpr double kInclined = 0.87; // radians: 50 degrees, less the tolerance of the bisection that finds this limit

std::string place(Point p) { return "(" + rounded(p.x) + ", " + rounded(p.y) + ")"; }

// The message where a chain ends but the outline continues smoothly along a curve that the side does not include; else empty.
std::string beyond(const Sketch& sketch, const Chain& chain, bool at_begin) {
  const Body& body = sketch.bodies[static_cast<size_t>(chain.body())];
  const Outline& outline = body.outlines[chain.outline()];
  const Curve& own = at_begin ? *chain.curves().front() : *chain.curves().back();
  const size_t n = outline.curves.size(), index = static_cast<size_t>(&own - outline.curves.data());
  if (outline.open && index == (at_begin ? 0 : n - 1)) return "";
  const Curve& next = outline.curves[(index + (at_begin ? n - 1 : 1)) % n];
  const double turn = at_begin ? angle_between(next.shape->tangent(1), own.shape->tangent(0))
                               : angle_between(own.shape->tangent(1), next.shape->tangent(0));
  if (std::fabs(turn) > kSmooth) return "";
  return body.name + "." + own.name + " ends at " + place(own.shape->at(at_begin ? 0 : 1)) + ", but " + body.name + "." +
         next.name + " continues it smoothly: add this curve to the side";
}

// Does a corner between two curves of a chain lie at this length? Beyond a corner the surface may be too inclined to face.
bool has_corner(const Chain& chain, double length) {
  const std::vector<const Curve*>& curves = chain.curves();
  for (size_t k = chain.closed() ? 0 : 1; k < curves.size(); ++k) {
    const Curve &before = *curves[(k + curves.size() - 1) % curves.size()], &next = *curves[k];
    if (std::fabs(chain.way(chain.joints()[k], length)) <= kAtEnd * chain.length() &&
        angle_between(before.shape->tangent(1), next.shape->tangent(0)) > kSmooth)
      return true;
  }
  return false;
}

} // namespace

std::string end_of_part(const Sketch& sketch, const FacingRun& run, bool last) {
  if (run.ring) return "";
  const FacingPoints& p = last ? run.points.back() : run.points.front();
  bool ends = false;
  for (size_t side = 0; side < 2; ++side) {
    const Chain& chain = *run.chain[side];
    const double near = kAtEnd * chain.length();
    if (has_corner(chain, p.length[side])) return "";
    const bool at_begin = p.length[side] - chain.begin() <= near, at_end = chain.end() - p.length[side] <= near;
    if (chain.closed() || (!at_begin && !at_end)) continue;
    ends = true;
    if (std::string text = beyond(sketch, chain, at_begin); !text.empty()) return text;
  }
  if (ends) return "";
  const bool inclined = std::fabs(angle_between(p.normal[0], -1.0 * p.normal[1])) > kInclined;
  return "beyond " + place(p.at) +
         (inclined ? " the surfaces are inclined to each other by more than 50 degrees"
                   : " another curve lies between the surfaces or is nearer");
}

} // namespace sketch
