#include "program/commands/commands.hpp"

#include "program/commands/families.hpp"
#include "program/exit_code.hpp"
#include "program/files/output_file.hpp"
#include "program/words/voice.hpp"
#include "report/text.hpp"

#include <sstream>

namespace app {
namespace {

int print(const std::string& text) {
  std::string error;
  if (write_output("-", text, error)) return kExitSolved;
  say("contact2d: " + shown(error) + "\n");
  return kExitFiles;
}

} // namespace

int make_deck(const Options& options) {
  const std::string& name = options.words.front();
  const std::vector<std::string> settings(options.words.begin() + 1, options.words.end());
  if (name == "--list" && settings.empty()) return print(families::list_families());
  const families::Family* family = families::find_family(name);
  if (family != nullptr && settings.size() == 1 && (settings[0] == "--help" || settings[0] == "-h"))
    return print(families::describe(*family));
  std::string deck, error;
  if (families::make_deck(name, settings, deck, error)) return print(deck);
  std::istringstream lines(error);
  std::string text;
  for (std::string line; std::getline(lines, line);) text += (text.empty() ? "contact2d: " : "") + shown(line) + "\n";
  say(text);
  return kExitUsage;
}

} // namespace app
