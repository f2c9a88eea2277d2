#pragma once
// Structs of the header in the caller's hands: they begin with the size that C2D_INIT wrote, which may be that of another
// version.
#include <stddef.h>

#include "memory/text.hpp"

namespace c2d {

// Is there a struct, with a size that C2D_INIT can have written?
bool is_begun(const void* theirs);
// What is wrong with one that is not: "NAME is null", or its size.
void put_not_begun(Text& text, const char* name, const void* theirs);
// Copy what both sides know of a struct that is begun. The caller's size stays; what its version lacks is 0 on our side.
void copy_out(const void* ours, size_t our_size, void* theirs);
void copy_in(const void* theirs, void* ours, size_t our_size);

} // namespace c2d
