// Paths on tableaux drawn at random, most of which no body could have: rounds of changes end without rates there, tableaux are
// built anew, bodies are let go and held again, and some have no rates at all. Whatever becomes of them is judged by the law of
// contact and friction and the stiffness that was drawn; and the store fails, and the host cancels, at every place.
#include "contact/let_go.hpp"
#include "contact/rates/limit_analysis.hpp"
#include "contact/rates/search.hpp"
#include "hand_tableau.hpp"
#include "memory/parts.hpp"

#include <memory>
#include <random>
#include <string>

using namespace c2d;
using hand::Hand;
using hand::sized;

C2D_BRINGS(c2d_link_search); // without that part what nothing holds is not seated: also in a program of these tests alone

namespace {

using Matrix = std::vector<std::vector<double>>;

// Forces of sticking pairs K (w - gap) + lambda b.
struct Drawn {
  Matrix k, b;
  std::vector<int> tangential;
  std::vector<double> gaps, mu;
  int free_motions = 0;
  bool jumps = false, delays = true;

  bool has_jumps() const {
    return std::any_of(mu.begin(), mu.end(), [](double one) { return one > 1e300; });
  }
  int slots() const { return static_cast<int>(k.size()); }
  std::unique_ptr<Hand> make() const {
    std::unique_ptr<Hand> h(new Hand(k, b, tangential, 0.0));
    if (!delays) h->keep_nothing_back();
    h->tableau().free_motions = free_motions;
    h->tableau().load = h->follower().load;
    h->tableau().direction = h->follower().direction;
    h->tableau().model = h->follower().model;
    for (size_t i = 0; i < mu.size(); ++i) h->pair(static_cast<int>(i)).law.mu = mu[i];
    if (jumps) h->follower().watch.jumping = [](void*, bool) { return c2d_status{C2D_OK}; };
    return h;
  }
};

class Draw {
public:
  explicit Draw(uint32_t seed) : engine_(seed) {}
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine_); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<uint32_t>(n)); }
  template <class T> T one_of(std::initializer_list<T> of) { return of.begin()[below(static_cast<int>(of.size()))]; }

private:
  std::mt19937 engine_;
};

// x of which a body takes no force, and so no load where `balanced`: K and b are projected.
void free_along(Drawn& d, const std::vector<double>& x, bool balanced) {
  const size_t m = x.size();
  double size = 0.0;
  for (double v : x) size += v * v;
  for (size_t i = 0; i < m; ++i) {
    double sum = 0.0;
    for (size_t j = 0; j < m; ++j) sum += d.k[i][j] * x[j];
    for (size_t j = 0; j < m; ++j) d.k[i][j] -= sum * x[j] / size;
  }
  for (size_t j = 0; j < m; ++j) {
    double sum = 0.0;
    for (size_t i = 0; i < m; ++i) sum += x[i] * d.k[i][j];
    for (size_t i = 0; i < m; ++i) d.k[i][j] -= sum * x[i] / size;
  }
  for (std::vector<double>& b : d.b) {
    double sum = 0.0;
    for (size_t i = 0; i < m; ++i) sum += b[i] * x[i];
    for (size_t i = 0; i < m && balanced; ++i) b[i] -= sum * x[i] / size;
  }
}

Drawn drawn(uint32_t seed, int most) {
  Draw draw(seed);
  Drawn d;
  const int pairs = 1 + draw.below(most), kind = draw.below(4);
  const double mu = draw.one_of({0.0, 0.3, 1.0, 2.5, double{HUGE_VAL}});
  const bool mixed = draw.below(4) == 0, gaps = draw.below(2) == 0;
  for (int i = 0; i < pairs; ++i) {
    d.tangential.push_back(mixed ? draw.below(2) : 1);
    d.mu.push_back(draw.below(6) == 0 ? draw.one_of({0.0, 0.5, double{HUGE_VAL}}) : mu);
    d.gaps.push_back(gaps && draw.below(2) == 0 ? 0.3 * (1.0 + draw.uniform()) : 0.0);
  }
  int m = pairs;
  for (int t : d.tangential) m += t;
  Matrix root(sized(m), std::vector<double>(sized(m)));
  for (auto& row : root)
    for (double& x : row) x = draw.uniform();
  d.k = root;
  const double coupling = draw.one_of({0.05, 0.5});
  for (int i = 0; i < m && kind != 0; ++i)
    for (int j = 0; j < m; ++j) {
      double& k = d.k[sized(i)][sized(j)];
      k = kind == 1 ? coupling * k + (i == j ? 0.5 : 0.0) : (i == j ? 0.1 : 0.02 * k);
      for (int l = 0; l < m && kind > 1; ++l) k += root[sized(i)][sized(l)] * root[sized(j)][sized(l)];
    }
  d.b.assign(2, std::vector<double>(sized(m)));
  for (auto& b : d.b)
    for (double& x : b) x = draw.uniform();
  if (kind == 3 && m > 1) {
    d.free_motions = 1;
    std::vector<double> x(sized(m));
    const bool along = draw.below(2) == 0;
    int dof = 0;
    for (int i = 0; i < pairs; ++i) { // a slide along all pairs, or any motion
      x[sized(dof)] = along ? 0.0 : draw.uniform();
      if (d.tangential[sized(i)] != 0) x[sized(dof + 1)] = along ? 1.0 : draw.uniform();
      dof += 1 + d.tangential[sized(i)];
    }
    if (along) x[0] += 1e-30;
    free_along(d, x, true);
  }
  d.jumps = draw.below(2) == 0;
  d.delays = draw.below(2) == 0;
  return d;
}

// What is wrong with the state of a path, or nothing: balance by K, gaps, pressures, and Coulomb's bound.
std::string breach(const Drawn& d, Hand& h) {
  constexpr double tight = 1e-6;
  const int m = d.slots(), pairs = static_cast<int>(d.tangential.size());
  std::vector<double> w(sized(m)), force(sized(m));
  double forces = 1e-30, motions = 1e-30;
  for (int i = 0, dof = 0; i < pairs; dof += 1 + d.tangential[sized(i)], ++i) {
    const PairState s = h.state(i);
    w[sized(dof)] = s.wn - d.gaps[sized(i)], force[sized(dof)] = s.p;
    if (d.tangential[sized(i)] != 0) w[sized(dof + 1)] = s.wt, force[sized(dof + 1)] = s.q;
  }
  for (double x : w) motions = std::max(motions, std::fabs(x));
  for (int i = 0; i < m; ++i) {
    double sum = 0.0, terms = std::fabs(force[sized(i)]);
    for (int j = 0; j < m; ++j) {
      sum += d.k[sized(i)][sized(j)] * w[sized(j)];
      terms += std::fabs(d.k[sized(i)][sized(j)] * w[sized(j)]);
    }
    for (int k = 0; k < 2; ++k) {
      sum += h.follower().load[k] * d.b[sized(k)][sized(i)];
      terms += std::fabs(h.follower().load[k] * d.b[sized(k)][sized(i)]);
    }
    forces = std::max(forces, terms);
    if (std::fabs(sum - force[sized(i)]) > tight * (terms + motions)) return "balance";
  }
  for (int i = 0; i < pairs; ++i) {
    const PairState s = h.state(i);
    const double mu = d.mu[sized(i)];
    if (s.wn < -tight * motions) return "overlap";
    if (s.p < -tight * forces) return "tension";
    if (mu < 1e300 && !d.has_jumps() && std::fabs(s.q) > mu * s.p + tight * (1.0 + mu) * forces) return "friction";
    if (h.pair(i).status == C2D_OPEN && (s.p != 0.0 || s.q != 0.0)) return "force of an open pair";
  }
  return "";
}

// To these loads one after the other; the first that is not reached ends it.
struct Way {
  c2d_status status = C2D_OK;
  c2d_outcome outcome = C2D_REACHED;
};
Way follow(Hand& h, bool increments = false, size_t most = 5) {
  const double targets[][2] = {{1, 0}, {1, 1}, {0.2, -1}, {0, 0}, {0.5, 0}};
  Way way;
  for (size_t i = 0; i < most; ++i) {
    const auto& target = targets[i];
    way.status = increments ? follow_increment(h.follower(), target, 6, &way.outcome)
                            : follow_events(h.follower(), target, &way.outcome);
    if (way.status != C2D_OK || way.outcome != C2D_REACHED) break;
  }
  return way;
}

// Zero load: pairs with a gap are open.
c2d_status begin(const Drawn& d, Hand& h) {
  for (size_t i = 0; i < d.gaps.size(); ++i) {
    Pair& p = h.pair(static_cast<int>(i));
    p.gap = d.gaps[i];
    p.status = d.gaps[i] > 0.0 ? C2D_OPEN : d.mu[i] == 0.0 ? C2D_SLIP : C2D_STICK;
    p.sign = p.status == C2D_SLIP ? 1 : 0;
    h.follower().gap_scale = std::max(h.follower().gap_scale, d.gaps[i]);
  }
  return h.build();
}

} // namespace

TEST_CASE("search: wherever a path on a drawn tableau leads, its states keep the law of contact and friction") {
  int reached = 0, ended = 0;
  for (uint32_t seed = 1; seed <= 1500; ++seed) {
    CAPTURE(seed);
    const Drawn d = drawn(seed, 6);
    const std::unique_ptr<Hand> h = d.make();
    const c2d_status begun = begin(d, *h);
    if (begun == C2D_ERR_SINGULAR) continue; // what touches does not hold it
    REQUIRE(begun == C2D_OK);
    const Way way = follow(*h, seed % 5 == 0);
    CHECK((way.status == C2D_OK || way.status == C2D_ERR_SINGULAR));
    if (way.status != C2D_OK) continue;
    (way.outcome == C2D_REACHED ? reached : ended) += 1;
    // What friction without bound lets go of may come to rest nowhere (the solver keeps the state before it), or push others
    // beyond their friction.
    if (way.outcome == C2D_REACHED || !d.has_jumps()) CHECK(breach(d, *h) == "");
  }
  CHECK(reached > 500);
  CHECK(ended > 250);
}

// A store that fails at one of the reads, which are many where tableaux are built anew, and a host that cancels: each is told,
// wherever it happens.
TEST_CASE("search: the store fails and the host cancels at every place of a drawn path") {
  int rebuilt = 0;
  for (uint32_t seed = 1; seed <= 250; ++seed) {
    CAPTURE(seed);
    const Drawn d = drawn(seed, 4);
    const auto run = [&](int64_t fails_at, int64_t cancelled_at, int64_t* reads, int64_t* ticks) {
      const std::unique_ptr<Hand> h = d.make();
      if (begin(d, *h) != C2D_OK) return Way{C2D_ERR_SINGULAR, C2D_REACHED};
      h->reads = 0;
      h->fails_at = fails_at, h->cancelled_at = cancelled_at;
      const Way way = follow(*h, seed % 5 == 0);
      *reads = h->reads, *ticks = h->ticks;
      return way;
    };
    int64_t reads = 0, ticks = 0, unused = 0;
    if (run(-1, -1, &reads, &ticks).status != C2D_OK) continue;
    rebuilt += reads > 0;
    for (int64_t n = 0; n < reads; n += 1 + reads / 25) CHECK(run(n, -1, &unused, &unused).status == C2D_ERR_STORE_READ);
    for (int64_t n = 0; n < ticks; n += 1 + ticks / 10) CHECK(run(-1, n, &unused, &unused).status == C2D_ERR_CANCELLED);
  }
  CHECK(rebuilt > 30);
}

// ---- rare ways ------------------------------------------------------------------------------------------------------

namespace {

// Models as above, of more kinds: `motions` of them free at most, in which pairs move along, or any way (each pair or, of those
// that may rest, every second one); numbers that are alike, K of a low rank.
struct Kind {
  int least, spread; // pairs
  bool is_free, may_rest;
};
constexpr Kind kFree = {1, 6, true, false}, kRests = {1, 6, true, true}, kSome = {17, 4, false, false},
               kMany = {41, 5, false, false};

std::vector<double> drawn_motion(Draw& draw, const Drawn& d, bool may_rest, bool alike) {
  std::vector<double> x(sized(d.slots()));
  const int way = draw.below(3);
  int dof = 0;
  for (int t : d.tangential) {
    const bool moves = !may_rest || draw.below(2) == 0;
    const auto number = [&] { return alike ? std::round(2 * draw.uniform()) / 2 : draw.uniform(); };
    x[sized(dof)] = way == 0 || !moves ? 0.0 : number();
    if (t != 0) x[sized(dof + 1)] = !moves ? 0.0 : way == 0 ? 1.0 : number();
    dof += 1 + t;
  }
  if (std::all_of(x.begin(), x.end(), [](double one) { return one == 0.0; })) x[0] = 1;
  return x;
}

double along(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Drawn drawn(uint32_t seed, const Kind& of) {
  Draw draw(seed * 2654435761u + 17);
  Drawn d;
  int pairs = 1 + draw.below(6);
  if (of.least > 1) pairs = of.least + draw.below(of.spread);
  int kind = draw.below(4);
  if (of.is_free) kind = 3;
  const double mu = draw.one_of({0.0, 0.3, 1.0, 2.5, 10.0, double{HUGE_VAL}});
  const bool mixed = draw.below(4) == 0, gaps = draw.below(2) == 0;
  int m = pairs;
  for (int i = 0; i < pairs; ++i) {
    d.tangential.push_back(mixed ? draw.below(2) : 1);
    d.mu.push_back(draw.below(6) == 0 ? draw.one_of({0.0, 0.5, double{HUGE_VAL}}) : mu);
    d.gaps.push_back(gaps && draw.below(2) == 0 ? 0.3 * (1.0 + draw.uniform()) : 0.0);
    m += d.tangential.back();
  }
  const bool alike = draw.below(3) == 0;
  const auto number = [&] { return alike ? std::round(2 * draw.uniform()) / 2 : draw.uniform(); };
  Matrix root(sized(m), std::vector<double>(sized(m)));
  const int rank = draw.below(3) == 0 && pairs > 6 ? 6 : m;
  for (auto& row : root)
    for (int j = 0; j < rank; ++j) row[sized(j)] = number();
  d.k = root;
  const double coupling = draw.one_of({0.05, 0.2, 0.5}) / (pairs > 6 ? std::sqrt(pairs / 3.0) : 1.0);
  for (int i = 0; i < m && kind != 0; ++i)
    for (int j = 0; j < m; ++j) {
      double& k = d.k[sized(i)][sized(j)];
      k = kind == 1 ? coupling * k + (i == j ? 0.5 : 0.0) : (i == j ? 0.1 : 0.02 * k);
      for (int l = 0; l < m && kind > 1; ++l) k += root[sized(i)][sized(l)] * root[sized(j)][sized(l)];
    }
  d.b.assign(2, std::vector<double>(sized(m)));
  for (auto& b : d.b)
    for (double& x : b) x = number();
  if (kind == 3 && m > 1) {
    std::vector<std::vector<double>> motions;
    for (int k = 1 + draw.below(of.may_rest ? 4 : 2); k > 0; --k) {
      std::vector<double> x = drawn_motion(draw, d, of.may_rest, alike);
      for (const std::vector<double>& other : motions) {
        const double part = along(x, other) / along(other, other);
        for (size_t i = 0; i < x.size(); ++i) x[i] -= part * other[i];
      }
      if (along(x, x) < 1e-6) continue;
      motions.push_back(x);
      free_along(d, x, true);
    }
    d.free_motions = static_cast<int>(motions.size());
  }
  d.jumps = draw.below(2) == 0;
  d.delays = draw.below(2) == 0;
  return d;
}

// These seeds go, among others, ways that few go: paths on the tableau and by systems that find rates or none, branches, places
// in a range and its other end, bodies that rest, lean and are let go.
struct Rare {
  Kind kind;
  size_t targets;
  std::vector<uint32_t> seeds;
};
const Rare kRare[] = {
    {kFree, 5, {84, 249, 2501, 2967, 3801, 4211, 5665, 9845}},
    {kFree, 3, {8498}},
    {kRests, 5, {5, 9, 15, 18, 21, 234, 242, 797, 808, 2413, 2688, 2967, 4130, 5047, 8328, 10196, 18850, 24095, 28516}},
    {kSome, 5, {9, 18, 30, 169}},
    {kMany, 5, {18, 25, 26, 43}},
};

} // namespace

TEST_CASE("search: the rare ways, too, end at states that keep the law, and what fails on them is told") {
  for (const Rare& rare : kRare)
    for (const uint32_t seed : rare.seeds) {
      CAPTURE(rare.kind.least);
      CAPTURE(rare.kind.may_rest);
      CAPTURE(seed);
      const Drawn d = drawn(seed, rare.kind);
      const auto run = [&](int64_t fails_at, int64_t cancelled_at, int64_t* reads, int64_t* ticks) {
        const std::unique_ptr<Hand> h = d.make();
        h->tableau().may_rest = rare.kind.may_rest;
        if (begin(d, *h) != C2D_OK) return Way{C2D_ERR_SINGULAR, C2D_REACHED};
        h->reads = h->ticks = 0;
        h->fails_at = fails_at, h->cancelled_at = cancelled_at;
        const Way way = follow(*h, seed % 5 == 0, rare.targets);
        *reads = h->reads, *ticks = h->ticks;
        if (way.status == C2D_OK && way.outcome == C2D_REACHED) CHECK(breach(d, *h) == "");
        return way;
      };
      int64_t reads = 0, ticks = 0, unused = 0;
      if (run(-1, -1, &reads, &ticks).status != C2D_OK) continue;
      if (rare.kind.least > 1) continue; // (a second each)
      for (int64_t n = 0; n < reads; n += 1 + reads / 20) CHECK(run(n, -1, &unused, &unused).status == C2D_ERR_STORE_READ);
      for (int64_t n = 0; n < ticks; n += 1 + ticks / 10) CHECK(run(-1, n, &unused, &unused).status == C2D_ERR_CANCELLED);
    }
}

// ---- many pairs -----------------------------------------------------------------------------------------------------

namespace {

// Pairs that know nothing of each other, all touching at zero load: single ones of which any load has one solution, and some
// with the given stiffness and rates.
Drawn apart(int pairs, const std::vector<int>& hard, const Matrix& k, const std::vector<double>& b, double mu) {
  Drawn d;
  Draw draw(7);
  d.k.assign(sized(2 * pairs), std::vector<double>(sized(2 * pairs)));
  d.b.assign(2, std::vector<double>(sized(2 * pairs)));
  for (int i = 0; i < pairs; ++i) {
    const bool is_hard = std::find(hard.begin(), hard.end(), i) != hard.end();
    const size_t n = sized(2 * i);
    d.tangential.push_back(1);
    d.mu.push_back(mu);
    d.gaps.push_back(0.0);
    for (size_t r = 0; r < 2; ++r) {
      for (size_t c = 0; c < 2; ++c) d.k[n + r][n + c] = is_hard ? k[r][c] : r == c ? 1.0 : 0.0;
      d.b[0][n + r] = is_hard ? b[r] : draw.uniform();
    }
  }
  return d;
}

} // namespace

// K = (1 k; k 1), k = 0.6, mu = 2, as in test_rates.cpp: of rates (-1, 2) the pair opens.
TEST_CASE("search: of more pairs than are looked at one by one each finds its status, in one search or many") {
  for (const int pairs : {20, 45, 60}) {
    CAPTURE(pairs);
    const Drawn d = apart(pairs, {3, pairs - 1}, {{1, 0.6}, {0.6, 1}}, {1.0, 1.9}, 2.0);
    const std::unique_ptr<Hand> h = d.make();
    REQUIRE(begin(d, *h) == C2D_OK);
    c2d_outcome outcome = C2D_REACHED;
    const double target[2] = {1.0, 0.0};
    REQUIRE(follow_events(h->follower(), target, &outcome) == C2D_OK);
    CHECK(outcome == C2D_REACHED);
    CHECK(breach(d, *h) == "");
  }
}

// A pair that would close by pulling has no status at all under a load that lifts it, however many others there are.
TEST_CASE("search: where one of many pairs has no status, that is said, or the search gives up; and all is as it was") {
  for (const int pairs : {3, 20, 45, 260}) {
    CAPTURE(pairs);
    const Drawn d = apart(pairs, {1}, {{-1, 0}, {0, 1}}, {-1.0, 0.0}, 0.5);
    const auto run = [&](int64_t cancelled_at, int64_t fails_at, int64_t* ticks, int64_t* reads) {
      const std::unique_ptr<Hand> h = d.make();
      REQUIRE(begin(d, *h) == C2D_OK);
      h->reads = 0;
      h->cancelled_at = cancelled_at, h->fails_at = fails_at;
      Way way;
      const double target[2] = {1.0, 0.0};
      way.status = follow_events(h->follower(), target, &way.outcome);
      *ticks = h->ticks, *reads = h->reads;
      if (way.status != C2D_OK) return way;
      CHECK((way.outcome == C2D_NO_ADMISSIBLE_CHANGE || way.outcome == C2D_UNDECIDED));
      CHECK(h->follower().load[0] == 0.0);
      for (int i = 0; i < pairs; ++i) CHECK(h->pair(i).status == C2D_STICK);
      CHECK(breach(d, *h) == "");
      return way;
    };
    const int64_t gives_up = pairs == 45 ? 5 : -1; // (of more it does so by itself)
    int64_t ticks = 0, reads = 0, unused = 0;
    CHECK(run(gives_up, -1, &ticks, &reads).status == (gives_up >= 0 ? C2D_ERR_CANCELLED : C2D_OK));
    for (int64_t n = 0; n < ticks; n += 1 + ticks / 6) CHECK(run(n, -1, &unused, &unused).status == C2D_ERR_CANCELLED);
    for (int64_t n = 0; n < reads; n += 1 + reads / 6) {
      const c2d_status status = run(gives_up, n, &unused, &unused).status;
      CHECK(status == C2D_ERR_STORE_READ);
    }
  }
}

// The wedge again, K = (1 0.6; 0.6 1), mu = 2, and rates (1, 1.8): it may stick, or slip by (q - 2 p) / 0.2 = -1. What it does
// to the pressure of a pair beside it, which sticks, has no part in that.
TEST_CASE("search: of several rates those are taken with which a motion goes on, and they are counted, whatever is beside it") {
  for (const double beside : {0.0, 3.0, -3.0}) {
    CAPTURE(beside);
    const Matrix k = {{1, 0.6, 0, 0}, {0.6, 1, 0, 0}, {0, beside, 1, 0}, {0, 0, 0, 1}};
    Hand h(k, {{1, 1.8, 100, 0}}, true, 2.0);
    h.keep_nothing_back();
    h.pair(0).status = C2D_SLIP, h.pair(0).sign = 1;
    REQUIRE(h.build() == C2D_OK);
    Follower& f = h.follower();
    f.load[0] = f.direction[0] = 1.0; // it has slipped up to here
    refresh(f);
    h.follow(2.0);
    CHECK(h.pair(0).status == C2D_SLIP);
    CHECK(h.state(0).wt == doctest::Approx(-2.0));
    CHECK(f.solutions == 2);
  }
}

// Two pairs slip, and A has what they move by per friction; A = size (1 c; c 1) is positive definite where c < 1.
TEST_CASE("search: rates of pairs that slip on are not looked at one by one where they are surely unique") {
  for (const double size : {0.01, 1.0, 100.0})
    for (const double c : {0.3, 2.0}) {
      CAPTURE(size);
      CAPTURE(c);
      const double own = 1.0 / (size * (1.0 - c * c)), other = -c * own;
      Hand h({{1, 0, 0, 0}, {0, own, 0, other}, {0, 0, 1, 0}, {0, other, 0, own}}, {{1, 1.5, 1, 1.5}}, true, 0.5);
      h.keep_nothing_back();
      for (int i = 0; i < 2; ++i) h.pair(i).status = C2D_SLIP, h.pair(i).sign = 1;
      REQUIRE(h.build() == C2D_OK);
      Follower& f = h.follower();
      f.load[0] = f.direction[0] = 1.0;
      refresh(f);
      h.follow(2.0);
      for (int i = 0; i < 2; ++i) CHECK(h.state(i).wt == doctest::Approx(-2.0 * size * (1.0 + c)));
      CHECK(f.solutions == (c < 1.0 ? 0 : 1));
    }
}

// Pairs that nothing holds, but for one that sticks: so many motions are more than bodies at rest may have.
TEST_CASE("search: bodies rest along twelve motions, not along thirteen") {
  for (const int open : {12, 13}) {
    CAPTURE(open);
    const size_t m = sized(open + 1);
    Matrix k(m, std::vector<double>(m));
    k[0][0] = 1.0;
    Hand h(k, {std::vector<double>(m)}, std::vector<int>(m, 0), 0.0);
    h.tableau().load = h.follower().load, h.tableau().direction = h.follower().direction;
    h.tableau().model = h.follower().model;
    h.tableau().free_motions = open;
    h.tableau().may_rest = 1;
    for (int i = 1; i <= open; ++i) h.pair(i).status = C2D_OPEN;
    CHECK(h.build() == (open == 12 ? C2D_OK : C2D_ERR_SINGULAR));
  }
}

namespace {

// Pair 0 is pressed. The others are open, and the body tips along R = (0, 2, -1) without a force, by (1, 2) against k = 1/2:
// loads of (1, 1, 2) do no work on that.
std::unique_ptr<Hand> balance(const std::vector<double>& gaps) {
  const Matrix k = {{1, 0, 0}, {0, 0.5, 1}, {0, 1, 2}};
  std::unique_ptr<Hand> h(new Hand(k, {{1, 1, 2}}, std::vector<int>(3, 0), 0.3));
  h->tableau().load = h->follower().load, h->tableau().direction = h->follower().direction;
  h->tableau().model = h->follower().model;
  h->tableau().free_motions = h->tableau().may_rest = 1;
  for (int i = 0; i < 3; ++i) {
    h->pair(i).length = 1.0 + i; // not all alike, nor 1
    keep_place(h->pair(i), gaps[sized(i)], 0.0);
  }
  h->start(gaps);
  REQUIRE(h->tableau().resting == 1);
  return h;
}

} // namespace

// K w + x l R = p, and the sum of l R w is none.
TEST_CASE("search: what rests along a motion gives way to forces as if it were held by a force that is none, in the mean") {
  const std::unique_ptr<Hand> h = balance({0, 0.1, 0.1});
  const double held[] = {2.0 * 2.0, 3.0 * -1.0}; // l R
  for (int pressed = 1; pressed <= 2; ++pressed) {
    CAPTURE(pressed);
    const double w[] = {h->entry(1, pressed), h->entry(2, pressed)}, along = pressed == 1 ? 2.0 : -1.0;
    const double x = along / (2.0 * held[0] - held[1]); // R p over R l R
    CHECK(held[0] * w[0] + held[1] * w[1] == doctest::Approx(0).scale(1));
    CHECK(0.5 * w[0] + w[1] + x * held[0] == doctest::Approx(pressed == 1 ? 1 : 0).scale(1));
    CHECK(w[0] + 2.0 * w[1] + x * held[1] == doctest::Approx(pressed == 2 ? 1 : 0).scale(1));
  }
}

// w_1 + 2 w_2 = 0.7 - 2 load. While none of the two touches, 4 w_1 - 3 w_2 is what it was.
TEST_CASE("search: a body that comes to touch with one pair more leans on it without a force until the next one touches") {
  const std::unique_ptr<Hand> h = balance({0, 0.1, 0.3});
  h->follow(0.05);
  CHECK(h->state(1).wn == doctest::Approx((3 * 0.6 - 2 * 0.5) / 11));
  CHECK(h->state(2).wn == doctest::Approx((4 * 0.6 + 0.5) / 11));
  h->follow(0.3);
  CHECK(h->pair(1).status == C2D_OPEN);
  CHECK(h->tableau().resting == 1); // it may still tip off
  CHECK(h->state(1).wn == doctest::Approx(0).scale(1));
  CHECK(h->state(2).wn == doctest::Approx(0.05));
  h->follow(0.5);
  CHECK(h->tableau().resting == 0);
  CHECK(h->state(0).p == doctest::Approx(0.5));
  CHECK(h->state(1).p == doctest::Approx(0.15));
  CHECK(h->state(2).p == doctest::Approx(0.3));
}

// Where supports hold the bodies nothing is let go: what they press without a force so far counts, below 1e-9 as well.
TEST_CASE("search: a held body that is moved along what it touches slips under a pressure from the start, however little") {
  for (const double little : {1e-10, 5e-10, 1e-8}) {
    CAPTURE(little);
    Hand h({{1, 0}, {0, 1}}, {{little, 1}}, true, 0.5);
    h.start({0});
    h.follow(1.0);
    CHECK(h.pair(0).status == C2D_SLIP);
    CHECK(h.state(0).p == doctest::Approx(little));
    CHECK(h.state(0).q == doctest::Approx(0.5 * little));
    CHECK(h.state(0).wt == doctest::Approx(-1));
  }
}

// ---- places in a range, METHOD 13.7 -----------------------------------------------------------------------------------

// The friction of the pair is at its bound, q = s p / 2, and stays there. K lets it slide freely, w_t by itself, where q falls
// by half of what p grows: that is so for s = -1 alone.
TEST_CASE("search: a pair is the end of a range if it is free to slide the way its friction lets it, not the other way") {
  for (const int sign : {1, -1}) {
    CAPTURE(sign);
    Hand h({{5, -2}, {-2, 1}}, {{1, 0.5 * sign}}, true, 0.5);
    h.tableau().free_motions = 1;
    h.start({0});
    h.follow(1.0);
    h.follow(2.0);
    CHECK(h.pair(0).status == C2D_STICK);
    CHECK(h.state(0).p == doctest::Approx(2));
    CHECK(h.state(0).q == doctest::Approx(sign));
    CHECK(h.follower().range == (sign < 0));
    CHECK(h.follower().solutions == (sign < 0 ? 2 : 1));
    CHECK(h.tableau().guided == 0);
  }
}

namespace {

// Springs of stiffness 1 along these combinations of the slots, and pairs that are open as the test says.
std::unique_ptr<Hand> on_springs(const Matrix& springs, const std::vector<double>& load, const std::vector<int>& tangential) {
  Matrix k(load.size(), std::vector<double>(load.size()));
  for (const std::vector<double>& s : springs)
    for (size_t i = 0; i < s.size(); ++i)
      for (size_t j = 0; j < s.size(); ++j) k[i][j] += s[i] * s[j];
  std::unique_ptr<Hand> h(new Hand(k, {load}, tangential, 0.5));
  h->tableau().free_motions = 1;
  return h;
}

} // namespace

// Pair 1 is pressed and at the bound of its friction, q = p / 2, and holds the motion (w_t1, w_2, w_3) = (1, 1, o), against
// which nothing else is: by -x of it the pairs move least, (1 - x)^2 + x^2 for each unit of load. Pair 3 does not move of
// itself, and if it touches and o is not zero it stops that.
TEST_CASE("search: a body does not begin to slide along a range where a pair that touches stops it at once") {
  for (const double gap : {0.0, 1.0})
    for (const double o : {1.0, 0.0}) {
      CAPTURE(gap);
      CAPTURE(o);
      const std::unique_ptr<Hand> h = on_springs({{1, 0, 0, 0}, {0, -1, 1, 0}, {0, -o, 0, 1}}, {1, 1.5, -1, 0}, {1, 0, 0});
      const double gaps[] = {0.0, 0.5, gap};
      for (int i = 0; i < 3; ++i) h->pair(i).gap = gaps[i], h->pair(i).status = i == 0 ? C2D_STICK : C2D_OPEN;
      h->follower().gap_scale = 1.0;
      REQUIRE(h->build() == C2D_OK);
      h->follow(0.5);
      CHECK(h->follower().range);
      const double slides = gap == 0.0 && o != 0.0 ? 0.0 : 1.0 / (2.0 + o * o);
      CHECK(h->tableau().guided == (slides > 0.0 ? 1 : 0));
      CHECK(h->state(0).wt == doctest::Approx(-0.5 * slides));
      CHECK(h->state(0).p == doctest::Approx(0.5));
      CHECK(h->state(1).wn == doctest::Approx(0.5 + 0.5 * (1.0 - slides)));
      CHECK(h->state(2).wn == doctest::Approx(gap - 0.5 * slides * o));
    }
}

// Pair 2 slips, (p, q) = w_t - w_t1 - (1, 2) for each unit of load, and friction of such a coefficient gives way by 1e-16 of
// what it would alone: too little for it to be stuck where the body, which slides along with pair 3, would turn it back.
TEST_CASE("search: where the other end of a range cannot be taken all stays at this one") {
  Hand h({{1, 0, 0, 0, 0}, {0, 2, 0, -1, -1}, {0, -1, 1, 1, 0}, {0, -1, 0, 1, 0}, {0, -1, 0, 0, 1}}, {{1, 5.5, -1, -2, -4}},
         {1, 1, 0}, 0.5);
  h.tableau().free_motions = 1;
  h.pair(1).law.mu = 1e16, h.pair(1).status = C2D_SLIP, h.pair(1).sign = -1;
  h.pair(2).gap = 0.5, h.pair(2).status = C2D_OPEN;
  h.follower().gap_scale = 1.0;
  REQUIRE(h.build() == C2D_OK);
  const int64_t before = h.tableau().exchanges;
  h.follow(0.5);
  CHECK(h.follower().range);
  CHECK(h.tableau().exchanges == before);
  CHECK(h.tableau().guided == 0);
  CHECK(h.pair(0).status == C2D_STICK);
  CHECK(h.pair(1).status == C2D_SLIP);
  CHECK(h.state(0).p == doctest::Approx(0.5));
  CHECK(h.state(0).q == doctest::Approx(0.25));
  CHECK(h.state(1).wt == doctest::Approx(0.5));
  CHECK(h.state(2).wn == doctest::Approx(0.5 + 2.0));
}

// More pairs than of which all statuses are tried, of a body that nothing else holds. What K says of all of them open is what
// the last digits would make of a body in the air.
TEST_CASE("search: rounds of changes that open every pair of a body do not let it go, where round-off holds it") {
  for (const double mu : {0.5, 0.0}) {
    CAPTURE(mu);
    const size_t pairs = 7, m = 2 * pairs;
    Matrix k(m, std::vector<double>(m));
    std::vector<double> b(m);
    for (size_t i = 0; i < m; ++i) k[i][i] = 1.0, b[i] = i % 2 == 0 ? 1.0 : 0.0;
    Hand h(k, {b}, true, mu);
    h.tableau().free_motions = 1;
    for (size_t i = 0; i < pairs && mu == 0.0; ++i)
      h.pair(static_cast<int>(i)).status = C2D_SLIP, h.pair(static_cast<int>(i)).sign = 1;
    REQUIRE(h.build() == C2D_OK);
    h.follow(1.0);
    const double target[2] = {-1.0, 0.0};
    c2d_outcome outcome = C2D_REACHED;
    REQUIRE(follow_events(h.follower(), target, &outcome) == C2D_OK);
    CHECK(outcome == C2D_NO_ADMISSIBLE_CHANGE);
    CHECK(h.follower().load[0] == doctest::Approx(0).scale(1));
    for (size_t i = 0; i < pairs; ++i) CHECK(h.pair(static_cast<int>(i)).status != C2D_OPEN);
  }
}

// ---- what a search finds, and nothing holds -------------------------------------------------------------------------------

namespace {

// One pair more, at the end, that knows nothing of the others.
void add_pair(Drawn& d, const Matrix& k, const std::vector<double>& b) {
  const size_t m = sized(d.slots());
  for (std::vector<double>& row : d.k) row.resize(m + 2);
  d.k.resize(m + 2, std::vector<double>(m + 2));
  for (size_t r = 0; r < 2; ++r)
    for (size_t c = 0; c < 2; ++c) d.k[m + r][m + c] = k[r][c];
  for (std::vector<double>& of_case : d.b) of_case.insert(of_case.end(), b.begin(), b.end());
  d.tangential.push_back(1);
  d.mu.push_back(2.0);
  d.gaps.push_back(0.0);
}

} // namespace

// The last pair slips, by a stiffness of 3e-10 of its own, or opens. More pairs than are looked at one by one: rounds of
// changes and a path on the tableau come to the slip, and the systems of each set of cells to the other.
TEST_CASE("search: rates of pairs that hardly anything holds are none, others are looked for") {
  Drawn d = apart(45, {}, {}, {}, 2.0);
  add_pair(d, {{1, -0.5 - 1.5e-10}, {0, -1}}, {1, 2 + 1e-8});
  const std::unique_ptr<Hand> h = d.make();
  REQUIRE(begin(d, *h) == C2D_OK);
  h->follow(1.0);
  CHECK(h->pair(45).status == C2D_OPEN);
  CHECK(breach(d, *h) == "");
}

// Rounds of changes go round at pair 4, and the last slides with neither force nor gap, which in a tableau means open. A path
// on the tableau ends with it closed; that is taken back, and what the systems of the cells say is taken.
TEST_CASE("search: what a path on the tableau finds is judged like the rest") {
  Drawn d = apart(45, {3}, {{1, 1}, {-0.5, 0.75}}, {0.25, 0.75}, 2.0);
  add_pair(d, {{1, 0}, {0, 1}}, {0, 1});
  const std::unique_ptr<Hand> h = d.make();
  REQUIRE(begin(d, *h) == C2D_OK);
  h->follow(1.0);
  CHECK(h->state(45).p == doctest::Approx(0).scale(1));
  CHECK(h->state(45).wt == doctest::Approx(-1));
  CHECK(breach(d, *h) == "");
}
