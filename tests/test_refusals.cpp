// What cannot be meant is refused before anything happens, by the name of the member or of the argument.
#include "contact2d_cards.h"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>

using namespace runs;

namespace {

constexpr double kMark = -77.25;
const double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

bool says(const c2d_error& e, const std::string& what) { return std::string(e.text).find(what) != std::string::npos; }

host::Limits two_blocks() { return deck_named("block").limits(); }

// Why there is no solver with these.
c2d_error why_not(const c2d_limits& limits, const c2d_port* port) {
  c2d_error why = C2D_INIT(c2d_error);
  Bytes memory(1000000);
  c2d_solver* s = reinterpret_cast<c2d_solver*>(memory.data());
  const c2d_status status = c2d_create(&s, memory.data(), memory.size(), &limits, port, &why);
  CHECK(status == why.status);
  CHECK((s == nullptr) == (status != C2D_OK));
  return why;
}

// A whole port, and one with the i-th of its functions missing.
c2d_port port_of(RamStore& store) {
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  return port;
}

struct Hearing : RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  std::vector<c2d_error> told;
  Hearing() {
    serve(port);
    port.log = [](void* context, const c2d_error* entry) {
      if (entry->severity == C2D_FAULT) static_cast<Hearing&>(self(context)).told.push_back(*entry);
    };
  }
  Hearing(const Hearing&) = delete;
  Hearing& operator=(const Hearing&) = delete;
};

// A solver that follows a deck, and what it says to calls that cannot be meant.
struct Running {
  Deck deck;
  Hearing host;
  Machine machine;
  c2d_solver* s;
  explicit Running(const char* name, int32_t state = C2D_STATE_RUNNING)
      : deck(deck_named(name)), machine(deck.limits(), 4000000, &host.port), s(machine.solver) {
    REQUIRE(machine.created == C2D_OK);
    if (state == C2D_STATE_EMPTY) return;
    REQUIRE(read_deck(s, deck) == C2D_OK);
    REQUIRE(c2d_prepare(s) == C2D_OK);
    const double mu = 0.3, load = 0.5;
    c2d_outcome outcome = C2D_REACHED;
    REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
    REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
  }
  // Was it refused as an argument, once, with this in its text?
  bool refused(c2d_status status, const std::string& what) {
    const bool once = host.told.size() == 1;
    const bool right = status == C2D_ERR_ARGUMENT && once && host.told[0].status == status && says(host.told[0], what) &&
                       std::string(error_of(s).text) == host.told[0].text;
    if (!right) MESSAGE(what << ": status " << status << ", " << (once ? host.told[0].text : "not told once"));
    host.told.clear();
    return right;
  }
};

// What a call said and told, once.
struct Refused {
  Hearing& host;
  void operator()(c2d_status status, c2d_status expected, const std::string& what) const {
    CAPTURE(what);
    CHECK(status == expected);
    REQUIRE(host.told.size() == 1);
    CHECK_MESSAGE(says(host.told[0], what), host.told[0].text);
    CHECK(host.told[0].status == expected);
    host.told.clear();
  }
};

} // namespace

TEST_CASE("refusals: a size that cannot be meant is named") {
  const struct {
    const char* name;
    int32_t c2d_limits::*member;
    int32_t least;
  } sizes[] = {{"bodies", &c2d_limits::bodies, 1},
               {"function_nodes", &c2d_limits::function_nodes, 1},
               {"zones", &c2d_limits::zones, 0},
               {"pairs", &c2d_limits::pairs, 0},
               {"contact_elements", &c2d_limits::contact_elements, 0},
               {"point_loads", &c2d_limits::point_loads, 0},
               {"coefficients", &c2d_limits::coefficients, 0},
               {"paths", &c2d_limits::paths, 0},
               {"load_cases", &c2d_limits::load_cases, 0},
               {"panel_columns", &c2d_limits::panel_columns, 0},
               {"free_pairs", &c2d_limits::free_pairs, 0},
               {"point_sets", &c2d_limits::point_sets, 0},
               {"curves", &c2d_limits::curves, 0},
               {"platens", &c2d_limits::platens, 0}};
  CHECK(why_not(two_blocks(), nullptr).status == C2D_OK);
  for (const auto& size : sizes) {
    CAPTURE(std::string(size.name));
    host::Limits limits = two_blocks();
    limits.*size.member = size.least - 1;
    const c2d_error why = why_not(limits, nullptr);
    CHECK(why.status == C2D_ERR_ARGUMENT);
    CHECK(says(why, std::string("c2d_limits.") + size.name + " is " + std::to_string(size.least - 1) + ", expected "));
    uint64_t bytes = 5;
    c2d_error need = C2D_INIT(c2d_error);
    CHECK(c2d_memory_need(&limits, &bytes, nullptr, &need) == C2D_ERR_ARGUMENT);
    CHECK(bytes == 5);
    CHECK(std::string(need.text) == why.text);
  }
  for (int32_t b = 0; b < 2; ++b) {
    const char* const names[] = {"points", "elements", "regions"};
    for (int i = 0; i < 3; ++i) {
      host::Limits limits = two_blocks();
      (i == 0 ? limits.body[b].points : i == 1 ? limits.body[b].elements : limits.body[b].regions) = 0;
      const c2d_error why = why_not(limits, nullptr);
      CHECK(why.status == C2D_ERR_ARGUMENT);
      CHECK(says(why, "c2d_limits.body[" + std::to_string(b) + "]." + names[i] + " is 0, expected 1 or more"));
    }
  }
  host::Limits limits = two_blocks();
  limits.body = nullptr;
  CHECK(says(why_not(limits, nullptr), "c2d_limits.body is null, expected an array of bodies"));
  limits = two_blocks();
  limits.free_pairs = limits.pairs + 1;
  CHECK(says(why_not(limits, nullptr), "c2d_limits.free_pairs is"));
  limits = two_blocks();
  limits.function_nodes = 5;
  CHECK(says(why_not(limits, nullptr), "c2d_limits.function_nodes is 5, expected 1 to 4"));
}

TEST_CASE("refusals: what a port lacks is named") {
  RamStore store;
  const c2d_port whole = port_of(store);
  const host::Limits limits = two_blocks();
  CHECK(why_not(limits, &whole).status == C2D_OK);
  const auto lacks = [&](c2d_port port, const char* what) {
    const c2d_error why = why_not(limits, &port);
    CHECK(why.status == C2D_ERR_ARGUMENT);
    CHECK_MESSAGE(says(why, what), why.text);
    // where a solver is taken up again as well
    Machine machine(limits, 1000000, nullptr);
    Bytes image = machine.workspace();
    c2d_solver* s = machine.solver;
    c2d_error again = C2D_INIT(c2d_error);
    CHECK(c2d_attach(&s, image.data(), image.size(), &port, &again) == C2D_ERR_ARGUMENT);
    CHECK(s == nullptr);
    CHECK(std::string(again.text) == why.text);
  };
  const auto lacks_one = [&](c2d_port port, auto member, const char* what) {
    port.*member = nullptr;
    lacks(port, what);
  };
  lacks_one(whole, &c2d_port::open, "c2d_port.open is null, expected all of open, read, write, sync, close, or none");
  lacks_one(whole, &c2d_port::read, "c2d_port.read is null");
  lacks_one(whole, &c2d_port::write, "c2d_port.write is null");
  lacks_one(whole, &c2d_port::sync, "c2d_port.sync is null");
  lacks_one(whole, &c2d_port::close, "c2d_port.close is null");
  c2d_port ahead = whole;
  ahead.start_read = [](void*, int32_t, uint64_t, void*, uint64_t, int32_t*) { return 1; };
  ahead.start_write = [](void*, int32_t, uint64_t, const void*, uint64_t, int32_t*) { return 1; };
  ahead.wait = [](void*, int32_t) { return 1; };
  CHECK(why_not(limits, &ahead).status == C2D_OK);
  lacks_one(ahead, &c2d_port::start_read,
            "c2d_port.start_read is null, expected all of start_read, start_write, wait, or none");
  lacks_one(ahead, &c2d_port::start_write, "c2d_port.start_write is null");
  lacks_one(ahead, &c2d_port::wait, "c2d_port.wait is null");
  c2d_port port = whole;
  port.threads = 4;
  lacks(port, "c2d_port.parallel_for is null, but threads is 4");
  port = whole, port.threads = -1;
  lacks(port, "c2d_port.threads is -1");
  port = whole, port.struct_size = 0;
  lacks(port, "c2d_port.struct_size is 0, expected C2D_INIT(c2d_port)");
  // None at all: the model can be checked, but not prepared.
  Machine storeless(deck_named("block").limits(), 1000000, nullptr);
  REQUIRE(read_deck(storeless.solver, deck_named("block")) == C2D_OK);
  CHECK(c2d_prepare(storeless.solver) == C2D_ERR_ARGUMENT);
  CHECK(says(error_of(storeless.solver), "c2d_port.open is null"));
  CHECK(c2d_restore(storeless.solver) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_state(storeless.solver) == C2D_STATE_MODEL);
}

TEST_CASE("refusals: a struct without C2D_INIT is named") {
  Running going("block"), empty("block", C2D_STATE_EMPTY);
  // What a struct on the stack that nobody set may begin with.
  for (uint32_t size : {0u, 1u, 3u, 7u, 0xCCCCCCCCu, 0x7ffe1234u, 0xffffffffu}) {
    CAPTURE(size);
    const std::string found = ".struct_size is " + std::to_string(size) + ", expected C2D_INIT(";
    const auto given = [&](auto data, const std::string& name, auto call) {
      data.struct_size = size;
      CHECK(empty.refused(call(empty.s, &data), name + found + name + ")"));
      CHECK(empty.refused(call(empty.s, static_cast<decltype(&data)>(nullptr)), name + " is null"));
      CHECK(c2d_get_state(empty.s) == C2D_STATE_EMPTY);
    };
    given(c2d_options(), "c2d_options", c2d_set_options);
    given(c2d_problem(), "c2d_problem", c2d_set_problem);
    given(c2d_body(), "c2d_body", [](c2d_solver* s, const c2d_body* b) { return c2d_set_body(s, 1, b); });
    given(c2d_zone(), "c2d_zone", c2d_add_zone);
    given(c2d_curve(), "c2d_curve", c2d_add_curve);
    given(c2d_points(), "c2d_points", c2d_add_points);
    const auto asked = [&](auto room, const std::string& name, auto call) {
      room.struct_size = size;
      auto before = room;
      CHECK(going.refused(call(going.s, &room), name + found + name + ")"));
      CHECK(std::memcmp(&room, &before, sizeof room) == 0);
      CHECK(going.refused(call(going.s, static_cast<decltype(&room)>(nullptr)), name + " is null"));
    };
    asked(c2d_summary(), "c2d_summary", c2d_get_summary);
    asked(c2d_body_result(), "c2d_body_result", [](c2d_solver* s, c2d_body_result* b) { return c2d_get_body_result(s, 1, b); });
    asked(c2d_zone(), "c2d_zone", [](c2d_solver* s, c2d_zone* z) { return c2d_get_zone(s, 1, z); });
    asked(c2d_zone_state(), "c2d_zone_state", [](c2d_solver* s, c2d_zone_state* z) { return c2d_get_zone_state(s, 1, z); });
    // c2d_last_error says it to the log alone: what is asked for must not be lost to the asking
    c2d_error room = c2d_error();
    room.struct_size = size;
    CHECK(going.refused(c2d_get(going.s, -5, 0, 1, 1, nullptr, 1), "field"));
    CHECK(c2d_last_error(going.s, &room) == C2D_ERR_ARGUMENT);
    REQUIRE(going.host.told.size() == 1);
    CHECK(says(going.host.told[0], "c2d_error" + found + "c2d_error)"));
    CHECK(says(error_of(going.s), "field"));
    going.host.told.clear();
    // and without a solver
    host::Limits limits = two_blocks();
    limits.struct_size = size;
    CHECK(says(why_not(limits, nullptr), "c2d_limits" + found + "c2d_limits)"));
    c2d_error why = C2D_INIT(c2d_error);
    Deck deck = deck_named("block");
    CHECK(c2d_scan_deck(Deck::read, &deck, &limits, &why) == C2D_ERR_ARGUMENT);
    CHECK(says(why, "c2d_limits" + found + "c2d_limits)"));
    CHECK(c2d_scan_deck(nullptr, &deck, &limits, &why) == C2D_ERR_ARGUMENT);
    CHECK(says(why, "read_line is null"));
    limits = two_blocks();
    CHECK(c2d_scan_deck(Deck::read, &deck, &limits, &room) == C2D_ERR_ARGUMENT);
    c2d_solver* s = going.s;
    Bytes memory(1000000);
    CHECK(c2d_create(&s, memory.data(), memory.size(), &limits, nullptr, &room) == C2D_ERR_ARGUMENT);
    CHECK(s == nullptr);
  }
}

TEST_CASE("refusals: strides, counts and numbers that cannot be meant") {
  Running going("block"), empty("block", C2D_STATE_EMPTY);
  const host::Summary sizes = summary_of(going.s);
  std::vector<double> room(400, kMark);
  double* middle = room.data() + 200; // whoever writes in front of it is found
  const auto untouched = [&] {
    for (double number : room)
      if (number != kMark) return false;
    return true;
  };
  const int64_t wrong[] = {0, -1, -2, INT64_MIN, INT64_MAX, INT64_MAX / 8};
  for (const int64_t stride : wrong) {
    CAPTURE(stride);
    const std::string is = "stride is " + std::to_string(stride);
    for (int32_t field : {C2D_TN, C2D_X, C2D_END_UX, C2D_END_X, C2D_NODE_X, C2D_PAIR_ELEMENT1}) {
      CAPTURE(field);
      CHECK(going.refused(c2d_get(going.s, field, 1, 1, 2, middle, stride), is));
    }
    const double at[4] = {0.1, 0.1, 0.2, 0.2};
    CHECK(going.refused(c2d_interior(going.s, 0, 2, at, stride, middle, C2D_POINT_FIELDS), "xy_" + is));
    CHECK(going.refused(c2d_interior(going.s, 0, 2, at, 2, middle, stride), "out_" + is));
    CHECK(going.refused(c2d_indicators(going.s, 1, 1, 2, middle, stride), is));
    c2d_points set = C2D_INIT(c2d_points);
    set.kind = C2D_POINTS_LINE;
    set.body = 1;
    set.count[0] = 5;
    int32_t total = -3;
    CHECK(c2d_expand_points(&set, 1, 5, middle, stride, &total) == C2D_ERR_ARGUMENT);
    CHECK(total == -3);
    c2d_body body = C2D_INIT(c2d_body);
    body.element_nodes = 2, body.elements = sizes.body[0].elements, body.regions = 1, body.youngs_modulus = 1;
    if (c2d_get_state(empty.s) == C2D_STATE_EMPTY) REQUIRE(c2d_set_body(empty.s, 1, &body) == C2D_OK);
    CHECK(empty.refused(c2d_set_nodes(empty.s, 1, 1, 2, middle, stride), is));
  }
  const double at[2] = {0.1, 0.1};
  for (int64_t stride : {1, 10}) { // of two numbers, of a row
    CHECK(going.refused(c2d_interior(going.s, 0, 2, at, 1, middle, C2D_POINT_FIELDS), "xy_stride is 1, expected at least 2"));
    CHECK(going.refused(c2d_interior(going.s, 0, 2, at, 2, middle, stride), "out_stride is"));
  }
  CHECK(empty.refused(c2d_set_nodes(empty.s, 1, 1, 2, middle, 1), "stride is 1, expected at least 2"));
  // counts
  for (int32_t count : {-1, INT32_MIN}) {
    const std::string is = "count is " + std::to_string(count);
    CHECK(going.refused(c2d_get(going.s, C2D_TN, 0, 1, count, middle, 1), is));
    CHECK(going.refused(c2d_interior(going.s, 0, count, at, 2, middle, C2D_POINT_FIELDS), is));
    CHECK(going.refused(c2d_indicators(going.s, 1, 1, count, middle, C2D_OFF_FIELDS), is));
    CHECK(empty.refused(c2d_set_nodes(empty.s, 1, 1, count, middle, 2), is));
  }
  for (int32_t first : {0, -1, INT32_MAX, INT32_MIN}) {
    CHECK(going.refused(c2d_get(going.s, C2D_TN, 0, first, 2, middle, 1), "first is " + std::to_string(first)));
    CHECK(going.refused(c2d_indicators(going.s, 1, first, 2, middle, C2D_OFF_FIELDS), "first is " + std::to_string(first)));
    CHECK(empty.refused(c2d_set_nodes(empty.s, 1, first, 2, middle, 2), "boundary point number is " + std::to_string(first)));
  }
  CHECK(going.refused(c2d_get(going.s, C2D_TN, 0, 2, INT32_MAX, middle, 1), "count is"));
  CHECK(empty.refused(c2d_set_nodes(empty.s, 1, 2, INT32_MAX, middle, 2), "last boundary point number is"));
  CHECK(going.refused(c2d_get(going.s, C2D_TN, 0, 1, 2, nullptr, 1), "out is null"));
  CHECK(going.refused(c2d_indicators(going.s, 1, 2, INT32_MAX, middle, C2D_OFF_FIELDS), "count is"));
  CHECK(going.refused(c2d_indicators(going.s, 1, 1, 2, middle, C2D_OFF_FIELDS - 1), "stride is 8, expected at least 9"));
  CHECK(going.refused(c2d_indicators(going.s, 1, 1, 2, nullptr, C2D_OFF_FIELDS), "out is null"));
  CHECK(going.refused(c2d_interior(going.s, 0, 2, nullptr, 2, middle, C2D_POINT_FIELDS), "xy is null"));
  CHECK(going.refused(c2d_interior(going.s, 0, 2, at, 2, nullptr, C2D_POINT_FIELDS), "out is null"));
  CHECK(empty.refused(c2d_set_nodes(empty.s, 1, 1, 2, nullptr, 2), "xy is null"));
  // numbers
  for (double number : {kNan, kInfinity, -kInfinity}) {
    const double bad[4] = {0.1, 0.1, 0.1, number};
    CHECK(going.refused(c2d_interior(going.s, 0, 2, bad, 2, middle, C2D_POINT_FIELDS), "a coordinate in xy is "));
    CHECK(empty.refused(c2d_set_nodes(empty.s, 1, 1, 2, bad, 2), "a coordinate is "));
    c2d_outcome outcome = 55;
    CHECK(going.refused(c2d_advance(going.s, &number, 1, &outcome), "load is "));
    CHECK(outcome == 55);
    CHECK(going.refused(c2d_next_event(going.s, &number, 1, middle), "direction is "));
    if (number != kInfinity) CHECK(going.refused(c2d_begin(going.s, &number, 1), "mu is "));
  }
  c2d_outcome outcome = 55;
  for (int32_t cases : {0, -1, 2}) {
    const double load[2] = {1, 1};
    CHECK(going.refused(c2d_advance(going.s, load, cases, &outcome), "cases is " + std::to_string(cases) + ", expected 1"));
    CHECK(going.refused(c2d_next_event(going.s, load, cases, middle), "cases is " + std::to_string(cases)));
  }
  CHECK(going.refused(c2d_advance(going.s, nullptr, 1, &outcome), "load is null"));
  CHECK(going.refused(c2d_advance(going.s, at, 1, nullptr), "outcome is null"));
  CHECK(going.refused(c2d_next_event(going.s, nullptr, 1, middle), "direction is null"));
  CHECK(going.refused(c2d_next_event(going.s, at, 1, nullptr), "step is null"));
  CHECK(going.refused(c2d_begin(going.s, nullptr, 1), "mu is null"));
  CHECK(outcome == 55);
  CHECK(untouched());
}

TEST_CASE("refusals: lists, loads and limits by the names of their arguments and members") {
  Running going("block"), empty("block", C2D_STATE_EMPTY);
  c2d_solver *s = going.s, *e = empty.s;
  int32_t integers[8];
  double numbers[8];
  std::fill_n(integers, 8, -77);
  std::fill_n(numbers, 8, kMark);
  for (int32_t i : {0, -1, 1000, INT32_MAX, INT32_MIN}) {
    const std::string is = " is " + std::to_string(i) + ", expected ";
    CHECK(going.refused(c2d_get_condition(s, i, 1, 1, 1, integers, numbers), "body" + is + "1 to 2"));
    CHECK(going.refused(c2d_get_condition(s, 2, i, 1, 1, integers, numbers), "element" + is + "1 to 56"));
    CHECK(going.refused(c2d_get_condition(s, 2, 1, i, 1, integers, numbers), "local" + is + "1 to 2"));
    CHECK(going.refused(c2d_get_condition(s, 2, 1, 1, i, integers, numbers), "load_case" + is + "1"));
    CHECK(going.refused(c2d_get_body_force(s, i, 1, numbers, numbers, numbers), "body" + is));
    CHECK(going.refused(c2d_get_body_force(s, 1, i, numbers, numbers, numbers), "load_case" + is));
    CHECK(going.refused(c2d_get_rigid(s, i, 1, integers, numbers, numbers), "body" + is));
    CHECK(going.refused(c2d_get_rigid(s, 1, i, integers, numbers, numbers), "load_case" + is));
    CHECK(going.refused(c2d_get_point_load(s, i, integers, integers, numbers, numbers), "i" + is));
    CHECK(going.refused(c2d_get_path(s, i, integers, numbers, 1), "i" + is));
    CHECK(going.refused(c2d_get_path(s, 1, integers, numbers, i), "cases" + is + "1"));
    CHECK(going.refused(c2d_get_friction(s, 0, i, numbers), "i" + is));
    if (i != 0) CHECK(going.refused(c2d_get_friction(s, i, 1, numbers), "zone" + is));
    CHECK(going.refused(c2d_get_region(s, i, 1, integers, integers), "body" + is));
    CHECK(going.refused(c2d_get_region(s, 1, i, integers, integers), "i" + is + "1"));
    CHECK(going.refused(c2d_get(s, C2D_NODE_X, i, 1, 1, numbers, 1), "body" + is));
    CHECK(empty.refused(c2d_add_point_load(e, 1, i, 0, 0, 0, 0), "load case" + is));
    CHECK(empty.refused(c2d_set_interference(e, i), "load case" + is));
    CHECK(empty.refused(c2d_set_body_force(e, 1, i, numbers, 0, numbers), "load case" + is));
    CHECK(empty.refused(c2d_add_path(e, 1, numbers, i),
                        "number of load factors (one per load case, that of an interference too)" + is));
  }
  CHECK(going.refused(c2d_get_condition(s, 1, 1, 1, 1, nullptr, numbers), "codes is null"));
  CHECK(going.refused(c2d_get_condition(s, 1, 1, 1, 1, integers, nullptr), "values is null"));
  CHECK(going.refused(c2d_get_body_force(s, 1, 1, nullptr, numbers, numbers), "force is null"));
  CHECK(going.refused(c2d_get_body_force(s, 1, 1, numbers, nullptr, numbers), "rho_omega2 is null"));
  CHECK(going.refused(c2d_get_body_force(s, 1, 1, numbers, numbers, nullptr), "axis is null"));
  CHECK(going.refused(c2d_get_rigid(s, 1, 1, nullptr, numbers, numbers), "is_rigid is null"));
  CHECK(going.refused(c2d_get_rigid(s, 1, 1, integers, nullptr, numbers), "motion is null"));
  CHECK(going.refused(c2d_get_interference(s, nullptr), "load_case is null"));
  CHECK(going.refused(c2d_get_path(s, 1, nullptr, numbers, 1), "increments is null"));
  CHECK(going.refused(c2d_get_path(s, 1, integers, nullptr, 1), "load is null"));
  CHECK(going.refused(c2d_get_friction(s, 0, 1, nullptr), "mu is null"));
  CHECK(going.refused(c2d_get_region(s, 1, 1, nullptr, integers), "first_element is null"));
  CHECK(going.refused(c2d_get_region(s, 1, 1, integers, nullptr), "last_element is null"));
  CHECK(empty.refused(c2d_set_body_force(e, 1, 1, nullptr, 0, nullptr), "force is null"));
  CHECK(empty.refused(c2d_set_body_force(e, 1, 1, numbers, 1, nullptr), "axis is null"));
  CHECK(empty.refused(c2d_set_rigid(e, 1, 1, nullptr, numbers), "motion is null"));
  CHECK(empty.refused(c2d_set_rigid(e, 1, 1, numbers, nullptr), "axis is null"));
  CHECK(empty.refused(c2d_add_path(e, 1, nullptr, 1), "load is null"));
  for (double number : {kNan, kInfinity, -kInfinity}) {
    const double good[3] = {0, 0, 0};
    CHECK(empty.refused(c2d_add_point_load(e, 1, 1, number, 0, 0, 0), "x is "));
    CHECK(empty.refused(c2d_add_point_load(e, 1, 1, 0, number, 0, 0), "y is "));
    CHECK(empty.refused(c2d_add_point_load(e, 1, 1, 0, 0, number, 0), "fx is "));
    CHECK(empty.refused(c2d_add_point_load(e, 1, 1, 0, 0, 0, number), "fy is "));
    CHECK(empty.refused(c2d_set_body_force(e, 1, 1, good, number, good), "rho_omega2 is "));
    for (size_t k = 0; k < 3; ++k) {
      double bad[3] = {0, 0, 0};
      bad[k] = number;
      const std::string at = "[" + std::to_string(k) + "] is ";
      CHECK(empty.refused(c2d_set_rigid(e, 1, 1, bad, good), "motion" + at));
      if (k == 2) continue;
      CHECK(empty.refused(c2d_set_rigid(e, 1, 1, good, bad), "axis" + at));
      CHECK(empty.refused(c2d_set_body_force(e, 1, 1, bad, 0, good), "force" + at));
      CHECK(empty.refused(c2d_set_body_force(e, 1, 1, good, 0, bad), "axis" + at));
    }
  }
  // Limits that are used up, by the member and what it has to be.
  host::Limits limits = two_blocks();
  limits.coefficients = 1, limits.paths = 2, limits.point_loads = 0, limits.point_sets = 0;
  Machine machine(limits, 4000000, nullptr);
  const double load = 1;
  const auto full = [&](c2d_status status, const char* what) {
    CHECK(status == C2D_ERR_LIMIT);
    CHECK_MESSAGE(says(error_of(machine.solver), what), error_of(machine.solver).text);
  };
  REQUIRE(c2d_add_friction(machine.solver, 0.1) == C2D_OK);
  full(c2d_add_friction(machine.solver, 0.1), "c2d_limits.coefficients is 1, expected 2 or more");
  REQUIRE(c2d_add_path(machine.solver, 1, &load, 1) == C2D_OK);
  REQUIRE(c2d_add_path(machine.solver, 1, &load, 1) == C2D_OK);
  full(c2d_add_path(machine.solver, 1, &load, 1), "c2d_limits.paths is 2, expected 3 or more");
  full(c2d_add_point_load(machine.solver, 1, 1, 0, 0, 1, 1), "c2d_limits.point_loads is 0, expected 1 or more");
  c2d_points points = C2D_INIT(c2d_points);
  points.body = 1;
  full(c2d_add_points(machine.solver, &points), "c2d_limits.point_sets is 0, expected 1 or more");
  for (int i = 0; i < 8; ++i) CHECK((integers[i] == -77 && numbers[i] == kMark));
}

TEST_CASE("refusals: bodies, regions, conditions and friction in the wrong order or of other numbers") {
  const host::Limits limits = two_blocks();
  Hearing host;
  Machine machine(limits, 4000000, &host.port);
  c2d_solver* s = machine.solver;
  const Refused refused{host};
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = 10, body.regions = 1, body.youngs_modulus = 1;
  c2d_body other = body;
  other.open_regions = 2;
  refused(c2d_set_body(s, 1, &other), C2D_ERR_ARGUMENT, "number of open regions is 2, expected 0 to 1");
  const auto too_many = [&](c2d_body large, int32_t b, c2d_status expected, const std::string& what) {
    refused(c2d_set_body(s, b, &large), expected, what);
    CHECK(error_of(s).body == (expected == C2D_ERR_LIMIT ? b : 0));
  };
  other = body, other.elements = 0;
  too_many(other, 1, C2D_ERR_ARGUMENT, "number of elements is 0, expected 1 or more");
  other = body, other.regions = -1;
  too_many(other, 2, C2D_ERR_ARGUMENT, "number of regions is -1, expected 1 or more");
  for (int32_t b = 1; b <= 2; ++b) {
    const std::string member = "c2d_limits.body[" + std::to_string(b - 1) + "].";
    const c2d_body_limits& room = limits.body[b - 1];
    const auto is = [](int32_t limit, int32_t needed) {
      return " is " + std::to_string(limit) + ", expected " + std::to_string(needed) + " or more";
    };
    other = body, other.elements = room.elements + 1;
    too_many(other, b, C2D_ERR_LIMIT, member + "elements" + is(room.elements, room.elements + 1));
    other = body, other.regions = room.regions + 1;
    too_many(other, b, C2D_ERR_LIMIT, member + "regions" + is(room.regions, room.regions + 1));
    other = body, other.element_nodes = 4, other.elements = room.elements;
    too_many(other, b, C2D_ERR_LIMIT, member + "points" + is(room.points, 3 * room.elements));
  }
  REQUIRE(c2d_set_body(s, 1, &body) == C2D_OK);
  other = body, other.elements = 9;
  refused(c2d_set_body(s, 1, &other), C2D_ERR_ARGUMENT, "given before, with other numbers of elements");
  const int32_t codes[4] = {1, 1, 0, 0};
  const double values[4] = {0, 0, 1, 2}, others_x[4] = {0, 0, 3, 2}, others_y[4] = {0, 0, 1, 3};
  refused(c2d_set_condition(s, 1, 1, 1, 1, codes, values), C2D_ERR_ARGUMENT, "give the body and all its regions first");
  refused(c2d_add_region(s, 1, 2, 10), C2D_ERR_ARGUMENT, "first element of the region is 2, expected 1");
  refused(c2d_add_region(s, 1, 1, 0), C2D_ERR_ARGUMENT, "last element of the region is 0, expected 1 to 10");
  refused(c2d_add_region(s, 1, 1, 11), C2D_ERR_ARGUMENT, "last element of the region is 11");
  refused(c2d_add_region(s, 1, 1, 9), C2D_ERR_ARGUMENT, "last element of the last region is 9, expected 10");
  REQUIRE(c2d_add_region(s, 1, 1, 10) == C2D_OK);
  refused(c2d_add_region(s, 1, 11, 12), C2D_ERR_LIMIT, "number of regions is 2, expected 1");
  for (int32_t i : {0, -1, 3}) {
    const std::string is = " is " + std::to_string(i) + ", expected 1";
    refused(c2d_set_condition(s, 1, 1, i, 1, codes, values), C2D_ERR_ARGUMENT, "local functional node" + is);
    if (i != 3) refused(c2d_set_condition(s, 1, i, 1, 1, codes, values), C2D_ERR_ARGUMENT, "element number" + is);
    refused(c2d_set_condition(s, 1, 1, 1, i, codes, values), C2D_ERR_ARGUMENT, "load case" + is);
    const int32_t wrong[4] = {0, 0, i == 0 ? 2 : i, 0};
    refused(c2d_set_condition(s, 1, 1, 1, 1, wrong, values), C2D_ERR_ARGUMENT, "condition code is ");
  }
  refused(c2d_set_condition(s, 1, 1, 1, 1, nullptr, values), C2D_ERR_ARGUMENT, "codes is null");
  refused(c2d_set_condition(s, 1, 1, 1, 1, codes, nullptr), C2D_ERR_ARGUMENT, "values is null");
  for (size_t k = 0; k < 4; ++k) {
    const int32_t known[4] = {0, 0, 0, 0};
    double bad[4] = {0, 0, 0, 0};
    bad[k] = kNan;
    const char* const names[] = {"tx is nan", "ty is nan", "ux is nan", "uy is nan"};
    refused(c2d_set_condition(s, 1, 1, 1, 1, known, bad), C2D_ERR_ARGUMENT, names[k]);
  }
  double corners[20]; // elements without length have nodes of their own
  for (size_t k = 0; k < 10; ++k) corners[2 * k] = std::cos(0.6 * double(k)), corners[2 * k + 1] = std::sin(0.6 * double(k));
  REQUIRE(c2d_set_nodes(s, 1, 1, 10, corners, 2) == C2D_OK);
  REQUIRE(c2d_set_condition(s, 1, 1, 2, 1, codes, values) == C2D_OK); // the node of element 2's first end
  refused(c2d_set_condition(s, 1, 2, 1, 1, codes, others_x), C2D_ERR_ARGUMENT, "prescribe different x-displacements");
  refused(c2d_set_condition(s, 1, 2, 1, 1, codes, others_y), C2D_ERR_ARGUMENT, "prescribe different y-displacements");
  REQUIRE(c2d_add_friction(s, 0.1) == C2D_OK);
  refused(c2d_set_zone_friction(s, 1, 1, 0.1), C2D_ERR_ARGUMENT, "contact zone is 1, expected 1 to 0");
  refused(c2d_set_zone_friction(s, 1, 1, -0.1), C2D_ERR_ARGUMENT, "coefficient of friction is -0.1");
  REQUIRE(c2d_set_symmetry(s, 0, 1.0) == C2D_OK);
  refused(c2d_set_symmetry(s, 0, 1.0), C2D_ERR_ARGUMENT, "a second line of symmetry in this direction");
  REQUIRE(c2d_set_symmetry(s, 1, 1.0) == C2D_OK);
  refused(c2d_set_symmetry(s, 1, 2.0), C2D_ERR_ARGUMENT, "a second line of symmetry in this direction");
}

TEST_CASE("refusals: zones whose ranges the bodies do not have, and values that contradict others") {
  host::Limits limits = two_blocks();
  limits.zones = limits.load_cases = 2;
  limits.pairs = 5, limits.contact_elements = 4, limits.free_pairs = 3;
  Hearing host;
  Machine machine(limits, 4000000, &host.port);
  c2d_solver* s = machine.solver;
  const Refused refused{host};
  c2d_zone good = C2D_INIT(c2d_zone); // elements 3, 4 of body 1 face 8, 7 of body 2
  good.pairs = 3;
  good.side1 = {1, 3, 4, 0, 3, 5};
  good.side2 = {2, 8, 7, 0, 9, 7};
  refused(c2d_add_zone(s, &good), C2D_ERR_ARGUMENT, "give both bodies and all their regions before the contact zones");
  const double none[4] = {0, 0, 0, 0}, here[4] = {0, 0, 1, 0}, there[4] = {0, 0, 2, 0}, pull[4] = {1, 0, 0, 0};
  double corners[20]; // elements without length have nodes of their own
  for (size_t k = 0; k < 10; ++k) corners[2 * k] = std::cos(0.6 * double(k)), corners[2 * k + 1] = std::sin(0.6 * double(k));
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = 10, body.regions = 1, body.youngs_modulus = 1;
  for (int32_t b = 1; b <= 2; ++b) {
    REQUIRE(c2d_set_body(s, b, &body) == C2D_OK);
    refused(c2d_set_values(s, b, 1, 0, 2, none), C2D_ERR_ARGUMENT, "give the body and all its regions first");
    REQUIRE(c2d_add_region(s, b, 1, 10) == C2D_OK);
    REQUIRE(c2d_set_nodes(s, b, 1, 10, corners, 2) == C2D_OK);
  }
  for (const int32_t kind : {C2D_ZONE_MATCHING, C2D_ZONE_FREE})
    for (const int32_t number : {0, -1, 11}) {
      CAPTURE(kind);
      const std::string is = " is " + std::to_string(number) + ", expected 1 to 10";
      c2d_zone zone = good;
      zone.kind = kind;
      zone.side1.first_element = number, zone.side1.elements = zone.side2.elements = 2;
      refused(c2d_add_zone(s, &zone), C2D_ERR_ARGUMENT, "contact element of body 1" + is);
      zone.side1.first_element = 3, zone.side2.last_element = number;
      refused(c2d_add_zone(s, &zone), C2D_ERR_ARGUMENT, "contact element of body 2" + is);
      zone = good;
      zone.side2.first_node = number;
      if (kind == C2D_ZONE_MATCHING) refused(c2d_add_zone(s, &zone), C2D_ERR_ARGUMENT, "contact node of body 2" + is);
    }
  const auto wrong = [&](int32_t kind, auto change, c2d_status expected, const std::string& what) {
    c2d_zone zone = good;
    zone.kind = kind;
    change(zone);
    refused(c2d_add_zone(s, &zone), expected, what);
  };
  wrong(
      8, [](c2d_zone&) {}, C2D_ERR_ARGUMENT, "kind of a zone");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side1.body = 2; }, C2D_ERR_ARGUMENT,
      "both sides of a contact zone are on one body, expected two different bodies");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side1.body = 3; }, C2D_ERR_ARGUMENT, "c2d_zone.side1.body is 3");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side2.body = 3; }, C2D_ERR_ARGUMENT, "c2d_zone.side2.body is 3");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side2.elements = 3; }, C2D_ERR_ARGUMENT,
      "number of contact elements of side 2 is 3, expected 2");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.pairs = 0; }, C2D_ERR_LIMIT, "number of contact pairs is 0, expected 1");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.pairs = 6; }, C2D_ERR_LIMIT, "c2d_limits.pairs is 5, expected 6 or more");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side1.elements = z.side2.elements = -1; }, C2D_ERR_LIMIT,
      "number of contact elements is -1, expected 1");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side1.elements = z.side2.elements = 5; }, C2D_ERR_LIMIT,
      "c2d_limits.contact_elements is 4, expected 5 or more");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side1.elements = z.side2.elements = 3; }, C2D_ERR_ARGUMENT,
      "the element range of body 1 does not contain");
  wrong(
      C2D_ZONE_MATCHING, [](c2d_zone& z) { z.side2.last_node = 5; }, C2D_ERR_ARGUMENT,
      "the node range of body 2 does not contain");
  wrong(
      C2D_ZONE_FREE, [](c2d_zone& z) { z.side2.elements = 3; }, C2D_ERR_ARGUMENT,
      "the element range of body 2 does not contain");
  wrong(
      C2D_ZONE_FREE, [](c2d_zone& z) { z.side2.last_element = 6; }, C2D_ERR_LIMIT,
      "c2d_limits.free_pairs is 3, expected 4 or more");
  wrong(
      C2D_ZONE_FREE, [](c2d_zone& z) { z.side2.last_element = 4; }, C2D_ERR_LIMIT, "c2d_limits.pairs is 5, expected 6 or more");
  REQUIRE(c2d_add_zone(s, &good) == C2D_OK);
  const int32_t held[4] = {1, 1, 0, 0};
  for (int32_t local = 1; local <= 2; ++local) REQUIRE(c2d_set_condition(s, 1, 8, local, 1, held, none) == C2D_OK);
  refused(c2d_set_values(s, 1, 8, 0, 2, pull), C2D_ERR_ARGUMENT, "tx is unknown here");
  refused(c2d_set_values(s, 1, 1, 0, 2, here), C2D_ERR_ARGUMENT, "ux is unknown here");
  refused(c2d_set_values(s, 1, 3, 1, 2, pull), C2D_ERR_ARGUMENT, "tx is a contact traction here");
  REQUIRE(c2d_set_values(s, 1, 8, 0, 2, here) == C2D_OK);
  refused(c2d_set_values(s, 1, 8, 1, 2, there), C2D_ERR_ARGUMENT, "ux was given another value at this node");
  refused(c2d_set_values(s, 1, 8, 1, 2, nullptr), C2D_ERR_ARGUMENT, "no values given");
  CHECK(c2d_get_state(s) == C2D_STATE_BUILDING);
}

// Half a cylinder on a foundation, by images: every end of both bodies is given every quantity once more.
TEST_CASE("refusals: new values where symmetry, contact or a rigid body has the say") {
  for (const bool rigid : {false, true}) {
    Deck deck = deck_named("sample");
    if (rigid) deck.lines.push_back("*RIGID");
    Hearing host;
    Machine machine(deck.limits(), 4000000, &host.port);
    c2d_options options = C2D_INIT(c2d_options);
    options.symmetry = C2D_SYMMETRY_IMAGES;
    REQUIRE(c2d_set_options(machine.solver, &options) == C2D_OK);
    REQUIRE(read_deck(machine.solver, deck) == C2D_OK);
    const host::Summary sizes = summary_of(machine.solver);
    std::map<std::string, int> said;
    for (int32_t b = 1; b <= 2; ++b)
      for (int32_t element = 1; element <= sizes.body[b - 1].elements; ++element)
        for (int32_t local = 1; local <= sizes.function_nodes; ++local)
          for (int q = 0; q < 4; ++q) {
            double values[4] = {0, 0, 0, 0};
            values[q] = 1;
            host.told.clear();
            const c2d_status status = c2d_set_values(machine.solver, b, element, local, 1, values);
            REQUIRE(status == (host.told.empty() ? C2D_OK : C2D_ERR_ARGUMENT));
            if (host.told.empty()) continue;
            const std::string text = host.told[0].text;
            ++said[text.substr(text.find(' ') + 1)];
          }
    CHECK(said["is a contact traction here, expected 0"] > 0);
    CHECK(said["belongs to a contact node, expected 0"] > 0);
    CHECK(said["is on an element without length or on a line of symmetry, expected 0"] > 0);
    CHECK(said["is fixed by symmetry here, expected 0"] > 0);
    CHECK((said["belongs to the rigid body 1, expected 0"] > 0) == rigid);
  }
}

TEST_CASE("refusals: what comes too late, and walks without a function") {
  Running going("block");
  c2d_options options = C2D_INIT(c2d_options);
  CHECK(c2d_change_loads(going.s) == C2D_OK);
  options.symmetry = C2D_SYMMETRY_IMAGES;
  CHECK(c2d_set_options(going.s, &options) == C2D_ERR_STATE);
  REQUIRE(going.host.told.size() == 1);
  CHECK(says(going.host.told[0], "symmetry by images can be chosen only before c2d_complete"));
  going.host.told.clear();
  const double zero[3] = {0, 0, 0};
  CHECK(c2d_set_rigid(going.s, 1, 1, zero, zero) == C2D_ERR_STATE);
  REQUIRE(going.host.told.size() == 1);
  CHECK(says(going.host.told[0], "made rigid only before c2d_complete"));
  // Without a function to read with, every walk says so to whoever listens.
  std::vector<c2d_error> told;
  const c2d_report hear = [](void* to, const c2d_error* e) { static_cast<std::vector<c2d_error>*>(to)->push_back(*e); };
  host::Limits limits = two_blocks();
  CHECK(c2d_check_deck(nullptr, nullptr, &limits, hear, &told) == C2D_ERR_ARGUMENT);
  CHECK(c2d_walk_deck(nullptr, nullptr, limits.body, 2, nullptr, nullptr, hear, &told) == C2D_ERR_ARGUMENT);
  CHECK(c2d_walk_deck(nullptr, nullptr, limits.body, 2, nullptr, nullptr, nullptr, nullptr) == C2D_ERR_ARGUMENT);
  REQUIRE(told.size() == 2);
  for (const c2d_error& e : told) CHECK(says(e, "read_line is null"));
}
