#include "contact/contact_tape.hpp"

#include <string.h>

namespace c2d {

namespace {

bool is_per_case(ContactMatrix matrix) {
  switch (matrix) {
  case ContactMatrix::load1:
  case ContactMatrix::load2:
  case ContactMatrix::flexibility_load:
  case ContactMatrix::closing:
  case ContactMatrix::stiffness_load: return true;
  default: return false;
  }
}

uint64_t first_block(ContactMatrix matrix, int32_t m, int32_t cases) {
  int64_t block = 0;
  for (int32_t i = 0; i < static_cast<int32_t>(matrix); ++i) block += contact_columns(static_cast<ContactMatrix>(i), m, cases);
  return static_cast<uint64_t>(block);
}

} // namespace

int64_t contact_columns(ContactMatrix matrix, int32_t m, int32_t cases) {
  if (matrix >= ContactMatrix::resultants) return 3;
  return is_per_case(matrix) ? cases : m;
}

int64_t contact_blocks(int32_t m, int32_t cases) { return static_cast<int64_t>(first_block(ContactMatrix::count, m, cases)); }

c2d_status write_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, const Real* data) {
  const uint64_t bytes = static_cast<uint64_t>(tape.m) * sizeof(Real);
  memcpy(static_cast<char*>(tape.buffer) + kBlockHeaderBytes, data, static_cast<size_t>(bytes));
  const uint64_t block = first_block(matrix, tape.m, tape.cases) + static_cast<uint64_t>(column);
  return write_block(*tape.tapes, C2D_TAPE_CONTACT, block, tape.buffer, bytes);
}

c2d_status read_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, Real* data) {
  const uint64_t bytes = static_cast<uint64_t>(tape.m) * sizeof(Real);
  const uint64_t block = first_block(matrix, tape.m, tape.cases) + static_cast<uint64_t>(column);
  const c2d_status status = read_block(*tape.tapes, C2D_TAPE_CONTACT, block, tape.buffer, bytes);
  if (status == C2D_OK) memcpy(data, static_cast<const char*>(tape.buffer) + kBlockHeaderBytes, static_cast<size_t>(bytes));
  return status;
}

c2d_status write_matrix(const ContactTape& tape, ContactMatrix matrix, const Real* data) {
  const int64_t columns = contact_columns(matrix, tape.m, tape.cases);
  for (int32_t j = 0; j < columns; ++j) {
    const c2d_status status = write_column(tape, matrix, j, data + static_cast<int64_t>(j) * tape.m);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

c2d_status read_matrix(const ContactTape& tape, ContactMatrix matrix, Real* data) {
  const int64_t columns = contact_columns(matrix, tape.m, tape.cases);
  for (int32_t j = 0; j < columns; ++j) {
    const c2d_status status = read_column(tape, matrix, j, data + static_cast<int64_t>(j) * tape.m);
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace c2d
