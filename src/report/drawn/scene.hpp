// The data of all pictures, collected once from the solver through the C interface.
#pragma once

#include "post/summary.hpp"
#include "report/drawn/svg.hpp"
#include "report/history.hpp"
#include "report/record.hpp"

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

// A point of the drawn outline: where it lies on which element.
struct OutlinePoint {
  int32_t element; // from 1
  double eta;      // -1 ... 1
  Point at, moved; // displacement added, not magnified: at + (moved - at) is the deformed place
};
struct EndCondition {
  int32_t codes[4];
  std::vector<double> values[4]; // per load case
  bool known(int quantity) const { return codes[quantity] == 0; }
  double value(int quantity, size_t load_case) const { return known(quantity) ? values[quantity][load_case] : 0.0; }
};
struct BodyScene {
  std::vector<std::vector<OutlinePoint>> curves;
  std::vector<Point> corners;                      // where elements meet
  std::vector<Point> ends, displacement, traction; // per element end
  std::vector<Point> normals;                      // outward, per element end
  std::vector<int32_t> nodes, status;              // per element end
  std::vector<EndCondition> conditions;            // per element end
  std::vector<bool> on_line; // per element: it lies on a line of symmetry, is no boundary and has no results
  bool rigid = false;        // an obstacle
  bool platen = false;       // has no curves: it is drawn where it is tied
};
struct PairScene {
  int32_t zone;     // from 1
  Point on[2];      // its places on both sides
  double s;         // place along side 1, see ZoneScene
  bool symmetric;   // a displacement of its node is prescribed: a line of symmetry
  int image_line;   // 1 or 2: it lies on the line x = ... or y = ... of symmetry by images, 0: on none
  Point normal{};   // of side 1, outward
  Point moved[2]{}; // displacements of both sides at the last state
};
// A pair, or its image beyond a line of symmetry, where the direction t is reversed.
struct ZoneSample {
  size_t pair; // from 0
  double s, turn;
};
struct ZoneScene {
  size_t first = 0, pairs = 0;
  size_t origin = 0; // the pair where lengths begin: on a line of symmetry, or the zone's left or lower end
  const char* position =
      "s"; // what the pairs' s is called: "x" or "y" where it is that coordinate, as side 1 is nearly straight along it
  bool symmetric_origin = false;
  bool has_images = false;
  std::vector<ZoneSample> samples; // in the order of s; a zone that ends on a line of images goes on beyond it
  int32_t body[2] = {1, 2};        // of its sides
  bool tied = false;               // bonded: neither opens nor slips
  bool free = false;               // joins meshes that do not match: tn and tt are per length of side 2
};

// Loads of a case other than conditions of element ends.
struct PointLoad {
  int32_t body;
  Point at, force;
  size_t load_case; // from 0
};
struct BodyForce {
  int32_t body;
  size_t load_case;
  Point force;       // per area
  double rho_omega2; // of a rotation about `axis`
  Point axis;
};
struct RigidMotion {
  int32_t body;
  size_t load_case;
  Point by;
  double rotation;
  Point axis;
};
// On the free motions of a rigid body or platen, at the step of the path where it is largest; the moment is about `at`.
struct RigidLoad {
  int32_t body;
  Point at, force;
  double moment;
};

// The model itself (turn = 1, 1) or one of its images.
struct Image {
  Point turn, line;
  Point place(Point p) const { return {line.x + turn.x * (p.x - line.x), line.y + turn.y * (p.y - line.y)}; }
  Point direction(Point v) const { return {turn.x * v.x, turn.y * v.y}; }
};

struct Scene {
  c2d_solver* solver = nullptr;
  Summary summary;
  const RunRecord* record = nullptr;
  const History* history = nullptr;
  bool solved = false; // results at the last load are there
  std::vector<BodyScene> bodies;
  std::vector<PairScene> pairs;
  std::vector<ZoneScene> zones;
  size_t cases = 1;
  std::vector<PointLoad> point_loads;
  std::vector<BodyForce> body_forces;
  std::vector<RigidMotion> motions; // of rigid bodies, other than none
  std::vector<RigidLoad> rigid_loads;
  size_t interference = 0;                                     // the load case, from 1, that closes overlaps; 0: none
  std::vector<Image> images;                                   // the model first
  std::vector<Image> zone_images;                              // those of them that go on with any of the zones
  std::string length_unit, stress_unit, force_unit, work_unit; // escaped; empty if the user named none
  // Forces and energies are those of the whole circumference, not per thickness.
  bool is_revolved() const { return summary.plane == C2D_AXISYMMETRIC; }
  // What pictures are mirrored at.
  const char* mirror_name() const { return is_revolved() && summary.symmetry == 1 ? "axis" : "line of symmetry"; }
};

// Loads of all cases and the lines of symmetry (scene_loads.cpp); pairs and zones (scene_zones.cpp).
c2d_status gather_loads(Scene& scene);
c2d_status gather_zones(Scene& scene);
// Results only if the solver is running. Returns the status of the first query that failed.
c2d_status gather_scene(c2d_solver* solver, const RunRecord& record, const History& history, Scene& scene);

// Coefficient of friction of a zone (from 0) in a run (from 0): zones may have their own.
double friction_of(const Scene& scene, size_t coefficient, size_t zone);

// The model and those of its images that go on with a zone beyond lines of symmetry.
std::vector<Image> images_of(const Scene& scene, const ZoneScene& zone);

// 1 or 2: the point lies on the line x = ... or y = ... of symmetry by images, 0: on none.
int image_line_at(const Summary& summary, Point p);

// Outlines moved by `magnification` times the displacement.
Outlines outline_of(const BodyScene& body, double magnification);

// State of a zone from a table (C2D_PAIR_FIELDS per pair).
struct ZoneFacts {
  double peak = 0.0;    // largest tn
  size_t peak_pair = 0; // from 0
  int32_t touching = 0, sticking = 0, slipping = 0;
  double low = 0.0, high = 0.0;             // s of the outermost touching pairs
  double stick_low = 0.0, stick_high = 0.0; // of the outermost sticking pairs
  size_t stretches = 0;                     // of neighbouring pairs that stick
};
ZoneFacts find_facts(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table);
// "; sticking from s = 1 to 3", or in how many stretches between them. Something sticks.
std::string words_of_sticking(const Scene& scene, const ZoneScene& zone, const ZoneFacts& facts);

// Position on the load path of the last table of a coefficient: "load factor 1", and with several load cases or a
// load that also falls "step 5 (load factors 1, 0.5)".
std::string place_on_path(const Scene& scene, size_t coefficient);
// The same of the last coefficient, whose results the solver still has, with its name: "load factor 1, mu =
// 0.3".
std::string place_at_end(const Scene& scene);

// "1, 0.5, -1"
std::string list_of(const std::vector<double>& numbers);
// A number with `digits` significant digits; with a unit behind it if there is one.
std::string figure(double value, int digits = 4);
std::string figure(double value, const std::string& unit, int digits = 4);

} // namespace app
