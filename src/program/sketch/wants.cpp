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
      {"stick", WantOf::kContact, false, true, {M::kStuckWidth, M::kEccentricity, M::kStuckAll}, false},
      {"slip", WantOf::kContact, false, true, {M::kSlipRange}, false},
      {"walk", WantOf::kContact, false, true, {M::kWalk}, false},
      {"loss", WantOf::kContact, false, true, {M::kCycleDissipated}, true},
      {"stress", WantOf::kPoints, false, false, {}, false},
      {"hoop", WantOf::kCurves, false, false, {}, false},
      {"torque", WantOf::kTorsion, true, false, {M::kTorque, M::kTurnsThrough}, false},
      {"angle", WantOf::kTorsion, true, false, {M::kAngle}, false},
      {"shear", WantOf::kTorsion, false, false, {M::kShear}, false},
      {"fatigue", WantOf::kFatigue, false, false, {}, false},
  };
  return rows;
}

const std::vector<FatigueRow>& fatigue_rows() {
  using M = app::Measure;
  using K = FatigueKind;
  static const std::vector<FatigueRow> rows = {
      {"swt", K::kSwt, M::kSwt},
      {"fatemi-socie", K::kFatemiSocie, M::kFatemiSocie},
      {"findley", K::kFindley, M::kFindley},
      {"crossland", K::kCrossland, M::kCrossland},
      {"dang-van", K::kDangVan, M::kDangVan},
      {"ruiz1", K::kRuiz1, M::kRuiz1},
      {"ruiz2", K::kRuiz2, M::kRuiz2},
      {"crack", K::kCrack, M::kCrackRange},
  };
  return rows;
}

const WantRow& want_row(const std::string& word) {
  return *std::find_if(wants().begin(), wants().end(), [&](const WantRow& row) { return row.word == word; });
}

} // namespace sketch
