#include "report/trace.hpp"

#include "report/text.hpp"

namespace app {

namespace {

// Reason of a change of status.
const char* reason(int from, int to) {
  if (from == C2D_OPEN) return "gap closed";
  if (to == C2D_OPEN) return "no pressure left";
  if (from == C2D_STICK) return "friction at its bound";
  return to == C2D_STICK ? "slip ended" : "slip turned";
}

void append_row(std::string& out, const c2d_step& step, int64_t event, int32_t pair, const char* from, int to,
                const char* why) {
  append_number(out, step.mu);
  out += ',';
  append_integer(out, step.step);
  out += ',';
  append_integer(out, event);
  for (int32_t k = 0; k < step.cases; ++k) {
    out += ',';
    append_number(out, step.loads[k]);
  }
  out += ',';
  append_integer(out, pair + 1);
  out += std::string(",") + from + "," + status_word(to) + "," + why + "\n";
}

} // namespace

void append_trace_header(std::string& out, int32_t load_cases) {
  out += "mu,step,event,load";
  for (int32_t k = 2; k <= load_cases; ++k) out += ",load" + std::to_string(k);
  out += ",pair,from,to,why\n";
}

void Trace::append(std::string& out, const c2d_step& step) {
  const bool begins = coefficient_ != step.coefficient;
  coefficient_ = step.coefficient;
  if (begins) event_ = 0;
  before_.resize(static_cast<size_t>(step.pairs));
  bool any = false;
  for (int32_t i = 0; i < step.pairs; ++i) {
    const double* row = step.table + i * step.stride;
    State& before = before_[static_cast<size_t>(i)];
    const State now{static_cast<int>(row[C2D_STATUS]), row[C2D_TT] < 0 ? -1 : 1};
    const bool turned = now.status == C2D_SLIP && before.status == C2D_SLIP && now.side != before.side && row[C2D_TT] != 0;
    if (begins) {
      append_row(out, step, 0, i, "none", now.status, "start");
    } else if (step.kind != C2D_STEP_CYCLE && (now.status != before.status || turned)) {
      if (!any) ++event_;
      any = true;
      append_row(out, step, event_, i, status_word(before.status), now.status, reason(before.status, now.status));
    }
    before = now;
  }
}

} // namespace app
