// Results of loads round the axis of bodies of revolution. Torques are those of the whole circle, of the part that is drawn.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

// Curves or a rigid body whose angle or traction is given.
struct TorsionPart {
  std::string name;
  int32_t body = 1;
  bool is_loaded = false; // a traction is given, else the angle
};

// A contact or a tie.
struct TorsionContact {
  std::string name;
  bool tied = false;
  double turns_through = NAN;                   // sum of limits times areas times radii
  double start = NAN, start_at[2] = {NAN, NAN}; // torque at the first slip, the place of the pair
  double through = NAN;                         // torque as the last pair began to slip
};

// A place where stick meets slip, in the last state.
struct TorsionBorder {
  int32_t contact = 1;
  double at[2] = {NAN, NAN};
};

struct TorsionStep {
  std::vector<double> loads;         // factors of the cases
  std::vector<double> angle, torque; // of the parts
  std::vector<double> carried;       // by the contacts, torque on their second sides
  std::vector<int32_t> slipping;     // pairs of the contacts
};

struct TorsionTable {
  std::vector<std::string> cases;
  std::vector<TorsionPart> parts;
  std::vector<TorsionContact> contacts;
  std::vector<TorsionStep> steps;
  std::vector<TorsionBorder> borders;
  double residual = 0;  // of the tractions of pairs, relative
  double imbalance = 0; // of the torques of a body, over the largest torque
  std::string ended;    // why the history ended early; empty: it did not
  std::string why;      // why there are no results; empty: there are
  bool any() const { return !parts.empty() || !why.empty(); }
};

} // namespace app
