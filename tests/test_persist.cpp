// A solver that outlives its address, its process and its store's mishaps: c2d_attach, c2d_save, c2d_restore.
#include "contact2d_image.h"
#include "shell.hpp"
#include "solver/solver.hpp"
#include "solver_runs.hpp"
#include "store/block.hpp"

#include <c2d_posix.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

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
  REQUIRE(c2d_memory_need(&limits, &minimum, &most, nullptr) == C2D_OK);
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
  const host::Summary summary = summary_of(s);
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
  const host::Limits limits = deck.limits();
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
      const host::Limits limits = deck.limits();
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

TEST_CASE("attach: an image with a checksum is taken up whole or not at all") {
  const Deck deck = deck_named("hertz_lin_l");
  const host::Limits limits = deck.limits();
  Host host;
  Room room(memory_for(limits, false), 5);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, room.memory(), room.size, &limits, &host.port, nullptr) == C2D_OK);
  REQUIRE(read_deck(s, deck) == C2D_OK);
  uint64_t sum = 0, other = 0;
  Bytes image(room.memory(), room.memory() + room.size);
  REQUIRE(c2d_image_sum(s, &sum) == C2D_OK);
  CHECK(image == Bytes(room.memory(), room.memory() + room.size)); // it has changed nothing
  CHECK(c2d_image_sum(nullptr, &sum) == C2D_ERR_ARGUMENT);
  CHECK(c2d_image_sum(s, nullptr) == C2D_ERR_ARGUMENT);
  REQUIRE(c2d_cancel(s) == C2D_OK); // it may come from another thread at that very moment
  REQUIRE(c2d_image_sum(s, &other) == C2D_OK);
  CHECK(sum == other);
  const size_t at = static_cast<size_t>(reinterpret_cast<unsigned char*>(s) - room.memory());
  const size_t cancelled = at + offsetof(c2d_solver, cancelled);
  const auto attach = [&image](uint64_t expected, c2d_error& why) {
    c2d_solver* out = nullptr;
    return c2d_attach_image(&out, image.data(), image.size(), nullptr, expected, &why);
  };
  int refused = 0;
  const Bytes whole = image;
  for (size_t i = at; i < image.size(); i += i < at + 2000 ? 1 : 13) {
    if (i >= cancelled && i < cancelled + 4) continue;
    for (const int bits : {1, 0x80}) {
      image[i] = static_cast<unsigned char>(image[i] ^ bits);
      const Bytes damaged = image;
      c2d_error why = C2D_INIT(c2d_error);
      const c2d_status status = attach(sum, why);
      const bool beyond = i >= at + s->bytes; // (what alignment has left over)
      CAPTURE(i);
      REQUIRE((status != C2D_OK || beyond));
      if (status == C2D_ERR_STORE_CHECKSUM) {
        CHECK(std::string(why.text) == "the memory does not match its checksum");
        ++refused;
      }
      if (!beyond) REQUIRE(image == damaged);
      image = whole;
    }
  }
  CHECK(refused > 1000);
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(attach(sum + 1, why) == C2D_ERR_STORE_CHECKSUM);
  for (const size_t shift : {0u, 3u, 8u}) { // wherever the copy lies
    Bytes copy(image.size() + shift);
    std::copy(image.begin(), image.end(), copy.begin() + static_cast<std::ptrdiff_t>(shift));
    c2d_solver* out = nullptr;
    REQUIRE(c2d_attach_image(&out, copy.data() + shift, image.size(), &host.port, sum, &why) == C2D_OK);
    CHECK(c2d_get_state(out) == C2D_STATE_MODEL);
  }
}

TEST_CASE("attach: what is no solver, or not all of it, is refused and left alone") {
  const Deck deck = deck_named("hertz_lin_l");
  const host::Limits limits = deck.limits();
  const uint64_t bytes = memory_for(limits, false);
  Host host;
  Room room(bytes, 11);
  c2d_solver* s = nullptr;
  REQUIRE(c2d_create(&s, room.memory(), room.size, &limits, &host.port, nullptr) == C2D_OK);
  REQUIRE(read_deck(s, deck) == C2D_OK);
  const size_t at = static_cast<size_t>(reinterpret_cast<unsigned char*>(s) - room.memory());
  const Bytes image(room.memory(), room.memory() + room.size);
  uint64_t needed = 0;
  std::string told;
  const auto attach = [&](Bytes& from, size_t size, const c2d_port* port) {
    const Bytes before = from;
    c2d_solver* out = reinterpret_cast<c2d_solver*>(1);
    c2d_error why = C2D_INIT(c2d_error);
    const c2d_status status = c2d_attach(&out, from.data(), size, port, &why);
    CHECK((out == nullptr) == (status != C2D_OK));
    if (status != C2D_OK) {
      CHECK(why.status == status);
      CHECK(from == before);
    }
    needed = why.bytes_needed;
    told = why.text;
    return status;
  };
  Bytes copy = image;
  for (size_t size : {size_t{0}, size_t{1}, size_t{63}, size_t{1000}}) CHECK(attach(copy, size, nullptr) == C2D_ERR_ARGUMENT);
  for (size_t size = 4000; size < image.size(); size += size < image.size() - 70 ? 1711 : 1) {
    CHECK(attach(copy, size, nullptr) == C2D_ERR_MEMORY);
    CHECK(needed == bytes);
  }
  CHECK(attach(copy, copy.size(), nullptr) == C2D_OK);
  copy = image;
  copy.resize(image.size() + 1000); // longer does no harm
  CHECK(attach(copy, copy.size(), nullptr) == C2D_OK);
  // Any byte of what tells the solver: magic, maker, place, size; then limits and layout.
  for (size_t i = 0; i < 24; ++i) {
    copy = image;
    copy[at + i] ^= 0x41;
    const c2d_status status = attach(copy, copy.size(), nullptr);
    CAPTURE(i);
    CHECK((status == C2D_ERR_MISMATCH) == (told.find("another version of the library, size of pointers or number type") < 200));
    if (i >= 16)
      CHECK(status != C2D_OK);
    else
      CHECK(status == (i >= 8 && i < 12 ? C2D_ERR_MISMATCH : C2D_ERR_ARGUMENT));
  }
  std::vector<size_t> places;
  for (size_t i = offsetof(c2d_solver, sizes); i < offsetof(c2d_solver, layout) + sizeof(c2d::Layout); i += 4)
    places.push_back(i);
  for (int32_t b = 0; b < limits.bodies; ++b) { // what of them stands behind the struct: limits and layout of each body
    const size_t list =
        static_cast<size_t>(s->layout.offset[c2d::kBodyLimits]) + static_cast<size_t>(b) * sizeof(c2d_body_limits);
    for (size_t i = 0; i < offsetof(c2d_body_limits, reserved); i += 4) places.push_back(list + i);
    const size_t body = static_cast<size_t>(s->layout.offset[c2d::kBodies]) + static_cast<size_t>(b) * sizeof(c2d::Body);
    for (size_t i = 0; i < sizeof(c2d::Body::array); i += 4) places.push_back(body + offsetof(c2d::Body, array) + i);
  }
  for (size_t i : places) {
    copy = image;
    for (size_t k = 0; k < 4; ++k) copy[at + i + k] ^= 0x81;
    CAPTURE(i);
    CHECK(attach(copy, copy.size(), nullptr) != C2D_OK);
  }
  Bytes zeros(10000, 0), noise(10000);
  for (size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<unsigned char>(i * i * 31 + i / 7);
  CHECK(attach(zeros, zeros.size(), nullptr) == C2D_ERR_ARGUMENT);
  CHECK(attach(noise, noise.size(), nullptr) == C2D_ERR_ARGUMENT);
  copy = image;
  c2d_port wrong = host.port;
  wrong.struct_size = 2;
  CHECK(attach(copy, copy.size(), &wrong) == C2D_ERR_ARGUMENT);
  c2d_solver* out = nullptr;
  CHECK(c2d_attach(nullptr, copy.data(), copy.size(), nullptr, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_attach(&out, nullptr, 0, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  // Copied inside a callback: what was under way on the stack is not in the memory.
  struct Copier {
    Host host;
    Room* room;
    Bytes taken;
  } copier{{}, &room, {}};
  c2d_port port = C2D_INIT(c2d_port);
  copier.host.serve(port);
  copier.host.before = [&](const RamStore::Operation&, size_t) {
    copier.taken.assign(room.memory(), room.memory() + room.size);
    return 0;
  };
  REQUIRE(c2d_create(&s, room.memory(), room.size, &limits, &port, nullptr) == C2D_OK);
  REQUIRE(read_deck(s, deck) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  CHECK(attach(copier.taken, copier.taken.size(), &port) == C2D_ERR_BUSY);
  // Prepared by a program without energies, which keeps nothing of what they need: the answer says which call links them.
  copy.assign(room.memory(), room.memory() + room.size);
  const size_t flag = static_cast<size_t>(reinterpret_cast<unsigned char*>(&s->keeps_energy) - room.memory());
  REQUIRE(s->keeps_energy == 1);
  copy[flag] = copy[flag + 1] = 0;
  CHECK(attach(copy, copy.size(), &port) == C2D_ERR_MISMATCH);
  CHECK(told == "the solver in this memory was prepared by a program linked without energies: "
                "call c2d_get_summary, c2d_run, c2d_attach or c2d_restore in that program to link them");
  copy = image; // before preparing there is nothing to keep
  copy[flag] = copy[flag + 1] = 0;
  CHECK(attach(copy, copy.size(), nullptr) == C2D_OK);
  // A store that cannot be opened: the image stays, and can be attached when it can.
  copy.assign(room.memory(), room.memory() + room.size);
  copier.host.before = [](const RamStore::Operation&, size_t) { return 17; };
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_attach(&out, copy.data(), copy.size(), &port, &why) == C2D_ERR_STORE_OPEN);
  CHECK(why.host_code == 17);
  CHECK(out == nullptr);
  CHECK(c2d_attach(&out, copy.data(), copy.size(), nullptr, &why) == C2D_ERR_STORE_OPEN);
  copier.host.before = nullptr;
  REQUIRE(c2d_attach(&out, copy.data(), copy.size(), &port, nullptr) == C2D_OK);
  begin(out);
  CHECK(c2d_close(out) == C2D_OK);
}

namespace {

// A solver in state `model` on a store that may hold something already.
struct Fresh {
  Machine machine;
  Fresh(const Deck& deck, Host& host, bool in_core) : machine(deck.limits(), memory_for(deck.limits(), in_core), &host.port) {
    REQUIRE(machine.created == C2D_OK);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
  }
};

} // namespace

TEST_CASE("save: a crash between any two steps, another process, the same bits") {
  for (const char* name : {"hertz_lin_l", "layer_mu", "plate"})
    for (bool in_core : {false, true}) {
      CAPTURE(std::string(name));
      const Deck deck = deck_named(name);
      const std::vector<double> expected = whole_path(deck, in_core);
      Host host;
      auto fresh = std::make_unique<Fresh>(deck, host, in_core);
      c2d_solver* s = fresh->machine.solver;
      uint64_t writes = 0;
      const auto crash = [&] {
        REQUIRE(c2d_save(s) == C2D_OK);
        const int32_t state = c2d_get_state(s);
        const host::Summary before = summary_of(s);
        fresh = std::make_unique<Fresh>(deck, host, in_core);
        s = fresh->machine.solver;
        writes = host.writes[1] + host.writes[2] + host.writes[3];
        REQUIRE(c2d_restore(s) == C2D_OK);
        REQUIRE(c2d_get_state(s) == state);
        const host::Summary after = summary_of(s);
        for (int tape = 0; tape < C2D_TAPES; ++tape) {
          CHECK(before.tape_bytes_written[tape] == after.tape_bytes_written[tape]);
          CHECK(before.tape_bytes_read[tape] <= after.tape_bytes_read[tape]);
        }
        CHECK(before.warnings == after.warnings);
        // Nothing was assembled or eliminated again.
        CHECK(writes == host.writes[1] + host.writes[2] + host.writes[3]);
      };
      REQUIRE(c2d_prepare(s) == C2D_OK);
      crash();
      begin(s);
      std::vector<double> out;
      for (size_t i = 0; i < std::size(kLoads); ++i) {
        crash();
        step(s, i, out);
      }
      crash();
      Numbers numbers;
      REQUIRE(get_boundary(s, numbers) == C2D_OK);
      out.insert(out.end(), numbers.boundary.begin(), numbers.boundary.end());
      CHECK(Numbers::same(out, expected));
    }
}

namespace {

// What the callback of c2d_run is shown, step by step. `save`: it saves at each; `end`: it gives up after so many.
struct Watcher {
  c2d_solver* solver;
  bool save = false;
  size_t end = SIZE_MAX;
  std::vector<std::vector<double>> steps = {};
  std::vector<c2d_status> saved = {};
  static int32_t see(void* context, const c2d_step* now) {
    Watcher& w = *static_cast<Watcher*>(context);
    if (now->kind == C2D_STEP_CHANGE) {
      w.saved.push_back(c2d_save(w.solver));
      return 0;
    }
    std::vector<double> out = {now->mu, now->load, now->work, now->dissipated, now->elastic, now->energy_defect};
    for (const int32_t n : {now->kind, now->coefficient, now->step, now->changes, now->iterations, now->outcome})
      out.push_back(n);
    for (int32_t p = 0; p < now->pairs; ++p)
      out.insert(out.end(), now->table + p * now->stride, now->table + p * now->stride + C2D_PAIR_FIELDS);
    w.steps.push_back(out);
    if (w.save) w.saved.push_back(c2d_save(w.solver));
    return w.steps.size() == w.end ? 7 : 0;
  }
  c2d_status run() { return c2d_run(solver, see, this); }
};

bool same_steps(const Watcher& part, const Watcher& whole) {
  const size_t n = part.steps.size(), first = whole.steps.size() - n;
  for (size_t i = 0; i < n; ++i)
    if (!Numbers::same(part.steps[i], whole.steps[first + i])) return false;
  return n <= whole.steps.size();
}

} // namespace

TEST_CASE("save: in the callback of a run, which goes on there in another process, the same bits") {
  for (const char* name : {"layer_mu", "sample", "plate", "block"})
    for (int32_t stepping : {C2D_STEPPING_EVENTS, C2D_STEPPING_DECK}) {
      CAPTURE(std::string(name));
      CAPTURE(stepping);
      const Deck deck = deck_named(name);
      c2d_options options = C2D_INIT(c2d_options);
      options.stepping = stepping;
      Host one;
      Fresh once(deck, one, true);
      Watcher whole{once.machine.solver};
      REQUIRE(c2d_set_options(whole.solver, &options) == C2D_OK);
      REQUIRE(c2d_prepare(whole.solver) == C2D_OK);
      REQUIRE(whole.run() == C2D_OK);
      const host::Summary expected = summary_of(whole.solver);
      CHECK((expected.run_step == 0 && expected.run_coefficient == 0));
      Numbers numbers;
      REQUIRE(get_boundary(whole.solver, numbers) == C2D_OK);
      const size_t stride = 1 + whole.steps.size() / 5;
      for (size_t end = 1; end <= whole.steps.size();
           end = end < whole.steps.size() && end + stride > whole.steps.size() ? whole.steps.size() : end + stride) {
        Host host;
        {
          Fresh fresh(deck, host, true);
          Watcher begun{fresh.machine.solver, true, end};
          REQUIRE(c2d_set_options(begun.solver, &options) == C2D_OK);
          REQUIRE(c2d_prepare(begun.solver) == C2D_OK);
          CHECK(begun.run() == C2D_ERR_CALLBACK);
          CHECK(begun.saved == std::vector<c2d_status>(end, C2D_OK));
        }
        Fresh fresh(deck, host, true);
        Watcher rest{fresh.machine.solver};
        REQUIRE(c2d_set_options(rest.solver, &options) == C2D_OK);
        REQUIRE(c2d_restore(rest.solver) == C2D_OK);
        const host::Summary now = summary_of(rest.solver);
        CHECK(now.run_coefficient == whole.steps[end - 1][7]);
        CHECK(now.run_step == whole.steps[end - 1][8]);
        REQUIRE(rest.run() == C2D_OK);
        CHECK(rest.steps.size() == whole.steps.size() - end);
        CHECK(same_steps(rest, whole));
        const host::Summary after = summary_of(rest.solver);
        CHECK((after.outcome == expected.outcome && after.events == expected.events && after.exchanges == expected.exchanges));
        CHECK((after.warnings == expected.warnings && after.run_step == 0));
        for (int tape = 1; tape < C2D_TAPES; ++tape) CHECK(after.tape_bytes_read[tape] == expected.tape_bytes_read[tape]);
        Numbers there;
        REQUIRE(get_boundary(rest.solver, there) == C2D_OK);
        CHECK(Numbers::same(there.boundary, numbers.boundary));
        // Another call that moves the load: the next run is a new one.
        REQUIRE(c2d_restore(rest.solver) == C2D_OK);
        begin(rest.solver);
        rest.steps.clear();
        REQUIRE(rest.run() == C2D_OK);
        CHECK(rest.steps.size() == whole.steps.size());
      }
    }
}

TEST_CASE("save: not where a change of status is shown; a store that fails there breaks the solver") {
  const Deck deck = deck_named("layer_mu");
  Host host;
  Fresh fresh(deck, host, true);
  Watcher watcher{fresh.machine.solver};
  c2d_options options = C2D_INIT(c2d_options);
  options.every_change = 1;
  REQUIRE(c2d_set_options(watcher.solver, &options) == C2D_OK);
  REQUIRE(c2d_prepare(watcher.solver) == C2D_OK);
  REQUIRE(watcher.run() == C2D_OK);
  CHECK(watcher.saved.size() > 1);
  for (const c2d_status status : watcher.saved) CHECK(status == C2D_ERR_BUSY);
  host.before = [](const RamStore::Operation& o, size_t) { return o.tape == C2D_TAPE_CONTROL ? 5 : 0; };
  Watcher failing{watcher.solver, true, SIZE_MAX};
  const c2d_status status = failing.run();
  CHECK((status >= C2D_ERR_STORE_OPEN && status <= C2D_ERR_STORE_STALE));
  CHECK(c2d_get_state(failing.solver) == C2D_STATE_BROKEN);
}

TEST_CASE("save: going back within one solver") {
  const Deck deck = deck_named("layer_mu");
  Host host;
  Fresh fresh(deck, host, true);
  c2d_solver* s = fresh.machine.solver;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  begin(s);
  std::vector<double> first, again;
  step(s, 0, first);
  REQUIRE(c2d_save(s) == C2D_OK);
  first.clear();
  for (size_t i = 1; i < std::size(kLoads); ++i) step(s, i, first);
  for (int turn = 0; turn < 3; ++turn) {
    REQUIRE(c2d_restore(s) == C2D_OK);
    CHECK(summary_of(s).load == kLoads[0]);
    again.clear();
    for (size_t i = 1; i < std::size(kLoads); ++i) step(s, i, again);
    CHECK(Numbers::same(first, again));
  }
  // The newer of two; then begin and save in state prepared: back to the factorisation.
  REQUIRE(c2d_save(s) == C2D_OK);
  begin(s);
  REQUIRE(c2d_restore(s) == C2D_OK);
  CHECK(summary_of(s).load == kLoads[std::size(kLoads) - 1]);
}

TEST_CASE("save: torn, lost or failing at every operation of the store, one of the last two states is there") {
  const Deck deck = deck_named("hertz_lin_l");
  Host host;
  auto fresh = std::make_unique<Fresh>(deck, host, false);
  c2d_solver* s = fresh->machine.solver;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  begin(s);
  std::vector<double> unused, second, third;
  step(s, 0, unused);
  REQUIRE(c2d_save(s) == C2D_OK);
  step(s, 1, unused);
  REQUIRE(c2d_save(s) == C2D_OK);
  const std::vector<Bytes> tape = host.tape[0]; // states at loads 0 and 1
  step(s, 2, second);
  step(s, 3, third);
  REQUIRE(c2d_restore(s) == C2D_OK);
  host.done.clear();
  std::vector<double> there;
  step(s, 2, there);
  CHECK(Numbers::same(there, second));
  host.done.clear();
  REQUIRE(c2d_save(s) == C2D_OK);
  const size_t operations = host.done.size();
  const std::vector<RamStore::Operation> done = host.done;
  CHECK(operations > 20);
  int old = 0, now = 0;
  enum Mishap { kFails, kDies, kTorn, kLost, kMishaps };
  for (int mishap = kFails; mishap < kMishaps; ++mishap)
    for (size_t n = 0; n < operations; ++n) {
      CAPTURE(mishap);
      CAPTURE(n);
      host.tape[0] = tape;
      fresh = std::make_unique<Fresh>(deck, host, false);
      s = fresh->machine.solver;
      REQUIRE(c2d_restore(s) == C2D_OK);
      REQUIRE(summary_of(s).load == kLoads[1]);
      std::vector<double> here;
      step(s, 2, here);
      REQUIRE(Numbers::same(here, second));
      host.done.clear();
      if (mishap == kFails || mishap == kDies)
        host.before = [=](const RamStore::Operation&, size_t i) { return i == n || (mishap == kDies && i > n) ? 5 : 0; };
      // The power goes: what is written from here on does not arrive, of the n-th half does.
      if (mishap == kTorn)
        host.keep = [=](const RamStore::Operation& o, size_t i) { return i < n ? o.bytes : (i == n ? o.bytes / 2 : 0); };
      // A write that was promised and is lost.
      if (mishap == kLost) host.keep = [=](const RamStore::Operation& o, size_t i) { return i == n ? 0 : o.bytes; };
      const c2d_status saved = c2d_save(s);
      host.before = nullptr;
      host.keep = nullptr;
      if (mishap == kFails || mishap == kDies) {
        if (saved != C2D_OK) { // reading the count may fail
          REQUIRE(saved >= C2D_ERR_STORE_OPEN);
          REQUIRE(c2d_get_state(s) == C2D_STATE_BROKEN);
          const host::Summary summary = summary_of(s);
          REQUIRE(summary.state == C2D_STATE_BROKEN);
        }
      } else {
        REQUIRE(saved == C2D_OK);
      }
      // In another process, and in this one if the save failed.
      for (int process = 0; process < 2; ++process) {
        if (process == 1) {
          fresh = std::make_unique<Fresh>(deck, host, false);
          s = fresh->machine.solver;
        } else if (saved == C2D_OK) {
          continue;
        }
        REQUIRE(c2d_restore(s) == C2D_OK);
        std::vector<double> state;
        const double load = summary_of(s).load;
        REQUIRE((load == kLoads[1] || load == kLoads[2]));
        ++(load == kLoads[1] ? old : now);
        if (load == kLoads[1]) {
          step(s, 2, state);
          REQUIRE(Numbers::same(state, second));
        }
        state.clear();
        step(s, 3, state);
        REQUIRE(Numbers::same(state, third));
        if (saved != C2D_OK) REQUIRE((load == kLoads[1] || n + 1 == operations));
      }
    }
  MESSAGE("operations of a save: " << operations << ", old state found " << old << " times, new " << now);
  CHECK(old > static_cast<int>(operations));
  CHECK(now > 2);
}

TEST_CASE("restore: what does not belong to the model, the tapes or the library is refused, the solver as before") {
  const Deck deck = deck_named("hertz_lin_l");
  Host host;
  const auto refused = [&](const Deck& other, c2d_status expected, const c2d_options* options = nullptr) {
    const host::Limits limits = other.limits();
    Machine machine(limits, memory_for(limits, false), &host.port);
    c2d_solver* s = machine.solver;
    if (options) REQUIRE(c2d_set_options(s, options) == C2D_OK);
    REQUIRE(read_deck(s, other) == C2D_OK);
    c2d_status status = c2d_restore(s);
    CHECK(status == expected);
    if (expected != C2D_OK) CHECK(error_of(s).status == expected);
    CHECK(c2d_get_state(s) == (expected == C2D_OK ? C2D_STATE_RUNNING : C2D_STATE_MODEL));
    if (expected == C2D_ERR_MISMATCH) { // or what is strange about the block
      const std::string text = error_of(s).text;
      CHECK_MESSAGE((text == c2d_message(C2D_ERR_MISMATCH) || text.find(" (another version of the library) is ") < 320 ||
                     text.find(" (a machine of the other byte order) is ") < 320 ||
                     text.find(" (a library with another C2D_REAL) is ") < 320),
                    text);
    }
    return machine.guards_are_whole();
  };
  CHECK(refused(deck, C2D_ERR_STORE_FORMAT)); // an empty store
  {
    Fresh fresh(deck, host, false);
    REQUIRE(c2d_prepare(fresh.machine.solver) == C2D_OK);
    CHECK(refused(deck, C2D_ERR_STORE_FORMAT)); // a factorisation, but nothing saved
    REQUIRE(c2d_prepare(Fresh(deck, host, false).machine.solver) == C2D_OK);
  }
  Fresh fresh(deck, host, false);
  c2d_solver* s = fresh.machine.solver;
  REQUIRE(c2d_prepare(s) == C2D_OK);
  begin(s);
  REQUIRE(c2d_save(s) == C2D_OK);
  const std::vector<Bytes> tape = host.tape[0];
  // Another model, path, coefficient, stepping.
  CHECK(refused(deck_named("plate"), C2D_ERR_MISMATCH));
  host.tape[0] = tape;
  Deck changed = deck;
  for (std::string& line : changed.lines)
    if (line.find("0.3") != std::string::npos) line.replace(line.find("0.3"), 3, "0.2");
  CHECK(refused(changed, C2D_ERR_MISMATCH));
  c2d_options options = C2D_INIT(c2d_options);
  options.stepping = C2D_STEPPING_DECK;
  CHECK(refused(deck, C2D_ERR_MISMATCH, &options));
  options = C2D_INIT(c2d_options);
  options.quadrature = C2D_QUADRATURE_THESIS;
  CHECK(refused(deck, C2D_ERR_MISMATCH, &options));
  options = C2D_INIT(c2d_options);
  options.every_change = 1; // this one changes no state
  CHECK(refused(deck, C2D_OK, &options));
  host.tape[0] = tape;
  // Other limits.
  host::Limits loose = deck.limits();
  loose.paths += 40;
  Machine wider(loose, memory_for(loose, false), &host.port);
  REQUIRE(read_deck(wider.solver, deck) == C2D_OK);
  CHECK(c2d_restore(wider.solver) == C2D_ERR_MISMATCH);
  // A record that names another state, or a longer image, with sums that are right.
  for (const size_t place : {size_t{32}, size_t{34}, size_t{60}}) {
    host.tape[0] = tape;
    int forged = 0;
    for (const size_t block : {size_t{1}, size_t{2}}) {
      Bytes& bytes = host.tape[0][block];
      const uint64_t data = bytes.size() - c2d::kBlockHeaderBytes;
      c2d::BlockLabel label;
      if (c2d::inspect_block(bytes.data(), data, &label).fault != c2d::BlockFault::none) continue;
      c2d::unseal_block(bytes.data(), label.length);
      bytes[c2d::kBlockHeaderBytes + place] ^= 0x40;
      c2d::seal_block(label, bytes.data());
      ++forged;
    }
    CHECK(forged == 1);
    CHECK(refused(deck, C2D_ERR_MISMATCH));
  }
  host.tape[0] = tape;
  // Another scalar size, another format: bytes 8, 4 and 6 of the header, with the header's own check.
  for (size_t place : {size_t{8}, size_t{4}, size_t{6}}) {
    host.tape[0] = tape;
    for (size_t block : {size_t{1}, size_t{2}}) {
      unsigned char* header = host.tape[0][block].data();
      header[place] ^= 0x0C;
      const uint64_t sum = c2d::checksum(c2d::checksum(2, header, 12), header + 16, 40) >> 32;
      for (size_t i = 0; i < 4; ++i) header[12 + i] = static_cast<unsigned char>(sum >> (8 * i));
    }
    CHECK(refused(deck, C2D_ERR_MISMATCH));
  }
  // No records.
  host.tape[0] = tape;
  for (size_t block : {size_t{1}, size_t{2}}) std::fill(host.tape[0][block].begin(), host.tape[0][block].end(), 0);
  CHECK(refused(deck, C2D_ERR_STORE_FORMAT));
  // Every block of the state, spoilt: there is only one, so nothing is left.
  size_t spoilt = 0;
  for (size_t block = 0; block < tape.size(); ++block) {
    if (tape[block].empty() || tape[block][0] == 0) continue;
    host.tape[0] = tape;
    host.tape[0][block][68] ^= 4;
    Fresh again(deck, host, false);
    const c2d_status status = c2d_restore(again.machine.solver);
    CAPTURE(block);
    CHECK(status != C2D_OK);
    CHECK(c2d_get_state(again.machine.solver) == C2D_STATE_MODEL);
    ++spoilt;
  }
  CHECK(spoilt > 10);
  host.tape[0] = tape;
  // A larger workspace was there: this one is told how much would do.
  {
    Host large;
    Fresh in_core(deck, large, true);
    REQUIRE(c2d_prepare(in_core.machine.solver) == C2D_OK);
    REQUIRE(c2d_save(in_core.machine.solver) == C2D_OK);
    Fresh small(deck, large, false);
    REQUIRE(c2d_restore(small.machine.solver) == C2D_ERR_MEMORY);
    const uint64_t needed = error_of(small.machine.solver).bytes_needed;
    CHECK(needed > memory_for(deck.limits(), false));
    CHECK(needed <= memory_for(deck.limits(), true));
    Machine enough(deck.limits(), needed, &large.port);
    REQUIRE(read_deck(enough.solver, deck) == C2D_OK);
    CHECK(c2d_restore(enough.solver) == C2D_OK);
  }
  // A later run on the same tapes.
  REQUIRE(c2d_prepare(Fresh(deck, host, false).machine.solver) == C2D_OK);
  CHECK(refused(deck, C2D_ERR_STORE_FORMAT)); // that store forgets what is no longer open
  // The state is whole, but a tape of the factorisation is gone: found when it is read.
  host.tape[0].clear();
  Fresh last(deck, host, false);
  REQUIRE(c2d_prepare(last.machine.solver) == C2D_OK);
  REQUIRE(c2d_save(last.machine.solver) == C2D_OK);
  for (Bytes& block : host.tape[C2D_TAPE_CONTACT]) std::fill(block.begin(), block.end(), static_cast<unsigned char>(0));
  Fresh victim(deck, host, false);
  REQUIRE(c2d_restore(victim.machine.solver) == C2D_OK);
  const double mu = 0.3;
  CHECK(c2d_begin(victim.machine.solver, &mu, 1) == C2D_ERR_STORE_FORMAT);
  CHECK(c2d_get_state(victim.machine.solver) == C2D_STATE_BROKEN);
}

TEST_CASE("restore: a factorisation serves any friction, path and stepping, with the same bits") {
  const Deck deck = deck_named("layer_mu");
  Deck other = deck;
  other.lines.back() = "    1 0.80000000";
  for (std::string& line : other.lines)
    if (line == "    2 0.100000000.30000000") line = "    2 0.200000000.05000000";
  for (const int32_t stepping : {C2D_STEPPING_EVENTS, C2D_STEPPING_DECK}) {
    const auto path_of = [&](c2d_solver* s) {
      Numbers out;
      REQUIRE(c2d_run(s, nullptr, nullptr) == C2D_OK);
      REQUIRE(get_boundary(s, out) == C2D_OK);
      return out.boundary;
    };
    const auto ready = [&](Machine& machine) {
      c2d_options options = C2D_INIT(c2d_options);
      options.stepping = stepping;
      REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
      REQUIRE(read_deck(machine.solver, other) == C2D_OK);
    };
    Host host, own;
    { // the factorisation of the deck as it is, and nothing of its path
      Fresh fresh(deck, host, true);
      REQUIRE(c2d_prepare(fresh.machine.solver) == C2D_OK);
      REQUIRE(c2d_save(fresh.machine.solver) == C2D_OK);
    }
    const host::Limits limits = other.limits();
    Machine machine(limits, memory_for(limits, true), &host.port), alone(limits, memory_for(limits, true), &own.port);
    ready(machine);
    REQUIRE(c2d_restore(machine.solver) == C2D_OK);
    CHECK(c2d_get_state(machine.solver) == C2D_STATE_PREPARED);
    ready(alone);
    REQUIRE(c2d_prepare(alone.solver) == C2D_OK);
    const std::vector<double> expected = path_of(alone.solver);
    CHECK(Numbers::same(path_of(machine.solver), expected));
    // and its own path is another one
    Fresh first(deck, own, true);
    REQUIRE(c2d_prepare(first.machine.solver) == C2D_OK);
    CHECK(!Numbers::same(path_of(first.machine.solver), expected));
  }
}

TEST_CASE("restore: a store that dies while the state is taken over breaks the solver, and once more helps") {
  const Deck deck = deck_named("hertz_lin_l");
  Host host;
  Fresh first(deck, host, true);
  REQUIRE(c2d_prepare(first.machine.solver) == C2D_OK);
  begin(first.machine.solver);
  std::vector<double> unused, expected;
  step(first.machine.solver, 1, unused);
  REQUIRE(c2d_save(first.machine.solver) == C2D_OK);
  step(first.machine.solver, 2, expected);
  int broken = 0, kept = 0;
  for (size_t n = 0;; ++n) {
    CAPTURE(n);
    Fresh fresh(deck, host, true);
    c2d_solver* s = fresh.machine.solver;
    host.done.clear();
    host.before = [=](const RamStore::Operation&, size_t i) { return i == n ? 5 : 0; };
    const c2d_status status = c2d_restore(s);
    host.before = nullptr;
    if (host.done.size() <= n) {
      REQUIRE(status == C2D_OK);
      break;
    }
    if (status != C2D_OK) {
      const int32_t state = c2d_get_state(s);
      REQUIRE((state == C2D_STATE_BROKEN || state == C2D_STATE_MODEL));
      ++(state == C2D_STATE_BROKEN ? broken : kept);
      REQUIRE(c2d_restore(s) == C2D_OK);
    }
    std::vector<double> out;
    step(s, 2, out);
    REQUIRE(Numbers::same(out, expected));
  }
  CHECK(broken > 5);
  CHECK(kept > 5);
}

namespace {

// A file of bytes, and a store in files that another process can go on with.
void write_bytes(const std::string& path, const unsigned char* data, size_t size) {
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

} // namespace

TEST_CASE("attach: a workspace dumped by one process and taken up by another") {
  for (const char* name : {"hertz_lin_l", "layer_mu"}) {
    CAPTURE(std::string(name));
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    const std::vector<double> expected = whole_path(deck, false);
    const test::Folder folder;
    const std::string image = folder / "image", answer = folder / "answer";
    // Each step is made by a process of its own; all that passes from one to the next is in files.
    for (size_t i = 0; i <= std::size(kLoads); ++i) {
      const pid_t child = ::fork();
      REQUIRE(child >= 0);
      if (child == 0) {
        c2d_posix_store store;
        c2d_port port = C2D_INIT(c2d_port);
        if (c2d_posix_store_init(&store, (folder / "tapes").c_str()) != 0) ::_exit(2);
        c2d_posix_store_port(&store, &port);
        const std::string before = i == 0 ? std::string() : test::read_file(image);
        const uint64_t size = memory_for(limits, false);
        Room room(size, 7 * i % 64);
        c2d_solver* s = nullptr;
        if (i == 0) {
          const double mu = 0.3;
          if (c2d_create(&s, room.memory(), room.size, &limits, &port, nullptr) != C2D_OK || read_deck(s, deck) != C2D_OK ||
              c2d_prepare(s) != C2D_OK || c2d_begin(s, &mu, 1) != C2D_OK)
            ::_exit(3);
        } else {
          std::memcpy(room.memory(), before.data(), before.size());
          if (c2d_attach(&s, room.memory(), room.size, &port, nullptr) != C2D_OK) ::_exit(4);
        }
        std::vector<double> out;
        if (i < std::size(kLoads)) {
          step(s, i, out);
        } else {
          Numbers numbers;
          if (get_boundary(s, numbers) != C2D_OK) ::_exit(5);
          out = numbers.boundary;
        }
        write_bytes(image, room.memory(), room.size);
        std::ofstream(answer, std::ios::binary | std::ios::app)
            .write(reinterpret_cast<const char*>(out.data()), static_cast<std::streamsize>(out.size() * sizeof(double)));
        ::_exit(0); // killed, as it were: nothing is closed
      }
      int status = -1;
      REQUIRE(::waitpid(child, &status, 0) == child);
      REQUIRE(WIFEXITED(status));
      REQUIRE(WEXITSTATUS(status) == 0);
    }
    const std::string bytes = test::read_file(answer);
    REQUIRE(bytes.size() == expected.size() * sizeof(double));
    CHECK(std::memcmp(bytes.data(), expected.data(), bytes.size()) == 0);
  }
}

namespace {

struct Walker {
  Deck deck;
  Host host;
  Machine machine;
  std::vector<double> out;
  size_t next = 0;
  Walker(const char* name, bool in_core)
      : deck(deck_named(name)), machine(deck.limits(), memory_for(deck.limits(), in_core), &host.port) {}
  // One call; false when there is no more to do.
  bool go() {
    c2d_solver* s = machine.solver;
    switch (next++) {
    case 0: return read_deck(s, deck) == C2D_OK;
    case 1: return c2d_prepare(s) == C2D_OK;
    case 2: {
      const double mu = 0.3;
      return c2d_begin(s, &mu, 1) == C2D_OK;
    }
    default: break;
    }
    if (next - 4 < std::size(kLoads)) {
      step(s, next - 4, out);
      return true;
    }
    Numbers numbers;
    if (get_boundary(s, numbers) == C2D_OK) out.insert(out.end(), numbers.boundary.begin(), numbers.boundary.end());
    return false;
  }
};

} // namespace

TEST_CASE("two solvers: call by call in turn, and each in a thread of its own, the same bits") {
  const char* const names[] = {"layer_mu", "hertz_lin_l"};
  const std::vector<double> expected[] = {whole_path(deck_named(names[0]), false), whole_path(deck_named(names[1]), true)};
  {
    Walker first(names[0], false), second(names[1], true);
    bool more[2] = {true, true};
    while (more[0] || more[1]) {
      if (more[0]) more[0] = first.go();
      if (more[1]) more[1] = second.go();
    }
    CHECK(Numbers::same(first.out, expected[0]));
    CHECK(Numbers::same(second.out, expected[1]));
  }
  // One inside the other: a whole run from a callback of the first.
  {
    Walker outer(names[0], false);
    size_t inside = 0;
    outer.host.before = [&](const RamStore::Operation&, size_t n) {
      if (n % 150 != 0) return 0;
      Walker inner(names[1], true);
      while (inner.go()) {
      }
      inside += Numbers::same(inner.out, expected[1]);
      return 0;
    };
    while (outer.go()) {
    }
    CHECK(Numbers::same(outer.out, expected[0]));
    CHECK(inside > 2);
  }
  for (int round = 0; round < 3; ++round) {
    std::vector<double> out[2];
    std::thread threads[2];
    for (size_t i = 0; i < 2; ++i)
      threads[i] = std::thread([&, i] {
        for (int turn = 0; turn < 3; ++turn) {
          Walker walker(names[i], i == 1);
          while (walker.go()) {
          }
          out[i] = walker.out;
        }
      });
    for (std::thread& thread : threads) thread.join();
    for (size_t i = 0; i < 2; ++i) CHECK(Numbers::same(out[i], expected[i]));
  }
}
