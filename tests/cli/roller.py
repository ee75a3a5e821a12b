"""Rollers: the contact in their bore, their stud, and what speaks for them beside a fixed pin."""

import json

import geneva_cli
from geneva_cli import CliTest, change_case, look_up, number, read_summary, set_parameter

CASE = """
set Title        = roller on a stud
set Model        = mechanism
set Output units = mm-N
set Accuracy     = 1 %
set Structural accuracy = off
subsection Mechanism
  set Contact model   = local
  set Type            = external
  set Stations        = 6
  set Wheel diameter  = 120 mm
  set Pin diameter    = 14 mm
  set Wheel thickness = 15 mm
  set Driver speed    = 120 rpm
  set Driver angle    = at maximum pin force
  set Load inertia    = 0.1 kg.m^2
  set Friction moment = 4 N.m
  set Pin type              = roller
  set Roller bore diameter  = 6 mm
  set Roller bore clearance = {clearance}
  subsection Stud material
    set Young's modulus = {modulus}
  end
end
"""


class Roller(CliTest):

    def case(self, name="roller", clearance="0.02 mm", modulus="207 GPa", changes=None):
        directory = self.directory / name
        directory.mkdir()
        (directory / "case.prm").write_text(CASE.format(clearance=clearance, modulus=modulus))
        change_case(directory, changes or {})
        return directory

    def solved(self, name="roller", **options):
        return self.run_case(self.case(name, **options))

    def bore(self, summary):
        return next(pair for pair in summary["contact_pairs"] if pair["source"] == "stud")

    def test_needles_carry_the_roller(self):
        needles = {"Mechanism/Roller bore diameter": "10 mm", "Mechanism/Roller bore clearance": "",
                   "Mechanism/Needles": "12", "Mechanism/Needle diameter": "2 mm",
                   "Mechanism/Stud material/Yield strength": "600 MPa"}
        case = self.case(changes=needles)
        summary = self.run_case(case)
        force = look_up(summary, "load.force.value")
        self.assert_close(look_up(summary, "roller.needle_load.value"), 5 * force / 12, 1e-12, "5 F/Z")
        # 1/R = 2/2 mm + 2/6 mm, p0 = sqrt(F E*/(pi R L)), E* = E/(2 (1 - nu^2)), L the wheel's thickness
        line = 5 * force / 12 / 15e-3
        pressure = (line * 207e9 / (2 * 0.91) * (1000 + 1000 / 3) / 3.141592653589793)**0.5
        self.assert_close(look_up(summary, "roller.needle_pressure.value"), pressure, 1e-9, "Hertz")
        self.assertAlmostEqual(look_up(summary, "roller.stud_diameter.value"), 6e-3)
        rows = {row["quantity"]: row for row in summary["safety"]}
        self.assert_close(rows["needle on stud, dents (ISO 76)"]["computed_factor"], 4e9 / pressure, 1e-9, "factor")
        plain = self.case("plain", clearance="", changes={"Mechanism/Roller bore diameter": "6 mm"})
        self.assertEqual(look_up(summary, "pin.root_stress_beam_theory.value"), look_up(self.run_case(plain), "pin.root_stress_beam_theory.value"))
        kinematics = self.geneva("kinematics", case)
        self.assertIn("maximum pressure, needle on stud", kinematics.out)
        known = {row["quantity"]: row for row in json.loads((case / "results" / "kinematics.json").read_text())["safety"]}
        for name in ("needle on stud, dents (ISO 76)", "needle on stud, shakedown, stud"):
            self.assert_close(number(known[name]["allowed"]), number(rows[name]["allowed"]), 1e-9, name)
        self.assert_close(number(rows["needle on stud, shakedown, stud"]["allowed"]), 4 / 3**0.5 * 600e6, 1e-5, "4 k")
        for changes, words in (({"Mechanism/Needles": "13"}, "at most 12 fit"),
                               ({"Mechanism/Needle diameter": ""}, "'Needles' needs it"),
                               ({"Mechanism/Roller bore clearance": "0.02 mm"}, "needles between roller and stud"),
                               ({"Mechanism/Pin type": "fixed"}, "Pin type = roller only")):
            with self.subTest(words):
                wrong = self.geneva("kinematics", self.case(f"needles-{words[:9]}", changes={**needles, **changes}))
                self.assertEqual(wrong.code, 1, wrong.describe())
                self.assertIn(words, wrong.err)

    def test_wall_and_bore_carry_the_pin_force(self):
        summary = self.solved()
        force = look_up(summary, "load.force.value")
        for pair in summary["contact_pairs"]:
            self.assert_close(number(pair["force"]), force, 1e-6, pair["source"])
        self.assertEqual(look_up(summary, "roller.bearing_load.value"), force)
        mean = force / (6e-3 * 15e-3)
        self.assert_close(look_up(summary, "roller.mean_bore_pressure.value"), mean, 1e-12, "F/(d_b t)")
        self.assertEqual(look_up(summary, "contact.source"), "pin")
        self.assert_close(look_up(summary, "contact.peak_pressure.value"), look_up(summary, "hertz.peak_pressure.value"), 0.005,
                          "the ring's bending hardly changes the contact on the wall")

    def test_a_loose_bore_is_hertz_s_line_contact(self):
        """Johnson, Contact Mechanics, Eq. 4.45: 1/R = 1/R1 - 1/R2; of two materials."""
        for name, modulus in (("alike", "207 GPa"), ("soft", "110 GPa")):
            summary = self.solved(name, clearance="0.5 mm", modulus=modulus)
            line = look_up(summary, "load.force.value") / 15e-3
            compliance = 0.91 / 207e9 + 0.91 / (float(modulus.split()[0]) * 1e9)
            relative = 1. / (1. / 2.75e-3 - 1. / 3e-3)
            exact = (line / (3.141592653589793 * relative * compliance)) ** 0.5
            self.assert_close(number(self.bore(summary)["peak_pressure"]), exact, 0.02, name)

    def test_a_tighter_bore_has_less_pressure_over_a_wider_angle(self):
        found = [self.bore(self.solved(f"bore{i}", clearance=f"{clearance} mm")) for i, clearance in enumerate((0.2, 0.05, 0.01, 0))]
        pressures = [number(pair["peak_pressure"]) for pair in found]
        widths = [number(pair["half_width"]) for pair in found]
        self.assertEqual(pressures, sorted(pressures, reverse=True))
        self.assertEqual(widths, sorted(widths))
        self.assertLess(widths[-1] / 3e-3, 3.1415926536 / 2)
        summary = read_summary(self.directory / "bore3" / "results")
        mean = look_up(summary, "roller.mean_bore_pressure.value")
        self.assertTrue(mean < pressures[-1] < 3. * mean, pressures[-1] / mean)

    def test_a_slack_thin_ring_tells_the_contact_that_carries(self):
        """Without clearance a thin ring touches its stud on the far side, too, over a wide angle and with hardly any pressure."""
        widths = [number(self.bore(self.solved(f"thin{i}", clearance="0 mm", changes={"Mechanism/Roller bore diameter": f"{bore} mm"}))
                         ["half_width"]) / (bore / 2e3) for i, bore in enumerate((10, 11, 12, 13))]
        self.assertEqual(widths, sorted(widths, reverse=True), "a thinner ring bears over a narrower angle")

    def test_limits_of_the_stud_are_those_of_its_own_contact(self):
        summary = self.solved(changes={"Mechanism/Stud material/Yield strength": "250 MPa",
                                       "Mechanism/Roller bore friction": "0.5"})
        rows = {row["quantity"]: row for row in summary["safety"]}
        self.assertNotIn("contact, first yield, stud", rows)
        row = rows["roller bore, first yield, stud"]
        self.assert_close(row["factor"], number(row["allowed"]) / number(self.bore(summary)["peak_pressure"]), 1e-9, "factor")
        self.assertGreater(row["factor"], 4.)
        self.assert_close(number(rows["roller bore, shakedown, stud"]["allowed"]), 1.8819 * 250e6 / 3**0.5, 1e-3,
                          "the surface's, by von Mises")

    def test_the_figures_do_not_depend_on_ranks(self):
        case = self.case()
        alone = self.run_case(case)
        together = self.run_case(case, ranks=2)
        for one, other in zip(alone["contact_pairs"], together["contact_pairs"]):
            self.assert_close(number(other["peak_pressure"]), number(one["peak_pressure"]), 1e-6, one["source"])

    def test_a_whole_wheel_takes_a_roller_as_well(self):
        summary = self.solved(changes={"Mechanism/Contact model": "full wheel", "Structural accuracy": "2 %"})
        rows = {row["quantity"]: row for row in summary["comparison"]}
        self.assertGreater(number(rows["contact angle, roller bore"]["computed"]), 0.1)
        self.assertLess(summary["strength"]["wheel"]["tensile"]["error"], 0.02)
        self.assertTrue(all(check["passed"] for check in summary["checks"]))

    def test_stands_beside_a_fixed_pin(self):
        case = self.case(changes={"Mechanism/Roller bore friction": "0.1"})
        run = self.geneva("kinematics", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("fixed pin", run.out)
        roller = json.loads((case / "results" / "kinematics.json").read_text())
        rows = {row["quantity"]: row for row in roller["roller_or_fixed_pin"]}
        self.assert_close(number(rows["friction along the wall over the pin force"]["roller"]), 0.1 * 6 / 14, 1e-12, "mu_b d_b/d")
        text = (case / "case.prm").read_text()
        for name in ("Roller bore diameter", "Roller bore clearance", "Roller bore friction"):
            text = "\n".join(line for line in text.splitlines() if name not in line)
        text = set_parameter(text, "Mechanism/Pin type", "fixed\n  set Slot friction = 0.1")
        fixed = self.directory / "fixed"
        fixed.mkdir()
        (fixed / "case.prm").write_text(text)
        run = self.geneva("kinematics", fixed)
        self.assertEqual(run.code, 0, run.describe())
        alone = json.loads((fixed / "results" / "kinematics.json").read_text())
        self.assertNotIn("roller_or_fixed_pin", alone)
        for quantity, key in (("maximum Hertz pressure on the wall", "peak_hertz_pressure"),
                              ("maximum pressure x slip on the wall", "peak_pressure_times_slip")):
            self.assert_close(number(rows[quantity]["fixed"]), number(alone[key]), 1e-12, quantity)
        self.assert_close(number(rows["bending stress at the root"]["roller"]) / number(rows["bending stress at the root"]["fixed"]),
                          (14 / 5.98) ** 3, 0.02, "32 M/(pi d^3)")

    def test_wrong_rollers_are_named(self):
        for changes, words in (
                ({"Mechanism/Roller bore clearance": "1 mm"}, ("bore clearance", "a tenth of its bore")),
                ({"Mechanism/Roller bore clearance": "-0.1 mm"}, ("Roller bore clearance", "-0.1")),
                ({"Mechanism/Pin core radius": "3 mm"}, ("core", "stud of radius")),
                ({"Mechanism/Roller bore diameter": "15 mm"}, ("less than the roller's own",)),
                ({"Mechanism/Roller bore diameter": "13.5 mm"}, ("too thin to be modelled", "13.3 mm")),
                ({"Dimension": "3"}, ("Roller bore clearance", "Dimension")),
                ({"Mechanism/Pin type": "fixed"}, ("Pin type = roller only",))):
            with self.subTest(changes):
                case = self.case(f"wrong{len(list(self.directory.iterdir()))}", changes=changes)
                run = self.geneva("run", case)
                self.assertEqual(run.code, 1, run.describe())
                for word in words:
                    self.assertIn(word, run.err)
                self.assertFalse((case / "results").exists())

    def test_a_stud_belongs_to_a_roller(self):
        case = self.copy_case("johnson-optimum-wheel")
        text = (case / "case.prm").read_text().rstrip()
        (case / "case.prm").write_text(text + "\nsubsection Mechanism\n  subsection Stud material\n    set Young's modulus = 70 GPa\n  end\nend\n")
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("Pin type = roller only", run.err)


if __name__ == "__main__":
    geneva_cli.main()
