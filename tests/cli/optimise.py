"""The best dimensions of a case: beside Johnson's, under limits, and what is refused."""

import json
import subprocess

import geneva_cli
from geneva_cli import CliTest, change_case, environment, number


def section(**values):
    lines = "".join(f"  set {name.replace('_', ' ')} = {value}\n" for name, value in values.items())
    return f"\nsubsection Optimisation\n{lines}end\n"


class Optimise(CliTest):

    def call(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=False,
                              cwd=self.directory, env=environment())

    def case(self, name, shipped="indexing-table", **values):
        case = self.copy_case(shipped, name)
        path = case / "case.prm"
        path.write_text(path.read_text() + section(**values))
        return case

    def optimum(self, case, code=0):
        run = self.call("optimise", case)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return json.loads((case / "results" / "optimum.json").read_text()), run.stdout

    def figure(self, optimum, quantity, key="after"):
        return number(next(row for row in optimum["figures"] if row["quantity"] == quantity)[key])

    def dimension(self, optimum, name):
        return next(row for row in optimum["dimensions"] if row["name"] == name)

    def test_with_the_diameter_alone_free_it_finds_johnson_s_wheel(self):
        # His Eq. 9, as 'geneva design' solves it; friction moment and load as in his Example 1.
        case = self.case("johnson", "johnson-optimum-wheel", Free="Wheel diameter: 2 in .. 12 in",
                         Minimise="peak contact pressure")
        self.assertEqual(self.call("design", case, "-o", case / "design").returncode, 0)
        design = json.loads((case / "design" / "design.json").read_text())
        optimum, printed = self.optimum(case)
        best = float(self.dimension(optimum, "Wheel diameter")["after"].split()[0])
        print(f"  best diameter {best:.5f} in")
        self.assert_close(best * 0.0254, number(design["optimum_diameter"]), 1e-3, "diameter")
        self.assertEqual(optimum["binds"], [])
        self.assertIn("nothing binds", printed)
        confirmed = self.figure(optimum, "peak contact pressure", "confirmed")
        self.assert_close(confirmed, self.figure(optimum, "peak contact pressure"), 0.005, "finite elements")

    def test_a_limit_that_binds_is_named_and_kept(self):
        free = "Wheel diameter: 80 mm .. 200 mm; Pin diameter: 8 mm .. 20 mm"
        heavy, _ = self.optimum(self.case("free", Free=free))
        mass = self.figure(heavy, "mass of the wheel")
        limit = 0.6 * mass
        light, printed = self.optimum(self.case("light", Free=free, Largest_mass=f"{limit:.9g} kg"))
        self.assertLessEqual(self.figure(light, "mass of the wheel"), limit * (1 + 1e-6))
        self.assertGreater(self.figure(light, "mass of the wheel"), limit * (1 - 1e-3))
        self.assertIn("the limit of the mass of the wheel", light["binds"])
        self.assertIn("the limit of the mass of the wheel", printed)
        self.assertGreater(self.figure(light, "peak contact pressure of the cycle"),
                           self.figure(heavy, "peak contact pressure of the cycle"))
        self.assertEqual(self.dimension(heavy, "Pin diameter")["bound"], "upper")

    def test_the_least_mass_that_bears_a_pressure_is_where_the_pressure_is_the_limit(self):
        optimum, _ = self.optimum(self.case("mass", Free="Wheel thickness: 5 mm .. 40 mm", Minimise="mass of the wheel",
                                            Largest_contact_pressure="600 MPa"))
        # p0 = sqrt(F E*/(pi R t)); the wheel's own inertia is 1 % of the load's.
        pressure = self.figure(optimum, "peak contact pressure of the cycle")
        self.assert_close(pressure, 600e6, 1e-5, "pressure")
        thickness = float(self.dimension(optimum, "Wheel thickness")["after"].split()[0])
        self.assert_close(thickness, 15 * (478.8 / 600)**2, 0.01, "thickness")
        self.assertEqual(optimum["binds"], ["the limit of the peak contact pressure of the cycle"])

    def test_the_least_mass_keeps_a_wall_that_can_be_made(self):
        free = "Wheel diameter: 80 mm .. 200 mm; Pin diameter: 5 mm .. 40 mm"
        for given, share in ((None, 0.1), ("3 mm", None)):
            values = {"Least_wall": given} if given else {}
            optimum, printed = self.optimum(self.case(f"wall-{given}", Free=free, Minimise="mass of the wheel", **values))
            slot = 1e-3 * float(self.dimension(optimum, "Pin diameter")["after"].split()[0])
            self.assert_close(self.figure(optimum, "least wall of the wheel"), share * slot if share else 3e-3, 1e-4, "wall")
            self.assertIn("the limit of the least wall of the wheel", printed)
            self.assertIsNotNone(optimum["figures"][0]["confirmed"])

    def test_the_best_case_is_judged_by_its_materials(self):
        optimum, printed = self.optimum(self.case("thin", Free="Wheel thickness: 1 mm .. 40 mm", Minimise="mass of the wheel"))
        pitting = next(row for row in optimum["safety"] if row["quantity"] == "contact, pitting, wheel")
        self.assert_close(number(pitting["computed"]), self.figure(optimum, "peak contact pressure of the cycle"), 1e-9, "pressure")
        self.assertLess(pitting["factor"], 1)
        self.assertIn("EXCEEDED", printed)

    def test_the_slot_s_bottom_may_be_the_goal(self):
        case = self.case("bottom", Free="Pin diameter: 8 mm .. 24 mm", Minimise="stress at the slot bottom")
        change_case(case, {"Structural accuracy": "4 %"})
        optimum, _ = self.optimum(case)
        best = self.figure(optimum, "stress at the slot bottom")
        for diameter in (8, 16, 24):
            other = self.copy_case("indexing-table", f"other-{diameter}")
            change_case(other, {"Mechanism/Pin diameter": f"{diameter} mm"})
            stress = next(number(row["computed"]) for row in self.run_case(other)["comparison"]
                          if row["quantity"] == "tensile stress, wheel")
            self.assertGreater(stress, 0.95 * best)

    def test_in_3_d_it_finds_the_crown_of_least_pressure(self):
        case = self.case("crown", "crowned-pin", Free="Pin/Crown radius: 20 in .. 20000 in", Minimise="peak contact pressure")
        change_case(case, {"Accuracy": "10 %"})
        optimum, printed = self.optimum(case)
        best = self.figure(optimum, "peak contact pressure")
        crown = float(self.dimension(optimum, "Crown radius")["after"].split()[0])
        self.assertIn("pressures by line contacts along the pin", printed)
        # The flattest crown with which the contact keeps off the wall's edge.
        (binds,) = optimum["binds"]
        self.assertIn("the contact reaches the wall's edge", binds)
        doubts, pressures = [], []
        for factor in (0.9, 0.99, 1.02):
            other = self.copy_case("crowned-pin", f"crown-{factor}")
            change_case(other, {"Mechanism/Pin/Crown radius": f"{factor * crown} in"})
            self.assertEqual(self.call("estimate", other).returncode, 0)
            line = json.loads((other / "results" / "estimate.json").read_text())["half_space_and_beam"]
            doubts.append(line["peak_doubt"])
            pressures.append(number(line["peak_pressure"]))
        self.assertEqual(doubts[:2], ["none", "none"])
        self.assertNotEqual(doubts[2], "none")
        self.assertGreater(pressures[0], pressures[1])
        self.assertGreater(pressures[1], best)
        confirmed = next(row for row in optimum["figures"] if row["quantity"] == "peak contact pressure")
        self.assert_close(number(confirmed["confirmed"]), best, confirmed["confirmed_error"], "finite elements")

    def test_the_best_case_can_be_run_and_is_what_was_told(self):
        case = self.case("again", Free="Pin diameter: 8 mm .. 20 mm", Largest_stress_at_the_pin_root="40 MPa")
        optimum, _ = self.optimum(case)
        again = self.directory / "best"
        again.mkdir()
        (again / "case.prm").write_text((case / "results" / "optimum.prm").read_text())
        summary = self.run_case(again)
        self.assertEqual(number(summary["contact"]["peak_pressure"]),
                         self.figure(optimum, "peak contact pressure", "confirmed"))
        self.assertIn("Best dimensions", (case / "results" / "report.html").read_text())

    def test_a_best_case_that_cannot_be_meshed_keeps_what_is_known_of_it(self):
        case = self.case("thick", Free="Pin diameter: 5 mm .. 40 mm", Least_wall="1 nm")
        run = self.call("optimise", case)
        self.assertEqual(run.returncode, 2, run.stdout)
        self.assertIn("the best case could not be solved", run.stderr)
        optimum = json.loads((case / "results" / "optimum.json").read_text())
        self.assertIsNone(optimum["figures"][0]["confirmed"])

    def test_it_leaves_a_run_and_its_mechanism_in_the_results(self):
        case = self.case("kept", Free="Pin diameter: 8 mm .. 20 mm")
        self.run_case(case)
        before = (case / "results" / "mechanism.json").read_text()
        self.optimum(case)
        self.assertEqual(json.loads((case / "results" / "mechanism.json").read_text())["name"], json.loads(before)["name"])
        report = (case / "results" / "report.html").read_text()
        for part in ("Best dimensions", "mechanism-drawing", "Verdict"):
            self.assertIn(part, report)

    def test_a_dimension_without_effect_is_named(self):
        optimum, printed = self.optimum(self.case("idle", Free="Pin/Root gap: 1 mm .. 10 mm; Pin diameter: 8 mm .. 20 mm"))
        self.assertEqual([self.dimension(optimum, name)["has_effect"] for name in ("Root gap", "Pin diameter")],
                         [False, True])
        self.assertIn("has no effect", printed)

    def test_a_dimension_without_effect_stays_as_the_case_gives_it(self):
        case = self.case("core", Free="Pin core radius: 1 mm .. 3 mm; Pin diameter: 8 mm .. 20 mm")
        change_case(case, {"Mechanism/Pin core radius": "2 mm"})
        optimum, _ = self.optimum(case)
        self.assertEqual(self.dimension(optimum, "Pin core radius")["after"], "2 mm")
        self.assertRegex((case / "results" / "optimum.prm").read_text(), r"Pin core radius\s*= 2 mm")

    def test_what_cannot_be_is_said(self):
        bare = self.copy_case("indexing-table", "bare")
        for case, words in (
                (bare, "leaves nothing free"),
                (self.case("a", Free="Wheel diameter 80 mm .. 90 mm"), "'NAME: LEAST .. GREATEST' is wanted"),
                (self.case("b", Free="Wheel diameter: 90 mm .. 80 mm"), "the least value comes first"),
                (self.case("c", Free="Wheel diametr: 80 mm .. 90 mm"), "did you mean 'Wheel diameter'?"),
                (self.case("d", Free="Wheel diameter: 80 kg .. 90 kg"), "is no unit of length"),
                (self.case("e", Free="Wheel diameter: 80 mm .. 90 mm", Largest_contact_pressure="1 MPa"),
                 "which comes nearest, the peak contact pressure of the cycle is"),
                (self.case("f", Largest_mass="1 kg"), "'Free' only, which is missing"),
                (self.case("g", Free="Pin diameter: 8 mm .. 9 mm; Pin diameter: 8 mm .. 9 mm"), "stands there twice"),
                (self.case("j", Free="Pin diameter: 8 mm .. 90 mm; Pin/Overhang: -9 m .. -8 m"), "case.prm and 'Free': "),
                (self.case("h", "long-dwell", Free="Pin diameter: 8 mm .. 14 mm", Minimise="stress at the slot bottom"),
                 "is not drawn"),
                (self.case("i", "four-bar-geneva", Free="Pin diameter: 8 mm .. 14 mm", Largest_mass="1 kg"),
                 "is not drawn")):
            with self.subTest(words):
                run = self.call("optimise", case)
                self.assertEqual(run.returncode, 1, run.stdout)
                self.assertIn(words, run.stderr)
                self.assertFalse((case / "results").exists())


if __name__ == "__main__":
    geneva_cli.main()
