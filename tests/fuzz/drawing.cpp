// Drawings, DXF or MSH, and the statements of --with behind a line of %%: the sketch of a drawing that is taken is a sketch.
#include "fuzz.hpp"

#include "program/drawing/read.hpp"
#include "program/drawing/write.hpp"
#include "program/sketch/read/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string text = fuzz::text_of(data, size);
  const size_t mark = text.find("\n%%\n");
  const std::string drawn = text.substr(0, mark), with = mark == std::string::npos ? "" : text.substr(mark + 4);
  const size_t lines = fuzz::count_lines(drawn) + fuzz::count_lines(with);
  std::string out;
  try {
    drawing::Conditions conditions;
    if (mark != std::string::npos) conditions = drawing::read_conditions(with);
    std::vector<std::string> notes;
    out =
        drawing::sketch_of(drawing::read_drawing(drawn, data[size / 2] % 4 == 3 ? 0.01 : 0, notes), "drawing.dxf", conditions);
  } catch (const drawing::Fault& fault) {
    fuzz::require(!fault.text.empty() && fault.line >= 0 && static_cast<size_t>(fault.line) <= lines + 1,
                  "a fault with its line");
    return 0;
  }
  fuzz::require(sketch::is_sketch(out, "drawing.c2s"), "the sketch of a drawing");
  const sketch::Reading reading = sketch::read_sketch(out, {}, [](const std::string&, std::string&) { return false; });
  for (const sketch::Fault& fault : reading.faults)
    fuzz::require(!fault.text.empty() && static_cast<size_t>(fault.at.line) <= fuzz::count_lines(out), "a fault of the sketch");
  return 0;
}
