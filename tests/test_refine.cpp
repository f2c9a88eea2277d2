// Meshes of sketches made finer, what is left out of a contact, and limits of the loop over meshes.
#include "program/estimate/loop.hpp"
#include "program/estimate/marks.hpp"
#include "program/estimate/mesh/far.hpp"
#include "program/estimate/wanted.hpp"
#include "program/interrupt.hpp"
#include "program/sketch/read/read.hpp"
#include "program/sketch/refine.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace sketch;

namespace {

const std::string kRoller = "parameter p 20\n"
                            "body plate E 1000 nu 0.3\nfrom -20 -20\nline bottom to 20 -20\nline right to 20 0\n"
                            "line top to -20 0\nline left close\n"
                            "body roller E 1000 nu 0.3\nfrom -8 2\narc foot to 8 2 radius 17\nline right to 8 12\n"
                            "line top to -8 12\nline left close\n"
                            "contact plate.top roller.foot mu 0.2\n"
                            "fix plate.bottom\nplaten roller.top about 0 12 force 0 -p turn 0\n";

Sketch sketch_of(const std::string& text) {
  Reading r = read_sketch(text, {}, [](const std::string&, std::string&) { return false; });
  for (const Fault& f : r.faults) MESSAGE(f.at.line << ": " << f.text);
  REQUIRE(r.faults.empty());
  return r.sketch;
}

Sketch roller(const std::string& more = std::string()) { return sketch_of(kRoller + more); }

std::vector<double> lengths_of(const MeshedOutline& outline) {
  std::vector<double> out;
  for (const MeshedCurve& curve : outline.curves)
    for (size_t e = 0; e < curve.elements(); ++e) out.push_back(curve.ends[e + 1] - curve.ends[e]);
  return out;
}

estimate::Adapted adapt(const Sketch& s) {
  estimate::Demand demand;
  estimate::ask(s, demand);
  return estimate::adapt(s, demand, [](const app::MeshRound&) {});
}

} // namespace

TEST_CASE("refine: halves keep every end and double the elements") {
  const Sketch s = roller();
  const Mesh mesh = first_mesh(s, 0.5), fine = halved(s, mesh);
  CHECK(elements_of(fine) == 2 * elements_of(mesh));
  for (size_t c = 0; c < mesh.bodies[1][0].curves.size(); ++c) {
    const std::vector<double>&p = mesh.bodies[1][0].curves[c].ends, &q = fine.bodies[1][0].curves[c].ends;
    for (size_t e = 0; e < p.size(); ++e) CHECK(p[e] == q[2 * e]);
  }
}

TEST_CASE("refine: neighbours stay within three to one, round the end of an outline, too") {
  const Sketch s = roller();
  Mesh mesh = first_mesh(s, 0.25);
  for (int round = 0; round < 4; ++round) {
    Levels levels;
    for (const auto& outlines : mesh.bodies) levels.push_back(std::vector<Bisection>(outlines[0].elements()));
    levels[1][0].level = 2; // at the begin of the roller's outline
    mesh = refined(s, mesh, levels);
  }
  const std::vector<double> lengths = lengths_of(mesh.bodies[1][0]);
  for (size_t e = 0; e < lengths.size(); ++e) {
    const double ratio = lengths[e] / lengths[(e + 1) % lengths.size()];
    CHECK(ratio < 3.001);
    CHECK(ratio > 1 / 3.001);
  }
}

TEST_CASE("refine: an element is graded toward one of its ends") {
  const Sketch s = roller();
  const Mesh mesh = first_mesh(s, 0.25);
  for (const int toward : {-1, 1}) {
    Levels levels;
    for (const auto& outlines : mesh.bodies) levels.push_back(std::vector<Bisection>(outlines[0].elements()));
    const std::vector<double>& ends = mesh.bodies[0][0].curves[0].ends;
    levels[0][0] = {5, toward};
    const std::vector<double> now = refined(s, mesh, levels).bodies[0][0].curves[0].ends;
    const double length = ends[1] - ends[0], at = toward < 0 ? ends[0] : ends[1];
    for (int k = 1; k <= 5; ++k) // at a half, a quarter, ... of its length from there
      CHECK(std::any_of(now.begin(), now.end(),
                        [&](double end) { return std::fabs(std::fabs(end - at) - std::ldexp(length, -k)) < 1e-9 * length; }));
    const std::ptrdiff_t inside = std::count_if(
        now.begin(), now.end(), [&](double end) { return end > ends[0] + 1e-9 * length && end < ends[1] - 1e-9 * length; });
    CHECK(inside == 5);
  }
}

TEST_CASE(
    "refine: a large share at the end of a curve is graded, one beside its like is not; a contact in one element is sought") {
  const Sketch s = roller();
  const Mesh mesh = first_mesh(s, 0.25);
  estimate::Distance distance;
  for (const auto& outlines : mesh.bodies) distance.shares.push_back(std::vector<estimate::Share>(outlines[0].elements()));
  const auto bisections = [&] { return estimate::marks(mesh, distance, 0.01, 0.08); };
  std::vector<estimate::Share>& shares = distance.shares[0];
  REQUIRE(mesh.bodies[0][0].curves[0].elements() > 1);
  shares[0].energy = 0.1;
  CHECK(bisections()[0][0].toward == -1);
  CHECK(bisections()[0][0].level > 2);
  shares[1].energy = 0.05;
  CHECK(bisections()[0][0].toward == 0);
  CHECK(bisections()[0][0].level == 2);
  shares[0].energy = shares[1].energy = 0;
  estimate::Share& alone = distance.shares[1][0];
  alone.pressure = 0.5, alone.edge = true;
  CHECK(bisections()[1][0].level == 2);
  alone.touch = 1;
  CHECK(bisections()[1][0].level == 4);
  CHECK(bisections()[1][0].toward == 1);
}

TEST_CASE("refine: what is asked of side 1 is done on both sides") {
  const Sketch s = roller();
  const Mesh mesh = first_mesh(s, 0.25);
  Levels levels;
  for (const auto& outlines : mesh.bodies) levels.push_back(std::vector<Bisection>(outlines[0].elements()));
  size_t first = 0, middle = 0; // the element of the plate under the roller
  for (const MeshedCurve& curve : mesh.bodies[0][0].curves)
    for (size_t e = 0; e < curve.elements(); ++e, ++first) {
      const Point p = curve.curve->shape->at(curve.measure.u_at((curve.ends[e] + curve.ends[e + 1]) / 2));
      if (curve.curve->name == "top" && std::fabs(p.x) < curve.ends[e + 1] - curve.ends[e]) middle = first;
    }
  levels[0][middle].level = 1;
  const Mesh fine = refined(s, mesh, levels);
  CHECK(fine.bodies[1][0].elements() > mesh.bodies[1][0].elements());
  CHECK(fine.bodies[0][0].elements() > mesh.bodies[0][0].elements());
}

TEST_CASE("refine: ends of elements move to places; what has moved stays, and so do ends of curves") {
  const Sketch s = roller();
  Mesh mesh = first_mesh(s, 1);
  MeshedCurve* foot = nullptr;
  for (MeshedCurve& curve : mesh.bodies[1][0].curves)
    if (curve.curve->name == "foot") foot = &curve;
  REQUIRE(foot != nullptr);
  foot->ends = {0, 4, 8, 12, foot->measure.length()};
  const auto spot = [&](double at) { return Spot{1, foot->curve->shape->at(foot->measure.u_at(at))}; };
  const Located at = locate(s, spot(5), true, mesh);
  CHECK(at.curve == foot);
  CHECK(at.length == doctest::Approx(5).epsilon(1e-9));
  CHECK(at.first == 0);
  CHECK(locate(s, Spot{0, {-20, -5}}, false, mesh).curve->curve->name == "left");
  CHECK(locate(s, Spot{0, {0, 0}}, true, mesh).curve == nullptr); // its nodes have no pairs
  place_ends(s, {spot(5), spot(5.5), spot(9), spot(1.5)}, mesh);
  const double expected[] = {0, 1.5, 5, 9, 12}; // 4 went to 5, 8 to 9; an end is made at 1.5, where both beside it stay
  REQUIRE(foot->ends.size() == 6);
  for (size_t e = 0; e < 5; ++e) CHECK(foot->ends[e] == doctest::Approx(expected[e]).epsilon(1e-9));
}

TEST_CASE("refine: elements at places that are not met are marked, with their neighbours") {
  const Sketch s = roller();
  Mesh mesh = first_mesh(s, 1);
  estimate::Trial trial;
  std::string why;
  REQUIRE(estimate::solve(deck_of(s, mesh), {}, trial, why) == C2D_OK);
  Levels levels;
  for (const auto& outlines : mesh.bodies) levels.push_back(std::vector<Bisection>(outlines[0].elements()));
  app::Stated edge;
  edge.what = app::Measure::kContactEdge;
  edge.zone = 1, edge.tolerance = 0.01, edge.scale = 1;
  for (const app::Quantity& q : trial.states.back().quantities)
    if (q.what == app::Measure::kContactEdge) edge.at[0] = q.at[0], edge.at[1] = q.at[1];
  REQUIRE_FALSE(std::isnan(edge.at[0]));
  edge.error = 0.001; // met
  estimate::mark_places(s, trial, {edge}, mesh, levels);
  const auto marked = [&] {
    return std::count_if(levels[1].begin(), levels[1].end(), [](const Bisection& b) { return b.level == 1; });
  };
  CHECK(marked() == 0);
  edge.error = 0.02;
  estimate::mark_places(s, trial, {edge}, mesh, levels);
  CHECK(marked() == 3);
  CHECK(std::all_of(levels[0].begin(), levels[0].end(), [](const Bisection& b) { return b.level == 0; }));
}

TEST_CASE("loop: a contact takes few pairs, with an end of an element at each edge") {
  const Sketch s = roller(); // its curves are those of the mesh
  const estimate::Adapted a = adapt(s);
  REQUIRE(a.loop.stopped.empty());
  CHECK(a.loop.rounds[a.loop.taken].pairs <= 100);
  int edges = 0;
  for (const app::Stated& edge : a.loop.stated) {
    if (edge.what != app::Measure::kContactEdge) continue;
    ++edges;
    double nearest = HUGE_VAL;
    for (const MeshedCurve& curve : a.mesh.bodies[1][0].curves)
      for (const double end : curve.ends) {
        const Point p = curve.curve->shape->at(curve.measure.u_at(end));
        nearest = std::min(nearest, std::hypot(p.x - edge.at[0], p.y - edge.at[1]));
      }
    CHECK(nearest <= 2 * edge.error);
  }
  CHECK(edges == 2);
}

TEST_CASE("loop: a stress that has no bound is given up, and said") {
  const estimate::Adapted a = adapt(roller("want hoop plate.left 1 %\nwant pressure 5 %\n"));
  CAPTURE(a.loop.stopped);
  CHECK(a.loop.stopped.find("it may be unbounded") != std::string::npos);
  for (const app::Stated& s : a.loop.stated) {
    CAPTURE(s.name());
    CHECK((s.is_met() || s.name().find("stress along left") != std::string::npos));
  }
}

TEST_CASE("refine: pairs are made where contact is, and again where it grows up to what was left out") {
  const Sketch s = roller();
  Mesh mesh = first_mesh(s, 1);
  estimate::Trial trial;
  std::string why;
  REQUIRE(estimate::solve(deck_of(s, mesh), {}, trial, why) == C2D_OK);
  REQUIRE(estimate::mark_far(s, trial, mesh));
  CHECK_FALSE(estimate::mark_far(s, trial, mesh)); // nothing more
  estimate::Trial near;
  REQUIRE(estimate::solve(deck_of(s, mesh), {}, near, why) == C2D_OK);
  CHECK(near.pairs < trial.pairs);
  CHECK_FALSE(estimate::is_cut_off(near, mesh));
  const auto peak = [](const estimate::Trial& t) { return t.states.back().quantities.front().value; };
  CHECK(peak(near) == doctest::Approx(peak(trial)).epsilon(1e-9)); // what is far carries nothing
  Sketch loaded = s;                                               // under a load that spreads the contact
  for (Drive& d : loaded.drives)
    if (d.load[1]) d.load[1] = 40 * *d.load[1];
  estimate::Trial wide;
  const c2d_status status = estimate::solve(deck_of(loaded, mesh), {}, wide, why);
  CAPTURE(why);
  REQUIRE(status == C2D_OK);
  CHECK(estimate::is_cut_off(wide, mesh));
}

TEST_CASE("loop: the same sketch gives the same deck, and errors below the tolerance") {
  const Sketch s = roller("tolerance 2 %\n");
  const estimate::Adapted first = adapt(s), second = adapt(s);
  CHECK(first.deck == second.deck);
  CHECK(first.loop.stopped.empty());
  int judged = 0;
  for (const app::Stated& number : first.loop.stated) {
    CHECK(number.is_met());
    judged += std::isnan(number.tolerance) ? 0 : 1;
  }
  CHECK(judged >= 6); // tractions, peak, two edges, forces, approach
}

TEST_CASE("loop: limits of elements, time and memory end it, with the error that was reached") {
  for (const char* limit : {"limit elements 150\n", "limit seconds 1e-6\n"}) {
    const estimate::Adapted a = adapt(roller(std::string("tolerance 0.01 %\n") + limit));
    CAPTURE(limit);
    CHECK_FALSE(a.loop.stopped.empty());
    CHECK_FALSE(a.deck.empty());
  }
  const Sketch s = roller("tolerance 0.01 %\n");
  estimate::Demand small;
  small.memory = 3000000;
  const estimate::Adapted a = estimate::adapt(s, small, [](const app::MeshRound&) {});
  CHECK(a.loop.stopped.find("bytes would do") != std::string::npos);
  CHECK_FALSE(a.loop.stated.empty());
}

TEST_CASE("loop: a stricter tolerance goes on where another ends, and is never worse for the same work") {
  for (const char* limit : {"limit work 2e8\n", "limit work 6e8\n"}) {
    CAPTURE(limit);
    std::vector<int32_t> before;
    double worst_before = HUGE_VAL;
    for (const char* tolerance : {"tolerance 4 %\n", "tolerance 1 %\n", "tolerance 0.3 %\n"}) {
      CAPTURE(tolerance);
      const estimate::Adapted a = adapt(roller(std::string(tolerance) + limit));
      std::vector<int32_t> elements;
      for (const app::MeshRound& round : a.loop.rounds) elements.push_back(round.elements);
      REQUIRE(elements.size() >= before.size());
      CHECK(std::equal(before.begin(), before.end(), elements.begin()));
      double worst = 0;
      for (const app::Stated& s : a.loop.stated)
        if (!std::isnan(s.tolerance) && s.scale > 0) worst = std::max(worst, s.relative_error());
      CHECK(worst <= worst_before);
      before = elements, worst_before = worst;
    }
  }
}

TEST_CASE("refine: no element becomes so short that coordinates have no digits for it") {
  const Sketch s = roller();
  Mesh mesh = first_mesh(s, 0.5);
  for (int round = 0; round < 40; ++round) {
    Levels levels;
    for (const auto& outlines : mesh.bodies) levels.push_back(std::vector<Bisection>(outlines[0].elements()));
    levels[0][0].level = 2;
    mesh = refined(s, mesh, levels);
  }
  const std::vector<double> lengths = lengths_of(mesh.bodies[0][0]);
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  CHECK(shortest >= 2e-7); // of coordinates up to 20
  CHECK(shortest < 1e-6);
  CHECK(lengths_of(halved(s, mesh).bodies[0][0])[0] == doctest::Approx(shortest));
  estimate::Trial trial;
  std::string why;
  CHECK(estimate::solve(deck_of(s, mesh), {}, trial, why) == C2D_OK);
}

TEST_CASE("loop: a signal ends it with the best mesh so far") {
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    app::catch_interrupts();
    int meshes = 0;
    const estimate::Adapted a = estimate::adapt(roller("tolerance 0.01 %\n"), {}, [&](const app::MeshRound&) {
      if (++meshes == 4) ::raise(SIGTERM);
    });
    const bool has_results = a.status == C2D_OK && !a.deck.empty() && !a.loop.stated.empty() && a.loop.missed();
    const bool stopped = a.loop.stopped == "the search was interrupted" && app::interrupted();
    app::put_off_interrupt();
    ::_exit(has_results && stopped && !app::interrupted() ? app::exit_put_off() : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 143));
}

TEST_CASE("loop: where the second mesh has no memory the results of the first stand, and nothing is met") {
  int first_alone = 0;
  for (uint64_t memory = 1000000; memory > 30000; memory -= memory / 4) {
    CAPTURE(memory);
    estimate::Demand small;
    small.memory = memory;
    const estimate::Adapted a = estimate::adapt(roller("tolerance 0.01 %\n"), small, [](const app::MeshRound&) {});
    if (a.status != C2D_OK) { // not even the first: nothing is written
      CHECK(a.loop.rounds.empty());
      break;
    }
    CHECK_FALSE(a.deck.empty());
    CHECK(a.loop.missed());
    CHECK_FALSE(a.loop.stopped.empty());
    CHECK(a.loop.taken < a.loop.rounds.size());
    if (a.loop.rounds.size() > 1) continue;
    ++first_alone;
    CHECK(a.loop.stated.empty());
  }
  CHECK(first_alone > 0);
}

TEST_CASE("loop: a history that ends early is told, and nothing is met") {
  Sketch s = roller();
  for (Drive& d : s.drives) d.load[0] = 100; // more than friction can carry
  const estimate::Adapted a = adapt(s);
  CAPTURE(a.loop.stopped);
  CHECK(a.loop.stopped.find("ended early") != std::string::npos);
}
