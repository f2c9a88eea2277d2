#include "report/axes.hpp"
#include "report/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const char* const kEdge[2] = {colour::kBlue, "#8a5a00"};

Point mapped(const Chart& view, Point p) {
  return view.at(p.x, p.y);
}
double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// Symbols closer than this to one of their kind are left out.
constexpr double kSpacing = 11.0;

// What of the model is there, for the legend.
struct Present {
  bool support = false, prescribed = false, traction = false, point_load = false;
};

class ModelView {
public:
  ModelView(Svg& svg, const Scene& scene, const Chart& view, bool zoom, Present& present)
      : svg_(svg), scene_(scene), view_(view), zoom_(zoom), present_(present) {}

  void draw() {
    draw_axes(svg_, view_);
    svg_.begin_clip(view_.frame);
    for (size_t b = 0; b < scene_.bodies.size(); ++b) bodies(b);
    lines_of_symmetry();
    pairs();
    for (const BodyScene& body : scene_.bodies) supports(body);
    for (const BodyScene& body : scene_.bodies) loads(body);
    for (const PointLoad& load : scene_.point_loads) point_load(load);
    svg_.end_clip();
    labels();
  }

private:
  bool visible(Point p) const {
    const Box& f = view_.frame;
    return p.x > f.left - 20 && p.x < f.right + 20 && p.y > f.top - 20 && p.y < f.bottom + 20;
  }

  void bodies(size_t b) {
    const BodyScene& body = scene_.bodies[b];
    std::vector<std::vector<Point>> curves = outline_of(body, 0.0);
    for (auto& curve : curves)
      for (Point& p : curve) p = mapped(view_, p);
    svg_.area(curves, colour::kBody[b], Stroke{kEdge[b], 1.3, ""});
    Point last{-1e9, -1e9};
    for (const Point& corner : body.corners) {
      const Point p = mapped(view_, corner);
      if (!visible(p) || distance(p, last) < 3.0) continue;
      svg_.mark(Mark::kCircle, p, zoom_ ? 3.2 : 2.2, kEdge[b]);
      last = p;
    }
  }

  void lines_of_symmetry() {
    const Stroke line{colour::kPurple, 1.2, "14 4 3 4"};
    const c2d_summary& s = scene_.summary;
    const Box& f = view_.frame;
    if ((s.symmetry & 1) != 0) {
      const double x = view_.at(s.symmetry_at[0], 0.0).x;
      svg_.line({x, f.top}, {x, f.bottom}, line);
    }
    if ((s.symmetry & 2) != 0) {
      const double y = view_.at(0.0, s.symmetry_at[1]).y;
      svg_.line({f.left, y}, {f.right, y}, line);
    }
  }

  void pairs() {
    for (const PairScene& pair : scene_.pairs) {
      const Point a = mapped(view_, pair.on[0]), b = mapped(view_, pair.on[1]);
      if (!visible(a)) continue;
      svg_.line(a, b, Stroke{colour::kGreen, zoom_ ? 1.2 : 1.0, ""});
      if (!zoom_) continue;
      svg_.mark(Mark::kSquare, a, 4.5, colour::kGreen);
      svg_.mark(Mark::kSquare, b, 4.5, colour::kGreen, false);
    }
  }

  // A triangle with its tip at `p`, its base away along (dx, dy); with a line behind it where the body may
  // slide.
  void support(Point p, double dx, double dy, bool both) {
    const double h = 8.0, w = 4.5;
    const Point base{p.x + h * dx, p.y + h * dy};
    svg_.area({{p, {base.x - w * dy, base.y + w * dx}, {base.x + w * dy, base.y - w * dx}}},
              both ? colour::kInk : "white", Stroke{colour::kInk, 1.0, ""});
    if (both) return;
    const Point rail{p.x + (h + 2.5) * dx, p.y + (h + 2.5) * dy};
    svg_.line({rail.x - w * dy, rail.y + w * dx}, {rail.x + w * dy, rail.y - w * dx},
              Stroke{colour::kInk, 1.0, ""});
  }

  // Outward direction along x or y at a node: a corner's symbol belongs to the side that it holds.
  std::vector<Point> outward(const BodyScene& body) const {
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

  void supports(const BodyScene& body) {
    const std::vector<Point> out = outward(body);
    std::vector<Point> placed[2];
    for (size_t i = 0; i < body.conditions.size(); ++i) {
      const EndCondition& c = body.conditions[i];
      const Point p = mapped(view_, body.ends[i]);
      const bool fixed[2] = {c.codes[2] == 0 && c.values[2] == 0.0, c.codes[3] == 0 && c.values[3] == 0.0};
      if (!visible(p) || (!fixed[0] && !fixed[1])) continue;
      const size_t kind = fixed[0] && fixed[1] ? 1 : 0;
      if (!take_place(placed[kind], p, kSpacing)) continue;
      present_.support = true;
      const Point n = out[static_cast<size_t>(body.nodes[i])];
      const bool along_x = kind == 1 ? std::fabs(n.x) > std::fabs(n.y) + 1e-3 : fixed[0];
      const double dx = n.x < -1e-6 ? -1.0 : 1.0, dy = n.y > 1e-6 ? -1.0 : 1.0; // of the picture
      support(p, along_x ? dx : 0.0, along_x ? 0.0 : dy, kind == 1);
    }
  }

  // Is there room around p? Then p is taken.
  static bool take_place(std::vector<Point>& placed, Point p, double spacing) {
    for (const Point& other : placed)
      if (distance(p, other) < spacing) return false;
    placed.push_back(p);
    return true;
  }

  void loads(const BodyScene& body) {
    double largest = 0.0;
    for (const EndCondition& c : body.conditions)
      largest = std::max(
          largest, std::hypot(c.codes[0] == 0 ? c.values[0] : 0.0, c.codes[1] == 0 ? c.values[1] : 0.0));
    std::vector<Point> motions, tractions;
    for (size_t i = 0; i < body.conditions.size(); ++i) {
      const EndCondition& c = body.conditions[i];
      const Point p = mapped(view_, body.ends[i]);
      if (!visible(p)) continue;
      const double ux = c.codes[2] == 0 ? c.values[2] : 0.0, uy = c.codes[3] == 0 ? c.values[3] : 0.0;
      const double motion = std::hypot(ux, uy);
      if (motion > 0.0 && take_place(motions, p, 1.5 * kSpacing)) {
        svg_.arrow({p.x - 26.0 * ux / motion, p.y + 26.0 * uy / motion}, p,
                   Stroke{colour::kPurple, 1.6, "4 2"}, 7.0);
        present_.prescribed = true;
      }
      const double tx = c.codes[0] == 0 ? c.values[0] : 0.0, ty = c.codes[1] == 0 ? c.values[1] : 0.0;
      const double size = std::hypot(tx, ty);
      if (largest == 0.0 || size <= 1e-12 * largest || !take_place(tractions, p, 0.8 * kSpacing)) continue;
      present_.traction = true;
      const double length = 10.0 + 18.0 * size / largest, ex = tx / size, ey = -ty / size;
      // Outside the body: pushing arrows end at the boundary, pulling ones begin there.
      if (ex * body.normals[i].x - ey * body.normals[i].y > 0.0)
        svg_.arrow(p, {p.x + length * ex, p.y + length * ey}, Stroke{colour::kOrange, 1.4, ""}, 6.5);
      else
        svg_.arrow({p.x - length * ex, p.y - length * ey}, p, Stroke{colour::kOrange, 1.4, ""}, 6.5);
    }
  }

  void point_load(const PointLoad& load) {
    const Point p = mapped(view_, load.at);
    const double size = std::hypot(load.force.x, load.force.y);
    if (!visible(p) || size == 0.0) return;
    present_.point_load = true;
    svg_.arrow({p.x - 34.0 * load.force.x / size, p.y + 34.0 * load.force.y / size}, p,
               Stroke{colour::kOrange, 2.4, ""}, 9.0);
    svg_.mark(Mark::kCircle, p, 5.0, colour::kOrange);
  }

  // Numbers of the first and last pair of each zone in the zoom.
  void labels() {
    if (!zoom_) return;
    for (const ZoneScene& zone : scene_.zones) {
      if (zone.pairs == 0) continue;
      const size_t last = zone.first + zone.pairs - 1;
      for (const size_t p : {zone.first, last}) {
        const Point a = mapped(view_, scene_.pairs[p].on[0]);
        const std::string number = std::to_string(p + 1);
        const double x = std::min(std::max(a.x, view_.frame.left + 14.0), view_.frame.right - 14.0);
        if (a.y + 24.0 < view_.frame.bottom && a.y > view_.frame.top)
          svg_.text({x, a.y + 20.0}, number, 11.0, Anchor::kMiddle, colour::kGreen, false, true);
        if (last == zone.first) break;
      }
    }
  }

  Svg& svg_;
  const Scene& scene_;
  const Chart& view_;
  bool zoom_;
  Present& present_;
};

std::vector<LegendEntry> legend(const Scene& scene, const Present& present) {
  std::vector<LegendEntry> out;
  for (size_t b = 0; b < scene.bodies.size(); ++b)
    out.push_back(
        {"body " + std::to_string(b + 1), Stroke{kEdge[b], 1.3, ""}, Mark::kNone, true, colour::kBody[b]});
  if (!scene.pairs.empty())
    out.push_back({"contact pairs", Stroke{colour::kGreen, 1.5, ""}, Mark::kSquare, true, ""});
  if (scene.summary.symmetry != 0)
    out.push_back({"line of symmetry", Stroke{colour::kPurple, 1.2, "14 4 3 4"}, Mark::kNone, true, ""});
  if (present.support)
    out.push_back({"held (filled: in both directions)", Stroke{}, Mark::kTriangle, false, ""});
  if (present.prescribed)
    out.push_back({"prescribed displacement", Stroke{colour::kPurple, 1.6, "4 2"}, Mark::kNone, true, ""});
  if (present.traction) out.push_back({"traction", Stroke{colour::kOrange, 1.3, ""}, Mark::kNone, true, ""});
  if (present.point_load)
    out.push_back({"point load", Stroke{colour::kOrange, 2.4, ""}, Mark::kCircle, true, ""});
  return out;
}

std::string model_caption(const Scene& scene) {
  const c2d_summary& s = scene.summary;
  std::string out = s.bodies == 1 ? "The body" : "Both bodies";
  out += " as the deck describes " + std::string(s.bodies == 1 ? "it" : "them") + ": ";
  for (int32_t b = 0; b < s.bodies; ++b) {
    if (b > 0) out += "; ";
    if (s.bodies > 1) out += "body " + std::to_string(b + 1) + " has ";
    out += std::to_string(s.elements[b]) +
           " elements, E = " + figure(s.youngs_modulus[b], scene.stress_unit) + ", Poisson's ratio " +
           figure(s.poisson_ratio[b]);
  }
  out += s.plane == C2D_PLANE_STRESS ? "; plane stress." : "; plane strain.";
  if (!scene.pairs.empty())
    out += " The contact is described by " + std::to_string(s.pairs) + " pairs of nodes in " +
           std::to_string(s.zones) + (s.zones == 1 ? " zone." : " zones.");
  return out;
}

} // namespace

void draw_model(const Scene& scene, Pictures& out) {
  Range x, y, zoom_x, zoom_y;
  for (const BodyScene& body : scene.bodies)
    for (const auto& curve : body.curves)
      for (const OutlinePoint& p : curve) x.include(p.at.x), y.include(p.at.y);
  for (const PairScene& pair : scene.pairs)
    for (const Point& p : pair.on) zoom_x.include(p.x), zoom_y.include(p.y);
  if (x.empty) return;
  const bool zoom = !scene.pairs.empty();
  const double left = 62.0, gap = 66.0, right = 14.0, top = 30.0;
  const double wide = zoom ? (kPictureWidth - left - gap - right) / 2.0 : kPictureWidth - left - right;
  const double high = view_height(x, y, wide, 240.0, zoom ? 420.0 : 460.0);
  const Box whole{left, top, left + wide, top + high},
      part{whole.right + gap, top, whole.right + gap + wide, top + high};
  const Chart view = make_view(whole, x, y, 40.0, scene.length_unit);

  Present present;
  Svg body("model", kPictureWidth, 0.0);
  Svg trial("model", kPictureWidth, 0.0); // tells what is present before the height is known
  ModelView(trial, scene, view, false, present).draw();
  const std::vector<LegendEntry> entries = legend(scene, present);
  const double legend_top = whole.bottom + 44.0;
  const double height =
      legend_top + draw_legend(nullptr, {left, legend_top}, kPictureWidth - left - right, entries) + 4.0;
  Svg svg("model", kPictureWidth, height);
  ModelView(svg, scene, view, false, present).draw();
  draw_heading(svg, whole, "Whole model");
  if (zoom) {
    const Chart close = make_view(part, zoom_x, zoom_y, 30.0, scene.length_unit);
    const Point a = view.at(close.x.low, close.y.high), b = view.at(close.x.high, close.y.low);
    svg.begin_clip(whole);
    svg.rectangle({a.x, a.y, b.x, b.y}, "none", Stroke{colour::kInk, 1.0, "5 3"});
    svg.end_clip();
    ModelView(svg, scene, close, true, present).draw();
    draw_heading(svg, part, "Contact zone (dashed frame)");
  }
  draw_legend(&svg, {left, legend_top}, kPictureWidth - left - right, entries);
  Picture picture{"model", "Model", model_caption(scene), ""};
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace app
