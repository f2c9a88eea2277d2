// Sketches whose answers are known, solved by the loop over meshes: true errors beside stated ones.
#pragma once

#include "callable.hpp"
#include "program/estimate/loop.hpp"

#include <array>
#include <string>
#include <vector>

namespace truth {

// A number of the last state in closed form; of a place the points where it may be.
struct Known {
  std::string name;
  double value = 0;
  std::vector<std::array<double, 2>> places = {};
};

struct Problem {
  std::string name;
  std::string text;                                               // the sketch; its parameter `tolerance` is what is asked
  std::vector<Known> known;                                       // of zone 1
  test::Callable<std::array<double, 2>(double x)> tractions = {}; // tx and ty along the top of body 1, y = 0
  double half_width = 0;                                          // of the contact, where they are not smooth
};

// A number of the loop, with its true error.
struct Row {
  std::string name;
  int item = 0;
  bool wanted = false;
  double value = 0, asked = 0, error = 0, stated = 0; // the last three over the scale of the tolerance
  double ratio() const { return stated / error; }
};
struct Judged {
  std::vector<Row> rows;
  int pairs = 0, elements = 0;
  size_t meshes = 0;
  double seconds = 0, last = 0; // of all meshes, of the final one
  std::string stopped, fault;   // why it ended above a tolerance; why there is no result
};

// By closed forms; `by_mesh`: by a mesh with elements half as long, of all numbers but the tractions, and less than the true
// error.
Judged judge(const Problem& problem, double tolerance, bool by_mesh);

// `shift` moves edges within their elements: loads grow by that share.
Problem hertz(double shift);
Problem cattaneo(double share, bool back, double shift); // pushed by share * mu * P; `back`: and back again
Problem rounded_punch(double b, double share);           // b: half the flat over half the contact
Problem receding_layer(double stiffness);                // of the layer over that of the foundation: 1 or 3
Problem disc_in_hole(bool pulled);                       // or pressed across
std::vector<Problem> problems();

} // namespace truth
