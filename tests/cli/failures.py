"""Every kind of failure has its exit code and one message, on one rank, on all of them, and on one of three only."""

import pathlib
import subprocess
import sys
import time

import geneva_cli
from geneva_cli import CliTest, environment

# Exit code and a part of the message by the kinds of throwing.cc.
KINDS = {"input": (1, "a wrong input"), "limit": (2, "a limit"), "not converged": (2, "no state"),
         "memory": (2, "memory ran out (throwing)"), "system": (1, "no such place"),
         "bug": (3, "a mistake"), "no exception": (3, "unknown exception")}
THROWING = pathlib.Path()


class Failures(CliTest):

    def assert_fails(self, kind, rank, ranks):
        launcher = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
        begin = time.monotonic()
        run = subprocess.run([*launcher, str(THROWING), kind, rank], env=environment(), capture_output=True, text=True,
                             timeout=60, check=False)
        code, text = KINDS[kind]
        self.assertEqual(run.returncode, code, run.stderr)
        self.assertEqual(run.stderr.count("geneva: "), 1, run.stderr)
        self.assertIn(text, run.stderr)
        self.assertEqual("report it" in run.stderr, code == 3, run.stderr)
        self.assertLess(time.monotonic() - begin, 20.)

    def test_alone(self):
        for kind in KINDS:
            with self.subTest(kind):
                self.assert_fails(kind, "all", 1)

    def test_on_all_ranks(self):
        for kind in KINDS:
            with self.subTest(kind):
                self.assert_fails(kind, "all", 3)

    def test_on_one_rank_while_the_others_wait_for_it(self):
        for i, kind in enumerate(KINDS):
            with self.subTest(kind):
                self.assert_fails(kind, str(i % 3), 3)


if __name__ == "__main__":
    THROWING = pathlib.Path(sys.argv.pop(3))
    geneva_cli.main()
