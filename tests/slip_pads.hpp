#pragma once
// A sketch in which pairs slide past changes of curvature on both sides.
#include <string>

namespace test {

// Two half planes, each flat and arc, C2 symmetric; the upper one is moved by d.
inline std::string slip_pads(const std::string& round = "arc round to -ax -ay centre -b -R",
                             const std::string& toe = "arc toe to ax ay centre b R") {
  return R"(
parameter R 50 b 5 P 4000 L 400 d 0.14 w 8 mu 0 nu 0.3
parameter Es 5e4 E {2*Es*(1-nu^2)}
parameter ax {b+w} ay {R-sqrt(R^2-w^2)} sl {w/sqrt(R^2-w^2)}
body block E E nu nu
  from -L -L
  line bottom to L -L
  line right to L 0
  line top to -b 0
  )" + round +
         R"(
  line slope to -40 {-ay-(40-ax)*sl}
  line far to -L {-ay-(40-ax)*sl}
  line left close
body pad E E nu nu
  from L L
  line lid to -L L
  line pleft to -L 0
  line flat to b 0
  )" + toe +
         R"(
  line pslope to 40 {ay+(40-ax)*sl}
  line pfar to L {ay+(40-ax)*sl}
  line pright close
contact block.top+round pad.flat+toe mu mu
fix block.bottom
case normal
  platen pad.lid about 0 L x 0 fy -P turn 0
case shift
  platen pad.lid about 0 L x d
want pressure edges
)";
}

} // namespace test
