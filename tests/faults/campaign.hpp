// Every operation, every kill, every loss of power and every place that asks for memory (its first and its last allocation) of
// a job, or every `step`-th.
#pragma once

#include "judge.hpp"

namespace faults {

// Of the faults that the program can see: does this kind apply to such an operation?
bool can_strike(const Record& r, int kind, bool ever);

// `step`: 1 for all; else about one case of that many, always the same ones.
void fail_operations(const Place& place, const Job& job, uint64_t step, Tally& tally);
void lie(const Place& place, const Job& job, uint64_t step, Tally& tally);
void kill_at_operations(const Place& place, const Job& job, uint64_t step, Tally& tally);
void lose_power(const Place& place, const Job& job, uint64_t step, Tally& tally);
void refuse_memory(const Place& place, const Job& job, uint64_t step, Tally& tally);

} // namespace faults
