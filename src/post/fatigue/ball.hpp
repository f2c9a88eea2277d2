// The smallest ball that encloses points in three dimensions.
#pragma once

#include <array>
#include <vector>

namespace app {

using SpacePoint = std::array<double, 3>;
struct Ball {
  SpacePoint centre{};
  double radius = 0;
};
Ball smallest_ball(const std::vector<SpacePoint>& points);

} // namespace app
