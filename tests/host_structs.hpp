#pragma once
// Structs of the interface as the tests keep them: with the lists that belong to them.
#include "contact2d.h"

#include <cstring>
#include <vector>

namespace host {

struct Limits : c2d_limits { // of two bodies, with room for some more
  static constexpr int32_t kRoom = 8;
  c2d_body_limits list[kRoom] = {};
  Limits() : c2d_limits(C2D_INIT(c2d_limits)) {
    bodies = 2;
    body = list;
  }
  Limits(const Limits& other) : c2d_limits(other) { take(other); }
  Limits& operator=(const Limits& other) {
    c2d_limits::operator=(other);
    take(other);
    return *this;
  }

private:
  void take(const Limits& other) {
    for (int b = 0; b < kRoom; ++b) list[b] = other.list[b];
    body = list;
  }
};

// The same numbers, whosever lists hold them.
inline bool same_numbers(Limits a, Limits b) {
  const bool same_bodies = std::memcmp(a.list, b.list, sizeof a.list) == 0;
  a.body = b.body = nullptr;
  const c2d_limits &one = a, &other = b;
  return same_bodies && std::memcmp(&one, &other, sizeof one) == 0;
}

// One for each body, of two or more of them.
template <class T> struct OfBodies : std::vector<T> {
  OfBodies() : std::vector<T>(2) {}
  explicit OfBodies(const T& empty) : std::vector<T>(2, empty) {}
  template <class Index> T& operator[](Index b) { return this->at(static_cast<size_t>(b)); }
  template <class Index> const T& operator[](Index b) const { return this->at(static_cast<size_t>(b)); }
};

struct Summary : c2d_summary {
  OfBodies<c2d_body_result> body = OfBodies<c2d_body_result>(C2D_INIT(c2d_body_result));
  Summary() : c2d_summary(C2D_INIT(c2d_summary)) {}
};
inline c2d_status get_summary(c2d_solver* s, Summary& out) {
  c2d_status status = c2d_get_summary(s, &out);
  if (out.bodies > 2) out.body.resize(static_cast<size_t>(out.bodies), C2D_INIT(c2d_body_result));
  for (int32_t b = 1; b <= out.bodies && status == C2D_OK; ++b) status = c2d_get_body_result(s, b, &out.body[b - 1]);
  return status;
}
inline Summary summary_of(c2d_solver* s) {
  Summary out;
  get_summary(s, out);
  return out;
}

} // namespace host
