#include "report/drawn/dark.hpp"

#include "report/drawn/svg.hpp"

namespace app {

// Each colour keeps its hue, and its contrast to the background; fills of bodies stay distinct in lightness.
const DarkColour kDarkColours[] = {
    {"white", "#15181c"},       {colour::kInk, "#e6e6e6"},    {colour::kGrid, "#343a42"},  {colour::kFaint, "#9a9a9a"},
    {colour::kBlue, "#5ab0f0"}, {colour::kOrange, "#ff8f3a"}, {colour::kGreen, "#3fc79a"}, {colour::kPurple, "#dd8ccc"},
    {colour::kTie, "#ff6fae"},  {"#eeeeee", "#262b31"},       {"#fbe3d0", "#4a2a12"}, // within the Coulomb limits, slip
    {"#dce9f5", "#1f3a52"},     {"#b9cbdc", "#34546f"},       {"#e6c88c", "#5a4516"},      {"#c2a263", "#7d6329"},
    {"#8a5a00", "#e0ae4e"},     {"#f6f3ea", "#2e2b22"},       {"#d6d0bc", "#4b4636"},      {"#444444", "#c4c4c4"},
    {"#a4b494", "#3c4a30"},     {"#85966f", "#576a45"},       {"#33521f", "#9ac47e"},      {"#e8d0dc", "#4a2d3b"},
    {"#c8a9b9", "#6b4758"},     {"#7a2a5a", "#e08fc0"},       {"#b4b8cc", "#383c52"},      {"#9297b0", "#555a78"},
    {"#35357a", "#a6a6ee"}};
const int kDarkColourCount = static_cast<int>(sizeof kDarkColours / sizeof kDarkColours[0]);

void append_dark_style(std::string& out) {
  out += "@media screen and (prefers-color-scheme:dark){:root{color-scheme:dark;--paper:#15181c;--shadow:#fff6}"
         "body{background:#15181c;color:#e3e3e3}\n"
         "h2,th,td{border-color:#444b54}th{border-color:#888}figcaption{color:#c4c4c4}a{color:#5ab0f0}\n"
         ".outcome{background:#14261f}.stopped{background:#33200f}\n";
  for (const DarkColour& c : kDarkColours)
    for (const char* what : {"fill", "stroke"})
      out += std::string("svg [") + what + "=\"" + c.light + "\"]{" + what + ":" + c.dark + "}\n";
  out += "}\n";
}

} // namespace app
