#include "solver/demand/compressed.hpp"

#include "bie/integrals/batch.hpp"
#include "bie/panel.hpp"
#include "contact/body_unknowns.hpp"
#include "memory/hostile.hpp"
#include "memory/math.hpp"
#include "model/validate/validate_finding.hpp"
#include "solver/demand/far_cells.hpp"
#include "solver/demand/on_demand.hpp"
#include "solver/judge.hpp"
#include "solver/session.hpp"

namespace c2d {

namespace {

constexpr int32_t kLeastRank = 2 * kLeafNodes, kMostRank = 1024;
constexpr int32_t kUsualRank = 256; // the largest measured were below
constexpr double kErrorLimit = sizeof(Real) == sizeof(double) ? 1e-9 : 1e-3;

// May there be models whose contact is on demand?
bool demands(const PhaseSizes& most) { return most.columns < most.m; }

// Of any body within the limits; with `keeps`: of one whose contact is on demand.
CompressedPlan most_of(const PhaseSizes& most, int b, int32_t rank, int32_t keeps) {
  const BodyPhase body = most.of(b);
  const int64_t pairs = most.limits->pairs < most.columns ? most.limits->pairs : most.columns;
  const int64_t touching = keeps != 0 ? 0 : (body.nodes < pairs ? body.nodes : pairs);
  return plan_compressed(CompressedLimits{static_cast<int32_t>(body.nodes), static_cast<int32_t>(touching),
                                          static_cast<int32_t>(keeps != 0 ? most.m : body.contact),
                                          static_cast<int32_t>(most.cases),
                                          most_holes(static_cast<int32_t>(sizes_of_body(*most.limits, b).regions)), keeps},
                         rank, kLeafNodes);
}

uint64_t larger(uint64_t a, uint64_t b) { return a > b ? a : b; }

uint64_t back_bytes_of(const CompressedPlan& plan, int32_t elements) {
  const uint64_t check = round_up(kAssemblyBytes) + compressed_check_bytes(plan);
  return larger(larger(compressed_back_bytes(plan), check), far_cells_bytes(elements));
}

// What elimination_area holds beside the work of the elimination.
uint64_t beside_work(const PhaseSizes& s, int b) {
  return elimination_area(s, b, EliminationPlan{}, nullptr, nullptr) - elimination_bytes(EliminationPlan{});
}

// Bytes of the phase area for cells of this rank.
uint64_t compression_need(const PhaseSizes& most, int32_t rank) {
  uint64_t need = reduction_area(most, nullptr, nullptr);
  BackNeed back = {0, 0, 0};
  for (int b = 0; b < most.bodies; ++b) {
    if (most.of(b).rows == 0) continue;
    for (int32_t keeps = 0; keeps <= (demands(most) ? 1 : 0); ++keeps) {
      const CompressedPlan plan = most_of(most, b, rank, keeps);
      need = larger(need, beside_work(most, b) + compressed_bytes(plan));
      back.work = larger(back.work, back_bytes_of(plan, static_cast<int32_t>(sizes_of_body(*most.limits, b).elements)));
      if (keeps != 0) back.later = larger(back.later, later_bytes(plan, most.m));
    }
    back.outer = larger(back.outer, static_cast<uint64_t>(most.of(b).outer));
  }
  return larger(need, path_area(most, back, false, nullptr, nullptr));
}

// The largest rank for which there is room; 0: for none.
int32_t rank_within(const PhaseSizes& most, uint64_t bytes) {
  int32_t rank = kMostRank;
  while (rank >= kLeastRank && compression_need(most, rank) > bytes) rank -= 8;
  return rank >= kLeastRank ? rank : 0;
}

// Of a body within the limits, its border cut for these bytes of the phase area.
CompressedPlan cut_most(const PhaseSizes& most, uint64_t bytes, int b, int32_t rank, int32_t keeps) {
  CompressedPlan plan = most_of(most, b, rank, keeps);
  const c2d_status status = cut_border(bytes - beside_work(most, b), plan, nullptr);
  C2D_ASSERT(status == C2D_OK);
  static_cast<void>(status);
  return plan;
}

} // namespace

uint64_t compression_that_will_do(const PhaseSizes& most, int32_t rank) {
  return compression_need(most, static_cast<int32_t>(larger(static_cast<uint64_t>(rank), kUsualRank)));
}

c2d_status plan_compression(const PhaseSizes& most, uint64_t bytes, const Model& m, EliminationPlan* out) {
  const int32_t rank = rank_within(most, bytes);
  if (rank == 0) return C2D_ERR_MEMORY;
  for (int b = 0; b < m.head->bodies; ++b) {
    if (!may_compress(m, b)) continue;
    out[b] = plan_compressed(m, b, rank, kLeafNodes).border;
    cut_alike(cut_most(most, bytes, b, rank, m.body[b].on_demand).border, out[b]);
  }
  return C2D_OK;
}

c2d_status compression_tape(const PhaseSizes& most, uint64_t bytes, bool upper, TapeUse& out) {
  const int32_t rank = rank_within(most, bytes);
  out = TapeUse{0, 0, 0, 0};
  if (rank == 0) return C2D_ERR_MEMORY;
  for (int b = 0; b < most.bodies; ++b) {
    if (most.of(b).rows == 0) continue;
    uint64_t blocks = 0;
    for (int32_t keeps = 0; keeps <= (demands(most) ? 1 : 0); ++keeps) {
      const CompressedPlan plan = cut_most(most, bytes, b, rank, keeps);
      const TapeUse use = upper ? compressed_upper_use(plan) : compressed_lower_use(plan);
      blocks = larger(blocks, use.blocks);
      out.max_data_bytes = larger(out.max_data_bytes, use.max_data_bytes);
    }
    out.blocks += blocks;
  }
  return C2D_OK;
}

bool is_compression_of(const Model& m, int b, const EliminationPlan& border) { return is_border(m, b, border); }

uint64_t compression_bytes(const Model& m, int b, const EliminationPlan& border) {
  return compressed_bytes(plan_around(m, b, border));
}

CompressedPlan compression_of(const Model& m, int b, const EliminationPlan& border) { return plan_around(m, b, border); }

uint64_t later_bytes(const Model& m, int b, const EliminationPlan& border) {
  return later_bytes(plan_around(m, b, border), m.head->contact);
}

uint64_t compression_back_bytes(const Model& m, int b, const EliminationPlan& border) {
  return back_bytes_of(plan_around(m, b, border), m.body[b].elements);
}

void compression_uses(const Model& m, int b, const EliminationPlan& border, TapeUse& lower, TapeUse& upper) {
  const CompressedPlan plan = plan_around(m, b, border);
  lower = compressed_lower_use(plan);
  upper = compressed_upper_use(plan);
}

c2d_status compress(const EliminationPlan& border, const ColumnSystem& system, const RowSink& sink, Tapes& tapes, void* work,
                    PivotStats* stats, int32_t* rank, const Watch& watch, const Engine& engine) {
  const CompressedPlan plan = plan_around(system.model, system.body, border);
  CompressedStats found;
  const c2d_status status = eliminate_compressed(plan, system, sink, tapes, work, stats, &found, watch, engine);
  // How much more than is allowed nobody has found out.
  if (status == C2D_ERR_MEMORY) *rank = 2 * found.largest_rank;
  return status;
}

namespace {

// visit(kind, value) for what the unknowns x of a body say of its nodes, component by component.
template <class Visit> void visit_unknowns(const Model& m, int b, const Real* x, Visit visit) {
  for (int32_t node = 0; node < m.body[b].nodes; ++node) {
    Unknown unknown[2];
    unknowns_at(m, b, node, unknown);
    for (int c = 0; c < 2; ++c)
      if (unknown[c].kind != UnknownKind::contact && unknown[c].kind != UnknownKind::none)
        visit(unknown[c].kind, static_cast<double>(x[outer_column(m, b, node, c)]));
  }
}

// Sum over the displacements among them.
double squares_of_displacements(const Model& m, int b, const Real* x) {
  double sum = 0.0;
  visit_unknowns(m, b, x, [&](UnknownKind kind, double u) { sum += kind == UnknownKind::displacement ? u * u : 0.0; });
  return sum;
}

// The largest traction among them, of supports, stress unit.
double largest_reaction(const Model& m, int b, const Real* x) {
  double most = 0.0;
  visit_unknowns(m, b, x, [&](UnknownKind kind, double t) {
    if (kind != UnknownKind::displacement) most = fmax(most, fabs(t));
  });
  return most * 2.0 * shear_modulus(m, b) / m.head->stress_unit;
}

// The largest that is given, and of the contact.
double largest_given(const Session& session, int b) {
  const Model& m = session.model;
  double most = 0.0;
  for (int32_t end = 0; end < m.body[b].elements * m.head->function_nodes; ++end)
    for (int c = 0; c < 2; ++c) {
      double t = 0.0;
      for (int32_t k = 0; k < m.head->load_cases; ++k) t += session.follower.load[k] * given_traction(m, b, end, c, k);
      most = fmax(most, fabs(t));
    }
  return most / m.head->stress_unit;
}
double largest_in_contact(const Session& session) {
  double most = 0.0;
  for (int32_t i = 0; i < session.model.head->pairs; ++i) {
    const PairState now = pair_state(*session.follower.t, i, session.follower.y);
    most = fmax(most, fmax(fabs(now.p), fabs(now.q)));
  }
  return most;
}

// The largest stiffness of a body's pairs against motions that they resist, each by itself while others rest.
c2d_status stiffest_pair(const Session& session, int b, double* most) {
  const Model& m = session.model;
  *most = 0.0;
  for (PairSide at = first_pair_side(); next_pair_of(m, b, at);) {
    const Pair& pair = m.pair[at.pair];
    const bool tied = is_tied(m, pair);
    const int slots = tied || pair.status == C2D_STICK ? 1 + pair.tangential : (pair.status == C2D_OPEN ? 0 : 1);
    for (int slot = 0; slot < slots; ++slot) {
      Real own = pair.stiffness[slot];
      if (tied) { // the tableau has no column of it
        const c2d_status status = read_column(session.tape, ContactMatrix::stiffness, pair.dof + slot, session.area.column);
        if (status != C2D_OK) return status;
        own = session.area.column[pair.dof + slot];
      }
      *most = fmax(*most, fabs(static_cast<double>(own)));
    }
  }
  return C2D_OK;
}

// What noise of 1 in a body's equations, in the mean square, makes of its displacements, all together, and of tractions of its
// supports; of tractions of its contact.
struct Growth {
  double displacements, reactions, contact;
};
constexpr double kOfMean = 12.0; // (METHOD 7.6)

void warn_of_error(c2d_solver* s, const Model& m, int b, bool tractions) {
  Finding out(C2D_WARN_COMPRESSED, in_body(b));
  put_all(out.text, "body ", body_named(m, b), ": by what is left of its equations the compressed elimination may be wrong by ",
          s->compression_error, tractions ? " of the tractions" : " of the displacements", ", above ", kErrorLimit,
          "; the dense one would tell");
  report_fault(s, out.entry);
}

double over(double part, double all) { return all > 0.0 ? part / all : 0.0; }

// How far off is area.outer? One step of refinement would change it by what the inverse makes of the remainder.
c2d_status note_remainder(Session& session, int b, const Growth& growth) {
  c2d_solver* s = session.solver;
  const Model& m = session.model;
  const PathArea& area = session.area;
  char* work = static_cast<char*>(area.work);
  const Quadrature quadrature = s->options.quadrature == C2D_QUADRATURE_THESIS ? Quadrature::thesis : Quadrature::accurate;
  const ColumnSystem system{
      m, b, quadrature, nullptr, nullptr, nullptr, reinterpret_cast<AssemblyScratch*>(work), batch_for(s->instructions)};
  Remainder left;
  const c2d_status status = check_compressed(plan_around(m, b, plan_of(s, b)), system, s->tapes, area.coefficient, area.outer,
                                             work + round_up(kAssemblyBytes), &left);
  if (status != C2D_OK) return status;
  const double largest = fmax(largest_reaction(m, b, area.outer), fmax(largest_given(session, b), largest_in_contact(session)));
  const double of_displacements = over(left.mean * growth.displacements, sqrt(squares_of_displacements(m, b, area.outer)));
  const double of_tractions = over(left.mean * fmax(growth.reactions, kOfMean * growth.contact), largest);
  const double error = fmax(of_displacements, of_tractions), before = s->compression_error;
  s->compression_residual = fmax(s->compression_residual, left.relative);
  s->compression_error = fmax(before, error);
  if (before <= kErrorLimit && error > kErrorLimit) warn_of_error(s, m, b, of_tractions > of_displacements);
  return C2D_OK;
}

} // namespace

c2d_status compression_growth(Session& session, int b, double* growth) {
  c2d_solver* s = session.solver;
  const c2d_status status =
      substitute_noise(plan_around(session.model, b, plan_of(s, b)), s->tapes, session.area.outer, session.area.work);
  if (status == C2D_OK) *growth = sqrt(squares_of_displacements(session.model, b, session.area.outer));
  return status;
}

c2d_status solve_compressed(Session& session, int b) {
  c2d_solver* s = session.solver;
  const PathArea& area = session.area;
  Growth growth = {0.0, 0.0, 0.0};
  c2d_status status = compression_growth(session, b, &growth.displacements);
  if (status == C2D_OK) growth.reactions = largest_reaction(session.model, b, area.outer);
  if (status == C2D_OK) status = stiffest_pair(session, b, &growth.contact);
  const CompressedPlan plan = plan_around(session.model, b, plan_of(s, b));
  if (status == C2D_OK && plan.keeps != 0)
    status = solve_on_demand(session, b, plan, area.coefficient);
  else if (status == C2D_OK)
    status = back_substitute_compressed(plan, s->tapes, area.coefficient, area.outer, area.work);
  return status == C2D_OK ? note_remainder(session, b, growth) : status;
}

c2d_status compression_functional(Session& session, int b, Real* f, Real* w) {
  c2d_solver* s = session.solver;
  return compressed_functional(plan_around(session.model, b, plan_of(s, b)), s->tapes, f, w, session.area.work);
}

} // namespace c2d
