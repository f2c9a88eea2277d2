// Curves of a side one behind the other, with the directions that its surface faces.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// A place on a chain: the number of its piece, and of that a part, 0 to 1.
using ChainPlace = double;

struct SurfacePoint {
  ChainPlace place = 0;
  Point at, normal; // outward
};

// Consecutive curves of one side, ended by concave corners: nothing touches across those. At a convex corner there is a fan of
// normals between the two curves.
class Chain {
public:
  Chain(const Outline& outline, int body, size_t number, std::vector<size_t> curves, bool closed);

  SurfacePoint at(ChainPlace place) const;
  bool is_fan(ChainPlace place) const { return piece_at(place).fan; }
  // Along the outline from where its first curve begins, beyond its whole length where the chain goes round that.
  double length_at(ChainPlace place) const;
  const std::vector<SurfacePoint>& samples() const { return samples_; }
  bool continues(size_t sample) const; // does the piece of a sample go on to the next?
  const std::vector<const Curve*>& curves() const { return curves_; }
  int body() const { return body_; }
  size_t outline() const { return outline_; }
  bool closed() const { return closed_; }
  double begin() const { return begin_; } // lengths along the outline
  double end() const { return end_; }
  double length() const { return end_ - begin_; }
  double way(double from, double to) const; // from one length to another, the shorter way round a closed chain
  const std::vector<double>& joints() const { return joints_; } // lengths at which its curves begin, and its end

private:
  struct Piece {
    size_t curve;
    double begin;      // length along the outline
    double from, turn; // of a fan: the angle of its first normal, and to its last
    bool fan;
  };
  const Piece& piece_at(ChainPlace place) const;
  std::vector<Piece> pieces_;
  std::vector<Measure> measures_;
  std::vector<const Curve*> curves_;
  std::vector<SurfacePoint> samples_;
  std::vector<double> joints_;
  int body_;
  size_t outline_;
  bool closed_;
  double begin_ = 0, end_ = 0;
};

// The chains of a side.
std::vector<Chain> chains_of(const Sketch& sketch, const Side& side);

} // namespace sketch
