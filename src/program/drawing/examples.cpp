#include "program/drawing/examples.hpp"

#include <algorithm>
#include <cmath>

namespace drawing {
namespace {

struct Sampled { // a curve by some of its points
  const Body* body;
  const Curve* curve;
  std::vector<Point> points;
  double height = 0; // of its middle
};

std::vector<Sampled> sampled(const std::vector<Body>& bodies) {
  std::vector<Sampled> out;
  for (const Body& body : bodies)
    for (const Loop& loop : body.loops)
      for (const Curve& curve : loop.curves) {
        const sketch::ShapePtr shape = shape_of(curve);
        Sampled s{&body, &curve, {}, 0};
        for (int i = 1; i < 16; ++i) s.points.push_back(shape->at(i / 16.0)); // ends belong to two curves
        for (const Point& p : s.points) s.height += p.y / static_cast<double>(s.points.size());
        out.push_back(std::move(s));
      }
  return out;
}

double distance(const Sampled& a, const Sampled& b) {
  double least = HUGE_VAL;
  for (const Point& p : a.points)
    for (const Point& q : b.points) least = std::min(least, sketch::length(p - q));
  return least;
}

std::string side(const Sampled& s) { return s.body->name + "." + s.curve->name; }

std::string contact_of(const Body& a, const Body& b, const std::vector<Sampled>& curves) {
  double least = HUGE_VAL;
  std::string text;
  for (const Sampled& p : curves)
    for (const Sampled& q : curves) {
      if (p.body != &a || q.body != &b) continue;
      const double apart = distance(p, q);
      if (apart < least) least = apart, text = "contact " + side(p) + " " + side(q) + "  mu 0.3";
    }
  return text;
}

} // namespace

std::vector<std::string> examples_for(const std::vector<Body>& bodies) {
  std::vector<std::string> out;
  const std::vector<Sampled> curves = sampled(bodies);
  constexpr size_t kMost = 8; // bodies: of more the pairs are too many to be an example
  for (size_t i = 0; i + 1 < bodies.size() && i + 1 < kMost; ++i) out.push_back(contact_of(bodies[i], bodies[i + 1], curves));
  const auto is_lower = [](const Sampled& a, const Sampled& b) { return a.height < b.height; };
  const Sampled& lowest = *std::min_element(curves.begin(), curves.end(), is_lower);
  const Sampled* highest = nullptr; // of another body, where there is one
  for (const Sampled& s : curves)
    if ((bodies.size() == 1 || s.body != lowest.body) && (highest == nullptr || is_lower(*highest, s))) highest = &s;
  out.push_back("case load");
  out.push_back("fix " + side(lowest));
  if (bodies.size() == 1) {
    out.push_back("traction " + side(*highest) + "  x 0 y -1");
  } else {
    const Point about = highest->points[7];
    out.push_back("platen " + side(*highest) + "  about " + told(about.x) + " " + told(about.y) + "  force 0 -1  turn 0");
  }
  out.push_back("history load 1");
  return out;
}

} // namespace drawing
