// What the outputs of a run are written from.
#pragma once

#include "post/corners.hpp"
#include "post/cracks.hpp"
#include "post/zone_line.hpp"
#include "program/files/path_record.hpp"
#include "program/interior_points.hpp"
#include "program/session.hpp"
#include "report/pictures/pictures.hpp"
#include "report/record.hpp"
#include "report/stresses.hpp"

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

// One call of the step callback.
struct StepResults {
  const c2d_step& step;
  CoefficientRecord* record; // null: a change of status that only outputs with kNeedsChanges show
  bool adds_row;             // to tables: a path that ended in the state of its last row adds none
};

struct RunResults {
  // `begun`: seconds of the clock.
  RunResults(Session& session_, double begun_) : session(session_), begun(begun_) {}
  // What the outputs of these needs use of the model, which is complete.
  c2d_status begin(uint32_t needs);
  // Keeps a step, inside the callback.
  c2d_status take(const c2d_step& step, StepResults& now);
  // The last state: corners and points; with those reported, warnings in order and pictures.
  c2d_status finish();
  c2d_status draw();
  // No solvable equations: all coefficients of friction end without a result.
  void stop_before_load(c2d_status status);
  // Summary and times of now.
  c2d_status refresh();
  // Since the run began, that the phases of the library have not taken, by the last summary: all of the time is some phase's.
  double time_left() const;
  // Of every load case, by the last coefficient of friction.
  std::vector<double> loads_reached() const;

  Session& session;
  const double begun;
  uint32_t needs = 0;             // of all outputs (OutputNeeds)
  bool has_short_listing = false; // on a terminal without --listing
  bool shows_changes = false;     // the deck wants every change of status in the listing
  bool solved = false;            // the solver has a last state
  Summary summary;
  RunRecord record;
  PathRecord path; // its history only if there will be pictures; its coefficients are those of record
  InteriorPoints interior;
  std::vector<std::vector<ContactEnd>> ends; // of each body
  std::vector<CrackTip> tips;
  std::vector<ZoneLine> lines;
  std::vector<Corner> corners;
  std::vector<StressPlace> places; // of --stresses and --ranges,
  std::vector<double> stresses;    // there, at the last row
  Scene scene;
  Pictures pictures;

private:
  c2d_status read_stresses();
};

} // namespace app
