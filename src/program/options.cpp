#include "program/options.hpp"

#include "program/option_table.hpp"
#include "program/words/near_word.hpp"
#include "program/words/read_number.hpp"

#include <c2d_threads.h>
#include <contact2d.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <sys/stat.h>
#include <vector>

namespace app {
namespace {

// A file that is standard output, as /dev/stdout, is "-": others may have written into it, and it is not to be replaced.
std::string output_name(const std::string& name) {
  struct stat file = {}, standard = {};
  const bool regular = ::stat(name.c_str(), &file) == 0 && S_ISREG(file.st_mode) && file.st_ino != 0;
  const bool same = regular && ::fstat(1, &standard) == 0 && standard.st_dev == file.st_dev && standard.st_ino == file.st_ino;
  return same ? "-" : name;
}

// "events or deck"
std::string listed(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " or ") + word;
  return out;
}

// What is stored as it is given; an option without a value sets its member.
void set_name(Options& o, const std::string& name, const std::string& value) {
  const std::pair<const char*, std::string Options::*> names[] = {
      {"--points", &Options::points},   {"--figures", &Options::figures}, {"--out", &Options::out},
      {"--with", &Options::conditions}, {"--output", &Options::output},   {"--params", &Options::params},
      {"--results", &Options::results}, {"--row", &Options::row},         {"--to", &Options::convert_to}};
  const std::pair<const char*, bool Options::*> switches[] = {{"--keep", &Options::keep},
                                                              {"--estimate", &Options::estimate},
                                                              {"--halve", &Options::halve},
                                                              {"--quiet", &Options::quiet},
                                                              {"--resume", &Options::resume}};
  for (const auto& [option, member] : names)
    if (name == option) o.*member = value;
  for (const auto member : {&Options::output, &Options::results, &Options::row}) o.*member = output_name(o.*member);
  for (const auto& [option, member] : switches)
    if (name == option) o.*member = true;
  for (size_t i = 0; i < kOutputs; ++i)
    if (name == kOutputTable[i].option) o.files[i] = output_name(value);
  if (name == "--set") o.settings.push_back(value);
  if (name == "--progress") o.progress = Progress::kAlways;
  if (name == "--no-progress") o.progress = Progress::kNever;
}

// One of the words of its value, which are counted from 0.
void set_choice(Options& o, const std::string& name, int32_t choice) {
  if (name == "--stepping") o.stepping = choice;
  if (name == "--quadrature") o.quadrature = choice;
  if (name == "--symmetry") o.symmetry = choice;
  if (name == "--elimination") o.elimination = choice;
}

// Reads a number within bounds.
template <class Number> bool read_between(const std::string& value, Number least, Number most, Number& number) {
  return read_number(value, number) && number >= least && number <= most;
}

// Takes over one option with its value; false with `error` if the value is none of those allowed.
bool set_option(Options& o, const OptionRow& row, const std::string& value, std::string& error) {
  const std::string name = row.name;
  const auto wrong = [&](const std::string& expected) {
    error = name + " " + value + ": expected " + expected;
    return false;
  };
  if (const std::vector<std::string> words = words_of_value(row); !words.empty()) {
    const auto found = std::find(words.begin(), words.end(), value);
    if (found == words.end()) return wrong(listed(words));
    set_choice(o, name, static_cast<int32_t>(found - words.begin()));
  }
  set_name(o, name, value);
  if (name == "--memory" && (!read_size(value, o.memory) || o.memory == 0))
    return wrong("a number of bytes such as 65536, 64K, 16M or 1G");
  if (name == "--save-every" && !read_between(value, 0.0, 1e9, o.save_every)) return wrong("a number of seconds, 0 or more");
  if (name == "--threads" && !read_between<int32_t>(value, 1, C2D_THREADS_MOST, o.threads))
    return wrong("a whole number from 1 to 64");
  if (name == "--touching" && !read_between(value, 0, INT32_MAX, o.touching))
    return wrong("a whole number of pairs, 0 for all");
  if (name == "--response" && !read_responses(value, o.responses, error)) return error = name + " " + error, false;
  if (name == "--join" && !(read_number(value, o.join) && o.join > 0 && o.join < 1e100)) return wrong("a distance above 0");
  if (name == "--store") {
    if (value != "memory" && (value.compare(0, 5, "file:") != 0 || value.size() == 5)) return wrong("memory or file:DIR");
    o.store = value;
  }
  return true;
}

// One option of `command` at words[at], with the word behind it if its value stands there.
bool read_option(const CommandRow& command, const std::vector<std::string>& words, size_t& at, Options& options,
                 std::string& error) {
  std::string name = words[at], value;
  const size_t equals = name.find('=');
  const bool joined = equals != std::string::npos;
  if (joined) {
    value = name.substr(equals + 1);
    name.resize(equals);
  }
  const OptionRow* row = find_option(command.command, name);
  if (row == nullptr)
    return error = std::string(command.name) + " takes no option " + name + did_you_mean(name, option_names(command.command)),
           false;
  if (joined && row->value == nullptr) return error = name + " takes no value", false;
  if (row->value != nullptr && !joined && at + 1 < words.size()) value = words[++at];
  if (row->value != nullptr && value.empty()) return error = name + " needs a value", false;
  options.given.emplace_back(row->name, value);
  return set_option(options, *row, value, error);
}

// Words such as mu=0.3 behind the name of a sketch, for its parameters.
bool takes_settings(Command command) {
  return command == Command::kRun || command == Command::kCheck || command == Command::kMesh || command == Command::kSweep;
}

} // namespace

bool read_size(const std::string& text, uint64_t& bytes) {
  const char* end = text.data() + text.size();
  uint64_t number = 0;
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc()) return false;
  std::string unit;
  for (const char* c = result.ptr; c != end; ++c) unit += static_cast<char>(std::toupper(static_cast<unsigned char>(*c)));
  if (unit.size() == 3 && unit.compare(1, 2, "IB") == 0) unit.resize(1);
  if (unit.size() == 2 && unit[1] == 'B') unit.resize(1);
  const size_t power = unit.empty() ? 0 : std::string_view("BKMGT").find(unit[0]);
  if (unit.size() > 1 || power == std::string_view::npos) return false;
  const size_t shift = 10 * power;
  if (number > (UINT64_MAX >> shift)) return false;
  bytes = number << shift;
  return true;
}

namespace {

bool asks_for_help(const std::string& word) { return word == "--help" || word == "-h"; }

// A word that is no option: the deck, the folder, a parameter of a sketch.
bool take_word(const std::string& word, Options& options, std::string& error) {
  const bool table = options.command == Command::kSweep && options.table.empty();
  std::string& first = options.command == Command::kResume ? options.folder : table ? options.table : options.deck;
  if (!first.empty() && takes_settings(options.command) && word.find('=') != std::string::npos) {
    options.settings.push_back(word);
    options.given.emplace_back("--set", word);
  } else if (!first.empty() && options.command == Command::kCheck) {
    options.more_decks.push_back(word);
  } else if (!first.empty()) {
    error = std::string(options.command == Command::kResume ? "more than one folder: " : "more than one deck: ") + first +
            " and " + word;
    return false;
  } else {
    first = word;
  }
  return true;
}

// Words and options in any order; --help makes it the command.
bool read_words(const CommandRow& command, const std::vector<std::string>& words, Options& options, std::string& error) {
  bool options_end = false;
  for (size_t at = 1; at < words.size(); ++at) {
    const std::string& word = words[at];
    if (!options_end && word == "--") {
      options_end = true;
    } else if (!options_end && asks_for_help(word)) {
      options.command = Command::kHelp;
      options.topic = command.name;
      return true;
    } else if (!options_end && word.size() > 1 && word[0] == '-') {
      if (!read_option(command, words, at, options, error)) return false;
    } else if (!take_word(word, options, error)) {
      return false;
    }
  }
  return true;
}

// The folder of --out has a file of each kind that has no name of its own.
void spread_out(Options& o) {
  if (o.out.empty()) return;
  o.interior_if_any = o.file(Output::kInterior).empty() && o.points.empty();
  for (size_t i = 0; i < kOutputs; ++i)
    if (o.files[i].empty() && kOutputTable[i].file != nullptr) o.files[i] = o.out + "/" + kOutputTable[i].file;
  if (o.figures.empty()) o.figures = o.out + "/figures";
}

// What is missing, or does not go together.
std::string fault_of(const std::string& command, const Options& options) {
  if (options.command == Command::kResume) return options.folder.empty() ? "resume needs a folder" : "";
  if (options.command == Command::kSweep && options.deck.empty()) return "sweep needs a table and a deck";
  const bool goes = !options.results.empty() || !options.row.empty();
  if (options.responses.empty() && (goes || options.command == Command::kSweep))
    return command + " needs the requested numbers, expected --response LIST";
  if (options.command == Command::kRun && !options.responses.empty() && !goes)
    return "--response: no output for the numbers, expected --results FILE or --row FILE";
  if (options.deck.empty()) return command + (options.command == Command::kSketch ? " needs a drawing" : " needs a deck");
  if (options.estimate && options.store.compare(0, 5, "file:") == 0)
    return "--estimate with --store " + options.store +
           ": the deck is also solved with halved elements, expected --store memory";
  const bool saves = std::any_of(options.given.begin(), options.given.end(),
                                 [](const auto& option) { return option.first == "--save-every"; });
  if (saves && options.store.compare(0, 5, "file:") != 0)
    return "--save-every: no folder for saved states, expected --store file:DIR";
  if (!options.points.empty() && options.responses.empty() && options.file(Output::kInterior).empty() &&
      options.file(Output::kVtk).empty() && options.file(Output::kStresses).empty() && options.file(Output::kRanges).empty() &&
      !has_listing(options))
    return "--points " + options.points +
           ": no output uses the points, expected --interior, --stresses, --ranges, --listing or --vtk";
  return "";
}

// Of help, completion and make, whose words are their own.
bool read_own_words(const std::vector<std::string>& words, Options& options, std::string& error) {
  const bool help = words.size() > 1 && asks_for_help(words.back()) && words.size() == 2;
  if (options.command == Command::kHelp || help) {
    options.topic = help ? words[0] : words.size() > 1 ? words[1] : "";
    options.command = Command::kHelp;
    if (!options.topic.empty() && options.topic != "--man" && find_command(options.topic) == nullptr)
      error = "help: unknown command " + options.topic + did_you_mean(options.topic, command_names());
  } else if (options.command == Command::kMake) {
    options.words.assign(words.begin() + 1, words.end());
    if (options.words.empty()) error = "make needs the name of a family, or --list";
  } else {
    options.topic = words.size() == 2 ? words[1] : "";
    if (options.topic != "bash" && options.topic != "zsh" && options.topic != "fish")
      error = "completion: expected one of bash, zsh and fish";
  }
  return error.empty();
}

// Is a word in the place of a command the deck or sketch to be run: a file that exists, or a path or a name with an extension?
bool is_input(const std::string& word) {
  if (word.empty() || word[0] == '-') return false;
  std::error_code none;
  return word.find_first_of("./") != std::string::npos || std::filesystem::is_regular_file(std::filesystem::u8path(word), none);
}

} // namespace

bool read_options(int argc, const char* const* argv, Options& options, std::string& error) {
  std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  std::string known;
  for (const std::string& name : command_names()) known += name + ", ";
  known += "--version or --help";
  if (words.empty()) return error = "no command: expected " + known, false;
  if (words[0] == "--version" || words[0] == "-V" || asks_for_help(words[0])) {
    options.command = asks_for_help(words[0]) ? Command::kHelp : Command::kVersion;
    return true;
  }
  if (find_command(words[0]) == nullptr && is_input(words[0])) words.insert(words.begin(), "run");
  const CommandRow* command = find_command(words[0]);
  if (command == nullptr) {
    const std::string near = did_you_mean(words[0], command_names());
    error = "unknown command " + words[0] + (near.empty() ? ": expected a file, " + known : near);
    return false;
  }
  options.command = command->command;
  if (command->command >= Command::kMake) return read_own_words(words, options, error);
  if (!read_words(*command, words, options, error)) return false;
  if (options.command == Command::kHelp) return true;
  spread_out(options);
  error = fault_of(command->name, options);
  return error.empty();
}

bool has_listing(const Options& o) {
  if (!o.file(Output::kListing).empty()) return true;
  if (o.results == "-" || o.command == Command::kSweep) return false;
  if (o.quiet) return false;
  for (const std::string& name : o.files)
    if (name == "-") return false;
  return true;
}

} // namespace app
