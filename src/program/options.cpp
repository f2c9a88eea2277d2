#include "program/options.hpp"

#include <c2d_threads.h>
#include <contact2d.h>

#include <cctype>
#include <charconv>
#include <vector>

namespace app {
namespace {

// One option of a command: its name and what it takes.
struct Known {
  const char* name;
  bool takes_value;
};
const Known kRunOptions[] = {{"--points", true},   {"--figures", true},   {"--stepping", true},     {"--quadrature", true},
                             {"--symmetry", true}, {"--memory", true},    {"--store", true},        {"--threads", true},
                             {"--set", true},      {"--progress", false}, {"--no-progress", false}, {"--keep", false},
                             {"--estimate", false}};

bool choose(const std::string& value, const char* first, const char* second, int32_t& choice) {
  if (value != first && value != second) return false;
  choice = value == first ? 0 : 1;
  return true;
}

bool read_threads(const std::string& value, int32_t& threads) {
  const char* end = value.data() + value.size();
  const auto result = std::from_chars(value.data(), end, threads);
  return result.ec == std::errc() && result.ptr == end && threads >= 1 && threads <= C2D_THREADS_MOST;
}

// Takes over one option with its value; false with `error` if the value is none of those allowed.
bool set_option(Options& o, const std::string& name, const std::string& value, std::string& error) {
  const auto wrong = [&](const char* expected) {
    error = name + " " + value + ": expected " + expected;
    return false;
  };
  for (size_t i = 0; i < kOutputs; ++i)
    if (name == kOutputTable[i].option) o.files[i] = value;
  if (name == "--points") o.points = value;
  if (name == "--figures") o.figures = value;
  if (name == "--progress") o.progress = Progress::kAlways;
  if (name == "--no-progress") o.progress = Progress::kNever;
  if (name == "--keep") o.keep = true;
  if (name == "--estimate") o.estimate = true;
  if (name == "--set") o.settings.push_back(value);
  if (name == "--stepping" && !choose(value, "events", "deck", o.stepping)) return wrong("events or deck");
  if (name == "--quadrature" && !choose(value, "accurate", "thesis", o.quadrature)) return wrong("accurate or thesis");
  if (name == "--symmetry" && !choose(value, "deck", "images", o.symmetry)) return wrong("deck or images");
  if (name == "--memory" && (!read_size(value, o.memory) || o.memory == 0))
    return wrong("a number of bytes such as 65536, 64K, 16M or 1G");
  if (name == "--threads" && !read_threads(value, o.threads)) return wrong("a whole number from 1 to 64");
  if (name == "--store") {
    if (value != "memory" && (value.compare(0, 5, "file:") != 0 || value.size() == 5)) return wrong("memory or file:DIR");
    o.store = value;
  }
  return true;
}

bool read_run_option(const std::vector<std::string>& words, size_t& at, Options& options, std::string& error) {
  std::string name = words[at], value;
  const size_t equals = name.find('=');
  const bool joined = equals != std::string::npos;
  if (joined) {
    value = name.substr(equals + 1);
    name.resize(equals);
  }
  std::vector<Known> all(std::begin(kRunOptions), std::end(kRunOptions));
  for (const OutputName& output : kOutputTable) all.push_back({output.option, true});
  for (const Known& known : all) {
    if (name != known.name) continue;
    if (joined && !known.takes_value) {
      error = name + " takes no value";
      return false;
    }
    if (known.takes_value && !joined) {
      if (at + 1 >= words.size()) {
        error = name + " needs a value";
        return false;
      }
      value = words[++at];
    }
    if (known.takes_value && value.empty()) {
      error = name + " needs a value";
      return false;
    }
    options.given.emplace_back(name, value);
    return set_option(options, name, value, error);
  }
  error = "unknown option " + name;
  return false;
}

bool read_distance(const std::string& value, double& distance) {
  const char* end = value.data() + value.size();
  const auto result = std::from_chars(value.data(), end, distance);
  return result.ec == std::errc() && result.ptr == end && distance > 0 && distance < 1e100;
}

bool read_convert_option(const std::vector<std::string>& words, size_t& at, Options& options, std::string& error) {
  std::string name = words[at], value;
  const bool mesh = options.command == Command::kMesh;
  if (mesh && name == "--halve") return options.halve = true;
  const size_t equals = name.find('=');
  if (equals != std::string::npos) {
    value = name.substr(equals + 1);
    name.resize(equals);
  } else if (at + 1 < words.size()) {
    value = words[++at];
  }
  const bool sketch = options.command == Command::kSketch;
  const bool joins = sketch && name == "--join";
  if (name != (mesh ? "--set" : sketch ? "--with" : "--to") && !joins && name != "-o" && name != "--output") {
    error = (mesh ? "mesh" : sketch ? "sketch" : "convert") + std::string(" takes no option ") + name;
    return false;
  }
  if (value.empty()) {
    error = name + " needs a value";
    return false;
  }
  if (name == "--to" && value != "fixed" && value != "free") {
    error = "--to " + value + ": expected fixed or free";
    return false;
  }
  if (joins && !read_distance(value, options.join)) {
    error = "--join " + value + ": expected a distance above 0";
    return false;
  }
  if (joins) return true;
  if (name == "--set")
    options.settings.push_back(value);
  else if (name == "--with")
    options.conditions = value;
  else
    (name == "--to" ? options.convert_to : options.output) = value;
  return true;
}

// Words such as mu=0.3 behind the name of a sketch, for its parameters.
bool takes_settings(Command command) {
  return command == Command::kRun || command == Command::kCheck || command == Command::kMesh;
}

bool read_resume(const std::vector<std::string>& words, Options& options, std::string& error) {
  options.command = Command::kResume;
  for (size_t at = 1; at < words.size(); ++at) {
    const std::string& word = words[at];
    if (word == "--help")
      options.command = Command::kHelp;
    else if (word == "--progress" || word == "--no-progress")
      options.progress = word == "--progress" ? Progress::kAlways : Progress::kNever;
    else if (word.size() > 1 && word[0] == '-')
      error = "resume takes no option " + word;
    else if (!options.folder.empty())
      error = "more than one folder: " + options.folder + " and " + word;
    else
      options.folder = word;
  }
  if (error.empty() && options.folder.empty() && options.command != Command::kHelp) error = "resume needs a folder";
  return error.empty();
}

} // namespace

bool read_size(const std::string& text, uint64_t& bytes) {
  const char* end = text.data() + text.size();
  uint64_t number = 0;
  const auto result = std::from_chars(text.data(), end, number);
  if (result.ec != std::errc() || result.ptr == text.data()) return false;
  std::string unit;
  for (const char* c = result.ptr; c != end; ++c) unit += static_cast<char>(std::toupper(static_cast<unsigned char>(*c)));
  if (unit.size() == 3 && unit.compare(1, 2, "IB") == 0) unit.resize(1);
  if (unit.size() == 2 && unit[1] == 'B') unit.resize(1);
  int shift = 0;
  if (unit == "K")
    shift = 10;
  else if (unit == "M")
    shift = 20;
  else if (unit == "G")
    shift = 30;
  else if (unit == "T")
    shift = 40;
  else if (!unit.empty() && unit != "B")
    return false;
  if (number > (UINT64_MAX >> shift)) return false;
  bytes = number << shift;
  return true;
}

namespace {

// The command of words whose other ones are a deck and options.
bool find_command(const std::string& command, Options& options, std::string& error) {
  const std::pair<const char*, Command> known[] = {{"run", Command::kRun},
                                                   {"check", Command::kCheck},
                                                   {"sketch", Command::kSketch},
                                                   {"mesh", Command::kMesh},
                                                   {"convert", Command::kConvert}};
  for (const auto& [name, which] : known)
    if (command == name) options.command = which;
  if (options.command != Command::kHelp) return true;
  error = "unknown command " + command + ": expected run, check, sketch, mesh, convert, make, resume, --version or --help";
  return false;
}

bool read_option(const std::vector<std::string>& words, size_t& at, Options& options, std::string& error) {
  const std::string name = words[at].substr(0, words[at].find('='));
  if (options.command == Command::kCheck && name != "--symmetry" && name != "--set") {
    error = "check takes no option " + words[at];
    return false;
  }
  const bool converts =
      options.command == Command::kConvert || options.command == Command::kMesh || options.command == Command::kSketch;
  return converts ? read_convert_option(words, at, options, error) : read_run_option(words, at, options, error);
}

// The deck, and options before and behind it; --help makes it the command.
bool read_deck_and_options(const std::vector<std::string>& words, Options& options, std::string& error) {
  bool options_end = false;
  for (size_t at = 1; at < words.size(); ++at) {
    const std::string& word = words[at];
    if (!options_end && word == "--") {
      options_end = true;
    } else if (!options_end && word == "--help") {
      options.command = Command::kHelp;
      return true;
    } else if (!options_end && word.size() > 1 && word[0] == '-') {
      if (!read_option(words, at, options, error)) return false;
    } else if (!options.deck.empty() && takes_settings(options.command) && word.find('=') != std::string::npos) {
      options.settings.push_back(word);
      options.given.emplace_back("--set", word);
    } else if (!options.deck.empty()) {
      error = "more than one deck: " + options.deck + " and " + word;
      return false;
    } else if (word.empty()) {
      error = "the name of the deck is empty";
      return false;
    } else {
      options.deck = word;
    }
  }
  return true;
}

// What is missing, or does not go together.
std::string fault_of(const std::string& command, const Options& options) {
  if (options.deck.empty()) return command + (options.command == Command::kSketch ? " needs a drawing" : " needs a deck");
  if (options.estimate && options.store.compare(0, 5, "file:") == 0)
    return "--estimate with --store " + options.store + ": the halved deck is solved beside it, expected --store memory";
  if (!options.points.empty() && options.file(Output::kInterior).empty() && options.file(Output::kVtk).empty() &&
      !has_listing(options))
    return "--points " + options.points + ": no output shows them, expected --interior, --listing or --vtk";
  return "";
}

} // namespace

bool read_options(int argc, const char* const* argv, Options& options, std::string& error) {
  const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
  if (words.empty()) {
    error = "no command: expected run, check, sketch, mesh, convert, make, resume, --version or --help";
    return false;
  }
  const std::string& command = words[0];
  if (command == "--version" || command == "--help" || command == "-h" || command == "help") {
    options.command = command == "--version" ? Command::kVersion : Command::kHelp;
    return true;
  }
  if (command == "make") {
    options.command = Command::kMake;
    options.words.assign(words.begin() + 1, words.end());
    if (!options.words.empty()) return true;
    error = "make needs the name of a family, or --list";
    return false;
  }
  if (command == "resume") return read_resume(words, options, error);
  if (!find_command(command, options, error) || !read_deck_and_options(words, options, error)) return false;
  if (options.command != Command::kHelp) error = fault_of(command, options);
  return error.empty();
}

bool has_listing(const Options& o) {
  if (!o.file(Output::kListing).empty()) return true;
  for (const std::string& name : o.files)
    if (name == "-") return false;
  return true;
}

const std::array<OutputName, kOutputs> kOutputTable = {{
    {"--listing", "printed results; default: standard output, unless another output is sent there"},
    {"--csv", "contact results, a row per pair and recorded step"},
    {"--boundary", "CSV of every element end of every body at the last step"},
    {"--interior", "CSV of displacements and stresses inside, at the points asked for, at the last step"},
    {"--json", "summary of the run"},
    {"--report", "one HTML page with pictures of the model and the results"},
    {"--vtk", "boundary with displacements, tractions and stresses at the last step, and the points\n"
              "                     inside, for ParaView"},
    {"--trace", "CSV of every change of status: load, pair, from, to, why"},
    {"--bodies", "CSV of every body: contact force and moment, and how a rigid one moved, by step"},
    {"--summary", "CSV of what sums up the contact, by step: pressures, edges, stick borders, resultants"},
}};

namespace {

const char kHelpBefore[] =
    "usage: contact2d run DECK [NAME=VALUE ...] [options]\n"
    "       contact2d check DECK [NAME=VALUE ...] [--symmetry deck|images]\n"
    "       contact2d sketch DRAWING [--with FILE] [--join D] [-o FILE]\n"
    "       contact2d mesh SKETCH [NAME=VALUE ...] [--halve] [-o FILE]\n"
    "       contact2d resume DIR\n"
    "       contact2d convert DECK [--to fixed|free] [-o FILE]\n"
    "       contact2d make NAME key=value ...\n"
    "       contact2d make --list\n"
    "       contact2d --version | --help\n"
    "\n"
    "run solves a deck, check reads and validates it and tells the memory it needs, convert writes it "
    "in the "
    "other\n"
    "form (fixed columns or free) without changing a number. DECK may be - for standard input.\n"
    "A DECK may be a sketch: shapes without a mesh; NAME=VALUE is for its parameters. mesh writes the deck that is made of "
    "it;\n"
    "with --halve, which takes decks too, with every element cut in two.\n"
    "sketch begins a sketch from a drawing (DXF or MSH, ASCII); --with FILE adds the statements of a file to it,\n"
    "--join D takes ends of curves up to a distance D for one.\n"
    "make writes the deck of a problem known by name to standard output; --list tells names and keys.\n"
    "\n"
    "resume goes on after a crash of a run with --store file:DIR: the deck, the options and the tapes are in DIR;\n"
    "outputs are written whole.\n"
    "\n"
    "options of run:\n";

const char kHelpAfter[] =
    "  --points FILE      CSV body,x,y of points inside, instead of those under *POINTS in the deck; - for "
    "standard\n"
    "                     input\n"
    "  --figures DIR      the pictures of --report as single SVG files\n"
    "  --stepping WORD    events (default): follow every change of status; deck: the increments of the "
    "deck\n"
    "  --quadrature WORD  accurate (default) or thesis: the rule of 2, 4 and 10 points\n"
    "  --symmetry WORD    deck (default): elements on a line of symmetry are kept; images: they are replaced by\n"
    "                     images\n"
    "  --memory SIZE      bytes of workspace, as 65536, 64K, 16M, 1G; default: all in memory, at most "
    "half of\n"
    "                     what is free\n"
    "  --store WHERE      memory, or file:DIR; default: memory if it fits, else a folder under $TMPDIR\n"
    "  --threads N        tasks at once in assembly, elimination and at interior points, 1 to 64; default 1. No\n"
    "                     result depends on it\n"
    "  --set NAME=VALUE   the value of a parameter of a sketch, instead of the one that stands there\n"
    "  --estimate         solve the deck once more with every element cut in two, and state errors\n"
    "  --progress, --no-progress\n"
    "                     a line on standard error; default: only on a terminal\n"
    "  --keep             leave the tapes in their folder\n"
    "FILE may be - for standard output.\n"
    "\n"
    "exit status: 0 solved; 1 no further or no unique solution; 2 bad deck; 3 block store or output "
    "file failed;\n"
    "4 workspace too small; 64 bad usage; 130 cancelled\n";

} // namespace

std::string help_text() {
  std::string text = kHelpBefore;
  for (const OutputName& output : kOutputTable) {
    std::string name = std::string("  ") + output.option + " FILE";
    name.resize(21, ' ');
    text += name + output.help + "\n";
  }
  return text + kHelpAfter;
}

} // namespace app
