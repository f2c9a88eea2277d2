// Chains: consecutive curves of a side with the outward normals of the surface.
#pragma once

#include "program/sketch/sketch.hpp"

namespace sketch {

// A place on a chain: the index of a piece plus the relative position in it, 0 to 1.
using ChainPlace = double;

struct SurfacePoint {
  ChainPlace place = 0;
  Point at, normal; // outward
};

// Consecutive curves of one side. A concave corner ends a chain, because no contact extends across it. A convex corner adds a
// fan of normals between its two curves.
class Chain {
public:
  Chain(const Outline& outline, int body, size_t number, std::vector<size_t> curves, bool closed);

  SurfacePoint at(ChainPlace place) const;
  bool is_fan(ChainPlace place) const { return piece_at(place).fan; }
  // Length along the outline, from the start of its first curve; beyond its total length where the chain passes that start.
  double length_at(ChainPlace place) const;
  const std::vector<SurfacePoint>& samples() const { return samples_; }
  bool continues(size_t sample) const; // do a sample and the next one belong to the same piece?
  const std::vector<const Curve*>& curves() const { return curves_; }
  int body() const { return body_; }
  size_t outline() const { return outline_; }
  bool closed() const { return closed_; }
  double begin() const { return begin_; } // lengths along the outline
  double end() const { return end_; }
  double length() const { return end_ - begin_; }
  double way(double from, double to) const;                     // from one length to another; the shorter way on a closed chain
  const std::vector<double>& joints() const { return joints_; } // lengths where its curves begin, and the length of its end

private:
  struct Piece {
    size_t curve;
    double begin;      // length along the outline
    double from, turn; // of a fan: the angle of its first normal and the angle from there to its last
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
