# Reads what llvm-cov show says of branches and lines, and prints a table per folder and the branches never taken. A branch is
# a condition as it stands in the source, with its two outcomes; of templates, of functions compiled more than once and of
# several builds the outcomes are taken together. Lines that end with (lanes) choose between numbers of vectors, all at once:
# no branches. ROOT: the project's folder. LEAST: folder:percent of branches, with commas.
function group_of(path) {
  if (path ~ /^port\/cortex-m\// || path ~ /^port\/packaging\//) return ""
  if (path ~ /^port\//) return "ports"
  if (path ~ /^src\/(post|report)\//) return "report"
  if (path ~ /^src\/program\//) return "program"
  return path ~ /^src\// ? "core" : ""
}
function percent(taken, all) { return all ? 100 * taken / all : 100 }

/^[^ |]*[.][chp]+:$/ { # of the library as from the project's folder, of tests in full
  path = substr($0, 1, length($0) - 1)
  if (index(path, ROOT "/") == 1) path = substr(path, length(ROOT) + 2)
  group = group_of(path)
  next
}
group == "" { next }
/^[ |]*[0-9]+\|/ { chooses = / \/\/ \(lanes\)$/ } # (also where a template stands once more for each of its types)
/^ *[0-9]+\| *[0-9.]+[kMGTPEZY]?\|/ {
  split($0, column, "|")
  line = path ":" column[1] + 0
  if (/C2D_NEVER\(/ && path != "src/memory/hostile.hpp" && !(line in lines)) nevers++
  count = column[2] + 0
  if (!(line in lines)) group_lines[group]++
  if (count > 0 && !lines[line]) group_run[group]++
  if (!(line in lines) || count > 0) lines[line] = count > 0
  next
}
/Branch \([0-9]+:[0-9]+\): \[True: / && !chooses {
  match($0, /\([0-9]+:[0-9]+\)/)
  place = path ":" substr($0, RSTART + 1, RLENGTH - 2)
  match($0, /True: [^,]*/)
  yes = substr($0, RSTART + 6, RLENGTH - 6)
  match($0, /False: [^]]*/)
  no = substr($0, RSTART + 7, RLENGTH - 7)
  if (!(place in where)) { where[place] = group; order[++places] = place }
  # (a difference of counters below zero comes out as 18.4E: threads that lost a count)
  if (yes != "0" && yes !~ /E$/) yes_of[place] = 1
  if (no != "0" && no !~ /E$/) no_of[place] = 1
}
END {
  for (i = 1; i <= places; i++) {
    place = order[i]
    g = where[place]
    all[g] += 2
    taken[g] += yes_of[place] + no_of[place]
    if (!yes_of[place]) print place ": never true"
    if (!no_of[place]) print place ": never false"
  }
  printf "%-8s %8s %8s %8s   %8s %8s %8s\n", "", "lines", "run", "%", "branches", "taken", "%"
  failed = 0
  count = split("core ports report program", groups, " ")
  for (i = 1; i <= count; i++) {
    g = groups[i]
    printf "%-8s %8d %8d %8.2f   %8d %8d %8.2f\n", g, group_lines[g], group_run[g], percent(group_run[g], group_lines[g]),
      all[g], taken[g], percent(taken[g], all[g])
  }
  print nevers + 0 " conditions are marked as never true, with their reasons (at most 40)"
  if (nevers > 40) failed = 1
  count = split(LEAST, wanted, ",")
  for (i = 1; i <= count; i++) {
    split(wanted[i], pair, ":")
    if (percent(taken[pair[1]], all[pair[1]]) < pair[2]) { failed = 1; print pair[1] ": less than " pair[2] " % of the branches" }
  }
  exit failed
}
