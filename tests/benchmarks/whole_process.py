#!/usr/bin/env python3
"""What a run costs as a whole process on one core: start, meshing, all levels, files.

    python3 tests/benchmarks/whole_process.py build/release/app/geneva [RUNS]

Prints wall time and peak memory (minimum, median, maximum) of the runs after one warm-up, and the contact solve's total
time over that of one assembly and one linear solve on its finest mesh. Targets: 1.5 s, 500 MB and a ratio below 4.
"""

import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

CASES = ("hertz-line-contact", "johnson-optimum-wheel")
ROOT = pathlib.Path(__file__).resolve().parents[2]


def run_once(geneva, case, output):
    start = time.perf_counter()
    process = subprocess.Popen([geneva, "run", ROOT / "cases" / case, "--output", output], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - start
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{case}: geneva ended with {os.waitstatus_to_exitcode(status)}")
    summary = json.loads((pathlib.Path(output) / "summary.json").read_text())
    solve = summary["time"]["solve"]["value"]
    one_solve = summary["solver"]["finest_assembly_and_solve"]["value"]
    return {"wall [s]": seconds, "cpu [s]": usage.ru_utime + usage.ru_stime, "memory [MB]": usage.ru_maxrss / 1024,
            "solve / one solve": solve / one_solve}


def main():
    geneva = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    for case in CASES:
        with tempfile.TemporaryDirectory() as output:
            measured = [run_once(geneva, case, output) for _ in range(runs + 1)][1:]
        print(f"{case} ({runs} runs)")
        for name in measured[0]:
            values = [run[name] for run in measured]
            print(f"  {name:<20}{min(values):10.3f}{statistics.median(values):10.3f}{max(values):10.3f}")


if __name__ == "__main__":
    main()
