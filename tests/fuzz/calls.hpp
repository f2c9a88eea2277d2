#pragma once
// Calls in any order with any arguments, in any state, with a store, callbacks and cancels that fail at any moment. Each is
// held against the header: the status is one that it lists, what fails writes nothing and changes nothing but what it says, the
// state goes where section 9 says. tests/test_contract.cpp compares the lists below with the header's own words.
#include "../../src/solver/solver.hpp"
#include "../callable.hpp"
#include "small_model.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace calls {

using namespace small_model;

enum Errors : uint32_t {
  kNone = 0,
  kOverflow = 1,
  kMemory = 2,
  kLimit = 4,
  kInput = 8,
  kRead = 16,
  kCancelled = 32,
  kSingular = 64,
  kCallback = 128,
  kStore = 256,
  kMismatch = 512
};

inline uint32_t error_bit(c2d_status status) {
  switch (status) {
  case C2D_ERR_OVERFLOW: return kOverflow;
  case C2D_ERR_MEMORY: return kMemory;
  case C2D_ERR_LIMIT: return kLimit;
  case C2D_ERR_INPUT: return kInput;
  case C2D_ERR_READ: return kRead;
  case C2D_ERR_CANCELLED: return kCancelled;
  case C2D_ERR_SINGULAR: return kSingular;
  case C2D_ERR_CALLBACK: return kCallback;
  case C2D_ERR_MISMATCH: return kMismatch;
  default: return status >= C2D_ERR_STORE_OPEN && status < C2D_ERR_MISMATCH ? kStore : 1u << 31;
  }
}

constexpr uint32_t bit(int32_t state) { return 1u << state; }
constexpr uint32_t kEmpty = bit(C2D_STATE_EMPTY), kBuilding = bit(C2D_STATE_BUILDING), kModel = bit(C2D_STATE_MODEL),
                   kPrepared = bit(C2D_STATE_PREPARED), kRunning = bit(C2D_STATE_RUNNING), kBroken = bit(C2D_STATE_BROKEN),
                   kFirst = kEmpty | kBuilding, kComplete = kModel | kPrepared | kRunning, kStarted = kPrepared | kRunning,
                   kAlways = kFirst | kComplete | kBroken;
constexpr int32_t kStays = -1; // of the state, where a call goes through

class Driver;
struct Function {
  const char* name;
  uint32_t errors; // that the header lists, beside ARGUMENT, STATE and BUSY
  uint32_t legal;  // states
  int32_t leads_to;
  bool keeps_outputs; // also when it fails by its store or is cancelled
  c2d_status (Driver::*make)();
};

class Driver {
public:
  static const std::vector<Function>& functions();
  struct Seen {
    const char* function;
    c2d_status status;
    int32_t before;
  };
  test::Callable<void(const Seen&)> seen; // every call that was made
  std::string violation;                  // empty: the header holds

  Driver(const uint8_t* data, size_t size) : in_{data, size}, variant_(in_.byte() % kVariants), limits_(variant_) {
    store_.driver = this;
    port_ = C2D_INIT(c2d_port);
    port_.context = &store_;
    port_.open = [](void* c, int32_t t, uint64_t n, uint64_t b) { return fails(c, 'o') ? 91 : Store::open(c, t, n, b); };
    port_.read = [](void* c, int32_t t, uint64_t n, void* d, uint64_t b) {
      return fails(c, 'r') ? 92 : Store::read(c, t, n, d, b);
    };
    port_.write = [](void* c, int32_t t, uint64_t n, const void* d, uint64_t b) {
      return fails(c, 'w') ? 93 : Store::write(c, t, n, d, b);
    };
    port_.sync = [](void* c, int32_t) { return fails(c, 's') ? 94 : 0; };
    port_.close = [](void* c, int32_t) { return fails(c, 'c') ? 95 : 0; };
    port_.progress = [](void* c, const c2d_progress*) {
      if (fails(c, 'p')) c2d_cancel(self(c).s_);
    };
    port_.cancel = [](void* c) { return fails(c, 'q') ? 1 : 0; };
    port_.log = [](void* c, const c2d_error* e) {
      self(c).told_ += e->severity == C2D_FAULT ? 1 : 0;
      self(c).inside();
    };
    memory_.assign(static_cast<size_t>(memory_for(limits_.limits)), 0xA5);
    if (c2d_create(&s_, memory_.data(), memory_.size(), &limits_.limits, &port_, nullptr) != C2D_OK) fault("c2d_create");
  }
  ~Driver() {
    if (c2d_get_state(s_) >= 0) c2d_close(s_);
  }
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  // Calls until the bytes are used up, or the header is broken.
  void run() {
    for (int i = 0; i < 60 && !in_.is_empty() && violation.empty(); ++i) {
      const uint8_t what = in_.byte();
      if (what >= 224)
        bring_on(what % 8);
      else
        one(functions()[what % functions().size()]);
    }
  }
  // One call with faults armed: the n-th time that the port is asked for something of this kind it fails.
  void arm(char kind, int n) { armed_ = kind, countdown_ = n; }
  bool went_off() const { return countdown_ < 0; }
  void one(const Function& f);
  // To a state, by calls that go through; as far as the state admits.
  void bring_on(int to);
  c2d_solver* solver() { return s_; }

private:
  struct FaultyStore : Store {
    Driver* driver = nullptr;
  };
  static Driver& self(void* context) { return *static_cast<FaultyStore*>(static_cast<Store*>(context))->driver; }
  static bool fails(void* context, char kind) {
    Driver& d = self(context);
    d.inside();
    return d.armed_ == kind && d.countdown_-- == 0;
  }
  // Nothing but what section 3 lists is legal here.
  void inside(bool in_step = false) { // (where a state may be saved)
    if (++insides_ % 16 != 1) return;
    const double load[] = {1, 1};
    c2d_outcome outcome = 77;
    if (c2d_advance(s_, load, 2, &outcome) != C2D_ERR_BUSY || c2d_prepare(s_) != C2D_ERR_BUSY ||
        (!in_step && c2d_save(s_) != C2D_ERR_BUSY) || c2d_close(s_) != C2D_ERR_BUSY || outcome != 77)
      fault("a call inside a callback was not refused");
    if (c2d_get_state(s_) < 0) fault("c2d_get_state inside a callback");
  }
  void fault(const char* what) {
    if (violation.empty()) violation = what;
  }

  // ---- arguments: most of them right, some at the end of their range or none at all
  int32_t number(int32_t most) {
    const uint8_t pick = in_.byte();
    static const int32_t odd[] = {0, -1, INT32_MAX, INT32_MIN, 1 << 30, 7, 100, -7};
    return pick < 208 ? 1 + pick % (most > 0 ? most : 1) : odd[pick % 8];
  }
  int32_t from_zero(int32_t most) {
    const int32_t value = number(most);
    return value == INT32_MIN ? value : value - 1;
  }
  int32_t flag() { return in_.byte() % 4 == 0 ? number(3) : in_.byte() % 2; }
  double real() {
    const uint8_t pick = in_.byte();
    const double inf = std::numeric_limits<double>::infinity();
    const double odd[] = {inf, -inf, std::nan(""), 1e308, -1e308, 1e-308, 1e30, -0.0};
    return pick < 224 ? (pick - 64) / 64.0 : odd[pick % 8];
  }
  int64_t stride(int64_t least) {
    static const int64_t odd[] = {0, -1, INT64_MAX, INT64_MIN, 1};
    const uint8_t pick = in_.byte();
    return pick < 224 ? least + pick % 3 : odd[pick % 5];
  }
  template <class T> T* maybe(T* pointer) { return in_.byte() < 240 ? pointer : nullptr; }
  const double* reals() {
    for (double& value : values_) value = real();
    return maybe(values_);
  }
  const int32_t* flags() {
    for (int32_t& value : flags_) value = flag();
    return maybe(flags_);
  }
  template <class T> const T* given(T& value) {
    if (in_.byte() >= 248) value.struct_size = static_cast<uint32_t>(number(4));
    return maybe(&value);
  }
  template <class T> T* asked() { // a struct of the outputs
    static_assert(sizeof(T) <= sizeof out_, "room for every struct");
    T* out = reinterpret_cast<T*>(out_);
    if (in_.byte() < 248) out->struct_size = static_cast<uint32_t>(sizeof(T));
    std::memcpy(before_, out_, sizeof out_);
    return maybe(out);
  }
  double* doubles() { return maybe(reinterpret_cast<double*>(out_)); }
  int32_t* integers(size_t at) { return maybe(reinterpret_cast<int32_t*>(out_ + 2048 + 64 * at)); }

  // ---- the functions, with arguments from the stranger
  c2d_status set_problem() {
    c2d_problem p = C2D_INIT(c2d_problem);
    p.plane = flag(), p.analysis = number(3), p.iteration_limit = number(50);
    return c2d_set_problem(s_, given(p));
  }
  c2d_status set_body() {
    c2d_body b = C2D_INIT(c2d_body);
    b.element_nodes = number(4), b.elements = number(6), b.regions = number(1), b.open_regions = in_.byte() % 16 == 0;
    b.youngs_modulus = 1000 * real(), b.poisson_ratio = real();
    return c2d_set_body(s_, number(2), given(b));
  }
  c2d_status add_region() { return c2d_add_region(s_, number(2), number(6), number(6)); }
  c2d_status set_nodes() {
    const int32_t body = number(2), first = number(6), count = number(6);
    const double* xy = reals();
    return c2d_set_nodes(s_, body, first, count > 16 ? -1 : count, xy, stride(2));
  }
  c2d_status set_line_nodes() {
    const double* xy = reals();
    return c2d_set_line_nodes(s_, number(2), number(6), number(6), maybe(xy), xy ? xy + 2 : xy, xy ? xy + 4 : xy);
  }
  c2d_status set_arc_nodes() {
    return c2d_set_arc_nodes(s_, number(2), number(6), number(6), reals(), real(), 90 * real(), 90 * real());
  }
  c2d_status set_condition() {
    const int32_t* codes = flags();
    return c2d_set_condition(s_, number(2), number(6), number(2), number(2), codes, reals());
  }
  c2d_status set_values() { return c2d_set_values(s_, number(2), number(6), from_zero(3), number(2), reals()); }
  c2d_status add_point_load() { return c2d_add_point_load(s_, number(2), number(2), real(), real(), real(), real()); }
  c2d_status replace_point_load() { return c2d_replace_point_load(s_, number(1), real(), real(), real(), real()); }
  c2d_status set_body_force() {
    const double* force = reals();
    return c2d_set_body_force(s_, number(2), number(2), force, real(), maybe(values_ + 2));
  }
  c2d_status set_rigid() {
    const double* motion = reals();
    return c2d_set_rigid(s_, number(2), from_zero(3), motion, maybe(values_ + 3));
  }
  c2d_status set_rigid_load() {
    const int32_t* is_free = flags();
    const double* load = reals();
    return c2d_set_rigid_load(s_, number(2), from_zero(3), is_free, load, maybe(values_ + 3));
  }
  c2d_status add_platen() {
    const int32_t* is_free = flags();
    return c2d_add_platen(s_, number(2), number(6), number(6), from_zero(2), is_free, reals());
  }
  c2d_status set_interference() { return c2d_set_interference(s_, number(2)); }
  c2d_status add_zone() {
    c2d_zone z = C2D_INIT(c2d_zone);
    z.kind = flag(), z.pairs = number(3);
    z.side1 = {number(2), number(6), number(6), flag(), number(6), number(6)};
    z.side2 = {number(2), number(6), number(6), flag(), number(6), number(6)};
    return c2d_add_zone(s_, given(z));
  }
  c2d_status tie_zone() { return c2d_tie_zone(s_, number(1)); }
  c2d_status add_curve() {
    c2d_curve c = C2D_INIT(c2d_curve);
    c.kind = from_zero(3), c.body = number(2), c.first_element = number(6), c.last_element = number(6);
    c.centre[0] = real(), c.centre[1] = real(), c.radius = real();
    return c2d_add_curve(s_, given(c));
  }
  c2d_status add_friction() { return c2d_add_friction(s_, real()); }
  c2d_status set_zone_friction() { return c2d_set_zone_friction(s_, number(1), number(2), real()); }
  c2d_status set_symmetry() { return c2d_set_symmetry(s_, flag(), real()); }
  c2d_status add_path() {
    const int32_t increments = number(3);
    const double* load = reals();
    return c2d_add_path(s_, increments > 100 ? 3 : increments, load, in_.byte() % 8 ? 2 : number(3)); // no end of increments
  }
  c2d_status clear_paths() { return c2d_clear_paths(s_); }
  c2d_status add_points() {
    c2d_points p = C2D_INIT(c2d_points);
    fill(p);
    return c2d_add_points(s_, given(p));
  }
  void fill(c2d_points& p) {
    p.kind = from_zero(3), p.body = number(2), p.count[0] = number(4), p.count[1] = number(4);
    for (int i = 0; i < 2; ++i) p.from[i] = real(), p.to[i] = real();
  }
  const char* name() {
    static const char* const names[] = {"roller", "",         "a name that is far too long for any body or zone",
                                        "\n",     "\xC3\xA9", "\xFF"};
    return maybe(names[in_.byte() % 6]);
  }
  c2d_status set_units() {
    const char* length = name();
    return c2d_set_units(s_, length, name());
  }
  c2d_status set_name() { return c2d_set_name(s_, from_zero(2), number(2), name()); }
  c2d_status get_name() { return c2d_get_name(s_, from_zero(2), number(2), maybe(reinterpret_cast<char*>(out_))); }
  c2d_status set_line() { return c2d_set_line(s_, number(9), number(9), number(9)); }
  c2d_status complete() { return c2d_complete(s_); }
  c2d_status set_options() {
    c2d_options o = C2D_INIT(c2d_options);
    o.quadrature = flag(), o.stepping = flag(), o.every_change = flag(), o.symmetry = flag(), o.keep_factors = flag();
    return c2d_set_options(s_, given(o));
  }
  c2d_status prepare() { return c2d_prepare(s_); }
  c2d_status change_loads() { return c2d_change_loads(s_); }
  c2d_status begin() {
    const double* mu = reals();
    return c2d_begin(s_, mu, from_zero(2));
  }
  int32_t cases() { return in_.byte() % 16 == 0 ? number(3) : 2; }
  c2d_status advance() {
    const double* load = reals();
    return c2d_advance(s_, load, cases(), integers(0));
  }
  c2d_status next_event() {
    const double* along = reals();
    return c2d_next_event(s_, along, cases(), doubles());
  }
  c2d_status save() { return c2d_save(s_); }
  c2d_status restore() { return c2d_restore(s_); }
  c2d_status run_path() {
    return c2d_run(s_, maybe(+[](void* c, const c2d_step* step) {
                     Driver& d = *static_cast<Driver*>(c);
                     c2d_zone_state zone = C2D_INIT(c2d_zone_state);
                     c2d_body_state body = C2D_INIT(c2d_body_state);
                     c2d_summary summary = C2D_INIT(c2d_summary);
                     d.inside(true);
                     const c2d_status status = c2d_get_zone_state(d.s_, 1, &zone);
                     const bool broken = error_bit(status) == kStore; // it reads what back substitution needs
                     if (status != C2D_OK && status != C2D_ERR_ARGUMENT && !broken)
                       d.fault("c2d_get_zone_state inside a step callback");
                     if (broken && c2d_get_body_state(d.s_, 1, &body) != C2D_ERR_STATE) d.fault("a broken solver goes on");
                     if (broken) return 0;
                     if (c2d_get_body_state(d.s_, 1, &body) != C2D_OK || c2d_get_summary(d.s_, &summary) != C2D_OK ||
                         step->cases != 2)
                       d.fault("what is legal inside a step callback");
                     return d.armed_ == 't' && d.countdown_-- == 0 ? 55 : 0;
                   }),
                   this);
  }
  c2d_status cancel() { return c2d_cancel(s_); }
  c2d_status get() {
    const int32_t field = from_zero(64), body = number(2), first = number(6), count = number(12);
    return c2d_get(s_, field, body, first, count, doubles(), stride(1));
  }
  c2d_status interior() {
    const int32_t body = from_zero(3), count = number(4);
    const double* xy = reals();
    return c2d_interior(s_, body, count > 8 ? -1 : count, xy, stride(2), doubles(), stride(C2D_POINT_FIELDS));
  }
  c2d_status indicators() { return c2d_indicators(s_, number(2), number(6), number(6), doubles(), stride(C2D_OFF_FIELDS)); }
  c2d_status get_summary() { return c2d_get_summary(s_, asked<c2d_summary>()); }
  c2d_status get_body_result() {
    const int32_t body = number(2);
    return c2d_get_body_result(s_, body, asked<c2d_body_result>());
  }
  c2d_status get_zone_state() {
    const int32_t zone = number(1);
    return c2d_get_zone_state(s_, zone, asked<c2d_zone_state>());
  }
  c2d_status get_body_state() {
    const int32_t body = number(2);
    return c2d_get_body_state(s_, body, asked<c2d_body_state>());
  }
  c2d_status get_friction() { return c2d_get_friction(s_, from_zero(2), number(1), doubles()); }
  c2d_status get_path() { return c2d_get_path(s_, number(2), integers(0), doubles(), cases()); }
  c2d_status get_zone() {
    const int32_t i = number(1);
    return c2d_get_zone(s_, i, asked<c2d_zone>());
  }
  c2d_status get_region() { return c2d_get_region(s_, number(2), number(1), integers(0), integers(1)); }
  c2d_status get_condition() {
    return c2d_get_condition(s_, number(2), number(6), number(2), number(2), integers(0), doubles());
  }
  c2d_status get_point_load() {
    double *xy = doubles(), *force = doubles();
    return c2d_get_point_load(s_, number(1), integers(0), integers(1), xy, force ? force + 4 : nullptr);
  }
  c2d_status get_points() {
    const int32_t i = number(1);
    return c2d_get_points(s_, i, asked<c2d_points>());
  }
  c2d_status get_curve() {
    const int32_t i = number(1);
    return c2d_get_curve(s_, i, asked<c2d_curve>());
  }
  c2d_status expand_points() {
    c2d_points p = C2D_INIT(c2d_points);
    fill(p);
    const int32_t first = number(8), count = number(8);
    return c2d_expand_points(given(p), first, count > 16 ? 0 : count, doubles(), stride(2), integers(0));
  }
  c2d_status get_body_force() {
    double *force = doubles(), *density = doubles(), *axis = doubles();
    return c2d_get_body_force(s_, number(2), number(2), force, density ? density + 4 : nullptr, axis ? axis + 8 : nullptr);
  }
  c2d_status get_rigid() {
    double *motion = doubles(), *axis = doubles();
    return c2d_get_rigid(s_, number(2), number(2), integers(0), motion, axis ? axis + 8 : nullptr);
  }
  c2d_status get_interference() { return c2d_get_interference(s_, integers(0)); }
  c2d_status last_error() { return c2d_last_error(s_, asked<c2d_error>()); }
  c2d_status memory_need() {
    c2d_limits l = some_limits();
    uint64_t* out = reinterpret_cast<uint64_t*>(out_);
    uint64_t *least = maybe(out), *most = maybe(out + 1);
    return c2d_memory_need(given(l), least, most, nullptr);
  }
  c2d_status tape_need() {
    c2d_limits l = some_limits();
    c2d_options o = C2D_INIT(c2d_options);
    o.keep_factors = flag();
    uint64_t* out = reinterpret_cast<uint64_t*>(out_);
    uint64_t *blocks = maybe(out), *bytes = maybe(out + 1);
    const uint64_t memory = in_.byte() % 2 == 0 ? memory_.size() : in_.word();
    return c2d_tape_need(given(l), given(o), memory, from_zero(5), blocks, bytes, nullptr);
  }
  c2d_limits some_limits() {
    c2d_limits l = limits_.limits;
    int32_t* const members[] = {&l.bodies,           &l.function_nodes, &l.zones,        &l.pairs,
                                &l.contact_elements, &l.point_loads,    &l.coefficients, &l.paths,
                                &l.load_cases,       &l.panel_columns,  &l.free_pairs,   &l.platens};
    int32_t& member = *members[in_.byte() % 12];
    const int32_t value = number(3);
    if (&member != &l.bodies || value <= 2) member = value; // the list is as long as it is
    return l;
  }
  struct Cards {
    const char* text;
    Driver* driver;
  };
  c2d_status read_deck() {
    static const char* const decks[] = {"", "*FREE\n", "nonsense\n1 2 3\n", "TITLE\n\n\n    1    2\n"};
    Cards cards{decks[in_.byte() % 4], this};
    return c2d_read_deck(s_, maybe(+[](void* c, char* text, int32_t size) {
                           Cards& from = *static_cast<Cards*>(c);
                           from.driver->inside();
                           if (from.driver->armed_ == 'l' && from.driver->countdown_-- == 0) return int32_t{-9};
                           if (*from.text == '\0') return int32_t{-1};
                           int32_t length = 0;
                           for (; *from.text != '\n' && length + 1 < size; ++from.text) text[length++] = *from.text;
                           ++from.text;
                           text[length] = '\0';
                           return length;
                         }),
                         &cards);
  }

  // What a refused call may write: what c2d_last_error tells, and a cancel that came meanwhile.
  Bytes workspace() const {
    const unsigned char* start = reinterpret_cast<const unsigned char*>(s_);
    Bytes bytes(start, memory_.data() + memory_.size());
    const auto clear = [&](size_t from, size_t count) { std::memset(bytes.data() + from, 0, count); };
    clear(offsetof(c2d_solver, error), sizeof(c2d_error));
    clear(offsetof(c2d_solver, has_fault), sizeof(int16_t));
    clear(offsetof(c2d_solver, cancelled), sizeof(int32_t));
    return bytes;
  }
  void check(const Function& f, c2d_status status, int32_t before);

  Source in_;
  int variant_;
  Limits limits_;
  FaultyStore store_;
  c2d_port port_;
  Bytes memory_;
  c2d_solver* s_ = nullptr;
  char armed_ = 0;
  int countdown_ = 0, insides_ = 0, told_ = 0;
  double values_[32] = {};
  int32_t flags_[4] = {};
  alignas(16) unsigned char out_[4096], before_[4096];
};

inline const std::vector<Function>& Driver::functions() {
  using D = Driver;
  constexpr uint32_t kResults = kStore;
  static const std::vector<Function> all = {
      {"set_problem", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_problem},
      {"set_body", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_body},
      {"add_region", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_region},
      {"set_nodes", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_nodes},
      {"set_line_nodes", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_line_nodes},
      {"set_arc_nodes", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_arc_nodes},
      {"set_condition", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_condition},
      {"set_values", kLimit, kFirst | kModel, kStays, true, &D::set_values},
      {"add_point_load", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_point_load},
      {"replace_point_load", kNone, kModel, kStays, true, &D::replace_point_load},
      {"set_body_force", kLimit, kFirst | kModel, kStays, true, &D::set_body_force},
      {"set_rigid", kLimit, kFirst | kModel, kStays, true, &D::set_rigid},
      {"set_rigid_load", kLimit, kFirst | kModel, kStays, true, &D::set_rigid_load},
      {"add_platen", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_platen},
      {"set_interference", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_interference},
      {"add_zone", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_zone},
      {"tie_zone", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::tie_zone},
      {"add_curve", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_curve},
      {"add_friction", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_friction},
      {"set_zone_friction", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_zone_friction},
      {"set_symmetry", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::set_symmetry},
      {"add_path", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_path},
      {"clear_paths", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::clear_paths},
      {"add_points", kLimit, kFirst, C2D_STATE_BUILDING, true, &D::add_points},
      {"set_units", kLimit, kFirst | kComplete, kStays, true, &D::set_units},
      {"set_name", kLimit, kFirst | kComplete, kStays, true, &D::set_name},
      {"get_name", kLimit, kFirst | kComplete, kStays, true, &D::get_name},
      {"set_line", kLimit, kFirst, kStays, true, &D::set_line},
      {"complete", kLimit | kInput, kBuilding, C2D_STATE_MODEL, true, &D::complete},
      {"set_options", kLimit, kFirst | kModel, kStays, true, &D::set_options},
      {"read_deck", kInput | kRead | kLimit, kEmpty, C2D_STATE_MODEL, true, &D::read_deck},
      {"prepare", kInput | kStore | kSingular | kCancelled | kMemory | kLimit, kModel, C2D_STATE_PREPARED, true, &D::prepare},
      {"change_loads", kNone, kStarted, C2D_STATE_MODEL, true, &D::change_loads},
      {"begin", kStore | kMemory, kStarted, C2D_STATE_RUNNING, true, &D::begin},
      {"advance", kStore | kCancelled | kMemory, kRunning, C2D_STATE_RUNNING, true, &D::advance},
      {"next_event", kStore | kMemory, kRunning, C2D_STATE_RUNNING, true, &D::next_event},
      {"save", kStore, kStarted, kStays, true, &D::save},
      {"restore", kMismatch | kStore | kMemory, kComplete | kBroken, kStays, true, &D::restore},
      {"run", kCallback | kCancelled | kMemory | kStore, kStarted, C2D_STATE_RUNNING, true, &D::run_path},
      {"cancel", kNone, kAlways, kStays, true, &D::cancel},
      {"get", kResults, kComplete, kStays, true, &D::get},
      {"interior", kStore | kCancelled, kRunning, kStays, false, &D::interior},
      {"indicators", kStore | kCancelled, kRunning, kStays, false, &D::indicators},
      {"get_summary", kNone, kAlways, kStays, true, &D::get_summary},
      {"get_body_result", kNone, kAlways, kStays, true, &D::get_body_result},
      {"get_zone_state", kResults, kRunning, kStays, true, &D::get_zone_state},
      {"get_body_state", kResults, kRunning, kStays, true, &D::get_body_state},
      {"get_friction", kNone, kComplete, kStays, true, &D::get_friction},
      {"get_path", kNone, kComplete, kStays, true, &D::get_path},
      {"get_zone", kNone, kComplete, kStays, true, &D::get_zone},
      {"get_region", kNone, kComplete, kStays, true, &D::get_region},
      {"get_condition", kNone, kComplete, kStays, true, &D::get_condition},
      {"get_point_load", kNone, kComplete, kStays, true, &D::get_point_load},
      {"get_points", kNone, kComplete, kStays, true, &D::get_points},
      {"get_curve", kNone, kComplete, kStays, true, &D::get_curve},
      {"expand_points", kNone, kAlways, kStays, true, &D::expand_points},
      {"get_body_force", kNone, kComplete, kStays, true, &D::get_body_force},
      {"get_rigid", kNone, kComplete, kStays, true, &D::get_rigid},
      {"get_interference", kNone, kComplete, kStays, true, &D::get_interference},
      {"last_error", kNone, kAlways, kStays, true, &D::last_error},
      {"memory_need", kOverflow, kAlways, kStays, true, &D::memory_need},
      {"tape_need", kOverflow | kMemory, kAlways, kStays, true, &D::tape_need},
  };
  return all;
}

inline void Driver::one(const Function& f) {
  if (armed_ == 0 && in_.byte() % 4 == 0) {
    static const char kinds[] = "orwscpqtl";
    armed_ = kinds[in_.byte() % 9];
    countdown_ = in_.byte();
  }
  std::memset(out_, 0xC5, sizeof out_);
  std::memcpy(before_, out_, sizeof out_);
  const int32_t before = c2d_get_state(s_);
  const Bytes kept = workspace();
  told_ = 0;
  const c2d_status status = (this->*f.make)();
  if (seen) seen({f.name, status, before});
  check(f, status, before);
  const bool refused = status == C2D_ERR_ARGUMENT || status == C2D_ERR_STATE || status == C2D_ERR_LIMIT;
  const bool empties = status == C2D_ERR_LIMIT && std::strcmp(f.name, "read_deck") == 0;
  if (refused && !empties && workspace() != kept) fault("a call that was refused has changed something");
  armed_ = 0;
  if (!violation.empty())
    violation += std::string(": c2d_") + f.name + " in state " + std::to_string(before) + " returned " +
                 std::to_string(status) + ", state " + std::to_string(c2d_get_state(s_));
}

inline void Driver::check(const Function& f, c2d_status status, int32_t before) {
  const int32_t now = c2d_get_state(s_);
  if (status == C2D_OK) {
    const int32_t expected = f.leads_to != kStays ? f.leads_to : before;
    const std::string name = f.name;
    if ((f.legal & bit(before)) == 0) fault("a call was legal in a state that the header does not list");
    if (name == "restore") {
      if (now != C2D_STATE_PREPARED && now != C2D_STATE_RUNNING) fault("c2d_restore leads elsewhere");
    } else if (before == C2D_STATE_EMPTY && (f.legal & kFirst) == kFirst && now == C2D_STATE_BUILDING) {
      // the first part of a model
    } else if (now != expected) {
      fault("the state is another than the header says");
    }
    return;
  }
  if (status != C2D_ERR_ARGUMENT && status != C2D_ERR_STATE && (error_bit(status) & f.errors) == 0)
    fault("a status that the header does not list");
  if ((f.legal & bit(before)) == 0 && status != C2D_ERR_STATE && status != C2D_ERR_ARGUMENT) fault("illegal, but not refused");
  const bool by_store = error_bit(status) == kStore;
  if ((f.keeps_outputs || (!by_store && status != C2D_ERR_CANCELLED)) && std::memcmp(out_, before_, sizeof out_) != 0)
    fault("a call that failed has written an output");
  const bool empties = f.leads_to == C2D_STATE_MODEL && status != C2D_ERR_STATE && status != C2D_ERR_ARGUMENT &&
                       std::strcmp(f.name, "change_loads") != 0;
  const bool restores = std::strcmp(f.name, "restore") == 0;
  if (empties    ? now != C2D_STATE_EMPTY
      : by_store ? now != C2D_STATE_BROKEN && !(restores && now == before)
      : std::strcmp(f.name, "run") == 0 && (status == C2D_ERR_CANCELLED || status == C2D_ERR_CALLBACK)
          ? now != C2D_STATE_RUNNING
          : now != before)
    fault("a call that failed leads elsewhere than the header says");
  c2d_error error = C2D_INIT(c2d_error);
  const bool asks = std::strcmp(f.name, "last_error") == 0; // the fault that was asked for stays the one kept
  if (told_ > 0 && !asks && c2d_last_error(s_, &error) == C2D_OK && before != C2D_STATE_BROKEN && error.status != status &&
      status != C2D_ERR_INPUT && status != C2D_ERR_LIMIT)
    fault("c2d_last_error tells another fault");
}

inline void Driver::bring_on(int to) {
  const double mu = 0.3, load[] = {1.0, 0.5};
  c2d_outcome outcome;
  c2d_status status = C2D_OK;
  const int32_t state = c2d_get_state(s_);
  if (to >= 1 && state == C2D_STATE_EMPTY) status = build(s_, variant_);
  if (to >= 2 && status == C2D_OK && c2d_get_state(s_) == C2D_STATE_MODEL) status = c2d_prepare(s_);
  if (to >= 3 && status == C2D_OK && c2d_get_state(s_) == C2D_STATE_PREPARED) status = c2d_begin(s_, &mu, 1);
  if (to >= 4 && status == C2D_OK && c2d_get_state(s_) == C2D_STATE_RUNNING) status = c2d_advance(s_, load, 2, &outcome);
  if (to >= 5 && status == C2D_OK && c2d_get_state(s_) == C2D_STATE_RUNNING) status = c2d_save(s_);
  if (to == 7) { // once more from the beginning, in the same memory
    c2d_close(s_);
    store_.tape[C2D_TAPE_CONTROL].clear();
    if (c2d_create(&s_, memory_.data(), memory_.size(), &limits_.limits, &port_, nullptr) != C2D_OK) fault("c2d_create");
  }
}

// Any bytes; a broken promise is told.
inline std::string run(const uint8_t* data, size_t size) {
  Driver driver(data, size);
  driver.run();
  return driver.violation;
}

} // namespace calls
