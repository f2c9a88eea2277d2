// Problems of the families of `contact2d make`, solved in this process, and the reference curves to compare
// with.
#pragma once

#include "paths.hpp"
#include "post/cracks.hpp"
#include "program/commands/families.hpp"
#include "solver_runs.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace families_test {

inline const double kPi = std::acos(-1.0);

struct Row {
  double x, y;
  int status;
  double tn, tt, gap, slip;
  int zone; // from 1
};
struct Step {
  double load, dissipated;
  std::vector<Row> rows; // by rising x
};
struct EndRow {
  double x, y, ux, uy, tx, ty, hoop;
};
struct Solution {
  std::string error; // empty: solved
  std::vector<Step> steps;
  std::vector<EndRow> ends;                // of body 1 at the last step
  std::vector<std::vector<EndRow>> bodies; // the same of all of them
  std::vector<c2d_body_result> resultants; // per body
  std::vector<c2d_zone_state> zones;
  std::vector<app::StressIntensity> cracks; // of all tips at the last step
  int elements = 0;                         // of all bodies
  const std::vector<Row>& last() const { return steps.back().rows; }
  std::vector<Row> zone(int number) const { // pairs of one zone at the last step, by rising x
    std::vector<Row> out;
    for (const Row& row : last())
      if (row.zone == number) out.push_back(row);
    return out;
  }
};

inline int32_t keep_step(void* context, const c2d_step* step) {
  if (step->kind == C2D_STEP_CHANGE) return 0;
  Step out{step->load, step->dissipated, {}};
  for (int32_t i = 0; i < step->pairs; ++i) {
    const double* r = step->table + i * step->stride;
    out.rows.push_back({r[C2D_X], r[C2D_Y], static_cast<int>(r[C2D_STATUS]), r[C2D_TN], r[C2D_TT], r[C2D_GAP], r[C2D_SLIP_SUM],
                        static_cast<int>(r[C2D_PAIR_ZONE])});
  }
  std::sort(out.rows.begin(), out.rows.end(), [](const Row& a, const Row& b) { return a.x < b.x; });
  static_cast<Solution*>(context)->steps.push_back(out);
  return 0;
}

inline void keep_ends(c2d_solver* s, Solution& out) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  c2d_get_summary(s, &summary);
  if (summary.outcome != C2D_REACHED) out.error = c2d_outcome_message(summary.outcome);
  const int32_t fields[7] = {C2D_END_X, C2D_END_Y, C2D_END_UX, C2D_END_UY, C2D_END_TX, C2D_END_TY, C2D_END_HOOP};
  for (int32_t b = 1; b <= summary.bodies; ++b) {
    c2d_body_result body = C2D_INIT(c2d_body_result);
    c2d_get_body_result(s, b, &body);
    out.resultants.push_back(body);
    out.elements += body.elements;
    const int32_t count = body.elements * summary.function_nodes;
    std::vector<double> table(static_cast<size_t>(count) * 7);
    for (int i = 0; i < 7 && count > 0; ++i) // (a body without a mesh has none)
      if (c2d_get(s, fields[i], b, 1, count, table.data() + i, 7) != C2D_OK) out.error = "no results of a body";
    out.bodies.emplace_back();
    for (size_t i = 0; i < table.size(); i += 7)
      out.bodies.back().push_back(
          {table[i], table[i + 1], table[i + 2], table[i + 3], table[i + 4], table[i + 5], table[i + 6]});
  }
  if (!out.bodies.empty()) out.ends = out.bodies.front();
  for (int32_t zone = 1; zone <= summary.zones; ++zone) {
    out.zones.push_back(C2D_INIT(c2d_zone_state));
    if (c2d_get_zone_state(s, zone, &out.zones.back()) != C2D_OK) out.error = "no state of a zone";
  }
}

// What the pairs hold as they stand.
inline void keep_cracks(c2d_solver* s, Solution& out) {
  app::Summary summary;
  std::vector<app::CrackTip> tips;
  if (app::get_summary(s, summary) != C2D_OK || app::find_crack_tips(s, summary, tips) != C2D_OK) out.error = "no crack tips";
  std::vector<double> table(static_cast<size_t>(summary.pairs) * C2D_PAIR_FIELDS);
  for (int32_t f = 0; f < C2D_PAIR_FIELDS && !tips.empty(); ++f)
    if (c2d_get(s, f, 1, 1, summary.pairs, table.data() + f, C2D_PAIR_FIELDS) != C2D_OK) out.error = "no results of pairs";
  for (const app::CrackTip& tip : tips) out.cracks.push_back(app::stress_intensity(tip, table.data(), C2D_PAIR_FIELDS));
}

inline Solution solve_deck(const std::string& text) {
  Solution out;
  runs::Deck deck;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) deck.lines.push_back(line);
  const host::Limits limits = deck.limits();
  uint64_t minimum = 0, in_core = 0;
  if (limits.bodies < 0 || c2d_memory_need(&limits, &minimum, &in_core, nullptr) != C2D_OK) {
    out.error = "the deck cannot be read";
    return out;
  }
  runs::RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  store.serve(port);
  runs::Machine machine(limits, in_core, &port);
  c2d_status status = machine.created;
  if (status == C2D_OK) status = runs::read_deck(machine.solver, deck);
  if (status == C2D_OK) status = c2d_prepare(machine.solver);
  if (status == C2D_OK) status = c2d_run(machine.solver, keep_step, &out);
  if (status == C2D_OK) {
    keep_ends(machine.solver, out);
    keep_cracks(machine.solver, out);
  } else {
    c2d_error why = C2D_INIT(c2d_error);
    c2d_last_error(machine.solver, &why);
    out.error = std::string(c2d_message(status)) + ": " + why.text;
  }
  return out;
}

inline Solution solve(const std::string& name, const std::vector<std::string>& settings = {}) {
  std::string deck, error;
  if (families::make_deck(name, settings, deck, error)) return solve_deck(deck);
  Solution out;
  out.error = error;
  return out;
}

inline std::string setting(const char* key, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s=%.12g", key, value);
  return text;
}

// A reference curve: rows of numbers under a header line.
using Table = std::vector<std::vector<double>>;
inline Table reference(const std::string& name) {
  std::ifstream file(paths::root() + "/tests/data/reference/" + name + ".csv");
  Table out;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    out.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) out.back().push_back(field == "nan" ? NAN : std::stod(field));
  }
  return out;
}

// Column `column` at x by straight lines between the rows; below `cusp` straight in the root of the distance
// from it, as friction is near the edge of a stick zone.
inline double at(const Table& t, double x, size_t column, double cusp = -1) {
  for (size_t i = 0; i + 1 < t.size(); ++i) {
    const double a = t[i][0], b = t[i + 1][0];
    if (x < a || x > b || !(b > a)) continue;
    double f = (x - a) / (b - a);
    if (b <= cusp + 1e-6) {
      const double ra = std::sqrt(std::fabs(cusp - a)), rb = std::sqrt(std::max(0.0, cusp - b));
      f = (std::sqrt(std::max(0.0, cusp - x)) - ra) / (rb - ra);
    }
    return t[i][column] + f * (t[i + 1][column] - t[i][column]);
  }
  return NAN;
}

// Largest x among the rows with this status; -1 if there is none.
inline double last_with(const std::vector<Row>& rows, int status) {
  double x = -1;
  for (const Row& row : rows)
    if (row.status == status) x = row.x;
  return x;
}
inline double first_with(const std::vector<Row>& rows, int status, double from = 0) {
  for (const Row& row : rows)
    if (row.status == status && row.x >= from) return row.x;
  return -1;
}
inline double last_closed(const std::vector<Row>& rows) {
  double x = -1;
  for (const Row& row : rows)
    if (row.status != C2D_OPEN) x = row.x;
  return x;
}
inline double largest_pressure(const std::vector<Row>& rows) {
  double p = 0;
  for (const Row& row : rows) p = std::max(p, row.tn);
  return p;
}

} // namespace families_test
