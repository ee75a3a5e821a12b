"""Cases that are read, built and changed, and what is said against wrong ones."""

import copy
import pickle

import numpy as np
import pytest

import geneva

WHEEL = {"Stations": 6, "Wheel diameter": "120 mm", "Driver speed": "300 rpm", "Load inertia": "0.002 kg.m^2"}


def wheel(**changes):
    return geneva.new_case({"Output units": "mm-N", "Mechanism": {**WHEEL, **changes}})


def test_a_case_is_read_from_its_directory(cases):
    case = geneva.read_case(cases / "johnson-optimum-wheel")
    assert (case.name, case.model, case.units, case.dimension) == ("johnson-optimum-wheel", "mechanism", "in-lbf", 2)
    assert case.directory == cases / "johnson-optimum-wheel"
    assert case.parameters["Mechanism/Wheel diameter"] == "4.53 in"
    assert repr(case) == ("<geneva.Case johnson-optimum-wheel: Johnson 1956, Example 1, optimum wheel, mechanism, "
                          "in-lbf>")


def test_a_built_case_is_that_of_the_file_with_the_same_lines(tmp_path):
    built = wheel()
    lines = "".join(f"  set {name} = {value}\n" for name, value in WHEEL.items())
    (tmp_path / "case.prm").write_text(f"set Output units = mm-N\nsubsection Mechanism\n{lines}end\n")
    assert geneva.read_case(tmp_path).text == built.text


def test_paths_and_nested_dicts_say_the_same():
    nested = wheel(**{"Pin material": {"Material": "100Cr6 hardened"}})
    flat = geneva.new_case({"Output units": "mm-N", "Mechanism/Pin material/Material": "100Cr6 hardened",
                            **{f"Mechanism/{name}": value for name, value in WHEEL.items()}})
    assert nested.text == flat.text


def test_the_text_of_a_case_is_a_case_file_of_the_same_case(tmp_path):
    built = wheel(**{"Pin diameter": 8})
    (tmp_path / "case.prm").write_text(built.text)
    assert geneva.read_case(tmp_path).text == built.text


@pytest.mark.parametrize("units, length", [("SI", 0.12), ("mm-N", 120), ("in-lbf", 120 / 25.4)])
def test_a_number_is_in_the_own_unit_of_the_case(units, length):
    given = geneva.new_case({"Output units": units, "Mechanism": {**WHEEL, "Wheel diameter": length}})
    text = geneva.new_case({"Output units": units, "Mechanism": WHEEL})
    assert (geneva.estimate(given).figures[0].value ==
            pytest.approx(geneva.estimate(text).figures[0].value, rel=1e-12))


def test_every_dimension_of_a_number_is_read_in_every_system_of_units():
    numbers = {"Pin diameter": 14, "Driver speed": 30, "Friction moment": 1, "Load inertia": 1, "Driver angle": -0.1,
               "Pin material": {"Young's modulus": 2e5, "Poisson's ratio": 0.3, "Density": 7850}}
    for units in ("SI", "mm-N", "in-lbf"):
        case = geneva.new_case({"Output units": units, "Allowable": {"Contact pressure": 900,
                                                                     "Pressure times slip speed": 3},
                                "Published": {"Peak pressure": 1}, "Maximum time": 5, "Maximum memory": 2,
                                "Mechanism": {"Stations": 6, "Wheel diameter": 120, **numbers}})
        unit = geneva.unit_of("length", units)[0]
        assert case.parameters["Mechanism/Pin diameter"] == f"14 {unit}"
        assert case.parameters["Maximum memory"] == "2 GB"


def test_lists_are_taken_where_the_parameter_takes_several(cases):
    block = geneva.read_case(cases / "flat-patch").with_("Geometry/Body lower/Density", "7850 kg/m^3")
    name = "Geometry/Body lower/Gravity"
    assert block.with_(name, np.array([0.0, -9810.0])).parameters[name] == "0 mm/s^2, -9810 mm/s^2"
    assert block.with_(name, ["0 m/s^2", "-9.81 m/s^2"]).parameters[name] == "0 m/s^2, -9.81 m/s^2"
    for wrong in ([0.0, 0.0, 0.0, 1.0], [1.0]):
        with pytest.raises(geneva.InputError, match="'Body lower/Gravity' = .*2 or 3 values separated by a comma"):
            block.with_(name, wrong)


def test_with_changes_one_parameter_and_leaves_the_case(cases):
    case = geneva.read_case(cases / "johnson-optimum-wheel")
    changed = case.with_("Mechanism/Wheel diameter", "5 in")
    assert changed.parameters["Mechanism/Wheel diameter"] == "5 in"
    assert case.parameters["Mechanism/Wheel diameter"] == "4.53 in"
    assert changed.with_({"Mechanism": {"Wheel diameter": 4.53}}).text == case.text


def test_a_changed_case_that_lies_in_no_file_can_be_changed_again():
    case = wheel().with_("Mechanism/Pin diameter", "13 mm").with_("Mechanism/Pin diameter", "14 mm")
    assert case.text == wheel(**{"Pin diameter": "14 mm"}).text


def test_starter_cases_run_as_they_are():
    for kind in ("external", "internal", "spherical", "long dwell", "four-bar"):
        assert geneva.estimate(geneva.starter_case(kind)).figures
    assert geneva.starter_case(stations=8, units="in-lbf").units == "in-lbf"
    with pytest.raises(geneva.InputError, match="geneva init --type geometry DIR"):
        geneva.starter_case("geometry")
    with pytest.raises(geneva.InputError, match="'extrenal': there is no such type.*did you mean 'external'"):
        geneva.starter_case("extrenal")


def test_cases_are_copied_and_pickled(cases):
    for case in (geneva.read_case(cases / "crowned-pin"), wheel(), wheel().with_("Mechanism/Pin diameter", 14)):
        assert pickle.loads(pickle.dumps(case)).text == case.text
        assert copy.deepcopy(case).parameters == case.parameters


def test_commands_take_the_path_of_a_case_directory_too(cases):
    directory = cases / "johnson-optimum-wheel"
    force = geneva.kinematics(geneva.read_case(directory)).figure("maximum pin force").value
    assert geneva.kinematics(directory).figure("maximum pin force").value == force
    assert geneva.kinematics(str(directory)).figure("maximum pin force").value == force
    with pytest.raises(geneva.InputError, match=r"no case.prm|no such (file|directory)"):
        geneva.estimate("nowhere")
    with pytest.raises(geneva.InputError, match="is no case: what read_case"):
        geneva.estimate(3)  # type: ignore[arg-type]


def test_a_sweep_over_one_number_has_one_point(cases):
    case = cases / "johnson-optimum-wheel"
    assert len(geneva.sweep(case, {"Mechanism/Driver speed": 600.}).points) == 1
    with pytest.raises(geneva.InputError, match="texts or numbers are wanted, not NoneType"):
        geneva.sweep(case, {"Mechanism/Driver speed": None})  # type: ignore[dict-item]


def test_a_wrong_file_is_refused_in_the_words_of_the_command(tmp_path, geneva_command):
    (tmp_path / "case.prm").write_text("set Modell = mechanism\n")
    with pytest.raises(geneva.InputError) as refused:
        geneva.read_case(tmp_path)
    assert str(refused.value) == geneva_command("run", tmp_path)
    with pytest.raises(ValueError, match="there is no such directory"):
        geneva.read_case(tmp_path / "nowhere")


@pytest.mark.parametrize("changes, words", [
    ({"Pin diametre": 8}, "the new case: there is no parameter 'Pin diametre' in the subsection 'Mechanism'; "
                          "did you mean 'Pin diameter'"),
    ({"Pin diameter": "8"}, "the new case: 'Pin diameter' = '8': a length with its unit"),
    ({"Pin diameter": "8 kg"}, "'Pin diameter' = '8 kg': 'kg' is no unit of length"),
    ({"Pin diameter": float("nan")}, "'Pin diameter' = 'nan mm': the number is not finite"),
    ({"Pin diameter": [8, 9]}, "'Pin diameter' = '8 mm, 9 mm'"),
    ({"Pin diameter": None}, "'Pin diameter' = None: a text, a number or a list of these is wanted, not NoneType"),
    ({"Pin diameter": [8, "9 mm"]}, "'Pin diameter' = .*: a text, a number or a list"),
    ({"Pin diameter": {"Value": 8}}, "there is no subsection 'Pin diameter' in 'Mechanism'"),
    ({"Pin material": "steel"}, "'Pin material' is a subsection"),
    ({"Stations": 6.5}, "'Stations' = '6.5'"),
    ({"Stations": "6 # or 8"}, "'Stations' = '6 # or 8': a value is one line without '#'"),
    ({"Type": "extrenal"}, "'Type' = 'extrenal': one of .* is wanted .did you mean 'external'"),
    ({"Stations": 6, " Stations": 8}, "'Stations' is set twice"),
])
def test_a_wrong_value_is_refused_with_the_name_of_its_parameter(changes, words):
    with pytest.raises(geneva.InputError, match=words):
        wheel(**changes)


def test_a_subsection_of_another_model_is_refused():
    with pytest.raises(geneva.InputError, match="the new case: the subsection 'Geometry' belongs to Model = geometry"):
        geneva.new_case({"Mechanism": WHEEL, "Geometry": {"File": "a.geo"}})
    with pytest.raises(geneva.InputError, match="there is no subsection 'Mechanizm'; did you mean 'Mechanism'"):
        geneva.new_case({"Mechanizm": WHEEL})


def test_a_wrong_change_names_the_file_and_what_changed_it(cases):
    case = geneva.read_case(cases / "johnson-optimum-wheel")
    with pytest.raises(geneva.InputError, match=r"case\.prm and with_: 'Wheel diameter' = '-1 in'"):
        case.with_("Mechanism/Wheel diameter", -1)
