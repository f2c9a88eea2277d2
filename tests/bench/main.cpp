// The benchmarks' program: make bench [SAVE=file] [BASE=file] [LARGE=1].
#include "bench.hpp"
#include "ours.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <thread>

namespace bench {

namespace {

std::map<std::string, double> base;
std::ofstream save;
int met = 0;
std::vector<std::string> missed;

void read_base(const std::string& name) {
  std::ifstream file(name);
  if (!file) give_up("cannot read " + name);
  for (std::string line; std::getline(file, line);) {
    const size_t equals = line.find('=');
    if (equals != std::string::npos) base[line.substr(0, equals)] = std::atof(line.c_str() + equals + 1);
  }
}

} // namespace

double seconds_now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double processor_seconds() {
  timespec now = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const size_t n = values.size();
  return n == 0 ? 0 : 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

double exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double n = static_cast<double>(x.size());
  for (size_t i = 0; i < x.size(); ++i) {
    const double a = std::log(x[i]), b = std::log(y[i]);
    sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string times(double ratio) {
  char text[32];
  std::snprintf(text, sizeof text, "x %.2f", ratio);
  return text;
}

void heading(const std::string& text) { std::printf("\n%s\n", text.c_str()); }

namespace {

// The same of the run compared with, if any.
std::string before(const std::string& key, double value) {
  const auto found = base.find(key);
  if (found == base.end() || found->second <= 0) return "";
  char text[64];
  std::snprintf(text, sizeof text, " [%.4g before, x %.2f]", found->second, value / found->second);
  return text;
}

} // namespace

void row(const std::string& key, double value, const std::string& unit, const std::string& remark) {
  std::printf("  %-36s %10.4g %-8s%s%s%s\n", key.c_str(), value, unit.c_str(), before(key, value).c_str(),
              remark.empty() ? "" : "  ", remark.c_str());
  std::fflush(stdout);
  if (save.is_open()) save << key << '=' << value << '\n';
}

void note(const std::string& key, const std::string& text) {
  std::printf("  %-36s          - %s\n", key.c_str(), text.c_str());
}

std::string judged(const std::string& key, double value, const char* relation, double figure, const std::string& words) {
  if (save.is_open()) save << key << '=' << value << '\n';
  char text[200];
  std::snprintf(text, sizeof text, "%.3g%s ", value, before(key, value).c_str());
  const std::string number = text;
  std::string out = words.empty() ? "" : number + words;
  if (figure <= 0) return out;
  const bool holds = relation[0] == '>' ? value >= figure : value <= figure;
  std::snprintf(text, sizeof text, "%sasked %s %.4g: %s", out.empty() ? "" : ", ", relation, figure, holds ? "met" : "MISSED");
  if (holds)
    ++met;
  else
    missed.push_back(key + "  " + (words.empty() ? number : "") + out + text);
  return out + text;
}

void give_up(const std::string& why) {
  std::fprintf(stderr, "bench: %s\n", why.c_str());
  std::exit(1);
}

} // namespace bench

namespace {

// What the numbers are of, and whether times by the clock can be believed.
void tell_machine() {
#ifdef __clang__
  const char* compiler = __VERSION__;
#else
  const char* compiler = "g++ " __VERSION__;
#endif
  std::ifstream cpu("/proc/cpuinfo");
  for (std::string line; std::getline(cpu, line);)
    if (line.compare(0, 10, "model name") == 0) {
      std::printf("%s, ", line.substr(line.find(':') + 2).c_str());
      break;
    }
  double load = 0;
  const unsigned cores = std::thread::hardware_concurrency();
  if (std::ifstream file("/proc/loadavg"); file) file >> load;
  std::printf("%u cores, best set %s, compiled by %s\n", cores, bench::name_of(c2d::best_instructions()), compiler);
  if (load > 0.3 * cores)
    std::printf("NOT QUIET: a load of %.1f by others; times by the clock, two threads above all, mean little\n", load);
}

void read_options(int argc, char** argv, bench::Options& options, std::string& only) {
  std::string large;
  const std::map<std::string, std::string*> words = {{"--program", &options.program},
                                                     {"--empty", &options.empty},
                                                     {"--spawn", &options.spawn},
                                                     {"--decks", &options.decks},
                                                     {"--examples", &options.examples},
                                                     {"--folder", &options.folder},
                                                     {"--openblas", &options.openblas},
                                                     {"--blas", &options.blas},
                                                     {"--lapack", &options.lapack},
                                                     {"--only", &only},
                                                     {"--large", &large}};
  options.self = argv[0];
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    const auto word = words.find(name);
    if (word != words.end())
      *word->second = value;
    else if (name == "--base") {
      if (!value.empty()) bench::read_base(value);
    } else if (name == "--save") {
      if (!value.empty()) bench::save.open(value);
    } else
      bench::give_up("unknown option " + name);
  }
  options.large = !large.empty() && large != "0";
}

} // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "--serve") return bench::serve_own(argv[2], std::atoi(argv[3]));
  if (argc == 3 && std::string(argv[1]) == "--guard") return bench::guard(argv[2]);
  bench::Options options;
  std::string only;
  read_options(argc, argv, options, only);
  tell_machine();
  const auto wanted = [&](const std::string& part) {
    return only.empty() || ("," + only + ",").find("," + part + ",") != std::string::npos;
  };
  if (wanted("elimination")) bench::elimination(options);
  if (wanted("out_of_core")) bench::out_of_core(options);
  if (wanted("assembly")) bench::assembly();
  if (wanted("interior")) bench::interior_points();
  if (wanted("events")) bench::contact_events(options);
  if (wanted("bodies")) bench::many_bodies();
  if (wanted("compressed")) bench::compressed_elimination(options);
  if (wanted("program")) bench::whole_program(options);
  std::printf("\nFigures asked for: %d met, %d missed\n", bench::met, static_cast<int>(bench::missed.size()));
  for (const std::string& line : bench::missed) std::printf("  %s\n", line.c_str());
  return 0;
}
