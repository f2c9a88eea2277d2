#!/bin/sh
# Instructions of fixed work, counted by valgrind (whatever else the machine does), and of the AVX-512 inner loop, read
# from its disassembly, against the numbers kept in guard.txt: more than 5 % above them is a failure.
# Usage: guard.sh check|save RUN_BENCH KERNEL_AVX512_OBJECT FILE COMPILER [FLAGS]
# Lines of FILE: compiler:flags, name, number. Compilers differ: numbers are kept per compiler with its major version
# and flags; where there are none for this one, that is said, and is a failure only with GUARD_MUST=1.
set -eu
what=$1 bench=$2 object=$3 file=$4 compiler=$5 flags=${6:-}
family=gcc
$compiler --version | grep -qi clang && family=clang
key=$family-$($compiler -dumpversion | cut -d. -f1):$(echo $flags | tr ' ' ,)
found=$(mktemp)
trap 'rm -f "$found"' EXIT

if command -v valgrind >/dev/null; then
  for job in $("$bench" --guard list); do
    counted=$(LD_BIND_NOW=1 valgrind --tool=callgrind --callgrind-out-file=/dev/null --collect-atstart=no \
      --toggle-collect=guarded_work "$bench" --guard "$job" 2>&1) || { echo "guard: $job cannot run here"; continue; }
    echo "$key $job $(echo "$counted" | sed -n 's/.*Collected : *\([0-9]*\).*/\1/p')" >>"$found"
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
