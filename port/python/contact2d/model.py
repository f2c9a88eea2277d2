"""A model by calls whose sizes nobody has to count beforehand."""

from __future__ import annotations

import inspect
import sys
from typing import Any, Dict, List

from . import arrays, calls, header
from .errors import offer
from .methods import ModelCalls
from .solver import Solver, limits_of

FUNCTIONS: Dict[str, str] = {name[4:]: name for name, (_, arguments, _) in header.FUNCTIONS.items()
             if arguments and arguments[0][0] == "solver" and name[4:].startswith(("set_", "add_", "tie_", "clear_"))}


class Model(ModelCalls):
    """Keeps calls that make a model, those of section 5 of contact2d.h by their names without c2d_: set_body, set_nodes,
    set_condition, add_zone, ... build() makes a Solver of the sizes that they need and plays them to it.

        model = contact2d.Model(title="Two squares")             members of c2d_problem; function_nodes 1 to 4
        model.set_body(1, element_nodes=2, elements=8, regions=1, youngs_modulus=1000, poisson_ratio=0.3)
        ...
        solver = model.build()

    Faults name the line of the script with the call that they are about.
    """

    def __init__(self, function_nodes: int = 2, **problem: Any) -> None:
        self._kept: List[Any] = []
        self._files: Dict[int, str] = {}
        self._function_nodes = function_nodes
        self._keep("set_problem", (), dict({"analysis": header.C2D_ANALYSIS_FULL}, **problem), 0)

    def __getattr__(self, name: str) -> Any:
        if name not in FUNCTIONS:
            raise AttributeError("a Model has no call %r%s" % (name, offer(name, sorted(FUNCTIONS))))

        def keep(*given, **named):
            caller = sys._getframe(1)
            self._files.setdefault(caller.f_lineno, caller.f_code.co_filename)
            self._keep(name, given, named, caller.f_lineno)

        keep.__name__, keep.__doc__ = name, header.FUNCTIONS[FUNCTIONS[name]][2]
        setattr(keep, "__signature__", calls.signature_of(FUNCTIONS[name]))
        return keep

    def __dir__(self):
        return sorted(set(super().__dir__()) | set(FUNCTIONS))

    def _keep(self, name, given, named, line):
        if name == "set_nodes":
            values = inspect.signature(Solver.set_nodes).bind(None, *given, **named).args[1:]
        else:
            values = calls.Arguments(FUNCTIONS[name], given, named).bind()  # wrong arguments are reported here
        self._kept.append((name, given, named, line, values))

    def build(self, **options: Any) -> Solver:
        """A Solver (options: memory, store, threads, progress) with the whole model in it."""
        solver = Solver(limits_of(self.sizes()), **options)
        solver._origin.lines.update(self._files)
        try:
            for name, given, named, line, _ in self._kept:
                if name not in ("set_options", "set_line"):
                    solver.set_line(line, 1 if line else 0, 1 if line else 0)
                getattr(solver, name)(*given, **named)
            solver.complete()
        except BaseException:
            solver.close()
            raise
        return solver

    def sizes(self) -> Dict[str, Any]:
        """The members of c2d_limits that the calls so far need."""
        count = Sizes(self._function_nodes)
        for name, _, _, _, values in self._kept:
            count.add(name, values)
        return count.sizes()


def elements_of(side):
    """Of a range that may run down, or round the end of its region."""
    return side.elements or abs(side.last_element - side.first_element) + 1


class Sizes:
    """Counts what calls need."""

    def __init__(self, function_nodes):
        self.nodes, self.bodies, self.load_cases = function_nodes, {}, 1
        self.count = dict.fromkeys(("zones", "pairs", "contact_elements", "free_pairs", "point_loads", "coefficients", "paths",
                                    "point_sets", "curves", "platens"), 0)

    def add(self, name, values):
        known = {}
        if name != "set_nodes":
            names = [each for each, *_ in values.expected[1:]]
            known = dict(zip(names, values.values))
        self.load_cases = max(self.load_cases, known.get("load_case", 1), known.get("cases", 1))
        if name == "set_body":
            body = values.kept[0]
            points = body.elements * max(1, body.element_nodes - 1) + body.open_regions
            self.bodies[known["body"]] = (points, body.elements, body.regions)
        elif name == "add_zone":
            self.zone(values.kept[0])
        elif name == "add_platen":
            self.platen(known["elements"] or abs(known["last_element"] - known["first_element"]) + 1)
        elif name == "set_zone_friction":
            self.count["coefficients"] = max(self.count["coefficients"], known["i"])
        else:
            counted = {"add_friction": "coefficients", "add_path": "paths", "add_points": "point_sets", "add_curve": "curves",
                       "add_point_load": "point_loads"}.get(name)
            if counted is not None:
                self.count[counted] += 1

    def zone(self, zone):
        free = zone.kind & header.C2D_ZONE_FREE
        elements = elements_of(zone.side2 if free else zone.side1)
        times = 2 if zone.kind & header.C2D_ZONE_SELF else 1
        self.facing(elements, times * (elements * self.nodes if free else zone.pairs), free, times)

    def platen(self, elements):
        self.count["platens"] += 1
        self.facing(elements, elements * self.nodes, True, 1)

    def facing(self, elements, pairs, free, times):
        self.count["zones"] += 1
        self.count["contact_elements"] += times * elements
        self.count["pairs"] += pairs
        self.count["free_pairs"] += pairs if free else 0

    def sizes(self):
        if self.bodies and not 1 <= min(self.bodies) <= max(self.bodies) <= len(self.bodies):
            raise ValueError("set_body: bodies are numbered from 1 on, not %s" % sorted(self.bodies))
        bodies = [self.bodies[body] for body in sorted(self.bodies)] or [(1, 1, 1)]
        return dict(self.count, bodies=bodies, function_nodes=self.nodes, load_cases=self.load_cases)
