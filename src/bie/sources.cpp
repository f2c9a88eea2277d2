// Collocation points, their mirror images, and the integrals of one element for all of them (METHOD 2.2, METHOD 5).
//
// Images: with R the reflection, T(P, RQ) R = R T(RP, Q), METHOD (5.1). So the element is integrated as it is for the mirrored
// source, and the rows get the signs of R.
// Diagonal: the block of a source is minus the sum of all others, since a translation needs no tractions (thesis (A.5);
// Brebbia and Dominguez, Boundary Elements: An Introductory Course, on rigid-body motion).
#include "bie/diagonal.hpp"
#include "bie/holes.hpp"
#include "bie/integrals/batch_sources.hpp"
#include "bie/panel.hpp"
#include "model/symmetry.hpp"

namespace c2d {

C2D_USES(HolePart);

Source mirrored_source(const ModelHeader& head, int image, const double at[2]) {
  if (image == 0) return Source{at[0], at[1], true};
  // Equality decides whether a source is its own image.
  double p[2];
  for (int c = 0; c < 2; ++c) p[c] = (image >> c & 1) != 0 ? 2.0 * (head.line_at[c] / head.length_unit) - at[c] : at[c];
  return Source{p[0], p[1], p[0] == at[0] && p[1] == at[1]};
}

bool place_sources(const ColumnSystem& system) {
  bool some_passed_over = false;
  const Model& m = system.model;
  for (int32_t node = 0; node < m.body[system.body].nodes; ++node) {
    double x, y;
    node_position(m, system.body, node, &x, &y);
    system.point[2 * static_cast<int64_t>(node)] = x / m.head->length_unit;
    system.point[2 * static_cast<int64_t>(node) + 1] = y / m.head->length_unit;
    const bool second = is_second_twin(m, system.body, node);
    system.twin[node] = second ? kSecondTwin : twin_node(m, system.body, node);
    int32_t ends[2];
    if (m.body[system.body].lines != 0 && ends_at_node(m, system.body, node, ends) == 0) system.twin[node] = kAxisNode;
    some_passed_over = some_passed_over || system.twin[node] < kSingle;
  }
  return some_passed_over;
}

int singular_node(const int32_t node[kElementNodes], int count, int32_t source, int32_t twin) {
  for (int l = 0; l < count; ++l)
    if (node[l] == source || (twin >= 0 && node[l] == twin)) return l;
  return -1;
}

namespace {

void sign_rows(int image, int functions, double block[kElementNodes][2][2]) {
  for (int l = 0; l < functions; ++l)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) block[l][i][j] *= image_sign(image, i);
}

// The term L n tr V of METHOD (4.1): one row of integrals, multiplied by the normal at each node of the hole.
void scatter_hole(const ColumnSystem& system, const Hole& hole, bool want_h, bool want_g) {
  Blocks& blocks = system.scratch->blocks;
  HoleRow& row = system.scratch->hole_row;
  kHolePart.hole_row(system.model, system.body, hole, system.scratch->integrator, want_h, want_g, system.scratch->hole_field,
                     row);
  visit_hole(system, hole, [&](int32_t node, const double n[2]) {
    for (int l = 0; l < system.scratch->integrator.functions; ++l)
      for (int i = 0; i < 2; ++i)
        for (int c = 0; c < 2; ++c) {
          if (want_h) blocks.h[l][i][c] = n[i] * row.h[l][c];
          if (want_g) blocks.g[l][i][c] = n[i] * row.g[l][c];
        }
    system.scratch->deposits.scatter(node);
  });
}

} // namespace

void scatter_sources(const ColumnSystem& system, const Hole* hole, const int32_t node[kElementNodes], bool want_h,
                     bool want_g) {
  if (hole) return scatter_hole(system, *hole, want_h, want_g);
  const Integrator& integrator = system.scratch->integrator;
  const Deposits& deposits = system.scratch->deposits;
  Blocks& blocks = system.scratch->blocks;
  // Several sources at once in vector registers, if element and build allow it.
  if (scatter_batches(system, integrator, node, blocks, deposits)) return;
  const Model& m = system.model;
  const int nf = m.head->function_nodes;
  const int32_t lines = images_of(system), end = sources_of(system);
  Samples samples;
  for (int32_t source = 0; source < end; ++source) {
    const int32_t twin = system.twin[source];
    if (twin == kSecondTwin || twin == kAxisNode) continue;
    const double* at = system.point + 2 * static_cast<int64_t>(source);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      const Source p = mirrored_source(*m.head, image, at);
      const int singular = p.on_itself ? singular_node(node, nf, node_of_source(system, source), twin) : -1;
      // A source on a line of symmetry is its own image: there the image's integrals are singular, too.
      integrate(integrator, p.x, p.y, singular, want_h, want_g, blocks, &samples);
      if (image > 0 && want_h) sign_rows(image, nf, blocks.h);
      if (image > 0 && want_g) sign_rows(image, nf, blocks.g);
      deposits.scatter(source);
    }
  }
}

void take_rigid_sums(const ColumnSystem& system, int32_t element, int32_t first, int32_t count) {
  const Model& m = system.model;
  const int b = system.body, nf = m.head->function_nodes;
  const int32_t lines = image_lines(m, b);
  Integrator& integrator = system.scratch->integrator;
  make_integrator(m, b, element, system.quadrature, Measure::own_length, integrator);
  int32_t node[kElementNodes];
  for (int l = 0; l < nf; ++l) node[l] = functional_node(m, b, element, l);
  if (fill_diagonal_batches(system, integrator, node, first, count)) return;
  for (int32_t source = first; source < first + count; ++source) {
    const int32_t twin = system.twin[source];
    if (twin == kSecondTwin || twin == kAxisNode) continue;
    double sum[2][2];
    const double* at = system.point + 2 * static_cast<int64_t>(source);
    double* block = system.diagonal + 4 * static_cast<int64_t>(source);
    for (int image = 0; image <= lines; ++image) {
      if (!is_image(lines, image)) continue;
      const Source p = mirrored_source(*m.head, image, at);
      const int singular = p.on_itself ? singular_node(node, nf, node_of_source(system, source), twin) : -1;
      rigid_sum(integrator, p.x, p.y, singular, sum);
      for (int i = 0; i < 4; ++i) block[i] -= image_sign(image, i / 2) * image_sign(image, i % 2) * sum[i / 2][i % 2];
    }
  }
}

void fill_diagonal(const ColumnSystem& system, int32_t first_node, int32_t count) {
  const Model& m = system.model;
  const int b = system.body;
  for (int64_t i = 4 * static_cast<int64_t>(first_node); i < 4 * static_cast<int64_t>(first_node + count); ++i)
    system.diagonal[i] = 0.0;
  // Straight elements: closed form, no element needs to be visited.
  if (fill_diagonal_closed(system, first_node, count)) return;
  for (int32_t element = 0; element < m.body[b].elements; ++element)
    if (is_integrated(m, b, element)) take_rigid_sums(system, element, first_node, count);
}

} // namespace c2d
