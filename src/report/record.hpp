// Data of a run for the reports: a record per coefficient of friction, the warnings, and the map
// from pairs to element ends.
#pragma once

#include "post/corners.hpp"
#include "post/cracks.hpp"
#include "post/cycles.hpp"
#include "post/mesh_loop.hpp"
#include "post/quantities.hpp"
#include "post/summary.hpp"
#include "report/inputs.hpp"
#include "report/interior.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>
#include <vector>

namespace app {

// Energy, load factors and zones at the end of an increment.
struct StepRecord {
  int32_t step = 0;
  std::vector<CornerState> corners; // of contacts and ties, where stress is singular
  double work = 0.0, dissipated = 0.0, elastic = 0.0, defect = 0.0;
  std::vector<double> loads, work_by_case;
  std::vector<c2d_zone_state> zones;
  std::vector<c2d_body_state> bodies;
  std::vector<StressIntensity> cracks;
  std::vector<Quantity> quantities;
  std::vector<double> stresses; // at the places of --ranges (report/stresses.hpp), if that is wanted
};

// The same cycle from a start without friction, if the two are to be compared.
struct OtherStart {
  CycleSeen last;
  double apart = 0;  // of pressures and friction at the end, relative to the largest pressure
  bool same = false; // as far as the cycles are steady
  std::string why;   // it is not known
};

// Progress of one coefficient of friction, with the table of pairs at its last valid state.
struct CoefficientRecord {
  double mu = 0.0;
  double load = 0.0;                      // load factor reached, of the first load case
  std::vector<double> loads;              // the same of every load case
  int32_t step = 0;                       // the last increment reached, or the one in which the path ended
  int32_t changes = 0;                    // changes of status, all steps
  c2d_outcome outcome = C2D_REACHED;      //
  bool singular = false;                  // no solution at all: c2d_prepare found no pivot
  std::string why;                        // if the path ended early
  int32_t body = 0, pair = 0;             // then: the body that can move, the pair whose status changed last
  std::vector<double> table;              // C2D_PAIR_FIELDS numbers per pair
  std::vector<StepRecord> steps;          // as many as were recorded
  std::vector<CycleSeen> cycles;          // of the load path's cycle, before the recorded one
  std::vector<StepRecord> cycle_start;    // none or one: the state at which the recorded cycle begins, after the step before it
  std::vector<OtherStart> other_start;    // none or one
  std::vector<double> slip, slip_at_turn; // C2D_SLIP_SUM of the pairs at the last step, and where the loads last turned
};

struct RunRecord {
  Inputs inputs;
  std::vector<CoefficientRecord> coefficients;
  std::vector<double> friction;      // all coefficients of the deck
  std::vector<double> zone_friction; // of each zone, with the first coefficient; infinite: full adhesion
  std::vector<c2d_error> warnings;
  std::vector<int32_t> measure;                   // of each zone: the body per whose length tn and tt are
  MeshLoop meshes;                                // how the mesh was found, and errors of the first coefficient's last step
  const Interior* interior = nullptr;             // results inside; null if none were asked for
  double read_seconds = 0.0, write_seconds = 0.0; // of the program, and what is no other phase's
  bool checked_only = false;                      // the deck asks for a data check, nothing was solved

  // The first coefficient whose path ended early; null if all reached their load.
  const CoefficientRecord* incomplete() const;
  // The first whose cycle is not steady at its limit.
  const CoefficientRecord* unsteady() const;
  // Gives the quantities of the first coefficient's last step the errors that `meshes` states.
  void take_stated_errors();
  // One word for the whole run.
  const char* outcome() const;
  std::vector<CornerState> corners; // all of the last state where stress is singular
};

// A record is kept of every increment and coefficient of friction: so many at most.
constexpr int64_t kMostSteps = 500000;
// A fault of their number, before anything is solved; empty: none.
std::string fault_of_steps(const c2d_summary& model);

// Stores the data of a step callback. Returns the record of its coefficient.
CoefficientRecord& keep_step(RunRecord& record, const c2d_step& step);
// The data of a step of kind C2D_STEP_CYCLE.
c2d_status keep_cycle(RunRecord& record, const c2d_step& step, c2d_solver* solver, int32_t zones);
// The state at its end, where the recorded cycle may begin; `solver` as in keep_history.
void keep_cycle_start(CoefficientRecord& coefficient, const c2d_step& step, c2d_solver* solver,
                      const std::vector<ZoneLine>& lines);
// "steady in cycle 7: it shakes down ...", of a coefficient with cycles; a word for a result of C2D_CYCLE_...; why a run whose
// cycle is not steady has failed.
std::string cycle_text(const CoefficientRecord& coefficient, const Summary& summary);
const char* cycle_word(int32_t result);
// Whether the other start ends elsewhere, of a coefficient that has one.
std::string other_start_text(const CoefficientRecord& coefficient);
std::string unsteady_text(const CoefficientRecord& coefficient, const Summary& summary);
// "load factor 1", or "load factors 1, 0.3": loads reached by a coefficient, of every load case.
std::string load_reached(const CoefficientRecord& coefficient);
// "incomplete: mu 0.3, step 2, load factor 0.5: why".
std::string incomplete_text(const CoefficientRecord& coefficient);
// A path that ended in the state of its last row has that state twice: is it the first of the two?
bool is_repeated(const CoefficientRecord& coefficient, size_t step);
// The same step's energy, its stress intensities and, unless solver is null, its zones, its bodies and what sums up its
// contact; inside the callback.
void keep_history(CoefficientRecord& coefficient, const c2d_step& step, c2d_solver* solver, const std::vector<CrackTip>& tips,
                  const std::vector<ZoneLine>& lines);

// Why a path ended, in one line: the outcome, the body and its motion, the last pair; `said` is the
// message of the library, may be empty. Sets why, body and pair of the record.
void explain(CoefficientRecord& coefficient, const c2d_summary& now, const Summary& model, const std::string& said);

// Corner states from the table of a step; after keep_history.
void keep_corners(CoefficientRecord& coefficient, const c2d_step& step, const std::vector<Corner>& corners);

// An end of a contact element of a zone, and the pair (from 1) and its side (1 or 2) that its node belongs to;
// on side 1 of a zone between meshes that do not match local is 0, and eta the pair's place on the element.
struct ContactEnd {
  int32_t zone, element, local, pair, side;
  double x, y, eta;
};
// The ends of all contact elements at listed pairs, of one body, in the order of the zones that it is part of.
// Returns the status of the first query that failed.
c2d_status find_contact_ends(c2d_solver* solver, const Summary& summary, int32_t body, std::vector<ContactEnd>& ends);

} // namespace app
