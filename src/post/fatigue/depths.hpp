// Places below a surface at which stresses are taken for a mean over a length, or for a crack; with the weights of the
// stresses.
#pragma once

#include <vector>

namespace app {

struct DepthWeight {
  double depth, weight;
};

// The mean over the depths from 0 to `length`.
std::vector<DepthWeight> mean_over_depth(double length);

// The stress intensity, mode I, of an edge crack of this length, normal to a straight free surface: the sum of the weights
// times the normal stress on its line without the crack.
std::vector<DepthWeight> edge_crack(double length);

} // namespace app
