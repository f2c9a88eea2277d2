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

} // namespace

TEST_CASE("tutorial: its deck is the example, its commands run, its figures are so") {
  const std::string page = read_file(kRoot + "/examples/TUTORIAL.md");
  std::string deck;
  for (const std::string& block : blocks(page, ""))
    if (block.compare(0, 5, "*FREE") == 0) deck = block;
  CHECK(deck == read_file(kRoot + "/examples/roller.dat"));

  const Folder folder; // a project's folder with nothing but what the page needs
  fs::create_directories(folder / "build");
  fs::create_directory_symlink(kRoot + "/examples", folder / "examples");
  fs::create_symlink(paths::program(), folder / "build/contact2d");
  std::vector<std::string> printed;
  for (const std::string& commands : blocks(page, "sh")) {
    const Result run = run_shell("cd '" + folder.path() + "' && set -e\n" + commands);
    CHECK_MESSAGE(run.status == 0, commands << run.err);
    if (contains(commands, "roller.lst")) CHECK(contains(run.err, "coarse contact: the zone of slip"));
    printed.push_back(run.out);
  }
  REQUIRE(printed.size() == 6);
  CHECK(contains(printed[0], "equations                   75, 89"));
  CHECK(contains(page, "`75, 89`"));
  CHECK(contains(printed[0], "warnings                    0"));

  // Hertz
  const double modulus = 1 / ((1 - 0.4 * 0.4) / 3000 + (1 - 0.3 * 0.3) / 210000), pi = std::acos(-1.0);
  const double a = std::sqrt(4 * 100 * 20 / (pi * modulus)), p0 = 2 * 100 / (pi * a);
  check_told(page, "3517 MPa", modulus, 1e-4);
  check_told(page, "0.851 mm", a, 5e-4);
  check_told(page, "74.8 MPa", p0, 5e-4);
  check_told(page, "74.82 |", p0, 1e-4);
  check_told(page, "52.9 MPa", p0 * std::sqrt(0.5), 5e-4);

  // Place, status, pressure without friction, as awk prints them.
  const std::vector<std::string> printed_rows = lines_of(printed[2]);
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
  CHECK(lines_of(printed[4]).size() == 15);
  check_told(page, "54.1 MPa", back[14].tn, 2e-3);
  CHECK(std::fabs(back_smooth[14].tn - p0 * std::sqrt(0.5)) < 0.005 * p0);
  check_told(page, "0.598", back[8].x, 1e-3);
  check_told(page, "-8.33 to", rough[8].tt);
  check_told(page, "0.56.", back[8].tt, 0.02);

  // Stress inside.
  double shear = 0, depth = 0;
  REQUIRE(std::sscanf(printed[5].c_str(), "%lf %lf", &shear, &depth) == 2);
  check_told(page, "23.3 MPa at", shear, 5e-3);
  check_told(page, "0.6 mm", -depth, 1e-6);
  for (const char* file : {"roller.html", "roller/tractions_2.svg", "roller/model.svg"})
    CHECK(fs::exists(folder / ("build/" + std::string(file))));
}
