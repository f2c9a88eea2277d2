#include "report/drawn/axes.hpp"
#include "report/pictures/contour.hpp"
#include "report/pictures/model_symbols.hpp"
#include "report/pictures/pictures.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// A rigid body is hatched.
std::string fill_of(Svg& svg, const Scene& scene, size_t b) {
  return scene.bodies[b].rigid ? svg.hatch(style_of(b).hatch, style_of(b).fill) : std::string(style_of(b).fill);
}

Stroke platen_stroke(size_t b) { return {style_of(b).edge, 5.0, ""}; }

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
    present_.taken.clear();
    draw_supports(svg_, scene_, view_, present_);
    draw_loads(svg_, scene_, view_, present_);
    svg_.end_clip();
    taken_.insert(taken_.end(), present_.taken.begin(), present_.taken.end());
    if (scene_.bodies.size() > 1) body_labels();
    pair_labels();
  }

private:
  void bodies(size_t b) {
    const BodyScene& body = scene_.bodies[b];
    if (body.platen) return platen(b);
    const Outlines curves = view_.at(outline_of(body, 0.0));
    svg_.area(curves, fill_of(svg_, scene_, b), Stroke{style_of(b).edge, 1.3, ""});
    for (const Image& image : scene_.images) {
      Point last{-1e9, -1e9};
      for (const Point& corner : body.corners) {
        const Point p = view_.at(image.place(corner));
        if (!view_.is_near(p) || distance(p, last) < 3.0) continue;
        svg_.mark(Mark::kCircle, p, zoom_ ? 3.2 : 2.2, style_of(b).edge);
        taken_.push_back(around(p, 3.0, 3.0));
        last = p;
      }
    }
  }

  // A bar along the ends that it moves, and their places on it.
  void platen(size_t b) {
    for (const ZoneScene& zone : scene_.zones) {
      if (zone.body[0] != static_cast<int32_t>(b) + 1) continue;
      for (const Image& image : scene_.images) {
        std::vector<Point> bar;
        for (size_t p = zone.first; p < zone.first + zone.pairs; ++p)
          bar.push_back(view_.at(image.place(scene_.pairs[p].on[0])));
        svg_.polyline(bar, platen_stroke(b));
        for (const Point& p : bar)
          if (view_.is_near(p)) svg_.mark(Mark::kSquare, p, 5.0, style_of(b).edge, false);
      }
    }
  }

  void lines_of_symmetry() {
    const Stroke line{colour::kFaint, 1.2, "14 4 3 4"};
    const Summary& s = scene_.summary;
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

  // Pairs that may touch are green squares, tied ones diamonds of another colour.
  void pairs() {
    for (const Image& image : scene_.images)
      for (const PairScene& pair : scene_.pairs) {
        if (!is_of_contact(scene_, pair)) continue;
        const Point a = view_.at(image.place(pair.on[0])), b = view_.at(image.place(pair.on[1]));
        if (!view_.is_near(a)) continue;
        const bool tied = scene_.zones[static_cast<size_t>(pair.zone) - 1].tied;
        const char* ink = tied ? colour::kTie : colour::kGreen;
        const Mark mark = tied ? Mark::kDiamond : Mark::kSquare;
        svg_.line(a, b, Stroke{ink, zoom_ ? 1.2 : 1.0, ""});
        if (zoom_) svg_.mark(mark, a, 4.5, ink);
        if (zoom_) svg_.mark(mark, b, 4.5, ink, false);
        taken_.push_back(around(a, 4.0, 4.0)), taken_.push_back(around(b, 4.0, 4.0));
      }
    if (zoom_) return;
    for (const Image& image : scene_.images)
      for (const ZoneScene& zone : scene_.zones) {
        if (scene_.bodies[static_cast<size_t>(zone.body[0]) - 1].platen) continue;
        std::vector<Point> line;
        for (size_t p = zone.first; p < zone.first + zone.pairs; ++p)
          line.push_back(view_.at(image.place(scene_.pairs[p].on[0])));
        svg_.polyline(line, Stroke{zone.tied ? colour::kTie : colour::kGreen, 2.6, ""});
      }
  }

  // Numbers of the first and last pair of each zone in the zoom, where there is room beside them.
  void pair_labels() {
    if (!zoom_) return;
    for (const ZoneScene& zone : scene_.zones) {
      if (zone.pairs == 0) continue;
      const size_t last = zone.first + zone.pairs - 1;
      for (const size_t p : {zone.first, last}) {
        const std::string number = std::to_string(p + 1);
        Point at;
        if (find_room(view_.at(scene_.pairs[p].on[0]), 0.5 * text_width(number, 11.0) + 1.0, 7.0, 40.0, at))
          svg_.text({at.x, at.y + 4.0}, number, 11.0, Anchor::kMiddle, zone.tied ? colour::kTie : colour::kGreen, false, true);
        if (last == zone.first) break;
      }
    }
  }

  // The number of every body: inside, where nothing else stands; else beside it, with a line to it.
  void body_labels() {
    for (size_t b = 0; b < scene_.bodies.size(); ++b) {
      const Outlines curves = view_.at(outline_of(scene_.bodies[b], 0.0));
      const std::string number = std::to_string(b + 1);
      const double half = std::max(9.0, 0.5 * text_width(number, kBodyNumber) + 3.0);
      double room = 0.0;
      Point at = widest_place(curves, half, taken_, room);
      if (room < half) {
        const Point inside = widest_place(curves, 0.0, {}, room);
        if (room <= 0.0 || zoom_ || !find_room(inside, half, half, 90.0, at)) continue;
        const double apart = distance(inside, at);
        svg_.line(inside, {at.x + half / apart * (inside.x - at.x), at.y + half / apart * (inside.y - at.y)},
                  Stroke{style_of(b).edge, 1.0, ""});
      }
      taken_.push_back(around(at, half, half));
      svg_.mark(Mark::kCircle, at, 2.0 * half, style_of(b).edge, false);
      svg_.text({at.x, at.y + 4.5}, number, kBodyNumber, Anchor::kMiddle, style_of(b).edge, false, true);
    }
  }

  // The place nearest to a point, within the frame and a distance, where nothing stands, no edge of a body either.
  bool find_room(Point from, double half_width, double half_height, double most, Point& out) {
    const Box& f = view_.frame;
    if (edges_.empty()) collect_edges();
    for (double radius = std::max(half_width, half_height) + 5.0; radius <= most; radius += 4.0)
      for (int k = 0; k < 24; ++k) {
        const double angle = 3.14159265358979323846 * (k % 2 == 0 ? k / 2 : -(k + 1) / 2) / 12.0 + 1.5707963267948966;
        const Point p{from.x + radius * std::cos(angle), from.y + radius * std::sin(angle)};
        const Box box = around(p, half_width, half_height);
        if (box.left < f.left + 2.0 || box.right > f.right - 2.0 || box.top < f.top + 2.0 || box.bottom > f.bottom - 2.0)
          continue;
        if (!is_free(box, taken_) || !is_free(box, edges_)) continue;
        out = p;
        taken_.push_back(box);
        return true;
      }
    return false;
  }

  void collect_edges() {
    edges_.push_back({-1e9, -1e9, -1e9, -1e9}); // collected, whatever follows
    for (const BodyScene& body : scene_.bodies)
      for (const std::vector<Point>& curve : outline_of(body, 0.0))
        for (size_t i = 0; i < curve.size(); ++i) {
          const Point a = view_.at(curve[i]), b = view_.at(curve[(i + 1) % curve.size()]);
          const int parts = 1 + static_cast<int>(std::min(500.0, distance(a, b) / 4.0));
          for (int k = 0; k < parts; ++k) {
            const Point p{a.x + (b.x - a.x) * k / parts, a.y + (b.y - a.y) * k / parts};
            if (view_.is_near(p)) edges_.push_back(around(p, 1.5, 1.5));
          }
        }
  }

  // Of the middles of rows and columns of a body within the frame, those amid the body first, the one farthest
  // from its boundary where nothing stands; `room`: how far. 0: there is none.
  Point widest_place(const Outlines& curves, double half, const std::vector<Box>& taken, double& room) const {
    const Box& f = view_.frame;
    const Box inner{f.left + half + 1.0, f.top + half + 1.0, f.right - half - 1.0, f.bottom - half - 1.0};
    Range x, y;
    for (const auto& curve : curves)
      for (const Point& p : curve) x.include(p.x), y.include(p.y);
    const int lines = 41;
    Point best;
    for (int i = 0; i < 2 * lines; ++i) {
      const bool row = i < lines;
      const double low = row ? std::max(y.low, inner.top) : std::max(x.low, inner.left);
      const double high = row ? std::min(y.high, inner.bottom) : std::min(x.high, inner.right);
      if (low > high) continue;
      const int k = i % lines, place = lines / 2 + (k % 2 == 0 ? k / 2 : -(k + 1) / 2);
      const double level = low + (place + 0.5) / lines * (high - low);
      for (const Point& p : middles(curves, inner, level, row)) {
        const Box label = around(p, half, half);
        if (!is_free(label, taken)) continue;
        const double here = distance_to_outline(curves, p);
        if (here > room + 0.5 || room == 0.0) best = p, room = here;
      }
    }
    return best;
  }

  // Middles of the parts of a row (y = level) or column that lie inside curves and a box.
  static std::vector<Point> middles(const Outlines& curves, const Box& box, double level, bool row) {
    std::vector<double> crossings;
    for (const std::vector<Point>& curve : curves)
      for (size_t i = 0, j = curve.size() - 1; i < curve.size(); j = i++) {
        const Point a = row ? curve[i] : Point{curve[i].y, curve[i].x}, b = row ? curve[j] : Point{curve[j].y, curve[j].x};
        if ((a.y > level) != (b.y > level)) crossings.push_back(a.x + (level - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    std::sort(crossings.begin(), crossings.end());
    std::vector<Point> out;
    for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double low = std::max(crossings[i], row ? box.left : box.top);
      const double high = std::min(crossings[i + 1], row ? box.right : box.bottom);
      if (low < high) out.push_back(row ? Point{0.5 * (low + high), level} : Point{level, 0.5 * (low + high)});
    }
    return out;
  }

  static Box around(Point p, double half_width, double half_height) {
    return {p.x - half_width, p.y - half_height, p.x + half_width, p.y + half_height};
  }
  static bool is_free(const Box& box, const std::vector<Box>& taken) {
    for (const Box& other : taken)
      if (box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom) return false;
    return true;
  }
  static constexpr double kBodyNumber = 12.5; // size of the text

  Svg& svg_;
  const Scene& scene_;
  const Chart& view_;
  bool zoom_;
  Present& present_;
  std::vector<Box> taken_; // by nodes, pairs, symbols and labels
  std::vector<Box> edges_; // of bodies
};

std::vector<LegendEntry> legend(Svg& svg, const Scene& scene, const Present& present) {
  std::vector<LegendEntry> out;
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string label = body_label(scene, static_cast<int64_t>(b) + 1);
    if (scene.bodies[b].platen)
      out.push_back({label + ": ends that it moves", platen_stroke(b), Mark::kSquare, true, ""});
    else
      out.push_back({label + (scene.bodies[b].rigid ? ", rigid" : ""), Stroke{style_of(b).edge, 1.3, ""}, Mark::kNone, true,
                     fill_of(svg, scene, b)});
  }
  bool kinds[2] = {false, false}; // contact, tie
  for (const PairScene& pair : scene.pairs)
    if (is_of_contact(scene, pair)) kinds[scene.zones[static_cast<size_t>(pair.zone) - 1].tied ? 1 : 0] = true;
  if (kinds[0]) out.push_back({"contact zone", Stroke{colour::kGreen, 2.6, ""}, Mark::kSquare, true, ""});
  if (kinds[1]) out.push_back({"tie", Stroke{colour::kTie, 2.6, ""}, Mark::kDiamond, true, ""});
  if (scene.summary.symmetry != 0)
    out.push_back({scene.mirror_name(), Stroke{colour::kFaint, 1.2, "14 4 3 4"}, Mark::kNone, true, ""});
  for (const LegendEntry& entry : symbol_legend(scene, present)) out.push_back(entry);
  return out;
}

std::string describe_body(const Scene& scene, size_t b) {
  const Summary& s = scene.summary;
  std::string out = std::to_string(s.body[b].elements) + " elements";
  if (scene.bodies[b].rigid) return out + ", rigid";
  return out + ", E = " + figure(s.body[b].youngs_modulus, scene.stress_unit) + ", Poisson's ratio " +
         figure(s.body[b].poisson_ratio);
}

std::string model_caption(const Scene& scene) {
  const Summary& s = scene.summary;
  std::string out = s.bodies == 1   ? "The body as the deck describes it: "
                    : s.bodies == 2 ? "Both bodies as the deck describes them: "
                                    : "All bodies as the deck describes them: ";
  for (size_t b = 0; b < scene.bodies.size(); ++b) {
    if (b > 0) out += "; ";
    const std::string label = body_label(scene, static_cast<int64_t>(b) + 1);
    if (scene.bodies[b].platen) {
      out += label + " moves " + s.moved_by(static_cast<int32_t>(b) + 1) + " as if rigid";
      continue;
    }
    if (s.bodies > 1) out += label + " has ";
    out += describe_body(scene, b);
  }
  out += s.plane == C2D_AXISYMMETRIC   ? "; half section of bodies of revolution about x = 0."
         : s.plane == C2D_PLANE_STRESS ? "; plane stress."
                                       : "; plane strain.";
  if (!scene.pairs.empty())
    out += " The contact is described by " + std::to_string(s.pairs) + " pairs of nodes in " + std::to_string(s.zones) +
           (s.zones == 1 ? " zone." : " zones.");
  for (size_t z = 0; z < scene.zones.size(); ++z)
    if (scene.zones[z].free)
      out += " Z" + zone_label(scene, z).substr(1) + " joins nodes of " + body_label(scene, scene.zones[z].body[1]) +
             " to points of " + body_label(scene, scene.zones[z].body[0]) + ": the meshes need not match.";
  if (mirror_lines(s) != 0)
    out += std::string(" One side of the ") + scene.mirror_name() + " was given, the other is its image.";
  if (mirror_lines(s) != 0 && !scene.pairs.empty()) out += " Pairs are numbered on the side given.";
  if (scene.cases > 1) out += " Each load is multiplied by the factor of its load case.";
  if (scene.interference > 0)
    out += " The factor of load case " + std::to_string(scene.interference) + " closes the overlaps of the press fit.";
  return out;
}

} // namespace

namespace {

// A frame with the model or a part of it, and the legend below.
Picture draw_model_view(const Scene& scene, const std::string& name, const Range& x, const Range& y, bool zoom,
                        const Chart* marked) {
  const double left = 62.0, right = 14.0, top = 12.0, wide = kPictureWidth - left - right;
  const double high = view_height(x, y, wide, 200.0, 400.0);
  const Chart view = make_view({left, top, left + wide, top + high}, x, y, zoom ? 26.0 : 44.0, scene.length_unit);
  Present present;
  Svg trial(name, kPictureWidth, 0.0); // finds what is present before the height is known
  ModelView(trial, scene, view, zoom, present).draw();
  const double legend_top = view.frame.bottom + 44.0;
  const double height = legend_top + draw_legend(nullptr, {left, legend_top}, wide, legend(trial, scene, present)) + 4.0;
  Svg svg(name, kPictureWidth, height);
  ModelView(svg, scene, view, zoom, present).draw();
  if (marked != nullptr) draw_zoom_frame(svg, view, *marked);
  draw_legend(&svg, {left, legend_top}, wide, legend(svg, scene, present));
  Picture picture{name, "Model", model_caption(scene), ""};
  if (zoom) {
    picture.title = "Model at the contact";
    picture.caption = "The part in the dashed frame of the whole model. Squares and diamonds are pairs, filled on side 1; "
                      "numbers are those of the first and last pair of each zone.";
  }
  picture.svg = svg.finish(picture.title, picture.caption);
  return picture;
}

} // namespace

void draw_model(const Scene& scene, Pictures& out) {
  constexpr double kAlike = 0.6; // a part that is this large against the whole is not drawn again
  Range x, y, zoom_x, zoom_y;
  for (const BodyScene& body : scene.bodies)
    for (const auto& curve : body.curves)
      for (const OutlinePoint& p : curve) x.include(p.at.x), y.include(p.at.y);
  for (const Image& image : scene.zone_images)
    for (const PairScene& pair : scene.pairs)
      for (const Point& on : pair.on) {
        if (!is_of_contact(scene, pair)) continue;
        const Point p = image.place(on);
        zoom_x.include(p.x), zoom_y.include(p.y);
      }
  if (x.empty) return;
  const double whole = std::max(x.high - x.low, y.high - y.low);
  const bool zoom = has_contact(scene) && std::max(zoom_x.high - zoom_x.low, zoom_y.high - zoom_y.low) < kAlike * whole;
  const double wide = kPictureWidth - 76.0, high = view_height(zoom_x, zoom_y, wide, 200.0, 400.0);
  const Chart close = make_view({0.0, 0.0, wide, high}, zoom_x, zoom_y, 26.0, "");
  out.push_back(draw_model_view(scene, "model", x, y, false, zoom ? &close : nullptr));
  if (zoom) out.push_back(draw_model_view(scene, "model_zone", zoom_x, zoom_y, true, nullptr));
}

} // namespace app
