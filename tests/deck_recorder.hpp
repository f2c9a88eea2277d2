#pragma once
// A model that only remembers which calls it received, and decks as lists of lines: for tests of the deck
// reader.
#include "contact2d.h"
#include "deck/deck.hpp"
#include "host_structs.hpp"
#include "paths.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace deck_test {

struct Call {
  std::string name;
  std::vector<double> numbers;
};

struct Fault {
  int line, column, column_end, status, host_code;
  std::string text;
  int body;
};

struct Recorder {
  std::vector<Call> calls;
  std::string title, units;
  int line = 0;
  double origin[host::Limits::kRoom][2] = {};
  int refuse_call = -1;               // number of the call that fails, from 0
  c2d_status refusal = C2D_ERR_LIMIT; // with this status

  c2d_status record(const char* name, std::vector<double> numbers) {
    const bool refused = static_cast<int>(calls.size()) == refuse_call;
    calls.push_back({name, std::move(numbers)});
    return refused ? refusal : C2D_OK;
  }
};

inline Recorder* recorder(c2d_solver* solver) { return reinterpret_cast<Recorder*>(solver); }

inline c2d::DeckSink recording_sink(Recorder& r, int32_t function_nodes = 0) {
  c2d::DeckSink sink = {};
  sink.solver = reinterpret_cast<c2d_solver*>(&r);
  sink.function_nodes = function_nodes;
  sink.origin = r.origin;
  sink.set_line = [](c2d_solver* s, int32_t line, int32_t, int32_t) -> c2d_status {
    recorder(s)->line = line;
    return C2D_OK;
  };
  sink.set_problem = [](c2d_solver* s, const c2d_problem* p) -> c2d_status {
    recorder(s)->title = p->title;
    return recorder(s)->record("problem", {double(p->plane), double(p->analysis), double(p->iteration_limit)});
  };
  sink.set_body = [](c2d_solver* s, int32_t body, const c2d_body* d) -> c2d_status {
    return recorder(s)->record("body", {double(body), double(d->element_nodes), double(d->elements), double(d->regions),
                                        d->youngs_modulus, d->poisson_ratio});
  };
  sink.add_region = [](c2d_solver* s, int32_t body, int32_t first, int32_t last) -> c2d_status {
    return recorder(s)->record("region", {double(body), double(first), double(last)});
  };
  sink.set_nodes = [](c2d_solver* s, int32_t body, int32_t first, int32_t count, const double* xy,
                      int64_t stride) -> c2d_status {
    for (int32_t i = 0; i < count; ++i)
      if (c2d_status e = recorder(s)->record("node", {double(body), double(first + i), xy[i * stride], xy[i * stride + 1]}))
        return e;
    return C2D_OK;
  };
  sink.set_condition = [](c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                          const int32_t codes[4], const double v[4]) -> c2d_status {
    const double code = codes[0] * 1000 + codes[1] * 100 + codes[2] * 10 + codes[3];
    return recorder(s)->record("condition",
                               {double(body), double(element), double(local), code, v[0], v[1], v[2], v[3], double(load_case)});
  };
  sink.add_point_load = [](c2d_solver* s, int32_t body, int32_t load_case, double x, double y, double fx,
                           double fy) -> c2d_status {
    return recorder(s)->record("point load", {double(body), x, y, fx, fy, double(load_case)});
  };
  sink.add_zone = [](c2d_solver* s, const c2d_zone* z) -> c2d_status {
    std::vector<double> numbers = {double(z->pairs),
                                   double(z->side1.elements),
                                   double(z->side1.first_element),
                                   double(z->side1.last_element),
                                   double(z->side2.first_element),
                                   double(z->side2.last_element),
                                   double(z->side1.first_node),
                                   double(z->side1.last_node),
                                   double(z->side2.first_node),
                                   double(z->side2.last_node)};
    if (z->kind == C2D_ZONE_FREE)
      numbers = {double(z->side1.first_element), double(z->side1.last_element), double(z->side2.first_element),
                 double(z->side2.last_element),  double(z->side1.elements),     double(z->side2.elements)};
    const bool one_and_two = z->side1.body == 1 && z->side2.body == 2; // else they are noted, too
    if (!one_and_two) numbers.insert(numbers.end(), {double(z->side1.body), double(z->side2.body)});
    return recorder(s)->record(z->kind == C2D_ZONE_FREE ? "free zone" : "zone", numbers);
  };
  sink.add_friction = [](c2d_solver* s, double mu) -> c2d_status { return recorder(s)->record("friction", {mu}); };
  sink.add_load_card = [](c2d_solver* s, int32_t increments, double load) -> c2d_status {
    return recorder(s)->record("path", {double(increments), load});
  };
  sink.set_values = [](c2d_solver* s, int32_t body, int32_t element, int32_t local, int32_t load_case,
                       const double v[4]) -> c2d_status {
    return recorder(s)->record("case values",
                               {double(body), double(element), double(local), v[0], v[1], v[2], v[3], double(load_case)});
  };
  sink.clear_paths = [](c2d_solver* s) -> c2d_status { return recorder(s)->record("clear paths", {}); };
  sink.add_factors = [](c2d_solver* s, int32_t increments, int32_t given, const double* factors, int32_t count,
                        bool) -> c2d_status {
    std::vector<double> numbers = {double(given == 0 ? increments : given)};
    numbers.insert(numbers.end(), factors, factors + count);
    return recorder(s)->record(given == 0 ? "path" : "more factors", numbers);
  };
  sink.set_zone_friction = [](c2d_solver* s, int32_t zone, int32_t i, double mu) -> c2d_status {
    return recorder(s)->record("zone friction", {double(zone), double(i), mu});
  };
  sink.repeat_paths = [](c2d_solver* s, int32_t pieces, int32_t limit, int32_t digits, int32_t start) -> c2d_status {
    return recorder(s)->record("repeat paths", {double(pieces), double(limit), double(digits), double(start)});
  };
  sink.has_free_zones = true;
  sink.add_points = [](c2d_solver* s, const c2d_points* p) -> c2d_status {
    return recorder(s)->record("points", {double(p->kind), double(p->body), double(p->count[0]), double(p->count[1]),
                                          p->from[0], p->from[1], p->to[0], p->to[1]});
  };
  sink.add_curve = [](c2d_solver* s, const c2d_curve* c) -> c2d_status {
    return recorder(s)->record("curve", {double(c->kind), double(c->body), double(c->first_element), double(c->last_element),
                                         c->centre[0], c->centre[1], c->radius});
  };
  sink.set_symmetry = [](c2d_solver* s, int32_t axis, double value) -> c2d_status {
    return recorder(s)->record("symmetry", {double(axis), value});
  };
  sink.set_rigid = [](c2d_solver* s, int32_t body, int32_t load_case, const double* u, const double* at) -> c2d_status {
    if (load_case == 0) return recorder(s)->record("rigid", {double(body)});
    return recorder(s)->record("rigid", {double(body), double(load_case), u[0], u[1], u[2], at[0], at[1]});
  };
  sink.set_rigid_load = [](c2d_solver* s, int32_t body, int32_t load_case, const int32_t* is_free, const double* load,
                           const double* at) -> c2d_status {
    if (load_case > 0) return recorder(s)->record("rigid load", {double(body), double(load_case), load[0], load[1], load[2]});
    return recorder(s)->record("rigid load",
                               {double(body), double(is_free[0]), double(is_free[1]), double(is_free[2]), at[0], at[1]});
  };
  sink.add_platen = [](c2d_solver* s, int32_t body, int32_t first, int32_t last, int32_t elements, const int32_t* is_free,
                       const double* at) -> c2d_status {
    return recorder(s)->record("platen", {double(body), double(first), double(last), double(elements), double(is_free[0]),
                                          double(is_free[1]), double(is_free[2]), at[0], at[1]});
  };
  sink.tie_zone = [](c2d_solver* s, int32_t zone) -> c2d_status { return recorder(s)->record("tie", {double(zone)}); };
  sink.set_interference = [](c2d_solver* s, int32_t load_case) -> c2d_status {
    return recorder(s)->record("interference", {double(load_case)});
  };
  sink.set_body_force = [](c2d_solver* s, int32_t body, int32_t load_case, const double* force, double w,
                           const double* at) -> c2d_status {
    return recorder(s)->record("body force", {double(body), double(load_case), force[0], force[1], w, at[0], at[1]});
  };
  sink.set_name = [](c2d_solver* s, int32_t kind, int32_t i, const char*) -> c2d_status {
    return recorder(s)->record("name", {double(kind), double(i)});
  };
  sink.set_units = [](c2d_solver* s, const char* length, const char* force) -> c2d_status {
    recorder(s)->units = std::string(length) + " " + force;
    return recorder(s)->record("units", {});
  };
  return sink;
}

// A deck as bytes, handed out line by line as a host would.
struct Bytes {
  std::string bytes;
  size_t at = 0;
  int fail_at_line = 0; // > 0: this line cannot be read
  int lines = 0;
};

inline int32_t read_bytes(void* context, char* text, int32_t size) {
  Bytes& deck = *static_cast<Bytes*>(context);
  if (++deck.lines == deck.fail_at_line) return -77;
  if (deck.at >= deck.bytes.size()) return -1;
  size_t end = deck.bytes.find('\n', deck.at);
  if (end == std::string::npos) end = deck.bytes.size();
  const size_t length = end - deck.at;
  const size_t fits = std::min(length, static_cast<size_t>(size - 1));
  deck.bytes.copy(text, fits, deck.at);
  text[fits] = '\0';
  deck.at = end + 1;
  return static_cast<int32_t>(length);
}

inline std::string load(const std::string& name) {
  std::ifstream in(paths::data() + "/decks/" + name, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

inline std::vector<std::string> lines_of(const std::string& bytes) {
  std::vector<std::string> lines;
  std::istringstream in(bytes);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

inline std::string joined(const std::vector<std::string>& lines, const char* end = "\n") {
  std::string bytes;
  for (const std::string& line : lines) bytes += line + end;
  return bytes;
}

struct Reading {
  c2d_status status = C2D_OK;
  Recorder model;
  std::vector<Fault> faults;
  host::Limits sizes;
};

inline void keep_fault(void* context, const c2d_error* e) {
  static_cast<std::vector<Fault>*>(context)->push_back(
      {e->line, e->column, e->column_end, e->status, e->host_code, e->text, e->body});
}

inline Reading read(const std::string& bytes, int refuse_call = -1, c2d_status refusal = C2D_ERR_LIMIT,
                    int32_t function_nodes = 0, int fail_at_line = 0) {
  Reading r;
  Bytes deck;
  deck.bytes = bytes;
  deck.fail_at_line = fail_at_line;
  r.model.refuse_call = refuse_call;
  r.model.refusal = refusal;
  r.sizes.bodies = host::Limits::kRoom;
  const c2d::DeckSink sink = recording_sink(r.model, function_nodes);
  r.status = c2d::read_deck_cards(&sink, read_bytes, &deck, keep_fault, &r.faults, &r.sizes);
  return r;
}

// A minimal deck of two bodies: a square of 4 elements on another one; numbers restart in body 2.
inline std::vector<std::string> squares() {
  return {"    1",
          "TWO SQUARES",
          "    0    1",
          "    2    1    2",
          "    1    2    4    4",
          "    1    2    4    4",
          "    1    4",
          "    1    4",
          "     100.0       0.3",
          "     200.0       0.2",
          "    1       0.5",
          "       0.0       0.0",
          "    1        0.        0.",
          "    2        1.        0.",
          "    3        1.        1.",
          "    4        0.        1.",
          "       0.0       1.0",
          "    1        0.        0.",
          "    2        1.        0.",
          "    3        1.        1.",
          "    4        0.        1.",
          "    2",
          "    1    1 1100                            0.0       0.0",
          "1   1    2 1100                            0.0       0.0",
          "    0",
          "    1",
          "    3    1 0011       0.0      -1.0",
          "    1",
          "    1       0.5       0.5       0.0      -2.0",
          "    1    2    2    1",
          "    3    3    1    1",
          "    3    4    2    1",
          "    2    1",
          "    2    1",
          "    1   10",
          "    4       1.0"};
}

} // namespace deck_test
