#pragma once
// Random models of bodies of revolution (make random KIND=revolved): discs and rings in piles, hubs on shafts with and without
// interference, plugs in conical seats, plates on rings, O-rings between plates. Judged as three bodies are, and resumed.
#include "../many_bodies.hpp"
#include "judge.hpp"

namespace random_decks {

many::Model generate_revolved(uint64_t seed, std::string& title);
Verdict judge_revolved(uint64_t seed);

} // namespace random_decks
