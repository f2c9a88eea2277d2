#include "post/zone_line.hpp"
#include "report/drawn/scene.hpp"
#include "report/drawn/surface.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// Position of a functional node, and whether its displacement is prescribed.
Point place_of_node(const BodyScene& body, size_t node, bool& supported) {
  Point place;
  for (size_t i = 0; i < body.nodes.size(); ++i) {
    if (static_cast<size_t>(body.nodes[i]) != node) continue;
    place = body.ends[i];
    supported = supported || body.conditions[i].known(2) || body.conditions[i].known(3);
  }
  return place;
}

// The pairs in the order of s, and beyond the line of symmetry their images.
void make_samples(const Scene& scene, ZoneScene& zone) {
  const PairScene& origin = scene.pairs[zone.origin];
  zone.has_images = origin.image_line != 0;
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) {
    zone.samples.push_back({p, scene.pairs[p].s, 1.0});
    if (zone.has_images && p != zone.origin) zone.samples.push_back({p, 2.0 * origin.s - scene.pairs[p].s, -1.0});
  }
  std::stable_sort(zone.samples.begin(), zone.samples.end(),
                   [](const ZoneSample& a, const ZoneSample& b) { return a.s < b.s; });
}

// A zone that nowhere rises more than a third is shown over the coordinate itself, which readers find in every table.
void take_coordinate(PairScene* p, ZoneScene& zone, bool steep) {
  constexpr double kMostSlope = 1.0 / 3.0;
  const auto along = [steep](Point at) { return steep ? at.y : at.x; };
  const auto across = [steep](Point at) { return steep ? at.x : at.y; };
  const double way = along(p[zone.pairs - 1].on[0]) - along(p[0].on[0]);
  for (size_t i = 1; i < zone.pairs; ++i) {
    const double step = (along(p[i].on[0]) - along(p[i - 1].on[0])) * (way > 0.0 ? 1.0 : -1.0);
    if (!(step > 0.0) || std::fabs(across(p[i].on[0]) - across(p[i - 1].on[0])) > kMostSlope * step) return;
  }
  zone.position = steep ? "y" : "x";
  for (size_t i = 0; i < zone.pairs; ++i) p[i].s = along(p[i].on[0]);
}

// s along side 1, chord by chord, from the zone's origin; towards larger x, in a steep zone towards larger y.
void measure(Scene& scene, ZoneScene& zone) {
  if (zone.pairs == 0) return;
  PairScene* p = scene.pairs.data() + zone.first;
  const size_t last = zone.pairs - 1;
  p[0].s = 0.0;
  for (size_t i = 1; i <= last; ++i)
    p[i].s = p[i - 1].s + std::hypot(p[i].on[0].x - p[i - 1].on[0].x, p[i].on[0].y - p[i - 1].on[0].y);
  const Point a = p[0].on[0], b = p[last].on[0];
  const bool steep = std::fabs(b.y - a.y) > 1.001 * std::fabs(b.x - a.x);
  const bool reversed = steep ? b.y < a.y : b.x < a.x;
  const bool at_first = p[0].symmetric, at_last = p[last].symmetric;
  size_t origin = reversed ? last : 0;
  if (at_first != at_last) origin = at_first ? 0 : last;
  zone.symmetric_origin = at_first != at_last || p[origin].image_line != 0;
  zone.origin = zone.first + origin;
  const double from = p[origin].s, sign = reversed ? -1.0 : 1.0;
  for (size_t i = 0; i <= last; ++i) p[i].s = sign * (p[i].s - from) + 0.0;
  take_coordinate(p, zone, steep);
  const double length = std::fabs(p[last].s - p[0].s);
  for (size_t i = 0; i <= last; ++i) p[i].s = told_place(p[i].s, length);
  make_samples(scene, zone);
}

struct PairFields {
  std::vector<double> node[2], x, y, zone;
};

c2d_status get_pairs(const Scene& scene, PairFields& out) {
  const auto get = [&](int32_t field, std::vector<double>& values) {
    values.resize(static_cast<size_t>(scene.summary.pairs));
    return c2d_get(scene.solver, field, 1, 1, scene.summary.pairs, values.data(), 1);
  };
  c2d_status status = get(C2D_PAIR_NODE1, out.node[0]);
  if (status == C2D_OK) status = get(C2D_PAIR_NODE2, out.node[1]);
  if (status == C2D_OK) status = get(C2D_X, out.x);
  if (status == C2D_OK) status = get(C2D_Y, out.y);
  if (status == C2D_OK) status = get(C2D_PAIR_ZONE, out.zone);
  return status;
}

} // namespace

int image_line_at(const Summary& s, Point p) {
  const double near = 1e-9 * (std::fabs(p.x) + std::fabs(p.y));
  if ((s.symmetry & 1) != 0 && std::fabs(p.x - s.symmetry_at[0]) <= near) return 1;
  if ((s.symmetry & 2) != 0 && std::fabs(p.y - s.symmetry_at[1]) <= near) return 2;
  return 0;
}

std::vector<Image> images_of(const Scene& scene, const ZoneScene& zone) {
  bool across[2] = {false, false}; // the lines x = ..., y = ...
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p)
    if (scene.pairs[p].image_line > 0) across[scene.pairs[p].image_line - 1] = true;
  std::vector<Image> out;
  for (const Image& image : scene.images)
    if ((across[0] || image.turn.x > 0.0) && (across[1] || image.turn.y > 0.0)) out.push_back(image);
  return out;
}

c2d_status gather_zones(Scene& scene) {
  if (scene.summary.pairs == 0) return C2D_OK;
  PairFields fields;
  if (const c2d_status status = get_pairs(scene, fields); status != C2D_OK) return status;
  for (const c2d_zone& zone : scene.summary.zone) {
    ZoneScene out;
    out.body[0] = zone.side1.body, out.body[1] = zone.side2.body;
    out.tied = (zone.kind & C2D_ZONE_TIED) != 0;
    out.free = (zone.kind & C2D_ZONE_FREE) != 0;
    scene.zones.push_back(out);
  }
  for (size_t p = 0; p < fields.zone.size(); ++p) {
    PairScene pair{static_cast<int32_t>(fields.zone[p]), {}, 0.0, false, 0};
    const size_t z = static_cast<size_t>(pair.zone) - 1;
    for (size_t side = 0; side < 2; ++side) {
      const BodyScene& body = scene.bodies[static_cast<size_t>(scene.zones[z].body[side]) - 1];
      pair.on[side] = place_of_node(body, static_cast<size_t>(fields.node[side][p]), pair.symmetric);
    }
    pair.on[0] = {fields.x[p], fields.y[p]}; // in free zones no node lies there
    pair.image_line = image_line_at(scene.summary, pair.on[0]);
    pair.symmetric = pair.symmetric || pair.image_line != 0;
    const c2d_zone& sides = scene.summary.zone[z];
    for (size_t side = 0; side < 2; ++side) {
      const BodyScene& body = scene.bodies[static_cast<size_t>(scene.zones[z].body[side]) - 1];
      const SurfacePoint here = surface_at(body, side == 0 ? sides.side1 : sides.side2, pair.on[side]);
      pair.moved[side] = here.moved;
      if (side == 0) pair.normal = here.normal;
    }
    scene.pairs.push_back(pair);
    if (scene.zones[z].pairs++ == 0) scene.zones[z].first = p;
  }
  for (ZoneScene& z : scene.zones) measure(scene, z);
  return C2D_OK;
}

} // namespace app
