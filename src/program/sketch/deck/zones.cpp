// The zones of a deck from the contacts of a sketch (Pairing::run). Phases:
// 1. Make one or more rows of elements per contact, without the elements that the other side never comes near (add_pairs).
// 2. Find the end nodes of rows that supports hold (find_supports); free zones give them up when the deck is read.
// 3. Where two rows of second sides meet, assign their common node to one of them (part_neighbours). Rows whose elements
//    coincide with the elements opposite become matching zones if divisions are given or if two of them meet.
#include "program/sketch/deck/zones.hpp"

#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kSame = 1e-6;   // of a contact: lengths along an outline that differ by less are equal
constexpr double kBeside = 0.05; // of the facing part: margin of side 0

struct Element {
  Point from, to;
  double begin, end; // lengths along the outline
  const Curve* curve;
  bool is_far;       // never near the other side (MeshedCurve::far)
  bool is_given;     // by a statement `elements`
  int before, after; // neighbours along the outline; -1 at the ends of an open one
};
using Elements = std::vector<Element>; // of a body
using Numbers = std::vector<int>;      // of elements, from 0

Elements elements_of(const std::vector<MeshedOutline>& outlines) {
  Elements out;
  for (const MeshedOutline& outline : outlines) {
    const size_t first = out.size();
    for (const MeshedCurve& curve : outline.curves)
      for (size_t e = 0; e < curve.elements(); ++e) {
        const auto at = [&](size_t end) { return curve.curve->shape->at(curve.measure.u_at(curve.ends[end])); };
        const int number = static_cast<int>(out.size());
        const double middle = (curve.ends[e] + curve.ends[e + 1]) / 2, begin = curve.curve->begin;
        const bool far = std::any_of(curve.far.begin(), curve.far.end(),
                                     [&](const auto& f) { return f.first < middle && middle < f.second; });
        out.push_back({at(e), at(e + 1), begin + curve.ends[e], begin + curve.ends[e + 1], curve.curve, far, curve.given,
                       number - 1, number + 1});
      }
    out[first].before = outline.open ? -1 : static_cast<int>(out.size()) - 1;
    out.back().after = outline.open ? -1 : static_cast<int>(first);
  }
  return out;
}

// Groups elements into rows of consecutive ones along the outline. A row of the whole outline begins at its first element.
std::vector<Numbers> in_a_row(const Elements& elements, const Numbers& numbers) {
  std::vector<char> has(elements.size(), 0);
  for (const int e : numbers) has[static_cast<size_t>(e)] = 1;
  const auto is_in = [&](int e) { return e >= 0 && has[static_cast<size_t>(e)] == 1; };
  std::vector<Numbers> out;
  const auto follow = [&](int e) {
    out.emplace_back();
    for (; is_in(e); e = elements[static_cast<size_t>(e)].after) out.back().push_back(e), has[static_cast<size_t>(e)] = 2;
  };
  for (const int e : numbers)
    if (is_in(e) && elements[static_cast<size_t>(e)].before < 0) follow(e);
  for (const int e : numbers) {
    const int before = elements[static_cast<size_t>(e)].before;
    if (is_in(e) && has[static_cast<size_t>(before)] == 0) follow(e);
  }
  for (const int e : numbers)
    if (is_in(e)) follow(e);
  return out;
}

Stretch stretch(const Numbers& row) { return {row.front() + 1, row.back() + 1, static_cast<int>(row.size())}; }

class Pairing {
public:
  Pairing(const Sketch& sketch, const Mesh& mesh) : s_(sketch), given_(mesh.given) {
    for (const auto& outlines : mesh.bodies) elements_.push_back(elements_of(outlines));
  }
  std::vector<Zone> run();

private:
  struct Pair {
    size_t contact;
    Numbers one, two;
    bool matching = false, leaves[2] = {false, false}, whole[2] = {true, true};
    bool is_held = false; // at an end, by a support
    int given_up = 0;     // end nodes of a free zone
  };
  const Elements& body(size_t k, size_t side) const { return elements_[static_cast<size_t>(s_.contacts[k].side[side].body)]; }
  bool is_tied(size_t k) const { return s_.interfaces[s_.contacts[k].interface].tied; }
  Numbers side(size_t k, int which) const;
  void add_pairs(size_t k);
  std::array<double, 2> faced(size_t k, const Numbers& row) const;
  bool coincides(const Pair& pair) const;
  void part(Pair& stays, Pair& yields);
  void part_neighbours();
  bool is_at(const Pair& pair, double length, double place) const;
  void find_supports(Pair& pair) const;

  const Sketch& s_;
  bool given_;
  std::vector<Elements> elements_;
  std::vector<Pair> pairs_;
};

// The elements of a side in their order along the outline.
Numbers Pairing::side(size_t k, int which) const {
  Numbers numbers;
  const Elements& all = body(k, static_cast<size_t>(which));
  for (size_t e = 0; e < all.size(); ++e)
    if (all[e].curve->contact == static_cast<int>(k) && all[e].curve->side == which) numbers.push_back(static_cast<int>(e));
  return in_a_row(all, numbers)[0];
}

// The length on side 0 that faces a length on side 1.
double opposite_on(const Contact& contact, double length) {
  const auto above = std::find_if(contact.map.begin(), contact.map.end(), [&](const auto& p) { return p[1] >= length; });
  if (above == contact.map.begin()) return contact.map.front()[0];
  if (above == contact.map.end()) return contact.map.back()[0];
  const std::array<double, 2>&p = *(above - 1), &q = *above;
  return p[0] + (q[0] - p[0]) * (length - p[1]) / (q[1] - p[1]);
}

// The range of lengths on side 0 that faces a row of elements of side 1; for a ring, it may extend beyond the total length.
std::array<double, 2> Pairing::faced(size_t k, const Numbers& row) const {
  const Contact& contact = s_.contacts[k];
  const Contact::Strip& strip = contact.side[1];
  const auto turns = [&](double length) {
    return strip.round > 0 ? std::floor((length - strip.from) / strip.round + kSame) : 0.0;
  };
  const auto opposite = [&](double length) {
    if (contact.ring && turns(length) > 0) return opposite_on(contact, length - strip.round) - contact.side[0].round;
    return opposite_on(contact, length);
  };
  double begin = body(k, 1)[static_cast<size_t>(row.front())].begin, end = begin;
  for (const int e : row) end += body(k, 1)[static_cast<size_t>(e)].end - body(k, 1)[static_cast<size_t>(e)].begin;
  const double shift = strip.round * turns(begin);
  return {opposite(end - shift), opposite(begin - shift)};
}

// Omits far elements of side 1, unless all are far, and the opposite elements of side 0 except for a margin, because the mean
// curvature of side 0 affects the normals of all pairs (METHOD 8.3). If several rows remain, each element of side 0 is assigned
// to one of them.
void Pairing::add_pairs(size_t k) {
  const Contact& contact = s_.contacts[k];
  const Numbers first = side(k, 0), second = side(k, 1);
  Numbers near;
  for (const int e : second)
    if (!body(k, 1)[static_cast<size_t>(e)].is_far) near.push_back(e);
  if (near.empty() || near.size() == second.size()) return pairs_.push_back({k, first, second});
  const std::vector<Numbers> rows = in_a_row(body(k, 1), near);
  std::vector<Numbers> facing(rows.size());
  for (const int e : first) {
    const Element& own = body(k, 0)[static_cast<size_t>(e)];
    size_t best = rows.size();
    double most = 0;
    for (size_t r = 0; r < rows.size(); ++r) {
      const std::array<double, 2> range = faced(k, rows[r]);
      const double margin = kBeside * (range[1] - range[0]);
      for (const double round : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
        const double shift = round * contact.side[0].round;
        const double common = std::min(own.end + shift, range[1] + margin) - std::max(own.begin + shift, range[0] - margin);
        if (common > most) most = common, best = r;
      }
    }
    if (best < rows.size()) facing[best].push_back(e);
  }
  for (size_t r = 0; r < rows.size(); ++r)
    if (!facing[r].empty()) pairs_.push_back({k, in_a_row(body(k, 0), facing[r])[0], rows[r]});
}

// Do the elements of two elastic bodies coincide end by end, or are equal numbers of facing elements given by statements?
bool Pairing::coincides(const Pair& pair) const {
  const Elements &one = body(pair.contact, 0), &two = body(pair.contact, 1);
  if (&one == &two || pair.is_held || pair.one.size() != pair.two.size()) return false;
  for (int which = 0; which < 2; ++which) {
    const Numbers& numbers = which == 0 ? pair.one : pair.two;
    const size_t side = static_cast<size_t>(which);
    const int after = body(pair.contact, side)[static_cast<size_t>(numbers.back())].after;
    if (s_.bodies[static_cast<size_t>(s_.contacts[pair.contact].side[side].body)].rigid || numbers.front() > numbers.back() ||
        (after >= 0 && after <= numbers.back()))
      return false; // nodes are numbered along the outline: a matching zone cannot pass its end
  }
  const auto all_given = [](const Elements& all, const Numbers& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [&](int e) { return all[static_cast<size_t>(e)].is_given; });
  };
  if (all_given(one, pair.one) && all_given(two, pair.two)) return true;
  for (size_t i = 0; i < pair.one.size(); ++i) {
    const Element &a = one[static_cast<size_t>(pair.one[i])], &b = two[static_cast<size_t>(pair.two[pair.two.size() - 1 - i])];
    const double near = kJoint * length(a.to - a.from);
    if (length(a.from - b.to) > near || length(a.to - b.from) > near) return false;
  }
  return true;
}

// Two zones that adjoin on their second side share a node, which may belong to one pair only. If both are matching, `yields`
// gives up its end node. A free zone gives up its own when the deck is read.
void Pairing::part(Pair& stays, Pair& yields) {
  const Elements& all = body(stays.contact, 1);
  for (const bool at_end : {false, true}) {
    const int after = all[static_cast<size_t>((at_end ? yields : stays).two.back())].after;
    if (after != (at_end ? stays : yields).two.front()) continue;
    if ((stays.matching || coincides(stays)) && (yields.matching || coincides(yields)))
      stays.matching = yields.matching = yields.leaves[at_end ? 1 : 0] = true;
    else
      ++(yields.matching ? stays : yields).given_up;
  }
}

// The later zone yields, except a tie, which keeps its full length because its end may be a crack tip.
void Pairing::part_neighbours() {
  for (Pair& pair : pairs_) pair.matching = given_ && coincides(pair);
  for (size_t i = 0; i < pairs_.size(); ++i)
    for (size_t j = i + 1; j < pairs_.size(); ++j) {
      if (&body(pairs_[i].contact, 1) != &body(pairs_[j].contact, 1)) continue;
      const bool early = is_tied(pairs_[j].contact) && !is_tied(pairs_[i].contact);
      part(pairs_[early ? j : i], pairs_[early ? i : j]);
    }
  const auto has_none = [&](const Pair& p) { return p.given_up > static_cast<int>(p.two.size()) * s_.order; };
  pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), has_none), pairs_.end());
  std::stable_partition(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.matching; });
}

// Are two lengths on side 1 of the contact equal?
bool Pairing::is_at(const Pair& pair, double length, double place) const {
  const Contact::Strip& strip = s_.contacts[pair.contact].side[1];
  const double off = strip.round > 0 ? std::remainder(length - place, strip.round) : length - place;
  return std::fabs(off) < kSame * (strip.to - strip.from);
}

void Pairing::find_supports(Pair& pair) const {
  const Elements& all = body(pair.contact, 1);
  const Contact& contact = s_.contacts[pair.contact];
  const Numbers& two = pair.two;
  if (contact.ring) {
    pair.whole[0] = pair.whole[1] = two.size() == side(pair.contact, 1).size();
    return;
  }
  pair.whole[0] = is_at(pair, all[static_cast<size_t>(two.front())].begin, contact.side[1].from);
  pair.whole[1] = is_at(pair, all[static_cast<size_t>(two.back())].end, contact.side[1].to);
  for (const int end : {0, 1})
    if (contact.is_supported[end] && pair.whole[end]) pair.is_held = true, ++pair.given_up;
}

std::vector<Zone> Pairing::run() {
  for (size_t k = 0; k < s_.contacts.size(); ++k) add_pairs(k);
  for (Pair& pair : pairs_) find_supports(pair);
  part_neighbours();
  std::vector<Zone> out;
  for (const Pair& p : pairs_)
    out.push_back({&s_.contacts[p.contact],
                   stretch(p.one),
                   stretch(p.two),
                   p.matching,
                   {p.whole[0], p.whole[1]},
                   {p.leaves[0], p.leaves[1]}});
  return out;
}

} // namespace

std::vector<Stretch> stretches_of(const Mesh& mesh, const Side& side) {
  const Elements all = elements_of(mesh.bodies[static_cast<size_t>(side.body)]);
  Numbers numbers;
  for (size_t e = 0; e < all.size(); ++e)
    if (side.has(all[e].curve->name)) numbers.push_back(static_cast<int>(e));
  std::vector<Stretch> out;
  for (const Numbers& row : in_a_row(all, numbers)) out.push_back(stretch(row));
  return out;
}

std::vector<Zone> zones_of(const Sketch& sketch, const Mesh& mesh) { return Pairing(sketch, mesh).run(); }

} // namespace sketch
