#pragma once
// C's own <math.h>. The GNU C++ library adds overloads and, since C++17, special functions: 20,000 lines in every file.
#define _GLIBCXX_INCLUDE_NEXT_C_HEADERS // makes that library omit its own header
#include <math.h>
#undef _GLIBCXX_INCLUDE_NEXT_C_HEADERS
