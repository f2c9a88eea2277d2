// Cells by following a piecewise linear path (Lemke's method): the rates under an artificial load z c along which z goes up
// and down until it is zero. c is such that the cells from which the path starts are right for every large z. Where few pairs
// are in doubt each stretch is one bordered system, solved anew: nothing gathers round-off, and the system of a stretch's
// cells alone may be singular. Where many are, the tableau itself goes along, one exchange a stretch, with c in place of its
// constants.

#include "contact/rates/rate_cells.hpp"
#include "memory/math.hpp"

namespace c2d {

namespace {

constexpr int kDraws = 200;

// Operations of all attempts: some seconds, or some paths through a large tableau, each of which takes about 3 m^3.
double most_work(const RateProblem& r) {
  const double m = r.t->m;
  return r.on_tableau ? 2e9 + 20 * m * m * m : 2e9;
}

struct Ticks { // asked now and then; what is not C2D_OK ends the search
  c2d_status (*tick)(void*);
  void* context;
  c2d_status* status;
  bool end() const { return (*status = tick(context)) != C2D_OK; }
};

// Always the same draws.
struct Draw {
  uint32_t state;
  double next() { // in [0, 1)
    state = state * 1664525u + 1013904223u;
    return (state >> 8) * (1.0 / 16777216.0);
  }
};

Real& at(RateProblem& r, int32_t i, int32_t j) { return r.matrix[static_cast<int64_t>(j) * (r.size + 1) + i]; }

// Unlike numbers near one, so that no two conditions are met at once.
double plain_weight(int32_t i) {
  const double turned = 0.6180339887498949 * (i + 1);
  return 1.0 + 0.25 * (turned - floor(turned));
}

double weight_of(const Doubt& d, Draw* draw) {
  return draw ? exp((2.0 * draw->next() - 1.0) * 2.302585092994046) : plain_weight(d.pair);
}

// Rates well inside the cell of a pair.
void inside(const Doubt& d, double weight, double out[2]) {
  out[0] = out[1] = 0.0;
  if (d.kind != DoubtKind::cone) out[0] = weight;
  if (d.cell == Cell::slip_plus || d.cell == Cell::slip_minus)
    out[1] = d.kind == DoubtKind::normal ? 0.0 : (d.cell == Cell::slip_plus ? -weight : weight);
  else if (d.kind == DoubtKind::cone)
    out[1] = -d.sign * weight;
}

struct Meeting { // of a condition's bound: where along a stretch
  double where;
  int32_t doubt, which;
};

// How far a stretch goes: point + where * tangent, to the first bound, or to z = 0 (doubt -1). where < 0: without end.
Meeting end_of_stretch(const RateProblem& r, const Real* point, const Real* tangent) {
  Meeting end{-1.0, -1, 0};
  const double z = point[r.size], falls = -static_cast<double>(tangent[r.size]);
  if (falls > 0.0) end.where = z > 0.0 ? z / falls : 0.0;
  for (int32_t i = 0; i < r.count; ++i) {
    Condition condition[2];
    const int count = cell_conditions(r, r.doubt[i], r.doubt[i].cell, condition);
    for (int k = 0; k < count; ++k) {
      const double rate = value_of(condition[k].row, r.doubt[i], tangent);
      if (!(rate < 0.0)) continue;
      const double now = fmax(0.0, value_of(condition[k].row, r.doubt[i], point));
      if (end.where < 0.0 || now < -rate * end.where) end = Meeting{now / -rate, i, k};
    }
  }
  return end;
}

// ---- on the tableau -----------------------------------------------------------------------------------------------

double row_scale(const Tableau& t, const Doubt& d, int slot) {
  const Pair& pair = t.pair[d.pair];
  return pair.status == C2D_STICK || (pair.status == C2D_SLIP && slot == 0) ? pair.stiffness[0] : 1.0;
}

bool exchange_to_cell(RateProblem& r, const Doubt& d) {
  r.work += 2.0 * r.t->m * r.t->m;
  return change_status(*r.t, d.pair, cell_status(d, d.cell), cell_sign(d, d.cell), 0.0);
}

// A number of the tableau's rows of the pairs in doubt, as the unknowns of their cells.
void read_rows(const RateProblem& r, const Real* rows, Real* out) {
  for (int32_t i = 0; i < r.count; ++i)
    for (int s = 0; s < r.doubt[i].slots; ++s)
      out[r.doubt[i].row + s] = static_cast<Real>(rows[r.doubt[i].dof + s] / row_scale(*r.t, r.doubt[i], s));
}

// The tableau with the present cells as statuses, and c among its constants.
bool start_on_tableau(RateProblem& r, Draw* draw) {
  Tableau& t = *r.t;
  for (int32_t i = 0; i < r.count; ++i)
    if (!exchange_to_cell(r, r.doubt[i])) return false;
  for (int32_t i = 0; i < t.m; ++i) constants(t)[i] = 0;
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    double rate[2];
    inside(d, weight_of(d, draw), rate);
    for (int s = 0; s < d.slots; ++s) constants(t)[d.dof + s] = static_cast<Real>(rate[s] * row_scale(t, d, s));
  }
  return true;
}

// r.rhs: the rates without c, r.point: what c adds.
void read_rates(RateProblem& r) {
  combine(*r.t, r.direction, false, r.rates);
  read_rows(r, r.rates, r.rhs);
  read_rows(r, constants(*r.t), r.point);
}

// The stretch beyond a bound: from z on, up or down as `entering` grows.
void begin_stretch(RateProblem& r, const Doubt& d, const double entering[2], double z) {
  read_rates(r);
  const double grows = value_of(entering, d, r.point);
  for (int32_t i = 0; i < r.size; ++i) {
    r.rhs[i] += static_cast<Real>(z) * r.point[i];
    if (grows < 0.0) r.point[i] = -r.point[i];
  }
  r.rhs[r.size] = static_cast<Real>(z);
  r.point[r.size] = grows < 0.0 ? Real(-1) : Real(1);
}

// What grows of the tableau's z of a pair as it enters its cell from the status it has there. False: both numbers, at once.
bool entering_numbers(const RateProblem& r, const Doubt& d, double z[2]) {
  const Pair& pair = r.t->pair[d.pair];
  const int32_t sign = cell_sign(d, d.cell);
  if (d.kind == DoubtKind::adhesive && d.slots == 2) return false;
  const bool across = pair.status == C2D_OPEN || d.cell == Cell::open;
  z[0] = across ? 1.0 : 0.0;
  z[1] = across ? sign * cell_friction(r, d) : -(pair.status == C2D_SLIP ? pair.sign : sign);
  return true;
}

// r.rhs and r.point of a pair, the rates and what they grow by with its z, in the unknowns of its cell instead of its status.
void read_in_cell(RateProblem& r, const Doubt& d, const double z[2]) {
  const Pair& pair = r.t->pair[d.pair];
  const double k = pair.stiffness[0];
  for (int of = 0; of < 2; ++of) {
    Real* const u = of == 0 ? r.rhs : r.point;
    const bool grows = of == 1;
    double w[2] = {grows ? z[0] : 0.0, grows ? z[1] : 0.0}, p[2] = {w[0] / k, w[1] / k}; // what the status holds at zero
    for (int s = 0; s < d.slots; ++s)
      (pair.status == C2D_OPEN || (pair.status == C2D_SLIP && s == 1) ? w : p)[s] = u[d.row + s];
    if (pair.status == C2D_SLIP) p[1] = pair.sign * cell_friction(r, d) * p[0] + (grows ? z[1] / k : 0.0);
    for (int s = 0; s < d.slots; ++s)
      u[d.row + s] = static_cast<Real>((d.cell == Cell::open || (cell_status(d, d.cell) == C2D_SLIP && s == 1) ? w : p)[s]);
  }
}

// Beyond a bound whose pair held the last motion of a body: z stays, and the bodies go along that motion up to the next bound.
// The cells of both pairs are regular together.
bool pass_motion(RateProblem& r, const Doubt& d, double z) {
  double by[2];
  if (!entering_numbers(r, d, by)) return false;
  for (int32_t i = 0; i < r.t->m; ++i) r.rates[i] = 0;
  for (int s = 0; s < d.slots; ++s)
    if (by[s] != 0.0) add_column_to(*r.t, column_of(*r.t, d.pair, s), by[s], r.rates);
  read_rows(r, r.rates, r.point);
  read_in_cell(r, d, by);
  r.point[r.size] = 0;
  r.rhs[r.size] = static_cast<Real>(z);
  const Meeting next = end_of_stretch(r, r.rhs, r.point);
  if (next.doubt < 0) return false;
  for (int32_t i = 0; i < r.size; ++i) r.rhs[i] += static_cast<Real>(next.where) * r.point[i];
  Doubt& other = r.doubt[next.doubt];
  const Crossing crossing = cross(r, other, next.which, r.rhs);
  other.cell = crossing.cell;
  if (!exchange_to_cell(r, other) || !exchange_to_cell(r, d)) return false;
  begin_stretch(r, other, crossing.entering, z);
  return true;
}

bool next_on_tableau(RateProblem& r, const Doubt& d, const double entering[2], double z) {
  if (!exchange_to_cell(r, d)) return pass_motion(r, d, z);
  begin_stretch(r, d, entering, z);
  return true;
}

// ---- by systems ---------------------------------------------------------------------------------------------------

// c in r.cover: the artificial load under which the pairs have the rates `inside` in r.point. The matrix is used.
void choose_cover(RateProblem& r, Draw* draw) {
  for (int32_t i = 0; i <= r.size; ++i) r.cover[i] = 0;
  for (int32_t i = 0; i < r.count; ++i) {
    const Doubt& d = r.doubt[i];
    double rate[2];
    inside(d, weight_of(d, draw), rate);
    for (int s = 0; s < d.slots; ++s) {
      r.point[d.row + s] = static_cast<Real>(rate[s]);
      for (int32_t j = 0; j < r.size; ++j) r.cover[j] += r.point[d.row + s] * at(r, j, d.row + s);
    }
  }
}

// The least z from which on the cells are right, and the condition that ends there; r.rhs: the rates for z = 0.
Meeting start_of_path(const RateProblem& r) {
  Meeting first{0.0, -1, 0};
  for (int32_t i = 0; i < r.count; ++i) {
    Condition condition[2];
    const int count = cell_conditions(r, r.doubt[i], r.doubt[i].cell, condition);
    for (int k = 0; k < count; ++k) {
      const double grows = value_of(condition[k].row, r.doubt[i], r.point), now = value_of(condition[k].row, r.doubt[i], r.rhs);
      if (now < -first.where * grows) first = Meeting{-now / grows, i, k};
    }
  }
  return first;
}

// Solves the bordered system of the present cells: the stretch that begins where `entering` of doubt i is zero.
bool solve_stretch(RateProblem& r, const Doubt& d, const double entering[2]) {
  assemble_cells(r);
  for (int32_t i = 0; i < r.size; ++i) at(r, i, r.size) = -r.cover[i];
  for (int s = 0; s < d.slots; ++s) at(r, r.size, d.row + s) = static_cast<Real>(entering[s]);
  if (!factor_cells(r, r.size + 1)) return false;
  load_cells(r, r.rhs);
  r.rhs[r.size] = 0;
  solve_cells(r, r.size + 1, r.rhs);
  for (int32_t i = 0; i < r.size; ++i) r.point[i] = 0;
  r.point[r.size] = 1;
  solve_cells(r, r.size + 1, r.point); // the tangent
  return true;
}

// r.rhs: the rates of the present cells for z = 0, r.point: what z adds.
bool start(RateProblem& r, Draw* draw) {
  if (r.on_tableau) {
    if (!start_on_tableau(r, draw)) return false;
    read_rates(r);
    return true;
  }
  assemble_cells(r);
  choose_cover(r, draw);
  if (!factor_cells(r, r.size)) return false;
  load_cells(r, r.rhs);
  solve_cells(r, r.size, r.rhs);
  return true;
}

// From the present cells; true if the cells at the end have rates that satisfy all conditions.
bool follow(RateProblem& r, Draw* draw, const Ticks& ticks) {
  if (!start(r, draw)) return false;
  Meeting next = start_of_path(r);
  double z = next.where;
  for (int32_t i = 0; i < r.size && next.doubt >= 0; ++i) r.rhs[i] += static_cast<Real>(z) * r.point[i];
  for (int32_t stretch = 0; next.doubt >= 0; ++stretch) {
    Doubt& d = r.doubt[next.doubt];
    const Crossing crossing = cross(r, d, next.which, r.rhs);
    d.cell = crossing.cell;
    if (stretch > 100 + 20 * r.count || r.work > most_work(r) || (stretch % 256 == 255 && ticks.end())) return false;
    if (!(r.on_tableau ? next_on_tableau(r, d, crossing.entering, z) : solve_stretch(r, d, crossing.entering))) return false;
    next = end_of_stretch(r, r.rhs, r.point);
    if (next.where < 0.0) return false;
    for (int32_t i = 0; i <= r.size; ++i) r.rhs[i] += static_cast<Real>(next.where) * r.point[i];
    z = r.rhs[r.size];
  }
  return r.on_tableau ? satisfies(r, r.rhs) : solve_present_cells(r, r.rhs);
}

void stick_all(RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i)
    r.doubt[i].cell = r.doubt[i].kind == DoubtKind::normal ? closed_cell(r.doubt[i]) : Cell::stick;
}

void draw_cells(RateProblem& r, Draw& draw) {
  for (int32_t i = 0; i < r.count; ++i) {
    Doubt& d = r.doubt[i];
    d.cell = nth_cell(d, static_cast<int>(draw.next() * cells_of(d)));
  }
}

void keep_cells(RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i) r.doubt[i].taken = r.doubt[i].cell;
}
void take_cells(RateProblem& r) {
  for (int32_t i = 0; i < r.count; ++i) r.doubt[i].cell = r.doubt[i].taken;
}

// From a part of every coefficient at the apex to the whole, in steps that are halved where they fail.
bool change_friction(RateProblem& r, double part, const Ticks& ticks) {
  r.mu_part = part;
  stick_all(r);
  bool found = follow(r, nullptr, ticks);
  double step = part < 1.0 ? 1.3 : 1.0 / 1.3;
  while (found && r.mu_part != 1.0) {
    keep_cells(r);
    const double from = r.mu_part, to = from * step;
    r.mu_part = (step > 1.0) == (to > 1.0) ? 1.0 : to;
    if (solve_present_cells(r, r.rhs) || follow(r, nullptr, ticks)) continue;
    take_cells(r);
    r.mu_part = from;
    step = sqrt(step);
    found = *ticks.status == C2D_OK && fabs(step - 1.0) > 1e-3 && r.work < most_work(r);
  }
  r.mu_part = 1.0;
  return found;
}

} // namespace

Settled follow_cells(RateProblem& r, bool drawn, c2d_status (*tick)(void*), void* context, c2d_status* status) {
  constexpr int kPlain = 5;
  Draw draw{20110917u};
  const double parts[] = {1e-3, 3.0, 30.0};
  const Ticks ticks{tick, context, status};
  *status = C2D_OK;
  for (int attempt = 0; attempt < (drawn ? kDraws : kPlain) && *status == C2D_OK && r.work < most_work(r); ++attempt) {
    if (ticks.end()) break;
    if (!drawn && attempt >= 2) {
      if (!r.on_tableau && change_friction(r, parts[attempt - 2], ticks)) return Settled::solved;
      continue;
    }
    if (drawn)
      draw_cells(r, draw);
    else if (attempt == 1)
      stick_all(r);
    if (follow(r, drawn ? &draw : nullptr, ticks)) return Settled::solved;
  }
  return Settled::undecided;
}

} // namespace c2d
