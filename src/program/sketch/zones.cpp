#include "program/sketch/zones.hpp"

#include "program/sketch/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kNear = 1e-3; // of an element: where its direction at an end is seen from there
constexpr double kOpen = 0.6;  // the least cosine of the angle between surfaces that may touch
constexpr size_t kBeside = 2;  // elements of side 1 that are kept beside what side 2 faces

struct Element {
  Point from, to;
  Point along[2]; // the curve's direction at its ends
  const std::string* curve;
  bool is_far;       // from all that it might touch
  int before, after; // along the outline; -1 where an open one ends
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
        const auto near = [&](double share) {
          return curve.curve->shape->at(curve.measure.u_at(curve.ends[e] + share * (curve.ends[e + 1] - curve.ends[e])));
        };
        const int number = static_cast<int>(out.size());
        const Point from = at(e), to = at(e + 1);
        const double middle = (curve.ends[e] + curve.ends[e + 1]) / 2;
        const bool far = std::any_of(curve.far.begin(), curve.far.end(),
                                     [&](const auto& f) { return f.first < middle && middle < f.second; });
        out.push_back({from, to, {near(kNear) - from, to - near(1 - kNear)}, &curve.curve->name, far, number - 1, number + 1});
      }
    out[first].before = outline.open ? -1 : static_cast<int>(out.size()) - 1;
    out.back().after = outline.open ? -1 : static_cast<int>(first);
  }
  return out;
}

// Numbers that follow each other along the outline. Those that go all round begin at the outline's first element.
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

// Elements that others may face.
class Wall {
public:
  Wall(const Elements& elements, const Numbers& numbers)
      : elements_(elements), numbers_(numbers), has_(elements.size(), false) {
    for (const int e : numbers) has_[static_cast<size_t>(e)] = true;
  }
  // How far an element is from it; infinitely, where the surfaces do not face each other: their normals are more than kOpen
  // from opposite, or the way across ends beside the wall.
  double gap_to(const Element& own) const {
    double most = 0;
    for (int end = 0; end < 2; ++end) {
      const Foot foot = nearest(end == 0 ? own.from : own.to);
      const Point along = own.along[end];
      const double opposite = -dot(foot.along, along) / (length(foot.along) * length(along));
      if (!foot.within || opposite < kOpen) return HUGE_VAL;
      most = std::max(most, foot.gap);
    }
    return most;
  }
  double distance(Point p) const { return nearest(p).gap; }
  int nearest_element(Point p) const { return nearest(p).element; }

private:
  struct Foot {
    double gap = HUGE_VAL;
    Point along;
    bool within = false;
    int element = 0;
  };
  bool goes_on(int e) const { return e < 0 || has_[static_cast<size_t>(e)]; } // as its own image behind a line of symmetry
  Foot nearest(Point p) const {
    Foot foot;
    for (const int e : numbers_) {
      const Element& w = elements_[static_cast<size_t>(e)];
      const Point d = w.to - w.from;
      const double t = dot(p - w.from, d) / dot(d, d), gap = length(p - (w.from + std::clamp(t, 0.0, 1.0) * d));
      if (gap >= foot.gap * (1 - 1e-12)) continue;
      foot = {gap, d, (goes_on(w.before) || t > -1e-6) && (goes_on(w.after) || t < 1 + 1e-6), e};
    }
    return foot;
  }
  const Elements& elements_;
  const Numbers& numbers_;
  std::vector<bool> has_;
};

// What an element takes part in: the interface that is nearest there.
struct ZonePart {
  size_t interface = 0;
  int side = -1; // 0: that of side 1 of the zones, 1: the other; -1: none
  double gap = HUGE_VAL;
};

class Pairing {
public:
  Pairing(const Sketch& sketch, const Mesh& mesh) : s_(sketch) {
    for (const auto& outlines : mesh.bodies) {
      elements_.push_back(elements_of(outlines));
      parts_.emplace_back(elements_.back().size());
    }
  }
  std::vector<Zone> run();

private:
  const Side& side(size_t k, int which) const {
    const Interface& interface = s_.interfaces[k];
    return interface.side[which == 0 ? first_side(s_, interface) : 1 - first_side(s_, interface)];
  }
  const Elements& body(size_t k, int which) const { return elements_[static_cast<size_t>(side(k, which).body)]; }
  Numbers named(size_t k, int which) const;
  Numbers chosen(size_t k, int which) const;
  void choose(size_t k);
  void join(size_t k);
  void share(size_t k, const Numbers& first, const std::vector<Numbers>& seconds);
  Numbers faced(size_t k, const Numbers& first, const Numbers& second) const;
  struct Pair {
    size_t interface;
    Numbers one, two;
    bool matching = false, leaves[2] = {false, false};
  };
  bool coincides(const Pair& pair) const;
  void part(Pair& stays, Pair& yields);
  void part_neighbours();

  const Sketch& s_;
  std::vector<Elements> elements_;
  std::vector<std::vector<ZonePart>> parts_; // of every body's elements
  std::vector<Pair> pairs_;
};

Numbers Pairing::named(size_t k, int which) const {
  Numbers out;
  const Elements& all = body(k, which);
  for (size_t e = 0; e < all.size(); ++e)
    if (side(k, which).has(*all[e].curve)) out.push_back(static_cast<int>(e));
  return out;
}

Numbers Pairing::chosen(size_t k, int which) const {
  Numbers out;
  for (const int e : named(k, which)) {
    const ZonePart& part = parts_[static_cast<size_t>(side(k, which).body)][static_cast<size_t>(e)];
    if (part.side == which && part.interface == k) out.push_back(e);
  }
  return out;
}

// An element is in one zone: that of the interface whose other side is nearest. What is far is left out, but where nothing else
// faces the other side: on a finer mesh it may touch.
void Pairing::choose(size_t k) {
  const Numbers numbers[2] = {named(k, 0), named(k, 1)};
  const Wall walls[2] = {Wall(body(k, 1), numbers[1]), Wall(body(k, 0), numbers[0])};
  const bool all = std::none_of(numbers[1].begin(), numbers[1].end(), [&](int e) {
    const Element& own = body(k, 1)[static_cast<size_t>(e)];
    return !own.is_far && walls[1].gap_to(own) < HUGE_VAL;
  });
  for (int which = 0; which < 2; ++which)
    for (const int e : numbers[which]) {
      const Element& own = body(k, which)[static_cast<size_t>(e)];
      if (which == 1 && own.is_far && !all) continue;
      const double gap = which == 1 ? walls[1].gap_to(own) : walls[0].distance(0.5 * (own.from + own.to));
      ZonePart& part = parts_[static_cast<size_t>(side(k, which).body)][static_cast<size_t>(e)];
      if (gap < part.gap) part = {k, which, gap};
    }
}

// Stretches of the first side, and what of the second faces them.
void Pairing::join(size_t k) {
  const Numbers first = chosen(k, 0), second = chosen(k, 1);
  const std::vector<Numbers> rows = in_a_row(body(k, 0), first);
  std::vector<Numbers> facing(rows.size());
  std::vector<Wall> walls;
  for (const Numbers& row : rows) walls.emplace_back(body(k, 0), row);
  for (const int e : second) {
    size_t best = 0;
    double least = HUGE_VAL;
    for (size_t r = 0; r < rows.size(); ++r)
      if (const double gap = walls[r].gap_to(body(k, 1)[static_cast<size_t>(e)]); gap < least) least = gap, best = r;
    if (least < HUGE_VAL) facing[best].push_back(e);
  }
  for (size_t r = 0; r < rows.size(); ++r) share(k, rows[r], in_a_row(body(k, 1), facing[r]));
}

// What of a stretch is nearest to each of those that it faces, as two feet stand on one floor: an element is in one zone.
void Pairing::share(size_t k, const Numbers& first, const std::vector<Numbers>& seconds) {
  if (seconds.empty()) return;
  if (seconds.size() == 1) return pairs_.push_back({k, faced(k, first, seconds[0]), seconds[0]});
  std::vector<Wall> walls;
  for (const Numbers& row : seconds) walls.emplace_back(body(k, 1), row);
  std::vector<Numbers> near(seconds.size());
  for (const int e : first) {
    const Element& own = body(k, 0)[static_cast<size_t>(e)];
    const auto nearer = [middle = 0.5 * (own.from + own.to)](const Wall& a, const Wall& b) {
      return a.distance(middle) < b.distance(middle);
    };
    near[static_cast<size_t>(std::min_element(walls.begin(), walls.end(), nearer) - walls.begin())].push_back(e);
  }
  for (size_t n = 0; n < seconds.size(); ++n) {
    const std::vector<Numbers> parts = in_a_row(body(k, 0), near[n]);
    if (parts.empty()) continue;
    const Numbers& part =
        *std::max_element(parts.begin(), parts.end(), [](const Numbers& a, const Numbers& b) { return a.size() < b.size(); });
    const Wall wall(body(k, 0), part);
    Numbers facing;
    for (const int e : seconds[n])
      if (wall.gap_to(body(k, 1)[static_cast<size_t>(e)]) < HUGE_VAL) facing.push_back(e);
    for (const Numbers& row : in_a_row(body(k, 1), facing)) pairs_.push_back({k, faced(k, part, row), row});
  }
}

// The part of a stretch that another faces, and a little more: what is round beside it would turn the frames of the pairs.
Numbers Pairing::faced(size_t k, const Numbers& first, const Numbers& second) const {
  const Elements &one = body(k, 0), &two = body(k, 1);
  if (one[static_cast<size_t>(first.back())].after == first.front()) return first;
  const Wall wall(one, first);
  size_t low = first.size(), high = 0;
  for (const int e : second)
    for (const Point p : {two[static_cast<size_t>(e)].from, two[static_cast<size_t>(e)].to}) {
      const auto at = static_cast<size_t>(std::find(first.begin(), first.end(), wall.nearest_element(p)) - first.begin());
      low = std::min(low, at), high = std::max(high, at);
    }
  low = low > kBeside ? low - kBeside : 0, high = std::min(high + kBeside, first.size() - 1);
  return Numbers(first.begin() + static_cast<std::ptrdiff_t>(low), first.begin() + static_cast<std::ptrdiff_t>(high) + 1);
}

// Do the elements of two elastic bodies lie on each other, end by end?
bool Pairing::coincides(const Pair& pair) const {
  const Elements &one = body(pair.interface, 0), &two = body(pair.interface, 1);
  if (&one == &two || pair.one.size() != pair.two.size()) return false;
  for (int which = 0; which < 2; ++which) {
    const Numbers& numbers = which == 0 ? pair.one : pair.two;
    const int after = body(pair.interface, which)[static_cast<size_t>(numbers.back())].after;
    if (s_.bodies[static_cast<size_t>(side(pair.interface, which).body)].rigid || numbers.front() > numbers.back() ||
        (after >= 0 && after <= numbers.back()))
      return false; // nodes are numbered along the outline: not round its end
  }
  for (size_t i = 0; i < pair.one.size(); ++i) {
    const Element &a = one[static_cast<size_t>(pair.one[i])], &b = two[static_cast<size_t>(pair.two[pair.two.size() - 1 - i])];
    const double near = kJoint * length(a.to - a.from);
    if (length(a.from - b.to) > near || length(a.to - b.from) > near) return false;
  }
  return true;
}

// Two zones that adjoin on their second side: nodes are in one pair. Of zones that coincide one leaves its last node to the
// other; else its last element, which then carries nothing.
void Pairing::part(Pair& stays, Pair& yields) {
  const Elements& all = body(stays.interface, 1);
  for (const bool at_end : {false, true}) {
    if (stays.two.empty() || yields.two.empty()) return;
    const int after = all[static_cast<size_t>((at_end ? yields : stays).two.back())].after;
    if (after != (at_end ? stays : yields).two.front()) continue;
    if ((stays.matching || coincides(stays)) && (yields.matching || coincides(yields))) {
      stays.matching = yields.matching = yields.leaves[at_end ? 1 : 0] = true;
      continue;
    }
    const auto shorten = [](Numbers& numbers, bool back) { numbers.erase(back ? numbers.end() - 1 : numbers.begin()); };
    shorten(yields.two, at_end);
    if (yields.matching) shorten(yields.one, !at_end), yields.leaves[at_end ? 1 : 0] = false;
  }
}

// The later one yields, but for a tie, which goes on to its end: that may be the tip of a crack.
void Pairing::part_neighbours() {
  for (size_t i = 0; i < pairs_.size(); ++i)
    for (size_t j = i + 1; j < pairs_.size(); ++j) {
      if (side(pairs_[i].interface, 1).body != side(pairs_[j].interface, 1).body) continue;
      const bool early = s_.interfaces[pairs_[j].interface].tied && !s_.interfaces[pairs_[i].interface].tied;
      part(pairs_[early ? j : i], pairs_[early ? i : j]);
    }
  pairs_.erase(std::remove_if(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.two.empty(); }), pairs_.end());
  std::stable_partition(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.matching; });
}

std::vector<Zone> Pairing::run() {
  for (size_t k = 0; k < s_.interfaces.size(); ++k) choose(k);
  for (size_t k = 0; k < s_.interfaces.size(); ++k) {
    const size_t before = pairs_.size();
    join(k);
    if (pairs_.size() == before) throw Fault{s_.interfaces[k].at, "the two sides do not face each other anywhere"};
  }
  part_neighbours();
  std::vector<Zone> out;
  for (const Pair& pair : pairs_)
    out.push_back({&s_.interfaces[pair.interface],
                   stretch(pair.one),
                   stretch(pair.two),
                   pair.matching,
                   {pair.leaves[0], pair.leaves[1]}});
  return out;
}

} // namespace

std::vector<Stretch> stretches_of(const Mesh& mesh, const Side& side) {
  const Elements all = elements_of(mesh.bodies[static_cast<size_t>(side.body)]);
  Numbers numbers;
  for (size_t e = 0; e < all.size(); ++e)
    if (side.has(*all[e].curve)) numbers.push_back(static_cast<int>(e));
  std::vector<Stretch> out;
  for (const Numbers& row : in_a_row(all, numbers)) out.push_back(stretch(row));
  return out;
}

std::vector<Zone> zones_of(const Sketch& sketch, const Mesh& mesh) { return Pairing(sketch, mesh).run(); }

} // namespace sketch
