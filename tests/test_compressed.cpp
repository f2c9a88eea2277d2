// Compressed elimination against the dense one: solutions, reduced equations, functionals, of every kind of body.
#include "bie/integrals/batch.hpp"
#include "bie/panel.hpp"
#include "effort.hpp"
#include "elimination/cells.hpp"
#include "elimination/compressed.hpp"
#include "elimination/compressed_work.hpp"
#include "elimination/later_sides.hpp"
#include "elimination/stream.hpp"
#include "linalg/dense.hpp"
#include "linalg/interpolate.hpp"
#include "linalg/lu.hpp"
#include "model/pair_frame.hpp"
#include "model_fixture.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>
#include <vector>

using namespace fixture;

namespace {

using Numbers = std::vector<c2d::Real>;

const c2d::BatchKernel* best_batch() { return c2d::batch_for(c2d::best_instructions()); }

// One body of a model, eliminated either way on a store of its own.
struct Body {
  c2d::Model model;
  int b;
  std::vector<double> diagonal, point;
  std::vector<int32_t> twin;
  std::unique_ptr<c2d::AssemblyScratch> scratch = std::make_unique<c2d::AssemblyScratch>();
  c2d::ColumnSystem system;
  runs::RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  c2d::Tapes tapes = {};
  int32_t pivots, trailing, left;
  Numbers s; // left x trailing

  Body(ModelData& d, int body) : model(d.view()), b(body) {
    c2d::number_unknowns(model, b);
    const size_t nodes = static_cast<size_t>(model.body[b].nodes);
    diagonal.resize(4 * nodes), point.resize(2 * nodes), twin.resize(nodes);
    system = {model, b, c2d::Quadrature::accurate, diagonal.data(), point.data(), twin.data(), scratch.get(), best_batch()};
    system.some_passed_over = c2d::place_sources(system);
    c2d::fill_diagonal(system, 0, static_cast<int32_t>(nodes));
    pivots = c2d::outer_columns(model, b);
    trailing = c2d::trailing_columns(model, b);
    left = c2d::system_rows(model, b) - pivots;
    s.assign(static_cast<size_t>(left) * static_cast<size_t>(trailing), 0);
    port.context = &store;
    port.open = runs::RamStore::open, port.read = runs::RamStore::read, port.write = runs::RamStore::write;
    port.sync = runs::RamStore::sync, port.close = runs::RamStore::close;
    tapes.port = &port;
  }
  static c2d_status fill(void* context, int32_t first, int32_t count, c2d::Real* panel, int64_t ld) {
    c2d::fill_columns(static_cast<Body*>(context)->system, first, count, panel, ld);
    return C2D_OK;
  }
  static c2d_status take(void* context, int32_t first, int32_t count, const c2d::Real* rows, int64_t ld) {
    Body& own = *static_cast<Body*>(context);
    for (int32_t j = 0; j < count; ++j)
      for (int32_t i = 0; i < own.left; ++i) own.s[static_cast<size_t>(i + (first + j) * own.left)] = rows[i + j * ld];
    return C2D_OK;
  }
  // The n-th operation from now on.
  void fail(int64_t n) {
    store.done.clear();
    store.before = [n](const runs::RamStore::Operation&, size_t i) { return static_cast<int64_t>(i) == n ? 5 : 0; };
  }
  void open(const c2d::TapeUse& lower, const c2d::TapeUse& upper) {
    if (lower.blocks > 0) REQUIRE(c2d::open_tape(tapes, C2D_TAPE_LOWER, lower.blocks, lower.max_data_bytes) == C2D_OK);
    if (upper.blocks > 0) REQUIRE(c2d::open_tape(tapes, C2D_TAPE_UPPER, upper.blocks, upper.max_data_bytes) == C2D_OK);
  }
};

struct Aligned {
  std::vector<double> room;
  void* at;
  explicit Aligned(uint64_t bytes) : room(bytes / 8 + 16) {
    const uintptr_t start = reinterpret_cast<uintptr_t>(room.data());
    at = room.data() + (64 - start % 64) % 64 / 8;
  }
};

struct Dense : Body {
  c2d::EliminationPlan plan;
  Dense(ModelData& d, int body) : Body(d, body) {
    REQUIRE(c2d::plan_elimination(uint64_t{1} << 34, left + pivots, pivots, trailing, 0, plan, nullptr) == C2D_OK);
    open(c2d::lower_use(plan), c2d::upper_use(plan));
    Aligned work(c2d::elimination_bytes(plan));
    REQUIRE(c2d::eliminate(plan, {this, fill}, {this, take}, tapes, work.at, nullptr, {nullptr, nullptr}) == C2D_OK);
  }
  Numbers solve(const Numbers& coefficient) {
    Numbers x(static_cast<size_t>(pivots));
    Aligned work(c2d::back_substitution_bytes(plan));
    REQUIRE(c2d::back_substitute(plan, tapes, coefficient.data(), x.data(), work.at) == C2D_OK);
    return x;
  }
  Numbers functional(Numbers f) {
    Numbers w(static_cast<size_t>(trailing));
    Aligned work(c2d::back_substitution_bytes(plan));
    REQUIRE(c2d::transposed_functional(plan, tapes, f.data(), w.data(), work.at) == C2D_OK);
    return w;
  }
};

struct Compressed : Body {
  c2d::CompressedPlan plan;
  c2d::CompressedStats stats = {};
  c2d_status status;
  // `block_bytes` of the records' blocks, 0: as planned; `fails_at`: the operation of the store that fails, `stops_at`: the
  // cell after which the host cancels; -1: none.
  struct Trouble {
    uint64_t block_bytes = 0, bytes_beyond = 2000000;
    int64_t fails_at = -1, stops_at = -1;
    bool watched = true;
  };
  int64_t steps = 0, stops = -1;
  static c2d_status step(void* context, int32_t) {
    Compressed& own = *static_cast<Compressed*>(context);
    return own.steps++ == own.stops ? c2d_status{C2D_ERR_CANCELLED} : c2d_status{C2D_OK};
  }
  Compressed(ModelData& d, int body, int32_t rank, int32_t leaf) : Compressed(d, body, rank, leaf, Trouble()) {}
  Compressed(ModelData& d, int body, int32_t rank, int32_t leaf, const Trouble& trouble) : Body(d, body) {
    plan = c2d::plan_compressed(model, b, rank, leaf);
    const uint64_t bytes = c2d::compressed_bytes(plan) + trouble.bytes_beyond;
    REQUIRE(c2d::cut_border(bytes, plan, nullptr) == C2D_OK);
    if (trouble.block_bytes != 0) plan.block_bytes = trouble.block_bytes;
    const c2d::TapeUse lower = c2d::compressed_lower_use(plan), upper = c2d::compressed_upper_use(plan);
    open(lower, upper);
    Aligned work(bytes);
    c2d::PivotStats pivot;
    stops = trouble.stops_at;
    fail(trouble.fails_at);
    const c2d::Watch watch = {this, trouble.watched ? step : nullptr};
    status = c2d::eliminate_compressed(plan, system, {this, take}, tapes, work.at, &pivot, &stats, watch, c2d::kPlainEngine);
  }
  Numbers solve(const Numbers& coefficient) {
    Numbers x(static_cast<size_t>(pivots));
    Aligned work(c2d::compressed_back_bytes(plan));
    REQUIRE(c2d::back_substitute_compressed(plan, tapes, coefficient.data(), x.data(), work.at) == C2D_OK);
    return x;
  }
  Numbers functional(Numbers f) {
    Numbers w(static_cast<size_t>(trailing));
    Aligned work(c2d::compressed_back_bytes(plan));
    REQUIRE(c2d::compressed_functional(plan, tapes, f.data(), w.data(), work.at) == C2D_OK);
    return w;
  }
};

double largest(const Numbers& x) {
  double most = 0;
  for (c2d::Real value : x) most = std::max(most, std::fabs(static_cast<double>(value)));
  return most;
}
double difference(const Numbers& a, const Numbers& b) {
  Numbers d(a.size());
  for (size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
  return largest(d) / largest(a);
}

// Trailing coefficients at which the body's equations can be met, S c = 0: those of columns that are no pivots at random.
Numbers coefficients(const Body& body, uint32_t seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const int32_t m = body.left, n = body.trailing;
  std::vector<long double> a(body.s.begin(), body.s.end());
  const auto at = [&](int32_t i, int32_t j) -> long double& { return a[static_cast<size_t>(i + j * m)]; };
  std::vector<int32_t> pivot(static_cast<size_t>(m), -1);
  std::vector<bool> taken(static_cast<size_t>(n), false);
  for (int32_t k = 0; k < m; ++k) {
    int32_t row = k, column = -1;
    for (int32_t j = 0; j < n; ++j)
      for (int32_t i = k; i < m && !taken[static_cast<size_t>(j)]; ++i)
        if (column < 0 || std::fabs(at(i, j)) > std::fabs(at(row, column))) row = i, column = j;
    REQUIRE_MESSAGE(column >= 0, k << " of " << m << ", " << n << " columns, contact " << body.model.body[body.b].contact);
    taken[static_cast<size_t>(column)] = true;
    pivot[static_cast<size_t>(k)] = column;
    for (int32_t j = 0; j < n; ++j) std::swap(at(k, j), at(row, j));
    for (int32_t i = 0; i < m; ++i) {
      const long double factor = i == k ? 0.0L : at(i, column) / at(k, column);
      for (int32_t j = 0; j < n && factor != 0; ++j) at(i, j) -= factor * at(k, j);
    }
  }
  std::vector<long double> c(static_cast<size_t>(n), 0);
  for (int32_t j = 0; j < n; ++j)
    if (!taken[static_cast<size_t>(j)]) c[static_cast<size_t>(j)] = uniform(generator);
  for (int32_t k = 0; k < m; ++k) {
    const int32_t column = pivot[static_cast<size_t>(k)];
    long double sum = 0;
    for (int32_t j = 0; j < n; ++j)
      if (!taken[static_cast<size_t>(j)]) sum += at(k, j) * c[static_cast<size_t>(j)];
    c[static_cast<size_t>(column)] = -sum / at(k, column);
  }
  return Numbers(c.begin(), c.end());
}

// S c over the largest terms it is the sum of.
double violation(const Body& body, const Numbers& c) {
  double most = 0, terms = 0;
  for (int32_t i = 0; i < body.left; ++i) {
    double sum = 0;
    for (int32_t j = 0; j < body.trailing; ++j) {
      const double term = body.s[static_cast<size_t>(i + j * body.left)] * c[static_cast<size_t>(j)];
      sum += term;
      terms = std::max(terms, std::fabs(term));
    }
    most = std::max(most, std::fabs(sum));
  }
  return terms > 0 ? most / terms : 0;
}

struct Agreement {
  double contact, solution, functional;
  int32_t rank;
};

// Both ways, for the same tractions, displacements and loads.
Agreement compare(ModelData& d, int b, int32_t rank, int32_t leaf) {
  Dense dense(d, b);
  Compressed compressed(d, b, rank, leaf);
  Agreement out = {1, 1, 1, compressed.stats.largest_rank};
  CHECK(compressed.status == C2D_OK);
  if (compressed.status != C2D_OK) return out;
  const Numbers c = coefficients(dense, 5);
  out.contact = std::max(violation(dense, c), violation(compressed, c));
  const Numbers x = dense.solve(c), x2 = compressed.solve(c);
  out.solution = difference(x, x2);
  // Of a functional of the solution its value at solutions counts.
  Numbers f(x.size());
  for (size_t i = 0; i < f.size(); ++i) f[i] = static_cast<c2d::Real>(std::sin(1.0 + 3.0 * static_cast<double>(i)));
  const Numbers w = dense.functional(f), w2 = compressed.functional(f);
  double sum = 0, sum2 = 0, terms = 0;
  for (size_t k = 0; k < w.size(); ++k) sum += w[k] * c[k], terms += std::fabs(w[k] * c[k]), sum2 += w2[k] * c[k];
  out.functional = std::fabs(sum - sum2) / terms;
  return out;
}

// A disc, held on an eighth of its boundary, pulled on half of it.
ModelData disc(int32_t functions, int32_t element_nodes, int elements) {
  ModelData d(functions);
  Points p;
  arc_to(p, 0.3, 0.2, 1.5, 0, 360, elements * (element_nodes - 1));
  d.body(element_nodes, {p}, 2600, 0.3);
  for (int e = 1; e <= std::max(1, elements / 8); ++e)
    for (int l = 1; l <= functions; ++l) d.condition(1, e, l, "1100", 0.001, 0.0);
  for (size_t i = 0; i < d.end_traction[0].size(); i += 2)
    if (i > d.end_traction[0].size() / 2) d.end_traction[0][i] = 0.7;
  return d;
}

// Two boxes, one on the other, all of it turned, with `holes` in each; `along` elements on the side where they touch.
ModelData boxes(int32_t functions, int32_t element_nodes, int holes, int along, double turn, double nu = 0.3) {
  ModelData d(functions);
  const double c = std::cos(turn), s = std::sin(turn);
  for (int b = 0; b < 2; ++b) {
    std::vector<Points> curves;
    const auto add = [&](const Points& corners) {
      Points p;
      const size_t n = corners.size() / 2;
      for (size_t e = 0; e < n; ++e)
        for (int k = 0; k < element_nodes - 1; ++k) {
          const double at = k / (element_nodes - 1.0) + (k > 0 && e % 3 == 1 ? 0.05 : 0.0);
          const size_t next = (e + 1) % n * 2;
          const double x = corners[2 * e] + at * (corners[next] - corners[2 * e]);
          const double y = corners[2 * e + 1] + at * (corners[next + 1] - corners[2 * e + 1]);
          p.push_back(c * x - s * y);
          p.push_back(s * x + c * y);
        }
      curves.push_back(p);
    };
    add(rectangle(0, b == 0 ? -2 : 0, 3, 2, along, 2 * along / 3 + 1));
    for (int h = 0; h < holes; ++h) {
      Points hole;
      arc_to(hole, 3 * (h + 0.5) / holes, b == 0 ? -1 : 1, 0.9 / holes, 0, -360, along / 2 + h);
      add(hole);
    }
    d.body(element_nodes, curves, 1000, b == 0 ? nu : 0.45);
  }
  d.conditions(1, 1, 1, along, functions, "1100");
  const int32_t up = 2 * along / 3 + 1, first = along + up + 1; // the upper side of body 1
  if (functions == 1) {
    d.zone(along, along, first, 1, first, along, -1, along);
  } else {
    const int32_t per = functions - 1;
    d.zone(along * per + 1, along, first, 1, (first - 1) * per + 1, along, -1, along * per + 1);
  }
  d.point_load(2, c * 0.2 - s * 1.8, s * 0.2 + c * 1.8, 0.3, -1);
  return d;
}

void check_agreement(ModelData& d, int32_t rank, int32_t leaf, double tolerance) {
  const bool complete = d.complete();
  REQUIRE_MESSAGE(complete, d.all());
  for (int b = 0; b < d.view().head->bodies; ++b) {
    const Agreement a = compare(d, b, rank, leaf);
    CAPTURE(b);
    CAPTURE(a.rank);
    CHECK(a.contact < tolerance);
    CHECK(a.solution < tolerance);
    CHECK(a.functional < tolerance);
    if (std::getenv("SHOW")) MESSAGE(b << " rank " << a.rank << " " << a.contact << " " << a.solution << " " << a.functional);
  }
}

constexpr double kNear = sizeof(c2d::Real) == 8 ? 1e-10 : 2e-3;

} // namespace

namespace {

// The displacement of a body's contact unknown among all its unknowns, `stride` apart, where nodes in contact are as others.
double displacement_at(const Body& body, const c2d::Real* x, int64_t stride, int32_t unknown) {
  const c2d::Model& m = body.model;
  for (int32_t node = 0; node < m.body[body.b].nodes; ++node) {
    const c2d::PairSide at = c2d::pair_of_node(m, body.b, node);
    if (at.pair < 0) continue;
    const c2d::Pair& pair = m.pair[at.pair];
    const int32_t first = c2d::dof_on(m, pair, at.side);
    if (unknown < first || unknown > first + pair.tangential) continue;
    double sum = 0;
    for (int c = 0; c < 2; ++c) sum += c2d::along(pair, unknown - first, c) * x[c2d::outer_column(m, body.b, node, c) * stride];
    return sum;
  }
  FAIL("no node has contact unknown " << unknown);
  return 0;
}

// S_u u = S_t t, for a traction at one contact unknown.
Numbers displacements_by(const Dense& dense, const Numbers& traction) {
  const int32_t n = dense.left, own = dense.model.body[dense.b].contact;
  REQUIRE(n == own);
  Numbers a(dense.s.begin(), dense.s.begin() + n * n), u(static_cast<size_t>(n), 0), norms(static_cast<size_t>(n));
  for (int32_t j = 0; j < n; ++j)
    for (int32_t i = 0; i < n; ++i)
      u[static_cast<size_t>(i)] += dense.s[static_cast<size_t>(i + (own + j) * n)] * traction[static_cast<size_t>(j)];
  std::vector<int32_t> pivots(static_cast<size_t>(n));
  REQUIRE(c2d::lu_factor(c2d::kPlainEngine, n, a.data(), n, pivots.data(), norms.data(), nullptr) == 0);
  c2d::lu_solve(c2d::kPlainEngine, n, 1, a.data(), n, pivots.data(), u.data(), n);
  return u;
}

// Tractions on a body in contact by its reduced equations, and by right-hand sides that come later: how far they differ.
double later_differs(ModelData& d, int b, int32_t rank, int32_t leaf, int32_t count) {
  Dense dense(d, b);
  const int32_t own = dense.model.body[b].contact;
  dense.model.body[b].on_demand = 1;
  Compressed tree(d, b, rank, leaf);
  CHECK(tree.status == C2D_OK);
  REQUIRE(tree.plan.keeps == 1);
  Aligned work(c2d::later_sides_bytes(tree.plan));
  const c2d::LaterSides later = {tree.plan, tree.system, tree.tapes, work.at, c2d::kPlainEngine};
  std::vector<int32_t> unknown;
  for (int32_t k = 0; k < count; ++k) unknown.push_back((7 * k + 3) % own);
  c2d::Real* x = nullptr;
  REQUIRE(c2d::solve_unit_tractions(later, unknown.data(), count, &x) == C2D_OK);
  double most = 0, size = 0;
  Numbers all(static_cast<size_t>(own), 0), together(static_cast<size_t>(tree.pivots), 0);
  for (int32_t k = 0; k < count; ++k) {
    Numbers traction(static_cast<size_t>(own), 0);
    traction[static_cast<size_t>(unknown[static_cast<size_t>(k)])] = 1;
    all[static_cast<size_t>(unknown[static_cast<size_t>(k)])] += k - 1.5;
    const Numbers u = displacements_by(dense, traction);
    for (int32_t i = 0; i < own; ++i) {
      most = std::max(most, std::fabs(u[static_cast<size_t>(i)] - displacement_at(tree, x + k, count, i)));
      size = std::max(size, std::fabs(static_cast<double>(u[static_cast<size_t>(i)])));
    }
  }
  REQUIRE(c2d::add_tractions(later, all.data(), together.data()) == C2D_OK);
  const Numbers u = displacements_by(dense, all);
  for (int32_t i = 0; i < own; ++i)
    most = std::max(most, std::fabs(u[static_cast<size_t>(i)] - displacement_at(tree, together.data(), 1, i)) / 4);
  dense.model.body[b].on_demand = 0;
  return most / size;
}

} // namespace

TEST_CASE("compressed: what is kept for later tractions and has been spoilt, or never written, leads nowhere") {
  ModelData d = boxes(2, 2, 1, 24, 0.3);
  REQUIRE(d.complete());
  d.view().body[0].on_demand = 1;
  Compressed tree(d, 0, 160, 10);
  REQUIRE(tree.status == C2D_OK);
  Aligned work(c2d::later_sides_bytes(tree.plan));
  const c2d::LaterSides later = {tree.plan, tree.system, tree.tapes, work.at, c2d::kPlainEngine};
  const uint64_t bytes = tree.plan.block_bytes;
  const c2d::KeptPlace place = c2d::kept_place(tree.plan);
  std::vector<unsigned char> block(c2d::kBlockHeaderBytes + bytes), spoilt;
  const std::vector<int32_t> unknown = {3, 8, 20};
  Numbers all(static_cast<size_t>(tree.model.body[0].contact), 0), x(static_cast<size_t>(tree.pivots), 0);
  all[5] = 1;
  int refused = 0;
  const auto use = [&] {
    c2d::Real* columns = nullptr;
    for (const c2d_status status :
         {c2d::solve_unit_tractions(later, unknown.data(), 3, &columns), c2d::add_tractions(later, all.data(), x.data())}) {
      const bool told = status >= C2D_ERR_STORE_READ && status <= C2D_ERR_STORE_STALE;
      CHECK((status == C2D_OK || status == C2D_ERR_INTERNAL || told));
      refused += status == C2D_OK ? 0 : 1;
    }
  };
  uint64_t last = place.first_block;
  while (c2d::read_block(tree.tapes, C2D_TAPE_LOWER, last, block.data(), bytes) == C2D_OK) ++last;
  REQUIRE(last > place.first_block);
  for (uint64_t k = place.first_block; k < last; ++k) {
    REQUIRE(c2d::read_block(tree.tapes, C2D_TAPE_LOWER, k, block.data(), bytes) == C2D_OK);
    for (uint64_t at = 0; at < bytes; at += k == place.first_block && at < 900 ? 4 : 4 * (bytes / 240))
      for (int32_t number : {-7, 1 << 30, 3, 2000}) {
        spoilt = block;
        std::memcpy(spoilt.data() + c2d::kBlockHeaderBytes + at, &number, sizeof number);
        REQUIRE(c2d::write_block(tree.tapes, C2D_TAPE_LOWER, k, spoilt.data(), bytes) == C2D_OK);
        use();
      }
    REQUIRE(c2d::write_block(tree.tapes, C2D_TAPE_LOWER, k, block.data(), bytes) == C2D_OK);
  }
  CHECK(refused > 100);
  refused = 0;
  use();
  CHECK(refused == 0);
  const size_t reads = tree.store.done.size();
  use();
  const size_t operations = tree.store.done.size() - reads;
  for (size_t n = 0; n < operations; n += 1 + operations / 60) {
    CAPTURE(n);
    tree.fail(static_cast<int64_t>(n));
    refused = 0;
    use();
    CHECK(refused == 1);
  }
  d.view().body[0].on_demand = 0;
}

TEST_CASE("compressed: tractions that come later as by the reduced equations, all orders, holes, leaves") {
  for (int32_t trial = 0; trial < 12; ++trial) {
    CAPTURE(trial);
    ModelData d = boxes(1 + trial % 4, 2 + trial / 4, trial % 4, trial % 4 < 2 ? 24 : 12, 0.1 * trial);
    REQUIRE(d.complete());
    for (int32_t leaf : {1, 10, 40, 1000}) {
      CAPTURE(leaf);
      const double differs = later_differs(d, 0, leaf == 1000 ? 1000 : 400, leaf, leaf == 10 ? 48 : 5);
      if (std::getenv("SHOW")) MESSAGE(trial << " leaf " << leaf << " " << differs);
      CHECK(differs < kNear);
    }
  }
}

TEST_CASE("compressed: later tractions on a small body are those of the reduced equations") {
  ModelData d = boxes(1, 2, 0, 24, 0);
  REQUIRE(d.complete());
  CHECK(later_differs(d, 0, 400, 10, 5) < kNear);
}

TEST_CASE("compressed: a disc with elements of all orders") {
  for (int32_t functions = 1; functions <= 4; ++functions)
    for (int32_t element_nodes = 2; element_nodes <= 4; ++element_nodes) {
      CAPTURE(functions);
      CAPTURE(element_nodes);
      ModelData d = disc(functions, element_nodes, functions < 3 ? 150 : 70);
      check_agreement(d, 160, 12, kNear);
    }
}

TEST_CASE("compressed: two bodies in contact, with and without holes, all orders") {
  for (int32_t trial = 0; trial < 12; trial += test::effort(5, 1)) {
    CAPTURE(trial);
    ModelData d = boxes(1 + trial % 4, 2 + trial / 4, trial % 4, trial % 4 < 2 ? 24 : 12, 0.1 * trial);
    check_agreement(d, 160, 10, kNear);
  }
}

TEST_CASE("compressed: incompressible, with holes") {
  ModelData d = boxes(2, 2, 2, 24, 0.2, 0.5);
  check_agreement(d, 160, 10, 10 * kNear);
}

TEST_CASE("compressed: symmetry by elements") {
  ModelData d = hertz();
  check_agreement(d, 120, 6, kNear);
}

TEST_CASE("compressed: one and two lines of symmetry by images, with a hole that they cut") {
  for (int lines = 1; lines <= 2; ++lines)
    for (int32_t functions = 1; functions <= 3; ++functions) {
      CAPTURE(lines);
      CAPTURE(functions);
      ModelData d = cut_by_symmetry(lines, functions, 1, 0.3);
      check_agreement(d, 140, 8, kNear);
    }
}

TEST_CASE("compressed: leaves of any size, trees of one cell, odd numbers of nodes") {
  for (int32_t elements : {8, 9, 17, 31, 64})
    for (int32_t leaf : {1, 2, 3, 5, 100}) {
      CAPTURE(elements);
      CAPTURE(leaf);
      ModelData d = disc(2, 2, elements);
      check_agreement(d, 100, leaf, kNear);
    }
}

namespace {

// Held at its first side, pulled at the last; curves as given.
ModelData held(const std::vector<Points>& curves, int first_side, int32_t functions = 2) {
  ModelData d(functions);
  d.body(2, curves, 1000, 0.3);
  d.conditions(1, 1, 1, first_side, functions, "1100");
  const size_t ends = d.end_traction[0].size();
  for (size_t i = ends / 2; i < ends; i += 2) d.end_traction[0][i] = 0.01;
  return d;
}

// From one point to another, elements half as long from the middle towards both ends, down to `smallest` of the whole.
void graded_line(Points& p, double x0, double y0, double x1, double y1, double smallest) {
  std::vector<double> s;
  for (double at = smallest; at < 0.5; at *= 1.5) s.push_back(at);
  std::vector<double> all = {0.0};
  for (double at : s) all.push_back(at);
  for (size_t k = s.size(); k-- > 0;) all.push_back(1.0 - s[k]);
  for (double at : all) p.insert(p.end(), {x0 + (x1 - x0) * at, y0 + (y1 - y0) * at});
}

} // namespace

TEST_CASE("compressed: double nodes") {
  ModelData plain = disc(2, 2, 60);
  Points p = plain.xy[0];
  for (size_t node : {7u, 30u, 31u}) // from behind: numbers before it stay
    p.insert(p.begin() + static_cast<int64_t>(2 * (37 - node)), {p[2 * (37 - node)], p[2 * (37 - node) + 1]});
  ModelData d(2);
  d.body(2, {p}, 2600, 0.3);
  d.conditions(1, 12, 1, 18, 2, "1100");
  d.end_traction[0][100] = d.end_traction[0][102] = 0.7;
  check_agreement(d, 100, 5, kNear);
}

TEST_CASE("compressed: an element of which nothing is unknown, between two that are held") {
  ModelData d = disc(2, 2, 60);
  for (int l = 1; l <= 2; ++l) d.condition(1, 9, l, "1100", 0.002, -0.001);
  for (size_t i = 4 * 7; i < 4 * 8; ++i) d.end_traction[0][i] = 0.3; // of element 8
  check_agreement(d, 100, 5, kNear);
}

TEST_CASE("compressed: squares graded to 1e-6, thin layers, rings, many holes") {
  Points graded;
  graded_line(graded, 0, 0, 1, 0, 1e-6), graded_line(graded, 1, 0, 1, 1, 1e-6);
  graded_line(graded, 1, 1, 0, 1, 1e-6), graded_line(graded, 0, 1, 0, 0, 1e-6);
  ModelData square = held({graded}, static_cast<int>(graded.size()) / 8);
  check_agreement(square, 160, 12, 100 * kNear);
  // (Elements of the layer's thickness: a cut along the contour would leave blocks of full rank.)
  Points strip = rectangle(0, 0, 1, 0.001, 200, 1);
  ModelData layer = held({strip}, 8);
  check_agreement(layer, 160, 12, 1e4 * kNear);
  Points outer, inner;
  arc_to(outer, 0, 0, 1, 0, 360, 150);
  arc_to(inner, 0, 0, 0.7, 360, 0, 120);
  ModelData ring = held({outer, inner}, 20);
  check_agreement(ring, 160, 12, kNear);
  std::vector<Points> plate = {rectangle(0, 0, 5, 4, 50, 40)};
  for (int h = 0; h < 20; ++h) {
    Points hole;
    arc_to(hole, 0.5 + h % 5, 0.5 + h / 5, 0.3, 360, 0, 12);
    plate.push_back(hole);
  }
  ModelData holes = held(plate, 30);
  check_agreement(holes, 220, 12, kNear);
}

// The centroid of such a hole is too near its neck.
TEST_CASE("compressed: a hole with two places inside") {
  const std::vector<double> corners = {-2, -0.5, -2, 0.5,  -1, 0.5,  -1, 0.05,  1,  0.05,  1,  0.5,
                                       2,  0.5,  2,  -0.5, 1,  -0.5, 1,  -0.05, -1, -0.05, -1, -0.5};
  Points hole;
  for (size_t i = 0; i < corners.size(); i += 2) {
    const size_t next = (i + 2) % corners.size();
    line_to(hole, corners[i], corners[i + 1], corners[next], corners[next + 1], 3);
  }
  ModelData d = held({rectangle(-4, -2, 8, 4, 16, 8), hole}, 16);
  check_agreement(d, 120, 6, kNear);
  c2d::HoleWalk walk{};
  c2d::Hole found;
  REQUIRE(c2d::next_hole(d.view(), 0, walk, found));
  CHECK(found.points == 2);
}

// What a line of symmetry cuts off between two teeth of a comb is a hole of the whole body.
TEST_CASE("compressed: a body with more holes than are allowed for is eliminated dense") {
  for (const int teeth : {4, 5, 6}) {
    CAPTURE(teeth);
    ModelData d(2);
    d.head.images = 1;
    Points p = {0, 0, 3, 0, 3, 2.0 * teeth + 1};
    for (int i = teeth; i >= 0; --i) {
      p.insert(p.end(), {0, 2.0 * i + 1, 0, 2.0 * i});
      if (i > 0) p.insert(p.end(), {1, 2.0 * i, 1, 2.0 * i - 1});
    }
    p.resize(p.size() - 2); // (0, 0) is there
    d.body(2, {p});
    for (int e = 4; e <= d.bodies[0].elements; e += 4) d.conditions(1, e, 1, e, 2, "1001");
    d.conditions(1, 1, 1, 1, 2, "1100");
    const bool complete = d.complete();
    REQUIRE_MESSAGE(complete, d.all());
    CHECK(c2d::may_compress(d.view(), 0) == (teeth <= c2d::most_holes(1)));
  }
}

TEST_CASE("compressed: ranks beyond what is allowed for, and memory below what is needed") {
  ModelData d = disc(2, 2, 100);
  REQUIRE(d.complete());
  const Compressed compressed(d, 0, 20, 8);
  CHECK(compressed.status == C2D_ERR_MEMORY);
  CHECK(compressed.stats.largest_rank == 21);
  c2d::CompressedPlan plan = c2d::plan_compressed(compressed.model, 0, 20, 8);
  uint64_t needed = 0;
  CHECK(c2d::cut_border(1000, plan, &needed) == C2D_ERR_MEMORY);
  CHECK(c2d::cut_border(needed - 1, plan, &needed) == C2D_ERR_MEMORY);
  CHECK(c2d::cut_border(needed, plan, nullptr) == C2D_OK);
  CHECK(c2d::compressed_bytes(plan) <= needed);
}

// A border of one column at a time: no panel holds both the last load case and the noise, or all of what is left of a chunk.
TEST_CASE("compressed: in the least memory") {
  ModelData d = boxes(2, 2, 1, 24, 0.3);
  REQUIRE(d.complete());
  for (int b = 0; b < 2; ++b) {
    Dense dense(d, b);
    Compressed::Trouble least;
    least.bytes_beyond = 0;
    Compressed compressed(d, b, 120, 8, least);
    REQUIRE(compressed.status == C2D_OK);
    CHECK(compressed.plan.border.panel_columns == 1);
    const Numbers c = coefficients(dense, 7);
    CHECK(violation(compressed, c) < kNear);
    CHECK(difference(dense.solve(c), compressed.solve(c)) < kNear);
    const Numbers f(static_cast<size_t>(compressed.pivots), 1);
    Numbers same = f; // no functional asked for
    Aligned work(c2d::compressed_back_bytes(compressed.plan));
    CHECK(c2d::compressed_functional(compressed.plan, compressed.tapes, same.data(), nullptr, work.at) == C2D_OK);
    CHECK(same == f);
  }
}

// Of a body nearly all of whose nodes are in contact the border is what is large.
TEST_CASE("compressed: nobody need watch") {
  ModelData d = disc(2, 2, 60);
  REQUIRE(d.complete());
  Compressed::Trouble trouble;
  Compressed watched(d, 0, 100, 5, trouble);
  trouble.watched = false;
  Compressed alone(d, 0, 100, 5, trouble);
  REQUIRE(alone.status == C2D_OK);
  CHECK(watched.steps > 5);
  CHECK(alone.steps == 0);
  CHECK(alone.s == watched.s);
}

TEST_CASE("compressed: a node whose equations say nothing makes a body singular") {
  ModelData d = disc(2, 2, 60);
  REQUIRE(d.complete());
  Compressed whole(d, 0, 100, 5);
  REQUIRE(whole.status == C2D_OK);
  whole.twin[30] = c2d::kAxisNode; // passed over
  whole.system.some_passed_over = true;
  c2d::PivotStats pivot;
  Aligned work(c2d::compressed_bytes(whole.plan));
  CHECK(c2d::eliminate_compressed(whole.plan, whole.system, {&whole, Body::take}, whole.tapes, work.at, &pivot, &whole.stats,
                                  {nullptr, nullptr}, c2d::kPlainEngine) == C2D_ERR_SINGULAR);
}

TEST_CASE("compressed: sizes that no machine has are told as such") {
  ModelData d = disc(2, 2, 60);
  REQUIRE(d.complete());
  const c2d::CompressedPlan plan = c2d::plan_compressed(d.view(), 0, 100, 5);
  c2d::CompressedPlan long_blocks = plan, wide_border = plan;
  long_blocks.block_bytes = UINT64_MAX - 200;
  wide_border.border.panel_columns = wide_border.border.rows = INT32_MAX;
  for (const auto bytes : {c2d::compressed_bytes, c2d::compressed_back_bytes, c2d::compressed_check_bytes}) {
    CHECK(bytes(plan) < uint64_t{1} << 32);
    CHECK(bytes(long_blocks) == UINT64_MAX);
  }
  CHECK(c2d::compressed_bytes(wide_border) == UINT64_MAX);
}

TEST_CASE("compressed: plans for bodies that are large, or nearly all in contact") {
  const c2d::CompressedPlan wide = c2d::plan_compressed(c2d::CompressedLimits{1, 100000, 200000, 1, 0, 0}, 160, 12);
  const uint64_t rows = static_cast<uint64_t>(wide.border.rows), pivots = static_cast<uint64_t>(wide.border.pivots);
  CHECK(rows > 200000);
  CHECK(wide.block_bytes >= rows * sizeof(c2d::Real)); // a column of the border is not cut
  CHECK(c2d::block_numbers(wide) >= static_cast<int64_t>(4 * rows));
  CHECK(c2d::compressed_back_bytes(wide) >= pivots * (sizeof(c2d::Real) + sizeof(int32_t)));
  CHECK(c2d::compressed_bytes(wide) > c2d::compressed_back_bytes(wide));
  const c2d::CompressedPlan huge = c2d::plan_compressed(c2d::CompressedLimits{1 << 29, 0, 0, 1, 0, 0}, (1 << 29) - 16, 12);
  CHECK(c2d::compressed_bytes(huge) == UINT64_MAX); // n^2 numbers, n = 2^30, more than once
}

TEST_CASE("compressed: a border is known by each of its numbers") {
  ModelData d = disc(2, 2, 100);
  REQUIRE(d.complete());
  c2d::Model m = d.view();
  c2d::number_unknowns(m, 0);
  const c2d::EliminationPlan border = c2d::plan_compressed(m, 0, 20, c2d::kLeafNodes).border;
  REQUIRE(c2d::is_border(m, 0, border));
  c2d::EliminationPlan other = border;
  other.rank = 0;
  CHECK_FALSE(c2d::is_border(m, 0, other));
  d.bodies[0].rigid = 1;
  CHECK_FALSE(c2d::is_border(d.view(), 0, border));
}

// The least of a work area counts blocks of 32 KB; where wide columns of the border make them longer, less is left for panels.
TEST_CASE("compressed: whatever the memory, the plan fits into it") {
  ModelData d = disc(2, 2, 2300);
  REQUIRE(d.complete());
  const c2d::Model m = d.view();
  c2d::number_unknowns(m, 0);
  for (int32_t rank : {60, 2200}) {
    const c2d::CompressedPlan narrow = c2d::plan_compressed(m, 0, rank, 8);
    const uint64_t least = c2d::compressed_bytes(narrow);
    int32_t before = 0;
    for (uint64_t beyond = 0; beyond < uint64_t{1} << 28; beyond = 2 * beyond + 50000) {
      CAPTURE(rank);
      CAPTURE(beyond);
      c2d::CompressedPlan plan = narrow;
      CHECK(c2d::cut_border(least + beyond, plan, nullptr) == C2D_OK);
      CHECK(c2d::compressed_bytes(plan) <= least + beyond);
      CHECK(plan.border.panel_columns >= before);
      before = plan.border.panel_columns;
    }
    CHECK(before > 1);
  }
}

// Right-hand sides of 1 and -1: so much is left in as many rows as there are unknowns.
TEST_CASE("compressed: what equations make of noise") {
  ModelData d = disc(2, 2, 200); // so many that cells are eliminated
  REQUIRE(d.complete());
  Compressed compressed(d, 0, 160, 8);
  REQUIRE(compressed.status == C2D_OK);
  Numbers x(static_cast<size_t>(compressed.pivots));
  Aligned work(c2d::compressed_back_bytes(compressed.plan));
  REQUIRE(c2d::substitute_noise(compressed.plan, compressed.tapes, x.data(), work.at) == C2D_OK);
  const int32_t rows = c2d::system_rows(compressed.model, 0);
  Numbers a(static_cast<size_t>(rows) * static_cast<size_t>(compressed.pivots));
  c2d::fill_columns(compressed.system, 0, compressed.pivots, a.data(), rows);
  int32_t met = 0, positive = 0;
  for (int32_t i = 0; i < rows; ++i) {
    double sum = 0;
    for (int32_t j = 0; j < compressed.pivots; ++j)
      sum += a[static_cast<size_t>(i) + static_cast<size_t>(j) * static_cast<size_t>(rows)] * x[static_cast<size_t>(j)];
    met += std::fabs(std::fabs(sum) - 1) < 1e4 * kNear ? 1 : 0;
    positive += sum > 0 ? 1 : 0;
  }
  CHECK(met >= compressed.pivots);
  CHECK(positive > rows / 4);
  CHECK(positive < 3 * rows / 4);
}

// Few nodes beside those in contact: the border asks for more room than the cells.
TEST_CASE("compressed: a ring that touches all round") {
  ModelData d(2);
  const int n = 100;
  Points hole, outer, inner;
  arc_to(outer, 0, 0, 2, 0, 360, 40);
  arc_to(hole, 0, 0, 1, 360, 0, n);
  arc_to(inner, 0, 0, 1, 0, 360, n);
  d.body(2, {outer, hole}, 1000, 0.3);
  d.body(2, {inner}, 1000, 0.3);
  d.conditions(1, 1, 1, 10, 2, "1100");
  d.zone(n, n, 41, 1, 41, n, -1, 1);
  d.point_load(2, 0.1, 0.2, 0.3, -1);
  const bool complete = d.complete();
  REQUIRE_MESSAGE(complete, d.all());
  const Agreement a = compare(d, 0, 40, 4);
  CHECK(a.contact < kNear);
  CHECK(a.solution < kNear);
  CHECK(a.functional < kNear);
}

// Bytes over block boundaries come back as they were; what does not fit is refused, once and for all.
TEST_CASE("compressed: streams of records") {
  for (uint64_t block_bytes : {64u, 192u}) {
    runs::RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    port.context = &store;
    port.open = runs::RamStore::open, port.read = runs::RamStore::read, port.write = runs::RamStore::write;
    port.sync = runs::RamStore::sync, port.close = runs::RamStore::close;
    c2d::Tapes tapes = {};
    tapes.port = &port;
    REQUIRE(c2d::open_tape(tapes, C2D_TAPE_UPPER, 5, block_bytes) == C2D_OK);
    std::vector<char> buffer(c2d::kBlockHeaderBytes + block_bytes), own(c2d::kBlockHeaderBytes + block_bytes);
    c2d::Stream out = c2d::open_stream(tapes, C2D_TAPE_UPPER, 1, 3, block_bytes, buffer.data());
    std::vector<unsigned char> data(3 * block_bytes);
    for (size_t i = 0; i < data.size(); ++i) data[i] = static_cast<unsigned char>(7 * i + 1);
    CHECK(c2d::finish_block(out) == C2D_OK); // nothing there
    CHECK(out.end == 0);
    c2d::append(out, data.data(), block_bytes + 10);
    CHECK(c2d::finish_block(out) == C2D_OK);
    CHECK(out.end == 2 * block_bytes);
    CHECK(c2d::finish_block(out) == C2D_OK);
    CHECK(out.end == 2 * block_bytes);
    c2d::append(out, data.data(), block_bytes);
    CHECK(out.status == C2D_OK);
    c2d::append(out, data.data(), 1);
    CHECK(out.status == C2D_ERR_MEMORY);
    CHECK(c2d::finish_block(out) == C2D_ERR_MEMORY);
    CHECK(out.end == 3 * block_bytes);
    c2d::Stream in = c2d::open_stream(tapes, C2D_TAPE_UPPER, 1, 3, block_bytes, own.data());
    std::vector<unsigned char> back(block_bytes + 10);
    CHECK(c2d::read_at(in, 0, back.data(), back.size()) == C2D_OK);
    CHECK(std::equal(back.begin(), back.end(), data.begin()));
    CHECK(c2d::read_at(in, 2 * block_bytes, back.data(), block_bytes) == C2D_OK);
    CHECK(std::equal(back.begin(), back.begin() + static_cast<int64_t>(block_bytes), data.begin()));
  }
}

namespace {

// So few nodes that the equations of all of them are looked at; those at two corners of a hole are double.
ModelData with_double_nodes() {
  Points hole = {1, 1, 1, 1, 1, 1.5, 1, 2, 1.5, 2, 2, 2, 2, 2, 2, 1.5, 2, 1, 1.5, 1};
  return held({rectangle(0, 0, 3, 3, 3, 3), hole}, 3);
}

} // namespace

// Equations assembled anew, of the dense form, at the true solution and beside it.
TEST_CASE("compressed: what a solution leaves of the equations is seen") {
  for (int32_t holes : {0, 2, -1}) {
    ModelData d = holes < 0 ? with_double_nodes() : boxes(2, 2, holes, 60, 0.1);
    REQUIRE(d.complete());
    for (int b = 0; b < d.head.bodies; ++b) {
      CAPTURE(holes);
      CAPTURE(b);
      Dense dense(d, b);
      Compressed compressed(d, b, 160, 12);
      REQUIRE(compressed.status == C2D_OK);
      const Numbers c = coefficients(dense, 3);
      Numbers x = dense.solve(c);
      Aligned work(c2d::compressed_check_bytes(compressed.plan));
      c2d::ColumnSystem system = compressed.system;
      system.diagonal = system.point = nullptr;
      system.twin = nullptr;
      c2d::Remainder left;
      const auto check = [&] {
        REQUIRE(c2d::check_compressed(compressed.plan, system, compressed.tapes, c.data(), x.data(), work.at, &left) == C2D_OK);
        return left.relative;
      };
      CHECK(check() < kNear);
      CHECK(left.mean <= largest(x));
      // Whatever unknown is wrong by a thousandth of the largest, some equation tells.
      for (size_t j = 0; j < x.size(); j += 1 + x.size() / 20) {
        CAPTURE(j);
        const c2d::Real kept = x[j];
        x[j] += largest(x) / 1000;
        CHECK(check() > 1e-7);
        x[j] = kept;
      }
    }
  }
}

// Blocks are whole and sealed, and what stands in them is not what was written.
TEST_CASE("compressed: records of a stranger lead nowhere") {
  ModelData d = disc(2, 2, 100);
  REQUIRE(d.complete());
  Compressed::Trouble trouble;
  trouble.block_bytes = 1024;
  Compressed compressed(d, 0, 100, 8, trouble);
  REQUIRE(compressed.status == C2D_OK);
  const c2d::CompressedPlan& plan = compressed.plan;
  const uint64_t first = c2d::most_upper_use(plan.border).blocks;
  Numbers x(static_cast<size_t>(compressed.pivots)), w(static_cast<size_t>(compressed.trailing));
  const Numbers c(w.size(), 0);
  Aligned work(std::max(c2d::compressed_back_bytes(plan), c2d::compressed_check_bytes(plan)));
  int refused = 0;
  const auto use = [&] {
    Numbers f(x.size(), 1);
    c2d::Remainder left;
    for (const c2d_status status :
         {c2d::back_substitute_compressed(plan, compressed.tapes, c.data(), x.data(), work.at),
          c2d::compressed_functional(plan, compressed.tapes, f.data(), w.data(), work.at),
          c2d::check_compressed(plan, compressed.system, compressed.tapes, c.data(), x.data(), work.at, &left)}) {
      const bool told = status >= C2D_ERR_STORE_READ && status <= C2D_ERR_STORE_STALE; // of blocks that never were written
      CHECK((status == C2D_OK || status == C2D_ERR_INTERNAL || told));
      refused += status == C2D_OK ? 0 : 1;
    }
  };
  std::vector<unsigned char> block(c2d::kBlockHeaderBytes + 1024), spoilt;
  uint64_t last = first + 1;
  while (c2d::read_block(compressed.tapes, C2D_TAPE_UPPER, last, block.data(), 1024) == C2D_OK) ++last;
  for (uint64_t k = first; k < last; k += k == first + 29 && last > first + 36 ? last - k - 6 : 1) { // the border's come last
    const uint64_t bytes = k == first ? 64 : 1024; // that tells where the records end
    REQUIRE(c2d::read_block(compressed.tapes, C2D_TAPE_UPPER, k, block.data(), bytes) == C2D_OK);
    for (uint64_t at = 0; at < bytes; at += 4 + bytes / 32)
      for (int32_t number : {-7, 1 << 30, 3, 2000}) {
        spoilt = block;
        std::memcpy(spoilt.data() + c2d::kBlockHeaderBytes + at, &number, sizeof number);
        REQUIRE(c2d::write_block(compressed.tapes, C2D_TAPE_UPPER, k, spoilt.data(), bytes) == C2D_OK);
        use();
      }
    REQUIRE(c2d::write_block(compressed.tapes, C2D_TAPE_UPPER, k, block.data(), bytes) == C2D_OK);
  }
  CHECK(refused > 100);
  refused = 0;
  use();
  CHECK(refused == 0);
}

namespace {

// A body whose records are spoilt where they lie, read by back substitution with no load.
struct Spoilt {
  ModelData d;
  Compressed::Trouble trouble;
  std::unique_ptr<Compressed> own;
  std::vector<char> buffer;
  uint64_t end = 0;
  c2d::Stream records;
  Numbers x, c;
  std::unique_ptr<Aligned> work;

  Spoilt(int nodes, int32_t rank, int32_t leaf, uint64_t block_bytes) : d(disc(2, 2, nodes)) {
    REQUIRE(d.complete());
    trouble.block_bytes = block_bytes;
    own = std::make_unique<Compressed>(d, 0, rank, leaf, trouble);
    REQUIRE(own->status == C2D_OK);
    buffer.resize(c2d::kBlockHeaderBytes + block_bytes);
    records = c2d::open_records(own->plan, own->tapes, buffer.data(), &end);
    x.resize(static_cast<size_t>(own->pivots));
    c.resize(static_cast<size_t>(own->trailing));
    work = std::make_unique<Aligned>(bytes() + end);
  }
  uint64_t bytes() const { return c2d::compressed_back_bytes(own->plan); }
  c2d_status back() { return c2d::back_substitute_compressed(own->plan, own->tapes, c.data(), x.data(), work->at); }
  void tell(uint64_t at, uint64_t told) { // of a length among the records
    const uint64_t size = trouble.block_bytes, place = at % size, block = records.first_block + at / size;
    REQUIRE(place + sizeof told <= size);
    REQUIRE(c2d::read_block(own->tapes, C2D_TAPE_UPPER, block, buffer.data(), size) == C2D_OK);
    std::memcpy(buffer.data() + c2d::kBlockHeaderBytes + place, &told, sizeof told);
    REQUIRE(c2d::write_block(own->tapes, C2D_TAPE_UPPER, block, buffer.data(), size) == C2D_OK);
  }
  void tell_end(uint64_t told) {
    std::memcpy(buffer.data() + c2d::kBlockHeaderBytes, &told, sizeof told);
    REQUIRE(c2d::write_block(own->tapes, C2D_TAPE_UPPER, records.first_block - 1, buffer.data(), c2d::kEndBytes) == C2D_OK);
  }
};

} // namespace

// What the length of the first record says reaches beyond it, where the samples are.
TEST_CASE("compressed: a record that begins before the first one is none") {
  Spoilt r(100, 100, 8, 8192);
  const uint64_t first = c2d::sample_bytes(r.own->plan);
  uint64_t end = r.end, length = 0;
  while (end > first) { // from the last one on
    REQUIRE(c2d::read_at(r.records, end - sizeof length, &length, sizeof length) == C2D_OK);
    end -= length + sizeof length;
  }
  REQUIRE(end == first);
  const uint64_t at = end + length;
  const auto back = [&](uint64_t told) {
    r.tell(at, told);
    return r.back();
  };
  CHECK(back(at + sizeof length) == C2D_ERR_INTERNAL);
  CHECK(back(at + sizeof length - 1) == C2D_ERR_INTERNAL);
  CHECK(back(length) == C2D_OK);
}

// Neither leads out of the records, or of the work area.
TEST_CASE("compressed: records that end behind the tape, and one as long as all of them, are none") {
  Spoilt r(600, 130, 4, 1024);
  CHECK(r.records.first_block + r.records.blocks == c2d::compressed_upper_use(r.own->plan).blocks);
  CHECK(r.back() == C2D_OK);
  r.tell_end(r.records.blocks * r.trouble.block_bytes + sizeof r.end);
  CHECK(r.back() == C2D_ERR_INTERNAL);
  r.tell_end(r.end);
  CHECK(r.back() == C2D_OK);
  const uint64_t at = r.end - sizeof r.end;
  REQUIRE(at > 2 * sizeof(double) * static_cast<uint64_t>(c2d::record_numbers(r.own->plan)));
  r.tell(at, at);
  unsigned char* behind = static_cast<unsigned char*>(r.work->at) + r.bytes();
  std::memset(behind, 0x5a, r.end);
  CHECK(r.back() == C2D_ERR_INTERNAL);
  CHECK(std::all_of(behind, behind + r.end, [](unsigned char byte) { return byte == 0x5a; }));
}

// They decide what is looked at as it is: too wide a circle costs time, too narrow a one digits.
TEST_CASE("compressed: circles round cells hold their points and what reaches from them, and are no wider") {
  ModelData d = disc(2, 2, 64);
  REQUIRE(d.complete());
  Body body(d, 0);
  const c2d::CompressedPlan plan = c2d::plan_compressed(body.model, 0, 100, 16);
  c2d::Compression t{plan, body.system, {}, c2d::kPlainEngine, 2, 0, nullptr, nullptr, {}, {}, {}, {}};
  std::vector<int32_t> ids(128), begin = {0, 32, 64, 96, 128};
  for (int32_t k = 0; k < 128; ++k) ids[static_cast<size_t>(k)] = k;
  std::vector<double> circle(12), reach(64, 0.05);
  t.w.rows[0] = t.w.columns[0] = ids.data();
  t.w.row_begin[0] = t.w.column_begin[0] = begin.data();
  t.w.circle = circle.data();
  t.w.reach = reach.data();
  c2d::place_circles(t, c2d::Depth{4, 0});
  for (size_t cell = 0; cell < 4; ++cell) {
    double farthest = 0;
    for (size_t node = 16 * cell; node < 16 * cell + 16; ++node)
      farthest = std::max(farthest,
                          std::hypot(body.point[2 * node] - circle[3 * cell], body.point[2 * node + 1] - circle[3 * cell + 1]));
    CHECK(circle[3 * cell + 2] == doctest::Approx(farthest + 0.05).epsilon(1e-12));
  }
}

namespace {

// All of a disc as one cell, held all round, beside a body that sets the unit of length.
struct OneCell {
  static constexpr int32_t kNodes = 80, kIds = 2 * kNodes;
  ModelData data{2};
  std::unique_ptr<Body> body;
  c2d::CompressedPlan plan;
  std::unique_ptr<Aligned> work;
  std::unique_ptr<c2d::Compression> t;
  OneCell() {
    Points p;
    for (int i = 0; i < kNodes; ++i) {
      const double angle = 360.0 / kNodes * (i + 0.3 * std::sin(7.0 * i * i)); // no two elements alike
      arc_to(p, 0, 0, 0.5, angle, angle, 1);
    }
    data.body(2, {p});
    data.body(2, {rectangle(1, 1, 4, 4, 1, 1)});
    data.conditions(1, 1, 1, kNodes, 2, "1100");
    data.conditions(2, 1, 1, 4, 2, "1100");
    REQUIRE(data.complete());
    body = std::make_unique<Body>(data, 0);
    plan = c2d::plan_compressed(body->model, 0, kIds, kNodes);
    work = std::make_unique<Aligned>(c2d::compressed_bytes(plan));
    t.reset(new c2d::Compression{plan, body->system, {}, c2d::kPlainEngine, 0, 0, nullptr, nullptr, {}, {}, {}, {}});
    c2d::CompressedWork& w = t->w;
    c2d::lay_out_work(plan, static_cast<char*>(work->at), &w);
    for (int32_t node = 0; node < kNodes; ++node) w.position[node] = w.stamp[node] = w.hole_at[node] = -1;
    for (int32_t j = 0; j < plan.columns; ++j) w.place[j] = -1;
    for (int32_t k = 0; k < kIds; ++k) w.rows[0][k] = w.columns[0][k] = k;
    w.row_begin[0][0] = w.column_begin[0][0] = 0;
    w.row_begin[0][1] = w.column_begin[0][1] = kIds;
  }
  void set_circle(double radius) { t->w.circle[0] = 0, t->w.circle[1] = 0, t->w.circle[2] = radius; }
  // One of the three rigid motions, at each row.
  Numbers motion(int which) const {
    Numbers of;
    for (size_t k = 0; k < kIds; ++k) {
      const double x = body->point[k / 2 * 2], y = body->point[k / 2 * 2 + 1];
      of.push_back(static_cast<c2d::Real>(which < 2 ? (k % 2 == static_cast<size_t>(which) ? 1 : 0) : k % 2 == 0 ? y : -x));
    }
    return of;
  }
  // What each column adds to one of the three balances.
  Numbers balance(size_t which) const {
    std::vector<int32_t> place(static_cast<size_t>(plan.columns), -1), elements;
    for (int32_t k = 0; k < kIds; ++k) place[static_cast<size_t>(c2d::column_of(*t, k))] = k;
    for (int32_t e = 0; e < kNodes; ++e) elements.push_back(e);
    Numbers all(3 * kIds), of;
    c2d::fill_balances(body->system, {place.data(), kIds, elements.data(), kNodes}, all.data(), 3);
    for (size_t k = 0; k < kIds; ++k) of.push_back(all[3 * k + which]);
    return of;
  }
};

// How far numbers of those that are left out are off the combinations of those that are kept, over the largest number.
double off_combinations(const Numbers& of, int32_t kept, const int32_t* order, const c2d::Real* x) {
  double most = 0;
  for (int32_t j = 0; j < static_cast<int32_t>(of.size()) - kept; ++j) {
    double sum = of[static_cast<size_t>(order[kept + j])];
    for (int32_t i = 0; i < kept; ++i) sum -= of[static_cast<size_t>(order[i])] * x[i + j * kept];
    most = std::max(most, std::fabs(sum));
  }
  return most / largest(of);
}

} // namespace

// Forces that are the same all along a circle of radius exp(1 / (2 kappa)) move nothing inside, and displacements of it do not
// tell the force that acts inside: without motions and balances of their own cells in such circles would lose them.
TEST_CASE("compressed: what stands for a cell has its rigid motions and its forces, whatever circle is round it") {
  OneCell cell;
  const c2d::CompressedWork& w = cell.t->w;
  const double silent = std::exp(0.5 / (3 - 4 * 0.3));
  for (const double size : {0.8, 1.0, 1.25}) {
    CAPTURE(size);
    cell.set_circle(size * silent / c2d::kProxyRadius);
    const int32_t rows = c2d::choose_rows(*cell.t, c2d::Depth{1, 0}, 0);
    REQUIRE(rows < cell.plan.rank);
    for (int i = 0; i < 3; ++i) CHECK(off_combinations(cell.motion(i), rows, w.row_order, w.row_x) < kNear);
    const int32_t columns = c2d::choose_columns(*cell.t, c2d::Depth{1, 0}, 0);
    REQUIRE(columns < cell.plan.rank);
    for (size_t i = 0; i < 3; ++i) CHECK(off_combinations(cell.balance(i), columns, w.column_order, w.column_x) < kNear);
  }
}

// Leaves that are full, and of which nothing can be left out.
TEST_CASE("compressed: tapes have room for all that cells hand on, for every load case") {
  for (int32_t loads : {1, 9}) {
    ModelData d = disc(2, 2, 64);
    REQUIRE(d.complete());
    d.head.load_cases = loads; // (the lists of the fixture are those of one)
    c2d::CompressedPlan plan = c2d::plan_compressed(d.view(), 0, 100, 8);
    plan.block_bytes = 512;
    // Of 8 cells of 16 unknowns: 16 x 16 twice, right-hand sides twice, in doubles; 4 of 32, 2 of 64.
    uint64_t least = 0;
    for (uint64_t k : {16u, 32u, 64u})
      least += 128 / k * (2 * k * k + 2 * k * static_cast<uint64_t>(loads + 1)) * sizeof(double);
    CHECK(c2d::compressed_lower_use(plan).blocks * 512 >= least);
    CHECK(c2d::compressed_lower_use(plan).blocks * 512 <= 2 * least + 40000);
  }
}

// Records in blocks of 512 bytes, so that each piece of them is written and read by itself.
TEST_CASE("compressed: every operation of the store fails, and the host cancels after any cell") {
  ModelData d = boxes(1, 2, 0, 8, 0.1);
  REQUIRE(d.complete());
  Compressed::Trouble trouble;
  trouble.block_bytes = 512;
  Compressed clean(d, 0, 60, 4, trouble);
  REQUIRE(clean.status == C2D_OK);
  const int64_t operations = static_cast<int64_t>(clean.store.done.size()), cells = clean.steps;
  REQUIRE(operations > 50);
  REQUIRE(cells > 2);
  const auto kind = [&](int64_t n) {
    return clean.store.done[static_cast<size_t>(n)].kind == 'r' ? C2D_ERR_STORE_READ : C2D_ERR_STORE_WRITE;
  };
  for (int64_t n = 0; n < operations; n += 1 + operations / 400) {
    CAPTURE(n);
    trouble.fails_at = n;
    CHECK(Compressed(d, 0, 60, 4, trouble).status == kind(n));
  }
  trouble.fails_at = -1;
  for (int64_t n = 0; n < cells; n += 3) {
    trouble.stops_at = n;
    CHECK(Compressed(d, 0, 60, 4, trouble).status == C2D_ERR_CANCELLED);
  }
  // And what reads the records.
  Numbers x(static_cast<size_t>(clean.pivots)), f(x.size(), 1), w(static_cast<size_t>(clean.trailing));
  const Numbers c(w.size(), 0);
  Aligned work(c2d::compressed_back_bytes(clean.plan));
  Aligned room(c2d::compressed_check_bytes(clean.plan));
  const auto back = [&](int which) {
    c2d::Remainder left;
    if (which == 2) return c2d::check_compressed(clean.plan, clean.system, clean.tapes, c.data(), x.data(), room.at, &left);
    if (which == 0) return c2d::back_substitute_compressed(clean.plan, clean.tapes, c.data(), x.data(), work.at);
    Numbers own = f;
    return c2d::compressed_functional(clean.plan, clean.tapes, own.data(), w.data(), work.at);
  };
  for (const int which : {0, 1, 2}) {
    CAPTURE(which);
    clean.fail(-1);
    REQUIRE(back(which) == C2D_OK);
    const int64_t reads = static_cast<int64_t>(clean.store.done.size());
    REQUIRE(reads > (which == 2 ? 0 : 3));
    for (int64_t n = 0; n < reads; ++n) {
      clean.fail(n);
      CHECK(back(which) == C2D_ERR_STORE_READ);
    }
    clean.fail(-1);
    CHECK(back(which) == C2D_OK);
  }
}

TEST_CASE("compressed: what is nothing but round-off below the smallest number has no column to keep") {
  constexpr c2d::Real kLeast = std::numeric_limits<c2d::Real>::min();
  for (const c2d::Real size : {c2d::Real(0), kLeast, std::sqrt(kLeast) / 4}) { // of the last the square is below it, and not 0
    Numbers a(12, size), w(static_cast<size_t>(c2d::rows_to_keep(4, 3) * 3)), x(15), norms(15);
    int32_t order[3];
    c2d::SampleSum sum = c2d::begin_samples(w.data(), 3, 4);
    for (int32_t i = 0; i < 4; ++i) c2d::add_sample(sum, a.data() + 3 * i, 1, false);
    CHECK(c2d::interpolate(sum, 1e-6, false, 3, order, norms.data(), x.data()) == 0);
  }
}

TEST_CASE("compressed: samples are divided by their own largest entry, however far apart their numbers lie") {
  for (int64_t step : {1, 3}) {
    const c2d::Real numbers[] = {2, 100, 3, -8, 200, 5, 4, 300, 7};
    const c2d::Real known[2][3] = {{c2d::Real(0.02), 1, c2d::Real(0.03)}, {c2d::Real(0.25), -1, c2d::Real(0.5)}};
    c2d::Real w[3];
    c2d::SampleSum sum = c2d::begin_samples(w, 3, 1);
    c2d::add_sample(sum, numbers, step, true);
    for (int j = 0; j < 3; ++j) CHECK(static_cast<double>(w[j]) == doctest::Approx(static_cast<double>(known[step / 3][j])));
  }
}

TEST_CASE("compressed: interpolation finds the columns that others are combinations of") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  const double tolerance = sizeof(c2d::Real) == 8 ? 1e-12 : 1e-5;
  for (int32_t columns : {1, 2, 7, 40})
    for (int32_t rank : {0, 1, 5, 40})
      for (int32_t samples : {1, 30, 400})
        for (int turn = 0; turn < 4; ++turn) {
          const bool relative = turn % 2 == 1;
          const c2d::Kernel* const kernel = turn < 2 ? nullptr : c2d::kernel_for(c2d::best_instructions());
          CAPTURE(columns);
          CAPTURE(rank);
          CAPTURE(samples);
          Numbers left(static_cast<size_t>(samples * rank)), right(static_cast<size_t>(rank * columns)), a;
          for (c2d::Real& x : left) x = static_cast<c2d::Real>(any(random));
          for (c2d::Real& x : right) x = static_cast<c2d::Real>(any(random));
          for (int32_t i = 0; i < samples; ++i)
            for (int32_t j = 0; j < columns; ++j) {
              c2d::Real sum = 0;
              for (int32_t k = 0; k < rank; ++k)
                sum += left[static_cast<size_t>(i * rank + k)] * right[static_cast<size_t>(k * columns + j)];
              a.push_back(sum);
            }
          const int32_t kept = c2d::rows_to_keep(samples, columns), least = std::min(std::min(rank, columns), samples);
          Numbers w(static_cast<size_t>(kept * columns)), x(static_cast<size_t>(columns * (columns + 2))), norms(x.size());
          std::vector<int32_t> order(static_cast<size_t>(columns));
          c2d::SampleSum sum = c2d::begin_samples(w.data(), columns, samples, kernel);
          for (int32_t i = 0; i < samples; ++i) c2d::add_sample(sum, a.data() + i * columns, 1, false);
          const int32_t k = c2d::interpolate(sum, tolerance, relative, columns, order.data(), norms.data(), x.data());
          CHECK(k == least);
          double worst = 0;
          for (int32_t i = 0; i < samples; ++i)
            for (int32_t j = 0; j < columns - k; ++j) {
              double found = 0;
              for (int32_t c = 0; c < k; ++c)
                found +=
                    a[static_cast<size_t>(i * columns + order[static_cast<size_t>(c)])] * x[static_cast<size_t>(c + j * k)];
              worst =
                  std::max(worst, std::fabs(found - a[static_cast<size_t>(i * columns + order[static_cast<size_t>(k + j)])]));
            }
          CHECK(worst < 1e3 * tolerance);
          if (least > 1) { // fewer than are needed
            c2d::SampleSum again = c2d::begin_samples(w.data(), columns, samples, kernel);
            for (int32_t i = 0; i < samples; ++i) c2d::add_sample(again, a.data() + i * columns, 1, true);
            CHECK(c2d::interpolate(again, tolerance, relative, least - 1, order.data(), norms.data(), x.data()) == least);
          }
        }
}

TEST_CASE("compressed: cells of a thin layer are cut across both its faces, at their middle") {
  constexpr int32_t kFace = 64;
  std::vector<double> point;
  std::vector<int32_t> order, room(2 * kFace);
  for (int32_t i = 0; i < 2 * kFace; ++i) { // there below, back above
    point.push_back(i < kFace ? i : 2 * kFace - 1 - i);
    point.push_back(i < kFace ? 0.0 : 0.1);
    order.push_back(i);
  }
  c2d::order_nodes(point.data(), 2 * kFace, 3, order.data(), room.data());
  for (int32_t leaf = 0; leaf < 8; ++leaf) {
    int32_t below = 0;
    double left = 1e9, right = 0;
    for (int32_t k = c2d::leaf_begin(2 * kFace, 3, leaf); k < c2d::leaf_begin(2 * kFace, 3, leaf + 1); ++k) {
      const size_t node = static_cast<size_t>(order[static_cast<size_t>(k)]);
      below += point[2 * node + 1] == 0.0;
      left = std::min(left, point[2 * node]);
      right = std::max(right, point[2 * node]);
    }
    CHECK(below == 8);
    CHECK(left == 8 * leaf);
    CHECK(right == 8 * leaf + 7);
  }
}
