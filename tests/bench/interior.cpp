// Displacements and stresses at many points inside.
#include "bench.hpp"
#include "model.hpp"

namespace bench {

void interior_points() {
  heading("Interior points: 200 x 200 under a disc's boundary of 1000 linear elements, one core");
  const Disc disc = {1000};
  const Solver solver(disc.limits());
  disc.build(solver);
  solver.must(c2d_prepare(solver));
  const double none = 0, load = 1;
  c2d_outcome outcome = C2D_REACHED;
  solver.must(c2d_begin(solver, &none, 0));
  solver.must(c2d_advance(solver, &load, 1, &outcome));
  c2d_points grid = C2D_INIT(c2d_points);
  grid.kind = C2D_POINTS_GRID, grid.body = 1, grid.count[0] = grid.count[1] = 200;
  grid.from[0] = grid.from[1] = -0.7, grid.to[0] = grid.to[1] = 0.7;
  const int32_t count = 40000;
  std::vector<double> xy(2 * static_cast<size_t>(count)), out(C2D_POINT_FIELDS * static_cast<size_t>(count));
  solver.must(c2d_expand_points(&grid, 1, count, xy.data(), 2, nullptr));
  const double seconds = time_of(
      3, 1, [&] { solver.must(c2d_interior(solver, 1, count, xy.data(), 2, out.data(), C2D_POINT_FIELDS)); });
  row("interior.200x200", seconds * 1e3, "ms", judged("interior.seconds", seconds, "<=", 1, "s"));
  row("interior.rate", count / seconds, "points/s");
}

} // namespace bench
