#include "program/run.hpp"

#include "post/summary.hpp"
#include "program/commands/drawn_words.hpp"
#include "program/commands/job.hpp"
#include "program/estimate/loop.hpp"
#include "program/exit_code.hpp"
#include "program/files/path_keeper.hpp"
#include "program/files/sha256.hpp"
#include "program/files/store_choice.hpp"
#include "program/interior_points.hpp"
#include "program/interrupt.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/session.hpp"
#include "program/sweep/answer.hpp"
#include "program/voice.hpp"
#include "report/csv.hpp"
#include "report/json.hpp"
#include "report/listing/listing.hpp"
#include "report/page.hpp"
#include "report/record.hpp"
#include "report/stresses.hpp"
#include "report/text.hpp"
#include "report/vtk.hpp"
#include "report/warnings.hpp"

#include <algorithm>
#include <c2d_threads.h>
#include <cmath>
#include <cstdio>
#include <ctime>

namespace app {
namespace {

std::string local_time() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  char text[32] = "";
  if (::localtime_r(&now, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts);
  return text;
}

class Run {
public:
  Run(const Options& options, double begun, bool anew = false, StoreChoice* of_many = nullptr)
      : options_(options), begun_(begun), store_(of_many != nullptr ? *of_many : own_store_), line_(options.progress),
        anew_(anew), is_one_of_many_(of_many != nullptr) {
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

  int read();
  int read_deck();
  int open_store(uint64_t budget);
  int keep_sketch(const std::vector<NamedText>& files);
  void take_inputs();
  int read_points();
  bool keep(JobForm form, const std::vector<NamedText>& files = {});
  bool claim();
  void drop_sketch();
  void tell_anew(c2d_status status);
  c2d_status go_on();
  bool save_path(const c2d_step& step);
  bool show_stresses(const c2d_step& step, StepRecord& kept);
  void begin_tables();
  int prepare();
  c2d_status factorise();
  int follow();
  void stopped_before_load(c2d_status status);
  void show_contact_zone();
  double time_left() const;
  int report();
  c2d_status show_interior();
  c2d_status show_vtk(const Scene& scene);
  c2d_status show_pictures();
  // They cost more time than the solution of a small deck.
  bool tells_corners() const { return record_.meshes.ran() || outputs_.has(Output::kJson) || has_pictures(); }
  // The complete listing, or only the summary on a terminal without --listing.
  bool has_whole_listing() const { return outputs_.has(Output::kListing) && !outputs_.shows_end_alone; }
  // Of every load case, by the last coefficient of friction.
  std::vector<double> loads_reached() const {
    return record_.coefficients.empty() ? std::vector<double>{summary_.load} : record_.coefficients.back().loads;
  }
  bool has_pictures() const { return outputs_.has(Output::kReport) || outputs_.figures.is_open(); }
  int close_store();
  int publish();
  int cancelled();
  int file_failed() {
    if (interrupted()) return kExitCancelled; // a waiting call was cancelled
    session_.messages.fail(error_);
    return store_.is_busy() ? kExitBusy : kExitFiles;
  }
  int library_failed(c2d_status status);

  const Options& options_;
  const double begun_; // by clock_seconds
  // In the order in which they need each other: the solver closes its tapes before the store goes.
  c2d_threads threads_;
  bool has_threads_ = false;
  StoreChoice own_store_;
  StoreChoice& store_; // own_store_, or a store with the tapes of the previous run
  ProgressLine line_;
  Session session_;
  Outputs outputs_;
  RunRecord record_;
  InteriorPoints interior_;
  std::vector<StressPlace> stressed_; // of --stresses and --ranges
  PathRecord path_;                   // its history only if there will be pictures; its coefficients are those of record_
  bool shows_changes_ = false;        // the deck wants every change of status in the listing
  std::vector<Corner> corners_;
  Summary summary_;
  std::vector<std::vector<ContactEnd>> ends_; // of each body
  std::vector<CrackTip> tips_;
  std::vector<ZoneLine> lines_;
  bool anew_ = false; // resumed run that does not use its tapes
  bool is_one_of_many_ = false;
  bool restored_ = false;
  bool tries_tapes_ = false; // tapes may belong to another model: not a fault
  std::string fresh_start_;
  bool wants_all_pairs_ = false;
  Job job_; // as stored, if stored
  bool kept_ = false, is_following_ = false;
  estimate::TrialKeeper trials_;
  PathKeeper keeper_;
  std::string saved_;       // the last step with a saved state
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
  if (run.has_pictures()) run.path_.history.note(*step);
  if (run.outputs_.has(Output::kTrace)) run.path_.trace.append(run.outputs_.text(Output::kTrace), *step);
  if (step->kind == C2D_STEP_CHANGE && !run.shows_changes_) return 0;
  const CoefficientRecord* before = static_cast<size_t>(step->coefficient) <= run.record_.coefficients.size()
                                        ? &run.record_.coefficients[static_cast<size_t>(step->coefficient) - 1]
                                        : nullptr;
  const bool again = before != nullptr && !before->table.empty() && before->load == step->load;
  if (run.path_.coefficient_shown != step->coefficient) run.show_contact_zone();
  CoefficientRecord& kept = keep_step(run.record_, *step);
  const bool ends = step->kind == C2D_STEP_STOPPED || step->step == run.summary_.steps;
  const bool sums_up = (run.outputs_.has(Output::kListing) && ends) || run.outputs_.has(Output::kJson) ||
                       run.outputs_.has(Output::kSummary) || run.has_pictures() || !run.options_.responses.empty();
  if (step->kind == C2D_STEP_RECORDED) run.line_.work.reached(step->coefficient, step->step, step->load);
  keep_history(kept, *step, sums_up ? run.session_.solver : nullptr, run.tips_, run.lines_);
  if (run.has_whole_listing()) {
    append_step(run.outputs_.text(Output::kListing), *step, run.path_.coefficient_shown != step->coefficient);
    run.path_.coefficient_shown = step->coefficient;
  }
  if (run.outputs_.has(Output::kJson)) keep_corners(kept, *step, run.corners_);
  // A path that ended in the state of its last row adds no row.
  const bool row = step->kind == C2D_STEP_RECORDED || (step->kind == C2D_STEP_STOPPED && !again);
  if (row && run.outputs_.has(Output::kCsv)) append_contact_rows(run.outputs_.text(Output::kCsv), *step, run.summary_);
  if (row && run.outputs_.has(Output::kBodies))
    append_bodies_rows(run.outputs_.text(Output::kBodies), *step, run.session_.solver);
  if (row && !run.stressed_.empty() && !run.show_stresses(*step, kept.steps.back())) return 1;
  if (step->kind == C2D_STEP_STOPPED) {
    c2d_summary now = C2D_INIT(c2d_summary);
    c2d_get_summary(run.session_.solver, &now);
    explain(kept, now, run.summary_, run.session_.messages.latest());
    if (run.session_.deck.is_made()) kept.why = in_words_of_drawing(kept.why, run.session_.deck.text());
    run.session_.messages.forget_latest();
  }
  return run.outputs_.flush(run.error_) && run.save_path(*step) ? 0 : 1;
}

// At every place; stored for the ranges.
bool Run::show_stresses(const c2d_step& step, StepRecord& kept) {
  std::vector<double> numbers;
  c2d_status status = add_end_stresses(session_.solver, summary_, numbers);
  if (status == C2D_OK) status = interior_.add_stresses(session_.solver, summary_.bodies, numbers);
  if (status != C2D_OK) {
    c2d_error last = C2D_INIT(c2d_error);
    c2d_last_error(session_.solver, &last);
    error_ = last.text[0] != '\0' ? last.text : c2d_message(status);
    return false;
  }
  if (outputs_.has(Output::kStresses)) append_stresses_rows(outputs_.text(Output::kStresses), step, stressed_, numbers);
  if (outputs_.has(Output::kRanges)) kept.stresses = std::move(numbers);
  return true;
}

// Saves the state if the interval is over, or at the last opportunity.
bool Run::save_path(const c2d_step& step) {
  if (step.kind == C2D_STEP_CHANGE || !(keeper_.is_due() || (keeper_.is_active() && told_to_end()))) return true;
  bool all = true; // all outputs can be written again
  for (size_t i = 0; i < kOutputs && all; ++i)
    all = !outputs_.files[i].is_open() || outputs_.files[i].so_far(path_.outputs[i], error_);
  if (all) {
    path_.warnings = session_.messages.warnings();
    path_.latest = session_.messages.latest();
    std::swap(path_.coefficients, record_.coefficients);
    const std::string text = text_of(path_);
    std::swap(path_.coefficients, record_.coefficients);
    all = keeper_.keep(session_.solver, step.coefficient, step.step, text, error_);
  }
  for (std::string& text : path_.outputs) text = std::string();
  if (!all && !error_.empty()) return false;
  if (all) saved_ = "step " + std::to_string(step.step) + ", " + load_reached(record_.coefficients.back());
  if (told_to_end()) c2d_cancel(session_.solver);
  return true;
}

// On the load path SIGTERM leaves some time to reach a load whose state can be saved.
bool Run::must_stop() {
  constexpr double kPatience = 5;
  if (!told_to_end() || !is_following_ || !keeper_.is_active()) return interrupted();
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
  c2d_error last = C2D_INIT(c2d_error);
  if (session_.solver != nullptr) c2d_last_error(session_.solver, &last);
  const int exit = session_.failed(status);
  const bool compressed = elimination_of(session_.limits, options_.elimination) == C2D_ELIMINATION_COMPRESSED;
  if (status == C2D_ERR_MEMORY && options_.elimination != C2D_ELIMINATION_COMPRESSED && compressed &&
      session_.limits.touching == 0)
    session_.messages.note("compressed elimination was chosen by size; --elimination dense takes less memory and more time");
  if (status < C2D_ERR_STORE_OPEN || status > C2D_ERR_STORE_STALE) return exit;
  const std::string file = store_.file_of(last.tape);
  const std::string why = last.host_code != 0 ? store_.system_text(last.host_code) : c2d_message(status);
  if (last.host_code != 0 || !file.empty()) session_.messages.fail(file.empty() ? why : file + ": " + why);
  return exit;
}

// A sketch and its files are stored before mesh refinement begins.
int Run::read_deck() {
  Drawing drawing{options_.settings, true, options_.memory, line_.active()};
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

// A resumed run has the inputs of the run that began.
void Run::take_inputs() {
  record_.inputs = options_.job != nullptr ? options_.job->inputs : session_.deck.inputs;
  if (options_.job != nullptr) return;
  record_.inputs.options = words_that_change_digits(options_);
  if (!options_.points.empty()) record_.inputs.files.push_back(input_file(options_.points, interior_.file_text()));
}

int Run::keep_sketch(const std::vector<NamedText>& files) {
  constexpr double kWorthIt = 0.25; // seconds to solve a mesh
  if (options_.job == nullptr && !options_.points.empty() && !interior_.load(options_.points))
    return interrupted() ? kExitCancelled : kExitInput;
  take_inputs();
  const int exit = open_store(0);
  if (exit != 0) return exit;
  if (!keep(JobForm::kSketch, files)) return file_failed();
  trials_.begin(store_.kept_folder(), id_of(job_), std::min(kWorthIt, options_.save_every));
  return 0;
}

int Run::open_store(uint64_t budget) {
  if (!store_.folder().empty()) return 0;
  return store_.choose(options_.store, budget, options_.keep, error_) ? 0 : file_failed();
}

// Reads the deck, allocates the workspace and opens the store; opens the outputs once the deck is valid.
int Run::read() {
  int exit = read_deck();
  record_.meshes = session_.meshes;
  if (exit == 0) exit = read_points();
  take_inputs();
  const int32_t chosen =
      options_.touching < 0 && options_.deck == "-" ? 0 : options_.touching; // (no restart from standard input)
  session_.limits.touching = touching_of(session_.limits, chosen, options_.elimination, options_.stepping);
  if (exit == 0) exit = session_.take_memory(options_.memory, options_.elimination);
  if (exit != 0) return exit;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape)
    store_.expect(tape, expected_bytes(session_.limits, options_.elimination, session_.workspace.minimum, tape));
  const uint64_t free = (free_memory() + store_.bytes_in_memory()) / 2;
  const uint64_t budget = free > session_.workspace.bytes ? free - session_.workspace.bytes : 0;
  if (options_.threads > 1) {
    const int32_t code = c2d_threads_start(&threads_, options_.threads);
    has_threads_ = code == 0;
    if (!has_threads_) {
      session_.messages.fail(std::to_string(options_.threads) + " threads: " + store_.system_text(code));
      return kExitMemory;
    }
  }
  exit = session_.read_model(make_port(), options_.symmetry);
  if (exit != 0) return exit;
  c2d_summary model = C2D_INIT(c2d_summary);
  if (const c2d_status status = c2d_get_summary(session_.solver, &model); status != C2D_OK) return library_failed(status);
  if (const std::string fault = fault_of_steps(model); !fault.empty()) {
    session_.messages.fail(fault);
    return kExitInput;
  }
  if (options_.estimate && !record_.meshes.ran()) {
    estimate::Demand demand;
    demand.memory = options_.memory, demand.symmetry = options_.symmetry, demand.quadrature = options_.quadrature;
    demand.elimination = options_.elimination;
    record_.meshes = estimate::estimate_deck(session_.solver, session_.deck.text(), demand);
    if (!record_.meshes.stopped.empty()) session_.messages.note("no errors are stated: " + record_.meshes.stopped);
  }
  if (!interior_.take_sets(session_.solver, error_)) {
    session_.messages.fail(error_);
    return kExitInput;
  }
  if (!outputs_.open(options_, interior_.any(), error_)) return file_failed();
  exit = open_store(budget);
  if (exit != 0 || store_.kept_folder().empty()) return exit;
  if (!keep(session_.deck.is_made() ? JobForm::kMade : JobForm::kDeck)) return file_failed();
  keeper_.begin(store_.kept_folder(), id_of(job_), options_.save_every);
  return 0;
}

// The folder is locked now. A resumed job must still be there; for a new run, old states are removed.
bool Run::claim() {
  if (options_.job == nullptr) return remove_way(store_.kept_folder(), error_);
  kept_ = is_kept(store_.kept_folder(), *options_.job);
  if (!kept_) error_ = options_.folder + ": another process has finished or replaced this run";
  job_ = *options_.job;
  return kept_;
}

// From here on an interrupted run can be resumed.
bool Run::keep(JobForm form, const std::vector<NamedText>& files) {
  if (!kept_ && !claim()) return false;
  if (kept_ && job_.form == form) return true;
  const bool had_meshes = kept_;
  if (!kept_) job_.begun = local_time(), job_.words = words_of(options_);
  job_.form = form;
  job_.deck_name = session_.deck.name();
  job_.deck = session_.deck.text();
  job_.settings = form == JobForm::kSketch ? options_.settings : std::vector<std::string>();
  job_.files = files;
  job_.has_points = job_.has_points || !options_.points.empty();
  job_.points = interior_.file_text();
  job_.workspace = form == JobForm::kSketch ? options_.memory : session_.workspace.bytes;
  job_.inputs = record_.inputs;
  job_.meshes = record_.meshes;
  kept_ = keep_job(store_.kept_folder(), job_, error_);
  return kept_ && (!had_meshes || remove_way(store_.kept_folder(), error_));
}

// Removes the job of a run that failed, because of its input, before it had a deck: it cannot be resumed.
void Run::drop_sketch() {
  std::string ignored;
  const std::string folder = store_.kept_folder();
  if (kept_ && options_.job == nullptr && job_.form == JobForm::kSketch && remove_job(folder, ignored) &&
      remove_way(folder, ignored))
    store_.remove_tapes(ignored);
}

// Reports that no saved data can be used.
void Run::tell_anew(c2d_status status) {
  const bool nothing = status == C2D_ERR_STORE_READ || status == C2D_ERR_STORE_FORMAT;
  std::string why = c2d_message(status);
  if (nothing) why = "nothing was saved before the run was interrupted";
  if (status == C2D_ERR_MISMATCH) why = "the saved data belong to another model or to another build of this program";
  session_.messages.note(options_.folder + ": " + why + "; the run restarts from the beginning");
}

// Restores the record of the steps up to the restored state. Without it the state cannot be used.
c2d_status Run::go_on() {
  c2d_summary now = C2D_INIT(c2d_summary);
  const c2d_status status = c2d_get_summary(session_.solver, &now);
  if (status != C2D_OK || now.run_step == 0) return status;
  std::string text, why;
  PathRecord found;
  found.history.begin(summary_.steps);
  bool whole = keeper_.find(now.run_coefficient, now.run_step, text, why);
  if (whole && !read_path_record(text, summary_, found)) why = "the record of the earlier steps belongs to another model";
  whole = whole && why.empty();
  if (!whole) {
    fresh_start_ = options_.folder + ": a state is saved at step " + std::to_string(now.run_step) + ", but " + why;
    return C2D_ERR_MISMATCH;
  }
  path_ = std::move(found);
  record_.coefficients = std::move(path_.coefficients);
  for (size_t i = 0; i < kOutputs; ++i) {
    if (outputs_.files[i].is_open()) outputs_.files[i].text = std::move(path_.outputs[i]);
    path_.outputs[i] = std::string();
  }
  session_.messages.take(std::move(path_.warnings), std::move(path_.latest));
  session_.messages.note("continues after step " + std::to_string(now.run_step));
  return C2D_OK;
}

// Restores the factorisation of an earlier run, or assembles and eliminates and saves the result.
c2d_status Run::factorise() {
  c2d_solver* solver = session_.solver;
  c2d_status status = C2D_OK;
  if (options_.job != nullptr && options_.job->form != JobForm::kSketch && !anew_) {
    status = c2d_restore(solver);
    restored_ = status == C2D_OK || c2d_get_state(solver) == C2D_STATE_BROKEN; // partly restored if the tapes are damaged
    if (restored_) return status == C2D_OK ? go_on() : status;
    tell_anew(status);
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

// Reads the points file; needs the number of bodies.
int Run::read_points() {
  if (options_.job != nullptr && options_.job->has_points)
    return interior_.take_text(options_.job->points, session_.limits.bodies) ? 0 : kExitInput;
  if (!options_.points.empty())
    return interior_.read_file(options_.points, session_.limits.bodies) ? 0 : interrupted() ? kExitCancelled : kExitInput;
  if (options_.file(Output::kInterior).empty() || options_.interior_if_any || session_.limits.point_sets > 0) return 0;
  session_.messages.fail("--interior " + options_.file(Output::kInterior) +
                         ": no points are given, expected --points FILE or *POINTS in the deck");
  return kExitUsage;
}

void Run::begin_tables() {
  if (outputs_.has(Output::kCsv)) append_contact_header(outputs_.text(Output::kCsv), summary_.load_cases);
  if (outputs_.has(Output::kBodies)) append_bodies_header(outputs_.text(Output::kBodies), summary_.load_cases);
  if (outputs_.has(Output::kTrace)) append_trace_header(outputs_.text(Output::kTrace), summary_.load_cases);
  if (outputs_.has(Output::kBoundary)) append_boundary_header(outputs_.text(Output::kBoundary));
  if (outputs_.has(Output::kInterior)) append_interior_header(outputs_.text(Output::kInterior));
  if (outputs_.has(Output::kStresses)) append_stresses_header(outputs_.text(Output::kStresses), summary_.load_cases);
}

int Run::prepare() {
  c2d_solver* solver = session_.solver;
  c2d_status status = get_summary(solver, summary_);
  if (status != C2D_OK) return library_failed(status);
  c2d_options options = C2D_INIT(c2d_options);
  options.stepping = options_.stepping;
  options.quadrature = options_.quadrature;
  options.elimination = options_.elimination;
  std::vector<int64_t> equations;
  for (int32_t b = 0; b < summary_.bodies; ++b) equations.push_back(summary_.body[static_cast<size_t>(b)].unknowns);
  line_.work.expect(equations, summary_.steps, summary_.coefficients);
  shows_changes_ = summary_.analysis >= C2D_ANALYSIS_ITERATIONS;
  options.every_change = shows_changes_ || has_pictures() || outputs_.has(Output::kTrace);
  path_.history.begin(summary_.steps);
  options.symmetry = options_.symmetry;
  status = c2d_set_options(solver, &options);
  if (status == C2D_OK) status = get_summary(solver, summary_);
  if (status == C2D_OK && has_whole_listing())
    status = append_model(outputs_.text(Output::kListing), solver, summary_, session_.deck.heading());
  ends_.resize(static_cast<size_t>(summary_.bodies));
  for (int32_t body = 1; body <= summary_.bodies && status == C2D_OK && summary_.pairs > 0; ++body)
    status = find_contact_ends(solver, summary_, body, ends_[static_cast<size_t>(body) - 1]);
  if (status == C2D_OK) status = find_crack_tips(solver, summary_, tips_);
  if (status == C2D_OK) status = find_zone_lines(solver, summary_, lines_);
  if (session_.deck.is_made()) take_statements(session_.deck.text(), lines_);
  for (int32_t i = 1; i <= summary_.coefficients && status == C2D_OK; ++i) {
    record_.friction.push_back(0.0);
    status = c2d_get_friction(solver, 0, i, &record_.friction.back());
  }
  for (int32_t i = 1; i <= summary_.zones && status == C2D_OK; ++i) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    status = c2d_get_zone(solver, i, &zone);
    record_.zone_friction.push_back(0.0);
    if (status == C2D_OK) status = c2d_get_friction(solver, i, 1, &record_.zone_friction.back());
    record_.measure.push_back((zone.kind & C2D_ZONE_FREE) != 0 ? zone.side2.body
                                                               : zone.side1.body); // the first has nodes on side 2
  }
  if (status == C2D_OK && (outputs_.has(Output::kStresses) || outputs_.has(Output::kRanges))) {
    status = add_end_places(solver, summary_, stressed_);
    interior_.add_places(stressed_);
  }
  if (status == C2D_OK && tells_corners()) status = find_corners(solver, summary_, corners_);
  begin_tables();
  if (status == C2D_OK) status = get_summary(solver, summary_);
  if (status != C2D_OK) return library_failed(status);
  record_.read_seconds = time_left();
  record_.checked_only = summary_.analysis <= C2D_ANALYSIS_CHECK;
  if (record_.checked_only) return 0;
  session_.messages.forget_latest();
  status = factorise();
  if (status == C2D_ERR_SINGULAR) {
    stopped_before_load(status);
    return 0;
  }
  return status == C2D_OK ? 0 : library_failed(status);
}

// No solvable equations: all coefficients end without a result.
void Run::stopped_before_load(c2d_status status) {
  library_failed(status);
  for (int32_t i = 1; i <= summary_.coefficients; ++i) {
    CoefficientRecord none;
    none.singular = true;
    none.why = session_.messages.latest().empty() ? c2d_message(status) : session_.messages.latest();
    c2d_get_friction(session_.solver, 0, i, &none.mu);
    record_.coefficients.push_back(none);
  }
}

int Run::follow() {
  if (record_.checked_only || record_.incomplete() != nullptr) return 0;
  constexpr double kBytesPerSecond = 1e8; // of tape 0, which has room for two states
  c2d_summary now = C2D_INIT(c2d_summary);
  c2d_status status = c2d_get_summary(session_.solver, &now);
  if (status != C2D_OK) return library_failed(status);
  keeper_.start(static_cast<double>(now.tape_blocks[C2D_TAPE_CONTROL]) / 2 * 512 / kBytesPerSecond);
  is_following_ = true;
  let_steps_end(keeper_.is_active());
  status = c2d_run(session_.solver, on_step, this);
  let_steps_end(false);
  is_following_ = false;
  return status == C2D_OK ? 0 : library_failed(status);
}

// The end of the last coefficient that was followed.
void Run::show_contact_zone() {
  if (has_whole_listing() && !record_.coefficients.empty())
    append_contact_zone(outputs_.text(Output::kListing), record_.coefficients.back(), ends_.data(), summary_);
}

// Since the run began, that the phases of the library have not taken, by the last summary: all of the time is some phase's.
double Run::time_left() const {
  double left = clock_seconds(nullptr) - begun_;
  for (const double seconds : summary_.seconds) left -= seconds;
  return left;
}

int Run::report() {
  c2d_solver* solver = session_.solver;
  const bool solved = c2d_get_state(solver) == C2D_STATE_RUNNING;
  c2d_status status = get_summary(solver, summary_);
  if (status != C2D_OK) return library_failed(status);
  record_.take_stated_errors();
  outputs_.write_inputs(inputs_text(record_.inputs));
  if (outputs_.has(Output::kSummary)) append_summary(outputs_.text(Output::kSummary), record_, summary_);
  if (outputs_.has(Output::kRanges)) append_ranges(outputs_.text(Output::kRanges), record_, stressed_);
  if (outputs_.has(Output::kBoundary) && solved) status = append_boundary(outputs_.text(Output::kBoundary), solver, summary_);
  if (status == C2D_OK && has_whole_listing()) {
    std::string& out = outputs_.text(Output::kListing);
    show_contact_zone();
    const bool all = summary_.analysis == C2D_ANALYSIS_STRESS || summary_.analysis >= C2D_ANALYSIS_FULL;
    if (solved && all) status = append_global(out, solver, summary_, loads_reached());
  }
  if (status == C2D_OK && solved) status = corner_states(solver, summary_, corners_, record_.corners);
  record_.warnings = session_.messages.warnings();
  if (status == C2D_OK && solved && interior_.any()) status = show_interior();
  order_warnings(record_.warnings);
  if (status == C2D_OK) status = show_pictures();
  if (status == C2D_OK) status = get_summary(solver, summary_); // with what the outputs above have taken
  if (status != C2D_OK) return library_failed(status);
  for (const Response& response : options_.responses) values_.push_back(solved ? evaluate(response, record_) : NAN);
  if (has_whole_listing() && solved && outputs_.has(Output::kSummary))
    append_key_tables(outputs_.text(Output::kListing), record_, summary_);
  if (has_whole_listing())
    append_ending(outputs_.text(Output::kListing), record_, summary_);
  else if (outputs_.has(Output::kListing))
    append_short_ending(outputs_.text(Output::kListing), record_, summary_);
  record_.write_seconds = time_left() - record_.read_seconds;
  if (outputs_.has(Output::kJson)) append_json(outputs_.text(Output::kJson), record_, summary_);
  return 0;
}

// The requested results inside the bodies, at the load reached.
c2d_status Run::show_interior() {
  const c2d_status status = interior_.evaluate(session_.solver, summary_.bodies);
  if (status != C2D_OK) return status;
  record_.interior = &interior_.results();
  line_.clear();
  interior_.report_places(session_.messages, summary_, record_.warnings);
  if (outputs_.has(Output::kInterior)) append_interior_rows(outputs_.text(Output::kInterior), interior_.results());
  if (has_whole_listing())
    append_interior_section(outputs_.text(Output::kListing), interior_.results(), summary_, loads_reached());
  return C2D_OK;
}

// With the requested points, or a grid over each body.
c2d_status Run::show_vtk(const Scene& scene) {
  InteriorPoints all;
  c2d_status status = C2D_OK;
  if (!interior_.any() && scene.solved) status = all.take_bodies(session_.solver, scene.summary);
  if (status == C2D_OK && all.any()) status = all.evaluate(session_.solver, scene.summary.bodies);
  if (status != C2D_OK) return status;
  return append_vtk(outputs_.text(Output::kVtk), scene, all.any() ? all.results() : interior_.results());
}

// The pictures as a page and as files, and the boundary for ParaView.
c2d_status Run::show_pictures() {
  if (!has_pictures() && !outputs_.has(Output::kVtk)) return C2D_OK;
  Scene scene;
  c2d_status status = gather_scene(session_.solver, record_, path_.history, scene);
  if (status == C2D_OK && outputs_.has(Output::kVtk)) status = show_vtk(scene);
  if (status != C2D_OK || !has_pictures()) return status;
  Pictures pictures;
  status = draw_pictures(scene, pictures);
  if (status == C2D_OK) status = get_summary(session_.solver, scene.summary);
  if (status != C2D_OK) return status;
  if (outputs_.has(Output::kReport)) append_page(outputs_.text(Output::kReport), scene, pictures, session_.deck.name());
  for (const Picture& picture : pictures)
    if (outputs_.figures.is_open() && !outputs_.figures.add(picture.name + ".svg", picture.svg, error_))
      return C2D_ERR_CALLBACK;
  return C2D_OK;
}

int Run::close_store() {
  if (options_.text == nullptr) set_interrupt_target(nullptr);
  const c2d_status status = c2d_close(session_.solver);
  session_.solver = nullptr;
  if (status == C2D_OK) return 0;
  const std::string& folder = store_.folder();
  session_.messages.fail((folder.empty() ? "" : folder + ": ") + c2d_message(status));
  return kExitFiles;
}

int Run::publish() {
  if (interrupted()) return kExitCancelled;
  if (!outputs_.publish(error_)) return file_failed();
  const std::string& kept = store_.kept_folder();
  if (!options_.keep && !kept.empty() && !(remove_job(kept, error_) && remove_way(kept, error_))) return file_failed();
  if (!options_.keep && !store_.remove_tapes(error_)) return file_failed();
  if (options_.keep && !store_.folder().empty() && !options_.quiet)
    say("contact2d: tapes are kept in " + shown(store_.folder()) + "\n");
  const CoefficientRecord* stopped = record_.incomplete();
  if (exit_put_off() != 0) return exit_put_off();
  if (stopped == nullptr) return record_.meshes.missed() ? kExitInaccurate : kExitSolved;
  if (!stopped->singular) {
    std::string text = "incomplete: mu ";
    append_number(text, stopped->mu);
    text += ", step " + std::to_string(stopped->step) + ", " + load_reached(*stopped);
    session_.messages.fail(text + ": " + stopped->why);
  }
  return kExitNoSolution;
}

int Run::go() {
  int exit = read();
  if (exit == 0) exit = prepare();
  if (exit == 0) exit = follow();
  line_.clear();
  if (exit == 0) exit = report();
  if (exit == 0) exit = close_store();
  if (exit == 0) exit = publish();
  if (exit == kExitInput || exit == kExitMemory || exit == kExitUsage) drop_sketch();
  return exit == kExitCancelled ? cancelled() : exit;
}

int Run::cancelled() {
  if (!told_to_end() || !kept_) {
    session_.messages.fail("cancelled");
    return kExitCancelled;
  }
  const std::string folder = options_.store.substr(5);
  session_.messages.note("stopped; " + (saved_.empty() ? "" : "the state of " + saved_ + " is saved; ") + "contact2d resume " +
                         folder + " continues the run");
  return kExitStopped;
}

// A run, and a restart from the beginning if needed; with the values of the responses.
int run_with(const Options& options, std::vector<double>& values, StoreChoice* store) {
  Options again = options;
  const double begun = clock_seconds(nullptr);
  {
    Run run(options, begun, false, store);
    const int exit = run.go();
    values = run.values();
    if (run.wants_fresh_start().empty()) return exit;
    if (!options.quiet) say("contact2d: " + run.wants_fresh_start() + "; the run restarts from the beginning\n");
    if (run.wants_all_pairs()) {
      again.touching = 0;
      again.given.emplace_back("--touching", "0");
    }
  }
  Run run(again, begun, true, store);
  const int exit = run.go();
  values = run.values();
  return exit;
}

int run_whole(const Options& options, std::vector<double>& values) {
  const std::string clash = find_clash(options);
  if (!clash.empty()) {
    say("contact2d: " + coloured(Colour::kError, "error:") + " " + shown(clash) + "\n");
    return kExitUsage;
  }
  if (options.job != nullptr && !options.quiet)
    say("contact2d: " + shown(options.folder) + ": continues " + shown(options.job->deck_name) + ", started " +
        shown(options.job->begun) + "\n");
  return run_with(options, values, nullptr);
}

} // namespace

int run_deck(const Options& options) {
  std::vector<double> values;
  forget_reason();
  const int exit = run_whole(options, values);
  const bool asked = !options.results.empty() || !options.row.empty();
  if (!asked || !find_clash(options).empty()) return exit; // do not overwrite a file with another use
  std::string error;
  if (write_answer(options, {exit, values, reason_told()}, error)) return exit;
  say("contact2d: " + coloured(Colour::kError, "error:") + " " + shown(error) + "\n");
  return exit != 0 ? exit : static_cast<int>(kExitFiles);
}

Answer answer_of(const Options& options, StoreChoice& store) {
  const Muted muted;
  forget_reason();
  std::vector<double> values;
  const int exit = run_with(options, values, &store);
  return {exit, values, reason_told()};
}

} // namespace app
