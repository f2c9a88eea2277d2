#pragma once
// One random deck: solved, judged by laws, by equations of its own, by all statuses where they are few, and told in other
// ways.
#include "forms.hpp"
#include "laws.hpp"

namespace random_decks {

// The last three: three_bodies.hpp, revolved_bodies.hpp, resumed.hpp.
enum class Kind { any, few_pairs, lifted, symmetric, three, revolved, resumed };

struct Verdict {
  std::string title;
  std::string deck; // its text
  c2d_status status = C2D_OK;
  c2d_outcome outcome = C2D_REACHED;
  double load = 0;                                  // reached
  double seconds = 0;                               // of the deck alone
  bool not_unique = false, undefined_place = false; // said so
  bool unstressed = false;                          // of many bodies: nothing is pressed or bent
  bool tried = false;                               // all statuses
  bool unlike_its_image = false;                    // a symmetric model's state, where that is said
  int32_t other_choices = 0;                        // of equivalent forms, where that is said
  std::vector<std::string> findings;                // empty: nothing is wrong
};

Verdict judge(Kind kind, uint64_t seed);

} // namespace random_decks
