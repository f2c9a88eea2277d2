#include "post/cracks.hpp"

#include "post/point.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace app {
namespace {

// Faces farther apart at their other end than this fraction of their length form a notch: the rotation there,
// times their distance, would count as slip.
const double kNarrow = 0.0101;

// Corners of the elements of a body, from its element ends.
class Corners {
public:
  c2d_status read(c2d_solver* solver, const Summary& s, int32_t body) {
    const int32_t fields[] = {C2D_END_X, C2D_END_Y};
    nodes_ = s.function_nodes;
    c2d_status status = get_ends(solver, s, body, fields, 2, ends_);
    for (int32_t r = 1; status == C2D_OK && r <= s.body[body - 1].regions; ++r) {
      regions_.emplace_back();
      status = c2d_get_region(solver, body, r, &regions_.back()[0], &regions_.back()[1]);
    }
    return status;
  }
  Point at(int32_t element, bool end) const {
    const size_t i = static_cast<size_t>((element - 1) * nodes_ + (end ? nodes_ - 1 : 0));
    return {ends_[0][i], ends_[1][i]};
  }
  double length(int32_t element) const { return distance(at(element, false), at(element, true)); }
  // The element that follows on the closed curve, upwards or downwards.
  int32_t next(int32_t element, bool up) const {
    for (const std::array<int32_t, 2>& r : regions_)
      if (element >= r[0] && element <= r[1])
        return up ? (element == r[1] ? r[0] : element + 1) : (element == r[0] ? r[1] : element - 1);
    return element;
  }

private:
  int32_t nodes_ = 0;
  std::vector<std::vector<double>> ends_;
  std::vector<std::array<int32_t, 2>> regions_;
};

// An end of a side of a zone: position, element, and whether the curve leaves the side upwards.
struct SideEnd {
  Point at;
  int32_t element;
  bool up;
};
// The ends at the side's first and last element. `first`: whether a side of one element runs up.
void find_side_ends(const Corners& corners, const c2d_side& side, bool first, SideEnd out[2]) {
  const int32_t elements = side.elements;
  int32_t last = side.first_element;
  for (int32_t k = 1; k < elements; ++k) last = corners.next(last, true);
  const bool up = elements == 1 ? first : last == side.last_element;
  out[0] = {corners.at(side.first_element, !up), side.first_element, !up};
  out[1] = {corners.at(side.last_element, up), side.last_element, up};
}

struct ZoneEnds {
  SideEnd side[2][2]; // of side 1 and 2, facing each other
  double length;      // between them
};

class TipFinder {
public:
  TipFinder(c2d_solver* solver, const Summary& s) : solver_(solver), s_(s) {}
  c2d_status find(std::vector<CrackTip>& out);

private:
  ZoneEnds ends_of(const c2d_zone& zone) const;
  ZoneEnds ends_up_to_ties(const c2d_zone& zone) const;
  bool is_tip(const c2d_zone& zone, const ZoneEnds& ends, int which) const;
  bool is_tied_at(const c2d_zone& zone, const SideEnd& a, const SideEnd& b) const;
  bool is_sharp(const c2d_zone& zone, const ZoneEnds& ends, int which) const;
  CrackTip tip_of(size_t zone, const SideEnd& a, const SideEnd& b) const;
  void judge(CrackTip& tip) const;

  c2d_solver* solver_;
  const Summary& s_;
  std::vector<Corners> corners_;
  std::vector<double> x_, y_, zone_; // of the pairs
};

ZoneEnds TipFinder::ends_of(const c2d_zone& zone) const {
  ZoneEnds e;
  find_side_ends(corners_[static_cast<size_t>(zone.side1.body) - 1], zone.side1, true, e.side[0]);
  find_side_ends(corners_[static_cast<size_t>(zone.side2.body) - 1], zone.side2, false, e.side[1]);
  const SideEnd *a = e.side[0], *b = e.side[1]; // sides of free zones may run either way
  if (distance(a[0].at, b[0].at) + distance(a[1].at, b[1].at) > distance(a[0].at, b[1].at) + distance(a[1].at, b[0].at))
    std::swap(e.side[1][0], e.side[1][1]);
  e.length = distance(a[0].at, a[1].at);
  return e;
}

// Do two faces of one body meet there?
bool TipFinder::is_sharp(const c2d_zone& zone, const ZoneEnds& ends, int which) const {
  const Corners& corners = corners_[static_cast<size_t>(zone.side1.body) - 1];
  const SideEnd &a = ends.side[0][which], &b = ends.side[1][which];
  return corners.next(a.element, a.up) == b.element && distance(a.at, b.at) < 1e-6 * corners.length(a.element);
}

bool same_bodies(const c2d_zone& a, const c2d_zone& b) {
  return (a.side1.body == b.side1.body && a.side2.body == b.side2.body) ||
         (a.side1.body == b.side2.body && a.side2.body == b.side1.body);
}

// Does a tie of the same bodies begin where this zone ends?
bool TipFinder::is_tied_at(const c2d_zone& zone, const SideEnd& a, const SideEnd& b) const {
  const double near = 1e-6 * corners_[static_cast<size_t>(zone.side1.body) - 1].length(a.element);
  for (const c2d_zone& tie : s_.zone) {
    if ((tie.kind & C2D_ZONE_TIED) == 0 || !same_bodies(zone, tie)) continue;
    const ZoneEnds other = ends_of(tie);
    const int turned = tie.side1.body == zone.side1.body ? 0 : 1;
    for (int k = 0; k < 2; ++k)
      if (distance(other.side[turned][k].at, a.at) < near && distance(other.side[1 - turned][k].at, b.at) < near) return true;
  }
  return false;
}

// Nodes are in one pair, so faces in a free zone end an element before a tie: that one belongs to them.
ZoneEnds TipFinder::ends_up_to_ties(const c2d_zone& zone) const {
  ZoneEnds ends = ends_of(zone);
  for (int k = 0; k < 2 && (zone.kind & (C2D_ZONE_FREE | C2D_ZONE_SELF)) == C2D_ZONE_FREE; ++k) {
    if (is_tied_at(zone, ends.side[0][k], ends.side[1][k])) continue;
    SideEnd& short_one = ends.side[1][k];
    const Corners& corners = corners_[static_cast<size_t>(zone.side2.body) - 1];
    const int32_t next = corners.next(short_one.element, short_one.up);
    const SideEnd longer{corners.at(next, short_one.up), next, short_one.up};
    if (is_tied_at(zone, ends.side[0][k], longer)) short_one = longer;
  }
  return ends;
}

bool TipFinder::is_tip(const c2d_zone& zone, const ZoneEnds& ends, int which) const {
  const SideEnd &a = ends.side[0][which], &b = ends.side[1][which];
  if (distance(ends.side[0][1 - which].at, ends.side[1][1 - which].at) > kNarrow * ends.length) return false;
  return (zone.kind & C2D_ZONE_SELF) != 0 ? is_sharp(zone, ends, which) : is_tied_at(zone, a, b);
}

bool alike(double a, double b) { return std::fabs(a - b) <= 1e-9 * std::max(std::fabs(a), std::fabs(b)); }

void TipFinder::judge(CrackTip& tip) const {
  const c2d_zone& zone = s_.zone[static_cast<size_t>(tip.zone) - 1];
  const c2d_body_result &a = s_.body[zone.side1.body - 1], &b = s_.body[zone.side2.body - 1];
  const double nu = a.poisson_ratio;
  tip.modulus = s_.plane == C2D_PLANE_STRESS ? a.youngs_modulus : a.youngs_modulus / (1 - nu * nu);
  if (a.unknowns == 0 || b.unknowns == 0)
    tip.why = "one of the bodies is rigid";
  else if (!alike(a.youngs_modulus, b.youngs_modulus) || !alike(nu, b.poisson_ratio))
    tip.why = "the bodies differ in material";
}

CrackTip TipFinder::tip_of(size_t zone, const SideEnd& a, const SideEnd& b) const {
  CrackTip tip;
  tip.zone = static_cast<int32_t>(zone) + 1;
  tip.at[0] = (a.at.x + b.at.x) / 2, tip.at[1] = (a.at.y + b.at.y) / 2;
  tip.element = corners_[static_cast<size_t>(s_.zone[zone].side2.body) - 1].length(b.element);
  for (size_t p = 0; p < zone_.size(); ++p)
    if (static_cast<int32_t>(zone_[p]) == tip.zone)
      tip.faces.push_back({static_cast<int32_t>(p), std::hypot(x_[p] - tip.at[0], y_[p] - tip.at[1])});
  std::sort(tip.faces.begin(), tip.faces.end(),
            [](const CrackTip::Pair& p, const CrackTip::Pair& q) { return p.distance < q.distance; });
  judge(tip);
  return tip;
}

c2d_status TipFinder::find(std::vector<CrackTip>& out) {
  c2d_status status = C2D_OK;
  corners_.resize(static_cast<size_t>(s_.bodies));
  for (int32_t b = 1; b <= s_.bodies && status == C2D_OK; ++b)
    status = corners_[static_cast<size_t>(b) - 1].read(solver_, s_, b);
  if (status == C2D_OK) status = get_pairs(solver_, s_, {{C2D_X, x_}, {C2D_Y, y_}, {C2D_PAIR_ZONE, zone_}});
  for (size_t z = 0; z < s_.zone.size() && status == C2D_OK; ++z) {
    if ((s_.zone[z].kind & C2D_ZONE_TIED) != 0) continue;
    const ZoneEnds ends = ends_up_to_ties(s_.zone[z]);
    for (int k = 0; k < 2; ++k)
      if (is_tip(s_.zone[z], ends, k)) out.push_back(tip_of(z, ends.side[0][k], ends.side[1][k]));
  }
  return status;
}

// ---- stress intensity

const int kTipTerms = 4; // r^-1/2, r^1/2, r^3/2, r^5/2
// Pairs used: from three elements at the tip up to 0.3 of the stretch of pairs that are all open, or all closed.
const double kNearestPair = 3, kFarthestPair = 0.3;
const size_t kFewestPairs = 6;
struct JumpSample {
  double r, jump; // r over the largest of the samples
};

// Factor of r^1/2 by least squares, errors relative to r^1/2: orthogonal columns one after another, that term as the last.
double leading_term(const std::vector<JumpSample>& samples) {
  const int powers[kTipTerms] = {-1, 1, 2, 0};
  std::vector<double> q[kTipTerms], rest;
  for (const JumpSample& s : samples) {
    for (int k = 0; k < kTipTerms; ++k) q[k].push_back(std::pow(s.r, powers[k]));
    rest.push_back(s.jump / std::sqrt(s.r));
  }
  const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
  };
  double factor = 0;
  for (int k = 0; k < kTipTerms; ++k) {
    for (int round = 0; round < 2; ++round)
      for (int j = 0; j < k; ++j) {
        const double part = product(q[j], q[k]) / product(q[j], q[j]);
        for (size_t i = 0; i < rest.size(); ++i) q[k][i] -= part * q[j][i];
      }
    factor = product(q[k], rest) / product(q[k], q[k]);
    for (size_t i = 0; i < rest.size(); ++i) rest[i] -= factor * q[k][i];
  }
  return factor;
}

} // namespace

c2d_status find_crack_tips(c2d_solver* solver, const Summary& summary, std::vector<CrackTip>& out) {
  out.clear();
  const bool any = summary.pairs > 0 && summary.function_nodes > 1; // constant functions have no nodes at corners
  return any ? TipFinder(solver, summary).find(out) : C2D_OK;
}
StressIntensity stress_intensity(const CrackTip& tip, const double* table, int64_t stride) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  StressIntensity out{tip.zone, {tip.at[0], tip.at[1]}, none, none, tip.why};
  if (!out.why.empty() || tip.faces.empty()) return out;
  const auto row = [&](size_t i) { return table + tip.faces[i].pair * stride; };
  const auto is_open = [&](size_t i) { return static_cast<int32_t>(row(i)[C2D_STATUS]) == C2D_OPEN; };
  size_t run = 1; // pairs from the tip on that are open, or that are not
  while (run < tip.faces.size() && is_open(run) == is_open(0)) ++run;
  const double largest = kFarthestPair * tip.faces[run - 1].distance;
  std::vector<JumpSample> opening, slip;
  for (size_t i = 0; i < run; ++i) {
    const double r = tip.faces[i].distance;
    if (r < kNearestPair * tip.element || r > largest) continue;
    opening.push_back({r / largest, row(i)[C2D_UN2] - row(i)[C2D_UN1]});
    slip.push_back({r / largest, row(i)[C2D_UT2] - row(i)[C2D_UT1]});
  }
  const double scale = tip.modulus * std::sqrt(2 * std::acos(-1.0) / largest) / 8;
  out.K1 = is_open(0) ? none : 0;
  if (opening.size() < kFewestPairs) {
    out.why = "fewer than 6 pairs between three elements from the tip and 0.3 of its " +
              std::string(is_open(0) ? "open" : "closed") + " faces";
    return out;
  }
  if (is_open(0)) out.K1 = scale * leading_term(opening);
  out.K2 = scale * leading_term(slip);
  return out;
}

} // namespace app
