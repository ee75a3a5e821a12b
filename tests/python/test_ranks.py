"""Runs that several processes share by mpi4py's communicator, and processes without it."""

import os
import sys

import pytest

HEAD = """
import sys
from mpi4py import MPI
import geneva
comm = MPI.COMM_WORLD
case = geneva.read_case(sys.argv[1])
"""


@pytest.fixture
def on_ranks(tmp_path, cases, command):
    """What a script prints on so many ranks, a set of lines."""
    def lines(script, ranks, *arguments, case="johnson-optimum-wheel", head=HEAD):
        file = tmp_path / "script.py"
        file.write_text(head + script)
        return sorted(command("mpirun", "-n", ranks, sys.executable, "-B", file, cases / case, *arguments).splitlines())

    return lines


def test_two_ranks_find_the_figures_of_one(on_ranks, tmp_path):
    script = """
result = geneva.run(case, comm=comm)
print(repr([(figure.name, figure.value, figure.error) for figure in result.figures if figure.error is not None]))
print(repr((result.error, result.contacts[0].peak_pressure, len(result.meshes))))
result.write(sys.argv[2])
cells = comm.allreduce(len(result.fields().cells))
assert cells == result.meshes[-1].cells, (cells, result.meshes[-1].cells)
"""
    alone = on_ranks(script, 1, tmp_path / "one")
    both = on_ranks(script, 2, tmp_path / "two")
    assert len(alone) == 2 and set(both) == set(alone) and len(both) == 4
    assert (tmp_path / "two" / "report.html").exists()


def test_ranks_share_the_instants_of_a_cycle(on_ranks, tmp_path):
    script = """
case = case.with_({"Mechanism/Instants": 3, "Accuracy": "5 %"})
found = geneva.cycle(case, comm=comm)
print(found.instants["peak pressure"].tolist(), found.is_converged)
found.write(sys.argv[2])
"""
    alone = on_ranks(script, 1, tmp_path / "one", case="six-station-cycle")
    both = on_ranks(script, 2, tmp_path / "two", case="six-station-cycle")
    assert set(both) == set(alone) and len(both) == 2
    assert (tmp_path / "two" / "cycle.json").exists()


@pytest.mark.parametrize("computation", [
    "geneva.run(case, comm=comm, progress=stop)",
    "geneva.run(case, comm=comm, on_step=stop)",
    "geneva.cycle(case.with_({'Mechanism/Instants': 3, 'Accuracy': '5 %'}), comm=comm, progress=stop)",
])
def test_what_a_callback_raises_on_one_rank_ends_all(on_ranks, computation):
    script = f"""
def stop(told):
    if comm.rank == 1:
        raise KeyError("enough")
try:
    {computation}
except KeyError as error:
    print(comm.rank, "raised", error)
except geneva.EndedByOtherRank as error:
    print(comm.rank, "ended:", str(error).splitlines()[0])
print(comm.rank, geneva.run(geneva.read_case(sys.argv[1]), comm=comm).is_converged)
"""
    assert on_ranks(script, 2) == ["0 True", "0 ended: KeyError: 'enough'", "1 True", "1 raised 'enough'"]


def test_without_a_communicator_each_rank_is_alone(on_ranks):
    script = """
result = geneva.run(case.with_("Mechanism/Wheel diameter", 4.5 + comm.rank))
print(comm.rank, f"{result.contacts[0].peak_pressure:.6g}", result.document["ranks"] if "ranks" in result.document else 1)
"""
    first, second = on_ranks(script, 2)
    assert first.split()[1] != second.split()[1]


def test_mpi4py_may_be_imported_after_the_first_run(on_ranks):
    head = "import sys\nimport geneva\ncase = geneva.read_case(sys.argv[1])\n"
    script = """
geneva.run(case)
from mpi4py import MPI
print(geneva.run(case, comm=MPI.COMM_WORLD).is_converged)
"""
    assert on_ranks(script, 2, head=head) == ["True", "True"]


def test_a_process_without_mpi4py_runs_alone_and_ends_quietly(command, cases, tmp_path):
    script = ("import sys; sys.modules['mpi4py'] = None\nimport geneva\n"
              "kept = geneva.run(geneva.read_case(sys.argv[1]))\nprint(kept.is_converged)")
    assert command(sys.executable, "-c", script, cases / "johnson-optimum-wheel", cwd=tmp_path) == "True\n"


def test_what_is_no_communicator_is_refused(cases):
    import geneva
    with pytest.raises(TypeError, match="comm: a communicator of mpi4py is wanted"):
        geneva.run(geneva.read_case(os.path.join(cases, "johnson-optimum-wheel")), comm=2)
