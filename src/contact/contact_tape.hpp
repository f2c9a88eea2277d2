#pragma once
// The contact matrices on tape CONTACT (MTAPE1 and MTAPE2 of 1987): one column of m numbers per block.
#include "memory/config.hpp"
#include "store/tapes.hpp"

namespace c2d {

// Matrices in the order of their blocks. Bodies: S_u u_c = S_t t_c + sum_k lambda_k s_k.
enum class ContactMatrix : int32_t {
  displacement1,
  traction1,
  load1, // S_u, S_t: m columns; s: L columns, of body 1
  displacement2,
  traction2,
  load2,            // of body 2
  flexibility,      // F = -S_u^-1 S_t of the inverted body, m columns
  flexibility_load, // v = S_u^-1 s of the inverted body, L columns
  compliance,       // M, m columns
  closing,          // h, L columns
  stiffness,        // T = M^-1 B, m columns: the tableau with every pair sticking
  stiffness_load,   // b = -M^-1 h, L columns
  resultants,       // G, E and R of the body that the contact has to hold (contact/rigid_balance.hpp), 3 columns each
  equilibrium,
  motions,
  count
};

struct ContactTape {
  Tapes* tapes;
  int32_t m, cases;
  void* buffer; // a block of m numbers, aligned to 64
};

int64_t contact_columns(ContactMatrix matrix, int32_t m, int32_t cases);
int64_t contact_blocks(int32_t m, int32_t cases); // on the whole tape

// One column, m numbers. Errors: those of the block store.
c2d_status write_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, const Real* data);
c2d_status read_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, Real* data);
// All columns of a matrix, leading dimension m.
c2d_status write_matrix(const ContactTape& tape, ContactMatrix matrix, const Real* data);
c2d_status read_matrix(const ContactTape& tape, ContactMatrix matrix, Real* data);

} // namespace c2d
