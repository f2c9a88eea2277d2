// The VTK file: the boundary CSV, and the images of symmetric models.
#include "picture_runs.hpp"

#include <array>

using namespace test;

namespace {

struct Vtk {
  std::vector<std::array<double, 3>> points, displacement, traction;
  std::vector<std::vector<int>> cells;
  std::vector<int> types, body, element, image, status;
  std::vector<std::array<double, 9>> stress;
  std::vector<std::array<double, 1>> von_mises;
  size_t tensors = 0;
  std::string fault;
};

template <size_t n> void read_tuples(std::istream& in, size_t count, std::vector<std::array<double, n>>& out) {
  out.resize(count);
  for (auto& tuple : out)
    for (double& x : tuple) in >> x;
}
void read_scalars(std::istream& in, size_t count, std::vector<int>& out) {
  std::string word;
  in >> word >> word >> word; // type is read by the caller; components, LOOKUP_TABLE default
  out.resize(count);
  for (int& x : out) in >> x;
}

Vtk read_vtk(const std::string& text) {
  Vtk out;
  std::istringstream in(text);
  std::string line, word, name;
  std::getline(in, line);
  if (line != "# vtk DataFile Version 3.0") out.fault = line;
  std::getline(in, line);
  std::getline(in, line);
  if (line != "ASCII") out.fault = line;
  size_t count = 0, numbers = 0, tuples = 0;
  while (in >> word) {
    if (word == "DATASET") {
      in >> name;
      if (name != "UNSTRUCTURED_GRID") out.fault = name;
    } else if (word == "POINTS") {
      in >> count >> name;
      read_tuples(in, count, out.points);
    } else if (word == "CELLS") {
      in >> count >> numbers;
      for (size_t c = 0; c < count; ++c) {
        int n = 0;
        in >> n;
        numbers -= static_cast<size_t>(n) + 1;
        out.cells.emplace_back(static_cast<size_t>(n));
        for (int& i : out.cells.back()) in >> i;
      }
      if (numbers != 0) out.fault = "size of CELLS";
    } else if (word == "CELL_TYPES") {
      in >> count;
      out.types.resize(count);
      for (int& t : out.types) in >> t;
    } else if (word == "CELL_DATA" || word == "POINT_DATA") {
      in >> tuples;
    } else if (word == "SCALARS") {
      in >> name >> word;
      if (name == "von_mises") {
        in >> word >> word >> word;
        read_tuples(in, tuples, out.von_mises);
        continue;
      }
      read_scalars(in, tuples,
                   name == "body"      ? out.body
                   : name == "element" ? out.element
                   : name == "image"   ? out.image
                                       : out.status);
    } else if (word == "VECTORS") {
      in >> name >> word;
      read_tuples(in, tuples, name == "displacement" ? out.displacement : out.traction);
    } else if (word == "TENSORS") {
      in >> name >> word;
      read_tuples(in, tuples, out.stress);
      out.tensors = out.stress.size();
    } else {
      out.fault = "unknown word " + word;
      break;
    }
  }
  return out;
}

} // namespace

TEST_CASE("VTK: the file holds the boundary CSV") {
  for (const char* name : {"hertz.dat", "thick_ring.dat"}) {
    Shown shown;
    show(shown, example(name));
    REQUIRE(shown.result.status == 0);
    const Vtk vtk = read_vtk(shown.vtk);
    CHECK_MESSAGE(vtk.fault.empty(), vtk.fault);
    const std::vector<std::string> rows = lines_of(read_file(shown.folder / "b.csv"));
    const size_t boundary = rows.size() - 1; // a grid inside follows
    REQUIRE(vtk.points.size() > boundary);
    REQUIRE(vtk.displacement.size() == vtk.points.size());
    REQUIRE(vtk.traction.size() == vtk.points.size());
    CHECK(vtk.status.size() == vtk.points.size());
    CHECK(vtk.tensors == vtk.points.size());
    CHECK(vtk.von_mises.size() == vtk.points.size());
    CHECK(vtk.types.size() == vtk.cells.size());
    CHECK(vtk.body.size() == vtk.cells.size());
    size_t ends = 0;
    for (size_t c = 0; c < vtk.cells.size() && vtk.element[c] > 0; ++c) {
      ends += vtk.cells[c].size();
      const size_t n = vtk.cells[c].size();
      CHECK(vtk.types[c] == (n == 1 ? 1 : n == 2 ? 3 : n == 3 ? 21 : 35));
    }
    CHECK(ends == boundary);
    for (size_t i = 0; i < boundary; ++i) {
      std::istringstream in(rows[i + 1]);
      std::vector<double> f;
      for (std::string field; std::getline(in, field, ',');) f.push_back(std::stod(field));
      REQUIRE(f.size() == 9);
      CHECK(vtk.points[i][0] == f[3]);
      CHECK(vtk.points[i][1] == f[4]);
      CHECK(vtk.displacement[i][0] == f[5]);
      CHECK(vtk.displacement[i][1] == f[6]);
      CHECK(vtk.traction[i][0] == f[7]);
      CHECK(vtk.traction[i][1] == f[8]);
    }
    // A quadratic edge lists its ends first: its middle node lies nearer to both than they to each other.
    for (const std::vector<int>& cell : vtk.cells) {
      if (cell.size() != 3) continue;
      const auto place = [&](int i) { return vtk.points[static_cast<size_t>(cell[static_cast<size_t>(i)])]; };
      const auto apart = [&](int i, int k) { return std::hypot(place(i)[0] - place(k)[0], place(i)[1] - place(k)[1]); };
      CHECK(apart(0, 2) < apart(0, 1));
      CHECK(apart(1, 2) < apart(0, 1));
    }
  }
}

namespace {

// Twice the area of the cells inside a body.
double twice_area_inside(const Vtk& vtk, int body) {
  double sum = 0.0;
  for (size_t c = 0; c < vtk.cells.size(); ++c) {
    if (vtk.body[c] != body || vtk.types[c] != 9) continue;
    CHECK(vtk.element[c] == 0);
    for (size_t n = 0; n < 4; ++n) {
      const auto &a = vtk.points[static_cast<size_t>(vtk.cells[c][n])],
                 &b = vtk.points[static_cast<size_t>(vtk.cells[c][(n + 1) % 4])];
      sum += a[0] * b[1] - b[0] * a[1];
    }
  }
  return sum;
}

// Twice the area within all cells of a body, each taken as the chord from its first to its second point.
double twice_area(const Vtk& vtk, int body) {
  double sum = 0.0;
  for (size_t c = 0; c < vtk.cells.size(); ++c) {
    if (vtk.body[c] != body || vtk.element[c] == 0) continue;
    const auto &a = vtk.points[static_cast<size_t>(vtk.cells[c][0])], &b = vtk.points[static_cast<size_t>(vtk.cells[c][1])];
    // An image's boundary runs the other way round if it is mirrored once.
    const bool turned = vtk.image.size() > c && (vtk.image[c] == 1 || vtk.image[c] == 2);
    sum += (turned ? -1.0 : 1.0) * (a[0] * b[1] - b[0] * a[1]);
  }
  return sum;
}

} // namespace

TEST_CASE("VTK: the whole of a symmetric model") {
  Shown half, whole;
  show(half, example("hertz.dat"));
  show(whole, example("hertz.dat"), "--symmetry images");
  REQUIRE(half.result.status == 0);
  REQUIRE(whole.result.status == 0);
  const Vtk a = read_vtk(half.vtk), b = read_vtk(whole.vtk);
  CHECK_MESSAGE(b.fault.empty(), b.fault);
  CHECK(a.image.empty());
  REQUIRE(b.image.size() == b.cells.size());
  for (const int body : {1, 2}) // the half's line x = 0 closes it and adds nothing to the sum
    CHECK(twice_area(b, body) == doctest::Approx(2.0 * twice_area(a, body)).epsilon(1e-9));
  // The grid inside fills the bodies but for what is cut off at their boundary, by no more than a spacing.
  for (const Vtk* vtk : {&a, &b})
    for (const int body : {1, 2}) {
      CHECK(twice_area_inside(*vtk, body) > 0.85 * twice_area(*vtk, body));
      CHECK(twice_area_inside(*vtk, body) < (1.0 + 1e-9) * twice_area(*vtk, body));
    }
  // Point by point: every one at (x, y) has its image at (-x, y), with ux, tx and sxy of the other sign.
  size_t matched = 0;
  for (size_t c = 0; c < b.cells.size(); ++c) {
    if (b.image[c] != 1) continue;
    const size_t other =
        static_cast<size_t>(std::find_if(b.cells.begin(), b.cells.end(),
                                         [&](const std::vector<int>& cell) {
                                           const size_t k = static_cast<size_t>(&cell - b.cells.data());
                                           return b.image[k] == 0 && b.body[k] == b.body[c] && b.element[k] == b.element[c];
                                         }) -
                            b.cells.begin());
    REQUIRE(other < b.cells.size());
    for (size_t n = 0; n < b.cells[c].size(); ++n) {
      const size_t i = static_cast<size_t>(b.cells[c][n]), k = static_cast<size_t>(b.cells[other][n]);
      CHECK(b.points[i][0] == -b.points[k][0]);
      CHECK(b.points[i][1] == b.points[k][1]);
      CHECK(b.displacement[i][0] == -b.displacement[k][0]);
      CHECK(b.displacement[i][1] == b.displacement[k][1]);
      CHECK(b.traction[i][0] == -b.traction[k][0]);
      CHECK(b.traction[i][1] == b.traction[k][1]);
      CHECK(b.stress[i][0] == b.stress[k][0]);
      CHECK(b.stress[i][1] == -b.stress[k][1]);
      CHECK(b.stress[i][4] == b.stress[k][4]);
      CHECK(b.points[k][0] >= 0.0);
      ++matched;
    }
  }
  CHECK(matched > 100);
}
