"""A run that has ended, in whatever way, is continued from its last mesh to the figures of an unbroken one."""

import contextlib
import resource
import signal
import subprocess
import time

import geneva_cli
from geneva_cli import CliTest, change_case, environment, flat, number, read_summary, replace_in

# Figures are the same but for the round-off of another start and another share of the ranks.
TOLERANCE = 1e-8
# Beside the names: how the solver came there, what is only round-off, and which of several equal places is named.
INCIDENTAL = ("case.name", "iterations", "residual", "checks", "place", "ranks", "notices")


def findings(results):
    """Every number of a summary that says something of the mechanism."""
    return {path: value for path, value in flat(read_summary(results)).items()
            if not any(part in path for part in INCIDENTAL)}


class Checkpoints(CliTest):

    def case(self, name="hertz-line-contact", to=None, **changes):
        case = self.copy_case(name, to)
        change_case(case, {"Checkpoint": "true", **{key.replace("_", " "): value for key, value in changes.items()}})
        return case

    def assert_same_findings(self, results, reference):
        ours, theirs = findings(results), findings(reference)
        self.assertEqual(ours.keys(), theirs.keys())
        for path, value in theirs.items():
            if isinstance(value, float):
                self.assert_same(ours[path], value, path, theirs["contact.force.value"])
            else:
                self.assertEqual(ours[path], value, path)

    def assert_same(self, ours, theirs, path, force):
        """Errors, which are shares of a figure and differences of meshes, by what they allow for the figure; components
        of reactions, of which some are round-off, by the contact's force."""
        scale = 1. if "error" in path or "difference" in path else abs(theirs)
        if path.startswith("reactions."):
            scale = force
        self.assertAlmostEqual(ours, theirs, delta=TOLERANCE * scale, msg=path)

    def assert_continues(self, case, ranks=None):
        run = self.geneva("run", "--continue", case, ranks=ranks)
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("continues from a mesh of", run.out)
        self.assertFalse(self.unfinished(case).exists())
        return run

    def assert_refused(self, case, *words):
        before = sorted(path.name for path in case.iterdir())
        run = self.geneva("run", "--continue", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertEqual(run.err.count("\n"), 1, run.describe())
        for word in words:
            self.assertIn(word, run.err)
        self.assertEqual(sorted(path.name for path in case.iterdir()), before)

    @staticmethod
    def unfinished(case):
        return case / ".results.checkpoint"

    def start(self, case):
        """A run that goes on while the test does something."""
        run = subprocess.Popen([str(self.program), "run", str(case)], cwd=self.directory, env=environment(),
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        return run

    def end_early(self, case, how):
        """Ends a run once it has left its second checkpoint."""
        run = self.start(case)
        deadline = time.monotonic() + geneva_cli.TIME_LIMIT
        seen = set()
        while len(seen) < 2:
            self.assertIsNone(run.poll(), "the run has ended before it left two checkpoints")
            self.assertLess(time.monotonic(), deadline)
            with contextlib.suppress(FileNotFoundError):
                seen.add(self.unfinished(case).stat().st_mtime_ns)
        run.send_signal(how)
        out, err = run.communicate(timeout=geneva_cli.TIME_LIMIT)
        return run.returncode, out, err


class Continued(Checkpoints):

    def test_a_run_that_met_its_limit_comes_to_the_figures_of_an_unbroken_one_on_any_number_of_ranks(self):
        unbroken = self.case(to="unbroken")
        self.run_case(unbroken)
        for ranks in (None, 3):
            broken = self.case(to=f"on {ranks}", Maximum_unknowns=2000)
            run = self.geneva("run", broken)
            self.assertEqual(run.code, 2, run.describe())
            self.assertIn("geneva run --continue", run.out)
            change_case(broken, {"Maximum unknowns": None})
            self.assert_continues(broken, ranks)
            self.assert_same_findings(broken / "results", unbroken / "results")

    def test_a_wheel_comes_to_the_same_figures(self):
        unbroken, broken = self.case("johnson-optimum-wheel", "unbroken"), self.case("johnson-optimum-wheel", "broken")
        self.run_case(unbroken)
        change_case(broken, {"Maximum unknowns": 4000})
        self.run_case(broken, ranks=2, code=2)
        change_case(broken, {"Maximum unknowns": None})
        self.assert_continues(broken)
        self.assert_same_findings(broken / "results", unbroken / "results")

    def test_a_pin_in_space_comes_to_the_same_figures(self):
        unbroken, broken = (self.case("crowned-pin", name, Accuracy="10 %") for name in ("unbroken", "broken"))
        self.run_case(unbroken)
        change_case(broken, {"Maximum unknowns": 20000})
        self.run_case(broken, ranks=3, code=2)
        change_case(broken, {"Maximum unknowns": None})
        self.assert_continues(broken, ranks=2)
        self.assert_same_findings(broken / "results", unbroken / "results")

    def test_a_killed_run_comes_to_the_same_figures(self):
        unbroken, broken = self.case(to="unbroken", Accuracy="0.02 %"), self.case(to="broken", Accuracy="0.02 %")
        self.run_case(unbroken)
        code, _, _ = self.end_early(broken, signal.SIGKILL)
        self.assertEqual(code, -signal.SIGKILL)
        self.assertFalse((broken / "results").exists())
        self.assert_continues(broken)
        self.assert_same_findings(broken / "results", unbroken / "results")

    def test_an_interrupted_run_says_how_to_go_on(self):
        case = self.case(Accuracy="0.02 %")
        code, _, err = self.end_early(case, signal.SIGTERM)
        self.assertEqual(code, 128 + signal.SIGTERM)
        self.assertIn(f"geneva run --continue {case}", err)
        self.assert_continues(case)

    def test_a_better_accuracy_needs_only_the_further_meshes(self):
        case = self.case(Accuracy="2 %")
        before = self.run_case(case)
        change_case(case, {"Accuracy": "0.02 %"})
        self.assert_continues(case)
        after = read_summary(case / "results")
        n_before = len(before["solver"]["levels"])
        self.assertGreater(len(after["solver"]["levels"]), n_before)
        self.assertEqual(flat(before["solver"]["levels"]), flat(after["solver"]["levels"][:n_before]))
        self.assertLessEqual(number(after["contact"]["peak_pressure_error"]), 2e-4)

    def test_a_run_that_had_all_is_at_once_at_its_end(self):
        case = self.case()
        self.run_case(case)
        reference = findings(case / "results")
        self.assert_continues(case)
        ours = findings(case / "results")
        for path, value in reference.items():
            if isinstance(value, float):
                self.assert_same(ours[path], value, path, reference["contact.force.value"])
        self.assertTrue((case / "results" / "checkpoint.bin").exists())


class Kept(Checkpoints):

    def test_in_the_plane_only_who_wants_a_checkpoint_gets_one(self):
        for wish, is_there in (("automatic", False), ("false", False), ("true", True)):
            case = self.case(to=wish, Checkpoint=wish)
            self.run_case(case)
            self.assertEqual((case / "results" / "checkpoint.bin").exists(), is_there, wish)
            self.assertFalse(self.unfinished(case).exists())

    def test_a_checkpoint_that_cannot_be_written_does_not_end_the_run(self):
        case = self.case()
        self.unfinished(case).mkdir()
        (self.unfinished(case) / "file").touch()
        run = self.geneva("run", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.err.count("could not be continued"), 1, run.describe())

    def test_a_new_run_tells_of_an_unfinished_one_and_takes_its_place(self):
        case = self.case(Accuracy="0.02 %")
        self.end_early(case, signal.SIGKILL)
        run = self.geneva("run", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertIn("an earlier run did not end", run.out)
        self.assertFalse(self.unfinished(case).exists())

    def test_a_run_that_fell_short_and_left_none_leaves_that_of_an_unfinished_one(self):
        case = self.case(Accuracy="0.02 %")
        self.end_early(case, signal.SIGKILL)
        change_case(case, {"Checkpoint": "false", "Maximum unknowns": "1000"})
        self.run_case(case, code=2)
        self.assertTrue(self.unfinished(case).exists())
        change_case(case, {"Maximum unknowns": None})
        self.assert_continues(case)

    def test_when_memory_runs_out_the_last_mesh_has_results(self):
        case = self.case("crowned-pin", Accuracy="0.2 %", Checkpoint="false")
        limit = 1050 * 2**20

        def limited():
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

        run = subprocess.run([str(self.program), "run", str(case)], env=environment(), stdin=subprocess.DEVNULL,
                             capture_output=True, text=True, preexec_fn=limited, timeout=geneva_cli.TIME_LIMIT)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertRegex(run.stderr, r"memory ran out on a mesh of \d+ unknowns")
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        summary = read_summary(case / "results")
        self.assertLess(number(summary["contact"]["peak_pressure_error"]), 0.1)


class Refused(Checkpoints):

    def test_without_a_checkpoint_there_is_nothing_to_continue(self):
        case = self.case(Checkpoint="false")
        self.assert_refused(case, "no checkpoint", ".results.checkpoint", "checkpoint.bin", "'Checkpoint' = true")

    def test_a_changed_case_is_named(self):
        case = self.case("johnson-optimum-wheel")
        self.run_case(case)
        change_case(case, {"Title": "another title", "Accuracy": "0.4 %", "Output units": "SI"})
        self.assert_continues(case)
        change_case(case, {"Mechanism/Wheel material/Young's modulus": "29.1e6 psi"})
        self.assert_refused(case, "Mechanism / Wheel material / Young's modulus", "29.1e6 psi", "without --continue")

    def test_a_changed_geometry_is_named(self):
        case = self.case()
        self.run_case(case)
        with (case / "geometry.geo").open("a") as geometry:
            geometry.write("\n// changed\n")
        self.assert_refused(case, "geometry.geo has changed")

    def test_a_damaged_checkpoint_is_refused(self):
        case = self.case()
        self.run_case(case)
        file = case / "results" / "checkpoint.bin"
        whole = file.read_bytes()
        middle = len(whole) // 2
        for damaged in (b"", b"geneva checkpoint \n", whole[:middle], whole[:-1], whole + b"1", b"\0" * len(whole),
                        whole[:middle] + bytes([whole[middle] ^ 1]) + whole[middle + 1:]):
            file.write_bytes(damaged)
            self.assert_refused(case, "checkpoint.bin", "damaged")


if __name__ == "__main__":
    geneva_cli.main()
