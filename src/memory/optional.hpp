#pragma once
// Parts of the core that only some models or programs need: free zones, body forces, a rigid body 1, symmetry, what the
// summary tells, new loads. A linker leaves them out where no call that declares one is linked
// (port/cortex-m/README.md).
//
// A part has object files of its own. Who uses it where a model has one names what it calls with C2D_OPTIONAL: such a
// reference brings no object file into a link. The call that declares the part names one function of each of its files
// with C2D_BRINGS. So an optional function is called only after asking whether the model has the part: a
// model can have it only if the call that declares it was linked. C2D_LINKED tells whether the program has it.
// Where a header names a function with C2D_OPTIONAL, C2D_BRINGS must name another one of that file.
//
// What brings models of any kind (the deck reader, c2d_attach, options) names one function of each part with C2D_NEEDS,
// which links it. In a library compiled with C2D_PARTS_BY_CALL, for firmware, it does not: only the declaring calls do,
// and what C2D_HAS denies is refused.
// Needs ELF, an archive of objects and GCC or clang; elsewhere, and in one file, everything is linked.
#include "memory/config.hpp"

#if C2D_PARTS_MAY_LACK
#define C2D_OPTIONAL(function) extern decltype(function) function __attribute__((weak))
#define C2D_LINKED(function) (&function != nullptr)
#define C2D_BRINGS(function) __attribute__((used)) static decltype(&function) const brings_##function = &function
#else
#define C2D_OPTIONAL(function) static_assert(true, "always linked")
#define C2D_LINKED(function) true
#define C2D_BRINGS(function) static_assert(true, "always linked")
#endif

#if C2D_ONLY_CALLS_BRING
#define C2D_NEEDS(function) C2D_OPTIONAL(function)
#define C2D_HAS(function) C2D_LINKED(function)
#else
#define C2D_NEEDS(function) C2D_BRINGS(function)
#define C2D_HAS(function) true
#endif
