// The statement `elements`: equal elements, or given sizes at both ends of a stretch that grow inwards by a factor per element.
// With sizes h(s) = h0 + g s along a stretch, g = ln(growth), the number of elements up to s is the integral of ds / h:
// ln(1 + g s / h0) / g. The sizes increase from the first end, stay at or below `most`, and decrease towards the last end.
#include "program/sketch/elements.hpp"

#include "program/sketch/read/reader.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>

namespace sketch {
namespace {

constexpr int kMostElements = 20000; // of a stretch

double count_rising(double h0, double g, double s) { return std::log1p(g * s / h0) / g; }
double place_rising(double h0, double g, double count) { return h0 * std::expm1(g * count) / g; }

// Adds the ends of a graded stretch. All sizes are scaled slightly so that a whole number of elements fits.
void add_graded(const Stretches& stretch, double from, double length, Place at, std::vector<double>& ends) {
  const double largest = std::min(stretch.most > 0 ? stretch.most : length, length), g = std::log(stretch.growth);
  const double h0 = stretch.first > 0 ? std::min(stretch.first, largest) : largest;
  const double h1 = stretch.last > 0 ? std::min(stretch.last, largest) : largest;
  double rise = (largest - h0) / g, fall = (largest - h1) / g;
  if (rise + fall > length) { // the sizes meet below the largest
    rise = std::clamp((h1 - h0 + g * length) / (2 * g), 0.0, length);
    fall = length - rise;
  }
  const double flat = length - rise - fall;
  const double n1 = count_rising(h0, g, rise), n2 = n1 + flat / largest, n3 = n2 + count_rising(h1, g, fall);
  if (!(n3 < kMostElements)) throw Fault{at, "the sizes give more than 20000 elements on one stretch, expected larger sizes"};
  const int n = std::max(1, static_cast<int>(std::ceil(n3 - 1e-9)));
  for (int i = 1; i < n; ++i) {
    const double count = n3 * i / n;
    ends.push_back(from + (count <= n1   ? place_rising(h0, g, count)
                           : count <= n2 ? rise + (count - n1) * largest
                                         : length - place_rising(h1, g, n3 - count)));
  }
  ends.push_back(from + length);
}

} // namespace

const Division* division_of(const Sketch& sketch, int body, const Curve& curve) {
  const Division* out = nullptr;
  for (const Division& division : sketch.divisions)
    if (division.side.body == body && division.side.has(curve.name)) out = &division;
  return out;
}

std::vector<double> divided_ends(const Division& division, double length) {
  std::vector<double> ends(1, 0.0);
  for (size_t i = 0; i < division.stretches.size(); ++i) {
    const Stretches& stretch = division.stretches[i];
    const bool last = i + 1 == division.stretches.size();
    const double from = ends.back(), to = last ? length : stretch.to, way = to - from;
    if (!(way > kJoint * length) || to > length * (1 + kJoint))
      throw Fault{division.side.at, "a stretch of elements ends at the length " + rounded(to) + ", expected a length above " +
                                        rounded(from) + " and at most " + rounded(length) + ", the length of the curve"};
    if (stretch.count == 0) {
      add_graded(stretch, from, way, division.side.at, ends);
      continue;
    }
    for (int k = 1; k <= stretch.count; ++k) ends.push_back(k == stretch.count ? to : from + way * k / stretch.count);
  }
  ends.back() = length;
  return ends;
}

// elements body.curve 20; elements body.curve from 0.1 to 0 growth 1.3 most 2; several stretches with `until` between them.
void Reader::elements(Statement& s) {
  end_body();
  Division out;
  out.side = side(s);
  do {
    Stretches stretch;
    if (s.accept("from")) {
      stretch.first = s.number("the size of the first element, 0 for any");
      if (!s.accept("to")) s.missing("to and the size of the last element");
      stretch.last = s.number("the size of the last element, 0 for any");
      if (s.accept("growth")) stretch.growth = s.number("the ratio of the size of an element to that of the one before");
      if (!(stretch.growth > 1)) s.fail(show(stretch.growth) + ": expected a growth above 1");
      if (s.accept("most")) stretch.most = s.positive("the size of the largest element");
    } else {
      stretch.count = s.whole("the number of elements", 1, kMostElements);
    }
    const bool more = s.accept("until");
    if (more) stretch.to = s.positive("the length from the start of the curve");
    out.stretches.push_back(stretch);
    if (!more) break;
  } while (true);
  s_.divisions.push_back(std::move(out));
}

} // namespace sketch
