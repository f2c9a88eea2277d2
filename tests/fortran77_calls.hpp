// The FORTRAN 77 names called as a compiler of FORTRAN calls them: arrays at odd addresses, texts padded with blanks,
// everything by reference.
#pragma once

#include "fortran77.hpp"
#include "paths.hpp"
#include "shell.hpp"

namespace test {

using c2d::fortran::integer_at;
using c2d::fortran::put_real;
using c2d::fortran::real_at;

// Memory whose address is `odd` bytes behind a multiple of 64.
class Odd {
public:
  Odd(size_t bytes, size_t odd) : bytes_(bytes + 128), odd_(odd) {}
  void* at() {
    const uintptr_t address = reinterpret_cast<uintptr_t>(bytes_.data());
    return bytes_.data() + (64 - address % 64) + odd_;
  }

private:
  std::vector<unsigned char> bytes_;
  size_t odd_;
};

// Arguments as FORTRAN hands them over: the address of a copy.
struct I {
  int32_t value;
  operator In() const { return &value; }
};
struct R {
  double value;
  operator In() const { return &value; }
};

constexpr int32_t kIntegers[2] = {1987, 64};
constexpr double kLiteral[1] = {1987.015625};
constexpr int32_t kWords = 60000;

inline int32_t open(void* work, int32_t words = kWords) {
  int32_t error = -1;
  c2open_(work, I{words}, kIntegers, kLiteral, &error);
  return error;
}

inline std::vector<std::string> cards_of(const std::string& file) {
  return lines_of(read_file(paths::root() + "/examples/" + file));
}

// CHARACTER*80 CARDS(N).
inline std::string padded(const std::vector<std::string>& cards) {
  std::string out;
  for (std::string card : cards) {
    card.resize(80, ' ');
    out += card;
  }
  return out;
}

} // namespace test
