#include "program/commands/drawn_sketch.hpp"

#include "program/drawing/read.hpp"
#include "program/drawing/write.hpp"
#include "program/exit_code.hpp"
#include "program/files/deck_file.hpp"
#include "program/files/output_file.hpp"
#include "program/files/system_file.hpp"
#include "program/messages.hpp"
#include "program/sketch/read/read.hpp"
#include "program/voice.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cstdio>

namespace app {
namespace {

int print(const DeckFile& file, const drawing::Fault& fault) {
  c2d_error entry = C2D_INIT(c2d_error);
  entry.line = fault.line;
  std::snprintf(entry.text, sizeof entry.text, "%s", fault.text.c_str());
  say(quote(file, entry, "error"));
  return kExitInput;
}

// A binary drawing is reported as such, not by its first zero byte.
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

// The sketch is written even with faults, so that the user can correct it.
void warn(const DeckFile& drawing, const std::string& text, const std::string& output) {
  DeckFile sketch;
  sketch.call(output.empty() ? "sketch of " + drawing.name() : output);
  sketch.replace(text);
  const sketch::Reading reading = sketch::read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
  for (const sketch::Fault& fault : reading.faults) {
    c2d_error entry = C2D_INIT(c2d_error);
    entry.line = fault.at.line, entry.column = fault.at.column, entry.column_end = fault.at.end;
    std::snprintf(entry.text, sizeof entry.text, "%s", fault.text.c_str());
    say(quote(sketch, entry, "warning"));
  }
}

// Its lines become lines of the sketch: control characters in them are refused.
bool is_plain(const DeckFile& file, c2d_error& fault) {
  for (size_t line = 1; line <= file.cards(); ++line) {
    const std::string card(file.card(line));
    for (size_t i = 0; i < card.size(); i += std::max<size_t>(character_at(card, i), 1)) {
      if (card[i] == '\t' || character_at(card, i) > 0) continue;
      std::snprintf(fault.text, sizeof fault.text, "column %zu has the byte %d, expected text", i + 1,
                    static_cast<unsigned char>(card[i]));
      fault.status = C2D_ERR_INPUT, fault.severity = C2D_FAULT;
      fault.line = static_cast<int32_t>(line), fault.column = fault.column_end = static_cast<int32_t>(i) + 1;
      return false;
    }
  }
  return true;
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
    if (!statements.read_named(options.conditions, fault) || !is_plain(statements, fault)) {
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
  std::string text, error;
  try {
    text = drawing::sketch_of(std::move(drawn), last_part(file.name()), conditions, &notes);
  } catch (const drawing::Fault& fault) {
    for (const std::string& note : notes) messages.note(note);
    return print(statements, fault);
  }
  for (const std::string& note : notes) messages.note(note);
  warn(file, text, options.output);
  if (write_output(options.output, text, error)) return kExitSolved;
  messages.fail(error);
  return kExitFiles;
}

} // namespace app
