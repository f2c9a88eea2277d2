"""The call tree of the rate problems of one run: how many files of the core it enters, and which calls lead from a folder up into a
higher one. Calls are those that callgrind counts below `settle` (src/contact); files are those whose objects define the functions.
A call up is counted and not followed: through a pool of threads it would lead to the work of others.

    python3 tests/shape/call_tree.py BUILD
"""

import collections
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = "c2d::settle("
DECKS = ("examples/hertz.dat", "examples/three_bodies.dat")
LEVELS = [("memory", "quadrature", "linalg", "store"), ("model",), ("deck", "bie"), ("elimination",), ("contact",), ("solver",),
          ("results",), ("interface",)]
BUILD = pathlib.Path(sys.argv[1])


def level(source):
    folder = source.split("_")[0]
    return next((i for i, each in enumerate(LEVELS) if folder in each), len(LEVELS))


def leads_up(home, a, b):
    return a in home and b in home and level(home[b]) > level(home[a])


def homes():
    """Object by function, of functions that one object alone defines."""
    out = collections.defaultdict(set)
    objects = sorted(str(path) for path in (BUILD / "obj").glob("*.o"))
    listing = subprocess.run(["nm", "-AC"] + objects, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    for line in listing.splitlines():
        found = re.match(r"(.*)\.o:[0-9a-f]+ [tTwW] (.*)", line)
        if found:
            out[found[2]].add(pathlib.Path(found[1]).name)
    return {name: places.pop() for name, places in out.items() if len(places) == 1}


def calls(deck, folder):
    """Pairs of functions, caller and callee, that callgrind saw."""
    log = folder / "callgrind.out"
    subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=%s" % log, str(BUILD / "contact2d"), "run", deck,
                    "--listing", str(folder / "listing")], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    names, caller, callee, out = {}, None, None, set()
    for line in log.read_text().splitlines():
        found = re.match(r"(c?fn)=\((\d+)\)(?: (.*))?", line)
        if found:
            if found[3]:
                names[found[2]] = re.sub(r"'\d+$", "", found[3])
            if found[1] == "fn":
                caller = names[found[2]]
            else:
                callee = names[found[2]]
        elif line.startswith("calls="):
            out.add((caller, callee))
    return out


def main():
    home, seen = homes(), set()
    with tempfile.TemporaryDirectory() as folder:
        for deck in DECKS:
            seen |= calls(deck, pathlib.Path(folder))
    below = collections.defaultdict(set)
    for caller, callee in seen:
        below[caller].add(callee)
    reached, todo = set(), [name for name in below if name.startswith(ROOT)]
    if not todo:
        sys.exit("no function %s...) was called" % ROOT)
    while todo:
        name = todo.pop()
        if name not in reached:
            reached.add(name)
            todo += [each for each in below[name] if not leads_up(home, name, each)]
    files = sorted({home[name] for name in reached if name in home})
    up = sorted({(home[a], home[b]) for a in reached for b in below[a] if leads_up(home, a, b)})
    print("files below one solved rate problem     %d: %s" % (len(files), " ".join(files)))
    print("calls up from a lower folder            %d: %s" % (len(up), ", ".join("%s to %s" % each for each in up)))


main()
