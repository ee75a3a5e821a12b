"""The error bar holds, at about the same cost, on coarse meshes of any shape with either side as source."""

import math
import pathlib
import sys

import closed_forms
import geneva_cli
from geneva_cli import CliTest, number, read_csv

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "benchmarks"))
import mesh_choice  # noqa: E402
import random_cases  # noqa: E402
from random_cases import Drawing, draw_half_ball, draw_rectangle, draw_ring, lines_of  # noqa: E402

ACCURACY = 0.005
SILENT = 1e-4  # relative: what Hertz leaves out in the contacts below, (half-width / radius)^2


class CoarseMeshes(CliTest):

    def geometry_case(self, name, drawing, geometry):
        """A case directory from a drawing and the entries of its subsection Geometry."""
        directory = self.directory / name
        directory.mkdir()
        parameters = [("Model", "geometry"), ("Accuracy", str(ACCURACY)), ("Geometry", [("Length unit", "m"), *geometry])]
        (directory / "case.prm").write_text("\n".join(lines_of(parameters)) + "\n")
        (directory / "geometry.geo").write_text(drawing.text())
        return directory

    def assert_within_bar(self, summary, pressure):
        contact = summary["contact"]
        error = abs(number(contact["peak_pressure"]) / pressure - 1)
        self.assertLessEqual(error, contact["peak_pressure_error"] + SILENT)


class Spheres(CoarseMeshes):
    """Two equal half balls of rubber, with a radius of contact of a hundredth of theirs or less."""

    RADIUS, MODULUS, POISSON, FORCE = 2.0, 14062500.0, 0.25, 10.0

    def case(self, name, source, cells):
        drawing = Drawing("m")
        material = [("Young's modulus", f"{self.MODULUS} Pa"), ("Poisson's ratio", self.POISSON)]
        for body, centre in (("upper", self.RADIUS), ("lower", -self.RADIUS)):
            draw_half_ball(drawing, body, centre, self.RADIUS, cells, cells)
        target = {"upper": "lower", "lower": "upper"}[source]
        return self.geometry_case(name, drawing, [
            ("Plane", "axisymmetric"), ("Bodies", "upper, lower"),
            ("Supports", "upper axis: x, lower axis: x, lower flat: y"), ("Loads", "upper flat"),
            ("Contact pairs", f"{source} surface -> {target} surface"), ("Body upper", material),
            ("Body lower", material),
            ("Load upper flat", random_cases.load_parameters("force", f"{self.FORCE} N"))])

    def test_of_few_cells_touch_in_hertz_s_circle_whichever_is_the_source(self):
        hertz = closed_forms.hertz_point(self.FORCE, self.RADIUS / 2,
                                         self.MODULUS / (2 * (1 - self.POISSON**2)), self.POISSON)
        for source in ("upper", "lower"):
            for cells in (3, 4, 5):
                with self.subTest(source, cells=cells):
                    summary = self.run_case(self.case(f"{source}-{cells}", source, cells))
                    self.assert_within_bar(summary, hertz["peak_pressure"])
                    self.assertLess(summary["mesh"]["dofs"], 10000)


class Cylinders(CoarseMeshes):
    """A ring of steel on a block."""

    RADIUS, CORE, MODULUS, POISSON, LOAD = 0.01, 0.5, 2.1e11, 0.3, 2e4  # m, of the radius, Pa, 1, N/m
    MESHES = {"compact": ((8, 4), (16, 8)), "long ring": ((3, 8), (16, 8)), "long block": ((8, 4), (8, 20)),
              "both": ((3, 8), (8, 20))}  # cells along a quarter and layers, of the ring and of the block

    def case(self, name, ring, block, ring_is_source):
        drawing = Drawing("m")
        draw_ring(drawing, "ring", self.RADIUS, self.CORE * self.RADIUS, self.RADIUS, -2.0, *ring)
        draw_rectangle(drawing, "block", -3.3 * self.RADIUS, 3.0 * self.RADIUS, 3.0 * self.RADIUS, *block)
        material = [("Young's modulus", f"{self.MODULUS} Pa"), ("Poisson's ratio", self.POISSON)]
        pair = ("ring outside", "block top") if ring_is_source else ("block top", "ring outside")
        return self.geometry_case(name, drawing, [
            ("Plane", "plane strain"), ("Thickness", "1 m"), ("Bodies", "ring, block"),
            ("Supports", "block bottom: fixed"), ("Loads", "ring inside"), ("Contact pairs", " -> ".join(pair)),
            ("Body ring", material), ("Body block", material),
            ("Load ring inside", random_cases.load_parameters("force per thickness", f"{self.LOAD} N/m"))])

    def test_on_long_cells_cost_at_most_twice_as_much_whichever_is_the_source(self):
        hertz = closed_forms.hertz_line(self.LOAD, self.RADIUS, self.MODULUS / (2 * (1 - self.POISSON**2)))
        unknowns, ripples = {}, {}
        for name, (ring, block) in self.MESHES.items():
            for ring_is_source in (True, False):
                with self.subTest(name, ring_is_source=ring_is_source):
                    case = self.case(f"{name}-{ring_is_source}".replace(" ", "-"), ring, block, ring_is_source)
                    summary = self.run_case(case)
                    self.assert_within_bar(summary, hertz["peak_pressure"])
                    unknowns[case.name] = summary["mesh"]["dofs"]
                    ripples[case.name] = self.ripple(case, hertz["half_width"])
        self.assertLess(max(unknowns.values()), 2 * min(unknowns.values()), unknowns)
        self.assertLess(max(ripples.values()), ACCURACY / 2, ripples)

    def test_on_a_block_of_one_layer_of_cells_have_the_error_that_is_told(self):
        """Cells 28 times as deep as wide."""
        hertz = closed_forms.hertz_line(self.LOAD, self.RADIUS, self.MODULUS / (2 * (1 - self.POISSON**2)))
        summary = self.run_case(self.case("one-layer", (8, 4), (60, 1), True))
        self.assert_within_bar(summary, hertz["peak_pressure"])

    def ripple(self, case, half_width):
        """Root mean square of the pressure's second difference over the nodes in the middle half of the contact, less
        that of Hertz's pressure, as a share of the peak."""
        table = read_csv(case / "results" / "contact.csv")
        nodes = sorted(zip(table["x [m]"], table["contact_pressure [Pa]"]))
        peak = max(pressure for _, pressure in nodes)
        found = []
        for (left, a), (middle, b), (right, c) in zip(nodes, nodes[1:], nodes[2:]):
            if max(abs(left), abs(right)) < half_width / 2:
                share = (middle - left) / (right - left)
                hertz = [math.sqrt(1 - (x / half_width)**2) for x in (left, middle, right)]
                found.append((b - (1 - share) * a - share * c) / peak -
                             (hertz[1] - (1 - share) * hertz[0] - share * hertz[2]))
        self.assertGreater(len(found), 4)
        return math.sqrt(sum(value**2 for value in found) / len(found))


class MeshChoice(CoarseMeshes):
    """A line contact on three coarse meshes that are drawn at random."""

    def runs(self, index):
        """Name, summary and nodal pressures' noise of each."""
        variations = mesh_choice.variations(random_cases.draw_case("plane", index), ACCURACY)
        for name, files in list(variations)[:len(mesh_choice.MESHES)]:
            with self.subTest(name):
                directory = self.directory / name.replace(" ", "-").replace(",", "")
                directory.mkdir()
                for file, text in files.items():
                    (directory / file).write_text(text)
                summary = self.run_case(directory)
                yield name, summary, mesh_choice.pressure_noise((directory / "results" / "contact.csv").read_text())

    def test_costs_at_most_twice_as_much_where_a_point_becomes_23_nodes_on_the_next_mesh(self):
        """The cells around are then too large."""
        unknowns = {name: summary["mesh"]["dofs"] for name, summary, _ in self.runs(44)}
        self.assertLess(max(unknowns.values()), 2 * min(unknowns.values()), unknowns)

    def test_makes_the_same_noise_where_the_target_s_edges_could_be_two_thirds_of_the_source_s(self):
        noise = {name: max(value, ACCURACY / 10) for name, _, value in self.runs(4)}
        self.assertLess(max(noise.values()), 2 * min(noise.values()), noise)


if __name__ == "__main__":
    geneva_cli.main()
