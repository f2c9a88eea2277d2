// The problems that `contact2d make` knows: the sketches of examples/families, whose text is part of the program.
#pragma once

#include <string>
#include <vector>

namespace families {

struct Family {
  const char* name;
  const char* sketch; // its text
};
struct Parameter {
  std::string key;
  std::string value;   // the default
  std::string meaning; // of a choice, begins with the words allowed, separated by |, and a colon; they count from 0
};

const std::vector<Family>& all_families();
const Family* find_family(const std::string& name);

// Those whose default is a number and of which the comment behind them says something.
std::vector<Parameter> parameters_of(const Family& family);
std::string summary_of(const Family& family); // its title
// Names and summaries, a line each; with a name that family's parameters too.
std::string list_families();
std::string describe(const Family& family);

// Deck of a family, with the given divisions of its curves, from words such as "n=20"; false with `error` telling what is wrong
// and what is known.
bool make_deck(const std::string& name, const std::vector<std::string>& settings, std::string& deck, std::string& error);

} // namespace families
