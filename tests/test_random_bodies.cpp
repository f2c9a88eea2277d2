// A draw of random models of three bodies (more of them: make random KIND=three), and that their judge sees what is wrong.
#include "random/three_bodies.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace random_decks;

TEST_CASE("random bodies: a draw of three") {
  int reached = 0, slipped = 0, tied = 0, rigid = 0;
  for (uint64_t seed = 1; seed <= 30; ++seed) {
    const Verdict v = judge_three(seed);
    std::string all;
    for (const std::string& f : v.findings) all += "\n" + f;
    CHECK_MESSAGE(v.findings.empty(), "make random N=1 KIND=three SEED=" << seed << ": " << v.title << all);
    reached += v.status == C2D_OK && v.outcome == C2D_REACHED;
    std::string title;
    const many::Model m = generate_three(seed, title);
    for (const many::Zone& z : m.zones) tied += (z.kind & C2D_ZONE_TIED) != 0;
    for (const many::Body& b : m.bodies) rigid += b.rigid;
    const many::Result r = many::solve(m);
    if (!r.steps.empty()) slipped += r.last().dissipated > 0;
  }
  CHECK(reached > 20); // or the draw says little
  CHECK(slipped > 10);
  CHECK(tied > 5);
  CHECK(rigid > 2);
}

TEST_CASE("random bodies: what is wrong is seen") {
  std::string title;
  uint64_t seed = 1;
  many::Model m;
  many::Result r;
  const auto has = [&](int status) {
    for (const many::Row& row : r.last().rows)
      if (row[C2D_STATUS] == status) return true;
    return false;
  };
  do { // one that opens, sticks and slips, with a tie
    m = generate_three(seed++, title);
    r = many::solve(m);
  } while (seed < 500 && (r.steps.empty() || r.outcome != C2D_REACHED || !has(C2D_OPEN) || !has(C2D_STICK) || !has(C2D_SLIP) ||
                          !has(C2D_TIED)));
  REQUIRE(seed < 500);
  CHECK(many::breach(m, r) == "");
  double pressure = 0;
  for (const many::Row& row : r.last().rows) pressure = std::max(pressure, row[C2D_TN]);
  const auto spoiled = [&](int status, size_t field, double step) {
    many::Result wrong = r;
    for (many::Row& row : wrong.steps.back().rows)
      if (row[C2D_STATUS] == status) {
        row[field] += step;
        break;
      }
    return many::breach(m, wrong);
  };
  const auto holds = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  CHECK(holds(spoiled(C2D_OPEN, C2D_TN, 1e-6 * pressure), "an open pair carries a force"));
  CHECK(holds(spoiled(C2D_OPEN, C2D_GAP, -1e9), "overlap"));
  CHECK(holds(spoiled(C2D_STICK, C2D_TN, -2 * pressure), "a pair pulls"));
  CHECK(holds(spoiled(C2D_STICK, C2D_GAP, 1e9), "a closed pair gapes"));
  CHECK(holds(spoiled(C2D_SLIP, C2D_TN, 1e-3 * pressure), "a slipping pair is not on the cone"));
  CHECK(holds(spoiled(C2D_TIED, C2D_STATUS, -2), "a tie and its status"));
  CHECK(many::difference(r, r) == 0);
  many::Result other = r;
  other.steps.back().rows.back()[C2D_TN] += 1e-3 * pressure;
  CHECK(many::difference(r, other) > 1e-4);
  other = r;
  for (c2d_body_result& b : other.bodies) b.contact[0] += 1e-3 * pressure;
  CHECK(many::imbalance(m, other) > 1e-5);
}
