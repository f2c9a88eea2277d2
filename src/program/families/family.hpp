// The families of problems that `contact2d make` knows: parameters, defaults, and the model made from them.
#pragma once

#include "program/families/model.hpp"

#include <map>
#include <string>
#include <vector>

namespace families {

enum class Kind { kPositive, kAboveOne, kNumber, kCount, kOrder, kFraction, kPoisson, kFriction, kChoice };

struct Parameter {
  const char* key;
  Kind kind;
  const char* value;   // the default, as it would be written
  const char* meaning; // one line; of a choice, begins with the words allowed, separated by |, and a colon
};

// Values of all parameters of a family, given or default.
class Values {
public:
  double number(const std::string& key) const { return numbers_.at(key); }
  int count(const std::string& key) const { return static_cast<int>(numbers_.at(key)); }
  const std::string& word(const std::string& key) const { return words_.at(key); }
  // Takes over one value; false with what was expected in `expected`.
  bool set(const Parameter& parameter, const std::string& text, std::string& expected);

private:
  std::map<std::string, double> numbers_;
  std::map<std::string, std::string> words_;
};

struct Family {
  const char* name;
  const char* summary; // one line
  std::vector<Parameter> parameters;
  // The model; or, with an empty list of bodies, why these values do not go together, in its title.
  ProblemModel (*build)(const Values& values);
};

const std::vector<Family>& all_families();
const Family* find_family(const std::string& name);

// Model of a family from words such as "n=20"; false with `error` telling what is wrong and what is known.
bool make_model(const std::string& name, const std::vector<std::string>& settings, ProblemModel& model, std::string& error);
// Deck of a family from words such as "n=20"; false with `error` as above.
bool make_deck(const std::string& name, const std::vector<std::string>& settings, std::string& deck, std::string& error);
// Names and summaries, a line each; with a name that family's parameters too.
std::string list_families();
std::string describe(const Family& family);

// What build returns if the values do not go together.
ProblemModel unfit(const std::string& why);

Family hertz_family();
Family receding_layer_family();
Family layer_lifted_family();
Family layer_pressed_family();
Family disc_in_hole_family();
Family punch_family();
Family cylinder_friction_family();
Family mindlin_family();
Family rough_plates_family();
Family ring_family();
Family hole_family();
Family cantilever_family();
Family stack_family();
Family rollers_family();
Family bearing_family();
Family coating_family();
Family bimaterial_family();
Family shrink_family();
Family crack_family();

} // namespace families
