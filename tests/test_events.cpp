// Events, exchanges, pivots off the diagonal and rebuilding on tableaux made by hand of one to five pairs. Every expected
// number is worked out in the comment above it: sticking, (p, q) = K (w_n - gap, w_t) + lambda b; open, p = q = 0; slipping,
// w_n = 0 and q = sign mu p.
#include "c2d_memory.h"
#include "contact/path.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace c2d;

namespace {

size_t sized(int count) { return static_cast<size_t>(count); }
doctest::Approx about(double value) { return doctest::Approx(value).epsilon(1e-12).scale(1.0); }

// A change that was told, and the sum of the load factors there.
struct Change {
  double load;
  int32_t pair;
};

// Pairs with the rates of up to two load cases; those without a tangential direction have one unknown.
class Hand {
public:
  Hand(const std::vector<std::vector<double>>& k, const std::vector<std::vector<double>>& b, bool tangential, double mu)
      : m_(static_cast<int>(k.size())), cases_(static_cast<int>(b.size())), pair_(sized(tangential ? m_ / 2 : m_)),
        t_(sized(m_ * (m_ + 1 + cases_))), store_(1 << 16), buffer_(sized(m_) + 9), y_(sized(m_)), dy_(sized(m_)),
        area_(sized((m_ + 1) * (m_ + 5)) + 8), lists_(pair_.size() * kRateListBytes / 8 + 1) {
    for (int j = 0; j < m_; ++j)
      for (int i = 0; i < m_; ++i) stiffness_.push_back(static_cast<Real>(k[sized(i)][sized(j)]));
    for (const std::vector<double>& of_case : b)
      for (double rate : of_case) rates_.push_back(static_cast<Real>(rate));
    for (size_t i = 0; i < pair_.size(); ++i) {
      Pair& p = pair_[i] = Pair{};
      p.tangential = tangential ? 1 : 0;
      p.dof = static_cast<int32_t>(i) * (1 + p.tangential);
      p.status = C2D_STICK;
      p.mu = mu;
    }
    tableau_ = Tableau{m_, m_,      cases_, static_cast<int32_t>(pair_.size()), pair_.data(), t_.data(), 1.0, 0.0, 0, nullptr,
                       0,  nullptr, nullptr};
    open_store();
    f_.t = &tableau_;
    f_.tape = &tape_;
    f_.load = load_;
    f_.direction = direction_;
    f_.origin = origin_;
    f_.y = y_.data();
    f_.dy = dy_.data();
    f_.rate_area = RateArea{area_.data(), lists_.data(), tableau_.pairs};
    f_.bound.pair = -1;
    f_.watch.context = this;
    f_.watch.tick = [](void*) { return c2d_status{C2D_OK}; };
    f_.watch.changed = [](void* self, double) { return static_cast<Hand*>(self)->note(); };
  }
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  Pair& pair(int i) { return pair_[sized(i)]; }
  Tableau& tableau() { return tableau_; }
  Follower& follower() { return f_; }
  double entry(int i, int j) const { return t_[sized(j * m_ + i)]; }
  void set_entry(int i, int j, double value) { t_[sized(j * m_ + i)] = static_cast<Real>(value); }
  double constant(int i) const { return entry(i, m_); }
  double rate(int i, int k = 0) const { return entry(i, m_ + 1 + k); }
  c2d_status build() { return build_tableau(tableau_, tape_, &culprit); }

  // Unloaded: pairs with a gap are open, the others stick.
  void start(const std::vector<double>& gaps) {
    for (size_t i = 0; i < gaps.size(); ++i) {
      pair_[i].gap = gaps[i];
      pair_[i].status = gaps[i] > 0.0 ? C2D_OPEN : C2D_STICK;
      f_.gap_scale = std::max(f_.gap_scale, gaps[i]);
    }
    REQUIRE(build() == C2D_OK);
  }
  // To these load factors, which must be reached. Changes of status on the way are in `changes`.
  void follow(double load1, double load2 = 0.0) {
    const double target[2] = {load1, load2};
    c2d_outcome outcome = C2D_REACHED;
    changes.clear();
    REQUIRE(follow_events(f_, target, &outcome) == C2D_OK);
    REQUIRE(outcome == C2D_REACHED);
  }
  PairState state(int i) const { return pair_state(tableau_, i, f_.y); }

  std::vector<Change> changes;
  int32_t culprit = -1;

private:
  c2d_status note() {
    changes.push_back({load_[0] + load_[1], f_.last_pair});
    return C2D_OK;
  }
  void open_store() {
    c2d_memory_store_init(&memory_, store_.data(), store_.size());
    port_ = C2D_INIT(c2d_port);
    c2d_memory_store_port(&memory_, &port_);
    tapes_.port = &port_;
    tapes_.run_id = 1;
    head_.contact = m_;
    head_.load_cases = cases_;
    model_.head = &head_;
    tape_ = ContactTape{&tapes_, &model_, buffer_.data()};
    const uint64_t blocks = static_cast<uint64_t>(place_contact_blocks(model_));
    REQUIRE(open_tape(tapes_, C2D_TAPE_CONTACT, blocks, sized(m_) * sizeof(Real)) == C2D_OK);
    REQUIRE(write_matrix(tape_, ContactMatrix::stiffness, stiffness_.data(), m_) == C2D_OK);
    REQUIRE(write_matrix(tape_, ContactMatrix::stiffness_load, rates_.data(), m_) == C2D_OK);
  }

  int m_, cases_;
  std::vector<Pair> pair_;
  std::vector<Real> t_, stiffness_, rates_;
  std::vector<unsigned char> store_;
  std::vector<double> buffer_;
  std::vector<Real> y_, dy_;
  std::vector<double> area_, lists_;
  double load_[2] = {}, direction_[2] = {}, origin_[2] = {};
  c2d_memory_store memory_{};
  c2d_port port_{};
  Tapes tapes_{};
  ModelHeader head_{}; // of no bodies: what the tape's matrices are as large as
  Model model_{};
  ContactTape tape_{};
  Tableau tableau_{};
  Follower f_{};
};

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
    std::vector<double> went;
    for (int at = 0; at < 120; ++at) went.push_back(h.entry(at % 10, at / 10));
    REQUIRE(h.build() == C2D_OK);
    for (int at = 0; at < 120; ++at) CHECK(std::fabs(h.entry(at % 10, at / 10) - went[sized(at)]) < 1e-10);
  }
}
