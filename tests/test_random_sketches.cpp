// A draw of random sketches (more of them: make estimate), and that their judge sees what is wrong.
#include "effort.hpp"
#include "random/children.hpp"
#include "random/sketch_judge.hpp"
#include "random/sketches.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <csignal>
#include <string>
#include <vector>

using namespace random_sketches;

namespace {

constexpr Limits kSmall = {300, 0, 420}; // without a limit of time: the same on every machine
// Half a punch, a press fit, a wedge on a bonded layer, half a roller, a parabola; a spline and a flat with fillets that stop
// at the limit of elements; two feet that slide off.
constexpr uint64_t kSeeds[] = {3, 4, 20, 39, 56, 6, 52, 119};

constexpr uint64_t kRevolved[] = {10, 9, 12, 1, 2}; // the first always, the others in full

} // namespace

TEST_CASE("random sketches: no fault, none ends without a word, and what was met is within its stated error") {
  size_t compared = 0;
  for (const uint64_t seed : kSeeds) {
    CAPTURE(seed);
    const Drawn drawn = draw(seed);
    CAPTURE(drawn.scene);
    const Judged j = judge(drawn.text, kSmall);
    CHECK(j.fault == "");
    CHECK(j.failure == "");
    CHECK(j.silent == "");
    CHECK(j.elements > 0);
    for (const Compared& c : j.numbers) {
      ++compared;
      if (!j.stopped.empty() || std::isnan(c.stated.tolerance)) continue;
      CAPTURE(c.stated.name());
      CHECK(c.off <= c.stated.tolerance * c.stated.scale); // what was asked for
    }
  }
  CHECK(compared > 50); // or the draw says little
}

TEST_CASE("random sketches: of revolution") {
  size_t compared = 0;
  std::string scenes;
  for (uint64_t seed = 1; seed < 40; ++seed) scenes += draw_revolved(seed).scene + ", ";
  for (const char* kind : {"of revolution", "half drawn", "press fit", "round", "flat rounded"})
    CHECK_MESSAGE(scenes.find(kind) != std::string::npos, kind);
  for (const uint64_t seed : kRevolved) {
    if (seed != kRevolved[0] && !test::in_full()) break;
    CAPTURE(seed);
    const Drawn drawn = draw_revolved(seed);
    CAPTURE(drawn.scene);
    const Judged j = judge(drawn.text, kSmall);
    CHECK(j.fault == "");
    CHECK(j.failure == "");
    CHECK(j.silent == "");
    for (const Compared& c : j.numbers) {
      if (!j.stopped.empty() || std::isnan(c.stated.tolerance)) continue;
      ++compared;
      CAPTURE(c.stated.name());
      CHECK(c.off <= c.stated.tolerance * c.stated.scale);
    }
  }
  CHECK(compared > 2);
}

// Slip without friction that two meshes had at one node; a moment that a tie does not have.
TEST_CASE("random sketches: what was stated far too small") {
  constexpr Limits kTruth = {300, 0, 500};
  const struct {
    uint64_t seed;
    const char* name;
  } kinds[] = {{273, "slip range"}, {315, "moment"}};
  for (const auto& kind : kinds) {
    CAPTURE(kind.seed);
    const Judged j = judge(draw(kind.seed).text, kTruth);
    CHECK(j.stopped == "");
    size_t compared = 0;
    for (const Compared& c : j.numbers) {
      if (c.stated.name() != kind.name) continue;
      ++compared;
      CAPTURE(c.off);
      CHECK((c.off <= 1e-6 * c.stated.scale || c.ratio() >= 0.8));
    }
    CHECK(compared > 0);
  }
}

// Friction that acts in slip zones of few pairs, at edges that advance.
TEST_CASE("random sketches: what friction dissipates is not stated far too small where few pairs slip") {
  size_t compared = 0;
  for (const uint64_t seed : {5, 7, 10, 45, 72}) {
    CAPTURE(seed);
    for (const Compared& c : judge(draw_revolved(seed).text, {300, 10, 700}).numbers) {
      if (c.stated.what != app::Measure::kDissipated) continue;
      ++compared;
      CHECK((c.off <= 1e-6 * c.stated.scale || c.ratio() >= 0.8));
    }
  }
  CHECK(compared > 6);
}

TEST_CASE("random sketches: a seed is one text, and all kinds are drawn") {
  CHECK(draw(7).text == draw(7).text);
  CHECK(draw(7).text != draw(8).text);
  std::string scenes;
  for (uint64_t seed = 1; seed < 200; ++seed) scenes += draw(seed).scene + ", ";
  for (const char* kind : {"sharp punch", "flat with fillets", "round",         "parabola",       "spline",     "flat rounded",
                           "blunt wedge", "two feet",          "pin in a hole", "press fit",      "crack",      "bonded layer",
                           "loose layer", "half drawn",        "hole",          "crowned ground", "rigid body", "plane stress",
                           "quadratic",   "reversal",          "unloading",     "moment",         "moved"})
    CHECK_MESSAGE(scenes.find(kind) != std::string::npos, kind);
}

TEST_CASE("random sketches: the judge sees faults and errors stated too small") {
  CHECK(judge("body b E 1 nu 0\nfrom 0 0\nline a to 1 0\n", kSmall).fault.find("line") == 0);
  Compared c;
  c.stated.value = c.stated.scale = 2, c.stated.error = 0.01, c.truth = 2.02, c.off = 0.02;
  CHECK(c.is_wrong());
  CHECK(c.ratio() == doctest::Approx(0.5));
  c.stated.error = 0.03;
  CHECK(!c.is_wrong());
}

TEST_CASE("random sketches: a process that ends by a signal is told, the next one goes on behind it") {
  std::vector<std::string> heard;
  random_work::Work work;
  work.judge = [](uint64_t seed, FILE* out) {
    if (seed == 5 || seed == 7) std::raise(SIGKILL);
    random_work::say(out, "count", "a\nb");
  };
  work.heard = [&](const std::string& word, const std::string& rest) { heard.push_back(word + " " + rest); };
  work.died = [&](uint64_t seed, int signal) {
    heard.push_back("died " + std::to_string(seed) + " by " + std::to_string(signal));
  };
  random_work::run_all(4, 8, work);
  CHECK(heard == std::vector<std::string>{"begin 4", "count a b", "end 4", "begin 5", "died 5 by 9", "begin 6", "count a b",
                                          "end 6", "begin 7", "died 7 by 9"});
}
