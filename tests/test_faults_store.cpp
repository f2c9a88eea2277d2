// The whole solver over a store that fails, tears, shortens, swaps, flips and forgets, at its n-th operation, for
// every n: the right error, nothing wrong passed off as right, and a workspace that can be used again.
#include "contact/contact_tape.hpp"
#include "program/commands/families.hpp"
#include "solver/solver.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

using namespace runs;

namespace {

struct Setting {
  const char* deck;
  int32_t panel_columns; // 0: the size below decides
  bool in_core;
  size_t stride; // of n, 1: every operation
};

struct Case {
  Deck deck;
  host::Limits limits;
  uint64_t bytes = 0;
  explicit Case(const Setting& setting) : deck(deck_named(setting.deck)), limits(deck.limits()) {
    limits.panel_columns = setting.panel_columns;
    uint64_t minimum = 0, in_core = 0;
    REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
    bytes = setting.in_core ? in_core : minimum;
  }
};

c2d_port port_of(RamStore& store) {
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  return port;
}

// A run over a store, up to and including c2d_close.
struct Attempt {
  c2d_status status = C2D_OK, closed = C2D_OK;
  int32_t state = 0;
  c2d_error error = C2D_INIT(c2d_error);
  Numbers numbers;
};
Attempt attempt(Machine& machine, const Case& c, RamStore& store) {
  Attempt out;
  const c2d_port port = port_of(store);
  machine.create(c.limits, &port);
  REQUIRE(machine.created == C2D_OK);
  out.status = run_all(machine.solver, c.deck, out.numbers);
  out.state = c2d_get_state(machine.solver);
  out.error = error_of(machine.solver);
  if (out.status != C2D_OK) {
    // Nothing but queries, close and create is legal.
    CHECK(c2d_prepare(machine.solver) == C2D_ERR_STATE);
    CHECK(c2d_run(machine.solver, nullptr, nullptr) == C2D_ERR_STATE);
    CHECK(summary_of(machine.solver).state == C2D_STATE_BROKEN);
  }
  out.closed = c2d_close(machine.solver);
  return out;
}

struct Clean {
  RamStore store;
  Numbers numbers;
};
void run_clean(Machine& machine, const Case& c, Clean& out) {
  const Attempt run = attempt(machine, c, out.store);
  REQUIRE(run.status == C2D_OK);
  REQUIRE(run.closed == C2D_OK);
  out.numbers = run.numbers;
}

c2d_status status_of(char kind) {
  switch (kind) {
  case 'o': return C2D_ERR_STORE_OPEN;
  case 'r': return C2D_ERR_STORE_READ;
  case 'w': return C2D_ERR_STORE_WRITE;
  case 's': return C2D_ERR_STORE_SYNC;
  default: return C2D_ERR_STORE_CLOSE;
  }
}

const Setting kSettings[] = {
    {"plate", 0, false, 13},       // one body, panels of one column: every 13th of its operations
    {"plate", 16, false, 1},       // one body, four panels
    {"hertz_lin_l", 0, true, 1},   // contact, all in core
    {"hertz_lin_l", 40, false, 3}, // contact, three panels: every third
    {"hertz_lin_l", 0, false, 211} // thousands of operations: every 211th
};

// Where the run's number is counted: a failing or spoilt read there means a new store.
bool is_count(const RamStore::Operation& operation) { return operation.kind == 'r' && operation.tape == C2D_TAPE_CONTROL; }

} // namespace

TEST_CASE("store faults: the n-th operation fails, once or from then on") {
  size_t tried = 0, harmless = 0;
  for (const Setting& setting : kSettings) {
    const Case c(setting);
    CAPTURE(std::string(setting.deck));
    CAPTURE(setting.panel_columns);
    Machine machine(c.limits, c.bytes, nullptr);
    Clean clean;
    run_clean(machine, c, clean);
    for (bool for_ever : {false, true}) {
      CAPTURE(for_ever);
      bool reached_end = false;
      for (size_t n = 0; !reached_end; n += setting.stride) {
        CAPTURE(n);
        if (for_ever && n > 20 && n % 5 != 0) continue; // like once: the first failure ends the run
        RamStore store;
        bool hit = false;
        RamStore::Operation failed{};
        store.before = [&](const RamStore::Operation& operation, size_t i) {
          if (i < n || (i > n && !for_ever)) return 0;
          if (i == n) failed = operation;
          hit = true;
          return 1000 + operation.kind;
        };
        const Attempt run = attempt(machine, c, store);
        REQUIRE(machine.guards_are_whole());
        reached_end = !hit;
        ++tried;
        if (!hit || (is_count(failed) && !for_ever)) {
          REQUIRE(run.status == C2D_OK);
          REQUIRE(run.closed == C2D_OK);
          REQUIRE(run.numbers == clean.numbers);
          harmless += hit;
          continue;
        }
        if (failed.kind == 'c') { // the last thing that c2d_close does
          REQUIRE(run.status == C2D_OK);
          REQUIRE(run.closed == C2D_ERR_STORE_CLOSE);
        } else {
          const char kind = is_count(failed) ? 'w' : failed.kind; // the count is written next
          REQUIRE(run.status == status_of(kind));
          REQUIRE(run.state == C2D_STATE_BROKEN);
          REQUIRE(run.error.status == run.status);
          REQUIRE(run.error.host_code == 1000 + kind);
          REQUIRE(run.error.tape == failed.tape);
          if (kind == 'r' || kind == 'w') REQUIRE(run.error.block == static_cast<int64_t>(failed.block));
          REQUIRE(run.closed == (for_ever && n > 0 ? C2D_ERR_STORE_CLOSE : C2D_OK)); // n = 0: nothing was opened
        }
        if (n % 7 == 0) { // the same memory and the same store, mended: the same bits
          store.before = nullptr;
          const Attempt again = attempt(machine, c, store);
          REQUIRE(again.status == C2D_OK);
          REQUIRE(again.numbers == clean.numbers);
        }
      }
    }
  }
  MESSAGE("failing operations tried: " << tried << ", of them without consequence: " << harmless);
  CHECK(tried > 1000);
}

TEST_CASE("store faults: torn writes are found when they are read, and only then") {
  size_t tried = 0, found = 0;
  for (const Setting& setting : kSettings) {
    const Case c(setting);
    CAPTURE(std::string(setting.deck));
    Machine machine(c.limits, c.bytes, nullptr);
    Clean clean;
    run_clean(machine, c, clean);
    const std::vector<RamStore::Operation> plan = clean.store.done;
    std::set<std::pair<int32_t, uint64_t>> later;
    std::vector<bool> is_read(plan.size(), false);
    for (size_t i = plan.size(); i-- > 0;) {
      is_read[i] = later.count({plan[i].tape, plan[i].block}) > 0;
      if (plan[i].kind == 'r') later.insert({plan[i].tape, plan[i].block});
    }
    for (size_t n = 0; n < plan.size(); ++n) {
      if (plan[n].kind != 'w' || (setting.stride > 1 && n % setting.stride > 3)) continue;
      CAPTURE(n);
      for (int how = 0; how < 3; ++how) {
        if (plan.size() > 100 && static_cast<size_t>(how) != n % 3) continue; // in turns, for time
        RamStore store;
        store.keep = [&](const RamStore::Operation& operation, size_t i) -> uint64_t {
          if (i != n) return operation.bytes;
          return how == 0 ? 0 : how == 1 ? 64 + (operation.bytes - 64) / 2 : operation.bytes - 4;
        };
        const Attempt run = attempt(machine, c, store);
        ++tried;
        if (!is_read[n]) {
          REQUIRE(run.status == C2D_OK);
          REQUIRE(run.numbers == clean.numbers);
          continue;
        }
        // Nothing arrived: no block there. A part: torn.
        REQUIRE(run.status == (how == 0 ? C2D_ERR_STORE_FORMAT : C2D_ERR_STORE_SHORT));
        REQUIRE(run.error.tape == plan[n].tape);
        REQUIRE(run.error.block == static_cast<int64_t>(plan[n].block));
        REQUIRE(run.state == C2D_STATE_BROKEN);
        ++found;
      }
    }
  }
  MESSAGE("torn writes tried: " << tried << ", found when read: " << found);
  CHECK(found > 200);
}

TEST_CASE("store faults: spoilt reads are named, never used") {
  size_t tried = 0;
  std::mt19937 random(7);
  for (const Setting& setting : kSettings) {
    const Case c(setting);
    CAPTURE(std::string(setting.deck));
    Machine machine(c.limits, c.bytes, nullptr);
    Clean clean;
    run_clean(machine, c, clean);
    const std::vector<RamStore::Operation> plan = clean.store.done;
    enum Kind { shortened, swapped, flipped_data, flipped_anywhere, stale, never_written, kinds };
    for (size_t n = 0; n < plan.size(); ++n) {
      if (plan[n].kind != 'r' || is_count(plan[n])) continue;
      if (n % setting.stride != 0) continue;
      CAPTURE(n);
      for (int kind = 0; kind < kinds; ++kind) {
        if (plan.size() > 100 && static_cast<size_t>(kind) != n % kinds) continue; // in turns, for time
        CAPTURE(kind);
        RamStore store;
        if (kind == stale) { // the store still holds everything of the run before
          const Attempt before = attempt(machine, c, store);
          REQUIRE(before.status == C2D_OK);
          store.done.clear();
        }
        const std::vector<Bytes> old = store.tape[plan[n].tape];
        bool hit = false;
        store.after_read = [&](const RamStore::Operation& operation, size_t i, unsigned char* data) {
          if (i != n) return;
          const size_t bytes = static_cast<size_t>(operation.bytes), body = bytes - 64;
          hit = true;
          switch (kind) {
          case shortened: std::memset(data + 64 + body / 2, 0, bytes - 64 - body / 2); break;
          case swapped: { // another block that was written on this tape, or the control block
            hit = false;
            for (size_t other = 0; other < store.tape[operation.tape].size() && !hit; ++other) {
              const Bytes& from = store.tape[operation.tape][other];
              if (other == operation.block || std::all_of(from.begin(), from.end(), [](unsigned char b) { return b == 0; }))
                continue;
              std::memcpy(data, from.data(), bytes);
              hit = true;
            }
            break;
          }
          case flipped_data:
            if (body > 8)
              data[64 + random() % (body - 8)] ^= static_cast<unsigned char>(1u << random() % 8);
            else
              hit = false;
            break;
          case flipped_anywhere: data[random() % bytes] ^= static_cast<unsigned char>(1u << random() % 8); break;
          case stale: std::memcpy(data, old[operation.block].data(), bytes); break;
          default: std::memset(data, 0, bytes); break;
          }
        };
        const Attempt run = attempt(machine, c, store);
        if (!hit) {
          REQUIRE(run.status == C2D_OK);
          REQUIRE(run.numbers == clean.numbers);
          continue;
        }
        ++tried;
        switch (kind) {
        case shortened: REQUIRE(run.status == C2D_ERR_STORE_SHORT); break;
        case swapped: REQUIRE(run.status == C2D_ERR_STORE_SWAPPED); break;
        case flipped_data: REQUIRE(run.status == C2D_ERR_STORE_CHECKSUM); break;
        case flipped_anywhere:
          REQUIRE(run.status >= C2D_ERR_STORE_FORMAT);
          REQUIRE(run.status <= C2D_ERR_STORE_CHECKSUM);
          break;
        case stale: REQUIRE(run.status == C2D_ERR_STORE_STALE); break;
        default: REQUIRE(run.status == C2D_ERR_STORE_FORMAT); break;
        }
        REQUIRE(run.state == C2D_STATE_BROKEN);
        REQUIRE(run.error.tape == plan[n].tape);
        REQUIRE(run.error.block == static_cast<int64_t>(plan[n].block));
        REQUIRE(run.error.host_code == 0);
      }
    }
  }
  MESSAGE("spoilt reads tried: " << tried);
  CHECK(tried > 300);
}

TEST_CASE("store faults: bytes and blocks per tape are the store's own counts and the formula's") {
  for (const std::string& name : deck_names())
    for (int32_t forced : {0, -1, 1, 7, 40}) { // 0: minimum, -1: in core
      if (forced == 1 && name == "sample56") continue;
      CAPTURE(name);
      CAPTURE(forced);
      const Case c(Setting{name.c_str(), forced < 0 ? 0 : forced, forced < 0, 1});
      RamStore store;
      const c2d_port port = port_of(store);
      Machine machine(c.limits, c.bytes, &port);
      REQUIRE(machine.created == C2D_OK);
      REQUIRE(read_deck(machine.solver, c.deck) == C2D_OK);
      REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
      const host::Summary prepared = summary_of(machine.solver);
      Numbers numbers;
      REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
      const host::Summary s = summary_of(machine.solver);
      for (int t = 0; t < C2D_TAPES; ++t) {
        CAPTURE(t);
        CHECK(s.tape_blocks[t] == store.blocks[t]);
        CHECK(s.tape_writes[t] == store.writes[t]);
        CHECK(s.tape_bytes_written[t] == store.bytes_written[t]);
        if (t == C2D_TAPE_CONTROL) continue; // what is read of a new store there is no block
        CHECK(s.tape_reads[t] == store.reads[t]);
        CHECK(s.tape_bytes_read[t] == store.bytes_read[t]);
      }
      c2d::TapeUse lower{}, upper{};
      for (int b = 0; b < s.bodies; ++b) {
        const c2d::TapeUse l = c2d::lower_use(c2d::plan_of(machine.solver, b)),
                           u = c2d::upper_use(c2d::plan_of(machine.solver, b));
        lower.blocks += l.blocks, lower.bytes_written += l.bytes_written, lower.bytes_read += l.bytes_read;
        upper.blocks += u.blocks, upper.bytes_written += u.bytes_written, upper.bytes_read += u.bytes_read;
      }
      CHECK(s.tape_blocks[C2D_TAPE_LOWER] == lower.blocks);
      CHECK(s.tape_writes[C2D_TAPE_LOWER] == lower.blocks);
      CHECK(s.tape_bytes_written[C2D_TAPE_LOWER] == lower.bytes_written);
      CHECK(s.tape_bytes_read[C2D_TAPE_LOWER] == lower.bytes_read);
      CHECK(s.tape_blocks[C2D_TAPE_UPPER] == upper.blocks);
      CHECK(s.tape_bytes_written[C2D_TAPE_UPPER] == upper.bytes_written);
      // The work of the one load case, and of its prescribed displacements, costs a pass for each body that has any.
      // Each back substitution reads the tape once. This run needs one.
      CHECK(prepared.tape_bytes_read[C2D_TAPE_UPPER] <= 2 * upper.bytes_read);
      CHECK(s.tape_bytes_read[C2D_TAPE_UPPER] - prepared.tape_bytes_read[C2D_TAPE_UPPER] == upper.bytes_read);
      // Contact, two bodies of which one is solved for and the other keeps its equations and may float: S_u, S_t, s of both, F
      // and v of the former (and room for the latter's v); R, G, E of the latter, with a column per motion; A, T with m
      // columns, h, b with one per case, R, G of the model with one per motion. These have m numbers; g of the latter has 3,
      // mix one per motion.
      const c2d::ModelHeader& head = machine.solver->model;
      const uint64_t m = static_cast<uint64_t>(s.contact_unknowns), cases = static_cast<uint64_t>(head.load_cases),
                     motions = static_cast<uint64_t>(head.motions);
      const uint64_t columns = m > 0 ? 7 * m + 5 * cases + 5 * motions : 0, given = m > 0 && motions > 0 ? cases : 0,
                     mix = m > 0 ? motions : 0;
      CHECK(s.tape_blocks[C2D_TAPE_CONTACT] == (m > 0 ? 7 * m + 3 * cases + 3 * motions + 2 * (3 * cases + 9) : 0));
      CHECK(s.tape_writes[C2D_TAPE_CONTACT] == columns + given + mix);
      CHECK(s.tape_bytes_written[C2D_TAPE_CONTACT] == columns * (64 + 8 * m) + given * (64 + 8 * 3) + mix * (64 + 8 * motions));
      for (const RamStore::Operation& o : store.done)
        if (o.tape == C2D_TAPE_CONTACT && (o.kind == 'r' || o.kind == 'w'))
          CHECK((o.bytes == 64 + 8 * m || o.bytes == 64 + 8 * 3 || o.bytes == 64 + 8 * motions));
      CHECK(s.tape_blocks[C2D_TAPE_CONTROL] == 1);
      CHECK(s.tape_bytes_written[C2D_TAPE_CONTROL] == 72);
    }
}

TEST_CASE("store faults: a control block that cannot be read costs the count, not the answer; a stale tape stays stale") {
  const Case c(Setting{"hertz_lin_l", 40, false, 1});
  Machine machine(c.limits, c.bytes, nullptr);
  Clean clean;
  run_clean(machine, c, clean);
  for (int how = 0; how < 4; ++how) {
    CAPTURE(how);
    RamStore store = clean.store; // what an earlier run left
    store.done.clear();
    Bytes& control = store.tape[C2D_TAPE_CONTROL].at(0);
    if (how == 0) control[70] ^= 4;
    if (how == 1) control.assign(control.size(), 0xFF);
    if (how == 2) control.assign(control.size(), 0);
    if (how == 3) control[10] ^= 1;
    const Attempt run = attempt(machine, c, store);
    CHECK(run.status == C2D_OK);
    CHECK(run.numbers == clean.numbers);
    // Writes that are lost leave the earlier run's blocks: they must not be taken for this run's.
    RamStore forgetful = clean.store;
    forgetful.done.clear();
    if (how == 3) forgetful.tape[C2D_TAPE_CONTROL].at(0)[70] ^= 4;
    forgetful.keep = [](const RamStore::Operation& operation, size_t) -> uint64_t {
      return operation.tape == C2D_TAPE_UPPER ? 0 : operation.bytes;
    };
    CHECK(attempt(machine, c, forgetful).status == C2D_ERR_STORE_STALE);
  }
}

TEST_CASE("store faults: get, begin and advance after the store has died") {
  const Case c(Setting{"hertz_lin_l", 0, false, 1});
  RamStore store;
  const c2d_port port = port_of(store);
  Machine machine(c.limits, c.bytes, &port);
  Numbers clean;
  REQUIRE(run_all(machine.solver, c.deck, clean) == C2D_OK);
  // c2d_begin reads the tableau, c2d_get what it has not kept.
  store.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'r' ? 5 : 0; };
  const double mu = 0.4, load = 0.5;
  CHECK(c2d_begin(machine.solver, &mu, 1) == C2D_ERR_STORE_READ);
  CHECK(c2d_get_state(machine.solver) == C2D_STATE_BROKEN);
  CHECK(error_of(machine.solver).host_code == 5);
  CHECK(c2d_close(machine.solver) == C2D_OK);
  store.before = nullptr;
  machine.create(c.limits, &port);
  REQUIRE(read_deck(machine.solver, c.deck) == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
  c2d_outcome outcome = -1;
  REQUIRE(c2d_advance(machine.solver, &load, 1, &outcome) == C2D_OK);
  store.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'r' ? 6 : 0; };
  double value = 0.0;
  CHECK(c2d_get(machine.solver, C2D_END_UX, 1, 1, 1, &value, 1) == C2D_ERR_STORE_READ);
  CHECK(c2d_get_state(machine.solver) == C2D_STATE_BROKEN);
  CHECK(error_of(machine.solver).host_code == 6);
  CHECK(c2d_get(machine.solver, C2D_TN, 1, 1, 1, &value, 1) == C2D_ERR_STATE);
  store.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'c' ? 9 : 0; };
  CHECK(c2d_close(machine.solver) == C2D_ERR_STORE_CLOSE);
  CHECK(c2d_get_state(machine.solver) == -1);
}

// What a store that has died says to being closed does not matter: it may come back.
TEST_CASE("store faults: a broken solver takes up its saved state, whatever its tapes say when they are closed") {
  const Case c(Setting{"hertz_lin_l", 40, false, 1});
  RamStore store;
  const c2d_port port = port_of(store);
  Machine machine(c.limits, c.bytes, &port);
  const auto prepare = [&] {
    machine.create(c.limits, &port);
    REQUIRE(machine.created == C2D_OK);
    REQUIRE(read_deck(machine.solver, c.deck) == C2D_OK);
    return c2d_prepare(machine.solver);
  };
  const auto advance = [&](double load) {
    std::vector<double> pressures(static_cast<size_t>(summary_of(machine.solver).pairs));
    c2d_outcome outcome = -1;
    REQUIRE(c2d_advance(machine.solver, &load, 1, &outcome) == C2D_OK);
    REQUIRE(c2d_get(machine.solver, C2D_TN, 0, 1, static_cast<int32_t>(pressures.size()), pressures.data(), 1) == C2D_OK);
    return pressures;
  };
  const auto fail = [&store](char kind, int code) {
    store.before = [=](const RamStore::Operation& operation, size_t) { return operation.kind == kind ? code : 0; };
  };
  const double mu = 0.4;
  REQUIRE(prepare() == C2D_OK);
  REQUIRE(c2d_begin(machine.solver, &mu, 1) == C2D_OK);
  advance(0.5);
  REQUIRE(c2d_save(machine.solver) == C2D_OK);
  const std::vector<double> expected = advance(1.0);
  double value = 0.0;
  fail('r', 6);
  REQUIRE(c2d_get(machine.solver, C2D_END_UX, 1, 1, 1, &value, 1) == C2D_ERR_STORE_READ);
  REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_BROKEN);
  fail('c', 9);
  REQUIRE(c2d_restore(machine.solver) == C2D_OK);
  CHECK(advance(1.0) == expected);
  store.before = nullptr;
  REQUIRE(c2d_close(machine.solver) == C2D_OK);
  // Broken before it had room for a state: the one that is there is taken up, or what is wrong with its tapes is told.
  fail('w', 7);
  REQUIRE(prepare() == C2D_ERR_STORE_WRITE);
  fail('c', 9);
  const c2d_status status = c2d_restore(machine.solver);
  CHECK(status != C2D_ERR_STORE_CLOSE);
  if (status == C2D_OK) CHECK(advance(1.0) == expected);
  store.before = nullptr;
}

// Small bodies are prepared side by side where there are threads; the functions of the port are asked meanwhile.
TEST_CASE("store faults: several bodies at once: cancelled anywhere, and with a store that cannot be closed") {
  Deck deck;
  std::string text, error;
  REQUIRE(families::make_deck("stack", {}, text, error));
  std::istringstream file(text);
  for (std::string line; std::getline(file, line);) deck.lines.push_back(line);
  const host::Limits limits = deck.limits();
  uint64_t in_core = 0;
  REQUIRE(c2d_memory_need(&limits, nullptr, &in_core, nullptr) == C2D_OK);
  in_core += 1 << 24; // for what each thread computes
  struct Port : RamStore {
    int64_t asked = 0, cancelled_at = -1;
  } store;
  c2d_port port = port_of(store);
  Machine alone(limits, in_core, &port);
  Numbers clean, numbers;
  REQUIRE(run_all(alone.solver, deck, clean) == C2D_OK);
  port.threads = 2;
  port.parallel_for = [](void*, int32_t n, void (*task)(void*, int32_t), void* argument) {
    for (int32_t i = n; i-- > 0;) task(argument, i);
  };
  port.cancel = [](void* context) {
    Port& p = static_cast<Port&>(RamStore::self(context));
    return int32_t{p.asked++ == p.cancelled_at};
  };
  Machine machine(limits, in_core, &port);
  c2d_options options = C2D_INIT(c2d_options);
  options.keep_factors = 1;
  REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
  REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
  int64_t tried = 0;
  for (bool closes : {true, false}) {
    store.before = [closes](const RamStore::Operation& o, size_t) { return o.kind == 'c' && !closes ? 8 : 0; };
    for (int64_t n = 0;; ++n, ++tried) {
      store.asked = 0, store.cancelled_at = n;
      const c2d_status status = c2d_prepare(machine.solver);
      if (status == C2D_OK) break;
      if (closes) {
        REQUIRE(status == C2D_ERR_CANCELLED);
        REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_MODEL);
        continue;
      }
      store.before = nullptr;
      CHECK((status == C2D_ERR_STORE_CLOSE || status == C2D_ERR_CANCELLED)); // the first one before anything was opened
      if (status == C2D_ERR_CANCELLED) continue;
      CHECK(c2d_get_state(machine.solver) == C2D_STATE_BROKEN);
      return;
    }
    CHECK(tried > 2);
    store.cancelled_at = -1;
    REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
    CHECK(numbers == clean);
    REQUIRE(c2d_change_loads(machine.solver) == C2D_OK);
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK); // with the factors that were kept
    REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
    REQUIRE(numbers.steps.size() == clean.steps.size());
    for (size_t i = 0; i < clean.steps.size(); ++i) CHECK(std::fabs(numbers.steps[i] - clean.steps[i]) < 1e-9);
    REQUIRE(c2d_close(machine.solver) == C2D_OK);
    machine.create(limits, &port);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
  }
}
