// `contact2d run DECK`.
#pragma once

#include "program/files/store_choice.hpp"
#include "program/options.hpp"
#include "program/sweep/answer.hpp"

namespace app {

// Solves the deck and writes the outputs; writes the responses also after a failure. Returns the exit status.
int run_deck(const Options& options);

// Only the responses, for a row of a sweep (`options.text`), without messages or outputs. `store` has the tapes of the previous
// row: if only friction and load factors differ, its factorisation is reused and gives the same bits.
Answer answer_of(const Options& options, StoreChoice& store);

} // namespace app
