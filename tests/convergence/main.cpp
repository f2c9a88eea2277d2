// make convergence: for every family, the error against the number of elements and the observed order.
#include "../callable.hpp"
#include "body_figures.hpp"
#include "sketches.hpp"

#include <cstdio>

using namespace families_test;

namespace {

struct Quantity {
  const char* name;
  test::Callable<double(const Solution&)> error;
};

// A row per mesh; the order is that between a row and the one before.
void table(const char* title, const char* family, const std::vector<std::string>& settings, const char* key,
           const std::vector<double>& values, const std::vector<Quantity>& quantities) {
  std::printf("\n%s: make %s", title, family);
  for (const std::string& s : settings) std::printf(" %s", s.c_str());
  std::printf("\n%8s %9s %7s", key, "elements", "pairs");
  for (const Quantity& q : quantities) std::printf("  %22s  order", q.name);
  std::printf("\n");
  std::vector<double> before(quantities.size(), 0.0);
  double value_before = 0;
  for (const double value : values) {
    std::vector<std::string> all = settings;
    all.push_back(setting(key, value));
    const Solution s = solve(family, all);
    std::printf("%8g %9d %7d", value, s.elements, s.steps.empty() ? 0 : static_cast<int>(s.last().size()));
    if (!s.error.empty()) {
      std::printf("  %s\n", s.error.c_str());
      continue;
    }
    for (size_t i = 0; i < quantities.size(); ++i) {
      const double error = std::fabs(quantities[i].error(s));
      std::printf("  %22.3e", error);
      if (value_before > 0 && error > 0 && before[i] > 0)
        std::printf("  %5.2f", std::log(before[i] / error) / std::log(value / value_before));
      else
        std::printf("  %5s", "");
      before[i] = error;
    }
    value_before = value;
    std::printf("\n");
  }
}

double centre(const Solution& s, double exact) { return s.last()[0].tn / exact - 1; }

// Mean square error of a curve up to `end`, over `scale`.
double curve(const Solution& s, const Table& t, size_t column, double scale, double end, bool friction, size_t x_column = 0) {
  Table by_x = t;
  for (std::vector<double>& row : by_x) row[0] = row[x_column];
  double sum = 0;
  int count = 0;
  for (const Row& row : s.last())
    if (row.x < end) {
      const double e = ((friction ? -row.tt : row.tn) / scale - at(by_x, row.x, column));
      sum += e * e;
      ++count;
    }
  return std::sqrt(sum / std::max(1, count));
}

const EndRow* end_at(const Solution& s, double x, double y) {
  for (const EndRow& end : s.ends)
    if (std::fabs(end.x - x) < 1e-9 && std::fabs(end.y - y) < 1e-9) return &end;
  return nullptr;
}

void contact_problems() {
  const double p0 = 1000 / (2 * 0.91) / 200; // of make hertz
  const auto hertz_curve = [p0](const Solution& s) {
    double worst = 0;
    for (const Row& row : s.last())
      worst = std::max(worst, std::fabs(row.tn / p0 - std::sqrt(std::max(0.0, 1 - row.x * row.x))));
    return worst;
  };
  table("Hertz", "hertz", {}, "n", {4, 8, 16, 32},
        {{"p(0)", [p0](const Solution& s) { return centre(s, p0); }},
         {"edge", [](const Solution& s) { return last_closed(s.last()) - 1; }},
         {"p, largest", hertz_curve}});
  table("Receding layer, equal stiffness", "receding_layer", {}, "n", {5, 10, 20, 40},
        {{"p(0)", [](const Solution& s) { return centre(s, 0.7130805511737414); }},
         {"edge", [](const Solution& s) { return last_closed(s.last()) - 1.3241653718676933; }},
         {"p, mean square", [](const Solution& s) { return curve(s, reference("p02_p_equal"), 2, 1, 1.2, false); }}});
  table("Layer lifted", "layer_lifted", {}, "n", {5, 10, 20, 40},
        {{"gap(0)", [](const Solution& s) { return s.last()[0].gap / (2 * 0.91 / 1e4) / 0.6533972762806306 - 1; }},
         {"edge", [](const Solution& s) { return last_with(s.last(), C2D_OPEN) - 0.9518250994943219; }},
         {"largest p", [](const Solution& s) { return largest_pressure(s.last()) / 1.0816857184683064 - 1; }}});
  table("Layer pressed", "layer_pressed", {}, "n", {5, 10, 20, 40},
        {{"p(0)", [](const Solution& s) { return centre(s, 93.07800764228236); }},
         {"inner edge", [](const Solution& s) { return first_with(s.last(), C2D_OPEN) - 1.228462713443854; }},
         {"outer edge", [](const Solution& s) { return last_with(s.last(), C2D_OPEN) - 3.139877067800519; }}});
  for (const char* order : {"order=1", "order=2"})
    table("Disc in a hole", "disc_in_hole", {order}, "n", {15, 30, 60, 120},
          {{"p at the pole", [](const Solution& s) { return centre(s, 0.6090826758968362); }},
           {"angle, degrees",
            [](const Solution& s) { return std::asin(last_closed(s.last())) * 180 / kPi - 19.62506010432921; }}});
}

void friction_problems() {
  table("Spence's punch", "punch", {}, "n", {10, 20, 40},
        {{"p(0)", [](const Solution& s) { return centre(s, 0.33151417068531397); }},
         {"stick boundary", [](const Solution& s) { return last_with(s.last(), C2D_STICK) - 0.7; }},
         {"q a/P, mean square",
          [](const Solution& s) { return curve(s, reference("p04_spence_pq_turner"), 2, 1, 0.65, true); }}});
  table(
      "Turner's unloading", "punch", {"unload=0.45"}, "n", {10, 20, 40},
      {{"x1", [](const Solution& s) { return first_with(s.last(), C2D_SLIP) - 0.5486995057134002; }},
       {"x2",
        [](const Solution& s) { return first_with(s.last(), C2D_STICK, first_with(s.last(), C2D_SLIP)) - 0.9589479775660557; }},
       {"q a/P, mean square", [](const Solution& s) { return curve(s, reference("p05_pq"), 6, 1, 0.9, true); }}});
  const double p00 = 1000 / 0.91 / 200; // of make cylinder_friction
  table("Cylinder with friction", "cylinder_friction", {}, "n", {10, 20, 40},
        {{"p(0)", [p00](const Solution& s) { return centre(s, p00 * 1.0782404462398982); }},
         {"stick boundary",
          [](const Solution& s) { return last_with(s.last(), C2D_STICK) - 0.864481667647117 * 0.9728971709260842; }},
         {"q/p0, mean square",
          [p00](const Solution& s) { return curve(s, reference("p06_pq_mu0.4_nu0.3"), 5, p00, 0.9, true, 3); }}});
  table("Cylinder with adhesion", "cylinder_friction", {"mu=inf"}, "n", {10, 20, 40},
        {{"p(0)", [p00](const Solution& s) { return centre(s, p00 * 1.0773110514492); }},
         {"q/p0, mean square",
          [p00](const Solution& s) { return curve(s, reference("p06_pq_adh_nu0.3"), 5, p00, 0.9, true, 3); }}});
  table("Rectangle between rough plates", "rough_plates", {"mu=0.2"}, "n", {10, 20, 40, 80},
        {{"stick boundary", [](const Solution& s) { return last_with(s.last(), C2D_STICK) - 0.4386065376; }}});
  table("Mindlin, loop", "mindlin", {}, "n", {10, 20, 40},
        {{"energy of a loop", [](const Solution& s) {
            const double muP = 0.3 * kPi / (4 * 200 * 2 * 0.91 / 1000);
            const auto force = [&](size_t step) {
              const std::vector<Row>& r = s.steps[step].rows;
              double sum = 0;
              for (size_t i = 0; i + 1 < r.size(); ++i) sum += (r[i].tt + r[i + 1].tt) / 2 * (r[i + 1].x - r[i].x);
              return sum / muP;
            };
            const double k = 1 - std::fabs(force(4) - force(12)) / 2;
            const double exact = 4 / kPi * muP * muP * (2 * 0.91 / 1000) * (k * std::log(k) + 1 - k - (1 - k) * (1 - k) / 2);
            return (s.steps[20].dissipated - s.steps[4].dissipated) / exact - 1;
          }}});
}

void single_bodies() {
  for (const char* order : {"order=1", "order=2", "order=3"}) {
    table("Ring", "ring", {order}, "n", {4, 8, 16},
          {{"ur(a)", [](const Solution& s) { return end_at(s, 1, 0)->ux / 1.9066666666666665e-3 - 1; }},
           {"ur(b)", [](const Solution& s) { return end_at(s, 2, 0)->ux / 1.2133333333333334e-3 - 1; }}});
    table("Hole", "hole", {order}, "n", {6, 12, 24},
          {{"ux(R, 0)", [](const Solution& s) { return end_at(s, 1, 0)->ux / 2.73e-3 - 1; }},
           {"uy(0, R)", [](const Solution& s) { return end_at(s, 0, 1)->uy / -0.91e-3 - 1; }}});
    table("Cantilever", "cantilever", {order}, "n", {2, 4, 8},
          {{"end displacement", [](const Solution& s) { return end_at(s, 0, -1)->uy / 0.23296 - 1; }}});
  }
}

void several_bodies() {
  for (const char* order : {"order=1", "order=2"})
    table("Stack of plates", "stack", {order}, "n", {3, 5, 9},
          {{"stress", [](const Solution& s) { return uniform_error(s, 1, 0.2); }}});
  const auto rollers = [](const char* title, const char* family, const std::vector<std::string>& settings,
                          const std::vector<double>& middles, double p0) {
    table(title, family, settings, "n", {4, 8, 16, 32},
          {{"p0, worst contact", [=](const Solution& s) { return worst_of_rollers(s, middles, p0).peak; }},
           {"edge, worst contact", [=](const Solution& s) { return worst_of_rollers(s, middles, p0).edge; }},
           {"p, worst contact", [=](const Solution& s) { return worst_of_rollers(s, middles, p0).curve; }}});
  };
  rollers("Three rollers between rigid platens", "rollers", {}, {0, 250}, 1000 / 0.91 / 200);
  rollers("Roller between half planes", "roller_between", {}, {0}, 1000 / 1.82 / 200);
  rollers("Roller between cylinders", "roller_between", {"platens=cylinders"}, {0}, 1000 / 1.82 / 100);
  for (const char* place : {"place=under", "place=between"})
    table("Bearing without clearance, rigid rings", "bearing", {place}, "n", {4, 8, 16, 32},
          {{"share of the load",
            [=](const Solution& s) { return bearing_figures(s, 12, std::string(place) == "place=between").share; }}});
  table("Bearing without clearance, ever stiffer rings", "bearing", {"rings=elastic"}, "E1", {1000, 4000, 16000, 64000},
        {{"share, of rigid rings", [](const Solution& s) { return bearing_figures(s, 12).share; }},
         {"most, of 4.08 P/Z", [](const Solution& s) { return bearing_figures(s, 12).factor / 4.08 - 1; }}});
  for (const char* bond : {"bond=matching", "bond=free"}) {
    const auto hertz = [](const Solution& s) { return hertz_figures(s.zone(1), 0, 1, 1000 / 1.82 / 200); };
    table("Layer of the same material", "coating", {"E2=1000", bond}, "n", {10, 20, 40},
          {{"p0", [=](const Solution& s) { return hertz(s).peak; }},
           {"edge", [=](const Solution& s) { return hertz(s).edge; }},
           {"p, largest", [=](const Solution& s) { return hertz(s).curve; }}});
    table("Bonded strips", "bimaterial", {bond}, "n", {4, 8, 16},
          {{"deflection", [](const Solution& s) { return bending_errors(s).deflection; }},
           {"stress, largest", [](const Solution& s) { return bending_errors(s).stress; }}});
    table("Ring on a bonded bush", "shrink", {bond}, "n", {6, 12, 24},
          {{"pressure of the fit", [](const Solution& s) { return shrink_errors(s).fit; }},
           {"pressure of the bond", [](const Solution& s) { return shrink_errors(s).bond; }}});
  }
}

// Stress intensity over sqrt(pi a), or where faces open that bending closes on the left.
double intensity(const Solution& s) { return s.cracks.front().K1 / std::sqrt(kPi); }

void cracks() {
  for (const char* order : {"order=1", "order=2"}) {
    table("Crack in the middle, half of the width", "crack", {order}, "n", {100, 200, 400},
          {{"K1, tension", [](const Solution& s) { return intensity(s) / crack_factors(0.5).centre - 1; }}});
    table("Edge crack, half of the width", "crack_edge", {order}, "n", {100, 200, 400},
          {{"K1, tension", [](const Solution& s) { return intensity(s) / crack_factors(0.5).edge - 1; }}});
    table("Edge crack, half of the width", "crack_edge", {order, "tension=0", "bending=1"}, "n", {100, 200, 400},
          {{"K1, bending", [](const Solution& s) { return intensity(s) / crack_factors(0.5).bending - 1; }}});
    table("Crack in a wide plate, closed in part", "crack", {order, "W=40", "tension=0", "bending=40"}, "n", {100, 200, 400},
          {{"K1 at the open tip", [](const Solution& s) { return intensity(s) / std::sqrt(8.0 / 27) - 1; }},
           {"closed length", [](const Solution& s) { return (opens_at(s.zone(1)) + 1) / (2.0 / 3) - 1; }}});
    table("Crack in a wide plate, sheared", "crack", {order, "W=40", "shear=1"}, "n", {100, 200, 400},
          {{"K2", [](const Solution& s) { return s.cracks.front().K2 / std::sqrt(kPi) - 1; }}});
  }
}

} // namespace

int main() {
  std::printf("Errors are relative, those of edges and boundaries in units of the problem: a node at most.\n");
  contact_problems();
  friction_problems();
  single_bodies();
  several_bodies();
  cracks();
  sketches();
  return 0;
}
