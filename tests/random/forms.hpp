#pragma once
// The same deck told in other ways, which must end the same.
#include "generator.hpp"

#include <string>
#include <vector>

namespace random_decks {

struct Form {
  std::string name;
  problem::Problem problem;
  problem::Setup setup;
  problem::Mapping map; // turns the form's numbers into the deck's
  bool equal_bits = false;
  int32_t rows = 1; // recorded rows of the form for one of the deck
};

std::vector<Form> forms_of(const Model& model, uint64_t seed);

// Empty, or how the two differ. Differences are judged by the largest of their kind on the whole path.
std::string difference(const Model& model, const problem::Result& deck, const Form& form, const problem::Result& other);

// The same for a symmetric model and its own image, as long as load case 2 has not come.
std::string asymmetry(const Model& model, const problem::Result& deck);

} // namespace random_decks
