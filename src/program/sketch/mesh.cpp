// The first mesh of a sketch (Mesher::run). Phases:
// 1. Sample the wanted element size on every curve: curvature, outline size, corners (sample).
// 2. Reduce it in thin walls, near forces at points and in gaps between facing parts (thin_walls, point_loads, gaps).
// 3. Limit the growth of sizes along the outlines (spread).
// 4. Divide the curves, by sizes (divide) or by statements (give), and align facing sides (align).
#include "program/sketch/mesh.hpp"

#include "program/sketch/elements.hpp"
#include "program/sketch/refine.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

size_t MeshedOutline::elements() const {
  size_t count = 0;
  for (const MeshedCurve& curve : curves) count += curve.elements();
  return count;
}

namespace {

constexpr double kGrowth = 0.35;     // growth of the element size per length
constexpr double kTurn = 0.3;        // radians: largest turn of an element
constexpr double kCorner = 0.05;     // size at a corner, as a fraction of the shorter adjacent curve
constexpr double kThinWall = 0.7;    // size as a fraction of the wall thickness
constexpr double kLargest = 0.1;     // size as a fraction of the size of the outline
constexpr double kTouching = 2e-3;   // smallest size by gaps, as a fraction of the length of the shorter side
constexpr double kAlongSide = 0.025; // the same, as a fraction of the length already touching as drawn
constexpr double kTied = 0.08;       // size along a tie, as a fraction of its length
constexpr double kOfLoad = 0.2;      // size near a force at a point, as a fraction of its distance
constexpr int kSamplesOfSide = 160;  // samples of the size on a curve

// Element sizes wanted along a curve, sampled at equal steps of its length.
struct Sizes {
  std::vector<Point> at;
  std::vector<double> h;
  double step;
};

class Mesher {
public:
  Mesher(const Sketch& sketch, double fineness, bool given) : s_(sketch), fineness_(fineness) { mesh_.given = given; }
  Mesh run();

private:
  void sample(const MeshedOutline& outline);
  void thin_walls(size_t body);
  void point_loads(size_t body);
  void gaps(size_t contact);
  void spread(const MeshedOutline& outline, size_t first);
  void divide(MeshedCurve& curve, const Sizes& sizes) const;
  void give(int body, MeshedOutline& outline) const;

  const Sketch& s_;
  double fineness_;
  std::vector<Sizes> sizes_; // of all curves, in the order of the mesh
  Mesh mesh_;
};

double turn_between(const Shape& a, const Shape& b) {
  const Point p = a.tangent(1), q = b.tangent(0);
  return std::fabs(std::atan2(cross(p, q), dot(p, q)));
}

// Sizes from curvature, the size of the outline, and corners.
void Mesher::sample(const MeshedOutline& outline) {
  Outline drawn;
  for (const MeshedCurve& curve : outline.curves) drawn.curves.push_back(*curve.curve);
  drawn.open = outline.open;
  const double largest = kLargest * size_of(polygon_of(drawn));
  const size_t first = sizes_.size(), n = outline.curves.size();
  for (const MeshedCurve& curve : outline.curves) {
    const double length = curve.measure.length();
    const int samples = kSamplesOfSide + 4 * curve.curve->shape->pieces();
    Sizes sizes{{}, {}, length / samples};
    for (int i = 0; i <= samples; ++i) {
      const double u = curve.measure.u_at(length * i / samples);
      sizes.at.push_back(curve.curve->shape->at(u));
      const double bend = std::fabs(curve.curve->shape->curvature(u));
      sizes.h.push_back(std::min({largest, length / 2, bend > 0 ? kTurn / bend : largest}));
    }
    sizes_.push_back(sizes);
  }
  for (size_t i = 0; i < n; ++i) { // the corner at the end of each curve
    if (outline.open && i + 1 == n) break;
    const size_t next = (i + 1) % n;
    const MeshedCurve &a = outline.curves[i], &b = outline.curves[next];
    if (turn_between(*a.curve->shape, *b.curve->shape) < 0.2) continue;
    const double h = kCorner * std::min(a.measure.length(), b.measure.length());
    sizes_[first + i].h.back() = std::min(sizes_[first + i].h.back(), h);
    sizes_[first + next].h.front() = std::min(sizes_[first + next].h.front(), h);
  }
}

// Limits the growth of sizes along the outline to kGrowth, in both directions.
void Mesher::spread(const MeshedOutline& outline, size_t first) {
  const size_t n = outline.curves.size();
  for (int round = 0; round < 2; ++round) {
    double h = HUGE_VAL;
    for (size_t i = 0; i < 2 * n; ++i) {
      if (outline.open && i % n == 0) h = HUGE_VAL;
      Sizes& s = sizes_[first + i % n];
      for (size_t k = 0; k < s.h.size(); ++k) h = s.h[k] = std::min(s.h[k], k == 0 ? h : h + kGrowth * s.step);
    }
    h = HUGE_VAL;
    for (size_t i = 2 * n; i-- > 0;) {
      if (outline.open && i % n == n - 1) h = HUGE_VAL;
      Sizes& s = sizes_[first + i % n];
      for (size_t k = s.h.size(); k-- > 0;) h = s.h[k] = std::min(s.h[k], k + 1 == s.h.size() ? h : h + kGrowth * s.step);
    }
  }
}

// Reduces sizes in thin walls: distance through the material along the inner normal.
void Mesher::thin_walls(size_t body) {
  size_t first = 0;
  for (size_t b = 0; b < body; ++b)
    for (const MeshedOutline& outline : mesh_.bodies[b]) first += outline.curves.size();
  size_t count = 0;
  for (const MeshedOutline& outline : mesh_.bodies[body]) count += outline.curves.size();
  std::vector<std::pair<Point, Point>> walls;
  for (size_t c = first; c < first + count; ++c)
    for (size_t k = 0; k + 1 < sizes_[c].at.size(); k += 4)
      walls.push_back({sizes_[c].at[k], sizes_[c].at[std::min(k + 4, sizes_[c].at.size() - 1)]});
  for (size_t c = first; c < first + count; ++c) {
    Sizes& s = sizes_[c];
    for (size_t k = 2; k + 2 < s.at.size(); k += 4) {
      const Point normal = turned_left(s.at[k + 1] - s.at[k - 1]);
      const double speed = length(normal);
      for (const auto& [p, q] : walls) {
        const Point d = q - p, off = p - s.at[k];
        const double det = cross(normal, d);
        if (det == 0) continue;
        const double away = cross(off, d) / det * speed, along = cross(off, normal) / det;
        if (away > 2 * s.step && along >= 0 && along <= 1) s.h[k] = std::min(s.h[k], kThinWall * away);
      }
    }
  }
}

// Reduces sizes near forces at interior points.
void Mesher::point_loads(size_t body) {
  size_t curve = 0;
  for (size_t b = 0; b < body; ++b)
    for (const MeshedOutline& outline : mesh_.bodies[b]) curve += outline.curves.size();
  for (const MeshedOutline& outline : mesh_.bodies[body])
    for (size_t i = 0; i < outline.curves.size(); ++i, ++curve)
      for (const PointLoad& load : s_.point_loads)
        for (size_t k = 0; k < sizes_[curve].at.size() && load.body == static_cast<int>(body); ++k)
          sizes_[curve].h[k] = std::min(sizes_[curve].h[k], kOfLoad * length(load.where - sizes_[curve].at[k]));
}

// Reduces sizes where facing surfaces are close, to resolve the opening of the gap.
void Mesher::gaps(size_t contact) {
  const bool tied = s_.interfaces[s_.contacts[contact].interface].tied;
  std::vector<size_t> sides[2];
  size_t index = 0;
  for (const auto& outlines : mesh_.bodies)
    for (const MeshedOutline& outline : outlines)
      for (const MeshedCurve& curve : outline.curves) {
        if (curve.curve->contact == static_cast<int>(contact)) sides[curve.curve->side].push_back(index);
        ++index;
      }
  double whole = HUGE_VAL; // the length of the shorter side
  for (const auto& side : sides) {
    double length = 0;
    for (const size_t c : side) length += sizes_[c].step * static_cast<double>(sizes_[c].h.size() - 1);
    whole = std::min(whole, length);
  }
  const auto nearest = [&](int side, Point p, double& size) { // the gap to the other side and the size there
    double gap = HUGE_VAL;
    for (const size_t o : sides[1 - side])
      for (size_t j = 0; j < sizes_[o].at.size(); ++j)
        if (const double d = length(sizes_[o].at[j] - p); d < gap) gap = d, size = sizes_[o].h[j];
    return gap;
  };
  double unused = 0, touching = 0; // length of side 1 that touches side 0 as drawn
  for (const size_t c : sides[1])
    for (const Point& p : sizes_[c].at) touching += nearest(1, p, unused) < sizes_[c].step ? sizes_[c].step : 0;
  const double least = std::max(kTouching * whole, kAlongSide * touching);
  for (int round = 0; round < 2; ++round) // first by gaps, then by the elements opposite
    for (int side = 0; side < 2; ++side)
      for (const size_t c : sides[side])
        for (size_t k = 0; k < sizes_[c].at.size(); ++k) {
          double other = 0;
          const double gap = nearest(side, sizes_[c].at[k], other);
          const double own = tied ? kTied * whole : std::max(least, kGrowth * std::sqrt(gap * whole));
          sizes_[c].h[k] = std::min(sizes_[c].h[k], round == 0 ? own : other + kGrowth * gap);
        }
}

// The number of elements is the integral of 1 / h, rounded up; each element has an equal share of the integral.
void Mesher::divide(MeshedCurve& curve, const Sizes& sizes) const {
  std::vector<double> sum(1, 0);
  for (size_t k = 1; k < sizes.h.size(); ++k)
    sum.push_back(sum.back() + fineness_ * sizes.step * 2 / (sizes.h[k - 1] + sizes.h[k]));
  const int n = std::max(2, static_cast<int>(std::ceil(sum.back() - 1e-9)));
  curve.ends.assign(1, 0);
  for (int i = 1; i < n; ++i) {
    const double count = sum.back() * i / n;
    const size_t k = static_cast<size_t>(std::upper_bound(sum.begin(), sum.end(), count) - sum.begin());
    curve.ends.push_back(sizes.step * (static_cast<double>(k) - 1 + (count - sum[k - 1]) / (sum[k] - sum[k - 1])));
  }
  curve.ends.push_back(curve.measure.length());
}

// Elements from statements. If a drawn curve has been cut, its element ends are distributed to the pieces.
void Mesher::give(int body, MeshedOutline& outline) const {
  std::vector<MeshedCurve>& curves = outline.curves;
  for (size_t first = 0, next; first < curves.size(); first = next) {
    double whole = 0;
    for (next = first; next < curves.size() && (next == first || !curves[next].curve->is_first); ++next)
      whole += curves[next].measure.length();
    const Division* const division = division_of(s_, body, *curves[first].curve);
    if (division == nullptr) continue;
    const std::vector<double> ends = divided_ends(*division, whole);
    double begin = 0;
    for (size_t i = first; i < next; ++i) {
      const double length = curves[i].measure.length(), near = next - first > 1 ? 1e-9 * whole : 0;
      curves[i].ends.assign(1, 0.0);
      for (const double end : ends)
        if (end > begin + near && end < begin + length - near) curves[i].ends.push_back(end - begin);
      curves[i].ends.push_back(length);
      curves[i].given = true;
      begin += length;
    }
  }
}

// Do curves of a body belong to one side of a contact, or to a platen?
bool are_on_one_side(const Sketch& s, int body, const Curve& a, const Curve& b) {
  const auto on = [&](const Drive& d) { return d.side && d.side->body == body && d.side->has(a.name) && d.side->has(b.name); };
  return (a.contact >= 0 && a.contact == b.contact && a.side == b.side) || std::any_of(s.drives.begin(), s.drives.end(), on);
}

// The curves of an outline. A closed outline starts between two sides, so that the elements of a side have consecutive numbers.
std::vector<const Curve*> curves_in_order(const Sketch& s, int body, const Outline& outline) {
  const size_t n = outline.curves.size();
  size_t first = 0;
  while (!outline.open && first < n && are_on_one_side(s, body, outline.curves[(first + n - 1) % n], outline.curves[first]))
    ++first;
  std::vector<const Curve*> out;
  for (size_t i = 0; i < n; ++i) out.push_back(&outline.curves[(first + i) % n]);
  return out;
}

Mesh Mesher::run() {
  for (const Body& body : s_.bodies) {
    std::vector<MeshedOutline> outlines;
    for (const bool open : {true, false})
      for (const Outline& outline : body.outlines) {
        if (outline.open != open) continue;
        outlines.push_back({open, {}});
        for (const Curve* curve : curves_in_order(s_, static_cast<int>(mesh_.bodies.size()), outline))
          outlines.back().curves.push_back({curve, Measure(curve->shape), {}, {}, false});
      }
    mesh_.bodies.push_back(std::move(outlines));
  }
  for (const auto& outlines : mesh_.bodies)
    for (const MeshedOutline& outline : outlines) sample(outline);
  for (size_t b = 0; b < mesh_.bodies.size(); ++b) thin_walls(b), point_loads(b);
  const auto spread_all = [&] {
    size_t first = 0;
    for (const auto& outlines : mesh_.bodies)
      for (const MeshedOutline& outline : outlines) spread(outline, first), first += outline.curves.size();
  };
  spread_all();
  for (size_t k = 0; k < s_.contacts.size(); ++k) gaps(k);
  spread_all();
  size_t index = 0;
  for (auto& outlines : mesh_.bodies)
    for (MeshedOutline& outline : outlines)
      for (MeshedCurve& curve : outline.curves) divide(curve, sizes_[index++]);
  for (size_t b = 0; b < mesh_.bodies.size() && mesh_.given; ++b)
    for (MeshedOutline& outline : mesh_.bodies[b]) give(static_cast<int>(b), outline);
  for (size_t k = 0; k < s_.contacts.size(); ++k) align(k, mesh_);
  return std::move(mesh_);
}

} // namespace

bool holds_pairs(const Sketch& sketch, const Curve& curve) {
  return curve.contact >= 0 && curve.side == 1 &&
         !sketch.interfaces[sketch.contacts[static_cast<size_t>(curve.contact)].interface].tied;
}

Mesh first_mesh(const Sketch& sketch, double fineness) { return Mesher(sketch, fineness, false).run(); }

Mesh given_mesh(const Sketch& sketch) { return Mesher(sketch, kWithoutSearch, !sketch.divisions.empty()).run(); }

} // namespace sketch
