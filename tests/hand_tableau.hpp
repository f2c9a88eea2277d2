#pragma once
// A tableau made by hand, of pairs with a stiffness and rates of loads that the test gives, over a block store in memory that
// may fail, and the follower of a load path on it.
#include "c2d_memory.h"
#include "contact/basis.hpp"
#include "contact/path.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hand {

using namespace c2d;

inline size_t sized(int count) { return static_cast<size_t>(count); }

// A change that was told, and the sum of the load factors there.
struct Change {
  double load;
  int32_t pair;
};

// Pairs with the rates of up to two load cases; those without a tangential direction have one unknown.
class Hand {
  static constexpr int kList = 3; // exchanges that the tableau keeps back: most changes of status are two

public:
  Hand(const std::vector<std::vector<double>>& k, const std::vector<std::vector<double>>& b, bool tangential, double mu)
      : Hand(k, b, std::vector<int>(tangential ? k.size() / 2 : k.size(), tangential ? 1 : 0), mu) {}
  // Pairs with and without a tangential direction.
  Hand(const std::vector<std::vector<double>>& k, const std::vector<std::vector<double>>& b, const std::vector<int>& tangential,
       double mu)
      : m_(static_cast<int>(k.size())), cases_(static_cast<int>(b.size())), pair_(tangential.size()),
        t_(sized(m_ * (m_ + 1 + cases_))), store_(k.size() * (k.size() + 16) * (sizeof(Real) * 2 + 64) + (1 << 16)),
        buffer_(sized(m_) + 9), y_(sized(m_)), dy_(sized(m_)), area_(sized((m_ + 1) * (m_ + 5)) + 8),
        delayed_(sized(3 * m_) + static_cast<size_t>(list_numbers(m_, kList))), lists_(pair_.size() * kRateListBytes / 8 + 1) {
    for (int j = 0; j < m_; ++j)
      for (int i = 0; i < m_; ++i) stiffness_.push_back(static_cast<Real>(k[sized(i)][sized(j)]));
    for (const std::vector<double>& of_case : b)
      for (double rate : of_case) rates_.push_back(static_cast<Real>(rate));
    int32_t dof = 0;
    for (size_t i = 0; i < pair_.size(); ++i) {
      Pair& p = pair_[i] = Pair{};
      p.tangential = static_cast<int8_t>(tangential[i]);
      p.dof = dof;
      dof += 1 + p.tangential;
      p.length = 1.0;
      p.status = C2D_STICK;
      p.law.mu = mu;
    }
    tableau_ =
        Tableau{m_, m_,      cases_, static_cast<int32_t>(pair_.size()), pair_.data(), t_.data(), 1.0, 0.0, 0, kPlainEngine,
                0,  nullptr, nullptr};
    tableau_.own = delayed_.data();
    tableau_.cross = tableau_.own + m_;
    tableau_.column = reinterpret_cast<int32_t*>(tableau_.cross + m_);
    tableau_.delayed = {m_, m_, t_.data(), kList, tableau_.cross + 2 * m_, 0};
    open_store();
    f_.t = &tableau_;
    f_.model = &model_;
    f_.tape = &tape_;
    f_.load = load_;
    f_.direction = direction_;
    f_.origin = origin_;
    f_.y = y_.data();
    f_.dy = dy_.data();
    f_.rate_area = RateArea{area_.data(), lists_.data(), tableau_.pairs};
    f_.bound.pair = -1;
    f_.watch.context = this;
    f_.watch.tick = [](void* self) { return static_cast<Hand*>(self)->tick(); };
    f_.watch.changed = [](void* self, double) { return static_cast<Hand*>(self)->note(); };
  }
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;

  Pair& pair(int i) { return pair_[sized(i)]; }
  Tableau& tableau() { return tableau_; }
  Follower& follower() { return f_; }
  double entry(int i, int j) const {
    if (j >= m_) return t_[sized(j * m_ + i)];
    return read_entry(tableau_.delayed, i, j);
  }
  void set_entry(int i, int j, double value) { t_[sized(j * m_ + i)] = static_cast<Real>(value); }
  double constant(int i) const { return entry(i, m_); }
  double rate(int i, int k = 0) const { return entry(i, m_ + 1 + k); }
  void keep_nothing_back() { tableau_.delayed.most = 0; } // no list: every exchange at once
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
  int64_t reads = 0, ticks = 0;             // so far
  int64_t fails_at = -1, cancelled_at = -1; // the read that fails, the tick that cancels

private:
  c2d_status tick() { return ticks++ == cancelled_at ? c2d_status{C2D_ERR_CANCELLED} : c2d_status{C2D_OK}; }
  c2d_status note() {
    changes.push_back({load_[0] + load_[1], f_.last_pair});
    return C2D_OK;
  }
  void open_store() {
    c2d_memory_store_init(&memory_, store_.data(), store_.size());
    port_ = C2D_INIT(c2d_port);
    c2d_memory_store_port(&memory_, &port_);
    store_port_ = port_;
    port_.context = this;
    port_.open = [](void* self, int32_t tape, uint64_t blocks, uint64_t bytes) {
      const c2d_port& to = static_cast<Hand*>(self)->store_port_;
      return to.open(to.context, tape, blocks, bytes);
    };
    port_.write = [](void* self, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
      const c2d_port& to = static_cast<Hand*>(self)->store_port_;
      return to.write(to.context, tape, block, data, bytes);
    };
    port_.read = [](void* self, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
      Hand& h = *static_cast<Hand*>(self);
      if (h.reads++ == h.fails_at) return int32_t{77};
      return h.store_port_.read(h.store_port_.context, tape, block, data, bytes);
    };
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
    const std::vector<Real> forces(static_cast<size_t>(m_)); // (kBasisForce)
    REQUIRE((!has_basis(m_) || write_column(tape_, ContactMatrix::basis, 0, forces.data()) == C2D_OK));
  }

  int m_, cases_;
  std::vector<Pair> pair_;
  std::vector<Real> t_, stiffness_, rates_;
  std::vector<unsigned char> store_;
  std::vector<double> buffer_;
  std::vector<Real> y_, dy_;
  std::vector<double> area_;
  std::vector<Real> delayed_;
  std::vector<double> lists_;
  double load_[2] = {}, direction_[2] = {}, origin_[2] = {};
  c2d_memory_store memory_{};
  c2d_port port_{}, store_port_{};
  Tapes tapes_{};
  ModelHeader head_{}; // of no bodies: what the tape's matrices are as large as
  Model model_{};
  ContactTape tape_{};
  Tableau tableau_{};
  Follower f_{};
};

} // namespace hand
