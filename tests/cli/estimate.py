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

    def test_a_pin_that_is_held_at_its_core_is_hertz_s(self):
        case = self.changed("crowned-pin", {"Mechanism/Pin/Held at": "core", "Mechanism/Pin/Root gap": None})
        run, _ = self.estimate(case)
        self.assertIn("held at its core", run.out)

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
