// Commands and options of the program, each in one row: what the command line is read by, and what help and the completions of
// shells are made from.
#pragma once

#include "program/options.hpp"

#include <string>
#include <vector>

namespace app {

struct CommandRow {
  const char* name;
  Command command;
  const char* words; // what stands behind it beside options
  const char* help;
};

struct OptionRow {
  const char* name;  // --csv
  const char* brief; // -o; null: there is none
  const char* value; // FILE, DIR, SIZE, events|deck ...: one of these words; null: it takes no value
  uint32_t commands; // bit_of each that takes it
  const char* help;
};

constexpr uint32_t bit_of(Command command) { return 1u << static_cast<unsigned>(command); }

const std::vector<CommandRow>& all_commands();
const std::vector<OptionRow>& all_options();

// null: there is no such command.
const CommandRow* find_command(const std::string& name);
// Of `command`, by either name; null: it has none such.
const OptionRow* find_option(Command command, const std::string& name);
// "events|deck" as its words; empty for anything that is not such a list.
std::vector<std::string> words_of_value(const OptionRow& option);

// What --help prints; with the name of a command what there is to know of it.
std::string help_text(const std::string& command = "");

} // namespace app
