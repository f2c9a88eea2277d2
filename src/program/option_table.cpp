#include "program/option_table.hpp"

#include "program/exit_code.hpp"

#include <algorithm>

namespace app {
namespace {

constexpr uint32_t kRun = bit_of(Command::kRun), kCheck = bit_of(Command::kCheck), kMesh = bit_of(Command::kMesh),
                   kSketch = bit_of(Command::kSketch), kConvert = bit_of(Command::kConvert), kMake = bit_of(Command::kMake),
                   kResume = bit_of(Command::kResume), kSweep = bit_of(Command::kSweep);

const CommandRow kCommands[] = {
    {"run", Command::kRun, "DECK [NAME=VALUE ...]",
     "solve a deck, or a sketch (shapes without a mesh); the word run may be left out. NAME=VALUE sets a parameter of a "
     "sketch, or the value of {NAME} in a "
     "deck"},
    {"check", Command::kCheck, "DECK ... [NAME=VALUE ...]", "read and validate decks and print the memory that they need"},
    {"sketch", Command::kSketch, "DRAWING", "make a sketch from a drawing (DXF or MSH, ASCII), to be completed"},
    {"mesh", Command::kMesh, "SKETCH [NAME=VALUE ...]", "mesh a sketch and write the deck"},
    {"resume", Command::kResume, "DIR",
     "continue an interrupted run with --store file:DIR. DIR contains the deck, the options, the tapes and the saved state; "
     "all outputs are written in full"},
    {"sweep", Command::kSweep, "TABLE DECK [NAME=VALUE ...]",
     "solve a deck or a sketch once for every row of a table (CSV; its heading names parameters) and write a table of "
     "results"},
    {"convert", Command::kConvert, "DECK", "convert a deck between fixed columns and free form without changing a number"},
    {"make", Command::kMake, "NAME key=value ...", "write the deck of a named problem to standard output"},
    {"completion", Command::kCompletion, "bash|zsh|fish", "write the completion script for this shell"},
    {"help", Command::kHelp, "[COMMAND|--man]",
     "print commands and options, of one command or of all; --man: as a page for man"},
};

const OptionRow kOptions[] = {
    {"--listing", nullptr, "FILE", kRun,
     "printed results; default: standard output, unless another output is sent there. On a terminal only the summary is "
     "printed unless --listing is given"},
    {"--csv", nullptr, "FILE", kRun, "contact results, a row per pair and recorded step"},
    {"--boundary", nullptr, "FILE", kRun, "CSV of every element end of every body at the last step"},
    {"--interior", nullptr, "FILE", kRun, "CSV of displacements and stresses at the interior points at the last step"},
    {"--json", nullptr, "FILE", kRun, "summary of the run"},
    {"--report", nullptr, "FILE", kRun, "one HTML page with pictures of the model and the results"},
    {"--vtk", nullptr, "FILE", kRun,
     "boundary with displacements, tractions and stresses at the last step, and the interior points, for ParaView"},
    {"--trace", nullptr, "FILE", kRun, "CSV of every change of status: load, pair, from, to, why"},
    {"--bodies", nullptr, "FILE", kRun, "CSV of contact force and moment of every body, and motion of rigid bodies, by step"},
    {"--summary", nullptr, "FILE", kRun,
     "CSV of the main contact numbers by step: pressures, edges, stick borders, resultants"},
    {"--stresses", nullptr, "FILE", kRun,
     "CSV of stresses at every element end of every body and at the interior points, at every recorded step"},
    {"--ranges", nullptr, "FILE", kRun,
     "CSV of stress ranges at these places over the last load cycle, or over all recorded steps if there is no cycle"},
    {"--points", nullptr, "FILE", kRun | kSweep,
     "CSV body,x,y of interior points, used instead of *POINTS in the deck; - for standard input"},
    {"--figures", nullptr, "DIR", kRun, "the pictures of --report as single SVG files"},
    {"--out", nullptr, "DIR", kRun,
     "write all these outputs to one folder, except --stresses, --ranges and outputs given an option of their own"},
    {"--stepping", nullptr, "events|deck", kRun | kSweep,
     "events (default): follow every change of status; deck: use the increments of the deck"},
    {"--quadrature", nullptr, "accurate|thesis", kRun | kSweep,
     "accurate (default), or thesis: the rule of 2, 4 and 10 points"},
    {"--symmetry", nullptr, "deck|images", kRun | kCheck | kSweep,
     "deck (default): keep elements on a line of symmetry; images: replace them by images"},
    {"--elimination", nullptr, "dense|compressed|size", kRun | kCheck | kSweep,
     "dense: time grows as the cube, memory as the square of the number of nodes; compressed: both grow in proportion to it; "
     "size (default): compressed if a body has more than 800 nodes plus one for every two pairs"},
    {"--touching", nullptr, "N", kRun | kCheck | kSweep,
     "number of pairs that may touch at once, or nearly touch; 0: all. If there are more pairs, columns of the contact system "
     "are computed only when pairs approach contact. Default: a fifth of more than 1500 pairs; all where this is not possible "
     "or not enough"},
    {"--memory", nullptr, "SIZE", kRun | kSweep,
     "bytes of workspace, for example 65536, 64K, 16M, 1G; default: everything in memory, but at most half of the free memory; "
     "with compressed elimination what it needs"},
    {"--store", nullptr, "WHERE", kRun, "memory, or file:DIR; default: memory if it fits, else a folder under $TMPDIR"},
    {"--threads", nullptr, "N", kRun | kSweep,
     "threads for assembly, elimination and interior points, 1 to 64; default 1. For sweep: rows solved at once; default: the "
     "number of processors. Results do not depend on it"},
    {"--set", nullptr, "NAME=VALUE", kRun | kCheck | kMesh | kSweep,
     "replace the value of a parameter; NAME=VALUE after the file name does the same"},
    {"--params", nullptr, "FILE", kRun | kCheck | kMesh | kSweep,
     "values of parameters, one line NAME = VALUE for each, or a Dakota parameters file; --set takes precedence"},
    {"--response", nullptr, "LIST", kRun | kSweep, "requested numbers, separated by semicolons: \"max tn; contact edge 1\""},
    {"--results", nullptr, "FILE", kRun | kSweep,
     "the requested numbers, one line for each; if the run fails, one line with FAIL and the reason. For sweep: the table of "
     "all rows"},
    {"--row", nullptr, "FILE", kRun, "append a row to a CSV file: outcome, parameters, requested numbers"},
    {"--resume", nullptr, nullptr, kSweep, "solve only the rows missing from an interrupted sweep"},
    {"--estimate", nullptr, nullptr, kRun, "solve the deck again with every element halved, and state errors"},
    {"--progress", nullptr, nullptr, kRun | kResume | kSweep,
     "show a progress line on standard error; default: only on a terminal"},
    {"--no-progress", nullptr, nullptr, kRun | kResume | kSweep, "show no progress line"},
    {"--keep", nullptr, nullptr, kRun, "leave the tapes in their folder"},
    {"--save-every", nullptr, "SECONDS", kRun,
     "with --store file:DIR: interval between saved states of the load path; default 2, and at most 1/60 of the time; 0: save "
     "at every recorded load"},
    {"--quiet", "-q", nullptr, kRun | kCheck | kResume | kSweep,
     "print only errors on the terminal: no warnings, and a listing only if it is requested"},
    {"--with", nullptr, "FILE", kSketch, "add the statements of a file"},
    {"--join", nullptr, "D", kSketch, "join ends of curves that are at most D apart"},
    {"--halve", nullptr, nullptr, kMesh, "accept decks too, and write the deck with every element halved"},
    {"--to", nullptr, "fixed|free", kConvert, "form to write; default: the other form"},
    {"--output", "-o", "FILE", kSketch | kMesh | kConvert, "output file; default: standard output"},
    {"--list", nullptr, nullptr, kMake, "list names and keys"},
};

const char kNotes[] = "DECK and input FILEs may be - for standard input, output FILEs - for standard output.\n";
const StatusRow kStatuses[] = {
    {kExitSolved, "solved"},
    {kExitNoSolution, "no further or no unique solution; rows up to the last load reached are written"},
    {kExitInput, "bad deck, each error with its line; no output file is left"},
    {kExitFiles, "block store or output file failed"},
    {kExitMemory, "workspace too small; the message contains the size needed"},
    {kExitInaccurate, "results written, a wanted tolerance not met"},
    {kExitUsage, "bad usage"},
    {kExitBusy, "store or sweep in use by another process"},
    {kExitCancelled, "cancelled"},
    {kExitPipe, "the reader of an output has gone"},
    {kExitStopped, "ended by SIGTERM; resume continues the run"},
};
constexpr size_t kMargin = 23, kWidth = 110;

// Appends `name`, and beside it `text`, broken into lines of at most kWidth characters.
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

const std::vector<StatusRow>& all_statuses() {
  static const std::vector<StatusRow> all(std::begin(kStatuses), std::end(kStatuses));
  return all;
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandRow& row : kCommands) names.push_back(row.name);
  return names;
}

std::vector<std::string> option_names(Command command) {
  std::vector<std::string> names;
  for (const OptionRow& row : kOptions)
    if ((row.commands & bit_of(command)) != 0) names.push_back(row.name);
  return names;
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
  append_row(out, "-V, --version", "print the version");
  append_row(out, "-h, --help", "after a command: print the help of that command");
  for (const CommandRow& row : kCommands) {
    bool first = true;
    for (const OptionRow& option : kOptions) {
      if ((option.commands & bit_of(row.command)) == 0) continue;
      if (first) out += std::string("\noptions of ") + row.name + ":\n";
      first = false;
      const bool described = (option.commands & (bit_of(row.command) - 1)) != 0; // with a command before this one
      if (described)
        append_row(out, option.name, "as above");
      else
        append_option(out, option);
    }
  }
  out += std::string("\n") + kNotes + "\nexit status:\n";
  for (const StatusRow& row : kStatuses) append_row(out, std::to_string(row.status), row.meaning);
  return out;
}

} // namespace app
