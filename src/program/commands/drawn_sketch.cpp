#include "program/commands/commands.hpp"

#include "program/drawing/read.hpp"
#include "program/drawing/write.hpp"
#include "program/exit_code.hpp"
#include "program/files/deck_file.hpp"
#include "program/files/system_file.hpp"
#include "program/messages.hpp"
#include "program/sketch/read/read.hpp"
#include "program/words/voice.hpp"
#include "report/text.hpp"

#include <algorithm>

namespace app {
namespace {

int print(const DeckFile& file, const drawing::Fault& fault) {
  say(quote(file, fault_in(fault.line, 0, 0, fault.text), "error"));
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
  for (const sketch::Fault& fault : reading.faults)
    say(quote(sketch, fault_in(fault.at.line, fault.at.column, fault.at.end, fault.text), "warning"));
}

// Its lines become lines of the sketch: control characters in them are refused.
bool is_plain(const DeckFile& file, c2d_error& fault) {
  for (size_t line = 1; line <= file.cards(); ++line) {
    const std::string card(file.card(line));
    for (size_t i = 0; i < card.size(); i += std::max<size_t>(character_at(card, i), 1)) {
      if (card[i] == '\t' || character_at(card, i) > 0) continue;
      const int32_t column = static_cast<int32_t>(i) + 1;
      fault = fault_in(static_cast<int32_t>(line), column, column,
                       "column " + std::to_string(column) + " has the byte " +
                           std::to_string(static_cast<unsigned char>(card[i])) + ", expected text");
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
    if (!statements.read_named(options.conditions, fault) || !is_plain(statements, fault))
      return Messages(statements).fault(fault, kExitInput);
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
  std::string text;
  try {
    text = drawing::sketch_of(std::move(drawn), last_part(file.name()), conditions, &notes);
  } catch (const drawing::Fault& fault) {
    for (const std::string& note : notes) messages.note(note);
    return print(statements, fault);
  }
  for (const std::string& note : notes) messages.note(note);
  warn(file, text, options.output);
  return write_or_fail(options.output, text, messages);
}

} // namespace app
