// A layer on a half plane under a line load: contact recedes to a width that the load does not change.
#include "program/families/family.hpp"
#include "program/families/shapes.hpp"

namespace families {
namespace {

ProblemModel build_receding_layer(const Values& v) {
  const double h = v.number("h"), load = v.number("P"), size = v.number("L") * h;
  const double width = v.number("zone") * h, end = width + h, strip = v.number("strip") * h;
  const double ratio = v.number("ratio");
  if (size < 2 * end) return unfit("L is below twice the length of the layer, zone + 1");
  const int n = v.count("n");
  const int elements = static_cast<int>(v.number("zone") * n + 0.5);
  if (elements < 1) return unfit("zone is below one element, 1 / n");
  if (strip > 0.5 * h) return unfit("strip is above 0.5: no line load");
  const std::vector<double> zone = equal(width, elements);

  ProblemModel m;
  m.heading = {"A layer (body 2) on a half plane (body 1) under a line load P, smooth, without weight.",
               "Half of it is modelled; the half plane is a block of half width L h.",
               "h = " + show(h) + ", P = " + show(load) + ", E of layer over half plane " +
                   show(v.number("E2") / v.number("E1")),
               "The ends lift at once: a/h does not depend on P. The line load is a strip of half width " + show(strip),
               "Reference: singular integral equation; L. M. Keer, J. Dundurs, K. C. Tsai, 1972"};
  m.title = "RECEDING LAYER UNDER A LINE LOAD";
  m.function_nodes = v.count("order") + 1;
  m.images = v.word("symmetry") == "images";
  Outline layer({0, 0});
  layer.line({width, 0}, zone);
  layer.line({end, 0}, graded(end - width, last_size(zone), 0, ratio, h / 4));
  layer.line({end, h}, equal(h, 4));
  layer.line({strip, h}, graded(end - strip, 0, strip / 2, ratio, h / 4));
  layer.line({0, h}, equal(strip, 2), traction(0, -load / (2 * strip)));
  layer.axis_x({0, 0}, graded(h, strip / 2, first_size(zone), ratio, h / 8));
  m.bodies = {{v.number("E1"), v.number("nu1"), {0, 0}, {half_block({zone, size, ratio})}, "the half plane"},
              {v.number("E2"), v.number("nu2"), {0, 0}, {layer}, "the layer"}};
  m.zones = {contact(3, 0)};
  return m;
}

} // namespace

Family receding_layer_family() {
  return {"receding_layer",
          "a layer on a half plane under a line load, smooth",
          {{"h", Kind::kPositive, "1", "thickness of the layer"},
           {"P", Kind::kPositive, "1", "line load per unit thickness"},
           {"E1", Kind::kPositive, "1000", "Young's modulus of the half plane"},
           {"nu1", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"E2", Kind::kPositive, "1000", "Young's modulus of the layer"},
           {"nu2", Kind::kPoisson, "0.3", "its Poisson's ratio"},
           {"n", Kind::kCount, "20", "elements over h in the contact zone"},
           {"zone", Kind::kPositive, "2.5", "half width of the contact zone, over h; the contact must be narrower"},
           {"strip", Kind::kPositive, "0.01", "half width of the strip that the load acts on, over h"},
           {"L", Kind::kPositive, "100", "half width and depth of the block, over h"},
           {"ratio", Kind::kAboveOne, "1.3", "growth of the elements away from the zone"},
           {"order", Kind::kOrder, "2", "of the functions: 1 linear, 2 quadratic, 3 cubic"},
           {"symmetry", Kind::kChoice, "images", "images|line: how lines of symmetry are treated, by images or elements"}},
          build_receding_layer};
}

} // namespace families
