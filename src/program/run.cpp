#include "program/run.hpp"

#include "program/estimate/loop.hpp"
#include "program/exit_code.hpp"
#include "program/interior_points.hpp"
#include "program/interrupt.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/restart.hpp"
#include "program/session.hpp"
#include "program/store_choice.hpp"
#include "report/csv.hpp"
#include "report/json.hpp"
#include "report/listing.hpp"
#include "report/page.hpp"
#include "report/record.hpp"
#include "report/summary.hpp"
#include "report/text.hpp"
#include "report/trace.hpp"
#include "report/vtk.hpp"

#include <c2d_threads.h>
#include <cstdio>

namespace app {
namespace {

class Run {
public:
  explicit Run(const Options& options) : options_(options), line_(options.progress) {}
  ~Run() {
    if (has_threads_) c2d_threads_stop(&threads_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  int go();
  // The tapes that a resumed run found turned out to be damaged: only a run from the beginning helps.
  bool wants_fresh_start() const { return fresh_start_; }

private:
  // The functions of the port; their context is the Run.
  static Run& self(void* context) { return *static_cast<Run*>(context); }
  static void on_log(void* context, const c2d_error* entry);
  static int32_t on_step(void* context, const c2d_step* step);
  c2d_port make_port();

  int read();
  int read_points();
  void begin_tables();
  int prepare();
  c2d_status factorise();
  int follow();
  void stopped_before_load(c2d_status status);
  void show_contact_zone();
  int report();
  c2d_status show_interior();
  c2d_status show_vtk(const Scene& scene);
  c2d_status show_pictures();
  // They take longer to find than a small deck to solve.
  bool tells_corners() const { return record_.meshes.ran() || outputs_.has(Output::kJson) || has_pictures(); }
  bool has_pictures() const { return outputs_.has(Output::kReport) || outputs_.figures.is_open(); }
  int close_store();
  int publish();
  int file_failed() {
    if (interrupted()) return kExitCancelled; // a call that waited was told to stop
    session_.messages.fail(error_);
    return kExitFiles;
  }
  int library_failed(c2d_status status);

  const Options& options_;
  // In the order in which they need each other: the solver closes its tapes before the store goes.
  c2d_threads threads_;
  bool has_threads_ = false;
  StoreChoice store_;
  ProgressLine line_;
  Session session_;
  Outputs outputs_;
  RunRecord record_;
  InteriorPoints interior_;
  Trace trace_;
  History history_;            // only if there will be pictures
  bool shows_changes_ = false; // the deck wants every change of status in the listing
  std::vector<Corner> corners_;
  Summary summary_;
  std::vector<std::vector<ContactEnd>> ends_; // of each body
  std::vector<CrackTip> tips_;
  std::vector<ZoneLine> lines_;
  bool restored_ = false, fresh_start_ = false;
  int32_t coefficient_shown_ = 0; // the coefficient whose heading stands in the listing
  std::string error_;
};

void Run::on_log(void* context, const c2d_error* entry) {
  Run& run = self(context);
  run.line_.clear();
  Messages::log(&run.session_.messages, entry);
}

int32_t Run::on_step(void* context, const c2d_step* step) {
  Run& run = self(context);
  if (run.has_pictures()) run.history_.note(*step);
  if (run.outputs_.has(Output::kTrace)) run.trace_.append(run.outputs_.text(Output::kTrace), *step);
  if (step->kind == C2D_STEP_CHANGE && !run.shows_changes_) return 0;
  const CoefficientRecord* before = static_cast<size_t>(step->coefficient) <= run.record_.coefficients.size()
                                        ? &run.record_.coefficients[static_cast<size_t>(step->coefficient) - 1]
                                        : nullptr;
  const bool again = before != nullptr && !before->table.empty() && before->load == step->load;
  if (run.coefficient_shown_ != step->coefficient) run.show_contact_zone();
  CoefficientRecord& kept = keep_step(run.record_, *step);
  const bool ends = step->kind == C2D_STEP_STOPPED || step->step == run.summary_.steps;
  const bool sums_up = (run.outputs_.has(Output::kListing) && ends) || run.outputs_.has(Output::kJson) ||
                       run.outputs_.has(Output::kSummary) || run.outputs_.has(Output::kReport);
  keep_history(kept, *step, sums_up ? run.session_.solver : nullptr, run.tips_, run.lines_);
  if (run.outputs_.has(Output::kListing)) {
    append_step(run.outputs_.text(Output::kListing), *step, run.coefficient_shown_ != step->coefficient);
    run.coefficient_shown_ = step->coefficient;
  }
  if (run.outputs_.has(Output::kJson)) keep_corners(kept, *step, run.corners_);
  // A path that ended in the state of its last row adds no row.
  const bool row = step->kind == C2D_STEP_RECORDED || (step->kind == C2D_STEP_STOPPED && !again);
  if (row && run.outputs_.has(Output::kCsv)) append_contact_rows(run.outputs_.text(Output::kCsv), *step, run.summary_);
  if (row && run.outputs_.has(Output::kBodies))
    append_bodies_rows(run.outputs_.text(Output::kBodies), *step, run.session_.solver);
  if (step->kind == C2D_STEP_STOPPED) {
    c2d_summary now = C2D_INIT(c2d_summary);
    c2d_get_summary(run.session_.solver, &now);
    explain(kept, now, run.summary_, run.session_.messages.latest());
    run.session_.messages.forget_latest();
  }
  return run.outputs_.flush(run.error_) ? 0 : 1;
}

c2d_port Run::make_port() {
  c2d_port port = C2D_INIT(c2d_port);
  port.context = this;
  port.open = [](void* c, int32_t tape, uint64_t blocks, uint64_t bytes) { return self(c).store_.open(tape, blocks, bytes); };
  port.read = [](void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
    return self(c).store_.read(tape, block, data, bytes);
  };
  port.write = [](void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
    return self(c).store_.write(tape, block, data, bytes);
  };
  port.start_read = [](void* c, int32_t tape, uint64_t block, void* data, uint64_t bytes, int32_t* ticket) {
    return self(c).store_.start_read(tape, block, data, bytes, ticket);
  };
  port.start_write = [](void* c, int32_t tape, uint64_t block, const void* data, uint64_t bytes, int32_t* ticket) {
    return self(c).store_.start_write(tape, block, data, bytes, ticket);
  };
  port.wait = [](void* c, int32_t ticket) { return self(c).store_.wait(ticket); };
  port.sync = [](void* c, int32_t tape) { return self(c).store_.sync(tape); };
  port.close = [](void* c, int32_t tape) { return self(c).store_.close(tape); };
  port.progress = [](void* c, const c2d_progress* now) { self(c).line_.show(*now); };
  if (!line_.active()) port.progress = nullptr;
  port.cancel = [](void*) { return static_cast<int32_t>(interrupted()); };
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

int Run::library_failed(c2d_status status) {
  line_.clear();
  if (status == C2D_ERR_CALLBACK && !error_.empty()) return file_failed();
  if (restored_ && (status == C2D_ERR_STORE_READ || (status >= C2D_ERR_STORE_FORMAT && status <= C2D_ERR_STORE_STALE))) {
    fresh_start_ = true;
    return kExitFiles;
  }
  c2d_error last = C2D_INIT(c2d_error);
  if (session_.solver != nullptr) c2d_last_error(session_.solver, &last);
  const int exit = session_.failed(status);
  if (status >= C2D_ERR_STORE_OPEN && status <= C2D_ERR_STORE_CLOSE && last.host_code != 0)
    session_.messages.fail(store_.system_text(last.host_code));
  return exit;
}

// The deck, the workspace and the store; outputs are opened as soon as the deck is known to be in order.
int Run::read() {
  const double start = clock_seconds(nullptr);
  int exit = session_.read_file(options_.deck, {options_.settings, true, options_.memory, line_.active()}, options_.deck_name);
  record_.meshes = session_.meshes;
  if (exit == 0 && !options_.folder.empty() && !read_kept_meshes(options_.folder, record_.meshes, error_)) return file_failed();
  record_.read_seconds = clock_seconds(nullptr) - start;
  if (exit == 0) exit = read_points();
  if (exit == 0) exit = session_.take_memory(options_.memory);
  if (exit != 0) return exit;
  const uint64_t free = free_memory() / 2;
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
  if (options_.estimate && !record_.meshes.ran()) {
    estimate::Demand demand;
    demand.memory = options_.memory, demand.symmetry = options_.symmetry, demand.quadrature = options_.quadrature;
    record_.meshes = estimate::estimate_deck(session_.solver, session_.deck.text(), demand);
    if (!record_.meshes.stopped.empty()) session_.messages.note("no errors are stated: " + record_.meshes.stopped);
  }
  if (!interior_.take_sets(session_.solver, error_)) {
    session_.messages.fail(error_);
    return kExitInput;
  }
  if (!outputs_.open(options_, error_)) return file_failed();
  if (!store_.choose(options_.store, budget, options_.keep, error_)) return file_failed();
  if (store_.named_folder().empty() || options_.resume) return 0;
  return leave_restart(store_.named_folder(), options_, session_.deck.name(), session_.deck.text(), interior_.file_text(),
                       record_.meshes, session_.workspace.bytes, error_)
             ? 0
             : file_failed();
}

// Assemble and eliminate, or take what a run before has left; what is new is left for a run after this one.
c2d_status Run::factorise() {
  c2d_solver* solver = session_.solver;
  c2d_status status = C2D_OK;
  if (options_.resume) {
    status = c2d_restore(solver);
    restored_ = status == C2D_OK;
    if (restored_ || c2d_get_state(solver) == C2D_STATE_BROKEN) return status;
  }
  status = c2d_prepare(solver);
  return status == C2D_OK && !store_.named_folder().empty() ? c2d_save(solver) : status;
}

// Those of a file, once it is known how many bodies there are.
int Run::read_points() {
  if (!options_.points.empty())
    return interior_.read_file(options_.points, session_.limits.bodies) ? 0 : interrupted() ? kExitCancelled : kExitInput;
  if (options_.file(Output::kInterior).empty() || session_.limits.point_sets > 0) return 0;
  session_.messages.fail("--interior " + options_.file(Output::kInterior) +
                         ": there are no points, expected --points FILE or *POINTS in the deck");
  return kExitUsage;
}

void Run::begin_tables() {
  if (outputs_.has(Output::kCsv)) append_contact_header(outputs_.text(Output::kCsv));
  if (outputs_.has(Output::kBodies)) append_bodies_header(outputs_.text(Output::kBodies));
  if (outputs_.has(Output::kTrace)) append_trace_header(outputs_.text(Output::kTrace), summary_.load_cases);
  if (outputs_.has(Output::kBoundary)) append_boundary_header(outputs_.text(Output::kBoundary));
  if (outputs_.has(Output::kInterior)) append_interior_header(outputs_.text(Output::kInterior));
}

int Run::prepare() {
  c2d_solver* solver = session_.solver;
  get_summary(solver, summary_);
  c2d_options options = C2D_INIT(c2d_options);
  options.stepping = options_.stepping;
  options.quadrature = options_.quadrature;
  shows_changes_ = summary_.analysis >= C2D_ANALYSIS_ITERATIONS;
  options.every_change = shows_changes_ || has_pictures() || outputs_.has(Output::kTrace);
  history_.begin(summary_.steps);
  options.symmetry = options_.symmetry;
  c2d_status status = c2d_set_options(solver, &options);
  get_summary(solver, summary_);
  if (status == C2D_OK && outputs_.has(Output::kListing))
    status = append_model(outputs_.text(Output::kListing), solver, summary_, session_.deck.heading());
  ends_.resize(static_cast<size_t>(summary_.bodies));
  for (int32_t body = 1; body <= summary_.bodies && status == C2D_OK && summary_.pairs > 0; ++body)
    status = find_contact_ends(solver, summary_, body, ends_[static_cast<size_t>(body) - 1]);
  if (status == C2D_OK) status = find_crack_tips(solver, summary_, tips_);
  if (status == C2D_OK) status = find_zone_lines(solver, summary_, lines_);
  for (int32_t i = 1; i <= summary_.coefficients && status == C2D_OK; ++i) {
    record_.friction.push_back(0.0);
    status = c2d_get_friction(solver, 0, i, &record_.friction.back());
  }
  for (int32_t i = 1; i <= summary_.zones && status == C2D_OK; ++i) {
    c2d_zone zone = C2D_INIT(c2d_zone);
    status = c2d_get_zone(solver, i, &zone);
    record_.measure.push_back((zone.kind & C2D_ZONE_FREE) != 0 ? zone.side2.body
                                                               : zone.side1.body); // the first has nodes on side 2
  }
  if (status == C2D_OK && tells_corners()) status = find_corners(solver, summary_, corners_);
  begin_tables();
  if (status != C2D_OK) return library_failed(status);
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

// No equations to go on with: every coefficient has come to nothing.
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
  const c2d_status status = c2d_run(session_.solver, on_step, this);
  return status == C2D_OK ? 0 : library_failed(status);
}

// The end of the last coefficient that was followed.
void Run::show_contact_zone() {
  if (outputs_.has(Output::kListing) && !record_.coefficients.empty())
    append_contact_zone(outputs_.text(Output::kListing), record_.coefficients.back(), ends_.data(), summary_);
}

int Run::report() {
  const double start = clock_seconds(nullptr);
  c2d_solver* solver = session_.solver;
  const bool solved = c2d_get_state(solver) == C2D_STATE_RUNNING;
  get_summary(solver, summary_);
  record_.take_stated_errors();
  if (outputs_.has(Output::kSummary)) append_summary(outputs_.text(Output::kSummary), record_, summary_);
  c2d_status status = C2D_OK;
  if (outputs_.has(Output::kBoundary) && solved) status = append_boundary(outputs_.text(Output::kBoundary), solver, summary_);
  if (status == C2D_OK && outputs_.has(Output::kListing)) {
    std::string& out = outputs_.text(Output::kListing);
    show_contact_zone();
    const bool all = summary_.analysis == C2D_ANALYSIS_STRESS || summary_.analysis >= C2D_ANALYSIS_FULL;
    if (solved && all) status = append_global(out, solver, summary_);
  }
  if (status == C2D_OK && solved) status = corner_states(solver, summary_, corners_, record_.corners);
  record_.warnings = session_.messages.warnings();
  if (status == C2D_OK && solved && interior_.any()) status = show_interior();
  if (status == C2D_OK) status = show_pictures();
  if (status != C2D_OK) return library_failed(status);
  get_summary(solver, summary_);
  if (outputs_.has(Output::kListing)) append_ending(outputs_.text(Output::kListing), record_, summary_);
  record_.write_seconds = clock_seconds(nullptr) - start;
  if (outputs_.has(Output::kJson)) append_json(outputs_.text(Output::kJson), record_, summary_);
  return 0;
}

// What was asked for inside the bodies, at the load reached.
c2d_status Run::show_interior() {
  const c2d_status status = interior_.evaluate(session_.solver, summary_.bodies);
  if (status != C2D_OK) return status;
  record_.interior = &interior_.results();
  line_.clear();
  interior_.tell(session_.messages, summary_, record_.warnings);
  if (outputs_.has(Output::kInterior)) append_interior_rows(outputs_.text(Output::kInterior), interior_.results());
  if (outputs_.has(Output::kListing)) append_interior_section(outputs_.text(Output::kListing), interior_.results(), summary_);
  return C2D_OK;
}

// With the points asked for, or a grid over each body.
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
  c2d_status status = gather_scene(session_.solver, record_, history_, scene);
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
  set_interrupt_target(nullptr);
  const c2d_status status = c2d_close(session_.solver);
  session_.solver = nullptr;
  if (status == C2D_OK) return 0;
  session_.messages.fail(std::string("block store: ") + c2d_message(status));
  return kExitFiles;
}

int Run::publish() {
  if (interrupted()) return kExitCancelled;
  if (!outputs_.publish(error_)) return file_failed();
  if (!options_.keep && !store_.named_folder().empty() && !remove_restart(store_.named_folder(), error_)) return file_failed();
  if (!options_.keep && !store_.remove_tapes(error_)) return file_failed();
  if (options_.keep && !store_.folder().empty())
    std::fprintf(stderr, "contact2d: tapes are kept in %s\n", store_.folder().c_str());
  const CoefficientRecord* stopped = record_.incomplete();
  if (stopped == nullptr) return kExitSolved;
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
  if (exit == kExitCancelled) session_.messages.fail("cancelled");
  return exit;
}

} // namespace

int run_deck(const Options& options) {
  const std::string clash = find_clash(options);
  if (!clash.empty()) {
    std::fprintf(stderr, "contact2d: %s\n", clash.c_str());
    return kExitUsage;
  }
  {
    Run run(options);
    const int exit = run.go();
    if (!run.wants_fresh_start()) return exit;
  }
  std::fprintf(stderr, "contact2d: the tapes in %s are damaged, the run begins anew\n", options.folder.c_str());
  Options anew = options;
  anew.resume = false;
  Run run(anew);
  return run.go();
}

} // namespace app
