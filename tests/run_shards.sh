#!/bin/sh
# run_shards.sh PROGRAM SHARDS: the tests in SHARDS processes at once, in an order that mixes slow and quick ones.
# Prints what each prints, then the totals of all: N passed, N failed. C2D_TESTS_NOT names a file with patterns of
# names of tests that do not run (the rest of the line after | says why).
program=$1
shards=$2
not=
[ -z "${C2D_TESTS_NOT:-}" ] || not=$(sed -n '/^#/d; s/ *|.*//p' "$C2D_TESTS_NOT" | paste -s -d , -)
total=$("$program" --count --no-colors -tce="$not" | sed -n 's/.*filters: *\([0-9]*\).*/\1/p')
[ -n "$total" ] || { echo "$program does not count its tests"; exit 1; }
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
i=0
while [ "$i" -lt "$shards" ]; do
  first=$((total * i / shards + 1))
  last=$((total * (i + 1) / shards))
  "$program" -tce="$not" --order-by=rand --rand-seed=20 --first=$first --last=$last >"$folder/$i" 2>&1 &
  i=$((i + 1))
done
wait
passed=0
failed=0
i=0
while [ "$i" -lt "$shards" ]; do
  sed '$d' "$folder/$i"
  totals=$(tail -n 1 "$folder/$i")
  case $totals in
    *' passed, '*' failed') ;;
    *) echo "$totals"; echo "shard $i ended without totals"; totals='0 passed, 1 failed' ;;
  esac
  passed=$((passed + ${totals%% passed*}))
  rest=${totals#*, }
  failed=$((failed + ${rest%% failed}))
  i=$((i + 1))
done
[ $((passed + failed)) -ge "$total" ] || { echo "only $((passed + failed)) of $total tests ran"; failed=$((failed + 1)); }
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
