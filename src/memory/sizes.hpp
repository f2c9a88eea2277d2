#pragma once
// Derived sizes and the one layout function that drives both c2d_memory_need and the carving of the workspace.
#include "contact2d.h"
#include "memory/config.hpp"

namespace c2d {

// Bytes of one element of the arrays whose types belong to the model (checked there with static_assert).
constexpr uint64_t kRegionBytes = 16, kZoneBytes = 72, kPairBytes = 104 + 14 * sizeof(Real), kPointLoadBytes = 48,
                   kPathBytes = 16, kBodyForceBytes = 40, kRigidMotionBytes = 40, kPointSetBytes = 56, kCurveBytes = 48;

// Every array that lives in the workspace, in the order in which memory is carved. Two arrays per body follow one
// another (`kXy + body`). src/FROM-1987.md maps them to the arrays of the 1987 program.
enum ArrayId : int32_t {
  kXy = 0,            // double [2 * geometry nodes]      boundary points (BNODE)
  kNodeLine = 2,      // int32  [geometry nodes]          line of the caller's input
  kEndTraction = 4,   // double [2 * ends * cases]        prescribed tractions (BCOND 1, 2)
  kNodeDisp = 6,      // double [2 * nodes * cases]       prescribed displacements (BCOND 3, 4)
  kEndCode = 8,       // uint8  [ends]                    what is known (ICODE 3 ... 6)
  kEndLine = 10,      // int32  [ends]
  kNodeColumn = 12,   // int32  [nodes + 1]               first column of a node among the outer unknowns
  kRegions = 14,      // Region [regions]                 (REGN)
  kZones = 16,        // Zone   [zones]                   (MCF, MCEL)
  kPairs = 17,        // Pair   [pairs]                   (MPAIR, UNTAVG)
  kPointLoads = 18,   // PointLoad [point loads]          (PTLOAD)
  kFriction = 19,     // double [coefficients]            (FMU), then [coefficients * zones], negative: the former
  kPaths = 20,        // Path   [paths]                   (PATH)
  kPairTable = 21,    // double [pairs * C2D_PAIR_FIELDS] results (UNION)
  kLoads = 22,        // double [4 * cases]               load factors: reached, target, direction, at stick
  kPathLoads = 23,    // double [paths * cases]           factors at the end of each piece of the path
  kEnergy = 24,       // double and Real [energy_bytes]   solver/energy.hpp
  kBodyForces = 25,   // BodyForce [2 * cases]            of both bodies, case by case
  kRigidMotions = 26, // RigidMotion [cases]              of body 1
  kPointSets = 27,    // PointSet [point sets]            where interior results are wanted
  kJudge = 28,        // double and Real [judge_bytes]    solver/judge.hpp
  kCurves = 29,       // Curve  [curves]                  what surfaces are between boundary points, where it is told
  kPhase = 30,        // the rest: what assembly, reduction and contact use one after another (A)
  kArrays = 31
};

// What a model within given limits needs, per body.
struct BodySizes {
  int64_t geometry_nodes, elements, regions;
  int64_t nodes; // functional nodes
  int64_t ends;  // element ends: elements * function_nodes
  int64_t rows;  // equations: 2 nodes + 3, and on body 1 2 for each pair of a free zone
};
struct Sizes {
  int32_t bodies, function_nodes, load_cases, panel_columns;
  BodySizes body[2];
  int64_t zones, pairs, contact_elements, point_loads, coefficients, paths;
  int64_t contact;    // contact unknowns at most: 2 pairs
  int64_t free_pairs; // of them, those of free zones
  int64_t point_sets, curves;
};

// Work, reaction and what they grow by, of each load case: 2 functionals of 2 m + cases numbers, and 5 numbers.
inline uint64_t energy_bytes(uint64_t m, uint64_t cases) { return (2 * cases + 5) * sizeof(double) + 4 * m * sizeof(Real); }

// 8 numbers of each load case, 4 of each contact unknown.
inline uint64_t judge_bytes(uint64_t m, uint64_t cases) { return 8 * cases * sizeof(double) + 4 * m * sizeof(Real); }

// Checks and completes the limits. Errors: C2D_ERR_ARGUMENT.
c2d_status derive_sizes(const c2d_limits& limits, Sizes& out);

struct Layout {
  uint64_t offset[kArrays]; // from the aligned start of the workspace
  uint64_t persistent;      // bytes up to kPhase
};

constexpr uint64_t kAlignment = 64;

// The sum that everything rests on, up to the phase area (whose size solver/phases.hpp tells). `header` is the size
// of the solver's own struct. Errors: C2D_ERR_OVERFLOW.
c2d_status lay_out(const Sizes& sizes, uint64_t header, Layout& out);

// Checked arithmetic: false if the result does not fit.
bool add_bytes(uint64_t& sum, uint64_t count, uint64_t size);
uint64_t round_up(uint64_t bytes);

} // namespace c2d
