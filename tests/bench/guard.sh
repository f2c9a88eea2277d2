#!/bin/sh
# Instructions of fixed work, counted by valgrind (whatever else the machine does), and of the AVX-512 inner loop, read
# from its disassembly, against the numbers kept in guard.txt: more than 5 % above them is a failure.
# Usage: guard.sh check|save RUN_BENCH PROGRAM KERNEL_AVX512_OBJECT FILE COMPILER [FLAGS]
# Lines of FILE: machine-compiler-version:flags, name, number. Compilers differ: numbers are kept per compiler with its
# major version and flags; where there are none for this one, that is said, and is a failure only with GUARD_MUST=1.
set -eu
what=$1 bench=$2 program=$3 object=$4 file=$5 compiler=$6 flags=${7:-}
family=gcc
$compiler --version | grep -qi clang && family=clang
key=$($compiler -dumpmachine | cut -d- -f1)-$family-$($compiler -dumpversion | cut -d. -f1):$(echo $flags | tr ' ' ,)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
found=$folder/found

count() { # options of valgrind, program and arguments: instructions, empty if it failed
  LD_BIND_NOW=1 valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 >/dev/null |
    sed -n 's/.*Collected : *\([0-9]*\).*/\1/p'
}
keep() { # name, instructions: none if the processor that valgrind plays lacks the set
  if [ "${2:-0}" = 0 ]; then echo "guard: $1 cannot run here"; else echo "$key $1 $2" >>"$found"; fi
}

if command -v valgrind >/dev/null; then
  for job in $("$bench" --guard list); do
    keep "$job" "$(count --collect-atstart=no --toggle-collect=guarded_work "$bench" --guard "$job")"
  done
  for deck in examples/hertz.dat tests/data/decks/sample56.dat; do
    keep "job.$(basename $deck .dat)" "$(count "$program" run $deck --listing "$folder/listing" --csv "$folder/csv" \
      --store memory --threads 1)"
  done
else
  echo 'guard: there is no valgrind, instructions are not counted'
  [ "${GUARD_MUST:-0}" = 0 ] || exit 1
fi

# The innermost loop with the most fused multiplications of whole 64-byte registers.
if objdump -d "$object" 2>/dev/null | grep -q 'vf.*zmm'; then
  objdump -d --no-show-raw-insn "$object" | awk -v key="$key" '
    />:$/ { n = 0 }
    /^ *[0-9a-f]+:/ {
      address = $1; sub(":", "", address)
      text[n] = $0; place[address] = n; at[n] = address; ++n
      if ($2 ~ /^j/ && ($3 in place) && at[place[$3]] == $3 && place[$3] < n) {
        fma = loads = spread = stores = inner = 0
        for (i = place[$3]; i < n; ++i) {
          line = text[i]
          if (line ~ /vf(n?)m(add|sub)[0-9]+p[ds].*zmm/) ++fma
          if (line ~ /\tv?mov[ua]p[sd].*\),%zmm/ || line ~ /vf.*[^}]\),%zmm/ || line ~ / v?mov[ua]p[sd] .*\),%zmm/) ++loads
          if (line ~ /vbroadcasts[ds].*\(/ || line ~ /\{1to/) ++spread
          if (line ~ /mov[ua]p[sd] +%zmm[0-9]+,.*\(/) ++stores
          if (i < n - 1 && line ~ /\tj[a-z]+ /) inner = 1
        }
        if (!inner && fma > best) { best = fma; all = n - place[$3]; l = loads; b = spread; s = stores }
      }
    }
    END {
      print key, "loop.avx512.fma", best; print key, "loop.avx512.instructions_per_1000_fma", int(1000 * all / best)
      print key, "loop.avx512.loads_per_1000_fma", int(1000 * l / best)
      print key, "loop.avx512.broadcasts_per_1000_fma", int(1000 * b / best)
      print key, "loop.avx512.stores", s
    }' >>"$found"
else
  echo 'guard: no AVX-512 in this build, or no objdump'
fi

if [ "$what" = save ]; then
  { [ -f "$file" ] && grep -vF "$key " "$file" || true; cat "$found"; } | sort >"$file.new"
  mv "$file.new" "$file"
  echo "guard: $(grep -cF "$key " "$file") numbers kept for $key"
  exit 0
fi
if ! grep -qF "$key " "$file"; then
  echo "guard: no numbers are kept for $key (make guard-save); nothing is compared"
  exit "${GUARD_MUST:-0}"
fi
awk -v key="$key" -v must="${GUARD_MUST:-0}" '
  NR == FNR { if ($1 == key) kept[$1 " " $2] = $3; next }
  ($1 " " $2) in kept {
    before = kept[$1 " " $2]
    verdict = "as kept"
    if ($2 ~ /\.fma$/ ? $3 < before : $3 > 1.05 * before) { verdict = "MORE THAN 5 % WORSE"; bad = 1 }
    else if ($3 < 0.95 * before) verdict = "better: make guard-save keeps it"
    printf "  %-44s %12d kept %12d  %s\n", $2, $3, before, verdict
    ++compared; delete kept[$1 " " $2]; next
  }
  { printf "  %-44s %12d not kept\n", $2, $3 }
  END {
    for (name in kept) { print "  " name " is kept, and was not counted"; if (must) bad = 1 }
    exit bad || !compared
  }' "$file" "$found" || { echo "guard: failed for $key"; exit 1; }
