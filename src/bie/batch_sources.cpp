#include "bie/batch_sources.hpp"

#include "bie/batch.hpp"
#include "model/symmetry.hpp"

namespace c2d {

#ifdef C2D_SMALL

bool pay_batches(const ColumnSystem&, const Integrator&, const int32_t*, Blocks&, const Deposits&) { return false; }

bool fill_diagonal_batches(const ColumnSystem&, const Integrator&, const int32_t*, int32_t, int32_t) { return false; }

#else

namespace {

// Sources at the element's own functional nodes: they have integrals of their own kind.
struct OwnSources {
  int32_t source[4];
  int count;
};

OwnSources own_sources(const ColumnSystem& system, const int32_t node[4], int functions) {
  OwnSources own;
  own.count = functions;
  for (int l = 0; l < functions; ++l)
    own.source[l] =
        system.twin[node[l]] == kSecondTwin ? twin_node(system.model, system.body, node[l]) : node[l];
  return own;
}

// Consecutive sources, fewer than a batch at the body's end.
struct Group {
  int32_t first;
  int count;
  bool plain; // every lane is a source that does not sit on the element
};

Group group_of(const ColumnSystem& system, const OwnSources& own, int32_t first, int32_t end) {
  Group g;
  g.first = first;
  g.count = end - first < kBatch ? end - first : kBatch;
  g.plain = g.count == kBatch;
  if (!g.plain) return g;
  const int32_t* twin = system.twin + first;
  int32_t signs = 0;
  for (int s = 0; s < kBatch; ++s) signs |= twin[s] - kSingle;
  g.plain = signs >= 0;
  for (int n = 0; n < own.count; ++n) g.plain = g.plain && (own.source[n] < first || own.source[n] >= first + kBatch);
  return g;
}

bool is_passed_over(int32_t twin) { return twin == kSecondTwin || twin == kAxisNode; }

// Where the sources of a group stand for an image; `room` if not where they are stored.
const double* places(const ColumnSystem& system, const Group& g, int image, double room[2 * kBatch]) {
  const double* at = system.point + 2 * static_cast<int64_t>(g.first);
  if (image == 0 && g.count == kBatch) return at;
  for (int s = 0; s < kBatch; ++s) {
    const Source p = mirrored_source(*system.model.head, image, at + 2 * (s < g.count ? s : g.count - 1));
    room[2 * s] = p.x;
    room[2 * s + 1] = p.y;
  }
  return room;
}

// Local node at which lane s sits, -1 if none.
int singular_lane(const ColumnSystem& system, const Integrator& in, const int32_t node[4], const Group& g, int image,
                  int s, Source& p) {
  const int32_t source = g.first + s;
  p = mirrored_source(*system.model.head, image, system.point + 2 * static_cast<int64_t>(source));
  return p.on_itself ? singular_node(node, in.functions, source, system.twin[source]) : -1;
}

// Where a deposit's integrals stand in the batch's blocks.
int place_in_batch(const Blocks& blocks, const double* block) {
  const int at = static_cast<int>(block - &blocks.h[0][0][0]), own = at % 16;
  return (at / 16 * 8 + own / 4 * 2 + own % 2) * 2 * kBatch;
}

struct BatchJob {
  const ColumnSystem& system;
  const Integrator& in;
  const int32_t* node;
  const Deposits& deposits;
  bool want_h, want_g;
};

// Lanes that are no source get nothing, those on the element what is theirs.
void mend_lanes(const BatchJob& job, const Group& g, int image, Blocks& blocks, BatchBlocks& out) {
  for (int s = 0; s < g.count; ++s) {
    Source p;
    const bool none = is_passed_over(job.system.twin[g.first + s]);
    const int singular = none ? -1 : singular_lane(job.system, job.in, job.node, g, image, s, p);
    if (!none && singular < 0) continue;
    if (!none) integrate(job.in, p.x, p.y, singular, job.want_h, job.want_g, blocks);
    for (int l = 0; l < job.in.functions; ++l)
      for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
          if (job.want_h) out.h[l][j][2 * s + i] = none ? 0.0 : blocks.h[l][i][j];
          if (job.want_g) out.g[l][j][2 * s + i] = none ? 0.0 : blocks.g[l][i][j];
        }
  }
}

void pay_group(const BatchJob& job, const Group& g, int image, const Blocks& blocks, const BatchBlocks& out) {
  const double* numbers = &out.h[0][0][0];
  const double sign[2] = {image_sign(image, 0), image_sign(image, 1)};
  for (int n = 0; n < job.deposits.count; ++n) {
    const Deposit& d = job.deposits.list[n];
    const double* values = numbers + place_in_batch(blocks, d.block);
    const double factor[2] = {d.factor * sign[0], d.factor * sign[1]};
    Real* to = d.column + 2 * static_cast<int64_t>(g.first);
    if (g.count == kBatch) {
      job.system.batch->deposit(values, factor, to);
      continue;
    }
    for (int i = 0; i < 2 * g.count; ++i) to[i] += static_cast<Real>(factor[i % 2] * values[i]);
  }
}

} // namespace

bool pay_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[4], Blocks& blocks,
                 const Deposits& deposits) {
  BatchJob job{system, integrator, node, deposits, false, false};
  for (int n = 0; n < deposits.count; ++n)
    (deposits.list[n].block < &blocks.g[0][0][0] ? job.want_h : job.want_g) = true;
  if (!system.batch || !is_batched(integrator, job.want_g)) return false;
  const ModelHeader& head = *system.model.head;
  const int32_t end = head.body[system.body].nodes;
  const OwnSources own = own_sources(system, node, integrator.functions);
  const BatchElement element = batch_element(integrator);
  BatchBlocks out;
  double room[2 * kBatch];
  for (int32_t first = 0; first < end; first += kBatch) {
    const Group g = group_of(system, own, first, end);
    for (int image = 0; image <= head.symmetry; ++image) {
      if (!is_image(head, image)) continue;
      system.batch->integrate(element, places(system, g, image, room), job.want_h, job.want_g, out);
      if (!g.plain) mend_lanes(job, g, image, blocks, out);
      pay_group(job, g, image, blocks, out);
    }
  }
  return true;
}

namespace {

void add_to_diagonal(const ColumnSystem& system, const Group& g, int image, const double sum[2][2 * kBatch]) {
  const double same = image_sign(image, 0) * image_sign(image, 1), own = 1.0; // of rows and columns together
  double* block = system.diagonal + 4 * static_cast<int64_t>(g.first);
  for (int s = 0; s < g.count; ++s, block += 4) {
    if (is_passed_over(system.twin[g.first + s])) continue;
    block[0] -= own * sum[0][2 * s];
    block[1] -= same * sum[0][2 * s + 1];
    block[2] -= same * sum[1][2 * s];
    block[3] -= own * sum[1][2 * s + 1];
  }
}

} // namespace

bool fill_diagonal_batches(const ColumnSystem& system, const Integrator& integrator, const int32_t node[4],
                           int32_t first_node, int32_t count) {
  if (!system.batch || !is_batched(integrator, false)) return false;
  const ModelHeader& head = *system.model.head;
  const int32_t end = first_node + count;
  const OwnSources own = own_sources(system, node, integrator.functions);
  const BatchElement element = batch_element(integrator);
  double room[2 * kBatch], sum[2][2 * kBatch];
  for (int32_t first = first_node; first < end; first += kBatch) {
    const Group g = group_of(system, own, first, end);
    for (int image = 0; image <= head.symmetry; ++image) {
      if (!is_image(head, image)) continue;
      system.batch->rigid(element, places(system, g, image, room), sum);
      for (int s = 0; s < g.count && !g.plain; ++s) {
        Source p;
        const int singular = singular_lane(system, integrator, node, g, image, s, p);
        double of_own[2][2];
        if (singular < 0) continue;
        rigid_sum(integrator, p.x, p.y, singular, of_own);
        for (int i = 0; i < 4; ++i) sum[i / 2][2 * s + i % 2] = of_own[i / 2][i % 2];
      }
      add_to_diagonal(system, g, image, sum);
    }
  }
  return true;
}

#endif

} // namespace c2d
