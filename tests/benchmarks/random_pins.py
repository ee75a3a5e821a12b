#!/usr/bin/env python3
"""How well line contacts along a pin (doc/theory.md, 2.4) agree with finite elements, on random pins in space.

    python3 tests/benchmarks/random_pins.py build/release/app/geneva --seeds 2..80 --only even --output pins.csv
    python3 tests/benchmarks/random_pins.py build/release/app/geneva --seeds 7..7 --accuracy "0.3 %" --output more.csv
    python3 tests/benchmarks/random_pins.py build/release/app/geneva --seeds 2..80 --only even --output pins.csv --again

Pin i is always the same. Each is run by finite elements at the accuracy asked for and estimated without them. FILE.csv
gains a row when a pin is done, and pins whose rows it has are left out; FILE-cases holds the case directories, to be
run by hand, with the small results of both. A row is known by the pin's text: to run with other limits or another
program take another file. --again estimates again and keeps the finite elements' results.

Judged are pins whose contact ends within the wall by the model, which says nothing of the peak of others, and whose run
has the pin force as its contact force, or they touch elsewhere, too:

- peak pressure: within 1 % beyond the error that the run reports;
- root stress: the same;
- place of the peak: within 2 % of the contact's length. The run reports the node with the maximum pressure, which on a
  flat maximum may be some nodes off; judged is the vertex of a parabola through the line loads above 0.7 of their
  maximum, found alike of both. A logarithmic profile has its maxima beside its ends: there the node is judged, and
  without a tilt, where both ends are alike, its distance from the middle.

What would explain a difference stands in the table and is not taken off: the error of the model's sections, and "arm",
the wheel's depth behind the contact over its thickness.
"""

import argparse
import csv
import hashlib
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import random_cases  # puts tests/cli on the path
from error_bar import percent, read_accuracy, share, table
from geneva_cli import environment, number, read_csv, read_summary
from random_cases import Draw, Material, contact_modulus, crown_for

# Odd in number, so that odd and even seeds see all kinds alike.
KINDS = ("crown", "tilt", "both ends", "logarithm", "edge", "slender", "both ends, tilt")
COLOURS = dict(zip(KINDS, ("#3566a8", "#c03a2b", "#3a8f4d", "#8a4fa3", "#777777", "#d98a1f", "#1f9fa8")))

# Judgement, relative: of the peak and the root stress beyond the run's own error, of the place over the length.
PEAK, ROOT, PLACE, DEFLECTION = 0.01, 0.01, 0.02, 0.03

KEPT = ("summary.json", "sections.csv", "estimate.json", "estimate.csv")


# Pins


class Pin:
    """A case of a pin in space with what it was drawn from."""

    def __init__(self, seed):
        self.name, self.kind = f"pin-{seed}", KINDS[seed % len(KINDS)]
        draw = Draw(f"geneva random pin {seed}")
        self.wheel = draw_wheel(draw, self.kind)
        self.force = random_cases.draw_pin_force(draw, self.wheel, 6e-3)
        self.angle = draw.pick((-1, 1)) * draw.between(beyond_bottom(self.wheel), 0.95 * self.wheel.engagement())
        self.held, self.gap, self.overhang = draw_lengths(draw, self.kind, self.wheel.pin)
        self.profile, self.tilt = draw_profile(draw, self)
        self.wheel.clearance += 2 * self.wheel.thickness * abs(self.tilt)  # clear of the other wall
        self._parameters = random_cases.mechanism_parameters(draw, self.wheel, self.angle, self.force,
                                                             [("Pin", self._pin_parameters(draw))])

    def text(self, accuracy, limits=()):
        """Of case.prm."""
        parameters = [("Output units", "SI"), ("Dimension", 3), *self._parameters]
        return random_cases.Case(self.name, self.kind, parameters).files(accuracy, limits)["case.prm"]

    def inputs(self):
        """What tells pins apart, lengths over the pin's diameter."""
        pin, wheel = self.wheel.materials
        diameter = self.wheel.pin
        arm = arm_behind(self.wheel, self.angle) / self.wheel.thickness
        profile = dict(self.profile)
        return {"stations": self.wheel.stations, "held": self.held, "profile": profile["Profile"],
                "diameter [m]": diameter, "thickness": self.wheel.thickness / diameter, "gap": self.gap / diameter,
                "overhang": self.overhang / diameter,
                "profile size": profile.get("Crown radius", profile.get("Profile length", 0.0)) / diameter,
                "tilt [rad]": self.tilt, "pin's modulus [Pa]": pin.modulus,
                "ratio of moduli": pin.modulus / wheel.modulus, "nu of pin": pin.poissons_ratio,
                "nu of wheel": wheel.poissons_ratio, "angle [rad]": self.angle, "arm over thickness": arm,
                "even half-width over radius": even_half_width(self) / (diameter / 2)}

    def _pin_parameters(self, draw):
        entries = [("Held at", self.held), ("Root gap", draw.quantity(self.gap, "length"))]
        if self.held == "one end":
            entries.append(("Overhang", draw.quantity(self.overhang, "length")))
        entries += [(name, value if isinstance(value, str) else draw.quantity(value, "length"))
                    for name, value in self.profile]
        return entries + ([("Tilt", draw.quantity(self.tilt, "angle"))] if self.tilt else [])


def even_half_width(pin):
    """Of a contact that carries evenly over the wheel's thickness."""
    load = pin.force / pin.wheel.thickness
    return math.sqrt(4 * load * pin.wheel.pin / 2 / (math.pi * contact_modulus(pin.wheel.materials)))


# Johnson 1956, Table 1: k4 for 3 to 10 stations.
LOCKING = (0.70, 0.35, 0.24, 0.17, 0.13, 0.10, 0.08, 0.08)


def arm_behind(wheel, angle):
    """How deep the wheel is behind the place of contact: to the locking arc, the next slot or the rim."""
    n, slope = wheel.stations, math.pi / wheel.stations
    x, half_slot = wheel.reach(angle)[0], (wheel.pin + wheel.clearance) / 2
    shrunk = min(1.0, math.sin(slope) / math.sin(math.pi / 10))
    centre, radius = wheel.diameter / 2 / math.cos(slope), LOCKING[min(n, 10) - 3] * shrunk * wheel.diameter
    ends = [math.sqrt(max(wheel.diameter**2 / 4 - x**2, 0.0))]
    aside = x - centre * math.cos(slope)
    if abs(aside) < radius:
        ends.append(centre * math.sin(slope) - math.sqrt(radius**2 - aside**2))
    if n > 4:
        ends.append((x * math.sin(2 * slope) - half_slot) / math.cos(2 * slope))
    return min(ends) - half_slot


def draw_wheel(draw, kind):
    """An external wheel; moduli in the ratio 0.1 to 10, Poisson's ratios from 0 to 0.45."""
    wheel = random_cases.draw_wheel(draw, "external", 12)
    modulus = draw.by_factor(2e9, 4e11)
    wheel.materials = (Material(modulus, draw.between(0.0, 0.45)),
                       Material(modulus / draw.by_factor(0.1, 10.0), draw.between(0.0, 0.45)))
    wheel.thickness = wheel.pin * (draw.between(0.6, 1.0) if kind == "slender" else draw.between(0.6, 2.0))
    return wheel


def beyond_bottom(wheel):
    """Least driver angle at which the pin touches a tenth of its diameter beyond the slot's round bottom."""
    low, high = 0.0, wheel.engagement()
    for _ in range(60):
        middle = (low + high) / 2
        is_beyond = wheel.reach(middle)[0] > wheel.reach(0.0)[0] + 0.1 * wheel.pin
        low, high = (low, middle) if is_beyond else (middle, high)
    return high


def draw_lengths(draw, kind, diameter):
    """How the pin is held, its root gap and its overhang."""
    held = "both ends" if kind.startswith("both") else "one end"
    if kind in ("logarithm", "edge"):
        held = draw.pick(("one end", "both ends"))
    gap = draw.between(0.7, 2.0) if kind == "slender" else draw.between(0.1, 0.5)
    overhang = 0.0 if held == "both ends" else draw.between(0.1, 0.5)
    return held, gap * diameter, overhang * diameter


def draw_profile(draw, pin):
    """The profile's parameters, and the tilt.

    Crowns are those whose contact on a stiff pin has a part of the wall's length, a tilt moves it within the rest.
    """
    wheel = pin.wheel
    modulus, half = contact_modulus(wheel.materials), wheel.thickness / 2
    if pin.kind == "logarithm":
        length = draw.between(0.5, 0.85) * wheel.thickness
        fall = pin.force / (math.pi * length * modulus)  # the profile's factor A
        tilt = draw.between(-1.0, 1.0) * fall / (length / 2) if draw.chance(0.5) else 0.0
        return [("Profile", "logarithmic"), ("Profile length", length)], tilt
    if pin.kind == "edge" and draw.chance(0.3):
        return [("Profile", "cylindrical")], 0.0
    part = {"edge": (1.1, 2.0), "crown": (0.35, 0.85), "both ends": (0.35, 0.85)}.get(pin.kind, (0.3, 0.6))
    length = draw.between(*part)
    crown = crown_for(pin.force, wheel.pin / 2, modulus, length * half)
    crown = max(crown, 1.01 * (half + max(pin.gap, pin.overhang)))  # it spans the pin
    moved = draw.pick((-1, 1)) * draw.between(0.2, 0.9) * (1 - length) * half
    return [("Profile", "crown"), ("Crown radius", crown)], moved / crown if "tilt" in pin.kind else 0.0


# Running


class Runner:
    """Runs pins by finite elements and without them."""

    def __init__(self, arguments):
        self._program = pathlib.Path(arguments.program).resolve()
        if not self._program.is_file():
            sys.exit(f"random_pins: there is no program {self._program}")
        self._accuracy, self._time_limit = arguments.accuracy, arguments.time_limit
        self._limits = [("Maximum time", f"{arguments.time_limit:g} s"), ("Maximum unknowns", arguments.unknowns)]
        self._cases = arguments.output.with_name(arguments.output.stem + "-cases")

    def key(self, pin):
        return hashlib.sha256(pin.text(self._accuracy).encode()).hexdigest()[:16]

    def run(self, pin):
        """The row of a pin."""
        case = self._cases / pin.name
        case.mkdir(parents=True, exist_ok=True)
        (case / "case.prm").write_text(pin.text(self._accuracy, self._limits))
        begin = time.perf_counter()
        with tempfile.TemporaryDirectory(prefix="geneva-random-pins-") as results:
            kept = case / "kept"
            shutil.rmtree(kept, ignore_errors=True)
            kept.mkdir()
            codes = [self._call(command, case, results) for command in ("run", "estimate")]
            for name in KEPT:
                if (pathlib.Path(results) / name).exists():
                    shutil.copy(pathlib.Path(results) / name, kept)
        row = {"pin": pin.name, "kind": pin.kind, "key": self.key(pin), "code": codes[0][0],
               "seconds": time.perf_counter() - begin, "message": codes[0][1] or codes[1][1]}
        figures = figures_of(kept) if all((kept / name).exists() for name in KEPT) else {}
        return {**row, **dict.fromkeys(FIGURES), **figures, **pin.inputs()}

    def again(self, pin, row):
        """The row with the model's figures made anew."""
        case = self._cases / pin.name
        kept = case / "kept"
        if not all((kept / name).exists() for name in KEPT):
            return row
        with tempfile.TemporaryDirectory(prefix="geneva-random-pins-") as results:
            self._call("estimate", case, results)
            for name in ("estimate.json", "estimate.csv"):
                shutil.copy(pathlib.Path(results) / name, kept)
        return {**row, **figures_of(kept)}

    def _call(self, command, case, results):
        """Exit code or "time", and the first line on stderr."""
        limit = 3 * self._time_limit + 60  # mesh and evaluation come on top of the solver's time
        try:
            run = subprocess.run([self._program, command, case, "--output", results], env=environment(), text=True,
                                 stdin=subprocess.DEVNULL, capture_output=True, timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return "time", f"did not end within {limit:g} s"
        return run.returncode, run.stderr.strip().split("\n")[0][:200]


# Figures of a pin: by finite elements, their reported error, and by the model.
FIGURES = ("inside", "failed checks", "force", "unknowns", "peak", "peak error", "model's peak", "place",
           "fitted place", "model's place", "model's fitted place", "length", "model's length", "root stress",
           "root stress error", "model's root stress", "deflection", "deflection error", "model's deflection",
           "middle load", "reported middle load", "model's middle load", "edge pressure", "error of sections",
           "model's edge")


def figures_of(kept):
    summary, estimate = read_summary(kept), json.loads((kept / "estimate.json").read_text())
    sections, lines = read_csv(kept / "sections.csv"), read_csv(kept / "estimate.csv")
    contact, pin, model = summary["contact"], summary["pin"], estimate["half_space_and_beam"]
    is_inside = model["peak_doubt"] == "none"
    places, loads = lines["z [m]"], lines["line load [N/m]"]
    failed = [check["name"] for check in summary["checks"] if not check["passed"] and check["name"] != "convergence"]
    return {"inside": int(is_inside), "failed checks": " and ".join(failed),
            "force": number(contact["force"]) / number(summary["load"]["force"]), "unknowns": summary["mesh"]["dofs"],
            "peak": number(contact["peak_pressure"]), "peak error": contact["peak_pressure_error"],
            "model's peak": number(model["peak_pressure"]), "place": number(contact["peak_pressure_place"]["z"]),
            "fitted place": vertex(sections["z [m]"], sections["line_load [N/m]"]),
            "model's place": number(model["peak_pressure_place"]), "model's fitted place": vertex(places, loads),
            "length": 2 * number(contact["half_length"]),
            "model's length": number(model["end"]) - number(model["begin"]),
            "root stress": number(pin["root_stress"]), "root stress error": pin["root_stress_error"],
            "model's root stress": number(model["root_stress"]),
            "deflection": number(pin["tip_deflection"]), "deflection error": pin["tip_deflection_error"],
            "model's deflection": number(model["deflection"]),
            "middle load": load_at(sections["z [m]"], sections["line_load [N/m]"], 0.0),
            "reported middle load": number(summary["line_load"]["middle"]),
            "model's middle load": load_at(places, loads, 0.0),
            "edge pressure": number(contact["edge"]["pressure"]), "error of sections": model["error_of_sections"],
            "model's edge": int(model["peak_doubt"] == "reaches the edge")}


def load_at(places, loads, z):
    """Line load at a place by a straight line between two sections; 0 beyond them."""
    for i in range(1, len(places)):
        if places[i - 1] <= z <= places[i]:
            part = (z - places[i - 1]) / (places[i] - places[i - 1])
            return (1 - part) * loads[i - 1] + part * loads[i]
    return 0.0


def vertex(places, loads):
    """Where the parabola of least squares through the loads around their maximum has its own, or that of the loads."""
    top = max(range(len(loads)), key=loads.__getitem__)
    first, last = top, top
    while first > 0 and loads[first - 1] > 0.7 * loads[top]:
        first -= 1
    while last + 1 < len(loads) and loads[last + 1] > 0.7 * loads[top]:
        last += 1
    if last - first < 3:
        return places[top]
    scale = places[last] - places[first]
    xs = [(z - places[top]) / scale for z in places[first:last + 1]]
    sums = [sum(x**power for x in xs) for power in range(5)]
    right = [sum(load / loads[top] * x**power for x, load in zip(xs, loads[first:last + 1])) for power in range(3)]
    matrix = [[sums[i + j] for j in range(3)] + [right[i]] for i in range(3)]
    _, slope, curve = solved(matrix)
    x = -slope / (2 * curve) if curve < 0 else 0.0
    return places[top] + scale * min(max(x, xs[0]), xs[-1])


def solved(matrix):
    """Solution of a small symmetric system with its right side as the last column."""
    n = len(matrix)
    for i in range(n):
        for k in range(n):
            if k != i:
                factor = matrix[k][i] / matrix[i][i]
                matrix[k] = [a - factor * b for a, b in zip(matrix[k], matrix[i])]
    return [matrix[i][n] / matrix[i][i] for i in range(n)]


# Judging


class Verdict:
    """Differences of the model from finite elements."""

    def __init__(self, row):
        self.row = row
        self.has_figures = row["peak"] is not None
        self.is_valid = self.has_figures and abs(row["force"] - 1) < 1e-3
        self.judged = self.is_valid and row["inside"] == 1
        if not self.has_figures:
            return
        self.peak = row["model's peak"] / row["peak"] - 1
        self.bar = row["peak error"]
        self.root = row["model's root stress"] / row["root stress"] - 1
        self.root_bar = row["root stress error"]
        self.node_place = place_difference(row, "place")
        self.place = self.node_place if row["profile"] == "logarithmic" else place_difference(row, "fitted place")
        self.length = row["model's length"] / row["length"] - 1
        self.deflection = row["model's deflection"] / row["deflection"] - 1
        self.deflection_bar = row["deflection error"] or 0.0
        self.middle = row["model's middle load"] / row["middle load"] - 1 if row["middle load"] else None

    def missed(self):
        """Names of the figures beyond their bounds."""
        found = {"peak": abs(self.peak) - (self.bar or 0.0) > PEAK,
                 "root": abs(self.root) - (self.root_bar or 0.0) > ROOT,
                 "place": abs(self.place) > PLACE}
        return [name for name, is_missed in found.items() if is_missed]


def place_difference(row, which):
    """Over the contact's length; of a pin whose ends nothing tells apart, of the distances from the middle."""
    places = [row[f"{of}{which}"] for of in ("model's ", "")]
    if row["held"] == "both ends" and row["tilt [rad]"] == 0:
        places = [abs(place) for place in places]
    return (places[0] - places[1]) / row["model's length"]


def pin_table(verdicts):
    rows = [("pin", "kind", "code", "time [s]", "bar [%]", "peak [%]", "over bar", "sections [%]",
             "place [%]", "of node", "length [%]", "root [%]", "+-", "deflection [%]", "middle [%]", "arm", "")]
    for v in verdicts:
        row = (v.row["pin"], v.row["kind"], str(v.row["code"]), f"{v.row['seconds']:.0f}")
        if not v.has_figures:
            rows.append((*row, *("-",) * 12, v.row["message"]))
            continue
        note = ", ".join(v.missed()) if v.judged else "reaches the edge" if v.is_valid else "not the pin force"
        over = f"{abs(v.peak) / v.bar:.2f}" if v.bar else "-"
        rows.append((*row, percent(v.bar), percent(v.peak, True), over, percent(v.row["error of sections"]),
                     *(percent(value, True) for value in (v.place, v.node_place, v.length, v.root)),
                     percent(v.root_bar), percent(v.deflection, True), percent(v.middle, True),
                     f"{v.row['arm over thickness']:.2f}", note))
    return table(rows)


def spread(values):
    """Median, 95th percentile and worst of the sizes, in per cent."""
    sizes = sorted(abs(value) for value in values if value is not None)
    if not sizes:
        return "-"
    high = sizes[math.ceil(0.95 * len(sizes)) - 1]
    return "  ".join(f"{100 * value:.2f}" for value in (statistics.median(sizes), high, sizes[-1]))


def kind_table(verdicts):
    rows = [("kind", "", "pins", "peak [%]", "place [%]", "length [%]", "root stress [%]", "middle load [%]",
             "peak held", "place held", "root held")]
    for kind in (*KINDS, "all"):
        own = [v for v in verdicts if v.judged and kind in (v.row["kind"], "all")]
        if own:
            rows.append((kind, "", str(len(own)), *(spread(getattr(v, name) for v in own)
                                                    for name in ("peak", "place", "length", "root", "middle")),
                         *(share(sum(name not in v.missed() for v in own), len(own))
                           for name in ("peak", "place", "root"))))
    return "sizes of the differences: median, 95th percentile, worst\n" + table(rows)


def summary_lines(verdicts):
    judged = [v for v in verdicts if v.judged]
    failed = [f"{v.row['pin']} ({v.row['failed checks']})" for v in verdicts
              if v.has_figures and v.row["failed checks"]]
    others = [v.row["pin"] for v in verdicts if v.has_figures and not v.is_valid]
    lines = [f"pins: {len(verdicts)}, judged: {len(judged)}; without figures: "
             f"{sum(not v.has_figures for v in verdicts)}",
             f"finite elements with another force than the pin's: {', '.join(others) or 'none'}",
             f"that fail their own checks of balance: {', '.join(failed) or 'none'}"]
    if judged:
        bars = [v for v in judged if v.bar]
        ratios = [abs(v.peak) / v.bar for v in bars]
        plain = sum(abs(v.peak) <= PEAK for v in judged)
        cantilevers = [v for v in judged if v.row["held"] == "one end"]
        bent = sum(abs(v.deflection) - v.deflection_bar <= DEFLECTION for v in cantilevers)
        lines += [f"peak: mean difference {percent(statistics.mean(v.peak for v in judged), True)} %; plainly within "
                  f"{100 * PEAK:g} %: {share(plain, len(judged))}; within the run's own error: "
                  f"{share(sum(ratio <= 1 for ratio in ratios), len(bars))}",
                  f"difference over the run's own error: median {statistics.median(ratios):.2f}, "
                  f"worst {max(ratios):.2f}",
                  "place of the node with the maximum pressure, over the length: median, 95th percentile and worst "
                  f"{spread(v.node_place for v in judged)} %",
                  f"root stress plainly within {100 * ROOT:g} %: "
                  f"{share(sum(abs(v.root) <= ROOT for v in judged), len(judged))}",
                  f"deflection of pins held at one end within {100 * DEFLECTION:g} % beyond the run's own error: "
                  f"{share(bent, len(cantilevers))}",
                  f"runs that met a limit: {sum(v.row['code'] != 0 for v in judged)} of {len(judged)}"]
        reached = [v for v in judged if v.row["code"] == 0]
        plain = sum(abs(v.peak) <= PEAK for v in reached)
        lines.append(f"peak plainly within {100 * PEAK:g} % where the run reached its accuracy: "
                     f"{share(plain, len(reached))}")
    whole = [v for v in verdicts if v.is_valid]
    alike = sum((v.row["edge pressure"] > 0) == (v.row["model's edge"] == 1) for v in whole)
    lines.append(f"whether the contact reaches the edge is told alike in {share(alike, len(whole))}")
    wrong = [v.row["pin"] for v in whole
             if abs(v.row["reported middle load"] - v.row["middle load"]) > 0.01 * v.row["middle load"]]
    lines.append("line_load.middle of summary.json is not that of sections.csv at z = 0, by more than 1 %: "
                 f"{', '.join(wrong) or 'nowhere'}")
    at_edge = [v for v in whole if not v.judged]
    if at_edge:
        lines.append(f"where the contact reaches the edge: root stress {spread(v.root for v in at_edge)} %, load "
                     f"in the middle {spread(v.middle for v in at_edge)} % off (median, 95th percentile, worst)")
    return "\n".join(lines)


def short_text(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def outliers(verdicts):
    lines = []
    for v in verdicts:
        if v.judged and v.missed():
            inputs = ", ".join(f"{name} {short_text(v.row[name])}" for name in INPUTS)
            lines.append(f"{v.row['pin']} ({v.row['kind']}): {', '.join(v.missed())}\n  {inputs}")
    return "outliers:\n" + ("\n".join(lines) or "none")


# Picture

LEFT, TOP, WIDTH, HEIGHT = 62, 34, 420, 320
RIGHT = LEFT + WIDTH


def picture(verdicts):
    """Sizes of the peak's difference over the run's own error, both logarithmic; rings where the model is lower."""
    points = [(v, v.bar, max(abs(v.peak), LEAST)) for v in verdicts if v.judged and v.bar]
    across, up = Axis([x for _, x, _ in points], LEFT, WIDTH), Axis([y for _, _, y in points], TOP + HEIGHT, -HEIGHT)
    low, high = max(across.low, up.low), min(across.high, up.high)
    grey = '<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" stroke="#bbbbbb"/>'
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{RIGHT + 130}" height="{TOP + HEIGHT + 46}" '
             'font-family="sans-serif" font-size="11">', '<rect width="100%" height="100%" fill="white"/>',
             grey.format(across.at(low), up.at(low), across.at(high), up.at(high)),
             grey.format(LEFT, up.at(PEAK), RIGHT, up.at(PEAK)),
             f'<path d="M{LEFT} {TOP} V{TOP + HEIGHT} H{RIGHT}" fill="none" stroke="black"/>']
    parts += [text(across.at(value), TOP + HEIGHT + 15, f"{100 * value:g}") for value in across.decades()]
    parts += [text(LEFT - 5, up.at(value) + 4, f"{100 * value:g}", "end") for value in up.decades()]
    for v, x, y in points:
        parts.append(mark(across.at(x), up.at(y), v.row["kind"], v.peak > 0))
    kinds = [kind for kind in KINDS if any(v.row["kind"] == kind for v, _, _ in points)]
    for row, kind in enumerate(kinds):
        parts += [mark(RIGHT + 18, TOP + 6 + 17 * row, kind, True),
                  text(RIGHT + 27, TOP + 10 + 17 * row, kind, "start")]
    held = share(sum("peak" not in v.missed() for v, _, _ in points), len(points))
    middle = TOP + HEIGHT / 2
    parts += [f'<g font-size="13">{text(LEFT + WIDTH / 2, 18, f"peak held in {held}")}</g>',
              text(LEFT + WIDTH / 2, TOP + HEIGHT + 34, "reported error of the finite elements [%]"),
              f'<g transform="rotate(-90 14 {middle:g})">'
              f'{text(14, middle, "difference of the line contacts [%]; rings: lower")}</g>', "</svg>"]
    return "\n".join(parts) + "\n"


LEAST = 1e-4  # smaller differences are drawn there


class Axis:
    """A logarithmic one around some values, from a start over an extent in pixels."""

    def __init__(self, values, start, extent):
        self.low, self.high = min([PEAK, *values]) / 1.3, max([PEAK, *values]) * 1.3
        self._start, self._extent = start, extent

    def at(self, value):
        return self._start + self._extent * math.log(value / self.low) / math.log(self.high / self.low)

    def decades(self):
        return [10.0**power for power in range(-5, 2) if self.low <= 10.0**power <= self.high]


def text(x, y, content, anchor="middle"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{content}</text>'


def mark(x, y, kind, is_filled):
    colour = COLOURS[kind]
    return (f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" stroke="{colour}" stroke-width="1.5" '
            f'fill="{colour if is_filled else "white"}"/>')


# Command line


def read_seeds(text):
    """Seeds from FIRST..LAST."""
    try:
        first, last = map(int, text.split(".."))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no range of seeds such as 1..40") from None
    if not 0 <= first <= last:
        raise argparse.ArgumentTypeError(f"'{text}' holds no seed: give the lower one first")
    return range(first, last + 1)


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--seeds", type=read_seeds, default="1..40", help="FIRST..LAST (default: 1..40)")
    parser.add_argument("--only", choices=("odd", "even"), help="seeds: one half to tune on, the other to check")
    parser.add_argument("--accuracy", type=read_accuracy, default="1 %", help="of the finite elements (default: 1 %%)")
    parser.add_argument("--time-limit", type=float, default=120.0, help="of a solve, s")
    parser.add_argument("--unknowns", type=int, default=2000000, help="limit of a run")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("random-pins.csv"))
    parser.add_argument("--picture", type=pathlib.Path, help="FILE.svg of the peak's difference and the reported error")
    parser.add_argument("--again", action="store_true", help="estimate again, finite elements are kept")
    parser.add_argument("--draw-only", action="store_true", help="print what is drawn and run nothing")
    return parser.parse_args()


INPUTS = tuple(Pin(1).inputs())
COLUMNS = ("pin", "kind", "key", "code", "seconds", "message", *FIGURES, *INPUTS)
TEXTS = ("pin", "kind", "key", "code", "message", "failed checks", "held", "profile")


def read_rows(file):
    """Rows by their keys."""
    if not file.exists():
        return {}
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {row["key"]: {name: read_entry(name, row.get(name, "")) for name in COLUMNS} for row in rows}


def read_entry(name, text):
    if name == "code" and text != "time":
        return int(text)
    return text if name in TEXTS else float(text) if text else None


def add_row(file, row):
    is_new = not file.exists()
    with open(file, "a", newline="") as stream:
        writer = csv.DictWriter(stream, COLUMNS, lineterminator="\n")
        if is_new:
            writer.writeheader()
        writer.writerow(row)


def main():
    arguments = read_arguments()
    pins = [Pin(seed) for seed in arguments.seeds
            if arguments.only is None or (seed % 2 == 1) == (arguments.only == "odd")]
    if arguments.draw_only:
        print(table([("pin", "kind", *INPUTS)] + [(pin.name, pin.kind, *map(short_text, pin.inputs().values()))
                                                      for pin in pins]))
        return
    runner = Runner(arguments)
    rows = read_rows(arguments.output)
    if arguments.again:
        known = [pin for pin in pins if runner.key(pin) in rows]
        for row in [runner.again(pin, rows[runner.key(pin)]) for pin in known]:
            rows[row["key"]] = row
        arguments.output.unlink()
        for row in rows.values():
            add_row(arguments.output, row)
    for pin in pins:
        if runner.key(pin) not in rows:
            row = runner.run(pin)
            add_row(arguments.output, row)
            print(f"{pin.name} ({pin.kind}): code {row['code']}, {row['seconds']:.1f} s", file=sys.stderr, flush=True)
    rows = read_rows(arguments.output)
    verdicts = [Verdict(rows[runner.key(pin)]) for pin in pins]
    print(pin_table(verdicts), kind_table(verdicts), summary_lines(verdicts), outliers(verdicts), sep="\n\n")
    if arguments.picture:
        arguments.picture.write_text(picture(verdicts))


if __name__ == "__main__":
    main()
