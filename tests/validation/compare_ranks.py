#!/usr/bin/env python3
"""Runs contact_figures on 1, 2, 3 and 4 MPI ranks and compares what it prints.

    compare_ranks.py MPIEXEC PROGRAM

Counts must be equal and figures agree to 1e-8: conjugate gradients stop at 1e-11 of the load, and the order of the
unknowns, which depends on the ranks, changes where in that range they stop.
"""

import re
import subprocess
import sys

RANKS = (1, 2, 3, 4)
TOLERANCE = 1e-8
# Overlaps of open nodes that are round-off, as a share of the half-width (b/R = 1/186).
NO_OVERLAP = 1e-12


def figures(mpiexec, program, ranks):
    """The program's words, with its numbers as int or float."""
    command = [mpiexec, "--oversubscribe", "-n", str(ranks), program]
    output = subprocess.run(command, check=True, capture_output=True, text=True, timeout=120).stdout
    words = []
    for word in output.split():
        if re.fullmatch(r"\d+", word):
            words.append(int(word))
        elif re.fullmatch(r"[-+.\de]+", word) and any(c.isdigit() for c in word):
            words.append(float(word))
        else:
            words.append(word)
    return words


def agree(first, second):
    if isinstance(first, (int, str)) and isinstance(second, (int, str)):
        return first == second
    difference = abs(float(first) - float(second))
    return difference <= max(TOLERANCE * abs(float(first)), NO_OVERLAP)


def main():
    mpiexec, program = sys.argv[1:3]
    reference = figures(mpiexec, program, RANKS[0])
    if "peak_pressure" not in reference:
        sys.exit(f"{program} printed no figures")
    failures = 0
    for ranks in RANKS[1:]:
        found = figures(mpiexec, program, ranks)
        if len(found) != len(reference):
            sys.exit(f"{ranks} ranks: {len(found)} words instead of {len(reference)}")
        maximum = 0.0
        for index, (expected, value) in enumerate(zip(reference, found)):
            if isinstance(expected, float) and expected != 0.0 and abs(expected) > NO_OVERLAP:
                maximum = max(maximum, abs(float(value) / expected - 1.0))
            if not agree(expected, value):
                failures += 1
                print(f"{ranks} ranks: {value} instead of {expected} (word {index})")
        print(f"{ranks} ranks: maximum relative difference {maximum:.1e}")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
