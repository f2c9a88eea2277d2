#pragma once
// Random sketches: seed to text. Shapes, materials, supports, friction, load histories and units vary; each is a problem that
// has an answer, or one that the program has to say something about (a pad pushed harder than friction holds).
#include <cstdint>
#include <string>

namespace random_sketches {

struct Drawn {
  std::string text;
  std::string scene;  // in words: shapes, friction, loads
  bool sharp = false; // a corner presses where stress has no bound
};

Drawn draw(uint64_t seed);
// Bodies of revolution: an indenter on a block, a hollow ball pressed into a shell.
Drawn draw_revolved(uint64_t seed);
// Cycles until they are steady: an indenter that is loaded by turns, a ring that creeps in its housing.
Drawn draw_cycles(uint64_t seed);

} // namespace random_sketches
