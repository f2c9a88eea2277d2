// `contact2d completion SHELL`: what a shell completes the command line by, made from the table of options.
#pragma once

#include <string>

namespace app {

// For bash, zsh or fish.
std::string completion_text(const std::string& shell);

} // namespace app
