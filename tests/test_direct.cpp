// The path of a chain of blocks against a direct solution: the equations of all bodies as they are assembled, nothing
// eliminated or reduced, and a dense system of them and the conditions of the pairs for each set of statuses.
#include "bie/columns.hpp"
#include "bie/panel.hpp"
#include "linalg/lu.hpp"
#include "many_bodies.hpp"
#include "solver/solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

using many::Row;

namespace {

const int kLinks = 20;
const double kFriction = 0.1;

// Flat blocks in a row, held at the left, pressed together by load case 1, pushed up at the right by load case 2.
many::Model chain() {
  many::Model m;
  for (int i = 0; i < kLinks; ++i)
    m.add(many::rectangle(0.2 * i, 0, 0.2 * (i + 1), 1, {1, 6, 1, 6}, 1000 + 100 * (i % 3), 0.2 + 0.05 * (i % 4)));
  m.set(1, 4, many::end_of(many::kHeld));
  m.set(kLinks, 2, many::end_of(many::kPulled, -1, 0));
  m.set_second(kLinks, 2, many::end_of(many::kPulled, 0, 0.08));
  for (int i = 1; i < kLinks; ++i) m.join(C2D_ZONE_MATCHING, i, 2, i + 1, 4);
  m.friction = kFriction;
  m.paths = {{1, 1.0, 0.0}, {1, 1.0, 1.0}, {1, 1.0, 0.2}};
  return m;
}

struct State {
  int kind;
  double load[2];
  std::vector<Row> rows;
  double friction(size_t pair) const { return rows[pair][C2D_TT]; }
  int status(size_t pair) const { return static_cast<int>(rows[pair][C2D_STATUS]); }
};
int32_t keep(void* context, const c2d_step* now) {
  State s = {now->kind, {now->loads[0], now->loads[1]}, std::vector<Row>(static_cast<size_t>(now->pairs))};
  for (int32_t i = 0; i < now->pairs; ++i)
    std::copy(now->table + i * now->stride, now->table + i * now->stride + C2D_PAIR_FIELDS,
              s.rows[static_cast<size_t>(i)].begin());
  static_cast<std::vector<State>*>(context)->push_back(s);
  return 0;
}

// Does the friction of a pair that slips from one state to the other push side 2 along t? (It has none where it opens or
// touches.)
bool pushes(const State& from, const State& to, size_t pair) {
  const double one = from.friction(pair), two = to.friction(pair);
  return (std::fabs(one) > std::fabs(two) ? one : two) > 0;
}

// What changes with a step along the loads: of each pair gap, w_t, pressure and friction, in the units of the rows.
struct Rate {
  double gap, slide, tn, tt;
};

class Direct {
public:
  explicit Direct(c2d_solver* s) : m_(c2d::model_of(s)) {
    for (int b = 0; b < m_.head->bodies; ++b) {
      first_row_.push_back(rows_), first_column_.push_back(contact_);
      rows_ += c2d::system_rows(m_, b), contact_ += c2d::outer_columns(m_, b) + m_.body[b].contact;
    }
    n_ = rows_ + m_.head->contact;
    REQUIRE(contact_ + m_.head->contact == n_);
    equations_.assign(static_cast<size_t>(n_) * static_cast<size_t>(n_), 0);
    for (auto& load : load_) load.assign(static_cast<size_t>(n_), 0);
    for (int b = 0; b < m_.head->bodies; ++b) add_body(b);
  }

  // With the statuses of `now`, for these steps of both loads to `then`.
  std::vector<Rate> rates(const State& now, const State& then, const double step[2]) const {
    std::vector<c2d::Real> a = equations_, x(static_cast<size_t>(n_)), norms(static_cast<size_t>(n_));
    std::vector<int32_t> pivots(static_cast<size_t>(n_));
    for (size_t i = 0; i < x.size(); ++i) x[i] = static_cast<c2d::Real>(step[0] * load_[0][i] + step[1] * load_[1][i]);
    for (int32_t i = 0; i < m_.head->pairs; ++i) {
      const c2d::Pair& pair = m_.pair[i];
      const size_t p = static_cast<size_t>(i);
      for (int d = 0; d < 2; ++d) {
        const int32_t row = rows_ + pair.dof + d;
        if (now.status(p) == C2D_OPEN || (d == 1 && now.status(p) == C2D_SLIP)) {
          entry(a, row, contact_ + pair.dof + d) = 1;
          if (now.status(p) == C2D_SLIP)
            entry(a, row, contact_ + pair.dof) = static_cast<c2d::Real>(pushes(now, then, p) ? -kFriction : kFriction);
        } else {
          entry(a, row, displacement(pair, 1, d)) = 1;
          entry(a, row, displacement(pair, 0, d)) = -1;
        }
      }
    }
    std::vector<double> scratch(static_cast<size_t>(c2d::full_scratch(n_, n_)) + 8);
    const size_t past = reinterpret_cast<uintptr_t>(scratch.data()) % 64;
    c2d::Real* aligned = reinterpret_cast<c2d::Real*>(scratch.data() + (64 - past) % 64 / sizeof(double));
    const c2d::Engine engine = {c2d::kernel_for(c2d::best_instructions()), aligned, c2d::full_scratch(n_, n_), nullptr};
    REQUIRE(c2d::lu_factor(engine, n_, a.data(), n_, pivots.data(), norms.data(), nullptr) == 0);
    c2d::lu_solve(engine, n_, 1, a.data(), n_, pivots.data(), x.data(), n_);
    std::vector<Rate> out;
    for (int32_t i = 0; i < m_.head->pairs; ++i) {
      const c2d::Pair& pair = m_.pair[i];
      const auto at = [&](int32_t k) { return static_cast<double>(x[static_cast<size_t>(k)]); };
      const auto moved = [&](int d) {
        return m_.head->length_unit * (at(displacement(pair, 1, d)) - at(displacement(pair, 0, d)));
      };
      out.push_back({moved(0), moved(1), m_.head->stress_unit * at(contact_ + pair.dof),
                     m_.head->stress_unit * at(contact_ + pair.dof + 1)});
    }
    return out;
  }

private:
  c2d::Model m_;
  std::vector<int32_t> first_row_, first_column_;
  int32_t rows_ = 0, contact_ = 0, n_ = 0; // equations of the bodies; their unknowns, behind which are the tractions; all
  std::vector<c2d::Real> equations_;
  std::vector<double> load_[2];

  c2d::Real& entry(std::vector<c2d::Real>& a, int32_t i, int32_t j) const {
    return a[static_cast<size_t>(i) + static_cast<size_t>(j) * static_cast<size_t>(n_)];
  }
  int32_t displacement(const c2d::Pair& pair, int side, int d) const {
    const int b = m_.zone[pair.zone].body[side];
    return first_column_[static_cast<size_t>(b)] + c2d::outer_columns(m_, b) + c2d::dof_on(m_, pair, side) + d;
  }
  void add_body(int b) {
    const size_t nodes = static_cast<size_t>(m_.body[b].nodes), own = static_cast<size_t>(b);
    const int32_t rows = c2d::system_rows(m_, b), outer = c2d::outer_columns(m_, b), contact = m_.body[b].contact;
    const int32_t columns = outer + c2d::trailing_columns(m_, b);
    std::vector<double> diagonal(4 * nodes), point(2 * nodes);
    std::vector<int32_t> twin(nodes);
    const auto scratch = std::make_unique<c2d::AssemblyScratch>();
    std::vector<c2d::Real> a(static_cast<size_t>(rows) * static_cast<size_t>(columns));
    c2d::ColumnSystem system{m_, b, c2d::Quadrature::accurate, diagonal.data(), point.data(), twin.data(), scratch.get()};
    system.some_passed_over = c2d::place_sources(system);
    c2d::fill_diagonal(system, 0, m_.body[b].nodes);
    c2d::fill_columns(system, 0, columns, a.data(), rows);
    const auto at = [&](int32_t i, int32_t j) {
      return a[static_cast<size_t>(i) + static_cast<size_t>(j) * static_cast<size_t>(rows)];
    };
    for (int32_t i = 0; i < rows; ++i) {
      const int32_t row = first_row_[own] + i;
      for (int32_t j = 0; j < outer + contact; ++j) entry(equations_, row, first_column_[own] + j) = at(i, j);
      for (size_t k = 0; k < 2; ++k)
        load_[k][static_cast<size_t>(row)] = static_cast<double>(at(i, outer + 2 * contact + static_cast<int32_t>(k)));
      for (int32_t p = 0; p < m_.head->pairs; ++p) // the traction acts on both sides, against each other
        for (int side = 0; side < 2; ++side)
          for (int d = 0; d < 2 && m_.zone[m_.pair[p].zone].body[side] == b; ++d)
            entry(equations_, row, contact_ + m_.pair[p].dof + d) -=
                static_cast<c2d::Real>(side == 1 ? 1 : -1) * at(i, outer + contact + c2d::dof_on(m_, m_.pair[p], side) + d);
    }
  }
};

// The part of the step at which the pair leaves its status; infinity: not in this direction. Below zero by more than round-off:
// it had left it before.
double reach_of(const Row& row, const Rate& rate, bool pushed, double p, double u) {
  const double never = std::numeric_limits<double>::infinity();
  const auto down_to_zero = [&](double value, double change, double nothing) {
    return change < -1e-9 * nothing ? std::max(value, 0.0) / -change : never;
  };
  const int status = static_cast<int>(row[C2D_STATUS]);
  if (status == C2D_OPEN) return down_to_zero(row[C2D_GAP], rate.gap, u);
  const double lifts = down_to_zero(row[C2D_TN], rate.tn, p);
  if (status == C2D_SLIP) { // against the friction it would have to stick
    const double along = pushed ? -rate.slide : rate.slide;
    return along < -1e-9 * u ? 0.0 : lifts;
  }
  const double up = down_to_zero(kFriction * row[C2D_TN] - row[C2D_TT], kFriction * rate.tn - rate.tt, p);
  const double back = down_to_zero(kFriction * row[C2D_TN] + row[C2D_TT], kFriction * rate.tn + rate.tt, p);
  return std::min({lifts, up, back});
}

} // namespace

TEST_CASE("direct: events of a chain of 20 blocks are where a direct solution of all equations has them") {
  const many::Model m = chain();
  many::Machine machine(m);
  REQUIRE(machine.status == C2D_OK);
  c2d_options options = C2D_INIT(c2d_options);
  options.every_change = 1;
  REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  std::vector<State> states;
  REQUIRE(c2d_run(machine.solver, keep, &states) == C2D_OK);
  const Direct direct(machine.solver);
  double p = 0, u = 0;
  for (const State& s : states)
    for (const Row& row : s.rows) p = std::max(p, std::fabs(row[C2D_TN])), u = std::max(u, std::fabs(row[C2D_GAP]));
  int events = 0, seen[3] = {0, 0, 0};
  for (size_t i = 1; i < states.size(); ++i) {
    const State &from = states[i - 1], &to = states[i];
    const double step[2] = {to.load[0] - from.load[0], to.load[1] - from.load[1]};
    if (std::fabs(step[0]) + std::fabs(step[1]) < 1e-9) continue; // changes at one load: the last of them counts
    CAPTURE(to.load[1]);
    const std::vector<Rate> rate = direct.rates(from, to, step);
    double reach = std::numeric_limits<double>::infinity(), off_p = 0, off_u = 0;
    size_t first = 0;
    for (size_t k = 0; k < rate.size(); ++k) {
      const Row &a = from.rows[k], &b = to.rows[k];
      off_p = std::max({off_p, std::fabs(a[C2D_TN] + rate[k].tn - b[C2D_TN]), std::fabs(a[C2D_TT] + rate[k].tt - b[C2D_TT])});
      const auto apart = [](const Row& row) { return row[C2D_UT2] - row[C2D_UT1]; };
      off_u =
          std::max({off_u, std::fabs(a[C2D_GAP] + rate[k].gap - b[C2D_GAP]), std::fabs(apart(a) + rate[k].slide - apart(b))});
      const double own = reach_of(a, rate[k], pushes(from, to, k), p, u);
      if (own < reach) reach = own, first = k;
      ++seen[from.status(k)];
    }
    CHECK(off_p < 1e-10 * p);
    CHECK(off_u < 1e-10 * u);
    if (to.kind != C2D_STEP_CHANGE) {
      CHECK(reach > 1 - 1e-6);
      continue;
    }
    ++events;
    CHECK(std::fabs(reach - 1) * std::fabs(step[1]) < 1e-11);
    CHECK(from.status(first) != to.status(first));
  }
  CHECK(events > 100);
  for (const int n : seen) CHECK(n > 100);
}
