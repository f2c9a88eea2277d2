// A picture as SVG text: shapes, markers, hatching and text with presentation attributes only, so that a
// picture stands alone as well as inside a page. Coordinates are pixels, y downwards; of what
// reaches far out of the picture only the parts within 5e4 pixels are written.
#pragma once

#include "post/point.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

using Outlines = std::vector<std::vector<Point>>; // closed curves; holes are curves of their own
struct Box {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};
struct Stroke {
  const char* colour = "none";
  double width = 1.0;
  const char* dash = ""; // as stroke-dasharray; empty: solid
};
enum class Anchor { kStart, kMiddle, kEnd };
enum class Head { kNone, kFilled, kOpen };
enum class Mark { kNone, kCircle, kSquare, kTriangle, kDiamond, kCross };

// Colours that stay apart for colour-blind people and in grey print, each used with one line style or marker.
namespace colour {
constexpr char kInk[] = "#222222";
constexpr char kGrid[] = "#dddddd";
constexpr char kFaint[] = "#888888";
constexpr char kBlue[] = "#0060a8";
constexpr char kOrange[] = "#d55e00";
constexpr char kGreen[] = "#007a5a";
constexpr char kPurple[] = "#a0438a";
constexpr char kTie[] = "#b8005c";
} // namespace colour

// Text for XML: markup characters and what is not ASCII as entities; control characters as '?'.
std::string escape_xml(const std::string& text);
// Width of `text` (an entity is one character) in a face of `size` pixels: 0.6 em a character, which running
// text exceeds in none of the common sans-serif faces.
double text_width(const std::string& text, double size);

class Svg {
public:
  // `name` begins every id, so that several pictures can share a page.
  Svg(const std::string& name, double width, double height);

  void line(Point from, Point to, const Stroke& stroke);
  void polyline(const std::vector<Point>& points, const Stroke& stroke);
  // Closed curves filled by the even-odd rule: holes are curves of their own.
  void area(const std::vector<std::vector<Point>>& curves, const std::string& fill, const Stroke& stroke);
  void rectangle(const Box& box, const std::string& fill, const Stroke& stroke);
  void mark(Mark mark, Point at, double size, const char* ink, bool filled = true);
  // A shaft with a head of `size` at `to`; the shaft alone is dashed.
  void arrow(Point from, Point to, const Stroke& stroke, double size = 5.0, Head head = Head::kFilled);
  // `text` may contain entities: pass words of the user through escape_xml first. `turned`: reads upwards.
  // `halo`: with a white rim, over lines.
  void text(Point at, const std::string& text, double size, Anchor anchor = Anchor::kStart, const char* ink = colour::kInk,
            bool turned = false, bool halo = false);
  // A fill with diagonal lines on `ground`.
  std::string hatch(const char* ink, const char* ground);
  // What follows is cut off outside; ends with end_clip().
  void begin_clip(const Box& box);
  void begin_clip(const std::vector<std::vector<Point>>& curves);
  void end_clip() { body_ += "</g>\n"; }
  // Path data of closed curves, for area and clip.
  void raw(const std::string& markup) { body_ += markup; }

  double width() const { return width_; }
  double height() const { return height_; }
  void set_height(double height) { height_ = height; }
  // The whole file, without an XML declaration; title and description for screen readers.
  std::string finish(const std::string& title, const std::string& description) const;

private:
  std::string name_, body_, definitions_;
  double width_, height_;
  int ids_ = 0;
};

// The parts of closed curves that lie within a box or close to it.
std::vector<std::vector<Point>> pieces_within(const std::vector<std::vector<Point>>& curves, const Box& box);

// Appends a coordinate with two decimals at most.
void append_pixel(std::string& out, double value);
void append_curves(std::string& out, const std::vector<std::vector<Point>>& curves);

} // namespace app
