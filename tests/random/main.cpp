// make random N=...: many random decks, in a process that may crash or hang without ending the others.
//   run_random COUNT FIRST_SEED FOLDER [any|few|lift|mirror|three|punch]
// Prints a line per finding and one per deck that could not be decided, then totals; exit status 1 if there was a finding.
#include "judge.hpp"
#include "spence.hpp"
#include "three_bodies.hpp"

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <map>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

using namespace random_decks;

namespace {

constexpr unsigned kPatience = 300; // seconds for one deck in all its forms

struct Tally {
  std::map<std::string, int> outcomes, findings;
  int decks = 0, wrong = 0;
};

std::string number(uint64_t seed) { return std::to_string(static_cast<unsigned long long>(seed)); }

std::string outcome_of(const Verdict& v) {
  return v.status == C2D_ERR_INPUT ? "refused" : v.status != C2D_OK ? "failed" : c2d_outcome_message(v.outcome);
}

// What is told to the parent: lines of a word and the rest.
void say(FILE* out, const char* word, std::string rest) {
  for (char& c : rest)
    if (c == '\n') c = ' ';
  std::fprintf(out, "%s %s\n", word, rest.c_str());
  std::fflush(out);
}

void judge_one(Kind kind, uint64_t seed, const std::string& folder, FILE* out) {
  alarm(kPatience);
  say(out, "begin", number(seed));
  Verdict v;
  try {
    v = kind == Kind::three ? judge_three(seed) : judge(kind, seed);
  } catch (const std::exception& e) {
    v.findings.push_back(std::string("the judge stopped: ") + e.what());
  }
  say(out, "count", "decks: " + outcome_of(v));
  if (v.tried) say(out, "count", "all statuses tried");
  if (v.not_unique) say(out, "count", "said to be not unique");
  if (v.not_unique && v.unlike_its_image) say(out, "count", "not unique, and not symmetric");
  if (v.undefined_place) say(out, "count", "said to have an undefined place");
  if (v.other_choices > 0) say(out, "count", "not unique, chosen otherwise in another form");
  if (v.seconds > 2) say(out, "count", "took more than 2 s");
  const bool undecided = v.status == C2D_OK && v.outcome == C2D_UNDECIDED;
  if (undecided) say(out, "tell", number(seed) + " could not be decided (" + v.title + ")");
  for (const std::string& f : v.findings) {
    say(out, "finding", f.substr(0, f.find(':')));
    say(out, "tell", number(seed) + " " + f + " (" + v.title + ")");
  }
  if (!v.findings.empty() || undecided) std::ofstream(folder + "/" + number(seed) + ".dat") << v.deck;
  say(out, "end", number(seed));
}

// Lines of the process at work until it ends; the seed it died at, or `end`.
uint64_t listen(FILE* in, Tally& tally, uint64_t end) {
  char line[4000];
  uint64_t at = end;
  while (fgets(line, sizeof line, in)) {
    const std::string text = line, word = text.substr(0, text.find(' '));
    const std::string rest = text.substr(word.size() + 1, text.find('\n') - word.size() - 1);
    if (word == "begin") at = std::strtoull(rest.c_str(), nullptr, 10), ++tally.decks;
    if (word == "count") ++tally.outcomes[rest];
    if (word == "finding") ++tally.findings[rest];
    if (word == "tell") std::printf("%s\n", rest.c_str());
    if (word == "end") at = end;
    std::fflush(stdout);
  }
  return at;
}

void run_all(Kind kind, uint64_t first, uint64_t end, const std::string& folder, Tally& tally) {
  for (uint64_t seed = first; seed < end;) {
    int ends[2];
    if (pipe(ends) != 0) std::exit(3);
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
      FILE* out = fdopen(ends[1], "w");
      for (; seed < end; ++seed) judge_one(kind, seed, folder, out);
      _exit(0);
    }
    close(ends[1]);
    FILE* in = fdopen(ends[0], "r");
    const uint64_t died = listen(in, tally, end);
    fclose(in);
    int status = 0;
    waitpid(child, &status, 0);
    if (died == end) return;
    std::printf("%s ended by signal %d\n", number(died).c_str(), WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    ++tally.findings["ended by a signal"];
    seed = died + 1;
  }
}

// Spence's punches: all of them, whatever was asked for.
int run_punches() {
  int wrong = 0, count = 0;
  for (const Punch& of : all_punches()) {
    Punch p = solve_punch(of.mu, of.nu);
    p.border = spence_border(of.mu, of.nu);
    ++count;
    if (p.border_within_a_node()) continue;
    ++wrong;
    std::printf("mu %g nu %g: %s, sticks up to %.6g, slips from %.6g, reference %.6g\n", p.mu, p.nu,
                p.solved ? "solved" : p.message.c_str(), p.sticks, p.slips, p.border);
  }
  std::printf("%d punches, %d wrong\n", count, wrong);
  return wrong == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  const uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 100;
  const uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::string folder = argc > 3 ? argv[3] : ".";
  const std::string name = argc > 4 ? argv[4] : "any";
  if (name == "punch") return run_punches();
  const Kind kind = name == "few"      ? Kind::few_pairs
                    : name == "lift"   ? Kind::lifted
                    : name == "mirror" ? Kind::symmetric
                    : name == "three"  ? Kind::three
                                       : Kind::any;
  Tally tally;
  run_all(kind, first, first + count, folder, tally);
  std::printf("%d decks\n", tally.decks);
  for (const auto& o : tally.outcomes) std::printf("%6d %s\n", o.second, o.first.c_str());
  std::printf("%s\n", tally.findings.empty() ? "no findings" : "findings");
  for (const auto& f : tally.findings) std::printf("%6d %s\n", f.second, f.first.c_str());
  return tally.findings.empty() ? 0 : 1;
}
