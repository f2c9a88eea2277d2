// All that the pictures show, gathered once from the solver through the C interface.
#pragma once

#include "report/history.hpp"
#include "report/record.hpp"
#include "report/svg.hpp"

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
  double values[4];
};
struct BodyScene {
  std::vector<std::vector<OutlinePoint>> curves;
  std::vector<Point> corners;                      // where elements meet
  std::vector<Point> ends, displacement, traction; // per element end
  std::vector<Point> normals;                      // outward, per element end
  std::vector<int32_t> nodes, status;              // per element end
  std::vector<EndCondition> conditions;            // per element end
};
struct PairScene {
  int32_t zone;   // from 1
  Point on[2];    // the nodes of body 1 and body 2
  double s;       // along body 1, see ZoneScene
  bool symmetric; // a displacement of its node is prescribed: a line of symmetry
};
struct ZoneScene {
  size_t first = 0, pairs = 0;
  size_t origin = 0; // the pair where s = 0: on a line of symmetry, or the zone's left or lower end
  bool symmetric_origin = false;
};
struct PointLoad {
  int32_t body;
  Point at, force;
};

struct Scene {
  c2d_solver* solver = nullptr;
  c2d_summary summary = C2D_INIT(c2d_summary);
  const RunRecord* record = nullptr;
  const History* history = nullptr;
  bool solved = false; // results at the last load are there
  std::vector<BodyScene> bodies;
  std::vector<PairScene> pairs;
  std::vector<ZoneScene> zones;
  std::vector<PointLoad> point_loads;
  std::string length_unit, stress_unit, force_unit, work_unit; // escaped; empty if the user named none
};

// Results only if the solver is running. Returns the status of the first query that failed.
c2d_status gather_scene(c2d_solver* solver, const RunRecord& record, const History& history, Scene& scene);

// Coefficient of friction of a zone (from 0) in a run (from 0): zones may have their own.
double friction_of(const Scene& scene, size_t coefficient, size_t zone);

// Outlines moved by `magnification` times the displacement.
std::vector<std::vector<Point>> outline_of(const BodyScene& body, double magnification);

// What a table (C2D_PAIR_FIELDS per pair) says of a zone.
struct ZoneFacts {
  double peak = 0.0;    // largest tn
  size_t peak_pair = 0; // from 0
  int32_t touching = 0, sticking = 0, slipping = 0;
  double low = 0.0, high = 0.0;             // s of the outermost touching pairs
  double stick_low = 0.0, stick_high = 0.0; // of the outermost sticking pairs
};
ZoneFacts find_facts(const Scene& scene, const ZoneScene& zone, const std::vector<double>& table);

// A number with `digits` significant digits; with a unit behind it if there is one.
std::string figure(double value, int digits = 4);
std::string figure(double value, const std::string& unit, int digits = 4);

} // namespace app
