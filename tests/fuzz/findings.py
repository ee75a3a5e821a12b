"""What the program must not do, whatever it is given."""

import json
import pathlib
import sys
import tempfile
import unicodedata

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
from geneva_cli import CRASH_SIGNS  # noqa: E402

# May itself lie in the directory of temporary files.
PROJECT = str(pathlib.Path(__file__).resolve().parents[2])

ENDINGS = {0: "done", 1: "wrong input", 2: "limit"}
LONGEST_MESSAGE = 4  # lines

# Names of C++ and its libraries, which are no words to a user.
PROGRAMMERS_WORDS = (*CRASH_SIGNS, "bad_alloc", "bad_array", "bad_function", "basic_string", "vector::", "map::at", "_M_",
                     "nlohmann", "[json.exception", "AddressSanitizer", "runtime error:", "__")

# What a run may leave beside the case: directories that were made for it, and OpenMPI's own.
BESIDE = {"case", "tmp", "home"}


def ending(run):
    """How it ended, in words."""
    if run.code is None:
        return "too long"
    return f"signal {-run.code}" if run.code < 0 else ENDINGS.get(run.code, f"exit code {run.code}")


def of_run(run):
    """What is wrong with how the program ended and what it said."""
    wrong = []
    message = [line for line in run.err.splitlines() if line.strip()]
    if run.code not in ENDINGS:
        wrong.append(f"it ended with: {ending(run)}")
    if run.code == 1 and not run.err.startswith("geneva: ") or run.code == 2 and not (message or run.out.strip()):
        wrong.append("it does not say why")
    wrong += [f"its message holds {word!r}" for word in PROGRAMMERS_WORDS if word in run.err]
    if tempfile.gettempdir() in run.err.replace(PROJECT, ""):
        wrong.append("its message holds a temporary path")
    if len(message) > LONGEST_MESSAGE:
        wrong.append(f"its message has {len(message)} lines")
    if any(unicodedata.category(character) == "Cc" and character not in "\n\t" for character in run.err):
        wrong.append("its message holds characters that a terminal obeys")
    return wrong + [f"it said: {line[:300]}" for line in message[:LONGEST_MESSAGE]] if wrong else []


def not_finite(name):
    raise ValueError(f"{name} in it")


def of_summary(file):
    """What is wrong with a file of results."""
    try:
        json.loads(file.read_text(), parse_constant=not_finite)
    except ValueError as error:
        return [f"{file.name}: {error}"]
    return []


def of_results(results, run):
    """What is wrong with the results directory: whole with exit codes 0 and 2, not there otherwise."""
    if not results.exists():
        return ["there are no results"] if run.code == 0 else []
    if run.code == 1:
        return ["there are results, though the case was refused"]
    return [line for file in sorted(results.glob("*.json")) for line in of_summary(file)]


def of_files(directory, given, run):
    """What is wrong with the files after a run.

    given: the case's files with their content
    """
    case = directory / "case"
    wrong = [f"{file.name} is beside the case" for file in directory.iterdir() if file.name not in BESIDE]
    wrong += [f"{file.relative_to(directory)} is left" for name in ("tmp", "home") for file in (directory / name).iterdir()
              if not file.name.startswith("ompi.")]
    there = {file.name for file in case.iterdir()}
    wrong += [f"{name} is left in the case" for name in sorted(there - set(given) - {"results"})]
    wrong += [f"{name} was changed" for name, content in given.items()
              if name not in there or (case / name).read_bytes() != content]
    return wrong + of_results(case / "results", run)
