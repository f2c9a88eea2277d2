// Numbers for narrow fields.
#pragma once

#include <cstddef>
#include <string>

namespace app {

// The number in at most `width` characters that a deck's reader turns into the same double: as few digits as
// that needs, written plainly if they fit so, else with an exponent (`12345-9` is 12345 times 10^-9 in an F
// field). Empty if there is no such text. `value` is finite.
std::string real_in_columns(double value, size_t width);

} // namespace app
