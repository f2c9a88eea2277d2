// The sketches of bodies of revolution under examples/revolution and of lesson 13: closed forms, statics, plane strain far from
// the axis, another program, other meshes. True errors lie within the stated ones, and these within what was asked.
#include "effort.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

using namespace test;

namespace {

const double kPi = std::acos(-1.0);

struct Number {
  double value = NAN, x = NAN, error = NAN;
};

// Numbers of the last state of a run.
class Run {
public:
  explicit Run(const std::string& sketch, const std::string& parameters = "", const std::string& other = "") {
    const Folder folder;
    std::string text = read_file(paths::root() + "/examples/" + sketch + ".c2s");
    if (!other.empty()) text.replace(text.find("axisymmetric"), 12, other);
    write_file(folder / "a.c2s", text);
    const Result run = run_shell("'" + paths::program() + "' run -q '" + (folder / "a.c2s") + "' " + parameters +
                                 " --summary '" + (folder / "s.csv") + "'");
    REQUIRE_MESSAGE(run.status == 0, sketch << ": " << run.err);
    for (const std::string& line : lines_of(read_file(folder / "s.csv"))) rows_.push_back(split(line));
    REQUIRE(rows_.size() > 2);
  }
  Number of(const std::string& quantity, int item = 0, int zone = 1) const {
    const std::vector<std::string>& last = rows_.back();
    Number out;
    for (const std::vector<std::string>& row : rows_)
      if (row.size() > 10 && row[1] == last[1] && row[5] == quantity && std::atoi(row[6].c_str()) == item &&
          (std::atoi(row[3].c_str()) == zone || row[3].empty()))
        out = Number{std::atof(row[7].c_str()), std::atof(row[8].c_str()), std::atof(row[10].c_str())};
    REQUIRE_MESSAGE(std::isfinite(out.value), quantity);
    return out;
  }

private:
  static std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> out(1);
    for (char c : line) {
      if (c == ',')
        out.emplace_back();
      else
        out.back().push_back(c);
    }
    return out;
  }
  std::vector<std::vector<std::string>> rows_;
};

// Within the stated error, and that within a percent. `model`: what the reference leaves out, or its last digit.
void check_number(const Number& number, double exact, double model = 0) {
  CHECK(number.error <= 0.0101 * std::fabs(number.value));
  CHECK(std::fabs(number.value - exact) <= number.error + model * std::fabs(exact));
}

} // namespace

TEST_CASE("revolution: hollow sphere, nu up to 1/2: Lame") {
  for (const char* nu : {"nu=0.5", "nu=0.3"})
    check_number(Run("revolution/thick_sphere", nu).of("largest stress along inside"), 10 * (2 * 1e3 + 8e3) / (2 * 7e3));
}

TEST_CASE("revolution: ball on a flat: Hertz; with friction, another program") {
  const double modulus = 1000 / 0.91, p0 = 2 * modulus / (kPi * 100);
  const Run smooth("revolution/ball_on_flat", "mu=0"), rough("revolution/ball_on_flat");
  check_number(smooth.of("peak pressure"), p0, 0.042 / 100); // -0.042 a/R of a ball that is no half space
  check_number(smooth.of("force y"), 4 * modulus / 300, 1e-6);
  CHECK(std::fabs(smooth.of("contact edge", 1).x - 1) < 0.005);
  check_number(rough.of("peak pressure"), 1.0806 * p0, 3e-3);
  CHECK(std::fabs(rough.of("stick border", 1).x / rough.of("contact edge", 1).x - 0.711) < 0.01);
}

TEST_CASE("revolution: round punch: the half space, from blocks of two sizes") {
  const Number small = Run("revolution/round_punch").of("force y"),
               large = Run("revolution/round_punch", "size=180").of("force y");
  const double exact = 2 * 1000 / 0.91 * 0.001;
  CHECK(std::fabs((3 / large.value - 1 / small.value) / 2 * exact - 1) <
        1.5 * large.error / large.value + 0.5 * small.error / small.value);
  CHECK(small.error < 0.01 * small.value);
  CHECK(large.error < 0.01 * large.value);
}

TEST_CASE("revolution: hub on a shaft: another program") {
  const double area = 2 * kPi * 20 * 20;
  for (double mu : {0.0, 0.15})
    check_number(Run("revolution/hub", mu == 0 ? "mu=0" : "mu=0.15").of("force x"), -area * (mu == 0 ? 80.604 : 81.717), 1e-4);
}

TEST_CASE("revolution: washer: in line and smooth it is a column; else a finer mesh of another order") {
  const double force = 50 * kPi * (14 * 14 - 8 * 8);
  const Run column("revolution/washer", "inner=8 outer=14 mu=0"), washer("revolution/washer"),
      fine("revolution/washer", "", "functions cubic\ntolerance " + effort<std::string>("0.5 %", "0.1 %") + "\naxisymmetric");
  check_number(column.of("force y"), force, 1e-6);
  check_number(column.of("mean pressure"), 50, 1e-6);
  CHECK(std::fabs(column.of("force x").value) < 1e-6 * force);
  check_number(washer.of("force y"), force, 1e-6);
  check_number(washer.of("approach"), fine.of("approach").value, 1e-3);
  const Number radial = washer.of("force x"); // its error is one of the whole force
  CHECK(std::fabs(radial.value - fine.of("force x").value) < radial.error);
  CHECK(radial.error < 0.01 * force);
}

TEST_CASE("revolution: O-ring: forces balance; far from the axis it is a seal in plane strain") {
  const std::string coarse = effort("\ntolerance 5 %", "");
  const Run ring("tutorial/t13_o_ring", "", "axisymmetric" + coarse);
  const double carried = ring.of("force y", 0, 1).value + ring.of("force y", 0, 2).value;
  CHECK(carried == doctest::Approx(-ring.of("force y", 0, 3).value).epsilon(1e-6));
  if (!in_full()) return;
  const Run far("tutorial/t13_o_ring", "r=2000"), plane("tutorial/t13_o_ring", "r=2000", "plane strain");
  for (int zone : {1, 3}) {
    const Number seal = plane.of("force y", 0, zone);
    check_number(far.of("force y", 0, zone), seal.value * 2 * kPi * 2000, seal.error / std::fabs(seal.value));
  }
  const Number peak = plane.of("peak pressure");
  check_number(far.of("peak pressure"), peak.value, peak.error / peak.value);
}

TEST_CASE("revolution: Belleville spring: Almen and Laszlo") {
  // A ring whose section turns, free to contract across: E, not E/(1 - nu^2). Loads act where the rounded edges touch.
  const double h = 0.75, round = 0.2, slope = std::atan(h / 12.5), shift = round * (std::cos(slope) - std::sin(slope));
  const double arm = 12.5 - 2 * shift - std::tan(slope);
  const double k = 1 / kPi * 0.25 / (3 - 2 / std::log(2.0));
  const double force = 4 * 206e3 * 0.05 / (k * 2500) * (h * h + 1) * std::pow(12.5 / arm, 2);
  const Run spring("revolution/belleville");
  check_number(spring.of("force y"), force, 0.01); // the theory's own error
  CHECK(spring.of("force y", 0, 1).value == doctest::Approx(-spring.of("force y", 0, 2).value).epsilon(1e-6));
}

TEST_CASE("revolution: ball in a conical seat: statics; the pressure of a line") {
  const double load = 2 * kPi * 25;
  for (double angle : {30.0, 45.0}) {
    const Run smooth("revolution/ball_in_cone", "mu=0 angle=" + std::to_string(angle));
    const double s = std::sin(angle * kPi / 180), c = std::cos(angle * kPi / 180);
    check_number(smooth.of("force y"), load, 1e-6);
    check_number(smooth.of("force x"), -load * s / c, 1e-3); // the normal turns by the width of the contact
    const double line = load / c / (2 * kPi * 5 * s);
    check_number(smooth.of("peak pressure"), std::sqrt(line * 210e3 / 1.82 / (kPi * 5)), 3e-3);
  }
}

TEST_CASE("revolution: a platen on a bar: the exponent of its edge is that of the plane") {
  // Fixed and free faces of a right angle: sin^2(pi e/2) = (4 (1 - nu)^2 - e^2)/(3 - 4 nu), Williams 1952.
  const Folder folder;
  write_file(folder / "a.c2s",
             "axisymmetric\nbody bar E 2600 nu 0.3\nfrom 0 0\nline base to 1 0\nline side to 1 3\nline top to 0 3\n"
             "fix bar.base y\nplaten bar.top y -0.01\ntolerance off\n");
  const Result run =
      run_shell("'" + paths::program() + "' run -q '" + (folder / "a.c2s") + "' --json '" + (folder / "j") + "'");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  const std::string text = read_file(folder / "j");
  const size_t at = text.find("\"exponents\": [");
  REQUIRE(at != std::string::npos);
  const double e = std::atof(text.c_str() + at + 14), sine = std::sin(kPi * e / 2);
  CHECK(sine * sine == doctest::Approx((4 * 0.49 - e * e) / 1.8).epsilon(1e-6));
  CHECK((e > 0.5 && e < 1));
}
