// Contact on demand of bodies that the contact alone holds, wholly or in some of their motions.
#include "on_demand.hpp"

using namespace demand;

namespace {

// The upper block of many::rough, pressed by a pressure instead.
many::Model floating(int32_t pairs, double pressure = 0.05) {
  many::Model m = many::rough(pairs);
  m.set(2, 3, many::end_of(many::kPulled, 0, -pressure));
  return m;
}

} // namespace

TEST_CASE("on demand: a block that the contact alone holds, pressed by a pressure" * doctest::skip(c2d::kSmallCode)) {
  for (double mu : {0.3, 1.5}) {
    CAPTURE(mu);
    many::Model m = floating(300);
    m.friction = mu;
    check_alike(m, 100);
  }
}
TEST_CASE("on demand: a block that is held along x, and one along y, and pressed" * doctest::skip(c2d::kSmallCode)) {
  for (const bool along_x : {false, true})
    for (double mu : {0.0, 0.3}) {
      if (mu == 0 && !along_x) continue; // slides freely
      CAPTURE(mu);
      CAPTURE(along_x);
      many::Model m = many::rough(300);
      m.friction = mu;
      m.set(2, 3, along_x ? many::end_of("1001", 0, -0.05) : many::end_of("0110", 0, 0, 0, -1.5e-4));
      check_alike(m, 100);
    }
}
