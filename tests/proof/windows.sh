#!/bin/sh
# windows.sh: the program for Windows in wine, and by MinGW a library without files and threads with a host in C.
set -e
export C2D_ALL_HOSTS=1 WINEPREFIX="$PWD/build/windows/wine" WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml=
mkdir -p build/windows build/mingw
$MAKE -s windows
$MAKE -s build/tests/only/windows
build/tests/only/windows
$MAKE -s PORTS=memory BUILD=build/mingw CXXFLAGS=-O0 CXX=x86_64-w64-mingw32-g++ AR=x86_64-w64-mingw32-ar
x86_64-w64-mingw32-gcc -std=c99 -Iinclude examples/model_by_calls.c build/mingw/libcontact2d.a -lm -o build/mingw/model.exe
wine build/mingw/model.exe | grep restored
