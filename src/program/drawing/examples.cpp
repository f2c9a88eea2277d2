#include "program/drawing/examples.hpp"

#include "program/drawing/course.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace drawing {
namespace {

constexpr double kMayTouch = 0.05; // of the smaller body: largest distance of sides that may touch

struct Sampled { // a curve by some of its points
  const Curve* curve;
  double side;                        // -1: the material is on its left; 1: on its right
  std::vector<Point> points, outward; // and the normals there
  Point middle() const { return points[points.size() / 2]; }
};

struct Part { // a body among those that it touches
  const Body* body;
  std::vector<Sampled> curves;
  Point low, high;
  std::set<std::string> in_contact; // names of its curves
  size_t root;                      // the fixed body that supports it, through contacts; its own number: none
  Point press;                      // towards that body, along an axis
  bool carries = false;             // others
  bool is_fixed = false;            // by its own support
  double size() const { return std::max(high.x - low.x, high.y - low.y); }
  std::set<std::string> free_names() const; // names without a contact
  // The free curve farthest in a direction; with `apart`, one that does not adjoin a contact; null: none.
  const Sampled* furthest(Point way, bool apart) const;
  bool ends_at_contact(const std::string& name) const;
};

Part part_of(const Body& body, size_t number) {
  Part part{&body, {}, {HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}, {}, number, {}};
  for (const Loop& loop : body.loops)
    for (const Curve& curve : loop.curves) {
      const sketch::ShapePtr shape = shape_of(curve);
      Sampled s{&curve, loop.hole && curve.whole ? 1.0 : -1.0, {}, {}}; // whole ones turn left
      for (int i = 0; i <= 16; ++i) {
        s.points.push_back(shape->at(i / 16.0));
        s.outward.push_back(s.side * sketch::turned_left(shape->tangent(i / 16.0)));
      }
      for (const Point& p : s.points) {
        part.low = {std::min(part.low.x, p.x), std::min(part.low.y, p.y)};
        part.high = {std::max(part.high.x, p.x), std::max(part.high.y, p.y)};
      }
      part.curves.push_back(std::move(s));
    }
  return part;
}

std::set<std::string> Part::free_names() const {
  std::set<std::string> out;
  for (const Sampled& s : curves)
    if (in_contact.count(s.curve->name) == 0) out.insert(s.curve->name);
  return out;
}

bool Part::ends_at_contact(const std::string& name) const {
  for (const Sampled& s : curves)
    for (const Sampled& t : curves) {
      if (s.curve->name != name || in_contact.count(t.curve->name) == 0) continue;
      for (const Point p : {s.curve->begin, s.curve->end})
        for (const Point q : {t.curve->begin, t.curve->end})
          if (sketch::length(p - q) <= kJoin * size()) return true;
    }
  return false;
}

const Sampled* Part::furthest(Point way, bool apart) const {
  const auto mean = [&](const Sampled& s) {
    double sum = 0;
    for (const Point& p : s.points) sum += sketch::dot(p, way);
    return sum;
  };
  const Sampled* best = nullptr;
  for (const Sampled& s : curves)
    if (in_contact.count(s.curve->name) == 0 && (best == nullptr || mean(s) > mean(*best)) &&
        !(apart && ends_at_contact(s.curve->name)))
      best = &s;
  return best;
}

struct Touch { // where two bodies are nearest to each other
  double gap;
  const Curve *supported, *supporting;
  Point press; // direction in which the supported body presses, along an axis
};

Point along_an_axis(Point way) {
  const bool along_x = std::fabs(way.x) > std::fabs(way.y);
  return {along_x ? std::copysign(1.0, way.x) : 0, along_x ? 0 : std::copysign(1.0, way.y)};
}

// The nearest points of two curves that face each other there.
Touch nearest(const Sampled& supported, const Sampled& supporting, double near) {
  constexpr double kFaces = 0.8; // the cosine of the angle between the normals
  const Course other({*supporting.curve});
  Touch out{HUGE_VAL, supported.curve, supporting.curve, {}};
  Point sum{};
  double count = 0;
  for (size_t i = 0; i < supported.points.size(); ++i) {
    const Course::Nearest at = other.nearest(supported.points[i]);
    const bool faces = sketch::dot(supported.outward[i], supporting.side * sketch::turned_left(at.along)) < -kFaces;
    if (!faces || at.distance > near) continue;
    if (at.distance < out.gap) out.gap = at.distance, out.press = supported.outward[i];
    sum = sum + supported.outward[i], ++count;
  }
  if (count > 2) out.press = sketch::length(sum) > 0.3 * count ? sum : Point{0, -1}; // a pin in a hole presses down
  return out;
}

Touch touch_of(const Part& a, const Part& b) {
  Touch best{HUGE_VAL, nullptr, nullptr, {}};
  const double near = kMayTouch * std::min(a.size(), b.size());
  if (a.low.x > b.high.x + near || b.low.x > a.high.x + near || a.low.y > b.high.y + near || b.low.y > a.high.y + near)
    return best;
  for (const Sampled& p : a.curves)
    for (const Sampled& q : b.curves) {
      const Touch touch = nearest(p, q, near), turned = nearest(q, p, near);
      if (touch.gap < best.gap) best = touch;
      if (turned.gap < best.gap) best = {turned.gap, p.curve, q.curve, -1.0 * turned.press};
    }
  return best;
}

// Adds contacts from supported bodies to bodies near them, the nearest first. Every body gets a contact with a supported one,
// if one is near and the fixed body keeps a free curve for its own support.
std::vector<std::string> connect(std::vector<Part>& parts, size_t root) {
  std::vector<std::string> out;
  std::vector<size_t> supported{root};
  std::map<std::pair<size_t, size_t>, Touch> touches;
  while (true) {
    Touch best{HUGE_VAL, nullptr, nullptr, {}};
    size_t next = 0, by = 0;
    for (const size_t i : supported)
      for (size_t j = 0; j < parts.size(); ++j) {
        if (parts[j].root != j || parts[j].is_fixed) continue;
        if (touches.count({j, i}) == 0) touches[{j, i}] = touch_of(parts[j], parts[i]);
        const Touch& touch = touches[{j, i}];
        if (!(touch.gap < best.gap)) continue;
        std::set<std::string> free = parts[root].free_names();
        if (i == root) free.erase(touch.supporting->name);
        if (!free.empty()) best = touch, next = j, by = i;
      }
    if (best.supported == nullptr) return out;
    Part &a = parts[next], &b = parts[by];
    a.root = root;
    b.carries = true;
    a.in_contact.insert(best.supported->name), b.in_contact.insert(best.supporting->name);
    a.press = along_an_axis(best.press);
    out.push_back("contact " + b.body->name + "." + best.supporting->name + " " + a.body->name + "." + best.supported->name +
                  "  mu 0.3");
    supported.push_back(next);
  }
}

// A total force of 1, as the weight of the body.
std::string weight_of(const Body& body, Point way) {
  double area = 0;
  for (const Loop& loop : body.loops) area += (loop.hole ? -1 : 1) * std::fabs(Course(loop.curves).area());
  return "weight " + body.name + "  x " + text_of(way.x / area) + " y " + text_of(way.y / area);
}

// A load on a body supported by a contact, towards the contact.
std::string load_on(const Part& part) {
  const Sampled* const pressed = part.furthest(-1.0 * part.press, true);
  if (pressed == nullptr) return weight_of(*part.body, part.press);
  const Point about = pressed->middle();
  const bool along_x = part.press.x != 0;
  return "platen " + part.body->name + "." + pressed->curve->name + "  about " + text_of(about.x) + " " + text_of(about.y) +
         (along_x ? "  y 0 fx " + text_of(part.press.x) : "  x 0 fy " + text_of(part.press.y)) + "  turn 0";
}

// A load on a body with its own support.
std::string traction_on(Part part, const std::string& support) {
  part.in_contact.insert(support);
  const Sampled* const pulled = part.furthest({0, 1}, false);
  return pulled == nullptr ? weight_of(*part.body, {0, -1})
                           : "traction " + part.body->name + "." + pulled->curve->name + "  x 0 y -1";
}

} // namespace

std::vector<std::string> examples_for(const std::vector<Body>& bodies) {
  std::vector<Part> parts;
  for (const Body& body : bodies) parts.push_back(part_of(body, parts.size()));
  std::vector<size_t> upwards(parts.size()); // by the lowest point
  for (size_t i = 0; i < upwards.size(); ++i) upwards[i] = i;
  std::stable_sort(upwards.begin(), upwards.end(), [&](size_t i, size_t j) { return parts[i].low.y < parts[j].low.y; });
  std::vector<std::string> out, supports, loads;
  for (const size_t i : upwards) {
    if (parts[i].root != i) continue;
    parts[i].is_fixed = true;
    const std::vector<std::string> contacts = connect(parts, i);
    out.insert(out.end(), contacts.begin(), contacts.end());
    const Sampled* const apart = parts[i].furthest({0, -1}, true);
    const std::string support = (apart != nullptr ? apart : parts[i].furthest({0, -1}, false))->curve->name;
    supports.push_back("fix " + parts[i].body->name + "." + support);
    if (i == upwards.front() && contacts.empty()) loads.push_back(traction_on(parts[i], support));
  }
  for (size_t i = 0; i < parts.size(); ++i)
    if (parts[i].root != i && !parts[i].carries) loads.push_back(load_on(parts[i]));
  out.push_back("case load");
  out.insert(out.end(), supports.begin(), supports.end());
  out.insert(out.end(), loads.begin(), loads.end());
  out.push_back("history load 1");
  return out;
}

} // namespace drawing
