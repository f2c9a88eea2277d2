#pragma once
// <math.h> as C has it. That of GNU's C++ library adds overloads and, since C++17, special functions: 20,000 lines in every
// file.
#define _GLIBCXX_INCLUDE_NEXT_C_HEADERS // by which that library leaves its own out
#include <math.h>
#undef _GLIBCXX_INCLUDE_NEXT_C_HEADERS
