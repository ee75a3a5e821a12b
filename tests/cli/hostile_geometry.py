"""A geometry that makes Gmsh crash, run on or want all memory is an error of the case, and nothing else."""

import tempfile

import geneva_cli
from geneva_cli import CRASH_SIGNS, CliTest

BLOCK = """
Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Point(5) = {0, 1, 0}; Point(6) = {1, 1, 0}; Point(7) = {1, 2, 0}; Point(8) = {0, 2, 0};
For i In {0:1}
  For j In {1:4}
    Line(4*i+j) = {4*i+j, 4*i+(j % 4)+1};
  EndFor
  Curve Loop(i+1) = {4*i+1:4*i+4}; Plane Surface(i+1) = {i+1};
EndFor
Mesh.MeshSizeMax = 0.3;
Physical Surface("lower", 1) = {1}; Physical Surface("upper", 2) = {2};
Physical Curve("bottom", 3) = {1}; Physical Curve("lower face", 4) = {3};
Physical Curve("upper face", 5) = {5}; Physical Curve("top", 6) = {7};
Physical Curve("sides", 7) = {4, 8};
"""

CASE = """
set Model = geometry
set Maximum time = {seconds} s
set Maximum memory = {memory}
subsection Geometry
  set File = {file}
  set Length unit = mm
  set Plane = plane strain
  set Thickness = 10 mm
  set Bodies = lower, upper
  set Supports = bottom: fixed, sides: x
  set Loads = top
  set Contact pairs = upper face -> lower face
  subsection Load top
    set Type = force
    set Value = 10 N
    set Direction = 0, -1
  end
end
"""


class HostileGeometry(CliTest):

    def run_geometry(self, geo, seconds=4, memory="2 GB", name="geometry.geo"):
        case = self.directory / f"case-{len(list(self.directory.iterdir()))}"
        case.mkdir()
        (case / "case.prm").write_text(CASE.format(seconds=seconds, memory=memory, file=name))
        (case / name).write_text(geo + "\n")
        return case, self.geneva("run", case, time_limit=60)

    def assert_refused(self, run, case, codes):
        text = run.describe()
        self.assertIn(run.code, codes, text)
        self.assertIn("geometry.geo", run.err, text)
        for sign in CRASH_SIGNS:
            self.assertNotIn(sign, run.err.replace("Segmentation fault)", ""), text)
        self.assertNotIn(tempfile.gettempdir(), run.err.replace(str(case), ""), text)
        self.assertLessEqual(len(run.err.strip().splitlines()), 3, text)
        self.assertFalse((case / "results").exists(), text)

    def test_the_block_itself_is_solved(self):
        case, run = self.run_geometry(BLOCK, seconds=60)
        self.assertEqual(run.code, 0, run.describe())
        self.assertNotIn("shut Gmsh in", run.out + run.err)

    def test_that_writes_beside_its_lists_is_refused(self):
        for line in ("x[] = {1}; x[-100000000] = 1;", "x[] = {1}; x[{-100000000}] = 1;",
                     "x[] = {1}; x[-100000000] += 1;", "x[] = {1}; x[-100000000]++;", "x[] = {1}; x[-1] = 1;",
                     "x[] = {1}; y = x[-100000000];"):
            with self.subTest(line):
                case, run = self.run_geometry(line + "\n" + BLOCK)
                if run.code != 0:  # a small list may survive what is done to it
                    self.assert_refused(run, case, (1, 2))

    def test_that_never_ends_is_ended(self):
        for line in ("Field[1] = Octree; Field[1].InField = 1; Background Field = 1;",
                     "Mesh.Smoothing = 2000000000;", "Transfinite Curve {:} = 5000;",
                     "Mesh 2;" + 20 * "RefineMesh;", "Point(102) = {1, 0, 1e300}; Line(102) = {1, 102};"):
            with self.subTest(line):
                case, run = self.run_geometry(BLOCK + line)
                self.assert_refused(run, case, (1, 2))

    def test_that_wants_all_memory_is_refused(self):
        for line in ("x[] = {1:1e10};", "Transfinite Curve {:} = 1e9;", "Mesh.ElementOrder = 1e9;"):
            with self.subTest(line):
                case, run = self.run_geometry(BLOCK + line, seconds=20)
                self.assert_refused(run, case, (1, 2))

    def test_drawn_wheels_beyond_all_measure_are_solved_or_refused(self):
        for name, value, code in (("Bore radius", "1 nm", 1), ("Pin diameter", "0.1 mm", 0)):
            with self.subTest(name):
                case = self.copy_case("johnson-optimum-wheel", name.split()[0].lower())
                text = (case / "case.prm").read_text()
                text = geneva_cli.set_parameter(text, "Mechanism/Wheel diameter", "120 mm")
                (case / "case.prm").write_text(geneva_cli.set_parameter(text, f"Mechanism/{name}", value))
                run = self.geneva("run", case, time_limit=60)
                self.assertEqual(run.code, code, run.describe())
                if code:
                    self.assertRegex(run.err, r"case\.prm.*bore radius is 1e-06 mm")

    def test_limits_end_with_exit_code_2_and_name_the_parameter(self):
        case, run = self.run_geometry(BLOCK + "Mesh.Smoothing = 2000000000;", seconds=2)
        self.assertEqual(run.code, 2, run.describe())
        self.assertIn("'Maximum time'", run.err)


if __name__ == "__main__":
    geneva_cli.main()
