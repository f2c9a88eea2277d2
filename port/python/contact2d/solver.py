"""The solver in this process: a deck or a model by calls, step by step, with results as arrays.

Every function of contact2d.h that works on a solver is a method of Solver, under its name without c2d_.
"""

import ctypes
import enum
import mmap
import os
import pathlib
import queue
import signal
import threading
from ctypes import byref

from . import arrays, calls, header
from .errors import Message, StoreError, WorkspaceError, kind_of
from .library import lib
from .tables import Table


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

    def __str__(self):
        return lib.c2d_outcome_message(int(self)).decode()


PAIR_FIELDS = ["x", "y", "status", "tn", "tt", "un1", "ut1", "un2", "ut2", "gap", "slip_sum", "nx", "ny", "pair_node1",
               "pair_node2", "pair_zone"]
END_FIELDS = ["end_x", "end_y", "end_node", "end_ux", "end_uy", "end_tx", "end_ty", "end_status", "end_sxx", "end_syy",
              "end_sxy", "end_szz", "end_hoop", "end_von_mises", "end_max_shear", "end_principal1", "end_principal2"]
POINT_FIELDS = ["ux", "uy", "sxx", "syy", "sxy", "szz", "von_mises", "max_shear", "principal1", "principal2", "flag"]
OFF_FIELDS = ["length", "zone", "side", "statuses", "equation", "gap", "drift", "equation_energy", "contact_energy"]
STATES = {header.C2D_STATE_EMPTY: "empty", header.C2D_STATE_BUILDING: "building", header.C2D_STATE_MODEL: "model",
          header.C2D_STATE_PREPARED: "prepared", header.C2D_STATE_RUNNING: "running", header.C2D_STATE_BROKEN: "broken"}


def table_of(rows, names):
    """Rows of numbers as a table."""
    if arrays.numpy is not None:
        return Table((name, rows[:, i]) for i, name in enumerate(names))
    return Table((name, [row[i] for row in rows]) for i, name in enumerate(names))


class Step:
    """What a callback of run() sees: the members of c2d_step as attributes, and `table`, a row per pair."""

    KINDS = {header.C2D_STEP_RECORDED: "recorded", header.C2D_STEP_CHANGE: "change", header.C2D_STEP_STOPPED: "stopped"}

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
        self.region = mmap.mmap(-1, need)
        lib.c2d_memory_store_init(byref(self.store), address(self.region), need)

    def done(self):
        self.region = None


class Files:
    """A block store in the files of a folder, which stay there."""

    def __init__(self, port, folder):
        self.store = header.c2d_posix_store()
        code = lib.c2d_posix_store_init(byref(self.store), os.fspath(folder).encode())
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


def address(region):
    return ctypes.addressof(ctypes.c_char.from_buffer(region))


def physical_memory():
    return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


class Solver:
    """A solver with its workspace, its block store and its threads.

        Solver(bodies=[(points, elements, regions), ...], zones=1, pairs=15, ...)    members of c2d_limits by name
        Solver.of_deck("hertz.dat")                                                  with the model in it

    memory    bytes of workspace; without it all that is of use, at most half of the machine's memory
    store     None: blocks are kept in memory; the name of a folder: in files, which stay for restore()
    threads   of assembly, elimination and interior points; no digit of a result depends on it
    progress  a function of (phase, body, done, total, load, target), called at least once per column and event

    Methods raise contact2d.Error; faults, warnings and notes are kept in `messages`. Ctrl-C cancels a call: it raises
    KeyboardInterrupt, and the solver goes on from where it is. Solvers may be used in different threads at once, one solver
    in one thread at a time. close(), or a `with` statement, gives everything back.
    """

    def __init__(self, limits=None, memory=None, store=None, threads=1, progress=None, **sizes):
        self._solver, self._pool, self._store = None, None, None
        self.messages, self._heard = [], []
        self._limits = limits if limits is not None else limits_of(sizes)
        self._port = port = header.c2d_port()
        try:
            self._store = Memory(port) if store is None else Files(port, store)
            self._set_callbacks(progress)
            if threads > 1:
                self._start_threads(threads)
            self._create(memory)
        except BaseException:
            self._let_go()
            raise

    @classmethod
    def of_deck(cls, source, **options):
        """With the model of a deck: the name of its file, or its text. (Of a sketch: Solver.of_deck(contact2d.mesh(...)).)"""
        lines = lines_of(source)
        bodies = (header.c2d_body_limits * max(2, len(lines)))()
        limits, found = header.c2d_limits(bodies=len(bodies), body=bodies), []

        def report(_, entry):
            found.append(Message.of(entry.contents))

        status = lib.c2d_check_deck(calls.read_line(lines), None, byref(limits), header.c2d_report(report), None)
        if status != header.C2D_OK:
            faults = [message for message in found if message.severity == "error"]
            raise kind_of(status)(faults or [Message("error", calls.message(status))], status)
        solver = cls(limits, **options)
        try:
            solver.read_deck(source)
        except BaseException:
            solver.close()
            raise
        return solver

    # ---- what it is made of
    def _set_callbacks(self, progress):
        heard = self._heard  # (not the solver itself, which would keep itself alive)

        def log(_, entry):
            heard.append(Message.of(entry.contents))

        def show(_, now):
            now = now.contents
            try:
                progress(now.phase, now.body, now.done, now.total, now.load, now.target)
            except BaseException as why:  # must not leave the callback: it is raised when the call has returned
                heard.append(why)

        def cancelled(_):
            return 1 if any(isinstance(each, BaseException) for each in heard) else 0

        self._port.log = dict(self._port._fields_)["log"](log)
        if progress is not None:
            self._port.progress = dict(self._port._fields_)["progress"](show)
            self._port.cancel = dict(self._port._fields_)["cancel"](cancelled)

    def _start_threads(self, threads):
        pool = header.c2d_threads()
        code = lib.c2d_threads_start(byref(pool), threads)
        if code != 0:
            raise WorkspaceError([Message("error", "%d threads: %s" % (threads, os.strerror(code)))], code)
        self._pool = pool
        lib.c2d_threads_port(byref(pool), byref(self._port))

    def _create(self, memory):
        least, in_core, why = ctypes.c_uint64(), ctypes.c_uint64(), header.c2d_error()
        self._check(lib.c2d_memory_need(byref(self._limits), byref(least), byref(in_core), byref(why)), why)
        self.bytes = memory if memory is not None else max(least.value, min(in_core.value, physical_memory() // 2))
        self._workspace = mmap.mmap(-1, max(1, self.bytes))
        solver = ctypes.c_void_p()
        self._check(lib.c2d_create(byref(solver), address(self._workspace), self.bytes, byref(self._limits),
                                   byref(self._port), byref(why)), why)
        self._solver = solver
        self._store.make_room(self._limits, self.bytes)

    def _let_go(self):
        if self._pool is not None:
            lib.c2d_threads_stop(byref(self._pool))
        if self._store is not None:
            self._store.done()
        self._pool = self._store = self._workspace = None

    def close(self):
        """Closes the store and gives the memory back. More than once does no harm."""
        solver, self._solver = self._solver, None
        if solver is not None:
            status = lib.c2d_close(solver)
            self._let_go()
            self._check(status, header.c2d_error())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def __del__(self):
        try:
            self.close()
        except Exception:
            pass  # nobody is there to hear it

    # ---- calls
    def _check(self, status, why):
        """Takes over what was logged; raises what failed."""
        heard, self._heard[:] = list(self._heard), []
        raised = [each for each in heard if isinstance(each, BaseException)]
        messages = [each for each in heard if not isinstance(each, BaseException)]
        self.messages += messages
        if raised:
            raise raised[0]
        if status == header.C2D_OK:
            return
        faults = [message for message in messages if message.severity == "error"]
        text = why.text.decode("utf-8", "replace") or calls.message(status)
        known = Message.of(why) if why.text else Message("error", text, status=status)
        error = kind_of(status)(faults or [known], status)
        if isinstance(error, WorkspaceError):
            error.bytes_needed = why.bytes_needed
        if isinstance(error, StoreError):
            error.host_code = why.host_code
        raise error

    def _pointer(self):
        if self._solver is None:
            raise ValueError("the solver is closed")
        return self._solver

    def _call(self, function, *values):
        """A call that may take long: Ctrl-C cancels it."""
        pointer = self._pointer()
        call = getattr(lib, function)
        if threading.current_thread() is threading.main_thread():
            status = self._beside(call, pointer, values)
        else:
            status = call(pointer, *values)
        self._finish(status)

    def _finish(self, status):
        why = header.c2d_error()
        if status != header.C2D_OK:
            lib.c2d_last_error(self._solver, byref(why))
        self._check(status, why)

    def _beside(self, call, pointer, values):
        """Runs the call in a thread of its own, since Python hears Ctrl-C only while no foreign code runs in its main thread.
        What the call asks back (`_ask`) is answered here."""
        hits = []

        def interrupted(number, frame):
            hits.append((number, frame))
            lib.c2d_cancel(pointer)

        before = signal.getsignal(signal.SIGINT)
        if callable(before):
            signal.signal(signal.SIGINT, interrupted)
        try:
            status = self._wait(call, pointer, values)
            if status == header.C2D_ERR_CANCELLED and self._late and not hits:
                status = self._wait(call, pointer, values)  # a Ctrl-C that came when the call before had ended
        finally:
            if callable(before):
                signal.signal(signal.SIGINT, before)
        self._late = bool(hits) and status != header.C2D_ERR_CANCELLED
        if hits:
            try:
                before(*hits[0])
            except BaseException as why:
                self._heard.append(why)
        return status

    def _wait(self, call, pointer, values):
        self._inbox = inbox = queue.SimpleQueue()
        worker = threading.Thread(target=lambda: inbox.put(call(pointer, *values)), daemon=True)
        worker.start()
        content = inbox.get()
        while callable(content):
            content()
            content = inbox.get()
        worker.join()
        self._inbox = None
        return content

    _late = False
    _inbox = None

    def _ask(self, function):
        """The answer of a user's function, in the thread that called the solver; None and an exception kept if it raised."""
        def answer():
            try:
                answers.append(function())
            except BaseException as why:
                self._heard.append(why)
                answers.append(None)
            done.release()

        answers, done = [], threading.Semaphore(0)
        if self._inbox is None:
            answer()
        else:
            self._inbox.put(answer)
        done.acquire()
        return answers[0]

    @property
    def state(self):
        """"empty", "building", "model", "prepared", "running" or "broken" (contact2d.h, section 9)."""
        return STATES[self.get_state()]

    @property
    def warnings(self):
        return [message for message in self.messages if message.severity == "warning"]

    def cancel(self):
        """From another thread: the call at work raises Cancelled."""
        lib.c2d_cancel(self._pointer())

    # ---- calls whose arguments are not as in C
    def read_deck(self, source):
        """The model of a deck: the name of its file, or its text."""
        self._finish(lib.c2d_read_deck(self._pointer(), calls.read_line(lines_of(source)), None))

    def set_nodes(self, body, first, xy):
        """Boundary points from number `first` on: rows (x, y)."""
        pointer, count, kept = arrays.doubles(xy)
        if count % 2:
            raise TypeError("set_nodes: expected rows (x, y), not %d numbers" % count)
        self._finish(lib.c2d_set_nodes(self._pointer(), body, first, count // 2, pointer, 2))
        del kept

    def advance(self, load):
        """Follows the load from the factors reached to these, one per load case; the Outcome says how it ended."""
        pointer, count, kept = arrays.doubles(load)
        outcome = ctypes.c_int32()
        self._call("c2d_advance", pointer, count, byref(outcome))
        del kept
        return Outcome(outcome.value)

    def run(self, step=None):
        """The model's own load cards for each of its coefficients of friction. `step` is called with a Step at the end of
        every increment, and where a path stops; if it returns something true the run ends. True: it came to its end."""
        stopped = []

        def seen(_, now):
            now = Step(now.contents)
            if self._ask(lambda: step(now)):
                stopped.append(now)
            return 1 if stopped or any(isinstance(each, BaseException) for each in self._heard) else 0

        callback = header.c2d_step_fn(seen) if step is not None else header.c2d_step_fn()
        try:
            self._call("c2d_run", callback, None)
        except Exception as why:
            if not stopped or getattr(why, "status", None) != header.C2D_ERR_CALLBACK:
                raise
        return not stopped

    def get_path(self, i):
        """(increments, load factors) of a piece of the load path."""
        increments, loads = ctypes.c_int32(), (ctypes.c_double * max(1, self.get_summary().load_cases))()
        self._finish(lib.c2d_get_path(self._pointer(), i, byref(increments), loads, len(loads)))
        return increments.value, list(loads)

    def get_name(self, kind, i):
        out = ctypes.create_string_buffer(32)
        self._finish(lib.c2d_get_name(self._pointer(), kind, i, out))
        return out.value.decode("utf-8", "replace")

    def last_error(self):
        """Why the last call failed, as a Message."""
        why = header.c2d_error()
        lib.c2d_last_error(self._pointer(), byref(why))
        return Message.of(why)

    def get_state(self):
        """C2D_STATE_...; `state` has it in words."""
        return lib.c2d_get_state(self._pointer())

    # ---- results
    def count(self, field, body=0):
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

    def get(self, field, body=0, first=1, count=None):
        """A field of contact2d_codes.h, as "tn" or "end_hoop": of pairs, or of a body's element ends, nodes or elements."""
        count = self.count(field, body) - first + 1 if count is None else count
        out = (ctypes.c_double * max(1, count))()
        self._call("c2d_get", field_number(field), body, first, count, out, 1)
        return arrays.shaped(out[:count])

    def contact(self):
        """A table with a row per pair."""
        return Table((name, self.get(name)) for name in PAIR_FIELDS)

    def boundary(self, body):
        """A table with a row per element end of a body: displacements, tractions, stresses."""
        return Table((name[4:], self.get(name, body)) for name in END_FIELDS)

    def interior(self, xy, body=0):
        """A table with displacements and stresses at points, rows (x, y); body 0: whichever each lies in."""
        pointer, count, kept = arrays.doubles(xy)
        if count % 2:
            raise TypeError("interior: expected rows (x, y), not %d numbers" % count)
        out = (ctypes.c_double * max(1, count // 2 * header.C2D_POINT_FIELDS))()
        self._call("c2d_interior", body, count // 2, pointer, 2, out, header.C2D_POINT_FIELDS)
        places = arrays.shaped(pointer[:count], 2)
        del kept
        table = table_of(arrays.shaped(out[: count // 2 * header.C2D_POINT_FIELDS], header.C2D_POINT_FIELDS), POINT_FIELDS)
        return Table(list(table_of(places, ["x", "y"]).items()) + list(table.items()))

    def indicators(self, body, first=1, count=None):
        """A table with what the mesh leaves open, a row per element (C2D_OFF_...)."""
        count = self.get_body_result(body).elements - first + 1 if count is None else count
        out = (ctypes.c_double * max(1, count * header.C2D_OFF_FIELDS))()
        self._call("c2d_indicators", body, first, count, out, header.C2D_OFF_FIELDS)
        return table_of(arrays.shaped(out[: count * header.C2D_OFF_FIELDS], header.C2D_OFF_FIELDS), OFF_FIELDS)


LONG = {"c2d_prepare", "c2d_begin", "c2d_next_event", "c2d_save", "c2d_restore"}


def method_of(function):
    """A method that calls a function of the interface: arguments by place or by name, outputs returned."""
    def method(self, *given, **named):
        bound = calls.Arguments(function, given, named).bind()
        if function in LONG:
            self._call(function, *bound.values)
        else:
            self._finish(getattr(lib, function)(self._pointer(), *bound.values))
        return bound.results()

    method.__name__ = method.__qualname__ = function[4:]
    method.__doc__ = header.FUNCTIONS[function][2]
    return method


def add_methods():
    for function, (_, arguments, _) in header.FUNCTIONS.items():
        if arguments and arguments[0][0] == "solver" and not hasattr(Solver, function[4:]):
            setattr(Solver, function[4:], method_of(function))


add_methods()


def field_number(field):
    number = getattr(header, "C2D_" + field.upper(), None) if isinstance(field, str) else field
    if not isinstance(number, int):
        raise ValueError("there is no field %r; see contact2d_codes.h" % (field,))
    return number


def limits_of(sizes):
    """A c2d_limits from its members by name; `bodies`: a (points, elements, regions) for each."""
    sizes = dict(sizes)
    bodies = [tuple(body) for body in sizes.pop("bodies", [])]
    listed = (header.c2d_body_limits * max(1, len(bodies)))(*[header.c2d_body_limits(*body) for body in bodies])
    limits = calls.fill(header.c2d_limits(), sizes)
    limits.bodies, limits.body = len(bodies), listed
    return limits


def lines_of(source):
    """The lines of a deck as bytes: of its text, or of the file of this name."""
    if isinstance(source, str) and "\n" in source:
        return source.encode("utf-8").splitlines()
    return pathlib.Path(source).read_bytes().splitlines()


def expand_points(points, **members):
    """The points of a set (a c2d_points, a mapping, or members by name) as rows (x, y)."""
    points = calls.fill(header.c2d_points(), dict(points, **members)) if not isinstance(points, header.c2d_points) else points
    total = ctypes.c_int32()
    for count in (0, None):
        count = total.value if count is None else count
        xy = (ctypes.c_double * max(2, 2 * count))()
        status = lib.c2d_expand_points(byref(points), 1, count, xy, 2, byref(total))
        if status != header.C2D_OK:
            raise kind_of(status)([Message("error", calls.message(status))], status)
    return arrays.shaped(xy[: 2 * count], 2)
