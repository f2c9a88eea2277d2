#include "refused_calls.hpp"

#include <contact2d.h>
#include <contact2d_cards.h>
#include <contact2d_cycle.h>

#include <map>
#include <mutex>

namespace {
std::mutex mutex;
int64_t count = 0, refused = 0;
c2d_status status_of_refused = C2D_ERR_STATE;
std::map<void*, std::vector<int64_t>> calls; // by where they come from; kept while none is refused
std::map<std::string, std::vector<int64_t>> by_name;
const char* name_refused = "";
} // namespace

namespace test {

void refuse_call(int64_t n, c2d_status status) {
  const std::lock_guard<std::mutex> one(mutex);
  count = 0, refused = n, status_of_refused = status, name_refused = "";
  calls.clear(), by_name.clear();
}
std::vector<int64_t> calls_of(const std::string& name) { return by_name[name]; }

std::vector<int64_t> calls_to_refuse() {
  std::vector<int64_t> out;
  for (const auto& [place, numbers] : calls) {
    out.push_back(numbers.front());
    if (numbers.size() > 1) out.push_back(numbers.back());
  }
  return out;
}
const char* call_refused() { return name_refused; }

#ifdef __linux__

bool can_refuse_calls() { return true; }

} // namespace test

namespace {
bool is_let_through(const char* name, void* place) {
  const std::lock_guard<std::mutex> one(mutex);
  const int64_t number = ++count;
  if (refused == 0) calls[place].push_back(number), by_name[name].push_back(number);
  if (number == refused) name_refused = name;
  return number != refused;
}
} // namespace

// name, its parameters, and what is handed on. (The Makefile reads the names here.)
#define WRAPPED(name, parameters, arguments)                                                                                   \
  extern "C" c2d_status __real_##name parameters;                                                                              \
  extern "C" c2d_status __wrap_##name parameters;                                                                              \
  extern "C" c2d_status __wrap_##name parameters {                                                                             \
    if (is_let_through(#name, __builtin_return_address(0))) return __real_##name arguments;                                    \
    return status_of_refused;                                                                                                  \
  }

using Solver = c2d_solver*;
WRAPPED(c2d_get, (Solver s, int32_t a, int32_t b, int32_t c, int32_t d, double* e, int64_t f), (s, a, b, c, d, e, f))
WRAPPED(c2d_get_zone, (Solver s, int32_t a, c2d_zone* b), (s, a, b))
WRAPPED(c2d_get_region, (Solver s, int32_t a, int32_t b, int32_t* c, int32_t* d), (s, a, b, c, d))
WRAPPED(c2d_get_summary, (Solver s, c2d_summary* a), (s, a))
WRAPPED(c2d_get_friction, (Solver s, int32_t a, int32_t b, double* c), (s, a, b, c))
WRAPPED(c2d_get_condition, (Solver s, int32_t a, int32_t b, int32_t c, int32_t d, int32_t* e, double* f), (s, a, b, c, d, e, f))
WRAPPED(c2d_get_body_result, (Solver s, int32_t a, c2d_body_result* b), (s, a, b))
WRAPPED(c2d_get_interference, (Solver s, int32_t* a), (s, a))
WRAPPED(c2d_get_point_load, (Solver s, int32_t a, int32_t* b, int32_t* c, double* d, double* e), (s, a, b, c, d, e))
WRAPPED(c2d_get_path, (Solver s, int32_t a, int32_t* b, double* c, int32_t d), (s, a, b, c, d))
WRAPPED(c2d_get_rigid, (Solver s, int32_t a, int32_t b, int32_t* c, double* d, double* e), (s, a, b, c, d, e))
WRAPPED(c2d_get_body_force, (Solver s, int32_t a, int32_t b, double* c, double* d, double* e), (s, a, b, c, d, e))
WRAPPED(c2d_get_points, (Solver s, int32_t a, c2d_points* b), (s, a, b))
WRAPPED(c2d_get_curve, (Solver s, int32_t a, c2d_curve* b), (s, a, b))
WRAPPED(c2d_interior, (Solver s, int32_t a, int32_t b, const double* c, int64_t d, double* e, int64_t f), (s, a, b, c, d, e, f))
WRAPPED(c2d_indicators, (Solver s, int32_t a, int32_t b, int32_t c, double* d, int64_t e), (s, a, b, c, d, e))
WRAPPED(c2d_set_options, (Solver s, const c2d_options* a), (s, a))
WRAPPED(c2d_read_deck, (Solver s, c2d_read_line a, void* b), (s, a, b))
WRAPPED(c2d_prepare, (Solver s), (s))
WRAPPED(c2d_begin, (Solver s, const double* a, int32_t b), (s, a, b))
WRAPPED(c2d_advance, (Solver s, const double* a, int32_t b, c2d_outcome* c), (s, a, b, c))
WRAPPED(c2d_cycle, (Solver s, const c2d_cycle_request* a, c2d_cycle_fn b, void* c, c2d_cycle_state* d), (s, a, b, c, d))
WRAPPED(c2d_get_cycle_state, (Solver s, c2d_cycle_state* a), (s, a))
WRAPPED(c2d_get_zone_state, (Solver s, int32_t a, c2d_zone_state* b), (s, a, b))
WRAPPED(c2d_get_body_state, (Solver s, int32_t a, c2d_body_state* b), (s, a, b))
WRAPPED(c2d_tape_need,
        (const c2d_limits* a, const c2d_options* b, uint64_t c, int32_t d, uint64_t* e, uint64_t* f, uint64_t* g),
        (a, b, c, d, e, f, g))
WRAPPED(c2d_run, (Solver s, c2d_step_fn a, void* b), (s, a, b))
WRAPPED(c2d_save, (Solver s), (s))
WRAPPED(c2d_restore, (Solver s), (s))
WRAPPED(c2d_create, (Solver * s, void* a, size_t b, const c2d_limits* c, const c2d_port* d, c2d_error* e), (s, a, b, c, d, e))
WRAPPED(c2d_check_deck, (c2d_read_line a, void* b, c2d_limits* c, c2d_report d, void* e), (a, b, c, d, e))
WRAPPED(c2d_close, (Solver s), (s))
WRAPPED(c2d_walk_deck, (c2d_read_line a, void* b, c2d_body_limits* c, int32_t d, c2d_card_fn e, void* f, c2d_report g, void* h),
        (a, b, c, d, e, f, g, h))
WRAPPED(c2d_scan_deck, (c2d_read_line a, void* b, c2d_limits* c, c2d_error* d), (a, b, c, d))

#else

bool can_refuse_calls() { return false; }

} // namespace test

#endif
