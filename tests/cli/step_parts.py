"""Parts of a CAD system: what `geneva surfaces` lists of a STEP file, and what is refused of it."""

import math
import re

import geneva_cli
from geneva_cli import CliTest, change_case, number

SPHERE = "hertz-sphere-step"
MINIMAL = """set Model        = geometry
set Dimension    = {dimension}
set Output units = mm-N
subsection Geometry
  set File = parts.step
{lines}end
"""

# Half a disc of radius 10 mm on half a block, both steel, as plane faces.
PLANE = """  set Thickness     = 1 mm
  set Bodies        = disc, block
  set Solid disc    = face nearest 3 mm, 6 mm
  set Solid block   = face nearest 3 mm, -6 mm
  set Surface arc   = edge nearest 7 mm, 3 mm
  set Surface cut   = edge nearest 5 mm, 10 mm
  set Surface top   = edge nearest 7 mm, 0
  set Surface back  = edge nearest 7 mm, -15 mm
  set Surface axis  = edge nearest 0, 5 mm
  set Surface plane = edge nearest 0, -5 mm
  set Supports      = back: fixed, axis: x, plane: x
  set Loads         = cut
  set Contact pairs = arc -> top
  subsection Load cut
    set Type      = force
    set Value     = 100 N
    set Direction = 0, -1
  end
"""


class StepParts(CliTest):

    def surfaces(self, case):
        run = self.geneva("surfaces", case)
        self.assertEqual(run.code, 0, run.describe())
        return run.out

    def minimal(self, name, file, lines="", dimension=3):
        """A case that says no more than its file."""
        case = self.directory / name
        case.mkdir()
        (case / "case.prm").write_text(MINIMAL.format(dimension=dimension, lines=lines))
        (case / "parts.step").write_bytes(file if isinstance(file, bytes) else file.read_bytes())
        return case

    def parts(self):
        return self.source / "cases" / SPHERE / "parts.step"

    def refusal(self, case, command="run"):
        run = self.geneva(command, case)
        self.assertEqual(run.code, 1, run.describe())
        for sign in geneva_cli.CRASH_SIGNS:
            self.assertNotIn(sign, run.err)
        return run.err

    def test_bodies_and_faces_are_listed_with_their_shapes_before_the_case_names_any(self):
        out = self.surfaces(self.minimal("new", self.parts()))
        self.assertIn("body block", out)
        self.assertIn("body sphere", out)
        self.assertEqual(len(re.findall(r"block face \d", out)), 6)
        self.assertEqual(out.count("sphere of radius 10 mm"), 1)
        self.assertEqual(out.count("sphere of radius 5 mm"), 1)
        self.assertEqual(out.count("plane"), 9)

    def test_a_file_is_listed_without_a_case(self):
        file = self.directory / "mine.step"
        file.write_bytes(self.parts().read_bytes())
        in_case = self.surfaces(self.minimal("new", self.parts()))
        alone = self.surfaces(file)
        self.assertEqual(alone.splitlines()[1:-1], in_case.splitlines()[1:-1])
        self.assertIn("<h1>Surfaces of mine.step</h1>", (self.directory / "surfaces.html").read_text())
        self.assertIn("there is no", self.refusal(self.directory / "other.step", "surfaces"))

    def test_a_support_that_is_missing_on_a_cut_is_named(self):
        case = self.copy_case(SPHERE)
        change_case(case, {"Geometry/Supports": "bottom: fixed, sphere x: x, sphere z: z", "Accuracy": "20 %"})
        summary = self.run_case(case)
        (notice, ) = [notice for notice in summary["notices"] if "plane of symmetry" in notice]
        self.assertIn("the surface of the contact 'ball -> top' ends along x amid the pressure", notice)

    def test_the_picture_shows_every_surface(self):
        case = self.minimal("new", self.parts())
        out = self.surfaces(case)
        page = (case / "surfaces.html").read_text()
        for name in re.findall(r"(?m)^  (\S.*?\d)\s{2,}", out):
            self.assertIn(f"<title>{name}</title>", page)
            self.assertIn(f"<td>{name}</td>", page)
        self.assertEqual(page.count("<svg "), 2)
        self.assertIsNone(re.search(r"\bnan\b", page))

    def test_places_that_are_listed_pick_their_faces(self):
        case = self.minimal("new", self.parts())
        listed = dict(re.findall(r"^  (\S.*?\d)\s{2,}.*nearest (.*)$", self.surfaces(case), re.M))
        lines = "".join(f"  set Surface my {name} = face nearest {place}\n" for name, place in listed.items())
        out = self.surfaces(self.minimal("named", self.parts(), lines))
        for name, place in listed.items():
            (line,) = [line for line in out.splitlines() if line.startswith(f"  my {name} ")]
            self.assertIn(place, line)

    def test_exported_parts_keep_their_names_and_sizes_in_every_unit(self):
        drawings = self.directory / "drawings"
        run = self.geneva("export", self.source / "cases" / "johnson-optimum-wheel", "-o", drawings)
        self.assertEqual(run.code, 0, run.describe())
        out = self.surfaces(self.minimal("wheel", drawings / "wheel.step"))
        for name in ("driving wall", "opposite wall", "locking arcs", "slots", "bore", "rim", "top", "bottom"):
            self.assertRegex(out, rf"(?m)^  {name} ")
        bore = float(re.search(r"bore\s+cylinder of radius (\S+) mm", out).group(1))
        drawn = re.search(r"CIRCLE.*?\n 40\n(\S+)", (drawings / "wheel.dxf").read_text(), re.S)
        self.assert_close(bore, 25.4 * float(drawn.group(1)), 1e-5, "radius of the bore")
        out = self.surfaces(self.minimal("assembly", drawings / "assembly.step"))
        for body in ("wheel", "driver", "pin"):
            self.assertIn(f"body {body}\n", out)
        for name in ("wheel top", "driver top", "pin top"):
            self.assertRegex(out, rf"(?m)^  {name} ")

    def test_plane_faces_have_hertz_s_pressure_within_their_error(self):
        file = self.source / "tests" / "cli" / "parts" / "half_disc_on_block.step"
        case = self.minimal("plane", file, PLANE, dimension=2)
        self.assertIn("arc", self.surfaces(case))
        summary = self.run_case(case)
        modulus = 207e9 / (2 * (1 - 0.3**2))  # steel, the default
        hertz = math.sqrt(200 / 1e-3 * modulus / (math.pi * 10e-3))
        self.assert_close(number(summary["contact"]["peak_pressure"]), hertz,
                          summary["contact"]["peak_pressure_error"] + 5e-4, "peak pressure")  # 5e-4: the disc's finite size

    def test_what_is_no_step_file_is_refused(self):
        whole = self.parts().read_bytes()
        self.assertIn("no STEP file", self.refusal(self.minimal("text", b"solid part\n"), "surfaces"))
        self.assertIn("cut short", self.refusal(self.minimal("short", whole[:len(whole) // 2]), "surfaces"))
        empty = whole[:whole.index(b"DATA;") + 5] + b"\nENDSEC;\nEND-ISO-10303-21;\n"
        self.assertIn("parts.step", self.refusal(self.minimal("empty", empty), "surfaces"))
        self.assertIn("no plane face outside of solids",
                      self.refusal(self.minimal("plane", self.parts(), dimension=2), "surfaces"))

    def test_places_that_pick_nothing_or_two_are_refused(self):
        for line, words in (("  set Surface wall = face nearest 100 mm, 0, 0\n", ["no face is near", "geneva surfaces"]),
                            ("  set Surface wall = face nearest 0, 0, 0\n", ["equally near", "'wall'"]),
                            ("  set Surface wall = face nearest 1 mm, 2 mm\n", ["2 numbers in place of 3"]),
                            ("  set Surface wall = face nearest 1 mm, 2 s, 0\n", ["'2 s' is no length"]),
                            ("  set Surface wall = 1 mm, 2 mm, 3 mm\n", ["face nearest 12 mm, 0, 3 mm"]),
                            ("  set Length unit = mm\n", ["STEP file has its own unit"])):
            name = f"case-{len(list(self.directory.iterdir()))}"
            err = self.refusal(self.minimal(name, self.parts(), line), "surfaces")
            for word in words:
                self.assertIn(word, err)

    def test_names_that_the_file_does_not_have_are_refused_with_those_it_has(self):
        case = self.copy_case(SPHERE)
        text = (case / "case.prm").read_text()
        (case / "case.prm").write_text(text.replace("sphere, block", "ball, block").replace("Body sphere", "Body ball"))
        err = self.refusal(case)
        self.assertIn("'ball'", err)
        self.assertIn("'sphere'", err)
        (case / "case.prm").write_text(text.replace("Loads         = core", "Loads         = kernel")
                                       .replace("Load core", "Load kernel"))
        self.assertIn("kernel", self.refusal(case))

    def test_cell_size_belongs_to_step_files(self):
        case = self.copy_case("hertz-sphere-3d")
        change_case(case, {"Geometry/Cell size": "1 mm"})
        self.assertIn("STEP file only", self.refusal(case))
        case = self.copy_case(SPHERE)
        coarse = self.surfaces(case)
        change_case(case, {"Geometry/Cell size": "0.8 mm"})
        self.assertNotEqual(self.surfaces(case), coarse)


if __name__ == "__main__":
    geneva_cli.main()
