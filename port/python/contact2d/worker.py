"""Foreign calls in a thread of their own, every one of them waited for.

Handlers of signals run in Python's main thread, at any moment at which it runs Python, and may raise: within a callback of a
foreign call what they raise would be lost, and where the caller waits for the call it would leave the call running with memory
that is given back. So a worker makes the calls, one after the other. Its caller waits for the end of each, answers what
callbacks ask, and raises afterwards what was raised meanwhile.
"""

import atexit
import os
import queue
import sys
import threading
import time
import weakref

from . import header
from .errors import Message, UsageError

PATIENCE = 0.1  # seconds after which a thread looks whether the other has gone, and runs handlers of signals


def hear(bell):
    """Waits for a bell with patience: a signal that comes just before a wait would not end it."""
    try:
        bell.get(timeout=PATIENCE)
    except queue.Empty:
        pass


class Question:
    """A user's function that a callback wants called, and its answer; `instead`: the answer if it raises."""

    def __init__(self, function, instead):
        self.function, self.answer, self.answered, self.bell = function, instead, False, queue.SimpleQueue()

    def take(self, job):
        """Calls the function, in the thread that waits for the job."""
        worker = job.worker
        before, worker.answering = worker.answering, threading.get_ident()
        try:
            if not job.raised:
                self.answer = self.function()
        except BaseException as why:
            job.raised.append(why)
        finally:
            worker.answering = before
            self.answered = True
            self.bell.put(None)


class Job:
    """One call. What the two threads share are its members; bells only wake, so that one too many, or one that is
    lost to an exception, does no harm."""

    def __init__(self, worker, function, cancel):
        self.worker, self.function, self.cancel = worker, function, cancel
        self.result = self.error = self.question = None
        self.ended = self.left = False  # left: its caller waits no longer
        self.raised, self.bell, self.process = [], queue.SimpleQueue(), os.getpid()

    def run(self):
        try:
            self.result = self.function()
        except BaseException as why:
            self.error = why
        self.function = None
        self.ended = True
        self.bell.put(None)

    def refuse(self):
        self.error, self.ended = Closed("the solver is closed"), True
        self.bell.put(None)

    def ask(self, question):
        """The answer to a question, for the worker's thread."""
        self.question = question
        self.bell.put(None)
        while not question.answered and not self.left:
            hear(question.bell)
        self.question = None
        return question.answer

    def attend(self):
        while not self.ended:
            question = self.question
            if question is None or question.answered:
                hear(self.bell)
            else:
                question.take(self)
            if os.getpid() != self.process:
                raise RuntimeError("a child of the process that made this call came back from the call's callback")

    def wait(self):
        """Until the call has ended. It is cancelled when something is raised here; a second exception within the few steps
        that note the first one ends the waiting, but not what the call works with: the job keeps that."""
        cancels = 0
        try:
            self.worker.waiting[threading.get_ident()] = self
            self.worker.jobs.put(self)
            if self.worker.stopped:
                self.refuse()
            while not self.ended:
                try:
                    if cancels < len(self.raised):
                        self.cancel()
                        cancels = len(self.raised)
                    self.attend()
                except BaseException as why:
                    self.raised.append(why)
                    if os.getpid() != self.process:
                        raise
        finally:
            self.left = True
            self.worker.waiting.pop(threading.get_ident(), None)
            if not self.ended and os.getpid() == self.process:
                self.cancel()


class Closed(ValueError):
    """A call on a solver that is closed."""


class Worker:
    """A thread that runs jobs; it ends after stop()."""

    everyone: "weakref.WeakSet[Worker]" = weakref.WeakSet()

    def __init__(self):
        self.jobs, self.job = queue.SimpleQueue(), None
        self.ident = self.answering = None
        self.waiting = {}  # jobs by the threads that wait for them, or did until a second exception came
        self.kept = []     # what foreign threads work with, until it is given back: also if the owner's __del__ is interrupted
        self.stopped = False
        threading.Thread(target=serve, args=(self,), daemon=True).start()
        Worker.everyone.add(self)

    def is_inside(self):
        """Is this thread in a callback of the job that runs?"""
        return self.job is not None and threading.get_ident() in (self.ident, self.answering)

    def is_waited_for(self):
        """Is this thread within wait(), in a handler of a signal?"""
        frame = sys._getframe(1)
        while frame is not None:
            if frame.f_code is Job.wait.__code__ and frame.f_locals["self"].worker is self:
                return True
            frame = frame.f_back
        return False

    def run(self, function, cancel):
        """(what function() returned, what was raised meanwhile)."""
        if threading.get_ident() == self.ident:  # what a job had kept alive goes here
            return function(), []
        if self.is_waited_for():  # a second wait would leave the first one's questions without answers
            raise UsageError([Message("error", "the solver is at work; in a handler of a signal cancel() alone is legal")],
                             header.C2D_ERR_BUSY)
        left = self.waiting.pop(threading.get_ident(), None)
        if left is not None and not left.ended:
            left.left = True
            left.cancel()
        job = Job(self, function, cancel)
        job.wait()
        if job.error is not None:
            raise job.error
        return job.result, job.raised

    def ask(self, function, instead):
        """For callbacks: function() in the thread that waits for the job; `instead` if it raises, or if nobody waits."""
        question = Question(function, instead)
        if threading.get_ident() == self.ident:
            return self.job.ask(question)
        question.take(self.job)  # a callback of a call within a callback
        return question.answer

    def has_raised(self):
        return bool(self.job is not None and (self.job.raised or self.job.left))

    def stop(self):
        self.jobs.put(None)


def serve(worker):
    worker.ident = threading.get_ident()
    job = worker.jobs.get()
    while job is not None:
        worker.job = job
        job.run()
        worker.job = job = None
        job = worker.jobs.get()
    worker.stopped = True  # before those that are left are looked for: who comes later sees it
    try:
        while True:
            job = worker.jobs.get_nowait()
            if job is not None:
                job.refuse()
    except queue.Empty:
        pass


@atexit.register
def end_all():
    """Before the interpreter ends: calls of threads that nobody waits for."""
    for worker in list(Worker.everyone):
        job = worker.job
        if job is None or job.process != os.getpid():
            continue
        job.left = True
        job.cancel()
        while not job.ended:
            time.sleep(0.001)
