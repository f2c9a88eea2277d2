// One solution of a model along its whole load history, with the data needed for comparison. Phases: size the workspace and the
// tapes; read and prepare the deck; advance through all increments; record the states at turns of the loads and midway between
// them. For stresses of a cycle the history is followed three times: to find the loads at its events, to record the states
// there, and once more for places that depend on these states. A cycle that is repeated until steady is followed
// first; then its pieces follow, as those of any other history.
#include "program/estimate/trial.hpp"

#include "post/corners.hpp"
#include "program/commands/drawn_words.hpp"
#include "program/files/deck_file.hpp"
#include "program/interrupt.hpp"
#include "program/progress.hpp"
#include "program/workspace.hpp"
#include "report/record.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace estimate {
namespace {

// A solver for the text of a deck, with all of its memory.
class Solver {
public:
  ~Solver() {
    if (solver_ != nullptr) c2d_close(solver_);
  }
  c2d_status read(const std::string& text, const Demand& demand, std::string& why);
  c2d_solver* get() const { return solver_; }
  bool keeps_tapes() const { return keeps_; } // in the requested store
  std::string words(c2d_status status) const;

private:
  c2d_status make_store(const Demand& demand, c2d_port& port);

  app::StoreChoice* store_ = &own_store_;
  bool keeps_ = false;

  app::DeckFile deck_;
  std::vector<c2d_body_limits> bodies_;
  c2d_limits limits_ = C2D_INIT(c2d_limits);
  app::Workspace workspace_;
  app::StoreChoice own_store_;
  c2d_solver* solver_ = nullptr;
};

c2d_options options_of(const Demand& demand) {
  c2d_options options = C2D_INIT(c2d_options);
  options.symmetry = demand.symmetry;
  options.quadrature = demand.quadrature;
  options.elimination = demand.elimination;
  options.every_change = demand.cycle.from > 0 ? 1 : 0;
  return options;
}

std::string Solver::words(c2d_status status) const {
  c2d_error error = C2D_INIT(c2d_error);
  if (solver_ != nullptr) c2d_last_error(solver_, &error);
  return error.status == status && error.text[0] != '\0' ? error.text : c2d_message(status);
}

app::StoreChoice& store_of(void* store) { return *static_cast<app::StoreChoice*>(store); }

// Tapes in memory, at their largest size.
c2d_status Solver::make_store(const Demand& demand, c2d_port& port) {
  const c2d_options options = options_of(demand);
  // Compressed elimination writes at most a quarter of its bound, as observed.
  const bool compressed = app::elimination_of(limits_, demand.elimination) == C2D_ELIMINATION_COMPRESSED;
  uint64_t sum = 0;
  std::vector<std::pair<uint64_t, uint64_t>> sizes;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    uint64_t blocks = 0, bytes = 0;
    const c2d_status status = c2d_tape_need(&limits_, &options, workspace_.bytes, tape, &blocks, &bytes, nullptr);
    if (status != C2D_OK) return status;
    const uint64_t expected = blocks * bytes / (compressed ? 4 : 1);
    sum += expected;
    store_->expect(tape, expected);
    sizes.emplace_back(blocks, bytes);
  }
  if (workspace_.bytes + sum > app::free_memory()) return C2D_ERR_MEMORY;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape)
    if (!store_->reserve(tape, sizes[static_cast<size_t>(tape)].first, sizes[static_cast<size_t>(tape)].second))
      return C2D_ERR_MEMORY;
  port.context = store_;
  app::connect<store_of>(port);
  return C2D_OK;
}

c2d_status Solver::read(const std::string& text, const Demand& demand, std::string& why) {
  if (demand.store != nullptr) demand.store->drop_tapes();
  deck_.replace(text);
  bodies_ = app::room_for_bodies(deck_);
  limits_.bodies = static_cast<int32_t>(bodies_.size());
  limits_.body = bodies_.data();
  c2d_error error = C2D_INIT(c2d_error);
  c2d_status status = c2d_scan_deck(app::DeckFile::read_line, &deck_, &limits_, &error);
  if (status == C2D_OK) status = app::take_workspace(limits_, demand.memory, demand.elimination, workspace_, why);
  if (!why.empty()) return status;
  constexpr uint64_t kMostKept = uint64_t{1} << 28; // bytes of workspace; saved states of larger models need too much memory
  keeps_ = demand.store != nullptr && workspace_.bytes <= kMostKept;
  if (keeps_) store_ = demand.store;
  if (!store_->choose("memory", 0, false, why)) return C2D_ERR_MEMORY;
  c2d_port port = C2D_INIT(c2d_port);
  if (status == C2D_OK) status = make_store(demand, port);
  port.cancel = [](void*) { return static_cast<int32_t>(app::interrupted()); };
  if (status == C2D_OK)
    status = c2d_create(&solver_, workspace_.memory.get(), static_cast<size_t>(workspace_.bytes), &limits_, &port, &error);
  const c2d_options options = options_of(demand);
  if (status == C2D_OK) status = c2d_set_options(solver_, &options);
  deck_.rewind();
  if (status == C2D_OK) status = c2d_read_deck(solver_, app::DeckFile::read_line, &deck_);
  if (status != C2D_OK) why = error.text[0] != '\0' ? error.text : words(status);
  return status;
}

// Solves the history and records its states.
class History {
public:
  History(c2d_solver* solver, const Demand& demand, Trial& out) : solver_(solver), demand_(demand), out_(out) {}
  c2d_status describe(const std::string& deck); // the model
  c2d_status follow();
  double work() const; // estimated cost of all steps

private:
  c2d_status measure(int32_t body);
  c2d_status begin();
  c2d_status go_to(const std::vector<double>& loads);
  c2d_status follow_once();
  c2d_status find_events();
  c2d_status repeat(int32_t press);
  c2d_status start_without_friction();
  static int32_t before_steady(void* context, const c2d_step* step);
  c2d_status end_cycles(const c2d_cycle_state& now);
  c2d_status note_step(int32_t increment, int32_t increments);
  c2d_status visit_events(int32_t step, const std::vector<double>& to);
  c2d_status note_of_cycle();
  c2d_status note_inside(const std::vector<Place>& places, State& state);
  c2d_status note(bool turn);
  c2d_status note_touching();
  c2d_status note_contact(State& state);
  c2d_status find_unbounded(const std::vector<double>& table, State& state);

  c2d_solver* solver_;
  const Demand& demand_;
  Trial& out_;
  app::Summary summary_;
  std::vector<app::ZoneLine> lines_;
  std::vector<double> loads_;        // load factors reached
  std::vector<double> slip_at_turn_; // of the pairs
  std::vector<app::Corner> corners_; // found when a highest pressure lies at one
  bool knows_corners_ = false;
  std::map<int32_t, std::vector<std::vector<double>>> events_; // load factors of the events of a step of the last cycle
  std::vector<Place> below_;                                   // places of the third time
  bool is_third_ = false;
  size_t noted_ = 0; // states of the cycle, the third time
  app::RepeatedPaths repeated_;
  bool has_cycles_ = false; // followed, until steady or to their limit
  c2d_cycle_state cycle_ = C2D_INIT(c2d_cycle_state);
  c2d_status cycle_status_ = C2D_OK; // of the call that reads it
};

c2d_status History::measure(int32_t body) {
  const c2d_body_result& b = summary_.body[body - 1];
  const int32_t steps = b.element_nodes - 1, closed = b.regions - b.open_regions;
  const int32_t count = b.elements * steps + b.open_regions;
  if (count == 0) return C2D_OK; // a platen has no nodes
  std::vector<double> xy(2 * static_cast<size_t>(count));
  c2d_status status = c2d_get(solver_, C2D_NODE_X, body, 1, count, xy.data(), 2);
  if (status == C2D_OK) status = c2d_get(solver_, C2D_NODE_Y, body, 1, count, xy.data() + 1, 2);
  std::vector<double>& lengths = out_.lengths[static_cast<size_t>(body) - 1];
  lengths.assign(static_cast<size_t>(b.elements), 0);
  int32_t node = 0;
  for (int32_t r = 1; r <= b.open_regions + closed && status == C2D_OK; ++r) {
    int32_t first = 0, last = 0;
    status = c2d_get_region(solver_, body, r, &first, &last);
    const int32_t begin = node;
    for (int32_t e = first; e <= last && status == C2D_OK; ++e)
      for (int32_t k = 0; k < steps; ++k, ++node) {
        const int32_t next = r > b.open_regions && e == last && k + 1 == steps ? begin : node + 1;
        const size_t p = 2 * static_cast<size_t>(node), q = 2 * static_cast<size_t>(next);
        lengths[static_cast<size_t>(e) - 1] += std::hypot(xy[q] - xy[p], xy[q + 1] - xy[p + 1]);
      }
    if (r <= b.open_regions) ++node;
  }
  return status;
}

c2d_status History::describe(const std::string& deck) {
  c2d_status status = app::get_summary(solver_, summary_);
  if (status != C2D_OK) return status;
  out_.nodes = summary_.function_nodes;
  out_.pairs = summary_.pairs;
  out_.lengths.resize(static_cast<size_t>(summary_.bodies));
  for (int32_t b = 1; b <= summary_.bodies && status == C2D_OK; ++b) {
    out_.elements += summary_.body[b - 1].elements;
    out_.equations += summary_.body[b - 1].unknowns;
    const double nu = summary_.body[b - 1].poisson_ratio;
    out_.stiffness.push_back(summary_.body[b - 1].youngs_modulus / (1 - nu * nu));
    out_.across.push_back(summary_.plane == C2D_PLANE_STRESS ? nu : nu / (1 - nu));
    status = measure(b);
  }
  for (const c2d_zone& zone : summary_.zone) {
    const auto side = [](const c2d_side& s) {
      const int32_t span = s.first_element - s.last_element;
      const bool down = span > 0 && s.elements == span + 1;
      return Side{s.body - 1, (down ? s.last_element : s.first_element) - 1, (down ? s.first_element : s.last_element) - 1};
    };
    out_.zones.push_back({side(zone.side1), side(zone.side2)});
    out_.tied.push_back((zone.kind & C2D_ZONE_TIED) != 0); // (a platen is tied)
  }
  repeated_ = app::repeated_paths(solver_);
  if (status == C2D_OK) status = app::find_zone_lines(solver_, summary_, lines_);
  if (demand_.drawn) app::take_statements(deck, lines_);
  return status;
}

// Estimated multiplications: bodies by their equations, dense or compressed; the contact by its exchanges.
double History::work() const {
  constexpr double kEntry = 3000;          // multiplications equivalent to the assembly of one entry
  constexpr double kCompressedFrom = 1600; // equations; above it the cost grows nearly linearly
  app::Summary now;
  if (app::get_summary(solver_, now) != C2D_OK) return 0;
  double out = 0;
  for (int32_t b = 0; b < now.bodies; ++b) {
    const double n = now.body[b].unknowns, own = now.compressed_bodies > 0 ? std::min(n, kCompressedFrom) : n;
    out += own * own * (kEntry + own / 3) * (n > own ? std::pow(n / own, 1.2) : 1);
  }
  const double m = now.contact_unknowns;
  return out + m * m * (m + static_cast<double>(now.exchanges + now.events));
}

// Where a contact ends that the history has unloaded is round-off.
constexpr double kUnloaded = 1e-8; // of the largest pressure it had
void drop_places_without_pressure(State& state, const std::vector<State>& before, int32_t zones) {
  for (int32_t z = 1; z <= zones; ++z) {
    double largest = 0;
    for (const State& earlier : before) largest = std::max(largest, peak_pressure(earlier, z));
    if (largest == 0 || peak_pressure(state, z) > kUnloaded * largest) continue;
    const auto is_place = [&](const app::Quantity& q) {
      const app::MeasureRow& row = app::row_of(q.what);
      return q.zone == z && (row.scale == app::Scale::kPlace || row.by_places.edges + row.by_places.borders > 0);
    };
    std::vector<app::Quantity>& all = state.quantities;
    for (app::Quantity& q : all)
      if (q.zone == z) q.at_corner = q.unbounded = false; // nor is what is left of the pressure anywhere
    all.erase(std::remove_if(all.begin(), all.end(), is_place), all.end());
  }
}

c2d_status History::begin() {
  std::vector<double> mu;
  for (int32_t z = 1; z <= summary_.zones; ++z) {
    mu.push_back(0);
    if (const c2d_status status = c2d_get_friction(solver_, z, 1, &mu.back()); status != C2D_OK) return status;
  }
  if (mu.empty()) mu.push_back(0);
  return c2d_begin(solver_, mu.data(), static_cast<int32_t>(mu.size()));
}

// Where stress at a corner is singular the highest pressure there grows without bound as the mesh is refined.
c2d_status History::find_unbounded(const std::vector<double>& table, State& state) {
  for (app::Quantity& q : state.quantities) {
    if (q.what != app::Measure::kPeakPressure || !q.at_corner) continue;
    if (!knows_corners_)
      if (const c2d_status status = app::find_corners(solver_, summary_, corners_); status != C2D_OK) return status;
    knows_corners_ = true;
    for (const app::Corner& c : corners_)
      if (c.kind == app::CornerKind::kContact && c.zone == q.zone &&
          std::hypot(c.at[0] - q.at[0], c.at[1] - q.at[1]) < c.element)
        q.unbounded = !app::corner_state(c, table.data(), C2D_PAIR_FIELDS).exponents.empty();
  }
  return C2D_OK;
}

c2d_status History::note_contact(State& state) {
  if (summary_.pairs == 0) return C2D_OK;
  std::vector<double> table(static_cast<size_t>(summary_.pairs) * C2D_PAIR_FIELDS);
  c2d_status status = C2D_OK;
  for (int32_t f = 0; f < C2D_PAIR_FIELDS && status == C2D_OK; ++f)
    status = c2d_get(solver_, f, 1, 1, summary_.pairs, table.data() + f, C2D_PAIR_FIELDS);
  std::vector<c2d_zone_state> zones(static_cast<size_t>(summary_.zones), C2D_INIT(c2d_zone_state));
  for (int32_t z = 1; z <= summary_.zones && status == C2D_OK; ++z)
    status = c2d_get_zone_state(solver_, z, &zones[static_cast<size_t>(z) - 1]);
  app::turn_forces(lines_, zones);
  app::CycleResults cycle;
  if (status == C2D_OK && has_cycles_) status = app::find_cycle_results(solver_, summary_.zones, summary_.pairs, cycle);
  std::vector<c2d_body_state> bodies(static_cast<size_t>(summary_.bodies), C2D_INIT(c2d_body_state));
  for (int32_t b = 1; b <= summary_.bodies && status == C2D_OK; ++b)
    status = c2d_get_body_state(solver_, b, &bodies[static_cast<size_t>(b) - 1]);
  if (status == C2D_OK)
    state.quantities = app::quantities_of(lines_, table.data(), C2D_PAIR_FIELDS, zones, state.dissipated, slip_at_turn_, bodies,
                                          has_cycles_ ? &cycle : nullptr);
  drop_places_without_pressure(state, out_.states, summary_.zones);
  if (status == C2D_OK && state.turn) status = find_unbounded(table, state);
  if (status == C2D_OK && state.turn) {
    slip_at_turn_.clear();
    for (size_t k = C2D_SLIP_SUM; k < table.size(); k += C2D_PAIR_FIELDS) slip_at_turn_.push_back(table[k]);
  }
  return status;
}

c2d_status History::note(bool turn) {
  State state;
  state.turn = turn;
  state.loads = loads_;
  app::Summary now;
  c2d_status status = app::get_summary(solver_, now);
  if (status != C2D_OK) return status;
  state.work = now.work, state.dissipated = now.dissipated, state.elastic = now.elastic;
  const int32_t fields[] = {C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY, C2D_END_STATUS, C2D_END_HOOP, C2D_END_SZZ};
  state.ends.resize(static_cast<size_t>(summary_.bodies));
  for (int32_t b = 1; b <= summary_.bodies && status == C2D_OK; ++b) {
    std::vector<std::vector<double>> values;
    status = app::get_ends(solver_, summary_, b, fields, demand_.zz ? kSzz + 1 : demand_.hoop ? kHoop + 1 : kHoop, values);
    for (size_t f = 0; f < values.size(); ++f) state.ends[static_cast<size_t>(b) - 1][f] = std::move(values[f]);
  }
  if (status == C2D_OK) status = note_contact(state);
  if (status == C2D_OK) status = note_inside(demand_.points, state);
  out_.states.push_back(std::move(state));
  return status;
}

c2d_status History::note_inside(const std::vector<Place>& places, State& state) {
  for (size_t first = 0, count = 0; first < places.size(); first += count) { // points of one body at once
    std::vector<double> xy;
    for (count = 0; first + count < places.size() && places[first + count].body == places[first].body; ++count)
      xy.push_back(places[first + count].x), xy.push_back(places[first + count].y);
    std::vector<double> out(count * C2D_POINT_FIELDS);
    const c2d_status status =
        c2d_interior(solver_, places[first].body, static_cast<int32_t>(count), xy.data(), 2, out.data(), C2D_POINT_FIELDS);
    if (status != C2D_OK) return status;
    for (size_t i = 0; i < count; ++i) {
      const double* p = out.data() + i * C2D_POINT_FIELDS;
      const double szz = static_cast<int>(p[C2D_POINT_FLAG]) == C2D_POINT_OUTSIDE ? NAN : p[C2D_POINT_SZZ];
      state.inside.push_back({p[C2D_POINT_UX], p[C2D_POINT_UY], p[C2D_POINT_SXX], p[C2D_POINT_SYY], p[C2D_POINT_SXY], szz});
    }
  }
  return C2D_OK;
}

// A state of the last cycle; the loads turn there if a state of the history has just been noted at these loads.
c2d_status History::note_of_cycle() {
  if (is_third_) return noted_ < out_.cycle.size() ? note_inside(below_, out_.cycle[noted_++]) : c2d_status{C2D_OK};
  State state;
  state.turn = !out_.states.empty() && out_.states.back().turn && out_.states.back().loads == loads_;
  state.loads = loads_;
  const int32_t fields[] = {C2D_END_TX, C2D_END_TY, C2D_END_HOOP, C2D_END_SZZ};
  constexpr Field kOfCycle[] = {kTx, kTy, kHoop, kSzz};
  state.ends.resize(static_cast<size_t>(summary_.bodies));
  c2d_status status = C2D_OK;
  for (const int32_t b : demand_.cycle.bodies) {
    std::vector<std::vector<double>> values;
    if (status == C2D_OK) status = app::get_ends(solver_, summary_, b, fields, 4, values);
    for (size_t f = 0; f < values.size(); ++f) state.ends[static_cast<size_t>(b) - 1][kOfCycle[f]] = std::move(values[f]);
  }
  if (status == C2D_OK && state.turn) state.quantities = out_.states.back().quantities;
  if (status == C2D_OK && !state.turn) status = note_contact(state);
  std::vector<double> v[6];
  if (status == C2D_OK && demand_.cycle.rubbing && summary_.pairs > 0)
    status = app::get_pairs(
        solver_, summary_,
        {{C2D_X, v[0]}, {C2D_Y, v[1]}, {C2D_TN, v[2]}, {C2D_TT, v[3]}, {C2D_SLIP_SUM, v[4]}, {C2D_PAIR_ZONE, v[5]}});
  for (size_t p = 0; p < v[5].size(); ++p)
    state.rubbing.push_back({v[0][p], v[1][p], v[2][p], v[3][p], v[4][p], static_cast<int32_t>(v[5][p])});
  if (status == C2D_OK) status = note_inside(demand_.cycle.points, state);
  out_.cycle.push_back(std::move(state));
  return status;
}

c2d_status History::note_touching() {
  out_.touched.resize(static_cast<size_t>(summary_.bodies));
  const int32_t status_field = C2D_END_STATUS;
  c2d_status status = C2D_OK;
  for (int32_t b = 1; b <= summary_.bodies && status == C2D_OK; ++b) {
    std::vector<std::vector<double>> now;
    status = app::get_ends(solver_, summary_, b, &status_field, 1, now);
    std::vector<char>& touched = out_.touched[static_cast<size_t>(b) - 1];
    touched.resize(now[0].size(), 0);
    for (size_t i = 0; i < touched.size(); ++i) touched[i] |= static_cast<char>(now[0][i] > 0);
  }
  return status;
}

c2d_status History::go_to(const std::vector<double>& loads) {
  const c2d_status status = c2d_advance(solver_, loads.data(), static_cast<int32_t>(loads.size()), &out_.outcome);
  loads_ = loads;
  return status;
}

// The loads at the changes of status in the last cycle, from c2d_run, whose callback is called there.
c2d_status History::find_events() {
  if (const c2d_status status = begin(); status != C2D_OK) return status;
  return c2d_run(
      solver_,
      [](void* context, const c2d_step* step) {
        auto& events = static_cast<History*>(context)->events_;
        if (step->kind == C2D_STEP_CHANGE && step->coefficient <= 1)
          events[step->step].emplace_back(step->loads, step->loads + step->cases);
        return int32_t{0};
      },
      this);
}

// States at the events between the loads reached and the loads `to`. Loads at one event that differ by round-off are one.
c2d_status History::visit_events(int32_t step, const std::vector<double>& to) {
  constexpr double kSameLoads = 1e-9; // of the length of the step
  const auto apart = [](const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (size_t k = 0; k < a.size(); ++k) sum = std::max(sum, std::fabs(a[k] - b[k]));
    return sum;
  };
  const double same = kSameLoads * apart(loads_, to);
  c2d_status status = C2D_OK;
  for (const std::vector<double>& event : events_[step]) {
    if (status != C2D_OK || out_.outcome != C2D_REACHED) break;
    if (event.size() != to.size() || apart(event, loads_) <= same || apart(event, to) <= same) continue;
    status = go_to(event);
    if (status == C2D_OK) status = note_of_cycle();
  }
  return status;
}

// The records at the end of an increment.
c2d_status History::note_step(int32_t i, int32_t increments) {
  if (is_third_) return C2D_OK;
  const bool turn = i == increments || out_.outcome != C2D_REACHED;
  c2d_status status = note_touching();
  if (status == C2D_OK && (turn || demand_.all_steps || i == increments / 2)) status = note(turn);
  return status;
}

// The cycles from the loads reached, as c2d_run repeats them.
c2d_status History::repeat(int32_t press) {
  c2d_cycle_request request = C2D_INIT(c2d_cycle_request);
  const size_t cases = loads_.size();
  std::vector<double> load(static_cast<size_t>(repeated_.pieces) * cases);
  c2d_status status = C2D_OK;
  for (int32_t i = 0, ignored = 0; i < repeated_.pieces && status == C2D_OK; ++i) {
    double* const corner = load.data() + static_cast<size_t>(i) * cases;
    status = c2d_get_path(solver_, repeated_.first + i, &ignored, corner, static_cast<int32_t>(cases));
    if (press > 0) corner[press - 1] = 1;
  }
  request.corners = repeated_.pieces, request.cases = static_cast<int32_t>(cases), request.load = load.data();
  request.limit = repeated_.limit, request.tolerance = std::pow(10.0, -repeated_.digits);
  c2d_cycle_state now = C2D_INIT(c2d_cycle_state);
  if (status == C2D_OK) status = c2d_cycle(solver_, &request, nullptr, nullptr, &now);
  return status == C2D_OK ? end_cycles(now) : status;
}

// The state in which the steady cycle begins, in place of that before the cycles.
c2d_status History::end_cycles(const c2d_cycle_state& now) {
  out_.outcome = now.outcome;
  if (out_.outcome != C2D_REACHED) return C2D_OK;
  has_cycles_ = true;
  if (now.result == C2D_CYCLE_NOT_STEADY)
    out_.why = "the cycle is not steady after " + std::to_string(now.cycles) + (now.cycles == 1 ? " cycle" : " cycles");
  c2d_status status = C2D_OK;
  if (!is_third_ && !out_.states.empty()) out_.states.pop_back();
  if (!is_third_) status = note(true);
  return status == C2D_OK && demand_.cycle.from > 0 ? note_of_cycle() : status;
}

// Ends the run of c2d_run after the last cycle.
int32_t History::before_steady(void* context, const c2d_step* step) {
  History& history = *static_cast<History*>(context);
  history.loads_.assign(step->loads, step->loads + step->cases);
  history.out_.outcome = step->outcome;
  if (step->kind != C2D_STEP_CYCLE) return 0;
  history.cycle_status_ = c2d_get_cycle_state(history.solver_, &history.cycle_);
  if (history.cycle_status_ != C2D_OK) return 1;
  return history.cycle_.result == C2D_CYCLE_NOT_STEADY && history.cycle_.cycles < history.repeated_.limit ? 0 : 1;
}

// From zero load through cycles that begin without friction; states before them are not recorded.
c2d_status History::start_without_friction() {
  cycle_ = C2D_INIT(c2d_cycle_state);
  const c2d_status status = c2d_run(solver_, before_steady, this);
  if (status != C2D_ERR_CALLBACK) return status; // the path has ended early
  return cycle_status_ == C2D_OK ? end_cycles(cycle_) : cycle_status_;
}

c2d_status History::follow() {
  const CycleDemand& cycle = demand_.cycle;
  c2d_status status = C2D_OK;
  if (cycle.from > 0) status = find_events();
  if (status == C2D_OK) status = follow_once();
  if (status != C2D_OK || out_.outcome != C2D_REACHED || !cycle.below || out_.cycle.empty()) return status;
  below_ = cycle.below(out_);
  is_third_ = !below_.empty();
  return is_third_ ? follow_once() : status;
}

c2d_status History::follow_once() {
  has_cycles_ = false;
  loads_.assign(static_cast<size_t>(std::max(1, summary_.load_cases)), 0);
  int32_t step = 0;
  const bool is_smooth = repeated_.first > 0 && repeated_.start == C2D_START_WITHOUT_FRICTION;
  c2d_status status = is_smooth ? start_without_friction() : begin();
  int32_t press = 0; // the load case that closes overlaps
  if (status == C2D_OK) status = c2d_get_interference(solver_, &press);
  if (status == C2D_OK && press > 0 && !is_smooth) {
    std::vector<double> to = loads_;
    to[static_cast<size_t>(press) - 1] = 1;
    status = go_to(to);
  }
  for (int32_t p = is_smooth ? repeated_.first : 1; p <= summary_.paths && status == C2D_OK && out_.outcome == C2D_REACHED;
       ++p) {
    if (p == repeated_.first && !is_smooth) status = repeat(press);
    if (status != C2D_OK || out_.outcome != C2D_REACHED) break;
    const std::vector<double> from = loads_;
    std::vector<double> to(from.size());
    int32_t increments = 1;
    status = c2d_get_path(solver_, p, &increments, to.data(), static_cast<int32_t>(to.size()));
    if (press > 0) to[static_cast<size_t>(press) - 1] = 1;
    for (int32_t i = 1; i <= increments && status == C2D_OK && out_.outcome == C2D_REACHED; ++i) {
      std::vector<double> now(to.size());
      for (size_t c = 0; c < to.size(); ++c) now[c] = i == increments ? to[c] : from[c] + (to[c] - from[c]) * i / increments;
      ++step;
      if (demand_.cycle.from > 0 && p > demand_.cycle.from) status = visit_events(step, now);
      if (status == C2D_OK && out_.outcome == C2D_REACHED) status = go_to(now);
      if (status == C2D_OK) status = note_step(i, increments);
      if (status == C2D_OK && i == increments && demand_.cycle.from > 0 && p >= demand_.cycle.from && p + 1 != repeated_.first)
        status = note_of_cycle();
    }
  }
  if (out_.outcome != C2D_REACHED) out_.why = c2d_outcome_message(out_.outcome);
  return status;
}

} // namespace

double peak_pressure(const State& state, int32_t zone) {
  for (const app::Quantity& q : state.quantities)
    if (q.zone == zone && q.what == app::Measure::kPeakPressure) return q.value;
  return 0;
}

c2d_status solve(const std::string& deck, const Demand& demand, Trial& out, std::string& why) {
  const double start = app::clock_seconds(nullptr);
  Solver solver;
  c2d_status status = solver.read(deck, demand, why);
  if (status != C2D_OK) return status;
  History history(solver.get(), demand, out);
  status = history.describe(deck);
  if (status == C2D_OK) status = c2d_prepare(solver.get());
  if (status == C2D_OK && solver.keeps_tapes()) status = c2d_save(solver.get());
  if (status == C2D_OK) status = history.follow();
  if (status != C2D_OK) why = solver.words(status);
  out.seconds = app::clock_seconds(nullptr) - start;
  out.work = history.work();
  return status;
}

namespace {

struct EndsSeen {
  c2d_solver* solver;
  int32_t zones;
  std::vector<EndOfCycles>& ends;
};

int32_t see_end(void* context, const c2d_step* step) {
  const EndsSeen& seen = *static_cast<EndsSeen*>(context);
  if (step->kind == C2D_STEP_CYCLE) {
    if (seen.ends.empty() || seen.ends.back().coefficient != step->coefficient)
      seen.ends.push_back({step->coefficient, {}, {}});
    seen.ends.back().last = app::CycleSeen();
    return app::find_cycle_seen(seen.solver, seen.zones, seen.ends.back().last) == C2D_OK ? 0 : 1;
  }
  if (seen.ends.empty() || seen.ends.back().coefficient != step->coefficient) return 0;
  std::vector<double>& tractions = seen.ends.back().tractions;
  tractions.clear(); // of a path that stops within its cycle none
  for (int32_t p = 0; p < step->pairs && step->kind == C2D_STEP_RECORDED; ++p)
    for (const int32_t field : {C2D_TN, C2D_TT}) tractions.push_back(step->table[p * int64_t{step->stride} + field]);
  return 0;
}

} // namespace

c2d_status follow_cycles(const std::string& deck, const Demand& demand, std::vector<EndOfCycles>& out, std::string& why) {
  Solver solver;
  c2d_status status = solver.read(deck, demand, why);
  app::Summary summary;
  if (status == C2D_OK) status = app::get_summary(solver.get(), summary);
  if (status == C2D_OK) status = c2d_prepare(solver.get());
  EndsSeen seen{solver.get(), summary.zones, out};
  if (status == C2D_OK) status = c2d_run(solver.get(), see_end, &seen);
  if (status != C2D_OK && why.empty()) why = solver.words(status);
  return status;
}

} // namespace estimate
