// `contact2d run DECK`.
#pragma once

#include "program/options.hpp"
#include "program/store_choice.hpp"
#include "program/sweep/answer.hpp"

namespace app {

// Solves the deck and writes the outputs, and the responses whatever became of it. Returns the exit status.
int run_deck(const Options& options);

// The responses alone, for a row of a sweep (`options.text`): nothing is told or written. `store` holds what the row before has
// left: if that differs in friction and load factors alone, its factorisation is taken, which gives the same bits.
Answer answer_of(const Options& options, StoreChoice& store);

} // namespace app
