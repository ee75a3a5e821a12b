"""An installed Geneva: its commands, and programs of somebody else that are built against its library.

    python3 tests/install/check_install.py BUILD_DIRECTORY SOURCE_DIRECTORY
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path()
SOURCE = pathlib.Path()
TIME_LIMIT = 300
# Of Debian, for which the package is built.
PYTHON = os.environ.get("GENEVA_PYTHON", "/usr/bin/python3")
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_mpi_yield_when_idle": "1"}


def run(*command, code=0, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, env=ENVIRONMENT,
                          timeout=TIME_LIMIT, check=False, **options)
    if done.returncode != code:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Install(unittest.TestCase):
    """Installs into a directory that the build does not know, as packagers do, and uses what is there."""

    @classmethod
    def setUpClass(cls):
        cls.room = pathlib.Path(tempfile.mkdtemp(prefix="geneva-install-"))
        cls.addClassCleanup(shutil.rmtree, cls.room, ignore_errors=True)
        run("cmake", "--install", BUILD, "--prefix", cls.room / "first")
        cls.prefix = (cls.room / "first").rename(cls.room / "moved")  # it must not matter where it lies
        run("cmake", "-S", SOURCE / "tests/install", "-B", cls.room / "build", "-G", "Ninja",
            "-D", "CMAKE_BUILD_TYPE=Release", "-D", f"CMAKE_PREFIX_PATH={cls.prefix}")
        run("cmake", "--build", cls.room / "build")
        cls.case = cls.prefix / "share/geneva/cases/johnson-optimum-wheel"

    def summary(self, directory):
        return json.loads((directory / "summary.json").read_text())

    def pressures(self, *cases, ranks):
        """What the program against the library prints of each case, and the results of the last one."""
        results = self.room / f"library{ranks}"
        lines = run("mpirun", "-n", ranks, self.room / "build/pressure", *cases, results).splitlines()
        return [tuple(map(float, line.split())) for line in lines], self.summary(results)

    def test_the_installed_command_solves_an_installed_case(self):
        results = self.room / "command"
        run(self.prefix / "bin/geneva", "run", self.case, "--output", results)
        self.assertTrue((results / "report.html").exists())
        self.assertLess(self.summary(results)["contact"]["peak_pressure_error"], 0.005)

    def test_manual_pages_completions_and_materials_lie_where_systems_look_for_them(self):
        share = self.prefix / "share"
        commands_text = run(self.prefix / "bin/geneva", "help").split("Subcommands:")[1].split("Examples:")[0]
        commands = re.findall(r"^  ([a-z]+) ", commands_text, re.MULTILINE)
        self.assertEqual({path.name for path in (share / "man/man1").iterdir()},
                         {"geneva.1.gz", *(f"geneva-{command}.1.gz" for command in commands)})
        self.assertIn("complete -o dirnames -F _geneva geneva", (share / "bash-completion/completions/geneva").read_text())
        self.assertTrue((share / "zsh/site-functions/_geneva").exists())
        self.assertTrue((share / "fish/vendor_completions.d/geneva.fish").exists())
        self.assertIn("subsection 42CrMo4 nitrided", (share / "geneva/materials.prm").read_text())

    def test_the_library_finds_what_the_command_does_on_two_ranks(self):
        by_command = self.room / "two"
        run("mpirun", "-n", 2, self.prefix / "bin/geneva", "run", self.case, "--output", by_command)
        ((pressure, error, *_),), by_library = self.pressures(self.case, ranks=2)
        summary = self.summary(by_command)
        self.assertEqual(pressure, summary["contact"]["peak_pressure"]["value"])
        self.assertEqual(error, summary["contact"]["peak_pressure_error"])
        for section in ("bodies", "checks", "comparison", "contact_pairs", "equilibrium", "load", "mesh", "notices"):
            self.assertEqual(by_library[section], summary[section], section)

    def test_two_analyses_in_one_process_find_the_same(self):
        other = self.prefix / "share/geneva/cases/hertz-sphere"
        together, _ = self.pressures(self.case, other, self.case, ranks=1)
        self.assertEqual(together[0], together[2])
        self.assertEqual(together[1], self.pressures(other, ranks=1)[0][0])

    def test_a_wrong_case_is_an_exception_with_the_message_of_the_command(self):
        wrong = self.room / "wrong"
        wrong.mkdir()
        (wrong / "case.prm").write_text("set Modell = mechanism\n")
        done = subprocess.run([str(self.room / "build/pressure"), str(wrong), "nowhere"], capture_output=True, text=True,
                              env=ENVIRONMENT, timeout=TIME_LIMIT, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "line 1: there is no parameter 'Modell'.*did you mean 'Model'")

    def test_the_python_package_is_found_and_finds_the_mesher_where_the_prefix_was_moved(self):
        package = self.prefix / "lib/python3/dist-packages"
        if not package.exists():
            self.skipTest("built without the Python package")
        script = ("import sys, geneva; result = geneva.run(geneva.read_case(sys.argv[1])); "
                  "print(geneva.__file__, repr(result.contacts[0].peak_pressure))")
        done = subprocess.run([PYTHON, "-B", "-c", script, str(self.case)], capture_output=True, text=True,
                              env={**ENVIRONMENT, "PYTHONPATH": str(package)}, timeout=TIME_LIMIT, check=True)
        place, pressure = done.stdout.split()
        self.assertEqual(place, str(package / "geneva/__init__.py"))
        ((expected, *_),), _ = self.pressures(self.case, ranks=1)
        self.assertEqual(float(pressure), expected)

    def test_motion_needs_no_finite_elements(self):
        text = run(self.room / "build/motion", self.case)
        self.assertRegex(text, "wheel acceleration")
        libraries = run("ldd", self.room / "build/motion")
        self.assertIsNone(re.search("deal|mpi|gmsh|trilinos", libraries), libraries)
        self.assertLess(len(libraries.splitlines()), 25)


if __name__ == "__main__":
    BUILD, SOURCE = map(pathlib.Path, sys.argv[1:3])
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
