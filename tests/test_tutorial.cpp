// The tutorial: its deck is the example's, its commands run, its figures are what they print.
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

using namespace test;

namespace {

const std::string kRoot = paths::root();

// Blocks of a page fenced with this word behind the fence.
std::vector<std::string> blocks(const std::string& text, const std::string& language) {
  std::vector<std::string> out;
  bool inside = false, wanted = false;
  for (const std::string& line : lines_of(text)) {
    if (line.compare(0, 3, "```") == 0) {
      inside = !inside;
      wanted = inside && line == "```" + language;
      if (wanted) out.emplace_back();
    } else if (wanted) {
      out.back() += line + "\n";
    }
  }
  return out;
}

// The page says `told`, and the run gave `value`: within the part `tolerance` of it.
void check_told(const std::string& page, const std::string& told, double value, double tolerance = 0.01) {
  CHECK_MESSAGE(contains(page, told), told);
  const double number = std::strtod(told.c_str(), nullptr);
  CHECK_MESSAGE(std::fabs(value - number) <= tolerance * std::fabs(number), told << ": " << value);
}

// Rows x, status, tn, tt of a step of a coefficient in a contact CSV.
struct Row {
  double x, tn, tt;
  std::string status;
};
std::vector<Row> rows_of(const std::string& csv, double mu, int step) {
  std::vector<Row> out;
  for (const std::string& line : lines_of(csv)) {
    double m, load, x, y, tn, tt;
    int s, pair;
    char status[8] = {};
    if (std::sscanf(line.c_str(), "%lf,%d,%lf,%d,%lf,%lf,%7[a-z],%lf,%lf", &m, &s, &load, &pair, &x, &y, status, &tn, &tt) ==
            9 &&
        m == mu && s == step)
      out.push_back({x, tn, tt, status});
  }
  return out;
}

double largest_friction(const std::vector<Row>& rows) {
  double out = 0;
  for (const Row& row : rows) out = std::max(out, std::fabs(row.tt));
  return out;
}
double last_contact(const std::vector<Row>& rows) {
  double out = 0;
  for (const Row& row : rows)
    if (row.status != "open") out = std::max(out, row.x);
  return out;
}
double dissipated(const std::string& json) {
  const size_t at = json.rfind("\"dissipated\": ");
  return at == std::string::npos ? -1 : std::strtod(json.c_str() + at + 14, nullptr);
}

// The example of three bodies: what the last command printed.
void check_three_bodies(const std::string& page, const std::string& printed) {
  const std::vector<std::string> lines = lines_of(printed);
  REQUIRE(lines.size() > 50);
  double load, fx, fy, moment, ux, uy, rotation;
  REQUIRE(std::sscanf(lines[0].c_str(), "0.1,10,%lf,3,%lf,%lf,%lf,%lf,%lf,%lf", &load, &fx, &fy, &moment, &ux, &uy,
                      &rotation) == 7);
  CHECK(load == 1);
  CHECK(std::fabs(fx) < 1e-9);
  CHECK(std::fabs(fy - 200) < 1e-9);
  CHECK(std::fabs(moment - 200) < 2e-4); // the rounded ends lie a little above the coating
  check_told(page, "0.00797 mm", -uy, 1e-3);
  check_told(page, "-5.34e-4", rotation, 1e-3);
  double first = 0, last = 0, peak = 0, at = 0, bond = 0, shear = 0, at_shear = 0, tension = 0;
  for (size_t i = 1; i < lines.size(); ++i) {
    int zone;
    double x, tn, tt;
    char status[8] = {};
    REQUIRE(std::sscanf(lines[i].c_str(), "%d %lf %7[a-z] %lf %lf", &zone, &x, status, &tn, &tt) == 5);
    CHECK((std::string(status) == "tied") == (zone == 1));
    if (zone == 2) {
      first = std::min(first, x);
      last = std::max(last, x);
      if (tn > peak) peak = tn, at = x;
      continue;
    }
    bond = std::max(bond, tn);
    tension = std::min(tension, tn);
    if (std::fabs(tt) > shear) shear = std::fabs(tt), at_shear = x;
  }
  check_told(page, "-5.57 to", first, 1e-3);
  check_told(page, "6.14.", last, 1e-3);
  check_told(page, "25.5 MPa", peak, 1e-3);
  check_told(page, "5.14,", at, 1e-3);
  check_told(page, "21.1 MPa", bond, 2e-3);
  check_told(page, "6.65 MPa", shear, 1e-3);
  CHECK(std::fabs(at_shear - 6) < 1e-9);
  CHECK(tension > -0.01);
  // By hand: a bed of springs below 11 mm.
  const double bed = 3000 * (1 - 0.4) / ((1 + 0.4) * (1 - 2 * 0.4)) / 2, width = 11;
  check_told(page, "3214 N/mm^3", bed, 1e-3);
  check_told(page, "0.0057 mm", 200 / width / bed, 0.01);
  check_told(page, "5.6e-4", 200 / (bed * width * width * width / 12), 0.01);
}

// The sketch that the page begins with: it is the example, and its run gives what the page tells.
void check_sketch(const std::string& page, const std::string& checked, const std::string& printed) {
  CHECK(contains(page, "```\n" + read_file(kRoot + "/examples/roller.c2s") + "```\n"));
  CHECK(contains(checked, "body 1 (plate), body 2 (roller), zone 1 (top on face)"));
  const std::vector<std::string> lines = lines_of(printed);
  REQUIRE(lines.size() == 3);
  check_told(page, "76.4 MPa", std::stod(lines[0]), 2e-3);
  check_told(page, "23.3 MPa", std::stod(lines[1]), 5e-3);
  check_told(page, "74.9 MPa", std::stod(lines[2]), 2e-3);
}

} // namespace

TEST_CASE("tutorial: its deck is the example, its commands run, its figures are so") {
  const std::string page = read_file(kRoot + "/examples/TUTORIAL.md");
  std::string deck;
  for (const std::string& block : blocks(page, ""))
    if (block.compare(0, 5, "*FREE") == 0) deck = block;
  CHECK(deck == read_file(kRoot + "/examples/roller.dat"));
  const std::string three = read_file(kRoot + "/examples/three_bodies.dat"), from = three.substr(three.find("\n*ZONE") + 1);
  CHECK(contains(page, "```\n" + from + "```\n"));

  const Folder folder; // a project's folder with nothing but what the page needs
  fs::create_directories(folder / "build");
  fs::create_directory_symlink(kRoot + "/examples", folder / "examples");
  fs::create_symlink(paths::program(), folder / "build/contact2d");
  std::vector<std::string> printed;
  for (const std::string& commands : blocks(page, "sh")) {
    const Result run = run_shell("cd '" + folder.path() + "' && set -e\n" + commands);
    CHECK_MESSAGE(run.status == 0, commands << run.err);
    if (contains(commands, "roller.lst")) CHECK(contains(run.err, "coarse contact: the slip zone"));
    if (contains(commands, "three.lst")) CHECK(contains(run.err, "the tied zone 1 joins unlike materials"));
    printed.push_back(run.out);
  }
  REQUIRE(printed.size() == 9);
  check_sketch(page, printed[0], printed[1]);
  CHECK(contains(printed[2], "equations                   75, 89"));
  CHECK(contains(page, "`75, 89`"));
  CHECK(contains(printed[2], "warnings                    0"));

  // Hertz
  const double modulus = 1 / ((1 - 0.4 * 0.4) / 3000 + (1 - 0.3 * 0.3) / 210000), pi = std::acos(-1.0);
  const double a = std::sqrt(4 * 100 * 20 / (pi * modulus)), p0 = 2 * 100 / (pi * a);
  check_told(page, "3517 MPa", modulus, 1e-4);
  check_told(page, "0.851 mm", a, 5e-4);
  check_told(page, "74.8 MPa", p0, 5e-4);
  check_told(page, "74.82 |", p0, 1e-4);
  check_told(page, "52.9 MPa", p0 * std::sqrt(0.5), 5e-4);

  // Place, status, pressure without friction, as awk prints them.
  const std::vector<std::string> printed_rows = lines_of(printed[4]);
  REQUIRE(printed_rows.size() == 15);
  CHECK(contains(printed_rows[5], "open"));
  CHECK(contains(printed_rows[6], "slip"));
  const auto smooth = rows_of(read_file(folder / "build/roller.csv"), 0, 10),
             rough = rows_of(read_file(folder / "build/roller.csv"), 0.2, 10);
  REQUIRE(smooth.size() == 15);
  REQUIRE(rough.size() == 15);
  check_told(page, "0.897", smooth[5].x, 1e-3);
  check_told(page, "0.798", smooth[6].x, 1e-3);
  check_told(page, "23.2 MPa", smooth[6].tn);
  check_told(page, "74.9 MPa", smooth[14].tn, 2e-3);
  CHECK(smooth[14].tn > 0.99 * p0);
  CHECK(smooth[14].tn < 1.01 * p0);
  CHECK(contains(read_file(folder / "build/roller.lst"), "5.0000000e+01")); // the balance, N per mm

  // Twice as fine.
  const auto fine = rows_of(read_file(folder / "build/fine.csv"), 0, 10),
             fine_rough = rows_of(read_file(folder / "build/fine.csv"), 0.2, 10);
  REQUIRE(fine.size() == 29);
  check_told(page, "74.86 |", smooth[14].tn, 2e-3);
  check_told(page, "74.88 |", fine[28].tn, 2e-3);
  check_told(page, "0.798 |", last_contact(smooth), 1e-3);
  check_told(page, "0.847 |", last_contact(fine), 1e-3);
  check_told(page, "76.3 |", rough[14].tn, 2e-3);
  check_told(page, "76.4 |", fine_rough[28].tn, 2e-3);
  check_told(page, "8.33 |", largest_friction(rough));
  check_told(page, "8.31 |", largest_friction(fine_rough));
  check_told(page, "5.7e-5 |", dissipated(read_file(folder / "build/roller.json")), 0.1);
  check_told(page, "3.9e-5 |", dissipated(read_file(folder / "build/fine.json")), 0.1);

  // Back to a half.
  const auto back = rows_of(read_file(folder / "build/unload.csv"), 0.2, 15),
             back_smooth = rows_of(read_file(folder / "build/unload.csv"), 0, 15);
  REQUIRE(back.size() == 15);
  CHECK(lines_of(printed[6]).size() == 15);
  check_told(page, "54.1 MPa", back[14].tn, 2e-3);
  CHECK(std::fabs(back_smooth[14].tn - p0 * std::sqrt(0.5)) < 0.005 * p0);
  check_told(page, "0.598", back[8].x, 1e-3);
  check_told(page, "-8.33 to", rough[8].tt);
  check_told(page, "0.56.", back[8].tt, 0.02);

  // Stress inside.
  double shear = 0, depth = 0;
  REQUIRE(std::sscanf(printed[7].c_str(), "%lf %lf", &shear, &depth) == 2);
  check_told(page, "23.3 MPa at", shear, 5e-3);
  check_told(page, "0.6 mm", -depth, 1e-6);
  check_three_bodies(page, printed[8]);
  for (const char* file : {"roller.html", "roller/tractions_2.svg", "roller/model.svg"})
    CHECK(fs::exists(folder / ("build/" + std::string(file))));
}
