#!/usr/bin/env python3
"""Whether the reported errors of a wheel's maximum stresses away from the contact hold, on random wheels.

    python3 tests/benchmarks/strength_bar.py 0 99 --only even
    python3 tests/benchmarks/strength_bar.py 0 79 --only even --kind space --accuracy "5 %"

Runs external and internal wheels FIRST to LAST, at any instant of their engagement, at the structural accuracy asked
for and at a tenth of it, which is the truth; in 3-D those of error_bar.py's pins, with the contact at 10 % and, for the
truth, at 1.5 %. Prints a row for each wheel and
stress, and a summary. An error holds if the true one is at most that; where the truth's own error matters, the summary
has what both together hold as well. An error of 100 % or more is none, and counts apart.
"""

import argparse
import concurrent.futures
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import random_cases  # puts tests/cli on the path
from error_bar import percent, read_accuracy, share, table
from geneva_cli import environment, read_summary

ROOT = pathlib.Path(__file__).resolve().parents[2]
KINDS = {"plane": ("external", "external", "internal"),  # odd in number, so that odd and even seeds see all alike
         "space": random_cases.SERIES["space"]}
GEOMETRIES = ("crossed",)  # without a wheel
STRESSES = ("von_mises", "tensile")


def kind_of(series, seed):
    return KINDS[series][seed % len(KINDS[series])]


def case_text(series, seed, structural, contact):
    """Of case.prm: a wheel as random_cases draws them; `contact` is the accuracy of its pressure in 3-D."""
    limits = [("Structural accuracy", f"{100 * structural:.6g} %"), ("Maximum unknowns", 2000000)]
    kind = kind_of(series, seed)
    if series == "space":
        return random_cases.draw_case(series, seed).files(contact, limits)["case.prm"]
    draw = random_cases.Draw(f"geneva strength {seed}")
    parameters, _, _ = random_cases.wheel_contact(draw, kind)
    head = [("Title", f"wheel {seed}: {kind}"), ("Output units", "SI"), ("Accuracy", "1 %"), *limits]
    return "\n".join(random_cases.lines_of([*head, *parameters])) + "\n"


def run(program, series, seed, structural, contact=0.1):
    """The wheel's section of `strength`, or what stood in the way; and unknowns."""
    with tempfile.TemporaryDirectory(prefix="geneva-strength-") as place:
        (pathlib.Path(place) / "case.prm").write_text(case_text(series, seed, structural, contact))
        done = subprocess.run([program, "run", place], env={**environment(), "OMP_NUM_THREADS": "1"},
                              capture_output=True, text=True, errors="replace")
        results = pathlib.Path(place) / "results"
        if not (results / "summary.json").exists():
            return None, done.stderr.strip()[:200], 0
        summary = read_summary(results)
        message = "" if done.returncode == 0 else summary["solver"]["message"]
        return {name: stress or {"value": 0} for name, stress in summary["strength"]["wheel"].items()}, message, summary["mesh"]["dofs"]


def moved(one, other):
    return max(abs(one["place"][axis]["value"] - other["place"][axis]["value"]) for axis in one["place"])


def compared(seed, coarse, fine):
    """A row for each stress of a wheel: true error, reported one."""
    rows = []
    for stress in STRESSES:
        found, truth = coarse[stress], fine[stress]
        if not truth["value"] or not found["value"]:
            continue
        rows.append({"seed": seed, "stress": stress, "value": found["value"],
                     "true": found["value"] / truth["value"] - 1, "error": found["error"], "of_truth": truth["error"],
                     "moved": moved(found, truth)})
    return rows


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--accuracy", type=read_accuracy, default=0.02)
    parser.add_argument("--only", choices=("odd", "even"))
    parser.add_argument("--kind", choices=("plane", "space"), default="plane")
    parser.add_argument("--program", default=str(ROOT / "build/release/app/geneva"))
    return parser.parse_args()


def summary_lines(rows, accuracy):
    known = [row for row in rows if row["error"] < 1]
    ratios = [abs(row["true"]) / row["error"] for row in known]
    held = sum(ratio <= 1 for ratio in ratios)
    held_by_both = sum(abs(row["true"]) <= row["error"] + row["of_truth"] for row in known)
    kept = sum(abs(row["true"]) <= accuracy for row in rows)
    return (f"{share(held, len(known))} within the reported error, worst {max(ratios):.2f} times it, median "
            f"{statistics.median(ratios):.2f}; {share(held_by_both, len(known))} within both errors, of the truth "
            f"{percent(statistics.median(row['of_truth'] for row in rows))} in the middle; without an error "
            f"{len(rows) - len(known)}; {share(kept, len(rows))} within the accuracy asked for; mean signed error "
            f"{percent(statistics.mean(row['true'] for row in rows), signed=True)}")


def main():
    arguments = read_arguments()
    seeds = [seed for seed in range(arguments.first, arguments.last + 1)
             if (arguments.only is None or seed % 2 == (arguments.only == "odd"))
             and kind_of(arguments.kind, seed) not in GEOMETRIES]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        pairs = [(seed, pool.submit(run, arguments.program, arguments.kind, seed, arguments.accuracy),
                  pool.submit(run, arguments.program, arguments.kind, seed, arguments.accuracy / 10, 0.015))
                 for seed in seeds]
        rows = []
        lines = [("wheel", "kind", "stress", "MPa", "true", "reported", "ratio", "unknowns", "message")]
        for seed, coarse, fine in pairs:
            (found, message, unknowns), (truth, truth_message, _) = coarse.result(), fine.result()
            if not found or not truth:
                lines.append((seed, kind_of(arguments.kind, seed), "", "", "", "", "", "", message or truth_message))
                continue
            for row in compared(seed, found, truth):
                rows.append(row)
                lines.append((seed, kind_of(arguments.kind, seed), row["stress"], f"{row['value'] / 1e6:.5g}",
                              percent(row["true"], signed=True), percent(row["error"]),
                              f"{abs(row['true']) / row['error']:.2f}", unknowns, message or truth_message))
    print(table([tuple(map(str, line)) for line in lines]))
    print(summary_lines(rows, arguments.accuracy) if rows else "nothing to compare")
    return 0


if __name__ == "__main__":
    sys.exit(main())
