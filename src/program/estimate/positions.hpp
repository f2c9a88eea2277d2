// Errors of numbers from the positions of moving loads.
#pragma once

#include "program/estimate/loop.hpp"

namespace estimate {

// adapt(), and for a sketch with moving loads then the positions: on the final mesh they are doubled until the stated error of
// every requested number, to which the change by the last doubling is added, is below its tolerance. The deck of the result
// has the positions of the last one.
Adapted adapt_positions(const sketch::Sketch& sketch, const Demand& demand,
                        const std::function<void(const app::MeshRound&)>& report, TrialKeeper* keeper = nullptr);

} // namespace estimate
