#pragma once
// Runs that end at one of their steps, where they were saved, and go on in another solver with other memory: every number and
// every message is that of a run that nothing ended.
#include "many_bodies.hpp"
#include "problem.hpp"
#include "solver_runs.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace interrupted {

struct Job {
  std::vector<c2d_body_limits> bodies; // of the limits
  c2d_limits limits = C2D_INIT(c2d_limits);
  c2d_options options = C2D_INIT(c2d_options);
  std::function<c2d_status(c2d_solver*)> feed; // the model
  bool in_core = true;
  uint64_t bytes = 0; // of workspace, if that is more
};

inline Job job_of(const many::Model& model) {
  Job job;
  job.limits = many::limits_of(model, job.bodies);
  job.options.elimination = model.elimination;
  job.feed = [model](c2d_solver* s) { return many::feed(s, model); };
  return job;
}
inline Job job_of(const std::string& deck_text) {
  Job job;
  runs::Deck deck;
  for (size_t at = 0, end = 0; at < deck_text.size(); at = end + 1) {
    end = std::min(deck_text.find('\n', at), deck_text.size());
    deck.lines.push_back(deck_text.substr(at, end - at));
  }
  runs::Deck cards = deck;
  job.bodies.resize(64);
  job.limits.bodies = 64, job.limits.body = job.bodies.data();
  if (c2d_scan_deck(runs::Deck::read, &cards, &job.limits, nullptr) != C2D_OK) job.limits.bodies = -1;
  job.feed = [deck](c2d_solver* s) { return runs::read_deck(s, deck); };
  return job;
}

// The same with a coefficient of friction before the model's own.
inline Job also_with(double mu, Job job) {
  const std::function<c2d_status(c2d_solver*)> model = job.feed;
  job.limits.coefficients = 2;
  job.feed = [mu, model](c2d_solver* s) {
    const c2d_status status = c2d_add_friction(s, mu);
    return status == C2D_OK ? model(s) : status;
  };
  return job;
}

// What a run shows: the bytes of each step and of all results at the end, and what it tells from its preparation on.
struct Story {
  c2d_status status = C2D_OK;
  std::vector<std::string> steps, told;
  std::string end;
};

// The store, and what was told, as they were when a step was saved.
struct Saved {
  runs::RamStore store;
  size_t told = 0, step = 0; // from 0
};

template <class T> void add_bytes(std::string& out, const T* from, int64_t count = 1) {
  if (count > 0) out.append(reinterpret_cast<const char*>(from), static_cast<size_t>(count) * sizeof(T));
}

// A solver that is fed with the job's model, on a store that may hold something.
class Life {
public:
  Life(const Job& job, runs::RamStore& store) {
    c2d_limits limits = job.limits;
    limits.body = const_cast<c2d_body_limits*>(job.bodies.data());
    c2d_port inner = C2D_INIT(c2d_port);
    store.serve(inner);
    store_ = inner;
    c2d_port port = C2D_INIT(c2d_port);
    port.context = this;
    port.open = [](void* c, int32_t t, uint64_t n, uint64_t size) { return with(c).open(with(c).context, t, n, size); };
    port.read = [](void* c, int32_t t, uint64_t k, void* d, uint64_t n) { return with(c).read(with(c).context, t, k, d, n); };
    port.write = [](void* c, int32_t t, uint64_t k, const void* d, uint64_t n) {
      return with(c).write(with(c).context, t, k, d, n);
    };
    port.sync = [](void* c, int32_t t) { return with(c).sync(with(c).context, t); };
    port.close = [](void* c, int32_t t) { return with(c).close(with(c).context, t); };
    port.log = [](void* c, const c2d_error* e) {
      static_cast<Life*>(c)->story.told.push_back(std::to_string(e->status) + " " + e->text);
    };
    uint64_t minimum = 0, in_core = 0;
    story.status = c2d_memory_need(&limits, &minimum, &in_core, nullptr);
    if (story.status != C2D_OK) return;
    machine_ =
        std::make_unique<runs::Machine>(limits, std::max(job.bytes, job.in_core ? std::max(minimum, in_core) : minimum), &port);
    story.status = machine_->created;
    if (story.status == C2D_OK) story.status = c2d_set_options(machine_->solver, &job.options);
    if (story.status == C2D_OK) story.status = job.feed(machine_->solver);
    if (story.status == C2D_OK) story.told.clear();
  }
  // Saves at every step; what there is then at steps `at` is kept.
  void run_and_save(const std::vector<size_t>& at, std::vector<Saved>& saved, const runs::RamStore& store) {
    at_ = &at, saved_ = &saved, kept_ = &store;
    run();
  }
  void run() {
    if (story.status == C2D_OK) story.status = c2d_run(solver(), see, this);
    if (story.status == C2D_OK) look();
  }
  c2d_solver* solver() const { return machine_->solver; }
  Story story;

private:
  static const c2d_port& with(void* life) { return static_cast<Life*>(life)->store_; }
  static int32_t see(void* context, const c2d_step* now) {
    Life& life = *static_cast<Life*>(context);
    std::string bytes;
    const double numbers[] = {now->mu, now->load, now->work, now->dissipated, now->elastic, now->energy_defect};
    const int32_t counts[] = {now->kind, now->coefficient, now->step, now->changes, now->iterations, now->outcome};
    add_bytes(bytes, numbers, 6);
    add_bytes(bytes, counts, 6);
    add_bytes(bytes, now->loads, now->cases);
    add_bytes(bytes, now->work_by_case, now->cases);
    for (int32_t p = 0; p < now->pairs; ++p) add_bytes(bytes, now->table + p * now->stride, C2D_PAIR_FIELDS);
    life.add_states(bytes);
    life.story.steps.push_back(bytes);
    if (!life.saved_) return 0;
    if (c2d_save(life.solver()) != C2D_OK) return 1;
    const size_t step = life.story.steps.size() - 1;
    if (std::find(life.at_->begin(), life.at_->end(), step) != life.at_->end())
      life.saved_->push_back({*life.kept_, life.story.told.size(), step});
    return 0;
  }
  void add_states(std::string& out) const {
    c2d_summary summary = C2D_INIT(c2d_summary);
    c2d_get_summary(solver(), &summary);
    for (int32_t i = 1; i <= summary.zones; ++i) {
      c2d_zone_state state = C2D_INIT(c2d_zone_state);
      if (c2d_get_zone_state(solver(), i, &state) == C2D_OK) add_bytes(out, &state);
    }
    for (int32_t b = 1; b <= summary.bodies; ++b) {
      c2d_body_state state = C2D_INIT(c2d_body_state);
      if (c2d_get_body_state(solver(), b, &state) == C2D_OK) add_bytes(out, &state);
    }
  }
  void look() {
    c2d_summary summary = C2D_INIT(c2d_summary);
    c2d_get_summary(solver(), &summary);
    for (int32_t b = 1; b <= summary.bodies; ++b) {
      c2d_body_result body = C2D_INIT(c2d_body_result);
      const c2d_status status = c2d_get_body_result(solver(), b, &body);
      add_bytes(story.end, &status);
      add_bytes(story.end, &body);
      const int32_t count = body.elements * summary.function_nodes;
      std::vector<double> values(static_cast<size_t>(count));
      for (int32_t field = C2D_END_X; field <= C2D_END_HOOP; ++field)
        if (c2d_get(solver(), field, b, 1, count, values.data(), 1) == C2D_OK) add_bytes(story.end, values.data(), count);
    }
    add_states(story.end);
    c2d_get_summary(solver(), &summary);
    for (double& seconds : summary.seconds) seconds = 0;
    summary.peak_bytes = 0; // of another process; tape 0 holds the saved states
    summary.tape_blocks[0] = summary.tape_bytes_written[0] = summary.tape_bytes_read[0] = summary.tape_writes[0] =
        summary.tape_reads[0] = 0;
    add_bytes(story.end, &summary);
  }

  c2d_port store_ = C2D_INIT(c2d_port);
  std::unique_ptr<runs::Machine> machine_;
  std::vector<Saved>* saved_ = nullptr;
  const runs::RamStore* kept_ = nullptr;
  const std::vector<size_t>* at_ = nullptr;
};

// How two runs differ, the second from step `first` on; empty: they do not.
inline std::string difference(const Story& whole, const Story& part, size_t first, size_t told) {
  if (whole.status != part.status) return "status " + std::to_string(part.status);
  if (whole.steps.size() - first != part.steps.size()) return std::to_string(part.steps.size()) + " steps";
  for (size_t i = 0; i < part.steps.size(); ++i)
    if (whole.steps[first + i] != part.steps[i]) return "step " + std::to_string(first + i + 1);
  if (whole.end != part.end) return "results at the end";
  std::string a, b;
  for (size_t i = told; i < whole.told.size(); ++i) a += whole.told[i] + "\n";
  for (const std::string& line : part.told) b += line + "\n";
  return a == b ? "" : "messages:\n" + b + "instead of\n" + a;
}

struct Verdict {
  size_t steps = 0, places = 0;
  c2d_status status = C2D_OK; // of the whole run
  std::string difference;     // empty: none
  std::string messages;       // of the whole run, and of a model that is refused
};

// Ended at up to `places` of its steps, the first and the last among them.
inline Verdict end_and_resume(const Job& job, size_t places = 4) {
  Verdict out;
  const auto prepare = [](Life& life) {
    if (life.story.status == C2D_OK) life.story.status = c2d_prepare(life.solver());
  };
  runs::RamStore own, other;
  Life plain(job, own), saving(job, other);
  prepare(plain);
  plain.run();
  out.status = plain.story.status;
  out.steps = plain.story.steps.size();
  for (const std::string& line : plain.story.told) out.messages += line + "\n";
  std::vector<size_t> at;
  for (size_t k = 0, n = std::min(places, out.steps); k < n; ++k) at.push_back(n < 2 ? 0 : k * (out.steps - 1) / (n - 1));
  std::vector<Saved> saved;
  prepare(saving);
  saving.run_and_save(at, saved, other);
  out.difference = difference(plain.story, saving.story, 0, 0);
  if (!out.difference.empty()) out.difference = "saved at every step: " + out.difference;
  for (size_t k = 0; k < saved.size() && out.difference.empty(); ++k) {
    Life life(job, saved[k].store);
    if (life.story.status == C2D_OK) life.story.status = c2d_restore(life.solver());
    for (const std::string& line : life.story.told) // what is wrong with the model is told in every process
      if (std::find(plain.story.told.begin(), plain.story.told.end(), line) == plain.story.told.end())
        out.difference = "restored: " + line;
    life.story.told.clear();
    life.run();
    ++out.places;
    if (out.difference.empty()) out.difference = difference(plain.story, life.story, saved[k].step + 1, saved[k].told);
    if (!out.difference.empty()) out.difference = "ended at step " + std::to_string(saved[k].step + 1) + ": " + out.difference;
  }
  return out;
}

} // namespace interrupted
