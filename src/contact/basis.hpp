#pragma once
// What the tableau on the tape has among its unknowns: of every slot its force, as of a pair that sticks, or its motion. Most
// often forces alone; motions of the tangents without friction (contact/frictionless.hpp), and all motions but those that hold
// the bodies where nothing is touched yet (contact/reduction/open_form.hpp).
#include "contact/contact_tape.hpp"
#include "linalg/delayed.hpp"

namespace c2d {

// Small ones have but the one: the number of unknowns alone says what is worth while. (So does small code, on the same tape.)
constexpr bool has_basis(int64_t m) { return C2D_DELAYED_(m) > 0; }
// Column `basis` on the tape, a number for each slot. Of `no_force` the column is zero, and not looked at.
constexpr Real kBasisForce = 0, kBasisMotion = 1, kBasisNoForce = 2, kBasisUnfinished = 3;

constexpr int32_t kMostHeld = 12;
struct Form {
  bool sliding = false, open = false;
  bool finished = true;               // false: its writing has been broken off
  int32_t count = 0, held[kMostHeld]; // open: the slots of forces
};
// Is it the force of this slot that b_k on the tape has?
bool has_force(const Form& form, const Model& m, int32_t dof);
// `basis`: m numbers; where there is no such column, all kBasisForce. Errors: the block store's.
c2d_status read_form(const ContactTape& tape, Real* basis, Form* form);
c2d_status write_unfinished(const ContactTape& tape, Real* basis);

// May the model have the open form? Supports hold every body that does not keep its equations, and nothing is tied.
inline bool has_open_form(const Model& m) {
  return !kSmallCode && has_basis(m.head->contact) && m.head->border == 0 && m.head->motions <= kMostHeld &&
         m.head->path_unknowns == m.head->contact && further_unknowns(m) == 0;
}
// How much farther a slot gives way to a traction of its own than what its neighbours in the zone make of a straight line, in a
// column of A: what the surface does there, without what shifts, turns or bends it. At the ends of the zone only what shifts it
// is taken off: own motion and a line through others may be the same by chance.
double local_compliance(const Model& m, int32_t pair, int slot, const Real* column);
// The pair of a contact unknown.
int32_t pair_of_slot(const Model& m, int32_t dof);
// Bends a body, or shifts, so much more than that, by the largest number of the column, that digits are lost?
bool loses_digits(const Model& m, int32_t pair, int slot, const Real* column, double most);

} // namespace c2d
