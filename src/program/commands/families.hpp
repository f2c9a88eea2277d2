// The families of problems of `contact2d make`: the sketches of examples/families, compiled into the program.
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
  std::string meaning; // for a choice: begins with the allowed words, separated by | and followed by a colon; they count from 0
};

const std::vector<Family>& all_families();
const Family* find_family(const std::string& name);

// The parameters with a numeric default and a comment that explains them.
std::vector<Parameter> parameters_of(const Family& family);
std::string summary_of(const Family& family); // its title
// All families with their parameters; describe: one family.
std::string list_families();
std::string describe(const Family& family);

// Writes the deck of a family, with the divisions of its statements `elements`, from settings such as "n=20". On failure
// returns false, with the reason and the known keys in `error`.
bool make_deck(const std::string& name, const std::vector<std::string>& settings, std::string& deck, std::string& error);

} // namespace families
