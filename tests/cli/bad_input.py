"""Wrong input ends with a message that names file, parameter and what is allowed, and writes nothing."""

import os
import re
import stat

import geneva_cli
import mesh_files
from geneva_cli import CRASH_SIGNS, CliTest, change_case, files_of, read_summary, replace_in

WRONG_INPUT, NOT_CONVERGED = 1, 2

MECHANISM = "johnson-optimum-wheel"
GEOMETRY = "hertz-line-contact"


class Refusals(CliTest):
    """Shared assertions on runs that are refused."""

    def paths(self):
        return {path.relative_to(self.directory) for path in self.directory.rglob("*")}

    def assert_explained(self, run, words):
        """One message on stderr, with these words, and no trace of a crash."""
        self.assertEqual(run.code, WRONG_INPUT, run.describe())
        for sign in CRASH_SIGNS:
            self.assertNotIn(sign, run.out + run.err)
        message = [line for line in run.err.splitlines() if line.strip()]
        self.assertTrue(message, "there is no message on stderr")
        self.assertTrue(message[0].startswith("geneva: "), run.err)
        self.assertLessEqual(len(message), 4, run.err)
        self.assertLessEqual(len(run.err), 700, run.err)
        for word in words:
            self.assertIn(word, run.err)

    def assert_refused(self, case, *words, arguments=()):
        """The run is refused with these words in its message, and nothing has been written."""
        before = self.paths(), files_of(self.directory)
        run = self.geneva("run", case, *arguments, time_limit=30)
        self.assert_explained(run, words)
        self.assertEqual(self.paths(), before[0])
        self.assertEqual(files_of(self.directory), before[1])

    def assert_parameter_refused(self, shipped, changes, *words):
        """A shipped case is refused after changes of its parameters.

        The message names case.prm, the last parameter that is changed, and these words.
        """
        case = self.copy_case(shipped, f"case-{len(list(self.directory.iterdir()))}")
        change_case(case, changes)
        path, value = list(changes.items())[-1]
        name = path.split("/")[-1]
        with self.subTest(f"{name} = {value}"):
            self.assert_refused(case, "case.prm", name, *words)

    def assert_value_refused(self, shipped, changes, *words):
        """The same; the message names the value, too."""
        self.assert_parameter_refused(shipped, changes, list(changes.values())[-1], *words)


class CaseDirectory(Refusals):

    def test_a_directory_that_does_not_exist_is_named(self):
        self.assert_refused(self.directory / "nowhere", "nowhere", "no such directory")

    def test_a_directory_without_case_file_is_named(self):
        (self.directory / "empty").mkdir()
        self.assert_refused(self.directory / "empty", "empty", "case.prm")

    def test_a_file_in_place_of_the_directory_is_named(self):
        case = self.copy_case(MECHANISM)
        self.assert_refused(case / "case.prm", "case.prm", "directory")

    def test_an_unknown_command_is_refused(self):
        run = self.geneva("solve", "somewhere")
        self.assertEqual(run.code, WRONG_INPUT, run.describe())
        self.assertTrue(run.err)

    def test_an_option_in_place_of_a_command_is_refused(self):
        run = self.geneva("--output", "somewhere")
        self.assertEqual(run.code, WRONG_INPUT, run.describe())
        self.assertTrue(run.err)


class Parameters(Refusals):

    def test_unknown_names_are_refused_with_the_nearest_known_one(self):
        for shipped, path, nearest in ((MECHANISM, "Mechanism/Wheel diametre", "Wheel diameter"),
                                       (MECHANISM, "Acuracy", "Accuracy"),
                                       (GEOMETRY, "Geometry/Body block/Yongs modulus", "Young's modulus")):
            self.assert_parameter_refused(shipped, {path: "1 m"}, nearest)

    def test_an_unknown_subsection_is_refused(self):
        case = self.copy_case(MECHANISM)
        with open(case / "case.prm", "a", encoding="utf-8") as stream:
            stream.write("subsection Mechanics\nend\n")
        self.assert_refused(case, "case.prm", "Mechanics")

    def test_a_line_that_is_no_parameter_is_refused_with_its_number(self):
        case = self.copy_case(MECHANISM)
        replace_in(case / "case.prm", "set Accuracy     = 0.5 %", "Accuracy is half a percent")
        line = (case / "case.prm").read_text().splitlines().index("Accuracy is half a percent") + 1
        self.assert_refused(case, "case.prm", f"line {line}")

    def test_a_subsection_in_place_of_a_parameter_is_said_with_where_it_belongs(self):
        case = self.copy_case(MECHANISM)
        change_case(case, {"Wheel material": "C45 normalised"})
        self.assert_refused(case, "is a subsection of 'Mechanism': there write 'subsection Wheel material'",
                            "such as 'set Material = C45 normalised'")

    def test_a_missing_unit_is_refused_with_the_dimension_wanted(self):
        for shipped, path, value, dimension in (
                (MECHANISM, "Mechanism/Wheel diameter", "4.53", "length"),
                (MECHANISM, "Mechanism/Driver speed", "600", "angular speed"),
                (MECHANISM, "Mechanism/Friction moment", "2", "moment"),
                (MECHANISM, "Mechanism/Wheel material/Young's modulus", "30e6", "stress"),
                (GEOMETRY, "Geometry/Thickness", "1", "length"),
                (GEOMETRY, "Geometry/Load cylinder core/Value", "6", "force")):
            self.assert_value_refused(shipped, {path: value}, dimension)

    def test_a_wrong_dimension_is_refused_with_the_one_wanted(self):
        for shipped, path, value, dimension in (
                (MECHANISM, "Mechanism/Wheel diameter", "4.53 s", "length"),
                (MECHANISM, "Mechanism/Driver speed", "600 psi", "angular speed"),
                (MECHANISM, "Mechanism/Load density", "0.283 lb", "density"),
                (MECHANISM, "Mechanism/Wheel material/Young's modulus", "30e6 kg", "stress"),
                (GEOMETRY, "Geometry/Length unit", "kg", "length"),
                (GEOMETRY, "Geometry/Load cylinder core/Value", "6 MPa", "force")):
            self.assert_value_refused(shipped, {path: value}, dimension)

    def test_values_out_of_range_are_refused_with_the_range(self):
        for shipped, path, value, allowed in (
                (MECHANISM, "Mechanism/Stations", "2", "from 3 to 24"),
                (MECHANISM, "Mechanism/Stations", "25", "from 3 to 24"),
                (MECHANISM, "Mechanism/Stations", "4.5", "whole number"),
                (MECHANISM, "Mechanism/Wheel thickness", "-0.5 in", "greater than 0"),
                (GEOMETRY, "Geometry/Thickness", "-1 mm", "greater than 0"),
                (MECHANISM, "Mechanism/Wheel material/Poisson's ratio", "0.5", "at most 0.4999"),
                (MECHANISM, "Mechanism/Pin material/Poisson's ratio", "-2", "greater than -1"),
                (GEOMETRY, "Geometry/Body block/Poisson's ratio", "0.5", "at most 0.4999"),
                (MECHANISM, "Mechanism/Wheel diameter", "nan in", "length"),
                (MECHANISM, "Accuracy", "0", "greater than 0"),
                (MECHANISM, "Output units", "furlongs", "in-lbf")):
            self.assert_value_refused(shipped, {path: value}, allowed)

    def test_a_required_parameter_that_is_left_out_is_named(self):
        for shipped, path in ((MECHANISM, "Mechanism/Stations"), (GEOMETRY, "Geometry/Thickness")):
            self.assert_parameter_refused(shipped, {path: None})


class Mechanisms(Refusals):
    """The wheel of the case: n = 4, D = 4.53 in, pin and slot 0.6795 in, bore 0.3 in or so."""

    def test_a_slot_that_reaches_the_bore_is_refused(self):
        changes = {"Mechanism/Bore radius": "0.5 in", "Mechanism/Slot depth": "1.8 in"}
        self.assert_mechanism_refused(changes, "bore radius", "slots")

    def test_slots_that_run_into_each_other_are_refused(self):
        self.assert_mechanism_refused({"Mechanism/Slot depth": "2.2 in"}, "slot depth", "slots run into each other")

    def test_a_locking_arc_that_cuts_a_slot_is_refused(self):
        self.assert_mechanism_refused({"Mechanism/Locking radius": "2 in"}, "locking", "slot")

    def test_a_pin_wider_than_its_slot_is_refused(self):
        changes = {"Mechanism/Pin diameter": "0.7 in", "Mechanism/Slot width": "0.6 in"}
        self.assert_mechanism_refused(changes, "pin diameter", "slot width")

    def assert_mechanism_refused(self, changes, *words):
        """The message names case.prm and the dimensions that do not go together, in whatever case."""
        case = self.copy_case(MECHANISM)
        change_case(case, changes)
        before = self.paths()
        run = self.geneva("run", case, time_limit=30)
        self.assert_explained(run, ("case.prm",))
        for word in words:
            self.assertIn(word, run.err.lower())
        self.assertEqual(self.paths(), before)

    def test_two_sizes_of_the_wheel_are_refused(self):
        self.assert_parameter_refused(MECHANISM, {"Mechanism/Crank radius": "2 in"}, "exactly one", "Wheel diameter")

    def test_a_driver_angle_outside_of_the_engagement_is_refused_with_its_limits(self):
        for angle in ("50 deg", "-46 deg"):
            self.assert_parameter_refused(MECHANISM, {"Mechanism/Driver angle": angle}, "-45 deg", "45 deg")

    def test_an_angle_at_which_the_pin_leaves_the_driving_wall_is_refused(self):
        self.assert_parameter_refused(MECHANISM, {"Mechanism/Driver angle": "20 deg"},
                                      "does not press on the driving wall", "'at maximum pin force' (-9.93")

    def test_an_angle_without_any_force_is_refused(self):
        changes = {"Mechanism/Friction moment": "0 N.m", "Mechanism/Driver angle": "0 deg"}
        self.assert_parameter_refused(MECHANISM, changes, "does not press on the driving wall", "'at maximum pin force'")

    def test_a_torque_that_turns_the_wheel_leaves_no_angle_to_choose(self):
        for angle in ("-10 deg", "at maximum pin force", "at maximum wheel acceleration"):
            changes = {"Mechanism/External torque": "-1000 N.m", "Mechanism/Driver angle": angle}
            self.assert_parameter_refused(MECHANISM, changes, "nor does it anywhere else")

    def test_inertia_of_johnson_s_table_is_refused_beyond_its_10_stations(self):
        changes = {"Mechanism/Stations": "12", "Mechanism/Wheel inertia": "Johnson"}
        self.assert_parameter_refused(MECHANISM, changes, "3 to 10")

    def test_a_pin_out_of_all_proportion_is_refused_before_it_is_meshed(self):
        case = self.copy_case("crowned-pin")
        change_case(case, {"Mechanism/Wheel diameter": "4.53 um"})
        self.assert_refused(case, "layers of cells")

    def test_control_characters_of_a_table_do_not_reach_the_terminal(self):
        case = self.copy_case("servo-harmonic")
        change_case(case, {"Mechanism/Motion time": None, "Mechanism/Driver motion": "table",
                           "Mechanism/Motion table": "motion.csv"})
        (case / "motion.csv").write_text("time [s], angle [deg]\n0.1\x1b[2J, \u009b2J\n")
        self.assert_refused(case, "motion.csv, line 2: '0.1 [2J,   2J'")


class Surfaces(Refusals):

    PAIRS = "Geometry/Contact pairs"

    def test_surfaces_that_do_not_exist_are_refused_with_those_that_do(self):
        for path, value in ((self.PAIRS, "cylinder rim -> block top"), (self.PAIRS, "cylinder surface -> block tip"),
                            ("Geometry/Supports", "block foot: fixed")):
            self.assert_parameter_refused(GEOMETRY, {path: value}, "block bottom")

    def test_a_body_that_does_not_exist_is_refused_with_those_that_do(self):
        case = self.copy_case(GEOMETRY)
        replace_in(case / "case.prm", "= cylinder, block", "= cylinder, brick")
        replace_in(case / "case.prm", "Body block", "Body brick")
        self.assert_refused(case, "case.prm", "Bodies", "brick", "block")

    def test_an_empty_contact_surface_is_refused(self):
        case = self.copy_case(GEOMETRY)
        with open(case / "geometry.geo", "a", encoding="utf-8") as stream:
            stream.write('Point(901) = {90, 0, 0};\nPoint(902) = {95, 0, 0};\nLine(901) = {901, 902};\n'
                         'Physical Curve("loose") = {901};\n')
        change_case(case, {self.PAIRS: "cylinder surface -> loose"})
        self.assert_refused(case, "geometry.geo", "loose")

    def test_contact_surfaces_that_are_one_are_refused(self):
        self.assert_parameter_refused(GEOMETRY, {self.PAIRS: "block top -> block top"}, "itself")

    def test_contact_surfaces_of_one_body_are_refused(self):
        self.assert_parameter_refused(GEOMETRY, {self.PAIRS: "cylinder surface -> cylinder core"}, "cylinder")

    def test_contact_surfaces_that_overlap_in_the_list_are_refused(self):
        pairs = "cylinder surface -> block top, cylinder surface -> block bottom"
        self.assert_parameter_refused(GEOMETRY, {self.PAIRS: pairs}, "cylinder surface")

    def test_a_curve_in_two_surfaces_is_refused(self):
        case = self.copy_case(GEOMETRY)
        with open(case / "geometry.geo", "a", encoding="utf-8") as stream:
            stream.write('Physical Curve("block lid") = {203};\n')
        self.assert_refused(case, "geometry.geo", "block top", "block lid")

    def test_bodies_that_share_a_point_are_not_welded_there(self):
        peaks = []
        for name, more in (("apart", ""), ("joined", "Coherence;\n")):
            case = self.copy_case(GEOMETRY, name)
            with open(case / "geometry.geo", "a", encoding="utf-8") as stream:
                stream.write(more)
            replace_in(case / "geometry.geo", "Point(203) = {W, 0, 0};", "Point(203) = {0, 0, 0};")
            run = self.geneva("run", case)
            self.assertEqual(run.code, NOT_CONVERGED, run.describe())
            self.assertIn("sharp edge", run.err)
            peaks.append(read_summary(case / "results")["solver"]["levels"][5]["peak_pressure"]["value"])
        self.assert_close(peaks[1], peaks[0], 1e-6, "peak on a mesh")

    def test_a_body_that_nothing_holds_is_named(self):
        for changes in ({"Geometry/Supports": None}, {"Geometry/Supports": "block bottom: x"}):
            case = self.copy_case(GEOMETRY, f"held-{len(list(self.directory.iterdir()))}")
            change_case(case, changes)
            with self.subTest(changes):
                self.assert_refused(case, "case.prm", "block")

    def test_a_body_without_support_or_contact_is_named(self):
        case = self.copy_case(GEOMETRY)
        with open(case / "geometry.geo", "a", encoding="utf-8") as stream:
            stream.write("Point(901) = {60, 0, 0};\nPoint(902) = {70, 0, 0};\nPoint(903) = {70, 10, 0};\n"
                         "Point(904) = {60, 10, 0};\nLine(901) = {901, 902};\nLine(902) = {902, 903};\n"
                         "Line(903) = {903, 904};\nLine(904) = {904, 901};\n"
                         "Curve Loop(901) = {901, 902, 903, 904};\nPlane Surface(901) = {901};\n"
                         'Transfinite Surface {901};\nRecombine Surface {901};\nPhysical Surface("brick") = {901};\n')
        replace_in(case / "case.prm", "= cylinder, block", "= cylinder, block, brick")
        self.assert_refused(case, "case.prm", "brick")

    def test_a_load_that_pulls_the_bodies_apart_is_refused(self):
        for change in ({"Value": "-6 N"}, {"Direction": "0, 1"}, {"Type": "displacement", "Value": "-1 um"}):
            case = self.copy_case(GEOMETRY, f"apart-{len(list(self.directory.iterdir()))}")
            change_case(case, {f"Geometry/Load cylinder core/{name}": value for name, value in change.items()})
            with self.subTest(change):
                self.assert_refused(case, "case.prm", "cylinder surface -> block top", "load")

    def test_a_direction_of_no_length_is_refused(self):
        self.assert_parameter_refused(GEOMETRY, {"Geometry/Load cylinder core/Direction": "0, 0"}, "direction")


class GeometryFiles(Refusals):

    def test_a_missing_file_is_named(self):
        case = self.copy_case(GEOMETRY)
        (case / "geometry.geo").unlink()
        self.assert_refused(case, "case.prm", "geometry.geo", "geometry.msh")

    def test_a_file_outside_of_the_case_directory_is_refused(self):
        other = self.copy_case(GEOMETRY, "other")
        for number, name in enumerate(("../other/geometry.geo", str(other / "geometry.geo"))):
            case = self.copy_case(GEOMETRY, f"inside-{number}")
            change_case(case, {"Geometry/File": name})
            with self.subTest(name):
                self.assert_refused(case, "case.prm", "File", "in the case directory")

    def test_a_link_that_leaves_the_case_directory_is_refused(self):
        other = self.copy_case(GEOMETRY, "other")
        case = self.copy_case(GEOMETRY)
        (case / "geometry.geo").unlink()
        (case / "geometry.geo").symlink_to(other / "geometry.geo")
        self.assert_refused(case, "case.prm", "File", "in the case directory")

    def test_syntax_errors_are_refused_with_their_line(self):
        for name, old, new in (("missing bracket", "Point(201) = {-W, -W, 0};", "Point(201) = {-W, -W, 0;"),
                               ("missing semicolon", "Line(201) = {201, 202};", "Line(201) = {201, 202}"),
                               ("unknown command", "Transfinite Surface {201};", "Transfinit Surface {201};")):
            case = self.copy_case(GEOMETRY, name.replace(" ", "-"))
            file = case / "geometry.geo"
            line = file.read_text().splitlines().index(old) + 1
            replace_in(file, old, new)
            with self.subTest(name):
                run = self.geneva("run", case, time_limit=30)
                self.assert_explained(run, ("geometry.geo",))
                self.assertTrue(any(f"geometry.geo:{line + later}:" in run.err for later in (0, 1)), run.err)

    def test_an_unknown_point_is_refused(self):
        case = self.copy_case(GEOMETRY)
        replace_in(case / "geometry.geo", "Line(201) = {201, 202};", "Line(201) = {201, 999};")
        self.assert_refused(case, "geometry.geo", "999")

    def test_commands_that_run_programs_are_refused_before_they_run(self):
        witness = self.directory / "witness"
        for number, command in enumerate((f'SystemCall "touch {witness}";', f'NonBlockingSystemCall "touch {witness}";',
                                          f'System "touch {witness}";',
                                          f'If(1)\nSystemCall "touch {witness}";\nEndIf',
                                          f'OnelabRun("x", "touch {witness}");')):
            case = self.copy_case(GEOMETRY, f"command-{number}")
            self.put_first(case, command)
            with self.subTest(command.split()[0]):
                self.assert_refused(case, "geometry.geo:", "runs a command")
                self.assertFalse(witness.exists())

    def test_commands_that_write_files_are_refused(self):
        witness = self.directory / "witness"
        for number, command in enumerate((f'Save "{witness}.msh";', f'Print "{witness}.geo";',
                                          f'Printf("text") > "{witness}.txt";', f'CreateDir "{witness}";')):
            case = self.copy_case(GEOMETRY, f"command-{number}")
            self.put_first(case, command)
            with self.subTest(command.split()[0]):
                says = "Unable to open file" if command.startswith("Printf") else "writes"
                self.assert_refused(case, "geometry.geo:", says)

    def test_files_outside_of_the_case_directory_are_not_read(self):
        secret = self.directory / "secret.geo"
        secret.write_text("not for others;\n")
        for number, command in enumerate(('Include "../secret.geo";', f'Include "{secret}";', 'Merge "../secret.geo";',
                                          f'Merge "{secret}";', 'Include "link.geo";', 'Merge "/etc/passwd";')):
            case = self.copy_case(GEOMETRY, f"read-{number}")
            (case / "link.geo").symlink_to(secret)
            self.put_first(case, command)
            with self.subTest(command):
                run = self.geneva("run", case, time_limit=30)
                self.assert_explained(run, ("geometry.geo", "secret.geo" if "link" not in command else "link.geo")
                                      if "passwd" not in command else ("geometry.geo", "passwd"))
                self.assertNotIn("not for others", run.out + run.err)

    def test_files_inside_of_the_case_directory_may_be_included(self):
        case = self.copy_case(GEOMETRY)
        (case / "geometry.geo").rename(case / "shapes.geo")
        (case / "geometry.geo").write_text('Include "shapes.geo";\n')
        self.assertEqual(self.geneva("run", case).code, 0)

    @staticmethod
    def put_first(case, command):
        file = case / "geometry.geo"
        file.write_text(command + "\n" + file.read_text())


class MeshFiles(Refusals):

    def mesh_case(self, text, name="mesh"):
        case = self.copy_case("flat-patch", name)
        (case / "geometry.geo").unlink()
        (case / "geometry.msh").write_text(text)
        return case

    def test_a_linear_mesh_with_names_is_accepted(self):
        self.run_case(self.mesh_case(mesh_files.two_blocks().text()))

    def test_cells_of_order_2_are_read_as_linear_ones(self):
        linear = self.run_case(self.mesh_case(mesh_files.two_blocks().text()))
        second = self.run_case(self.mesh_case(mesh_files.two_blocks().text(order=2), "second"))
        self.assert_close(second["contact"]["peak_pressure"]["value"], linear["contact"]["peak_pressure"]["value"], 1e-9,
                          "peak pressure")

    def test_groups_without_names_are_refused(self):
        self.assert_refused(self.mesh_case(mesh_files.two_blocks().text(named=False)), "geometry.msh", "name")

    def test_a_file_cut_short_is_refused(self):
        text = mesh_files.two_blocks().text()
        for share in (0.01, 0.3, 0.7, 0.99):
            with self.subTest(share=share):
                case = self.mesh_case(text[:int(share * len(text))], f"cut-{int(100 * share)}")
                self.assert_refused(case, "geometry.msh")

    def test_a_file_with_missing_lines_is_refused(self):
        lines = mesh_files.two_blocks().text().splitlines(keepends=True)
        nodes, elements = lines.index("$Nodes\n"), lines.index("$Elements\n")
        for name, first in (("nodes", nodes + 5), ("elements", elements + 9)):
            with self.subTest(name):
                case = self.mesh_case("".join(lines[:first] + lines[first + 3:]), f"without-{name}")
                self.assert_refused(case, "geometry.msh")

    def test_a_script_named_as_a_mesh_is_refused_before_it_runs(self):
        witness = self.directory / "witness"
        self.assert_refused(self.mesh_case(f'SystemCall "touch {witness}";\n'), "geometry.msh", "no Gmsh mesh")
        self.assertFalse(witness.exists())

    def test_an_empty_file_is_refused(self):
        self.assert_refused(self.mesh_case(""), "geometry.msh")


class ResultsDirectory(Refusals):

    def test_a_place_that_cannot_be_written_is_named(self):
        case = self.copy_case(MECHANISM)
        (self.directory / "file").write_text("in the way\n")
        for place in ("file/results", "file"):
            with self.subTest(place):
                self.assert_refused(case, str(self.directory / place), "--output" if "/" in place else "in the way",
                                    arguments=("--output", self.directory / place))

    def test_a_case_directory_is_no_place_for_results(self):
        """The completed case file would take the place of the user's own."""
        case = self.copy_case(MECHANISM)
        other = self.copy_case(GEOMETRY)
        for place in (case, other):
            with self.subTest(place.name):
                self.assert_refused(case, "--output", "case.prm", arguments=("--output", place))

    def test_a_directory_without_permission_is_named(self):
        if os.geteuid() == 0:
            self.skipTest("permissions do not bind root")
        case = self.copy_case(MECHANISM)
        locked = self.directory / "locked"
        locked.mkdir(mode=stat.S_IRUSR | stat.S_IXUSR)
        self.assert_refused(case, "locked", "--output", arguments=("--output", locked / "results"))
        locked.chmod(stat.S_IRWXU)

    def test_no_directory_is_left_above_the_results_of_a_wrong_case(self):
        case = self.copy_case(GEOMETRY)
        replace_in(case / "geometry.geo", "Line(201) = {201, 202};", "Line(201) = {201, 999};")
        self.assert_refused(case, "geometry.geo", arguments=("--output", self.directory / "new" / "place"))

    def test_results_stay_until_a_later_run_succeeds(self):
        case = self.copy_case(GEOMETRY)
        self.run_case(case)
        results = case / "results"
        (results / "solution.7.vtu").write_text("from a run on 8 ranks\n")
        (results / "notes.txt").write_text("not the program's\n")
        good_case, good_geometry = (case / "case.prm").read_text(), (case / "geometry.geo").read_text()
        kept = files_of(results)

        change_case(case, {"Geometry/Body block/Poisson's ratio": "0.5"})
        self.assert_refused(case, "Poisson's ratio")
        (case / "case.prm").write_text(good_case)
        replace_in(case / "geometry.geo", "Line(201) = {201, 202};", "Line(201) = {201, 999};")
        self.assert_refused(case, "geometry.geo")
        self.assertEqual(files_of(results), kept)

        (case / "geometry.geo").write_text(good_geometry)
        change_case(case, {"Geometry/Load cylinder core/Value": "7 N"})
        self.assertAlmostEqual(self.run_case(case)["contact"]["force"]["value"], 7.0, places=6)
        self.assertFalse((results / "solution.7.vtu").exists())
        self.assertEqual((results / "notes.txt").read_text(), "not the program's\n")
        self.assertFalse(list(case.glob(".*")), "the hidden working directory is left over")


class SeveralRanks(Refusals):

    TIME_LIMIT = 30

    def assert_refused_together(self, case, *words, arguments=()):
        """All ranks end at once, and one speaks."""
        before = self.paths()
        run = self.geneva("run", case, *arguments, ranks=2, time_limit=self.TIME_LIMIT)
        self.assertEqual(run.code, WRONG_INPUT, run.describe())
        self.assertEqual(run.err.count("geneva: "), 1, run.err)
        for sign in CRASH_SIGNS:
            self.assertNotIn(sign, run.out + run.err)
        for word in words:
            self.assertIn(word, run.err)
        self.assertEqual(self.paths(), before)

    def test_a_wrong_parameter_ends_all_ranks_with_one_message(self):
        case = self.copy_case(MECHANISM)
        change_case(case, {"Mechanism/Stations": "2"})
        self.assert_refused_together(case, "case.prm", "Stations")

    def test_a_pin_without_force_ends_all_ranks_with_one_message(self):
        case = self.copy_case(MECHANISM)
        change_case(case, {"Mechanism/Driver angle": "20 deg"})
        self.assert_refused_together(case, "Driver angle")

    def test_a_wrong_geometry_ends_all_ranks_with_one_message(self):
        case = self.copy_case(GEOMETRY)
        replace_in(case / "geometry.geo", "Line(201) = {201, 202};", "Line(201) = {201, 999};")
        self.assert_refused_together(case, "geometry.geo", "999")

    def test_a_place_that_cannot_be_written_ends_all_ranks_with_one_message(self):
        case = self.copy_case(MECHANISM)
        (self.directory / "file").write_text("in the way\n")
        self.assert_refused_together(case, "file/results", arguments=("--output", self.directory / "file" / "results"))

    def test_a_case_that_does_not_exist_ends_all_ranks_with_one_message(self):
        self.assert_refused_together(self.directory / "nowhere", "nowhere")


class NotConverged(Refusals):
    """A limit ends the run with exit code 2; the last good results are written and what was reached is named."""

    LIMITS = (("Maximum refinement levels", "2"), ("Maximum unknowns", "1000"), ("Maximum memory", "10 MB"),
              ("Maximum active-set steps", "1"))

    def assert_last_good_results(self, shipped, changes, limit, ranks=None):
        case = self.copy_case(shipped, f"limit-{len(list(self.directory.iterdir()))}")
        change_case(case, changes)
        run = self.geneva("run", case, ranks=ranks)
        self.assertEqual(run.code, NOT_CONVERGED, run.describe())
        for sign in CRASH_SIGNS:
            self.assertNotIn(sign, run.out + run.err)
        self.assertEqual((run.out + run.err).count("not converged"), 1, run.describe())
        self.assertIn(limit, run.err)
        self.assertIn("estimated error of the peak contact pressure", run.out)
        self.assertNotIn("nan", run.out)
        self.assertLessEqual(set(geneva_cli.RESULT_FILES), {path.name for path in (case / "results").iterdir()})
        summary = read_summary(case / "results")
        self.assertIs(summary["solver"]["converged"], False)
        self.assertIn(limit, summary["solver"]["message"])
        self.assertGreater(summary["contact"]["peak_pressure_error"], 0.005)
        self.assertIn(summary["solver"]["message"], (case / "results" / "log.txt").read_text())

    def test_limits_end_a_geometry_with_its_last_good_results(self):
        for name, value in self.LIMITS:
            with self.subTest(name):
                self.assert_last_good_results(GEOMETRY, {name: value}, name)

    def test_limits_end_a_mechanism_with_its_last_good_results(self):
        for name, value in self.LIMITS[:2]:
            with self.subTest(name):
                self.assert_last_good_results(MECHANISM, {name: value}, name)

    def test_the_accuracy_that_was_reached_is_offered(self):
        case = self.copy_case(MECHANISM)
        change_case(case, {"Maximum unknowns": "6000"})  # enough for the first mesh with an estimate
        run = self.geneva("run", case)
        self.assertEqual(run.code, NOT_CONVERGED, run.describe())
        offered = float(re.search(r"be content with 'Accuracy' = (\S+) %", run.err).group(1)) / 100
        reached = read_summary(case / "results")["contact"]["peak_pressure_error"]
        self.assertTrue(reached <= offered < 1.11 * reached, (reached, offered))

    def test_limits_end_all_ranks_with_the_last_good_results(self):
        self.assert_last_good_results(GEOMETRY, {"Maximum refinement levels": "9"}, "Maximum refinement levels",
                                      ranks=2)


if __name__ == "__main__":
    geneva_cli.main()
