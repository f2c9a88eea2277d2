// Bounds for the search for facing points (model/facing.hpp).
//
// A search examines all elements of a side. Building the smooth surface over an element is expensive (model/surface.cpp), a
// distance between two points is not. These functions exclude an element by its middle point and an upper bound of its length,
// with a strict inequality, so that the result of the search does not change.
#include "memory/math.hpp"
#include "model/facing.hpp"

#include "model/geometry.hpp"

namespace c2d::facing {

namespace {

// Middle point of an element: curve_point() at eta = 0, with the shape functions tabulated.
void middle_of(int nodes, const double* x, const double* y, double out[2]) {
  static constexpr double kPart[3][kElementNodes] = {{0.5, 0.5}, {0, 1, 0}, {-1.0 / 16, 9.0 / 16, 9.0 / 16, -1.0 / 16}};
  out[0] = out[1] = 0;
  for (int i = 0; i < nodes; ++i) out[0] += kPart[nodes - 2][i] * x[i], out[1] += kPart[nodes - 2][i] * y[i];
}

} // namespace

// Upper bound of the length of an element. dx/deta is a linear combination of the chords between successive nodes; the integral
// of the magnitude of each coefficient is 1.25 with three nodes and at most 2.01 with four.
double length_at_most(int nodes, const double* x, const double* y) {
  double sum = 0;
  for (int i = 1; i < nodes; ++i) {
    const double dx = x[i] - x[i - 1], dy = y[i] - y[i - 1];
    sum += sqrt(dx * dx + dy * dy);
  }
  return (nodes == 3 ? 1.26 : nodes == 4 ? 2.02 : 1) * sum;
}

bool is_beyond(const Model& m, int b, int32_t element, const SurfacePoint& from, double square) {
  const int nodes = body_of(m, b).element_nodes;
  double px[kElementNodes], py[kElementNodes], middle[2];
  element_coordinates(m, b, element, px, py);
  middle_of(nodes, px, py, middle);
  const double x = middle[0] - from.x, y = middle[1] - from.y, off = sqrt(x * x + y * y);
  double far = off - 1.5 * length_at_most(nodes, px, py);
  if (far > 0 && far * far > square) return true;
  far = off - 1.5 * element_length(m, b, element);
  return far > 0 && far * far > square;
}

Closeness closeness(const Model& m, int b, int32_t element, double start, double end) {
  const int nodes = body_of(m, b).element_nodes;
  double x[kElementNodes], y[kElementNodes];
  element_coordinates(m, b, element, x, y);
  // The bound of the length is cheap and excludes most elements; only near a zero the exact length is computed.
  const double most = kSnap * length_at_most(nodes, x, y);
  if (fabs(start) > most && fabs(end) > most) return Closeness{false, false};
  const double tolerance = kSnap * element_length(m, b, element);
  return Closeness{fabs(start) <= tolerance, fabs(end) <= tolerance};
}

int32_t nearest_place(const Model& m, const Zone& z, int side, const SurfacePoint& from) {
  int32_t best = 0;
  double least = -1;
  for (int32_t place = 0; place < zone_elements(z, side); ++place) {
    double px[kElementNodes], py[kElementNodes], p[2];
    element_coordinates(m, z.body[side], zone_element(m, z, side, place), px, py);
    middle_of(body_of(m, z.body[side]).element_nodes, px, py, p);
    const double x = p[0] - from.x, y = p[1] - from.y, square = x * x + y * y;
    if (least < 0 || square < least) least = square, best = place;
  }
  return best;
}

} // namespace c2d::facing
