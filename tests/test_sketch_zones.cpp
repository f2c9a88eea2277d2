// Which elements of a sketch may touch: sides in several interfaces, sides that go round, ties, press fits.
#include "program/sketch/deck/zones.hpp"
#include "program/sketch/refine.hpp"
#include "sketch_runs.hpp"

#include <doctest/doctest.h>

using namespace sketch_test;

namespace {

template <class Drawn> Solution solved(const Drawn& drawn, const Setup& setup = Setup()) {
  const Solution out = solve(drawn, setup);
  REQUIRE_MESSAGE(out.error.empty(), out.error);
  return out;
}

std::vector<sketch::Zone> zones(const sketch::Reading& drawn, const sketch::Mesh& mesh) {
  return sketch::zones_of(drawn.sketch, mesh);
}

// Two circles on a block, which begin at their lowest points, where they touch it.
const char kTwo[] = "body block E 1000 nu 0.3\nfrom -12 -10\nline bottom to 12 -10\nline right to 12 0\nline top to -12 0\n"
                    "line left close\nbody a E 1000 nu 0.3\ncircle out centre -4 2 radius 2\ncopy b of a shift 8 0\n"
                    "contact block.top a.out\ncontact block.top b.out\nfix block.bottom\nweight a y -1\nweight b y -1\n";

} // namespace

TEST_CASE("sketch zones: a side under two bodies, sides that go on where their outline begins") {
  const sketch::Reading drawn = read_text(kTwo);
  const sketch::Mesh mesh = sketch::first_mesh(drawn.sketch, 2);
  const std::vector<sketch::Zone> found = zones(drawn, mesh);
  REQUIRE(found.size() == 2);      // one for each circle, though what faces the block is its last and its first elements
  for (size_t k = 0; k < 2; ++k) { // numbered in a row: the outline is run through from where the contact ends
    CHECK(found[k].two.first < found[k].two.last);
    CHECK(found[k].contact->side[1].from < 0); // but what faces goes round the circle's begin
  }
  CHECK(found[0].one.first > found[1].one.last); // the top runs to the left
  const Solution s = solved(drawn);
  for (size_t k = 0; k < 2; ++k) CHECK(std::fabs(s.zones[k].force[1] / (4 * std::acos(-1.0)) - 1) < 2e-3); // their weight
  CHECK(std::fabs(at_peak(s.zone(1)).tn / at_peak(s.zone(2)).tn - 1) < 0.02);
}

TEST_CASE("sketch zones: neighbours meet, whichever interface is told first") {
  const std::string ring = "body wall rigid\nfrom -6 -2\nline to 5 -2\nline to 5 6\nline to 2.5 6\nline side to 2.5 0\n"
                           "line floor to -6 0\nline close\nbody ring E 1 nu 0.3\ncircle out centre 0 2.5 radius 2.5\n";
  const std::string contacts[] = {"contact wall.floor ring.out\n", "contact wall.side ring.out\n"};
  for (const size_t first : {size_t{0}, size_t{1}}) {
    const sketch::Reading drawn = read_text(ring + contacts[first] + contacts[1 - first]);
    const sketch::Mesh mesh = sketch::first_mesh(drawn.sketch, 2);
    const std::vector<sketch::Zone> found = zones(drawn, mesh);
    const int all = static_cast<int>(mesh.bodies[1][0].elements());
    REQUIRE(found.size() == 2);
    const sketch::Stretch &floor = found[first].two, &side = found[1 - first].two;
    CHECK(floor.last % all + 1 == side.first); // the circle is one side of both, each element belongs to what is nearer
  }
}

// Sides that coincide are matching zones, of which the tie has the node at the tip; else the free zones give it up when the
// deck is read.
TEST_CASE("sketch zones: a tie goes on to the tip of a crack") {
  for (const bool tie_first : {true, false})
    for (const bool coincide : {true, false}) {
      CAPTURE(coincide);
      std::string text = test::read_file(paths::root() + "/examples/crack.c2s");
      const size_t tie = text.find("\ntie "), behind = text.find('\n', tie + 1);
      const std::string statement = text.substr(tie, behind - tie);
      text.erase(tie, behind - tie).insert(text.find("\ncontact ") + (tie_first ? 0 : 1), tie_first ? statement : "");
      if (!tie_first) text += statement.substr(1) + "\n";
      const sketch::Reading drawn = read_text(text);
      REQUIRE(drawn.faults.empty());
      sketch::Mesh mesh = sketch::first_mesh(drawn.sketch, 2);
      int crack = 0, ahead = 0, tied = 0, faces = 0, left = 0;
      for (sketch::MeshedCurve& curve : mesh.bodies[0][0].curves) {
        if (curve.curve->name == "crack") crack += static_cast<int>(curve.elements());
        if (curve.curve->name == "ahead") ahead += static_cast<int>(curve.elements());
        if (curve.curve->name == "crack" && !coincide) curve.ends[40] += 0.3 * (curve.ends[41] - curve.ends[40]);
      }
      for (const sketch::Zone& zone : zones(drawn, mesh)) {
        const bool is_tied = drawn.sketch.interfaces[zone.contact->interface].tied;
        (is_tied ? tied : faces) += zone.two.count;
        CHECK(zone.matching == coincide);
        for (const bool leaves : zone.leaves) left += leaves ? 1 : 0;
        if (is_tied) CHECK((!zone.leaves[0] && !zone.leaves[1]));
      }
      CHECK(tied == ahead);
      CHECK(faces == crack);
      CHECK(left == (coincide ? 2 : 0));
      const Solution s = families_test::solve_deck(sketch::deck_of(drawn.sketch, mesh));
      REQUIRE_MESSAGE(s.error.empty(), s.error);
      double largest = 0; // at the open tip, in an infinite plate
      for (const app::StressIntensity& tip : s.cracks) largest = std::max(largest, tip.K1);
      CHECK(s.cracks.size() == 2);
      CHECK(std::fabs(largest / (200.0 / 3 * std::sqrt(std::acos(-1.0) * 10 / 3)) - 1) < 0.01);
    }
}

// A foot ends at a wall that holds it in one direction, stands on two floors, or in a corner: its pressure is uniform all
// along.
TEST_CASE("sketch zones: pressure goes on up to a support, to the next floor, and into a corner") {
  const auto floor = [](const char* name, const char* from, const char* to) {
    return std::string("body ") + name + " rigid\nfrom " + from + " -1\nline s to " + to + " -1\nline e to " + to +
           " 0\nline top to " + from + " 0\nline w close\n";
  };
  const std::string wall = "body w rigid\nfrom -1 0\nline s to 0 0\nline face to 0 2\nline n to -1 2\nline w close\n";
  const std::string block = "body b E 1000 nu 0.3\nfrom 0 0\nline f to 1 0\nline g to 2 0\nline r to 2 1\nline top to 0 1\n"
                            "line l close\ntraction b.top y -1\n";
  for (const char* order : {"linear", "quadratic"})
    for (const std::string& text : {floor("one", "-1", "3") + block + "contact one.top b.f+g mu 0\nfix b.l x\n",
                                    floor("one", "0", "1") + floor("two", "1", "2") + block +
                                        "contact one.top b.f mu 0\ncontact two.top b.g mu 0\nfix b.r.end x\n",
                                    floor("one", "-1", "3") + wall + block +
                                        "contact one.top b.f+g mu 0\ncontact w.face b.l mu 0\ntraction b.r x -0.5\n"}) {
      CAPTURE(order);
      CAPTURE(text);
      const sketch::Reading drawn = read_text(text + "functions " + order + "\n");
      REQUIRE(drawn.faults.empty());
      const Solution s = families_test::solve_deck(sketch::deck_of(drawn.sketch, sketch::first_mesh(drawn.sketch, 2)));
      REQUIRE_MESSAGE(s.error.empty(), s.error);
      CHECK(s.last().size() > 8);
      const bool in_corner = text.find("w.face") != std::string::npos;
      for (const auto& row : s.last()) CHECK(row.tn == doctest::Approx(in_corner && row.zone == 2 ? 0.5 : 1).epsilon(1e-9));
    }
}

TEST_CASE("sketch zones: a press fit and a load behind it") {
  const std::string fit = test::read_file(paths::root() + "/examples/press_fit.c2s"), load = "pressure hub.rim 20\n";
  const auto pressure = [](const std::string& text, double overlap) {
    const Solution s = solved(read_text(text, {{"fit", overlap}}), {1});
    return s.last()[s.last().size() / 2].tn;
  };
  const double both = pressure(fit + load, 0.0025), alone = pressure(fit, 0.0025), pressed = pressure(fit + load, 1e-7);
  CHECK(pressed > 5);
  CHECK(std::fabs(both / (alone + pressed) - 1) < 1e-3); // one contact all the time: superposition
  const std::string deck = sketch::deck_of(read_text(fit + load).sketch, sketch::first_mesh(read_text(fit).sketch, 1));
  CHECK(deck.find("*INTERFERENCE 2\n*PATH\n10 1 1\n") != std::string::npos);

  // Told twice, and not at all.
  const sketch::Reading twice = sketch::read_sketch(fit + "interference\n", {}, nullptr);
  REQUIRE(twice.faults.size() == 1);
  CHECK(twice.faults[0].text == "the statement 'interference' is given twice, expected once");
  const sketch::Reading none = read_text(fit.substr(0, fit.find("interference\n")) + load);
  REQUIRE(none.faults.size() == 1);
  CHECK(none.faults[0].text.find("overlap") != std::string::npos);
}

// A pad with an arch between its feet, drawn as one side: an element of the floor is in one zone.
TEST_CASE("sketch zones: two feet of a side share the floor they stand on") {
  const sketch::Reading drawn = read_text(
      "body floor E 1000 nu 0.3\nfrom -6 -5\nline bottom to 6 -5\nline right to 6 0\nline top to -6 0\nline left close\n"
      "body pad E 1000 nu 0.3\nfrom -2 3\nline side to -2 0\nfillet face radius 0.2\nline face to -1 0\nfillet face radius "
      "0.2\n"
      "line arch to -1 1\nline arch to 1 1\nline arch to 1 0\nfillet face radius 0.2\nline face to 2 0\nfillet face radius "
      "0.2\n"
      "line side to 2 3\nline top close\ncontact floor.top pad.face\nfix floor.bottom\n"
      "platen pad.top about 0 3 x 0 fy -4 turn 0\n");
  for (const double fineness : {0.25, 1.0, 2.0}) {
    const std::vector<sketch::Zone> found = zones(drawn, sketch::first_mesh(drawn.sketch, fineness));
    REQUIRE(found.size() == 2);
    const bool apart = found[0].one.last < found[1].one.first || found[1].one.last < found[0].one.first;
    CHECK(apart);
  }
  const Solution s = solved(drawn);
  for (size_t k = 0; k < 2; ++k) CHECK(std::fabs(s.zones[k].force[1]) == doctest::Approx(2).epsilon(1e-3)); // half each
}

// On the coarsest mesh an element is an eighth of a circle: the chord of one of them still faces the floor, its far end does
// not.
TEST_CASE("sketch zones: an element of a fillet faces the floor with both ends") {
  const sketch::Reading drawn = read_text(
      "body floor E 1000 nu 0.3\nfrom -6 -5\nline bottom to 6 -5\nline right to 6 0\nline top to -6 0\nline left close\n"
      "body pad E 1000 nu 0.3\nfrom -1 3\nline side to -1 0\nfillet face radius 0.3\nline face to 1 0\nfillet face radius 0.3\n"
      "line side to 1 3\nline top close\ncontact floor.top pad.face\nfix floor.bottom\nplaten pad.top about 0 3 x 0 fy -2 turn "
      "0\n");
  for (const double fineness : {0.25, 0.35, 0.5, 0.7, 1.0}) {
    CAPTURE(fineness);
    const Solution s = solved(drawn, {fineness});
    CHECK(std::fabs(s.zones[0].force[1]) == doctest::Approx(2).epsilon(1e-6));
  }
}

// A short wall beside a long side, whose elements are the ones with the pairs.
const std::string kShort =
    "body b E 1 nu 0.3\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\n"
    "body c E 1 nu 0.3\nfrom 1 0.35\nline s to 2 0.35\nline e to 2 0.62\nline n to 1 0.62\nline w close\n"
    "fix b.w\nfix c.e\n";

TEST_CASE("sketch zones: elements longer than what they face make way for shorter ones") {
  const sketch::Reading drawn = read_text(kShort + "contact c.w b.e\n");
  const sketch::Mesh coarse = sketch::first_mesh(drawn.sketch, 0.01), fine = sketch::first_mesh(drawn.sketch, 2);
  CHECK(zones(drawn, coarse).size() == 1);
  CHECK(sketch::elements_of(coarse) < sketch::elements_of(fine));
  const sketch::Reading apart = read_text(kShort + "contact c.s b.e\n");
  REQUIRE(apart.faults.size() == 1);
  CHECK(apart.faults[0].text ==
        "no part of c.s faces b.e: they are inclined to each other by 90 degrees or more, expected less "
        "than 50 degrees at some place; their smallest distance is 0 at (1, 0.35)");
}

TEST_CASE("sketch zones: what is far is left out, but not all of an interface") {
  const sketch::Reading drawn = read_text(kShort + "contact c.w b.e\n");
  sketch::Mesh mesh = sketch::first_mesh(drawn.sketch, 2);
  const std::vector<sketch::Zone> all = zones(drawn, mesh);
  for (sketch::MeshedCurve& curve : mesh.bodies[0][0].curves) curve.far = {{0, 0.1}};
  CHECK(zones(drawn, mesh).at(0).two.count < all.at(0).two.count);
  for (sketch::MeshedCurve& curve : mesh.bodies[0][0].curves) curve.far = {{0, 1}};
  CHECK(zones(drawn, mesh).at(0).two.count == all.at(0).two.count);
}

// A pad over a quarter of a wide face whose far end is rounded: a mean curvature with that end in it would turn the frames.
TEST_CASE("sketch zones: side 1 ends beside what side 2 faces") {
  const sketch::Reading drawn = read_text("body block E 1000 nu 0.3\nfrom -20 -10\nline bottom to 20 -10\nline right to 20 0\n"
                                          "fillet lip radius 4\nline top to -20 0\nline left close\n"
                                          "body pad E 1000 nu 0.3\nfrom -15 1e-3\nline foot to -5 1e-3\nline to -5 6\n"
                                          "line roof to -15 6\nline close\ncontact block.top+lip pad.foot\n"
                                          "fix block.bottom\nplaten pad.roof about -10 6 force 0 -1 turn 0\n");
  const sketch::Mesh mesh = sketch::first_mesh(drawn.sketch, 2);
  const std::vector<sketch::Zone> found = zones(drawn, mesh);
  REQUIRE(found.size() == 1);
  int element = 0;
  double low = HUGE_VAL, high = -HUGE_VAL; // of side 1
  for (const sketch::MeshedCurve& curve : mesh.bodies[0][0].curves)
    for (size_t e = 0; e < curve.elements(); ++e) {
      if (++element < found[0].one.first || element > found[0].one.last) continue;
      CHECK(curve.curve->name == "top");
      for (const double s : {curve.ends[e], curve.ends[e + 1]}) {
        const double x = curve.curve->shape->at(curve.measure.u_at(s)).x;
        low = std::min(low, x), high = std::max(high, x);
      }
    }
  CHECK(low <= -15);
  CHECK(high >= -5);
  CHECK(high < 14);
}
