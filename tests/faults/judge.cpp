#include "judge.hpp"

#include <algorithm>

namespace faults {
namespace {

const char* const kKinds[FAULT_KINDS] = {"none",    "fails", "short",   "interrupted", "full",      "torn", "killed",
                                         "stopped", "half",  "flipped", "lost",        "no memory", "late"};
const char* const kOps[OP_KINDS] = {"open", "read",     "write",   "sync", "close", "rename", "unlink", "mkdir", "rmdir",
                                    "lock", "truncate", "reserve", "link", "mode",  "look",   "memory", "end"};

const char kFirst[] = "the run";

bool is_lie(int kind) { return kind == FAULT_HALF || kind == FAULT_FLIPPED || kind == FAULT_LOST || kind == FAULT_LATE; }
bool is_input(const std::string& path) { return is_below(path, "in") || path == "standard input"; }

bool in_store(const Job& job, const std::string& path) {
  return !job.store.empty() && is_below(path, job.store) && !(job.has_strangers && find(job.start, path) != nullptr);
}

// Files of the run's own and of others outside its store, each as before or as after; of them how many are as after.
struct Names {
  size_t old_ones = 0, new_ones = 0;
  std::string wrong, left_over;
};

bool is_new(const Job& job, const std::string& path) {
  const Entry *before = find(job.start, path), *after = find(job.finish, path);
  return after != nullptr && (before == nullptr || *before != *after);
}

Names look(const Job& job, const Tree& tree) {
  Names out;
  Tree all = job.start;
  all.insert(job.finish.begin(), job.finish.end());
  all.insert(tree.begin(), tree.end());
  for (const auto& [path, unused] : all) {
    static_cast<void>(unused);
    const Entry *before = find(job.start, path), *after = find(job.finish, path), *now = find(tree, path);
    if (in_store(job, path) || path == job.store) continue;
    if (is_aside(path) || (before == nullptr && after == nullptr)) {
      if (now == nullptr || (before != nullptr && *now == *before)) continue;
      if (out.left_over.empty() || is_aside(out.left_over)) out.left_over = path; // the worst of them
      continue;
    }
    const auto same = [now](const Entry* other) { return now ? other && *now == *other : !other; };
    if (!same(before) && !same(after)) {
      if (out.wrong.empty()) out.wrong = path + (now == nullptr ? " is gone" : " is neither what it was nor what it is to be");
      continue;
    }
    if (is_new(job, path) && (after->kind == 'f' || !same(after))) ++(same(after) ? out.new_ones : out.old_ones);
  }
  return out;
}

// Does the message name the file: as it is, a folder that it is in, or, of a file without its name yet, the output?
bool names_path(const Job& job, const std::string& text, const std::string& path) {
  const size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash);
  for (std::string part = path; !part.empty();
       part = part.rfind('/') == std::string::npos ? "" : part.substr(0, part.rfind('/')))
    if (text.find(part) != std::string::npos) return true;
  if (path.empty() && !job.store.empty() && text.find(job.store) != std::string::npos) return true; // the folder of all
  if (!path.empty() && !is_aside(path) && find(job.start, path) == nullptr && find(job.finish, path) == nullptr) return false;
  for (const auto& [other, entry] : job.finish)
    if ((entry.kind == 'f' || path.empty()) && is_new(job, other) && (folder.empty() || is_below(other, folder)) &&
        text.find(other) != std::string::npos)
      return true;
  return false;
}

} // namespace

bool Judge::fault(const std::string& text) {
  ++found_;
  if (!told_) ++tally_.faults;
  told_ = true;
  ++tally_.how_often[text];
  tally_.example.emplace(text, what_);
  return false;
}

bool Judge::is_whole(const Job& job, const Tree& tree, bool killed) {
  const Names names = look(job, tree);
  if (!names.wrong.empty()) return fault(names.wrong);
  if (!names.left_over.empty() && !(killed && (is_aside(names.left_over) || is_below(names.left_over, "tmp"))))
    return fault("left over: " + (is_aside(names.left_over) ? "a file aside" : names.left_over));
  return true;
}

void Judge::ends_well(const Job& job, const Ended& ended, const Tree& tree, bool leftovers, const std::string& what) {
  if (ended.status != 0) {
    fault(what + " ends with " + std::to_string(ended.status));
    return;
  }
  const Names names = look(job, tree);
  if (!names.wrong.empty()) fault(what + ": exit status 0, " + names.wrong);
  if (names.old_ones > 0) fault(what + ": exit status 0, " + std::to_string(names.old_ones) + " outputs are not there");
  const bool temporary = what != kFirst && is_below(names.left_over, "tmp"); // of one that was killed: nobody knows it
  if (!leftovers && !temporary && !names.left_over.empty())
    fault(what + ": exit status 0, left over: " + (is_aside(names.left_over) ? "a file aside" : names.left_over));
  for (const auto& [path, entry] : tree) {
    static_cast<void>(entry);
    const bool may_stay = path == job.store && what != kFirst; // nobody knows any more whose folder it is
    if (leftovers || job.keeps || may_stay || !in_store(job, path) || find(job.finish, path)) continue;
    fault(what + ": exit status 0, left over: " + path);
    break;
  }
}

void Judge::runs(const Job& job, const Tree& tree, bool leftovers) {
  put_tree(place_.work(), tree);
  const Ended ended = run(place_, job.command);
  ends_well(job, ended, take_tree(place_.work()), leftovers, "the second try");
}

void Judge::resumes_or_refuses(const Job& job, const Tree& tree, bool leftovers) {
  put_tree(place_.work(), tree);
  const Ended ended = run(place_, {{"resume", job.store}, "", 0, job.command.threads});
  const Tree after = take_tree(place_.work());
  const Names names = look(job, after);
  if (ended.status == 0 && job.has_earlier && names.new_ones == 0) { // nothing of this one was kept yet
    runs(job, after, leftovers);
    return;
  }
  if (ended.status == 0) {
    ends_well(job, ended, after, leftovers, "resume");
    return;
  }
  if (must_go_on_) fault("exit status 143, and resume refuses");
  if (ended.status != 2 && ended.status != 3) fault("resume ends with " + std::to_string(ended.status));
  if (ended.err.find(job.store) == std::string::npos) fault("resume refuses without a word on the folder");
  if (!names.wrong.empty()) fault("resume refuses, " + names.wrong);
  if (names.new_ones > 0 && names.old_ones > 0) fault("some outputs are there, some not, and resume refuses");
  if (job.resumes && names.new_ones == 0 && names.old_ones > 0) fault("a run that could be resumed is lost");
  if (!job.resumes) runs(job, after, leftovers);
}

void Judge::begins_or_goes_on(const Job& job, const Tree& tree, bool leftovers) {
  if (job.store.empty())
    runs(job, tree, leftovers);
  else
    resumes_or_refuses(job, tree, leftovers);
}

void Judge::second_try(const Job& job, const Tree& tree, bool leftovers) {
  const std::pair<std::string, size_t> state = {job.name, hash_of(tree) + 2 * must_go_on_ + leftovers};
  if (went_well_.count(state) != 0) return;
  const uint64_t before = found_;
  begins_or_goes_on(job, tree, leftovers);
  if (before == found_) went_well_.insert(state);
}

void Judge::failed(const Job& job, const Strike& strike, const Ended& ended, const Tree& tree) {
  const Record* struck = ended.struck();
  const std::string op = struck == nullptr ? "?"
                                           : std::string(kOps[struck->op]) + " " +
                                                 (in_store(job, struck->path) ? "in the store"
                                                  : is_input(struck->path)    ? "of an input"
                                                  : is_aside(struck->path)    ? "aside"
                                                                              : "elsewhere");
  must_go_on_ = ended.status == 143;
  if (ended.status > 128 && ended.status != 130 && !must_go_on_)
    fault("dies of signal " + std::to_string(ended.status - 128) + ": " + op);
  if (strike.kind == FAULT_INTERRUPTED || strike.kind == FAULT_SHORT)
    fault(std::string(kKinds[strike.kind]) + " is no failure, " + op + ": exit status " + std::to_string(ended.status));
  if (ended.err.empty()) fault("fails without a word: " + op);
  if (strike.kind == FAULT_MEMORY) {
    if (ended.status != 4) fault("no memory: exit status " + std::to_string(ended.status));
  } else if (strike.kind == FAULT_STOPPED) {
    if (ended.status != 130 && ended.status != 143) fault("stopped: exit status " + std::to_string(ended.status));
  } else if (struck != nullptr) {
    const bool may_be_2 = std::any_of(ended.journal.begin(), ended.journal.end(), [&job](const Record& r) {
      return r.struck != 0 && (is_input(r.path) || (job.resumes && in_store(job, r.path)));
    });
    if (ended.status != 3 && !(may_be_2 && ended.status == 2)) fault("exit status " + std::to_string(ended.status) + ": " + op);
    const bool named = std::any_of(ended.journal.begin(), ended.journal.end(),
                                   [&](const Record& r) { return r.struck != 0 && names_path(job, ended.err, r.path); });
    if (!named) fault("the message names no file: " + op);
  }
  const Names names = look(job, tree);
  if (!names.wrong.empty()) fault("exit status " + std::to_string(ended.status) + ", " + names.wrong);
  const bool stays = strike.ever || (struck != nullptr && (struck->op == OP_UNLINK || struck->op == OP_RMDIR));
  if (!names.left_over.empty() && !stays)
    fault("fails and leaves " + (is_aside(names.left_over) ? "a file aside" : names.left_over));
}

void Judge::strike(const Job& job, const Strike& strike) {
  ++tally_.cases;
  told_ = false;
  what_ = job.name + ", " + kKinds[strike.kind] + " at " + std::to_string(strike.at) + (strike.ever ? " and ever after" : "");
  put_tree(place_.work(), job.start);
  const Ended ended = run(place_, job.command, strike);
  const Tree tree = take_tree(place_.work());
  const Record* struck = ended.struck();
  if (struck != nullptr) what_ += std::string(", ") + kOps[struck->op] + " " + struck->path;
  if (const size_t error = ended.err.rfind("error: "); error != std::string::npos)
    what_ += "; " + ended.err.substr(error, ended.err.find('\n', error) - error);
  ++tally_.kinds[std::string(kKinds[strike.kind]) + (struck != nullptr ? std::string(" ") + kOps[struck->op] : "") +
                 (strike.ever ? ", ever after" : "")];
  const bool removal = struck != nullptr && (struck->op == OP_UNLINK || struck->op == OP_RMDIR);
  const bool leaves = removal || (strike.ever && strike.kind == FAULT_FAIL);
  if (ended.status != 0) {
    failed(job, strike, ended, tree);
    second_try(job, tree, leaves);
    return;
  }
  must_go_on_ = false;
  ends_well(job, ended, tree, leaves, kFirst);
  if (ended.out != job.ended.out) fault("exit status 0, standard output is not what it is to be");
  if (job.keeps && is_lie(strike.kind)) resumes_or_refuses(job, tree, false);
}

void Judge::again(const std::string& kind) {
  ++tally_.cases;
  ++tally_.kinds[kind];
}

void Judge::crash(const Job& job, const Tree& left, bool done, const std::string& kind, const std::string& what) {
  again(kind);
  must_go_on_ = false;
  told_ = false;
  what_ = job.name + ", " + what;
  if (!is_whole(job, left, true)) return;
  const Names names = look(job, left);
  if (done && names.old_ones > 0) fault("after exit status 0 outputs are not there");
  if (!done || (job.keeps && !job.resumes)) second_try(job, left, false);
}

} // namespace faults
