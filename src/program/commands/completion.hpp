// `contact2d completion SHELL`: completion script of the command line, made from the table of options.
#pragma once

#include <string>

namespace app {

// The script for bash, zsh or fish.
std::string completion_text(const std::string& shell);

} // namespace app
