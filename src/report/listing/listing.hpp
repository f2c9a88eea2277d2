// The printed results, in the order of the 1987 program: the data read, a block per increment, the contact
// zones body by body at the end of each coefficient of friction, all element ends at the end of the run, and
// the balance.
#pragma once

#include "report/record.hpp"

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

// Title, heading cards, control data, materials, node coordinates, conditions, point loads, zones, load
// cards. Needs a complete model.
c2d_status append_model(std::string& out, c2d_solver* solver, const Summary& summary, const std::vector<std::string>& heading);
// The statuses of all pairs after an increment, after a change of status, or where the path ended; `first` of
// its coefficient of friction: with a heading.
void append_step(std::string& out, const c2d_step& step, bool first);
// Where stress is singular at the last state, by which power it grows and its intensity; nothing where there is no such corner.
void append_corners(std::string& out, const RunRecord& record, const Summary& summary);
// Contact results of every body at the last state of a coefficient; `ends` of each body.
void append_contact_zone(std::string& out, const CoefficientRecord& coefficient, const std::vector<ContactEnd>* ends,
                         const Summary& summary);
// Displacements and tractions of all element ends in global components at the load reached: `loads`, of every case.
c2d_status append_global(std::string& out, c2d_solver* solver, const Summary& summary, const std::vector<double>& loads);
// Key numbers of the contact at the last state of every coefficient, with their stated errors.
void append_quantities(std::string& out, const RunRecord& record, const Summary& summary);
// The same step by step, of every zone.
void append_key_tables(std::string& out, const RunRecord& record, const Summary& summary);
// The meshes that were tried for a sketch, and the numbers with their stated errors; nothing if there was one mesh alone.
void append_accuracy(std::string& out, const RunRecord& record);
// How wanted numbers change with parameters that have tolerances; nothing if none has.
void append_tolerances(std::string& out, const RunRecord& record);
// Cycles of the load path: nothing where there is none; `all`: a row for each.
void append_cycles(std::string& out, const RunRecord& record, const Summary& summary, bool all);
// Angles, torques and slip of loads round the axis; nothing if there are none.
void append_torsion(std::string& out, const RunRecord& record);
// Balance of forces, key numbers of the contact, warnings, and outcome of the run.
void append_ending(std::string& out, const RunRecord& record, const Summary& summary);
// Its essential part, for a terminal that already shows the warnings.
void append_short_ending(std::string& out, const RunRecord& record, const Summary& summary);

} // namespace app
