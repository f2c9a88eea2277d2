#include "children.hpp"

#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

namespace random_work {
namespace {

// Lines of the process at work until it ends; the seed it died at, or `end`.
uint64_t listen(FILE* in, const Work& work, uint64_t end) {
  char line[4000];
  uint64_t at = end;
  while (fgets(line, sizeof line, in)) {
    const std::string text = line, word = text.substr(0, text.find(' '));
    const std::string rest = text.substr(word.size() + 1, text.find('\n') - word.size() - 1);
    if (word == "begin") at = std::strtoull(rest.c_str(), nullptr, 10);
    if (word == "end") at = end;
    if (word == "tell") std::printf("%s\n", rest.c_str());
    work.heard(word, rest);
    std::fflush(stdout);
  }
  return at;
}

} // namespace

void say(FILE* out, const char* word, std::string rest) {
  for (char& c : rest)
    if (c == '\n') c = ' ';
  std::fprintf(out, "%s %s\n", word, rest.c_str());
  std::fflush(out);
}

void run_all(uint64_t first, uint64_t end, const Work& work) {
  for (uint64_t seed = first; seed < end;) {
    int ends[2];
    if (pipe(ends) != 0) std::exit(3);
    const pid_t child = fork();
    if (child == 0) {
      close(ends[0]);
      FILE* out = fdopen(ends[1], "w");
      for (; seed < end; ++seed) {
        say(out, "begin", std::to_string(seed));
        work.judge(seed, out);
        say(out, "end", std::to_string(seed));
      }
      _exit(0);
    }
    close(ends[1]);
    FILE* in = fdopen(ends[0], "r");
    const uint64_t died = listen(in, work, end);
    fclose(in);
    int status = 0;
    waitpid(child, &status, 0);
    if (died == end) return;
    work.died(died, WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    seed = died + 1;
  }
}

} // namespace random_work
