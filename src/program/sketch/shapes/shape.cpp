#include "program/sketch/shapes/shape.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {

double angle_between(Point a, Point b) { return std::atan2(cross(a, b), dot(a, b)); }

Point Shape::tangent(double u) const {
  Point d = local(u).d;
  if (length(d) == 0)
    d = u < 0.5 ? at(u + 1e-6) - at(u) : at(u) - at(u - 1e-6); // the derivative of a formula may vanish at an end
  return (1 / length(d)) * d;
}

double Shape::curvature(double u) const {
  const Local l = local(u);
  const double speed = length(l.d);
  return speed > 0 ? cross(l.d, l.dd) / (speed * speed * speed) : 0;
}

namespace {

constexpr double kDegree = 0.017453292519943295;

class Line final : public Shape {
public:
  Line(Point from, Point to) : from_(from), to_(to) {}
  Local local(double u) const override { return {u == 1 ? to_ : from_ + u * (to_ - from_), to_ - from_, {}}; }
  Form form() const override { return Form::kLine; }

private:
  Point from_, to_;
};

class Ellipse final : public Shape {
public:
  Ellipse(Point centre, Point a, Point b, double from, double sweep)
      : centre_(centre), a_(a), b_(b), from_(from), sweep_(sweep), round_(std::fabs(length(a) - length(b)) == 0) {}
  Local local(double u) const override {
    const double w = sweep_ * kDegree, angle = (from_ + u * sweep_) * kDegree, c = std::cos(angle), s = std::sin(angle);
    const Point radius = c * a_ + s * b_;
    return {centre_ + radius, w * (c * b_ - s * a_), -w * w * radius};
  }
  Form form() const override { return round_ ? Form::kArc : Form::kSmooth; }

private:
  Point centre_, a_, b_;
  double from_, sweep_;
  bool round_;
};

class Formula final : public Shape {
public:
  Formula(Expression x, Expression y, double first, double last)
      : x_(std::move(x)), y_(std::move(y)), first_(first), last_(last) {}
  Local local(double u) const override {
    const double w = last_ - first_, t = u == 1 ? last_ : first_ + u * w;
    const Jet x = x_.at(t), y = y_.at(t);
    return {{x.v, y.v}, {w * x.d, w * y.d}, {w * w * x.dd, w * w * y.dd}};
  }

private:
  Expression x_, y_;
  double first_, last_;
};

class Moved final : public Shape {
public:
  Moved(ShapePtr shape, const Motion& motion) : shape_(std::move(shape)), motion_(motion) {}
  Local local(double u) const override {
    const Local l = shape_->local(u);
    Motion turn = motion_;
    turn.x0 = turn.y0 = 0;
    return {motion_(l.at), turn(l.d), turn(l.dd)};
  }
  Form form() const override { return shape_->form(); }
  int pieces() const override { return shape_->pieces(); }

private:
  ShapePtr shape_;
  Motion motion_;
};

class Part final : public Shape {
public:
  Part(ShapePtr shape, double first, double last) : shape_(std::move(shape)), first_(first), last_(last) {}
  Local local(double u) const override {
    const double w = last_ - first_;
    Local l = shape_->local(u == 1 ? last_ : first_ + u * w);
    l.d = w * l.d, l.dd = w * w * l.dd;
    return l;
  }
  Form form() const override { return shape_->form(); }
  int pieces() const override { return shape_->pieces(); }

private:
  ShapePtr shape_;
  double first_, last_;
};

} // namespace

ShapePtr line(Point from, Point to) { return std::make_shared<Line>(from, to); }

ShapePtr arc(Point centre, double radius, double from, double sweep) { return ellipse(centre, radius, radius, 0, from, sweep); }

ShapePtr ellipse(Point centre, double a, double b, double tilt, double from, double sweep) {
  const double c = std::cos(tilt * kDegree), s = std::sin(tilt * kDegree);
  return std::make_shared<Ellipse>(centre, Point{a * c, a * s}, Point{-b * s, b * c}, from, sweep);
}

ShapePtr formula(Expression x, Expression y, double first, double last) {
  return std::make_shared<Formula>(std::move(x), std::move(y), first, last);
}

ShapePtr moved(ShapePtr shape, const Motion& motion) { return std::make_shared<Moved>(std::move(shape), motion); }

ShapePtr part(ShapePtr shape, double first, double last) { return std::make_shared<Part>(std::move(shape), first, last); }

// ---- lengths ----

// Five-point Gauss quadrature of the speed.
double Measure::piece(double from, double to) const {
  static const double at[5] = {-0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
  static const double weight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                   0.2369268850561891};
  double sum = 0;
  for (int i = 0; i < 5; ++i) sum += weight[i] * sketch::length(shape_->local((from + to) / 2 + at[i] * (to - from) / 2).d);
  return sum * (to - from) / 2;
}

Measure::Measure(ShapePtr shape) : shape_(std::move(shape)), steps_(128 + 4 * shape_->pieces()), sums_(1, 0.0) {
  for (int i = 0; i < steps_; ++i)
    sums_.push_back(sums_.back() + piece(static_cast<double>(i) / steps_, static_cast<double>(i + 1) / steps_));
}

double Measure::length_to(double u) const {
  const int step = std::clamp(static_cast<int>(u * steps_), 0, steps_ - 1);
  return sums_[static_cast<size_t>(step)] + piece(static_cast<double>(step) / steps_, u);
}

double Measure::u_at(double length) const {
  if (length <= 0) return 0;
  if (length >= sums_.back()) return 1;
  const auto above = std::upper_bound(sums_.begin(), sums_.end(), length);
  double low = static_cast<double>(above - sums_.begin() - 1) / steps_, high = low + 1.0 / steps_;
  double u = low + (length - *(above - 1)) / (*above - *(above - 1)) / steps_;
  for (int i = 0; i < 60; ++i) { // Newton's method with bracketing bounds
    const double off = length_to(u) - length;
    (off > 0 ? high : low) = u;
    const double speed = sketch::length(shape_->local(u).d), next = speed > 0 ? u - off / speed : u;
    if (std::fabs(next - u) < 1e-15) break;
    u = next > low && next < high ? next : (low + high) / 2;
  }
  return u;
}

} // namespace sketch
