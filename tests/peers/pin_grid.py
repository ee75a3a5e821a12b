#!/usr/bin/env python3
"""Whether `geneva estimate` finds the peak pressure of a pin in 3-D, beside a grid of Love's rectangles.

    tests/peers/pin_grid.py build/release/app/geneva
    tests/peers/pin_grid.py build/release/app/geneva --pins 5 --seed 4 --slenderness 10

Draws pins, runs `PROGRAM estimate` on each and solves the same contact again, with the same slow compliance along the
pin, but on a grid: even pressures on rectangles (Love 1929), convolved by FFT, and conjugate gradients that keep
pressure and gap from below zero (Polonsky and Keer 1999). So the grid has no sections, no Hertz and no Newton. It says
nothing on the slow compliance itself, beyond that it is what doc/theory.md says, and little on the images at the
faces, which a contact inside the wall hardly feels.

Prints a line for each pin whose contact ends inside the wall as the program says, with its differences from the grid
(places over the contact's length, line loads as root mean square over the greatest). Judged is the peak pressure of
    slender contacts: half-length over half-width a/b at least `--slenderness`, at their peak, too, beside which the
        pressure falls no faster than an ellipse of that length does,
    edge: contacts whose pressure on the grid is greatest at the wall's end or broken edge, where it has no bound;
exit code 1 if one differs by more than 0.2 %. Not judged are those that are sharp at their peak, at an end of a
logarithmic profile: its outline changes there within a sixth of a half-width, where no section is a line contact. The
program's peak is mostly too low then, by 10 to 30 %; the grid's is within 2 % of that of four times shorter rectangles.

The sections of the program are line contacts, whose peak it raises to that of an ellipse of the contact's length.

Needs numpy.
"""

import argparse
import csv
import dataclasses
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "benchmarks"))
import random_cases  # noqa: E402, puts tests/cli on the path
from geneva_cli import environment  # noqa: E402

ALLOWED = 2e-3
# Rectangles across the greatest half-width, fewest along the contact, their greatest length over the half-width, and
# most along the contact. Halving them changes the peak by less than 0.002 %, by pins of seed 1, in MPa:
#                                     as here     halved    quarters
#    4, crowned, a/b = 35             293.0684   293.0676    293.0675
#    8, logarithmic, a/b = 165        12.71816   12.71826
#   13, logarithmic, a/b = 276        230.3273   230.3296              (along by 1.75 only)
ACROSS, ALONG, LONGEST, MOST_ALONG = 16, 256, 0.5, 2500


@dataclasses.dataclass
class Pin:
    """A pin and the wall that it touches, in SI units; the force is told by the program."""
    radius: float
    pin: random_cases.Material
    wheel: random_cases.Material
    half: float  # of the wall
    root_gap: float
    overhang: float
    held_twice: bool
    crown: float = 0.0  # radius; 0: none
    profile_length: float = 0.0  # of the logarithm; 0: none
    profile_load: float = 0.0
    tilt: float = 0.0
    edge: str = "sharp"  # of the slot
    edge_size: float = 0.0
    wheel_twist: float = 0.0  # told by the program

    @property
    def modulus(self):
        return random_cases.contact_modulus((self.pin, self.wheel))

    @property
    def ends(self):
        return -self.half - (self.root_gap if self.held_twice else self.overhang), self.half + self.root_gap

    def half_width(self, line_load):
        """Hertz's."""
        return np.sqrt(4 * line_load * self.radius / (math.pi * self.modulus))

    def clearance(self, z):
        return self.outline(z) + self.edge_break(self.half - np.abs(z)) + z * math.tan(self.tilt)

    def outline(self, z):
        if self.crown:
            return self.crown - np.sqrt(self.crown**2 - z**2)
        # Johns and Gohar 1981; beyond its length along the tangent.
        amplitude = self.profile_load / (math.pi * self.profile_length * self.modulus)
        end = self.profile_length / 2
        relief = 1 - 0.3033 * self.half_width(self.profile_load / self.profile_length) / end
        along = np.abs(z) / end
        slope = 2 * relief / (1 - relief)
        return amplitude * (-np.log(1 - relief * np.minimum(along, 1)**2) + slope * np.maximum(along - 1, 0))

    def edge_break(self, inwards):
        left = np.maximum(self.edge_size - np.maximum(inwards, 0), 0)
        if self.edge == "rounded":
            return self.edge_size - np.sqrt(self.edge_size**2 - left**2)
        return left


# The pin's slow compliance, from doc/theory.md, "The pin in space without finite elements"


class Beam:
    """Timoshenko's, from where it is held on s = 0, by the shear force and the moment there."""

    def __init__(self, pin):
        nu = pin.pin.poissons_ratio
        area = math.pi * pin.radius**2
        self.shear_stiffness = pin.pin.modulus / (2 * (1 + nu)) * area
        self.kappa = 6 * (1 + nu) / (7 + 6 * nu)  # Cowper
        self.bending = pin.pin.modulus * area * pin.radius**2 / 4
        self.length = pin.ends[1] - pin.ends[0]
        self.held_twice = pin.held_twice

    def reactions(self, at):
        """Shear force and moment on s = 0 under the load 1 at `at`."""
        if not self.held_twice:
            return np.ones_like(at), at
        # They leave the far end without deflection and turn.
        reach = self.length
        unknown = np.array([self.path(reach, None, 1, 0), self.path(reach, None, 0, 1)]).T
        known = np.array(self.path(reach, at, 0, 0))
        return tuple(np.tensordot(-np.linalg.inv(unknown), known, 1))

    def path(self, s, at, shear, moment):
        """Deflection and turn at s by what acts on s = 0 and by the load 1 at `at`."""
        def by_force(x):
            return -x**3 / (6 * self.bending) + x / (self.kappa * self.shear_stiffness), -x**2 / (2 * self.bending)

        deflection, turn = (shear * part for part in by_force(s))
        deflection, turn = deflection + moment * s**2 / (2 * self.bending), turn + moment * s / self.bending
        if at is None:
            return deflection, turn
        beyond = by_force(np.maximum(s - at, 0))
        return deflection - beyond[0], turn - beyond[1]

    def deflection(self, s, at):
        return self.path(s, at, *self.reactions(at))[0]


def kernel_integral(poissons_ratio):
    """V(z), the integral of v from 0 to z, from the project's table: the kernel itself is not made again here."""
    text = (ROOT / "loads" / "pin" / "cylinder_kernel_table.h").read_text()
    rows = [[float(number) for number in row] for row in re.findall(r"\{(-?[\d.e+-]+), (-?[\d.e+-]+)\}", text)]
    ratios = (1 - np.cos(np.pi * np.arange(7) / 6)) / 4
    others = [np.delete(ratios, i) for i in range(7)]
    weights = [np.prod((poissons_ratio - other) / (ratio - other)) for ratio, other in zip(ratios, others)]
    values, slopes = np.tensordot(weights, np.array(rows).reshape(7, -1, 2), 1).T
    places = np.sinh(0.1 * np.arange(len(values))) / 4
    logarithm = (1 - 2 * poissons_ratio)**2 * (1 + poissons_ratio) / (4 * math.pi)

    def integral(z):
        size = np.maximum(np.abs(z), 1e-300)
        assert size.max() < places[-1], "the table ends at 34 radii"
        i = np.searchsorted(places, size, side="right") - 1
        width = places[i + 1] - places[i]
        x = (size - places[i]) / width
        smooth = ((1 + 2 * x) * (1 - x)**2 * values[i] + x**2 * (3 - 2 * x) * values[i + 1] +
                  width * x * (1 - x) * ((1 - x) * slopes[i] - x * slopes[i + 1]))
        return np.sign(z) * (smooth - logarithm * size * np.log(size / np.hypot(1, size)))

    return integral


def slow_compliance(pin, z, width):
    """M: displacement at the places z under a line load 1 on each of the rows around them."""
    nu = pin.pin.poissons_ratio
    beam = Beam(pin)
    generator = (7 - 8 * nu**2) / (6 * (1 + nu)**2)  # s: load and displacement on the same generator
    away = z[:, None] - z[None, :]
    shear = (1 / beam.kappa - generator) / (2 * beam.shear_stiffness) * np.abs(away)
    integral = kernel_integral(nu)
    local = integral((away + width / 2) / pin.radius) - integral((away - width / 2) / pin.radius)
    bending = beam.deflection(pin.ends[1] - z[:, None], pin.ends[1] - z[None, :])
    plate = slab_kernel(pin.wheel.poissons_ratio, z / pin.half) / (pin.wheel.modulus * 2 * pin.half)
    turned = pin.wheel_twist * z[:, None] * z[None, :]
    return width * (bending + shear + plate + turned) + local / pin.pin.modulus


def slab_kernel(poissons_ratio, places):
    """sum of k_ij P_i P_j at places over the half-thickness, from the project's table."""
    text = (ROOT / "loads" / "pin" / "slab_kernel_table.h").read_text()
    ratios = np.array([float(number) for number in re.search(r"slab_ratios\{([^}]*)\}", text)[1].split(",")])
    weights = [np.prod([(poissons_ratio - other) / (ratio - other) for other in ratios if other != ratio])
               for ratio in ratios]
    result = 0.0
    for first, name in enumerate(("slab_even", "slab_odd")):
        numbers = re.findall(r"-?\d+\.\d+", re.search(name + r"\{\{(.*?)\}\};", text, re.S)[1])
        table = np.tensordot(weights, np.array(numbers, float).reshape(len(ratios), -1), 1)
        size = math.isqrt(len(table))
        modes = np.array([np.polynomial.legendre.Legendre.basis(first + 2 * i)(places) for i in range(size)])
        result = result + modes.T @ table.reshape(size, size) @ modes
    return result


# The grid


def love(x, z, dx, dz):
    """Integral of 1/distance over a rectangle dx by dz around the origin, seen from (x, z) (Love 1929)."""
    def corner(a, b):
        return a * np.arcsinh(b / np.maximum(np.abs(a), 1e-300)) + b * np.arcsinh(a / np.maximum(np.abs(b), 1e-300))

    right, left, above, below = x + dx / 2, x - dx / 2, z + dz / 2, z - dz / 2
    return corner(right, above) - corner(left, above) - corner(right, below) + corner(left, below)


def fast_length(least):
    """Next number of factors 2, 3 and 5."""
    powers = (2**i * 3**j * 5**k for i in range(15) for j in range(6) for k in range(4))
    return min(number for number in powers if number >= least)


class Grid:
    """Rectangles between the places `window` along the pin and `reach` to both sides across it."""

    def __init__(self, pin, window, reach, shape):
        self.pin = pin
        self.shape = shape
        self.dx, self.dz = 2 * reach / shape[0], (window[1] - window[0]) / shape[1]
        self.x = (np.arange(shape[0]) + 0.5) * self.dx - reach
        self.z = (np.arange(shape[1]) + 0.5) * self.dz + window[0]
        self.gap = self.x[:, None]**2 / (2 * pin.radius) + pin.clearance(self.z)[None, :]
        self.slow = slow_compliance(pin, self.z, self.dz)
        self.padded = [fast_length(2 * n - 1) for n in shape]
        across, along = (np.arange(1 - n, n) for n in shape)
        x = across[:, None] * self.dx
        self.loads = self.transformed(love(x, along[None, :] * self.dz, self.dx, self.dz))
        # A load at z' has images at +-t - z', which only the wheel has; over the loads in reverse order that is a
        # convolution, too.
        sums = 2 * window[0] + (along[None, :] + shape[1]) * self.dz
        images = sum(love(x, sums - side * 2 * pin.half, self.dx, self.dz) for side in (-1, 1))
        nu = pin.wheel.poissons_ratio
        share = (1.29 - (0.08 - nu / 2) / (1 - nu)) * pin.wheel.compliance() * pin.modulus
        self.images = share * self.transformed(images)

    def transformed(self, kernel):
        wrapped = np.zeros(self.padded)
        wrapped[:kernel.shape[0], :kernel.shape[1]] = kernel / (math.pi * self.pin.modulus)
        return np.fft.rfft2(np.roll(wrapped, [1 - n for n in self.shape], (0, 1)))

    def line_loads(self, pressure):
        return pressure.sum(0) * self.dx

    def displacement(self, pressure):
        spectrum = np.fft.rfft2(pressure, self.padded) * self.loads
        spectrum += np.fft.rfft2(pressure[:, ::-1], self.padded) * self.images
        fast = np.fft.irfft2(spectrum, self.padded)[:self.shape[0], :self.shape[1]]
        return fast + (self.slow @ self.line_loads(pressure))[None, :]

    def solve(self, force, tolerance, most_steps=3000):
        """Pressures of Polonsky and Keer's method; the tolerance is that of their change in a step."""
        total = force / (self.dx * self.dz)
        pressure = np.full(self.shape, total / np.prod(self.shape))
        direction, before, conjugate = np.zeros(self.shape), 1.0, False
        for _ in range(most_steps):
            gap = self.displacement(pressure) + self.gap
            touching = pressure > 0
            gap -= gap[touching].mean()
            square = (gap[touching]**2).sum()
            direction = np.where(touching, gap + (square / before if conjugate else 0.0) * direction, 0.0)
            before = square
            answer = self.displacement(direction)
            answer -= answer[touching].mean()
            length = (gap * direction)[touching].sum() / (answer * direction)[touching].sum()
            changed = np.maximum(pressure - length * direction, 0.0)
            overlapping = (changed == 0) & (gap < 0)
            conjugate = not overlapping.any()
            changed[overlapping] -= length * gap[overlapping]
            changed *= total / changed.sum()
            change = np.abs(changed - pressure).sum() / total
            pressure = changed
            if change < tolerance:
                return pressure
        raise RuntimeError(f"no balance on the grid after {most_steps} steps, change {change:.2g}")


@dataclasses.dataclass
class Contact:
    """What is compared."""
    peak: float
    place: float
    begin: float
    end: float
    root_moment: float
    z: np.ndarray  # of the rows
    line_load: np.ndarray
    peak_reach: float = math.inf  # of the grid alone
    told_error: float = 0.0  # of the program alone

    @property
    def length(self):
        return self.end - self.begin


def contact_of(grid, pressure):
    loads = grid.line_loads(pressure)
    pin = grid.pin
    moment = (loads * Beam(pin).reactions(pin.ends[1] - grid.z)[1]).sum() * grid.dz
    top = row_peaks(grid, pressure, loads.max())
    place, peak = vertex(grid.z, top)
    return Contact(peak, place, end_of(grid.z, loads), end_of(grid.z[::-1], loads[::-1]), moment, grid.z, loads,
                   reach_of_peak(grid.z, top))


def row_peaks(grid, pressure, load):
    """Greatest pressure of every row: that of the ellipse through its rectangles in the middle."""
    middle = np.abs(grid.x) < 0.5 * grid.pin.half_width(load)
    shape = np.stack([np.ones(middle.sum()), grid.x[middle]**2], 1)
    return np.sqrt(np.maximum(np.linalg.lstsq(shape, pressure[middle]**2, rcond=None)[0][0], 0.0))


def around(values, share):
    """First and last row around the greatest value in which the values are more than this share of it."""
    top = int(np.argmax(values))
    low = np.flatnonzero(values < share * values[top])
    return max(low[low < top], default=-1) + 1, min(low[low > top], default=len(values)) - 1


def vertex(z, values):
    """Place and value of the top of the parabola through the greatest values, or of the greatest if that is no top."""
    top = int(np.argmax(values))
    if top in (0, len(z) - 1):
        return z[top], values[top]
    first, last = around(values, 0.998)
    first, last = min(first, top - 1), max(last, top + 1)
    scale = z[last] - z[first]
    curve, slope, value = np.polyfit((z[first:last + 1] - z[top]) / scale, values[first:last + 1], 2)
    return z[top] - slope / (2 * curve) * scale, value - slope**2 / (4 * curve)


def reach_of_peak(z, values):
    """Half-length of the ellipse that falls off beside its peak as fast as the pressure does on its steeper side: by a
    hundredth over sqrt(0.02) of its half-length."""
    first, last = around(values, 0.99)
    top = int(np.argmax(values))
    return (min(top - first, last - top) + 1) * (z[1] - z[0]) / math.sqrt(1 - 0.99**2)


def end_of(z, loads):
    """Where the load begins, seen from the first row: it rises as a parabola. The outermost rows are a few rectangles
    wide only, so that it is followed from where there are more."""
    peak = int(np.argmax(loads))
    seen = [i for i in range(peak + 1) if 0.02 * loads[peak] < loads[i] < 0.2 * loads[peak]]
    if len(seen) < 3:
        return z[int(np.argmax(loads > 0))] - (z[1] - z[0]) / 2
    origin, scale = z[seen[0]], z[seen[-1]] - z[seen[0]]
    roots = np.roots(np.polyfit((z[seen] - origin) / scale, loads[seen] / loads[peak], 2))
    return origin + scale * float(np.real(roots[np.argmin(np.abs(roots))]))


def grid_contact(pin, force, across=ACROSS, along=ALONG, longest=LONGEST):
    """The contact on the whole wall coarsely, then on a grid that fits it."""
    window, reach = (-pin.half, pin.half), 3 * pin.half_width(force / (2 * pin.half))
    while True:
        grid = Grid(pin, window, reach, (36, 96))
        pressure = grid.solve(force, 1e-4)
        if not pressure[[0, -1]].any():
            break
        reach *= 1.5
    loaded = grid.z[grid.line_loads(pressure) > 0]
    window = (max(loaded[0] - 1.5 * grid.dz, -pin.half), min(loaded[-1] + 1.5 * grid.dz, pin.half))
    half_width = pin.half_width(grid.line_loads(pressure).max())
    along = max(along, min(math.ceil((window[1] - window[0]) / (longest * half_width)), MOST_ALONG))
    rows = 2 * math.ceil(1.1 * across)
    while True:
        grid = Grid(pin, window, rows / (2 * across) * half_width, (rows, along))
        pressure = grid.solve(force, 1e-7)
        if not pressure[[0, -1]].any():
            return contact_of(grid, pressure)
        rows += across // 2


# Random pins


def draw_pin(draw):
    """A pin of a contact that mostly ends inside the wall, and the parameters of its case."""
    wheel = random_cases.draw_wheel(draw, "external", 10)
    wheel.thickness = wheel.pin * draw.between(0.6, 1.6)
    modulus = draw.by_factor(5e10, 4e11)
    wheel.materials = (random_cases.Material(modulus, draw.between(0.0, 0.49)),
                       random_cases.Material(modulus * draw.by_factor(0.1, 10.0), draw.between(0.0, 0.49)))
    pin = Pin(wheel.pin / 2, *wheel.materials, wheel.thickness / 2, wheel.pin * draw.by_factor(0.05, 2.0),
              wheel.pin * draw.between(0.05, 0.5), draw.chance(0.4))
    half_width = draw.by_factor(2e-3, 1e-2) * pin.radius
    force = math.pi / 4 * pin.modulus * half_width**2 / pin.radius * wheel.thickness
    further = [("Held at", "both ends" if pin.held_twice else "one end"),
               ("Root gap", draw.quantity(pin.root_gap, "length"))]
    if not pin.held_twice:
        further.append(("Overhang", draw.quantity(pin.overhang, "length")))
    further += draw_profile(draw, pin, force) + draw_edge(draw, pin)
    pin.tilt = draw.pick((0.0, 1.0)) * draw.between(-0.5, 0.5) * float(pin.outline(0.5 * pin.half)) / pin.half
    further.append(("Tilt", draw.quantity(pin.tilt, "angle")))
    wheel.clearance += 4 * wheel.thickness * abs(pin.tilt)  # clear of the other wall
    angle = draw.between(-0.9, 0.9) * wheel.engagement()
    parameters = random_cases.mechanism_parameters(draw, wheel, angle, force, [("Pin", further)])
    return pin, [("Title", "pin"), ("Dimension", 3), ("Output units", "SI"), *parameters]


def draw_profile(draw, pin, force):
    if draw.chance(0.6):
        pin.crown = random_cases.crown_for(force, pin.radius, pin.modulus, draw.between(0.3, 1.0) * pin.half)
        return [("Profile", "crown"), ("Crown radius", draw.quantity(pin.crown, "length"))]
    pin.profile_length = draw.between(0.8, 1.8) * pin.half
    pin.profile_load = draw.between(1.0, 2.5) * force
    return [("Profile", "logarithmic"), ("Profile length", draw.quantity(pin.profile_length, "length")),
            ("Profile load", draw.quantity(pin.profile_load, "force"))]


def draw_edge(draw, pin):
    pin.edge = draw.pick(("sharp", "chamfered", "rounded"))
    if pin.edge == "sharp":
        return []
    pin.edge_size = draw.between(0.01, 0.1) * pin.half
    return [("Slot edge", pin.edge), ("Slot edge size", draw.quantity(pin.edge_size, "length"))]


# The program's answer


def estimate(program, pin, parameters, directory):
    """The force and the contact that the program finds, None where it knows no peak."""
    directory.mkdir()
    (directory / "case.prm").write_text("\n".join(random_cases.lines_of(parameters)) + "\n")
    subprocess.run([program, "estimate", directory], env=environment(), check=True, stdout=subprocess.DEVNULL)
    answer = json.loads((directory / "results" / "estimate.json").read_text())
    force = answer["load"]["force"]["value"]
    found = answer.get("half_space_and_beam", {"peak_doubt": "stands in the slot's round bottom"})
    if found["peak_doubt"] != "none":
        return force, None
    pin.wheel_twist = found["wheel_twist"]["value"]
    with open(directory / "results" / "estimate.csv", newline="", encoding="utf-8") as stream:
        rows = [(float(row["z [m]"]), float(row["line load [N/m]"])) for row in csv.DictReader(stream)]
    names = ("peak_pressure", "peak_pressure_place", "begin", "end", "root_moment")
    return force, Contact(*(found[name]["value"] for name in names), *np.array(rows).T,
                          told_error=found["error_of_sections"])


def slenderness(pin, contact):
    return min(contact.length / 2, contact.peak_reach) / pin.half_width(contact.line_load.max())


def differences(found, grid):
    """Of the program's contact: of peak and root moment relative, of places over the contact's length, and the root
    mean square of the line loads over their greatest."""
    rest = found.line_load - np.interp(found.z, grid.z, grid.line_load, 0.0, 0.0)
    return (found.peak / grid.peak - 1, found.root_moment / grid.root_moment - 1, *(
        (getattr(found, name) - getattr(grid, name)) / grid.length for name in ("place", "begin", "end")),
            math.sqrt(np.mean(rest**2)) / grid.line_load.max())


def describe(index, pin, found, grid):
    profile = f"crown {pin.crown / pin.radius:.0f} R" if pin.crown else "logarithm"
    lean = f"{1e3 * pin.tilt:+.3f}" if pin.tilt else "0"
    off = [f"{100 * value:+8.3f}" for value in differences(found, grid)]
    return (f"{index:3}  {profile:13} {'both' if pin.held_twice else 'one':5} {lean:>7} {slenderness(pin, grid):6.1f} "
            f"{grid.peak / 1e6:8.1f} {100 * found.told_error:7.3f} {''.join(off)}")


HEADING = """                                                      told        difference from the grid [%]
pin  profile       held     tilt    a/b     peak   error     peak  moment   place   begin     end    load   time
                          [mrad]           [MPa]     [%]                                                    [s]"""


def judged(pin, force, least):
    """The contact on the grid, and what it is for the line contacts of the program: slender; sharp at its peak, where
    no line contact holds; or sharp where it reaches the wall's end or broken edge, where there is no peak at all."""
    grid = grid_contact(pin, force)
    if slenderness(pin, grid) < least:  # on long rectangles an end may look sharp that is not
        grid = grid_contact(pin, force, longest=LONGEST / 4)
    if slenderness(pin, grid) >= least:
        return grid, "slender"
    row = grid.z[1] - grid.z[0]
    end = np.abs(grid.z[grid.line_load > 0]).max() + row / 2
    return grid, "edge" if end > pin.half - pin.edge_size - row else "sharp"


def compare(program, given):
    """Relative differences of the peak pressure by the kind of contact, and what was left out."""
    peaks, index = {"slender": [], "edge": [], "sharp": []}, 0
    left_out = {"has no peak that the program knows": 0, "is too wide": 0}
    with tempfile.TemporaryDirectory(prefix="geneva-pin-") as name:
        while len(peaks["slender"]) < given.pins:
            pin, parameters = draw_pin(random_cases.Draw(f"geneva pin grid {given.seed} {index}"))
            force, found = estimate(program, pin, parameters, pathlib.Path(name) / str(index))
            index += 1
            if found is None or slenderness(pin, found) < given.slenderness:
                left_out["has no peak that the program knows" if found is None else "is too wide"] += 1
                continue
            start = time.monotonic()
            grid, kind = judged(pin, force, given.slenderness)
            peaks[kind].append(abs(found.peak / grid.peak - 1))
            print(f"{describe(index - 1, pin, found, grid)} {time.monotonic() - start:6.1f}  {kind}", flush=True)
    print("left out:", ", ".join(f"{count} whose contact {why}" for why, count in left_out.items()))
    return peaks


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--pins", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--slenderness", type=float, default=10.0, help="least half-length over half-width")
    given = parser.parse_args()
    print(HEADING)
    peaks = compare(given.program.resolve(), given)
    for kind, off in peaks.items():
        if off:
            print(f"{kind}: {len(off)} pins, difference of the peak {100 * statistics.median(off):.3f} % in the "
                  f"median, {100 * max(off):.3f} % at most{' (not judged)' if kind == 'sharp' else ''}")
    return 1 if max(peaks["slender"] + peaks["edge"]) > ALLOWED else 0


if __name__ == "__main__":
    sys.exit(main())
