// The text of a sketch: its statements, its first mesh, and the deck of that, which the library reads.
#include "fuzz.hpp"

#include "program/sketch/mesh.hpp"
#include "program/sketch/read/read.hpp"

namespace {

void require_place(const sketch::Fault& fault, size_t lines) {
  fuzz::require(!fault.text.empty(), "a fault has a text");
  fuzz::require(fault.at.line >= 0 && static_cast<size_t>(fault.at.line) <= lines, "a line of the sketch");
  fuzz::require(fault.at.line == 0 || fault.at.column >= 1, "a column of the sketch");
}

bool file(const std::string& name, std::string& text) {
  text = "x,y\n0,0\n1,0.5\n2,0\n3,-0.5\n";
  return name == "points.csv";
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::text_of(data, size);
  const size_t lines = fuzz::count_lines(text);
  sketch::is_sketch(text);
  const sketch::Reading reading = sketch::read_sketch(text, {}, file);
  for (const sketch::Fault& fault : reading.faults) require_place(fault, lines);
  if (!reading.faults.empty()) return 0;
  std::string deck;
  try {
    deck = sketch::deck_of(reading.sketch, sketch::first_mesh(reading.sketch, 0.5));
  } catch (const sketch::Fault& fault) {
    require_place(fault, lines);
    return 0;
  }
  std::vector<c2d_body_limits> bodies(reading.sketch.bodies.size() + 1);
  c2d_limits limits = C2D_INIT(c2d_limits);
  limits.bodies = static_cast<int32_t>(bodies.size()), limits.body = bodies.data();
  fuzz::Lines cards(deck);
  c2d_error why = C2D_INIT(c2d_error);
  if (c2d_scan_deck(fuzz::Lines::read, &cards, &limits, &why) != C2D_OK) {
    std::fprintf(stderr, "%s\nline %d: %s\n", deck.c_str(), static_cast<int>(why.line), why.text);
    fuzz::require(false, "the mesh of a sketch is a deck");
  }
  return 0;
}
