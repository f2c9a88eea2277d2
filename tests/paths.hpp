// Where the build put things, and with what. One file alone is given them (paths.cpp), so that the other objects of the
// tests are the same in every copy of the tree.
#pragma once

#include <string>

namespace paths {

std::string root();       // the project
std::string data();       // its tests/data
std::string build();      // the folder of this build
std::string c_compiler(); // with flags, perhaps
std::string cxx_compiler();
std::string library();  // libcontact2d.a
std::string core();     // the library without ports, where it is one of its own
std::string shared();   // libcontact2d.so.VERSION
std::string program();  // contact2d
std::string chapter9(); // the program of examples/chapter9
bool hardened();        // port/packaging/hardening.mk
bool sanitized();       // address and undefined-behaviour sanitizers are in library and program

} // namespace paths
