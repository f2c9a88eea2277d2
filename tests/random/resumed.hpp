#pragma once
// Random models ended at some of their steps and taken up by another solver: the same bytes and messages
// (tests/interrupted.hpp).
#include "judge.hpp"

namespace random_decks {

Verdict judge_resumed(uint64_t seed);

} // namespace random_decks
