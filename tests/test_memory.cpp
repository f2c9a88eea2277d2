// Fixed memory: the need, the constant bound, exactly N bytes at every alignment, overflow, what is reported as used.
#include "contact2d_memory.h"
#include "memory/config.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace runs;

namespace {

struct Need {
  c2d_status status;
  uint64_t minimum, in_core;
};
Need need_of(const c2d_limits& limits) {
  Need need{C2D_OK, 0, 0};
  need.status = c2d_memory_need(&limits, &need.minimum, &need.in_core, nullptr);
  return need;
}

uint64_t bound_of(const c2d_limits& l) {
  const bool two = l.bodies == 2;
  const auto n = [](int32_t count) { return static_cast<uint64_t>(count); };
  return C2D_LIMITS_BYTES(n(l.function_nodes), n(l.body[0].points), n(two ? l.body[1].points : 0), n(l.body[0].elements),
                          n(two ? l.body[1].elements : 0), n(l.body[0].regions), n(two ? l.body[1].regions : 0), n(l.zones),
                          n(l.pairs), n(l.contact_elements), n(l.point_loads), n(l.coefficients), n(l.paths), n(l.load_cases),
                          n(l.panel_columns), n(l.free_pairs), n(l.point_sets), n(l.curves));
}

host::Limits smallest_limits() {
  host::Limits l;
  l.bodies = l.function_nodes = 1;
  l.body[0].points = l.body[0].elements = l.body[0].regions = 1;
  return l;
}

// Every number that limits hold, to be set to something in turn.
std::vector<int32_t c2d_limits::*> counts() {
  return {&c2d_limits::zones,        &c2d_limits::pairs, &c2d_limits::contact_elements, &c2d_limits::point_loads,
          &c2d_limits::coefficients, &c2d_limits::paths, &c2d_limits::load_cases,       &c2d_limits::panel_columns,
          &c2d_limits::point_sets,   &c2d_limits::curves};
}
std::vector<int32_t*> numbers_of(c2d_limits& l) {
  std::vector<int32_t*> out;
  for (int b = 0; b < 2; ++b) out.insert(out.end(), {&l.body[b].points, &l.body[b].elements, &l.body[b].regions});
  for (auto member : counts()) out.push_back(&(l.*member));
  return out;
}

struct Spread {
  double ratio = 0.0;
  uint64_t least = UINT64_MAX, most = 0;
  int checked = 0;
  void take(const c2d_limits& l) {
    const Need need = need_of(l);
    if (need.status == C2D_ERR_OVERFLOW) return;
    REQUIRE(need.status == C2D_OK);
    const uint64_t bound = bound_of(l);
    CAPTURE(l.function_nodes);
    CAPTURE(l.body[0].elements);
    CAPTURE(l.body[1].elements);
    CAPTURE(l.pairs);
    CAPTURE(l.load_cases);
    REQUIRE(bound >= need.minimum);
    REQUIRE(bound - need.minimum <= 1024 + need.minimum / 20);
    least = std::min(least, bound - need.minimum);
    most = std::max(most, bound - need.minimum);
    ratio = std::max(ratio, static_cast<double>(bound) / static_cast<double>(need.minimum));
    ++checked;
  }
};

struct Quiet : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  Quiet() { serve(port); }
};

// A static array, as a host without a heap would write it.
unsigned char static_memory[C2D_MEMORY_BYTES(2, 60, 60, 60, 60, 1, 1, 1, 20, 19, 0, 4, 4, 1)];
static_assert(C2D_MEMORY_BYTES(2, 40, 0, 40, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0) ==
                  C2D_MEMORY_BYTES(2, 40, 0, 40, 0, 1, 0, 0, 0, 0, 0, 0, 1, 1),
              "no load cases means one");

} // namespace

TEST_CASE("memory: the constant bound holds for all limits and is tight") {
  std::mt19937 random(1987);
  Spread spread;
  for (int i = 0; i < 20000; ++i) {
    const auto any = [&](int32_t from) {
      const int bits = static_cast<int>(random() % 15);
      return from + static_cast<int32_t>(random() % (1u << bits));
    };
    host::Limits l = smallest_limits();
    l.bodies = 1 + static_cast<int32_t>(random() % 2);
    l.function_nodes = 1 + static_cast<int32_t>(random() % 4);
    for (int b = 0; b < 2; ++b) l.body[b].points = any(1), l.body[b].elements = any(1), l.body[b].regions = any(1);
    for (auto member : counts()) l.*member = any(0);
    l.panel_columns = 0;
    if (i % 2 == 0) l.free_pairs = static_cast<int32_t>(random() % (static_cast<uint32_t>(l.pairs) + 1));
    spread.take(l);
  }
  // Extremes: one number large, the rest as small as they may be; every row count near the odd leading dimensions.
  for (int functions = 1; functions <= 4; ++functions) {
    for (int bit = 0; bit < 27; ++bit) {
      host::Limits l = smallest_limits();
      l.function_nodes = functions;
      l.bodies = 2;
      l.body[1].points = l.body[1].elements = l.body[1].regions = 1;
      for (int32_t* number : numbers_of(l)) {
        if (number == &l.panel_columns) continue;
        const int32_t before = *number;
        *number = 1 << bit;
        spread.take(l);
        *number = before;
      }
    }
    for (int32_t elements = 1; elements < 1200; ++elements) {
      host::Limits l = smallest_limits();
      l.function_nodes = functions;
      l.body[0].elements = elements;
      spread.take(l);
    }
  }
  MESSAGE("limits " << spread.checked << ", bound - need " << spread.least << " to " << spread.most << " bytes, largest ratio "
                    << spread.ratio);
  CHECK(spread.checked > 24000);
}

TEST_CASE("memory: a static array of the bound's size solves the sample") {
  const Deck deck = deck_named("sample");
  const host::Limits limits = deck.limits();
  REQUIRE(limits.pairs <= 20);
  REQUIRE(limits.body[0].elements <= 60);
  REQUIRE(limits.body[1].elements <= 60);
  Quiet store;
  c2d_solver* solver = nullptr;
  REQUIRE(c2d_create(&solver, static_memory, sizeof static_memory, &limits, &store.port, nullptr) == C2D_OK);
  Numbers numbers;
  CHECK(run_all(solver, deck, numbers) == C2D_OK);
  CHECK(c2d_close(solver) == C2D_OK);
}

TEST_CASE("memory: exactly N bytes do, fewer never, at every alignment") {
  for (const char* name : {"plate", "sample"}) {
    const host::Limits limits = deck_named(name).limits();
    const Need need = need_of(limits);
    REQUIRE(need.status == C2D_OK);
    Bytes room(static_cast<size_t>(need.minimum) + 128, 0x5A);
    for (size_t offset = 0; offset < 64; ++offset) {
      c2d_solver* solver = nullptr;
      c2d_error why = C2D_INIT(c2d_error);
      unsigned char* at = room.data() + offset;
      REQUIRE(c2d_create(&solver, at, static_cast<size_t>(need.minimum), &limits, nullptr, &why) == C2D_OK);
      REQUIRE(reinterpret_cast<uintptr_t>(solver) % 64 == 0);
      REQUIRE(c2d_close(solver) == C2D_OK);
      const Bytes before = room;
      for (uint64_t bytes = need.minimum; bytes-- > 0;) {
        if (need.minimum - bytes > 70 && bytes > 70 && bytes % 1009 != 0) continue;
        why = C2D_INIT(c2d_error);
        REQUIRE(c2d_create(&solver, at, static_cast<size_t>(bytes), &limits, nullptr, &why) == C2D_ERR_MEMORY);
        REQUIRE(solver == nullptr);
        REQUIRE(why.status == C2D_ERR_MEMORY);
        REQUIRE(why.bytes_needed == need.minimum);
      }
      REQUIRE(room == before);
    }
    c2d_solver* solver = nullptr;
    c2d_error why = C2D_INIT(c2d_error);
    CHECK(c2d_create(&solver, nullptr, 0, &limits, nullptr, &why) == C2D_ERR_MEMORY);
    CHECK(why.bytes_needed == need.minimum);
    CHECK(c2d_create(&solver, nullptr, 1, &limits, nullptr, &why) == C2D_ERR_ARGUMENT);
  }
}

TEST_CASE("memory: the minimum solves every deck, nothing outside is touched, the answer does not depend on it") {
  for (const std::string& name : deck_names()) {
    CAPTURE(name);
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    const Need need = need_of(limits);
    REQUIRE(need.status == C2D_OK);
    CHECK(need.minimum <= need.in_core);
    Numbers first;
    const std::vector<size_t> offsets = name == "sample" ? std::vector<size_t>{0, 1, 8, 31, 63} : std::vector<size_t>{17};
    for (size_t offset : offsets) {
      Quiet store;
      Machine machine(limits, need.minimum, &store.port, offset);
      REQUIRE(machine.created == C2D_OK);
      Numbers numbers;
      REQUIRE(run_all(machine.solver, deck, numbers) == C2D_OK);
      CHECK(machine.guards_are_whole());
      if (offset == offsets[0]) first = numbers;
      CHECK(numbers == first);
      const host::Summary summary = summary_of(machine.solver);
      CHECK(summary.minimum_bytes == need.minimum);
      CHECK(summary.peak_bytes <= summary.workspace_bytes);
      CHECK(summary.peak_bytes > 0);
      REQUIRE(c2d_close(machine.solver) == C2D_OK);
      CHECK(machine.guards_are_whole());
    }
  }
}

TEST_CASE("memory: all in core is one panel, and more is of no use") {
  for (const std::string& name : deck_names()) {
    CAPTURE(name);
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    const Need need = need_of(limits);
    uint64_t peak = 0;
    for (uint64_t bytes : {need.in_core, 3 * need.in_core + 12345}) {
      Quiet store;
      Machine machine(limits, bytes, &store.port, 5);
      Numbers numbers;
      REQUIRE(run_all(machine.solver, deck, numbers) == C2D_OK);
      CHECK(machine.guards_are_whole());
      const host::Summary s = summary_of(machine.solver);
      const int32_t unknowns = std::max(s.body[0].unknowns, s.body[1].unknowns);
      CHECK(s.panel_columns >= unknowns - s.contact_unknowns);
      CHECK(s.tape_blocks[C2D_TAPE_LOWER] == 0);
      CHECK(s.tape_writes[C2D_TAPE_LOWER] == 0);
      CHECK(store.writes[C2D_TAPE_LOWER] == 0);
      CHECK(s.peak_bytes <= need.in_core - 63);
      if (peak == 0) peak = s.peak_bytes;
      CHECK(s.peak_bytes == peak);
    }
  }
}

TEST_CASE("memory: more of it never fails, and the bytes said to be used are used, no more") {
  for (const char* name : {"plate", "hertz_lin_l", "rect"}) {
    CAPTURE(name);
    const Deck deck = deck_named(name);
    for (int32_t forced : {0, 1, 3, 8, 20, 50, 1000}) {
      CAPTURE(forced);
      host::Limits limits = deck.limits();
      limits.panel_columns = forced;
      const Need need = need_of(limits);
      REQUIRE(need.status == C2D_OK);
      REQUIRE(need.minimum <= need.in_core);
      std::vector<uint64_t> sizes = {need.minimum, need.in_core, need.in_core + 64};
      for (int i = 1; i < 8; ++i) sizes.push_back(need.minimum + (need.in_core - need.minimum) * static_cast<uint64_t>(i) / 8);
      for (uint64_t d : {1u, 63u, 64u, 500u, 1000u, 3000u}) sizes.push_back(need.minimum + d);
      for (uint64_t bytes : sizes) {
        CAPTURE(bytes);
        Quiet store;
        Machine machine(limits, bytes, &store.port);
        REQUIRE(machine.created == C2D_OK);
        Numbers numbers;
        REQUIRE(run_all(machine.solver, deck, numbers) == C2D_OK);
        const host::Summary s = summary_of(machine.solver);
        if (forced > 0 && forced < 50) CHECK(s.panel_columns == forced);
        // Beyond its peak the workspace is as it was: the guard's value.
        const unsigned char* end = reinterpret_cast<const unsigned char*>(machine.solver) + s.workspace_bytes;
        const unsigned char* used = reinterpret_cast<const unsigned char*>(machine.solver) + s.peak_bytes;
        CHECK(s.peak_bytes <= s.workspace_bytes);
        CHECK(std::all_of(used, end, [](unsigned char byte) { return byte == 0xA5; }));
        // and of its last 3 KiB at least something was touched (the widest gap is the room of unused norms and pivots, and in
        // small code, which takes one block at a time, that of a second one)
        if (c2d::kSmallCode) continue;
        CHECK(
            std::any_of(used - std::min<uint64_t>(3072, s.peak_bytes), used, [](unsigned char byte) { return byte != 0xA5; }));
      }
    }
  }
}

TEST_CASE("memory: limits at their overflow") {
  // Nothing wraps: the answer never falls when a number grows, and what is too much is said to be.
  std::mt19937 random(2);
  const int32_t large[] = {1, 1000, 1 << 20, 1 << 28, 1 << 29, (1 << 30) - 1, 1 << 30, INT32_MAX / 2, INT32_MAX - 1, INT32_MAX};
  int overflows = 0, fits = 0;
  for (int i = 0; i < 20000; ++i) {
    host::Limits l = smallest_limits();
    l.bodies = 1 + static_cast<int32_t>(random() % 2);
    l.function_nodes = 1 + static_cast<int32_t>(random() % 4);
    l.body[1].points = l.body[1].elements = l.body[1].regions = 1;
    const std::vector<int32_t*> numbers = numbers_of(l);
    const size_t changed = 1 + random() % 3;
    for (size_t k = 0; k < changed; ++k) *numbers[random() % numbers.size()] = large[random() % 10];
    const Need need = need_of(l);
    if (need.status == C2D_OK) {
      REQUIRE(need.minimum <= need.in_core);
      ++fits;
    } else {
      REQUIRE(need.status == C2D_ERR_OVERFLOW);
      ++overflows;
    }
    // At least what the plainest arrays take, in a wider arithmetic.
    const long double m = 2.0L * l.pairs, cases = std::max(l.load_cases, 1);
    long double least = m * m * 8 * 2 + 136.0L * l.pairs + 56.0L * l.zones + 48.0L * l.point_loads + 8.0L * l.coefficients +
                        16.0L * l.paths + 52.0L * l.point_sets + 44.0L * l.curves;
    for (int b = 0; b < l.bodies; ++b)
      least += 20.0L * l.body[b].points + 8.0L * l.body[b].regions + 16.0L * l.body[b].elements * cases;
    if (need.status == C2D_OK) REQUIRE(static_cast<long double>(need.minimum) >= least);
    // One less of everything that was large needs no more.
    host::Limits smaller = l;
    for (int32_t* number : numbers_of(smaller))
      if (*number > 1) --*number;
    const Need less = need_of(smaller);
    if (need.status == C2D_OK) {
      REQUIRE(less.status == C2D_OK);
      REQUIRE(less.minimum <= need.minimum);
      REQUIRE(less.in_core <= need.in_core);
    }
    c2d_solver* solver = nullptr;
    unsigned char few[8];
    c2d_error why = C2D_INIT(c2d_error);
    const c2d_status made = c2d_create(&solver, few, sizeof few, &l, nullptr, &why);
    REQUIRE(made == (need.status == C2D_OK ? C2D_ERR_MEMORY : C2D_ERR_OVERFLOW));
    REQUIRE(why.bytes_needed == (need.status == C2D_OK ? need.minimum : 0));
  }
  CHECK(overflows > 1000);
  CHECK(fits > 1000);
  host::Limits all = smallest_limits();
  all.bodies = 2;
  all.function_nodes = 4;
  for (int32_t* number : numbers_of(all)) *number = INT32_MAX;
  CHECK(need_of(all).status == C2D_ERR_OVERFLOW);
  // The number of contact pairs alone, whose square counts.
  for (int32_t pairs : {INT32_MAX, INT32_MAX / 2 + 1, 1 << 30}) {
    host::Limits l = smallest_limits();
    l.pairs = pairs;
    CHECK(need_of(l).status == C2D_ERR_OVERFLOW);
  }
}

TEST_CASE("memory: more platens than there may be are refused at once") {
  host::Limits l = smallest_limits();
  l.platens = 1 << 30; // (a minute of sums)
  CHECK(need_of(l).status == C2D_ERR_ARGUMENT);
  l.platens = l.zones + 1;
  CHECK(need_of(l).status == C2D_ERR_ARGUMENT);
  l.platens = l.zones = 2;
  CHECK(need_of(l).status == C2D_OK);
}

TEST_CASE("memory: negative and missing sizes") {
  host::Limits good = smallest_limits();
  good.bodies = 2;
  good.body[1].points = good.body[1].elements = good.body[1].regions = 1;
  REQUIRE(need_of(good).status == C2D_OK);
  for (size_t k = 0; k < numbers_of(good).size(); ++k)
    for (int32_t value : {-1, -1000, INT32_MIN}) {
      host::Limits l = good;
      *numbers_of(l)[k] = value;
      CHECK(need_of(l).status == C2D_ERR_ARGUMENT);
    }
  for (size_t k = 0; k < 6; ++k) {
    host::Limits l = good;
    *numbers_of(l)[k] = 0;
    CHECK(need_of(l).status == C2D_ERR_ARGUMENT);
  }
  for (int32_t value : {INT32_MIN, -1, 0, 3, 5, INT32_MAX}) {
    host::Limits l = good;
    l.bodies = value;
    CHECK(need_of(l).status == C2D_ERR_ARGUMENT);
    l = good;
    l.function_nodes = value == 3 ? 0 : value;
    CHECK(need_of(l).status == C2D_ERR_ARGUMENT);
  }
  CHECK(c2d_memory_need(nullptr, nullptr, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_memory_need(&good, nullptr, nullptr, nullptr) == C2D_OK);
}
