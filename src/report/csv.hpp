// The CSV outputs. Columns and their meaning are part of the program's contract.
#pragma once

#include "post/summary.hpp"
#include "report/record.hpp"

#include <contact2d.h>

#include <string>

namespace app {

// With several load cases tables of steps have their other factors at the end, load2, load3, ...

// Names of the columns: kContactColumns.
void append_contact_header(std::string& out, int32_t load_cases);
// A row per pair of a recorded or last step.
void append_contact_rows(std::string& out, const c2d_step& step, const Summary& summary);

// Names of the columns: kBodyColumns.
void append_bodies_header(std::string& out, int32_t load_cases);
// A row per body of a recorded or last step; inside the callback.
void append_bodies_rows(std::string& out, const c2d_step& step, c2d_solver* solver);

// mu,step,load,zone,name,quantity,item,value,x,y,error,s,along, the factors of other load cases,
// plane_angle,worst_case,root_of_squares: key numbers of the contact at every recorded step of a run, with the stated errors; a
// field without a value is empty.
void append_summary(std::string& out, const RunRecord& record, const Summary& summary);

// body,element,node,x,y,ux,uy,tx,ty with a row per element end of every body at the load reached.
void append_boundary_header(std::string& out);
c2d_status append_boundary(std::string& out, c2d_solver* solver, const Summary& summary);

} // namespace app
