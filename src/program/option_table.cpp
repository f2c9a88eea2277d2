#include "program/option_table.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr uint32_t kRun = bit_of(Command::kRun), kCheck = bit_of(Command::kCheck), kMesh = bit_of(Command::kMesh),
                   kSketch = bit_of(Command::kSketch), kConvert = bit_of(Command::kConvert), kMake = bit_of(Command::kMake),
                   kResume = bit_of(Command::kResume), kSweep = bit_of(Command::kSweep);

const CommandRow kCommands[] = {
    {"run", Command::kRun, "DECK [NAME=VALUE ...]",
     "solves a deck, or a sketch: shapes without a mesh. NAME=VALUE is for the parameters of a sketch, and for {NAME} in a "
     "deck"},
    {"check", Command::kCheck, "DECK ... [NAME=VALUE ...]", "reads and validates decks and tells the memory that they need"},
    {"sketch", Command::kSketch, "DRAWING", "begins a sketch from a drawing (DXF or MSH, ASCII)"},
    {"mesh", Command::kMesh, "SKETCH [NAME=VALUE ...]", "writes the deck that is made of a sketch"},
    {"resume", Command::kResume, "DIR",
     "goes on where a run with --store file:DIR was cut off: the deck, the options, the tapes and the saved state are in DIR; "
     "outputs are written whole"},
    {"sweep", Command::kSweep, "TABLE DECK [NAME=VALUE ...]",
     "solves a deck or a sketch once for every row of a table (CSV; its heading names parameters) and writes a table of "
     "results"},
    {"convert", Command::kConvert, "DECK", "writes a deck in the other form (fixed columns or free) without changing a number"},
    {"make", Command::kMake, "NAME key=value ...", "writes the deck of a problem known by name to standard output"},
    {"completion", Command::kCompletion, "bash|zsh|fish", "writes what that shell completes commands and options by"},
    {"help", Command::kHelp, "[COMMAND]", "tells commands and options, of one command or of all"},
};

const OptionRow kOptions[] = {
    {"--listing", nullptr, "FILE", kRun,
     "printed results; default: standard output, unless another output is sent there. On a terminal that nobody asked for a "
     "listing its end alone is shown"},
    {"--csv", nullptr, "FILE", kRun, "contact results, a row per pair and recorded step"},
    {"--boundary", nullptr, "FILE", kRun, "CSV of every element end of every body at the last step"},
    {"--interior", nullptr, "FILE", kRun,
     "CSV of displacements and stresses inside, at the points asked for, at the last step"},
    {"--json", nullptr, "FILE", kRun, "summary of the run"},
    {"--report", nullptr, "FILE", kRun, "one HTML page with pictures of the model and the results"},
    {"--vtk", nullptr, "FILE", kRun,
     "boundary with displacements, tractions and stresses at the last step, and the points inside, for ParaView"},
    {"--trace", nullptr, "FILE", kRun, "CSV of every change of status: load, pair, from, to, why"},
    {"--bodies", nullptr, "FILE", kRun, "CSV of every body: contact force and moment, and how a rigid one moved, by step"},
    {"--summary", nullptr, "FILE", kRun,
     "CSV of what sums up the contact, by step: pressures, edges, stick borders, resultants"},
    {"--stresses", nullptr, "FILE", kRun,
     "CSV of stresses at every element end of every body and at the points inside, at every recorded step"},
    {"--ranges", nullptr, "FILE", kRun,
     "CSV of how far stresses go at these places in the last cycle of the loads, or in all recorded steps if there is none"},
    {"--points", nullptr, "FILE", kRun | kSweep,
     "CSV body,x,y of points inside, instead of those under *POINTS in the deck; - for standard input"},
    {"--figures", nullptr, "DIR", kRun, "the pictures of --report as single SVG files"},
    {"--out", nullptr, "DIR", kRun,
     "all of these outputs in one folder, but for those that have a name of their own, and --stresses and --ranges"},
    {"--stepping", nullptr, "events|deck", kRun | kSweep,
     "events (default): follow every change of status; deck: the increments of the deck"},
    {"--quadrature", nullptr, "accurate|thesis", kRun | kSweep, "accurate (default) or thesis: the rule of 2, 4 and 10 points"},
    {"--symmetry", nullptr, "deck|images", kRun | kCheck | kSweep,
     "deck (default): elements on a line of symmetry are kept; images: they are replaced by images"},
    {"--elimination", nullptr, "dense|compressed|size", kRun | kCheck | kSweep,
     "compressed: time and memory grow with the number of nodes, not with its cube and square as dense; size (default): "
     "compressed where a body has more than 800 nodes and one for two pairs"},
    {"--touching", nullptr, "N", kRun | kCheck | kSweep,
     "pairs that may touch, or nearly, at once, 0 for all: where there are more, columns of the contact system are made when "
     "pairs are about to touch; default: a fifth of more than 1500 pairs, and all where that cannot be or is too little"},
    {"--memory", nullptr, "SIZE", kRun | kSweep,
     "bytes of workspace, as 65536, 64K, 16M, 1G; default: all in memory, at most half of what is free; compressed: what it "
     "needs"},
    {"--store", nullptr, "WHERE", kRun, "memory, or file:DIR; default: memory if it fits, else a folder under $TMPDIR"},
    {"--threads", nullptr, "N", kRun | kSweep,
     "tasks at once in assembly, elimination and at interior points, 1 to 64; default 1; of sweep: rows at once, default as "
     "many "
     "as the machine has processors. No result depends on it"},
    {"--set", nullptr, "NAME=VALUE", kRun | kCheck | kMesh | kSweep,
     "the value of a parameter, instead of the one that stands there; behind the file's name NAME=VALUE is enough"},
    {"--params", nullptr, "FILE", kRun | kCheck | kMesh | kSweep,
     "values of parameters, a line each, NAME = VALUE, or a file of parameters of Dakota; --set goes before it"},
    {"--response", nullptr, "LIST", kRun | kSweep,
     "numbers that are asked for, with semicolons between them: \"max tn; contact edge 1\""},
    {"--results", nullptr, "FILE", kRun | kSweep,
     "these numbers, a line each; if the run fails a line that begins with FAIL and tells why; of sweep: the table of all "
     "rows"},
    {"--row", nullptr, "FILE", kRun, "appends a row to a CSV file: what became of the run, its parameters, these numbers"},
    {"--resume", nullptr, nullptr, kSweep, "of a sweep that was cut off the rows that are missing"},
    {"--estimate", nullptr, nullptr, kRun, "solve the deck once more with every element cut in two, and state errors"},
    {"--progress", nullptr, nullptr, kRun | kResume | kSweep,
     "a line on standard error that tells how far the run is; default: only on a terminal"},
    {"--no-progress", nullptr, nullptr, kRun | kResume | kSweep, "no such line"},
    {"--keep", nullptr, nullptr, kRun, "leave the tapes in their folder"},
    {"--save-every", nullptr, "SECONDS", kRun,
     "with --store file:DIR: how often the state of the path is saved; default 2, and at most 1/60 of the time; 0: at every "
     "recorded load"},
    {"--quiet", "-q", nullptr, kRun | kCheck | kResume | kSweep,
     "errors alone on the terminal: neither warnings nor, unless asked for, a listing"},
    {"--with", nullptr, "FILE", kSketch, "adds the statements of a file"},
    {"--join", nullptr, "D", kSketch, "takes ends of curves up to a distance D for one"},
    {"--halve", nullptr, nullptr, kMesh, "takes decks, too, and writes the deck with every element cut in two"},
    {"--to", nullptr, "fixed|free", kConvert, "the form to write; default: the other one"},
    {"--output", "-o", "FILE", kSketch | kMesh | kConvert, "where to; default: standard output"},
    {"--list", nullptr, nullptr, kMake, "tells names and keys"},
};

const char kNotes[] =
    "DECK, and FILE of what is read, may be - for standard input; FILE of what is written - for standard output.\n";
const char kStatuses[] =
    "exit status: 0 solved; 1 no further or no unique solution; 2 bad deck; 3 block store or output file failed;\n"
    "4 workspace too small; 64 bad usage; 75 store or sweep in use by another process; 130 cancelled;\n"
    "143 ended by SIGTERM, resume goes on\n";
constexpr size_t kMargin = 23, kWidth = 110;

// `name`, and `text` beside it, on lines of kWidth.
void append_row(std::string& out, const std::string& name, const std::string& text) {
  std::string line = "  " + name;
  if (line.size() > kMargin - 2) {
    out += line + "\n";
    line.clear();
  }
  line.resize(kMargin, ' ');
  bool begun = false;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(' ', at), text.size());
    if (begun && line.size() + 1 + (end - at) > kWidth) {
      out += line + "\n";
      line.assign(kMargin, ' ');
      begun = false;
    }
    line += (begun ? " " : "") + text.substr(at, end - at);
    begun = true;
    at = end + 1;
  }
  out += line + "\n";
}

void append_option(std::string& out, const OptionRow& option) {
  std::string name = option.brief != nullptr ? std::string(option.brief) + ", " : std::string();
  name += option.name;
  if (option.value != nullptr) name += std::string(" ") + option.value;
  append_row(out, name, option.help);
}

std::string help_of(const CommandRow& row) {
  const auto is_its = [&row](const OptionRow& option) { return (option.commands & bit_of(row.command)) != 0; };
  const bool any = std::any_of(std::begin(kOptions), std::end(kOptions), is_its);
  std::string out = std::string("usage: contact2d ") + row.name + " " + row.words + (any ? " [options]" : "") + "\n\n";
  append_row(out, row.name, row.help);
  if (any) out += "\n";
  for (const OptionRow& option : kOptions)
    if (is_its(option)) append_option(out, option);
  return out;
}

} // namespace

const std::vector<CommandRow>& all_commands() {
  static const std::vector<CommandRow> all(std::begin(kCommands), std::end(kCommands));
  return all;
}

const std::vector<OptionRow>& all_options() {
  static const std::vector<OptionRow> all(std::begin(kOptions), std::end(kOptions));
  return all;
}

const CommandRow* find_command(const std::string& name) {
  for (const CommandRow& row : all_commands())
    if (name == row.name) return &row;
  return nullptr;
}

const OptionRow* find_option(Command command, const std::string& name) {
  for (const OptionRow& row : all_options()) {
    const bool called = name == row.name || (row.brief != nullptr && name == row.brief);
    if (called && (row.commands & bit_of(command)) != 0) return &row;
  }
  return nullptr;
}

std::vector<std::string> words_of_value(const OptionRow& option) {
  std::vector<std::string> words;
  const std::string value = option.value != nullptr ? option.value : "";
  for (size_t at = 0; value.find('|') != std::string::npos && at <= value.size();) {
    const size_t end = std::min(value.find('|', at), value.size());
    words.push_back(value.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

std::string help_text(const std::string& command) {
  if (const CommandRow* row = find_command(command); row != nullptr && row->command != Command::kHelp) return help_of(*row);
  std::string out = "usage: contact2d COMMAND ...\n\n";
  for (const CommandRow& row : kCommands) append_row(out, std::string(row.name) + " " + row.words, row.help);
  append_row(out, "-V, --version", "tells the version");
  append_row(out, "-h, --help", "behind a command: tells of it alone");
  for (const CommandRow& row : kCommands) {
    bool first = true;
    for (const OptionRow& option : kOptions) {
      if ((option.commands & bit_of(row.command)) == 0) continue;
      if (first) out += std::string("\noptions of ") + row.name + ":\n";
      first = false;
      const bool told = (option.commands & (bit_of(row.command) - 1)) != 0; // with a command before this one
      if (told)
        append_row(out, option.name, "as above");
      else
        append_option(out, option);
    }
  }
  return out + "\n" + kNotes + kStatuses;
}

} // namespace app
