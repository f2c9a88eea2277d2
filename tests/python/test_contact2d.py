"""The Python package. Run by tests/test_python.cpp, with numpy where it is installed, and without it (C2D_WITHOUT_NUMPY=1).

CONTACT2D_LIBRARY and CONTACT2D_PROGRAM name what is tested.
"""

import ast
import csv
import doctest
import inspect
import os
import pathlib
import pickle
import re
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
import threading
import time
import unittest
import warnings
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, os.environ.get("C2D_PYTHON_PACKAGE", str(ROOT / "port" / "python")))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # notebook
if os.environ.get("C2D_WITHOUT_NUMPY") == "1":
    sys.modules["numpy"] = None

import contact2d  # noqa: E402
from contact2d import arrays, header, library  # noqa: E402

HERTZ = ROOT / "examples" / "hertz.dat"
ROLLER = ROOT / "examples" / "roller.c2s"
SLIDING = """title A block that is pushed off
parameter push 0.5
body base E 1000 nu 0.3
  from 0 0
  line bottom to 4 0
  line right to 4 1
  line top to 0 1
  line left close
body block E 1000 nu 0.3
  from 1 1
  line foot to 3 1
  line right to 3 2
  line top to 1 2
  line left close
contact base.top block.foot mu 0.3
case pressed
  fix base.bottom
  traction block.top y -1
case pushed
  traction block.top x push
history pressed 1; pushed 1
tolerance off
"""
ALONG_Y, ALONG_X, LOADED = (1, 0, 0, 1), (0, 1, 1, 0), (0, 0, 1, 1)


def raise_enough(_):
    raise InterruptedError("enough")


def quiet(**changes):
    """The environment of a process of ours that imports the package (its library and program are given by their paths)."""
    return dict(os.environ, PYTHONPATH=str(pathlib.Path(contact2d.__file__).parents[1]), **changes)


def slow_deck():
    """A deck that takes a second or more."""
    return contact2d.make("disc_in_hole", n=480)


def squares():
    """Two squares of eight elements, [0,2] x [0,2] on [0,2] x [-2,0], a pressure of 1 on top: uniform stress."""
    places = [[(0, -2), (1, -2), (2, -2), (2, -1), (2, 0), (1, 0), (0, 0), (0, -1)],
              [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)]]
    model = contact2d.Model(title="Two squares")
    for body, points in enumerate(places, 1):
        model.set_body(body, element_nodes=2, elements=8, regions=1, youngs_modulus=1000, poisson_ratio=0.3)
        model.add_region(body, 1, 8)
        model.set_nodes(body, 1, points)
        for end in (1, 2):
            for element in (7, 8):
                model.set_condition(body, element, end, 1, ALONG_Y, [0, 0, 0, 0])
            for element in (1, 2):
                if body == 1:
                    model.set_condition(1, element, end, 1, codes=ALONG_X, values=[0, 0, 0, 0])
                else:
                    model.set_condition(2, element + 4, end, 1, LOADED, [0, -1, 0, 0])
    model.add_zone(pairs=3, side1=dict(body=1, first_element=5, last_element=6, first_node=5, last_node=7),
                   side2=dict(body=2, first_element=2, last_element=1, first_node=3, last_node=1))
    return model


class Header(unittest.TestCase):
    def test_is_made_from_the_headers(self):
        done = subprocess.run([sys.executable, str(ROOT / "port" / "python" / "generate.py"), "--check"],
                              stdout=subprocess.PIPE)
        self.assertEqual(done.returncode, 0, done.stdout.decode())

    def test_every_function_is_in_the_library_and_every_call_on_a_solver_is_a_method(self):
        self.assertGreater(len(header.FUNCTIONS), 80)
        for name, (_, arguments, doc) in header.FUNCTIONS.items():
            self.assertTrue(callable(getattr(contact2d.lib, name)))
            self.assertIn(name, doc)
            if arguments and arguments[0][0] == "solver":
                self.assertTrue(callable(getattr(contact2d.Solver, name[4:])), name)

    def test_structs_know_their_size(self):
        self.assertEqual(header.c2d_limits().struct_size, header.sizeof(header.c2d_limits))
        self.assertEqual(header.c2d_side().body, 0)

    def test_a_library_of_another_version_is_refused(self):
        text = "import contact2d.header as h; h.C2D_VERSION_PATCH = 99; import contact2d.library"
        # (the package imports its library first: its parts are taken one by one)
        package = pathlib.Path(contact2d.__file__).parent
        text = ("import sys, types; p = types.ModuleType('contact2d'); p.__path__ = [%r]; sys.modules['contact2d'] = p; %s" %
                (str(package), text))
        done = subprocess.run([sys.executable, "-c", text], stderr=subprocess.PIPE,
                              env=quiet(CONTACT2D_LIBRARY=contact2d.lib._name))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(b"ImportError", done.stderr)
        self.assertIn(b"this package is of 0.2.99", done.stderr)


class Solve(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.result = contact2d.solve(HERTZ, points=[(0.5, 3.0, 2), (1.0, -1.0)], stresses=True)

    def test_tables_have_the_programs_digits(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "hertz.csv")
            subprocess.run([library.program(), "run", str(HERTZ), "--csv", name], stderr=subprocess.DEVNULL, check=True)
            with open(name) as file:
                rows = list(csv.DictReader(file))
        table = self.result["contact"]
        self.assertEqual(len(rows), 2 * 28 * 15)
        self.assertEqual(table.columns, list(rows[0]))
        for column in ("mu", "load", "tn", "tt", "slip", "gap", "ut2"):
            self.assertEqual([float(row[column]) for row in rows], list(table[column]))
        self.assertEqual([row["status"] for row in rows], list(table["status"]))
        self.assertEqual([int(row["pair"]) for row in rows], list(table["pair"]))

    def test_every_output_is_there(self):
        self.assertEqual(set(self.result.tables), {"contact", "boundary", "interior", "summary", "bodies", "trace", "stresses",
                                                   "ranges"})
        last = [i for i, point in enumerate(self.result["stresses"]["point"]) if point == 2][-1]
        self.assertEqual(self.result["stresses"]["sxx"][last], self.result["interior"]["sxx"][1])
        self.assertTrue(self.result.complete)
        self.assertEqual(self.result.outcome, "reached")
        self.assertEqual(self.result.summary["mu"], [0.4, 0.3])
        self.assertIn("Balance of forces", self.result.listing)
        self.assertTrue(self.result.report.lstrip().lower().startswith("<!doctype html"))
        self.assertAlmostEqual(self.result.quantity("peak pressure", mu=0.4), 212.8, delta=0.1)
        self.assertEqual(self.result.quantity("peak pressure", part="x"), 0)
        self.assertGreaterEqual(self.result.quantity("peak pressure", part="along"), 0)
        self.assertEqual(self.result.quantity("peak pressure x"), 0)
        with self.assertRaisesRegex(KeyError, "has no 'z'; it has zone, quantity"):
            self.result.quantity("peak pressure", part="z")
        with self.assertRaisesRegex(KeyError, "no quantity 'peak'; there are peak pressure, "):
            self.result.quantity("peak")
        with self.assertRaisesRegex(KeyError, "no quantity 'peak presure', did you mean 'peak pressure'"):
            self.result.quantity("peak presure")
        with self.assertRaisesRegex(KeyError, "no quantity 'peak pressure' with zone 2"):
            self.result.quantity("peak pressure", zone=2)
        with self.assertRaisesRegex(KeyError, "no table 'contakt', did you mean 'contact'"):
            self.result["contakt"]
        with self.assertRaisesRegex(KeyError, "no picture 'traction_1', did you mean 'tractions_1'"):
            self.result.pictures["traction_1"]
        with self.assertRaisesRegex(KeyError, "there are contact"):
            self.result["nodes"]

    def test_interior_points_are_those_asked_for(self):
        table = self.result["interior"]
        self.assertEqual([list(table[name]) for name in ("body", "x", "y")], [[2, 1], [0.5, 1.0], [3.0, -1.0]])
        solver = contact2d.Solver.of_deck(HERTZ)
        solver.prepare()
        solver.run()
        for row, (body, x, y) in enumerate([(2, 0.5, 3.0), (1, 1.0, -1.0)]):
            own = solver.interior([(x, y)], body)
            for name in ("ux", "syy", "von_mises"):
                self.assertAlmostEqual(own[name][0] / table[name][row], 1.0, delta=1e-9)

    def test_points_of_the_deck_itself_come_too(self):
        deck = HERTZ.read_text() + "*POINTS\n POINT      2  0.5  3.0\n"
        try:
            table = contact2d.solve(deck, pictures=False)["interior"]
        except contact2d.InputError as why:
            self.fail(str(why))
        self.assertEqual(list(table["y"]), [3.0])

    def test_rows_are_selected(self):
        table = self.result["contact"].where(mu=0.3, step=-1)
        self.assertEqual(len(table), 15)
        self.assertEqual(set(table["step"]), {28})
        self.assertEqual(table.rows()[14]["pair"], 15)
        self.assertEqual(len(table.take([0, 2])), 2)
        with self.assertRaisesRegex(KeyError, "no column 'nope'; there are .*tn"):
            self.result["contact"]["nope"]
        self.assertNotIn("nope", self.result["contact"])
        with self.assertRaisesRegex(KeyError, "no column 'stp'"):
            table.where(stp=1)
        self.assertEqual([row["pair"] for row in table], list(range(1, 16)))
        self.assertEqual(table[-1]["pair"], 15)
        self.assertEqual(list(table[3:5]["pair"]), [4, 5])
        self.assertEqual(list(table[[2, 0]]["pair"]), [3, 1])
        mask = [pair > 13 for pair in table["pair"]]
        self.assertEqual(list(table[mask]["pair"]), [14, 15])
        if arrays.numpy is not None:
            self.assertEqual(list(table[table["pair"] > 13]["pair"]), [14, 15])
        self.assertEqual(len(table[[False] * 15]), 0)
        self.assertEqual(list(dict(table)), table.columns)
        with self.assertRaisesRegex(IndexError, "no row 15; there are 15"):
            table[15]
        with self.assertRaisesRegex(ValueError, "the mask has 2 entries, the table 15 rows"):
            table[[True, False]]
        with self.assertRaisesRegex(ValueError, "differ in length"):
            contact2d.Table({"x": [1, 2], "y": [1]})
        with self.assertRaisesRegex(KeyError, "no column 'stattus', did you mean 'status'"):
            table["stattus"]
        again = contact2d.Table.of_csv(table.to_csv())
        self.assertEqual(list(again["tn"]), list(table["tn"]))

    def test_columns_are_arrays_if_numpy_is_there(self):
        column = self.result["contact"]["tn"]
        self.assertIsInstance(column, list if arrays.numpy is None else arrays.numpy.ndarray)

    def test_a_table_becomes_a_frame_of_pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("there is no pandas")
        frame = self.result["contact"].to_pandas()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(frame.shape, (840, 18))
        self.assertEqual(frame.query("mu == 0.3 and step == 28")["tn"].max(), max(self.result["contact"].where(mu=0.3)["tn"]))

    def test_pictures_are_svg_and_show_themselves(self):
        self.assertIn("tractions_1", self.result.pictures)
        for picture in self.result.pictures.values():
            self.assertTrue(xml.etree.ElementTree.fromstring(picture._repr_svg_()).tag.endswith("svg"))
        page = self.result._repr_html_()
        self.assertIn("peak pressure", page)
        self.assertIn("normals of the two surfaces", page)
        self.assertGreaterEqual(page.count("data:image/svg+xml;base64,"), 3)
        self.assertIn("<th>tn</th>", self.result["contact"]._repr_html_())

    def test_everything_is_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            self.result.save(os.path.join(folder, "run"))
            found = {path.name for path in pathlib.Path(folder, "run").iterdir()}
            self.assertLessEqual({"contact.csv", "summary.json", "listing.txt", "report.html", "figures"}, found)

    def test_pictures_of_an_earlier_run_go_where_it_is_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            figures = pathlib.Path(folder, "figures")
            self.result.save(folder)
            ring = contact2d.solve(HERTZ.parent / "thick_ring.dat")
            own = {name + ".svg" for name in ring.pictures}
            gone = {path.name for path in figures.iterdir()} - own
            self.assertIn("tractions_1.svg", gone)
            text = (figures / "tractions_1.svg").read_bytes()
            for name in ("mine.svg", "gap_1.svg", "note.txt"):  # of another name, changed, none
                (figures / name).write_bytes(text)
            (figures / "empty.svg").write_bytes(b"")
            (figures / "link.svg").symlink_to("note.txt")
            (figures / "folder.svg").mkdir()
            ring.save(folder)
            kept = {"mine.svg", "gap_1.svg", "note.txt", "empty.svg", "link.svg", "folder.svg"}
            self.assertEqual({path.name for path in figures.iterdir()}, own | kept)
            contact2d.solve(HERTZ, pictures=False).save(folder)
            self.assertEqual({path.name for path in figures.iterdir()}, kept)

    def test_warnings_say_where(self):
        self.assertEqual([message.line for message in self.result.warnings][:1], [99])
        self.assertIn("normals", self.result.warnings[0].text)

    def test_parameters_options_and_text(self):
        text, forces = ROLLER.read_text() + "\ntolerance off\n", []
        for radius in (10, 20):
            result = contact2d.solve(text, pictures=False, options={"threads": 2}, R=radius)
            self.assertEqual(result.pictures, {})
            self.assertIsNone(result.report)
            forces.append(result.quantity("peak pressure"))
        self.assertGreater(forces[0], forces[1] * 1.2)  # the blunter roller presses less

    def test_tolerances_of_parameters(self):
        text = ROLLER.read_text() + "\ntolerance off\n"
        self.assertEqual(len(contact2d.solve(text, pictures=False).tolerances), 0)
        found = contact2d.solve(text, pictures=False, set={"R": "10+-0.1", "mu": "0.1+-10%"}).tolerances
        peak = found.where(quantity="peak pressure", parameter="R")
        self.assertEqual(len(peak), 1)
        self.assertAlmostEqual(peak[0]["derivative"] * 10 / peak[0]["value"], -0.5, delta=0.05)
        self.assertAlmostEqual(peak[0]["share"], -0.1 * peak[0]["derivative"], delta=1e-9)
        self.assertEqual(set(found["parameter"]), {"R", "mu"})
        self.assertGreaterEqual(peak[0]["worst_case"], peak[0]["root_of_squares"])

    def test_a_path_that_ends_early_is_told(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = contact2d.solve(SLIDING, pictures=False)
        self.assertFalse(result.complete)
        self.assertIn(result.outcome, ("gross sliding", "tipping"))
        self.assertEqual([each.category for each in caught], [contact2d.IncompleteWarning])
        self.assertIn(result.why, str(caught[0].message))
        self.assertGreater(len(result["contact"]), 0)

    def test_other_commands(self):
        self.assertIn("hertz", contact2d.families())
        deck = contact2d.make("hertz", n=10)
        self.assertRegex(contact2d.check(deck), "pairs +16")
        self.assertIn("*FREE", contact2d.mesh(ROLLER))
        report = contact2d.check(HERTZ)
        self.assertEqual([message.line for message in report.warnings], [99])
        self.assertEqual(report.notes, [])

    def test_a_sweep_has_a_row_for_each_row_of_values(self):
        text = SLIDING.replace("mu 0.3", "mu {mu}").replace("parameter push 0.5", "parameter push 0.5 mu 0.3 p 1").replace("y -1", "y -p")
        table = contact2d.sweep(text, {"push": [0.1, 0.2, 0.5], "p": 1}, ["peak pressure", "friction force"], mu=0.4)
        self.assertEqual(table.columns, ["row", "push", "p", "peak pressure", "friction force", "outcome"])
        self.assertEqual(list(table["push"]), [0.1, 0.2, 0.5])
        for row in table[:2]:
            self.assertEqual(row["outcome"], "ok")
            self.assertAlmostEqual(abs(row["friction force"]), row["push"] * 2, delta=1e-6)
        self.assertTrue(table[2]["outcome"].startswith("FAIL"), table[2])
        self.assertNotEqual(table[2]["peak pressure"], table[2]["peak pressure"])  # nan
        none = contact2d.sweep(text, {"push": [0.1, 0.2]}, "contact edge 9 x; load")
        self.assertTrue(all(number != number for number in none["contact edge 9 x"]), none)  # of no row
        self.assertEqual(list(none["load"]), [1, 1])
        rows = contact2d.sweep(text, [{"push": 0.1, "mu": 0.4}], "peak pressure", options={"threads": 1})
        self.assertAlmostEqual(rows["peak pressure"][0] / table["peak pressure"][0], 1, delta=1e-9)
        for wrong, kind, said in (([], ValueError, "there are no values"),
                                  ({"push": [1, 2], "mu": [1, 2, 3]}, ValueError, "'push' has 2 values, expected 1 or 3"),
                                  ([{"push": 1}, {"mu": 1}], ValueError, "a row has the parameters mu, expected push"),
                                  ({"pusj": [1]}, contact2d.UsageError, "^no parameter pusj, did you mean 'push'")):
            with self.assertRaisesRegex(kind, said):
                contact2d.sweep(text, wrong, "peak pressure")

    def test_progress_of_a_run_is_shown(self):
        told, interval, contact2d.program.INTERVAL = [], contact2d.program.INTERVAL, 0.01
        try:
            result = contact2d.solve(HERTZ, pictures=False, progress=told.append)
            with self.assertRaisesRegex(InterruptedError, "enough"):
                contact2d.solve(HERTZ, pictures=False, progress=raise_enough)
        finally:
            contact2d.program.INTERVAL = interval
        self.assertTrue(told and all(told), told)
        self.assertEqual([message.line for message in result.warnings], [message.line for message in self.result.warnings])
        command = "import contact2d, sys; contact2d.solve(sys.argv[1], pictures=False, progress=%s)"
        for progress, shown in (("True", "^\r\033\\[K[a-z].*\r\033\\[K$"), ("None", "^$")):  # without a terminal
            done = subprocess.run([sys.executable, "-c", command % progress, str(HERTZ)], stderr=subprocess.PIPE, env=quiet())
            self.assertEqual(done.returncode, 0)
            self.assertRegex(done.stderr.decode(), shown)


class Faults(unittest.TestCase):
    def test_of_a_sketch_have_line_and_column(self):
        text = ROLLER.read_text().replace("contact ", "contact nothing.", 1)
        line = 1 + next(i for i, each in enumerate(text.splitlines()) if each.startswith("contact "))
        for call in (contact2d.solve, contact2d.check, contact2d.mesh):
            with self.assertRaises(contact2d.InputError) as caught:
                call(text)
            self.assertEqual(caught.exception.line, line)
            self.assertGreater(caught.exception.column, 0)
            self.assertIsInstance(caught.exception, ValueError)

    def test_of_a_deck_are_all_told(self):
        lines = HERTZ.read_text().split("\n")
        lines[20], lines[40] = "x" + lines[20], "1.2.3" + lines[40][5:]
        for call in (contact2d.solve, contact2d.Solver.of_deck):
            with self.assertRaises(contact2d.InputError) as caught:
                call("\n".join(lines))
            self.assertEqual(caught.exception.line, 21)
            self.assertGreaterEqual(len(caught.exception.messages), 1)
            self.assertGreater(caught.exception.column, 0)

    def test_name_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "wrong.dat")
            pathlib.Path(name).write_text(HERTZ.read_text().replace("\n", "\nx", 30))
            for call in (contact2d.solve, contact2d.Solver.of_deck):
                with self.assertRaisesRegex(contact2d.InputError, "^" + name + ":[0-9]+:1: "):
                    call(name)
        with contact2d.Solver.of_deck(HERTZ) as solver:
            solver.prepare()
            self.assertEqual(str(solver.warnings[0]).split(": ")[0], "%s:99" % HERTZ)

    def test_of_use(self):
        with self.assertRaisesRegex(contact2d.UsageError, "no parameter of this sketch is called 'zz'"):
            contact2d.solve(ROLLER, zz=1)
        with self.assertRaisesRegex(contact2d.UsageError, "turbo"):
            contact2d.solve(HERTZ, options={"turbo": True})
        with self.assertRaisesRegex(contact2d.InputError, "No such file"):
            contact2d.solve("nowhere.dat")
        with self.assertRaisesRegex(contact2d.WorkspaceError, "bytes"):
            contact2d.solve(HERTZ, options={"memory": "4K"})
        with self.assertRaises(contact2d.UsageError) as caught:
            contact2d.Solver.of_deck(HERTZ).advance(1.0)
        self.assertEqual(caught.exception.status, header.C2D_ERR_STATE)

    def test_a_small_workspace_says_what_would_do(self):
        with self.assertRaises(contact2d.WorkspaceError) as caught:
            contact2d.Solver.of_deck(HERTZ, memory=5000)
        self.assertIsInstance(caught.exception, MemoryError)
        solver = contact2d.Solver.of_deck(HERTZ, memory=caught.exception.bytes_needed)
        solver.prepare()

    def test_a_closed_solver_is_closed(self):
        with contact2d.Solver.of_deck(HERTZ) as solver:
            self.assertEqual(solver.state, "model")
        solver.close()
        with self.assertRaisesRegex(ValueError, "closed"):
            solver.prepare()

    def test_arguments_are_checked_before_the_call(self):
        model = contact2d.Model()
        for call, why in ((lambda: model.set_condition(1, 2), "'local' is missing"),
                          (lambda: model.set_body(1, elements=3, modulus=2), "not expected: modulus"),
                          (lambda: model.set_condition(1, 1, 1, 1, (0, 0), [0] * 4), "has 2 numbers, expected 4"),
                          (lambda: model.add_zone({"pears": 3}), "no member 'pears'"),
                          (lambda: model.set_nodes(1, 1), "xy")):
            with self.assertRaisesRegex(TypeError, why):
                call()
        with self.assertRaisesRegex(AttributeError, "no call 'set_bodies'"):
            model.set_bodies
        solver = contact2d.Solver.of_deck(HERTZ)
        with self.assertRaisesRegex(ValueError, "no field 'tm'"):
            solver.get("tm")
        with self.assertRaisesRegex(TypeError, "rows"):
            solver.interior([1.0, 2.0, 3.0])


    def test_numbers_that_c_cannot_take_are_refused_by_name(self):
        solver = contact2d.Solver.of_deck(HERTZ)
        for call, kind, why in (
                (lambda: contact2d.Solver.of_deck(HERTZ, memory=-5), ValueError, "memory is -5"),
                (lambda: contact2d.Solver.of_deck(HERTZ, memory=2**64), ValueError, "memory is 18446744073709551616"),
                (lambda: contact2d.Solver.of_deck(HERTZ, memory=1.5), TypeError, "memory is 1.5"),
                (lambda: contact2d.Solver.of_deck(HERTZ, threads=-1), ValueError, "threads is -1"),
                (lambda: contact2d.Solver.of_deck(HERTZ, progress=3), TypeError, "progress is 3"),
                (lambda: contact2d.Solver(bodies=[(8, 8)]), TypeError, "body 1 is"),
                (lambda: contact2d.Solver(bodies=[(2**40, 8, 1)]), ValueError, "body 1 is 1099511627776"),
                (lambda: contact2d.Solver(zones=2**32, bodies=[(8, 8, 1)]), ValueError, "c2d_limits.zones is 4294967296"),
                (lambda: contact2d.Solver(header.c2d_limits(bodies=5)), TypeError, "limits is"),
                (lambda: solver.begin(float("nan")), ValueError, "'mu' is nan"),
                (lambda: solver.advance("1.0"), TypeError, "'load' is '1.0'"),
                (lambda: solver.advance([[1.0]]), TypeError, "'load' is"),
                (lambda: solver.get("tn", count=-1), ValueError, "'count' is -1"),
                (lambda: solver.get("tn", count=10**9), ValueError, "'count' is 1000000000, expected at most 15"),
                (lambda: solver.get("tn", first=2**33), ValueError, "'first' is 8589934592"),
                (lambda: solver.get("ok"), ValueError, "no field 'ok'"),
                (lambda: solver.get_zone(2**32 + 1), ValueError, "'i' is 4294967297"),
                (lambda: solver.get_zone(1.5), TypeError, "'i' is 1.5"),
                (lambda: solver.set_units("m\0", "N"), ValueError, "'length' has a character that is zero"),
                (lambda: solver.set_units(3, "N"), TypeError, "'length' is 3"),
                (lambda: solver.add_zone(dict(side1=3)), TypeError, "side1 is 3"),
                (lambda: solver.set_condition(1, 1, 1, 1, [0, 0, 2**40, 0], [0] * 4), ValueError, "'codes' is 1099511627776"),
                (lambda: solver.interior([[1, 2, 3], [4, 5, 6]]), TypeError, "expected rows"),
                (lambda: solver.interior([(1, float("nan"))]), ValueError, "'xy' is nan"),
                (lambda: solver.run(3), TypeError, "'step' is 3"),
                (lambda: contact2d.Model(title="x" * 80), ValueError, "title has 80 bytes"),
                (lambda: contact2d.solve(HERTZ, points=[(1, 2, 3, 4)]), TypeError, "points"),
                (lambda: contact2d.solve(HERTZ, mu=float("nan")), ValueError, "parameter 'mu' is nan")):
            with self.subTest(why):
                with self.assertRaisesRegex(kind, why):
                    call()
        if arrays.numpy is not None:
            with self.assertRaisesRegex(TypeError, r"shape \(2, 3\)"):
                solver.interior(arrays.numpy.zeros((2, 3)))
            with self.assertRaisesRegex(ValueError, "has a nan"):
                solver.interior(arrays.numpy.array([[1.0, float("nan")]]))
        gap = contact2d.Model()
        gap.set_body(3, element_nodes=2, elements=8, regions=1, youngs_modulus=1000, poisson_ratio=0.3)
        with self.assertRaisesRegex(ValueError, "numbered from 1 on"):
            gap.build()

    def test_a_name_that_begins_with_a_dash_is_a_name(self):
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for name in ("-q", "-", "--csv=x"):
                    pathlib.Path(name).write_text(HERTZ.read_text())
                    self.assertTrue(contact2d.solve(name, pictures=False).complete)
                    self.assertIn("pairs", contact2d.check(name))
                with self.assertRaisesRegex(contact2d.UsageError, "expected the name of a parameter"):
                    contact2d.solve("-q", pictures=False, set={"--json": "x"})
            finally:
                os.chdir(before)


class Processes(unittest.TestCase):
    def test_results_tables_and_exceptions_go_from_one_to_another(self):
        result = contact2d.solve(HERTZ, pictures=False)
        again = pickle.loads(pickle.dumps(result))
        self.assertEqual(list(again["contact"]["tn"]), list(result["contact"]["tn"]))
        self.assertEqual((again.summary, again.outcome), (result.summary, result.outcome))
        kinds = [kind for kind in vars(contact2d).values() if isinstance(kind, type) and issubclass(kind, contact2d.Error)]
        self.assertGreater(len(kinds), 6)
        for kind in kinds:
            error = kind([contact2d.Message("error", "text", 3, 4)], 5)
            error.more = 6
            copy = pickle.loads(pickle.dumps(error))
            self.assertEqual((type(copy), str(copy), copy.line, copy.column, copy.status, copy.more),
                             (kind, str(error), 3, 4, 5, 6))
        with self.assertRaisesRegex(TypeError, "belongs to its process"):
            pickle.dumps(contact2d.Solver.of_deck(HERTZ))

    def test_a_solver_is_of_no_use_in_a_child(self):
        with tempfile.TemporaryDirectory() as folder:
            solver = contact2d.Solver.of_deck(HERTZ, store=folder)
            solver.prepare()
            solver.begin(0.3)
            child = os.fork()
            if child == 0:
                status = 1
                try:
                    refused = 0
                    for call in (solver.prepare, lambda: solver.begin(0.1), lambda: solver.state, solver.close, solver.cancel):
                        try:
                            call()
                        except contact2d.UsageError as why:
                            refused += "is a child of it" in str(why)
                    del solver, call
                    status = 0 if refused == 5 else 2
                finally:
                    os._exit(status)
            self.assertEqual(os.waitpid(child, 0)[1], 0)
            with self.assertRaisesRegex(contact2d.StoreError, "in use"):
                contact2d.Solver.of_deck(HERTZ, store=folder)  # the child has given nothing back
            self.assertEqual(solver.advance(1.0), contact2d.Outcome.REACHED)

    def test_what_a_handler_of_a_signal_raises_comes_when_the_call_has_ended(self):
        class Late(Exception):
            pass

        def late(*_):
            raise Late()

        def at_once(*_):
            if not hits:
                hits.append(1)
                os.kill(os.getpid(), signal.SIGALRM)

        hits, before = [], signal.signal(signal.SIGALRM, late)
        try:
            solver = contact2d.Solver.of_deck(HERTZ, progress=at_once)
            with self.assertRaises(Late):
                solver.prepare()
            self.assertEqual(solver.state, "model")
            solver.prepare()
            solver.close()
        finally:
            signal.signal(signal.SIGALRM, before)

    def test_a_handler_may_cancel_and_nothing_else(self):
        told, heard = [], threading.Event()

        def handler(*_):
            for call in (solver.close, lambda: solver.state, lambda: solver.begin(0)):
                try:
                    call()
                except contact2d.UsageError as why:
                    told.append(str(why))
            heard.set()

        def prepare(*values):
            os.kill(os.getpid(), signal.SIGALRM)
            heard.wait()
            return original(*values)

        before = signal.signal(signal.SIGALRM, handler)
        solver, original = contact2d.Solver.of_deck(HERTZ), contact2d.lib.c2d_prepare
        contact2d.lib.c2d_prepare = prepare
        try:
            solver.prepare()
        finally:
            contact2d.lib.c2d_prepare = original
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(["cancel() alone is legal" in each for each in told], [True] * 3)

    def test_close_is_refused_in_a_callback(self):
        solver = contact2d.Solver.of_deck(HERTZ)
        solver.prepare()
        with self.assertRaisesRegex(contact2d.UsageError, "one of its callbacks"):
            solver.run(lambda step: solver.close())
        self.assertTrue(solver.run())


class Stepping(unittest.TestCase):
    def test_the_decks_path_step_by_step(self):
        solver, steps = contact2d.Solver.of_deck(HERTZ), []
        solver.prepare()
        self.assertTrue(solver.run(steps.append))
        self.assertEqual([step.step for step in steps], 2 * list(range(1, 29)))
        table = contact2d.solve(HERTZ, pictures=False)["contact"]
        for step in (steps[9], steps[55]):
            wanted = table.where(mu=step.mu, step=step.step)
            for own, name in (("tn", "tn"), ("tt", "tt"), ("slip_sum", "slip")):
                for a, b in zip(step.table[own], wanted[name]):
                    self.assertAlmostEqual(a, b, delta=1e-9 * 213)
            self.assertAlmostEqual(step.work, sum(step.work_by_case))
        self.assertEqual(steps[0].kind, "recorded")

    def test_a_callback_may_end_the_run_or_raise(self):
        solver = contact2d.Solver.of_deck(HERTZ)
        solver.prepare()
        loads = []
        self.assertFalse(solver.run(lambda step: loads.append(step.load) or step.step == 3))
        self.assertEqual(solver.get_summary().load, loads[-1])
        self.assertEqual(len(loads), 3)

        def fail(step):
            self.assertIs(threading.current_thread(), threading.main_thread())
            raise LookupError("step %d" % step.step)

        with self.assertRaisesRegex(LookupError, "step 1"):
            solver.run(fail)
        self.assertEqual(solver.state, "running")
        self.assertTrue(solver.run())

    def test_a_callback_may_ask_for_the_state_of_a_zone(self):
        solver, touching = contact2d.Solver.of_deck(HERTZ), []
        solver.prepare()
        solver.run(lambda step: touching.append(solver.get_zone_state(1).open))
        self.assertEqual(len(touching), 56)
        self.assertGreater(touching[0], touching[27])

    def test_one_big_step_equals_many_small_ones(self):
        solver = contact2d.Solver.of_deck(HERTZ)
        solver.prepare()
        solver.begin(0.3)
        for i in range(1, 21):
            outcome = solver.advance(i / 20)
        self.assertEqual(outcome, contact2d.Outcome.REACHED)
        self.assertEqual(str(outcome), "reached")
        small = list(solver.get("tn"))
        solver.begin([0.3])
        solver.advance([1.0])
        for a, b in zip(small, solver.get("tn")):
            self.assertAlmostEqual(a, b, delta=1e-7)
        step = solver.next_event([-1.0])
        self.assertTrue(0 < step < 1)

    def test_a_cycle_of_loads_until_it_is_steady(self):
        solver = contact2d.Solver.of_deck(HERTZ, cycle_states=20)
        solver.prepare()
        solver.begin(0.3)
        solver.advance(1.0)
        seen = []
        state = solver.cycle([[0.5], [1.0]], each=lambda now: seen.append(now.cycles))
        self.assertIn(state.result, (header.C2D_CYCLE_SHAKES_DOWN, header.C2D_CYCLE_SLIPS))
        self.assertEqual(seen, list(range(1, state.cycles + 1)))
        self.assertLessEqual(state.change, 1e-10)
        before, tt = solver.get_summary().dissipated, list(solver.get("tt"))
        solver.advance(0.5)
        solver.advance(1.0)
        self.assertAlmostEqual(solver.get_summary().dissipated - before, state.dissipated, delta=1e-9 * (1e-9 + before))
        for a, b in zip(tt, solver.get("tt")):
            self.assertAlmostEqual(a, b, delta=1e-8)
        self.assertEqual(max(solver.get_cycle("range")), state.slip_range)
        self.assertEqual(sum(solver.get_cycle("stuck")), state.stuck)
        self.assertEqual(solver.get_cycle_zone(1).slip_range, state.slip_range)
        self.assertEqual(solver.cycle([[0.5], [1.0]], mode="plain", each=lambda now: True).cycles, 1)
        self.assertEqual(solver.cycle([[0.5], [1.0]], limit=1, tolerance=1.0).cycles, 1)
        with self.assertRaisesRegex(ValueError, "'mode' is 'exakt', expected one of exact, plain, fast"):
            solver.cycle([[0.5], [1.0]], mode="exakt")
        for load in (1.0, [[1.0, 2.0], [1.0, 2.0]]):
            with self.assertRaisesRegex(TypeError, "cycle: 'load'"):
                solver.cycle(load)
        with self.assertRaisesRegex(TypeError, "'each' is 3"):
            solver.cycle([[0.5], [1.0]], each=3)
        with self.assertRaisesRegex(ValueError, "'field' is 'slip'"):
            solver.get_cycle("slip")
        with self.assertRaisesRegex(contact2d.Error, "does not close"):
            solver.cycle([[1.0], [0.5]])

        def enough(now):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            solver.cycle([[0.5], [1.0]], each=enough)

    def test_progress_is_told_and_may_raise(self):
        seen = []
        solver = contact2d.Solver.of_deck(HERTZ, progress=lambda *now: seen.append(now))
        solver.prepare()
        self.assertIn(header.C2D_PHASE_ASSEMBLE, {now[0] for now in seen})

        def enough(*now):
            raise LookupError("enough")

        solver = contact2d.Solver.of_deck(HERTZ, progress=enough)
        with self.assertRaisesRegex(LookupError, "enough"):
            solver.prepare()
        self.assertEqual(solver.state, "model")

    def test_state_in_files_is_taken_up_again(self):
        with tempfile.TemporaryDirectory() as folder:
            with contact2d.Solver.of_deck(HERTZ, store=folder) as solver:
                with self.assertRaisesRegex(contact2d.StoreError, "in use"):
                    contact2d.Solver.of_deck(HERTZ, store=folder)
                solver.prepare()
                solver.begin(0.3)
                solver.advance(0.5)
                solver.save()
                solver.advance(1.0)
                wanted = list(solver.get("tn"))
            with contact2d.Solver.of_deck(HERTZ, store=folder) as solver:
                solver.restore()
                self.assertEqual(solver.get_summary().load, 0.5)
                solver.advance(1.0)
                self.assertEqual(list(solver.get("tn")), wanted)


class Calls(unittest.TestCase):
    def test_two_squares_have_uniform_stress(self):
        solver = squares().build()
        solver.prepare()
        solver.begin(0.3)
        self.assertEqual(solver.advance(1.0), contact2d.Outcome.REACHED)
        for pressure in solver.get("tn"):
            self.assertAlmostEqual(pressure, 1.0, delta=1e-12)
        inside = solver.interior([(1, 1), (0.5, -1.5)])
        for syy in inside["syy"]:
            self.assertAlmostEqual(syy, -1.0, delta=1e-9)
        solver.advance(0.5)
        self.assertAlmostEqual(solver.boundary(2)["syy"][0], -0.5, delta=1e-9)
        self.assertEqual(len(solver.contact()), 3)
        self.assertAlmostEqual(max(abs(gap) for gap in solver.indicators(1)["gap"]), 0.0, delta=1e-9)

    def test_what_was_given_comes_back(self):
        model = squares()
        model.set_name(header.C2D_NAME_BODY, 2, "upper")
        model.set_units("mm", "N")
        model.add_friction(0.25)
        model.add_path(4, [1.0])
        model.add_points(kind=header.C2D_POINTS_LINE, body=2, count=(3, 1), **{"from": (0.5, 0.5), "to": (1.5, 1.5)})
        solver = model.build()
        self.assertEqual(solver.get_name(header.C2D_NAME_BODY, 2), "upper")
        self.assertEqual(solver.get_friction(0, 1), 0.25)
        self.assertEqual(solver.get_path(1), (4, [1.0]))
        self.assertEqual(solver.get_zone(1).side2.first_element, 2)
        self.assertEqual(solver.get_region(1, 1), (1, 8))
        self.assertEqual(solver.get_condition(1, 7, 1, 1)[0], list(ALONG_Y))
        self.assertEqual(solver.get_summary().title, "Two squares")
        self.assertEqual(solver.get_summary().unit_force, "N")
        points = solver.get_points(1)
        from contact2d.solver import expand_points
        self.assertEqual([list(row) for row in expand_points(vars(points))], [[0.5, 0.5], [1.0, 1.0], [1.5, 1.5]])

    def test_faults_name_the_line_of_the_script(self):
        model = squares()
        model.add_region(1, 9, 12)
        line = sys._getframe().f_lineno - 1
        with self.assertRaises(contact2d.InputError) as caught:
            model.build()
        self.assertEqual(caught.exception.line, line)

    def test_sizes_are_counted(self):
        model = squares()
        model.add_zone(kind=header.C2D_ZONE_FREE, side1=dict(body=1, first_element=3, last_element=4),
                       side2=dict(body=2, first_element=8, last_element=7))
        model.add_path(2, [0.5, 1.0, 0.0])
        model.add_point_load(2, 1, 1.0, 1.0, 0.0, -1.0)
        model.set_zone_friction(1, 3, 0.2)
        model.add_platen(2, 5, 6, 0, [1, 1, 1], [1.0, 2.0])
        sizes = model.sizes()
        self.assertEqual(sizes["bodies"], [(8, 8, 1), (8, 8, 1)])
        self.assertEqual((sizes["zones"], sizes["load_cases"], sizes["paths"]), (3, 3, 1))
        self.assertEqual((sizes["point_loads"], sizes["coefficients"], sizes["platens"]), (1, 3, 1))
        self.assertEqual((sizes["pairs"], sizes["free_pairs"], sizes["contact_elements"]), (3 + 4 + 4, 8, 2 + 2 + 2))

    def test_arrays_of_numpy_go_in(self):
        if arrays.numpy is None:
            self.skipTest("there is no numpy")
        solver = squares().build()
        solver.prepare()
        solver.begin(arrays.numpy.array([0.3]))
        solver.advance(arrays.numpy.float64(1.0))
        grid = arrays.numpy.array([[0.5, 0.5, 9.0], [1.5, 1.0, 9.0]])[:, :2]  # not contiguous
        self.assertTrue(arrays.numpy.allclose(solver.interior(grid)["syy"], -1.0))

    def test_a_platen_by_calls(self):
        model = squares()
        model._kept = [call for call in model._kept if not (call[0] == "set_condition" and call[1][:2] in ((2, 5), (2, 6)))]
        model.add_platen(2, 5, 6, 0, [0, 0, 0], [1.0, 2.0])
        model.set_rigid(3, 1, [0.0, -0.001, 0.0], [1.0, 2.0])
        solver = model.build()
        solver.prepare()
        solver.begin(0.0)
        solver.advance(1.0)
        self.assertAlmostEqual(solver.get_body_state(3).motion[1], -0.001, delta=1e-15)
        self.assertGreater(min(solver.get("tn", count=3)), 0)


class Interrupts(unittest.TestCase):
    SCRIPT = """
import contact2d, os, signal, sys, threading, time
deck = sys.stdin.read()
hits = []

def interrupt(*now):
    if not hits:
        hits.append(now)
        os.kill(os.getpid(), signal.SIGINT)
        time.sleep(0.2)  # for the main thread to hear it

solver = contact2d.Solver.of_deck(deck, progress=interrupt)
try:
    solver.prepare()
    print("not interrupted")
except KeyboardInterrupt:
    print("interrupted", solver.state)
assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
print("then", solver.state)
solver.prepare()
solver.begin(0.3)
print(solver.advance(0.1), solver.state)
"""
    RUN = """
import contact2d, os, signal, sys, threading
deck = sys.stdin.read()
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    contact2d.solve(deck)
    print("not interrupted")
except KeyboardInterrupt:
    print("interrupted")
try:
    os.waitpid(-1, os.WNOHANG)
    print("the program still runs")
except ChildProcessError:
    print("nothing is left")
"""

    def run_script(self, script, deck):
        done = subprocess.run([sys.executable, "-c", script], input=deck.encode(), stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, env=quiet(), timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr.decode())
        return done.stdout.decode().split("\n")

    def test_of_the_library(self):
        told = self.run_script(self.SCRIPT, HERTZ.read_text())
        self.assertEqual(told[:3], ["interrupted model", "then model", "reached running"])

    def test_of_the_program(self):
        told = self.run_script(self.RUN, slow_deck())
        self.assertEqual(told[:2], ["interrupted", "nothing is left"])

    def test_one_that_comes_late_does_no_harm(self):
        solver = contact2d.Solver.of_deck(HERTZ)
        solver.prepare()
        solver.begin(0.3)
        original = contact2d.lib.c2d_advance

        def late(*values):
            status = original(*values)
            os.kill(os.getpid(), signal.SIGINT)
            return status

        contact2d.lib.c2d_advance = late
        try:
            with self.assertRaises(KeyboardInterrupt):
                solver.advance(0.5)
        finally:
            contact2d.lib.c2d_advance = original
        self.assertEqual(solver.advance(0.75), contact2d.Outcome.REACHED)
        self.assertEqual(solver.get_summary().load, 0.75)

    def test_cancel_from_another_thread(self):
        solver = contact2d.Solver.of_deck(HERTZ)
        solver.prepare()
        solver.begin(0.3)
        solver.cancel()
        with self.assertRaises(contact2d.Cancelled):
            solver.advance(1.0)
        self.assertEqual(solver.advance(1.0), contact2d.Outcome.REACHED)


class Threads(unittest.TestCase):
    def test_solvers_do_not_meet(self):
        wanted, found = self.pressures(0.3), {}

        def work(i):
            found[i] = self.pressures(0.3)

        workers = [threading.Thread(target=work, args=(i,)) for i in range(4)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        self.assertEqual(list(found.values()), [wanted] * 4)

    def pressures(self, mu, **options):
        with contact2d.Solver.of_deck(HERTZ, **options) as solver:
            solver.prepare()
            solver.begin(mu)
            solver.advance(1.0)
            return list(solver.get("tn"))

    def test_threads_of_the_library_change_no_bit(self):
        self.assertEqual(self.pressures(0.3, threads=2), self.pressures(0.3))
        with self.assertRaisesRegex(contact2d.WorkspaceError, "threads"):
            contact2d.Solver.of_deck(HERTZ, threads=1000)

    def test_the_lock_is_released(self):
        solver, count, done = contact2d.Solver.of_deck(slow_deck()), [0], threading.Event()
        worker = threading.Thread(target=lambda: (solver.prepare(), done.set()))
        worker.start()
        while not done.is_set():
            count[0] += 1
            time.sleep(0.001)
        worker.join()
        self.assertGreater(count[0], 3)  # with the lock held it were one


class Plots(unittest.TestCase):
    def test_curves_lie_where_they_should(self):
        picture = contact2d.plot(([0, 1, 2], [0, 10, 5], "a < b"), ([0, 2], [float("nan"), 5]), title="T & U", x="mm")
        root = xml.etree.ElementTree.fromstring(picture.svg)
        lines = [each for each in root.iter() if each.tag.endswith("polyline")]
        places = [[float(n) for n in point.split(",")] for point in lines[0].get("points").split()]
        self.assertAlmostEqual(places[1][0] - places[0][0], places[2][0] - places[1][0], delta=0.02)
        self.assertLess(places[1][1], places[2][1])  # up is less in SVG
        self.assertAlmostEqual((places[0][1] - places[2][1]) * 2, places[0][1] - places[1][1], delta=0.05)
        self.assertIn("a &lt; b", picture.svg)
        self.assertEqual(picture.name, "T & U")

    def test_what_cannot_be_drawn_is_refused(self):
        with self.assertRaisesRegex(ValueError, "at least one curve"):
            contact2d.plot()
        with self.assertRaisesRegex(ValueError, "3 x values and 2 y values"):
            contact2d.plot(([1, 2, 3], [1, 2]))
        constant = contact2d.plot(([1, 2], [5, 5]))
        self.assertIn("polyline", constant.svg)

    def test_ticks_are_round(self):
        from contact2d.pictures import ticks
        self.assertEqual([round(tick, 12) for tick in ticks(0, 1)], [0, 0.2, 0.4, 0.6, 0.8, 1.0])
        self.assertEqual(ticks(-3e5, 7e5), [-2e5, 0, 2e5, 4e5, 6e5])
        for low, high in ((0.1, 0.10001), (-5, 5), (1e-9, 3e-9)):
            found = ticks(low, high)
            self.assertTrue(2 <= len(found) <= 7, (low, high, found))
            self.assertTrue(all(low - 1e-6 * (high - low) <= tick <= high + 1e-6 * (high - low) for tick in found))


    def test_curves_go_on_axes_of_matplotlib(self):
        class Axes:
            def __init__(self):
                self.calls = []

            def __getattr__(self, name):
                return lambda *given, **named: self.calls.append((name, given, named))

        axes = Axes()  # (matplotlib itself, where it is installed, below)
        self.assertIs(contact2d.plot(([0, 1], [2, 3], "a"), ([0, 1], [4, 5]), title="T", x="mm", ax=axes), axes)
        self.assertEqual(axes.calls, [("plot", ([0, 1], [2, 3]), {"label": "a"}), ("plot", ([0, 1], [4, 5]), {"label": None}),
                                      ("legend", (), {}), ("set_title", ("T",), {}), ("set_xlabel", ("mm",), {})])
        table, axes = contact2d.Table({"x": [0.0, 1.0], "tn": [1.0, 2.0]}), Axes()
        table.plot("x", "tn", ax=axes)
        self.assertEqual([name for name, *_ in axes.calls], ["plot", "legend", "set_xlabel"])
        self.assertIn("tn", table.plot("x", "tn").svg)
        try:
            import matplotlib
        except ImportError:
            with self.assertRaisesRegex(ImportError, "ax=True needs matplotlib"):
                table.plot("x", "tn", ax=True)
            return
        matplotlib.use("Agg")
        self.assertEqual(len(table.plot("x", "tn", ax=True).get_lines()), 1)


class Typing(unittest.TestCase):
    PACKAGE = pathlib.Path(contact2d.__file__).parent

    def test_what_users_call_has_annotations_and_a_stub_or_text(self):
        self.assertTrue((self.PACKAGE / "py.typed").exists())
        kinds = [contact2d.Solver, contact2d.Model, contact2d.Table, contact2d.Result, contact2d.Picture, contact2d.Message]
        written = [value for kind in kinds for name, value in vars(kind).items()
                   if inspect.isfunction(value) and not name.startswith("_") and value.__module__.startswith("contact2d")
                   and "members" not in value.__qualname__]
        functions = [getattr(contact2d, name) for name in contact2d.__all__ if inspect.isfunction(getattr(contact2d, name))]
        self.assertGreater(len(functions), 6)
        added = ast.parse((self.PACKAGE / "methods.pyi").read_text())
        stubs = {node.name for kind in added.body if isinstance(kind, ast.ClassDef) for node in kind.body}
        for function in written + functions:
            if function.__name__ in stubs and function.__module__ == "contact2d.solver" and not function.__annotations__:
                continue  # added from the headers
            self.assertIn("return", function.__annotations__, function)

    def test_every_call_has_its_stub_and_its_signature(self):
        added = ast.parse((self.PACKAGE / "methods.pyi").read_text())
        solver, model = [node for node in added.body if isinstance(node, ast.ClassDef)]
        for kind, stubs in ((contact2d.Solver, solver), (contact2d.Model(), model)):
            for stub in stubs.body:
                declared = [each.arg for each in stub.args.args]
                method = getattr(kind, stub.name)
                if stub.name != "set_nodes":
                    names = [each.name for each in inspect.signature(method).parameters.values()
                             if each.kind is each.POSITIONAL_OR_KEYWORD]
                    self.assertEqual(names, declared, stub.name)
        with self.assertRaisesRegex(AttributeError, "no call 'set_bdy', did you mean 'set_body'"):
            contact2d.Model().set_bdy


class Wheels(unittest.TestCase):
    """The tag of a wheel, by what its files ask of the system."""

    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(ROOT / "port" / "python"))
        import wheel_tag
        cls.tags = wheel_tag

    def test_libraries_and_versions_are_those_that_readelf_finds(self):
        if shutil.which("readelf") is None:
            self.skipTest("there is no readelf")
        for path in (library.program(), contact2d.lib._name, sys.executable):
            found = self.tags.Elf(pathlib.Path(path).read_bytes())
            dynamic, versions = (subprocess.run(["readelf", option, "-W", path], stdout=subprocess.PIPE, check=True).stdout.decode()
                                 for option in ("-d", "-V"))
            self.assertEqual(found.needed, set(re.findall(r"NEEDED.*\[(.*)\]", dynamic)))
            self.assertEqual({version for _, version in found.versions},
                             set(re.findall(r"Name: (\S+)\s+Flags:", versions.split("version needs section")[-1])))

    def test_what_asks_for_more_than_glibc_is_for_this_machine(self):
        own = sysconfig.get_platform().replace("-", "_").replace(".", "_")
        if not own.startswith("linux_"):
            self.skipTest("no Linux")
        many = re.compile("^manylinux_2_[0-9]+_" + own[6:] + "$")
        paths = [library.program(), contact2d.lib._name]
        tag = self.tags.platform_tag(paths)
        self.assertTrue(tag == own or many.match(tag), tag)
        self.assertEqual(self.tags.platform_tag(paths, "-O2 -march=native"), own)
        self.assertEqual(self.tags.platform_tag(paths + [__file__]), own)  # no file in ELF
        compiler = shutil.which("cc")
        if compiler is None or not many.match(tag):
            return
        with tempfile.TemporaryDirectory() as folder:
            made = {name: os.path.join(folder, name) for name in ("other.so", "plain.so", "more.so")}
            for name, words in (("other.so", []), ("plain.so", ["-lm"]), ("more.so", ["-Wl,--no-as-needed", made["other.so"]])):
                subprocess.run([compiler, "-shared", "-fPIC", "-x", "c", "-", "-x", "none", "-o", made[name]] + words, check=True,
                               input=b"double sqrt(double); double half(double x) { return 0.5 * sqrt(x); }")
            self.assertTrue(many.match(self.tags.platform_tag([made["plain.so"]])))
            self.assertEqual(self.tags.platform_tag([made["plain.so"], made["more.so"]]), own)


class Example(unittest.TestCase):
    def test_docstrings_run(self):
        before = os.getcwd()
        os.chdir(str(ROOT / "examples"))
        try:
            for module in (contact2d, contact2d.errors, contact2d.pictures, contact2d.program, contact2d.tables):
                found = doctest.testmod(module)
                self.assertGreater(found.attempted, 0, module)
                self.assertEqual(found.failed, 0, module)
        finally:
            os.chdir(before)

    def test_the_notebook_shows_what_it_did(self):
        command = [sys.executable, str(ROOT / "tests" / "python" / "notebook.py"), str(ROOT / "examples" / "hertz.ipynb")]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=quiet())
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        import notebook
        kept = "peak pressure 2.75 at x -1e-3"
        for text, same in ((kept, True), (kept.replace("2.75", "2.76"), True), (kept.replace("2.75", "2.85"), False),
                           (kept.replace("x", "y"), False), (kept + " 1", False)):
            self.assertEqual(notebook.is_same(kept, text), same, text)
        wrong = {"cells": [{"cell_type": "code", "source": ["print(2 + 2)\n", "[1]"], "outputs": [
            {"output_type": "stream", "text": ["5\n"]}, {"output_type": "execute_result", "data": {"text/plain": ["[1]"]}}]}]}
        self.assertEqual(list(notebook.differences(wrong, notebook.run(wrong))), ["cell 1, stream: '4\\n', kept is '5\\n'"])

    def test_programs_of_the_page_run(self):
        page = (ROOT / "port" / "python" / "README.md").read_text()
        programs = [block.split("```")[0] for block in page.split("```python\n")[1:]]
        self.assertEqual(len(programs), 4)
        told = []
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(str(ROOT / "examples"), os.path.join(folder, "examples"))
            for program in programs:
                done = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                      env=quiet(), cwd=folder)
                self.assertEqual(done.returncode, 0, done.stderr.decode())
                told.append(done.stdout.decode())
            self.assertTrue(os.path.exists(os.path.join(folder, "run", "contact.csv")))
        self.assertIn("reached", told[0])
        self.assertEqual([line.split()[::2] for line in told[1].splitlines()], [["10.0", "ok"], ["20.0", "ok"], ["40.0", "ok"]])
        self.assertIn("0.4 reached", told[2])
        self.assertRegex(told[3], r"^\[[-.\d]+\]\n$")
        self.assertAlmostEqual(float(told[3].strip("[]\n")), -1, delta=1e-12)  # an exact state, but for round-off

    def test_fretting_loops_close_and_enclose_what_friction_takes(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, str(ROOT / "examples" / "fretting_loop.py"), folder],
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=quiet())
            self.assertEqual(done.returncode, 0, done.stderr.decode())
            found = {path.name for path in pathlib.Path(folder).iterdir()}
        rows = [line.replace(",", " ").split() for line in done.stdout.decode().splitlines() if line.startswith("mu ")]
        self.assertEqual([row[1] for row in rows], ["0.4:", "0.5:", "0.6:", "0.8:", "1.0:"])
        losses = [float(row[5]) for row in rows]
        self.assertEqual(losses, sorted(losses, reverse=True))  # more friction, less slip
        for loss, row in zip(losses, rows):
            self.assertAlmostEqual(float(row[10]) / loss, 1.0, delta=0.01)
            self.assertLess(float(row[-1]), 1e-12)
        self.assertLessEqual({"loops.svg", "losses.svg", "deformed.svg"}, found)


if __name__ == "__main__":
    unittest.main()
