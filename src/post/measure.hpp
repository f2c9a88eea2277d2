// The table of quantities: one row each, with everything that listing, JSON, CSV, page, responses, requests and stated errors
// need of it. Rows are in the order of the outputs.
#pragma once

#include <cstddef>
#include <cstdint>

namespace app {

enum class Measure {
  // Of a contact, from a solved step: quantities_of().
  kPeakPressure,  // and its place
  kMeanPressure,  // over the touching length
  kFrictionForce, // of tt along the surface, on side 2
  kContactEdge,   // place where contact ends; value: length along side 2 from its first pair
  kStickBorder,   // place where stick meets slip, likewise
  kContactWidth,  // length that touches, of the whole contact: a stretch that a line of symmetry cuts with its images
  kHalfWidth,     // half of it, if it is one stretch
  kStuckWidth,    // length that sticks, likewise
  kEccentricity,  // of one stick zone in one stretch: the middle of stick less that of contact, along the second side
  kEdgePressure,  // L of p = L sqrt(d) at a contact edge, d the distance inside; its item is that of the edge
  kEdgeFriction,  // K of tt = K / sqrt(d) where a stuck contact ends; its item is that of the edge
  kSlipRange,     // the largest magnitude of slip of touching pairs since the loads last turned, and its place
  kForceX,
  kForceY,
  kMoment,     // on side 2, about the origin
  kDissipated, // since zero load; zone 0: by the whole contact
  kApproach, // c2d_zone_state; in a model without a contact, zone 0: of the rigid body or platen `item` along its driving force
  kShift,    // c2d_zone_state
  kWalk,     // of a cycle that is repeated until steady: (u2 - u1).t over the last one, mean of the pairs that touch
  kStuckAll, // length that sticks all through that cycle
  kMotionX,  // zone 0: of the rigid body or platen with the number `item`: its point and rotation
  kMotionY,
  kRotation,
  // Requested by a sketch, from all states of the history: estimate/wanted.cpp.
  kTractions, // relative L1 distance of the tractions of two meshes; it has an error but no value
  kDisplacementX,
  kDisplacementY,
  kStressXX,
  kStressYY,
  kStressXY,
  kRangeXX,
  kRangeYY,
  kRangeXY,
  kCycleXX,
  kCycleYY,
  kCycleXY,
  kLargestAlong, // stress along the surface of curves
  kSmallestAlong,
  kRangeAlong,
  kCycleAlong,
  kPressureOn, // at a place of curves
  kApproachOf, // of two points inside: along the line from the first to the second
  kShiftOf,    // and across it
  kCycleDissipated,
  kSwt, // fatigue parameters over the last cycle
  kFatemiSocie,
  kFindley,
  kCrossland,
  kDangVan,
  kRuiz1,
  kRuiz2,
  kCrackRange, // of the stress intensity of an edge crack
  // Round the axis of bodies of revolution: estimate/torsion.cpp.
  kTorque,       // on curves or a rigid body that are turned
  kAngle,        // of curves with a traction
  kSlipStart,    // torque on a contact as its first pair slips
  kTurnsThrough, // the largest torque that a contact carries
  kShear,        // largest shear stress on curves
  // The stress out of the plane, of bodies of revolution round the axis.
  kStressZZ,
  kRangeZZ,
  kCycleZZ,
  kLargestZZ, // on curves
  kSmallestZZ,
  kRangeZZOn,
  kCycleZZOn,
};
constexpr size_t kMeasures = static_cast<size_t>(Measure::kCycleZZOn) + 1;

enum class Unit { kNone, kLength, kStress, kForce, kWork };

// What a stated error is compared with, S of METHOD-MESHES, "Scales".
enum class Scale { kOwn, kForce, kMoment, kPlace, kContact, kApproach, kMotion, kRotation, kWork, kSlip, kWalk, kGiven };

// A stated error is the largest of these multiples, METHOD (16.7): of the difference on two meshes, of that of the round
// before, of the distance of the tractions times the scale, of the spacing of pairs, and of the difference from another method.
struct ErrorRule {
  double apart, before, hidden, spacing, doubt;
};

// And at least these multiples of the sums of the errors of the edges and of the borders of its zone.
struct ByPlaces {
  double edges, borders;
};

// Has a number a place, and are elements there bisected if it is inaccurate?
enum class PlaceKind { kNone, kGiven, kRefined };

struct ZoneStep;  // a zone in a solved step
struct BodyStep;  // a rigid body or platen in a solved step
class Quantities; // the list that quantities are added to

struct MeasureRow {
  Measure what;
  const char* name; // in all outputs
  Unit unit;
  Scale scale;
  // The second rule applies to a stick border if the force on the contact changed in the last piece of the history, and to a
  // stress along a surface that is extrapolated to a contact edge.
  ErrorRule rule[2];
  ByPlaces by_places;
  // What refinement does for an inaccurate number: contact tractions are made more accurate, else the solution outside
  // contacts.
  bool by_tractions;
  PlaceKind place;
  // How it is taken from a solved step; null: it is not.
  void (*of_zone)(const ZoneStep&, Quantities&);
  void (*of_body)(const BodyStep&, Quantities&);
};

const MeasureRow& row_of(Measure what);

// "peak pressure", "contact edge": the name in listing, JSON and CSV; empty for a number that is no Measure.
const char* name_of(Measure what);

// What a reader is shown: of an edge or border, where it has one, its distance along the second side, the same on every mesh.
double shown_value(Measure what, double value, double along);

// The quantity of a contact or body with this name; null: none.
const MeasureRow* find_measure(const char* name);

} // namespace app
