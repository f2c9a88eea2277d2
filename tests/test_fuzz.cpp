// The targets of tests/fuzz with their seeds and with every input that was found to fail once: each demands what it demands
// under libFuzzer. The long runs are `make fuzz`.
#include "paths.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

extern "C" {
int fuzz_calls(const uint8_t* data, size_t size);
int fuzz_deck(const uint8_t* data, size_t size);
int fuzz_drawing(const uint8_t* data, size_t size);
int fuzz_expression(const uint8_t* data, size_t size);
int fuzz_options(const uint8_t* data, size_t size);
int fuzz_points(const uint8_t* data, size_t size);
int fuzz_program(const uint8_t* data, size_t size);
int fuzz_sketch(const uint8_t* data, size_t size);
int fuzz_state(const uint8_t* data, size_t size);
int fuzz_table(const uint8_t* data, size_t size);
}

namespace {

namespace fs = std::filesystem;

struct Target {
  const char* name;
  int (*run)(const uint8_t* data, size_t size);
  std::vector<const char*> more; // folders and files of the tree that are seeds too
};
const std::vector<Target> kTargets = {{"calls", fuzz_calls, {}},
                                      {"deck", fuzz_deck, {"tests/data/decks", "tests/data/hard"}},
                                      {"drawing", fuzz_drawing, {"tests/data/drawings"}},
                                      {"expression", fuzz_expression, {}},
                                      {"options", fuzz_options, {}},
                                      {"points", fuzz_points, {}},
                                      {"program", fuzz_program, {"examples/three_bodies.dat", "tests/data/judge"}},
                                      {"sketch", fuzz_sketch, {"examples/roller.c2s", "examples/crack.c2s"}},
                                      {"state", fuzz_state, {}},
                                      {"table", fuzz_table, {}}};

// What the targets print is of no interest unless one of them ends the tests.
class Quiet {
public:
  Quiet() : kept_(::dup(2)) {
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(nothing, 2);
    ::close(nothing);
  }
  ~Quiet() {
    ::dup2(kept_, 2);
    ::close(kept_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

private:
  int kept_;
};

std::vector<fs::path> files_of(const fs::path& path) {
  std::vector<fs::path> out;
  if (fs::is_regular_file(path)) out.push_back(path);
  if (fs::is_directory(path))
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

// Feeds a target with a file. It has a block of the heap of its own, so that reading beyond its end is seen.
void feed(const Target& target, const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  REQUIRE(in.good());
  const std::vector<uint8_t> bytes(text.begin(), text.end());
  INFO("tests/fuzz, target ", target.name, ", input ", path.string());
  const Quiet quiet;
  CHECK(target.run(bytes.data(), bytes.size()) == 0);
}

size_t feed_all(const Target& target, const fs::path& path) {
  const std::vector<fs::path> files = files_of(path);
  for (const fs::path& file : files) feed(target, file);
  return files.size();
}

} // namespace

TEST_CASE("fuzz: every target holds on its seeds") {
  const fs::path root = paths::root();
  for (const Target& target : kTargets) {
    INFO(target.name);
    CHECK(feed_all(target, root / "tests/fuzz/seeds" / target.name) > 0);
    for (const char* more : target.more) CHECK(feed_all(target, root / more) > 0);
  }
}

TEST_CASE("fuzz: what once failed") {
  for (const Target& target : kTargets) feed_all(target, fs::path(paths::root()) / "tests/fuzz/found" / target.name);
}

TEST_CASE("fuzz: the tests know every target, and every folder of inputs is one's") {
  const fs::path folder = fs::path(paths::root()) / "tests/fuzz";
  std::set<std::string> known, written;
  for (const Target& target : kTargets) known.insert(target.name);
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".cpp") written.insert(entry.path().stem().string());
  CHECK(known == written);
  for (const char* kind : {"seeds", "found"})
    if (fs::is_directory(folder / kind))
      for (const auto& entry : fs::directory_iterator(folder / kind)) {
        INFO(entry.path().string());
        CHECK(known.count(entry.path().filename().string()) == 1);
        CHECK(!files_of(entry.path()).empty());
      }
}
