// Chapter 9 of the dissertation of 1987: what the increments of the load and the sizes of the elements do to
// the friction under a rigid cylinder that adheres to a half plane. Decks come from the family
// cylinder_friction of `contact2d make`; they are followed in increments, as in 1987, or from event to event.
#pragma once

#include <string>
#include <vector>

namespace chapter9 {

struct Increments { // equal ones, from the load reached before to `load`
  int count;
  double load;
};
using LoadCards = std::vector<Increments>;
LoadCards equal(int count);
// Increments each of which just brings the next pair into contact; `touching`: the loads of Run, with events.
// Where the increment has no solution (held back for all of the increment, the pair would be pulled; left
// open, the bodies would overlap) it is lengthened by 5 % until it has one, as in 1987.
LoadCards pair_by_pair(const std::vector<std::string>& settings, const std::vector<double>& touching);
LoadCards divided(LoadCards cards, int parts); // every increment in so many equal ones
int count_of(const LoadCards& cards);

// The deck of `contact2d make cylinder_friction` with these settings and load cards.
std::string make_deck(const std::vector<std::string>& settings, const LoadCards& cards);

struct Node {      // of the half plane, at full load
  double x;        // distance from the axis over a0, the half width without friction
  double pressure; // over p0 = 2 P / (pi a0), the largest pressure without friction
  double friction; // the same; positive: outward on the half plane
  bool closed;
};
struct Run {
  std::string error;            // empty: solved
  std::vector<Node> nodes;      // by rising x
  std::vector<double> touching; // load factors at which pairs closed, with events
  bool by_events = false;       // an increment had no solution and was finished by following events
};
int pairs_closed(const Run& run);
enum class Stepping { kEvents, kIncrements };
Run follow(const std::string& deck, Stepping stepping);

// Full adhesion on a half plane of Poisson's ratio nu, in the limit of infinitely small increments and
// elements: stamps of growing width, each of which leaves the field of a flat punch that adheres (D. A.
// Spence, 1968).
class Adhesion {
public:
  explicit Adhesion(double nu);
  double half_width() const; // over a0
  double friction(double x) const;
  double pressure(double x) const;

private:
  double sum(double x, bool cosine) const;
  double epsilon_, load_; // load over that without friction for the same half width
};

// Differences of friction over the largest friction of `exact`, at the nodes within kInside of the half
// width: the last nodes, beyond which nothing touches, are not what the increments are about.
constexpr double kInside = 0.85;
struct Difference {
  double rms = 0, largest = 0; // root of the mean square
};
Difference compare(const Run& run, const Run& exact); // over the same nodes
Difference compare(const Run& run, const Adhesion& exact);
double largest_friction(const Run& run);

} // namespace chapter9
