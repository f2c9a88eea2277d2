// Colours of the page and of its pictures where the reader's screen is dark.
#pragma once

#include <string>

namespace app {

struct DarkColour {
  const char* light; // as presentation attributes of pictures have it
  const char* dark;  // what stands for it there
};

// Of the scale of contours alone there is none: it keeps its colours.
extern const DarkColour kDarkColours[];
extern const int kDarkColourCount;

// A style sheet's rules for screens that prefer dark; on paper pictures stay as they are.
void append_dark_style(std::string& out);

} // namespace app
