// Stresses at every recorded step and their ranges: --stresses and --ranges, and results asked for inside a run's step.
#include "paths.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <memory>

using namespace test;

namespace {

Result contact2d(const std::string& arguments) { return run_shell("'" + paths::program() + "' " + arguments); }

// Rows by column; an empty field is infinite, so that it equals no number.
using Row = std::map<std::string, double>;
std::vector<Row> table_of(const std::string& csv) {
  const auto fields_of = [](const std::string& line) {
    std::vector<std::string> out;
    std::istringstream in(line + ",");
    for (std::string field; std::getline(in, field, ',');) out.push_back(field);
    return out;
  };
  const std::vector<std::string> lines = lines_of(csv);
  REQUIRE(!lines.empty());
  const std::vector<std::string> names = fields_of(lines[0]);
  std::vector<Row> rows;
  for (size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> fields = fields_of(lines[i]);
    REQUIRE(fields.size() == names.size());
    Row row;
    for (size_t k = 0; k < fields.size(); ++k) row[names[k]] = fields[k].empty() ? INFINITY : std::stod(fields[k]);
    rows.push_back(row);
  }
  return rows;
}

// Lame's ring (examples/thick_ring.dat), its pressure raised, lowered to a fifth and raised again.
std::string pulsating_ring() {
  std::string deck = read_file(paths::root() + "/examples/thick_ring.dat");
  const std::string once = "    1    1\n    1 1.00000000\n",
                    thrice = "    3    1\n    2 1.00000000\n    4 0.20000000\n    4 1.00000000\n";
  const size_t at = deck.find(once);
  REQUIRE(at != std::string::npos);
  return deck.replace(at, once.size(), thrice);
}
double hoop_in_ring(double r) { return 100.0 / 3 + 400.0 / 3 / (r * r); }
double mises_in_ring(double r) {
  const double rr = 200.0 / 3 - hoop_in_ring(r), tt = hoop_in_ring(r), zz = 20.0;
  return std::sqrt(0.5 * ((rr - tt) * (rr - tt) + (tt - zz) * (tt - zz) + (zz - rr) * (zz - rr)));
}

} // namespace

TEST_CASE("stresses: a ring under pulsating pressure, states and ranges against Lame") {
  const Folder folder;
  write_file(folder / "deck", pulsating_ring());
  write_file(folder / "points", "body,x,y\n1,1.5,0.01\n1,1.06,1.06\n1,5,5\n");
  const Result result = contact2d("run '" + (folder / "deck") + "' -q --no-progress --points '" + (folder / "points") +
                                  "' --stresses '" + (folder / "s") + "' --ranges '" + (folder / "r") + "'");
  CHECK(result.status == 0);
  const std::vector<Row> states = table_of(read_file(folder / "s")), ranges = table_of(read_file(folder / "r"));
  REQUIRE(ranges.size() > 3);
  CHECK(states.size() == 10 * ranges.size());
  int inside = 0, along = 0, outside = 0;
  for (size_t i = 0; i < ranges.size(); ++i) {
    Row range = ranges[i], last = states[9 * ranges.size() + i];
    CAPTURE(i);
    CHECK(range["first"] == 2);
    CHECK(range["last"] == 10);
    for (const char* same : {"body", "element", "point", "x", "y"}) CHECK(range[same] == last[same]);
    const double r = std::hypot(last["x"], last["y"]);
    if (r > 3) {
      ++outside;
      CHECK(std::isnan(last["von_mises"]));
      CHECK(std::isnan(range["von_mises_range"]));
      continue;
    }
    for (size_t step = 0; step < 10; ++step) { // no contact: everything is proportional to the load
      Row row = states[step * ranges.size() + i];
      for (const char* name : {"sxx", "syy", "sxy", "szz", "s1", "s2", "von_mises"})
        CHECK(row[name] == doctest::Approx(row["load"] * last[name]).scale(100).epsilon(1e-9));
    }
    CHECK(range["von_mises_most"] == doctest::Approx(last["von_mises"]).epsilon(1e-9));
    CHECK(range["von_mises_range"] == doctest::Approx(0.8 * last["von_mises"]).epsilon(1e-9));
    if (last["point"] > 0) {
      ++inside;
      CHECK(std::isinf(last["hoop"]));
      CHECK(std::fabs(range["s1_most"] - hoop_in_ring(r)) < 0.1);
      CHECK(std::fabs(range["s1_least"] - 0.2 * hoop_in_ring(r)) < 0.02);
      CHECK(std::fabs(last["von_mises"] - mises_in_ring(r)) < 0.1);
    } else if (std::fabs(r - 2) < 1e-3 && last["x"] * last["y"] > 0.01) { // the outer circle, free of tractions
      ++along;
      CHECK(std::fabs(range["hoop_most"] - hoop_in_ring(2)) < 0.5);
      CHECK(range["hoop_least"] == doctest::Approx(0.2 * range["hoop_most"]).epsilon(1e-9));
    }
  }
  CHECK(inside == 2);
  CHECK(outside == 1);
  CHECK(along > 20);
}

TEST_CASE("stresses: the last step is that of --interior and --boundary, points outside a grid are left out") {
  const Folder folder;
  write_file(folder / "deck", read_file(made("mindlin")) + "*POINTS\ngrid 2 -2 -1 2 1 5 5\n");
  const Result result =
      contact2d("run '" + (folder / "deck") + "' -q --no-progress --stresses '" + (folder / "s") + "' --interior '" +
                (folder / "i") + "' --boundary '" + (folder / "b") + "' --csv '" + (folder / "c") + "'");
  CHECK(result.status == 0);
  CHECK(contact2d("run '" + made("mindlin") + "' -q --no-progress --csv '" + (folder / "alone") + "'").status == 0);
  CHECK(read_file(folder / "c") == read_file(folder / "alone")); // what is asked on the way changes nothing
  const std::vector<Row> states = table_of(read_file(folder / "s")), points = table_of(read_file(folder / "i")),
                         ends = table_of(read_file(folder / "b"));
  const size_t places = ends.size() + points.size();
  CHECK(points.size() < 25);
  REQUIRE(states.size() % places == 0);
  const size_t last = states.size() - places;
  for (size_t i = 0; i < ends.size(); ++i) {
    Row row = states[last + i], end = ends[i];
    for (const char* same : {"body", "element", "x", "y"}) CHECK(row[same] == end[same]);
  }
  for (size_t i = 0; i < points.size(); ++i) {
    Row row = states[last + ends.size() + i], point = points[i];
    for (const char* same : {"body", "x", "y", "sxx", "syy", "sxy", "szz"}) CHECK(row[same] == point[same]);
    CHECK(row["von_mises"] == doctest::Approx(point["von_mises"]).epsilon(1e-10));
    CHECK(0.5 * (row["s1"] - row["s2"]) == doctest::Approx(point["max_shear"]).epsilon(1e-10));
  }
  CHECK(table_of(read_file(folder / "s"))[last]["load2"] == 1);
}

namespace {

// The deck read, and prepared.
struct Solver {
  runs::RamStore store;
  c2d_port port = C2D_INIT(c2d_port);
  std::unique_ptr<runs::Machine> machine;
  Solver(runs::Deck deck, bool every_change) {
    store.serve(port);
    const host::Limits limits = deck.limits();
    uint64_t bytes = 0;
    REQUIRE(c2d_memory_need(&limits, nullptr, &bytes, nullptr) == C2D_OK);
    machine = std::make_unique<runs::Machine>(limits, bytes, &port);
    c2d_options options = C2D_INIT(c2d_options);
    options.every_change = every_change;
    REQUIRE(c2d_read_deck(*this, runs::Deck::read, &deck) == C2D_OK);
    REQUIRE(c2d_set_options(*this, &options) == C2D_OK);
    REQUIRE(c2d_prepare(*this) == C2D_OK);
  }
  operator c2d_solver*() const { return machine->solver; }
};

} // namespace

TEST_CASE("interface: results asked for inside a run's step are those of the same load reached by calls") {
  const auto ask = [](c2d_solver* s, std::vector<double>& out) {
    const double place[2] = {0.3, -0.5};
    double row[C2D_POINT_FIELDS], ends[40];
    CHECK(c2d_get(s, C2D_END_HOOP, 1, 1, 40, ends, 1) == C2D_OK);
    CHECK(c2d_interior(s, 0, 1, place, 2, row, C2D_POINT_FIELDS) == C2D_OK);
    out.insert(out.end(), ends, ends + 40);
    out.insert(out.end(), row, row + C2D_POINT_FIELDS);
  };
  struct Asked {
    test::Callable<void(std::vector<double>&)> ask;
    std::vector<double> loads;
    std::vector<std::vector<double>> answers;
    int busy = 0;
  };
  const runs::Deck deck = runs::deck_named("sample");
  const Solver whole(deck, false), calls(deck, false);
  Asked asked;
  asked.ask = [&](std::vector<double>& out) { ask(whole, out); };
  const c2d_step_fn step = [](void* context, const c2d_step* now) {
    Asked& self = *static_cast<Asked*>(context);
    self.loads.push_back(now->load);
    self.answers.emplace_back();
    self.ask(self.answers.back());
    return 0;
  };
  REQUIRE(c2d_run(whole, step, &asked) == C2D_OK);
  double mu = 0;
  REQUIRE(c2d_get_friction(calls, 0, 1, &mu) == C2D_OK);
  REQUIRE(c2d_begin(calls, &mu, 1) == C2D_OK);
  REQUIRE(asked.loads.size() > 1);
  for (size_t i = 0; i < asked.loads.size() && asked.loads[i] >= (i > 0 ? asked.loads[i - 1] : 0); ++i) {
    c2d_outcome outcome = C2D_FREE_MOTION;
    REQUIRE(c2d_advance(calls, &asked.loads[i], 1, &outcome) == C2D_OK);
    std::vector<double> answer;
    ask(calls, answer);
    CAPTURE(i);
    CHECK(answer == asked.answers[i]);
  }
  // A change of status on the way is no state that c2d_run can come back to.
  const Solver again(deck, true);
  struct Changes {
    c2d_solver* solver;
    int seen = 0, refused = 0;
  } changes{again};
  const c2d_step_fn refused = [](void* context, const c2d_step* now) {
    Changes& self = *static_cast<Changes*>(context);
    double x = 0;
    if (now->kind == C2D_STEP_CHANGE)
      ++self.seen, self.refused += c2d_get(self.solver, C2D_END_HOOP, 1, 1, 1, &x, 1) == C2D_ERR_BUSY;
    return 0;
  };
  CHECK(c2d_run(again, refused, &changes) == C2D_OK);
  CHECK(changes.seen > 0);
  CHECK(changes.refused == changes.seen);
}
