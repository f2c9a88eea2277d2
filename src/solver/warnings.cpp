// What a user should know about a contact state: each warning once per path (design: warnings).
#include <math.h>

#include "bie/shape.hpp"
#include "memory/text.hpp"
#include "model/geometry.hpp"
#include "solver/session.hpp"

namespace c2d {

namespace {

void warn(Session& session, int32_t number, int32_t zone, int32_t pair, const char* text) {
  c2d_solver* s = session.solver;
  const int32_t bit = 1 << (number - C2D_WARN_ZONE_END);
  if (s->warned & bit) return;
  s->warned |= bit;
  c2d_error e = blank_error();
  e.status = number;
  e.severity = C2D_WARNING;
  e.zone = zone;
  e.pair = pair;
  e.load = session.follower.load[0];
  Text out = text_in(e.text);
  if (zone > 0) {
    put_all(out, "zone ", zone, ", ");
  }
  if (pair > 0) {
    put_all(out, "pair ", pair, ", ");
  }
  put_all(out, "load factor ", e.load, ", mu ", s->mu, ": ", text);
  report_fault(s, e);
}

bool is_closed(const Pair& pair) { return pair.status != C2D_OPEN; }

double pressure_of(const Session& session, int32_t pair) {
  return pair_state(*session.follower.t, pair, session.follower.y).p;
}

// Does body b's surface go on beyond an end (-1: first, +1: last) of a zone without a corner, and out of
// contact zones?
bool goes_on(const Model& m, const Zone& z, int b, int end) {
  const int32_t element = zone_element(m, z, b, end < 0 ? 0 : zone_elements(z, b) - 1);
  const int travel = end * z.element_step[b];
  const Region& r = m.region[b][z.region[b]];
  int32_t next = element + (travel > 0 ? 1 : -1);
  if (next < r.first || next > r.last) next = r.open != 0 ? -1 : (travel > 0 ? r.first : r.last);
  int32_t zone, place;
  if (next < 0 || !is_integrated(m, b, next) || find_contact_element(m, b, next, &zone, &place)) return false;
  double here[2], there[2];
  outward_normal(m, b, element, travel > 0 ? 1.0 : -1.0, here);
  outward_normal(m, b, next, travel > 0 ? -1.0 : 1.0, there);
  constexpr double kTenDegrees = 0.985; // cosine
  return here[0] * there[0] + here[1] * there[1] > kTenDegrees;
}

// A pair that touches from the start says nothing about the zone where a body ends, as at the edge of a
// punch. Where both surfaces go on, pressure on it does.
bool is_cut_short(const Session& session, const Zone& zone, int32_t pair, int end) {
  if (!goes_on(session.model, zone, 0, end) || !goes_on(session.model, zone, 1, end)) return false;
  double most = 0.0;
  for (int32_t i = zone.first_pair; i < zone.first_pair + zone.pairs; ++i) {
    const double p = pressure_of(session, i);
    if (p > most) most = p;
  }
  return pressure_of(session, pair) > 0.1 * most;
}

// An end of a zone where symmetry holds the pair is no end of the contact.
void warn_zone_ends(Session& session, bool at_end) {
  const Model& m = session.model;
  for (int32_t z = 0; z < m.head->zones; ++z) {
    const Zone& zone = m.zone[z];
    const int32_t ends[2] = {zone.first_pair, zone.first_pair + zone.pairs - 1};
    for (int k = 0; k < 2; ++k) {
      const int32_t i = ends[k];
      const Pair& pair = m.pair[i];
      if (!is_closed(pair) || !pair.tangential) continue;
      if (pair.gap > 0.0)
        warn(session, C2D_WARN_ZONE_END, z + 1, i + 1,
             "the last pair at an end of a contact zone has closed: the contact may reach further than the zone");
      else if (at_end && is_cut_short(session, zone, i, k == 0 ? -1 : 1))
        warn(session, C2D_WARN_ZONE_END, z + 1, i + 1,
             "the last pair at an end of a contact zone carries pressure: the contact may reach further than "
             "the zone");
    }
  }
}

void warn_few_pairs(Session& session) {
  int32_t touching = 0;
  for (int32_t i = 0; i < session.model.head->pairs; ++i) touching += is_closed(session.model.pair[i]);
  if (touching > 0 && touching < 5)
    warn(session, C2D_WARN_FEW_PAIRS, 0, 0, "fewer than 5 pairs touch: refine the contact zone");
}

void warn_slip(Session& session) {
  const double unit = session.model.head->length_unit;
  for (int32_t i = 0; i < session.model.head->pairs; ++i)
    if (fabs(slip_sum(session.follower, i)) * unit > 0.5 * session.model.pair[i].length)
      warn(session, C2D_WARN_LARGE_SLIP, session.model.pair[i].zone + 1, i + 1,
           "slip exceeds half a contact element: pairs no longer face each other");
}

// Pressure at eta of a contact element, from its listed ends.
double pressure_inside(const Session& session, int b, int32_t element, double eta) {
  const int nf = session.model.head->function_nodes;
  double shapes[4], sum = 0.0;
  shape(nf, eta, shapes);
  for (int l = 0; l < nf; ++l) {
    const int32_t pair = pair_of_end(session.model, b, element, l);
    if (pair >= 0) sum += shapes[l] * pressure_of(session, pair);
  }
  return sum;
}

} // namespace

double tension_ratio(const Session& session) {
  const Model& m = session.model;
  if (m.head->function_nodes < 3 || m.head->contact == 0 || session.solver->floating || session.solver->blocked)
    return 0.0; // constant and linear pressures have no minimum inside
  double most = 0.0, least = 0.0;
  for (int32_t z = 0; z < m.head->zones; ++z)
    for (int32_t k = 0; k < m.zone[z].elements; ++k)
      for (int sample = -10; sample <= 10; ++sample) {
        const int b = m.zone[z].is_free != 0 ? 1 : 0; // where tau has its shape functions
        const double p = pressure_inside(session, b, zone_element(m, m.zone[z], b, k), 0.1 * sample);
        if (p < least) least = p;
      }
  for (int32_t i = 0; i < m.head->pairs; ++i) {
    const double p = pressure_of(session, i);
    if (p > most) most = p;
  }
  return most > 0.0 ? least / most : 0.0;
}

void warn_contact(Session& session, bool at_end) {
  c2d_solver* s = session.solver;
  if (s->model.contact == 0 || s->floating || s->blocked) return;
  warn_zone_ends(session, at_end);
  if (at_end) warn_few_pairs(session);
  warn_slip(session);
  const double ratio = tension_ratio(session);
  if (ratio < s->tension_ratio) s->tension_ratio = ratio;
  if (ratio < -0.01)
    warn(session, C2D_WARN_TENSION, 0, 0,
         "the pressure inside a contact element falls below -1 % of the largest nodal pressure: contact conditions "
         "hold at nodes only; refine, or use linear functions");
  if (session.follower.stats.unconverged > 0)
    warn(session, C2D_WARN_INCREMENT, 0, 0,
         "an increment did not converge within the iteration limit and was finished by following events");
}

} // namespace c2d
