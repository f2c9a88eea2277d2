#pragma once
// Random numbers that are the same on every machine (splitmix64; the standard library's distributions are not).
#include <cmath>
#include <cstdint>

namespace random_decks {

class Dice {
public:
  explicit Dice(uint64_t seed) : state_(seed) { state_ = bits() ^ 0x632BE59BD9B4E019u; } // seeds beside each other differ
  uint64_t bits() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double a, double b) { return a + (b - a) * unit(); }
  double power(double a, double b) { return std::pow(10.0, between(a, b)); } // 10^a ... 10^b
  int32_t whole(int32_t a, int32_t b) {                                      // both ends included
    return a + static_cast<int32_t>(bits() % static_cast<uint64_t>(b - a + 1));
  }
  bool chance(double p) { return unit() < p; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

private:
  uint64_t state_;
};

} // namespace random_decks
