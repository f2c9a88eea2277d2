#pragma once
// Two bodies that meet: body 1 below or around body 2.
#include "../dice.hpp"
#include "outline.hpp"

#include <string>

namespace random_decks {

struct Scene {
  Outlines body[2];
  std::string name;
  int zones = 1;
  bool free_zones = false;    // the sides are meshed independently
  bool same_surfaces = false; // the same points on both
  bool touching = false;      // everywhere
  bool overlap = false;       // a press fit
  bool round = false;         // body 2 may roll
  // Places for conditions, as sides of the outer curves: where body 1 is held, and where body 2 is loaded.
  int32_t base = 0, top = 0, base_other = 0, top_other = 0; // others: a side beside it
  bool flush_left = false;                                  // both end there at x = 0, on the two sides from left_wall on
  int32_t left_wall[2] = {0, 0};
  Point room[2][2] = {}; // lower left and upper right corner of a box for holes, per body; empty: none
};

// `few`: at most five pairs for these functions, all touching.
Scene make_scene(Dice& dice, int32_t function_nodes, bool few);
// Symmetric about x = 0. Sides 0 and base_other are the base of body 1, which begins in its middle; the four sides from top
// on are the top of body 2, with the axis behind the second one, and the sides before and behind them are its walls.
Scene make_symmetric_scene(Dice& dice, int32_t function_nodes);

} // namespace random_decks
