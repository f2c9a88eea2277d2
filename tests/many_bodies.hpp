#pragma once
// Models of any number of bodies for tests: made by hand from polygons and curves, told otherwise (bodies and zones in
// another order, sides of a zone swapped, reflected, turned, in other units), and solved through the C interface alone.
// Bodies, elements, sides of polygons, zones and pairs of a zone are numbered from 1, like those of the calls.
#include "c2d_memory.h"
#include "callable.hpp"
#include "contact2d.h"
#include "room.hpp"

#include <array>
#include <string>
#include <vector>

namespace many {

struct End { // condition at one end of an element; values of unknown quantities are not looked at
  int32_t codes[4] = {0, 0, 1, 1};
  double values[4] = {0, 0, 0, 0};
};
// "0011" and the like, and the values of tx ty ux uy.
End end_of(const char* codes, double tx = 0, double ty = 0, double ux = 0, double uy = 0);
const char* const kPulled = "0011"; // tractions are known
const char* const kHeld = "1100";   // displacements are

struct Range {
  int32_t first, last;
};
struct Body {
  double youngs_modulus = 1000, poisson_ratio = 0.3;
  int32_t element_nodes = 2;
  std::vector<Range> regions, sides; // of elements; sides in the order in which they were given
  int32_t open_regions = 0;          // the first ones end on lines of symmetry
  std::vector<double> xy;            // boundary points
  std::vector<End> ends;             // [(element - 1) * function_nodes + local]
  std::vector<End> second;           // the same in load case 2, if there is one
  int32_t rigid = 0, is_free[3] = {0, 0, 0};
  double motion[3] = {0, 0, 0}, load[3] = {0, 0, 0}, point[2] = {0, 0}; // of a rigid body, about the point
  double force[2] = {0, 0}, spin = 0;                                   // per area; density times angular velocity squared

  int32_t elements() const { return regions.empty() ? 0 : regions.back().last; }
};

struct Corner { // start of a straight side of `elements` elements, each `growth` times as long as the one before
  double x, y;
  int32_t elements;
  double growth = 1;
};
Body polygon(const std::vector<Corner>& corners, double youngs_modulus = 1000, double poisson_ratio = 0.3);
// Corners (x0, y0), (x1, y0), (x1, y1), (x0, y1); sides 1 lower, 2 right, 3 upper, 4 left.
Body rectangle(double x0, double y0, double x1, double y1, const std::array<int32_t, 4>& elements, double youngs_modulus = 1000,
               double poisson_ratio = 0.3);
// From (x0, y0) along the corners to the last one: an open curve; the element count of the last is not looked at.
Body open_polygon(const std::vector<Corner>& corners, double youngs_modulus = 1000, double poisson_ratio = 0.3);
// One more closed region of these corners, or through the points of a closed curve, s from 0 to 1 (one side).
void add_polygon(Body& body, const std::vector<Corner>& corners);
void add_curve(Body& body, int32_t elements, const test::Callable<void(double s, double& x, double& y)>& curve);

struct Side {
  int32_t body, first, last; // of elements
  int32_t elements = 0;      // 0: by their numbers
};
struct Zone {
  int32_t kind;
  Side side[2];
  double mu = -1;              // its own coefficient of friction, unless negative
  int32_t without[2] = {0, 0}; // of a matching zone: 1: the node at its first end, at its last end makes no pair
  int32_t count(int k) const;
};
struct Platen { // of load cases 1 and 2
  Side side;
  int32_t is_free[3] = {1, 1, 1};
  double point[2] = {0, 0}, motion[3] = {0, 0, 0}, load[3] = {0, 0, 0};
  double second_motion[3] = {0, 0, 0}, second_load[3] = {0, 0, 0};
};
struct PointLoad {
  int32_t body;
  double x, y, fx, fy;
};
struct Path {
  int32_t increments;
  double load;
  double second = 0; // factor of load case 2, if there is one
};

struct Model {
  int32_t plane = C2D_PLANE_STRAIN, function_nodes = 2, cases = 1, interference = 0;
  std::vector<Body> bodies;
  std::vector<Zone> zones;
  std::vector<Platen> platens; // their ties are the zones behind these
  std::vector<PointLoad> point_loads;
  double friction = 0;
  std::vector<Path> paths = {{1, 1.0}};
  int32_t repeated = 0, cycle_limit = 0, cycle_digits = 0,
          cycle_start = 0; // of c2d_repeat_paths: the last so many paths; 0: no cycle
  int32_t symmetry = 0;    // 1: x = symmetry_at[0], 2: y = symmetry_at[1]
  double symmetry_at[2] = {0, 0};
  int32_t elimination = 0, touching = 0, cycle_states = 0; // C2D_ELIMINATION_; of c2d_limits
  uint64_t bytes = 0;                                      // of workspace; 0: as many as are of use, 1: the minimum

  int32_t add(const Body& body); // its number
  Body& body(int32_t number) { return bodies[static_cast<size_t>(number - 1)]; }
  const Body& body(int32_t number) const { return bodies[static_cast<size_t>(number - 1)]; }
  Range side(int32_t number, int32_t side) const { return body(number).sides[static_cast<size_t>(side - 1)]; }
  // The condition of all ends of a side of a body, or of each of them by its place.
  void set(int32_t number, int32_t side, const End& end);
  void set(int32_t number, int32_t side, const test::Callable<End(double x, double y)>& end);
  void set_second(int32_t number, int32_t side, const End& end); // in load case 2
  // A zone between whole sides: the elements of the first from first to last face those of the second from last to first.
  Platen& move(int32_t number, int32_t side); // by a platen
  int32_t join(int32_t kind, int32_t body1, int32_t side1, int32_t body2, int32_t side2);
  void place(int32_t number, int32_t element, int32_t local, double& x, double& y) const; // of a functional node
  double scale() const;                                                                   // largest coordinate
};

// ---- results
using Row = std::array<double, C2D_PAIR_FIELDS>;
struct Step {
  int32_t kind = 0;
  c2d_outcome outcome = C2D_REACHED;
  double load = 0, work = 0, dissipated = 0, elastic = 0, defect = 0;
  std::vector<Row> rows;
};
struct EndResult {
  double x, y, node, ux, uy, tx, ty, status, sxx, syy, sxy;
};
struct Result {
  c2d_status status = C2D_OK; // of the first call that failed
  c2d_outcome outcome = C2D_REACHED;
  std::vector<Step> steps; // recorded ones, and where the path stopped
  std::vector<c2d_body_result> bodies;
  std::vector<c2d_zone_state> zones;
  std::vector<c2d_body_state> states;
  std::vector<std::vector<EndResult>> boundary; // per body
  c2d_summary summary = C2D_INIT(c2d_summary);
  std::vector<c2d_error> told;

  std::string messages() const;
  bool told_of(const std::string& words) const;
  const Step& last() const { return steps.back(); }
  std::vector<Row> zone_rows(int32_t zone) const; // of the last step
};

// A solver with memory and a store of its own, fed with the model (state model, unless `status` tells why not).
class Machine {
public:
  explicit Machine(const Model& model, int32_t keep_factors = 0, int32_t stepping = C2D_STEPPING_EVENTS);
  explicit Machine(const std::string& deck, int32_t cycle_states = 0);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  Result run();  // prepare and run, unless it is prepared already
  Result look(); // what there is at the load reached
  c2d_solver* solver = nullptr;
  c2d_status status = C2D_OK;
  std::vector<c2d_error> told;
  bool every_change = false;

private:
  void create(c2d_limits& limits, uint64_t bytes = 0);
  test::Room memory_, region_;
  c2d_memory_store store_ = {};
  c2d_port port_ = C2D_INIT(c2d_port), inner_ = C2D_INIT(c2d_port);
  friend struct Relay;
};

Result solve(const Model& model, int32_t stepping = C2D_STEPPING_EVENTS);
// A deck of the model, in free form, without cycles; load factors as long as they are, platens in place. Matching zones are
// numbered before free ones: order[i - 1] is the model's number of the deck's zone i.
std::string deck_of(const Model& model, const std::string& title, std::vector<int32_t>& order);
Result solve_deck(const std::string& text);
c2d_status feed(c2d_solver* solver, const Model& model); // the calls of section 5
std::vector<c2d_body_limits> body_limits(const Model& model);
c2d_limits limits_of(const Model& model, std::vector<c2d_body_limits>& list);
// Two blocks that may touch in so many pairs, all of their faces; the upper one's is rough: waves of a twentieth of its width
// and less, the shorter the lower. Pressed by a displacement until about 5 % touch.
Model rough(int32_t pairs);

// ---- the same model, told otherwise
Model with_bodies_in_order(const Model& model, const std::vector<int32_t>& order); // new number i is old body order[i - 1]
Model with_zones_in_order(const Model& model, const std::vector<int32_t>& order);
Model with_swapped_sides(Model model, int32_t zone);
Model reflected(const Model& model);   // x -> -x
Model upside_down(const Model& model); // y -> -y
// The elements of closed curves counted from another one, `shift` or a little more behind the first.
Model renumbered(const Model& model, int32_t shift);
Model in_more_steps(Model model, int32_t times); // every path in so many times as many increments
Model turned(Model model, double degrees);
Model scaled(Model model, double length, double stress);

// Largest differences over all recorded steps of the pressures, the displacements, the gaps and the slips, each relative to the
// largest of its kind (gaps and slips: displacement). `b` is the result of a model that was made from that of `a`: zone[i - 1]
// is the number there of zone i, and place maps a's points to b's. Energies and balance are compared as well.
struct Least { // sizes below which there is nothing but round-off
  double pressure = 0, displacement = 0, energy = 0;
};
// That of motions against the bodies' sizes, and of their stiffness where they move without a load.
Least least_sizes(const Model& model, const Result& result);
struct Mapping {
  std::vector<int32_t> zone; // empty: the same
  test::Callable<void(double& x, double& y)> place;
  double tangential = 1, length = 1, stress = 1;
  int32_t dimensions = 2; // 3: energies are those of whole bodies of revolution
  Least least;            // of a's sizes
  int32_t every = 1;      // only every so many-th recorded step of b has one of a
};
double difference(const Result& a, const Result& b, const Mapping& map = Mapping());
double status_differences(const Result& a, const Result& b, const Mapping& map = Mapping());

// ---- laws
// Bodies that move without a load leave round-off of their stiffness in the place of pressures: a size below which there are
// none.
double least_pressure(const Model& model, const Result& result);
// Of every body: |applied + contact| over the largest force on a body, added up along its boundary (moments: times the largest
// coordinate).
double imbalance(const Model& model, const Result& result);
// Thin layers between blocks, which bend more than the contact system resolves: their displacements are its unknowns. Quadratic
// functions, n elements along a layer.
Model pressed_layers(int32_t layers, double thickness, int32_t kind, int32_t n);

// Coulomb's law and contact conditions of every recorded step; empty, or the first breach. Sizes relative to the largest
// pressure and displacement.
std::string breach(const Model& model, const Result& result, double tolerance = 1e-9);

} // namespace many
