"""Pin and wheel in 3-D: closed forms, invariants and refusals on a soft pin and block, which need few unknowns."""

import csv
import json
import math

import geneva_cli
from geneva_cli import CliTest, look_up, number, set_parameter

CASE = """set Model        = mechanism
set Dimension    = {dimension}
set Output units = mm-N
set Accuracy     = {accuracy}
subsection Mechanism
  set Stations        = 4
  set Wheel diameter  = {diameter}
  set Pin diameter    = {pin_diameter}
  set Wheel thickness = {thickness}
  set Driver speed    = {speed}
  set Friction moment = 0.2 N.m
  set Load inertia    = 0.00052 kg.m^2
  set Wheel inertia   = 0.0008 kg.m^2
  set Contact model   = {model}
{more}  subsection Pin material
    set Young's modulus = {modulus}
  end
  subsection Wheel material
    set Young's modulus = {modulus}
  end
{pin}end
"""


YIELD = "\nsubsection Mechanism\n  subsection Pin material\n    set Yield strength = 600 MPa\n  end\nend\n"
ALLOWED = "\nsubsection Allowable\n  set Contact pressure = 900 MPa\nend\n"


class Space(CliTest):

    def write(self, name, pin=(), dimension=3, accuracy="5 %", thickness="17 mm", modulus="1 GPa", diameter="115 mm",
              pin_diameter="17 mm", model="local", more="", speed="600 rpm"):
        lines = "".join(f"    set {line}\n" for line in pin)
        section = f"  subsection Pin\n{lines}  end\n" if pin else ""
        case = self.directory / name
        case.mkdir()
        (case / "case.prm").write_text(CASE.format(
            dimension=dimension, accuracy=accuracy, thickness=thickness, modulus=modulus, diameter=diameter,
            pin_diameter=pin_diameter, model=model, more=more, speed=speed, pin=section))
        return case

    def run_case(self, case, ranks=None):
        run = self.geneva("run", case, ranks=ranks)
        self.assertEqual(run.code, 0, run.describe())
        return json.loads((case / "results" / "summary.json").read_text())

    def sections(self, case):
        with open(case / "results" / "sections.csv", newline="", encoding="utf-8") as stream:
            return [{name: float(value) for name, value in row.items() if name != "pair"}
                    for row in csv.DictReader(stream)]

    def layers(self, case):
        places = [row["z [mm]"] for row in self.sections(case)]
        return [above - below for below, above in zip(places, places[1:])]

    def refused(self, *parts, **given):
        case = self.write(f"bad-{len(list(self.directory.iterdir()))}", **given)
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        for part in ("case.prm", *parts):
            self.assertIn(part, run.err)

    def value(self, summary, key):
        return number(look_up(summary, key))

    def test_a_pin_held_at_its_core_is_nearly_the_plane_model_in_the_middle(self):
        # The ends carry less and the middle 2 to 4 % more, the pressure half of that (p ~ sqrt(w)).
        flush = self.run_case(self.write("flush", ["Held at = core", "Overhang = 0 mm"], accuracy="2 %"))
        plane = self.run_case(self.write("plane", dimension=2))
        ratio = self.value(flush, "contact.mid_length_pressure") / self.value(plane, "contact.peak_pressure")
        self.assertGreater(ratio, 1.)
        self.assertLess(ratio, 1.02)
        self.assertTrue(flush["contact"]["edge"]["bounded"], "both bodies end together")
        self.assertLess(self.value(flush, "line_load.ratio"), 1.)
        self.assertLess(flush["equilibrium"]["force_residual"], 1e-8)
        self.assertNotIn("pin", flush, "nothing bends a pin that is held at its core")

    def test_a_long_flush_contact_is_the_plane_model_in_the_middle(self):
        # Three diameters: the ends carry 29 % less over a length of the order of the diameter.
        flush = self.run_case(self.write("long", ["Held at = core", "Overhang = 0 mm"], accuracy="2 %",
                                         thickness="51 mm"))
        plane = self.run_case(self.write("plane", dimension=2, thickness="51 mm"))
        ratio = self.value(flush, "contact.mid_length_pressure") / self.value(plane, "contact.peak_pressure")
        even = self.value(plane, "contact.force") / 0.051
        load = self.value(flush, "line_load.middle") / even
        self.assertAlmostEqual(load, 1.02, delta=0.01, msg="what the ends do not carry")
        self.assertAlmostEqual(ratio / math.sqrt(load), 1., delta=0.01)

    def test_a_logarithmic_profile_carries_its_design_load_evenly(self):
        case = self.write("logarithmic", ["Held at = core", "Profile = logarithmic", "Profile length = 6 mm",
                                          "Overhang = 4 mm"], accuracy="20 %", modulus="20 GPa", speed="300 rpm",
                          more="  set Pin core radius = 1 mm\n")
        summary = self.run_case(case)
        middle = [row["line_load [N/mm]"] for row in self.sections(case) if abs(row["z [mm]"]) < 0.45 * 6]
        mean = sum(middle) / len(middle)
        self.assertGreater(len(middle), 30)
        self.assertLess(max(abs(load / mean - 1) for load in middle), 0.01, "5 % is what the profile promises")
        self.assertAlmostEqual(mean * 6 / self.value(summary, "contact.force"), 1., delta=0.02)

    def test_a_long_pin_bends_as_timoshenko_s_beam(self):
        # Where the pin is held its cross-section cannot narrow, which makes a shorter one stiffer than the beam.
        pins = {"one": ["Held at = one end", "Overhang = 5 mm", "Root gap = 120 mm", "Crown radius = 150 mm"],
                "both": ["Held at = both ends", "Root gap = 60 mm", "Crown radius = 80 mm"]}
        for name, held in pins.items():
            summary = self.run_case(self.write(name, ["Profile = crown", *held], accuracy="20 %", modulus="100 GPa",
                                               speed="300 rpm"))
            for key in ("tip_deflection", "root_stress"):
                with self.subTest(held=name, key=key):
                    ratio = self.value(summary, f"pin.{key}") / self.value(summary, f"pin.{key}_beam_theory")
                    self.assertAlmostEqual(ratio, 1., delta=0.03)

    def test_line_load_adds_up_to_the_pin_force(self):
        case = self.write("sum", ["Held at = core", "Overhang = 0 mm"])
        summary = self.run_case(case)
        sections = self.sections(case)
        force = sum((b["z [mm]"] - a["z [mm]"]) * (a["line_load [N/mm]"] + b["line_load [N/mm]"]) / 2
                    for a, b in zip(sections, sections[1:]))
        self.assertAlmostEqual(force / self.value(summary, "contact.force"), 1., delta=2e-3)

    def test_layers_become_thinner_towards_the_ends_of_a_line_contact_only(self):
        line = self.write("line", ["Held at = core"], accuracy="3 %")
        crown = self.write("crown", ["Held at = core", "Profile = crown", "Crown radius = 60 mm"], modulus="20 GPa")
        for case in (line, crown):
            self.run_case(case)
        layers = self.layers(line)
        self.assertAlmostEqual(layers[0] / max(layers), 0.5, delta=0.05)
        self.assertAlmostEqual(layers[-1] / max(layers), 0.5, delta=0.05)
        self.assertAlmostEqual(min(self.layers(crown)) / max(self.layers(crown)), 1., delta=1e-6)

    def test_the_peak_at_a_small_rounded_edge_converges(self):
        # The contact climbs 0.04 mm onto the round: with layers as at sharp edges the peak goes up and down.
        case = self.write("rounded", ["Held at = core", "Slot edge = rounded", "Slot edge size = 0.3 mm"],
                          accuracy="15 %", modulus="20 GPa")
        summary = self.run_case(case)
        self.assertTrue(summary["contact"]["edge"]["bounded"])
        self.assertGreater(self.value(summary, "contact.peak_pressure"),
                           2.5 * self.value(summary, "contact.mid_length_pressure"))
        self.assertAlmostEqual(abs(self.value(summary, "contact.peak_pressure_place.z")), 8.2e-3, delta=2e-5,
                               msg="where the round begins")
        self.assertLess(min(self.layers(case)) / max(self.layers(case)), 0.05)

    def test_figures_that_no_mesh_bounds_have_no_number(self):
        case = self.write("sharp", ["Held at = one end", "Root gap = 5 mm"])
        (case / "case.prm").write_text((case / "case.prm").read_text() + ALLOWED)
        summary = self.run_case(case)
        self.assertFalse(summary["contact"]["edge"]["bounded"])
        log = (self.directory / "sharp" / "results" / "log.txt").read_text()
        rows = {row["quantity"]: row for row in summary["comparison"]}
        for name in ("edge pressure", "line load, greater end"):
            with self.subTest(name):
                self.assertIs(rows[name]["bounded"], False)
                self.assertIsNone(rows[name]["computed"])
                self.assertIsNone(rows[name]["error"])
                line = next(line for line in log.splitlines() if line.startswith(name))
                self.assertRegex(line, r"\] +not bounded .* -$")
        for name in ("pressure in the middle", "half-width", "maximum shear, middle", "line load, middle",
                     "pin deflection", "bending stress at the root"):
            with self.subTest(name):
                self.assertGreater(rows[name]["error"], 0)
                self.assertGreater(number(rows[name]["computed"]), 0)
        self.assertNotIn("maximum shear", rows)
        for error in (summary["contact"]["max_shear_error"], summary["line_load"]["end_error"]):
            self.assertIsNone(error)
        for error in (summary["contact"]["mid_length_pressure_error"], summary["line_load"]["middle_error"],
                      summary["pin"]["tip_deflection_error"], summary["pin"]["slope_error"],
                      summary["pin"]["root_stress_error"]):
            self.assertGreater(error, 0)
        report = (self.directory / "sharp" / "results" / "report.html").read_text()
        self.assertIn(">not bounded</td>", report)
        for column in ("as analysed", "maximum in the cycle"):
            self.assertIn(f'<td data-label="{column}">not bounded</td>', report)
        self.assertRegex(report, r'class="answer"><span>edge pressure</span> <strong>not bounded')
        self.assertIn("± ", report)

    def test_a_contact_does_not_open_wholly_before_it_is_solved(self):
        # A hundred nodes are closed at first on the fourth mesh, all in tension after some steps of smoothing.
        case = self.directory / "loose"
        case.mkdir()
        text = (self.source / "cases" / "johnson-optimum-3d" / "case.prm").read_text()
        edge = "  subsection Pin\n    set Slot edge = rounded\n    set Slot edge size = 0.03 in\n"
        (case / "case.prm").write_text("set Maximum unknowns = 21000\n" + text.replace("  subsection Pin\n", edge))
        run = self.geneva("run", case)
        self.assertEqual(run.code, 2, run.describe())
        self.assertIn("Maximum unknowns", run.err)

    def test_a_crowned_pin_touches_in_hertz_s_ellipse(self):
        for radius in (60, 120):
            summary = self.run_case(self.write(f"crown-{radius}", ["Held at = core", "Profile = crown",
                                                                   f"Crown radius = {radius} mm"], modulus="20 GPa"))
            for key in ("peak_pressure", "half_width", "half_length"):
                with self.subTest(radius=radius, key=key):
                    ratio = self.value(summary, f"contact.{key}") / self.value(summary, f"hertz.{key}")
                    self.assertAlmostEqual(ratio, 1., delta=0.02)
            self.assertTrue(summary["contact"]["edge"]["bounded"])
            self.assertLess(summary["equilibrium"]["force_residual"], 1e-9)
            self.assertLess(summary["equilibrium"]["moment_residual"], 1e-6)
        log = (self.directory / "crown-60" / "results" / "log.txt").read_text()
        self.assertIn("the surfaces face each other over 17 mm: their ends carry nothing", log)

    def assert_stress_goes_with_the_pressure_over_the_cycle(self, summary):
        """Not with the root of the force, as a line contact's would."""
        rows = {row["quantity"]: row for row in summary["safety"]}

        def grows(quantity):
            return number(rows[quantity]["cycle"]) / number(rows[quantity]["computed"])

        self.assertGreater(grows("peak contact pressure"), 1.)
        self.assertAlmostEqual(grows("maximum von Mises stress of the pin"), grows("peak contact pressure"), delta=1e-9)

    def test_half_space_and_beam_agree_with_finite_elements_where_the_contact_ends_inside(self):
        for name, pin in {"crowned": ["Crown radius = 3 m"], "tilted": ["Crown radius = 2 m", "Tilt = 0.05 deg"],
                          "held twice": ["Held at = both ends", "Crown radius = 1 m"]}.items():
            with self.subTest(name):
                case = self.write(name.replace(" ", "-"), ["Profile = crown", *pin], modulus="207 GPa")
                with open(case / "case.prm", "a") as file:
                    file.write(ALLOWED + YIELD)
                summary = self.run_case(case)
                self.assert_stress_goes_with_the_pressure_over_the_cycle(summary)
                model = self.value(summary, "pin.half_space_and_beam.peak_pressure")
                error = summary["contact"]["peak_pressure_error"]
                self.assertAlmostEqual(self.value(summary, "contact.peak_pressure") / model, 1., delta=error + 0.005)
                if name == "held twice":  # no beam, half as long again as thick
                    continue
                self.assertAlmostEqual(self.value(summary, "pin.root_stress")
                                       / self.value(summary, "pin.half_space_and_beam.root_stress"), 1.,
                                       delta=0.01 + summary["pin"]["root_stress_error"])
        flush = self.run_case(self.write("flush", ["Held at = one end"], modulus="207 GPa"))
        model = flush["pin"]["half_space_and_beam"]
        self.assertNotIn("peak_pressure", model, "it grows with the sections at a sharp edge")
        # Of finite elements at an accuracy of 5 %.
        self.assertAlmostEqual(self.value(flush, "line_load.middle") / number(model["mid_length_line_load"]), 1.,
                               delta=0.03)
        self.assertTrue(any("those of line contacts along the pin" in notice for notice in flush["notices"]))
        rows = {row["quantity"]: row for row in flush["comparison"]}
        self.assertAlmostEqual(number(rows["line load, middle"]["closed_form"]),
                               number(model["mid_length_line_load"]), delta=1e-6)
        for row in self.sections(self.directory / "flush"):
            if abs(row["z [mm]"]) < 0.4 * 17:
                self.assertAlmostEqual(row["line_load [N/mm]"] / row["line_load_half_space_and_beam [N/mm]"], 1.,
                                       delta=0.05)

    def test_a_hollow_pin_gives_way_more(self):
        """By finite elements as by line contacts: a ring also bends across."""
        peaks = {}
        for bore in ((), ("Bore diameter = 9 mm",)):
            summary = self.run_case(self.write(f"bore-{len(bore)}", ["Profile = crown", "Crown radius = 3 m", *bore],
                                               modulus="207 GPa"))
            error = summary["contact"]["peak_pressure_error"]
            model = self.value(summary, "pin.half_space_and_beam.peak_pressure")
            self.assertAlmostEqual(self.value(summary, "contact.peak_pressure") / model, 1., delta=error + 0.01)
            self.assertAlmostEqual(self.value(summary, "pin.tip_deflection") / self.value(summary, "pin.half_space_and_beam.tip_deflection"),
                                   1., delta=0.03 + summary["pin"]["tip_deflection_error"])
            peaks[len(bore)] = model
        self.assertLess(peaks[1], 0.99 * peaks[0])

    def test_a_bore_that_no_pin_has_is_refused(self):
        for pin, words in (({"pin": ["Bore diameter = 17 mm"]}, "nothing is left of the pin"),
                           ({"pin": ["Bore diameter = 5 mm", "Held at = core"]}, "Pin core radius"),
                           ({"pin": ["Bore diameter = 5 mm"], "more": "  set Pin core radius = 3 mm\n"}, "give one of the two"),
                           ({"pin": ["Bore diameter = 5 mm"], "more": "  set Pin type = roller\n  set Roller bore diameter = 8 mm\n"},
                            "Roller bore diameter")):
            run = self.geneva("run", self.write("refused" + str(len(words)), **pin))
            self.assertEqual(run.code, 1, run.describe())
            self.assertIn(words, run.err)
            self.assertIn("Bore diameter", run.err)

    def test_a_soft_wheel_under_a_stiff_pin_is_solved(self):
        case = self.write("soft", ["Held at = core", "Profile = crown", "Crown radius = 60 mm"], modulus="20 GPa")
        text = (case / "case.prm").read_text()
        (case / "case.prm").write_text(set_parameter(text, "Mechanism/Pin material/Young's modulus", "200000 GPa"))
        summary = self.run_case(case)
        for key in ("peak_pressure", "half_width", "half_length"):
            with self.subTest(key):
                self.assert_close(self.value(summary, f"contact.{key}"), self.value(summary, f"hertz.{key}"), 0.03, key)

    def test_inches_and_metres_and_any_number_of_ranks_give_the_same(self):
        pin = ["Held at = one end", "Profile = crown", "Crown radius = 100 mm", "Tilt = 0.2 deg"]
        metres = self.run_case(self.write("metres", pin, accuracy="20 %"))
        inches = self.run_case(self.write("inches", pin, accuracy="20 %", thickness=f"{17 / 25.4!r} in",
                                          diameter=f"{115 / 25.4!r} in", pin_diameter=f"{17 / 25.4!r} in"))
        others = {"inches": (inches, 1e-9)}
        for ranks in (2, 3, 4):
            case = self.write(f"ranks-{ranks}", pin, accuracy="20 %")
            others[f"{ranks} ranks"] = (self.run_case(case, ranks=ranks), 1e-7)
        for key in ("contact.peak_pressure", "contact.half_width", "pin.tip_deflection", "pin.root_stress"):
            expected = self.value(metres, key)
            for name, (other, tolerance) in others.items():
                with self.subTest(key=key, other=name):
                    self.assertAlmostEqual(self.value(other, key) / expected, 1., delta=tolerance)

    def test_a_pin_held_at_both_ends_is_solved_by_half(self):
        # A tilt of a millionth of a degree is no tilt, but the model is whole then.
        pin = ["Held at = both ends", "Root gap = 10 mm", "Profile = crown", "Crown radius = 300 mm"]
        given = {"accuracy": "20 %", "modulus": "5 GPa"}
        half = self.run_case(self.write("half", pin, **given))
        whole = self.run_case(self.write("whole", [*pin, "Tilt = 1e-6 deg"], **given))
        self.assertLess(half["mesh"]["dofs"], 0.65 * whole["mesh"]["dofs"])
        for key, tolerance in (("contact.force", 1e-6), ("contact.peak_pressure", 0.003), ("contact.half_width", 0.003),
                               ("contact.half_length", 0.003), ("johnson.factor", 0.003),
                               ("pin.tip_deflection", 0.003), ("pin.root_stress", 0.01)):
            with self.subTest(key=key):
                values = [summary["johnson"]["factor"] if key == "johnson.factor" else self.value(summary, key)
                          for summary in (half, whole)]
                self.assertAlmostEqual(values[0] / values[1], 1., delta=tolerance)
        self.assertEqual(half["contact_pairs"][0]["force"], half["contact"]["force"])
        sections = self.sections(self.directory / "half")
        self.assertAlmostEqual(sections[0]["z [mm]"], -sections[-1]["z [mm]"], delta=1e-9)

    def test_design_finds_the_crown_by_which_the_line_load_is_most_even(self):
        pin = ["Held at = one end", "Root gap = 10 mm"]
        given = {"modulus": "2 GPa", "accuracy": "20 %", "thickness": "8 mm"}
        case = self.write("design", pin, **given)
        run = self.geneva("design", "--crown", case)
        self.assertEqual(run.code, 0, run.describe())
        crown = json.loads((case / "results" / "crown.json").read_text())
        size = number(crown["crown"]["size"])
        self.assertAlmostEqual(number(crown["crown"]["drop"]) / (0.004**2 / 2 / size), 1., delta=0.01)
        self.assertLess(crown["after"]["ratio"], 0.75 * crown["before"]["ratio"])
        self.assertGreaterEqual(crown["after"]["ratio"], 1.)
        tried = {number(trial["size"]): trial["ratio"] for trial in crown["search"]}
        self.assertEqual(min(tried, key=tried.get), size)
        self.assertTrue(min(tried) < size < max(tried), "the best lies inside of what was tried")
        crowned = self.run_case(self.write("crowned", [*pin, "Profile = crown", f"Crown radius = {size} m"], **given))
        self.assertAlmostEqual(self.value(crowned, "contact.peak_pressure") /
                               number(crown["finite_elements"]["peak_pressure"]), 1., delta=1e-9)
        quick = self.geneva("design", "--crown", "--no-run", case)
        self.assertEqual(quick.code, 0, quick.describe())
        without = json.loads((case / "results" / "crown.json").read_text())
        self.assertNotIn("finite_elements", without)
        self.assertEqual((without["crown"], without["after"], without["search"]),
                         (crown["crown"], crown["after"], crown["search"]))
        alone = self.geneva("design", "--no-run", case)
        self.assertEqual(alone.code, 1)
        self.assertIn("--no-run: this has an effect with --crown only", alone.err)
        two = self.geneva("design", "--crown", case, case)
        self.assertEqual(two.code, 1)
        self.assertIn("one CASE_DIR is wanted", two.err)
        table = self.write("table", [*pin, "Profile = table", "Profile table = pin.csv"], **given)
        (table / "pin.csv").write_text("z [mm], height [um]\n-20, -50\n0, 0\n20, -50\n")
        no_size = self.geneva("design", "--crown", table)
        self.assertEqual(no_size.code, 1)
        self.assertIn("'Pin/Profile' = 'table'", no_size.err)
        for name, parts in (("johnson-optimum-wheel", ("'Dimension' = '2'", "Dimension = 3")),
                            ("flat-patch-3d", ("'Model' = 'geometry'", "no pin to crown"))):
            refused = self.geneva("design", "--crown", self.source / "cases" / name)
            self.assertEqual(refused.code, 1)
            for part in parts:
                self.assertIn(part, refused.err)

    def test_a_crown_bears_all_tilts_and_loads_that_the_case_allows(self):
        pin = ["Held at = one end", "Root gap = 10 mm"]
        given = {"modulus": "207 GPa", "thickness": "8 mm", "model": "full wheel", "more": "  set Slot clearance = 0.1 mm\n"}
        found = {}
        for name, more in {"level": [], "leaning": ["Tilt tolerance = 0.05 deg"],
                           "heavy": ["Load range = 100 N, 4000 N"]}.items():
            case = self.write(name, [*pin, *more], **given)
            run = self.geneva("design", "--crown", "--no-run", case)
            self.assertEqual(run.code, 0, run.describe())
            found[name] = json.loads((case / "results" / "crown.json").read_text())
        drop = {name: number(crown["crown"]["drop"]) for name, crown in found.items()}
        self.assertGreater(drop["leaning"], 1.5 * drop["level"], "a pin that leans needs more crown")
        self.assertGreater(drop["heavy"], 1.5 * drop["level"], "so does one that bends more")
        leaning = found["leaning"]
        tilt = math.radians(0.05)
        self.assertAlmostEqual(number(leaning["crown"]["least_tilt"]), -tilt, delta=1e-12)
        self.assertAlmostEqual(number(leaning["crown"]["greatest_tilt"]), tilt, delta=1e-12)
        rows = leaning["map"]["by_tilt"]
        self.assertEqual(len(rows), 9)
        worst = [max(row["pressures"][i] for row in rows) for i in range(len(leaning["map"]["sizes"]))]
        sizes = leaning["map"]["sizes"]
        self.assertAlmostEqual(sizes[worst.index(min(worst))], number(leaning["crown"]["size"]), delta=1e-9)
        self.assertEqual(len(found["level"]["map"]["by_tilt"]), 1)
        self.assertEqual(number(found["heavy"]["crown"]["force"]), 4000.)
        for line, part in {"Tilt tolerance = 1 deg": "'Pin/Tilt tolerance'", "Load range = 0 N, 0 N": "no pin force",
                           "Load range = 3 N, 1 N": "least force comes first", "Load range = 3 N": "'Pin/Load range'",
                           "Tilt tolerance = -1 deg": "from 0 to 10 deg"}.items():
            self.refused(part, pin=[line], **given)

    def test_the_search_for_a_crown_does_not_begin_where_its_results_cannot_go(self):
        case = self.write("design", ["Held at = one end", "Root gap = 10 mm"], accuracy="20 %")
        (self.directory / "file").write_text("in the way\n")
        for place in ("file", "file/results"):
            refused = self.geneva("design", "--crown", case, "--output", self.directory / place)
            self.assertEqual(refused.code, 1)
            self.assertIn(f"results directory {self.directory / place}", refused.err)
            self.assertEqual(refused.out, "", "nothing was tried")
        self.assertEqual((self.directory / "file").read_text(), "in the way\n")

    def test_limits_end_the_run_on_the_last_good_mesh(self):
        for name, limit in (("unknowns", "5000"), ("memory", "400 MB"), ("time", "3 s")):
            case = self.write(name, ["Held at = core"], accuracy="0.1 %")
            text = (case / "case.prm").read_text()
            (case / "case.prm").write_text(f"set Maximum {name} = {limit}\n" + text)
            run = self.geneva("run", case)
            self.assertEqual(run.code, 2, run.describe())
            self.assertIn(f"Maximum {name}", run.err)
            summary = json.loads((case / "results" / "summary.json").read_text())
            self.assertLess(summary["mesh"]["dofs"], 200000)
            self.assertGreater(self.value(summary, "contact.peak_pressure"), 0)

    def test_a_pin_that_does_not_fit_is_refused(self):
        self.refused("'Pin/Length'", "ends within the slot", pin=["Length = 15 mm"])
        self.refused("'Pin/Tilt'", "touches the other wall", pin=["Tilt = 0.5 deg"], model="full wheel",
                     more="  set Slot clearance = 0.05 mm\n")
        self.refused("'Pin/Crown radius'", "at least the", pin=["Profile = crown", "Crown radius = 5 mm"])
        self.refused("'Crown radius' is missing", "needs it", pin=["Profile = crown"])
        self.refused("'Pin/Slot edge size'", "half of the wheel's thickness",
                     pin=["Slot edge = rounded", "Slot edge size = 9 mm"])
        self.refused("'Pin/Overhang'", "no free end", pin=["Held at = both ends", "Overhang = 1 mm"])
        self.refused("'Pin/Tilt'", "Dimension = 3 only", dimension=2, pin=["Tilt = 1 deg"])
        self.refused("'Pin/Profile load'", "Profile = logarithmic only", pin=["Profile load = 5 N"])


if __name__ == "__main__":
    geneva_cli.main()
