#pragma once
// A model over plain vectors, on the test's side of the interface: read from a deck, made by hand or turned
// into another one (scaled, rotated, reflected, renumbered, bodies exchanged), and solved through the C
// interface alone. All numbers in here start at 1, like those of the cards.
#include "callable.hpp"
#include "host_structs.hpp"

#include <string>
#include <vector>

namespace problem {

struct End { // condition at one end of an element; values of unknown quantities are zero
  int32_t codes[4] = {0, 0, 1, 1};
  double values[4] = {0, 0, 0, 0};
};
struct Range {
  int32_t first, last;
};
struct Body {
  int32_t element_nodes = 2;
  double youngs_modulus = 1000, poisson_ratio = 0.3;
  std::vector<Range> regions;   // of elements
  int32_t open_regions = 0;     // the first ones end on lines of symmetry
  std::vector<double> xy;       // boundary points
  std::vector<End> ends;        // [(element - 1) * function_nodes + local - 1]
  std::vector<End> second_case; // the same for load case 2, if there is one
};
struct PointLoad {
  int32_t body;
  double x, y, fx, fy;
  int32_t load_case = 1;
};
struct Path {
  int32_t increments;
  double load;
  double second = 0; // factor of load case 2, if there is one
};
struct BodyForce { // per area (bx, by) + rho_omega2 (x - x0, y - y0)
  int32_t body, load_case;
  double bx, by, rho_omega2 = 0, x0 = 0, y0 = 0;
};

struct Zone { // of matching pairs; first of body 1, second of body 2
  int32_t pairs = 0, elements = 0, first_element[2] = {}, last_element[2] = {}, first_node[2] = {}, last_node[2] = {};
};
struct FreeZone {
  int32_t first_element[2] = {}, last_element[2] = {}, elements[2] = {};
};

struct Problem {
  int32_t plane = C2D_PLANE_STRAIN, analysis = C2D_ANALYSIS_FULL, iteration_limit = 50, function_nodes = 2;
  std::vector<Body> bodies;
  std::vector<PointLoad> point_loads;
  std::vector<BodyForce> body_forces;
  bool rigid = false; // body 1; `motions` of load cases 1 ...: ux, uy, rotation about the origin
  std::vector<std::vector<double>> motions;
  int32_t interference = 0; // load case that closes overlaps
  std::vector<Zone> zones;
  std::vector<FreeZone> free_zones;
  std::vector<double> friction = {0.0};
  std::vector<Path> paths = {{1, 1.0}};
  int32_t symmetry = 0; // lines of symmetry by images: 1: x = symmetry_at[0], 2: y = symmetry_at[1]
  double symmetry_at[2] = {0, 0};

  int32_t elements(int body) const;
  int32_t pairs() const;
  bool two_cases() const;
  End& end(int body, int32_t element, int32_t local);
};

enum class Memory { minimum, between, in_core };
enum class Store { memory, stdio, posix };
struct Setup {
  Memory memory = Memory::in_core;
  uint64_t bytes = 0; // instead of `memory`, unless 0
  int32_t panel_columns = 0;
  Store store = Store::memory;
  int32_t quadrature = C2D_QUADRATURE_ACCURATE, stepping = C2D_STEPPING_EVENTS, every_change = 0;
  int32_t symmetry = C2D_SYMMETRY_DECK;
  std::vector<double> points; // x y x y ...: c2d_interior at the end
  bool indicators = false;    // c2d_indicators of all elements at the end
  int32_t threads = 1;
  double seconds = 0; // of the processor's time, after which the run is cancelled; 0: any
  int runs = 1;       // how often c2d_run is called; the last one is kept
  // Instead of c2d_run, unless empty: friction, then a call of c2d_advance per load. Steps then carry numbers
  // 1 ...
  std::vector<double> advance_loads;
  std::vector<double> advance_second; // factors of load case 2, if there is one
  double advance_mu = 0;
  bool go_on = false;           // with the next load after one that was not reached
  bool boundaries = false;      // kept at every load
  bool begin_after_run = false; // c2d_run first, then begin and advance
};

struct EndResult {
  int32_t element, node, status;
  double x, y, ux, uy, tx, ty;
};
struct Step {
  int32_t kind, coefficient, step, changes, iterations;
  c2d_outcome outcome;
  double mu, load;
  std::vector<double> table; // pairs x C2D_PAIR_FIELDS
  double work = 0, dissipated = 0, elastic = 0, defect = 0;
  double at(int pair, int field) const { return table[static_cast<size_t>(pair * C2D_PAIR_FIELDS + field)]; }
  int pairs() const { return static_cast<int>(table.size()) / C2D_PAIR_FIELDS; }
  double second = 0;                                    // factor of load case 2
  host::OfBodies<std::vector<EndResult>> boundary = {}; // with Setup::boundaries
};
struct Result {
  c2d_status status = C2D_OK; // of the first call that failed
  c2d_outcome outcome = C2D_REACHED;
  std::vector<Step> steps; // recorded ones, with every_change also changes
  host::OfBodies<std::vector<EndResult>> boundary;
  std::vector<double> interior;                   // rows of C2D_POINT_FIELDS
  host::OfBodies<std::vector<double>> indicators; // rows of C2D_OFF_FIELDS
  host::Summary summary;
  std::vector<c2d_error> told;
  uint64_t minimum_bytes = 0;

  bool warned(int32_t number) const;
  std::string messages() const;
  std::vector<Step> recorded() const; // without changes and stops
};

// A deck of tests/data/decks, or the text of one.
std::string deck_text(const std::string& name);
Problem from_text(const std::string& text);
Problem load(const std::string& name);
Result solve(const Problem& problem, const Setup& setup = Setup());
Result solve_text(const std::string& text, const Setup& setup = Setup());

// ---- the same problem, told otherwise
// ---------------------------------------------------------------------------
Problem scaled(Problem p, double length, double stress);
// Quarter turns keep every condition; other angles need both components of an end to be of one kind.
Problem rotated(Problem p, double degrees);
Problem reflected(const Problem& p);                    // x -> -x: boundaries then run the other way
Problem renumbered(const Problem& p, int32_t elements); // each region starts that many elements further on
Problem exchanged(Problem p);
Problem with_paths(Problem p, const std::vector<Path>& paths);
Problem split(Problem p, int32_t times); // every load card into `times` as many increments
// Linear elements and functions to these orders; conditions at inner nodes follow from those at both ends.
Problem with_functions(const Problem& p, int32_t function_nodes);
Problem with_geometry(const Problem& p, int32_t element_nodes);
// Every element of linear ones cut in two, between points that `place` moves to where they belong.
Problem cut_in_two(const Problem& p,
                   const test::Callable<void(int body, const double* from, const double* to, double* middle)>& place);

// ---- bodies by hand
// ---------------------------------------------------------------------------------------------
struct Corner { // start of a straight side of `elements` equal elements
  double x, y;
  int32_t elements;
};
// Add a closed curve to a body.
void add_polygon(Body& body, const std::vector<Corner>& corners);
// Add an element sequence through the points of a parametrised closed curve; s runs from 0 to 1.
void add_curve(Body& body, int32_t elements, const test::Callable<void(double s, double& x, double& y)>& curve);
// Visit every end with its place and outward normal (size of `ends` is set).
void set_ends(Problem& p, int body, const test::Callable<void(double x, double y, double nx, double ny, End&)>& set);

// ---- comparison
// ------------------------------------------------------------------------------------------------- Largest
// difference of two tables relative to the largest of its kind: tractions; displacements of body 1, of body
// 2; gaps; slips. `statuses` counts pairs of different status.
struct Difference {
  double traction = 0, displacement1 = 0, displacement2 = 0, gap = 0, slip = 0;
  int statuses = 0;
  double worst() const;
  void join(const Difference& other);
};
// Signs of the tangential quantities of `b`, and factors that turn b's lengths and stresses into a's.
struct Mapping {
  double length = 1, stress = 1, tangential = 1;
  bool exchanged = false;
};
Difference compare(const Step& a, const Step& b, const Mapping& map = Mapping());
// Of all recorded steps, which must agree in number.
Difference compare(const Result& a, const Result& b, const Mapping& map = Mapping());
// Largest differences of displacements and tractions at all ends of all bodies, relative to the largest.
double boundary_difference(const Result& a, const Result& b);
// Bits of all tables and boundaries agree.
bool identical(const Result& a, const Result& b);

// Sums over a body's boundary of its linear or higher elements: fx, fy, moment about the origin. `which`: 0
// all ends, 1 ends of contact pairs, 2 the others. Point loads (times the load factor) count as others.
struct Resultant {
  double fx = 0, fy = 0, moment = 0, size = 0; // size: sum of magnitudes of forces
};
Resultant resultant(const Problem& p, const Result& r, int body, int which);

// Coulomb's law and the contact conditions at every step. Returns an empty string or the first breach.
std::string coulomb_breach(const Problem& p, const Result& r);

} // namespace problem
