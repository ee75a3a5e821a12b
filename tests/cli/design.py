"""`geneva design`: Johnson's wheel and shaft, one case or several, and what is refused."""

import json
import math

import geneva_cli
from bad_input import Refusals
from closed_forms import INCH, POUND_FORCE, PSI
from geneva_cli import CliTest, change_case, files_of, timeless_files_of, look_up, number, read_csv, set_parameter
from run_cases import read_expected

POUND_INCH = POUND_FORCE * INCH  # lbf.in in N m, and lbf.s^2.in in kg m^2
OPTIMUM, SMALL, LARGE = "johnson-optimum-wheel", "johnson-small-wheel", "johnson-large-wheel"


def read_design(directory):
    return json.loads((directory / "design.json").read_text())


class Design(CliTest):
    """The figures of shipped cases against those that Johnson prints."""

    def design(self, *cases):
        output = self.directory / "output"
        run = self.geneva("design", *(self.source / "cases" / case for case in cases), "--output", output)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.err, "")
        return run, output

    def hertz_pressure(self, case):
        """Closed form of a run's peak pressure, worked out apart from the program."""
        checks = read_expected(self.source / "cases" / case)
        return next(check["value"] for check in checks if check.get("key") == "hertz.peak_pressure")

    def test_example_one_gives_johnsons_optimum_wheel(self):
        _, output = self.design(OPTIMUM)
        design = read_design(output)
        # three printed digits, of which he rounds the factors: 4.53 in, 0.00704, 232 lbf, 72 600 psi
        for key, unit, printed, tolerance in (("optimum_diameter", "m", 4.53 * INCH, 1.2e-3),
                                              ("optimum_inertia", "kg m^2", 0.00704 * POUND_INCH, 2.5e-3),
                                              ("force", "N", 232 * POUND_FORCE, 3e-3),
                                              ("peak_pressure", "Pa", 72600 * PSI, 3e-3),
                                              ("thickness", "m", 0.68 * INCH, 5e-3)):
            self.assertEqual(design[key]["unit"], unit)
            self.assert_close(number(design[key]), printed, tolerance, key)
        self.assert_close(number(design["wheel"]["force"]), 1033.7323756133883, 1e-10, "the wheel of the case")

    def test_the_drawn_wheel_has_the_same_best_inertia_in_a_smaller_wheel(self):
        _, output = self.design(OPTIMUM)
        design = read_design(output)
        best = number(design["optimum_inertia"])
        self.assert_close(number(look_up(design, "geometry.optimum_inertia")), best, 1e-10, "J_G")
        self.assert_close(look_up(design, "geometry.inertia_ratio"), 1.5, 1e-10, "Eq. 9")
        self.assertLess(number(look_up(design, "geometry.optimum_diameter")), number(design["optimum_diameter"]))

    def test_example_two_gives_johnsons_shafts(self):
        _, output = self.design(OPTIMUM, SMALL)
        # the load's inertia is 0.0046055 where he takes 0.0046: torque and twist 0.12 % more, frequency 0.06 % less
        exact = {OPTIMUM: (4.6244e-5, 0.00018498, 1470.5, 0.00041990), SMALL: (0.0038975, 0.015590, 160.18, 0.035389)}
        for case, (twist, amplitude, frequency, energy) in exact.items():
            shaft = read_design(output / case)["shaft"]
            self.assert_close(number(shaft["twist"]), twist, 1.3e-3, "twist")
            self.assert_close(number(shaft["double_amplitude"]), amplitude * INCH, 1.3e-3, "double amplitude")
            self.assert_close(number(shaft["frequency"]), frequency, 7e-4, "frequency")
            self.assert_close(number(shaft["energy"]), energy * POUND_INCH, 2.5e-3, "energy")
        inertia = read_design(output / OPTIMUM)["shaft"]["inertia"]
        self.assert_close(number(inertia), 0.000216 * POUND_INCH, 2.5e-3, "the shaft's own inertia")

    def test_the_table_is_johnsons(self):
        _, output = self.design(OPTIMUM)
        table = {row["n"]: row for row in read_design(output)["table"]}
        self.assertEqual(sorted(table), list(range(3, 25)))
        self.assert_close(table[5]["a_max"], 2.2988, 3e-5, "a_max for five stations, which he misprints")
        for n, row in table.items():
            self.assertAlmostEqual(row["a_v"], math.tan(math.pi / n), 12)
            self.assertEqual("k5" in row, n <= 10)
        self.assertEqual(table[4]["k5"], 0.00506)
        self.assert_close(table[4]["k5_geometry"], 0.0057, 0.01, "k5 of the drawn wheel")
        self.assertEqual(table[3]["beta"]["unit"], "rad")

    def test_three_wheels_stand_side_by_side_with_johnsons_percentages(self):
        run, output = self.design(OPTIMUM, SMALL, LARGE)
        lines = run.out.splitlines()
        self.assertEqual(lines[0].split(), [OPTIMUM, SMALL, LARGE])
        stress = [line for line in lines if line.startswith("  peak contact pressure [psi]")]
        self.assertEqual(len(stress), 3, run.out)
        self.assertEqual(stress[0].split()[4:], ["72675"] * 3)
        hertz = [self.hertz_pressure(case) for case in (OPTIMUM, SMALL, LARGE)]
        self.assertEqual(stress[2].split()[4:], [f"{pressure / PSI:.0f}" for pressure in hertz])
        # "218 per cent of the stress", "111 per cent"
        for case, percent in ((OPTIMUM, 100), (SMALL, 218), (LARGE, 111)):
            ratio = read_design(output / case)["wheel"]["peak_pressure_ratio"]
            self.assertEqual(round(100 * ratio), percent)

    def test_the_curve_has_its_minimum_at_the_optimum(self):
        _, output = self.design(OPTIMUM)
        design, curve = read_design(output), read_csv(output / "design.csv")
        for name, section in (("johnson", design), ("geometry", design["geometry"])):
            stress = curve[f"stress_{name} [psi]"]
            self.assertEqual(len(stress), 101)
            best = number(section["optimum_diameter"]) / INCH
            lowest = curve["diameter [in]"][stress.index(min(stress))]
            self.assertLess(abs(math.log(lowest / best)), math.log(10) / 100)
            self.assertGreaterEqual(min(stress) * PSI, number(section["peak_pressure"]) * (1 - 1e-9))

    def test_a_run_and_a_design_leave_each_others_files(self):
        case = self.copy_case(OPTIMUM)
        results = case / "results"
        self.assertEqual(self.geneva("design", case).code, 0)
        designed = timeless_files_of(results)
        self.assertEqual(sorted(designed), ["design.csv", "design.json", "mechanism.json", "report.html"])
        del designed["report.html"]  # which the run makes anew
        self.run_case(case)
        both = timeless_files_of(results)
        self.assertEqual({name: both[name] for name in designed}, designed)
        self.assertEqual(self.geneva("design", case).code, 0)
        self.assertEqual(timeless_files_of(results), both)

    def test_given_lengths_that_stay_are_searched_for(self):
        case = self.copy_case(OPTIMUM)
        change_case(case, {"Mechanism/Pin diameter": "0.68 in", "Mechanism/Design/Given lengths": "stay as given"})
        run = self.geneva("design", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("instead of the 1.5 of Johnson's Eq. 9", run.out)
        geometry = read_design(case / "results")["geometry"]
        self.assert_close(number(geometry["pin_diameter"]), 0.68 * INCH, 1e-12, "the pin")
        self.assertLess(geometry["inertia_ratio"], 1)

    def test_several_processes_write_once(self):
        case = self.copy_case(OPTIMUM)
        run = self.geneva("design", case, ranks=2)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.out.count("natural frequency"), 1)


class DesignRefusals(Refusals):
    """What is no design is refused in one message, and nothing is written."""

    def assert_design_refused(self, *arguments, words):
        before = self.paths(), files_of(self.directory)
        run = self.geneva("design", *arguments)
        self.assert_explained(run, words)
        self.assertEqual((self.paths(), files_of(self.directory)), before)

    def test_a_geometry_is_refused(self):
        case = self.copy_case("hertz-line-contact")
        self.assert_design_refused(case, words=["case.prm", "geometry", "Model = mechanism"])

    def test_one_wrong_case_of_two_is_refused(self):
        good, wrong = self.copy_case(OPTIMUM), self.copy_case(SMALL)
        change_case(wrong, {"Mechanism/Design/Shaft": "1 in by 3 in"})
        self.assert_design_refused(good, wrong, words=["case.prm", "'Design/Shaft' = '1 in by 3 in'", "0.375 in x 5 in"])

    def test_a_wheel_without_load_has_no_optimum(self):
        case = self.copy_case(SMALL)
        text = (case / "case.prm").read_text()
        for name in ("Load diameter", "Load length", "Load density", "Design/Shaft"):
            text = set_parameter(text, f"Mechanism/{name}", None)
        (case / "case.prm").write_text(text)
        change_case(case, {"Mechanism/Load inertia": "0 kg.m^2", "Mechanism/Friction moment": "0 N.m"})
        self.assert_design_refused(case, words=["case.prm", "both 0", "give the load's inertia or the friction"])

    def test_two_cases_for_one_directory_are_refused(self):
        case = self.copy_case(OPTIMUM)
        self.assert_design_refused(case, case, words=["two cases", "name each case once"])
        other = self.copy_case(OPTIMUM, f"other/{OPTIMUM}")
        self.assert_design_refused(case, other, "--output", self.directory / "output",
                                   words=["two cases", "without --output"])

    def test_a_missing_case_and_a_file_in_the_way_are_refused(self):
        case = self.copy_case(OPTIMUM)
        self.assert_design_refused(case / "nowhere", words=["there is no such directory"])
        self.assertEqual(self.geneva("design").code, 1)
        # the table is out by then
        run = self.geneva("design", case, "--output", case / "case.prm")
        self.assertEqual(run.code, 1)
        self.assertIn("in the way", run.err)


class WithStrength(CliTest):
    """`geneva design --strength`: the wheel away from the contact against its diameter."""

    CASE = """set Model = mechanism
set Output units = SI
subsection Mechanism
  set Stations = 6
  set Wheel diameter = 100 mm
  set Pin diameter = 14 mm
  set Wheel thickness = 14 mm
  set Driver speed = 300 rpm
  set Friction moment = 20 N.m
  set Load inertia = 1e-3 kg.m^2
end
"""

    def write(self, name, scale=1.):
        case = self.directory / name
        case.mkdir()
        text = self.CASE
        for parameter, length in (("Wheel diameter", 100), ("Pin diameter", 14), ("Wheel thickness", 14)):
            text = set_parameter(text, f"Mechanism/{parameter}", f"{length * scale!r} mm")
        (case / "case.prm").write_text(text)
        return case

    def test_it_is_that_of_a_run_with_the_wheel_of_that_diameter(self):
        case = self.write("wheel")
        run = self.geneva("design", "--strength", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("the wheel away from the contact", run.out)
        rows = read_design(case / "results")["strength"]
        diameters = [number(row["diameter"]) for row in rows]
        self.assertEqual(diameters, sorted(diameters))
        self.assertGreaterEqual(len(rows), 7)
        for row in rows:
            self.assertLess(max(row["von_mises_error"], row["tensile_error"]), 0.05)
            self.assertLess(row["peak_pressure_error"], 0.02)
        row = rows[len(rows) // 2]
        alone = self.write("alone", number(row["diameter"]) / 0.1)
        (alone / "case.prm").write_text("set Accuracy = 2 %\n" + (alone / "case.prm").read_text())
        wheel = self.run_case(alone)["strength"]["wheel"]
        for name in ("von_mises", "tensile"):
            self.assert_close(number(row[name]), wheel[name]["value"], 1e-6, name)
            self.assert_close(row[f"{name}_error"], wheel[name]["error"], 1e-3, f"{name}_error")
        self.assertEqual(row["where"], wheel["tensile"]["where"])
        page = (case / "results" / "report.html").read_text()
        self.assertIn("Maximum stresses of the wheel away from the contact against its diameter", page)

    def test_the_pin_force_over_thickness_and_diameter_decides(self):
        # At the best diameter 0.6 of the force is the wheel's own inertia, J_G a ~ D^5, 0.4 load and friction: of D0
        # F/(t D) ~ (0.6 (D/D0)^5 + 0.4)/(D/D0)^3. The wheel's inertia, which pulls on its arms, too, changes that little.
        case = self.write("similar")
        run = self.geneva("design", "--strength", case)
        self.assertEqual(run.code, 0, run.describe())
        design = read_design(case / "results")
        best = number(design["optimum_diameter"])
        expected = [(0.6 * size**5 + 0.4) / size**3 for size in (number(row["diameter"]) / best for row in design["strength"])]
        shares = [number(row["tensile"]) / value for row, value in zip(design["strength"], expected)]
        for share in shares:
            self.assert_close(share, shares[0], 0.12, "tensile stress over F/(t D)")

    def test_one_case_and_no_crown_is_wanted(self):
        one, other = self.write("one"), self.write("other")
        for words, arguments in ((("--strength", "one CASE_DIR"), ("--strength", one, other)),
                                 (("--strength", "give one"), ("--strength", "--crown", one))):
            run = self.geneva("design", *arguments)
            self.assertEqual(run.code, 1, run.describe())
            for word in words:
                self.assertIn(word, run.err + run.out)


if __name__ == "__main__":
    geneva_cli.main()
