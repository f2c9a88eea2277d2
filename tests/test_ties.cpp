// Zones that are tied: what is cut and tied is whole again, under tension as under pressure.
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;
using namespace solved_bodies;

namespace {

int32_t tied(int32_t kind) { return kind + C2D_ZONE_TIED; }

// A plane field: displacements and stresses at a point.
struct Field {
  double ux, uy, sxx, syy, sxy;
};
using FieldAt = test::Callable<Field(double x, double y)>;

// Bodies whose sides carry the field's tractions; those on x = 0 its displacements. Sides that are tied carry what the tie
// does.
void load_side(Model& m, int32_t body, int32_t side, const FieldAt& field, double nx, double ny) {
  m.set(body, side, [&](double x, double y) {
    const Field f = field(x, y);
    if (nx < -0.5 && std::fabs(x) < 1e-12) return end_of(kHeld, 0, 0, f.ux, f.uy);
    return end_of(kPulled, f.sxx * nx + f.sxy * ny, f.sxy * nx + f.syy * ny);
  });
}
void load_rectangle(Model& m, int32_t body, const FieldAt& field) {
  const double normal[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
  for (int side = 0; side < 4; ++side) load_side(m, body, side + 1, field, normal[side][0], normal[side][1]);
}

int32_t tie(Model& m, int32_t kind, int32_t body1, int32_t side1, int32_t body2, int32_t side2) {
  m.set(body1, side1, End());
  m.set(body2, side2, End());
  return m.join(tied(kind), body1, side1, body2, side2);
}

// Largest differences at all ends, relative to these sizes.
double off_field(const Result& r, const FieldAt& field, double stress, double displacement) {
  double worst = 0;
  for (const std::vector<EndResult>& body : r.boundary)
    for (const EndResult& e : body) {
      const Field f = field(e.x, e.y);
      worst =
          std::max({worst, std::fabs(e.ux - f.ux) / displacement, std::fabs(e.uy - f.uy) / displacement,
                    std::fabs(e.sxx - f.sxx) / stress, std::fabs(e.syy - f.syy) / stress, std::fabs(e.sxy - f.sxy) / stress});
    }
  return worst;
}
double off_displacements(const Result& r, const FieldAt& field, double displacement) {
  double worst = 0;
  for (const std::vector<EndResult>& body : r.boundary)
    for (const EndResult& e : body)
      worst = std::max(worst, std::hypot(e.ux - field(e.x, e.y).ux, e.uy - field(e.x, e.y).uy) / displacement);
  return worst;
}

const double kE = 1000, kNu = 0.3;
const double kPlaneE = kE / (1 - kNu * kNu), kPlaneNu = kNu / (1 - kNu); // of plane strain

Field uniform_field(double sxx, double syy, double sxy, double x, double y) {
  const double exx = (sxx - kPlaneNu * syy) / kPlaneE, eyy = (syy - kPlaneNu * sxx) / kPlaneE;
  return {exx * x, eyy * y + 2 * (1 + kPlaneNu) * sxy / kPlaneE * x, sxx, syy, sxy};
}
Field bending(double x, double y) { // sxx = y
  return {x * y / kPlaneE, -(x * x + kPlaneNu * y * y) / (2 * kPlaneE), y, 0, 0};
}
Field bent_and_pulled(double x, double y) {
  const Field a = bending(x, y), b = uniform_field(0, 1, 0, x, y);
  return {a.ux + b.ux, a.uy + b.uy, a.sxx, b.syy, 0};
}
// A cantilever |y| < 1/2 of length 4 with a force at its end.
Field cantilever(double x, double y) {
  const double L = 4, c = 0.5, G = kPlaneE / (2 * (1 + kPlaneNu));
  const double ux = (L * x - x * x / 2) * y / kPlaneE + (1 / (2 * G) - kPlaneNu / (2 * kPlaneE)) * y * y * y / 3;
  const double uy =
      -kPlaneNu * (L - x) * y * y / (2 * kPlaneE) - (L * x * x / 2 - x * x * x / 6) / kPlaneE - c * c * x / (2 * G);
  return {ux, uy, (L - x) * y, 0, -0.5 * (c * c - y * y)};
}

// Three plates of width 3 one on the other, tied; matching or not.
Model tied_stack(int32_t kind, const FieldAt& field, int32_t function_nodes = 2) {
  const std::array<int32_t, 4> same[3] = {{6, 3, 6, 3}, {6, 2, 6, 2}, {6, 4, 6, 4}},
                               unlike[3] = {{5, 3, 7, 3}, {6, 2, 9, 2}, {8, 4, 5, 4}};
  Model m;
  m.function_nodes = function_nodes;
  for (int i = 0; i < 3; ++i) {
    m.add(rectangle(0, i, 3, i + 1, kind == C2D_ZONE_MATCHING ? same[i] : unlike[i], kE, kNu));
    load_rectangle(m, i + 1, field);
  }
  for (int i = 1; i <= 3; ++i)
    m.set(i, 4, [&](double x, double y) { return end_of(kPulled, -field(x, y).sxx, -field(x, y).sxy); });
  m.set(1, 1, [&](double x, double y) { return end_of(kHeld, 0, 0, field(x, y).ux, field(x, y).uy); });
  for (int i = 1; i <= 2; ++i) tie(m, kind, i, 3, i + 1, 1);
  return m;
}

void check_tied(const Model& m, const Result& r) {
  CHECK(imbalance(m, r) < 1e-12);
  CHECK(breach(m, r) == "");
  for (const Step& s : r.steps)
    for (const Row& row : s.rows) CHECK(static_cast<int>(row[C2D_STATUS]) == C2D_TIED);
}

} // namespace

TEST_CASE("ties: a stack under tension and shear is uniform") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    const FieldAt field = [](double x, double y) { return uniform_field(0.3, 1, 0.8, x, y); };
    const Model m = tied_stack(kind, field);
    const Result r = solved(m);
    check_tied(m, r);
    CHECK(off_field(r, field, 1, 3 / kPlaneE) < 1e-10);
    for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] + 1) < 1e-10);
    CHECK(std::fabs(r.last().defect) < 1e-10);
    for (const std::vector<int32_t>& order : {std::vector<int32_t>{3, 1, 2}, {2, 3, 1}, {3, 2, 1}})
      CHECK(difference(r, solved(with_bodies_in_order(m, order))) < 1e-10);
    if (kind == C2D_ZONE_MATCHING) CHECK(difference(r, solved(with_swapped_sides(m, 1))) < 1e-10);
  }
}

TEST_CASE("ties: a linear stress is exact with quadratic functions, and energies balance") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    const Model flat = tied_stack(kind, bent_and_pulled, 3); // cut along the fibres
    Result r = solved(flat);
    check_tied(flat, r);
    CHECK(off_field(r, bent_and_pulled, 3, 9 / kPlaneE) < 1e-9);
    CHECK(std::fabs(r.last().defect) < 1e-9);
    Model cross; // cut across them
    cross.function_nodes = 3;
    const bool same = kind == C2D_ZONE_MATCHING;
    cross.add(rectangle(0, -1, 2, 1, {4, 5, 4, 4}, kE, kNu));
    cross.add(rectangle(2, -1, 4, 1, {4, 4, 3, same ? 5 : 7}, kE, kNu));
    for (int32_t b = 1; b <= 2; ++b) load_rectangle(cross, b, bending);
    tie(cross, kind, 1, 2, 2, 4);
    r = solved(cross);
    check_tied(cross, r);
    CHECK(off_field(r, bending, 1, 8 / kPlaneE) < 1e-9);
    CHECK(std::fabs(r.last().defect) < 1e-9);
  }
}

TEST_CASE("ties: those that carry nothing are solved") {
  for (const int32_t kind : kKinds) {
    const FieldAt field = [](double x, double y) { return uniform_field(1, 0, 0, x, y); };
    const Result r = solved(tied_stack(kind, field));
    CHECK(off_field(r, field, 1, 3 / kPlaneE) < 1e-10);
  }
}

// ---- where they end

namespace {

// A strip on another, shorter one; half of it with the line of symmetry x = 0.
Model strip_on_strip(double upper_modulus, bool half) {
  Model m;
  const double from = half ? 0 : -1;
  if (half) {
    m.add(open_polygon({{0, 0, 3}, {2, 0, 2}, {2, 1, 2}, {1, 1, 3}, {0, 1, 0}}, 100));
    m.add(open_polygon({{0, 1, 3}, {1, 1, 2}, {1, 2, 3}, {0, 2, 0}}, upper_modulus));
    m.symmetry = 1;
  } else {
    m.add(polygon({{-2, 0, 6}, {2, 0, 2}, {2, 1, 2}, {1, 1, 6}, {-1, 1, 2}, {-2, 1, 2}}, 100));
    m.add(rectangle(from, 1, 1, 2, {6, 2, 6, 2}, upper_modulus));
  }
  m.set(1, 1, half ? end_of("0110") : end_of(kHeld));
  m.set(2, 3, end_of(kPulled, 0, 1));
  tie(m, C2D_ZONE_MATCHING, 1, 4, 2, 1);
  return m;
}
// The half turned by 90 degrees, with elements on the line of symmetry.
Model strip_beside_strip() {
  Model m;
  m.add(polygon({{0, 0, 3}, {0, 2, 2}, {-1, 2, 2}, {-1, 1, 3}, {-1, 0, 2}}, 100));
  m.add(polygon({{-1, 0, 3}, {-1, 1, 6}, {-2, 1, 6}, {-2, 0, 2}}, 300));
  m.set(1, 1, end_of("1001"));
  m.set(1, 5, end_of("0110"));
  m.set(2, 4, end_of("0110"));
  m.set(2, 3, end_of(kPulled, -1, 0));
  tie(m, C2D_ZONE_MATCHING, 1, 4, 2, 1);
  return m;
}

} // namespace

TEST_CASE("ties: where those of unlike materials end a warning says that stresses are singular") {
  const std::string words = "the tied zone 1 joins unlike materials, bodies 1 and 2, and ends at ";
  CHECK(solve(strip_on_strip(300, false)).told_of(words + "(1, 1) and (-1, 1): stresses there are singular"));
  CHECK(solve(strip_on_strip(300, true)).told_of(words + "(1, 1): stresses there are singular"));
  CHECK(solve(strip_beside_strip()).told_of(words + "(-1, 1): stresses there are singular"));
  for (const bool half : {false, true}) CHECK(!solve(strip_on_strip(100, half)).told_of("singular"));
  Model rigid = strip_on_strip(100, false);
  rigid.set(2, 3, End());
  rigid.body(2).rigid = 1;
  rigid.body(2).motion[1] = 0.01;
  CHECK(solve(rigid).told_of(words));
  // An inclusion has no ends, nor has one zone that goes on in another.
  Model ring;
  Body plate = rectangle(-2, -2, 2, 2, {4, 4, 4, 4}, 100), disc;
  const double turn = 2 * std::acos(-1.0);
  add_curve(plate, 12, [&](double s, double& x, double& y) { x = std::cos(turn * s), y = -std::sin(turn * s); });
  add_curve(disc, 12, [&](double s, double& x, double& y) { x = std::cos(turn * s), y = std::sin(turn * s); });
  disc.youngs_modulus = 300;
  ring.add(plate);
  ring.add(disc);
  ring.set(1, 1, end_of(kHeld));
  ring.set(1, 3, end_of(kPulled, 0, 1));
  tie(ring, C2D_ZONE_MATCHING, 1, 5, 2, 1);
  CHECK(!solved(ring).told_of("singular"));
}

TEST_CASE("ties: surfaces that are apart are told of with the zone") {
  Model m = strip_on_strip(300, false);
  for (size_t i = 1; i < m.body(2).xy.size(); i += 2) m.body(2).xy[i] += 0.1;
  CHECK(solve(m).told_of(": the surfaces of the tied zone 1 are 0.1 apart, expected surfaces that coincide"));
}

TEST_CASE("ties: their status is tied also where the path cannot start") {
  Model m = strip_on_strip(300, false);
  m.set(1, 1, End());
  const Result r = solve(m);
  CHECK(r.outcome == C2D_FREE_MOTION);
  REQUIRE(!r.last().rows.empty());
  for (const Row& row : r.last().rows) CHECK(static_cast<int>(row[C2D_STATUS]) == C2D_TIED);
  CHECK(r.zones[0].open == 0);
  CHECK(r.zones[0].stick == static_cast<int32_t>(r.last().rows.size()));
}

// ---- cut and tied against the whole

namespace {

const FieldAt kCantilever = cantilever;
const double kDeflection = 4 * 4 * 4 / (3 * kPlaneE);

Model whole_beam(int32_t n, int32_t function_nodes) {
  Model m;
  m.function_nodes = function_nodes;
  m.add(rectangle(0, -0.5, 4, 0.5, {4 * n, n, 4 * n, n}, kE, kNu));
  load_rectangle(m, 1, cantilever);
  return m;
}
Model cut_beam(int32_t n, int32_t function_nodes, int32_t kind) {
  Model m;
  m.function_nodes = function_nodes;
  m.add(rectangle(0, -0.5, 2, 0.5, {2 * n, n, 2 * n, n}, kE, kNu));
  m.add(rectangle(2, -0.5, 4, 0.5, {2 * n, n, 2 * n, kind == C2D_ZONE_MATCHING ? n : n + 1}, kE, kNu));
  for (int32_t b = 1; b <= 2; ++b) load_rectangle(m, b, cantilever);
  tie(m, kind, 1, 2, 2, 4);
  return m;
}
// Largest difference at the ends that both have.
double between(const Result& whole, const Result& cut) {
  double worst = 0;
  for (const std::vector<EndResult>& body : cut.boundary)
    for (const EndResult& e : body)
      for (const EndResult& w : whole.boundary[0])
        if (std::hypot(e.x - w.x, e.y - w.y) < 1e-9)
          worst = std::max(worst, std::hypot(e.ux - w.ux, e.uy - w.uy) / kDeflection);
  return worst;
}

} // namespace

TEST_CASE("ties: a beam cut in two and tied is the whole one within its error, and converges like it") {
  for (const int32_t function_nodes : {2, 3})
    for (const int32_t kind : kKinds) {
      CAPTURE(function_nodes);
      CAPTURE(kind);
      double before = 0;
      for (const int32_t n : {2, 4, 8}) {
        CAPTURE(n);
        const Result whole = solved(whole_beam(n, function_nodes)), cut = solved(cut_beam(n, function_nodes, kind));
        const double whole_error = off_displacements(whole, kCantilever, kDeflection),
                     cut_error = off_displacements(cut, kCantilever, kDeflection);
        // Two and three elements across the beam, or four and five, do not show yet how a cubic passes between them; measured
        // 2.8 and 1.3 times the error of the whole, with eight elements 0.48 times.
        const bool coarse = kind == C2D_ZONE_FREE && function_nodes == 3 && n < 8;
        CHECK(between(whole, cut) < (coarse ? 3 : 1) * whole_error);
        if (n > 2) CHECK(std::log2(before / cut_error) > function_nodes - 0.2);
        before = cut_error;
      }
    }
}

// ---- inclusions

namespace {

// A disc tied into a hole of a plate, of so many elements; the disc of more if the tie is free.
Model inclusion(int32_t kind, int32_t n, const FieldAt& field) {
  Model m;
  m.function_nodes = 3;
  const double turn = 2 * std::acos(-1.0);
  Body plate, disc;
  plate.element_nodes = disc.element_nodes = 3;
  plate.youngs_modulus = disc.youngs_modulus = kE;
  const int32_t more = kind == C2D_ZONE_FREE ? n + 3 : n;
  add_polygon(plate, {{0, -2, 4}, {4, -2, 5}, {4, 2, 4}, {0, 2, 6}});
  add_curve(plate, n, [&](double s, double& x, double& y) { x = 2 + std::cos(turn * s), y = -std::sin(turn * s); });
  add_curve(disc, more, [&](double s, double& x, double& y) { x = 2 + std::cos(turn * s), y = std::sin(turn * s); });
  m.add(plate);
  m.add(disc);
  load_rectangle(m, 1, field);
  m.zones.push_back({tied(kind), {{1, plate.sides[4].first, plate.sides[4].last, n}, {2, more, 1, more}}});
  return m;
}

} // namespace

TEST_CASE("ties: an inclusion of the same material is not seen") {
  const FieldAt field = [](double x, double y) { return uniform_field(1, -0.4, 0.2, x, y); };
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    double before = 0;
    for (const int32_t n : {8, 16, 32}) {
      const Model m = inclusion(kind, n, field);
      const Result r = solved(m);
      check_tied(m, r);
      const double error = off_field(r, field, 1, 4 / kPlaneE);
      // At the ends, stresses included. With free meshes the kinks between the elements of both surfaces do not meet.
      if (n > 8) CHECK(std::log2(before / error) > (kind == C2D_ZONE_FREE ? 1.3 : 1.8));
      before = error;
    }
    CHECK(before < (kind == C2D_ZONE_FREE ? 3e-3 : 3e-4));
  }
}

// ---- what a tie does along a path

namespace {

// Two unlike plates tied on a third one that they press on: a tie, and contact with friction.
Model tie_and_contact(double mu = 0.14) {
  Model m;
  m.add(rectangle(0, 0, 4, 1, {8, 3, 8, 3}, 800));
  m.add(rectangle(0, 1, 4, 2, {8, 2, 6, 2}, 1000));
  m.add(rectangle(0, 2, 4, 3, {9, 3, 8, 3}, 300));
  m.set(1, 1, end_of(kHeld));
  m.set(3, 3, [](double x, double) { return end_of(kPulled, 0.12, -1 - 0.3 * std::cos(x)); });
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.join(tied(C2D_ZONE_FREE), 2, 3, 3, 1);
  m.friction = mu;
  m.paths = {{3, 1.0}};
  return m;
}

} // namespace

TEST_CASE("ties: never change their status, however the load turns") {
  for (const int32_t kind : kKinds) {
    Model m = tied_stack(kind, [](double x, double y) { return uniform_field(0.2, 1, 0.5, x, y); });
    m.body(2).youngs_modulus = 200;
    m.paths = {{2, 1.0}, {4, -1.5}, {3, 2.0}};
    const Result r = solved(m);
    check_tied(m, r);
    CHECK(r.summary.events == 0);
    CHECK(r.last().dissipated == 0);
    REQUIRE(r.steps.size() == 9);
    for (size_t i = 0; i < r.last().rows.size(); ++i) // the state is that of the load alone
      for (const int field : {C2D_TN, C2D_TT, C2D_UN1, C2D_UT1})
        CHECK(std::fabs(r.last().rows[i][static_cast<size_t>(field)] - 2 * r.steps[1].rows[i][static_cast<size_t>(field)]) <
              1e-9);
  }
}

TEST_CASE("ties: beside contact, in any order") {
  const Model m = tie_and_contact();
  const Result r = solved(m);
  CHECK(breach(m, r) == "");
  CHECK(imbalance(m, r) < 1e-12);
  bool slips = false;
  for (const Row& row : r.last().rows) slips = slips || static_cast<int>(row[C2D_STATUS]) == C2D_SLIP;
  CHECK(slips);
  Mapping zones;
  zones.zone = {2, 1};
  CHECK(difference(r, solved(with_bodies_in_order(m, {3, 1, 2}))) < 1e-10);
  CHECK(difference(r, solved(with_zones_in_order(m, {2, 1})), zones) < 1e-10);
  Mapping mirror;
  mirror.tangential = -1;
  mirror.place = [](double& x, double&) { x = -x; };
  CHECK(difference(r, solved(reflected(m)), mirror) < 1e-10);
}

TEST_CASE("ties: a path that is saved goes on with the same bits") {
  const Model m = tie_and_contact();
  Machine one(m), two(m);
  for (Machine* at : {&one, &two}) {
    REQUIRE(at->status == C2D_OK);
    REQUIRE(c2d_prepare(at->solver) == C2D_OK);
    const double mu = 0.14;
    REQUIRE(c2d_begin(at->solver, &mu, 1) == C2D_OK);
    c2d_outcome outcome;
    for (const double load : {0.4, 0.7}) REQUIRE(c2d_advance(at->solver, &load, 1, &outcome) == C2D_OK);
  }
  REQUIRE(c2d_save(two.solver) == C2D_OK);
  c2d_outcome outcome;
  const double load = 1, off = -0.2;
  REQUIRE(c2d_advance(two.solver, &off, 1, &outcome) == C2D_OK);
  REQUIRE(c2d_restore(two.solver) == C2D_OK);
  for (Machine* at : {&one, &two}) REQUIRE(c2d_advance(at->solver, &load, 1, &outcome) == C2D_OK);
  const Result a = one.look(), b = two.look();
  for (size_t body = 0; body < 3; ++body)
    for (size_t i = 0; i < a.boundary[body].size(); ++i) {
      CHECK(a.boundary[body][i].ux == b.boundary[body][i].ux);
      CHECK(a.boundary[body][i].ty == b.boundary[body][i].ty);
    }
}

TEST_CASE("ties: new loads give what a new model gives") {
  Model m = tie_and_contact(), other = m;
  other.set(3, 3, [](double x, double) { return end_of(kPulled, -0.05, -1.2 + 0.1 * x); });
  const Result fresh = solved(other);
  for (const int32_t keep_factors : {0, 1}) {
    CAPTURE(keep_factors);
    Machine machine(m, keep_factors);
    REQUIRE(machine.run().status == C2D_OK);
    REQUIRE(c2d_change_loads(machine.solver) == C2D_OK);
    const Range top = other.side(3, 3);
    for (int32_t e = top.first; e <= top.last; ++e)
      for (int32_t l = 1; l <= 2; ++l)
        REQUIRE(c2d_set_values(machine.solver, 3, e, l, 1,
                               other.body(3).ends[static_cast<size_t>(2 * (e - 1) + l - 1)].values) == C2D_OK);
    const Result r = machine.run();
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(difference(fresh, r) < 1e-10);
    CHECK(status_differences(fresh, r) == 0);
  }
}

TEST_CASE("ties: with a line of symmetry by images") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    const auto load = [](double x, double) { return end_of(kPulled, 0, 1 + std::cos(x)); };
    Model half, whole;
    half.add(open_polygon({{0, 0, 4}, {2, 0, 3}, {2, 1, 5}, {0, 1, 0}}, 1000));
    half.add(open_polygon({{0, 1, kind == C2D_ZONE_FREE ? 4 : 5}, {2, 1, 3}, {2, 2, 4}, {0, 2, 0}}, 300));
    half.set(1, 1, end_of("0110"));
    half.set(2, 3, load);
    half.symmetry = 1;
    tie(half, kind, 1, 3, 2, 1);
    whole.add(rectangle(-2, 0, 2, 1, {8, 3, 10, 3}, 1000));
    whole.add(rectangle(-2, 1, 2, 2, {kind == C2D_ZONE_FREE ? 8 : 10, 3, 8, 3}, 300));
    whole.set(1, 1, end_of("0110"));
    whole.body(1).ends[2 * 4] = end_of(kHeld);
    whole.body(1).ends[2 * 4 - 1] = end_of(kHeld);
    whole.set(2, 3, load);
    tie(whole, kind, 1, 3, 2, 1);
    Result a = solved(half), b = solved(whole);
    check_tied(half, a);
    check_tied(whole, b);
    CHECK(std::fabs(b.last().work - 2 * a.last().work) < 1e-9 * a.last().work);
    for (Result* r : {&a, &b}) r->steps[0].work = r->steps[0].elastic = 0;
    std::vector<Row>& rows = b.steps[0].rows;
    rows.erase(std::remove_if(rows.begin(), rows.end(), [](const Row& row) { return row[C2D_X] < -1e-9; }), rows.end());
    CHECK(difference(a, b) < 1e-9);
  }
}

// ---- what is refused

TEST_CASE("ties: surfaces that do not coincide are refused") {
  for (const int32_t kind : kKinds)
    for (const double gap : {0.06, -0.06, 0.04, -0.04}) { // of elements of 0.5
      CAPTURE(kind);
      CAPTURE(gap);
      Model m;
      m.add(rectangle(0, 0, 3, 1, {6, 2, 6, 2}));
      m.add(rectangle(0, 1 + gap, 3, 2, {6, 2, 6, 2}));
      m.set(1, 1, end_of(kHeld));
      m.set(2, 3, end_of(kPulled, 0, 1));
      m.join(tied(kind), 1, 3, 2, 1);
      const Result r = solve(m);
      if (std::fabs(gap) < 0.05) {
        CHECK(r.status == C2D_OK);
        for (const Row& row : r.last().rows) CHECK(row[C2D_GAP] == 0);
        continue;
      }
      CHECK(r.status == C2D_ERR_INPUT);
      CHECK(r.told.front().zone == 1);
      CHECK(r.told_of("tied"));
      CHECK(r.told_of("expected surfaces that coincide within a tenth of an element"));
    }
}

// Contact, tie and contact on one face under uniform pressure, which does not jump where they meet.
TEST_CASE("ties: zones that meet share the node there, in any order") {
  const FieldAt field = [](double x, double y) { return uniform_field(0.3, -1, 0, x, y); };
  const int end[4] = {0, 3, 5, 8}; // elements of the zones, from the left
  for (const int functions : {2, 3, 4})
    for (const int32_t kind : kKinds) // of the tie
      for (const std::array<int, 3>& order : {std::array<int, 3>{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}) {
        CAPTURE(functions);
        CAPTURE(kind);
        CAPTURE(order[0]);
        Model m;
        m.function_nodes = functions;
        m.add(rectangle(0, 0, 4, 1, {8, 2, 8, 2}, kE, kNu));
        m.add(rectangle(0, 1, 4, 2, {8, 2, 8, 2}, kE, kNu));
        for (int32_t b = 1; b <= 2; ++b)
          for (const int32_t side : {2, 4}) m.set(b, side, end_of(kPulled, side == 2 ? 0.3 : -0.3, 0));
        m.set(1, 1, [&](double x, double y) { return end_of(kHeld, 0, 0, field(x, y).ux, field(x, y).uy); });
        m.set(2, 3, end_of(kPulled, 0, -1));
        const Range top = m.side(1, 3), foot = m.side(2, 1);
        for (const int z : order)
          m.zones.push_back(
              {z == 1 ? tied(kind) : C2D_ZONE_FREE,
               {{1, top.last - end[z], top.last - end[z + 1] + 1}, {2, foot.first + end[z], foot.first + end[z + 1] - 1}}});
        const Result r = solved(m);
        CHECK(imbalance(m, r) < 1e-12);
        CHECK(breach(m, r) == "");
        CHECK(off_field(r, field, 1, 3 / kPlaneE) < 1e-10);
        CHECK(r.last().rows.size() == static_cast<size_t>(8 * (functions - 1) + 1));
        for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10);
      }
}

// A block on two others, whose zones meet at a node, between supports that hold its corners: no pair there, no false peak.
TEST_CASE("ties: free zones end at supports, and beside those of other bodies") {
  const FieldAt field = [](double x, double y) { return uniform_field(0.3, -1, 0, x, y); };
  for (const int functions : {2, 3, 4})
    for (const int supports : {0, 1, 2}) // none, in x, in both
      for (const bool swapped : {false, true}) {
        CAPTURE(functions);
        CAPTURE(supports);
        CAPTURE(swapped);
        Model m;
        m.function_nodes = functions;
        m.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}, kE, kNu));
        m.add(rectangle(2, 0, 4, 1, {5, 2, 5, 2}, kE, kNu));
        m.add(rectangle(0, 1, 4, 2, {8, 2, 8, 2}, kE, kNu));
        for (int32_t b = 1; b <= 3; ++b)
          for (const int32_t side : {2, 4}) m.set(b, side, end_of(kPulled, side == 2 ? 0.3 : -0.3, 0));
        const auto held = [&](double x, double y) { return end_of(kHeld, 0, 0, field(x, y).ux, field(x, y).uy); };
        for (int32_t b = 1; b <= 2; ++b) m.set(b, 1, held);
        m.set(3, 3, end_of(kPulled, 0, -1));
        for (const int32_t side : {2, 4})
          if (supports == 2)
            m.set(3, side, held);
          else if (supports == 1)
            m.set(3, side, [&](double x, double y) { return end_of("1001", 0, 0, field(x, y).ux, 0); });
        const Range foot = m.side(3, 1);
        for (const int32_t b : {swapped ? 2 : 1, swapped ? 1 : 2}) {
          const Range top = m.side(b, 3);
          m.zones.push_back({C2D_ZONE_FREE, {{b, top.first, top.last}, {3, foot.first + 4 * (b - 1), foot.first + 4 * b - 1}}});
        }
        const Result r = solved(m);
        CHECK(imbalance(m, r) < 1e-12);
        CHECK(breach(m, r) == "");
        CHECK(off_field(r, field, 1, 3 / kPlaneE) < 1e-10);
        CHECK(std::fabs(r.last().defect) < 1e-10);
        CHECK(r.last().rows.size() == static_cast<size_t>(8 * (functions - 1) + 1 - (supports == 0 ? 0 : 2)));
        for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10);
      }
}

// The same with meshes that coincide: the node where two zones meet is left out of the pairs of one of them, and the end there
// carries the traction of its nearest pair, on both bodies, whether both are in both zones or not.
TEST_CASE("ties: matching zones that meet have uniform pressure up to the node that one leaves to the other") {
  const FieldAt field = [](double x, double y) { return uniform_field(0.3, -1, 0, x, y); };
  const int end[4] = {0, 3, 5, 8}; // elements of the zones, from the left
  for (const int functions : {2, 3, 4})
    for (const bool parted : {false, true}) // the lower body at x = 1.5
      for (const std::array<int, 3>& order : {std::array<int, 3>{0, 1, 2}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}) {
        CAPTURE(functions);
        CAPTURE(parted);
        CAPTURE(order[0]);
        CAPTURE(order[1]);
        Model m;
        m.function_nodes = functions;
        if (parted) {
          m.add(rectangle(0, 0, 1.5, 1, {3, 2, 3, 2}, kE, kNu));
          m.add(rectangle(1.5, 0, 4, 1, {5, 2, 5, 2}, kE, kNu));
        } else {
          m.add(rectangle(0, 0, 4, 1, {8, 2, 8, 2}, kE, kNu));
        }
        m.add(rectangle(0, 1, 4, 2, {8, 2, 8, 2}, kE, kNu));
        const int32_t upper = parted ? 3 : 2;
        for (int32_t b = 1; b <= upper; ++b)
          for (const int32_t side : {2, 4}) m.set(b, side, end_of(kPulled, side == 2 ? 0.3 : -0.3, 0));
        for (int32_t b = 1; b < upper; ++b)
          m.set(b, 1, [&](double x, double y) { return end_of(kHeld, 0, 0, field(x, y).ux, field(x, y).uy); });
        m.set(upper, 3, end_of(kPulled, 0, -1));
        const Range foot = m.side(upper, 1);
        bool has[9] = {}; // nodes between the elements that a zone has
        for (const int z : order) {
          const int32_t b = parted && z > 0 ? 2 : 1;
          const Range top = m.side(b, 3);
          const int32_t last = parted && z == 0 ? top.last - end[z] : top.last - (end[z] - (b == 2 ? 3 : 0));
          Zone zone{z == 1 ? tied(C2D_ZONE_MATCHING) : C2D_ZONE_MATCHING,
                    {{b, last, last - (end[z + 1] - end[z]) + 1}, {upper, foot.first + end[z], foot.first + end[z + 1] - 1}}};
          zone.without[0] = has[end[z]] ? 1 : 0, zone.without[1] = has[end[z + 1]] ? 1 : 0;
          has[end[z]] = has[end[z + 1]] = true;
          m.zones.push_back(zone);
        }
        const Result r = solved(m);
        CHECK(imbalance(m, r) < 1e-12);
        CHECK(breach(m, r) == "");
        CHECK(off_field(r, field, 1, 3 / kPlaneE) < 1e-10);
        CHECK(std::fabs(r.last().defect) < 1e-10);
        CHECK(r.last().rows.size() == static_cast<size_t>(8 * (functions - 1) + 1));
        for (const Row& row : r.last().rows) CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10);
      }
}

// A block in a corner: which of the two zones has the node there, on faces at right angles.
TEST_CASE("ties: matching zones that meet in a corner have their uniform pressures up to it") {
  const auto held = [](double sx, double sy) {
    return [=](double x, double y) {
      const Field e = uniform_field(sx, sy, 0, x, y);
      return end_of(kHeld, 0, 0, e.ux, e.uy);
    };
  };
  for (const int functions : {2, 3, 4})
    for (const int keeps : {0, 1}) { // the zone that has the node
      CAPTURE(functions);
      CAPTURE(keeps);
      Model m;
      m.function_nodes = functions;
      m.add(rectangle(0, -1, 2, 0, {4, 2, 4, 2}, kE, kNu));
      m.add(rectangle(2, 0, 3, 1, {2, 2, 2, 2}, kE, kNu));
      m.add(rectangle(0, 0, 2, 1, {4, 2, 4, 2}, kE, kNu));
      m.set(1, 1, held(0, -1));
      m.set(2, 2, held(-0.5, 0));
      m.set(3, 3, end_of(kPulled, 0, -1));
      m.set(3, 4, end_of(kPulled, 0.5, 0));
      m.join(C2D_ZONE_MATCHING, 1, 3, 3, 1);
      m.join(C2D_ZONE_MATCHING, 2, 4, 3, 2);
      if (keeps == 1)
        m.zones[0].without[0] = 1;
      else
        m.zones[1].without[1] = 1;
      const Result r = solved(m);
      CHECK(imbalance(m, r) < 1e-12);
      CHECK(breach(m, r) == "");
      CHECK(std::fabs(r.last().defect) < 1e-10);
      const size_t first = static_cast<size_t>(4 * (functions - 1) + 1 - keeps);
      REQUIRE(r.last().rows.size() == static_cast<size_t>(6 * (functions - 1) + 1));
      for (size_t i = 0; i < r.last().rows.size(); ++i)
        CHECK(std::fabs(r.last().rows[i][C2D_TN] - (i < first ? 1 : 0.5)) < 1e-10);
    }
}

TEST_CASE("ties: a tie and a contact on one node are refused") {
  Model m;
  m.add(rectangle(0, 0, 4, 1, {8, 2, 8, 2}));
  m.add(rectangle(0, 1, 4, 2, {8, 2, 8, 2}));
  m.set(1, 1, end_of(kHeld));
  m.set(2, 3, end_of(kPulled, 0, -1));
  const Range top = m.side(1, 3), foot = m.side(2, 1);
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, top.first, top.first + 3}, {2, foot.last, foot.last - 3}}});
  m.zones.push_back({tied(C2D_ZONE_MATCHING), {{1, top.first + 4, top.last}, {2, foot.last - 4, foot.first}}});
  const Result r = solve(m);
  CHECK(r.status == C2D_ERR_INPUT);
  CHECK(r.told_of("node 15 of body 1")); // x = 2
  CHECK(r.told_of("node 5 of body 2"));
  CHECK(r.told_of("expected in one pair only"));
}
