#pragma once
// Spence's punch, flat and rigid, with friction on a half plane: where sticking ends. From the half plane's own integrals
// (Boussinesq and Cerruti) with constant tractions on a graded mesh: nothing of the library, no block, no events.
#include <string>
#include <vector>

namespace random_decks {

// Half width of the sticking part over that of the punch, within a tenth of (1 - c) or of c, whichever is less; 0: below 1e-4.
double spence_border(double mu, double nu);

struct Punch {
  double mu, nu;
  double border = 0; // by spence_border
  bool solved = false;
  double sticks = 0, slips = 1; // last node that sticks, first that slips
  std::string message = std::string();
  bool border_within_a_node() const;     // at most a node's distance beyond the two
  double node_below = 0, node_above = 1; // the nodes next to those
};
// `contact2d make punch mu= nu=` with its defaults, solved.
Punch solve_punch(double mu, double nu);
std::vector<Punch> all_punches(); // 84 of mu in [0.05, 1] and nu in [0, 0.45], not solved

} // namespace random_decks
