"""Whatever the system fails at, a results directory holds old or new results whole.

faults.cc counts the calls of a run that write below its case's directory (write, open, rename, fsync, mkdir, link ...)
and its allocations, and makes the n-th fail. GENEVA_FAULTS=all tries every call, and of the million allocations the
first with each stack of calls; GENEVA_FAULTS=1000 tries a thousand of each, evenly chosen; else a few do.
"""

import concurrent.futures
import errno
import os
import pathlib
import queue
import signal
import subprocess
import sys
import unittest

import geneva_cli
from geneva_cli import CliTest, read_summary

SHIM = pathlib.Path()
FAULTS = os.environ.get("GENEVA_FAULTS", "12")
TRIES = None if FAULTS == "all" else int(FAULTS)
TIME_LIMIT = 120


def some_of(count, tries=TRIES):
    """Numbers from 1 to count, all or evenly chosen."""
    if tries is None or tries >= count:
        return range(1, count + 1)
    return sorted({1 + i * (count - 1) // (tries - 1) for i in range(tries)})


class Victim:
    """A case with old results that a run is going to replace, and what a run that failed has left of them."""

    def __init__(self, test, name):
        self.test = test
        self.case = test.copy_case("hertz-line-contact", name)
        text = (self.case / "case.prm").read_text()
        self.text = geneva_cli.set_parameter(text, "Accuracy", "5 %")
        self.titled("old")
        test.run_case(self.case)
        self.old = self.content()
        self.titled("new")

    def titled(self, title):
        (self.case / "case.prm").write_text(geneva_cli.set_parameter(self.text, "Title", title))

    def content(self):
        return {path.name: path.read_bytes() for path in (self.case / "results").iterdir()}

    def run_failing(self, command="run", program="geneva-solver", **faults):
        environment = {**geneva_cli.environment(), "LD_PRELOAD": str(SHIM), "GENEVA_FAULT_PATH": str(self.case),
                       "GENEVA_FAULT_PROGRAM": program}
        for name, value in faults.items():
            environment[f"GENEVA_FAULT_{name.upper()}"] = str(value)
        return subprocess.run([str(self.test.program), command, str(self.case)], env=environment, capture_output=True,
                              text=True, timeout=TIME_LIMIT, check=False)

    def run_on_three_ranks(self, failing, allocation):
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe"]
        for rank in range(3):
            fault = ["-x", f"LD_PRELOAD={SHIM}", "-x", "GENEVA_FAULT_PROGRAM=geneva-solver", "-x",
                     f"GENEVA_FAULT_NEW={allocation}"] if rank == failing else []
            command += ["-n", "1", *fault, str(self.test.program), "run", str(self.case), ":"]
        return subprocess.run(command[:-1], env=geneva_cli.environment(), capture_output=True, text=True,
                              timeout=TIME_LIMIT, check=False)

    def counted(self):
        """The number of calls of a run that succeeds, and that of the first allocation in each place of the program, in
        ascending order; its results are taken back."""
        count, places = self.test.directory / "count", self.test.directory / "places"
        run = self.run_failing(count=count, places=places)
        self.test.assertEqual(run.returncode, 0, run.stderr)
        self.put_back()
        calls = max(int(line.split()[0]) for line in count.read_text().splitlines())  # Open MPI's daemon counts, too
        return calls, sorted(map(int, places.read_text().split()))

    def put_back(self):
        for path in (self.case / "results").iterdir():
            path.unlink()
        for name, content in self.old.items():
            (self.case / "results" / name).write_bytes(content)

    def assert_whole(self, must_be_new=None):
        """Old or new results whole, which of them.

        must_be_new -- whether a run says that it succeeded
        """
        is_new = read_summary(self.case / "results")["case"]["title"] == "new"
        if is_new:
            names = {path.name for path in (self.case / "results").iterdir()}
            self.test.assertEqual(names - {"solution.1.vtu", "solution.2.vtu"}, set(self.old))  # pieces of other ranks
            for name in ("case.prm", "report.html"):
                self.test.assertIn("new", (self.case / "results" / name).read_text())
            self.put_back()
        else:
            self.test.assertEqual(self.content(), self.old)
        if must_be_new:
            self.test.assertTrue(is_new, "exit code 0 without the new results")
        return is_new

    def assert_nothing_is_left(self):
        self.test.assertEqual([path.name for path in self.case.iterdir() if path.name.startswith(".")], [])


class Faults(CliTest):

    def setUp(self):
        super().setUp()
        self.victim = Victim(self, "case")

    def check(self, run, **faults):
        with self.subTest(**faults):
            self.assertIn(run.returncode, (0, 1), run.stderr)
            self.victim.assert_whole(must_be_new=run.returncode == 0)
            self.victim.assert_nothing_is_left()
            if run.returncode == 1:
                self.assertIn(os.strerror(errno.ENOSPC), run.stderr)
                self.assertEqual(len(run.stderr.strip().splitlines()), 1, run.stderr)

    def test_every_call_that_writes_may_fail(self):
        calls, _ = self.victim.counted()
        self.assertGreater(calls, 20)
        for n in some_of(calls):
            self.check(self.victim.run_failing(at=n), at=n)

    def test_the_disk_may_be_full_from_any_call_on(self):
        calls, _ = self.victim.counted()
        for n in some_of(calls):
            self.check(self.victim.run_failing(at=n, **{"for": "all"}), at=n, on="all")

    def test_it_may_be_killed_at_any_call_that_writes(self):
        calls, _ = self.victim.counted()
        seen = set()
        for n in some_of(calls):
            with self.subTest(killed_at=n):
                run = self.victim.run_failing(at=n, kill=1)
                self.assertEqual(run.returncode, -signal.SIGKILL)
                seen.add(self.victim.assert_whole())
        self.assertIn(False, seen)
        self.victim.titled("old")
        self.run_case(self.victim.case)  # mends what the kills left
        self.victim.assert_nothing_is_left()

    def test_memory_may_run_out_at_any_allocation(self):
        _, places = self.victim.counted()
        self.assertGreater(len(places), 1000)
        chosen = [places[i - 1] for i in some_of(len(places))]
        # As many runs at a time as there are cores, each of a case of its own with a path as long.
        workers = len(os.sched_getaffinity(0))
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            idle = queue.SimpleQueue()
            for i in range(workers):
                idle.put(Victim(self, f"cas{i}"))
            for n, complaint in zip(chosen, pool.map(lambda n: complaint_of_failing(idle, n), chosen)):
                with self.subTest(allocation=n):
                    self.assertIsNone(complaint)

    def test_memory_may_run_out_at_any_allocation_without_the_solver(self):
        case = self.copy_case("johnson-optimum-wheel")
        environment = {**geneva_cli.environment(), "LD_PRELOAD": str(SHIM), "GENEVA_FAULT_PROGRAM": "geneva"}
        results = case / "results" / "kinematics.json"

        def run(**faults):
            return subprocess.run([str(self.program), "kinematics", str(case), "--steps", "4"], capture_output=True,
                                  env={**environment, **faults}, text=True, timeout=TIME_LIMIT, check=False)

        places = self.directory / "places"
        self.assertEqual(run(GENEVA_FAULT_PLACES=str(places)).returncode, 0)
        old = results.read_bytes()
        allocations = sorted(map(int, places.read_text().split()))
        self.assertGreater(len(allocations), 300)
        for i in some_of(len(allocations)):
            with self.subTest(allocation=allocations[i - 1]):
                end = run(GENEVA_FAULT_NEW=str(allocations[i - 1]))
                self.assertIn(end.returncode, (0, 1, 2, 3), end.stderr)
                if end.returncode != 0:
                    self.assertEqual(end.stderr.count("geneva: "), 1, end.stderr)
                    self.assertEqual(results.read_bytes(), old)
                old = results.read_bytes()
                self.assertEqual([path.name for path in case.iterdir() if path.name.startswith(".")], [])

    def test_memory_may_run_out_on_one_rank_only(self):
        """One message, no rank that waits for ever, nothing left behind."""
        _, places = self.victim.counted()
        for rank in (0, 1, 2):
            for n in places[rank::len(places) // (3 if TRIES == 12 else 33)]:
                with self.subTest(rank=rank, allocation=n):
                    run = self.victim.run_on_three_ranks(rank, n)
                    self.victim.assert_whole(must_be_new=run.returncode == 0)
                    self.assertIn(run.returncode, (0, 2, 3), run.stderr)
                    self.assertEqual(run.stderr.count("geneva: "), 0 if run.returncode == 0 else 1, run.stderr)
                    self.victim.assert_nothing_is_left()


def complaint_of_failing(idle, allocation):
    """What is wrong where an allocation fails, or None.

    idle -- the victims that no other thread is using
    """
    victim = idle.get()
    try:
        run = victim.run_failing(new=allocation)
        victim.test.assertIn(run.returncode, (0, 1, 2, 3), run.stderr)
        victim.assert_whole(must_be_new=run.returncode == 0)
        victim.assert_nothing_is_left()
    except (AssertionError, OSError, ValueError, subprocess.TimeoutExpired) as error:
        victim.put_back()
        return f"{type(error).__name__}: {error}"
    finally:
        idle.put(victim)
    return None


if __name__ == "__main__":
    SHIM = pathlib.Path(sys.argv.pop(3))
    geneva_cli.main()
