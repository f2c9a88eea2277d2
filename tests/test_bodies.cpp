// Models of more than two bodies: uniform states, equivalent models, what may not matter, bodies that lean on others, chains.
#include "paths.hpp"
#include "solved_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

using namespace many;
using namespace solved_bodies;

namespace {

// Largest difference of the stresses at all ends of all bodies from these.
double off_stress(const Result& r, double sxx, double syy, double sxy) {
  double worst = 0;
  for (const std::vector<EndResult>& body : r.boundary)
    for (const EndResult& e : body)
      worst = std::max({worst, std::fabs(e.sxx - sxx), std::fabs(e.syy - syy), std::fabs(e.sxy - sxy)});
  return worst;
}

// Three plates of width 3, one on the other: the lowest stands on rollers and is held at one point; pressure and shear on all
// outer sides make the stress uniform.
Model stack(int32_t kind, double pressure, double shear, const double (&moduli)[3]) {
  const std::array<int32_t, 4> same[3] = {{6, 3, 6, 3}, {6, 2, 6, 2}, {6, 4, 6, 4}},
                               unlike[3] = {{5, 3, 7, 3}, {6, 2, 9, 2}, {8, 4, 5, 4}};
  Model m;
  for (int i = 0; i < 3; ++i) {
    m.add(rectangle(0, i, 3, i + 1, kind == C2D_ZONE_MATCHING ? same[i] : unlike[i], moduli[i]));
    m.set(i + 1, 2, end_of(kPulled, 0, shear));
    m.set(i + 1, 4, end_of(kPulled, 0, -shear));
  }
  m.set(1, 1, end_of("0110", -shear));
  m.body(1).ends[0] = end_of(kHeld); // its reaction along x is zero
  m.set(3, 3, end_of(kPulled, shear, -pressure));
  for (int i = 1; i <= 2; ++i) m.join(kind, i, 3, i + 1, 1);
  m.friction = 0.5;
  return m;
}

} // namespace

TEST_CASE("bodies: a stack of three plates under pressure, and under pressure and shear, is uniform") {
  for (const int32_t kind : kKinds)
    for (const double shear : {0.0, 0.4}) {
      CAPTURE(kind);
      CAPTURE(shear);
      const Model m = stack(kind, 1, shear, {100, 100, 100});
      const Result r = solved(m);
      CHECK(off_stress(r, 0, -1, shear) < 1e-10);
      for (const Row& row : r.last().rows) {
        CHECK(std::fabs(row[C2D_TN] - 1) < 1e-10);
        CHECK(std::fabs(std::fabs(row[C2D_TT]) - shear) < 1e-10);
        if (shear > 0) CHECK(static_cast<int>(row[C2D_STATUS]) == C2D_STICK);
      }
      CHECK(imbalance(m, r) < 1e-12);
    }
}

TEST_CASE("bodies: a smooth stack of three materials is uniform") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    Model m = stack(kind, 1, 0, {100, 37, 900});
    m.friction = 0; // the plates widen unlike
    // The upper two are held sideways, one point each.
    for (int i = 2; i <= 3; ++i) m.body(i).ends[static_cast<size_t>(2 * m.side(i, 2).first - 1)] = end_of("1001");
    CHECK(off_stress(solved(m), 0, -1, 0) < 1e-10);
  }
}

// ---- symmetry by images against the whole

namespace {

constexpr double kHalf = 0.5; // of the layer's thickness
const int32_t kZoneElements = 14;

std::vector<Corner> upper_block() { return {{-2, kHalf, kZoneElements}, {2, kHalf, 5}, {2, 2.5, 8}, {-2, 2.5, 5}}; }
std::vector<Corner> mirrored(std::vector<Corner> c) { // y -> -y, run the other way round
  std::vector<Corner> out;
  for (size_t i = 0; i < c.size(); ++i) {
    const Corner &from = c[(c.size() - i) % c.size()], &side = c[c.size() - 1 - i];
    out.push_back({from.x, -from.y, side.elements});
  }
  return out;
}
End pressed(double down) { return end_of(kHeld, 0, 0, 0.1 * down, -down); }

// A soft block on a layer on its mirror image: the layer is longer, its ends lift, some of the contact slips.
Model layer_and_image() {
  Model m;
  m.add(open_polygon({{3, 0, 2}, {3, kHalf, 3}, {2, kHalf, kZoneElements}, {-2, kHalf, 3}, {-3, kHalf, 2}, {-3, 0, 0}}, 1000));
  m.add(polygon(upper_block(), 300));
  m.set(2, 3, pressed(0.01));
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.symmetry = 2;
  m.friction = 0.1;
  m.paths = {{4, 1.0}};
  return m;
}
Model layer_and_two_blocks(const std::array<int32_t, 3>& order) {
  Model m;
  m.add(polygon({{3, -kHalf, 2},
                 {3, 0, 2},
                 {3, kHalf, 3},
                 {2, kHalf, kZoneElements},
                 {-2, kHalf, 3},
                 {-3, kHalf, 2},
                 {-3, 0, 2},
                 {-3, -kHalf, 3},
                 {-2, -kHalf, kZoneElements},
                 {2, -kHalf, 3}},
                1000));
  m.add(polygon(upper_block(), 300));
  m.add(polygon(mirrored(upper_block()), 300));
  m.set(2, 3, pressed(0.01));
  m.set(3, 2, end_of(kHeld, 0, 0, 0.001, 0.01));
  m.join(C2D_ZONE_MATCHING, 1, 4, 2, 1);
  m.join(C2D_ZONE_MATCHING, 1, 9, 3, 4);
  m.friction = 0.1;
  m.paths = {{4, 1.0}};
  return with_bodies_in_order(m, {order[0], order[1], order[2]});
}

} // namespace

TEST_CASE("bodies: a layer between two equal blocks is a layer on its image") {
  const Result image = solved(layer_and_image());
  int statuses[3] = {0, 0, 0};
  for (const Row& row : image.last().rows) ++statuses[static_cast<int>(row[C2D_STATUS])];
  CHECK(statuses[C2D_STICK] > 0);
  CHECK(statuses[C2D_SLIP] > 0);
  for (const std::array<int32_t, 3>& order : {std::array<int32_t, 3>{1, 2, 3}, std::array<int32_t, 3>{3, 1, 2}}) {
    const Model whole = layer_and_two_blocks(order);
    Result both = solved(whole);
    CHECK(imbalance(whole, both) < 1e-12);
    CHECK(std::fabs(both.last().work - 2 * image.last().work) <= 1e-9 * image.last().work);
    for (Step& s : both.steps) // the upper half
      s.rows.erase(std::remove_if(s.rows.begin(), s.rows.end(), [](const Row& row) { return row[C2D_Y] < 0; }), s.rows.end());
    Mapping map;
    Result half = image;
    for (Result* r : {&both, &half})
      for (Step& s : r->steps) s.work = s.elastic = s.dissipated = 0;
    CHECK(difference(half, both, map) < 1e-9);
    CHECK(status_differences(half, both, map) == 0);
  }
}

namespace {

// The same three bodies, of which the right half is modelled.
Model half_of_three() {
  Model m;
  m.add(open_polygon({{0, -kHalf, 7}, {2, -kHalf, 3}, {3, -kHalf, 4}, {3, kHalf, 3}, {2, kHalf, 7}, {0, kHalf, 0}}, 1000));
  m.add(open_polygon({{0, kHalf, 7}, {2, kHalf, 5}, {2, 2.5, 4}, {0, 2.5, 0}}, 300));
  m.add(open_polygon({{0, -3.5, 4}, {2, -3.5, 6}, {2, -kHalf, 7}, {0, -kHalf, 0}}, 400));
  m.set(2, 3, end_of("0110", 0, 0, 0, -0.01));
  m.set(3, 1, end_of("0110"));
  m.join(C2D_ZONE_MATCHING, 1, 5, 2, 1);
  m.join(C2D_ZONE_MATCHING, 3, 3, 1, 1);
  m.symmetry = 1;
  m.friction = 0.1;
  m.paths = {{4, 1.0}};
  return m;
}
Model whole_of_three() {
  Model m;
  m.add(polygon({{-2, -kHalf, 14},
                 {2, -kHalf, 3},
                 {3, -kHalf, 4},
                 {3, kHalf, 3},
                 {2, kHalf, 14},
                 {-2, kHalf, 3},
                 {-3, kHalf, 4},
                 {-3, -kHalf, 3}},
                1000));
  m.add(rectangle(-2, kHalf, 2, 2.5, {14, 5, 8, 5}, 300));
  m.add(rectangle(-2, -3.5, 2, -kHalf, {8, 6, 14, 6}, 400));
  m.set(2, 3, end_of("0110", 0, 0, 0, -0.01));
  m.set(3, 1, end_of("0110"));
  // One point of each end is held across the line; by symmetry its reaction is zero.
  const size_t top = static_cast<size_t>(2 * (m.side(2, 3).first + 3) - 1), foot = 2 * 4 - 1;
  m.body(2).ends[top] = end_of(kHeld, 0, 0, 0, -0.01), m.body(3).ends[foot] = end_of(kHeld);
  m.join(C2D_ZONE_MATCHING, 1, 5, 2, 1);
  m.join(C2D_ZONE_MATCHING, 3, 3, 1, 1);
  m.friction = 0.1;
  m.paths = {{4, 1.0}};
  return m;
}

} // namespace

TEST_CASE("bodies: three with a line of symmetry by images are the whole") {
  const Model half = half_of_three(), whole = whole_of_three();
  Result a = solved(half), b = solved(whole);
  int statuses[3] = {0, 0, 0};
  for (const Row& row : a.last().rows) ++statuses[static_cast<int>(row[C2D_STATUS])];
  CHECK(statuses[C2D_STICK] > 0);
  CHECK(statuses[C2D_SLIP] > 0);
  CHECK(imbalance(whole, b) < 1e-12);
  CHECK(std::fabs(b.last().work - 2 * a.last().work) <= 1e-9 * a.last().work);
  for (Result* r : {&a, &b})
    for (Step& s : r->steps) s.work = s.elastic = s.dissipated = 0;
  for (Step& s : b.steps)
    s.rows.erase(std::remove_if(s.rows.begin(), s.rows.end(), [](const Row& row) { return row[C2D_X] < -1e-9; }), s.rows.end());
  CHECK(difference(a, b) < 1e-9);
  CHECK(status_differences(a, b) == 0);
}

// ---- the receding layer, on both sides of a block

namespace {

struct CurvePoint {
  double x, p;
};
// Columns x/h and p h/P of a reference curve.
std::vector<CurvePoint> reference(const std::string& name) {
  std::ifstream in(paths::data() + "/reference/" + name + ".csv");
  std::vector<CurvePoint> out;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    double x, a, p;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf", &x, &a, &p) == 3) out.push_back({x, p});
  }
  return out;
}
double at(const std::vector<CurvePoint>& curve, double x) {
  for (size_t i = 1; i < curve.size(); ++i)
    if (curve[i].x >= x) {
      const double s = (x - curve[i - 1].x) / (curve[i].x - curve[i - 1].x);
      return (1 - s) * curve[i - 1].p + s * curve[i].p;
    }
  return 0;
}

// Half of it (x >= 0): a block of half width 100 and height 200, and on either side a layer of thickness 1 under a line load.
Model layers_on_block(double layer, double block) {
  const double g = 1.3, strip = 0.01;
  Model m;
  m.function_nodes = 3;
  m.add(open_polygon({{0, -200, 50}, {2.5, -200, 24, g}, {100, -200, 8}, {100, 0, 24, 1 / g}, {2.5, 0, 50}, {0, 0, 0}}, block));
  m.add(open_polygon({{0, 0, 50}, {2.5, 0, 8}, {3.5, 0, 4}, {3.5, 1, 20, 1 / g}, {strip, 1, 2}, {0, 1, 0}}, layer));
  m.add(
      open_polygon({{0, -201, 2}, {strip, -201, 20, g}, {3.5, -201, 4}, {3.5, -200, 8}, {2.5, -200, 50}, {0, -200, 0}}, layer));
  m.body(1).ends[static_cast<size_t>(3 * (m.side(1, 3).first + 3) - 1)] = end_of("0110"); // halfway up
  m.set(2, 5, end_of(kPulled, 0, -1 / (2 * strip)));
  m.set(3, 1, end_of(kPulled, 0, 1 / (2 * strip)));
  m.join(C2D_ZONE_MATCHING, 1, 5, 2, 1);
  m.join(C2D_ZONE_MATCHING, 1, 1, 3, 5);
  m.symmetry = 1;
  return m;
}

} // namespace

TEST_CASE("bodies: receding layers on both sides of a block, as the reference of one on a half plane") {
  const struct {
    const char* file;
    double layer, block, a, p0;
  } cases[] = {{"p02_p_equal", 1000, 1000, 1.3241653718676933, 0.7130805511737414},
               {"p02_p_layer_3x_stiffer", 3000, 1000, 1.836300638935971, 0.5394575709930005},
               {"p02_p_foundation_rigid", 1000, 1e9, 0.8569939232759662, 0.9603329604773432}};
  for (const auto& c : cases) {
    CAPTURE(c.file);
    const Model m = layers_on_block(c.layer, c.block);
    const Result r = solved(m);
    CHECK(imbalance(m, r) < 1e-12);
    const std::vector<CurvePoint> curve = reference(c.file);
    REQUIRE(curve.size() > 10);
    for (int32_t zone = 1; zone <= 2; ++zone) {
      double last = 0, centre = 0, worst = 0;
      for (const Row& row : r.zone_rows(zone)) {
        if (static_cast<int>(row[C2D_STATUS]) != C2D_OPEN) last = std::max(last, row[C2D_X]);
        if (row[C2D_X] < 1e-9) centre = row[C2D_TN];
        if (row[C2D_X] < c.a - 0.05) worst = std::max(worst, std::fabs(row[C2D_TN] - at(curve, row[C2D_X])));
      }
      CHECK(std::fabs(last - c.a) < 0.05); // one element
      CHECK(std::fabs(centre / c.p0 - 1) < 3e-3);
      CHECK(worst < 3e-3 * c.p0);
    }
  }
}

// ---- what may not matter

namespace {

// A wedge-like middle body between a held block and a loaded one: contact with friction that sticks, slips and lifts.
Model three_with_slip(int32_t kind) {
  const bool same = kind == C2D_ZONE_MATCHING;
  Model m;
  m.add(rectangle(0, 0, 4, 1, {8, 3, 8, 3}, 700, 0.25));
  m.add(rectangle(0, 1, 4, 2, {same ? 8 : 6, 2, same ? 8 : 7, 2}, 1000, 0.3));
  m.add(polygon({{0, 2, same ? 8 : 9}, {4, 2, 3}, {4, 3, 8}, {0, 3, 3}}, 400, 0.35));
  m.set(1, 1, end_of(kHeld));
  m.set(3, 3, [](double x, double) { return end_of(kPulled, 0.14 + 0.02 * x, -1 - 0.5 * std::cos(x)); });
  m.join(kind, 1, 3, 2, 1);
  m.join(kind, 2, 3, 3, 1);
  m.friction = 0.25;
  m.zones[1].mu = 0.22;
  m.paths = {{3, 1.0}, {2, 0.6}};
  return m;
}

void check_same(const Result& a, const Model& other, const Mapping& map = Mapping()) {
  const Result b = solved(other);
  CHECK(difference(a, b, map) < 1e-10);
  CHECK(status_differences(a, b, map) == 0);
  CHECK(imbalance(other, b) < 1e-12);
}

} // namespace

TEST_CASE("bodies: order of bodies and zones, sides, mirror, rotation and units do not matter") {
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    const Model m = three_with_slip(kind);
    const Result r = solved(m);
    CHECK(breach(m, r) == "");
    CHECK(imbalance(m, r) < 1e-12);
    int slips = 0, sticks = 0;
    for (const Step& s : r.steps)
      for (const Row& row : s.rows)
        slips += static_cast<int>(row[C2D_STATUS]) == C2D_SLIP, sticks += static_cast<int>(row[C2D_STATUS]) == C2D_STICK;
    CHECK(slips > 5);
    CHECK(sticks > 5);
    CHECK(r.last().dissipated > 0);

    for (const std::vector<int32_t>& order : {std::vector<int32_t>{1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}}) {
      CAPTURE(order[0]);
      CAPTURE(order[1]);
      check_same(r, with_bodies_in_order(m, order));
    }
    Mapping zones;
    zones.zone = {2, 1};
    check_same(r, with_zones_in_order(m, {2, 1}), zones);
    if (kind == C2D_ZONE_MATCHING) { // the two sides of a free zone have different parts
      check_same(r, with_swapped_sides(m, 1));
      check_same(r, with_swapped_sides(with_swapped_sides(m, 1), 2));
    }
    Mapping mirror;
    mirror.tangential = -1;
    mirror.place = [](double& x, double&) { x = -x; };
    check_same(r, reflected(m), mirror);
    for (const double degrees : {31.0, 90.0, -117.3}) {
      CAPTURE(degrees);
      Mapping turn;
      turn.place = [degrees](double& x, double& y) {
        const double angle = degrees * std::acos(-1.0) / 180, old = x;
        x = std::cos(angle) * old - std::sin(angle) * y, y = std::sin(angle) * old + std::cos(angle) * y;
      };
      check_same(r, turned(m, degrees), turn);
    }
    const double units[][2] = {{1e-3, 1}, {1, 1e6}, {37, 7.3e-4}};
    for (const auto& unit : units) {
      CAPTURE(unit[0]);
      Mapping map;
      map.length = unit[0], map.stress = unit[1];
      map.place = [&unit](double& x, double& y) { x *= unit[0], y *= unit[0]; };
      check_same(r, scaled(m, unit[0], unit[1]), map);
    }
  }
}

TEST_CASE("bodies: one without any zone is solved beside the others") {
  Model m = three_with_slip(C2D_ZONE_MATCHING);
  const Result r = solved(m);
  Model more = m;
  const int32_t alone = more.add(rectangle(10, 0, 12, 1, {4, 2, 4, 2}, 500));
  more.set(alone, 1, end_of("0110"));
  more.body(alone).ends[0] = end_of(kHeld);
  more.set(alone, 3, end_of(kPulled, 0, -2));
  for (const bool first : {false, true}) {
    const Model q = first ? with_bodies_in_order(more, {4, 1, 2, 3}) : more;
    Result s = solved(q);
    const std::vector<EndResult>& ends = s.boundary[first ? 0 : 3];
    for (const EndResult& e : ends) CHECK(std::fabs(e.syy + 2 * s.last().load) < 1e-10);
    CHECK(s.bodies[first ? 0 : 3].contact[1] == 0);
    for (Step& step : s.steps) step.work = step.elastic = 0;
    Result before = r;
    for (Step& step : before.steps) step.work = step.elastic = 0;
    CHECK(difference(before, s) < 1e-10);
  }
}

TEST_CASE("bodies: two zones between the same two") {
  // A bridge on two feet: one zone for each foot, against the same bodies with the zones in one row of pairs each.
  Model m;
  m.add(rectangle(0, 0, 6, 1, {6, 2, 12, 2}));
  m.add(polygon({{0, 1, 4}, {2, 1, 2}, {2, 1.5, 4}, {4, 1.5, 2}, {4, 1, 4}, {6, 1, 3}, {6, 2.5, 6}, {0, 2.5, 3}}, 600));
  m.set(1, 1, end_of(kHeld));
  m.set(2, 7, [](double x, double) { return end_of(kPulled, 0.1, -1 - 0.1 * x); });
  const Range top = m.side(1, 3), left = m.side(2, 1), right = m.side(2, 5);
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, top.last - 3, top.last}, {2, left.first + 3, left.first}}});
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, top.first, top.first + 3}, {2, right.last, right.first}}});
  m.friction = 0.2;
  m.paths = {{2, 1.0}};
  const Result r = solved(m);
  CHECK(breach(m, r) == "");
  CHECK(imbalance(m, r) < 1e-12);
  const double both = r.zones[0].force[1] + r.zones[1].force[1];
  CHECK(std::fabs(both - (6 + 0.1 * 18)) < 1e-11);
  CHECK(r.zones[0].force[1] > 1);
  CHECK(r.zones[1].force[1] > 1);
  Mapping zones;
  zones.zone = {2, 1};
  check_same(r, with_zones_in_order(m, {2, 1}), zones);
  check_same(r, with_bodies_in_order(m, {2, 1}));
  check_same(r, with_swapped_sides(m, 2));
}

// ---- bodies that others hold

namespace {

// A, free along x, is pushed against B, which is held along x and free along y: friction holds it up.
Model leaning(double load, double mu, bool b_first) {
  Model m;
  m.add(rectangle(0, 0, 1, 1, {4, 4, 4, 4}, 100));
  m.add(polygon({{1, 0, 3}, {2, 0, 4}, {2, 1, 5}, {1, 1, 4}}, 200));
  m.set(1, 1, [](double x, double) { return end_of(x < 0.8 ? "0110" : kPulled); }); // its last element is free, as B is
  m.set(1, 4, end_of(kPulled, 1));
  m.set(2, 2, end_of("1001"));
  m.set(2, 3, end_of(kPulled, 0, -load));
  m.join(C2D_ZONE_MATCHING, 1, 2, 2, 4);
  m.friction = mu;
  m.paths = {{2, 1.0}};
  return b_first ? with_bodies_in_order(m, {2, 1}) : m;
}

} // namespace

TEST_CASE("bodies: two that lean on each other") {
  for (const bool b_first : {false, true}) {
    CAPTURE(b_first);
    const Model m = leaning(0.3, 0.5, b_first);
    const Result r = solved(m);
    CHECK(breach(m, r) == "");
    CHECK(imbalance(m, r) < 1e-12);
    CHECK(std::fabs(std::fabs(r.zones[0].force[0]) - 1) < 1e-12);
    CHECK(std::fabs(std::fabs(r.zones[0].force[1]) - 0.3) < 1e-12);
  }
}

namespace {

void check_sliding_down(double mu) {
  for (const bool b_first : {false, true}) {
    CAPTURE(b_first);
    const Result r = solve(leaning(0.6, mu, b_first));
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    CHECK(r.outcome == (mu > 0 ? C2D_GROSS_SLIDING : C2D_FREE_MOTION));
    CHECK(r.summary.outcome_body == (b_first ? 1 : 2));
    CHECK(std::fabs(r.summary.free_motion[0]) < 1e-9);
    CHECK(r.summary.free_motion[1] < 0);
    CHECK(std::fabs(r.summary.free_motion[2]) < 1e-9);
  }
}

} // namespace

TEST_CASE("bodies: more load than friction: the one that slides is named, and where to") { check_sliding_down(0.5); }

TEST_CASE("bodies: without friction the one that nothing holds is named") { check_sliding_down(0); }

TEST_CASE("bodies: one held by friction alone, between two jaws") {
  const auto jaws = [](double weight, int32_t kind) {
    Model m;
    m.add(rectangle(-1, 0, 0, 2, {2, 6, 2, 4}));
    m.add(rectangle(0, 0, 1, 2, {3, kind == C2D_ZONE_FREE ? 5 : 6, 3, kind == C2D_ZONE_FREE ? 7 : 6}, 500));
    m.add(rectangle(1, 0, 2, 2, {2, 4, 2, 6}));
    m.set(1, 4, end_of(kHeld));
    m.set(3, 2, end_of(kHeld, 0, 0, -0.002, 0));
    m.join(kind, 1, 2, 2, 4);
    m.join(kind, 2, 2, 3, 4);
    m.body(2).force[1] = -weight;
    m.friction = 0.3;
    m.paths = {{3, 1.0}};
    return m;
  };
  for (const int32_t kind : kKinds) {
    CAPTURE(kind);
    const Model m = jaws(0.05, kind);
    const Result r = solved(m);
    CHECK(breach(m, r) == "");
    CHECK(imbalance(m, r) < 1e-12);
    CHECK(std::fabs(r.bodies[1].contact[1] - 0.1) < 1e-12); // weight per area, area 2
    check_same(r, with_bodies_in_order(m, {2, 3, 1}));
    const Result fell = solve(jaws(5, kind));
    CHECK(fell.outcome == C2D_GROSS_SLIDING);
    CHECK(fell.summary.outcome_body == 2);
    CHECK(fell.summary.free_motion[1] < 0);
  }
}

// ---- a chain

namespace {

const int kLinks = 20;

// Flat blocks in a row, held at the left, pressed together by load case 1, pushed up (and pulled) at the right by case 2.
Model chain(double sideways, double along) {
  Model m;
  for (int i = 0; i < kLinks; ++i) {
    const double E = 1000 + 100 * (i % 3), nu = 0.2 + 0.05 * (i % 4);
    m.add(rectangle(0.2 * i, 0, 0.2 * (i + 1), 1, {1, 6, 1, 6}, E, nu));
  }
  m.set(1, 4, end_of(kHeld));
  m.set(kLinks, 2, end_of(kPulled, -1, 0));
  m.set_second(kLinks, 2, end_of(kPulled, along, sideways));
  for (int i = 1; i < kLinks; ++i) m.join(C2D_ZONE_MATCHING, i, 2, i + 1, 4);
  m.friction = 0.1;
  m.paths = {{1, 1.0, 0.0}, {4, 1.0, 1.0}, {2, 1.0, 0.2}};
  return m;
}

} // namespace

TEST_CASE("bodies: a chain of 20 blocks, pushed sideways and pulled, is in balance body by body") {
  for (const bool pulled : {false, true}) {
    CAPTURE(pulled);
    const Model m = pulled ? chain(0.04, 0.3) : chain(0.08, 0);
    const Result r = solved(m);
    CHECK(breach(m, r) == "");
    CHECK(imbalance(m, r) < 1e-12);
    int seen[3] = {0, 0, 0};
    for (const Step& s : r.steps)
      for (const Row& row : s.rows) ++seen[static_cast<int>(row[C2D_STATUS])];
    if (!pulled) CHECK(seen[C2D_SLIP] > 0);
    CHECK(seen[C2D_OPEN] > 0);
    CHECK(r.summary.max_residual < 1e-10);
    // Every joint carries what stands to its right.
    for (const c2d_zone_state& z : r.zones) {
      CHECK(std::fabs(z.force[0] - (pulled ? 1 - 0.3 * 0.2 : 1)) < 1e-12);
      CHECK(std::fabs(z.force[1] + (pulled ? 0.04 : 0.08) * 0.2) < 1e-12);
    }
  }
}

TEST_CASE("bodies: a chain of 20 blocks, events in any order of bodies and as by small steps") {
  const Model m = chain(0.08, 0);
  const Result r = solved(m);
  std::vector<int32_t> order, zones;
  for (int32_t i = 0; i < kLinks; ++i) order.push_back((i * 7 + 3) % kLinks + 1);
  for (int32_t i = 0; i < kLinks - 1; ++i) zones.push_back((i * 5 + 2) % (kLinks - 1) + 1);
  Mapping map;
  map.zone.resize(kLinks - 1);
  for (int32_t i = 0; i < kLinks - 1; ++i) map.zone[static_cast<size_t>(zones[static_cast<size_t>(i)] - 1)] = i + 1;
  check_same(r, with_zones_in_order(with_bodies_in_order(m, order), zones), map);
  // Small steps of the stepping of 1987 come nearer as they become smaller.
  double before = 1;
  for (const int32_t times : {10, 40, 160}) {
    Model steps = m;
    for (Path& p : steps.paths) p.increments *= times;
    Result by_steps = solve(steps, C2D_STEPPING_DECK), by_events = r;
    REQUIRE_MESSAGE(by_steps.status == C2D_OK, by_steps.messages());
    REQUIRE(by_steps.outcome == C2D_REACHED);
    for (Result* one : {&by_steps, &by_events}) {
      one->steps.erase(one->steps.begin(), one->steps.end() - 1);
      one->steps[0].work = one->steps[0].elastic = one->steps[0].dissipated = 0;
    }
    const double now = difference(by_events, by_steps);
    CHECK(now < before / 2.5);
    before = now;
    if (times == 160) CHECK(status_differences(by_events, by_steps) == 0);
  }
  CHECK(before < 5e-4);
}
