// The program: command line, then one of the commands.
#include "program/check.hpp"
#include "program/convert.hpp"
#include "program/drawn_deck.hpp"
#include "program/drawn_sketch.hpp"
#include "program/exit_code.hpp"
#include "program/halve.hpp"
#include "program/interrupt.hpp"
#include "program/make.hpp"
#include "program/options.hpp"
#include "program/restart.hpp"
#include "program/run.hpp"

#include <contact2d.h>

#include <cstdio>
#include <new>

namespace {

int print(const char* text) {
  const bool written = std::fputs(text, stdout) >= 0 && std::fflush(stdout) == 0;
  return written ? app::kExitSolved : app::kExitFiles;
}

int resume(app::Options options) {
  std::string error;
  if (app::read_restart(options, error)) return app::run_deck(options);
  std::fprintf(stderr, "contact2d: %s\n", error.c_str());
  return app::kExitInput;
}

int run_command(const app::Options& options) {
  switch (options.command) {
  case app::Command::kRun: return app::run_deck(options);
  case app::Command::kCheck: return app::check_deck(options);
  case app::Command::kMake: return app::make_deck(options);
  case app::Command::kSketch: return app::sketch_drawing(options);
  case app::Command::kMesh: return options.halve ? app::halve_deck(options) : app::write_mesh(options);
  case app::Command::kConvert: return app::convert_deck(options);
  case app::Command::kResume: return resume(options);
  case app::Command::kVersion: return print((std::string("contact2d ") + c2d_version() + "\n").c_str());
  case app::Command::kHelp: break;
  }
  return print(app::help_text().c_str());
}

} // namespace

int main(int argc, char** argv) {
  app::catch_interrupts();
  try {
    app::Options options;
    std::string error;
    if (!app::read_options(argc, argv, options, error)) {
      std::fprintf(stderr, "contact2d: %s\ncontact2d: --help lists commands and options\n", error.c_str());
      return app::kExitUsage;
    }
    return run_command(options);
  } catch (const std::bad_alloc&) {
    std::fputs("contact2d: error: no memory left\n", stderr);
    return app::kExitMemory;
  }
}
