// Forces and moments of a body: of the modelled part, and of the whole if a line of symmetry cuts it.
#pragma once

#include "post/quantities.hpp"
#include "post/summary.hpp"

#include <string>
#include <vector>

namespace app {

struct BodyTotal {
  std::string of; // "loads and supports", "contact", "lines of symmetry", "sum", or the same of the whole body
  double force[3];
  bool is_sum = false; // zero but for round-off and the error of the solution
};

// The lines of symmetry that a body, from 1, meets: 1 x, 2 y, 3 both.
int32_t lines_that_cut(const Summary& summary, int32_t body);

// Of a body, from 1: a force and its moment about the origin, with the images of the modelled part.
BodyTotal whole_of(const Summary& summary, int32_t body, const double (&part)[3], const std::string& of = "");

// Body from 1. If the body meets lines of symmetry, their share completes the balance of the part, and there are totals of the
// whole, too, which of a body that meets both are zero; a body beside the lines is whole.
std::vector<BodyTotal> totals_of(const Summary& summary, int32_t body);

// The numbers of a table, in their order. The force along a line of symmetry in a zone whose body the line cuts is followed by
// that of the whole contact.
struct TableNumber {
  Quantity is;
  const char* of; // behind its name: "", or ", whole"
};
std::vector<TableNumber> with_wholes(const std::vector<Quantity>& all, const Summary& summary);

// "of the modelled part", "of the whole circumference", or both; empty: forces are simply those of the model.
std::string whose_forces(const Summary& summary);

// What the rows mean, with lines of symmetry; else empty.
const char* words_of_totals(const Summary& summary);

} // namespace app
