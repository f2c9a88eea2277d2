#include "program/progress.hpp"

#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace app {

double clock_seconds(void*) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

ProgressLine::ProgressLine(Progress wanted)
    : active_(wanted == Progress::kAlways || (wanted == Progress::kAutomatic && ::isatty(2) == 1)) {}

void ProgressLine::show(const c2d_progress& now) {
  static const char* const kPhases[C2D_PHASES] = {
      "reading", "assembling", "eliminating", "reducing", "following the load", "substituting back", "writing"};
  const double time = clock_seconds(nullptr);
  if (!active_ || (last_ >= 0.0 && time - last_ < 0.1)) return;
  last_ = time;
  shown_ = true;
  const char* phase = now.phase >= 0 && now.phase < C2D_PHASES ? kPhases[now.phase] : "working";
  char text[160];
  int length = std::snprintf(text, sizeof text, "\r\033[Kcontact2d: %s", phase);
  const size_t at = static_cast<size_t>(length);
  if (now.phase == C2D_PHASE_CONTACT)
    length += std::snprintf(text + at, sizeof text - at, " %.4g of %.4g", now.load, now.target);
  else if (now.total > 0)
    length += std::snprintf(text + at, sizeof text - at, " body %d: %.0f %%", static_cast<int>(now.body),
                            100.0 * static_cast<double>(now.done) / static_cast<double>(now.total));
  if (length > 0) std::fwrite(text, 1, static_cast<size_t>(length), stderr);
}

void ProgressLine::clear() {
  if (shown_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

} // namespace app
