"""Sweeps: every combination, what fails, what is done already, and what is written."""

import json
import os
import re
import signal
import subprocess
import time

import geneva_cli
from geneva_cli import CliTest, change_case, environment, look_up, number, read_csv, read_summary

DIAMETERS = "Mechanism/Pin diameter = 12 mm .. 18 mm, 3"
SPEEDS = "Mechanism/Driver speed = 200 rpm; 300 rpm"


def wait_for(condition, seconds=120):
    """Until the condition holds, or so long."""
    deadline = time.monotonic() + seconds
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.02)


class Sweep(CliTest):

    def call(self, *arguments):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=False,
                              cwd=self.directory, env=environment())

    def new_case(self, name="wheel", *options):
        run = self.call("init", name, *options)
        self.assertEqual(run.returncode, 0, run.stderr)
        change_case(self.directory / name, {"Accuracy": "5 %", "Structural accuracy": "off"})
        return self.directory / name

    def sweep(self, case, *options, code=0):
        run = self.call("sweep", case, *options)
        self.assertEqual(run.returncode, code, run.stdout + run.stderr)
        return run

    def begun_sweep(self, case):
        """The process of a sweep of one job, which goes on beside the test."""
        return subprocess.Popen([self.program, "sweep", case, "-j", "1", "--set", DIAMETERS], cwd=self.directory,
                                env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def points(self, directory):
        return json.loads((directory / "sweep.json").read_text())["points"]

    def figure(self, point, quantity):
        return number(next(figure for figure in point["figures"] if figure["quantity"] == quantity)["value"])

    def test_every_combination_has_the_figures_of_a_run_of_its_own(self):
        case = self.new_case()
        self.sweep(case, "--set", DIAMETERS, "--set", SPEEDS)
        points = self.points(case / "sweep")
        self.assertEqual([point["values"] for point in points],
                         [[f"{d} mm", f"{n} rpm"] for d in (12, 15, 18) for n in (200, 300)])
        alone = self.new_case("alone")
        change_case(alone, {"Mechanism/Pin diameter": "15 mm", "Mechanism/Driver speed": "300 rpm"})
        summary = self.run_case(alone)
        self.assertEqual(self.figure(points[3], "peak contact pressure"), number(look_up(summary, "contact.peak_pressure")))
        self.assertEqual(self.figure(points[3], "least safety factor"), min(row["factor"] for row in summary["safety"]))
        of_point = read_summary(case / "sweep" / points[3]["directory"] / "results")
        self.assertEqual(look_up(of_point, "contact.peak_pressure"), look_up(summary, "contact.peak_pressure"))
        table = read_csv(case / "sweep" / "sweep.csv")
        self.assertEqual(list(table["Mechanism/Pin diameter [mm]"]), [12, 12, 15, 15, 18, 18])
        self.assert_close(table["peak contact pressure [MPa]"][3], 1e-6 * self.figure(points[3], "peak contact pressure"),
                          1e-8, "csv")
        report = (case / "sweep" / "report.html").read_text()
        self.assertIn("peak contact pressure against Pin diameter", report)
        self.assertIn("Driver speed 300 rpm", report)

    def test_what_is_done_is_not_done_again_and_what_is_changed_is(self):
        case = self.new_case()
        self.sweep(case, "--set", DIAMETERS)
        times = [(case / "sweep" / f"points/{i}/results/summary.json").stat().st_mtime_ns for i in (1, 2, 3)]
        (case / "sweep" / "points" / "2" / "ended").unlink()
        self.sweep(case, "--set", DIAMETERS)
        again = [(case / "sweep" / f"points/{i}/results/summary.json").stat().st_mtime_ns for i in (1, 2, 3)]
        self.assertEqual([a == b for a, b in zip(times, again)], [True, False, True])
        change_case(case, {"Mechanism/Friction moment": "900 N.mm"})
        before = [self.figure(point, "contact force") for point in self.points(case / "sweep")]
        self.sweep(case, "--set", DIAMETERS)
        for old, new in zip(before, (self.figure(point, "contact force") for point in self.points(case / "sweep"))):
            self.assertLess(1.05 * old, new)

    def test_a_point_is_kept_where_another_sweep_has_it_at_another_place(self):
        case = self.new_case()
        self.sweep(case, "--set", "Mechanism/Pin diameter = 12 mm .. 18 mm, 3")
        solved = {point["values"][0]: self.figure(point, "peak contact pressure") for point in self.points(case / "sweep")}
        run = self.sweep(case, "--set", "Mechanism/Pin diameter = 18 mm; 12 mm; 13 mm; 15 mm")
        for count, diameter, is_kept in ((1, "18 mm", True), (2, "12 mm", True), (3, "15 mm", True), (4, "13 mm", False)):
            line = re.search(rf"^\d of 4: {diameter}(.*)$", run.stdout, re.M)
            self.assertEqual("kept" in line.group(1), is_kept, (count, run.stdout))
        for point in self.points(case / "sweep"):
            if point["values"][0] in solved:
                self.assertEqual(self.figure(point, "peak contact pressure"), solved[point["values"][0]])
        self.assertEqual(sorted(place.name for place in (case / "sweep" / "points").iterdir()), ["1", "2", "3", "4"])

    def test_a_point_that_fails_is_told_and_ends_no_other(self):
        case = self.new_case()
        run = self.sweep(case, "--set", "Mechanism/Pin diameter = 12 mm; 12 kg; 300 mm; 15 mm", code=2)
        points = self.points(case / "sweep")
        self.assertEqual([point["exit_code"] for point in points], [0, 1, 1, 0])
        self.assertIn("is no unit of length", points[1]["message"])
        self.assertNotEqual(points[2]["message"], "")
        self.assertIn("2 of 4 points failed", run.stderr)
        self.assertIn("is no unit of length", run.stdout)

    def test_a_run_that_meets_a_limit_at_once_is_told_and_ends_no_other(self):
        case = self.new_case()
        run = self.sweep(case, "--set", "Maximum unknowns = 1000; 1000000", code=2)
        few, many = self.points(case / "sweep")
        self.assertEqual((few["exit_code"], many["exit_code"]), (2, 0))
        self.assertIn("Maximum unknowns", few["message"])
        self.assertGreater(len(many["figures"]), 5)
        self.assertIn("1 of 2 points failed", run.stderr)

    def test_a_place_that_cannot_be_written_is_told(self):
        case = self.new_case()
        (self.directory / "file").write_text("")
        run = self.call("sweep", case, "--set", SPEEDS, "-o", self.directory / "file" / "below")
        self.assertEqual(run.returncode, 1)
        self.assertIn("file", run.stderr)

    def test_a_damaged_or_missing_result_is_made_again(self):
        case = self.new_case()
        self.sweep(case, "--set", DIAMETERS)
        whole = [point["figures"] for point in self.points(case / "sweep")]
        results = case / "sweep" / "points" / "2" / "results"
        for harm in (lambda: (results / "summary.json").write_text("{"), (results / "summary.json").unlink):
            harm()
            self.sweep(case, "--set", DIAMETERS)
            self.assertEqual([point["figures"] for point in self.points(case / "sweep")], whole)

    def test_a_second_sweep_in_the_same_directory_is_refused(self):
        case = self.new_case()
        change_case(case, {"Accuracy": "0.05 %"})
        first = self.begun_sweep(case)
        wait_for((case / "sweep" / "points" / "1").exists)
        second = self.call("sweep", case, "--set", SPEEDS)
        self.assertEqual(second.returncode, 1, second.stdout)
        self.assertIn("sweep directory", second.stderr)
        first.communicate(timeout=120)
        self.assertEqual(first.returncode, 0)
        self.assertEqual(len(self.points(case / "sweep")), 3)

    def test_a_geometry_that_includes_a_file_is_swept(self):
        case = self.new_case("drawn", "--type", "geometry")
        (case / "size.geo").write_text("R = 12;\n")
        text = (case / "geometry.geo").read_text()
        (case / "geometry.geo").write_text(text.replace("R = 10;", 'Include "size.geo";'))
        variation = "Geometry/Load cylinder core/Value = 500 N; 1000 N"
        self.sweep(case, "--set", variation)
        before = [self.figure(point, "peak contact pressure") for point in self.points(case / "sweep")]
        (case / "size.geo").write_text("R = 9;\n")
        self.sweep(case, "--set", variation)
        for old, new in zip(before, (self.figure(point, "peak contact pressure") for point in self.points(case / "sweep"))):
            self.assert_close(new / old, (12 / 9)**0.5, 0.05, "p0 of a line grows with the root of the curvature")

    def test_a_range_through_zero_has_a_zero(self):
        case = self.new_case()
        self.sweep(case, "--with", "estimate", "--set", "Mechanism/Pin/Root gap = -0.3 mm .. 0.6 mm, 4", code=2)
        points = self.points(case / "sweep")
        self.assertEqual(points[1]["values"], ["0 mm"])
        self.assertEqual([point["exit_code"] for point in points], [1, 0, 0, 0])

    def test_every_figure_has_a_whole_name(self):
        case = self.new_case()
        self.sweep(case, "--with", "kinematics", "--set", SPEEDS)
        names = [figure["quantity"] for figure in self.points(case / "sweep")[0]["figures"]]
        self.assertEqual(len(names), len(set(names)))
        for name in names:
            self.assertFalse(name.startswith(" "), name)

    def test_commands_without_finite_elements_need_no_runs(self):
        case = self.new_case()
        for command, quantity in (("kinematics", "maximum pin force"), ("estimate", "pin force"),
                                  ("design", "diameter, best wheel as drawn")):
            with self.subTest(command):
                output = self.directory / command
                self.sweep(case, "--with", command, "--set", SPEEDS, "-o", output)
                slow, fast = (self.figure(point, quantity) for point in self.points(output))
                self.assertNotEqual(slow, fast)
                self.assertFalse((output / "points").exists())

    def test_its_own_geometry_and_files_go_along(self):
        case = self.new_case("drawn", "--type", "geometry")
        self.sweep(case, "--set", "Geometry/Load cylinder core/Value = 500 N .. 2000 N, 2, log")
        light, heavy = (self.figure(point, "peak contact pressure") for point in self.points(case / "sweep"))
        self.assert_close(heavy / light, 2., 0.05, "p0 of a line grows with the root of the load")

    def test_words_instead_of_numbers_are_varied_too(self):
        case = self.new_case()
        self.sweep(case, "--set", "Mechanism/Wheel material/Material = 42CrMo4 nitrided; PEEK")
        steel, plastic = (self.figure(point, "peak contact pressure") for point in self.points(case / "sweep"))
        self.assertLess(3. * plastic, steel)
        table = read_csv(case / "sweep" / "sweep.csv")
        self.assertEqual(list(table["Mechanism/Wheel material/Material"]), ["42CrMo4 nitrided", "PEEK"])

    def test_a_material_whose_modulus_the_case_replaces_is_told(self):
        case = self.copy_case("johnson-optimum-wheel")
        run = self.sweep(case, "--with", "estimate", "--set", "Mechanism/Wheel material/Material = C45 normalised; POM-C")
        note = "'Wheel material/Young's modulus' is 206.8 GPa as the case gives it, not 2.8 GPa as that of 'POM-C'"
        self.assertIn("note: " + note, run.stdout)
        self.assertNotIn("'C45 normalised':", run.stdout, "206.8 GPa are nearly its own")
        self.assertIn(note, json.loads((case / "sweep/sweep.json").read_text())["notices"][0])
        self.assertIn("leave it out to have the material", (case / "sweep/report.html").read_text())

    def test_wrong_variations_are_named_before_anything_is_done(self):
        case = self.new_case()
        for variation, words in (("Mechanism/Pin diameter", "there is no '='"),
                                 ("Mechanism/Pin diameter = 8 mm .. 14 in, 3", "the same unit"),
                                 ("Mechanism/Pin diameter = 8 mm .. 14 mm", "the number of its values"),
                                 ("Mechanism/Pin diameter = 8 mm .. 14 mm, 1.5", "'1.5' is no whole number"),
                                 ("Mechanism/Pin diameter = -8 mm .. 14 mm, 3, log", "one sign"),
                                 ("Mechanism/Pn diameter = 8 mm; 9 mm", "did you mean 'Pin diameter'?"),
                                 ("Pin diameter = 8 mm; 9 mm", "it belongs in the subsection 'Mechanism'"),
                                 ("Title = ", "there is no value"), ("Title = a; b", "a text that changes no figure")):
            with self.subTest(variation):
                run = self.call("sweep", case, "--set", variation)
                self.assertEqual(run.returncode, 1)
                self.assertIn(words, run.stderr)
        self.assertIn("is set twice", self.call("sweep", case, "--set", SPEEDS, "--set", SPEEDS).stderr)
        self.assertFalse((case / "sweep").exists())

    def test_an_interrupted_sweep_leaves_no_process_and_goes_on(self):
        case = self.new_case()
        change_case(case, {"Accuracy": "0.05 %"})
        sweep = self.begun_sweep(case)
        first = case / "sweep" / "points" / "1" / "ended"
        wait_for(first.exists)
        sweep.send_signal(signal.SIGTERM)
        sweep.communicate(timeout=60)
        self.assertEqual(sweep.returncode, 128 + signal.SIGTERM)
        wait_for(lambda: not self.solvers())
        self.assertEqual(self.solvers(), [])
        done = first.stat().st_mtime_ns
        self.sweep(case, "--set", DIAMETERS)
        self.assertEqual(first.stat().st_mtime_ns, done)
        self.assertEqual([point["exit_code"] for point in self.points(case / "sweep")], [0, 0, 0])

    def solvers(self):
        """Process ids of the solvers that work for this test's sweeps."""
        listed = subprocess.run(["pgrep", "-f", "geneva-solver --worker"], capture_output=True, text=True, check=False).stdout
        return [pid for pid in map(int, listed.split()) if self.directory_of(pid) == str(self.directory.resolve())]

    def directory_of(self, pid):
        try:
            return os.readlink(f"/proc/{pid}/cwd")
        except OSError:
            return ""

    def test_a_solver_that_is_killed_is_told_and_ends_no_other_point(self):
        case = self.new_case()
        change_case(case, {"Accuracy": "0.05 %"})
        sweep = self.begun_sweep(case)
        wait_for((case / "sweep" / "points" / "1" / "log.txt").exists)
        (solver,) = self.solvers()
        os.kill(solver, signal.SIGKILL)
        sweep.communicate(timeout=120)
        self.assertEqual(sweep.returncode, 2)
        killed, *others = self.points(case / "sweep")
        self.assertEqual(killed["exit_code"], 128 + signal.SIGKILL)
        self.assertEqual([point["exit_code"] for point in others], [0, 0])
        self.sweep(case, "--set", DIAMETERS)
        self.assertEqual([point["exit_code"] for point in self.points(case / "sweep")], [0, 0, 0])

    def test_one_solver_does_all_the_points_of_one_job(self):
        case = self.new_case()
        sweep = self.begun_sweep(case)
        seen = set()

        def ended():
            seen.update(self.solvers())
            return sweep.poll() is not None

        wait_for(ended)
        self.assertEqual(sweep.returncode, 0, sweep.communicate()[1])
        self.assertEqual(len(seen), 1)

    def test_two_parameters_make_a_map(self):
        case = self.new_case()
        change_case(case, {"Mechanism/Wheel material/Yield strength": "100 MPa"})
        self.sweep(case, "--set", DIAMETERS, "--set", "Mechanism/Driver speed = 200 rpm .. 600 rpm, 3")
        report = (case / "sweep" / "report.html").read_text()
        (drawn,) = re.findall(r'<svg class="map"[^>]*aria-label="least safety factor over[^>]*>(.*?)</svg>', report, re.S)
        factors = [self.figure(point, "least safety factor") for point in self.points(case / "sweep")]
        self.assertEqual(drawn.count("<rect") - 1, len(factors))
        self.assertEqual(drawn.count('class="exceeded"'), sum(factor < 1 for factor in factors))
        self.assertTrue(0 < drawn.count('class="exceeded"') < len(factors), factors)

    def test_a_figure_that_does_not_change_has_a_map_of_one_colour(self):
        case = self.new_case()
        moduli = "Mechanism/{} material/Young's modulus = 200 GPa; 207 GPa; 210 GPa"
        self.sweep(case, "--set", moduli.format("Wheel"), "--set", moduli.format("Pin"))
        report = (case / "sweep" / "report.html").read_text()
        (drawn,) = re.findall(r'<svg class="map"[^>]*aria-label="contact force[^>]*>(.*?)</svg>', report, re.S)
        self.assertEqual(len(set(re.findall(r'fill="(#[0-9a-f]{6})"', drawn))), 1)

    def test_a_point_that_cannot_be_written_ends_no_other(self):
        case = self.new_case()
        (case / "sweep" / "points").mkdir(parents=True)
        (case / "sweep" / "points" / "1").write_text("")
        self.sweep(case, "--set", DIAMETERS, code=2)
        first, *others = self.points(case / "sweep")
        self.assertEqual((first["exit_code"], [point["exit_code"] for point in others]), (1, [0, 0]))
        self.assertIn("points/1", first["message"])

    def test_works_where_a_launcher_of_mpi_programs_started_it(self):
        case = self.new_case()
        run = self.geneva("sweep", case, "--set", SPEEDS, ranks=2)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual([point["exit_code"] for point in self.points(case / "sweep")], [0, 0])

    def test_no_map_of_few_values(self):
        case = self.new_case()
        self.sweep(case, "--with", "kinematics", "--set", DIAMETERS, "--set", SPEEDS, "-o", self.directory / "few")
        self.assertNotIn('class="map"', (self.directory / "few" / "report.html").read_text())


if __name__ == "__main__":
    geneva_cli.main()
