#pragma once
// Judges a random model of many bodies by balances, no overlap, Coulomb's law, energies, and the same model told otherwise.
#include "../many_bodies.hpp"
#include "judge.hpp"

#include <string>
#include <vector>

namespace random_decks {

struct BodyForm {
  std::string name;
  many::Model model;
  many::Mapping map;
};
// Bodies and zones in another order, other units. A model of one zone has one order of them.
std::vector<BodyForm> common_forms(const many::Model& model);

// Fills in all but the title.
void judge_bodies(Verdict& verdict, const many::Model& model, const std::vector<BodyForm>& forms);

} // namespace random_decks
