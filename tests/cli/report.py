#!/usr/bin/env python3
"""Reports: made by the commands, made again from their files, looked at in a browser."""

import base64
import csv
import html.parser
import json
import math
import os
import re
import shutil
import subprocess
import unittest

from browser import Browser
from geneva_cli import CliTest, change_case, main, read_summary, set_parameter
from space import CASE as SPACE_CASE

PSI = 6894.757293168361

# Elements without an end.
VOID = {"meta", "img", "br", "input", "hr", "link", "path", "circle", "line", "rect", "polyline", "polygon", "image"}


class Outline(html.parser.HTMLParser):
    """Refuses elements that are not closed in their order, and collects ids and texts."""

    def __init__(self):
        super().__init__()
        self.open = []
        self.ids = []
        self.text = ""

    def handle_starttag(self, tag, attrs):
        self.ids += [value for name, value in attrs if name == "id"]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.ids += [value for name, value in attrs if name == "id"]

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            raise AssertionError(f"</{tag}> closes nothing, line {self.getpos()[0]}")

    def handle_data(self, data):
        if self.open and self.open[-1] not in ("script", "style"):
            self.text += data


def complaints(file):
    """What HTML Tidy says about a page."""
    return subprocess.run(["tidy", "-errors", "-quiet", "--drop-empty-elements", "no", file], capture_output=True, text=True, check=False).stderr


def grouped(number):
    """As the tables print it: thousands apart from five digits on."""
    whole, *rest = number.split(".")
    return ".".join([f"{int(whole):,}".replace(",", "\u202f") if len(whole) > 4 else whole, *rest])


def plain(text):
    """As the terminal prints it."""
    return text.replace("\u202f", "")


def peak_in_psi(summary):
    """The peak contact pressure as the tables print it."""
    return grouped(f"{summary['contact']['peak_pressure']['value'] / PSI:.5g}")


def difference(value, reference):
    """As the tables print it: zero has no sign."""
    percent = f"{100 * (value / reference - 1):+.2f}"
    return ("0.00" if float(percent) == 0 else percent) + " %"


def read_report(file):
    outline = Outline()
    outline.feed(file.read_text())
    outline.close()
    return outline


# Captions of the tables that are wider than their place.
CUT_OFF_TABLES = """
  return [...document.querySelectorAll('.scroll')].filter((s) => s.scrollWidth > s.clientWidth + 1).map((s) => s.querySelector('caption').textContent);
"""


class ReportTest(CliTest):
    """A report that one run made, for all tests of a class."""

    case_name = None
    command = "run"
    changes = {}
    most_pages = 7

    @classmethod
    def setUpClass(cls):
        if cls.case_name is None:
            raise unittest.SkipTest("a base class")
        runner = cls("setUp")
        runner.setUp()
        cls.addClassCleanup(runner.doCleanups)
        cls.case = runner.copy_case(cls.case_name)
        change_case(cls.case, cls.changes)
        cls.results = cls.case / "results"
        run = runner.geneva(*cls.command.split(), cls.case)
        runner.assertEqual(run.code, 0, run.describe())
        if cls.command == "run":
            cls.summary = read_summary(cls.results)
        cls.prepare(runner)
        cls.browser = cls.enterClassContext(Browser()) if hasattr(cls, "enterClassContext") else Browser().__enter__()
        if not hasattr(cls, "enterClassContext"):
            cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.open(cls.results / "report.html")

    @classmethod
    def prepare(cls, runner):
        """What is done beside the run before the report is opened."""

    def chart(self, name):
        """The points of a chart's series, as the browser drew them, by the series' name."""
        return self.browser.run(
            "return Object.fromEntries(genevaCharts[arguments[0]].data.datasets.map((d) => [d.label, d.data]))", name)

    def check_page(self):
        """What holds for every report."""
        self.assertEqual([entry["message"] for entry in self.browser.console()], [])
        self.assertEqual(complaints(self.results / "report.html"), "")
        outline = read_report(self.results / "report.html")
        self.assertEqual(outline.open, [])
        self.assertEqual(len(outline.ids), len(set(outline.ids)))
        self.assertLess((self.results / "report.html").stat().st_size, 6e6)
        self.assertIn("Inputs", outline.text)
        self.assertGreater(self.browser.run("return document.querySelectorAll('#inputs tbody tr').length"), 5)
        for chart in self.browser.run("return Object.keys(genevaCharts)"):
            painted = self.browser.run(
                "const c = document.getElementById(arguments[0]); const d = c.getContext('2d')"
                ".getImageData(0, 0, c.width, c.height).data; let n = 0;"
                "for (let i = 3; i < d.length; i += 4) if (d[i] > 0) ++n; return n;", chart)
            self.assertGreater(painted, 2000, f"{chart} is blank")
        for width in (1280, 390):
            self.browser.resize(width, 900)
            fits = self.browser.wait_for(f"return document.documentElement.scrollWidth <= {width}")
            self.assertTrue(fits, f"scrolls sideways at {width} pixels")
            hidden = self.browser.run(
                "return [...document.querySelectorAll('td, th[scope=row]')].filter((c) => c.getBoundingClientRect().right > innerWidth + 1)"
                ".map((c) => c.textContent)")
            self.assertEqual(hidden, [], f"out of sight at {width} pixels")
            self.assertEqual(self.browser.run(CUT_OFF_TABLES), [], f"tables cut off at {width} pixels")
        self.browser.resize(1280, 1000)
        self.check_paper()

    def check_paper(self):
        """The curves are whole and undistorted on paper, which is narrower than the window."""
        self.browser.protocol("Emulation.setEmulatedMedia", media="print")
        # Printing lays the page out anew without giving the charts time to follow: so does one script.
        for name, canvas, figure, ratio in self.browser.run(
                "document.body.style.width = '718px'; const parts = Object.keys(genevaCharts).map((name) => { const c = document.getElementById(name);"
                "const [r, f] = [c, c.closest('figure')].map((e) => e.getBoundingClientRect());"
                "return [name, [r.left, r.right, r.width / r.height], [f.left, f.right], c.width / c.height]; });"
                "const left = document.body.getBoundingClientRect().left; document.body.style.width = '';"
                "return parts.map(([name, r, f, ratio]) => [name, r, [f[0] - left, f[1] - left, left], ratio]);"):
            self.assertGreaterEqual(canvas[0] - figure[2], figure[0] - 1, name)
            self.assertLessEqual(canvas[1] - figure[2], figure[1] + 1, name)
            self.assertLessEqual(figure[1], 718, name)
            self.assertAlmostEqual(canvas[2] / ratio, 1., delta=0.01, msg=name)  # whole pixels of 200 or more
        wide = self.browser.run("document.body.style.width = '718px'; const cut = (() => {" + CUT_OFF_TABLES + "})();"
                                "document.body.style.width = ''; return cut;")
        self.assertEqual(wide, [], "tables cut off on paper")
        self.browser.protocol("Emulation.setEmulatedMedia", media="")
        pages = set()
        for width in (390, 1280):  # of the window it is printed from
            self.browser.resize(width, 1000)
            self.browser.wait_for(f"return Object.values(genevaCharts).every((c) => c.width <= {width})")
            pages.add(len(re.findall(rb"/Type\s*/Page[^s]", self.browser.pdf())))
        self.assertEqual(len(pages), 1, pages)
        self.assertTrue(1 <= min(pages) <= self.most_pages, f"{pages} pages")

    def choose(self, control, value):
        """Sets a control of the field view as a user would."""
        self.browser.run(
            "const c = document.querySelector(`#field-view [name=\"${arguments[0]}\"]`); c.value = arguments[1];"
            "c.dispatchEvent(new Event(c.tagName === 'INPUT' ? 'input' : 'change'));", control, value)

    def field_picture(self):
        return self.browser.run("return genevaField.canvas.toDataURL()")

    def check_slider(self):
        """Wheel, pins and readings follow the slider."""
        stations = int(re.search(r"set Stations\s*= (\d+)", (self.case / "case.prm").read_text()).group(1))
        mechanism = json.loads((self.results / "mechanism.json").read_text())
        n_engaged = 0
        for index in range(0, len(mechanism["steps"]), 45):
            self.browser.run(
                "const s = document.querySelector('#mechanism-controls [name=step]'); s.value = arguments[0];"
                "s.dispatchEvent(new Event('input'))", index)
            step = mechanism["steps"][index]
            self.check_drawing(step)
            drawn = self.browser.run("return document.getElementById('mechanism-drawing').dataset.wheelAngle")
            self.assertAlmostEqual(float(drawn), step["wheel_angle"], 12)
            shown = self.browser.run(
                "return document.querySelector('#mechanism-readings [data-key=wheel_speed]').textContent")
            self.assertAlmostEqual(float(shown), step["wheel_speed"] * 30. / math.pi, delta=0.1)
            if step["engaged_pin"] is not None:
                self.check_pin_is_in_slot(step, stations)
                n_engaged += 1
        self.assertGreater(n_engaged, 0)

    def check_drawing(self, step):
        """No label covers another or an arrow's head, no pin is clipped, and caption and charts tell the position."""
        covering, clipped, caption, cursors, heads, below = self.browser.run("""
          const d = document.getElementById('mechanism-drawing'), frame = d.getBoundingClientRect();
          const boxes = [...d.querySelectorAll('.label')].map((l) => [l.textContent, l.getBoundingClientRect()]);
          const covers = ([, a], [, b]) => Math.min(a.right, b.right) > Math.max(a.left, b.left) + 1 && Math.min(a.bottom, b.bottom) > Math.max(a.top, b.top) + 1;
          const pairs = boxes.flatMap((a, i) => boxes.slice(i + 1).filter((b) => covers(a, b)).map((b) => a[0] + ' and ' + b[0]));
          const out = [...d.querySelectorAll('.pin'), ...d.querySelectorAll('.label')].filter((p) => { const b = p.getBoundingClientRect();
            return b.left < frame.left - 1 || b.right > frame.right + 1 || b.top < frame.top - 1 || b.bottom > frame.bottom + 1; }).length;
          const inside = (x, y) => boxes.filter(([, b]) => x > b.left && x < b.right && y > b.top && y < b.bottom).map((b) => b[0]);
          const heads = [...d.querySelectorAll('line.dimension[marker-end]')].flatMap((l) => {
            const [from, to] = [[l.x1, l.y1], [l.x2, l.y2]].map(([x, y]) =>
              new DOMPoint(x.baseVal.value, y.baseVal.value).matrixTransform(d.getScreenCTM()));
            const length = Math.hypot(to.x - from.x, to.y - from.y);
            return [1, 1 - 7 / length].flatMap((s) => inside(from.x + s * (to.x - from.x), from.y + s * (to.y - from.y))); });
          const force = document.getElementById('mechanism-force');
          const below = [...d.querySelectorAll('.label')].every((l) => l.compareDocumentPosition(force) & Node.DOCUMENT_POSITION_FOLLOWING);
          return [pairs, out, document.getElementById('mechanism-angle').textContent,
                  Object.values(genevaCharts).filter((c) => c.options.isOverCycle).length, heads, below];""")
        self.assertEqual(heads, [], "labels on heads of arrows")
        self.assertTrue(below, "a label may hide the force")
        self.assertEqual(covering, [])
        self.assertEqual(clipped, 0)
        self.assertAlmostEqual(float(caption), math.degrees(step["driver_angle"]), delta=0.01)
        self.assertGreaterEqual(cursors, 3)

    def check_pin_is_in_slot(self, step, stations):
        """The drawn pin lies on the middle of a slot of the drawn wheel."""
        x, y, _ = step["pins"][step["engaged_pin"]]
        turned = math.atan2(y, x) - step["wheel_angle"]
        self.assertAlmostEqual(math.remainder(turned, 2. * math.pi / stations), 0., 9)
        self.check_pin_is_drawn_in_slot(step["engaged_pin"])

    def check_pin_is_drawn_in_slot(self, pin):
        in_material = self.browser.run(
            "const p = document.querySelectorAll('#mechanism-drawing .pin')[arguments[0]];"
            "const w = document.querySelector('#mechanism-wheel');"
            "const at = document.getElementById('mechanism-drawing').createSVGPoint();"
            "at.x = p.cx.baseVal.value; at.y = p.cy.baseVal.value; return w.isPointInFill(at)", pin)
        self.assertFalse(in_material, "the pin's middle is in the wheel's material")

    def press(self, *keys):
        """Keys on the field view."""
        for key in keys:
            self.browser.run(
                "genevaField.canvas.focus();"
                "document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key: arguments[0], bubbles: true}))", key)

    def check_keys(self):
        """The keys change the picture, and Home brings it back."""
        self.press("Home")
        start = self.field_picture()
        pictures = {start}
        for key in ("ArrowLeft", "ArrowUp", "+"):
            self.press(key)
            self.assertNotIn(self.field_picture(), pictures, key)
            pictures.add(self.field_picture())
        self.press("Home")
        self.assertEqual(self.field_picture(), start)

    def colours_in_picture(self):
        """Number of different colours of the field view, every 10th pixel looked at."""
        return self.browser.run(
            "const c = document.createElement('canvas'), g = genevaField.canvas; c.width = g.width; c.height = g.height;"
            "const x = c.getContext('2d'); x.drawImage(g, 0, 0); const d = x.getImageData(0, 0, c.width, c.height).data;"
            "const s = new Set(); for (let i = 0; i < d.length; i += 40) s.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]);"
            "return s.size")

    def check_field(self, fields):
        """Every choice of the field view draws a picture of its own."""
        pictures = {}
        for field in fields:
            self.choose("field", field)
            # A blank picture has one or two; a field that is flat but for a few cells some twenty.
            self.assertGreater(self.colours_in_picture(), 20, field)
            pictures[self.field_picture()] = field
        self.assertEqual(set(pictures.values()), set(fields))
        self.choose("field", "von_mises")
        for part in ("model", "zone"):
            self.choose("part", part)
            pictures[self.field_picture()] = part
        self.choose("deformation", 1)
        pictures[self.field_picture()] = "deformed"
        self.choose("part", "model")
        self.assertEqual(self.browser.run(BORDER_OF_FIELD), 1, "the deformed model reaches the frame")
        self.choose("part", "zone")
        self.choose("deformation", 0)
        self.assertEqual(len(pictures), len(fields) + 2)

    def status_at_middle(self):
        self.browser.run(
            "const b = genevaField.canvas.getBoundingClientRect();"
            "genevaField.canvas.dispatchEvent(new PointerEvent('pointermove', {clientX: b.x + b.width / 2,"
            " clientY: b.y + b.height / 2 - 3}))")
        return self.browser.run("return document.querySelector('#field-view .status').textContent")


# At points all over the middle of the field view: by how much, of 255, the colour differs from that of the value read there.
COLOURS_AGAINST_VALUES = """
  const g = genevaField.canvas, c = document.createElement('canvas');
  c.width = g.width; c.height = g.height;
  const x = c.getContext('2d'); x.drawImage(g, 0, 0);
  const data = x.getImageData(0, 0, c.width, c.height).data;
  const palette = JSON.parse(document.getElementById('palette').textContent);
  const box = g.getBoundingClientRect(), u = genevaField.uniforms, found = [];
  for (let i = 0; i <= 60; ++i) for (let j = 0; j <= 40; ++j) {
    const [px, py] = [Math.floor((0.35 + 0.005 * i) * c.width), Math.floor((0.2 + 0.01 * j) * c.height)];
    g.dispatchEvent(new PointerEvent('pointermove', {
      clientX: box.x + (px + 0.5) / c.width * box.width, clientY: box.y + (py + 0.5) / c.height * box.height}));
    const value = parseFloat(document.querySelector('#field-view .status').textContent);
    if (!Number.isFinite(value)) continue;
    const share = Math.min(Math.max((value - u.low.value) / (u.high.value - u.low.value), 0), 1) * (palette.length - 1);
    const k = Math.min(Math.floor(share), palette.length - 2);
    let worst = 0;
    for (let n = 0; n < 3; ++n) {
      const [a, b] = [k, k + 1].map((m) => parseInt(palette[m].substr(2 * n, 2), 16));
      worst = Math.max(worst, Math.abs(a + (share - k) * (b - a) - data[4 * (py * c.width + px) + n]));
    }
    found.push(worst);
  }
  return found;
"""

# Number of colours along the border of the field view: one, where all of the model is within.
BORDER_OF_FIELD = """
  const c = document.createElement('canvas'), g = genevaField.canvas; c.width = g.width; c.height = g.height;
  const x = c.getContext('2d', { willReadFrequently: true }); x.drawImage(g, 0, 0);
  const colours = new Set();
  for (const [l, t, w, h] of [[0, 0, c.width, 1], [0, c.height - 1, c.width, 1], [0, 0, 1, c.height], [c.width - 1, 0, 1, c.height]]) {
    const d = x.getImageData(l, t, w, h).data;
    for (let i = 0; i < d.length; i += 4) colours.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]);
  }
  return colours.size;
"""

STRESSES = ("von_mises", "max_shear", "principal_stress_1", "principal_stress_2", "principal_stress_3", "displacement",
            "contact_pressure")


class SpaceReport(ReportTest):
    """The report of two blocks pressed together in 3-D."""

    case_name = "flat-patch-3d"

    def test_is_a_sound_page(self):
        self.check_page()

    def test_cuts_the_bodies(self):
        self.choose("part", "model")
        pictures = set()
        for cut in ("none", "across", "along"):
            self.choose("cut", cut)
            pictures.add(self.field_picture())
        self.assertEqual(len(pictures), 3)

    def test_is_turned_by_keys(self):
        self.choose("field", "von_mises")
        self.choose("part", "model")
        self.check_keys()

    def test_offers_no_difference_from_what_does_not_exist(self):
        names = self.browser.run("return [...document.querySelectorAll('#field-view [name=field] option')].map((o) => o.value)")
        self.assertEqual(names, list(STRESSES))

    def test_shows_the_even_pressure(self):
        peak = self.summary["contact"]["peak_pressure"]["value"]
        view = json.loads((self.results / "view.json").read_text())
        self.choose("field", "contact_pressure")
        factor = {"Pa": 1., "MPa": 1e6, "psi": PSI}[view["stress_unit"]]
        self.assert_close(self.browser.run("return genevaField.uniforms.high.value") * factor, peak, 1e-6, "colour bar")


class CutReport(ReportTest):
    """The report of a pin that presses on the edge of its slot, where the cut lies just below the wheel's side."""

    case_name = "johnson-optimum-3d"

    def test_draws_cuts_as_the_data_has_them(self):
        self.choose("field", "von_mises")
        for cut in ("across", "along"):
            self.choose("cut", cut)
            self.choose("part", "zone")
            differences = self.browser.run(COLOURS_AGAINST_VALUES)
            self.assertGreater(len(differences), 1000, cut)
            wrong = sum(difference > 30 for difference in differences)  # 0.2 % stand on the bodies' outlines
            self.assertLess(wrong, 0.005 * len(differences), f"{cut}: {wrong} of {len(differences)} points")


class PlaneReport(ReportTest):
    """The report of Johnson's optimum wheel in the plane."""

    case_name = "johnson-optimum-wheel"

    def test_is_a_sound_page(self):
        self.check_page()

    def test_tells_the_same_figures_as_the_summary(self):
        text = read_report(self.results / "report.html").text
        peak, hertz = (self.summary[section]["peak_pressure"]["value"] for section in ("contact", "hertz"))
        error = self.summary["contact"]["peak_pressure_error"]
        for figure in ("232.39", peak_in_psi(self.summary), grouped("72675"), grouped("72600"), difference(peak, hertz),
                       f"{100 * error:.2g} %", "± error", f"± {100 * error:.2g} %",
                       f"± {100 * self.summary['contact']['half_width_error']:.2g} %"):
            self.assertIn(figure, text)
        self.assertEqual(text.count("✓ passed"), len(self.summary["checks"]))
        self.assertIn("von Mises stress, wheel [psi]bottom of the engaged slot", text)

    def test_prints_every_input(self):
        opened = self.browser.run("return [...document.querySelectorAll('#inputs summary')].map((s) => s.textContent)")
        self.assertEqual(len(opened), 2)
        text = read_report(self.results / "report.html").text
        given = text[text.index("What the case gives"):text.index("Everything else")]
        self.assertEqual(given.count("Poisson's ratio"), 2, "is given, be it the default or not")
        self.assertIn("0.283 lb/in³", text)
        self.assertIn("set Density          = 0.283 lb/in^3", text)
        self.browser.protocol("Emulation.setEmulatedMedia", media="print")
        heights = self.browser.run(
            "return [...document.querySelectorAll('#inputs details > :not(summary)')].map((e) => e.getBoundingClientRect().height)")
        self.browser.protocol("Emulation.setEmulatedMedia", media="")
        for height in heights:
            self.assertGreater(height, 50, "folded on paper")

    def test_draws_the_pressure_of_the_summary(self):
        drawn = max(point["y"] for point in self.chart("chart-pressure")["this program"])
        self.assert_close(drawn * PSI, self.peak_of_mesh(), 1e-3, "pressure")
        hertz = max(point["y"] for point in self.chart("chart-pressure")["Hertz"])
        self.assert_close(hertz * PSI, self.summary["hertz"]["peak_pressure"]["value"], 1e-12, "Hertz's")
        self.assertGreater(len(self.chart("chart-pressure")["Hertz"]), 300)

    def test_draws_every_mesh(self):
        levels = self.summary["solver"]["levels"]
        drawn = self.chart("chart-convergence")["this program"]
        self.assertEqual([point["x"] for point in drawn], [level["dofs"] for level in levels])

    def test_field_view_shows_what_is_chosen(self):
        self.check_field((*STRESSES, "hertz_difference", "mcewen_difference"))

    def test_field_view_is_moved_by_keys(self):
        self.choose("field", "von_mises")
        self.choose("part", "zone")
        self.check_keys()

    def test_draws_the_difference_from_hertz_s_pressure(self):
        with open(self.results / "contact.csv", newline="", encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        exact = [float(row["contact_pressure [psi]"]) - float(row["hertz_pressure [psi]"]) for row in rows]
        drawn = self.browser.run("return Array.from(genevaField.meshes.contact.fields.hertz_difference)")[::2]
        step = (max(exact) - min(exact)) / 65534  # numbers are kept to half of it
        for one, other in zip(drawn, exact, strict=True):
            self.assertAlmostEqual(one, other, delta=step)

    def test_reads_the_value_under_the_cursor(self):
        self.choose("field", "von_mises")
        self.choose("part", "zone")
        status = self.status_at_middle()
        found = re.match(r"([\d.]+) psi in the (pin|wheel) at x = ([-\d.]+), y = ([-\d.]+) in$", status)
        self.assertTrue(found, status)
        self.assertTrue(20000 < float(found.group(1)) < 45000, status)
        distance = self.summary["load"]["pin_distance"]["value"] / 0.0254
        self.assertAlmostEqual(float(found.group(3)), distance, delta=0.003)

    def test_keeps_the_values_that_are_clicked(self):
        self.choose("field", "von_mises")
        self.choose("part", "zone")
        status = self.status_at_middle()
        for kind in ("pointerdown", "pointerup"):
            self.browser.run(
                "const b = genevaField.canvas.getBoundingClientRect();"
                "genevaField.canvas.dispatchEvent(new PointerEvent(arguments[0], {clientX: b.x + b.width / 2,"
                " clientY: b.y + b.height / 2 - 3}))", kind)
        kept = self.browser.run("return [...document.querySelectorAll('#field-view .kept li')].map((l) => l.textContent)")
        self.assertEqual(kept, ["A: von Mises stress " + status])

    def test_colour_bar_has_round_marks(self):
        self.choose("field", "von_mises")
        marks = self.browser.run("return [...document.querySelectorAll('#field-view .ticks span')].map((s) => s.textContent)")
        numbers = [float(mark.replace("\u202f", "")) for mark in marks]
        self.assertGreaterEqual(len(numbers), 3)
        step = numbers[1] - numbers[0]
        self.assertIn(f"{step:.1e}"[:3], ("1.0", "2.0", "2.5", "5.0"))
        for number in numbers:
            self.assertAlmostEqual(math.remainder(number, step) / step, 0., 6)

    def test_curves_over_the_cycle_end_where_it_ends(self):
        for name in ("chart-wheel_speed", "chart-pin_force"):
            low, high, marks, zero = self.browser.run(
                "const c = genevaCharts[arguments[0]]; const x = c.scales.x;"
                "return [x.min, x.max, x.ticks.map((t) => t.value), c.scales.y.ticks.some((t) => t.value === 0)]", name)
            self.assertEqual((round(low), round(high)), (-180, 180))
            self.assertEqual([round(mark, 6) for mark in marks], list(range(-180, 181, 45)))
            self.assertTrue(zero, "no mark at 0")

    def test_draws_the_maximum_contact_pressure(self):
        self.choose("field", "contact_pressure")
        self.assert_close(self.browser.run("return genevaField.uniforms.high.value") * PSI,
                          self.peak_of_mesh(), 1e-3, "colour bar")

    def peak_of_mesh(self):
        """The peak without its correction: nodes scatter about it by less than 0.1 %."""
        contact = self.summary["contact"]
        return contact["peak_pressure"]["value"] / (1. + contact["peak_pressure_correction"])

    def test_slider_turns_the_mechanism(self):
        self.check_slider()

    def test_tells_the_dimensions_on_the_drawing(self):
        words = self.browser.run(
            "return [...document.querySelectorAll('#mechanism-drawing .dimension-text')].map((t) => t.textContent)")
        self.assertEqual(sorted(words), sorted(["R 2.265 in", "R 2.265 in", "R 1.5855 in", "3.2032 in", "⌀ 0.6795 in"]))

    def test_marks_the_analysed_angle(self):
        load = self.summary["load"]
        (mark,) = self.chart("chart-pin_force")["analysed"]
        self.assert_close(mark["x"], math.degrees(load["driver_angle"]["value"]), 1e-9, "angle")
        self.assert_close(mark["y"] * 4.4482216152605, load["force"]["value"], 1e-9, "force")

    def test_is_the_same_when_made_again(self):
        first = (self.results / "report.html").read_text()
        run = self.geneva("report", self.results, "-o", self.case / "again.html")
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual((self.case / "again.html").read_text(), first)


class InternalGeneva(ReportTest):
    """The report of the motion of an internal Geneva."""

    case_name = "internal-six-station"
    command = "kinematics"

    def test_is_a_sound_page(self):
        self.check_page()

    def test_slider_turns_the_mechanism(self):
        self.check_slider()


    def test_sizes_step_aside_for_the_force_and_can_be_read(self):
        faded = self.browser.run("return [...document.querySelectorAll('#mechanism-drawing .label')].filter((l) => l.style.opacity === '0.15').length")
        self.assertEqual(faded, 0)


class SphericalGeneva(InternalGeneva):
    case_name = "spherical-eight-station"

    def check_pin_is_drawn_in_slot(self, pin):
        """Nothing: the drawing of a sphere is no plane, its lines cross."""


class LongDwellGeneva(InternalGeneva):
    case_name = "long-dwell"


class FourBarGeneva(InternalGeneva):
    case_name = "four-bar-geneva"


class SiReport(ReportTest):
    """The report of a motion in SI units, whose angles are radians."""

    case_name = "four-bar-geneva"
    command = "kinematics"
    changes = {"Output units": "SI"}

    def test_is_a_sound_page(self):
        self.check_page()

    def test_radians_are_marked_in_quarters_of_pi(self):
        low, high, marks = self.browser.run(
            "const x = genevaCharts['chart-pin_force'].scales.x; return [x.min, x.max, x.ticks.map((t) => t.label)]")
        quarters = {"-π": -4, "-3π/4": -3, "-π/2": -2, "-π/4": -1, "0": 0, "π/4": 1, "π/2": 2, "3π/4": 3, "π": 4,
                    "5π/4": 5, "3π/2": 6, "7π/4": 7, "2π": 8}
        found = [quarters[mark] for mark in marks]
        self.assertEqual(found, list(range(math.ceil(4 * low / math.pi - 1e-6), math.floor(4 * high / math.pi + 1e-6) + 1)))


class TwoPinGeneva(InternalGeneva):
    case_name = "irregular-two-pin"

    def test_tells_its_two_dwells_apart(self):
        text = read_report(self.results / "report.html").text
        for number in (1, 2):
            self.assertEqual(text.count(f"dwell time after engagement {number}"), 1)


class CrownReport(ReportTest):
    """The report of the crown by which a pin carries its load most evenly."""

    command = "design --crown"
    case_name = "a short pin"

    def copy_case(self, name, *rest):
        case = self.directory / "short"
        case.mkdir()
        text = SPACE_CASE.format(
            dimension=3, accuracy="20 %", thickness="8 mm", modulus="2 GPa", diameter="115 mm", pin_diameter="17 mm",
            model="local", more="", speed="600 rpm",
            pin="  subsection Pin\n    set Held at = one end\n    set Root gap = 10 mm\n  end\n")
        (case / "case.prm").write_text(text)
        return case

    def test_is_a_sound_page(self):
        self.check_page()

    def test_draws_both_pins(self):
        crown = json.loads((self.results / "crown.json").read_text())
        series = self.chart("chart-crown-line_load")
        self.assertEqual(set(series), {"as it is", "most even", "most even, by finite elements"})
        maximum = {name: max(point["y"] for point in points) for name, points in series.items()}
        self.assertLess(maximum["most even"], maximum["as it is"])
        for name, key in (("as it is", "before"), ("most even", "after"),
                          ("most even, by finite elements", "finite_elements")):
            self.assertGreaterEqual(maximum[name] * 1e3, crown[key]["maximum_line_load"]["value"])
        tried = [trial["ratio"] for trial in crown["search"]]
        self.assertGreater(len(tried), 5)
        self.assertEqual([point["y"] for point in self.chart("chart-crown-search")["tried"]], tried)
        lines = self.chart("chart-crown-map")
        self.assertEqual(set(lines), {"tilt 0 deg"})
        self.assertEqual(len(lines["tilt 0 deg"]), len(crown["map"]["sizes"]))

    def test_tells_the_size(self):
        crown = json.loads((self.results / "crown.json").read_text())
        text = read_report(self.results / "report.html").text
        self.assertIn("makes the line load most even", text)
        self.assertIn(f"{crown['crown']['size']['value'] * 1e3:.4g} mm", text)


class WholeReport(ReportTest):
    """The report on a directory in which run, kinematics and design left their results."""

    case_name = "johnson-optimum-wheel"
    most_pages = 8

    @classmethod
    def prepare(cls, runner):
        for command in ("kinematics", "design"):
            run = runner.geneva(command, cls.case)
            runner.assertEqual(run.code, 0, run.describe())

    def test_is_a_sound_page(self):
        self.check_page()

    def test_tells_all_three(self):
        text = read_report(self.results / "report.html").text
        for words in ("Verdict", "Motion over the cycle", "Choice of the wheel", grouped("72675"), "motion time over dwell time"):
            self.assertIn(words, text)

    def test_tells_the_best_wheel_first(self):
        design = json.loads((self.results / "design.json").read_text())
        words = self.browser.run("return document.querySelector('#design .answer').textContent")
        self.assertIn(f"{design['optimum_diameter']['value'] / 0.0254:.5g} in", words, "of Johnson's inertia, as the case has it")
        flat = [point["x"] for point in self.chart("chart-design")["as drawn, within 1 %"]]
        self.assertTrue(flat[0] < design["geometry"]["optimum_diameter"]["value"] / 0.0254 < flat[-1])

    def test_explains_the_figures_of_the_motion(self):
        words = self.browser.run(
            "return [...document.querySelectorAll('#kinematics tbody tr')].map((r) => [r.cells[1].textContent, r.querySelector('abbr').title])")
        self.assertGreater(len(words), 8)
        for _, meaning in words:
            self.assertGreater(len(meaning), 10)
        self.assertIn("kt", [symbol for symbol, _ in words])

    def test_marks_the_best_wheel(self):
        design = json.loads((self.results / "design.json").read_text())
        (best,) = self.chart("chart-design")["best, Johnson"]
        self.assert_close(best["x"] * 0.0254, design["optimum_diameter"]["value"], 1e-9, "diameter")
        self.assert_close(best["y"] * PSI, design["peak_pressure"]["value"], 1e-9, "pressure")
        lowest = min(point["y"] for point in self.chart("chart-design")["Johnson's proportions"])
        self.assertGreaterEqual(lowest, best["y"] * (1 - 1e-9))

    def test_marks_the_analysed_angle_on_the_motion(self):
        load = self.summary["load"]
        for name, value, unit in (("hertz_pressure", self.summary["hertz"]["peak_pressure"]["value"], PSI),
                                  ("slip_speed", load["slip_speed"]["value"], 0.0254)):
            (mark,) = self.chart(f"chart-{name}")["analysed"]
            self.assert_close(mark["x"], math.degrees(load["driver_angle"]["value"]), 1e-9, "angle")
            self.assert_close(mark["y"] * unit, value, 1e-3, name)  # straight between points half a degree apart

    def test_draws_the_maximum_hertz_pressure(self):
        kinematics = json.loads((self.results / "kinematics.json").read_text())
        drawn = max(point["y"] for point in self.chart("chart-hertz_pressure")["Hertz pressure"])
        self.assert_close(drawn * PSI, kinematics["peak_hertz_pressure"]["value"], 1e-3, "pressure")


class SweepReport(ReportTest):
    """The report of estimates and of motions for several diameters and speeds."""

    case_name = "indexing-table"
    command = "kinematics"

    def test_draws_limits(self):
        for command, quantity in (("kinematics", "maximum Hertz pressure"), ("estimate", "peak contact pressure"),
                                  ("design", "peak contact pressure, wheel of the case")):
            with self.subTest(command):
                output = self.case / f"sweep-{command}"
                run = self.geneva("sweep", self.case, "--with", command, "--set", "Mechanism/Driver speed = 100 rpm .. 200 rpm, 3",
                                  "-o", output)
                self.assertEqual(run.code, 0, run.describe())
                page = (output / "report.html").read_text()
                charts = json.loads(re.search(r'id="charts">\s*(.*?)\s*</script>', page).group(1))
                (chart,) = [chart for chart in charts if chart["y"]["label"] == quantity + " [MPa]"]
                (allowed,) = [one["points"] for one in chart["series"] if one["name"] == "allowed"]
                self.assertAlmostEqual(allowed[0][1], 554, 6, "pitting of the wheel's C45, the least of all limits")

    def test_draws_a_limit_for_each_material_and_no_curve_of_what_stays(self):
        output = self.case / "sweep-materials"
        run = self.geneva("sweep", self.case, "--with", "estimate", "--set", "Mechanism/Wheel material/Material = C45 normalised; POM-C",
                          "--set", "Mechanism/Pin diameter = 8 mm .. 14 mm, 4", "-o", output)
        self.assertEqual(run.code, 0, run.describe())
        page = (output / "report.html").read_text()
        charts = json.loads(re.search(r'id="charts">\s*(.*?)\s*</script>', page).group(1))
        (pressure,) = [chart for chart in charts if chart["y"]["label"] == "peak contact pressure [MPa]"]
        limits = [series for series in pressure["series"] if series["name"].endswith("allowed")]
        self.assertEqual(len(limits), 2)
        for series in limits:
            self.assertEqual(len({y for _, y in series["points"]}), 1, "a limit does not jump")
        for chart in charts:
            values = [y for series in chart["series"] for _, y in series["points"]]
            self.assertGreater(max(values) - min(values), 1e-7 * max(map(abs, values)), chart["y"]["label"])
        self.assertIn("greatest safety factor", page)

    @classmethod
    def prepare(cls, runner):
        run = runner.geneva("sweep", cls.case, "--with", "kinematics", "--set", "Mechanism/Pin diameter = 8 mm .. 14 mm, 3", "--set",
                            "Mechanism/Driver speed = 100 rpm; 200 rpm", "-o", cls.case / "sweep")
        runner.assertEqual(run.code, 0, run.describe())
        cls.results = cls.case / "sweep"

    def test_is_a_sound_page(self):
        self.check_page()

    def test_shows_every_figure_of_every_point(self):
        points = json.loads((self.results / "sweep.json").read_text())["points"]
        shown = self.browser.run("return [...document.querySelectorAll('#points thead th')].map((h) => h.textContent)")
        for figure in points[0]["figures"]:
            if not figure["quantity"].startswith("safety factor: "):
                self.assertTrue(any(heading.split(" [")[0] == figure["quantity"] for heading in shown), figure["quantity"])

    def test_tells_the_curves_apart(self):
        colours = self.browser.run(
            "return Object.values(genevaCharts).map((c) => c.data.datasets.map((d) => d.borderColor))")
        for of_chart in colours:
            self.assertEqual(len(set(of_chart)), len(of_chart))


class Reporting(CliTest):
    """`geneva report` without a browser."""

    def results_of(self, name="johnson-optimum-wheel", **changes):
        case = self.copy_case(name)
        if changes:
            change_case(case, changes)
        self.run_case(case)
        return case / "results"

    def test_escapes_the_title(self):
        results = self.results_of(Title="<script>alert(1)</script> & \"quotes\"")
        text = (results / "report.html").read_text()
        self.assertNotIn("<script>alert", text)
        self.assertIn("&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;quotes&quot;", text)

    def test_does_without_the_packages_and_says_so(self):
        results = self.results_of()
        os.environ["GENEVA_JAVASCRIPT"] = str(self.directory)
        self.addCleanup(os.environ.pop, "GENEVA_JAVASCRIPT")
        run = self.geneva("report", results)
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("libjs-chart.js", run.err)
        outline = read_report(results / "report.html")
        self.assertIn("libjs-chart.js", outline.text)
        self.assertIn(peak_in_psi(read_summary(results)), outline.text)

    LIMITS = """
subsection Allowable
  set Contact pressure          = 80000 psi
  set Pressure times slip speed = 1e6 psi.in/s
end
"""

    def test_tells_safety_factors(self):
        case = self.copy_case("johnson-optimum-wheel")
        text = (case / "case.prm").read_text() + self.LIMITS
        (case / "case.prm").write_text(set_parameter(text, "Mechanism/Pin material/Yield strength", "30 ksi"))
        run = self.geneva("run", case)
        self.assertEqual(run.code, 0, run.describe())
        summary = read_summary(case / "results")
        self.assertIn("peak contact pressure: 73303 of 80000 psi allowed, safety factor 1.09 at -9.9336 deg "
                      f"(as analysed at -11.464 deg: {plain(peak_in_psi(summary))}, 1.1)", run.out)
        rows = {row["quantity"]: row for row in summary["safety"]}
        self.assertEqual(set(rows), {"peak contact pressure", "peak contact pressure times slip speed",
                                     "contact, first yield, pin", "contact, shakedown, pin",
                                     "maximum von Mises stress of the pin",
                                     "von Mises stress at the pin's root (beam theory)"})
        outline = read_report(case / "results" / "report.html")
        self.assertIn("EXCEEDED", outline.text)
        self.assertIn("Pin material/Yield strength", outline.text)
        self.assertIn("30 ksi", outline.text)
        pressure = summary["contact"]["peak_pressure"]["value"]
        hertz = rows["peak contact pressure"]
        self.assert_close(hertz["computed"]["value"], pressure, 1e-12, "computed")
        self.assert_close(hertz["computed_factor"], 80000 * PSI / pressure, 1e-12, "factor as analysed")
        wear = rows["peak contact pressure times slip speed"]
        self.assert_close(wear["computed"]["value"], pressure * abs(summary["load"]["slip_speed"]["value"]), 1e-12, "p v")
        # judged where they are least: the other command's figures of the cycle
        self.assertEqual(self.geneva("kinematics", case).code, 0)
        cycle = json.loads((case / "results" / "kinematics.json").read_text())
        for row, key, allowed in ((hertz, "peak_hertz_pressure", 80000 * PSI),
                                  (wear, "peak_pressure_times_slip", 1e6 * PSI * 0.0254)):
            maximum, angle = cycle[key]["value"], cycle[f"{key}_angle"]["value"]
            self.assert_close(row["cycle"]["value"], maximum, 1e-12, key)
            self.assert_close(row["factor"], allowed / maximum, 1e-12, key)
            self.assert_close(row["driver_angle"]["value"], angle, 1e-12, key)
            self.assertLess(row["factor"], row["computed_factor"])
        for row in cycle["safety"]:  # the same limits, judged by the closed forms alone
            self.assert_close(row["factor"], row["allowed"]["value"] / rows[row["quantity"]]["cycle"]["value"], 1e-12, row["quantity"])
            self.assert_close(row["allowed"]["value"], rows[row["quantity"]]["allowed"]["value"], 1e-12, row["quantity"])
        pin = rows["maximum von Mises stress of the pin"]
        self.assertGreater(pin["cycle"]["value"], pin["computed"]["value"], "with the root of the force")
        self.assertLess(pin["factor"], pin["computed_factor"])
        self.assert_close(pin["computed"]["value"], summary["bodies"]["pin"]["max_von_mises"]["value"], 1e-12, "stress")
        self.assertLess(pin["factor"], 1)
        report = read_report(case / "results" / "report.html").text
        self.assertIn("✗ exceeded", report)
        self.assertIn("✓ allowed", report)

    def test_a_result_of_unknown_error_gets_no_verdict(self):
        case = self.copy_case("johnson-optimum-wheel")
        change_case(case, {"Maximum refinement levels": "0"})
        (case / "case.prm").write_text((case / "case.prm").read_text() + self.LIMITS)
        self.assertEqual(self.geneva("run", case).code, 2)
        self.assertGreaterEqual(read_summary(case / "results")["accuracy"]["error_estimate"], 1.)
        text = read_report(case / "results" / "report.html").text
        self.assertIn("(error not known)", text)
        self.assertRegex(text, r"least safety factor\s+not judged")
        self.assertNotIn("EXCEEDED", text)
        self.assertNotIn("✓ allowed", text)

    def test_a_pair_that_passes_where_it_is_analysed_may_fail_elsewhere(self):
        """At the maximum acceleration pressure x slip is 1.91e6 psi in/s, at -22.8 deg of the driver 4.47e6."""
        case = self.copy_case("johnson-optimum-wheel")
        text = (case / "case.prm").read_text() + self.LIMITS.replace("1e6", "3e6")
        (case / "case.prm").write_text(text)
        run = self.geneva("run", case)
        self.assertEqual(run.code, 0, run.describe())
        wear = read_summary(case / "results")["safety"][1]
        self.assertGreater(wear["computed_factor"], 1)
        self.assertLess(wear["factor"], 1)
        self.assertAlmostEqual(math.degrees(wear["driver_angle"]["value"]), -22.826, 3)
        report = read_report(case / "results" / "report.html").text
        self.assertIn("✗ exceeded", report)
        self.assertIn("-22.8", report)

    def test_the_greater_of_analysis_and_cycle_decides(self):
        """At the maximum pin force the computed pressure and Hertz's of the whole cycle differ by 0.02 % only."""
        case = self.copy_case("johnson-optimum-wheel")
        (case / "case.prm").write_text((case / "case.prm").read_text() + self.LIMITS)
        change_case(case, {"Mechanism/Driver angle": "at maximum pin force"})
        self.run_case(case)
        row = read_summary(case / "results")["safety"][0]
        computed, cycle = row["computed"]["value"], row["cycle"]["value"]
        self.assertAlmostEqual(computed / cycle, 1., delta=0.005)
        allowed = computed * row["computed_factor"]
        self.assert_close(row["factor"], allowed / max(computed, cycle), 1e-12, "factor")

    def test_a_roller_is_judged_in_its_bore(self):
        case = self.copy_case("johnson-optimum-wheel")
        (case / "case.prm").write_text((case / "case.prm").read_text() + self.LIMITS)
        change_case(case, {"Mechanism/Pin type": "roller", "Mechanism/Roller bore diameter": "0.3 in"})
        self.run_case(case)
        summary = read_summary(case / "results")
        load, row = summary["load"], summary["safety"][1]
        self.assertEqual(row["quantity"], "mean bore pressure times sliding speed")
        self.assertEqual((load["pin_type"], load["slip_speed"]["value"]), ("roller", 0))
        mean = load["force"]["value"] / (0.3 * 0.6795 * 0.0254**2)
        self.assert_close(row["computed"]["value"], mean * load["bore_speed"]["value"], 1e-9, "in the bore")
        self.assertGreater(row["cycle"]["value"], row["computed"]["value"])
        self.geneva("kinematics", case)
        self.assertIn("sliding speed of the roller on its stud", (case / "results" / "report.html").read_text())

    def test_says_that_an_impact_is_not_in_the_safety_factors(self):
        case = self.copy_case("four-bar-geneva")
        (case / "case.prm").write_text((case / "case.prm").read_text() + self.LIMITS)
        change_case(case, {"Mechanism/Centre distance": "240 mm"})
        self.assertIn("the wheel's speed jumps", " ".join(self.run_case(case)["notices"]))

    def test_refuses_a_slip_speed_where_nothing_moves(self):
        case = self.copy_case("hertz-line-contact")
        (case / "case.prm").write_text((case / "case.prm").read_text() + self.LIMITS)
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("Pressure times slip speed", run.err)
        self.assertIn("Model = mechanism", run.err)

    def test_compares_runs_in_the_units_of_the_first(self):
        inches = self.results_of("johnson-optimum-wheel")
        case = self.copy_case("johnson-optimum-wheel", "metric")
        change_case(case, {"Output units": "mm-N"})
        self.run_case(case)
        run = self.geneva("report", inches, case / "results", "-o", "both.html")
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("comparison in both.html", run.out)
        self.assertEqual(complaints(self.directory / "both.html"), "")
        page = read_report(self.directory / "both.html")
        self.assertEqual(page.open, [])
        self.assertEqual(len(page.ids), len(set(page.ids)))
        self.assertEqual(page.text.count(peak_in_psi(read_summary(inches))), 4)
        self.assertNotIn("[MPa]", page.text)
        for words in ("Runs of ", "Cases johnson-optimum-wheel", "peak contact pressure"):
            self.assertIn(words, page.text)
        pictures = [base64.b64decode(data).decode() for data in
                    re.findall(r'src="data:image/svg\+xml;base64,([^"]*)"', (self.directory / "both.html").read_text())]
        ticks = [[float(x) for x in re.findall(r'<path stroke="#1b2126" d="M([\d.]+) 560.0v6"', picture)] for picture in pictures]
        labels = [[float(x) for x in re.findall(r'y="588.0" text-anchor="middle">([^<]*)<', picture)] for picture in pictures]
        per_length = [(x[-1] - x[0]) / (at[-1] - at[0]) for x, at in zip(ticks, labels, strict=True)]
        self.assert_close(per_length[1] * 25.4, per_length[0], 1e-2, "pixels per inch")
        charts = re.search(r'id="charts">\s*(.*?)\s*</script>', (self.directory / "both.html").read_text()).group(1)
        (pressure,) = [chart for chart in json.loads(charts) if chart["id"] == "chart-pressure"]
        self.assertEqual([series["name"] for series in pressure["series"]], ["johnson-optimum-wheel", "metric"])
        first, second = ([y for _, y in series["points"]] for series in pressure["series"])
        for one, other in zip(first, second, strict=True):
            self.assertAlmostEqual(one, other, delta=1e-4)

    def test_says_once_what_is_said_of_several_runs_with_other_numbers(self):
        heavier = self.copy_case("johnson-optimum-wheel", "heavier")
        text = (heavier / "case.prm").read_text()
        (heavier / "case.prm").write_text(text.replace("Friction moment = 2 lbf.in", "Friction moment = 3 lbf.in"))
        self.run_case(heavier)
        self.assertEqual(self.geneva("report", self.results_of("johnson-optimum-wheel"), heavier / "results",
                                     "-o", "both.html").code, 0)
        page = (self.directory / "both.html").read_text()
        self.assertEqual(page.count("the pin force is greatest at"), 1)
        self.assertRegex(page, "<strong>heavier:</strong> the same with -[0-9.]+ for -9.93361<")

    def test_motion_and_estimate_tell_the_nearest_limit_first(self):
        case = self.copy_case("johnson-optimum-wheel")
        (case / "case.prm").write_text((case / "case.prm").read_text() + self.LIMITS)
        for command in ("kinematics", "estimate"):
            with self.subTest(command):
                self.assertEqual(self.geneva(command, case, "-o", self.directory / command).code, 0)
                (document,) = (self.directory / command).glob(f"{command}.json")
                safety = json.loads(document.read_text())["safety"]
                least = min(row["factor"] for row in safety)
                self.assertEqual([row["quantity"] for row in safety][0], "peak contact pressure")
                page = (self.directory / command / "report.html").read_text()
                first = page[:page.index("<table>")]
                self.assertIn(f"least safety factor</span> <strong>{least:.3g}</strong>", first)
                self.assertEqual("EXCEEDED" in first, least < 1)

    def test_has_a_title_block(self):
        case = self.copy_case("johnson-optimum-wheel", "filed")
        change_case(case, {"Accuracy": "5 %\nset Project = press <line> 4\nset Author = A. Designer"})
        self.run_case(case)
        page = read_report(case / "results" / "report.html")
        for words in ("Project press <line> 4", "Author A. Designer", "Case filed", "Units in-lbf"):
            self.assertIn(words, page.text, words)
        self.assertEqual(self.geneva("kinematics", case, "--output", "motion").code, 0)
        self.assertIn("Author A. Designer", read_report(self.directory / "motion" / "report.html").text)

    def test_refuses_to_compare_what_is_no_run(self):
        results = self.results_of()
        case = self.copy_case("six-station-360rpm")
        self.assertEqual(self.geneva("kinematics", case).code, 0)
        self.assert_refused([results, case / "results"], "holds no run", "geneva run")
        self.assertFalse((self.directory / "comparison.html").exists())

    def assert_refused(self, results, *words):
        run = self.geneva("report", *(results if isinstance(results, list) else [results]))
        self.assertEqual(run.code, 1, run.describe())
        for word in words:
            self.assertIn(word, run.err)

    def test_refuses_a_directory_without_results(self):
        self.assert_refused(self.directory / "nowhere", "no such directory")
        self.assert_refused(self.directory, "no results", "geneva run")

    def test_refuses_incomplete_and_foreign_results(self):
        results = self.results_of()
        kept = self.directory / "kept"
        shutil.copytree(results, kept)
        (results / "depth.csv").unlink()
        self.assert_refused(results, "depth.csv is missing", "geneva run")
        summary = json.loads((kept / "summary.json").read_text())
        del summary["versions"]["results"]
        (results / "summary.json").write_text(json.dumps(summary))
        self.assert_refused(results, "format 0", "make them again")
        (results / "summary.json").write_text("{ half")
        self.assert_refused(results, "summary.json", "damaged")
        self.assertEqual(read_summary(kept)["versions"]["results"], 5)

    def test_refuses_documents_that_lack_something(self):
        results = self.results_of()
        whole = json.loads((results / "summary.json").read_text())
        for key in ("case", "comparison", "solver"):
            (results / "summary.json").write_text(json.dumps({k: v for k, v in whole.items() if k != key}))
            self.assert_refused(results, "an earlier geneva wrote them; make them again")
            self.assert_refused([results, results], "an earlier geneva wrote them")
        (results / "summary.json").write_text(json.dumps(whole))
        view = json.loads((results / "view.json").read_text())
        view["meshes"][0]["points"] = ""
        (results / "view.json").write_text(json.dumps(view))
        self.assert_refused(results, "damaged")


if __name__ == "__main__":
    main()
