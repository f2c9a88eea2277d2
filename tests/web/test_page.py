"""The page build/web/contact2d.html in a real browser: headless Chromium, driven through chromedriver by the standard library.

    python3 tests/web/test_page.py PAGE PROGRAM SCREENSHOTS [-k NAME] ...

PROGRAM is the program of this machine, whose digits the page must have; screenshots go to a folder. Run by tests/test_web.cpp.
"""

import base64
import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, PROGRAM, SCREENSHOTS = (pathlib.Path(each).resolve() for each in sys.argv[1:4])
FLAGS = ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage", "--window-size=1280,1000"]
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"
PATIENCE = 120


class Browser:
    """A session of W3C WebDriver."""

    def __init__(self, folder):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        self.driver = subprocess.Popen(["chromedriver", "--port=%d" % self.port], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        self.session = None
        options = {"binary": shutil.which("chromium"), "args": FLAGS + ["--user-data-dir=" + os.path.join(folder, "user")]}
        wanted = {"capabilities": {"alwaysMatch": {"goog:chromeOptions": options, "timeouts": {"script": PATIENCE * 1000}}}}
        end = time.time() + PATIENCE
        while self.session is None:
            try:
                self.session = self.call("POST", "/session", wanted)["sessionId"]
            except (urllib.error.URLError, ConnectionError):
                if time.time() > end:
                    raise
                time.sleep(0.2)

    def call(self, method, path, data=None):
        place = "http://127.0.0.1:%d%s" % (self.port, path if self.session is None else "/session/%s%s" % (self.session, path))
        body = None if method == "GET" else json.dumps(data or {}).encode()
        request = urllib.request.Request(place, body, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=2 * PATIENCE) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as why:
            raise AssertionError(json.load(why)["value"]["message"])

    def close(self):
        try:
            self.call("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()

    def open(self, page):
        self.call("POST", "/url", {"url": page})

    def run(self, script, *values):
        return self.call("POST", "/execute/sync", {"script": script, "args": list(values)})

    def ask(self, script, *values):
        """Of a promise."""
        text = "const done = arguments[arguments.length - 1]; (async () => { %s })().then(done, (why) => done('failed: ' + why));"
        return self.call("POST", "/execute/async", {"script": text % script, "args": list(values)})

    def find(self, selector):
        return self.call("POST", "/element", {"using": "css selector", "value": selector})[ELEMENT]

    def click(self, selector):
        self.call("POST", "/element/%s/click" % self.find(selector))

    def keys(self, selector, text):
        self.call("POST", "/element/%s/value" % self.find(selector), {"text": text})

    def act(self, *actions):
        self.call("POST", "/actions", {"actions": actions})

    def devtools(self, command, **values):
        return self.call("POST", "/goog/cdp/execute", {"cmd": command, "params": values})

    def screenshot(self, name):
        height = self.run("return document.documentElement.scrollHeight")
        shot = self.devtools("Page.captureScreenshot", captureBeyondViewport=True,
                             clip=dict(x=0, y=0, width=self.run("return innerWidth"), height=min(height, 6000), scale=1))
        (SCREENSHOTS / name).write_bytes(base64.b64decode(shot["data"]))

    def wait(self, script, *values):
        end = time.time() + PATIENCE
        while time.time() < end:
            found = self.run(script, *values)
            if found:
                return found
            time.sleep(0.05)
        raise AssertionError("waited in vain for: %s; state: %s" % (script, self.run("return $('state').textContent")))


IDLE = "return document.body.dataset.ready === 'yes' && !page.busy && page.wanted === null"


class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        cls.folder = tempfile.TemporaryDirectory()
        cls.browser = Browser(cls.folder.name)
        cls.browser.devtools("Network.enable")
        cls.browser.devtools("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def setUp(self):
        self.size(1280, 1000)
        self.browser.devtools("Storage.clearDataForOrigin", origin="file://", storageTypes="all")  # as on a first visit
        self.browser.open(PAGE.as_uri())
        self.browser.wait(IDLE)

    def size(self, width, height):
        self.browser.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)

    def text(self, name):
        return self.browser.run("return $(arguments[0]).textContent", name)

    def choose(self, value):
        self.browser.run("$('example').value = arguments[0]; $('example').onchange()", value)
        self.browser.wait(IDLE)

    def test_it_is_small(self):
        self.assertLessEqual(PAGE.stat().st_size, 2 << 20)

    def test_it_is_one_file_that_fetches_nothing(self):
        self.assertRegex(self.text("state"), "^Solved in .*largest pressure")
        fetched = self.browser.run("return performance.getEntriesByType('resource').map((each) => each.name)")
        self.assertEqual([each for each in fetched if not each.startswith(("blob:", "data:"))], [])
        self.assertIn("contact2d ", self.text("version"))

    def both(self, text, name, words):
        """The files that the program and the page make of a deck or sketch."""
        outputs = ["--csv", "contact.csv", "--boundary", "boundary.csv", "--json", "summary.json"]
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, name).write_text(text)
            subprocess.run([PROGRAM, "run", name] + words + outputs, cwd=folder, check=True, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
            ours = {each: pathlib.Path(folder, each).read_text() for each in outputs[1::2]}
        found = self.browser.ask("return await command(['run', ...arguments[2]], {[arguments[1]]: arguments[0]})", text, name,
                                 [name] + words + outputs)
        self.assertEqual(found["status"], 0, found["err"])
        return ours, found["files"]

    def test_it_has_the_digits_of_the_program(self):
        roller = (ROOT / "examples" / "roller.c2s").read_text() + "\ntolerance off\n"
        for text, name, words in (((ROOT / "examples" / "hertz.dat").read_text(), "hertz.dat", []), (roller, "roller.c2s", []),
                                  ((ROOT / "examples" / "three_bodies.dat").read_text(), "three.dat", []),
                                  (roller, "roller.c2s", ["R=12"])):
            ours, theirs = self.both(text, name, words)
            for each in ("contact.csv", "boundary.csv"):
                self.compare(ours[each], theirs[each], "%s %s" % (name, each))

    def test_a_mesh_is_sought_as_well(self):
        """Last digits may choose another mesh; numbers on it are as accurate as the sketch wants them, 1 %."""
        ours, theirs = self.both((ROOT / "examples" / "roller.c2s").read_text(), "roller.c2s", [])
        peaks = []
        for files in (ours, theirs):
            summary = json.loads(files["summary.json"])
            self.assertTrue(all(each["met"] for each in summary["accuracy"]["stated"] if "met" in each))
            peaks.append(next(each["value"] for each in summary["runs"][0]["quantities"] if each["quantity"] == "peak pressure"))
        self.assertAlmostEqual(peaks[0] / peaks[1], 1, delta=0.01)

    def compare(self, ours, theirs, what):
        """Fields alike to 1e-9 of the largest of their column's kind (processors with and without fused additions, and their
        libraries, differ in the last digits, as the builds of tests/cross do), words alike."""
        ours, theirs = ([row.split(",") for row in text.splitlines()] for text in (ours, theirs))
        self.assertEqual(len(ours), len(theirs), what)
        self.assertEqual(ours[0], theirs[0], what)
        kinds = {"tn": "t", "tt": "t", "tx": "t", "ty": "t", "un1": "u", "ut1": "u", "un2": "u", "ut2": "u", "ux": "u", "uy": "u",
                 "gap": "u", "slip": "u"}
        largest = {}
        for name, *column in zip(*ours):
            if name != "status":
                kind = kinds.get(name, name)
                largest[kind] = max([largest.get(kind, 0)] + [abs(float(each)) for each in column])
        same = 0
        for mine, other in zip(ours[1:], theirs[1:]):
            for name, a, b in zip(ours[0], mine, other):
                same += a == b
                if a != b:
                    self.assertNotEqual(name, "status", what)
                    self.assertLessEqual(abs(float(a) - float(b)), 1e-9 * largest[kinds.get(name, name)], "%s: %s" % (what, name))
        self.assertGreater(same, 0.5 * len(ours[0]) * (len(ours) - 1), what)

    def test_a_mistake_is_told_at_its_line(self):
        before = self.text("pressure")
        self.browser.run("$('editor').focus(); $('editor').setSelectionRange(0, 0)")
        self.browser.keys("#editor", "bodyy x\n")
        self.browser.wait("return $('state').textContent.startsWith('Not solved: line ')")
        where = self.browser.run("return page.messages.filter((each) => each.severity === 'error').map((each) => each.line)")
        self.assertEqual(len(self.browser.run("return [...$('gutter').querySelectorAll('.fault')].map((each) => each.textContent)")), len(set(where)))
        self.assertEqual(self.text("pressure"), before)  # the last picture stays, and looks old
        self.assertTrue(self.browser.run("return $('shown').classList.contains('stale')"))
        self.browser.screenshot("mistake_1280.png")
        self.browser.click("#messages button")
        caret = self.browser.run("return $('editor').value.slice(0, $('editor').selectionStart).split('\\n').length")
        self.assertEqual(caret, where[0])
        text = self.browser.run("const all = $('editor').value; return all.includes('bodyy x')")
        self.assertTrue(text)
        self.browser.run("$('editor').value = $('editor').value.replace('bodyy x\\n', ''); $('editor').oninput()")
        self.browser.wait("return $('state').textContent.startsWith('Solved')")
        self.assertFalse(self.browser.run("return $('shown').classList.contains('stale')"))

    def test_an_edit_is_solved(self):
        before = self.browser.run("return Math.max(...page.result.rows.map((row) => row.tn))")
        self.browser.run("$('editor').value = $('editor').value.replace(/E 3000/, 'E 6000'); $('editor').oninput()")
        time.sleep(0.5)
        self.browser.wait(IDLE)
        after = self.browser.run("return Math.max(...page.result.rows.map((row) => row.tn))")
        self.assertAlmostEqual(after / before, 2 ** 0.5, delta=0.1)  # Hertz: with the root of the stiffness

    def again(self):
        self.browser.open(PAGE.as_uri())
        self.browser.wait(IDLE)

    def test_edits_and_values_survive_a_reload(self):
        self.browser.run("$('editor').value = $('editor').value.replace(/E 3000/, 'E 6000'); $('editor').oninput()")
        self.browser.run("const field = $('value-P'); field.value = '300'; field.onchange()")
        self.browser.wait(IDLE)
        state, numbers = self.text("state").split(" in ")[0], self.text("numbers")
        self.again()
        self.assertIn("E 6000", self.browser.run("return $('editor').value"))
        self.assertEqual(self.browser.run("return [$('value-P').value, page.parameters.find((each) => each.name === 'P').chosen]"),
                         ["300", "300"])
        self.assertEqual((self.text("state").split(" in ")[0], self.text("numbers")), (state, numbers))
        self.browser.click("#reset")
        self.browser.wait(IDLE)
        self.assertIn("E 3000", self.browser.run("return $('editor').value"))
        self.assertNotEqual(self.text("numbers"), numbers)
        self.choose("family:punch")
        self.browser.run("const field = $('value-mu'); field.value = '0.4'; field.onchange()")
        self.browser.wait(IDLE)
        deck = self.browser.run("return $('editor').value")
        self.again()
        self.assertEqual(self.browser.run("return [$('example').value, $('value-mu').value, $('editor').value]"),
                         ["family:punch", "0.4", deck])
        self.browser.run("localStorage.setItem(KEPT, '{broken')")
        self.again()
        self.assertEqual(self.browser.run("return $('example').value"), "sketch:roller.c2s")

    def test_an_edited_sketch_is_saved_with_the_values_of_its_sliders(self):
        place = os.path.join(self.folder.name, "edited")
        os.makedirs(place, exist_ok=True)
        self.browser.devtools("Browser.setDownloadBehavior", behavior="allow", downloadPath=place)
        self.browser.run("const field = $('value-P'); field.value = '300'; field.onchange()")
        self.browser.wait(IDLE)
        self.browser.click("#save button[data-output=problem]")
        name, end = pathlib.Path(place, "model.c2s"), time.time() + PATIENCE
        while time.time() < end and not name.exists():
            time.sleep(0.1)
        self.assertRegex(name.read_text(), r"(?m)^parameter .*\bP 300\b")
        subprocess.run([PROGRAM, "run", "model.c2s", "--csv", "contact.csv"], cwd=place, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        self.compare(pathlib.Path(place, "contact.csv").read_text(), self.browser.run("return page.full['csv.csv']"), "saved")
        for text, values, saved in (("parameter a 1, b={a * 2} c 3 ! a 1", {"a": 5, "c": 6}, "parameter a 5, b={a * 2} c 6 ! a 1"),
                                    ("line a 1\n  parameter  a = 1", {"a": 2}, "line a 1\n  parameter  a = 2")):
            parameters = [{"name": key, "chosen": value} for key, value in values.items()]
            self.assertEqual(self.browser.run("const before = page.parameters; page.parameters = arguments[1]; "
                                              "const text = withValues(arguments[0]); page.parameters = before; return text",
                                              text, parameters), saved)

    def test_stated_errors_are_shown_when_the_mesh_is_sought(self):
        self.assertNotIn("\u00b1", self.text("numbers"))
        self.browser.click("#seek")
        self.browser.wait(IDLE)
        self.assertRegex(self.text("state"), r"stated errors: .*peak pressure [0-9.]+ %")
        self.assertRegex(self.text("numbers"), r"peak pressure.*?\u00b1 [0-9.]+")

    def test_a_slider_solves_while_it_is_dragged(self):
        place = self.browser.run("const box = $('parameters').querySelector('input[type=range]').getBoundingClientRect(); return [box.left, box.top, box.width, box.height]")
        label = self.browser.run("return $('parameters').querySelector('label').textContent")
        self.assertEqual(label, "P")
        self.browser.run("window.seen = []; const all = show; show = () => { all(); seen.push(Math.max(...page.result.rows.map((row) => row.tn))); }")
        left, top, width, height = place
        middle = int(top + height / 2)
        steps = [{"type": "pointerMove", "duration": 0, "x": int(left + width * 0.25), "y": middle}, {"type": "pointerDown", "button": 0}]
        for i in range(1, 15):
            steps += [{"type": "pointerMove", "duration": 60, "x": int(left + width * (0.25 + 0.045 * i)), "y": middle},
                      {"type": "pause", "duration": 100}]
        self.browser.act({"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": steps + [{"type": "pointerUp", "button": 0}]})
        self.browser.wait(IDLE)
        seen = self.browser.run("return seen")
        self.assertGreaterEqual(len(seen), 4)
        self.assertGreater(seen[-1], 1.3 * seen[0])  # more load, more pressure: on the way, too
        self.assertEqual(seen[:-1], sorted(seen[:-1]))
        value = float(self.browser.run("return $('value-P').value"))
        self.assertAlmostEqual(seen[-1] / seen[0], 1, delta=3)
        self.assertGreater(value, 100)

    def test_the_deformed_shape_shows_the_contact_and_bodies_that_do_not_overlap(self):
        overlaps = """
          const shapes = [...$('deformed').querySelectorAll('path')].filter((each) => /fill[12]/.test(each.getAttribute('fill')));
          const box = $('deformed').querySelector('clipPath rect').getBBox(), found = [];
          for (const shape of shapes) shape.style.strokeWidth = '3px';
          for (const shape of shapes)
            for (const [x, y] of [...shape.getAttribute('d').matchAll(/[ML](\\S+) ([^ML]+)/g)].map((each) => [Number(each[1]), Number(each[2])])) {
              if (x < box.x || x > box.x + box.width || y < box.y || y > box.y + box.height) continue;
              const point = new DOMPoint(x, y);
              for (const other of shapes)
                if (other.getAttribute('fill') !== shape.getAttribute('fill') && other.isPointInFill(point) && !other.isPointInStroke(point)) found.push([x, y]);
            }
          return [shapes.length, found];"""
        for value, bodies in (("sketch:roller.c2s", 4), ("sketch:press_fit.c2s", 8), ("family:mindlin", 2)):
            self.choose(value)
            self.assertEqual(self.browser.run("return $('view').value"), "contact")
            widths = []
            for view in ("contact", "whole"):
                self.browser.run("$('view').value = arguments[0]; $('view').onchange()", view)
                words = self.browser.run("return [...$('deformed').querySelectorAll('text')].map((each) => each.textContent)")
                self.assertIn("x", "".join(words))
                places = [float(each) for each in words if re.fullmatch(r"-?[0-9.e-]+", each)]
                self.assertGreater(len(places), 5)  # ticks of both axes
                widths.append(self.browser.run("return 2 * page.shape.d.half"))
                steps = self.browser.run("return Number($('magnify').max)")
                for step in range(steps + 1):
                    self.browser.run("$('magnify').value = arguments[0]; $('magnify').oninput()", step)
                    count, found = self.browser.run(overlaps)
                    self.assertEqual((count, found), (bodies, []), "%s, %s, %s" % (value, view, self.text("magnify-text")))
                self.assertRegex(self.text("deformed"), "to scale" if steps == 0 else "displacements and gaps \u00d7 [0-9]+")
            self.assertLessEqual(widths[0], widths[1])
        self.choose("sketch:roller.c2s")
        self.assertLess(self.browser.run("return page.shape.d.half"), 2)  # mm, of a roller of radius 20

    def test_on_a_phone_chart_and_sliders_are_on_one_screen_however_many_there_are(self):
        self.size(390, 844)
        self.choose("family:mindlin")
        self.assertGreater(self.browser.run("return $('parameters').children.length"), 8)
        chart, sliders = self.browser.run("return ['pressure', 'parameters'].map((id) => $(id).getBoundingClientRect().toJSON())")
        self.assertGreaterEqual(sliders["top"], chart["bottom"] - 1)
        self.assertLessEqual(sliders["bottom"] - chart["top"], 844)

    def test_the_load_path_is_scrubbed(self):
        self.choose("deck:hertz.dat")
        self.assertIn("step 28 of 28", self.text("step-text"))
        last = self.browser.run("return $('pressure').innerHTML")
        self.browser.keys("#step", "\ue012" * 10)  # arrow to the left
        self.assertIn("step 18 of 28", self.text("step-text"))
        self.assertNotEqual(self.browser.run("return $('pressure').innerHTML"), last)
        self.assertEqual(self.browser.run("return $('mu').options.length"), 2)
        self.assertRegex(self.label_of("pressure"), "largest pressure .*stick")

    def label_of(self, name):
        return self.browser.run("return $(arguments[0]).querySelector('svg').getAttribute('aria-label')", name)

    def words_of(self, name):
        return self.browser.run("return [...$(arguments[0]).querySelectorAll('text, tspan')].map((each) => each.textContent)", name)

    def test_a_tie_has_stresses_and_no_bounds_and_is_not_the_first_zone_shown(self):
        for value, contact, tie in (("sketch:t9_shoe.c2s", "top on toe", "bond on bond"), ("family:crack", "crack on crack",
                                                                                            "ahead on ahead (zone 2)")):
            self.choose(value)
            names = self.browser.run("return [...$('zone').options].map((each) => each.textContent)")
            self.assertEqual(self.browser.run("return $('zone').selectedOptions[0].textContent"), contact)
            self.assertLessEqual({"pressure", "friction", "stick", "slip", "open"}, set(self.words_of("pressure")))
            self.browser.run("$('zone').selectedIndex = arguments[0]; $('zone').onchange()", names.index(tie))
            words = self.words_of("pressure") + self.words_of("status-map")
            self.assertLessEqual({"normal stress", "shear stress", "tied"}, set(words))
            self.assertEqual({"pressure", "friction", "stick", "slip", "open"} & set(words), set())
            self.assertNotIn("open", "".join(words))
            self.assertEqual(self.browser.run("return $('pressure').querySelectorAll('polygon').length"), 0)
            self.assertRegex(self.label_of("pressure"), "largest normal stress.* tied$")
            self.assertIn("normal stress", self.text("pairs"))

    def test_a_zone_has_the_bounds_of_its_own_friction(self):
        text = (ROOT / "examples" / "tutorial" / "t9_shoe.c2s").read_text()
        for mu in ("0", "0.1"):
            self.browser.run("$('editor').value = arguments[0]; $('editor').onchange()", text.replace("mu 0.1", "mu " + mu))
            self.browser.wait(IDLE)
            self.assertEqual(self.browser.run("return $('pressure').querySelectorAll('polygon').length"), 1 if mu != "0" else 0)

    def test_factors_of_all_load_cases_are_shown(self):
        self.choose("sketch:t6_history.c2s")
        factors = self.browser.run("return page.result.json.steps_detail.map((each) => each.loads)")
        for step in (1, 15, len(factors)):
            self.browser.run("$('step').value = arguments[0]; $('step').oninput()", step)
            shown = re.fullmatch(r"step %d of %d, loads (\S+), (\S+)" % (step, len(factors)), self.text("step-text")).groups()
            for each, factor in zip(shown, factors[step - 1]):
                self.assertAlmostEqual(float(each), factor, delta=1e-4)

    def test_an_early_end_is_not_a_time(self):
        self.choose("sketch:t12_sliding.c2s")
        self.assertRegex(self.text("state"), r"^Ended early \(gross sliding\); [0-9.]+ m?s;")

    def test_contact_numbers_are_those_of_the_report(self):
        """The same columns, units, digits and zeros."""
        table = ("[...%s.querySelectorAll('#numbers tr, #numbers p')].map((row) => "
                 "row.cells ? [...row.cells].map((cell) => cell.textContent) : [row.textContent])")

        def number(word):  # 4.7e-05 is 0.000047
            return float(word) if re.fullmatch(r"-?[0-9.]+(e-?[0-9]+)?", word) else word

        for value in ("sketch:roller.c2s", "sketch:t9_shoe.c2s", "sketch:ball_on_flat.c2s", "sketch:press_fit.c2s", "sketch:hub.c2s",
                      "sketch:coated_roller.c2s", "deck:hertz.dat", "sought"):
            if value == "sought":
                self.browser.run("$('example').value = 'sketch:roller.c2s'; $('seek').checked = true; $('example').onchange()")
                self.browser.wait(IDLE)
            else:
                self.choose(value)
            ours = self.browser.run("return " + table % "document")
            theirs = self.browser.run("const report = new DOMParser().parseFromString(page.full['report.html'], 'text/html');"
                                      "return " + table % "report")
            self.assertEqual(ours[0], theirs[0])
            self.assertEqual(len(ours), len(theirs))
            self.assertGreater(len(ours), 10)
            for mine, other in zip(ours[1:], theirs[1:]):
                self.assertEqual(len(mine), len(other))
                if len(mine) == 1:  # the heading of a zone, or what forces are those of
                    self.assertEqual(mine[0].startswith("Forces"), other[0].startswith("Forces"))
                    self.assertTrue(mine == other or not mine[0].startswith("Forces"), mine)
                    continue
                self.assertEqual(*([[number(word) for word in cell.split(" ")] for cell in row] for row in (mine, other)))

    def test_tables_that_are_cut_on_a_phone_show_it(self):
        self.size(390, 844)
        self.choose("sketch:t9_shoe.c2s")
        self.browser.run("$('pairs').parentElement.open = true")
        cut = self.browser.run("return ['numbers', 'pairs'].map($).filter((each) => each.scrollWidth > each.clientWidth)"
                               ".map((each) => getComputedStyle(each).backgroundImage)")
        self.assertGreater(len(cut), 0)
        self.assertEqual([each for each in cut if each.count("gradient") != 4], [])
        self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), 390)
        self.browser.screenshot("tables_390.png")

    def test_every_example_is_there_by_its_title(self):
        files = [each for place in ("tutorial", "revolution", "") for kind in ("c2s", "dat")
                 for each in (ROOT / "examples" / place).glob("*." + kind)]
        options = self.browser.run("return [...$('example').options].map((each) => [each.value, each.textContent])")
        found = {value.split(":")[1]: text for value, text in options if not value.startswith("family:")}
        self.assertEqual(set(found), {each.name for each in files})
        self.assertEqual([name for name, text in found.items() if text == name or re.fullmatch(r"\d+ " + re.escape(name), text)], [])
        self.assertEqual(found["t11_deck.dat"], "11 TWO BLOCKS")
        self.assertTrue(found["hertz.dat"].startswith("HERTZ'S PROBLEM."))  # the last of its 14 heading lines
        decks = [text for name, text in found.items() if name.endswith(".dat")]
        self.assertEqual(len(decks), len(set(decks)))

    def test_charts_are_over_x_or_y_and_go_on_beyond_a_line_of_symmetry(self):
        for value, name in (("sketch:roller.c2s", "x (mm)"), ("sketch:hub.c2s", "y (mm)"), ("sketch:press_fit.c2s", "along the zone (mm)"),
                            ("sketch:ball_on_flat.c2s", "x (mm)"), ("sketch:gear_pair.c2s", "along the zone (mm)")):
            self.choose(value)
            self.assertIn(name, self.words_of("pressure"))
            rows = self.browser.run("return stepsShown().steps.pop().map(({s, tn, tt, isImage, x, y}) => "
                                    "[s, tn, tt, isImage === true, x, y])")
            self.assertEqual([row[0] for row in rows], sorted(row[0] for row in rows))
            images = [row for row in rows if row[3]]
            if value == "sketch:gear_pair.c2s":
                self.assertEqual(images, [])
                continue
            self.assertIn(len(rows) - 2 * len(images), (0, 1))
            for one, other in zip(rows, reversed(rows)):
                self.assertEqual((one[0], one[1]), (-other[0], other[1]))
                if one[3] != other[3]:
                    self.assertEqual(one[2], -other[2])
            if name[0] != "a":
                self.assertEqual([row[0] for row in rows if not row[3]], [row[4 if name[0] == "x" else 5] for row in rows if not row[3]])
            counts = re.findall(r"(\d+) (?:stick|slip|open)", self.label_of("pressure"))
            self.assertEqual(sum(int(each) for each in counts), len(rows) - len(images))  # of the model

    def test_the_factor_of_the_deformed_shape_is_that_of_the_report(self):
        for value, whole in (("sketch:press_fit.c2s", 5), ("sketch:roller.c2s", 1)):
            self.choose(value)
            text = self.browser.run("return $('editor').value")
            self.browser.run("$('view').value = 'whole'; $('view').onchange()")
            self.assertEqual(self.text("magnify-text"), "to scale" if whole == 1 else "times %d" % whole)
            with tempfile.TemporaryDirectory() as folder:  # as the page solves it: on the first mesh
                pathlib.Path(folder, "a.c2s").write_text(text + "\ntolerance off\n")
                subprocess.run([PROGRAM, "run", "a.c2s", "-q", "--figures", "f", "--listing", "l"], cwd=folder, check=True)
                caption = re.search("<desc>(.*)</desc>", pathlib.Path(folder, "f", "deformed.svg").read_text()).group(1)
            self.assertIn("to scale" if whole == 1 else "displacements and gaps &#215; %d:" % whole, caption)

    def test_a_rigid_body_is_drawn_rigid(self):
        lifts = """
          const lift = (end) => String(end.lift.map((each) => each.toFixed(12)));
          return [...page.shape.d.shapes].map(([body, curves]) => [body, new Set(curves.flat().map(lift)).size])"""
        for value, rigid in (("sketch:t9_shoe.c2s", [3]), ("sketch:ball_on_flat.c2s", [1])):
            self.choose(value)
            counts = dict(self.browser.run(lifts))
            self.assertEqual({counts[body] for body in rigid}, {1})
        self.assertGreater(max(counts.values()), 1)  # the ball
        # what does not fit then is not offered
        self.choose("sketch:t9_shoe.c2s")
        self.assertEqual(self.browser.run("return page.shape.factors.filter((factor) => !fits(page.shape.d, factor, 600))"), [])
        self.assertFalse(self.browser.run("const d = page.shape.d; d.lifted.add(50); return gapsFit(d, 50, 2 * d.half / 600)"))

    def test_magnified_gaps_leave_no_notch_and_no_distortion(self):
        # a flat zone of length 2 on an outline that goes on with the slope 0.1; body 1 below
        found = self.browser.run("""
          const at = (x, y) => ({x, y}), pairs = [0, 0.5, 1, 1.5, 2].map((x) => ({x, y: 0.5, n: [0, 1], initial: 0.5}));
          return besideZone(pairs, [[at(9, 0), at(-9, 0)]], [[at(0, 0.5), at(2, 0.5), at(9, 1.2)]])""")
        self.assertGreater(len(found), 20)
        # the back of body 2 is not beside the zone
        behind = self.browser.run("""
          const at = (x, y) => ({x, y}), pairs = [0, 0.5, 1, 1.5, 2].map((x) => ({x, y: 0.5, n: [0, 1], initial: 0.5}));
          return besideZone(pairs, [[at(9, 0), at(-9, 0)]], [[at(9, 1.5), at(-9, 1.5)]])""")
        self.assertEqual(behind, [])
        for each in found:
            self.assertTrue(2 < each["x"] < 4)
            self.assertAlmostEqual(each["initial"], 0.5 + 0.1 * (each["x"] - 2))
        shape = """
          const ends = [0, 1, 1, 2].map((x) => ({x, y: 0, lift: [0, arguments[0] * x]}));
          const d = {shapes: new Map([[1, [ends]]]), lifted: new Set([arguments[2]]), x: 0, y: 0, half: arguments[3]};
          return shapesFit(d, 5, arguments[1])"""
        for slope, pixel, lifted, half, fits in ((0.02, 0.01, 5, 3, True), (0.1, 0.01, 5, 3, False), (0.1, 1, 5, 3, True),
                                                 (0.1, 0.01, 2, 3, True), (0.1, 0.01, 5, -1, True)):
            self.assertEqual(self.browser.run(shape, slope, pixel, lifted, half), fits, (slope, pixel, lifted, half))

    def test_families_are_those_that_make_knows(self):
        listed = subprocess.run([PROGRAM, "make", "--list"], stdout=subprocess.PIPE, check=True).stdout.decode()
        known = [line.split(":")[0] for line in listed.splitlines() if line[:1].isalpha() and ": " in line and "usage" not in line]
        names = self.browser.run("return [...$('example').options].map((each) => each.value).filter((each) => each.startsWith('family:'))")
        self.assertEqual(names, ["family:" + name for name in known])

    def test_a_family_has_sliders_for_its_keys(self):
        self.choose("family:mindlin")
        self.assertTrue(self.text("state").startswith("Solved"))
        names = self.browser.run("return [...$('parameters').querySelectorAll('label')].map((each) => each.textContent)")
        self.assertIn("Q", names)
        self.browser.run("const f = $('value-Q'); f.value = '0.3'; f.onchange()")
        self.browser.wait(IDLE)
        self.assertTrue(self.text("state").startswith("Solved"))
        with tempfile.TemporaryDirectory() as folder:
            deck = subprocess.run([PROGRAM, "make", "mindlin", "Q=0.3"], check=True, stdout=subprocess.PIPE, cwd=folder).stdout.decode()
        self.assertEqual(self.browser.run("return $('editor').value").split(), deck.split())

    def test_every_example_of_each_kind_runs(self):
        values = self.browser.run("return [...$('example').options].map((each) => each.value)")
        self.assertGreater(len([each for each in values if each.startswith("family:")]), 15)
        self.assertGreater(len([each for each in values if each.startswith("sketch:")]), 8)
        self.assertNotIn("family:usage", values)
        self.assertEqual([re.sub("_.*", "", each.split(":")[1]) for each in values[:12]], ["t%d" % i for i in range(1, 13)])
        for value in ["sketch:t1_roller.c2s", "deck:t11_deck.dat", "sketch:gear_pair.c2s", "sketch:rough_profile.c2s",
                      "deck:thick_ring.dat", "family:crack", "sketch:washer.c2s"]:
            self.choose(value)
            self.assertRegex(self.text("state"), "^(Solved|Ended early)", value)

    def test_every_output_is_saved(self):
        place = os.path.join(self.folder.name, "saved")
        os.makedirs(place, exist_ok=True)
        self.browser.devtools("Browser.setDownloadBehavior", behavior="allow", downloadPath=place)
        wanted = {"problem": "model.c2s", "listing": "listing.txt", "csv": "contact.csv", "boundary": "boundary.csv",
                  "summary": "numbers.csv", "bodies": "bodies.csv", "trace": "trace.csv", "json": "summary.json",
                  "vtk": "contact2d.vtk", "report": "report.html", "figures": "pictures.zip"}
        for output in self.browser.run("return [...$('save').children].map((each) => each.dataset.output)"):
            self.browser.click("#save button[data-output=%s]" % output)
            self.browser.wait(IDLE)
            end = time.time() + PATIENCE
            names = []
            while time.time() < end and wanted[output] not in names:
                time.sleep(0.1)
                names = os.listdir(place)
            self.assertIn(wanted[output], names)
        self.assertIn("</html>", pathlib.Path(place, "report.html").read_text())
        self.assertEqual(json.loads(pathlib.Path(place, "summary.json").read_text())["outcome"], "reached")
        with zipfile.ZipFile(os.path.join(place, "pictures.zip")) as pictures:
            self.assertIsNone(pictures.testzip())
            self.assertIn("tractions.svg", pictures.namelist())
            self.assertRegex(pictures.read("tractions.svg").decode(), r"</svg>\n<!-- contact2d tractions.svg [0-9a-f]{16} -->\n$")

    def test_every_control_has_a_name_and_the_keyboard_reaches_it(self):
        tree = self.browser.devtools("Accessibility.getFullAXTree")["nodes"]
        seen = 0
        for node in tree:
            role = node.get("role", {}).get("value")
            if role in ("slider", "button", "combobox", "textbox", "spinbutton", "checkbox", "image", "img") and not node.get("ignored"):
                seen += 1
                self.assertTrue(node.get("name", {}).get("value"), node)
        self.assertGreater(seen, 15)
        self.browser.run("document.activeElement.blur(); scrollTo(0, 0)")
        reached = []
        for _ in range(40):
            self.browser.act({"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": "\ue004"}, {"type": "keyUp", "value": "\ue004"}]})
            reached.append(self.browser.run("const a = document.activeElement; return a.id || a.dataset.output || a.tagName"))
        for name in ("example", "open", "value-P", "seek", "editor", "solve", "magnify", "numbers", "report"):
            self.assertIn(name, reached)
        self.assertEqual(self.browser.run("return $('state').getAttribute('aria-live')"), "polite")

    def test_a_long_run_can_be_stopped(self):
        self.choose("sketch:fretting_pad.c2s")
        self.browser.run("$('seek').checked = true; $('seek').onchange()")
        time.sleep(0.3)
        self.browser.click("#stop")
        self.browser.wait("return $('state').textContent === 'Stopped.'")
        self.browser.run("$('seek').checked = false; $('seek').onchange()")
        self.browser.wait(IDLE)
        self.assertTrue(self.text("state").startswith("Solved"), self.text("state"))

    def test_it_fits_a_phone_and_a_screen_in_light_and_dark(self):
        for width, height in ((1280, 1000), (390, 844)):
            for scheme in ("light", "dark"):
                self.size(width, height)
                self.browser.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
                self.browser.open(PAGE.as_uri())
                self.browser.wait(IDLE)
                self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width)
                cut = self.browser.run("return [...document.querySelectorAll('figure svg text')].filter((each) => "
                                       "each.getBoundingClientRect().right > each.ownerSVGElement.getBoundingClientRect().right + 1)"
                                       ".map((each) => each.textContent)")
                self.assertEqual(cut, [])
                back = self.browser.run("return getComputedStyle(document.body).backgroundColor")
                self.assertEqual(back, "rgb(255, 255, 255)" if scheme == "light" else "rgb(20, 24, 28)")
                papers = self.browser.run("$('more').open = true; $('more').ontoggle(); return ['stress', 'pictures'].map((id) => [...$(id)"
                                          ".children].map((each) => getComputedStyle(each.querySelector(':scope > rect')).fill))")
                self.assertGreater(min(len(each) for each in papers), 1)
                self.assertEqual(set(papers[0] + papers[1]), {"rgb(255, 255, 255)" if scheme == "light" else "rgb(21, 24, 28)"})
                self.browser.screenshot("page_%d_%s.png" % (width, scheme))
        self.browser.run("$('pressure').scrollIntoView()")  # on the phone: the sliders beneath the chart, on one screen
        chart, sliders = self.browser.run("return ['pressure', 'parameters'].map((id) => $(id).getBoundingClientRect().toJSON())")
        self.assertGreaterEqual(sliders["top"], chart["bottom"] - 1)
        self.assertLessEqual(sliders["bottom"] - chart["top"], 844)
        small = self.browser.run("return [...document.querySelectorAll('button, select, input[type=range]')].filter((each) => each.offsetHeight > 0 && each.offsetHeight < 24 && !each.closest('#messages')).length")
        self.assertEqual(small, 0)  # what a finger hits
        self.browser.devtools("Emulation.setEmulatedMedia", features=[])

    def test_the_report_fits_a_phone_and_a_screen_in_light_and_dark(self):
        with tempfile.TemporaryDirectory() as folder:
            report = pathlib.Path(folder, "report.html")
            subprocess.run([PROGRAM, "run", "-q", "--report", report, "--listing", "-", ROOT / "examples" / "fretting_pad.c2s"],
                           check=True, stdout=subprocess.DEVNULL)
            for width, height in ((1280, 1000), (390, 844)):
                for scheme in ("light", "dark"):
                    self.size(width, height)
                    self.browser.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
                    self.browser.open(report.as_uri())
                    self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width)
                    cut = self.browser.run("return [...document.querySelectorAll('section > .wide')].filter((each) => each.scrollWidth > "
                                           "each.clientWidth).map((each) => getComputedStyle(each).backgroundImage)")
                    if width == 1280:
                        self.assertEqual(cut, [])  # the margins are there to be used
                    self.assertEqual([each for each in cut if each.count("gradient") != 4], [])
                    papers = self.browser.run("return [document.body, ...document.querySelectorAll('svg > rect:first-of-type')].map((each) => "
                                              "getComputedStyle(each)[each === document.body ? 'backgroundColor' : 'fill'])")
                    self.assertGreater(len(papers), 8)
                    self.assertLessEqual(set(papers), {"rgb(255, 255, 255)", "rgba(0, 0, 0, 0)"} if scheme == "light" else {"rgb(21, 24, 28)"})
                    self.browser.screenshot("report_%d_%s.png" % (width, scheme))
        self.browser.devtools("Emulation.setEmulatedMedia", features=[])

    def test_the_page_of_ones_own_of_the_readme(self):
        page = (ROOT / "port" / "web" / "README.md").read_text().split("```html\n")[1].split("```")[0]
        self.assertLessEqual(len(page.splitlines()), 30)
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(PAGE.with_suffix(".js"), os.path.join(folder, "contact2d.js"))
            own = pathlib.Path(folder, "own.html")
            own.write_text(page)
            self.browser.open(own.as_uri())
            self.browser.wait("return document.querySelector('output') && document.querySelector('output').textContent.includes('peak')")
            first = self.browser.run("return document.querySelector('output').textContent")
            self.browser.run("const r = document.querySelector('input'); r.value = r.max; r.oninput()")
            self.browser.wait("return document.querySelector('output').textContent !== arguments[0]", first)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
