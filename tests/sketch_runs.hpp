// Sketches of examples/ solved in this process, on meshes of any fineness, and what is read off their contacts.
#pragma once

#include "family_runs.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"
#include "shell.hpp"

namespace sketch_test {

using families_test::Row;
using families_test::Solution;

struct Setup {
  double fineness = 2;
  int order = 0; // of the functions; 0: the sketch's
  sketch::Parameters parameters = {};
};

inline sketch::Reading read_text(const std::string& text, const sketch::Parameters& parameters = {}) {
  const auto file = [](const std::string& name, std::string& content) {
    content = test::read_file(paths::root() + "/examples/" + name);
    return !content.empty();
  };
  sketch::Reading drawn = sketch::read_sketch(text, parameters, file);
  for (const auto& [name, value] : parameters) // as the program does
    if (drawn.parameters.count(name) == 0) drawn.faults.push_back({{}, "no parameter " + name});
  return drawn;
}
inline sketch::Reading read_example(const std::string& name, const sketch::Parameters& parameters = {}) {
  return read_text(test::read_file(paths::root() + "/examples/" + name + ".c2s"), parameters);
}

inline Solution solve(sketch::Reading drawn, const Setup& setup = Setup()) {
  Solution out;
  for (const sketch::Fault& fault : drawn.faults) out.error += fault.text + "\n";
  if (!out.error.empty()) return out;
  if (setup.order > 0) drawn.sketch.order = setup.order;
  return families_test::solve_deck(sketch::deck_of(drawn.sketch, sketch::first_mesh(drawn.sketch, setup.fineness)));
}
inline Solution solve(const std::string& name, const Setup& setup = Setup()) {
  return solve(read_example(name, setup.parameters), setup);
}

// Pairs of a zone at a step, by rising x.
inline std::vector<Row> zone_at(const Solution& s, size_t step, int zone = 1) {
  std::vector<Row> out;
  for (const Row& row : s.steps.at(step).rows)
    if (row.zone == zone) out.push_back(row);
  return out;
}

inline Row at_peak(const std::vector<Row>& rows) {
  return *std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.tn < b.tn; });
}

// A traction between the pairs beside x; NaN beside all of them, as where nothing begins below.
inline double between(const std::vector<Row>& rows, double x, double Row::*value) {
  for (size_t i = 1; i < rows.size(); ++i)
    if (rows[i - 1].x <= x && x <= rows[i].x) {
      const double f = (x - rows[i - 1].x) / (rows[i].x - rows[i - 1].x);
      return rows[i - 1].*value + f * (rows[i].*value - rows[i - 1].*value);
    }
  return NAN;
}

// Where a quantity that grows like the power 3/2 of the distance begins, towards larger x: from two pairs that have it, next to
// each other. A gap begins at the edge of contact, slip at the border of the pairs that stick.
inline double begin_of(const std::vector<Row>& rows, double Row::*value, int status, size_t skipped) {
  size_t first = rows.size();
  while (first > 0 && rows[first - 1].status != status && value == &Row::slip) --first; // open pairs beyond the slip
  while (first > 0 && rows[first - 1].status == status) --first;
  if (first + skipped + 1 >= rows.size()) return NAN;
  const Row &a = rows[first + skipped], &b = rows[first + skipped + 1];
  const double p = std::pow(std::fabs(a.*value), 2.0 / 3), q = std::pow(std::fabs(b.*value), 2.0 / 3);
  return a.x - p * (b.x - a.x) / (q - p);
}
inline double edge_of(const std::vector<Row>& rows) { return begin_of(rows, &Row::gap, C2D_OPEN, 1); }
inline double stick_border(const std::vector<Row>& rows) { return begin_of(rows, &Row::slip, C2D_SLIP, 0); }

} // namespace sketch_test
