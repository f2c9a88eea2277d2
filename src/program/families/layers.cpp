// A layer clamped to a smooth rigid base by a uniform pressure, and lifted or pressed by a line load.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

namespace families {
namespace {

ProblemModel build_layers(const Values& v, bool lifted) {
  const double h = v.number("h"), pe = v.number("pe"), E = v.number("E"), nu = v.number("nu");
  const double end = v.number("L") * h, fine = v.number("zone") * h, strip = v.number("strip") * h;
  const double ratio = v.number("ratio"), lambda = v.number("lambda");
  const double load = lambda * h * pe;
  if (end < fine + 2 * h) return unfit("L is below zone + 2");
  const int n = v.count("n");
  std::vector<double> zone = equal(fine, static_cast<int>(v.number("zone") * n + 0.5));
  const std::vector<double> rest = graded(end - fine, last_size(zone), 0, ratio, h / 2);
  for (size_t i = 1; i < rest.size(); ++i) zone.push_back(fine + rest[i]);

  ProblemModel m;
  m.heading = {"A layer (body 2) on a smooth rigid base (body 1), clamped by a pressure pe on its top",
               std::string(lifted ? "and lifted" : "and pressed") + " by a line load P = lambda h pe at x = 0.",
               "Half of it is modelled; h = " + show(h) + ", pe = " + show(pe) + ", lambda = " + show(lambda),
               lifted ? "Above lambda = 1.0876 the middle |x| < a is clear of the base."
                      : "Above lambda = 44.14 the layer is clear of the base in b < |x| < c.",
               "Reference: singular integral equation; L. M. Keer and M. A. G. Silva, 1972; M. B. Civelek and",
               "F. Erdogan, 1975. The line load is a strip of half width " + show(strip)};
  m.title = lifted ? "LAYER CLAMPED AND LIFTED" : "LAYER CLAMPED AND PRESSED";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  const double on_strip = (lifted ? load : -load) / (2 * strip) - pe;
  Outline layer({0, 0});
  layer.line({end, 0}, zone);
  layer.line({end, h}, equal(h, 3));
  layer.line({strip, h}, graded(end - strip, 0, strip / 2, ratio, h / 3), traction(0, -pe));
  layer.line({0, h}, equal(strip, 2), traction(0, on_strip));
  layer.axis_x({0, 0}, graded(h, strip / 2, first_size(zone), ratio, h / 8));
  Outline base({0, -h});
  base.line({end + h, -h}, graded(end + h, 0, 0, ratio, h), roller_y());
  base.line({end + h, 0}, equal(h, 2));
  base.line({end, 0}, equal(h, 2));
  base.line({0, 0}, reversed(zone));
  base.axis_x({0, -h}, graded(h, first_size(zone), 0, ratio, h / 2));
  m.bodies = {{E * v.number("rigid"), nu, {0, 0}, {base}, "the base"}, {E, nu, {0, 0}, {layer}, "the layer"}};
  m.zones = {contact(3, 0)};
  return m;
}

std::vector<Parameter> parameters(const char* lambda, const char* limit) {
  return {{"lambda", Kind::kPositive, lambda, limit},
          {"h", Kind::kPositive, "1", "thickness of the layer"},
          {"pe", Kind::kPositive, "1", "clamping pressure"},
          {"E", Kind::kPositive, "1000", "Young's modulus of the layer"},
          {"nu", Kind::kPoisson, "0.3", "its Poisson's ratio"},
          {"rigid", Kind::kPositive, "1e6", "stiffness of the base over that of the layer"},
          {"n", Kind::kCount, "20", "elements over h in the fine part of the contact zone"},
          {"zone", Kind::kPositive, "4", "length of that part, over h"},
          {"strip", Kind::kPositive, "0.01", "half width of the strip that the load acts on, over h"},
          {"L", Kind::kPositive, "12", "half length of the layer, over h"},
          {"ratio", Kind::kAboveOne, "1.3", "growth of the elements elsewhere"},
          {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
          {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}};
}

} // namespace

Family layer_lifted_family() {
  return {"layer_lifted", "a layer clamped to a smooth rigid base by pressure and lifted by a line load",
          parameters("2", "P / (h pe); the layer lifts above 1.0876"), [](const Values& v) { return build_layers(v, true); }};
}

Family layer_pressed_family() {
  return {"layer_pressed", "a layer clamped to a smooth rigid base by pressure and pressed by a line load",
          parameters("100", "P / (h pe); the layer lifts beside the load above 44.14"),
          [](const Values& v) { return build_layers(v, false); }};
}

} // namespace families
