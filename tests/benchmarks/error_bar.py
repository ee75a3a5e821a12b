#!/usr/bin/env python3
"""Whether the reported error of the peak pressure holds, on random cases that nobody has tuned.

    python3 tests/benchmarks/error_bar.py 0 79 --accuracy "0.5 %" --label before
    python3 tests/benchmarks/error_bar.py 0 39 --accuracy "5 %" --kind space --only odd --histogram ratio.svg

Runs the cases FIRST to LAST of tests/benchmarks/random_cases.py at the accuracy asked for, and again at a tenth of it:
that result is the truth. The true error is the peak pressure's relative difference from the truth; the reported error
holds if it is at least that. Prints a row for each case, one for each kind, and a summary.

OUTPUT/cases/NAME/at-ACCURACY is each case directory, to be run by hand. OUTPUT/results.jsonl gains a line for every
run that has ended: a second call leaves those out, and other programs, accuracies and splits add to it. A run is known
by the text of its case and by the label of its program; the truth may be that of another program (--truth-program).
With the kind "all" every index stands for a case in the plane and one in 3-D.
"""

import argparse
import concurrent.futures
import csv
import hashlib
import io
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import random_cases  # puts tests/cli on the path
from geneva_cli import environment, flat, number, read_summary

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Beside the time; they leave room for the truth.
LIMITS = {"plane": [("Maximum unknowns", 3000000), ("Maximum refinement levels", 28)],
          "space": [("Maximum unknowns", 5000000)]}

# Sections of summary.json that are no figures of the contact.
OTHER_SECTIONS = ("case", "checks", "comparison", "contact_pairs", "memory", "mesh", "notices", "safety", "solver",
                  "time", "versions")

# A closed form is a check only where the contact is small beside the bodies; then it has to agree as well as this.
SMALL_CONTACT, CLOSED_FORM_AGREES = 0.01, 0.003

PEAK, PEAK_ERROR = "contact.peak_pressure", "contact.peak_pressure_error"


# Running


class Results:
    """Lines of results.jsonl by their keys. A line is written at once, so that an end at any time leaves whole ones."""

    def __init__(self, file):
        self._file = file
        self._lock = threading.Lock()
        self.records = {}
        content = file.read_bytes() if file.exists() else b""
        for line in content.splitlines():
            try:
                record = json.loads(line)
            except ValueError:  # cut short by a full disc
                continue
            self.records[record["key"]] = record
        self._is_cut = bool(content) and not content.endswith(b"\n")

    def add(self, record):
        line = json.dumps(record, sort_keys=True).encode() + b"\n"
        with self._lock:
            self.records[record["key"]] = record
            with open(self._file, "ab", buffering=0) as stream:
                stream.write(b"\n" * self._is_cut + line)
            self._is_cut = False


class Program:
    """A program with the label that its results go by."""

    def __init__(self, path, label):
        self.path = pathlib.Path(path).resolve()
        if not self.path.is_file():
            sys.exit(f"error_bar: there is no program {self.path}; build it, or name another with --program")
        self.digest = hashlib.sha256(self.path.read_bytes()).hexdigest()[:16]
        self.label = label or self._run_version()

    def _run_version(self):
        run = subprocess.run([self.path, "--version"], env=environment(), capture_output=True, text=True, check=True)
        return run.stdout.strip()


class Run:
    """A case at an accuracy by a program."""

    def __init__(self, case, series, program, accuracy, time_limit):
        self.case, self.program, self.accuracy, self.time_limit = case, program, accuracy, time_limit
        self.files = case.files(accuracy, [*LIMITS[series], ("Maximum time", f"{time_limit:g} s")])
        text = json.dumps(case.files(accuracy), sort_keys=True)  # another time limit does not make another case
        self.key = f"{case.name} {accuracy:g} {program.label} {hashlib.sha256(text.encode()).hexdigest()[:16]}"

    def is_missing(self, record):
        """A run that failed is tried again if it may take longer now."""
        return record is None or record["code"] != 0 and record["time_limit"] < self.time_limit

    def write(self, output):
        directory = output / "cases" / self.case.name / f"at-{100 * self.accuracy:g}-percent"
        directory.mkdir(parents=True, exist_ok=True)
        for name, text in self.files.items():
            (directory / name).write_text(text)
        return directory

    def execute(self, output):
        """Runs the program and returns the record of it."""
        directory = self.write(output)
        with tempfile.TemporaryDirectory(prefix="geneva-error-bar-") as results:
            begin = time.perf_counter()
            code, errors = self._call(directory, results)
            seconds = time.perf_counter() - begin
            summary = read_summary(pathlib.Path(results)) if (pathlib.Path(results) / "summary.json").exists() else {}
        solver, mesh = summary.get("solver", {}), summary.get("mesh", {})
        return {"key": self.key, "case": self.case.name, "kind": self.case.kind, "accuracy": self.accuracy,
                "label": self.program.label, "program": self.program.digest, "code": code, "seconds": seconds,
                "time_limit": self.time_limit,
                "message": solver.get("message") or errors, "unknowns": mesh.get("dofs"), "levels": mesh.get("levels"),
                "figures": figures_of(summary)}

    def _call(self, directory, results):
        """Exit code, negative if a signal ended the program, or "time"; and what stands on stderr."""
        command = [self.program.path, "run", directory, "--output", results]
        with subprocess.Popen(command, env={**environment(), "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              errors="replace") as process:
            try:
                errors = process.communicate(timeout=2 * self.time_limit + 60)[1]
                return process.returncode, errors.strip()[:1000]
            except subprocess.TimeoutExpired:
                process.kill()
                return "time", f"did not end within {2 * self.time_limit + 60:g} s"


def figures_of(summary):
    """Every number of a summary that says something about the contact, by its dotted key."""
    kept = {name: entry for name, entry in summary.items() if name not in OTHER_SECTIONS}
    return {key.removesuffix(".value"): value for key, value in flat(kept).items()
            if isinstance(value, (int, float)) and not isinstance(value, bool)}


# Judging


class Verdict:
    """A case's run beside its truth."""

    def __init__(self, case, run, truth):
        self.case, self.run, self.truth = case, run, truth
        self.peak = run["figures"].get(PEAK)
        self.reported = run["figures"].get(PEAK_ERROR)
        self.finished = run["code"] == 0
        self.has_truth = truth is not None and truth["code"] == 0  # of failed runs none is asked for
        self.judged = self.finished and self.has_truth and bool(self.peak) and bool(self.reported)
        if self.judged:
            self.error = self.peak / truth["figures"][PEAK] - 1
            self.ratio = abs(self.error) / self.reported
            self.holds = self.ratio <= 1
            self.is_certain = abs(abs(self.error) - self.reported) > truth["figures"][PEAK_ERROR]

    def closed_form(self):
        """The truth's relative difference from Hertz, if the contact is small enough to compare; else None."""
        if self.case.hertz is None or not self.has_truth:
            return None
        peak, size = self.case.hertz.pressure(self.truth["figures"]["contact.force"])
        return self.truth["figures"][PEAK] / peak - 1 if size < SMALL_CONTACT else None

    def other_errors(self):
        """(reported, true) errors of the other figures that the program gives one for, by name."""
        if not self.judged:
            return {}
        found = {}
        for key, reported in self.run["figures"].items():
            name = key.removesuffix("_error")
            if name != key and key != PEAK_ERROR and reported and self.truth["figures"].get(name):
                if name in self.run["figures"]:
                    found[name] = (reported, self.run["figures"][name] / self.truth["figures"][name] - 1)
        return found


def percent(value, signed=False):
    return "-" if value is None else f"{100 * value:{'+' if signed else ''}.3f}"


def table(rows):
    """Rows of texts in columns, the first two to the left."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    lines = ("  ".join(entry.ljust(width) if i < 2 else entry.rjust(width)
                       for i, (entry, width) in enumerate(zip(row, widths))) for row in rows)
    return "\n".join(line.rstrip() for line in lines)


def case_table(verdicts):
    rows = [("case", "kind", "code", "levels", "unknowns", "time [s]", "reported [%]", "true [%]", "ratio", "Hertz [%]",
             "")]
    for verdict in verdicts:
        run, closed = verdict.run, verdict.closed_form()
        row = (verdict.case.name, verdict.case.kind, str(run["code"]), str(run["levels"] or "-"),
               str(run["unknowns"] or "-"), f"{run['seconds']:.1f}", percent(verdict.reported))
        if verdict.judged:
            note = "" if verdict.holds else "not held"
            row += (percent(verdict.error, True), f"{verdict.ratio:.2f}", percent(closed, True),
                    note if verdict.is_certain else f"{note} (truth +-{percent(verdict.truth['figures'][PEAK_ERROR])})")
        else:
            row += ("-", "-", percent(closed, True), "no truth" if verdict.finished else "failed")
        rows.append(row)
    return table(rows)


def share(part, whole):
    return f"{part} of {whole}" + (f" ({100 * part / whole:.1f} %)" if whole else "")


def kind_table(verdicts):
    rows = [("kind", "", "cases", "judged", "held", "worst ratio", "median ratio", "failed", "no truth")]
    for kind in sorted({verdict.case.kind for verdict in verdicts}):
        own = [verdict for verdict in verdicts if verdict.case.kind == kind]
        judged = [verdict for verdict in own if verdict.judged]
        ratios = [verdict.ratio for verdict in judged] or [math.nan]
        failed = sum(not verdict.finished for verdict in own)
        rows.append((kind, "", str(len(own)), str(len(judged)), share(sum(v.holds for v in judged), len(judged)),
                     f"{max(ratios):.2f}", f"{statistics.median(ratios):.2f}", str(failed),
                     str(len(own) - failed - len(judged))))
    return table(rows)


def failures(records):
    """Cases by exit code and message, numbers left out of the message."""
    groups = {}
    for record in records:
        if record["code"] != 0:
            message = re.sub(r"\S*/\S*|[-+]?\d[\d.]*(e[-+]?\d+)?", "#", record["message"].split("\n")[0])
            groups.setdefault((str(record["code"]), message), []).append(record["case"])
    return [f"  code {code}, {len(cases)}: {message[:160]}\n    {', '.join(cases)}"
            for (code, message), cases in sorted(groups.items(), key=lambda group: -len(group[1]))]


def summary_lines(verdicts):
    judged = [verdict for verdict in verdicts if verdict.judged]
    lines = [f"cases: {len(verdicts)}, judged {len(judged)}"]
    if judged:
        ratios, errors = [verdict.ratio for verdict in judged], [verdict.error for verdict in judged]
        open_ones = [verdict for verdict in judged if not verdict.is_certain]
        worst = max(judged, key=lambda verdict: verdict.ratio)
        beyond = sum(abs(verdict.error) > verdict.run["accuracy"] for verdict in judged)
        lines += [f"true error at most the reported one: {share(sum(v.holds for v in judged), len(judged))}; "
                  f"{len(open_ones)} could turn within the error of the truth",
                  f"true over reported: worst {max(ratios):.2f} ({worst.case.name}), "
                  f"median {statistics.median(ratios):.2f}",
                  f"true error: mean {percent(statistics.mean(errors), True)} %, mean size "
                  f"{percent(statistics.mean(map(abs, errors)))} %, "
                  f"maximum {percent(max(errors, key=abs), True)} %",
                  f"true error above the accuracy asked for, with exit code 0: {share(beyond, len(judged))}",
                  f"median unknowns {statistics.median(v.run['unknowns'] for v in judged):.0f}, "
                  f"median time {statistics.median(v.run['seconds'] for v in judged):.1f} s"]
    differences = [value for value in (verdict.closed_form() for verdict in verdicts) if value is not None]
    agree = sum(abs(value) <= CLOSED_FORM_AGREES for value in differences)
    lines += [f"truth within {100 * CLOSED_FORM_AGREES:g} % of Hertz where the contact is small: "
              f"{share(agree, len(differences))}"]
    for heading, records in (("ended with another exit code than 0", [v.run for v in verdicts]),
                             ("truths that did not finish", [v.truth for v in verdicts if v.finished])):
        groups = failures(records)
        lines += [f"{heading}: {sum(record['code'] != 0 for record in records)}", *groups]
    return "\n".join(lines)


def other_table(verdicts):
    """The errors that the program reports of other figures than the peak pressure."""
    by_name = {}
    for verdict in verdicts:
        for name, pair in verdict.other_errors().items():
            by_name.setdefault(name, []).append(pair)
    rows = [("figure", "", "cases", "held", "worst ratio", "median ratio", "mean size [%]")]
    for name, pairs in sorted(by_name.items()):
        ratios = [abs(true) / reported for reported, true in pairs]
        rows.append((name, "", str(len(pairs)), share(sum(ratio <= 1 for ratio in ratios), len(pairs)),
                     f"{max(ratios):.2f}", f"{statistics.median(ratios):.2f}",
                     percent(statistics.mean(abs(true) for _, true in pairs))))
    return table(rows) if by_name else "the program reports no error of another figure"


# Histogram

BIN, BINS = 0.1, 20  # of true over reported; the last bin holds what is beyond


def histogram_counts(ratios):
    counts = [0] * (BINS + 1)
    for ratio in ratios:
        counts[min(BINS, int(ratio / BIN))] += 1
    return counts


def histogram_csv(counts):
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(("true over reported from", "to", "cases"))
    for i, count in enumerate(counts):
        writer.writerow((f"{i * BIN:.1f}", f"{(i + 1) * BIN:.1f}" if i < BINS else "", count))
    return stream.getvalue()


def histogram_svg(counts, caption):
    """Bars over true / reported, those beyond 1 in red."""
    step, height, left, top = 24, 200, 46, 30
    width, bottom, most = left + step * (BINS + 1) + 14, top + height, max(*counts, 1)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{bottom + 50}" '
             f'font-family="sans-serif" font-size="11" text-anchor="middle">',
             '<rect width="100%" height="100%" fill="white"/>',
             f'<text x="{width / 2:g}" y="18" font-size="13">{caption}</text>']
    for i, count in enumerate(counts):
        x, high = left + i * step, height * count / most
        colour = "#3566a8" if i * BIN < 1 - BIN / 2 else "#c03a2b"
        parts.append(f'<rect x="{x + 1}" y="{bottom - high:.1f}" width="{step - 2}" height="{high:.1f}" '
                     f'fill="{colour}"/>')
        if count:
            parts.append(f'<text x="{x + step / 2:g}" y="{bottom - high - 3:.1f}">{count}</text>')
        if i % 5 == 0:
            label = f"{i * BIN:g}" + (" and more" if i == BINS else "")
            parts.append(f'<text x="{x}" y="{bottom + 15}">{label}</text>')
    parts += [f'<line x1="{left}" y1="{bottom}" x2="{width - 14}" y2="{bottom}" stroke="black"/>',
              f'<text x="{width / 2:g}" y="{bottom + 36}">true error over reported error</text>',
              f'<text x="14" y="{top + height / 2:g}" transform="rotate(-90 14 {top + height / 2:g})">cases</text>',
              "</svg>"]
    return "\n".join(parts) + "\n"


def write_histogram(file, verdicts):
    ratios = [verdict.ratio for verdict in verdicts if verdict.judged]
    counts = histogram_counts(ratios)
    held = share(sum(ratio <= 1 for ratio in ratios), len(ratios))
    text = histogram_csv(counts) if file.suffix == ".csv" else histogram_svg(counts, f"held in {held} cases")
    temporary = file.with_name(file.name + ".part")
    temporary.write_text(text)
    temporary.replace(file)


# Command line


def read_accuracy(text):
    """An accuracy as in a case file: "0.5 %" or 0.005."""
    try:
        value = float(text.removesuffix("%")) / (100 if text.endswith("%") else 1)
    except ValueError:
        value = math.nan
    if not 0 < value <= 0.2:
        raise argparse.ArgumentTypeError(f"'{text}' is no accuracy: give a number or a percentage, greater than 0 and "
                                         "at most 20 %")
    return value


def read_histogram(text):
    if pathlib.Path(text).suffix not in (".svg", ".csv"):
        raise argparse.ArgumentTypeError(f"'{text}' must end in .svg or .csv")
    return pathlib.Path(text)


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("first", type=int)
    parser.add_argument("last", type=int)
    parser.add_argument("--accuracy", type=read_accuracy, required=True, help="of the runs, as in a case file")
    parser.add_argument("--kind", choices=("plane", "space", "all"), default="plane")
    parser.add_argument("--space-accuracy", type=read_accuracy, help="of the runs in 3-D (default: the same)")
    parser.add_argument("--only", choices=("odd", "even"), help="cases with such an index: one half to tune on, the "
                        "other to check")
    parser.add_argument("--program", default=ROOT / "build/release/app/geneva")
    parser.add_argument("--label", help="of the program in the results (default: its version)")
    parser.add_argument("--truth-program", help="that gives the truth (default: the same)")
    parser.add_argument("--truth-label", help="of that (default: its version)")
    parser.add_argument("--truth-accuracy", type=read_accuracy, help="(default: a tenth of the accuracy)")
    parser.add_argument("--time-limit", type=float, default=60.0, help="of a run, s")
    parser.add_argument("--truth-time-limit", type=float, default=120.0, help="of a truth, s")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("error-bar"))
    parser.add_argument("--write-only", action="store_true", help="write the case directories and run nothing")
    parser.add_argument("--other-errors", action="store_true", help="also judge the errors of other figures")
    parser.add_argument("--histogram", type=read_histogram, help="FILE.svg or FILE.csv of true over reported")
    return parser.parse_args()


def planned_runs(arguments, program, truth_program):
    """(case, run, truth) of every case that is asked for."""
    plans = []
    for series in ("plane", "space") if arguments.kind == "all" else (arguments.kind,):
        accuracy = (series == "space" and arguments.space_accuracy) or arguments.accuracy
        truth_accuracy = arguments.truth_accuracy or accuracy / 10
        for index in range(arguments.first, arguments.last + 1):
            if arguments.only is None or (index % 2 == 1) == (arguments.only == "odd"):
                case = random_cases.draw_case(series, index)
                plans.append((case, Run(case, series, program, accuracy, arguments.time_limit),
                              Run(case, series, truth_program, truth_accuracy, arguments.truth_time_limit)))
    return plans


def execute(runs, results, arguments):
    """Runs what has no result yet, and says how far it is on stderr."""
    for run in runs:
        known = results.records.get(run.key)
        if known and known["program"] != run.program.digest:
            sys.exit(f"error_bar: the results labelled '{run.program.label}' in {arguments.output} are those of "
                     f"another program than {run.program.path}; give this one another --label")
    missing = list({run.key: run for run in runs if run.is_missing(results.records.get(run.key))}.values())
    with concurrent.futures.ThreadPoolExecutor(max(1, arguments.jobs)) as pool:
        pending = [pool.submit(run.execute, arguments.output) for run in missing]
        try:
            for count, future in enumerate(concurrent.futures.as_completed(pending), 1):
                record = future.result()
                results.add(record)
                print(f"{count}/{len(missing)} {record['case']} at {100 * record['accuracy']:g} %: code "
                      f"{record['code']}, {record['seconds']:.1f} s", file=sys.stderr, flush=True)
        except BaseException:  # KeyboardInterrupt too: begin nothing more
            pool.shutdown(cancel_futures=True)
            raise


def main():
    arguments = read_arguments()
    program = Program(arguments.program, arguments.label)
    truth_program = program if arguments.truth_program is None else Program(arguments.truth_program,
                                                                            arguments.truth_label)
    plans = planned_runs(arguments, program, truth_program)
    if not plans:
        sys.exit("error_bar: no case has such an index; FIRST must be at most LAST")
    arguments.output.mkdir(parents=True, exist_ok=True)
    if arguments.write_only:
        for _, *both in plans:
            for run in both:
                run.write(arguments.output)
        return
    results = Results(arguments.output / "results.jsonl")
    execute([run for _, run, _ in plans], results, arguments)
    execute([truth for _, run, truth in plans if results.records[run.key]["code"] == 0], results, arguments)
    verdicts = [Verdict(case, results.records[run.key], results.records.get(truth.key)) for case, run, truth in plans]
    print(case_table(verdicts), kind_table(verdicts), summary_lines(verdicts), sep="\n\n")
    if arguments.other_errors:
        print("", other_table(verdicts), sep="\n")
    if arguments.histogram:
        write_histogram(arguments.histogram, verdicts)


if __name__ == "__main__":
    main()
