// A solver that outlives its address, its process and its store's mishaps: c2d_attach, c2d_save, c2d_restore.
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace runs;

namespace {

struct Host : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  Host() { serve(port); }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
};

uint64_t memory_for(const c2d_limits& limits, bool in_core) {
  uint64_t minimum = 0, most = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, &most) == C2D_OK);
  return in_core ? most : minimum;
}

// A workspace at a chosen offset from a multiple of 64, without a solver yet.
struct Room {
  Bytes bytes;
  size_t start, size;
  Room(uint64_t n, size_t offset) : bytes(static_cast<size_t>(n) + 192, 0xA5), size(static_cast<size_t>(n)) {
    const size_t past = reinterpret_cast<uintptr_t>(bytes.data()) % 64;
    start = 64 + (64 - past) % 64 + offset;
  }
  unsigned char* memory() { return bytes.data() + start; }
  bool guards_are_whole() const {
    for (size_t i = 0; i < bytes.size(); ++i)
      if ((i < start || i >= start + size) && bytes[i] != 0xA5) return false;
    return true;
  }
};

// The loads of a path up and down, and what is seen at each of them.
const double kLoads[] = {0.2, 0.55, 0.8, 1.0, 0.7, 0.3, 0.9};

void look(c2d_solver* s, std::vector<double>& out) {
  const c2d_summary summary = summary_of(s);
  for (int32_t field = 0; field < C2D_PAIR_FIELDS && summary.pairs > 0; ++field) {
    const size_t at = out.size();
    out.resize(at + static_cast<size_t>(summary.pairs));
    REQUIRE(c2d_get(s, field, 1, 1, summary.pairs, out.data() + at, 1) == C2D_OK);
  }
  out.insert(out.end(), {summary.load, summary.work, summary.elastic, summary.dissipated, summary.energy_defect,
                         static_cast<double>(summary.events), static_cast<double>(summary.exchanges)});
}
void step(c2d_solver* s, size_t i, std::vector<double>& out) {
  const std::vector<double> load(static_cast<size_t>(summary_of(s).load_cases), kLoads[i]);
  c2d_outcome outcome = -1;
  REQUIRE(c2d_advance(s, load.data(), static_cast<int32_t>(load.size()), &outcome) == C2D_OK);
  out.push_back(outcome);
  look(s, out);
}
void begin(c2d_solver* s) {
  const double mu = 0.3;
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
}
// The path without any interruption.
std::vector<double> whole_path(const Deck& deck, bool in_core) {
  const c2d_limits limits = deck.limits();
  Host host;
  Machine machine(limits, memory_for(limits, in_core), &host.port);
  REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  begin(machine.solver);
  std::vector<double> out;
  for (size_t i = 0; i < std::size(kLoads); ++i) step(machine.solver, i, out);
  Numbers numbers;
  REQUIRE(get_boundary(machine.solver, numbers) == C2D_OK);
  out.insert(out.end(), numbers.boundary.begin(), numbers.boundary.end());
  return out;
}

} // namespace

TEST_CASE("attach: moved between any two calls, to any alignment, the same bits") {
  for (const char* name : {"hertz_lin_l", "layer_mu", "plate"})
    for (bool in_core : {false, true}) {
      CAPTURE(std::string(name));
      const Deck deck = deck_named(name);
      const c2d_limits limits = deck.limits();
      const std::vector<double> expected = whole_path(deck, in_core);
      const uint64_t bytes = memory_for(limits, in_core);
      Host host;
      std::vector<std::unique_ptr<Room>> rooms;
      rooms.push_back(std::make_unique<Room>(bytes, 5));
      c2d_solver* s = nullptr;
      REQUIRE(c2d_create(&s, rooms.back()->memory(), rooms.back()->size, &limits, &host.port, nullptr) == C2D_OK);
      size_t offset = 0;
      const auto move = [&] {
        const int32_t state = c2d_get_state(s);
        offset = (offset * 5 + 17) % 64;
        rooms.push_back(std::make_unique<Room>(bytes, offset));
        Room &from = *rooms[rooms.size() - 2], &to = *rooms.back();
        std::copy_n(from.memory(), from.size, to.memory());
        std::fill(from.bytes.begin(), from.bytes.end(), static_cast<unsigned char>(0xEE)); // nothing may point there
        REQUIRE(c2d_attach(&s, to.memory(), to.size, &host.port, nullptr) == C2D_OK);
        REQUIRE(reinterpret_cast<uintptr_t>(s) % 64 == 0);
        REQUIRE(c2d_get_state(s) == state);
      };
      move();
      REQUIRE(read_deck(s, deck) == C2D_OK);
      move();
      REQUIRE(c2d_prepare(s) == C2D_OK);
      move();
      begin(s);
      std::vector<double> out;
      for (size_t i = 0; i < std::size(kLoads); ++i) {
        move();
        step(s, i, out);
      }
      move();
      Numbers numbers;
      REQUIRE(get_boundary(s, numbers) == C2D_OK);
      out.insert(out.end(), numbers.boundary.begin(), numbers.boundary.end());
      CHECK(Numbers::same(out, expected));
      CHECK(c2d_close(s) == C2D_OK);
      CHECK(rooms.back()->guards_are_whole());
    }
}
