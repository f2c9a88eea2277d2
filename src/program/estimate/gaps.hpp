// Contact between the nodes of a mesh: gaps of the shapes themselves, with the motions of two meshes.
#pragma once

#include "program/estimate/trial.hpp"
#include "program/sketch/refine.hpp"

namespace estimate {

// A mesh with the states that were found on it.
struct Solved {
  const sketch::Mesh& mesh;
  const Trial& trial;
};

// What two meshes say of a contact where no pair touches.
struct OpenContact {
  bool misses = false; // surfaces lie in each other between pairs that are open
  bool unsure = false; // nothing touches, and the meshes do not agree on the motions well enough to rule contact out
  bool doubts() const { return misses || unsure; }
};

// One per contact of the sketch; ties are never in doubt. Contact is ruled out where the gap that is left on the finer mesh is
// more than twice what it has changed by since the coarser one, and motions have changed by less than a fifth. `tolerance`, of
// the largest motion: gaps that are open or closed by less than that are not distinguished.
std::vector<OpenContact> open_contacts(const sketch::Sketch& sketch, const Solved& coarse, const Solved& fine,
                                       double tolerance);

// Elements of the coarser mesh, `mesh`, in which surfaces lie in each other, marked until they are about as long as that; what
// was far there is no longer.
void mark_missed(const sketch::Sketch& sketch, const Solved& coarse, const Solved& fine, double tolerance, sketch::Mesh& mesh,
                 sketch::Levels& levels);

} // namespace estimate
