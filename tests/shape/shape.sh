#!/bin/sh
# make shape: sizes and habits of the sources, one line each. $1: a folder with the objects of the library, and the program beside it.
cd "$(dirname "$0")/../.." || exit 1
build=${1:-build}
files() { find "$@" -name '*.cpp' -o -name '*.hpp' | sort; }
core() { files src | grep -vE '^src/(program|report|post)/'; }
count() { wc -l | tr -d ' '; }

modes='delays\(|is_on_demand\(|\bsmooth\b|\bguided\b|\bresting\b|\.sliding\b|\.open\b|is_let_go\(|has_normal_columns\(|some_sleep\(|is_asleep\('
words='told|tells|asleep|awake|woken|let go|lets go|hold|holds|held'
echo "lines of the core                       $(core | xargs cat | count)"
echo "lines of program, report and post       $(files src | grep -E '^src/(program|report|post)/' | xargs cat | count)"
echo "modes asked in contact and solver       $(grep -rnoE "$modes" src/contact src/solver | count)"
echo "kSmallCode                              $(grep -rno kSmallCode src | count) in $(grep -rl kSmallCode src | count) files"
echo "files of the core that know mu          $(grep -rlwE mu src --include=*.cpp --include=*.hpp |
  grep -cE '^src/(contact|solver|interface|results|model)')"
echo "house words                             $(grep -rniowE "$words" --include=*.cpp --include=*.hpp --include=*.h --include=*.md \
  src include README.md examples port | count)"
# Characters of comments over those of code, blanks left out.
share() { xargs cat | awk '{ at = index($0, "//"); comment = at ? substr($0, at) : ""; code = at ? substr($0, 1, at - 1) : $0
  gsub(/[ \t]/, "", code); c += length(comment); k += length(code) } END { printf "%.0f %%\n", 100 * c / k }'; }
echo "comments over code, .cpp of the core    $(core | grep 'cpp$' | share)"
echo "folders of more than 30 files           $(find src -type f | xargs -n1 dirname | sort | uniq -c | awk '$1 > 30 { print $2, $1 }' |
  paste -sd , -)"
echo "sources of the core without a header    $(core | grep 'cpp$' | while read -r f; do [ -e "${f%.cpp}.hpp" ] || echo; done | count)"
for page in src/METHOD*.md; do printf 'words of %-31s %s\n' "${page#src/}" "$(wc -w <"$page")"; done
if command -v valgrind >/dev/null && command -v python3 >/dev/null && command -v nm >/dev/null; then
  python3 tests/shape/call_tree.py "$build"
else
  echo "call tree of a rate problem             not counted: needs valgrind, nm and python3"
fi
