#include "solver/on_demand.hpp"

#include "bie/batch.hpp"
#include "bie/panel.hpp"
#include "contact/basis.hpp"
#include "contact/body_unknowns.hpp"
#include "memory/parts.hpp"
#include "memory/text.hpp"
#include "model/pair_frame.hpp"
#include "solver/compressed.hpp"
#include "solver/energy.hpp"
#include "solver/judge.hpp"

namespace c2d {

C2D_USES(EnergyPart);

namespace {

// Supports hold every body, each pair has two bodies and nodes that face each other, and every mesh can be compressed.
bool may_be_on_demand(const Model& m) {
  if (!has_open_form(m) || m.head->motions != 0) return false;
  for (int32_t i = 0; i < m.head->zones; ++i)
    if (m.zone[i].is_free != 0 || m.zone[i].is_self != 0) return false;
  for (int b = 0; b < m.head->bodies; ++b)
    if (!is_rigid(m, b) && !may_compress(m, b)) return false;
  return true;
}

} // namespace

void plan_demand(c2d_solver* s, const Model& m) {
  const int64_t room = columns_of(s->sizes);
  const bool demanded = s->sizes.touching > 0 && s->options.elimination == C2D_ELIMINATION_COMPRESSED &&
                        model_sizes(m).widest > room && may_be_on_demand(m);
  m.head->columns = demanded ? static_cast<int32_t>(room) : 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    const int8_t own = demanded && !is_rigid(m, b);
    if (demanded) m.body[b].keeps_equations = 0;
    if (own == m.body[b].on_demand) continue;
    m.body[b].on_demand = own;
    number_unknowns(m, b);
  }
}

c2d_status tell_touching(c2d_solver* s) {
  Sizes more = sizes_of(s);
  const int64_t twice = columns_of(more); // (there may be room for more than were told)
  more.touching = twice < more.pairs ? twice : more.pairs;
  c2d_error e = blank_error();
  uint64_t least = 0;
  if (phase_need(more, &least, nullptr) == C2D_OK) e.bytes_needed = s->layout.persistent + least + kAlignment - 1;
  char what[200];
  Text text = text_in(what);
  put_all(text, status_text(C2D_ERR_MEMORY), ": more pairs touch, or nearly, than the ", s->sizes.touching,
          " of c2d_limits.touching; room for ", more.touching, " takes ", e.bytes_needed, " bytes");
  return fail_with(s, e, C2D_ERR_MEMORY, what);
}

namespace {

// What stands in PathArea::later.
struct LaterArea {
  AssemblyScratch* scratch;
  Real *packing, *columns; // of the kernels; [2 m * kMostSides] of A, of displacements on side 0
  double* point;
  int32_t* twin;
  char* work;
};
constexpr int64_t kPacking = full_scratch(kDepth, kDepth);

uint64_t lay_out_area(const CompressedPlan& plan, int64_t m, char* base, LaterArea* out) {
  LaterArea area{};
  AreaCarver carver{base};
  const uint64_t nodes = static_cast<uint64_t>(plan.nodes), contact = static_cast<uint64_t>(m);
  carver.take(area.scratch, 1);
  carver.take(area.packing, static_cast<uint64_t>(kPacking));
  carver.take(area.columns, 2 * contact * static_cast<uint64_t>(kMostSides));
  carver.take(area.point, 2 * nodes);
  carver.take(area.twin, nodes);
  carver.take(area.work, later_sides_bytes(plan));
  if (out) *out = area;
  return carver.total();
}

LaterArea area_of(const Session& session, const CompressedPlan& plan) {
  LaterArea area;
  lay_out_area(plan, session.model.head->contact, static_cast<char*>(session.area.later), &area);
  return area;
}

ColumnSystem system_of(const Session& session, int b, const LaterArea& area) {
  const c2d_solver* s = session.solver;
  const Quadrature quadrature = s->options.quadrature == C2D_QUADRATURE_THESIS ? Quadrature::thesis : Quadrature::accurate;
  ColumnSystem system{session.model, b, quadrature, nullptr, area.point, area.twin, area.scratch, batch_for(s->instructions)};
  system.some_passed_over = place_sources(system);
  return system;
}

// work(sides) with a body's tree.
template <class Work> c2d_status with_tree(const Session& session, int b, const CompressedPlan& plan, Work work) {
  c2d_solver* s = session.solver;
  const LaterArea area = area_of(session, plan);
  const ColumnSystem system = system_of(session, b, area);
  const Engine engine = {kernel_for(s->instructions), area.packing, kPacking, nullptr, kAlone};
  return work(LaterSides{plan, system, s->tapes, area.work, engine});
}

// A displacement of a body in the frame of a pair, of `stride` solutions side by side.
Real displacement_along(const Model& m, int b, const Pair& pair, int side, int slot, const Real* x, int64_t stride) {
  Real sum = 0;
  for (int c = 0; c < 2; ++c)
    sum += static_cast<Real>(along(pair, slot, c)) * x[outer_column(m, b, pair.node[side], c) * stride];
  return sum;
}

} // namespace

uint64_t later_bytes(const CompressedPlan& plan, int64_t m) { return lay_out_area(plan, m, nullptr, nullptr); }

c2d_status respond_on_demand(c2d_solver* s) {
  Session session;
  open_session(s, session);
  const Model& m = session.model;
  const PathArea& area = session.area;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (is_rigid(m, b) || m.body[b].contact == 0) continue;
    const CompressedPlan plan = compression_of(m, b, plan_of(s, b));
    for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) {
      for (int32_t i = 0; i < m.head->load_cases; ++i) area.coefficient[i] = i == k ? Real(1) : Real(0);
      status = back_substitute_compressed(plan, s->tapes, area.coefficient, area.outer, area.work);
      if (status != C2D_OK) break;
      for_pairs_of(m, b, [&](const Pair& pair, int side) {
        for (int slot = 0; slot <= pair.tangential; ++slot)
          area.column[dof_on(m, pair, side) + slot] = displacement_along(m, b, pair, side, slot, area.outer, 1);
      });
      status = write_column(session.tape, b, BodyMatrix::response, k, area.column);
    }
  }
  return status;
}

c2d_status solve_on_demand(Session& session, int b, const CompressedPlan& plan, const Real* coefficient) {
  const int32_t own = session.model.body[b].contact;
  const c2d_status status = back_substitute_compressed(plan, session.solver->tapes, coefficient + 2 * static_cast<int64_t>(own),
                                                       session.area.outer, session.area.work);
  if (status != C2D_OK) return status;
  return with_tree(session, b, plan,
                   [&](const LaterSides& sides) { return add_tractions(sides, coefficient + own, session.area.outer); });
}

namespace {

// Columns that are made together.
struct Lot {
  int32_t count;
  int32_t pair[kMostSides], slot[kMostSides];
};

// What tractions on a body, those of the lot, make of its sides of the pairs, added to the columns.
c2d_status add_body(Session& session, int b, const Lot& lot, Real* columns) {
  const Model& m = session.model;
  int32_t unknown[kMostSides], place[kMostSides], side[kMostSides], count = 0;
  for (int32_t k = 0; k < lot.count; ++k)
    for (int at = 0; at < 2; ++at) {
      const Pair& pair = m.pair[lot.pair[k]];
      if (body_on(m, pair, at) != b) continue;
      unknown[count] = dof_on(m, pair, at) + lot.slot[k];
      place[count] = k;
      side[count++] = at;
    }
  if (count == 0) return C2D_OK;
  Real* x = nullptr;
  const c2d_status status = with_tree(session, b, compression_of(m, b, plan_of(session.solver, b)),
                                      [&](const LaterSides& sides) { return solve_unit_tractions(sides, unknown, count, &x); });
  if (status != C2D_OK) return status;
  for_pairs_of(m, b, [&](const Pair& pair, int own) {
    for (int slot = 0; slot <= pair.tangential; ++slot)
      for (int32_t k = 0; k < count; ++k) {
        const Real u = signed_on(side[k], displacement_along(m, b, pair, own, slot, x + k, count));
        Real* const column = columns + 2 * static_cast<int64_t>(place[k]) * m.head->contact + pair.dof + slot;
        column[0] += signed_on(own, u);
        if (own == 0) column[m.head->contact] += u;
      }
  });
  if (!session.solver->keeps_energy) return C2D_OK;
  int32_t dof[kMostSides];
  for (int32_t k = 0; k < count; ++k) dof[k] = m.pair[lot.pair[place[k]]].dof + lot.slot[place[k]];
  kEnergyPart.add_demanded(session, b, DemandedColumns{count, dof, side, x});
  return C2D_OK;
}

c2d_status make_lot(Session& session, const Lot& lot) {
  const Model& m = session.model;
  c2d_solver* s = session.solver;
  const int32_t contact = m.head->contact;
  Real* columns = nullptr;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies && status == C2D_OK; ++b) {
    if (is_rigid(m, b)) continue;
    if (!columns) {
      columns = area_of(session, compression_of(m, b, plan_of(s, b))).columns;
      for (int64_t i = 0; i < 2 * static_cast<int64_t>(lot.count) * contact; ++i) columns[i] = 0;
    }
    status = add_body(session, b, lot, columns);
  }
  for (int32_t k = 0; k < lot.count && status == C2D_OK; ++k) {
    const Real* const column = columns + 2 * static_cast<int64_t>(k) * contact;
    note_demanded(s, m.pair[lot.pair[k]].dof + lot.slot[k], column);
    status = write_column(session.tape, ContactMatrix::compliance, s->made + k, column);
    if (status == C2D_OK) status = write_column(session.tape, ContactMatrix::stiffness, s->made + k, column + contact);
  }
  if (status != C2D_OK) return status;
  for (int32_t k = 0; k < lot.count; ++k)
    if (lot.slot[k] == 0) m.pair[lot.pair[k]].made = s->made + k;
  s->made += lot.count;
  return C2D_OK;
}

} // namespace

c2d_status make_columns(void* context, const int32_t* pair, int32_t count) {
  Session& session = *static_cast<Session*>(context);
  c2d_solver* s = session.solver;
  const Model& m = session.model;
  const auto slots_of = [&](int32_t i) {
    return m.pair[i].made >= 0 ? 0 : (s->sliding != 0 && m.pair[i].tangential != 0 ? 1 : 1 + m.pair[i].tangential);
  };
  int32_t needed = 0;
  for (int32_t i = 0; i < count; ++i) needed += slots_of(pair[i]);
  if (needed > m.head->columns - s->made) return C2D_ERR_MEMORY;
  c2d_status status = C2D_OK;
  Lot lot;
  lot.count = 0;
  for (int32_t i = 0; i < count && status == C2D_OK; ++i) {
    const int32_t slots = slots_of(pair[i]);
    if (lot.count + slots > kMostSides) {
      status = make_lot(session, lot);
      lot.count = 0;
    }
    for (int32_t slot = 0; slot < slots; ++slot) {
      lot.pair[lot.count] = pair[i];
      lot.slot[lot.count++] = slot;
    }
  }
  return status == C2D_OK && lot.count > 0 ? make_lot(session, lot) : status;
}

} // namespace c2d
