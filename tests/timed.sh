#!/bin/sh
# timed.sh COMMAND...: runs it, and appends to the file C2D_COMPILE_TIMES the processor seconds that it took and what stands behind its
# -o (make test-times).
"$@"
status=$?
[ -n "$C2D_COMPILE_TIMES" ] || exit $status
out=
for word; do
  [ "$out" != -o ] || { out=$word; break; }
  [ "$word" != -o ] || out=-o
done
case $out in *.o | */run_tests | */contact2d | *.so.*) ;; *) exit $status ;; esac
times >"$C2D_COMPILE_TIMES.$$"
sed -n '2s/m/ /g; 2s/s//g; 2p' "$C2D_COMPILE_TIMES.$$" |
  awk -v out="${out#"${C2D_TIMES_WITHOUT:-}"}" '{ printf "%.2f %s\n", $1 * 60 + $2 + $3 * 60 + $4, out }' >>"$C2D_COMPILE_TIMES"
rm -f "$C2D_COMPILE_TIMES.$$"
exit $status
