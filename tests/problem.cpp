#include "problem.hpp"

#include "c2d_memory.h"
#include "c2d_posix.h"
#include "c2d_stdio.h"
#include "c2d_threads.h"
#include "paths.hpp"
#include "room.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace problem {

namespace {

size_t index(int64_t i) { return static_cast<size_t>(i); }

int32_t nodes_per_element(int32_t function_nodes) { return function_nodes == 1 ? 1 : function_nodes - 1; }

struct Cards {
  const std::string* text;
  size_t at = 0;
};
int32_t read_card(void* context, char* out, int32_t size) {
  Cards& cards = *static_cast<Cards*>(context);
  if (cards.at >= cards.text->size()) return -1;
  size_t end = cards.text->find('\n', cards.at);
  if (end == std::string::npos) end = cards.text->size();
  const size_t length = end - cards.at, fits = std::min(length, index(size - 1));
  cards.text->copy(out, fits, cards.at);
  out[fits] = '\0';
  cards.at = end + 1;
  return static_cast<int32_t>(length);
}

void keep_entry(void* context, const c2d_error* entry) { static_cast<Result*>(context)->told.push_back(*entry); }

int32_t keep_step(void* context, const c2d_step* now) {
  Step step{now->kind, now->coefficient, now->step,       now->changes, now->iterations,   now->outcome, now->mu, now->load,
            {},        now->work,        now->dissipated, now->elastic, now->energy_defect};
  for (int32_t p = 0; p < now->pairs; ++p)
    step.table.insert(step.table.end(), now->table + p * now->stride, now->table + p * now->stride + C2D_PAIR_FIELDS);
  if (now->cases > 1) step.second = now->loads[1];
  static_cast<Result*>(context)->steps.push_back(step);
  return 0;
}

// The three stores; files live in a folder of their own that goes with this.
struct Storage {
  std::string folder;
  test::Room region;
  c2d_memory_store memory = {};
  c2d_stdio_store stdio = {};
  c2d_posix_store posix = {};
  Store kind;

  Storage(Store which, uint64_t bytes, c2d_port& port) : kind(which) {
    if (kind == Store::memory) {
      region.resize(bytes);
      c2d_memory_store_init(&memory, region.data(), bytes);
      c2d_memory_store_port(&memory, &port);
      return;
    }
    char name[] = "/tmp/c2d_test_XXXXXX";
    if (!mkdtemp(name)) throw std::runtime_error("no temporary folder");
    folder = name;
    if (kind == Store::stdio) {
      c2d_stdio_store_init(&stdio, name);
      c2d_stdio_store_port(&stdio, &port);
    } else {
      if (c2d_posix_store_init(&posix, name) != 0) throw std::runtime_error("cannot lock the temporary folder");
      c2d_posix_store_port(&posix, &port);
    }
  }
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;
  ~Storage() {
    if (kind == Store::stdio) {
      c2d_stdio_store_remove(&stdio);
      rmdir(folder.c_str());
    } else if (kind == Store::posix) {
      c2d_posix_store_remove(&posix);
      c2d_posix_store_discard(&posix, folder.c_str());
    }
  }
};

host::Limits limits_of(const Problem& p) {
  host::Limits limits;
  limits.bodies = static_cast<int32_t>(p.bodies.size());
  limits.function_nodes = p.function_nodes;
  for (size_t b = 0; b < p.bodies.size(); ++b) {
    limits.body[b].points = static_cast<int32_t>(p.bodies[b].xy.size() / 2);
    limits.body[b].elements = p.elements(static_cast<int>(b) + 1);
    limits.body[b].regions = static_cast<int32_t>(p.bodies[b].regions.size());
  }
  if (p.two_cases()) limits.load_cases = 2;
  if (p.motions.size() > 1) limits.load_cases = static_cast<int32_t>(p.motions.size());
  if (p.interference > 1) limits.load_cases = p.interference;
  for (const BodyForce& f : p.body_forces)
    if (f.load_case > limits.load_cases) limits.load_cases = f.load_case;
  limits.zones = static_cast<int32_t>(p.zones.size());
  for (const Zone& z : p.zones) {
    limits.pairs += z.pairs;
    limits.contact_elements += z.elements;
  }
  limits.zones += static_cast<int32_t>(p.free_zones.size());
  for (const FreeZone& z : p.free_zones) {
    const int32_t elements = z.elements[1] > 0 ? z.elements[1] : std::abs(z.last_element[1] - z.first_element[1]) + 1;
    const int32_t pairs = p.function_nodes > 1 ? elements * (p.function_nodes - 1) + 1 : elements;
    limits.pairs += pairs;
    limits.free_pairs += pairs;
    limits.contact_elements += elements;
  }
  limits.point_loads = static_cast<int32_t>(p.point_loads.size());
  limits.coefficients = static_cast<int32_t>(p.friction.size());
  limits.paths = static_cast<int32_t>(p.paths.size());
  return limits;
}

c2d_status feed_body(c2d_solver* s, const Problem& p, int32_t number) {
  const Body& body = p.bodies[index(number - 1)];
  c2d_body data = C2D_INIT(c2d_body);
  data.element_nodes = body.element_nodes;
  data.elements = p.elements(number);
  data.regions = static_cast<int32_t>(body.regions.size());
  data.open_regions = body.open_regions;
  data.youngs_modulus = body.youngs_modulus;
  data.poisson_ratio = body.poisson_ratio;
  c2d_status status = c2d_set_body(s, number, &data);
  for (const Range& r : body.regions)
    if (status == C2D_OK) status = c2d_add_region(s, number, r.first, r.last);
  if (status == C2D_OK) status = c2d_set_nodes(s, number, 1, static_cast<int32_t>(body.xy.size() / 2), body.xy.data(), 2);
  for (size_t i = 0; i < body.ends.size() && status == C2D_OK; ++i) {
    const int32_t end = static_cast<int32_t>(i);
    status = c2d_set_condition(s, number, end / p.function_nodes + 1, end % p.function_nodes + 1, 1, body.ends[i].codes,
                               body.ends[i].values);
    if (status == C2D_OK && !body.second_case.empty())
      status = c2d_set_condition(s, number, end / p.function_nodes + 1, end % p.function_nodes + 1, 2,
                                 body.second_case[i].codes, body.second_case[i].values);
  }
  return status;
}

constexpr double kOrigin[2] = {0, 0};

c2d_status add_zone(c2d_solver* s, const Zone& z) {
  c2d_zone zone = C2D_INIT(c2d_zone);
  zone.pairs = z.pairs;
  zone.side1 = {1, z.first_element[0], z.last_element[0], z.elements, z.first_node[0], z.last_node[0]};
  zone.side2 = {2, z.first_element[1], z.last_element[1], z.elements, z.first_node[1], z.last_node[1]};
  return c2d_add_zone(s, &zone);
}

c2d_status add_zone(c2d_solver* s, const FreeZone& z) {
  c2d_zone zone = C2D_INIT(c2d_zone);
  zone.kind = C2D_ZONE_FREE;
  zone.side1 = {1, z.first_element[0], z.last_element[0], z.elements[0], 0, 0};
  zone.side2 = {2, z.first_element[1], z.last_element[1], z.elements[1], 0, 0};
  return c2d_add_zone(s, &zone);
}

c2d_status feed(c2d_solver* s, const Problem& p) {
  c2d_problem data = C2D_INIT(c2d_problem);
  data.plane = p.plane;
  data.analysis = p.analysis;
  data.iteration_limit = p.iteration_limit;
  c2d_status status = c2d_set_problem(s, &data);
  for (size_t b = 0; b < p.bodies.size() && status == C2D_OK; ++b) status = feed_body(s, p, static_cast<int32_t>(b) + 1);
  for (const PointLoad& l : p.point_loads)
    if (status == C2D_OK) status = c2d_add_point_load(s, l.body, l.load_case, l.x, l.y, l.fx, l.fy);
  if (p.rigid && status == C2D_OK) status = c2d_set_rigid(s, 1, 0, nullptr, nullptr);
  for (size_t k = 0; k < p.motions.size(); ++k)
    if (status == C2D_OK) status = c2d_set_rigid(s, 1, static_cast<int32_t>(k) + 1, p.motions[k].data(), kOrigin);
  if (p.interference > 0 && status == C2D_OK) status = c2d_set_interference(s, p.interference);
  for (const BodyForce& f : p.body_forces) {
    const double force[2] = {f.bx, f.by}, axis[2] = {f.x0, f.y0};
    if (status == C2D_OK) status = c2d_set_body_force(s, f.body, f.load_case, force, f.rho_omega2, axis);
  }
  for (const Zone& z : p.zones)
    if (status == C2D_OK) status = add_zone(s, z);
  for (const FreeZone& z : p.free_zones)
    if (status == C2D_OK) status = add_zone(s, z);
  for (double mu : p.friction)
    if (status == C2D_OK) status = c2d_add_friction(s, mu);
  for (const Path& path : p.paths) {
    std::vector<double> factors(index(std::max(2, limits_of(p).load_cases)));
    factors[0] = path.load, factors[1] = path.second;
    if (status == C2D_OK) status = c2d_add_path(s, path.increments, factors.data(), std::max(1, limits_of(p).load_cases));
  }
  for (int32_t axis = 0; axis < 2; ++axis)
    if (status == C2D_OK && (p.symmetry >> axis & 1) != 0) status = c2d_set_symmetry(s, axis, p.symmetry_at[axis]);
  return status == C2D_OK ? c2d_complete(s) : status;
}

c2d_status fetch_boundary(c2d_solver* s, const host::Summary& summary, host::OfBodies<std::vector<EndResult>>& boundary) {
  c2d_status status = C2D_OK;
  if (summary.bodies > 2) boundary.resize(index(summary.bodies));
  for (int32_t b = 1; b <= summary.bodies; ++b) {
    const int32_t count = summary.body[b - 1].elements * summary.function_nodes;
    std::vector<double> field[8];
    for (int i = 0; i < 8 && status == C2D_OK; ++i) {
      field[i].resize(index(count));
      status = c2d_get(s, C2D_END_X + i, b, 1, count, field[i].data(), 1);
    }
    if (status != C2D_OK) return status;
    for (int32_t i = 0; i < count; ++i) {
      const size_t k = index(i);
      boundary[b - 1].push_back({i / summary.function_nodes + 1, static_cast<int32_t>(field[2][k]),
                                 static_cast<int32_t>(field[7][k]), field[0][k], field[1][k], field[3][k], field[4][k],
                                 field[5][k], field[6][k]});
    }
  }
  return status;
}

c2d_status follow_loads(c2d_solver* s, const Setup& setup, Result& r) {
  c2d_status status = c2d_begin(s, &setup.advance_mu, 1);
  int32_t number = 0;
  const int32_t cases = setup.advance_second.empty() ? 1 : 2;
  for (size_t i = 0; i < setup.advance_loads.size(); ++i) {
    if (status != C2D_OK) return status;
    const double load[2] = {setup.advance_loads[i], cases == 2 ? setup.advance_second[i] : 0.0};
    status = c2d_advance(s, load, cases, &r.outcome);
    host::get_summary(s, r.summary);
    Step step{C2D_STEP_RECORDED,
              1,
              ++number,
              0,
              0,
              r.outcome,
              setup.advance_mu,
              r.summary.load,
              {},
              r.summary.work,
              r.summary.dissipated,
              r.summary.elastic,
              r.summary.energy_defect};
    if (r.outcome != C2D_REACHED) step.kind = C2D_STEP_STOPPED;
    step.table.resize(index(r.summary.pairs * C2D_PAIR_FIELDS));
    for (int32_t field = 0; field < C2D_PAIR_FIELDS && r.summary.pairs > 0 && status == C2D_OK; ++field)
      status = c2d_get(s, field, 0, 1, r.summary.pairs, step.table.data() + field, C2D_PAIR_FIELDS);
    if (cases == 2) step.second = load[1];
    if (setup.boundaries && status == C2D_OK) {
      const c2d_status fetched = fetch_boundary(s, r.summary, step.boundary);
      if (r.outcome == C2D_REACHED) status = fetched; // else there may be nothing to be had
    }
    r.steps.push_back(step);
    if (r.outcome != C2D_REACHED && !setup.go_on) break;
  }
  return status;
}

c2d_status follow(c2d_solver* s, const Setup& setup, Result& r) {
  c2d_status status = c2d_prepare(s);
  if (status != C2D_OK) return status;
  if (setup.advance_loads.empty() || setup.begin_after_run) {
    for (int i = 0; i < setup.runs && status == C2D_OK; ++i) {
      r.steps.clear();
      status = c2d_run(s, keep_step, &r);
    }
    if (status != C2D_OK) return status;
    host::get_summary(s, r.summary);
    r.outcome = r.summary.outcome;
  }
  if (!setup.advance_loads.empty()) {
    r.steps.clear();
    status = follow_loads(s, setup, r);
    if (status != C2D_OK) return status;
  }
  host::get_summary(s, r.summary);
  const bool stopped = r.outcome != C2D_REACHED;
  status = fetch_boundary(s, r.summary, r.boundary);
  if (!setup.points.empty() && status == C2D_OK) {
    const size_t count = setup.points.size() / 2;
    r.interior.resize(count * C2D_POINT_FIELDS);
    status = c2d_interior(s, 0, static_cast<int32_t>(count), setup.points.data(), 2, r.interior.data(), C2D_POINT_FIELDS);
  }
  if (r.summary.bodies > 2) r.indicators.resize(index(r.summary.bodies));
  for (int32_t b = 1; setup.indicators && b <= r.summary.bodies && status == C2D_OK; ++b) {
    const int32_t elements = r.summary.body[b - 1].elements;
    r.indicators[b - 1].resize(index(elements) * C2D_OFF_FIELDS);
    status = c2d_indicators(s, b, 1, elements, r.indicators[b - 1].data(), C2D_OFF_FIELDS);
  }
  if (stopped && status != C2D_OK) status = C2D_OK; // nothing to be had before anything touches
  host::get_summary(s, r.summary);
  return status;
}

using Feeder = test::Callable<c2d_status(c2d_solver*)>;

Result solve_with(const host::Limits& wanted, const Setup& setup, const Feeder& feeder, Problem* keep);

// What the model holds, asked back from the solver.
void capture(c2d_solver* s, Problem& p) {
  host::Summary sum;
  host::get_summary(s, sum);
  p.plane = sum.plane, p.analysis = sum.analysis, p.iteration_limit = sum.iteration_limit;
  p.function_nodes = sum.function_nodes;
  for (int32_t b = 1; b <= sum.bodies; ++b) {
    Body body;
    body.element_nodes = sum.body[b - 1].element_nodes;
    body.youngs_modulus = sum.body[b - 1].youngs_modulus;
    body.poisson_ratio = sum.body[b - 1].poisson_ratio;
    body.xy.resize(index(2 * sum.body[b - 1].points));
    c2d_get(s, C2D_NODE_X, b, 1, sum.body[b - 1].points, body.xy.data(), 2);
    c2d_get(s, C2D_NODE_Y, b, 1, sum.body[b - 1].points, body.xy.data() + 1, 2);
    for (int32_t i = 1; i <= sum.body[b - 1].regions; ++i) {
      Range range = {0, 0};
      c2d_get_region(s, b, i, &range.first, &range.last);
      body.regions.push_back(range);
    }
    for (int32_t e = 1; e <= sum.body[b - 1].elements; ++e)
      for (int32_t l = 1; l <= sum.function_nodes; ++l) {
        End end;
        c2d_get_condition(s, b, e, l, 1, end.codes, end.values);
        for (int k = 0; k < 4; ++k)
          if (end.codes[k] != 0) end.values[k] = 0;
        body.ends.push_back(end);
      }
    p.bodies.push_back(body);
  }
  for (int32_t i = 1;; ++i) {
    PointLoad l;
    double xy[2], force[2];
    if (c2d_get_point_load(s, i, &l.body, &l.load_case, xy, force) != C2D_OK) break;
    l.x = xy[0], l.y = xy[1], l.fx = force[0], l.fy = force[1];
    p.point_loads.push_back(l);
  }
  for (int32_t i = 1; i <= sum.zones; ++i) {
    c2d_zone z = C2D_INIT(c2d_zone);
    c2d_get_zone(s, i, &z);
    p.zones.push_back({z.pairs,
                       z.side1.elements,
                       {z.side1.first_element, z.side2.first_element},
                       {z.side1.last_element, z.side2.last_element},
                       {z.side1.first_node, z.side2.first_node},
                       {z.side1.last_node, z.side2.last_node}});
  }
  p.friction.resize(index(sum.coefficients));
  for (int32_t i = 1; i <= sum.coefficients; ++i) c2d_get_friction(s, 0, i, &p.friction[index(i - 1)]);
  p.paths.resize(index(sum.paths));
  for (int32_t i = 1; i <= sum.paths; ++i)
    c2d_get_path(s, i, &p.paths[index(i - 1)].increments, &p.paths[index(i - 1)].load, 1);
}

namespace {

Result solve_once(const host::Limits& wanted, const Setup& setup, const Feeder& feeder, Problem* keep) {
  Result r;
  host::Limits limits = wanted;
  limits.panel_columns = setup.panel_columns;
  uint64_t minimum = 0, in_core = 0;
  r.status = c2d_memory_need(&limits, &minimum, &in_core, nullptr);
  if (r.status != C2D_OK) return r;
  r.minimum_bytes = minimum;
  uint64_t bytes = setup.memory == Memory::minimum   ? minimum
                   : setup.memory == Memory::between ? (minimum + in_core) / 2
                                                     : std::max(minimum, in_core);
  if (setup.bytes != 0) bytes = setup.bytes;
  test::Room workspace(bytes);
  c2d_port port = C2D_INIT(c2d_port);
  // The log's context is the store's, so the store's functions get at theirs through this.
  struct Both {
    c2d_port store;
    Result* result;
    clock_t last; // moment for the run to end, 0: none
    c2d_threads pool;
  } both = {C2D_INIT(c2d_port), &r, 0, {}};
  if (setup.seconds > 0) both.last = clock() + static_cast<clock_t>(setup.seconds * CLOCKS_PER_SEC);
  const uint64_t room = 4 * in_core + (8u << 20);
  Storage storage(setup.store, room, both.store);
  port.context = &both;
  port.open = [](void* c, int32_t t, uint64_t n, uint64_t size) {
    const c2d_port& p = static_cast<Both*>(c)->store;
    return p.open(p.context, t, n, size);
  };
  port.read = [](void* c, int32_t t, uint64_t k, void* d, uint64_t n) {
    const c2d_port& p = static_cast<Both*>(c)->store;
    return p.read(p.context, t, k, d, n);
  };
  port.write = [](void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
    const c2d_port& p = static_cast<Both*>(c)->store;
    return p.write(p.context, t, k, d, n);
  };
  port.sync = [](void* c, int32_t t) {
    const c2d_port& p = static_cast<Both*>(c)->store;
    return p.sync(p.context, t);
  };
  port.close = [](void* c, int32_t t) {
    const c2d_port& p = static_cast<Both*>(c)->store;
    return p.close(p.context, t);
  };
  port.log = [](void* c, const c2d_error* e) { keep_entry(static_cast<Both*>(c)->result, e); };
  port.cancel = [](void* c) -> int32_t {
    const Both* b = static_cast<Both*>(c);
    return b->last != 0 && clock() > b->last;
  };
  struct Threads { // ended on every way out
    c2d_threads* pool;
    ~Threads() {
      if (pool) c2d_threads_stop(pool);
    }
  } threads = {nullptr};
  if (setup.threads > 1) {
    if (c2d_threads_start(&both.pool, setup.threads) != 0) throw std::runtime_error("no threads");
    threads.pool = &both.pool;
    port.threads = setup.threads;
    port.parallel_for = [](void* c, int32_t n, void (*task)(void*, int32_t), void* argument) {
      c2d_threads_run(&static_cast<Both*>(c)->pool, n, task, argument);
    };
  }
  c2d_solver* s = nullptr;
  c2d_error why = C2D_INIT(c2d_error);
  r.status = c2d_create(&s, workspace.data(), workspace.size(), &limits, &port, &why);
  if (r.status != C2D_OK) {
    r.told.push_back(why);
    return r;
  }
  c2d_options options = C2D_INIT(c2d_options);
  options.quadrature = setup.quadrature;
  options.stepping = setup.stepping;
  options.every_change = setup.every_change;
  options.symmetry = setup.symmetry;
  r.status = c2d_set_options(s, &options);
  if (r.status == C2D_OK) r.status = feeder(s);
  if (r.status == C2D_OK && keep) capture(s, *keep);
  if (r.status == C2D_OK && !keep) r.status = follow(s, setup, r);
  if (r.status != C2D_OK) {
    c2d_error last = C2D_INIT(c2d_error);
    c2d_last_error(s, &last);
    r.told.push_back(last);
  }
  c2d_close(s);
  return r;
}

} // namespace

// In the least memory slender bodies upon each other are refused, with the bytes that would do: a host makes room for them.
Result solve_with(const host::Limits& wanted, const Setup& setup, const Feeder& feeder, Problem* keep) {
  const Result first = solve_once(wanted, setup, feeder, keep);
  if (setup.memory != Memory::minimum || first.status != C2D_ERR_MEMORY || first.told.back().bytes_needed <= 0) return first;
  Setup more = setup;
  more.bytes = static_cast<uint64_t>(first.told.back().bytes_needed);
  return solve_once(wanted, more, feeder, keep);
}

host::Limits deck_limits(const std::string& text) {
  Cards cards{&text};
  host::Limits limits;
  c2d_error why = C2D_INIT(c2d_error);
  if (c2d_scan_deck(read_card, &cards, &limits, &why) != C2D_OK) throw std::runtime_error(why.text);
  return limits;
}

} // namespace

// ---- the problem
// ------------------------------------------------------------------------------------------------

int32_t Problem::elements(int body) const {
  const Body& b = bodies[index(body - 1)];
  return (static_cast<int32_t>(b.xy.size()) / 2 - b.open_regions) / (b.element_nodes - 1);
}
int32_t Problem::pairs() const {
  int32_t sum = 0;
  for (const Zone& z : zones) sum += z.pairs;
  return sum;
}
End& Problem::end(int body, int32_t element, int32_t local) {
  return bodies[index(body - 1)].ends[index((element - 1) * function_nodes + local - 1)];
}

bool Problem::two_cases() const {
  for (const Body& body : bodies)
    if (!body.second_case.empty()) return true;
  return false;
}

bool Result::warned(int32_t number) const {
  for (const c2d_error& e : told)
    if (e.status == number) return true;
  return false;
}
std::string Result::messages() const {
  std::string all;
  for (const c2d_error& e : told) all += std::to_string(e.status) + ": " + e.text + "\n";
  return all;
}
std::vector<Step> Result::recorded() const {
  std::vector<Step> out;
  for (const Step& step : steps)
    if (step.kind == C2D_STEP_RECORDED) out.push_back(step);
  return out;
}

std::string deck_text(const std::string& name) {
  std::ifstream in(paths::data() + "/decks/" + name, std::ios::binary);
  if (!in) throw std::runtime_error("no deck " + name);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

Problem from_text(const std::string& text) {
  Problem p;
  p.friction.clear();
  p.paths.clear();
  Cards cards{&text};
  const Result r = solve_with(
      deck_limits(text), Setup(), [&](c2d_solver* s) { return c2d_read_deck(s, read_card, &cards); }, &p);
  if (r.status != C2D_OK) throw std::runtime_error(r.messages());
  return p;
}
Problem load(const std::string& name) { return from_text(deck_text(name)); }

Result solve(const Problem& p, const Setup& setup) {
  return solve_with(
      limits_of(p), setup, [&](c2d_solver* s) { return feed(s, p); }, nullptr);
}
Result solve_text(const std::string& text, const Setup& setup) {
  Cards cards{&text};
  return solve_with(
      deck_limits(text), setup, [&](c2d_solver* s) { return c2d_read_deck(s, read_card, &cards); }, nullptr);
}

// ---- transformations
// --------------------------------------------------------------------------------------------

Problem scaled(Problem p, double length, double stress) {
  for (Body& body : p.bodies) {
    body.youngs_modulus *= stress;
    for (double& x : body.xy) x *= length;
    for (std::vector<End>* ends : {&body.ends, &body.second_case})
      for (End& end : *ends)
        for (int k = 0; k < 4; ++k) end.values[k] *= k < 2 ? stress : length;
  }
  for (PointLoad& l : p.point_loads) {
    l.x *= length, l.y *= length;
    l.fx *= stress * length, l.fy *= stress * length;
  }
  for (BodyForce& f : p.body_forces) {
    f.bx *= stress / length, f.by *= stress / length, f.rho_omega2 *= stress / (length * length);
    f.x0 *= length, f.y0 *= length;
  }
  return p;
}

Problem rotated(Problem p, double degrees) {
  const bool quarter = degrees == 90;
  const double angle = degrees * std::acos(-1.0) / 180, c = quarter ? 0 : std::cos(angle), s = quarter ? 1 : std::sin(angle);
  const auto turn = [&](double& x, double& y) {
    const double old = x;
    x = c * old - s * y;
    y = s * old + c * y;
  };
  for (Body& body : p.bodies) {
    for (size_t i = 0; i < body.xy.size(); i += 2) turn(body.xy[i], body.xy[i + 1]);
    for (std::vector<End>* ends : {&body.ends, &body.second_case})
      for (End& end : *ends) {
        turn(end.values[0], end.values[1]);
        turn(end.values[2], end.values[3]);
        if (quarter) {
          std::swap(end.codes[0], end.codes[1]);
          std::swap(end.codes[2], end.codes[3]);
        } else if (end.codes[0] != end.codes[1] || end.codes[2] != end.codes[3]) {
          throw std::runtime_error("a condition on a single component cannot be turned by this angle");
        }
      }
  }
  for (PointLoad& l : p.point_loads) {
    turn(l.x, l.y);
    turn(l.fx, l.fy);
  }
  for (BodyForce& f : p.body_forces) {
    turn(f.bx, f.by);
    turn(f.x0, f.y0);
  }
  return p;
}

namespace {

// A body whose element e (of a region of n, from 0) becomes element to(e, n); `flip` turns each element
// round.
struct Renumbering {
  bool flip;
  int32_t shift;

  int32_t element(int32_t e, int32_t n) const { return flip ? n - 1 - e : ((e - shift) % n + n) % n; }
  // A node of a ring with `per` nodes per element, N in all.
  int32_t node(int32_t i, int32_t n, int32_t per, bool constant) const {
    const int32_t all = n * per;
    if (constant) return element(i, n);
    return flip ? (all - i) % all : ((i - shift * per) % all + all) % all;
  }
};

Range region_of(const Body& body, int32_t element) {
  for (const Range& r : body.regions)
    if (element >= r.first && element <= r.last) return r;
  throw std::runtime_error("no such element");
}

Problem renumber(const Problem& p, const Renumbering& how) {
  Problem q = p;
  const int32_t f = p.function_nodes, per = nodes_per_element(f);
  for (size_t b = 0; b < p.bodies.size(); ++b) {
    const Body& from = p.bodies[b];
    Body& to = q.bodies[b];
    const int32_t steps = from.element_nodes - 1;
    for (const Range& r : from.regions) {
      const int32_t n = r.last - r.first + 1, base = (r.first - 1) * steps;
      for (int32_t i = 0; i < n * steps; ++i)
        for (int k = 0; k < 2; ++k)
          to.xy[index(2 * (base + how.node(i, n, steps, false)) + k)] = from.xy[index(2 * (base + i) + k)];
      for (int32_t e = 0; e < n; ++e)
        for (int32_t l = 0; l < f; ++l) {
          const size_t here = index((r.first - 1 + e) * f + l),
                       there = index((r.first - 1 + how.element(e, n)) * f + (how.flip ? f - 1 - l : l));
          to.ends[there] = from.ends[here];
          if (!from.second_case.empty()) to.second_case[there] = from.second_case[here];
        }
    }
  }
  for (Zone& z : q.zones)
    for (size_t b = 0; b < 2; ++b) {
      const Range r = region_of(p.bodies[b], z.first_element[b]);
      const int32_t n = r.last - r.first + 1, base = (r.first - 1) * per;
      for (int32_t* e : {&z.first_element[b], &z.last_element[b]}) *e = r.first + how.element(*e - r.first, n);
      for (int32_t* i : {&z.first_node[b], &z.last_node[b]}) *i = base + 1 + how.node(*i - base - 1, n, per, f == 1);
    }
  for (FreeZone& z : q.free_zones)
    for (size_t b = 0; b < 2; ++b) {
      const int32_t count = z.elements[b] > 0 ? z.elements[b] : std::abs(z.last_element[b] - z.first_element[b]) + 1;
      const int32_t way = (z.last_element[b] - z.first_element[b]) * (how.flip ? -1 : 1);
      const Range r = region_of(p.bodies[b], z.first_element[b]);
      for (int32_t* e : {&z.first_element[b], &z.last_element[b]})
        *e = r.first + how.element(*e - r.first, r.last - r.first + 1);
      z.elements[b] = z.last_element[b] - z.first_element[b] == way ? 0 : count; // round the end
    }
  return q;
}

} // namespace

Problem reflected(const Problem& p) {
  Problem q = renumber(p, {true, 0});
  for (Body& body : q.bodies) {
    for (size_t i = 0; i < body.xy.size(); i += 2) body.xy[i] = -body.xy[i];
    for (std::vector<End>* ends : {&body.ends, &body.second_case})
      for (End& end : *ends) {
        end.values[0] = -end.values[0];
        end.values[2] = -end.values[2];
      }
  }
  for (PointLoad& l : q.point_loads) {
    l.x = -l.x;
    l.fx = -l.fx;
  }
  for (BodyForce& f : q.body_forces) {
    f.bx = -f.bx;
    f.x0 = -f.x0;
  }
  return q;
}

Problem renumbered(const Problem& p, int32_t elements) { return renumber(p, {false, elements}); }

Problem exchanged(Problem p) {
  std::swap(p.bodies[0], p.bodies[1]);
  for (PointLoad& l : p.point_loads) l.body = 3 - l.body;
  for (BodyForce& f : p.body_forces) f.body = 3 - f.body;
  for (Zone& z : p.zones)
    for (int32_t* two : {z.first_element, z.last_element, z.first_node, z.last_node}) std::swap(two[0], two[1]);
  return p;
}

Problem with_paths(Problem p, const std::vector<Path>& paths) {
  p.paths = paths;
  return p;
}
Problem split(Problem p, int32_t times) {
  for (Path& path : p.paths) path.increments *= times;
  return p;
}

Problem with_functions(const Problem& p, int32_t f) {
  if (p.function_nodes != 2) throw std::runtime_error("only linear functions can be raised");
  Problem q = p;
  q.function_nodes = f;
  for (size_t b = 0; b < p.bodies.size(); ++b) {
    const std::vector<End>& from = p.bodies[b].ends;
    std::vector<End>& to = q.bodies[b].ends;
    to.clear();
    for (size_t e = 0; e < from.size() / 2; ++e)
      for (int32_t l = 0; l < f; ++l) {
        const End &first = from[2 * e], &last = from[2 * e + 1];
        const double s = f == 1 ? 0.5 : l / (f - 1.0);
        End end;
        if (f > 1 && (l == 0 || l == f - 1)) {
          end = l == 0 ? first : last;
        } else {
          for (int c = 0; c < 2; ++c) {
            const bool fixed = first.codes[2 + c] == 0 && last.codes[2 + c] == 0;
            end.codes[2 + c] = fixed ? 0 : 1;
            end.codes[c] = fixed ? 1 : 0;
            const int k = fixed ? 2 + c : c;
            end.values[k] = (1 - s) * first.values[k] + s * last.values[k];
          }
        }
        to.push_back(end);
      }
  }
  for (Zone& z : q.zones) {
    z.pairs = f == 1 ? z.elements : (z.pairs - 1) * (f - 1) + 1;
    for (int b = 0; b < 2; ++b) {
      z.first_node[b] = f == 1 ? z.first_element[b] : (z.first_node[b] - 1) * (f - 1) + 1;
      z.last_node[b] = f == 1 ? z.last_element[b] : (z.last_node[b] - 1) * (f - 1) + 1;
    }
  }
  return q;
}

Problem with_geometry(const Problem& p, int32_t element_nodes) {
  Problem q = p;
  for (size_t b = 0; b < p.bodies.size(); ++b) {
    if (p.bodies[b].element_nodes != 2) throw std::runtime_error("only linear geometry can be raised");
    const std::vector<double>& from = p.bodies[b].xy;
    Body& to = q.bodies[b];
    to.element_nodes = element_nodes;
    to.xy.clear();
    for (const Range& r : to.regions)
      for (int32_t e = r.first; e <= r.last; ++e) {
        const size_t i = index(2 * (e - 1)), j = index(2 * ((e == r.last ? r.first : e + 1) - 1));
        for (int32_t k = 0; k < element_nodes - 1; ++k) {
          const double s = k / (element_nodes - 1.0);
          to.xy.push_back((1 - s) * from[i] + s * from[j]);
          to.xy.push_back((1 - s) * from[i + 1] + s * from[j + 1]);
        }
      }
  }
  return q;
}

Problem cut_in_two(const Problem& p,
                   const test::Callable<void(int body, const double* from, const double* to, double* middle)>& place) {
  Problem q = with_functions(p, 3); // conditions in the middle
  q.function_nodes = 2;
  for (size_t b = 0; b < p.bodies.size(); ++b) {
    const Body& from = p.bodies[b];
    Body& to = q.bodies[b];
    const std::vector<End> ends = to.ends;
    to.xy.clear(), to.ends.clear(), to.regions.clear();
    for (const Range& r : from.regions) {
      to.regions.push_back({2 * r.first - 1, 2 * r.last});
      for (int32_t e = r.first; e <= r.last; ++e) {
        const double* one = &from.xy[index(2 * (e - 1))];
        const double* two = &from.xy[index(2 * ((e == r.last ? r.first : e + 1) - 1))];
        double middle[2] = {0.5 * (one[0] + two[0]), 0.5 * (one[1] + two[1])};
        place(static_cast<int>(b) + 1, one, two, middle);
        to.xy.insert(to.xy.end(), {one[0], one[1], middle[0], middle[1]});
        for (const int32_t l : {0, 1, 1, 2}) to.ends.push_back(ends[index(3 * (e - 1) + l)]);
      }
    }
  }
  for (Zone& z : q.zones) { // its nodes follow the functions
    for (int b = 0; b < 2; ++b) {
      const bool up = (z.first_element[b] <= z.last_element[b]);
      z.first_element[b] = up ? 2 * z.first_element[b] - 1 : 2 * z.first_element[b];
      z.last_element[b] = up ? 2 * z.last_element[b] : 2 * z.last_element[b] - 1;
    }
    z.elements *= 2;
  }
  return q;
}

// ---- bodies by hand
// ---------------------------------------------------------------------------------------------

namespace {
void add_region(Body& body, int32_t elements) {
  const int32_t first = body.regions.empty() ? 1 : body.regions.back().last + 1;
  body.regions.push_back({first, first + elements - 1});
}
} // namespace

void add_polygon(Body& body, const std::vector<Corner>& corners) {
  int32_t elements = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Corner &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const int32_t steps = from.elements * (body.element_nodes - 1);
    for (int32_t k = 0; k < steps; ++k) {
      body.xy.push_back(from.x + (to.x - from.x) * k / steps);
      body.xy.push_back(from.y + (to.y - from.y) * k / steps);
    }
    elements += from.elements;
  }
  add_region(body, elements);
}

void add_curve(Body& body, int32_t elements, const test::Callable<void(double, double&, double&)>& curve) {
  const int32_t points = elements * (body.element_nodes - 1);
  for (int32_t i = 0; i < points; ++i) {
    double x, y;
    curve(static_cast<double>(i) / points, x, y);
    body.xy.push_back(x);
    body.xy.push_back(y);
  }
  add_region(body, elements);
}

namespace {

struct Place {
  double x, y, dx, dy; // derivatives with respect to eta
};

// Lagrange interpolation through equally spaced points of an element.
Place element_place(const Body& body, int32_t element, double eta) {
  const int n = body.element_nodes;
  const Range r = region_of(body, element);
  int32_t shift = 0; // a point more for every open region before it
  bool open = false;
  for (int32_t i = 0; i < body.open_regions; ++i) {
    if (body.regions[index(i)].last < element) ++shift;
    open = open || body.regions[index(i)].last == r.last;
  }
  Place out = {0, 0, 0, 0};
  for (int k = 0; k < n; ++k) {
    int32_t node = (element - 1) * (n - 1) + k + shift;
    if (k == n - 1 && element == r.last && !open) node = (r.first - 1) * (n - 1) + shift;
    const double here = -1 + 2.0 * k / (n - 1);
    double value = 1, slope = 0;
    for (int j = 0; j < n; ++j) {
      if (j == k) continue;
      const double other = -1 + 2.0 * j / (n - 1);
      slope = slope * (eta - other) / (here - other) + value / (here - other);
      value *= (eta - other) / (here - other);
    }
    out.x += value * body.xy[index(2 * node)], out.y += value * body.xy[index(2 * node + 1)];
    out.dx += slope * body.xy[index(2 * node)], out.dy += slope * body.xy[index(2 * node + 1)];
  }
  return out;
}

double end_eta(int32_t function_nodes, int32_t l) { return function_nodes == 1 ? 0 : -1 + 2.0 * l / (function_nodes - 1); }

} // namespace

void set_ends(Problem& p, int number, const test::Callable<void(double, double, double, double, End&)>& set) {
  Body& body = p.bodies[index(number - 1)];
  const int32_t f = p.function_nodes;
  body.ends.assign(index(p.elements(number) * f), End());
  for (int32_t e = 1; e <= p.elements(number); ++e)
    for (int32_t l = 0; l < f; ++l) {
      const Place at = element_place(body, e, end_eta(f, l));
      const double length = std::hypot(at.dx, at.dy);
      if (length == 0) continue; // between the two of a double node
      set(at.x, at.y, at.dy / length, -at.dx / length, body.ends[index((e - 1) * f + l)]);
    }
}

// ---- comparison
// -------------------------------------------------------------------------------------------------

double Difference::worst() const { return std::max({traction, displacement1, displacement2, gap, slip}); }
void Difference::join(const Difference& o) {
  traction = std::max(traction, o.traction);
  displacement1 = std::max(displacement1, o.displacement1);
  displacement2 = std::max(displacement2, o.displacement2);
  gap = std::max(gap, o.gap);
  slip = std::max(slip, o.slip);
  statuses += o.statuses;
}

namespace {

struct Row {
  double status, tn, tt, un1, ut1, un2, ut2, gap, slip;
};
Row row_of(const Step& s, int pair, const Mapping& m) {
  const double t = m.tangential;
  Row r = {s.at(pair, C2D_STATUS),
           m.stress * s.at(pair, C2D_TN),
           t * m.stress * s.at(pair, C2D_TT),
           m.length * s.at(pair, C2D_UN1),
           t * m.length * s.at(pair, C2D_UT1),
           m.length * s.at(pair, C2D_UN2),
           t * m.length * s.at(pair, C2D_UT2),
           m.length * s.at(pair, C2D_GAP),
           t * m.length * s.at(pair, C2D_SLIP_SUM)};
  if (m.exchanged) { // n and t turn round, and with them the signs of displacements; relative quantities do
                     // not
    const Row o = r;
    r.un1 = -o.un2, r.ut1 = -o.ut2, r.un2 = -o.un1, r.ut2 = -o.ut1;
  }
  return r;
}

double max2(double a, double b) { return std::max(std::fabs(a), std::fabs(b)); }
double ratio(double difference, double size) { return difference == 0 ? 0 : difference / size; }

} // namespace

Difference compare(const Step& a, const Step& b, const Mapping& map) {
  Difference d;
  if (a.table.size() != b.table.size()) throw std::runtime_error("tables of different length");
  double traction = 0, u1 = 0, u2 = 0, gap = 0;
  double worst_traction = 0, worst1 = 0, worst2 = 0, worst_gap = 0, worst_slip = 0;
  for (int i = 0; i < a.pairs(); ++i) {
    const Row x = row_of(a, i, Mapping()), y = row_of(b, i, map);
    if (x.status != y.status) ++d.statuses;
    traction = std::max(traction, max2(x.tn, x.tt));
    u1 = std::max(u1, max2(x.un1, x.ut1));
    u2 = std::max(u2, max2(x.un2, x.ut2));
    gap = std::max(gap, std::fabs(x.gap));
    worst_traction = std::max(worst_traction, max2(x.tn - y.tn, x.tt - y.tt));
    worst1 = std::max(worst1, max2(x.un1 - y.un1, x.ut1 - y.ut1));
    worst2 = std::max(worst2, max2(x.un2 - y.un2, x.ut2 - y.ut2));
    worst_gap = std::max(worst_gap, std::fabs(x.gap - y.gap));
    worst_slip = std::max(worst_slip, std::fabs(x.slip - y.slip));
  }
  d.traction = ratio(worst_traction, traction);
  d.displacement1 = ratio(worst1, u1);
  d.displacement2 = ratio(worst2, u2);
  // Gap and slip are differences of the two bodies' displacements: round-off is that of the larger of these.
  d.gap = ratio(worst_gap, std::max({gap, u1, u2}));
  d.slip = ratio(worst_slip, std::max(u1, u2));
  return d;
}

Difference compare(const Result& a, const Result& b, const Mapping& map) {
  const std::vector<Step> x = a.recorded(), y = b.recorded();
  if (x.empty() || x.size() != y.size())
    throw std::runtime_error("different numbers of recorded steps: " + std::to_string(x.size()) + " and " +
                             std::to_string(y.size()) + "\n" + a.messages() + b.messages());
  Difference d;
  for (size_t i = 0; i < x.size(); ++i) d.join(compare(x[i], y[i], map));
  return d;
}

double boundary_difference(const Result& a, const Result& b) {
  double worst = 0;
  for (size_t body = 0; body < a.boundary.size(); ++body) {
    double u = 0, t = 0, du = 0, dt = 0;
    if (a.boundary[body].size() != b.boundary[body].size()) throw std::runtime_error("boundaries of different length");
    for (size_t i = 0; i < a.boundary[body].size(); ++i) {
      const EndResult &x = a.boundary[body][i], &y = b.boundary[body][i];
      u = std::max(u, max2(x.ux, x.uy));
      t = std::max(t, max2(x.tx, x.ty));
      du = std::max(du, max2(x.ux - y.ux, x.uy - y.uy));
      dt = std::max(dt, max2(x.tx - y.tx, x.ty - y.ty));
    }
    worst = std::max({worst, ratio(du, u), ratio(dt, t)});
  }
  return worst;
}

bool identical(const Result& a, const Result& b) {
  if (a.steps.size() != b.steps.size()) return false;
  for (size_t i = 0; i < a.steps.size(); ++i) {
    const std::vector<double>&x = a.steps[i].table, &y = b.steps[i].table;
    if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size() * sizeof(double)) != 0) return false;
  }
  for (size_t body = 0; body < a.boundary.size(); ++body) {
    if (a.boundary[body].size() != b.boundary[body].size()) return false;
    for (size_t i = 0; i < a.boundary[body].size(); ++i) {
      const EndResult &x = a.boundary[body][i], &y = b.boundary[body][i];
      if (x.ux != y.ux || x.uy != y.uy || x.tx != y.tx || x.ty != y.ty) return false;
    }
  }
  return true;
}

// ---- laws
// -------------------------------------------------------------------------------------------------------

Resultant resultant(const Problem& p, const Result& r, int number, int which) {
  // Five-point Gauss-Legendre: exact to degree 9, cubic tractions times cubic geometry times a lever fit in.
  const double point[5] = {0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
  const double weight[5] = {128.0 / 225, 0.47862867049936647, 0.47862867049936647, 0.23692688505618909, 0.23692688505618909};
  const Body& body = p.bodies[index(number - 1)];
  const int32_t f = p.function_nodes;
  Resultant sum;
  for (int32_t e = 1; e <= p.elements(number); ++e)
    for (int g = 0; g < 5; ++g) {
      const Place at = element_place(body, e, point[g]);
      const double length = std::hypot(at.dx, at.dy);
      double tx = 0, ty = 0;
      for (int32_t l = 0; l < f; ++l) {
        const EndResult& end = r.boundary[number - 1][index((e - 1) * f + l)];
        if (which != 0 && (which == 1) != (end.status >= 0)) continue;
        double shape = 1;
        for (int32_t k = 0; k < f; ++k)
          if (k != l) shape *= (point[g] - end_eta(f, k)) / (end_eta(f, l) - end_eta(f, k));
        tx += shape * end.tx;
        ty += shape * end.ty;
      }
      const double w = weight[g] * length;
      sum.fx += w * tx, sum.fy += w * ty;
      sum.moment += w * (at.x * ty - at.y * tx);
      sum.size += w * std::hypot(tx, ty);
    }
  if (which == 1) return sum;
  for (const PointLoad& l : p.point_loads) {
    if (l.body != number) continue;
    const double factor = r.summary.load;
    sum.fx += factor * l.fx, sum.fy += factor * l.fy;
    sum.moment += factor * (l.x * l.fy - l.y * l.fx);
    sum.size += factor * std::hypot(l.fx, l.fy);
  }
  return sum;
}

namespace {

std::string breach(const Step& s, int pair, const char* what, double value) {
  char text[200];
  std::snprintf(text, sizeof text, "coefficient %d step %d load %.6g pair %d: %s (%.3e)", s.coefficient, s.step, s.load,
                pair + 1, what, value);
  return text;
}

} // namespace

std::string coulomb_breach(const Problem& p, const Result& r) {
  (void)p;
  double pressure = 0, displacement = 0;
  for (const Step& s : r.steps)
    for (int i = 0; i < s.pairs(); ++i) {
      pressure = std::max(pressure, std::fabs(s.at(i, C2D_TN)));
      displacement =
          std::max({displacement, max2(s.at(i, C2D_UN1), s.at(i, C2D_UT1)), max2(s.at(i, C2D_UN2), s.at(i, C2D_UT2))});
    }
  const double small_p = 1e-9 * pressure, small_u = 1e-9 * displacement;
  for (size_t k = 0; k < r.steps.size(); ++k) {
    const Step& s = r.steps[k];
    for (int i = 0; i < s.pairs(); ++i) {
      const int status = static_cast<int>(s.at(i, C2D_STATUS));
      const double tn = s.at(i, C2D_TN), tt = s.at(i, C2D_TT), gap = s.at(i, C2D_GAP);
      const double ut = s.at(i, C2D_UT2) - s.at(i, C2D_UT1);
      if (status == C2D_OPEN) {
        if (tn != 0 || tt != 0) return breach(s, i, "an open pair carries a force", max2(tn, tt));
        if (gap < -1e-12 * displacement) return breach(s, i, "an open pair overlaps", gap);
      } else {
        if (tn < -small_p) return breach(s, i, "a closed pair pulls", tn);
        if (std::fabs(gap) > 1e-12 * displacement) return breach(s, i, "a closed pair gapes", gap);
        if (std::isfinite(s.mu) && std::fabs(tt) > s.mu * tn + small_p)
          return breach(s, i, "friction beyond the cone", std::fabs(tt) - s.mu * tn);
        if (status == C2D_SLIP && std::fabs(std::fabs(tt) - s.mu * tn) > small_p)
          return breach(s, i, "a slipping pair is not on the cone", std::fabs(tt) - s.mu * tn);
      }
      // With every change at hand, a pair of the same status at a change and at the next entry kept it in
      // between (what an event leads to is settled right after it was told): what slips is opposed, what
      // sticks stays.
      if (k == 0 || r.steps[k - 1].coefficient != s.coefficient || s.kind == C2D_STEP_STOPPED) continue;
      const Step& before = r.steps[k - 1];
      if (before.kind != C2D_STEP_CHANGE || static_cast<int>(before.at(i, C2D_STATUS)) != status) continue;
      const double ut_before = before.at(i, C2D_UT2) - before.at(i, C2D_UT1);
      const double slip = s.at(i, C2D_SLIP_SUM) - before.at(i, C2D_SLIP_SUM);
      if (status == C2D_STICK && std::fabs(slip) > small_u) return breach(s, i, "a sticking pair slipped", slip);
      if (status == C2D_SLIP && s.mu > 0) {
        if (std::fabs(ut - ut_before - slip) > small_u) return breach(s, i, "slip is not the motion", slip);
        const double friction = std::fabs(tt) > small_p ? tt : before.at(i, C2D_TT);
        if (std::fabs(friction) > small_p && friction * slip > 0 && std::fabs(slip) > small_u)
          return breach(s, i, "friction pushes along the slip", slip);
      }
    }
  }
  return "";
}

} // namespace problem
