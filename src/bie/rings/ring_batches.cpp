// Sources of a body of revolution in batches (METHOD 21.2). The sources of a batch follow each other along the boundary, so
// that one rule, sufficient for the nearest of them, is hardly finer than the others need. Sources that no rule on the element
// or its halves suffices for, among them those on the element itself, are integrated one by one (ring_elements.hpp).
//
// Grouping and rules depend on the sources alone: no bit of a result depends on the range of columns that is assembled.
#include "bie/rings/ring_batches.hpp"

#include "bie/integrals/batch.hpp"
#include "bie/integrals/batch_sources.hpp"
#include "bie/integrals/integrals_detail.hpp"
#include "bie/rings/ring_elements.hpp"
#include "memory/math.hpp"
#include "model/shape.hpp"
#include "model/symmetry.hpp"
#include "quadrature/gauss.hpp"

namespace c2d {
namespace {

// First points of the rules, found when the first batch needs them; both halves of the element follow each other.
constexpr int kHalves = kFarOrderCount;
constexpr int kRuleStart[] = {0, 2, 5, 9, 14, 20, 28, 38, 50, 66, 86, 118};

struct RingRules {
  bool known[kFarOrderCount + 1] = {};
  RingPoint at[kRuleStart[kFarOrderCount + 1]];
};

RingPoint ring_point(const Integrator& in, const Expansion& x, double eta, double weight) {
  const Sample s = sample(in, x, eta - x.origin);
  RingPoint p = {s.rx, s.ry, in.element.x[0] + s.rx, s.nx, s.ny, -0.5 * in.k * weight * (in.element.x[0] + s.rx), {}, {}};
  const double measured = 0.5 * in.k * weight * s.jacobian * measured_radius(in, eta);
  for (int l = 0; l < in.functions; ++l) {
    p.h[l] = p.own * s.shape[l];
    p.g[l] = measured * s.shape[l];
  }
  return p;
}

struct RulePart {
  const RingPoint* at;
  int count;
};
RulePart rule_of(const Integrator& in, int rule, RingRules& rules) {
  RingPoint* at = rules.at + kRuleStart[rule];
  const int count = kRuleStart[rule + 1] - kRuleStart[rule];
  if (!rules.known[rule]) {
    const Expansion x = expand(in, -1.0, in.element.x[0], in.element.y[0], true); // an end: its coordinates are exact
    const bool halves = rule == kHalves;
    const GaussRule gauss = gauss_legendre(halves ? kNearOrder : count);
    for (int i = 0; i < count; ++i) {
      const GaussPoint p = gauss_point(gauss, i % gauss.n);
      const double eta = !halves ? p.x : (i < kNearOrder ? 0.5 : -0.5) + 0.5 * p.x;
      at[i] = ring_point(in, x, eta, halves ? 0.5 * p.w : p.w);
    }
    rules.known[rule] = true;
  }
  return {at, count};
}

// An element's batches. `alone` marks lanes that the rule does not serve; they get a place where it finds finite numbers.
struct RingBatches {
  const ColumnSystem& system;
  const Integrator& in;
  const int32_t* node;
  BatchRing element;
  RingRules rules;
  int32_t first, count; // the sources of the batch
  int image;
  double xy[2 * kBatch];
  bool alone[kBatch];
  int singular[kBatch]; // of lanes alone
  bool some_alone;      // at least one lane may be
  int rule;             // -1: all lanes are alone

  RingBatches(const ColumnSystem& s, const Integrator& integrator, const int32_t* nodes)
      : system(s), in(integrator), node(nodes), element{in.element.x[0], in.element.y[0], in.kappa, in.t1, in.functions} {}
};

bool is_omitted(const ColumnSystem& system, int32_t source) {
  return system.twin[source] == kSecondTwin || system.twin[source] == kAxisNode;
}

double squared_distance(const Integrator& in, const double* at) {
  const double d[2] = {in.element.c[0][0] - at[0], in.element.c[0][1] - at[1]};
  return squared(d);
}

bool halves_suffice(const Integrator& in, const double* at) {
  const Expansion x = expand(in, 0.0, at[0], at[1], false);
  return resolved(in, x, {0.0, 1.0, 1.0}, false) && resolved(in, x, {0.0, 1.0, -1.0}, false);
}

int rule_at(const Integrator& in, double distance2) {
  int rule = 0;
  while (rule < kFarOrderCount && distance2 <= in.reach2[rule]) ++rule;
  return rule;
}

int singular_at(const RingBatches& b, int32_t source) {
  const ColumnSystem& system = b.system;
  const Source p = mirrored_source(*system.model.head, b.image, system.point + 2 * static_cast<int64_t>(source));
  return p.on_itself ? singular_node(b.node, b.in.functions, node_of_source(system, source), system.twin[source]) : -1;
}

// Some lanes may be too near. (A source on the element always is.)
void sort_lanes(RingBatches& b) {
  b.rule = -1;
  for (int s = 0; s < kBatch; ++s) {
    double* at = b.xy + 2 * s;
    const int32_t source = b.first + (s < b.count ? s : b.count - 1);
    const bool omitted = is_omitted(b.system, source);
    const int rule = rule_at(b.in, squared_distance(b.in, at));
    b.singular[s] = omitted ? -1 : singular_at(b, source);
    b.alone[s] = !omitted && (b.singular[s] >= 0 || (rule == kHalves && !halves_suffice(b.in, at)));
    if (omitted || b.alone[s])
      at[0] = fabs(b.element.x) + 20.0 * b.in.radius, at[1] = b.element.z; // finite numbers, not used
    else if (rule > b.rule)
      b.rule = rule;
  }
}

// Beyond the body's end the last source is repeated.
void take_batch(RingBatches& b, int32_t first, int32_t count, int image) {
  b.first = first, b.count = count, b.image = image;
  const double* at = b.system.point + 2 * static_cast<int64_t>(first);
  for (int s = 0; s < kBatch; ++s, at += s < count ? 2 : 0) {
    b.xy[2 * s] = at[0], b.xy[2 * s + 1] = at[1];
    b.alone[s] = false;
    if (image == 0) continue;
    const Source p = mirrored_source(*b.system.model.head, image, at);
    b.xy[2 * s] = p.x, b.xy[2 * s + 1] = p.y;
  }
  double least = squared_distance(b.in, b.xy);
  for (int s = 1; s < kBatch; ++s) {
    const double distance2 = squared_distance(b.in, b.xy + 2 * s);
    least = distance2 < least ? distance2 : least;
  }
  b.rule = rule_at(b.in, least);
  b.some_alone = b.rule == kHalves;
  if (b.some_alone) sort_lanes(b);
}

// The blocks of lanes alone; zeros where there is no collocation.
void mend_rings(const RingBatches& b, bool want_h, bool want_g, Blocks& blocks, BatchBlocks& out) {
  for (int s = 0; s < b.count; ++s) {
    const bool omitted = is_omitted(b.system, b.first + s);
    if (!omitted && !b.alone[s]) continue;
    const Source p = mirrored_source(*b.system.model.head, b.image, b.system.point + 2 * static_cast<int64_t>(b.first + s));
    if (!omitted) integrate_ring_panels(b.in, *b.system.batch, p.x, p.y, b.singular[s], want_h, want_g, blocks);
    for (int n = 0; n < 4 * b.in.functions; ++n) {
      const int l = n / 4, i = n / 2 % 2, j = n % 2;
      if (want_h) out.h[l][j][2 * s + i] = omitted ? 0.0 : blocks.h[l][i][j];
      if (want_g) out.g[l][j][2 * s + i] = omitted ? 0.0 : blocks.g[l][i][j];
    }
  }
}

// Every batch and image of the sources [first, end): work(batch).
template <class Work> void visit_batches(RingBatches& b, int32_t first, int32_t end, int32_t lines, Work work) {
  for (; first < end; first += kBatch)
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      take_batch(b, first, end - first < kBatch ? end - first : kBatch, image);
      work();
    }
}

} // namespace

bool scatter_rings(const ColumnSystem& system, const Integrator& in, const int32_t node[kElementNodes], Blocks& blocks,
                   const Deposits& deposits) {
  if (kSmallCode || !system.batch || in.degenerate) return false;
  const BatchKernel& kernel = *system.batch;
  bool want[2] = {false, false};
  for (int n = 0; n < deposits.count; ++n) want[deposits.list[n].block < &blocks.g[0][0][0] ? 0 : 1] = true;
  RingBatches b(system, in, node);
  BatchRun run = {{}, &deposits, &blocks, want[0], want[1], {1.0, 1.0}, nullptr};
  BatchBlocks out;
  visit_batches(b, 0, sources_of(system), images_of(system), [&] {
    if (b.rule >= 0) {
      const RulePart rule = rule_of(in, b.rule, b.rules);
      kernel.rings(b.element, rule.at, rule.count, b.xy, out);
    }
    if (b.some_alone || system.some_passed_over) mend_rings(b, want[0], want[1], blocks, out);
    for (int i = 0; i < 2; ++i) run.sign[i] = image_sign(b.image, i);
    kernel.scatter(run, b.first, b.count, out);
  });
  return true;
}

bool take_rings(const ColumnSystem& system, const Integrator& in, const int32_t node[kElementNodes], int32_t first_node,
                int32_t count) {
  if (kSmallCode || !system.batch || in.degenerate) return false;
  RingBatches b(system, in, node);
  double sum[4 * kBatch];
  visit_batches(b, first_node, first_node + count, image_lines(system.model, system.body), [&] {
    if (b.rule >= 0) {
      const RulePart rule = rule_of(in, b.rule, b.rules);
      system.batch->ring_rigid(b.element, rule.at, rule.count, b.xy, sum);
    }
    double* diagonal = system.diagonal + 4 * static_cast<int64_t>(b.first);
    for (int s = 0; s < b.count; ++s) {
      if (is_omitted(system, b.first + s)) continue;
      double own[2][2];
      if (b.alone[s]) {
        const Source p = mirrored_source(*system.model.head, b.image, system.point + 2 * static_cast<int64_t>(b.first + s));
        ring_panel_sum(in, *system.batch, p.x, p.y, b.singular[s], own);
      }
      for (int i = 0; i < 4; ++i)
        diagonal[4 * s + i] -=
            image_sign(b.image, i / 2) * image_sign(b.image, i % 2) * (b.alone[s] ? own[i / 2][i % 2] : sum[4 * s + i]);
    }
  });
  return true;
}

} // namespace c2d
