// Reads the text of a sketch.
#pragma once

#include "program/sketch/sketch.hpp"

#include <functional>
#include <set>
#include <string>

namespace sketch {

// Is a file a sketch rather than a deck? Its name ends in .c2s, or its first word begins a statement.
bool is_sketch(const std::string& text, const std::string& name = std::string());

struct Reading {
  Sketch sketch;
  std::vector<Fault> faults;        // in the order of the lines; none: the sketch is valid
  std::set<std::string> parameters; // defined by the sketch
};
// `given`: parameters that replace those of the text; `tolerances` likewise. `file` reads a file of a spline; false if it
// cannot be read.
Reading read_sketch(const std::string& text, const Parameters& given,
                    const std::function<bool(const std::string& name, std::string& text)>& file,
                    const Parameters& tolerances = {});

} // namespace sketch
