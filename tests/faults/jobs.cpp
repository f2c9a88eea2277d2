#include "jobs.hpp"

namespace faults {
namespace {

using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Small, so that a run takes milliseconds; panels of the least workspace, so that there are many blocks.
const Words kMake = {"make", "hertz", "n=2", "L=5", "ratio=1.6"};
const Words kSmall = {"--memory", "64K", "--no-progress"};
const Words kTables = {"--csv", "out/a.csv", "--json", "out/a.json", "--listing", "out/a.lst", "--boundary", "out/b.csv"};
const Words kAll = {"--bodies",  "out/bodies.csv", "--trace",    "out/t.csv",  "--summary",  "out/s.csv", "--points",
                    "in/p.csv",  "--interior",     "out/i.csv",  "--report",   "out/r.html", "--vtk",     "out/v.vtk",
                    "--figures", "figures",        "--stresses", "out/st.csv", "--ranges",   "out/ra.csv"};
const char kPoints[] = "1,0.2,-0.5\n1,0.5,-1.5\n2,0.1,1.5\n";

class Workshop {
public:
  Workshop(const Place& place, std::string& error) : place_(place), error_(error) {
    deck_ = output_of({kMake, "", 0, false});
    other_ = output_of({{"make", "hertz", "n=3", "L=5", "ratio=1.6"}, "", 0, false});
    path_ = deck_;
    replace(path_, "\n1 0\n", "\n2 0 0.3\n");       // coefficients of friction
    replace(path_, "\n*PATH\n1 1", "\n*PATH\n2 1"); // increments
  }

  Tree inputs() const {
    Tree tree;
    add_file(tree, "in/deck.dat", deck_);
    add_file(tree, "in/p.csv", kPoints);
    add_file(tree, "in/path.dat", path_);
    add_file(tree, "out/of others", "not ours\n");
    tree["tmp"].kind = 'd';
    return tree;
  }
  Tree inputs_and_outputs() const {
    Tree tree = inputs();
    for (const char* name : {"out/a.csv", "out/a.json", "out/a.lst", "out/b.csv", "out/i.csv", "out/r.html"})
      add_file(tree, name, std::string("what was in ") + name + " before\n");
    tree["out/link"] = {'l', "linked.csv"};
    add_file(tree, "out/linked.csv", "before\n");
    return tree;
  }
  // A folder that others use for files that bear names which a store might use.
  static void add_strangers(Tree& tree) {
    for (const char* name : {"deck.dat", "options", "points.csv", "meshes", "tape0.c2d", "tape3.c2d", "lock", "job", "notes"})
      add_file(tree, std::string("tapes/") + name, std::string("a stranger's ") + name + "\n");
  }

  void add(const std::string& name, const Tree& start, const Command& command, const std::string& store = "",
           bool keeps = false, bool resumes = false) {
    Job job;
    job.name = name;
    job.start = start, job.command = command, job.store = store, job.keeps = keeps, job.resumes = resumes;
    job.has_strangers = find(start, "tapes/notes") != nullptr;
    put_tree(place_.work(), start);
    job.ended = run(place_, command, {}, true);
    job.finish = take_tree(place_.work());
    if (job.ended.status != 0)
      fail(name + ": exit status " + std::to_string(job.ended.status) + " without a fault: " + job.ended.err);
    jobs.push_back(std::move(job));
  }
  // The folder after a run that was killed before the last operation on a path with `part` in it.
  Tree killed(const Tree& start, const Command& command, int op, const std::string& part) {
    put_tree(place_.work(), start);
    uint64_t last = 0;
    for (const Record& r : run(place_, command).journal)
      if (r.op == op && (r.path.find(part) != std::string::npos || r.path2.find(part) != std::string::npos)) last = r.number;
    put_tree(place_.work(), start);
    if (last == 0 || run(place_, command, {FAULT_KILLED, last, false, ""}).status != 128 + 9)
      fail("no run was killed at " + part);
    return take_tree(place_.work());
  }
  Tree after(const Tree& start, const Command& command) {
    put_tree(place_.work(), start);
    const Ended ended = run(place_, command);
    if (ended.status != 0) fail("a run for a job failed: " + ended.err);
    return take_tree(place_.work());
  }
  std::string other_deck() const { return other_; }

  std::vector<Job> jobs;

private:
  std::string output_of(const Command& command) {
    put_tree(place_.work(), {});
    const Ended ended = run(place_, command);
    if (ended.status != 0) fail("make: " + ended.err);
    return ended.out;
  }
  void fail(const std::string& text) {
    if (error_.empty()) error_ = text;
  }
  void replace(std::string& text, const std::string& from, const std::string& to) {
    const size_t at = text.find(from);
    if (at == std::string::npos) return fail("the deck has no " + from);
    text.replace(at, from.size(), to);
  }
  const Place& place_;
  std::string& error_;
  std::string deck_, other_, path_;
};

// The biggest tape of a kept run, with one bit changed.
Tree with_damage(Tree tree) {
  Entry* largest = nullptr;
  for (auto& [path, entry] : tree)
    if (path.find("tape") != std::string::npos && entry.kind == 'f' && (!largest || entry.bytes.size() > largest->bytes.size()))
      largest = &entry;
  if (largest != nullptr && !largest->bytes.empty()) largest->bytes[largest->bytes.size() / 2] ^= 4;
  return tree;
}

// Outputs as if the kept run had written others before.
Tree with_old_outputs(Tree tree) {
  for (auto& [path, entry] : tree)
    if (is_below(path, "out") && entry.kind == 'f' && path != "out/of others") entry.bytes = "before\n";
  return tree;
}

} // namespace

std::vector<Job> make_jobs(const Place& place, std::string& error) {
  Workshop w(place, error);
  const Words run_deck = Words{"run", "in/deck.dat"} + kSmall, in_files = {"--store", "file:tapes"}, keep = {"--keep"};
  const Words some = {"--csv", "out/a.csv", "--json", "out/a.json"}, resume = {"resume", "tapes"};
  w.add("listing", w.inputs(), {run_deck, "", 0, false});
  w.add("outputs", w.inputs_and_outputs(), {run_deck + kTables + kAll, "", 0, false});
  w.add("link", w.inputs_and_outputs(), {run_deck + Words{"--csv", "out/link"}, "", 0, false});
  w.add("store", w.inputs(), {run_deck + in_files + kTables, "", 0, false}, "tapes");
  w.add("store and outputs", w.inputs_and_outputs(), {run_deck + in_files + kTables + kAll, "", 0, false}, "tapes");
  Tree strangers = w.inputs_and_outputs();
  w.add_strangers(strangers);
  w.add("keep", strangers, {run_deck + in_files + keep + some, "", 0, false}, "tapes", true);
  w.add("standard input", w.inputs(), {Words{"run", "-"} + kSmall + in_files + some, "in/deck.dat", 0, false}, "tapes");
  Command temporary = {run_deck + some, "", 100000, false};
  temporary.words[3] = "60K";
  w.add("temporary", w.inputs(), temporary);
  const Words follow = Words{"run", "in/path.dat"} + kSmall + in_files + Words{"--save-every", "0"};
  w.add("path", w.inputs(), {follow + some, "", 0, false}, "tapes");
  w.add("threads", w.inputs(), {run_deck + in_files + some + Words{"--threads", "2"}, "", 0, true}, "tapes");

  const Command kept = {run_deck + in_files + keep + kTables, "", 0, false};
  const Tree after = w.after(w.inputs(), kept);
  w.add("resume what was kept", with_old_outputs(after), {resume, "", 0, false}, "tapes", true, true);
  w.add("resume what is damaged", with_damage(with_old_outputs(after)), {resume, "", 0, false}, "tapes", true, true);
  const Command lost = {run_deck + in_files + kTables + kAll, "", 0, false};
  const Tree killed = w.killed(w.inputs_and_outputs(), lost, OP_RENAME, "out/");
  w.add("resume what was killed", killed, {resume, "", 0, false}, "tapes", false, true);
  const Tree cut =
      w.killed(w.inputs_and_outputs(), {follow + kTables + kAll, "", 0, false}, OP_RENAME, "tapes/contact2d.store/path");
  w.add("resume within the path", cut, {resume, "", 0, false}, "tapes", false, true);
  Tree again = after;
  add_file(again, "in/deck.dat", w.other_deck());
  w.add("again", again, {run_deck + in_files + Words{"--csv", "out/other.csv", "--boundary", "out/b.csv"}, "", 0, false},
        "tapes");
  w.jobs.back().has_earlier = true;
  w.add("convert", w.inputs_and_outputs(), {{"convert", "in/deck.dat", "--to", "free", "-o", "out/a.csv"}, "", 0, false});
  return std::move(w.jobs);
}

} // namespace faults
