// Saved states and tapes from strangers: changed bytes, and such as are sealed again with right checksums.
#include "forged_state.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  forged::run(data, size);
  return 0;
}
