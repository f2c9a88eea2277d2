// The contacts of a sketch (Cutter::run). Phases:
// 1. Build the chains of every side and find their facing parts (find). If bodies overlap by rounded coordinates, move one of
//    them and repeat (part_overlaps).
// 2. Divide stretches that belong to two parts by distance (settle, share); drop parts too far apart (drop_far_parts).
// 3. Choose the side with the contact conditions (side_of_pairs), make the contacts (contact_of), and extend their first sides
//    (go_beyond).
// 4. Divide the outlines at the ends of the contacts (cut).
#include "program/sketch/deck/contacts.hpp"

#include "program/sketch/facing.hpp"
#include "program/sketch/part_ends.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kTouches = 1e-3, kTieTouches = 0.01, kFitTouches = 0.05; // of the smaller body: largest overlaps
constexpr double kClear = 0.02;       // of the smaller body: smaller gaps are not checked for curves in between
constexpr double kBeyond = 0.05;      // of its part: extension of side 0 beyond the facing part
constexpr double kFar = 0.1;          // of their radii of curvature: a larger distance of the sides is far
constexpr double kOfWay = 0.4;        // of the distance to the next part: the largest extension
constexpr double kCrumb = 0.1;        // of its part: a shorter rest of a curve is included
constexpr double kOneOverlap = 1e-6;  // of the smaller part: shorter common stretches are ignored
constexpr double kLeastPiece = 1e-12; // of the outline
constexpr double kAtJoint = 1e-9;     // of the outline
constexpr double kDigits = 1e-13;     // of the smaller body: smaller overlaps are round-off
constexpr int kMostMoves = 4;         // of bodies that overlap by rounded coordinates
constexpr int kChords = 36;           // chords of a curve that may lie between two sides

double size_of_body(const Body& body) {
  double out = 0;
  for (const Outline& outline : body.outlines) out = std::max(out, size_of(polygon_of(outline)));
  return out;
}

// Displacements prescribed at a place of an outline, by statements on the curves there.
struct Support {
  bool along[2] = {false, false};
  bool any() const { return along[0] || along[1]; }
};

// A facing part: a run of facing points and the state of its ends.
struct FacingPart {
  size_t interface = 0;
  FacingRun run;
  bool shared[2] = {false, false}; // is an end shared with another part? In the order of the points
  double length(size_t side) const { return run.length(side); }
};

class Cutter {
public:
  explicit Cutter(Sketch& sketch) : s_(sketch) {}
  std::vector<Fault> run();

private:
  const Body& body(int b) const { return s_.bodies[static_cast<size_t>(b)]; }
  // Lengths along an outline where its curves begin, and its total length.
  const std::vector<double>& begins(int b, size_t outline) const { return begins_[static_cast<size_t>(b)][outline]; }
  // The total length of a closed outline; 0 for an open one.
  double round_of(const Chain& chain) const {
    return body(chain.body()).outlines[chain.outline()].open ? 0 : begins(chain.body(), chain.outline()).back();
  }
  FacingLimits limits_of(const Interface& interface, const Chain& a, const Chain& b) const;
  void find(size_t interface);
  bool part_overlaps();
  std::string why(const Interface& interface, const std::vector<Chain>& a, const std::vector<Chain>& b) const;
  bool settle(FacingPart& p, FacingPart& q);
  void drop_far_parts();
  bool share(FacingPart& p, size_t side, FacingPart& q, size_t other);
  Support support_at(const Chain& chain, double length) const;
  bool is_supported(const FacingPart& part, size_t side) const;
  size_t side_of_pairs(const FacingPart& part);
  Contact contact_of(const FacingPart& part, size_t pairs) const;
  void go_beyond(const FacingPart& part, size_t pairs, Contact& contact) const;
  void cut(int body, size_t outline);
  bool has_pieces(size_t contact, int side) const;

  Sketch& s_;
  std::vector<std::vector<std::vector<double>>> begins_;
  std::vector<std::array<std::vector<Chain>, 2>> chains_; // of every interface
  std::vector<FacingPart> parts_;
  std::vector<Fault> faults_;
};

FacingLimits Cutter::limits_of(const Interface& interface, const Chain& a, const Chain& b) const {
  const double size = std::min(size_of_body(body(a.body())), size_of_body(body(b.body())));
  FacingLimits out;
  out.overlap = (s_.interference ? kFitTouches : interface.tied ? kTieTouches : kTouches) * size;
  out.clear = kClear * size;
  for (const Body& one : s_.bodies)
    for (const Outline& outline : one.outlines)
      for (const Curve& curve : outline.curves) {
        const auto is_on = [&](const Chain& chain) {
          return std::count(chain.curves().begin(), chain.curves().end(), &curve) > 0;
        };
        if (is_on(a) || is_on(b)) continue;
        const int n = curve.shape->form() == Form::kLine ? 1 : kChords + curve.shape->pieces();
        for (int i = 0; i < n; ++i)
          out.others.push_back({curve.shape->at(static_cast<double>(i) / n), curve.shape->at(static_cast<double>(i + 1) / n)});
      }
  return out;
}

std::string names_of(const Body& body, const Side& side) {
  std::string out = body.name + ".";
  for (size_t i = 0; i < side.names.size(); ++i) out += (i == 0 ? "" : "+") + side.names[i];
  return out;
}

// The message for two sides without facing parts.
std::string Cutter::why(const Interface& interface, const std::vector<Chain>& a, const std::vector<Chain>& b) const {
  double inclination = 180, gap = HUGE_VAL;
  Point at;
  for (const Chain& one : a)
    for (const Chain& two : b) {
      inclination = std::min(inclination, least_inclination(one, two));
      for (const auto& [from, to] : {std::pair(&one, &two), std::pair(&two, &one)})
        for (const SurfacePoint& p : from->samples())
          for (size_t i = 0; i < to->samples().size(); ++i) {
            if (!to->continues(i)) continue;
            const Point q = to->samples()[i].at, way = to->samples()[i + 1].at - q;
            const double part = dot(way, way) > 0 ? std::clamp(dot(p.at - q, way) / dot(way, way), 0.0, 1.0) : 0;
            if (const double d = sketch::length(p.at - q - part * way); d < gap) gap = d, at = p.at;
          }
    }
  const std::string one = names_of(body(interface.side[0].body), interface.side[0]),
                    two = names_of(body(interface.side[1].body), interface.side[1]);
  bool corner = false; // is the nearest point a convex corner?
  for (const std::vector<Chain>* chains : {&a, &b})
    for (const Chain& chain : *chains)
      for (const SurfacePoint& p : chain.samples())
        corner = corner || (chain.is_fan(p.place) && sketch::length(p.at - at) <= kAtJoint * chain.length());
  const std::string nearest = "their smallest distance is " + rounded(gap) + " at (" + rounded(at.x) + ", " + rounded(at.y) +
                              ")" + (corner ? ", a corner; add a fillet if contact is expected there" : "");
  const std::string none = "no part of " + one + " faces " + two + ": ";
  if (inclination > 90) return none + "their outward normals point the same way; " + nearest;
  if (inclination > 50)
    return none + "they are inclined to each other by " + rounded(std::round(inclination)) +
           " degrees or more, expected less than 50 degrees at some place; " + nearest;
  return none +
         "they lie beside each other, or farther apart than their radii of curvature, or another curve lies between them; " +
         nearest;
}

void Cutter::find(size_t index) {
  const Interface& interface = s_.interfaces[index];
  const std::vector<Chain>&a = chains_[index][0], &b = chains_[index][1];
  const size_t before = parts_.size();
  for (const Chain& one : a)
    for (const Chain& two : b) {
      if (one.curves() == two.curves()) continue;
      for (FacingRun& run : facing_runs(one, two, limits_of(interface, one, two)))
        parts_.push_back({index, std::move(run), {false, false}});
    }
  if (parts_.size() == before) faults_.push_back({interface.at, why(interface, a, b)});
}

// Removes an overlap from rounded coordinates (kOverlap of outline.cpp) by moving one of the bodies. Was there one?
bool Cutter::part_overlaps() {
  for (const FacingPart& part : parts_) {
    const Interface& interface = s_.interfaces[part.interface];
    if (s_.interference || interface.tied) continue;
    const std::vector<FacingPoints>& points = part.run.points;
    const auto deepest =
        std::min_element(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.gap < q.gap; });
    const int one = interface.side[0].body, two = interface.side[1].body;
    const double size = std::min(size_of_body(body(one)), size_of_body(body(two)));
    if (deepest->gap >= -kDigits * size || one == two) continue;
    // A body on a line of symmetry may not leave it.
    const auto goes = [&](int b, Point way) {
      for (const Outline& outline : body(b).outlines)
        for (size_t axis = 0; axis < 2 && outline.open; ++axis)
          if (s_.symmetry[axis] && std::fabs(axis == 0 ? way.x : way.y) > kDigits * size) return false;
      return true;
    };
    const Point normal = deepest->normal[0] - deepest->normal[1];
    const Point way = (-deepest->gap * (1 + 1e-9) / length(normal)) * normal;
    const int moves = goes(two, way) ? two : one;
    Motion motion;
    motion.x0 = moves == two ? way.x : -way.x, motion.y0 = moves == two ? way.y : -way.y;
    for (Outline& outline : s_.bodies[static_cast<size_t>(moves)].outlines)
      for (Curve& curve : outline.curves) curve.shape = moved(curve.shape, motion);
    return true;
  }
  return false;
}

// ---- stretches of an outline that belong to two parts ----

// The gap of a part at a length on one side, and the interpolated index of the point there.
double gap_at(const FacingRun& run, size_t side, double length, double& number) {
  const std::vector<FacingPoints>& p = run.points;
  for (size_t i = 0; i + 1 < p.size(); ++i) {
    const double from = p[i].length[side], to = p[i + 1].length[side];
    if (from == to || (length - from) * (length - to) > 0) continue;
    const double f = (length - from) / (to - from);
    number = static_cast<double>(i) + f;
    return std::fabs(p[i].gap + f * (p[i + 1].gap - p[i].gap));
  }
  const bool low = (side == 0) == (length <= run.low(side));
  number = low ? 0 : static_cast<double>(p.size() - 1);
  return std::fabs(low ? p.front().gap : p.back().gap);
}

// Cuts a run at an interpolated index and keeps the part before or after it.
void trim(FacingPart& part, double number, bool keeps_before) {
  std::vector<FacingPoints>& p = part.run.points;
  const double least = kOneOverlap * std::max(part.length(0), part.length(1)); // of what is left
  const size_t i = std::min(static_cast<size_t>(number), p.size() - 2);
  const double f = number - static_cast<double>(i);
  FacingPoints at = p[f < 0.5 ? i : i + 1];
  for (size_t side = 0; side < 2; ++side) at.length[side] = p[i].length[side] + f * (p[i + 1].length[side] - p[i].length[side]);
  at.gap = p[i].gap + f * (p[i + 1].gap - p[i].gap);
  const auto here = p.begin() + static_cast<std::ptrdiff_t>(i) + 1;
  if (keeps_before)
    p.erase(here, p.end()), p.push_back(at);
  else
    p.erase(p.begin(), here), p.insert(p.begin(), at);
  part.run.ring = false;
  part.shared[keeps_before ? 1 : 0] = true;
  if (std::max(part.length(0), part.length(1)) <= least) p.clear();
}

// Divides a stretch that belongs to two parts: each part keeps the points that are nearer to its other side. Was there one?
bool Cutter::share(FacingPart& p, size_t side, FacingPart& q, size_t other) {
  const Chain &a = *p.run.chain[side], &b = *q.run.chain[other];
  if (a.body() != b.body() || a.outline() != b.outline()) return false;
  const double least = kOneOverlap * std::min({p.length(0), p.length(1), q.length(0), q.length(1)});
  for (int round = -2; round <= 2; ++round) {
    const double shift = round * round_of(a); // of q's lengths
    const double low = std::max(p.run.low(side), q.run.low(other) + shift),
                 high = std::min(p.run.high(side), q.run.high(other) + shift);
    if (high - low < least) continue;
    std::vector<double> at{low, high};
    for (const FacingPoints& point : p.run.points) at.push_back(point.length[side]);
    for (const FacingPoints& point : q.run.points) at.push_back(point.length[other] + shift);
    at.erase(std::remove_if(at.begin(), at.end(), [&](double x) { return x < low || x > high; }), at.end());
    std::sort(at.begin(), at.end());
    double number[2], before = 0, sum = 0;
    const auto more = [&](double x) {
      const double of_p = gap_at(p.run, side, x, number[0]);
      return of_p - gap_at(q.run, other, x - shift, number[1]);
    };
    for (size_t i = 0; i < at.size(); ++i) {
      const double now = more(at[i]);
      sum += now;
      if (i > 0 && before != 0 && now != 0 && (before < 0) != (now < 0)) {
        more(at[i - 1] + (at[i] - at[i - 1]) * before / (before - now));
        trim(p, number[0], (before < 0) == (side == 0));
        trim(q, number[1], (before > 0) == (other == 0));
        return true;
      }
      before = now == 0 ? before : now;
    }
    FacingPart& yields = sum > 0 ? p : q; // it keeps the larger of its remaining ends
    double ends[2];
    for (size_t k = 0; k < 2; ++k) {
      more(k == 0 ? low : high);
      ends[k] = number[sum > 0 ? 0 : 1];
    }
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
    const double behind = static_cast<double>(yields.run.points.size() - 1) - ends[1];
    trim(yields, ends[0] > behind ? ends[0] : ends[1], ends[0] > behind);
    return true;
  }
  return false;
}

// Drops parts that depend on their own mean curvatures, and finds fault where an interface has no other.
void Cutter::drop_far_parts() {
  std::vector<size_t> left(s_.interfaces.size()), dropped(s_.interfaces.size());
  std::vector<FacingPart> kept;
  for (FacingPart& p : parts_) {
    const auto& [one, two] = p.run.chain;
    const bool stays = agree_with_curvatures(p.run, limits_of(s_.interfaces[p.interface], *one, *two));
    ++(stays ? left : dropped)[p.interface];
    if (stays) kept.push_back(std::move(p));
  }
  parts_ = std::move(kept);
  for (size_t k = 0; k < s_.interfaces.size(); ++k)
    if (left[k] == 0 && dropped[k] > 0)
      faults_.push_back({s_.interfaces[k].at, why(s_.interfaces[k], chains_[k][0], chains_[k][1])});
}

bool Cutter::settle(FacingPart& p, FacingPart& q) {
  for (const size_t side : {size_t{0}, size_t{1}})
    for (const size_t other : {size_t{0}, size_t{1}})
      if (!p.run.points.empty() && !q.run.points.empty() && share(p, side, q, other)) return true;
  return false;
}

// ---- the side with the contact conditions ----

Support Cutter::support_at(const Chain& chain, double length) const {
  Support out;
  const Outline& outline = body(chain.body()).outlines[chain.outline()];
  const std::vector<double>& begins = this->begins(chain.body(), chain.outline());
  const double whole = begins.back(), near = kAtJoint * whole;
  for (size_t i = 0; i < outline.curves.size(); ++i) {
    const auto is_at = [&](double from, double to) {
      for (const double x : {length - whole, length, length + whole})
        if ((x == length || !outline.open) && x > from - near && x < to + near) return true;
      return false;
    };
    const auto note = [&](const Side& side, Condition::Part part, bool x, bool y) {
      if (side.body != chain.body() || !side.has(outline.curves[i].name)) return;
      if (!is_at(part == Condition::kEnd ? begins[i + 1] : begins[i], part == Condition::kStart ? begins[i] : begins[i + 1]))
        return;
      out.along[0] |= x, out.along[1] |= y;
    };
    for (const Condition& c : s_.conditions)
      if (c.kind == Condition::kDisplacement) note(c.side, c.part, c.value[0].has_value(), c.value[1].has_value());
    for (const Drive& d : s_.drives)
      if (d.side) note(*d.side, Condition::kAll, true, true);
  }
  return out;
}

bool Cutter::is_supported(const FacingPart& part, size_t side) const {
  for (const FacingPoints* p : {&part.run.points.front(), &part.run.points.back()})
    if (support_at(*part.run.chain[side], p->length[side]).any()) return true;
  return false;
}

// Not the side of a rigid body, nor a side that ends at a support if the other does not; otherwise the second.
size_t Cutter::side_of_pairs(const FacingPart& part) {
  const bool rigid[2] = {body(part.run.chain[0]->body()).rigid, body(part.run.chain[1]->body()).rigid};
  if (rigid[0] || rigid[1]) return rigid[1] ? 0 : 1;
  return is_supported(part, 1) && !is_supported(part, 0) ? 0 : 1;
}

Contact Cutter::contact_of(const FacingPart& part, size_t pairs) const {
  Contact out;
  out.interface = part.interface;
  out.ring = part.run.ring, out.turned = pairs == 0;
  const std::vector<FacingPoints>& points = part.run.points;
  for (size_t k = 0; k < 2; ++k) {
    const size_t side = k == 1 ? pairs : 1 - pairs;
    const Chain& chain = *part.run.chain[side];
    out.side[k] = {chain.body(), chain.outline(), part.run.low(side), part.run.high(side), round_of(chain)};
  }
  for (const FacingPoints& p : points) out.map.push_back({p.length[1 - pairs], p.length[pairs]});
  if (pairs == 1) std::reverse(out.map.begin(), out.map.end());
  for (size_t end = 0; end < 2 && !out.ring; ++end) {
    const std::array<double, 2>& at = end == 0 ? out.map.front() : out.map.back();
    const Support own = support_at(*part.run.chain[pairs], at[1]), other = support_at(*part.run.chain[1 - pairs], at[0]);
    const bool as_symmetry = own.along[0] == other.along[0] && own.along[1] == other.along[1] && own.along[0] != own.along[1];
    out.is_supported[end] = own.any() && !as_symmetry;
    const bool last = (end == 1) == (pairs == 0); // of the points
    if (!part.shared[last ? 1 : 0]) out.ends[end] = end_of_part(s_, part.run, last);
  }
  return out;
}

// Are the sides far apart for how they bend?
bool is_far(const FacingRun& run) {
  double gap = HUGE_VAL, bend[2] = {0, 0};
  for (size_t i = 0; i < run.points.size(); ++i) {
    gap = std::min(gap, std::fabs(run.points[i].gap));
    for (size_t side = 0; side < 2 && i > 0; ++side)
      bend[side] += std::fabs(angle_between(run.points[i - 1].normal[side], run.points[i].normal[side]));
  }
  return gap * bend[0] > kFar * run.length(0) || gap * bend[1] > kFar * run.length(1);
}

// Extends side 0 slightly beyond the facing part, within its chain and away from other parts. Of sides that are far apart what
// faces what depends on their mean curvatures, so they stay as they are.
void Cutter::go_beyond(const FacingPart& part, size_t pairs, Contact& contact) const {
  if (contact.ring || is_far(part.run)) return;
  Contact::Strip& strip = contact.side[0];
  const size_t side = 1 - pairs;
  const Chain& chain = *part.run.chain[side];
  const double length = strip.to - strip.from;
  const auto room = [&](double at, double way) { // distance to the next part
    double least = HUGE_VAL;
    for (const FacingPart& other : parts_)
      for (size_t k = 0; k < 2; ++k) {
        const Chain& c = *other.run.chain[k];
        if ((&other == &part && k == side) || c.body() != strip.body || c.outline() != strip.outline) continue;
        for (const double place : {other.run.low(k), other.run.high(k)})
          for (int times = -2; times <= 2; ++times)
            if (const double d = way * (place + times * strip.round - at); d > -kAtJoint * length) least = std::min(least, d);
      }
    return std::max(least, 0.0);
  };
  const auto beyond = [&](double at, double way, bool shared) {
    double out = std::min(shared ? 0.0 : kBeyond * length, kOfWay * room(at, way));
    if (chain.closed()) return std::min(out, kOfWay * (strip.round - length));
    if (out > 0)
      for (const double joint : chain.joints())
        if (const double rest = way * (joint - at) - out; rest > 0 && rest < kCrumb * length) out += rest;
    return std::min({out, way > 0 ? chain.end() - at : at - chain.begin(), kOfWay * room(at, way)});
  };
  const size_t low = side == 0 ? 0 : 1; // the end of the points at the start of the strip
  const double from = beyond(strip.from, -1, part.shared[low]), to = beyond(strip.to, 1, part.shared[1 - low]);
  strip.from -= from, strip.to += to;
}

// ---- division of the outlines ----

// Assigns a piece to the contact and side whose strip contains a length.
void find_contact(const std::vector<Contact>& contacts, int body, size_t outline, double length, Curve& piece) {
  for (size_t k = 0; k < contacts.size(); ++k)
    for (size_t side = 0; side < 2; ++side) {
      const Contact::Strip& strip = contacts[k].side[side];
      if (strip.body != body || strip.outline != outline) continue;
      for (int times = -2; times <= 2; ++times)
        if (const double x = length + times * strip.round; x > strip.from && x < strip.to)
          piece.contact = static_cast<int>(k), piece.side = static_cast<int>(side);
    }
}

void Cutter::cut(int b, size_t number) {
  Outline& outline = s_.bodies[static_cast<size_t>(b)].outlines[number];
  struct Cut {
    double at, least; // a cut nearer than `least` to another cut or a joint is dropped
    bool operator<(const Cut& other) const { return at < other.at; }
  };
  std::vector<Cut> cuts;
  const double whole = begins(b, number).back();
  for (const Contact& contact : s_.contacts)
    for (const Contact::Strip& strip : contact.side)
      if (strip.body == b && strip.outline == number && !contact.ring)
        for (const double place : {strip.from, strip.to})
          cuts.push_back({place - whole * std::floor(place / whole),
                          std::max(kLeastPiece * whole, kOneOverlap * (strip.to - strip.from))});
  std::sort(cuts.begin(), cuts.end());
  std::vector<Curve> out;
  double begin = 0;
  for (const Curve& curve : outline.curves) {
    const Measure measure(curve.shape);
    std::vector<double> ends(1, 0.0);
    for (const Cut& cut : cuts)
      if (cut.at - begin - ends.back() > cut.least && begin + measure.length() - cut.at > cut.least)
        ends.push_back(cut.at - begin);
    ends.push_back(measure.length());
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
      Curve piece = curve;
      if (ends.size() > 2) piece.shape = part(curve.shape, measure.u_at(ends[i]), measure.u_at(ends[i + 1]));
      piece.begin = begin + ends[i];
      piece.is_first = i == 0, piece.is_last = i + 2 == ends.size();
      find_contact(s_.contacts, b, number, begin + (ends[i] + ends[i + 1]) / 2, piece);
      out.push_back(piece);
    }
    begin += measure.length();
  }
  outline.curves = std::move(out);
}

bool Cutter::has_pieces(size_t contact, int side) const {
  const Contact::Strip& strip = s_.contacts[contact].side[side];
  const std::vector<Curve>& curves = body(strip.body).outlines[strip.outline].curves;
  return std::any_of(curves.begin(), curves.end(),
                     [&](const Curve& curve) { return curve.contact == static_cast<int>(contact) && curve.side == side; });
}

std::vector<Fault> Cutter::run() {
  for (const Body& body : s_.bodies) {
    begins_.push_back({});
    for (const Outline& outline : body.outlines) {
      begins_.back().push_back({0.0});
      for (const Curve& curve : outline.curves)
        begins_.back().back().push_back(begins_.back().back().back() + Measure(curve.shape).length());
    }
  }
  for (int moves = 0; moves == 0 || (moves <= kMostMoves && part_overlaps()); ++moves) {
    chains_.clear(), parts_.clear();
    for (const Interface& interface : s_.interfaces)
      chains_.push_back({chains_of(s_, interface.side[0]), chains_of(s_, interface.side[1])});
    for (size_t k = 0; k < s_.interfaces.size(); ++k) find(k);
  }
  if (!faults_.empty()) return faults_;
  for (size_t i = 0; i < parts_.size(); ++i)
    for (size_t k = 0; k < i; ++k)
      for (int round = 0; round < 8 && settle(parts_[i], parts_[k]);) ++round;
  const auto is_empty = [](const FacingPart& p) { return p.run.points.empty(); };
  parts_.erase(std::remove_if(parts_.begin(), parts_.end(), is_empty), parts_.end());
  drop_far_parts();
  if (!faults_.empty()) return faults_;
  for (const FacingPart& part : parts_) {
    const size_t pairs = side_of_pairs(part);
    Contact contact = contact_of(part, pairs);
    go_beyond(part, pairs, contact);
    s_.contacts.push_back(std::move(contact));
  }
  for (size_t b = 0; b < s_.bodies.size(); ++b)
    for (size_t o = 0; o < s_.bodies[b].outlines.size(); ++o) cut(static_cast<int>(b), o);
  for (size_t k = 0; k < s_.contacts.size(); ++k)
    if (const Interface& interface = s_.interfaces[s_.contacts[k].interface]; !has_pieces(k, 0) || !has_pieces(k, 1))
      faults_.push_back({interface.at, "the facing part of " + names_of(body(interface.side[0].body), interface.side[0]) +
                                           " and " + names_of(body(interface.side[1].body), interface.side[1]) +
                                           " is shorter than 1e-12 of the outline, expected a longer one"});
  return faults_;
}

} // namespace

std::vector<Fault> cut_contacts(Sketch& sketch) { return Cutter(sketch).run(); }

} // namespace sketch
