#include "solver/demand/on_demand.hpp"

#include <string.h>

#include "bie/integrals/batch.hpp"
#include "bie/measure.hpp"
#include "bie/panel.hpp"
#include "contact/basis.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "memory/math.hpp"
#include "memory/parts.hpp"
#include "memory/text.hpp"
#include "model/pair_frame.hpp"
#include "solver/demand/compressed.hpp"
#include "solver/demand/hold_demand.hpp"
#include "solver/energy/energy.hpp"
#include "solver/judge.hpp"
#include "solver/load_path.hpp"

namespace c2d {

C2D_USES(EnergyPart);

namespace {

// The work of a traction at an end of an element, component c, on a motion, over the traction's integral.
double work_of_reaction(const Model& m, int b, int32_t end, int c, const double motion[3]) {
  const double unit = m.head->length_unit, *centre = m.body[b].centre;
  EndResultant weight[kElementNodes];
  end_resultants(m, b, end / m.head->function_nodes, Measure::own_length, weight);
  const EndResultant& w = weight[end % m.head->function_nodes];
  const double arm = c == 0 ? -(w.wy - centre[1] / unit * w.w) : w.wx - centre[0] / unit * w.w;
  return w.w != 0.0 ? fabs((motion[c] * w.w + motion[2] * arm) / w.w) : 0.0; // (between double nodes there is none)
}

// Does no reaction of an elastic body do work on its free motions? Then what its tractions balance is known (motions_held):
// else, where it may turn about a single node, reactions have a moment about that, as their lines of action are those of the
// elements.
bool are_plain(const Model& m, int b) {
  for (int32_t node = 0; node < m.body[b].nodes && m.body[b].free_motions > 0; ++node) {
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c) {
      if (unknown[c].kind != UnknownKind::traction && unknown[c].kind != UnknownKind::shared_traction) continue;
      for (int32_t end : unknown[c].end)
        for (int32_t k = 0; k < m.body[b].free_motions && end >= 0; ++k)
          if (!(work_of_reaction(m, b, end, c, m.body[b].free_motion[k]) < 1e-12)) return false;
    }
  }
  return true;
}

// Normals or tangents of the contact hold what supports do not, each pair has two bodies and nodes that face each other, and
// every mesh can be compressed.
bool may_be_on_demand(c2d_solver* s, const Model& m) {
  if (!has_basis(m.head->contact) || m.head->path_unknowns != m.head->contact) return false;
  for (int32_t i = 0; i < m.head->zones; ++i)
    if (m.zone[i].is_free != 0 || m.zone[i].is_self != 0) return false;
  bool any = false;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (is_rigid(m, b)) continue;
    if (!may_compress(m, b) || !are_plain(m, b)) return false;
    any = any || m.body[b].contact > 0;
  }
  HeldSlots held;
  return any && choose_held(s, m, held);
}

} // namespace

void plan_demand(c2d_solver* s, const Model& m) {
  const int64_t room = columns_of(s->sizes);
  const bool demanded = s->sizes.touching > 0 && is_compressed(s) && model_sizes(m).widest > room && may_be_on_demand(s, m);
  m.head->columns = demanded ? static_cast<int32_t>(room) : 0;
  if (demanded) m.head->border = 0;
  for (int b = 0; b < m.head->bodies; ++b) {
    const int8_t own = demanded && !is_rigid(m, b);
    if (demanded) {
      m.body[b].keeps_equations = 0;
      m.body[b].first_border = m.body[b].first_motion; // (no motion is an unknown of the contact system)
    }
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

Real* room_for_columns(const Session& session) {
  const Model& m = session.model;
  int b = 0;
  while (is_rigid(m, b)) ++b;
  return area_of(session, compression_of(m, b, plan_of(session.solver, b))).columns;
}

c2d_status solve_body_motions(const Session& session, int b, Real** x) {
  return with_tree(session, b, compression_of(session.model, b, plan_of(session.solver, b)),
                   [&](const LaterSides& sides) { return solve_motions(sides, x); });
}

namespace {

// G: forces along x and y, and moments about the body's centre, of its contact tractions, along each free motion.
void find_resultants(const Model& m, int b, const double motion[3], Real* out) {
  const double unit = m.head->length_unit, cx = m.body[b].centre[0] / unit, cy = m.body[b].centre[1] / unit;
  for (int32_t i = 0; i < m.body[b].contact; ++i) out[i] = 0;
  for (ContactEnd end; next_contact_end(m, b, end);) {
    const Pair& pair = m.pair[end.at.pair];
    const EndResultant& w = end.weight();
    const double ux = motion[0] * w.w - motion[2] * (w.wy - cy * w.w), uy = motion[1] * w.w + motion[2] * (w.wx - cx * w.w);
    for (int slot = 0; slot <= pair.tangential; ++slot)
      out[dof_on(m, pair, end.at.side) + slot] += static_cast<Real>(ux * along(pair, slot, 0) + uy * along(pair, slot, 1));
  }
}

// R, G and g of a body, to the tape.
c2d_status respond_to_motions(Session& session, int b) {
  const Model& m = session.model;
  const PathArea& area = session.area;
  const int32_t count = m.body[b].free_motions;
  Real* x = nullptr;
  c2d_status status = count > 0 ? solve_body_motions(session, b, &x) : c2d_status{C2D_OK};
  for (int32_t k = 0; k < count && status == C2D_OK; ++k) {
    for_pairs_of(m, b, [&](const Pair& pair, int side) {
      for (int slot = 0; slot <= pair.tangential; ++slot)
        area.column[dof_on(m, pair, side) + slot] = displacement_along(m, b, pair, side, slot, x + k, count);
    });
    status = write_column(session.tape, b, BodyMatrix::motions, k, area.column);
    find_resultants(m, b, m.body[b].free_motion[k], area.column);
    if (status == C2D_OK) status = write_column(session.tape, b, BodyMatrix::resultants, k, area.column);
  }
  const double unit = m.head->length_unit * m.head->stress_unit;
  double* const factor = session.follower.load; // no path has begun
  for (int32_t k = 0; k < m.head->load_cases && count > 0 && status == C2D_OK; ++k) {
    Real g[kMostMotions] = {};
    double size = 0.0;
    for (int32_t i = 0; i < m.head->load_cases; ++i) factor[i] = i == k ? 1.0 : 0.0;
    for (int32_t j = 0; j < count; ++j)
      g[j] = static_cast<Real>(load_work(session, b, factor, m.body[b].free_motion[j], &size) / unit);
    for (int32_t i = 0; i < m.head->load_cases; ++i) factor[i] = 0.0;
    status = write_column(session.tape, b, BodyMatrix::given, k, g);
  }
  return status;
}

} // namespace

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
    if (status == C2D_OK) status = respond_to_motions(session, b);
  }
  return status;
}

namespace {

// By the contact unknowns of a body: where fit_motions finds what its motions have to make up for.
Real* rest_of(const Session& session, int b) {
  return room_for_columns(session) + static_cast<int64_t>(kMostMotions) * session.model.body[b].contact;
}

// The motions that come nearest to it.
c2d_status fit_motions(const Session& session, int b, double amount[kMostMotions]) {
  const int64_t own = session.model.body[b].contact;
  const int32_t count = session.model.body[b].free_motions;
  Real *const motion = room_for_columns(session), *const rest = rest_of(session, b);
  double matrix[kMostMotions][kMostMotions], right[kMostMotions];
  for (int32_t k = 0; k < count; ++k) {
    const c2d_status status = read_column(session.tape, b, BodyMatrix::motions, k, motion + k * own);
    if (status != C2D_OK) return status;
    amount[k] = 0.0;
  }
  for (int round = 0; round < 2; ++round) { // (normal equations lose digits where the contact is narrow)
    for (int32_t k = 0; k < count; ++k) {
      for (int32_t l = 0; l < count; ++l) matrix[k][l] = product(motion + k * own, motion + l * own, static_cast<int32_t>(own));
      right[k] = product(motion + k * own, rest, static_cast<int32_t>(own));
    }
    for (int32_t k = 0; k < count; ++k) // (the pairs hold the motions: it is positive definite)
      for (int32_t i = k + 1; i < count; ++i) {
        const double by = matrix[i][k] / matrix[k][k];
        for (int32_t l = k; l < count; ++l) matrix[i][l] -= by * matrix[k][l];
        right[i] -= by * right[k];
      }
    for (int32_t k = count - 1; k >= 0; --k) {
      for (int32_t l = k + 1; l < count; ++l) right[k] -= matrix[k][l] * right[l];
      right[k] /= matrix[k][k];
      amount[k] += right[k];
      for (int64_t j = 0; j < own; ++j) rest[j] -= static_cast<Real>(right[k]) * motion[k * own + j];
    }
  }
  return C2D_OK;
}

// The rest of the body goes along with it.
c2d_status add_motions(const Session& session, int b, const Real* coefficient) {
  const int32_t count = session.model.body[b].free_motions;
  double amount[kMostMotions] = {};
  Real *x = nullptr, *const rest = rest_of(session, b);
  for_pairs_of(session.model, b, [&](const Pair& pair, int side) {
    for (int slot = 0; slot <= pair.tangential; ++slot) { // (coefficients are minus the displacements)
      const int32_t j = dof_on(session.model, pair, side) + slot;
      rest[j] = -coefficient[j] - displacement_along(session.model, b, pair, side, slot, session.area.outer, 1);
    }
  });
  c2d_status status = fit_motions(session, b, amount);
  if (status == C2D_OK) status = solve_body_motions(session, b, &x);
  for (int32_t j = 0; j < outer_columns(session.model, b) && status == C2D_OK; ++j)
    for (int32_t k = 0; k < count; ++k)
      session.area.outer[j] += static_cast<Real>(amount[k]) * x[static_cast<int64_t>(j) * count + k];
  return status;
}

} // namespace

c2d_status fit_rigid(const Session& session) {
  const Model& m = session.model;
  c2d_status status = C2D_OK;
  for (int b = 0; b < m.head->bodies && status == C2D_OK; ++b) {
    if (!is_rigid(m, b) || m.body[b].contact == 0 || m.body[b].free_motions == 0) continue;
    Real* const rest = rest_of(session, b);
    for_ranges(m, b, [&](const UnknownRange& range) {
      for (int32_t i = 0; i < range.count; ++i) rest[range.own + i] = session.area.u[range.side][range.all + i];
    });
    for (int32_t k = 0; k < m.head->load_cases && status == C2D_OK; ++k) {
      status = read_column(session.tape, b, BodyMatrix::response, k, session.area.column);
      for (int32_t i = 0; i < m.body[b].contact; ++i)
        rest[i] -= static_cast<Real>(session.follower.load[k]) * session.area.column[i];
    }
    double amount[kMostMotions] = {};
    if (status == C2D_OK) status = fit_motions(session, b, amount);
    for (int32_t j = 0; j < m.body[b].free_motions; ++j)
      session.area.motion[m.body[b].first_border + j] = static_cast<Real>(amount[j]);
  }
  return status;
}

c2d_status solve_on_demand(Session& session, int b, const CompressedPlan& plan, const Real* coefficient) {
  const int32_t own = session.model.body[b].contact;
  const c2d_status status = back_substitute_compressed(plan, session.solver->tapes, coefficient + 2 * static_cast<int64_t>(own),
                                                       session.area.outer, session.area.work);
  if (status != C2D_OK) return status;
  const c2d_status added = with_tree(
      session, b, plan, [&](const LaterSides& sides) { return add_tractions(sides, coefficient + own, session.area.outer); });
  return added == C2D_OK && session.model.body[b].free_motions > 0 ? add_motions(session, b, coefficient) : added;
}

namespace {

// Columns that are made together.
struct Lot {
  int32_t count;
  bool counts; // in the books of energies and checks
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
  if (!session.solver->keeps_energy || !lot.counts) return C2D_OK;
  int32_t dof[kMostSides];
  for (int32_t k = 0; k < count; ++k) dof[k] = m.pair[lot.pair[place[k]]].dof + lot.slot[place[k]];
  kEnergyPart.add_demanded(session, b, DemandedColumns{count, dof, side, x});
  return C2D_OK;
}

// What the columns bring to the books, and the motions that go with them: those by which nothing moves in the slots that hold.
c2d_status note_lot(Session& session, const Lot& lot, Real* columns) {
  const Model& m = session.model;
  const int32_t contact = m.head->contact;
  Form form;
  c2d_status status = read_form(session.tape, session.area.column, &form);
  int32_t dof[kMostSides];
  for (int32_t j = 0; j < lot.count; ++j) dof[j] = m.pair[lot.pair[j]].dof + lot.slot[j];
  for (int32_t k = 0; k < form.count && status == C2D_OK; ++k) {
    const Real* motion = nullptr;
    status = view_column(session.tape, ContactMatrix::motion, k, &motion);
    for (int32_t j = 0; j < lot.count && status == C2D_OK; ++j) {
      Real* const column = columns + 2 * static_cast<int64_t>(j) * contact;
      const Real by = column[form.held[k]];
      for (int32_t i = 0; i < contact; ++i) column[contact + i] -= by * motion[i];
    }
  }
  if (status != C2D_OK || !lot.counts) return status;
  for (int32_t j = 0; j < lot.count && session.solver->keeps_energy != 0; ++j)
    kEnergyPart.hold_demanded(session, form, dof[j], columns + 2 * static_cast<int64_t>(j) * contact);
  return note_demanded(session, form, lot.count, dof, columns);
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
  if (status == C2D_OK) status = note_lot(session, lot, columns);
  for (int32_t k = 0; k < lot.count && status == C2D_OK; ++k) {
    const Real* const column = columns + 2 * static_cast<int64_t>(k) * contact;
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

c2d_status make_some(Session& session, const int32_t* pair, int32_t count, bool counts) {
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
  lot.counts = counts;
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

c2d_status make_columns(void* context, const int32_t* pair, int32_t count) {
  return make_some(*static_cast<Session*>(context), pair, count, true);
}

} // namespace c2d
