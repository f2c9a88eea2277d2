// Warning for contact zones with too few elements.
//
// Phases for every zone:
//   1. Split the zone into stretches of closed pairs (on a ring beginning after an open pair).
//   2. Edges. Hertz pressure rises from zero at the edge with the square root of the distance (Johnson, Contact Mechanics,
//      chapter 4). Count the elements from each edge to the first pressure maximum; fewer than kFewElements cannot resolve it.
//   3. Corners. Under a sharp punch the pressure grows like r^(lambda - 1) (Johnson, section 5.1). A last element that carries
//      much of the force shows that the mesh does not resolve this singularity.
//   4. Stick and slip zones, at the peak of the load: count the elements of each (Cattaneo and Mindlin: Johnson, chapter 7).
//   5. Report the worst edge, zone and corner with an uncertainty: the length of the pair at the border, within which the true
//      border lies, and for the pressure the drop to the next pair.
// Of equally many elements the border with the larger uncertainty is reported, then the narrower zone. This rule does not
// depend on the direction of numbering, so that a model and its mirror image give the same message.
#include "results/warnings/coarse_contact.hpp"

#include "model/geometry.hpp"

namespace c2d {

namespace {

// Consecutive pairs first ... last of one kind: closed, or of one status.
struct Stretch {
  int32_t first, last;
};

// A zone with its pairs. On a ring indices continue beyond the last pair and place() reduces them.
struct Looked {
  const Session* session;
  int32_t begin, end;    // pairs of the zone: begin ... end - 1
  bool round, corner[2]; // closed curve; the first and last pair lie at a corner of a body

  int32_t place(int32_t i) const {
    const int32_t count = end - begin;
    return round ? begin + ((i - begin) % count + count) % count : i;
  }
  const Pair& pair(int32_t i) const { return session->model.pair[place(i)]; }
  bool has(int32_t i) const { return round || (i >= begin && i < end); }
  bool closed(int32_t i) const { return pair(i).status != C2D_OPEN; }
  double pressure(int32_t i) const { return pair_state(*session->follower.t, place(i), session->follower.y).p; }
  // Elements of so many pairs, rounded up: a partly closed element at the border counts as one.
  int32_t elements(int32_t pairs) const {
    const int32_t per_element = session->model.head->function_nodes > 2 ? session->model.head->function_nodes - 1 : 1;
    return (pairs + per_element - 1) / per_element;
  }
  double width(Stretch s) const {
    double sum = 0.0;
    for (int32_t i = s.first; i <= s.last; ++i) sum += length_at(session->model, pair(i));
    return sum;
  }
};

// Stick, or slip in one of two directions. Opposite directions form separate zones. A pair without tangential freedom (on an
// axis of symmetry) belongs to the stick zone around it.
int32_t kind_of(const Pair& pair) { return pair.status == C2D_SLIP ? 10 + pair.sign : pair.status; }

struct Worst {
  int32_t elements = kFewElements - 1, edge = -1; // edge: its pair
  double reach = 0.0, width = 0.0;
  double drop = 0.0;           // relative drop from the highest pressure to the next pair
  int32_t first = 0, last = 0; // pairs
  const char* kind = nullptr;
  // Is another finding worse? Fewer elements first, then the larger uncertainty, then the narrower zone. Differences below 1e-9
  // are round-off and must not decide between a model and its mirror image.
  bool gives_way_to(int32_t other, double other_reach, double other_width) const {
    if (other != elements || reach == 0.0) return other <= elements;
    const double more = other_reach / reach - 1.0;
    return more > 1e-9 || (more > -1e-9 && other_width < (1.0 - 1e-9) * width);
  }
};

// From the edge at pair i inwards, in steps of +1 or -1, to the first pressure maximum. The drop from there to the next pair
// estimates the uncertainty of the maximum: shifting the mesh by one pair would change it by about as much. It is small for a
// smooth pressure and large for a peak at a corner.
void look_at_edge(const Looked& at, Stretch contact, int32_t i, int step, Worst& worst) {
  if (!at.has(i - step)) return;
  int32_t top = i;
  while (top + step >= contact.first && top + step <= contact.last && at.pressure(top + step) > at.pressure(top)) top += step;
  const int32_t elements = at.elements((top - i) * step + 1);
  const double width = at.width(contact);
  if (!worst.gives_way_to(elements, at.pair(i).length, width)) return;
  worst.elements = elements;
  worst.edge = at.place(i);
  worst.reach = at.pair(i).length;
  worst.width = width;
  // The maximum may lie at the end of the zone, on an axis or at a corner: then the other neighbour is used.
  const int32_t beside = at.has(top + step) ? top + step : top - step;
  const double next = at.closed(beside) ? at.pressure(beside) : 0.0;
  worst.drop = at.pressure(top) > 0.0 ? 1.0 - next / at.pressure(top) : 0.0;
}

// Corner singularity: the force in the last element, int p ds, tends to zero with its length although p is unbounded. So the
// share of the force, not the pressure, shows whether the mesh is fine enough.
struct Corner {
  int32_t pair = -1;
  double share = kMostAtCorner, rise = 0.0; // of the force; of the pressure over the one an element farther in
};

void look_at_corner(const Looked& at, Stretch contact, int32_t i, int step, Corner& worst) {
  const int32_t nodes = at.session->model.head->function_nodes, per_element = nodes > 2 ? nodes - 1 : 1;
  if (at.pair(i).tangential == 0 || contact.last - contact.first < 2 * per_element) return;
  const double p[] = {at.pressure(i), at.pressure(i + per_element * step), at.pressure(i + 2 * per_element * step)};
  // An abrupt rise over the last element only: a rise over two elements or more is a smooth gradient that the mesh resolves.
  const bool rises_as_without_bound = p[0] > 4.0 * p[1] && p[1] < 2.0 * p[2];
  if (!rises_as_without_bound || p[1] <= 0.0) return;
  double last = 0.0, all = 0.0;
  for (int32_t k = contact.first; k <= contact.last; ++k) all += at.pressure(k) * at.pair(k).weight;
  for (int32_t k = 0; k < per_element; ++k) last += at.pressure(i + k * step) * at.pair(i + k * step).weight;
  if (nodes > 1) last += 0.5 * p[1] * at.pair(i + per_element * step).weight; // this node is shared with the next element
  if (last <= worst.share * all) return;
  worst.pair = i;
  worst.share = last / all;
  worst.rise = p[0] / p[1];
}

// On an axis of symmetry the pair has no tangential freedom; the other half of the zone lies in the image.
bool is_on_axis(const Looked& at, int32_t i) { return at.pair(i).tangential == 0; }

// A small slip zone at a corner is accepted if a larger slip zone exists, because it contributes little to the work of
// friction. If one or two pairs are all that slips, the mesh does not resolve the work of friction at all.
bool is_small_at_corner(const Looked& at, Stretch s, int32_t longest) {
  constexpr int32_t kFew = 2;
  return longest <= kFew && ((s.first == at.begin && at.corner[0]) || (s.last + 1 == at.end && at.corner[1]));
}

// Examines one stick or slip zone `s`. `contact` gives the edges of the contact (none for a ring in full contact), `longest`
// the pairs of the longest slip zone. Zones that cover the whole contact have no border inside it, and a stick zone that
// reaches the edge is bounded by the edge, which is examined as such.
void look_at_friction(const Looked& at, Stretch contact, Stretch s, int32_t longest, Worst& worst) {
  const bool slips = at.pair(s.first).status == C2D_SLIP;
  const bool axis = is_on_axis(at, s.first) || is_on_axis(at, s.last);
  if (s.first == contact.first && s.last == contact.last) return;
  if (!slips && (s.first == contact.first || s.last == contact.last) && !axis) return;
  if (slips && (!at.has(s.first - 1) || !at.has(s.last + 1)) && !is_small_at_corner(at, s, longest)) return;
  const int32_t elements = (axis ? 2 : 1) * at.elements(s.last - s.first + 1);
  double reach = 0.0; // the larger uncertainty of the two borders; an axis of symmetry is exact
  const int32_t borders[] = {s.first, s.last};
  for (const int32_t border : borders)
    if ((s.first == s.last || !is_on_axis(at, border)) && at.pair(border).length > reach) reach = at.pair(border).length;
  const double width = (axis ? 2.0 : 1.0) * at.width(s);
  if (!worst.gives_way_to(elements, reach, width)) return;
  worst.elements = elements;
  worst.reach = reach;
  worst.width = width;
  worst.first = at.place(s.first);
  worst.last = at.place(s.last);
  worst.kind = slips ? "slip" : "stick";
}

// The longest stretch of pairs of one kind that begins at pair i.
Stretch zone_from(const Looked& at, int32_t i, int32_t last) {
  Stretch s = {i, i};
  while (s.last < last && kind_of(at.pair(s.last + 1)) == kind_of(at.pair(i))) ++s.last;
  return s;
}

// All stick and slip zones of these pairs. Without friction every closed pair slips, and there is nothing to resolve.
void look_at_zones(const Looked& at, Stretch pairs, Stretch contact, Worst& friction) {
  if (at.pair(pairs.first).law.is_smooth()) return;
  int32_t longest = 0;
  for (int32_t i = pairs.first; i <= pairs.last;) {
    const Stretch s = zone_from(at, i, pairs.last);
    i = s.last + 1;
    if (at.pair(s.first).status == C2D_SLIP && i - s.first > longest) longest = i - s.first;
  }
  for (int32_t i = pairs.first; i <= pairs.last;) {
    const Stretch s = zone_from(at, i, pairs.last);
    look_at_friction(at, contact, s, longest, friction);
    i = s.last + 1;
  }
}

// A ring in full contact has no edge: begin at a border between two of its zones, so that none is split.
void look_at_ring(const Looked& at, Worst& friction) {
  int32_t first = at.begin;
  while (first < at.end && kind_of(at.pair(first - 1)) == kind_of(at.pair(first))) ++first;
  if (first < at.end) look_at_zones(at, {first, first + at.end - at.begin - 1}, {-1, -1}, friction);
}

struct Found {
  Worst edge, friction;
  Corner corner;
};

void look_at_zone(const Looked& at, bool at_peak, Found& found) {
  int32_t first = at.begin; // on a ring start after an open pair, so that no stretch of contact is split
  while (at.round && first < at.end && at.closed(first - 1)) ++first;
  if (first == at.end) {
    if (at_peak) look_at_ring(at, found.friction);
    return;
  }
  const int32_t end = first + at.end - at.begin;
  for (int32_t i = first; i < end; ++i) {
    if (!at.closed(i)) continue;
    Stretch contact = {i, i};
    while (contact.last + 1 < end && at.closed(contact.last + 1)) ++contact.last;
    look_at_edge(at, contact, contact.first, 1, found.edge);
    look_at_edge(at, contact, contact.last, -1, found.edge);
    const bool ends = !kSmallCode && !at.round; // not in small code, to save memory
    if (ends && at.corner[0] && i == at.begin) look_at_corner(at, contact, i, 1, found.corner);
    if (ends && at.corner[1] && contact.last + 1 == at.end) look_at_corner(at, contact, contact.last, -1, found.corner);
    if (at_peak) look_at_zones(at, contact, contact, found.friction);
    i = contact.last;
  }
}

// Does the zone cover a whole closed curve? Then its last and first pair are neighbours.
bool goes_round(const Model& m, const Zone& z) {
  const int side = z.is_free != 0 ? 1 : 0;
  const Region& r = m.region[z.body[side]][z.region[side]];
  return r.open == 0 && zone_elements(z, side) == r.last - r.first + 1;
}

// At most 100 %, without an exponent: "1e+02 %" would be hard to read.
void put_percent(Text& out, double part) { put(out, part < 0.995 ? 100.0 * part : 100.0, part < 0.995 ? 2 : 3); }

void put_reach(Text& out, const Worst& w) {
  put(out, w.reach, 3);
  put_all(out, " (");
  put_percent(out, w.reach / w.width);
  put_all(out, " % of the width)");
}

void put_edge(Text& out, const Worst& w) {
  put_all(out, "only ", w.elements, w.elements == 1 ? " element" : " elements",
          " between the contact edge and the highest pressure; the edge is uncertain by ");
  put_reach(out, w);
  put_all(out, ", this pressure by ");
  put_percent(out, w.drop);
  put_all(out, " %");
}

void put_corner(Text& out, const Corner& w, bool more) {
  put_all(out, more ? "; " : "", "the last element before the corner at pair ", w.pair + 1, " carries ");
  put_percent(out, w.share);
  put(out, " % of the force, and the pressure rises there to ");
  put(out, w.rise, 2);
  put(out, " times that of the next element; it may be unbounded");
}

void put_zone(Text& out, const Worst& w, bool more) {
  put_all(out, more ? "; " : "", "the ", w.kind, " zone of pairs ", w.first + 1, " to ", w.last + 1, " is only ", w.elements,
          w.elements == 1 ? " element" : " elements", " wide; its border is uncertain by ");
  put_reach(out, w);
}

} // namespace

bool goes_on(const Model& m, const Zone& z, int side, int end) {
  const int b = z.body[side];
  const int32_t element = zone_element(m, z, side, end < 0 ? 0 : zone_elements(z, side) - 1);
  const int travel = end * z.element_step[side];
  const Region& r = m.region[b][z.region[side]];
  int32_t next = element + (travel > 0 ? 1 : -1);
  if (next < r.first || next > r.last) next = r.open != 0 ? -1 : (travel > 0 ? r.first : r.last);
  ZonePlace place;
  if (next < 0 || !is_integrated(m, b, next) || find_contact_element(m, b, next, &place)) return false;
  double here[2], there[2];
  outward_normal(m, b, element, travel > 0 ? 1.0 : -1.0, here);
  outward_normal(m, b, next, travel > 0 ? -1.0 : 1.0, there);
  constexpr double kTenDegrees = 0.985; // cosine
  return here[0] * there[0] + here[1] * there[1] > kTenDegrees;
}

bool tell_coarse_contact(const Session& session, bool at_peak, Text& out, int32_t* zone, int32_t* pair) {
  const Model& m = session.model;
  Found found;
  for (int32_t z = 0; z < m.head->zones; ++z) {
    const Zone& at = m.zone[z];
    if (at.is_tied != 0) continue;
    const bool corner[2] = {!goes_on(m, at, 0, -1) || !goes_on(m, at, 1, -1), !goes_on(m, at, 0, 1) || !goes_on(m, at, 1, 1)};
    look_at_zone({&session, at.first_pair, at.first_pair + at.pairs, goes_round(m, at), {corner[0], corner[1]}}, at_peak,
                 found);
  }
  const bool edge = found.edge.edge >= 0, friction = found.friction.kind != nullptr, corner = found.corner.pair >= 0;
  if (!edge && !friction && !corner) return false;
  *pair = edge ? found.edge.edge : friction ? found.friction.first : found.corner.pair;
  *zone = m.pair[*pair].zone;
  put_all(out, "coarse contact: ");
  if (edge) put_edge(out, found.edge);
  if (friction) put_zone(out, found.friction, edge);
  if (!kSmallCode && corner) put_corner(out, found.corner, edge || friction);
  put_all(out, ": refine the mesh there");
  return true;
}

} // namespace c2d
