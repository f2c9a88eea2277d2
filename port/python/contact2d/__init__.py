"""contact2d: plane elastic contact with Coulomb friction by boundary elements.

A deck or a sketch, solved by the program, with tables, pictures and messages by name:

>>> import contact2d
>>> result = contact2d.solve("roller.c2s", mu=0.2)            # in examples
>>> last = result["contact"].where(step=-1)
>>> "%.3g" % max(last["tn"]), result.outcome
('76.4', 'reached')
>>> result.pictures["tractions"]                              # shown in a notebook
<Picture tractions>

The library in this process, step by step, or a model by calls (contact2d.Model); every call of contact2d.h is a method:

>>> solver = contact2d.Solver.of_deck("hertz.dat")
>>> solver.prepare()
>>> solver.begin(0.3)
>>> print(solver.advance(1.0))
reached
>>> solver.close()

contact2d.header has the names of the C interface, contact2d.lib its functions.
"""

from . import errors, header
from .errors import Cancelled, Error, IncompleteWarning, InputError, Message, SingularError, StoreError, UsageError
from .errors import WorkspaceError
from .library import VERSION as __version__
from .library import lib
from .model import Model
from .pictures import Picture, plot
from .program import Report, Result, check, families, make, mesh, run_program, solve, sweep
from .solver import Outcome, Solver, Step
from .tables import Table

__all__ = ["Cancelled", "Error", "IncompleteWarning", "InputError", "Message", "Model", "Outcome", "Picture", "Report", "Result",
           "SingularError", "Solver", "Step", "StoreError", "Table", "UsageError", "WorkspaceError", "check", "errors",
           "families", "header", "lib", "make", "mesh", "plot", "run_program", "solve", "sweep"]
