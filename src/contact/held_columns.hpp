#pragma once
// Columns of the tableau with every pair open, for pairs that wake (contact/asleep.hpp) and for a new tableau. On demand they
// are made of those of A as they are read, METHOD (10.11): R and G of the motions that no support prevents stand on the tape
// with 1 in the slots that hold them.
#include "contact/basis.hpp"

namespace c2d {

struct OpenColumns {
  Real* first; // [m * count]
  int32_t count;
  int32_t dof[kMostDelayed];
};
// Errors: the block store's.
c2d_status read_open_columns(const ContactTape& tape, const Form& form, const OpenColumns& columns);
// Do tangents hold motions?
bool holds_tangents(const Model& m, const Form& form);
// The column on the tape, of those made on demand, of a slot that holds a motion.
int32_t held_column(const Model& m, int32_t slot);

} // namespace c2d
