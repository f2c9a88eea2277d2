// c2d_repeat_paths and c2d_get_repeated, and what c2d_run does with the cycle of its path: it follows the cycle until it is
// steady, then goes on with the segments, whose steps are those of one more cycle.
#include "interface/advance.hpp"
#include "interface/cycles.hpp"
#include "interface/model/refuse.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "solver/load_path.hpp"

namespace c2d {

C2D_BRINGS(c2d_get_summary); // energies
C2D_BRINGS(c2d_link_search);

namespace {

constexpr int32_t kMostCycles = 1000000, kMostDigits = 12, kDigitsByDefault = 10;

// A cycle of the load path: its first segment, from 0, and how many it has.
struct PathCycle {
  int32_t first, pieces, limit, digits, start;
};

// What Path::cycle of the first segment contains.
constexpr int32_t kDigitCodes = 16, kStarts = 3;
int32_t code_of(int32_t limit, int32_t digits, int32_t start) { return (kStarts * limit + start) * kDigitCodes + digits; }

double power_of_tenth(int32_t digits) {
  double out = 1.0;
  for (int32_t i = 0; i < digits; ++i) out *= 10.0;
  return 1.0 / out;
}

PathCycle cycle_of(const ModelHeader& head, const Path* path) {
  PathCycle out = {-1, 0, 0, 0, 0};
  for (int32_t p = 0; p < head.paths; ++p) {
    if (path[p].cycle > 0) {
      const int32_t rest = path[p].cycle / kDigitCodes;
      out.first = p, out.limit = rest / kStarts, out.start = rest % kStarts, out.digits = path[p].cycle % kDigitCodes;
    }
    if (path[p].cycle < 0) out.pieces = -path[p].cycle;
  }
  return out;
}

// Is the path still followed without friction, if that is asked for?
bool is_before_friction(const Session& session, const PathCycle& cycle) {
  return cycle.start == C2D_START_WITHOUT_FRICTION && cycle_record(session.solver).head->cycles == 0;
}

int32_t steps_before(const Model& m, int32_t p) {
  int32_t steps = 0;
  for (int32_t i = 0; i < p; ++i) steps += m.path[i].increments;
  return steps;
}

// A run begins, or goes on after step `shown`.
void begin_run(Session& session, int32_t shown) {
  const PathCycle cycle = cycle_of(*session.model.head, session.model.path);
  if (cycle.first < 0) return;
  if (shown == 0) start_cycles(session);
  if (shown <= steps_before(session.model, cycle.first) && is_before_friction(session, cycle)) stop_friction(session);
}

// Follows cycles until they are steady. What happens within them is not shown, only the end of each. Extrapolation does not
// touch the last cycle that the limit allows: the steps begin in a state that was followed.
c2d_status repeat(Session& session, int32_t first, c2d_status (*show)(Session&, int32_t)) {
  c2d_solver* s = session.solver;
  const PathCycle cycle = cycle_of(*session.model.head, session.model.path);
  const double* const load = session.model.path_load + static_cast<int64_t>(first) * s->model.load_cases;
  CyclePlan plan = {
      load, cycle.pieces, s->model.load_cases, s->model.interference, {power_of_tenth(cycle.digits), C2D_CYCLES_EXACT}};
  const c2d_step_fn step = session.step;
  c2d_status status = is_before_friction(session, cycle) ? start_friction(session) : c2d_status{C2D_OK};
  while (status == C2D_OK && goes_on(session, cycle.limit)) {
    if (cycle_record(s).head->cycles + 1 == cycle.limit) plan.rule.mode = C2D_CYCLES_PLAIN;
    session.step = nullptr;
    status = follow_cycle(session, plan);
    session.step = step;
    session.follower.watch = path_watch(session);
    if (status == C2D_OK && s->outcome == C2D_REACHED) status = show(session, C2D_STEP_CYCLE);
  }
  return status;
}

c2d_status check_pieces(c2d_solver* s, int32_t pieces) {
  const ModelHeader& m = s->model;
  if (pieces >= m.paths)
    return refuse(s, C2D_ERR_ARGUMENT,
                  "the cycle has no segment of the path before it, expected one that leads to its first load");
  const double* const end = array_of<double>(s, kPathLoads) + static_cast<int64_t>(m.paths - 1) * m.load_cases;
  if (!are_alike(end, end - static_cast<int64_t>(pieces) * m.load_cases, m.load_cases))
    return refuse(s, C2D_ERR_ARGUMENT, "the cycle does not close: its last load is not the one at which it begins");
  for (int32_t i = 1; i < pieces; ++i)
    if (!are_alike(end, end - static_cast<int64_t>(i) * m.load_cases, m.load_cases)) return C2D_OK;
  return refuse(s, C2D_ERR_ARGUMENT, "all loads of the cycle are the same, expected two different ones");
}

} // namespace

const CyclePart kCyclePart = {true, c2d_repeat_paths, begin_run, repeat};

} // namespace c2d

using namespace c2d;

extern "C" c2d_status c2d_repeat_paths(c2d_solver* s, int32_t pieces, int32_t limit, int32_t digits, int32_t start) {
  c2d_status status = enter_building(s);
  if (status == C2D_OK)
    status = check_ranges(s, {{"pieces", pieces, 2, INT32_MAX},
                              {"limit", limit, 0, kMostCycles},
                              {"digits", digits, 0, kMostDigits},
                              {"start", start, C2D_START_AS_LOADED, C2D_START_COMPARED}});
  if (status != C2D_OK) return status;
  if (s->sizes.cycle_states == 0) return refuse_limit(s, "cycle_states", 0, 1);
  status = check_pieces(s, pieces);
  if (status != C2D_OK) return status;
  Path* const path = array_of<Path>(s, kPaths);
  if (cycle_of(s->model, path).first >= 0)
    return refuse(s, C2D_ERR_ARGUMENT, "the load path has a cycle already, expected one");
  path[s->model.paths - pieces].cycle =
      code_of(limit == 0 ? kCyclesByDefault : limit, digits == 0 ? kDigitsByDefault : digits, start);
  path[s->model.paths - 1].cycle = -pieces;
  return built(s);
}

extern "C" c2d_status c2d_get_repeated(c2d_solver* s, int32_t* first, int32_t* pieces, int32_t* limit, int32_t* digits,
                                       int32_t* start) {
  c2d_status status = enter(s, kComplete);
  if (status == C2D_OK)
    status = check_pointers(s, {{"first", first}, {"pieces", pieces}, {"limit", limit}, {"digits", digits}, {"start", start}});
  if (status != C2D_OK) return status;
  const PathCycle cycle = cycle_of(s->model, array_of<Path>(s, kPaths));
  *first = cycle.first + 1;
  *pieces = cycle.pieces;
  *limit = cycle.limit;
  *digits = cycle.digits;
  *start = cycle.start;
  return C2D_OK;
}
