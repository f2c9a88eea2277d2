#!/bin/sh
# run_shards.sh PROCESSORS PROGRAM...: the tests of each program in pieces, one process more at once than there are processors, as some
# wait more than they compute, in an order that mixes slow and quick ones (C2D_TESTS_SEED=NUMBER: another one).
# Prints what each prints, then the totals of all: N passed, N failed. C2D_TESTS_NOT names files with patterns of names of tests
# or of files (test_NAME.cpp) that do not run (the rest of the line after | says why), C2D_TESTS_FILES patterns of files, with commas,
# whose tests alone run.
workers=$(($1 + 1))
shift
pieces=$((workers * 12))
not= not_files=
if [ -n "${C2D_TESTS_NOT:-}" ]; then
  not=$(sed -n '/^#/d; /^test_[a-z0-9_]*\.cpp /d; s/ *|.*//p' $C2D_TESTS_NOT | paste -s -d , -)
  not_files=$(sed -n 's/^\(test_[a-z0-9_]*\.cpp\) *|.*/*\1/p' $C2D_TESTS_NOT | paste -s -d , -)
fi
chosen() { "$program" -tce="$not" -sfe="$not_files" -sf="${C2D_TESTS_FILES:-}" "$@"; }
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
totals=0
index=0
for program; do # a line for each piece: program, first and last of its tests
  total=$(chosen --count --no-colors | sed -n 's/.*filters: *\([0-9]*\).*/\1/p')
  [ -n "$total" ] || { echo "$program does not count its tests"; exit 1; }
  totals=$((totals + total))
  parts=$pieces
  [ "$total" -ge "$parts" ] || parts=1
  i=0
  while [ "$i" -lt "$parts" ] && [ "$total" -gt 0 ]; do
    echo "$((total * i / parts + 1)) $((total * (i + 1) / parts)) $program" >"$folder/piece.$index"
    index=$((index + 1)) i=$((i + 1))
  done
done
work() { # a worker takes the next piece that no other has taken
  i=0
  while [ "$i" -lt "$index" ]; do
    if mkdir "$folder/taken.$i" 2>/dev/null; then
      read -r first last program <"$folder/piece.$i"
      chosen --order-by=rand --rand-seed="${C2D_TESTS_SEED:-20}" --first="$first" --last="$last" >"$folder/$i" 2>&1
    fi
    i=$((i + 1))
  done
}
worker=0
while [ "$worker" -lt "$workers" ]; do
  work &
  worker=$((worker + 1))
done
wait
passed=0 failed=0 i=0
while [ "$i" -lt "$index" ]; do
  sed '$d' "$folder/$i"
  last=$(tail -n 1 "$folder/$i")
  case $last in
    *' passed, '*' failed') ;;
    *) echo "$last"; echo "piece $i ended without totals"; last='0 passed, 1 failed' ;;
  esac
  passed=$((passed + ${last%% passed*}))
  rest=${last#*, }
  failed=$((failed + ${rest%% failed}))
  i=$((i + 1))
done
[ $((passed + failed)) -ge "$totals" ] || { echo "only $((passed + failed)) of $totals tests ran"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
