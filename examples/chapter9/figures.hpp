// The curves of the study as a sheet of charts.
#pragma once

#include "study.hpp"

#include <string>
#include <vector>

namespace chapter9 {

// How a curve is drawn; those of one chart differ in colour, line and marker.
enum class Look { kEvents, kFirst, kSecond, kThird };
struct Series {
  std::string name;
  const Run* run;
  Look look;
};
// The limit of small increments and elements: left out, a line behind the curves, or taken off them.
enum class Against { kNothing, kContinuum, kDifference };
struct Panel {
  std::string heading;
  std::vector<Series> series; // one without a name stands for the one before of the same look in the legend
  Against against;
};
struct Convergence { // difference from event following against the number of increments
  std::string name;
  std::vector<double> increments, difference;
  Look look;
};

// A sheet as SVG: the panels, two in a row, and below them the convergence.
std::string draw_sheet(const std::vector<Panel>& panels, const Adhesion& continuum,
                       const std::vector<Convergence>& convergence);

} // namespace chapter9
