// One run in phases (Run::go): read the deck into a solver, prepare the equations, follow the load path, write the outputs.
#include "program/run.hpp"

#include "program/estimate/loop.hpp"
#include "program/exit_code.hpp"
#include "program/files/store_choice.hpp"
#include "program/interrupt.hpp"
#include "program/kept_run.hpp"
#include "program/outputs/outputs.hpp"
#include "program/outputs/results.hpp"
#include "program/progress.hpp"
#include "program/second_start.hpp"
#include "program/session.hpp"
#include "program/sweep/answer.hpp"
#include "program/words/voice.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <c2d_threads.h>
#include <cmath>

namespace app {
namespace {

class Run {
public:
  Run(const Options& options, double begun, bool anew = false, StoreChoice* of_many = nullptr)
      : options_(options), store_(of_many != nullptr ? *of_many : own_store_), line_(options.progress),
        results_(session_, begun), kept_(options, store_), anew_(anew), is_one_of_many_(of_many != nullptr) {
    session_.messages.quiet = options.quiet;
  }
  ~Run() {
    if (has_threads_) c2d_threads_stop(&threads_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  int go();
  // Values of the requested responses; empty if the run ended before.
  const std::vector<double>& values() const { return values_; }
  const Inputs& inputs() const { return results_.record.inputs; }
  // Why a resumed run must restart from the beginning; empty: it need not.
  const std::string& wants_fresh_start() const { return fresh_start_; }
  // With room for all pairs.
  bool wants_all_pairs() const { return wants_all_pairs_; }

private:
  // The functions of the port; their context is the Run.
  static Run& self(void* context) { return *static_cast<Run*>(context); }
  static StoreChoice& store_of(void* context) { return self(context).store_; }
  static void on_log(void* context, const c2d_error* entry);
  static int32_t on_step(void* context, const c2d_step* step);
  c2d_port make_port();
  bool begins_anew(int32_t status) const;
  bool must_stop();

  // The phases, and their parts. They return the exit status of the program; 0: continue.
  int read();
  int read_deck();
  int read_points();
  int take_memory_and_threads();
  int read_model();
  int open_outputs();
  int open_store();
  int keep_sketch(const std::vector<NamedText>& files);
  void take_inputs() { results_.record.inputs = inputs_of(options_, session_.deck.inputs, results_.interior.file_text()); }
  int prepare();
  c2d_status set_options();
  c2d_status factorise();
  int follow();
  void compare_starts();
  bool save_path(const c2d_step& step);
  int report();
  int close_store();
  int publish();
  int cancelled();
  int failed(const std::string& text, int exit = kExitInput) const { return session_.messages.fail(text, exit); }
  int file_failed() {
    if (interrupted()) return kExitCancelled; // a waiting call was cancelled
    return failed(error_, store_.is_busy() ? kExitBusy : kExitFiles);
  }
  int library_failed(c2d_status status);

  const Options& options_;
  // In the order in which they need each other: the solver closes its tapes before the store goes.
  c2d_threads threads_;
  bool has_threads_ = false;
  StoreChoice own_store_;
  StoreChoice& store_; // own_store_, or a store with the tapes of the previous run
  ProgressLine line_;
  Session session_;
  Outputs outputs_;
  RunResults results_;
  KeptRun kept_;
  estimate::TrialKeeper trials_;
  const bool anew_; // resumed run that does not use its tapes
  const bool is_one_of_many_;
  bool is_following_ = false;
  bool restored_ = false;
  bool tries_tapes_ = false; // tapes may belong to another model: not a fault
  std::string fresh_start_;
  bool wants_all_pairs_ = false;
  uint64_t budget_ = 0;     // bytes for tapes in memory; 0 while a mesh is sought
  double told_to_end_ = -1; // when, by clock_seconds
  std::string error_;
  std::vector<double> values_;
};

void Run::on_log(void* context, const c2d_error* entry) {
  Run& run = self(context);
  run.line_.clear();
  if (entry->severity == C2D_FAULT && (run.tries_tapes_ || run.begins_anew(entry->status))) return; // reported otherwise
  Messages::log(&run.session_.messages, entry);
}

int32_t Run::on_step(void* context, const c2d_step* step) {
  Run& run = self(context);
  StepResults now{*step, nullptr, false};
  if (const c2d_status status = run.results_.take(*step, now); status != C2D_OK) {
    if (c2d_get_state(run.session_.solver) == C2D_STATE_BROKEN) return 0; // c2d_run returns what broke it
    const c2d_error last = run.session_.last_error();
    run.error_ = last.text[0] != '\0' ? last.text : c2d_message(status);
    return 1;
  }
  if (step->kind == C2D_STEP_RECORDED) run.line_.work.reached(step->coefficient, step->step, step->load);
  run.outputs_.step(run.results_, now);
  return run.outputs_.flush(run.error_) && run.save_path(*step) ? 0 : 1;
}

// Saves the state if the interval is over, or at the last opportunity.
bool Run::save_path(const c2d_step& step) {
  const bool ends = kept_.saves_states() && told_to_end();
  if (!kept_.save(step, ends, results_, outputs_, error_)) return false;
  if (ends && step.kind != C2D_STEP_CHANGE) c2d_cancel(session_.solver);
  return true;
}

// On the load path SIGTERM leaves some time to reach a load whose state can be saved.
bool Run::must_stop() {
  constexpr double kPatience = 5;
  if (!told_to_end() || !is_following_ || !kept_.saves_states()) return interrupted();
  const double now = clock_seconds(nullptr);
  if (told_to_end_ < 0) told_to_end_ = now;
  return now - told_to_end_ > kPatience;
}

c2d_port Run::make_port() {
  c2d_port port = C2D_INIT(c2d_port);
  port.context = this;
  connect<Run::store_of>(port);
  port.progress = [](void* c, const c2d_progress* now) { self(c).line_.show(*now); };
  if (!line_.active()) port.progress = nullptr;
  port.cancel = [](void* c) { return static_cast<int32_t>(self(c).must_stop()); };
  port.log = on_log;
  port.clock = clock_seconds;
  if (has_threads_) {
    port.parallel_for = [](void* c, int32_t n, void (*task)(void*, int32_t), void* argument) {
      c2d_threads_run(&self(c).threads_, n, task, argument);
    };
    port.threads = options_.threads;
  }
  return port;
}

// Restart with room for all pairs, if the program chose the number.
bool Run::begins_anew(int32_t status) const {
  return session_.limits.touching > 0 && options_.touching < 0 && (status == C2D_ERR_LIMIT || status == C2D_ERR_MEMORY);
}

int Run::library_failed(c2d_status status) {
  line_.clear();
  if (status == C2D_ERR_CALLBACK && !error_.empty()) return file_failed();
  if (restored_ && (status == C2D_ERR_STORE_READ || (status >= C2D_ERR_STORE_FORMAT && status <= C2D_ERR_STORE_STALE))) {
    fresh_start_ = "the tapes in " + options_.folder + " are damaged";
    return kExitFiles;
  }
  if (begins_anew(status)) {
    wants_all_pairs_ = true;
    fresh_start_ = status == C2D_ERR_LIMIT
                       ? "the contact cannot be on demand"
                       : "more than " + std::to_string(session_.limits.touching) + " pairs are in or near contact (--touching)";
  }
  if (!fresh_start_.empty()) return kExitFiles;
  const c2d_error last = session_.last_error();
  const int exit = session_.failed(status);
  const bool compressed = elimination_of(session_.limits, options_.elimination) == C2D_ELIMINATION_COMPRESSED;
  if (status == C2D_ERR_MEMORY && options_.elimination != C2D_ELIMINATION_COMPRESSED && compressed &&
      session_.limits.touching == 0)
    session_.messages.note("compressed elimination was chosen by size; --elimination dense takes less memory and more time");
  if (status < C2D_ERR_STORE_OPEN || status > C2D_ERR_STORE_STALE) return exit;
  if (const std::string why = store_.why_failed(last, status); !why.empty()) session_.messages.fail(why);
  return exit;
}

// A sketch and its files are stored before mesh refinement begins.
int Run::read_deck() {
  Drawing drawing{options_.settings, true, options_.memory, line_.active()};
  drawing.tolerances = !is_one_of_many_; // a row of a sweep only if it is asked for
  for (const Response& r : options_.responses) drawing.tolerances = drawing.tolerances || r.of == Response::Of::kTolerance;
  drawing.find_clash = [this](const std::vector<std::string>& read) { return find_clash(options_, read); };
  if (options_.store.compare(0, 5, "file:") == 0) {
    drawing.before_search = [this](const std::vector<NamedText>& files) { return keep_sketch(files); };
    drawing.keeper = &trials_;
  } else {
    drawing.store = &store_;
  }
  if (options_.text != nullptr) return session_.read_text(options_.deck, *options_.text, drawing);
  drawing.ends_in_results = drawing.keeper == nullptr; // otherwise a resumed run also reads stored meshes
  if (options_.job == nullptr) return session_.read_file(options_.deck, drawing);
  drawing.files = &options_.job->files;
  return session_.take_job(*options_.job, drawing);
}

int Run::keep_sketch(const std::vector<NamedText>& files) {
  constexpr double kWorthIt = 0.25; // seconds to solve a mesh
  if (options_.job == nullptr && !options_.points.empty() && !results_.interior.load(options_.points))
    return interrupted() ? kExitCancelled : kExitInput;
  take_inputs();
  const int exit = open_store();
  if (exit != 0) return exit;
  if (!kept_.keep(JobForm::kSketch, results_, files, error_)) return file_failed();
  trials_.begin(store_.kept_folder(), kept_.id(), std::min(kWorthIt, options_.save_every));
  return 0;
}

int Run::open_store() {
  const bool is_open = !store_.folder().empty();
  return is_open || store_.choose(options_.store, budget_, options_.keep, error_) ? 0 : file_failed();
}

// Reads the points file; needs the number of bodies.
int Run::read_points() {
  const bool of_job = options_.job != nullptr && options_.job->has_points;
  InteriorPoints& interior = results_.interior;
  if (of_job) return interior.take_text(options_.job->points, session_.limits.bodies) ? 0 : kExitInput;
  if (!options_.points.empty() && interior.read_file(options_.points, session_.limits.bodies)) return 0;
  if (!options_.points.empty()) return interrupted() ? kExitCancelled : kExitInput;
  const std::string& name = options_.file(Output::kInterior);
  if (name.empty() || options_.interior_if_any || session_.limits.point_sets > 0) return 0;
  return failed("--interior " + name + ": no points are given, expected --points FILE or *POINTS in the deck", kExitUsage);
}

// The workspace, the bytes that are left for tapes, and the threads.
int Run::take_memory_and_threads() {
  const int32_t chosen =
      options_.touching < 0 && options_.deck == "-" ? 0 : options_.touching; // (no restart from standard input)
  session_.limits.touching = touching_of(session_.limits, chosen, options_.elimination, options_.stepping);
  if (const int exit = session_.take_memory(options_.memory, options_.elimination); exit != 0) return exit;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape)
    store_.expect(tape, expected_bytes(session_.limits, options_.elimination, session_.workspace.minimum, tape));
  const uint64_t free = (free_memory() + store_.bytes_in_memory()) / 2;
  budget_ = free > session_.workspace.bytes ? free - session_.workspace.bytes : 0;
  if (options_.threads <= 1) return 0;
  const int32_t code = c2d_threads_start(&threads_, options_.threads);
  has_threads_ = code == 0;
  return has_threads_ ? 0 : failed(std::to_string(options_.threads) + " threads: " + store_.system_text(code), kExitMemory);
}

int Run::read_model() {
  if (const int exit = session_.read_model(make_port(), options_.symmetry); exit != 0) return exit;
  c2d_summary model = C2D_INIT(c2d_summary);
  if (const c2d_status status = c2d_get_summary(session_.solver, &model); status != C2D_OK) return library_failed(status);
  if (const std::string fault = fault_of_steps(model); !fault.empty()) return failed(fault);
  if (options_.estimate && !session_.meshes.ran()) {
    estimate::Demand demand;
    demand.memory = options_.memory, demand.symmetry = options_.symmetry, demand.quadrature = options_.quadrature;
    demand.elimination = options_.elimination;
    ToleranceTable tolerances = session_.meshes.tolerances;
    results_.record.meshes = estimate::estimate_deck(session_.solver, session_.deck.text(), demand);
    results_.record.meshes.tolerances = std::move(tolerances);
    const std::string& stopped = results_.record.meshes.stopped;
    if (!stopped.empty()) session_.messages.note("no errors are stated: " + stopped);
  }
  return results_.interior.take_sets(session_.solver, error_) ? 0 : failed(error_);
}

// The outputs, now that the deck is valid, and the store with the job.
int Run::open_outputs() {
  if (!outputs_.open(options_, results_.interior.any(), error_)) return file_failed();
  const int exit = open_store();
  if (exit != 0 || store_.kept_folder().empty()) return exit;
  if (!kept_.keep(session_.deck.is_made() ? JobForm::kMade : JobForm::kDeck, results_, {}, error_)) return file_failed();
  return 0;
}

int Run::read() {
  int exit = read_deck();
  results_.record.meshes = session_.meshes;
  if (exit == 0) exit = read_points();
  take_inputs();
  if (exit == 0) exit = take_memory_and_threads();
  if (exit == 0) exit = read_model();
  return exit == 0 ? open_outputs() : exit;
}

c2d_status Run::set_options() {
  Summary& summary = results_.summary;
  const c2d_status status = get_summary(session_.solver, summary);
  std::vector<int64_t> equations;
  for (int32_t b = 0; b < summary.bodies && status == C2D_OK; ++b) equations.push_back(summary.body[b].unknowns);
  line_.work.expect(equations, summary.steps, summary.coefficients);
  results_.shows_changes = summary.analysis >= C2D_ANALYSIS_ITERATIONS;
  c2d_options options = C2D_INIT(c2d_options);
  options.stepping = options_.stepping;
  options.quadrature = options_.quadrature;
  options.elimination = options_.elimination;
  options.symmetry = options_.symmetry;
  options.every_change = results_.shows_changes || (outputs_.needs() & kNeedsChanges) != 0;
  return status == C2D_OK ? c2d_set_options(session_.solver, &options) : status;
}

// Restores the factorisation of an earlier run, or assembles and eliminates and saves the result.
c2d_status Run::factorise() {
  c2d_solver* solver = session_.solver;
  c2d_status status = C2D_OK;
  if (options_.job != nullptr && options_.job->form != JobForm::kSketch && !anew_) {
    status = c2d_restore(solver);
    restored_ = status == C2D_OK || c2d_get_state(solver) == C2D_STATE_BROKEN; // partly restored if the tapes are damaged
    if (restored_) return status == C2D_OK ? kept_.restore(results_, outputs_, fresh_start_) : status;
    kept_.report_unusable(status, session_.messages);
  }
  if (store_.bytes_in_memory() > 0) { // tapes of the last mesh of the refinement, or of the previous row of a sweep
    tries_tapes_ = true;
    status = c2d_restore(solver);
    tries_tapes_ = false;
    if (status == C2D_OK || c2d_get_state(solver) == C2D_STATE_BROKEN) return status;
  }
  status = c2d_prepare(solver);
  return status == C2D_OK && (is_one_of_many_ || !store_.kept_folder().empty()) ? c2d_save(solver) : status;
}

int Run::prepare() {
  RunRecord& record = results_.record;
  uint32_t needs = outputs_.needs();
  if (record.meshes.ran()) needs |= kNeedsCorners;
  if (!options_.responses.empty()) needs |= kNeedsSums;
  c2d_status status = set_options();
  if (status == C2D_OK) status = get_summary(session_.solver, results_.summary);
  if (status == C2D_OK) status = results_.begin(needs);
  if (status == C2D_OK) status = outputs_.begin(results_);
  if (status == C2D_OK) status = get_summary(session_.solver, results_.summary);
  if (status != C2D_OK) return library_failed(status);
  record.read_seconds = results_.time_left();
  record.checked_only = results_.summary.analysis <= C2D_ANALYSIS_CHECK;
  if (record.checked_only) return 0;
  session_.messages.forget_latest();
  status = factorise();
  if (status != C2D_ERR_SINGULAR) return status == C2D_OK ? 0 : library_failed(status);
  library_failed(status);
  results_.stop_before_load(status);
  return 0;
}

int Run::follow() {
  if (results_.record.checked_only || results_.record.incomplete() != nullptr) return 0;
  c2d_summary now = C2D_INIT(c2d_summary);
  c2d_status status = c2d_get_summary(session_.solver, &now);
  if (status != C2D_OK) return library_failed(status);
  kept_.begin_path(now);
  is_following_ = true;
  let_steps_end(kept_.saves_states());
  status = c2d_run(session_.solver, on_step, this);
  let_steps_end(false);
  is_following_ = false;
  if (status == C2D_OK) compare_starts();
  return status == C2D_OK ? 0 : library_failed(status);
}

// A deck may ask whether its cycle depends on how the loads began.
void Run::compare_starts() {
  const RepeatedPaths repeated = repeated_paths(session_.solver);
  if (repeated.start != C2D_START_COMPARED) return;
  estimate::Demand demand;
  demand.memory = options_.memory, demand.symmetry = options_.symmetry, demand.quadrature = options_.quadrature;
  demand.elimination = options_.elimination;
  app::compare_starts(session_.deck.text(), repeated.digits, demand, results_.record);
}

int Run::report() {
  c2d_status status = results_.finish();
  line_.clear();
  if (status == C2D_OK) status = results_.draw();
  if (status == C2D_OK) status = outputs_.end(results_, error_);
  if (status != C2D_OK) return library_failed(status);
  for (const Response& response : options_.responses)
    values_.push_back(results_.solved ? evaluate(response, results_.record) : NAN);
  return 0;
}

int Run::close_store() {
  if (options_.text == nullptr) set_interrupt_target(nullptr);
  const c2d_status status = c2d_close(session_.solver);
  session_.solver = nullptr;
  if (status == C2D_OK) return 0;
  return failed((store_.folder().empty() ? "" : store_.folder() + ": ") + c2d_message(status), kExitFiles);
}

int Run::publish() {
  if (interrupted()) return kExitCancelled;
  if (!outputs_.publish(error_)) return file_failed();
  if (!options_.keep && !kept_.remove(error_)) return file_failed();
  if (!options_.keep && !store_.remove_tapes(error_)) return file_failed();
  if (options_.keep && !store_.folder().empty() && !options_.quiet)
    say("contact2d: tapes are kept in " + shown(store_.folder()) + "\n");
  const CoefficientRecord* stopped = results_.record.incomplete();
  if (exit_put_off() != 0) return exit_put_off();
  const CoefficientRecord* unsteady = stopped == nullptr ? results_.record.unsteady() : nullptr;
  if (unsteady != nullptr) return failed(unsteady_text(*unsteady, results_.summary), kExitNoSolution);
  const TorsionTable& torsion = results_.record.meshes.torsion;
  if (stopped == nullptr && !(torsion.why + torsion.ended).empty())
    return failed("loads round the axis: " + (torsion.why.empty() ? torsion.ended : "no results: " + torsion.why),
                  kExitNoSolution);
  if (stopped == nullptr) return results_.record.meshes.missed() ? kExitInaccurate : kExitSolved;
  return stopped->singular ? kExitNoSolution : failed(incomplete_text(*stopped), kExitNoSolution);
}

int Run::cancelled() {
  if (!told_to_end() || !kept_.is_kept()) return failed("cancelled", kExitCancelled);
  const std::string saved = kept_.saved().empty() ? "" : "the state of " + kept_.saved() + " is saved; ";
  session_.messages.note("stopped; " + saved + "contact2d resume " + options_.store.substr(5) + " continues the run");
  return kExitStopped;
}

int Run::go() {
  int exit = read();
  if (exit == 0) exit = prepare();
  if (exit == 0) exit = follow();
  line_.clear();
  if (exit == 0) exit = report();
  if (exit == 0) exit = close_store();
  if (exit == 0) exit = publish();
  if (exit == kExitInput || exit == kExitMemory || exit == kExitUsage) kept_.drop_sketch();
  return exit == kExitCancelled ? cancelled() : exit;
}

// A run, and a restart from the beginning if needed.
Answer solve(const Options& options, StoreChoice* store) {
  Options now = options;
  const double begun = clock_seconds(nullptr);
  forget_reason();
  for (bool anew = false;; anew = true) {
    Run run(now, begun, anew, store);
    const int exit = run.go();
    if (anew || run.wants_fresh_start().empty()) return {exit, run.values(), reason_told(), run.inputs()};
    if (!options.quiet) say("contact2d: " + run.wants_fresh_start() + "; the run restarts from the beginning\n");
    if (!run.wants_all_pairs()) continue;
    now.touching = 0;
    now.given.emplace_back("--touching", "0");
  }
}

} // namespace

int run_deck(const Options& options) {
  if (const std::string clash = find_clash(options); !clash.empty()) return fail(clash, kExitUsage);
  if (options.job != nullptr && !options.quiet)
    say("contact2d: " + shown(options.folder) + ": continues " + shown(options.job->deck_name) + ", started " +
        shown(options.job->begun) + "\n");
  const Answer answer = solve(options, nullptr);
  std::string error;
  const bool is_asked = !options.results.empty() || !options.row.empty();
  if (!is_asked || write_answer(options, answer, error)) return answer.exit;
  return fail(error, answer.exit != 0 ? answer.exit : static_cast<int>(kExitFiles));
}

Answer answer_of(const Options& options, StoreChoice& store) {
  const Muted muted;
  return solve(options, &store);
}

} // namespace app
