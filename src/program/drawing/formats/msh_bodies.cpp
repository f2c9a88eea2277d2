// What the elements of a mesh bound.
#include "program/drawing/chain.hpp"
#include "program/drawing/formats/msh.hpp"
#include "program/drawing/loops.hpp"
#include "program/sketch/shapes/outline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace drawing {
namespace {

using Key = std::pair<int64_t, int64_t>; // of a side: its end nodes, the smaller first

Key key_of(int64_t a, int64_t b) { return {std::min(a, b), std::max(a, b)}; }

// A side of a face, or a line element: its nodes one after the other.
struct Side {
  std::vector<int64_t> nodes;
  std::string name;
  int64_t entity = 0;
  int line = 0; // of the file; 0: no line element is there
  Key key() const { return key_of(nodes.front(), nodes.back()); }
};

bool is_alike(const Side& a, const Side& b) { return a.name == b.name && a.entity == b.entity; }

Side side_of(const Mesh& mesh, const Element& line) {
  Side side{{line.nodes[0]}, mesh.name(1, line.group), line.entity, line.line};
  side.nodes.insert(side.nodes.end(), line.nodes.begin() + 2, line.nodes.end());
  side.nodes.push_back(line.nodes[1]);
  if (side.name.empty() && line.group != 0) side.name = "group" + std::to_string(line.group);
  if (side.name.empty() && line.entity != 0) side.name = "curve" + std::to_string(line.entity);
  return side;
}

// The sides of a face, counter-clockwise.
std::vector<Side> sides_of(const Mesh& mesh, const Element& face) {
  const size_t corners = static_cast<size_t>(corners_of(face.type)), between = static_cast<size_t>(order_of(face.type)) - 1;
  std::vector<Side> out(corners);
  std::vector<Point> polygon;
  for (size_t i = 0; i < corners; ++i) {
    polygon.push_back(mesh.at(face.nodes[i]));
    out[i].nodes.push_back(face.nodes[i]);
    for (size_t k = 0; k < between; ++k) out[i].nodes.push_back(face.nodes[corners + i * between + k]);
    out[i].nodes.push_back(face.nodes[(i + 1) % corners]);
  }
  if (sketch::area_of(polygon) < 0)
    for (Side& side : out) std::reverse(side.nodes.begin(), side.nodes.end());
  return out;
}

class Builder {
public:
  explicit Builder(const Mesh& mesh) : mesh_(mesh) {}
  Drawing build();

private:
  void take_lines();
  void join_faces();
  size_t root(size_t face);
  void body_of(const std::vector<size_t>& faces, const std::string& name);
  std::vector<std::vector<Side>> loops_of(const std::vector<Side>& sides) const;
  Loop loop_of(std::vector<Side> sides);
  void add_loose();
  std::vector<Side> walk(size_t first, const std::vector<Side>& loose, std::vector<bool>& used, bool& closed) const;
  void add_curves(std::vector<Curve>& out, const std::vector<Side>& run, bool closed) const;

  const Mesh& mesh_;
  Drawing out_;
  double size_ = 0;
  size_t tidied_ = 0;                               // curves that became part of the one before
  std::vector<Side> lines_;                         // every one once
  std::map<Key, size_t> line_at_;                   // of lines_
  std::map<Key, std::vector<size_t>> faces_at_;     // of every side of a face
  std::map<int64_t, std::vector<size_t>> loose_at_; // lines that bound no face, by node
  std::vector<size_t> parent_;                      // of faces that hang together
};

void Builder::take_lines() {
  int twice = 0;
  for (const Element& element : mesh_.lines) {
    Side side = side_of(mesh_, element);
    if (line_at_.emplace(side.key(), lines_.size()).second)
      lines_.push_back(std::move(side));
    else
      ++twice;
  }
  if (twice > 0) out_.notes.push_back(std::to_string(twice) + " line elements are repeated: the name of the first one is used");
}

size_t Builder::root(size_t face) {
  while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
  return face;
}

// Faces of one group with a side in common hang together.
void Builder::join_faces() {
  for (size_t f = 0; f < mesh_.faces.size(); ++f) {
    parent_.push_back(f);
    const Element& face = mesh_.faces[f];
    if (std::set<int64_t>(face.nodes.begin(), face.nodes.end()).size() != face.nodes.size())
      throw Fault{face.line, "an element of a surface has a node twice"};
    for (const Side& side : sides_of(mesh_, face)) {
      std::vector<size_t>& list = faces_at_[side.key()];
      for (const size_t other : list)
        if (mesh_.faces[other].group == face.group) parent_[root(f)] = root(other);
      list.push_back(f);
    }
  }
}

std::vector<std::vector<Side>> Builder::loops_of(const std::vector<Side>& sides) const {
  std::map<int64_t, std::vector<size_t>> leaving;
  for (size_t i = 0; i < sides.size(); ++i) leaving[sides[i].nodes.front()].push_back(i);
  std::vector<bool> used(sides.size(), false);
  std::vector<std::vector<Side>> loops;
  for (size_t first = 0; first < sides.size(); ++first) {
    if (used[first]) continue;
    loops.emplace_back();
    for (size_t i = first; i < sides.size();) {
      used[i] = true;
      loops.back().push_back(sides[i]);
      const int64_t end = sides[i].nodes.back();
      if (end == sides[first].nodes.front()) break;
      const Point way = mesh_.at(end) - mesh_.at(sides[i].nodes.front());
      size_t next = sides.size();
      double most = -HUGE_VAL; // where loops touch, the one that turns left most bounds the same material
      for (const size_t j : leaving[end]) {
        const Point on = mesh_.at(sides[j].nodes.back()) - mesh_.at(end);
        const double turn = std::atan2(sketch::cross(way, on), sketch::dot(way, on));
        if (!used[j] && turn > most) most = turn, next = j;
      }
      if (next == sides.size()) throw Fault{0, "the boundary of a surface is not closed at " + text_of(mesh_.at(end))};
      i = next;
    }
  }
  return loops;
}

void Builder::add_curves(std::vector<Curve>& out, const std::vector<Side>& run, bool closed) const {
  std::vector<Point> points;
  for (const Side& side : run)
    for (size_t i = 0; i + 1 < side.nodes.size(); ++i) points.push_back(mesh_.at(side.nodes[i]));
  if (!closed) points.push_back(mesh_.at(run.back().nodes.back()));
  for (Curve& curve : curves_of(points, closed, size_)) {
    curve.name = run.front().name;
    curve.line = run.front().line;
    out.push_back(std::move(curve));
  }
}

Loop Builder::loop_of(std::vector<Side> sides) {
  Loop loop;
  const size_t n = sides.size();
  size_t change = 0;
  while (change < n && is_alike(sides[change], sides[(change + n - 1) % n])) ++change;
  if (change == n) {
    add_curves(loop.curves, sides, true);
  } else {
    std::rotate(sides.begin(), sides.begin() + static_cast<ptrdiff_t>(change), sides.end());
    for (size_t first = 0; first < n;) {
      size_t last = first + 1;
      while (last < n && is_alike(sides[first], sides[last])) ++last;
      add_curves(loop.curves, {sides.begin() + static_cast<ptrdiff_t>(first), sides.begin() + static_cast<ptrdiff_t>(last)},
                 false);
      first = last;
    }
  }
  if (loop.curves.empty()) throw Fault{0, "a surface has zero size at " + text_of(mesh_.at(sides.front().nodes.front()))};
  std::vector<Point> polygon;
  for (const Side& side : sides)
    for (size_t i = 0; i + 1 < side.nodes.size(); ++i) polygon.push_back(mesh_.at(side.nodes[i]));
  loop.hole = sketch::area_of(polygon) < 0;
  if (Curve& only = loop.curves.front(); only.whole && only.kind == Curve::kSpline && loop.hole) only = reversed(only);
  tidied_ += tidy(loop);
  return loop;
}

void Builder::body_of(const std::vector<size_t>& faces, const std::string& name) {
  const size_t part = root(faces.front());
  std::vector<Side> boundary;
  for (const size_t f : faces)
    for (Side& side : sides_of(mesh_, mesh_.faces[f])) {
      const std::vector<size_t>& both = faces_at_[side.key()];
      if (std::count_if(both.begin(), both.end(), [&](size_t other) { return root(other) == part; }) != 1) continue;
      const auto line = line_at_.find(side.key());
      if (line != line_at_.end())
        side.name = lines_[line->second].name, side.entity = lines_[line->second].entity, side.line = lines_[line->second].line;
      boundary.push_back(std::move(side));
    }
  Body body;
  body.name = name;
  for (std::vector<Side>& sides : loops_of(boundary)) body.loops.push_back(loop_of(std::move(sides)));
  std::stable_sort(body.loops.begin(), body.loops.end(), [](const Loop& a, const Loop& b) { return !a.hole && b.hole; });
  if (!body.loops.empty() && !body.loops.front().hole) return out_.bodies.push_back(std::move(body));
  out_.notes.push_back("left out: a surface of zero area at " + text_of(mesh_.at(mesh_.faces[faces.front()].nodes.front())));
}

// From one line element as far as lines of its name go on, both ways.
std::vector<Side> Builder::walk(size_t first, const std::vector<Side>& loose, std::vector<bool>& used, bool& closed) const {
  std::vector<Side> run{loose[first]};
  used[first] = true;
  closed = false;
  for (int way = 0; way < 2; ++way) {
    while (true) {
      const int64_t end = run.back().nodes.back();
      closed = run.size() > 1 && end == run.front().nodes.front();
      const std::vector<size_t>& at = loose_at_.at(end);
      if (closed || at.size() != 2) break;
      const size_t next = used[at[0]] ? at[1] : at[0];
      if (used[next] || !is_alike(loose[next], run.front())) break;
      used[next] = true;
      Side side = loose[next];
      if (side.nodes.front() != end) std::reverse(side.nodes.begin(), side.nodes.end());
      run.push_back(std::move(side));
    }
    if (closed || way == 1) break;
    std::reverse(run.begin(), run.end());
    for (Side& side : run) std::reverse(side.nodes.begin(), side.nodes.end());
  }
  return run;
}

void Builder::add_loose() {
  std::vector<Side> loose;
  int inside = 0;
  for (const Side& side : lines_) {
    const auto at = faces_at_.find(side.key());
    if (at == faces_at_.end())
      loose.push_back(side);
    else if (at->second.size() > 1 && mesh_.faces[at->second[0]].group == mesh_.faces[at->second[1]].group)
      ++inside;
  }
  if (inside > 0) out_.notes.push_back(std::to_string(inside) + " line elements inside bodies were left out");
  for (size_t i = 0; i < loose.size(); ++i)
    for (const int64_t node : {loose[i].nodes.front(), loose[i].nodes.back()}) loose_at_[node].push_back(i);
  std::vector<bool> used(loose.size(), false);
  for (size_t i = 0; i < loose.size(); ++i) {
    if (used[i]) continue;
    bool closed = false;
    const std::vector<Side> run = walk(i, loose, used, closed);
    add_curves(out_.curves, run, closed);
  }
}

Drawing Builder::build() {
  out_.kind = "MSH " + mesh_.format;
  out_.notes = mesh_.notes;
  std::vector<Curve> box;
  for (const Point& p : mesh_.nodes) box.push_back(straight(p, p));
  size_ = size_of(box);
  take_lines();
  join_faces();
  std::map<size_t, std::vector<size_t>> parts;
  std::map<int64_t, int> parts_of_group, part_numbers;
  for (size_t f = 0; f < parent_.size(); ++f) parts[root(f)].push_back(f);
  for (const auto& part : parts) ++parts_of_group[mesh_.faces[part.first].group];
  for (const auto& part : parts) {
    const int64_t group = mesh_.faces[part.first].group;
    std::string name = mesh_.name(2, group);
    if (!name.empty() && parts_of_group[group] > 1) name += std::to_string(++part_numbers[group]);
    body_of(part.second, name);
  }
  add_loose();
  note_tidied(tidied_, out_.notes);
  return std::move(out_);
}

} // namespace

Drawing drawing_of(const Mesh& mesh) { return Builder(mesh).build(); }

} // namespace drawing
