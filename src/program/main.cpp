// The program: command line, then one of the commands.
#include "program/commands/commands.hpp"
#include "program/commands/drawn_deck.hpp"
#include "program/commands/job.hpp"
#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/files/system_file.hpp"
#include "program/interrupt.hpp"
#include "program/option_table.hpp"
#include "program/run.hpp"
#include "program/sweep/answer.hpp"
#include "program/sweep/parameters.hpp"
#include "program/sweep/sweep.hpp"
#include "program/words/voice.hpp"
#include "report/text.hpp"

#include <contact2d.h>

#include <cstdio>
#include <cstring>
#include <new>
#include <unistd.h>

namespace {

int print(const std::string& text) {
  std::string error;
  if (app::write_output("-", text, error)) return app::kExitSolved;
  app::say("contact2d: " + app::shown(error) + "\n");
  return app::kExitFiles;
}

int resume(app::Options options) {
  std::string error;
  const bool quiet = options.quiet;
  const int exit = app::find_job(options, error);
  options.quiet = options.quiet || quiet;
  if (exit == 0) return app::run_deck(options);
  app::say("contact2d: " + app::shown(error) + "\n");
  return exit;
}

int run_command(const app::Options& options) {
  switch (options.command) {
  case app::Command::kRun: return app::run_deck(options);
  case app::Command::kCheck: return app::check_decks(options);
  case app::Command::kMake: return app::make_deck(options);
  case app::Command::kSketch: return app::sketch_drawing(options);
  case app::Command::kMesh: return options.halve ? app::halve_deck(options) : app::write_mesh(options);
  case app::Command::kSweep: return app::sweep_table(options);
  case app::Command::kConvert: return app::convert_deck(options);
  case app::Command::kResume: return resume(options);
  case app::Command::kCompletion: return print(app::completion_text(options.topic));
  case app::Command::kVersion: return print(std::string("contact2d ") + c2d_version() + "\n");
  case app::Command::kHelp: break;
  }
  return print(options.topic == "--man" ? app::man_page(c2d_version()) : app::help_text(options.topic));
}

// Those of --params, before those of --set.
bool take_parameters(app::Options& options, std::string& error) {
  if (options.params.empty()) return true;
  std::string text;
  std::vector<std::string> words;
  error = options.params == "-" ? app::read_text(0, text) : app::read_named(options.params, text);
  if (error.empty()) app::read_parameters(text, words, error);
  if (!error.empty()) error = options.params + ": " + error;
  options.settings.insert(options.settings.begin(), words.begin(), words.end());
  return error.empty();
}

// Where the words of a command are explained.
std::string help_hint(app::Command command) {
  for (const app::CommandRow& row : app::all_commands())
    if (row.command == command && command != app::Command::kHelp)
      return std::string(row.name) + " --help explains this command";
  return "--help lists commands and options";
}

// Writes the failure to the requested response files, unless these exist: the unreadable options may have named another
// file.
int refuse(const app::Options& options, const std::string& error, int exit) {
  app::Options results = options;
  results.row.clear();
  std::string ignored;
  const bool asked = options.command == app::Command::kRun && !options.results.empty();
  if (asked && ::access(options.results.c_str(), F_OK) != 0) app::write_answer(results, {exit, {}, error, {}}, ignored);
  return exit;
}

} // namespace

int main(int argc, char** argv) {
  app::open_standard_files();
  app::catch_interrupts();
  try {
    app::Options options;
    std::string error;
    if (!app::read_options(argc, argv, options, error)) {
      app::say("contact2d: " + app::shown(error) + "\ncontact2d: " + help_hint(options.command) + "\n");
      return refuse(options, error, app::kExitUsage);
    }
    if (!take_parameters(options, error)) return refuse(options, error, app::fail(error, app::kExitInput));
    const int exit = run_command(options);
    return exit == app::kExitSolved && app::pipe_is_broken() ? static_cast<int>(app::kExitPipe) : exit;
  } catch (const std::bad_alloc&) {
    std::fputs("contact2d: error: no memory left\n", stderr);
    return app::kExitMemory;
  }
}
