#pragma once
// A model over plain vectors, put together by a few calls whose numbers start at 1, like those of the cards.
#include "contact/pairs/frames.hpp"
#include "model/geometry.hpp"
#include "model/model.hpp"
#include "model/rigid.hpp"
#include "model/unknowns.hpp"
#include "model/validate/validate.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace fixture {

using Points = std::vector<double>; // x1, y1, x2, y2, ...

template <class T> using PerBody = std::vector<std::vector<T>>;

struct ModelData {
  c2d::ModelHeader head = {};
  std::vector<c2d::Body> bodies;
  PerBody<double> xy, end_traction, node_disp, load_work;
  PerBody<int32_t> node_line, end_line, node_column;
  PerBody<uint8_t> end_code;
  PerBody<c2d::Region> regions;
  PerBody<c2d::BodyForce> body_forces;
  PerBody<c2d::RigidMotion> rigid_motions;
  std::vector<double> friction;
  std::vector<c2d::Zone> zones;
  std::vector<c2d::Pair> pairs;
  std::vector<c2d::PointLoad> point_loads;
  std::vector<c2d::Curve> surfaces;
  std::vector<c2d::SlipGap> slip_gaps;
  std::vector<c2d::Path> paths;
  std::vector<c2d_error> told;
  int32_t faults = 0;

  explicit ModelData(int32_t function_nodes) {
    head.function_nodes = function_nodes;
    head.load_cases = 1;
    head.plane = C2D_PLANE_STRAIN;
    head.iteration_limit = 50;
    head.analysis = C2D_ANALYSIS_CONTACT;
    friction = {0.3};
    paths = {{1, 0, 1.0}};
  }

  // One more body of closed curves through these points; the last element of each ends at its first point.
  void body(int element_nodes, const std::vector<Points>& curves, double e = 1000, double nu = 0.3) {
    const size_t b = bodies.size();
    bodies.emplace_back();
    head.bodies = static_cast<int32_t>(bodies.size());
    each_array([](auto& array) { array.emplace_back(); });
    c2d::Body& body = bodies[b];
    body.element_nodes = element_nodes;
    body.is_set = 1;
    body.youngs_modulus = e;
    body.poisson_ratio = nu;
    for (const Points& curve : curves) {
      const int32_t elements = static_cast<int32_t>(curve.size()) / 2 / (element_nodes - 1);
      regions[b].push_back({body.elements, body.elements + elements - 1});
      body.elements += elements;
      xy[b].insert(xy[b].end(), curve.begin(), curve.end());
    }
    body.regions = body.region_count = static_cast<int32_t>(curves.size());
    body.geometry_nodes = static_cast<int32_t>(xy[b].size() / 2);
    const int32_t f = head.function_nodes;
    body.nodes = f == 1 ? body.elements : body.elements * (f - 1);
    const size_t ends = static_cast<size_t>(body.elements * f), nodes = static_cast<size_t>(body.nodes);
    node_line[b].assign(xy[b].size() / 2, 0);
    end_traction[b].assign(2 * ends, 0);
    node_disp[b].assign(2 * nodes, 0);
    end_code[b].assign(ends, 0);
    end_line[b].assign(ends, 0);
    node_column[b].assign(nodes + 1, 0);
    body_forces[b].assign(1, c2d::BodyForce()); // one load case
    rigid_motions[b].assign(1, c2d::RigidMotion());
    load_work[b].assign(4, 0);
  }

  // Codes as on the card: tx ty ux uy, 0 known, 1 unknown.
  void condition(int body, int element, int local, const char* codes, double ux = 0, double uy = 0, int line = 0) {
    const size_t b = static_cast<size_t>(body - 1);
    const int32_t end = (element - 1) * head.function_nodes + local - 1;
    uint8_t code = c2d::kGiven;
    for (int i = 0; i < 4; ++i) code = static_cast<uint8_t>(code | (codes[i] == '0' ? 1 << i : 0));
    end_code[b][static_cast<size_t>(end)] = code;
    end_line[b][static_cast<size_t>(end)] = line;
    const size_t node = static_cast<size_t>(c2d::functional_node(view(), body - 1, element - 1, local - 1));
    if (codes[2] == '0') node_disp[b][2 * node] = ux;
    if (codes[3] == '0') node_disp[b][2 * node + 1] = uy;
  }
  // All ends from (element, local) to (last, last_local), as generated cards give them.
  void conditions(int body, int element, int local, int last, int last_local, const char* codes) {
    for (;;) {
      condition(body, element, local, codes);
      if (element == last && local == last_local) return;
      if (++local > head.function_nodes) local = 1, ++element;
    }
  }

  void zone(int pairs_in, int elements, int e1, int step1, int node1, int e2, int step2, int node2, int line = 0) {
    c2d::Zone z = {};
    z.pairs = pairs_in;
    z.elements = elements;
    z.first_element[0] = e1 - 1, z.first_element[1] = e2 - 1;
    z.element_step[0] = z.node_step[0] = step1, z.element_step[1] = z.node_step[1] = step2;
    z.first_node[0] = node1 - 1, z.first_node[1] = node2 - 1;
    z.first_pair = head.pairs;
    z.line = line;
    for (int side = 0; side < 2; ++side) {
      z.body[side] = side;
      z.region[side] = c2d::region_of_element(view(), side, z.first_element[side]);
    }
    zones.push_back(z);
    head.pairs += pairs_in;
    head.contact_elements += elements;
    head.zones = static_cast<int32_t>(zones.size());
    pairs.resize(static_cast<size_t>(head.pairs));
  }
  void point_load(int body, double x, double y, double fx, double fy, int line = 0) {
    point_loads.push_back({body - 1, 0, line, 0, x, y, fx, fy});
  }

  c2d::Model view() {
    head.zones = static_cast<int32_t>(zones.size());
    head.point_loads = static_cast<int32_t>(point_loads.size());
    head.coefficients = static_cast<int32_t>(friction.size());
    head.paths = static_cast<int32_t>(paths.size());
    c2d::Model m = {};
    m.head = &head;
    m.body = bodies.data();
    place(m.xy, xy);
    place(m.node_line, node_line);
    place(m.end_traction, end_traction);
    place(m.node_disp, node_disp);
    place(m.end_code, end_code);
    place(m.end_line, end_line);
    place(m.node_column, node_column);
    place(m.region, regions);
    place(m.body_force, body_forces);
    place(m.rigid_motion, rigid_motions);
    place(m.load_work, load_work);
    m.zone = zones.data();
    m.pair = pairs.data();
    m.point_load = point_loads.data();
    head.curves = static_cast<int32_t>(surfaces.size());
    m.curve = surfaces.data();
    slip_gaps.resize(pairs.size());
    m.slip_gap = surfaces.empty() ? nullptr : slip_gaps.data();
    m.friction = friction.data();
    m.path = paths.data();
    return m;
  }

  static void keep(void* context, const c2d_error& entry) { static_cast<ModelData*>(context)->told.push_back(entry); }
  bool complete() {
    told.clear();
    c2d::Reporter reporter = {this, keep, 0};
    const bool ok = c2d::complete_model(view(), reporter);
    faults = reporter.faults;
    return ok;
  }

  // The first entry whose text contains `part`, or null.
  const c2d_error* find(const char* part) const {
    for (const c2d_error& entry : told) {
      if (std::strstr(entry.text, part) != nullptr) return &entry;
    }
    return nullptr;
  }
  int count(int32_t status) const {
    int number = 0;
    for (const c2d_error& entry : told) number += entry.status == status;
    return number;
  }
  std::string all() const {
    std::string text;
    for (const c2d_error& entry : told) text += std::string(entry.text) + "\n";
    return text;
  }

private:
  template <class Do> void each_array(Do act) {
    act(xy), act(end_traction), act(node_disp), act(load_work), act(node_line), act(end_line), act(node_column);
    act(end_code), act(regions), act(body_forces), act(rigid_motions);
  }
  // Where an array is of every body; anew for each view, as vectors move.
  template <class T, int32_t id> void place(c2d::BodyArray<T, id>& array, PerBody<T>& data) {
    array.body = bodies.data();
    for (size_t b = 0; b < bodies.size(); ++b)
      bodies[b].array[id] =
          static_cast<int64_t>(reinterpret_cast<intptr_t>(data[b].data()) - reinterpret_cast<intptr_t>(bodies.data()));
  }
};

// Points first ... last of a straight line between the points of two cards, the first included.
inline void line_to(Points& points, double x0, double y0, double x1, double y1, int steps) {
  for (int i = 0; i < steps; ++i) {
    points.push_back(x0 + (x1 - x0) * i / steps);
    points.push_back(y0 + (y1 - y0) * i / steps);
  }
}
inline void arc_to(Points& points, double cx, double cy, double r, double a0, double a1, int steps) {
  const double degree = std::acos(-1.0) / 180;
  for (int i = 0; i < steps; ++i) {
    const double a = (a0 + (a1 - a0) * i / steps) * degree;
    points.push_back(cx + r * std::cos(a));
    points.push_back(cy + r * std::sin(a));
  }
}

inline Points unit_square(double x = 0, double y = 0, double size = 1) {
  return {x, y, x + size, y, x + size, y + size, x, y + size};
}

// Rectangle with its corner points and `steps` equal elements on each side, counter-clockwise from (x, y).
inline Points rectangle(double x, double y, double w, double h, int along_x, int along_y) {
  Points p;
  line_to(p, x, y, x + w, y, along_x);
  line_to(p, x + w, y, x + w, y + h, along_y);
  line_to(p, x + w, y + h, x, y + h, along_x);
  line_to(p, x, y + h, x, y, along_y);
  return p;
}

// A plate of which one or two lines of symmetry cut a half or a quarter off, and a hole that they cut; 117 or 104 elements,
// each cut in `n`. Pulled where nothing else is said.
inline ModelData cut_by_symmetry(int lines, int32_t functions, int n, double traction) {
  ModelData d(functions);
  d.head.images = 1;
  // Counter-clockwise: below, right, above, and down the left with a bite in the middle.
  Points p;
  line_to(p, lines == 2 ? 0.5 : 0, 0, 3, 0, 30 * n);
  line_to(p, 3, 0, 3, 2, 20 * n);
  line_to(p, 3, 2, 0, 2, 30 * n);
  line_to(p, 0, 2, 0, lines == 2 ? 0.5 : 1.5, 10 * n);
  if (lines == 1) {
    arc_to(p, 0, 1, 0.5, 90, -90, 21 * n);
    line_to(p, 0, 0.5, 0, 0, 6 * n);
  } else {
    arc_to(p, 0, 0, 0.5, 90, 0, 14 * n);
  }
  d.body(2, {p}, 1000, 0.3);
  const int end = static_cast<int>(p.size()) / 2;
  if (lines == 2) d.conditions(1, 1, 1, 30 * n, functions, "0110");
  d.conditions(1, 80 * n + 1, 1, 90 * n, functions, "1001");
  if (lines == 1) d.conditions(1, 111 * n + 1, 1, end, functions, "1001");
  if (lines == 1) d.conditions(1, 40 * n, 1, 44 * n, functions, "0110");
  const size_t step = static_cast<size_t>(n);
  for (size_t i = 0; i < d.end_traction[0].size(); i += 2)
    d.end_traction[0][i] = i / 2 % (50 * step) < 9 * step ? traction : 0.0;
  return d;
}

// Hertz's problem of the thesis: cylinder (body 2) on a foundation, half of it, symmetry at x = 0.
inline ModelData hertz() {
  ModelData d(2);
  Points p;
  line_to(p, 0, -4, 8, -4, 8);
  line_to(p, 8, -4, 8, 0, 4);
  line_to(p, 8, 0, 5, 0, 3);
  line_to(p, 5, 0, 4, 0, 2);
  line_to(p, 4, 0, 3, 0, 5);
  line_to(p, 3, 0, 2, 0, 5);
  line_to(p, 2, 0, 1, 0, 5);
  line_to(p, 1, 0, 0, 0, 5);
  line_to(p, 0, 0, 0, -0.5, 2);
  line_to(p, 0, -0.5, 0, -1, 1);
  line_to(p, 0, -1, 0, -3.5, 5);
  line_to(p, 0, -3.5, 0, -4, 1);
  d.body(2, {p}, 1e7, 0.3);
  Points q;
  arc_to(q, 0, 8, 8, 0, 70, 7);
  const double upper[] = {70, 80, 82.8192442, 84.6206210, 86.4166783, 88.2092153};
  arc_to(q, 0, 8, 8, upper[0], upper[1], 2);
  for (int i = 1; i < 6; ++i) arc_to(q, 0, 8, 8, upper[i], upper[i], 1);
  line_to(q, 0, 16, 0, 15.5, 2);
  line_to(q, 0, 15.5, 0, 15, 1);
  line_to(q, 0, 15, 0, 8, 7);
  line_to(q, 0, 8, 0, 1, 7);
  line_to(q, 0, 1, 0, 0.5, 1);
  line_to(q, 0, 0.5, 0, 0, 2);
  q.resize(2 * 34); // node 35 is the next
  q.push_back(0), q.push_back(0);
  const double lower[] = {271.432544, 272.865984, 274.301222, 275.739171, 277.180756, 278.626927,
                          280.078658, 281.536959, 283.002878, 284.477512, 285.962014, 287.457603,
                          288.965575, 290.487315, 292.024313, 293.578179, 295};
  for (double angle : lower) arc_to(q, 0, 8, 8, angle, angle, 1);
  arc_to(q, 0, 8, 8, 300, 350, 5);
  arc_to(q, 0, 8, 8, 350, 350, 1);
  d.body(2, {q}, 1000, 0.3);
  d.condition(1, 1, 1, "0100");
  d.conditions(1, 1, 2, 8, 1, "0110");
  d.condition(1, 8, 2, "0100");
  d.condition(1, 9, 1, "1000");
  d.conditions(1, 9, 2, 12, 2, "1001");
  d.condition(1, 13, 1, "0001");
  d.condition(1, 37, 2, "0101");
  d.conditions(1, 38, 1, 46, 1, "1001");
  d.condition(1, 46, 2, "1000");
  d.condition(2, 13, 1, "0011");
  d.condition(2, 13, 2, "0011");
  d.condition(2, 14, 1, "0011");
  d.condition(2, 14, 2, "0001");
  d.conditions(2, 15, 1, 34, 2, "1001");
  d.condition(2, 35, 1, "0101");
  d.zone(15, 14, 24, 1, 24, 48, -1, 49);
  return d;
}

} // namespace fixture
