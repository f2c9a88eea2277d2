#include "report/interior.hpp"

#include "report/text.hpp"

namespace app {
namespace {

const char* place_word(int flag) {
  switch (flag) {
  case C2D_POINT_INSIDE: return "inside";
  case C2D_POINT_NEAR_NODE: return "near node";
  case C2D_POINT_BOUNDARY: return "boundary";
  default: return "outside";
  }
}

} // namespace

void append_interior_header(std::string& out) { out += "body,x,y,ux,uy,sxx,syy,sxy,szz,von_mises,max_shear\n"; }

void append_interior_rows(std::string& out, const Interior& interior) {
  for (const InteriorPoint& p : interior.points) {
    append_integer(out, p.body);
    for (const double v : {p.x, p.y}) {
      out += ',';
      append_number(out, v);
    }
    for (int c = C2D_POINT_UX; c <= C2D_POINT_MAX_SHEAR; ++c) {
      out += ',';
      if (flag_of(p) == C2D_POINT_OUTSIDE)
        out += "nan";
      else
        append_number(out, p.values[c]);
    }
    out += '\n';
  }
}

void append_interior_section(std::string& out, const Interior& interior, const Summary& s, const std::vector<double>& loads) {
  out += "\nInterior points\n";
  out.append(100, '-') += '\n';
  out += loads.size() > 1 ? "  load factors " : "  load factor ";
  for (size_t k = 0; k < loads.size(); ++k) append_number(k > 0 ? out += ", " : out, loads[k]);
  if (s.pairs > 0) {
    out += ", coefficient of friction ";
    append_number(out, s.mu);
  }
  out += "\n  s1 >= s2: principal stresses of the plane; max shear is half their difference. On the "
         "boundary: its own "
         "stress;\n  near a node: without the effect of the jumps of slopes and tractions between elements.\n\n"
         "  body            x            y           ux           uy          sxx          syy          sxy"
         "          szz           s1           s2    von Mises    max shear  place\n";
  const int columns[] = {C2D_POINT_UX,  C2D_POINT_UY,         C2D_POINT_SXX,        C2D_POINT_SYY,       C2D_POINT_SXY,
                         C2D_POINT_SZZ, C2D_POINT_PRINCIPAL1, C2D_POINT_PRINCIPAL2, C2D_POINT_VON_MISES, C2D_POINT_MAX_SHEAR};
  for (const InteriorPoint& p : interior.points) {
    append_column(out, p.body, 6);
    append_scientific(out, p.x, 13);
    append_scientific(out, p.y, 13);
    for (const int c : columns)
      if (flag_of(p) == C2D_POINT_OUTSIDE)
        append_column(out, "-", 13);
      else
        append_scientific(out, p.values[c], 13);
    out += "  ";
    out += place_word(flag_of(p));
    out += '\n';
  }
}

} // namespace app
