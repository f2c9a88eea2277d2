#pragma once
// What is known at an element end, and the units of a model.
#include "model/model.hpp"

namespace c2d {

// Is the traction component (0: x, 1: y) at this end prescribed? Ends that no card names are free of
// traction, so theirs is; whether the end belongs to a contact pair is not asked here.
bool traction_known(const Model& m, int b, int32_t end, int component);

// Is this component of this pair's nodes what the contact conditions decide? Both are if the pair may slip,
// else only the one along the normal.
bool is_contact_component(const Pair& pair, int component);

// Fills head->length_unit and head->stress_unit. Needs coordinates and moduli that are set and finite. Length
// 0 (all points coincide) gives 1.
void set_units(const Model& m);

} // namespace c2d
