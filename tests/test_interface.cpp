// The rules of the C interface: structs that grow, states, wrong arguments, callbacks, words for numbers.
#include "contact2d_cards.h"
#include "paths.hpp"
#include "shell.hpp"
#include "solver/solver.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <type_traits>

using namespace runs;

namespace {

// Every public struct is plain and begins with its size.
template <class T> constexpr bool is_public_struct() {
  return std::is_trivially_copyable<T>::value && std::is_standard_layout<T>::value && offsetof(T, struct_size) == 0;
}
static_assert(is_public_struct<c2d_error>() && is_public_struct<c2d_limits>() && is_public_struct<c2d_progress>() &&
                  is_public_struct<c2d_port>() && is_public_struct<c2d_problem>() && is_public_struct<c2d_body>() &&
                  is_public_struct<c2d_zone>() && is_public_struct<c2d_options>() && is_public_struct<c2d_step>() &&
                  is_public_struct<c2d_summary>() && is_public_struct<c2d_body_result>() &&
                  is_public_struct<c2d_zone_state>() && is_public_struct<c2d_card>(),
              "structs grow at their end");
// Version 0.2: a member that moves breaks hosts that were compiled before.
static_assert(sizeof(void*) != 8 || (offsetof(c2d_limits, panel_columns) == 48 && offsetof(c2d_error, text) == 80 &&
                                     offsetof(c2d_options, every_change) == 12 && offsetof(c2d_body, youngs_modulus) == 16 &&
                                     offsetof(c2d_zone, side2) == 36),
              "members keep their places");

struct Host : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  test::Callable<void(const char*)> inside; // called from every callback with its name
  std::vector<c2d_error> faults;            // told by log
  static void call(void* context, const char* name) {
    Host& h = static_cast<Host&>(self(context));
    if (h.inside) h.inside(name);
  }
  Host() {
    serve(port);
    port.log = [](void* c, const c2d_error* entry) {
      if (entry->severity == C2D_FAULT) static_cast<Host&>(self(c)).faults.push_back(*entry);
      call(c, "log");
    };
    port.progress = [](void* c, const c2d_progress*) { call(c, "progress"); };
    port.cancel = [](void* c) { return call(c, "cancel"), 0; };
    port.clock = [](void* c) { return call(c, "clock"), 0.0; };
    before = [this](const Operation& operation, size_t) {
      const char name[2] = {operation.kind, '\0'};
      call(this, name);
      return 0;
    };
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
};

const Deck& small_deck() {
  static const Deck deck = deck_named("hertz_lin_l");
  return deck;
}
uint64_t enough(const c2d_limits& limits) {
  uint64_t in_core = 0;
  REQUIRE(c2d_memory_need(&limits, nullptr, &in_core, nullptr) == C2D_OK);
  return in_core;
}

c2d_problem problem() {
  c2d_problem p = C2D_INIT(c2d_problem);
  p.analysis = C2D_ANALYSIS_FULL;
  return p;
}
c2d_body body_of(const c2d_limits& l, int b) {
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2;
  body.elements = l.body[b].elements;
  body.regions = 1;
  body.youngs_modulus = 1000.0;
  body.poisson_ratio = 0.3;
  return body;
}

// A solver brought into a state.
void bring(Machine& machine, Host& host, int32_t state) {
  c2d_solver* s = machine.solver;
  REQUIRE(machine.created == C2D_OK);
  if (state == C2D_STATE_EMPTY) return;
  if (state == C2D_STATE_BUILDING) {
    const c2d_problem p = problem();
    REQUIRE(c2d_set_problem(s, &p) == C2D_OK);
    return;
  }
  REQUIRE(read_deck(s, small_deck()) == C2D_OK);
  if (state == C2D_STATE_MODEL) return;
  if (state == C2D_STATE_BROKEN) {
    const auto ok = host.before;
    host.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'w' ? 3 : 0; };
    REQUIRE(c2d_prepare(s) == C2D_ERR_STORE_WRITE);
    host.before = ok;
    return;
  }
  REQUIRE(c2d_prepare(s) == C2D_OK);
  if (state == C2D_STATE_PREPARED) return;
  const double mu = 0.4;
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
}

constexpr uint32_t bit(int32_t state) { return 1u << state; }
constexpr uint32_t kEmpty = bit(C2D_STATE_EMPTY), kBuilding = bit(C2D_STATE_BUILDING), kModel = bit(C2D_STATE_MODEL),
                   kPrepared = bit(C2D_STATE_PREPARED), kRunning = bit(C2D_STATE_RUNNING), kBroken = bit(C2D_STATE_BROKEN);

struct Call {
  const char* name;
  uint32_t legal;
  test::Callable<c2d_status(c2d_solver*)> make; // with arguments that are right in the states where it is legal
};

double g_numbers[4];

c2d_status add_load(c2d_solver* s, int32_t increments, double load) { return c2d_add_path(s, increments, &load, 1); }

const std::vector<Call>& calls() {
  static const std::vector<Call> all = [] {
    const host::Limits limits = small_deck().limits();
    const uint32_t model_calls = kEmpty | kBuilding, complete = kModel | kPrepared | kRunning;
    std::vector<Call> out;
    const auto add = [&](const char* name, uint32_t legal, test::Callable<c2d_status(c2d_solver*)> make) {
      out.push_back({name, legal, std::move(make)});
    };
    add("set_problem", model_calls, [](c2d_solver* s) {
      const c2d_problem p = problem();
      return c2d_set_problem(s, &p);
    });
    add("set_line", model_calls, [](c2d_solver* s) { return c2d_set_line(s, 1, 2, 3); });
    add("set_options", model_calls | kModel, [](c2d_solver* s) {
      const c2d_options o = C2D_INIT(c2d_options);
      return c2d_set_options(s, &o);
    });
    add("set_body", model_calls, [limits](c2d_solver* s) {
      const c2d_body b = body_of(limits, 0);
      return c2d_set_body(s, 1, &b);
    });
    add("add_region", model_calls, [](c2d_solver* s) { return c2d_add_region(s, 1, 1, 4); });
    add("set_nodes", model_calls, [](c2d_solver* s) {
      const double xy[2] = {1, 2};
      return c2d_set_nodes(s, 1, 1, 1, xy, 2);
    });
    add("set_condition", model_calls, [](c2d_solver* s) {
      const int32_t codes[4] = {0, 0, 1, 1};
      const double values[4] = {0, 0, 0, 0};
      return c2d_set_condition(s, 1, 1, 1, 1, codes, values);
    });
    add("add_point_load", model_calls, [](c2d_solver* s) { return c2d_add_point_load(s, 1, 1, 0, 0, 1, 1); });
    add("add_points", model_calls, [](c2d_solver* s) {
      c2d_points p = C2D_INIT(c2d_points);
      p.body = 1;
      return c2d_add_points(s, &p);
    });
    add("add_curve", model_calls, [](c2d_solver* s) {
      c2d_curve c = C2D_INIT(c2d_curve);
      c.body = c.first_element = c.last_element = 1;
      return c2d_add_curve(s, &c);
    });
    add("add_zone", model_calls, [](c2d_solver* s) {
      const c2d_zone z = C2D_INIT(c2d_zone);
      return c2d_add_zone(s, &z);
    });
    add("add_friction", model_calls, [](c2d_solver* s) { return c2d_add_friction(s, 0.1); });
    add("add_path", model_calls, [](c2d_solver* s) {
      const double load = 1;
      return c2d_add_path(s, 1, &load, 1);
    });
    add("set_units", model_calls | complete, [](c2d_solver* s) { return c2d_set_units(s, "mm", "N"); });
    add("set_name", model_calls | complete, [](c2d_solver* s) { return c2d_set_name(s, C2D_NAME_BODY, 1, "bolt"); });
    add("get_name", model_calls | complete, [](c2d_solver* s) {
      char name[32];
      return c2d_get_name(s, C2D_NAME_BODY, 1, name);
    });
    add("set_values", kBuilding | kModel, [](c2d_solver* s) {
      const double values[4] = {0, 0, 0, 0};
      return c2d_set_values(s, 1, 1, 1, 1, values);
    });
    add("set_zone_friction", model_calls, [](c2d_solver* s) { return c2d_set_zone_friction(s, 1, 1, 0.2); });
    add("set_symmetry", model_calls, [](c2d_solver* s) { return c2d_set_symmetry(s, 0, 0.0); });
    add("set_rigid", model_calls, [](c2d_solver* s) { return c2d_set_rigid(s, 1, 0, nullptr, nullptr); });
    add("set_rigid_load", model_calls, [](c2d_solver* s) {
      const int32_t is_free[3] = {1, 0, 0};
      return c2d_set_rigid_load(s, 1, 0, is_free, nullptr, g_numbers);
    });
    add("add_platen", model_calls, [](c2d_solver* s) {
      const int32_t is_free[3] = {1, 0, 0};
      return c2d_add_platen(s, 1, 1, 1, 0, is_free, g_numbers);
    });
    add("tie_zone", model_calls, [](c2d_solver* s) { return c2d_tie_zone(s, 1); });
    add("set_interference", model_calls, [](c2d_solver* s) { return c2d_set_interference(s, 1); });
    add("set_body_force", model_calls | kModel, [](c2d_solver* s) {
      const double weight[2] = {0, -1};
      return c2d_set_body_force(s, 1, 1, weight, 0, nullptr);
    });
    add("clear_paths", model_calls, [](c2d_solver* s) { return c2d_clear_paths(s); });
    add("read_deck", kEmpty, [](c2d_solver* s) { return read_deck(s, small_deck()); });
    add("complete", kBuilding, [](c2d_solver* s) { return c2d_complete(s); });
    add("prepare", kModel, [](c2d_solver* s) { return c2d_prepare(s); });
    add("change_loads", kPrepared | kRunning, [](c2d_solver* s) { return c2d_change_loads(s); });
    add("replace_point_load", kModel, [](c2d_solver* s) { return c2d_replace_point_load(s, 1, 0, 0, 0, 0); });
    add("set_line_nodes", model_calls, [](c2d_solver* s) {
      const double xy[2] = {1, 2};
      return c2d_set_line_nodes(s, 1, 1, 2, xy, xy, xy);
    });
    add("set_arc_nodes", model_calls, [](c2d_solver* s) {
      const double xy[2] = {1, 2};
      return c2d_set_arc_nodes(s, 1, 1, 2, xy, 1, 0, 90);
    });
    add("save", kPrepared | kRunning, [](c2d_solver* s) { return c2d_save(s); });
    add("restore", complete | kBroken, [](c2d_solver* s) { return c2d_restore(s); });
    add("begin", kPrepared | kRunning, [](c2d_solver* s) {
      const double mu = 0.2;
      return c2d_begin(s, &mu, 1);
    });
    add("run", kPrepared | kRunning, [](c2d_solver* s) { return c2d_run(s, nullptr, nullptr); });
    add("advance", kRunning, [](c2d_solver* s) {
      const double load = 0.5;
      c2d_outcome o;
      return c2d_advance(s, &load, 1, &o);
    });
    add("next_event", kRunning, [](c2d_solver* s) {
      const double along = 1;
      double far;
      return c2d_next_event(s, &along, 1, &far);
    });
    add("get_zone_state", kRunning, [](c2d_solver* s) {
      c2d_zone_state z = C2D_INIT(c2d_zone_state);
      return c2d_get_zone_state(s, 1, &z);
    });
    add("get_body_state", kRunning, [](c2d_solver* s) {
      c2d_body_state b = C2D_INIT(c2d_body_state);
      return c2d_get_body_state(s, 1, &b);
    });
    add("get result", kRunning, [](c2d_solver* s) { return c2d_get(s, C2D_TN, 1, 1, 1, g_numbers, 1); });
    add("get boundary", kRunning, [](c2d_solver* s) { return c2d_get(s, C2D_END_UX, 1, 1, 1, g_numbers, 1); });
    add("get stress", kRunning, [](c2d_solver* s) { return c2d_get(s, C2D_END_HOOP, 1, 1, 1, g_numbers, 1); });
    add("interior", kRunning, [](c2d_solver* s) {
      const double xy[2] = {0, 0};
      double row[C2D_POINT_FIELDS];
      return c2d_interior(s, 0, 1, xy, 2, row, C2D_POINT_FIELDS);
    });
    add("indicators", kRunning, [](c2d_solver* s) {
      double row[C2D_OFF_FIELDS];
      return c2d_indicators(s, 1, 1, 1, row, C2D_OFF_FIELDS);
    });
    add("get end status", kRunning, [](c2d_solver* s) { return c2d_get(s, C2D_END_STATUS, 1, 1, 1, g_numbers, 1); });
    add("get position", complete, [](c2d_solver* s) { return c2d_get(s, C2D_X, 1, 1, 1, g_numbers, 1); });
    add("get end position", complete, [](c2d_solver* s) { return c2d_get(s, C2D_END_X, 1, 1, 1, g_numbers, 1); });
    add("get node", complete, [](c2d_solver* s) { return c2d_get(s, C2D_NODE_X, 1, 1, 1, g_numbers, 1); });
    add("get_friction", complete, [](c2d_solver* s) { return c2d_get_friction(s, 0, 1, g_numbers); });
    add("get_path", complete, [](c2d_solver* s) {
      int32_t n;
      return c2d_get_path(s, 1, &n, g_numbers, 1);
    });
    add("get_zone", complete, [](c2d_solver* s) {
      c2d_zone z = C2D_INIT(c2d_zone);
      return c2d_get_zone(s, 1, &z);
    });
    add("get_region", complete, [](c2d_solver* s) {
      int32_t a, b;
      return c2d_get_region(s, 1, 1, &a, &b);
    });
    add("get_condition", complete, [](c2d_solver* s) {
      int32_t codes[4];
      return c2d_get_condition(s, 1, 1, 1, 1, codes, g_numbers);
    });
    add("get_point_load", complete, [](c2d_solver* s) {
      int32_t b, k;
      double f[2];
      return c2d_get_point_load(s, 1, &b, &k, g_numbers, f);
    });
    add("get_body_force", complete, [](c2d_solver* s) {
      double f[2], axis[2];
      return c2d_get_body_force(s, 1, 1, f, g_numbers, axis);
    });
    add("get_rigid", complete, [](c2d_solver* s) {
      int32_t rigid;
      double u[3];
      return c2d_get_rigid(s, 1, 1, &rigid, u, g_numbers);
    });
    add("get_interference", complete, [](c2d_solver* s) {
      int32_t k;
      return c2d_get_interference(s, &k);
    });
    add("get place", complete, [](c2d_solver* s) { return c2d_get(s, C2D_PAIR_ELEMENT1, 1, 1, 1, g_numbers, 1); });
    add("get_points", complete, [](c2d_solver* s) {
      c2d_points p = C2D_INIT(c2d_points);
      return c2d_get_points(s, 1, &p);
    });
    add("get_curve", complete, [](c2d_solver* s) {
      c2d_curve c = C2D_INIT(c2d_curve);
      return c2d_get_curve(s, 1, &c);
    });
    return out;
  }();
  return all;
}

// The workspace but for the record of the last error, which every refused call may write.
Bytes without_error(const c2d_solver* s) {
  const unsigned char* start = reinterpret_cast<const unsigned char*>(s);
  Bytes bytes(start, start + s->bytes);
  std::fill_n(bytes.begin() + offsetof(c2d_solver, error), sizeof(c2d_error), static_cast<unsigned char>(0));
  std::fill_n(bytes.begin() + offsetof(c2d_solver, has_fault), sizeof(int32_t), static_cast<unsigned char>(0));
  return bytes;
}

// A call that was refused has told the log so, once, and in words. A model has as many faults as it has.
void check_told(const Host& host, c2d_status status) {
  REQUIRE(host.faults.size() >= 1);
  if (status != C2D_ERR_INPUT) CHECK(host.faults.size() == 1);
  CHECK(host.faults[0].status == status);
  CHECK(std::strlen(host.faults[0].text) > 8);
}
bool is_kept(c2d_solver* s, const c2d_error& fault) {
  const c2d_error kept = error_of(s);
  return std::memcmp(&kept, &fault, sizeof kept) == 0;
}

} // namespace

TEST_CASE("interface: a word for every number") {
  const auto is_word = [](const char* text) { return text && std::strlen(text) > 3 && std::strlen(text) < 200; };
  std::set<std::string> seen;
  for (int32_t status : {0,  1,  2,  3,  4,  5,   6,   7,   8,   9,   10,  11,  20,  21,  22,  23,  24,  30,  31, 32,
                         33, 34, 35, 40, 99, 201, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211, 212, 213, 214}) {
    CAPTURE(status);
    CHECK(is_word(c2d_message(status)));
    CHECK(std::string(c2d_message(status)) != c2d_message(-12345));
    CHECK(seen.insert(c2d_message(status)).second);
  }
  for (int32_t outcome = 0; outcome <= 4; ++outcome) {
    CHECK(is_word(c2d_outcome_message(outcome)));
    CHECK(seen.insert(c2d_outcome_message(outcome)).second);
  }
  for (int32_t any : {INT32_MIN, INT32_MIN + 1, -1, 1000, INT32_MAX - 1, INT32_MAX}) {
    CHECK(is_word(c2d_message(any)));
    CHECK(is_word(c2d_outcome_message(any)));
  }
  for (int32_t any = -300; any < 1000; ++any) CHECK((is_word(c2d_message(any)) && is_word(c2d_outcome_message(any))));
  CHECK(std::string(c2d_version()) == "0.2.0");
}

TEST_CASE("interface: structs of other versions") {
  const host::Limits limits = small_deck().limits();
  uint64_t need = 0, again = 0;
  REQUIRE(c2d_memory_need(&limits, &need, nullptr, nullptr) == C2D_OK);
  // A longer struct of a later version: what we do not know is not looked at.
  struct {
    host::Limits known;
    unsigned char more[40];
  } later;
  later.known = limits;
  later.known.struct_size = sizeof later;
  std::fill(std::begin(later.more), std::end(later.more), static_cast<unsigned char>(0xEE));
  CHECK(c2d_memory_need(&later.known, &again, nullptr, nullptr) == C2D_OK);
  CHECK(again == need);
  // A shorter one: what is not there is zero, the default.
  host::Limits cut = limits, zeros = limits;
  cut.struct_size = offsetof(c2d_limits, load_cases);
  cut.load_cases = -7;
  cut.panel_columns = -7;
  zeros.load_cases = zeros.panel_columns = 0;
  REQUIRE(c2d_memory_need(&zeros, &need, nullptr, nullptr) == C2D_OK);
  CHECK(c2d_memory_need(&cut, &again, nullptr, nullptr) == C2D_OK);
  CHECK(again == need);
  for (uint32_t size = 0; size < 8; ++size) {
    cut.struct_size = size;
    CHECK(c2d_memory_need(&cut, &again, nullptr, nullptr) == C2D_ERR_ARGUMENT);
    c2d_solver* s = nullptr;
    unsigned char few[64];
    c2d_error why = C2D_INIT(c2d_error);
    CHECK(c2d_create(&s, few, sizeof few, &cut, nullptr, &why) == C2D_ERR_ARGUMENT);
    CHECK(why.status == C2D_ERR_ARGUMENT);
    why.struct_size = size;
    CHECK(c2d_create(&s, few, sizeof few, &limits, nullptr, &why) == (size == 4 ? C2D_ERR_MEMORY : C2D_ERR_ARGUMENT));
    CHECK(why.struct_size == size);
  }
  // What comes out: no byte beyond the caller's struct, nor beyond ours.
  Host host;
  Machine machine(limits, enough(limits), &host.port);
  bring(machine, host, C2D_STATE_RUNNING);
  double nothing;
  REQUIRE(c2d_get(machine.solver, -1, 1, 1, 1, &nothing, 1) == C2D_ERR_ARGUMENT);
  struct Out {
    const char* name;
    size_t size;
    test::Callable<c2d_status(c2d_solver*, void*)> get;
  };
  const Out outs[] = {
      {"summary", sizeof(c2d_summary), [](c2d_solver* s, void* p) { return c2d_get_summary(s, static_cast<c2d_summary*>(p)); }},
      {"error", sizeof(c2d_error), [](c2d_solver* s, void* p) { return c2d_last_error(s, static_cast<c2d_error*>(p)); }},
      {"zone", sizeof(c2d_zone), [](c2d_solver* s, void* p) { return c2d_get_zone(s, 1, static_cast<c2d_zone*>(p)); }},
      {"body", sizeof(c2d_body_result),
       [](c2d_solver* s, void* p) { return c2d_get_body_result(s, 1, static_cast<c2d_body_result*>(p)); }},
  };
  for (const Out& out : outs) {
    CAPTURE(std::string(out.name));
    std::vector<uint64_t> reference((out.size + 256) / 8, 0);
    uint32_t ours = static_cast<uint32_t>(out.size);
    std::memcpy(reference.data(), &ours, sizeof ours);
    REQUIRE(out.get(machine.solver, reference.data()) == C2D_OK);
    const unsigned char* truth = reinterpret_cast<const unsigned char*>(reference.data());
    for (size_t size = 0; size <= out.size + 100; ++size) {
      CAPTURE(size);
      std::vector<uint64_t> room((out.size + 256) / 8, 0xDDDDDDDDDDDDDDDDull);
      const uint32_t mark = static_cast<uint32_t>(size);
      std::memcpy(room.data(), &mark, sizeof mark);
      const c2d_status status = out.get(machine.solver, room.data());
      const bool can_be = size >= 4 && size % 4 == 0; // of a struct whose members have 4 bytes or more
      REQUIRE(status == (can_be ? C2D_OK : C2D_ERR_ARGUMENT));
      const unsigned char* got = reinterpret_cast<const unsigned char*>(room.data());
      REQUIRE(std::memcmp(got, &mark, sizeof mark) == 0);
      const size_t end = can_be ? std::min(size, out.size) : 4;
      REQUIRE(std::memcmp(got + 4, truth + 4, end - 4) == 0);
      for (size_t i = end; i < room.size() * 8; ++i) REQUIRE(got[i] == 0xDD);
    }
  }
  // A port of an earlier version: the store alone, nothing read beyond.
  c2d_port old = host.port;
  old.struct_size = offsetof(c2d_port, start_read);
  Machine small(limits, enough(limits), &old);
  Numbers numbers;
  CHECK(run_all(small.solver, small_deck(), numbers) == C2D_OK);
  old.struct_size = 3;
  small.create(limits, &old);
  CHECK(small.created == C2D_ERR_ARGUMENT);
  CHECK(small.solver == nullptr);
}

TEST_CASE("interface: what is no solver") {
  std::vector<uint64_t> garbage(2000, 0x5555555555555555ull);
  const host::Limits limits = small_deck().limits();
  Machine closed(limits, enough(limits), nullptr);
  REQUIRE(c2d_close(closed.solver) == C2D_OK);
  for (c2d_solver* s : {static_cast<c2d_solver*>(nullptr), reinterpret_cast<c2d_solver*>(garbage.data()), closed.solver}) {
    CHECK(c2d_get_state(s) == -1);
    for (const Call& call : calls()) {
      CAPTURE(std::string(call.name));
      CHECK(call.make(s) == C2D_ERR_ARGUMENT);
    }
    host::Summary summary;
    c2d_error error = C2D_INIT(c2d_error);
    CHECK(host::get_summary(s, summary) == C2D_ERR_ARGUMENT);
    CHECK(c2d_last_error(s, &error) == C2D_ERR_ARGUMENT);
    CHECK(c2d_cancel(s) == C2D_ERR_ARGUMENT);
    CHECK(c2d_close(s) == C2D_ERR_ARGUMENT);
  }
  CHECK(std::all_of(garbage.begin(), garbage.end(), [](uint64_t word) { return word == 0x5555555555555555ull; }));
  c2d_solver* s = nullptr;
  CHECK(c2d_create(nullptr, garbage.data(), 100, &limits, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_create(&s, garbage.data(), 100, nullptr, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  host::Limits out;
  CHECK(c2d_scan_deck(nullptr, nullptr, &out, nullptr) == C2D_ERR_ARGUMENT);
  Deck deck = small_deck();
  CHECK(c2d_scan_deck(Deck::read, &deck, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_check_deck(nullptr, nullptr, &out, nullptr, nullptr) == C2D_ERR_ARGUMENT);
}

TEST_CASE("interface: every function in every state") {
  const host::Limits limits = small_deck().limits();
  for (int32_t state = C2D_STATE_EMPTY; state <= C2D_STATE_BROKEN; ++state) {
    CAPTURE(state);
    for (const Call& call : calls()) {
      CAPTURE(std::string(call.name));
      Host host;
      Machine machine(limits, enough(limits), &host.port);
      bring(machine, host, state);
      REQUIRE(c2d_get_state(machine.solver) == state);
      const Bytes before = without_error(machine.solver);
      const c2d_error cause = error_of(machine.solver); // in state broken: why it is
      host.faults.clear();
      const c2d_status status = call.make(machine.solver);
      if (status != C2D_OK) check_told(host, status);
      if (call.legal & bit(state)) {
        CHECK(status != C2D_ERR_STATE);
        CHECK(status != C2D_ERR_BUSY);
        const std::string name = call.name;
        const bool empty_list =
            name.find("point_load") != std::string::npos || name == "get_points" || name == "get_curve"; // here
        if (name == "restore")
          CHECK(status == C2D_ERR_STORE_FORMAT); // nothing was saved
        else if (state >= C2D_STATE_MODEL && !empty_list)
          CHECK(status == C2D_OK);
      } else {
        CHECK(status == C2D_ERR_STATE);
        CHECK(without_error(machine.solver) == before);
        CHECK(is_kept(machine.solver, state == C2D_STATE_BROKEN ? cause : host.faults[0]));
      }
      if (state == C2D_STATE_BROKEN) CHECK(error_of(machine.solver).status == C2D_ERR_STORE_WRITE);
      // Always legal:
      host::Summary summary;
      CHECK(host::get_summary(machine.solver, summary) == C2D_OK);
      CHECK(summary.state == c2d_get_state(machine.solver));
      CHECK(summary.minimum_bytes > 0);
      CHECK(c2d_cancel(machine.solver) == C2D_OK);
      CHECK(c2d_close(machine.solver) == C2D_OK);
      CHECK(machine.guards_are_whole());
    }
  }
}

TEST_CASE("interface: what broke a solver is told until it is taken up again") {
  const host::Limits limits = small_deck().limits();
  Host host;
  Machine machine(limits, enough(limits), &host.port);
  c2d_solver* s = machine.solver;
  bring(machine, host, C2D_STATE_RUNNING);
  REQUIRE(c2d_save(s) == C2D_OK);
  const auto ok = host.before;
  host.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'w' ? 28 : 0; };
  host.faults.clear();
  REQUIRE(c2d_save(s) == C2D_ERR_STORE_WRITE);
  check_told(host, C2D_ERR_STORE_WRITE);
  const c2d_error cause = host.faults[0];
  CHECK(cause.host_code == 28);
  CHECK(is_kept(s, cause));
  double number = 0.0;
  CHECK(c2d_advance(s, &number, 1, nullptr) == C2D_ERR_STATE);
  CHECK(c2d_get(s, C2D_TN, 0, 1, 1, &number, 1) == C2D_ERR_STATE);
  host.before = [](const RamStore::Operation& operation, size_t) { return operation.kind == 'r' ? 29 : 0; };
  CHECK(c2d_restore(s) == C2D_ERR_STORE_READ);
  REQUIRE(host.faults.size() == 4);
  CHECK(host.faults[3].host_code == 29);
  CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);
  CHECK(is_kept(s, cause));
  host.before = ok;
  CHECK(c2d_restore(s) == C2D_OK);
  // From then on the last failure is told again.
  CHECK(c2d_advance(s, &number, 1, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(error_of(s).status == C2D_ERR_ARGUMENT);
}

TEST_CASE("interface: where each call leads") {
  const host::Limits limits = small_deck().limits();
  Host host;
  Machine machine(limits, enough(limits), &host.port);
  c2d_solver* s = machine.solver;
  CHECK(c2d_get_state(s) == C2D_STATE_EMPTY);
  REQUIRE(read_deck(s, small_deck()) == C2D_OK);
  CHECK(c2d_get_state(s) == C2D_STATE_MODEL);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  CHECK(c2d_get_state(s) == C2D_STATE_PREPARED);
  const double mu = 0.3;
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  CHECK(c2d_get_state(s) == C2D_STATE_RUNNING);
  REQUIRE(c2d_run(s, nullptr, nullptr) == C2D_OK);
  CHECK(c2d_get_state(s) == C2D_STATE_RUNNING);
  // Without a store the model can be checked but not prepared, and the model stays.
  Machine storeless(limits, enough(limits), nullptr);
  REQUIRE(read_deck(storeless.solver, small_deck()) == C2D_OK);
  CHECK(c2d_prepare(storeless.solver) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_state(storeless.solver) == C2D_STATE_MODEL);
  // A model that is not complete: the fault is told, and the solver is empty again.
  Machine half(limits, enough(limits), nullptr);
  const c2d_problem p = problem();
  REQUIRE(c2d_set_problem(half.solver, &p) == C2D_OK);
  CHECK(c2d_get_state(half.solver) == C2D_STATE_BUILDING);
  CHECK(c2d_complete(half.solver) == C2D_ERR_INPUT);
  CHECK(c2d_get_state(half.solver) == C2D_STATE_EMPTY);
  CHECK(error_of(half.solver).status == C2D_ERR_INPUT);
  CHECK(read_deck(half.solver, small_deck()) == C2D_OK);
}

namespace {

// Calls with something wrong, for a solver in the given state.
struct Wrong {
  const char* name;
  int32_t state;
  test::Callable<c2d_status(c2d_solver*)> make;
};

std::vector<Wrong> wrong_calls() {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  static const host::Limits limits = small_deck().limits();
  std::vector<Wrong> out;
  for (int32_t state : {C2D_STATE_EMPTY, C2D_STATE_BUILDING}) {
    const auto add = [&](const char* name, test::Callable<c2d_status(c2d_solver*)> make) {
      out.push_back({name, state, std::move(make)});
    };
    add("problem null", [](c2d_solver* s) { return c2d_set_problem(s, nullptr); });
    add("problem size", [](c2d_solver* s) {
      c2d_problem p = problem();
      p.struct_size = 3;
      return c2d_set_problem(s, &p);
    });
    add("plane", [](c2d_solver* s) {
      c2d_problem p = problem();
      p.plane = 3;
      return c2d_set_problem(s, &p);
    });
    add("iterations", [](c2d_solver* s) {
      c2d_problem p = problem();
      p.iteration_limit = -1;
      return c2d_set_problem(s, &p);
    });
    add("options null", [](c2d_solver* s) { return c2d_set_options(s, nullptr); });
    add("options range", [](c2d_solver* s) {
      c2d_options o = C2D_INIT(c2d_options);
      o.stepping = 2;
      return c2d_set_options(s, &o);
    });
    add("body null", [](c2d_solver* s) { return c2d_set_body(s, 1, nullptr); });
    for (int32_t number : {INT32_MIN, -1, 0, 3, INT32_MAX}) {
      add("body number", [number](c2d_solver* s) {
        const c2d_body b = body_of(limits, 0);
        return c2d_set_body(s, number, &b);
      });
      add("region body", [number](c2d_solver* s) { return c2d_add_region(s, number, 1, 4); });
      add("nodes body", [number](c2d_solver* s) {
        const double xy[2] = {0, 0};
        return c2d_set_nodes(s, number, 1, 1, xy, 2);
      });
      add("load body", [number](c2d_solver* s) { return c2d_add_point_load(s, number, 1, 0, 0, 0, 0); });
    }
    for (double modulus : {0.0, -1.0, nan, inf})
      add("modulus", [modulus](c2d_solver* s) {
        c2d_body b = body_of(limits, 0);
        b.youngs_modulus = modulus;
        return c2d_set_body(s, 1, &b);
      });
    for (double ratio : {-1.0, 0.51, nan, -inf})
      add("poisson", [ratio](c2d_solver* s) {
        c2d_body b = body_of(limits, 0);
        b.poisson_ratio = ratio;
        return c2d_set_body(s, 1, &b);
      });
    add("too many elements", [](c2d_solver* s) {
      c2d_body b = body_of(limits, 0);
      ++b.elements;
      return c2d_set_body(s, 1, &b);
    });
    add("too many regions", [](c2d_solver* s) {
      c2d_body b = body_of(limits, 0);
      b.regions = limits.body[0].regions + 1;
      return c2d_set_body(s, 1, &b);
    });
    add("too many points", [](c2d_solver* s) {
      c2d_body b = body_of(limits, 0);
      b.element_nodes = 4;
      return c2d_set_body(s, 1, &b);
    });
    add("region early", [](c2d_solver* s) { return c2d_add_region(s, 1, 1, 4); });
    add("nodes early", [](c2d_solver* s) {
      const double xy[2] = {0, 0};
      return c2d_set_nodes(s, 1, 1, 1, xy, 2);
    });
    add("condition early", [](c2d_solver* s) { return c2d_set_condition(s, 1, 1, 1, 1, nullptr, nullptr); });
    add("load case", [](c2d_solver* s) { return c2d_add_point_load(s, 1, 2, 0, 0, 0, 0); });
    add("load nan", [nan](c2d_solver* s) { return c2d_add_point_load(s, 1, 1, nan, 0, 0, 0); });
    add("too many loads", [](c2d_solver* s) { return c2d_add_point_load(s, 1, 1, 0, 0, 1, 1); });
    add("zone null", [](c2d_solver* s) { return c2d_add_zone(s, nullptr); });
    add("zone early", [](c2d_solver* s) {
      const c2d_zone z = C2D_INIT(c2d_zone);
      return c2d_add_zone(s, &z);
    });
    for (double mu : {-0.1, -inf, nan}) add("mu", [mu](c2d_solver* s) { return c2d_add_friction(s, mu); });
    for (int32_t count : {0, -1, INT32_MIN}) add("increments", [count](c2d_solver* s) { return add_load(s, count, 1.0); });
    for (double load : {inf, nan}) add("path load", [load](c2d_solver* s) { return add_load(s, 1, load); });
  }
  out.push_back({"deck null", C2D_STATE_EMPTY, [](c2d_solver* s) { return c2d_read_deck(s, nullptr, nullptr); }});
  const auto add = [&](int32_t state, const char* name, test::Callable<c2d_status(c2d_solver*)> make) {
    out.push_back({name, state, std::move(make)});
  };
  for (int32_t state : {C2D_STATE_PREPARED, C2D_STATE_RUNNING}) {
    add(state, "begin null", [](c2d_solver* s) { return c2d_begin(s, nullptr, 1); });
    for (int32_t zones : {-1, INT32_MIN, 0, 2, INT32_MAX})
      add(state, "begin zones", [zones](c2d_solver* s) {
        const double mu[2] = {0, 0};
        return c2d_begin(s, mu, zones);
      });
    for (double mu : {-1.0, nan, -inf}) add(state, "begin mu", [mu](c2d_solver* s) { return c2d_begin(s, &mu, 1); });
    for (int32_t i : {0, -1, 100, INT32_MAX, INT32_MIN}) {
      add(state, "friction", [i](c2d_solver* s) { return c2d_get_friction(s, 0, i, g_numbers); });
      add(state, "path", [i](c2d_solver* s) {
        int32_t n;
        return c2d_get_path(s, i, &n, g_numbers, 1);
      });
      add(state, "zone", [i](c2d_solver* s) {
        c2d_zone z = C2D_INIT(c2d_zone);
        return c2d_get_zone(s, i, &z);
      });
      add(state, "region", [i](c2d_solver* s) {
        int32_t a, b;
        return c2d_get_region(s, 1, i, &a, &b);
      });
      add(state, "region body", [i](c2d_solver* s) {
        int32_t a, b;
        return c2d_get_region(s, i, 1, &a, &b);
      });
      add(state, "condition", [i](c2d_solver* s) {
        int32_t c[4];
        return c2d_get_condition(s, 1, i == 100 ? 1000 : i, 1, 1, c, g_numbers);
      });
      add(state, "condition end", [i](c2d_solver* s) {
        int32_t c[4];
        return c2d_get_condition(s, 1, 1, i, 1, c, g_numbers);
      });
      add(state, "case of condition", [i](c2d_solver* s) {
        int32_t c[4];
        return c2d_get_condition(s, 1, 1, 1, i, c, g_numbers);
      });
      add(state, "point load", [i](c2d_solver* s) {
        int32_t b, k;
        double f[2];
        return c2d_get_point_load(s, i, &b, &k, g_numbers, f);
      });
      add(state, "body force body", [i](c2d_solver* s) {
        double f[2], axis[2];
        return c2d_get_body_force(s, i, 1, f, g_numbers, axis);
      });
      add(state, "body force case", [i](c2d_solver* s) {
        double f[2], axis[2];
        return c2d_get_body_force(s, 1, i, f, g_numbers, axis);
      });
      add(state, "zone of friction", [i](c2d_solver* s) { return c2d_get_friction(s, i == 0 ? 100 : i, 1, g_numbers); });
      add(state, "cases of a path", [i](c2d_solver* s) {
        int32_t n;
        return c2d_get_path(s, 1, &n, g_numbers, i);
      });
      add(state, "rigid body", [i](c2d_solver* s) {
        int32_t rigid;
        double u[3];
        return c2d_get_rigid(s, i, 1, &rigid, u, g_numbers);
      });
      add(state, "rigid case", [i](c2d_solver* s) {
        int32_t rigid;
        double u[3];
        return c2d_get_rigid(s, 1, i, &rigid, u, g_numbers);
      });
      add(state, "get body", [i](c2d_solver* s) { return c2d_get(s, C2D_NODE_X, i, 1, 1, g_numbers, 1); });
    }
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_friction(s, 0, 1, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_path(s, 1, nullptr, nullptr, 1); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_zone(s, 1, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_region(s, 1, 1, nullptr, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_condition(s, 1, 1, 1, 1, nullptr, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_point_load(s, 1, nullptr, nullptr, nullptr, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_body_force(s, 1, 1, nullptr, nullptr, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_rigid(s, 1, 1, nullptr, nullptr, nullptr); });
    add(state, "nulls", [](c2d_solver* s) { return c2d_get_interference(s, nullptr); });
    add(state, "summary", [](c2d_solver* s) { return c2d_get_summary(s, nullptr); });
    add(state, "error", [](c2d_solver* s) { return c2d_last_error(s, nullptr); });
    for (int32_t body : {INT32_MIN, -1, 0, 3, INT32_MAX})
      add(state, "body result", [body](c2d_solver* s) {
        c2d_body_result result = C2D_INIT(c2d_body_result);
        return c2d_get_body_result(s, body, &result);
      });
    for (int32_t field : {-1, 16, 99, 117, 119, 122, 129, 132, INT32_MAX, INT32_MIN})
      add(state, "field", [field](c2d_solver* s) { return c2d_get(s, field, 1, 1, 1, g_numbers, 1); });
    for (int32_t field : {C2D_X, C2D_END_X, C2D_NODE_X, C2D_TN, C2D_END_TX}) {
      if (state == C2D_STATE_PREPARED && (field == C2D_TN || field == C2D_END_TX)) continue;
      add(state, "get null", [field](c2d_solver* s) { return c2d_get(s, field, 1, 1, 1, nullptr, 1); });
      for (int32_t first : {0, -1, INT32_MIN, INT32_MAX, 5000})
        add(state, "get first", [=](c2d_solver* s) { return c2d_get(s, field, 1, first, 1, g_numbers, 1); });
      for (int32_t count : {-1, INT32_MIN, INT32_MAX, 5000})
        add(state, "get count", [=](c2d_solver* s) { return c2d_get(s, field, 1, 1, count, g_numbers, 1); });
    }
  }
  add(C2D_STATE_RUNNING, "advance", [](c2d_solver* s) {
    c2d_outcome o;
    return c2d_advance(s, nullptr, 1, &o);
  });
  add(C2D_STATE_RUNNING, "advance", [](c2d_solver* s) {
    const double load = 1;
    return c2d_advance(s, &load, 1, nullptr);
  });
  for (int32_t cases : {0, -1, 2, INT32_MAX})
    add(C2D_STATE_RUNNING, "cases", [cases](c2d_solver* s) {
      const double load[2] = {1, 1};
      c2d_outcome o;
      return c2d_advance(s, load, cases, &o);
    });
  for (double number : {nan, inf, -inf}) {
    add(C2D_STATE_EMPTY, "symmetry", [number](c2d_solver* s) { return c2d_set_symmetry(s, 0, number); });
    add(C2D_STATE_EMPTY, "rigid", [number](c2d_solver* s) {
      const double motion[3] = {0, 0, number}, axis[2] = {0, 0};
      return c2d_set_rigid(s, 1, 1, motion, axis);
    });
    add(C2D_STATE_EMPTY, "rigid axis", [number](c2d_solver* s) {
      const double motion[3] = {0, 0, 0}, axis[2] = {0, number};
      return c2d_set_rigid(s, 1, 1, motion, axis);
    });
    add(C2D_STATE_MODEL, "body force", [number](c2d_solver* s) {
      const double force[2] = {0, number};
      return c2d_set_body_force(s, 1, 1, force, 0, nullptr);
    });
    add(C2D_STATE_MODEL, "body force axis", [number](c2d_solver* s) {
      const double force[2] = {0, 0}, axis[2] = {0, number};
      return c2d_set_body_force(s, 1, 1, force, 1, axis);
    });
    add(C2D_STATE_MODEL, "replaced", [number](c2d_solver* s) {
      const double values[4] = {number, number, number, number};
      return c2d_set_values(s, 1, 1, 1, 1, values);
    });
    add(C2D_STATE_EMPTY, "points", [number](c2d_solver* s) {
      c2d_points p = C2D_INIT(c2d_points);
      p.body = 1;
      p.from[1] = number;
      return c2d_add_points(s, &p);
    });
    add(C2D_STATE_RUNNING, "direction", [number](c2d_solver* s) { return c2d_next_event(s, &number, 1, g_numbers); });
  }
  for (int32_t i : {-1, 2, 100, INT32_MAX, INT32_MIN}) {
    add(C2D_STATE_EMPTY, "axis", [i](c2d_solver* s) { return c2d_set_symmetry(s, i, 0.0); });
    add(C2D_STATE_EMPTY, "rigid case", [i](c2d_solver* s) {
      const double still[3] = {0, 0, 0};
      return c2d_set_rigid(s, 1, i, still, still);
    });
    const int32_t body = i == 2 ? 3 : i; // of two
    add(C2D_STATE_EMPTY, "rigid body", [body](c2d_solver* s) { return c2d_set_rigid(s, body, 0, nullptr, nullptr); });
    add(C2D_STATE_EMPTY, "rigid load case",
        [i](c2d_solver* s) { return c2d_set_rigid_load(s, 1, i, nullptr, g_numbers, nullptr); });
    add(C2D_STATE_BUILDING, "platen", [i](c2d_solver* s) {
      const int32_t is_free[3] = {1, 1, 1};
      return c2d_add_platen(s, i == 2 ? 3 : i, 1, 1, 0, is_free, g_numbers);
    });
    add(C2D_STATE_BUILDING, "tie", [i](c2d_solver* s) { return c2d_tie_zone(s, i); });
    add(C2D_STATE_EMPTY, "closing case", [i](c2d_solver* s) { return c2d_set_interference(s, i); });
    add(C2D_STATE_MODEL, "body force case", [i](c2d_solver* s) {
      const double force[2] = {0, 0};
      return c2d_set_body_force(s, 1, i, force, 0, nullptr);
    });
    add(C2D_STATE_EMPTY, "zone friction", [i](c2d_solver* s) { return c2d_set_zone_friction(s, i, 1, 0.1); });
    add(C2D_STATE_MODEL, "point load", [i](c2d_solver* s) { return c2d_replace_point_load(s, i, 0, 0, 0, 0); });
    add(C2D_STATE_MODEL, "replaced", [i](c2d_solver* s) {
      const double values[4] = {0, 0, 0, 0};
      return c2d_set_values(s, 1, 1, i == 2 ? 4 : i, 1, values);
    });
    add(C2D_STATE_EMPTY, "path cases", [i](c2d_solver* s) { return c2d_add_path(s, 1, g_numbers, i); });
    add(C2D_STATE_RUNNING, "path cases", [i](c2d_solver* s) {
      int32_t n;
      return c2d_get_path(s, 1, &n, g_numbers, i);
    });
    add(C2D_STATE_RUNNING, "zone friction", [i](c2d_solver* s) { return c2d_get_friction(s, i, 1, g_numbers); });
    add(C2D_STATE_RUNNING, "zone state", [i](c2d_solver* s) {
      c2d_zone_state z = C2D_INIT(c2d_zone_state);
      return c2d_get_zone_state(s, i, &z);
    });
    const int32_t whose = i == 2 ? 3 : i; // of two
    add(C2D_STATE_RUNNING, "body state", [whose](c2d_solver* s) {
      c2d_body_state b = C2D_INIT(c2d_body_state);
      return c2d_get_body_state(s, whose, &b);
    });
    add(C2D_STATE_RUNNING, "points", [i](c2d_solver* s) {
      c2d_points p = C2D_INIT(c2d_points);
      return c2d_get_points(s, i, &p);
    });
    add(C2D_STATE_RUNNING, "curve", [i](c2d_solver* s) {
      c2d_curve c = C2D_INIT(c2d_curve);
      return c2d_get_curve(s, i, &c);
    });
    add(C2D_STATE_RUNNING, "indicators body", [whose](c2d_solver* s) {
      double row[C2D_OFF_FIELDS];
      return c2d_indicators(s, whose, 1, 1, row, C2D_OFF_FIELDS);
    });
    if (i != 2 || limits.bodies < 2)
      add(C2D_STATE_RUNNING, "interior body", [i](c2d_solver* s) {
        const double xy[2] = {0, 0};
        double row[C2D_POINT_FIELDS];
        return c2d_interior(s, i, 1, xy, 2, row, C2D_POINT_FIELDS);
      });
  }
  add(C2D_STATE_EMPTY, "no rigid load", [](c2d_solver* s) { return c2d_set_rigid_load(s, 1, 1, nullptr, nullptr, nullptr); });
  add(C2D_STATE_EMPTY, "nothing free", [](c2d_solver* s) { return c2d_set_rigid_load(s, 1, 0, nullptr, nullptr, g_numbers); });
  add(C2D_STATE_EMPTY, "no motion", [](c2d_solver* s) { return c2d_set_rigid(s, 1, 1, nullptr, nullptr); });
  add(C2D_STATE_EMPTY, "no force", [](c2d_solver* s) { return c2d_set_body_force(s, 1, 1, nullptr, 0, nullptr); });
  add(C2D_STATE_EMPTY, "no axis", [](c2d_solver* s) { return c2d_set_body_force(s, 1, 1, g_numbers, 1, nullptr); });
  add(C2D_STATE_EMPTY, "no factors", [](c2d_solver* s) { return c2d_add_path(s, 1, nullptr, 1); });
  add(C2D_STATE_EMPTY, "curve", [](c2d_solver* s) { return c2d_add_curve(s, nullptr); });
  for (int32_t body : {INT32_MIN, -1, 0, 2, 3, INT32_MAX})
    add(C2D_STATE_BUILDING, "side 1", [body](c2d_solver* s) {
      c2d_zone z = C2D_INIT(c2d_zone);
      z.side1.body = body, z.side2.body = 2;
      return c2d_add_zone(s, &z);
    });
  for (int32_t body : {INT32_MIN, -1, 0, 1, 3, INT32_MAX})
    add(C2D_STATE_BUILDING, "side 2", [body](c2d_solver* s) {
      c2d_zone z = C2D_INIT(c2d_zone);
      z.kind = C2D_ZONE_FREE;
      z.side1.body = 1, z.side2.body = body;
      return c2d_add_zone(s, &z);
    });
  for (int32_t kind : {INT32_MIN, -1, 8, INT32_MAX})
    add(C2D_STATE_EMPTY, "kind of zone", [kind](c2d_solver* s) {
      c2d_zone z = C2D_INIT(c2d_zone);
      z.kind = kind;
      return c2d_add_zone(s, &z);
    });
  add(C2D_STATE_EMPTY, "line nodes", [](c2d_solver* s) { return c2d_set_line_nodes(s, 1, 1, 2, nullptr, nullptr, nullptr); });
  add(C2D_STATE_EMPTY, "arc nodes", [](c2d_solver* s) { return c2d_set_arc_nodes(s, 1, 1, 2, nullptr, 1, 0, 90); });
  add(C2D_STATE_EMPTY, "long unit", [](c2d_solver* s) { return c2d_set_units(s, "0123456789abcdef", nullptr); });
  for (const int32_t kind : {-1, 2, INT32_MAX})
    add(C2D_STATE_MODEL, "kind of name", [kind](c2d_solver* s) { return c2d_set_name(s, kind, 1, "a"); });
  for (const int32_t kind : {C2D_NAME_BODY, C2D_NAME_ZONE})
    for (const int32_t i : {INT32_MIN, 0, 3}) {
      add(C2D_STATE_MODEL, "named thing", [kind, i](c2d_solver* s) { return c2d_set_name(s, kind, i, "a"); });
      add(C2D_STATE_MODEL, "named thing", [kind, i](c2d_solver* s) {
        char name[32];
        return c2d_get_name(s, kind, i, name);
      });
    }
  add(C2D_STATE_EMPTY, "control character", [](c2d_solver* s) { return c2d_set_name(s, C2D_NAME_BODY, 1, "a\n"); });
  add(C2D_STATE_MODEL, "name", [](c2d_solver* s) { return c2d_get_name(s, C2D_NAME_BODY, 1, nullptr); });
  add(C2D_STATE_BUILDING, "case values", [](c2d_solver* s) { return c2d_set_values(s, 1, 1, 1, 1, nullptr); });
  add(C2D_STATE_EMPTY, "points", [](c2d_solver* s) { return c2d_add_points(s, nullptr); });
  for (double load : {nan, inf, -inf})
    add(C2D_STATE_RUNNING, "load", [load](c2d_solver* s) {
      c2d_outcome o;
      return c2d_advance(s, &load, 1, &o);
    });
  return out;
}

} // namespace

// Names of the header's functions that begin with these words and take a solver that may change.
std::set<std::string> functions_of_a_solver() {
  const std::string header = test::read_file(paths::root() + "/include/contact2d.h");
  const std::string before = "c2d_status c2d_", behind = "(c2d_solver* solver";
  std::set<std::string> out;
  for (size_t at = header.find(before); at != std::string::npos; at = header.find(before, at + 1)) {
    const size_t name = at + before.size(), end = header.find('(', name);
    if (header.compare(end, behind.size(), behind) == 0) out.insert("c2d_" + header.substr(name, end - name));
  }
  return out;
}

TEST_CASE("interface: no function is left out of the tests of states and of wrong arguments") {
  const std::set<std::string> functions = functions_of_a_solver();
  CHECK(functions.size() > 40);
  const std::string here = test::read_file(paths::root() + "/tests/test_interface.cpp");
  const size_t states = here.find("& calls() {"), arguments = here.find("wrong_calls() {");
  REQUIRE(states < arguments);
  const std::set<std::string> always = {"c2d_close", "c2d_last_error", "c2d_get_summary", "c2d_get_body_result",
                                        "c2d_cancel"}, // in every state
      takes_nothing = {"c2d_close",        "c2d_cancel", "c2d_clear_paths", "c2d_complete", "c2d_prepare",
                       "c2d_change_loads", "c2d_save",   "c2d_restore",     "c2d_set_line", "c2d_run"};
  for (const std::string& name : functions) {
    CAPTURE(name);
    const size_t call = here.find(name.substr(4) + "(s", states); // decks are read by a function of the tests
    CHECK((always.count(name) == 1 || (call > states && call < arguments)));
    CHECK((takes_nothing.count(name) == 1 || here.find(name + "(s", arguments) < here.find("} // namespace", arguments)));
  }
}

TEST_CASE("interface: a wrong argument changes nothing") {
  const host::Limits limits = small_deck().limits();
  size_t count = 0;
  for (int32_t state = C2D_STATE_EMPTY; state <= C2D_STATE_RUNNING; ++state) {
    Host host;
    Machine machine(limits, enough(limits), &host.port);
    bring(machine, host, state);
    for (const Wrong& wrong : wrong_calls()) {
      if (wrong.state != state) continue;
      const Bytes before = without_error(machine.solver);
      CAPTURE(state);
      CAPTURE(std::string(wrong.name));
      ++count;
      host.faults.clear();
      const c2d_error kept = error_of(machine.solver);
      std::fill_n(g_numbers, 4, -77.0);
      const c2d_status status = wrong.make(machine.solver);
      CHECK((status == C2D_ERR_ARGUMENT || status == C2D_ERR_LIMIT));
      check_told(host, status);
      CHECK(is_kept(machine.solver, std::string(wrong.name) == "error" ? kept : host.faults[0]));
      CHECK(std::all_of(g_numbers, g_numbers + 4, [](double number) { return number == -77.0; }));
      const bool same = without_error(machine.solver) == before;
      CHECK(same);
      if (same) continue;
      machine.create(limits, &host.port); // the next one starts afresh
      bring(machine, host, state);
    }
  }
  MESSAGE("wrong calls: " << count);
  CHECK(count > 200);
}

namespace {

// Every function, from inside a callback. Returns the names of those that did not say busy.
std::string not_busy(c2d_solver* s, const c2d_limits& limits, bool in_step) {
  std::string out;
  for (const Call& call : calls()) {
    const std::string name = call.name;
    const bool is_get = name.compare(0, 4, "get ") == 0; // c2d_get, of any field
    const bool legal = is_get || name == "get_zone_state" || name == "get_body_state" || name == "interior" || name == "save";
    const c2d_status expected = in_step && legal ? C2D_OK : C2D_ERR_BUSY;
    if (call.make(s) != expected) out += " " + name;
  }
  if (c2d_close(s) != C2D_ERR_BUSY) out += " close";
  const c2d_error error_before = error_of(s);
  if (c2d_get_summary(s, nullptr) != C2D_ERR_ARGUMENT || c2d_last_error(s, nullptr) != C2D_ERR_ARGUMENT) out += " (null)";
  if (!is_kept(s, error_before)) out += " (kept)";
  // and what is legal
  host::Summary summary;
  c2d_error error = C2D_INIT(c2d_error);
  uint64_t need = 0;
  if (host::get_summary(s, summary) != C2D_OK) out += " (summary)";
  if (c2d_last_error(s, &error) != C2D_OK) out += " (last error)";
  if (c2d_get_state(s) < 0) out += " (state)";
  if (c2d_memory_need(&limits, &need, nullptr, nullptr) != C2D_OK) out += " (need)";
  if (!c2d_message(3)) out += " (message)";
  return out;
}

struct ReadInside {
  Deck deck;
  test::Callable<void()> inside;
  static int32_t read(void* context, char* text, int32_t size) {
    ReadInside& self = *static_cast<ReadInside*>(context);
    self.inside();
    return Deck::read(&self.deck, text, size);
  }
};

} // namespace

TEST_CASE("interface: inside a callback every call is refused as busy") {
  for (const char* name : {"hertz_lin_l", "layer_t"}) {
    const Deck deck = deck_named(name);
    const host::Limits limits = deck.limits();
    Host host;
    Machine machine(limits, enough(limits), &host.port);
    c2d_solver* s = machine.solver;
    std::map<std::string, std::pair<int, std::string>> seen; // callback: calls, what was not refused first
    bool closed = false;
    const auto inside = [&](const char* callback) {
      if (closed) return;
      auto& entry = seen[callback];
      if (entry.first++ > 3) return; // a few of each will do
      // A close that goes through would end the test: the store's calls are tried without it.
      const std::string wrong = not_busy(s, limits, std::string(callback) == "step");
      if (entry.second.empty()) entry.second = wrong;
      closed = c2d_get_state(s) < 0;
    };
    host.inside = inside;
    ReadInside reading{deck, [&] { inside("read_line"); }};
    CHECK(c2d_read_deck(s, ReadInside::read, &reading) == C2D_OK);
    CHECK(c2d_prepare(s) == C2D_OK);
    const c2d_step_fn step = [](void* context, const c2d_step*) {
      (*static_cast<test::Callable<void(const char*)>*>(context))("step");
      return 0;
    };
    test::Callable<void(const char*)> from_step = inside;
    CHECK(c2d_run(s, step, &from_step) == C2D_OK);
    Numbers numbers;
    CHECK(get_boundary(s, numbers) == C2D_OK);
    CHECK(c2d_close(s) == C2D_OK);
    for (const auto& entry : seen) {
      CAPTURE(entry.first);
      CHECK(entry.second.second == "");
    }
    for (const char* callback : {"read_line", "progress", "cancel", "clock", "step", "o", "r", "w", "s", "c"}) {
      CAPTURE(std::string(callback));
      CHECK(seen.count(callback) == 1);
    }
    if (std::string(name) == "layer_t") CHECK(seen.count("log") == 1);
  }
}

TEST_CASE("interface: a failed c2d_read_deck leaves an empty model that can read another") {
  const Deck good = small_deck();
  const host::Limits limits = good.limits();
  Host host;
  Machine machine(limits, enough(limits), &host.port);
  Numbers clean, numbers;
  REQUIRE(run_all(machine.solver, good, clean) == C2D_OK);
  for (size_t cut = 0; cut < good.lines.size(); cut += 3) {
    CAPTURE(cut);
    machine.create(limits, &host.port);
    Deck bad = good;
    bad.lines.resize(cut);
    REQUIRE(read_deck(machine.solver, bad) == C2D_ERR_INPUT);
    REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_EMPTY);
    const c2d_error error = error_of(machine.solver);
    REQUIRE(error.status == C2D_ERR_INPUT);
    REQUIRE(std::strlen(error.text) > 10);
    const host::Summary summary = summary_of(machine.solver);
    REQUIRE(summary.bodies == 0);
    REQUIRE(summary.pairs == 0);
    REQUIRE(read_deck(machine.solver, good) == C2D_OK);
    if (cut % 30 != 0) continue;
    REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
    REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
    REQUIRE(numbers == clean);
  }
}

TEST_CASE("interface: a list of bodies that is too short is told with how long it must be") {
  for (const bool checked : {false, true})
    for (int32_t room : {0, 1, 2, 5}) {
      c2d_body_limits list[5], untouched[5];
      std::memset(list, 0x55, sizeof list);
      std::memcpy(untouched, list, sizeof list);
      c2d_limits out = C2D_INIT(c2d_limits);
      out.bodies = room;
      out.body = room > 0 ? list : nullptr;
      c2d_error why = C2D_INIT(c2d_error);
      Deck deck = deck_named("block");
      const c2d_report keep = [](void* to, const c2d_error* entry) { *static_cast<c2d_error*>(to) = *entry; };
      const c2d_status status =
          checked ? c2d_check_deck(Deck::read, &deck, &out, keep, &why) : c2d_scan_deck(Deck::read, &deck, &out, &why);
      CHECK(status == (room < 2 ? C2D_ERR_LIMIT : C2D_OK));
      CHECK(out.bodies == 2);
      CHECK(out.body == (room > 0 ? list : nullptr));
      CHECK(std::memcmp(list + 2, untouched, sizeof *list) == 0);
      if (room < 2) {
        CHECK(out.pairs == 0);
        CHECK(std::memcmp(list, untouched, sizeof list) == 0);
        CHECK(std::string(why.text) == "c2d_limits.body has room for " + std::to_string(room) + ", the deck has 2 bodies");
      } else {
        CHECK(out.pairs > 0);
        CHECK(list[1].elements > 0);
        CHECK(list[1].reserved == 0);
      }
    }
}

TEST_CASE("interface: limits too small by one are told as such") {
  const Deck deck = deck_named("sample");
  const host::Limits good = deck.limits();
  struct Member {
    const char* name;
    int32_t* at;
  };
  host::Limits l = good;
  const Member members[] = {{"geometry nodes 1", &l.body[0].points},
                            {"geometry nodes 2", &l.body[1].points},
                            {"elements 1", &l.body[0].elements},
                            {"elements 2", &l.body[1].elements},
                            {"zones", &l.zones},
                            {"pairs", &l.pairs},
                            {"contact elements", &l.contact_elements},
                            {"coefficients", &l.coefficients},
                            {"paths", &l.paths}};
  for (const Member& member : members) {
    CAPTURE(std::string(member.name));
    l = good;
    --*member.at;
    Machine machine(l, enough(l), nullptr);
    REQUIRE(machine.created == C2D_OK);
    CHECK(read_deck(machine.solver, deck) == C2D_ERR_LIMIT);
    CHECK(error_of(machine.solver).status == C2D_ERR_LIMIT);
    CHECK(error_of(machine.solver).line > 0);
    const std::string name = member.name, text = error_of(machine.solver).text;
    if (name == "zones" || name == "pairs") CHECK_MESSAGE(text.find("c2d_limits." + name + " is ") == 0, text);
    CHECK(c2d_get_state(machine.solver) == C2D_STATE_EMPTY);
    CHECK(machine.guards_are_whole());
  }
  // One body for a deck of two, other shape functions: refused, whatever the word.
  l = good;
  l.bodies = 1;
  Machine one(l, enough(l), nullptr);
  const c2d_status status = read_deck(one.solver, deck);
  CHECK((status == C2D_ERR_LIMIT || status == C2D_ERR_INPUT || status == C2D_ERR_ARGUMENT));
  CHECK(c2d_get_state(one.solver) == C2D_STATE_EMPTY);
  l = good;
  l.function_nodes = 4;
  Machine cubic(l, enough(l), nullptr);
  const c2d_status other = read_deck(cubic.solver, deck);
  CHECK((other == C2D_ERR_LIMIT || other == C2D_ERR_INPUT || other == C2D_ERR_ARGUMENT));
  CHECK(c2d_get_state(cubic.solver) == C2D_STATE_EMPTY);
  // More than enough of everything does no harm.
  l = good;
  for (int b = 0; b < 2; ++b) l.body[b].points += 7, l.body[b].elements += 5, l.body[b].regions += 2;
  l.zones += 2, l.pairs += 9, l.contact_elements += 3, l.point_loads += 2, l.coefficients += 1, l.paths += 4;
  Numbers tight, loose;
  Host host1, host2;
  Machine a(good, enough(good), &host1.port), b(l, enough(l), &host2.port);
  CHECK(run_all(a.solver, deck, tight) == C2D_OK);
  CHECK(run_all(b.solver, deck, loose) == C2D_OK);
  CHECK(tight.outcome == loose.outcome);
  CHECK(Numbers::same(tight.steps, loose.steps));
  CHECK(Numbers::same(tight.boundary, loose.boundary));
}

TEST_CASE("interface: what the caller's functions return comes back") {
  const Deck deck = deck_named("sample");
  const host::Limits limits = deck.limits();
  Host host;
  Machine machine(limits, enough(limits), &host.port);
  // read_line
  for (int32_t code : {-2, -77, INT32_MIN}) {
    struct Failing {
      Deck deck;
      int32_t code;
      static int32_t read(void* context, char* text, int32_t size) {
        Failing& self = *static_cast<Failing*>(context);
        return self.deck.next == 20 ? self.code : Deck::read(&self.deck, text, size);
      }
    } failing{deck, code};
    CHECK(c2d_read_deck(machine.solver, Failing::read, &failing) == C2D_ERR_READ);
    CHECK(error_of(machine.solver).status == C2D_ERR_READ);
    CHECK(error_of(machine.solver).host_code == code);
    CHECK(c2d_get_state(machine.solver) == C2D_STATE_EMPTY);
    failing.deck.next = 0;
    host::Limits out;
    c2d_error why = C2D_INIT(c2d_error);
    CHECK(c2d_scan_deck(Failing::read, &failing, &out, &why) == C2D_ERR_READ);
    CHECK(why.host_code == code);
  }
  // step: stopped at each of the recorded steps, and the solver stays valid there
  REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
  REQUIRE(c2d_prepare(machine.solver) == C2D_OK);
  Numbers clean, numbers;
  REQUIRE(run_prepared(machine.solver, clean) == C2D_OK);
  struct Stopping {
    int32_t left;
    double load;
    static int32_t step(void* context, const c2d_step* now) {
      Stopping& self = *static_cast<Stopping*>(context);
      self.load = now->load;
      return self.left-- == 0 ? -4242 : 0;
    }
  };
  for (int32_t n = 0;; ++n) {
    CAPTURE(n);
    Stopping stopping{n, -1.0};
    const size_t told = host.faults.size();
    const c2d_status status = c2d_run(machine.solver, Stopping::step, &stopping);
    if (status == C2D_OK) {
      CHECK(n > 20);
      break;
    }
    REQUIRE(status == C2D_ERR_CALLBACK);
    REQUIRE(error_of(machine.solver).host_code == -4242);
    REQUIRE(host.faults.size() == told + 1);
    REQUIRE(is_kept(machine.solver, host.faults.back()));
    REQUIRE(c2d_get_state(machine.solver) == C2D_STATE_RUNNING);
    REQUIRE(summary_of(machine.solver).load == stopping.load);
    Numbers there;
    REQUIRE(get_boundary(machine.solver, there) == C2D_OK);
  }
  REQUIRE(run_prepared(machine.solver, numbers) == C2D_OK);
  CHECK(numbers == clean);
}

TEST_CASE("interface: structs that go in may be of version 1, longer, or none") {
  const host::Limits limits = small_deck().limits();
  struct In {
    const char* name;
    size_t size, first; // ours; that of version 1
    test::Callable<c2d_status(c2d_solver*, const void*)> give;
    test::Callable<void(void*)> fill;
  };
  const auto set = [](const auto& from) { return [from](void* to) { std::memcpy(to, &from, sizeof from); }; };
  const In ins[] = {
      {"options", sizeof(c2d_options), offsetof(c2d_options, symmetry),
       [](c2d_solver* s, const void* p) { return c2d_set_options(s, static_cast<const c2d_options*>(p)); },
       set(C2D_INIT(c2d_options))},
      {"problem", sizeof(c2d_problem), sizeof(c2d_problem),
       [](c2d_solver* s, const void* p) { return c2d_set_problem(s, static_cast<const c2d_problem*>(p)); }, set(problem())},
      {"body", sizeof(c2d_body), offsetof(c2d_body, open_regions),
       [](c2d_solver* s, const void* p) { return c2d_set_body(s, 1, static_cast<const c2d_body*>(p)); },
       set(body_of(limits, 0))},
      // This one is refused for what they say, in state empty, once its size is in order.
      {"zone", sizeof(c2d_zone), sizeof(c2d_zone),
       [](c2d_solver* s, const void* p) { return c2d_add_zone(s, static_cast<const c2d_zone*>(p)); }, set(C2D_INIT(c2d_zone))},
  };
  Host host;
  for (const In& in : ins) {
    CAPTURE(std::string(in.name));
    const bool refused = in.name == std::string("zone");
    for (size_t size : {size_t{0}, size_t{1}, size_t{3}, size_t{4}, in.first, in.size, in.size + 4, in.size + 1000}) {
      CAPTURE(size);
      Machine machine(limits, enough(limits), &host.port);
      std::vector<uint64_t> room((in.size + 1100) / 8, 0xEEEEEEEEEEEEEEEEull);
      in.fill(room.data());
      // What the caller's version does not have must not be read.
      unsigned char* bytes = reinterpret_cast<unsigned char*>(room.data());
      const uint32_t mark = static_cast<uint32_t>(size);
      std::memcpy(bytes, &mark, sizeof mark);
      for (size_t i = std::max<size_t>(size, 4); i < room.size() * 8; ++i) bytes[i] = 0xEE;
      const c2d_status status = in.give(machine.solver, bytes);
      const std::string why = error_of(machine.solver).text;
      if (size < 4) {
        CHECK(status == C2D_ERR_ARGUMENT);
        CHECK(why.find(".struct_size is ") != std::string::npos);
      } else if (refused || size == 4) { // all defaults: legal, or refused for what they say
        CHECK((status == C2D_OK || why.find("struct_size") == std::string::npos));
      } else {
        CHECK(status == C2D_OK);
      }
    }
  }
  // The port, also where a solver is taken up again.
  for (size_t size : {size_t{0}, size_t{3}, offsetof(c2d_port, start_read), sizeof(c2d_port), sizeof(c2d_port) + 64}) {
    CAPTURE(size);
    struct {
      c2d_port port;
      unsigned char more[64];
    } later;
    std::memset(&later, 0xEE, sizeof later);
    std::memcpy(&later.port, &host.port, std::min(size, sizeof later.port));
    later.port.struct_size = static_cast<uint32_t>(size);
    Machine machine(limits, enough(limits), &host.port);
    c2d_solver* s = nullptr;
    Bytes image = machine.workspace();
    const c2d_status expected = size < 4 ? C2D_ERR_ARGUMENT : C2D_OK;
    CHECK(c2d_attach(&s, image.data(), image.size(), &later.port, nullptr) == expected);
    Numbers numbers;
    if (s) CHECK(run_all(s, small_deck(), numbers) == C2D_OK);
    machine.create(limits, &later.port);
    CHECK(machine.created == expected);
    if (machine.created == C2D_OK) CHECK(run_all(machine.solver, small_deck(), numbers) == C2D_OK);
  }
}

TEST_CASE("interface: boundary points by lines and arcs have the bits of the deck") {
  const Deck deck = deck_named("sample");
  Machine read(deck.limits(), enough(deck.limits()), nullptr), called(deck.limits(), enough(deck.limits()), nullptr);
  REQUIRE(read_deck(read.solver, deck) == C2D_OK);
  c2d_solver* s = called.solver;
  const host::Limits limits = deck.limits();
  for (int32_t body = 1; body <= 2; ++body) {
    const c2d_body data = body_of(limits, body - 1);
    REQUIRE(c2d_set_body(s, body, &data) == C2D_OK);
  }
  // Node cards: letter, number, two coordinates in columns 1, 2-5, 7-16, 17-26, after a card with the origin.
  size_t at = 0;
  while (deck.lines[at].compare(0, 20, "    2     0.4000    0") != 0 &&
         deck.lines[at].find("0.4000    0.3000") == std::string::npos)
    ++at;
  ++at;
  int arcs = 0, lines = 0;
  for (int32_t body = 1; body <= 2; ++body) {
    const auto number = [&](size_t from, size_t count) { return std::stod(deck.lines[at].substr(from, count)); };
    const double origin[2] = {number(0, 10), number(10, 10)};
    ++at;
    int32_t node = 0;
    double last[2] = {0, 0};
    while (node < limits.body[body - 1].points) {
      const bool polar = deck.lines[at][0] == 'P';
      const int32_t next = static_cast<int32_t>(number(1, 4)) - (body == 2 && number(1, 4) > 58 ? 46 : 0);
      const double here[2] = {number(6, 10), number(16, 10)};
      if (node == 0 || next == node + 1) {
        double xy[2] = {here[0] + origin[0], here[1] + origin[1]};
        if (polar) {
          // A single point: the beginning of an arc, whose other end is set again later.
          REQUIRE(next < limits.body[body - 1].points);
          REQUIRE(c2d_set_arc_nodes(s, body, next, next + 1, origin, here[0], here[1], here[1]) == C2D_OK);
        } else {
          REQUIRE(c2d_set_nodes(s, body, next, 1, xy, 2) == C2D_OK);
        }
      }
      if (node > 0) {
        if (polar && next > node + 1) {
          REQUIRE(c2d_set_arc_nodes(s, body, node, next, origin, here[0], last[1], here[1]) == C2D_OK);
          ++arcs;
        } else if (!polar && next > node + 1) {
          REQUIRE(c2d_set_line_nodes(s, body, node, next, origin, last, here) == C2D_OK);
          ++lines;
        }
      }
      node = next;
      last[0] = here[0], last[1] = here[1];
      ++at;
    }
  }
  CHECK(arcs > 1);
  CHECK(lines > 5);
  // The points are asked for in state model: compare what the workspaces hold.
  for (int32_t body = 1; body <= 2; ++body) {
    const int32_t count = limits.body[body - 1].points;
    std::vector<double> expected(static_cast<size_t>(2 * count));
    REQUIRE(c2d_get(read.solver, C2D_NODE_X, body, 1, count, expected.data(), 2) == C2D_OK);
    REQUIRE(c2d_get(read.solver, C2D_NODE_Y, body, 1, count, expected.data() + 1, 2) == C2D_OK);
    const double* found = c2d::model_of(s).xy[body - 1];
    int wrong = 0;
    for (size_t i = 0; i < expected.size(); ++i) wrong += std::memcmp(&expected[i], found + i, sizeof(double)) != 0;
    CHECK(wrong == 0);
  }
  // Wrong ones.
  const double xy[2] = {0, 1}, far[2] = {1e100, 1e100}, bad[2] = {std::nan(""), 0};
  const Bytes before = without_error(s);
  CHECK(c2d_set_line_nodes(s, 1, 2, 2, nullptr, xy, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 1, 0, 2, nullptr, xy, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 1, 1, 10000, nullptr, xy, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 3, 1, 2, nullptr, xy, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 1, 1, 2, nullptr, nullptr, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 1, 1, 2, far, far, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 1, 1, 2, bad, xy, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_line_nodes(s, 1, INT32_MIN, INT32_MAX, nullptr, xy, xy) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_arc_nodes(s, 1, 1, 2, nullptr, 1, 0, 90) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_arc_nodes(s, 1, 1, 2, xy, -1, 0, 90) == C2D_ERR_ARGUMENT);
  CHECK(c2d_set_arc_nodes(s, 1, 1, 2, xy, 1, 0, std::nan("")) == C2D_ERR_ARGUMENT);
  CHECK(without_error(s) == before);
}
