#include "report/pictures/contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

struct CellCorner {
  Point at;
  double value;
};

CellCorner between(const CellCorner& a, const CellCorner& b, double level) {
  const double part = (level - a.value) / (b.value - a.value);
  return {{a.at.x + part * (b.at.x - a.at.x), a.at.y + part * (b.at.y - a.at.y)}, level};
}

// The part of a convex polygon on one side of a level (Sutherland-Hodgman clipping).
std::vector<CellCorner> cut(const std::vector<CellCorner>& polygon, double level, bool above) {
  std::vector<CellCorner> out;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const CellCorner& a = polygon[i];
    const CellCorner& b = polygon[(i + 1) % polygon.size()];
    const bool in_a = above ? a.value >= level : a.value <= level;
    const bool in_b = above ? b.value >= level : b.value <= level;
    if (in_a) out.push_back(a);
    if (in_a != in_b) out.push_back(between(a, b, level));
  }
  return out;
}

size_t band_of(double value, const std::vector<double>& levels) {
  const size_t bands = levels.size() - 1;
  const auto above = std::upper_bound(levels.begin(), levels.end(), value);
  const size_t k = static_cast<size_t>(above - levels.begin());
  return k == 0 ? 0 : std::min(k - 1, bands - 1);
}

void fill_triangle(const std::vector<CellCorner>& triangle, const std::vector<double>& levels, std::vector<Polygons>& out) {
  size_t low = out.size(), high = 0;
  for (const CellCorner& c : triangle) {
    low = std::min(low, band_of(c.value, levels));
    high = std::max(high, band_of(c.value, levels));
  }
  for (size_t k = low; k <= high; ++k) {
    std::vector<CellCorner> part = triangle;
    if (k > low) part = cut(part, levels[k], true);
    if (k < high) part = cut(part, levels[k + 1], false);
    if (part.size() < 3) continue;
    out[k].emplace_back();
    for (const CellCorner& c : part) out[k].back().push_back(c.at);
  }
}

bool cell_is_known(const Grid& g, size_t c, size_t r) {
  return g.known[g.at(c, r)] && g.known[g.at(c + 1, r)] && g.known[g.at(c, r + 1)] && g.known[g.at(c + 1, r + 1)];
}

// The band of a cell that lies entirely in one band; else the number of bands.
size_t whole_band(const Grid& g, size_t c, size_t r, const std::vector<double>& levels) {
  const size_t none = levels.size() - 1;
  if (!cell_is_known(g, c, r)) return none;
  const size_t k = band_of(g.values[g.at(c, r)], levels);
  for (const size_t i : {g.at(c + 1, r), g.at(c, r + 1), g.at(c + 1, r + 1)})
    if (band_of(g.values[i], levels) != k) return none;
  return k;
}

void fill_cell(const Grid& g, size_t c, size_t r, const std::vector<double>& levels, std::vector<Polygons>& out) {
  const auto corner = [&](size_t i, size_t k) { return CellCorner{g.place(i, k), g.values[g.at(i, k)]}; };
  const CellCorner a = corner(c, r), b = corner(c + 1, r), d = corner(c + 1, r + 1), e = corner(c, r + 1);
  if (std::fabs(a.value - d.value) <= std::fabs(b.value - e.value)) { // along the flatter diagonal
    fill_triangle({a, b, d}, levels, out);
    fill_triangle({a, d, e}, levels, out);
  } else {
    fill_triangle({a, b, e}, levels, out);
    fill_triangle({b, d, e}, levels, out);
  }
}

// Value for an unknown node from its known neighbours; false if it has none.
bool continued(const Grid& g, const std::vector<char>& known, size_t c, size_t r, double& value) {
  double near = 0.0, far = 0.0;
  int nears = 0, fars = 0;
  const auto index = [&](int i, int k, size_t& at) {
    const int64_t column = static_cast<int64_t>(c) + i, row = static_cast<int64_t>(r) + k;
    if (column < 0 || row < 0 || column >= static_cast<int64_t>(g.columns) || row >= static_cast<int64_t>(g.rows)) return false;
    at = g.at(static_cast<size_t>(column), static_cast<size_t>(row));
    return known[at] != 0;
  };
  for (int i = -1; i <= 1; ++i)
    for (int k = -1; k <= 1; ++k) {
      size_t one = 0, two = 0;
      if ((i == 0 && k == 0) || !index(i, k, one)) continue;
      near += g.values[one], ++nears;
      if (index(2 * i, 2 * k, two)) far += 2.0 * g.values[one] - g.values[two], ++fars;
    }
  if (nears == 0) return false;
  value = fars > 0 ? far / fars : near / nears;
  return true;
}

} // namespace

void extend(Grid& g, int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<char> known = g.known;
    for (size_t r = 0; r < g.rows; ++r)
      for (size_t c = 0; c < g.columns; ++c) {
        double value = 0.0;
        if (known[g.at(c, r)] || !continued(g, known, c, r, value)) continue;
        g.values[g.at(c, r)] = value;
        g.known[g.at(c, r)] = 1;
      }
  }
}

std::vector<Polygons> fill_bands(const Grid& g, const std::vector<double>& levels) {
  const size_t bands = levels.size() - 1;
  std::vector<Polygons> out(bands);
  for (size_t r = 0; r + 1 < g.rows; ++r)
    for (size_t c = 0; c + 1 < g.columns;) {
      const size_t band = whole_band(g, c, r, levels);
      size_t end = c + 1;
      if (band < bands) {
        while (end + 1 < g.columns && whole_band(g, end, r, levels) == band) ++end;
        out[band].push_back({g.place(c, r), g.place(end, r), g.place(end, r + 1), g.place(c, r + 1)});
      } else if (cell_is_known(g, c, r)) {
        fill_cell(g, c, r, levels, out);
      }
      c = end;
    }
  return out;
}

double distance_to_outline(const Outlines& curves, Point p) {
  double least = HUGE_VAL;
  for (const std::vector<Point>& curve : curves)
    for (size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
      const Point a = curve[j], way = curve[i] - a;
      const double square = dot(way, way), along = square > 0.0 ? dot(p - a, way) / square : 0.0;
      least = std::min(least, distance(p, a + std::min(1.0, std::max(0.0, along)) * way));
    }
  return least;
}

bool is_inside(const Outlines& curves, Point p) {
  bool inside = false;
  for (const std::vector<Point>& curve : curves)
    for (size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
      const Point a = curve[i], b = curve[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  return inside;
}

std::string scale_colour(double place) {
  static const int kAnchors[6][3] = {{255, 248, 220}, {252, 214, 130}, {244, 152, 88},
                                     {208, 84, 112},  {132, 44, 140},  {40, 26, 104}};
  const double x = std::min(1.0, std::max(0.0, place)) * 5.0;
  const int i = std::min(4, static_cast<int>(x));
  char text[16];
  int c[3];
  for (int k = 0; k < 3; ++k)
    c[k] = static_cast<int>(std::lround(kAnchors[i][k] + (x - i) * (kAnchors[i + 1][k] - kAnchors[i][k])));
  std::snprintf(text, sizeof text, "#%02x%02x%02x", c[0] & 255, c[1] & 255, c[2] & 255);
  return text;
}

} // namespace app
