"""What is computed without finite elements, beside the files that the command line writes."""

import csv
import json
import math
import os
import sys

import numpy as np
import pytest

import geneva

PROGRAM = os.environ["GENEVA_PROGRAM"]


@pytest.fixture
def johnson(cases):
    return geneva.read_case(cases / "johnson-optimum-wheel")


def without_date(document):
    document["case"].pop("date")
    return document


def columns_of(file):
    rows = list(csv.reader(file.open()))
    return {name: column for name, *column in zip(*rows)}


def test_kinematics_are_those_of_the_command(johnson, tmp_path, command):
    found = geneva.kinematics(johnson)
    printed = command(PROGRAM, "kinematics", johnson.directory, "--output", tmp_path)
    assert found.table() in printed
    assert without_date(found.document) == without_date(json.loads((tmp_path / "kinematics.json").read_text()))
    columns = columns_of(tmp_path / "kinematics.csv")
    curves = found.curves.to("in-lbf")
    for name, heading in {"driver angle": "driver_angle [deg]", "pin force": "pin_force [lbf]",
                          "Hertz pressure": "hertz_pressure [psi]", "time": "time [s]",
                          "slip speed": "slip_speed [in/s]", "jerk ratio": "jerk_ratio"}.items():
        np.testing.assert_allclose(curves[name], np.array(columns[heading], dtype=float), rtol=1e-9, atol=1e-9)
    assert list(found.walls) == columns["wall"]


def test_curves_say_their_units_and_names(johnson):
    curves = geneva.kinematics(johnson, steps=10).curves
    assert curves.units["pin force"] == "N" and curves.to("in-lbf").units["pin force"] == "lbf"
    assert curves.units["speed ratio"] == ""
    assert len(curves["pin force"]) == len(curves["time"]) >= 10
    assert curves["pin force"].dtype == np.float64
    with pytest.raises(KeyError, match="'pin fource': there are 'time', 'driver angle'"):
        curves["pin fource"]
    assert "pin force [N]" in repr(curves)


def test_arrays_outlive_their_result_and_are_their_own(johnson):
    found = geneva.kinematics(johnson)
    force = found.curves["pin force"]
    kept = force.copy()
    force[:] = 0.0
    np.testing.assert_array_equal(found.curves["pin force"], kept)
    del found
    assert force.flags.owndata


def test_figures_have_names_units_and_angles(johnson):
    found = geneva.kinematics(johnson)
    force = found.figure("maximum pin force")
    assert force.unit == "N" and force.driver_angle == pytest.approx(found.curves["driver angle"][np.argmax(
        found.curves["pin force"])], abs=0.01)
    assert force.to("in-lbf").value == pytest.approx(force.value / 4.4482216152605, rel=1e-12)
    assert str(force.to("in-lbf")).endswith(" lbf")
    with pytest.raises(KeyError, match="'weight': there are 'reference speed', "):
        found.figure("weight")


def test_an_estimate_is_hertz(johnson):
    found = geneva.estimate(johnson)
    pressure = found.figure("peak contact pressure")
    assert pressure.to("in-lbf").value == pytest.approx(72675, rel=1e-4)
    assert max(found.curves["Hertz pressure"]) == pytest.approx(
        found.figure("greatest pressure of the engagement").value, rel=1e-3)
    assert len(found.pin) == 0 and found.left_out


def test_an_estimate_in_3d_has_the_line_load_along_the_pin(cases):
    pin = geneva.estimate(geneva.read_case(cases / "crowned-pin")).pin
    assert np.all(np.diff(pin["z"]) > 0) and np.all(pin["line load"] >= 0)
    assert pin.units == {"z": "m", "line load": "N/m"}


def test_a_design_has_its_best_wheel_where_the_curve_is_least(johnson):
    found = geneva.design(johnson)
    best = found.figure("diameter, best wheel by Johnson").value
    curve = found.curves
    at = np.nanargmin(curve["peak pressure by Johnson"])
    assert curve["diameter"][at - 1] < best < curve["diameter"][at + 1]
    assert "best" in found.table() or "Johnson" in found.table()


def test_a_crown_evens_the_line_load(cases):
    found = geneva.crown(geneva.read_case(cases / "tilted-pin"))
    assert max(found.after["line load"]) < max(found.before["line load"])
    assert found.size > 0 and found.is_converged is None and found.best.dimension == 3


def test_a_linkage_is_synthesized(cases):
    found = geneva.synthesize(geneva.read_case(cases / "synthesis-quick-return"))
    assert found.shortfall == "" and found.document["case"] and found.table()


def test_an_optimum_keeps_its_limits_also_of_a_case_in_no_file(johnson):
    case = johnson.with_({"Optimisation": {"Free": "Wheel diameter: 3 in .. 8 in", "Minimise": "peak contact pressure"}})
    told = []
    found = geneva.optimise(case, progress=told.append)
    assert told == sorted(told)
    before, after = (geneva.estimate(one).figure("peak contact pressure").value for one in (case, found.best))
    assert after <= before * (1 + 1e-9)
    assert found.figure("peak contact pressure").value == pytest.approx(after, rel=1e-9)


def test_results_are_written_as_the_command_does(johnson, tmp_path):
    written = geneva.estimate(johnson).write(tmp_path / "results")
    assert written.directory == tmp_path / "results" and written.removed == ()
    assert {"estimate.json", "estimate.csv", "report.html"} <= {file.name for file in written.directory.iterdir()}
    (tmp_path / "results" / "report.html").unlink()
    geneva.write_report(tmp_path / "results")
    assert (tmp_path / "results" / "report.html").exists()
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(geneva.InputError, match="file"):
        geneva.estimate(johnson).write(tmp_path / "file")


def test_a_sweep_is_that_of_the_command(johnson, tmp_path, command):
    found = geneva.sweep(johnson, {"Mechanism/Wheel diameter": "4 in .. 6 in, 3", "Mechanism/Stations": ["4", "6"]})
    command(PROGRAM, "sweep", johnson.directory, "--set",
            "Mechanism/Wheel diameter = 4 in .. 6 in, 3", "--set", "Mechanism/Stations = 4; 6", "--with", "estimate",
            "--output", tmp_path / "sweep")
    assert without_date(found.document) == without_date(json.loads((tmp_path / "sweep" / "sweep.json").read_text()))
    assert [point.values for point in found.points][:3] == [("4 in", "4"), ("4 in", "6"), ("5 in", "4")]
    np.testing.assert_array_equal(found.numbers("Mechanism/Wheel diameter"), [4, 4, 5, 5, 6, 6])


def test_a_sweep_takes_numbers_of_numpy_in_the_own_unit_of_the_case(johnson):
    found = geneva.sweep(johnson, {"Mechanism/Pin diameter": np.linspace(0.5, 0.8, 4)})
    np.testing.assert_allclose(found.numbers("Mechanism/Pin diameter"), np.linspace(0.5, 0.8, 4), rtol=1e-12)
    pressure = found.values("peak contact pressure", units="in-lbf")
    for point, value in zip(found.points, pressure):
        assert geneva.estimate(point.case).figure("peak contact pressure").to("in-lbf").value == pytest.approx(value)


def test_a_sweep_says_which_combinations_are_refused(johnson):
    found = geneva.sweep(johnson, {"Mechanism/Pin diameter": ["0.6 in", "6 in"]})
    good, bad = found.points
    assert good.message == "" and good.is_converged
    assert bad.case is None and bad.message and math.isnan(found.values("peak contact pressure")[1])
    with pytest.raises(geneva.InputError, match="with_ = 'estimation'"):
        geneva.sweep(johnson, {"Mechanism/Pin diameter": ["0.6 in"]}, with_="estimation")
    with pytest.raises(geneva.InputError, match="--set .*both ends of a range have the same unit"):
        geneva.sweep(johnson, {"Mechanism/Pin diameter": "8 mm .. 1 in, 3"})
    with pytest.raises(geneva.InputError, match="texts alone or numbers alone"):
        geneva.sweep(johnson, {"Mechanism/Pin diameter": [8, "9 mm"]})


def test_a_command_that_a_case_is_not_for_is_refused_in_its_words(cases, geneva_command):
    with pytest.raises(geneva.InputError) as refused:
        geneva.kinematics(geneva.read_case(cases / "hertz-sphere"))
    assert str(refused.value) == geneva_command("kinematics", cases / "hertz-sphere")


def test_nothing_of_finite_elements_is_loaded_by_closed_forms(command, cases):
    script = ("import sys, geneva; geneva.estimate(geneva.read_case(sys.argv[1])); "
              "maps = open('/proc/self/maps').read(); print('deal' in maps, 'libmpi' in maps)")
    assert command(sys.executable, "-c", script, cases / "johnson-optimum-wheel").split() == ["False"] * 2


