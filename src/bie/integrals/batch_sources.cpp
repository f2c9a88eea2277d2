// Sources in batches of kBatch for the vector loops (METHOD 3.2).
//
// Consecutive sources form groups. A plain group consists of whole batches without special sources, and its integrals go
// straight into the columns. Any other group is one batch, whose special lanes are corrected afterwards:
// 1. sources on the element itself: singular integrals, one by one;
// 2. sources without collocation (second twins, axis nodes): zero.
// No bit of a result depends on the range of columns that is assembled, nor on which columns are wanted.
// The integrals are those of integrals_straight.cpp, METHOD (3.2).
#include "bie/integrals/batch_sources.hpp"

#include "bie/integrals/batch.hpp"
#include "memory/parts.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(RingPart);

namespace {

// Sources at the element's own functional nodes: their integrals are singular.
struct OwnSources {
  int32_t source[kElementNodes];
  int count;
};

int32_t collocation_node(const ColumnSystem& system, int32_t node) {
  return system.twin[node] == kSecondTwin ? twin_node(system.model, system.body, node) : node;
}

// The chosen source that collocates at the node; -1: none.
int32_t chosen_source(const ColumnSystem& system, int32_t node) {
  for (int32_t s = 0; s < system.sources; ++s)
    if (system.chosen[s] != kNoNode && (system.chosen[s] == node || system.twin[s] == node)) return s;
  return -1;
}

OwnSources own_sources(const ColumnSystem& system, const int32_t node[kElementNodes], int functions) {
  OwnSources own;
  own.count = functions;
  for (int l = 0; l < functions; ++l)
    own.source[l] = system.chosen ? chosen_source(system, node[l]) : collocation_node(system, node[l]);
  return own;
}

// Consecutive sources: whole batches of regular sources (plain), or one batch with special ones, shorter at the body's end.
struct Group {
  int32_t first, count;
  bool plain;
};

bool has_passed_over(const ColumnSystem& system, int32_t first) {
  const int32_t* twin = system.twin + first;
  for (int s = 0; s < kBatch; ++s)
    if (twin[s] < kSingle) return true;
  return false;
}

Group group_at(const ColumnSystem& system, const OwnSources& own, int32_t first, int32_t end) {
  Group g{first, end - first, false};
  if (g.count < kBatch) return g;
  g.count -= g.count % kBatch;
  for (int n = 0; n < own.count; ++n) // up to the batch with the first singular source
    if (own.source[n] >= first && own.source[n] < first + g.count) g.count = (own.source[n] - first) / kBatch * kBatch;
  for (int32_t s = 0; system.some_passed_over && s < g.count; s += kBatch)
    if (has_passed_over(system, first + s)) g.count = s;
  g.plain = g.count > 0;
  if (!g.plain) g.count = kBatch;
  return g;
}

bool is_passed_over(int32_t twin) { return twin == kSecondTwin || twin == kAxisNode; }

// Places of a batch of sources for an image: in `room`, unless they can be used where they are stored. Beyond the body's end
// the last source is repeated.
const double* places(const ColumnSystem& system, int32_t first, int32_t count, int image, double room[2 * kBatch]) {
  const double* at = system.point + 2 * static_cast<int64_t>(first);
  if (image == 0 && count >= kBatch) return at;
  for (int s = 0; s < kBatch; ++s) {
    const Source p = mirrored_source(*system.model.head, image, at + 2 * (s < count ? s : count - 1));
    room[2 * s] = p.x;
    room[2 * s + 1] = p.y;
  }
  return room;
}

// Local node at which lane s is located; -1 if none.
int singular_lane(const ColumnSystem& system, const Integrator& in, const int32_t node[kElementNodes], const Group& g,
                  int image, int s, Source& p) {
  const int32_t source = g.first + s;
  p = mirrored_source(*system.model.head, image, system.point + 2 * static_cast<int64_t>(source));
  return p.on_itself ? singular_node(node, in.functions, node_of_source(system, source), system.twin[source]) : -1;
}

struct BatchJob {
  const ColumnSystem& system;
  const Integrator& in;
  const int32_t* node;
  BatchRun run;
  BatchColumns columns;
  bool direct; // the columns receive everything that is to be added
};

// Corrects special lanes: zeros where there is no collocation, the singular integrals where the source is on the element.
void mend_lanes(const BatchJob& job, const Group& g, int image, Blocks& blocks, BatchBlocks& out) {
  for (int s = 0; s < g.count; ++s) {
    Source p;
    const bool none = is_passed_over(job.system.twin[g.first + s]);
    const int singular = none ? -1 : singular_lane(job.system, job.in, job.node, g, image, s, p);
    if (!none && singular < 0) continue;
    if (!none) integrate(job.in, p.x, p.y, singular, job.run.want_h, job.run.want_g, blocks);
    for (int l = 0; l < job.in.functions; ++l)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
          if (job.run.want_h) out.h[l][j][2 * s + i] = none ? 0.0 : blocks.h[l][i][j];
          if (job.run.want_g) out.g[l][j][2 * s + i] = none ? 0.0 : blocks.g[l][i][j];
        }
  }
}

void scatter_group(BatchJob& job, const Group& g, int image, Blocks& blocks, BatchBlocks& out) {
  const BatchKernel& kernel = *job.system.batch;
  BatchRun& run = job.run;
  for (int i = 0; i < 2; ++i) run.sign[i] = image_sign(image, i);
  run.direct = image == 0 && job.direct ? &job.columns : nullptr;
  double room[2 * kBatch];
  if (!g.plain) {
    kernel.integrate(run.element, places(job.system, g.first, g.count, image, room), run.want_h, run.want_g, out);
    mend_lanes(job, g, image, blocks, out);
    kernel.scatter(run, g.first, g.count, out);
    return;
  }
  // Images need mirrored places, of which there is room for one batch.
  const int32_t step = image == 0 ? g.count : kBatch;
  for (int32_t s = 0; s < g.count; s += step)
    kernel.integrate_and_scatter(run, places(job.system, g.first + s, step, image, room), g.first + s, step, out);
}

} // namespace

bool scatter_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[kElementNodes],
                     Blocks& blocks, const Deposits& deposits) {
  if (kSmallCode || !system.batch) return false;
  if (is_ring(integrator)) return kRingPart.scatter_rings(system, integrator, node, blocks, deposits);
  BatchJob job{system, integrator, node, BatchRun{{}, &deposits, &blocks, false, false, {1.0, 1.0}, nullptr}, {}, false};
  for (int n = 0; n < deposits.count; ++n)
    (deposits.list[n].block < &blocks.g[0][0][0] ? job.run.want_h : job.run.want_g) = true;
  if (!is_batched(integrator, true)) return false; // also if g is not wanted: no bit may depend on the range of columns
  job.run.element = batch_element(integrator);
  // Nor may it depend on whether only one of a component's two columns lies in the range.
  job.direct = sizeof(Real) == sizeof(double) && !system.scratch->targets.shared;
  if (job.direct) aim_columns(job.run, job.columns);
  const int32_t lines = images_of(system), end = sources_of(system);
  const OwnSources own = own_sources(system, node, integrator.functions);
  BatchBlocks out;
  for (int32_t first = 0; first < end;) {
    const Group g = group_at(system, own, first, end);
    for (int image = 0; image <= lines; ++image)
      if (is_image(lines, image)) scatter_group(job, g, image, blocks, out);
    first += g.count;
  }
  return true;
}

namespace {

// Subtracts one batch from the diagonal, source by source.
void take_off(const ColumnSystem& system, const Integrator& in, const int32_t node[kElementNodes], const Group& g, int image,
              double* sum) {
  double* diagonal = system.diagonal + 4 * static_cast<int64_t>(g.first);
  for (int s = 0; s < g.count; ++s) {
    if (is_passed_over(system.twin[g.first + s])) continue;
    Source p;
    double own[2][2];
    const int singular = singular_lane(system, in, node, g, image, s, p);
    if (singular >= 0) rigid_sum(in, p.x, p.y, singular, own);
    for (int i = 0; i < 4; ++i) {
      const double value = singular >= 0 ? own[i / 2][i % 2] : sum[4 * s + i];
      diagonal[4 * s + i] -= image_sign(image, i / 2) * image_sign(image, i % 2) * value;
    }
  }
}

} // namespace

bool fill_diagonal_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[kElementNodes],
                           int32_t first_node, int32_t count) {
  if (kSmallCode || !system.batch) return false;
  if (is_ring(integrator)) return kRingPart.take_rings(system, integrator, node, first_node, count);
  if (!is_batched(integrator, false)) return false;
  const int32_t lines = system.model.body[system.body].lines;
  const BatchElement element = batch_element(integrator);
  const int32_t end = first_node + count;
  const OwnSources own = own_sources(system, node, integrator.functions);
  double room[2 * kBatch], sum[4 * kBatch];
  for (int32_t first = first_node; first < end;) {
    const Group g = group_at(system, own, first, end);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      // The frequent case subtracts in registers.
      if (image == 0 && g.plain) {
        system.batch->rigid_off(element, system.point + 2 * static_cast<int64_t>(first), g.count,
                                system.diagonal + 4 * static_cast<int64_t>(first));
        continue;
      }
      for (int32_t s = 0; s < g.count; s += kBatch) {
        const Group part{first + s, g.count - s < kBatch ? g.count - s : kBatch, false};
        system.batch->rigid(element, places(system, part.first, part.count, image, room), sum);
        take_off(system, integrator, node, part, image, sum);
      }
    }
    first += g.count;
  }
  return true;
}

} // namespace c2d
