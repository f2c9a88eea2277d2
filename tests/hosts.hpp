// What the tests of foreign hosts share: tools that may be missing, the library in folders where -lcontact2d
// finds it, and the answers that every host must give.
#pragma once

#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace test {

// Can this be tested here? A missing tool is said aloud, and is a failure where C2D_ALL_HOSTS says that all
// are there.
inline bool can_host(const std::string& tool) {
  if (paths::sanitized()) {
    MESSAGE("skipped: the library needs the sanitizer's run-time, which " << tool << " does not link");
    return false;
  }
  if (has_command(tool)) return true;
  const char* all = std::getenv("C2D_ALL_HOSTS");
  if (all != nullptr && std::string(all) == "1")
    FAIL_CHECK(tool << " is missing, and C2D_ALL_HOSTS=1");
  else
    MESSAGE("skipped: there is no " << tool);
  return false;
}

// Folders with nothing but the static or the shared library in them.
class Libraries {
public:
  Libraries() {
    fs::create_directories(folder_ / "static");
    fs::create_directories(folder_ / "shared");
    fs::create_symlink(paths::library(), folder_ / "static/libcontact2d.a");
    for (const char* name : {"shared/libcontact2d.so", "shared/libcontact2d.so.0.2"})
      fs::create_symlink(paths::shared(), folder_ / name);
  }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  // " -L'...' -lcontact2d", kind: static or shared.
  std::string link(const std::string& kind) const { return " -L'" + (folder_ / kind) + "' -lcontact2d"; }
  std::string run(const std::string& program) const {
    return "LD_LIBRARY_PATH='" + (folder_ / "shared") + "' '" + (folder_ / program) + "'";
  }

private:
  Folder folder_;
};

// A line of a host: coefficient, step, load factor, and the largest pressure of all pairs.
struct Peak {
  double mu, step, load, pressure;
};

// The numbers of the lines that tell a peak pressure; words are passed over. `own`: lines that begin with
// OWN, which have no step.
inline std::vector<Peak> peaks_of(const std::string& text, bool own = false) {
  std::vector<Peak> out;
  for (std::string line : lines_of(text)) {
    for (char& c : line) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!contains(line, "peak pressure") || contains(line, "own") != own) continue;
    std::vector<double> numbers;
    std::istringstream in(line);
    for (std::string word; in >> word;) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (end != word.c_str() && *end == '\0') numbers.push_back(value);
    }
    if (own && numbers.size() == 3) out.push_back({numbers[0], 0, numbers[1], numbers[2]});
    if (!own && numbers.size() == 4) out.push_back({numbers[0], numbers[1], numbers[2], numbers[3]});
  }
  return out;
}

// The same from the program's --csv: the desktop run that hosts are compared with.
inline std::vector<Peak> desktop_peaks(const std::string& deck) {
  std::vector<Peak> out;
  const Result run = run_shell("'" + paths::program() + "' run '" + deck + "' --csv -");
  for (const std::string& line : lines_of(run.out)) {
    double mu = 0, step = 0, load = 0, tn = 0;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%*d,%*f,%*f,%*[a-z],%lf", &mu, &step, &load, &tn) != 4) continue;
    if (out.empty() || out.back().mu != mu || out.back().step != step) out.push_back({mu, step, load, 0});
    if (tn > out.back().pressure) out.back().pressure = tn;
  }
  return out;
}

// `digits`: what the host printed behind the point. Widths of panels differ between hosts, and with them the
// ninth digit of an answer.
inline void check_peaks(const std::vector<Peak>& found, const std::vector<Peak>& expected, double digits) {
  REQUIRE(expected.size() > 10);
  REQUIRE(found.size() == expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    CHECK(found[i].mu == doctest::Approx(expected[i].mu).epsilon(1e-12));
    CHECK(found[i].step == expected[i].step);
    CHECK(std::fabs(found[i].load - expected[i].load) < 1e-9);
    CHECK(std::fabs(found[i].pressure - expected[i].pressure) < digits + 1e-8 * std::fabs(expected[i].pressure));
  }
}

} // namespace test
