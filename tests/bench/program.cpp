// The whole program, listing and CSV written, against an empty process.
#include "bench.hpp"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace bench {

namespace {

// Milliseconds from start to end of a process, and of processor time in it.
struct Spent {
  double wall, processor;
};

double milliseconds(const timeval& t) {
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
}

// Runs a process, its three standard streams closed off.
Spent run_once(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int fd = 0; fd < 3; ++fd)
    posix_spawn_file_actions_addopen(&actions, fd, "/dev/null", fd == 0 ? O_RDONLY : O_WRONLY, 0);
  pid_t child = 0;
  int status = -1;
  rusage use = {};
  const double start = seconds_now();
  if (posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) != 0 ||
      wait4(child, &status, 0, &use) != child || status != 0)
    give_up("failed: " + words[0] + " " + (words.size() > 2 ? words[2] : ""));
  const double time = seconds_now() - start;
  posix_spawn_file_actions_destroy(&actions);
  return {time * 1e3, milliseconds(use.ru_utime) + milliseconds(use.ru_stime)};
}

struct Case {
  std::string name, deck, store; // store: memory, or the folder of the tapes
};

// A file system in memory, where a sync costs nothing; empty: none is there.
std::string quick_folder() {
  return access("/dev/shm", W_OK) == 0 ? "/dev/shm/contact2d-bench-" + std::to_string(getpid()) : "";
}

} // namespace

void whole_program(const Options& options) {
  const std::string folder =
      std::filesystem::temp_directory_path() / ("contact2d-bench-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  heading("Whole program, listing and CSV written: milliseconds more than an empty process, medians");
  const auto command = [&](const Case& c) {
    return std::vector<std::string>{options.program,
                                    "run",
                                    options.examples + "/" + c.deck,
                                    "--listing",
                                    folder + "/listing",
                                    "--csv",
                                    folder + "/csv",
                                    "--store",
                                    c.store == "memory" ? c.store : "file:" + c.store};
  };
  const auto compare = [&](const std::vector<Case>& cases, int runs) {
    std::vector<double> empty;
    std::vector<std::vector<double>> wall(cases.size()), processor(cases.size());
    for (int i = 0; i < runs + 1; ++i) { // in turns; the first round warms the caches
      for (size_t c = 0; c < cases.size(); ++c) {
        std::filesystem::remove(folder + "/listing"); // to replace a file takes some disks a while
        std::filesystem::remove(folder + "/csv");
        const Spent nothing = run_once({options.empty}), all = run_once(command(cases[c]));
        if (i == 0) continue;
        empty.push_back(nothing.wall);
        wall[c].push_back(all.wall - nothing.wall);
        processor[c].push_back(all.processor - nothing.processor);
      }
    }
    row("program.empty_process." + std::to_string(runs), median(empty), "ms");
    for (size_t c = 0; c < cases.size(); ++c) {
      const double more = median(wall[c]);
      row("program." + cases[c].name, more, "ms", times(more / median(empty)) + " of the empty process");
      row("program." + cases[c].name + ".processor", median(processor[c]), "ms", "processor time");
    }
  };
  const std::string disk = folder + "/tapes", quick = quick_folder();
  std::vector<Case> sample = {{"hertz.memory", "hertz.dat", "memory"}, {"hertz.file", "hertz.dat", disk}};
  std::vector<Case> others = {{"half_cylinder.memory", "half_cylinder.dat", "memory"},
                              {"hertz_fine.memory", "hertz_fine.dat", "memory"}};
  if (!quick.empty()) {
    sample.push_back({"hertz.file_without_sync", "hertz.dat", quick});
    others.push_back({"hertz_fine.file_without_sync", "hertz_fine.dat", quick});
  }
  compare(sample, 30);
  compare(others, 10);
  if (!quick.empty()) std::filesystem::remove_all(quick);
  std::filesystem::remove_all(folder);
}

} // namespace bench
