// The boundary equations of one body in torsion, at all nodes of its section: H phi = (1/G) G tau (METHOD 21.10).
#pragma once

#include "post/point.hpp"

#include <array>
#include <optional>
#include <vector>

namespace app {

// A curve of a section by its length, the radius as x. The material is on its left.
class TwistCurve {
public:
  struct Local {
    Point at, along; // a place, the unit tangent
    double bend = 0; // curvature, above 0 to the left
  };
  virtual ~TwistCurve() = default;
  virtual Local local(double length) const = 0;
  virtual bool is_straight() const = 0;
};

constexpr size_t kTwistNodes = 4; // of an element, at most

struct TwistElement {
  const TwistCurve* curve = nullptr;
  double from = 0, to = 0;                // lengths along the curve
  std::array<size_t, kTwistNodes> node{}; // of the body, equally spaced
  // The element opposite, in the other direction, whose ring areas carry the torque of the tractions; null: its own.
  const TwistElement* facing = nullptr;
  double half() const { return (to - from) / 2; }
  TwistCurve::Local at(double eta) const { return curve->local(from + (1 + eta) * half()); }
};

struct TwistBody {
  double modulus = 1; // shear modulus
  size_t order = 1;   // of the shape functions
  size_t nodes = 0;
  std::vector<TwistElement> elements;
  std::optional<double> mirror; // z of a plane of symmetry that the section meets
};

// Shape functions of equally spaced nodes at -1 ... 1.
void twist_shapes(size_t order, double eta, double out[kTwistNodes]);
void twist_slopes(size_t order, double eta, double out[kTwistNodes]);

// Rows of a dense matrix.
struct TwistMatrix {
  size_t rows = 0, columns = 0;
  std::vector<double> value;
  TwistMatrix(size_t r, size_t c) : rows(r), columns(c), value(r * c, 0.0) {}
  double* row(size_t i) { return value.data() + i * columns; }
  const double* row(size_t i) const { return value.data() + i * columns; }
};

struct TwistEquations {
  TwistMatrix phi, tau;       // a row per node; columns: nodes, element ends (element * (order + 1) + local)
  std::vector<double> torque; // of a unit traction at each element end, whole circle
  std::vector<Point> at;      // places of the nodes
};
// `integrals`: false for a rigid body, of which only places and torques are found.
TwistEquations twist_equations(const TwistBody& body, bool integrals = true);

} // namespace app
