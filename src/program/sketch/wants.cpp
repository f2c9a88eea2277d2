#include "program/sketch/wants.hpp"

#include <algorithm>

namespace sketch {

const std::vector<WantRow>& wants() {
  using M = app::Measure;
  static const std::vector<WantRow> rows = {
      {"pressure", WantOf::kContact, true, true, {M::kTractions, M::kPeakPressure}, false},
      {"edges", WantOf::kContact, true, true, {M::kContactEdge, M::kStickBorder}, false},
      {"forces", WantOf::kContact, true, false, {M::kForceX, M::kForceY}, false},
      {"approach", WantOf::kContact, true, false, {M::kApproach}, false},
      {"dissipation", WantOf::kContact, false, true, {M::kDissipated}, true},
      {"width", WantOf::kContact, false, true, {M::kContactWidth, M::kHalfWidth}, false},
      {"stick", WantOf::kContact, false, true, {M::kStuckWidth, M::kEccentricity}, false},
      {"stress", WantOf::kPoints, false, false, {}, false},
      {"hoop", WantOf::kCurves, false, false, {}, false},
  };
  return rows;
}

const WantRow& want_row(const std::string& word) {
  return *std::find_if(wants().begin(), wants().end(), [&](const WantRow& row) { return row.word == word; });
}

} // namespace sketch
