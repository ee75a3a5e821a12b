"""`geneva estimate`: the contact without finite elements, in the plane and in 3-D, and what is refused."""

import json

import geneva_cli
from geneva_cli import CliTest, read_csv


class Estimate(CliTest):

    def estimate(self, case, *arguments):
        run = self.geneva("estimate", case, *arguments)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.err, "")
        return run, json.loads((case / "results" / "estimate.json").read_text())

    def value(self, summary, name):
        return {row["quantity"]: row["value"]["value"] if isinstance(row["value"], dict) else row["value"]
                for row in summary["estimate"]}[name]

    def changed(self, shipped, changes):
        case = self.copy_case(shipped)
        geneva_cli.change_case(case, changes)
        return case

    def test_in_the_plane_it_is_hertz_s_contact(self):
        case = self.copy_case("johnson-optimum-wheel")
        _, summary = self.estimate(case)
        self.assertAlmostEqual(self.value(summary, "peak contact pressure") / 6894.757, 72675., delta=5.)
        table = read_csv(case / "results" / "estimate.csv")
        self.assertAlmostEqual(max(table["shear [psi]"]) / 21823., 1., delta=0.001)
        self.assertEqual(table["depth [in]"][0], 0.)

    def test_in_the_plane_peak_and_shear_are_those_of_finite_elements(self):
        for name in ("johnson-optimum-wheel", "internal-six-station", "long-dwell", "four-bar-geneva"):
            with self.subTest(name):
                case = self.copy_case(name)
                _, summary = self.estimate(case)
                contact = self.run_case(case)["contact"]
                self.assert_close(self.value(summary, "peak contact pressure"), geneva_cli.number(contact["peak_pressure"]),
                                  contact["peak_pressure_error"] + summary["hertz"]["expected_error"], "peak")
                self.assert_close(self.value(summary, "maximum shear"), geneva_cli.number(contact["max_shear"]),
                                  contact["max_shear_error"], "shear")

    def test_in_the_round_bottom_no_error_is_expected_of_hertz_s_contact(self):
        case = self.changed("johnson-optimum-wheel", {"Mechanism/Driver angle": "0 deg", "Mechanism/Slot clearance": "0.001 in"})
        run, summary = self.estimate(case)
        self.assertIn("the round bottom of the slot, where the pin stands", run.out)
        self.assertNotIn("expected_error", summary["hertz"])

    def test_a_crowned_pin_s_contact_is_that_of_finite_elements(self):
        case = self.copy_case("crowned-pin")
        run, summary = self.estimate(case)
        self.assertAlmostEqual(self.value(summary, "peak contact pressure") / 829.2e6, 1., delta=0.001)
        self.assertIn("half-space and beam", run.out)
        self.assertIn("left out", run.out)
        table = read_csv(case / "results" / "estimate.csv")
        places, loads = table["z [in]"], table["line load [lbf/in]"]
        self.assertEqual(places, sorted(places))
        self.assertGreaterEqual(min(loads), 0.)
        force = sum(load * (above - below) for load, below, above in zip(loads, places, places[1:] + places[-1:]))
        self.assertAlmostEqual(force / 232.39, 1., delta=0.01)

    def test_an_edge_that_no_line_contact_bounds_has_no_peak(self):
        run, summary = self.estimate(self.copy_case("johnson-optimum-3d"))
        self.assertNotIn("peak contact pressure", run.out)
        self.assertIn("the contact reaches the wall's edge", run.out)
        self.assertAlmostEqual(self.value(summary, "pressure in the middle") / 6894.757, 72000., delta=1000.)

    def test_a_pin_that_touches_at_one_end_alone_carries_nothing_in_the_middle(self):
        case = self.changed("crowned-pin", {"Mechanism/Pin/Tilt": "0.5 deg", "Mechanism/Slot clearance": "0.02 in"})
        run, summary = self.estimate(case)
        self.assertIn("the contact reaches the wall's edge", run.out)
        self.assertEqual(self.value(summary, "pressure in the middle"), 0.)
        self.assertEqual(self.value(summary, "line load, middle"), 0.)

    def test_a_pin_that_is_held_at_its_core_does_not_bend(self):
        case = self.changed("crowned-pin", {"Mechanism/Pin/Held at": "core", "Mechanism/Pin/Root gap": None})
        run, summary = self.estimate(case)
        self.assertNotIn("bending stress", run.out)
        self.assertAlmostEqual(self.value(summary, "place of the peak along the pin"), 0., delta=1e-9)
        self.assertAlmostEqual(self.value(summary, "peak contact pressure") / 828.7e6, 1.005, delta=0.005,
                               msg="Hertz's ellipse, and a little more on a thin layer")

    def test_it_follows_the_pin_over_its_engagement(self):
        case = self.changed("crowned-pin", {"Mechanism/Pin material/Yield strength": "600 MPa"})
        with open(case / "case.prm", "a", encoding="utf-8") as file:
            file.write("subsection Allowable\n  set Contact pressure = 1 GPa\nend\n")
        _, summary = self.estimate(case)
        curve = summary["engagement"]
        self.assertGreater(len(curve["driver_angle"]), 25)
        peaks = [peak for peak in curve["peak_pressure"] if peak is not None]
        self.assertGreater(len(peaks), 25)
        self.assertAlmostEqual(max(peaks), self.value(summary, "greatest pressure of the engagement"), delta=1.)
        self.assertGreaterEqual(max(summary["engagement"]["even_pressure"]), summary["hertz"]["peak_pressure"]["value"])
        self.assertTrue(min(curve["force"]) < 0 < max(curve["force"]), "it drives, then it brakes")
        for even, peak, force in zip(curve["even_pressure"], curve["peak_pressure"], curve["force"]):
            if peak is not None and abs(force) > 100:
                self.assertGreater(peak, even, "a crown carries on less than the wall's length")
        self.assertAlmostEqual(self.value(summary, "safety factor of the contact pressure"),
                               1e9 / self.value(summary, "peak contact pressure"), delta=1e-9)
        self.assertAlmostEqual(self.value(summary, "safety factor of the pin's root"),
                               600e6 / self.value(summary, "bending stress at the root"), delta=1e-9)

    def test_no_greatest_pressure_is_told_where_the_contact_reaches_the_edge(self):
        run, summary = self.estimate(self.changed("crowned-pin", {"Mechanism/Pin/Crown radius": "1000 in"}))
        self.assertNotIn("greatest pressure of the engagement", [row["quantity"] for row in summary["estimate"]])
        self.assertIn("left out: the greatest pressure of the engagement", run.out)

    def test_a_short_pin_that_is_held_twice_is_no_beam_at_its_root(self):
        case = self.changed("crowned-pin", {"Mechanism/Pin/Held at": "both ends", "Mechanism/Pin/Overhang": None})
        run, _ = self.estimate(case)
        self.assertNotIn("bending stress at the root", run.out)
        self.assertIn("too short for a beam", run.out)

    def test_a_pin_in_the_round_bottom_is_hertz_s(self):
        case = self.changed("crowned-pin", {"Mechanism/Driver angle": "-0.01 deg"})
        run, _ = self.estimate(case)
        self.assertNotIn("half-space and beam", run.out)
        self.assertIn("round bottom", run.out)

    def test_the_report_shows_it_beside_the_motion(self):
        case = self.copy_case("crowned-pin")
        self.assertEqual(self.geneva("kinematics", case, "--steps", "20").code, 0)
        self.estimate(case)
        names = {path.name for path in (case / "results").iterdir()}
        self.assertLessEqual({"estimate.json", "estimate.csv", "kinematics.json", "mechanism.json", "report.html"}, names)
        page = (case / "results" / "report.html").read_text()
        for part in (">Estimate<", "Left out", "maximum pressure along the pin", "Motion over the cycle"):
            self.assertTrue(part in page, part)

    def test_cases_without_a_mechanism_are_refused(self):
        for shipped in ("hertz-line-contact", "synthesis-quick-return"):
            case = self.copy_case(shipped)
            run = self.geneva("estimate", case)
            self.assertEqual(run.code, 1, run.describe())
            self.assertIn("there is no Geneva mechanism", run.err)
            self.assertEqual(len(run.err.strip().splitlines()), 1)

    def test_a_pin_that_presses_on_nothing_is_refused(self):
        run = self.geneva("estimate", self.changed("johnson-optimum-wheel", {"Mechanism/Driver angle": "20 deg"}))
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("does not press", run.err)


if __name__ == "__main__":
    geneva_cli.main()
