"""Every kind of failure has its exit code and one message, on one rank, on all of them, and on one of three only.

throwing.cc does nothing but fail; throws.cc makes a run fail in the n-th of its calls by which ranks exchange data, from
the reading of the mesh to the writing of the results. GENEVA_FAULTS=all tries more n.
"""

import os
import pathlib
import subprocess
import sys
import time

import geneva_cli
from geneva_cli import CliTest, environment, read_summary

# Exit code and a part of the message by the kinds of failure_kinds.h, and of throwing.cc.
KINDS = {"input": (1, "a wrong input"), "limit": (2, "a limit"),
         "memory": (2, "memory ran out"), "system": (1, "no such place"),
         "bug": (3, "a mistake"), "no exception": (3, "unknown exception")}
ALL_KINDS = {**KINDS, "not converged": (2, "finer meshes will not help")}
THROWING = pathlib.Path()
THROWS = pathlib.Path()
MOMENTS = 25 if os.environ.get("GENEVA_FAULTS") == "all" else 1


class Failures(CliTest):

    def assert_fails(self, kind, rank, ranks):
        launcher = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        begin = time.monotonic()
        run = subprocess.run([*launcher, str(THROWING), kind, rank], env=environment(), capture_output=True, text=True,
                             timeout=60, check=False)
        code, text = ALL_KINDS[kind]
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertEqual(run.stderr.count("geneva: "), 1, run.stderr)
        self.assertIn(text, run.stderr)
        self.assertEqual("report it" in run.stderr, code == 3, run.stderr)
        self.assertLess(time.monotonic() - begin, 20.)

    def test_alone(self):
        for kind in ALL_KINDS:
            with self.subTest(kind):
                self.assert_fails(kind, "all", 1)

    def test_on_all_ranks(self):
        for kind in ALL_KINDS:
            with self.subTest(kind):
                self.assert_fails(kind, "all", 3)

    def test_on_one_rank_while_the_others_wait_for_it(self):
        for i, kind in enumerate(ALL_KINDS):
            with self.subTest(kind):
                self.assert_fails(kind, str(i % 3), 3)


class FailuresOfARun(CliTest):

    def setUp(self):
        super().setUp()
        self.case = self.copy_case("hertz-line-contact", "case")
        self.text = geneva_cli.set_parameter((self.case / "case.prm").read_text(), "Accuracy", "5 %")
        self.titled("old")
        self.run_case(self.case)
        self.titled("new")

    def titled(self, title):
        (self.case / "case.prm").write_text(geneva_cli.set_parameter(self.text, "Title", title))

    def run_throwing(self, ranks, **throw):
        """On three ranks, of which some throw."""
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe"]
        variables = {"LD_PRELOAD": THROWS, **{f"GENEVA_THROW{name}": value for name, value in throw.items()}}
        for rank in range(3):
            fault = [word for name, value in variables.items() for word in ("-x", f"{name}={value}")]
            command += ["-n", "1", *(fault if rank in ranks else []), str(self.program), "run", str(self.case), ":"]
        return subprocess.run(command[:-1], env=environment(), capture_output=True, text=True, timeout=200, check=False)

    def counted(self):
        """The exchanges of a run that succeeds."""
        file = self.directory / "count"
        run = self.run_throwing((0, 1, 2), _COUNT=file)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.titled("newer")
        return min(map(int, file.read_text().split()))

    def test_in_every_phase_on_all_ranks_or_one_of_three(self):
        count = self.counted()
        moments = len(KINDS) * MOMENTS
        for i in range(moments):
            kind = list(KINDS)[i % len(KINDS)]
            failing = ((0,), (0, 1, 2), (1,), (2,))[i % 4]
            at = 1 + i * (count - 1) // (moments - 1)
            with self.subTest(kind=kind, ranks=failing, at=at):
                self.check(self.run_throwing(failing, **{"": kind, "_AT": at}), kind)

    def check(self, run, kind):
        code, text = KINDS[kind]
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertEqual(run.stderr.count("geneva: "), 1, run.stderr)
        self.assertIn(text, run.stderr)
        self.assertEqual("report it" in run.stderr, code == 3, run.stderr)
        self.assertEqual([path.name for path in self.case.iterdir() if path.name.startswith(".")], [])
        if read_summary(self.case / "results")["case"]["title"] == "newer":  # those of the last mesh
            self.assertEqual(kind, "memory")


if __name__ == "__main__":
    THROWING = pathlib.Path(sys.argv.pop(3))
    THROWS = pathlib.Path(sys.argv.pop(3))
    geneva_cli.main()
