# Usage: CXX=... DOCTEST_INCLUDE=... NO_INSTALL=... sh tests/doctest.sh FLAGS_FILE
# Finds doctest/doctest.h and writes the compiler flag that leads to it (or nothing) to FLAGS_FILE. If the header
# is missing it is installed with the system's package manager, unless NO_INSTALL is set. DOCTEST_SHA256: what was installed is
# used only if its checksum is among these words.
out=$1
compiles() { echo '#include <doctest/doctest.h>' | ${CXX:-c++} $1 -std=c++17 -E -x c++ - >/dev/null 2>&1; }
found() { if compiles "$1"; then echo "$1" >"$out"; exit 0; fi; }

if [ -n "$DOCTEST_INCLUDE" ]; then
  if [ -e "$DOCTEST_INCLUDE/doctest/doctest.h" ]; then found "-I$DOCTEST_INCLUDE"; fi
  echo "DOCTEST_INCLUDE=$DOCTEST_INCLUDE holds no doctest/doctest.h" >&2
  exit 1
fi
search() {
  found ""
  for folder in /usr/local/include /opt/homebrew/include; do found "-I$folder"; done
}
search

known() { # is the header one of those that were looked at?
  [ -n "$DOCTEST_SHA256" ] || return 0
  header=$(echo '#include <doctest/doctest.h>' | ${CXX:-c++} -std=c++17 -M -x c++ - | tr ' ' '\n' | grep 'doctest/doctest\.h$' | head -1)
  sum=$(sha256sum "$header" | cut -d' ' -f1)
  case " $DOCTEST_SHA256 " in *" $sum "*) return 0 ;; esac
  echo "$header has the checksum $sum, which is not among those asked for ($DOCTEST_SHA256)" >&2
  exit 1
}

as_root=
if [ "$(id -u)" != 0 ]; then as_root="sudo -n "; fi
if command -v apt-get >/dev/null; then
  command="${as_root}apt-get update && ${as_root}env DEBIAN_FRONTEND=noninteractive apt-get install -y doctest-dev"
elif command -v dnf >/dev/null; then command="${as_root}dnf install -y doctest-devel"
elif command -v apk >/dev/null; then command="${as_root}apk add doctest-dev"
elif command -v pacman >/dev/null; then command="${as_root}pacman -S --noconfirm doctest"
elif command -v brew >/dev/null; then command="brew install doctest"
else command=
fi
if [ -n "$command" ] && [ -z "$NO_INSTALL" ]; then
  if [ -z "$as_root" ] || [ "${command#sudo}" = "$command" ] || sudo -n true 2>/dev/null; then
    echo "doctest/doctest.h is missing, installing: $command" >&2
    sh -c "$command" >&2 && known && search
  fi
fi
echo "doctest/doctest.h is missing. Install it (${command:-package doctest}) or say DOCTEST_INCLUDE=folder" >&2
exit 1
