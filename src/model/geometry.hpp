#pragma once
// Plane geometry of the model's elements: points, lengths, areas, winding, crossing.
#include "model/element.hpp"
#include "model/model.hpp"
#include "model/shape.hpp"

namespace c2d {

// Points closer than this fraction of the size of their body coincide.
constexpr double kCoincident = 1e-10;

// Position and derivative with respect to the local coordinate eta in [-1, 1].
struct CurvePoint {
  double x, y, dx, dy;
};
// Point of the curve through `nodes` (2 ... 4) points that are equally spaced in eta, thesis (4.7) to (4.10). At the nodes it
// is exactly theirs, which that of an Element (model/element.hpp: for many points of one element) is but for round-off.
CurvePoint curve_point(int nodes, const double* x, const double* y, double eta);
CurvePoint curve_point(const Model& m, int b, int32_t element, double eta);
Element element_of(const Model& m, int b, int32_t element);

// Unit outward normal, to the right of the direction of travel; (0, 0) where the tangent vanishes.
void outward_normal(const Model& m, int b, int32_t element, double eta, double n[2]);
double element_length(const Model& m, int b, int32_t element);
// An open region is closed along the symmetry lines: from its end to its start, by way of the lines' crossing if they
// lie on different lines. Fills the corners of that way and returns how many there are: 2 or 3; 0 for a closed region.
int closing_way(const Model& m, int b, int32_t region, double x[3], double y[3]);
// Enclosed area, positive if the region runs counter-clockwise; exact for polynomial elements.
double region_area(const Model& m, int b, int32_t region);

// An element as a polyline: one chord if it is linear, kChords of them if it is curved.
constexpr int kChords = 16;
struct Chords {
  int count;
  double x[kChords + 1], y[kChords + 1];
};
void chords_of(const Model& m, int b, int32_t element, Chords& out);

struct Box {
  double x_min, x_max, y_min, y_max;
};
Box box_around(const Model& m, int b,
               int32_t element);        // a box that contains the whole curve
Box box_of_body(const Model& m, int b); // of the boundary points
// Tolerance of coincidence of two points of a body, in either coordinate: from its size and the round-off of its coordinates.
// Reads all points.
double coincidence_of(const Model& m, int b);
bool boxes_meet(const Box& a, const Box& b);

// Do the chords (p0, p1) and (q0, q1) cross or touch?
bool chords_cross(const double p0[2], const double p1[2], const double q0[2], const double q1[2]);
double distance_to_element(const Model& m, int b, int32_t element, double x, double y);
// Winding number of a region about a point: 1 inside a counter-clockwise curve, -1 inside a clockwise one, else 0.
int winding_number(const Model& m, int b, int32_t region, double x, double y);

// Is the joint at which `after` begins one of the chords of an arc? Neither element has zero length. Then the turn per length
// at the previous or next joint is similar, and below that of a corner (METHOD 8.1).
bool is_joint_of_arc(const Model& m, int b, int32_t before, int32_t after);

// Angle in radians between two directions, 0 ... pi; neither may vanish.
double angle_between(const double a[2], const double b[2]);

} // namespace c2d
