#pragma once
// Fingerprint and sizes of a model.
#include "solver/phases.hpp"
#include "solver/solver.hpp"

namespace c2d {

// Of everything that decides the numbers on the tapes.
uint64_t hash_model(const Model& model, const c2d_options& options);

} // namespace c2d
