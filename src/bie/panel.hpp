#pragma once
// Adding to a panel of columns: one number, or the integrals of an element for one source after another.
#include "bie/deposits.hpp"
#include "bie/holes.hpp"
#include "bie/integrals/interior.hpp"
#include "bie/targets.hpp"
#include "bie/transfer.hpp"
#include "contact2d_memory.h"

namespace c2d {

struct Panel {
  const Model& m;
  int b;
  Range range;
  Real* data;
  int64_t ld;
  const int32_t* place = nullptr; // of each column, -1: none; null: those of the range, in order

  Real* column(int32_t j) const {
    if (place) return place[j] >= 0 ? data + place[j] * ld : nullptr;
    return range.contains(j) ? data + (j - range.first) * ld : nullptr;
  }
  void add(int32_t row, int32_t j, double value) const {
    if (Real* to = column(j)) to[row] += static_cast<Real>(value);
  }
  template <class Value> void send(const Destination& d, int32_t row, double integral, Value value) const {
    for (const Target& target : d.target)
      if (target.column >= 0) add(row, target.column, target.factor * integral);
    if (!d.known) return;
    for (int32_t k = range.first_case(); k < range.end_case(); ++k)
      if (const double given = value(k); given != 0.0) add(row, range.right + k, given * integral);
  }
  void send_h(const Destination& d, int32_t node, int c, int32_t row, double integral) const {
    send(d, row, integral, [&](int32_t k) { return known_displacement(m, b, node, c, k); });
  }
  void send_g(const Destination& d, int32_t element, int l, int c, int32_t row, double integral) const {
    send(d, row, integral, [&](int32_t k) {
      const int32_t end = element * m.head->function_nodes + l;
      return given_traction(m, b, end, c, k) == 0.0 ? 0.0 : known_traction(m, b, element, l, c, k);
    });
  }
};

struct AssemblyScratch {
  ElementTargets targets;
  Integrator integrator;
  Blocks blocks;
  Deposits deposits;
  HoleRow hole_row;
  FieldElement hole_field;
  Transfer transfer;
};
constexpr uint64_t kAssemblyBytes = C2D_ASSEMBLY_BYTES;
static_assert(sizeof(AssemblyScratch) <= kAssemblyBytes, "C2D_ASSEMBLY_BYTES of contact2d_memory.h bounds it on any target");

inline void add_deposits(const Panel& panel, const Destination& d, const double* block, Deposits& out) {
  for (const Target& target : d.target)
    if (target.column >= 0) out.add(block, panel.column(target.column), target.factor);
}

// Integrals of the scratch's element for every source and image, added where its deposits say. With a hole: the additional
// terms of its nodes' equations instead.
void scatter_sources(const ColumnSystem& system, const Hole* hole, const int32_t node[kElementNodes], bool want_h, bool want_g);

// The blocks of one element for every source, tractions in one measure; displacements go with its own length.
void add_element(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t element, const ElementTargets& t,
                 Measure measure);
// Its share of the three balances, in rows from `row` on.
void add_balance(const ColumnSystem& system, const Panel& panel, int32_t element, const ElementTargets& t, Measure measure,
                 int32_t row);
// Free term, twin equations and the multipliers' columns of one source.
void add_node(const ColumnSystem& system, const Panel& panel, int32_t source);

// Point loads of the body and its body force of one load case, in the right-hand sides; `hole` as above.
void add_point_load(const ColumnSystem& system, const Hole* hole, const Panel& panel, const PointLoad& load);
void add_body_force_columns(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t load_case);
// H u_p - G t_p of one element, its share of that.
void add_particular(const ColumnSystem& system, const Hole* hole, const Panel& panel, int32_t element, int32_t load_case);

} // namespace c2d
