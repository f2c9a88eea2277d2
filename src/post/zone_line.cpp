#include "post/zone_line.hpp"

#include <algorithm>
#include <cmath>

namespace app {

void ZoneLine::place(double at, double out[2]) const {
  out[0] = out[1] = NAN;
  if (pieces.empty()) return;
  if (round) at -= length * std::floor((at - end[0].s) / length);
  size_t i = pieces.size() - 1;
  while (i > 0 && pieces[i].s > at) --i;
  const Piece& piece = pieces[i];
  const ElementCurve& curve = piece.curve;
  const double whole = curve.length(), from_begin = at - piece.s; // an end may lie beyond the last element
  const double want = piece.up ? from_begin : whole - from_begin;
  double eta = 2 * want / whole - 1, slope[2];
  for (int k = 0; k < 5 && curve.count > 2; ++k) { // Newton iteration; a straight element with two points has constant speed
    curve.slope(eta, slope);
    const double run = eta > -1 ? curve.length(-1, eta) : -curve.length(eta, -1);
    eta = std::min(std::max(eta - (run - want) / std::hypot(slope[0], slope[1]), -3.0), 3.0);
  }
  curve.point(eta, out);
  for (int c = 0; c < 2; ++c) out[c] = told_place(out[c], length); // on an axis
}

double ZoneLine::area(double to) const {
  double sum = 0;
  for (size_t i = 0; i < pieces.size(); ++i) { // Gauss's rule of three points on each element
    const double begin = std::max(0.0, pieces[i].s), until = i + 1 < pieces.size() ? std::min(to, pieces[i + 1].s) : to;
    const double half = (until - begin) / 2;
    for (int g = -1; g <= 1 && half > 0; ++g) {
      double at[2];
      place(begin + half * (1 + g * 0.7745966692414834), at);
      sum += (g == 0 ? 8.0 : 5.0) / 9 * half * kFullTurn * at[0];
    }
  }
  return sum;
}

namespace {

// Least distance of a point from an element, and the length there from the begin of the element.
double nearest_on(const ElementCurve& curve, const double at[2], double& run) {
  double eta = 0, p[2], t[2];
  for (int k = 0; k < 8; ++k) {
    curve.point(eta, p), curve.slope(eta, t);
    eta += ((at[0] - p[0]) * t[0] + (at[1] - p[1]) * t[1]) / (t[0] * t[0] + t[1] * t[1]);
    eta = std::min(std::max(eta, -1.0), 1.0);
  }
  curve.point(eta, p);
  run = eta > -1 ? curve.length(-1, eta) : 0;
  return std::hypot(at[0] - p[0], at[1] - p[1]);
}

double nearest_length(const std::vector<ZoneLine::Piece>& pieces, const double at[2]) {
  double least = HUGE_VAL, out = 0;
  for (const ZoneLine::Piece& piece : pieces) {
    double run = 0;
    const double off = nearest_on(piece.curve, at, run);
    if (off < least) least = off, out = piece.s + run;
  }
  return out;
}

} // namespace

double ZoneLine::along(double at) const {
  if (pieces.empty()) return NAN;
  double run = pieces.front().up ? at - pieces.front().s : pieces.front().s + length - at;
  if (turned) {
    double point[2];
    place(at, point);
    run = nearest_length(faced, point);
  }
  const double out = from + run;
  return told_place(around > 0 ? out - around * std::floor(out / around + 1e-10) : out, length);
}

void turn_forces(const std::vector<ZoneLine>& lines, std::vector<c2d_zone_state>& states) {
  for (size_t z = 0; z < lines.size() && z < states.size(); ++z)
    if (lines[z].turned)
      for (double* number : {&states[z].force[0], &states[z].force[1], &states[z].moment})
        if (*number != 0) *number = -*number;
}

namespace {

class PlaceFinder {
public:
  PlaceFinder(c2d_solver* solver, const Summary& summary) : solver_(solver), s_(summary) {}
  c2d_status find(std::vector<ZoneLine>& out);

private:
  struct Walk { // along a side
    std::vector<int32_t> elements;
    bool up = true;
  };
  c2d_status read();
  const BodyCurve& curve(int32_t body) const { return curves_[static_cast<size_t>(body) - 1]; }
  Walk walk(const c2d_side& side) const;
  ZoneLine line_of(int32_t zone) const;
  void add_element(ZoneLine& line, const c2d_side& side, int32_t e, bool up, double s) const;
  void add_faced(ZoneLine& line, const c2d_side& side) const;
  void find_ends(ZoneLine& line, const c2d_zone& zone, const Walk& w) const;
  void compare_ends(ZoneLine& line, const c2d_zone& zone, const Walk& w, const Walk& other) const;
  bool is_corner_pair(const c2d_zone& zone, size_t pair) const;
  bool faces_corner(const c2d_zone& zone, size_t pair) const;
  bool meets_another(int32_t number, bool at_end) const;
  bool is_mirror(const c2d_side& side, int32_t element, bool at_end) const;
  bool is_guided(int32_t body, int32_t element) const;
  bool is_cut(const c2d_side& side, int32_t element, bool at_end) const;

  c2d_solver* solver_;
  const Summary& s_;
  std::vector<BodyCurve> curves_;
  std::vector<double> zone_, node1_, node2_, element1_, eta1_; // of the pairs
  std::vector<std::vector<int32_t>> pair_at_;                  // by zone and functional node of side 2: the pair from 0, or -1
};

c2d_status PlaceFinder::read() {
  c2d_status status = C2D_OK;
  curves_.resize(static_cast<size_t>(s_.bodies));
  for (int32_t b = 1; b <= s_.bodies && status == C2D_OK; ++b)
    status = curves_[static_cast<size_t>(b) - 1].read(solver_, s_, b);
  if (status == C2D_OK)
    status = get_pairs(solver_, s_,
                       {{C2D_PAIR_ZONE, zone_},
                        {C2D_PAIR_NODE1, node1_},
                        {C2D_PAIR_NODE2, node2_},
                        {C2D_PAIR_ELEMENT1, element1_},
                        {C2D_PAIR_ETA1, eta1_}});
  if (status != C2D_OK) return status;
  for (const c2d_zone& zone : s_.zone) pair_at_.emplace_back(static_cast<size_t>(s_.body[zone.side2.body - 1].nodes) + 1, -1);
  for (size_t p = 0; p < zone_.size(); ++p) {
    std::vector<int32_t>& at = pair_at_[static_cast<size_t>(zone_[p]) - 1];
    const size_t node = static_cast<size_t>(node2_[p]);
    if (node < at.size()) at[node] = static_cast<int32_t>(p);
  }
  return C2D_OK;
}

// Up if that arrives at the last element after as many as the side has. One element: down, as sides 2 face sides 1.
PlaceFinder::Walk PlaceFinder::walk(const c2d_side& side) const {
  Walk w;
  const BodyCurve& c = curve(side.body);
  const int32_t count = side.elements;
  for (const bool up : {false, true}) {
    w.up = up;
    w.elements.assign(1, side.first_element);
    while (static_cast<int32_t>(w.elements.size()) < count && w.elements.back() != 0)
      w.elements.push_back(c.next(w.elements.back(), up));
    if (w.elements.back() == side.last_element) break;
  }
  return w;
}

bool PlaceFinder::faces_corner(const c2d_zone& zone, size_t pair) const {
  const BodyCurve& c = curve(zone.side1.body);
  const int32_t element = static_cast<int32_t>(element1_[pair]);
  if (node1_[pair] > 0) return c.is_corner_node(static_cast<int32_t>(node1_[pair]));
  if (element < 1 || element > c.elements() || 1 - std::fabs(eta1_[pair]) > 1e-6) return false;
  return c.is_corner(element, eta1_[pair] > 0);
}

bool PlaceFinder::is_corner_pair(const c2d_zone& zone, size_t pair) const {
  return curve(zone.side2.body).is_corner_node(static_cast<int32_t>(node2_[pair])) || faces_corner(zone, pair);
}

// Is the node where a matching zone begins, or ends, in a pair of another zone on either body?
bool PlaceFinder::meets_another(int32_t number, bool at_end) const {
  const c2d_zone& zone = s_.zone[static_cast<size_t>(number) - 1];
  for (const c2d_side* side : {&zone.side1, &zone.side2}) {
    if (curve(side->body).elements() == 0) continue; // of a platen
    const Walk w = walk(*side);
    const int32_t e = at_end ? w.elements.back() : w.elements.front();
    if (e == 0) continue;
    const int32_t node = curve(side->body).node(e, w.up == at_end ? s_.function_nodes : 1);
    for (size_t p = 0; p < zone_.size(); ++p) {
      const c2d_zone& other = s_.zone[static_cast<size_t>(zone_[p]) - 1];
      if (&other == &zone) continue;
      if (other.side1.body == side->body && static_cast<int32_t>(node1_[p]) == node) return true;
      if (other.side2.body == side->body && static_cast<int32_t>(node2_[p]) == node) return true;
    }
  }
  return false;
}

// Pairs of an element of side 2 that begins at s, and the parts of its shape functions. An end that is in no pair of the zone
// carries the traction of the nearest one, in a free zone or where another zone has its node.
void PlaceFinder::add_element(ZoneLine& line, const c2d_side& side, int32_t e, bool up, double s) const {
  const int32_t nodes = s_.function_nodes;
  const ElementCurve& element = curve(side.body).element(e);
  line.pieces.push_back({s, up, element});
  const c2d_zone& zone = s_.zone[static_cast<size_t>(line.zone) - 1];
  double of_end = 0; // weight of an end at the start of the line
  for (int32_t i = 0; i < nodes; ++i) {
    const int32_t k = up ? i : nodes - 1 - i;
    const int32_t node = curve(side.body).node(e, k + 1);
    const int32_t pair = pair_at_[static_cast<size_t>(line.zone) - 1][static_cast<size_t>(node)];
    const double own = element.length(-1, 1, nodes, k, line.revolved), weight = own + of_end, eta = node_place(nodes, k);
    if (pair < 0) {
      const bool begins = line.pair.empty();
      if ((zone.kind & C2D_ZONE_FREE) != 0 || meets_another(line.zone, !begins)) (begins ? of_end : line.weight.back()) += own;
      continue;
    }
    of_end = 0;
    if (!line.pair.empty() && (line.pair.back() == pair || line.pair.front() == pair)) { // shared with a neighbour
      line.weight[line.pair.back() == pair ? line.weight.size() - 1 : 0] += weight;
      continue;
    }
    double at[2];
    element.point(eta, at);
    line.pair.push_back(pair);
    line.s.push_back(s + (up ? element.length(-1, eta) : element.length(eta, 1)));
    line.x.push_back(at[0]), line.y.push_back(at[1]);
    line.weight.push_back(weight);
    line.corner.push_back(is_corner_pair(zone, static_cast<size_t>(pair)) ? 1 : 0);
  }
}

void PlaceFinder::add_faced(ZoneLine& line, const c2d_side& side) const {
  if (curve(side.body).elements() == 0) return; // of a platen
  Walk w = walk(side);
  if (!w.up) std::reverse(w.elements.begin(), w.elements.end());
  double s = 0;
  for (const int32_t e : w.elements) {
    if (e == 0) return line.faced.clear();
    line.faced.push_back({s, true, curve(side.body).element(e)});
    s += curve(side.body).element(e).length();
  }
}

// Is the element a straight one along an axis that slides along a fixed line without friction, in every load case?
bool PlaceFinder::is_guided(int32_t body, int32_t element) const {
  const ElementCurve& c = curve(body).element(element);
  double size = 0, off[2] = {0, 0};
  for (int32_t k = 1; k < c.count; ++k) {
    off[0] = std::max(off[0], std::fabs(c.x[k] - c.x[0])), off[1] = std::max(off[1], std::fabs(c.y[k] - c.y[0]));
    size = std::max({size, off[0], off[1]});
  }
  const int across = off[0] <= 1e-9 * size ? 0 : 1;
  if (off[across] > 1e-9 * size) return false;
  for (int32_t local = 1; local <= s_.function_nodes; ++local)
    for (int32_t load_case = 1; load_case <= s_.load_cases; ++load_case) {
      int32_t codes[4];
      double values[4];
      if (c2d_get_condition(solver_, body, element, local, load_case, codes, values) != C2D_OK) return false;
      const int supported = 2 + across, along = 1 - across; // codes are those of tx ty ux uy; 0: known
      if (codes[supported] != 0 || values[supported] != 0 || codes[along] != 0 || values[along] != 0) return false;
    }
  return true;
}

// Does a side end on a line of symmetry, by images or by its elements?
bool PlaceFinder::is_mirror(const c2d_side& side, int32_t element, bool at_end) const {
  const ElementCurve& c = curve(side.body).element(element);
  double at[2];
  c.point(at_end ? 1 : -1, at);
  const double near = 1e-6 * c.length();
  for (int axis = 0; axis < 2; ++axis)
    if ((s_.symmetry >> axis & 1) != 0 && std::fabs(at[axis] - s_.symmetry_at[axis]) < near) return true;
  const int32_t beyond = curve(side.body).next(element, at_end);
  return beyond != 0 && s_.body[side.body - 1].unknowns > 0 && is_guided(side.body, beyond);
}

// Does the surface go on beyond an end of a side with elements that belong to no zone?
bool PlaceFinder::is_cut(const c2d_side& side, int32_t element, bool at_end) const {
  const int32_t beyond = curve(side.body).next(element, at_end);
  const auto holds = [&](const c2d_side& other) {
    if (other.body != side.body) return false;
    const Walk w = walk(other);
    return std::find(w.elements.begin(), w.elements.end(), beyond) != w.elements.end();
  };
  return beyond != 0 && std::none_of(s_.zone.begin(), s_.zone.end(),
                                     [&](const c2d_zone& zone) { return holds(zone.side1) || holds(zone.side2); });
}

// Distance of the end of an element of side 1 beyond that of one of side 2, along it and over its length; NaN: not on its line.
double distance_beyond(const ElementCurve& one, bool at_end1, const ElementCurve& two, bool at_end2) {
  double a[2], b[2], t[2];
  one.point(at_end1 ? 1 : -1, a);
  two.point(at_end2 ? 1 : -1, b);
  two.slope(at_end2 ? 1 : -1, t);
  const double size = (at_end2 ? 1 : -1) * std::hypot(t[0], t[1]), length = two.length();
  const double along = ((a[0] - b[0]) * t[0] + (a[1] - b[1]) * t[1]) / size;
  const double off = ((a[0] - b[0]) * t[1] - (a[1] - b[1]) * t[0]) / size;
  return std::fabs(off) > 0.5 * length ? NAN : along / length;
}
const double kOpposite = 0.1, kLeftOut = 1.5; // over the length of the element

// Corners and lines of symmetry of side 1 where it ends opposite an end of side 2. Both bodies have to be mirrored there; a
// rigid one has no conditions to decide it.
void PlaceFinder::compare_ends(ZoneLine& line, const c2d_zone& zone, const Walk& w, const Walk& other) const {
  const bool rigid[2] = {s_.body[zone.side1.body - 1].unknowns == 0, s_.body[zone.side2.body - 1].unknowns == 0};
  const BodyCurve &one = curve(zone.side1.body), &two = curve(zone.side2.body);
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j) {
      const int32_t e = j == 0 ? other.elements.front() : other.elements.back(),
                    own = k == 0 ? w.elements.front() : w.elements.back();
      const bool at_end = (j == 1) == other.up;
      const double beyond = distance_beyond(one.element(e), at_end, two.element(own), (k == 1) == w.up);
      const double reach = (zone.kind & C2D_ZONE_FREE) != 0 ? kLeftOut : kOpposite; // of side 2 elements may be left out
      if (std::isnan(beyond) || beyond < -kOpposite || beyond > reach) continue;
      if (one.is_corner(e, at_end)) {
        line.end[k].corner = true;
        if (beyond > kOpposite) line.end[k].s = beyond * two.element(own).length();
      }
      line.end[k].cut = line.end[k].cut && is_cut(zone.side1, e, at_end);
      if (beyond > kOpposite) continue;
      const bool mirror = is_mirror(zone.side1, e, at_end);
      line.end[k].mirror = rigid[1] ? mirror : line.end[k].mirror && (mirror || rigid[0]);
    }
}

void PlaceFinder::find_ends(ZoneLine& line, const c2d_zone& zone, const Walk& w) const {
  for (int k = 0; k < 2; ++k) {
    const bool at_end = (k == 1) == w.up;
    const int32_t last = k == 0 ? w.elements.front() : w.elements.back();
    line.end[k].mirror = is_mirror(zone.side2, last, at_end);
    line.end[k].corner = curve(zone.side2.body).is_corner(last, at_end);
    line.end[k].cut = is_cut(zone.side2, last, at_end);
  }
  if (curve(zone.side1.body).elements() > 0) compare_ends(line, zone, w, walk(zone.side1));
}

// Normal and tangential compliance of the surface of a body under pressure.
struct Yields {
  double normal = 0, along = 0;
  Yields(const Summary& s, int32_t body) {
    const c2d_body_result& b = s.body[body - 1];
    if (!(b.youngs_modulus > 0) || b.unknowns == 0) return; // a rigid one
    const double nu = b.poisson_ratio, kappa = s.plane == C2D_PLANE_STRESS ? (3 - nu) / (1 + nu) : 3 - 4 * nu;
    normal = (kappa + 1) * (1 + nu) / (2 * b.youngs_modulus), along = (kappa - 1) * (1 + nu) / (2 * b.youngs_modulus);
  }
};

double dundurs_beta(const Summary& s, const c2d_zone& zone) {
  const Yields one(s, zone.side1.body), two(s, zone.side2.body);
  const double sum = one.normal + two.normal;
  return sum > 0 ? (one.along - two.along) / sum : 0;
}

ZoneLine PlaceFinder::line_of(int32_t number) const {
  const c2d_zone& zone = s_.zone[static_cast<size_t>(number) - 1];
  ZoneLine line;
  line.zone = number;
  line.tied = (zone.kind & C2D_ZONE_TIED) != 0;
  line.self = zone.side1.body == zone.side2.body;
  line.revolved = s_.plane == C2D_AXISYMMETRIC;
  line.beta = dundurs_beta(s_, zone);
  const Walk w = walk(zone.side2);
  if (w.elements.front() == 0 || w.elements.back() == 0) return line;
  for (const int32_t e : w.elements) {
    add_element(line, zone.side2, e, w.up, line.length);
    line.length += curve(zone.side2.body).element(e).length();
  }
  const int32_t region = curve(zone.side2.body).region_size(w.elements.front());
  line.round = curve(zone.side2.body).is_closed(w.elements.front()) && static_cast<int32_t>(w.elements.size()) == region;
  if (!line.round) find_ends(line, zone, w);
  if (line.round) line.around = line.length;
  add_faced(line, zone.side1);
  const double begin = line.s.empty() ? 0 : line.s.front(); // lengths are counted from the first pair
  for (double& s : line.s) s -= begin;
  for (ZoneLine::Piece& piece : line.pieces) piece.s -= begin;
  // Until here `s` is how far an end lies beyond the elements.
  line.end[0].s = -begin - line.end[0].s, line.end[1].s += line.length - begin;
  return line;
}

c2d_status PlaceFinder::find(std::vector<ZoneLine>& out) {
  if (const c2d_status status = read(); status != C2D_OK) return status;
  for (int32_t z = 1; z <= static_cast<int32_t>(s_.zone.size()); ++z) out.push_back(line_of(z));
  return C2D_OK;
}

} // namespace

c2d_status find_zone_lines(c2d_solver* solver, const Summary& summary, std::vector<ZoneLine>& out) {
  out.clear();
  return summary.pairs > 0 ? PlaceFinder(solver, summary).find(out) : C2D_OK;
}

} // namespace app
