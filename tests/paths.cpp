#include "paths.hpp"

namespace paths {

std::string root() { return C2D_TEST_ROOT; }
std::string data() { return root() + "/tests/data"; }
std::string build() { return C2D_TEST_BUILD; }
std::string c_compiler() { return C2D_TEST_CC; }
std::string cxx_compiler() { return C2D_TEST_CXX; }
std::string library() { return C2D_TEST_LIBRARY; }
std::string core() { return C2D_TEST_CORE; }
std::string shared() { return C2D_TEST_SHARED; }
std::string program() { return C2D_TEST_PROGRAM; }
std::string chapter9() { return C2D_TEST_CHAPTER9; }
bool hardened() { return C2D_TEST_HARDENED != 0; }

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
bool sanitized() { return true; }
#else
bool sanitized() { return false; }
#endif

} // namespace paths
