"""Random cases for error_bar.py: case i of a series is always the same, and nobody has tuned anything on it.

    draw_case("plane", 17).files(0.005)    # {"case.prm": ..., "geometry.geo": ...}

SI units. Loads are chosen by Hertz's formulas so that the contact is as wide as drawn; how wide it comes out is the
program's matter. Only random() is asked of the generator of random numbers, the rest is made of it here: that alone
gives the same numbers in every version of Python.
"""

import dataclasses
import math
import pathlib
import random
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
import closed_forms  # noqa: E402
from closed_forms import INCH, POUND_FORCE, PSI, relative_radius  # noqa: E402

RPM = closed_forms.RPM
UNITS = {"length": {"m": 1.0, "mm": 1e-3, "um": 1e-6, "in": INCH},
         "stress": {"Pa": 1.0, "MPa": 1e6, "GPa": 1e9, "psi": PSI},
         "force": {"N": 1.0, "kN": 1e3, "lbf": POUND_FORCE},
         "force per length": {"N/m": 1.0, "kN/m": 1e3, "N/mm": 1e3, "lbf/in": POUND_FORCE / INCH},
         "moment": {"N.m": 1.0, "lbf.in": POUND_FORCE * INCH},
         "inertia": {"kg.m^2": 1.0, "kg.mm^2": 1e-6, "lbf.s^2.in": POUND_FORCE * INCH},
         "density": {"kg/m^3": 1.0, "g/cm^3": 1e3},
         "speed": {"rpm": RPM, "rad/s": 1.0},
         "angle": {"deg": math.pi / 180, "rad": 1.0}}

# Johnson 1956, Table 1: k2 for 3 to 10 stations.
JOHNSON_PIN = (0.16, 0.15, 0.14, 0.14, 0.14, 0.13, 0.12, 0.10)

# Kinds by the index of a case. The lengths are odd, so that odd and even indices see all kinds alike.
SERIES = {"plane": ("line", "external", "line", "sphere", "line", "local", "line", "punch", "line", "internal", "line",
                    "sphere", "line", "external", "line"),
          "space": ("crowned", "crossed", "tilted", "crossed", "bent")}


@dataclasses.dataclass
class Hertz:
    """What the closed form needs beside the computed force."""
    shape: str  # "line" or "point"
    radius: float  # relative, 1/R = 1/R1 + 1/R2
    modulus: float  # E*
    thickness: float = 1.0  # of a line contact
    smallest: float = 0.0  # length of the bodies beside which the contact has to be small

    def pressure(self, force):
        """Hertz's peak pressure, and the contact's half-width over the bodies' smallest length."""
        if self.shape == "line":
            found = closed_forms.hertz_line(force / self.thickness, self.radius, self.modulus)
        else:
            found = closed_forms.hertz_point(force, self.radius, self.modulus, 0.3)  # p0 and a do not depend on nu
        return found["peak_pressure"], found["half_width"] / self.smallest


@dataclasses.dataclass
class Case:
    """A case without its accuracy and limits."""
    name: str
    kind: str
    parameters: list  # of case.prm: (name, value), or (subsection, [parameters])
    geometry: str = ""
    hertz: Hertz | None = None

    def files(self, accuracy, limits=()):
        """The files of the case directory by name; `limits` are further parameters."""
        head = [("Title", f"{self.name}: {self.kind}"), ("Accuracy", f"{100 * accuracy:.6g} %"), *limits]
        files = {"case.prm": "\n".join(lines_of([*head, *self.parameters])) + "\n"}
        if self.geometry:
            files["geometry.geo"] = self.geometry
        return files


def lines_of(parameters):
    """Lines of case.prm."""
    lines = []
    for name, value in parameters:
        if isinstance(value, list):
            lines += [f"subsection {name}", *("  " + line for line in lines_of(value)), "end"]
        else:
            lines.append(f"set {name} = {value}")
    return lines


def draw_case(series, index):
    """Case `index` of a series, "plane" or "space"."""
    kinds = SERIES[series]
    kind = kinds[index % len(kinds)]
    name = f"{series}-{index}"
    draw = Draw(f"geneva error bar {name}")
    parameters, geometry, hertz = DRAWERS[kind](draw)
    units = ("Output units", draw.pick(("SI", "mm-N", "in-lbf")))
    return Case(name, kind, [units, *parameters], geometry, hertz)


class Draw:
    """Draws from a seed."""

    def __init__(self, seed):
        self._random = random.Random(seed).random

    def between(self, low, high):
        return low + (high - low) * self._random()

    def by_factor(self, low, high):
        """Evenly in the logarithm."""
        return low * (high / low)**self._random()

    def whole(self, low, high):
        """A whole number, both ends included."""
        return low + int((high - low + 1) * self._random())

    def pick(self, options):
        return options[int(len(options) * self._random())]

    def chance(self, share):
        return self._random() < share

    def quantity(self, value, dimension):
        """The value with a unit by chance."""
        unit = self.pick(tuple(UNITS[dimension]))
        return f"{value / UNITS[dimension][unit]!r} {unit}"


# Materials


@dataclasses.dataclass
class Material:
    modulus: float
    poissons_ratio: float

    def compliance(self, is_plane_stress=False):
        return (1 if is_plane_stress else 1 - self.poissons_ratio**2) / self.modulus


def draw_materials(draw):
    """Two materials: moduli in the ratio 0.01 to 100, Poisson's ratios from 0 to 0.49."""
    modulus = draw.by_factor(1e9, 4e11)
    return (Material(modulus, draw.between(0.0, 0.49)),
            Material(modulus * draw.by_factor(0.01, 100.0), draw.between(0.0, 0.49)))


def material_parameters(draw, material):
    return [("Young's modulus", draw.quantity(material.modulus, "stress")),
            ("Poisson's ratio", repr(material.poissons_ratio))]


def contact_modulus(materials, is_plane_stress=False):
    return 1 / sum(material.compliance(is_plane_stress) for material in materials)


# Drawings: what a geometry.geo says, with all its numbers written out


class Drawing:
    """The text of a geometry.geo in a unit of length."""

    def __init__(self, unit):
        self._scale = UNITS["length"][unit]
        self._count = 0
        self._lines = []

    def text(self):
        return "\n".join(self._lines) + "\n"

    def point(self, x, y):
        return self._add("Point", f"{x / self._scale!r}, {y / self._scale!r}, 0")

    def line(self, first, last):
        return self._add("Line", f"{first}, {last}")

    def arc(self, first, centre, last):
        return self._add("Circle", f"{first}, {centre}, {last}")

    def surface(self, curves):
        """A surface with four sides, each a curve's number, negative if it is run backwards."""
        loop = self._add("Curve Loop", ", ".join(map(str, curves)))
        return self._add("Plane Surface", str(loop))

    def cells(self, curves, count):
        self._lines.append(f"Transfinite Curve {{{', '.join(map(str, curves))}}} = {count} + 1;")

    def body(self, name, surfaces):
        numbers = ", ".join(map(str, surfaces))
        self._lines += [f"Transfinite Surface {{{numbers}}};", f"Recombine Surface {{{numbers}}};",
                        f'Physical Surface("{name}") = {{{numbers}}};']

    def face(self, name, curves):
        self._lines.append(f'Physical Curve("{name}") = {{{", ".join(map(str, curves))}}};')

    def _add(self, word, content):
        self._count += 1
        self._lines.append(f"{word}({self._count}) = {{{content}}};")
        return self._count


def draw_ring(drawing, name, centre, inner, outer, turn, cells, layers):
    """A ring about (0, centre) in four quarters, the first one beginning at the angle `turn`; see draw_sector."""
    middle = drawing.point(0.0, centre)

    def corner(radius, quarter):
        angle = turn + quarter * math.pi / 2
        return drawing.point(radius * math.cos(angle), centre + radius * math.sin(angle))

    inside, outside = ([corner(radius, quarter) for quarter in range(4)] for radius in (inner, outer))
    spokes = [drawing.line(*ends) for ends in zip(inside, outside)]
    arcs = [[drawing.arc(ring[i], middle, ring[(i + 1) % 4]) for i in range(4)] for ring in (inside, outside)]
    surfaces = [drawing.surface((spokes[i], arcs[1][i], -spokes[(i + 1) % 4], -arcs[0][i])) for i in range(4)]
    drawing.cells(arcs[0] + arcs[1], cells)
    drawing.cells(spokes, layers)
    drawing.body(name, surfaces)
    drawing.face(f"{name} inside", arcs[0])
    drawing.face(f"{name} outside", arcs[1])


def draw_rectangle(drawing, name, left, right, depth, columns, layers):
    """A block under y = 0."""
    corners = [drawing.point(*place) for place in ((left, -depth), (right, -depth), (right, 0.0), (left, 0.0))]
    sides = [drawing.line(corners[i], corners[(i + 1) % 4]) for i in range(4)]
    surface = drawing.surface(sides)
    drawing.cells(sides[0::2], columns)
    drawing.cells(sides[1::2], layers)
    drawing.body(name, [surface])
    for which, side in zip(("bottom", "right", "top", "left"), sides):
        drawing.face(f"{name} {which}", [side])


def draw_sector(drawing, name, centre, inner, outer, angle, cells, layers):
    """Half of a ring's section on the axis x = 0: between two radii about (0, centre), from the axis nearest to y = 0
    round to an angle."""
    side = math.copysign(1.0, centre)
    middle = drawing.point(0.0, centre)
    ends = [[drawing.point(radius * math.sin(at), centre - side * radius * math.cos(at)) if at else
             drawing.point(0.0, centre - side * radius) for at in (0.0, angle)] for radius in (inner, outer)]
    arcs = [drawing.arc(first, middle, last) for first, last in ends]
    axis, end = (drawing.line(*pair) for pair in zip(*ends))
    surface = drawing.surface((axis, arcs[1], -end, -arcs[0]))
    drawing.cells(arcs, cells)
    drawing.cells((axis, end), layers)
    drawing.body(name, [surface])
    for which, curve in (("inside", arcs[0]), ("outside", arcs[1]), ("axis", axis), ("end", end)):
        drawing.face(f"{name} {which}", [curve])


def draw_half_ball(drawing, name, centre, radius, cells, layers):
    """Half of a ball with its pole at the origin, its section in three patches round a square at the centre."""
    side = math.copysign(1.0, centre)

    def point(x, y):
        return drawing.point(radius * x, centre - side * radius * y)

    middle, low, high, corner = point(0.0, 0.0), point(0.0, 0.5), point(0.5, 0.0), point(0.42, 0.42)
    pole, rim, between = point(0.0, 1.0), point(1.0, 0.0), point(math.sqrt(0.5), math.sqrt(0.5))
    square = [drawing.line(*ends) for ends in ((middle, low), (low, corner), (corner, high), (high, middle))]
    spokes = [drawing.line(*ends) for ends in ((low, pole), (corner, between), (high, rim))]
    arcs = [drawing.arc(pole, middle, between), drawing.arc(between, middle, rim)]
    surfaces = [drawing.surface(square), drawing.surface((spokes[0], arcs[0], -spokes[1], -square[1])),
                drawing.surface((spokes[1], arcs[1], -spokes[2], -square[2]))]
    drawing.cells(square + arcs, cells)
    drawing.cells(spokes, layers)
    drawing.body(name, surfaces)
    drawing.face(f"{name} surface", arcs)
    drawing.face(f"{name} flat", [square[3], spokes[2]])
    drawing.face(f"{name} axis", [square[0], spokes[0]])


def draw_punch(drawing, shape, is_half, cells, columns, layers):
    """A punch with rounded edges that stands on y = 0: a flat, an arc that leaves it, and straight sides."""
    flat, edge, angle, height = shape
    side = flat + edge * math.sin(angle)
    bottoms = {sign: drawing.point(sign * flat, 0.0) for sign in (-1, 1)}
    tops = {sign: drawing.point(sign * flat, height) for sign in (-1, 1)}
    if is_half:
        bottoms[-1], tops[-1] = drawing.point(0.0, 0.0), drawing.point(0.0, height)
    posts = {sign: drawing.line(bottoms[sign], tops[sign]) for sign in (-1, 1)}
    face, lid = [drawing.line(bottoms[-1], bottoms[1])], [drawing.line(tops[1], tops[-1])]
    surfaces = [drawing.surface((face[0], posts[1], lid[0], -posts[-1]))]
    drawing.cells(face + lid, columns)
    drawing.cells(posts.values(), layers)
    for sign in (1,) if is_half else (1, -1):
        last = drawing.point(sign * side, edge * (1 - math.cos(angle)))
        top = drawing.point(sign * side, height)
        arc = drawing.arc(bottoms[sign], drawing.point(sign * flat, edge), last)
        wall, roof = drawing.line(last, top), drawing.line(top, tops[sign])
        surfaces.append(drawing.surface((arc, wall, roof, -posts[sign])))
        drawing.cells((arc, roof), cells)
        drawing.cells((wall,), layers)
        face.append(arc)
        lid.append(roof)
    drawing.body("punch", surfaces)
    drawing.face("punch face", face)
    drawing.face("punch lid", lid)
    if is_half:
        drawing.face("punch middle", [posts[-1]])


# A user's own geometry


def geometry_parameters(draw, unit, plane, bodies, supports, load, faces):
    """The subsection Geometry; `bodies` are materials by name, `load` is a surface with its parameters."""
    source, target = faces if draw.chance(0.5) else reversed(faces)
    entries = [("Length unit", unit), *plane, ("Bodies", ", ".join(bodies)), ("Supports", ", ".join(supports)),
               ("Loads", load[0]), ("Contact pairs", f"{source} -> {target}")]
    entries += [(f"Body {name}", material_parameters(draw, material)) for name, material in bodies.items()]
    return [("Model", "geometry"), ("Geometry", [*entries, (f"Load {load[0]}", load[1])])]


def load_parameters(kind, value, direction="0, -1"):
    return [("Type", kind), ("Value", value), ("Direction", direction)]


def line_load(draw, force_per_length, thickness, displacement):
    """A load of a line contact, as force, force per thickness or displacement."""
    kind = draw.pick(("force", "force", "force per thickness", "force per thickness", "displacement"))
    value = {"force": (force_per_length * thickness, "force"),
             "force per thickness": (force_per_length, "force per length"),
             "displacement": (displacement, "length")}[kind]
    return load_parameters(kind, draw.quantity(*value))


def draw_turn(draw):
    """The angle of a ring's first spoke: below, where the bodies touch, or anywhere."""
    return -math.pi / 2 if draw.chance(0.3) else draw.between(-math.pi, math.pi)


def line_contact(draw):
    """A cylinder on a cylinder, on a block or in a groove; half-width 1e-4 to 3e-2 of the smallest radius."""
    radius, core = draw.by_factor(1e-4, 10.0), draw.between(0.3, 0.7)
    shape = draw.pick(("cylinder", "block", "groove"))
    base, depth = {"cylinder": lambda: (radius * draw.by_factor(0.1, 10.0), draw.between(0.3, 0.7)),
                   "block": lambda: (math.inf, draw.between(2.0, 8.0)),
                   "groove": lambda: (-radius * draw.by_factor(1.05, 20.0), draw.between(0.5, 2.0))}[shape]()
    depth *= radius if shape == "block" else abs(base)
    relative = relative_radius(radius, base)
    materials = draw_materials(draw)
    is_plane_stress = draw.chance(0.15)
    modulus = contact_modulus(materials, is_plane_stress)
    smallest = min(radius, abs(base), (1 - core) * radius, depth)
    half_width = draw.by_factor(1e-4, 3e-2) * min(radius, abs(base))
    load = math.pi / 4 * modulus * half_width**2 / relative
    gap = draw.between(0.1, 1.0) * half_width**2 / relative if draw.chance(0.2) else 0.0
    approach = gap + sum(half_plane_approach(load, half_width, material, deep, is_plane_stress)
                         for material, deep in zip(materials, ((1 - core) * radius, depth)))

    unit = draw.pick(tuple(UNITS["length"]))
    drawing = Drawing(unit)
    draw_ring(drawing, "roller", radius + gap, core * radius, radius, draw_turn(draw), draw.whole(3, 12),
              draw.whole(1, 5))
    face, held = draw_base(draw, drawing, base, depth, radius)
    thickness = draw.by_factor(0.1, 10.0) * radius
    plane = [("Plane", "plane stress" if is_plane_stress else "plane strain"),
             ("Thickness", draw.quantity(thickness, "length"))]
    parameters = geometry_parameters(
        draw, unit, plane, dict(zip(("roller", "base"), materials)), [f"{held}: fixed"],
        ("roller inside", line_load(draw, load, thickness, approach)), ("roller outside", face))
    return parameters, drawing.text(), Hertz("line", relative, modulus, thickness, smallest)


def draw_base(draw, drawing, radius, depth, roller):
    """What a roller lies on: a cylinder, a block (infinite radius) or a groove (negative radius); the names of its face
    and of what is held."""
    if math.isinf(radius):
        width = draw.between(2.0, 8.0) * roller
        shift = draw.between(-0.3, 0.3) * width
        draw_rectangle(drawing, "base", shift - width, shift + width, depth, draw.whole(6, 24), draw.whole(1, 10))
        return "base top", "base bottom"
    inner, outer = (radius - depth, radius) if radius > 0 else (-radius, -radius + depth)
    draw_ring(drawing, "base", -radius, inner, outer, draw_turn(draw), draw.whole(3, 12), draw.whole(1, 5))
    return ("base outside", "base inside") if radius > 0 else ("base inside", "base outside")


def half_plane_approach(load, half_width, material, depth, is_plane_stress):
    """By which the middle of a line contact comes nearer to a point of a half-plane at a depth (K. L. Johnson 1985,
    section 5.6)."""
    ratio = material.poissons_ratio if is_plane_stress else material.poissons_ratio / (1 - material.poissons_ratio)
    return load * material.compliance(is_plane_stress) / math.pi * (2 * math.log(2 * depth / half_width) - ratio)


def sphere_contact(draw):
    """A sphere on a flat, on a sphere or in a cup; contact radius 1e-3 to 5e-2 of the smaller radius."""
    radius = draw.by_factor(1e-4, 10.0)
    shape = draw.pick(("sphere", "flat", "cup"))
    base = {"sphere": lambda: radius * draw.by_factor(0.2, 5.0), "flat": lambda: math.inf,
            "cup": lambda: -radius * draw.by_factor(1.1, 10.0)}[shape]()
    relative = relative_radius(radius, base)
    materials = draw_materials(draw)
    modulus = contact_modulus(materials)
    contact_radius = draw.by_factor(1e-3, 5e-2) * min(radius, abs(base))
    force = 4 / 3 * modulus * contact_radius**3 / relative

    unit = draw.pick(tuple(UNITS["length"]))
    drawing = Drawing(unit)
    held = {"ball axis": "x", "base axis": "x"}
    face, loaded, upper = draw_round_body(draw, drawing, "ball", radius)
    if math.isinf(base):
        size = draw.between(2.0, 6.0) * radius
        draw_rectangle(drawing, "base", 0.0, size, size, draw.whole(3, 12), draw.whole(2, 10))
        base_face, base_held, lower, held = "base top", "base bottom", size, {"ball axis": "x", "base left": "x"}
    elif base > 0:
        base_face, base_held, lower = draw_round_body(draw, drawing, "base", -base)
    else:
        lower = draw.between(0.5, 2.0) * -base
        draw_sector(drawing, "base", -base, -base, -base + lower, draw.between(0.3, 0.5) * math.pi, draw.whole(3, 12),
                    draw.whole(1, 5))
        base_face, base_held = "base inside", "base outside"
    held[base_held] = "fixed"
    load = load_parameters(*(("force", draw.quantity(force, "force")) if draw.chance(0.75) else
                             ("displacement", draw.quantity(contact_radius**2 / relative, "length"))))
    parameters = geometry_parameters(
        draw, unit, [("Plane", "axisymmetric")], dict(zip(("ball", "base"), materials)),
        [f"{surface}: {how}" for surface, how in held.items()], (loaded, load), (face, base_face))
    return parameters, drawing.text(), Hertz("point", relative, modulus, smallest=min(radius, abs(base), upper, lower))


def draw_round_body(draw, drawing, name, centre):
    """A ball that touches y = 0, as half a ball or as a shell round a core; its face, what is loaded or held, and how
    deep the body is."""
    radius, cells = abs(centre), draw.whole(3, 10)
    if draw.chance(0.5):
        draw_half_ball(drawing, name, centre, radius, cells, draw.whole(1, 5))
        return f"{name} surface", f"{name} flat", radius
    core = draw.between(0.3, 0.7) * radius
    draw_sector(drawing, name, centre, core, radius, math.pi / 2, cells, draw.whole(1, 5))
    return f"{name} outside", f"{name} inside", radius - core


def punch_contact(draw):
    """A punch with rounded edges on a block: the pressure is greatest near the ends of the flat."""
    flat = draw.by_factor(1e-4, 1.0)
    edge, angle = flat * draw.by_factor(0.1, 2.0), draw.between(30.0, 60.0) * math.pi / 180
    beyond = draw.by_factor(0.02, 0.3) * edge
    materials = draw_materials(draw)
    force = rounded_punch_load(flat, edge, flat + beyond, contact_modulus(materials))
    is_half = draw.chance(0.5)
    height = draw.between(1.0, 3.0) * (flat + edge)

    unit = draw.pick(tuple(UNITS["length"]))
    drawing = Drawing(unit)
    draw_punch(drawing, (flat, edge, angle, height), is_half, draw.whole(2, 6), draw.whole(2, 10), draw.whole(2, 6))
    width = draw.between(3.0, 8.0) * (flat + edge)
    left = 0.0 if is_half else draw.between(-1.3, -0.7) * width
    draw_rectangle(drawing, "base", left, left + (1 if is_half else 2) * width, draw.between(0.5, 1.0) * width,
                   draw.whole(3, 12) * (1 if is_half else 2), draw.whole(2, 8))
    thickness = draw.by_factor(0.1, 10.0) * flat
    supports = ["base bottom: fixed", *(("punch middle: x", "base left: x") if is_half else ())]
    share = 0.5 if is_half else 1.0
    load = load_parameters("force", draw.quantity(share * force * thickness, "force"))
    plane = [("Plane", "plane strain"), ("Thickness", draw.quantity(thickness, "length"))]
    parameters = geometry_parameters(draw, unit, plane, dict(zip(("punch", "base"), materials)), supports,
                                     ("punch lid", load), ("punch face", "base top"))
    return parameters, drawing.text(), None


def rounded_punch_load(flat, edge, half_width, modulus):
    """Load per length of a half-plane under a flat with edges of a radius, from the contact's half-width.

    P' = (E*/2) int_-b^b x h'(x)/sqrt(b^2 - x^2) dx with the slope h' = (|x| - a)/R beyond the flat |x| < a
    (K. L. Johnson 1985, section 2.7 gives the pressure under a given slope).
    """
    return modulus / edge * (half_width**2 / 2 * math.acos(flat / half_width) -
                             flat / 2 * math.sqrt(half_width**2 - flat**2))


# Mechanisms


@dataclasses.dataclass
class Wheel:
    """What the load of a wheel at an instant follows from."""
    type: str
    stations: int
    diameter: float
    pin: float  # diameter
    thickness: float
    clearance: float
    materials: tuple  # of pin and wheel

    def reach(self, angle):
        """Distance from the wheel's axis to the pin's, and the wheel's acceleration over the driver's speed squared.

        x^2 = r^2 + c^2 -+ 2 r c cos(theta), and ME341, Eq. 5.32; theta = 0 is midway through the engagement.
        """
        s = math.sin(math.pi / self.stations) * (1 if self.type == "external" else -1)
        centres = self.diameter / 2 / math.cos(math.pi / self.stations)
        square = 1 + s**2 - 2 * s * math.cos(angle)
        return centres * math.sqrt(square), -s * (1 - s**2) * math.sin(angle) / square**2

    def inertia(self, density):
        """More than the drawn wheel's moment of inertia: without slots, arcs and bore."""
        outer, inner = self.diameter / 2, 0.0
        if self.type == "internal":
            slope = math.pi / self.stations
            reach = outer / math.cos(slope) + outer * math.tan(slope)  # of the pin, c + r
            outer, inner = reach + (self.pin + self.clearance) / 2 + 0.15 * self.diameter, outer
        return math.pi / 2 * density * self.thickness * (outer**4 - inner**4)

    def engagement(self):
        """Maximum driver angle at which the pin stands in the slot with room for its contact before the wall's end."""
        sign = 1 if self.type == "external" else -1
        entry = math.pi / 2 - sign * math.pi / self.stations
        width = self.pin + self.clearance
        end = math.sqrt(self.diameter**2 - width**2) / 2
        inside = -sign * 0.1 * self.pin

        def fits(angle):
            return sign * (end + inside - self.reach(angle)[0]) > 0

        low, high = 0.0, entry
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if fits(middle) else (low, middle)
        return low


def draw_wheel(draw, wheel_type, maximum_stations=24):
    """A wheel with Johnson's proportions or a thinner pin."""
    stations = draw.whole(3, maximum_stations)
    diameter = draw.by_factor(0.01, 1.0)
    shrunk = min(1.0, math.sin(math.pi / stations) / math.sin(math.pi / 10))  # with the pitch, beyond the table
    widest = JOHNSON_PIN[min(stations, 10) - 3] * shrunk
    pin = diameter * widest * (1.0 if draw.chance(0.5) else draw.between(0.5, 1.0))
    clearance = 0.0 if draw.chance(0.4) else pin * draw.by_factor(1e-4, 1e-2)
    materials = (Material(draw.by_factor(5e10, 4e11), draw.between(0.2, 0.4)),
                 Material(draw.by_factor(2e9, 4e11), draw.between(0.2, 0.45)))
    return Wheel(wheel_type, stations, diameter, pin, diameter * draw.between(0.05, 0.2), clearance, materials)


def mechanism_parameters(draw, wheel, angle, force, further):
    """The parameters of a mechanism whose pin force is about the one given.

    The friction moment carries most of it. Where the wheel gains speed up to a half is left to the inertia of wheel and
    load, where it loses speed the friction carries up to a fifth more.
    """
    density = draw.between(1500.0, 9000.0)
    arm, acceleration = wheel.reach(angle)
    moment = force * arm
    inertia = wheel.inertia(density)
    load_inertia = inertia * draw.by_factor(0.01, 10.0)
    share = draw.between(0.0, 0.5 if acceleration > 0 else 0.2)
    speed = math.sqrt(share * moment / (inertia + load_inertia) / max(abs(acceleration), 0.1))
    friction = moment - (inertia + load_inertia) * acceleration * speed**2
    pin, slot = wheel.materials
    entries = [("Type", wheel.type), ("Stations", wheel.stations),
               ("Wheel diameter", draw.quantity(wheel.diameter, "length")),
               ("Pin diameter", draw.quantity(wheel.pin, "length")),
               ("Wheel thickness", draw.quantity(wheel.thickness, "length")),
               ("Slot clearance", draw.quantity(wheel.clearance, "length")),
               ("Driver speed", draw.quantity(speed, "speed")), ("Driver angle", draw.quantity(angle, "angle")),
               ("Friction moment", draw.quantity(friction, "moment")),
               ("Load inertia", draw.quantity(load_inertia, "inertia")),
               ("Pin core radius", draw.quantity(wheel.pin * draw.between(0.15, 0.35), "length")), *further,
               ("Pin material", material_parameters(draw, pin)),
               ("Wheel material", [*material_parameters(draw, slot), ("Density", draw.quantity(density, "density"))])]
    return [("Model", "mechanism"), ("Mechanism", entries)]


def wheel_hertz(wheel):
    return Hertz("line", wheel.pin / 2, contact_modulus(wheel.materials), wheel.thickness, wheel.pin / 4)


def draw_pin_force(draw, wheel, least=1e-3):
    """A pin force by which the half-width of an even contact is from `least` to 3e-2 of the pin's radius."""
    half_width = draw.by_factor(least, 3e-2) * wheel.pin / 2
    return math.pi / 4 * contact_modulus(wheel.materials) * half_width**2 / (wheel.pin / 2) * wheel.thickness


def wheel_contact(draw, wheel_type, further=()):
    """A pin in the slot of a wheel at any instant; one in ten stands nearest to the slot's bottom."""
    wheel = draw_wheel(draw, wheel_type)
    reach = wheel.engagement()
    angle = 0.0 if draw.chance(0.1) else draw.between(-reach, reach)
    parameters = mechanism_parameters(draw, wheel, angle, draw_pin_force(draw, wheel),
                                      [(name, value(draw, wheel)) for name, value in further])
    return parameters, "", wheel_hertz(wheel)


def local_contact(draw):
    """A pin on a block of slot wall."""
    block = (("Contact model", lambda draw, wheel: "local"),
             ("Block width", lambda draw, wheel: draw.quantity(wheel.pin * draw.between(2.0, 8.0), "length")),
             ("Block depth", lambda draw, wheel: draw.quantity(wheel.pin * draw.between(1.0, 4.0), "length")))
    return wheel_contact(draw, draw.pick(("external", "internal")), block)


# In 3-D


def ellipse(force, radii, modulus):
    """Semi-axes of Hertz's contact from the radii in its two planes, the greater first: along it and across.

    After B. J. Hamrock and D. E. Brewe's simplified solution (1983), within some per cent.
    """
    ratio = 1.0339 * (radii[0] / radii[1])**0.636
    integral = 1.0003 + 0.5968 * radii[1] / radii[0]
    along = (3 * ratio**2 * integral * force * relative_radius(*radii) / (math.pi * modulus))**(1 / 3)
    return along, along / ratio


def crown_for(force, radius, modulus, half_length):
    """Crown radius by which the contact is as long as wanted, by bisection."""
    low, high = 2 * radius, 1e8 * radius
    for _ in range(80):
        middle = math.sqrt(low * high)
        shorter = ellipse(force, (middle, radius), modulus)[0] < half_length
        low, high = (middle, high) if shorter else (low, middle)
    return low


def pin_contact(draw, kind):
    """A crowned pin whose contact ends before the slot does: straight, leaning, or a long cantilever.

    Very narrow contacts are left out: they would need some hundred thousand unknowns on the first mesh that sees them.
    """
    wheel = draw_wheel(draw, "external", 10)
    wheel.thickness = wheel.pin * draw.between(0.7, 1.3)
    force = draw_pin_force(draw, wheel, 5e-3)
    modulus = contact_modulus(wheel.materials)
    crown = crown_for(force, wheel.pin / 2, modulus, draw.between(0.25, 0.6) * wheel.thickness / 2)
    held = draw.pick(("one end", "both ends", "core")) if kind == "crowned" else "one end"
    pin = [("Held at", held), ("Profile", "crown"), ("Crown radius", draw.quantity(crown, "length"))]
    if held != "core":
        gap = draw.between(0.5, 1.0) if kind == "bent" else draw.between(0.1, 0.4)
        pin += [("Root gap", draw.quantity(gap * wheel.pin, "length"))]
    if held == "one end":
        pin += [("Overhang", draw.quantity(draw.between(0.1, 0.4) * wheel.pin, "length"))]
    if kind == "tilted":
        lean = draw.between(-0.25, 0.25) * wheel.thickness / 2 / crown
        pin += [("Tilt", draw.quantity(lean, "angle"))]
        wheel.clearance += 2 * wheel.thickness * abs(lean)  # clear of the other wall
    reach = wheel.engagement()
    angle = draw.between(-0.9, 0.9) * reach
    parameters = mechanism_parameters(draw, wheel, angle, force, [("Pin", pin)])
    return [("Dimension", 3), *parameters], "", None


def crossed_contact(draw):
    """Quarters of two cylinders that cross at a right angle, as in cases/crossed-cylinders."""
    unit = draw.pick(tuple(UNITS["length"]))
    scale = UNITS["length"][unit]
    radius = draw.by_factor(1e-3, 1.0)
    radii = (radius, radius * draw.by_factor(0.25, 4.0))
    small = min(radii)
    materials = draw_materials(draw)
    wanted = draw.by_factor(0.01, 0.05) * small
    unit_force = ellipse(1.0, sorted(radii, reverse=True), contact_modulus(materials))[0]
    force = (wanted / unit_force)**3 / 4
    length = draw.between(0.6, 0.95) * small
    values = {"R1": radii[0] / scale, "R2": radii[1] / scale, "depth": draw.between(0.5, 0.8) * small / scale,
              "L": length / scale, "A1": math.asin(min(0.75, length / radii[0])),
              "A2": math.asin(min(0.75, length / radii[1])), "cells": draw.whole(3, 6), "layers": draw.whole(2, 5)}
    geometry = "".join(f"{name} = {value!r};\n" for name, value in values.items()) + CROSSED
    supports = ["lower core: fixed", "lower side x: x", "lower side z: z", "upper side x: x", "upper side z: z"]
    load = load_parameters("force", draw.quantity(force, "force"), "0, -1, 0")
    parameters = geometry_parameters(draw, unit, [], dict(zip(("upper", "lower"), materials)), supports,
                                     ("upper core", load), ("upper surface", "lower surface"))
    return [("Dimension", 3), *parameters], geometry, None


# A sector between surface and core of each cylinder, extruded along its axis.
CROSSED = """SetFactory("OpenCASCADE");
Macro Sector
  Point(n) = {0, side * R, 0};
  Point(n + 1) = {0, 0, 0};
  Point(n + 2) = {ux * R * Sin(angle), side * R * (1 - Cos(angle)), uz * R * Sin(angle)};
  Point(n + 3) = {ux * (R - depth) * Sin(angle), side * (R - (R - depth) * Cos(angle)), uz * (R - depth) * Sin(angle)};
  Point(n + 4) = {0, side * depth, 0};
  Circle(n + 1) = {n + 1, n, n + 2};
  Line(n + 2) = {n + 2, n + 3};
  Circle(n + 3) = {n + 3, n, n + 4};
  Line(n + 4) = {n + 4, n + 1};
  Curve Loop(n + 1) = {n + 1, n + 2, n + 3, n + 4};
  Plane Surface(n + 1) = {n + 1};
  Transfinite Curve {n + 1, n + 3} = cells + 1;
  Transfinite Curve {n + 2, n + 4} = layers + 1;
  Transfinite Surface {n + 1};
  Recombine Surface {n + 1};
Return
n = 100;
side = 1;
R = R1;
ux = 0;
uz = 1;
angle = A1;
Call Sector;
upper[] = Extrude {L, 0, 0} { Surface{101}; Layers{cells}; Recombine; };
n = 200;
side = -1;
R = R2;
ux = 1;
uz = 0;
angle = A2;
Call Sector;
lower[] = Extrude {0, 0, L} { Surface{201}; Layers{cells}; Recombine; };
Physical Volume("upper") = {upper[1]};
Physical Surface("upper surface") = {upper[2]};
Physical Surface("upper core") = {upper[4]};
Physical Surface("upper side x") = {101};
Physical Surface("upper side z") = {upper[5]};
Physical Volume("lower") = {lower[1]};
Physical Surface("lower surface") = {lower[2]};
Physical Surface("lower core") = {lower[4]};
Physical Surface("lower side x") = {lower[5]};
Physical Surface("lower side z") = {201};
"""

DRAWERS = {"line": line_contact, "sphere": sphere_contact, "punch": punch_contact, "local": local_contact,
           "external": lambda draw: wheel_contact(draw, "external"),
           "internal": lambda draw: wheel_contact(draw, "internal"),
           "crowned": lambda draw: pin_contact(draw, "crowned"), "tilted": lambda draw: pin_contact(draw, "tilted"),
           "bent": lambda draw: pin_contact(draw, "bent"), "crossed": crossed_contact}
