#include "program/commands/commands.hpp"

#include "program/estimate/mesh/halved.hpp"
#include "program/exit_code.hpp"
#include "program/session.hpp"

namespace app {

int halve_deck(const Options& options) {
  Session session;
  int exit = session.read_file(options.deck, {options.settings, true, options.memory});
  if (exit == 0) exit = session.read_model_alone();
  if (exit != 0) return exit;

  std::string error;
  const std::string halved = estimate::halved_deck(session.solver, session.deck.text(), error);
  if (halved.empty()) return session.messages.fail(error, kExitInput);
  return write_or_fail(options.output, halved, session.messages);
}

} // namespace app
