"""`geneva synthesize`: the shipped linkages, path generators that are not found, and what is refused."""

import csv
import json
import math

import geneva_cli
from bad_input import NOT_CONVERGED, Refusals
from closed_forms import KNOWN_LINKAGE, RPM, coupler_point, wheel_motion
from geneva_cli import CliTest, change_case, files_of, look_up, number, read_csv, replace_in

QUICK_RETURN, CRANK_ROCKER, PATH = "synthesis-quick-return", "synthesis-crank-rocker", "synthesis-nine-points"
GIVEN = {"Synthesis/Crank pivot x": "10 mm", "Synthesis/Crank pivot y": "-20 mm",
         "Synthesis/Rocker pivot x": "130 mm", "Synthesis/Rocker pivot y": "10 mm"}


def read_synthesis(directory):
    return json.loads((directory / "synthesis.json").read_text())


def read_points(case):
    with open(case / "points.csv", newline="") as stream:
        lines = [line for line in stream if not line.startswith("#")]
    return [complex(float(x), float(y)) * 1e-3 for x, y in list(csv.reader(lines))[1:]]


def keep_points(case, count):
    """Shortens a path case's file to its first points."""
    lines = (case / "points.csv").read_text().splitlines()
    (case / "points.csv").write_text("\n".join(lines[:2 + count]) + "\n")


class Synthesize(CliTest):
    """The shipped cases; their single figures are those of expected.json (run_cases.py)."""

    def synthesize(self, case, code=0):
        run = self.geneva("synthesize", case)
        self.assertEqual(run.code, code, run.describe())
        return run, read_synthesis(case / "results"), read_csv(case / "results" / "synthesis.csv")

    def test_the_quick_return_moves_like_the_geneva_wheel_in_engagement(self):
        run, summary, curve = self.synthesize(self.copy_case(QUICK_RETURN))
        self.assertEqual(run.err, "")
        self.assertIn("slider farthest", run.out)
        speed = number(look_up(summary, "quick_return.crank_speed"))
        self.assertEqual(len(curve["crank_angle [deg]"]), 361)
        for degrees, angle, rocker_speed in zip(curve["crank_angle [deg]"], curve["rocker_angle [deg]"],
                                                curve["rocker_speed [rpm]"]):
            if abs(degrees) <= 60:
                wheel_angle, wheel_speed, _ = wheel_motion(6, math.radians(degrees), speed)
                self.assertAlmostEqual(math.radians(angle), wheel_angle, 10)
                self.assertAlmostEqual(rocker_speed * RPM, wheel_speed, 8)

    def test_the_rocker_of_the_crank_rocker_stays_between_its_extremes(self):
        _, summary, curve = self.synthesize(self.copy_case(CRANK_ROCKER))
        angles = curve["rocker_angle [deg]"]
        self.assert_close(min(angles), 75, 1e-12, "first extreme position")
        self.assert_close(max(angles), 105, 1e-12, "last extreme position")
        least = math.degrees(number(look_up(summary, "crank_rocker.minimum_transmission_angle")))
        self.assertGreaterEqual(min(curve["transmission_angle [deg]"]), least)
        self.assert_close(min(curve["transmission_angle [deg]"]), least, 1e-4, "minimum transmission angle")

    def test_the_points_are_those_of_the_linkage_that_the_readme_names(self):
        points = read_points(self.source / "cases" / PATH)
        self.assertEqual(len(points), 9)
        for k, point in enumerate(points):
            self.assertLess(abs(point - coupler_point(KNOWN_LINKAGE, math.radians(10 + 30 * k))), 1e-15)

    def test_every_path_generator_passes_all_points(self):
        run, summary, table = self.synthesize(self.copy_case(PATH))
        solutions = summary["path"]["solutions"]
        self.assertIn(f"{len(solutions)} found in 3000 starts", run.out)
        self.assertEqual(len(table["crank [mm]"]), len(solutions))
        points = read_points(self.source / "cases" / PATH)
        for solution in solutions:
            linkage = {name: number(solution[name]) for name in KNOWN_LINKAGE}
            if solution["assemblies"] != ["open"] * 9:
                continue
            for angle, point in zip(solution["crank_angles"], points):
                self.assertLess(abs(coupler_point(linkage, number(angle)) - point), 1e-9)
        defects = [(s["needs_reassembly"], s["out_of_order"]) for s in solutions]
        self.assertEqual(defects, sorted(defects))

    def test_fewer_points_and_given_dimensions(self):
        case = self.copy_case(PATH)
        keep_points(case, 5)
        change_case(case, {**GIVEN, "Synthesis/Starts": "10000"})
        _, summary, _ = self.synthesize(case)
        self.assertEqual(sorted(summary["path"]["given"]),
                         ["crank_pivot_x", "crank_pivot_y", "rocker_pivot_x", "rocker_pivot_y"])
        nearest = min(max(abs(number(solution[name]) - value) for name, value in KNOWN_LINKAGE.items())
                      for solution in summary["path"]["solutions"])
        self.assertLess(nearest, 1e-9)

    def test_the_same_seed_gives_the_same_files(self):
        case = self.copy_case(PATH)
        change_case(case, {"Synthesis/Starts": "300"})
        self.synthesize(case)
        first = files_of(case / "results")
        self.synthesize(case)
        self.assertEqual(files_of(case / "results"), first)

    def test_that_nothing_is_found_is_said_and_the_list_is_empty(self):
        case = self.copy_case(PATH)
        # nine points on a parabola with a jump, and a single start
        rows = "\n".join(f"{x}, {(-1)**x * x**2}" for x in range(9))
        (case / "points.csv").write_text(f"x [mm], y [mm]\n{rows}\n")
        change_case(case, {"Synthesis/Starts": "1"})
        run, summary, table = self.synthesize(case, NOT_CONVERGED)
        for word in ("geneva: not converged", "1 start,", "minimum residual", "mm", "'Starts'", "'Seed'"):
            self.assertIn(word, run.err)
        self.assertEqual(len(run.err.splitlines()), 1)
        self.assertEqual(summary["path"]["solutions"], [])
        self.assertGreater(number(summary["path"]["minimum_residual"]), 1e-9)
        self.assertEqual(table["crank [mm]"], [])

    def test_units_change_files_but_not_figures(self):
        case = self.copy_case(CRANK_ROCKER)
        _, metric, _ = self.synthesize(case)
        change_case(case, {"Output units": "in-lbf"})
        run, imperial, _ = self.synthesize(case)
        self.assertEqual(metric, imperial)
        self.assertIn("rocker CD [in]", run.out)

    def test_a_later_run_of_another_case_removes_the_files(self):
        case = self.copy_case(QUICK_RETURN)
        self.synthesize(case)
        found = files_of(case / "results")
        self.assertEqual(sorted(found), ["synthesis.csv", "synthesis.json"])
        mechanism = self.copy_case("johnson-optimum-wheel")
        run = self.geneva("run", mechanism, "--output", case / "results")
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("removed results of another case, or of this one before it was changed: synthesis.csv, "
                      "synthesis.json", run.out)
        self.assertEqual(set(found) & set(files_of(case / "results")), set())

    def test_several_processes_write_once(self):
        run = self.geneva("synthesize", self.copy_case(QUICK_RETURN), ranks=2)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.out.count("slider farthest"), 1)


class SynthesizeRefusals(Refusals):
    """What is no synthesis is refused in one message, and nothing is written."""

    def assert_synthesis_refused(self, case, *words, command="synthesize"):
        before = self.paths(), files_of(self.directory)
        run = self.geneva(command, case, time_limit=30)
        self.assert_explained(run, words)
        self.assertEqual((self.paths(), files_of(self.directory)), before)

    def assert_change_refused(self, shipped, changes, *words):
        case = self.copy_case(shipped, f"case-{len(list(self.directory.iterdir()))}")
        change_case(case, changes)
        with self.subTest(str(changes)):
            self.assert_synthesis_refused(case, "case.prm", *words)

    def test_other_models_are_refused(self):
        for shipped, model in (("johnson-optimum-wheel", "mechanism"), ("hertz-line-contact", "geometry")):
            self.assert_synthesis_refused(self.copy_case(shipped), f"'{model}'", "Model = synthesis")

    def test_other_commands_refuse_it(self):
        case = self.copy_case(CRANK_ROCKER)
        for command in ("run", "kinematics", "design"):
            with self.subTest(command):
                self.assert_synthesis_refused(case, "'synthesis'", f"'geneva {command}'", "'geneva synthesize'",
                                              command=command)

    def test_missing_parameters_are_named(self):
        for shipped, name in ((QUICK_RETURN, "Stations"), (QUICK_RETURN, "Maximum wheel speed"),
                              (QUICK_RETURN, "Frame"), (CRANK_ROCKER, "Swing"), (CRANK_ROCKER, "Rocker"),
                              (CRANK_ROCKER, "Crank pivot distance")):
            self.assert_change_refused(shipped, {f"Synthesis/{name}": None}, f"'{name}' is missing")

    def test_values_out_of_range_are_refused(self):
        for shipped, name, value, word in ((QUICK_RETURN, "Stations", "2", "from 3 to 24"),
                                           (QUICK_RETURN, "Frame", "nan mm", "length"),
                                           (QUICK_RETURN, "Crank", "50 mm", "give one of the two"),
                                           (CRANK_ROCKER, "Swing", "180 deg", "less than 180 deg"),
                                           (CRANK_ROCKER, "Swing", "30", "angle"),
                                           (CRANK_ROCKER, "Crank pivot distance", "20 mm", "half the chord"),
                                           (CRANK_ROCKER, "Kind", "rocker", "'crank-rocker'"),
                                           (PATH, "Starts", "0", "from 1"), (PATH, "Seed", "-1", "from 0"),
                                           (PATH, "Swing", "30 deg", "Kind = crank-rocker")):
            self.assert_change_refused(shipped, {f"Synthesis/{name}": value}, word)

    def test_a_wrong_number_of_given_dimensions_is_refused(self):
        self.assert_change_refused(PATH, {"Synthesis/Crank": "40 mm"}, "9 points", "none of", "leave out 1")
        case = self.copy_case(PATH)
        keep_points(case, 7)
        self.assert_synthesis_refused(case, "7 points", "exactly 2", "give 2 more", "'Coupler'")

    def test_points_outside_of_the_directory_are_refused(self):
        (self.directory / "points.csv").write_text("x [mm], y [mm]\n0, 0\n1, 1\n")
        for value in ("../points.csv", str(self.directory / "points.csv")):
            self.assert_change_refused(PATH, {"Synthesis/Points": value}, "outside")
        self.assert_change_refused(PATH, {"Synthesis/Points": "nowhere.csv"}, "no such file")

    def test_wrong_points_are_refused_with_their_line(self):
        for rows, word in (("", "number of points is 0"), ("1, 1", "number of points is 1"),
                           ("0, 0\n1, nan", "line 3"), ("0, 0\n1", "line 3"), ("0, 0\n1; 2", "line 3")):
            case = self.copy_case(PATH, f"case-{len(list(self.directory.iterdir()))}")
            (case / "points.csv").write_text(f"x [mm], y [mm]\n{rows}\n")
            with self.subTest(rows):
                self.assert_synthesis_refused(case, "points.csv", word)
        case = self.copy_case(PATH)
        lines = (case / "points.csv").read_text().splitlines()
        replace_in(case / "points.csv", lines[3], lines[2])
        self.assert_synthesis_refused(case, "points.csv", "points 1 and 2 are both")
        (case / "points.csv").write_text("x [s], y [mm]\n")
        self.assert_synthesis_refused(case, "points.csv, line 1", "length")


if __name__ == "__main__":
    geneva_cli.main()
