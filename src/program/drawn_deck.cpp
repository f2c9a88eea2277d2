#include "program/drawn_deck.hpp"

#include "program/estimate/loop.hpp"
#include "program/estimate/wanted.hpp"
#include "program/exit_code.hpp"
#include "program/interrupt.hpp"
#include "program/messages.hpp"
#include "program/output_file.hpp"
#include "program/progress.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace app {
namespace {

constexpr double kFineness = 2; // of a mesh that no tolerance asks for

void print(const DeckFile& deck, const sketch::Fault& fault) {
  c2d_error entry = C2D_INIT(c2d_error);
  entry.line = fault.at.line, entry.column = fault.at.column, entry.column_end = fault.at.end;
  std::snprintf(entry.text, sizeof entry.text, "%s", fault.text.c_str());
  const std::string text = quote(deck, entry, "error");
  std::fwrite(text.data(), 1, text.size(), stderr);
}

bool read_setting(const std::string& word, sketch::Parameters& given) {
  const size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0) return false;
  double value = 0;
  const char *const begin = word.data() + equals + 1, *const end = word.data() + word.size();
  const auto result = std::from_chars(begin, end, value);
  given[word.substr(0, equals)] = value;
  return result.ec == std::errc() && result.ptr == end && std::isfinite(value);
}

// Names of files in a sketch are seen from where the sketch is.
std::string beside(const std::string& sketch, const std::string& name) {
  const size_t slash = sketch.rfind('/');
  return name.empty() || name[0] == '/' || slash == std::string::npos ? name : sketch.substr(0, slash + 1) + name;
}

// The numbers whose tolerances were not met.
void tell_misses(const DeckFile& deck, const MeshLoop& loop) {
  if (loop.stopped.empty()) return;
  const Messages messages(deck);
  if (loop.stated.empty()) messages.note("no errors are stated: " + loop.stopped);
  for (const Stated& s : loop.stated) {
    if (s.is_met()) continue;
    std::string text = s.name;
    if (s.zone > 0) text += " of zone " + std::to_string(s.zone);
    char numbers[120] = ": its error cannot be told";
    if (!std::isnan(s.relative_error()))
      std::snprintf(numbers, sizeof numbers, ": its error is about %.2g %%", 100 * s.relative_error());
    text += numbers;
    std::snprintf(numbers, sizeof numbers, ", asked for was %.2g %%", 100 * s.tolerance);
    messages.note(text + numbers + ", " + loop.stopped);
  }
}

void show(const MeshRound& round, size_t number) {
  std::fprintf(stderr, "contact2d: mesh %zu: %d elements, %d pairs, %.2g s", number, round.elements, round.pairs,
               round.seconds);
  if (!std::isnan(round.pressure)) std::fprintf(stderr, ", tractions changed by %.2g %%", 100 * round.pressure);
  std::fputc('\n', stderr);
}

// The deck of a sound sketch. Throws a sketch::Fault.
int mesh_sketch(DeckFile& deck, const sketch::Sketch& sketch, const Drawing& drawing, MeshLoop& loop) {
  if (!drawing.adapts || !sketch.adapts) {
    deck.replace_by_deck(sketch::deck_of(sketch, sketch::first_mesh(sketch, kFineness)));
    return 0;
  }
  estimate::Demand demand;
  demand.memory = drawing.memory;
  estimate::ask(sketch, demand);
  size_t meshes = 0;
  estimate::Adapted adapted = estimate::adapt(sketch, demand, [&](const MeshRound& round) {
    if (drawing.shows) show(round, ++meshes);
  });
  if (interrupted()) return kExitCancelled;
  deck.replace_by_deck(adapted.deck);
  tell_misses(deck, adapted.loop);
  loop = std::move(adapted.loop);
  return 0;
}

} // namespace

int take_sketch(DeckFile& deck, const Drawing& drawing, MeshLoop& loop) {
  if (!sketch::is_sketch(deck.text(), deck.name())) {
    if (drawing.settings.empty()) return 0;
    print(deck, {{}, "a deck has no parameters: " + drawing.settings[0] + " is for sketches"});
    return kExitUsage;
  }
  sketch::Parameters given;
  for (const std::string& word : drawing.settings)
    if (!read_setting(word, given)) {
      print(deck, {{}, word + ": expected the name of a parameter, = and a number"});
      return kExitUsage;
    }
  const auto file = [&deck](const std::string& name, std::string& text) {
    std::ifstream in(beside(deck.name(), name), std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    text = out.str();
    return in.good();
  };
  const sketch::Reading reading = sketch::read_sketch(deck.text(), given, file);
  for (const sketch::Fault& fault : reading.faults) print(deck, fault);
  if (!reading.faults.empty()) return kExitInput;
  try {
    return mesh_sketch(deck, reading.sketch, drawing, loop);
  } catch (const sketch::Fault& fault) {
    print(deck, fault);
    return kExitInput;
  }
}

int write_mesh(const Options& options) {
  DeckFile deck;
  MeshLoop loop;
  Messages messages(deck);
  c2d_error fault = C2D_INIT(c2d_error);
  if (!deck.read(options.deck, fault)) {
    messages.fault(fault);
    return kExitInput;
  }
  if (!sketch::is_sketch(deck.text(), deck.name())) {
    messages.fail("a deck has its mesh, expected a sketch");
    return kExitInput;
  }
  if (const int status =
          take_sketch(deck, {options.settings, true, options.memory, ProgressLine(options.progress).active()}, loop);
      status != 0)
    return status;
  std::string error;
  if (write_output(options.output, deck.text(), error)) return kExitSolved;
  messages.fail(error);
  return kExitFiles;
}

} // namespace app
