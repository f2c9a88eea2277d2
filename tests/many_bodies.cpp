#include "many_bodies.hpp"

#include "contact2d_cycle.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <stdexcept>

namespace many {

namespace {
size_t index(int64_t i) { return static_cast<size_t>(i); }
double larger(double a, double b) { return std::max(std::fabs(a), std::fabs(b)); }
} // namespace

End end_of(const char* codes, double tx, double ty, double ux, double uy) {
  End end;
  const double values[4] = {tx, ty, ux, uy};
  for (int k = 0; k < 4; ++k) {
    end.codes[k] = codes[k] - '0';
    end.values[k] = end.codes[k] != 0 ? 0 : values[k];
  }
  return end;
}

// ---- bodies

namespace {

void add_side(Body& body, const Corner& from, double x, double y) {
  const int32_t first = body.sides.empty() ? 1 : body.sides.back().last + 1, steps = from.elements * (body.element_nodes - 1);
  for (int32_t k = 0; k < steps; ++k) {
    const double g = std::pow(from.growth, 1.0 / (body.element_nodes - 1));
    const double s = g == 1 ? static_cast<double>(k) / steps : (std::pow(g, k) - 1) / (std::pow(g, steps) - 1);
    body.xy.push_back(from.x + (x - from.x) * s);
    body.xy.push_back(from.y + (y - from.y) * s);
  }
  body.sides.push_back({first, first + from.elements - 1});
}

} // namespace

void add_polygon(Body& body, const std::vector<Corner>& corners) {
  const int32_t first = body.elements() + 1;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Corner& to = corners[(i + 1) % corners.size()];
    add_side(body, corners[i], to.x, to.y);
  }
  body.regions.push_back({first, body.sides.back().last});
}

Body polygon(const std::vector<Corner>& corners, double youngs_modulus, double poisson_ratio) {
  Body body;
  body.youngs_modulus = youngs_modulus, body.poisson_ratio = poisson_ratio;
  add_polygon(body, corners);
  return body;
}

Body rectangle(double x0, double y0, double x1, double y1, const std::array<int32_t, 4>& n, double youngs_modulus,
               double poisson_ratio) {
  return polygon({{x0, y0, n[0]}, {x1, y0, n[1]}, {x1, y1, n[2]}, {x0, y1, n[3]}}, youngs_modulus, poisson_ratio);
}

Body open_polygon(const std::vector<Corner>& corners, double youngs_modulus, double poisson_ratio) {
  Body body;
  body.youngs_modulus = youngs_modulus, body.poisson_ratio = poisson_ratio;
  for (size_t i = 0; i + 1 < corners.size(); ++i) add_side(body, corners[i], corners[i + 1].x, corners[i + 1].y);
  body.xy.insert(body.xy.end(), {corners.back().x, corners.back().y});
  body.open_regions = 1;
  body.regions.push_back({1, body.sides.back().last});
  return body;
}

void add_curve(Body& body, int32_t elements, const test::Callable<void(double, double&, double&)>& curve) {
  const int32_t first = body.elements() + 1, points = elements * (body.element_nodes - 1);
  for (int32_t i = 0; i < points; ++i) {
    double x, y;
    curve(static_cast<double>(i) / points, x, y);
    body.xy.insert(body.xy.end(), {x, y});
  }
  body.regions.push_back({first, first + elements - 1});
  body.sides.push_back(body.regions.back());
}

int32_t Zone::count(int k) const {
  return side[k].elements != 0 ? side[k].elements : std::abs(side[k].last - side[k].first) + 1;
}

int32_t Model::add(const Body& body) {
  bodies.push_back(body);
  bodies.back().ends.assign(index(body.elements() * function_nodes), End());
  return static_cast<int32_t>(bodies.size());
}

void Model::set(int32_t number, int32_t of, const End& end) {
  set(number, of, [&](double, double) { return end; });
}
void Model::set(int32_t number, int32_t of, const test::Callable<End(double, double)>& end) {
  const Range r = side(number, of);
  for (int32_t e = r.first; e <= r.last; ++e)
    for (int32_t l = 0; l < function_nodes; ++l) {
      double x, y;
      place(number, e, l, x, y);
      body(number).ends[index((e - 1) * function_nodes + l)] = end(x, y);
    }
}
void Model::set_second(int32_t number, int32_t of, const End& end) {
  cases = 2;
  for (Body& b : bodies)
    if (b.second.empty()) {
      b.second = b.ends;
      for (End& e : b.second) std::fill(e.values, e.values + 4, 0.0);
    }
  const Range r = side(number, of);
  for (int32_t i = (r.first - 1) * function_nodes; i < r.last * function_nodes; ++i) body(number).second[index(i)] = end;
}

Platen& Model::move(int32_t number, int32_t side_number) {
  const Range r = side(number, side_number);
  platens.emplace_back();
  platens.back().side = {number, r.first, r.last};
  return platens.back();
}

int32_t Model::join(int32_t kind, int32_t body1, int32_t side1, int32_t body2, int32_t side2) {
  const Range a = side(body1, side1), b = side(body2, side2);
  zones.push_back({kind, {{body1, a.first, a.last}, {body2, b.last, b.first}}});
  return static_cast<int32_t>(zones.size());
}

namespace {

const Range& region_of(const Body& body, int32_t element) {
  for (const Range& r : body.regions)
    if (element >= r.first && element <= r.last) return r;
  throw std::runtime_error("no such element");
}
// How many open regions stand before that of an element, and whether it is open itself.
int32_t open_before(const Body& body, int32_t element, bool& open) {
  int32_t before = 0;
  open = false;
  for (int32_t i = 0; i < body.open_regions; ++i) {
    const Range& r = body.regions[index(i)];
    if (r.last < element) ++before;
    if (element >= r.first && element <= r.last) open = true;
  }
  return before;
}
// Node `local` (from 0) of an element with `per` steps, from 1; per 0: one node for each element.
int32_t node_of(const Body& body, int32_t element, int32_t local, int32_t per) {
  if (per == 0) return element;
  bool open;
  const int32_t shift = open_before(body, element, open) + 1;
  const Range& r = region_of(body, element);
  if (element == r.last && local == per && !open) return (r.first - 1) * per + shift;
  return (element - 1) * per + local + shift;
}

} // namespace

void Model::place(int32_t number, int32_t element, int32_t local, double& x, double& y) const {
  const Body& b = body(number);
  const int32_t n = b.element_nodes;
  const double eta = function_nodes == 1 ? 0 : -1 + 2.0 * local / (function_nodes - 1);
  x = y = 0;
  for (int32_t k = 0; k < n; ++k) {
    double shape = 1;
    for (int32_t j = 0; j < n; ++j)
      if (j != k) shape *= (eta - (-1 + 2.0 * j / (n - 1))) / (2.0 * (k - j) / (n - 1));
    const size_t i = index(2 * (node_of(b, element, k, n - 1) - 1));
    x += shape * b.xy[i], y += shape * b.xy[i + 1];
  }
}

double Model::scale() const {
  double most = 0;
  for (const Body& b : bodies)
    for (double x : b.xy) most = std::max(most, std::fabs(x));
  return most;
}

// ---- through the interface

std::vector<c2d_body_limits> body_limits(const Model& m) {
  std::vector<c2d_body_limits> list;
  for (const Body& b : m.bodies)
    list.push_back({static_cast<int32_t>(b.xy.size() / 2), b.elements(), static_cast<int32_t>(b.regions.size()), 0});
  return list;
}

namespace {
// A side that is a whole closed curve: its first node is not one more at the end.
bool is_ring(const Model& m, const Zone& z, int k) {
  const Range& r = region_of(m.body(z.side[k].body), z.side[k].first);
  return &r - m.body(z.side[k].body).regions.data() >= m.body(z.side[k].body).open_regions &&
         z.count(k) == r.last - r.first + 1;
}
int32_t pairs_of(const Model& m, const Zone& z) {
  const int32_t elements = z.count(1);
  if ((z.kind & C2D_ZONE_FREE) == 0 && is_ring(m, z, 1)) return elements * std::max(1, m.function_nodes - 1);
  return m.function_nodes == 1 ? elements : elements * (m.function_nodes - 1) + 1 - z.without[0] - z.without[1];
}
} // namespace

c2d_limits limits_of(const Model& m, std::vector<c2d_body_limits>& list) {
  list = body_limits(m);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = static_cast<int32_t>(list.size());
  limits.body = list.data();
  limits.function_nodes = m.function_nodes;
  limits.zones = static_cast<int32_t>(m.zones.size());
  for (const Zone& z : m.zones) {
    const int32_t pairs = pairs_of(m, z) * ((z.kind & C2D_ZONE_SELF) != 0 ? 2 : 1);
    limits.pairs += pairs;
    if ((z.kind & C2D_ZONE_FREE) != 0) limits.free_pairs += pairs;
    limits.contact_elements += z.count(1);
  }
  for (const Platen& p : m.platens) {
    const Zone z = {C2D_ZONE_MATCHING, {p.side, p.side}};
    ++limits.platens, ++limits.zones;
    limits.pairs += pairs_of(m, z);
    limits.contact_elements += z.count(1);
  }
  limits.point_loads = static_cast<int32_t>(m.point_loads.size());
  limits.coefficients = 1;
  limits.paths = static_cast<int32_t>(m.paths.size());
  limits.load_cases = std::max(m.cases, m.interference);
  limits.touching = m.touching;
  limits.cycle_states = m.cycle_states;
  return limits;
}

namespace {

c2d_status feed_body(c2d_solver* s, const Model& m, int32_t number) {
  const Body& b = m.body(number);
  c2d_body data = C2D_INIT(c2d_body);
  data.element_nodes = b.element_nodes;
  data.elements = b.elements();
  data.regions = static_cast<int32_t>(b.regions.size());
  data.open_regions = b.open_regions;
  data.youngs_modulus = b.youngs_modulus;
  data.poisson_ratio = b.poisson_ratio;
  c2d_status status = c2d_set_body(s, number, &data);
  for (const Range& r : b.regions)
    if (status == C2D_OK) status = c2d_add_region(s, number, r.first, r.last);
  if (status == C2D_OK) status = c2d_set_nodes(s, number, 1, static_cast<int32_t>(b.xy.size() / 2), b.xy.data(), 2);
  for (int32_t k = 1; k <= m.cases; ++k) {
    const std::vector<End>& ends = k == 1 ? b.ends : b.second;
    for (size_t i = 0; i < ends.size() && status == C2D_OK; ++i) {
      const int32_t end = static_cast<int32_t>(i);
      status = c2d_set_condition(s, number, end / m.function_nodes + 1, end % m.function_nodes + 1, k, ends[i].codes,
                                 ends[i].values);
    }
  }
  const double at_origin[2] = {0, 0};
  if (b.force[0] != 0 || b.force[1] != 0 || b.spin != 0)
    if (status == C2D_OK) status = c2d_set_body_force(s, number, 1, b.force, b.spin, at_origin);
  if (b.rigid == 0) return status;
  if (status == C2D_OK) status = c2d_set_rigid(s, number, 0, nullptr, nullptr);
  if (status == C2D_OK) status = c2d_set_rigid(s, number, 1, b.motion, b.point);
  if (b.is_free[0] + b.is_free[1] + b.is_free[2] == 0) return status;
  if (status == C2D_OK) status = c2d_set_rigid_load(s, number, 0, b.is_free, nullptr, b.point);
  return status == C2D_OK ? c2d_set_rigid_load(s, number, 1, nullptr, b.load, nullptr) : status;
}

c2d_side side_of(const Model& m, const Zone& z, int k) {
  const Side& from = z.side[k];
  c2d_side side = {from.body, from.first, from.last, from.elements, 0, 0};
  if ((z.kind & C2D_ZONE_FREE) != 0) return side;
  const int32_t per = m.function_nodes - 1;
  const Range& r = region_of(m.body(from.body), from.first);
  const bool up = from.elements == 0
                      ? (from.last == from.first ? k == 0 : from.last > from.first)
                      : (from.first - r.first + from.elements - 1) % (r.last - r.first + 1) == from.last - r.first;
  side.elements = z.count(k);
  side.first_node = node_of(m.body(from.body), from.first, up ? z.without[0] : per - z.without[0], per);
  side.last_node = node_of(m.body(from.body), from.last, up ? per - z.without[1] : z.without[1], per);
  if (is_ring(m, z, k) && per > 0) side.last_node = node_of(m.body(from.body), from.last, up ? per - 1 : 1, per);
  return side;
}

c2d_status feed_platen(c2d_solver* s, const Model& m, size_t i) {
  const Platen& p = m.platens[i];
  const int32_t number = static_cast<int32_t>(m.bodies.size() + i) + 1;
  c2d_status status = c2d_add_platen(s, p.side.body, p.side.first, p.side.last, p.side.elements, p.is_free, p.point);
  for (int32_t k = 1; k <= m.cases; ++k) {
    if (status == C2D_OK) status = c2d_set_rigid(s, number, k, k == 1 ? p.motion : p.second_motion, p.point);
    if (status == C2D_OK) status = c2d_set_rigid_load(s, number, k, nullptr, k == 1 ? p.load : p.second_load, nullptr);
  }
  return status;
}

} // namespace

c2d_status feed(c2d_solver* s, const Model& m) {
  c2d_problem data = C2D_INIT(c2d_problem);
  data.plane = m.plane;
  data.analysis = C2D_ANALYSIS_FULL;
  c2d_status status = c2d_set_problem(s, &data);
  for (int32_t b = 1; b <= static_cast<int32_t>(m.bodies.size()) && status == C2D_OK; ++b) status = feed_body(s, m, b);
  for (const PointLoad& l : m.point_loads)
    if (status == C2D_OK) status = c2d_add_point_load(s, l.body, 1, l.x, l.y, l.fx, l.fy);
  for (const Zone& z : m.zones) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    zone.kind = z.kind;
    zone.pairs = (z.kind & C2D_ZONE_FREE) != 0 ? 0 : pairs_of(m, z);
    zone.side1 = side_of(m, z, 0), zone.side2 = side_of(m, z, 1);
    if (status == C2D_OK) status = c2d_add_zone(s, &zone);
  }
  for (size_t i = 0; i < m.platens.size(); ++i)
    if (status == C2D_OK) status = feed_platen(s, m, i);
  if (status == C2D_OK && m.interference > 0) status = c2d_set_interference(s, m.interference);
  if (status == C2D_OK) status = c2d_add_friction(s, m.friction);
  for (size_t i = 0; i < m.zones.size(); ++i)
    if (status == C2D_OK && m.zones[i].mu >= 0)
      status = c2d_set_zone_friction(s, static_cast<int32_t>(i) + 1, 1, m.zones[i].mu);
  for (const Path& p : m.paths) {
    const double factors[2] = {p.load, p.second};
    if (status == C2D_OK) status = c2d_add_path(s, p.increments, factors, m.cases);
  }
  if (status == C2D_OK && m.repeated > 0)
    status = c2d_repeat_paths(s, m.repeated, m.cycle_limit, m.cycle_digits, m.cycle_start);
  for (int32_t axis = 0; axis < 2; ++axis)
    if (status == C2D_OK && (m.symmetry >> axis & 1) != 0) status = c2d_set_symmetry(s, axis, m.symmetry_at[axis]);
  return status == C2D_OK ? c2d_complete(s) : status;
}

// The port's functions get at the store and at the list of messages through the machine.
struct Relay {
  static Machine& of(void* c) { return *static_cast<Machine*>(c); }
  static int32_t open(void* c, int32_t t, uint64_t n, uint64_t size) {
    return of(c).inner_.open(of(c).inner_.context, t, n, size);
  }
  static int32_t read(void* c, int32_t t, uint64_t k, void* d, uint64_t n) {
    return of(c).inner_.read(of(c).inner_.context, t, k, d, n);
  }
  static int32_t write(void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
    return of(c).inner_.write(of(c).inner_.context, t, k, d, n);
  }
  static int32_t sync(void* c, int32_t t) { return of(c).inner_.sync(of(c).inner_.context, t); }
  static int32_t close(void* c, int32_t t) { return of(c).inner_.close(of(c).inner_.context, t); }
  static void log(void* c, const c2d_error* entry) { of(c).told.push_back(*entry); }
};

namespace {
uint64_t bytes_of_tapes(const c2d_limits& limits, uint64_t workspace) {
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = C2D_ELIMINATION_COMPRESSED;
  uint64_t sum = 0;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    uint64_t blocks = 0, each = 0;
    c2d_tape_need(&limits, &options, workspace, tape, &blocks, &each, nullptr);
    sum += blocks * (each + 64) + 64;
  }
  return sum;
}
} // namespace

void Machine::create(c2d_limits& limits, uint64_t bytes) {
  uint64_t minimum = 0, in_core = 0;
  c2d_error why = C2D_INIT(c2d_error);
  status = c2d_memory_need(&limits, &minimum, &in_core, &why);
  if (status != C2D_OK) return told.push_back(why);
  memory_.resize(bytes == 0 ? std::max(minimum, in_core) : std::max(minimum, bytes));
  uint64_t tapes = 4 * in_core + (8u << 20);
  if (limits.touching > 0) tapes = bytes_of_tapes(limits, memory_.size());
  region_.resize(tapes);
  c2d_memory_store_init(&store_, region_.data(), region_.size());
  c2d_memory_store_port(&store_, &inner_);
  port_.context = this;
  port_.open = Relay::open, port_.read = Relay::read, port_.write = Relay::write, port_.sync = Relay::sync;
  port_.close = Relay::close, port_.log = Relay::log;
  status = c2d_create(&solver, memory_.data(), memory_.size(), &limits, &port_, &why);
  if (status != C2D_OK) told.push_back(why);
}

Machine::Machine(const Model& m, int32_t keep_factors, int32_t stepping) {
  std::vector<c2d_body_limits> list;
  c2d_limits limits = limits_of(m, list);
  create(limits, m.bytes);
  if (status != C2D_OK) return;
  c2d_options options = C2D_INIT(c2d_options);
  options.keep_factors = keep_factors;
  options.stepping = stepping;
  options.elimination = m.elimination;
  status = c2d_set_options(solver, &options);
  if (status == C2D_OK) status = feed(solver, m);
}

namespace {
struct Cards {
  const std::string* text;
  size_t at;
};
int32_t read_card(void* context, char* out, int32_t size) {
  Cards& cards = *static_cast<Cards*>(context);
  if (cards.at >= cards.text->size()) return -1;
  const size_t end = std::min(cards.text->find('\n', cards.at), cards.text->size());
  const size_t length = end - cards.at, fits = std::min(length, index(size - 1));
  cards.text->copy(out, fits, cards.at);
  out[fits] = '\0';
  cards.at = end + 1;
  return static_cast<int32_t>(length);
}
} // namespace

Machine::Machine(const std::string& deck, int32_t cycle_states) {
  std::vector<c2d_body_limits> list(64);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 64, limits.body = list.data();
  Cards cards{&deck, 0};
  const auto hear = [](void* c, const c2d_error* e) { static_cast<Machine*>(c)->told.push_back(*e); };
  status = c2d_check_deck(read_card, &cards, &limits, hear, this);
  if (status != C2D_OK) return;
  limits.cycle_states = cycle_states;
  create(limits);
  if (status != C2D_OK) return;
  cards.at = 0;
  status = c2d_read_deck(solver, read_card, &cards);
}

Machine::~Machine() {
  if (solver) c2d_close(solver);
}

namespace {
int32_t keep_step(void* context, const c2d_step* now) {
  Step step;
  step.kind = now->kind, step.outcome = now->outcome, step.load = now->load;
  step.work = now->work, step.dissipated = now->dissipated, step.elastic = now->elastic, step.defect = now->energy_defect;
  step.rows.resize(index(now->pairs));
  for (int32_t p = 0; p < now->pairs; ++p)
    std::copy(now->table + p * now->stride, now->table + p * now->stride + C2D_PAIR_FIELDS, step.rows[index(p)].begin());
  static_cast<Result*>(context)->steps.push_back(step);
  return 0;
}
} // namespace

Result Machine::look() {
  Result r;
  c2d_get_summary(solver, &r.summary);
  r.outcome = r.summary.outcome;
  for (int32_t b = 1; b <= r.summary.bodies; ++b) {
    c2d_body_result body = C2D_INIT(c2d_body_result);
    r.status = c2d_get_body_result(solver, b, &body);
    if (r.status != C2D_OK) return r;
    r.bodies.push_back(body);
    const int32_t count = body.elements * r.summary.function_nodes;
    std::vector<EndResult> ends(index(count));
    const int32_t fields[11] = {C2D_END_X,  C2D_END_Y,      C2D_END_NODE, C2D_END_UX,  C2D_END_UY, C2D_END_TX,
                                C2D_END_TY, C2D_END_STATUS, C2D_END_SXX,  C2D_END_SYY, C2D_END_SXY};
    std::vector<double> values(index(count));
    for (int f = 0; f < 11; ++f) {
      if (c2d_get(solver, fields[f], b, 1, count, values.data(), 1) != C2D_OK)
        values.assign(index(count), 0); // of a rigid body
      for (int32_t i = 0; i < count; ++i) *(&ends[index(i)].x + f) = values[index(i)];
    }
    r.boundary.push_back(ends);
  }
  for (int32_t z = 1; z <= r.summary.zones; ++z) {
    c2d_zone_state state = C2D_INIT(c2d_zone_state);
    if (c2d_get_zone_state(solver, z, &state) == C2D_OK) r.zones.push_back(state);
  }
  for (int32_t b = 1; b <= r.summary.bodies; ++b) {
    c2d_body_state state = C2D_INIT(c2d_body_state);
    if (c2d_get_body_state(solver, b, &state) == C2D_OK) r.states.push_back(state);
  }
  c2d_get_summary(solver, &r.summary);
  return r;
}

Result Machine::run() {
  Result steps;
  if (status == C2D_OK && c2d_get_state(solver) == C2D_STATE_MODEL) status = c2d_prepare(solver);
  if (status == C2D_OK) status = c2d_run(solver, keep_step, &steps);
  Result r;
  if (status == C2D_OK) r = look();
  if (r.outcome != C2D_REACHED) r.status = C2D_OK; // there may be nothing to be had
  if (status != C2D_OK) r.status = status;
  r.steps = steps.steps;
  r.told = told;
  return r;
}

Result solve(const Model& m, int32_t stepping) { return Machine(m, 0, stepping).run(); }
Result solve_deck(const std::string& text) { return Machine(text).run(); }

// ---- as a deck

namespace {

std::string words(std::initializer_list<int32_t> numbers) {
  std::string text;
  for (int32_t n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}
std::string reals(std::initializer_list<double> numbers) {
  std::string text;
  for (double x : numbers) {
    char one[32];
    std::snprintf(one, sizeof one, " %.17g", x);
    text += one;
  }
  return text;
}

std::string body_cards(const Model& m, const Body& b, int32_t number) {
  std::string cards, loads;
  int32_t count = 0, forces = 0;
  for (size_t i = 0; i < b.ends.size(); ++i) {
    const End& e = b.ends[i];
    bool plain = e.codes[0] == 0 && e.codes[1] == 0;
    for (double v : e.values) plain = plain && v == 0;
    if (plain) continue;
    const int32_t f = m.function_nodes, end = static_cast<int32_t>(i);
    cards += words({end / f + 1, end % f + 1}) + " ";
    for (int32_t code : e.codes) cards += std::to_string(code);
    cards += reals({e.values[0], e.values[1], e.values[2], e.values[3]}) + "\n";
    ++count;
  }
  for (const PointLoad& l : m.point_loads)
    if (l.body == number) loads += std::to_string(++forces) + reals({l.x, l.y, l.fx, l.fy}) + "\n";
  return std::to_string(count) + "\n" + cards + std::to_string(forces) + "\n" + loads;
}

std::string rigid_cards(const Body& b, int32_t number) {
  std::string text = "*RIGID " + std::to_string(number) + "\n1" +
                     reals({b.motion[0], b.motion[1], b.motion[2], b.point[0], b.point[1]}) + "\n";
  const char* const names[3] = {" X", " Y", " TURN"};
  std::string free;
  for (int i = 0; i < 3; ++i)
    if (b.is_free[i] != 0) free += names[i];
  if (free.empty()) return text;
  text += "*RIGID LOAD " + std::to_string(number) + reals({b.point[0], b.point[1]}) + free + "\n1";
  return text + reals({b.load[0], b.load[1], b.load[2]}) + "\n";
}

std::string platen_cards(const Model& m, const Platen& p) {
  std::string text = "*PLATEN " + words({p.side.body, p.side.first, p.side.last}) + reals({p.point[0], p.point[1]}) + "\n";
  const char* const moved[3] = {" UX", " UY", " TURN"};
  const char* const loaded[3] = {" FX", " FY", " MOMENT"};
  for (int32_t k = 1; k <= m.cases; ++k) {
    text += std::to_string(k);
    for (int i = 0; i < 3; ++i)
      text += p.is_free[i] != 0 ? loaded[i] + reals({k == 1 ? p.load[i] : p.second_load[i]})
                                : moved[i] + reals({k == 1 ? p.motion[i] : p.second_motion[i]});
    text += "\n";
  }
  return text;
}

// Values of a second load case, and the factors of both.
std::string case_cards(const Model& m) {
  if (m.cases < 2) return "";
  std::string text = "*CASES 2\ncase 2\n";
  for (size_t b = 0; b < m.bodies.size(); ++b)
    for (size_t i = 0; i < m.bodies[b].second.size(); ++i) {
      const double* v = m.bodies[b].second[i].values;
      const int32_t f = m.function_nodes, end = static_cast<int32_t>(i);
      if (v[0] == 0 && v[1] == 0 && v[2] == 0 && v[3] == 0) continue;
      text += "condition " + words({static_cast<int32_t>(b) + 1, end / f + 1, end % f + 1});
      text += reals({v[0], v[1], v[2], v[3]}) + "\n";
    }
  text += "*PATH\n";
  for (const Path& p : m.paths) text += std::to_string(p.increments) + reals({p.load, p.second}) + "\n";
  return text;
}

} // namespace

std::string deck_of(const Model& m, const std::string& title, std::vector<int32_t>& order) {
  std::string regions, moduli, nodes, conditions, zones, touching, friction, keywords;
  std::string text = "*FREE\n1\n" + title + "\n" + words({m.plane, 2}) + "\n";
  std::vector<int32_t> in_contact(2 * m.bodies.size());
  order.clear();
  for (const int32_t free : {0, 1})
    for (size_t i = 0; i < m.zones.size(); ++i) {
      const Zone& z = m.zones[i];
      if (((z.kind & C2D_ZONE_FREE) != 0) != (free != 0)) continue;
      order.push_back(static_cast<int32_t>(i) + 1);
      const c2d_side a = side_of(m, z, 0), b = side_of(m, z, 1);
      const int32_t second = (z.kind & C2D_ZONE_SELF) != 0 ? -b.body : b.body;
      if (free == 0) {
        zones += words({a.body, second, pairs_of(m, z), z.count(0)}) + "\n";
        zones += words({a.first_element, a.last_element, b.first_element, b.last_element}) + "\n";
        zones += words({a.first_node, a.last_node, b.first_node, b.last_node}) + "\n";
        for (const c2d_side* side : {&a, &b}) {
          in_contact[index(2 * (side->body - 1))] += pairs_of(m, z);
          in_contact[index(2 * (side->body - 1) + 1)] += z.count(0);
        }
      } else {
        keywords += "*ZONE BODIES " + words({a.body, second, a.first_element, a.last_element, b.first_element, b.last_element});
        keywords += "\n";
      }
    }
  for (size_t i = 0; i < order.size(); ++i) {
    const Zone& z = m.zones[index(order[i] - 1)];
    const int32_t number = static_cast<int32_t>(i) + 1;
    if ((z.kind & C2D_ZONE_TIED) != 0) keywords += "*TIE " + std::to_string(number) + "\n";
    if (z.mu >= 0) friction += std::to_string(number) + reals({z.mu}) + "\n";
  }
  if (!friction.empty()) keywords += "*FRICTION\n" + friction;
  int32_t matching = 0;
  for (const Zone& z : m.zones) matching += (z.kind & C2D_ZONE_FREE) == 0;
  text += words({static_cast<int32_t>(m.bodies.size()), matching, m.function_nodes}) + "\n";
  for (size_t i = 0; i < m.bodies.size(); ++i) {
    const Body& b = m.bodies[i];
    const int32_t points = static_cast<int32_t>(b.xy.size() / 2), number = static_cast<int32_t>(i) + 1;
    text += words({static_cast<int32_t>(b.regions.size()), b.element_nodes, b.elements(), points}) + "\n";
    for (const Range& r : b.regions) regions += words({r.first, r.last}) + "\n";
    moduli += reals({b.youngs_modulus, b.poisson_ratio}) + "\n";
    nodes += "0 0\n";
    for (int32_t k = 0; k < points; ++k)
      nodes += std::to_string(k + 1) + reals({b.xy[index(2 * k)], b.xy[index(2 * k + 1)]}) + "\n";
    conditions += body_cards(m, b, number);
    if (b.rigid != 0) keywords += rigid_cards(b, number);
    if (b.force[0] != 0 || b.force[1] != 0 || b.spin != 0)
      keywords += "*BODY FORCE " + words({number, 1}) + reals({b.force[0], b.force[1], b.spin, 0, 0}) + "\n";
    touching += words({in_contact[2 * i], in_contact[2 * i + 1]}) + "\n";
  }
  for (int axis = 0; axis < 2; ++axis)
    if ((m.symmetry >> axis & 1) != 0) keywords += std::string("*SYMMETRY ") + "XY"[axis] + reals({m.symmetry_at[axis]}) + "\n";
  text += regions + moduli + "1" + reals({m.friction}) + "\n" + nodes + conditions + zones + touching;
  text += words({static_cast<int32_t>(m.paths.size()), 50}) + "\n";
  for (const Path& p : m.paths) text += std::to_string(p.increments) + reals({p.load}) + "\n";
  for (const Platen& p : m.platens) keywords += platen_cards(m, p);
  if (m.interference > 0) keywords += "*INTERFERENCE " + std::to_string(m.interference) + "\n";
  return text + case_cards(m) + keywords;
}

std::string Result::messages() const {
  std::string all;
  for (const c2d_error& e : told) all += std::to_string(e.status) + ": " + e.text + "\n";
  return all;
}
bool Result::told_of(const std::string& words) const { return messages().find(words) != std::string::npos; }
std::vector<Row> Result::zone_rows(int32_t zone) const {
  std::vector<Row> rows;
  for (const Row& row : last().rows)
    if (static_cast<int32_t>(row[C2D_PAIR_ZONE]) == zone) rows.push_back(row);
  return rows;
}

// ---- told otherwise

Model with_bodies_in_order(const Model& m, const std::vector<int32_t>& order) {
  Model q = m;
  std::vector<int32_t> number(order.size() + 1);
  for (size_t i = 0; i < order.size(); ++i) {
    q.bodies[i] = m.body(order[i]);
    number[index(order[i])] = static_cast<int32_t>(i) + 1;
  }
  for (Zone& z : q.zones)
    for (Side& side : z.side) side.body = number[index(side.body)];
  for (PointLoad& l : q.point_loads) l.body = number[index(l.body)];
  for (Platen& p : q.platens) p.side.body = number[index(p.side.body)];
  return q;
}

Model with_zones_in_order(const Model& m, const std::vector<int32_t>& order) {
  Model q = m;
  for (size_t i = 0; i < order.size(); ++i) q.zones[i] = m.zones[index(order[i] - 1)];
  return q;
}

Model with_swapped_sides(Model m, int32_t zone) {
  std::swap(m.zones[index(zone - 1)].side[0], m.zones[index(zone - 1)].side[1]);
  return m;
}

namespace {

// Along `axis`, 0 or 1, and turned round with it.
void reflect_ends(const std::vector<End>& from, std::vector<End>& to, const Range& r, int32_t f, int axis) {
  for (int32_t e = r.first; e <= r.last; ++e)
    for (int32_t l = 0; l < f; ++l) {
      End end = from[index((e - 1) * f + l)];
      end.values[axis] = -end.values[axis], end.values[2 + axis] = -end.values[2 + axis];
      to[index((r.first + r.last - e - 1) * f + f - 1 - l)] = end;
    }
}

Body reflected_body(const Body& b, int32_t f, int axis) {
  Body q = b;
  for (size_t k = 0; k < b.regions.size(); ++k) {
    const Range& r = b.regions[k];
    const bool open = static_cast<int32_t>(k) < b.open_regions;
    const int32_t per = b.element_nodes - 1, base = node_of(b, r.first, 0, per) - 1, n = (r.last - r.first + 1) * per;
    for (int32_t i = 0; i < n + (open ? 1 : 0); ++i) {
      const size_t here = index(2 * (base + i)), there = index(2 * (base + (open ? n - i : (n - i) % n)));
      for (size_t c = 0; c < 2; ++c) q.xy[there + c] = static_cast<int>(c) == axis ? -b.xy[here + c] : b.xy[here + c];
    }
    reflect_ends(b.ends, q.ends, r, f, axis);
    if (!b.second.empty()) reflect_ends(b.second, q.second, r, f, axis);
  }
  q.sides.clear(); // sides keep their numbers, elements do not
  for (const Range& s : b.sides) {
    const Range& r = region_of(b, s.first);
    q.sides.push_back({r.first + r.last - s.last, r.first + r.last - s.first});
  }
  for (double* x : {&q.motion[axis], &q.motion[2], &q.load[axis], &q.load[2], &q.point[axis], &q.force[axis]}) *x = -*x;
  return q;
}

Model reflected_along(const Model& m, int axis) {
  Model q = m;
  for (Body& b : q.bodies) b = reflected_body(b, m.function_nodes, axis);
  for (Zone& z : q.zones)
    for (Side& s : z.side) {
      const Range& r = region_of(m.body(s.body), s.first);
      s.first = r.first + r.last - s.first, s.last = r.first + r.last - s.last;
    }
  for (PointLoad& l : q.point_loads)
    for (double* x : {axis == 0 ? &l.x : &l.y, axis == 0 ? &l.fx : &l.fy}) *x = -*x;
  for (Platen& p : q.platens) {
    const Range& r = region_of(m.body(p.side.body), p.side.first);
    const int32_t first = r.first + r.last - p.side.last;
    p.side.last = r.first + r.last - p.side.first, p.side.first = first;
    p.point[axis] = -p.point[axis];
    for (double* v : {p.motion, p.load, p.second_motion, p.second_load}) v[axis] = -v[axis], v[2] = -v[2];
  }
  q.symmetry_at[axis] = -q.symmetry_at[axis];
  return q;
}

} // namespace

Model reflected(const Model& m) {
  for (const Body& b : m.bodies)
    if (b.open_regions > 0) throw std::runtime_error("open curves are not reflected");
  return reflected_along(m, 0);
}
Model upside_down(const Model& m) { return reflected_along(m, 1); }

namespace {

// The number of element e of its region when they are counted from another one, if the region is closed.
int32_t counted_on(const Body& b, int32_t e, int32_t shift) {
  bool open;
  open_before(b, e, open);
  const Range& r = region_of(b, e);
  return open ? e : r.first + (e - r.first + shift) % (r.last - r.first + 1);
}

Body counted_anew(const Body& b, int32_t f, int32_t shift) {
  Body q = b;
  const int32_t per = b.element_nodes - 1;
  for (int32_t e = 1; e <= b.elements(); ++e) {
    const int32_t to = counted_on(b, e, shift);
    for (int32_t k = 0; k < per; ++k)
      for (int32_t c = 0; c < 2; ++c)
        q.xy[index(2 * (node_of(b, to, k, per) - 1) + c)] = b.xy[index(2 * (node_of(b, e, k, per) - 1) + c)];
    for (int32_t l = 0; l < f; ++l) {
      q.ends[index((to - 1) * f + l)] = b.ends[index((e - 1) * f + l)];
      if (!b.second.empty()) q.second[index((to - 1) * f + l)] = b.second[index((e - 1) * f + l)];
    }
  }
  return q; // its sides are no longer ranges
}

// False where the range could be read both ways.
bool count_on(const Body& b, Side& side, int32_t shift) {
  const int32_t count = std::abs(side.last - side.first) + 1, last = counted_on(b, side.last, shift);
  side.first = counted_on(b, side.first, shift);
  const bool whole = std::abs(last - side.first) + 1 == count;
  const Range& r = region_of(b, last);
  side.last = last, side.elements = whole ? 0 : count;
  return whole || 2 * (count - 1) != r.last - r.first + 1;
}

} // namespace

Model renumbered(const Model& m, int32_t shift) {
  for (;; ++shift) {
    Model q = m;
    bool clear = true;
    for (Body& b : q.bodies) b = counted_anew(b, m.function_nodes, shift);
    for (Zone& z : q.zones)
      for (Side& s : z.side) clear = count_on(m.body(s.body), s, shift) && clear;
    for (Platen& p : q.platens) clear = count_on(m.body(p.side.body), p.side, shift) && clear;
    if (clear) return q;
  }
}

Model in_more_steps(Model m, int32_t times) {
  for (Path& p : m.paths) p.increments *= times;
  return m;
}

Model turned(Model m, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180, c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](double* v) {
    const double x = v[0];
    v[0] = c * x - s * v[1], v[1] = s * x + c * v[1];
  };
  for (Body& b : m.bodies) {
    for (size_t i = 0; i < b.xy.size(); i += 2) turn(&b.xy[i]);
    for (std::vector<End>* ends : {&b.ends, &b.second})
      for (End& end : *ends) {
        if (end.codes[0] != end.codes[1]) throw std::runtime_error("a condition on one component cannot be turned");
        turn(end.values), turn(end.values + 2);
      }
    for (double* v : {b.motion, b.load, b.point, b.force}) turn(v);
  }
  for (PointLoad& l : m.point_loads) turn(&l.x), turn(&l.fx);
  for (Platen& p : m.platens)
    for (double* v : {p.point, p.motion, p.load, p.second_motion, p.second_load}) turn(v);
  return m;
}

Model scaled(Model m, double length, double stress) {
  const double force = stress * length * (m.plane == C2D_AXISYMMETRIC ? length : 1); // per thickness, or of the whole ring
  for (Body& b : m.bodies) {
    b.youngs_modulus *= stress;
    for (double& x : b.xy) x *= length;
    for (std::vector<End>* ends : {&b.ends, &b.second})
      for (End& end : *ends)
        for (int k = 0; k < 4; ++k) end.values[k] *= k < 2 ? stress : length;
    for (int c = 0; c < 2; ++c) {
      b.motion[c] *= length, b.point[c] *= length;
      b.load[c] *= force, b.force[c] *= stress / length;
    }
    b.spin *= stress / (length * length);
    b.load[2] *= force * length;
  }
  for (PointLoad& l : m.point_loads) l.x *= length, l.y *= length, l.fx *= force, l.fy *= force;
  for (Platen& p : m.platens) {
    for (int c = 0; c < 2; ++c) {
      p.point[c] *= length, p.motion[c] *= length, p.second_motion[c] *= length;
      p.load[c] *= force, p.second_load[c] *= force;
    }
    p.load[2] *= force * length, p.second_load[2] *= force * length;
  }
  for (double& at : m.symmetry_at) at *= length;
  return m;
}

// ---- comparison

namespace {

// b's row of the same zone at the place of a row of a.
const Row& partner(const Row& row, const Step& b, const Mapping& map) {
  double x = row[C2D_X], y = row[C2D_Y];
  if (map.place) map.place(x, y);
  const int32_t zone = static_cast<int32_t>(row[C2D_PAIR_ZONE]), there = map.zone.empty() ? zone : map.zone[index(zone - 1)];
  const Row* best = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Row& other : b.rows) {
    if (static_cast<int32_t>(other[C2D_PAIR_ZONE]) != there) continue;
    const double distance = std::hypot(other[C2D_X] - x, other[C2D_Y] - y);
    if (distance < nearest) nearest = distance, best = &other;
  }
  if (!best) throw std::runtime_error("no such pair in the other model");
  return *best;
}

// Displacements in one frame: those of side 1 and side 2, along a's n and t.
struct Motion {
  double n[2], t[2];
};
Motion motion_of(const Row& r) { return {{r[C2D_UN1], r[C2D_UN2]}, {r[C2D_UT1], r[C2D_UT2]}}; }
// b's in a's frame. Normals that are opposed (after the mapping of places) tell that the sides are swapped.
Motion motion_in(const Row& a, const Row& b, const Mapping& map) {
  Motion m = motion_of(b);
  double x = 0, y = 0, nx = a[C2D_NX], ny = a[C2D_NY];
  if (map.place) map.place(x, y), map.place(nx, ny);
  const bool swapped = (nx - x) * b[C2D_NX] + (ny - y) * b[C2D_NY] < 0;
  if (swapped) {
    std::swap(m.n[0], m.n[1]), std::swap(m.t[0], m.t[1]);
    for (int k = 0; k < 2; ++k) m.n[k] = -m.n[k], m.t[k] = -m.t[k];
  }
  for (int k = 0; k < 2; ++k) m.n[k] /= map.length, m.t[k] *= map.tangential / map.length;
  return m;
}

std::vector<const Step*> recorded(const Result& r, int32_t every = 1) {
  std::vector<const Step*> out;
  int32_t count = 0;
  for (const Step& s : r.steps)
    if (s.kind != C2D_STEP_CHANGE && ++count % every == 0) out.push_back(&s);
  return out;
}

struct Sizes {
  double p = 0, u = 0, dp = 0, du = 0, energy = 0, de = 0;
  int statuses = 0;
  double worst() const { return std::max({p > 0 ? dp / p : dp, u > 0 ? du / u : du, energy > 0 ? de / energy : de}); }
};

void compare_rows(const Row& a, const Row& b, const Mapping& map, Sizes& size) {
  if (a[C2D_STATUS] != b[C2D_STATUS]) ++size.statuses;
  size.p = std::max(size.p, larger(a[C2D_TN], a[C2D_TT]));
  size.dp = std::max(size.dp, larger(a[C2D_TN] - b[C2D_TN] / map.stress, a[C2D_TT] - map.tangential * b[C2D_TT] / map.stress));
  const Motion x = motion_of(a), y = motion_in(a, b, map);
  for (int k = 0; k < 2; ++k) {
    size.u = std::max(size.u, larger(x.n[k], x.t[k]));
    size.du = std::max(size.du, larger(x.n[k] - y.n[k], x.t[k] - y.t[k]));
  }
  size.du = std::max(
      size.du, larger(a[C2D_GAP] - b[C2D_GAP] / map.length, a[C2D_SLIP_SUM] - map.tangential * b[C2D_SLIP_SUM] / map.length));
}

Sizes compare(const Result& a, const Result& b, const Mapping& map) {
  const std::vector<const Step*> x = recorded(a), y = recorded(b, map.every);
  if (x.empty() || x.size() != y.size())
    throw std::runtime_error("different numbers of steps: " + std::to_string(x.size()) + " and " + std::to_string(y.size()) +
                             "\n" + a.messages() + b.messages());
  Sizes size;
  size.p = map.least.pressure, size.u = map.least.displacement, size.energy = map.least.energy;
  for (size_t i = 0; i < x.size(); ++i) {
    if (x[i]->rows.size() != y[i]->rows.size()) throw std::runtime_error("different numbers of pairs");
    for (const Row& row : x[i]->rows) compare_rows(row, partner(row, *y[i], map), map, size);
    const double unit = map.stress * std::pow(map.length, map.dimensions);
    const double from[3] = {x[i]->work, x[i]->dissipated, x[i]->elastic}, to[3] = {y[i]->work, y[i]->dissipated, y[i]->elastic};
    for (int k = 0; k < 3; ++k) {
      size.energy = std::max(size.energy, std::fabs(from[k]));
      size.de = std::max(size.de, std::fabs(from[k] - to[k] / unit));
    }
  }
  return size;
}

} // namespace

double difference(const Result& a, const Result& b, const Mapping& map) { return compare(a, b, map).worst(); }
double status_differences(const Result& a, const Result& b, const Mapping& map) { return compare(a, b, map).statuses; }

// ---- laws

namespace {
// Magnitudes of the tractions along a body, summed; of a body of revolution, all round.
double pull_on(const Model& m, const std::vector<EndResult>& ends) {
  const size_t f = index(m.function_nodes);
  double sum = 0;
  for (size_t e = 0; e + f <= ends.size(); e += f) {
    const EndResult &one = ends[e], &two = ends[e + f - 1];
    const double round = m.plane == C2D_AXISYMMETRIC ? std::acos(-1.0) * (one.x + two.x) : 1;
    sum += 0.5 * (std::hypot(one.tx, one.ty) + std::hypot(two.tx, two.ty)) * std::hypot(two.x - one.x, two.y - one.y) * round;
  }
  return sum;
}

struct Largest {
  double p = 0, u = 0; // tractions and displacements of pairs
};
Largest largest_of(const Result& r) {
  Largest out;
  for (const Step& s : r.steps)
    for (const Row& row : s.rows) {
      out.p = std::max(out.p, larger(row[C2D_TN], row[C2D_TT]));
      out.u = std::max({out.u, larger(row[C2D_UN1], row[C2D_UT1]), larger(row[C2D_UN2], row[C2D_UT2])});
    }
  return out;
}

// Does something of this component pass through a line of symmetry or the axis, which is not among the results?
bool is_open(const Model& m, int k) {
  if (m.plane == C2D_AXISYMMETRIC && k != 1) return true;
  return k == 2 ? m.symmetry != 0 : (m.symmetry >> k & 1) != 0;
}
} // namespace

Least least_sizes(const Model& m, const Result& r) {
  double stiff = 0;
  for (const Body& b : m.bodies)
    if (b.rigid == 0) stiff = std::max(stiff, b.youngs_modulus);
  Least out;
  out.displacement = 1e-7 * m.scale();
  const double u = std::max(largest_of(r).u, out.displacement);
  out.pressure = 1e-4 * stiff * u / m.scale();
  out.energy = out.pressure * u * std::pow(m.scale(), m.plane == C2D_AXISYMMETRIC ? 2 : 1);
  return out;
}

double imbalance(const Model& m, const Result& r) {
  double force = 0, worst = 0;
  const double arm = m.scale();
  for (const c2d_body_result& b : r.bodies)
    force = std::max({force, std::hypot(b.applied[0], b.applied[1]), std::hypot(b.contact[0], b.contact[1])});
  for (const std::vector<EndResult>& ends : r.boundary) force = std::max(force, pull_on(m, ends));
  const double pressure =
      0.1 * std::max(largest_of(r).p, least_sizes(m, r).pressure); // forces that were there before the loads went back to zero
  force = std::max(force, pressure * arm * (m.plane == C2D_AXISYMMETRIC ? arm : 1));
  for (const c2d_body_result& b : r.bodies)
    for (int k = 0; k < 3; ++k)
      if (!is_open(m, k)) worst = std::max(worst, std::fabs(b.applied[k] + b.contact[k]) / (k == 2 ? arm : 1));
  return force > 0 ? worst / force : worst;
}

namespace {
std::string fault(const Step& s, const Row& row, const char* what, double value) {
  char text[200];
  std::snprintf(text, sizeof text, "load %.6g, zone %.0f at (%.6g, %.6g): %s (%.3e)", s.load, row[C2D_PAIR_ZONE], row[C2D_X],
                row[C2D_Y], what, value);
  return text;
}
} // namespace

std::string breach(const Model& m, const Result& r, double tolerance) {
  const Largest largest = largest_of(r);
  const Least least = least_sizes(m, r);
  const double p = tolerance * std::max(largest.p, least.pressure), u = tolerance * std::max(largest.u, least.displacement);
  for (const Step& s : r.steps)
    for (const Row& row : s.rows) {
      const size_t zone = index(static_cast<int32_t>(row[C2D_PAIR_ZONE]) - 1);
      const Zone z = zone < m.zones.size() ? m.zones[zone] : Zone{C2D_ZONE_TIED, {}};
      const double mu = z.mu >= 0 ? z.mu : m.friction, tn = row[C2D_TN], tt = row[C2D_TT], gap = row[C2D_GAP];
      const int status = static_cast<int>(row[C2D_STATUS]);
      if (((z.kind & C2D_ZONE_TIED) != 0) != (status == C2D_TIED)) return fault(s, row, "a tie and its status", status);
      if (status != C2D_OPEN && std::fabs(gap) > u) return fault(s, row, "a closed pair gapes", gap);
      if (status == C2D_TIED) continue;
      if (status == C2D_OPEN && (tn != 0 || tt != 0)) return fault(s, row, "an open pair carries a force", larger(tn, tt));
      if (gap < -u) return fault(s, row, "overlap", gap);
      if (tn < -p) return fault(s, row, "a pair pulls", tn);
      if (std::fabs(tt) > mu * tn + p) return fault(s, row, "friction beyond the cone", std::fabs(tt) - mu * tn);
      if (status == C2D_SLIP && std::fabs(std::fabs(tt) - mu * tn) > p)
        return fault(s, row, "a slipping pair is not on the cone", std::fabs(tt) - mu * tn);
    }
  return "";
}

Model rough(int32_t pairs) {
  const int32_t face = pairs - 1, rest = std::max(8, face / 16);
  const auto height = [](double x) {
    double sum = 0;
    for (int wave = 20; wave < 80; ++wave)
      sum += 1e-3 * std::pow(wave, -1.3) * std::cos(2 * 3.141592653589793 * wave * x + wave * wave);
    return sum;
  };
  double lowest = height(0);
  for (int32_t i = 0; i <= face; ++i) lowest = std::min(lowest, height(static_cast<double>(i) / face));
  Model m;
  for (const bool upper : {false, true}) {
    Body body;
    const auto side = [&](double x0, double y0, double x1, double y1, int32_t count, bool contact) {
      for (int32_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / count, x = x0 + (x1 - x0) * t, y = y0 + (y1 - y0) * t;
        body.xy.insert(body.xy.end(), {x, contact && upper ? height(x) - lowest + 1e-9 : y});
      }
    };
    const double low = upper ? 0 : -1, high = upper ? 1 : 0;
    side(0, low, 1, low, face, upper), side(1, low, 1, high, rest, false);
    side(1, high, 0, high, face, !upper), side(0, high, 0, low, rest, false);
    if (upper) body.xy[2 * static_cast<size_t>(face) + 1] = height(1) - lowest + 1e-9;
    const int32_t count = 2 * (face + rest);
    body.regions.push_back({1, count});
    body.ends.resize(2 * static_cast<size_t>(count));
    body.sides = {{1, face}, {face + 1, face + rest}, {face + rest + 1, 2 * face + rest}, {2 * face + rest + 1, count}};
    m.add(body);
  }
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of("1100", 0, 0, 0, -1.5e-4));
  const Range lower = m.side(1, 3), top = m.side(2, 1);
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, lower.first, lower.last}, {2, top.last, top.first}}});
  m.friction = 0.3;
  return m;
}

Model pressed_layers(int32_t layers, double t, int32_t kind, int32_t n) {
  Model m;
  m.function_nodes = 3;
  m.add(rectangle(0, 0, 1, 1, {n, n / 2, n, n / 2}, 1000, 0));
  for (int32_t i = 0; i < layers; ++i) m.add(rectangle(0, 1 + t * i, 1, 1 + t * (i + 1), {n, 1, n, 1}, 500, 0));
  m.add(rectangle(0, 1 + t * layers, 1, 2 + t * layers, {n, n / 2, n, n / 2}, 2000, 0));
  for (Body& b : m.bodies) b.ends.assign(static_cast<size_t>(b.elements() * 3), End());
  m.set(1, 1, end_of(kHeld));
  m.set(layers + 2, 3, end_of(kPulled, 0, -1));
  for (int32_t b = 1; b <= layers + 1; ++b) m.join(kind, b, 3, b + 1, 1);
  m.friction = 0.5;
  return m;
}

} // namespace many
