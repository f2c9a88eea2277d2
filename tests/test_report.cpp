// Numbers as the reports print them, against the C library.
#include "report/text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

namespace {

std::string number(double value) {
  std::string out;
  app::append_number(out, value);
  return out;
}

std::string printed(const char* format, double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, format, digits, value);
  return text;
}

} // namespace

TEST_CASE("report: numbers with few digits look as %.12g prints them") {
  const double values[] = {1.0,
                           -1.0,
                           10.0,
                           0.1,
                           0.4,
                           2.8,
                           1.03,
                           213.0,
                           1e5,
                           -0.001,
                           0.0001,
                           0.00001,
                           123456.75,
                           1e11,
                           1e12,
                           1.5e12,
                           9.5e-5,
                           1e22,
                           1e23,
                           1e30,
                           1e31,
                           1e-20,
                           1e-33,
                           1e-34,
                           1e-300,
                           1e300,
                           999999999999.0,
                           0.5,
                           1.0 / 3,
                           2.0 / 3e7,
                           1e-5 / 3,
                           1e15 / 7,
                           4e-310,
                           0.9999999999996,
                           0.99999999999949};
  for (const double v : values) {
    CHECK(number(v) == printed("%.*g", v, 12));
    CHECK(number(-v) == printed("%.*g", -v, 12));
  }
  CHECK(number(0.0) == "0");
  CHECK(number(-0.0) == "0");
  CHECK(number(std::numeric_limits<double>::infinity()) == "inf");
}

TEST_CASE("report: any number is within half a unit of its twelfth digit") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(1.0, 10.0), exponent(-40.0, 40.0);
  int differ = 0;
  for (int i = 0; i < 200000; ++i) {
    const double v = mantissa(random) * std::pow(10.0, std::floor(exponent(random)));
    const std::string text = number(v);
    if (text != printed("%.*g", v, 12)) ++differ;
    const double unit = std::pow(10.0, std::floor(std::log10(v)) - 11.0);
    REQUIRE_MESSAGE(std::fabs(std::strtod(text.c_str(), nullptr) - v) <= 0.502 * unit, text);
    REQUIRE(text.size() <= 18);
  }
  CHECK(differ <= 200); // near ties alone: one value in a thousand at the very most
}

TEST_CASE("report: columns are right-aligned, in scientific and general form") {
  std::mt19937_64 random(8);
  std::normal_distribution<double> values(0.0, 1e3);
  for (int i = 0; i < 20000; ++i) {
    const double v = values(random);
    std::string scientific, general;
    app::append_scientific(scientific, v, 16, 5);
    app::append_general(general, v, 15, 8);
    REQUIRE(scientific.size() == 16);
    REQUIRE(general.size() == 15);
    REQUIRE(std::strtod(scientific.c_str(), nullptr) == doctest::Approx(v).epsilon(5.1e-6));
    REQUIRE(std::strtod(general.c_str(), nullptr) == doctest::Approx(v).epsilon(5.1e-8));
  }
  std::string out;
  app::append_scientific(out, -1234.4, 14, 3);
  app::append_scientific(out, 0.0, 11, 3);
  app::append_scientific(out, 9.9996e-7, 11, 3);
  app::append_column(out, int64_t{-42}, 5);
  app::append_column(out, "open", 6);
  CHECK(out == "    -1.234e+03  0.000e+00  1.000e-06  -42  open");
}
