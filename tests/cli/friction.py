"""A pin that slides along the wall: friction in the contact, the stress field, the torque and the results."""

import csv
import math

import geneva_cli
from geneva_cli import CliTest, change_case, look_up, number

CASE = """
set Title        = pin that slides
set Model        = mechanism
set Output units = SI
set Accuracy     = {accuracy}
set Structural accuracy = off
subsection Mechanism
  set Contact model   = {model}
  set Type            = {type}
  set Stations        = 4
  set Wheel diameter  = 120 mm
  set Pin diameter    = 18 mm
  set Wheel thickness = 15 mm
  set Driver speed    = 300 rpm
  set Driver angle    = {angle} deg
  set Load inertia    = 0.01 kg.m^2
  set Friction moment = 2 N.m
  set Slot friction   = {friction}
end
"""


class Friction(CliTest):

    def case(self, friction, name="wheel", *, model="full wheel", kind="external", angle=-20, accuracy="1 %", changes=None):
        directory = self.directory / f"{name}-{friction}"
        directory.mkdir()
        (directory / "case.prm").write_text(
            CASE.format(friction=friction, model=model, type=kind, angle=angle, accuracy=accuracy))
        change_case(directory, changes or {})
        return directory

    def solved(self, friction, *arguments, **options):
        return self.run_case(self.case(friction, *arguments, **options))

    def rows(self, case):
        """Of contact.csv, by the names of its columns without units."""
        with open(case / "results" / "contact.csv", newline="") as file:
            lines = list(csv.reader(file))
        names = [heading.split(" [")[0] for heading in lines[0]]
        return [dict(zip(names, line)) for line in lines[1:]]

    def test_traction_is_mu_times_the_pressure_against_the_sliding(self):
        for angle, towards_the_rim in ((-20, False), (-3, True)):
            case = self.case(0.3, f"at{angle}", angle=angle)
            summary = self.run_case(case)
            slip = look_up(summary, "load.slip_speed.value")
            self.assertEqual(slip > 0, towards_the_rim)
            closed = [row for row in self.rows(case) if float(row["contact_pressure"]) > 0]
            self.assertGreater(len(closed), 10)
            for row in closed:
                pressure = float(row["contact_pressure"])
                self.assertEqual(row["status"], "2")
                self.assertAlmostEqual(float(row["friction_x"]) / pressure, -math.copysign(0.3, slip), delta=1e-4)
                self.assertAlmostEqual(float(row["friction_y"]) / pressure, 0, delta=1e-6)
            force = look_up(summary, "contact.force.value")
            self.assert_close(look_up(summary, "contact.friction.force.value"), 0.3 * force, 1e-6, "mu F")
            self.assert_close(look_up(summary, "contact.friction.power.value"), 0.3 * force * abs(slip), 1e-6, "mu F v")

    def test_the_shaft_takes_the_load_on_either_side_of_the_reversal(self):
        """The load's torque, whatever friction does to the pin force; external and internal wheels, both directions."""
        for kind, angles in (("external", (-30, -20, -3)), ("internal", (-60, -30))):
            for angle in angles:
                summary = self.solved(0.3, f"{kind}{angle}", kind=kind, angle=angle, accuracy="5 %")
                self.assert_close(look_up(summary, "equilibrium.bore_torque.value"),
                                  look_up(summary, "equilibrium.expected_bore_torque.value"), 2e-3, f"{kind} {angle}")
                load = 0.01 * look_up(summary, "load.wheel_acceleration.value") + 2
                self.assert_close(look_up(summary, "equilibrium.expected_bore_torque.value"), load, 1e-9, "J a + M_f")

    def test_the_field_is_that_of_smith_and_liu(self):
        for friction in (0.1, 0.3, 0.5):
            summary = self.solved(friction, "field", accuracy="0.3 %")
            self.assert_close(look_up(summary, "contact.peak_pressure.value"), look_up(summary, "hertz.peak_pressure.value"),
                              0.005, "similar bodies keep Hertz's pressure")
            for side in ("source", "target"):
                self.assertLess(look_up(summary, f"contact.stress_difference_{side}"), 0.02, (friction, side))

    def test_little_friction_is_a_small_change(self):
        without = self.solved(0)
        little = self.solved(1e-9)
        self.assertNotIn("friction", without["contact"])
        self.assert_close(look_up(little, "contact.peak_pressure.value"), look_up(without, "contact.peak_pressure.value"), 1e-7,
                          "mu = 1e-9")

    def test_ranks_and_units_change_nothing(self):
        case = self.case(0.3, "ranks")
        alone = self.run_case(case)
        for ranks in (2, 3):
            together = self.run_case(case, ranks=ranks)
            for key in ("contact.peak_pressure.value", "contact.friction.force.value", "equilibrium.bore_torque.value"):
                self.assert_close(look_up(together, key), look_up(alone, key), 1e-7, f"{key} on {ranks} ranks")

    def test_in_space_friction_drags_the_pin_along(self):
        """Half of a pin held at both ends: the friction's resultant is mu F, and nothing is left of the balance."""
        case = self.case(0.3, "space", model="local", accuracy="10 %", changes={"Dimension": "3"})
        with open(case / "case.prm", "a") as file:
            file.write("subsection Mechanism\nsubsection Pin\nset Held at = both ends\nset Root gap = 2 mm\nset Profile = crown\nset Crown radius = 2 m\nend\nend\n")
        summary = self.run_case(case)
        force = look_up(summary, "contact.force.value")
        self.assert_close(look_up(summary, "contact.friction.force.value"), 0.3 * force, 1e-5, "mu F")
        self.assertLess(look_up(summary, "equilibrium.force_residual"), 1e-6)

    def test_a_roller_has_no_friction_on_the_wall(self):
        case = self.case(0, "roller", changes={"Mechanism/Pin type": "roller", "Mechanism/Roller bore diameter": "8 mm",
                                               "Mechanism/Roller bore friction": "0.1"})
        self.assertNotIn("friction", self.run_case(case)["contact"])


if __name__ == "__main__":
    geneva_cli.main()
