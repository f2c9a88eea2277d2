#pragma once
// Zones that are tied.
#include "model/model.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

// Its pairs lose their gaps, once they have frames. Fault: surfaces that are farther apart than a tenth of an element. Warning:
// C2D_WARN_TIE_END.
void close_tie(const Model& m, int32_t zone, Reporter& reporter);

} // namespace c2d
