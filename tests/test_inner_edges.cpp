// What the core's own tools do at the ends of their ranges: numbers and text, wide integers, tapes of a store that lacks a
// function, plans of the elimination for any sizes, pivots at the ends of what a double holds.
#include "elimination/plan.hpp"
#include "linalg/dense.hpp"
#include "linalg/exchange.hpp"
#include "linalg/lu.hpp"
#include "memory/sizes.hpp"
#include "memory/text.hpp"
#include "memory/wide_integer.hpp"
#include "solver/phases.hpp"
#include "store/block.hpp"
#include "store/tapes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace c2d;

namespace {

std::string shown(double number, int32_t digits) {
  char bytes[64];
  Text text = text_in(bytes);
  put(text, number, digits);
  return bytes;
}

std::string printed(double number, int32_t digits) {
  char bytes[64];
  std::snprintf(bytes, sizeof bytes, "%.*g", digits, number);
  return bytes;
}

} // namespace

TEST_CASE("inner edges: a number with fewer than one digit has one, with more than 17 has 17") {
  for (double number : {1.0 / 3.0, 6.02e23, -5e-324, 1e308, 0.5}) {
    CHECK(shown(number, 0) == printed(number, 1));
    CHECK(shown(number, -9) == printed(number, 1));
    CHECK(shown(number, 40) == printed(number, 17));
  }
}

TEST_CASE("inner edges: numbers of few digits over the whole range of a double, as printf has them") {
  std::mt19937_64 random(3);
  int wrong = 0;
  for (int exponent = -1074; exponent <= 1023; ++exponent)
    for (int32_t digits : {1, 2, 17}) {
      const double number = std::ldexp(1.0 + static_cast<double>(random() >> 12) * 0x1p-52, exponent);
      wrong += shown(number, digits) != printed(number, digits);
    }
  CHECK(wrong == 0);
}

TEST_CASE("inner edges: a name that does not fit is left out from its first character on that does not") {
  char bytes[24], none[1];
  Text text = text_in(bytes);
  put_with_name(text, "body ", 3, "a long name that ends nowhere");
  CHECK(std::string(bytes) == "body 3 (a long name tha");
  text = text_in(bytes);
  put_with_name(text, "body ", 3, "\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6"); // of two bytes each
  CHECK(std::string(bytes) == "body 3 (\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4");     // no half of one
  Text nowhere = text_in(none, 0);
  put_with_name(nowhere, "body ", 3, "bolt");
  CHECK(nowhere.size == 0);
}

TEST_CASE("inner edges: wide integers, zero and at the top of what they hold") {
  WideInteger a;
  wide_set(a, 0);
  CHECK(wide_bits(a) == 0);
  wide_shift_left(a, 100);
  CHECK(a.used == 0);
  wide_set(a, 5);
  wide_shift_left(a, 1565); // 5 * 2^1565 has 1568 bits
  CHECK(wide_bits(a) == 1568);
  CHECK(a.used == WideInteger::kWords);
  WideInteger same = a;
  wide_shift_left(a, 0); // (there is no word above)
  CHECK(wide_compare(a, same) == 0);
  wide_multiply(a, 2); // beyond the top is cut off, and nothing is written there
  CHECK(a.used == WideInteger::kWords);
  CHECK(wide_bits(a) == 1567);
  wide_set(a, 1);
  wide_shift_left(a, 1567);
  wide_shift_left(a, 32);
  CHECK(a.used == 0);
}

TEST_CASE("inner edges: a store without one of its functions is none, when a tape is opened and opened again") {
  struct Store {
    static int32_t open(void*, int32_t, uint64_t, uint64_t) { return 0; }
    static int32_t read(void*, int32_t, uint64_t, void*, uint64_t) { return 0; }
    static int32_t write(void*, int32_t, uint64_t, const void*, uint64_t) { return 0; }
    static int32_t one(void*, int32_t) { return 0; }
  };
  const auto whole = [] {
    c2d_port port = C2D_INIT(c2d_port);
    port.open = Store::open, port.read = Store::read, port.write = Store::write, port.sync = port.close = Store::one;
    return port;
  };
  for (int lacks = 0; lacks <= 6; ++lacks) {
    CAPTURE(lacks);
    c2d_port port = whole();
    Tapes tapes;
    std::memset(&tapes, 0, sizeof tapes);
    tapes.port = &port;
    REQUIRE(open_tape(tapes, C2D_TAPE_UPPER, 1, 8) == C2D_OK);
    if (lacks == 1) port.open = nullptr;
    if (lacks == 2) port.read = nullptr;
    if (lacks == 3) port.write = nullptr;
    if (lacks == 4) port.sync = nullptr;
    if (lacks == 5) port.close = nullptr;
    if (lacks == 6) tapes.port = nullptr;
    const c2d_status expected = lacks == 0 ? C2D_OK : C2D_ERR_STORE_OPEN;
    CHECK(open_tape(tapes, C2D_TAPE_LOWER, 1, 8) == expected);
    CHECK(reopen_tapes(tapes) == expected);
    if (lacks > 0) CHECK(std::string(tapes.error.text).find("without a complete block store") != std::string::npos);
  }
}

TEST_CASE("inner edges: tapes that are none, or not open, or longer than a file can be") {
  c2d_port port = C2D_INIT(c2d_port);
  port.open = [](void*, int32_t, uint64_t, uint64_t) { return 0; };
  port.read = [](void*, int32_t, uint64_t, void*, uint64_t) { return 0; };
  port.write = [](void*, int32_t, uint64_t, const void*, uint64_t) { return 0; };
  port.sync = port.close = [](void*, int32_t) { return 0; };
  Tapes tapes;
  std::memset(&tapes, 0, sizeof tapes);
  tapes.port = &port;
  CHECK(open_tape(tapes, C2D_TAPE_LOWER, 3, static_cast<uint64_t>(INT64_MAX) / 2) == C2D_ERR_OVERFLOW);
  CHECK(std::string(tapes.error.text).find("its length does not fit into 63 bits") != std::string::npos);
  unsigned char buffer[kBlockHeaderBytes + kControlBytes] = {};
  for (int32_t tape : {-1, C2D_TAPES + 0, C2D_TAPE_LOWER + 0}) {
    CHECK(sync_tape(tapes, tape) == C2D_ERR_INTERNAL);
    CHECK(close_tape(tapes, tape) == C2D_ERR_INTERNAL);
    CHECK(read_block(tapes, tape, 0, buffer, 8) == C2D_ERR_INTERNAL);
    CHECK(write_block(tapes, tape, 0, buffer, 8) == C2D_ERR_INTERNAL);
    for (const bool ahead : {false, true}) {
      BlockTransfer transfer;
      CHECK(start_transfer(tapes, transfer, BlockTransfer::read, tape, 0, buffer, 8, ahead) == C2D_ERR_INTERNAL);
    }
  }
  CHECK(recount_run(tapes, buffer) == C2D_ERR_INTERNAL); // tape CONTROL is not open
  CHECK(keep_count(tapes, buffer) == C2D_ERR_INTERNAL);
}

namespace {

// One tape in memory, of one block: CONTROL.
struct Counter {
  std::vector<unsigned char> block;
  c2d_port port = C2D_INIT(c2d_port);
  Tapes tapes;
  unsigned char buffer[kBlockHeaderBytes + kControlBytes] = {};
  Counter() {
    std::memset(&tapes, 0, sizeof tapes);
    port.context = this;
    port.open = [](void* c, int32_t, uint64_t blocks, uint64_t bytes) {
      static_cast<Counter*>(c)->block.resize(blocks * bytes);
      return 0;
    };
    port.read = [](void* c, int32_t, uint64_t, void* to, uint64_t bytes) {
      std::memcpy(to, static_cast<Counter*>(c)->block.data(), bytes);
      return 0;
    };
    port.write = [](void* c, int32_t, uint64_t, const void* from, uint64_t bytes) {
      std::memcpy(static_cast<Counter*>(c)->block.data(), from, bytes);
      return 0;
    };
    port.sync = port.close = [](void*, int32_t) { return 0; };
    tapes.port = &port;
  }
};

} // namespace

TEST_CASE("inner edges: a run whose number would be that of the count itself takes another") {
  Counter c;
  const uint64_t hash = 12345;
  c.tapes.count = mix(hash) - 1; // the next count makes the number 0
  REQUIRE(begin_run(c.tapes, hash, c.buffer) == C2D_OK);
  CHECK(c.tapes.count == mix(hash));
  CHECK(c.tapes.run_id == 1);
}

TEST_CASE("inner edges: a count that is spoilt on its tape is written again, and a run goes on from another") {
  for (const bool torn : {false, true}) {
    CAPTURE(torn);
    Counter c;
    REQUIRE(begin_run(c.tapes, 7, c.buffer) == C2D_OK);
    const auto spoil = [&] { // half of the end of the block is not the one written with it, or a byte of the data
      for (size_t i = 1; i <= 4 && torn; ++i) c.block[c.block.size() - i] ^= 0x55;
      if (!torn) c.block[kBlockHeaderBytes] ^= 1;
    };
    const std::vector<unsigned char> sound = c.block;
    uint64_t count = 0;
    spoil();
    CHECK(read_count(c.tapes, &count, c.buffer) == (torn ? C2D_ERR_STORE_SHORT : C2D_ERR_STORE_CHECKSUM));
    CHECK(keep_count(c.tapes, c.buffer) == C2D_OK);
    CHECK(c.block == sound);
    const uint64_t before = c.tapes.count;
    spoil();
    CHECK(begin_run(c.tapes, 7, c.buffer) == C2D_OK);
    CHECK(c.tapes.count > before + 1000); // from the sum of what is there: nobody had that
  }
}

TEST_CASE("inner edges: an elimination of no sizes, of wrong ones, of any: the plan fits, and its tapes hold what it says") {
  EliminationPlan plan;
  uint64_t needed = 0;
  CHECK(plan_elimination(1 << 20, -1, 0, 0, 0, plan, &needed) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(1 << 20, 5, -1, 0, 0, plan, &needed) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(1 << 20, 5, 6, 0, 0, plan, &needed) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(1 << 20, 5, 4, -1, 0, plan, &needed) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(1 << 20, 5, 4, INT32_MAX - 4, 0, plan, &needed) == C2D_ERR_ARGUMENT);
  CHECK(plan_elimination(1 << 20, 5, 4, 1, -1, plan, &needed) == C2D_ERR_ARGUMENT);
  CHECK(elimination_bytes_in_core(0, 0, 0) > 0);
  CHECK(plan_elimination(1 << 20, 0, 0, 0, 0, plan, nullptr) == C2D_OK);
  EliminationPlan alike = plan;
  cut_alike(plan, alike);
  CHECK(alike.panel_columns == 1);
  std::mt19937 random(11);
  const auto below = [&](int32_t n) { return static_cast<int32_t>(random() % static_cast<uint32_t>(n)); };
  int planned = 0;
  for (int i = 0; i < 20000; ++i) {
    const int32_t rows = below(3) == 0 ? below(20) : below(4000), pivots = rows > 0 ? below(rows + 1) : 0;
    const int32_t trailing = below(3) == 0 ? 0 : below(200);
    const int32_t forced = below(2) == 0 ? 0 : 1 + below(below(2) == 0 ? 60 : 3000);
    const uint64_t in_core = elimination_bytes_in_core(rows, pivots, trailing);
    const uint64_t bytes = static_cast<uint64_t>(std::ldexp(static_cast<double>(in_core), -below(12)));
    const c2d_status status = plan_elimination(bytes, rows, pivots, trailing, forced, plan, &needed);
    REQUIRE((status == C2D_OK || (status == C2D_ERR_MEMORY && needed > bytes)));
    if (status != C2D_OK) continue;
    ++planned;
    REQUIRE(elimination_bytes(plan) <= bytes);
    plan.keep_lower = below(2);
    const TapeUse lower = lower_use(plan), upper = upper_use(plan), most = most_upper_use(plan);
    REQUIRE(most.blocks >= upper.blocks);
    if (plan.keep_lower != 0 && pivots > 0) REQUIRE(lower.max_data_bytes >= sizeof(int32_t) * static_cast<uint64_t>(pivots));
  }
  CHECK(planned > 5000);
}

TEST_CASE("inner edges: a pivot whose reciprocal has lost its digits divides, and gives what the quotients are") {
  if (sizeof(Real) != sizeof(double)) return;
  const double huge = std::numeric_limits<double>::max();
  Real a[4] = {static_cast<Real>(huge), static_cast<Real>(huge / 3), 1, 1}, norms[2];
  const double exact = static_cast<double>(a[1]) / huge;
  int32_t pivots[2];
  REQUIRE(lu_factor(kPlainEngine, 2, a, 2, pivots, norms, nullptr) == 0);
  CHECK(static_cast<double>(a[1]) == exact);
  CHECK(static_cast<double>(a[3]) == 1.0 - exact);
  CHECK(lu_width(100) <= lu_width(1000));
  CHECK(lu_width(2000) <= lu_width(3000));
  if (!kSmallCode) CHECK(lu_width(3000) == kWidestLuBlock);
}

TEST_CASE("inner edges: two exchanges at once, where either has no pivot, leave all as it was") {
  const double tables[3][4] = {{0, 2, 3, 4}, {1, 2, 2, 4}, {0, 0, 0, 0}}; // no first pivot, none left for the second
  for (const auto& table : tables) {
    Real t[4], was[4];
    for (int i = 0; i < 4; ++i) was[i] = t[i] = static_cast<Real>(table[i]);
    CHECK_FALSE(exchange_two(2, 2, t, 2, 0, 1, nullptr));
    if (!kSmallCode) CHECK(std::memcmp(t, was, sizeof t) == 0);
  }
  Real t[4] = {2, 1, 1, 3}; // both at once are the negative of the inverse, as METHOD 11 has exchanges, or the inverse
  REQUIRE(exchange_two(2, 2, t, 2, 0, 1, nullptr));
  const double inverse[4] = {0.6, -0.2, -0.2, 0.4};
  for (int i = 0; i < 4; ++i)
    CHECK(std::fabs(static_cast<double>(t[i])) == doctest::Approx(std::fabs(inverse[i])).epsilon(1e-6));
}

TEST_CASE("inner edges: columns are cut for many workers into pieces that are neither too narrow nor too wide") {
  for (int32_t columns : {0, 1, 7, 33, 63, 65, 100, 2000, 50001})
    for (int32_t parts : {1, 2, 3, 16}) {
      const int32_t pieces = pieces_of(columns, parts);
      CHECK((pieces == 0) == (columns == 0));
      if (parts == 1) CHECK(pieces <= 1);
      int32_t end = 0; // of the piece before
      for (int32_t item = 0; item < pieces; ++item) {
        const Piece piece = piece_of(columns, parts, item);
        CHECK(piece.first == end);
        CHECK(piece.count >= (columns < 32 ? columns : 32));
        if (parts > 1) CHECK(piece.count <= kWidth);
        end += piece.count;
      }
      CHECK(end == columns);
    }
}

// Two bodies of so many elements, with linear functions, and a zone of so many pairs.
static c2d_limits limits_for(int32_t elements, int32_t pairs, std::vector<c2d_body_limits>& list) {
  list.assign(2, c2d_body_limits{elements, elements, 1, 0});
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 2, limits.body = list.data(), limits.function_nodes = 2;
  limits.zones = 1, limits.pairs = limits.contact_elements = pairs;
  limits.coefficients = limits.paths = 1;
  return limits;
}

TEST_CASE("inner edges: where what stands beside an elimination takes all the memory, its panels have one column") {
  std::vector<c2d_body_limits> list;
  Sizes sizes;
  REQUIRE(derive_sizes(limits_for(30, 8, list), sizes) == C2D_OK);
  const PhaseSizes s = phase_sizes(sizes);
  for (const uint64_t bytes : {uint64_t{0}, uint64_t{1}, uint64_t{1000}}) {
    const EliminationPlan plan = plan_by(PlanRule{bytes, 0}, s, 0);
    CHECK(plan.panel_columns == 1);
    CHECK(plan.block_columns == 1);
  }
}

TEST_CASE("inner edges: plans of any model within its limits keep to the memory there is") {
  std::mt19937 random(3);
  const auto below = [&](int32_t n) { return static_cast<int32_t>(random() % static_cast<uint32_t>(n)); };
  for (int i = 0; i < 3000; ++i) {
    std::vector<c2d_body_limits> list, own_list;
    const int32_t elements = 10 + below(below(2) == 0 ? 60 : 600), pairs = 2 + below(elements / 2);
    Sizes limits, own;
    REQUIRE(derive_sizes(limits_for(elements, pairs, list), limits) == C2D_OK);
    REQUIRE(derive_sizes(limits_for(4 + below(elements - 4), 1 + below(pairs), own_list), own) == C2D_OK);
    uint64_t least = 0, in_core = 0;
    REQUIRE(phase_need(limits, &least, &in_core) == C2D_OK);
    const uint64_t bytes = least + static_cast<uint64_t>(std::ldexp(static_cast<double>(in_core - least), -below(12)));
    EliminationPlan plan[2];
    const PhaseSizes s = phase_sizes(own);
    plan_phases(limits, s, bytes, plan);
    CAPTURE(elements);
    CHECK(phases_use(s, plan, false) <= bytes);
  }
}

TEST_CASE("inner edges: memory beyond what an address counts is told, whatever it is for") {
  std::vector<c2d_body_limits> list;
  int beyond = 0;
  for (double pairs = 1e5; pairs < 2.1e9; pairs *= 1.1) {
    Sizes sizes;
    if (derive_sizes(limits_for(2000, static_cast<int32_t>(pairs), list), sizes) != C2D_OK) continue;
    uint64_t least = 0, in_core = 0;
    const c2d_status status = phase_need(sizes, &least, &in_core);
    CHECK((status == C2D_OK || status == C2D_ERR_OVERFLOW));
    beyond += status == C2D_ERR_OVERFLOW;
    if (status == C2D_OK) CHECK(static_cast<double>(in_core) > 4 * pairs * pairs * sizeof(Real));
  }
  CHECK(beyond > 0);
}
