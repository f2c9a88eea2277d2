#pragma once
// The model: bodies with boundary and conditions, contact zones and load cards, as views into the workspace.
// All numbers in here start at 0 (the interface's start at 1). Coordinates, loads and moduli are the caller's.
#include "contact2d.h"
#include "memory/config.hpp"
#include "memory/sizes.hpp"
#include "model/friction_law.hpp"
#include "model/shape.hpp"

namespace c2d {

// Bits of an element end's code: quantity is known. kGiven: a condition card named this end. At an element's first end:
// kMeasured: kNoLength says whether the element has zero length, without looking at its nodes. kFacesNothing: nothing of side 1
// faces this end on side 0 of a free zone, which need not be searched for again.
enum EndCode : uint8_t {
  kKnownTx = 1,
  kKnownTy = 2,
  kKnownUx = 4,
  kKnownUy = 8,
  kGiven = 16,
  kMeasured = 32,
  kNoLength = 64,
  kFacesNothing = 128
};

struct Region { // elements first ... last form a closed curve, or one that is open between symmetry lines
  int32_t first, last;
  int32_t open = 0;  // 1: its last boundary point is not its first
  int32_t shift = 0; // open regions before it: its nodes' numbers are that much higher
};
struct PointLoad {
  int32_t body, load_case, line, column;
  double x, y, fx, fy;
};
// Points for interior results: a point, a line or a grid, as in c2d_points. The solution does not depend on them.
struct PointSet {
  int32_t kind, body, count[2], line, padding;
  double from[2], to[2];
};
// Given surface over elements first ... last; kind as in c2d_curve.
struct Curve {
  int32_t kind, body, first, last, line, padding;
  double centre[2], radius;
};
// Change of the gap of a pair due to slip along given curves (model/slip_gap.hpp).
struct SlipGap {
  int32_t follows, padding; // 1: the curvature changes along the zone, so the change is not zero
  double even;              // curvature of both sides together on the longest stretch of the zone with constant curves
  double now, rate;         // current change, and its rate along the current path segment, in the length unit of the model
  double work;              // work of the pressure on the change
  double good, good_work;   // of the last verified state (solver/judge.hpp)
};
struct Path {
  int32_t increments;
  int32_t cycle; // of the first segment of a cycle: see interface/path_cycle_calls.cpp; of the last: less their number
  double load;
};
// Body force of one body in a load case: per area (bx, by) + rho_omega2 (x - x0, y - y0).
struct BodyForce {
  double bx, by, rho_omega2, x0, y0;
};
// Motion of a rigid body in a load case: (ux, uy) and a rotation about (x0, y0), linear in the angle; for its free motions the
// force and the moment about Body::centre.
struct RigidMotion {
  double ux, uy, rotation, x0, y0;
  double load[3];
};
// Where two bodies may touch, side 0 on body[0] and side 1 on body[1]. Element k of a zone is first_element[s] + k *
// element_step[s] on side s; pair k joins the functional nodes zone_node(..., k). Ranges may wrap around their region. In a
// free zone (model/free_zones.hpp) the sides are meshed independently: `elements` are those of side 1, whose nodes make the
// pairs; side 0 has `facing` elements and no nodes.
struct Zone {
  int32_t pairs, elements;
  int32_t body[2];
  int32_t shift[2]; // contact unknown of the body on a side, less Pair::dof
  int32_t first_element[2], element_step[2];
  int32_t first_node[2], node_step[2];
  int32_t region[2];
  int32_t first_pair; // pairs of earlier zones; tied zones come after all others
  int32_t line;
  int32_t facing;
  int8_t is_free;
  int8_t is_tied;     // 1: bonded: it carries unlimited tension and shear
  int8_t is_self;     // 1: self-contact: both sides are on one body, which has contact unknowns for each
  double normal_part; // weight of the normal of side 0 in that of the pairs (model/surface.hpp)
  char name[32];
};
// A place on a side of a zone: its k-th element.
struct ZonePlace {
  int32_t zone, side, place;
};
// A pair and the side on which something is; pair -1: none.
struct PairSide {
  int32_t pair, side;
};
// Sign of the force of a pair on the body of a side, and of the displacement of that body in the relative motion of the pair.
inline double sign_of_side(int side) { return side == 1 ? 1.0 : -1.0; }
template <class Number> Number signed_on(int side, Number x) { return side == 1 ? x : -x; } // without a product
// Marks of a pair during one round of status changes.
struct PairMarks {
  uint8_t offends : 1;                       // contact/settle.cpp: violates a condition with the current rates
  uint8_t exchanged : 2;                     // contact/tableau.cpp: bit 1 << slot, that degree of freedom has left the basis
  uint8_t changes : 1, status : 2, slip : 2; // contact/settle.cpp, increments.cpp: new status; sign of slip + 1
};
static_assert(sizeof(PairMarks) == 1, "scratch that costs nothing");
struct Pair {
  int32_t node[2]; // functional nodes of both sides; in a free zone -1 on side 0, a point of an element there:
  int32_t element; // free zone: that element,
  union {
    int32_t row;  // and the pair's first equation u_c = u there, from 0
    int32_t made; // contact on demand: where its columns are on the tape; -1: nowhere
  };
  double eta;
  int32_t zone;
  int32_t dof;       // first contact unknown: normal; tangential follows if there is one
  int8_t tangential; // 0: symmetry fixes the tangential direction
  int8_t status;     // C2D_OPEN, C2D_STICK, C2D_SLIP
  int8_t sign;       // slip: sign of the friction on side 1
  PairMarks mark;
  int8_t saved_status, saved_sign;
  int8_t good_status, good_sign; // of the last verified state (solver/judge.hpp)
  // The search for the next event reads these members of every pair: they are adjacent in memory, from `dof` to here.
  double gap;        // initial normal gap >= 0
  FrictionLaw law;   // in force
  Real stiffness[2]; // normal and tangential, of this pair alone with its neighbours fixed
  // History of friction, written by src/contact alone; w_t = (u1 - u0).t of the sides in the length unit of the model.
  // For a pair of a separated body they store its last position: place_of and keep_place of contact/let_go.hpp.
  Real offset;      // stick: w_t at which the pair sticks
  Real slip_from;   // slip: w_t at which this episode began
  double nx, ny;    // the frame: n from side 0 to side 1; t = (ny, -nx)
  double overlap;   // by which the bodies overlap there; ModelHeader::interference closes it
  double length;    // shorter of the contact elements that meet there, both sides
  double weight;    // integral of the pair's shape functions along the body of its measure, length unit
  int32_t place[2]; // while the tableau is built: where the column of a slot stands
  // These, too, come from the tableau and have no more digits than it.
  Real slip_done;      // slip summed over finished episodes
  Real increment_from; // w_t at the start of the increment (deck stepping)
  Real saved_offset, saved_slip_done, saved_slip_from;
  Real saved_q; // q at the start of the increment (deck stepping)
  Real good_offset, good_slip_done, good_slip_from;
  Real slip_before; // slip summed before the pair last touched (results/warnings/warnings.cpp)
};

#define C2D_AS_LISTED(type) static_assert(sizeof(type) == C2D_BYTES_OF_##type, "contact2d_memory.h states the size")
C2D_AS_LISTED(Region);
C2D_AS_LISTED(Zone);
C2D_AS_LISTED(Pair);
C2D_AS_LISTED(PointLoad);
C2D_AS_LISTED(Path);
C2D_AS_LISTED(BodyForce);
C2D_AS_LISTED(RigidMotion);
C2D_AS_LISTED(PointSet);
C2D_AS_LISTED(Curve);
C2D_AS_LISTED(SlipGap);

// How a body enters the contact system, Body::keeps_equations (contact/reduction/reduction_plan.hpp).
enum Enters : int8_t {
  kSolvedFor = 0,     // its displacements are F tau + ... + R x
  kKept = 1,          // its equations are rows; its displacements follow from those of the bodies it meets
  kDisplacements = 2, // its equations are further rows, its displacements z + R x, z further unknowns
};

// Bodies and what belongs to each are lists in the workspace.
struct Body {
  int32_t element_nodes, elements, geometry_nodes, regions;
  int32_t nodes, region_count;
  int32_t open_regions; // the first ones
  int32_t columns;      // outer unknowns without rho and omega
  int32_t contact;      // contact unknowns of all its zones
  int32_t free_rows;    // those of side 0 of free zones, which have equations
  int32_t first_motion; // free motions of earlier bodies that the contact must support
  int32_t first_border; // of them, those of bodies that keep no equations
  int8_t is_set;
  int8_t free_motions;    // rigid-body motions that no prescribed displacement prevents
  int8_t rigid;           // 1: no equations; the load cases prescribe its motion,
  int8_t free_rigidly;    // except these free motions: bits 1: ux, 2: uy, 4: rotation, of the point `centre`
  int8_t has_force;       // 1: body forces
  int8_t keeps_equations; // how it enters the contact system: Enters, contact/reduction/reduction_plan.hpp
  int8_t lines;           // of symmetry that it meets, as in ModelHeader::symmetry: across them it is its own image
  int8_t on_demand;       // 1: lazy columns: contact nodes are ordinary ones, contact tractions right-hand sides (METHOD 10.12)
  double youngs_modulus, poisson_ratio;
  double free_motion[3][3]; // orthonormal in (ux, uy, rotation * length_unit) about `centre`
  double centre[2];
  int64_t first_node, first_end; // functional nodes and element ends of the bodies before
  int64_t first_block;           // of its matrices on tape CONTACT
  int64_t array[kBodyArrays];    // bytes from the list of bodies to its arrays
  char name[32];
};
struct BodyResults {    // of the last back-substituted state
  double multiplier[3]; // rho, omega of the balanced equations
  double applied[3], contact_force[3];
};
C2D_AS_LISTED(Body);
C2D_AS_LISTED(BodyResults);
#undef C2D_AS_LISTED

struct ModelHeader { // lives in the solver's header; the arrays live in the workspace
  int32_t bodies, function_nodes, load_cases;
  int32_t plane, analysis, iteration_limit;
  int32_t zones, pairs, contact_elements, point_loads, coefficients, paths;
  int32_t contact;       // contact unknowns m, those of tied zones last
  int32_t path_pairs;    // pairs that can change their status: the first ones,
  int32_t path_unknowns; // and their contact unknowns
  int32_t loose;         // free motions that ties leave
  int32_t motions;       // free motions of all bodies in contact
  int32_t border;        // of them, those of bodies that keep no equations
  int32_t line, column, column_end;
  // Lines of symmetry x = line_at[0] (bit 1) and y = line_at[1] (bit 2): requested, and in force after the completion of the
  // model; the model lies where line_side * (x - line_at) >= 0.
  int32_t symmetry_asked, symmetry;
  int32_t images;       // 1: elements on a symmetry line are replaced by images
  int32_t interference; // load case, from 1, that removes initial overlaps; 0: overlaps are not allowed
  int32_t point_sets;   // points for interior results
  int32_t curves;       // given curves
  int32_t columns;      // lazy columns: how many columns of the contact system fit in memory; 0: all are made
  double line_at[2], line_side[2];
  double length_unit; // power of two near the size of the bodies
  double stress_unit; // power of two near 2G of the softer body
  char title[80];
  char unit_length[16], unit_force[16];
};

// Arrays that a platen shares with the body that it moves.
constexpr int32_t kMeshArrays[] = {kXy, kNodeLine, kEndTraction, kNodeDisp, kEndCode, kEndLine, kRegions};

// One array of every body.
template <class T, int32_t id> struct BodyArray {
  Body* body;
  T* operator[](int b) const { return reinterpret_cast<T*>(reinterpret_cast<char*>(body) + body[b].array[id]); }
};

struct Model { // a view, rebuilt on every call of the library: plain pointers, never stored
  ModelHeader* head;
  Body* body;
  BodyArray<double, kXy> xy;
  BodyArray<int32_t, kNodeLine> node_line;
  BodyArray<double, kEndTraction> end_traction; // [(case * ends + end) * 2 + component]
  BodyArray<double, kNodeDisp> node_disp;       // [(case * nodes + node) * 2 + component]
  BodyArray<uint8_t, kEndCode> end_code;
  BodyArray<int32_t, kEndLine> end_line;
  BodyArray<int32_t, kNodeColumn> node_column;
  BodyArray<Region, kRegions> region;
  BodyArray<BodyForce, kBodyForces> body_force;       // [case]
  BodyArray<RigidMotion, kRigidMotions> rigid_motion; // [case]
  BodyArray<double, kLoadWork> load_work;             // [4 * case]: on the free motions, and the sum of magnitudes
  Zone* zone;
  Pair* pair;
  PointLoad* point_load;
  Curve* curve;
  SlipGap* slip_gap; // [pairs]; null where no curve is given
  double* friction;
  Path* path;
  double* path_load; // [path * cases + case]
};

// Bodies of revolution about x = 0: x is r, y is z (METHOD 21).
inline bool is_axisymmetric(const Model& m) { return kRings && m.head->plane == C2D_AXISYMMETRIC; }
// Length of the surface that a pair stands for. Weights of rings are areas; there it is a share of the element.
inline double length_at(const Model& m, const Pair& pair) {
  if (!is_axisymmetric(m)) return pair.weight * m.head->length_unit;
  return m.head->function_nodes > 2 ? pair.length / (m.head->function_nodes - 1) : pair.length;
}

// ---- topology ---------------------------------------------------------------------------------------------------
inline const Body& body_of(const Model& m, int b) { return m.body[b]; }
int32_t region_of_element(const Model& m, int b, int32_t element);
// First and last functional node of a region.
void nodes_of_region(const Model& m, int b, int32_t region, int32_t* first, int32_t* last);
// The element that begins where this one ends; -1 at the end of an open region.
int32_t element_after(const Model& m, int b, int32_t element);
// Geometry node `k` (0 ... element_nodes-1) of an element; the last node of a closed region's last element is its first.
int32_t geometry_node(const Model& m, int b, int32_t element, int k);
// Functional node of local function node l of an element.
int32_t functional_node(const Model& m, int b, int32_t element, int l);
// Ends of elements of non-zero length at a functional node: 0, 1 or 2 (end = element * function_nodes + local), the preceding
// element first. Without those on a symmetry line, and with them.
int ends_at_node(const Model& m, int b, int32_t node, int32_t ends[2]);
int all_ends_at_node(const Model& m, int b, int32_t node, int32_t ends[2]);
int ends_off_axis(const Model& m, int b, int32_t ends[2], int count); // removes those on symmetry lines
// The boundary point at which an element begins or ends there; -1 for a node inside an element.
int32_t corner_point(const Model& m, int b, int32_t node);
bool is_zero_length(const Model& m, int b, int32_t element);
// Stores for all elements whether they have zero length. Once the nodes have their final positions.
void measure_elements(const Model& m);
// Is the element integrated over? Not if it has zero length or is replaced by images (model/symmetry.hpp).
bool is_integrated(const Model& m, int b, int32_t element);
// The other node of a double node (joined by a zero-length element), or -1. The first of the two carries the
// collocation equations; the second's are u_first = u_second.
int32_t twin_node(const Model& m, int b, int32_t node);
bool is_second_twin(const Model& m, int b, int32_t node);
void element_coordinates(const Model& m, int b, int32_t element, double x[kElementNodes], double y[kElementNodes]);
void node_position(const Model& m, int b, int32_t node, double* x, double* y);
// Where a pair is on a side: at its node, on side 0 of a free zone at the point its node faces (model/free_zones.cpp).
void pair_position(const Model& m, const Pair& pair, int side, double* x, double* y);
void faced_position(const Model& m, const Pair& pair, double* x, double* y);

// ---- contact topology -------------------------------------------------------------------------------------------
inline int32_t zone_elements(const Zone& z, int side) { return z.is_free != 0 && side == 0 ? z.facing : z.elements; }
int32_t zone_element(const Model& m, const Zone& z, int side, int32_t k);
int32_t zone_node(const Model& m, const Zone& z, int side, int32_t k);
inline bool is_tied(const Model& m, const Pair& pair) { return m.zone[pair.zone].is_tied != 0; }
inline const Zone& zone_of(const Model& m, const Pair& pair) { return m.zone[pair.zone]; }
inline int body_on(const Model& m, const Pair& pair, int side) { return m.zone[pair.zone].body[side]; }
// First contact unknown of a pair among those of the body on that side.
inline int32_t dof_on(const Model& m, const Pair& pair, int side) { return pair.dof + m.zone[pair.zone].shift[side]; }
// Where an element is in a zone; false if it is no contact element.
bool find_contact_element(const Model& m, int b, int32_t element, ZonePlace* out);
// Pair -1: none, as everywhere on side 0 of a free zone.
PairSide pair_of_node(const Model& m, int b, int32_t node);
// Pair whose traction lives at local node l of this element; -1 if the end is not a contact end (METHOD 9.1). Where a free zone
// ends at a node that is in none of its pairs, or a matching one at a node of another zone, that of the nearest pair.
PairSide pair_of_end(const Model& m, int b, int32_t element, int l);

// ---- unknowns ---------------------------------------------------------------------------------------------------
// The one unknown of a global component (0: x, 1: y) at a functional node.
enum class UnknownKind : int32_t {
  displacement,
  traction,
  shared_traction,
  contact, // shared: one value at both ends
  none,
  several // faults
};
struct Unknown {
  UnknownKind kind;
  int32_t end[2]; // traction: end[0]; shared_traction: both
  bool loaded;    // displacement: the contact acts there all the same, on demand
};
// Do tractions of the contact act along this component, where an end is in contact?
inline bool is_in_contact(const Unknown& unknown) {
  return unknown.kind == UnknownKind::contact || (!kSmallCode && unknown.loaded);
}
Unknown unknown_at(const Model& m, int b, int32_t node, int component);
// Does the contact determine this component of the traction at an element end? `at`: its pair (pair_of_end); `node`, `unknown`:
// the node of the end, and the unknown there.
bool is_of_contact(const Model& m, const PairSide& at, int32_t node, int component, const Unknown& unknown);
void unknowns_at(const Model& m, int b, int32_t node, Unknown unknown[2]); // of both components
bool displacement_known(const Model& m, int b, int32_t node, int component);
// Prescribed values in a load case, at factor 1.
inline double given_displacement(const Model& m, int b, int32_t node, int component, int32_t load_case) {
  return m.node_disp[b][(static_cast<int64_t>(load_case) * m.body[b].nodes + node) * 2 + component];
}
inline double given_traction(const Model& m, int b, int32_t end, int component, int32_t load_case) {
  const int64_t ends = static_cast<int64_t>(m.body[b].elements) * m.head->function_nodes;
  return m.end_traction[b][(load_case * ends + end) * 2 + component];
}

// Are columns of the contact system made only when needed?
inline bool is_on_demand(const Model& m) { return !kSmallCode && m.head->columns > 0; }
// With lazy columns: motions of a body that its equations do not constrain, the first free ones, and on which no reaction does
// work (may_be_on_demand).
inline int32_t motions_held(const Model& m, int b) {
  return kSmallCode || m.body[b].on_demand == 0 ? 0 : m.body[b].free_motions;
}
inline bool is_rigid(const Model& m, int b) { return m.body[b].rigid != 0; }
inline bool keeps_equations(const Model& m, int b) { return m.body[b].keeps_equations == kKept; }
inline bool has_displacements(const Model& m, int b) { return !kSmallCode && m.body[b].keeps_equations == kDisplacements; }
// Displacements of such bodies: further unknowns of the contact system, of all bodies or of those before one.
int32_t further_unknowns(const Model& m, int end);
inline int32_t further_unknowns(const Model& m) { return kSmallCode ? 0 : further_unknowns(m, m.head->bodies); }
// A platen (c2d_add_platen): a rigid body tied to elements of another. These are its side of the zone as well: the arrays of
// its mesh are those of that body, but it counts no elements, nodes or regions, so that none is looked at as its own.
inline bool is_platen(const Model& m, int b) { return m.body[b].elements == 0; }
// Among elements 0 ... end - 1 are those of its zones.
inline int32_t end_of_elements(const Model& m, int b) { return is_platen(m, b) ? m.region[b]->last + 1 : m.body[b].elements; }
const Zone& tie_of_platen(const Model& m, int b);
bool has_body_forces(const Model& m);
// Displacement of a point of a rigid body in a load case, at factor 1.
inline void rigid_displacement(const Model& m, int b, int32_t load_case, double x, double y, double u[2]) {
  const RigidMotion& motion = m.rigid_motion[b][load_case];
  u[0] = motion.ux - motion.rotation * (y - motion.y0);
  u[1] = motion.uy + motion.rotation * (x - motion.x0);
}

// ---- materials --------------------------------------------------------------------------------------------------
double shear_modulus(const Model& m, int b);
double strain_poisson_ratio(const Model& m, int b); // nu of the equivalent plane strain problem

} // namespace c2d
