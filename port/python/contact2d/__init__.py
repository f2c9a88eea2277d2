"""contact2d: plane elastic contact with Coulomb friction by boundary elements.

    import contact2d
    result = contact2d.solve("fretting_pad.c2s", mu=0.5)      a deck or a sketch, by the program
    result["contact"].where(step=-1)["tn"]                    tables by name
    result.pictures["tractions"]                              shown in a notebook

    solver = contact2d.Solver.of_deck("hertz.dat")            the library in this process: step by step, or a model by
    solver.prepare()                                          calls; every call of contact2d.h is a method
    solver.begin(0.3)
    solver.advance(1.0)

contact2d.header has the names of the C interface, contact2d.lib its functions.
"""

from . import errors, header
from .errors import Cancelled, Error, IncompleteWarning, InputError, Message, SingularError, StoreError, UsageError
from .errors import WorkspaceError
from .library import VERSION as __version__
from .library import lib
from .model import Model
from .pictures import Picture, plot
from .program import Result, check, families, make, mesh, run_program, solve
from .solver import Outcome, Solver, Step
from .tables import Table

__all__ = ["Cancelled", "Error", "IncompleteWarning", "InputError", "Message", "Model", "Outcome", "Picture", "Result",
           "SingularError", "Solver", "Step", "StoreError", "Table", "UsageError", "WorkspaceError", "check", "errors",
           "families", "header", "lib", "make", "mesh", "plot", "run_program", "solve"]
