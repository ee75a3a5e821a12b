"""A pin in the round bottom of its slot: the wall is straight wall and bottom in one."""

import math

import geneva_cli
from geneva_cli import CliTest, look_up, number, set_parameter

# Four stations without clearance: at driver angle 0 the pin fits the bottom.
CASE = """set Model = mechanism
set Output units = mm-N
set Accuracy = 2 %
subsection Mechanism
  set Stations = 4
  set Crank radius = 80 mm
  set Pin diameter = 9.4 mm
  set Wheel thickness = 9.4 mm
  set Driver speed = 1 rpm
  set Driver angle = 0 deg
  set Friction moment = 25 N.m
  set Load inertia = 1e-6 kg.m^2
  set Contact model = full wheel
end
"""


class SlotBottom(CliTest):

    def run_with(self, name, changes):
        case = self.directory / name
        case.mkdir()
        text = CASE
        for parameter, value in changes.items():
            text = set_parameter(text, parameter, value)
        (case / "case.prm").write_text(text)
        return self.run_case(case)

    def check_without_hertz(self, summary):
        """No closed form beside it, and a torque balance that holds all the same."""
        self.assertIn("reaches over parts of different curvature", " ".join(summary["notices"]))
        self.assertNotIn("hertz", summary)
        balance = summary["equilibrium"]
        self.assert_close(number(balance["bore_torque"]), number(balance["expected_bore_torque"]), 1e-3, "bore torque")

    def check_conforming(self, summary):
        """Spread over the bottom, which presses along the slot as well."""
        self.check_without_hertz(summary)
        self.assertIn("presses it along the slot", " ".join(summary["notices"]))
        force, pin_force = (number(look_up(summary, key)) for key in ("contact.force", "load.force"))
        self.assertGreater(force, 1.01 * pin_force)
        # half of the arc over the quarter turn
        self.assertGreater(number(summary["contact"]["half_width"]), math.pi / 8 * 4.7e-3)

    def test_a_pin_that_fits_has_a_pressure_with_a_bound(self):
        runs = {}
        for accuracy in ("2 %", "0.5 %"):
            runs[accuracy] = self.run_with(accuracy.replace(" %", ""), {"Accuracy": accuracy})
            self.check_conforming(runs[accuracy])
        coarse, fine = (run["contact"] for run in runs.values())
        bars = sum(run["peak_pressure_error"] for run in (coarse, fine))
        self.assert_close(number(coarse["peak_pressure"]), number(fine["peak_pressure"]), bars, "within the bars")

    def test_the_pressure_is_the_same_before_and_after_the_middle_of_the_step(self):
        peaks = {}
        for angle in (-1.125, 1.125):
            summary = self.run_with(f"{angle}", {"Mechanism/Driver angle": f"{angle} deg"})
            self.check_without_hertz(summary)
            peaks[angle] = number(summary["contact"]["peak_pressure"])
        # the same geometry, and loads that differ by the wheel's inertia only
        self.assert_close(peaks[-1.125], peaks[1.125], 0.02, "both signs")

    def test_an_internal_wheel_has_the_bottom_outside(self):
        changes = {"Mechanism/Type": "internal", "Mechanism/Stations": "6"}
        self.check_conforming(self.run_with("internal", changes))

    def test_a_pin_beside_the_bottom_touches_the_wall_that_the_load_pushes_it_to(self):
        """Gaps to the bottom are small all around, but close along the load on one side only."""
        summary = self.run_with("beside", {"Mechanism/Type": "internal", "Mechanism/Stations": "18",
                                           "Mechanism/Driver angle": "3 deg"})
        self.assert_close(number(summary["contact"]["peak_pressure"]), number(summary["hertz"]["peak_pressure"]), 0.01,
                          "Hertz's line contact on the straight wall")

    def test_in_space_wall_and_bottom_are_one_surface_as_well(self):
        plane = self.run_with("plane", {"Mechanism/Driver angle": "1.125 deg"})
        changes = {"Dimension": "3", "Accuracy": "5 %", "Mechanism/Driver angle": "1.125 deg"}
        space = self.run_with("space", changes)
        # a pin as long as thick, held at both ends: its middle is near plane strain
        self.assert_close(number(space["contact"]["mid_length_pressure"]),
                          number(plane["contact"]["peak_pressure"]), 0.05, "in the middle")

    def test_a_pin_with_clearance_presses_on_wall_and_bottom(self):
        """Between Hertz's pressure on the straight wall and that in the bottom alone."""
        summary = self.run_with("clearance", {"Mechanism/Slot clearance": "0.4 mm"})
        self.assertIn("different curvature", " ".join(summary["notices"]))
        radius, bottom = 4.7e-3, 4.9e-3
        modulus = 207e9 / (1 - 0.3**2) / 2
        line_load = number(summary["load"]["force"]) / 9.4e-3
        flat = math.sqrt(line_load * modulus / (math.pi * radius))
        enclosed = math.sqrt(line_load * modulus / math.pi * (1 / radius - 1 / bottom))
        peak = number(summary["contact"]["peak_pressure"])
        self.assertLess(peak, flat)
        self.assertGreater(peak, enclosed)


if __name__ == "__main__":
    geneva_cli.main()
