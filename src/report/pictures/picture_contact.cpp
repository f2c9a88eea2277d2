// The first picture of a page: pressure and friction drawn on the deformed bodies where they act.
#include "post/edges.hpp"
#include "report/drawn/axes.hpp"
#include "report/pictures/deformation.hpp"
#include "report/pictures/pictures.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kLeft = 62.0, kRight = 14.0;
constexpr double kDiagram = 92.0;        // pixels: height of the diagram of the largest pressure
constexpr double kRound = 60.0;          // the same where it would reach out of the frame: all round a contact
constexpr double kArrowSpacing = 17.0;   // pixels along the surface
constexpr double kDeformed = 1.0 / 12.0; // of what touches and a margin: largest displacement relative to the mean
constexpr double kLittleFriction = 0.25; // of the pressure: less is drawn to a scale of its own
const Stroke kPressure{colour::kBlue, 1.8, ""}, kFriction{colour::kOrange, 1.8, ""};

// A zone at the last state of the last coefficient.
struct Contact {
  Contact(const Scene& of, size_t zone_index, const CoefficientRecord& record)
      : scene(of), zone(of.zones[zone_index]), table(record.table), tied(is_tied(record, of.zones[zone_index])),
        images_(images_of(of, of.zones[zone_index])) {}
  const Scene& scene;
  const ZoneScene& zone;
  const std::vector<double>& table;
  bool tied;
  double friction_scale = 1.0; // friction is drawn so many times larger than pressure
  double value(size_t pair, int column) const { return table[pair * C2D_PAIR_FIELDS + static_cast<size_t>(column)]; }
  bool touches(size_t pair) const { return static_cast<int>(value(pair, C2D_STATUS)) != C2D_OPEN; }
  bool slips(size_t pair) const { return static_cast<int>(value(pair, C2D_STATUS)) == C2D_SLIP; }
  double largest(int column) const {
    double most = 0.0;
    for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) most = std::max(most, std::fabs(value(p, column)));
    return most;
  }
  size_t peak() const { // the pair of the largest normal stress in size
    size_t most = zone.first;
    for (size_t p = zone.first; p < zone.first + zone.pairs; ++p)
      if (touches(p) && is_larger(std::fabs(value(p, C2D_TN)), std::fabs(value(most, C2D_TN)))) most = p;
    return most;
  }
  // The model and, of a zone that goes on beyond lines of symmetry, its images.
  const std::vector<Image>& images() const { return images_; }

private:
  std::vector<Image> images_;
};

// By which friction is magnified against pressure.
double scale_of_friction(const Contact& c) {
  const double pressure = c.largest(C2D_TN), friction = c.largest(C2D_TT);
  if (!(friction > kNoFriction * pressure) || friction >= kLittleFriction * pressure) return 1.0;
  return round_below(0.5 * pressure / friction);
}

// The mean displacement of side 1 where the bodies touch: what is drawn is relative to it.
Point mean_motion(const Contact& c) {
  Point sum;
  double count = 0.0;
  for (const Image& image : c.images())
    for (size_t p = c.zone.first; p < c.zone.first + c.zone.pairs; ++p) {
      if (!c.touches(p)) continue;
      const Point u = image.direction(c.scene.pairs[p].moved[0]);
      sum.x += u.x, sum.y += u.y, count += 1.0;
    }
  return {sum.x / count, sum.y / count};
}

// The largest motion relative to it of what touches, and of the two bodies as far as they are in view.
double relative_motion(const Contact& c, Point mean, const Chart& view) {
  double most = 0.0;
  const auto take = [&](Point u) { most = std::max(most, std::hypot(u.x - mean.x, u.y - mean.y)); };
  for (const Image& image : c.images()) {
    for (size_t p = c.zone.first; p < c.zone.first + c.zone.pairs; ++p)
      for (const Point& moved : c.scene.pairs[p].moved)
        if (c.touches(p)) take(image.direction(moved));
    for (const int32_t number : c.zone.body) {
      const BodyScene& body = c.scene.bodies[static_cast<size_t>(number) - 1];
      for (size_t i = 0; i < body.displacement.size(); ++i)
        if (view.is_near(view.at(image.place(body.ends[i])))) take(image.direction(body.displacement[i]));
    }
  }
  return most;
}

// Where side 2 of a pair lies after its motion relative to the mean one, which is what a picture to scale shows.
Point place_of(const Contact& c, const Image& image, size_t pair, Point mean) {
  const PairScene& p = c.scene.pairs[pair];
  return image.place(p.on[1]) + (image.direction(p.moved[1]) - mean);
}

// What touches: its places on side 2, where the tractions are drawn.
void extent_of(const Contact& c, Point mean, Range& x, Range& y) {
  for (const Image& image : c.images())
    for (size_t p = c.zone.first; p < c.zone.first + c.zone.pairs; ++p) {
      if (!c.touches(p)) continue;
      const Point at = place_of(c, image, p, mean);
      x.include(at.x), y.include(at.y);
    }
}

// Of the largest relative motion as it is drawn, a multiple: of what touches, whatever the shape of the frame around it (the
// same as in the browser, port/web/draw.js).
constexpr double kContactMargin = 1.25;
double size_of_contact(const Contact& c, Point mean, const Chart& view) {
  Range x, y;
  extent_of(c, mean, x, y);
  const double width = view.x.high - view.x.low, size = kContactMargin * std::max(x.high - x.low, y.high - y.low);
  return size > 0.0 ? std::min(size, width) : width;
}

// The contact in the middle, with `margin` pixels around it.
Chart view_with_margin(const Contact& c, Point mean, double top, double margin) {
  Range x, y;
  extent_of(c, mean, x, y);
  const double size = std::max(x.high - x.low, y.high - y.low), whole = size_of(c.scene);
  const double least = size > 1e-9 * whole ? 0.0 : 0.02 * whole; // of a contact at a point
  for (Range* range : {&x, &y}) {
    const double room = 0.5 * (least - (range->high - range->low));
    if (room > 0.0) range->low -= room, range->high += room;
  }
  const double wide = kPictureWidth - kLeft - kRight;
  const double high = std::min(380.0, std::max(300.0, wide * (y.high - y.low) / std::max(x.high - x.low, 1e-300)));
  return make_view({kLeft, top, kPictureWidth - kRight, top + high}, x, y, margin, c.scene.length_unit);
}

// Pixels per unit of stress, for the diagram of the largest to have this height.
double scale_of_diagrams(const Contact& c, double height) {
  const double largest = std::max(c.largest(C2D_TN), c.friction_scale * c.largest(C2D_TT));
  return largest > 0.0 ? height / largest : 0.0;
}

// Do the diagrams stay in the frame, but for the width of their lines?
bool holds_diagrams(const Contact& c, Point mean, const Chart& view, double height) {
  const double scale = scale_of_diagrams(c, height);
  for (const Image& image : c.images())
    for (size_t p = c.zone.first; p < c.zone.first + c.zone.pairs; ++p) {
      if (!c.touches(p)) continue;
      const Point at = view.at(place_of(c, image, p, mean)), n = image.direction(c.scene.pairs[p].normal);
      for (const double out : {-scale * c.value(p, C2D_TN), c.friction_scale * scale * std::fabs(c.value(p, C2D_TT))}) {
        const double x = at.x + out * n.x, y = at.y - out * n.y;
        if (x < view.frame.left || x > view.frame.right || y < view.frame.top || y > view.frame.bottom) return false;
      }
    }
  return true;
}

struct FramedContact {
  Chart chart;
  double diagram; // height of the largest
};

// With room for the diagrams: a flat contact has it above and below, one that goes round needs it on all sides.
FramedContact view_of_contact(const Contact& c, Point mean, double top) {
  const FramedContact flat{view_with_margin(c, mean, top, 62.0), kDiagram};
  if (holds_diagrams(c, mean, flat.chart, kDiagram)) return flat;
  return {view_with_margin(c, mean, top, kRound + 22.0), kRound};
}

// The surface of side 2 as it is drawn, with the tractions on it, in pixels: y downwards.
struct Acting {
  size_t pair;
  Point at, normal;          // normal: into body 2
  double pressure, friction; // pixels
};

class ContactView {
public:
  ContactView(Svg& svg, const Contact& contact, const Deformation& deformation, const FramedContact& view)
      : svg_(svg), c_(contact), deformation_(deformation), view_(view.chart), scale_(scale_of_diagrams(contact, view.diagram)) {
  }

  void draw() {
    draw_axes(svg_, view_);
    svg_.begin_clip(view_.frame);
    for (size_t b = 0; b < c_.scene.bodies.size(); ++b) body(b);
    const std::vector<char> arrows = choose_arrows();
    for (const Image& image : c_.scene.images)
      for (const std::vector<Acting>& run : runs(image)) draw_run(run, image.turn.x * image.turn.y, arrows);
    svg_.end_clip();
    label_peak();
  }

private:
  void body(size_t b) {
    const Outlines curves = view_.at(deformation_.outline(c_.scene.bodies[b], b));
    svg_.area(curves, style_of(b).fill, Stroke{});
    for (const std::vector<Point>& piece : pieces_within(curves, view_.frame))
      svg_.polyline(piece, Stroke{style_of(b).edge, 1.2, style_of(b).dash});
  }

  Acting acting(const Image& image, size_t pair) const {
    const PairScene& p = c_.scene.pairs[pair];
    const size_t body = static_cast<size_t>(c_.zone.body[1]) - 1;
    const Point at = deformation_.place(body, image.place(p.on[1]), image.direction(p.moved[1]));
    const Point normal = image.direction(p.normal);
    return {pair,
            view_.at(at),
            {normal.x, -normal.y},
            scale_ * c_.value(pair, C2D_TN),
            c_.friction_scale * scale_ * c_.value(pair, C2D_TT)};
  }

  // Stretches of pairs that touch, one after the other.
  std::vector<std::vector<Acting>> runs(const Image& image) const {
    std::vector<std::vector<Acting>> out;
    bool before = false;
    for (size_t p = c_.zone.first; p < c_.zone.first + c_.zone.pairs; ++p) {
      const bool touches = c_.touches(p);
      if (touches && !before) out.emplace_back();
      if (touches) out.back().push_back(acting(image, p));
      before = touches;
    }
    return out;
  }

  // Pairs with arrows: about equal distances, the same ones in all images.
  std::vector<char> choose_arrows() const {
    std::vector<char> out(c_.scene.pairs.size(), 0);
    for (const std::vector<Acting>& run : runs(c_.images()[0])) {
      double since = kArrowSpacing;
      for (size_t i = 0; i < run.size(); ++i) {
        if (i > 0) since += std::hypot(run[i].at.x - run[i - 1].at.x, run[i].at.y - run[i - 1].at.y);
        if (since < kArrowSpacing) continue;
        out[run[i].pair] = 1;
        since = 0.0;
      }
    }
    return out;
  }

  // Pressure stands outside body 2 and pushes into it; friction lies inside, along the surface.
  static Point pressure_end(const Acting& a) { return {a.at.x - a.pressure * a.normal.x, a.at.y - a.pressure * a.normal.y}; }
  static Point friction_end(const Acting& a) {
    const double size = std::fabs(a.friction);
    return {a.at.x + size * a.normal.x, a.at.y + size * a.normal.y};
  }

  void diagram(const std::vector<Acting>& run, Point (*end)(const Acting&), const Stroke& stroke) {
    std::vector<Point> outer, closed;
    for (const Acting& a : run) outer.push_back(end(a));
    closed = outer;
    for (size_t i = run.size(); i-- > 0;) closed.push_back(run[i].at);
    svg_.raw("<g fill-opacity=\"0.3\">\n");
    svg_.area({closed}, stroke.colour, Stroke{});
    svg_.raw("</g>\n");
    svg_.polyline(outer, stroke);
  }

  // `turn`: -1 in a mirror image, where t is reversed.
  void draw_run(const std::vector<Acting>& run, double turn, const std::vector<char>& arrows) {
    const bool friction = c_.largest(C2D_TT) > kNoFriction * c_.largest(C2D_TN);
    diagram(run, pressure_end, kPressure);
    if (friction) diagram(run, friction_end, kFriction);
    surface(run);
    for (const Acting& a : run) {
      if (!arrows[a.pair]) continue;
      if (std::fabs(a.pressure) > 6.0) svg_.arrow(pressure_end(a), a.at, Stroke{colour::kBlue, 1.0, ""}, 5.0);
      const double way = turn * a.friction; // along t = n turned by -90 degrees; in pixels (ny, -nx) is (-ny, nx)
      if (!friction || std::fabs(way) < 6.0) continue;
      const double half = std::min(7.5, 0.5 * std::fabs(way)) * (way > 0.0 ? 1.0 : -1.0);
      const Point middle{a.at.x + 6.0 * a.normal.x, a.at.y + 6.0 * a.normal.y}, along{-a.normal.y, a.normal.x};
      svg_.arrow({middle.x - half * along.x, middle.y - half * along.y}, {middle.x + half * along.x, middle.y + half * along.y},
                 Stroke{colour::kOrange, 1.4, ""}, 6.0);
    }
  }

  // Stuck and tied surfaces are a full line, slipping ones a broken one.
  void surface(const std::vector<Acting>& run) {
    for (size_t i = 0; i + 1 < run.size(); ++i) {
      const bool slips = !c_.tied && (c_.slips(run[i].pair) || c_.slips(run[i + 1].pair));
      if (!slips) svg_.polyline({run[i].at, run[i + 1].at}, Stroke{c_.tied ? colour::kTie : colour::kInk, 2.4, ""});
    }
  }

  void label_peak() {
    const size_t peak = c_.peak();
    const Acting a = acting(c_.images()[0], peak);
    const Point end = pressure_end(a);
    const std::string text = figure(c_.value(peak, C2D_TN), c_.scene.stress_unit);
    const double half = 0.5 * text_width(text, 12.0);
    const Box& f = view_.frame;
    const double x = std::min(f.right - half - 3.0, std::max(f.left + half + 3.0, end.x - 12.0 * a.normal.x));
    const double y = std::min(f.bottom - 6.0, std::max(f.top + 14.0, end.y - 12.0 * a.normal.y + 4.0));
    svg_.text({x, y}, text, 12.0, Anchor::kMiddle, colour::kBlue, false, true);
  }

  Svg& svg_;
  const Contact& c_;
  const Deformation& deformation_;
  const Chart& view_;
  double scale_; // pixels per stress
};

std::vector<LegendEntry> legend_of(const Contact& c) {
  const std::string on = " on " + body_label(c.scene, c.zone.body[1]);
  std::vector<LegendEntry> out;
  out.push_back({(c.tied ? "normal stress of the tie" : "pressure") + on, kPressure, Mark::kNone, true, "", Head::kFilled});
  if (c.largest(C2D_TT) > kNoFriction * c.largest(C2D_TN)) {
    std::string text = c.tied ? "shear stress" : "friction";
    if (c.friction_scale > 1.0) text += ", drawn &#215; " + figure(c.friction_scale);
    out.push_back({text + on, kFriction, Mark::kNone, true, "", Head::kFilled});
  }
  bool sticks = false;
  for (size_t p = c.zone.first; p < c.zone.first + c.zone.pairs; ++p) sticks = sticks || (c.touches(p) && !c.slips(p));
  if (c.tied)
    out.push_back({"tie", Stroke{colour::kTie, 2.4, ""}, Mark::kNone, true, ""});
  else if (sticks)
    out.push_back({"stick", Stroke{colour::kInk, 2.4, ""}, Mark::kNone, true, ""});
  return out;
}

std::string caption_of(const Contact& c, const Deformation& deformation) {
  const Scene& scene = c.scene;
  const size_t peak = c.peak();
  const std::string two = body_label(scene, c.zone.body[1]), one = body_label(scene, c.zone.body[0]);
  std::string out = std::string("Stresses on ") + two + (c.tied ? " where it is tied to " : " where it touches ") + one +
                    ", at " + place_at_end(scene) + ": the largest " +
                    (c.tied ? "normal stress (pressure is positive)" : "pressure") + " of a pair is " +
                    figure(c.value(peak, C2D_TN), scene.stress_unit, 6) + " at " + c.zone.position + " = " +
                    figure(scene.pairs[peak].s, scene.length_unit);
  const double friction = c.largest(C2D_TT);
  if (friction > kNoFriction * c.largest(C2D_TN))
    out += std::string(", the largest ") + (c.tied ? "shear stress " : "friction ") + figure(friction, scene.stress_unit, 4);
  out += ". Those on " + one + " are opposite. The bodies are drawn deformed";
  out += deformation.factor() == 1.0 ? ", to scale."
                                     : ", displacements (relative to the mean motion of the contact) and gaps &#215; " +
                                           figure(deformation.factor(), 9) + ".";
  if (c.zone.has_images) out += std::string(" The part beyond the ") + scene.mirror_name() + " is the image.";
  return out;
}

void draw_contact_of(const Scene& scene, size_t coefficient, size_t zone_index, Pictures& out) {
  const ZoneScene& zone = scene.zones[zone_index];
  const CoefficientRecord& record = scene.record->coefficients[coefficient];
  if (coefficient + 1 < scene.record->coefficients.size()) return; // displacements are those of the last one
  if (scene.bodies[static_cast<size_t>(zone.body[0]) - 1].platen) return;
  Contact c(scene, zone_index, record);
  bool any = false;
  for (size_t p = zone.first; p < zone.first + zone.pairs; ++p) any = any || c.touches(p);
  if (!any || !(c.largest(C2D_TN) > 0.0)) return;
  c.friction_scale = scale_of_friction(c);
  const std::vector<LegendEntry> entries = legend_of(c);
  const double top = 16.0 + draw_legend(nullptr, {kLeft, 4.0}, kPictureWidth - kLeft - kRight, entries);
  const Point mean = mean_motion(c);
  const FramedContact drawn = view_of_contact(c, mean, top);
  const Chart& view = drawn.chart;
  const double wanted = wanted_factor(size_of_contact(c, mean, view), relative_motion(c, mean, view), kDeformed);
  const GapLift lift(scene);
  const Deformation deformation = choose_deformation(scene, lift, wanted, mean, [&](const Deformation&) { return view; });
  const std::string suffix = scene.zones.size() > 1 ? "_zone" + std::to_string(zone_index + 1) : "", name = "contact" + suffix;
  Svg svg(name, kPictureWidth, view.frame.bottom + 42.0);
  draw_legend(&svg, {kLeft, 4.0}, kPictureWidth - kLeft - kRight, entries);
  ContactView(svg, c, deformation, drawn).draw();
  const bool friction = c.largest(C2D_TT) > kNoFriction * c.largest(C2D_TN);
  const char* title = c.tied     ? "Stresses of the tie"
                      : friction ? "Pressure and friction where they act"
                                 : "Pressure where it acts";
  Picture picture{name, title, caption_of(c, deformation), ""};
  if (scene.zones.size() > 1) picture.title += ", " + zone_label(scene, zone_index);
  picture.svg = svg.finish(picture.title, picture.caption);
  out.push_back(picture);
}

} // namespace

void draw_contact(const Scene& scene, Pictures& out) {
  if (scene.solved) draw_charts(scene, scene.record->coefficients.size(), draw_contact_of, out);
}

} // namespace app
