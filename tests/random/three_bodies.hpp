#pragma once
// Random models of three bodies (make random KIND=three): how they stand together, of what they are, how they meet, how they
// are held and loaded. Judged by balances, no overlap, Coulomb's law, energies, and the same model told otherwise.
#include "../many_bodies.hpp"
#include "judge.hpp"

namespace random_decks {

many::Model generate_three(uint64_t seed, std::string& title);
Verdict judge_three(uint64_t seed);

} // namespace random_decks
