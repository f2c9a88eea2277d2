#!/bin/sh
# cmake.sh: library, program and tests by CMake and clang++, each file by itself, warnings as errors; and the suite.
set -e
CXXFLAGS=-Werror cmake -S . -B build/proof/cmake -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=None
cmake --build build/proof/cmake --parallel "$(nproc)"
ctest --test-dir build/proof/cmake --output-on-failure
