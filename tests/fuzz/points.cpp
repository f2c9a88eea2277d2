// CSV of points inside: every row is taken or told.
#include "fuzz.hpp"

#include "program/files/points_file.hpp"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text = fuzz::text_of(data, size);
  for (const int32_t bodies : {1, 3}) {
    app::DeckFile file;
    file.call("points.csv");
    file.replace(text);
    app::Messages messages(file);
    std::vector<app::WantedPoint> points;
    const bool sound = app::read_points(file, bodies, messages, points);
    fuzz::require(sound || !messages.latest().empty(), "what is refused is told");
    fuzz::require(!sound || !points.empty(), "points, or a fault");
    fuzz::require(points.size() <= file.cards(), "a point per row");
    for (const app::WantedPoint& p : points) {
      fuzz::require(p.body >= 1 && p.body <= bodies && std::isfinite(p.x) && std::isfinite(p.y), "a point of a body");
      fuzz::require(p.line >= 1 && static_cast<size_t>(p.line) <= file.cards(), "a line of the file");
    }
  }
  return 0;
}
