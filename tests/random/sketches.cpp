#include "sketch_pen.hpp"

#include <algorithm>
#include <cmath>

// An indenter on a ground, a layer between them; a pin in a hole; a press fit; a crack. Lengths are in half widths of the
// indenter or radii of the pin.
namespace random_sketches {
namespace {

struct Indenter {
  double height = 2, rise = 0; // of its top, and of the ends of its face
  double radius = 0;           // of its face; 0: it is flat in the middle
  double flat = 0;             // half of the flat's width
};

double chord_rise(double radius, double half_width) { return radius - std::sqrt(radius * radius - half_width * half_width); }

// From (-1, rise) to (1, rise), curve by curve; fillets against the sides too.
void draw_flat(Pen& p, Indenter& shape) {
  const bool sharp = p.dice.chance(0.15);
  const std::string fillet = "  fillet face radius " + p.length(p.dice.between(0.05, 0.5));
  p.tell(sharp ? "sharp punch" : "flat with fillets");
  p.out.sharp = p.out.sharp || sharp;
  shape.flat = 1;
  p.line("  line left to " + p.xy(-1, 0));
  if (!sharp) p.line(fillet);
  p.line("  line face to " + p.xy(1, 0));
  if (!sharp) p.line(fillet);
}

void draw_round(Pen& p, Indenter& shape) {
  shape.radius = p.dice.power(0.02, 1.3);
  shape.rise = chord_rise(shape.radius, 1);
  p.tell("round");
  p.line("  line left to " + p.xy(-1, shape.rise));
  p.line("  arc  face to " + p.xy(1, shape.rise) + " radius " + p.length(shape.radius));
}

void draw_parabola(Pen& p, Indenter& shape) {
  shape.radius = p.dice.power(0.3, 1.3);
  shape.rise = 0.5 / shape.radius;
  p.tell("parabola");
  p.line("  line left to " + p.xy(-1, shape.rise));
  p.line("  curve face t " + p.xy(-1, 1) + " x t y t^2/" + p.length(2 * shape.radius));
}

void draw_spline(Pen& p, Indenter& shape) {
  shape.radius = p.dice.power(0.3, 1.3);
  const auto y = [&](double x) { return x * x / (2 * shape.radius) * (1 + x * x); };
  shape.rise = y(1);
  p.tell("spline");
  p.line("  line left to " + p.xy(-1, shape.rise));
  std::string text = "  spline face through";
  for (const double x : {-0.7, -0.35, 0.0, 0.35, 0.7, 1.0}) text += "  " + p.xy(x, y(x));
  p.line(text);
}

void draw_flat_rounded(Pen& p, Indenter& shape) {
  const double b = shape.flat = p.dice.between(0.2, 0.7), R = p.dice.power(0.1, 1.3);
  shape.rise = chord_rise(R, 1 - b);
  p.tell("flat rounded");
  p.line("  line left to " + p.xy(-1, shape.rise));
  p.line("  arc  face to " + p.xy(-b, 0) + " centre " + p.xy(-b, R));
  p.line("  line face to " + p.xy(b, 0));
  p.line("  arc  face to " + p.xy(1, shape.rise) + " centre " + p.xy(b, R));
}

void draw_wedge(Pen& p, Indenter& shape) {
  const double slope = p.dice.power(-1.7, -0.7);
  shape.rise = slope;
  shape.radius = p.dice.between(0.1, 0.8) / slope;
  p.tell("blunt wedge");
  p.line("  line left to " + p.xy(-1, slope));
  p.line("  line face to " + p.xy(0, 0));
  p.line("  fillet face radius " + p.length(shape.radius));
  p.line("  line face to " + p.xy(1, slope));
}

void draw_feet(Pen& p, Indenter& shape) {
  const double foot = p.dice.between(0.3, 0.7), depth = p.dice.between(0.3, 0.8), r = p.dice.between(0.05, 0.13);
  const std::string fillet = " radius " + p.length(r);
  p.tell("two feet");
  shape.flat = 1;
  p.line("  line left to " + p.xy(-1, 0));
  p.line("  fillet face" + fillet);
  p.line("  line face to " + p.xy(foot - 1, 0));
  p.line("  fillet face" + fillet);
  p.line("  line arch to " + p.xy(foot - 1, depth));
  p.line("  fillet arch" + fillet);
  p.line("  line arch to " + p.xy(1 - foot, depth));
  p.line("  fillet arch" + fillet);
  p.line("  line arch to " + p.xy(1 - foot, 0));
  p.line("  fillet face" + fillet);
  p.line("  line face to " + p.xy(1, 0));
  p.line("  fillet face" + fillet);
}

Indenter draw_indenter(Pen& p) {
  Indenter shape;
  shape.height = p.dice.between(1.2, 3);
  p.line("body pad" + p.material(1, true));
  p.line("  from " + p.xy(-1, shape.height));
  void (*const faces[])(Pen&, Indenter&) = {draw_flat,         draw_round, draw_parabola, draw_spline,
                                            draw_flat_rounded, draw_wedge, draw_feet};
  faces[p.dice.whole(0, 6)](p, shape);
  p.line("  line right to " + p.xy(1, shape.height));
  p.line("  line top close");
  return shape;
}

void draw_hole(Pen& p, double depth) {
  const double x = p.dice.between(-1, 1), r = p.dice.between(0.2, 0.6);
  p.tell("hole");
  p.line("  hole");
  if (p.dice.chance(0.5))
    p.line("  circle bore centre " + p.xy(x, -depth) + " radius " + p.length(r));
  else
    p.line("  ellipse bore centre " + p.xy(x, -depth) + " axes " + p.xy(r, r * p.dice.between(0.4, 0.9)) + " tilt " +
           Pen::number(std::floor(p.dice.between(0, 180))));
}

// A block below y = -layer; true if it has a hole.
bool draw_ground(Pen& p, double layer, bool crowned) {
  const double W = p.dice.between(3, 7), H = p.dice.between(3, 6), R = W * p.dice.power(0.3, 1.5);
  const double low = crowned ? chord_rise(R, W) : 0;
  p.line("body ground" + p.material(0, true));
  p.line("  from " + p.xy(-W, -layer - low - H));
  p.line("  line bottom to " + p.xy(W, -layer - low - H));
  p.line("  line side to " + p.xy(W, -layer - low));
  if (crowned) {
    p.tell("crowned ground");
    p.line("  arc  top to " + p.xy(-W, -layer - low) + " radius " + p.length(R));
  } else {
    p.line("  line top to " + p.xy(-W, -layer));
  }
  p.line("  line side close");
  const bool hole = !p.rigid[0] && p.dice.chance(0.25);
  if (hole) draw_hole(p, layer + p.dice.between(1.5, 2.2));
  return hole;
}

void draw_layer(Pen& p, double thickness) {
  const double L = p.dice.between(1.5, 2.8);
  const double E = p.stress * p.dice.power(-1, 1);
  p.line("body layer E " + Pen::number(E) + " nu 0.3");
  p.line("  from " + p.xy(-L, -thickness));
  p.line("  line under to " + p.xy(L, -thickness));
  p.line("  line side to " + p.xy(L, 0));
  p.line("  line top to " + p.xy(-L, 0));
  p.line("  line side close");
}

// The force that presses an indenter to a contact of some part of its width.
double press(Pen& p, const Indenter& shape) {
  if (shape.radius == 0) return 2 * p.dice.power(-3.5, -2) * p.modulus();
  const double a = p.dice.between(0.08, 0.5);
  return std::acos(-1.0) / 4 * p.modulus() * a * a / std::max(shape.radius, 1.0);
}

void write_history(Pen& p, bool shears) {
  std::string text = "history normal 1";
  if (!shears && p.dice.chance(0.3)) text += ", 0.4", p.tell("unloading"); // with shear it would slide off
  const int32_t turns = shears ? p.dice.whole(1, 3) : 0;
  if (shears) text += "; shear 1";
  if (turns > 1) text += ", -0.8", p.tell("reversal");
  if (turns > 2) text += ", 0.9";
  p.line(text);
  p.line("steps " + std::to_string(p.dice.whole(2, 5)));
}

// The indenter goes down, and to the side.
void load_by_motion(Pen& p, const Indenter& shape, const std::string& moved, double P) {
  const double d = P / p.modulus() * p.dice.between(1, 2);
  p.tell("moved");
  p.line("  " + moved + " x 0 y " + p.length(-d) + " turn 0");
  const bool shears = p.friction > 0 && p.dice.chance(0.6);
  if (shears) p.line("case shear"), p.line("  " + moved + " x " + p.length(d * p.friction * p.dice.between(0.2, 1.5)));
  (void)shape;
  write_history(p, shears);
}

void load_by_force(Pen& p, const Indenter& shape, const std::string& moved, double P) {
  const bool turns = shape.flat > 0.6 && p.dice.chance(0.4), held = p.friction == 0;
  std::string text = "  " + moved + (held ? " x 0 fy " : " fx 0 fy ") + p.force(-P);
  if (turns)
    text += " moment " + p.moment(P * p.dice.between(-0.3, 0.3)), p.tell("moment");
  else
    text += " turn 0";
  p.line(text);
  const bool shears = !held && p.dice.chance(0.7);
  if (shears) {
    const double share = p.dice.chance(0.07) ? 1.1 : p.dice.between(0.1, 0.9);
    p.tell(share > 1 ? "pushed away" : "shear");
    p.line("case shear");
    p.line("  " + moved + " fx " + p.force(share * p.friction * P));
  }
  write_history(p, shears);
}

void draw_wants(Pen& p, double layer, bool hole, double left = -1) {
  if (!p.rigid[0] && p.dice.chance(0.4)) {
    p.line("want pressure 2 %  edges 2 %  forces 2 %");
    p.line("want stress ground " + p.xy(p.dice.between(left, 1), -layer - p.dice.between(0.2, 0.7)) + " 2 %");
    if (hole) p.line("want hoop ground.bore 2 %");
  }
  p.line("tolerance 2 %");
}

void indenter_scene(Pen& p) {
  const bool layered = p.dice.chance(0.2), bonded = p.dice.chance(0.5) || p.friction == 0;
  const double thickness = layered ? p.dice.between(0.15, 1) : 0;
  const bool hole = draw_ground(p, thickness, !layered && p.dice.chance(0.2));
  if (layered) draw_layer(p, thickness);
  const Indenter shape = draw_indenter(p);
  if (layered) {
    p.tell(bonded ? "bonded layer" : "loose layer");
    p.line((bonded ? "tie " : "contact ") + std::string("ground.top layer.under") + (bonded ? "" : p.mu()));
    p.line("contact layer.top pad.face" + p.mu());
  } else {
    p.line("contact ground.top pad.face" + p.mu());
  }
  if (!p.rigid[0]) p.line("fix ground.bottom");
  p.line("case normal");
  const std::string moved = (p.rigid[1] ? "drive pad about " : "platen pad.top about ") + p.xy(0, shape.height);
  (p.dice.chance(0.25) ? load_by_motion : load_by_force)(p, shape, moved, press(p, shape));
  draw_wants(p, thickness, hole);
}

// Half of an indenter on half of a block.
void half_scene(Pen& p) {
  const double W = p.dice.between(3, 8), H = p.dice.between(3, 8), T = p.dice.between(1.2, 3);
  p.tell("half drawn");
  p.line("symmetry x 0");
  p.line("body ground" + p.material(0));
  p.line("  from " + p.xy(0, -H));
  p.line("  line bottom to " + p.xy(W, -H));
  p.line("  line side to " + p.xy(W, 0));
  p.line("  line top to " + p.xy(0, 0));
  p.line("body pad" + p.material(1));
  p.line("  from " + p.xy(0, 0));
  Indenter shape;
  const bool flat = p.dice.chance(0.4);
  const double b = flat ? p.dice.between(0.2, 0.7) : 0;
  const double R = shape.radius = p.dice.power(0.1, 1.3), rise = chord_rise(R, 1 - b);
  if (flat) p.line("  line face to " + p.xy(b, 0)), shape.radius = 0;
  p.tell(flat ? "flat rounded" : "round");
  p.line("  arc  face to " + p.xy(1, rise) + " centre " + p.xy(b, R));
  p.line("  line side to " + p.xy(1, T));
  p.line("  line top to " + p.xy(0, T));
  p.line("contact ground.top pad.face" + p.mu());
  const double P = press(p, shape);
  p.line("case normal");
  p.line("  fix ground.bottom");
  p.line(p.dice.chance(0.5) ? "  traction pad.top y " + Pen::number(-P / 2) : "  pressure pad.top " + Pen::number(P / 2));
  write_history(p, false);
  draw_wants(p, 0, false, 0.1);
}

// Half of a pin in a hole, with clearance.
void pin_scene(Pen& p) {
  const double c = p.dice.power(-4, -1.5), L = p.dice.between(2, 8);
  p.tell("pin in a hole");
  p.line("symmetry x 0");
  p.line("body ground" + p.material(0));
  p.line("  from " + p.xy(0, -L));
  p.line("  line rim to " + p.xy(L, -L));
  p.line("  line side to " + p.xy(L, L));
  p.line("  line far to " + p.xy(0, L));
  p.line("  outline");
  p.line("  from " + p.xy(0, 1));
  p.line("  arc bore to " + p.xy(0, -1) + " centre " + p.xy(0, 0) + " right");
  p.line("body pin" + p.material(1));
  p.line("  from " + p.xy(0, -1));
  p.line("  arc face to " + p.xy(0, 1 - 2 * c) + " centre " + p.xy(0, -c));
  p.line("contact ground.bore pin.face" + p.mu());
  p.line("fix ground.rim");
  p.line("force pin at " + p.xy(0, -c) + " y " + p.force(-p.dice.power(-1, 1) * c * p.modulus()));
  p.line("steps " + std::to_string(p.dice.whole(1, 4)));
  p.line("tolerance 2 %");
}

// A quarter of a shaft pressed into a hub; then the hub is loaded.
void press_scene(Pen& p) {
  const double bore = p.dice.between(0.2, 0.7), outside = p.dice.between(1.4, 3), fit = p.dice.power(-4, -2.3);
  p.tell("press fit");
  p.line("symmetry x 0");
  p.line("symmetry y 0");
  p.line("body ground" + p.material(0));
  p.line("  from " + p.xy(outside, 0));
  p.line("  arc rim centre 0 0 turn 90");
  p.line("  outline");
  p.line("  from " + p.xy(0, 1));
  p.line("  arc seat centre 0 0 turn -90");
  p.line("body shaft" + p.material(1));
  p.line("  from " + p.xy(1 + fit, 0));
  p.line("  arc face centre 0 0 turn 90");
  p.line("  outline");
  p.line("  from " + p.xy(0, bore));
  p.line("  arc bore centre 0 0 turn -90");
  p.line("contact ground.seat shaft.face" + p.mu());
  p.line("interference");
  if (p.dice.chance(0.5)) p.line("pressure ground.rim " + Pen::number(0.5 * fit * p.modulus()));
  p.line("steps " + std::to_string(p.dice.whole(1, 3)));
  p.line("tolerance 2 %");
}

// A plate cut along a line and bonded beside the cut, bent and pressed so that the cut is closed in part.
void crack_scene(Pen& p) {
  const double W = p.dice.between(4, 9), H = p.dice.between(4, 9), s = p.stress * p.dice.power(-4, -2.5);
  p.tell("crack");
  const std::string same = p.material(0);
  p.line("body lower" + same);
  p.line("  from " + p.xy(-W, -H));
  p.line("  line foot to " + p.xy(W, -H));
  p.line("  line side to " + p.xy(W, 0));
  p.line("  line ahead to " + p.xy(1, 0));
  p.line("  line crack to " + p.xy(-1, 0));
  p.line("  line ahead to " + p.xy(-W, 0));
  p.line("  line side close");
  p.line("copy upper of lower mirror y 0");
  p.line("contact lower.crack upper.crack" + p.mu());
  p.line("tie lower.ahead upper.ahead");
  p.line("fix lower.foot");
  p.line("platen upper.foot about " + p.xy(0, H) + " fx " + p.force(W * s * p.dice.between(-0.3, 0.3)) + " fy " +
         p.force(-W * s * p.dice.between(0, 1)) + " moment " + p.moment(W * W * W * s * p.dice.between(-0.5, 0.5)));
  p.line("steps " + std::to_string(p.dice.whole(1, 3)));
  p.line("tolerance 2 %");
}

// ---- cycles that are repeated until they are steady -------------------------------------------------------------------

// `shears`: there is a case of it.
void write_cycle(Pen& p, bool shears) {
  const std::string low = Pen::number(p.dice.between(0.3, 0.8));
  const int32_t kind = shears ? p.dice.whole(0, 2) : 3;
  const char* const words[] = {"shear to and fro", "pressed by turns beside shear", "round a square", "pressed by turns"};
  const std::string history[] = {"", "; shear " + low, "; shear " + low, ""};
  const std::string cycle[] = {"shear 1, -1, 1", "normal " + low + ", 1",
                               "normal " + low + "; shear -" + low + "; normal 1; shear " + low, "normal " + low + ", 1"};
  p.tell(words[kind]);
  p.line("history normal 1" + history[kind]);
  p.line("cycle " + cycle[kind] + " until steady");
  p.line("steps 1");
}

void want_cycle(Pen& p) {
  const std::string tolerance = " " + std::to_string(p.dice.whole(2, 10)) + " %";
  for (const char* number : {"walk", "loss", "slip"}) p.line(std::string("want ") + number + tolerance);
}

// An indenter on a ground; the force aside is below what friction holds.
void cycle_scene(Pen& p) {
  draw_ground(p, 0, p.dice.chance(0.2));
  const Indenter shape = draw_indenter(p);
  p.line("contact ground.top pad.face" + p.mu());
  if (!p.rigid[0]) p.line("fix ground.bottom");
  const std::string moved = (p.rigid[1] ? "drive pad about " : "platen pad.top about ") + p.xy(0, shape.height);
  const double P = press(p, shape);
  p.line("case normal");
  p.line("  " + moved + " fx 0 fy " + p.force(-P) + " turn 0");
  const bool shears = p.dice.chance(0.75);
  if (shears) p.line("case shear");
  if (shears) p.line("  " + moved + " fx " + p.force(p.dice.between(0.1, 0.85) * p.friction * P));
  write_cycle(p, shears);
  want_cycle(p);
}

// A ring in its housing, pressed outward, and a patch of pressure that goes round on its bore.
void creep_scene(Pen& p) {
  const double wall = p.dice.between(0.05, 0.2), outside = p.dice.between(1.25, 2), fit = p.stress * p.dice.power(-6, -4.5);
  p.tell("ring in its housing");
  const std::string housing = p.material(0);
  p.line("body ground" + housing);
  p.line("  circle rim centre 0 0 radius " + p.length(outside));
  p.line("  hole");
  p.line("  circle seat centre 0 0 radius " + p.length(1));
  p.line("body ring" + (p.dice.chance(0.5) ? housing : p.material(1)));
  p.line("  circle outer centre 0 0 radius " + p.length(1));
  p.line("  hole");
  p.line("  circle bore centre 0 0 radius " + p.length(1 - wall));
  p.line("contact ring.outer ground.seat" + p.mu());
  p.line("fix ground.rim");
  p.line("case fit");
  p.line("  pressure ring.bore " + Pen::number(fit));
  p.line("case roll round 0 0 positions " + std::to_string(4 * p.dice.whole(2, 3)));
  p.line("  pressure ring.bore {" + Pen::number(fit * p.dice.power(2, 3)) + "*max(0, cos(atan2(y, x)) - cos(" +
         std::to_string(p.dice.whole(20, 45)) + "*deg))}");
  p.line("history fit 1; roll 1");
  p.line("cycle roll to 1 until steady digits 3");
  p.line("steps 1");
  want_cycle(p);
}

// The x line of symmetry becomes the axis.
std::string revolved(const std::string& text) {
  std::string out;
  for (size_t at = 0, end; at < text.size(); at = end + 1) {
    end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    if (line.compare(0, 5, "plane") == 0) continue;
    out += (line == "symmetry x 0" ? "axisymmetric" : line) + "\n";
  }
  return out;
}

} // namespace

Drawn draw_revolved(uint64_t seed) {
  Drawn out;
  Pen p(seed, out);
  p.tell("of revolution");
  (p.dice.chance(0.75) ? half_scene : press_scene)(p);
  out.text = revolved(out.text);
  return out;
}

Drawn draw_cycles(uint64_t seed) {
  Drawn out;
  Pen p(seed, out);
  if (p.friction < 0.05 || p.friction > 0.9) p.friction = p.dice.between(0.05, 0.9);
  p.tell("a cycle with mu " + Pen::number(p.friction));
  (p.dice.chance(0.85) ? cycle_scene : creep_scene)(p);
  return out;
}

Drawn draw(uint64_t seed) {
  Drawn out;
  Pen p(seed, out);
  const double kind = p.dice.unit();
  (kind < 0.66   ? indenter_scene
   : kind < 0.78 ? half_scene
   : kind < 0.88 ? pin_scene
   : kind < 0.94 ? press_scene
                 : crack_scene)(p);
  return out;
}

} // namespace random_sketches
