#pragma once
// The contact system where no pair that may change has friction, METHOD (10.9): w_t of such a pair is an unknown in the place
// of its q, which is zero. What is given are the other slots: the normal motions of these pairs, and motions of ties.
#include "contact/contact_tape.hpp"
#include "contact/tableau.hpp"

namespace c2d {

// May the model have it? As in the tableau, the number of unknowns alone says whether it is worth while.
bool has_sliding_form(const Model& m);
// Is it w_t of a pair that may change? Of the model's contact unknowns; of a body's.
bool is_sliding_slot(const Model& m, int32_t dof);
bool is_sliding_slot(const Model& m, int b, int32_t own);
int32_t first_sliding_slot(const Model& m); // -1: no pair may slide
// How many slots are given; the number of one of them among these; the one of this number.
inline int32_t given_slots(const Model& m) { return m.head->path_pairs + m.head->contact - m.head->path_unknowns; }
int32_t given_number(const Model& m, int32_t dof);
inline int32_t given_slot(const Model& m, int32_t number) {
  const int32_t tied = number - m.head->path_pairs;
  return tied < 0 ? m.pair[number].dof : m.head->path_unknowns + tied;
}
} // namespace c2d
