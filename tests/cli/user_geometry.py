"""Geometries of the user's: the examples of doc/case-file.md and doc/how-to-geometry.md as they stand there, and nearly round meshes."""

import random
import re

import geneva_cli
import mesh_files
from geneva_cli import CliTest, change_case, number


def blocks_of(markdown):
    """The indented blocks of a page, without their indentation."""
    blocks = [[]]
    for line in markdown.splitlines():
        if line.startswith("    "):
            blocks[-1].append(line[4:])
        elif line and blocks[-1]:
            blocks.append([])
        elif blocks[-1]:
            blocks[-1].append("")
    return ["\n".join(block).strip() + "\n" for block in blocks if block]


class DocumentedExamples(CliTest):

    def write_examples(self):
        """Case directories of the geometry cases on the page, in their order."""
        blocks = blocks_of((self.source / "doc" / "case-file.md").read_text())
        cases = []
        for index, block in enumerate(blocks):
            if not re.search(r"^set Model += geometry", block, re.MULTILINE):
                continue
            case = self.directory / f"example-{len(cases)}"
            case.mkdir()
            (case / "case.prm").write_text(block)
            (case / "geometry.geo").write_text(blocks[index + 1])
            cases.append(case)
        return cases

    def test_run_as_they_stand_on_the_page(self):
        cases = self.write_examples()
        self.assertEqual(len(cases), 2, "in the plane and in 3-D")
        for case, tolerance in zip(cases, (0.005, 0.05)):
            with self.subTest(case.name):
                summary = self.run_case(case)
                peak, hertz = (number(summary[key]["peak_pressure"]) for key in ("contact", "hertz"))
                self.assert_close(hertz, 560.8e6, 1e-3, "Hertz")
                self.assert_close(peak, hertz, tolerance, "peak pressure")

    def test_the_how_to_gives_the_figures_that_it_prints(self):
        page = (self.source / "doc" / "how-to-geometry.md").read_text()
        blocks = blocks_of(page)
        case = self.directory / "notch"
        case.mkdir()
        (case / "geometry.geo").write_text(next(block for block in blocks if "Physical Surface" in block))
        (case / "case.prm").write_text(next(block for block in blocks if block.startswith("set Title")))
        summary = self.run_case(case)
        for name, value, unit in (("peak contact pressure [MPa]", summary["contact"]["peak_pressure"], 1e6),
                                  ("contact force [N]", summary["contact"]["force"], 1)):
            printed = float(re.search(rf"{re.escape(name)} +([\d.]+) \+-", page).group(1))
            self.assert_close(number(value), printed * unit, 5e-3, name)  # the default accuracy

    def test_touching_lines_of_unlike_division_are_refused_in_gmsh_s_words(self):
        case = self.write_examples()[1]
        geometry = (case / "geometry.geo").read_text()
        self.assertIn("Surface{101}; Layers{4}", geometry)
        (case / "geometry.geo").write_text(geometry.replace("Surface{101}; Layers{4}", "Surface{101}; Layers{5}"))
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("geometry.geo", run.err)


class NearlyRoundMeshes(CliTest):
    """The cylinder of hertz-line-contact as a mesh file whose nodes miss their circle by a little."""

    OFF = 2e-5  # of the radius

    def write_case(self, name, off):
        mesh = mesh_files.cylinder_on_block()
        chance = random.Random(7)
        radius = 10.0
        for index, (x, y) in enumerate(mesh.vertices):
            distance = ((x**2 + (y - radius)**2)**0.5)
            if abs(distance - radius) < 1e-9 and (x, y) != (0.0, 0.0):
                stretch = 1 + chance.uniform(-off, off)
                mesh.vertices[index] = (stretch * x, radius + stretch * (y - radius))
        case = self.copy_case("hertz-line-contact", name)
        (case / "geometry.geo").unlink()
        (case / "geometry.msh").write_text(mesh.text())
        return case

    def test_a_polygon_is_named_with_its_kinks(self):
        case = self.write_case("polygon", self.OFF)
        change_case(case, {"Maximum refinement levels": "3"})
        run = self.geneva("run", case)
        self.assertIn("note: contact surface 'cylinder surface' is a polygon", run.out)
        # 24 edges a turn
        kink = float(re.search(r"meet at up to ([\d.]+) deg", run.out).group(1))
        self.assertAlmostEqual(kink, 15, delta=0.1)
        self.assertNotIn("'block top' is a polygon", run.out)
        notices = geneva_cli.read_summary(case / "results")["notices"]
        self.assertTrue(any("is a polygon" in notice for notice in notices))

    def test_a_circle_has_no_notice(self):
        summary = self.run_case(self.write_case("circle", 0.0))
        self.assertEqual([notice for notice in summary["notices"] if "polygon" in notice], [])

    def test_the_circle_tolerance_makes_a_circle_of_it(self):
        exact = self.run_case(self.write_case("exact", 0.0))
        case = self.write_case("fitted", self.OFF)
        change_case(case, {"Geometry/Circle tolerance": "0.01 %"})
        fitted = self.run_case(case)
        self.assertEqual([notice for notice in fitted["notices"] if "polygon" in notice], [])
        # the fitted radius is off by OFF at most, and so is half of that the pressure
        for key in ("contact", "hertz"):
            self.assert_close(number(fitted[key]["peak_pressure"]), number(exact[key]["peak_pressure"]),
                              3e-3 if key == "contact" else self.OFF, key)

    def test_a_smaller_tolerance_leaves_the_polygon(self):
        case = self.write_case("too-small", self.OFF)
        change_case(case, {"Geometry/Circle tolerance": "1e-6", "Maximum refinement levels": "2"})
        self.assertIn("is a polygon", self.geneva("run", case).out)

    def test_a_tolerance_out_of_range_is_refused(self):
        case = self.write_case("too-great", 0.0)
        change_case(case, {"Geometry/Circle tolerance": "2 %"})
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("'Circle tolerance'", run.err)
        self.assertIn("from 0 to 1 %", run.err)


if __name__ == "__main__":
    geneva_cli.main()
