#pragma once
// Column-wise assembly of the balanced boundary equations of one body (METHOD 2):
//   H u - G t - rho - omega e_z x (x - x0) = 0 at every functional node, and forces and moment of all t add to 0.
// With lines of symmetry (model/symmetry.hpp) every element acts together with its images. An equation that symmetry leaves
// empty becomes "its unknown is zero".
// Lengths are in ModelHeader::length_unit, outer tractions of body b in 2 G_b, contact tractions tau in stress_unit.
//
// Rows: 2 p, 2 p + 1 for functional node p; then three, the balances of force x, force y and moment; then, for each contact
// unknown of free zones with the body on side 0, u_c = sum N_l u_l at the pair's point (bie/transfer.hpp).
// Columns, in this order:
//   outer unknowns, node by node (Body::columns of them), then rho_x, rho_y, omega    A_o
//   contact displacements u_c in the pairs' frames                                      H_c   (m columns)
//   contact tractions tau, as force on side 1, in the pairs' frames                     G_c   (m columns)
//   right-hand sides of the load cases                                                  r     (L columns)
// so that A_o x_o + H_c u_c = G_c t_c + sum_k lambda_k r_k with t_c = +tau on side 1 and -tau on side 0. m is
// the body's own number of contact unknowns, Body::contact; column dof_on() is the first one of a pair.
#include "bie/measure.hpp"
#include "memory/config.hpp"
#include "model/symmetry.hpp"

namespace c2d {

struct AssemblyScratch; // bie/panel.hpp: work space for one element at a time, too large for a small stack
struct BatchKernel;
struct Hole;
struct ColumnSystem {
  Model model;
  int32_t body;
  Quadrature quadrature;
  double* diagonal; // [4 * nodes]: free term and principal value, 2x2 row by row, from rigid translation, thesis (A.5)
  double* point;    // [2 * nodes]: collocation points in the length unit
  int32_t* twin;    // [nodes]: the other node of a double node, kSingle, or kSecondTwin (no collocation there)
  AssemblyScratch* scratch;
  const BatchKernel* batch = nullptr; // bie/integrals/batch.hpp; null: sources are processed one by one
  bool some_passed_over = true;       // second twins or nodes of axis elements exist; from place_sources()
  // If not every node is a source (bie/integrals/chosen.hpp): point and twin then belong to the chosen ones alone.
  const int32_t* chosen = nullptr; // [sources] nodes, kNoNode for a point that is no node; null: all of the body's
  int32_t sources = 0;
  bool alone = false; // without images
  bool rest = false;  // without the sums over elements at the body's own nodes (elimination/far_sums.hpp)
};
constexpr int32_t kSingle = -1, kSecondTwin = -2, kAxisNode = -3; // kAxisNode: only axis elements meet there
constexpr int32_t kNoNode = -1;
inline int32_t sources_of(const ColumnSystem& s) { return s.chosen ? s.sources : s.model.body[s.body].nodes; }
inline int32_t node_of_source(const ColumnSystem& s, int32_t source) { return s.chosen ? s.chosen[source] : source; }
inline int32_t images_of(const ColumnSystem& s) { return s.alone ? 0 : image_lines(s.model, s.body); }

// The source as an image of the element sees it, in the length unit. With R the reflection T(P, RQ) R = R T(RP, Q), and U
// likewise: the image of an element acts on P as the element itself acts on RP, with the rows times the signs of R.
struct Source {
  double x, y;
  bool on_itself; // it lies on every line across which it is mirrored
};
Source mirrored_source(const ModelHeader& head, int image, const double at[2]);

// Fills `point` and `twin`; called first. Returns whether there are nodes without collocation.
bool place_sources(const ColumnSystem& system);

inline int32_t system_rows(const Model& m, int b) { return 2 * m.body[b].nodes + 3 + m.body[b].free_rows; }
inline int32_t outer_columns(const Model& m, int b) { return m.body[b].columns + 3; }
inline int32_t trailing_columns(const Model& m, int b) { return 2 * m.body[b].contact + m.head->load_cases; }

// Number the outer unknowns of a body: fills node_column and Body::columns. Once per model.
void number_unknowns(const Model& model, int b);

// Column of the unknown of a component at a node (displacement or traction), -1 if it belongs to the contact.
int32_t outer_column(const Model& model, int b, int32_t node, int component);

// Fill `diagonal` for the nodes [first, first + count): one integral with unit density per source and element.
void fill_diagonal(const ColumnSystem& system, int32_t first_node, int32_t count);

// Subtracts one element's share from the diagonal, for the sources [first, first + count).
void take_rigid_sums(const ColumnSystem& system, int32_t element, int32_t first, int32_t count);

// Assign all rows of columns first ... first+count-1; panel is column-major with leading dimension ld.
void fill_columns(const ColumnSystem& system, int32_t first, int32_t count, Real* panel, int64_t ld);

} // namespace c2d
