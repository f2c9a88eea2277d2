// A body that the other lets go where nothing else holds it in some direction: its place there is undefined, told, and follows
// one rule.
#include "contact2d.h"
#include "lifted_block.hpp"
#include "solver_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <utility>

using namespace lifted;

TEST_CASE("let go: a block lifted straight from a flat table keeps its place, and goes on when it is pushed back") {
  for (int32_t elements : {1, 5}) {
    CAPTURE(elements);
    const Problem p = with_paths(block(elements, 5.0), {{1, 1, 0}, {1, 1, 0.1}, {1, 1, 0}, {2, -1, 0}, {1, 1, 0}, {1, 1, 0.1}});
    const Result r = solve(p);
    REQUIRE(r.outcome == C2D_REACHED);
    const std::vector<Step> rows = r.recorded();
    REQUIRE(rows.size() == 7);
    const double size = std::fabs(sideways(rows[1], 0)) + 0.01;
    CHECK(no_force(rows[4]));
    for (int i = 0; i <= elements; ++i) {
      CHECK(std::fabs(rows[4].at(i, C2D_GAP) - 0.01) < tight() * size); // raised by 0.01 straight up, without strain
      CHECK(std::fabs(sideways(rows[4], i)) < tight() * size);
    }
    CHECK(rows[4].elastic < tight() * rows[0].elastic);
    CHECK(compare(rows[0], rows[5]).worst() < 100 * tight()); // as if it had never been lifted
    CHECK(compare(rows[1], rows[6]).worst() < 100 * tight());
    const c2d_error* e = told(r);
    REQUIRE(e != nullptr);
    CHECK(e->load < 0);
    CHECK(std::string(e->text).find("position of body 2 in the direction (1, 0)") != std::string::npos);
    CHECK_FALSE(r.warned(C2D_WARN_NOT_UNIQUE));
  }
}

TEST_CASE("supports: two that lean on each other hold each other; two that may go together fly away") {
  const auto held = [](bool along_x) { // body 1 may move along x, body 2 along y or x
    Problem p = block(2, 0.5);
    set_ends(p, 1, [](double, double y, double, double ny, End& end) {
      end = End();
      if (y < -1.99) end.codes[3] = 0;
      if (ny < -0.5) end.codes[1] = 1;
    });
    p.bodies[0].second_case = p.bodies[0].ends;
    if (along_x) return p;
    for (std::vector<End>* ends : {&p.bodies[1].ends, &p.bodies[1].second_case})
      for (End& end : *ends)
        if (end.codes[3] == 0) std::swap(end.codes[0], end.codes[1]), std::swap(end.codes[2], end.codes[3]), end.values[1] = -1;
    return p;
  };
  // Friction holds the lower body, pressure the upper one: it is pushed down by 1 on a length of 4, and at both corners by what
  // falls to 0 along a side's element of length 1.
  const Problem p = held(false);
  const Result leaning = solve(p);
  CAPTURE(leaning.messages());
  REQUIRE(leaning.status == C2D_OK);
  CHECK(leaning.outcome == C2D_REACHED);
  for (int body = 1; body <= 2; ++body) {
    const problem::Resultant contact = resultant(p, leaning, body, 1);
    CHECK(std::fabs(contact.fx) < tight() * 5);
    CHECK(std::fabs(contact.fy - (body == 2 ? 5 : -5)) < tight() * 5);
  }
  const Result together = solve(held(true));
  CHECK(together.status == C2D_OK);
  CHECK(together.outcome == C2D_FREE_MOTION);
}

TEST_CASE("a held body that slides along a flat without pressing touches nothing and has no slip") {
  for (const int32_t elements : {4, 19}) {
    Problem p = block(elements, 0.1);
    for (std::vector<End>* ends : {&p.bodies[1].ends, &p.bodies[1].second_case})
      for (End& end : *ends) {
        if (end.codes[3] == 0) end.codes[0] = end.codes[1], end.codes[2] = 0; // the top is held in both directions
        end.values[0] = 0;
      }
    for (End& end : p.bodies[1].second_case)
      if (end.codes[3] == 0) end.values[2] = 0.005;
    p = with_paths(p, {{2, 0, 1}, {1, 0, 0.5}});
    for (const Problem& form : {p, reflected(p), rotated(p, 90)}) {
      const Result r = solve(form);
      REQUIRE(r.outcome == C2D_REACHED);
      for (const Step& s : r.recorded()) {
        CHECK(no_force(s));
        for (int i = 0; i <= elements; ++i) CHECK(s.at(i, C2D_SLIP_SUM) == 0);
      }
    }
  }
}

// The same on a smooth table; by_traction: pressed by case 1 as a traction instead, so that it may tilt and rise as well.
Problem smooth_block(double gap, bool by_traction) {
  Problem p = block(5, 0.0, gap);
  for (size_t i = 0; i < p.bodies[1].ends.size() && by_traction; ++i) {
    End& end = p.bodies[1].ends[i];
    if (end.codes[3] != 0) continue;
    end.codes[3] = 1, end.codes[1] = 0, end.values[1] = -5, end.values[3] = 0;
    p.bodies[1].second_case[i] = end;
    p.bodies[1].second_case[i].values[1] = 0;
  }
  return p;
}

// Nothing holds the block sideways: forces are those of one that is held at a point, which takes no force, and the mean of the
// pairs' tangential motions is none.
TEST_CASE("let go: a block on a smooth table is pressed, and its place along the table follows the rule") {
  for (const double gap : {0.0, 0.002})
    for (const bool by_traction : {false, true}) {
      CAPTURE(gap);
      CAPTURE(by_traction);
      // (At 0.2 of it the gap would close without a force, which leaves nothing to compare with.)
      const Problem p = with_paths(smooth_block(gap, by_traction), {{3, 1, 0}, {1, 0.25, 0}, {1, 1.5, 0}});
      const Result r = solve(p);
      REQUIRE_MESSAGE(r.outcome == C2D_REACHED, r.messages());
      const c2d_error* e = told(r);
      REQUIRE(e != nullptr);
      CHECK(std::string(e->text).find("position of body 2 in the direction (1, 0)") != std::string::npos);
      Problem held = p; // at a corner of its top
      for (std::vector<End>* ends : {&held.bodies[1].ends, &held.bodies[1].second_case}) {
        End& end = (*ends)[static_cast<size_t>((5 + 2) * 2)];
        end.codes[2] = 0, end.codes[0] = 1, end.values[0] = end.values[2] = 0;
      }
      const Result other = solve(held);
      REQUIRE_MESSAGE(other.outcome == C2D_REACHED, other.messages());
      CHECK_FALSE(other.warned(C2D_WARN_UNDEFINED_PLACE));
      const std::vector<Step> rows = r.recorded(), others = other.recorded();
      REQUIRE(rows.size() == others.size());
      for (size_t k = 0; k < rows.size(); ++k) {
        const Difference d = compare(rows[k], others[k]);
        CHECK(d.traction < 10 * tight());
        CHECK(d.gap < 10 * tight());
        CHECK(std::fabs(mean_sideways(rows[k])) < tight() * 0.01);
      }
    }
}

TEST_CASE("let go: a block on a smooth table that is pushed along it flies away, from where the push begins") {
  for (const bool by_traction : {false, true}) {
    const Result r = solve(with_paths(smooth_block(0.0, by_traction), {{1, 1, 0}, {1, 1, 0.1}}));
    CHECK(r.outcome == C2D_FREE_MOTION);
    CHECK(r.recorded().size() == 1);
    CHECK(r.summary.outcome_body == 2);
    CHECK(r.summary.free_motion[0] == doctest::Approx(1));
    CHECK(std::fabs(r.summary.free_motion[1]) < 1e-9);
    CHECK(std::fabs(r.summary.free_motion[2]) < 1e-9);
  }
}

// Lifted while it is held aside, the block lets go of its friction pair by pair, until nothing is left of its energy.
TEST_CASE("let go: the energy that friction without bound sets free is dissipated, and the balance closes") {
  Problem p = with_paths(block(4, HUGE_VAL), {{1, 1, 0}, {1, 1, 1}, {4, -1, 1}});
  for (size_t i = 0; i < p.bodies[1].ends.size(); ++i)
    if (p.bodies[1].ends[i].codes[3] == 0) { // its top is held along x as well, and moved there by case 2
      for (std::vector<End>* ends : {&p.bodies[1].ends, &p.bodies[1].second_case})
        (*ends)[i].codes[2] = 0, (*ends)[i].codes[0] = 1;
      p.bodies[1].second_case[i].values[2] = 0.01;
    }
  for (End& end : p.bodies[1].second_case) end.values[0] = 0;
  Setup every;
  every.every_change = 1;
  const Result r = solve(p, every);
  REQUIRE(r.outcome == C2D_REACHED);
  double before = 0;
  for (const Step& s : r.steps) {
    CHECK(s.dissipated >= before);
    before = s.dissipated;
  }
  for (const Step& s : r.recorded()) CHECK(std::fabs(s.defect) < 3e-3); // without what is set free 0.18 at last
  const Step last = r.recorded().back();
  CHECK(no_force(last));
  CHECK(std::fabs(last.elastic) < tight() * last.dissipated);
  CHECK(last.dissipated > 0.015);
}

TEST_CASE("seating: a bowed block that is pressed beside the pair on which it stands rolls onto a second one") {
  const auto pressed = [](int32_t elements, double mu, double bow) { // by a pressure on its top, held by nothing else
    Problem p = block(elements, mu);
    for (std::vector<End>* ends : {&p.bodies[1].ends, &p.bodies[1].second_case})
      for (End& end : *ends) {
        if (end.codes[3] != 0) continue;
        end.codes[3] = 1, end.values[3] = 0;
        if (end.codes[1] != 0) end.codes[1] = 0, end.values[1] = ends == &p.bodies[1].ends ? -1 : 0;
      }
    for (size_t i = 0; i + 1 < p.bodies[1].xy.size(); i += 2)
      if (p.bodies[1].xy[i + 1] < 0.01) p.bodies[1].xy[i + 1] += bow * (p.bodies[1].xy[i] - 2) * (p.bodies[1].xy[i] - 2);
    return with_paths(p, {{1, 1, 0}});
  };
  for (const int32_t elements : {2, 4}) {
    const Result bowed = solve(pressed(elements, 0.3, 1e-3)); // the pair at (2, 0) is the only one that touches
    REQUIRE_MESSAGE(bowed.outcome == C2D_REACHED, bowed.messages());
    CHECK(bowed.summary.force_error < 1e-12);
    int closed = 0;
    for (int i = 0; i <= elements; ++i) closed += bowed.recorded().back().at(i, C2D_STATUS) != double{C2D_OPEN};
    CHECK(closed >= 2);
  }
}

TEST_CASE("let go: what it has slid before stays, and no slip is counted in the air") {
  // On a smooth enough table the sides of the block slide outwards as it is pressed, and some of that remains.
  const Problem p = with_paths(block(6, 0.05), {{1, 1, 0}, {1, 1, 0.02}, {1, 0.02, 0}, {2, -1, 0}});
  const Result r = solve(p);
  REQUIRE(r.outcome == C2D_REACHED);
  const std::vector<Step> rows = r.recorded();
  REQUIRE(rows.size() == 5);
  CHECK(no_force(rows[3]));
  CHECK(no_force(rows[4]));
  CHECK(std::fabs(mean_sideways(rows[4]) - mean_sideways(rows[3])) < 1e-12);
  CHECK(std::fabs(rows[4].at(0, C2D_GAP) - rows[3].at(0, C2D_GAP) - 0.0051) < 1e-12);
  for (int i = 0; i < rows[4].pairs(); ++i) CHECK(rows[4].at(i, C2D_SLIP_SUM) == rows[3].at(i, C2D_SLIP_SUM));
}

TEST_CASE("let go: a body that loads move flies away") {
  const Problem p = with_paths(block(4, 0.5), {{1, 1, 0}, {1, -1, 0}, {1, -1, 0.1}});
  const Result r = solve(p);
  CHECK(r.outcome == C2D_FREE_MOTION);
  CHECK(r.summary.load == -1);
  CHECK(r.recorded().size() == 2);
  CHECK(r.summary.outcome_body == 2);
  CHECK(r.summary.free_motion[0] > 0);
  CHECK(std::fabs(r.summary.free_motion[1]) + std::fabs(r.summary.free_motion[2]) < 1e-9);
  const Result pulled = solve(with_paths(block(4, 0.5), {{1, 1, 0}, {1, -1, 0.1}})); // slides off before it lifts
  CHECK(pulled.outcome == C2D_GROSS_SLIDING);
}

TEST_CASE("let go: a body that hangs over the other comes down where it was made") {
  const double gap = 0.004;
  const Result r = solve(with_paths(block(5, 0.3, gap), {{1, 0.2, 0}, {2, 1.4, 0}, {1, 0, 0}}));
  const Result on_it = solve(with_paths(block(5, 0.3), {{1, 1, 0}}));
  REQUIRE(r.outcome == C2D_REACHED);
  REQUIRE(on_it.outcome == C2D_REACHED);
  const std::vector<Step> rows = r.recorded();
  REQUIRE(rows.size() == 4);
  REQUIRE(told(r) != nullptr);
  CHECK(told(r)->load == 0.2);
  CHECK(no_force(rows[0]));
  CHECK(no_force(rows[3]));
  for (int i = 0; i < rows[2].pairs(); ++i) {
    CHECK(std::fabs(rows[0].at(i, C2D_GAP) - 0.002) < 1e-12);
    CHECK(std::fabs(sideways(rows[0], i)) < 1e-12);
    CHECK(rows[2].at(i, C2D_TN) == doctest::Approx(on_it.recorded()[0].at(i, C2D_TN)).epsilon(1e-3)); // the gap is 1/500 of it
    CHECK(std::fabs(rows[3].at(i, C2D_GAP) - gap) < 1e-11);
  }
}

TEST_CASE("let go: a body that hangs is at rest under no load, as often as that is asked for") {
  const Problem p = with_paths(block(5, 0.3, 0.004), {{1, 1, 0}});
  Setup setup;
  setup.advance_mu = 0.3;
  setup.advance_loads = {0, 0, 1};
  setup.advance_second = {0, 0, 0};
  const Result calls = solve(p, setup), plain = solve(p);
  REQUIRE(calls.outcome == C2D_REACHED);
  REQUIRE(calls.recorded().size() == 3);
  for (size_t k = 0; k < 2; ++k) {
    CHECK(no_force(calls.recorded()[k]));
    for (int i = 0; i < calls.recorded()[k].pairs(); ++i) CHECK(calls.recorded()[k].at(i, C2D_GAP) == doctest::Approx(0.004));
  }
  CHECK(compare(calls.recorded()[2], plain.recorded()[0]).worst() < 1e-9);
}

TEST_CASE("let go: free zones, curved functions and rigid obstacles do the same") {
  const std::vector<Path> path = {{1, 1, 0}, {1, -1, 0}, {1, 1, 0}};
  Problem facing = block(5, 0.4);
  facing.zones.clear();
  problem::FreeZone zone = problem::FreeZone();
  zone.first_element[0] = 8, zone.last_element[0] = 12, zone.first_element[1] = 5, zone.last_element[1] = 1;
  facing.free_zones = {zone};
  Problem on_rigid = block(5, 5.0); // with less friction several states are possible on the way back
  on_rigid.rigid = true;
  Problem one_case = block(3, 0.4);
  for (Body& body : one_case.bodies) body.second_case.clear();
  const Problem all[] = {facing, with_functions(one_case, 3), with_functions(one_case, 4), on_rigid};
  for (const Problem& p : all) {
    CAPTURE(&p - all);
    const Result r = solve(with_paths(p, path));
    REQUIRE_MESSAGE(r.status == C2D_OK, r.messages());
    REQUIRE_MESSAGE(r.outcome == C2D_REACHED, r.messages());
    const std::vector<Step> rows = r.recorded();
    REQUIRE(rows.size() == 3);
    CHECK(no_force(rows[1]));
    CHECK(told(r) != nullptr);
    for (int i = 0; i < rows[1].pairs(); ++i) CHECK(std::fabs(rows[1].at(i, C2D_GAP) - 0.01) < 1e-11);
    CHECK(std::fabs(mean_sideways(rows[1])) < 1e-11);
    CHECK(compare(rows[0], rows[2]).traction < 1e-7);
  }
}

TEST_CASE("let go: the increments of 1987, calls instead of a run, and every change told end at the same place") {
  const Problem p = with_paths(block(5, 0.5), {{1, 1, 0}, {4, -1, 0}, {1, 0.5, 0}});
  const Result r = solve(p);
  REQUIRE(r.outcome == C2D_REACHED);
  Setup setup;
  setup.stepping = C2D_STEPPING_DECK;
  const Result deck = solve(p, setup);
  REQUIRE(deck.outcome == C2D_REACHED);
  for (size_t i = 2; i < 5; ++i) CHECK(compare(deck.recorded()[i], r.recorded()[i]).worst() < 1e-9);
  setup = Setup();
  setup.every_change = 1;
  CHECK(compare(solve(p, setup), r).worst() < 1e-9);
  setup = Setup();
  setup.advance_mu = 0.5;
  setup.advance_loads = {1, -1, 0.5};
  setup.advance_second = {0, 0, 0};
  const Result calls = solve(p, setup);
  CHECK(compare(calls.recorded()[1], r.recorded()[4]).worst() < 1e-9);
  CHECK(compare(calls.recorded()[2], r.recorded()[5]).worst() < 1e-9);
}

TEST_CASE("let go: saved in the air, restored in another process, the same bits") {
  runs::Deck deck;
  for (const std::string& line : test::lines_of(hard("W3_lifted_free_in_x_1-116"))) deck.lines.push_back(line);
  struct Life {
    runs::RamStore& store;
    c2d_port port = C2D_INIT(c2d_port);
    std::unique_ptr<runs::Machine> machine;
    Life(const runs::Deck& deck, runs::RamStore& there) : store(there) {
      store.serve(port);
      const host::Limits limits = deck.limits();
      uint64_t minimum = 0, in_core = 0;
      REQUIRE(c2d_memory_need(&limits, &minimum, &in_core, nullptr) == C2D_OK);
      machine.reset(new runs::Machine(limits, in_core, &port));
      REQUIRE(machine->created == C2D_OK);
      REQUIRE(runs::read_deck(machine->solver, deck) == C2D_OK);
    }
    std::vector<double> go(double load) const {
      c2d_outcome outcome = C2D_NO_ADMISSIBLE_CHANGE;
      REQUIRE(c2d_advance(machine->solver, &load, 1, &outcome) == C2D_OK);
      CHECK(outcome == C2D_REACHED);
      std::vector<double> all;
      for (int32_t field : {C2D_TN, C2D_TT, C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2, C2D_SLIP_SUM}) {
        double row[3];
        REQUIRE(c2d_get(machine->solver, field, 0, 1, 3, row, 1) == C2D_OK);
        all.insert(all.end(), row, row + 3);
      }
      return all;
    }
  };
  runs::RamStore store;
  const double mu = 0.3;
  std::vector<double> expected;
  {
    const Life first(deck, store);
    REQUIRE(c2d_prepare(first.machine->solver) == C2D_OK);
    REQUIRE(c2d_begin(first.machine->solver, &mu, 1) == C2D_OK);
    first.go(0.7);
    first.go(-0.3);
    REQUIRE(c2d_save(first.machine->solver) == C2D_OK);
    for (double load : {-0.5, 0.4}) {
      const std::vector<double> row = first.go(load);
      expected.insert(expected.end(), row.begin(), row.end());
    }
  }
  const Life second(deck, store);
  REQUIRE(c2d_restore(second.machine->solver) == C2D_OK);
  std::vector<double> again;
  for (double load : {-0.5, 0.4}) {
    const std::vector<double> row = second.go(load);
    again.insert(again.end(), row.begin(), row.end());
  }
  CHECK(again == expected);
}

TEST_CASE("let go: a free body that touches without any force is told") {
  const Result r = solve(from_text(hard("unloaded_under_a_moved_body")));
  REQUIRE(told(r) != nullptr);
  CHECK(std::string(told(r)->text).find("position of body 1 in any of its 3 free motions") != std::string::npos);
  CHECK_FALSE(solve(with_paths(block(3, 0.5), {{2, 1, 0}})).warned(C2D_WARN_UNDEFINED_PLACE));
}

TEST_CASE("let go: a pair that slid along without force stays behind when the other body moves away") {
  const Result r = solve(drawn(9)); // two pairs on a slope that a shrinking load pushes one of them along
  REQUIRE(r.outcome == C2D_REACHED);
  const std::vector<Step> rows = r.recorded();
  REQUIRE(rows.size() == 6);
  CHECK(no_force(rows[3]));
  CHECK(std::fabs(mean_sideways(rows[3]) - mean_sideways(rows[2])) < 0.01); // with it, it would go on by 9.4
}

TEST_CASE("let go: a light body under which its table is pulled away stays on it, however small its pressures are") {
  Problem p = block(3, 0); // held sideways at its top, by nothing else: 1e-6 of weight, and a table that moves by 100
  for (End& end : p.bodies[0].second_case)
    if (end.codes[2] == 0) end.values[2] = 100;
  for (size_t i = 0; i < p.bodies[1].ends.size(); ++i) {
    End& end = p.bodies[1].ends[i];
    End& second = p.bodies[1].second_case[i];
    second.values[0] = 0;
    if (end.codes[3] != 0) continue;
    end.codes[3] = second.codes[3] = 1, end.codes[1] = second.codes[1] = 0;
    end.codes[2] = second.codes[2] = 0, end.codes[0] = second.codes[0] = 1;
    end.values[3] = 0, end.values[1] = -1e-6;
  }
  const Result r = solve(with_paths(p, {{1, 1, 0}, {1, 1, 0.5}, {1, 1, 1}}));
  REQUIRE_MESSAGE(r.outcome == C2D_REACHED, r.messages());
  CHECK(told(r) == nullptr);
  for (const Step& s : r.recorded())
    for (int i = 0; i < s.pairs(); ++i) CHECK(std::fabs(s.at(i, C2D_TN) - r.recorded()[0].at(i, C2D_TN)) < 1e-10);
}
