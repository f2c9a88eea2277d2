// Every place of the program at which the store is asked for something, reached in any of many models: what is asked there
// fails, the first time and the last. Places are told apart by their chains of calls. The whole life of a solver is gone
// through: path, fields, interior points, indicators, saved states, new loads.
#include "many_bodies.hpp"
#include "problem.hpp"
#include "store_places.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

using namespace runs;

namespace {

struct Told {
  const char *deck, *card; // a card more
  int32_t symmetry, stepping;
};
const Told kModels[] = {{"tests/data/decks/plate", "", 0, 0},
                        {"tests/data/decks/hertz_lin_l", "", 0, 0},
                        {"tests/data/decks/block", "", 0, 0},
                        {"tests/data/hard/D1_4pairs_endless_12", "", 0, 0},
                        {"tests/data/hard/D2_unload_3-41", "", 0, 0},
                        {"tests/data/hard/D5_hang_3-740", "", 0, 0},
                        {"tests/data/hard/D8_holes_0.01", "", 0, 0},
                        {"tests/data/hard/F1_facing_in_other_units", "", 0, 0},
                        {"tests/data/hard/F2_unloaded_to_nothing", "", 0, 0},
                        {"tests/data/hard/F3_goes_along_without_force", "", 0, 0},
                        {"tests/data/hard/F4_turns_on_its_arc", "", 0, 0},
                        {"tests/data/hard/F5_lets_go_of_friction", "", 0, 0},
                        {"tests/data/hard/N1_slides_on_few_elements", "", 0, 0},
                        {"tests/data/hard/N2_wedge_that_cannot_come_out", "", 0, 0},
                        {"tests/data/hard/W1_arc_1_1_3_3_4_0.25", "", 0, 0},
                        {"tests/data/hard/W1_arc_1_3_2_3_4_0.21", "", 0, 0},
                        {"tests/data/hard/W2_drift_2-737m", "", 0, 0},
                        {"tests/data/hard/nonunique_9", "", 0, 0},
                        {"tests/data/hard/nonunique_equally_near", "", 0, 0},
                        {"tests/data/hard/D1_4pairs_endless_24", "", 0, 0},
                        {"tests/data/hard/D1_4pairs_endlesslow_2", "", 0, 0},
                        {"tests/data/hard/D1_arc_below_limit_unique_solution", "", 0, 0},
                        {"tests/data/hard/D1_punch_nu0_11pairs", "", 0, 0},
                        {"tests/data/hard/D2_loose_41-21", "", 0, 0},
                        {"tests/data/hard/D2_through_zero_41-38", "", 0, 0},
                        {"tests/data/hard/D2_unload_3-150", "", 0, 0},
                        {"tests/data/hard/D4_no_rows_arc", "", 0, 0},
                        {"tests/data/hard/D6_threads_1-58", "", 0, 0},
                        {"tests/data/hard/D9_strip_1e-05_nf3", "", 0, 0},
                        {"tests/data/hard/W1_arc_1_3_3_2_6_0.3", "", 0, 0},
                        {"tests/data/hard/W1_arc_1_3_3_3_6_0.25", "", 0, 0},
                        {"tests/data/hard/W1_solved_but_slides_4-362", "", 0, 0},
                        {"tests/data/hard/W3_lifted_free_in_x_1-116", "", 0, 0},
                        {"tests/data/hard/no_rates_bridge_10pairs", "", 0, 0},
                        {"tests/data/hard/no_rates_bump_10pairs", "", 0, 0},
                        {"tests/data/hard/nonunique_19", "", 0, 0},
                        {"tests/data/hard/range_portal_22pairs", "", 0, 0},
                        {"tests/data/hard/unloaded_under_a_moved_body", "", 0, 0},
                        {"tests/data/coarse/pad", "", 0, 0},
                        {"tests/data/coarse/ring", "", 0, 0},
                        {"tests/data/judge/two_holes", "", 0, 0},
                        {"tests/data/sweep/disc_in_hole", "", 0, 0},
                        {"tests/data/sweep/shrink", "", 0, 0},
                        {"tests/data/sweep/stack", "", 0, 0},
                        {"examples/three_bodies", "", 0, 0},
                        {"tests/data/decks/block", "", 0, C2D_STEPPING_DECK},
                        {"tests/data/decks/hertz_lin_l", "", C2D_SYMMETRY_IMAGES, 0},
                        {"tests/data/sweep/disc_in_hole", "", C2D_SYMMETRY_IMAGES, 0},
                        {"tests/data/sweep/shrink", "", C2D_SYMMETRY_IMAGES, 0},
                        {"tests/data/sweep/ring", "", C2D_SYMMETRY_IMAGES, 0},
                        {"tests/data/coarse/ring", "*BODY FORCE 1 1 0 -1e-3 1e-6 0 0", 0, 0},
                        {"tests/data/decks/hertz_lin_l", "*BODY FORCE 1 1 0 -1e-3 1e-6 0 0", C2D_SYMMETRY_IMAGES, 0},
                        {"tests/data/judge/two_holes", "*BODY FORCE 1 1 0 -1e-3", 0, 0},
                        {"tests/data/decks/plate", "*BODY FORCE 1 1 0 -1e-3 1e-6 0 0", 0, 0}};

// Plates of width 3 on a table, with gaps below them: they fall on each other before anything is loaded. The top is pressed,
// more on one side, and pushed along x.
many::Model plates(int32_t kind, double gap2, double gap3, double pushed, double friction) {
  const double at[3] = {0, 1 + gap2, 2 + gap2 + gap3};
  many::Model m;
  for (const double y : at) m.add(many::rectangle(0, y, 3, y + 1, {4, 2, 4, 2}, 100));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(3, 3, [=](double x, double) { return many::end_of(many::kPulled, pushed, -1 - 0.2 * x); });
  for (int i = 1; i <= 2; ++i) m.join(kind, i, 3, i + 1, 1);
  m.friction = friction;
  return m;
}
// A block that is pressed on its table by what moves its upper side, lifted off, and put down again.
many::Model lifted(double friction) {
  many::Model m;
  m.add(many::rectangle(0, 0, 3, 1, {4, 2, 4, 2}, 100));
  m.add(many::rectangle(0, 1, 3, 2, {4, 2, 4, 2}, 60));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, [](double x, double) { return many::end_of("0110", 0, 0, 0, -0.01 - 0.001 * x); });
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = friction;
  m.paths = {{1, 1.0}, {2, -1.0}, {1, 0.5}};
  return m;
}

// Models that are made here, by their names.
many::Model made(const std::string& name) {
  if (name == "plates that hover") return plates(C2D_ZONE_MATCHING, 0.01, 0.02, 0.1, 0.4);
  if (name == "plates that hover, meshed freely") return plates(C2D_ZONE_FREE, 0.01, 0.02, 0.1, 0.4);
  if (name == "a plate that hovers over another") return plates(C2D_ZONE_MATCHING, 0, 0.02, 0.1, 0.4);
  if (name == "plates that slide away") return plates(C2D_ZONE_MATCHING, 0, 0, 2.0, 0.4);
  return lifted(name == "a block that is lifted" ? 5.0 : 0.3);
}
const Told kMade[] = {{"plates that hover", "", 0, 0},
                      {"plates that hover, meshed freely", "", 0, 0},
                      {"a plate that hovers over another", "", 0, 0},
                      {"plates that slide away", "", 0, 0},
                      {"a block that is lifted", "", 0, 0},
                      {"a block that slides as it is lifted", "", 0, 0}};

Deck deck_of(const Told& told) {
  Deck deck;
  std::vector<int32_t> order;
  std::stringstream file;
  if (std::find_if(std::begin(kMade), std::end(kMade), [&](const Told& t) { return t.deck == told.deck; }) != std::end(kMade))
    file << many::deck_of(made(told.deck), told.deck, order);
  else
    file << std::ifstream(paths::root() + "/" + told.deck + ".dat").rdbuf();
  for (std::string line; std::getline(file, line);) deck.lines.push_back(line);
  if (*told.card != '\0') deck.lines.push_back(told.card);
  return deck;
}

void look_at_results(c2d_solver* s, Caller& did, Numbers& to) {
  const host::Summary summary = summary_of(s);
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    c2d_body_result own = C2D_INIT(c2d_body_result);
    if (!did("c2d_get_body_result", c2d_get_body_result(s, body, &own))) return;
    std::vector<double> off(static_cast<size_t>(own.elements) * C2D_OFF_FIELDS);
    if (!did("c2d_indicators", c2d_indicators(s, body, 1, own.elements, off.data(), C2D_OFF_FIELDS))) return;
    double at[6] = {}, out[3 * C2D_POINT_FIELDS] = {};
    if (!did("c2d_get", c2d_get(s, C2D_END_X, body, 1, 3, at, 2))) return;
    if (!did("c2d_get", c2d_get(s, C2D_END_Y, body, 1, 3, at + 1, 2))) return;
    at[0] += 1e-3 * at[2], at[1] -= 1e-3 * at[3];
    if (!did("c2d_interior", c2d_interior(s, body, 3, at, 2, out, C2D_POINT_FIELDS))) return;
    c2d_body_state moved = C2D_INIT(c2d_body_state);
    if (!did("c2d_get_body_state", c2d_get_body_state(s, body, &moved))) return;
    to.boundary.insert(to.boundary.end(), off.begin(), off.end());
    to.boundary.insert(to.boundary.end(), out, out + 3 * C2D_POINT_FIELDS);
    to.boundary.insert(to.boundary.end(), moved.contact, moved.contact + 3);
  }
}

// Where the path would go on to, either way; and how the bodies stand after that.
bool ask_for_an_event(c2d_solver* s, Caller& did, Numbers& to) {
  const host::Summary summary = summary_of(s);
  for (double way : {1.0, -1.0}) {
    const std::vector<double> direction(static_cast<size_t>(summary.load_cases), way);
    double step = 0;
    if (!did("c2d_next_event", c2d_next_event(s, direction.data(), summary.load_cases, &step))) return false;
    to.boundary.push_back(step);
    double ux = 0;
    if (way < 0 && !did("c2d_get", c2d_get(s, C2D_END_UX, 1, 1, 1, &ux, 1))) return false;
    to.boundary.push_back(ux);
    c2d_body_state moved = C2D_INIT(c2d_body_state);
    if (!did("c2d_get_body_state", c2d_get_body_state(s, 1, &moved))) return false;
    to.boundary.insert(to.boundary.end(), moved.contact, moved.contact + 3);
  }
  return true;
}

// The step callback asks what it may ask.
int32_t look_at_step(void* context, const c2d_step* step) {
  auto& [solver, numbers, failed] = *static_cast<std::tuple<c2d_solver*, Numbers*, c2d_status>*>(context);
  for (int32_t body = 1; body <= summary_of(solver).bodies; ++body) {
    c2d_body_state moved = C2D_INIT(c2d_body_state);
    const c2d_status status = c2d_get_body_state(solver, body, &moved);
    if (status != C2D_OK) return failed = status, 1;
  }
  return Numbers::take(numbers, step);
}

Life live(Machine& machine, const host::Limits& limits, const Told& told, const Deck& deck, RamStore& store) {
  Life life;
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  machine.create(limits, &port);
  REQUIRE(machine.created == C2D_OK);
  c2d_solver* const s = machine.solver;
  Caller did{s, life};
  c2d_options options = C2D_INIT(c2d_options);
  options.keep_factors = options.every_change = 1;
  options.symmetry = told.symmetry, options.stepping = told.stepping;
  did("c2d_set_options", c2d_set_options(s, &options));
  if (did("c2d_read_deck", read_deck(s, deck))) did("c2d_prepare", c2d_prepare(s));
  for (int round = 0; round < 2 && life.status == C2D_OK; ++round) {
    std::tuple<c2d_solver*, Numbers*, c2d_status> context{s, &life.numbers, C2D_OK};
    const c2d_status ran = c2d_run(s, look_at_step, &context);
    const c2d_status asked = std::get<2>(context);
    if (!did("c2d_run", asked != C2D_OK ? asked : ran)) break;
    if (!did("c2d_get", get_boundary(s, life.numbers))) break;
    look_at_results(s, did, life.numbers);
    if (life.status != C2D_OK || round == 1) break;
    if (!ask_for_an_event(s, did, life.numbers)) break;
    did("c2d_save", c2d_save(s));
    if (life.status == C2D_OK) did("c2d_restore", c2d_restore(s));
    if (life.status == C2D_OK) did("c2d_change_loads", c2d_change_loads(s));
    if (life.status == C2D_OK) did("c2d_prepare", c2d_prepare(s));
  }
  c2d_close(s);
  return life;
}

} // namespace

TEST_CASE("store sweep: whichever call of whichever model asks, a store that fails is told and nothing is made up") {
  std::set<uint64_t> seen; // over all models: a place needs to fail once
  size_t tried = 0, unseen = 0;
  std::vector<Told> models(std::begin(kModels), std::end(kModels));
  models.insert(models.end(), std::begin(kMade), std::end(kMade));
  for (const Told& told : models) {
    CAPTURE(std::string(told.deck));
    CAPTURE(std::string(told.card));
    const Deck deck = deck_of(told);
    host::Limits limits = deck.limits();
    for (int32_t width : {0, 7}) {
      CAPTURE(width);
      limits.panel_columns = width;
      uint64_t minimum = 0, in_core = 0;
      REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
      Machine machine(limits, width == 0 ? in_core : minimum, nullptr);
      std::map<uint64_t, Place> places;
      RamStore whole;
      whole.before = [&](const RamStore::Operation&, size_t n) {
        Place& place = places.insert({asker(), Place{n, n}}).first->second;
        place.last = n;
        return 0;
      };
      const Life clean = live(machine, limits, told, deck, whole);
      CAPTURE(clean.call);
      REQUIRE(clean.status == C2D_OK);
      std::set<size_t> failing;
      for (const auto& [key, place] : places)
        if (seen.insert(key).second) failing.insert({place.first, place.last});
      for (size_t n : failing) {
        RamStore store;
        RamStore::Operation failed{};
        store.before = [&](const RamStore::Operation& operation, size_t i) {
          if (i != n) return 0;
          failed = operation;
          return 1000 + operation.kind;
        };
        const Life life = live(machine, limits, told, deck, store);
        CAPTURE(n);
        CAPTURE(failed.kind);
        CAPTURE(failed.tape);
        CAPTURE(life.call);
        ++tried;
        REQUIRE(machine.guards_are_whole());
        check_failed_life(life, clean, failed);
        unseen += life.status == C2D_OK ? 1 : 0;
      }
    }
  }
  MESSAGE("places of the program where the store failed: " << tried << ", of them without consequence: " << unseen);
  CHECK(tried > 300);
}
