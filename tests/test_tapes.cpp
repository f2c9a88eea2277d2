// Tapes known beforehand: what c2d_tape_need and the constants tell, against what the store is asked for.
#include "contact2d_memory.h"
#include "fuzz/small_model.hpp"
#include "many_bodies.hpp"
#include "paths.hpp"
#include "solver_runs.hpp"
#include "store/block.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

using namespace runs;

namespace {

struct Shape {
  uint64_t blocks = 0, bytes = 0;
};
struct Tapes {
  Shape tape[C2D_TAPES];
};

Tapes told(const c2d_limits& limits, const c2d_options& options, uint64_t workspace) {
  Tapes out;
  for (int32_t t = 0; t < C2D_TAPES; ++t)
    REQUIRE(c2d_tape_need(&limits, &options, workspace, t, &out.tape[t].blocks, &out.tape[t].bytes, nullptr) == C2D_OK);
  return out;
}

// The largest shape that each tape was opened with.
Tapes opened(const RamStore& store) {
  Tapes out;
  for (const RamStore::Operation& o : store.done) {
    if (o.kind != 'o') continue;
    Shape& shape = out.tape[o.tape];
    shape.blocks = std::max(shape.blocks, o.block);
    shape.bytes = std::max(shape.bytes, o.bytes);
  }
  return out;
}

// While a deck is solved and saved.
Tapes asked(const Deck& deck, const c2d_limits& limits, const c2d_options& options, uint64_t workspace, bool save) {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  Machine machine(limits, workspace, &port, 0);
  REQUIRE(machine.created == C2D_OK);
  Numbers numbers;
  REQUIRE(run_all(machine.solver, deck, numbers, &options) == C2D_OK);
  if (save) REQUIRE(c2d_save(machine.solver) == C2D_OK);
  return opened(store);
}

void bounded(const Tapes& need, const Tapes& open) {
  for (int32_t t = 0; t < C2D_TAPES; ++t) {
    CAPTURE(t);
    CHECK(open.tape[t].blocks <= need.tape[t].blocks);
    CHECK(open.tape[t].bytes <= need.tape[t].bytes);
  }
}

uint64_t count(int32_t number) { return static_cast<uint64_t>(number); }

Tapes constants(const c2d_limits& l, int32_t keep_factors) {
  const c2d_body_limits none = {}, &one = l.body[0], &two = l.bodies == 2 ? l.body[1] : none;
  const uint64_t f = count(l.function_nodes), p = count(l.panel_columns), k = count(l.load_cases), pairs = count(l.pairs),
                 free_pairs = count(l.free_pairs), keep = count(keep_factors);
  const uint64_t n1 = count(one.points), e1 = count(one.elements), r1 = count(one.regions);
  const uint64_t n2 = count(two.points), e2 = count(two.elements), r2 = count(two.regions);
  Tapes out;
  out.tape[C2D_TAPE_LOWER] = {
      C2D_LOWER_BLOCKS(f, n1, e1, r1, pairs, k, p, keep) + C2D_LOWER_BLOCKS(f, n2, e2, r2, pairs, k, p, keep),
      std::max(C2D_LOWER_BLOCK_BYTES(f, n1, e1, r1, free_pairs, p), C2D_LOWER_BLOCK_BYTES(f, n2, e2, r2, 0, p))};
  out.tape[C2D_TAPE_UPPER] = {C2D_UPPER_BLOCKS(f, n1, e1, r1, pairs, k, p) + C2D_UPPER_BLOCKS(f, n2, e2, r2, pairs, k, p),
                              std::max(C2D_UPPER_BLOCK_BYTES(f, n1, e1, r1, p), C2D_UPPER_BLOCK_BYTES(f, n2, e2, r2, p))};
  out.tape[C2D_TAPE_CONTACT] = {C2D_CONTACT_BLOCKS(count(l.bodies), pairs, k), C2D_CONTACT_BLOCK_BYTES(pairs)};
  return out;
}

uint64_t workspace_of(const c2d_limits& l) {
  const c2d_body_limits none = {}, &one = l.body[0], &two = l.bodies == 2 ? l.body[1] : none;
  return C2D_LIMITS_BYTES(count(l.function_nodes), count(one.points), count(two.points), count(one.elements),
                          count(two.elements), count(one.regions), count(two.regions), count(l.zones), count(l.pairs),
                          count(l.contact_elements), count(l.point_loads), count(l.coefficients), count(l.paths),
                          count(l.load_cases), count(l.panel_columns), count(l.free_pairs), count(l.point_sets),
                          count(l.curves));
}

// In arrays and preprocessor conditions.
static_assert(C2D_UPPER_BLOCKS(2, 40, 40, 1, 12, 1, 4) > 0, "a constant");
#if C2D_CONTACT_BLOCKS(2, 12, 1) != 16 * 12 + 45 || C2D_LOWER_BLOCKS(2, 40, 40, 1, 12, 1, 1, 1) != 84
#error "these are constants of the preprocessor, too"
#endif

const int32_t kPanels[] = {0, 1, 3, 8, 31, 40, 1000};

} // namespace

TEST_CASE("tapes: never more is asked for than was told, for every deck, workspace, width of panels and option") {
  int seen = 0;
  for (const std::string& name : deck_names()) {
    CAPTURE(name);
    const Deck deck = deck_named(name);
    for (const int32_t panel : kPanels) {
      CAPTURE(panel);
      host::Limits limits = deck.limits();
      limits.panel_columns = panel;
      if (limits.body[0].elements > 60 && panel != 0 && panel != 8) continue; // a minute more
      uint64_t least = 0, most = 0;
      REQUIRE(c2d_memory_need(&limits, &least, &most, nullptr) == C2D_OK);
      for (const uint64_t workspace : {least, least + (most - least) / 16, least + (most - least) / 4, most}) {
        CAPTURE(workspace);
        c2d_options options = C2D_INIT(c2d_options);
        options.keep_factors = seen % 2;
        bounded(told(limits, options, workspace), asked(deck, limits, options, workspace, true));
        ++seen;
      }
    }
  }
  CHECK(seen > 100);
}

TEST_CASE("tapes: they are those told where limits are the model's own and every unknown is eliminated") {
  const Deck deck = deck_named("plate"); // without contact; boundary points are those of linear elements
  const host::Limits limits = deck.limits();
  REQUIRE(limits.pairs == 0);
  uint64_t least = 0, most = 0;
  REQUIRE(c2d_memory_need(&limits, &least, &most, nullptr) == C2D_OK);
  const c2d_options options = C2D_INIT(c2d_options);
  const Tapes need = told(limits, options, least), open = asked(deck, limits, options, least, true);
  for (int32_t t = 0; t < C2D_TAPES; ++t) {
    CAPTURE(t);
    CHECK(open.tape[t].blocks == need.tape[t].blocks);
    CHECK(open.tape[t].bytes == need.tape[t].bytes);
  }
}

TEST_CASE("tapes: a model far smaller than its limits stays within them, too") {
  const c2d_options options = C2D_INIT(c2d_options);
  for (const char* name : {"plate", "sample", "rect"}) {
    CAPTURE(name);
    const Deck deck = deck_named(name);
    for (const int32_t factor : {2, 3, 7})
      for (const int32_t panel : {0, 5}) {
        CAPTURE(factor);
        host::Limits limits = deck.limits();
        for (int b = 0; b < limits.bodies; ++b) {
          limits.body[b].points *= factor;
          limits.body[b].elements *= factor;
        }
        limits.pairs += factor;
        limits.coefficients += factor;
        limits.panel_columns = panel;
        uint64_t least = 0, most = 0;
        REQUIRE(c2d_memory_need(&limits, &least, &most, nullptr) == C2D_OK);
        for (const uint64_t workspace : {least, least + least / 4, (least + most) / 2, most}) {
          CAPTURE(workspace);
          bounded(told(limits, options, workspace), asked(deck, limits, options, workspace, false));
        }
      }
  }
}

// Pairs of free zones, had it some, would have rows of their own: the largest model within the limits is cut into strips, and
// this one, cut alike, would have whole blocks that do not fit beside its path.
TEST_CASE("tapes: a model far smaller than its limits in rows alone, in the least memory") {
  many::Model m;
  m.add(many::rectangle(0, -1, 2, 0, {1, 1, 36, 1}));
  m.add(many::rectangle(0, 0, 2, 1, {36, 1, 1, 1}));
  m.add(many::rectangle(5, 0, 7, 1, {12, 12, 12, 12}));
  for (const int32_t body : {1, 3}) m.set(body, 1, many::end_of(many::kHeld));
  for (const int32_t body : {2, 3}) m.set(body, 3, many::end_of(many::kPulled, 0, -1));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.3;
  std::vector<c2d_body_limits> list;
  c2d_limits limits = many::limits_of(m, list);
  const c2d_options options = C2D_INIT(c2d_options);
  std::vector<double> first;
  for (const int32_t free_pairs : {0, 6, 12}) {
    limits.free_pairs = free_pairs;
    limits.panel_columns = 32;
    uint64_t least = 0;
    REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
    for (const uint64_t more : {UINT64_C(0), UINT64_C(2048), UINT64_C(5120), UINT64_C(20000)}) {
      CAPTURE(free_pairs);
      CAPTURE(more);
      RamStore store;
      c2d_port port = C2D_INIT(c2d_port);
      store.serve(port);
      Machine machine(limits, least + more, &port, 0);
      REQUIRE(machine.created == C2D_OK);
      REQUIRE(many::feed(machine.solver, m) == C2D_OK);
      Numbers numbers;
      REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
      REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
      CHECK(machine.guards_are_whole());
      bounded(told(limits, options, least + more), opened(store));
      if (first.empty()) first = numbers.boundary;
      REQUIRE(numbers.boundary.size() == first.size());
      for (size_t i = 0; i < first.size(); ++i)
        CHECK(std::fabs(numbers.boundary[i] - first[i]) < (C2D_REAL_BYTES == 8 ? 1e-9 : 1e-2));
    }
  }
}

TEST_CASE("tapes: the constants are what is told where panels are given") {
  for (const std::string& name : deck_names()) {
    CAPTURE(name);
    for (const int32_t panel : {1, 2, 7, 16, 31})
      for (const int32_t keep : {0, 1}) {
        CAPTURE(panel);
        CAPTURE(keep);
        host::Limits limits = deck_named(name).limits();
        limits.panel_columns = panel;
        c2d_options options = C2D_INIT(c2d_options);
        options.keep_factors = keep;
        const uint64_t workspace = workspace_of(limits);
        uint64_t least = 0;
        REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
        REQUIRE(least <= workspace);
        for (const int32_t more : {0, 1000, 100000, 10000000}) {
          const Tapes need = told(limits, options, workspace + count(more)), constant = constants(limits, keep);
          for (const int32_t t : {C2D_TAPE_LOWER, C2D_TAPE_UPPER, C2D_TAPE_CONTACT}) {
            CAPTURE(t);
            CHECK(need.tape[t].blocks == constant.tape[t].blocks);
            if (need.tape[t].blocks > 0) CHECK(need.tape[t].bytes == constant.tape[t].bytes);
          }
          CHECK(need.tape[C2D_TAPE_CONTROL].blocks <= C2D_CONTROL_BLOCKS(workspace));
          CHECK(need.tape[C2D_TAPE_CONTROL].bytes == C2D_CONTROL_BLOCK_BYTES);
        }
      }
  }
}

TEST_CASE("tapes: what cannot be told is refused, and nothing is touched") {
  const host::Limits limits = deck_named("sample").limits();
  uint64_t least = 0, blocks = 7, bytes = 7;
  REQUIRE(c2d_memory_need(&limits, &least, nullptr, nullptr) == C2D_OK);
  const auto refused = [&](const c2d_limits* given, const c2d_options* options, uint64_t workspace, int32_t tape,
                           c2d_status expected, const std::string& what) {
    c2d_error why = C2D_INIT(c2d_error);
    CHECK(c2d_tape_need(given, options, workspace, tape, &blocks, &bytes, &why) == expected);
    CHECK(c2d_tape_need(given, options, workspace, tape, &blocks, &bytes, nullptr) == expected);
    CHECK(why.status == expected);
    CHECK_MESSAGE(std::string(why.text).find(what) != std::string::npos, why.text);
    CHECK(why.bytes_needed == (expected == C2D_ERR_MEMORY ? least : 0));
  };
  refused(nullptr, nullptr, least, 0, C2D_ERR_ARGUMENT, "c2d_limits is null");
  refused(&limits, nullptr, least, -1, C2D_ERR_ARGUMENT, "tape is -1, expected 0 to 3");
  refused(&limits, nullptr, least, C2D_TAPES, C2D_ERR_ARGUMENT, "tape is 4, expected 0 to 3");
  refused(&limits, nullptr, least - 1, C2D_TAPE_UPPER, C2D_ERR_MEMORY, ": " + std::to_string(least) + " bytes would do");
  c2d_limits wrong = limits;
  wrong.pairs = -1;
  refused(&wrong, nullptr, least, 0, C2D_ERR_ARGUMENT, "c2d_limits.pairs is -1, expected 0 or more");
  wrong.pairs = INT32_MAX;
  refused(&wrong, nullptr, least, 0, C2D_ERR_OVERFLOW, c2d_message(C2D_ERR_OVERFLOW));
  c2d_options forgotten{};
  refused(&limits, &forgotten, least, 0, C2D_ERR_ARGUMENT, "c2d_options.struct_size is 0, expected C2D_INIT(c2d_options)");
  c2d_error unset{};
  CHECK(c2d_tape_need(&limits, nullptr, least, 0, &blocks, &bytes, &unset) == C2D_ERR_ARGUMENT);
  CHECK(c2d_memory_need(&limits, &blocks, &bytes, &unset) == C2D_ERR_ARGUMENT);
  CHECK(blocks == 7);
  CHECK(bytes == 7);
  CHECK(c2d_tape_need(&limits, nullptr, least, C2D_TAPE_UPPER, nullptr, nullptr, nullptr) == C2D_OK);
}

// tests/data/format1_control.c2d: tape CONTROL as contact2d 0.1 left it, with a saved state of the deck `plate`.
TEST_CASE("tapes: blocks and saved states of 0.1 are refused with the reason") {
  std::ifstream file(paths::root() + "/tests/data/format1_control.c2d", std::ios::binary);
  const Bytes old((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  constexpr size_t kBlock = C2D_CONTROL_BLOCK_BYTES;
  REQUIRE(old.size() > 3 * kBlock);
  const c2d::BlockReport count = c2d::inspect_block(old.data(), 8, nullptr);
  CHECK(count.fault == c2d::BlockFault::version);
  CHECK(count.found == 1);
  CHECK(count.expected == c2d::kBlockVersion);
  CHECK(c2d::kBlockVersion > 1);

  RamStore store;
  for (size_t at = 0; at < old.size(); at += kBlock)
    store.tape[C2D_TAPE_CONTROL].emplace_back(old.data() + at, old.data() + std::min(at + kBlock, old.size()));
  const std::vector<Bytes> before = store.tape[C2D_TAPE_CONTROL];
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  const Deck deck = deck_named("plate");
  const host::Limits limits = deck.limits();
  uint64_t most = 0;
  REQUIRE(c2d_memory_need(&limits, nullptr, &most, nullptr) == C2D_OK);
  Machine machine(limits, most, &port, 0);
  REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
  CHECK(c2d_restore(machine.solver) == C2D_ERR_MISMATCH);
  const std::string text = error_of(machine.solver).text;
  CHECK_MESSAGE(text.find("format version (another version of the library) is 1, expected 3") != std::string::npos, text);
  CHECK(c2d_get_state(machine.solver) == C2D_STATE_MODEL);
  CHECK(std::equal(before[0].begin(), before[0].end(), store.tape[C2D_TAPE_CONTROL][0].begin()));
  CHECK(c2d_prepare(machine.solver) == C2D_OK); // the store is as good as a new one
}

TEST_CASE("tapes: no byte that was in the host's memory before is written to one") {
  namespace small = small_model;
  const auto written = [](int variant, unsigned char fill) {
    small::Store store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    small::Machine machine(variant, &port, fill);
    const double mu = 0.3, load[] = {1.0, 0.6};
    c2d_outcome outcome = -1;
    c2d_solver* const s = machine.solver;
    REQUIRE(machine.created == C2D_OK);
    REQUIRE(small::build(s, variant) == C2D_OK);
    REQUIRE(c2d_prepare(s) == C2D_OK);
    REQUIRE(c2d_save(s) == C2D_OK);
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(s, load, 2, &outcome) == C2D_OK);
    REQUIRE(c2d_save(s) == C2D_OK); // in the other slot
    REQUIRE(c2d_close(s) == C2D_OK);
    return store;
  };
  for (int variant = 0; variant < small::kVariants; ++variant) {
    const small::Store one = written(variant, 0xA5), other = written(variant, 0x3C);
    for (int tape = 0; tape < C2D_TAPES; ++tape) {
      CAPTURE(variant);
      CAPTURE(tape);
      REQUIRE(one.tape[tape].size() == other.tape[tape].size());
      for (size_t block = 0; block < one.tape[tape].size(); ++block) {
        CAPTURE(block);
        REQUIRE(one.tape[tape][block] == other.tape[tape][block]);
      }
    }
  }
}
