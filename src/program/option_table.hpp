// Commands and options of the program, one row each. The parser of the command line, the help and the shell completions all
// use these tables.
#pragma once

#include "program/options.hpp"

#include <string>
#include <vector>

namespace app {

struct CommandRow {
  const char* name;
  Command command;
  const char* words; // arguments after the name, options excepted
  const char* help;
};

struct OptionRow {
  const char* name;  // --csv
  const char* brief; // short form (-o), or null
  const char* value; // FILE, DIR, SIZE, or the permitted words (events|deck); null: no value
  uint32_t commands; // bit_of each command that accepts it
  const char* help;
};

struct StatusRow { // an exit status
  int status;
  const char* meaning;
};

constexpr uint32_t bit_of(Command command) { return 1u << static_cast<unsigned>(command); }

const std::vector<CommandRow>& all_commands();
const std::vector<OptionRow>& all_options();
const std::vector<StatusRow>& all_statuses();

std::vector<std::string> command_names();
std::vector<std::string> option_names(Command command); // the long ones
// Null if there is no such command.
const CommandRow* find_command(const std::string& name);
// The option of `command` with this long or short name; null if it has none.
const OptionRow* find_option(Command command, const std::string& name);
// The words of a list such as "events|deck"; empty if the value is no such list.
std::vector<std::string> words_of_value(const OptionRow& option);

// The text of --help, for all commands or for one.
std::string help_text(const std::string& command = "");

} // namespace app
