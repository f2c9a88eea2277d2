#pragma once
// Structs of the public header in the caller's memory: they begin with the size that C2D_INIT wrote, which may be that of
// another version.
#include <stddef.h>

#include "memory/text.hpp"

namespace c2d {

// Is there a struct whose size C2D_INIT can have written?
bool is_begun(const void* theirs);
// The fault of a struct that is not begun: "NAME is null", or its size.
void put_not_begun(Text& text, const char* name, const void* theirs);
// Copies the part of a begun struct that both sides know. The caller's size stays; members that its version lacks are 0 on our
// side.
void copy_out(const void* ours, size_t our_size, void* theirs);
void copy_in(const void* theirs, void* ours, size_t our_size);

} // namespace c2d
