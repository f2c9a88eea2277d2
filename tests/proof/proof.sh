#!/bin/bash
# proof.sh [STAGE...]: the stages of make proof (proof.mk). A stage's output stays in build/proof/STAGE.log. Ends with 1 if a stage has
# not passed.
set -u
cd "$(dirname "$0")/../.." || exit 1
page=tests/PROOF.md logs=build/proof
export MAKE=${MAKE:-make}
mkdir -p "$logs"

stage_line() { sed -n "s/^$1 | //p" tests/proof/stages.txt; }
names=$(sed -n '/^#/d; s/ |.*//p' tests/proof/stages.txt)
# What the tree holds, but for the page itself: a commit of the page makes no result old.
tree=$(git ls-files -s -- . ":!$page" 2>/dev/null; git diff HEAD -- . ":!$page" 2>/dev/null)
tree=$(printf %s "$tree" | cksum | cut -d' ' -f1)
commit=$(git rev-parse --short HEAD 2>/dev/null || echo none)
[ -z "$(git status --porcelain -- . ":!$page" 2>/dev/null)" ] || commit="$commit, changed"

row_of() { sed -n "s/^| $1 | //p" "$page" 2>/dev/null; }
field() { row_of "$1" | awk -F' [|] ' -v n="$2" '{ print $n }'; } # 2 result, 3 commit, 4 date, 5 minutes, 6 tree
write_page() { # stage, result, minutes: its row anew, all others as they were
  {
    echo '# What make proof found'
    echo
    echo 'Written by `make proof`: of each stage the result of its last run, at which commit, when, and how long it took.'
    echo 'A stage whose tree is another than today is due again.'
    echo
    echo '| stage | what it shows | result | commit | date | minutes | tree |'
    echo '| --- | --- | --- | --- | --- | --- | --- |'
    for row in $names; do
      shows=$(stage_line "$row" | sed 's/ | .*//')
      if [ "$row" = "$1" ]; then
        echo "| $row | $shows | $2 | $commit | $(date -u +%Y-%m-%d) | $3 | $tree |"
      elif [ -n "$(row_of "$row")" ]; then
        echo "| $row | $shows | $(field "$row" 2) | $(field "$row" 3) | $(field "$row" 4) | $(field "$row" 5) | $(field "$row" 6 | sed 's/ |$//') |"
      else
        echo "| $row | $shows | not run | - | - | - | - |"
      fi
    done
  } >"$page.new" && mv "$page.new" "$page"
}
is_due() { [ "$(field "$1" 2)" != passed ] || [ "$(field "$1" 6 | sed 's/ |$//')" != "$tree" ]; }

due=$*
if [ $# = 0 ]; then
  for name in $names; do [ "$(field "$name" 2)" = passed ] || due="$due $name"; done
  for name in $names; do [ "$(field "$name" 2)" != passed ] || ! is_due "$name" || due="$due $name"; done
fi
failed=
for name in $due; do
  command=$(stage_line "$name" | sed 's/^[^|]* | //')
  [ -n "$command" ] || { echo "proof: there is no stage $name; there are: $(echo $names)"; exit 64; }
  echo "proof: $name: $command"
  began=$(date +%s)
  if sh -c "$command" >"$logs/$name.log" 2>&1 </dev/null; then result=passed; else result='**failed**'; fi
  minutes=$(awk "BEGIN { printf \"%.1f\", ($(date +%s) - $began) / 60 }")
  write_page "$name" "$result" "$minutes"
  tail -n 1 "$logs/$name.log"
  echo "proof: $name $result in $minutes minutes"
  [ "$result" = passed ] || { tail -n 60 "$logs/$name.log"; failed="$failed $name"; }
done
[ -z "$failed" ] || { echo "proof: failed:$failed"; exit 1; }
