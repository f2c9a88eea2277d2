#pragma once
// Columns of the tableau with every pair open, for pairs that wake (contact/asleep.hpp) and for a new tableau. On demand they
// are made of those of A as they are read, METHOD (10.11): R and G of the motions that no support prevents stand on the tape
// with 1 in the slots that hold them.
#include "contact/basis.hpp"

namespace c2d {

// Columns of these slots, one behind the other from `first` on; some are read together. Errors: the block store's.
struct OpenColumns {
  const ContactTape& tape;
  const Form& form;
  Real* first; // of those still to be read, [m] each
  int32_t count;
  int32_t dof[kMostDelayed];

  c2d_status take(int32_t slot) {
    dof[count++] = slot;
    return count < kMostDelayed ? c2d_status{C2D_OK} : finish();
  }
  c2d_status finish(); // after the last
};
// Do tangents hold motions?
bool holds_tangents(const Model& m, const Form& form);
// The column on the tape, of those made on demand, of a slot that holds a motion.
int32_t held_column(const Model& m, int32_t slot);

} // namespace c2d
