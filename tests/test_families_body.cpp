// One body: ring, hole and cantilever against closed forms.
#include "family_runs.hpp"

#include <doctest/doctest.h>

using namespace families_test;

TEST_CASE("families: ring against Lame") {
  const double A = 1.0 / 3, B = 4.0 / 3, E = 1000, nu = 0.3; // a = 1, b = 2, unit pressure inside
  for (const char* order : {"order=2", "order=3"}) {
    const Solution s = solve("ring", {order});
    REQUIRE_MESSAGE(s.error.empty(), s.error);
    for (const EndRow& end : s.ends) {
      const double r = std::hypot(end.x, end.y);
      const double u = (1 + nu) / E * ((1 - 2 * nu) * A * r + B / r);
      CHECK(std::hypot(end.ux, end.uy) == doctest::Approx(u).epsilon(5e-5)); // measured 1.1e-5
      if (end.y == 0 && end.ty != 0) CHECK(-end.ty == doctest::Approx(A + B / (r * r)).epsilon(5e-3));
    }
  }
}

TEST_CASE("families: hole against Kirsch") {
  // Infinite plate, nu = 0.3, E = 1000, S = R = 1: ux(1, 0), uy(0, 1) in plane strain.
  const auto check = [](const std::vector<std::string>& settings, double tolerance) {
    const Solution s = solve("hole", settings);
    REQUIRE_MESSAGE(s.error.empty(), s.error);
    bool seen[2] = {false, false};
    for (const EndRow& end : s.ends) {
      if (end.x == 1 && end.y == 0) {
        CHECK(end.ux == doctest::Approx(2.73e-3).epsilon(tolerance));
        seen[0] = true;
      }
      if (end.x == 0 && end.y == 1) {
        CHECK(end.uy == doctest::Approx(-0.91e-3).epsilon(tolerance));
        if (end.tx != 0) CHECK(-end.tx == doctest::Approx(3).epsilon(tolerance + 1e-2)); // measured 3e-3
        seen[1] = true;
      }
    }
    CHECK(seen[0]);
    CHECK(seen[1]);
  };
  check({}, 1e-4);                        // the square with the tractions of the infinite plate; measured 1e-5
  check({"L=10"}, 1e-4);                  // its size does not matter then
  check({"outer=uniform", "L=40"}, 1e-2); // with S alone the difference falls with (R/L)^2
}

TEST_CASE("families: a hole in plates of growing size with uniform tension comes near the infinite plate") {
  double before = 0;
  for (const char* size : {"L=5", "L=10", "L=20"}) {
    const Solution s = solve("hole", {"outer=uniform", size});
    REQUIRE_MESSAGE(s.error.empty(), s.error);
    double error = 0;
    for (const EndRow& end : s.ends)
      if (end.x == 1 && end.y == 0) error = std::fabs(end.ux / 2.73e-3 - 1);
    if (before > 0) CHECK(before / error > 3); // 4 for the square of the size
    before = error;
  }
}

TEST_CASE("families: cantilever against the exact solution") {
  const Solution s = solve("cantilever");
  REQUIRE_MESSAGE(s.error.empty(), s.error);
  int seen = 0;
  for (const std::vector<double>& row : reference("p10_cantilever"))
    for (const EndRow& end : s.ends) {
      if (std::fabs(end.x - row[0]) > 1e-9 || std::fabs(end.y - row[1]) > 1e-9) continue;
      CHECK(end.ux == doctest::Approx(row[5]).epsilon(2e-4).scale(0.05));
      CHECK(end.uy == doctest::Approx(row[6]).epsilon(2e-4).scale(0.05)); // measured 4.5e-5
      ++seen;
    }
  CHECK(seen >= 6);
}
