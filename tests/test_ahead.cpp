// Transfers that are on their way while the solver works: the same numbers, bytes and errors as without, and none that
// outlives the call that began it.
#include "c2d_posix.h"
#include "elimination/eliminate.hpp"
#include "solver/solver.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <deque>
#include <random>
#include <unistd.h>

using namespace runs;

namespace {

// A RamStore whose transfers happen as late as the rules allow: when they are waited for, in the order of their start.
// Until then a buffer to be read into holds nonsense, and one to be written must not change.
struct LateStore {
  struct Pending {
    int32_t ticket;
    bool writes;
    int32_t tape;
    uint64_t block, bytes;
    unsigned char* data;
    Bytes seen;
    bool happened;
    int32_t code;
  };
  RamStore ram;
  std::deque<Pending> pending;
  size_t starts = 0, waits = 0, most = 0, spoilt = 0, unknown = 0, refuse_at = SIZE_MAX;
  test::Callable<void()> inside;

  static LateStore& self(void* context) { return *static_cast<LateStore*>(context); }
  int32_t start(bool writes, int32_t tape, uint64_t block, unsigned char* data, uint64_t bytes, int32_t* ticket) {
    if (inside) inside();
    if (starts++ == refuse_at) return 2000;
    if (!writes) std::memset(data, 0xEE, bytes);
    *ticket = static_cast<int32_t>(7 * starts);
    pending.push_back({*ticket, writes, tape, block, bytes, data, Bytes(data, data + bytes), false, 0});
    most = std::max(most, pending.size());
    return 0;
  }
  void happen(Pending& p) {
    if (p.happened) return;
    spoilt += !std::equal(p.seen.begin(), p.seen.end(), p.data);
    p.code = p.writes ? RamStore::write(&ram, p.tape, p.block, p.data, p.bytes)
                      : RamStore::read(&ram, p.tape, p.block, p.data, p.bytes);
    if (!p.writes && p.code == 0) p.seen.assign(p.data, p.data + p.bytes);
    p.happened = true;
  }
  int32_t wait(int32_t ticket) {
    if (inside) inside();
    ++waits;
    for (size_t i = 0; i < pending.size(); ++i) {
      happen(pending[i]);
      if (pending[i].ticket != ticket) continue;
      const int32_t code = pending[i].code;
      pending.erase(pending.begin() + static_cast<long>(i));
      return code;
    }
    ++unknown;
    return 3000;
  }
  void serve(c2d_port& port) {
    ram.serve(port);
    port.context = this;
    port.open = [](void* c, int32_t t, uint64_t n, uint64_t b) { return RamStore::open(&self(c).ram, t, n, b); };
    port.read = [](void* c, int32_t t, uint64_t k, void* d, uint64_t n) { return RamStore::read(&self(c).ram, t, k, d, n); };
    port.write = [](void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
      return RamStore::write(&self(c).ram, t, k, d, n);
    };
    port.sync = [](void* c, int32_t t) { return RamStore::sync(&self(c).ram, t); };
    port.close = [](void* c, int32_t t) { return RamStore::close(&self(c).ram, t); };
    port.start_read = [](void* c, int32_t t, uint64_t k, void* d, uint64_t n, int32_t* ticket) {
      return self(c).start(false, t, k, static_cast<unsigned char*>(d), n, ticket);
    };
    port.start_write = [](void* c, int32_t t, uint64_t k, const void* d, uint64_t n, int32_t* ticket) {
      return self(c).start(true, t, k, static_cast<unsigned char*>(const_cast<void*>(d)), n, ticket);
    };
    port.wait = [](void* c, int32_t ticket) { return self(c).wait(ticket); };
  }
  // The rules were kept, and nothing is left.
  bool at_rest() const { return pending.empty() && spoilt == 0 && unknown == 0 && most <= c2d::kMostTransfers; }
};

// ---- elimination ----------------------------------------------------------------------------------------------------

using c2d::Real;

// A streamed elimination of a random matrix, and back substitution, over any port.
struct Streamed {
  c2d::EliminationPlan plan;
  std::vector<Real> a, s, x;
  c2d::Tapes tapes;
  int32_t told = 0, refuse_at = -1;

  explicit Streamed(int32_t strip_rows = 0) : plan(), tapes() {
    const int32_t rows = 180, pivots = 150, trailing = 70;
    // What streaming in a third of the memory comes to, and memory to read ahead.
    const uint64_t bytes = c2d::elimination_bytes_in_core(rows, pivots, trailing) * 2 / 3;
    REQUIRE(c2d::plan_elimination(bytes, rows, pivots, trailing, 90, plan, nullptr) == C2D_OK);
    REQUIRE(c2d::block_buffers(plan) == 2);
    if (strip_rows > 0) plan.block_rows = strip_rows;
    plan.keep_lower = 1;
    std::mt19937 random(5);
    a.resize(static_cast<size_t>(rows * (pivots + trailing)));
    for (Real& v : a) v = static_cast<Real>(static_cast<double>(random()) / 4294967296.0 - 0.5);
    s.assign(static_cast<size_t>((rows - pivots) * trailing), Real(0));
    tapes.run_id = 99;
  }
  static c2d_status fill(void* context, int32_t first, int32_t count, Real* panel, int64_t ld) {
    const Streamed& m = *static_cast<Streamed*>(context);
    for (int32_t j = 0; j < count; ++j)
      std::memcpy(panel + j * ld, m.a.data() + static_cast<size_t>((first + j) * m.plan.rows),
                  static_cast<size_t>(m.plan.rows) * sizeof(Real));
    return C2D_OK;
  }
  static c2d_status take(void* context, int32_t first, int32_t count, const Real* values, int64_t ld) {
    Streamed& m = *static_cast<Streamed*>(context);
    const int32_t rest = m.plan.rows - m.plan.pivots;
    for (int32_t j = 0; j < count; ++j)
      std::memcpy(m.s.data() + static_cast<size_t>((first + j) * rest), values + j * ld,
                  static_cast<size_t>(rest) * sizeof(Real));
    return C2D_OK;
  }
  static c2d_status step(void* context, int32_t) {
    Streamed& m = *static_cast<Streamed*>(context);
    return m.told++ == m.refuse_at ? C2D_ERR_CANCELLED : C2D_OK;
  }
  c2d_status open(const c2d_port* port) {
    const c2d::TapeUse lower = c2d::lower_use(plan), upper = c2d::upper_use(plan);
    tapes.port = port;
    const c2d_status status = c2d::open_tape(tapes, C2D_TAPE_LOWER, lower.blocks, lower.max_data_bytes);
    return status == C2D_OK ? c2d::open_tape(tapes, C2D_TAPE_UPPER, upper.blocks, upper.max_data_bytes) : status;
  }
  // Everything that transfers blocks: elimination, again with the same trailing columns, back substitution, its adjoint.
  c2d_status run() {
    told = 0;
    std::vector<Real> w(static_cast<size_t>(plan.trailing)), f(static_cast<size_t>(plan.pivots), Real(0.5));
    std::vector<Real> c(static_cast<size_t>(plan.trailing), Real(1));
    x.assign(static_cast<size_t>(plan.pivots), Real(0));
    const uint64_t bytes = std::max(c2d::elimination_bytes(plan), c2d::back_substitution_bytes(plan));
    Bytes room(static_cast<size_t>(bytes) + 64);
    unsigned char* work = room.data() + (64 - reinterpret_cast<uintptr_t>(room.data()) % 64) % 64;
    const c2d::ColumnSource source{this, fill};
    const c2d::RowSink sink{this, take};
    c2d_status status = c2d::eliminate(plan, source, sink, tapes, work, nullptr, {this, step});
    if (status == C2D_OK) status = c2d::eliminate_again(plan, 3, source, sink, tapes, work, {this, step});
    if (status == C2D_OK) status = c2d::back_substitute(plan, tapes, c.data(), x.data(), work);
    if (status == C2D_OK) status = c2d::transposed_functional(plan, tapes, f.data(), w.data(), work);
    x.insert(x.end(), s.begin(), s.end());
    x.insert(x.end(), w.begin(), w.end());
    return status;
  }
};

c2d_port port_of(LateStore& late) {
  c2d_port port = C2D_INIT(c2d_port);
  late.serve(port);
  return port;
}

} // namespace

TEST_CASE("ahead: the same bits and the same bytes as block by block") {
  for (int32_t strip_rows : {0, 64, 75}) {
    CAPTURE(strip_rows);
    RamStore ram;
    LateStore late;
    c2d_port plain = C2D_INIT(c2d_port);
    ram.serve(plain);
    const c2d_port port = port_of(late);
    Streamed one(strip_rows), other(strip_rows);
    REQUIRE(one.open(&plain) == C2D_OK);
    REQUIRE(other.open(&port) == C2D_OK);
    REQUIRE(one.run() == C2D_OK);
    REQUIRE(other.run() == C2D_OK);
    CHECK(one.x == other.x);
    CHECK(late.at_rest());
    CHECK(late.most == 2);
    CHECK(late.starts == late.waits);
    for (int32_t t = 0; t < C2D_TAPES; ++t) {
      CAPTURE(t);
      CHECK(ram.tape[t] == late.ram.tape[t]);
      CHECK(one.tapes.reads[t] == other.tapes.reads[t]);
      CHECK(one.tapes.writes[t] == other.tapes.writes[t]);
      CHECK(one.tapes.bytes_read[t] == other.tapes.bytes_read[t]);
      CHECK(one.tapes.bytes_written[t] == other.tapes.bytes_written[t]);
      CHECK(late.ram.bytes_read[t] == other.tapes.bytes_read[t]);
      CHECK(late.ram.bytes_written[t] == other.tapes.bytes_written[t]);
    }
    // Two of the three are as good as none.
    for (int32_t which = 0; which < 3; ++which) {
      LateStore unused;
      c2d_port some = port_of(unused);
      if (which == 0) some.start_read = nullptr;
      if (which == 1) some.start_write = nullptr;
      if (which == 2) some.wait = nullptr;
      Streamed third(strip_rows);
      REQUIRE(third.open(&some) == C2D_OK);
      REQUIRE(third.run() == C2D_OK);
      CHECK(third.x == one.x);
      CHECK(unused.starts + unused.waits == 0);
    }
  }
}

TEST_CASE("ahead: the n-th transfer fails on its way or is refused, for every n; nothing is left behind") {
  for (bool refused : {false, true}) {
    CAPTURE(refused);
    size_t n = 0;
    for (bool done = false; !done; ++n) {
      CAPTURE(n);
      LateStore late;
      const c2d_port port = port_of(late);
      Streamed job;
      REQUIRE(job.open(&port) == C2D_OK);
      int32_t busy = 0;
      job.tapes.busy = &busy;
      size_t not_busy = 0;
      late.inside = [&] { not_busy += busy == 0; };
      const size_t opened = late.ram.done.size();
      bool hit = false;
      char kind = 'w';
      if (refused) {
        late.refuse_at = n;
      } else {
        late.ram.before = [&](const RamStore::Operation& operation, size_t i) {
          if (i != opened + n) return 0;
          hit = true;
          kind = operation.kind;
          return 2000;
        };
      }
      const c2d_status status = job.run();
      if (refused) hit = late.starts > n;
      done = !hit;
      REQUIRE(late.at_rest());
      REQUIRE(not_busy == 0);
      REQUIRE(busy == 0);
      if (done) {
        REQUIRE(status == C2D_OK);
        continue;
      }
      if (refused)
        REQUIRE((status == C2D_ERR_STORE_WRITE || status == C2D_ERR_STORE_READ));
      else
        REQUIRE(status == (kind == 'r' ? C2D_ERR_STORE_READ : C2D_ERR_STORE_WRITE));
      REQUIRE(job.tapes.error.status == status);
      REQUIRE(job.tapes.error.host_code == 2000);
      if (n % 5 != 0) continue;
      late.refuse_at = SIZE_MAX;
      late.ram.before = nullptr;
      Streamed clean;
      RamStore ram;
      c2d_port plain = C2D_INIT(c2d_port);
      ram.serve(plain);
      REQUIRE(clean.open(&plain) == C2D_OK);
      REQUIRE(clean.run() == C2D_OK);
      REQUIRE(job.run() == C2D_OK);
      REQUIRE(job.x == clean.x);
      REQUIRE(late.at_rest());
    }
    CHECK(n > 20);
  }
}

TEST_CASE("ahead: stopped at any moment, and with any block spoilt, every transfer has been waited for") {
  int32_t n = 0;
  for (bool done = false; !done; n += 7) {
    LateStore late;
    const c2d_port port = port_of(late);
    Streamed job;
    REQUIRE(job.open(&port) == C2D_OK);
    job.refuse_at = n;
    const c2d_status status = job.run();
    done = job.told <= n;
    REQUIRE(status == (done ? C2D_OK : C2D_ERR_CANCELLED));
    REQUIRE(late.at_rest());
    REQUIRE(late.starts == late.waits);
  }
  CHECK(n > 100);
  size_t i = 0, spoilt = 0;
  for (bool done = false; !done; ++i) {
    LateStore late;
    const c2d_port port = port_of(late);
    Streamed job;
    REQUIRE(job.open(&port) == C2D_OK);
    bool hit = false;
    late.ram.after_read = [&](const RamStore::Operation& operation, size_t at, unsigned char* data) {
      if (at < i || hit) return;
      hit = true;
      i = at;
      data[operation.bytes / 2] ^= 16;
    };
    const c2d_status status = job.run();
    done = !hit;
    spoilt += hit;
    REQUIRE(status == (done ? C2D_OK : C2D_ERR_STORE_CHECKSUM));
    REQUIRE(late.at_rest());
  }
  CHECK(spoilt > 10);
}

// ---- the whole solver -----------------------------------------------------------------------------------------------

namespace {

struct Job {
  Deck deck = deck_named("hertz_lin_l");
  host::Limits limits = deck.limits();
  uint64_t bytes = 0;
  Job() {
    limits.panel_columns = 45;
    uint64_t minimum = 0;
    REQUIRE(c2d_memory_need(&limits, &minimum, &bytes, nullptr) == C2D_OK);
  }
  // Block by block.
  Numbers numbers() const {
    RamStore ram;
    c2d_port plain = C2D_INIT(c2d_port);
    ram.serve(plain);
    Machine machine(limits, bytes, &plain);
    Numbers out;
    REQUIRE(run_all(machine.solver, deck, out) == C2D_OK);
    REQUIRE(c2d_close(machine.solver) == C2D_OK);
    return out;
  }
};

} // namespace

TEST_CASE("ahead: the whole solver; callbacks find it busy; it may be moved in between") {
  const Job job;
  LateStore late;
  const c2d_port port = port_of(late);
  Machine machine(job.limits, job.bytes, &port);
  size_t let_in = 0;
  late.inside = [&] { let_in += c2d_prepare(machine.solver) != C2D_ERR_BUSY; };
  REQUIRE(read_deck(machine.solver, job.deck) == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  REQUIRE(late.starts > 20);
  REQUIRE(late.at_rest());
  Bytes image = machine.workspace(); // its start keeps its distance from a multiple of 64 or not: any will do
  c2d_solver* moved = nullptr;
  REQUIRE(c2d_attach(&moved, image.data(), image.size(), &port, nullptr) == C2D_OK);
  late.inside = nullptr;
  Numbers found;
  REQUIRE(run_prepared(moved, found) == C2D_OK);
  CHECK(found == job.numbers());
  CHECK(let_in == 0);
  CHECK(c2d_close(moved) == C2D_OK);
  CHECK(late.at_rest());
  c2d_close(machine.solver);
}

TEST_CASE("ahead: the whole solver, its n-th transfer failing") {
  const Job job;
  const Numbers expected = job.numbers();
  Machine machine(job.limits, job.bytes, nullptr);
  Numbers found;
  size_t tried = 0;
  bool done = false;
  for (size_t n = 0; !done; n += 5) {
    LateStore late;
    bool hit = false;
    char kind = 0;
    late.ram.before = [&](const RamStore::Operation& operation, size_t i) {
      if (i != n || operation.kind == 'o' || operation.kind == 'c' || operation.tape == C2D_TAPE_CONTROL) return 0;
      hit = true;
      kind = operation.kind;
      return 1234;
    };
    const c2d_port port = port_of(late);
    machine.create(job.limits, &port);
    const c2d_status status = run_all(machine.solver, job.deck, found);
    REQUIRE(late.at_rest());
    REQUIRE(machine.guards_are_whole());
    done = n > late.ram.done.size();
    if (hit) {
      ++tried;
      REQUIRE(status == (kind == 'r' ? C2D_ERR_STORE_READ : kind == 'w' ? C2D_ERR_STORE_WRITE : C2D_ERR_STORE_SYNC));
      REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_BROKEN);
      REQUIRE(error_of(machine.solver).host_code == 1234);
    } else {
      REQUIRE(status == C2D_OK);
      REQUIRE(found == expected);
    }
    c2d_close(machine.solver);
    REQUIRE(late.at_rest());
  }
  CHECK(tried > 50);
}

TEST_CASE("ahead: cancelled with transfers on their way, the solver is unprepared and can start anew") {
  const Job job;
  LateStore late;
  c2d_port port = port_of(late);
  Machine machine(job.limits, job.bytes, &port);
  REQUIRE(read_deck(machine.solver, job.deck) == C2D_OK);
  Numbers first, again;
  size_t cancelled = 0, under_way = 0;
  for (size_t at : {1u, 4u, 9u, 14u, 19u, 100000u}) {
    const size_t starts = late.starts;
    bool told = false;
    late.inside = [&] {
      if (told || late.starts < starts + at) return;
      told = true;
      under_way += !late.pending.empty();
      c2d_cancel(machine.solver);
    };
    const c2d_status status = c2d_prepare(machine.solver);
    REQUIRE(late.at_rest());
    REQUIRE(status == (told ? C2D_ERR_CANCELLED : C2D_OK));
    cancelled += told;
    if (told) CHECK(c2d_get_state(machine.solver) == C2D_STATE_MODEL);
  }
  late.inside = nullptr;
  CHECK(cancelled >= 2);
  CHECK(under_way >= 1);
  REQUIRE(run_prepared(machine.solver, again) == C2D_OK);
  RamStore ram;
  c2d_port plain = C2D_INIT(c2d_port);
  ram.serve(plain);
  Machine other(job.limits, job.bytes, &plain);
  REQUIRE(run_all(other.solver, job.deck, first) == C2D_OK);
  CHECK(first == again);
}

// ---- port/posix -----------------------------------------------------------------------------------------------------

namespace {

struct Folder {
  char name[40] = "/tmp/contact2d_ahead_XXXXXX";
  c2d_posix_store store;
  c2d_port port = C2D_INIT(c2d_port);
  Folder() {
    REQUIRE(mkdtemp(name) != nullptr);
    REQUIRE(c2d_posix_store_init(&store, name) == 0);
    c2d_posix_store_port(&store, &port);
  }
  ~Folder() { c2d_posix_store_discard(&store, name); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

} // namespace

TEST_CASE("port/posix: a plain read or write comes after what was begun with the block, not before") {
  Folder folder;
  const c2d_port& p = folder.port;
  void* c = p.context;
  const uint64_t size = 1 << 22; // no helper is done with it at once
  REQUIRE(p.open(c, 1, 2, size) == 0);
  Bytes begun(size), plain(size), in(size), later(size);
  for (int turn = 0; turn < 20; ++turn) {
    std::fill(begun.begin(), begun.end(), static_cast<unsigned char>(2 * turn + 1));
    std::fill(plain.begin(), plain.end(), static_cast<unsigned char>(2 * turn + 2));
    int32_t ticket = 0;
    REQUIRE(p.start_write(c, 1, 0, begun.data(), size, &ticket) == 0);
    REQUIRE(p.read(c, 1, 0, in.data(), size) == 0);
    CHECK(in == begun);
    REQUIRE(p.wait(c, ticket) == 0);
    REQUIRE(p.start_write(c, 1, 0, begun.data(), size, &ticket) == 0);
    REQUIRE(p.write(c, 1, 0, plain.data(), size) == 0);
    REQUIRE(p.wait(c, ticket) == 0);
    REQUIRE(p.start_read(c, 1, 0, later.data(), size, &ticket) == 0);
    REQUIRE(p.write(c, 1, 0, begun.data(), size) == 0);
    REQUIRE(p.wait(c, ticket) == 0);
    CHECK(later == plain);
  }
  CHECK(p.close(c, 1) == 0);
}

TEST_CASE("port/posix: four transfers at once, waited for in any order, also beyond 4 GiB") {
  Folder folder;
  const c2d_port& p = folder.port;
  void* c = p.context;
  const uint64_t size = 1 << 20, far = 5000; // 5 GB; the file has holes
  REQUIRE(p.open(c, 1, far + 10, size) == 0);
  std::vector<Bytes> out(4, Bytes(size)), in(4, Bytes(size, 0xEE));
  int32_t ticket[4] = {}, other = 0;
  for (int turn = 0; turn < 20; ++turn) {
    for (size_t i = 0; i < 4; ++i) {
      std::fill(out[i].begin(), out[i].end(), static_cast<unsigned char>(turn * 4 + static_cast<int>(i)));
      REQUIRE(p.start_write(c, 1, i % 2 == 0 ? i : far + i, out[i].data(), size, &ticket[i]) == 0);
    }
    CHECK(p.start_read(c, 1, 0, in[0].data(), size, &other) == C2D_POSIX_STORE_TICKET);
    // Two make room, and reads of blocks whose writing was not waited for see what was written.
    REQUIRE(p.wait(c, ticket[2]) == 0);
    REQUIRE(p.wait(c, ticket[1]) == 0);
    REQUIRE(p.start_read(c, 1, far + 3, in[3].data(), size, &ticket[1]) == 0);
    REQUIRE(p.start_read(c, 1, 0, in[0].data(), size, &ticket[2]) == 0);
    for (size_t i : {2u, 3u, 1u, 0u}) REQUIRE(p.wait(c, ticket[i]) == 0);
    CHECK(in[3] == out[3]);
    CHECK(in[0] == out[0]);
  }
  CHECK(p.wait(c, ticket[0]) == C2D_POSIX_STORE_TICKET); // waited for already
  CHECK(p.wait(c, 17) == C2D_POSIX_STORE_TICKET);
  // What went wrong is told by wait: a block beyond the end, a tape that is not open, a block never written.
  const int32_t codes[3] = {C2D_POSIX_STORE_RANGE, C2D_POSIX_STORE_TAPE, C2D_POSIX_STORE_END};
  const int32_t tapes[3] = {1, 2, 1};
  const uint64_t blocks[3] = {far + 10, 0, far + 9};
  for (int i = 0; i < 3; ++i) REQUIRE(p.start_read(c, tapes[i], blocks[i], in[0].data(), size, &ticket[i]) == 0);
  for (int i = 0; i < 3; ++i) CHECK(p.wait(c, ticket[i]) == codes[i]);
  // The thread ends with the last tape, and another comes when it is wanted.
  REQUIRE(p.close(c, 1) == 0);
  CHECK(folder.store.helper == nullptr);
  REQUIRE(p.open(c, 1, far + 10, size) == 0);
  REQUIRE(p.start_read(c, 1, far + 1, in[0].data(), size, &other) == 0);
  REQUIRE(p.wait(c, other) == 0);
  CHECK(in[0] == out[1]);
}

TEST_CASE("port/posix: eliminating with the store's thread gives the bits that blocks in turn give") {
  Folder folder;
  Streamed one, other;
  RamStore ram;
  c2d_port plain = C2D_INIT(c2d_port);
  ram.serve(plain);
  REQUIRE(one.open(&plain) == C2D_OK);
  REQUIRE(one.run() == C2D_OK);
  REQUIRE(other.open(&folder.port) == C2D_OK);
  for (int turn = 0; turn < 5; ++turn) {
    REQUIRE(other.run() == C2D_OK);
    CHECK(other.x == one.x);
  }
  CHECK(c2d::close_all(other.tapes) == C2D_OK);
}
