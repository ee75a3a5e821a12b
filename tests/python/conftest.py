"""What the tests of the Python package share."""

import os
import pathlib
import subprocess

import pytest

SOURCE = pathlib.Path(os.environ["GENEVA_SOURCE"])
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}


def run(*command, code=0, **options):
    """What a command prints that ends with that exit code."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, env=ENVIRONMENT,
                          timeout=300, check=False, **options)
    assert done.returncode == code, f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@pytest.fixture
def cases():
    """The directory of the project's cases."""
    return SOURCE / "cases"


@pytest.fixture
def command():
    """Runs a command, see run()."""
    return run


@pytest.fixture
def geneva_command():
    """What the command line says against something: the text behind 'geneva: '."""
    def refusal(*arguments):
        done = subprocess.run([os.environ["GENEVA_PROGRAM"], *map(str, arguments)], capture_output=True, text=True,
                              env=ENVIRONMENT, timeout=300, check=False)
        assert done.returncode == 1, done.stdout + done.stderr
        return done.stderr.strip().removeprefix("geneva: ")

    return refusal
