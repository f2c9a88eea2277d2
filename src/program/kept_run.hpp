// What is stored of a run with --store file:DIR, so that `resume` can continue it: its job, and states of its load path with
// the record of the steps so far.
#pragma once

#include "program/commands/job.hpp"
#include "program/files/store_choice.hpp"
#include "program/outputs/outputs.hpp"
#include "program/outputs/results.hpp"

#include <string>
#include <vector>

namespace app {

class KeptRun {
public:
  KeptRun(const Options& options, StoreChoice& store) : options_(options), store_(store) {}

  // Stores the job; the folder of the store is locked. From here on an interrupted run can be resumed. False with an error
  // text.
  bool keep(JobForm form, const RunResults& run, const std::vector<NamedText>& files, std::string& error);
  bool is_kept() const { return kept_; }
  std::string id() const { return id_of(job_); }
  // Removes the job of a run that failed, because of its input, before it had a deck: it cannot be resumed.
  void drop_sketch();
  // The run is complete: removes what was stored. False with an error text.
  bool remove(std::string& error) const;

  bool saves_states() const { return kept_ && job_.form != JobForm::kSketch; }
  // Starts the interval of --save-every. At most 1/60 of the time is spent on saving, unless that is 0.
  void begin_path(const c2d_summary& now);
  // Saves a step of the path, if the interval is over or `at_once`: the record first, then the solver. After a crash at any
  // moment one of the last two states is complete with its record. False with an error text.
  bool save(const c2d_step& step, bool at_once, RunResults& run, Outputs& outputs, std::string& error);
  // Restores the record of the steps up to the state that the solver has restored. Without it, C2D_ERR_MISMATCH with the
  // reason, that state cannot be used.
  c2d_status restore(RunResults& run, Outputs& outputs, std::string& why);
  // Reports that the solver could not restore a state: the run restarts.
  void report_unusable(c2d_status status, const Messages& messages) const;
  // The last step with a saved state; empty: none.
  const std::string& saved() const { return saved_; }

private:
  bool claim(std::string& error);
  std::string path_of(int slot) const { return store_.kept_folder() + (slot == 0 ? "/path0" : "/path1"); }
  std::string heading(int32_t coefficient, int32_t step, int32_t cycles) const;
  bool write_state(const c2d_step& step, RunResults& run, std::string& error);
  bool find_record(const c2d_summary& now, int32_t cycles, std::string& record, std::string& why);

  const Options& options_;
  StoreChoice& store_;
  Job job_; // as stored, if stored
  bool kept_ = false;
  double next_ = 0; // when the next state is saved, by clock_seconds
  int slot_ = 0;    // that of the older record
  std::string saved_;
};

} // namespace app
