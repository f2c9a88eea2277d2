#pragma once
// The contact matrices on tape CONTACT (MTAPE1 and MTAPE2 of 1987): one column per block. m: contact unknowns of the model.
#include "memory/config.hpp"
#include "model/model.hpp"
#include "store/tapes.hpp"

namespace c2d {

// Of each body, with as many rows as it has contact unknowns: S_u u = S_t t + sum_k lambda_k s_k. Bodies that keep no equations
// are solved for: u = F t + sum_k lambda_k v_k + R x (contact/reduction/body_compliance.hpp). (F and v do not stand where S_t
// and s stood: a write that is lost must not leave what reads as good.)
enum class BodyMatrix : int32_t {
  displacement, // S_u
  traction,     // S_t
  load,         // s: per load case
  flexibility, // F, of bodies that are solved for; where displacements are unknowns, z = X w' + sum_k lambda_k x_k, a row of X,
               // m numbers of the model, in each column
  response,    // v of those, and of rigid ones, or x: per load case
  given,       // g: per load case, a number for each motion of the body
  motions,     // R, G and E: kMostMotions columns each
  resultants,
  equilibrium,
  count
};
// Of the model (contact/reduction/reduction.hpp).
enum class ContactMatrix : int32_t {
  compliance, // A and C: m columns of m, and one for each motion of bodies that keep no equations; on demand as many as
              // there is room for, of pairs in the order in which they were made (Pair::made)
  closing,    // h: per load case, of m
  stiffness,  // T: m columns of m, the tableau for what is basic (contact/basis.hpp), most often with every pair sticking; on
              // demand displacements on side 0 of all pairs, a column for each of A, with the motions that make the slots rest
              // which hold them
  stiffness_load, // b: per load case, of m
  resultants, // G and R of all bodies, each orthonormal, on demand 1 or 0 in the slots that hold: a column of m for each motion
  motions,
  mix,         // what made G orthonormal: a column for each motion, a number for each motion
  border,      // C, orthonormal: a column of m for each of these motions
  motion,      // x = X w' + sum_k lambda_k x_k: a row of X, m numbers, for each of these motions, on demand displacements on
               // side 0 of all pairs under each column of `motions`
  motion_load, // x_k: per load case, a number for each
  basis,       // a column of m, if there are many (contact/basis.hpp)
  count
};

constexpr int32_t kMostMotions = 3; // of a body in a plane

struct ContactTape {
  Tapes* tapes;
  const Model* model;
  void* buffer; // a block of contact_block_numbers(m), aligned to 64
  // Of a contact on demand: makes columns of A, and with them of the tableau with every pair open, unless they are there.
  c2d_status (*make)(const ContactTape& tape, const int32_t* pair, int32_t count) = nullptr;
};
inline uint64_t contact_block_numbers(int64_t m) { return static_cast<uint64_t>(m > kMostMotions ? m : kMostMotions); }

inline int32_t contact_unknowns(const ContactTape& tape) { return tape.model->head->contact; }
inline int32_t free_motions(const ContactTape& tape) { return tape.model->head->motions; }
inline int32_t border_motions(const ContactTape& tape) { return tape.model->head->border; }
// On the whole tape, for so many bodies, contact unknowns (some), motions and load cases; never more with fewer of them.
int64_t contact_blocks(int64_t bodies, int64_t m, int64_t motions, int64_t cases);
// Fills Body::first_block; returns the number of blocks.
int64_t place_contact_blocks(const Model& m);

// One column. Errors: those of the block store.
c2d_status write_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, const Real* data);
c2d_status read_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, Real* data);
c2d_status write_column(const ContactTape& tape, int b, BodyMatrix matrix, int32_t column, const Real* data);
c2d_status read_column(const ContactTape& tape, int b, BodyMatrix matrix, int32_t column, Real* data);
// On demand these pairs' columns are made, unless they are there. Errors: the block store's; C2D_ERR_MEMORY: there is no room.
c2d_status need_columns(const ContactTape& tape, const int32_t* pair, int32_t count);
// The column of a pair's slot in A.
c2d_status read_compliance(const ContactTape& tape, const Pair& pair, int slot, Real* data);
// A column as it stands in the tape's buffer, until something else is read or written.
c2d_status view_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, const Real** out);
// All columns of a matrix, at this distance.
c2d_status write_matrix(const ContactTape& tape, ContactMatrix matrix, const Real* data, int64_t ld);
c2d_status read_matrix(const ContactTape& tape, ContactMatrix matrix, Real* data, int64_t ld);
c2d_status read_matrix(const ContactTape& tape, int b, BodyMatrix matrix, Real* data, int64_t ld);
c2d_status write_matrix(const ContactTape& tape, int b, BodyMatrix matrix, const Real* data, int64_t ld);

} // namespace c2d
