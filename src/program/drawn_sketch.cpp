#include "program/drawn_sketch.hpp"

#include "program/deck_file.hpp"
#include "program/drawing/read.hpp"
#include "program/drawing/write.hpp"
#include "program/exit_code.hpp"
#include "program/messages.hpp"
#include "program/output_file.hpp"
#include "program/sketch/read.hpp"
#include "program/system_file.hpp"

#include <cstdio>

namespace app {
namespace {

int print(const DeckFile& file, const drawing::Fault& fault) {
  c2d_error entry = C2D_INIT(c2d_error);
  entry.line = fault.line;
  std::snprintf(entry.text, sizeof entry.text, "%s", fault.text.c_str());
  const std::string text = quote(file, entry, "error");
  std::fwrite(text.data(), 1, text.size(), stderr);
  return kExitInput;
}

// A binary drawing is told as such, not by its first byte that is zero.
bool read(DeckFile& file, const std::string& name) {
  c2d_error fault = C2D_INIT(c2d_error);
  if (file.read(name, fault)) return true;
  if (fault.status == C2D_ERR_INPUT) {
    try {
      std::vector<std::string> notes;
      drawing::read_drawing(file.text(), 0, notes);
    } catch (const drawing::Fault& binary) {
      print(file, binary);
      return false;
    }
  }
  Messages(file).fault(fault);
  return false;
}

// The sketch is written all the same: what is wrong with it can be put right there.
void warn(const DeckFile& drawing, const std::string& text, const std::string& output) {
  DeckFile sketch;
  sketch.call(output.empty() ? "sketch of " + drawing.name() : output);
  sketch.replace(text);
  const sketch::Reading reading = sketch::read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
  for (const sketch::Fault& fault : reading.faults) {
    c2d_error entry = C2D_INIT(c2d_error);
    entry.line = fault.at.line, entry.column = fault.at.column, entry.column_end = fault.at.end;
    std::snprintf(entry.text, sizeof entry.text, "%s", fault.text.c_str());
    const std::string shown = quote(sketch, entry, "warning");
    std::fwrite(shown.data(), 1, shown.size(), stderr);
  }
}

std::string last_part(const std::string& path) { return path.substr(begin_of_name(path)); }

} // namespace

int sketch_drawing(const Options& options) {
  DeckFile file, statements;
  const Messages messages(file);
  if (!read(file, options.deck)) return kExitInput;
  drawing::Conditions conditions;
  if (!options.conditions.empty()) {
    c2d_error fault = C2D_INIT(c2d_error);
    if (!statements.read(options.conditions, fault)) {
      Messages(statements).fault(fault);
      return kExitInput;
    }
    conditions = drawing::read_conditions(statements.text());
  }
  drawing::Drawing drawn;
  std::vector<std::string> notes;
  try {
    drawn = drawing::read_drawing(file.text(), options.join, notes);
  } catch (const drawing::Fault& fault) {
    for (const std::string& note : notes) messages.note(note);
    return print(file, fault);
  }
  for (const std::string& note : notes) messages.note(note);
  std::string text, error;
  try {
    text = drawing::sketch_of(std::move(drawn), last_part(file.name()), conditions);
  } catch (const drawing::Fault& fault) {
    return print(statements, fault);
  }
  warn(file, text, options.output);
  if (write_output(options.output, text, error)) return kExitSolved;
  messages.fail(error);
  return kExitFiles;
}

} // namespace app
