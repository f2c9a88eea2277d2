// The positions of moving loads and the derivatives by parameters where a run is resumed, interrupted, or cannot go on.
#include "refused_calls.hpp"
#include "shell.hpp"
#include "sketches.hpp"
#include "system_calls.hpp"

#include "program/estimate/kept.hpp"
#include "program/estimate/positions.hpp"
#include "program/estimate/tolerances.hpp"
#include "program/estimate/wanted.hpp"
#include "program/interrupt.hpp"

#include <cmath>
#include <csignal>

using namespace sketch;
using namespace sketches;

namespace {

// A load that passes over a block; `load` is centred on x = 0 at the start.
std::string passing(const std::string& more, const std::string& load = "pressure b.n {exp(-(2*x)^2)}",
                    const std::string& travel = "travel 2 0 positions 3") {
  return "parameter E 10 +- 1 %\nbody b E E nu 0.3\nfrom -1 -1\nline s to 3 -1\nline e to 3 0\nline n to -1 0\nline w close\n"
         "fix b.s\ncase roll " +
         travel + "\n" + load + "\nhistory roll 1; roll to 1\nsteps 1\n" + more;
}

struct Found {
  estimate::Adapted adapted;
  app::ToleranceTable tolerances;
  std::string error; // of what keeps the meshes
};
// As a run does. `by`: the folder that keeps meshes.
Found find(const std::string& text, const std::string& by = "") {
  Found out;
  estimate::Demand demand;
  const Sketch s = sound(text);
  estimate::ask(s, demand);
  estimate::TrialKeeper keeper;
  if (!by.empty()) keeper.begin(by, "job", 0);
  out.adapted = estimate::adapt_positions(
      s, demand, [](const app::MeshRound&) {}, by.empty() ? nullptr : &keeper);
  if (!out.adapted.sketch.tolerances.empty() && out.adapted.loop.ran())
    out.tolerances = estimate::tolerances_of(
        {out.adapted.sketch, out.adapted.mesh, out.adapted.trial}, out.adapted.loop.stated,
        [&](const Parameters& p) { return sketches::read(text, p); }, demand, by.empty() ? nullptr : &keeper);
  out.error = keeper.error();
  return out;
}

// The same numbers with the same errors, bit by bit, and the same derivatives.
void check_alike(const Found& a, const Found& b) {
  const auto text = [](app::MeshLoop loop) {
    for (app::MeshRound& round : loop.rounds) round.seconds = 0;
    return estimate::text_of(std::move(loop));
  };
  CHECK(text(a.adapted.loop) == text(b.adapted.loop));
  REQUIRE(a.tolerances.numbers.size() == b.tolerances.numbers.size());
  for (size_t i = 0; i < a.tolerances.numbers.size(); ++i)
    CHECK(a.tolerances.numbers[i].by[0].derivative == b.tolerances.numbers[i].by[0].derivative);
}

} // namespace

TEST_CASE("estimate, kept: positions of a moving load and derivatives are the same from meshes that are kept") {
  const test::Folder folder;
  const std::string text = passing("want approach at b 1 -0.2 b 1 -0.9 20 %\nlimit elements 300\n");
  const Found plain = find(text), first = find(text, folder / "."), second = find(text, folder / ".");
  CHECK(plain.adapted.loop.positions >= 12);
  CHECK(plain.adapted.loop.stopped == "");
  CHECK(first.error.empty());
  check_alike(plain, first);
  check_alike(first, second);
  // A displacement is as 1/E.
  CHECK(plain.tolerances.numbers.size() == 2);
  for (const app::Toleranced& t : plain.tolerances.numbers) {
    CHECK(t.by[0].why == "");
    CHECK(t.by[0].derivative == doctest::Approx(-t.number.value / 10).epsilon(1e-3));
  }
  // Where each mesh cannot be kept the search ends there; what came before is not solved again.
  size_t kept = 0;
  while (test::fs::exists(folder / ("mesh" + std::to_string(kept + 1)))) ++kept;
  CHECK(kept > 6);
  for (size_t k = 1; k <= kept; ++k) {
    CAPTURE(k);
    const std::string name = folder / ("mesh" + std::to_string(k));
    test::fs::remove(name);
    test::fs::create_directory(name); // no file can be written in its place
    test::write_file(name + "/a", "");
    const Found stopped = find(text, folder / ".");
    CHECK(stopped.error.find("mesh" + std::to_string(k)) != std::string::npos);
    test::fs::remove_all(name);
    check_alike(plain, find(text, folder / "."));
  }
}

TEST_CASE("estimate, kept: a mesh that cannot be solved ends the search with its reason") {
  if (!test::can_refuse_calls()) return;
  const std::string text = passing("want approach at b 1 -0.2 b 1 -0.9 20 %\nlimit elements 300\n");
  test::refuse_call(0);
  const Found whole = find(text);
  const std::vector<int64_t> solutions = test::calls_of("c2d_prepare");
  const size_t meshes = whole.adapted.loop.rounds.size();
  REQUIRE(solutions.size() > meshes + 4);
  size_t first = 0;
  for (size_t k = 0; k < solutions.size(); ++k) {
    CAPTURE(k);
    test::refuse_call(solutions[k]);
    const Found found = find(text);
    CHECK(std::string(test::call_refused()) == "c2d_prepare");
    const app::MeshLoop& loop = found.adapted.loop;
    if (k < solutions.size() - 4 && loop.stopped.empty()) { // the search for the first positions can be done without
      ++first;
      CHECK(found.adapted.status == C2D_OK);
      for (const app::Stated& number : loop.stated) CHECK(number.is_met());
    } else if (k < solutions.size() - 4) {
      CHECK(loop.stopped.find(c2d_message(C2D_ERR_STATE)) == 0);
    }
    if (k >= solutions.size() - 4) { // two differences by the parameter
      CHECK(loop.stopped.empty());
      const char* const values[] = {"10.1", "9.9", "10.05", "9.95"};
      CHECK(found.tolerances.parameters[0].why ==
            std::string("with E = ") + values[k + 4 - solutions.size()] + ": " + c2d_message(C2D_ERR_STATE));
    }
  }
  CHECK(first + 6 < solutions.size());
  test::refuse_call(0);
}

TEST_CASE("estimate, kept: a signal ends the search wherever it comes, and what is kept is not solved again") {
  if (!test::can_judge_calls()) return;
  const std::string text = passing("want approach at b 1 -0.2 b 1 -0.9 20 %\nlimit elements 300\n");
  const test::Folder folder;
  const Found plain = find(text);
  int ended = 0;
  for (int n = 1;; ++n) {
    CAPTURE(n);
    for (const std::string& name : folder.names()) test::fs::remove(folder / name);
    app::catch_interrupts();
    Found stopped;
    bool is_over = false;
    {
      const test::System system("rename", [&, count = 0]() mutable {
        if (++count == n) std::raise(SIGINT);
        return int(test::kDone);
      });
      stopped = find(text, folder / ".");
      is_over = system.calls() < n;
    }
    CHECK(app::interrupted() != is_over);
    app::put_off_interrupt(), app::put_off_interrupt(); // the second one forgets it
    if (is_over) break;
    const bool is_said = stopped.adapted.loop.stopped.find("the search was interrupted") != std::string::npos ||
                         stopped.tolerances.why == "the search was interrupted" || stopped.tolerances.numbers.empty();
    CHECK(is_said);
    ++ended;
    check_alike(plain, find(text, folder / "."));
  }
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_DFL);
  CHECK(ended > 6);
}
