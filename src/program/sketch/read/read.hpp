// From the text of a sketch to its shapes and conditions.
#pragma once

#include "program/sketch/sketch.hpp"

#include <functional>
#include <set>
#include <string>

namespace sketch {

// Is a file a sketch, and not a deck? Its name ends in .c2s, or its text begins as a sketch does.
bool is_sketch(const std::string& text, const std::string& name = std::string());

struct Reading {
  Sketch sketch;
  std::vector<Fault> faults;        // in the order of the lines; none: the sketch is sound
  std::set<std::string> parameters; // that it has
};
// `given`: parameters that replace those of the text. `file`: the text of a file that a spline names; false if there is none.
Reading read_sketch(const std::string& text, const Parameters& given,
                    const std::function<bool(const std::string& name, std::string& text)>& file);

} // namespace sketch
