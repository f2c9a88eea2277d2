// c2d_link_compressed.
#include "memory/parts.hpp"
#include "results/interior/interior_cells.hpp"
#include "solver/demand/compressed.hpp"
#include "solver/demand/hold_demand.hpp"
#include "solver/demand/on_demand.hpp"

// Small code has no compressed elimination.
const c2d::CompressedPart c2d::kCompressedPart = kSmallCode ? CompressedPart()
                                                            : CompressedPart{true,
                                                                             elimination_by_size,
                                                                             plan_compression,
                                                                             compression_that_will_do,
                                                                             compression_tape,
                                                                             is_compression_of,
                                                                             compression_bytes,
                                                                             compression_back_bytes,
                                                                             later_bytes,
                                                                             compression_uses,
                                                                             compress,
                                                                             solve_compressed,
                                                                             compression_functional,
                                                                             compression_growth,
                                                                             plan_demand,
                                                                             tell_touching,
                                                                             respond_on_demand,
                                                                             make_columns,
                                                                             hold_on_demand,
                                                                             count_held,
                                                                             remake_columns,
                                                                             functional_of_motions,
                                                                             hold_functional,
                                                                             fit_rigid,
                                                                             has_far_cells,
                                                                             evaluate_by_cells};

extern "C" void c2d_link_compressed(void) {}
