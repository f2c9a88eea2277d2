// What the program says on standard error, and its colours.
#pragma once

#include <string>

namespace app {

// As it stands, with its line ends; of control characters only those of the program itself. All that goes to standard error
// goes this way; what comes from an input has been through shown() (report/text.hpp), so that it has no colours either.
void say(const std::string& text);
constexpr const char* kClearLine = "\r\033[K";

// What the first error that this thread told says, without its place; empty: none was told since it was forgotten.
std::string reason_told();
void forget_reason();

// As long as it lives, what this thread says goes nowhere. Reasons are kept all the same.
class Muted {
public:
  Muted();
  ~Muted();
  Muted(const Muted&) = delete;
  Muted& operator=(const Muted&) = delete;
};

enum class Colour { kError, kWarning, kNote, kPlace };

// The text in a colour if standard error is a terminal that has some and NO_COLOR does not stand in the environment; else the
// text alone.
std::string coloured(Colour colour, const std::string& text);

} // namespace app
