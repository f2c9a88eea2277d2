#include "report/drawn/svg.hpp"

#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {
namespace {

void append_attribute(std::string& out, const char* name, double value) {
  out += ' ';
  out += name;
  out += "=\"";
  append_pixel(out, value);
  out += '"';
}

void append_stroke(std::string& out, const Stroke& stroke) {
  out += " stroke=\"";
  out += stroke.colour;
  out += '"';
  if (std::string("none") == stroke.colour) return;
  append_attribute(out, "stroke-width", stroke.width);
  if (stroke.dash[0] == '\0') return;
  out += " stroke-dasharray=\"";
  out += stroke.dash;
  out += '"';
}

// Cuts a segment to a box; false if it lies outside.
bool cut(const Box& box, Point& a, Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double p[4] = {-dx, dx, -dy, dy};
  const double q[4] = {a.x - box.left, box.right - a.x, a.y - box.top, box.bottom - a.y};
  double first = 0.0, last = 1.0;
  for (int i = 0; i < 4; ++i) {
    if (p[i] == 0.0) {
      if (q[i] < 0.0) return false;
      continue;
    }
    const double at = q[i] / p[i];
    if (p[i] < 0.0)
      first = std::max(first, at);
    else
      last = std::min(last, at);
  }
  if (first > last) return false;
  if (last < 1.0) b = {a.x + last * dx, a.y + last * dy};
  if (first > 0.0) a = {a.x + first * dx, a.y + first * dy};
  return true;
}

// Parts far outside a picture are clipped before writing: some renderers use fixed point up to
// 2^23 pixels only and draw larger shapes wrongly.
constexpr Box kPaper{-5e4, -5e4, 5e4, 5e4};

bool on_paper(Point p) { return p.x >= kPaper.left && p.x <= kPaper.right && p.y >= kPaper.top && p.y <= kPaper.bottom; }

// How far a point lies within side k of the paper.
double within(Point p, int k) {
  switch (k) {
  case 0: return p.x - kPaper.left;
  case 1: return kPaper.right - p.x;
  case 2: return p.y - kPaper.top;
  default: return kPaper.bottom - p.y;
  }
}

// A closed curve clipped to the paper side by side (Sutherland-Hodgman): the enclosed area there stays the
// same, and its new edges run along the paper's.
std::vector<Point> closed_on_paper(std::vector<Point> curve) {
  if (std::all_of(curve.begin(), curve.end(), on_paper)) return curve;
  for (int k = 0; k < 4; ++k) {
    std::vector<Point> kept;
    for (size_t i = 0; i < curve.size(); ++i) {
      const Point a = curve[i], b = curve[(i + 1) % curve.size()];
      const double from = within(a, k), to = within(b, k);
      if (from >= 0.0) kept.push_back(a);
      if ((from >= 0.0) == (to >= 0.0)) continue;
      const double f = from / (from - to);
      kept.push_back({a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)});
    }
    curve = kept;
  }
  return curve;
}

// The parts of lines that lie within a box.
Outlines parts_within(const std::vector<Point>& line, bool closed, const Box& box) {
  Outlines out;
  bool joined = false;
  for (size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    Point a = line[i], b = line[(i + 1) % line.size()];
    const Point end = b;
    if (!cut(box, a, b)) {
      joined = false;
      continue;
    }
    if (!joined) out.push_back({a});
    out.back().push_back(b);
    joined = b.x == end.x && b.y == end.y;
  }
  return out;
}

// Is every point between these two within a twentieth of a pixel of the line that joins them?
bool is_straight(const std::vector<Point>& curve, size_t from, size_t to) {
  constexpr double kStraight = 0.05;
  const double dx = curve[to].x - curve[from].x, dy = curve[to].y - curve[from].y, length = std::hypot(dx, dy);
  for (size_t i = from + 1; i < to; ++i) {
    const double x = curve[i].x - curve[from].x, y = curve[i].y - curve[from].y;
    const double along = length > 0 ? (x * dx + y * dy) / length : 0.0;
    const double off = length > 0 ? std::fabs(x * dy - y * dx) / length : std::hypot(x, y);
    if (off > kStraight || along < -kStraight || along > length + kStraight) return false;
  }
  return true;
}

// A line without points that nobody sees: they are most of the bytes of a picture. Both ends stay.
std::vector<Point> thinned(const std::vector<Point>& curve) {
  constexpr size_t kLongest = 64; // points that one line replaces
  std::vector<Point> out;
  for (size_t i = 0; i < curve.size();) {
    out.push_back(curve[i]);
    size_t next = i + 1;
    while (next + 1 < curve.size() && next - i < kLongest && is_straight(curve, i, next + 1)) ++next;
    i = next;
  }
  return out;
}

} // namespace

Outlines pieces_within(const Outlines& curves, const Box& box) {
  const double room = 10.0;
  const Box wider{box.left - room, box.top - room, box.right + room, box.bottom + room};
  Outlines out;
  for (const std::vector<Point>& curve : curves)
    for (std::vector<Point>& part : parts_within(curve, true, wider)) out.push_back(std::move(part));
  return out;
}

void append_pixel(std::string& out, double value) {
  const int64_t hundredths = std::llround(value * 100.0);
  const int64_t size = hundredths < 0 ? -hundredths : hundredths;
  if (hundredths < 0) out += '-';
  out += std::to_string(size / 100);
  const int64_t rest = size % 100;
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}

void append_curves(std::string& out, const Outlines& curves) {
  for (const std::vector<Point>& whole : curves) {
    const std::vector<Point> curve = thinned(closed_on_paper(whole));
    for (size_t i = 0; i < curve.size(); ++i) {
      out += i == 0 ? 'M' : 'L';
      append_pixel(out, curve[i].x);
      out += ' ';
      append_pixel(out, curve[i].y);
    }
    if (!curve.empty()) out += 'Z';
  }
}

std::string escape_xml(const std::string& text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const size_t bytes = character_at(text, i);
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (bytes == 0)
      out += '?';
    else
      out.append(text, i, bytes);
    i += bytes > 1 ? bytes - 1 : 0;
  }
  return out;
}

double text_width(const std::string& text, double size) {
  size_t characters = 0;
  for (size_t i = 0; i < text.size(); ++i, ++characters) {
    const unsigned char byte = static_cast<unsigned char>(text[i]);
    if (text[i] == '&') i = std::min(text.find(';', i), text.size());
    const size_t bytes = character_at(text, i);
    if (bytes > 1) i += bytes - 1;
    if (byte >= 0xe3) ++characters; // of scripts whose letters are wide
  }
  return 0.6 * size * static_cast<double>(characters);
}

Svg::Svg(const std::string& name, double width, double height) : name_(name), width_(width), height_(height) {}

void Svg::line(Point from, Point to, const Stroke& stroke) {
  if (!(on_paper(from) && on_paper(to)) && !cut(kPaper, from, to)) return;
  body_ += "<line";
  append_attribute(body_, "x1", from.x);
  append_attribute(body_, "y1", from.y);
  append_attribute(body_, "x2", to.x);
  append_attribute(body_, "y2", to.y);
  append_stroke(body_, stroke);
  body_ += "/>\n";
}

void Svg::polyline(const std::vector<Point>& points, const Stroke& stroke) {
  if (points.empty()) return;
  Outlines parts{points};
  if (!std::all_of(points.begin(), points.end(), on_paper)) parts = parts_within(points, false, kPaper);
  for (const std::vector<Point>& part : parts) {
    body_ += "<polyline points=\"";
    for (const Point& p : thinned(part)) {
      append_pixel(body_, p.x);
      body_ += ',';
      append_pixel(body_, p.y);
      body_ += ' ';
    }
    body_.back() = '"';
    body_ += " fill=\"none\" stroke-linejoin=\"round\"";
    append_stroke(body_, stroke);
    body_ += "/>\n";
  }
}

void Svg::area(const Outlines& curves, const std::string& fill, const Stroke& stroke) {
  body_ += "<path d=\"";
  append_curves(body_, curves);
  body_ += "\" fill=\"" + fill + "\" fill-rule=\"evenodd\" stroke-linejoin=\"round\"";
  append_stroke(body_, stroke);
  body_ += "/>\n";
}

void Svg::rectangle(const Box& whole, const std::string& fill, const Stroke& stroke) {
  const Box box{std::max(whole.left, kPaper.left), std::max(whole.top, kPaper.top), std::min(whole.right, kPaper.right),
                std::min(whole.bottom, kPaper.bottom)};
  if (box.right < box.left || box.bottom < box.top) return;
  body_ += "<rect";
  append_attribute(body_, "x", box.left);
  append_attribute(body_, "y", box.top);
  append_attribute(body_, "width", box.width());
  append_attribute(body_, "height", box.height());
  body_ += " fill=\"" + fill + '"';
  append_stroke(body_, stroke);
  body_ += "/>\n";
}

void Svg::mark(Mark mark, Point at, double size, const char* ink, bool filled) {
  if (!on_paper(at)) return;
  const double r = size / 2.0;
  const std::string fill = filled ? ink : "white";
  const Stroke edge{ink, 1.2, ""};
  switch (mark) {
  case Mark::kNone: return;
  case Mark::kCircle:
    body_ += "<circle";
    append_attribute(body_, "cx", at.x);
    append_attribute(body_, "cy", at.y);
    append_attribute(body_, "r", r);
    body_ += " fill=\"" + fill + '"';
    append_stroke(body_, edge);
    body_ += "/>\n";
    return;
  case Mark::kSquare: rectangle({at.x - r, at.y - r, at.x + r, at.y + r}, fill, edge); return;
  case Mark::kTriangle: area({{{at.x - r, at.y + r}, {at.x + r, at.y + r}, {at.x, at.y - r}}}, fill, edge); return;
  case Mark::kDiamond: area({{{at.x - r, at.y}, {at.x, at.y + r}, {at.x + r, at.y}, {at.x, at.y - r}}}, fill, edge); return;
  case Mark::kCross:
    line({at.x - r, at.y - r}, {at.x + r, at.y + r}, edge);
    line({at.x - r, at.y + r}, {at.x + r, at.y - r}, edge);
    return;
  }
}

void Svg::arrow(Point from, Point to, const Stroke& stroke, double size, Head head) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (length < 0.1) return;
  const double ex = dx / length, ey = dy / length, h = size < length ? size : length;
  const Point neck{to.x - h * ex, to.y - h * ey};
  const double w = 0.42 * h;
  const Point left{neck.x - w * ey, neck.y + w * ex}, right{neck.x + w * ey, neck.y - w * ex};
  line(from, head == Head::kFilled ? neck : to, stroke);
  if (head == Head::kFilled) area({{to, left, right}}, stroke.colour, Stroke{});
  if (head == Head::kOpen) polyline({left, to, right}, Stroke{stroke.colour, stroke.width, ""});
}

void Svg::text(Point at, const std::string& text, double size, Anchor anchor, const char* ink, bool turned, bool halo) {
  if (!on_paper(at)) return;
  body_ += "<text";
  append_attribute(body_, "x", at.x);
  append_attribute(body_, "y", at.y);
  append_attribute(body_, "font-size", size);
  if (anchor != Anchor::kStart) body_ += anchor == Anchor::kMiddle ? " text-anchor=\"middle\"" : " text-anchor=\"end\"";
  body_ += " fill=\"";
  body_ += ink;
  body_ += '"';
  if (turned) {
    body_ += " transform=\"rotate(-90 ";
    append_pixel(body_, at.x);
    body_ += ' ';
    append_pixel(body_, at.y);
    body_ += ")\"";
  }
  if (halo) body_ += " stroke=\"white\" stroke-width=\"3\" paint-order=\"stroke\"";
  body_ += '>' + text + "</text>\n";
}

std::string Svg::hatch(const char* ink, const char* ground) {
  const std::string id = name_ + "-" + std::to_string(++ids_);
  definitions_ += "<pattern id=\"" + id +
                  "\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
                  "patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"" +
                  ground + "\"/><rect width=\"2\" height=\"6\" fill=\"" + ink + "\"/></pattern>\n";
  return "url(#" + id + ")";
}

void Svg::begin_clip(const Box& box) {
  begin_clip({{{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}});
}

void Svg::begin_clip(const Outlines& curves) {
  const std::string id = name_ + "-" + std::to_string(++ids_);
  definitions_ += "<clipPath id=\"" + id + "\"><path clip-rule=\"evenodd\" d=\"";
  append_curves(definitions_, curves);
  definitions_ += "\"/></clipPath>\n";
  body_ += "<g clip-path=\"url(#" + id + ")\">\n";
}

std::string Svg::finish(const std::string& title, const std::string& description) const {
  std::string size;
  append_attribute(size, "width", width_);
  append_attribute(size, "height", height_);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + size + " viewBox=\"0 0 ";
  append_pixel(out, width_);
  out += ' ';
  append_pixel(out, height_);
  out += "\" font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" role=\"img\">\n<title>" + title +
         "</title>\n<desc>" + description + "</desc>\n";
  if (!definitions_.empty()) out += "<defs>\n" + definitions_ + "</defs>\n";
  out += "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  return out + body_ + "</svg>\n";
}

} // namespace app
