"""The scripts of doc/python run as they stand, and say what the page says that they do."""

import os
import pathlib
import re
import sys
import xml.etree.ElementTree

SOURCE = pathlib.Path(os.environ["GENEVA_SOURCE"])
SCRIPTS = SOURCE / "doc" / "python"


def test_the_pressure_falls_with_the_pin_diameter(command):
    printed = command(sys.executable, "-B", SCRIPTS / "pin_diameter.py", cwd=SOURCE)
    page = (SOURCE / "doc" / "how-to-python.md").read_text()
    assert all(f"    {row}\n" in page for row in printed.splitlines()[:4])
    pressures = [float(row.split()[1]) for row in printed.splitlines()[1:-1]]
    assert len(pressures) == 11 and pressures == sorted(pressures, reverse=True)


def test_the_pressure_along_the_contact_is_drawn_beside_hertz(command, tmp_path):
    for ranks in (1, 2):
        picture = tmp_path / f"pressure{ranks}.svg"
        printed = command("mpirun", "-n", ranks, sys.executable, "-B", SCRIPTS / "pressure_along_contact.py",
                          SOURCE / "cases" / "johnson-optimum-wheel", picture)
        assert re.fullmatch(r"peak pressure 501\.\d MPa within 0\.\d+ %, half-width 0\.\d+ mm; along the contact at most "
                            r"\d\.\d+ % of the peak from Hertz's\n", printed), printed
        curves = xml.etree.ElementTree.parse(picture).getroot()
        assert len(curves) == 2 and all(len(curve.get("points").split()) > 10 for curve in curves)


def test_a_case_of_numbers_is_run_and_written(command, tmp_path):
    printed = command(sys.executable, "-B", SCRIPTS / "case_of_numbers.py", tmp_path / "results", cwd=tmp_path)
    assert re.search(r"greatest pin force \d+\.\d N at -\d+\.\d+ deg", printed)
    assert "peak contact pressure: " in printed and (tmp_path / "results" / "report.html").exists()


def test_every_script_is_tested():
    tested = pathlib.Path(__file__).read_text()
    assert all(script.name in tested for script in SCRIPTS.glob("*.py"))
