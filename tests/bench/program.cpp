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
  std::string name, deck, store;
};

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
                                    c.store == "file" ? "file:" + folder + "/tapes" : c.store};
  };
  const auto compare = [&](const std::vector<Case>& cases, int runs) {
    std::vector<double> empty;
    std::vector<std::vector<double>> wall(cases.size()), processor(cases.size());
    for (int i = 0; i < runs + 1; ++i) { // in turns; the first round warms the caches
      for (size_t c = 0; c < cases.size(); ++c) {
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
      row("program." + cases[c].name, more, "ms",
          "x " + std::to_string(more / median(empty)) + " of the empty process");
      row("program." + cases[c].name + ".processor", median(processor[c]), "ms", "processor time");
    }
  };
  compare({{"hertz.memory", "hertz.dat", "memory"}, {"hertz.file", "hertz.dat", "file"}}, 30);
  compare({{"half_cylinder.memory", "half_cylinder.dat", "memory"},
           {"hertz_fine.memory", "hertz_fine.dat", "memory"},
           {"hertz_fine.file", "hertz_fine.dat", "file"}},
          10);
  std::filesystem::remove_all(folder);
}

} // namespace bench
