#!/bin/sh
# The gallery: a picture, key numbers and the sketch of every problem of list.txt, as the program makes them. In the project folder:
#   sh examples/gallery/gallery.sh PROGRAM FOLDER   writes README.md and the pictures to FOLDER (make gallery)
#   sh examples/gallery/gallery.sh inputs           prints what the page is made from: a checksum of every input, the version
set -e
list=examples/gallery/list.txt
entries() { grep -v '^#' $list; }

inputs() {
  sed -n 's/^#define C2D_VERSION_\([A-Z]*\) *\([0-9]*\).*/\1 \2/p' include/contact2d.h
  for sketch in $(entries | cut -d' ' -f1); do cksum "examples/$sketch.c2s"; done
  for file in examples/*.csv $list examples/gallery/gallery.sh; do cksum "$file"; done
}

# Rows of the last state in --summary: what a reader looks for first, with the stated error and the place.
numbers() {
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
    { row[NR] = $0; last = $at["mu"] "," $at["step"] }
    function short(value, form) { return value == "" ? "" : sprintf(form, value + 0) }
    function place_of(value, form) { return short(value*value < 1e-20 ? 0 : value, form) } # not the last digit of a zero
    END {
      print "| part | number | value | stated error | x, y |"; print "| --- | --- | --- | --- | --- |"
      for (r = 2; r <= NR; ++r) {
        split(row[r], f, ",")
        what = f[at["quantity"]]
        if (f[at["mu"]] "," f[at["step"]] != last) continue
        if (what !~ /^(peak pressure|contact edge|stick border|(largest|smallest) stress|stress|friction force|contact width|dissipated|walk|motion|rotation|SWT|Fatemi-Socie|Findley|Crossland|Dang Van|Ruiz)/) continue
        value = f[at["value"]]; error = f[at["error"]]; part = f[at["name"]]
        if (value == 0 || (value < 0 ? -value : value) <= 3*error) continue
        if (++seen[part, what] > 2) continue
        end = what ~ /edge|border/
        item = end && f[at["item"]] > 0 ? " " f[at["item"]] : ""
        place = f[at["x"]] == "" ? "" : place_of(f[at["x"]], "%.5g") ", " place_of(f[at["y"]], "%.4g")
        print "| " (part == "" ? "all" : part) " | " what item " | " short(end ? f[at["along"]] : value, "%.5g") " | " short(error, "%.2g") " | " place " |"
      }
    }' "$1"
}

# Stress intensities of the last state, from the listing: it has them where there are cracks.
cracks() {
  awk '
    /tip x +tip y +K1/ { reads = 1; count = 0; next }
    reads && NF == 0 { reads = 0 }
    reads && $1 != step { step = $1; count = 0 }
    reads { row[++count] = $0 }
    END {
      for (i = 1; i <= count; ++i) {
        split(row[i], f, " ")
        for (k = 1; k <= 2; ++k)
          if (f[4 + k] + 0 != 0) printf "| tip %d | K%d | %.5g | | %.5g, %.4g |\n", i, k, f[4 + k], f[3], f[4]
      }
    }' "$1"
}

entry() { # sketch, picture
  name=$(basename "$1")
  case $1 in families/*) name=family_$name ;; revolution/*) name=revolution_$name ;; esac
  rm -rf "$work"
  mkdir -p "$work"
  "$program" run --quiet --no-progress --listing "$work/listing" --summary "$work/summary.csv" --figures "$work/figures" "examples/$1.c2s" >&2
  cp "$work/figures/$2.svg" "$folder/$name.svg"
  title=$(sed -n 's/^title  *//p' "examples/$1.c2s" | head -1)
  units=$(sed -n 's/^units  */in /p' "examples/$1.c2s" | head -1)
  caption=$(sed -n 's/^<desc>\(.*\)<\/desc>$/\1/p' "$folder/$name.svg" | head -1)
  printf '\n## %s\n\n`examples/%s.c2s`\n%s\n\n![%s](%s.svg)\n\n%s\n\n' "$title" "$1" "$units" "$title" "$name" "$caption"
  numbers "$work/summary.csv"
  cracks "$work/listing"
  printf '\n<details><summary>The sketch</summary>\n\n```\n'
  cat "examples/$1.c2s"
  printf '```\n\n</details>\n'
}

if [ "$1" = inputs ]; then inputs; exit; fi
program=$1 folder=$2
work=$folder/work
mkdir -p "$folder"
{
  cat <<'END'
# Gallery

The problems of users and the families of the [examples](../README.md) as the program solves them: a picture of `--figures`, and
key numbers at the end of the load history, each with its stated error. The value of an edge is the distance along the second side
of the contact statement. A picture shows the largest pressure of a pair, the numbers the largest also between pairs. The sketches
of a half or a quarter give forces of that part. `make gallery` makes this page and its pictures; a test reports when they are
older than the sketches.

Other lessons of the [tutorial](../TUTORIAL.md): the roller below [with friction](../tutorial/t2_friction.c2s), with
[mistakes](../tutorial/t3_mistakes.c2s), [more accurate](../tutorial/t4_accuracy.c2s), and as a table of runs
[a pin in a hole](../tutorial/t10_sweep.c2s); a [rounded pad](../tutorial/t5_report.c2s), a [deck](../tutorial/t11_deck.dat), and
a [load that cannot be carried](../tutorial/t12_sliding.c2s).
END
  entries | while read -r sketch picture; do entry "$sketch" "$picture"; done
  printf '\n<!-- made from\n'
  inputs
  printf -- '-->\n'
} > "$folder/README.md.new"
mv "$folder/README.md.new" "$folder/README.md"
rm -rf "$work"
