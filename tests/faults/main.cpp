// run_faults PROGRAM LIBRARY STEP [PART [JOB]]: the program under faults; a line per kind of trouble. STEP 1: all cases.
#include "campaign.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace {

struct Part {
  const char* name;
  void (*go)(const faults::Place&, const faults::Job&, uint64_t, faults::Tally&);
};
const Part kParts[] = {{"operations", faults::fail_operations},
                       {"lies", faults::lie},
                       {"kills", faults::kill_at_operations},
                       {"power", faults::lose_power},
                       {"memory", faults::refuse_memory}};

void print(const std::string& name, const faults::Tally& tally) {
  std::printf("%-12s %9llu cases %7llu faults\n", name.c_str(), static_cast<unsigned long long>(tally.cases),
              static_cast<unsigned long long>(tally.faults));
  for (const auto& [kind, count] : tally.kinds)
    std::printf("  %9llu  %s\n", static_cast<unsigned long long>(count), kind.c_str());
  for (const auto& [text, count] : tally.how_often)
    std::printf("  FAULT %7llu  %s\n           (%s)\n", static_cast<unsigned long long>(count), text.c_str(),
                tally.example.at(text).c_str());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 64;
  namespace fs = std::filesystem;
  const std::string part = argc > 4 ? argv[4] : "", wanted = argc > 5 ? argv[5] : "";
  faults::Place place;
  place.program = fs::absolute(argv[1]).string();
  // In memory where that can be had: there are many runs, and nothing has to last.
  const char* base = ::access("/dev/shm", W_OK) == 0 ? "/dev/shm" : std::getenv("TMPDIR");
  place.base = std::string(base != nullptr ? base : "/tmp") + "/contact2d-faults-" + std::to_string(::getpid());
  fs::create_directories(place.base);
  place.library = place.base + "/preload.so"; // a name without blanks, which part those of LD_PRELOAD
  fs::create_symlink(fs::absolute(argv[2]), place.library);
  std::string error;
  const std::vector<faults::Job> jobs = faults::make_jobs(place, error);
  uint64_t all = 0;
  if (!error.empty()) std::fprintf(stderr, "%s\n", error.c_str());
  for (const Part& p : kParts) {
    if (!part.empty() && part != p.name) continue;
    faults::Tally tally;
    for (const faults::Job& job : jobs)
      if (wanted.empty() || wanted == job.name) p.go(place, job, std::strtoull(argv[3], nullptr, 10), tally);
    print(p.name, tally);
    all += tally.faults;
  }
  fs::remove_all(place.base);
  return error.empty() && all == 0 ? 0 : 1;
}
