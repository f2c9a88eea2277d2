// Speed of assembly: pairs of source node and element integrated in a second.
#include "bench.hpp"
#include "model.hpp"

#include "../callable.hpp"
#include "bie/integrals/batch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <memory>

namespace bench {

namespace {

// Source-element pairs per second of one ring; several rings are prepared, the median counts.
double pairs_per_second(const Ring& ring, int32_t quadrature) {
  std::vector<double> rates;
  for (double spent = 0; rates.size() < 5 || (spent < 0.3 && rates.size() < 100);) {
    const Solver solver(ring.limits());
    ring.build(solver);
    c2d_options options = C2D_INIT(c2d_options);
    options.quadrature = quadrature;
    solver.must(c2d_set_options(solver, &options));
    const double start = processor_seconds();
    solver.must(c2d_prepare(solver));
    spent += processor_seconds() - start;
    const host::Summary now = solver.summary();
    rates.push_back(static_cast<double>(now.body[0].nodes) * now.body[0].elements / now.seconds[C2D_PHASE_ASSEMBLE]);
  }
  return median(rates);
}

// H and G of a disc with nodes on the unit circle, column-major: what a solver assembles, without its
// bookkeeping.
struct Polygon {
  size_t n;
  std::vector<double> xy, h, g;
  std::vector<c2d::Integrator> integrator;

  explicit Polygon(size_t elements) : n(elements), h(4 * n * n), g(4 * n * n) {
    for (size_t i = 0; i < n; ++i) {
      const double angle = 2 * 3.14159265358979324 * static_cast<double>(i) / static_cast<double>(n);
      xy.push_back(std::cos(angle)), xy.push_back(std::sin(angle));
    }
    for (size_t i = 0; i < n; ++i) {
      const size_t j = next(i);
      const double x[2] = {xy[2 * i], xy[2 * j]}, y[2] = {xy[2 * i + 1], xy[2 * j + 1]};
      integrator.emplace_back();
      c2d::prepare(integrator.back(), c2d::make_element(2, x, y), 2, 0.3, c2d::Quadrature::accurate);
    }
  }
  size_t next(size_t i) const { return (i + 1) % n; }
  double* column(std::vector<double>& of, size_t element, int l, int c) const {
    return of.data() + 2 * n * (2 * (l == 0 ? element : next(element)) + static_cast<size_t>(c));
  }
  void clear() {
    std::fill(h.begin(), h.end(), 0.0);
    std::fill(g.begin(), g.end(), 0.0);
  }
};

// Four Gauss points per pair, wherever the source is, as textbooks do it.
void textbook(Polygon& p) {
  const double eta[4] = {-0.861136311594053, -0.339981043584856, 0.339981043584856, 0.861136311594053};
  const double w[4] = {0.347854845137454, 0.652145154862546, 0.652145154862546, 0.347854845137454};
  const double nu = 0.3, k = 1 / (4 * 3.14159265358979324 * (1 - nu));
  for (size_t e = 0; e < p.n; ++e) {
    const c2d::Element& at = p.integrator[e].element;
    const double dx = 0.5 * (at.x[1] - at.x[0]), dy = 0.5 * (at.y[1] - at.y[0]), jacobian = std::sqrt(dx * dx + dy * dy);
    const double n[2] = {dy / jacobian, -dx / jacobian};
    for (size_t s = 0; s < p.n; ++s) {
      double h[2][2][2] = {}, g[2][2][2] = {};
      for (int q = 0; q < 4; ++q) {
        const double shape[2] = {0.5 * (1 - eta[q]), 0.5 * (1 + eta[q])};
        const double rx = shape[0] * at.x[0] + shape[1] * at.x[1] - p.xy[2 * s];
        const double ry = shape[0] * at.y[0] + shape[1] * at.y[1] - p.xy[2 * s + 1];
        const double r = std::sqrt(rx * rx + ry * ry), d[2] = {rx / r, ry / r}, dn = d[0] * n[0] + d[1] * n[1];
        const double log_r = std::log(r), weight = w[q] * jacobian * k;
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j) {
            const double same = i == j ? 1 : 0;
            const double u = -(3 - 4 * nu) * log_r * same + d[i] * d[j];
            const double t = -(dn * ((1 - 2 * nu) * same + 2 * d[i] * d[j]) - (1 - 2 * nu) * (d[i] * n[j] - d[j] * n[i])) / r;
            for (int l = 0; l < 2; ++l) {
              h[l][i][j] += weight * shape[l] * t;
              g[l][i][j] += weight * shape[l] * u;
            }
          }
      }
      for (int l = 0; l < 2; ++l)
        for (int j = 0; j < 2; ++j)
          for (int i = 0; i < 2; ++i) {
            p.column(p.h, e, l, j)[2 * s + static_cast<size_t>(i)] += h[l][i][j];
            p.column(p.g, e, l, j)[2 * s + static_cast<size_t>(i)] += g[l][i][j];
          }
    }
  }
}

void batched(Polygon& p, const c2d::BatchKernel& kernel) {
  c2d::BatchBlocks room;
  c2d::Blocks blocks;
  c2d::Deposits deposits;
  for (size_t e = 0; e < p.n; ++e) {
    deposits.count = 0;
    for (int l = 0; l < 2; ++l)
      for (int j = 0; j < 2; ++j) {
        deposits.add(&blocks.h[l][0][j], p.column(p.h, e, l, j), 1);
        deposits.add(&blocks.g[l][0][j], p.column(p.g, e, l, j), 1);
      }
    c2d::BatchRun run = {c2d::batch_element(p.integrator[e]), &deposits, &blocks, true, true, {1, 1}, nullptr};
    c2d::BatchColumns columns;
    c2d::aim_columns(run, columns);
    run.direct = &columns;
    kernel.integrate_and_scatter(run, p.xy.data(), 0, static_cast<int32_t>(p.n), room);
  }
}

void one_by_one(Polygon& p) {
  c2d::Blocks out;
  for (size_t e = 0; e < p.n; ++e)
    for (size_t s = 0; s < p.n; ++s) {
      const int singular = s == e ? 0 : s == p.next(e) ? 1 : -1;
      c2d::integrate(p.integrator[e], p.xy[2 * s], p.xy[2 * s + 1], singular, true, true, out);
      for (int l = 0; l < 2; ++l)
        for (int j = 0; j < 2; ++j)
          for (int i = 0; i < 2; ++i) {
            p.column(p.h, e, l, j)[2 * s + static_cast<size_t>(i)] += out.h[l][i][j];
            p.column(p.g, e, l, j)[2 * s + static_cast<size_t>(i)] += out.g[l][i][j];
          }
    }
}

// The textbook's loop and every instruction set in turns, so that a slow spell of the machine strikes all.
void matrices() {
  heading("Assembly of H and G of 1000 linear elements: millions of source-element pairs per second");
  Polygon p(1000);
  const char* names[] = {"one_by_one", "baseline", "avx2", "avx512"};
  const int sets = static_cast<int>(c2d::best_instructions());
  std::vector<double> seconds[5];
  for (int turn = 0; turn < 7; ++turn)
    for (int way = 0; way <= sets + 1; ++way) {
      const c2d::BatchKernel* kernel = way > sets ? nullptr : c2d::batch_for(static_cast<c2d::Instructions>(way));
      if (way > 0 && way <= sets && !kernel) continue;
      p.clear();
      const double start = processor_seconds();
      if (way > sets)
        textbook(p);
      else if (kernel)
        batched(p, *kernel);
      else
        one_by_one(p);
      seconds[way].push_back(processor_seconds() - start);
    }
  const double pairs = static_cast<double>(p.n * p.n) * 1e-6, loop = median(seconds[sets + 1]);
  row("assembly.matrices.textbook", pairs / loop, "M/s", "four Gauss points everywhere, nothing near or singular");
  for (int way = 0; way <= sets; ++way) {
    const double t = median(seconds[way]);
    if (!(t > 0)) continue;
    const std::string key = std::string("assembly.matrices.") + names[way];
    row(key, pairs / t, "M/s", judged(key + ".ratio", loop / t, ">=", way == sets && way > 1 ? 12 : 0, "times the textbook's"));
    row(key + ".time", t * 1e3, "ms", judged(key + ".ms", t * 1e3, "<=", way == 1 ? 30 : way > 1 ? 10 : 0, ""));
  }
}

// What c2d_prepare spends in assembly: the matrix of the unknowns, its diagonal, balances and right-hand
// side.
double assembly_of(const Disc& disc) {
  const Solver solver(disc.limits());
  disc.build(solver);
  solver.must(c2d_prepare(solver));
  return solver.summary().seconds[C2D_PHASE_ASSEMBLE];
}

// Bodies of revolution beside plane ones of the same nodes, in turns.
void whole_bodies() {
  heading("Assembly of a whole body: a disc, and a ring of the same nodes whose section it is, middle radius 2");
  const char* names[] = {"linear", "quadratic", "cubic"};
  for (int order = 1; order <= 3; ++order)
    for (const int32_t nodes : {200, 1000}) {
      const Disc disc = {nodes / order, 0, order + 1}, ring = {nodes / order, 2, order + 1};
      std::vector<double> plane, round;
      for (int turn = 0; turn < (nodes < 1000 ? 15 : 5); ++turn) {
        plane.push_back(assembly_of(disc));
        round.push_back(assembly_of(ring));
      }
      const std::string end = std::string(".") + names[order - 1] + "." + std::to_string(nodes);
      const double ratio = median(round) / median(plane);
      row("assembly.disc" + end, median(plane) * 1e3, "ms");
      row("assembly.ring" + end, median(round) * 1e3, "ms",
          judged("assembly.ring" + end + ".ratio", ratio, "<=", 8, "times the disc's"));
    }
}

} // namespace

void write_boundary_matrix(const std::string& file, int nodes) {
  Polygon p(static_cast<size_t>(nodes));
  one_by_one(p);
  // Tractions are unknown on the first half of the boundary, displacements on the other.
  std::copy(p.g.begin(), p.g.begin() + static_cast<std::ptrdiff_t>(p.g.size() / 2), p.h.begin());
  for (size_t i = p.n; i < 2 * p.n; ++i) p.h[i * (2 * p.n + 1)] += 0.5;
  FILE* out = std::fopen(file.c_str(), "wb");
  if (!out || std::fwrite(p.h.data(), sizeof(double), p.h.size(), out) != p.h.size() || std::fclose(out) != 0)
    give_up("cannot write " + file);
}

test::Callable<void()> assembly_job(c2d::Instructions set, int nodes) {
  const auto p = std::make_shared<Polygon>(static_cast<size_t>(nodes));
  const c2d::BatchKernel* kernel = c2d::batch_for(set);
  if (!kernel) return {};
  return [p, kernel] { batched(*p, *kernel); };
}

void assembly() {
  matrices();
  whole_bodies();
  heading("Assembly: millions of source-element pairs per second, all in one panel (ring of 2 x 60 elements)");
  for (const int order : {2, 3, 4}) {
    for (const bool round : {false, true}) {
      if (round && order == 2) continue;
      const Ring ring = {60, order, order, round};
      const std::string name = std::string("assembly.") + (round ? "curved." : "straight.") +
                               (order == 2   ? "linear."
                                : order == 3 ? "quadratic."
                                             : "cubic.");
      const double accurate = pairs_per_second(ring, C2D_QUADRATURE_ACCURATE) * 1e-6;
      const double thesis = pairs_per_second(ring, C2D_QUADRATURE_THESIS) * 1e-6;
      row(name + "accurate", accurate, "M/s", times(accurate / thesis) + " of the rule of 1987");
      row(name + "thesis", thesis, "M/s");
    }
  }
}

} // namespace bench
