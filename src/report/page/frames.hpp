// The load path in frames: pressure, friction and statuses of each zone at recorded steps, one step shown at a time.
#pragma once

#include "report/drawn/scene.hpp"

#include <string>

namespace app {

// Appends a section per zone, of kMostFramed zones at most, to a page; none for a path of fewer than three recorded steps. A
// row of radio buttons selects the step, without a script; kFrameStyle makes it so.
constexpr int kMostFramed = 4;
void append_frames(std::string& out, const Scene& scene);
extern const char kFrameStyle[];

} // namespace app
