// Bodies that float until first touch come to rest before anything is loaded: against the same model drawn in touch, against
// statics, and told otherwise.
#include "many_bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace many;

namespace {

const int32_t kKinds[] = {C2D_ZONE_MATCHING, C2D_ZONE_FREE};

Result solved(const Model& m) {
  const Result r = solve(m);
  REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
  REQUIRE_MESSAGE(r.outcome == C2D_REACHED, c2d_outcome_message(r.outcome) << "\n" << r.messages());
  CHECK(breach(m, r) == "");
  CHECK(imbalance(m, r) < 1e-11);
  return r;
}

// Largest difference of tractions, relative to the largest one, and of the displacements of a body less (ux, uy).
double off_pressures(const Result& a, const Result& b) {
  double most = 0, off = 0;
  REQUIRE(a.steps.size() == b.steps.size());
  for (size_t k = 0; k < a.steps.size(); ++k) {
    REQUIRE(a.steps[k].rows.size() == b.steps[k].rows.size());
    for (size_t i = 0; i < a.steps[k].rows.size(); ++i)
      for (const int32_t field : {C2D_TN, C2D_TT}) {
        const size_t f = static_cast<size_t>(field);
        most = std::max(most, std::fabs(a.steps[k].rows[i][f]));
        off = std::max(off, std::fabs(a.steps[k].rows[i][f] - b.steps[k].rows[i][f]));
      }
  }
  return off / most;
}
double off_displacements(const Result& touching, const Result& seated, int32_t body, double ux, double uy) {
  double off = 0;
  const std::vector<EndResult>&a = touching.boundary[static_cast<size_t>(body - 1)],
        &b = seated.boundary[static_cast<size_t>(body - 1)];
  for (size_t i = 0; i < a.size(); ++i)
    off = std::max({off, std::fabs(b[i].ux - a[i].ux - ux), std::fabs(b[i].uy - a[i].uy - uy)});
  return off;
}

// ---- loose plates on a table

// Plates of width 3 one above the other, the first held below, the others loose, with gaps below them. The top is pressed more
// on one side and pushed along x.
Model plates(int32_t kind, double gap2, double gap3) {
  const std::array<int32_t, 4> same[3] = {{6, 3, 6, 3}, {6, 2, 6, 2}, {6, 4, 6, 4}},
                               unlike[3] = {{5, 3, 7, 3}, {6, 2, 9, 2}, {8, 4, 5, 4}};
  const double at[3] = {0, 1 + gap2, 2 + gap2 + gap3}, moduli[3] = {100, 60, 300};
  Model m;
  for (int i = 0; i < 3; ++i)
    m.add(rectangle(0, at[i], 3, at[i] + 1, kind == C2D_ZONE_MATCHING ? same[i] : unlike[i], moduli[i]));
  m.set(1, 1, end_of(kHeld));
  m.set(3, 3, [](double x, double) { return end_of(kPulled, 0.1, -1 - 0.2 * x); });
  for (int i = 1; i <= 2; ++i) m.join(kind, i, 3, i + 1, 1);
  m.friction = 0.4;
  m.paths = {{2, 1.0}};
  return m;
}

} // namespace

TEST_CASE("seating: loose plates that hover, each with three motions, are the plates that lie on each other") {
  for (const int32_t kind : kKinds)
    for (const double gap2 : {0.0, 0.01, 0.25})
      for (const double gap3 : {0.0, 0.02}) {
        CAPTURE(kind);
        CAPTURE(gap2);
        CAPTURE(gap3);
        const Result touching = solved(plates(kind, 0, 0)), seated = solved(plates(kind, gap2, gap3));
        CHECK(off_pressures(touching, seated) < 1e-10);
        CHECK(off_displacements(touching, seated, 1, 0, 0) < 1e-10);
        CHECK(off_displacements(touching, seated, 2, 0, -gap2) < 1e-10);
        // As it falls the third is pushed along as well.
        const double along = seated.boundary[2][0].ux - touching.boundary[2][0].ux;
        CHECK((gap2 + gap3 > 0 ? along > 0 : along == 0));
        CHECK(off_displacements(touching, seated, 3, along, -gap2 - gap3) < 1e-10);
      }
}

TEST_CASE("seating: order of bodies and of zones, sides, mirror, turn and units do not matter") {
  const Model m = plates(C2D_ZONE_MATCHING, 0.01, 0.02);
  const Result r = solved(m);
  for (const std::vector<int32_t>& order : {std::vector<int32_t>{3, 1, 2}, std::vector<int32_t>{2, 3, 1}})
    CHECK(difference(r, solved(with_bodies_in_order(m, order))) < 1e-10);
  Mapping zones;
  zones.zone = {2, 1};
  CHECK(difference(r, solved(with_zones_in_order(m, {2, 1})), zones) < 1e-10);
  Mapping mirror;
  mirror.place = [](double& x, double&) { x = -x; };
  mirror.tangential = -1;
  CHECK(difference(r, solved(reflected(m)), mirror) < 1e-10);
  Mapping units;
  units.length = 25.4, units.stress = 6.894757;
  units.place = [](double& x, double& y) { x *= 25.4, y *= 25.4; };
  CHECK(difference(r, solved(scaled(m, 25.4, 6.894757)), units) < 1e-10);
}

namespace {

// ---- a block that falls into a corner, and one that tips

// Body 1 is an L of floor and wall; body 2 a block above the one and beside the other.
Model corner(double right, double up, double mu) {
  Model m;
  m.add(polygon({{-1, -1, 3}, {3, -1, 3}, {3, 0, 1}, {2, 0, 5}, {0, 0, 4}, {0, 2, 1}, {0, 3, 2}, {-1, 3, 4}}, 200));
  m.set(1, 1, end_of(kHeld));
  m.add(rectangle(right, up, 2 + right, 2 + up, {5, 4, 4, 4}, 100));
  m.set(2, 3, end_of(kPulled, -0.1, -1));
  m.set(2, 2, end_of(kPulled, -0.3, 0));
  m.join(C2D_ZONE_MATCHING, 1, 4, 2, 1);
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, 14, 16}, {2, 16, 14}}}); // without the node in the corner
  m.friction = mu;
  return m;
}

} // namespace

TEST_CASE("seating: a block slides into a corner") {
  for (const double mu : {0.1, 0.3})
    for (const double right : {0.0, 0.02})
      for (const double up : {0.0, 0.01, 0.1}) {
        CAPTURE(mu);
        CAPTURE(right);
        CAPTURE(up);
        const Result touching = solved(corner(0, 0, mu)), seated = solved(corner(right, up, mu));
        CHECK(off_pressures(touching, seated) < 1e-10);
        CHECK(off_displacements(touching, seated, 2, -right, -up) < 1e-10);
      }
}

TEST_CASE("seating: enough friction holds a block where it falls, short of the wall") {
  // Tractions on it: fx = -0.1 * 2 - 0.3 * 2 = -0.8, fy = -2.
  for (const double up : {0.0, 0.01}) {
    Model m = corner(0.02, up, 0.5);
    m.paths = {{1, 0.01}};
    const Result r = solved(m);
    CHECK(r.zones[1].stick + r.zones[1].slip == 0);
    CHECK(std::fabs(std::fabs(r.zones[0].force[0]) - 0.008) < 1e-12);
  }
}

namespace {

// ---- a roller between platens

test::Callable<void(double, double&, double&)> circle(double radius, double x0, double y0, double turn) {
  return [=](double s, double& x, double& y) {
    const double angle = 2 * M_PI * s + turn;
    x = x0 + radius * std::cos(angle);
    y = y0 + radius * std::sin(angle);
  };
}

// Quarters of the circle begin at -45 degrees: sides 1 to 4 are elements n/4 each.
Model roller(double below, double above, bool rigid) {
  const int32_t n = 32;
  Model m;
  m.add(rectangle(-1, -1, 1, 0, {6, 3, 8, 3}, 500));
  m.set(1, 1, end_of(kHeld));
  Body disc;
  disc.youngs_modulus = 300;
  add_curve(disc, n, circle(1, 0, 1 + below, -0.75 * M_PI));
  m.add(disc);
  if (rigid) {
    Body top = rectangle(-1, 2 + below + above, 1, 3 + below + above, {8, 3, 6, 3});
    top.rigid = 1;
    top.is_free[1] = 1;
    top.load[1] = -2;
    m.add(top);
  } else {
    m.add(rectangle(-1, 2 + below + above, 1, 3 + below + above, {8, 3, 6, 3}, 500));
    m.set(3, 3, end_of(kPulled, 0, -1));
    for (int side = 2; side <= 4; side += 2) m.set(3, side, end_of("1001")); // guided
  }
  m.zones.push_back({C2D_ZONE_FREE, {{1, 10, 17}, {2, 8, 1}}});
  m.zones.push_back({C2D_ZONE_FREE, {{3, 1, 8}, {2, 24, 17}}});
  m.friction = 0.2;
  m.paths = {{2, 1.0}};
  return m;
}

} // namespace

TEST_CASE("seating: a roller with clearance to both platens") {
  for (const bool rigid : {false, true})
    for (const double below : {0.0, 0.01})
      for (const double above : {0.0, 0.03}) {
        CAPTURE(rigid);
        CAPTURE(below);
        CAPTURE(above);
        const Result touching = solved(roller(0, 0, rigid)), seated = solved(roller(below, above, rigid));
        CHECK(off_pressures(touching, seated) < 1e-10);
        CHECK(off_displacements(touching, seated, 2, 0, -below) < 1e-10);
      }
}

namespace {

// ---- a pin in a hole with clearance

// A plate with a hole of radius 1, held at its edges, and a pin in it, which a body force pulls along (fx, fy). A node of both
// is where it comes to lie, or (half) the middle between two.
Model pin(double clearance, double fx, double fy, double mu, bool half) {
  const int32_t n = 48;
  const double turn = half ? M_PI / n : 0;
  Model m;
  Body plate = rectangle(-3, -3, 3, 3, {6, 6, 6, 6}, 500);
  const auto hole = circle(1, 0, 0, turn);
  add_curve(plate, n, [&](double s, double& x, double& y) { hole(1 - s, x, y); });
  m.add(plate);
  for (int side = 1; side <= 4; ++side) m.set(1, side, end_of(kHeld));
  Body disc;
  disc.youngs_modulus = 300;
  add_curve(disc, n, circle(1 - clearance, 0, 0, turn));
  m.add(disc);
  m.body(2).force[0] = fx;
  m.body(2).force[1] = fy;
  m.zones.push_back({C2D_ZONE_MATCHING, {{1, 25, 24 + n}, {2, n, 1}}});
  m.friction = mu;
  m.paths = {{3, 1.0}};
  return m;
}

} // namespace

TEST_CASE("seating: a pin falls in its hole") {
  for (const double mu : {0.0, 0.3})
    for (const bool half : {false, true}) {
      CAPTURE(mu);
      CAPTURE(half);
      const Result r = solved(pin(0.01, 0, -0.5, mu, half));
      const double weight = 0.5 * M_PI * 0.99 * 0.99;
      CHECK(r.zones[0].force[1] == doctest::Approx(weight).epsilon(1e-2));
      CHECK(std::fabs(r.zones[0].force[0]) < 1e-9 * weight);
    }
}

TEST_CASE("seating: a pin that is pulled anywhere, told otherwise") {
  for (const double mu : {0.0, 0.3})
    for (const double angle : {0.0, 7.5, 9.0, 30.0, 131.0}) {
      CAPTURE(mu);
      CAPTURE(angle);
      const double weight = 0.5 * M_PI * 0.98 * 0.98, x = std::sin(angle * M_PI / 180), y = -std::cos(angle * M_PI / 180);
      const Model m = pin(0.02, 0.5 * x, 0.5 * y, mu, false);
      const Result r = solved(m);
      CHECK(r.zones[0].force[0] == doctest::Approx(-weight * x).epsilon(1e-2).scale(weight));
      CHECK(r.zones[0].force[1] == doctest::Approx(-weight * y).epsilon(1e-2).scale(weight));
      CHECK(difference(r, solved(with_bodies_in_order(m, {2, 1}))) < 1e-9);
      Mapping mirror;
      mirror.place = [](double& at_x, double&) { at_x = -at_x; };
      mirror.tangential = -1;
      CHECK(difference(r, solved(reflected(m)), mirror) < 1e-9);
      Mapping units;
      units.length = 25.4, units.stress = 6.894757;
      units.place = [](double& at_x, double& at_y) { at_x *= 25.4, at_y *= 25.4; };
      CHECK(difference(r, solved(scaled(m, 25.4, 6.894757)), units) < 1e-9);
    }
}

namespace {

// The same with a bore in the pin, at which load case 1 pulls down and load case 2 along.
Model pulled_pin(double mu, const std::vector<Path>& paths) {
  Model m = pin(0.02, 0, 0, mu, false);
  Body& disc = m.body(2);
  add_curve(disc, 16, [](double s, double& x, double& y) { circle(0.3, 0, 0, 0)(1 - s, x, y); });
  disc.ends.resize(static_cast<size_t>(2 * disc.elements()));
  m.cases = 2;
  m.set(2, 2, end_of(kPulled, 0, -1));
  for (Body& body : m.bodies) body.second.resize(body.ends.size());
  m.body(1).second = m.body(1).ends;
  m.set_second(2, 2, end_of(kPulled, 1, 0));
  m.paths = paths;
  return m;
}

} // namespace

TEST_CASE("seating: a pin at rest on one pair is held as soon as more of them touch, and flies if it is pushed before") {
  const Result held = solved(pulled_pin(0.3, {{1, 1, 0}, {1, 1, 0.2}}));
  CHECK(std::fabs(held.zones[0].force[0] / held.zones[0].force[1]) == doctest::Approx(0.2).epsilon(1e-9));
  const Result pushed = solve(pulled_pin(0.3, {{1, 0.01, 0}, {1, 0.01, 0.2}}));
  CHECK(pushed.outcome == C2D_FREE_MOTION);
  CHECK(pushed.summary.outcome_body == 2);
  CHECK(pushed.steps.size() >= 1);
  const Result lies = solved(pulled_pin(0.3, {{1, 0.01, 0}})); // on one pair, and could roll
  CHECK(lies.told_of("position of body 2 in 1 motion that the contact leaves free"));
  CHECK(!held.told_of("leaves free"));
  const Result at_once = solved(pulled_pin(0.3, {{1, 1, 0.2}}));
  CHECK(std::fabs(at_once.zones[0].force[0] / at_once.zones[0].force[1]) == doctest::Approx(0.2).epsilon(1e-9));
}

namespace {

// ---- a plate that comes down askew, a body that nothing moves, bodies that nothing stops

Model askew(double turn, double height) {
  Model m;
  m.add(rectangle(0, -1, 3, 0, {6, 3, 6, 3}, 200));
  m.set(1, 1, end_of(kHeld));
  const double rise = 3 * turn;
  m.add(polygon({{0, height, 6}, {3, height + rise, 4}, {3, height + rise + 1, 6}, {0, height + 1, 4}}, 100));
  m.set(2, 3, [](double x, double) { return end_of(kPulled, 0, -0.1 - 0.05 * x); });
  m.join(C2D_ZONE_MATCHING, 1, 3, 2, 1);
  m.friction = 0.5;
  return m;
}

} // namespace

TEST_CASE("seating: a plate that comes down askew, or stands on its edge, tips until it lies") {
  const Result lying = solved(askew(0, 0));
  for (const double turn : {1e-6, -1e-6})
    for (const double height : {0.0, 0.01}) {
      CAPTURE(turn);
      CAPTURE(height);
      const Result r = solved(askew(turn, height + (turn < 0 ? -3 * turn : 0)));
      CHECK(off_pressures(lying, r) < 1e-4);
      CHECK(r.zones[0].open == 0);
    }
}

namespace {

// A plate above two loose blocks, unlike gaps below them, pressed down and pushed along x by so much of that.
Model plate_on_blocks(double push, double mu) {
  Model m;
  m.add(polygon({{-3, 0, 12}, {3, 0, 2}, {3, 1, 6}, {0, 1, 6}, {-3, 1, 2}}, 100));
  m.set(1, 1, end_of(kHeld));
  m.add(rectangle(-2.5, 1.05, -0.5, 2, {6, 3, 6, 3}, 100));
  m.add(rectangle(0.3, 1.02, 2.6, 2, {7, 3, 7, 3}, 100));
  m.add(polygon({{-2.7, 2.1, 10}, {0, 2.1, 10}, {2.8, 2.1, 3}, {2.8, 3, 10}, {-2.7, 3, 3}}, 100));
  m.set(4, 4, end_of(kPulled, 0.8 * push, -0.8));
  m.join(C2D_ZONE_FREE, 1, 4, 2, 1);
  m.join(C2D_ZONE_FREE, 1, 3, 3, 1);
  m.join(C2D_ZONE_FREE, 4, 1, 2, 3);
  m.join(C2D_ZONE_FREE, 4, 2, 3, 3);
  m.friction = mu;
  m.paths = {{2, 1.0}};
  return m;
}

} // namespace

TEST_CASE("seating: blocks that stand on their edges below a plate roll over under a push that friction can carry") {
  Mapping mirror;
  mirror.place = [](double& x, double&) { x = -x; };
  mirror.tangential = -1;
  for (const double push : {0.001, 0.01, 0.1, -0.1}) { // without friction nothing but the blocks' edges is in the way
    CAPTURE(push);
    const Model m = plate_on_blocks(push, 0.3);
    CHECK(difference(solved(m), solved(reflected(m)), mirror) < 1e-10);
  }
  for (const double push : {0.35, -0.35}) CHECK(solve(plate_on_blocks(push, 0.3)).outcome == C2D_FREE_MOTION);
  CHECK(solve(plate_on_blocks(0.001, 0)).outcome == C2D_FREE_MOTION);
}

TEST_CASE("seating: a loose body that no load moves stays where it is while another is pressed") {
  const auto two = [](bool idle) {
    Model m;
    m.add(rectangle(0, -1, 5, 0, {10, 3, 10, 3}, 200));
    m.set(1, 1, end_of(kHeld));
    m.add(rectangle(0, 0.01, 2, 1, {4, 3, 5, 3}, 100));
    m.set(2, 3, end_of(kPulled, 0.1, -1));
    m.zones.push_back({C2D_ZONE_MATCHING, {{1, 23, 20}, {2, 1, 4}}});
    if (idle) {
      m.add(rectangle(3, 0.3, 5, 1, {4, 3, 5, 3}, 100));
      m.zones.push_back({C2D_ZONE_MATCHING, {{1, 17, 14}, {3, 1, 4}}});
    }
    m.friction = 0.4;
    return m;
  };
  const Result alone = solved(two(false)), both = solved(two(true));
  for (const int32_t field : {C2D_TN, C2D_TT, C2D_GAP})
    for (size_t i = 0; i < alone.last().rows.size(); ++i)
      CHECK(std::fabs(alone.last().rows[i][static_cast<size_t>(field)] - both.last().rows[i][static_cast<size_t>(field)]) <
            1e-10);
  CHECK(both.zones[1].open == 5);
  CHECK(both.zones[1].force[1] == 0);
}

TEST_CASE("seating: what nothing stops is an outcome that names it") {
  Model m = plates(C2D_ZONE_MATCHING, 0.01, 0.02);
  m.friction = 0;
  const Result along = solve(m); // the third slides off
  REQUIRE_MESSAGE(along.status == C2D_OK, along.messages());
  CHECK(along.outcome == C2D_FREE_MOTION);
  CHECK(along.summary.outcome_body == 3);
  m = plates(C2D_ZONE_MATCHING, 0.01, 0.02);
  m.set(3, 3, end_of(kPulled, 0, 1));
  const Result up = solve(m);
  CHECK(up.outcome == C2D_FREE_MOTION);
  CHECK(up.summary.outcome_body == 3);
  CHECK(up.summary.free_motion[1] > 0.9);
}

TEST_CASE("seating: loose plates under one that is moved down lie on each other when it presses") {
  const auto driven = [](double gap2, double gap3, double gap4) {
    const double at[4] = {0, 1 + gap2, 2 + gap2 + gap3, 3 + gap2 + gap3 + gap4};
    Model m;
    for (const double y : at) m.add(rectangle(0, y, 3, y + 1, {6, 3, 6, 3}));
    m.set(1, 1, end_of(kHeld));
    m.set(4, 3, end_of(kHeld, 0, 0, 0, -0.1 - gap2 - gap3 - gap4));
    for (int i = 1; i <= 3; ++i) m.join(C2D_ZONE_MATCHING, i, 3, i + 1, 1);
    m.friction = 0.4;
    return m;
  };
  const Result touching = solved(driven(0, 0, 0)), apart = solved(driven(0.01, 0.02, 0.03));
  CHECK(off_pressures(touching, apart) < 1e-9);
}
