#include "program/halve.hpp"

#include "program/estimate/halved.hpp"
#include "program/exit_code.hpp"
#include "program/output_file.hpp"
#include "program/session.hpp"

namespace app {

int halve_deck(const Options& options) {
  Session session;
  int exit = session.read_file(options.deck, {options.settings, true, options.memory});
  if (exit != 0) return exit;
  uint64_t minimum = 0, in_core = 0;
  const c2d_status status = c2d_memory_need(&session.limits, &minimum, &in_core, nullptr);
  exit = status == C2D_OK ? session.take_memory(minimum) : session.failed(status);
  if (exit != 0) return exit;
  c2d_port port = C2D_INIT(c2d_port);
  port.context = &session.messages;
  port.log = Messages::log;
  exit = session.read_model(port);
  if (exit != 0) return exit;

  std::string error;
  const std::string halved = estimate::halved_deck(session.solver, session.deck.text(), error);
  if (halved.empty()) {
    session.messages.fail(error);
    return kExitInput;
  }
  OutputFile out;
  bool written = out.open(options.output.empty() ? "-" : options.output, error);
  if (written) out.text = halved;
  written = written && out.finish(error) && out.publish(error);
  if (written) return kExitSolved;
  session.messages.fail(error);
  return kExitFiles;
}

} // namespace app
