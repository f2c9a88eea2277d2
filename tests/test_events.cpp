// Events, exchanges, pivots off the diagonal and rebuilding on tableaux made by hand of one to five pairs. Every expected
// number is worked out in the comment above it: sticking, (p, q) = K (w_n - gap, w_t) + lambda b; open, p = q = 0; slipping,
// w_n = 0 and q = sign mu p.
#include "hand_tableau.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <vector>

using namespace c2d;
using hand::Change;
using hand::Hand;
using hand::sized;

namespace {

doctest::Approx about(double value) { return doctest::Approx(value).epsilon(1e-12).scale(1.0); }

void check_tableau(const Hand& h, const std::vector<std::vector<double>>& rows) { // T, then the constant, then the rates
  for (size_t i = 0; i < rows.size(); ++i)
    for (size_t j = 0; j < rows[i].size(); ++j) {
      CAPTURE(i);
      CAPTURE(j);
      CHECK(h.entry(static_cast<int>(i), static_cast<int>(j)) == about(rows[i][j]));
    }
}

// K = (4 1; 2 3), det 10, b = (1, 2), mu = 0.5.
Hand* one_pair() {
  Hand* h = new Hand({{4, 1}, {2, 3}}, {{1, 2}}, true, 0.5);
  REQUIRE(h->build() == C2D_OK);
  return h;
}

// K^-1 = (0.3 -0.1; -0.2 0.4), -K^-1 b = (-0.1, -0.6).
const std::vector<std::vector<double>> kStick = {{4, 1, 0, 1}, {2, 3, 0, 2}},
                                       kOpen = {{0.3, -0.1, 0, -0.1}, {-0.2, 0.4, 0, -0.6}},
                                       // r = q - p/2 = 0 w_n + 2.5 w_t + 1.5; w_t = 0.4 r - 0.6; p = 4 w_n + w_t + 1
    kSlipPlus = {{4, 0.4, 0, 0.4}, {0, 0.4, 0, -0.6}},
                                       // r = q + p/2 = 4 w_n + 3.5 w_t + 2.5; w_t = (r - 4 w_n - 2.5) / 3.5
    kSlipMinus = {{20.0 / 7, 2.0 / 7, 0, 2.0 / 7}, {-8.0 / 7, 2.0 / 7, 0, -5.0 / 7}};

const std::vector<std::vector<double>>& tableau_of(int32_t status, int32_t sign) {
  if (status == C2D_STICK) return kStick;
  if (status == C2D_OPEN) return kOpen;
  return sign > 0 ? kSlipPlus : kSlipMinus;
}

} // namespace

TEST_CASE("exchanges: each status of one pair, from each other, is the system solved for other unknowns") {
  const struct { int32_t status, sign; } states[] = {{C2D_OPEN, 0}, {C2D_STICK, 0}, {C2D_SLIP, 1}, {C2D_SLIP, -1}};
  for (const auto& from : states)
    for (const auto& to : states) {
      CAPTURE(from.status);
      CAPTURE(from.sign);
      CAPTURE(to.status);
      CAPTURE(to.sign);
      const std::unique_ptr<Hand> h(one_pair());
      REQUIRE(change_status(h->tableau(), 0, from.status, from.sign, 0.0));
      check_tableau(*h, tableau_of(from.status, from.sign));
      REQUIRE(change_status(h->tableau(), 0, to.status, to.sign, 0.0));
      check_tableau(*h, tableau_of(to.status, to.sign));
      CHECK(h->pair(0).status == to.status);
      CHECK(h->pair(0).sign == to.sign);
    }
}

// Sticking at w_t = 0.25 the forces are K (0, 0.25) = (0.25, 0.75) more. Open and slipping, w_t counts from zero again.
TEST_CASE("exchanges: a pair that sticks where it has come to keeps the forces of that place, and loses them when it lets go") {
  for (const int32_t status : {C2D_OPEN, C2D_SLIP}) {
    CAPTURE(status);
    const std::unique_ptr<Hand> h(one_pair());
    const int32_t sign = status == C2D_SLIP ? 1 : 0;
    REQUIRE(change_status(h->tableau(), 0, status, sign, 0.0));
    REQUIRE(change_status(h->tableau(), 0, C2D_STICK, 0, 0.25));
    check_tableau(*h, {{4, 1, 0.25, 1}, {2, 3, 0.75, 2}});
    CHECK(h->pair(0).offset == 0.25);
    REQUIRE(change_status(h->tableau(), 0, status, sign, 0.0));
    check_tableau(*h, tableau_of(status, sign));
  }
}

// Whichever slot is exchanged first, alone in the list or behind others, of this pair or of the next, and wherever it touched.
TEST_CASE("exchanges: a pair that slips where it has just stuck has the tableau of its status") {
  for (const double normal : {5.0, 2.0}) // stiffer across, and along
    for (int before = 0; before < 4; ++before)
      for (const int sign : {1, -1}) {
        CAPTURE(normal);
        CAPTURE(before);
        CAPTURE(sign);
        Hand h({{normal, 1, 0.5, 0.2}, {2, 3, 0.1, 0.3}, {0.4, 0.2, 5, 1}, {0.1, 0.7, 0.3, 4}}, {{1, 2, 3, 4}, {-4, 3, 2, -1}},
               true, 0.5);
        h.pair(0).status = C2D_OPEN;
        REQUIRE(h.build() == C2D_OK);
        if (before == 1) REQUIRE(change_status(h.tableau(), 1, C2D_SLIP, 1, 0.0));
        if (before == 2) REQUIRE(change_status(h.tableau(), 1, C2D_OPEN, 0, 0.0));
        if (before == 3)
          REQUIRE((change_status(h.tableau(), 0, C2D_SLIP, 1, 0.0) && change_status(h.tableau(), 0, C2D_OPEN, 0, 0.0)));
        REQUIRE(change_status(h.tableau(), 0, C2D_STICK, 0, 0.25));
        REQUIRE(change_status(h.tableau(), 0, C2D_SLIP, sign, 0.0));
        std::vector<double> went;
        for (int at = 0; at < 4 * 7; ++at) went.push_back(h.entry(at % 4, at / 4));
        for (int slot = 0; slot < 4; ++slot) {
          CHECK(own_entry(h.tableau(), slot) == about(h.entry(slot, slot)));
          CHECK(cross_entry(h.tableau(), slot, slot ^ 1) == about(h.entry(slot, slot ^ 1)));
        }
        REQUIRE(h.build() == C2D_OK);
        for (int at = 0; at < 4 * 7; ++at) CHECK(went[sized(at)] == about(h.entry(at % 4, at / 4)));
      }
}

// K = (4 2; 1 3), b = (8, 6): w_1 = p_1/4 - w_2/2 - 2, p_2 = w_1 + 3 w_2 + 6 = p_1/4 + 2.5 w_2 + 4.
TEST_CASE("exchanges: one of two pairs opens, and the other's row goes along") {
  Hand h({{4, 2}, {1, 3}}, {{8, 6}}, false, 0.0);
  REQUIRE(h.build() == C2D_OK);
  REQUIRE(change_status(h.tableau(), 0, C2D_OPEN, 0, 0.0));
  check_tableau(h, {{0.25, -0.5, 0, -2}, {0.25, 2.5, 0, 4}});
  REQUIRE(change_status(h.tableau(), 0, C2D_STICK, 0, 0.0));
  check_tableau(h, {{4, 2, 0, 8}, {1, 3, 0, 6}});
}

// K = (4 2; 2 1): det 0, and 1 - 0.5 * 2 = 0. Neither opening nor slipping with friction along + leaves anything to hold w_t.
TEST_CASE("exchanges: a change that would leave a motion free is refused, and nothing has changed") {
  Hand h({{4, 2}, {2, 1}}, {{1, 1}}, true, 0.5);
  REQUIRE(h.build() == C2D_OK);
  CHECK_FALSE(change_status(h.tableau(), 0, C2D_OPEN, 0, 0.0));
  CHECK_FALSE(change_status(h.tableau(), 0, C2D_SLIP, 1, 0.0));
  check_tableau(h, {{4, 2, 0, 1}, {2, 1, 0, 1}});
  CHECK(h.pair(0).status == C2D_STICK);
  // The other way: r = q + p/2 = 4 w_n + 2 w_t + 1.5, from there w_t = r/2 - 2 w_n - 0.75, p = 4 w_n + 2 w_t + 1 = r - 0.5.
  REQUIRE(change_status(h.tableau(), 0, C2D_SLIP, -1, 0.0));
  check_tableau(h, {{0, 1, 0, -0.5}, {-2, 0.5, 0, -0.75}});
  CHECK_FALSE(change_status(h.tableau(), 0, C2D_SLIP, 1, 0.0)); // refused half way, behind sticking
  check_tableau(h, {{0, 1, 0, -0.5}, {-2, 0.5, 0, -0.75}});
  CHECK(h.pair(0).sign == -1);
}

// p_1 = 2 w_2 + 8, p_2 = 4 w_1 + 4: w_1 = p_2/4 - 1, w_2 = p_1/2 - 4. The diagonal is zero.
TEST_CASE("pivots: two pairs that hold each other open together, where neither can alone") {
  Hand h({{0, 2}, {4, 0}}, {{8, 4}}, false, 0.0);
  REQUIRE(h.build() == C2D_OK);
  CHECK_FALSE(change_status(h.tableau(), 0, C2D_OPEN, 0, 0.0));
  CHECK_FALSE(change_status(h.tableau(), 1, C2D_OPEN, 0, 0.0));
  for (int i = 0; i < 2; ++i) h.pair(i).status = C2D_OPEN;
  REQUIRE(h.build() == C2D_OK);
  check_tableau(h, {{0, 0.25, 0, -1}, {0.5, 0, 0, -4}});
}

// p_1 = 2 w_2 + 4, p_2 = 4 w_3 + 8, p_3 = 5 w_1 + 10, p_4 = w_4 + w_1 + 3 in contact: w_2 = p_1/2 - 2, w_3 = p_2/4 - 2,
// w_1 = p_3/5 - 2, p_4 = w_4 + p_3/5 + 1. With gaps 1, 2, 3 these are added to w.
TEST_CASE("pivots: three pairs in a ring, with gaps, beside one that stays") {
  Hand h({{0, 2, 0, 0}, {0, 0, 4, 0}, {5, 0, 0, 0}, {1, 0, 0, 1}}, {{4, 8, 10, 3}}, false, 0.0);
  h.start({1, 2, 3, 0});
  check_tableau(h, {{0, 0, 0.2, 0, 1, -2}, {0.5, 0, 0, 0, 2, -2}, {0, 0.25, 0, 0, 3, -2}, {0, 0, 0.2, 1, 0, 1}});
}

// K = (1 1; 1 1): together the two can move without force.
TEST_CASE("pivots: where nothing holds what opens, the tableau names a pair") {
  Hand h({{1, 1}, {1, 1}}, {{1, 1}}, false, 0.0);
  for (int i = 0; i < 2; ++i) h.pair(i).status = C2D_OPEN;
  CHECK(h.build() == C2D_ERR_SINGULAR);
  CHECK((h.culprit == 0 || h.culprit == 1));
  h.pair(0).status = C2D_STICK;
  CHECK(h.build() == C2D_OK);
  check_tableau(h, {{0, 1, 0, 0}, {-1, 1, 0, -1}}); // w_2 = p_2 - w_1 - 1, p_1 = w_1 + w_2 + 1 = p_2
}

// K = (1 c; c 1), c = 1e8: with both open, w_n of one under its own force alone is 1e-16 of what it would be by itself, all
// round-off. Nothing is exchanged there, whatever the other status, with a tangential direction or without.
TEST_CASE("pivots: what round-off alone would hold is not closed, and nothing has changed") {
  const double c = 1e8;
  const auto unchanged = [](Hand& h, int pair, int32_t status, int32_t sign) {
    std::vector<double> before;
    const int m = h.tableau().m;
    for (int at = 0; at < m * (m + 2); ++at) before.push_back(h.entry(at % m, at / m));
    const Pair was = h.pair(pair);
    CHECK_FALSE(change_status(h.tableau(), pair, status, sign, 0.25));
    for (int at = 0; at < m * (m + 2); ++at) CHECK(h.entry(at % m, at / m) == about(before[sized(at)]));
    CHECK(h.pair(pair).status == was.status);
    CHECK(h.pair(pair).sign == was.sign);
  };
  Hand normal({{1, c}, {c, 1}}, {{1, 1}}, false, 0.0);
  for (int i = 0; i < 2; ++i) normal.pair(i).status = C2D_OPEN;
  REQUIRE(normal.build() == C2D_OK);
  unchanged(normal, 0, C2D_STICK, 0);
  unchanged(normal, 0, C2D_SLIP, 1);
  Hand both({{1, 0, c, 0}, {0, 1, 0, c}, {c, 0, 1, 0}, {0, c, 0, 1}}, {{1, 1, 1, 1}}, true, 0.5);
  for (int i = 0; i < 2; ++i) both.pair(i).status = C2D_OPEN;
  REQUIRE(both.build() == C2D_OK);
  unchanged(both, 1, C2D_STICK, 0);
  Hand along({{1, 0, 0, 0}, {0, 1, 0, c}, {0, 0, 1, 0}, {0, c, 0, 1}}, {{1, 1, 1, 1}}, true, 0.5);
  for (int i = 0; i < 2; ++i) along.pair(i).status = C2D_SLIP, along.pair(i).sign = 1;
  REQUIRE(along.build() == C2D_OK);
  unchanged(along, 0, C2D_STICK, 0);
  unchanged(along, 0, C2D_SLIP, -1);
}

TEST_CASE("exchanges: a pair without a tangential direction slides as it sticks") {
  Hand h({{4, 2}, {1, 3}}, {{8, 6}}, false, 0.0);
  REQUIRE(h.build() == C2D_OK);
  REQUIRE(change_status(h.tableau(), 0, C2D_SLIP, 1, 0.0));
  CHECK(h.pair(0).status == C2D_SLIP);
  check_tableau(h, {{4, 2, 0, 8}, {1, 3, 0, 6}});
  REQUIRE(change_status(h.tableau(), 0, C2D_STICK, 0, 0.0));
  CHECK(h.pair(0).status == C2D_STICK);
  check_tableau(h, {{4, 2, 0, 8}, {1, 3, 0, 6}});
}

// Of bodies with free motions that nothing touches there must be as many slots without a pivot as there are motions.
TEST_CASE("pivots: a body that is let go has its free motions, no fewer and no more") {
  Hand held({{4, 1}, {1, 3}}, {{1, 1}}, false, 0.0), looser({{0, 0}, {0, 0}}, {{0, 0}}, false, 0.0);
  for (Hand* h : {&held, &looser}) {
    h->tableau().free_motions = 1;
    for (int i = 0; i < 2; ++i) h->pair(i).status = C2D_OPEN;
    CHECK(h->build() == C2D_ERR_SINGULAR);
  }
}

// Where it touches, pressure grows by 1 and friction by `along` with the load, if it sticks.
TEST_CASE("events: with a list a pair that would slip as soon as it sticks slips at once, by one exchange for three") {
  struct Case {
    double along, mu;
    int32_t status, sign;
  };
  for (const Case& c : {Case{1, 0.1, C2D_SLIP, 1}, Case{-1, 0.1, C2D_SLIP, -1}, Case{1, 0.99, C2D_SLIP, 1},
                        Case{1, 1.01, C2D_STICK, 0}, Case{-1, 2, C2D_STICK, 0}, Case{-1, HUGE_VAL, C2D_STICK, 0}}) {
    CAPTURE(c.mu);
    for (const bool list : {true, false}) {
      const size_t all = 2 * 7; // as many pairs as make rounds of changes
      std::vector<std::vector<double>> k(all, std::vector<double>(all)), b(1, std::vector<double>(all));
      for (size_t i = 0; i < all; i += 2) k[i][i] = 4, k[i][i + 1] = 1, k[i + 1][i] = 2, k[i + 1][i + 1] = 3, b[0][i] = 1;
      b[0][1] = c.along;
      Hand h(k, b, true, c.mu);
      if (!list) h.keep_nothing_back();
      h.start({0.5, 0, 0, 0, 0, 0, 0});
      const int64_t before = h.tableau().exchanges;
      h.follow(10);
      CHECK(h.pair(0).status == c.status);
      CHECK(h.pair(0).sign == c.sign);
      CHECK(h.tableau().exchanges - before == (c.status == C2D_STICK ? 2 : list ? 1 : 3));
      CHECK(h.follower().stats.changes == (c.status == C2D_STICK || list ? 1 : 2));
      // Stuck, or with w_n and q - s mu p none: p is what remains of the load beyond the one at which it touches.
      const double closing = (3 - c.along) / 10, beyond = 10 - 0.5 / closing;
      const double p = beyond * (c.status == C2D_STICK ? 1 : (1 - c.along / 3) / (1 - c.sign * c.mu / 3));
      CHECK(h.state(0).p == about(p));
      CHECK(h.state(0).q == about(c.status == C2D_STICK ? c.along * p : c.sign * c.mu * p));
    }
  }
}

// METHOD 13.7: a guided pair slips, and its tableau is that of a sticking one, in the place where it is.
TEST_CASE("rebuilding: a guided pair is a sticking one in the tableau, and stays what it was") {
  for (const bool list : {true, false}) {
    Hand h({{4, 1}, {2, 3}}, {{1, 2}}, true, 0.5);
    if (!list) h.keep_nothing_back();
    h.pair(0).status = C2D_SLIP, h.pair(0).sign = -1, h.pair(0).offset = 0.25;
    h.tableau().guided = 1;
    REQUIRE(h.build() == C2D_OK);
    check_tableau(h, {{4, 1, 0.25, 1}, {2, 3, 0.75, 2}});
    CHECK(h.pair(0).status == C2D_SLIP);
    CHECK(h.pair(0).sign == -1);
    Follower& f = h.follower(); // its rate is given, and moves the others with it
    f.direction[0] = 1.0, f.guide = -0.5;
    refresh(f);
    CHECK(f.y[1] == 0.25);
    CHECK(f.dy[1] == -0.5);
    CHECK(f.dy[0] == about(1 - 0.5 * 1));
    end_guide(f);
    CHECK(h.pair(0).status == C2D_STICK);
    CHECK(h.tableau().guided == 0);
    CHECK(f.dy[1] == about(2));
  }
}

// K = diag(2, 1), b = (4, 1), gap 0.5, mu = 0.5. Open: w_n = 0.5 - 2 lambda, w_t = -lambda; touches at 0.25. Sticking there:
// p = 4 lambda - 1, q = lambda - 0.25, always below p / 2.
TEST_CASE("events: a gap closes and the pair sticks where it touches") {
  Hand h({{2, 0}, {0, 1}}, {{4, 1}}, true, 0.5);
  h.start({0.5});
  h.follow(0.2);
  CHECK(h.changes.empty());
  CHECK(h.state(0).wn == about(0.1));
  CHECK(h.state(0).wt == about(-0.2));
  h.follow(1.0);
  REQUIRE(h.changes.size() == 1);
  CHECK(h.changes[0].load == about(0.25));
  CHECK(h.pair(0).status == C2D_STICK);
  CHECK(h.pair(0).offset == about(-0.25));
  CHECK(h.state(0).p == about(3));
  CHECK(h.state(0).q == about(0.75));
}

// The same with b = (4, 3), and with b = (4, -3): q would be +-3 (lambda - 0.25), p / 2 is 2 (lambda - 0.25). It slips from the
// first touch on: q = +-p/2, w_t = q -+ 3 lambda, at lambda = 1 -+1.5 and since the touch -+0.75.
TEST_CASE("events: a gap closes and the pair slips at once, either way") {
  for (const int sign : {1, -1}) {
    CAPTURE(sign);
    Hand h({{2, 0}, {0, 1}}, {{4, 3.0 * sign}}, true, 0.5);
    h.start({0.5});
    h.follow(1.0);
    CHECK(h.follower().stats.events == 1);
    CHECK(h.pair(0).status == C2D_SLIP);
    CHECK(h.pair(0).sign == sign);
    CHECK(h.state(0).p == about(3));
    CHECK(h.state(0).q == about(1.5 * sign));
    CHECK(h.state(0).wt == about(-1.5 * sign));
    CHECK(slip_sum(h.follower(), 0) == about(-0.75 * sign));
  }
}

// K = (2 1; 1 2), b_1 = (2, 2), b_2 = (-4, 0), gaps 0 and 0.3. With pair 2 open w_2 = 0.3 - lambda_1, p_1 = lambda_1: touches
// at 0.3; then p = (2 lambda_1 - 0.3, 2 lambda_1 - 0.6). At lambda_1 = 1, p_1 = 1.7 - 4 lambda_2 lifts at 0.425; then w_1 = 2
// (lambda_2 - 0.425), p_2 = 1.4 + w_1.
TEST_CASE("events: of two coupled pairs one touches under the first load and the other lifts under the second") {
  Hand h({{2, 1}, {1, 2}}, {{2, 2}, {-4, 0}}, false, 0.0);
  h.start({0, 0.3});
  h.follow(1.0);
  REQUIRE(h.changes.size() == 1);
  CHECK(h.changes[0].load == about(0.3));
  CHECK(h.changes[0].pair == 1);
  CHECK(h.state(0).p == about(1.7));
  CHECK(h.state(1).p == about(1.4));
  h.follow(1.0, 1.0);
  REQUIRE(h.changes.size() == 1);
  CHECK(h.changes[0].load == about(1.425));
  CHECK(h.changes[0].pair == 0);
  CHECK(h.state(0).wn == about(1.15));
  CHECK(h.state(0).p == 0.0);
  CHECK(h.state(1).p == about(2.55));
}

// Four pairs by themselves, w_n = gap - lambda b: touching at 0.9, 0.2, 0.5 and, by 2 b, at 0.35; the last never.
TEST_CASE("events: the nearest comes first, whatever its number") {
  Hand h({{1, 0, 0, 0, 0}, {0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0, 0, 0, 1, 0}, {0, 0, 0, 0, 1}}, {{1, 1, 1, 2, -1}}, false, 0.0);
  h.start({0.9, 0.2, 0.5, 0.7, 0.1});
  h.follow(1.0);
  const Change expected[] = {{0.2, 1}, {0.35, 3}, {0.5, 2}, {0.9, 0}};
  REQUIRE(h.changes.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(h.changes[i].load == about(expected[i].load));
    CHECK(h.changes[i].pair == expected[i].pair);
  }
  const double p[] = {0.1, 0.8, 0.5, 1.3, 0};
  for (int i = 0; i < 5; ++i) CHECK(h.state(i).p == about(p[i]));
  CHECK(h.state(4).wn == about(1.1));
}

// K = (3 1; 1 3), gaps 0.5, b = (2, 1) + (1, 2): under both loads alike w = gap - K^-1 b lambda = 0.5 - 0.75 lambda for both
// pairs, which touch at 2/3; then p = K (-0.5, -0.5) + 3 lambda = 3 lambda - 2.
TEST_CASE("events: pairs that touch at the same load all touch there, in any order") {
  Hand h({{3, 1}, {1, 3}}, {{3, 3}}, false, 0.0);
  h.start({0.5, 0.5});
  h.follow(1.0);
  for (const Change& c : h.changes) CHECK(c.load == about(2.0 / 3));
  CHECK(h.follower().stats.changes == 2);
  for (int i = 0; i < 2; ++i) CHECK(h.state(i).p == about(1));
}

// Pair 1: K = 1, pressed by the first load to p = 1, drawn by the second: q = lambda_2 reaches p / 2 at 0.5. There pair 2, gap
// 0.5, touches as well. At lambda_2 = 1: q = 0.5, w_t = q - 1, of which all is slip; pair 2 p = 0.5.
TEST_CASE("events: one pair slips and another touches at the same load") {
  Hand h({{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}, {{1, 0, 0, 0}, {0, 1, 1, 0}}, true, 0.5);
  h.start({0, 0.5});
  h.follow(1.0);
  CHECK(h.changes.empty());
  h.follow(1.0, 1.0);
  for (const Change& c : h.changes) CHECK(c.load == about(1.5));
  CHECK(h.follower().stats.changes == 2);
  CHECK(h.pair(0).status == C2D_SLIP);
  CHECK(h.state(0).q == about(0.5));
  CHECK(h.state(0).wt == about(-0.5));
  CHECK(slip_sum(h.follower(), 0) == about(-0.5));
  CHECK(h.pair(1).status == C2D_STICK);
  CHECK(h.state(1).p == about(0.5));
}

// The load turns back: the pair sticks at w_t = -0.5 at once, q = lambda_2 - 0.5 falls to -0.5 at lambda_2 = 0 and it slips the
// other way: w_t = -0.5 - lambda_2, 0 at -0.5, and the slips add up to nothing.
TEST_CASE("events: a pair sticks where the load turns back, and slips back when friction has turned round") {
  Hand h({{1, 0}, {0, 1}}, {{1, 0}, {0, 1}}, true, 0.5);
  h.start({0});
  h.follow(1.0);
  h.follow(1.0, 1.0);
  CHECK(slip_sum(h.follower(), 0) == about(-0.5));
  h.follow(1.0, 0.25);
  REQUIRE(h.changes.size() == 1);
  CHECK(h.changes[0].load == about(2));
  CHECK(h.pair(0).status == C2D_STICK);
  CHECK(h.pair(0).offset == about(-0.5));
  CHECK(h.state(0).q == about(-0.25));
  h.follow(1.0, -0.5);
  REQUIRE(h.changes.size() == 1);
  CHECK(h.changes[0].load == about(1));
  CHECK(h.pair(0).sign == -1);
  CHECK(h.state(0).q == about(-0.5));
  CHECK(h.state(0).wt == about(0));
  CHECK(slip_sum(h.follower(), 0) == about(0));
}

// w_n = 0.5 - lambda: 0.5 away, from 0.2 on 0.3. Closed, p = lambda - 0.5 grows: nothing is ahead.
TEST_CASE("events: how far the next one is can be asked without going there") {
  Hand h({{1}}, {{1}}, false, 0.0);
  h.start({0.5});
  Follower& f = h.follower();
  c2d_outcome outcome = C2D_REACHED;
  double part = 0.0;
  f.direction[0] = 1.0;
  REQUIRE(find_event(f, 2.0, &part, &outcome) == C2D_OK);
  CHECK(part == about(0.5));
  REQUIRE(find_event(f, 0.4, &part, &outcome) == C2D_OK);
  CHECK(std::isinf(part));
  h.follow(0.2);
  f.direction[0] = 1.0;
  REQUIRE(find_event(f, 2.0, &part, &outcome) == C2D_OK);
  CHECK(part == about(0.3));
  CHECK(f.load[0] == 0.2);
  CHECK(h.pair(0).status == C2D_OPEN);
  h.follow(1.0);
  f.direction[0] = 1.0;
  REQUIRE(find_event(f, 2.0, &part, &outcome) == C2D_OK);
  CHECK(std::isinf(part));
}

// Of the pair of the sample above that slips from its first touch on, at lambda = 1: p = 3, q = 1.5, w_t = -1.5. Behind it
// another whose normal force feels its motion: p_2 = w_t1 / 10 + lambda, so 0.85.
TEST_CASE("rebuilding: what exchanges and drift have left of the tableau is as if it had never been") {
  Hand h({{2, 0, 0, 0}, {0, 1, 0, 0}, {0, 0.1, 1, 0}, {0, 0, 0, 1}}, {{4, 3, 1, 0}}, true, 0.5);
  h.start({0.5, 0});
  h.follow(1.0);
  const auto as_worked_out = [&] {
    CHECK(h.state(0).p == about(3));
    CHECK(h.state(0).q == about(1.5));
    CHECK(h.state(0).wt == about(-1.5));
    CHECK(h.state(1).p == about(0.85));
  };
  as_worked_out();
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 4; ++i) h.set_entry(i, j, h.entry(i, j) + 1e-3 * (i + j));
  refresh(h.follower());
  CHECK(std::fabs(h.state(0).p - 3) > 1e-4);
  REQUIRE(rebuild(h.follower()) == C2D_OK);
  as_worked_out();
}

// Statuses, place and slip of lambda = 0.5: p = 1, q = 0.5, w_t = 0.5 - 1.5 = -1, of which since the touch at -0.75: -0.25.
TEST_CASE("rebuilding: pairs go back to what was kept, with their books") {
  Hand h({{2, 0}, {0, 1}}, {{4, 3}}, true, 0.5);
  h.start({0.5});
  const auto go_back_to = [&](double load) {
    h.follower().load[0] = load;
    REQUIRE(restore_pairs(h.follower()) == C2D_OK);
  };
  h.follow(0.2);
  keep_pairs(h.follower());
  h.follow(0.5);
  go_back_to(0.2);
  CHECK(h.pair(0).status == C2D_OPEN);
  CHECK(h.state(0).wn == about(0.1));
  CHECK(h.state(0).wt == about(-0.6));
  CHECK(slip_sum(h.follower(), 0) == 0.0);
  h.follow(0.5);
  keep_pairs(h.follower());
  h.follow(1.0);
  h.follow(0.9); // back: it sticks
  CHECK(h.pair(0).status == C2D_STICK);
  CHECK(slip_sum(h.follower(), 0) == about(-0.75));
  go_back_to(0.5);
  CHECK(h.pair(0).status == C2D_SLIP);
  CHECK(h.pair(0).sign == 1);
  CHECK(h.state(0).p == about(1));
  CHECK(h.state(0).q == about(0.5));
  CHECK(h.state(0).wt == about(-1));
  CHECK(slip_sum(h.follower(), 0) == about(-0.25));
}

// Five pairs drawn, 40 changes of status one after the other: each tableau is that built for its statuses from the matrix.
TEST_CASE("rebuilding: any way of exchanges leads to the tableau of the statuses") {
  std::vector<std::vector<double>> k(10, std::vector<double>(10));
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) k[sized(i)][sized(j)] = (i == j ? 5.0 : 0.0) + std::sin(1.0 + 7 * i + 3 * j);
  Hand h(k, {{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}, true, 0.3);
  REQUIRE(h.build() == C2D_OK);
  uint32_t draw = 1;
  for (int i = 0; i < 40; ++i) {
    draw = draw * 1664525u + 1013904223u;
    const int pair = static_cast<int>(draw >> 16) % 5, kind = static_cast<int>(draw >> 24) % 4;
    const int32_t status = kind == 0 ? C2D_OPEN : kind == 1 ? C2D_STICK : C2D_SLIP;
    REQUIRE(change_status(h.tableau(), pair, status, kind == 2 ? 1 : -1, 0.125 * i));
    for (int slot = 0; slot < 10; ++slot) { // what is kept of it beside it
      CHECK(std::fabs(own_entry(h.tableau(), slot) - h.entry(slot, slot)) < 1e-12);
      CHECK(std::fabs(cross_entry(h.tableau(), slot, slot ^ 1) - h.entry(slot, slot ^ 1)) < 1e-12);
    }
    std::vector<double> went;
    for (int at = 0; at < 120; ++at) went.push_back(h.entry(at % 10, at / 10));
    REQUIRE(h.build() == C2D_OK);
    for (int at = 0; at < 120; ++at) CHECK(std::fabs(h.entry(at % 10, at / 10) - went[sized(at)]) < 1e-10);
  }
}

// Friction without bound, q = lambda_2, lets go where the pair lifts, p = 1 - 2 lambda_2 at 0.5: the state jumps there, and
// what is asked beforehand or afterwards may end the path. Nobody need be told of changes.
TEST_CASE("events: a jump is told before and after, and either may stop the path") {
  struct Watch {
    int before = 0, after = 0, fails = -1;
  } watch;
  for (const int fails : {-1, 0, 1}) {
    Hand h({{1, 0}, {0, 1}}, {{1, 0}, {-2, 1}}, true, HUGE_VAL);
    h.start({0});
    watch = Watch{0, 0, fails};
    Follower& f = h.follower();
    f.watch.tick = [](void*) { return c2d_status{C2D_OK}; };
    f.watch.changed = nullptr;
    f.watch.context = &watch;
    f.watch.jumping = [](void* context, bool done) {
      Watch& w = *static_cast<Watch*>(context);
      const bool now = (w.before + w.after) / 2 >= 1 && w.fails == (done ? 1 : 0);
      ++(done ? w.after : w.before);
      return now ? c2d_status{C2D_ERR_CALLBACK} : c2d_status{C2D_OK};
    };
    const double first[2] = {1.0, 0.0}, second[2] = {1.0, 1.0};
    c2d_outcome outcome = C2D_REACHED;
    REQUIRE(follow_events(f, first, &outcome) == C2D_OK);
    REQUIRE(outcome == C2D_REACHED);
    const c2d_status status = follow_events(f, second, &outcome);
    CHECK(status == (fails < 0 ? C2D_OK : C2D_ERR_CALLBACK));
    if (fails >= 0) continue;
    CHECK(watch.before == watch.after);
    CHECK(h.pair(0).status == C2D_OPEN);
    CHECK(h.state(0).wn == about(1)); // w_n = -(1 - 2), w_t = -1, which the friction held back up to there
    CHECK(h.state(0).wt == about(-1));
  }
}

// wn = gap - load, p = load - gap. From the first change on whatever the pair does goes back at once, as round-off without
// bound would make it: what the pair is told here is that it leaves zero, falling.
TEST_CASE("events: changes without end at one load end the path there, unless it was on its way to no load and all but there") {
  for (const bool back : {false, true}) {
    CAPTURE(back);
    const double gap = back ? 1e-10 : 0.5;
    Hand h({{1, 0}, {0, 1}}, {{1, 1}}, false, 0.0);
    h.start({gap, 0.0});
    if (back) h.follow(1.0);
    h.follower().stats = PathStats();
    h.follower().watch.changed = [](void* self, double load) {
      Hand& restless = *static_cast<Hand*>(self);
      const double falling = restless.follower().direction[0] > 0.0 ? -1.0 : 1.0;
      restless.set_entry(0, 2, -falling * load);
      restless.set_entry(0, 3, falling);
      refresh(restless.follower());
      return c2d_status{C2D_OK};
    };
    const double target[2] = {back ? 0.0 : 1.0, 0.0};
    c2d_outcome outcome = C2D_REACHED;
    REQUIRE(follow_events(h.follower(), target, &outcome) == C2D_OK);
    CHECK(outcome == (back ? C2D_REACHED : C2D_NO_PROGRESS));
    CHECK(h.follower().load[0] == (back ? 0.0 : gap));
    CHECK(h.follower().stats.events == 1 + 20 + 8 * 2); // METHOD 12
    CHECK(h.state(1).p == about(h.follower().load[0]));
  }
}

// w_n = 0.5 - lambda; closed, p = -(lambda - 0.5): the pair would close by pulling. Six others stay as they are.
TEST_CASE("events: changes that come back to where they began are not begun again") {
  std::vector<std::vector<double>> k(7, std::vector<double>(7)), b(1, std::vector<double>(7, 1.0));
  for (size_t i = 0; i < 7; ++i) k[i][i] = i == 0 ? -1.0 : 1.0;
  b[0][0] = -1.0;
  Hand h(k, b, false, 0.0);
  h.start({0.5, 0, 0, 0, 0, 0, 0});
  const double target[2] = {1.0, 0.0};
  c2d_outcome outcome = C2D_REACHED;
  REQUIRE(follow_events(h.follower(), target, &outcome) == C2D_OK);
  CHECK(outcome == C2D_NO_ADMISSIBLE_CHANGE);
  CHECK(h.follower().load[0] == about(0.5));
  CHECK(h.pair(0).status == C2D_OPEN);
  CHECK(h.follower().stats.changes == 2);
}

// p = lambda_2: the pair lifts where that load is none, exactly, wherever the path comes from and goes to.
TEST_CASE("events: a load that goes to the other side is none where the last pair lifts, whatever the other load is") {
  for (const double from : {0.1, 0.7, 1.1, 1.3, 2.9})
    for (const double to : {0.3, 0.9, 1.7, 2.3})
      for (const int other : {0, 1}) {
        CAPTURE(from);
        CAPTURE(to);
        std::vector<std::vector<double>> b(2, {0.0});
        b[sized(1 - other)][0] = 1.0;
        Hand h({{1}}, b, false, 0.0);
        h.start({0});
        const auto go = [&](double load) { h.follow(other == 0 ? 0.0 : load, other == 0 ? load : 0.0); };
        go(from);
        go(-to);
        REQUIRE(h.changes.size() == 1);
        CHECK(h.changes[0].load == 0.0);
      }
}

// Pressed by 1, of which friction carries 1000, and pushed by as much or more: then nothing holds the pair any more, and it can
// neither slide nor lift. What is left of the piece where that happens may be round-off alone.
TEST_CASE("events: a path that would end within round-off of its end is not cut short") {
  for (const double more : {1e-13, 1e-3}) {
    CAPTURE(more);
    Hand h({{1, 0}, {0, 0}}, {{1, 0}, {0, 1e3 * (1 + more)}}, true, 1e3);
    h.start({0});
    h.follow(1.0);
    const double target[2] = {1.0, 1.0};
    c2d_outcome outcome = C2D_REACHED;
    REQUIRE(follow_events(h.follower(), target, &outcome) == C2D_OK);
    CHECK(outcome == (more < 1e-12 ? C2D_REACHED : C2D_NO_ADMISSIBLE_CHANGE));
    CHECK(h.follower().stats.events == 1);
    CHECK(h.follower().load[1] == (more < 1e-12 ? 1.0 : about(1 / (1 + more))));
    CHECK(h.pair(0).status == C2D_STICK);
    CHECK(h.state(0).q == about(1e3));
  }
}

TEST_CASE("events: the bound below which rates are none has no stiffness where a pair has none") {
  Pair soft = Pair();
  const PathScales s{1.0, 1.0, 3.0, 2.0};
  const NoRate none = no_rate(soft, s);
  CHECK(none.force == about(kRateTolerance * 3.0));
  CHECK(none.motion == about(kRateTolerance * 2.0));
  soft.stiffness[0] = Real(0.5);
  CHECK(no_rate(soft, s).motion == about(kRateTolerance * 2.0 + kMixedNoise * 6.0));
}
