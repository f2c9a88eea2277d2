// What the benchmarks share: time by medians, a table that can be saved and compared.
#pragma once

#include <string>
#include <vector>

namespace bench {

double seconds_now();
// Processor time of this process: what others do on the machine at the same time counts least in it.
double processor_seconds();
double median(std::vector<double> values);

// Median seconds of one call of work(), which is called at least `least` times and until `enough` seconds are
// over.
template <class Work> double time_of(int least, double enough, Work work) {
  std::vector<double> times;
  for (const double start = seconds_now();
       static_cast<int>(times.size()) < least || seconds_now() - start < enough;) {
    const double t = processor_seconds();
    work();
    times.push_back(processor_seconds() - t);
  }
  return median(times);
}

// Exponent b of y = a x^b by least squares of the logarithms.
double exponent(const std::vector<double>& x, const std::vector<double>& y);

// "x 1.23"
std::string times(double ratio);
void heading(const std::string& text);
// One line of the table: key, value, unit, the same of the run compared with, if any, and what it means.
void row(const std::string& key, double value, const std::string& unit, const std::string& remark = "");
[[noreturn]] void give_up(const std::string& why);

struct Options {
  std::string program, empty, examples; // files to run, folder of the decks
};

void contact_events();
void elimination();
void assembly();
void whole_program(const Options& options);

} // namespace bench
