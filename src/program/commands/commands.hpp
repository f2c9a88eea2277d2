// The commands other than run and sweep. Each returns the exit status of the program.
#pragma once

#include "program/options.hpp"

#include <string>

namespace app {

// check: reads and validates decks, one after another, and prints their sizes and the memory they need. The status is, of
// several decks, the first that is not 0.
int check_decks(const Options& options);
// convert: reads options.deck and writes it to options.output in the form asked for (options.convert_to; empty: the other one).
// Every number is read back as the same double, or nothing is written.
int convert_deck(const Options& options);
// make: writes the deck of a named problem.
int make_deck(const Options& options);
// mesh --halve: reads options.deck, a deck or a sketch, and writes its deck with every element halved to options.output.
int halve_deck(const Options& options);
// sketch: reads the drawing options.deck and writes its sketch to options.output, with the statements of options.conditions.
int sketch_drawing(const Options& options);

// completion: the script for bash, zsh or fish, from the table of options.
std::string completion_text(const std::string& shell);
// help --man: the page in the language of man(7), from the tables; make man keeps it as port/packaging/contact2d.1.in.
std::string man_page(const std::string& version);

} // namespace app
