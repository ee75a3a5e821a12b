"""What a new user types first: help, a new case, materials, and what is said of slips."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

import geneva_cli
from geneva_cli import CliTest, environment, look_up, number, read_summary

COMMANDS = ("init", "run", "kinematics", "estimate", "design", "synthesize", "report", "materials", "parameters", "help",
            "version", "man", "completion")
TYPES = ("external", "internal", "spherical", "long-dwell", "four-bar")


class FirstSteps(CliTest):

    def call(self, *arguments, directory=None, changes=None):
        return subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=False,
                              cwd=directory or self.directory, env={**environment(), **(changes or {})})

    def prints(self, *arguments, directory=None, changes=None):
        run = self.call(*arguments, directory=directory, changes=changes)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr, "")
        return run.stdout

    def refuses(self, *arguments, directory=None, changes=None):
        run = self.call(*arguments, directory=directory, changes=changes)
        self.assertEqual(run.returncode, 1, run.stdout)
        return run.stderr

    def test_the_name_alone_prints_help_with_three_examples(self):
        text = self.prints()
        examples = re.findall(r"^  geneva \w+ .*", text.split("Examples:")[1], re.MULTILINE)
        self.assertEqual(len(examples), 3)
        for command in COMMANDS:
            self.assertIn(f"\n  {command} ", text)

    def test_help_and_version_are_commands(self):
        self.assertEqual(self.prints("help", "run"), self.prints("run", "--help"))
        self.assertIn("Usage: geneva run [OPTIONS] [CASE_DIR]", self.prints("help", "run"))
        self.assertEqual(self.prints("version"), self.prints("--version"))
        self.assertIn("did you mean 'geneva kinematics'", self.refuses("help", "kinematic"))

    def test_a_word_that_is_no_command_is_named_with_the_nearest(self):
        self.assertIn("'rnu' is no command: did you mean 'geneva run'?", self.refuses("rnu"))
        self.assertIn("geneva: --with: 'dsign': one of run, estimate, kinematics, design is wanted; did you mean 'design'?",
                      self.refuses("sweep", "wheel", "--set", "Mechanism/Stations = 4; 5", "--with", "dsign"))
        self.prints("init", "wheel")
        self.assertIn("did you mean 'geneva run wheel'?", self.refuses("wheel"))
        self.assertIn("'geneva help' lists the commands", self.refuses("whatever"))

    def test_a_new_case_of_every_type_and_unit_system_runs_at_once(self):
        for index, kind in enumerate((*TYPES, "geometry")):
            units = ("SI", "mm-N", "in-lbf")[index % 3]
            with self.subTest(kind):
                self.prints("init", kind, "--type", kind, "--units", units)
                case = self.directory / kind
                summary = self.run_case(case)
                self.assertEqual(look_up(summary, "case.output_units"), units)
                self.assertLess(summary["accuracy"]["error_estimate"], 0.005)
                for check in summary["checks"]:
                    self.assertTrue(check["passed"], check)

    def test_it_has_the_stations_asked_for_and_moves(self):
        for kind in TYPES:
            for stations in (3, 5, 12):
                with self.subTest(f"{kind} {stations}"):
                    case = self.directory / f"{kind}-{stations}"
                    self.prints("init", case, "--type", kind, "--stations", stations)
                    self.assertIn("pin force", self.prints("kinematics", case))

    def test_a_new_case_overwrites_nothing_and_wrong_words_write_nothing(self):
        self.prints("init", "wheel")
        self.assertIn("case.prm is there already", self.refuses("init", "wheel"))
        for wrong, words in ((("--type", "internl"), "did you mean 'internal'"), (("--stations", "2"), "from 3 to 24"),
                             (("--stations", "5.5"), "'5.5': a whole number from 3 to 24 is wanted"),
                             (("--type", "geometry", "--stations", "5"), "a geometry is no wheel"),
                             (("--units", "mm"), "mm-N")):
            self.assertIn(words, self.refuses("init", "other", *wrong))
            self.assertFalse((self.directory / "other").exists())

    def test_without_a_directory_the_current_one_is_meant(self):
        case = self.directory / "here"
        case.mkdir()
        self.prints("init", directory=case)
        for command in ("run", "kinematics", "estimate", "design"):
            self.assertEqual(self.call(command, directory=case).returncode, 0, command)
        self.assertTrue((case / "results" / "summary.json").exists())
        self.assertIn("'geneva init' writes one", self.refuses("run", directory=self.directory))

    def test_a_material_by_name_gives_its_values_and_own_ones_go_before_them(self):
        case = self.directory / "steel"
        self.prints("init", case)
        text = (case / "case.prm").read_text()
        summary = self.run_case(case)
        factors = {row["quantity"]: row for row in summary["safety"]}
        pressure = look_up(summary, "contact.peak_pressure")["value"]
        yielding = factors["contact, first yield, wheel"]
        self.assert_close(number(yielding["allowed"]), 1.79367 * 750e6, 1e-5, "elastic limit")
        self.assert_close(yielding["computed_factor"], number(yielding["allowed"]) / pressure, 1e-12, "factor")
        self.assert_close(number(factors["contact, shakedown, wheel"]["allowed"]), 4 / 3**0.5 * 750e6, 1e-5, "shakedown")
        self.assert_close(number(factors["contact, pitting, wheel"]["allowed"]), 780e6, 1e-12, "flanks")
        self.assertTrue(any("typical values" in notice for notice in summary["notices"]))
        (case / "case.prm").write_text(text.replace("tempered\n", "tempered\n    set Yield strength = 500 MPa\n"))
        rows = {row["quantity"]: row for row in self.run_case(case)["safety"]}
        self.assert_close(number(rows["contact, first yield, wheel"]["allowed"]), 1.79367 * 500e6, 1e-5, "own value")
        self.assertRegex((case / "results" / "case.prm").read_text(), r"set Contact pressure\s*= 780 MPa")
        (case / "case.prm").write_text(text.replace("tempered\n", "tempered\n    set Contact pressure = 700 MPa\n"))
        rows = {row["quantity"]: row for row in self.run_case(case)["safety"]}
        self.assert_close(number(rows["contact, pitting, wheel"]["allowed"]), 700e6, 1e-12, "own contact pressure")

    def test_a_hardened_layer_bears_what_its_depth_leaves_the_core(self):
        case = self.directory / "hardened"
        self.prints("init", case)
        text = (case / "case.prm").read_text()
        allowed = {}
        for depth in ("10 mm", "0.3 mm", "1 nm"):
            (case / "case.prm").write_text(text.replace(
                "Material = 42CrMo4 quenched and tempered\n",
                f"Material = 16MnCr5 case-hardened\n    set Hardness = 600\n    set Hardened depth = {depth}\n"))
            rows = {row["quantity"]: row for row in self.run_case(case)["safety"]}
            allowed[depth] = number(rows["contact, first yield, wheel"]["allowed"])
            stress = number(rows["maximum von Mises stress of the wheel"]["allowed"])
            layer = 600 * 9.80665e6 / 3
            self.prints("kinematics", case)
            known = json.loads((case / "results" / "kinematics.json").read_text())["safety"]
            self.assertEqual(len(known), 5, "pitting of a case that is softer than usual is unknown")
            for row in known:  # the same closed forms
                self.assert_close(number(row["allowed"]), number(rows[row["quantity"]]["allowed"]), 1e-9, row["quantity"])
            self.assert_close(stress, 590e6 if depth == "1 nm" else layer, 1e-9, "von Mises stress")
        self.assert_close(allowed["10 mm"], 1.79367 * layer, 1e-4, "the layer's")
        self.assert_close(allowed["1 nm"], 1.79367 * 590e6, 1e-3, "the core's")
        self.assertTrue(allowed["1 nm"] < allowed["0.3 mm"] < allowed["10 mm"], allowed)
        (case / "case.prm").write_text(text.replace("  subsection Pin material", "  set Slot friction = 1.2\n  subsection Pin material"))
        rows = [row["quantity"] for row in self.run_case(case)["safety"]]
        self.assertIn("contact, pitting, wheel", rows)
        self.assertFalse([row for row in rows if "first yield" in row or "shakedown" in row], "known up to mu = 1")
        (case / "case.prm").write_text(text.replace("tempered\n", "tempered\n    set Hardness = 340\n"))
        rows = {row["quantity"]: row for row in self.run_case(case)["safety"]}
        self.assert_close(number(rows["contact, pitting, wheel"]["allowed"]), (1.313 * 340 + 373) * 1e6, 1e-9, "pitting")
        (case / "case.prm").write_text(text.replace("Material = 42CrMo4 quenched and tempered\n", "Hardened depth = 1 mm\n"))
        self.assertIn("'Hardness' is missing", self.refuses("run", case))
        (case / "case.prm").write_text(text.replace("Material = 42CrMo4 quenched and tempered\n",
                                                    "Hardened depth = 1 mm\n    set Hardness = 600\n"))
        self.assertIn("'Yield strength' is missing", self.refuses("run", case))

    def test_a_material_is_found_by_its_other_names(self):
        self.assertIn("'42CrMo4 nitrided'", self.refuses("materials", "AISI 4140"))
        self.assertIn("'S235JR'", self.refuses("materials", "steel"))
        self.assertIn("'POM-C'", self.refuses("materials", "acetal"))

    def test_an_unknown_material_is_told_those_of_its_grade(self):
        self.assertIn("one of 'C45 normalised', 'C45 quenched and tempered'", self.refuses("materials", "C46"))
        for name in ("42CrMo4 QT", "42CrMo5 something else"):
            self.assertIn("'42CrMo4 nitrided'", self.refuses("materials", name))
        self.assertNotIn("did you mean", self.refuses("materials", "unobtainium"))

    def test_a_file_of_materials_adds_to_them(self):
        case = self.directory / "own"
        self.prints("init", case)
        prm = (case / "case.prm").read_text().replace("42CrMo4 quenched and tempered", "our bronze")
        (case / "case.prm").write_text(prm)
        self.assertIn("no such material is known", self.refuses("run", case))
        (case / "materials.prm").write_text("subsection our bronze\n  set Young's modulus = 100 GPa\n  set Source = us\nend\n")
        self.assertIn("our bronze", self.prints("materials", directory=case))
        self.run_case(case)
        (case / "materials.prm").write_text("subsection our bronze\n  set Young's modulus = 100\n  set Source = us\nend\n")
        self.assertIn("materials.prm, line 2", self.refuses("run", case))
        self.assertNotIn("'Pin material/Material'", self.refuses("run", case))
        self.assertIn("no such directory", self.refuses("materials", "--case", self.directory / "nowhere"))
        (case / "materials.prm").unlink()
        home = self.directory / "configuration"
        (home / "geneva").mkdir(parents=True)
        (home / "geneva" / "materials.prm").write_text(
            "subsection our bronze\n  set Young's modulus = 90 GPa\n  set Source = us\nend\n")
        self.assertIn("our bronze", self.prints("materials", changes={"XDG_CONFIG_HOME": str(home)}))

    def test_every_material_of_the_list_has_values_in_their_order_and_a_source(self):
        rows = [line for line in self.prints("materials").splitlines()[2:] if re.search(r"\d  +\S", line)]
        self.assertGreater(len(rows), 30)
        self.assertGreaterEqual(sum("-" not in re.split(r"  +", row) for row in rows), 30, "with all values")
        for row in rows:
            name, modulus, nu, density, *limits = re.split(r"  +", row.strip())
            self.assertTrue(1 < float(modulus) < 250 and 0.2 < float(nu) < 0.45 and 1000 < float(density) < 9000, row)
            *stresses, wear = limits
            strength, fatigue, _ = (float(limit) if limit != "-" else None for limit in stresses)
            self.assertTrue(fatigue is None or fatigue <= strength, row)
            lubricated, dry = map(float, wear.split(".."))
            self.assertTrue(1e-18 < lubricated < dry < 1e-11, row)
            self.assertRegex(self.prints("materials", name), r"Source +\S")

    def test_slips_in_a_case_are_answered_with_what_was_meant(self):
        case = self.directory / "slips"
        self.prints("init", case)
        good = (case / "case.prm").read_text()
        for old, new, words in (("500 N.mm", "2 Nm", "did you mean 'N.m'?"), ("500 N.mm", "2 lbfin", "did you mean 'lbf.in'?"),
                                ("  subsection Pin material", "  set Wheel material = 42CrMo4\n  subsection Pin material",
                                 "write 'subsection Wheel material', below it 'set NAME = VALUE' lines such as "
                                 "'set Material = 42CrMo4'"),
                                ("300 rpm", "300 1/min", "did you mean 'rpm'?"),
                                ("100Cr6 hardened", "100Cr6 hardend", "did you mean '100Cr6 hardened'?"),
                                ("100Cr6 hardened", "42crmo4", "'42CrMo4 nitrided'")):
            (case / "case.prm").write_text(good.replace(old, new))
            self.assertIn(words, self.refuses("run", case))

    def test_manual_pages_are_ones(self):
        for command in ("", *COMMANDS):
            page = self.prints("man", *([command] if command else []))
            self.assertTrue(page.startswith(".TH GENEVA"))
            self.assertFalse([line for line in page.splitlines() if line.startswith("'")], "a line of no macro")
            for section in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS"):
                self.assertIn(f".SH {section}\n", page)
        self.assertIn("\\fB\\-o, \\-\\-output\\fR \\fIDIR\\fR", self.prints("man", "run"))
        if shutil.which("man"):
            with tempfile.TemporaryDirectory() as directory:
                file = pathlib.Path(directory) / "geneva-run.1"
                file.write_text(self.prints("man", "run"))
                shown = subprocess.run(["man", "-l", file], capture_output=True, text=True, check=True,
                                       env={**os.environ, "MANWIDTH": "100"}).stdout
                self.assertIn("geneva run [OPTIONS] [CASE_DIR]", shown)

    def test_completion_knows_commands_options_and_directories(self):
        script = self.directory / "completion"
        script.write_text(self.prints("completion", "bash"))
        self.prints("init", "my-wheel")

        def completed(*words):
            line = " ".join(words)
            run = subprocess.run(
                ["bash", "-c", f"source {script}; COMP_WORDS=({line}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); "
                 "_geneva; printf '%s\\n' \"${COMPREPLY[@]}\""],
                capture_output=True, text=True, check=True, cwd=self.directory)
            return run.stdout.split()

        self.assertEqual(completed("geneva", "kin"), ["kinematics"])
        self.assertEqual(completed("geneva", "run", "--con"), ["--continue"])
        self.assertEqual(completed("geneva", "run", "my"), [], "directories are left to the shell")
        self.assertIn("complete -o dirnames", script.read_text())
        self.assertEqual(completed("geneva", "sweep", "--with", "k"), ["kinematics"])
        self.assertEqual(completed("geneva", "help", "opt"), ["optimise"])
        self.assertEqual(completed("geneva", "init", "--type", "long"), ["long-dwell"])
        self.assertTrue(self.prints("completion", "zsh").startswith("#compdef geneva"))
        self.assertIn(":value:(external internal spherical", self.prints("completion", "zsh"))
        self.assertIn("-l output -r", self.prints("completion", "fish"))
        self.assertIn("-x -a 'run estimate kinematics design'", self.prints("completion", "fish"))
        self.assertIn("bash", self.refuses("completion", "tcsh"))


if __name__ == "__main__":
    geneva_cli.main()
