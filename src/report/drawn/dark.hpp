// Colours of the page and its pictures in dark mode.
#pragma once

#include <string>

namespace app {

struct DarkColour {
  const char* light; // as in the presentation attributes of pictures
  const char* dark;  // its replacement
};

// Only the contour scale has no replacements: it keeps its colours.
extern const DarkColour kDarkColours[];
extern const int kDarkColourCount;

// A style sheet's rules for screens that prefer dark; on paper pictures stay as they are.
void append_dark_style(std::string& out);

} // namespace app
