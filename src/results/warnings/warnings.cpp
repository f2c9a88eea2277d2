// Warnings about a contact state (src/report/OUTPUT.md explains each of them).
//
// Three questions are checked after every increment of a load path:
//   - Is the model valid for this state? Contact beyond the end of a zone, large slip or sideways motion of pairs, strains and
//     rotations beyond the linear theory, overlap outside zones.
//   - Is the mesh fine enough? Coarse contact, tension between nodes, overlap between nodes, work of friction.
//   - Is the solution unique? Undetermined positions of bodies, several contact states, friction coefficients above 3.
// Every warning is given once per path: solver->warned has one bit per kind, which is tested before the check where the check
// is expensive. Checks that only make sense with a developed contact (number of elements, surfaces) run at the peak of the load
// and at the end, not while the contact is still growing.
#include <float.h>

#include "contact/let_go.hpp"
#include "memory/math.hpp"
#include "memory/text.hpp"
#include "model/body_overlaps.hpp"
#include "model/geometry.hpp"
#include "model/shape.hpp"
#include "model/symmetry.hpp"
#include "model/validate/validate_finding.hpp"
#include "results/back.hpp"
#include "results/friction_work.hpp"
#include "results/interior/between_nodes.hpp"
#include "results/warnings/coarse_contact.hpp"
#include "results/warnings/facing_meshes.hpp"
#include "results/warnings/surface_warnings.hpp"
#include "results/warnings/warnings.hpp"
#include "solver/load_path.hpp"

namespace c2d {

namespace {

int32_t bit_of(int32_t number) { return 1 << (number - C2D_WARN_ZONE_END); }

// Reports a warning once per path; zone and pair from 1, 0: none.
void warn(Session& session, int32_t number, int32_t zone, int32_t pair, const char* text) {
  c2d_solver* s = session.solver;
  const int32_t bit = bit_of(number);
  if (s->warned & bit) return;
  s->warned |= bit;
  Finding out(number);
  c2d_error& e = out.entry;
  e.zone = zone;
  e.pair = pair;
  e.load = session.follower.load[0];
  if (zone > 0) put_all(out.text, "zone ", zone_named(session.model, zone - 1), ", ");
  if (pair > 0) put_all(out.text, "pair ", pair, ", ");
  put_all(out.text, "load factor ", e.load, ", mu ", s->mu, ": ", text);
  report_fault(s, e);
}

bool is_closed(const Pair& pair) { return pair.status != C2D_OPEN; }

double pressure_of(const Session& session, int32_t pair) { return pair_state(*session.follower.t, pair, session.follower.y).p; }

// A last pair that touches initially is normal where a body ends, as at the edge of a punch. Where both surfaces continue
// beyond the zone, noticeable pressure on it shows that the zone cuts the contact off.
bool is_cut_short(const Session& session, const Zone& zone, int32_t pair, int end) {
  if (!goes_on(session.model, zone, 0, end) || !goes_on(session.model, zone, 1, end)) return false;
  double most = 0.0;
  for (int32_t i = zone.first_pair; i < zone.first_pair + zone.pairs; ++i) {
    const double p = pressure_of(session, i);
    if (p > most) most = p;
  }
  return pressure_of(session, pair) > 0.1 * most;
}

// On an axis of symmetry the zone continues in its image: such an end (pair without tangential freedom) is skipped.
void warn_zone_ends(Session& session, bool at_end) {
  const Model& m = session.model;
  for (int32_t z = 0; z < m.head->zones; ++z) {
    const Zone& zone = m.zone[z];
    if (zone.is_tied != 0) continue;
    const int32_t ends[2] = {zone.first_pair, zone.first_pair + zone.pairs - 1};
    for (int k = 0; k < 2; ++k) {
      const int32_t i = ends[k];
      const Pair& pair = m.pair[i];
      if (!is_closed(pair) || !pair.tangential) continue;
      if (pair.gap > 0.0 || (at_end && is_cut_short(session, zone, i, k == 0 ? -1 : 1)))
        warn(session, C2D_WARN_ZONE_END, z + 1, i + 1,
             "the last pair at an end of a contact zone is closed: the contact may extend beyond the zone; lengthen it");
    }
  }
}

void warn_coarse_contact(Session& session, Moment moment) {
  if (session.solver->warned & bit_of(C2D_WARN_FEW_PAIRS)) return;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  int32_t zone = 0, pair = 0;
  if (tell_coarse_contact(session, moment == Moment::peak, text, &zone, &pair))
    warn(session, C2D_WARN_FEW_PAIRS, zone + 1, pair + 1, room);
}

// With deck stepping the energies are those of whole increments (METHOD 18), too coarse for this check.
void warn_friction_work(Session& session, bool at_end) {
  const c2d_solver* s = session.solver;
  if ((s->warned & bit_of(C2D_WARN_ENERGY)) != 0 || s->keeps_energy == 0 || s->options.stepping != C2D_STEPPING_EVENTS) return;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  if (tell_friction_work(session, at_end, text)) warn(session, C2D_WARN_ENERGY, 0, 0, room);
}

constexpr double kMatters = 0.05; // of the contact length: on fine meshes a slip of several elements may be negligible

double closed_length(const Session& session, const Zone& z) {
  double sum = 0.0;
  for (int32_t i = z.first_pair; i < z.first_pair + z.pairs; ++i)
    if (is_closed(session.model.pair[i])) sum += length_at(session.model, session.model.pair[i]);
  return sum;
}

// Pairs join the points that face each other in the undeformed state. If bodies move tangentially before they touch, contact is
// computed at points that no longer face each other. Slip in contact is left to warn_slip: here only the motion before it.
void warn_sideways(Session& session) {
  if (kSmallCode || (session.solver->warned & bit_of(C2D_WARN_SIDEWAYS)) != 0) return;
  const double unit = session.model.head->length_unit;
  double most = 1.0, moved = 0.0;
  int32_t worst = -1;
  for (int32_t i = 0; i < session.model.head->path_pairs; ++i) {
    const Pair& pair = session.model.pair[i];
    if (!is_closed(pair) || pair.tangential == 0) continue;
    const double way = fabs(pair_state(*session.follower.t, i, session.follower.y).wt) * unit;
    const double slipped = fabs(slip_sum(session.follower, i)) * unit;
    if (way - slipped <= most * pair.length) continue;
    most = (way - slipped) / pair.length;
    moved = way;
    worst = i;
  }
  if (worst < 0 || moved <= kMatters * closed_length(session, session.model.zone[session.model.pair[worst].zone])) return;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  put(text, "the bodies have moved sideways by ");
  put(text, moved, 3);
  put(text, ", ");
  put(text, moved / session.model.pair[worst].length, 2);
  put(text,
      " elements, most of it before they touched, but contact is computed between points that faced each other initially; "
      "start the model where the bodies touch");
  warn(session, C2D_WARN_SIDEWAYS, session.model.pair[worst].zone + 1, worst + 1, room);
}

void warn_between_nodes(Session& session) {
  if (kSmallCode || (session.solver->warned & bit_of(C2D_WARN_BETWEEN)) != 0) return;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  int32_t zone = 0, pair = 0;
  if (tell_between_nodes(session, text, &zone, &pair)) warn(session, C2D_WARN_BETWEEN, zone + 1, pair + 1, room);
}

// Slip since the last contact, for the same reason: small-displacement theory keeps the pairs together while they slide apart.
void warn_slip(Session& session) {
  const Model& m = session.model;
  for (int32_t z = 0; z < m.head->zones; ++z) {
    const Zone& zone = m.zone[z];
    const double least = kMatters * closed_length(session, zone);
    for (int32_t i = zone.first_pair; i < zone.first_pair + zone.pairs; ++i) {
      if (!is_closed(m.pair[i])) continue;
      const double slip = fabs(slip_sum(session.follower, i) - m.pair[i].slip_before) * m.head->length_unit;
      if (slip > fmax(least, 0.5 * m.pair[i].length))
        warn(
            session, C2D_WARN_LARGE_SLIP, z + 1, i + 1,
            "slip since it last touched exceeds half a contact element and 5 % of the contact length: its nodes no longer face "
            "each other");
    }
  }
}

// Coefficients of 1e6 and more are taken as adhesion. In between solutions of the Coulomb problem need not exist or be unique
// (Klarbring, Ingenieur-Archiv 60, 1990).
void warn_friction(Session& session) {
  for (int32_t i = 0; i < session.model.head->path_pairs; ++i) {
    const Pair& pair = session.model.pair[i];
    if (pair.law.mu > 3.0 && pair.law.mu < 1e6)
      return warn(session, C2D_WARN_FRICTION, pair.zone + 1, 0,
                  "the coefficient of friction is above 3: contact states may not be unique, or not exist");
  }
}

// Interpolated pressure at eta of a contact element; ends without a pair carry none.
double pressure_inside(const Session& session, int b, int32_t element, double eta) {
  const int nf = session.model.head->function_nodes;
  double shapes[kElementNodes], sum = 0.0;
  shape(nf, eta, shapes);
  for (int l = 0; l < nf; ++l) {
    const int32_t pair = pair_of_end(session.model, b, element, l).pair;
    if (pair >= 0) sum += shapes[l] * pressure_of(session, pair);
  }
  return sum;
}

// Is the contact without force? Forces below the round-off of the largest earlier pressure, or of stiffness times the largest
// motion, count as zero.
bool carries_nothing(const Session& session) {
  const PathScales s = path_scales(session.follower);
  return s.p <= fmax(kNoPressure * session.solver->peak_pressure, kMixedNoise * session.tableau.stiffness * s.w);
}

bool is_loaded(const Session& session) {
  for (int32_t k = 0; k < session.tableau.cases; ++k)
    if (session.follower.load[k] != 0.0) return true;
  return false;
}

double without_noise(double number) { return fabs(number) < 1e-9 ? 0.0 : number; }

// The undetermined motion of a body: a direction or a centre of rotation if it is a single one, else the number of motions.
void put_free_motion(const Session& session, int32_t count, const double motion[3], Text& text) {
  const FreeBody& body = session.free_body;
  const double turn = motion[2] / session.model.head->length_unit, size = hypot(motion[0], motion[1]);
  if (count > 1)
    put_all(text, "in any of its ", count, " free motions");
  else if (fabs(motion[2]) < 1e-9 * size)
    put_all(text, "in the direction (", without_noise(motion[0] / size), ", ", without_noise(motion[1] / size), ")");
  else
    put_all(text, "in its rotation about (", body.centre[0] - motion[1] / turn, ", ", body.centre[1] + motion[0] / turn, ")");
}

void put_free_body(const Session& session, Text& text) {
  const FreeBody& body = session.free_body;
  if (body.body < 0)
    put(text, "the bodies that only contact supports");
  else
    put_all(text, "body ", body_named(session.model, body.body));
}

// Nothing determines the position of a body if it has separated, touches without force under load, slides without friction, or
// keeps a motion that the contact does not resist. Stresses are unique all the same; displacements are not.
void warn_undefined_place(Session& session) {
  const FreeBody& body = session.free_body;
  if (session.solver->outcome != C2D_REACHED || body.motions == 0) return;
  // idle: separated or without force, so that every free motion is undetermined.
  const bool idle = is_let_go(session.tableau) || (is_loaded(session) && carries_nothing(session));
  const int32_t resting = is_loaded(session) ? session.tableau.resting : 0;
  if (!idle && resting == 0 && (body.slides == 0 || !is_loaded(session))) return;
  const bool several = body.body < 0;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  put(text, "no contact force determines the position of ");
  put_free_body(session, text);
  if (!several) put(text, " ");
  if (!idle && resting > 0)
    put_all(text, several ? " in " : "in ", resting, resting > 1 ? " motions" : " motion", " that the contact leaves free");
  else if (!several && idle)
    put_free_motion(session, body.motions, body.others() == 1 ? body.motion : body.slide, text);
  else if (!several)
    put_free_motion(session, body.slides, body.slide, text);
  put_all(text, ": this displacement is arbitrary, forces and stresses are not; ",
          several ? "they keep their positions" : "it keeps its position", " relative to the other bod",
          session.model.head->bodies > 2 ? "ies" : "y");
  warn(session, C2D_WARN_UNDEFINED_PLACE, 0, 0, room);
}

} // namespace

double tension_ratio(const Session& session) {
  const Model& m = session.model;
  if (m.head->function_nodes < 3) return 0.0; // constant and linear functions have their minimum at nodes
  if (carries_nothing(session)) return 0.0;
  double most = 0.0, least = 0.0;
  for (int32_t z = 0; z < m.head->zones; ++z)
    for (int32_t k = 0; k < m.zone[z].elements && m.zone[z].is_tied == 0; ++k)
      for (int sample = -10; sample <= 10; ++sample) {
        const Zone& zone = m.zone[z];
        const int side = zone.is_free != 0 ? 1 : 0; // the side on which tau is interpolated
        const double p = pressure_inside(session, zone.body[side], zone_element(m, zone, side, k), 0.1 * sample);
        if (p < least) least = p;
      }
  for (int32_t i = 0; i < m.head->path_pairs; ++i) {
    const double p = pressure_of(session, i);
    if (p > most) most = p;
  }
  return most > 0.0 ? least / most : 0.0;
}

namespace {

// The largest value over all elements, with its place.
struct Largest {
  double size = 0.0;
  int body = 0;
  int32_t element = 0;
  void add(double number, int b, int32_t e) {
    if (number <= (1.0 + 1e-9) * size) return; // equal up to round-off, as on mirrored elements: keep the first
    size = number;
    body = b;
    element = e;
  }
};

void tell_largest(Session& session, int32_t number, const Largest& most, const char* what, const char* limit) {
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  put_all(text, what, " reach ");
  put(text, most.size, 2);
  put_all(text, " at element ", most.element + 1, " of body ", body_named(session.model, most.body), limit);
  warn(session, number, 0, 0, room);
}

// Start of an element in the deformed state.
void start_moved(const void* context, const Model& m, int b, int32_t element, double p[2]) {
  double u[2];
  get_displacement(*static_cast<const Session*>(context), b, functional_node(m, b, element, 0), u);
  start_as_made(context, m, b, element, p);
  for (int c = 0; c < 2; ++c) p[c] += u[c];
}

// Bodies that overlap in the deformed state outside their zones. Overlaps of the undeformed state were reported when the model
// was completed.
void warn_overlapping(Session& session) {
  constexpr double kDriven = 0.5, kOfBody = 1e-3; // least depth: over the element, over the smaller body
  constexpr double kMore = 1.5;                   // times the initial depth, which has been reported already
  const Model& m = session.model;
  const BodyOverlap now = deepest_overlap(m, start_moved, &session, kDriven, kOfBody, false);
  if (now.depth == 0.0) return;
  const BodyOverlap before = deepest_overlap(m, start_as_made, nullptr, 0.0, 0.0, true);
  if (now.depth <= kMore * before.depth) return;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  put(text, "at the load reached ");
  put_overlap(text, m, now);
  warn(session, C2D_WARN_OVERLAPPING, 0, 0, room);
}

} // namespace

// Strains and rotations of boundary elements. The strain along an element follows from its end displacements, the strain across
// it from the normal traction by Hooke's law in plane strain: e_nn = ((1 - 2 nu) s_nn/(2G) - nu e_ss)/(1 - nu). The largest
// strain of a body without body forces is nearly always on its boundary.
void warn_strains(Session& session) {
  const Model& m = session.model;
  const int32_t nf = m.head->function_nodes;
  Largest strain, rotation;
  for (int b = 0; b < m.head->bodies; ++b)
    for (int32_t e = 0; nf > 1 && !is_rigid(m, b) && e < m.body[b].elements; ++e) {
      double x[kElementNodes], y[kElementNodes], u[2], v[2], t[2];
      element_coordinates(m, b, e, x, y);
      const int last = m.body[b].element_nodes - 1;
      const double dx = x[last] - x[0], dy = y[last] - y[0], square = fmax(dx * dx + dy * dy, DBL_MIN);
      if (!is_integrated(m, b, e)) continue;
      get_displacement(session, b, functional_node(m, b, e, 0), u);
      get_displacement(session, b, functional_node(m, b, e, nf - 1), v);
      get_traction(session, b, e * nf, t);
      const double along = ((v[0] - u[0]) * dx + (v[1] - u[1]) * dy) / square;
      const double pull = (t[0] * dy - t[1] * dx) / sqrt(square), nu = strain_poisson_ratio(m, b);
      const double across = ((1.0 - 2.0 * nu) * pull / (2.0 * shear_modulus(m, b)) - nu * along) / (1.0 - nu);
      strain.add(fmax(fabs(along), fabs(across)), b, e);
      rotation.add(fabs(dx * (v[1] - u[1]) - dy * (v[0] - u[0])) / square, b, e);
    }
  if (strain.size > 0.05)
    tell_largest(session, C2D_WARN_STRAIN, strain, "strains", ": the theory assumes small strains, below 0.05");
  else if (!kSmallCode && rotation.size > 0.1)
    tell_largest(session, C2D_WARN_ROTATION, rotation, "rotations", ": the theory assumes small rotations, below 0.1");
  if (!kSmallCode) warn_overlapping(session);
}

void warn_contact(Session& session, Moment moment) {
  c2d_solver* s = session.solver;
  if (s->model.contact == 0 || s->floating || s->blocked) return;
  warn_undefined_place(session);
  warn_zone_ends(session, moment != Moment::between);
  if (moment != Moment::between) warn_coarse_contact(session, moment);
  if (moment != Moment::between) warn_surfaces(session);
  if (moment != Moment::between) warn_between_nodes(session);
  warn_friction_work(session, moment != Moment::between);
  note_open_pairs(session);
  warn_slip(session);
  warn_sideways(session);
  warn_friction(session);
  const double ratio = tension_ratio(session);
  if (ratio < s->tension_ratio) s->tension_ratio = ratio;
  if (ratio < -0.01 && moment != Moment::between)
    warn(session, C2D_WARN_TENSION, 0, 0,
         "the pressure inside a contact element falls below -1 % of the largest nodal pressure: contact conditions "
         "are enforced at nodes only; refine, or use linear functions");
  if (session.follower.stats.unconverged > 0)
    warn(session, C2D_WARN_INCREMENT, 0, 0,
         "an increment did not converge within the iteration limit and was completed by event stepping");
}

// At a load that has been reached; not in small code.
void warn_facing_meshes(Session& session) {
  if (kSmallCode) return;
  char room[sizeof(c2d_error::text)];
  Text text = text_in(room);
  int32_t zone = 0, pair = 0;
  if (!session.solver->floating && session.model.head->contact > 0 && tell_facing_meshes(session, text, &zone, &pair))
    warn(session, C2D_WARN_SIZES, zone + 1, pair + 1, room);
}

// Once per path. Two kinds: a continuous range of positions with the same forces (METHOD 13.7), or several distinct states.
void warn_not_unique(Session& session) {
  Follower& f = session.follower;
  c2d_solver* s = session.solver;
  const int32_t bit = bit_of(C2D_WARN_NOT_UNIQUE);
  if (f.solutions < 2 || (s->warned & bit) != 0) return;
  s->warned |= bit;
  Finding out(C2D_WARN_NOT_UNIQUE);
  out.entry.load = f.solutions_load;
  put_all(out.text, "load factor ", out.entry.load, ", mu ", s->mu, ": the solution is not unique: ");
  if (f.range) {
    put(out.text, "friction is at its limit at all pairs that support ");
    put_free_body(session, out.text);
    put_all(out.text, ", whose position may vary over a range at the same forces; ",
            s->options.stepping == C2D_STEPPING_DECK ? "the stepping of 1987 selects some position in it"
                                                     : "the position that moves the pairs least is selected");
  } else {
    put_all(out.text, f.more_solutions ? "at least " : "", f.solutions,
            " contact states satisfy all conditions; the one with the least change of motion is selected, of equal ones the "
            "first by pairs");
  }
  report_fault(s, out.entry);
}

void warn_breach(c2d_solver* s) {
  constexpr const char* kWhat[] = {"",
                                   "the residual of the contact tableau",
                                   "the residual of the contact equations",
                                   "the imbalance of forces on the free body",
                                   "a negative pressure or gap",
                                   "friction above its limit",
                                   "slip in the direction of its friction"};
  Finding out(C2D_WARN_RESIDUAL);
  out.entry.load = array_of<double>(s, kLoads)[0];
  put_all(out.text, "the path ends at load factor ", out.entry.load, ": beyond it ");
  if (s->breach == C2D_BREACH_SINGULAR)
    put(out.text, "the contact equations have no unique solution");
  else
    put_all(out.text, kWhat[s->breach], " is ", s->breach_size, " of the largest, even with a rebuilt tableau");
  report_fault(s, out.entry);
}

} // namespace c2d
