"""The files that a run leaves and what it says on the way."""

import base64
import errno
import fcntl
import functools
import math
import os
import pathlib
import pty
import re
import shutil
import struct
import subprocess
import tempfile
import termios
import unittest
import xml.etree.ElementTree as xml
import zlib

import closed_forms
import geneva_cli
from geneva_cli import RESULT_FILES, CliTest, look_up, number, read_csv, read_summary, unit_of

MECHANISM = "johnson-optimum-wheel"  # shows inches and pounds
GEOMETRY = "hertz-line-contact"  # shows millimetres and newtons
LENGTH_UNIT = {MECHANISM: "in", GEOMETRY: "mm"}
STRESS_UNIT = {MECHANISM: "psi", GEOMETRY: "MPa"}
STRESS_FACTOR = {"psi": 1 / closed_forms.PSI, "MPa": 1e-6}

STRESSES = ("stress", "stress_out_of_plane", "von_mises", "principal_stress_1", "principal_stress_2",
            "principal_stress_3", "max_shear", "mcewen_stress", "mcewen_difference")

QUANTITIES = {
    "contact": {"force": "N", "peak_pressure": "Pa", "half_width": "m", "max_shear": "Pa", "max_shear_depth": "m",
                "max_penetration": "m"},
    "hertz": {"peak_pressure": "Pa", "half_width": "m", "max_shear": "Pa", "max_shear_depth": "m"},
    "time": {"total": "s"},
    "memory": {"peak": "byte"},
}
MECHANISM_QUANTITIES = {
    "load": {"force": "N", "driver_angle": "rad", "wheel_acceleration": "rad/s^2", "wheel_speed": "rad/s",
             "pin_distance": "m"},
    "wheel": {"inertia_from_geometry": "kg m^2", "inertia_used": "kg m^2", "max_von_mises": "Pa"},
    "equilibrium": {"bore_torque": "N m", "expected_bore_torque": "N m"},
    "published": {"peak_pressure": "Pa"},
}
PLAIN = ("case.name", "case.title", "contact.peak_pressure_error", "contact.peak_pressure_correction",
         "contact.force_error", "contact.half_width_error", "contact.max_shear_error", "contact.max_shear_depth_error",
         "contact.active_nodes", "equilibrium.force_residual", "equilibrium.moment_residual", "mesh.levels", "mesh.cells", "mesh.dofs", "solver.converged", "versions.geneva",
         "versions.deal\\.II", "versions.gmsh")


def for_both(test):
    """Runs a test on the results of the mechanism and on those of the geometry."""
    @functools.wraps(test)
    def both(self):
        for name in (MECHANISM, GEOMETRY):
            with self.subTest(name):
                test(self, name, self.results(name))
    return both


class FinishedRuns(CliTest):
    """Tests on one run of a mechanism and one of a geometry, which setUpModule() has made."""

    place = pathlib.Path()
    output = {}

    def results(self, name):
        return self.place / name / "results"


def setUpModule():
    FinishedRuns.place = pathlib.Path(tempfile.mkdtemp(prefix="geneva-test-"))
    unittest.addModuleCleanup(shutil.rmtree, FinishedRuns.place, ignore_errors=True)
    for name in (MECHANISM, GEOMETRY):
        case = FinishedRuns.place / name
        shutil.copytree(CliTest.source / "cases" / name, case, ignore=shutil.ignore_patterns("results"))
        done = subprocess.run([str(CliTest.program), "run", str(case)], env=geneva_cli.environment(),
                              capture_output=True, text=True, timeout=geneva_cli.TIME_LIMIT, check=False)
        if done.returncode != 0:
            raise RuntimeError(f"{name} ended with {done.returncode}: {done.stdout}{done.stderr}")
        FinishedRuns.output[name] = done.stdout


class Files(FinishedRuns):

    @for_both
    def test_all_files_are_there_and_no_others(self, name, results):
        files = {*RESULT_FILES, "solution.0.vtu"}
        if "load" in read_summary(results):
            files.add("mechanism.json")
        self.assertEqual({path.name for path in results.iterdir()}, files)
        self.assertFalse(list((self.place / name).glob(".*")), "the working directory is left over")

    @for_both
    def test_xml_files_are_well_formed(self, _, results):
        for file in ("solution.pvd", "solution.pvtu", "solution.0.vtu", "contact.vtu", "results.xdmf"):
            xml.parse(results / file)

    @for_both
    def test_the_collection_leads_to_the_pieces(self, _, results):
        sets = xml.parse(results / "solution.pvd").findall("Collection/DataSet")
        self.assertEqual([entry.get("file") for entry in sets], ["solution.pvtu"])
        pieces = xml.parse(results / "solution.pvtu").findall("PUnstructuredGrid/Piece")
        self.assertEqual([entry.get("Source") for entry in pieces], ["solution.0.vtu"])

    def test_every_rank_writes_a_piece(self):
        case = self.copy_case(GEOMETRY)
        summary = self.run_case(case, ranks=2)
        pieces = [entry.get("Source") for entry in
                  xml.parse(case / "results" / "solution.pvtu").findall("PUnstructuredGrid/Piece")]
        self.assertEqual(pieces, ["solution.0.vtu", "solution.1.vtu"])
        cells = [int(xml.parse(case / "results" / piece).find("UnstructuredGrid/Piece").get("NumberOfCells"))
                 for piece in pieces]
        self.assertGreater(sum(cells), summary["mesh"]["cells"], "cells at round surfaces are shown in parts")

    @for_both
    def test_hdf5_file_is_one_and_the_xdmf_file_refers_to_it(self, _, results):
        content = (results / "results.h5").read_bytes()
        self.assertEqual(content[:8], b"\x89HDF\r\n\x1a\n")
        items = xml.parse(results / "results.xdmf").findall(".//DataItem")
        self.assertTrue(items)
        for item in items:
            file, _, dataset = item.text.strip().partition(":/")
            self.assertEqual(file, "results.h5")
            self.assertIn(dataset.encode(), content)
        for dataset in (b"history", b"error_estimate", b"active_set_iterations"):
            self.assertIn(dataset, content)

    @for_both
    def test_the_xdmf_file_has_all_components_of_the_stress(self, _, results):
        attributes = {attribute.get("Name"): attribute for attribute in
                      xml.parse(results / "results.xdmf").findall(".//Attribute")}
        for tensor in ("stress", "mcewen_stress", "mcewen_difference"):
            if tensor in attributes:
                self.assertIn(attributes[tensor].get("AttributeType"), ("Tensor", "Tensor6"), tensor)
            else:
                self.assertLessEqual({f"{tensor}_{component}" for component in ("xx", "yy", "xy")}, set(attributes))


class Fields(FinishedRuns):
    """solution.N.vtu"""

    @for_both
    def test_arrays_carry_their_units(self, name, results):
        arrays = {array.get("Name"): array for array in
                  xml.parse(results / "solution.0.vtu").findall("UnstructuredGrid/Piece/PointData/DataArray")}
        self.assertLessEqual({"displacement", "body", *STRESSES}, set(arrays))
        self.assertEqual(array_unit(arrays["displacement"]), LENGTH_UNIT[name])
        self.assertIsNone(array_unit(arrays["body"]))
        for stress in STRESSES:
            self.assertEqual(array_unit(arrays[stress]), STRESS_UNIT[name], stress)

    def test_positions_are_in_output_units(self):
        grid = read_vtu(self.results(MECHANISM) / "solution.0.vtu")
        places = grid["points"]
        width = max(point[0] for point in places) - min(point[0] for point in places)
        height = max(point[1] for point in places) - min(point[1] for point in places)
        for extent in (width, height):  # the rim's corners stand a little inside of the diameter
            self.assertGreater(extent, 0.8 * 4.53)
            self.assertLess(extent, 1.01 * 4.53)

    @for_both
    def test_stresses_are_consistent(self, name, results):
        grid = read_vtu(results / "solution.0.vtu")
        largest = max(value[0] for value in grid["von_mises"])
        tolerance = 2e-5 * largest  # the file holds single precision
        for point, stress in enumerate(grid["stress"]):
            xx, xy, yx, yy = stress[0], stress[1], stress[3], stress[4]
            zz = grid["stress_out_of_plane"][point][0]
            mean, radius = (xx + yy) / 2, math.hypot((xx - yy) / 2, xy)
            principal = sorted((mean + radius, mean - radius, zz), reverse=True)
            a, b, c = principal
            von_mises = math.sqrt(((a - b)**2 + (b - c)**2 + (c - a)**2) / 2)
            self.assertAlmostEqual(xy, yx, delta=tolerance)
            self.assertAlmostEqual(grid["von_mises"][point][0], von_mises, delta=tolerance)
            for index, value in enumerate(principal, 1):
                self.assertAlmostEqual(grid[f"principal_stress_{index}"][point][0], value, delta=tolerance)

    @for_both
    def test_the_normal_stress_at_the_contact_is_the_contact_pressure(self, name, results):
        grid = read_vtu(results / "solution.0.vtu")
        peak = number(read_summary(results)["contact"]["peak_pressure"]) * STRESS_FACTOR[STRESS_UNIT[name]]
        self.assert_close(-min(value[0] for value in grid["principal_stress_3"]), peak, 0.05, "least stress")

    @for_both
    def test_the_difference_is_that_from_the_closed_form(self, name, results):
        grid = read_vtu(results / "solution.0.vtu")
        tolerance = 2e-5 * max(value[0] for value in grid["von_mises"])
        inside = [point for point, zone in enumerate(grid["mcewen_zone"]) if zone[0] == 1]
        self.assertGreater(len(inside), 100)
        for point in inside:
            for ours, exact, difference in zip(grid["stress"][point], grid["mcewen_stress"][point],
                                               grid["mcewen_difference"][point]):
                self.assertAlmostEqual(ours - exact, difference, delta=tolerance)

    @for_both
    def test_bodies_are_numbered(self, _, results):
        self.assertEqual({value[0] for value in read_vtu(results / "solution.0.vtu")["body"]}, {0.0, 1.0})


class Contact(FinishedRuns):
    """contact.csv and contact.vtu"""

    def columns(self, name):
        """Columns by name without unit, and their units."""
        table = read_csv(self.results(name) / "contact.csv")
        return ({heading.split(" [")[0]: column for heading, column in table.items()},
                {heading.split(" [")[0]: unit_of(heading) for heading in table})

    @for_both
    def test_columns_carry_their_units(self, name, _):
        _, units = self.columns(name)
        length, stress = LENGTH_UNIT[name], STRESS_UNIT[name]
        self.assertEqual(units, {"pair": None, "arc_length": length, "x": length, "y": length,
                                 "contact_pressure": stress, "gap": length, "status": None,
                                 "hertz_pressure": stress})

    @for_both
    def test_the_peak_is_that_of_the_summary(self, name, results):
        columns, units = self.columns(name)
        contact = read_summary(results)["contact"]
        of_mesh = number(contact["peak_pressure"]) / (1. + contact["peak_pressure_correction"])
        # That of the summary is a fit through the nodes around the maximum one, which scatter by less than 0.1 %.
        self.assert_close(max(columns["contact_pressure"]), of_mesh * STRESS_FACTOR[units["contact_pressure"]],
                          1e-3, "peak pressure")

    @for_both
    def test_pressure_stands_where_the_contact_is_closed_only(self, name, _):
        columns, _ = self.columns(name)
        for status, pressure in zip(columns["status"], columns["contact_pressure"]):
            self.assertIn(status, (0.0, 1.0))
            self.assertGreaterEqual(pressure, 0.0)
            if pressure > 1e-3 * max(columns["contact_pressure"]):
                self.assertEqual(status, 1.0)

    @for_both
    def test_arc_length_increases(self, name, _):
        arc = self.columns(name)[0]["arc_length"]
        self.assertTrue(all(a < b for a, b in zip(arc, arc[1:])))

    def test_the_pressure_adds_up_to_the_force(self):
        columns, _ = self.columns(GEOMETRY)
        arc, pressure = columns["arc_length"], columns["contact_pressure"]
        force = sum((b - a) * (p + q) / 2 for a, b, p, q in zip(arc, arc[1:], pressure, pressure[1:]))
        self.assert_close(force, 6.0, 0.01, "force on 1 mm of thickness [N]")

    @for_both
    def test_the_vtu_file_holds_the_same_as_the_csv_file(self, name, results):
        columns, units = self.columns(name)
        for array in xml.parse(results / "contact.vtu").findall("UnstructuredGrid/Piece/PointData/DataArray"):
            text = (array.text or "") + "".join(child.tail or "" for child in array)
            self.assertEqual([float(entry) for entry in text.split()], columns[array.get("Name")])
            self.assertEqual(array_unit(array), units[array.get("Name")])


class Summary(FinishedRuns):

    @for_both
    def test_quantities_are_there_with_si_units(self, name, results):
        summary = read_summary(results)
        wanted = {**QUANTITIES, **(MECHANISM_QUANTITIES if name == MECHANISM else {})}
        for section, quantities in wanted.items():
            for key, unit in quantities.items():
                entry = summary[section][key]
                self.assertEqual(entry["unit"], unit, f"{section}.{key}")
                self.assertTrue(math.isfinite(entry["value"]), f"{section}.{key}")

    @for_both
    def test_plain_values_are_there(self, _, results):
        summary = read_summary(results)
        for key in PLAIN:
            section, _, name = key.partition(".")
            self.assertIn(name.replace("\\", ""), summary[section])

    def test_the_place_of_the_maximum_stress_is_there(self):
        place = read_summary(self.results(MECHANISM))["wheel"]["max_von_mises_place"]
        self.assertEqual({key: entry["unit"] for key, entry in place.items()}, {"x": "m", "y": "m"})

    @for_both
    def test_every_level_is_recorded(self, _, results):
        summary = read_summary(results)
        levels = summary["solver"]["levels"]
        self.assertEqual(len(levels), summary["mesh"]["levels"])
        self.assertEqual(levels[-1]["dofs"], summary["mesh"]["dofs"])
        for level in levels:
            self.assertEqual(len(level["linear_iterations"]), level["active_set_iterations"])

    def test_an_axisymmetric_and_a_flat_case_have_a_summary_of_their_own_kind(self):
        sphere = self.run_case(self.copy_case("hertz-sphere"))
        self.assertIn("hertz", sphere)
        flat = self.run_case(self.copy_case("flat-patch"))
        self.assertNotIn("hertz", flat)
        self.assertNotIn("wheel", flat)
        self.assert_close(number(look_up(flat, "published.peak_pressure")), 100e6, 1e-12, "published")


class CompletedCase(FinishedRuns):

    @for_both
    def test_it_runs_again_to_the_same_peak_pressure(self, name, results):
        again = self.copy_case(name)
        shutil.copy(results / "case.prm", again / "case.prm")
        peaks = [number(summary["contact"]["peak_pressure"])
                 for summary in (read_summary(results), self.run_case(again))]
        self.assert_close(peaks[1], peaks[0], 1e-12, "peak pressure")
        self.assertEqual((again / "results" / "case.prm").read_text().count("set "),
                         (results / "case.prm").read_text().count("set "))

    @for_both
    def test_it_holds_every_parameter_of_the_model(self, name, results):
        known = parameter_names(self.geneva("parameters").out)
        others = ("Synthesis/", *(("Geometry/",) if name == MECHANISM else ("Mechanism/", "Optimisation/")))
        completed = parameter_names((results / "case.prm").read_text())
        generic = {re.sub(r"(Body|Load) [^/]+/", r"\1 NAME/", parameter) for parameter in completed}
        picks = ("Geometry/Surface NAME", "Geometry/Solid NAME")  # as many as the case of a STEP file names
        self.assertEqual(generic, {parameter for parameter in known
                                   if not parameter.startswith(others) and parameter not in picks})


class Output(FinishedRuns):

    @for_both
    def test_without_terminal_lines_are_plain(self, name, _):
        self.assertNotIn("\x1b", self.output[name])
        self.assertNotIn("\r", self.output[name])

    @for_both
    def test_it_names_the_results_directory(self, name, results):
        self.assertIn(str(results), self.output[name])

    @for_both
    def test_every_level_has_a_line(self, name, results):
        lines = re.findall(r"^ +\d+ +\d+ +\d+ +\d+ +\d+ .* s$", self.output[name], re.MULTILINE)
        self.assertEqual(len(lines), read_summary(results)["mesh"]["levels"])

    def test_the_table_compares_with_closed_form_and_publication(self):
        output = self.output[MECHANISM]
        for heading in ("this program", "+- error", "closed form", "published", "difference"):
            self.assertIn(heading, output)
        row = next(line for line in output.splitlines() if line.startswith("peak contact pressure [psi]"))
        self.assertRegex(row, r"\] +\d+ \+- 0\.\d+ % +\d+ +72600 +[+-]?\d\.\d\d %$")
        for name in ("contact force", "half-width", "maximum shear", "its depth", "bore torque"):
            row = next(line for line in output.splitlines() if line.startswith(name))
            self.assertRegex(row, r"\] +\S+ \+- [\d.]+ % ", "every figure has its error")

    @for_both
    def test_every_figure_has_its_error(self, _, results):
        summary = read_summary(results)
        sections = {"contact": ("force", "half_width", "max_shear", "max_shear_depth", "peak_pressure")}
        if "load" in summary:
            sections["equilibrium"] = ("bore_torque",)
        for section, keys in sections.items():
            for key in keys:
                error = summary[section][f"{key}_error"]
                self.assertTrue(0 <= error < 0.1, f"{section}.{key}_error: {error}")
        self.assertLess(summary["contact"]["force_error"], 1e-6, "the load decides it")
        for row in summary["comparison"]:
            self.assertIs(row["bounded"], True)
            if row["computed"] is not None:  # beam theory has no mesh
                self.assertIsNotNone(row["error"], row["quantity"])

    @for_both
    def test_the_log_file_is_what_was_said(self, name, results):
        log = (results / "log.txt").read_text()
        self.assertTrue(log)
        self.assertTrue(self.output[name].startswith(log))

    def test_on_a_terminal_progress_is_shown_in_place(self):
        case = self.copy_case(GEOMETRY)
        code, output = self.run_on_terminal("run", str(case))
        self.assertEqual(code, 0, output)
        self.assertIn("\x1b[K", output)
        self.assertIn("active-set step", output)
        self.assertIn("peak contact pressure [MPa]", output)
        log = (case / "results" / "log.txt").read_text()
        self.assertNotIn("\x1b", log)
        self.assertNotIn("\r", log)

    def test_colours_are_for_terminals_whose_user_wants_them(self):
        case = self.copy_case(GEOMETRY)
        with open(case / "case.prm", "a", encoding="utf-8") as file:
            file.write("\nsubsection Allowable\n  set Contact pressure = 1 MPa\nend\n")
        colour = "\x1b[31mpeak contact pressure: "
        for variables, is_coloured in (({"TERM": "xterm"}, True), ({"TERM": "xterm", "NO_COLOR": "1"}, False),
                                       ({"TERM": "dumb"}, False), ({"TERM": "xterm", "NO_COLOR": ""}, True)):
            with self.subTest(variables):
                code, output = self.run_on_terminal("run", str(case), **variables)
                self.assertEqual(code, 0, output)
                self.assertIn("EXCEEDED", output)
                self.assertRegex(left_on_terminal(output), r"\n\n +this program", "a blank line before the table")
                self.assertEqual(colour in output, is_coloured, output)
                self.assertEqual("\x1b[3" in output, is_coloured, output)
                self.assertNotIn("\x1b[3", (case / "results" / "log.txt").read_text())
        code, output = self.run_on_terminal("run", str(case / "nowhere"), TERM="xterm")
        self.assertEqual(code, 1)
        self.assertIn("\x1b[31mgeneva: ", output)

    def test_a_terminal_shows_what_is_done_and_the_time_that_is_left_on_lines_that_fit(self):
        case = self.copy_case("crowned-pin")
        code, output = self.run_on_terminal("run", str(case), columns=60, TERM="xterm")
        self.assertEqual(code, 0, output)
        status = re.findall(r"\r\x1b\[K([^\r\n\x1b]+)", output)
        for work in ("meshing", "solving a mesh of ", "finding the stresses and errors", "working out the figures of this mesh",
                     "refining the mesh", "working out the results", "writing the results, about "):
            with self.subTest(work):
                self.assertTrue(any(line.startswith(work) for line in status), status)
        self.assertRegex(output, r"solving a mesh of \d+ unknowns, about \d+ s left")
        self.assertEqual(max(len(text) for text in status if re.match(r"level +\d", text)), 59, "cut to fit")
        self.assertNotIn("so far", (case / "results" / "log.txt").read_text())

    def run_on_terminal(self, *arguments, columns=200, **variables):
        """Exit code and output of a run whose output is a pseudo-terminal."""
        reading, writing = pty.openpty()
        fcntl.ioctl(writing, termios.TIOCSWINSZ, struct.pack("HHHH", 50, columns, 0, 0))
        with subprocess.Popen([str(self.program), *arguments], stdin=subprocess.DEVNULL, stdout=writing,
                              stderr=writing, env={**geneva_cli.environment(), **variables}) as process:
            os.close(writing)
            output = bytearray()
            while part := read_terminal(reading):
                output += part
            os.close(reading)
            return process.wait(geneva_cli.TIME_LIMIT), output.decode(errors="replace")

    def test_a_case_goes_by_its_directory_s_name_wherever_it_is_started(self):
        case = self.copy_case(GEOMETRY)
        done = subprocess.run([str(self.program), "run", "."], cwd=case, env=geneva_cli.environment(),
                              capture_output=True, text=True, timeout=geneva_cli.TIME_LIMIT, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(read_summary(case / "results")["case"]["name"], GEOMETRY)
        self.assertTrue(done.stdout.startswith(f"{GEOMETRY}: "), done.stdout[:200])

    def test_version_and_help_are_printed(self):
        version = self.geneva("--version")
        self.assertEqual((version.code, version.err), (0, ""))
        self.assertEqual(version.out.strip(), read_summary(self.results(GEOMETRY))["versions"]["geneva"])
        usage = self.geneva("--help")
        self.assertEqual(usage.code, 0)
        for command in ("run", "parameters"):
            self.assertIn(command, usage.out)


class StaleFiles(CliTest):
    """A results directory holds results of one case only."""

    OWN = ("summary.json", "contact.csv", "sections.csv", "depth.csv", "contact.vtu", "solution.pvd", "solution.pvtu",
           "solution.0.vtu", "solution.17.vtu", "results.h5", "results.xdmf", "view.json", "stress.svg", "case.prm",
           "log.txt", "kinematics.json", "kinematics.csv", "design.json", "design.csv", "crown.json", "crown.csv",
           "synthesis.json", "synthesis.csv", "mechanism.json", "report.html")
    FOREIGN = ("notes.txt", "summary.json.bak", "my-contact.csv", "solution.vtu", "geometry.geo", "kinematics.json~")

    def filled(self, name):
        """A results directory with a file of every name, the program's own and others."""
        directory = self.directory / name
        directory.mkdir()
        for file in self.OWN + self.FOREIGN:
            (directory / file).write_text("old")
        return directory

    def test_a_geometry_after_a_mechanism_draws_no_mechanism(self):
        results = self.directory / "results"
        case = self.copy_case(MECHANISM)
        for command in ("run", "kinematics", "design"):
            self.assertEqual(self.geneva(command, case, "--output", results).code, 0)
        self.assertIn("id=\"mechanism\"", (results / "report.html").read_text())
        run = self.geneva("run", self.copy_case(GEOMETRY), "--output", results)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(sorted(file.name for file in results.iterdir()),
                         sorted({*RESULT_FILES, "solution.0.vtu"}))
        self.assertNotIn("id=\"mechanism\"", (results / "report.html").read_text())
        self.assertIn("design.csv, design.json, kinematics.csv, kinematics.json", run.out)

    def test_every_command_removes_all_own_files_that_it_does_not_write(self):
        written = {("run", GEOMETRY): {*RESULT_FILES, "solution.0.vtu"},
                   ("run", MECHANISM): {*RESULT_FILES, "solution.0.vtu", "mechanism.json"},
                   ("kinematics", MECHANISM): {"kinematics.json", "kinematics.csv", "mechanism.json", "report.html"},
                   ("design", MECHANISM): {"design.json", "design.csv", "mechanism.json", "report.html"},
                   ("synthesize", "synthesis-quick-return"): {"synthesis.json", "synthesis.csv"}}
        for (command, name), files in written.items():
            with self.subTest(f"{command} {name}"):
                results = self.filled(f"{command}-{name}")
                run = self.geneva(command, self.source / "cases" / name, "--output", results)
                self.assertEqual(run.code, 0, run.describe())
                found = {file.name for file in results.iterdir()}
                self.assertEqual(found, files | set(self.FOREIGN))
                self.assertEqual([name for name in found if (results / name).read_bytes() == b"old"
                                  and name not in self.FOREIGN], [])

    def test_a_changed_case_keeps_nothing_of_the_old_one(self):
        case = self.copy_case(MECHANISM)
        self.assertEqual(self.geneva("kinematics", case).code, 0)
        self.run_case(case)
        geneva_cli.change_case(case, {"Title": "the same, with another title", "Accuracy": "1 %"})
        run = self.geneva("design", case)
        self.assertNotIn("removed", run.out)
        results = case / "results"
        for name in ("summary.json", "kinematics.json", "design.json", "solution.pvtu"):
            self.assertTrue((results / name).exists(), name)
        geneva_cli.change_case(case, {"Output units": "mm-N"})
        self.assertIn("removed", self.geneva("design", case).out)  # tables in other units
        self.run_case(case)
        geneva_cli.change_case(case, {"Mechanism/Friction moment": "3 lbf.in"})
        run = self.geneva("kinematics", case)
        self.assertIn("removed results of another case, or of this one before it was changed: case.prm, contact.csv",
                      run.out)
        self.assertEqual(sorted(file.name for file in results.iterdir()),
                         ["kinematics.csv", "kinematics.json", "mechanism.json", "report.html"])

    def test_the_case_s_own_files_stay_where_it_gets_its_results(self):
        """A motion table may bear the name of a result, and its case directory be the results directory."""
        case = self.copy_case("six-station-360rpm")
        geneva_cli.change_case(case, {"Mechanism/Driver motion": "table", "Mechanism/Motion table": "contact.csv",
                                      "Mechanism/Driver speed": None})
        rows = [f"{1e3 * angle / 360 / 6:.17g}, {angle}" for angle in range(-180, 181, 15)]
        (case / "contact.csv").write_text("\n".join(["time [ms], angle [deg]", *rows, ""]))
        (case / "summary.json").write_text("{}")  # as if case.prm were a run's copy
        before = {name: (case / name).read_text() for name in ("case.prm", "contact.csv")}
        for _ in range(2):
            self.assertEqual(self.geneva("kinematics", case, "--output", case).code, 0)
            self.assertEqual({name: (case / name).read_text() for name in before}, before)
        self.assertFalse((case / "summary.json").exists())

    def test_another_case_s_case_file_stays(self):
        case, other = self.copy_case(MECHANISM), self.copy_case(GEOMETRY)
        text = (other / "case.prm").read_text()
        self.assertEqual(self.geneva("kinematics", case, "--output", other).code, 0)
        self.assertEqual((other / "case.prm").read_text(), text)


class ParameterReference(CliTest):

    def test_parameters_are_printed_with_explanations(self):
        run = self.geneva("parameters")
        self.assertEqual((run.code, run.err), (0, ""))
        for name in ("Mechanism/Stations", "Mechanism/Wheel material/Young's modulus", "Geometry/Contact pairs",
                     "Geometry/Load NAME/Value", "Published/Peak pressure", "Accuracy", "Output units"):
            self.assertIn(name, parameter_names(run.out))

    def test_the_reference_in_the_documentation_is_up_to_date(self):
        reference = self.source / "doc" / "parameters.prm"
        if not reference.exists():
            self.skipTest("there is no doc/parameters.prm")
        self.assertEqual(reference.read_text(), self.geneva("parameters").out)


def left_on_terminal(output):
    """The lines that are left of a pseudo-terminal's output, without those that were taken away."""
    return "\n".join(line.split("\r\x1b[K")[-1].rstrip("\r") for line in output.split("\n"))


def read_terminal(descriptor):
    """The next part of a pseudo-terminal's output; empty when the program has ended."""
    try:
        return os.read(descriptor, 4096)
    except OSError as error:
        if error.errno == errno.EIO:
            return b""
        raise


def parameter_names(text):
    """Names of all parameters that a case file sets, with their subsections before slashes."""
    names, sections = set(), []
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words[:1] == ["subsection"]:
            sections.append(" ".join(words[1:]))
        elif words == ["end"]:
            sections.pop()
        elif words[:1] == ["set"]:
            names.add("/".join([*sections, " ".join(words[1:]).split("=")[0].strip()]))
    return names


def array_unit(array):
    """The unit that a VTK array carries, or None."""
    for key in array.findall("InformationKey"):
        if key.get("name") == "UNITS_LABEL":
            return (key.text or "").strip()
    return array.get("units")


def read_vtu(file):
    """Point arrays of a .vtu file by name, one tuple for each point, and "points" for the positions."""
    piece = xml.parse(file).find("UnstructuredGrid/Piece")
    arrays = {"points": decode(piece.find("Points/DataArray"))}
    for array in piece.findall("PointData/DataArray"):
        arrays[array.get("Name")] = decode(array)
    for name, values in arrays.items():
        if len(values) != int(piece.get("NumberOfPoints")):
            raise ValueError(f"{file.name}: {name} has {len(values)} entries")
    return arrays


def decode(array):
    """Entries of a VTK array of single precision: base64 of zlib's blocks, behind the table of their sizes."""
    text = "".join((array.text or "").split()) or "".join("".join((child.tail or "").split()) for child in array)
    blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    header_length = 4 * math.ceil(4 * (3 + blocks) / 3)
    header = struct.unpack(f"<{3 + blocks}I", base64.b64decode(text[:header_length])[:4 * (3 + blocks)])
    data = base64.b64decode(text[header_length:])
    content, start = b"", 0
    for size in header[3:]:
        content += zlib.decompress(data[start:start + size])
        start += size
    values = struct.unpack(f"<{len(content) // 4}f", content)
    width = int(array.get("NumberOfComponents", "1"))
    return [values[i:i + width] for i in range(0, len(values), width)]


if __name__ == "__main__":
    geneva_cli.main()
