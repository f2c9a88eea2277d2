#include "program/progress.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace app {

double clock_seconds(void*) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void WorkDone::expect(const std::vector<int64_t>& equations, int32_t steps, int32_t coefficients) {
  constexpr double kEntry = 6000.0; // operations of the elimination in the time in which an entry is assembled
  assembly_.clear(), elimination_.clear();
  for (const int64_t equation : equations) {
    const double n = static_cast<double>(equation);
    assembly_.push_back(kEntry * n * n);
    elimination_.push_back(2.0 / 3.0 * n * n * n);
  }
  steps_ = steps, coefficients_ = std::max(coefficients, 1);
}

void WorkDone::reached(int32_t coefficient, int32_t step, double load) {
  coefficient_ = coefficient, step_ = step, load_ = load;
  if (step < steps_) return;
  ++coefficient_, step_ = 0, load_ = 0.0; // the next one begins at zero load
}

double WorkDone::prepared(const c2d_progress& now) const {
  double all = 0.0, done = 0.0;
  const size_t body = now.body > 0 ? static_cast<size_t>(now.body) - 1 : assembly_.size();
  const double part = now.total > 0 ? static_cast<double>(now.done) / static_cast<double>(now.total) : 0.0;
  for (size_t b = 0; b < assembly_.size(); ++b) {
    all += assembly_[b] + elimination_[b];
    if (b < body) done += assembly_[b] + elimination_[b];
    if (b != body) continue;
    // the columns that are eliminated took their assembly; those assembled are of the same panel, or of all of them
    done += part * assembly_[b];
    if (now.phase == C2D_PHASE_ELIMINATE) done += part * elimination_[b];
  }
  return all > 0.0 ? done / all : 0.0;
}

double WorkDone::followed(const c2d_progress& now) const {
  if (steps_ == 0) return 0.0;
  const double way = now.target - load_, gone = now.load - load_;
  const double part = std::fabs(way) > 0.0 && gone / way > 0.0 ? std::min(gone / way, 1.0) : 0.0;
  return (static_cast<double>(coefficient_ - 1) + (step_ + part) / steps_) / coefficients_;
}

double WorkDone::share(const c2d_progress& now) {
  if (follows_ != follows_load(now)) follows_ = !follows_, most_ = 0.0;
  const bool prepares = now.phase == C2D_PHASE_ASSEMBLE || now.phase == C2D_PHASE_ELIMINATE;
  if (prepares) most_ = std::max(most_, prepared(now));
  if (now.phase == C2D_PHASE_REDUCE) most_ = 1.0;
  if (now.phase == C2D_PHASE_CONTACT) most_ = std::max(most_, followed(now));
  return most_ = std::min(most_, 1.0);
}

std::string duration_text(double seconds) {
  const bool hours = seconds >= 5400.0, minutes = seconds >= 90.0;
  const double number = std::ceil(seconds / (hours ? 3600.0 : minutes ? 60.0 : 1.0));
  return std::to_string(static_cast<int64_t>(std::max(number, 1.0))) + (hours ? " h" : minutes ? " min" : " s");
}

ProgressLine::ProgressLine(Progress wanted)
    : active_(wanted == Progress::kAlways || (wanted == Progress::kAutomatic && ::isatty(2) == 1)) {}

std::string ProgressLine::text(const c2d_progress& now, double time) {
  static const char* const kPhases[C2D_PHASES] = {
      "reading", "assembling", "eliminating", "reducing", "following the load", "substituting back", "writing"};
  std::string out = now.phase >= 0 && now.phase < C2D_PHASES ? kPhases[now.phase] : "working";
  if (begun_ < 0.0 || follows_ != WorkDone::follows_load(now)) begun_ = time, follows_ = WorkDone::follows_load(now);
  const double share = work.share(now);
  if (now.phase == C2D_PHASE_ASSEMBLE || now.phase == C2D_PHASE_ELIMINATE) out += " body " + std::to_string(now.body);
  if (now.phase == C2D_PHASE_CONTACT) {
    if (work.coefficients() > 1)
      out += ", coefficient " + std::to_string(work.coefficient()) + " of " + std::to_string(work.coefficients());
    out += ", increment " + std::to_string(work.step() + 1) + " of " + std::to_string(work.steps());
  }
  if (now.phase < C2D_PHASE_ASSEMBLE || now.phase > C2D_PHASE_CONTACT) return out;
  out += ": " + std::to_string(static_cast<int>(100.0 * share)) + " %";
  const double gone = time - begun_;
  if (gone > 1.0 && share > 0.02) out += ", " + duration_text(gone * (1.0 - share) / share) + " left";
  return out;
}

void ProgressLine::show(const c2d_progress& now) {
  const double time = clock_seconds(nullptr);
  const bool turns = begun_ < 0.0 || follows_ != WorkDone::follows_load(now); // a new phase is shown at once
  const std::string line = text(now, time);
  if (!turns && time - last_ < 0.1) return;
  last_ = time;
  shown_ = true;
  std::fprintf(stderr, "\r\033[Kcontact2d: %s", line.c_str());
}

void ProgressLine::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

} // namespace app
