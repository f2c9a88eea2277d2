// A file that a sketch names, read.
#pragma once

#include <string>

namespace app {

struct NamedText {
  std::string name, text;
};

} // namespace app
