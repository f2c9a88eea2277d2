#include "post/body_faces.hpp"
#include "post/corners.hpp"

#include <algorithm>

namespace app {
namespace {

// The other side at the place where an end of a zone meets it.
struct Meeting {
  double angle = kPi;
  bool is_corner = false;
  int32_t beyond = 0; // the element that continues there, outside the contact; 0: none
  double element = 0;
};

class CornerFinder {
public:
  CornerFinder(c2d_solver* solver, const Summary& s) : solver_(solver), s_(s) {}
  c2d_status find(std::vector<Corner>& out);

private:
  struct End { // of a zone, on a body that has a mesh
    int32_t body;
    StretchEnd end;
    double length; // between the ends of the zone on this side
  };
  const BodyFaces& faces(int32_t body) const { return faces_[static_cast<size_t>(body) - 1]; }
  bool is_rigid(int32_t body) const { return s_.body[body - 1].unknowns == 0; }
  Sector sector(int32_t body, double angle) const {
    const c2d_body_result& b = s_.body[body - 1];
    return sector_of(angle, b.youngs_modulus, b.poisson_ratio, s_.plane != C2D_PLANE_STRESS);
  }
  c2d_status read();
  c2d_status read_friction();
  void find_in_body(int32_t body, std::vector<Corner>& out) const;
  void find_at_image(int32_t body, int32_t element, bool up, std::vector<Corner>& out) const;
  void sample_face(int32_t body, int32_t element, bool up, Corner& corner) const;
  void find_in_zone(int32_t zone, std::vector<Corner>& out) const;
  bool meet(const c2d_zone& zone, const End& own, int32_t other, const StretchEnd* facing, Corner& out) const;
  bool project(const End& own, int32_t other, const StretchEnd* facing, Meeting& out) const;
  void sample_pairs(Corner& corner) const;
  double distance_to_next(const Corner& corner) const;
  double least_exponent(Corner& corner) const;
  double exponent_of(const CornerShape& shape) const;

  c2d_solver* solver_;
  const Summary& s_;
  std::vector<BodyFaces> faces_;
  std::vector<double> x_, y_, zone_;               // of the pairs
  std::vector<double> friction_;                   // the largest of each zone
  std::vector<std::vector<double>> end_x_, end_y_; // element ends of each body
  struct Known {
    std::vector<double> shape;
    double exponent;
  };
  mutable std::vector<Known> known_; // many corners of a model are alike
};

c2d_status CornerFinder::read_friction() {
  friction_.assign(s_.zone.size(), 0);
  for (size_t z = 0; z < friction_.size(); ++z)
    for (int32_t i = 1; i <= s_.coefficients; ++i) {
      double mu = 0;
      const c2d_status status = c2d_get_friction(solver_, static_cast<int32_t>(z) + 1, i, &mu);
      if (status != C2D_OK) return status;
      friction_[z] = std::max(friction_[z], mu);
    }
  return C2D_OK;
}

c2d_status CornerFinder::read() {
  c2d_status status = read_friction();
  faces_.resize(static_cast<size_t>(s_.bodies));
  end_x_.resize(faces_.size()), end_y_.resize(faces_.size());
  for (int32_t b = 1; b <= s_.bodies && status == C2D_OK; ++b) {
    const size_t i = static_cast<size_t>(b) - 1;
    status = faces_[i].read(solver_, s_, b);
    const int32_t ends = s_.body[b - 1].elements * s_.function_nodes;
    end_x_[i].resize(static_cast<size_t>(ends)), end_y_[i].resize(static_cast<size_t>(ends));
    if (status == C2D_OK && ends > 0) status = c2d_get(solver_, C2D_END_X, b, 1, ends, end_x_[i].data(), 1);
    if (status == C2D_OK && ends > 0) status = c2d_get(solver_, C2D_END_Y, b, 1, ends, end_y_[i].data(), 1);
  }
  if (status == C2D_OK) status = get_pairs(solver_, s_, {{C2D_X, x_}, {C2D_Y, y_}, {C2D_PAIR_ZONE, zone_}});
  if (status != C2D_OK) return status;
  for (size_t z = 0; z < s_.zone.size(); ++z)
    for (const c2d_side* side : {&s_.zone[z].side1, &s_.zone[z].side2})
      if (!s_.is_platen(side->body)) faces_[static_cast<size_t>(side->body) - 1].enter_zone(*side, static_cast<int32_t>(z) + 1);
  return C2D_OK;
}

double CornerFinder::exponent_of(const CornerShape& shape) const {
  std::vector<double> numbers;
  for (const Sector& q : shape.sectors) numbers.insert(numbers.end(), {q.angle, q.shear_modulus, q.kappa});
  for (const Face& f : shape.faces) numbers.insert(numbers.end(), {static_cast<double>(f.kind), f.friction});
  for (const Known& k : known_)
    if (std::equal(numbers.begin(), numbers.end(), k.shape.begin(), k.shape.end(),
                   [](double a, double b) { return std::fabs(a - b) <= 1e-9 * std::fabs(a); }))
      return k.exponent;
  known_.push_back({numbers, exponent(shape)});
  return known_.back().exponent;
}

// ---- corners of one body

// Element ends on a face, up to the next corner or change of condition. The face that runs upwards from the
// corner is the first: the material is counter-clockwise from it.
void CornerFinder::sample_face(int32_t body, int32_t element, bool up, Corner& corner) const {
  const BodyFaces& f = faces(body);
  Face own, other;
  f.face(element, own);
  int32_t e = element;
  for (int32_t count = 0; count < f.elements(); ++count) {
    const Point along = f.direction(e, false);
    for (int32_t local = 0; local < s_.function_nodes; ++local) {
      const size_t i = static_cast<size_t>((e - 1) * s_.function_nodes + local);
      const Point at{end_x_[static_cast<size_t>(body) - 1][i], end_y_[static_cast<size_t>(body) - 1][i]};
      corner.samples.push_back({static_cast<int32_t>(i), distance(at, {corner.at[0], corner.at[1]}), up, {along.y, -along.x}});
    }
    const int32_t next = f.next(e, up);
    if (next == 0 || f.is_corner_after(up ? e : next) || !f.face(next, other) || other.kind != own.kind) return;
    e = next;
  }
}

// A notch that a line of symmetry cuts in two.
void CornerFinder::find_at_image(int32_t body, int32_t element, bool up, std::vector<Corner>& out) const {
  const BodyFaces& f = faces(body);
  const double angle = f.angle_at_image(element, up);
  Face face;
  if (angle <= kPi || !f.is_corner_at_image(element, up)) return;
  if (!f.face(element, face) || face.kind != FaceKind::kFree) return;
  Corner c;
  c.kind = CornerKind::kNotch;
  c.body[0] = body;
  const Point at = f.at(element, up), along = f.direction(element, up);
  c.at[0] = at.x, c.at[1] = at.y;
  c.element = f.length(element);
  c.shape = {{sector(body, angle)}, {face, face}};
  c.half = true;
  // In the order of elements the first face leaves the corner, the last one arrives there.
  c.direction = up ? std::atan2(-along.y, -along.x) - angle : std::atan2(along.y, along.x);
  c.least = exponent_of(c.shape);
  sample_face(body, element, !up, c);
  out.push_back(c);
}

void CornerFinder::find_in_body(int32_t body, std::vector<Corner>& out) const {
  const BodyFaces& f = faces(body);
  for (int32_t e = 1; e <= f.elements(); ++e) {
    if (f.is_on_line(e)) continue;
    const int32_t behind = f.next(e, true);
    for (const bool up : {false, true})
      if (f.next(e, up) == 0) find_at_image(body, e, up, out);
    Face before, after;
    if (behind == 0 || !f.face(e, before) || !f.face(behind, after)) continue;
    const bool is_corner = f.is_corner_after(e);
    const double angle = is_corner ? f.angle_after(e) : kPi;
    const bool free = before.kind == FaceKind::kFree && after.kind == FaceKind::kFree;
    if (free ? angle <= kPi : !is_corner && before.kind == after.kind) continue;
    Corner c;
    c.kind = free ? CornerKind::kNotch : CornerKind::kSupport;
    c.body[0] = body;
    const Point at = f.at(e, true), along = f.direction(behind, false);
    c.at[0] = at.x, c.at[1] = at.y;
    c.element = std::min(f.length(e), f.length(behind));
    c.shape = {{sector(body, angle)}, {after, before}};
    c.joint = after.kind == FaceKind::kFree ? 1 : 0;
    c.direction = std::atan2(along.y, along.x);
    c.least = exponent_of(c.shape);
    if (c.least > kSingular) continue;
    sample_face(body, behind, true, c);
    sample_face(body, e, false, c);
    out.push_back(c);
  }
}

// ---- ends of zones

// At the end of a zone on `own`: the facing place of the other body, or the nearest place of its boundary.
bool CornerFinder::project(const End& own, int32_t other, const StretchEnd* facing, Meeting& out) const {
  const BodyFaces& f = faces(other);
  const Point tip = faces(own.body).at(own.end);
  StretchEnd end;
  if (facing != nullptr) {
    end = *facing;
  } else {
    double nearest = -1;
    int32_t at = 0;
    double place = 0;
    for (int32_t e = 1; e <= f.elements(); ++e) {
      const Point a = f.at(e, false), side = f.at(e, true) - a, to = tip - a;
      const double square = side.x * side.x + side.y * side.y;
      const double t = std::min(1.0, std::max(0.0, (to.x * side.x + to.y * side.y) / square));
      const double off = std::hypot(to.x - t * side.x, to.y - t * side.y);
      if (nearest < 0 || off < nearest) nearest = off, at = e, place = t;
    }
    out.element = f.length(at);
    const double near = 0.1 * faces(own.body).length(own.end.element) + 0.1 * out.element + 0.02 * own.length;
    if (place > 1e-3 && place < 1 - 1e-3) { // the direction of the contact at an end depends on the direction of numbering
      out.beyond = at;
      return nearest < near;
    }
    // If the contact comes before the end on its own body, it comes after the place on the other one.
    const int32_t before = place < 0.5 ? f.next(at, false) : at, behind = place < 0.5 ? at : f.next(at, true);
    end = {own.end.up ? behind : before, !own.end.up};
    if (end.element == 0 || nearest > near) return false;
  }
  out.element = f.length(end.element);
  out.beyond = f.beyond(end);
  if (out.beyond == 0) return false;
  out.element = std::min(out.element, f.length(out.beyond));
  out.is_corner = f.is_corner_after(f.before(end));
  if (out.is_corner) out.angle = f.angle_after(f.before(end));
  return true;
}

// The corner where an end of a zone meets the other body; false: none, or one that the geometry does not determine.
bool CornerFinder::meet(const c2d_zone& zone, const End& own, int32_t other, const StretchEnd* facing, Corner& c) const {
  const BodyFaces& f = faces(own.body);
  const bool tied = (zone.kind & C2D_ZONE_TIED) != 0, platen = s_.is_platen(other);
  const int32_t beyond = f.beyond(own.end);
  Face own_face, other_face;
  Meeting there;
  if (beyond == 0 || (!is_rigid(own.body) && !f.face(beyond, own_face))) return false;
  if (!platen && !project(own, other, facing, there)) return false;
  const bool is_corner = f.is_corner_after(f.before(own.end));
  if (!tied && !is_corner && !there.is_corner) return false;
  if (!is_rigid(other)) {
    const bool inside = faces(other).zone(there.beyond) == c.zone; // beyond the corner it faces nothing
    if (!inside && !faces(other).face(there.beyond, other_face)) return false;
  }
  // Both bodies are fixed along a line on which the zone ends: symmetry.
  const bool own_line = is_rigid(own.body) || own_face.kind == FaceKind::kSmooth;
  if (own_line && (is_rigid(other) || other_face.kind == FaceKind::kSmooth)) return false;
  const Point at = f.at(own.end);
  c.kind = tied ? CornerKind::kTie : CornerKind::kContact;
  c.at[0] = at.x, c.at[1] = at.y;
  c.element = std::min(f.length(own.end.element), platen ? f.length(own.end.element) : there.element);
  // Counter-clockwise: the body whose contact arrives at the corner is before the joint.
  const bool own_first = own.end.up;
  const double angle = is_corner ? f.angle_after(f.before(own.end)) : kPi;
  const auto add = [&](bool of_own) {
    c.body[c.body[0] == 0 ? 0 : 1] = of_own ? own.body : other;
    c.shape.sectors.push_back(sector(of_own ? own.body : other, of_own ? angle : there.angle));
  };
  const int32_t first = own_first ? own.body : other, second = own_first ? other : own.body;
  if (!is_rigid(first)) {
    add(own_first);
    c.shape.faces.push_back(own_first ? own_face : other_face);
  }
  c.joint = c.shape.faces.size();
  c.shape.faces.push_back({FaceKind::kBonded, 0});
  if (!is_rigid(second)) {
    add(!own_first);
    c.shape.faces.push_back(own_first ? other_face : own_face);
  }
  c.after = zone.side1.body == second ? 1 : 2;
  return !c.shape.sectors.empty();
}

void CornerFinder::sample_pairs(Corner& c) const {
  for (size_t p = 0; p < zone_.size(); ++p)
    if (static_cast<int32_t>(zone_[p]) == c.zone)
      c.samples.push_back({static_cast<int32_t>(p), std::hypot(x_[p] - c.at[0], y_[p] - c.at[1]), true, {0, 0}});
}

// Over the states that the friction of the zone allows; the joint takes the one with the lowest exponent.
double CornerFinder::least_exponent(Corner& c) const {
  std::vector<Face> states;
  const double mu = friction_[static_cast<size_t>(c.zone) - 1];
  if (c.kind == CornerKind::kTie || mu > 0) states.push_back({FaceKind::kBonded, 0});
  if (c.kind == CornerKind::kContact && mu == 0) states.push_back({FaceKind::kSmooth, 0});
  if (c.kind == CornerKind::kContact && mu > 0 && std::isfinite(mu))
    for (const double f : {mu, -mu}) states.push_back({FaceKind::kRubbing, f});
  double least = 2;
  Face worst;
  for (const Face& state : states) {
    c.shape.faces[c.joint] = state;
    const double now = exponent_of(c.shape);
    if (now < least) least = now, worst = state;
  }
  c.shape.faces[c.joint] = worst;
  return least;
}

void CornerFinder::find_in_zone(int32_t number, std::vector<Corner>& out) const {
  const c2d_zone& zone = s_.zone[static_cast<size_t>(number) - 1];
  if ((zone.kind & C2D_ZONE_SELF) != 0) return;
  const bool free = (zone.kind & C2D_ZONE_FREE) != 0;
  const c2d_side* side[2] = {&zone.side1, &zone.side2};
  StretchEnd ends[2][2];
  for (int k = 0; k < 2; ++k)
    if (!s_.is_platen(side[k]->body)) faces(side[k]->body).find_ends(*side[k], k == 0, ends[k]);
  const bool platen = s_.is_platen(zone.side1.body);
  const size_t before = out.size();
  for (const bool sharp :
       {true, false}) // corners of the side itself first: an end of the other side beside one is the same corner
    for (const int k : {1, 0})
      for (int i = 0; i < 2; ++i) {
        if (k == 0 && (!free || platen || !sharp)) continue; // side 1 of matching zones ends where side 2 does
        const StretchEnd& own = ends[k][i];
        const BodyFaces& f = faces(side[k]->body);
        const bool is_sharp = f.beyond(own) != 0 && f.is_corner_after(f.before(own));
        if (is_sharp != sharp) continue;
        Corner c;
        c.zone = number;
        // Facing sides run in opposite directions: one ends where the other begins, in the order of elements.
        const StretchEnd* facing = free || platen ? nullptr : &ends[1 - k][ends[1 - k][0].up != own.up ? 0 : 1];
        const double length = distance(f.at(ends[k][0]), f.at(ends[k][1]));
        if (!meet(zone, {side[k]->body, own, length}, side[1 - k]->body, facing, c)) continue;
        const Point at{c.at[0], c.at[1]};
        const auto is_here = [&](const Corner& known) {
          return distance(at, {known.at[0], known.at[1]}) < 2 * f.length(own.element);
        };
        if (std::any_of(out.begin() + static_cast<long>(before), out.end(), is_here)) continue;
        c.least = least_exponent(c);
        if (c.least > kSingular) continue;
        sample_pairs(c);
        out.push_back(c);
      }
}

double CornerFinder::distance_to_next(const Corner& c) const {
  double nearest = INFINITY;
  for (const int32_t body : c.body) {
    if (body == 0) continue;
    const BodyFaces& f = faces(body);
    for (int32_t e = 1; e <= f.elements(); ++e) {
      const double off = distance(f.at(e, true), {c.at[0], c.at[1]});
      if (off > 0.5 * c.element && f.next(e, true) != 0 && f.is_corner_after(e)) nearest = std::min(nearest, off);
    }
  }
  return nearest;
}

c2d_status CornerFinder::find(std::vector<Corner>& out) {
  if (const c2d_status status = read(); status != C2D_OK) return status;
  for (int32_t z = 1; z <= static_cast<int32_t>(s_.zone.size()); ++z) find_in_zone(z, out);
  for (int32_t b = 1; b <= s_.bodies; ++b)
    if (!is_rigid(b)) find_in_body(b, out); // (platens have no elements)
  for (Corner& c : out) {
    c.size = distance_to_next(c);
    c.linear = s_.function_nodes == 2;
    std::sort(c.samples.begin(), c.samples.end(),
              [](const Corner::Sample& a, const Corner::Sample& b) { return a.distance < b.distance; });
  }
  return C2D_OK;
}

} // namespace

c2d_status find_corners(c2d_solver* solver, const Summary& summary, std::vector<Corner>& out) {
  out.clear();
  return summary.function_nodes > 1 ? CornerFinder(solver, summary).find(out) : C2D_OK;
}

} // namespace app
