#include "report/pictures/model_symbols.hpp"

#include "report/pictures/contour.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// Symbols closer than this to one of their kind are omitted.
constexpr double kSpacing = 11.0;
// Strokes of load cases. With more cases than kMostListed the legend has a line for each stroke.
constexpr size_t kLoadStyles = 4, kMostListed = 8;
constexpr int kMostNamed = 3; // on such a line
// Symbols inside a body: length of an arrow from its middle, radius of a rotation.
constexpr double kInnerArrow = 44.0, kTurnRadius = 20.0;

// A load case has a colour and a dash of its own.
Stroke stroke_of(Symbol symbol, size_t load_case) {
  static const Stroke kCases[] = {
      {colour::kOrange, 0.0, ""}, {colour::kPurple, 0.0, "6 2"}, {colour::kBlue, 0.0, "2 2"}, {colour::kInk, 0.0, "8 2 2 2"}};
  static const double kWidths[] = {1.4, 2.4, 1.4, 4.0, 2.4, 2.4, 2.8, 2.0};
  Stroke out = kCases[load_case % kLoadStyles];
  out.width = kWidths[static_cast<size_t>(symbol)];
  return out;
}

Head head_of(Symbol symbol) {
  return symbol == Symbol::kDisplacement || symbol == Symbol::kRigidMotion ? Head::kOpen : Head::kFilled;
}

// Is there room around a place of the model and its images? Then it is taken. Only the model counts, so that all images
// have the same symbols.
bool take_place(std::vector<Point>& placed, const Scene& scene, const Chart& view, Point at, double spacing) {
  const Point p = view.at(at);
  const auto near = [&](Point other) { return std::hypot(p.x - other.x, p.y - other.y) < spacing; };
  for (const Image& image : scene.images) {
    const Point there = image.place(at), q = view.at(there);
    if (near(q) && std::hypot(p.x - q.x, p.y - q.y) > 1.0) return false;
  }
  if (std::any_of(placed.begin(), placed.end(), near)) return false;
  placed.push_back(p);
  return true;
}

// A triangle with its tip at `p`, its base away along (dx, dy); with a line behind it where the body may
// slide.
void draw_support(Svg& svg, Point p, double dx, double dy, bool both) {
  const double h = 8.0, w = 4.5;
  const Point base{p.x + h * dx, p.y + h * dy};
  svg.area({{p, {base.x - w * dy, base.y + w * dx}, {base.x + w * dy, base.y - w * dx}}}, both ? colour::kInk : "white",
           Stroke{colour::kInk, 1.0, ""});
  if (both) return;
  const Point rail{p.x + (h + 2.5) * dx, p.y + (h + 2.5) * dy};
  svg.line({rail.x - w * dy, rail.y + w * dx}, {rail.x + w * dy, rail.y - w * dx}, Stroke{colour::kInk, 1.0, ""});
}

// Outward direction along x or y at a node: the symbol of a corner belongs to the supported side.
std::vector<Point> outward(const BodyScene& body) {
  std::vector<Point> out;
  for (size_t i = 0; i < body.nodes.size(); ++i) {
    const size_t node = static_cast<size_t>(body.nodes[i]);
    if (out.size() <= node) out.resize(node + 1);
    const Point n = body.normals[i];
    if (std::fabs(n.x) > std::fabs(out[node].x)) out[node].x = n.x;
    if (std::fabs(n.y) > std::fabs(out[node].y)) out[node].y = n.y;
  }
  return out;
}

// Known and zero in every load case.
bool is_held(const EndCondition& c, int quantity) {
  if (!c.known(quantity)) return false;
  for (const double value : c.values[quantity])
    if (value != 0.0) return false;
  return true;
}

// A shaft whose head stands at a point of the boundary, or whose tail does if it pulls outwards.
struct Arrow {
  Point direction, normal; // of the picture: y downwards
  double length, head;
};
bool outwards(const Arrow& a) { return a.direction.x * a.normal.x + a.direction.y * a.normal.y > 0.0; }
void draw_arrow(Svg& svg, Point p, const Arrow& a, const Stroke& stroke, Head head) {
  const double size = std::hypot(a.direction.x, a.direction.y);
  const Point way{a.length * a.direction.x / size, a.length * a.direction.y / size};
  if (outwards(a))
    svg.arrow(p, {p.x + way.x, p.y + way.y}, stroke, a.head, head);
  else
    svg.arrow({p.x - way.x, p.y - way.y}, p, stroke, a.head, head);
}

// Three quarters of a circle round a cross, the way of a positive or negative rotation.
void draw_turn(Svg& svg, Point centre, bool positive, const Stroke& stroke, Head head) {
  const double radius = kTurnRadius, pi = 3.14159265358979323846;
  std::vector<Point> arc;
  for (int i = 0; i <= 24; ++i) {
    const double angle = (positive ? -1.0 : 1.0) * 1.5 * pi * i / 24.0;
    arc.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  svg.polyline(arc, stroke);
  const Point end = arc.back(), way{end.x - arc[23].x, end.y - arc[23].y};
  const double size = std::hypot(way.x, way.y);
  svg.arrow(end, {end.x + 9.0 * way.x / size, end.y + 9.0 * way.y / size}, Stroke{stroke.colour, stroke.width, ""}, 9.0, head);
  svg.mark(Mark::kCross, centre, 7.0, stroke.colour);
}

// Centre of the area within closed curves.
Point centroid(const Outlines& curves) {
  double area = 0.0;
  Point moment;
  for (const std::vector<Point>& curve : curves)
    for (size_t i = 0; i < curve.size(); ++i) {
      const Point a = curve[i], b = curve[(i + 1) % curve.size()];
      const double part = a.x * b.y - b.x * a.y;
      area += part;
      moment.x += part * (a.x + b.x) / 3.0;
      moment.y += part * (a.y + b.y) / 3.0;
    }
  return area != 0.0 ? Point{moment.x / area, moment.y / area} : Point{};
}

// Where symbols of a whole body stand: its centre, images included; of a body beside its image, that of its first curve; of a
// platen, the middle of the ends that it moves.
Point centre_of(const Scene& scene, int32_t number) {
  const BodyScene& body = scene.bodies[static_cast<size_t>(number) - 1];
  const Outlines curves = outline_of(body, 0.0);
  for (const ZoneScene& zone : scene.zones)
    if (body.platen && zone.body[0] == number && zone.pairs > 0) return scene.pairs[zone.first + zone.pairs / 2].on[0];
  const Point all = centroid(curves);
  return curves.size() < 2 || is_inside(curves, all) ? all : centroid({curves[0]});
}

// Where the force on a rigid body is drawn: at its point or, where that lies beside the body, at the place of its line of
// action that is nearest to the middle of the body.
Point place_of(const Scene& scene, const RigidLoad& load) {
  const double size = std::hypot(load.force.x, load.force.y);
  const Outlines curves = outline_of(scene.bodies[static_cast<size_t>(load.body) - 1], 0.0);
  if (size == 0.0 || load.moment != 0.0 || is_inside(curves, load.at)) return load.at;
  const Point middle = centre_of(scene, load.body), along{load.force.x / size, load.force.y / size};
  const double by = (middle.x - load.at.x) * along.x + (middle.y - load.at.y) * along.y;
  return {load.at.x + by * along.x, load.at.y + by * along.y};
}

// The loads of one case on one body and its images.
class Loads {
public:
  Loads(Svg& svg, const Scene& scene, const Chart& view, size_t load_case, Present& present)
      : svg_(svg), scene_(scene), view_(view), case_(load_case), present_(present) {}

  void boundary(const BodyScene& body) {
    double largest = 0.0;
    for (const EndCondition& c : body.conditions) largest = std::max(largest, std::hypot(c.value(0, case_), c.value(1, case_)));
    std::vector<Point> motions, tractions;
    for (size_t i = 0; i < body.conditions.size(); ++i) {
      const EndCondition& c = body.conditions[i];
      const Point u{c.value(2, case_), c.value(3, case_)}, t{c.value(0, case_), c.value(1, case_)};
      const double size = std::hypot(t.x, t.y);
      const bool moves = std::hypot(u.x, u.y) > 0.0 && take_place(motions, scene_, view_, body.ends[i], 1.5 * kSpacing);
      const bool pulls = size > 1e-12 * largest && take_place(tractions, scene_, view_, body.ends[i], 0.8 * kSpacing);
      for (const Image& image : scene_.images) {
        const Point at = image.place(body.ends[i]), p = view_.at(at);
        if (!view_.is_near(p)) continue;
        if (moves) arrow(Symbol::kDisplacement, p, image.direction(u), {0.0, 0.0}, 26.0, 7.0);
        if (pulls)
          arrow(Symbol::kTraction, p, image.direction(t), image.direction(body.normals[i]), 10.0 + 18.0 * size / largest, 6.5);
      }
    }
  }

  void point_load(const PointLoad& load) {
    for (const Image& image : scene_.images) {
      const Point at = image.place(load.at), p = view_.at(at);
      if (!view_.is_near(p) || std::hypot(load.force.x, load.force.y) == 0.0) continue;
      arrow(Symbol::kPointLoad, p, image.direction(load.force), {0.0, 0.0}, 34.0, 9.0);
      svg_.mark(Mark::kCircle, p, 5.0, stroke_of(Symbol::kPointLoad, case_).colour);
    }
  }

  // Starts at the middle of the body.
  void body_force(const BodyForce& force) {
    const Point middle = centre_of(scene_, force.body);
    const Point p = view_.at(middle), axis = view_.at(in_view(force.axis, force.body));
    if ((force.force.x != 0.0 || force.force.y != 0.0) && view_.is_near(p))
      arrow(Symbol::kBodyForce, p, force.force, {force.force.x, force.force.y}, kInnerArrow, 13.0);
    if (force.rho_omega2 != 0.0 && view_.is_near(axis)) turn(Symbol::kRotation, axis, true);
  }

  void rigid_motion(const RigidMotion& motion) {
    const Point middle = centre_of(scene_, motion.body), axis = in_view(motion.axis, motion.body);
    for (const Image& image : images_of_points({middle, axis})) {
      const Point p = view_.at(image.place(middle)), pole = view_.at(image.place(axis)), by = image.direction(motion.by);
      if ((by.x != 0.0 || by.y != 0.0) && view_.is_near(p)) arrow(Symbol::kRigidMotion, p, by, by, kInnerArrow, 12.0);
      if (motion.rotation != 0.0 && view_.is_near(pole))
        turn(Symbol::kRigidMotion, pole, motion.rotation * image.turn.x * image.turn.y > 0.0);
    }
  }

  void rigid_load(const RigidLoad& load) {
    const Point place = in_view(place_of(scene_, load), load.body);
    for (const Image& image : images_of_points({place})) {
      const Point at = image.place(place), p = view_.at(at), force = image.direction(load.force);
      if (!view_.is_near(p)) continue;
      if (force.x != 0.0 || force.y != 0.0) arrow(Symbol::kRigidForce, p, force, {0.0, 0.0}, 36.0, 11.0);
      if (load.moment != 0.0) turn(Symbol::kRigidMoment, p, load.moment * image.turn.x * image.turn.y > 0.0);
      svg_.mark(Mark::kCircle, p, 4.0, stroke_of(Symbol::kRigidForce, case_).colour);
    }
  }

private:
  // The point, or where it lies beyond the picture, the middle of the body.
  Point in_view(Point at, int32_t body) const { return view_.is_near(view_.at(at)) ? at : centre_of(scene_, body); }
  // The model and those images that are elsewhere: a point on a line of symmetry is its own image.
  std::vector<Image> images_of_points(const std::vector<Point>& points) const {
    std::vector<Image> out;
    const double near = 1e-9 * size_of(scene_);
    for (const Image& image : scene_.images) {
      const auto is_new = [&](Point p) {
        return std::none_of(out.begin(), out.end(), [&](const Image& other) {
          return std::hypot(image.place(p).x - other.place(p).x, image.place(p).y - other.place(p).y) <= near;
        });
      };
      if (out.empty() || std::any_of(points.begin(), points.end(), is_new)) out.push_back(image);
    }
    return out;
  }
  // `direction` and `normal` are of the model.
  void arrow(Symbol symbol, Point p, Point direction, Point normal, double length, double head) {
    const Arrow a{{direction.x, -direction.y}, {normal.x, -normal.y}, length, head};
    draw_arrow(svg_, p, a, stroke_of(symbol, case_), head_of(symbol));
    present_.note(symbol, case_);
    const double size = std::hypot(direction.x, direction.y), sign = outwards(a) ? 1.0 : -1.0;
    present_.cover(p, {p.x + sign * length * a.direction.x / size, p.y + sign * length * a.direction.y / size}, 5.0);
  }
  void turn(Symbol symbol, Point p, bool positive) {
    draw_turn(svg_, p, positive, stroke_of(symbol, case_), head_of(symbol));
    present_.note(symbol, case_);
    present_.cover(p, p, kTurnRadius + 5.0);
  }

  Svg& svg_;
  const Scene& scene_;
  const Chart& view_;
  size_t case_;
  Present& present_;
};

} // namespace

void Present::note(Symbol symbol, size_t load_case) {
  std::vector<bool>& cases = load[static_cast<size_t>(symbol)];
  if (cases.size() <= load_case) cases.resize(load_case + 1, false);
  cases[load_case] = true;
}

void Present::cover(Point from, Point to, double half) {
  const int parts = 1 + static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / half);
  for (int i = 0; i <= parts; ++i) {
    const Point p{from.x + (to.x - from.x) * i / parts, from.y + (to.y - from.y) * i / parts};
    taken.push_back({p.x - half, p.y - half, p.x + half, p.y + half});
  }
}

void draw_supports(Svg& svg, const Scene& scene, const Chart& view, Present& present) {
  std::vector<Point> placed[2];
  for (const BodyScene& body : scene.bodies) {
    if (body.rigid) continue;
    const std::vector<Point> out = outward(body);
    const size_t ends = static_cast<size_t>(scene.summary.function_nodes);
    for (size_t i = 0; i < body.conditions.size(); ++i) {
      // On a line of symmetry by images the line itself supports a node across it.
      const int line = image_line_at(scene.summary, body.ends[i]);
      const bool fixed[2] = {line != 1 && is_held(body.conditions[i], 2), line != 2 && is_held(body.conditions[i], 3)};
      const bool both = fixed[0] && fixed[1];
      if ((!fixed[0] && !fixed[1]) || body.on_line[i / ends]) continue;
      if (!take_place(placed[both ? 1 : 0], scene, view, body.ends[i], kSpacing)) continue;
      for (const Image& image : scene.images) {
        const Point at = image.place(body.ends[i]), p = view.at(at);
        if (!view.is_near(p)) continue;
        present.support = true;
        const Point n = image.direction(out[static_cast<size_t>(body.nodes[i])]);
        const bool along_x = both ? std::fabs(n.x) > std::fabs(n.y) + 1e-3 : fixed[0];
        const double dx = n.x < -1e-6 ? -1.0 : 1.0, dy = n.y > 1e-6 ? -1.0 : 1.0; // of the picture
        draw_support(svg, p, along_x ? dx : 0.0, along_x ? 0.0 : dy, both);
        present.cover(p, {p.x + (along_x ? 10.0 * dx : 0.0), p.y + (along_x ? 0.0 : 10.0 * dy)}, 5.0);
      }
    }
  }
}

void draw_loads(Svg& svg, const Scene& scene, const Chart& view, Present& present) {
  for (size_t k = 0; k < scene.cases; ++k) {
    Loads loads(svg, scene, view, k, present);
    for (const BodyScene& body : scene.bodies)
      if (!body.rigid) loads.boundary(body);
    for (const PointLoad& load : scene.point_loads)
      if (load.load_case == k) loads.point_load(load);
    for (const BodyForce& force : scene.body_forces)
      if (force.load_case == k) loads.body_force(force);
    for (const RigidMotion& motion : scene.motions)
      if (motion.load_case == k) loads.rigid_motion(motion);
    for (const RigidLoad& load : scene.rigid_loads)
      if (k == 0) loads.rigid_load(load); // of all cases together
  }
}

std::vector<LegendEntry> symbol_legend(const Scene& scene, const Present& present) {
  const auto rigid = std::count_if(scene.bodies.begin(), scene.bodies.end(), [](const BodyScene& b) { return b.rigid; });
  const char* const words[] = {"traction",
                               "point load",
                               "prescribed displacement",
                               "body force",
                               "rotation",
                               rigid > 1 ? "motion of a rigid body" : "motion of the rigid body",
                               "force on a rigid body",
                               "moment on a rigid body"};
  std::vector<LegendEntry> out;
  if (present.support) out.push_back({"support (filled: in both directions)", Stroke{}, Mark::kTriangle, false, ""});
  const bool many = scene.cases > kMostListed;
  for (size_t k = 0; k < (many ? kLoadStyles : scene.cases); ++k)
    for (size_t s = 0; s < static_cast<size_t>(Symbol::kSymbols); ++s) {
      std::string cases; // of this stroke
      int count = 0;
      for (size_t c = k; c < std::min(present.load[s].size(), scene.cases) && count <= kMostNamed;
           c += many ? kLoadStyles : scene.cases) {
        if (!present.load[s][c]) continue;
        cases += (count > 0 ? ", " : "") + (count < kMostNamed ? std::to_string(c + 1) : "...");
        ++count;
      }
      if (count == 0) continue;
      const Symbol symbol = static_cast<Symbol>(s);
      const bool all = symbol == Symbol::kRigidForce || symbol == Symbol::kRigidMoment;
      const std::string which = all ? ", largest of the path" : (count > 1 ? ", cases " : ", case ") + cases;
      const std::string text = words[s] + (scene.cases > 1 ? which : "");
      out.push_back({text, stroke_of(symbol, k), Mark::kNone, true, "", head_of(symbol)});
    }
  return out;
}

} // namespace app
