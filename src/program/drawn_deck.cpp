#include "program/drawn_deck.hpp"

#include "program/exit_code.hpp"
#include "program/messages.hpp"
#include "program/output_file.hpp"
#include "program/sketch/mesh.hpp"
#include "program/sketch/read.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace app {
namespace {

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

} // namespace

int take_sketch(DeckFile& deck, const std::vector<std::string>& settings) {
  if (!sketch::is_sketch(deck.text(), deck.name())) {
    if (settings.empty()) return 0;
    print(deck, {{}, "a deck has no parameters: --set is for sketches"});
    return kExitUsage;
  }
  sketch::Parameters given;
  for (const std::string& word : settings)
    if (!read_setting(word, given)) {
      print(deck, {{}, "--set " + word + ": expected the name of a parameter, = and a number"});
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
    deck.replace(sketch::deck_of(reading.sketch, sketch::first_mesh(reading.sketch, 2)));
  } catch (const sketch::Fault& fault) {
    print(deck, fault);
    return kExitInput;
  }
  return 0;
}

int write_mesh(const Options& options) {
  DeckFile deck;
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
  if (const int status = take_sketch(deck, options.settings); status != 0) return status;
  OutputFile out;
  std::string error;
  bool written = out.open(options.output.empty() ? "-" : options.output, error);
  if (written) out.text = deck.text();
  written = written && out.finish(error) && out.publish(error);
  if (written) return kExitSolved;
  messages.fail(error);
  return kExitFiles;
}

} // namespace app
