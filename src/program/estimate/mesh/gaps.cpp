// Search for contact between the nodes of a mesh (METHOD 16.5). Phases: find facing points of the two sides; compute their gaps
// g + (u1 - u2).n from displacements interpolated on both meshes; report overlaps that no pair has detected, and zones in which
// contact cannot be excluded; mark elements with an overlap for bisection.
#include "program/estimate/mesh/gaps.hpp"

#include "program/estimate/mesh/functions.hpp"

#include <algorithm>
#include <cmath>

namespace estimate {
namespace {

constexpr double kSettled = 0.2;      // relative change of the largest motion above which contact cannot be excluded
constexpr double kTouch = 1e-7;       // times the contact length: a smaller gap has no direction
constexpr double kNone = 1e-9;        // motions below this fraction of the gap are round-off
constexpr double kMostBisections = 6; // bisections of an element in one round

// A place on an outline of a mesh.
struct OnMesh {
  sketch::MeshedCurve* curve;
  size_t element, own; // of the body, of the curve
  double eta;          // -1 ... 1 on it
  sketch::Point at, outward;
};

// Finds places on one side of a contact by their lengths along the outline.
class Finder {
public:
  Finder(const sketch::Sketch& sketch, size_t contact, size_t side, sketch::Mesh& mesh)
      : strip_(sketch.contacts[contact].side[side]) {
    size_t first = 0;
    for (sketch::MeshedOutline& outline : mesh.bodies[static_cast<size_t>(strip_.body)])
      for (sketch::MeshedCurve& curve : outline.curves) {
        const bool on = curve.curve->contact == static_cast<int>(contact) && curve.curve->side == static_cast<int>(side);
        if (on) curves_.push_back({&curve, first});
        first += curve.elements();
      }
  }
  OnMesh at(double length) const {
    const Own* own = nullptr;
    double least = HUGE_VAL, place = 0; // how far it is from a curve; the length along that
    for (const Own& o : curves_)
      for (const double round : {-1.0, 0.0, 1.0}) {
        const double s = length + round * strip_.round - o.curve->curve->begin;
        const double off = std::max({0.0, -s, s - o.curve->ends.back()});
        if (off < least) own = &o, least = off, place = s;
      }
    sketch::MeshedCurve& curve = *own->curve;
    const std::vector<double>& ends = curve.ends;
    const double s = std::clamp(place, 0.0, ends.back());
    const auto above = std::upper_bound(ends.begin() + 1, ends.end() - 1, s);
    const auto e = static_cast<size_t>(above - ends.begin()) - 1;
    const double u = curve.measure.u_at(s);
    return {&curve,
            own->first + e,
            e,
            -1 + 2 * (s - ends[e]) / (ends[e + 1] - ends[e]),
            curve.curve->shape->at(u),
            -1.0 * sketch::turned_left(curve.curve->shape->tangent(u))};
  }

private:
  struct Own {
    sketch::MeshedCurve* curve;
    size_t first; // its first element, of the body
  };
  const sketch::Contact::Strip& strip_;
  std::vector<Own> curves_;
};

// Facing points: places on the mesh, drawn gap, and its direction out of side 1.
struct Facing {
  OnMesh side[2];
  double gap;
  sketch::Point normal;
  double length; // along side 2
};

std::vector<Facing> facing_points(const sketch::Sketch& sketch, size_t number, sketch::Mesh& mesh) {
  const sketch::Contact& contact = sketch.contacts[number];
  const Finder finders[2] = {{sketch, number, 0, mesh}, {sketch, number, 1, mesh}};
  std::vector<Facing> out;
  for (const std::array<double, 2>& lengths : contact.map) {
    Facing f{{finders[0].at(lengths[0]), finders[1].at(lengths[1])}, 0, {}, lengths[1]};
    // Direction across the gap; where surfaces touch, or at a corner, the normal out of side 1.
    const sketch::Point way = f.side[0].at - f.side[1].at, outward = f.side[1].outward;
    const double size = sketch::length(way), across = sketch::dot(way, outward);
    const bool opposite = std::fabs(across) > 0.5 * size && size > kTouch * (contact.side[1].to - contact.side[1].from);
    f.gap = opposite ? std::copysign(size, across) : across;
    f.normal = opposite ? (1 / f.gap) * way : outward;
    out.push_back(f);
  }
  return out;
}

// A displacement at a place.
double displacement(const std::vector<double>& ends, int32_t nodes, const OnMesh& place) {
  const Functions f(nodes, place.eta);
  double out = 0;
  for (int32_t i = 0; i < nodes; ++i)
    out += f.value[i] * ends[place.element * static_cast<size_t>(nodes) + static_cast<size_t>(i)];
  return out;
}

// Displacement of side 1 relative to side 2 in a direction.
double motion_along(const sketch::Contact& contact, const Trial& trial, const State& state, const Facing& f,
                    sketch::Point way) {
  double out = 0;
  for (size_t side = 0; side < 2; ++side) {
    const auto& ends = state.ends[static_cast<size_t>(contact.side[side].body)];
    const double along =
        displacement(ends[kUx], trial.nodes, f.side[side]) * way.x + displacement(ends[kUy], trial.nodes, f.side[side]) * way.y;
    out += side == 0 ? along : -along;
  }
  return out;
}

// Change of the gap.
double opening(const sketch::Contact& contact, const Trial& trial, const State& state, const Facing& f) {
  return motion_along(contact, trial, state, f, f.normal);
}

// Change of the gap because sliding by this length along the surfaces brings another point of side 2 opposite the point of
// side 1.
double fall(const Finder& side2, const Facing& f, double far) {
  constexpr int kSteps = 6;
  const sketch::Point along = sketch::turned_left(f.normal);
  double length = f.length, out = 0;
  for (int i = 0; i <= kSteps; ++i) {
    const OnMesh there = side2.at(length);
    const sketch::Point way = there.at - f.side[1].at;
    out = -sketch::dot(way, f.normal);
    const double slope = sketch::dot(sketch::turned_left(there.outward), along);
    if (slope == 0) break;
    length += (far - sketch::dot(way, along)) / slope;
  }
  return out;
}

// Does a pair of an element or of its neighbours touch?
bool touches(const Trial& trial, const State& state, const sketch::Contact& contact, const OnMesh& place) {
  const std::vector<double>& status = state.ends[static_cast<size_t>(contact.side[1].body)][kStatus];
  const auto nodes = static_cast<size_t>(trial.nodes);
  const size_t low = place.element > 0 ? (place.element - 1) * nodes : 0;
  const size_t high = std::min((place.element + 2) * nodes, status.size());
  return std::any_of(status.begin() + static_cast<std::ptrdiff_t>(low), status.begin() + static_cast<std::ptrdiff_t>(high),
                     [](double s) { return s > 0; });
}

bool is_tied(const sketch::Sketch& sketch, size_t contact) {
  return sketch.interfaces[sketch.contacts[contact].interface].tied;
}

// The points of a contact on two meshes.
class Survey {
public:
  Survey(const sketch::Sketch& sketch, size_t contact, const Solved& coarse, sketch::Mesh& coarse_mesh, const Solved& fine)
      : contact_(sketch.contacts[contact]), coarse_(coarse.trial), fine_(fine.trial), fine_mesh_(fine.mesh),
        side2_(sketch, contact, 1, fine_mesh_), coarse_points_(facing_points(sketch, contact, coarse_mesh)),
        points_(facing_points(sketch, contact, fine_mesh_)) {
    for (size_t k = 0; k < states(); ++k)
      for (const Facing& f : points_) motion_ = std::max(motion_, std::fabs(opening(contact_, fine_, fine_.states[k], f)));
  }
  size_t states() const { return std::min(coarse_.states.size(), fine_.states.size()); }
  size_t size() const { return points_.size(); }
  double motion() const { return motion_; } // the largest
  double drawn(size_t i) const { return points_[i].gap; }
  const OnMesh& on_coarse(size_t i) const { return coarse_points_[i].side[1]; }
  bool touches(size_t k, size_t i) const { return estimate::touches(fine_, fine_.states[k], contact_, points_[i].side[1]); }
  // With sliding, other points face each other: an overlap must also exist there.
  double gap(size_t k, size_t i) const {
    const Facing& f = points_[i];
    const double out = f.gap + opening(contact_, fine_, fine_.states[k], f);
    if (out >= 0) return out;
    const double far = motion_along(contact_, fine_, fine_.states[k], f, sketch::turned_left(f.normal));
    return std::min(0.0, out + std::max(0.0, fall(side2_, f, far)));
  }
  // Difference of the gap from the coarser mesh.
  double change(size_t k, size_t i) const {
    return std::fabs(opening(contact_, fine_, fine_.states[k], points_[i]) -
                     opening(contact_, coarse_, coarse_.states[k], coarse_points_[i]));
  }
  // Do the surfaces overlap by more than the uncertainty of the motions?
  bool overlaps(size_t k, size_t i, double tolerance) const {
    return !touches(k, i) && gap(k, i) + 2 * change(k, i) < -tolerance * motion_ - kNone * std::fabs(drawn(i));
  }

private:
  const sketch::Contact& contact_;
  const Trial &coarse_, &fine_;
  sketch::Mesh fine_mesh_;
  Finder side2_; // of side 2
  std::vector<Facing> coarse_points_, points_;
  double motion_ = 0;
};

OpenContact open_contact(const sketch::Sketch& sketch, size_t contact, const Solved& coarse, const Solved& fine,
                         double tolerance) {
  OpenContact out;
  sketch::Mesh mesh = coarse.mesh;
  const Survey survey(sketch, contact, coarse, mesh, fine);
  double change = 0, gap = 0, margin = HUGE_VAL;
  bool empty = true;
  for (size_t k = 0; k < survey.states(); ++k)
    for (size_t i = 0; i < survey.size(); ++i) {
      empty = empty && !survey.touches(k, i);
      out.misses = out.misses || survey.overlaps(k, i, tolerance);
      change = std::max(change, survey.change(k, i)), gap = std::max(gap, std::fabs(survey.drawn(i)));
      margin = std::min(margin, survey.gap(k, i) - 2 * survey.change(k, i));
    }
  const double motion = survey.motion();
  if (motion <= kNone * gap) return OpenContact();
  out.unsure = empty && (change > kSettled * motion || margin < -tolerance * motion);
  return out;
}

} // namespace

std::vector<OpenContact> open_contacts(const sketch::Sketch& sketch, const Solved& coarse, const Solved& fine,
                                       double tolerance) {
  std::vector<OpenContact> out;
  for (size_t contact = 0; contact < sketch.contacts.size(); ++contact)
    out.push_back(is_tied(sketch, contact) ? OpenContact() : open_contact(sketch, contact, coarse, fine, tolerance));
  return out;
}

void mark_missed(const sketch::Sketch& sketch, const Solved& coarse, const Solved& fine, double tolerance, sketch::Mesh& mesh,
                 sketch::Levels& levels) {
  for (size_t number = 0; number < sketch.contacts.size(); ++number) {
    if (is_tied(sketch, number)) continue;
    const sketch::Contact& contact = sketch.contacts[number];
    const Survey survey(sketch, number, coarse, mesh, fine);
    for (size_t k = 0; k < survey.states(); ++k)
      for (size_t i = 0, next; i < survey.size(); i = next) {
        for (next = i; next < survey.size() && survey.overlaps(k, next, tolerance);) ++next;
        if (next++ == i) continue;
        const size_t low = i > 0 ? i - 1 : i, high = std::min(next - 1, survey.size() - 1); // with the adjacent open points
        const double width = contact.map[high][1] - contact.map[low][1];
        for (size_t p = i; p + 1 < next; ++p) {
          const OnMesh& place = survey.on_coarse(p);
          const std::vector<double>& ends = place.curve->ends;
          const double more = std::log2(2 * (ends[place.own + 1] - ends[place.own]) / width);
          int& level = levels[static_cast<size_t>(contact.side[1].body)][place.element].level;
          level = std::max(level, static_cast<int>(std::clamp(more, 1.0, kMostBisections)));
          place.curve->far.clear();
        }
      }
  }
}

} // namespace estimate
