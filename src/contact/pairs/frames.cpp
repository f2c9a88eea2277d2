#include "contact/pairs/frames.hpp"

#include "contact/pairs/facing_pairs.hpp"
#include "contact/pairs/ties.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "model/body_overlaps.hpp"
#include "model/geometry.hpp"
#include "model/pair_frame.hpp"
#include "model/rigid.hpp"
#include "model/symmetry.hpp"
#include "model/unknowns.hpp"
#include "model/validate/slits.hpp"
#include "model/validate/validate_finding.hpp"

namespace c2d {

C2D_USES(FreeZonePart);
C2D_USES(CurvePart);

namespace {

constexpr double kDegree = 0.017453292519943295;
// Of the element length. A smaller overlap is none, unless overlaps are a load (*INTERFERENCE): then each is a press fit,
// however small beside the elements, down to the digits of coordinates. A smaller gap is none if the whole zone has no larger
// one, as surfaces that are meant to coincide; else its own counts: the first neighbours of a point of first contact may be as
// close (1e-5 elements are 5 % of the pressure at a/R = 1e-4), and what is asked must not depend on where the bodies lie and
// how they are turned, as the digits of their coordinates do.
constexpr double kGapTolerance = 1e-5;
constexpr double kExactGap = 1e-9;
constexpr double kOffset = 0.5;      // of the element length: nodes shifted further do not face each other
constexpr double kShift = 0.02;      // those shifted by more, and by more than their gap, do not quite
constexpr double kAlongNormal = 0.5; // least cosine between the average normal and a symmetric pair's frame

double dot(const double a[2], const double b[2]) { return a[0] * b[0] + a[1] * b[1]; }

} // namespace

bool make_unit(double v[2]) {
  const double size = sqrt(dot(v, v));
  if (size <= 1e-6) return false;
  v[0] /= size;
  v[1] /= size;
  return true;
}

void add_surface(const Model& m, int b, int32_t element, double eta, Surface& out) {
  const SurfaceElement surface = surface_element(m, b, element);
  const SurfacePoint p = surface_point(surface, eta);
  const double length = element_length(m, b, element);
  if (out.length < 0 || length < out.length) out.length = length;
  out.n[0] += p.nx;
  out.n[1] += p.ny;
  out.x = p.x;
  out.y = p.y;
  out.doubt = surface.doubt * (1 - eta * eta); // none at boundary points
}

void say_pair(Finding& f, const Model& m, int32_t pair) {
  const Pair& p = m.pair[pair];
  say(f, "pair ", pair + 1);
  if (p.node[0] >= 0)
    say(f, " (node ", p.node[0] + 1);
  else
    say(f, " (on element ", p.element + 1);
  say(f, " of body ", body_named(m, body_on(m, p, 0)), ", node ", p.node[1] + 1, " of body ", body_named(m, body_on(m, p, 1)),
      ")");
}

namespace {

bool surface_at(const Model& m, int side, int32_t pair, Surface& out) {
  const int32_t f = m.head->function_nodes;
  const int b = body_on(m, m.pair[pair], side);
  int32_t ends[2];
  const int count = ends_at_node(m, b, m.pair[pair].node[side], ends);
  out = Surface{{0, 0}, 0, 0, -1, 0};
  for (int i = 0; i < count; ++i) {
    const int32_t element = ends[i] / f, local = ends[i] % f;
    if (pair_of_end(m, b, element, local).pair != pair) continue;
    add_surface(m, b, element, node_eta(f, local), out);
  }
  return make_unit(out.n);
}

void report_pair(const Model& m, int32_t pair, const char* found, const char* expected, Reporter& reporter) {
  Finding f(at_pair(m, pair));
  say_pair(f, m, pair);
  say(f, ": ", found, ", expected ", expected);
  report(reporter, f);
}

// ---- symmetry ----

bool has_value(const Model& m, int b, int32_t node, int component) {
  for (int32_t k = 0; k < m.head->load_cases; ++k)
    if (given_displacement(m, b, node, component, k) != 0) return true;
  return false;
}

void report_one_side(const Model& m, int32_t pair, int side, int component, Reporter& reporter) {
  Finding f(at_pair(m, pair));
  say_pair(f, m, pair);
  const int b = body_on(m, m.pair[pair], side), other = body_on(m, m.pair[pair], 1 - side);
  say(f, component == 0 ? ": ux" : ": uy", " is prescribed on body ", body_named(m, b), " only, expected it on ");
  if (is_rigid(m, other))
    say(f, "neither: what meets the rigid body ", body_named(m, other), " follows it");
  else
    say(f, "both bodies (symmetry) or on neither");
  report(reporter, f);
}

// Prescribed displacements at a pair. Returns false on a fault; *component: the one that symmetry fixes, or
// -1.
bool find_symmetry(const Model& m, int32_t pair, int* component, Reporter& reporter) {
  const Pair& p = m.pair[pair];
  *component = -1;
  const int32_t node[2] = {p.node[0] >= 0 ? p.node[0] : kFreeZonePart.faced_node(m, p), p.node[1]};
  const int body[2] = {body_on(m, p, 0), body_on(m, p, 1)};
  bool fixed[2][2]; // [side][component]
  for (int s = 0; s < 2; ++s) {
    for (int c = 0; c < 2; ++c)
      fixed[s][c] = node[s] >= 0 && (displacement_known(m, body[s], node[s], c) || is_held_by_symmetry(m, body[s], node[s], c));
  }
  // What holds side 0 of a free zone is symmetry only if it holds side 1 as well; else it is a support.
  for (int c = 0; c < 2 && p.node[0] < 0; ++c) fixed[0][c] = fixed[0][c] && fixed[1][c];
  if ((node[0] >= 0 ? lines_at_node(m, body[0], node[0]) : 0) != lines_at_node(m, body[1], node[1])) {
    report_pair(m, pair, "one of the nodes lies on a symmetry line", "both on it or neither", reporter);
    return false;
  }
  if ((fixed[0][0] || fixed[1][0]) && (fixed[0][1] || fixed[1][1])) {
    report_pair(m, pair, "displacements are prescribed in both directions", "a free direction along the normal", reporter);
    return false;
  }
  for (int c = 0; c < 2; ++c) {
    if (!fixed[0][c] && !fixed[1][c]) continue;
    if (fixed[0][c] != fixed[1][c]) {
      report_one_side(m, pair, fixed[0][c] ? 0 : 1, c, reporter);
      return false;
    }
    if (has_value(m, body[0], node[0], c) || has_value(m, body[1], node[1], c)) {
      report_pair(m, pair, c == 0 ? "a nonzero ux is prescribed" : "a nonzero uy is prescribed", "zero (symmetry)", reporter);
      return false;
    }
    *component = c;
  }
  return true;
}

// ---- one pair ----

bool set_normal(const Model& m, int32_t pair, const Surface& s1, const Surface& s2, Reporter& reporter) {
  Pair& p = m.pair[pair];
  const double part = m.zone[p.zone].normal_part;
  double n[2];
  for (int i = 0; i < 2; ++i) n[i] = part * s1.n[i] - (1 - part) * s2.n[i];
  if (dot(s1.n, s2.n) > 0) {
    report_pair(m, pair, "the surfaces do not face each other", "opposed outward normals", reporter);
    return false;
  }
  make_unit(n);
  int fixed;
  if (!find_symmetry(m, pair, &fixed, reporter)) return false;
  p.tangential = fixed < 0;
  if (fixed >= 0) {
    const int other = 1 - fixed;
    if (fabs(n[other]) < kAlongNormal) {
      report_pair(m, pair, fixed == 0 ? "ux is prescribed nearly along the normal" : "uy is prescribed nearly along the normal",
                  "a free displacement along the normal", reporter);
      return false;
    }
    const double sense = n[other] > 0 ? 1 : -1;
    n[fixed] = 0;
    n[other] = sense;
  }
  p.nx = n[0];
  p.ny = n[1];
  return true;
}

// Pairs of a zone whose surfaces lie inside each other, or would, were the elements' surfaces right to the last digit.
struct Overlaps {
  int32_t count, pair; // the worst
  double size, doubt;
  void add(int32_t of_pair, double of_size, double of_doubt) {
    if (count++ > 0 && of_size * doubt <= size * of_doubt) return; // of_doubt is never zero
    pair = of_pair;
    size = of_size;
    doubt = of_doubt;
  }
};
struct ZoneOverlaps {
  Overlaps told, unsure;
};

void set_gap(const Model& m, int32_t pair, const double g[2], double doubt, ZoneOverlaps& overlaps) {
  Pair& p = m.pair[pair];
  double across[2];
  to_frame(p, g[0], g[1], across);
  p.gap = across[0];
  const double overlap = m.head->interference != 0 ? kExactGap : kGapTolerance;
  if (p.gap >= -overlap * p.length && p.gap <= kExactGap * p.length) p.gap = 0;
  if (p.gap >= 0) return;
  const double size = -p.gap;
  p.gap = 0;
  if (m.head->interference != 0 || is_tied(m, p)) p.overlap = size;
  if (size <= doubt)
    overlaps.unsure.add(pair, size, doubt);
  else if (m.head->interference == 0)
    overlaps.told.add(pair, size, p.length);
}

// Nodes of a pair lie opposite each other: what lies between them is gap, not a shift along the surfaces.
struct Offsets {
  struct Worst {
    int32_t count, pair;
    double size;
    void add(const Model& m, int32_t of_pair, double offset) {
      if (count++ > 0 && offset * m.pair[pair].length <= size * m.pair[of_pair].length) return;
      pair = of_pair;
      size = offset;
    }
  };
  Worst far, near; // pairs beyond half an element, and others
  void add(const Model& m, int32_t of_pair, const double g[2]) {
    double across[2];
    to_frame(m.pair[of_pair], g[0], g[1], across);
    const double offset = fabs(across[1]), length = m.pair[of_pair].length;
    if (offset > kOffset * length)
      far.add(m, of_pair, offset);
    else if (!kSmallCode && offset > kShift * length + fabs(across[0]))
      near.add(m, of_pair, offset);
  }
};

// How far the lengths of elements that face each other differ in a zone.
struct Lengths {
  int32_t count, pair; // pairs beyond the limit; the worst
  double length[2];
  void add(int32_t of_pair, double one, double two) {
    constexpr double kMost = 4;
    const double ratio = one > two ? one / two : two / one;
    if (ratio <= kMost) return;
    if (count++ > 0 && ratio <= fmax(length[0] / length[1], length[1] / length[0])) return;
    pair = of_pair;
    length[0] = one;
    length[1] = two;
  }
};

// How far the normals of a zone's pairs differ.
struct Spread {
  int32_t count, pair; // pairs beyond 15 degrees; the worst
  double angle;
  void add(int32_t of_pair, double degrees) {
    if (degrees <= 15) return;
    if (count++ == 0 || degrees > angle) {
      pair = of_pair;
      angle = degrees;
    }
  }
};

// Do the elements of both sides coincide at a pair of nodes?
bool on_same_elements(const Model& m, const Pair& p, double tolerance) {
  if (p.node[0] < 0) return false;
  double x[2], y[2];
  for (int side = 0; side < 2; ++side) node_position(m, body_on(m, p, side), p.node[side], &x[side], &y[side]);
  return fabs(x[1] - x[0]) <= tolerance && fabs(y[1] - y[0]) <= tolerance;
}

// What is told of a zone once, about its worst pair.
struct ZoneFindings {
  Spread spread;
  ZoneOverlaps overlaps;
  Lengths lengths;
  Offsets offsets;
};

// Side 0, where side 1 is `other`: a platen lies on it.
bool facing_surface(const Model& m, int32_t pair, const Surface& other, Surface& out) {
  const Pair& p = m.pair[pair];
  if (p.node[0] < 0) return kFreeZonePart.surface_faced(m, pair, out);
  if (!is_platen(m, body_on(m, p, 0))) return surface_at(m, 0, pair, out);
  out = other;
  for (double& n : out.n) n = -n;
  return true;
}

void build_frame(const Model& m, int32_t pair, ZoneFindings& of, Reporter& reporter) {
  Pair& p = m.pair[pair];
  Surface s1, s2;
  const bool second = surface_at(m, 1, pair, s2), first = facing_surface(m, pair, s2, s1);
  if (!first || !second) return report_pair(m, pair, "no normal on one of the bodies", "a smooth contact element", reporter);
  p.length = fmin(s1.length, s2.length);
  of.lengths.add(pair, s1.length, s2.length);
  if (!set_normal(m, pair, s1, s2, reporter)) return;
  const bool same = on_same_elements(m, p, kExactGap * p.length); // one surface, whatever lies beyond the zone on either body
  const double g[2] = {same ? 0 : s2.x - s1.x, same ? 0 : s2.y - s1.y};
  set_gap(m, pair, g, s1.doubt + s2.doubt, of.overlaps);
  if (p.node[0] >= 0) of.offsets.add(m, pair, g); // points of a free zone face each other by construction

  const double opposite[2] = {-s2.n[0], -s2.n[1]};
  of.spread.add(pair, angle_between(s1.n, opposite) / kDegree);
}

// Surfaces that coincide but for the last digits of their nodes.
void close_gaps(const Model& m, const Zone& z) {
  Pair* pairs = m.pair + z.first_pair;
  for (int32_t k = 0; k < z.pairs; ++k)
    if (pairs[k].gap > kGapTolerance * pairs[k].length || pairs[k].overlap > 0) return;
  for (int32_t k = 0; k < z.pairs; ++k) pairs[k].gap = 0;
}

// One fault or warning for a zone, about the worst of its pairs.
void report_overlaps(const Model& m, int32_t zone, const ZoneOverlaps& overlaps, Reporter& reporter) {
  if (overlaps.told.count > 0) {
    Finding f(at_pair(m, overlaps.told.pair));
    say_pair(f, m, overlaps.told.pair);
    say(f, ": the bodies overlap by ", overlaps.told.size, " before any load (interference)");
    if (overlaps.told.count > 1) say(f, ", the largest of ", overlaps.told.count, " overlaps in zone ", zone_named(m, zone));
    say(f, ", expected a gap of 0 or more, or *INTERFERENCE");
    report(reporter, f);
  }
  if (overlaps.unsure.count > 0) {
    ZoneFinding f(C2D_WARN_OVERLAP, m, zone, overlaps.unsure.pair);
    say(f, ": overlaps smaller than what the elements leave open of the surfaces, pairs: ", overlaps.unsure.count,
        ", most at ");
    say_pair(f, m, overlaps.unsure.pair);
    say(f, ": ", overlaps.unsure.size, " against ", overlaps.unsure.doubt);
    say(f, m.head->interference != 0 ? "" : "; they count as touching");
    report(reporter, f);
  }
}

// Tractions of one side act where the other has them, METHOD (9.1): by so much off.
void warn_shift(const Model& m, int32_t zone, const Offsets::Worst& offsets, Reporter& reporter) {
  if (offsets.count == 0) return;
  const double part = 100 * offsets.size / m.pair[offsets.pair].length;
  ZoneFinding f(C2D_WARN_SHIFTED, m, zone, offsets.pair);
  say(f, ": the nodes do not quite face each other at ", offsets.count, offsets.count == 1 ? " pair, " : " pairs, most at ");
  say_pair(f, m, offsets.pair);
  say(f, ": they are shifted by ", offsets.size, " along the surface; pressures there may be off by as large a part as of the ",
      "element, ");
  put(f.text, part, 2);
  say(f, " %: mesh both sides alike, or use a free zone");
  report(reporter, f);
}

void report_offsets(const Model& m, int32_t zone, const Offsets::Worst& offsets, Reporter& reporter) {
  if (offsets.count == 0) return;
  const double length = m.pair[offsets.pair].length;
  ZoneFinding f(offsets.size < length ? int32_t{C2D_WARN_OFFSET} : 0, m, zone, offsets.pair);
  say(f, ": the nodes do not face each other at ", offsets.count, offsets.count == 1 ? " pair, " : " pairs, ",
      offsets.count == 1 ? "" : "least at ");
  say_pair(f, m, offsets.pair);
  say(f, ": they are shifted by ", offsets.size, " along the surface, where contact elements are ", length,
      " long, expected at most half of it");
  report(reporter, f);
}

void warn_lengths(const Model& m, int32_t zone, const Lengths& lengths, Reporter& reporter) {
  if (lengths.count == 0) return;
  ZoneFinding f(C2D_WARN_SIZES, m, zone, lengths.pair);
  say(f, ": elements that face each other differ in length more than fourfold at ", lengths.count,
      lengths.count == 1 ? " pair, " : " pairs, most at ");
  say_pair(f, m, lengths.pair);
  say(f, ": ", lengths.length[0], " and ", lengths.length[1]);
  report(reporter, f);
}

void warn_spread(const Model& m, int32_t zone, const Spread& spread, Reporter& reporter) {
  if (spread.count == 0) return;
  ZoneFinding f(C2D_WARN_NORMALS, m, zone, spread.pair);
  say(f, ": the normals of the two surfaces differ by more than 15 degrees at ", spread.count,
      spread.count == 1 ? " pair, " : " pairs, most at ");
  say_pair(f, m, spread.pair);
  say(f, ": ", spread.angle, " degrees");
  report(reporter, f);
}

// ---- kinks ----

// Kinks of one side of a zone; element: that behind the worst.
struct Kinks {
  int32_t count, before, after;
  double angle;
};

void look_for_kink(const Model& m, const Zone& z, int side, int32_t k, Kinks& kinks) {
  const int b = z.body[side];
  int32_t before = zone_element(m, z, side, k), after = zone_element(m, z, side, (k + 1) % zone_elements(z, side));
  const int last = body_of(m, b).element_nodes - 1;
  if (geometry_node(m, b, before, last) != geometry_node(m, b, after, 0)) {
    const int32_t swap = before;
    before = after;
    after = swap;
  }
  double n1[2], n2[2];
  outward_normal(m, b, before, 1, n1);
  outward_normal(m, b, after, -1, n2);
  const double angle = angle_between(n1, n2) / kDegree;
  if (angle <= 10 || is_joint_of_arc(m, b, before, after)) return;
  if (kinks.count++ == 0 || angle > kinks.angle) {
    kinks.before = before;
    kinks.after = after;
    kinks.angle = angle;
  }
}

void warn_kinks(const Model& m, int32_t zone, int side, Reporter& reporter) {
  const Zone& z = m.zone[zone];
  const int b = z.body[side];
  // A zone that goes all round its region has a last neighbour more.
  const Region& r = m.region[b][z.region[side]];
  const int32_t count = zone_elements(z, side);
  const int32_t joints = count - (count == r.last - r.first + 1 && !r.open ? 0 : 1);
  Kinks kinks{0, 0, 0, 0.0};
  for (int32_t k = 0; k < joints; ++k) look_for_kink(m, z, side, k, kinks);
  if (kinks.count == 0) return;
  Finding f(C2D_WARN_KINK, in_zone(m, zone, b, kinks.after));
  if (m.head->function_nodes > 1 && (z.is_free == 0 || side == 1)) {
    const int32_t node = functional_node(m, b, kinks.after, 0);
    f.entry.node = node + 1;
    f.entry.pair = pair_of_node(m, b, node).pair + 1;
  }
  say(f, "zone ", zone_named(m, zone), ": elements ", kinks.before + 1, " and ", kinks.after + 1, " of body ", body_named(m, b),
      " meet at a kink of ", kinks.angle, " degrees, more than 10");
  if (kinks.count > 1) say(f, ", the largest of ", kinks.count);
  report(reporter, f);
}

// How far the surface may be off at a point of an element: not at all at its ends.
double doubt_at(const Model& m, int b, int32_t element, double eta) {
  const double part = 1 - eta * eta;
  return part == 0 ? 0 : part * surface_element(m, b, element).doubt;
}

void clear_contact(const Model& m) {
  m.head->contact = m.head->path_unknowns = m.head->motions = 0;
  for (int b = 0; b < m.head->bodies; ++b) m.body[b].contact = m.body[b].free_rows = m.body[b].first_motion = 0;
}

// Contact unknowns: of the model pair after pair, of each body zone after zone.
void number_contact(const Model& m) {
  clear_contact(m);
  for (int32_t pair = 0, dof = 0; pair < m.head->pairs; ++pair) {
    m.pair[pair].dof = dof;
    dof += 1 + m.pair[pair].tangential;
    m.head->contact = dof;
    if (pair + 1 == m.head->path_pairs) m.head->path_unknowns = dof;
  }
  for (int32_t i = 0; i < m.head->zones; ++i) {
    Zone& z = m.zone[i];
    if (C2D_NEVER(z.pairs == 0)) continue; // zones without pairs are refused
    const int32_t first = m.pair[z.first_pair].dof;
    int32_t dof = first;
    for (int32_t k = 0; k < z.pairs; ++k) {
      Pair& pair = m.pair[z.first_pair + k];
      dof += 1 + pair.tangential;
      if (z.is_free != 0) pair.row = m.body[z.body[0]].free_rows + pair.dof - first;
    }
    for (int side = 0; side < 2; ++side) {
      int32_t& contact = m.body[z.body[side]].contact;
      z.shift[side] = contact - first;
      contact += dof - first;
    }
    if (z.is_free != 0) m.body[z.body[0]].free_rows += dof - first;
  }
}

} // namespace

double surface_doubt(const Model& m, int32_t pair) {
  const Pair& p = m.pair[pair];
  const int32_t f = m.head->function_nodes;
  double sum = 0;
  for (int side = 0; side < 2; ++side) {
    const int b = body_on(m, p, side);
    int32_t ends[2];
    if (p.node[side] < 0)
      sum += doubt_at(m, b, p.element, p.eta);
    else if (ends_at_node(m, b, p.node[side], ends) == 1)
      sum += doubt_at(m, b, ends[0] / f, node_eta(f, ends[0] % f));
  }
  return sum;
}

bool build_frames(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  for (int32_t i = 0; i < m.head->zones; ++i) {
    const Zone& z = m.zone[i];
    ZoneFindings of{{0, 0, 0.0}, {{0, 0, 0.0, 0.0}, {0, 0, 0.0, 0.0}}, {0, 0, {0.0, 0.0}}, {{0, 0, 0.0}, {0, 0, 0.0}}};
    for (int32_t k = 0; k < z.pairs; ++k) {
      const int32_t pair = z.first_pair + k;
      Pair& p = m.pair[pair];
      p = Pair{};
      p.node[0] = z.is_free != 0 ? -1 : zone_node(m, z, 0, k);
      p.node[1] = zone_node(m, z, 1, k);
      p.zone = i;
      p.tangential = 1;
      p.status = C2D_OPEN;
      p.ny = 1; // until its own is known: a pair with a fault
      build_frame(m, pair, of, reporter);
    }
    if (z.is_tied != 0)
      close_tie(m, i, reporter);
    else
      close_gaps(m, z);
    report_offsets(m, i, of.offsets.far, reporter);
    if (of.offsets.far.count == 0) warn_shift(m, i, of.offsets.near, reporter);
    warn_spread(m, i, of.spread, reporter);
    if (z.is_tied == 0) report_overlaps(m, i, of.overlaps, reporter);
    warn_lengths(m, i, of.lengths, reporter);
    for (int side = is_platen(m, z.body[0]) ? 1 : 0; side < 2; ++side) warn_kinks(m, i, side, reporter);
  }
  number_contact(m);
  return reporter.faults == before;
}

// Those of a rigid body that are not given.
static void free_rigid_motions(Body& body) {
  body.free_motions = 0;
  for (int i = 0; i < 3; ++i) {
    if ((body.free_rigidly >> i & 1) == 0) continue;
    for (int k = 0; k < 3; ++k) body.free_motion[body.free_motions][k] = k == i ? 1.0 : 0.0;
    ++body.free_motions;
  }
}

// Free motions of every body, and where what belongs to each begins in lists of all bodies.
static void place_bodies(const Model& m) {
  int64_t nodes = 0, ends = 0;
  m.head->motions = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    Body& body = m.body[b];
    if (is_rigid(m, b))
      free_rigid_motions(body);
    else
      find_free_motions(m, b);
    body.first_node = nodes;
    body.first_end = ends;
    body.first_motion = m.head->motions;
    nodes += body.nodes;
    ends += static_cast<int64_t>(body.elements) * m.head->function_nodes;
    if (body.contact > 0) m.head->motions += body.free_motions;
  }
}

bool complete_model(const Model& m, Reporter& reporter) {
  const int32_t before = reporter.faults;
  clear_contact(m);
  if (!validate_data(m, reporter)) return false; // nothing else can be looked at
  set_units(m);
  const bool symmetric = validate_symmetry(m, reporter); // moves points onto its lines
  measure_elements(m);
  const bool sound =
      symmetric && validate_geometry(m, reporter) && (m.head->curves == 0 || kCurvePart.validate_curves(m, reporter));
  validate_loads(m, reporter);
  if (!validate_zones(m, sound, reporter)) return false; // conditions depend on who is in contact
  const bool frames = sound && build_frames(m, reporter);
  validate_conditions(m, frames, reporter);
  if (reporter.faults != before) return false;
  warn_overlapping_bodies(m, reporter);
  warn_slits(m, reporter);
  place_bodies(m);
  if (m.head->curves > 0) kCurvePart.find_slip_gaps(m);
  return true;
}

} // namespace c2d
