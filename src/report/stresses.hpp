// Stresses on the boundary and at interior points at every recorded step, and their ranges over a load cycle.
#pragma once

#include "post/summary.hpp"
#include "report/record.hpp"

#include <contact2d.h>

#include <string>
#include <vector>

namespace app {

// An end of an element, or a point inside: the other number is 0.
struct StressPlace {
  int32_t body, element, point; // from 1
  double x, y;
  bool of_grid; // omitted if outside
};
// Of each place: sxx, syy, sxy, szz, and the normal stress along the boundary, NaN inside; all of them NaN outside the body.
constexpr size_t kStressNumbers = 5;

// The ends of all elements, in the order of --boundary, and what c2d_get has of them; added to `out`. Both return the status of
// the first call that failed. In a run's step, or behind it.
c2d_status add_end_places(c2d_solver* solver, const Summary& summary, std::vector<StressPlace>& out);
c2d_status add_end_stresses(c2d_solver* solver, const Summary& summary, std::vector<double>& out);
// Of a row of C2D_POINT_FIELDS numbers.
void add_point_stresses(const double* row, std::vector<double>& out);

// mu,step,load,body,element,point,x,y,sxx,syy,sxy,szz,hoop,s1,s2,von_mises[,load2 ...], part of the program's contract.
void append_stresses_header(std::string& out, int32_t load_cases);
void append_stresses_rows(std::string& out, const c2d_step& step, const std::vector<StressPlace>& places,
                          const std::vector<double>& numbers);

// mu,first,last,body,element,point,x,y,hoop_least,hoop_most,s1_least,s1_most,von_mises_most,von_mises_range: over the last
// whole cycle, or over all recorded steps where there is none, from `first` to `last`; of steps whose `stresses` were kept.
void append_ranges(std::string& out, const RunRecord& record, const std::vector<StressPlace>& places);

} // namespace app
