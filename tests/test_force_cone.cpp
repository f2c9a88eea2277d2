// The cone of the forces that pairs can have: what of a load it balances is judged by what a projection onto a cone is, however
// nearly parallel its rays are; and where there is no room for it, that is told.
#include "contact/rates/force_cone.hpp"
#include "hand_tableau.hpp"

#include <memory>
#include <random>

using namespace c2d;
using hand::Hand;
using hand::sized;

namespace {

// Unloaded pairs without friction, each of which can push both of two bodies along a ray.
class Cone {
public:
  Cone(const std::vector<std::vector<double>>& rays, const std::vector<double>& load)
      : pairs_(static_cast<int>(rays.size())), n_(static_cast<int>(load.size())),
        hand_(unit(pairs_), {std::vector<double>(rays.size(), 0.0)}, false, 0.0), bodies_(3), zone_(), numbers_(sized(8 * n_)),
        squares_(sized(2 * n_ * n_)), resultants_(sized(2 * pairs_ * kMostMotions)), chosen_(sized(n_)) {
    hand_.start(std::vector<double>(rays.size(), 0.0));
    for (int i = 0; i < pairs_; ++i) hand_.pair(i).zone = 0;
    for (int b = 0; b < 2; ++b) {
      bodies_[sized(b)].first_motion = b == 0 ? 0 : n_ / 2;
      bodies_[sized(b)].free_motions = static_cast<int8_t>(b == 0 ? n_ / 2 : n_ - n_ / 2);
      zone_.body[b] = b;
    }
    head_.motions = n_, head_.pairs = pairs_, head_.bodies = 2;
    model_.head = &head_, model_.body = bodies_.data(), model_.zone = &zone_, model_.pair = &hand_.pair(0);
    hand_.follower().model = &model_;
    refresh(hand_.follower());
    const auto at = [&](int i) { return numbers_.data() + i * n_; };
    cone_ = std::make_unique<ForceCone>(ForceCone{hand_.follower(), model_, decision_scales(hand_.follower()), n_,
                                                  Friction::own, resultants_.data(), at(0), at(1), at(2), squares_.data(),
                                                  squares_.data() + n_ * n_, at(3), at(4), at(5), chosen_.data(), 0, 0});
    for (int i = 0; i < pairs_; ++i)
      for (int j = 0; j < n_; ++j) {
        const int side = j < n_ / 2 ? 0 : 1;
        cone_->resultants_of(hand_.pair(i), side, 0)[side == 0 ? j : j - n_ / 2] = static_cast<Real>(rays[sized(i)][sized(j)]);
      }
    for (int j = 0; j < n_; ++j) cone_->load[j] = load[sized(j)];
  }
  ForceCone& get() { return *cone_; }
  Follower& follower() { return hand_.follower(); }
  // Behind the bodies of the model stands what would have all of the motion.
  void touch_bodies() {
    for (Body& body : bodies_) body.contact = 1;
    bodies_[2].first_motion = 0;
    bodies_[2].free_motions = static_cast<int8_t>(n_);
  }
  void set_motions(int n) { head_.motions = n; }
  Ray ray(int i) { return cone_->of(hand_.pair(i), 0); }

private:
  static std::vector<std::vector<double>> unit(int n) {
    std::vector<std::vector<double>> k(sized(n), std::vector<double>(sized(n)));
    for (int i = 0; i < n; ++i) k[sized(i)][sized(i)] = 1.0;
    return k;
  }
  int pairs_, n_;
  Hand hand_;
  std::vector<Body> bodies_;
  Zone zone_;
  ModelHeader head_{};
  Model model_{};
  std::vector<double> numbers_, squares_;
  std::vector<Real> resultants_;
  std::vector<Chosen> chosen_;
  std::unique_ptr<ForceCone> cone_;
};

} // namespace

// rest = load - sum of factors times rays: at right angles to what is balanced, and no ray points along it.
TEST_CASE("force cone: what is left of a load is what no force opposes") {
  std::mt19937 engine(5);
  const auto uniform = [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine); };
  const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
  int unbalanced = 0, balanced = 0;
  for (int draw = 0; draw < 20000; ++draw) {
    CAPTURE(draw);
    const int n = 2 + below(5), pairs = 1 + below(8);
    std::vector<std::vector<double>> rays;
    for (int i = 0; i < pairs; ++i) {
      std::vector<double> ray(sized(n));
      const double beside = std::pow(10.0, -below(14)); // of one before
      const bool alike = i > 0 && below(2) == 0;
      for (int j = 0; j < n; ++j) ray[sized(j)] = alike ? rays[sized(below(i))][sized(j)] + beside * uniform() : uniform();
      rays.push_back(ray);
    }
    std::vector<double> load(sized(n));
    const double noise = below(2) == 0 ? 1.0 : std::pow(10.0, -below(12));
    for (double& x : load) x = noise * uniform();
    for (int i = 0; i < pairs && noise < 1.0; ++i) {
      const double part = uniform();
      for (int j = 0; j < n; ++j) load[sized(j)] += part * rays[sized(i)][sized(j)];
    }
    Cone c(rays, load);
    ForceCone& a = c.get();
    const bool is = is_unbalanced(a, Friction::own);
    (is ? unbalanced : balanced) += 1;
    std::vector<double> rest = load;
    double along = 0.0;
    for (int k = 0; k < a.count; ++k) {
      const Ray one = c.ray(a.chosen[k].pair);
      CHECK(a.factor[k] >= 0.0);
      add_to(rest.data(), -a.factor[k] / length(one), one);
    }
    const double size = length(load.data(), n), left = length(rest.data(), n);
    if (!is) {
      CHECK(left <= 1e-5 * size);
      continue;
    }
    CHECK(left > 1e-10 * size);
    for (int i = 0; i < pairs; ++i) CHECK(work(c.ray(i), rest.data()) <= 1e-7 * left * length(c.ray(i)) + 1e-14 * size);
    for (int j = 0; j < n; ++j) along += rest[sized(j)] * (load[sized(j)] - rest[sized(j)]);
    CHECK(std::fabs(along) <= 1e-6 * left * size);
  }
  CHECK(unbalanced > 2000);
  CHECK(balanced > 2000);
}

TEST_CASE("force cone: a body that pressure pushes back along one motion alone turns over, one that nothing pushes comes off") {
  for (const int taken : {0, 1, 2, 3})
    for (const double push : {-1.0, 1.0}) {
      CAPTURE(taken);
      CAPTURE(push);
      std::vector<double> ray(4, 0.0), load(4, 0.0);
      ray[sized(taken)] = 1.0;
      load[sized(taken)] = push;
      load[sized((taken + 1) % 4)] = 0.5;
      Cone c({ray}, load);
      REQUIRE(is_unbalanced(c.get(), Friction::own));
      CHECK(kind_of_motion(c.get()) == (push > 0.0 ? C2D_TIPPING : C2D_FREE_MOTION));
    }
}

TEST_CASE("force cone: the body in motion is one of the model's") {
  for (const int moved : {0, 1}) {
    Cone c({{0.0, 0.0, 0.0, 0.0}}, {0.0, 0.0, 0.0, 0.0});
    c.get().rest[2 * moved] = 1.0;
    c.get().rest[2 * (1 - moved) + 1] = 0.5;
    c.touch_bodies();
    CHECK(body_in_motion(c.get()) == moved);
  }
}

// Vectors of all motions stand in the place of results per pair, squares in that of the rate problem or of the tableau.
TEST_CASE("force cone: of so many motions of so few pairs that there is no room for it there is none") {
  struct Case {
    int pairs, motions;
    bool beside, in_tableau; // room beside the tableau, in its place
  };
  for (const Case& of :
       {Case{1, 1, false, true}, {1, 2, false, false}, {2, 4, false, false}, {2, 100, false, false}, {30, 3, true, true}}) {
    CAPTURE(of.pairs);
    CAPTURE(of.motions);
    Cone c(std::vector<std::vector<double>>(sized(of.pairs), std::vector<double>{1.0, 1.0}), {1.0, 1.0});
    c.set_motions(of.motions);
    Real* column = nullptr;
    CHECK((force_cone(c.follower(), &column).load != nullptr) == of.beside);
    CHECK((cone_for_tableau(c.follower(), &column).load != nullptr) == of.in_tableau);
  }
}
