#!/bin/sh
# cross.sh FOLDER BUILD COMPARE: see cross.mk. BUILD holds this machine's library and program.
set -eu
folder=$1
here=$2
compare=$3
skipped=0

die() { echo "cross: $*" >&2; exit 1; }
available() { # name, commands ...; old compilers are not in every release of a system
  name=$1; shift
  for command; do
    command -v "$command" >/dev/null && continue
    [ -z "${C2D_ALL_HOSTS:-}" ] || [ "$name" = "$command" ] || die "$name: $command is not installed"
    echo "cross: $name SKIPPED: $command is not installed"
    skipped=$((skipped + 1))
    return 1
  done
}
i686_emulator() { # nothing, where such programs run without one
  printf 'int main(void) { return 0; }\n' >"$folder/empty.c"
  i686-linux-gnu-gcc -static "$folder/empty.c" -o "$folder/empty" && "$folder/empty" 2>/dev/null || echo qemu-i386
}
wanted() { [ -z "${CROSS_ONLY:-}" ] || [ "$CROSS_ONLY" = "$1" ]; }
solve() { # folder, emulator and program ...
  out=$1; shift
  rm -rf "$out/tapes"
  "$@" run examples/hertz.dat --no-progress --listing "$out/hertz.lst" --csv "$out/hertz.csv" --memory 64K \
    --store "file:$out/tapes" --keep
}
blocks() { # folder, compiler ...
  out=$1; shift
  "$@" -std=c99 -Wall -Wextra -Werror -Iinclude -Iport/stdio tests/cross/blocks.c "$out/libcontact2d.a" -lm -o "$out/blocks"
  rm -rf "$out/saved"; mkdir -p "$out/saved"
}
agrees() { # name, results
  echo "cross: $1: the sample against this machine"
  "$compare" "$folder/here/hertz.csv" "$2" 1e-9
}
library() { # name, emulator, prefix of the compilers: linked statically, it needs no libraries of that machine
  name=$1 emulator=$2 prefix=$3 out=$folder/$1
  set -- CXX="${prefix}g++" CC="${prefix}gcc" AR="${prefix}ar" CXXFLAGS=-O0 LDFLAGS=-static
  "$MAKE" -s -j"$JOBS" --no-print-directory BUILD="$out" "$@" "$out/libcontact2d.a"
  blocks "$out" "${prefix}gcc" -static
  mkdir -p "$out/solved"
  $emulator "$out/blocks" solve "$out/solved" > "$out/hertz.csv"
  agrees "$name" "$out/hertz.csv"
  if [ -z "${CROSS_ONLY:-}" ]; then program "$name" "$emulator" "$@"; fi
}
program() { # name, emulator, make's variables
  name=$1 emulator=$2 out=$folder/$1; shift 2
  "$MAKE" -s -j"$JOBS" --no-print-directory BUILD="$out" "$@" "$out/contact2d"
  solve "$out" $emulator "$out/contact2d"
  agrees "$name, program" "$out/hertz.csv"
}
# Blocks that `from` wrote, read by `to`: the status that must come out, and words that must be in what is said.
pass() { # from, to's emulator, to's program, expected
  said=$($2 "$3" read "$1") || true
  case $said in
    $4) echo "cross: blocks of $1 read by $3: $said" ;;
    *) die "blocks of $1 read by $3: expected $4, got: $said" ;;
  esac
}

mkdir -p "$folder/here"
cp "$here/libcontact2d.a" "$folder/here/"
solve "$folder/here" "$here/contact2d"
blocks "$folder/here" "$CC"
"$folder/here/blocks" write "$folder/here/saved" >/dev/null
pass "$folder/here/saved" '' "$folder/here/blocks" '0 *'

if wanted i686 && available 'i686 (32 bits)' i686-linux-gnu-g++; then
  # Some kernels of x86-64 run 32-bit programs as they are.
  run=$(i686_emulator)
  [ -z "$run" ] || available 'i686 (32 bits)' "$run" || exit 1
  library i686 "$run" i686-linux-gnu-
  $run "$folder/i686/blocks" write "$folder/i686/saved" >/dev/null
  pass "$folder/i686/saved" '' "$folder/here/blocks" '40 *' # C2D_ERR_MISMATCH: a state is a machine's own
  pass "$folder/here/saved" "$run" "$folder/i686/blocks" '40 *'
fi
if wanted s390x && available 's390x (big-endian)' s390x-linux-gnu-g++ qemu-s390x; then
  library s390x qemu-s390x s390x-linux-gnu-
  qemu-s390x "$folder/s390x/blocks" write "$folder/s390x/saved" >/dev/null
  pass "$folder/s390x/saved" '' "$folder/here/blocks" '40 *the other byte order*'
  pass "$folder/here/saved" qemu-s390x "$folder/s390x/blocks" '40 *the other byte order*'
fi
# Libraries by other compilers, linked into this machine's program.
wanted g++-11 && available g++-11 g++-11 && program g++-11 '' TESTS_FROM="$here" CXX=g++-11 CC=gcc-11 CXXFLAGS='-O1 -Werror'
wanted clang-13 && available clang++-13 clang++-13 && program clang-13 '' TESTS_FROM="$here" CXX=clang++-13 CC=clang-13 CXXFLAGS='-O1 -Werror'
echo "cross: done, $skipped skipped"
