#define PEAK_BYTES 64
#define PEAK_SUMS 16
#define PEAK_NAME peak_avx512
#include "peak_loop.hpp"
