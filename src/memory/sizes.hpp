#pragma once
// Derived sizes, and the one layout function for both c2d_memory_need and the workspace.
#include "contact2d.h"
#include "contact2d_memory.h"
#include "memory/config.hpp"

namespace c2d {

// Every array in the workspace, in the order of the layout: the lists of contact2d_memory.h. src/FROM-1987.md maps them to the
// arrays of the 1987 program.
enum ArrayId : int32_t {
#define C2D_ID(type, name, count, each) k##name,
  C2D_BODY_LISTS_(C2D_ID, ) kArraysOfBodies,                              // those of BodyArrayId, one body after the other
  C2D_MODEL_ARRAYS_(C2D_ID, , , , , , , , ) C2D_CYCLE_ARRAYS_(C2D_ID, , ) //
  kPhase, // the rest: what assembly, reduction and contact use one after another (A)
  kArrays
};
enum BodyArrayId : int32_t { C2D_BODY_ARRAYS_(C2D_ID, , , , , ) kBodyArrays };
#undef C2D_ID

// Sizes of a body within given limits.
struct BodySizes {
  int64_t geometry_nodes, elements, regions;
  int64_t nodes; // functional nodes
  int64_t ends;  // element ends: elements * function_nodes
  int64_t rows;  // equations: 2 nodes + 3, and 2 for each pair of a free zone
};
struct Sizes {
  int32_t bodies, function_nodes, load_cases, panel_columns;
  c2d_body_limits* body; // [bodies], not changed; null in a solver, which has it in its list kBodyLimits
  int64_t zones, pairs, contact_elements, point_loads, coefficients, paths;
  int64_t contact;    // contact unknowns at most: 2 pairs
  int64_t motions;    // of bodies that only the contact constrains, at most
  int64_t free_pairs; // of them, those of free zones
  int64_t point_sets, curves;
  int64_t platens;  // the last of the bodies; they have no mesh
  int64_t touching; // pairs for whose columns there is room; 0: for all
  int64_t cycle_states;
};
// Columns of the contact system that fit.
inline int64_t columns_of(const Sizes& sizes) {
  return kSmallCode ? sizes.contact : C2D_COLUMNS_(sizes.contact, sizes.touching); // (small code has all)
}
BodySizes sizes_of_body(const Sizes& sizes, int b);
// C2D_ELIMINATION_DENSE or COMPRESSED: which one by size.
int32_t elimination_by_size(const Sizes& sizes);

// The first limit that is out of range: its name (null: there is no list of bodies), its body (from 0; -1: none), and the
// range.
struct WrongLimit {
  const char* member;
  int32_t body, value, least, most;
};
bool find_wrong_limit(const c2d_limits& limits, WrongLimit& out);

// Checks and completes the limits. Their list of bodies must stay valid. Errors: C2D_ERR_ARGUMENT.
c2d_status derive_sizes(const c2d_limits& limits, Sizes& out);
// The limits that these sizes were derived from.
c2d_limits limits_of(const Sizes& sizes);

struct Layout {
  uint64_t offset[kArrays]; // from the aligned start of the workspace
  uint64_t persistent;      // bytes up to kPhase
};

constexpr uint64_t kAlignment = 64; // of the workspace, and of the lists of the phases
static_assert(sizeof(Real) == C2D_REAL_BYTES, "C2D_REAL=float needs C2D_REAL_BYTES=4");

// The layout of everything up to the phase area (whose size solver/phases.hpp gives). `header` is the size of the solver's own
// struct. Errors: C2D_ERR_OVERFLOW.
c2d_status lay_out(const Sizes& sizes, uint64_t header, Layout& out);
// The arrays of one body, from `at` on: their places; returns the end. For sizes that lay_out() has passed.
uint64_t lay_out_body(const Sizes& sizes, int b, uint64_t at, int64_t place[kBodyArrays]);

// Checked arithmetic: false if the result does not fit.
bool add_bytes(uint64_t& sum, uint64_t count, uint64_t size);
uint64_t round_up(uint64_t bytes); // to a multiple of kAlignment
// Carves arrays one after another, each from a multiple of 8 bytes on. `used`: bytes so far.
struct Carver {
  uint64_t used;
  bool fits;
  uint64_t carve(uint64_t count, uint64_t size); // where the array begins
  void align() { used = round_up(used); }
};
// Arrays of a work area, each aligned to kAlignment; null pointers if base is null, to count only.
struct AreaCarver {
  char* base;
  Carver carver{0, true};
  template <class T> void take(T*& out, uint64_t count) {
    carver.align();
    const uint64_t at = carver.carve(count, sizeof(T));
    out = base ? reinterpret_cast<T*>(base + at) : nullptr;
  }
  uint64_t total() { // UINT64_MAX: beyond any memory
    carver.align();
    return carver.fits ? carver.used : UINT64_MAX;
  }
};

} // namespace c2d
