"""The Debian packages: what is in them, and that it works where they are unpacked.

    python3 tests/install/check_packages.py BUILD_DIRECTORY
"""

import gzip
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path()
TIME_LIMIT = 300
# Of Debian, for which the package is built.
PYTHON = os.environ.get("GENEVA_PYTHON", "/usr/bin/python3")


def run(*command, environment=None, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=TIME_LIMIT, check=False,
                          env={**os.environ, **(environment or {})}, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


class Packages(unittest.TestCase):
    """Builds the packages and unpacks them into a directory that the build does not know."""

    @classmethod
    def setUpClass(cls):
        cls.room = pathlib.Path(tempfile.mkdtemp(prefix="geneva-packages-"))
        cls.addClassCleanup(shutil.rmtree, cls.room, ignore_errors=True)
        run("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", cls.room, cwd=cls.room)
        cls.version = re.search("CMAKE_PROJECT_VERSION:STATIC=(.*)", (BUILD / "CMakeCache.txt").read_text())[1]
        cls.runtime = "libgeneva" + cls.version.rsplit(".", 1)[0]
        cls.files = {file.name.split("_")[0]: file for file in cls.room.glob("*.deb")}
        cls.root = cls.room / "root"
        for file in cls.files.values():
            run("dpkg-deb", "-x", file, cls.root)
        cls.case = cls.root / "usr/share/geneva/cases/johnson-optimum-wheel"

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.files[package], name).strip()

    def test_there_are_four_packages_that_say_what_they_are(self):
        self.assertEqual(set(self.files), {"geneva", self.runtime, "libgeneva-dev", "python3-geneva"})
        for package in self.files:
            self.assertRegex(self.field(package, "Description").splitlines()[0], "^Contact stress analysis of Geneva mechanisms")
            self.assertGreater(len(self.field(package, "Description").splitlines()), 1)
            self.assertIn("GNU General Public License", (self.root / "usr/share/doc" / package / "copyright").read_text())

    def test_they_depend_on_what_they_need_at_run_time(self):
        wanted = {
            "geneva": (f"{self.runtime} (= {self.version})", "libdeal.ii", "libopenmpi3", "libudunits2", "openmpi-bin",
                       "libopenblas0-pthread"),
            self.runtime: ("libgmsh", "libdeal.ii", "libopenmpi3", "libseccomp2", "libnlopt0", "libudunits2"),
            "libgeneva-dev": (f"{self.runtime} (= {self.version})", "libopenmpi-dev", "nlohmann-json3-dev"),
            "python3-geneva": (f"{self.runtime} (= {self.version})", "python3-numpy", "python3 (>= 3.11)"),
        }
        for package, names in wanted.items():
            depends = self.field(package, "Depends")
            for name in names:
                self.assertIn(name, depends, package)
        self.assertIn("libjs-chart.js", self.field("geneva", "Recommends"))

    def test_what_links_to_the_libraries_finds_out_their_package(self):
        control = run("dpkg-deb", "--info", self.files[self.runtime], "shlibs")
        for library in ("libgeneva", "libgeneva-core"):
            self.assertRegex(control, rf"(?m)^{library} \S+ {self.runtime} ")

    def test_no_file_is_in_two_of_them(self):
        seen = {}
        for package, file in self.files.items():
            for line in run("dpkg-deb", "-c", file).splitlines():
                name = line.split(None, 5)[5]
                if not name.endswith("/"):
                    self.assertNotIn(name, seen)
                    seen[name] = package
        self.assertEqual(seen["./usr/bin/geneva"], "geneva")
        self.assertEqual(seen["./usr/libexec/geneva/geneva-mesher"], self.runtime)

    def test_no_library_is_looked_for_where_they_were_built(self):
        checked = 0
        for file in self.root.rglob("*"):
            if file.is_symlink() or not file.is_file() or file.read_bytes()[:4] != b"\x7fELF":
                continue
            checked += 1
            text = run("readelf", "-d", file)
            for path in re.findall(r"R(?:UN)?PATH.*\[(.*)\]", text):
                self.assertTrue(all(part.startswith("$ORIGIN") for part in path.split(":")), f"{file}: {path}")
        self.assertGreaterEqual(checked, 7)

    def test_the_program_runs_a_case_from_them(self):
        printed = run(self.root / "usr/bin/geneva", "run", self.case, "--output", self.room / "results")
        self.assertRegex(printed, r"peak contact pressure \[psi\] +726[5-9]\d \+-")
        self.assertTrue((self.room / "results/report.html").exists())

    def test_manual_pages_and_completions_are_there(self):
        page = self.root / "usr/share/man/man1/geneva-run.1.gz"
        text = run("man", "--local-file", page) if shutil.which("man") else gzip.decompress(page.read_bytes()).decode()
        self.assertIn("geneva", text)
        self.assertTrue((self.root / "usr/share/bash-completion/completions/geneva").exists())

    def test_python_imports_and_runs_the_package_from_them(self):
        packages = self.root / "usr/lib/python3/dist-packages"
        script = ("import sys, geneva; result = geneva.run(geneva.read_case(sys.argv[1])); "
                  "print(geneva.__file__, result.contacts[0].to('in-lbf').peak_pressure)")
        printed = run(PYTHON, "-B", "-c", script, self.case, environment={"PYTHONPATH": str(packages)})
        place, pressure = printed.split()
        self.assertEqual(place, str(packages / "geneva/__init__.py"))
        self.assertAlmostEqual(float(pressure) / 72675, 1, delta=1e-3, msg="Hertz")

    def test_a_program_is_built_against_them(self):
        build = self.room / "build"
        sources = pathlib.Path(__file__).resolve().parent
        run("cmake", "-S", sources, "-B", build, "-G", "Ninja", "-D", f"CMAKE_PREFIX_PATH={self.root / 'usr'}")
        run("cmake", "--build", build, "--target", "motion")
        self.assertIn("wheel acceleration", run(build / "motion", self.case))


if __name__ == "__main__":
    BUILD = pathlib.Path(sys.argv[1])
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
