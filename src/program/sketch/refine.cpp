// Refinement of a mesh (refined). Phases:
// 1. Transfer the requested levels from side 0 of every contact to the elements of side 1 (carry).
// 2. Bisect elements by level (divided), then until no element is more than kNeighbours times as long as its neighbour
//    (smooth).
// 3. Move element ends to given places, such as edges of contact (place_ends).
// 4. Replace the elements of side 0 of every contact by ends opposite those of side 1 (align, face).
#include "program/sketch/refine.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kNeighbours = 3.0;    // largest ratio of the lengths of neighbouring elements
constexpr double kLeastElement = 1e-8; // of the largest coordinate; lengths along curves are accurate to 1e-10

// No element becomes shorter than `least`.
std::vector<double> divided(const std::vector<double>& ends, const Bisection* bisections, double least) {
  std::vector<double> out(1, ends.front());
  for (size_t e = 0; e + 1 < ends.size(); ++e) {
    const double length = ends[e + 1] - ends[e];
    int level = bisections[e].level;
    while (level > 0 && length < std::ldexp(least, level)) --level;
    const int parts = 1 << level;
    if (bisections[e].toward == 0)
      for (int k = 1; k < parts; ++k) out.push_back(ends[e] + length * k / parts);
    else if (bisections[e].toward < 0)
      for (int k = level; k > 0; --k) out.push_back(ends[e] + std::ldexp(length, -k));
    else
      for (int k = 1; k <= level; ++k) out.push_back(ends[e + 1] - std::ldexp(length, -k));
    out.push_back(ends[e + 1]);
  }
  return out;
}

// Gives elements of side 1 the bisections requested for the elements of side 0 opposite.
void carry(size_t contact, const Mesh& mesh, Levels& levels) {
  struct Asked {
    Point middle, end; // the end that it is graded toward
    double half;
    Bisection bisection;
  };
  std::vector<Asked> asked;
  const auto each = [&](int side, const auto& visit) { // element of a side
    for (size_t b = 0; b < mesh.bodies.size(); ++b) {
      size_t e = 0;
      for (const MeshedOutline& outline : mesh.bodies[b])
        for (const MeshedCurve& curve : outline.curves) {
          const bool on = curve.curve->contact == static_cast<int>(contact) && curve.curve->side == side;
          for (size_t k = 0; k < curve.elements(); ++k, ++e)
            if (on) visit(curve, k, levels[b][e]);
        }
    }
  };
  const auto point = [](const MeshedCurve& curve, double s) { return curve.curve->shape->at(curve.measure.u_at(s)); };
  const auto middle = [&](const MeshedCurve& curve, size_t k) { return point(curve, (curve.ends[k] + curve.ends[k + 1]) / 2); };
  each(0, [&](const MeshedCurve& curve, size_t k, const Bisection& own) {
    const double half = (curve.ends[k + 1] - curve.ends[k]) / 2;
    if (own.level > 0) asked.push_back({middle(curve, k), point(curve, curve.ends[own.toward > 0 ? k + 1 : k]), half, own});
  });
  if (asked.empty()) return;
  each(1, [&](const MeshedCurve& curve, size_t k, Bisection& own) {
    const Point p = middle(curve, k);
    const double half = (curve.ends[k + 1] - curve.ends[k]) / 2;
    for (const Asked& a : asked) {
      if (length(a.middle - p) >= std::max(a.half, half) || half <= 0.7 * a.half || own.level >= a.bisection.level) continue;
      const auto away = [&](size_t end) { return length(point(curve, curve.ends[end]) - a.end); };
      own = {a.bisection.level, a.bisection.toward == 0 ? 0 : away(k) < away(k + 1) ? -1 : 1};
    }
  });
}

// The shortest allowed element, a fraction of the largest coordinate: below it, coordinate differences lose their digits.
double least_element(const Mesh& mesh) {
  double largest = 0;
  for (const auto& outlines : mesh.bodies)
    for (const MeshedOutline& outline : outlines)
      for (const MeshedCurve& curve : outline.curves)
        for (const double u : {0.0, 0.5, 1.0}) {
          const Point p = curve.curve->shape->at(u);
          largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
        }
  return kLeastElement * largest;
}

// Bisects elements that are too long beside their neighbours; a closed outline is cyclic.
void smooth(MeshedOutline& outline) {
  struct Element {
    MeshedCurve* curve;
    size_t index;
    double length;
  };
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<Element> all;
    for (MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e) all.push_back({&curve, e, curve.ends[e + 1] - curve.ends[e]});
    std::vector<char> split(all.size(), 0);
    for (size_t i = 0; i < all.size(); ++i) {
      const size_t next = i + 1 < all.size() ? i + 1 : 0;
      if (next == 0 && outline.open) break;
      if (all[i].length > kNeighbours * all[next].length * (1 + 1e-9)) split[i] = 1;
      if (all[next].length > kNeighbours * all[i].length * (1 + 1e-9)) split[next] = 1;
    }
    size_t at = 0;
    for (MeshedCurve& curve : outline.curves) {
      std::vector<Bisection> levels;
      for (size_t e = 0; e < curve.elements(); ++e) levels.push_back({split[at + e], 0});
      at += curve.elements();
      if (std::none_of(levels.begin(), levels.end(), [](const Bisection& d) { return d.level > 0; })) continue;
      curve.ends = divided(curve.ends, levels.data(), 0);
      changed = true;
    }
  }
}

// Places the element ends of a curve of side 0 opposite those of side 1. Where nothing faces the curve, it keeps its own ends.
void face(const std::vector<std::vector<Point>>& chains, MeshedCurve& curve) {
  const double whole = curve.measure.length(), low = 1e-9 * whole, high = whole - low;
  struct Stretch { // that an element of side 1 faces
    double from, to;
  };
  std::vector<Stretch> faced;
  std::vector<double> places;
  for (const std::vector<Point>& chain : chains) {
    double before = -1;
    for (const Point& p : chain) {
      const double s = nearest_length(curve, p);
      const bool within = s > low && s < high;
      if (within) places.push_back(s);
      if (within && before > low && before < high) faced.push_back({std::min(s, before), std::max(s, before)});
      before = s;
    }
  }
  if (places.empty()) return;
  std::sort(places.begin(), places.end());
  const auto step_at = [&](double s) { // of the current elements
    const auto above = std::upper_bound(curve.ends.begin() + 1, curve.ends.end() - 1, s);
    return *above - *(above - 1);
  };
  for (const double s : std::vector<double>(curve.ends.begin() + 1, curve.ends.end() - 1)) {
    const double room = 0.4 * step_at(s);
    bool keeps = true;
    for (const Stretch& f : faced) keeps = keeps && (s <= f.from || s >= f.to);
    const auto above = std::lower_bound(places.begin(), places.end(), s);
    if (keeps && (above == places.end() || *above - s > room) && (above == places.begin() || s - *(above - 1) > room))
      places.insert(above, s);
  }
  std::vector<double> out(1, 0.0);
  for (const double s : places) { // merge ends that nearly coincide
    double room = 0.2 * step_at(s);
    for (const Stretch& f : faced)
      if (s == f.from || s == f.to) room = std::min(room, 0.2 * (f.to - f.from));
    if (s - out.back() > room && whole - s > room) out.push_back(s);
  }
  out.push_back(whole);
  if (out.size() > 2) curve.ends = out;
}

} // namespace

void align(size_t contact, Mesh& mesh) {
  const auto on = [contact](const MeshedCurve& curve, int side) {
    return curve.curve->contact == static_cast<int>(contact) && curve.curve->side == side;
  };
  std::vector<std::vector<Point>> chains; // element ends of side 1, curve by curve
  bool given = mesh.given;
  for (const auto& outlines : mesh.bodies)
    for (const MeshedOutline& outline : outlines)
      for (const MeshedCurve& curve : outline.curves) {
        if (!on(curve, 1)) continue;
        chains.push_back({});
        given = given && curve.given;
        for (const double s : curve.ends) chains.back().push_back(curve.curve->shape->at(curve.measure.u_at(s)));
      }
  for (auto& outlines : mesh.bodies)
    for (MeshedOutline& outline : outlines)
      for (MeshedCurve& curve : outline.curves)
        if (on(curve, 0) && !curve.given) {
          if (given) curve.ends = {0, curve.measure.length()};
          face(chains, curve);
          curve.given = given;
        }
}

Mesh refined(const Sketch& sketch, const Mesh& mesh, const Levels& levels, const std::vector<Spot>& spots) {
  Levels all = levels;
  for (size_t k = 0; k < sketch.contacts.size(); ++k) carry(k, mesh, all);
  Mesh out = mesh;
  const double least = least_element(mesh);
  for (size_t b = 0; b < out.bodies.size(); ++b) {
    const Bisection* bisection = all[b].data();
    for (MeshedOutline& outline : out.bodies[b]) {
      for (MeshedCurve& curve : outline.curves) {
        const size_t before = curve.elements();
        curve.ends = divided(curve.ends, bisection, least);
        bisection += before;
      }
      smooth(outline);
    }
  }
  place_ends(sketch, spots, out);
  for (size_t k = 0; k < sketch.contacts.size(); ++k) align(k, out);
  return out;
}

Mesh halved(const Sketch& sketch, const Mesh& mesh) {
  Mesh out = mesh;
  const double least = least_element(mesh);
  for (auto& outlines : out.bodies)
    for (MeshedOutline& outline : outlines)
      for (MeshedCurve& curve : outline.curves) {
        const std::vector<Bisection> once(curve.elements(), Bisection{1, 0});
        curve.ends = divided(curve.ends, once.data(), least);
      }
  for (size_t k = 0; k < sketch.contacts.size(); ++k) align(k, out);
  return out;
}

int elements_of(const Mesh& mesh) {
  size_t count = 0;
  for (const auto& outlines : mesh.bodies)
    for (const MeshedOutline& outline : outlines) count += outline.elements();
  return static_cast<int>(count);
}

} // namespace sketch
