// The benchmarks' program: make bench [SAVE=file] [BASE=file].
#include "bench.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>

namespace bench {

namespace {

std::map<std::string, double> base;
std::ofstream save;

void read_base(const std::string& name) {
  std::ifstream file(name);
  if (!file) give_up("cannot read " + name);
  for (std::string line; std::getline(file, line);) {
    const size_t equals = line.find('=');
    if (equals != std::string::npos) base[line.substr(0, equals)] = std::atof(line.c_str() + equals + 1);
  }
}

} // namespace

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

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

void heading(const std::string& text) {
  std::printf("\n%s\n", text.c_str());
}

void row(const std::string& key, double value, const std::string& unit, const std::string& remark) {
  std::string compared;
  const auto found = base.find(key);
  if (found != base.end() && found->second > 0) {
    char text[64];
    std::snprintf(text, sizeof text, " [%.4g before, x %.2f]", found->second, value / found->second);
    compared = text;
  }
  std::printf("  %-34s %10.4g %-8s%s%s%s\n", key.c_str(), value, unit.c_str(), compared.c_str(),
              remark.empty() ? "" : "  ", remark.c_str());
  std::fflush(stdout);
  if (save.is_open()) save << key << '=' << value << '\n';
}

void give_up(const std::string& why) {
  std::fprintf(stderr, "bench: %s\n", why.c_str());
  std::exit(1);
}

} // namespace bench

int main(int argc, char** argv) {
  bench::Options options;
  std::string only;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i], value = argv[i + 1];
    if (name == "--program")
      options.program = value;
    else if (name == "--empty")
      options.empty = value;
    else if (name == "--examples")
      options.examples = value;
    else if (name == "--only")
      only = value;
    else if (name == "--base") {
      if (!value.empty()) bench::read_base(value);
    } else if (name == "--save") {
      if (!value.empty()) bench::save.open(value);
    } else
      bench::give_up("unknown option " + name);
  }
  const auto wanted = [&](const char* part) { return only.empty() || only == part; };
  if (wanted("events")) bench::contact_events();
  if (wanted("elimination")) bench::elimination();
  if (wanted("assembly")) bench::assembly();
  if (wanted("program")) bench::whole_program(options);
  return 0;
}
