// SHA-256 (FIPS 180-4), for the names of inputs in outputs.
#pragma once

#include "report/inputs.hpp"

#include <string>

namespace app {

// In 64 hexadecimal digits.
std::string sha256_of(const std::string& text);

// A file as outputs name it: without its folder.
InputFile input_file(const std::string& name, const std::string& text);

} // namespace app
