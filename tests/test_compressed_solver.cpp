// Compressed elimination through the C interface and the program: the answers of the dense one, in known memory and on known
// tapes, saved, moved, failing and cut off like those.
#include "contact2d_memory.h"
#include "effort.hpp"
#include "many_bodies.hpp"
#include "memory/config.hpp"
#include "program/commands/families.hpp"
#include "shell.hpp"
#include "solver/phases.hpp"
#include "solver/solver.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <sys/stat.h>

using namespace runs;

namespace {

const bool kIsDouble = C2D_REAL_BYTES == 8;

Deck deck_of_family(const std::string& name, const std::vector<std::string>& settings) {
  std::string text, error;
  REQUIRE_MESSAGE(families::make_deck(name, settings, text, error), error);
  Deck deck;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  return deck;
}

Deck deck_at(const std::string& file) { // or of the family behind "make "
  if (file.compare(0, 5, "make ") == 0) return deck_of_family(file.substr(5), {});
  Deck deck;
  std::ifstream in(paths::root() + "/" + file);
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  return deck;
}

c2d_options compressed() {
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = C2D_ELIMINATION_COMPRESSED;
  return options;
}

uint64_t minimum_of(const c2d_limits& limits) {
  uint64_t minimum = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK);
  return minimum;
}
uint64_t enough_for(const c2d_limits& limits) { return 2 * minimum_of(limits) + (uint64_t{32} << 20); }

// A solver in memory of its own, with a store and what it told.
struct Own {
  RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  std::unique_ptr<Machine> machine;
  std::vector<c2d_error> told;
  RamStore* shared = nullptr; // the store of another one
  int chances = -1;           // at how many more the run is not cancelled; below 0: at none
  explicit Own(const c2d_limits& limits, uint64_t bytes, RamStore* with = nullptr) : shared(with) {
    port.context = this;
    port.open = [](void* c, int32_t t, uint64_t n, uint64_t bytes_each) { return RamStore::open(&at(c), t, n, bytes_each); };
    port.read = [](void* c, int32_t t, uint64_t k, void* data, uint64_t n) { return RamStore::read(&at(c), t, k, data, n); };
    port.write = [](void* c, int32_t t, uint64_t k, const void* data, uint64_t n) {
      return RamStore::write(&at(c), t, k, data, n);
    };
    port.sync = [](void* c, int32_t t) { return RamStore::sync(&at(c), t); };
    port.close = [](void* c, int32_t t) { return RamStore::close(&at(c), t); };
    port.log = [](void* c, const c2d_error* entry) { static_cast<Own*>(c)->told.push_back(*entry); };
    port.cancel = [](void* c) { return static_cast<Own*>(c)->chances-- == 0 ? 1 : 0; };
    machine = std::make_unique<Machine>(limits, bytes, &port, 0);
    REQUIRE(machine->created == C2D_OK);
  }
  static RamStore& at(void* context) {
    Own& own = *static_cast<Own*>(context);
    return own.shared != nullptr ? *own.shared : own.store;
  }
  c2d_solver* solver() const { return machine->solver; }
  bool told_of(int32_t number) const {
    return std::any_of(told.begin(), told.end(), [&](const c2d_error& e) { return e.status == number; });
  }
};

struct Answer {
  Numbers numbers;
  host::Summary summary;
  std::string warning; // of compressed elimination
};

Answer answer_of(const Deck& deck, const c2d_options& options, uint64_t more = 0) {
  const host::Limits limits = deck.limits();
  Own own(limits, enough_for(limits) + more);
  Answer out;
  const c2d_status status = run_all(own.solver(), deck, out.numbers, &options);
  REQUIRE_MESSAGE(status == C2D_OK, error_of(own.solver()).text);
  CHECK(own.machine->guards_are_whole());
  out.summary = summary_of(own.solver());
  for (const c2d_error& e : own.told)
    if (e.status == C2D_WARN_COMPRESSED) out.warning += e.text;
  return out;
}

// Pressures and friction over the largest pressure, displacements, gaps and slips over the largest of these; of the boundary
// tractions and displacements alike. Statuses must be the same.
struct Difference {
  double tractions = 0, lengths = 0;
};
void take(const std::vector<double>& a, const std::vector<double>& b, const std::vector<size_t>& at, double& most) {
  double size = 0, apart = 0;
  for (size_t i : at) size = std::max(size, std::fabs(a[i])), apart = std::max(apart, std::fabs(a[i] - b[i]));
  if (size > 0) most = std::max(most, apart / size);
}
Difference compare(const Answer& a, const Answer& b) {
  Difference out;
  REQUIRE(a.numbers.outcome == b.numbers.outcome);
  REQUIRE(a.numbers.steps.size() == b.numbers.steps.size());
  REQUIRE(a.numbers.boundary.size() == b.numbers.boundary.size());
  const size_t pairs = static_cast<size_t>(a.summary.pairs), step = 1 + pairs * C2D_PAIR_FIELDS;
  std::vector<size_t> tractions, lengths;
  for (size_t s = 0; s < a.numbers.steps.size(); s += step)
    for (size_t p = 0; p < pairs; ++p) {
      const size_t row = s + 1 + p * C2D_PAIR_FIELDS;
      CHECK(a.numbers.steps[row + C2D_STATUS] == b.numbers.steps[row + C2D_STATUS]);
      for (int32_t c : {C2D_TN, C2D_TT}) tractions.push_back(row + static_cast<size_t>(c));
      for (int32_t c : {C2D_UN1, C2D_UN2, C2D_UT1, C2D_UT2, C2D_GAP}) lengths.push_back(row + static_cast<size_t>(c));
    }
  take(a.numbers.steps, b.numbers.steps, tractions, out.tractions);
  take(a.numbers.steps, b.numbers.steps, lengths, out.lengths);
  size_t at = 0;
  tractions.clear(), lengths.clear();
  for (int32_t body = 1; body <= a.summary.bodies; ++body) {
    const size_t ends = static_cast<size_t>(a.summary.body[static_cast<size_t>(body) - 1].elements * a.summary.function_nodes);
    for (int32_t field = C2D_END_X; field <= C2D_END_STATUS; ++field, at += ends)
      for (size_t k = 0; k < ends; ++k) {
        if (field == C2D_END_UX || field == C2D_END_UY) lengths.push_back(at + k);
        if (field == C2D_END_TX || field == C2D_END_TY) tractions.push_back(at + k);
      }
  }
  take(a.numbers.boundary, b.numbers.boundary, tractions, out.tractions);
  take(a.numbers.boundary, b.numbers.boundary, lengths, out.lengths);
  return out;
}

} // namespace

TEST_CASE("compressed solver: decks of every kind as by the dense elimination" * doctest::skip(c2d::kSmallCode)) {
  const double limit = kIsDouble ? 1e-9 : 5e-3;
  std::vector<std::string> files;
  for (const std::string& name : deck_names()) files.push_back("tests/data/decks/" + name + ".dat");
  for (const char* name :
       {"hole", "ring", "bearing", "bimaterial", "coating", "cylinder_friction", "crack", "rollers", "cantilever", "stack"})
    files.push_back(std::string("make ") + name);
  for (const char* name : {"three_bodies", "thick_ring", "roller"}) files.push_back(std::string("examples/") + name + ".dat");
  files.push_back(files[8] + " by the thesis"); // its quadrature
  for (std::string file : files) {
    CAPTURE(file);
    c2d_options options = C2D_INIT(c2d_options);
    const size_t thesis = file.find(" by the thesis");
    if (thesis != std::string::npos) options.quadrature = C2D_QUADRATURE_THESIS, file.resize(thesis);
    const Deck deck = deck_at(file);
    options.symmetry = file.find("half_cylinder") != std::string::npos ? C2D_SYMMETRY_IMAGES : C2D_SYMMETRY_DECK;
    const Answer dense = answer_of(deck, options);
    options.elimination = C2D_ELIMINATION_COMPRESSED;
    const Answer own = answer_of(deck, options);
    CHECK(dense.summary.compressed_bodies == 0);
    CHECK(own.summary.compressed_bodies > 0);
    const Difference apart = compare(dense, own);
    CHECK(apart.tractions < limit);
    CHECK(apart.lengths < limit);
    CHECK(own.summary.compression_residual < (kIsDouble ? 1e-10 : 1e-3));
    if (kIsDouble) CHECK(own.warning == "");
    CHECK(own.summary.work == doctest::Approx(dense.summary.work).epsilon(limit));
    CHECK(own.summary.elastic == doctest::Approx(dense.summary.elastic).epsilon(limit));
    CHECK(own.summary.condition < 20 * dense.summary.condition);
    CHECK(own.summary.condition > dense.summary.condition / 20);
  }
}

TEST_CASE("compressed solver: bodies with equations of free zones stay dense, beside others that do not" *
          doctest::skip(c2d::kSmallCode)) {
  many::Model m;
  m.add(many::rectangle(0, 0, 4, 1, {30, 10, 41, 10}));
  m.add(many::rectangle(1, 1, 3, 2, {23, 10, 20, 10}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0.1, -1));
  const many::Range lower = m.side(1, 3), upper = m.side(2, 1);
  m.zones.push_back({C2D_ZONE_FREE, {{1, lower.first, lower.last}, {2, upper.last, upper.first}}});
  m.friction = 0.4;
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  std::vector<double> pressure[2];
  for (int32_t elimination : {C2D_ELIMINATION_DENSE, C2D_ELIMINATION_COMPRESSED}) {
    Own own(limits, enough_for(limits));
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = elimination;
    REQUIRE(many::feed(own.solver(), m) == C2D_OK);
    REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
    REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
    REQUIRE(c2d_run(own.solver(), nullptr, nullptr) == C2D_OK);
    const host::Summary summary = summary_of(own.solver());
    CHECK(summary.compressed_bodies == elimination);
    pressure[elimination].resize(static_cast<size_t>(summary.pairs));
    REQUIRE(c2d_get(own.solver(), C2D_TN, 0, 1, summary.pairs, pressure[elimination].data(), 1) == C2D_OK);
    for (int32_t t = 1; t < C2D_TAPES; ++t) {
      uint64_t blocks = 0, bytes = 0;
      REQUIRE(c2d_tape_need(&limits, &options, enough_for(limits), t, &blocks, &bytes, nullptr) == C2D_OK);
      CHECK(own.store.blocks[t] <= blocks);
    }
  }
  double most = 0, apart = 0;
  for (size_t i = 0; i < pressure[0].size(); ++i) {
    most = std::max(most, std::fabs(pressure[0][i]));
    apart = std::max(apart, std::fabs(pressure[0][i] - pressure[1][i]));
  }
  CHECK(most > 0);
  CHECK(apart < (kIsDouble ? 1e-9 : 5e-3) * most);
}

TEST_CASE("compressed solver: points inside and indicators as by the dense elimination" * doctest::skip(c2d::kSmallCode)) {
  const Deck deck = deck_at("examples/hertz_fine.dat");
  const host::Limits limits = deck.limits();
  std::vector<double> found[2];
  for (int32_t elimination : {C2D_ELIMINATION_DENSE, C2D_ELIMINATION_COMPRESSED}) {
    Own own(limits, enough_for(limits));
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = elimination;
    Numbers numbers;
    REQUIRE(run_all(own.solver(), deck, numbers, &options) == C2D_OK);
    const double points[] = {0.5, -1, 1.5, -3, 0.2, -0.4};
    std::vector<double>& out = found[elimination];
    out.resize(3 * C2D_POINT_FIELDS + 5 * C2D_OFF_FIELDS);
    REQUIRE(c2d_interior(own.solver(), 1, 3, points, 2, out.data(), C2D_POINT_FIELDS) == C2D_OK);
    REQUIRE(c2d_indicators(own.solver(), 1, 1, 5, out.data() + 3 * C2D_POINT_FIELDS, C2D_OFF_FIELDS) == C2D_OK);
  }
  for (size_t i = 0; i < found[0].size(); ++i)
    CHECK(std::fabs(found[0][i] - found[1][i]) <= (kIsDouble ? 1e-9 : 1e-2) * (1e-3 + std::fabs(found[0][i])));
}

// ---- memory and tapes -------------------------------------------------------------------------------------------------

TEST_CASE("compressed solver: tapes are no larger than was told, whatever the workspace" * doctest::skip(c2d::kSmallCode)) {
  for (const char* file : {"tests/data/decks/sample.dat", "examples/hertz_fine.dat", "make bearing", "make hole", "make crack"})
    for (uint64_t beyond : {uint64_t{2} << 20, uint64_t{8} << 20, uint64_t{100} << 20})
      for (int32_t symmetry : {C2D_SYMMETRY_DECK, C2D_SYMMETRY_IMAGES}) {
        CAPTURE(file);
        CAPTURE(beyond);
        const Deck deck = deck_at(file);
        const host::Limits limits = deck.limits();
        const uint64_t bytes = minimum_of(limits) + beyond;
        c2d_options options = compressed();
        options.symmetry = symmetry;
        uint64_t blocks[C2D_TAPES] = {}, each[C2D_TAPES] = {};
        c2d_status status = C2D_OK;
        for (int32_t t = 0; t < C2D_TAPES && status == C2D_OK; ++t)
          status = c2d_tape_need(&limits, &options, bytes, t, &blocks[t], &each[t], nullptr);
        Own own(limits, bytes);
        Numbers numbers;
        if (status == C2D_ERR_MEMORY) {
          CHECK(run_all(own.solver(), deck, numbers, &options) == C2D_ERR_MEMORY);
          continue;
        }
        REQUIRE(status == C2D_OK);
        const c2d_status ended = run_all(own.solver(), deck, numbers, &options);
        if (ended == C2D_ERR_MEMORY) continue; // of a rank beyond what was planned; the tapes were opened
        if (ended == C2D_ERR_INPUT) continue;  // a deck that images do not suit
        REQUIRE(ended == C2D_OK);
        REQUIRE(c2d_save(own.solver()) == C2D_OK);
        int opened = 0;
        for (const RamStore::Operation& o : own.store.done) {
          if (o.kind != 'o') continue;
          ++opened;
          CHECK(o.block <= blocks[o.tape]);
          CHECK(o.bytes <= each[o.tape]);
        }
        CHECK(opened > 2);
        CHECK(own.machine->guards_are_whole());
        const host::Summary summary = summary_of(own.solver());
        CHECK(summary.peak_bytes <= summary.workspace_bytes);
      }
}

TEST_CASE("compressed solver: too little workspace is told with the number that will do" * doctest::skip(c2d::kSmallCode)) {
  const Deck deck = deck_at("examples/hertz_fine.dat");
  const host::Limits limits = deck.limits();
  const c2d_options options = compressed();
  const uint64_t least = minimum_of(limits);
  Numbers dense, numbers;
  uint64_t needed = 0;
  {
    Own own(limits, least);
    REQUIRE(run_all(own.solver(), deck, numbers, &options) == C2D_ERR_MEMORY);
    const c2d_error why = error_of(own.solver());
    needed = why.bytes_needed;
    CHECK(needed > least);
    CHECK(std::string(why.text).find(std::to_string(needed) + " bytes would do") != std::string::npos);
    CHECK(c2d_get_state(own.solver()) == C2D_STATE_MODEL);
    // The same solver without it.
    const c2d_options none = C2D_INIT(c2d_options);
    REQUIRE(c2d_set_options(own.solver(), &none) == C2D_OK);
    REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
    REQUIRE(run_prepared(own.solver(), dense) == C2D_OK);
  }
  c2d_error why = C2D_INIT(c2d_error);
  CHECK(c2d_tape_need(&limits, &options, least, C2D_TAPE_UPPER, nullptr, nullptr, &why) == C2D_ERR_MEMORY);
  CHECK(why.bytes_needed == needed);
  Own own(limits, needed);
  CHECK(run_all(own.solver(), deck, numbers, &options) == C2D_OK);
  CHECK(numbers.outcome == dense.outcome);
}

namespace {

// A body whose cells keep more than the least rank there is.
many::Model wide() {
  many::Model m;
  m.add(many::rectangle(0, 0, 1, 0.8, {150, 120, 150, 120}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(1, 3, many::end_of(many::kPulled, 0.2, 1));
  return m;
}

} // namespace

TEST_CASE("compressed solver: a rank beyond the workspace is told with the number that will do" *
          doctest::skip(c2d::kSmallCode)) {
  const many::Model m = wide();
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  const c2d_options options = compressed();
  uint64_t low = minimum_of(limits), high = enough_for(limits); // the least workspace that can be planned for
  while (high - low > 64) {
    const uint64_t middle = low + (high - low) / 2;
    (c2d_tape_need(&limits, &options, middle, C2D_TAPE_UPPER, nullptr, nullptr, nullptr) == C2D_OK ? high : low) = middle;
  }
  Own tight(limits, high);
  REQUIRE(many::feed(tight.solver(), m) == C2D_OK);
  REQUIRE(c2d_set_options(tight.solver(), &options) == C2D_OK);
  CHECK(c2d_prepare(tight.solver()) == C2D_ERR_MEMORY);
  const uint64_t needed = error_of(tight.solver()).bytes_needed;
  CHECK(needed > high);
  CHECK(c2d_get_state(tight.solver()) == C2D_STATE_MODEL);
  CHECK(c2d_prepare(tight.solver()) == C2D_ERR_MEMORY); // and again
  CHECK(error_of(tight.solver()).bytes_needed == needed);
  std::vector<double> results[2];
  for (uint64_t bytes : {needed, enough_for(limits)}) {
    Own own(limits, bytes);
    REQUIRE(many::feed(own.solver(), m) == C2D_OK);
    REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
    REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
    REQUIRE(c2d_run(own.solver(), nullptr, nullptr) == C2D_OK);
    std::vector<double>& out = results[bytes == needed ? 0 : 1];
    out.resize(540);
    REQUIRE(c2d_get(own.solver(), C2D_END_UX, 1, 1, 540, out.data(), 1) == C2D_OK);
  }
  double size = 0, apart = 0;
  for (size_t i = 0; i < results[0].size(); ++i) {
    size = std::max(size, std::fabs(results[0][i]));
    apart = std::max(apart, std::fabs(results[0][i] - results[1][i]));
  }
  CHECK(size > 0);
  CHECK(apart < (kIsDouble ? 1e-12 : 1e-4) * size);
}

// ---- states, other loads, options -------------------------------------------------------------------------------------

TEST_CASE("compressed solver: saved, restored elsewhere and moved it goes on with the same bits" *
          doctest::skip(c2d::kSmallCode)) {
  const Deck deck = deck_at("examples/hertz_fine.dat");
  const host::Limits limits = deck.limits();
  const c2d_options options = compressed();
  const uint64_t bytes = enough_for(limits);
  Own first(limits, bytes);
  REQUIRE(c2d_set_options(first.solver(), &options) == C2D_OK);
  REQUIRE(read_deck(first.solver(), deck) == C2D_OK);
  REQUIRE(c2d_prepare(first.solver()) == C2D_OK);
  const double mu = 0.3, half = 0.5, full = 1;
  c2d_outcome outcome;
  const auto at_full = [&](c2d_solver* s) {
    REQUIRE(c2d_advance(s, &full, 1, &outcome) == C2D_OK);
    Numbers out;
    REQUIRE(get_boundary(s, out) == C2D_OK);
    return out;
  };
  REQUIRE(c2d_begin(first.solver(), &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(first.solver(), &half, 1, &outcome) == C2D_OK);
  REQUIRE(c2d_save(first.solver()) == C2D_OK);
  const RamStore kept = first.store;
  const Bytes image = first.machine->workspace();
  const Numbers through = at_full(first.solver());
  SUBCASE("restored") {
    RamStore store = kept;
    Own other(limits, bytes, &store);
    REQUIRE(c2d_set_options(other.solver(), &options) == C2D_OK);
    REQUIRE(read_deck(other.solver(), deck) == C2D_OK);
    REQUIRE(c2d_restore(other.solver()) == C2D_OK);
    CHECK(summary_of(other.solver()).compressed_bodies == 2);
    CHECK(at_full(other.solver()) == through);
  }
  SUBCASE("not by a dense solver, nor the other way round") {
    RamStore store = kept;
    Own other(limits, bytes, &store);
    REQUIRE(read_deck(other.solver(), deck) == C2D_OK);
    CHECK(c2d_restore(other.solver()) == C2D_ERR_MISMATCH);
  }
  SUBCASE("in a workspace that is too small for it") {
    RamStore store = kept;
    Own other(limits, minimum_of(limits), &store);
    REQUIRE(c2d_set_options(other.solver(), &options) == C2D_OK);
    REQUIRE(read_deck(other.solver(), deck) == C2D_OK);
    CHECK(c2d_restore(other.solver()) == C2D_ERR_MEMORY);
  }
  SUBCASE("moved") {
    RamStore store = kept;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    std::vector<unsigned char> room(image.size() + 64);
    std::copy(image.begin(), image.end(), room.begin() + 5);
    c2d_solver* moved = nullptr;
    REQUIRE(c2d_attach(&moved, room.data() + 5, image.size(), &port, nullptr) == C2D_OK);
    CHECK(at_full(moved) == through);
    c2d_close(moved);
  }
}

TEST_CASE("compressed solver: other loads, and from one elimination to the other" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = wide();
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  Own own(limits, enough_for(limits));
  const auto solve = [&](int32_t elimination, int32_t keep) {
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = elimination;
    options.keep_factors = keep;
    REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
    REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
    REQUIRE(c2d_run(own.solver(), nullptr, nullptr) == C2D_OK);
    std::vector<double> out(540);
    REQUIRE(c2d_get(own.solver(), C2D_END_UY, 1, 1, 540, out.data(), 1) == C2D_OK);
    REQUIRE(c2d_change_loads(own.solver()) == C2D_OK);
    return out;
  };
  REQUIRE(many::feed(own.solver(), m) == C2D_OK);
  const std::vector<double> dense = solve(C2D_ELIMINATION_DENSE, 1), own1 = solve(C2D_ELIMINATION_COMPRESSED, 1);
  CHECK(Numbers::same(solve(C2D_ELIMINATION_DENSE, 1), dense));
  const double twice[4] = {0.4, 2, 0, 0};
  for (int32_t e = 271; e <= 420; ++e) REQUIRE(c2d_set_values(own.solver(), 1, e, 0, 1, twice) == C2D_OK);
  const std::vector<double> doubled = solve(C2D_ELIMINATION_COMPRESSED, 1);
  double size = 0, apart = 0, off = 0;
  for (size_t i = 0; i < dense.size(); ++i) {
    size = std::max(size, std::fabs(dense[i]));
    apart = std::max(apart, std::fabs(dense[i] - own1[i]));
    off = std::max(off, std::fabs(doubled[i] - 2 * own1[i]));
  }
  CHECK(apart < (kIsDouble ? 1e-10 : 1e-3) * size);
  CHECK(off < (kIsDouble ? 1e-12 : 1e-4) * size);
  c2d_options options = C2D_INIT(c2d_options);
  for (int32_t wrong : {-1, 3}) {
    options.elimination = wrong;
    CHECK(c2d_set_options(own.solver(), &options) == C2D_ERR_ARGUMENT);
  }
}

TEST_CASE("compressed solver: two load cases of a body whose right-hand sides come by cells" * doctest::skip(c2d::kSmallCode)) {
  many::Model m = wide();
  m.set_second(1, 2, many::end_of(many::kPulled, 0.5, -0.3));
  m.set_second(1, 1, many::end_of(many::kHeld, 0.004, -0.002));
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  REQUIRE(limits.load_cases == 2);
  std::vector<double> found[2];
  for (const int32_t elimination : {C2D_ELIMINATION_DENSE, C2D_ELIMINATION_COMPRESSED}) {
    Own own(limits, enough_for(limits));
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = elimination;
    REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
    REQUIRE(many::feed(own.solver(), m) == C2D_OK);
    REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
    const double mu = 0, loads[3][2] = {{1, 0}, {0, 1}, {0.7, -0.4}};
    REQUIRE(c2d_begin(own.solver(), &mu, 0) == C2D_OK);
    for (const auto& load : loads) {
      c2d_outcome outcome = C2D_UNDECIDED;
      REQUIRE(c2d_advance(own.solver(), load, 2, &outcome) == C2D_OK);
      REQUIRE(outcome == C2D_REACHED);
      std::vector<double>& all = found[elimination == C2D_ELIMINATION_DENSE ? 0 : 1];
      for (const int32_t field : {C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY}) {
        all.resize(all.size() + 540);
        REQUIRE(c2d_get(own.solver(), field, 1, 1, 540, all.data() + all.size() - 540, 1) == C2D_OK);
      }
    }
  }
  for (size_t first = 0; first < found[0].size(); first += 540) {
    double size = 0, apart = 0;
    for (size_t i = first; i < first + 540; ++i)
      size = std::max(size, std::fabs(found[0][i])), apart = std::max(apart, std::fabs(found[0][i] - found[1][i]));
    CAPTURE(first);
    CHECK(size > 0);
    CHECK(apart < (kIsDouble ? 1e-10 : 1e-3) * size);
  }
}

// A strip a millionth as thick as it is long: no elimination leaves many digits.
TEST_CASE("compressed solver: what is left of the equations is told" * doctest::skip(c2d::kSmallCode)) {
  many::Model m;
  m.add(many::rectangle(0, 0, 1, kIsDouble ? 1e-5 : 1e-2, {100, 1, 100, 1}));
  m.set(1, 4, many::end_of(many::kHeld));
  m.set(1, 2, many::end_of(many::kPulled, 0, 1));
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  Own own(limits, enough_for(limits));
  const c2d_options options = compressed();
  REQUIRE(many::feed(own.solver(), m) == C2D_OK);
  REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
  REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
  REQUIRE(c2d_run(own.solver(), nullptr, nullptr) == C2D_OK);
  CHECK(own.told_of(C2D_WARN_COMPRESSED));
  const host::Summary summary = summary_of(own.solver());
  CHECK(summary.compression_error > 1e-9);
  CHECK(summary.compression_residual < 1e-4);
  CHECK(std::string(c2d_message(C2D_WARN_COMPRESSED)).find("compress") != std::string::npos);
  m.add(many::rectangle(0, 1, 1, kIsDouble ? 1 + 1e-5 : 1.01, {100, 1, 100, 1})); // another one is not told again
  m.set(2, 4, many::end_of(many::kHeld));
  m.set(2, 2, many::end_of(many::kPulled, 0, 1));
  const c2d_limits both = many::limits_of(m, list);
  Own two(both, enough_for(both));
  REQUIRE(many::feed(two.solver(), m) == C2D_OK);
  REQUIRE(c2d_set_options(two.solver(), &options) == C2D_OK);
  REQUIRE(c2d_prepare(two.solver()) == C2D_OK);
  REQUIRE(c2d_run(two.solver(), nullptr, nullptr) == C2D_OK);
  CHECK(std::count_if(two.told.begin(), two.told.end(), [](const c2d_error& e) { return e.status == C2D_WARN_COMPRESSED; }) ==
        1);
}

struct Slender {
  const char* name;
  std::vector<std::string> settings;
  const char* of; // what a warning is about; null: there is none
  double least;   // of what is told, however compilers round
};
constexpr uint64_t kForSlender = uint64_t{256} << 20;
// Slender bodies, and elements that are short beside them: what the last digits make of tractions.
const std::vector<Slender> kSlender = {
    {"bimaterial", {"h1=0.002", "h2=0.002", "L=20", "n=20"}, " of the tractions", 2e-10}, // (some 1e-9)
    {"bimaterial", {"h1=0.002", "h2=0.002", "L=10", "n=8"}, nullptr, 0},
    {"cantilever", {"L=200", "c=0.5", "n=1"}, " of the tractions", 3e-9},
    {"cantilever", {"L=20", "c=0.5", "n=2"}, nullptr, 0},
    {"punch", {"n=20"}, nullptr, 0},
};

TEST_CASE("compressed solver: tractions and displacements are no farther from the dense ones than is told" *
          doctest::skip(c2d::kSmallCode || !kIsDouble)) {
  for (const Slender& slender : kSlender) {
    CAPTURE(std::string(slender.name) + " " + slender.settings.front());
    const Deck deck = deck_of_family(slender.name, slender.settings);
    const Answer dense = answer_of(deck, C2D_INIT(c2d_options)), own = answer_of(deck, compressed(), kForSlender);
    REQUIRE(own.summary.compressed_bodies > 0);
    const Difference apart = compare(dense, own);
    const double told = own.summary.compression_error;
    CHECK(apart.tractions < std::max(1e-9, told));
    CHECK(apart.lengths < std::max(1e-9, told));
    CHECK(told > slender.least);
    CHECK((told > 1e-9) == (own.warning != ""));
    if (slender.of == nullptr)
      CHECK(own.warning == "");
    else if (told > 1e-9)
      CHECK(own.warning.find(slender.of) != std::string::npos);
  }
}

// The layer bends under its own tractions far more than cylinder and block give way. Where these keep their equations and it is
// solved for, 6e-9 of the tractions are lost, dense or compressed, and the block's equations are met to 2e-9 only.
TEST_CASE("compressed solver: of a block, a thin layer and a cylinder the layer keeps its equations" *
          doctest::skip(c2d::kSmallCode || !kIsDouble)) {
  const Deck deck = deck_of_family("coating", {"t=0.1", "n=10"});
  const Answer dense = answer_of(deck, C2D_INIT(c2d_options)), own = answer_of(deck, compressed(), kForSlender);
  REQUIRE(own.summary.compressed_bodies == 3);
  const Difference apart = compare(dense, own);
  CHECK(apart.tractions < 1e-11);
  CHECK(apart.lengths < 1e-11);
  CHECK(own.summary.compression_residual < 1e-13);
  CHECK(own.summary.compression_error < 1e-11);
  CHECK(own.warning == "");
}

// A strip that a punch draws, whose body has no equations of its own; and one that nothing draws.
TEST_CASE("compressed solver: beside a punch, and without loads" * doctest::skip(c2d::kSmallCode)) {
  for (const bool drawn : {true, false}) {
    CAPTURE(drawn);
    many::Model m;
    m.add(many::rectangle(0, 0, 4, 1, {40, 10, 40, 10}));
    m.set(1, 4, many::end_of(many::kHeld));
    if (drawn) m.move(1, 2).load[0] = 3;
    std::vector<c2d_body_limits> list;
    const c2d_limits limits = many::limits_of(m, list);
    host::Summary summary[2];
    for (const bool compresses : {false, true}) {
      const c2d_options options = compresses ? compressed() : c2d_options(C2D_INIT(c2d_options));
      uint64_t blocks[C2D_TAPES] = {}, each[C2D_TAPES] = {};
      for (int32_t t = 0; t < C2D_TAPES; ++t)
        REQUIRE(c2d_tape_need(&limits, &options, enough_for(limits), t, &blocks[t], &each[t], nullptr) == C2D_OK);
      Own own(limits, enough_for(limits));
      REQUIRE(many::feed(own.solver(), m) == C2D_OK);
      REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
      REQUIRE(c2d_prepare(own.solver()) == C2D_OK);
      REQUIRE(c2d_run(own.solver(), nullptr, nullptr) == C2D_OK);
      for (const RamStore::Operation& o : own.store.done)
        if (o.kind == 'o') CHECK((o.block <= blocks[o.tape] && o.bytes <= each[o.tape]));
      summary[compresses] = summary_of(own.solver());
    }
    CHECK(summary[1].compressed_bodies == 1);
    CHECK((summary[0].work > 0) == drawn);
    CHECK(summary[1].work == doctest::Approx(summary[0].work).epsilon(kIsDouble ? 1e-9 : 5e-3));
    CHECK(summary[1].compression_error < (kIsDouble ? 1e-9 : 1e-2));
    if (!drawn) CHECK(summary[1].compression_error == 0.0);
  }
}

// A state that is taken up brings plans, which place what is read: each number of them is held to what it can be.
TEST_CASE("compressed solver: a plan that is none of the body's is known, of either elimination" *
          doctest::skip(c2d::kSmallCode)) {
  const Deck deck = deck_at("tests/data/decks/sample.dat");
  const host::Limits limits = deck.limits();
  for (const bool compresses : {false, true}) {
    CAPTURE(compresses);
    Own own(limits, enough_for(limits));
    const c2d_options options = compresses ? compressed() : c2d_options(C2D_INIT(c2d_options));
    Numbers numbers;
    REQUIRE(run_all(own.solver(), deck, numbers, &options) == C2D_OK);
    const c2d::Model m = c2d::model_of(own.solver());
    const c2d::PhaseSizes sizes = c2d::model_sizes(m);
    const c2d::EliminationPlan plan = c2d::plan_of(own.solver(), 1);
    REQUIRE((plan.rank > 0) == compresses);
    CHECK(c2d::is_plan_of(sizes, 1, plan));
    using Plan = c2d::EliminationPlan;
    for (int32_t Plan::*const number : {&Plan::rows, &Plan::pivots, &Plan::trailing, &Plan::panel_columns, &Plan::block_columns,
                                        &Plan::block_rows, &Plan::keep_lower, &Plan::rank})
      for (const int32_t wrong : {-1, INT32_MAX}) {
        Plan other = plan;
        other.*number = wrong;
        CHECK_FALSE(c2d::is_plan_of(sizes, 1, other));
      }
    Plan wide = plan;
    wide.block_columns = wide.panel_columns + 1;
    CHECK_FALSE(c2d::is_plan_of(sizes, 1, wide));
  }
}

// ---- the store --------------------------------------------------------------------------------------------------------

TEST_CASE("compressed solver: whichever operation of the store fails, that is told, and it can begin anew" *
          doctest::skip(c2d::kSmallCode)) {
  const Deck deck = deck_at("tests/data/decks/sample.dat");
  const host::Limits limits = deck.limits();
  const c2d_options options = compressed();
  Own clean(limits, enough_for(limits));
  Numbers expected;
  REQUIRE(run_all(clean.solver(), deck, expected, &options) == C2D_OK);
  const size_t operations = clean.store.done.size();
  REQUIRE(operations > 100);
  // The last ones are those of back substitution, and of what is left of the equations.
  const size_t sparse = test::effort<size_t>(6, 1);
  for (size_t n = 0; n < operations;
       n += n + 24 < operations ? std::min(sparse * (1 + operations / 60), operations - 24 - n) : sparse) {
    CAPTURE(n);
    Own own(limits, enough_for(limits));
    own.store.before = [n](const RamStore::Operation&, size_t i) { return i == n ? 7 : 0; };
    Numbers numbers;
    const c2d_status status = run_all(own.solver(), deck, numbers, &options);
    if (status == C2D_OK) { // of the count, which a new store need not have
      CHECK(numbers == expected);
      continue;
    }
    CHECK(status >= C2D_ERR_STORE_OPEN);
    CHECK(status <= C2D_ERR_STORE_CLOSE);
    CHECK(error_of(own.solver()).host_code == 7);
  }
}

// ---- the program ------------------------------------------------------------------------------------------------------

TEST_CASE("compressed solver: the program's option" * doctest::skip(c2d::kSmallCode)) {
  const test::Folder folder;
  const std::string deck = paths::root() + "/examples/hertz_fine.dat", program = paths::program();
  const auto run = [&](const std::string& words) { return test::run_shell("'" + program + "' " + words); };
  const auto json_of = [&](const std::string& words) {
    const test::Result out = run("run '" + deck + "' -q --json '" + (folder / "run.json") + "' " + words);
    REQUIRE_MESSAGE(out.status == 0, out.err);
    return test::read_file(folder / "run.json");
  };
  const std::string dense = json_of(""), own = json_of("--elimination compressed");
  CHECK(dense.find("\"elimination\": \"dense\"") != std::string::npos);
  CHECK(dense.find("compression") == std::string::npos);
  CHECK(own.find("\"elimination\": \"compressed\"") != std::string::npos);
  CHECK(own.find("\"compression\": {\"bodies\": 2, \"residual\": ") != std::string::npos);
  const test::Result checked = run("check '" + deck + "' --elimination compressed");
  CHECK(checked.status == 0);
  CHECK(checked.out.find("memory, compressed") != std::string::npos);
  CHECK(run("run '" + deck + "' --elimination sparse").status == 64);
  const test::Result small = run("run '" + deck + "' --elimination compressed --memory 700K");
  CHECK(small.status == 4);
  CHECK(small.err.find("bytes would do") != std::string::npos);
  // Less than the least of dense elimination is answered by what will do, too, as check tells it.
  const test::Result least = run("run '" + deck + "' --elimination compressed --memory 1000");
  CHECK(least.status == 4);
  const std::string before = "bytes is too small: ";
  const size_t at = least.err.find(before);
  REQUIRE(at != std::string::npos);
  const std::string enough = std::to_string(std::stoull(least.err.substr(at + before.size())));
  CHECK(checked.out.find(" bytes; minimum " + enough + "\n") != std::string::npos);
  CHECK(run("run '" + deck + "' -q --elimination compressed --memory " + enough).status == 0);
  // A run that is cut off goes on with what it was begun with.
  CHECK(run("run '" + deck + "' -q --elimination compressed --store file:'" + (folder / "store") + "' --csv '" +
            (folder / "a.csv") + "'")
            .status == 0);
  CHECK(run("run '" + deck + "' -q --elimination compressed --csv '" + (folder / "b.csv") + "'").status == 0);
  CHECK(test::read_file(folder / "a.csv") == test::read_file(folder / "b.csv"));
  CHECK(run("run '" + deck + "' -q --elimination compressed --threads 2 --csv '" + (folder / "c.csv") + "'").status == 0);
  CHECK(test::read_file(folder / "c.csv") == test::read_file(folder / "b.csv"));
}

TEST_CASE("compressed solver: by size, as the limits say, whatever the memory" * doctest::skip(c2d::kSmallCode)) {
  const auto by_size = [](int32_t nodes, int32_t pairs, int32_t free_pairs) {
    host::Limits limits;
    limits.bodies = 2;
    limits.function_nodes = 2;
    limits.body[0] = {20, 20, 1, 0};
    limits.body[1] = {nodes, nodes, 1, 0};
    limits.zones = 1;
    limits.pairs = pairs, limits.contact_elements = pairs, limits.free_pairs = free_pairs;
    limits.coefficients = limits.paths = 1;
    Own own(limits, enough_for(limits)), least(limits, minimum_of(limits));
    c2d_options options = C2D_INIT(c2d_options);
    options.elimination = C2D_ELIMINATION_BY_SIZE;
    REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
    REQUIRE(c2d_set_options(least.solver(), &options) == C2D_OK);
    const int32_t chosen = own.solver()->options.elimination;
    CHECK(least.solver()->options.elimination == chosen);
    c2d_options same = options;
    same.elimination = chosen;
    for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
      uint64_t blocks[2], bytes[2];
      REQUIRE(c2d_tape_need(&limits, &options, enough_for(limits), tape, &blocks[0], &bytes[0], nullptr) == C2D_OK);
      REQUIRE(c2d_tape_need(&limits, &same, enough_for(limits), tape, &blocks[1], &bytes[1], nullptr) == C2D_OK);
      CHECK(blocks[0] == blocks[1]);
      CHECK(bytes[0] == bytes[1]);
    }
    return chosen;
  };
  CHECK(by_size(801, 2, 0) == C2D_ELIMINATION_DENSE);
  CHECK(by_size(802, 2, 0) == C2D_ELIMINATION_COMPRESSED);
  CHECK(by_size(900, 201, 0) == C2D_ELIMINATION_DENSE);
  CHECK(by_size(901, 201, 0) == C2D_ELIMINATION_COMPRESSED);
  CHECK(by_size(2000, 201, 201) == C2D_ELIMINATION_DENSE); // (bodies with equations of free zones are)
}

TEST_CASE("compressed solver: the program chooses by size, and check says from where on" * doctest::skip(c2d::kSmallCode)) {
  const test::Folder folder;
  const auto run = [&](const std::string& words) {
    return test::run_shell("cd '" + folder.path() + "' && '" + paths::program() + "' " + words);
  };
  REQUIRE(run("make ring n=399 order=1 >small && '" + paths::program() + "' make ring n=400 order=1 >large").status == 0);
  const auto says = [&](const std::string& words, const std::string& expected) {
    const test::Result out = run("check " + words);
    CHECK_MESSAGE(out.out.find("elimination                 " + expected + "\n") != std::string::npos, out.out);
    return out.out.find("memory, compressed") != std::string::npos;
  };
  CHECK_FALSE(says("small", "dense by size (compressed from 801 nodes per body)"));
  CHECK(says("large", "compressed by size (compressed from 801 nodes per body)"));
  CHECK_FALSE(says("large --elimination dense", "dense"));
  CHECK(says("small --elimination compressed", "compressed"));
  CHECK_FALSE(says("'" + paths::root() + "/examples/three_bodies.dat'", "dense (the model has free zones)"));
  for (const std::string file : {"small", "large"}) {
    REQUIRE(run("run " + file + " -q --json j").status == 0);
    const std::string own = test::read_file(folder / "j");
    CHECK(own.find("\"elimination\": \"" + std::string(file == "small" ? "dense" : "compressed")) != std::string::npos);
  }
  const test::Result little = run("run large --memory 1M"), as_asked = run("run large --memory 1M --elimination compressed");
  CHECK((little.status == 4 && as_asked.status == 4));
  CHECK(little.err.find("bytes would do") != std::string::npos);
  CHECK(little.err.find("--elimination dense takes less memory") != std::string::npos);
  CHECK(as_asked.err.find("--elimination dense") == std::string::npos);
  CHECK(run("run large --memory 1M --elimination dense").status == 0);
  // Bounds of what is written are far above it: the disk is not asked for all of them.
  REQUIRE(run("make ring n=1000 order=1 >larger").status == 0);
  REQUIRE(run("run larger -q --keep --store file:kept").status == 0);
  struct stat tape;
  REQUIRE(::stat((folder / "kept/contact2d.store/tape1.c2d").c_str(), &tape) == 0);
  const std::string check = run("check larger").out, lower = check.substr(check.find("tape lower") + 10);
  const size_t each = lower.find("blocks of ");
  REQUIRE(each != std::string::npos);
  CHECK(static_cast<uint64_t>(tape.st_blocks) * 512 < std::stoull(lower) * std::stoull(lower.substr(each + 10)) / 4);
}

// ---- points inside ----------------------------------------------------------------------------------------------------

namespace {

// Points all over a body, on its boundary, and in growing distances from it, on both sides.
std::vector<double> points_about(c2d_solver* solver, int32_t body) {
  const host::Summary summary = summary_of(solver);
  const int32_t ends = summary.body[static_cast<size_t>(body) - 1].elements * summary.function_nodes;
  std::vector<double> x(static_cast<size_t>(ends)), y(x), out;
  REQUIRE(c2d_get(solver, C2D_END_X, body, 1, ends, x.data(), 1) == C2D_OK);
  REQUIRE(c2d_get(solver, C2D_END_Y, body, 1, ends, y.data(), 1) == C2D_OK);
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      out.push_back(*left + (*right - *left) * (i + 0.31) / 12);
      out.push_back(*low + (*high - *low) * (j + 0.43) / 12);
    }
  for (size_t k = 0; k + 1 < x.size(); k += 1 + x.size() / 40) {
    const double dx = x[k + 1] - x[k], dy = y[k + 1] - y[k];
    out.push_back(x[k]);
    out.push_back(y[k]);
    for (const double depth : {1e-3, 0.03, 0.3, 3.0, 30.0, -0.3})
      for (const double along : {0.5, 0.02}) {
        out.push_back(x[k] + along * dx - depth * dy);
        out.push_back(y[k] + along * dy + depth * dx);
      }
  }
  return out;
}

std::vector<double> inside(c2d_solver* solver, int32_t body, const std::vector<double>& points) {
  std::vector<double> out(points.size() / 2 * C2D_POINT_FIELDS);
  REQUIRE(c2d_interior(solver, body, static_cast<int32_t>(points.size() / 2), points.data(), 2, out.data(), C2D_POINT_FIELDS) ==
          C2D_OK);
  return out;
}

Deck family(const std::string& words) {
  const test::Result made = test::run_shell("'" + paths::program() + "' make " + words);
  REQUIRE_MESSAGE(made.status == 0, made.err);
  Deck deck;
  std::istringstream in(made.out);
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  return deck;
}

// Curves of straight elements, x y x y ...: open ones, from one point to another on the line of symmetry, before closed ones.
many::Body body_of(const std::vector<std::vector<double>>& curves, int32_t open) {
  many::Body body;
  body.open_regions = open;
  for (const std::vector<double>& curve : curves) {
    const int32_t before = body.elements(), points = static_cast<int32_t>(curve.size() / 2);
    body.xy.insert(body.xy.end(), curve.begin(), curve.end());
    body.regions.push_back({before + 1, before + points - (static_cast<int32_t>(body.regions.size()) < open ? 1 : 0)});
  }
  body.ends.resize(2 * static_cast<size_t>(body.elements()));
  return body;
}
void straight(std::vector<double>& curve, double x0, double y0, double x1, double y1, int count) { // without its end
  for (int i = 0; i < count; ++i) curve.insert(curve.end(), {x0 + (x1 - x0) * i / count, y0 + (y1 - y0) * i / count});
}

// Half of a plate with holes along the line of symmetry, x = 0 (1) or y = 0 (2): a contour of many pieces, with a double node
// at a corner.
many::Model comb(int32_t axis) {
  std::vector<std::vector<double>> curves(1);
  straight(curves[0], 0, 0, 2, 0, 40), curves[0].insert(curves[0].end(), {2, 0}), straight(curves[0], 2, 0, 2, 8, 160);
  straight(curves[0], 2, 8, 0, 8, 40), curves[0].insert(curves[0].end(), {0, 8});
  for (int hole = 4; hole >= 0; --hole) {
    curves.emplace_back();
    for (int i = 0; i <= 40; ++i) {
      const double angle = std::acos(-1.0) * (0.5 - i / 40.0), x = i % 40 == 0 ? 0 : 0.3 * std::cos(angle);
      curves.back().insert(curves.back().end(), {x, 0.8 + 1.6 * hole + 0.3 * std::sin(angle)});
    }
  }
  many::Model m;
  many::Body body = body_of(curves, 6);
  body.sides = {{1, 40}, {202, 241}};
  for (size_t i = 0; i < body.xy.size() && axis == 2; i += 2) {
    const double x = body.xy[i];
    body.xy[i] = -body.xy[i + 1], body.xy[i + 1] = x;
  }
  m.add(body);
  m.symmetry = axis;
  return m;
}
// The same without holes, its contour closed along the line.
many::Model with_axis() {
  std::vector<double> curve;
  straight(curve, 0, 0, 2, 0, 50), straight(curve, 2, 0, 2, 8, 150), straight(curve, 2, 8, 0, 8, 50),
      straight(curve, 0, 8, 0, 0, 200);
  many::Model m;
  many::Body body = body_of({curve}, 0);
  body.sides = {{1, 50}, {201, 250}, {251, 450}};
  m.add(body);
  m.set(1, 3, many::end_of("1001"));
  return m;
}

// A model that has gone its way.
struct Followed {
  std::vector<c2d_body_limits> list;
  c2d_limits limits;
  Own own;
  Followed(const many::Model& m, const c2d_options& options)
      : limits(many::limits_of(m, list)), own(limits, enough_for(limits)) {
    REQUIRE(c2d_set_options(own.solver(), &options) == C2D_OK);
    REQUIRE_MESSAGE(many::feed(own.solver(), m) == C2D_OK, error_of(own.solver()).text);
    REQUIRE_MESSAGE(c2d_prepare(own.solver()) == C2D_OK, error_of(own.solver()).text);
    REQUIRE(c2d_run(own.solver(), nullptr, nullptr) == C2D_OK);
  }
};

// A solver that has gone through a deck.
struct Solved {
  Own own;
  Solved(const Deck& deck, const c2d_options& options) : own(deck.limits(), enough_for(deck.limits())) {
    Numbers numbers;
    REQUIRE(run_all(own.solver(), deck, numbers, &options) == C2D_OK);
  }
};

} // namespace

namespace {

// Displacements and stresses at many points by both eliminations, each over the largest of its kind; both must agree where each
// point lies. Adds how many bodies were large enough for cells.
void compare_inside(c2d_solver* dense, c2d_solver* own, double apart[2], int* large) {
  const host::Summary summary = summary_of(own);
  for (int32_t body = 1; body <= summary.bodies; ++body) {
    *large += summary.body[static_cast<size_t>(body) - 1].elements >= 400 ? 1 : 0;
    const std::vector<double> points = points_about(dense, body), a = inside(dense, body, points),
                              b = inside(own, body, points);
    double most[2] = {0, 0}, off[2] = {0, 0};
    int found = 0;
    for (size_t i = 0; i < a.size(); i += C2D_POINT_FIELDS) {
      CHECK(a[i + C2D_POINT_FLAG] == b[i + C2D_POINT_FLAG]);
      found += static_cast<int>(a[i + C2D_POINT_FLAG]) == C2D_POINT_INSIDE ? 1 : 0;
      for (size_t f = 0; f < C2D_POINT_FLAG; ++f) {
        const size_t kind = f <= C2D_POINT_UY ? 0 : 1;
        most[kind] = std::max(most[kind], std::fabs(a[i + f]));
        off[kind] = std::max(off[kind], std::fabs(a[i + f] - b[i + f]));
      }
    }
    CHECK(found > 100);
    for (int kind = 0; kind < 2; ++kind) apart[kind] = std::max(apart[kind], off[kind] / most[kind]);
  }
}

} // namespace

TEST_CASE("compressed solver: points inside large bodies by cells are those element by element" *
          doctest::skip(c2d::kSmallCode)) {
  double apart[2] = {0, 0};
  int large = 0;
  for (const char* words : {"hertz n=250 ratio=1.05 order=2",                     // one line of symmetry
                            "disc_in_hole n=450",                                 // two
                            "disc_in_hole n=60 order=3 ratio=1.05 symmetry=line", // closed contours, cubics
                            "crack n=700", "cantilever n=100 order=2"}) {
    CAPTURE(words);
    const Deck deck = family(words);
    Solved dense(deck, C2D_INIT(c2d_options)), own(deck, compressed());
    compare_inside(dense.own.solver(), own.own.solver(), apart, &large);
  }
  CHECK(large >= 5);
  for (int32_t axis = 0; axis <= 2; ++axis) {
    CAPTURE(axis);
    many::Model m = axis > 0 ? comb(axis) : with_axis();
    m.set(1, 1, many::end_of(many::kHeld));
    m.set(1, 2, many::end_of(many::kPulled, axis == 2 ? -1 : 0.3, axis == 2 ? 0.3 : 1));
    c2d_options options[2] = {C2D_INIT(c2d_options), compressed()};
    for (c2d_options& o : options) o.symmetry = axis > 0 ? C2D_SYMMETRY_DECK : C2D_SYMMETRY_IMAGES;
    Followed dense(m, options[0]), own(m, options[1]);
    compare_inside(dense.own.solver(), own.own.solver(), apart, &large);
  }
  CHECK(apart[0] < (kIsDouble ? 1e-9 : 1e-2));
  CHECK(apart[1] < (kIsDouble ? 1e-9 : 1e-2));
}

TEST_CASE("compressed solver: points inside large bodies that float, or that nothing holds, do not move" *
          doctest::skip(c2d::kSmallCode)) {
  for (const bool floats : {false, true}) {
    CAPTURE(floats);
    many::Model m = comb(1);
    m.set(1, 2, many::end_of(many::kPulled, 0, 1));
    if (floats) { // above a block that is held; nothing touches before the load
      m = many::Model();
      m.add(many::rectangle(0, -1, 2, 0, {100, 50, 2, 50}));
      m.add(many::rectangle(0, 0.1, 2, 1.1, {2, 150, 200, 150}));
      m.set(1, 1, many::end_of(many::kHeld));
      m.set(2, 3, many::end_of(many::kPulled, 0, -1));
      m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
    }
    Followed own(m, compressed());
    const int32_t body = floats ? 2 : 1;
    const double mu = 0;
    if (floats) REQUIRE(c2d_begin(own.own.solver(), &mu, 1) == C2D_OK);
    const std::vector<double> points = points_about(own.own.solver(), body), out = inside(own.own.solver(), body, points);
    int found = 0;
    for (size_t i = 0; i < out.size(); i += C2D_POINT_FIELDS) {
      found += static_cast<int>(out[i + C2D_POINT_FLAG]) == C2D_POINT_INSIDE ? 1 : 0;
      for (size_t f = 0; f < C2D_POINT_FLAG; ++f) CHECK(out[i + f] == 0);
    }
    CHECK(found > 100);
    CHECK(inside(own.own.solver(), body, points) == out); // no cells of that state are kept
  }
}

TEST_CASE("compressed solver: no point depends on its companions, on threads, or on what was asked before" *
          doctest::skip(c2d::kSmallCode)) {
  const Deck deck = family("hertz n=260 ratio=1.05");
  Solved solved(deck, compressed());
  c2d_solver* const solver = solved.own.solver();
  std::vector<double> points = points_about(solver, 2);
  for (int i = 0; i < 2500; ++i) points.push_back(i % 2 == 0 ? -0.03 * i / 2500 : 1 + 2.0 * i / 2500); // more than a block
  const std::vector<double> all = inside(solver, 2, points);
  const auto same = [&](size_t i, const std::vector<double>& one) {
    return std::memcmp(one.data(), all.data() + i * C2D_POINT_FIELDS, C2D_POINT_FIELDS * sizeof(double)) == 0;
  };
  // of bodies asked for together, the first one's points come first
  const std::vector<double> first = inside(solver, 1, points), both = inside(solver, 0, points);
  int of_second = 0;
  for (size_t i = 0; i < points.size() / 2; ++i) {
    const bool outside = static_cast<int>(first[i * C2D_POINT_FIELDS + C2D_POINT_FLAG]) == C2D_POINT_OUTSIDE;
    const std::vector<double>& alone = outside ? all : first;
    of_second += outside ? 1 : 0;
    CHECK(std::memcmp(both.data() + i * C2D_POINT_FIELDS, alone.data() + i * C2D_POINT_FIELDS,
                      C2D_POINT_FIELDS * sizeof(double)) == 0);
  }
  CHECK(of_second > 0);
  CHECK(of_second < static_cast<int>(points.size() / 2));
  for (size_t i = 0; i < points.size() / 2; i += 29) {
    const std::vector<double> one = inside(solver, 2, {points[2 * i], points[2 * i + 1]});
    CHECK(same(i, one));
    if (i % 5 == 0) inside(solver, 1, {0.1, -0.2}); // the other body's cells
  }
  Own other(deck.limits(), enough_for(deck.limits()));
  c2d_close(other.machine->solver);
  other.port.threads = 3;
  other.port.parallel_for = [](void*, int32_t n, void (*task)(void*, int32_t), void* argument) {
    for (int32_t i = n - 1; i >= 0; --i) task(argument, i);
  };
  other.machine->create(deck.limits(), &other.port);
  REQUIRE(other.machine->created == C2D_OK);
  Numbers numbers;
  const c2d_options options = compressed();
  REQUIRE(run_all(other.solver(), deck, numbers, &options) == C2D_OK);
  const std::vector<double> by_tasks = inside(other.solver(), 2, points);
  CHECK(std::memcmp(by_tasks.data(), all.data(), all.size() * sizeof(double)) == 0);
  // nor is anything left of an earlier load
  std::vector<double> now[2];
  bool moved[2] = {false, false};
  for (int k = 0; k < 2; ++k) {
    c2d_solver* const s = k == 0 ? solver : other.solver();
    const double mu = 0, load = 0.5;
    c2d_outcome outcome = C2D_REACHED;
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
    if (k == 1) inside(s, 1, {0.1, -0.2});
    now[k] = inside(s, 2, points);
    const double none = 0;
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK); // nothing has moved, or pressed
    for (const double number : inside(s, 2, {0.1, 5.0})) moved[k] = moved[k] || number != none;
  }
  CHECK_FALSE(moved[0]);
  CHECK_FALSE(moved[1]);
  CHECK(now[0] == now[1]);
  CHECK(now[0] != all);
}

TEST_CASE("compressed solver: points inside can be cancelled while cells are made and met" * doctest::skip(c2d::kSmallCode)) {
  const Deck deck = family("hertz n=260 ratio=1.05");
  Solved solved(deck, compressed());
  c2d_solver* const solver = solved.own.solver();
  const std::vector<double> points = points_about(solver, 1), all = inside(solver, 1, points);
  int cancelled = 0;
  for (int after = 0;; ++after) {
    inside(solver, 2, {0.0, 1.0}); // the cells of body 1 are to be made anew
    solved.own.chances = after;
    std::vector<double> out(all.size());
    const c2d_status status =
        c2d_interior(solver, 1, static_cast<int32_t>(points.size() / 2), points.data(), 2, out.data(), C2D_POINT_FIELDS);
    solved.own.chances = -1;
    if (status == C2D_OK) break;
    CHECK(status == C2D_ERR_CANCELLED);
    ++cancelled;
    CHECK(inside(solver, 1, points) == all);
  }
  CHECK(cancelled > 3);
}
