"""Calls of the interface by name. They are added when the package is loaded (solver.add_methods, Model.__getattr__); what type
checkers read of them, methods.pyi, is made from the headers.
"""


class SolverCalls:
    """Every function of contact2d.h that works on a solver, as a method."""


class ModelCalls:
    """Every function of contact2d.h that makes a model, as a method."""
