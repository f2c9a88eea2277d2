#include "program/kept_run.hpp"

#include "program/files/sealed_file.hpp"
#include "program/progress.hpp"

#include <algorithm>
#include <ctime>

namespace app {
namespace {

const char kPathKind[] = "contact2d path 4";
constexpr double kWork = 60; // least ratio of run time to time for saving

std::string local_time() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  char text[32] = "";
  if (::localtime_r(&now, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts);
  return text;
}

} // namespace

// A resumed job must still be there; for a new run, old states are removed.
bool KeptRun::claim(std::string& error) {
  if (options_.job == nullptr) return remove_way(store_.kept_folder(), error);
  kept_ = app::is_kept(store_.kept_folder(), *options_.job);
  if (!kept_) error = options_.folder + ": another process has finished or replaced this run";
  job_ = *options_.job;
  return kept_;
}

bool KeptRun::keep(JobForm form, const RunResults& run, const std::vector<NamedText>& files, std::string& error) {
  if (!kept_ && !claim(error)) return false;
  if (kept_ && job_.form == form) return true;
  const bool had_meshes = kept_;
  if (!kept_) job_.begun = local_time(), job_.words = words_of(options_);
  job_.form = form;
  job_.deck_name = run.session.deck.name();
  job_.deck = run.session.deck.text();
  job_.settings = form == JobForm::kSketch ? options_.settings : std::vector<std::string>();
  job_.files = files;
  job_.has_points = job_.has_points || !options_.points.empty();
  job_.points = run.interior.file_text();
  job_.workspace = form == JobForm::kSketch ? options_.memory : run.session.workspace.bytes;
  job_.inputs = run.record.inputs;
  job_.meshes = run.record.meshes;
  kept_ = keep_job(store_.kept_folder(), job_, error);
  return kept_ && (!had_meshes || remove_way(store_.kept_folder(), error));
}

void KeptRun::drop_sketch() {
  std::string ignored;
  if (kept_ && options_.job == nullptr && job_.form == JobForm::kSketch && remove(ignored)) store_.remove_tapes(ignored);
}

bool KeptRun::remove(std::string& error) const {
  const std::string folder = store_.kept_folder();
  return folder.empty() || (remove_job(folder, error) && remove_way(folder, error));
}

void KeptRun::begin_path(const c2d_summary& now) {
  constexpr double kBytesPerSecond = 1e8; // of tape 0, which has room for two states
  const double first = static_cast<double>(now.tape_blocks[C2D_TAPE_CONTROL]) / 2 * 512 / kBytesPerSecond;
  next_ = clock_seconds(nullptr) + std::max(options_.save_every, kWork * first);
}

// States within the cycles of a load path differ by the cycles followed alone.
std::string KeptRun::heading(int32_t coefficient, int32_t step, int32_t cycles) const {
  return id() + ' ' + std::to_string(coefficient) + ' ' + std::to_string(step) +
         (cycles > 0 ? ' ' + std::to_string(cycles) : "") + '\n';
}

bool KeptRun::write_state(const c2d_step& step, RunResults& run, std::string& error) {
  const double start = clock_seconds(nullptr);
  run.path.warnings = run.session.messages.warnings();
  run.path.latest = run.session.messages.latest();
  std::swap(run.path.coefficients, run.record.coefficients);
  const std::string record = heading(step.coefficient, step.step, cycles_followed(run.session.solver)) + text_of(run.path);
  std::swap(run.path.coefficients, run.record.coefficients);
  if (!write_sealed(path_of(slot_), kPathKind, record, error)) return false;
  if (const c2d_status status = c2d_save(run.session.solver); status != C2D_OK)
    return error = store_.kept_folder() + ": the state of the path cannot be saved: " + c2d_message(status), false;
  slot_ = 1 - slot_;
  const double end = clock_seconds(nullptr);
  next_ = end + std::max(options_.save_every, kWork * (end - start));
  saved_ = "step " + std::to_string(step.step) + ", " + load_reached(run.record.coefficients.back());
  return true;
}

bool KeptRun::save(const c2d_step& step, bool at_once, RunResults& run, Outputs& outputs, std::string& error) {
  const bool is_due = at_once || options_.save_every == 0 || clock_seconds(nullptr) >= next_;
  if (step.kind == C2D_STEP_CHANGE || !saves_states() || !is_due) return true;
  bool all = true; // all outputs can be written again
  for (size_t i = 0; i < kOutputs && all; ++i)
    all = !outputs.files[i].is_open() || outputs.files[i].so_far(run.path.outputs[i], error);
  all = all && write_state(step, run, error);
  for (std::string& text : run.path.outputs) text = std::string();
  return all || error.empty();
}

bool KeptRun::find_record(const c2d_summary& now, int32_t cycles, std::string& record, std::string& why) {
  const std::string wanted = heading(now.run_coefficient, now.run_step, cycles);
  why = "the record of the earlier steps is missing";
  for (int slot = 0; slot < 2; ++slot) {
    std::string error;
    const Sealed found = read_sealed(path_of(slot), kPathKind, record, error);
    if (found == Sealed::kFailed) why = error;
    if (found != Sealed::kWhole || record.compare(0, wanted.size(), wanted) != 0) continue;
    record.erase(0, wanted.size());
    slot_ = 1 - slot;
    return true;
  }
  return false;
}

void KeptRun::report_unusable(c2d_status status, const Messages& messages) const {
  const bool nothing = status == C2D_ERR_STORE_READ || status == C2D_ERR_STORE_FORMAT;
  std::string why = c2d_message(status);
  if (nothing) why = "nothing was saved before the run was interrupted";
  if (status == C2D_ERR_MISMATCH) why = "the saved data belong to another model or to another build of this program";
  messages.note(options_.folder + ": " + why + "; the run restarts from the beginning");
}

c2d_status KeptRun::restore(RunResults& run, Outputs& outputs, std::string& why) {
  c2d_summary now = C2D_INIT(c2d_summary);
  const c2d_status status = c2d_get_summary(run.session.solver, &now);
  if (status != C2D_OK || now.run_step == 0) return status;
  std::string text;
  PathRecord found;
  found.history.begin(run.summary.steps);
  const bool there = find_record(now, cycles_followed(run.session.solver), text, why);
  if (!there || !read_path_record(text, run.summary, found)) {
    if (there) why = "the record of the earlier steps belongs to another model";
    why = options_.folder + ": a state is saved at step " + std::to_string(now.run_step) + ", but " + why;
    return C2D_ERR_MISMATCH;
  }
  why.clear();
  run.path = std::move(found);
  run.record.coefficients = std::move(run.path.coefficients);
  for (size_t i = 0; i < kOutputs; ++i) {
    if (outputs.files[i].is_open()) outputs.files[i].text = std::move(run.path.outputs[i]);
    run.path.outputs[i] = std::string();
  }
  run.session.messages.take(std::move(run.path.warnings), std::move(run.path.latest));
  run.session.messages.note("continues after step " + std::to_string(now.run_step));
  return C2D_OK;
}

} // namespace app
