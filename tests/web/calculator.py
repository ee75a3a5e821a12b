#!/usr/bin/env python3
"""The page that computes in the browser: the same figures, sentences and cases as the program's."""

import json
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import unittest
import urllib.parse

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from browser import Browser  # noqa: E402
from geneva_cli import CliTest, main, number  # noqa: E402

SKIPPED = 77  # tests/web/CMakeLists.txt
SAME = 1e-12
# Places of flat maxima are looked for to about 1e-10 of an engagement (loads/motion/pin_load.h).
SAME_PLACE = 1e-10

KINDS = ("external", "internal", "spherical", "long dwell")
CASES_OF_A_KIND = 6
MATERIALS = ("100Cr6 hardened", "EN-GJS-600-3", "PEEK", "CuSn12-C centrifugally cast")

# What a length in mm, a moment of inertia in kg.mm^2, a moment in N.mm and a modulus in MPa are in the other system.
INCH_POUND = {"mm": ("in", 1 / 25.4), "kg.mm^2": ("lbf.s^2.in", 8.85e-9 * 1e3), "N.mm": ("lbf.in", 8.85e-3),
              "MPa": ("psi", 145.0), "kg/m^3": ("lb/in^3", 3.61e-5)}


def build(source):
    """Builds the page, which takes no time if nothing has changed."""
    if not shutil.which("em++"):
        print("web.calculator: skipped, since Emscripten is missing; scripts/setup installs it")
        sys.exit(SKIPPED)
    subprocess.run([source / "scripts" / "calculator"], check=True, stdout=subprocess.DEVNULL)


def link_of(inputs):
    return "#" + "&".join(f"{key}={urllib.parse.quote(value)}" for key, value in inputs.items())


def drawn_inputs(kind, index):
    """Random inputs of a kind, the same for the same index."""
    draw = random.Random(f"{kind} {index}")
    in_inches = draw.random() < 0.3

    def quantity(low, high, unit):
        name, factor = INCH_POUND[unit] if in_inches else (unit, 1.0)
        digits = draw.choice((3, 6, 15))
        return f"{draw.uniform(low, high) * factor:.{digits}g} {name}"

    inputs = {"units": "in-lbf" if in_inches else "mm-N", "type": kind, "stations": str(draw.randint(3, 14)),
              "driver_speed": f"{draw.uniform(10, 900):.4g} rpm", "load_inertia": quantity(0, 20000, "kg.mm^2"),
              "friction_moment": quantity(0, 5000, "N.mm")}
    if kind in ("external", "internal"):
        inputs["centre_distance"] = quantity(30, 300, "mm")
        inputs["slot_clearance"] = quantity(0, 0.2, "mm")
    if kind == "spherical":
        inputs["sphere_radius"] = quantity(30, 200, "mm")
        inputs["shaft_angle"] = f"{draw.uniform(20, 160):.5g} deg"
    if kind == "long dwell":
        inputs["crank_radius"] = quantity(20, 100, "mm")
        inputs["sprocket_spacing"] = quantity(0, 300, "mm")
        inputs["sprocket_line"] = draw.choice(("along line of centres", "across line of centres"))
    if kind in ("spherical", "long dwell"):
        inputs["wheel_inertia"] = quantity(100, 5000, "kg.mm^2")
    if draw.random() < 0.5:
        inputs["pin_diameter"] = quantity(4, 9, "mm")
        inputs["thickness"] = quantity(4, 20, "mm")
    if draw.random() < 0.5:
        inputs["slot_friction"] = f"{draw.uniform(0, 0.2):.3g}"
    if draw.random() < 0.2:
        inputs["pins"] = "2"
    for body in ("pin", "wheel"):
        if draw.random() < 0.6:
            inputs[f"{body}_material"] = draw.choice(MATERIALS)
            continue
        inputs[f"{body}_material"] = "own values"
        inputs[f"{body}_youngs_modulus"] = quantity(3000, 230000, "MPa")
        inputs[f"{body}_poissons_ratio"] = f"{draw.uniform(0, 0.45):.4g}"
    if inputs["wheel_material"] == "own values":
        inputs["wheel_density"] = quantity(1000, 9000, "kg/m^3")
    return inputs


class PageTest(CliTest):
    """One browser with the page for all tests of a class."""

    width = 1280

    @classmethod
    def setUpClass(cls):
        cls.page = cls.source / "build" / "site" / "calculator.html"
        cls.browser = Browser(cls.width, 900).__enter__()
        cls.addClassCleanup(cls.browser.__exit__)

    def open(self, inputs=None):
        """Opens the page anew, with inputs in its link."""
        self.browser._call("POST", "/url", {"url": "about:blank"})
        self.browser.open(str(self.page) + (link_of(inputs) if inputs else ""))
        self.assertTrue(self.browser.wait_for("return document.body && document.body.dataset.ready"))

    def updated(self, script, *arguments):
        """Runs a script that changes the inputs and waits until the page has answered."""
        before = self.browser.run("return document.body.dataset.ready")
        self.browser.run(script, *arguments)
        self.assertTrue(self.browser.wait_for(f"return document.body.dataset.ready !== '{before}'"))

    def go(self, inputs):
        """Other inputs by their link, in the page that is open."""
        self.follow(link_of(inputs))

    def follow(self, link):
        """As the browser does where a link of this page is clicked, but at once."""
        self.updated("const newURL = location.href.split('#')[0] + arguments[0];"
                     "window.dispatchEvent(new HashChangeEvent('hashchange', { newURL }))", link)

    def type(self, key, text):
        self.updated("const box = document.getElementById('input-' + arguments[0]); box.value = arguments[1];"
                     "box.dispatchEvent(new Event('input', { bubbles: true }));", key, text)

    def refusal(self):
        return self.browser.run("const box = document.getElementById('refused'); return box.hidden ? '' : box.innerText")

    def answer(self):
        return self.browser.run("return genevaCalculator.answer()")

    def case(self, name="case"):
        """Writes the case file that the page offers."""
        directory = self.directory / name
        directory.mkdir(exist_ok=True)
        (directory / "case.prm").write_text(self.browser.run("return document.getElementById('case-text').value"))
        return directory

    def document(self, command, case):
        """What a command writes in full precision."""
        results = self.directory / command
        run = self.geneva(command, case, "-o", results)
        self.assertEqual(run.code, 0, run.describe())
        return json.loads((results / f"{command}.json").read_text()), results

    def assert_same(self, found, expected, what, tolerance=SAME, size=None):
        if found is None or expected is None:
            self.assertIs(found, expected, what)
            return
        self.assertLessEqual(abs(found - expected), tolerance * (abs(expected) if size is None else size),
                             f"{what}: {found!r} instead of {expected!r}")


class Figures(PageTest):
    """Beside those of the program for the case that the page itself offers."""

    def test_equal_those_of_the_program(self):
        self.open()
        answered = dict.fromkeys(KINDS, 0)
        for kind in KINDS:
            for index in range(CASES_OF_A_KIND):
                with self.subTest(kind=kind, index=index):
                    self.go(drawn_inputs(kind, index))
                    answered[kind] += self.check_case(self.case())
        self.assertGreaterEqual(min(answered.values()), CASES_OF_A_KIND / 3, answered)

    def check_case(self, case):
        """Compares all figures; of a case that is refused the sentences."""
        refused = self.refusal()
        if refused:
            run = self.geneva("kinematics", case)
            self.assertEqual(run.code, 1, refused + run.describe())
            self.assertIn(refused, one_line(run.err))
            return 0
        answer = self.answer()
        kinematics, results = self.document("kinematics", case)
        self.check_kinematics(answer["kinematics"], kinematics)
        self.check_drawing(answer["drawing"], json.loads((results / "mechanism.json").read_text()))
        self.check_hertz(answer, self.document("estimate", case)[0])
        if "refused" in answer["design"]:
            run = self.geneva("design", case)
            self.assertEqual(run.code, 1, run.describe())
            self.assertIn(answer["design"]["refused"].split("equations are ")[-1], one_line(run.err))
        else:
            self.check_design(answer["design"], self.document("design", case)[0])
        return 1

    def check_kinematics(self, found, document):
        self.assertEqual(len(found["dwell_time"]), len(document["dwell_time"]))
        for mine, its in zip(found["dwell_time"], document["dwell_time"]):
            self.assert_same(mine, number(its), "dwell_time")
        compared = 0
        for key, value in found.items():
            if key not in document or key in ("dwell_time", "unbounded"):
                continue
            compared += 1
            if key.endswith("tangency"):  # of 0 but for roundings
                self.assert_same(value, number(document[key]), key, SAME, size=1.0)
            elif key.endswith("_angle"):
                self.assert_same(value, number(document[key]), key, SAME_PLACE, size=1.0)
            else:
                self.assert_same(value, number(document[key]), key)
        self.assertGreaterEqual(compared, 16)
        self.assertEqual([one["cause"] for one in found["unbounded"]], [one["cause"] for one in document["unbounded"]])

    def check_drawing(self, drawing, document):
        """All positions of the mechanism, with its motion and force, and its lines."""
        for key in ("wheel", "pin_path"):
            found, expected = flat(drawing[key]), flat(document[key])
            self.assertEqual(len(found), len(expected), key)
            size = max(map(abs, expected))
            for mine, its in zip(found, expected):
                self.assert_same(mine, its, key, SAME, size)
        self.assertEqual(len(drawing["steps"]), len(document["steps"]))
        for key in ("time", "driver_angle", "wheel_angle", "wheel_speed", "wheel_acceleration", "pin_force"):
            size = max(abs(step[key]) for step in document["steps"])
            for mine, its in zip(drawing["steps"], document["steps"]):
                self.assert_same(mine[key], its[key], key, SAME, size)
                self.assertEqual(mine["engaged_pin"], its["engaged_pin"])

    def check_hertz(self, answer, estimate):
        hertz = answer["hertz"]
        rows = {row["quantity"]: number(row["value"]) for row in estimate["estimate"]}
        # The program's is at the greatest force on the driving wall; all but the force go with its root.
        ratio = hertz["force"] / rows["pin force"]
        if answer["kinematics"]["peak_braking_force"] <= answer["kinematics"]["peak_force"]:
            self.assert_same(ratio, 1.0, "pin force")
        for key, quantity in (("peak_pressure", "peak contact pressure"), ("half_width", "half-width")):
            self.assert_same(hertz[key], rows[quantity] * math.sqrt(ratio), quantity, 2 * SAME)
        # The program's maximum shear is that of the held pin, greater than Hertz's in the half-plane.
        golden = (math.sqrt(5) - 1) / 2
        self.assert_same(hertz["max_shear"], golden**2.5 * hertz["peak_pressure"], "maximum shear", 2 * SAME)
        self.assert_same(hertz["max_shear_depth"], golden**0.5 * hertz["half_width"], "its depth", 2 * SAME)
        self.assertLess(hertz["max_shear"], rows["maximum shear"] * math.sqrt(ratio) * (1 + 2 * SAME))
        self.assert_same(hertz["peak_pressure"], answer["kinematics"]["peak_hertz_pressure"], "pressure of the cycle")

    def check_design(self, found, document):
        renamed = {"diameter": "optimum_diameter", "inertia": "optimum_inertia"}
        for key in ("diameter", "inertia", "pin_diameter", "thickness", "locking_radius", "force", "peak_pressure"):
            its = renamed.get(key, key)
            self.assert_same(found["drawn"][key], number(document["geometry"][its]), f"drawn {key}")
            self.assert_same(found["own"][key], number(document["wheel"][key]), f"own {key}")
            if its in document:
                self.assert_same(found["johnson"][key], number(document[its]), f"Johnson's {key}")
            elif key == "diameter":
                self.assertIsNone(found["johnson"])

    def test_are_shown_in_either_system_of_units_as_the_program_prints_them(self):
        for system in ("mm-N", "in-lbf"):
            self.open({"units": system, "type": "external", "stations": "5", "centre_distance": "3.21 in"})
            printed = self.geneva("kinematics", self.case()).out
            shown = self.browser.run("return Object.fromEntries([...document.querySelectorAll('#figure-rows tr')].filter("
                                     "(row) => row.cells.length > 2).map((row) => [row.cells[0].innerText, "
                                     "[row.cells[2].innerText, row.cells[3].innerText]]))")
            for mine, its in (("maximum pin force, driving wall", "maximum pin force"), ("maximum Hertz pressure", "maximum Hertz pressure"),
                              ("maximum pressure × sliding speed", "maximum pressure x slip"), ("index time", "motion time"), ("dwell", "dwell time")):
                heading, (value, place) = next(entry for entry in shown.items() if entry[0].split(" [")[0] == mine)
                unit = heading.split("[")[1].rstrip("]")
                line = re.search(rf"^{re.escape(its)} \[(.+)\] +(\S+)(?:  at (\S+))?", printed, re.M)
                self.assertEqual(unit, line.group(1))
                self.assert_same(plain(value), float(line.group(2)), mine, 6e-5)  # five digits
                if line.group(3):
                    self.assert_same(plain(place.split()[0]), float(line.group(3)), f"place of {mine}", 6e-5)

    def test_a_run_of_the_case_has_the_same_force(self):
        self.open({"type": "external", "stations": "5", "centre_distance": "80 mm", "slot_friction": "0.1"})
        hertz = self.answer()["hertz"]
        force = self.answer()["kinematics"]["peak_force"]
        summary = self.run_case(self.case())
        self.assert_same(number(summary["load"]["force"]), force, "pin force")
        self.assertGreater(hertz["force"], 0)


class Sentences(PageTest):
    """What cannot be is said as the program says it, and leaves the last picture."""

    IMPOSSIBLE = (
        {"type": "external", "stations": "2"}, {"type": "external", "stations": "25"},
        {"type": "external", "centre_distance": "0 mm"}, {"type": "external", "centre_distance": "-70 mm"},
        {"type": "external", "pin_diameter": "60 mm"}, {"type": "internal", "pin_diameter": "80 mm"},
        {"type": "external", "pins": "4"}, {"type": "external", "slot_friction": "7"},
        {"type": "spherical", "shaft_angle": "180 deg"}, {"type": "spherical", "shaft_angle": "0 deg"},
        {"type": "long dwell", "crank_radius": "0 mm"}, {"type": "external", "slot_clearance": "50 mm"})
    # The program refuses these by the rules of its case file, with the same range in other words.
    REFUSED_BY_RANGE = ({"stations": "2"}, {"stations": "25"}, {"centre_distance": "0 mm"}, {"centre_distance": "-70 mm"},
                        {"shaft_angle": "0 deg"}, {"crank_radius": "0 mm"})

    def test_are_those_of_the_program(self):
        self.open({"type": "external"})
        for inputs in self.IMPOSSIBLE:
            with self.subTest(**inputs):
                self.go({"type": "external"})
                self.assertEqual(self.refusal(), "")
                drawing = self.browser.run("return document.getElementById('mechanism-wheel').getAttribute('d')")
                self.go(inputs)
                sentence = self.refusal()
                self.assertNotEqual(sentence, "")
                run = self.geneva("kinematics", self.case())
                self.assertEqual(run.code, 1, sentence + run.describe())
                if not any(part.items() <= inputs.items() for part in self.REFUSED_BY_RANGE):
                    self.assertIn(sentence, one_line(run.err))
                self.assertTrue(self.browser.run("return document.getElementById('workplace').classList.contains('stale')"))
                self.assertLess(float(self.browser.run("return getComputedStyle(document.getElementById('mechanism')).opacity")), 0.6)
                self.assertEqual(self.browser.run("return document.getElementById('mechanism-wheel').getAttribute('d')"), drawing)

    def test_say_what_is_no_number(self):
        self.open()
        for text, part in (("12,5", "written with a point"), ("abc", "no number"), ("", "a number is wanted"),
                           ("1e999", "too large or too small"), ("70 mm", "without its unit")):
            self.type("centre_distance", text)
            self.assertIn(part, self.refusal())
            self.assertEqual(self.browser.run("return document.getElementById('input-centre_distance').ariaInvalid"), "true")
        self.type("centre_distance", "70")
        self.assertEqual(self.refusal(), "")

    def test_say_what_a_link_has_that_cannot_be_taken(self):
        self.open({"type": "external", "centre_distance": "7 cm", "colour": "red", "stations": "5"})
        self.assertIn("Centre distance as '7 cm': a number and mm or in are wanted", self.refusal())
        self.assertIn("'colour'", self.refusal())
        self.assertFalse(self.browser.run("return document.getElementById('workplace').classList.contains('stale')"))
        self.assertEqual(self.answer()["mechanism"], "external Geneva with 5 stations")

    def test_no_input_whatever_shows_a_number_that_is_none(self):
        self.open()
        keys = self.browser.run("return [...document.querySelectorAll('[data-number]')].map((box) => box.dataset.number)")
        self.assertGreater(len(keys), 15)
        texts = ("0", "-1", "1e-300", "1e300", "3.7")
        seen = set()
        for turn, kind in enumerate(KINDS):
            self.go({"type": kind, "pin_material": "own values", "wheel_material": "own values", "pin_diameter": "8 mm", "thickness": "8 mm"})
            start = self.browser.run("return genevaCalculator.link()")
            for place, key in enumerate(key for key in keys if f"&{key}=" in start):
                # An input that another kind had with every text has one here, another one for each kind.
                for text in texts if key not in seen else [texts[(place + turn) % len(texts)]]:
                    self.follow(re.sub(rf"(&{key}=)[^&+]*", rf"\g<1>{text}", start))
                    self.check_words(f"{kind} {key} {text}")
                seen.add(key)

    def check_words(self, what):
        words = self.browser.run("return document.body.innerText")
        for word in ("NaN", "Infinity", "undefined", "null", "[object"):
            self.assertNotIn(word, words, what)
        self.assertNotIn("fault of its own", self.refusal(), what)
        attributes = self.browser.run("return document.getElementById('drawing').innerHTML")
        self.assertNotIn("NaN", attributes, what)


class Links(PageTest):
    """A case in a link, and what was typed."""

    def test_carry_all_inputs(self):
        for kind in KINDS:
            inputs = drawn_inputs(kind, 1)
            self.open(inputs)
            link, values, text = (self.browser.run(f"return {what}") for what in (
                "genevaCalculator.link()", "genevaCalculator.values()", "document.getElementById('case-text').value"))
            given = {key: " ".join(value) for key, value in urllib.parse.parse_qs(link[1:]).items()}
            self.assertEqual({key: given[key] for key in inputs}, inputs)
            self.assertEqual(self.browser.wait_for("return location.hash === genevaCalculator.link()"), True)
            self.updated("location.hash = arguments[0]", link_of({"type": kind}))
            self.assertNotEqual(self.browser.run("return genevaCalculator.values()"), values)
            self.open(given)
            self.assertEqual(self.browser.run("return genevaCalculator.values()"), values)
            self.assertEqual(self.browser.run("return document.getElementById('case-text').value"), text)

    def test_keep_what_was_typed_exactly(self):
        self.open()
        typed = "70.12345678901234567"
        self.type("centre_distance", typed)
        self.assertIn(f"centre_distance={typed}+mm", self.browser.run("return genevaCalculator.link()"))
        for system, shown in (("in-lbf", "2.76077"), ("mm-N", typed)):
            self.updated("document.querySelector(`[value='${arguments[0]}']`).click()", system)
            self.assertEqual(self.browser.run("return document.getElementById('input-centre_distance').value"), shown)
            self.assertIn(f"set Centre distance = {typed} mm", self.browser.run("return document.getElementById('case-text').value"))
        # beyond the slider
        self.type("centre_distance", "5000")
        self.assertEqual(self.answer()["lengths"]["centre_distance"], 5.0)

    def test_sliders_and_keys_change_the_inputs(self):
        self.open()
        self.browser.run("document.querySelector('[data-slider=stations]').focus()")
        for kind in ("keyDown", "keyUp"):
            self.browser.protocol("Input.dispatchKeyEvent", type=kind, key="ArrowRight", code="ArrowRight", windowsVirtualKeyCode=39)
        self.assertTrue(self.browser.wait_for("return genevaCalculator.values().stations === 7"))
        self.assertEqual(self.browser.run("return document.getElementById('input-stations').value"), "7")
        self.assertTrue(self.browser.wait_for("return genevaCalculator.answer().mechanism.includes('7 stations')"))

    def test_the_drawing_turns_with_its_slider(self):
        self.open()
        angle = "return Number(document.getElementById('mechanism-drawing').dataset.wheelAngle)"
        step = "const slider = document.querySelector('[name=step]'); slider.value = arguments[0]; slider.dispatchEvent(new Event('input', { bubbles: true }));"
        found = []
        for position in (0, 170, 400):
            self.browser.run(step, position)
            found.append(self.browser.run(angle))
        self.assertAlmostEqual(found[2] - found[0], math.pi / 3, 12)
        self.assertGreater(found[1], found[0])
        self.browser.run("document.querySelector('[name=run]').click()")
        self.assertTrue(self.browser.wait_for(f"{angle} !== {found[2]!r}"))
        self.browser.run("document.querySelector('[name=run]').click()")


class Page(PageTest):
    """What holds for the page as a page."""

    def test_opens_from_disk_without_a_network(self):
        self.browser.protocol("Network.enable")
        self.browser.protocol("Network.emulateNetworkConditions", offline=True, latency=0, downloadThroughput=0, uploadThroughput=0)
        self.open()
        self.assertEqual(self.answer()["mechanism"], "external Geneva with 6 stations")
        asked = self.browser.run("return performance.getEntriesByType('resource').map((entry) => entry.name)")
        self.assertEqual([name for name in asked if not name.startswith("data:")], [])
        self.assertEqual(re.findall(r'(?:src|href)\s*=\s*"(?!data:|#)[^"]*"', self.page.read_text()), [])
        self.assertLess(self.page.stat().st_size, 3e6)

    def test_fits_on_a_desk_and_on_a_telephone(self):
        for width in (1280, 390):
            self.browser.resize(width, 900)
            for index, kind in enumerate(KINDS):
                self.open(drawn_inputs(kind, 2 + index))
                for state in ("as it is", "with more", "refused"):
                    if state == "with more":
                        self.browser.run("document.querySelector('details').open = true")
                    if state == "refused":
                        self.type("pin_diameter", "400")
                    self.assertLessEqual(self.browser.run("return document.documentElement.scrollWidth"), width, f"{kind} {state}")
                    cut = self.browser.run("return [...document.querySelectorAll('.scroll, td, th, strong, label, button')].filter((e) => "
                                           "e.scrollWidth > e.clientWidth + 1 && e.clientWidth > 0 && getComputedStyle(e).display !== 'inline').map((e) => e.innerText)")
                    self.assertEqual(cut, [], f"{kind} {state}")
            columns = self.browser.run("return getComputedStyle(document.getElementById('workplace')).gridTemplateColumns.split(' ').length")
            self.assertEqual(columns, 2 if width == 1280 else 1)
        self.browser.resize(1280, 900)

    def test_has_names_for_what_can_be_changed_and_no_complaints(self):
        self.open()
        nameless = self.browser.run("return [...document.querySelectorAll('input, select, textarea, button')].filter((e) => "
                                    "!(e.labels && e.labels.length) && !e.ariaLabel && !e.innerText.trim()).map((e) => e.outerHTML)")
        self.assertEqual(nameless, [])
        self.assertEqual([entry["message"] for entry in self.browser.console()], [])
        tidied = subprocess.run(["tidy", "-errors", "-quiet", "--drop-empty-elements", "no", self.page], capture_output=True, text=True, check=False)
        self.assertEqual(tidied.stderr, "")

    def test_is_legible_by_day_and_night(self):
        for scheme in ("light", "dark"):
            self.browser.colour_scheme(scheme)
            self.open()
            contrasts = self.browser.run(CONTRASTS)
            self.assertGreater(len(contrasts), 10)
            self.assertGreaterEqual(min(contrasts.values()), 4.5, f"{scheme}: {contrasts}")
        self.browser.colour_scheme("light")


# Least contrast of texts and their ground (WCAG 2.1, 1.4.3) by class and element.
CONTRASTS = """
  const light = (colour) => {
    const parts = colour.match(/[\\d.]+/g).slice(0, 3).map((c) => c / 255).map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2];
  };
  const ground = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const colour = getComputedStyle(e).backgroundColor;
      if (!/, 0\\)$/.test(colour)) return colour;
    }
    return 'rgb(255, 255, 255)';
  };
  const found = {};
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!own || element.disabled || element.closest('svg') || !element.getClientRects().length || /SCRIPT|STYLE/.test(element.tagName)) continue;
    const [a, b] = [light(getComputedStyle(element).color), light(ground(element))];
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const name = `${element.tagName}.${element.className}`;
    found[name] = Math.min(found[name] ?? 99, contrast);
  }
  return found;
"""


def one_line(text):
    return " ".join(text.split())


def plain(text):
    return float(text.replace("\u202f", ""))


def flat(entry):
    return [entry] if isinstance(entry, (int, float)) else [value for part in entry for value in flat(part)]


if __name__ == "__main__":
    main(prepare=build)
