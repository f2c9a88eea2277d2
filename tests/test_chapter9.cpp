// Chapter 9 of the dissertation (make chapter9): what increments and sizes of elements do to the friction
// under full adhesion, against event following and against the continuum, which is known in closed form.
#include "../examples/chapter9/study.hpp"
#include "family_runs.hpp"
#include "paths.hpp"
#include "shell.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace chapter9;

namespace {

using Settings = std::vector<std::string>;
const Settings kAdhesion = {"mu=inf", "n=15", "edge=0"};

Run solved(const Settings& settings, Stepping stepping, const LoadCards& cards) {
  const Run run = follow(make_deck(settings, cards), stepping);
  REQUIRE_MESSAGE(run.error.empty(), run.error);
  REQUIRE(run.nodes.size() > 8);
  return run;
}
Run by_events(const Settings& settings, const LoadCards& cards = equal(1)) {
  return solved(settings, Stepping::kEvents, cards);
}
Run by_increments(const Settings& settings, const LoadCards& cards) { return solved(settings, Stepping::kIncrements, cards); }
Settings with(Settings settings, const std::string& more) {
  settings.push_back(more);
  return settings;
}

} // namespace

TEST_CASE("chapter9: the closed form of adhesion is the reference, which was made by superposition of stamps") {
  const Adhesion exact(0.3);
  CHECK(exact.half_width() == doctest::Approx(0.9686138354342385).epsilon(1e-8));
  for (const std::vector<double>& row : families_test::reference("p06_pq_adh_nu0.3")) {
    CHECK(std::fabs(exact.pressure(row[3]) - row[4]) < 1e-5); // the quadrature's error
    CHECK(std::fabs(exact.friction(row[3]) - row[5]) < 1e-5);
  }
}

TEST_CASE("chapter9: event following needs no increments") {
  for (const char* mu : {"mu=inf", "mu=0.4"}) {
    const Settings settings = {mu, "n=15", "edge=0"};
    const Run one = by_events(settings);
    for (const LoadCards& cards : {equal(25), equal(200), LoadCards{{4, 0.16}, {168, 1.0}},
                                   pair_by_pair(settings, one.touching), LoadCards{{3, 0.0137}, {1, 0.77}, {1, 1.0}}}) {
      const Run many = by_events(settings, cards);
      REQUIRE(many.nodes.size() == one.nodes.size());
      for (size_t i = 0; i < one.nodes.size(); ++i) {
        CHECK(many.nodes[i].closed == one.nodes[i].closed);
        CHECK(std::fabs(many.nodes[i].friction - one.nodes[i].friction) < 1e-9);
        CHECK(std::fabs(many.nodes[i].pressure - one.nodes[i].pressure) < 1e-9);
      }
    }
  }
}

TEST_CASE("chapter9: equal increments oscillate and come closer to the events as they are halved (figures "
          "36, 37)") {
  const Run exact = by_events(kAdhesion);
  CHECK(compare(exact, Adhesion(0.3)).largest < 0.01); // measured 0.0042
  double before = 1;
  for (const int count : {25, 50, 100, 200, 800, 3200}) {
    CAPTURE(count);
    const Run run = by_increments(kAdhesion, equal(count));
    const double now = compare(run, exact).rms; // measured 0.087, 0.076, 0.038, 0.023, 0.0031, 0.0010
    CHECK(now < before);
    before = now;
    if (count == 25) CHECK(now > 0.05);
    if (count == 200) CHECK(now < 0.03);
    for (size_t i = 0; i < run.nodes.size(); ++i) // normal tractions hardly depend on them, as the thesis says
      CHECK(std::fabs(run.nodes[i].pressure - exact.nodes[i].pressure) < 0.02);
  }
  CHECK(before < 0.002);
}

TEST_CASE("chapter9: what large increments spoil stays where it is (figure 38)") {
  const Run exact = by_events(kAdhesion), run = by_increments(kAdhesion, {{4, 0.16}, {168, 1.0}});
  double inside = 0, outside = 0;
  for (size_t i = 0; i < run.nodes.size(); ++i) {
    if (run.nodes[i].x > kInside) continue;
    double& worst = run.nodes[i].x < 0.45 ? inside : outside; // the contact reaches 0.39 at 16 % of the load
    worst = std::max(worst, std::fabs(run.nodes[i].friction - exact.nodes[i].friction) / largest_friction(exact));
  }
  CHECK(inside > 0.15);  // measured 0.19
  CHECK(outside < 0.03); // measured 0.027
}

TEST_CASE("chapter9: increments of one pair each give a smooth curve that is too high; divided, they fall "
          "(figure 39)") {
  const Run exact = by_events(kAdhesion);
  const LoadCards cards = pair_by_pair(kAdhesion, exact.touching);
  CHECK(count_of(cards) == 14); // one for each pair off the axis, and the rest of the load
  const Run once = by_increments(kAdhesion, cards);
  for (size_t i = 4; i < once.nodes.size(); ++i)
    if (once.nodes[i].closed) CHECK(once.nodes[i].friction > exact.nodes[i].friction);
  double before = compare(once, exact).rms; // measured 0.088
  for (const int parts : {2, 4}) {          // 0.037, 0.014
    const double now = compare(by_increments(kAdhesion, divided(cards, parts)), exact).rms;
    CHECK(now < 0.5 * before);
    before = now;
  }
  CHECK(compare(by_increments(kAdhesion, divided(cards, 64)), exact).rms < 0.002); // measured 0.0013
}

TEST_CASE("chapter9: a jump in the size of elements leaves an error there that no increment removes (figure 40)") {
  const Adhesion continuum(0.3);
  double largest[3];
  const char* const sizes[] = {"sizes=equal", "sizes=gradual", "sizes=jump"};
  for (int i = 0; i < 3; ++i) {
    const Settings mesh = with(kAdhesion, sizes[i]);
    const Run exact = by_events(mesh);
    largest[i] = compare(exact, continuum).largest; // measured 0.0042, 0.0125, 0.040
    CHECK(compare(exact, continuum).rms < compare(by_increments(mesh, equal(200)), continuum).rms);
    if (i < 2) continue;
    for (const Node& node : exact.nodes) // but for the nodes at the jump, at 0.714, all is as on equal elements
      if (node.x < 0.55 || (node.x > 0.73 && node.x < 0.85))
        CHECK(std::fabs(node.friction - continuum.friction(node.x)) < 0.01 * largest_friction(exact));
  }
  CHECK(largest[0] < 0.01);
  CHECK(largest[1] < 0.02);
  CHECK(largest[2] > 0.03);
  CHECK(largest[2] < 0.06); // the thesis: 6 %
}

TEST_CASE("chapter9: slip at the edge makes increments matter less (figure 41)") {
  const Settings friction = {"mu=0.4", "n=15", "edge=0"};
  const Run exact = by_events(friction), adhesion = by_events(kAdhesion);
  const double twenty = compare(by_increments(friction, equal(20)), exact).rms;
  CHECK(twenty < 0.03);                                                                              // measured 0.018
  CHECK(twenty < 0.3 * compare(by_increments(kAdhesion, equal(20)), adhesion).rms);                  // 0.087 with 25
  CHECK(compare(by_increments(friction, pair_by_pair(friction, exact.touching)), exact).rms < 0.01); // 0.0025
}

TEST_CASE("chapter9: quadratic elements let the friction alternate between end and middle nodes") {
  // The edge passes end and middle nodes in turn; what each keeps from then on differs, and with it the
  // friction, by an amount that falls like the root of the size of the elements only. The thesis left the
  // question open.
  const Adhesion continuum(0.3);
  const Run quadratic = by_events({"mu=inf", "n=8", "edge=0", "order=2"}); // as many nodes as 14 linear ones
  CHECK(compare(quadratic, continuum).largest > 5 * compare(by_events(kAdhesion), continuum).largest); // 0.047, 0.0042
}

TEST_CASE("chapter9: the program writes table, picture, curves, and decks that contact2d runs alike") {
  const test::Folder folder;
  const test::Result result = test::run_shell("'" + paths::chapter9() + "' '" + folder.path() + "'");
  REQUIRE_MESSAGE(result.status == 0, result.err);
  for (const char* curve : {"\nevents ", "\nequal_25 ", "\nequal_200 ", "\npairs_4 ", "\nsizes_jump_200 ", "\nmu_0.4_pairs "})
    CHECK_MESSAGE(test::contains(result.out, curve), curve);
  const std::string picture = test::read_file(folder / "chapter9.svg");
  for (const char* text : {"<svg", "Figure 36", "Figure 41", "distance from the axis x / a", "</svg>"})
    CHECK_MESSAGE(test::contains(picture, text), text);
  CHECK(!test::contains(picture, "nan"));

  const test::Result run = test::run_shell("'" + paths::program() + "' run '" + (folder / "equal_100.dat") +
                                           "' --stepping deck --csv '" + (folder / "run.csv") + "' --listing /dev/null");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  std::map<double, double> friction; // of the last step, over p0, at its place
  for (const std::string& line : test::lines_of(test::read_file(folder / "run.csv"))) {
    int step = 0;
    double x = 0, tn = 0, tt = 0;
    if (std::sscanf(line.c_str(), "%*[^,],%d,%*[^,],%*d,%lf,%*[^,],%*[^,],%lf,%lf", &step, &x, &tn, &tt) == 4 && step == 100)
      friction[x] = -tt / (1000 / (2 * 0.91) / 100);
  }
  std::vector<double> written;
  for (const std::string& line : test::lines_of(test::read_file(folder / "curves.csv"))) {
    double value = 0;
    if (std::sscanf(line.c_str(), "equal_100,%*[^,],%*[^,],%lf", &value) == 1) written.push_back(value);
  }
  REQUIRE(written.size() == friction.size());
  REQUIRE(written.size() > 15);
  size_t i = 0;
  for (const auto& [x, value] : friction) CHECK(std::fabs(written[i++] - value) < 1e-6); // six decimals
}
