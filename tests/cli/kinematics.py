"""`geneva kinematics`: characteristic values of every mechanism, its curves, and what is refused."""

import json
import math

import closed_forms
import geneva_cli
from bad_input import Refusals
from closed_forms import RPM
from geneva_cli import CliTest, change_case, files_of, timeless_files_of, look_up, number, read_csv, set_parameter, unit_of

DEGREE = math.pi / 180
OWN_FILES = ["kinematics.csv", "kinematics.json"]
FILES = [*OWN_FILES, "mechanism.json", "report.html"]
COLUMNS = ["driver_angle", "wheel_angle", "speed_ratio", "acceleration_ratio", "jerk_ratio", "pin_distance",
           "slip_speed", "pin_force", "hertz_pressure", "wall", "time", "driver_speed", "driver_acceleration",
           "travel_speed", "slip_speed_driving", "slip_speed_braking", "bore_speed"]
SIX, INTERNAL, SPHERE = "six-station-360rpm", "internal-six-station", "spherical-eight-station"
PINS, LINKAGE = "irregular-two-pin", "four-bar-geneva"
HARMONIC, CYCLOIDAL = "servo-harmonic", "servo-cycloidal"

# Lecture 4 and ME341, driver of unit speed: maximum speed and acceleration, recomputed in double precision.
EXTERNAL_TABLE = {3: (6.4641, 31.392), 4: (2.41421, 5.4070), 5: (1.42592, 2.2988), 6: (1.0, 1.3496), 7: (None, 0.92840),
                  8: (0.61991, 0.69976), 9: (None, 0.55908), 10: (None, 0.46484)}
INTERNAL_TABLE = {3: (0.46410, 1.73205), 4: (0.41421, 1.0), 5: (0.37019, 0.72654), 6: (0.33333, 0.57735),
                  8: (0.27677, 0.41421)}
# with the angle of the maximum acceleration before the line of centres
SPHERICAL_TABLE = {3: (1.73205, 2.1716, 18.28), 4: (1.0, 0.88009, 30.36), 5: (0.72654, 0.57875, 41.31),
                   6: (0.57735, 0.45597, 53.26), 8: (0.41421, 0.35355, 90.0)}
# maximum pin force over that at the maximum acceleration with inertia alone, and its angle before the line of centres
FORCE_TABLE = {3: (1.0176, 4.12), 4: (1.0172, 9.94), 5: (1.0167, 15.27), 6: (1.0160, 19.965), 8: (1.0144, 27.76),
               10: (1.0129, 34.01)}


def read_kinematics(directory):
    return json.loads((directory / "kinematics.json").read_text())


class Kinematics(CliTest):
    """Shared: running the command on a shipped case, changed or not, or on one that is written."""

    def kinematics(self, case, *arguments, results=None):
        run = self.geneva("kinematics", case, *arguments)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.err, "")
        return read_kinematics(results or case / "results")

    def changed(self, name, changes):
        case = self.copy_case(name, f"case-{len(list(self.directory.iterdir()))}")
        change_case(case, {f"Mechanism/{path}": value for path, value in changes.items()})
        return case

    def curves(self, case):
        return read_csv(case / "results" / "kinematics.csv")

    def write_case(self, parameters):
        """A mechanism with inertia only, at 60 rpm."""
        case = self.directory / f"case-{len(list(self.directory.iterdir()))}"
        case.mkdir()
        lines = [f"set {name} = {value}" for name, value in
                 {"Driver speed": "60 rpm", "Load inertia": "0.01 kg.m^2", "Wheel inertia": "0.001 kg.m^2",
                  **parameters}.items()]
        (case / "case.prm").write_text("\n".join(["subsection Mechanism", *lines, "end", ""]))
        return case

    def assert_value(self, values, key, expected, tolerance):
        self.assert_close(number(look_up(values, key)), expected, tolerance, key)

    def assert_angle(self, values, key, degrees, tolerance):
        self.assertAlmostEqual(number(values[key]) / DEGREE, degrees, delta=tolerance, msg=key)


class ShippedCases(Kinematics):

    def test_every_mechanism_case_has_its_closed_values(self):
        for case, closed in closed_forms.kinematics().items():
            values = self.kinematics(self.source / "cases" / case, "--output", self.directory / case,
                                     results=self.directory / case)
            for key, expected in closed.items():
                with self.subTest(f"{case}: {key}"):
                    found = number(look_up(values, key))
                    # angles are found from slopes, which roundings blur more
                    tolerance = 1e-9 if key.endswith("_angle") else 1e-10
                    self.assertLessEqual(abs(found - expected), tolerance * max(abs(expected), 1e-3))
            self.assertEqual(values["bounded"], case != CYCLOIDAL)
            self.assertEqual(values["case"]["name"], case)
            self.assertLess(number(values["entry_tangency"]), 1e-9)
            self.assertLess(number(values["exit_tangency"]), 1e-9)

    def test_the_lectures_example_with_what_it_prints_wrongly(self):
        """ME341, six stations at 360 rpm."""
        values = self.kinematics(self.copy_case(SIX))
        speed = number(values["reference_speed"])
        self.assert_value(values, "reference_speed", 37.699, 1e-5)
        self.assertAlmostEqual(1 / (number(values["motion_time"]) + number(values["dwell_time"][0])), 6, 9)
        self.assert_value(values, "motion_time", 1 / 18, 1e-12)
        self.assert_value(values, "dwell_time.0", 1 / 9, 1e-12)  # printed: 0.0555 s
        self.assert_value(values, "motion_fraction", 1 / 3, 1e-12)  # printed as that of the dwell
        self.assert_close(values["peak_speed_ratio"] * speed, 37.699, 1e-5, "maximum speed")
        self.assert_value(values, "peak_acceleration_ratio", 1.3496, 3e-5)  # printed: 1.372
        self.assert_close(values["peak_acceleration_ratio"] * speed**2, 1918.14, 3e-6, "printed: 1950")
        self.assert_angle(values, "peak_acceleration_angle", -22.903, 5e-4)

    def test_a_law_on_the_cross_moves_the_carrier_as_kolomiets_says(self):
        """Z = 6, speeds over (carrier engagement)/(motion time): printed 1.412 at the ends, and halved midway."""
        for name, ends, middle in ((HARMONIC, 1.5 * math.sqrt(math.pi * math.sqrt(3) / 6), math.pi / 4),
                                   (CYCLOIDAL, 0.0, 1.0)):
            case = self.copy_case(name)
            values = self.kinematics(case, "--steps", "720")
            curves = self.curves(case)
            speed = number(values["reference_speed"]) / RPM
            for angle, expected in ((-60, ends), (0, middle), (60, ends)):
                row = min(range(len(curves["wall"])), key=lambda i: abs(curves["driver_angle [deg]"][i] - angle))
                self.assertAlmostEqual(curves["driver_angle [deg]"][row], angle, 9)
                self.assertAlmostEqual(curves["driver_speed [rpm]"][row] / speed, expected, delta=1e-7)
        self.assertAlmostEqual(1.5 * math.sqrt(math.pi * math.sqrt(3) / 6), 1.42847, 5)

    def test_the_cycloidal_law_on_the_cross_has_no_bounded_carrier(self):
        case = self.copy_case(CYCLOIDAL)
        run = self.geneva("kinematics", case)
        values = read_kinematics(case / "results")
        self.assertFalse(values["bounded"])
        places = [(number(place["driver_angle"]) / DEGREE, number(place["time"])) for place in values["unbounded"]]
        for (angle, time), sign in zip(places, (-1, 1), strict=True):
            self.assertAlmostEqual(angle, sign * 60, 9)
            self.assertAlmostEqual(time, sign * 0.025, 12)
        self.assertEqual({place["quantity"] for place in values["unbounded"]}, {"driver acceleration"})
        self.assertEqual(run.out.count("not bounded: the driver acceleration"), 2)
        # and grows as k^(-1/2): pi sqrt(3/2 alpha cot(alpha))/T^2 times that
        curves = self.curves(case)
        begin = next(i for i, wall in enumerate(curves["wall"]) if wall != "none")
        factor = math.pi * math.sqrt(1.5 * math.pi / 6 * math.sqrt(3)) / 0.05**2
        for row, tolerance in ((begin + 1, 0.02), (begin + 2, 0.03)):
            k = curves["time [s]"][row] / 0.05 + 0.5
            found = curves["driver_acceleration [rad/s^2]"][row]
            self.assert_close(found, factor / math.sqrt(k), tolerance, f"k = {k}")

    def test_unequal_pins_have_equal_motions_and_unequal_dwells(self):
        case = self.copy_case(PINS)
        values = self.kinematics(case)
        self.assertEqual([round(number(time), 12) for time in values["dwell_time"]], [round(1 / 48, 12), 0.0625])
        curves = self.curves(case)
        walls = curves["wall"]
        entries = [i for i in range(1, len(walls)) if walls[i] != "none" and walls[i - 1] == "none"]
        self.assertEqual([round(curves["driver_angle [deg]"][i], 6) for i in entries], [-60, 90])
        # a pitch in each engagement
        self.assertAlmostEqual(curves["wheel_angle [deg]"][-1] - curves["wheel_angle [deg]"][0], 120, 9)

    def test_an_internal_wheel_is_loaded_most_at_entry(self):
        values = self.kinematics(self.copy_case(INTERNAL))
        self.assertEqual(values["entry_acceleration_ratio"], values["peak_acceleration_ratio"])
        self.assert_angle(values, "peak_acceleration_angle", -120, 1e-9)
        self.assert_value(values, "peak_acceleration_ratio", math.tan(math.pi / 6), 1e-12)


class Tables(Kinematics):
    """The sources' tables, to the digits given."""

    def assert_table(self, values, speed, acceleration):
        if speed is not None:
            self.assert_value(values, "peak_speed_ratio", speed, 2e-5)
        self.assert_value(values, "peak_acceleration_ratio", acceleration, 3e-5)

    def test_external(self):
        for n, (speed, acceleration) in EXTERNAL_TABLE.items():
            values = self.kinematics(self.write_case({"Stations": n, "Wheel diameter": "120 mm"}), "--steps", "1")
            self.assert_table(values, speed, acceleration)
            self.assert_value(values, "entry_acceleration_ratio", math.tan(math.pi / n), 1e-10)
            self.assert_value(values, "time_ratio", (n - 2) / (n + 2), 1e-10)
            self.assertGreater(values["peak_pressure_times_slip_ratio"], 1)
            if n in FORCE_TABLE:
                ratio, angle = FORCE_TABLE[n]
                self.assert_value(values, "peak_force_ratio", ratio, 5e-5)
                self.assert_angle(values, "peak_force_angle", -angle, 5.1e-3)
                self.assert_value(values, "peak_hertz_pressure_ratio", math.sqrt(values["peak_force_ratio"]), 1e-9)
        jerks = {3: 672.02, 4: 48.042, 5: 13.324, 6: 6.0}
        for n, jerk in jerks.items():
            values = self.kinematics(self.write_case({"Stations": n, "Wheel diameter": "120 mm"}), "--steps", "1")
            self.assert_value(values, "jerk_ratio_at_centre", -jerk, 2e-5)

    def test_internal(self):
        for n, (speed, acceleration) in INTERNAL_TABLE.items():
            values = self.kinematics(self.write_case({"Type": "internal", "Stations": n, "Crank radius": "40 mm"}))
            self.assert_table(values, speed, acceleration)
            self.assert_value(values, "time_ratio", (n + 2) / (n - 2), 1e-10)

    def test_spherical(self):
        for n, (speed, acceleration, angle) in SPHERICAL_TABLE.items():
            values = self.kinematics(self.write_case({"Type": "spherical", "Stations": n, "Sphere radius": "80 mm",
                                                      "Contact model": "local"}))
            self.assert_table(values, speed, acceleration)
            self.assert_angle(values, "peak_acceleration_angle", -angle, 5.1e-3)
            self.assert_angle(values, "engagement_angle", 180, 1e-9)

    def test_small_and_great_shaft_angles_are_nearly_plane(self):
        for angle, name in (("0.1 deg", "external"), ("179.9 deg", "internal")):
            sphere = self.kinematics(self.write_case({"Type": "spherical", "Stations": 5, "Sphere radius": "1 m",
                                                      "Shaft angle": angle, "Contact model": "local"}))
            plane = self.kinematics(self.write_case({"Type": name, "Stations": 5, "Crank radius": "40 mm"}))
            for key in ("peak_speed_ratio", "peak_acceleration_ratio", "engagement_angle"):
                self.assert_value(sphere, key, number(plane[key]), 1e-4)

    def test_a_chain_without_spacing_is_an_external_geneva(self):
        plane = self.kinematics(self.write_case({"Stations": 5, "Crank radius": "40 mm"}))
        for line in ("along line of centres", "across line of centres"):
            chain = self.kinematics(self.write_case({"Type": "long dwell", "Stations": 5, "Crank radius": "40 mm",
                                                     "Sprocket line": line, "Contact model": "local"}))
            for key in ("peak_speed_ratio", "peak_acceleration_ratio", "peak_force", "time_ratio"):
                self.assert_value(chain, key, number(plane[key]), 1e-10)

    def test_a_parallelogram_is_an_external_geneva(self):
        """Also where it turns through the positions in which all links are in line."""
        links = {"Crank": "40 mm", "Rocker": "40 mm", "Coupler": "100 mm", "Frame": "100 mm"}
        sizes = {"Pin diameter": "10 mm", "Wheel thickness": "10 mm"}
        plane = self.kinematics(self.write_case({"Stations": 5, "Crank radius": "40 mm", **sizes}))
        for direction in ("0 deg", "90 deg", "180 deg"):
            case = self.copy_case(LINKAGE, f"direction-{direction[:-4]}")
            changes = {"Stations": 5, "Driver speed": "60 rpm", "Friction moment": None, "Wheel inertia": "0.001 kg.m^2",
                       "Load inertia": "0.01 kg.m^2", "Load diameter": None, "Load length": None, "Load density": None,
                       "Linkage/Coupler point distance": "50 mm", "Linkage/Wheel direction": direction, **sizes,
                       **{f"Linkage/{name}": length for name, length in links.items()}}
            change_case(case, {f"Mechanism/{path}": value for path, value in changes.items()})
            linkage = self.kinematics(case)
            for key in ("peak_speed_ratio", "peak_acceleration_ratio", "peak_force", "time_ratio"):
                self.assert_value(linkage, key, number(plane[key]), 1e-9)

    def test_a_chain_across_passes_the_wheel_on_a_straight(self):
        case = self.write_case({"Type": "long dwell", "Stations": 6, "Crank radius": "40 mm",
                                "Sprocket spacing": "60 mm", "Sprocket line": "across line of centres",
                                "Contact model": "local"})
        values = self.kinematics(case)
        self.assertTrue(values["bounded"])
        # the straight stretch is (r + (a/2) cos(alpha))/sin(alpha) - r from the wheel's axis, and 2 (r/a) wide
        least = (0.04 + 0.03 * math.cos(math.pi / 6)) / math.sin(math.pi / 6) - 0.04
        self.assert_close(values["peak_speed_ratio"], 0.04 / least, 1e-10, "maximum speed")
        self.assert_value(values, "engagement_angle", 2 * math.pi / 3 + 0.06 / 0.04, 1e-10)
        self.assert_value(values, "time_ratio", (2 * math.pi / 3 + 1.5) / (2 * math.pi / 3 * 2 + 1.5), 1e-10)


class Curves(Kinematics):

    def test_headings_carry_the_units_that_the_case_asks_for(self):
        units = {"SI": ("rad", "m", "m/s", "N", "Pa"), "mm-N": ("deg", "mm", "mm/s", "N", "MPa"),
                 "in-lbf": ("deg", "in", "in/s", "lbf", "psi")}
        for system, (angle, length, speed, force, stress) in units.items():
            case = self.copy_case(SIX, system)
            change_case(case, {"Output units": system})
            self.kinematics(case)
            found = {heading.split(" [")[0]: unit_of(heading) for heading in self.curves(case)}
            self.assertEqual(list(found), COLUMNS)
            for name, unit in (("driver_angle", angle), ("pin_distance", length), ("slip_speed", speed),
                               ("pin_force", force), ("hertz_pressure", stress), ("time", "s"), ("speed_ratio", None)):
                self.assertEqual(found[name], unit, f"{system}: {name}")

    def test_the_pin_goes_from_the_driving_to_the_braking_wall(self):
        for name in (SIX, INTERNAL, SPHERE, LINKAGE, HARMONIC):
            case = self.copy_case(name)
            self.kinematics(case)
            curves = self.curves(case)
            walls = [wall for i, wall in enumerate(curves["wall"]) if i == 0 or wall != curves["wall"][i - 1]]
            self.assertEqual(walls, ["none", "driving", "braking", "none"], name)
            for wall, force, pressure in zip(curves["wall"], curves["pin_force [N]"], curves["hertz_pressure [MPa]"]):
                self.assertEqual((force > 0) - (force < 0), {"driving": 1, "braking": -1, "none": 0}[wall])
                self.assertEqual(pressure > 0, force != 0)

    def test_steps_are_those_asked_for(self):
        case = self.copy_case(SIX)
        for steps, rows in ((720, 721), (12, 13), (1, 4)):  # the ends of the engagement are rows as well
            self.kinematics(case, "--steps", steps)
            self.assertEqual(len(self.curves(case)["wall"]), rows)
        self.kinematics(case)
        self.assertEqual(len(self.curves(case)["wall"]), 721)

    def test_columns_are_the_derivatives_of_each_other(self):
        for name in (SIX, INTERNAL, SPHERE, LINKAGE, HARMONIC):
            case = self.copy_case(name)
            values = self.kinematics(case, "--steps", "7200")
            curves = self.curves(case)
            speed = number(values["reference_speed"])
            time = [speed * entry for entry in curves["time [s]"]]
            wheel = [entry * DEGREE for entry in curves["wheel_angle [deg]"]]
            pairs = ((wheel, curves["speed_ratio"]), (curves["speed_ratio"], curves["acceleration_ratio"]),
                     (curves["acceleration_ratio"], curves["jerk_ratio"]),
                     (curves["pin_distance [mm]"], [entry / speed for entry in curves["travel_speed [mm/s]"]]),
                     ([entry * DEGREE for entry in curves["driver_angle [deg]"]],
                      [entry * RPM / speed for entry in curves["driver_speed [rpm]"]]),
                     ([entry * RPM / speed for entry in curves["driver_speed [rpm]"]],
                      [entry / speed**2 for entry in curves["driver_acceleration [rad/s^2]"]]))
            inside = [i for i, wall in enumerate(curves["wall"]) if wall != "none"]
            for order, (column, rate) in enumerate(pairs):
                if name == SPHERE and order == 3:
                    continue  # there the pin moves along the slot, which is an arc
                scale = max(abs(rate[i]) for i in inside) or 1
                for i in inside[2:-2]:
                    # on a parabola through three rows, whose steps may differ
                    before, after = time[i] - time[i - 1], time[i + 1] - time[i]
                    risen, fallen = column[i + 1] - column[i], column[i] - column[i - 1]
                    found = (risen * before / after + fallen * after / before) / (before + after)
                    self.assertLess(abs(found - rate[i]), 2e-4 * scale, f"{name}, column {order}, row {i}")

    def test_force_pressure_and_moment_belong_together(self):
        """Torque balance, Hertz and the arm, row by row; the motion takes no energy but friction's."""
        case = self.copy_case(SIX)
        values = self.kinematics(case, "--steps", "3600")
        curves = self.curves(case)
        mover = closed_forms.movers()[SIX]
        omega = number(values["reference_speed"])
        work = 0.0
        rows = list(zip(*(curves[name] for name in ("wall", "acceleration_ratio", "pin_distance [mm]", "pin_force [N]",
                                                    "hertz_pressure [MPa]", "wheel_angle [deg]"))))
        for i, (wall, acceleration, distance, force, pressure, angle) in enumerate(rows):
            if wall == "none":
                continue
            moment = (mover.inertia + mover.load_inertia) * acceleration * omega**2 + mover.friction
            self.assertAlmostEqual(force * distance / 1e3, moment, delta=1e-9 * 20)
            self.assert_close(pressure, mover.hertz(force)["peak_pressure"] / 1e6, 1e-9, "pressure")
            if rows[i + 1][0] != "none":
                after = rows[i + 1]
                work += (force * distance + after[3] * after[2]) / 2e3 * (after[5] - angle) * DEGREE
        self.assert_close(work, mover.friction * math.pi / 3, 1e-4, "work of the pin in one engagement")

    def test_inches_and_millimetres_give_the_same(self):
        metric, inches = (self.kinematics(self.write_case({"Stations": 6, "Wheel diameter": wheel,
                                                           "Pin diameter": pin}))
                          for wheel, pin in (("127 mm", "12.7 mm"), ("5 in", "0.5 in")))
        for values in (metric, inches):
            del values["case"]
        for key, value in geneva_cli.flat(metric).items():
            other = geneva_cli.flat(inches)[key]
            if isinstance(value, float):
                self.assertAlmostEqual(value, other, delta=1e-9 * max(abs(value), 1e-3), msg=key)
            else:
                self.assertEqual(value, other, key)


class Loads(Kinematics):

    def test_a_torque_that_drives_the_wheel_takes_the_pin_off_the_driving_wall(self):
        case = self.changed(SIX, {"External torque": "-50 N.m"})
        values = self.kinematics(case)
        self.assertEqual(number(values["peak_force"]), 0)
        self.assertGreater(number(values["peak_braking_force"]), 0)
        for key in ("peak_force_angle", "peak_force_ratio", "peak_hertz_pressure_ratio", "peak_pressure_times_slip_ratio"):
            self.assertIsNone(values[key], key)
        self.assertNotIn("driving", self.curves(case)["wall"])

    def test_johnsons_point_is_where_the_wheel_speeds_up(self):
        """An accelerating driver slows the wheel down more than it speeds it up."""
        case = self.changed(SIX, {"Driver acceleration": "200 rad/s^2"})
        values = self.kinematics(case)
        curves = self.curves(case)
        acceleration = curves["acceleration_ratio"]
        self.assertLess(max(acceleration), -min(acceleration))
        self.assert_close(number(values["peak_acceleration_ratio"]), max(acceleration), 1e-4, "maximum forwards")
        self.assertLess(number(values["peak_acceleration_angle"]), 0)
        self.assertGreater(values["peak_force_ratio"], 1)

    def test_an_external_torque_adds_to_the_friction(self):
        friction = self.kinematics(self.changed(SIX, {"Friction moment": "2 N.m"}))
        torque = self.kinematics(self.changed(SIX, {"Friction moment": "0.5 N.m", "External torque": "1.5 N.m"}))
        for key in ("peak_force", "peak_force_angle", "peak_braking_force", "peak_hertz_pressure"):
            self.assert_close(number(torque[key]), number(friction[key]), 1e-10, key)

    def test_slot_friction_shortens_and_lengthens_the_arm(self):
        """x + mu d/2 while the pin's surface moves inwards on the wall that carries, x - mu d/2 while it moves outwards."""
        coefficient, pin = 0.1, 0.0168
        plain, rough = self.copy_case(SIX), self.changed(SIX, {"Slot friction": coefficient})
        for case in (plain, rough):
            self.kinematics(case)
        without, curves = self.curves(plain), self.curves(rough)
        mover = closed_forms.movers()[SIX]
        compared = against = 0
        for i, wall in enumerate(curves["wall"]):
            if wall == "none":
                continue
            side = 1 if wall == "driving" else -1
            slip = mover.motion.place(curves["driver_angle [deg]"][i] * DEGREE).slip(pin, side).real
            self.assertAlmostEqual(curves["slip_speed [mm/s]"][i], 1e3 * slip, delta=1e-7)
            self.assertEqual(curves["slip_speed [mm/s]"][i], curves[f"slip_speed_{wall} [mm/s]"][i])
            against += slip * curves["travel_speed [mm/s]"][i] < 0  # the surface moves against the pin's axis
            arm = curves["pin_distance [mm]"][i] / 1e3
            lever = -math.copysign(coefficient * pin / 2, slip)
            moment = without["pin_force [N]"][i] * arm
            self.assert_close(curves["pin_force [N]"][i] * (arm + lever), moment, 1e-8, "moment")
            compared += 1
        self.assertGreater(compared, 200)
        self.assertGreater(against, 40)

    ROLLER = {"Pin type": "roller", "Roller bore diameter": "8.4 mm", "Roller bore friction": "0.2"}

    def test_a_roller_slides_in_its_bore_only(self):
        """On the wall it is as rough as a fixed pin with mu_b d_b/d; on its stud it slides with d_b/d of that pin's slip."""
        fixed, roller = self.changed(SIX, {"Slot friction": "0.1"}), self.changed(SIX, self.ROLLER)
        sliding, rolling = self.kinematics(fixed), self.kinematics(roller)
        self.assertEqual((sliding["pin_type"], rolling["pin_type"]), ("fixed", "roller"))
        for key in ("peak_force", "peak_force_angle", "peak_braking_force", "peak_hertz_pressure"):
            self.assert_close(number(rolling[key]), number(sliding[key]), 1e-12, key)
        self.assertEqual(number(rolling["peak_pressure_times_slip"]), 0)
        self.assertIsNone(rolling["peak_pressure_times_slip_angle"])
        self.assertEqual(number(sliding["peak_bore_pressure_times_speed"]), 0)
        without, curves = self.curves(fixed), self.curves(roller)
        maximum = 0.0
        for i, slip in enumerate(without["slip_speed [mm/s]"]):
            for name in ("slip_speed", "slip_speed_driving", "slip_speed_braking"):
                self.assertEqual(curves[f"{name} [mm/s]"][i], 0)
            self.assertEqual(without["bore_speed [mm/s]"][i], 0)
            self.assertAlmostEqual(curves["bore_speed [mm/s]"][i], abs(slip) / 2, delta=1e-8)
            mean = abs(curves["pin_force [N]"][i]) / (8.4 * 16.8)  # MPa
            maximum = max(maximum, mean * curves["bore_speed [mm/s]"][i])
        self.assert_close(number(rolling["peak_bore_pressure_times_speed"]) / 1e3, maximum, 1e-4, "in the bore")

    def test_a_roller_without_friction_has_the_force_of_a_smooth_pin(self):
        smooth, roller = self.copy_case(SIX), self.changed(SIX, {**self.ROLLER, "Roller bore friction": "0"})
        self.kinematics(smooth)
        self.kinematics(roller)
        self.assertEqual(self.curves(smooth)["pin_force [N]"], self.curves(roller)["pin_force [N]"])

    def test_the_force_jumps_where_the_slip_reverses(self):
        """The maximum force of a rough pin is the limit from the hindered side, (x + mu d/2)/(x - mu d/2) of the other."""
        mover = closed_forms.movers()["johnson-optimum-wheel"]
        case = self.changed("johnson-optimum-wheel", {"Slot friction": "0.3"})
        values = self.kinematics(case)
        at = closed_forms.slip_reversals(mover)[0]
        self.assertAlmostEqual(at / DEGREE, -8.1766, 4)
        self.assertAlmostEqual(number(values["peak_force_angle"]), at, delta=1e-8)
        place = mover.motion.place(at)
        smooth = mover.force(at).real * place.pin_distance.real
        self.assert_value(values, "peak_force", smooth / (place.pin_distance.real - 0.3 * mover.pin / 2), 1e-8)

    def test_an_accelerated_driver_adds_its_own_term(self):
        """The equation before ME341, 5.29: a = epsilon dphi/dtheta + omega^2 d2phi/dtheta2."""
        case = self.changed(SIX, {"Driver acceleration": "200 rad/s^2"})
        self.kinematics(case)
        curves = self.curves(case)
        for i, angle in enumerate(curves["driver_angle [deg]"]):
            if curves["wall"][i] == "none":
                continue
            _, first, second = closed_forms.wheel_motion(6, angle * DEGREE, 1.0)
            speed = curves["driver_speed [rpm]"][i] * RPM
            self.assertAlmostEqual(curves["acceleration_ratio"][i] * (360 * RPM)**2, 200 * first + speed**2 * second,
                                   delta=1e-6 * 2000)

    def test_a_table_of_uniform_rotation_is_constant_speed(self):
        case = self.changed(SIX, {"Driver motion": "table", "Motion table": "motion.csv", "Driver speed": None})
        rows = [f"{1e3 * angle / 360 / 6:.17g}, {angle}" for angle in range(-180, 181, 15)]
        (case / "motion.csv").write_text("\n".join(["time [ms], angle [deg]", *rows, ""]))
        values = self.kinematics(case)
        steady = self.kinematics(self.copy_case(SIX))
        for key in ("peak_acceleration_ratio", "peak_force", "motion_time", "time_ratio"):
            self.assert_value(values, key, number(steady[key]), 1e-6)

    def test_a_law_on_the_carrier_starts_and_ends_the_wheel_softly(self):
        case = self.changed(SIX, {"Driver motion": "cycloidal on the carrier", "Motion time": "50 ms",
                                  "Driver speed": None})
        values = self.kinematics(case)
        self.assertTrue(values["bounded"])
        self.assertAlmostEqual(values["entry_acceleration_ratio"], 0, 9)
        self.assertGreater(values["peak_acceleration_ratio"], 1.5)  # more than with the law on the cross

    def test_a_wheel_in_the_wrong_place_starts_with_a_jump(self):
        case = self.changed(LINKAGE, {"Centre distance": "240 mm"})
        values = self.kinematics(case)
        self.assertFalse(values["bounded"])
        self.assertEqual({place["quantity"] for place in values["unbounded"]}, {"wheel acceleration"})
        self.assertGreater(number(values["exit_tangency"]), 0.01)


class Limits(Kinematics):
    """Of a pin in 3-D, whose line load is not even."""

    def judged(self, command, name, changes=None):
        case = self.copy_case(name, f"{command}-{len(list(self.directory.iterdir()))}")
        change_case(case, {"Mechanism/Wheel material/Yield strength": "100000 psi", **(changes or {})})
        run = self.geneva(command, case)
        self.assertEqual(run.code, 0, run.describe())
        document = json.loads((case / "results" / f"{command}.json").read_text())
        return {row["quantity"]: number(row["computed"]) for row in document["safety"]}, run.out

    def test_a_crowned_pin_is_judged_by_its_own_pressure_and_not_by_an_even_one(self):
        estimated, _ = self.judged("estimate", "crowned-pin")
        moved, text = self.judged("kinematics", "crowned-pin")
        self.assertEqual(set(moved), {"contact, first yield, wheel", "contact, shakedown, wheel"})
        for quantity, value in moved.items():
            self.assert_close(value, estimated[quantity], 1e-6, quantity)
            self.assertGreater(value, 800e6, "an even load would be 510 MPa")
        self.assertIn("line contacts along it", text)

    def test_yield_of_a_crowned_pin_with_friction_is_judged_in_no_command(self):
        for command in ("estimate", "kinematics"):
            judged, text = self.judged(command, "crowned-pin", {"Mechanism/Slot friction": 0.1})
            self.assertEqual(judged, {}, command)
            self.assertIn("no closed form for a contact in 3-D with friction", text)

    def test_no_limit_is_judged_where_the_wall_has_sharp_edges(self):
        moved, text = self.judged("kinematics", "johnson-optimum-3d")
        self.assertEqual(moved, {})
        self.assertIn("no limit of the contact is judged", text)

    def test_of_a_plane_case_all_are_judged_as_before(self):
        moved, text = self.judged("kinematics", "johnson-optimum-wheel")
        self.assert_close(moved["contact, first yield, wheel"], 1.0169**0.5 * 501.1e6, 2e-3, "Hertz at the greatest force")
        self.assertNotIn("note: the pressures", text)


class Files(Kinematics):

    def test_they_go_where_they_are_told(self):
        case = self.copy_case(SIX)
        output = self.directory / "there" / "deep"
        self.kinematics(case, "--output", output, results=output)
        self.assertEqual(sorted(files_of(output)), FILES)
        self.assertFalse((case / "results").exists())

    def test_a_run_leaves_them_and_they_leave_the_runs(self):
        case = self.copy_case(SIX)
        self.kinematics(case)
        before = timeless_files_of(case / "results")
        self.assertEqual(sorted(before), FILES)
        self.run_case(case)
        both = timeless_files_of(case / "results")
        self.assertEqual({name: both[name] for name in OWN_FILES}, {name: before[name] for name in OWN_FILES})
        self.kinematics(case)
        self.assertEqual(timeless_files_of(case / "results"), both)

    def test_several_processes_write_once(self):
        alone, together = self.copy_case(SIX, "alone/case"), self.copy_case(SIX, "together/case")
        self.kinematics(alone)
        run = self.geneva("kinematics", together, ranks=3)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.out.count("motion time [s]"), 1)
        self.assertEqual(timeless_files_of(together / "results"), timeless_files_of(alone / "results"))


class KinematicsRefusals(Refusals):
    """What does not move, or not as asked, is refused in one message, and nothing is written."""

    def assert_kinematics_refused(self, case, *words):
        before = self.paths(), files_of(self.directory)
        run = self.geneva("kinematics", case, time_limit=30)
        self.assert_explained(run, words)
        self.assertEqual((self.paths(), files_of(self.directory)), before)

    def assert_change_refused(self, shipped, changes, *words):
        case = self.copy_case(shipped, f"case-{len(list(self.directory.iterdir()))}")
        change_case(case, {f"Mechanism/{path}": value for path, value in changes.items()})
        with self.subTest(f"{shipped}: {changes}"):
            self.assert_kinematics_refused(case, "case.prm", *words)

    def test_a_geometry_does_not_move(self):
        case = self.copy_case("hertz-line-contact")
        self.assert_kinematics_refused(case, "'Model' = 'geometry'", "Model = mechanism")

    def test_two_stations_are_too_few(self):
        self.assert_change_refused(SIX, {"Stations": "2"}, "'Stations' = '2'", "from 3 to 24")

    def test_pins_that_would_be_in_slots_together(self):
        near = {"Pin angles": "0 deg, 100 deg"}
        self.assert_change_refused(PINS, near, "'Pin angles' =", "pins 1 and 2", "100 deg", "120 deg", "together")
        self.assert_change_refused(SIX, {"Pins": "4"}, "3 equally spaced pins at most")
        self.assert_change_refused(PINS, {"Pin angles": "10 deg, 160 deg"}, "'Pin angles'", "the first is 0 deg")
        self.assert_change_refused(PINS, {"Pin angles": "0 deg, 150"}, "'Pin angles'")

    def test_shafts_that_are_parallel_or_beyond(self):
        self.assert_change_refused(SPHERE, {"Shaft angle": "0 deg"}, "'Shaft angle' = '0 deg'", "greater than 0")
        self.assert_change_refused(SPHERE, {"Shaft angle": "180 deg"}, "line", "'Shaft angle' = '180 deg'", "0 to 180 deg")
        self.assert_change_refused(SPHERE, {"Shaft angle": "190 deg"}, "'Shaft angle' = '190 deg'", "0 to 180 deg")

    def test_linkages_that_turn_no_wheel(self):
        links = {"Linkage/Crank": "60 mm", "Linkage/Coupler": "60 mm", "Linkage/Frame": "110 mm"}
        self.assert_change_refused(LINKAGE, links, "crank of 60 mm does not turn fully", "Grashof")
        self.assert_change_refused(LINKAGE, {"Linkage/Frame": "400 mm"}, "400 mm", "cannot be closed", "280 mm")
        flat = {"Linkage/Crank": "40 mm", "Linkage/Rocker": "40 mm", "Linkage/Coupler": "110 mm",
                "Linkage/Frame": "110 mm", "Linkage/Wheel direction": "0 deg", "Linkage/Assembly": "crossed"}
        self.assert_change_refused(LINKAGE, flat, "'Linkage'", "AB 40, BC 110, CD 40 and AD 110 mm", "in two ways")
        small = {"Linkage/Crank": "5 mm", "Linkage/Coupler point distance": "300 mm",
                 "Linkage/Wheel direction": "270 deg"}
        self.assert_change_refused(LINKAGE, small, "wheel direction is 270 deg", "60 deg", "another direction")
        self.assert_change_refused(LINKAGE, {"Centre distance": "1 m"}, "centre distance is 1000 mm", "at most")

    def test_slot_friction_that_cannot_be(self):
        self.assert_change_refused(SIX, {"Slot friction": "-0.1"}, "'Slot friction' = '-0.1'", "0 or greater")
        jammed = {"Slot friction": "5"}
        self.assert_change_refused(SIX, jammed, "line", "'Slot friction' = '5'", "16.8 mm", "must be below")

    def test_rollers_that_cannot_be(self):
        bore = {"Roller bore diameter": "8 mm"}
        self.assert_change_refused(SIX, bore, "'Roller bore diameter' = '8 mm'", "Pin type = roller only")
        self.assert_change_refused(SIX, {"Roller bore friction": "0.1"}, "'Roller bore friction'", "Pin type = roller only")
        self.assert_change_refused(SIX, {"Pin type": "roller"}, "'Roller bore diameter' is missing", "'roller' needs it")
        roller = {"Pin type": "roller", **bore}
        self.assert_change_refused(SIX, {**roller, "Slot friction": "0.1"}, "'Slot friction' = '0.1'", "Pin type = fixed only")
        self.assert_change_refused(SIX, {**roller, "Roller bore diameter": "17 mm"}, "line",
                                   "'Roller bore diameter' = '17 mm'", "less than", "16.8 mm")
        self.assert_change_refused(SIX, {**roller, "Roller bore friction": "11"}, "line", "'Roller bore friction' = '11'",
                                   "roller of 16.8 mm jams", "must be below")
        self.assert_change_refused(SIX, {"Pin type": "loose"}, "'Pin type' = 'loose'", "fixed", "roller")

    def test_laws_of_motion_without_their_time(self):
        changes = {"Driver speed": None, "Driver motion": "harmonic on the carrier"}
        self.assert_change_refused(SIX, changes, "'Motion time' is missing", "harmonic on the carrier")
        self.assert_change_refused(HARMONIC, {"Driver speed": "60 rpm"}, "'Driver speed'", "Driver motion = constant")
        self.assert_change_refused(SIX, {"Motion time": "1 s"}, "'Motion time'", "a law of motion")
        self.assert_change_refused(SIX, {"Driver acceleration": "-1000 rad/s^2"},
                                   "'Driver acceleration' = '-1000 rad/s^2'", "must be between")

    def assert_table_refused(self, table, *words):
        case = self.copy_case(SIX, f"case-{len(list(self.directory.iterdir()))}")
        changes = {"Driver speed": None, "Driver motion": "table", "Motion table": "motion.csv"}
        change_case(case, {f"Mechanism/{path}": value for path, value in changes.items()})
        (case / "motion.csv").write_text(table)
        with self.subTest(table):
            self.assert_kinematics_refused(case, *words)

    def test_motion_tables_that_are_none(self):
        heading = "time [s], angle [deg]\n"
        self.assert_table_refused("", "line", "'Motion table' = 'motion.csv'", "has 0 rows", "four or more")
        self.assert_table_refused(heading, "motion table has 0 rows", "four or more")
        self.assert_table_refused(heading + "0,-100\n2,-50\n1,0\n3,100\n", "row 3", "motion table", "sort the table")
        self.assert_table_refused(heading + "0,-100\n1,soon\n", "motion.csv, line 3", "'1,soon'", "two numbers")
        self.assert_table_refused(heading + "0,-50\n1,-20\n2,0\n3,50\n", "from -50 to 50 deg", "from -60 to 60 deg")
        self.assert_table_refused(heading + "0,-100\n1,-99\n1.1,99\n2,100\n", "motion table", "turn back")
        self.assert_table_refused("0, 1\n1, 2\n", "motion.csv, line 1", "'time [s], angle [deg]' is wanted")
        outside = {"Driver speed": None, "Driver motion": "table", "Motion table": "../motion.csv"}
        (self.directory / "motion.csv").write_text(heading)
        self.assert_change_refused(SIX, outside, "'Motion table' = '../motion.csv'", "not one outside of it")
        outside["Motion table"] = "nowhere.csv"
        self.assert_change_refused(SIX, outside, "'Motion table' = 'nowhere.csv'", "no such file")

    def test_no_steps(self):
        case = self.copy_case(SIX)
        for steps in ("0", "-1", "many"):
            run = self.geneva("kinematics", case, "--steps", steps)
            self.assertEqual(run.code, 1, run.describe())
            self.assertIn("--steps", run.err)
            self.assertIn("1 to 10000000", run.err)
            self.assertFalse((case / "results").exists())

    def test_a_file_in_the_way(self):
        case = self.copy_case(SIX)
        run = self.geneva("kinematics", case, "--output", case / "case.prm")
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("in the way", run.err)


if __name__ == "__main__":
    geneva_cli.main()
