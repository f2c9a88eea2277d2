#include "program/drawing/read.hpp"

#include "program/drawing/formats/dxf.hpp"
#include "program/drawing/formats/msh.hpp"
#include "program/drawing/loops.hpp"
#include "program/drawing/text.hpp"

namespace drawing {

Drawing read_drawing(std::string_view text, double join, std::vector<std::string>& notes) {
  if (text.substr(0, 18) == "AutoCAD Binary DXF") throw Fault{1, "this DXF file is binary, expected an ASCII file"};
  if (trimmed(text).find_first_not_of("\r\n") == std::string_view::npos) throw Fault{0, "the drawing is empty"};
  Drawing drawing;
  if (is_msh(text)) {
    drawing = drawing_of(read_mesh(text));
  } else if (is_dxf(text)) {
    drawing = read_dxf(text);
  } else {
    throw Fault{1, "not a drawing, expected DXF (begins with 0 and SECTION) or MSH (begins with $MeshFormat)"};
  }
  if (text.find('\0') != std::string_view::npos) throw Fault{0, "zero byte: this is not a text file"};
  const bool has_curves = !drawing.curves.empty() || !drawing.bodies.empty();
  join_curves(drawing, join);
  notes = drawing.notes;
  if (!has_curves) throw Fault{0, "the drawing has no curves"};
  if (drawing.bodies.empty() && !drawing.crossing.text.empty()) throw drawing.crossing;
  if (drawing.bodies.empty()) throw Fault{0, "no closed outline; --join D joins ends up to a distance D"};
  return drawing;
}

} // namespace drawing
