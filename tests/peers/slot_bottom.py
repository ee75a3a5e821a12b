#!/usr/bin/env python3
"""The wheel's maximum stresses away from the contact as `geneva run` finds them, beside those of CalculiX.

    tests/peers/slot_bottom.py build/release/app/geneva
    tests/peers/slot_bottom.py build/release/app/geneva --cases johnson-small-wheel --cells 24

Runs shipped cases in the plane, whose maximum von Mises stress and maximum first principal stress of the wheel are at
the round bottom of the engaged slot: once as they are and once at a `Structural accuracy` of 0.2 %. Then it meshes the
wheel of results/mechanism.json anew, with its arcs as true circles, by curved triangles of second degree, and solves
the same load with CalculiX in plane strain:
    bore held,
    contact force as an even pressure over the contact's width around the centre of the contact pressure,
    inertia of the wheel as a body force, of the density that gives the wheel's inertia on that mesh.
So there is no contact, no bilinear cell and no recovery of geneva's. Outline, contact force, width and place, speed and
acceleration are geneva's own: they are not checked here, beyond that the torque of all loads is the bore's.

CalculiX has each wheel twice, with cells of the sizes h and h/2 everywhere; its stresses are those at the nodes, means
of what it extrapolates from the points of integration. Its maximum is that over the nodes of the bottom no further from
geneva's place than half of the bottom's radius. Exit code 1 if a maximum at 0.2 % differs by more than 0.5 % from that on
the finer mesh, or if the latter has changed by more than 0.25 % from the coarser.

Needs numpy, gmsh and ccx (Debian's packages gmsh and calculix-ccx).
"""

import argparse
import dataclasses
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "cli"))
from geneva_cli import change_case, environment, find_parameter, look_up, number, read_csv, read_summary  # noqa: E402

CASES = ("johnson-optimum-wheel", "johnson-small-wheel", "johnson-large-wheel", "six-station-360rpm")
ALLOWED = 5e-3
ALLOWED_CHANGE = 2.5e-3  # of CalculiX from h to h/2
TORQUE_TOLERANCE = 1e-3  # of the pin's torque; the contact wanders by some micrometres along the wall
STRESSES = {"von_mises": "von Mises", "tensile": "tensile"}
# CalculiX has millimetres and newtons, so that no number is very small.
MM = 1e3

# Edges of the coarser mesh: growth with the distance from bottom or load; the longest over the radius of the bottom.
GROWTH, LONGEST = 0.2, 0.25
EDGES_ON_LOAD = 4


# The load


@dataclasses.dataclass
class Load:
    """Everything about a wheel but its outline, in millimetres, newtons and seconds."""
    thickness: float
    radius: float  # of the slot's bottom
    force: float
    place: float  # along the wall
    half_width: float
    inertia: float  # N mm s^2
    speed: float
    acceleration: float
    torque: float  # on the bore
    poissons_ratio: float


def load_of(case):
    summary, mechanism = read_summary(case / "results"), read_mechanism(case)
    lengths = {entry["name"]: MM * number(entry["length"]) for entry in mechanism["lengths"]}
    analysed = mechanism["analysed"]
    return Load(lengths["wheel thickness"], lengths["slot width"] / 2, number(summary["contact"]["force"]),
                MM * centre_of_pressure(case), MM * number(summary["contact"]["half_width"]),
                MM * number(summary["wheel"]["inertia_used"]), analysed["wheel_speed"], analysed["wheel_acceleration"],
                MM * number(look_up(summary, "equilibrium.bore_torque")), poissons_ratio(case))


def read_mechanism(case):
    return json.loads((case / "results" / "mechanism.json").read_text())


def centre_of_pressure(case):
    columns = read_csv(case / "results" / "contact.csv")
    x, pressure = np.array(columns["x [m]"]), np.array(columns["contact_pressure [Pa]"])
    order = np.argsort(x)
    x, pressure = x[order], pressure[order]
    moment = pressure * x
    return ((moment[1:] + moment[:-1]) * np.diff(x)).sum() / ((pressure[1:] + pressure[:-1]) * np.diff(x)).sum()


def poissons_ratio(case):
    lines = (case / "case.prm").read_text().splitlines()
    place, is_there = find_parameter(lines, ["Mechanism", "Wheel material"], "Poisson's ratio")
    if not is_there:
        raise ValueError(f"{case.name}: the case has to give the wheel's Poisson's ratio")
    return float(lines[place].split("=")[1].split("#")[0])


# The outline


@dataclasses.dataclass
class Edge:
    """A straight line, or an arc of less than half a turn around a centre."""
    start: np.ndarray
    end: np.ndarray
    centre: np.ndarray | None = None
    name: str = "free"


def edges_of(polyline):
    """Lines and arcs of a closed polyline; it begins at a corner or is one circle. An arc is a run of segments of the
    same length that turn by the same angle; a segment that is alone is a line."""
    points = np.array(polyline, float)[:, :2] * MM
    steps = np.diff(points, axis=0)
    lengths = np.hypot(*steps.T)
    # Turn from each segment to the next.
    turns = np.arctan2(steps[:-1, 0] * steps[1:, 1] - steps[:-1, 1] * steps[1:, 0], (steps[:-1] * steps[1:]).sum(1))
    edges, first = [], 0
    while first < len(steps):
        last = first
        while (last + 1 < len(steps) and math.isclose(lengths[last + 1], lengths[first], rel_tol=1e-6)
               and math.isclose(turns[last], turns[first], abs_tol=1e-6) and abs(turns[first]) < 0.1):
            last += 1
        run = points[first:last + 2]
        edges += [Edge(run[0], run[1])] if last == first else arcs_of(run)
        first = last + 1
    return edges


def arcs_of(run):
    """The points' arc in parts of a quarter turn at most."""
    centre = circle_centre(run[0], run[len(run) // 3], run[2 * len(run) // 3])
    radii = np.hypot(*(run - centre).T)
    assert np.ptp(radii) < 1e-6 * radii[0], "the points of an arc are on a circle"
    sweep = (len(run) - 1) * 2 * math.asin(math.dist(run[0], run[1]) / (2 * radii[0]))
    ends = np.linspace(0, len(run) - 1, math.ceil(sweep / (math.pi / 2) - 1e-6) + 1).round().astype(int)
    return [Edge(run[i], run[j], centre) for i, j in zip(ends[:-1], ends[1:])]


def circle_centre(a, b, c):
    matrix = 2 * np.array([b - a, c - a])
    return np.linalg.solve(matrix, [b @ b - a @ a, c @ c - a @ a])


def wheel_loops(polylines, load):
    """Outer boundary and bore, with the bottom, the bore and the loaded part of the wall named."""
    loops = [edges_of(polyline) for polyline in polylines]
    if len(loops) != 2:
        raise ValueError("a wheel with a bore and nothing else is wanted")
    for edge in loops[1]:
        edge.name = "bore"
    bottom = [edge for edge in loops[0] if is_bottom(edge, load)]
    assert len(bottom) == 2, "the engaged slot's bottom is two quarters of a circle"
    for edge in bottom:
        edge.name = "bottom"
    loops[0] = [part for edge in loops[0] for part in with_load(edge, load)]
    if sum(edge.name == "load" for edge in loops[0]) != 1:
        raise ValueError("the contact is not on the straight wall alone")
    return loops


def is_bottom(edge, load):
    if edge.centre is None:
        return False
    small = 1e-6 * load.radius
    on_axis = edge.centre[0] > 0 and abs(edge.centre[1]) < small
    return on_axis and abs(math.dist(edge.start, edge.centre) - load.radius) < small


def with_load(edge, load):
    """The edge, in three if it is the driving wall (y = +w/2), the middle one being loaded."""
    on_wall = edge.centre is None and all(
        abs(end[1] - load.radius) < 1e-6 * load.radius and end[0] > 0 for end in (edge.start, edge.end))
    left, right = load.place - load.half_width, load.place + load.half_width
    if not (on_wall and edge.start[0] < left and right < edge.end[0]):
        return [edge]
    begin, end = np.array([left, load.radius]), np.array([right, load.radius])
    return [Edge(edge.start, begin), Edge(begin, end, None, "load"), Edge(end, edge.end)]


# The mesh


@dataclasses.dataclass
class Mesh:
    """Nodes, triangles of six nodes (corners, then middles), and edges of three nodes (ends, then middle)."""
    nodes: np.ndarray
    triangles: np.ndarray
    edges: dict


NAMES = {"bore": 1, "bottom": 2, "load": 3, "free": 4}
WHEEL = 5


def geometry_text(loops, load, cells, scale):
    """Gmsh's input. All sizes are multiplied by the scale."""
    lines, tags, curves = [], {}, {name: [] for name in NAMES}

    def point(place):
        key = tuple(np.round(place, 9))
        if key not in tags:
            tags[key] = len(tags) + 1
            lines.append(f"Point({tags[key]}) = {{{place[0]:.15g}, {place[1]:.15g}, 0}};")
        return tags[key]

    tag = 0
    for index, loop in enumerate(loops):
        first = tag + 1
        for edge in loop:
            tag += 1
            ends = point(edge.start), point(edge.end)
            if edge.centre is None:
                lines.append(f"Line({tag}) = {{{ends[0]}, {ends[1]}}};")
            else:
                lines.append(f"Circle({tag}) = {{{ends[0]}, {point(edge.centre)}, {ends[1]}}};")
            curves[edge.name].append(tag)
        lines.append(f"Curve Loop({index + 1}) = {{{first}:{tag}}};")
    lines.append("Plane Surface(1) = {1, 2};")
    lines += [f"Physical Curve({NAMES[name]}) = {{{', '.join(map(str, tags))}}};" for name, tags in curves.items()]
    lines.append(f"Physical Surface({WHEEL}) = {{1}};")
    return "\n".join(lines + size_lines(loops, load, cells, scale)) + "\n"


def size_lines(loops, load, cells, scale):
    """Sizes at the bottom's circle, around the load, and elsewhere."""
    centre = next(edge.centre for edge in loops[0] if edge.name == "bottom")[0]  # on the x axis
    at_load = 2 * load.half_width / EDGES_ON_LOAD
    # Gmsh's formulas know no exponents such as 1e-5.
    sizes = (f"{scale} * ({load.radius / cells:.9f} + {GROWTH} * "
             f"Abs(Sqrt((x - {centre:.9f})^2 + y^2) - {load.radius:.9f}))",
             f"{scale} * ({at_load:.9f} + {GROWTH} * Sqrt((x - {load.place:.9f})^2 + (y - {load.radius:.9f})^2))",
             f"{scale * LONGEST * load.radius:.9f}")
    lines = []
    for tag, size in enumerate(sizes, 1):
        lines += [f"Field[{tag}] = MathEval;", f'Field[{tag}].F = "{size}";']
    return lines + ["Field[4] = Min;", "Field[4].FieldsList = {1, 2, 3};", "Background Field = 4;",
                    "Mesh.MeshSizeFromPoints = 0;", "Mesh.MeshSizeExtendFromBoundary = 0;", "Mesh.ElementOrder = 2;",
                    "Mesh.Algorithm = 6;", "Mesh.MshFileVersion = 2.2;"]


def make_mesh(text, directory):
    (directory / "wheel.geo").write_text(text)
    run_tool(["gmsh", "-2", "-nt", "1", "wheel.geo", "-o", "wheel.msh"], directory)
    lines = (directory / "wheel.msh").read_text().splitlines()
    begin = lines.index("$Nodes")
    rows = np.array([line.split() for line in lines[begin + 2:begin + 2 + int(lines[begin + 1])]], float)
    index = np.full(int(rows[:, 0].max()) + 1, -1)
    index[rows[:, 0].astype(int)] = np.arange(len(rows))
    begin = lines.index("$Elements")
    triangles, edges = [], {name: [] for name in NAMES}
    names = {tag: name for name, tag in NAMES.items()}
    for line in lines[begin + 2:begin + 2 + int(lines[begin + 1])]:
        _, kind, count, group, *rest = map(int, line.split())
        nodes = index[rest[count - 1:]]
        if kind == 9:
            triangles.append(nodes)
        elif kind == 8:
            edges[names[group]].append(nodes)
    return used_nodes(Mesh(rows[:, 1:3], counter_clockwise(rows[:, 1:3], np.array(triangles)),
                           {name: np.array(parts) for name, parts in edges.items()}))


def counter_clockwise(nodes, triangles):
    """As CalculiX wants them."""
    a, b, c = (nodes[triangles[:, i]] for i in range(3))
    twice_area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    triangles[twice_area < 0] = triangles[twice_area < 0][:, [0, 2, 1, 5, 4, 3]]
    return triangles


def used_nodes(mesh):
    """The mesh without nodes that no triangle has, as the centres of arcs."""
    used = np.unique(mesh.triangles)
    index = np.full(len(mesh.nodes), -1)
    index[used] = np.arange(len(used))
    return Mesh(mesh.nodes[used], index[mesh.triangles], {name: index[edges] for name, edges in mesh.edges.items()})


def run_tool(command, directory):
    """Runs gmsh or ccx on one core."""
    done = subprocess.run(command, cwd=directory, env={**os.environ, "OMP_NUM_THREADS": "1"}, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)} failed\n{done.stdout}")


# The forces at the nodes


def integration_points():
    """Radon's rule of the fifth degree on the triangle: two coordinates and the weight."""
    root = math.sqrt(15)
    points = [(1 / 3, 1 / 3, 9 / 80)]
    for a, weight in (((6 - root) / 21, (155 - root) / 2400), ((6 + root) / 21, (155 + root) / 2400)):
        points += [(a, a, weight), (1 - 2 * a, a, weight), (a, 1 - 2 * a, weight)]
    return points


def shape_functions(s, t):
    """Values of the six, and their derivatives with respect to s and t."""
    r = 1 - s - t
    values = np.array([r * (2 * r - 1), s * (2 * s - 1), t * (2 * t - 1), 4 * r * s, 4 * s * t, 4 * t * r])
    by_s = np.array([1 - 4 * r, 4 * s - 1, 0, 4 * (r - s), 4 * t, -4 * t])
    by_t = np.array([1 - 4 * r, 0, 4 * t - 1, -4 * s, 4 * s, 4 * (r - t)])
    return values, by_s, by_t


def inertia_forces(mesh, load):
    """Those of the body force that geneva gives the wheel: outwards by the speed, against the acceleration."""
    corners = mesh.nodes[mesh.triangles]
    forces, moment_of_area = np.zeros_like(mesh.nodes), 0.0
    for s, t, weight in integration_points():
        values, by_s, by_t = shape_functions(s, t)
        place, along_s, along_t = (np.einsum("i,eij->ej", part, corners) for part in (values, by_s, by_t))
        area = weight * (along_s[:, 0] * along_t[:, 1] - along_s[:, 1] * along_t[:, 0])
        assert (area > 0).all(), "no triangle is turned inside out"
        moment_of_area += (area * (place**2).sum(1)).sum()
        across = np.column_stack([place[:, 1], -place[:, 0]])  # against the sense of rotation
        density = load.speed**2 * place + load.acceleration * across
        parts = area[:, None, None] * values[None, :, None] * density[:, None, :]
        np.add.at(forces, mesh.triangles.ravel(), parts.reshape(-1, 2))
    return load.inertia / moment_of_area * forces


def contact_forces(mesh, load):
    """Of an even pressure on the straight edges under the load, towards +y."""
    forces = np.zeros_like(mesh.nodes)
    edges = mesh.edges["load"]
    lengths = np.hypot(*(mesh.nodes[edges[:, 1]] - mesh.nodes[edges[:, 0]]).T)
    for column, share in enumerate((1 / 6, 1 / 6, 4 / 6)):
        np.add.at(forces[:, 1], edges[:, column], share * load.force * lengths / lengths.sum())
    return forces


def check_torque(mesh, load, forces):
    x, y = mesh.nodes.T
    torque = (x * forces[:, 1] - y * forces[:, 0]).sum()
    if abs(torque - load.torque) > TORQUE_TOLERANCE * load.force * load.place:
        raise RuntimeError(f"the loads turn the wheel by {torque:.6g} N mm, geneva's by {load.torque:.6g} N mm")


# CalculiX


def calculix_text(mesh, load, forces):
    lines = ["*NODE, NSET=NALL"]
    lines += [f"{i}, {x:.12g}, {y:.12g}, 0" for i, (x, y) in enumerate(mesh.nodes, 1)]
    lines.append("*ELEMENT, TYPE=CPE6, ELSET=WHEEL")
    lines += [f"{i}, {', '.join(map(str, nodes + 1))}" for i, nodes in enumerate(mesh.triangles, 1)]
    lines.append("*BOUNDARY")
    lines += [f"{i + 1}, 1, 2" for i in np.unique(mesh.edges["bore"])]
    # The bore is held and all else is forces: the stresses do not depend on the modulus.
    lines += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"2e5, {load.poissons_ratio}",
              "*SOLID SECTION, ELSET=WHEEL, MATERIAL=STEEL", f"{load.thickness:.12g}", "*STEP", "*STATIC", "*CLOAD"]
    lines += [f"{i}, {axis}, {value:.12g}" for i, force in enumerate(forces, 1) for axis, value in enumerate(force, 1)]
    return "\n".join(lines + ["*EL FILE, OUTPUT=2D", "S", "*END STEP"]) + "\n"


def calculix_stresses(directory, count):
    """Rows of sxx, syy, szz, sxy, syz, szx at the nodes, NaN where there is none."""
    stresses = np.full((count, 6), np.nan)
    reading = False
    for line in (directory / "wheel.frd").read_text().splitlines():
        if line.startswith(" -4"):
            reading = line.split()[1] == "STRESS"
        elif line.startswith(" -3"):
            reading = False
        elif reading and line.startswith(" -1"):
            stresses[int(line[3:13]) - 1] = [float(line[13 + 12 * i:25 + 12 * i]) for i in range(6)]
    return stresses


def invariants(stresses):
    """Von Mises' and the first principal stress."""
    xx, yy, zz, xy, yz, zx = stresses.T
    tensors = np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]).transpose(2, 0, 1)
    von_mises = np.sqrt(((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) / 2 + 3 * (xy**2 + yz**2 + zx**2))
    return {"von_mises": von_mises, "tensile": np.linalg.eigvalsh(tensors)[:, 2]}


@dataclasses.dataclass
class Maximum:
    """In MPa and mm."""
    value: float
    place: np.ndarray
    error: float = 0.0


def calculix_maxima(loops, load, near, cells, scale, directory):
    """Maxima at the bottom near the given places, and the count of triangles."""
    directory.mkdir()
    mesh = make_mesh(geometry_text(loops, load, cells, scale), directory)
    forces = inertia_forces(mesh, load) + contact_forces(mesh, load)
    check_torque(mesh, load, forces)
    (directory / "wheel.inp").write_text(calculix_text(mesh, load, forces))
    run_tool(["ccx", "wheel"], directory)
    bottom = np.unique(mesh.edges["bottom"])
    stresses = calculix_stresses(directory, len(mesh.nodes))[bottom]
    assert not np.isnan(stresses).any(), "CalculiX gives a stress at every node of the bottom"
    maxima = {}
    for name, values in invariants(stresses).items():
        away = np.hypot(*(mesh.nodes[bottom] - near[name].place).T)
        best = np.argmax(np.where(away < load.radius / 2, values, -np.inf))
        maxima[name] = Maximum(values[best], mesh.nodes[bottom[best]])
    return maxima, len(mesh.triangles)


# The comparison


def geneva_maxima(program, case, changes):
    """Runs the case with the changes and takes the maxima of its wheel."""
    change_case(case, {"Output units": "SI", **changes})
    subprocess.run([program, "run", case], env=environment(), check=True, stdout=subprocess.DEVNULL)
    strength = read_summary(case / "results")["strength"]["wheel"]
    maxima = {}
    for name in STRESSES:
        entry = strength[name]
        if entry is None or entry["where"] != "bottom of the engaged slot":
            raise ValueError(f"{case.name}: the maximum {STRESSES[name]} stress is not at the engaged slot's bottom")
        place = np.array([MM * number(entry["place"][axis]) for axis in "xy"])
        maxima[name] = Maximum(number(entry) / 1e6, place, entry["error"])
    return maxima


HEADING = """                                      geneva                       CalculiX           difference of geneva
                                 default          at 0.2 %          h      h/2  change  default  at 0.2 %   apart
case                  stress     [MPa] +-[%]    [MPa] +-[%]    [MPa]    [MPa]     [%]      [%]       [%]  [% of r]"""


def compare(program, name, cells, directory):
    """Prints a case's rows; whether they are as close as they have to be."""
    case = directory / name
    shutil.copytree(ROOT / "cases" / name, case, ignore=shutil.ignore_patterns("results", ".results*"))
    default = geneva_maxima(program, case, {})
    fine = geneva_maxima(program, case, {"Structural accuracy": "0.2 %"})
    load = load_of(case)
    loops = wheel_loops(read_mechanism(case)["wheel"], load)
    (first, coarse_count), (second, fine_count) = (
        calculix_maxima(loops, load, fine, cells, scale, directory / f"{name}-{i}")
        for i, scale in enumerate((1.0, 0.5)))
    passed = True
    for key, title in STRESSES.items():
        peer = second[key].value
        change, off = peer / first[key].value - 1, fine[key].value / peer - 1
        passed = passed and abs(off) <= ALLOWED and abs(change) <= ALLOWED_CHANGE
        apart = math.dist(fine[key].place, second[key].place) / load.radius
        print(f"{name:21} {title:9} {default[key].value:7.3f} {100 * default[key].error:5.2f}  "
              f"{fine[key].value:7.3f} {100 * fine[key].error:5.2f}  {first[key].value:7.3f}  {peer:7.3f} "
              f"{100 * change:+7.3f}  {100 * (default[key].value / peer - 1):+7.3f}   {100 * off:+7.3f}    "
              f"{100 * apart:6.2f}", flush=True)
    print(f"{'':21} {coarse_count} and {fine_count} triangles of CalculiX", flush=True)
    return passed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--cases", nargs="+", default=CASES, metavar="NAME", help="of shipped cases")
    parser.add_argument("--cells", type=float, default=48.0, help="cells per radius of the bottom, on the coarser mesh")
    given = parser.parse_args()
    for tool, package in (("gmsh", "gmsh"), ("ccx", "calculix-ccx")):
        if not shutil.which(tool):
            sys.exit(f"{tool} is not there; it is in Debian's package {package}")
    print(HEADING)
    with tempfile.TemporaryDirectory(prefix="geneva-slot-") as name:
        passed = [compare(given.program.resolve(), case, given.cells, pathlib.Path(name)) for case in given.cases]
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
