#!/bin/sh
# symbols.sh LIBRARY FILE VERSION: keeps in FILE the names that LIBRARY exports, each with the version that had it first,
# in the form of dpkg-gensymbols. Names that FILE has already keep their version; one that is gone is an error, since
# programs linked with it would no longer start.
set -eu
library=$1 file=$2 version=$3
so=${version%%.*}
[ "$so" != 0 ] || so=${version%.*}
new=$(mktemp)
trap 'rm -f "$new" "$new.names"' EXIT
nm -D --defined-only --with-symbol-versions "$library" |
  sed -n 's/^[0-9a-f]* [TWDRBV] \(c2[^@]*\)@@*\([^@]*\)$/\1@\2/p' | LC_ALL=C sort >"$new.names"
[ -f "$file" ] || : >"$file"
{
  echo "libcontact2d.so.$so libcontact2d$so #MINVER#"
  while read -r name; do
    known=$(sed -n "s/^ $name \(.*\)/\1/p" "$file")
    echo " $name ${known:-$version}"
  done <"$new.names"
} >"$new"
for name in $(sed -n 's/^ \([^ ]*\) .*/\1/p' "$file"); do
  grep -q "^ $name " "$new" || { echo "$name is no longer exported (see $file)"; exit 1; }
done
cp "$new" "$file"
