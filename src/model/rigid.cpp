// Rigid-body motions that the supports of a body leave free (METHOD 7.3).
//
// A plane rigid-body motion is a vector (u_x, u_y, omega L) about the centre of the body; L, the unit of length, makes its
// components comparable. Every prescribed displacement component is a row acting on it: at (x, y), u_x + omega (y_0 - y) = 0 or
// u_y + omega (x - x_0) = 0. The free motions are the null space of these rows. Phases:
//   1. Greedy Gram-Schmidt with pivoting: the row farthest from the span of those chosen is added until none is farther than
//      1e-8. Lines of symmetry contribute rows against the translation across them and the rotation.
//   2. Complete the basis by unit motions, also by largest distance: the free motions, orthonormal to the prevented ones.
// Pivoting makes the rank decision reliable for nearly dependent supports (Golub and Van Loan, Matrix Computations, on rank
// determination by QR with column pivoting).
#include "model/rigid.hpp"

#include "memory/math.hpp"
#include "model/geometry.hpp"
#include "model/symmetry.hpp"

namespace c2d {

namespace {

constexpr double kIndependent = 1e-8; // a smaller distance from the span counts as dependent: coordinates have round-off

double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Removes from v its components along `count` orthonormal vectors and returns the length of the rest. Done twice: a single pass
// of Gram-Schmidt loses orthogonality when most of v cancels.
double orthogonalise(const double basis[3][3], int count, double v[3]) {
  for (int turn = 0; turn < 2; ++turn) {
    for (int i = 0; i < count; ++i) {
      const double part = dot(basis[i], v);
      for (int k = 0; k < 3; ++k) v[k] -= part * basis[i][k];
    }
  }
  return sqrt(dot(v, v));
}

// Row of a displacement component at a node, as a linear form in the motion.
void node_row(const Model& m, int b, int32_t node, int component, double row[3]) {
  const Body& body = body_of(m, b);
  double x, y;
  node_position(m, b, node, &x, &y);
  row[0] = component == 0;
  row[1] = component == 1;
  row[2] = (component == 0 ? body.centre[1] - y : x - body.centre[0]) / m.head->length_unit;
}

// A symmetry line that the body meets prevents the translation across it, and the rotation.
double farthest_symmetry_row(int32_t lines, const double basis[3][3], int count, double best[3]) {
  double farthest = 0;
  for (int i = 0; i < 3 && lines != 0; ++i) {
    if (i < 2 && (lines >> i & 1) == 0) continue;
    double row[3] = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    const double left = orthogonalise(basis, count, row);
    if (left <= farthest) continue;
    farthest = left;
    for (int k = 0; k < 3; ++k) best[k] = row[k];
  }
  return farthest;
}

// The prescribed component that is farthest from the span of the ones found so far.
double farthest_row(const Model& m, int b, const double basis[3][3], int count, double best[3]) {
  double farthest = farthest_symmetry_row(body_of(m, b).lines, basis, count, best);
  if (farthest > 0.5) return farthest; // a symmetry row this independent needs no search over all nodes
  for (int32_t node = 0; node < body_of(m, b).nodes; ++node) {
    for (int component = 0; component < 2; ++component) {
      if (!displacement_known(m, b, node, component)) continue;
      double row[3];
      node_row(m, b, node, component, row);
      const double left = orthogonalise(basis, count, row);
      if (left <= farthest) continue;
      farthest = left;
      for (int k = 0; k < 3; ++k) best[k] = row[k];
    }
  }
  return farthest;
}

// The unit motion that is farthest from the span: completes the basis.
void farthest_unit(const double basis[3][3], int count, double best[3]) {
  double farthest = 0;
  for (int i = 0; i < 3; ++i) {
    double unit[3] = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    const double left = orthogonalise(basis, count, unit);
    if (left <= farthest + kIndependent) continue; // of equal distances the first: translations before the rotation
    farthest = left;
    for (int k = 0; k < 3; ++k) best[k] = unit[k] / left;
  }
}

} // namespace

void find_free_motions(const Model& m, int b) {
  Body& body = m.body[b];
  const Box box = box_of_body(m, b);
  body.centre[0] = box.x_min + 0.5 * (box.x_max - box.x_min);
  body.centre[1] = box.y_min + 0.5 * (box.y_max - box.y_min);
  double basis[3][3]; // first the prevented motions, then the free ones
  int prevented = 0;
  for (; prevented < 3; ++prevented) {
    double row[3] = {0, 0, 0};
    const double size = farthest_row(m, b, basis, prevented, row);
    if (size <= kIndependent) break;
    for (int k = 0; k < 3; ++k) basis[prevented][k] = row[k] / size;
  }
  body.free_motions = static_cast<int8_t>(3 - prevented);
  for (int i = prevented; i < 3; ++i) {
    farthest_unit(basis, i, basis[i]);
    for (int k = 0; k < 3; ++k) body.free_motion[i - prevented][k] = basis[i][k];
  }
  for (int i = body.free_motions; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) body.free_motion[i][k] = 0;
  }
}

void put_motion(Text& text, const Model& m, int b, const double motion[3]) {
  const Body& body = body_of(m, b);
  const double size = sqrt(motion[0] * motion[0] + motion[1] * motion[1]);
  if (fabs(motion[2]) <= kIndependent * size) {
    put(text, "along ");
    if (fabs(motion[1]) <= kIndependent * size) return void(put(text, "x"));
    if (fabs(motion[0]) <= kIndependent * size) return void(put(text, "y"));
    put_all(text, "(", motion[0] / size, ", ", motion[1] / size, ")");
    return;
  }
  // A motion with rotation is a rotation about its pole, where u vanishes.
  const double turn = motion[2] / m.head->length_unit;
  double centre[2] = {body.centre[0] - motion[1] / turn, body.centre[1] + motion[0] / turn};
  for (double& c : centre) c = fabs(c) <= 1e-12 * m.head->length_unit ? 0 : c; // print round-off as 0
  put_all(text, "rotation about (", centre[0], ", ", centre[1], ")");
}

} // namespace c2d
