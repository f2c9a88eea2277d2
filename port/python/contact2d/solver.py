"""The solver in this process: a deck or a model by calls, step by step, with results as arrays.

Every function of contact2d.h that works on a solver is a method of Solver, under its name without c2d_.
"""

from __future__ import annotations

import ctypes
import enum
import mmap
import os
import pathlib
import sys
import threading
from collections.abc import Mapping
from ctypes import byref
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from . import arrays, calls, header
from .errors import Message, StoreError, UsageError, WorkspaceError, kind_of, offer
from .library import lib
from .methods import SolverCalls
from .tables import Table
from .worker import Closed, Worker


Source = Union[str, "os.PathLike[str]"]  # the name of a file, or text of more than one line


class Outcome(enum.IntEnum):
    """How a load path ended; as text in the library's words."""

    REACHED = header.C2D_REACHED
    FREE_MOTION = header.C2D_FREE_MOTION
    GROSS_SLIDING = header.C2D_GROSS_SLIDING
    NO_ADMISSIBLE_CHANGE = header.C2D_NO_ADMISSIBLE_CHANGE
    NO_PROGRESS = header.C2D_NO_PROGRESS
    UNDECIDED = header.C2D_UNDECIDED
    TIPPING = header.C2D_TIPPING
    BEYOND_LIMITS = header.C2D_BEYOND_LIMITS

    def __str__(self) -> str:
        return lib.c2d_outcome_message(int(self)).decode()


PAIR_FIELDS = ["x", "y", "status", "tn", "tt", "un1", "ut1", "un2", "ut2", "gap", "slip_sum", "nx", "ny", "pair_node1",
               "pair_node2", "pair_zone"]
END_FIELDS = ["end_x", "end_y", "end_node", "end_ux", "end_uy", "end_tx", "end_ty", "end_status", "end_sxx", "end_syy",
              "end_sxy", "end_szz", "end_hoop", "end_von_mises", "end_max_shear", "end_principal1", "end_principal2"]
POINT_FIELDS = ["ux", "uy", "sxx", "syy", "sxy", "szz", "von_mises", "max_shear", "principal1", "principal2", "flag"]
OFF_FIELDS = ["length", "zone", "side", "statuses", "equation", "gap", "drift", "equation_energy", "contact_energy"]
CYCLE_MODES = ["exact", "plain", "fast"]  # C2D_CYCLES_...
CYCLE_FIELDS = ["range", "walk", "stuck", "touched"]  # C2D_CYCLE_RANGE ...
STATES = {header.C2D_STATE_EMPTY: "empty", header.C2D_STATE_BUILDING: "building", header.C2D_STATE_MODEL: "model",
          header.C2D_STATE_PREPARED: "prepared", header.C2D_STATE_RUNNING: "running", header.C2D_STATE_BROKEN: "broken"}


def table_of(rows: Any, names: Sequence[str]) -> Table:
    """Rows of numbers as a table."""
    if arrays.numpy is not None:
        return Table((name, rows[:, i]) for i, name in enumerate(names))
    return Table((name, [row[i] for row in rows]) for i, name in enumerate(names))


class Step:
    """What a callback of run() sees: the members of c2d_step as attributes, and `table`, a row per pair."""

    KINDS = {header.C2D_STEP_RECORDED: "recorded", header.C2D_STEP_CHANGE: "change", header.C2D_STEP_STOPPED: "stopped",
             header.C2D_STEP_CYCLE: "cycle"}

    def __init__(self, now):
        self.kind, self.outcome = self.KINDS[now.kind], Outcome(now.outcome)
        for name in ("coefficient", "step", "changes", "iterations", "mu", "load", "work", "dissipated", "elastic",
                     "energy_defect"):
            setattr(self, name, getattr(now, name))
        self.loads, self.work_by_case = list(now.loads[: now.cases]), list(now.work_by_case[: now.cases])
        stride = max(now.stride, 1)
        rows = [now.table[pair * stride : pair * stride + header.C2D_PAIR_FIELDS] for pair in range(now.pairs)]
        self.table = table_of(arrays.shaped([value for row in rows for value in row], header.C2D_PAIR_FIELDS), PAIR_FIELDS)


class Memory:
    """A block store in memory. Pages that are not written take no room, so it is as large as any model could need."""

    def __init__(self, port):
        self.store, self.region, self.bytes = header.c2d_memory_store(), None, 0
        lib.c2d_memory_store_init(byref(self.store), None, 0)
        lib.c2d_memory_store_port(byref(self.store), byref(port))

    def make_room(self, limits, workspace):
        options, blocks, size = header.c2d_options(keep_factors=1), ctypes.c_uint64(), ctypes.c_uint64()
        need = 0
        for tape in range(header.C2D_TAPES):
            status = lib.c2d_tape_need(byref(limits), byref(options), workspace, tape, byref(blocks), byref(size), None)
            if status != header.C2D_OK:
                raise kind_of(status)([Message("error", calls.message(status))], status)
            need += blocks.value * (size.value + 64) + 4096
        self.region = memory_of(need)
        lib.c2d_memory_store_init(byref(self.store), address(self.region), need)

    def done(self):
        self.region = None


class Files:
    """A block store in the files of a folder, which stay there."""

    def __init__(self, port, folder):
        self.store = header.c2d_posix_store()
        code = lib.c2d_posix_store_init(byref(self.store), calls.text("store", os.fsencode(folder)))
        if code != 0:
            why = {header.C2D_POSIX_STORE_LOCKED: "in use by another store", header.C2D_POSIX_STORE_FOREIGN:
                   "what stands there is not ours"}.get(code) or os.strerror(code)
            error = StoreError([Message("error", "%s: %s" % (folder, why))], header.C2D_ERR_STORE_OPEN)
            error.host_code = code
            raise error
        lib.c2d_posix_store_port(byref(self.store), byref(port))

    def make_room(self, limits, workspace):
        pass

    def done(self):
        lib.c2d_posix_store_done(byref(self.store))


def memory_of(size):
    """Memory of this process alone: a child has a copy, as of everything else."""
    try:
        return mmap.mmap(-1, max(1, size), flags=mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
    except (OSError, OverflowError):
        raise WorkspaceError([Message("error", "%d bytes cannot be had" % size)], header.C2D_ERR_MEMORY) from None


def address(region):
    return ctypes.addressof(ctypes.c_char.from_buffer(region))


def physical_memory():
    return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


class Origin:
    """Where the lines of messages stand: in the file of a deck, or in those of a script (`lines`)."""

    def __init__(self) -> None:
        self.file: Optional[str] = None
        self.lines: Dict[int, str] = {}

    def message_of(self, entry: header.c2d_error) -> Message:
        message = Message.of(entry)
        message.name = self.lines.get(message.line, self.file)
        return message


class Solver(SolverCalls):
    """A solver with its workspace, its block store and its threads.

        Solver(bodies=[(points, elements, regions), ...], zones=1, pairs=15, ...)    members of c2d_limits by name
        Solver.of_deck("hertz.dat")                                                  with the model in it

    memory    bytes of workspace; without it all that is of use, at most half of the machine's memory
    store     None: blocks are kept in memory; the name of a folder: in files, which stay for restore()
    threads   of assembly, elimination and interior points; no digit of a result depends on it
    progress  a function of (phase, body, done, total, load, target), called at least once per column and event

    Arguments that C could not take are ValueError or TypeError and name the argument; what a call of the library finds wrong
    is contact2d.Error. Faults, warnings and notes are kept in `messages`.

    A call is waited for in any case. What a handler of a signal raises meanwhile (Ctrl-C: KeyboardInterrupt) cancels it and is
    raised afterwards, and the solver goes on from where it is; what progress or the step of run() raises ends it likewise.
    Within those two get_zone_state and what else section 3 of contact2d.h lists is legal, close() is not. A solver may be used
    from any thread; one call is made after the other. In a child of its process (os.fork, multiprocessing) every method
    raises: the child makes a solver of its own. close(), or a `with` statement, gives everything back.
    """

    def __init__(self, limits: Any = None, memory: Optional[int] = None, store: Union[None, str, os.PathLike[str]] = None,
                 threads: int = 1, progress: Optional[Callable[..., Any]] = None, **sizes: Any) -> None:
        self._solver = self._pool = self._store = self._workspace = None
        self._process, self._gate, self._worker = os.getpid(), threading.RLock(), None
        self.messages: List[Message] = []
        self._heard: List[Any] = []
        self._cancelled_by: Optional[str] = None
        self._port, self._origin = header.c2d_port(), Origin()
        if limits is not None and sizes:
            raise TypeError("limits are given, and by name: %s" % ", ".join(sorted(sizes)))
        self._limits = limits if isinstance(limits, Limits) else limits_of(sizes if limits is None else limits)
        memory = None if memory is None else arrays.integer("memory", memory, ctypes.c_int64, 1)
        threads = arrays.integer("threads", threads, least=1)
        store = None if store is None else os.fspath(store)
        if progress is not None and not callable(progress):
            raise TypeError("progress is %r, expected a function" % (progress,))
        self._worker = Worker()
        try:
            _, raised = self._run(lambda: self._build(memory, store, threads, progress))
            if raised:
                raise raised[0]
        except BaseException:
            self.close()
            raise

    def _build(self, memory, store, threads, progress):
        self._store = Memory(self._port) if store is None else Files(self._port, store)
        self._worker.kept.append(self._store)
        self._set_callbacks(progress)
        if threads > 1:
            self._start_threads(threads)
        self._create(memory)

    @classmethod
    def of_deck(cls, source: Source, cycle_states: int = 0, **options: Any) -> Solver:
        """With the model of a deck: the name of its file, or its text. (Of a sketch: Solver.of_deck(contact2d.mesh(...)).)
        `cycle_states`: of c2d_limits, 20 to 40 for cycle()."""
        limits = limits_of_deck(source)
        limits.cycle_states = arrays.integer("of_deck: 'cycle_states'", cycle_states, least=0)
        solver = cls(limits, **options)
        try:
            solver.read_deck(source)
        except BaseException:
            solver.close()
            raise
        return solver

    # ---- what it is made of
    def _set_callbacks(self, progress):
        heard, worker, origin = self._heard, self._worker, self._origin  # (not the solver itself, which would keep itself alive)

        def log(_, entry):
            heard.append(origin.message_of(entry.contents))

        def show(_, now):
            now = now.contents
            worker.ask(lambda: progress(now.phase, now.body, now.done, now.total, now.load, now.target), None)

        self._port.log = dict(self._port._fields_)["log"](log)
        if progress is not None:
            self._port.progress = dict(self._port._fields_)["progress"](show)
            self._port.cancel = dict(self._port._fields_)["cancel"](lambda _: 1 if worker.has_raised() else 0)

    def _start_threads(self, threads):
        pool = header.c2d_threads()
        code = lib.c2d_threads_start(byref(pool), threads)
        if code != 0:
            raise WorkspaceError([Message("error", "%d threads: %s" % (threads, os.strerror(code)))], code)
        self._pool = pool
        self._worker.kept.append(pool)
        lib.c2d_threads_port(byref(pool), byref(self._port))

    def _create(self, memory):
        least, in_core, why = ctypes.c_uint64(), ctypes.c_uint64(), header.c2d_error()
        self._check(lib.c2d_memory_need(byref(self._limits), byref(least), byref(in_core), byref(why)), why)
        self.bytes = memory if memory is not None else max(least.value, min(in_core.value, physical_memory() // 2))
        self._workspace = memory_of(self.bytes)
        solver = ctypes.c_void_p()
        self._check(lib.c2d_create(byref(solver), address(self._workspace), self.bytes, byref(self._limits),
                                   byref(self._port), byref(why)), why)
        self._solver = solver
        self._store.make_room(self._limits, self.bytes)

    def _give_back(self):
        with self._gate:
            solver, self._solver = self._solver, None
        status = header.C2D_OK if solver is None else lib.c2d_close(solver)
        if self._pool is not None:
            lib.c2d_threads_stop(byref(self._pool))
        if self._store is not None:
            self._store.done()
        self._worker.kept.clear()
        self._pool = self._store = self._workspace = None
        return status

    def close(self) -> None:
        """Closes the store and gives the memory back. More than once does no harm; within a callback it is refused."""
        self._check_process()
        if self._worker is None:
            return  # it was never made
        if self._worker.is_inside():
            raise UsageError([Message("error", "close: the solver is at work, this is one of its callbacks")],
                             header.C2D_ERR_BUSY)
        try:
            status, raised = self._run(self._give_back)
        except Closed:
            return
        self._worker.stop()
        self._check(status, header.c2d_error(), raised)

    def __enter__(self) -> Solver:
        self._check_process()
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        try:
            if self._process == os.getpid():
                self.close()
        except BaseException:
            pass  # nobody is there to hear it

    def __reduce__(self) -> Any:
        raise TypeError("a Solver belongs to its process: neither pickled nor copied")

    # ---- calls
    def _check_process(self):
        if self._process != os.getpid():
            raise UsageError([Message("error", "the solver belongs to process %d, this is a child of it: make another one here" %
                                      self._process)], header.C2D_ERR_STATE)

    def _run(self, work):
        """(what work() returns, what was raised meanwhile); work() runs where no handler of a signal does."""
        self._check_process()
        if self._worker.is_inside() or sys.is_finalizing():
            return work(), []
        return self._worker.run(work, self._stop)

    def _stop(self):
        """Cancels the call at work because something was raised."""
        with self._gate:
            if self._solver is not None:
                lib.c2d_cancel(self._solver)
                self._cancelled_by = self._cancelled_by or "us"

    def cancel(self) -> None:
        """From another thread, or a callback: the call at work raises Cancelled."""
        self._check_process()
        with self._gate:
            lib.c2d_cancel(self._pointer())
            self._cancelled_by = "user"

    def _pointer(self):
        if self._solver is None:
            raise Closed("the solver is closed")
        return self._solver

    def _call(self, function, *values):
        """A call of the library on this solver."""
        def work():
            status = getattr(lib, function)(self._pointer(), *values)
            why = header.c2d_error()
            if status != header.C2D_OK:
                lib.c2d_last_error(self._pointer(), byref(why))
            return status, why

        def checked():
            earlier, self._cancelled_by = self._cancelled_by, None
            status, why = work()
            is_of_this = self._cancelled_by or self._worker.has_raised()
            if status == header.C2D_ERR_CANCELLED and earlier == "us" and not is_of_this:
                status, why = work()  # our cancel had come when the call before had ended
            if status != header.C2D_ERR_CANCELLED:
                self._cancelled_by = self._cancelled_by or earlier  # no cancel is lost
            return status, why

        (status, why), raised = self._run(checked)
        self._check(status, why, raised)

    def _check(self, status, why, raised=()):
        """Takes over what was logged; raises what failed."""
        messages, self._heard[:] = list(self._heard), []
        self.messages += messages
        if raised:
            raise raised[0]
        if status == header.C2D_OK:
            return
        faults = [message for message in messages if message.severity == "error"]
        text = why.text.decode("utf-8", "replace") or calls.message(status)
        known = self._origin.message_of(why) if why.text else Message("error", text, status=status)
        error = kind_of(status)(faults or [known], status)
        if isinstance(error, WorkspaceError):
            error.bytes_needed = why.bytes_needed
        if isinstance(error, StoreError):
            error.host_code = why.host_code
        raise error

    @property
    def state(self) -> str:
        """"empty", "building", "model", "prepared", "running" or "broken" (contact2d.h, section 9)."""
        return STATES[self.get_state()]

    @property
    def warnings(self) -> List[Message]:
        return [message for message in self.messages if message.severity == "warning"]

    # ---- calls whose arguments are not as in C
    def read_deck(self, source: Source) -> None:
        """The model of a deck: the name of its file, or its text."""
        self._origin.file = name_of(source)
        self._call("c2d_read_deck", calls.read_line(lines_of(source)), None)

    def set_nodes(self, body: int, first: int, xy: Any) -> None:
        """Boundary points from number `first` on: rows (x, y)."""
        body, first = arrays.integer("set_nodes: 'body'", body), arrays.integer("set_nodes: 'first'", first)
        pointer, count, kept = arrays.doubles("set_nodes: 'xy'", xy, 2)
        self._call("c2d_set_nodes", body, first, count // 2, pointer, 2)
        del kept

    def advance(self, load: Any) -> Outcome:
        """Follows the load from the factors reached to these, one per load case; the Outcome says how it ended."""
        pointer, count, kept = arrays.doubles("advance: 'load'", load)
        outcome = ctypes.c_int32()
        self._call("c2d_advance", pointer, count, byref(outcome))
        del kept
        return Outcome(outcome.value)

    def run(self, step: Optional[Callable[[Step], Any]] = None) -> bool:
        """The model's own load cards for each of its coefficients of friction. `step` is called with a Step at the end of
        every increment, and where a path stops; if it returns something true the run ends. True: it came to its end."""
        if step is not None and not callable(step):
            raise TypeError("run: 'step' is %r, expected a function" % (step,))
        stopped = []

        def seen(_, now):
            if self._worker.ask(lambda: step(Step(now.contents)), True):
                stopped.append(True)
            return 1 if stopped else 0

        callback = header.c2d_step_fn(seen) if step is not None else header.c2d_step_fn(0)
        try:
            self._call("c2d_run", callback, None)
        except Exception as why:
            if not stopped or getattr(why, "status", None) != header.C2D_ERR_CALLBACK:
                raise
        return not stopped

    def cycle(self, load: Any, limit: int = 0, tolerance: float = 0.0, mode: str = "exact",
              each: Optional[Callable[[Any], Any]] = None) -> Any:
        """Repeats a cycle of loads until it is steady: c2d_cycle. `load`: its corners, rows of one factor per load case; the last
        one is the load reached. `each` is called after every cycle with the members of c2d_cycle_state; if it returns something
        true, no further cycle is followed. Returns these members."""
        if mode not in CYCLE_MODES:
            raise ValueError("cycle: 'mode' is %r, expected one of %s%s" % (mode, ", ".join(CYCLE_MODES), offer(mode, CYCLE_MODES)))
        if each is not None and not callable(each):
            raise TypeError("cycle: 'each' is %r, expected a function" % (each,))
        cases = self.get_summary().load_cases
        if not arrays.is_list(load):
            raise TypeError("cycle: 'load' is %r, expected rows of load factors" % (load,))
        rows = [arrays.listed("cycle: 'load'", row) for row in load]
        if any(len(row) != cases for row in rows):
            raise TypeError("cycle: 'load' has rows of %s factors, expected %d" % (sorted({len(row) for row in rows}), cases))
        pointer, count, kept = arrays.doubles("cycle: 'load'", [factor for row in rows for factor in row])
        request, state, seen = header.c2d_cycle_request(), header.c2d_cycle_state(), []
        request.corners, request.cases, request.mode = count // cases, cases, CYCLE_MODES.index(mode)
        request.limit = arrays.integer("cycle: 'limit'", limit, least=0)
        request.tolerance = arrays.real("cycle: 'tolerance'", tolerance)
        request.load = ctypes.cast(pointer, type(request.load))

        def show(_, now):
            plain = calls.plain(now.contents)
            if self._worker.ask(lambda: each(plain), True):
                seen.append(plain)
            return 1 if seen else 0

        callback = header.c2d_cycle_fn(show) if each is not None else header.c2d_cycle_fn(0)
        try:
            self._call("c2d_cycle", byref(request), callback, None, byref(state))
        except Exception as why:
            if not seen or getattr(why, "status", None) != header.C2D_ERR_CALLBACK:
                raise
            return seen[-1]
        del kept
        return calls.plain(state)

    def get_cycle(self, field: str) -> Any:
        """Of each pair over the last cycle that cycle() followed: "range", "walk", "stuck" or "touched"."""
        if field not in CYCLE_FIELDS:
            raise ValueError("get_cycle: 'field' is %r, expected one of %s" % (field, ", ".join(CYCLE_FIELDS)))
        many = self.get_summary().pairs
        out = (ctypes.c_double * max(1, many))()
        self._call("c2d_get_cycle", CYCLE_FIELDS.index(field), 1, many, out, 1)
        return arrays.shaped(out[:many])

    def get_path(self, i: int) -> Tuple[int, List[float]]:
        """(increments, load factors) of a piece of the load path."""
        i = arrays.integer("get_path: 'i'", i)
        increments, loads = ctypes.c_int32(), (ctypes.c_double * max(1, self.get_summary().load_cases))()
        self._call("c2d_get_path", i, byref(increments), loads, len(loads))
        return increments.value, list(loads)

    def get_name(self, kind: int, i: int) -> str:
        kind, i = arrays.integer("get_name: 'kind'", kind), arrays.integer("get_name: 'i'", i)
        out = ctypes.create_string_buffer(32)
        self._call("c2d_get_name", kind, i, out)
        return out.value.decode("utf-8", "replace")

    def last_error(self) -> Message:
        """Why the last call failed, as a Message."""
        why = header.c2d_error()
        self._call("c2d_last_error", byref(why))
        return Message.of(why)

    def get_state(self) -> int:
        """C2D_STATE_...; `state` has it in words."""
        state, raised = self._run(lambda: lib.c2d_get_state(self._pointer()))
        if raised:
            raise raised[0]
        return state

    # ---- results
    def count(self, field: Union[str, int], body: int = 0) -> int:
        """How many entries a field of get() has."""
        number = field_number(field)
        summary = self.get_summary()
        if number < header.C2D_END_X or header.C2D_PAIR_ELEMENT1 <= number <= header.C2D_PAIR_ETA1:
            return summary.pairs
        found = self.get_body_result(body)
        if number in (header.C2D_NODE_X, header.C2D_NODE_Y):
            return found.points
        per_element = summary.function_nodes if number < header.C2D_NODE_X else 1
        return found.elements * per_element

    def get(self, field: Union[str, int], body: int = 0, first: int = 1, count: Optional[int] = None) -> Any:
        """A field of contact2d_codes.h, as "tn" or "end_hoop": of pairs, or of a body's element ends, nodes or elements."""
        number, body = field_number(field), arrays.integer("get: 'body'", body)
        first, many = entries("get", first, count, self.count(number, body))
        out = (ctypes.c_double * max(1, many))()
        self._call("c2d_get", number, body, first, many, out, 1)
        return arrays.shaped(out[:many])

    def contact(self) -> Table:
        """A table with a row per pair."""
        return Table((name, self.get(name)) for name in PAIR_FIELDS)

    def boundary(self, body: int) -> Table:
        """A table with a row per element end of a body: displacements, tractions, stresses."""
        return Table((name[4:], self.get(name, body)) for name in END_FIELDS)

    def interior(self, xy: Any, body: int = 0) -> Table:
        """A table with displacements and stresses at points, rows (x, y); body 0: whichever each lies in."""
        body = arrays.integer("interior: 'body'", body)
        pointer, count, kept = arrays.doubles("interior: 'xy'", xy, 2)
        out = (ctypes.c_double * max(1, count // 2 * header.C2D_POINT_FIELDS))()
        self._call("c2d_interior", body, count // 2, pointer, 2, out, header.C2D_POINT_FIELDS)
        places = arrays.shaped(pointer[:count], 2)
        del kept
        table = table_of(arrays.shaped(out[: count // 2 * header.C2D_POINT_FIELDS], header.C2D_POINT_FIELDS), POINT_FIELDS)
        return Table(list(table_of(places, ["x", "y"]).items()) + list(table.items()))

    def indicators(self, body: int, first: int = 1, count: Optional[int] = None) -> Table:
        """A table with what the mesh leaves open, a row per element (C2D_OFF_...)."""
        body = arrays.integer("indicators: 'body'", body)
        first, many = entries("indicators", first, count, self.get_body_result(body).elements)
        out = (ctypes.c_double * max(1, many * header.C2D_OFF_FIELDS))()
        self._call("c2d_indicators", body, first, many, out, header.C2D_OFF_FIELDS)
        return table_of(arrays.shaped(out[: many * header.C2D_OFF_FIELDS], header.C2D_OFF_FIELDS), OFF_FIELDS)


def method_of(function):
    """A method that calls a function of the interface: arguments by place or by name, outputs returned."""
    def method(self, *given, **named):
        bound = calls.Arguments(function, given, named).bind()
        self._call(function, *bound.values)
        return bound.results()

    method.__name__ = method.__qualname__ = function[4:]
    method.__signature__ = calls.signature_of(function)
    method.__doc__ = header.FUNCTIONS[function][2]
    return method


def add_methods():
    for function, (_, arguments, _) in header.FUNCTIONS.items():
        if arguments and arguments[0][0] == "solver" and not hasattr(Solver, function[4:]):
            setattr(Solver, function[4:], method_of(function))


add_methods()


FIELDS = {name: getattr(header, "C2D_" + name.upper()) for name in PAIR_FIELDS + END_FIELDS + [
    "node_x", "node_y", "pair_element1", "pair_eta1", "surface_x", "surface_y"]}


def field_number(field: Union[str, int]) -> int:
    """Of a name, or of a number that is one already."""
    if isinstance(field, str):
        if field.lower() not in FIELDS:
            raise ValueError("there is no field %r%s" % (field, offer(field, FIELDS)))
        return FIELDS[field.lower()]
    return arrays.integer("field", field)


def entries(function, first, count, there):
    """(first, count) of a range among so many entries."""
    first = arrays.integer("%s: 'first'" % function, first, least=1)
    rest = max(there - first + 1, 0)
    count = rest if count is None else arrays.integer("%s: 'count'" % function, count, least=0)
    if count > rest:
        raise ValueError("%s: 'count' is %d, expected at most %d: there are %d entries" % (function, count, rest, there))
    return first, count


class Limits(header.c2d_limits):
    """A c2d_limits whose list was made here."""


Limits.__name__ = header.c2d_limits.__name__  # as messages call it


def limits_of(sizes: Any) -> Limits:
    """Limits from members by name; `bodies`: a (points, elements, regions) for each."""
    if not isinstance(sizes, Mapping):
        raise TypeError("limits is %r, expected members of c2d_limits by name" % (sizes,))
    sizes = dict(sizes)
    bodies = sizes.pop("bodies", [])
    if not arrays.is_list(bodies):
        raise TypeError("bodies is %r, expected a list of (points, elements, regions)" % (bodies,))
    listed = []
    for i, body in enumerate(bodies, 1):
        where = "bodies: body %d" % i
        if not arrays.is_list(body) or len(body) != 3:
            raise TypeError("%s is %r, expected (points, elements, regions)" % (where, body))
        listed.append(header.c2d_body_limits(*[arrays.integer(where, number, least=0) for number in body]))
    limits = calls.fill(Limits(), sizes)
    limits.body = (header.c2d_body_limits * max(1, len(listed)))(*listed)
    limits.bodies = len(listed)
    return limits


def limits_of_deck(source: Source) -> Limits:
    """Limits of a deck; its faults are raised."""
    lines, found, limits = lines_of(source), [], Limits()
    limits.bodies = max(2, len(lines))
    limits.body = (header.c2d_body_limits * limits.bodies)()
    origin = Origin()
    origin.file = name_of(source)
    report = header.c2d_report(lambda _, entry: found.append(origin.message_of(entry.contents)))
    worker = Worker()
    try:
        status, raised = worker.run(lambda: lib.c2d_check_deck(calls.read_line(lines), None, byref(limits), report, None),
                                    lambda: None)
    finally:
        worker.stop()
    if raised:
        raise raised[0]
    if status != header.C2D_OK:
        faults = [message for message in found if message.severity == "error"]
        raise kind_of(status)(faults or [Message("error", calls.message(status), name=origin.file)], status)
    return limits


def name_of(source: Source) -> Optional[str]:
    """The name of a deck's file; None: the source is its text."""
    return None if isinstance(source, str) and "\n" in source else os.fsdecode(source)


def lines_of(source: Source) -> List[bytes]:
    """The lines of a deck as bytes: of its text, or of the file of this name."""
    if isinstance(source, str) and "\n" in source:
        return source.encode("utf-8").splitlines()
    return pathlib.Path(source).read_bytes().splitlines()


def expand_points(points: Any, **members: Any) -> Any:
    """The points of a set (a c2d_points, a mapping, or members by name) as rows (x, y)."""
    if isinstance(points, Mapping):
        points = calls.fill(header.c2d_points(), dict(points, **members))
    elif not isinstance(points, header.c2d_points) or members:
        raise TypeError("points is %r, expected a c2d_points, a mapping, or members by name" % (points,))
    total = ctypes.c_int32()
    for is_counted in (False, True):
        count = total.value if is_counted else 0
        if 16 * count > physical_memory():
            raise MemoryError("%d points" % count)
        xy = (ctypes.c_double * max(2, 2 * count))()
        status = lib.c2d_expand_points(byref(points), 1, count, xy, 2, byref(total))
        if status != header.C2D_OK:
            raise kind_of(status)([Message("error", calls.message(status))], status)
    return arrays.shaped(xy[: 2 * count], 2)
