"""Cases to be changed, by the kind of the change: small ones, since a mutant that is still a case is solved."""

import dataclasses
import functools
import pathlib
import sys

import mutations

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.append(str(HERE.parent / "cli"))
from geneva_cli import set_parameter  # noqa: E402


@dataclasses.dataclass
class Seed:
    """A case directory's files by name, and the one that is changed."""
    name: str
    files: dict
    changed: str
    commands: tuple = ("run",)
    has_limits: bool = True


def files_of(directory):
    return {file.name: file.read_bytes() for file in directory.iterdir()
            if file.suffix in (".prm", ".geo", ".msh", ".csv")}


def shipped(name, changes=None):
    """Files of a shipped case, with other parameters and without those that the limits set."""
    files = files_of(ROOT / "cases" / name)
    text = files["case.prm"].decode()
    for path, value in {**dict.fromkeys(("Accuracy", "Maximum unknowns")), **(changes or {})}.items():
        if value is not None or f"set {path.split('/')[-1]} " in text:
            text = set_parameter(text, path, value)
    return {**files, "case.prm": text.encode()}


def replaced(data, changes):
    for old, new in changes.items():
        if old not in data:
            raise KeyError(f"{old} is not there")
        data = data.replace(old, new)
    return data


# Geometries with fewer cells than the shipped ones
FEWER_CELLS = {
    "flat-patch": {b"7 + 1": b"2 + 1", b"3 + 1": b"1 + 1", b"9 + 1": b"3 + 1", b"4 + 1": b"1 + 1"},
    "flat-patch-3d": {b"nx = 7": b"nx = 2", b"ny = 3": b"ny = 1", b"nz = 4": b"nz = 1", b"nx = 9": b"nx = 3",
                      b"ny = 4": b"ny = 1", b"nz = 5": b"nz = 2"},
    "hertz-line-contact": {b"= 6 + 1": b"= 4 + 1", b"16 + 1": b"6 + 1", b"8 + 1": b"3 + 1"},
}


def drawn(name):
    files = shipped(name)
    return {**files, "geometry.geo": replaced(files["geometry.geo"], FEWER_CELLS.get(name, {}))}


def mechanism(name, changes=None):
    """A shipped mechanism; most of what its case file can cause needs no finite elements."""
    commands = ("run", "run", "kinematics", "design")
    return Seed(name, shipped(name, changes), "case.prm", commands)


def in_space(name):
    """A mechanism with its pin in 3-D, whose first mesh costs what many other mutants do."""
    return Seed(name, shipped(name), "case.prm", ("run", "kinematics", "kinematics", "design"))


def geometry_case(name):
    return Seed(name, drawn(name), "case.prm")


def linkage(name):
    return Seed(name, shipped(name), "case.prm", ("synthesize",), has_limits=False)


def points():
    """Of a linkage; only the points are changed, since a million starts may be asked for."""
    files = shipped("synthesis-nine-points", {"Synthesis/Starts": "5"})
    return Seed("synthesis-nine-points", files, "points.csv", ("synthesize",), has_limits=False)


def motion_table():
    changes = {"Mechanism/Driver motion": "table", "Mechanism/Motion table": "motion.csv", "Mechanism/Motion time": None}
    rows = [f"{angle / 2160:.6g}, {angle}" for angle in range(-180, 181, 30)]
    table = "\n".join(["time [s], angle [deg]", *rows, ""]).encode()
    files = {**shipped("servo-harmonic", changes), "motion.csv": table}
    return Seed("motion table", files, "motion.csv", ("kinematics",))


def geometry(name):
    return Seed(name, drawn(name), "geometry.geo")


def mesh(file):
    """The case flat-patch or flat-patch-3d with a mesh of its blocks."""
    files = shipped("flat-patch-3d" if file.name.startswith("space") else "flat-patch", {"Geometry/File": "geometry.msh"})
    del files["geometry.geo"]
    return Seed(file.name, {**files, "geometry.msh": file.read_bytes()}, "geometry.msh")


def damaged_mesh(directory):
    """A mesh that Gmsh crashed on; the limit of unknowns that its case file has goes."""
    files = files_of(directory)
    case = set_parameter(files["case.prm"].decode(), "Maximum unknowns", None)
    return Seed(f"damaged mesh {directory.name}", {**files, "case.prm": case.encode()}, "geometry.msh")


def is_binary(content):
    return content[content.index(b"\n"):][:8].split()[1] == b"1"


def meshes(binary):
    """What draws meshes in text or binary files."""
    whole = [file for file in sorted((HERE / "corpus" / "mesh_file").glob("*.msh"))
             if file.name.startswith(("plane", "space")) and is_binary(file.read_bytes()) == binary]
    # Those with a number; others come to the corpus later and must not make other mutants of the same numbers.
    damaged = [directory for directory in sorted((HERE / "corpus" / "damaged-meshes").glob("[0-9]*"))
               if is_binary((directory / "geometry.msh").read_bytes()) == binary]
    # twice as often the whole ones, which get further
    return [functools.partial(mesh, file) for file in 2 * whole] + [functools.partial(damaged_mesh, directory)
                                                                    for directory in damaged]


def drawers(draw, *names):
    return [functools.partial(draw, name) for name in names]


CASES = [*drawers(mechanism, "johnson-optimum-wheel", "six-station-360rpm", "irregular-two-pin", "servo-harmonic",
                  "internal-six-station", "spherical-eight-station", "long-dwell", "four-bar-geneva"),
         *drawers(in_space, "crowned-pin", "tilted-pin"),
         *drawers(geometry_case, "flat-patch", "hertz-line-contact", "hertz-sphere", "flat-patch-3d", "flat-patch",
                  "hertz-line-contact", "hertz-sphere"),
         *drawers(linkage, "synthesis-quick-return", "synthesis-crank-rocker"), points, motion_table]
GEOMETRIES = drawers(geometry, "flat-patch", "flat-patch", "flat-patch-3d", "hertz-line-contact", "hertz-sphere")

# What is changed how, and what draws the seeds.
KINDS = {"case file": (mutations.CASE, CASES),
         "geometry": (mutations.GEOMETRY, GEOMETRIES),
         "mesh in text": (mutations.MESH_TEXT, meshes(binary=False)),
         "binary mesh": (mutations.MESH_BINARY, meshes(binary=True))}
