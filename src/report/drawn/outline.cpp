#include "report/drawn/outline.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// Lagrange polynomials over `count` equally spaced points of [-1, 1]; one point: constant.
double shape(int32_t count, int32_t k, double eta) {
  double product = 1.0;
  const double step = count > 1 ? 2.0 / (count - 1) : 0.0;
  for (int32_t j = 0; j < count; ++j)
    if (j != k) product *= (eta + 1.0 - j * step) / ((k - j) * step);
  return product;
}

using Curve = std::vector<OutlinePoint>;

// Follows the elements of a region. Elements on a line of symmetry carry no results and are no boundary of
// the whole body: the curve is broken there.
class Tracer {
public:
  Tracer(const Summary& s, int32_t body, const std::vector<Point>& nodes, BodyScene& out)
      : summary_(s), geometry_(s.body[body - 1].element_nodes), functions_(s.function_nodes),
        open_(s.body[body - 1].points - s.body[body - 1].elements * (geometry_ - 1)), nodes_(nodes), out_(out) {}

  // Elements first ... last are region r (from 0); the first open_ regions are open.
  void region(int32_t r, int32_t first, int32_t last) {
    first_ = first, last_ = last;
    shift_ = std::min(r, open_);
    is_open_ = r < open_;
    std::vector<bool> on_line;
    for (int32_t e = first; e <= last; ++e) {
      on_line.push_back(lies_on_line(e));
      out_.on_line.push_back(on_line.back());
      if (!on_line.back()) out_.corners.push_back(at(e, -1.0));
      add_normals(e);
    }
    if (is_open_) out_.corners.push_back(at(last, 1.0));
    // A closed curve with a break begins behind it.
    const int32_t count = last - first + 1;
    int32_t start = 0;
    for (int32_t i = 0; i < count && !is_open_; ++i)
      if (on_line[static_cast<size_t>(i)]) start = i + 1;
    const bool closed = !is_open_ && start == 0;
    Curve piece;
    for (int32_t i = 0; i < count; ++i) {
      const int32_t place = (start + i) % count;
      if (on_line[static_cast<size_t>(place)])
        finish(piece, false);
      else
        add_element(piece, first + place);
    }
    finish(piece, closed);
  }
  const std::vector<Curve>& closed() const { return closed_; }
  const std::vector<Curve>& open() const { return pieces_; }

private:
  bool lies_on_line(int32_t e) const {
    bool on_x = (summary_.symmetry & 1) != 0, on_y = (summary_.symmetry & 2) != 0;
    for (int32_t k = 0; k < geometry_; ++k) {
      const Point p = node(e, k);
      on_x = on_x && p.x == summary_.symmetry_at[0];
      on_y = on_y && p.y == summary_.symmetry_at[1];
    }
    return on_x || on_y;
  }
  Point node(int32_t e, int32_t k) const {
    const bool wraps = !is_open_ && e == last_ && k == geometry_ - 1;
    const int32_t number = wraps ? (first_ - 1) * (geometry_ - 1) + shift_ : (e - 1) * (geometry_ - 1) + k + shift_;
    return static_cast<size_t>(number) < nodes_.size() ? nodes_[static_cast<size_t>(number)] : Point{};
  }
  Point at(int32_t e, double eta) const {
    Point sum;
    for (int32_t k = 0; k < geometry_; ++k) {
      const double n = shape(geometry_, k, eta);
      const Point p = node(e, k);
      sum.x += n * p.x;
      sum.y += n * p.y;
    }
    return sum;
  }
  void add_normals(int32_t e) {
    for (int32_t l = 0; l < functions_; ++l) {
      const double eta = functions_ > 1 ? -1.0 + 2.0 * l / (functions_ - 1) : 0.0;
      const Point a = at(e, eta - 1e-3), b = at(e, eta + 1e-3);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      out_.normals.push_back(length > 0.0 ? Point{(b.y - a.y) / length, (a.x - b.x) / length} : Point{});
    }
  }
  OutlinePoint point(int32_t e, double eta) const {
    OutlinePoint p{e, eta, at(e, eta), {}};
    p.moved = p.at;
    for (int32_t l = 0; l < functions_ && !out_.displacement.empty(); ++l) {
      const Point u = out_.displacement[static_cast<size_t>((e - 1) * functions_ + l)];
      p.moved.x += shape(functions_, l, eta) * u.x;
      p.moved.y += shape(functions_, l, eta) * u.y;
    }
    return p;
  }
  void add_element(Curve& piece, int32_t e) const {
    const int32_t parts = geometry_ == 2 && functions_ <= 2 ? 1 : 8;
    for (int32_t i = 0; i < parts; ++i) piece.push_back(point(e, -1.0 + 2.0 * i / parts));
  }
  void finish(Curve& piece, bool closed) {
    if (piece.empty()) return;
    if (!closed) piece.push_back(point(piece.back().element, 1.0));
    (closed ? closed_ : pieces_).push_back(piece);
    piece.clear();
  }

  const Summary& summary_;
  int32_t geometry_, functions_, open_, first_ = 0, last_ = 0, shift_ = 0;
  bool is_open_ = false;
  const std::vector<Point>& nodes_;
  BodyScene& out_;
  std::vector<Curve> closed_, pieces_;
};

Curve image_of(const Curve& curve, int axis, double value) {
  Curve out(curve.rbegin(), curve.rend());
  for (OutlinePoint& p : out) {
    double* const numbers[2] = {axis == 0 ? &p.at.x : &p.at.y, axis == 0 ? &p.moved.x : &p.moved.y};
    for (double* number : numbers) *number = 2.0 * value - *number;
  }
  return out;
}

Curve joined(Curve a, const Curve& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Adds the images across one line; an open curve that ends on the line goes on in its image.
void mirror(std::vector<Curve>& closed, std::vector<Curve>& open, int axis, double value) {
  const size_t whole = closed.size();
  for (size_t i = 0; i < whole; ++i) closed.push_back(image_of(closed[i], axis, value));
  std::vector<Curve> still_open;
  for (const Curve& curve : open) {
    const Curve image = image_of(curve, axis, value);
    const auto on_line = [&](const OutlinePoint& p) { return (axis == 0 ? p.at.x : p.at.y) == value; };
    const bool begins = on_line(curve.front()), ends = on_line(curve.back());
    if (begins && ends) {
      closed.push_back(joined(curve, image));
    } else if (begins || ends) {
      still_open.push_back(ends ? joined(curve, image) : joined(image, curve));
    } else {
      still_open.push_back(curve);
      still_open.push_back(image);
    }
  }
  open = still_open;
}

} // namespace

c2d_status trace_outline(c2d_solver* solver, const Summary& s, int32_t body, const std::vector<Point>& nodes, BodyScene& out) {
  Tracer tracer(s, body, nodes, out);
  for (int32_t r = 1; r <= s.body[body - 1].regions; ++r) {
    int32_t first = 0, last = 0;
    if (const c2d_status status = c2d_get_region(solver, body, r, &first, &last); status != C2D_OK) return status;
    tracer.region(r - 1, first, last);
  }
  std::vector<Curve> closed = tracer.closed(), open = tracer.open();
  for (int axis = 0; axis < 2; ++axis)
    if ((s.symmetry >> axis & 1) != 0) mirror(closed, open, axis, s.symmetry_at[axis]);
  out.curves = closed;
  out.curves.insert(out.curves.end(), open.begin(), open.end());
  return C2D_OK;
}

} // namespace app
