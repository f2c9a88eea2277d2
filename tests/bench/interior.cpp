// Displacements and stresses at many points inside.
#include "../callable.hpp"
#include "bench.hpp"
#include "model.hpp"

#include <memory>

namespace bench {

namespace {

// A disc of linear elements, solved, and a grid of points in it.
struct Grid {
  Solver solver;
  int32_t count;
  std::vector<double> xy, out;
  Grid(int32_t elements, int32_t points) : Grid(Disc{elements}, points) {}
  Grid(const Disc& disc, int32_t points)
      : solver(disc.limits()), count(points * points), xy(2 * static_cast<size_t>(count)),
        out(C2D_POINT_FIELDS * static_cast<size_t>(count)) {
    disc.build(solver);
    solver.must(c2d_prepare(solver));
    const double none = 0, load = 1;
    c2d_outcome outcome = C2D_REACHED;
    solver.must(c2d_begin(solver, &none, 0));
    solver.must(c2d_advance(solver, &load, 1, &outcome));
    c2d_points grid = C2D_INIT(c2d_points);
    grid.kind = C2D_POINTS_GRID, grid.body = 1, grid.count[0] = grid.count[1] = points;
    grid.from[0] = grid.from[1] = -0.7, grid.to[0] = grid.to[1] = 0.7;
    solver.must(c2d_expand_points(&grid, 1, count, xy.data(), 2, nullptr));
  }
  void evaluate() { solver.must(c2d_interior(solver, 1, count, xy.data(), 2, out.data(), C2D_POINT_FIELDS)); }
};

} // namespace

test::Callable<void()> interior_job(int32_t elements, int32_t points) {
  const auto grid = std::make_shared<Grid>(elements, points);
  return [grid] { grid->evaluate(); };
}

void interior_points() {
  heading("Interior points: 200 x 200 under a disc's boundary of 1000 linear elements, one core");
  Grid grid(1000, 200);
  const double seconds = time_of(3, 1, [&] { grid.evaluate(); });
  row("interior.200x200", seconds, "s", judged("interior.seconds", seconds, "<=", 1, ""));
  row("interior.rate", grid.count / seconds, "points/s");
}

} // namespace bench
