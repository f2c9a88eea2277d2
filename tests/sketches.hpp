// Sketches in tests: read, with a file of points beside them, and what they tell.
#pragma once

#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <doctest/doctest.h>
#include <string>

namespace sketches {

inline sketch::Reading read(const std::string& text, const sketch::Parameters& given = {}) {
  return sketch::read_sketch(text, given, [](const std::string& name, std::string& content) {
    if (name != "points.csv") return false;
    content = "x,y\n0,0\n1,0\n2,0.5\n3,0\n";
    return true;
  });
}

// A sketch that has to be sound.
inline sketch::Sketch sound(const std::string& text, const sketch::Parameters& given = {}) {
  sketch::Reading r = read(text, given);
  for (const sketch::Fault& f : r.faults) MESSAGE(f.at.line << ": " << f.text);
  REQUIRE(r.faults.empty());
  return std::move(r.sketch);
}
inline std::string deck(const std::string& text, double fineness = 1) {
  const sketch::Sketch s = sound(text);
  return sketch::deck_of(s, sketch::first_mesh(s, fineness));
}

// The only fault of a sketch, with its line and column.
inline std::string fault(const std::string& text) {
  const sketch::Reading r = read(text);
  if (r.faults.size() != 1) return std::to_string(r.faults.size()) + " faults";
  return std::to_string(r.faults[0].at.line) + ":" + std::to_string(r.faults[0].at.column) + " " + r.faults[0].text;
}
inline void tells(const std::string& text, const std::string& part) {
  const std::string said = fault(text);
  CHECK_MESSAGE(said.find(part) != std::string::npos, "told: " << said << "\nexpected: " << part);
}

const char kSquare[] = "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\n"; // 6 lines

} // namespace sketches
