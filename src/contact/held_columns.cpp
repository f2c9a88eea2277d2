#include "contact/held_columns.hpp"

namespace c2d {

namespace {

const Pair& pair_at(const Model& m, int32_t dof) { return m.pair[pair_of_slot(m, dof)]; }

// Columns of A that become those of T.
struct Holding {
  const ContactTape& tape;
  const Form& form;
  const OpenColumns& columns;
  int32_t m;
  Real g[kMostDelayed * kMostHeld]; // rows of G

  Real* column(int32_t j) const { return columns.first + static_cast<int64_t>(j) * m; }
  // Which of the slots that hold motions a column is; -1: none.
  int32_t held(int32_t j) const {
    for (int32_t k = 0; k < form.count; ++k)
      if (form.held[k] == columns.dof[j]) return k;
    return -1;
  }
};

c2d_status read_rows_of_g(Holding& h) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < h.form.count && status == C2D_OK; ++k) {
    const Real* g = nullptr;
    status = view_column(h.tape, ContactMatrix::resultants, k, &g);
    for (int32_t j = 0; j < h.columns.count && status == C2D_OK; ++j) h.g[j * kMostHeld + k] = g[h.columns.dof[j]];
  }
  return status;
}

// a := a - A_H G^T: tau_H balances a force.
c2d_status balance(const Holding& h) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < h.form.count && status == C2D_OK; ++k) {
    const Real* a = nullptr;
    status = view_column(h.tape, ContactMatrix::compliance, held_column(*h.tape.model, h.form.held[k]), &a);
    for (int32_t j = 0; j < h.columns.count && status == C2D_OK; ++j) {
      Real* const to = h.column(j);
      const Real by = h.held(j) < 0 ? h.g[j * kMostHeld + k] : Real(0);
      for (int32_t i = 0; i < h.m && by != 0; ++i) to[i] -= by * a[i];
    }
  }
  return status;
}

// a := a - R a_H, with -G in these rows; of a slot that holds a motion R itself.
c2d_status move(const Holding& h) {
  c2d_status status = C2D_OK;
  for (int32_t k = 0; k < h.form.count && status == C2D_OK; ++k) {
    const Real* r = nullptr;
    status = view_column(h.tape, ContactMatrix::motions, k, &r);
    for (int32_t j = 0; j < h.columns.count && status == C2D_OK; ++j) {
      Real* const to = h.column(j);
      const int32_t own = h.held(j);
      const Real by = own < 0 ? to[h.form.held[k]] : Real(0);
      for (int32_t i = 0; i < h.m && own == k; ++i) to[i] = r[i];
      for (int32_t i = 0; i < h.m && by != 0; ++i) to[i] -= by * r[i];
    }
  }
  for (int32_t j = 0; j < h.columns.count; ++j)
    for (int32_t k = 0; k < h.form.count; ++k) h.column(j)[h.form.held[k]] = h.held(j) < 0 ? -h.g[j * kMostHeld + k] : Real(0);
  return status;
}

} // namespace

int32_t held_column(const Model& m, int32_t slot) {
  const Pair& pair = pair_at(m, slot);
  return pair.made + slot - pair.dof;
}

bool holds_tangents(const Model& m, const Form& form) {
  for (int32_t k = 0; k < form.count; ++k)
    if (pair_at(m, form.held[k]).dof != form.held[k]) return true;
  return false;
}

namespace {

c2d_status read_all(const OpenColumns& columns) {
  const ContactTape& tape = columns.tape;
  const Model& m = *tape.model;
  const bool demand = is_on_demand(m);
  c2d_status status = C2D_OK;
  for (int32_t j = 0; j < columns.count && status == C2D_OK; ++j) {
    Real* const to = columns.first + static_cast<int64_t>(j) * m.head->contact;
    const Pair& pair = pair_at(m, columns.dof[j]);
    status = demand ? read_compliance(tape, pair, columns.dof[j] - pair.dof, to)
                    : read_column(tape, ContactMatrix::stiffness, columns.dof[j], to);
  }
  if (!demand || columns.form.count == 0 || status != C2D_OK) return status;
  Holding h{tape, columns.form, columns, m.head->contact, {}};
  status = read_rows_of_g(h);
  if (status == C2D_OK) status = balance(h);
  return status == C2D_OK ? move(h) : status;
}

} // namespace

c2d_status OpenColumns::finish() {
  const c2d_status status = read_all(*this);
  first += static_cast<int64_t>(tape.model->head->contact) * count;
  count = 0;
  return status;
}

} // namespace c2d
