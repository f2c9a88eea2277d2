// Contours and axes against exact areas and labels.
#include "report/drawn/axes.hpp"
#include "report/pictures/contour.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace {

double area_of(const app::Polygons& polygons) {
  double sum = 0.0;
  for (const auto& polygon : polygons) {
    double twice = 0.0;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const app::Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      twice += a.x * b.y - a.y * b.x;
    }
    sum += 0.5 * std::fabs(twice);
  }
  return sum;
}

app::Grid make_grid(size_t columns, size_t rows, double (*f)(double, double)) {
  app::Grid g;
  g.columns = columns;
  g.rows = rows;
  g.dx = 1.0 / static_cast<double>(columns - 1);
  g.dy = 1.0 / static_cast<double>(rows - 1);
  for (size_t r = 0; r < rows; ++r)
    for (size_t c = 0; c < columns; ++c) {
      const app::Point p = g.place(c, r);
      g.values.push_back(f(p.x, p.y));
      g.known.push_back(1);
    }
  return g;
}

} // namespace

TEST_CASE("contours: bands of a plane have their exact areas") {
  const app::Grid g = make_grid(14, 9, [](double x, double y) { return x + y; });
  const std::vector<app::Polygons> bands = app::fill_bands(g, {0.0, 0.5, 1.0, 1.5, 2.0});
  REQUIRE(bands.size() == 4);
  const double exact[] = {0.125, 0.375, 0.375, 0.125}; // corner triangles of the unit square
  for (size_t k = 0; k < 4; ++k) CHECK(area_of(bands[k]) == doctest::Approx(exact[k]).epsilon(1e-12));
}

TEST_CASE("contours: bands of a paraboloid converge to discs and cover the square once") {
  double last = 1.0;
  for (const size_t n : {11u, 41u}) {
    const app::Grid g = make_grid(n, n, [](double x, double y) { return x * x + y * y; });
    const std::vector<app::Polygons> bands = app::fill_bands(g, {0.0, 0.25, 0.81, 2.0});
    double sum = 0.0;
    for (const auto& band : bands) sum += area_of(band);
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-12));
    const double pi = 3.14159265358979323846;
    const double error = std::fabs(area_of(bands[1]) - pi / 4.0 * (0.81 - 0.25));
    CHECK(error < 0.2 * last); // second order would be 1/16
    last = error;
  }
  CHECK(last < 1e-3);
}

TEST_CASE("contours: values beyond the levels belong to the outer bands, unknown cells to none") {
  app::Grid g = make_grid(3, 3, [](double x, double) { return 10.0 * x - 5.0; });
  g.known[g.at(2, 2)] = 0;
  const std::vector<app::Polygons> bands = app::fill_bands(g, {-1.0, 0.0, 1.0});
  CHECK(area_of(bands[0]) + area_of(bands[1]) == doctest::Approx(0.75));
}

TEST_CASE("contours: a plane is continued exactly") {
  app::Grid g = make_grid(9, 9, [](double x, double y) { return 2.0 * x - 3.0 * y + 1.0; });
  const app::Grid whole = g;
  for (size_t r = 0; r < 9; ++r)
    for (size_t c = 0; c < 9; ++c)
      if (c + r > 10) g.values[g.at(c, r)] = 99.0, g.known[g.at(c, r)] = 0;
  app::extend(g, 2);
  for (size_t i = 0; i < g.values.size(); ++i)
    if (g.known[i]) CHECK(g.values[i] == doctest::Approx(whole.values[i]).epsilon(1e-12));
  CHECK(g.known[g.at(5, 6)] == 1);
  CHECK(g.known[g.at(8, 8)] == 0);
}

TEST_CASE("contours: inside and outside of a ring") {
  const std::vector<std::vector<app::Point>> ring = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
  CHECK(app::is_inside(ring, {0.5, 0.5}));
  CHECK(!app::is_inside(ring, {2.0, 2.0}));
  CHECK(!app::is_inside(ring, {5.0, 2.0}));
}

TEST_CASE("axes: steps of 1, 2 or 5, labels without rounding, power of ten in the name") {
  const auto axis_of = [](double low, double high, int about) {
    app::Range range;
    range.include(low);
    range.include(high);
    return app::make_axis(range, "p", "MPa", about);
  };
  for (const double size : {1e-9, 3.7e-5, 0.02, 1.0, 47.0, 1.3e4, 8e11})
    for (const double low : {0.0, -0.3, 0.9}) {
      const app::Axis a = axis_of(low * size, size, 6);
      CHECK(a.low <= low * size + 1e-6 * a.step);
      CHECK(a.high >= size - 1e-6 * a.step);
      CHECK(a.ticks >= 3);
      CHECK(a.ticks <= 14);
      for (int i = 0; i < a.ticks; ++i) {
        std::string label = a.label(i);
        if (label.compare(0, 7, "&#8722;") == 0) label = "-" + label.substr(7);
        CHECK(std::stod(label) * a.power == doctest::Approx(a.tick(i)).epsilon(1e-9).scale(a.step));
        CHECK(label.size() <= 8);
      }
    }
  CHECK(axis_of(0.0, 1.0, 5).name == "p [MPa]");
  CHECK(axis_of(0.0, 8e11, 5).name == "p [10&#8313; MPa]");
  const app::Axis constant = axis_of(5.0, 5.0, 5);
  CHECK(constant.low < 5.0);
  CHECK(constant.high > 5.0);
}
