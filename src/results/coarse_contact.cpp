#include "results/coarse_contact.hpp"

namespace c2d {

namespace {

// The pairs first ... last of a zone, all of them alike.
struct Stretch {
  int32_t first, last;
};

struct Looked {
  const Session* session;
  const Zone* zone;
  int32_t begin, end; // pairs of the zone: begin ... end - 1

  const Pair& pair(int32_t i) const { return session->model.pair[i]; }
  bool has(int32_t i) const { return i >= begin && i < end; }
  bool closed(int32_t i) const { return has(i) && pair(i).status != C2D_OPEN; }
  double pressure(int32_t i) const { return pair_state(*session->follower.t, i, session->follower.y).p; }
  // Half-closed elements at the borders count.
  int32_t elements(int32_t pairs) const {
    const int32_t per_element = session->model.head->function_nodes > 2 ? session->model.head->function_nodes - 1 : 1;
    return (pairs + per_element - 1) / per_element;
  }
  double width(Stretch s) const {
    double sum = 0.0;
    for (int32_t i = s.first; i <= s.last; ++i) sum += pair(i).weight;
    return sum * session->model.head->length_unit;
  }
};

// What sticks, slips to one side or to the other; pairs that cannot slip go with what sticks.
int32_t kind_of(const Pair& pair) { return pair.status == C2D_SLIP ? 10 + pair.sign : pair.status; }

struct Worst {
  int32_t elements = kFewElements - 1, edge = -1;
  double reach = 0.0, width = 0.0;
  Stretch stretch = {0, 0};
  const char* kind = nullptr;
  // Fewer elements; of as many the border that may be farther off, wherever the pairs begin to count.
  bool gives_way_to(int32_t other, double other_reach) const {
    return other < elements || (other == elements && other_reach > (1.0 + 1e-9) * reach);
  }
};

// From the edge at pair i inwards, in steps of +1 or -1, to the first highest pressure.
void look_at_edge(const Looked& at, Stretch contact, int32_t i, int step, Worst& worst) {
  if (!at.has(i - step)) return;
  int32_t top = i;
  while (top + step >= contact.first && top + step <= contact.last && at.pressure(top + step) > at.pressure(top)) top += step;
  const int32_t elements = at.elements((top - i) * step + 1);
  if (!worst.gives_way_to(elements, at.pair(i).length)) return;
  worst.elements = elements;
  worst.edge = i;
  worst.reach = at.pair(i).length;
  worst.width = at.width(contact);
  worst.stretch = contact;
}

// A symmetric half of a zone has the other half beyond the pair that cannot slip.
bool is_on_axis(const Looked& at, int32_t i) { return at.has(i) && at.pair(i).tangential == 0; }

void look_at_friction(const Looked& at, Stretch contact, Stretch s, Worst& worst) {
  const bool slips = at.pair(s.first).status == C2D_SLIP;
  if (!slips && (s.first == contact.first || s.last == contact.last) && !is_on_axis(at, s.first) && !is_on_axis(at, s.last))
    return;                                                           // what sticks up to an edge
  if (slips && (!at.has(s.first - 1) || !at.has(s.last + 1))) return; // up to a corner
  if (s.first == contact.first && s.last == contact.last) return;
  const bool half = is_on_axis(at, s.first) || is_on_axis(at, s.last);
  const int32_t elements = (half ? 2 : 1) * at.elements(s.last - s.first + 1);
  double reach = 0.0; // of both borders; an axis is none
  const int32_t borders[] = {s.first, s.last};
  for (const int32_t border : borders)
    if ((s.first == s.last || !is_on_axis(at, border)) && at.pair(border).length > reach) reach = at.pair(border).length;
  if (!worst.gives_way_to(elements, reach)) return;
  worst.elements = elements;
  worst.reach = reach;
  worst.width = (half ? 2.0 : 1.0) * at.width(s);
  worst.stretch = s;
  worst.kind = slips ? "slip" : "stick";
}

void look_at_contact(const Looked& at, Stretch contact, bool at_peak, Worst& edge, Worst& friction) {
  look_at_edge(at, contact, contact.first, 1, edge);
  look_at_edge(at, contact, contact.last, -1, edge);
  if (!at_peak || at.pair(contact.first).mu == 0.0) return;
  for (int32_t i = contact.first; i <= contact.last;) {
    Stretch s = {i, i};
    while (s.last < contact.last && kind_of(at.pair(s.last + 1)) == kind_of(at.pair(i))) ++s.last;
    look_at_friction(at, contact, s, friction);
    i = s.last + 1;
  }
}

void put_reach(Text& out, const Worst& w) {
  const double percent = w.width > 0.0 ? 100.0 * w.reach / w.width : 100.0;
  put(out, w.reach, 3);
  put_all(out, ", ");
  put(out, percent < 99.5 ? percent : 100.0, percent < 99.5 ? 2 : 3);
  put_all(out, " % of the width");
}

} // namespace

bool tell_coarse_contact(const Session& session, bool at_peak, Text& out, int32_t* zone, int32_t* pair) {
  const Model& m = session.model;
  Worst edge, friction;
  for (int32_t z = 0; z < m.head->zones; ++z) {
    const Looked at = {&session, &m.zone[z], m.zone[z].first_pair, m.zone[z].first_pair + m.zone[z].pairs};
    for (int32_t i = at.begin; i < at.end; ++i) {
      if (!at.closed(i)) continue;
      Stretch contact = {i, i};
      while (at.closed(contact.last + 1)) ++contact.last;
      look_at_contact(at, contact, at_peak, edge, friction);
      i = contact.last;
    }
  }
  if (edge.edge < 0 && !friction.kind) return false;
  *pair = edge.edge >= 0 ? edge.edge : friction.stretch.first;
  *zone = m.pair[*pair].zone;
  put_all(out, "coarse contact: ");
  if (edge.edge >= 0) {
    put_all(out, "the pressure rises from the edge to its highest over only ", edge.elements,
            edge.elements == 1 ? " element" : " elements", "; the edge may be off by ");
    put_reach(out, edge);
  }
  if (friction.kind) {
    put_all(out, edge.edge >= 0 ? "; the zone of " : "the zone of ", friction.kind, " of pairs ", friction.stretch.first + 1,
            " to ", friction.stretch.last + 1, " holds only ", friction.elements,
            friction.elements == 1 ? " element" : " elements", "; its border may be off by ");
    put_reach(out, friction);
  }
  put_all(out, ": refine there, to 4 elements or more");
  return true;
}

} // namespace c2d
