// The divisions of a mesh on changed curves. Phases:
//   1. Compare both sketches: bodies, curves, facing parts, load cases and requests must correspond (compare).
//   2. Divide each changed curve at the same fractions of its length, or where these move (redivided).
//   3. Place the element ends of side 0 of a contact, where they were opposite ends of side 1, opposite these again
//   (face_again).
#include "program/sketch/same_divisions.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kOpposite = 1e-7; // of the length of a curve: an end so near to the foot of another one is opposite to it

void same(bool is_same, const std::string& what) {
  if (!is_same) throw Fault{{}, what + ", expected a change of numbers only"};
}

bool correspond(const Curve& a, const Curve& b) {
  return a.name == b.name && a.contact == b.contact && a.side == b.side && a.is_first == b.is_first && a.is_last == b.is_last;
}

void compare(const Body& a, const Body& b) {
  const std::string of = " of body " + a.name;
  same(a.name == b.name && a.rigid == b.rigid && a.outlines.size() == b.outlines.size(), "the outlines" + of + " differ");
  for (size_t o = 0; o < a.outlines.size(); ++o) {
    const std::vector<Curve>&p = a.outlines[o].curves, &q = b.outlines[o].curves;
    same(a.outlines[o].open == b.outlines[o].open, "an outline" + of + " opens or closes");
    const bool fits = p.size() == q.size() && std::equal(p.begin(), p.end(), q.begin(), correspond);
    same(fits, "the curves or the parts" + of + " that face another body differ");
  }
}

void compare(const Sketch& a, const Sketch& b) {
  same(a.bodies.size() == b.bodies.size(), "the number of bodies differs");
  for (size_t k = 0; k < a.bodies.size(); ++k) compare(a.bodies[k], b.bodies[k]);
  same(a.contacts.size() == b.contacts.size(), "the number of facing parts differs");
  for (size_t k = 0; k < a.contacts.size(); ++k)
    same(a.contacts[k].interface == b.contacts[k].interface && a.contacts[k].turned == b.contacts[k].turned &&
             a.contacts[k].ring == b.contacts[k].ring,
         "the facing parts differ");
  same(a.cases.size() == b.cases.size() && a.pieces == b.pieces && a.wants.size() == b.wants.size() &&
           a.points.size() == b.points.size() && a.conditions.size() == b.conditions.size() &&
           a.drives.size() == b.drives.size(),
       "the load cases, the conditions or the requested results differ");
}

// The curve of `changed` at the place of a curve of `sketch` in the same body.
const Curve* counterpart(const Body& body, const Body& changed, const Curve* curve) {
  for (size_t o = 0; o < body.outlines.size(); ++o)
    for (size_t c = 0; c < body.outlines[o].curves.size(); ++c)
      if (&body.outlines[o].curves[c] == curve) return &changed.outlines[o].curves[c];
  return nullptr;
}

MeshedCurve redivided(const MeshedCurve& from, const Curve* curve, const Stretching* stretching) {
  MeshedCurve out{curve, Measure(curve->shape), from.ends, from.far, from.given};
  const double before = from.measure.length(), after = out.measure.length();
  const auto moved = [&](double s) {
    return stretching == nullptr ? s * (after / before) : stretching->at(s / before) * after;
  };
  for (double& s : out.ends) s = s >= from.ends.back() ? after : moved(s);
  for (auto& [first, last] : out.far) first = moved(first), last = moved(last);
  return out;
}

// Calls `visit` with all curves of a side of a contact.
template <class AnyMesh, class Visit> void on_side(AnyMesh& mesh, size_t contact, int side, const Visit& visit) {
  for (auto& outlines : mesh.bodies)
    for (auto& outline : outlines)
      for (auto& curve : outline.curves)
        if (curve.curve->contact == static_cast<int>(contact) && curve.curve->side == side) visit(curve);
}

Point end_point(const MeshedCurve& curve, size_t k) { return curve.curve->shape->at(curve.measure.u_at(curve.ends[k])); }

// Moves ends of a curve of side 0 to where they were: opposite ends of side 1. `before`, `after`: all curves of side 1.
void face_again(const std::vector<const MeshedCurve*>& before, const std::vector<const MeshedCurve*>& after,
                const MeshedCurve& old, MeshedCurve& curve) {
  const double near = kOpposite * old.measure.length();
  std::vector<double> ends = curve.ends;
  for (size_t c = 0; c < before.size(); ++c)
    for (size_t k = 0; k < before[c]->ends.size(); ++k) {
      const double foot = nearest_length(old, end_point(*before[c], k));
      const auto above = std::lower_bound(old.ends.begin(), old.ends.end(), foot - near);
      const auto at = static_cast<size_t>(above - old.ends.begin());
      if (at == 0 || at + 1 >= old.ends.size() || std::fabs(*above - foot) > near) continue;
      ends[at] = old.ends[at] + (nearest_length(curve, end_point(*after[c], k)) - foot);
    }
  if (std::is_sorted(ends.begin(), ends.end(), std::less_equal<double>())) curve.ends = ends;
}

} // namespace

double Stretching::at(double part) const {
  const auto above = std::upper_bound(from.begin() + 1, from.end() - 1, part);
  const auto k = static_cast<size_t>(above - from.begin());
  return to[k - 1] + (part - from[k - 1]) / (from[k] - from[k - 1]) * (to[k] - to[k - 1]);
}

MeshPlace place_on(const Sketch& sketch, const Spot& spot, const Mesh& mesh) {
  Mesh own = mesh;
  const Located at = locate(sketch, spot, true, own);
  MeshPlace out;
  for (const auto& outlines : own.bodies)
    for (const MeshedOutline& outline : outlines)
      for (const MeshedCurve& curve : outline.curves) {
        if (&curve == at.curve) return {out.curve, at.length / curve.measure.length()};
        ++out.curve;
      }
  return out; // no side has such conditions
}

Mesh same_divisions(const Sketch& sketch, const Mesh& mesh, const Sketch& changed, const Stretchings& stretchings) {
  compare(sketch, changed);
  Mesh out;
  size_t index = 0;
  out.given = mesh.given;
  for (size_t b = 0; b < mesh.bodies.size(); ++b) {
    out.bodies.push_back({});
    for (const MeshedOutline& outline : mesh.bodies[b]) {
      out.bodies.back().push_back({outline.open, {}});
      for (const MeshedCurve& curve : outline.curves) {
        const auto found = stretchings.find(index++);
        out.bodies.back().back().curves.push_back(redivided(curve,
                                                            counterpart(sketch.bodies[b], changed.bodies[b], curve.curve),
                                                            found == stretchings.end() ? nullptr : &found->second));
      }
    }
  }
  for (size_t k = 0; k < sketch.contacts.size(); ++k) {
    std::vector<const MeshedCurve*> before, after, old;
    on_side(mesh, k, 1, [&](const MeshedCurve& curve) { before.push_back(&curve); });
    on_side(out, k, 1, [&](const MeshedCurve& curve) { after.push_back(&curve); });
    on_side(mesh, k, 0, [&](const MeshedCurve& curve) { old.push_back(&curve); });
    size_t next = 0;
    on_side(out, k, 0, [&](MeshedCurve& curve) { face_again(before, after, *old[next++], curve); });
  }
  return out;
}

} // namespace sketch
