#pragma once
// Small code, as firmware wants it: plain forms alone, nothing twice for speed. -Os asks for it too.
#if defined(__OPTIMIZE_SIZE__) && !defined(C2D_SMALL)
#define C2D_SMALL
#endif

namespace c2d {

#ifdef C2D_SMALL
constexpr bool kSmallCode = true;
#else
constexpr bool kSmallCode = false;
#endif

} // namespace c2d
