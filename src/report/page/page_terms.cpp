#include "report/page/page_terms.hpp"

#include <algorithm>

namespace app {

std::string unit_of(Measure what, const Scene& scene) {
  if (what == Measure::kRotation) return "rad";
  if (what == Measure::kEdgePressure)
    return scene.stress_unit.empty() ? "" : scene.stress_unit + "/&#8730;" + scene.length_unit;
  if (what == Measure::kEdgeFriction || what == Measure::kCrackRange)
    return scene.stress_unit.empty() ? "" : scene.stress_unit + " &#8730;" + scene.length_unit;
  if (what == Measure::kRuiz2) return scene.stress_unit.empty() ? "" : scene.stress_unit + "&#183;" + scene.force_unit;
  switch (row_of(what).unit) {
  case Unit::kStress: return scene.stress_unit;
  case Unit::kLength: return scene.length_unit;
  case Unit::kForce: return scene.force_unit;
  case Unit::kWork: return scene.work_unit;
  case Unit::kNone: break;
  }
  return "";
}

// Words that name a quantity, as they end a link.
std::string term_of(Measure what) {
  std::string out = name_of(what);
  std::replace(out.begin(), out.end(), ' ', '-');
  return out;
}

// What the numbers of the page mean.
const char* meaning_of(Measure what) {
  switch (what) {
  case Measure::kPeakPressure:
    return "The largest pressure and its place. It is found between nodes where the pressure has a smooth top, and so may "
           "exceed "
           "the largest pressure of a pair that pictures show; at a sharp corner it is the value of the last pair, which grows "
           "with every refinement.";
  case Measure::kMeanPressure: return "The resultant of the pressure over the length in contact.";
  case Measure::kContactEdge: return "Where contact ends: the distance along the second side, and the place.";
  case Measure::kStickBorder: return "The border between stick and slip: the distance along the second side, and the place.";
  case Measure::kContactWidth: return "The length in contact; where a line of symmetry cuts it, with its image.";
  case Measure::kHalfWidth: return "Half the contact width.";
  case Measure::kStuckWidth: return "The length that sticks; where a line of symmetry cuts it, with its image.";
  case Measure::kEccentricity: return "The middle of the stick zone less that of the contact, along the second side.";
  case Measure::kForceX:
  case Measure::kForceY: return "A component of the force of the contact on side 2.";
  case Measure::kMoment: return "The moment of the contact on side 2, about the origin.";
  case Measure::kApproach: return "How far the bodies have approached each other, along the mean normal of the contact.";
  case Measure::kShift: return "How far the bodies have moved against each other, along the mean tangent of the contact.";
  case Measure::kDissipated: return "Energy that friction has dissipated since zero load.";
  case Measure::kEdgePressure: return "L of the pressure L &#8730;d at an edge of contact, d the distance inside it.";
  case Measure::kEdgeFriction:
    return "K of the friction K/&#8730;d where a contact that sticks ends, d the distance inside it.";
  case Measure::kSlipRange: return "The largest slip of what touches since the load last turned, and its place.";
  case Measure::kFrictionForce: return "The resultant of the friction along the surface, on side 2.";
  case Measure::kMotionX:
  case Measure::kMotionY: return "Displacement of the point of a rigid body or platen.";
  case Measure::kRotation: return "Rotation of a rigid body or platen, counter-clockwise.";
  case Measure::kSwt:
    return "Smith-Watson-Topper: the largest normal stress on a plane times half the range of its normal strain; of the worst "
           "plane.";
  case Measure::kFatemiSocie:
    return "Half the range of shear strain on a plane times 1 + k times its largest normal stress over the yield stress; of "
           "the "
           "worst plane.";
  case Measure::kFindley:
    return "Half the range of shear stress on a plane and k times its largest normal stress; of the worst plane.";
  case Measure::kCrossland:
    return "The radius of the smallest ball round the path of the stress deviator and a times the largest hydrostatic stress.";
  case Measure::kDangVan:
    return "The largest shear stress about the mean of the cycle and a times the hydrostatic stress of the same state.";
  case Measure::kRuiz1: return "Friction times the range of slip, where it is largest.";
  case Measure::kRuiz2: return "Friction times the range of slip times the tensile stress along the surface.";
  case Measure::kCrackRange:
    return "The range of the stress intensity of a short crack normal to the surface, from the stress without the crack.";
  default: break; // a number that is wanted alone has its place in its name
  }
  return "";
}

std::string term_link(Measure what) { return "<a href=\"#term-" + term_of(what) + "\">" + name_of(what) + "</a>"; }

} // namespace app
