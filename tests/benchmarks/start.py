#!/usr/bin/env python3
"""What the commands take from their start to their end, beside their own work.

    python3 tests/benchmarks/start.py build/release/app/geneva [RUNS]

Prints the median, minimum and maximum wall time of RUNS runs (20) after one warm-up. For `run` the time that the program
reports as its own stands beside: the rest is the start and the end of the process. Targets: 0.1 s without finite elements,
0.9 s for a plane run of 0.45 s.
"""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
WHEEL = ROOT / "cases" / "johnson-optimum-wheel"


def commands(output):
    own = ("--output", output)
    return {
        "--version": ("--version",),
        "--help": ("--help",),
        "parameters": ("parameters",),
        "kinematics": ("kinematics", WHEEL, *own),
        "design": ("design", WHEEL, *own),
        "synthesize": ("synthesize", ROOT / "cases" / "synthesis-quick-return", *own),
        "report": ("report", output / "run", "--output", output / "report.html"),
        "run": ("run", WHEEL, "--output", output / "run"),
    }


def seconds_of(program, arguments):
    start = time.perf_counter()
    subprocess.run([program, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start


def main():
    program = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    with tempfile.TemporaryDirectory() as directory:
        output = pathlib.Path(directory)
        seconds_of(program, commands(output)["run"])
        for name, arguments in commands(output).items():
            seconds_of(program, arguments)
            taken, own = [], []
            for _ in range(runs):
                taken.append(seconds_of(program, arguments))
                if name == "run":
                    own.append(json.loads((output / "run" / "summary.json").read_text())["time"]["total"]["value"])
            print(f"{name:<12}{statistics.median(taken):8.3f} s  ({min(taken):.3f} to {max(taken):.3f})"
                  + (f", {statistics.median(own):.3f} s of its own" if own else ""))


if __name__ == "__main__":
    main()
