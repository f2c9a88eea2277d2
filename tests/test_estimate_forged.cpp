// The search for a mesh with solutions that no small model has: kept meshes, changed.
#include "shell.hpp"
#include "sketches.hpp"

#include "program/commands/archive.hpp"
#include "program/estimate/kept.hpp"
#include "program/estimate/positions.hpp"
#include "program/estimate/wanted.hpp"
#include "program/files/sealed_file.hpp"

#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

// A rigid cylinder on a block.
std::string pressed(const std::string& more) {
  return "body block E 1 nu 0.3\nfrom -1 -2\nline bottom to 1 -2\nline right to 1 0\nline top to -1 0\nline left close\n"
         "body cylinder rigid\nfrom -0.3 {1-sqrt(0.91)}\narc face to 0.3 {1-sqrt(0.91)} radius 1\nline right to 0.3 0.5\n"
         "line above to -0.3 0.5\nline left close\ncontact block.top cylinder.face mu 0.3\ncase normal\n"
         "platen block.bottom about 0 -2 fx 0 fy {pi/400} turn 0\nsteps 2\n" +
         more;
}

class Search {
public:
  explicit Search(const std::string& text) : sketch_(sound(text)) {
    whole_ = run();
    while (test::fs::exists(mesh(meshes_ + 1))) ++meshes_;
    for (size_t k = 1; k <= meshes_; ++k) files_.push_back(test::read_file(mesh(k)));
  }
  size_t meshes() const { return meshes_; }
  const estimate::Adapted& whole() const { return whole_; }
  estimate::Adapted run() {
    estimate::Demand demand;
    estimate::ask(sketch_, demand);
    estimate::TrialKeeper keeper;
    keeper.begin(folder_ / ".", "job", 0);
    return estimate::adapt_positions(
        sketch_, demand, [](const app::MeshRound&) {}, &keeper);
  }
  // With the k-th mesh, from 1, changed.
  template <class Change> estimate::Adapted with(size_t k, Change change) {
    for (size_t i = 0; i < meshes_; ++i) test::write_file(mesh(i + 1), files_[i]);
    return and_with(k, change);
  }
  template <class Change> estimate::Adapted and_with(size_t k, Change change) { // and those changed before
    std::string text, error, job, deck;
    REQUIRE(app::read_sealed(mesh(k), "contact2d mesh 4", text, error) == app::Sealed::kWhole);
    app::ArchiveReader reader(text);
    reader(job), reader(deck);
    estimate::TrialKeeper keeper;
    keeper.begin(folder_ / ".", job, 0);
    estimate::Trial trial, ignored;
    for (size_t i = 1; i < k; ++i) keeper.recall("", ignored);
    REQUIRE(keeper.recall(deck, trial));
    change(trial);
    REQUIRE(keeper.keep(deck, trial));
    return run();
  }

private:
  std::string mesh(size_t k) const { return folder_ / ("mesh" + std::to_string(k)); }
  const test::Folder folder_;
  Sketch sketch_;
  estimate::Adapted whole_;
  size_t meshes_ = 0;
  std::vector<std::string> files_;
};

void end_early(estimate::Trial& t, c2d_outcome outcome) {
  t.outcome = outcome;
  t.why = c2d_outcome_message(outcome);
}

} // namespace

TEST_CASE("estimate, forged: a finer mesh on which the arithmetic fails leaves the results of the one before") {
  Search search(pressed("want pressure 0.5 % edges\nlimit elements 200\n"));
  REQUIRE(search.meshes() >= 4);
  for (const c2d_outcome outcome : {C2D_NO_ADMISSIBLE_CHANGE, C2D_NO_PROGRESS, C2D_UNDECIDED, C2D_BEYOND_LIMITS}) {
    CAPTURE(outcome);
    const estimate::Adapted a = search.with(3, [&](estimate::Trial& t) { end_early(t, outcome); });
    CHECK(a.loop.stopped == "on the next mesh the history ended early: " + std::string(c2d_outcome_message(outcome)));
    CHECK(a.loop.rounds.size() == 2);
    CHECK(a.loop.taken == 1);
  }
}

TEST_CASE("estimate, forged: a history that ends before its first state has no numbers, and says why") {
  for (const char* wants : {"want pressure edges hoop block.top stress at block 0 -0.5\n",
                            "want approach at block 0 -0.5 block 0 -1 forces hoop block.top+right\n",
                            "want pressure at block.top 0 0 width dissipation\n"}) {
    CAPTURE(wants);
    Search search(pressed(wants + std::string("limit elements 200\n")));
    for (size_t k = 1; k <= std::min<size_t>(4, search.meshes()); ++k) {
      CAPTURE(k);
      const estimate::Adapted a = search.with(k, [&](estimate::Trial& t) {
        end_early(t, C2D_FREE_MOTION);
        t.states.clear();
      });
      CHECK(a.status == C2D_OK);
      const bool is_last = k % 2 == 0 && a.loop.rounds.size() == k;
      if (is_last) CHECK(a.loop.stopped.find("the history ended early: ") == 0);
      for (const app::Stated& s : a.loop.stated)
        if (is_last) CHECK(!(s.confirmed && s.error <= s.tolerance * s.scale));
    }
  }
}

TEST_CASE("estimate, forged: stresses out of the plane, of a cycle and fatigue need a history that reaches them") {
  const std::string tube =
      "axisymmetric\nbody b E 1 nu 0.3\nfrom 1 0\nline s to 2 0\nline e to 2 1\nline n to 1 1\nline w close\n"
      "fix b.s y\npressure b.w {1+y}\nsteps 1\nwant hoop b.e stress at b 1.5 0.5\nlimit elements 100\n";
  std::string sheared =
      pressed("case shear\nplaten block.bottom about 0 -2 x 0.01\nhistory normal 1; shear 0.1, -0.1, 0.1\n"
              "want fatigue ruiz1 block.top fatigue swt block.top fatigue swt block 0 -0.5\n"
              "want fatigue swt block.top depth 0.1 cycle range stress at block 0 -0.5 cycle range hoop block.top\n"
              "limit elements 150\n");
  sheared.replace(sheared.find("fx 0 fy"), 4, "x 0");
  for (const std::string& text : {tube, sheared})
    for (const int left_out : {0, 1, 2}) {
      CAPTURE(text);
      CAPTURE(left_out);
      Search search(text);
      REQUIRE(search.meshes() >= 2);
      for (size_t k = 1; k <= 2; ++k) {
        const estimate::Adapted a = search.with(k, [&](estimate::Trial& t) {
          end_early(t, C2D_GROSS_SLIDING);
          if (left_out > 0) t.cycle.clear();
          if (left_out > 1) t.states.clear();
        });
        CHECK(a.status == C2D_OK);
        const bool is_last = a.loop.stopped.find("the history ended early: ") == 0; // no later mesh took its place
        for (const app::Stated& number : a.loop.stated)
          if (is_last) CHECK(!number.confirmed);
      }
    }
}
