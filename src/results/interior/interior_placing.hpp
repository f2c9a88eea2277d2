#pragma once
// Points of c2d_interior: location and intermediate sums, accumulated element by element. Coordinates, distances and sums are
// in the length unit of the equations.
#include "bie/columns.hpp"
#include "bie/far_field.hpp"
#include "bie/integrals/batch.hpp"
#include "bie/integrals/integrals.hpp"
#include "model/symmetry.hpp"
#include "solver/session.hpp"

#include <stddef.h>

namespace c2d {

// Intermediate data of a point, stored in its row of the caller's output until the results are complete. During the search, and
// finally for points on the boundary:
struct PointSearch {
  double x, y;
  double distance, element, eta; // of the nearest boundary point
  double windings;
  double unused[4];
  double place; // kUnplaced, kNowhere, or 4 * (body + 1) + flag
};
// Once it is known to be inside:
struct PointSums {
  double x, y;
  double u[2], stress[3]; // stress: trace, deviator
  double reference[2];    // displacement of the nearest boundary point, or reference_motion()
  double round;           // stress round the axis of bodies of revolution
  double place;
};
static_assert(sizeof(PointSearch) == C2D_POINT_FIELDS * sizeof(double) && sizeof(PointSums) == sizeof(PointSearch) &&
                  offsetof(PointSearch, place) == offsetof(PointSums, place),
              "both fill one output row and share its last member");
constexpr double kUnplaced = 0.0, kNowhere = 1.0;
constexpr double kBeyondAll = 1e60; // times the size of the bodies: squares of larger coordinates may overflow
constexpr double kRounding = 1e-14; // of the coordinates, in the length unit

struct Points {
  int32_t count;
  const double* xy;
  int64_t xy_stride;
  double* out;
  int64_t out_stride;
  double unit;

  const Model* model;
  const BatchKernel* kernel;        // null: one by one
  const uint16_t* chosen = nullptr; // [count] of the rows, null: these are the points

  int64_t row(int32_t i) const { return !kSmallCode && chosen ? chosen[i] : i; }
  PointSearch& search(int32_t i) const { return *reinterpret_cast<PointSearch*>(out + row(i) * out_stride); }
  PointSums& sums(int32_t i) const { return *reinterpret_cast<PointSums*>(out + row(i) * out_stride); }
  double& place(int32_t i) const { return search(i).place; }

  // Points of symmetric models are folded into the modelled part, and their results reflected back.
  double folded(int32_t i, int c) const {
    double p[2] = {xy[row(i) * xy_stride], xy[row(i) * xy_stride + 1]};
    fold(*model->head, p);
    return p[c];
  }
  double folding(int32_t i, int c) const { return folded(i, c) != xy[row(i) * xy_stride + c] ? -1.0 : 1.0; }
  double x(int32_t i) const { return folded(i, 0) / unit; }
  double y(int32_t i) const { return folded(i, 1) / unit; }
  int32_t lines(int b) const { return model->body[b].lines; }
  int32_t images(int b) const { return image_lines(*model, b); } // the lines with images of the elements
  // A coordinate in the length unit, reflected as for the elements of an image.
  double seen(int image, int c, double scaled) const {
    return (image >> c & 1) != 0 ? 2.0 * (model->head->line_at[c] / unit) - scaled : scaled;
  }
};

inline double place_of(int b, int32_t flag) { return 4 * (b + 1) + flag; }
inline bool is_near_node(double place, int b) { return place == place_of(b, C2D_POINT_NEAR_NODE); }
inline bool is_inside(double place, int b) { return place == place_of(b, C2D_POINT_INSIDE) || is_near_node(place, b); }

// Order of calls: begin_placing; look_from_afar for all elements, then leave_afar (optional, saves time; not in small code);
// look_at_element for all elements; end_placing. Afterwards every point inside body b or on its boundary is placed, with the
// displacement and position of the nearest boundary point.
void begin_placing(const Points& points);
void look_from_afar(const Element& e, const Points& points);
void leave_afar(const Points& points);
void look_at_element(const Integrator& in, int b, int32_t element, const Points& points);
void end_placing(const Session& session, int b, const Points& points);
// look_at_element for an element given by its number.
void place_by_element(const Session& session, int b, int32_t element, const Points& points);
// The motion that is subtracted: u, the displacement of a boundary point in the length unit, becomes that at the point (x, y).
// In the plane a translation; of bodies of revolution that of METHOD (21.5) with the radial strain of the boundary point.
void reference_motion(const Model& m, int b, int32_t element, double eta, double x, double y, double u[2]);
// Contribution of a chain of elements to the winding number of a point that is not between the chain and its chord: the angle
// of the chord, or its crossings (over a closed boundary both have the same sum).
double chord_winding(const Chain& chain, bool by_angle, Complex at);
// The points from `first` on, at most `most`.
inline Points some_points(const Points& points, int32_t first, int32_t most) {
  const int32_t rest = points.count - first;
  Points out = points;
  out.count = rest < most ? rest : most;
  out.xy += first * points.xy_stride;
  out.out += first * points.out_stride;
  return out;
}

} // namespace c2d
