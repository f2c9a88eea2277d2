#pragma once
// Known quantities at element ends, and the internal units of a model.
#include "model/model.hpp"

namespace c2d {

// Is the traction component (0: x, 1: y) at this end prescribed? Ends without a condition have zero traction, which counts as
// prescribed. Contact pairs are not considered here.
bool traction_known(const Model& m, int b, int32_t end, int component);

// Do the contact conditions determine this component at the nodes of the pair? Both components if the pair can slip, else only
// the one along the normal.
bool is_contact_component(const Pair& pair, int component);

// Fills head->length_unit and head->stress_unit. Needs coordinates and moduli that are set and finite. Length
// 0 (all points coincide) gives 1.
void set_units(const Model& m);

} // namespace c2d
