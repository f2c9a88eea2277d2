// Parameters of decks: {name} in a card stands for a value, {name=value} for one that has a default.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace app {

// "name=value" as name and value; false if it is none such: names are of letters, digits and _, values of printed characters
// without blanks and braces.
using Setting = std::pair<std::string, std::string>;
bool read_setting(const std::string& word, Setting& setting);

// Settings of the text of a file: lines `name = value`, `name value` or `{ name = value }`, `#` begins a comment; or a file of
// parameters of Dakota, in either of its formats, of which the variables are taken. False with an error text that names the
// line.
bool read_parameters(const std::string& text, std::vector<std::string>& words, std::string& error);

// The parameter names in the cards of a deck.
std::set<std::string> parameters_of(const std::string& deck);

// To be appended to the message that there is no parameter `name`: the name that is near, or all; empty if there are none.
std::string offer_parameters(const std::string& name, const std::set<std::string>& parameters);
// The values used: those given, and defaults of the deck.
std::vector<Setting> values_of_parameters(const std::string& deck, const std::vector<Setting>& settings);

struct DeckFault {
  int32_t line = 0, column = 0, column_end = 0; // 0: of none
  std::string text;
};

// Replaces parameters by values. In fixed columns (a deck that does not begin with *FREE) a value ends where the braces end,
// and a longer one uses the blanks before them, so that no other field moves. Comments are not changed. False with faults: a
// name without a value, an unused setting, a field that is too narrow.
bool put_parameters(std::string& deck, const std::vector<Setting>& settings, std::vector<DeckFault>& faults);

} // namespace app
