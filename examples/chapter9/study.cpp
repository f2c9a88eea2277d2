#include "study.hpp"

#include "c2d_memory.h"
#include "contact2d.h"
#include "program/commands/families.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace chapter9 {
namespace {

const double kPi = std::acos(-1.0);

// ---- a deck followed through the library

struct Lines {
  std::istringstream text;
  static int32_t next(void* context, char* out, int32_t size) {
    std::string line;
    if (!std::getline(static_cast<Lines*>(context)->text, line)) return -1;
    std::memset(out, 0, static_cast<size_t>(size));
    line.copy(out, static_cast<size_t>(size) - 1);
    return static_cast<int32_t>(line.size());
  }
};

struct Watch { // what the library hands back to its callbacks: the store first, whose functions take the same
               // context
  c2d_memory_store store;
  Run* run;
  std::vector<bool> closed;
};

// Warnings of the library; this one comes once in a run.
void hear(void* context, const c2d_error* entry) {
  if (entry->status == C2D_WARN_INCREMENT) static_cast<Watch*>(context)->run->by_events = true;
}

// Called after every change of status and at the end of every increment.
int32_t watch(void* context, const c2d_step* step) {
  Watch& w = *static_cast<Watch*>(context);
  w.closed.resize(static_cast<size_t>(step->pairs), false);
  std::vector<Node> nodes;
  bool one_closed = false;
  for (int32_t i = 0; i < step->pairs; ++i) {
    const double* row = step->table + i * step->stride;
    const bool closed = static_cast<int>(row[C2D_STATUS]) != C2D_OPEN;
    const double p0 = 1000 / (2 * (1 - 0.3 * 0.3)) / 100; // E / (2 (1 - nu^2)) a0 / R of the family
    nodes.push_back({row[C2D_X], row[C2D_TN] / p0, -row[C2D_TT] / p0, closed});
    one_closed = one_closed || (closed && !w.closed[static_cast<size_t>(i)]);
    w.closed[static_cast<size_t>(i)] = closed;
  }
  if (one_closed) w.run->touching.push_back(step->load);
  if (step->kind == C2D_STEP_CHANGE) return 0;
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.x < b.x; });
  w.run->nodes = nodes;
  return 0;
}

} // namespace

Run follow(const std::string& deck, Stepping stepping) {
  Run run;
  Lines lines{std::istringstream(deck)};
  c2d_body_limits bodies[2];
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = 2; // so many have room
  limits.body = bodies;
  c2d_error why = C2D_INIT(c2d_error);
  uint64_t in_core = 0;
  c2d_status status = c2d_scan_deck(Lines::next, &lines, &limits, &why);
  if (status == C2D_OK) status = c2d_memory_need(&limits, nullptr, &in_core, nullptr);
  if (status != C2D_OK) {
    run.error = std::string(c2d_message(status)) + ": " + why.text;
    return run;
  }
  std::vector<unsigned char> workspace(in_core), region(8 * in_core);
  Watch watching{{}, &run, {}};
  c2d_memory_store_init(&watching.store, region.data(), region.size());
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store_port(&watching.store, &port);
  port.log = hear;
  c2d_options options = C2D_INIT(c2d_options);
  options.stepping = stepping == Stepping::kEvents ? C2D_STEPPING_EVENTS : C2D_STEPPING_DECK;
  options.every_change = 1;

  c2d_solver* solver = nullptr;
  status = c2d_create(&solver, workspace.data(), workspace.size(), &limits, &port, &why);
  lines.text.clear();
  lines.text.seekg(0);
  if (status == C2D_OK) status = c2d_read_deck(solver, Lines::next, &lines);
  if (status == C2D_OK) status = c2d_set_options(solver, &options);
  if (status == C2D_OK) status = c2d_prepare(solver);
  if (status == C2D_OK) status = c2d_run(solver, watch, &watching);
  c2d_summary summary = C2D_INIT(c2d_summary);
  if (status != C2D_OK)
    run.error = c2d_message(status);
  else if (c2d_get_summary(solver, &summary) == C2D_OK && summary.outcome != C2D_REACHED)
    run.error = c2d_outcome_message(summary.outcome);
  if (solver != nullptr) c2d_close(solver);
  return run;
}

int pairs_closed(const Run& run) {
  return static_cast<int>(std::count_if(run.nodes.begin(), run.nodes.end(), [](const Node& n) { return n.closed; }));
}

// ---- load cards

LoadCards equal(int count) { return {{count, 1.0}}; }

LoadCards pair_by_pair(const std::vector<std::string>& settings, const std::vector<double>& touching) {
  LoadCards cards;
  double before = 0;
  int closed = 0;
  for (const double load : touching) {
    if (load - before < 1e-6) continue;
    for (double part = 1; part < 2; part *= 1.05) {
      cards.push_back({1, std::min(1.0, before + part * (load + 2e-9 - before))}); // cards tell nine digits
      const Run run = follow(make_deck(settings, cards), Stepping::kIncrements);
      const double reached = cards.back().load;
      if ((!run.by_events && pairs_closed(run) > closed) || reached == 1) {
        before = reached;
        closed = pairs_closed(run);
        break;
      }
      cards.pop_back();
    }
    if (before == 1) return cards;
  }
  cards.push_back({1, 1.0});
  return cards;
}

LoadCards divided(LoadCards cards, int parts) {
  for (Increments& card : cards) card.count *= parts;
  return cards;
}

int count_of(const LoadCards& cards) {
  int count = 0;
  for (const Increments& card : cards) count += card.count;
  return count;
}

std::string make_deck(const std::vector<std::string>& settings, const LoadCards& cards) {
  std::string deck, error;
  if (!families::make_deck("cylinder_friction", settings, deck, error)) return "";
  deck.erase(deck.find("*PATH")); // its last cards
  std::ostringstream path;
  path.precision(17);
  path << "*PATH\n";
  for (const Increments& card : cards) path << card.count << " " << card.load << "\n";
  return deck + path.str();
}

// ---- the continuum

Adhesion::Adhesion(double nu) : epsilon_(std::atanh((1 - 2 * nu) / (2 * (1 - nu))) / kPi), load_(0) {
  // Slopes of the surface under the cylinder: x / R is the sum over all stamps narrower than x, x tanh u wide.
  const int n = 4000;
  const double end = 6.5;
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double v = (i + 0.5) * end / n, u = v * v;
    sum += std::tanh(u) * std::cos(2 * epsilon_ * u) / std::cosh(u) * 2 * v * end / n;
  }
  load_ = 1 / sum;
}

double Adhesion::half_width() const { return 1 / std::sqrt(load_); }

// A stamp of half width l carries a share of the load as l^2; d^2 = l^2 - x^2 takes the root out of its
// field, and d = s t^3 smooths the logarithm.
double Adhesion::sum(double x, bool cosine) const {
  const double at = x / half_width();
  if (at >= 1) return 0;
  const double s = std::sqrt(1 - at * at);
  const int n = 400;
  double out = 0;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) / n, d = s * t * t * t, l = std::sqrt(at * at + d * d);
    const double angle = 2 * epsilon_ * std::log((l + at) / d);
    out += (cosine ? std::cos(angle) : std::sin(angle)) * 3 * t * t * s / n;
  }
  return out * std::cosh(kPi * epsilon_) / half_width();
}

double Adhesion::friction(double x) const { return sum(x, false); }
double Adhesion::pressure(double x) const { return sum(x, true); }

// ---- differences

double largest_friction(const Run& run) {
  double largest = 0;
  for (const Node& node : run.nodes) largest = std::max(largest, std::fabs(node.friction));
  return largest;
}

namespace {

template <class Exact> Difference compare_with(const Run& run, double half_width, Exact exact) {
  Difference out;
  double size = 0;
  int count = 0;
  for (size_t i = 0; i < run.nodes.size(); ++i) {
    const double q = exact(i), apart = std::fabs(run.nodes[i].friction - q);
    size = std::max(size, std::fabs(q));
    if (run.nodes[i].x > kInside * half_width) continue;
    out.largest = std::max(out.largest, apart);
    out.rms += apart * apart;
    ++count;
  }
  return {std::sqrt(out.rms / count) / size, out.largest / size};
}

} // namespace

Difference compare(const Run& run, const Run& exact) {
  return compare_with(run, Adhesion(0.3).half_width(), [&](size_t i) { return exact.nodes[i].friction; });
}

Difference compare(const Run& run, const Adhesion& exact) {
  return compare_with(run, exact.half_width(), [&](size_t i) { return exact.friction(run.nodes[i].x); });
}

} // namespace chapter9
