// Points inside: *POINTS, --points and --interior of the program, and the calls behind them.
#include "deck_recorder.hpp"
#include "json.hpp"
#include "paths.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace test;

namespace {

const std::string kRing = paths::root() + "/examples/thick_ring.dat";
const std::string kHeader = "body,x,y,ux,uy,sxx,syy,sxy,szz,von_mises,max_shear";

std::string quoted(const std::string& path) { return "'" + path + "'"; }
Result contact2d(const std::string& arguments) { return run_shell("'" + paths::program() + "' " + arguments); }

struct Row {
  int body;
  double x, y, ux, uy, sxx, syy, sxy, szz, von_mises, max_shear;
  bool outside() const {
    bool all = true, any = false;
    for (double v : {ux, uy, sxx, syy, sxy, szz, von_mises, max_shear}) {
      all = all && std::isnan(v);
      any = any || std::isnan(v);
    }
    CHECK(all == any);
    return all;
  }
};

std::vector<Row> rows_of(const std::string& csv) {
  const std::vector<std::string> lines = lines_of(csv);
  REQUIRE(!lines.empty());
  CHECK(lines[0] == kHeader);
  std::vector<Row> rows;
  for (size_t i = 1; i < lines.size(); ++i) {
    std::vector<double> f;
    std::istringstream in(lines[i]);
    for (std::string field; std::getline(in, field, ',');) f.push_back(std::stod(field));
    REQUIRE(f.size() == 11);
    rows.push_back({static_cast<int>(f[0]), f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10]});
  }
  return rows;
}

// Lame's ring: a = 1, b = 2, pressure 100 inside, E = 1e5, nu = 0.3, plane strain.
constexpr double kA = 100.0 / 3, kB = 400.0 / 3;

// The largest error of a row: stresses over the pressure, displacement over the largest.
double error_of(const Row& p) {
  const double r = std::hypot(p.x, p.y), c = p.x / r, s = p.y / r;
  const double rr = kA - kB / (r * r), tt = kA + kB / (r * r), ur = 1.3e-5 * (0.4 * kA * r + kB / r);
  const double exact[] = {rr * c * c + tt * s * s, rr * s * s + tt * c * c, (rr - tt) * s * c, 0.6 * kA, (tt - rr) / 2};
  const double found[] = {p.sxx, p.syy, p.sxy, p.szz, p.max_shear};
  double worst = std::max(std::fabs(p.ux - ur * c), std::fabs(p.uy - ur * s)) / 1.9e-3;
  for (int k = 0; k < 5; ++k) worst = std::max(worst, std::fabs(found[k] - exact[k]) / 100);
  const double zz = 0.6 * kA, mises = std::sqrt(0.5 * ((rr - tt) * (rr - tt) + (tt - zz) * (tt - zz) + (zz - rr) * (zz - rr)));
  return std::max(worst, std::fabs(p.von_mises - mises) / 100);
}

std::string ring_with(const std::string& cards) { return read_file(kRing) + cards; }

const std::string kThree = "*POINTS\n"
                           "point 1 1.5 0.1 ! a point\n"
                           "line 1 1.2 0.4, 1.2 1.3 4\n"
                           "grid 1 0 0 2 2 9 5\n";

} // namespace

TEST_CASE("points: a file of points in the ring against Lame, in both stores") {
  const Folder folder;
  std::string csv = "body,x,y\n";
  int count = 0;
  for (double r : {1.1, 1.25, 1.4, 1.6, 1.8, 1.9})
    for (double angle : {0.1, 0.4, 0.8, 1.2, 1.5}) {
      csv += "1, " + std::to_string(r * std::cos(angle)) + ", " + std::to_string(r * std::sin(angle)) + "\n";
      ++count;
    }
  write_file(folder / "p", csv);
  const std::string run = "run " + quoted(kRing) + " --memory 64K --points " + quoted(folder / "p") + " --interior ";
  const Result memory = contact2d(run + quoted(folder / "a") + " --listing /dev/null --store memory");
  CHECK(memory.status == 0);
  CHECK(memory.err == "");
  CHECK(contact2d(run + quoted(folder / "b") + " --listing /dev/null --store file:" + quoted(folder / "tapes")).status == 0);
  CHECK(read_file(folder / "a") == read_file(folder / "b"));
  const std::vector<Row> rows = rows_of(read_file(folder / "a"));
  REQUIRE(rows.size() == static_cast<size_t>(count));
  double worst = 0;
  for (const Row& row : rows) {
    CHECK(row.body == 1);
    worst = std::max(worst, error_of(row));
  }
  MESSAGE("ring, 28 quadratic elements: " << worst);
  CHECK(worst < 1e-3); // measured 7.9e-4: the mesh
  // Standard input and output, the points without a heading: the same.
  const Result piped = run_shell("tail -n +2 " + quoted(folder / "p") + " | '" + paths::program() + "' run " + quoted(kRing) +
                                 " --memory 64K --points - --interior -");
  CHECK(piped.status == 0);
  CHECK(piped.out == read_file(folder / "a"));
}

TEST_CASE("points: outside, on the boundary, and next to it") {
  const Folder folder;
  // The middle of element arcs and sides: (1.5, 0) lies on the straight side y = 0, the inner arc ends at (1,
  // 0).
  write_file(folder / "p", "1,5,5\n1,1.5,0\n1,1.5,1.25e-7\n1,0.5,0.5\r\n\n1,1.55,1.2e-7\n1,1,0\n1,1.5,-1e-3\n1,1e300,0\n");
  const Result result =
      contact2d("run " + quoted(kRing) + " --points " + quoted(folder / "p") + " --interior " + quoted(folder / "i") +
                " --listing " + quoted(folder / "l") + " --json " + quoted(folder / "j"));
  CHECK(result.status == 0);
  const std::vector<Row> rows = rows_of(read_file(folder / "i"));
  REQUIRE(rows.size() == 8);
  for (size_t i : {0u, 3u, 6u, 7u}) CHECK(rows[i].outside());
  for (size_t i : {1u, 2u, 4u, 5u}) {
    CAPTURE(i);
    CHECK(!rows[i].outside());
    CHECK(error_of(rows[i]) < 1e-2); // measured 7.8e-3 at the corner (1, 0): the mesh
  }
  // Within 1e-6 of an element (0.125 long) from the boundary at the same place: the same field.
  CHECK(std::fabs(rows[1].ux - rows[2].ux) < 1e-6);
  CHECK(std::fabs(rows[1].uy - rows[2].uy) < 1e-6);
  CHECK(error_of(rows[2]) < 3e-3);
  CHECK(contains(result.err, "p:1:1: warning: point (5, 5) lies outside body 1\n"));
  CHECK(contains(result.err, "p:4:1: warning: point (0.5, 0.5) lies outside body 1\n"));
  CHECK(contains(result.err, "p:8:1: warning: point (1.5, -0.001) lies outside body 1\n"));
  CHECK(contains(result.err, "p: note: 2 points lie on the boundary: "));
  const std::string listing = read_file(folder / "l");
  CHECK(contains(listing, "\nInterior points\n"));
  CHECK(contains(listing, "  boundary\n"));
  CHECK(contains(listing, "            -            -  outside\n"));
  CHECK(contains(listing, "  point (5, 5) lies outside body 1\n")); // among the warnings
  const Json json = JsonReader::read(read_file(folder / "j"));
  CHECK(json["interior"]["points"].number == 8);
  CHECK(json["interior"]["boundary"].number == 2);
  CHECK(json["interior"]["outside"].number == 4);
  CHECK(json["warnings"].items.size() == 4);
}

TEST_CASE("points: more points outside than anyone would read") {
  const Folder folder;
  std::string csv;
  for (int i = 0; i < 50; ++i) csv += "1,7," + std::to_string(i) + "\n";
  write_file(folder / "p", csv + "1,1.5,0.2\n");
  const Result result = contact2d("run " + quoted(kRing) + " --points " + quoted(folder / "p") + " --interior -");
  CHECK(result.status == 0);
  CHECK(rows_of(result.out).size() == 51);
  CHECK(lines_of(result.err).size() == 21); // rows are not shown
  CHECK(contains(result.err, "p: warning: 30 more points lie outside their body\n"));
}

TEST_CASE("points: a point, a line and a clipped grid in the deck") {
  const Folder folder;
  write_file(folder / "d", ring_with(kThree));
  const Result result = contact2d("run " + quoted(folder / "d") + " --interior - --listing " + quoted(folder / "l") +
                                  " --json " + quoted(folder / "j") + " --vtk " + quoted(folder / "v"));
  CHECK(result.status == 0);
  CHECK(result.err == "");
  const std::vector<Row> rows = rows_of(result.out);
  REQUIRE(rows.size() > 5);
  CHECK(rows[0].x == 1.5);
  CHECK(rows[0].y == 0.1);
  const double at[] = {0.4, 0.7, 1.0, 1.3};
  for (size_t i = 0; i < 4; ++i) {
    CHECK(rows[1 + i].x == 1.2);
    CHECK(rows[1 + i].y == doctest::Approx(at[i]).epsilon(1e-14));
  }
  // What is left of the grid, row by row: all nodes between the circles. No node lies within 1e-3 of either
  // but those on the axes, which are on the boundary.
  size_t next = 5;
  int on_axes = 0, clipped = 0;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 9; ++i) {
      const double x = 0.25 * i, y = 0.5 * j, r = std::hypot(x, y);
      if (r < 1 || r > 2) {
        ++clipped;
        continue;
      }
      REQUIRE(next < rows.size());
      CHECK(rows[next].x == x);
      CHECK(rows[next].y == y);
      CHECK(!rows[next].outside());
      CHECK(error_of(rows[next]) < 1e-2); // as above
      on_axes += i == 0 || j == 0;
      ++next;
    }
  CHECK(next == rows.size());
  const Json json = JsonReader::read(read_file(folder / "j"));
  CHECK(json["interior"]["points"].number == static_cast<double>(rows.size()));
  CHECK(json["interior"]["boundary"].number == on_axes);
  CHECK(json["interior"]["clipped"].number == clipped);
  CHECK(json["interior"]["outside"].number == 0);
  // ParaView: cells of four corners where all are there; every point but the first five belongs to one or is
  // a vertex.
  const std::string vtk = read_file(folder / "v");
  const size_t types = vtk.find("CELL_TYPES");
  REQUIRE(types != std::string::npos);
  int quads = 0, vertices = 0;
  for (const std::string& line : lines_of(vtk.substr(types, vtk.find("CELL_DATA") - types))) {
    quads += line == "9";
    vertices += line == "1";
  }
  int cells = 0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 8; ++i) {
      const double x = 0.25 * i, y = 0.5 * j;
      cells += std::hypot(x, y) >= 1 && std::hypot(x + 0.25, y + 0.5) <= 2 && std::hypot(x + 0.25, y) >= 1 &&
               std::hypot(x, y + 0.5) >= 1 && std::hypot(x + 0.25, y) <= 2 && std::hypot(x, y + 0.5) <= 2;
    }
  CHECK(quads == cells);
  CHECK(cells > 5);
  CHECK(vertices >= 5);
  // The listing alone, and a file of points instead of the deck's.
  const Result listed = contact2d("run " + quoted(folder / "d"));
  CHECK(listed.status == 0);
  CHECK(contains(listed.out, "\nInterior points\n"));
  CHECK(lines_of(listed.out.substr(listed.out.find("Interior points"))).size() > rows.size());
  write_file(folder / "p", "1,1.5,0.2\n");
  CHECK(rows_of(contact2d("run " + quoted(folder / "d") + " --points " + quoted(folder / "p") + " --interior -").out).size() ==
        1);
  CHECK(contains(contact2d("check " + quoted(folder / "d")).out, "sets of interior points     3\n"));
  CHECK(!contains(contact2d("run " + quoted(kRing)).out, "Interior points"));
}

TEST_CASE("points: an axis of symmetry as images, points in the whole body") {
  const Folder folder;
  write_file(folder / "d", ring_with("*POINTS\ngrid 1 -2 -2 2 2 16 16\n"));
  const Result result = contact2d("run " + quoted(folder / "d") + " --symmetry images --interior -");
  CHECK(result.status == 0);
  const std::vector<Row> rows = rows_of(result.out);
  int quarter[4] = {0, 0, 0, 0};
  double worst = 0;
  for (const Row& row : rows) {
    ++quarter[(row.x < 0 ? 1 : 0) + (row.y < 0 ? 2 : 0)];
    worst = std::max(worst, error_of(row));
  }
  MESSAGE("four quarters: " << worst);
  CHECK(worst < 5e-3);
  for (int q : quarter) CHECK(q == quarter[0]);
  CHECK(quarter[0] > 20);
}

TEST_CASE("points: two bodies, and the last step of the last coefficient") {
  const Folder folder;
  const std::string hertz = paths::root() + "/examples/hertz.dat";
  write_file(folder / "p", "2,1,4\n1,1,4\n1,2,-2\n2,2,-2\n");
  const Result result = contact2d("run " + quoted(hertz) + " --points " + quoted(folder / "p") + " --interior - --boundary " +
                                  quoted(folder / "b"));
  CHECK(result.status == 0);
  const std::vector<Row> rows = rows_of(result.out);
  REQUIRE(rows.size() == 4);
  CHECK(!rows[0].outside());
  CHECK(rows[1].outside());
  CHECK(!rows[2].outside());
  CHECK(rows[3].outside());
  CHECK(contains(result.err, "p:2:1: warning: point (1, 4) lies outside body 1, but inside body 2\n"));
  CHECK(contains(result.err, "p:4:1: warning: point (2, -2) lies outside body 2, but inside body 1\n"));
  // Of the second coefficient, as --boundary: a boundary point has the displacement of its node there.
  const std::vector<std::string> boundary = lines_of(read_file(folder / "b"));
  std::vector<double> f;
  std::istringstream in(boundary[boundary.size() / 4]);
  for (std::string field; std::getline(in, field, ',');) f.push_back(std::stod(field));
  REQUIRE(f.size() == 9);
  std::ostringstream point;
  point.precision(17);
  point << f[0] << ',' << f[3] << ',' << f[4] << '\n';
  write_file(folder / "p", point.str());
  const std::vector<Row> one =
      rows_of(contact2d("run " + quoted(hertz) + " --points " + quoted(folder / "p") + " --interior -").out);
  REQUIRE(one.size() == 1);
  CHECK(one[0].ux == doctest::Approx(f[5]).epsilon(1e-9));
  CHECK(one[0].uy == doctest::Approx(f[6]).epsilon(1e-9));
}

TEST_CASE("points: nothing solved, nothing but the heading") {
  const Folder folder;
  std::string deck = ring_with("*POINTS\npoint 1 1.5 0.1\n");
  const size_t at = deck.find("    0    0\n");
  REQUIRE(at != std::string::npos);
  write_file(folder / "d", deck.replace(at, 10, "    0   -1"));
  const Result result = contact2d("run " + quoted(folder / "d") + " --interior -");
  CHECK(result.status == 0);
  CHECK(result.out == kHeader + "\n");
}

TEST_CASE("points: a run that is resumed has its points, whatever has become of the file") {
  const Folder folder;
  write_file(folder / "p", "1,1.5,0.1\n1,7,7\n");
  const Result first = run_shell("cat " + quoted(folder / "p") + " | '" + paths::program() + "' run " + quoted(kRing) +
                                 " --listing /dev/null --points - --interior " + quoted(folder / "i") +
                                 " --keep --store file:" + quoted(folder / "tapes"));
  REQUIRE(first.status == 0);
  const std::string rows = read_file(folder / "i");
  CHECK(rows_of(rows).size() == 2);
  fs::remove(folder / "p");
  fs::remove(folder / "i");
  const Result again = contact2d("resume " + quoted(folder / "tapes"));
  CHECK_MESSAGE(again.status == 0, again.err);
  CHECK(read_file(folder / "i") == rows);
}

TEST_CASE("points: faulty files of points") {
  const Folder in, out;
  struct Case {
    const char *text, *said;
  };
  const Case cases[] = {
      {"", "p: error: no points, expected rows body,x,y\n"},
      {"\n\n", "p: error: no points, expected rows body,x,y\n"},
      {"body,x,y\n", "p: error: no points, expected rows body,x,y\n"},
      {"2,1.5,0.1\n", "p:1:1: error: body is '2', expected 1, the only body\n"},
      {"1,1.5,0.1\n0,1.5,0.1\n", "p:2:1: error: body is '0', expected 1, the only body\n"},
      {"1.0,1.5,0.1\n", "p:1:1: error: body is '1.0', expected 1, the only body\n"},
      {"1, 1.5x,0.1\n", "p:1:4: error: x is '1.5x', expected a number\n"},
      {"1,1.5,\n", "p:1:7: error: y is '', expected a number\n"},
      {"1,1.5,inf\n", "p:1:7: error: y is 'inf', expected a number\n"},
      {"1,nan,1\n", "p:1:3: error: x is 'nan', expected a number\n"},
      {"1,1.5\n", "p:1:1: error: the row has 2 fields, expected 3 separated by commas: body,x,y\n"},
      {"1,1.5,0.1,0\n", "p:1:11: error: the row has 4 fields, expected 3 separated by commas: body,x,y\n"},
      {"1;1.5;0.1\n", "p:1:1: error: the row has 1 field, expected 3 separated by commas: body,x,y\n"},
      {"1 1.5 0.1\n", "p:1:1: error: the row has 1 field, expected 3 separated by commas: body,x,y\n"},
      {"x,y,body\n1.5,0.1,1\n", "p:1:1: error: body is 'x', expected 1, the only body\n"},
      {"1,1.5,0.1\nbody,x,y\n", "p:2:1: error: body is 'body', expected 1, the only body\n"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.text);
    write_file(in / "p", c.text);
    const Result result = contact2d("run " + quoted(kRing) + " --points " + quoted(in / "p") + " --interior " +
                                    quoted(out / "i") + " --listing " + quoted(out / "l"));
    CHECK(result.status == 2);
    CHECK_MESSAGE(contains(result.err, c.said), result.err);
    CHECK(result.err.compare(0, 11, "contact2d: ") == 0);
    CHECK(out.names().empty());
  }
  // All faults at once; what is only written in another way is none.
  write_file(in / "p", "3,a,b\n1,1,1\n1,c,1\n");
  const Result all = contact2d("run " + quoted(kRing) + " --points " + quoted(in / "p") + " --interior -");
  CHECK(all.status == 2);
  CHECK(lines_of(all.err).size() == 4);
  write_file(in / "p", "\xef\xbb\xbf"
                       "Body , X,Y\r\n\r\n 1 ,\t+1.5D0, 1E-1\r\n1,1.5,.1");
  const Result good = contact2d("run " + quoted(kRing) + " --points " + quoted(in / "p") + " --interior -");
  CHECK(good.status == 0);
  const std::vector<std::string> lines = lines_of(good.out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[1] == lines[2]);
  for (const std::string& name : {in / "missing", in.path()}) {
    const Result result = contact2d("run " + quoted(kRing) + " --points " + quoted(name) + " --interior -");
    CHECK(result.status == 2);
    CHECK_MESSAGE(contains(result.err, name + ": error: " + (name == in.path() ? "is no regular file" : "cannot be read: ")),
                  result.err);
  }
  write_file(in / "p", std::string("1,1,\0001\n", 8));
  CHECK(contact2d("run " + quoted(kRing) + " --points " + quoted(in / "p") + " --interior -").status == 2);
}

TEST_CASE("points: bad usage") {
  const Folder folder;
  write_file(folder / "p", "1,1.5,0.1\n");
  write_file(folder / "d", ring_with(kThree));
  const std::string ring = "run " + quoted(kRing) + " ", points = " --points " + quoted(folder / "p") + " ";
  const std::string wrong[] = {
      ring + "--interior -",                  // no points
      ring + points + "--csv -",              // nobody sees them
      ring + points + "--interior - --csv -", // two on standard output
      ring + points + "--interior " + quoted(folder / "p"),
      "run - --points - --interior x",
      "run " + quoted(folder / "d") + " --interior " + quoted(folder / "d"),
      ring + "--points",
      ring + "--interior= --points p",
  };
  for (const std::string& arguments : wrong) {
    const Result result = contact2d(arguments);
    CHECK_MESSAGE(result.status == 64, arguments);
    CHECK_MESSAGE(result.err.compare(0, 11, "contact2d: ") == 0, result.err);
    CHECK_MESSAGE(result.out.empty(), arguments);
  }
  CHECK(contains(contact2d(ring + "--interior -").err, "no points are given, expected --points FILE or *POINTS"));
  CHECK(read_file(folder / "p") == "1,1.5,0.1\n");
  // A listing shows them.
  CHECK(contains(contact2d(ring + points).out, "\nInterior points\n"));
}

TEST_CASE("points: cards of *POINTS") {
  using namespace deck_test;
  const auto with_cards = [](const std::vector<std::string>& cards) {
    std::vector<std::string> deck = squares();
    deck.insert(deck.end(), cards.begin(), cards.end());
    return read(joined(deck));
  };
  const Reading good = with_cards(
      {"*points", "POINT 2 0.5 0.25", "line 1 0 0 1 1 5", "*UNITS mm N", "*POINTS", "Grid, 2, 0 0, 1 1, 3 4 ! clipped"});
  CHECK(good.status == C2D_OK);
  CHECK(good.faults.empty());
  CHECK(good.sizes.point_sets == 3);
  std::vector<std::vector<double>> sets;
  for (const Call& call : good.model.calls)
    if (call.name == "points") sets.push_back(call.numbers);
  CHECK(sets ==
        std::vector<std::vector<double>>{{0, 2, 1, 1, 0.5, 0.25, 0, 0}, {1, 1, 5, 1, 0, 0, 1, 1}, {2, 2, 3, 4, 0, 0, 1, 1}});
  struct Wrong {
    const char *card, *text;
    int column, column_end;
  };
  const Wrong wrong[] = {
      {"circle 1 0 0 1", "expected one of: point, line, grid", 1, 6},
      {"point 3 0 0", "body number is 3, expected 1 to 2", 7, 7},
      {"point x 0 0", nullptr, 7, 7},
      {"point 1 0", "the card ends here, expected y", 10, 10},
      {"point 1 0 0 5", "the card has 5 fields, expected 4", 13, 13},
      {"point 1 a 0", nullptr, 9, 9},
      {"line 1 0 0 1 1", "the card ends here, expected number of points", 15, 15},
      {"line 1 0 0 1 1 0", nullptr, 16, 16},
      {"line 1 0 0 1 1 -3", nullptr, 16, 17},
      {"line 1 0 0 1 1 2.5", nullptr, 16, 18},
      {"grid 1 0 0 1 1 5", "the card ends here, expected number of points in y", 17, 17},
      {"grid 1 0 0 1 1 0 5", nullptr, 16, 16},
      {"grid 1 0 0 1 1 5 0", nullptr, 18, 18},
      {"grid 1 0 0 1 1 50000 50000", "the grid has more than 1073741823 points", 22, 26},
  };
  for (const Wrong& w : wrong) {
    CAPTURE(w.card);
    const Reading r = with_cards({"*POINTS", "point 1 0.5 0.5", w.card});
    CHECK(r.status == C2D_ERR_INPUT);
    REQUIRE(r.faults.size() == 1);
    CHECK(r.faults[0].line == static_cast<int>(squares().size()) + 3);
    if (w.text != nullptr) CHECK(r.faults[0].text == w.text);
    CHECK(r.faults[0].column == w.column);
    CHECK(r.faults[0].column_end == w.column_end);
  }
  Reading r = with_cards({"*POINTS 1"});
  REQUIRE(!r.faults.empty());
  CHECK(r.faults[0].text == "the card has 1 field, expected 0");
  r = with_cards({"*POINTS"});
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].text == "*POINTS without cards, expected at least one: point, line or grid");
  r = with_cards({"*POINT"});
  REQUIRE(r.faults.size() == 1);
  CHECK(r.faults[0].text == "*POINT is not a known keyword; did you mean *POINTS?");
}

TEST_CASE("points: convert carries the cards") {
  const Folder folder;
  write_file(folder / "d", ring_with(kThree));
  REQUIRE(contact2d("convert " + quoted(folder / "d") + " -o " + quoted(folder / "free")).status == 0);
  REQUIRE(contact2d("convert " + quoted(folder / "free") + " -o " + quoted(folder / "fixed")).status == 0);
  const Result first = contact2d("run " + quoted(folder / "d") + " --interior -");
  CHECK(first.status == 0);
  for (const char* name : {"free", "fixed"}) {
    const std::string deck = read_file(folder / name);
    CHECK(contains(deck, "*POINTS\n"));
    CHECK(contains(deck, "grid 1 0 0 2 2 9 5\n"));
    CHECK(contact2d("run " + quoted(folder / name) + " --interior -").out == first.out);
  }
}

namespace {

c2d_points set_of(int32_t kind, int32_t body, int32_t nx, int32_t ny, double x0, double y0, double x1, double y1) {
  c2d_points p = C2D_INIT(c2d_points);
  p.kind = kind;
  p.body = body;
  p.count[0] = nx;
  p.count[1] = ny;
  p.from[0] = x0, p.from[1] = y0, p.to[0] = x1, p.to[1] = y1;
  return p;
}

} // namespace

TEST_CASE("points: sets by calls") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  runs::Deck deck = runs::deck_named("plate");
  host::Limits limits = deck.limits();
  limits.point_sets = 2;
  uint64_t need = 0;
  REQUIRE(c2d_memory_need(&limits, &need, nullptr, nullptr) == C2D_OK);
  runs::Machine machine(limits, need, nullptr);
  c2d_solver* s = machine.solver;
  REQUIRE(machine.created == C2D_OK);
  const c2d_points good = set_of(C2D_POINTS_GRID, 1, 3, 2, 0, 1, 4, 2);
  CHECK(c2d_add_points(s, nullptr) == C2D_ERR_ARGUMENT);
  for (const c2d_points& wrong :
       {set_of(3, 1, 1, 1, 0, 0, 0, 0), set_of(-1, 1, 1, 1, 0, 0, 0, 0), set_of(C2D_POINTS_ONE, 0, 1, 1, 0, 0, 0, 0),
        set_of(C2D_POINTS_ONE, 2, 1, 1, 0, 0, 0, 0), set_of(C2D_POINTS_ONE, 1, 1, 1, nan, 0, 0, 0),
        set_of(C2D_POINTS_LINE, 1, 0, 1, 0, 0, 1, 1), set_of(C2D_POINTS_LINE, 1, 2, 1, 0, 0, 1, nan),
        set_of(C2D_POINTS_GRID, 1, 2, 0, 0, 0, 1, 1), set_of(C2D_POINTS_GRID, 1, 65536, 65536, 0, 0, 1, 1)}) {
    CHECK(c2d_add_points(s, &wrong) == C2D_ERR_ARGUMENT);
    CHECK(std::string(runs::error_of(s).text).size() > 10);
    CHECK(c2d_get_state(s) == C2D_STATE_EMPTY);
  }
  c2d_points told = C2D_INIT(c2d_points);
  CHECK(c2d_get_points(s, 1, &told) == C2D_ERR_STATE);

  // With the deck's own: there is room for two.
  deck.lines.insert(deck.lines.end(), {"*POINTS", "line 1 0 0 3 6 4", "point 1 7 8"});
  REQUIRE(deck.limits().point_sets == 2);
  REQUIRE(runs::read_deck(s, deck) == C2D_OK);
  CHECK(c2d_add_points(s, &good) == C2D_ERR_STATE);
  REQUIRE(c2d_get_points(s, 1, &told) == C2D_OK);
  CHECK(told.kind == C2D_POINTS_LINE);
  CHECK(told.body == 1);
  CHECK(told.count[0] == 4);
  CHECK(told.line == static_cast<int32_t>(deck.lines.size()) - 1);
  CHECK(told.to[1] == 6);
  double xy[12];
  int32_t total = 0;
  REQUIRE(c2d_expand_points(&told, 2, 3, xy, 3, &total) == C2D_OK);
  CHECK(total == 4);
  CHECK(xy[0] == 1);
  CHECK(xy[1] == 2);
  CHECK(xy[6] == 3);
  CHECK(xy[7] == 6);
  REQUIRE(c2d_get_points(s, 2, &told) == C2D_OK);
  CHECK(told.kind == C2D_POINTS_ONE);
  REQUIRE(c2d_expand_points(&told, 1, 1, xy, 2, &total) == C2D_OK);
  CHECK(total == 1);
  CHECK(xy[0] == 7);
  CHECK(xy[1] == 8);
  CHECK(c2d_get_points(s, 3, &told) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_points(s, 0, &told) == C2D_ERR_ARGUMENT);
  CHECK(c2d_get_points(s, 1, nullptr) == C2D_ERR_ARGUMENT);

  // One set more than limits allow, from calls and from a deck.
  runs::Machine other(limits, need, nullptr);
  CHECK(c2d_add_points(other.solver, &good) == C2D_OK);
  CHECK(c2d_get_state(other.solver) == C2D_STATE_BUILDING);
  CHECK(c2d_add_points(other.solver, &good) == C2D_OK);
  CHECK(c2d_add_points(other.solver, &good) == C2D_ERR_LIMIT);
  deck.lines.push_back("point 1 7 9");
  runs::Machine third(limits, need, nullptr);
  CHECK(runs::read_deck(third.solver, deck) == C2D_ERR_LIMIT);
  CHECK(runs::error_of(third.solver).line == static_cast<int32_t>(deck.lines.size()));
  CHECK(machine.guards_are_whole());
  CHECK(other.guards_are_whole());

  // Expansion alone.
  REQUIRE(c2d_expand_points(&good, 1, 6, xy, 2, nullptr) == C2D_OK);
  const double grid[] = {0, 1, 2, 1, 4, 1, 0, 2, 2, 2, 4, 2};
  for (int i = 0; i < 12; ++i) CHECK(xy[i] == grid[i]);
  CHECK(c2d_expand_points(&good, 1, 7, xy, 2, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_expand_points(&good, 7, 1, xy, 2, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_expand_points(&good, 0, 1, xy, 2, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_expand_points(&good, 1, -1, xy, 2, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_expand_points(&good, 1, 1, nullptr, 2, nullptr) == C2D_ERR_ARGUMENT);
  CHECK(c2d_expand_points(&good, 1, 0, nullptr, 2, &total) == C2D_OK);
  CHECK(total == 6);
  CHECK(c2d_expand_points(nullptr, 1, 0, nullptr, 2, nullptr) == C2D_ERR_ARGUMENT);
  const c2d_points single = set_of(C2D_POINTS_GRID, 1, 1, 1, 5, 6, 7, 8);
  REQUIRE(c2d_expand_points(&single, 1, 1, xy, 2, nullptr) == C2D_OK);
  CHECK(xy[0] == 5);
  CHECK(xy[1] == 6);
}

TEST_CASE("points: invariants of the stress along the boundary") {
  // Against the eigenvalues of the tensor that the other fields tell.
  for (const char* name : {"ring3", "plate", "sample"}) { // plane strain, plane stress, contact
    CAPTURE(name);
    const runs::Deck deck = runs::deck_named(name);
    const host::Limits limits = deck.limits();
    uint64_t need = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &need, nullptr) == C2D_OK);
    runs::RamStore store;
    c2d_port port = C2D_INIT(c2d_port);
    store.serve(port);
    runs::Machine machine(limits, need, &port);
    runs::Numbers ignored;
    REQUIRE(runs::run_all(machine.solver, deck, ignored) == C2D_OK);
    const int32_t ends = limits.body[0].elements * limits.function_nodes;
    std::vector<double> v[9];
    for (int32_t field = 0; field < 9; ++field) {
      v[field].resize(static_cast<size_t>(ends));
      REQUIRE(c2d_get(machine.solver, C2D_END_SXX + field, 1, 1, ends, v[field].data(), 1) == C2D_OK);
    }
    double largest = 0;
    for (size_t i = 0; i < static_cast<size_t>(ends); ++i) {
      const double xx = v[0][i], yy = v[1][i], xy = v[2][i], zz = v[3][i], s1 = v[7][i], s2 = v[8][i];
      const double size = std::fabs(s1) + std::fabs(s2) + 1e-12;
      largest = std::max(largest, size);
      CHECK(std::fabs(s1 + s2 - xx - yy) < 1e-12 * size);
      CHECK(std::fabs(s1 * s2 - (xx * yy - xy * xy)) < 1e-12 * size * size);
      CHECK(std::fabs(v[6][i] - 0.5 * (s1 - s2)) < 1e-12 * size);
      CHECK(s1 >= s2);
      const double mises = std::sqrt(0.5 * ((s1 - s2) * (s1 - s2) + (s2 - zz) * (s2 - zz) + (zz - s1) * (zz - s1)));
      CHECK(std::fabs(v[5][i] - mises) < 1e-7 * size);
    }
    CHECK(largest > 1);
  }
}
