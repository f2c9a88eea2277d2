// Messages on standard error, and their colours.
#pragma once

#include <string>

namespace app {

// As it stands, with its line ends; of control characters only those of the program itself. All that goes to standard error
// goes this way; what comes from an input has been through shown() (report/text.hpp), so that it has no colours either.
void say(const std::string& text);
// Says `contact2d: error: TEXT`; returns `exit`.
int fail(const std::string& text, int exit);
constexpr const char* kClearLine = "\r\033[K";

// Text of the first error of this thread since forget_reason(), without its place; empty: none.
std::string reason_told();
void forget_reason();

// During its lifetime the messages of this thread are not printed. Reasons are still stored.
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
