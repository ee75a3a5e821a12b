"""Analyses by finite elements on one rank, beside what the command line writes."""

import csv
import json
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import geneva

PROGRAM = os.environ["GENEVA_PROGRAM"]


@pytest.fixture(scope="module")
def case():
    return geneva.read_case(os.path.join(os.environ["GENEVA_SOURCE"], "cases", "johnson-optimum-wheel"))


@pytest.fixture(scope="module")
def result(case):
    return geneva.run(case)


def test_the_figures_are_those_of_the_command(case, result, tmp_path, command):
    command(PROGRAM, "run", case.directory, "--output", tmp_path / "command")
    summary = json.loads((tmp_path / "command" / "summary.json").read_text())
    assert result.error == summary["contact"]["peak_pressure_error"]
    assert result.contacts[0].peak_pressure == summary["contact"]["peak_pressure"]["value"]
    for section in ("bodies", "checks", "comparison", "contact_pairs", "equilibrium", "load", "mesh", "notices"):
        assert result.document[section] == summary[section], section
    written = result.write(tmp_path / "library")
    names = [{file.name for file in (tmp_path / one).iterdir()} for one in ("command", "library")]
    assert names[0] == names[1] and written.missing_packages == ()
    rows = list(csv.DictReader((tmp_path / "command" / "contact.csv").open()))
    pressure = result.contacts[0].to("in-lbf").pressure
    np.testing.assert_allclose(np.sort(pressure), np.sort([float(row["contact_pressure [psi]"]) for row in rows]), rtol=1e-5,
                               atol=1e-3)


def test_the_peak_pressure_is_hertz_and_johnson_within_its_error(result):
    figure = result.figure("peak contact pressure").to("in-lbf")
    assert figure.published == pytest.approx(72600)
    assert abs(figure.value / figure.closed_form - 1) < figure.error + 1e-3
    assert result.is_converged and result.shortfall == "" and all(check.is_passed for check in result.checks)


def test_a_contact_has_arrays_with_their_units(result):
    contact = result.contacts[0]
    nodes = len(contact.pressure)
    assert contact.place.shape == (nodes, 3) and contact.gap.shape == contact.hertz_pressure.shape == (nodes,)
    assert contact.units["pressure"] == "Pa" and contact.to("in-lbf").units["half_width"] == "in"
    assert np.all(contact.pressure >= 0) and np.all(contact.gap[contact.pressure > 0] < 1e-9)
    assert contact.to("in-lbf").to("SI").peak_pressure == pytest.approx(contact.peak_pressure, rel=1e-15)
    assert repr(contact).startswith("<geneva.Contact ")
    assert np.linalg.norm(contact.force) == pytest.approx(
        abs(result.figure("contact force").value), rel=1e-6)


def test_the_pressure_along_the_contact_is_hertz(result):
    contact = result.contacts[0]
    difference = np.abs(contact.pressure - contact.hertz_pressure) / contact.peak_pressure
    assert difference[contact.hertz_pressure > 0.4 * contact.peak_pressure].max() < 0.005
    # The slope has no bound at the rim: half of an edge 2 a/N within it Hertz's pressure is p0 sqrt(2/N).
    assert difference.max() < np.sqrt(2 / np.count_nonzero(contact.pressure))


def test_fields_are_arrays_of_nodes_and_cells(result):
    fields = result.fields()
    nodes = len(fields.place)
    assert fields.displacement.shape == (nodes, 3) and fields.stress.shape == (nodes, 6)
    assert fields.cells.shape[1] == 4 and fields.cells.max() < nodes and len(fields.bodies) == len(fields.cells)
    xx, yy, zz, xy, yz, zx = fields.stress.T
    von_mises = np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * (xy**2 + yz**2 + zx**2))
    np.testing.assert_allclose(fields.von_mises, von_mises, rtol=1e-9, atol=1e-6 * von_mises.max())
    kept = fields.stress.copy()
    fields.stress[:] = 0
    np.testing.assert_array_equal(result.fields().stress, kept)


def test_progress_tells_of_every_mesh_and_step(case):
    meshes, steps = [], []
    result = geneva.run(case, progress=meshes.append, on_step=steps.append)
    assert tuple(mesh.unknowns for mesh in meshes) == tuple(mesh.unknowns for mesh in result.meshes)
    assert meshes[-1].error == pytest.approx(result.error)
    assert sum(step.step > 0 for step in steps) == sum(len(mesh.linear_iterations) for mesh in meshes)


def test_an_exception_of_a_callback_ends_the_run_and_arrives_unchanged(case):
    class Enough(Exception):
        pass

    thrown = Enough("the second mesh")
    meshes = []

    def stop(mesh):
        meshes.append(mesh)
        if len(meshes) == 2:
            raise thrown

    with pytest.raises(Enough) as caught:
        geneva.run(case, progress=stop)
    assert caught.value is thrown and len(meshes) == 2
    assert geneva.run(case).is_converged  # and nothing is left of it


def test_ctrl_c_ends_a_run_without_any_callback(case):
    timer = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    slow = case.with_("Accuracy", "0.01 %")
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(100):
            geneva.run(slow)


def test_other_threads_go_on_meanwhile(case):
    counted = [0]
    is_over = threading.Event()

    def count():
        while not is_over.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    geneva.run(case)
    during = counted[0] - before
    is_over.set()
    thread.join()
    assert during > 20


def test_what_cannot_be_solved_is_refused_in_the_words_of_the_command(cases, geneva_command):
    case = geneva.read_case(cases / "synthesis-quick-return")
    with pytest.raises(geneva.InputError) as refused:
        geneva.run(case)
    assert str(refused.value) == geneva_command("run", case.directory)


def test_a_limit_that_is_reached_before_any_result_is_an_exception(case):
    with pytest.raises(geneva.LimitReached, match="Gmsh took more than 0.001 s .* raise 'Maximum time'"):
        geneva.run(case.with_("Maximum time", 0.001))


def test_a_limit_that_is_reached_later_leaves_a_result_that_says_so(case):
    result = geneva.run(case.with_("Maximum refinement levels", 3))
    assert not result.is_converged and "Maximum refinement levels" in result.shortfall
    assert "not converged" in repr(result)


def test_a_cycle_is_solved_instant_by_instant(case, tmp_path):
    case = case.with_({"Mechanism/Instants": 4, "Accuracy": "5 %"})
    told = []
    found = geneva.cycle(case, progress=told.append)
    assert [instant.done for instant in told] == list(range(1, len(told) + 1)) and told[-1].of == len(told)
    assert len(found.instants["peak pressure"]) == len(told)
    solved = ~np.isnan(found.instants["peak pressure"])
    assert len(found.fields()) == solved.sum() and "deg" in told[0].words
    found.write(tmp_path)
    assert (tmp_path / "cycle.json").exists()
    with pytest.raises(ZeroDivisionError):
        geneva.cycle(case, progress=lambda instant: 1 / 0)


def test_a_geometry_has_its_load_steps(tmp_path):
    case = geneva.read_case(os.path.join(os.environ["GENEVA_SOURCE"], "cases", "mindlin-sphere")).with_({
        "Accuracy": "20 %", "Maximum refinement levels": 3})
    meshes = []
    found = geneva.load_steps(case, progress=meshes.append)
    (contact,) = found.contacts.values()
    assert len(meshes) > 1 and list(found.contacts) == ["sphere surface -> block top"]
    np.testing.assert_allclose(np.abs(contact["force y"]), 60, rtol=1e-6)
    np.testing.assert_allclose(np.abs(contact["friction force x"]), [0, 6.75, 13.5], atol=1e-6)
    assert contact.to("mm-N").units["peak pressure"] == "MPa"
    assert np.all(np.diff(contact["heat of friction"]) >= 0)
    fields = found.fields()
    assert len(fields) == 3 and fields[0].von_mises.max() == pytest.approx(
        max(found.stresses[body]["von Mises"][0] for body in ("sphere", "block")))
    found.write(tmp_path)
    assert (tmp_path / "load_steps.pvd").exists()
    with pytest.raises(geneva.InputError, match="Load steps"):
        geneva.load_steps(os.path.join(os.environ["GENEVA_SOURCE"], "cases", "hertz-line-contact"))


def test_a_sweep_of_runs_has_their_figures(case, result):
    told = []
    found = geneva.sweep(case, {"Mechanism/Wheel diameter": ["4.53 in", "5 in"]}, with_="run",
                         progress=lambda *done: told.append(done))
    assert told == [(1, 2), (2, 2)]
    assert found.values("peak contact pressure")[0] == result.contacts[0].peak_pressure
    assert found.points[1].figures["peak contact pressure"].error < 0.005


def test_jobs_of_a_sweep_are_processes_of_their_own(case, tmp_path, command):
    script = tmp_path / "jobs.py"
    script.write_text("""
import sys
import geneva

if __name__ == "__main__":
    case = geneva.read_case(sys.argv[1]).with_("Accuracy", "5 %")
    diameters = ["4.53 in", "5 in", "0.1 in"]
    told = []
    alone, shared = (geneva.sweep(case, {"Mechanism/Wheel diameter": diameters}, with_="run", jobs=jobs,
                                  progress=lambda *done: told.append(done)) for jobs in (1, 2))
    pressures = [found.values("peak contact pressure")[:2].tolist() for found in (alone, shared)]
    messages = [[point.message for point in found.points] for found in (alone, shared)]
    print(pressures[0] == pressures[1], messages[0] == messages[1], told[-1])
""")
    assert command(sys.executable, "-B", script, case.directory) == "True True (3, 3)\n"
    with pytest.raises(geneva.InputError, match="jobs = 0: a whole number of 1 or more"):
        geneva.sweep(case, {"Mechanism/Wheel diameter": ["5 in"]}, with_="run", jobs=0)


def test_an_optimum_and_a_design_are_confirmed_by_finite_elements(case):
    free = case.with_({"Optimisation/Free": "Wheel diameter: 4 in .. 6 in", "Accuracy": "5 %"})
    pressure = geneva.optimise(free, confirm=True).figure("peak contact pressure")
    assert abs(pressure.value / pressure.closed_form - 1) < 0.05 and pressure.error < 0.05
    told = []
    strength = geneva.design(case, strength=True, progress=lambda *done: told.append(done)).strength
    assert told[-1] == (len(told), len(told)) and len(strength["diameter"]) == len(told)
    assert np.all(np.diff(strength["diameter"]) > 0) and np.all(strength["tensile stress"] > 0)


def test_processes_of_a_pool_solve_a_case_each(case, tmp_path, command):
    script = tmp_path / "pool.py"
    script.write_text("""
import multiprocessing
import sys
import geneva

def pressure(case):
    return geneva.run(case).contacts[0].peak_pressure

if __name__ == "__main__":
    case = geneva.read_case(sys.argv[1]).with_("Accuracy", "5 %")
    cases = [case.with_("Mechanism/Wheel diameter", diameter) for diameter in (4.5, 5.0)]
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        print(pool.map(pressure, cases) == [pressure(one) for one in cases])
""")
    assert command(sys.executable, "-B", script, case.directory) == "True\n"


def test_a_mesher_that_is_missing_is_told_with_the_places_looked_at(tmp_path, case, command):
    """By a copy of the package whose libraries lie where there is no mesher."""
    import geneva._core
    package = os.path.dirname(geneva._core.__file__)
    libraries = tmp_path / "libraries"
    libraries.mkdir()
    maps = subprocess.run(["ldd", os.path.join(package, "_solver" + geneva._core.__file__.split("_core")[1])],
                          capture_output=True, text=True, check=True).stdout
    for line in maps.splitlines():
        if "libgeneva" in line:
            name, path = line.split(" => ")[0].strip(), line.split(" => ")[1].split(" (")[0]
            (libraries / name).write_bytes(open(path, "rb").read())
    script = "import sys, geneva\ntry: geneva.run(geneva.read_case(sys.argv[1]))\nexcept geneva.InputError as e: print(e)"
    done = subprocess.run([sys.executable, "-c", script, case.directory], capture_output=True, text=True, check=True,
                          env={**os.environ, "LD_LIBRARY_PATH": str(libraries)}).stdout
    assert f"there is no {os.path.dirname(os.path.realpath(sys.executable))}/geneva-mesher" in done
    assert str(libraries / "geneva-mesher") in done


def test_what_is_started_after_a_run_does_not_see_how_mpi_was_started(result):
    assert subprocess.run("env | grep OMPI_MCA_btl", shell=True, capture_output=True, check=False).stdout == b""
