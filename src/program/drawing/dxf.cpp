#include "program/drawing/dxf.hpp"

#include "program/drawing/dxf_groups.hpp"
#include "program/drawing/nurbs.hpp"
#include "program/drawing/placing.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace drawing {
namespace {

double degrees(double radians) { return radians * 180 / kHalfTurn; }

// What $INSUNITS means; empty: no unit, or one that hardly is that of a drawing.
std::string unit_of(int64_t code) {
  const std::pair<int, const char*> known[] = {{1, "in"}, {2, "ft"}, {4, "mm"}, {5, "cm"}, {6, "m"}, {9, "mil"}, {13, "um"}};
  for (const auto& [number, name] : known)
    if (code == number) return name;
  return "";
}

// From corner to corner of a polyline: bulge is the tangent of a quarter of the angle, above 0 counter-clockwise.
Curve with_bulge(Point from, Point to, double bulge) {
  if (std::fabs(bulge) < 1e-12) return straight(from, to);
  const Point chord = to - from;
  const Point centre = 0.5 * (from + to) + ((1 - bulge * bulge) / (4 * bulge)) * sketch::turned_left(chord);
  const Point arm = from - centre;
  Curve c = circular(centre, sketch::length(arm), degrees(std::atan2(arm.y, arm.x)), degrees(4 * std::atan(bulge)));
  if (!c.whole) move_ends(c, from, to);
  return c;
}

// What is drawn in a plane that is seen from behind: x goes to -x.
Curve mirrored(Curve c) { return placed(std::move(c), {{}, {}, 1, 180, true}); }

struct Vertex {
  Point at;
  double bulge = 0;
};

class DxfReader {
public:
  explicit DxfReader(std::string_view text) : groups_(groups_of(text)) {}
  Drawing read();

private:
  enum class Plane { kFront, kBack, kOther };
  static Plane plane_of(const Entity& e);
  void header(size_t first, size_t last);
  std::vector<Entity> entities(size_t first, size_t last) const;
  void blocks(size_t first, size_t last);
  void draw(const std::vector<Entity>& all, int depth);
  bool insert(const Entity& e, int depth);
  bool take(const Entity& e); // false: passed over
  void polyline(const std::vector<Vertex>& vertices, bool closed, const Entity& e);
  void light_polyline(const Entity& e);
  size_t old_polyline(const std::vector<Entity>& all, size_t at);
  void ellipse(const Entity& e);
  void spline(const Entity& e);
  void add(Curve curve, const Entity& e, bool own_plane);

  std::vector<Group> groups_;
  Drawing drawing_;
  struct Block {
    Point base;
    std::vector<Entity> entities;
  };
  std::map<std::string, Block> blocks_;
  int inserts_ = 0;
  int slanting_ = 0;
  std::map<std::string, int> passed_over_;
};

DxfReader::Plane DxfReader::plane_of(const Entity& e) {
  const double x = e.number(210, 0, "the normal of a plane"), y = e.number(220, 0, "the normal of a plane");
  const double z = e.number(230, 1, "the normal of a plane");
  if (std::fabs(x) > 1e-9 || std::fabs(y) > 1e-9 || z == 0) return Plane::kOther;
  return z > 0 ? Plane::kFront : Plane::kBack;
}

// `own_plane`: coordinates are those of the plane in which the entity lies.
void DxfReader::add(Curve curve, const Entity& e, bool own_plane) {
  if (e.number(30, 0, "z") != e.number(31, e.number(30, 0, "z"), "z") && e.type == "LINE") ++slanting_;
  if (own_plane && plane_of(e) == Plane::kBack) curve = mirrored(curve);
  curve.name = e.text(8) == "0" ? std::string() : std::string(e.text(8));
  curve.line = e.line;
  drawing_.curves.push_back(std::move(curve));
}

void DxfReader::polyline(const std::vector<Vertex>& v, bool closed, const Entity& e) {
  const size_t n = v.size();
  for (size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const Point from = v[i].at, to = v[(i + 1) % n].at;
    if (sketch::length(to - from) == 0) continue; // a closed one may repeat its first corner
    add(with_bulge(from, to, v[i].bulge), e, true);
  }
}

void DxfReader::light_polyline(const Entity& e) {
  std::vector<Vertex> vertices;
  for (const Group* g = e.first; g != e.last; ++g) {
    if (g->code == 10) vertices.push_back({{real(g->value, g->line, "x of a corner"), NAN}, 0});
    if ((g->code == 20 || g->code == 42) && vertices.empty()) throw Fault{g->line, "LWPOLYLINE: expected x of a corner first"};
    if (g->code == 20) vertices.back().at.y = real(g->value, g->line, "y of a corner");
    if (g->code == 42) vertices.back().bulge = real(g->value, g->line, "a bulge");
  }
  for (const Vertex& v : vertices)
    if (std::isnan(v.at.y)) throw Fault{e.line, "LWPOLYLINE: a corner has no y"};
  if (const int64_t n = e.flags(90); e.has(90) && n != static_cast<int64_t>(vertices.size()))
    throw Fault{e.line, "LWPOLYLINE: " + std::to_string(vertices.size()) + " corners, expected " + std::to_string(n)};
  polyline(vertices, (e.flags(70) & 1) != 0, e);
}

// POLYLINE with its VERTEX entities; returns where SEQEND is.
size_t DxfReader::old_polyline(const std::vector<Entity>& all, size_t at) {
  const Entity& e = all[at];
  std::vector<Vertex> vertices;
  size_t i = at + 1;
  for (; i < all.size() && all[i].type == "VERTEX"; ++i) {
    constexpr int64_t kFrame = 16; // a control point of a spline that the other corners follow
    if ((all[i].flags(70) & kFrame) == 0) vertices.push_back({all[i].point(10, "a corner"), all[i].number(42, 0, "a bulge")});
  }
  if (i == all.size() || all[i].type != "SEQEND") throw Fault{e.line, "POLYLINE without SEQEND behind its corners"};
  constexpr int64_t kMesh = 16 | 64;
  if ((e.flags(70) & kMesh) != 0 || plane_of(e) == Plane::kOther)
    ++passed_over_["POLYLINE that is not flat"];
  else
    polyline(vertices, (e.flags(70) & 1) != 0, e);
  return i;
}

void DxfReader::ellipse(const Entity& e) {
  const Point centre = e.point(10, "the centre"), axis = e.point(11, "the end of the major axis");
  const double ratio = e.number(40, "the ratio of the axes"), a = sketch::length(axis);
  if (!(ratio > 0)) throw Fault{e.line, "ELLIPSE: ratio of the axes " + told(ratio) + ", expected one above 0"};
  const double from = e.number(41, 0, "the first parameter");
  double sweep = e.number(42, 2 * kHalfTurn, "the last parameter") - from;
  sweep = std::fmod(sweep, 2 * kHalfTurn);
  if (sweep <= 1e-9) sweep += 2 * kHalfTurn;
  if (a == 0) throw Fault{e.line, "ELLIPSE: the major axis has no length"};
  const double side = plane_of(e) == Plane::kBack ? -1 : 1; // the minor axis lies on the other side
  const double tilt = degrees(std::atan2(axis.y, axis.x));
  if (std::fabs(ratio - 1) < 1e-12)
    return add(circular(centre, a, tilt + side * degrees(from), side * degrees(sweep)), e, false);
  add(elliptic(centre, a, a * ratio, tilt, side * degrees(from), side * degrees(sweep)), e, false);
}

void DxfReader::spline(const Entity& e) {
  Nurbs n;
  n.degree = static_cast<int>(std::clamp<int64_t>(e.flags(71), 0, 99));
  n.knots = e.numbers(40, "a knot");
  n.points = e.points(10, "a control point");
  n.weights = e.numbers(41, "a weight");
  n.closed = (e.flags(70) & 1) != 0;
  if (n.points.empty()) { // known by the points it goes through alone
    std::vector<Point> through = e.points(11, "a fit point");
    if (through.size() < 2) throw Fault{e.line, "SPLINE with neither control points nor two fit points"};
    for (size_t i = 1; i < through.size(); ++i)
      if (sketch::length(through[i] - through[i - 1]) == 0) through.erase(through.begin() + static_cast<ptrdiff_t>(i--));
    const bool again = through.size() > 3 && sketch::length(through.back() - through.front()) == 0;
    if (n.closed && again) through.pop_back();
    const bool whole = n.closed && through.size() >= 3;
    return add(through.size() > 2 ? smooth(through, whole) : straight(through.front(), through.back()), e, false);
  }
  if (const std::string fault = n.fault(); !fault.empty()) throw Fault{e.line, "SPLINE with " + fault};
  const double size = size_of({smooth(n.points, false)});
  if (!(size > 0)) return add(straight(n.points.front(), n.points.back()), e, false);
  for (Curve& curve : curves_of(n, 1e-7 * size)) add(std::move(curve), e, false);
}

bool DxfReader::take(const Entity& e) {
  const bool flat = plane_of(e) != Plane::kOther;
  if (e.type == "LINE") {
    const Point first = e.point(10, "the first end"), last = e.point(11, "the last end");
    add(straight(first, last), e, false);
  } else if (e.type == "ARC" && flat) {
    const double from = e.number(50, "the first angle");
    double sweep = std::fmod(e.number(51, "the last angle") - from, 360);
    if (sweep <= 1e-9) sweep += 360;
    const double r = e.number(40, "the radius");
    if (!(r > 0)) throw Fault{e.line, "ARC: radius " + told(r) + ", expected one above 0"};
    add(circular(e.point(10, "the centre"), r, from, sweep), e, true);
  } else if (e.type == "CIRCLE" && flat) {
    const double r = e.number(40, "the radius");
    if (!(r > 0)) throw Fault{e.line, "CIRCLE: radius " + told(r) + ", expected one above 0"};
    add(circular(e.point(10, "the centre"), r, -90, 360), e, true);
  } else if (e.type == "LWPOLYLINE" && flat) {
    light_polyline(e);
  } else if (e.type == "ELLIPSE" && flat) {
    ellipse(e);
  } else if (e.type == "SPLINE") {
    spline(e);
  } else {
    return false;
  }
  return true;
}

std::vector<Entity> DxfReader::entities(size_t first, size_t last) const {
  std::vector<Entity> all;
  for (size_t i = first; i < last; ++i) {
    if (groups_[i].code != 0) continue;
    Entity e;
    e.type = groups_[i].value;
    e.line = groups_[i].line;
    size_t end = i + 1;
    while (end < last && groups_[end].code != 0) ++end;
    e.first = groups_.data() + i + 1, e.last = groups_.data() + end;
    all.push_back(e);
  }
  return all;
}

// BLOCK, its entities and ENDBLK, one block behind the other.
void DxfReader::blocks(size_t first, size_t last) {
  Block* open = nullptr;
  for (const Entity& e : entities(first, last)) {
    if (e.type == "BLOCK") {
      open = &blocks_[std::string(e.text(2))];
      open->base = {e.number(10, 0, "the base of a block"), e.number(20, 0, "the base of a block")};
    } else if (e.type == "ENDBLK") {
      open = nullptr;
    } else if (open != nullptr) {
      open->entities.push_back(e);
    }
  }
}

void DxfReader::draw(const std::vector<Entity>& all, int depth) {
  for (size_t i = 0; i < all.size(); ++i) {
    if (all[i].type == "VERTEX" || all[i].type == "SEQEND" || all[i].type == "ATTRIB") continue; // of what was passed over
    if (all[i].flags(67) == 1)
      ++passed_over_[std::string(all[i].type) + " on paper"];
    else if (all[i].type == "POLYLINE")
      i = old_polyline(all, i);
    else if (all[i].type == "INSERT" ? !insert(all[i], depth) : !take(all[i]))
      ++passed_over_[std::string(all[i].type.substr(0, 40))];
  }
}

// A block, perhaps several times in rows and columns. One that is stretched in one direction is passed over.
bool DxfReader::insert(const Entity& e, int depth) {
  constexpr int kDeepest = 16;
  constexpr int64_t kMostCopies = 10000;
  constexpr int kMostInserts = 1000000;
  const double x = e.number(41, 1, "a scale"), y = e.number(42, 1, "a scale");
  if (x == 0 || std::fabs(std::fabs(x) - std::fabs(y)) > 1e-9 * std::fabs(x) || plane_of(e) == Plane::kOther) return false;
  const auto block = blocks_.find(std::string(e.text(2)));
  if (block == blocks_.end()) throw Fault{e.line, "INSERT of block " + shown(e.text(2)) + ", which is not there"};
  if (depth >= kDeepest) throw Fault{e.line, "INSERT of block " + shown(e.text(2)) + " within itself, or 16 deep"};
  const Point at = e.point(10, "the place of a block");
  const int64_t columns = e.has(70) ? e.flags(70) : 1, rows = e.has(71) ? e.flags(71) : 1;
  if (columns < 0 || rows < 0 || columns > kMostCopies || rows > kMostCopies || columns * rows > kMostCopies)
    throw Fault{e.line, "INSERT: more than 10000 copies of a block"};
  const Placing turn{{}, {}, 1, e.number(50, 0, "an angle"), false};
  for (int64_t i = 0; i < std::max<int64_t>(columns, 1) * std::max<int64_t>(rows, 1); ++i) {
    const int64_t column = i % std::max<int64_t>(columns, 1), row = i / std::max<int64_t>(columns, 1);
    const Point off = {static_cast<double>(column) * e.number(44, 0, "a distance of columns"),
                       static_cast<double>(row) * e.number(45, 0, "a distance of rows")};
    const Placing placing{block->second.base, at + turn(off), std::fabs(x), turn.angle + (x < 0 ? 180 : 0), x * y < 0};
    const size_t first = drawing_.curves.size();
    if (++inserts_ > kMostInserts) throw Fault{e.line, "INSERT: more than 1000000 copies of blocks in all"};
    draw(block->second.entities, depth + 1);
    for (size_t c = first; c < drawing_.curves.size(); ++c) {
      Curve& curve = drawing_.curves[c];
      curve = placed(std::move(curve), placing);
      if (plane_of(e) == Plane::kBack) curve = mirrored(curve);
      if (curve.name.empty() && e.text(8) != "0") curve.name = e.text(8); // layer 0 is that of the block
    }
  }
  return true;
}

void DxfReader::header(size_t first, size_t last) {
  for (size_t i = first; i + 1 < last; ++i)
    if (groups_[i].code == 9 && groups_[i].value == "$INSUNITS" && groups_[i + 1].code == 70)
      drawing_.unit = unit_of(whole_number(groups_[i + 1].value, groups_[i + 1].line, "$INSUNITS"));
}

Drawing DxfReader::read() {
  drawing_.kind = "DXF";
  bool found = false;
  for (size_t i = 0; i + 1 < groups_.size(); ++i) {
    if (groups_[i].code != 0 || groups_[i].value != "SECTION") continue;
    if (groups_[i + 1].code != 2) throw Fault{groups_[i + 1].line, "expected the name of a section, group 2"};
    const std::string_view name = groups_[i + 1].value;
    size_t end = i + 2;
    while (end < groups_.size() && !(groups_[end].code == 0 && groups_[end].value == "ENDSEC")) ++end;
    if (end == groups_.size()) throw Fault{groups_[i].line, "section " + shown(name) + " without ENDSEC: the file is cut off"};
    if (name == "HEADER") header(i + 2, end);
    if (name == "BLOCKS") blocks(i + 2, end);
    if (name == "ENTITIES") draw(entities(i + 2, end), 0), found = true;
    i = end;
  }
  if (!found) throw Fault{0, "no section ENTITIES"};
  for (const auto& [type, count] : passed_over_)
    drawing_.notes.push_back(std::to_string(count) + " " + shown(type) + (count == 1 ? " was" : " were") + " passed over");
  if (slanting_ > 0)
    drawing_.notes.push_back(std::to_string(slanting_) + (slanting_ == 1 ? " line has" : " lines have") +
                             " ends of different z: seen along z");
  return std::move(drawing_);
}

} // namespace

bool is_dxf(std::string_view text) {
  Lines lines(text);
  std::string_view code, value;
  while (lines.next(code) && lines.next(value)) // comments may stand first
    if (trimmed(code) != "999") return trimmed(code) == "0" && trimmed(value) == "SECTION";
  return false;
}

Drawing read_dxf(std::string_view text) { return DxfReader(text).read(); }

} // namespace drawing
