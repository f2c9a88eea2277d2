// What many bodies cost beyond what each of them and the contact cost alone, and what threads gain on small ones.
#include "../many_bodies.hpp"
#include "bench.hpp"
#include "linalg/exchange.hpp"
#include "model.hpp"

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {

const int kRows = 10, kColumns = 5, kSideJoints = 15, kElements = 10; // of a side

many::Model block() {
  many::Model m;
  m.add(many::rectangle(0, 0, 1, 1, {kElements, kElements, kElements, kElements}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(1, 3, many::end_of(many::kPulled, 0, -1));
  return m;
}

// The elements of two sides that face each other, but for those at the corners.
void join(many::Model& m, int32_t one, int32_t side1, int32_t two, int32_t side2) {
  const many::Range a = m.side(one, side1), b = m.side(two, side2);
  m.zones.push_back({C2D_ZONE_MATCHING, {{one, a.first + 1, a.last - 1}, {two, b.last - 1, b.first + 1}}});
}

// 50 blocks one on the other and side by side, held below, pressed from above and pushed at the top.
many::Model wall() {
  many::Model m;
  const auto number = [](int row, int column) { return row * kColumns + column + 1; };
  for (int row = 0; row < kRows; ++row)
    for (int c = 0; c < kColumns; ++c)
      m.add(many::rectangle(c, row, c + 1, row + 1, {kElements, kElements, kElements, kElements}));
  for (int row = 0; row + 1 < kRows; ++row)
    for (int c = 0; c < kColumns; ++c) join(m, number(row, c), 3, number(row + 1, c), 1);
  for (int k = 0; k < kSideJoints; ++k) {
    const int row = kRows - 1 - k / (kColumns - 1), c = k % (kColumns - 1);
    join(m, number(row, c), 2, number(row, c + 1), 4);
  }
  for (int c = 0; c < kColumns; ++c) {
    m.set(number(0, c), 1, many::end_of(many::kHeld));
    m.set(number(kRows - 1, c), 3, many::end_of(many::kPulled, 0, -1 - 0.2 * c));
  }
  m.set(number(kRows - 1, 0), 4, many::end_of(many::kPulled, 0.2));
  m.friction = 0.4;
  return m;
}

// Two plates that meet in so many pairs.
[[gnu::noinline]] many::Model plates(int32_t pairs) {
  many::Model m;
  m.add(many::rectangle(0, 0, 50, 5, {20, 4, pairs + 1, 4}));
  m.add(many::rectangle(0, 5, 50, 10, {pairs + 1, 4, 20, 4}));
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0.1, -1));
  join(m, 1, 3, 2, 1);
  m.friction = 0.4;
  return m;
}

struct Cost {
  double prepare, path, assemble, eliminate, reduce;
  host::Summary summary;
};

Cost cost_of(const many::Model& m, int32_t threads = 0) {
  std::vector<c2d_body_limits> list;
  const Solver solver(many::limits_of(m, list), threads);
  solver.must(many::feed(solver, m));
  Cost out;
  const double start = processor_seconds();
  solver.must(c2d_prepare(solver));
  out.prepare = processor_seconds() - start;
  solver.must(c2d_run(solver, nullptr, nullptr));
  out.path = processor_seconds() - start - out.prepare;
  out.summary = solver.summary();
  const double* seconds = out.summary.seconds;
  out.assemble = seconds[C2D_PHASE_ASSEMBLE], out.eliminate = seconds[C2D_PHASE_ELIMINATE];
  out.reduce = seconds[C2D_PHASE_REDUCE];
  return out;
}

double seconds_of_exchange(int32_t m) {
  std::vector<c2d::Real> t(static_cast<size_t>(m) * static_cast<size_t>(m + 2));
  uint32_t seed = 12345;
  for (c2d::Real& v : t) v = static_cast<c2d::Real>((seed = seed * 1664525u + 1013904223u) >> 8) / 16777216;
  const c2d::Kernel* kernel = c2d::kernel_for(c2d::best_instructions());
  return time_of(6, 0.05, [&] { c2d::exchange(m, m + 2, t.data(), m, 7, 7, kernel); });
}

template <class Part> double median_of(const std::vector<Cost>& costs, Part part) {
  std::vector<double> values;
  for (const Cost& cost : costs) values.push_back(part(cost));
  return median(values);
}

void against_the_parts() {
  heading("50 blocks of 40 elements in 60 zones: the whole over the sum of its parts");
  std::vector<Cost> whole, alone, contact;
  std::vector<double> exchange;
  const many::Model all = wall(), one = block();
  const int32_t unknowns = cost_of(all).summary.contact_unknowns;
  for (int turn = 0; turn < 5; ++turn) { // in turns, so that a slow spell of the machine strikes all
    whole.push_back(cost_of(all));
    for (int k = 0; k < 10; ++k) alone.push_back(cost_of(one));
    contact.push_back(cost_of(plates(unknowns / 2)));
    exchange.push_back(seconds_of_exchange(unknowns));
  }
  const double bodies = kRows * kColumns * median_of(alone, [](const Cost& c) { return c.prepare + c.path; });
  const double reduce = median_of(contact, [](const Cost& c) { return c.reduce; });
  const double path = static_cast<double>(whole[0].summary.exchanges) * median(exchange);
  const double total = median_of(whole, [](const Cost& c) { return c.prepare + c.path; });
  row("bodies.50.time", total, "s", std::to_string(unknowns) + " contact unknowns");
  row("bodies.50.alone", bodies, "s", "50 times one of them");
  row("bodies.50.reduce", reduce, "s", "of two bodies with as many contact unknowns");
  row("bodies.50.exchanges", path, "s", std::to_string(whole[0].summary.exchanges) + " of them, each as it is alone");
  const double ratio = total / (bodies + reduce + path);
  row("bodies.50.over_parts", ratio, "", judged("bodies.50.ratio", ratio, "<=", 1.2, ""));
}

void side_by_side() {
  heading("Small bodies side by side: assembly and elimination of 50 blocks by the clock, one thread over two");
  std::vector<Cost> one, two;
  const many::Model all = wall();
  for (int turn = 0; turn < 9; ++turn) one.push_back(cost_of(all, 1)), two.push_back(cost_of(all, 2));
  const auto assemble = [](const Cost& c) { return c.assemble; };
  const auto eliminate = [](const Cost& c) { return c.eliminate; };
  row("bodies.threads.assemble", median_of(one, assemble) / median_of(two, assemble), "");
  row("bodies.threads.eliminate", median_of(one, eliminate) / median_of(two, eliminate), "",
      "writing the blocks is left to one of them");
}

} // namespace

void many_bodies() {
  against_the_parts();
  side_by_side();
}

} // namespace bench
