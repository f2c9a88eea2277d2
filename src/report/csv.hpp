// The CSV outputs. Columns and their meaning are part of the program's contract.
#pragma once

#include "report/record.hpp"

#include <contact2d.h>

#include <string>

namespace app {

// mu,step,load,pair,x,y,status,tn,tt,un1,ut1,un2,ut2,gap,slip
void append_contact_header(std::string& out);
// A row per pair of a recorded or last step.
void append_contact_rows(std::string& out, const c2d_step& step);

// body,element,node,x,y,ux,uy,tx,ty with a row per element end of every body at the load reached.
void append_boundary_header(std::string& out);
c2d_status append_boundary(std::string& out, c2d_solver* solver, const Summary& summary);

} // namespace app
