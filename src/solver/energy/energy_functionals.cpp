// What multiplies tau, w' and lambda in the work and reaction of every load case (solver/energy/energy.hpp).
//
// Phases, for some functionals at once, so that what is read from the tapes serves all of them:
// 1. The loads of each case, body by body, in terms of all unknowns of the body.
// 2. Its outer unknowns out of them, by one pass over its factors (transposed_functionals).
// 3. Displacements of the contact out of them, by the bodies' compliances; at last the motions of the bodies.
#include "bie/body_force.hpp"
#include "bie/columns.hpp"
#include "contact/body_unknowns.hpp"
#include "contact/reduction/orthonormal.hpp"
#include "linalg/dots.hpp"
#include "memory/parts.hpp"
#include "model/free_zones.hpp"
#include "solver/energy/energy_adjoint.hpp"
#include "solver/energy/motion.hpp"

namespace c2d {

C2D_USES(BodyForcePart);
C2D_USES(CompressedPart);
C2D_USES(RigidPart);

namespace {

// Pressures times the overlaps that case k closes.
void add_overlaps(const Model& m, Real* tau) {
  for (int32_t i = 0; i < m.head->pairs; ++i)
    tau[m.pair[i].dof] += static_cast<Real>(m.pair[i].weight * m.pair[i].overlap / m.head->length_unit);
}

// ---- functionals, some at once --------------------------------------------------------------------------------------

struct Functionals {
  Adjoint* a;
  int32_t count;
  FunctionalTiles tiles;
  Adjoint* begin() const { return a; }
  int32_t size() const { return kSmallCode ? 1 : count; }
  Adjoint* end() const { return a + size(); }
};

int64_t most_outer(const PhaseSizes& sizes) {
  int64_t outer = 0;
  for (int b = 0; b < sizes.bodies; ++b)
    if (sizes.of(b).outer > outer) outer = sizes.of(b).outer;
  return outer;
}
int64_t numbers_of_functional(const PhaseSizes& sizes) {
  return 4 * sizes.widest + 2 * sizes.m + most_outer(sizes) + sizes.cases;
}

// With more load cases kernels form the sums. (Few have the digits that they always had.)
constexpr int32_t kManyFunctionals = 32;

int64_t most_tiled(const PhaseSizes& sizes) {
  const int64_t outer = most_outer(sizes);
  return outer > sizes.widest ? outer : sizes.widest;
}

// How many functionals are put together at once, and by what sums. The first has the arrays of the path area, others take
// theirs from `room`, and the tiles theirs behind them. That is the tableau's, which is not built while energies are prepared,
// or the workspace behind the path area. A call from a step's callback may use neither.
struct AtOnce {
  int32_t functionals;
  Real* room;
  FunctionalTiles tiles;
};
AtOnce most_at_once(const Session& session) {
  if (kSmallCode || is_on_demand(session.model)) return {1, nullptr, {}};
  c2d_solver* s = session.solver;
  const PhaseSizes sizes = model_sizes(session.model);
  const int64_t room = sizes.m * (sizes.columns + 1 + sizes.cases), each = numbers_of_functional(sizes);
  const auto needed = [&](int32_t lanes) { return (lanes - 1) * each + functional_tiles(lanes, most_tiled(sizes)); };
  const Kernel* const kernel = kernel_for(s->instructions);
  if (2 * sizes.cases <= kManyFunctionals || !kernel || kernel->cols > kWidestTile || kTiledFunctionals % kernel->rows != 0 ||
      needed(kTiledFunctionals) > room)
    return {static_cast<int32_t>(room / each < kFunctionalsAtOnce ? room / each + 1 : kFunctionalsAtOnce),
            session.area.tableau,
            {}};
  PathArea area;
  const uint64_t used = (open_path_area(s, session.model, s->keeps_flexibility != 0, area) + 63) / 64 * 64;
  Real* const behind = reinterpret_cast<Real*>(array_of<char>(s, kPhase) + used);
  const uint64_t bytes = s->bytes - s->layout.persistent;
  const int64_t left = bytes > used ? static_cast<int64_t>((bytes - used) / sizeof(Real)) : 0;
  int32_t lanes = kFunctionalsAtOnce;
  while (lanes > kTiledFunctionals && needed(lanes) > room && needed(lanes) > left) lanes /= 2;
  Real* const at = needed(lanes) <= room ? session.area.tableau : behind;
  return {lanes, at, {kernel, at + (lanes - 1) * each, lanes}};
}

// Outer unknowns of a body out of the functionals: they follow from -u_c, t_c = +-tau and lambda.
c2d_status solve_outer(const Functionals& all, Session& session, int b) {
  Real *f[kFunctionalsAtOnce], *w[kFunctionalsAtOnce];
  int32_t count = 0;
  for (Adjoint& a : all) {
    if (!a.touched) continue;
    f[count] = a.outer;
    w[count++] = a.coefficient;
  }
  return count == 0 ? c2d_status{C2D_OK} : solve_transposed(session, b, count, f, w, all.tiles);
}

void add_solved(Adjoint& a) {
  const Model& m = a.model();
  const Real* w = a.coefficient;
  const int32_t own = is_on_demand(m) ? 0 : m.body[a.b].contact; // (what tractions bring there comes with their columns)
  for (int32_t j = 0; j < own; ++j) a.u[j] -= w[j];
  for_ranges(m, a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count && own > 0; ++i) a.tau[range.all + i] += signed_on(range.side, w[own + range.own + i]);
  });
  for (int32_t i = 0; i < m.head->load_cases; ++i) a.lambda[i] += static_cast<double>(w[2 * own + i]);
}

// Coefficients of displacements on the sides of the pairs are put together from all bodies.
void add_to_sides(Adjoint& a) {
  for_ranges(a.model(), a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) a.side[range.side][range.all + i] += a.u[range.own + i];
  });
}

// Displacements of a body that keeps its equations out of the functional: those of what it meets, and w'.
void remove_kept(Adjoint& a) {
  for_ranges(a.model(), a.b, [&](const UnknownRange& range) {
    Real *own = a.side[range.side] + range.all, *other = a.side[1 - range.side] + range.all;
    for (int32_t i = 0; i < range.count; ++i) {
      other[i] += own[i];
      a.jump[range.all + i] += signed_on(range.side, own[i]);
    }
  });
}

// The coefficients of a body's displacements; touched: not all are zero.
void gather_displacements(Adjoint& a) {
  a.touched = false;
  for_ranges(a.model(), a.b, [&](const UnknownRange& range) {
    for (int32_t i = 0; i < range.count; ++i) {
      a.u[range.own + i] = a.side[range.side][range.all + i];
      a.touched = a.touched || a.u[range.own + i] != Real(0);
    }
  });
}

void add_to_tractions(Adjoint& a, int32_t i, double sum) { a.tau[i] += static_cast<Real>(sum); }
void add_to_loads(Adjoint& a, int32_t k, double sum) { a.lambda[k] += sum; }

// The functionals of a body's displacements that are not all zero, and their products with columns of `numbers`.
struct Touched {
  int32_t count = 0, numbers;
  Adjoint* a[kFunctionalsAtOnce];
  const Real* u[kFunctionalsAtOnce];
  const FunctionalTiles& tiles;
  double sum[kFunctionalsAtOnce];              // of one column,
  Real tiled[kWidestTile][kFunctionalsAtOnce]; // or of some

  typedef void (*Add)(Adjoint& a, int32_t i, double sum);

  Touched(const Functionals& all, int32_t n) : numbers(n), tiles(all.tiles) {
    for (Adjoint& one : all) {
      if (!one.touched) continue;
      a[count] = &one;
      u[count++] = one.u;
    }
    for (int32_t i = 0; i < numbers && is_tiled(); ++i)
      for (int32_t k = 0; k < tiles.lanes; ++k) tiles.room[entry(i) + k] = k < count ? u[k][i] : Real(0);
  }
  int32_t size() const { return kSmallCode ? 1 : count; } // (of none no products are asked for)
  bool is_tiled() const { return !kSmallCode && tiles.kernel; }
  int64_t entry(int32_t i) const { return static_cast<int64_t>(i) * tiles.lanes; }
  // Adds the products with columns first ... first + columns - 1 of a body's matrix to numbers `to` ... of each functional.
  c2d_status add_sums(Session& session, int b, BodyMatrix matrix, int32_t first, int32_t columns, Add add, int32_t to,
                      int side) {
    Real* const column = session.area.column;
    const int32_t width = is_tiled() ? tiles.kernel->cols : 1;
    for (int32_t j = 0, some; j < columns; j += some) {
      some = columns - j < width ? columns - j : width;
      for (int32_t c = 0; c < some; ++c) {
        if (const c2d_status status = read_column(session.tape, b, matrix, first + j + c, column); status != C2D_OK)
          return status;
        if (is_tiled())
          pack(column, c);
        else
          dots(numbers, column, size(), u, sum);
      }
      if (is_tiled()) form_tiles();
      for (int32_t c = 0; c < some; ++c)
        for (int32_t k = 0; k < size(); ++k)
          add(*a[k], to + j + c, signed_on(side, is_tiled() ? static_cast<double>(-tiled[c][k]) : sum[k]));
    }
    return C2D_OK;
  }

private:
  Real* packed() const { return tiles.room + entry(numbers); }
  void pack(const Real* column, int32_t c) const {
    for (int32_t i = 0; i < numbers; ++i) packed()[int64_t{i} * tiles.kernel->cols + c] = column[i];
  }
  void form_tiles() {
    for (Real* const row : tiled)
      for (int32_t k = 0; k < kFunctionalsAtOnce; ++k) row[k] = 0;
    for (int32_t k = 0; k < count; k += tiles.kernel->rows)
      tiles.kernel->tile(numbers, tiles.room + k, tiles.lanes, packed(), tiled[0] + k, kFunctionalsAtOnce);
  }
};

// tau out of the contact displacements u = F t + ..., t = -tau on the body's sides 0, +tau on its sides 1.
c2d_status add_compliance(const Functionals& all, Session& session, int b) {
  Touched touched(all, session.model.body[b].contact);
  c2d_status status = C2D_OK;
  for_ranges(session.model, b, [&](const UnknownRange& range) {
    if (status == C2D_OK)
      status = touched.add_sums(session, b, BodyMatrix::flexibility, range.own, range.count, add_to_tractions, range.all,
                                range.side);
  });
  return status;
}

// Of a functional of motions: what the overlaps make of it that a load case closes.
double overlap_part(const Model& m, const Real* motions) {
  double sum = 0.0;
  for (int32_t i = 0; i < m.head->pairs; ++i)
    sum += static_cast<double>(motions[m.pair[i].dof]) * m.pair[i].overlap / m.head->length_unit;
  return sum;
}

// So much of a row of X (w' - overlaps closed).
void add_motion_row(Adjoint& a, Real part, const Real* row) {
  const ModelHeader& head = *a.model().head;
  for (int32_t i = 0; i < head.contact; ++i) a.jump[i] += part * row[i];
  if (head.interference != 0) a.lambda[head.interference - 1] -= static_cast<double>(part) * overlap_part(a.model(), row);
}

// Where displacements are unknowns X w' stands in the place of F t.
c2d_status add_unknowns(const Functionals& all, Session& session, int b) {
  Real* column = session.area.column;
  for (int32_t i = 0; i < session.model.body[b].contact; ++i) {
    bool needed = false;
    for (const Adjoint& a : all) needed = needed || (a.touched && a.u[i] != Real(0));
    if (!needed) continue;
    const c2d_status status = read_column(session.tape, b, BodyMatrix::flexibility, i, column);
    if (status != C2D_OK) return status;
    for (Adjoint& a : all)
      if (a.touched && a.u[i] != Real(0)) add_motion_row(a, a.u[i], column);
  }
  return C2D_OK;
}

// Those of another body: u = F t + sum lambda_k v_k + R x.
c2d_status remove_displacements(const Functionals& all, Session& session, int b) {
  const Model& m = session.model;
  const Body& body = m.body[b];
  bool any = false;
  for (Adjoint& a : all) {
    a.b = b;
    gather_displacements(a);
    any = any || a.touched;
  }
  if (!any) return C2D_OK;
  Real* column = session.area.column;
  c2d_status status = is_rigid(m, b)            ? c2d_status{C2D_OK}
                      : has_displacements(m, b) ? add_unknowns(all, session, b)
                                                : add_compliance(all, session, b);
  if (status == C2D_OK) {
    status = Touched(all, body.contact).add_sums(session, b, BodyMatrix::response, 0, m.head->load_cases, add_to_loads, 0, 1);
  }
  for (int32_t j = 0; j < body.free_motions && status == C2D_OK; ++j) {
    status = read_column(session.tape, b, BodyMatrix::motions, j, column);
    for (Adjoint& a : all)
      if (a.touched && status == C2D_OK)
        a.motion[body.first_border + j] += static_cast<Real>(product(column, a.u, body.contact));
  }
  return status;
}

// Force and moment on a rigid body times its motion.
c2d_status add_given(Adjoint& a, int32_t k) {
  const Body& body = a.model().body[a.b];
  Real g[kMostMotions];
  if (body.free_motions == 0) return C2D_OK;
  const c2d_status status = read_column(a.session->tape, a.b, BodyMatrix::given, k, g);
  for (int32_t j = 0; j < body.free_motions && status == C2D_OK; ++j) a.motion[body.first_border + j] += g[j];
  return status;
}

// What the cases of some functionals do on a body with its boundary, point loads and body force.
void add_loads(Adjoint* a, int32_t count) {
  const Model& m = a->model();
  for (int32_t i = 0; i < count; ++i) {
    Adjoint& one = a[i];
    one.touched = false;
    for (int32_t j = 0; j < m.body[one.b].contact; ++j) one.u[j] = 0;
    for (int32_t j = 0; j < outer_columns(m, one.b); ++j) one.outer[j] = 0;
    add_boundary(one, one.number / 2, one.number % 2 == 1);
  }
  add_point_loads(a, count);
  for (int32_t i = 0; i < count; ++i)
    if (a[i].number % 2 == 0 && has_body_force(m, a[i].b)) kBodyForcePart.add_body_force(a[i], a[i].number / 2);
}

// What force, moment and motion of a rigid body do.
c2d_status add_rigid(Adjoint& a) {
  const Model& m = a.model();
  const int32_t k = a.number / 2;
  a.touched = false;
  if (a.number % 2 == 0) return m.body[a.b].contact > 0 ? add_given(a, k) : c2d_status{C2D_OK};
  kRigidPart.add_rigid_motion(m, a.b, k, a.tau);
  return C2D_OK;
}

// What functionals have of the body.
c2d_status add_body(const Functionals& all, int b) {
  const Model& m = all.a->model();
  c2d_status status = C2D_OK;
  if (!is_rigid(m, b)) add_loads(all.a, all.size());
  for (Adjoint& a : all) {
    if (status == C2D_OK && is_rigid(m, b)) status = add_rigid(a);
    if (status == C2D_OK && is_on_demand(m) && a.touched)
      status = kCompressedPart.functional_of_motions(*a.session, b, a.outer, a.motion);
  }
  return status;
}

Real* room_of_cases(const Session& session, int b) { return session.area.traction + 2 * session.model.body[b].first_end; }

// Of a body with point loads. Null: nobody looks there.
const Real* cases_of(const Session& session, int b) {
  const Model& m = session.model;
  bool loaded = false;
  for (int32_t i = 0; i < m.head->point_loads; ++i) loaded = loaded || m.point_load[i].body == b;
  return kSmallCode || !loaded || is_on_demand(m) || m.head->load_cases < 3 ? nullptr : room_of_cases(session, b);
}

// 1: load case k prescribes tractions on the body; 2: displacements.
int32_t prescribed_kinds(const Model& m, int b, int32_t k) {
  return (prescribes(m, b, k, false) ? 1 : 0) + (prescribes(m, b, k, true) ? 2 : 0);
}

// For each element the first case after case 0 that prescribes something there, and the last one plus 1: of loads that move
// over a body these are few. They lie among the results, which nothing needs yet.
void find_cases(const Session& session, int b) {
  const Model& m = session.model;
  Real* const cases = room_of_cases(session, b);
  for (int32_t i = 0; i < 2 * m.body[b].elements; ++i) cases[i] = 0;
  for (int32_t k = 1; k < m.head->load_cases; ++k)
    for (int32_t element = 0, kinds = prescribed_kinds(m, b, k); element < m.body[b].elements && kinds != 0; ++element) {
      const bool given =
          ((kinds & 1) != 0 && prescribes(m, b, element, k, false)) || ((kinds & 2) != 0 && prescribes(m, b, element, k, true));
      if (!given) continue;
      Real* const span = cases + 2 * element;
      if (span[1] == Real(0)) span[0] = static_cast<Real>(k);
      span[1] = static_cast<Real>(k + 1);
    }
}

c2d_status add_bodies(const Functionals& all, Session& session) {
  for (int b = 0; b < session.model.head->bodies; ++b) {
    for (Adjoint& a : all) {
      a.b = b;
      a.cases = cases_of(session, b);
    }
    c2d_status status = add_body(all, b);
    if (status == C2D_OK) status = solve_outer(all, session, b);
    if (status != C2D_OK) return status;
    for (Adjoint& a : all) {
      if (is_rigid(session.model, b)) continue;
      if (a.touched) add_solved(a);
      add_to_sides(a);
    }
  }
  return C2D_OK;
}

// Motions of the bodies out of the functionals: x = X (w' - overlaps closed) + sum lambda_k x_k.
c2d_status remove_motions(const Functionals& all, Session& session) {
  const ModelHeader& head = *session.model.head;
  if (is_on_demand(session.model)) // (one at once)
    return kCompressedPart.hold_functional(session, all.a[0].motion, all.a[0].jump, all.a[0].lambda);
  Real* column = session.area.column;
  for (Adjoint& a : all) a.touched = false;
  bool any = false;
  for (int32_t j = 0; j < head.border; ++j) {
    bool needed = false;
    for (const Adjoint& a : all) needed = needed || a.motion[j] != Real(0);
    if (!needed) continue;
    any = true;
    const c2d_status status = read_column(session.tape, ContactMatrix::motion, j, column);
    if (status != C2D_OK) return status;
    for (Adjoint& a : all) {
      if (a.motion[j] == Real(0)) continue;
      a.touched = true;
      add_motion_row(a, a.motion[j], column);
    }
  }
  for (int32_t k = 0; k < head.load_cases && any; ++k) {
    const c2d_status status = read_column(session.tape, ContactMatrix::motion_load, k, column);
    if (status != C2D_OK) return status;
    for (Adjoint& a : all)
      if (a.touched) a.lambda[k] += product(column, a.motion, head.border);
  }
  return C2D_OK;
}

// The arrays that a functional is put together in.
void place_arrays(Session& session, Real* room, int32_t number, Adjoint& a) {
  const PathArea& area = session.area;
  a.session = &session;
  if (number == 0) {
    a.motion = area.motion;
    a.u = area.own;
    a.outer = area.outer;
    a.coefficient = area.coefficient;
    for (int side = 0; side < 2; ++side) a.side[side] = area.u[side];
    return;
  }
  const PhaseSizes sizes = model_sizes(session.model);
  a.motion = room + (number - 1) * numbers_of_functional(sizes);
  a.u = a.motion + sizes.widest;
  a.outer = a.u + sizes.widest;
  a.coefficient = a.outer + most_outer(sizes);
  a.side[0] = a.coefficient + 2 * sizes.widest + sizes.cases;
  a.side[1] = a.side[0] + sizes.m;
}

// Nothing of this kind is prescribed on any body: the functional is zero. (Most load cases prescribe no displacements.)
bool is_zero(const Model& m, int32_t number) {
  const int32_t k = number / 2;
  const bool reactions = number % 2 == 1;
  bool zero = !reactions || k + 1 != m.head->interference;
  for (int b = 0; b < m.head->bodies && zero; ++b)
    zero = !is_rigid(m, b) && (reactions || !has_body_force(m, b)) && !prescribes(m, b, k, reactions);
  for (int32_t i = 0; i < m.head->point_loads && zero && !reactions; ++i) zero = m.point_load[i].load_case != k;
  return zero;
}

// Functionals *next ... of the books, as many as fit, without those that are zero; how many. *next: the one after them.
int32_t open_functionals(Session& session, const EnergyBook& book, const AtOnce& at_once, int32_t* next, Adjoint* a) {
  const ModelHeader& head = *session.model.head;
  int32_t count = 0;
  for (; count < at_once.functionals && *next < 2 * book.cases; ++*next) {
    Adjoint& one = a[count];
    place_arrays(session, at_once.room, count, one);
    const int64_t number = *next;
    one.number = *next;
    one.tau = book.of_contact + 2 * number * book.m;
    one.jump = one.tau + book.m;
    one.lambda = book.of_loads + number * book.cases;
    for (int32_t i = 0; i < 2 * head.contact; ++i) one.tau[i] = 0;
    for (int32_t i = 0; i < head.load_cases; ++i) one.lambda[i] = 0.0;
    if (!kSmallCode && is_zero(session.model, one.number)) continue;
    ++count;
    for (int32_t i = 0; i < (is_on_demand(session.model) ? head.motions : head.border); ++i) one.motion[i] = 0;
    for (Real* u : one.side)
      for (int32_t i = 0; i < head.contact; ++i) u[i] = 0;
    if (number % 2 == 1 && number / 2 + 1 == head.interference) add_overlaps(session.model, one.tau);
  }
  return count;
}

c2d_status build_functionals(const Functionals& all, Session& session) {
  const ModelHeader& head = *session.model.head;
  c2d_status status = add_bodies(all, session);
  for (int b = 0; b < head.bodies && status == C2D_OK; ++b) {
    if (!keeps_equations(session.model, b)) continue;
    for (Adjoint& a : all) {
      a.b = b;
      remove_kept(a);
    }
  }
  for (int b = 0; b < head.bodies && status == C2D_OK; ++b)
    if (session.model.body[b].contact > 0 && !keeps_equations(session.model, b)) status = remove_displacements(all, session, b);
  return status == C2D_OK ? remove_motions(all, session) : status;
}

} // namespace

void add_demanded(Session& session, int b, const DemandedColumns& columns) {
  if (kSmallCode) return;
  const EnergyBook book = energy_book(session.solver);
  const PathArea& area = session.area;
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    // What the loads do without the solution has been counted: that goes where it is of no use.
    Adjoint a{&session,         b,  area.u[0], area.u[1], book.r, area.motion, area.own, area.outer,
              area.coefficient, {}, false,     k,         nullptr};
    add_loads(&a, 1);
    Real* const of_tau = book.of_contact + 2 * static_cast<int64_t>(k) * book.m;
    const int32_t unknowns = outer_columns(session.model, b);
    for (int32_t j = 0; j < columns.count && a.touched; ++j) {
      double sum = 0.0;
      for (int32_t i = 0; i < unknowns; ++i)
        if (a.outer[i] != 0)
          sum += static_cast<double>(a.outer[i]) * static_cast<double>(columns.x[static_cast<int64_t>(i) * columns.count + j]);
      of_tau[columns.dof[j]] += static_cast<Real>(signed_on(columns.side[j], sum));
    }
  }
}

void hold_demanded(Session& session, const Form& form, int32_t dof, const Real* column) {
  if (kSmallCode) return;
  const EnergyBook book = energy_book(session.solver);
  for (int32_t k = 0; k < 2 * book.cases; ++k) {
    Real *const of_tau = book.of_contact + 2 * static_cast<int64_t>(k) * book.m, *const of_jump = of_tau + book.m;
    for (int32_t i = 0; i < form.count; ++i) of_tau[dof] -= column[form.held[i]] * of_jump[form.held[i]];
  }
}

c2d_status build_energy(c2d_solver* s) {
  Session session;
  open_session(s, session);
  const EnergyBook book = energy_book(s);
  for (int b = 0; b < s->model.bodies; ++b)
    if (cases_of(session, b)) find_cases(session, b);
  const AtOnce at_once = most_at_once(session);
  for (int32_t next = 0; next < 2 * book.cases;) {
    tell_progress(s, C2D_PHASE_REDUCE, 0, next, 2 * static_cast<int64_t>(book.cases));
    if ((kSmallCode || s->state == C2D_STATE_MODEL) && asked_to_stop(s)) return C2D_ERR_CANCELLED; // (allow_friction)
    Adjoint a[kFunctionalsAtOnce];
    const Functionals all = {a, open_functionals(session, book, at_once, &next, a), at_once.tiles};
    const c2d_status status = all.count > 0 ? build_functionals(all, session) : c2d_status{C2D_OK};
    if (status != C2D_OK) return status;
  }
  return C2D_OK;
}

} // namespace c2d
