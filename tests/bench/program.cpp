// The whole program, listing and CSV written, against an empty process.
#include "bench.hpp"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace bench {

namespace {

// Milliseconds from start to end of a process, its three standard streams closed off.
double run_once(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int fd = 0; fd < 3; ++fd)
    posix_spawn_file_actions_addopen(&actions, fd, "/dev/null", fd == 0 ? O_RDONLY : O_WRONLY, 0);
  pid_t child = 0;
  int status = -1;
  const double start = seconds_now();
  if (posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) != 0 ||
      waitpid(child, &status, 0) != child || status != 0)
    give_up("failed: " + words[0] + " " + (words.size() > 2 ? words[2] : ""));
  const double time = seconds_now() - start;
  posix_spawn_file_actions_destroy(&actions);
  return time * 1e3;
}

struct Case {
  std::string name, deck, store;
};

} // namespace

void whole_program(const Options& options) {
  const std::string folder = std::filesystem::temp_directory_path() / ("contact2d-bench-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  heading("Whole program, listing and CSV written: milliseconds more than an empty process, medians");
  const auto command = [&](const Case& c) {
    return std::vector<std::string>{options.program, "run", options.examples + "/" + c.deck, "--listing",
                                    folder + "/listing", "--csv", folder + "/csv", "--store",
                                    c.store == "file" ? "file:" + folder + "/tapes" : c.store};
  };
  const auto compare = [&](const std::vector<Case>& cases, int runs) {
    std::vector<double> empty;
    std::vector<std::vector<double>> times(cases.size()), more(cases.size());
    for (int i = 0; i < runs + 1; ++i) { // in turns; the first round warms the caches
      const double nothing = run_once({options.empty});
      if (i > 0) empty.push_back(nothing);
      for (size_t c = 0; c < cases.size(); ++c) {
        const double time = run_once(command(cases[c]));
        if (i == 0) continue;
        times[c].push_back(time);
        more[c].push_back(time - nothing);
      }
    }
    row("program.empty_process", median(empty), "ms");
    for (size_t c = 0; c < cases.size(); ++c)
      row("program." + cases[c].name, median(more[c]), "ms",
          "x " + std::to_string(median(times[c]) / median(empty)) + " of the empty process");
  };
  compare({{"hertz.memory", "hertz.dat", "memory"}, {"hertz.file", "hertz.dat", "file"}}, 30);
  compare({{"half_cylinder.memory", "half_cylinder.dat", "memory"},
           {"hertz_fine.memory", "hertz_fine.dat", "memory"},
           {"hertz_fine.file", "hertz_fine.dat", "file"}},
          10);
  std::filesystem::remove_all(folder);
}

} // namespace bench
