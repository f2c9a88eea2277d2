// The pictures of a run, in the order of the page. Each is drawn by a file of its own.
#pragma once

#include "report/drawn/axes.hpp"
#include "report/drawn/scene.hpp"

#include <string>
#include <vector>

namespace app {

struct Picture {
  std::string name;    // file name without .svg, begins its ids
  std::string title;   // may contain entities, as all text here
  std::string caption; // one or two sentences with the key numbers
  std::string svg;     // the whole file
};
using Pictures = std::vector<Picture>;

constexpr double kPictureWidth = 480.0; // legible on a telephone, two side by side on a desk
// Coefficients of friction and zones that get charts of their own; the rest is left to the CSV.
constexpr size_t kMostCharts = 16;

// Pressure and friction on the deformed bodies, zoomed to the contact, per zone.
void draw_contact(const Scene& scene, Pictures& out);
// All bodies, nodes, supports, loads, pairs; beside it what is in contact.
void draw_model(const Scene& scene, Pictures& out);
// At an edge the pressure may be unbounded: the size at which an axis of tn or tt (`column`) ends above the rest of the zone
// (all of the zone but 3 % of its length, if this stays below a sixth of the largest), else infinity.
double axis_limit(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table, size_t column);
// Pressure and friction along a zone with the Coulomb bounds, per coefficient and zone.
void draw_tractions(const Scene& scene, Pictures& out);
// Open, stick and slip over position and load, per coefficient and zone.
void draw_status_map(const Scene& scene, Pictures& out);
// Friction force over displacement where the loads turn, per coefficient and zone; the last whole cycle and its area.
void draw_loop(const Scene& scene, Pictures& out);
// Of a cycle that is repeated until it is steady, per coefficient: its numbers over the cycles, and over the steps of the
// recorded one; per zone friction over slip of a pair, and the statuses of all.
void draw_cycles(const Scene& scene, Pictures& out);
void draw_cycle_loop(const Scene& scene, Pictures& out);
void draw_cycle_status(const Scene& scene, Pictures& out);
// Gap and slip along a zone, per coefficient and zone.
void draw_gap(const Scene& scene, Pictures& out);
// The deformed shape over the undeformed one.
void draw_deformed(const Scene& scene, Pictures& out);
// Stress along the boundaries of bodies without contact: hoop stress over arc length.
c2d_status draw_boundary_stress(const Scene& scene, Pictures& out);
// Changes of status, peak pressure and pairs in contact against the load.
void draw_path(const Scene& scene, Pictures& out);
// Loads and supports against contact forces of each body.
void draw_balance(const Scene& scene, Pictures& out);
// Work, elastic energy and dissipation against the load; nothing if the library has no energies.
void draw_energy(const Scene& scene, Pictures& out);
// Filled contours of the stress inside the bodies, on grids of their own. Fails as c2d_interior does.
c2d_status draw_stress(const Scene& scene, Pictures& out);

// Fatigue parameters that a sketch requests along curves; nothing without them.
void draw_fatigue(const Scene& scene, Pictures& out);
// Shares of parameters with tolerances in the wanted numbers, as bars; nothing without tolerances.
void draw_tolerances(const Scene& scene, Pictures& out);
// The first and the last of the meshes that were tried for a sketch, whole and at the contact, and how numbers converged over
// all; nothing if there was one alone.
void draw_meshes(const Scene& scene, Pictures& out);
void draw_convergence(const Scene& scene, Pictures& out);

// All of them. Fails only if the solver cannot return results.
c2d_status draw_pictures(const Scene& scene, Pictures& out);

// Calls `draw` for every zone with results of the first coefficients, up to kMostCharts times.
void draw_charts(const Scene& scene, size_t coefficients,
                 void (*draw)(const Scene& scene, size_t coefficient, size_t zone, Pictures& out), Pictures& out);

// ", mu = 0.3" except of a tie, and, if there are several zones, ", zone 2"; with its bodies where these are named.
std::string chart_title(const Scene& scene, double mu, size_t zone);
// "_1" and "_1_2": coefficient and zone, numbers only if there are several.
std::string chart_suffix(const Scene& scene, size_t coefficient, size_t zone);
// How a status is marked everywhere: stick a full circle, slip a triangle, open a cross, tied a square.
Mark status_mark(int status);
std::vector<LegendEntry> status_legend(bool tied); // of a zone
// How a status is filled where it is a strip: open white, stick blue, slip hatched.
struct StatusFills {
  std::string of[3];
};
StatusFills status_fills(Svg& svg);
std::vector<LegendEntry> fills_legend(const StatusFills& fills);
// Borders of the columns of a zone's samples: half way to their neighbours.
std::vector<double> borders_of(const ZoneScene& zone);
// A strip from `top` to `bottom`, filled by the status of each pair.
void draw_status_row(Svg& svg, const Chart& chart, const ZoneScene& zone, const std::vector<double>& border,
                     const std::string& status, double top, double bottom, const StatusFills& fills);
bool is_tied(const CoefficientRecord& record, const ZoneScene& zone);
// The pairs of contact and of ties, without those of platens, which are as long as the end of a body that they move.
bool is_of_contact(const Scene& scene, const PairScene& pair);
bool has_contact(const Scene& scene);
// What s means, for axes.
std::string position_name(const Scene& scene, const ZoneScene& zone);
// The axis of all charts along a zone.
Axis position_axis(const Scene& scene, const ZoneScene& zone);
// "contact pressure tn", "friction tt"; of a tie "normal stress tn", "shear stress tt".
std::string traction_name(const ZoneScene& zone, bool normal);
// "(0, 1.5) mm": a place, where coordinates that are round-off beside the size of the model are 0.
std::string place_text(const Scene& scene, Point p, double size);
// Larger side of the box around all bodies.
double size_of(const Scene& scene);
// Sum of the sizes of all tractions on all boundaries: beside it a resultant is round-off or not.
double sum_of_forces(const Scene& scene);
// "body 2 on body 3".
std::string bodies_of(const Scene& scene, const ZoneScene& zone);
// "body 2 (bolt)", "zone 1 (thread)", ready for markup; the zone from 0.
std::string body_label(const Scene& scene, int64_t body);
std::string zone_label(const Scene& scene, size_t zone);
// "zone", with several zones of named bodies "zones".
std::string contact_zones(const Scene& scene);

// How a body is drawn: fills differ in lightness, edges in dash, too; every sixth body looks alike.
struct BodyStyle {
  const char* fill;
  const char* hatch; // over the fill of a rigid body
  const char* edge;
  const char* dash;
};
const BodyStyle& style_of(size_t body);

} // namespace app
