// The program: command line, then one of the commands.
#include "program/check.hpp"
#include "program/exit_code.hpp"
#include "program/interrupt.hpp"
#include "program/options.hpp"
#include "program/run.hpp"

#include <contact2d.h>

#include <cstdio>
#include <new>

namespace {

int print(const char* text) {
  const bool written = std::fputs(text, stdout) >= 0 && std::fflush(stdout) == 0;
  return written ? c2d::kExitSolved : c2d::kExitFiles;
}

int run_command(const c2d::Options& options) {
  switch (options.command) {
  case c2d::Command::kRun:
    return c2d::run_deck(options);
  case c2d::Command::kCheck:
    return c2d::check_deck(options);
  case c2d::Command::kVersion:
    return print((std::string("contact2d ") + c2d_version() + "\n").c_str());
  case c2d::Command::kHelp:
    break;
  }
  return print(c2d::help_text());
}

} // namespace

int main(int argc, char** argv) {
  c2d::catch_interrupts();
  try {
    c2d::Options options;
    std::string error;
    if (!c2d::read_options(argc, argv, options, error)) {
      std::fprintf(stderr, "contact2d: %s\ncontact2d: --help lists commands and options\n", error.c_str());
      return c2d::kExitUsage;
    }
    return run_command(options);
  } catch (const std::bad_alloc&) {
    std::fputs("contact2d: error: no memory left\n", stderr);
    return c2d::kExitMemory;
  }
}
