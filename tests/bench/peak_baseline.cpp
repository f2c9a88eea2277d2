#define PEAK_BYTES 16
#define PEAK_SUMS 12
#define PEAK_NAME peak_baseline
#include "peak_loop.hpp"
