#include "contact/contact_tape.hpp"

#include <string.h>

#include "contact/basis.hpp"
#include "memory/hostile.hpp"

namespace c2d {

namespace {

// Columns and rows of one matrix, and its first block.
struct Place {
  int64_t first, columns, rows;
};

// What of a body's matrices is needed: on demand neither its equations nor F.
enum class Needs { equations, flexibility_too, none };
// Of a body with n unknowns, from its own first block on; `long_rows`: of F, which is X where the displacements are unknowns.
Place place_of(BodyMatrix matrix, int64_t n, int64_t long_rows, Needs needs, int64_t cases) {
  Place at = {0, 0, n};
  for (int32_t i = 0; i <= static_cast<int32_t>(matrix); ++i) {
    at.first += at.columns;
    switch (static_cast<BodyMatrix>(i)) {
    case BodyMatrix::displacement:
    case BodyMatrix::traction: at.columns = needs == Needs::none ? 0 : n; break;
    case BodyMatrix::flexibility: at.columns = needs == Needs::flexibility_too ? n : 0; break;
    case BodyMatrix::load:
    case BodyMatrix::response:
    case BodyMatrix::given: at.columns = cases; break;
    default: at.columns = kMostMotions;
    }
  }
  if (matrix == BodyMatrix::given) at.rows = kMostMotions;
  if (matrix == BodyMatrix::flexibility) at.rows = long_rows;
  return at;
}

// `columns`: those on demand; 0: all are there.
Place place_of(ContactMatrix matrix, int64_t m, int64_t columns, int64_t motions, int64_t border, int64_t cases) {
  Place at = {0, 0, 0};
  for (int32_t i = 0; i <= static_cast<int32_t>(matrix); ++i) {
    at.first += at.columns;
    at.rows = m;
    switch (static_cast<ContactMatrix>(i)) {
    case ContactMatrix::compliance: at.columns = columns > 0 ? columns : m + border; break;
    case ContactMatrix::stiffness: at.columns = columns > 0 ? columns : m; break;
    case ContactMatrix::motion_load: at.rows = border; [[fallthrough]];
    case ContactMatrix::closing:
    case ContactMatrix::stiffness_load: at.columns = cases; break;
    case ContactMatrix::border: at.columns = border; break;
    case ContactMatrix::motion: at.columns = columns > 0 ? motions : border; break;
    case ContactMatrix::basis: at.columns = has_basis(m) ? 1 : 0; break;
    case ContactMatrix::mix: at.rows = motions; [[fallthrough]];
    default: at.columns = motions;
    }
  }
  return at;
}

Needs needs_of(const Model& m, int b) {
  if (is_on_demand(m)) return Needs::none;
  return !keeps_equations(m, b) || has_open_form(m) ? Needs::flexibility_too : Needs::equations;
}

Place place_of(const ContactTape& tape, ContactMatrix matrix) {
  const ModelHeader& head = *tape.model->head;
  return place_of(matrix, head.contact, head.columns, head.motions, head.border, head.load_cases);
}
Place place_of(const ContactTape& tape, int b, BodyMatrix matrix) {
  const Body& body = tape.model->body[b];
  const int32_t rows = has_displacements(*tape.model, b) ? tape.model->head->contact : body.contact;
  Place at = place_of(matrix, body.contact, rows, needs_of(*tape.model, b), tape.model->head->load_cases);
  at.first += body.first_block;
  return at;
}

c2d_status write(const ContactTape& tape, const Place& at, int64_t column, const Real* data) {
  const uint64_t bytes = static_cast<uint64_t>(at.rows) * sizeof(Real);
  memcpy(static_cast<char*>(tape.buffer) + kBlockHeaderBytes, data, static_cast<size_t>(bytes));
  return write_block(*tape.tapes, C2D_TAPE_CONTACT, static_cast<uint64_t>(at.first + column), tape.buffer, bytes);
}

c2d_status read(const ContactTape& tape, const Place& at, int64_t column, Real* data) {
  const uint64_t bytes = static_cast<uint64_t>(at.rows) * sizeof(Real);
  const c2d_status status =
      read_block(*tape.tapes, C2D_TAPE_CONTACT, static_cast<uint64_t>(at.first + column), tape.buffer, bytes);
  if (status == C2D_OK) memcpy(data, static_cast<const char*>(tape.buffer) + kBlockHeaderBytes, static_cast<size_t>(bytes));
  return status;
}

c2d_status write_all(const ContactTape& tape, const Place& at, const Real* data, int64_t ld) {
  c2d_status status = C2D_OK;
  for (int64_t j = 0; j < at.columns && status == C2D_OK; ++j) status = write(tape, at, j, data + j * ld);
  return status;
}

c2d_status read_all(const ContactTape& tape, const Place& at, Real* data, int64_t ld) {
  c2d_status status = C2D_OK;
  for (int64_t j = 0; j < at.columns && status == C2D_OK; ++j) status = read(tape, at, j, data + j * ld);
  return status;
}

} // namespace

int64_t contact_blocks(int64_t bodies, int64_t m, int64_t motions, int64_t cases) {
  // Every contact unknown belongs to two bodies.
  return place_of(ContactMatrix::count, m, 0, motions, motions, cases).first + 6 * m + bodies * (3 * cases + 3 * kMostMotions);
}

int64_t place_contact_blocks(const Model& m) {
  const ModelHeader& head = *m.head;
  int64_t block = place_of(ContactMatrix::count, head.contact, head.columns, head.motions, head.border, head.load_cases).first;
  for (int b = 0; b < m.head->bodies; ++b) {
    m.body[b].first_block = block;
    if (m.body[b].contact > 0)
      block += place_of(BodyMatrix::count, m.body[b].contact, 0, needs_of(m, b), m.head->load_cases).first;
  }
  return m.head->contact > 0 ? block : 0;
}

c2d_status need_columns(const ContactTape& tape, const int32_t* pair, int32_t count) {
  return is_on_demand(*tape.model) ? tape.make(tape, pair, count) : c2d_status{C2D_OK};
}
c2d_status read_compliance(const ContactTape& tape, const Pair& pair, int slot, Real* data) {
  const bool demand = is_on_demand(*tape.model);
  C2D_ASSERT(!demand || pair.made >= 0);
  return read_column(tape, ContactMatrix::compliance, demand ? pair.made + slot : pair.dof + slot, data);
}

c2d_status view_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, const Real** out) {
  const Place at = place_of(tape, matrix);
  *out = reinterpret_cast<const Real*>(static_cast<const char*>(tape.buffer) + kBlockHeaderBytes);
  return read_block(*tape.tapes, C2D_TAPE_CONTACT, static_cast<uint64_t>(at.first + column), tape.buffer,
                    static_cast<uint64_t>(at.rows) * sizeof(Real));
}

c2d_status write_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, const Real* data) {
  return write(tape, place_of(tape, matrix), column, data);
}
c2d_status read_column(const ContactTape& tape, ContactMatrix matrix, int32_t column, Real* data) {
  return read(tape, place_of(tape, matrix), column, data);
}
c2d_status write_column(const ContactTape& tape, int b, BodyMatrix matrix, int32_t column, const Real* data) {
  return write(tape, place_of(tape, b, matrix), column, data);
}
c2d_status read_column(const ContactTape& tape, int b, BodyMatrix matrix, int32_t column, Real* data) {
  return read(tape, place_of(tape, b, matrix), column, data);
}

c2d_status write_matrix(const ContactTape& tape, ContactMatrix matrix, const Real* data, int64_t ld) {
  return write_all(tape, place_of(tape, matrix), data, ld);
}
c2d_status read_matrix(const ContactTape& tape, ContactMatrix matrix, Real* data, int64_t ld) {
  return read_all(tape, place_of(tape, matrix), data, ld);
}
c2d_status write_matrix(const ContactTape& tape, int b, BodyMatrix matrix, const Real* data, int64_t ld) {
  return write_all(tape, place_of(tape, b, matrix), data, ld);
}
c2d_status read_matrix(const ContactTape& tape, int b, BodyMatrix matrix, Real* data, int64_t ld) {
  return read_all(tape, place_of(tape, b, matrix), data, ld);
}

} // namespace c2d
