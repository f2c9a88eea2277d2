"""Draws calls of the Python package: hostile arguments, any order, callbacks and handlers of signals that raise, forks, threads.

    python3 tests/python/draw_calls.py --cases 5             as `make test` does
    python3 tests/python/draw_calls.py --seconds 600         for as long
    python3 tests/python/draw_calls.py --seed 17 --cases 1   the case of that seed again

Every case is a process of its own. It fails if a signal ends it, if it hangs, if a call raises what it should not, or if the
solver then gives another number than one on which the same calls were made plainly.
"""

import argparse
import array
import decimal
import faulthandler
import gc
import os
import pathlib
import pickle
import random
import resource
import signal
import sys
import tempfile
import threading
import time
import traceback
import warnings

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("C2D_PYTHON_PACKAGE", str(ROOT / "port" / "python")))

if os.environ.get("C2D_WITHOUT_NUMPY") == "1":
    sys.modules["numpy"] = None

import contact2d  # noqa: E402
from contact2d import header  # noqa: E402

PATIENCE = 120  # seconds for a case, which takes a tenth of one
MEMORY = 4 << 30  # bytes of address space
DECKS = [(ROOT / "examples" / "hertz.dat").read_text(), contact2d.make("mindlin", n=8), contact2d.make("cantilever", n=4)]
NUMBERS = [0, 1, -1, 2, 3, 15, 16, 2**31 - 1, 2**31, -(2**31), -(2**31) - 1, 2**32, 2**32 + 1, 2**63, 2**64, -(2**64), True, 0.0,
           1.0, 0.5, -0.5, 1e-320, 1e300, -1e300, float("inf"), float("-inf"), float("nan"), 10**400, decimal.Decimal(1), 1j]
OTHERS = [None, "", "x", "1.0", "a\0b", "\x1b[2J", "\ud800", "name" * 100, b"bytes", b"\0", object(), int, [], (), {}, [[]], [1], [1, 2],
          [1, 2, 3], [1, 2, 3, 4], (0, 0, 1, 1), [[1, 2], [3]], [[0, 0], [1, 1]], ["a", "b"], [float("nan")] * 2, [2**40] * 4, range(3),
          {"body": 1}, {"side1": {"body": 2**40}}, {"title": "t" * 80}, array.array("d", [1.0, 2.0]), bytearray(4), set([1.0]),
          header.c2d_zone(), header.c2d_body(struct_size=2**32 - 1), header.c2d_points(kind=2, count=(50000, 40000))]
FIELDS = ["tn", "tt", "gap", "status", "end_ux", "end_hoop", "node_x", "surface_x", "pair_eta1", "ok", "tm", -1, 3, 99, 2**32]
LEFT_OUT = {"change_loads", "close", "read_deck", "complete"}  # what changes the model beyond what `replay` repeats
METHODS = sorted(name for name in dir(contact2d.Solver) if not name.startswith("_") and name not in LEFT_OUT and
                 callable(getattr(contact2d.Solver, name)) and name != "of_deck")
REFUSED = (contact2d.Error, ValueError, TypeError, MemoryError)


class Late(Exception):
    """Raised by the handler of a signal."""


class Ours(Exception):
    """Raised by a callback."""


def late(*_):
    raise Late()


class Case:
    def __init__(self, seed):
        self.draw = random.Random(seed)
        self.deck = self.draw.choice(DECKS)
        self.replay, self.cancelled, self.plain = [], False, False
        self.folder = tempfile.TemporaryDirectory() if self.draw.random() < 0.2 else None
        self.solver = contact2d.Solver.of_deck(self.deck, threads=self.draw.choice((1, 1, 2)), progress=self.progress,
                                               store=self.folder and self.folder.name)

    # ---- what disturbs
    def progress(self, *_):
        if not self.plain and self.draw.random() < 0.002:
            self.disturb()

    def step(self, step):
        if step.kind == "change" or self.draw.random() < 0.7:
            return False
        what = self.draw.randrange(5)
        if what == 0:
            self.solver.get_zone_state(1), self.solver.get("tn"), self.solver.save()
        elif what == 1:
            return True
        else:
            self.disturb()

    def disturb(self):
        """In a callback."""
        what = self.draw.randrange(6)
        if what == 0:
            raise Ours()
        if what == 1:
            self.must_refuse(self.solver.close)
        elif what == 2:
            self.must_refuse(lambda: self.solver.begin(0.1))
        elif what == 3:
            self.fork()
        elif what == 4:
            self.solver.cancel()
            self.cancelled = True
        elif what == 5:
            assert self.solver.get_state() in range(10)

    def must_refuse(self, call):
        try:
            call()
        except contact2d.UsageError:
            return
        raise AssertionError("not refused")

    def fork(self):
        """Every method raises in a child, and what it drops is its own alone."""
        child = os.fork()
        if child:
            assert os.waitpid(child, 0)[1] == 0, "a child failed"
            return
        status = 1
        try:
            signal.setitimer(signal.ITIMER_REAL, 0)
            for name in METHODS + ["close"]:
                try:
                    getattr(self.solver, name)()
                except (contact2d.UsageError, TypeError):
                    continue
                raise AssertionError(name)
            self.solver = None
            gc.collect()
            status = 0
        except BaseException:
            traceback.print_exc()
        os._exit(status)

    # ---- calls
    def junk(self):
        return self.draw.choice(NUMBERS if self.draw.random() < 0.6 else OTHERS)

    def hostile(self):
        """Any method, with arguments that are right by chance only."""
        name = self.draw.choice(METHODS)
        state = self.solver.state
        given = [self.junk() for _ in range(self.draw.randrange(7))]
        if name in ("run", "contact", "begin", "prepare", "restore"):
            given = given[:1]
        self.attempt(lambda: getattr(self.solver, name)(*given))
        if self.result is None or state != "model":
            return
        if name.startswith(("set_", "add_", "tie_", "clear_", "replace_")):
            self.replay.append((name, given))

    def make_another(self):
        """A solver, a model or a run that cannot be."""
        what, junk = self.draw.randrange(4), self.junk
        if what == 0:
            members = [name for name, *_ in header.c2d_limits._fields_] + ["memory", "threads", "store", "progress"]
            named = {name: junk() for name in self.draw.sample(members, 3)}
            named.pop("store", None)  # (a folder may be called anything)
            self.attempt(lambda: contact2d.Solver(**named))
        elif what == 1:
            model = contact2d.Model()
            for _ in range(5):
                name = self.draw.choice(sorted(contact2d.model.FUNCTIONS))
                self.attempt(lambda: getattr(model, name)(*[junk() for _ in range(self.draw.randrange(7))]))
            self.attempt(model.build)
        elif what == 2:
            named = {name: junk() for name in self.draw.sample(["memory", "threads", "progress"], 1)}
            self.attempt(lambda: contact2d.Solver.of_deck(self.deck, **named))
        else:
            self.attempt(lambda: contact2d.solver.expand_points({"kind": 2, "body": 1, "count": [junk(), junk()]}))

    def others(self):
        """Other threads use the solver, or cancel it, while this one does."""
        def use():
            for _ in range(3):
                self.refused(lambda: self.solver.get("tn"))

        def cancel():
            time.sleep(self.draw.random() * 0.01)
            self.solver.cancel()

        self.cancelled = True
        workers = [threading.Thread(target=self.draw.choice((use, cancel))) for _ in range(2)]
        for worker in workers:
            worker.start()
        self.attempt(self.usual(), timer=True)
        for worker in workers:
            worker.join()

    def refused(self, call):
        try:
            call()
        except REFUSED:
            pass

    def usual(self):
        solver, draw = self.solver, self.draw
        field, load = draw.choice(FIELDS), draw.choice((0.1, 0.5, 1.0, -0.2, 0.0))
        return draw.choice([solver.prepare, lambda: solver.begin(draw.choice((0, 0.1, 0.4))), lambda: solver.advance(load),
                            lambda: solver.advance(load), lambda: solver.run(self.step), lambda: solver.run(self.step),
                            lambda: solver.next_event(load), solver.save, solver.restore, lambda: solver.get(field, draw.randrange(3)),
                            solver.contact, lambda: solver.boundary(1), lambda: solver.interior([(0.5, 3.0), (0.1, -0.3)]),
                            lambda: solver.indicators(2), solver.get_summary])

    def attempt(self, call, timer=False):
        """One call, disturbed by a signal if `timer`; `result`: None if it raised."""
        self.result = None
        try:
            try:
                if timer:
                    signal.setitimer(signal.ITIMER_REAL, self.draw.random() ** 3 * 0.03 + 1e-6, self.draw.choice((0, 0, 1e-3)))
                self.result = (call(),)
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
        except REFUSED as why:
            if isinstance(why, contact2d.Error):
                assert str(pickle.loads(pickle.dumps(why))) == str(why)
        except (Late, Ours):
            pass

    def disturbed(self):
        for _ in range(self.draw.randrange(4, 16)):
            what = self.draw.randrange(10)
            if what < 4:
                self.attempt(self.usual(), timer=self.draw.random() < 0.6)
            elif what < 7:
                self.hostile()
            elif what == 7:
                self.make_another()
            elif what == 8:
                self.fork()
            else:
                self.others()

    # ---- numbers
    def numbers(self, solver, mu, loads):
        """Of a path from its beginning."""
        def call(function, *given):
            try:
                return function(*given)
            except contact2d.Cancelled:
                return function(*given)  # a cancel that nobody had met yet

        outcome = []
        try:
            if solver.state == "broken":
                return "broken"
            if solver.state == "model":
                call(solver.prepare)
            call(solver.begin, mu)
            outcome = [int(call(solver.advance, [load] * solver.get_summary().load_cases)) for load in loads]
            tables = [solver.contact(), solver.boundary(1), call(solver.interior, [(0.5, 3.0), (0.1, -0.3)])]
        except contact2d.Cancelled:
            raise
        except contact2d.Error as why:
            return outcome, str(why)
        return outcome, [list(table[name]) for table in tables for name in table.columns]

    def run(self):
        self.disturbed()
        self.plain = True
        mu, loads = self.draw.choice((0.0, 0.2, 0.5)), sorted(self.draw.random() for _ in range(2))
        found = self.numbers(self.solver, mu, loads)
        self.solver.close()
        self.must_refuse_closed()
        plain = contact2d.Solver.of_deck(self.deck)
        for name, given in self.replay:
            getattr(plain, name)(*given)
        wanted = self.numbers(plain, mu, loads)
        assert repr(found) == repr(wanted), "other numbers: %.300r %.300r" % (found, wanted)

    def must_refuse_closed(self):
        try:
            self.solver.prepare()
        except ValueError:
            return
        raise AssertionError("a closed solver works")


def lost(what):
    """What Python cannot raise: only a handler's exception may be, on the first step of __del__ or while Python itself runs
    something of its own that nobody called, as what forgets weak references."""
    module = getattr(what.object, "__module__", None)
    theirs = module is not None and module.split(".")[0] != "contact2d"
    if not isinstance(what.exc_value, Late) or not (theirs or what.object is contact2d.Solver.__del__):
        print("lost:", what.err_msg, what.object, repr(what.exc_value), flush=True)
        os._exit(3)


def child(seed):
    faulthandler.enable()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.signal(signal.SIGALRM, late)
    warnings.simplefilter("ignore")
    sys.unraisablehook = lost
    Case(seed).run()


def run_case(seed):
    """"" or what went wrong."""
    with tempfile.TemporaryFile() as told:
        process = os.fork()
        if process == 0:
            status = 1
            try:
                os.dup2(told.fileno(), 1)
                os.dup2(told.fileno(), 2)
                child(seed)
                status = 0
            except BaseException:
                traceback.print_exc()
            sys.stderr.flush()
            sys.stdout.flush()
            os._exit(status)
        end, done = time.monotonic() + PATIENCE, (0, 0)
        pause = 0.001
        while done[0] == 0 and time.monotonic() < end:
            done = os.waitpid(process, os.WNOHANG)
            time.sleep(0 if done[0] else pause)
            pause = min(2 * pause, 0.02)
        if done[0] == 0:
            os.kill(process, signal.SIGKILL)
            os.waitpid(process, 0)
            return "it hangs"
        told.seek(0)
        text = told.read().decode("utf-8", "replace")
    return "" if done[1] == 0 else "wait status %d\n%s" % (done[1], text)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--cases", type=int, default=0)
    words.add_argument("--seconds", type=float, default=0)
    words = words.parse_args()
    begin, seed, failed = time.monotonic(), words.seed, 0
    while seed < words.seed + words.cases or time.monotonic() < begin + words.seconds:
        why = run_case(seed)
        failed += why != ""
        if why:
            print("seed %d: %s" % (seed, why), file=sys.stderr, flush=True)
        seed += 1
    print("%d cases, %d failed" % (seed - words.seed, failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
