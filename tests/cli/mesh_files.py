"""Meshes of two bodies as Gmsh's .msh files, format 2.2, written without Gmsh.

They are those of the cases flat-patch and hertz-line-contact; lengths in millimetres.
"""

import math

LINE, QUADRILATERAL, LINE_OF_ORDER_2, QUADRILATERAL_OF_ORDER_2 = 1, 3, 8, 16


class MeshFile:
    """Vertices, cells and named boundary edges, put together from patches of rows and columns."""

    def __init__(self):
        self.vertices = []
        self.cells = []
        self.edges = []
        self._bodies = []
        self._surfaces = []
        self._found = {}

    def vertex(self, body, place):
        """Index of a body's vertex; the same for the same place, but never shared by two bodies."""
        key = (body, round(place[0], 9), round(place[1], 9))
        if key not in self._found:
            self._found[key] = len(self.vertices)
            self.vertices.append(place)
        return self._found[key]

    def add_patch(self, body, place, columns, rows, surfaces):
        """Adds columns x rows cells; place(i, j) gives the vertices.

        Surfaces: names of the sides by "bottom" (j = 0), "right", "top" and "left".
        """
        grid = [[self.vertex(body, place(i, j)) for j in range(rows + 1)] for i in range(columns + 1)]
        for i in range(columns):
            for j in range(rows):
                self.cells.append((self._tag(self._bodies, body),
                                   (grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1])))
        sides = {"bottom": [column[0] for column in grid], "right": grid[-1],
                 "top": [column[-1] for column in grid], "left": grid[0]}
        for side, name in surfaces.items():
            for ends in zip(sides[side], sides[side][1:]):
                self.edges.append((self._tag(self._surfaces, name), ends))

    @staticmethod
    def _tag(names, name):
        if name not in names:
            names.append(name)
        return names.index(name) + 1

    def text(self, scale=1.0, order=1, named=True):
        """The file; coordinates times scale, cells of order 1 or 2, groups with or without names."""
        vertices = list(self.vertices)
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(vertices)
                vertices.append(tuple((p + q) / 2 for p, q in zip(self.vertices[a], self.vertices[b])))
            return middles[key]

        elements = []
        for kind, groups in ((LINE, self.edges), (QUADRILATERAL, self.cells)):
            for tag, corners in groups:
                sides = [corners] if kind == LINE else zip(corners, corners[1:] + corners[:1])
                nodes = [*corners, *(middle(*side) for side in sides)] if order == 2 else corners
                second = {LINE: LINE_OF_ORDER_2, QUADRILATERAL: QUADRILATERAL_OF_ORDER_2}
                elements.append((second[kind] if order == 2 else kind, tag, nodes))
        names = [(1, tag + 1, name) for tag, name in enumerate(self._surfaces)]
        names += [(2, tag + 1, name) for tag, name in enumerate(self._bodies)]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat"]
        if named:
            lines += ["$PhysicalNames", str(len(names))]
            lines += [f'{dimension} {tag} "{name}"' for dimension, tag, name in names]
            lines += ["$EndPhysicalNames"]
        lines += ["$Nodes", str(len(vertices))]
        lines += [f"{index} {scale * x:.17g} {scale * y:.17g} 0" for index, (x, y) in enumerate(vertices, 1)]
        lines += ["$EndNodes", "$Elements", str(len(elements))]
        lines += [f"{index} {kind} 2 {tag} {tag} {' '.join(str(node + 1) for node in nodes)}"
                  for index, (kind, tag, nodes) in enumerate(elements, 1)]
        return "\n".join([*lines, "$EndElements", ""])


def two_blocks():
    """The bodies of flat-patch."""
    mesh = MeshFile()
    width, height = 40.0, 20.0
    mesh.add_patch("upper", lambda i, j: (width * i / 7, height * j / 3), 7, 3,
                   {"bottom": "upper face", "top": "upper top", "left": "upper side"})
    mesh.add_patch("lower", lambda i, j: (width * i / 9, height * (j / 4 - 1)), 9, 4,
                   {"bottom": "lower bottom", "top": "lower face", "left": "lower side"})
    return mesh


def cylinder_on_block():
    """The bodies of hertz-line-contact: the cylinder's core is a hole round which the cells lie."""
    mesh = MeshFile()
    radius, core, width = 10.0, 5.0, 40.0
    arc = 6
    layers = 2

    def ring(quarter):
        def place(i, j):
            angle = math.pi / 2 * (quarter + i / arc - 1)
            at = core + (radius - core) * j / layers
            return (at * math.cos(angle) if (quarter, i) not in ((0, 0), (1, arc), (2, 0), (3, arc)) else 0.0,
                    radius + at * math.sin(angle))
        return place

    for quarter in range(4):
        mesh.add_patch("cylinder", ring(quarter), arc, layers, {"bottom": "cylinder core", "top": "cylinder surface"})
    mesh.add_patch("block", lambda i, j: (width * (i / 8 - 1), width * (j / 8 - 1)), 16, 8,
                   {"bottom": "block bottom", "top": "block top"})
    return mesh
