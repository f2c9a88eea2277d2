// make estimate N=...: many random sketches, each in a process that may crash or hang without ending the others.
//   run_sketches COUNT FIRST_SEED FOLDER [ELEMENTS] [SECONDS] [ELEMENTS OF TRUTH] [revolved | cycles]
// Prints a line per sketch and one per number whose true error is above the stated one, then totals; exit status 1 if a sketch
// crashed, hung, was not taken, or failed without a word. Numbers that are off are counted, not judged: an error is an
// estimate.
#include "children.hpp"
#include "sketch_judge.hpp"
#include "sketches.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <map>
#include <string>

#include <sys/time.h>

using namespace random_sketches;
using random_work::say;

namespace {

constexpr long kPatience = 120; // seconds of a processor for one sketch and what it is held against
constexpr double kBounds[] = {0.4, 0.8, 1, 2, 4, 8, 20, 100};

struct Tally {
  std::map<std::string, int> ends, findings, ratios;
  int sketches = 0;
};

std::string bin_of(const Compared& c) {
  if (!(c.off > 1e-6 * c.stated.scale)) return "~ nothing to compare";
  char text[60];
  double low = 0;
  for (const double bound : kBounds) {
    std::snprintf(text, sizeof text, "%5.1f to %g", low, bound);
    if (c.ratio() < bound) return text;
    low = bound;
  }
  return "above 100";
}

// Without the numbers in it.
std::string kind_of(const std::string& message) {
  std::string out;
  for (const char c : message)
    if (c < '0' || c > '9') out += c;
  return out;
}

// All numbers of a sketch beside the truth, as a table.
void write_numbers(const Judged& j, const std::string& file) {
  std::ofstream out(file);
  out << "name,zone,body,item,value,error,truth,off,scale,tolerance,met,apart,before,hidden,spacing,doubt,energy,order\n";
  for (const Compared& c : j.numbers) {
    char text[400];
    std::snprintf(text, sizeof text, "%s,%d,%d,%d,%.9g,%.3g,%.9g,%.3g,%.3g,%g,%d,%.3g,%.3g,%.3g,%.3g,%.3g,%.3g,%d\n",
                  c.stated.name().c_str(), c.stated.zone, c.stated.body, c.stated.item, c.stated.value, c.stated.error, c.truth,
                  c.off, c.stated.scale, c.stated.tolerance, j.stopped.empty() ? 1 : 0, c.stated.apart, c.stated.before,
                  c.stated.hidden, c.stated.spacing, c.stated.doubt, j.energy, j.order);
    out << text;
  }
}

void say_numbers(const Judged& j, bool sharp, const std::string& seed, FILE* out) {
  const std::string all = sharp ? "sharp " : j.stopped.empty() ? "met   " : "unmet ";
  for (const Compared& c : j.numbers) {
    say(out, "ratio", all + bin_of(c));
    if (!c.is_wrong()) continue;
    char text[300];
    std::snprintf(text, sizeof text,
                  "%s   %s zone %d item %d: %.6g +- %.2g, truth %.6g, off %.2g (%.2g of stated, %.2g of scale)%s", seed.c_str(),
                  c.stated.name().c_str(), c.stated.zone, c.stated.item, c.stated.value, c.stated.error, c.truth, c.off,
                  c.off / c.stated.error, c.off / c.stated.scale, std::isnan(c.stated.tolerance) ? "" : ", wanted");
    say(out, "tell", text);
  }
}

void judge_one(uint64_t number, Drawn (*draw_one)(uint64_t), const std::string& folder, const Limits& limits, FILE* out) {
  const std::string seed = std::to_string(number);
  const Drawn drawn = draw_one(number);
  std::ofstream(folder + "/" + seed + ".c2s") << drawn.text;
  const itimerval patience{{0, 0}, {kPatience, 0}};
  setitimer(ITIMER_PROF, &patience, nullptr);
  Judged j;
  try {
    j = judge(drawn.text, limits);
  } catch (const std::exception& e) {
    j.fault = std::string("the judge stopped: ") + e.what();
  }
  const std::string end = !j.fault.empty()      ? "FAULT " + j.fault
                          : !j.silent.empty()   ? "SILENT " + j.silent
                          : !j.failure.empty()  ? "failed: " + j.failure
                          : !j.no_truth.empty() ? "the other mesh failed: " + j.no_truth
                          : !j.ended.empty()    ? "history ended: " + j.ended
                          : !j.stopped.empty()  ? "stopped: " + j.stopped
                                                : "met";
  double worst = HUGE_VAL;
  for (const Compared& c : j.numbers)
    if (c.off > 1e-6 * c.stated.scale) worst = std::fmin(worst, c.ratio());
  char text[200];
  std::snprintf(text, sizeof text, "; %d meshes, %d elements, %.2g s, truth %.2g s /%d; least stated/true %.2g of %zu (",
                j.rounds, j.elements, j.seconds, j.seconds_of_truth, 1 << j.halved, worst, j.numbers.size());
  say(out, "tell", seed + " " + end + text + drawn.scene + ")");
  if (!j.fault.empty() || !j.silent.empty()) say(out, "finding", kind_of(end));
  say(out, "count", kind_of(end));
  say_numbers(j, drawn.sharp, seed, out);
  write_numbers(j, folder + "/" + seed + ".csv");
}

} // namespace

int main(int argc, char** argv) {
  const uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 200;
  const uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  Limits limits;
  if (argc > 4) limits.elements = std::atoi(argv[4]);
  if (argc > 5) limits.seconds = std::atof(argv[5]);
  if (argc > 6) limits.of_truth = std::atoi(argv[6]);
  const std::string kind = argc > 7 ? argv[7] : "";
  Drawn (*const draw_one)(uint64_t) = kind == "revolved" ? draw_revolved : kind == "cycles" ? draw_cycles : draw;
  Tally tally;
  const std::string folder = argc > 3 ? argv[3] : ".";
  random_work::Work work;
  work.judge = [&](uint64_t seed, FILE* out) { judge_one(seed, draw_one, folder, limits, out); };
  work.heard = [&](const std::string& word, const std::string& rest) {
    if (word == "begin") ++tally.sketches;
    if (word == "count") ++tally.ends[rest];
    if (word == "finding") ++tally.findings[rest];
    if (word == "ratio") ++tally.ratios[rest];
  };
  work.died = [&](uint64_t seed, int signal) {
    const std::string how = "ended by signal " + std::to_string(signal);
    std::printf("%s %s%s\n", std::to_string(seed).c_str(), how.c_str(), signal == SIGPROF ? " (too long)" : "");
    ++tally.findings[how];
  };
  random_work::run_all(first, first + count, work);
  std::printf("%d sketches\n", tally.sketches);
  for (const auto& o : tally.ends) std::printf("%6d %s\n", o.second, o.first.c_str());
  std::printf("stated over true errors, of sketches that met their tolerances, did not, or have sharp corners\n");
  for (const auto& r : tally.ratios) std::printf("%6d %s\n", r.second, r.first.c_str());
  std::printf("%s\n", tally.findings.empty() ? "no findings" : "findings");
  for (const auto& f : tally.findings) std::printf("%6d %s\n", f.second, f.first.c_str());
  return tally.findings.empty() ? 0 : 1;
}
