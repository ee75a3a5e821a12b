"""What the command-line tests share: running the program, changing case files, reading summaries.

Every script of this directory is called with the path of the program and the project's root directory, and takes
unittest's own arguments after them:

    python3 tests/cli/bad_input.py build/release/app/geneva . -v
"""

import base64
import csv
import dataclasses
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

# Longer than any run of these tests takes; a run that hangs is ended and fails.
TIME_LIMIT = 120.0

# Signs of a program that fell over instead of explaining itself.
CRASH_SIGNS = ("terminate called", "Stack trace", "Stacktrace", "Aborted", "what():", "Segmentation fault",
               "internal error", "dealii::", "std::", "MPI_ABORT", "An error occurred in line")

# Everything that a run in the plane writes, beside one solution.N.vtu for each MPI rank.
RESULT_FILES = ("solution.pvd", "solution.pvtu", "contact.vtu", "contact.csv", "results.h5", "results.xdmf",
                "depth.csv", "summary.json", "case.prm", "log.txt", "view.json",
                "stress.svg", "report.html")

# Fields of summary.json that differ from run to run.
UNREPEATABLE = ("date", "time", "memory", "elapsed", "finest_assembly_and_solve")


@dataclasses.dataclass
class Run:
    """How a run ended and what it said."""
    code: int
    out: str
    err: str

    def describe(self):
        return f"exit code {self.code}\nstdout:\n{self.out}\nstderr:\n{self.err}"


class CliTest(unittest.TestCase):
    """A test with a temporary directory of its own that runs the program."""

    program = pathlib.Path()
    source = pathlib.Path()

    def setUp(self):
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix="geneva-test-"))
        self.addCleanup(shutil.rmtree, self.directory, ignore_errors=True)

    def geneva(self, *arguments, ranks=None, time_limit=TIME_LIMIT):
        command = [str(self.program), *map(str, arguments)]
        if ranks is not None:
            command = ["mpirun", "--oversubscribe", "-n", str(ranks), *command]
        with subprocess.Popen(command, cwd=self.directory, env=environment(), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, errors="replace") as process:
            try:
                out, err = process.communicate(timeout=time_limit)
            except subprocess.TimeoutExpired:
                process.terminate()  # mpirun then ends its ranks
                out, err = process.communicate()
                self.fail(f"{' '.join(command)} did not end within {time_limit:g} s\n{out}\n{err}")
        return Run(process.returncode, out, err)

    def copy_case(self, name, to=None):
        """Copies a shipped case without the results that a run left in it."""
        target = self.directory / (to or name)
        shutil.copytree(self.source / "cases" / name, target, ignore=shutil.ignore_patterns("results", ".results*"))
        return target

    def run_case(self, case, ranks=None, code=0):
        """Runs a case and reads its summary."""
        run = self.geneva("run", case, ranks=ranks)
        self.assertEqual(run.code, code, run.describe())
        return read_summary(case / "results")

    def assert_close(self, value, expected, tolerance, what):
        """Compares numbers by their relative difference."""
        difference = abs(value - expected) / abs(expected) if expected else abs(value)
        self.assertLessEqual(difference, tolerance, f"{what}: {value!r} instead of {expected!r}")


def vtk_array(file, name):
    """An array of single precision of a VTK file."""
    text = file.read_text()
    start = text.index(">", text.index(f'Name="{name}"')) + 1
    data = base64.b64decode(text[start:text.index("</DataArray>", start)].strip())
    (size,) = struct.unpack("<I", data[:4])
    return struct.unpack(f"<{size // 4}f", data[4:])


def environment():
    """The environment of a run: MPI also as root and on fewer cores than ranks, colours as on any terminal."""
    allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1", "LC_ALL": "C.UTF-8"}
    return {**{name: value for name, value in os.environ.items() if name != "NO_COLOR"}, **allowed}


def main(prepare=lambda source: None):
    """Takes the program and the root directory from the command line and runs the script's tests.

    `prepare` is called with the root directory before the tests are collected.
    """
    if len(sys.argv) < 3:
        sys.exit(f"usage: {sys.argv[0]} PROGRAM SOURCE_DIRECTORY [unittest's arguments]")
    CliTest.program = pathlib.Path(sys.argv[1]).resolve()
    CliTest.source = pathlib.Path(sys.argv[2]).resolve()
    prepare(CliTest.source)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])


# Case files


def set_parameter(text, path, value):
    """A case file's text with one parameter changed, added, or (value None) taken out.

    The path is that of the subsections with slashes between them: "Mechanism/Wheel material/Density".
    """
    *sections, name = path.split("/")
    lines = text.splitlines()
    place, is_there = find_parameter(lines, sections, name)
    if value is None and not is_there:
        raise KeyError(f"{path} is not in the case file")
    lines[place:place + is_there] = [] if value is None else [f"set {name} = {value}"]
    return "\n".join(lines) + "\n"


def find_parameter(lines, sections, name):
    """Index of the line that sets a parameter and True, or of the line where it belongs and False."""
    place = None if sections else 0
    open_sections = []
    for index, line in enumerate(lines):
        words = line.split("#")[0].split()
        if words[:1] == ["subsection"]:
            open_sections.append(" ".join(words[1:]))
            if open_sections == sections:
                place = index + 1
        elif words == ["end"]:
            open_sections.pop()
        elif words[:1] == ["set"] and open_sections == sections:
            if " ".join(words[1:]).split("=")[0].strip() == name:
                return index, True
    if place is None:
        raise KeyError(f"the case file has no subsection {'/'.join(sections)}")
    return place, False


def change_case(case, changes, file="case.prm"):
    """Changes parameters of a case directory's file; see set_parameter."""
    path = case / file
    text = path.read_text()
    for parameter, value in changes.items():
        text = set_parameter(text, parameter, value)
    path.write_text(text)


def replace_in(file, old, new):
    """Replaces a text that has to be there."""
    text = file.read_text()
    if old not in text:
        raise KeyError(f"{file.name} does not hold {old!r}")
    file.write_text(text.replace(old, new))


# Results


def read_summary(results):
    return json.loads((results / "summary.json").read_text())


def look_up(summary, key):
    """The entry of a summary that a dotted key names."""
    entry = summary
    for part in key.split("."):
        entry = entry[int(part)] if isinstance(entry, list) else entry[part]
    return entry


def number(entry):
    """A quantity's value, or the plain number itself."""
    return entry["value"] if isinstance(entry, dict) else entry


def flat(entry, path=""):
    """Every number and text of a summary by its dotted key, without what differs from run to run."""
    if isinstance(entry, dict):
        parts = entry.items()
    elif isinstance(entry, list):
        parts = enumerate(entry)
    else:
        return {path: entry}
    result = {}
    for name, part in parts:
        if name not in UNREPEATABLE:
            result.update(flat(part, f"{path}.{name}" if path else str(name)))
    return result


def read_csv(file):
    """Columns of a CSV file by their headings; numbers where all entries are numbers."""
    with open(file, newline="") as stream:
        rows = list(csv.reader(stream))
    columns = {}
    for index, heading in enumerate(rows[0]):
        entries = [row[index] for row in rows[1:]]
        try:
            columns[heading] = [float(entry) for entry in entries]
        except ValueError:
            columns[heading] = entries
    return columns


def unit_of(heading):
    """The unit in a heading such as "gap [mm]", or None."""
    found = re.fullmatch(r".*\[(.+)\]", heading)
    return found.group(1) if found else None


def files_of(directory):
    """Content of every file below a directory, by name."""
    return {str(path.relative_to(directory)): path.read_bytes()
            for path in sorted(directory.rglob("*")) if path.is_file()}
def timeless_files_of(directory):
    """The same without the dates at which the files were made."""
    date = re.compile(rb"\d{4}-\d\d-\d\d(T| )\d\d:\d\d(:\d\d[+-]\d{4})?")
    return {name: date.sub(b"", content) for name, content in files_of(directory).items()}


