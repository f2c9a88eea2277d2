#include "program/commands/commands.hpp"

#include "program/commands/families.hpp"
#include "program/option_table.hpp"

#include <vector>

namespace app {
namespace {

const char kIntroduction[] =
    ".SH DESCRIPTION\n"
    ".B contact2d\n"
    "solves two-dimensional elastic contact problems with Coulomb friction by the boundary element method.\n"
    "The cards of a deck describe any number of bodies, in the fixed columns of the program CONTACT of 1987 or in free form;\n"
    "a sketch describes their shapes, and the program meshes them.\n"
    "The program follows the load from one change of status to the next, so that the result depends on the order of loads but\n"
    "not on the size of increments.\n"
    "Memory is bounded: matrix blocks go to files if they do not fit.\n";
const char kOptionsBegin[] = ".SH OPTIONS\n"
                             "Each option names the commands that accept it.\n"
                             "DECK and input FILEs may be\n.B \\-\nfor standard input, output FILEs\n.B \\-\n"
                             "for standard output.\nFiles appear under their names only when they are complete.\n";
const char kEnding[] =
    ".SH ENVIRONMENT\n"
    ".TP\n.B TMPDIR\nparent of the folder for blocks if none is named; default: /tmp.\n"
    ".TP\n.B NO_COLOR\nif not empty, messages on a terminal have no colours.\n"
    ".PP\nNumbers are read and written with a point whatever the locale.\n"
    ".SH EXAMPLES\n.nf\n"
    "contact2d make \\-\\-list\n"
    "contact2d make punch mu=0.3 nu=0.3 > punch.dat\n"
    "contact2d check punch.dat\n"
    "contact2d run punch.dat \\-\\-csv punch.csv \\-\\-report punch.html\n"
    "contact2d run punch.dat \\-\\-memory 256K \\-\\-store file:tapes \\-\\-csv \\-\n"
    ".fi\n"
    ".SH SEE ALSO\n"
    "The C interface is described in\n.IR contact2d.h ,\nthe deck in\n.IR src/deck/DECK.md ,\nthe sketch in\n"
    ".IR src/program/sketch/SKETCH.md ,\nthe results in\n.IR src/report/OUTPUT.md ,\na worked example in\n"
    ".I examples/TUTORIAL.md\nof the documentation.\n";

// Text that man prints as it stands: lines of moderate length, none of which begins with a control character.
std::string prose(const std::string& text) {
  std::string out;
  size_t column = 0;
  for (const char c : text) {
    if (c == ' ' && column > 100) {
      out += '\n', column = 0;
      continue;
    }
    if (column == 0 && (c == '.' || c == '\'')) out += "\\&";
    out += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
    ++column;
  }
  return out + "\n";
}

std::string bold(const std::string& text) { return "\\fB" + text + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + text + "\\fR"; }
std::string dashes(const std::string& text) {
  const std::string line = prose(text);
  return line.substr(0, line.size() - 1);
}

std::string synopsis() {
  std::string out = ".SH SYNOPSIS\n";
  for (const CommandRow& row : all_commands())
    out += std::string(".B contact2d ") + row.name + "\n" + italic(dashes(row.words)) +
           (option_names(row.command).empty() ? "" : " [options]") + "\n.br\n";
  return out + ".B contact2d\n" + italic("DECK") + " [options]\n.br\n.B contact2d \\-\\-version\n|\n.B \\-\\-help\n";
}

std::string commands() {
  std::string out;
  for (const CommandRow& row : all_commands()) {
    out += ".TP\n" + bold(row.name) + " " + italic(dashes(row.words)) + "\n" + prose(row.help);
    if (row.command != Command::kMake) continue;
    out += ".br\nThe problems are:\n";
    for (const families::Family& family : families::all_families())
      out += ".br\n" + bold(dashes(family.name)) + ": " + prose(families::summary_of(family));
  }
  return out + ".PP\nA file in the place of a command is run.\nThe completion script is for example used by\n"
               ".B eval \"\"\"$(contact2d completion bash)\"\"\"\nin bash.\n";
}

std::string options() {
  std::string out = kOptionsBegin;
  for (const OptionRow& row : all_options()) {
    out += ".TP\n" + (row.brief != nullptr ? bold(dashes(row.brief)) + ", " : std::string()) + bold(dashes(row.name));
    if (row.value != nullptr) out += " " + (words_of_value(row).empty() ? italic(row.value) : bold(row.value));
    out += "\n" + prose(row.help);
    std::string names;
    for (const CommandRow& command : all_commands())
      if ((row.commands & bit_of(command.command)) != 0) names += (names.empty() ? "" : ", ") + std::string(command.name);
    out += ".br\nFor " + names + ".\n";
  }
  return out;
}

std::string statuses() {
  std::string out = ".SH EXIT STATUS\n";
  for (const StatusRow& row : all_statuses()) out += ".TP\n.B " + std::to_string(row.status) + "\n" + prose(row.meaning);
  return out;
}

} // namespace

std::string man_page(const std::string& version) {
  return ".TH CONTACT2D 1 2026-11-01 \"contact2d " + version + "\" \"User Commands\"\n" +
         ".SH NAME\ncontact2d \\- two\\-dimensional elastic contact with friction by boundary elements\n" + synopsis() +
         kIntroduction + commands() + options() + statuses() + kEnding;
}

} // namespace app
