// Detects contact between the nodes of a mesh, from gaps of the drawn shapes and the displacements on two meshes.
#pragma once

#include "program/estimate/trial.hpp"
#include "program/sketch/refine.hpp"

namespace estimate {

// A mesh and its solution.
struct Solved {
  const sketch::Mesh& mesh;
  const Trial& trial;
};

// Result for a contact in which no pair touches.
struct OpenContact {
  bool misses = false; // surfaces overlap between open pairs
  bool unsure = false; // no pair touches, and the motions differ too much to exclude contact
  bool doubts() const { return misses || unsure; }
};

// One result per contact of the sketch; ties are always clear. Contact is excluded where the gap on the finer mesh is more than
// twice its change from the coarser mesh, and motions have changed by less than a fifth. `tolerance`, times the largest motion:
// smaller gaps and overlaps are not distinguished from contact.
std::vector<OpenContact> open_contacts(const sketch::Sketch& sketch, const Solved& coarse, const Solved& fine,
                                       double tolerance);

// Marks elements of the coarser mesh, `mesh`, with overlapping surfaces for bisection, down to the length of the overlap. These
// elements are no longer left out.
void mark_missed(const sketch::Sketch& sketch, const Solved& coarse, const Solved& fine, double tolerance, sketch::Mesh& mesh,
                 sketch::Levels& levels);

} // namespace estimate
