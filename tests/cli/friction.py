"""A pin that slides along the wall: friction in the contact, the stress field, the torque and the results."""

import csv
import json
import math
import random
import re

import geneva_cli
from browser import Browser
from geneva_cli import CliTest, change_case, look_up, number, vtk_array

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
        """With half-widths of a thousandth of the pin's radius: a finite pin adds some 2.6 b/R p0 to the stress along its surface."""
        for friction in (0.1, 0.3, 0.5):
            summary = self.solved(friction, "field", accuracy="0.005 %", changes={
                "Mechanism/Driver speed": "50 rpm", "Mechanism/Load inertia": "0.0001 kg.m^2", "Mechanism/Friction moment": "0.02 N.m"})
            self.assert_close(look_up(summary, "contact.peak_pressure.value"), look_up(summary, "hertz.peak_pressure.value"),
                              0.005, "similar bodies keep Hertz's pressure")
            for side in ("source", "target"):
                self.assertLess(look_up(summary, f"contact.stress_difference_{side}"), 0.02, (friction, side))
            peak = look_up(summary, "hertz.peak_pressure.value")
            self.assert_close(look_up(summary, "contact.friction.surface_tension.value"), 2 * friction * peak, 0.02,
                              f"behind the pin, mu = {friction}")
            self.assert_close(look_up(summary, "contact.friction.surface_compression.value"),
                              peak * math.sqrt(1 + 4 * friction**2), 0.02, f"below the pin, mu = {friction}")
            rows = {row["quantity"]: row for row in summary["comparison"]}
            self.assert_close(number(rows["maximum shear"]["computed"]), number(rows["maximum shear"]["closed_form"]), 0.02,
                              f"maximum shear, mu = {friction}")
            if friction == 0.5:
                self.assertLess(number(rows["its depth"]["computed"]), 0.05 * look_up(summary, "contact.half_width.value"))
            else:
                self.assert_close(number(rows["its depth"]["computed"]), number(rows["its depth"]["closed_form"]), 0.1, "its depth")

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
        self.assert_close(look_up(summary, "contact.friction.force.value"), 0.3 * force, 1e-6, "mu F")
        self.assertLess(look_up(summary, "equilibrium.force_residual"), 1e-6)

    def test_a_roller_has_no_friction_on_the_wall(self):
        case = self.case(0, "roller", changes={"Mechanism/Pin type": "roller", "Mechanism/Roller bore diameter": "8 mm",
                                               "Mechanism/Roller bore friction": "0.1"})
        self.assertNotIn("friction", self.run_case(case)["contact"])


CYLINDER = """
set Title        = stick and slip
set Model        = geometry
set Output units = SI
set Accuracy     = 0.5 %
set Structural accuracy = off
subsection Geometry
  set Length unit   = mm
  set Thickness     = 1 mm
  set Bodies        = cylinder, block
  set Loads         = cylinder core, block bottom
  set Contact pairs = cylinder surface -> block top
  set Friction coefficient = 0.3
  set Load steps    = steps.csv
  subsection Body cylinder
    set Young's modulus = 210 GPa
  end
  subsection Body block
    set Young's modulus = 210 GPa
  end
  subsection Load cylinder core
    set Type      = force
    set Value     = 6 N
    set Direction = 0, -1
  end
  subsection Load block bottom
    set Type      = displacement
    set Value     = {displacement} mm
    set Direction = 1, 0
  end
end
"""

INCLINE = """
set Title        = block on an incline
set Model        = geometry
set Output units = SI
set Accuracy     = 10 %
set Structural accuracy = off
set Maximum refinement levels = 1
subsection Geometry
  set Length unit   = mm
  set Thickness     = 1 mm
  set Bodies        = base, block
  set Supports      = bottom: fixed
  set Contact pairs = underside -> top of base
  set Friction coefficient = 0.3
  subsection Body base
    set Young's modulus = 210 GPa
  end
  subsection Body block
    set Young's modulus = 210 GPa
    set Body force      = {along} MN/m^3, -100 MN/m^3
  end
end
"""

BLOCKS = """
Point(1) = {-40, -20, 0}; Point(2) = {40, -20, 0}; Point(3) = {40, 0, 0}; Point(4) = {-40, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Point(11) = {-10, 0, 0}; Point(12) = {10, 0, 0}; Point(13) = {10, 10, 0}; Point(14) = {-10, 10, 0};
Line(11) = {11, 12}; Line(12) = {12, 13}; Line(13) = {13, 14}; Line(14) = {14, 11};
Curve Loop(2) = {11, 12, 13, 14}; Plane Surface(2) = {2};
Transfinite Curve {1, 3} = 17; Transfinite Curve {2, 4} = 5; Transfinite Curve {11, 13} = 9; Transfinite Curve {12, 14} = 5;
Transfinite Surface {1, 2}; Recombine Surface {1, 2};
Physical Surface("base") = {1}; Physical Surface("block") = {2};
Physical Curve("bottom") = {1}; Physical Curve("top of base") = {3}; Physical Curve("underside") = {11};
"""


class StickAndSlip(CliTest):
    """K. L. Johnson, Contact Mechanics, 1985, 7.2: cylinders pressed together, then moved along each other."""

    MU = 0.3
    LOAD = 6e3  # N/m
    MODULUS = 210e9 / (1 - 0.3**2) / 2

    def setUp(self):
        super().setUp()
        self.half_width = math.sqrt(4 * self.LOAD * 0.01 / (math.pi * self.MODULUS))
        self.peak = math.sqrt(self.LOAD * self.MODULUS / (math.pi * 0.01))

    def case(self, name, displacement, factors):
        directory = self.copy_case("hertz-line-contact", name)
        (directory / "case.prm").write_text(CYLINDER.format(displacement=displacement))
        rows = "".join(f"{time}, {factor}\n" for time, factor in enumerate(factors))
        (directory / "steps.csv").write_text("time [s], block bottom\n" + rows)
        return directory

    def table(self, case, name):
        with open(case / "results" / name, newline="") as file:
            lines = list(csv.reader(file))
        names = [heading.split(" [")[0] for heading in lines[0]]
        return [dict(zip(names, line)) for line in lines[1:]]

    def closed(self, case):
        return [row for row in self.table(case, "contact.csv") if float(row["contact_pressure"]) > 0]

    def bound(self, place, width):
        """sqrt(s^2 - x^2)/a"""
        return math.sqrt(max(0., width**2 - place**2)) / self.half_width

    def difference(self, case, traction):
        """Of the friction from a closed form, root mean square over mu p0."""
        squares = [(float(row["friction_x"]) / (self.MU * self.peak) - traction(float(row["x"])))**2 for row in self.closed(case)]
        return math.sqrt(sum(squares) / len(squares))

    def share(self, step):
        return float(step["friction_force_x"]) / (self.MU * self.LOAD * 1e-3)

    def test_the_stick_zone_and_the_traction_are_cattaneo_s_and_mindlin_s(self):
        for displacement in ("2.2e-5", "4.5e-5", "7e-5"):
            case = self.case(f"to{displacement}", displacement, [0, 1])
            summary = self.run_case(case)
            share = self.share(self.table(case, "steps.csv")[-1])
            stick = self.half_width * math.sqrt(1 - share)
            self.assertLess(self.difference(case, lambda x, c=stick: self.bound(x, self.half_width) - self.bound(x, c)), 0.02, share)
            nodes = self.closed(case)
            spacing = float(nodes[1]["x"]) - float(nodes[0]["x"])
            found = max(abs(float(node["x"])) for node in nodes if node["status"] == "1")
            self.assertLess(abs(found - stick), 1.01 * abs(spacing), "to the nodes")
            self.assertAlmostEqual(look_up(summary, "contact.friction.sticking_share"), stick / self.half_width, delta=0.02)

    def test_a_sphere_slips_back_from_the_edge_as_mindlin_and_deresiewicz_say(self):
        case = self.copy_case("mindlin-sphere", "back")
        (case / "steps.csv").write_text("time [s], block end\n0, 0\n1, 1\n2, 0.2\n")
        for ranks in (None, 2):
            summary = self.run_case(case, ranks=ranks)
            self.assert_energy_balanced(summary)
            self.assertFalse([notice for notice in summary["notices"] if "support" in notice], "the cut of the half has its support")
            rows = {row["quantity"]: row for row in summary["comparison"]}
            share = rows["sticking share of the contact"]
            exact = (1 - 0.75 * 0.8 / 2)**(2 / 3)
            self.assert_close(number(share["closed_form"]), exact, 1e-4, "closed form")
            self.assert_close(number(share["computed"]), exact, 0.05, "to the nodes")
            self.assert_close(number(rows["friction force"]["computed"]), 2.7, 1e-6, "a fifth")
            nodes = [node for node in self.table(case, "contact.csv") if float(node["contact_pressure"]) > 0]
            squares = [(float(node["friction_x"]) - float(node["mindlin_friction"]))**2 for node in nodes]
            self.assertLess(math.sqrt(sum(squares) / len(squares)) / (0.3 * 1456.8), 0.05, "at 5 % accuracy")

    def test_the_closed_form_is_left_out_where_the_load_path_is_another(self):
        """Pressed and moved at once: 21 steps would stick everywhere."""
        case = self.case("at-once", "4.5e-5", [1])
        rows = {row["quantity"]: row for row in self.run_case(case)["comparison"]}
        self.assertIsNone(rows["sticking share of the contact"]["closed_form"])
        self.assertEqual({node["mindlin_friction"] for node in self.table(case, "contact.csv")}, {""})

    def test_unloading_slips_back_from_the_edges(self):
        case = self.case("back", "4.5e-5", [0, 1, 0])
        self.run_case(case)
        steps = self.table(case, "steps.csv")
        most, left = self.share(steps[1]), self.share(steps[2])
        a = self.half_width
        stick, back = a * math.sqrt(1 - most), a * math.sqrt(1 - (most - left) / 2)

        def traction(x):
            return (self.bound(x, a) - self.bound(x, stick)) - 2 * (self.bound(x, a) - self.bound(x, back))

        self.assertLess(self.difference(case, traction), 0.02)

    def test_a_cycle_dissipates_what_the_closed_form_says(self):
        """W = (4/pi) (mu P')^2/E* [F - F^2/2 + (1 - F) ln(1 - F)]."""
        case = self.case("cycle", "4.5e-5", [0, 1, 0, -1, 0, 1])
        self.assert_energy_balanced(self.run_case(case))
        steps = self.table(case, "steps.csv")
        share = self.share(steps[1])
        exact = 4 / math.pi * (self.MU * self.LOAD)**2 / self.MODULUS * (
            share - share**2 / 2 + (1 - share) * math.log(1 - share)) * 1e-3
        self.assert_close(float(steps[-1]["dissipated"]) - float(steps[1]["dissipated"]), exact, 0.03, "heat of a cycle")
        heat = [float(step["dissipated"]) for step in steps]
        self.assertEqual(heat, sorted(heat))
        self.assert_close(float(steps[5]["elastic_energy"]), float(steps[1]["elastic_energy"]), 1e-3, "the same again")
        work = float(steps[5]["work"]) - float(steps[1]["work"])
        self.assert_close(work, heat[5] - heat[1], 0.35, "heat of a step is that of its last friction")

    def history(self, case, *, ranks=None):
        run = self.geneva("cycle", case, ranks=ranks)
        self.assertEqual(run.code, 0, run.describe())
        return json.loads((case / "results" / "load_steps.json").read_text())

    def test_every_load_step_has_its_field(self):
        """Equal bodies: pressed together it is Hertz's pressure at every step, however they are moved along."""
        case = self.case("steps", "4.5e-5", [0, 1, -1])
        history = self.history(case)
        alone = self.run_case(case)
        rows = self.table(case, "steps.csv")
        self.assertEqual(len(history["steps"]), 3)
        results = case / "results"
        envelope = {name: vtk_array(results / "load_steps_envelope.vtu", name) for name in ("von_mises", "von_mises_load_step", "contact_pressure")}
        for number_of_step, (step, row) in enumerate(zip(history["steps"], rows)):
            (contact,) = step["contacts"]
            self.assert_close(number(contact["peak_pressure"]), self.peak, 0.01, "Hertz")
            self.assert_close(number(contact["half_width"]), self.half_width, 0.01, "Hertz")
            self.assert_close(number(contact["friction_force"][0]) + 1, float(row["friction_force_x"]) + 1, 1e-8, "as a run")
            self.assert_close(number(contact["dissipated"]) + 1e-6, float(row["dissipated"]) + 1e-6, 1e-8, "as a run")
            field = vtk_array(results / f"load_steps.{number_of_step}.vtu", "von_mises")
            self.assertTrue(all(here <= most for here, most in zip(field, envelope["von_mises"])))
            at = [i for i, when in enumerate(envelope["von_mises_load_step"]) if when == number_of_step + 1]
            self.assertTrue(at and all(field[i] == envelope["von_mises"][i] for i in at))
            self.assert_close(max(field), max(number(stress["von_mises"]) for stress in step["stresses"]), 1e-6, "greatest")
        self.assert_close(number(history["steps"][-1]["contacts"][0]["peak_pressure"]), look_up(alone, "contact.peak_pressure.value"), 1e-9,
                          "the last step is the run's")
        self.assert_close(max(envelope["contact_pressure"]), number(history["greatest"]["peak_pressure"]), 0.005, "without the correction")
        page = (results / "report.html").read_text()
        for words in ("Over the load steps", "load step 3 of 3", "Heat of friction since the first step"):
            self.assertIn(words, page)
        self.assert_plays(results / "report.html")

    def assert_plays(self, report):
        """The slider moves both pictures of the field and tells the step."""
        move = ("const s = document.querySelector('#cycle-controls input'); s.value = arguments[0]; s.dispatchEvent(new Event('input'));"
                "return [...document.querySelectorAll('.instant img')].map((one) => one.src).concat("
                "document.getElementById('cycle-words').textContent)")
        with Browser() as browser:
            browser.open(report)
            first, last = browser.run(move, 0), browser.run(move, 2)
            self.assertEqual(len(first), 3)
            self.assertEqual(sum(a == b for a, b in zip(first, last)), 0)
            self.assertIn("load step 3 of 3", last[2])
            self.assertEqual([entry["message"] for entry in browser.console()], [])

    def test_the_field_of_a_step_is_that_of_a_run_that_ends_there(self):
        step = self.history(self.case("three", "4.5e-5", [0, 1, 0]))["steps"][1]
        case = self.case("two", "4.5e-5", [0, 1])
        self.run_case(case)
        self.assert_close(number(step["contacts"][0]["friction_force"][0]), float(self.table(case, "steps.csv")[1]["friction_force_x"]),
                          2e-3, "on two meshes")

    def test_ranks_change_no_load_step(self):
        case = self.case("ranks", "4.5e-5", [0, 1, 0])
        histories, fields = [], []
        for ranks in (None, 2):
            histories.append(self.history(case, ranks=ranks))
            envelope = case / "results" / "load_steps_envelope.vtu"
            fields.append({name: sorted(set(vtk_array(envelope, name))) for name in ("von_mises", "principal_stress_1_least")})
        alone, together = histories
        for one, other in zip(alone["steps"], together["steps"]):
            for key in ("peak_pressure", "half_width", "dissipated"):
                self.assert_close(1e-9 + number(other["contacts"][0][key]), 1e-9 + number(one["contacts"][0][key]), 1e-7, key)
            for mine, theirs in zip(one["stresses"], other["stresses"]):
                self.assert_close(number(theirs["first_principal"]), number(mine["first_principal"]), 1e-7, "tension")
        for name in ("von_mises", "principal_stress_1_least"):
            self.assert_close(sum(fields[1][name]), sum(fields[0][name]), 1e-4, f"{name}, whatever the order of the nodes")

    def test_every_limit_is_judged_at_the_step_where_it_is_nearest(self):
        """Pressed in full first."""
        case = self.case("limits", "0", [0])
        (case / "steps.csv").write_text("time [s], cylinder core\n0, 1\n1, 0.25\n2, 0.5\n")
        change_case(case, {"Structural accuracy": "5 %"})
        with open(case / "case.prm", "a") as file:
            for body in ("cylinder", "block"):
                file.write(f"\nsubsection Geometry\nsubsection Body {body}\nset Yield strength = 300 MPa\nend\nend\n")
            file.write("\nsubsection Allowable\nset Contact pressure = 200 MPa\nend\n")
        history = self.history(case)
        rows = {row["quantity"]: row for row in history["safety"]}
        pressed = rows["peak contact pressure (load step 1)"]
        self.assert_close(number(pressed["computed"]), self.peak, 0.01, "Hertz")
        self.assert_close(pressed["factor"], 200e6 / number(pressed["computed"]), 1e-12, "factor")
        self.assertTrue([name for name in rows if name.startswith("contact, first yield")])
        judged = {re.sub(r" \(load step \d\)$", "", name) for name in rows}
        self.assertEqual({row["quantity"] for row in self.run_case(case)["safety"]} - judged, set(), "those of a run")
        self.assertEqual(history["greatest"]["step"], 1)

    def test_a_geometry_without_load_steps_has_no_cycle(self):
        run = self.geneva("cycle", self.copy_case("hertz-line-contact", "none"))
        self.assertEqual(run.code, 1, run.describe())
        for words in ("case.prm", "'Load steps'", "geneva run"):
            self.assertIn(words, run.err)

    def test_all_work_of_steady_sliding_is_heat(self):
        """Once all of it slides no more elastic energy is stored."""
        case = self.case("steady", "1e-3", [0, 1, 2, 3])
        self.run_case(case)
        steps = self.table(case, "steps.csv")
        for before, now in zip(steps[1:], steps[2:]):
            heat = float(now["dissipated"]) - float(before["dissipated"])
            work = float(now["friction_force_x"]) * 1e-6  # m
            self.assert_close(heat, work, 1e-8, "energy balance")
            self.assert_close(float(now["work"]) - float(before["work"]), heat, 1e-8, "work of the support")
            self.assert_close(float(now["elastic_energy"]), float(before["elastic_energy"]), 1e-8, "stored")
            self.assert_close(float(now["friction_force_x"]), self.MU * self.LOAD * 1e-3, 1e-8, "mu P")

    def test_dissimilar_bodies_that_slide_shift_the_pressure(self):
        """Johnson, 8.2: g = arctan(beta mu)/pi, resultant at -(8/3) g a, a = a0/sqrt(1 - 4 g^2); beta = -0.3830."""
        stiff, soft = (210e9, 0.3), (21e9, 0.1)
        compliance = sum((1 - nu**2) / modulus for modulus, nu in (stiff, soft))
        half_width = math.sqrt(4 * self.LOAD * 0.01 * compliance / math.pi)
        peak = math.sqrt(self.LOAD / (math.pi * 0.01 * compliance))
        for product, displacement, to in ((0.05, "5e-3", 1), (0.1, "-5e-3", -1), (0.25, "5e-3", 1)):
            case = self.case(f"shift{product}", displacement, [0, 1])
            change_case(case, {"Geometry/Body block/Young's modulus": "21 GPa", "Geometry/Body block/Poisson's ratio": "0.1",
                               "Geometry/Body cylinder/Poisson's ratio": "0.3", "Accuracy": "0.2 %",
                               "Geometry/Friction coefficient": str(product / 0.38298)})
            summary = self.run_case(case)
            g = math.atan(product) / math.pi
            width = half_width / math.sqrt(1 - 4 * g**2)
            nodes = self.closed(case)
            force = sum(float(node["contact_pressure"]) for node in nodes)
            # On the cylinder; the source is the softer block.
            middle = sum(float(node["contact_pressure"]) * (float(node["x"]) + float(node["slip_x"]))
                         for node in nodes) / force
            self.assertLess(abs(middle - to * 8 / 3 * g * width), 0.004 * half_width, "the finite cylinder bends")
            exact = peak * (1 + 2 * g)**(0.5 + g) * (1 - 2 * g)**(0.5 - g) * math.cos(math.pi * g) / (1 - 4 * g**2)**0.5
            self.assert_close(look_up(summary, "contact.peak_pressure.value"), exact, 0.003, product)

    def test_units_change_nothing(self):
        case = self.case("units", "4.5e-5", [0, 1, 0.2])
        first = self.run_case(case)
        change_case(case, {"Geometry/Load cylinder core/Value": f"{6 / 4.4482216152605:.15g} lbf", "Output units": "in-lbf",
                           "Geometry/Load block bottom/Value": f"{4.5e-5 / 25.4:.15g} in",
                           "Geometry/Body block/Young's modulus": f"{210e9 / 6894.757293168362:.15g} psi"})
        (case / "steps.csv").write_text("time [min], block bottom\n0, 0\n1, 1\n2, 0.2\n")
        second = self.run_case(case)
        for key in ("contact.peak_pressure.value", "contact.friction.force.value", "contact.friction.dissipated.value"):
            self.assert_close(look_up(second, key), look_up(first, key), 1e-8, key)

    def test_ranks_change_nothing(self):
        case = self.case("ranks", "4.5e-5", [0, 1, 0.2])
        self.run_case(case)
        alone = self.table(case, "steps.csv")
        self.run_case(case, ranks=3)
        for one, other in zip(alone, self.table(case, "steps.csv")):
            self.assert_close(float(other["force_y"]), float(one["force_y"]), 1e-7, "pressure")
            self.assertAlmostEqual(float(other["friction_force_x"]), float(one["friction_force_x"]), delta=1e-7)
            self.assertEqual(other["sticking_nodes"], one["sticking_nodes"])

    def incline(self, along, changes=None):
        directory = self.directory / f"incline{along}-{len(list(self.directory.iterdir()))}"
        directory.mkdir()
        (directory / "case.prm").write_text(INCLINE.format(along=along))
        (directory / "geometry.geo").write_text(BLOCKS)
        change_case(directory, changes or {})
        return self.geneva("run", directory), directory

    def test_a_block_stays_on_an_incline_up_to_the_angle_of_friction(self):
        for along in (10, 29.9):
            run, case = self.incline(along)
            self.assertIn(run.code, (0, 2), run.describe())
            self.assert_close(look_up(geneva_cli.read_summary(case / "results"), "contact.friction.force.value"), along / 5, 1e-9, along)
        run, case = self.incline(30.1)
        self.assertEqual(run.code, 2, run.describe())
        for words in ("everything slides", "6.02 N", "allows 6 N", "Friction coefficient"):
            self.assertIn(words, run.err)

    def test_little_friction_and_soft_bodies_hold_as_well(self):
        """Where the corners slip outwards and the nodes between them stick one after the other."""
        for seed in range(8):
            draw = random.Random(seed)
            friction = 10**draw.uniform(-2.5, -0.7)
            along = draw.choice([-1, 1]) * friction * 100 * draw.choice([0.3, 0.6, 0.97, 0.999])
            run, case = self.incline(
                along, {
                    "Geometry/Friction coefficient": friction,
                    "Geometry/Body block/Young's modulus": f"{210 * 10**draw.uniform(-3, 0)} GPa",
                    "Geometry/Body block/Poisson's ratio": draw.uniform(0, 0.49)
                })
            self.assertIn(run.code, (0, 2), run.describe())
            self.assertNotIn("did not settle", run.err)
            self.assert_close(look_up(geneva_cli.read_summary(case / "results"), "contact.friction.force.value"),
                              abs(along) / 5, 1e-6, f"{friction} {along}")

    def test_a_block_that_tips_is_named(self):
        """The resultant leaves the underside where it is twice as great along the incline as across."""
        for friction, along in ((5, 250), (2.2, 210), (20, 1900), (3, -204), (3, 296)):
            with self.subTest(friction=friction, along=along):
                run, _ = self.incline(along, {"Geometry/Friction coefficient": friction})
                self.assertEqual(run.code, 1, run.describe())
                self.assertIn("body 'block' can rotate freely", run.err)
                self.assertIn("tips", run.err)

    def test_a_block_that_much_friction_holds_does_not_tip(self):
        for friction, along in ((5, 150), (2.2, 190), (20, 100), (3, -196)):
            with self.subTest(friction=friction, along=along):
                run, case = self.incline(along, {"Geometry/Friction coefficient": friction})
                self.assertIn(run.code, (0, 2), run.describe())
                self.assertNotIn("did not settle", run.err)
                self.assert_close(look_up(geneva_cli.read_summary(case / "results"), "contact.friction.force.value"),
                                  abs(along) / 5, 1e-6, f"{friction} {along}")

    def test_a_load_step_that_lifts_a_body_is_named(self):
        case = self.case("lifted", "0", [0])
        (case / "steps.csv").write_text("time [s], cylinder core\n0, 1\n1, -1\n")
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("load step 2", run.err)
        self.assertIn("apart", run.err)

    def assert_balanced(self, summary, below):
        for check in summary["checks"]:
            if check["name"].startswith("balance"):
                self.assertLess(check["value"], below, check["name"])

    def test_a_mesh_without_equilibrium_leaves_the_one_before(self):
        """A block balanced on a cylinder by friction alone."""
        case = self.copy_case("hertz-line-contact", "balanced")
        text = (case / "case.prm").read_text()
        for old, new in (("block bottom: fixed", "cylinder core: fixed"), ("= cylinder core\n", "= block bottom\n"),
                         ("cylinder surface -> block top", "block top -> cylinder surface\n  set Friction coefficient = 0.3"),
                         ("Load cylinder core", "Load block bottom"), ("= force", "= pressure"), ("6 N", "0.1 MPa"),
                         ("    set Direction = 0, -1\n", "")):
            self.assertIn(old, text)
            text = text.replace(old, new)
        (case / "case.prm").write_text("set Structural accuracy = off\n" + text)
        run = self.geneva("run", case)
        self.assertEqual(run.code, 2, run.describe())
        self.assertIn("not converged", run.err)
        self.assertEqual(len(geneva_cli.read_summary(case / "results")["checks"]), 5)

    def assert_energy_balanced(self, summary):
        check = {check["name"]: check for check in summary["checks"]}["balance of energy"]
        self.assertTrue(check["passed"])
        self.assertLess(check["value"], 1e-8)

    def test_friction_across_a_gap_is_in_balance(self):
        """Friction acts on either surface where it is undeformed, with the gap for an arm."""
        case = self.case("gap", "4.5e-5", [0, 1])
        geometry = (case / "geometry.geo").read_text()
        (case / "geometry.geo").write_text(re.sub(r"(Point\(1\d\d\) = \{[^,]*, )", r"\g<1>0.05 + ", geometry))
        self.assert_balanced(self.run_case(case), 1e-6)

    def test_friction_of_a_node_that_a_support_holds_acts_on_both_bodies(self):
        case = self.copy_case("flat-patch")
        change_case(case, {"Geometry/Friction coefficient": 0.1})
        self.assert_balanced(self.run_case(case), 1e-9)

    def test_wrong_input_is_named(self):
        case = self.case("wrong", "1e-5", [0, 1])

        def assert_refused(*words):
            run = self.geneva("run", case)
            self.assertEqual(run.code, 1, run.describe())
            for word in words:
                self.assertIn(word, run.err)

        for steps, words in (("time [s], top\n0, 1\n", "the column 'top'"), ("time [s], block bottom\n", "no load step"),
                             ("time [s], block bottom\n1, 0\n1, 1\n", "line 3: the time 1 does not come after 1"),
                             ("time [s], block bottom\n0, x\n", "'x' is no number"),
                             ("time [s], block bottom\n0, 1, 2\n", "3 numbers"), ("block bottom\n1\n", "the heading is")):
            (case / "steps.csv").write_text(steps)
            assert_refused("steps.csv", words) if "column" not in words else assert_refused("Load steps", words)
        (case / "steps.csv").write_text("time [s], block bottom\n0, 1\n")
        for value, words in (("-0.1", "-0.1"), ("nan", "nan"), ("0.1, 0.2", "there are 2 numbers")):
            change_case(case, {"Geometry/Friction coefficient": value})
            assert_refused("Friction coefficient", words)
        change_case(case, {"Geometry/Friction coefficient": "0.3", "Geometry/Load steps": "none.csv"})
        assert_refused("none.csv")


if __name__ == "__main__":
    geneva_cli.main()
