// The table of results that a statement `want` may request: one row each.
#pragma once

#include "post/measure.hpp"

#include <string>
#include <vector>

namespace sketch {

// What follows the word: nothing, a body and points inside, curves, curves and points on them, two points inside, or a fatigue
// parameter with one of these.
// Of torsion: nothing, or curves.
enum class WantOf { kContact, kPoints, kCurves, kPlaces, kPair, kFatigue, kTorsion };

// Fatigue parameters over the last cycle, and the stress intensity of a crack.
enum class FatigueKind { kSwt, kFatemiSocie, kFindley, kCrossland, kDangVan, kRuiz1, kRuiz2, kCrack };
struct FatigueRow {
  const char* word;
  FatigueKind kind;
  app::Measure what;
};
const std::vector<FatigueRow>& fatigue_rows(); // in the order of FatigueKind

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
