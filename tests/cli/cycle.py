"""`geneva cycle`: the contact over the whole engagement, on both walls, and what is refused."""

import csv
import json
import math
import re

import geneva_cli
from browser import Browser
from geneva_cli import CliTest, change_case, vtk_array

DEGREE = math.pi / 180


class Cycle(CliTest):

    def cycle(self, case, *arguments, ranks=None, code=0):
        run = self.geneva("cycle", case, *arguments, ranks=ranks)
        self.assertEqual(run.code, code, run.describe())
        return json.loads((case / "results" / "cycle.json").read_text())

    def changed(self, name, changes, to=None):
        case = self.copy_case(name, to)
        change_case(case, changes)
        return case

    def assert_hertz(self, cycle, within):
        """Of what Hertz's theory covers."""
        solved = [instant for instant in cycle["instants"] if instant["contact"]]
        self.assertEqual(len(solved), len(cycle["instants"]))
        covered = [instant for instant in solved if not instant["contact"]["hertz_objection"]]
        self.assertGreater(len(covered), 5)
        for instant in covered:
            self.assert_close(instant["contact"]["peak_pressure"]["value"], instant["hertz_pressure"]["value"], within,
                              instant["driver_angle"]["value"] / DEGREE)

    def assert_torque(self, cycle):
        for instant in cycle["instants"]:
            contact = instant["contact"]
            self.assert_close(contact["bore_torque"]["value"], contact["expected_bore_torque"]["value"], 2e-3,
                              instant["driver_angle"]["value"] / DEGREE)

    def role(self, cycle, role):
        found = [instant for instant in cycle["instants"] if instant["role"] == role]
        self.assertEqual(len(found), 1, role)
        return found[0]

    def test_the_engagement_of_johnson_s_wheel_is_hertz_at_every_instant(self):
        case = self.copy_case("johnson-optimum-wheel")
        cycle = self.cycle(case)
        self.assert_hertz(cycle, 0.005)
        self.assert_torque(cycle)
        greatest = self.role(cycle, "greatest force")
        self.assertAlmostEqual(greatest["driver_angle"]["value"] / DEGREE, -9.9336, delta=1e-3)
        self.assertEqual(cycle["greatest"], greatest)
        braking = self.role(cycle, "greatest braking force")
        self.assertAlmostEqual(braking["driver_angle"]["value"] / DEGREE, 9.9537, delta=1e-3)
        self.assertEqual(braking["wall"], "braking")
        self.assertLess(braking["contact"]["bore_torque"]["value"], 0, "the shaft pushes the wheel on")
        (change,) = cycle["wall_changes"]
        self.assertAlmostEqual(change["value"] / DEGREE, 0.0517, delta=1e-4)
        for role, side in (("entry", 1), ("exit", -1)):
            self.assertGreater(side * self.role(cycle, role)["driver_angle"]["value"], side * -side * 45 * DEGREE)
        work = {name: quantity["value"] for name, quantity in cycle["work"].items() if isinstance(quantity, dict)}
        self.assertAlmostEqual(work["pin"] / work["driving"], work["energy_change"] / work["driving"], delta=1e-6)
        self.assertEqual(work["friction"], 0)
        with open(case / "results" / "cycle.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), len(cycle["instants"]))
        series = (case / "results" / "cycle.pvd").read_text()
        self.assertEqual(series.count("<DataSet"), len(cycle["instants"]))
        self.assertTrue((case / "results" / f"cycle.{len(cycle['instants']) - 1}.vtu").exists())
        passing = 6894.757293168362 * max(vtk_array(case / "results" / "envelope.vtu", "contact_pressure"))
        self.assert_close(passing, max(value for value in cycle["curve"]["peak_pressure"] if value is not None), 0.002,
                          "contact pressure of the envelope")
        for stress in cycle["stresses"]:
            if stress["quantity"] != "tensile stress":
                continue
            self.assertLessEqual(stress["least"]["value"], 0)
            self.assertEqual(stress["range"]["value"], stress["value"]["value"] - stress["least"]["value"])
        least = vtk_array(case / "results" / "envelope.vtu", "principal_stress_1_least")
        self.assertLessEqual(max(least), 0)
        self.assertLess(min(least), -1000, "the walls are pressed where they were pulled")
        greatest_stress = max(vtk_array(case / "results" / "envelope.vtu", "von_mises"))
        for i in range(len(cycle["instants"])):
            self.assertLessEqual(max(vtk_array(case / "results" / f"cycle.{i}.vtu", "von_mises")), 1.02 * greatest_stress, i)
        self.assert_bore_is_round(case / "results" / "cycle.0.vtu")
        page = (case / "results" / "report.html").read_text()
        self.assertIn("Over the engagement", page)
        self.assertIn("chart-cycle-pressure", page)
        frames = json.loads(re.search(r'id="cycle-data">\s*(.*?)\s*</script>', page).group(1))
        self.assertEqual([frame["driver_angle"] for frame in frames],
                         [instant["driver_angle"]["value"] for instant in cycle["instants"]])
        self.assertEqual(len({frame["wheel"] for frame in frames}), len(frames), "every instant has a picture of its own")
        self.assertLess(len(page), 3e6)

    def assert_bore_is_round(self, field):
        """The nodes nearest to the wheel's axis follow a circle, one every 2.5 degrees or closer."""
        points = vtk_array(field, "Points")
        places = [points[i:i + 2] for i in range(0, len(points), 3)]
        radius = min(math.hypot(*place) for place in places)
        angles = sorted({round(math.degrees(math.atan2(y, x)), 3) for x, y in places if math.hypot(x, y) < (1 + 1e-4) * radius})
        gaps = [after - before for before, after in zip(angles, [*angles[1:], angles[0] + 360])]
        self.assertLess(max(gaps), 2.51)

    def test_twice_as_many_instants_find_the_same(self):
        """The curve between them, too, where the coarser ones stand."""
        greatest = []
        passing = []
        for count in (11, 21):
            cycle = self.cycle(case := self.changed("johnson-optimum-wheel", {
                "Mechanism/Instants": count, "Accuracy": "1 %", "Structural accuracy": "off"
            }, f"with-{count}"))
            self.assertEqual(len({round(instant["time"]["value"], 12) for instant in cycle["instants"]}), len(cycle["instants"]))
            greatest.append(max(value for value in cycle["curve"]["peak_pressure"] if value is not None))
            passing.append(max(vtk_array(case / "results" / "envelope.vtu", "contact_pressure")))
            self.assert_contact_leaves_a_band(case)
        self.assert_close(greatest[0], greatest[1], 0.005, "greatest pressure of the curve")
        self.assert_close(passing[0], passing[1], 0.005, "contact pressure of the envelope")

    def assert_contact_leaves_a_band(self, case):
        """Johnson 1985, 4.2: 0.39 to 0.4 p0 down to a tenth of b below walls and pin, between the instants, too."""
        envelope = case / "results" / "envelope.vtu"
        pressure, von_mises = vtk_array(envelope, "contact_pressure"), vtk_array(envelope, "von_mises")
        passed = [i for i, here in enumerate(pressure) if here > 0]
        self.assertGreater(len(passed), 100)
        for i in passed:
            self.assertGreater(von_mises[i], 0.385 * pressure[i])

    def test_a_block_of_wall_keeps_its_contact_where_it_is(self):
        """Its nodes are not those of a wall along which the pin passes."""
        case = self.changed("johnson-optimum-wheel", {"Mechanism/Instants": 5, "Accuracy": "2 %", "Structural accuracy": "off",
                                                      "Mechanism/Contact model": "local"})
        cycle = self.cycle(case)
        self.assertNotIn("contact_pressure", (case / "results" / "envelope.vtu").read_text())
        greatest = cycle["greatest"]["contact"]["peak_pressure"]["value"]
        found = 6894.757293168362 * max(vtk_array(case / "results" / "envelope.vtu", "von_mises"))
        self.assert_close(found / greatest, 0.557, 0.05, "Hertz's line contact, at the instant of the greatest pressure")

    def test_ranks_share_the_instants(self):
        case = self.changed("irregular-two-pin", {"Accuracy": "2 %", "Structural accuracy": "off"})
        self.cycle(case)
        alone = (case / "results" / "cycle.csv").read_text()
        shared = self.cycle(case, ranks=2)
        self.assertEqual((case / "results" / "cycle.csv").read_text(), alone)
        self.assertEqual(shared["ranks"], 2)
        self.assertEqual(shared["equal_engagements"], 1, "the other pin does the same")

    def test_internal_spherical_and_servo_wheels(self):
        for name in ("internal-six-station", "spherical-eight-station", "servo-cycloidal"):
            cycle = self.cycle(self.changed(name, {"Accuracy": "2 %", "Structural accuracy": "off", "Mechanism/Instants": 9}))
            self.assert_hertz(cycle, 0.015)
            if name == "internal-six-station":
                self.assert_torque(cycle)
            walls = {instant["wall"] for instant in cycle["instants"]}
            self.assertEqual(walls, {"driving", "braking"}, name)

    def test_friction_jumps_where_slip_turns_round_and_takes_work(self):
        case = self.changed("johnson-optimum-wheel", {"Mechanism/Slot friction": 0.2, "Accuracy": "2 %", "Structural accuracy": "off"})
        cycle = self.cycle(case)
        self.assert_torque(cycle)
        jumps = [instant for instant in cycle["instants"] if instant["role"] == "jump" and instant["wall"] == "driving"]
        self.assertGreaterEqual(len(jumps), 1)
        beside = [instant for instant in cycle["instants"] if abs(instant["driver_angle"]["value"] / DEGREE + 8.177) < 0.002]
        slips = [instant["slip_speed"]["value"] for instant in beside]
        self.assertLess(min(slips), 0)
        self.assertGreater(max(slips), 0)
        heat = 0.
        curve = cycle["curve"]
        times = [instant["time"]["value"] for instant in cycle["instants"]]
        step = 45 * 2 * DEGREE / 200 / (600 * math.pi / 30)
        for force, slip in zip(curve["pin_force"], curve["slip_speed"]):
            heat += 0.2 * abs(force * slip) * step
        self.assertLess(min(times), 0)
        self.assert_close(cycle["work"]["friction"]["value"], heat, 0.01, "heat")
        thickness = 0.6795 * 0.0254
        for heat_per_area, place in (("wall_heat", "pin_distance"), ("pin_heat", "pin_turn")):
            places = [value * (1 if place == "pin_distance" else 0.5 * 0.6795 * 0.0254) for value in curve[place]]
            heats = [value or 0. for value in curve[heat_per_area]]
            total = sum(0.5 * (heats[i] + heats[i + 1]) * abs(places[i + 1] - places[i]) for i in range(len(heats) - 1))
            self.assert_close(total * thickness, cycle["work"]["friction"]["value"], 0.03, heat_per_area)
        self.assertLess(cycle["work"]["driving_efficiency"], 1)

    def test_a_roller_is_solved_at_every_instant(self):
        cycle = self.cycle(self.changed("indexing-table-roller", {"Accuracy": "3 %", "Structural accuracy": "off", "Mechanism/Instants": 9}))
        self.assert_hertz(cycle, 0.03)

    def test_wrong_input_is_named(self):
        def assert_refused(case, *words):
            run = self.geneva("cycle", case)
            self.assertEqual(run.code, 1, run.describe())
            for word in words:
                self.assertIn(word, run.err)
            self.assertFalse((case / "results").exists())

        assert_refused(self.changed("johnson-optimum-wheel", {"Mechanism/Instants": 2}, "few"), "Instants", "3")
        assert_refused(self.copy_case("hertz-line-contact"), "'Load steps'", "geneva run")
        assert_refused(self.copy_case("synthesis-quick-return"), "geneva cycle")

    def test_the_verdict_of_a_run_uses_what_the_cycle_knows(self):
        case = self.changed("six-station-cycle", {
            "Accuracy": "2 %", "Structural accuracy": "off", "Mechanism/Instants": 7
        })
        with open(case / "case.prm", "a") as file:
            file.write("subsection Allowable\n  set Contact pressure = 300 MPa\nend\n")
        cycle = self.cycle(case)
        run = self.geneva("run", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertTrue((case / "results" / "cycle.json").exists(), "a run of the same case leaves it")
        page = (case / "results" / "report.html").read_text()
        self.assertIn("The same limits over the engagement", page)
        self.assertNotIn("How near to the limits over the engagement", page)
        factor = 300e6 / cycle["greatest"]["contact"]["peak_pressure"]["value"]
        self.assertIn(f"{factor:.3g}", page)
        self.assertIn("exceeded", page)
        safety, = cycle["safety"]
        self.assert_close(safety["factor"], factor, 1e-12, "factor of the cycle")
        self.assertIn("least safety factor</span>", page)
        self.check_playing(case / "results" / "report.html")

    def test_fatigue_is_judged_by_the_range(self):
        case = self.changed("six-station-cycle", {
            "Accuracy": "2 %", "Mechanism/Instants": 7, "Mechanism/Wheel material/Fatigue strength": "300 MPa"
        })
        for ranks in (None, 2):
            cycle = self.cycle(case, ranks=ranks)
            (wheel,) = [one for one in cycle["stresses"] if (one["body"], one["quantity"]) == ("wheel", "tensile stress")]
            self.assertLess(wheel["least"]["value"], 0, "the other wall bends the arm back")
            limit, = [row for row in cycle["safety"] if "fatigue" in row["quantity"]]
            self.assert_close(limit["factor"], 300e6 / (wheel["value"]["value"] - wheel["least"]["value"]), 1e-9, "factor")

    def check_playing(self, report):
        """One slider moves field, mechanism and cursor; the mechanism's own slider takes the field along."""
        state = ("return [document.getElementById('cycle-wheel').src, document.getElementById('mechanism-drawing').dataset.wheelAngle,"
                 "document.getElementById('cycle-words').textContent, document.querySelector('#cycle-controls input').value]")
        move = ("const s = document.querySelector(arguments[0]); s.value = arguments[1]; s.dispatchEvent(new Event('input'));" + state)
        with Browser() as browser:
            browser.open(report)
            start = browser.run(state)
            first = browser.run(move, "#cycle-controls input", 0)
            self.assertEqual(sum(a == b for a, b in zip(start, first)), 0)
            self.assertIn("driver angle -", first[2])
            follows = browser.run(move, "#mechanism-controls input", browser.run(
                "return document.querySelector('#mechanism-controls input').max / 2"))
            self.assertNotIn(follows[0], (start[0], first[0]))
            browser.run("document.querySelector('#cycle-controls button').click()")
            self.assertTrue(browser.wait_for(f"return document.querySelector('#cycle-controls input').value != {follows[3]}"))
            self.assertEqual([entry["message"] for entry in browser.console()], [])


class NearTheRoundBottom(CliTest):
    """Where a pin of the slot's width all but fits its bottom, the node that touches first may not be the one that carries."""

    def peak(self, case):
        return geneva_cli.look_up(self.run_case(case), "contact.peak_pressure.value")

    def test_the_contact_is_found(self):
        case = self.copy_case("johnson-optimum-wheel")
        for angle in ("-0.01 deg", "-0.03 deg", "0.02 deg", "-2.44460782 deg"):
            change_case(case, {"Mechanism/Driver angle": angle, "Accuracy": "2 %", "Structural accuracy": "off"})
            summary = self.run_case(case)
            self.assert_close(geneva_cli.look_up(summary, "equilibrium.bore_torque.value"),
                              geneva_cli.look_up(summary, "equilibrium.expected_bore_torque.value"), 2e-3, angle)

    def test_a_roller_and_its_stud_are_found(self):
        case = self.copy_case("indexing-table-roller")
        for angle in ("-0.13925397959533656 rad", "-0.0786 rad"):
            change_case(case, {"Mechanism/Driver angle": angle, "Accuracy": "5 %", "Structural accuracy": "off"})
            summary = self.run_case(case)
            self.assert_close(self.peak(case), geneva_cli.look_up(summary, "hertz.peak_pressure.value"), 0.05, angle)


if __name__ == "__main__":
    geneva_cli.main()
