#pragma once
// Options of the program from the words of a command line.
#include "program/options.hpp"

#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace test {

inline app::Options options_of(const std::vector<std::string>& words) {
  std::vector<const char*> argv = {"contact2d"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  app::Options options;
  std::string error;
  REQUIRE_MESSAGE(app::read_options(static_cast<int>(argv.size()), argv.data(), options, error), error);
  return options;
}

} // namespace test
