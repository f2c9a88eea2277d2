#include "report/vtk.hpp"

#include "report/text.hpp"

namespace app {
namespace {

// Cell types of the format: vertex, line, quadratic edge, cubic line; ends first, then what lies between.
constexpr int kTypes[] = {1, 3, 21, 35};
constexpr int kOrder[4][4] = {{0, 0, 0, 0}, {0, 1, 0, 0}, {0, 2, 1, 0}, {0, 3, 1, 2}};

struct Collected {
  std::string points, displacement, traction, stress, von_mises, status; // point data
  std::string cells, types, body, element, image;                        // cells and their data
  int64_t point_count = 0, cell_count = 0, cell_numbers = 0;
};

void append_vector(std::string& out, double x, double y) {
  append_number(out, x);
  out += ' ';
  append_number(out, y);
  out += " 0\n";
}

void append_tensor(std::string& out, double xx, double yy, double xy, double zz) {
  append_vector(out, xx, xy);
  append_vector(out, xy, yy);
  out += "0 0 ";
  append_number(out, zz);
  out += '\n';
}

void append_cell(Collected& c, int32_t body, int32_t element, int32_t nodes, size_t image = 0) {
  c.cells += std::to_string(nodes);
  for (int32_t k = 0; k < nodes; ++k) c.cells += ' ' + std::to_string(c.point_count + kOrder[nodes - 1][k]);
  c.cells += '\n';
  c.types += std::to_string(kTypes[nodes - 1]) + '\n';
  c.body += std::to_string(body) + '\n';
  c.element += std::to_string(element) + '\n';
  c.image += std::to_string(image) + '\n';
  c.cell_count += 1;
  c.cell_numbers += nodes + 1;
}

struct BodyStress {
  std::vector<std::vector<double>> fields; // sxx, syy, sxy, szz, von Mises stress of every element end
};

void append_end(Collected& c, const Scene& scene, const BodyScene& b, const BodyStress& stress, size_t i, const Image& image) {
  const Point at = image.place(b.ends[i]);
  append_vector(c.points, at.x, at.y);
  c.point_count += 1;
  if (!scene.solved) return;
  const Point u = image.direction(b.displacement[i]), t = image.direction(b.traction[i]);
  const std::vector<std::vector<double>>& s = stress.fields;
  append_vector(c.displacement, u.x, u.y);
  append_vector(c.traction, t.x, t.y);
  append_tensor(c.stress, s[0][i], s[1][i], image.turn.x * image.turn.y * s[2][i], s[3][i]);
  append_number(c.von_mises, s[4][i]);
  c.von_mises += '\n';
  c.status += std::to_string(b.status[i]) + '\n';
}

// A body or one of its images. Elements on a line of symmetry are no boundary of the whole body.
c2d_status collect_body(Collected& c, const Scene& scene, int32_t body, size_t image) {
  const Summary& s = scene.summary;
  const BodyScene& b = scene.bodies[static_cast<size_t>(body) - 1];
  BodyStress stress;
  if (scene.solved) {
    const int32_t fields[] = {C2D_END_SXX, C2D_END_SYY, C2D_END_SXY, C2D_END_SZZ, C2D_END_VON_MISES};
    const c2d_status status = get_ends(scene.solver, s, body, fields, 5, stress.fields);
    if (status != C2D_OK) return status;
  }
  for (int32_t e = 1; e <= s.body[body - 1].elements; ++e) {
    if (b.on_line[static_cast<size_t>(e) - 1]) continue;
    append_cell(c, body, e, s.function_nodes, image);
    for (int32_t l = 0; l < s.function_nodes; ++l)
      append_end(c, scene, b, stress, static_cast<size_t>((e - 1) * s.function_nodes + l), scene.images[image]);
  }
  return C2D_OK;
}

void collect_point(Collected& c, const InteriorPoint& p) {
  append_vector(c.points, p.x, p.y);
  append_vector(c.displacement, p.values[C2D_POINT_UX], p.values[C2D_POINT_UY]);
  append_vector(c.traction, 0.0, 0.0);
  append_tensor(c.stress, p.values[C2D_POINT_SXX], p.values[C2D_POINT_SYY], p.values[C2D_POINT_SXY], p.values[C2D_POINT_SZZ]);
  append_number(c.von_mises, p.values[C2D_POINT_VON_MISES]);
  c.von_mises += '\n';
  c.status += "-1\n";
  c.point_count += 1;
}

void append_inner_cell(Collected& c, int32_t body, const std::vector<int64_t>& corners) {
  c.cells += std::to_string(corners.size());
  for (const int64_t corner : corners) c.cells += ' ' + std::to_string(corner);
  c.cells += '\n';
  c.types += corners.size() == 4 ? "9\n" : "1\n";
  c.body += std::to_string(body) + '\n';
  c.element += "0\n";
  c.image += "0\n";
  c.cell_count += 1;
  c.cell_numbers += static_cast<int64_t>(corners.size()) + 1;
}

void collect_interior(Collected& c, const Interior& interior) {
  std::vector<int64_t> number; // in the file, -1: outside
  for (const InteriorPoint& p : interior.points) {
    const bool there = flag_of(p) != C2D_POINT_OUTSIDE;
    number.push_back(there ? c.point_count : -1);
    if (there) collect_point(c, p);
  }
  std::vector<char> in_grid(number.size(), 0);
  for (const InteriorGrid& g : interior.grids)
    for (size_t row = 0; row + 1 < g.rows; ++row)
      for (size_t column = 0; column + 1 < g.columns; ++column) {
        const size_t first = row * g.columns + column;
        const int64_t at[] = {g.at[first], g.at[first + 1], g.at[first + g.columns + 1], g.at[first + g.columns]};
        if (at[0] < 0 || at[1] < 0 || at[2] < 0 || at[3] < 0) continue;
        std::vector<int64_t> corners;
        for (const int64_t i : at) {
          corners.push_back(number[static_cast<size_t>(i)]);
          in_grid[static_cast<size_t>(i)] = 1;
        }
        append_inner_cell(c, g.body, corners);
      }
  for (size_t i = 0; i < number.size(); ++i)
    if (number[i] >= 0 && !in_grid[i]) append_inner_cell(c, interior.points[i].body, {number[i]});
}

} // namespace

c2d_status append_vtk(std::string& out, const Scene& scene, const Interior& interior) {
  Collected c;
  for (size_t image = 0; image < scene.images.size(); ++image)
    for (int32_t body = 1; body <= scene.summary.bodies; ++body) {
      if (const c2d_status status = collect_body(c, scene, body, image); status != C2D_OK) return status;
    }
  if (scene.solved) collect_interior(c, interior);
  std::string title = scene.summary.title[0] != '\0' ? scene.summary.title : "contact2d";
  for (char& character : title)
    if (static_cast<unsigned char>(character) < 0x20 || static_cast<unsigned char>(character) >= 0x7f) character = '?';
  const std::string points = std::to_string(c.point_count), cells = std::to_string(c.cell_count);
  out +=
      "# vtk DataFile Version 3.0\n" + title + "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + points + " double\n" + c.points;
  out += "CELLS " + cells + ' ' + std::to_string(c.cell_numbers) + '\n' + c.cells;
  out += "CELL_TYPES " + cells + '\n' + c.types;
  out += "CELL_DATA " + cells + "\nSCALARS body int 1\nLOOKUP_TABLE default\n" + c.body;
  out += "SCALARS element int 1\nLOOKUP_TABLE default\n" + c.element;
  if (scene.images.size() > 1) out += "SCALARS image int 1\nLOOKUP_TABLE default\n" + c.image;
  if (!scene.solved) return C2D_OK;
  out += "POINT_DATA " + points + "\nVECTORS displacement double\n" + c.displacement;
  out += "VECTORS traction double\n" + c.traction;
  out += "TENSORS stress double\n" + c.stress;
  out += "SCALARS von_mises double 1\nLOOKUP_TABLE default\n" + c.von_mises;
  out += "SCALARS status int 1\nLOOKUP_TABLE default\n" + c.status;
  return C2D_OK;
}

} // namespace app
