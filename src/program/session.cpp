#include "program/session.hpp"

#include "program/exit_code.hpp"
#include "program/interrupt.hpp"

namespace app {

Session::~Session() {
  if (!is_one_of_many_) set_interrupt_target(nullptr);
  if (solver != nullptr) c2d_close(solver);
}

c2d_error Session::last_error() const {
  c2d_error error = C2D_INIT(c2d_error);
  if (solver != nullptr) c2d_last_error(solver, &error);
  return error;
}

int Session::failed(c2d_status status) {
  if (status == C2D_ERR_CANCELLED) return kExitCancelled;
  c2d_error error = last_error();
  if (error.status != status) { // no error stored
    error = C2D_INIT(c2d_error);
    error.status = status;
  }
  return messages.fault(error, exit_code(status));
}

int Session::read_file(const std::string& name, const Drawing& drawing) {
  c2d_error why = C2D_INIT(c2d_error);
  if (!deck.read(name, why)) {
    if (interrupted()) return kExitCancelled;
    return messages.fault(why, kExitInput);
  }
  return take_cards(&drawing);
}

int Session::read_text(const std::string& name, const std::string& text, const Drawing& drawing) {
  is_one_of_many_ = true;
  deck.call(name);
  deck.replace(text);
  return take_cards(&drawing);
}

int Session::take_job(const Job& job, const Drawing& drawing) {
  deck.call(job.deck_name);
  if (job.form == JobForm::kMade)
    deck.replace_by_deck(job.deck);
  else
    deck.replace(job.deck);
  meshes = job.meshes;
  return take_cards(job.form == JobForm::kSketch ? &drawing : nullptr);
}

int Session::take_cards(const Drawing* drawing) {
  const int exit = drawing != nullptr ? take_sketch(deck, *drawing, meshes) : 0;
  if (exit != 0) return exit;
  messages.print_warnings = false; // reading the model repeats them
  bodies = room_for_bodies(deck);
  limits.bodies = static_cast<int32_t>(bodies.size());
  limits.body = bodies.data();
  deck.rewind();
  c2d_status status = c2d_check_deck(DeckFile::read_line, &deck, &limits, Messages::log_cards, &messages);
  messages.print_warnings = true;
  messages.restart();
  if (status == C2D_OK) return 0;
  if (status == C2D_ERR_LIMIT) return exit_code(status); // already reported
  c2d_error why = C2D_INIT(c2d_error);
  deck.rewind();
  c2d_limits ignored = limits;
  c2d_scan_deck(DeckFile::read_line, &deck, &ignored, &why);
  if (why.status == C2D_OK) why.status = status;
  return messages.fault(why, exit_code(status));
}

int Session::take_memory(uint64_t wanted, int32_t elimination) {
  std::string error;
  const c2d_status status = take_workspace(limits, wanted, elimination, workspace, error);
  if (status != C2D_OK) messages.fail(error);
  return exit_code(status);
}

int Session::read_model(const c2d_port& port, int32_t symmetry) {
  c2d_error why = C2D_INIT(c2d_error);
  c2d_status status = c2d_create(&solver, workspace.memory.get(), static_cast<size_t>(workspace.bytes), &limits, &port, &why);
  if (status == C2D_ERR_MEMORY)
    return messages.fail("workspace of " + std::to_string(workspace.bytes) +
                             " bytes is too small: " + std::to_string(why.bytes_needed) + " bytes would do",
                         kExitMemory);
  if (status != C2D_OK) return messages.fault(why, exit_code(status));
  if (!is_one_of_many_) set_interrupt_target(solver);
  if (deck.is_made() && limits.platens > 0) messages.first_platen_zone = limits.zones - limits.platens + 1;
  deck.rewind();
  c2d_options options = C2D_INIT(c2d_options);
  options.symmetry = symmetry;
  status = c2d_set_options(solver, &options);
  if (status == C2D_OK) status = c2d_read_deck(solver, DeckFile::read_line, &deck);
  return status == C2D_OK ? 0 : failed(status);
}

int Session::read_model_alone(int32_t symmetry) {
  uint64_t minimum = 0, in_core = 0;
  const c2d_status status = c2d_memory_need(&limits, &minimum, &in_core, nullptr);
  const int exit = status == C2D_OK ? take_memory(minimum) : failed(status);
  if (exit != 0) return exit;
  c2d_port port = C2D_INIT(c2d_port);
  port.context = &messages;
  port.log = Messages::log;
  return read_model(port, symmetry);
}

} // namespace app
