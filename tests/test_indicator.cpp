// c2d_indicators: what a mesh leaves open between its nodes, against closed forms of half planes, finer meshes, invariances and
// rates.
#include "paths.hpp"
#include "problem.hpp"
#include "program/commands/families.hpp"
#include "shell.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace problem;

namespace {

const double kPi = std::acos(-1.0);
size_t at(int64_t i) { return static_cast<size_t>(i); }

Setup asking() {
  Setup setup;
  setup.indicators = true;
  return setup;
}
Result solved(const Problem& p) {
  Result r = solve(p, asking());
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}
Result family(const std::string& name, const std::vector<std::string>& settings = {}) {
  std::string deck, error;
  REQUIRE_MESSAGE(families::make_deck(name, settings, deck, error), error);
  Result r = solve_text(deck, asking());
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  return r;
}

// Of element e of body b, both from 1.
double off(const Result& r, int b, int32_t e, int32_t column) {
  return r.indicators[b - 1][at((e - 1) * C2D_OFF_FIELDS + column)];
}
int32_t elements(const Result& r, int b) { return static_cast<int32_t>(r.indicators[b - 1].size()) / C2D_OFF_FIELDS; }
double total(const Result& r, int b, int32_t column) {
  double sum = 0;
  for (int32_t e = 1; e <= elements(r, b); ++e) sum += off(r, b, e, column);
  return sum;
}
double largest_density(const Result& r, int b, int32_t* where = nullptr) {
  double most = 0;
  for (int32_t e = 1; e <= elements(r, b); ++e) {
    const double density = off(r, b, e, C2D_OFF_CONTACT_ENERGY) / off(r, b, e, C2D_OFF_LENGTH);
    if (density <= most) continue;
    most = density;
    if (where != nullptr) *where = e;
  }
  return most;
}

// A piecewise linear traction over [-c, c], symmetric: nodes x from 0 on. Its integral with ln|x - s|.
struct Linear {
  std::vector<double> x, p;
  double with_log(double at_x) const {
    double sum = 0;
    const auto part = [](double u, double v, double a, double b) { // over s - x from u to v, (a + b (s - x)) ln|s - x|
      const auto f = [a, b](double t) {
        const double l = t == 0 ? 0 : std::log(std::fabs(t));
        return a * (t * l - t) + b * (0.5 * t * t * l - 0.25 * t * t);
      };
      return f(v) - f(u);
    };
    for (size_t i = 0; i + 1 < x.size(); ++i)
      for (double side : {1.0, -1.0}) {
        const double s0 = side * x[i], s1 = side * x[i + 1], slope = (p[i + 1] - p[i]) / (s1 - s0);
        sum += side * part(s0 - at_x, s1 - at_x, p[i] + slope * (at_x - s0), slope);
      }
    return sum;
  }
};

// The most that f is off what lies between its values at both ends, at quarters.
template <class Function> double most_between(double from, double to, const Function& f) {
  double most = 0;
  for (double s : {0.25, 0.5, 0.75})
    most = std::max(most, std::fabs(f(from + s * (to - from)) - (1 - s) * f(from) - s * f(to)));
  return most;
}

// Pairs of the last step by rising x, from the axis on.
Linear tractions(const Result& r, int field) {
  const Step step = r.recorded().back();
  std::vector<std::pair<double, double>> rows;
  for (int i = 0; i < step.pairs(); ++i)
    if (step.at(i, C2D_X) > -1e-9) rows.emplace_back(step.at(i, C2D_X), step.at(i, field));
  std::sort(rows.begin(), rows.end());
  Linear out;
  for (const auto& row : rows) out.x.push_back(row.first), out.p.push_back(row.second);
  return out;
}

// Of an element of body b: its ends along x.
struct Reach {
  double from, to;
};
Reach reach(const Result& r, int b, int32_t e) {
  Reach out{1e300, -1e300};
  for (const EndResult& end : r.boundary[b - 1])
    if (end.element == e) out.from = std::min(out.from, end.x), out.to = std::max(out.to, end.x);
  return out;
}

// The zone given as one of independent meshes.
Problem with_free_zone(Problem p) {
  for (const Zone& z : p.zones) {
    FreeZone f;
    for (int b = 0; b < 2; ++b) f.first_element[b] = z.first_element[b], f.last_element[b] = z.last_element[b];
    p.free_zones.push_back(f);
  }
  p.zones.clear();
  return p;
}
// A cylinder of radius 100 on a half plane, of whose bodies one has four elements for one of the other, or 2^cuts.
Problem with_fine_body(int body, const char* n = "n=6", int cuts = 2) {
  std::string deck, error;
  REQUIRE(families::make_deck("hertz", {n, "symmetry=line"}, deck, error));
  const Problem coarse = from_text(deck);
  Problem fine = coarse;
  for (int i = 0; i < cuts; ++i)
    fine = cut_in_two(fine, [](int, const double* from, const double* to, double* middle) {
      const auto is_on_arc = [](const double* p) { return std::fabs(std::hypot(p[0], p[1] - 100) - 100) < 1e-6; };
      if (!is_on_arc(from) || !is_on_arc(to) || std::fabs(from[1]) + std::fabs(to[1]) == 0) return;
      const double size = std::hypot(middle[0], middle[1] - 100);
      middle[0] *= 100 / size, middle[1] = 100 + (middle[1] - 100) * 100 / size;
    });
  Problem out = with_free_zone(coarse);
  fine = with_free_zone(fine);
  out.bodies[at(body - 1)] = fine.bodies[at(body - 1)];
  for (size_t z = 0; z < out.free_zones.size(); ++z) {
    out.free_zones[z].first_element[body - 1] = fine.free_zones[z].first_element[body - 1];
    out.free_zones[z].last_element[body - 1] = fine.free_zones[z].last_element[body - 1];
  }
  return out;
}

// Column by column, relative to the largest.
void check_alike(const Result& a, const Result& b, double length, double stress, double tolerance) {
  const double unit[C2D_OFF_FIELDS] = {
      length, 1, 1, 1, length, length, length, stress * length * length, stress * length * length};
  for (size_t k = 0; k < 2; ++k)
    for (int32_t c = 0; c < C2D_OFF_FIELDS; ++c) {
      double most = 0, worst = 0;
      REQUIRE(a.indicators[k].size() == b.indicators[k].size());
      for (size_t i = at(c); i < a.indicators[k].size(); i += C2D_OFF_FIELDS) {
        most = std::max(most, std::fabs(a.indicators[k][i]));
        worst = std::max(worst, std::fabs(a.indicators[k][i] - b.indicators[k][i] / unit[c]));
      }
      CAPTURE(k);
      CAPTURE(c);
      CHECK(worst <= tolerance * most);
    }
}

} // namespace

TEST_CASE("indicators: gaps between the nodes of Hertz' contact are those of half planes under its pressures") {
  const Result r = family("hertz", {"n=10"});
  const Linear p = tractions(r, C2D_TN);
  const double modulus = 1000 / 0.91 / 2;
  int looked = 0;
  for (int b = 1; b <= 2; ++b)
    for (int32_t e = 1; e <= elements(r, b); ++e) {
      if (off(r, b, e, C2D_OFF_STATUSES) != 4) continue;
      const Reach x = reach(r, b, e);
      const double expected =
          most_between(x.from, x.to, [&](double s) { return s * s / 200 - 2 / (kPi * modulus) * p.with_log(s); });
      CHECK(off(r, b, e, C2D_OFF_GAP) == doctest::Approx(expected).epsilon(0.02));
      CHECK(off(r, b, e, C2D_OFF_DRIFT) == 0);
      ++looked;
    }
  CHECK(looked == 18);
}

TEST_CASE("indicators: drift between the nodes of Cattaneo's contact, what slip left behind taken off") {
  for (const char* order : {"order=1", "order=2"}) {
    const Result r = family("mindlin", {"n=10", "Q=0.7", order}); // to, fro and to again
    const Linear q = tractions(r, C2D_TT);
    const double modulus = 1000 / 0.91 / 2;
    int looked = 0;
    for (int32_t e = 1; e <= elements(r, 1); ++e) {
      if (off(r, 1, e, C2D_OFF_STATUSES) != 2) continue;
      ++looked;
      CHECK(off(r, 1, e, C2D_OFF_DRIFT) > 0);
      const Reach x = reach(r, 1, e);
      if (std::strcmp(order, "order=1") != 0) continue;
      const double expected = most_between(x.from, x.to, [&](double s) { return 2 / (kPi * modulus) * q.with_log(s); });
      CHECK(off(r, 1, e, C2D_OFF_DRIFT) == doctest::Approx(expected).epsilon(0.02));
    }
    CHECK(looked > 5);
  }
}

TEST_CASE("indicators: what an equation adds between nodes is what a mesh sixteen times finer finds there") {
  Problem p;
  p.analysis = C2D_ANALYSIS_STRESS;
  p.bodies.resize(1);
  add_polygon(p.bodies[0], {{0, 0, 8}, {8, 0, 4}, {8, 4, 8}, {0, 4, 4}});
  set_ends(p, 1, [](double x, double y, double, double ny, End& end) {
    if (y == 0 && ny < -0.5) end.codes[1] = 1, end.codes[3] = 0;
    if (y == 0 && x == 0 && ny < -0.5) end.codes[0] = 1, end.codes[2] = 0;
    if (y == 4 && ny > 0.5) end.values[1] = -std::fabs(x - 3), end.values[0] = 0.1 * x;
  });
  Problem fine = p;
  for (int i = 0; i < 4; ++i) fine = cut_in_two(fine, [](int, const double*, const double*, double*) {});
  const Result r = solved(p), f = solved(fine);
  for (int32_t e = 14; e < 20; ++e) { // of the top, but for those at corners
    CAPTURE(e);
    double most = 0;
    for (int quarter = 1; quarter < 4; ++quarter) {
      const EndResult &there = f.boundary[0][at(2 * ((e - 1) * 16 + 4 * quarter))], &from = f.boundary[0][at(2 * (e - 1) * 16)],
                      &to = f.boundary[0][at(2 * e * 16 - 1)];
      const double s = 0.25 * quarter;
      most = std::max(most, std::hypot(there.ux - (1 - s) * from.ux - s * to.ux, there.uy - (1 - s) * from.uy - s * to.uy));
    }
    CHECK(off(r, 1, e, C2D_OFF_EQUATION) == doctest::Approx(most).epsilon(0.15));
    CHECK(off(r, 1, e, C2D_OFF_ZONE) == 0);
    CHECK(off(r, 1, e, C2D_OFF_STATUSES) == 0);
    CHECK(off(r, 1, e, C2D_OFF_CONTACT_ENERGY) == 0);
  }
  double before = 0; // energies fall with the cube of the elements
  for (int32_t parts : {2, 4}) {
    p = cut_in_two(p, [](int, const double*, const double*, double*) {});
    const Result halves = solved(p);
    double now = 0;
    for (int32_t e = 13 * parts + 1; e <= 19 * parts; ++e) now += off(halves, 1, e, C2D_OFF_EQUATION_ENERGY);
    if (before > 0) CHECK(before / now == doctest::Approx(8).epsilon(0.1));
    before = now;
  }
}

TEST_CASE("indicators: a uniform field leaves nothing open, whatever the meshes that face each other") {
  for (const char* order : {"order=1", "order=2", "order=3"}) {
    const Result r = family("stack", {"plates=2", order});
    for (int b = 1; b <= 2; ++b)
      for (int32_t e = 1; e <= elements(r, b); ++e) {
        const double strain = 1e-3, length = off(r, b, e, C2D_OFF_LENGTH);
        for (int32_t c : {C2D_OFF_EQUATION, C2D_OFF_GAP, C2D_OFF_DRIFT}) CHECK(off(r, b, e, c) < 1e-6 * strain * length);
        CHECK(off(r, b, e, C2D_OFF_CONTACT_ENERGY) < 1e-12 * strain * length * length);
        CHECK(off(r, b, e, C2D_OFF_STATUSES) == (off(r, b, e, C2D_OFF_ZONE) > 0 ? 2 : 0));
      }
  }
}

TEST_CASE("indicators: the edge of Hertz' contact is marked, and energies fall with the cube of the elements") {
  for (const char* order : {"order=1", "order=2", "order=3"}) {
    double before = 0;
    for (const char* n : {"n=10", "n=20", "n=40"}) {
      const Result r = family("hertz", {n, order});
      const double now = total(r, 1, C2D_OFF_CONTACT_ENERGY);
      int32_t marked = 0;
      largest_density(r, 1, &marked);
      CHECK(off(r, 1, marked, C2D_OFF_STATUSES) == 5); // half closed
      const Reach x = reach(r, 1, marked);
      CHECK(x.from < 1.0);
      CHECK(x.to > 1.0);
      CHECK(off(r, 1, marked, C2D_OFF_CONTACT_ENERGY) > 0.5 * now);
      CHECK(total(r, 2, C2D_OFF_CONTACT_ENERGY) == doctest::Approx(now).epsilon(0.01));
      if (before > 0) CHECK(before / now == doctest::Approx(8.5).epsilon(0.06));
      before = now;
    }
  }
}

TEST_CASE("indicators: elements where slip ends have the work of their spare friction") {
  const Result r = family("cylinder_friction", {"n=20"});
  double mixed = 0;
  int count = 0;
  for (int32_t e = 1; e <= elements(r, 1); ++e) {
    if (off(r, 1, e, C2D_OFF_STATUSES) != 6) continue;
    ++count;
    mixed = std::max(mixed, off(r, 1, e, C2D_OFF_CONTACT_ENERGY));
    CHECK(off(r, 1, e, C2D_OFF_DRIFT) < 1e-15);
  }
  CHECK(count == 1);
  CHECK(mixed > 0);
}

TEST_CASE("indicators: with constant functions, with elements of three points, on lines of symmetry") {
  double before = 0;
  for (int times = 0; times < 2; ++times) {
    Problem p = load("hertz_lin_l.dat");
    p.friction.resize(1);
    for (int i = 0; i < times; ++i) p = cut_in_two(p, [](int, const double*, const double*, double*) {});
    const double now = total(solved(with_functions(p, 1)), 2, C2D_OFF_EQUATION_ENERGY);
    CHECK(now > 0);
    if (before > 0) CHECK(now < 0.7 * before);
    before = now;
  }
  Problem flat = load("layer_mu.dat");
  flat.friction.resize(1);
  check_alike(solved(flat), solved(with_geometry(flat, 3)), 1, 1, 1e-6);
  const Result images = family("hertz", {"n=10"}), line = family("hertz", {"n=10", "symmetry=line"});
  CHECK(total(line, 1, C2D_OFF_CONTACT_ENERGY) == doctest::Approx(total(images, 1, C2D_OFF_CONTACT_ENERGY)).epsilon(0.02));
}

TEST_CASE("indicators: ties") {
  for (const char* bond : {"bond=matching", "bond=free"}) {
    double before = 0;
    for (const char* n : {"n=8", "n=16"}) {
      const Result r = family("bimaterial", {n, "order=1", bond});
      for (int b = 1; b <= 2; ++b)
        for (int32_t e = 1; e <= elements(r, b); ++e)
          if (off(r, b, e, C2D_OFF_ZONE) > 0) CHECK(off(r, b, e, C2D_OFF_STATUSES) == 8);
      const double now = total(r, 1, C2D_OFF_CONTACT_ENERGY);
      CHECK(now > 0);
      if (before > 0) CHECK(now < 0.5 * before);
      before = now;
    }
  }
}

TEST_CASE("indicators: where a platen holds a body what its equation adds is the drift") {
  const test::Result deck =
      test::run_shell("'" + paths::program() + "' mesh '" + paths::root() + "/examples/fretting_pad.c2s'");
  REQUIRE(deck.status == 0);
  const Result r = solve_text(deck.out, asking());
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  int held = 0;
  for (int32_t e = 1; e <= elements(r, 2); ++e) {
    if (off(r, 2, e, C2D_OFF_ZONE) != 2) continue;
    ++held;
    CHECK(off(r, 2, e, C2D_OFF_STATUSES) == 8);
    CHECK(off(r, 2, e, C2D_OFF_CONTACT_ENERGY) == doctest::Approx(off(r, 2, e, C2D_OFF_EQUATION_ENERGY)).epsilon(1e-3));
  }
  CHECK(held > 4);
}

TEST_CASE("indicators: a rigid body leaves to its partner what the stiffest one would") {
  Problem p = load("hertz_lin_l.dat"); // body 1 is 10,000 times as stiff
  p.friction.resize(1);
  const Result stiff = solved(p);
  p.rigid = true;
  p.motions = {{0, 0, 0}};
  const Result rigid = solved(p);
  CHECK(total(rigid, 1, C2D_OFF_EQUATION_ENERGY) == 0);
  CHECK(total(rigid, 1, C2D_OFF_CONTACT_ENERGY) > 0);
  for (int b = 1; b <= 2; ++b)
    CHECK(total(rigid, b, C2D_OFF_CONTACT_ENERGY) == doctest::Approx(total(stiff, b, C2D_OFF_CONTACT_ENERGY)).epsilon(0.01));
}

TEST_CASE("indicators: units, turns and which body is first do not matter") {
  for (const char* name : {"sample.dat", "block.dat", "hertz_lin_l.dat", "layer_mu.dat"}) {
    CAPTURE(name);
    Problem p = load(name);
    p.friction.resize(1);
    const Result r = solved(p);
    check_alike(r, solved(scaled(p, 64, 0.125)), 64, 0.125, 1e-9);
    check_alike(r, solved(scaled(p, 0.01, 7)), 0.01, 7, 1e-6);
    check_alike(r, solved(rotated(p, 90)), 1, 1, 1e-6);
  }
  for (const char* name : {"layer_mu.dat", "layer_t.dat", "rect.dat", "block.dat"}) { // flat: tractions per length of either
    CAPTURE(name);
    Problem p = load(name);
    p.friction.resize(1);
    const Result r = solved(p);
    Result swapped = solved(exchanged(p));
    std::swap(swapped.indicators[0], swapped.indicators[1]);
    for (auto& body : swapped.indicators)
      for (size_t i = C2D_OFF_SIDE; i < body.size(); i += C2D_OFF_FIELDS)
        if (body[i] > 0) body[i] = 3 - body[i];
    check_alike(r, swapped, 1, 1, 1e-6);
    check_alike(r, solved(with_free_zone(p)), 1, 1, 1e-5); // of which both sides say what a matching one does
  }
}

TEST_CASE("indicators: the coarse side of a zone is marked, whichever it is") {
  for (int fine : {1, 2}) {
    const Result r = solved(with_fine_body(fine));
    const auto largest = [&r](int b) {
      double most = 0;
      for (int32_t e = 1; e <= elements(r, b); ++e) most = std::max(most, off(r, b, e, C2D_OFF_CONTACT_ENERGY));
      return most;
    };
    CHECK(largest(3 - fine) > 1.5 * largest(fine));
  }
}

// Hertz' peak is 2.747. Where the half plane has as many elements as the cylinder nothing is said of it.
TEST_CASE("facing meshes: elements of side 1 that are too long for those of side 2, and by how much") {
  const auto told = [](const Result& r) {
    double percent = 0;
    for (const c2d_error& e : r.told) {
      const char* number = std::strstr(e.text, "the pressure is uncertain by ");
      if (e.status == C2D_WARN_SIZES && number != nullptr) std::sscanf(number, "the pressure is uncertain by %lf", &percent);
    }
    return percent;
  };
  for (const char* n : {"n=2", "n=3"}) {
    const Result r = solved(with_fine_body(2, n));
    const Step last = r.recorded().back();
    double most = 0;
    for (int i = 0; i < last.pairs(); ++i) most = std::max(most, last.at(i, C2D_TN));
    const double off = 100 * (most / 2.747 - 1);
    CHECK(off > 8);
    CHECK(told(r) > 0.8 * off);
    CHECK(told(r) < 2 * off);
  }
  // At the edge of contact a few pairs lie on a part of their element, and tell no slope: whether they come first or last.
  for (const double load : {0.5, 0.7, 0.85, 1.0, 1.15}) {
    Problem p = with_fine_body(2, "n=2", 3);
    p.paths = {{1, load}};
    const Result up = solve(p);
    for (FreeZone& z : p.free_zones)
      for (int b = 0; b < 2; ++b) std::swap(z.first_element[b], z.last_element[b]);
    const Result down = solve(p);
    REQUIRE(up.status == C2D_OK);
    CHECK(told(up) > 30);
    CHECK(told(down) == told(up));
  }
  CHECK(told(solved(with_fine_body(2, "n=12"))) == 0);
  CHECK(told(solved(with_fine_body(1, "n=3"))) == 0);
  CHECK(told(family("hertz", {"n=3", "symmetry=line"})) == 0);
}

TEST_CASE("indicators: before anything touches all is open and nothing is off") {
  Problem p = load("sample.dat");
  p.friction.resize(1);
  Setup setup = asking();
  setup.advance_loads = {0.0};
  const Result r = solve(p, setup);
  REQUIRE(r.status == C2D_OK);
  for (int b = 1; b <= 2; ++b)
    for (int32_t e = 1; e <= elements(r, b); ++e) {
      CHECK(off(r, b, e, C2D_OFF_LENGTH) > 0);
      CHECK((off(r, b, e, C2D_OFF_STATUSES) == 1) == (off(r, b, e, C2D_OFF_ZONE) > 0));
      for (int32_t c : {C2D_OFF_EQUATION, C2D_OFF_DRIFT, C2D_OFF_EQUATION_ENERGY}) CHECK(off(r, b, e, c) == 0);
    }
}

namespace {

struct Host : runs::RamStore {
  c2d_port port = C2D_INIT(c2d_port);
  bool cancels = false;
  static int32_t cancel(void* context) { return static_cast<Host&>(self(context)).cancels ? 1 : 0; }
  Host() {
    serve(port);
    port.cancel = cancel;
  }
};

} // namespace

TEST_CASE("indicators: one by one the same bits, nothing else changes, a cancel and a broken store are told") {
  runs::Deck deck = runs::deck_named("sample");
  const host::Limits limits = deck.limits();
  uint64_t minimum = 0, in_core = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
  Host host;
  runs::Machine machine(limits, minimum, &host.port);
  c2d_solver* s = machine.solver;
  REQUIRE(runs::read_deck(s, deck) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  const double mu = 0.3, load = 0.5;
  c2d_outcome outcome = C2D_REACHED;
  REQUIRE(c2d_begin(s, &mu, 1) == C2D_OK);
  REQUIRE(c2d_advance(s, &load, 1, &outcome) == C2D_OK);
  host.before = [](const runs::RamStore::Operation& o, size_t) { return o.kind == 'r' ? 77 : 0; };
  std::vector<double> rows(20 * C2D_OFF_FIELDS), again(C2D_OFF_FIELDS), pressure(19), after(19);
  CHECK(c2d_indicators(s, 1, 1, 20, rows.data(), C2D_OFF_FIELDS) == C2D_ERR_STORE_READ);
  host.before = nullptr;
  CHECK(c2d_get_state(s) == C2D_STATE_BROKEN);

  Host other;
  runs::Machine second(limits, minimum, &other.port);
  s = second.solver;
  deck = runs::deck_named("sample");
  REQUIRE(runs::read_deck(s, deck) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_run(s, nullptr, nullptr) == C2D_OK);
  REQUIRE(c2d_get(s, C2D_TN, 0, 1, 10, pressure.data(), 1) == C2D_OK);
  REQUIRE(c2d_indicators(s, 1, 11, 20, rows.data(), C2D_OFF_FIELDS) == C2D_OK);
  for (int32_t i = 0; i < 20; ++i) {
    REQUIRE(c2d_indicators(s, 1, 11 + i, 1, again.data(), C2D_OFF_FIELDS) == C2D_OK);
    CHECK(std::memcmp(again.data(), &rows[at(i * C2D_OFF_FIELDS)], sizeof(double) * C2D_OFF_FIELDS) == 0);
  }
  REQUIRE(c2d_get(s, C2D_TN, 0, 1, 10, after.data(), 1) == C2D_OK);
  CHECK(pressure == after);
  other.cancels = true;
  CHECK(c2d_indicators(s, 1, 11, 20, rows.data(), C2D_OFF_FIELDS) == C2D_ERR_CANCELLED);
  other.cancels = false;
  CHECK(c2d_indicators(s, 1, 11, 20, rows.data(), C2D_OFF_FIELDS) == C2D_OK);
  CHECK(c2d_get_state(s) == C2D_STATE_RUNNING);
}

// A port that cancels at the n-th time it is asked.
TEST_CASE("indicators and points: cancelled whenever that is asked, they can be had again") {
  struct Counting : runs::RamStore {
    c2d_port port = C2D_INIT(c2d_port);
    int64_t asked = 0, at = -1;
    static int32_t cancel(void* context) {
      Counting& own = static_cast<Counting&>(self(context));
      return own.asked++ == own.at ? 1 : 0;
    }
    Counting() {
      serve(port);
      port.cancel = cancel;
    }
  } host;
  runs::Deck deck = runs::deck_named("sample");
  const host::Limits limits = deck.limits();
  uint64_t minimum = 0;
  REQUIRE(c2d_memory_need(&limits, &minimum, nullptr, nullptr) == C2D_OK);
  runs::Machine machine(limits, minimum, &host.port);
  c2d_solver* s = machine.solver;
  REQUIRE(runs::read_deck(s, deck) == C2D_OK);
  REQUIRE(c2d_prepare(s) == C2D_OK);
  REQUIRE(c2d_run(s, nullptr, nullptr) == C2D_OK);
  std::vector<double> rows(10 * C2D_OFF_FIELDS), again = rows, points(2 * C2D_POINT_FIELDS), twice = points;
  const double xy[4] = {0.5, 0.25, 0.75, 0.5};
  for (const bool inside : {false, true}) {
    CAPTURE(inside);
    const auto ask = [&](std::vector<double>& to) {
      host.asked = 0;
      return inside ? c2d_interior(s, 0, 2, xy, 2, to.data(), C2D_POINT_FIELDS)
                    : c2d_indicators(s, 1, 24, 10, to.data(), C2D_OFF_FIELDS); // in contact
    };
    std::vector<double>&whole = inside ? points : rows, &other = inside ? twice : again;
    host.at = -1;
    REQUIRE(ask(whole) == C2D_OK);
    const int64_t times = host.asked;
    REQUIRE(times > 3);
    for (host.at = 0; host.at < times; ++host.at) {
      CAPTURE(host.at);
      CHECK(ask(other) == C2D_ERR_CANCELLED);
      CHECK(host.asked == host.at + 1);
    }
    host.at = -1;
    REQUIRE(ask(other) == C2D_OK);
    CHECK(other == whole);
  }
}

TEST_CASE("indicators: an end of a contact element that makes no pair is open") {
  for (const int32_t without : {0, 1}) {
    Problem p;
    p.friction = {0.3};
    p.bodies.resize(2);
    add_polygon(p.bodies[0], {{0, 0, 4}, {4, 0, 1}, {4, 1, 4}, {0, 1, 1}});
    add_polygon(p.bodies[1], {{0, 1, 4}, {4, 1, 1}, {4, 2, 4}, {0, 2, 1}});
    set_ends(p, 1, [](double, double, double, double ny, End& end) {
      if (ny < -0.5) end = End{{1, 1, 0, 0}, {0, 0, 0, 0}};
    });
    set_ends(p, 2, [](double, double, double, double ny, End& end) {
      if (ny > 0.5) end.values[1] = -1;
    });
    p.zones = {Zone()};
    Zone& z = p.zones[0];
    z.elements = 4, z.pairs = 5 - without;
    z.first_element[0] = 6, z.last_element[0] = 9, z.first_node[0] = 6, z.last_node[0] = 10 - without;
    z.first_element[1] = 4, z.last_element[1] = 1, z.first_node[1] = 5, z.last_node[1] = 1 + without;
    const Result r = solved(p);
    const auto statuses = [&](int b, int32_t e) { return static_cast<int32_t>(off(r, b, e, C2D_OFF_STATUSES)); };
    for (int b = 1; b <= 2; ++b) {
      CHECK((statuses(b, b == 1 ? 9 : 1) & 1) == without);
      CHECK((statuses(b, b == 1 ? 9 : 1) & 6) != 0);
      CHECK((statuses(b, b == 1 ? 8 : 2) & 1) == 0);
    }
  }
}
