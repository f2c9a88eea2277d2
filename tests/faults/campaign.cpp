#include "campaign.hpp"

#include "disk.hpp"

#include <set>

namespace faults {
namespace {

// Cases are counted over all jobs, so that a thin sample is not the first operation of each.
class Sieve {
public:
  explicit Sieve(uint64_t step) : step_(step) {}
  bool takes() { return count_++ % step_ == 0; }

private:
  uint64_t step_;
  static inline uint64_t count_ = 0;
};

bool can_suffer(int op, int kind) {
  switch (kind) {
  case FAULT_SHORT: return op == OP_READ || op == OP_WRITE;
  case FAULT_INTERRUPTED: return op <= OP_CLOSE || op == OP_LOCK || op == OP_TRUNCATE || op == OP_RESERVE;
  case FAULT_FULL:
    return op == OP_OPEN || op == OP_WRITE || op == OP_SYNC || op == OP_RENAME || op == OP_MKDIR || op == OP_RESERVE;
  case FAULT_TORN:
  case FAULT_HALF:
  case FAULT_LATE:
  case FAULT_LOST: return op == OP_WRITE;
  case FAULT_FLIPPED: return op == OP_READ || op == OP_WRITE;
  default: return true;
  }
}

Tree tree_after(const Place& place, const Tree& start, const Command& command, const Strike& strike, Ended* told = nullptr) {
  put_tree(place.work(), start);
  Ended ended = run(place, command, strike);
  if (told != nullptr) *told = std::move(ended);
  return take_tree(place.work());
}

} // namespace

bool can_strike(const Record& r, int kind, bool ever) {
  if (!can_suffer(r.op, kind) || (kind == FAULT_STOPPED && ever)) return false;
  return kind != FAULT_FULL || r.op != OP_OPEN || (r.flags & OPENED_CREATES) != 0;
}

void fail_operations(const Place& place, const Job& job, uint64_t step, Tally& tally) {
  Judge judge(place, tally);
  Sieve sieve(step);
  for (const int kind : {FAULT_FAIL, FAULT_SHORT, FAULT_INTERRUPTED, FAULT_FULL, FAULT_STOPPED})
    for (const Record& r : job.ended.journal)
      for (const bool ever : {false, true})
        if (can_strike(r, kind, ever) && sieve.takes()) judge.strike(job, {kind, r.number, ever, ""});
}

// Only of what the program keeps for itself: nobody can tell what is in a user's file.
void lie(const Place& place, const Job& job, uint64_t step, Tally& tally) {
  if (job.store.empty()) return;
  Judge judge(place, tally);
  Sieve sieve(step);
  for (const int kind : {FAULT_HALF, FAULT_FLIPPED, FAULT_LOST, FAULT_LATE})
    for (const Record& r : job.ended.journal)
      for (const bool ever : {false, true}) {
        const bool own = is_below(r.path, job.store);
        if (own && can_suffer(r.op, kind) && sieve.takes()) judge.strike(job, {kind, r.number, ever, "/" + job.store + "/"});
      }
}

void kill_at_operations(const Place& place, const Job& job, uint64_t step, Tally& tally) {
  Judge judge(place, tally);
  Sieve sieve(step);
  std::set<size_t> seen; // states of the folder that were judged
  const auto is_new = [&seen](const Tree& tree) { return seen.insert(hash_of(tree)).second; };
  const Command again = job.store.empty() ? job.command : Command{{"resume", job.store}, "", 0, job.command.threads};
  for (const int kind : {FAULT_KILLED, FAULT_TORN})
    for (const Record& r : job.ended.journal) {
      if (!can_suffer(r.op, kind) || !sieve.takes()) continue;
      const std::string name = kind == FAULT_TORN ? "torn and killed" : "killed";
      const std::string what = name + " at " + std::to_string(r.number);
      const Tree left = tree_after(place, job.start, job.command, {kind, r.number, false, ""});
      if (!is_new(left)) {
        judge.again(name);
        continue;
      }
      judge.crash(job, left, false, name, what + " " + r.path);
      if (job.store.empty()) continue;
      Ended resumed;
      tree_after(place, left, again, {}, &resumed);
      for (const Record& second : resumed.journal) {
        if (!sieve.takes()) continue;
        const Tree twice = tree_after(place, left, again, {FAULT_KILLED, second.number, false, ""});
        const std::string both = name + ", and the resume killed";
        if (is_new(twice))
          judge.crash(job, twice, false, both, what + ", the resume at " + std::to_string(second.number) + " " + second.path);
        else
          judge.again(both);
      }
    }
}

void lose_power(const Place& place, const Job& job, uint64_t step, Tally& tally) {
  Judge judge(place, tally);
  Sieve sieve(step);
  std::set<size_t> seen;
  Disk disk(job.start);
  struct Policy {
    Loss loss;
    uint32_t seed;
    const char* name;
  };
  const Policy policies[] = {{Loss::kNothing, 0, "nothing lost"},
                             {Loss::kAllUnsynced, 0, "all lost that was not synced"},
                             {Loss::kData, 0, "bytes lost"},
                             {Loss::kZeros, 0, "zeros"},
                             {Loss::kHalf, 0, "half of the bytes"},
                             {Loss::kEarlyNames, 0, "the last names first"},
                             {Loss::kLateNames, 0, "the last name lost"},
                             {Loss::kNewestEmpty, 0, "the last names first, bytes lost"},
                             {Loss::kRandom, 1, "any"},
                             {Loss::kRandom, 2, "any"},
                             {Loss::kRandom, 3, "any"}};
  const std::vector<Record>& journal = job.ended.journal;
  for (size_t i = 0; i < journal.size(); ++i) {
    const bool done = i + 1 == journal.size();
    if (!disk.apply(journal[i]) && !done) continue;
    for (const Policy& p : policies) {
      if (!sieve.takes()) continue;
      const Tree left = disk.after_crash(p.loss, p.seed + static_cast<uint32_t>(4 * i));
      if (seen.insert(hash_of(left) + done).second)
        judge.crash(job, left, done, p.name,
                    "power lost after " + std::to_string(journal[i].number) + " " + journal[i].path + ": " + p.name);
      else
        judge.again(p.name);
    }
  }
  if (disk.is_wrong()) {
    ++tally.faults;
    ++tally.how_often["the model of the disk does not follow: " + job.name];
  }
}

void refuse_memory(const Place& place, const Job& job, uint64_t step, Tally& tally) {
  Judge judge(place, tally);
  Sieve sieve(step);
  for (const uint64_t n : job.ended.places)
    for (const bool ever : {false, true})
      if (sieve.takes()) judge.strike(job, {FAULT_MEMORY, n, ever, ""});
}

} // namespace faults
