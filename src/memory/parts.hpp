#pragma once
// Parts of the method that only some models or programs need. Each is a constant table of the functions that the rest of the
// core calls. The file of the call that declares the part (src/interface) fills the table, and so links the part into a
// program.
//
// A file that calls through a table names it with C2D_USES. This defines a weak, empty table: its functions do nothing and
// return 0, or return C2D_ERR_INTERNAL if they return a status. So every call has a target. A model uses a part only if the
// call that declares it was linked, so nothing is missing. Where another program's model may be read, `linked` is checked and
// the model refused; the deck reader takes the declaring call from the table. (A file without C2D_USES links the part: more
// code, no other harm.)
//
// Functions that read models of any kind (the deck reader, c2d_attach, options) name their parts with C2D_MEETS. This links
// all of them through their calls (C2D_BRINGS), except in a library compiled with C2D_PARTS_BY_CALL.
// Omitting parts needs ELF, an archive of objects and GCC or clang; elsewhere every part is linked.
#include "contact2d_cycle.h"
#include "memory/config.hpp"

namespace c2d {

// What needs a part that is not linked, then this, then the call that declares the part.
inline constexpr char kNeedsPart[] = " needs a part of the library that this program does not link (C2D_PARTS_BY_CALL): ";

// Contents of an empty table.
template <class R, class... A> using Function = R (*)(A...);
struct Nothing {
  template <class R, class... A> static R none(A...) { return R(); }
  template <class R, class... A> constexpr operator Function<R, A...>() const { return none<R, A...>; }
};
struct NotLinked {
  template <class... A> static c2d_status refuse(A...) { return C2D_ERR_INTERNAL; }
  template <class... A> constexpr operator Function<c2d_status, A...>() const { return refuse<A...>; }
};

struct Model;
struct ModelHeader;
struct Pair;
struct Reporter;

struct SymmetryPart { // model/validate/validate_lines.cpp
  bool linked = false;
  decltype(&c2d_set_symmetry) set_symmetry = nullptr;
  Function<bool, const Model&, Reporter&> validate_lines = Nothing();
  Function<int32_t, const Model&, int, int32_t> lines_along = Nothing();
  Function<int32_t, const Model&, int, int32_t> lines_at_corner = Nothing();
  Function<bool, const Model&, int, int32_t, int> is_held_by_lines = Nothing();
  Function<void, const ModelHeader&, double*> fold_across = Nothing();
};

struct FacePoint;
struct Surface;
struct Zone;
struct ColumnSystem;
struct TransferWalk;
struct Transfer;
enum class Quadrature;
struct Adjoint;
struct Session;

struct FreeZonePart { // model/free_zones.cpp with model/facing_*.cpp and zone_surface.cpp, bie/transfer.cpp,
                      // contact/pairs/facing_pairs.cpp, results/transferred.cpp
  bool linked = false;
  Function<c2d_status, c2d_solver*, const c2d_zone&> add_free_zone = NotLinked();
  Function<bool, const Model&, int32_t, Reporter&> fit_free_zone = Nothing();
  Function<void, const Model&, const Pair&, double*, double*> faced_position = Nothing();
  Function<void, const ColumnSystem&, int32_t, int32_t, Real*, int64_t> fill_transfer = Nothing();
  Function<bool, const Model&, TransferWalk&> next_transfer = Nothing();
  Function<void, const Model&, Quadrature, const TransferWalk&, Transfer&> make_transfer = Nothing();
  Function<bool, const Model&, int32_t, Surface&> surface_faced = Nothing();
  Function<int32_t, const Model&, const Pair&> faced_node = Nothing();
  Function<void, Adjoint&, const double*, const double*> add_transferred_at = Nothing();
  Function<void, const Session&, int, int32_t, int, double*> add_transferred_traction = Nothing();
  Function<void, const Session&, const Transfer&, int, double*> transferred_values = Nothing();
  Function<void, const Session&, int, double*> add_transferred_force = Nothing();
  Function<bool, const Model&, const Zone&, const FacePoint&, FacePoint&> face_point = Nothing();
  Function<bool, const Model&, const Zone&, const FacePoint&, FacePoint&> facing_point = Nothing();
};

struct Hole;
struct Panel;
struct PointLoad;
struct Blocks;

struct HoleWalk;
struct HoleRow;
struct FieldElement;
struct Integrator;

struct HolePart { // bie/holes.cpp
  bool linked = false;
  Function<bool, const Model&, int, HoleWalk&, Hole&> next_hole = Nothing();
  Function<void, const Model&, int, const Hole&, const Integrator&, bool, bool, FieldElement&, HoleRow&> hole_row = Nothing();
  Function<double, const Model&, int, const Hole&, const PointLoad&> hole_load = Nothing();
  Function<void, const Model&, int, int32_t, double*> hole_normal = Nothing();
};

struct Complex;
struct PointField;
struct Deposits;

struct RingPart { // bie/rings: bodies of revolution
  bool linked = false;
  Function<void, const Integrator&, double, double, int, bool, bool, Blocks&> integrate_rings = Nothing();
  Function<void, const Integrator&, double, double, int, double (*)[2]> ring_sum = Nothing();
  Function<bool, const ColumnSystem&, const Integrator&, const int32_t*, Blocks&, const Deposits&> scatter_rings = Nothing();
  Function<bool, const ColumnSystem&, const Integrator&, const int32_t*, int32_t, int32_t> take_rings = Nothing();
  Function<bool, const ColumnSystem&, int32_t, int32_t> fill_ring_diagonal = Nothing();
  Function<void, const Integrator&, double, double, double (*)[2], double (*)[2]> add_ring_trace = Nothing();
  Function<void, const FieldElement&, const Complex&, double, double, PointField&> add_ring_field = Nothing();
  Function<void, double, const double*, const double*, double (*)[2]> ring_force = Nothing();
  Function<void, const double*, double, const double*, const double*, PointField&> add_ring_force = Nothing();
};

struct Follower;

struct CurvePart { // model/validate/validate_curves.cpp, slip_gap.cpp, contact/slip_path.cpp
  bool linked = false;
  Function<bool, const Model&, Reporter&> validate_curves = Nothing();
  Function<void, const Model&> find_slip_gaps = Nothing();
  Function<void, Follower&, double> aim_gaps = Nothing();
  Function<double, const Model&, const Zone&, const FacePoint*, const double*, double, double> slip_gap = Nothing();
};

struct BodyForcePart { // bie/body_force.cpp, body_force_columns.cpp, solver/particular.cpp, energy_body_force.cpp
  bool linked = false;
  decltype(&c2d_set_body_force) set_body_force = nullptr;
  Function<void, const Model&, int, int32_t, Reporter&> check_body_force = Nothing();
  Function<void, const Model&, int, int32_t, double, double, double*> body_force_resultant = Nothing();
  Function<void, const ColumnSystem&, const Hole*, const Panel&, int32_t> add_body_force_columns = Nothing();
  Function<void, Adjoint&, int32_t> add_body_force = Nothing();
  Function<void, Adjoint&, int32_t, const Blocks&, const double*> take_particular = Nothing();
  Function<void, Adjoint&, const PointLoad&, const double*> add_particular_at_load = Nothing();
  Function<void, const Session&, int, int32_t, int, double*, double*> particular_at_end = Nothing();
  Function<void, const Session&, int, int32_t, double, double*> interpolated_particular = Nothing();
  Function<void, const Session&, int, const double*, double*, double*> add_particular_at = Nothing();
};

struct Reduction;

struct RigidPart { // model/validate/validate_rigid.cpp, results/rigid.cpp, solver/energy/energy_rigid.cpp
  bool linked = false;
  decltype(&c2d_set_rigid) set_rigid = nullptr;
  decltype(&c2d_set_rigid_load) set_rigid_load = nullptr;
  decltype(&c2d_add_platen) add_platen = nullptr;
  Function<void, const Model&, int, Reporter&> check_rigid = Nothing();
  Function<void, const Model&, int, Reporter&> check_rigid_zones = Nothing();
  Function<c2d_status, const Reduction&, int> reduce_rigid = NotLinked();
  Function<void, const Model&, int, int32_t, Real*> add_rigid_motion = Nothing();
  Function<void, const Session&, int> fill_rigid = Nothing();
  Function<void, const Session&, int, double, double, double*> rigid_displacement_now = Nothing();
  Function<void, const Session&, int, double*> rigid_motion_now = Nothing();
};

struct DemandedColumns;
struct Form;

struct EnergyPart { // solver/energy*.cpp, motion.cpp, pressed_motion.cpp, results/balance.cpp
  bool linked = false;
  Function<c2d_status, c2d_solver*> build_energy = NotLinked();
  Function<void, Session&, int, const DemandedColumns&> add_demanded = Nothing();
  Function<void, Session&, const Form&, int32_t, const Real*> hold_demanded = Nothing();
  Function<double*, c2d_solver*> work_by_case = Nothing();
  Function<void, c2d_solver*> begin_energy = Nothing();
  Function<void, Session&, const double*> note_turn = Nothing();
  Function<void, Session&, double> add_segment = Nothing();
  Function<void, Session&> before_jump = Nothing();
  Function<void, Session&> after_jump = Nothing();
  Function<void, Session&> release = Nothing();
  Function<void, Session&> close_balance = Nothing();
  Function<void, Session&, c2d_outcome> find_outcome_motion = Nothing();
  Function<void, Session&> balance_forces = Nothing();
  Function<void, const Session&, int, int32_t, const double*> add_boundary_force = Nothing();
};

enum class Moment;

struct WarningPart { // results/warnings/warnings.cpp and what it asks, solver/condition.cpp
  bool linked = false;
  Function<void, Session&, Moment> warn_contact = Nothing();
  Function<void, Session&> warn_facing_meshes = Nothing();
  Function<void, Session&> warn_not_unique = Nothing();
  Function<void, c2d_solver*> warn_breach = Nothing();
  Function<c2d_status, c2d_solver*> find_condition = Nothing();
  Function<void, c2d_solver*> warn_condition = Nothing();
  Function<void, c2d_solver*, const double*, int32_t> tell_unheld = Nothing();
};

struct Follower;
struct PathScales;
struct Tableau;

struct SearchPart { // contact/rates/search.cpp, limit_analysis.cpp, let_go.cpp, start.cpp
  bool linked = false;
  Function<c2d_status, Follower&, bool, int32_t*> try_all = Nothing();
  Function<c2d_status, Follower&, bool, c2d_outcome*> decide = Nothing();
  Function<void, Follower&> place_in_range = Nothing();
  Function<bool, const Tableau&, const int32_t*, int32_t> place_body = Nothing();
  Function<bool, const Tableau&, const int32_t*, int32_t> may_rest = Nothing();
  Function<bool, const Tableau&, int32_t, Real*> rest_along = Nothing();
  Function<c2d_status, Follower&, bool> rest_again = Nothing();
  Function<c2d_status, Follower&, const PathScales&> note_idle = Nothing();
  Function<bool, Follower&> slides_without_force = Nothing();
  Function<c2d_status, Follower&, bool*> try_let_go = Nothing();
  Function<c2d_status, Follower&, bool*, c2d_outcome*> hold_again = Nothing();
  Function<c2d_status, Follower&, int32_t, c2d_outcome*> seat = Nothing();
};

struct EliminationPlan;
struct ColumnSource;
struct RowSink;
struct Tapes;
struct Watch;
struct Engine;

struct NewLoadsPart { // of elimination/eliminate.cpp, contact/reduction/reduction.cpp
  bool linked = false;
  Function<c2d_status, const EliminationPlan&, int32_t, const ColumnSource&, const RowSink&, Tapes&, void*, const Watch&,
           const Engine&>
      eliminate_again = NotLinked();
  Function<c2d_status, const Reduction&> reduce_loads = NotLinked();
};

struct PhaseSizes;
struct Sizes;
struct TapeUse;
struct PivotStats;

struct Points;

struct CompressedPart { // solver/demand/compressed.cpp with elimination/compressed*.cpp, cells.cpp, stream.cpp,
                        // bie/integrals/chosen.cpp, results/interior/interior_cells.cpp with bie/far_field.cpp
  bool linked = false;
  Function<int32_t, const Sizes&> elimination_by_size = Nothing(); // C2D_ELIMINATION_DENSE
  Function<c2d_status, const PhaseSizes&, uint64_t, const Model&, EliminationPlan*> plan_compression = NotLinked();
  Function<uint64_t, const PhaseSizes&, int32_t> compression_that_will_do = Nothing();
  Function<c2d_status, const PhaseSizes&, uint64_t, bool, TapeUse&> compression_tape = NotLinked();
  Function<bool, const Model&, int, const EliminationPlan&> is_compression_of = Nothing();
  Function<uint64_t, const Model&, int, const EliminationPlan&> compression_bytes = Nothing();
  Function<uint64_t, const Model&, int, const EliminationPlan&> compression_back_bytes = Nothing();
  Function<uint64_t, const Model&, int, const EliminationPlan&> later_bytes = Nothing();
  Function<void, const Model&, int, const EliminationPlan&, TapeUse&, TapeUse&> compression_uses = Nothing();
  Function<c2d_status, const EliminationPlan&, const ColumnSystem&, const RowSink&, Tapes&, void*, PivotStats*, int32_t*,
           const Watch&, const Engine&>
      compress = NotLinked();
  Function<c2d_status, Session&, int> solve_compressed = NotLinked();
  Function<c2d_status, Session&, int, Real*, Real*> compression_functional = NotLinked();
  Function<c2d_status, Session&, int, double*> compression_growth = NotLinked();
  Function<void, c2d_solver*, const Model&> plan_demand = Nothing();
  Function<c2d_status, c2d_solver*> tell_touching = NotLinked();
  Function<c2d_status, c2d_solver*> respond_on_demand = NotLinked();
  Function<c2d_status, void*, const int32_t*, int32_t> make_columns = NotLinked();
  Function<c2d_status, c2d_solver*, bool> hold_on_demand = NotLinked();
  Function<c2d_status, c2d_solver*> count_held = NotLinked();
  Function<c2d_status, c2d_solver*> remake_columns = NotLinked();
  Function<c2d_status, const Session&, int, const Real*, Real*> functional_of_motions = NotLinked();
  Function<c2d_status, const Session&, const Real*, Real*, double*> hold_functional = NotLinked();
  Function<c2d_status, const Session&> fit_rigid = NotLinked();
  Function<bool, const Session&, int> has_far_cells = Nothing();
  Function<c2d_status, const Session&, int, const Points&> evaluate_by_cells = NotLinked();
};

struct CyclePart { // interface/path_cycle_calls.cpp, solver/cycle.cpp: a cycle of c2d_run
  bool linked = false;
  decltype(&c2d_repeat_paths) repeat_paths = nullptr;
  Function<void, Session&, int32_t> begin_run = Nothing();
  Function<c2d_status, Session&, int32_t, c2d_status (*)(Session&, int32_t)> repeat = NotLinked();
};

extern const SymmetryPart kSymmetryPart;     // interface/model/symmetry_calls.cpp
extern const FreeZonePart kFreeZonePart;     // free_zone_calls.cpp
extern const HolePart kHolePart;             // hole_calls.cpp
extern const RingPart kRingPart;             // ring_calls.cpp
extern const CurvePart kCurvePart;           // curves.cpp
extern const BodyForcePart kBodyForcePart;   // body_force_calls.cpp
extern const RigidPart kRigidPart;           // rigid_calls.cpp
extern const EnergyPart kEnergyPart;         // summary.cpp
extern const WarningPart kWarningPart;       // warning_calls.cpp
extern const SearchPart kSearchPart;         // search_calls.cpp
extern const NewLoadsPart kNewLoadsPart;     // new_loads_calls.cpp
extern const CompressedPart kCompressedPart; // compressed_calls.cpp
extern const CyclePart kCyclePart;           // path_cycle_calls.cpp

} // namespace c2d

#if C2D_PARTS_MAY_LACK
#define C2D_USES(Part)                                                                                                         \
  extern const Part k##Part __attribute__((weak));                                                                             \
  const Part k##Part = {}
#define C2D_BRINGS(call) __attribute__((used)) static decltype(&call) const brings_##call = &call
#else
#define C2D_USES(Part) static_assert(true, "always linked")
#define C2D_BRINGS(call) static_assert(true, "always linked")
#endif
#if C2D_ONLY_CALLS_BRING
#define C2D_MEETS(Part, call) C2D_USES(Part)
#else
#define C2D_MEETS(Part, call) C2D_BRINGS(call)
#endif
// The same of a part that small code meets only in programs that call it.
#if C2D_SMALL_CODE
#define C2D_MEETS_IN_FULL(Part, call) C2D_USES(Part)
#else
#define C2D_MEETS_IN_FULL(Part, call) C2D_MEETS(Part, call)
#endif
