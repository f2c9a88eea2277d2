// make random N=...: many random decks, in a process that may crash or hang without ending the others.
//   run_random COUNT FIRST_SEED FOLDER [any|few|lift|mirror|three|revolved|resume|punch]
// Prints a line per finding and one per deck that could not be decided, then totals; exit status 1 if there was a finding.
#include "children.hpp"
#include "judge.hpp"
#include "resumed.hpp"
#include "revolved_bodies.hpp"
#include "spence.hpp"
#include "three_bodies.hpp"

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <map>
#include <string>

#include <unistd.h>

using namespace random_decks;
using random_work::say;

namespace {

constexpr unsigned kPatience = 300; // seconds for one deck in all its forms

struct Tally {
  std::map<std::string, int> outcomes, findings;
  int decks = 0, wrong = 0;
};

std::string outcome_of(const Verdict& v) {
  return v.status == C2D_ERR_INPUT ? "refused" : v.status != C2D_OK ? "failed" : c2d_outcome_message(v.outcome);
}

void judge_one(Kind kind, uint64_t seed, const std::string& folder, FILE* out) {
  alarm(kPatience);
  feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  Verdict v;
  try {
    v = kind == Kind::three      ? judge_three(seed)
        : kind == Kind::revolved ? judge_revolved(seed)
        : kind == Kind::resumed  ? judge_resumed(seed)
                                 : judge(kind, seed);
  } catch (const std::exception& e) {
    v.findings.push_back(std::string("the judge stopped: ") + e.what());
  }
  say(out, "count", "decks: " + outcome_of(v));
  if (v.unstressed) say(out, "count", "without stress");
  if (v.tried) say(out, "count", "all statuses tried");
  if (v.not_unique) say(out, "count", "said to be not unique");
  if (v.not_unique && v.unlike_its_image) say(out, "count", "not unique, and not symmetric");
  if (v.undefined_place) say(out, "count", "said to have an undefined place");
  if (v.other_choices > 0) say(out, "count", "not unique, chosen otherwise in another form");
  if (v.seconds > 2) say(out, "count", "took more than 2 s");
  const bool undecided = v.status == C2D_OK && v.outcome == C2D_UNDECIDED;
  if (undecided) say(out, "tell", std::to_string(seed) + " could not be decided (" + v.title + ")");
  for (const std::string& f : v.findings) {
    say(out, "finding", f.substr(0, f.find(':')));
    say(out, "tell", std::to_string(seed) + " " + f + " (" + v.title + ")");
  }
  if (!v.findings.empty() || undecided) std::ofstream(folder + "/" + std::to_string(seed) + ".dat") << v.deck;
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
  const Kind kind = name == "few"        ? Kind::few_pairs
                    : name == "lift"     ? Kind::lifted
                    : name == "mirror"   ? Kind::symmetric
                    : name == "three"    ? Kind::three
                    : name == "revolved" ? Kind::revolved
                    : name == "resume"   ? Kind::resumed
                                         : Kind::any;
  Tally tally;
  random_work::Work work;
  work.judge = [&](uint64_t seed, FILE* out) { judge_one(kind, seed, folder, out); };
  work.heard = [&](const std::string& word, const std::string& rest) {
    if (word == "begin") ++tally.decks;
    if (word == "count") ++tally.outcomes[rest];
    if (word == "finding") ++tally.findings[rest];
  };
  work.died = [&](uint64_t seed, int signal) {
    std::printf("%s ended by signal %d\n", std::to_string(seed).c_str(), signal);
    ++tally.findings["ended by a signal"];
  };
  random_work::run_all(first, first + count, work);
  std::printf("%d decks\n", tally.decks);
  for (const auto& o : tally.outcomes) std::printf("%6d %s\n", o.second, o.first.c_str());
  std::printf("%s\n", tally.findings.empty() ? "no findings" : "findings");
  for (const auto& f : tally.findings) std::printf("%6d %s\n", f.second, f.first.c_str());
  return tally.findings.empty() ? 0 : 1;
}
