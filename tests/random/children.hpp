// Work by seeds in processes that may crash or hang without ending the others.
#pragma once

#include "../callable.hpp"

#include <cstdint>
#include <cstdio>
#include <string>

namespace random_work {

// What a process at work tells its parent: a line of a word and the rest.
void say(FILE* out, const char* word, std::string rest);

struct Work {
  test::Callable<void(uint64_t seed, FILE* out)> judge;                         // in a process of its own
  test::Callable<void(const std::string& word, const std::string& rest)> heard; // of what it says, but "tell": that is printed
  test::Callable<void(uint64_t seed, int signal)> died;                         // by that signal, 0: it ended otherwise
};
// Seeds from the first one up to before `end`, in one process after another: the next one begins behind the seed at which the
// last one died.
void run_all(uint64_t first, uint64_t end, const Work& work);

} // namespace random_work
