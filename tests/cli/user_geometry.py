"""Geometries of the user's: the examples of doc/case-file.md as they stand there."""

import re

import geneva_cli
from geneva_cli import CliTest, number


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
        self.assertEqual(len(cases), 2, "in the plane and in space")
        for case, tolerance in zip(cases, (0.005, 0.05)):
            with self.subTest(case.name):
                summary = self.run_case(case)
                peak, hertz = (number(summary[key]["peak_pressure"]) for key in ("contact", "hertz"))
                self.assert_close(hertz, 560.8e6, 1e-3, "Hertz")
                self.assert_close(peak, hertz, tolerance, "peak pressure")

    def test_touching_lines_of_unlike_division_are_refused_in_gmsh_s_words(self):
        case = self.write_examples()[1]
        geometry = (case / "geometry.geo").read_text()
        self.assertIn("Surface{101}; Layers{4}", geometry)
        (case / "geometry.geo").write_text(geometry.replace("Surface{101}; Layers{4}", "Surface{101}; Layers{5}"))
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("geometry.geo", run.err)


if __name__ == "__main__":
    geneva_cli.main()
