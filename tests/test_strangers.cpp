// Saved states that no solver wrote: right checksums over numbers that no path leaves (tests/fuzz/state.cpp goes on from here).
#include "fuzz/forged_state.hpp"
#include "many_bodies.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <random>
#include <string>

using namespace forged;

namespace {

// The image of a state begins with the model in the solver's struct.
constexpr size_t image_offset(size_t of_solver) { return of_solver - offsetof(c2d_solver, model); }

// A saved state in which bytes of the image were replaced, and its sums made right again.
Store with(const Store& from, size_t offset, const void* bytes, size_t count) {
  Store store = from;
  Opened opened(store);
  Image image(store, opened);
  REQUIRE(offset + count <= image.bytes);
  for (size_t i = 0; i < count; ++i) *image.at(offset + i) = static_cast<const unsigned char*>(bytes)[i];
  image.sum();
  opened.seal();
  return store;
}

struct Restored {
  c2d_status status;
  int32_t state;
  std::string text;
  std::vector<double> numbers; // of all pairs and all ends
};

Restored restore(Store store, int variant) {
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  Machine machine(variant, &port);
  c2d_solver* const s = machine.solver;
  REQUIRE(build(s, variant) == C2D_OK);
  Restored out{c2d_restore(s), c2d_get_state(s), "", {}};
  c2d_error error = C2D_INIT(c2d_error);
  if (out.status != C2D_OK && c2d_last_error(s, &error) == C2D_OK) out.text = error.text;
  for (int32_t field = C2D_X; field < C2D_PAIR_FIELDS && out.status == C2D_OK && out.state == C2D_STATE_RUNNING; ++field) {
    double column[12];
    REQUIRE(c2d_get(s, field, 1, 1, 3, column, 1) == C2D_OK);
    out.numbers.insert(out.numbers.end(), column, column + 3);
  }
  for (int32_t body = 1; body <= 2 && !out.numbers.empty(); ++body) {
    double column[12];
    REQUIRE(c2d_get(s, C2D_END_UX, body, 1, 12, column, 1) == C2D_OK);
    out.numbers.insert(out.numbers.end(), column, column + 12);
  }
  c2d_close(s);
  return out;
}

template <class T> void refused(const char* name, const Store& from, int variant, size_t offset, T value) {
  CAPTURE(std::string(name));
  CAPTURE(value);
  const Restored found = restore(with(from, image_offset(offset), &value, sizeof value), variant);
  CHECK(found.status == C2D_ERR_STORE_FORMAT);
  CHECK(found.state == C2D_STATE_BROKEN);
  CHECK(found.text.size() > 10);
}

} // namespace

TEST_CASE("strangers: a number of a saved state that leads nowhere is refused, however right its checksums are") {
  int tried = 0;
#define C2D_REFUSED(member, ...)                                                                                               \
  for (const int64_t value : std::initializer_list<int64_t>{__VA_ARGS__})                                                      \
  refused(#member, state.store, variant, offsetof(c2d_solver, member), static_cast<decltype(c2d_solver::member)>(value)),      \
      ++tried
  for (const int variant : {int{kPlain}, int{kKeepFactors}, int{kFree}, int{kStreamed}}) {
    CAPTURE(variant);
    const Saved& state = saved(variant, true);
    REQUIRE(restore(state.store, variant).status == C2D_OK);
    C2D_REFUSED(blocked, 1, -1, INT32_MAX);
    C2D_REFUSED(keeps_flexibility, 2, -1);
    C2D_REFUSED(keeps_energy, 0, 2);
    C2D_REFUSED(warnings, -1, INT32_MAX);
    C2D_REFUSED(factors, -1, 2);
    C2D_REFUSED(loads_changed, 1);
    C2D_REFUSED(floating, 2, -1);
    C2D_REFUSED(outcome, -1, C2D_BEYOND_LIMITS + 1);
    C2D_REFUSED(outcome_body, -1, 3, INT32_MAX);
    C2D_REFUSED(last_pair, -2, 3, INT32_MAX);
    C2D_REFUSED(may_rest, 2);
    C2D_REFUSED(resting, -1);
    C2D_REFUSED(guided, -1, 4, INT32_MAX);
    C2D_REFUSED(good_guided, -1, 4, INT32_MIN);
    C2D_REFUSED(table_is_current, 2);
    C2D_REFUSED(unsound, 2);
    C2D_REFUSED(careful, 1);
    C2D_REFUSED(breach, -1, C2D_BREACHES);
    C2D_REFUSED(good_floating, -1);
    C2D_REFUSED(exchanges, -1, INT64_MAX);
    C2D_REFUSED(judged_exchanges, INT64_MIN);
    C2D_REFUSED(built_exchanges, INT64_MAX);
    C2D_REFUSED(turns, INT64_MAX);
    C2D_REFUSED(stats.events, -1, INT64_MAX);
    C2D_REFUSED(stats.iterations, INT32_MAX);
    C2D_REFUSED(options.keep_factors, 2, -1);
  }
#undef C2D_REFUSED
  MESSAGE("forged numbers refused: " << tried);
  CHECK(tried == 4 * 46);
}

TEST_CASE("strangers: statuses of pairs and plans of eliminations, too") {
  for (const int variant : {int{kPlain}, int{kStreamed}, int{kTied}}) {
    CAPTURE(variant);
    const Saved& state = saved(variant, true);
    c2d_port port = C2D_INIT(c2d_port);
    Machine machine(variant, &port);
    const uint64_t* const at = machine.solver->layout.offset;
    for (size_t pair = 0; pair < 3; ++pair)
      for (const size_t member : {offsetof(c2d::Pair, status), offsetof(c2d::Pair, saved_status),
                                  offsetof(c2d::Pair, good_status), offsetof(c2d::Pair, sign)}) {
        const size_t place = static_cast<size_t>(at[c2d::kPairs]) + pair * sizeof(c2d::Pair) + member;
        refused("pair", state.store, variant, place, static_cast<signed char>(3));
        refused("pair", state.store, variant, place, static_cast<signed char>(-2));
      }
    for (size_t body = 0; body < 2; ++body)
      for (size_t member = 0; member < 5 * 4; member += 4)
        for (const int32_t value : {-1, 0, 1 << 20, INT32_MAX})
          refused("plan", state.store, variant,
                  static_cast<size_t>(at[c2d::kPlans]) + body * sizeof(c2d::EliminationPlan) + member, value);
    for (size_t body = 0; body < 2; ++body) // lower factors that the options keep not
      refused("plan", state.store, variant,
              static_cast<size_t>(at[c2d::kPlans]) + body * sizeof(c2d::EliminationPlan) +
                  offsetof(c2d::EliminationPlan, keep_lower),
              int32_t{1});
    for (size_t body = 0; body < 2; ++body)
      for (const size_t member : {offsetof(c2d::EliminationPlan, keep_lower), offsetof(c2d::EliminationPlan, block_rows)})
        for (const int32_t value : {-1, 1 << 20, INT32_MAX})
          refused("plan", state.store, variant,
                  static_cast<size_t>(at[c2d::kPlans]) + body * sizeof(c2d::EliminationPlan) + member, value);
  }
}

// Half a block upon another: the pair on the line of symmetry has no tangential direction.
TEST_CASE("strangers: a pair that cannot slide is not said to slide at a given rate") {
  many::Model m;
  m.symmetry = 1;
  m.friction = 0.3;
  m.add(many::open_polygon({{0, -1, 1}, {2, -1, 1}, {2, 0, 2}, {0, 0, 0}}));
  m.add(many::open_polygon({{0, 0, 2}, {2, 0, 1}, {2, 1, 1}, {0, 1, 0}}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  std::vector<unsigned char> memory(static_cast<size_t>(small_model::memory_for(limits)));
  const auto fed = [&](Store& store) {
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    c2d_solver* s = nullptr;
    REQUIRE(c2d_create(&s, memory.data(), memory.size(), &limits, &port, nullptr) == C2D_OK);
    REQUIRE(many::feed(s, m) == C2D_OK);
    return s;
  };
  Store store;
  c2d_solver* s = fed(store);
  const double mu = 0.3, load = 1;
  c2d_outcome outcome = -1;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
  REQUIRE(c2d_save(s) == C2D_OK);
  std::vector<bool> may_slide;
  for (int32_t i = 0; i < s->model.pairs; ++i) may_slide.push_back(c2d::model_of(s).pair[i].tangential != 0);
  REQUIRE((may_slide.size() == 3 && may_slide[0] && !may_slide[2]) != (may_slide[2] && !may_slide[0]));
  for (const size_t member : {offsetof(c2d_solver, guided), offsetof(c2d_solver, good_guided)})
    for (int32_t pair = 1; pair <= 3; ++pair) {
      CAPTURE(pair);
      Store forged = with(store, image_offset(member), &pair, sizeof pair);
      c2d_solver* other = fed(forged);
      CHECK(c2d_restore(other) == (may_slide[static_cast<size_t>(pair - 1)] ? C2D_OK : C2D_ERR_STORE_FORMAT));
    }
}

TEST_CASE("strangers: pieces that are whole but not those the record adds up, and a record in the other's place") {
  for (const bool in_piece : {true, false}) {
    CAPTURE(in_piece);
    Store store = saved(kPlain, true).store;
    Opened opened(store);
    Image image(store, opened);
    if (in_piece)
      *image.at(image.bytes / 2) ^= 1;
    else
      ++opened.data(C2D_TAPE_CONTROL, 2)->at(kHeader); // the number of the save, which chooses the slot
    opened.seal();
    const Restored found = restore(store, kPlain);
    CHECK(found.status == (in_piece ? C2D_ERR_STORE_STALE : C2D_ERR_STORE_SWAPPED));
    CHECK(found.state == C2D_STATE_MODEL); // nothing has been taken up
  }
}

TEST_CASE("strangers: what a saved state says of the model is not listened to") {
  for (const int variant : {int{kPlain}, int{kFree}, int{kTied}, int{kDeckStepping}}) {
    CAPTURE(variant);
    const Saved& state = saved(variant, true);
    const Restored clean = restore(state.store, variant);
    REQUIRE(clean.status == C2D_OK);
    REQUIRE(clean.numbers.size() == 72);
    c2d_port port = C2D_INIT(c2d_port);
    Machine machine(variant, &port);
    const uint64_t* const at = machine.solver->layout.offset;
    const auto same = [&](size_t from, size_t to) {
      for (const int value : {0xFF, 0x7F, 0x00}) {
        const unsigned char byte = static_cast<unsigned char>(value);
        const Bytes forged(to - from, byte);
        const Restored found = restore(with(state.store, image_offset(from), forged.data(), forged.size()), variant);
        REQUIRE(found.status == C2D_OK);
        CHECK(std::memcmp(found.numbers.data(), clean.numbers.data(), clean.numbers.size() * sizeof(double)) == 0);
      }
    };
    same(offsetof(c2d_solver, model), offsetof(c2d_solver, model) + offsetof(c2d::ModelHeader, title));
    same(static_cast<size_t>(at[c2d::kBodyLimits]), static_cast<size_t>(at[c2d::kBodies]));
    for (size_t body = 0; body < 2; ++body) {
      const size_t place = static_cast<size_t>(at[c2d::kBodies]) + body * sizeof(c2d::Body);
      same(place, place + offsetof(c2d::Body, name));
    }
    same(static_cast<size_t>(at[c2d::kZones]), static_cast<size_t>(at[c2d::kZones]) + offsetof(c2d::Zone, name));
    for (size_t pair = 0; pair < 3; ++pair)
      same(static_cast<size_t>(at[c2d::kPairs]) + pair * sizeof(c2d::Pair),
           static_cast<size_t>(at[c2d::kPairs]) + pair * sizeof(c2d::Pair) + offsetof(c2d::Pair, status));
    same(static_cast<size_t>(at[c2d::kPointLoads]), static_cast<size_t>(at[c2d::kPairTable]));
    same(static_cast<size_t>(at[c2d::kPathLoads]), static_cast<size_t>(at[c2d::kEnergy]));
  }
}

TEST_CASE("strangers: texts without an end, names that are none") {
  const Saved& state = saved(kPlain, true);
  c2d_port port = C2D_INIT(c2d_port);
  Machine machine(kPlain, &port);
  const uint64_t* const at = machine.solver->layout.offset;
  struct Text {
    size_t place, size;
  };
  const size_t head = offsetof(c2d_solver, model);
  const Text texts[] = {{head + offsetof(c2d::ModelHeader, title), sizeof c2d::ModelHeader::title},
                        {head + offsetof(c2d::ModelHeader, unit_length), 16},
                        {head + offsetof(c2d::ModelHeader, unit_force), 16},
                        {static_cast<size_t>(at[c2d::kBodies]) + offsetof(c2d::Body, name), 32},
                        {static_cast<size_t>(at[c2d::kBodies]) + sizeof(c2d::Body) + offsetof(c2d::Body, name), 32},
                        {static_cast<size_t>(at[c2d::kZones]) + offsetof(c2d::Zone, name), 32}};
  for (const Text& text : texts) {
    const Bytes endless(text.size, 'x');
    CHECK(restore(with(state.store, image_offset(text.place), endless.data(), text.size), kPlain).status ==
          C2D_ERR_STORE_FORMAT);
    CHECK(restore(with(state.store, image_offset(text.place), "label", 6), kPlain).status == C2D_OK);
    const c2d_status control = restore(with(state.store, image_offset(text.place), "a\nb", 4), kPlain).status;
    CHECK(control == (text.size == 32 ? C2D_ERR_STORE_FORMAT : C2D_OK));
  }
}

TEST_CASE("strangers: row exchanges that lead out of a panel are refused") {
  const int variant = kKeepFactors;
  const Saved& state = saved(variant, false);
  int refusals = 0;
  for (size_t block = 0; block < state.store.tape[C2D_TAPE_LOWER].size(); ++block)
    for (const int32_t value : {-1, INT32_MAX, 4000}) {
      Store store = state.store;
      Opened opened(store);
      Bytes* const data = opened.data(C2D_TAPE_LOWER, block);
      REQUIRE(data);
      std::memcpy(data->data() + kHeader, &value, sizeof value);
      opened.seal();
      c2d_port port = C2D_INIT(c2d_port);
      store.serve(port);
      Machine machine(variant, &port);
      c2d_solver* const s = machine.solver;
      REQUIRE(build(s, variant) == C2D_OK);
      REQUIRE(c2d_restore(s) == C2D_OK);
      REQUIRE(c2d_change_loads(s) == C2D_OK);
      const c2d_status status = c2d_prepare(s);
      CHECK((status == C2D_OK || status == C2D_ERR_STORE_FORMAT)); // other blocks of the tape hold numbers
      refusals += status == C2D_ERR_STORE_FORMAT;
    }
  CHECK(refusals == 2 * 3); // a block of each body
}

TEST_CASE("strangers: every word of a state forged, one by one, and everything asked for") {
  size_t tried = 0;
  for (int variant = 0; variant < kVariants; variant += 5) {
    const Saved& state = saved(variant, true);
    Store copy = state.store;
    Opened opened(copy);
    const size_t bytes = Image(copy, opened).bytes;
    for (size_t word = static_cast<size_t>(variant % 7); word < bytes / 4; word += 13, ++tried) {
      const int32_t value = word % 2 == 0 ? INT32_MAX : -7;
      Store store = with(state.store, 4 * word, &value, sizeof value);
      take_up(store, variant);
    }
  }
  std::mt19937 generator(14);
  for (int i = 0; i < 300; ++i, ++tried) {
    Bytes bytes(1 + generator() % 60);
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(generator());
    forged::run(bytes.data(), bytes.size());
  }
  MESSAGE("forged states taken up: " << tried);
  CHECK(tried > 1000);
}
