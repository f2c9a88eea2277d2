#include "solver/cycle.hpp"

#include <float.h>
#include <string.h>

#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "solver/energy/energy.hpp"
#include "solver/judge.hpp"
#include "solver/load_path.hpp"

namespace c2d {

C2D_USES(EnergyPart);

namespace {

constexpr int kChange = 2, kMemory = 4; // numbers of a direction for each pair
static_assert(sizeof(CycleMemory) == kMemory * sizeof(double), "a direction has the numbers of CycleMemory");
static_assert(sizeof(CyclePair) <= 128 && sizeof(CycleHead) <= 2 * 128, "contact2d_memory.h has room for these");

// A direction whose change is less than this part of itself lies in the span of those before.
constexpr double kDependent = 1e-8;
constexpr double kNothing = 1e-14; // of the largest value: round-off
// What is left of the way to the fixed point: slip that vanishes there makes no event there, and the next cycle would be
// another one. More of it is left after a cycle that was another one, and less after one that was not.
constexpr double kGain = 0.7; // of the change of the cycle before, that an extrapolation has to leave at most
constexpr double kLeastLeft = 1e-3, kMostLeft = 0.3;
// Near the tolerance the last digits decide about events.
constexpr double kNear = 100.0; // times the tolerance
// Cycles with the same events before the first extrapolation. Fast: none, as the difference of two cycles leads on all the
// same.
constexpr int32_t kRepeats = 3;

int32_t pairs_of(const Session& session) { return session.tableau.pairs; }

uint64_t mixed(uint64_t x) { // (Steele, Lea, Flood 2014)
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
  x = (x ^ x >> 27) * 0x94d049bb133111ebu;
  return x ^ x >> 31;
}
uint64_t code_of(int32_t pair, int8_t status, int8_t sign) {
  return static_cast<uint64_t>(pair) * 16 + static_cast<uint64_t>(status * 3 + sign + 1);
}

double* direction_of(const Session& session, const CycleRecord& record, int32_t i) {
  return record.direction + static_cast<int64_t>(i) * (kChange + kMemory) * pairs_of(session);
}

double gap_now(const Session& session, int32_t i) { return follows_slip(session.tableau) ? session.tableau.slip[i].now : 0.0; }
CycleMemory memory_of(const Session& session, int32_t i) {
  const Pair& pair = session.model.pair[i];
  return {pair.offset, pair.slip_done, pair.slip_from, gap_now(session, i)};
}

void note_slip(const Session& session, CyclePair& seen, int32_t i) {
  const double slip = slip_sum(session.follower, i);
  seen.least = fmin(seen.least, slip);
  seen.most = fmax(seen.most, slip);
  const Pair& pair = session.model.pair[i];
  if (pair.status != C2D_STICK) seen.sticks = 0;
  if (pair.status != C2D_OPEN) seen.touches = 1;
}

// After a change of statuses. Those of one segment count alike in any order: at one load it is up to round-off, and pairs that
// are far from each other hardly know of it.
void note_pairs(Session& session) {
  const CycleRecord record = cycle_record(session.solver);
  for (int32_t i = 0; i < pairs_of(session); ++i) {
    const Pair& pair = session.model.pair[i];
    CyclePair& seen = record.pair[i];
    note_slip(session, seen, i);
    if (pair.status == seen.status && pair.sign == seen.sign) continue;
    record.head->segment += mixed(mixed(code_of(i, seen.status, seen.sign)) ^ code_of(i, pair.status, pair.sign));
    seen.status = pair.status;
    seen.sign = pair.sign;
  }
}

c2d_status note_change(void* context, double load) {
  Session& session = *static_cast<Session*>(context);
  note_pairs(session);
  return path_watch(session).changed(context, load);
}

} // namespace

CycleRecord cycle_record(c2d_solver* s) {
  char* const at = array_of<char>(s, kCycles);
  CyclePair* const pair = reinterpret_cast<CyclePair*>(at + 2 * 128);
  return {reinterpret_cast<CycleHead*>(at), pair, reinterpret_cast<double*>(pair + s->model.path_pairs)};
}

void start_cycles(Session& session) {
  const CycleRecord record = cycle_record(session.solver);
  memset(static_cast<void*>(record.head), 0, sizeof *record.head);
  memset(static_cast<void*>(record.pair), 0, static_cast<size_t>(pairs_of(session)) * sizeof *record.pair);
}

void begin_cycle(Session& session) {
  const CycleRecord record = cycle_record(session.solver);
  CycleHead& head = *record.head;
  head.events = head.segment = 0;
  for (int32_t i = 0; i < pairs_of(session); ++i) {
    const Pair& pair = session.model.pair[i];
    CyclePair& seen = record.pair[i];
    const PairState now = pair_state(session.tableau, i, session.follower.y);
    seen.p = now.p, seen.q = now.q, seen.wn = now.wn, seen.wt = now.wt;
    seen.status = pair.status, seen.sign = pair.sign;
    seen.sticks = pair.tangential, seen.touches = 0;
    seen.slip = seen.least = seen.most = slip_sum(session.follower, i);
    note_slip(session, seen, i);
    head.events = mixed(head.events ^ code_of(i, pair.status, pair.sign));
  }
  head.dissipated_before = session.solver->dissipated;
  if (session.solver->options.stepping == C2D_STEPPING_EVENTS) session.follower.watch.changed = note_change;
}

void note_corner(Session& session) {
  note_pairs(session);
  CycleHead& head = *cycle_record(session.solver).head;
  head.events = mixed(head.events ^ head.segment);
  head.segment = 0;
}

namespace {

double coefficient_of(const Session& session, int32_t pair) {
  c2d_solver* s = session.solver;
  return coefficient_of_zone(s, session.model.pair[pair].zone, s->coefficient - 1);
}

} // namespace

void stop_friction(Session& session) {
  for (int32_t i = 0; i < pairs_of(session); ++i)
    if (session.model.pair[i].law.has_bound()) session.model.pair[i].law.mu = 0.0;
  note_free_body(session);
}

c2d_status start_friction(Session& session) {
  c2d_status status = judge(session, Agree::values); // the state becomes that to which return_to_good returns
  if (status != C2D_OK) return status == kUnsound ? c2d_status{C2D_OK} : status;
  for (int32_t i = 0; i < pairs_of(session); ++i) {
    Pair& pair = session.model.pair[i];
    if (pair.status == C2D_SLIP && pair.tangential && coefficient_of(session, i) > 0.0) {
      pair.good_status = C2D_STICK;
      pair.good_sign = 0;
      pair.good_slip_done = static_cast<Real>(slip_sum(session.follower, i));
      pair.good_offset = static_cast<Real>(pair_state(session.tableau, i, session.follower.y).wt);
    }
  }
  for (int32_t i = 0; i < pairs_of(session); ++i) session.model.pair[i].law.mu = coefficient_of(session, i);
  note_free_body(session);
  status = return_to_good(session);
  return status == C2D_ERR_SINGULAR ? c2d_status{C2D_OK} : status; // the next segment of the path says so
}

double least_slip(const CycleHead& head) { return fmax(1e-9, 10.0 * head.change) * head.w_scale; }

namespace {

// ---- what a cycle came to ------------------------------------------------------------------------------------------------

// The largest change over the cycle; those of the pairs by the scales at which directions were begun.
void find_change(const Session& session, const CycleRecord& record) {
  CycleHead& head = *record.head;
  const Follower& f = session.follower;
  const double p_scale = fmax(f.pressure_scale, DBL_MIN), w_scale = fmax(f.gap_scale, DBL_MIN); // 0: nothing has touched
  if (head.repeated <= 1) head.p_scale = p_scale, head.w_scale = w_scale;
  head.change = 0.0;
  for (int32_t i = 0; i < pairs_of(session); ++i) {
    const CyclePair& seen = record.pair[i];
    const PairState now = pair_state(session.tableau, i, f.y);
    head.change = fmax(head.change, fmax(fabs(now.p - seen.p), fabs(now.q - seen.q)) / p_scale);
    head.change = fmax(head.change, fabs(now.wn - seen.wn) / w_scale);
  }
}

void take_change(const Session& session, const CyclePair& seen, const CycleHead& head, int32_t i, double out[2]) {
  const PairState now = pair_state(session.tableau, i, session.follower.y);
  out[0] = (now.p - seen.p) / head.p_scale + (now.wn - seen.wn) / head.w_scale; // one of them is 0
  out[1] = (now.q - seen.q) / head.p_scale;
}

void close_pairs(const Session& session, const CycleRecord& record) {
  for (int32_t i = 0; i < pairs_of(session); ++i) {
    CyclePair& seen = record.pair[i];
    seen.range = seen.most - seen.least;
    seen.walk = pair_state(session.tableau, i, session.follower.y).wt - seen.wt;
    seen.stuck = seen.sticks;
    seen.touched = seen.touches;
  }
}

// ---- directions ------------------------------------------------------------------------------------------------------------

struct Direction {
  double* change; // [2 pairs]
  double* memory; // [4 pairs]
  int32_t pairs;
};
Direction direction(const Session& session, const CycleRecord& record, int32_t i) {
  double* const at = direction_of(session, record, i);
  return {at, at + static_cast<int64_t>(kChange) * pairs_of(session), pairs_of(session)};
}

double product(const Direction& a, const double* change) {
  double sum = 0.0;
  for (int32_t i = 0; i < kChange * a.pairs; ++i) sum += a.change[i] * change[i];
  return sum;
}
double norm(const Direction& a) { return sqrt(product(a, a.change)); }

void add(const Direction& to, double factor, const Direction& a) {
  for (int32_t i = 0; i < kChange * a.pairs; ++i) to.change[i] += factor * a.change[i];
  for (int32_t i = 0; i < kMemory * a.pairs; ++i) to.memory[i] += factor * a.memory[i];
}

// The difference of this cycle and the one before, orthonormal to those kept.
void keep_direction(const Session& session, const CycleRecord& record) {
  CycleHead& head = *record.head;
  if (head.directions >= session.solver->sizes.cycle_states) head.directions = 0; // begin anew
  const Direction now = direction(session, record, head.directions);
  for (int32_t i = 0; i < now.pairs; ++i) {
    const CyclePair& seen = record.pair[i];
    double change[kChange];
    take_change(session, seen, head, i, change);
    for (int k = 0; k < kChange; ++k) now.change[kChange * i + k] = change[k] - seen.change[k];
    const CycleMemory end = memory_of(session, i);
    const double difference[kMemory] = {end.offset - seen.end.offset, end.slip_done - seen.end.slip_done,
                                        end.slip_from - seen.end.slip_from, end.gap - seen.end.gap};
    for (int k = 0; k < kMemory; ++k) now.memory[kMemory * i + k] = difference[k];
  }
  const double whole = norm(now);
  for (int round = 0; round < 2; ++round)
    for (int32_t j = 0; j < head.directions; ++j) {
      const Direction other = direction(session, record, j);
      add(now, -product(other, now.change), other);
    }
  const double left = norm(now);
  if (!(left > kDependent * whole) || !(left > kNothing)) return;
  for (int32_t i = 0; i < kChange * now.pairs; ++i) now.change[i] /= left;
  for (int32_t i = 0; i < kMemory * now.pairs; ++i) now.memory[i] /= left;
  ++head.directions;
}

// Of the cycle that has ended here.
void keep_end(const Session& session, const CycleRecord& record) {
  for (int32_t i = 0; i < pairs_of(session); ++i) {
    CyclePair& seen = record.pair[i];
    take_change(session, seen, *record.head, i, seen.change);
    seen.end = memory_of(session, i);
    seen.end_status = session.model.pair[i].status;
    seen.end_sign = session.model.pair[i].sign;
  }
}

// ---- extrapolation ---------------------------------------------------------------------------------------------------------

// Not while contact leaves a body free: its place is no part of what is kept.
bool may_extrapolate(const Session& session) {
  const Tableau& t = session.tableau;
  const bool is_free = (t.guided | t.may_rest | t.resting) != 0;
  return session.solver->options.stepping == C2D_STEPPING_EVENTS && !is_free;
}

// Moves what the pairs remember by factor times a direction; the statuses stay.
void move_memory(Session& session, const Direction& by, double factor) {
  const Tableau& t = session.tableau;
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    const double* step = by.memory + kMemory * static_cast<int64_t>(i);
    const double offset = factor * step[0];
    if (pair.status == C2D_STICK && pair.tangential) add_column_to(t, column_of(t, i, 1), offset, constants(t));
    pair.offset += static_cast<Real>(offset);
    pair.slip_done += static_cast<Real>(factor * step[1]);
    pair.slip_from += static_cast<Real>(factor * step[2]);
    if (follows_slip(t)) t.slip[i].rate = factor * step[3];
  }
  if (!follows_slip(t)) return;
  find_slip_rates(t);
  for (int32_t i = 0; i < t.pairs; ++i) t.slip[i].now += t.slip[i].rate;
  for (int32_t i = 0; i < t.m; ++i) constants(t)[i] += slip_rates(t)[i];
  hold_gaps(t);
}

// Energies as before a state is moved. What its elastic energy and the loads' work then differ by counts as dissipated, so that
// the balance stays as it was.
struct KeptBalance {
  Session& session;
  double defect;
  explicit KeptBalance(Session& now) : session(now) {
    const c2d_solver* s = session.solver;
    defect = s->work - s->elastic - s->dissipated;
    if (s->keeps_energy) kEnergyPart.before_jump(session);
  }
  void close() {
    c2d_solver* s = session.solver;
    if (!s->keeps_energy) return;
    kEnergyPart.release(session);
    kEnergyPart.close_balance(session);
    s->dissipated = s->work - s->elastic - defect;
    kEnergyPart.close_balance(session);
  }
};

// Back to the end of the last cycle that was followed as it should be; `strayed`: from the end of one that was not.
c2d_status go_back(Session& session, const CycleRecord& record, bool strayed) {
  KeptBalance balance(session);
  c2d_solver* s = session.solver;
  const Tableau& t = session.tableau;
  for (int32_t i = 0; i < t.pairs; ++i) {
    Pair& pair = t.pair[i];
    const CyclePair& seen = record.pair[i];
    pair.good_status = seen.end_status;
    pair.good_sign = seen.end_sign;
    pair.good_offset = static_cast<Real>(seen.end.offset);
    pair.good_slip_done = static_cast<Real>(seen.end.slip_done);
    pair.good_slip_from = static_cast<Real>(seen.end.slip_from);
    if (follows_slip(t)) t.slip[i].good = seen.end.gap;
  }
  s->table_is_current = s->back_substituted = 0;
  c2d_status status = return_to_good(session);
  if (status == C2D_ERR_SINGULAR) return C2D_OK; // the next segment of the path says so
  if (status != C2D_OK) return status;
  if (strayed)
    balance.close();
  else if (s->keeps_energy)
    kEnergyPart.close_balance(session);
  status = judge(session, Agree::values);
  return status == kUnsound ? c2d_status{C2D_OK} : status;
}

void wait_longer(CycleHead& head) {
  head.plain = 0;
  head.wait = head.left < kMostLeft ? 1 : 2 * head.wait + 1;
  head.left = fmin(kMostLeft, sqrt(head.left));
}

// `change` of the pairs is that of the cycle that has ended here.
void move_all(Session& session, const CycleRecord& record) {
  const CycleHead& head = *record.head;
  for (int32_t j = 0; j < head.directions; ++j) {
    const Direction by = direction(session, record, j);
    double along = 0.0;
    for (int32_t i = 0; i < by.pairs; ++i)
      for (int k = 0; k < kChange; ++k) along += by.change[kChange * i + k] * record.pair[i].change[k];
    move_memory(session, by, (head.left - 1.0) * along);
  }
  refresh(session.follower);
}

c2d_status extrapolate(Session& session, const CycleRecord& record) {
  c2d_solver* s = session.solver;
  CycleHead& head = *record.head;
  KeptBalance balance(session);
  move_all(session, record);
  s->table_is_current = s->back_substituted = 0;
  c2d_status status = kUnsound;
  if (may_be_shown(session, Agree::values)) {
    balance.close();
    status = judge(session, Agree::values);
  }
  if (status == kUnsound) {
    s->breach = C2D_BREACH_NONE;
    wait_longer(head);
    return go_back(session, record, false);
  }
  head.extrapolated = 1;
  ++head.extrapolations;
  return status;
}

// Does the cycle belong to those whose directions are kept? Else they are of no more use.
bool continues(CycleHead& head) {
  const bool same = head.cycles > 1 && head.events == head.sequence;
  if (!same) {
    head.sequence = head.events;
    head.repeated = head.directions = head.plain = head.wait = 0;
    head.left = kLeastLeft;
  }
  ++head.repeated;
  return same;
}

// May a cycle that has other events than the extrapolated one before it count all the same? Fast: the way to the fixed point
// leads through other sequences.
bool may_stray(const CycleHead& head, const CycleRule& rule) {
  return rule.mode == C2D_CYCLES_FAST || fmax(head.change, head.previous / kNear) <= rule.tolerance;
}

bool is_due(const CycleHead& head, const CycleRule& rule) {
  const int32_t repeats = rule.mode == C2D_CYCLES_FAST ? 1 : kRepeats;
  return rule.mode != C2D_CYCLES_PLAIN && head.steady == 0 && head.repeated >= repeats && head.plain > head.wait &&
         head.directions > 0;
}

} // namespace

c2d_status end_cycle(Session& session, const CycleRule& rule) {
  c2d_solver* s = session.solver;
  const CycleRecord record = cycle_record(s);
  CycleHead& head = *record.head;
  ++head.cycles;
  find_change(session, record);
  close_pairs(session, record);
  head.dissipated = s->dissipated - head.dissipated_before;
  const bool strayed = head.extrapolated != 0 && head.events != head.sequence && !may_stray(head, rule);
  const bool gained = head.change <= kGain * head.previous;
  if (head.extrapolated != 0 && !strayed) head.left = fmax(kLeastLeft, head.left * head.left);
  // (An affine function would have left less: the events have changed their order.)
  if (head.extrapolated != 0 && !strayed && !gained) head.sequence = ~head.events;
  head.extrapolated = 0;
  if (strayed) {
    wait_longer(head);
    return go_back(session, record, true);
  }
  head.previous = head.change;
  const bool same = continues(head);
  find_change(session, record); // by new scales, if directions begin anew
  head.steady = head.change <= rule.tolerance ? 1 : 0;
  if (same || (rule.mode == C2D_CYCLES_FAST && head.cycles > 1)) keep_direction(session, record);
  keep_end(session, record);
  ++head.plain;
  return may_extrapolate(session) && is_due(head, rule) ? extrapolate(session, record) : c2d_status{C2D_OK};
}

} // namespace c2d
