// The table of results that a statement `want` may request: one row each.
#pragma once

#include "post/measure.hpp"

#include <string>
#include <vector>

namespace sketch {

// What follows the word: nothing, a body and points inside, curves, curves and points on them, or two points inside.
enum class WantOf { kContact, kPoints, kCurves, kPlaces, kPair };

struct WantRow {
  const char* word;
  WantOf of;
  bool by_default;      // in a sketch without a statement `want`
  bool needs_interface; // an error in a sketch without one
  // The quantities of the contact, or of the whole contact only, that it requests; those of points and curves:
  // estimate/wanted.cpp.
  std::vector<app::Measure> quantities;
  bool of_whole;
};

const std::vector<WantRow>& wants();
const WantRow& want_row(const std::string& word); // of a word of the table

} // namespace sketch
