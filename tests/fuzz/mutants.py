#!/usr/bin/env python3
"""Runs the program with cases that were changed at random, and keeps those that it does not take well.

    python3 tests/fuzz/mutants.py PROGRAM FIRST LAST [--jobs N] [--output DIRECTORY]

Mutant number n is always the same case, whatever range is run. Each runs in a directory of its own, with limits that
let it end within seconds. Prints every finding (findings.py says what is one), then how many of each kind ended how;
the exit status is 1 if something was found. With --output the directories of the findings are copied there.
"""

import argparse
import collections
import concurrent.futures
import dataclasses
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import findings
import mutations
import seeds

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
import geneva_cli  # noqa: E402

# Far beyond what the limits of a mutant allow, on a machine that does other things too [s].
TIME_LIMIT = 40.0

# So that a mutant that is a case after all ends soon; sometimes one of them is changed as well.
LIMITS = {"Accuracy": "20 %", "Maximum refinement levels": "2", "Maximum unknowns": "3000", "Maximum time": "2 s",
          "Maximum memory": "1 GB", "Maximum active-set steps": "20"}
CHANGED_LIMITS = {"Accuracy": ("1e-9 %", "0.1 %", "100 %", "0"), "Maximum unknowns": ("1", "100", "20000"),
                  "Maximum time": ("1e-9 s", "0 s", "0.2 s", "1 h"), "Maximum memory": ("1 B", "1 MB", "50 MB", "1e30 GB"),
                  "Maximum active-set steps": ("1", "2", "10000"), "Maximum refinement levels": ("1", "3", "nan")}


@dataclasses.dataclass
class Mutant:
    """A case directory's files by name, and the command that it is given to."""
    number: int
    kind: str
    seed: str
    command: str
    files: dict


@dataclasses.dataclass
class Outcome:
    """How the run of a mutant ended and what is wrong with that."""
    mutant: Mutant
    ending: str
    seconds: float
    wrong: list


def with_limits(rng, case):
    """The limits before everything else, where no change of the file's text comes."""
    limits = dict(LIMITS)
    if rng.random() < 0.15:
        name = rng.choice(sorted(CHANGED_LIMITS))
        limits[name] = rng.choice(CHANGED_LIMITS[name])
    return "".join(f"set {name} = {value}\n" for name, value in limits.items()).encode() + case


def draw_mutant(number):
    """Mutant number n."""
    rng = random.Random(number)
    kind = list(seeds.KINDS)[number % len(seeds.KINDS)]
    changes, drawers = seeds.KINDS[kind]
    seed = rng.choice(drawers)()
    files = {**seed.files, seed.changed: mutations.mutate(rng, seed.files[seed.changed], changes)}
    if seed.has_limits:
        files["case.prm"] = with_limits(rng, files["case.prm"])
    return Mutant(number, kind, seed.name, rng.choice(seed.commands), files)


def environment(directory):
    """That of every run, with places for files that should not appear."""
    for name in ("tmp", "home"):
        (directory / name).mkdir()
    return {**geneva_cli.environment(), "TMPDIR": str(directory / "tmp"), "HOME": str(directory / "home"),
            "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def run(program, command, directory):
    """Runs the program on the case in the directory.

    Returns the run with its exit code, None if it had to be ended.
    """
    with subprocess.Popen([program, *command.split(), "case"], cwd=directory, env=environment(directory),
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          errors="replace", start_new_session=True) as process:
        try:
            out, err = process.communicate(timeout=TIME_LIMIT)
            code = process.returncode
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            out, err = process.communicate()
            code = None
    return geneva_cli.Run(code, out, err)


def keep(directory, outcome, output):
    target = output / str(outcome.mutant.number)
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(directory, target, symlinks=True)
    (target / "finding.txt").write_text(describe(outcome) + "\n")


def describe(outcome):
    mutant = outcome.mutant
    return "\n  ".join([f"mutant {mutant.number} ({mutant.kind} of {mutant.seed}, geneva {mutant.command}): "
                        f"{outcome.ending} after {outcome.seconds:.1f} s", *outcome.wrong])


def try_mutant(program, number, room, output):
    mutant = draw_mutant(number)
    directory = room / str(number)
    case = directory / "case"
    case.mkdir(parents=True)
    for name, content in mutant.files.items():
        (case / name).write_bytes(content)
    start = time.monotonic()
    ended = run(program, mutant.command, directory)
    outcome = Outcome(mutant, findings.ending(ended), time.monotonic() - start,
                      findings.of_run(ended) + findings.of_files(directory, mutant.files, ended))
    if outcome.wrong and output:
        keep(directory, outcome, output)
    shutil.rmtree(directory)
    return outcome


def print_summary(outcomes, seconds):
    counts = collections.Counter((outcome.mutant.kind, outcome.ending) for outcome in outcomes)
    found = collections.Counter(outcome.mutant.kind for outcome in outcomes if outcome.wrong)
    for kind in seeds.KINDS:
        endings = ", ".join(f"{ending}: {count}" for (of, ending), count in sorted(counts.items()) if of == kind)
        print(f"{kind}: {found[kind]} findings ({endings})")
    print(f"mutants: {len(outcomes)} run in {seconds:.0f} s, {sum(found.values())} findings")


def main():
    parser = argparse.ArgumentParser(description="Runs the program with cases that were changed at random.")
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--output", type=pathlib.Path)
    given = parser.parse_args()
    if given.output:
        given.output.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    outcomes = []
    with tempfile.TemporaryDirectory(prefix="geneva-mutants-") as room:
        with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
            for outcome in pool.map(lambda number: try_mutant(given.program.resolve(), number, pathlib.Path(room),
                                                              given.output), range(given.first, given.last + 1)):
                outcomes.append(outcome)
                if outcome.wrong:
                    print(describe(outcome), flush=True)
    print_summary(outcomes, time.monotonic() - start)
    return 1 if any(outcome.wrong for outcome in outcomes) else 0


if __name__ == "__main__":
    sys.exit(main())
