#pragma once
// The contact system with every pair open, METHOD 10.11. All bodies are solved for, and A of METHOD (10.3) is the tableau as it
// stands, but for a few slots, `held`, in which the motions of the bodies that no support prevents are given instead of forces.
// Two products and a solution of the size of A are never made.
#include "contact/basis.hpp"
#include "contact/reduction/reduction.hpp"

namespace c2d {

// With A in r.first and on the tape, and R and G of all motions there: T. C2D_ERR_SINGULAR, and nothing is written: no slots
// hold the motions, or a body bends so much more than it gives way locally that A has lost digits.
c2d_status form_open_stiffness(const Reduction& r);
// With h on the tape: the rates of the loads, and the basis behind all else. Uses r.second and the strip.
c2d_status form_open_rates(const Reduction& r);

} // namespace c2d
