#include "program/sketch/shapes/chain.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr double kRadian = 0.017453292519943295; // a degree
constexpr double kConcave = -20 * kRadian;       // a corner that turns more to the right ends a chain
constexpr double kFan = 1e-4;                    // a convex corner that turns less is smooth
constexpr int kLeastSamples = 64;                // of a curve
constexpr int kFanSamples = 8;
constexpr double kLast = 1 - 1e-13, kWhole = 1 - 1e-12; // of a piece: its last sample; a place beyond kWhole is its end

Point outward(const Shape& shape, double u) { return -1.0 * turned_left(shape.tangent(u)); }

double turn_at_joint(const Curve& before, const Curve& next) {
  return angle_between(before.shape->tangent(1), next.shape->tangent(0));
}

// About one sample per degree of turn.
int samples_of(const Shape& shape) {
  const int n = kLeastSamples + 8 * shape.pieces();
  double turn = 0;
  if (shape.form() != Form::kLine)
    for (int i = 0; i < n; ++i)
      turn +=
          std::fabs(angle_between(shape.tangent(static_cast<double>(i) / n), shape.tangent(static_cast<double>(i + 1) / n)));
  return std::max(kLeastSamples, static_cast<int>(turn / kRadian));
}

} // namespace

Chain::Chain(const Outline& outline, int body, size_t number, std::vector<size_t> curves, bool closed)
    : body_(body), outline_(number), closed_(closed) {
  measures_.reserve(curves.size());
  for (size_t i = 0; i < curves.front(); ++i) begin_ += Measure(outline.curves[i].shape).length();
  end_ = begin_;
  for (size_t k = 0; k < curves.size(); ++k) {
    const Curve& curve = outline.curves[curves[k]];
    measures_.emplace_back(curve.shape);
    curves_.push_back(&curve);
    joints_.push_back(end_);
    pieces_.push_back({k, end_, 0, 0, false});
    end_ += measures_.back().length();
    if (k + 1 == curves.size() && !closed) break;
    const Curve& next = outline.curves[curves[(k + 1) % curves.size()]];
    const Point normal = outward(*curve.shape, 1);
    if (const double turn = turn_at_joint(curve, next); turn > kFan)
      pieces_.push_back({k, end_, std::atan2(normal.y, normal.x), turn, true});
  }
  joints_.push_back(end_);
  for (size_t p = 0; p < pieces_.size(); ++p) {
    const int n = pieces_[p].fan ? kFanSamples : samples_of(*curves_[pieces_[p].curve]->shape);
    for (int i = 0; i <= n; ++i) samples_.push_back(at(static_cast<double>(p) + std::min(static_cast<double>(i) / n, kLast)));
  }
}

const Chain::Piece& Chain::piece_at(ChainPlace place) const {
  return pieces_[std::min(static_cast<size_t>(std::max(place, 0.0)), pieces_.size() - 1)];
}

SurfacePoint Chain::at(ChainPlace place) const {
  const Piece& piece = piece_at(place);
  const double part = place - static_cast<double>(&piece - pieces_.data());
  const Shape& shape = *curves_[piece.curve]->shape;
  if (piece.fan) {
    const double angle = piece.from + part * piece.turn;
    return {place, shape.at(1), {std::cos(angle), std::sin(angle)}};
  }
  const double u = part > kWhole ? 1 : part;
  return {place, shape.at(u), outward(shape, u)};
}

double Chain::length_at(ChainPlace place) const {
  const Piece& piece = piece_at(place);
  const double part = place - static_cast<double>(&piece - pieces_.data());
  return piece.fan ? piece.begin : piece.begin + measures_[piece.curve].length_to(part > kWhole ? 1 : part);
}

bool Chain::continues(size_t sample) const {
  return sample + 1 < samples_.size() &&
         static_cast<size_t>(samples_[sample].place) == static_cast<size_t>(samples_[sample + 1].place);
}

double Chain::way(double from, double to) const {
  const double d = to - from;
  return closed_ ? d - length() * std::round(d / length()) : d;
}

std::vector<Chain> chains_of(const Sketch& sketch, const Side& side) {
  std::vector<Chain> out;
  const std::vector<Outline>& outlines = sketch.bodies[static_cast<size_t>(side.body)].outlines;
  for (size_t o = 0; o < outlines.size(); ++o) {
    const Outline& outline = outlines[o];
    const size_t n = outline.curves.size();
    const auto ends_behind = [&](size_t i) {
      const size_t next = (i + 1) % n;
      return (outline.open && next == 0) || !side.has(outline.curves[next].name) ||
             turn_at_joint(outline.curves[i], outline.curves[next]) < kConcave;
    };
    const auto begins = [&](size_t i) {
      const size_t before = (i + n - 1) % n;
      return (outline.open && i == 0) || !side.has(outline.curves[before].name) || ends_behind(before);
    };
    bool any = false, whole = true;
    for (size_t i = 0; i < n; ++i) {
      if (!side.has(outline.curves[i].name)) continue;
      any = true;
      if (!begins(i)) continue;
      whole = false;
      std::vector<size_t> run(1, i);
      while (!ends_behind(run.back())) run.push_back((run.back() + 1) % n);
      out.emplace_back(outline, side.body, o, run, false);
    }
    if (!any || !whole) continue;
    std::vector<size_t> all;
    for (size_t i = 0; i < n; ++i) all.push_back(i);
    out.emplace_back(outline, side.body, o, all, true);
  }
  return out;
}

} // namespace sketch
