#pragma once
// One fault or warning while it is being put together. The text is written in place, so a Finding never
// moves.
#include "memory/config.hpp"
#include "memory/text.hpp"
#include "model/validate.hpp"

namespace c2d {

struct Finding {
  Finding();                        // a fault
  explicit Finding(int32_t number); // a warning
  Finding(const Finding&) = delete;
  Finding& operator=(const Finding&) = delete;
  c2d_error entry;
  Text text; // in entry.text
};
inline Finding fault() { return Finding(); }
inline Finding warning(int32_t number) { return Finding(number); }

// Appends characters and numbers.
template <class... Parts> C2D_IN_PLACE inline void say(Finding& finding, Parts... parts) { put_all(finding.text, parts...); }

// Where it is. Arguments count from 0, the entry's numbers from 1; a line that is not known stays 0.
void locate_point(Finding& finding, const Model& m, int b, int32_t geometry_point);
void locate_element(Finding& finding, const Model& m, int b, int32_t element);
void locate_node(Finding& finding, const Model& m, int b, int32_t node); // functional
void locate_zone(Finding& finding, const Model& m, int32_t zone);
void locate_pair(Finding& finding, const Model& m, int32_t pair); // with its zone

// ---- optional parts of validate_loads (memory/parts.hpp) ----
// A body force that is not symmetric has no part in a symmetric model.
void check_body_force(const Model& m, int b, int32_t load_case, Reporter& reporter);
// A rigid body 1 takes no loads and moves by its cards alone, as the lines of symmetry allow.
void check_rigid(const Model& m, Reporter& reporter);

// Hands it over and counts faults.
void tell(Reporter& reporter, const Finding& finding);

} // namespace c2d
