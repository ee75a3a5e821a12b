"""Runs that several processes share by mpi4py's communicator, and processes without it."""

import os
import sys

import pytest

# Each rank prints to a file of its own: lines of several on one terminal run into each other.
PRINTING = """
import os
import sys
sys.stdout = open(sys.argv[2] + os.environ["OMPI_COMM_WORLD_RANK"], "w")
"""
HEAD = PRINTING + """
from mpi4py import MPI
import geneva
comm = MPI.COMM_WORLD
case = geneva.read_case(sys.argv[1])
"""


@pytest.fixture
def on_ranks(tmp_path, cases, command):
    """What a script prints on so many ranks: a text for each of them."""
    def texts(script, ranks, *arguments, head=HEAD):
        file = tmp_path / "script.py"
        file.write_text(head + script)
        command("mpirun", "-n", ranks, sys.executable, "-B", file, cases / "johnson-optimum-wheel", tmp_path / "rank.",
                *arguments)
        return [(tmp_path / f"rank.{rank}").read_text() for rank in range(ranks)]

    return texts


def test_two_ranks_find_the_figures_of_one(on_ranks, tmp_path):
    script = """
result = geneva.run(case, comm=comm)
print(len(result.meshes), result.error, *(figure.value for figure in result.figures if figure.value is not None))
result.write(sys.argv[3])
assert comm.allreduce(len(result.fields().cells)) == result.meshes[-1].cells
"""
    (alone, ), both = on_ranks(script, 1, tmp_path / "one"), on_ranks(script, 2, tmp_path / "two")
    assert both[0] == both[1]
    one, two = ([float(word) for word in text.split()] for text in (alone, both[0]))
    assert two == pytest.approx(one, rel=1e-8) and len(one) > 5
    assert (tmp_path / "two" / "report.html").exists()


def test_ranks_share_the_instants_of_a_cycle(on_ranks, tmp_path):
    script = """
case = case.with_({"Mechanism/Instants": 4, "Accuracy": "10 %"})
found = geneva.cycle(case, comm=comm)
print(found.instants["peak pressure"].tolist(), found.is_converged)
found.write(sys.argv[3])
"""
    (alone, ), both = on_ranks(script, 1, tmp_path / "one"), on_ranks(script, 2, tmp_path / "two")
    assert both == [alone, alone] and alone
    assert (tmp_path / "two" / "cycle.json").exists()


def test_what_a_callback_raises_on_one_rank_ends_all_and_leaves_nothing_behind(on_ranks):
    script = """
case = case.with_({"Mechanism/Instants": 4, "Accuracy": "10 %"})

def stop(told):
    if comm.rank == 1:
        raise KeyError("enough")

for computation in (lambda: geneva.run(case, comm=comm, progress=stop),
                    lambda: geneva.run(case, comm=comm, on_step=stop),
                    lambda: geneva.cycle(case, comm=comm, progress=stop)):
    try:
        computation()
    except KeyError as error:
        print("raised", error)
    except geneva.EndedByOtherRank as error:
        print("ended:", str(error).splitlines()[0])
print(geneva.run(case, comm=comm).is_converged)
"""
    assert on_ranks(script, 2) == [3 * "ended: KeyError: 'enough'\n" + "True\n", 3 * "raised 'enough'\n" + "True\n"]


def test_without_a_communicator_each_rank_is_alone(on_ranks):
    script = """
given = case.with_({"Mechanism/Wheel diameter": 4.5 + comm.rank, "Accuracy": "10 %"})
pressure = geneva.run(given).contacts[0].peak_pressure
print(abs(pressure / geneva.estimate(given).figure("peak contact pressure").value - 1) < 0.1, pressure)
"""
    first, second = (text.split() for text in on_ranks(script, 2))
    assert first[0] == second[0] == "True" and abs(float(first[1]) / float(second[1]) - 1) > 0.04


def test_mpi4py_may_be_imported_after_the_first_run(on_ranks):
    script = """
import geneva
case = geneva.read_case(sys.argv[1]).with_("Accuracy", "10 %")
geneva.run(case)
from mpi4py import MPI
print(geneva.run(case, comm=MPI.COMM_WORLD).is_converged)
"""
    assert on_ranks(script, 2, head=PRINTING) == ["True\n", "True\n"]


def test_a_process_without_mpi4py_runs_alone_and_ends_quietly(command, cases, tmp_path):
    script = ("import sys; sys.modules['mpi4py'] = None\nimport geneva\n"
              "kept = geneva.run(geneva.read_case(sys.argv[1]))\nprint(kept.is_converged)")
    assert command(sys.executable, "-c", script, cases / "johnson-optimum-wheel", cwd=tmp_path) == "True\n"


def test_what_is_no_communicator_is_refused(cases):
    import geneva
    with pytest.raises(TypeError, match="comm: a communicator of mpi4py is wanted"):
        geneva.run(geneva.read_case(os.path.join(cases, "johnson-optimum-wheel")), comm=2)
