// What the benchmarks share: time by medians, a table that can be saved and compared.
#pragma once

#include "../callable.hpp"
#include "linalg/kernel.hpp"

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
  for (const double start = seconds_now(); static_cast<int>(times.size()) < least || seconds_now() - start < enough;) {
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
// A row without a number.
void note(const std::string& key, const std::string& text);
// "0.83 of the peak, asked >= 0.8: met"; figure 0: nothing was asked. Kept under the key as a row is, and
// counted.
std::string judged(const std::string& key, double value, const char* relation, double figure, const std::string& words);
[[noreturn]] void give_up(const std::string& why);

struct Options {
  std::string program, empty, spawn, examples, decks; // files to run, folders of decks
  std::string self, folder;                           // this program, and where its helpers are
  std::string openblas, blas, lapack;                 // libraries; empty: not there
  bool large = false;
};

// The matrix of a mixed problem of a disc with so many nodes, column-major, 2 nodes x 2 nodes, to a file.
void write_boundary_matrix(const std::string& file, int nodes);

// Fixed amounts of work, whose instructions are counted: guard.cpp.
test::Callable<void()> assembly_job(c2d::Instructions set, int nodes); // empty: this build has no such set
test::Callable<void()> interior_job(int32_t elements, int32_t points); // points x points
test::Callable<void()> contact_job(int32_t pairs, int sweeps);
// run_bench --guard JOB; --guard list tells their names.
int guard(const std::string& job);

void elimination(const Options& options);
void out_of_core(const Options& options);
void assembly();
void interior_points();
void contact_events(const Options& options);
void many_bodies();
void compressed_elimination(const Options& options);
void whole_program(const Options& options);

} // namespace bench
