#include "program/commands/commands.hpp"

#include "program/commands/families.hpp"
#include "program/option_table.hpp"

namespace app {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

std::string family_names() {
  std::string out;
  for (const families::Family& family : families::all_families()) out += (out.empty() ? "" : " ") + std::string(family.name);
  return out;
}

bool takes(const CommandRow& command, const OptionRow& option) { return (option.commands & bit_of(command.command)) != 0; }

// The arguments of `compgen` that complete the value of an option.
std::string bash_values(const OptionRow& option) {
  const std::string value = option.value;
  if (const std::vector<std::string> words = words_of_value(option); !words.empty()) return "-W '" + joined(words) + "'";
  if (value == "FILE") return "-f";
  if (value == "DIR") return "-d";
  if (value == "WHERE") return "-W 'memory file:'";
  return "-W ''";
}

std::string bash() {
  std::string out = "# contact2d, for bash: source this file, or copy it to the folder of bash completions.\n_contact2d() {\n"
                    "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}\n"
                    "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    COMPREPLY=($(compgen -W '" +
                    joined(command_names()) +
                    " --version --help' -- \"$word\"))\n    [ -n \"$word\" ] && COMPREPLY+=($(compgen -f -- \"$word\"))\n"
                    "    return\n  fi\n  case $before in\n";
  for (const OptionRow& option : all_options()) {
    if (option.value == nullptr) continue;
    out += "  " + (option.brief != nullptr ? std::string(option.brief) + "|" : std::string()) + option.name +
           ") COMPREPLY=($(compgen " + bash_values(option) + " -- \"$word\")); return ;;\n";
  }
  out += "  esac\n  case $command in\n";
  for (const CommandRow& command : all_commands()) {
    std::string words;
    for (const OptionRow& option : all_options())
      if (takes(command, option)) words += std::string(option.name) + " ";
    const bool has_words = command.command >= Command::kMake;
    if (command.command == Command::kMake) words += family_names();
    if (command.command == Command::kHelp) words = joined(command_names());
    if (command.command == Command::kCompletion) words = "bash zsh fish";
    out += std::string("  ") + command.name + ") COMPREPLY=($(compgen " + (has_words ? "" : "-f ") + "-W '" + words +
           (command.command == Command::kHelp ? "" : " --help") + "' -- \"$word\")) ;;\n";
  }
  return out + "  esac\n}\ncomplete -o filenames -F _contact2d contact2d\n";
}

// Text between single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string zsh_option(const OptionRow& option) {
  const std::string value = option.value != nullptr ? option.value : "";
  std::string action;
  if (const std::vector<std::string> words = words_of_value(option); !words.empty())
    action = "(" + joined(words) + ")";
  else if (value == "FILE")
    action = "_files";
  else if (value == "DIR")
    action = "_files -/";
  else if (value == "WHERE")
    action = "(memory file\\:)";
  std::string help;
  for (const char c : std::string(option.help))
    help += c == ':' ? std::string("\\:") : std::string(1, c); // (there are no brackets in help)
  std::string text = std::string(option.name) + (option.value != nullptr ? "=" : "") + "[" + help + "]";
  if (option.value != nullptr) text += ":" + value.substr(0, value.find('|')) + ":" + action;
  return quoted(text);
}

std::string zsh() {
  std::string out = "#compdef contact2d\n# contact2d, for zsh: copy it as _contact2d to a folder of $fpath.\n_contact2d() {\n"
                    "  local -a commands\n  commands=(\n";
  for (const CommandRow& command : all_commands())
    out += "    " + quoted(std::string(command.name) + ":" + command.help) + "\n";
  out += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    [[ -n $PREFIX ]] && _files\n    return\n  "
         "fi\n  local command=$words[2]\n"
         "  shift words; (( CURRENT-- ))\n  case $command in\n";
  for (const CommandRow& command : all_commands()) {
    out += std::string("  ") + command.name + ") _arguments -S '--help[print the help of this command]'";
    for (const OptionRow& option : all_options())
      if (takes(command, option)) out += " \\\n    " + zsh_option(option);
    std::string rest = "'*:file:_files'";
    if (command.command == Command::kMake) rest = "'1:family:(" + family_names() + ")'";
    if (command.command == Command::kHelp) rest = "'1:command:(" + joined(command_names()) + ")'";
    if (command.command == Command::kCompletion) rest = "'1:shell:(bash zsh fish)'";
    out += " \\\n    " + rest + " ;;\n";
  }
  return out + "  esac\n}\n_contact2d \"$@\"\n";
}

std::string fish() {
  std::string out = "# contact2d, for fish: copy it as contact2d.fish to the folder of fish completions.\n";
  const std::string begin = "complete -c contact2d ";
  for (const CommandRow& command : all_commands())
    out += begin + "-n __fish_use_subcommand -a " + command.name + " -d " + quoted(command.help) + "\n";
  for (const OptionRow& option : all_options()) {
    std::string commands;
    for (const CommandRow& command : all_commands())
      if (takes(command, option)) commands += std::string(" ") + command.name;
    out += begin + "-n '__fish_seen_subcommand_from" + commands + "' -l " + (option.name + 2);
    if (option.brief != nullptr) out += std::string(" -s ") + (option.brief + 1);
    const std::vector<std::string> words = words_of_value(option);
    if (option.value != nullptr) out += words.empty() ? " -r" : " -x -a " + quoted(joined(words));
    out += " -d " + quoted(option.help) + "\n";
  }
  out += begin + "-n '__fish_seen_subcommand_from make' -f -a " + quoted(family_names()) + "\n";
  out += begin + "-n '__fish_seen_subcommand_from completion' -f -a 'bash zsh fish'\n";
  return out + begin + "-n '__fish_seen_subcommand_from help' -f -a " + quoted(joined(command_names())) + "\n";
}

} // namespace

std::string completion_text(const std::string& shell) { return shell == "bash" ? bash() : shell == "zsh" ? zsh() : fish(); }

} // namespace app
