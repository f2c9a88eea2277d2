// Headings and named values of the printed results, and the parts of the data read.
#pragma once

#include "post/summary.hpp"

#include <contact2d.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace app {

// The largest coordinate or length among the places of numbers, for the size of the model.
template <class Numbers> double extent_of(const Numbers& all) {
  double most = 0.0;
  for (const auto& q : all)
    for (const double v : {q.at[0], q.at[1], q.along})
      if (std::isfinite(v)) most = std::max(most, std::fabs(v));
  return most;
}

void append_rule(std::string& out);
void append_section(std::string& out, const std::string& title);
// "Body 2 (bolt)", and the rest of the heading.
void append_body_section(std::string& out, const Summary& summary, int32_t body, const char* more = "");
// "  name ............ value"; append_name stops before the value.
std::string& append_name(std::string& out, const char* name);
void append_item(std::string& out, const char* name, int64_t value);
void append_item(std::string& out, const char* name, double value);
void append_item(std::string& out, const char* name, const char* value);
// The load factors reached, of all load cases.
void append_loads(std::string& out, const std::vector<double>& factors);

// Known components of every element end that is neither free of traction nor left to the contact, case by
// case.
c2d_status append_conditions(std::string& out, c2d_solver* solver, const Summary& summary, int32_t body);
// Point loads, body forces, motions of rigid bodies, press fit: nothing of what there is none.
c2d_status append_other_loads(std::string& out, c2d_solver* solver, const Summary& summary);
// Coefficients of friction and the load path.
c2d_status append_path(std::string& out, c2d_solver* solver, const Summary& summary);
// Elements and nodes of every zone.
c2d_status append_zones(std::string& out, c2d_solver* solver, const Summary& summary);

} // namespace app
