// Tolerances of parameters: statements, derivatives against closed forms and drawn samples, what has no derivative.
#include "effort.hpp"
#include "estimate_truth.hpp"
#include "json.hpp"
#include "program/estimate/kept.hpp"
#include "program/estimate/tolerances.hpp"
#include "program/estimate/wanted.hpp"
#include "program/sketch/same_divisions.hpp"
#include "shell.hpp"
#include "sketches.hpp"

#include <cmath>
#include <cstdio>

using namespace sketch;
using namespace sketches;

namespace {

// A solved sketch and what its parameters do to its numbers.
struct Toleranced {
  std::string text;
  Sketch sketch;
  Mesh mesh;
  estimate::Trial trial;
  estimate::Demand demand;
  std::vector<app::Stated> stated;
  app::ToleranceTable table;
  int solved = 0; // further solutions asked for
};

estimate::Redraw redraw_of(Toleranced& t) {
  return [&t](const Parameters& changed) {
    ++t.solved;
    return sketches::read(t.text, changed);
  };
}

// By the loop over meshes, or on the first mesh.
void find(const std::string& text, Toleranced& out) {
  out.text = text;
  out.sketch = sound(text);
  estimate::ask(out.sketch, out.demand);
  if (out.sketch.adapts) {
    estimate::Adapted found = estimate::adapt(out.sketch, out.demand, [](const app::MeshRound&) {});
    REQUIRE_MESSAGE(found.status == C2D_OK, found.why);
    out.sketch = std::move(found.sketch), out.mesh = std::move(found.mesh), out.trial = std::move(found.trial);
    out.stated = std::move(found.loop.stated);
  } else {
    out.mesh = given_mesh(out.sketch);
    out.demand.drawn = true;
    std::string why;
    REQUIRE_MESSAGE(estimate::solve(deck_of(out.sketch, out.mesh), out.demand, out.trial, why) == C2D_OK, why);
  }
  out.table = estimate::tolerances_of({out.sketch, out.mesh, out.trial}, out.stated, redraw_of(out), out.demand, nullptr);
}

const app::Toleranced& number_of(const app::ToleranceTable& table, const std::string& name) {
  for (const app::Toleranced& t : table.numbers)
    if (table.name_of(t) == name) return t;
  FAIL("no number " << name);
  return table.numbers.front();
}

// d ln(number) / d ln(parameter); of an edge by its x.
double elasticity(const app::ToleranceTable& table, const std::string& name, size_t parameter) {
  const app::Toleranced& t = number_of(table, name);
  CHECK_MESSAGE(t.by[parameter].why.empty(), name << ": " << t.by[parameter].why);
  return t.by[parameter].derivative * table.parameters[parameter].value / t.number.value;
}

// Half of two half-plane-like bodies, pressed by 2 P: a^2 = 4 (2 P) R (1 - nu^2) 2 / (pi E).
std::string half_hertz(const std::string& parameters, const std::string& more) {
  return parameters + R"(
parameter L 24 nu 0.3
symmetry x 0
body block E E nu nu
  from 0 -L
  line bottom to L -L
  line right  to L 0
  line top    to 0 0
body pad E E nu nu
  from 0 0
  curve face t 0 L x t y {t^2/(2*R)}
  line right to L L
  line top   to 0 L
contact block.top pad.face mu 0
fix block.bottom
platen pad.top about 0 L x 0 fy -P turn 0
)" + more;
}

// A bar of length L that is pulled: all is in closed form, on any mesh.
const char* const kBar = R"(
body bar E E nu 0
  from 0 0
  line s to L 0
  line e to L 1
  line n to 0 1
  line w close
fix bar.w x
fix bar.s.start y
traction bar.e fx p
stress bar L/2 0.5
want approach at bar 1.5 0.5 bar 1 0.5
tolerance off
)";

Tolerance tolerance_of(const std::string& parameter) {
  const Sketch s = sound(parameter + "\n" + kSquare);
  REQUIRE(s.tolerances.size() == 1);
  return s.tolerances[0];
}

std::string refused(const std::string& parameter) { return fault(parameter + "\n" + kSquare); }

} // namespace

TEST_CASE("tolerances: statements") {
  const Sketch s = sound("parameter R 50 +- 0.01  mu 0.3 +- 5 %  n 4 k 2*R +-1%, L -20+-(0.1*n)\n" + std::string(kSquare));
  REQUIRE(s.tolerances.size() == 4);
  const char* const names[] = {"R", "mu", "k", "L"};
  const double values[] = {50, 0.3, 100, -20}, sizes[] = {0.01, 0.015, 1, 0.4};
  for (size_t i = 0; i < 4; ++i) {
    CHECK(s.tolerances[i].parameter == names[i]);
    CHECK(s.tolerances[i].value == doctest::Approx(values[i]));
    CHECK(s.tolerances[i].size == doctest::Approx(sizes[i]));
  }
  CHECK(tolerance_of("parameter L -20 +- 1%").size == doctest::Approx(0.2));
  const Tolerance at = tolerance_of("parameter R 50+-0.5");
  CHECK(at.at.line == 1);
  CHECK(at.at.column == 15);
  CHECK(sound("parameter R 50 +- 0\n" + std::string(kSquare)).tolerances.empty());
  CHECK(sound("parameter R +-3\n" + std::string(kSquare)).parameters.at("R") == -3); // a sign before a sign, as ever
  // A value from outside keeps the tolerance, a share is one of it, and another tolerance takes precedence.
  const std::string text = "parameter R 50 +- 0.01 E 2 +- 10 %\n" + std::string(kSquare);
  const Sketch given = read_sketch(text, {{"R", 51}, {"E", 4}}, nullptr).sketch;
  CHECK(given.tolerances[0].value == 51);
  CHECK(given.tolerances[0].size == 0.01);
  CHECK(given.tolerances[1].size == doctest::Approx(0.4));
  CHECK(read_sketch(text, {{"R", 51}}, nullptr, {{"R", 0.25}}).sketch.tolerances[0].size == 0.25);
}

TEST_CASE("tolerances: what is no tolerance is reported with line and column") {
  CHECK(refused("parameter R 50 +-") == "1:18 the statement ends here, expected the tolerance of R");
  CHECK(refused("parameter R +- 0.01") == "1:13 '+-': expected the value of R before its tolerance");
  CHECK(refused("parameter R 50 +- -0.01") == "1:19 -0.01: expected the tolerance of R, not below 0");
  CHECK(refused("parameter R 50 +- much") == "1:19 'much': expected the tolerance of R");
  CHECK(refused("parameter R 50 +- inf") == "1:19 'inf' is not a finite number, expected the tolerance of R");
  CHECK(refused("parameter R 50 +- 0/0").find("1:19 '0/0' is not a finite number") == 0);
  CHECK(refused("parameter mu inf +- 1") == "1:18 mu is infinite, expected a finite value before a tolerance");
}

TEST_CASE("tolerances: a bar that is pulled, by closed forms, two pairs of solutions for each parameter") {
  Toleranced t;
  find("parameter E 200 +- 1 %  p 3 +- 0.1  L 2 +- 0.01  idle 7 +- 1" + std::string(kBar), t);
  const double E = 200, p = 3, a = -p / E * 0.5; // the points are 0.5 apart
  REQUIRE(t.table.parameters.size() == 4);
  CHECK(t.table.why.empty());
  const app::Toleranced& approach = number_of(t.table, "approach of points");
  CHECK(approach.number.value == doctest::Approx(a).epsilon(1e-9));
  CHECK(approach.by[0].derivative == doctest::Approx(-a / E).epsilon(1e-4));
  CHECK(approach.by[1].derivative == doctest::Approx(a / p).epsilon(1e-7));
  CHECK(approach.by[2].derivative == 0);
  CHECK(approach.by[3].derivative == 0);
  const double shares[] = {-a / E * 2, -a / p * 0.1};
  CHECK(t.table.worst_case(approach) == doctest::Approx(shares[0] + shares[1]).epsilon(1e-4));
  CHECK(t.table.root_of_squares(approach) == doctest::Approx(std::hypot(shares[0], shares[1])).epsilon(1e-4));
  CHECK(t.solved == 4 * 4);
}

TEST_CASE("tolerances: Hertz, pressure and edge by radius, modulus and load to 1e-3") {
  Toleranced t;
  find(half_hertz("parameter R 50 +- 0.01  E 2e5 +- 2 %  P 100 +- 3",
                  "want pressure edges width approach  pressure at block.top 0.27 0 1 %\n"),
       t);
  CHECK(t.stated.size() > 0);
  CHECK(t.solved == 3 * 6);
  const double half[] = {0.5, -0.5, 0.5}, of_peak[] = {-0.5, 0.5, 0.5};
  for (size_t p = 0; p < 3; ++p) {
    CAPTURE(p);
    CHECK(elasticity(t.table, "peak pressure", p) == doctest::Approx(of_peak[p]).epsilon(1e-3));
    CHECK(elasticity(t.table, "half width", p) == doctest::Approx(half[p]).epsilon(5e-3));
  }
  // At a given place, past which the elements move, it is less accurate, or named.
  const double a2 = 8 * 100 * 50 * 2 * 0.91 / 2e5 / 3.14159265358979, x2 = 0.27 * 0.27; // p ~ sqrt(a^2 - x^2) / R
  const app::Toleranced& at = number_of(t.table, "pressure on top");
  const double by_load = a2 / (a2 - x2) / 2, found = at.by[2].derivative * 100 / at.number.value;
  CHECK((std::isnan(found) ? at.by[2].why.find(" give ") != std::string::npos : std::fabs(found / by_load - 1) < 0.03));
  // Displacements depend on load over modulus alone, if pressures do.
  const double sum = elasticity(t.table, "approach", 1) + elasticity(t.table, "approach", 2);
  CHECK(std::fabs(sum) < 1e-4);
}

// W ~ (mu P)^2 / E* (k ln k + 1 - k - s^2 / 2) with s = Q / (mu P), k = 1 - s; stuck half width c = a sqrt(k).
TEST_CASE("tolerances: Cattaneo, dissipation and stuck width by friction, shear and radius") {
  truth::Problem problem = truth::cattaneo(0.6, false, 0.13);
  std::string text = problem.text;
  const auto replace = [&](const std::string& what, const std::string& with) {
    const size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    text.replace(at, what.size(), with);
  };
  replace("force {share*mu*P} 0", "force Q 0");
  replace("parameter tolerance 0.01", "parameter Q " + show(0.36 * sound(problem.text).parameters["P"]) + " +- 0.5 tolerance " +
                                          std::string(test::in_full() ? "0.001" : "0.05"));
  if (test::in_full())
    replace("parameter mu 0.59999999999999998", "parameter mu 0.6 +- 5 %"), replace("parameter R 500", "parameter R 500 +- 1");
  text += "want width stick\n";
  Toleranced t;
  find(text, t);
  const double s = 0.6, k = 1 - s, by_shear = -s * (std::log(k) + s) / (k * std::log(k) + 1 - k - s * s / 2);
  const double fine = test::effort(5e-3, 1e-3), place = test::effort(1e-2, 5e-3);
  for (size_t p = 0; p < t.table.parameters.size(); ++p) {
    const std::string& name = t.table.parameters[p].name;
    CAPTURE(name);
    const double energy = name == "mu" ? 2 - by_shear : by_shear, stuck = s / 2 / k * (name == "mu" ? 1 : -1);
    if (name == "R") {
      CHECK(elasticity(t.table, "peak pressure", p) == doctest::Approx(-0.5).epsilon(fine));
      CHECK(elasticity(t.table, "half width", p) == doctest::Approx(0.5).epsilon(place));
      CHECK(elasticity(t.table, "stuck width", p) == doctest::Approx(0.5).epsilon(place));
    } else {
      CHECK(elasticity(t.table, "dissipated", p) == doctest::Approx(energy).epsilon(fine));
      CHECK(elasticity(t.table, "stuck width", p) == doctest::Approx(stuck).epsilon(place));
      CHECK(std::fabs(elasticity(t.table, "peak pressure", p)) < 1e-3);
    }
  }
}

namespace {

// Standard deviation of a number with parameters drawn from normal distributions, by further solutions on the same divisions.
double spread_of(Toleranced& t, const std::string& name, int samples) {
  double sum = 0, squares = 0;
  uint32_t state = 1;
  const auto uniform = [&] { return (state = state * 1664525U + 1013904223U) / 4294967296.0; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * std::acos(-1.0) * uniform()); };
  for (int i = 0; i < samples; ++i) {
    Parameters drawn;
    for (const app::ToleranceOf& p : t.table.parameters) drawn[p.name] = p.value + p.size * normal();
    double value = NAN;
    for (const app::Stated& s : estimate::numbers_with({t.sketch, t.mesh, t.trial}, drawn, redraw_of(t), t.demand))
      if (s.name() == name) value = s.value;
    sum += value, squares += value * value;
  }
  return std::sqrt(squares / samples - sum * sum / samples / samples);
}

} // namespace

// The spread of n samples is known to 1 / sqrt(2 n), of 1000 to 2.2 %.
TEST_CASE("tolerances: the root of squares is the spread of drawn samples") {
  Toleranced bar;
  find("parameter E 200 +- 1 %  p 3 +- 0.05  L 2" + std::string(kBar), bar);
  const double of_bar = bar.table.root_of_squares(number_of(bar.table, "approach of points"));
  CHECK(spread_of(bar, "approach of points", test::effort(40, 1000)) ==
        doctest::Approx(of_bar).epsilon(test::effort(0.25, 0.05)));
  if (!test::in_full()) return;
  Toleranced hertz;
  find(half_hertz("parameter R 50 +- 1  E 2e5 +- 2 %  P 100 +- 3", "want pressure approach\n"), hertz);
  for (const char* name : {"peak pressure", "approach"})
    CHECK(spread_of(hertz, name, 1000) ==
          doctest::Approx(hertz.table.root_of_squares(number_of(hertz.table, name))).epsilon(0.05));
}

TEST_CASE("tolerances: shares add up: all parameters moved at once") {
  Toleranced t;
  find(half_hertz("parameter R 50 +- 0.2  E 2e5 +- 0.5 %  P 100 +- 0.4", "want pressure\ntolerance 3 %\n"), t);
  const app::Toleranced& peak = number_of(t.table, "peak pressure");
  double change = 0;
  std::vector<app::Stated> ends[2];
  for (const int sign : {-1, 1}) {
    Parameters moved;
    for (size_t p = 0; p < 3; ++p)
      moved[t.table.parameters[p].name] = t.table.parameters[p].value + sign * t.table.parameters[p].size;
    ends[sign > 0 ? 1 : 0] = estimate::numbers_with({t.sketch, t.mesh, t.trial}, moved, redraw_of(t), t.demand);
  }
  for (size_t p = 0; p < 3; ++p) change += 2 * peak.by[p].derivative * t.table.parameters[p].size;
  CHECK(ends[1][1].name() == "peak pressure");
  CHECK(ends[1][1].value - ends[0][1].value == doctest::Approx(change).epsilon(0.05));
}

TEST_CASE("tolerances: other units of length and force, the same elasticities") {
  Toleranced a, b;
  const std::string more = "want pressure width\ntolerance 3 %\n";
  find(half_hertz("parameter R 50 +- 0.1  P 100 +- 1  E 2e5", more), a);
  std::string text = half_hertz("parameter R 50e3 +- 100  P 100e6 +- 1e6  E 2e8", more); // lengths and stresses times 1000
  text.replace(text.find("L 24"), 4, "L 24e3");
  find(text, b);
  for (const char* name : {"peak pressure", "half width"})
    for (size_t p = 0; p < 2; ++p)
      CHECK(elasticity(b.table, name, p) == doctest::Approx(elasticity(a.table, name, p)).epsilon(1e-6));
}

TEST_CASE("tolerances: the table is kept with the meshes of a run") {
  app::MeshLoop loop;
  loop.tolerances.parameters = {{"R", 50, 0.1, ""}, {"n", 3, 1, "with n = 3.01: no"}};
  app::Stated peak;
  peak.what = app::Measure::kPeakPressure, peak.value = 2.5, peak.tolerance = 0.01;
  loop.tolerances.numbers = {{peak, {{-0.25, ""}, {NAN, "two steps give 1 and 2"}}}};
  loop.tolerances.why = "the search was interrupted";
  app::MeshLoop back;
  REQUIRE(estimate::read_meshes(estimate::text_of(loop), back));
  CHECK(back.tolerances.why == loop.tolerances.why);
  REQUIRE(back.tolerances.parameters.size() == 2);
  CHECK(back.tolerances.parameters[1].why == "with n = 3.01: no");
  REQUIRE(back.tolerances.numbers.size() == 1);
  CHECK(back.tolerances.numbers[0].number.value == 2.5);
  CHECK(back.tolerances.numbers[0].by[0].derivative == -0.25);
  CHECK(std::isnan(back.tolerances.numbers[0].by[1].derivative));
  CHECK(back.tolerances.share(back.tolerances.numbers[0], 0) == doctest::Approx(0.025));
}

TEST_CASE("tolerances: a number with a kink or a jump has no derivative, and the reason is named") {
  Toleranced t;
  find("parameter a 0 +- 0.01  b 3 +- 0.1  p {1 + abs(a) + floor(b)}  E 200  L 2" + std::string(kBar), t);
  const app::Toleranced& approach = number_of(t.table, "approach of points");
  CHECK(approach.by[0].derivative == 0); // abs(a) at 0: central differences vanish
  CHECK(std::isnan(approach.by[1].derivative));
  CHECK(approach.by[1].why.find("two steps give ") == 0);
  CHECK(std::isnan(t.table.worst_case(approach)));
}

TEST_CASE("tolerances: a changed sketch with other curves is named") {
  Toleranced t;
  find("parameter half 0 +- 0.1  E 200  L 2  p 1" + std::string(kBar) + "when half traction bar.n fy half\n", t);
  CAPTURE(t.table.parameters[0].why);
  CHECK(t.table.parameters[0].why.find("with half = 0.01: ") == 0);
  CHECK(t.table.parameters[0].why.find("expected a change of numbers only") != std::string::npos);
  CHECK(std::isnan(number_of(t.table, "approach of points").by[0].derivative));
}

TEST_CASE("tolerances: a history that ends early, of the nominal or of a changed sketch, is named") {
  std::string text = test::read_file(paths::root() + "/examples/tutorial/t12_sliding.c2s");
  const auto with = [&](const std::string& mu) {
    std::string out = text;
    const size_t at = out.find("mu 0.3");
    REQUIRE(at != std::string::npos);
    return out.replace(at, 6, mu);
  };
  Toleranced slides, nearly; // friction carries 40 of 100 from 0.4 on
  find(with("mu 0.3 +- 0.01"), slides);
  CHECK(slides.table.why.find("the history ended early: ") == 0);
  CHECK(slides.table.numbers.empty());
  find(with("mu 0.401 +- 0.01"), nearly);
  CHECK(nearly.table.why.empty());
  CHECK(nearly.table.parameters[0].why.find("with mu = 0.39699: the history ends otherwise: ") == 0);
  REQUIRE(nearly.table.numbers.size() > 0);
  CHECK(std::isnan(nearly.table.worst_case(nearly.table.numbers[0])));
}

TEST_CASE("tolerances: the same divisions on changed curves, both sides of a contact opposite") {
  const std::string text = half_hertz("parameter R 50 E 2e5 P 100", "");
  const Sketch s = sound(text), changed = sound(text, {{"R", 45}, {"L", 25}});
  const Mesh mesh = first_mesh(s, 1), other = same_divisions(s, mesh, changed);
  for (size_t b = 0; b < 2; ++b)
    for (size_t c = 0; c < mesh.bodies[b][0].curves.size(); ++c) {
      const MeshedCurve &p = mesh.bodies[b][0].curves[c], &q = other.bodies[b][0].curves[c];
      REQUIRE(p.ends.size() == q.ends.size());
      CHECK(q.ends.back() == q.measure.length());
      if (p.curve->contact >= 0 && p.curve->side == 0) continue;
      for (size_t k = 0; k < p.ends.size(); ++k) CHECK(q.ends[k] / q.ends.back() == doctest::Approx(p.ends[k] / p.ends.back()));
    }
  CHECK(deck_of(s, same_divisions(s, mesh, s)) == deck_of(s, mesh));
  // Element ends move where they are stretched to.
  Stretchings moved;
  moved[2].from = {0, 0.5, 1}, moved[2].to = {0, 0.6, 1};
  const Mesh stretched = same_divisions(s, mesh, s, moved);
  CHECK(stretched.bodies[0][0].curves[2].elements() == mesh.bodies[0][0].curves[2].elements());
}

TEST_CASE("tolerances: listing, JSON and command line") {
  const test::Folder folder;
  const std::string sketch = folder / "bar.c2s", json = folder / "bar.json", lines = folder / "bar.lst",
                    errors = folder / "errors";
  const auto run = [&](const std::string& parameters, const std::string& words) {
    test::write_file(sketch, parameters + kBar);
    return test::run_shell("'" + paths::program() + "' run '" + sketch + "' " + words + " --quiet --json '" + json +
                           "' --listing '" + lines + "' 2>'" + errors + "'")
        .status;
  };
  REQUIRE(run("parameter E 200 +- 1 %  p 3 L 2", "p=4+-0.25") == 0);
  const test::Json t = test::JsonReader::read(test::read_file(json))["tolerances"];
  REQUIRE(t["parameters"].items.size() == 2);
  CHECK(t["parameters"][0]["name"].text == "E");
  CHECK(t["parameters"][1]["value"].number == 4);
  CHECK(t["parameters"][1]["tolerance"].number == 0.25);
  REQUIRE(t["numbers"].items.size() == 2);
  const test::Json& approach = t["numbers"][0];
  CHECK(approach["name"].text == "approach of points");
  CHECK(approach["by"][1]["share"].number == doctest::Approx(-approach["value"].number / 16).epsilon(1e-6));
  CHECK(approach["worst_case"].number ==
        doctest::Approx(approach["by"][0]["share"].number + approach["by"][1]["share"].number));
  const std::string listing = test::read_file(lines);
  CHECK(listing.find("\nTolerances\n") != std::string::npos);
  CHECK(listing.find("by p ") != std::string::npos);
  // Nothing of it without a tolerance.
  REQUIRE(run("parameter E 200 p 3 L 2", "") == 0);
  CHECK_FALSE(test::JsonReader::read(test::read_file(json)).has("tolerances"));
  CHECK(test::read_file(lines).find("Tolerances") == std::string::npos);
  // Bad input.
  CHECK(run("parameter E 200 p 3 L 2", "p=4+-x") == 64);
  CHECK(test::read_file(errors).find("p=4+-x: expected the name of a parameter, = and a number, or a number, +- and a "
                                     "tolerance") != std::string::npos);
  CHECK(run("parameter E 200 p 3 L 2", "p=4+--1") == 64);
  CHECK(run("parameter E 200 p 3 L 2", "p=+-1") == 64);
  CHECK(run("parameter E 200 p 3 L 2 n 4 +- 1\nsteps n", "") == 2);
  CHECK(test::read_file(errors).find(":1:29: error: the tolerance of n cannot be used: with the value 4.1, line 2: 4.1: "
                                     "expected ") != std::string::npos);
}

TEST_CASE("tolerances: the page has the table, bars of the shares, and what has no derivative") {
  const test::Folder folder;
  const std::string sketch = folder / "bar.c2s", page = folder / "page.html", figures = folder / "figures";
  test::write_file(sketch, "parameter b 3 +- 0.1  c 1 +- 5 %  d 1 +- 4 %  e 1 +- 3 %  f 1 +- 2 %  g 1 +- 1 %  h 1 +- 0.5 %\n"
                           "parameter k 1 +- 10 %  E {200*c*d*e*f*g}  p {h*k}  L {2 + 0*floor(b)}" +
                               std::string(kBar));
  const auto run = [&](const std::string& more) {
    return test::run_shell("'" + paths::program() + "' run '" + sketch + "' --quiet --listing /dev/null --report '" + page +
                           "' --figures '" + figures + "' " + more)
        .status;
  };
  REQUIRE(run("") == 0);
  const std::string html = test::read_file(page), bars = test::read_file(figures + "/tolerances.svg");
  CHECK(html.find("<h2>Wanted numbers and tolerances</h2>") != std::string::npos);
  CHECK(html.find("by k = 1 &#177; 0.1</th>") != std::string::npos);
  CHECK(html.find("No usable derivative") == std::string::npos);
  CHECK(html.find("<section id=\"tolerances\">") != std::string::npos);
  CHECK(bars.find("all others") != std::string::npos);
  CHECK(bars.find("c &#177; 0.05</text>") != std::string::npos);
  CHECK(bars.find("h &#177;") == std::string::npos);
  // Without any derivative there is a table, and no picture.
  test::write_file(sketch, "parameter b 3 +- 0.1  E 200  L 2  p {3 + floor(b)}" + std::string(kBar));
  REQUIRE(run("") == 0);
  const std::string without = test::read_file(page);
  CHECK(without.find("<li>By b not the approach of points: two steps give ") != std::string::npos);
  CHECK(without.find("<section id=\"tolerances\">") == std::string::npos);
}

TEST_CASE("tolerances: responses of a run and of a sweep") {
  const test::Folder folder;
  const std::string sketch = folder / "bar.c2s", table = folder / "table.csv", results = folder / "results.csv",
                    errors = folder / "errors";
  test::write_file(sketch, "parameter E 200 +- 1 %  p 3 L 2" + std::string(kBar));
  const auto run = [&](const std::string& words) {
    return test::run_shell("'" + paths::program() + "' " + words + " --results '" + results + "' 2>'" + errors + "'").status;
  };
  const std::string quiet = " --quiet --listing /dev/null";
  REQUIRE(run("run '" + sketch +
              "' p=3+-0.5 --response 'derivative approach of points by p; share approach of points by E; worst "
              "case approach of points; root of squares approach of points; share approach of points by L; worst case peak "
              "pressure'" +
              quiet) == 0);
  double values[6] = {};
  std::istringstream lines(test::read_file(results));
  std::string line;
  for (double& value : values) std::getline(lines, line), value = std::strtod(line.c_str(), nullptr);
  CHECK(values[0] == doctest::Approx(-0.0025).epsilon(1e-6));
  CHECK(values[1] == doctest::Approx(0.000075).epsilon(1e-4));
  CHECK(values[2] == doctest::Approx(0.00125 + 0.000075).epsilon(1e-4));
  CHECK(values[3] == doctest::Approx(std::hypot(0.00125, 0.000075)).epsilon(1e-4));
  CHECK(std::isnan(values[4])); // L has no tolerance
  CHECK(std::isnan(values[5])); // not wanted
  test::write_file(table, "p\n3+-0.5\n6\n");
  REQUIRE(run("sweep '" + table + "' '" + sketch + "' --response 'worst case approach of points'") == 0);
  std::istringstream rows(test::read_file(results));
  std::getline(rows, line);
  CHECK(line == "row,p,worst case approach of points,outcome");
  std::getline(rows, line);
  CHECK(std::strtod(line.c_str() + line.find(',', 2) + 1, nullptr) == doctest::Approx(0.001325).epsilon(1e-4));
  std::getline(rows, line);
  CHECK(std::strtod(line.c_str() + line.find(',', 2) + 1, nullptr) == doctest::Approx(0.00015).epsilon(1e-4));
  // What is no such response.
  for (const char* words :
       {"derivative peak pressure", "worst case", "share by R", "worst case nothing", "worst case peak pressure by R"})
    CHECK(run("run '" + sketch + "' --response '" + std::string(words) + "'" + quiet) == 64);
  CHECK(run("run '" + sketch + "' --response 'worst case peek pressure'" + quiet) == 64);
  CHECK(test::read_file(errors).find("did you mean 'worst case peak pressure'") != std::string::npos);
}
