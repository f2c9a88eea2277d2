// Structs of the public header in the caller's memory: they begin with their size, which may be that of another version of the
// library. Only the part that both versions know is copied.
#include "memory/structs.hpp"

#include <string.h>

namespace c2d {

namespace {

constexpr uint32_t kLargest =
    65536; // no version's struct is larger, and memory that was never set usually contains larger numbers

uint32_t size_of(const void* theirs) {
  uint32_t size;
  memcpy(&size, theirs, sizeof size);
  return size;
}

} // namespace

// The size is copied out, because the caller's struct need not be aligned for this library's view of it.
bool is_begun(const void* theirs) {
  if (!theirs) return false;
  const uint32_t size = size_of(theirs);
  return size >= sizeof size && size <= kLargest && size % sizeof size == 0;
}

void put_not_begun(Text& text, const char* name, const void* theirs) {
  if (!theirs)
    put_all(text, name, " is null");
  else
    put_all(text, name, ".struct_size is ", size_of(theirs), ", expected C2D_INIT(", name, ")");
}

void copy_out(const void* ours, size_t our_size, void* theirs) {
  const uint32_t size = size_of(theirs);
  const size_t bytes = size < our_size ? size : our_size;
  memcpy(static_cast<char*>(theirs) + sizeof size, static_cast<const char*>(ours) + sizeof size, bytes - sizeof size);
}

void copy_in(const void* theirs, void* ours, size_t our_size) {
  const uint32_t size = size_of(theirs), our_mark = static_cast<uint32_t>(our_size);
  memset(ours, 0, our_size);
  memcpy(ours, theirs, size < our_size ? size : our_size);
  memcpy(ours, &our_mark, sizeof our_mark);
}

} // namespace c2d
