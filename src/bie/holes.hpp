#pragma once
// Equations that holes need (METHOD 4). The boundary equations also state that the displacement V = int U t - int T u vanishes
// in the space inside every hole. For an incompressible material that leaves a constant pressure there undetermined: H and G
// both have the normal n of the hole as a left null vector, and the hole's own state of pressure is in the null space of H.
// (n.(H u - G t) summed over the hole is 1 - 2 nu times something: the errors of the discretisation are divided by it.) The
// equations at the nodes of a hole therefore are
//   H u - G t + L n tr V = 0,   tr V: trace of the stress of V inside the hole, 0 in the exact solution,
// with a length L of the hole. The place inside follows from the hole's shape alone, so that no rotation, reflection or
// numbering of the boundary changes results: the centroid of its area, or, if that is not well inside, the centre of its
// largest circle; of two that mirror each other, both. The sign is that of a filling which no pressure of its own can keep
// displaced.
#include "bie/columns.hpp"
#include "memory/parts.hpp"

namespace c2d {

// A closed curve with the material outside it, by itself or completed by its images: a run of elements of one region.
struct Hole {
  int32_t region, first, elements;
  int32_t points;
  double at[2][2]; // points inside, in the length unit: their mean is used
  double length;   // width of the hole, likewise: of a circle with its ratio of area to length
};

// Holes one after another: start with HoleWalk{}; false when there is none left.
struct HoleWalk {
  int32_t region, element, done; // begin of the next run; elements of the region already visited
};
bool next_hole(const Model& model, int b, HoleWalk& walk, Hole& out);

struct FieldElement; // bie/integrals/interior.hpp
// The share of each local node's displacement and traction (in the integrator's measure) in L tr V, with the signs of the sums
// h u - g t.
struct HoleRow {
  double h[kElementNodes][2], g[kElementNodes][2];
};
void hole_row(const Model& model, int body, const Hole& hole, const Integrator& integrator, bool want_h, bool want_g,
              FieldElement& scratch, HoleRow& out);
// The same for a point load, on the side of G t.
double hole_load(const Model& model, int b, const Hole& hole, const PointLoad& load);

// Visits every node of the hole that has equations of its own: visit(node, n) with a normal n, not of unit length.
void hole_normal(const Model& model, int b, int32_t node, double n[2]);
template <class Visit> void visit_hole(const ColumnSystem& system, const Hole& hole, Visit visit) {
  const Model& m = system.model;
  const int b = system.body, nf = m.head->function_nodes;
  int32_t element = hole.first, before = -1;
  for (int32_t k = 0; k < hole.elements; ++k) {
    for (int l = 0; l < nf; ++l) {
      const int32_t node = functional_node(m, b, element, l);
      const bool closes = k + 1 == hole.elements && k > 0 && node == functional_node(m, b, hole.first, 0);
      if (node == before || closes || system.twin[node] == kSecondTwin) continue;
      before = node;
      double n[2];
      kHolePart.hole_normal(m, b, node, n);
      visit(node, n);
    }
    element = element_after(m, b, element);
  }
}

} // namespace c2d
