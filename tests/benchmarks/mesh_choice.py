#!/usr/bin/env python3
"""What a user's choices that ought not to matter cost: which surface is the source, and the coarse mesh.

    python3 tests/benchmarks/mesh_choice.py 0 59 --only even --accuracy "0.5 %"

Runs the line contacts among the plane cases FIRST to LAST of tests/benchmarks/random_cases.py with either surface
written first, each on the coarse mesh as drawn and on two others drawn from the same ranges. Prints for each case by
what factor unknowns, pressure noise and time differ, and a summary. The noise is the root mean square of the nodal
pressures' differences from the half-ellipse that fits them best, within seven tenths of the half-width, over the
greatest. Of meshes that match by chance it is a hundredth of the accuracy, so that noise below a tenth of the accuracy
counts as that tenth. Compared are the runs that reached the accuracy.
"""

import argparse
import concurrent.futures
import csv
import io
import itertools
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

import random_cases  # puts tests/cli on the path
from geneva_cli import environment, number, read_summary

ROOT = pathlib.Path(__file__).resolve().parents[2]
MESHES = ("mesh as drawn", "second mesh", "third mesh")
SOURCES = ("source as drawn", "other source")


def with_coarse_mesh(geometry, name, is_on_block):
    """A line contact's geometry with other cells: along the roller and its layers, along the base and its layers."""
    draw = random_cases.Draw(f"geneva coarse mesh {name}")
    ranges = ((3, 12), (1, 5), *(((6, 24), (1, 10)) if is_on_block else ((3, 12), (1, 5))))
    counts = iter([draw.whole(*limits) for limits in ranges])
    return re.sub(r"= \d+ \+ 1;", lambda _: f"= {next(counts)} + 1;", geometry)


def with_other_source(parameters):
    return re.sub(r"(Contact pairs = )(.*) -> (.*)", r"\1\3 -> \2", parameters)


def variations(case, accuracy):
    """Files of the case directory by the name of the variation."""
    files = case.files(accuracy, [("Maximum unknowns", 3000000), ("Maximum refinement levels", 28)])
    for source, mesh in itertools.product(SOURCES, MESHES):
        parameters, geometry = files["case.prm"], files["geometry.geo"]
        if source != SOURCES[0]:
            parameters = with_other_source(parameters)
        if mesh != MESHES[0]:
            geometry = with_coarse_mesh(geometry, f"{case.name} {mesh}", "base top" in geometry)
        yield f"{source}, {mesh}", {"case.prm": parameters, "geometry.geo": geometry}


def fit_half_ellipse(places, pressures):
    """Coefficients of 1, x, x^2 of the squared pressures, by least squares."""
    rows = [(1.0, x, x * x) for x in places]
    matrix = [[sum(row[i] * row[j] for row in rows) for j in range(3)] for i in range(3)]
    right = [sum(row[i] * p * p for row, p in zip(rows, pressures)) for i in range(3)]
    for i in range(3):
        for j in range(i + 1, 3):
            share = matrix[j][i] / matrix[i][i]
            matrix[j] = [a - share * b for a, b in zip(matrix[j], matrix[i])]
            right[j] -= share * right[i]
    found = [0.0] * 3
    for i in (2, 1, 0):
        found[i] = (right[i] - sum(matrix[i][j] * found[j] for j in range(i + 1, 3))) / matrix[i][i]
    return found


def pressure_noise(contact):
    """Relative noise from the text of contact.csv; None if there are too few nodes."""
    table = list(csv.DictReader(io.StringIO(contact)))
    place, pressure = (next(name for name in table[0] if name.startswith(word)) for word in ("arc_length",
                                                                                               "contact_pressure"))
    loaded = [(float(row[place]), float(row[pressure])) for row in table if float(row[pressure]) > 0]
    if len(loaded) < 8:
        return None
    begin, end = min(x for x, _ in loaded), max(x for x, _ in loaded)
    middle, half = (begin + end) / 2, (end - begin) / 2
    inner = [((x - middle) / half, p) for x, p in loaded if abs(x - middle) < 0.7 * half]
    places, pressures = zip(*inner)
    a, b, c = fit_half_ellipse(places, pressures)
    differences = [p - math.sqrt(max(a + b * x + c * x * x, 0.0)) for x, p in inner]
    return math.sqrt(sum(d * d for d in differences) / (len(inner) - 3)) / max(pressures)


def run(program, files):
    """Figures of a run, or None if it did not end by itself."""
    with tempfile.TemporaryDirectory(prefix="geneva-mesh-choice-") as directory:
        case, results = pathlib.Path(directory, "case"), pathlib.Path(directory, "results")
        case.mkdir()
        for name, text in files.items():
            (case / name).write_text(text)
        begin = time.perf_counter()
        ended = subprocess.run([program, "run", case, "--output", results], env=environment(), capture_output=True,
                               check=False)
        if ended.returncode != 0:
            return None
        summary = read_summary(results)
        contact = summary["contact"]
        return {"unknowns": summary["mesh"]["dofs"], "seconds": time.perf_counter() - begin,
                "noise": pressure_noise((results / "contact.csv").read_text()),
                "peak": number(contact["peak_pressure"]), "error": number(contact["peak_pressure_error"])}


def ratio(runs, quantity, least=0.0):
    values = [max(figures[quantity], least) for figures in runs if figures[quantity]]
    return max(values) / min(values) if len(values) > 1 else 1.0


def row_of(name, runs, accuracy):
    """What is printed of a case, and its three factors."""
    ended = [figures for figures in runs.values() if figures]
    factors = [ratio(ended, "unknowns"), ratio(ended, "noise", accuracy / 10), ratio(ended, "seconds")]
    peaks = [figures["peak"] for figures in ended]
    noise = [figures["noise"] for figures in ended if figures["noise"]]
    spread = max(peaks) / min(peaks) - 1
    allowed = sum(sorted(figures["error"] for figures in ended)[-2:])
    return (f"{name:10} {len(ended)} of {len(runs)}  unknowns {min(f['unknowns'] for f in ended):7} x {factors[0]:4.2f}"
            f"  noise at most {100 * max(noise):5.3f} % x {factors[1]:4.2f}  time x {factors[2]:4.2f}"
            f"  peaks {100 * spread:5.3f} % apart, errors {100 * allowed:5.3f} %", factors)


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--accuracy", default="0.5 %")
    parser.add_argument("--only", choices=("odd", "even"))
    parser.add_argument("--program", default=ROOT / "build/release/app/geneva")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--each", action="store_true", help="a line for each run, too")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    accuracy = float(arguments.accuracy.rstrip("% ")) / 100
    indices = [i for i in range(arguments.first, arguments.last + 1)
               if arguments.only is None or i % 2 == (arguments.only == "odd")]
    cases = [case for case in (random_cases.draw_case("plane", i) for i in indices) if case.kind == "line"]
    all_factors = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for case in cases:
            names, files = zip(*variations(case, accuracy))
            runs = dict(zip(names, pool.map(lambda each: run(arguments.program, each), files)))
            if arguments.each:
                for name, figures in runs.items():
                    print("  ", name, figures)
            if sum(figures is not None for figures in runs.values()) < 2:
                print(f"{case.name}: fewer than two runs ended by themselves")
                continue
            text, factors = row_of(case.name, runs, accuracy)
            print(text, flush=True)
            all_factors.append(factors)
    if not all_factors:
        sys.exit("mesh_choice: no case ended by itself")
    for name, factors in zip(("unknowns", "noise", "time"), zip(*all_factors)):
        print(f"{name}: factor {statistics.median(factors):.2f} in the middle, {max(factors):.2f} at most, "
              f"{sum(factor <= 2.0 for factor in factors)} of {len(factors)} within 2")


if __name__ == "__main__":
    main()
