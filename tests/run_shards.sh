#!/bin/sh
# run_shards.sh PROGRAM PROCESSORS: the tests in pieces, one process more at once than there are processors, as some wait more than
# they compute, in an order that mixes slow and quick ones.
# Prints what each prints, then the totals of all: N passed, N failed. C2D_TESTS_NOT names files with patterns of names of tests
# that do not run (the rest of the line after | says why), C2D_TESTS_FILES patterns of files, with commas, whose tests alone run.
program=$1
workers=$(($2 + 1))
pieces=$((workers * 12))
not=
[ -z "${C2D_TESTS_NOT:-}" ] || not=$(sed -n '/^#/d; s/ *|.*//p' $C2D_TESTS_NOT | paste -s -d , -)
chosen() { "$program" -tce="$not" -sf="${C2D_TESTS_FILES:-}" "$@"; }
total=$(chosen --count --no-colors | sed -n 's/.*filters: *\([0-9]*\).*/\1/p')
[ -n "$total" ] || { echo "$program does not count its tests"; exit 1; }
[ "$total" -ge "$pieces" ] || pieces=1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
work() { # a worker takes the next piece that no other has taken
  i=0
  while [ "$i" -lt "$pieces" ]; do
    if mkdir "$folder/taken.$i" 2>/dev/null; then
      chosen --order-by=rand --rand-seed=20 --first=$((total * i / pieces + 1)) --last=$((total * (i + 1) / pieces)) \
        >"$folder/$i" 2>&1
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
passed=0
failed=0
i=0
while [ "$i" -lt "$pieces" ]; do
  sed '$d' "$folder/$i"
  totals=$(tail -n 1 "$folder/$i")
  case $totals in
    *' passed, '*' failed') ;;
    *) echo "$totals"; echo "piece $i ended without totals"; totals='0 passed, 1 failed' ;;
  esac
  passed=$((passed + ${totals%% passed*}))
  rest=${totals#*, }
  failed=$((failed + ${rest%% failed}))
  i=$((i + 1))
done
[ $((passed + failed)) -ge "$total" ] || { echo "only $((passed + failed)) of $total tests ran"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
