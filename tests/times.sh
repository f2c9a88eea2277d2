#!/bin/sh
# times.sh FOLDER: the processor seconds that make test-times left there: sources (FOLDER/sources), the 40 slowest tests (FOLDER/tests), sums.
cd "$1" || exit 1
sum() { awk '{ s += $1 } END { printf "%.1f s of a processor: %s of %d\n", s, what, NR }' what="$1" "$2"; }
echo 'objects and programs, as they are compiled and linked:'
sort -rn sources
echo 'the 40 slowest tests:'
sort -rn tests | head -40
sum 'compiling and linking' sources
sum 'tests' tests
