"""Closed forms for the shipped cases, on their own: nothing here comes from the program.

`python3 tests/cli/closed_forms.py` prints the values that stand in cases/*/expected.json, and those of kinematics.json.
SI units. The motion of the mechanisms stands in closed_motion.py.
"""

import cmath
import dataclasses
import json
import math

import closed_motion
from closed_motion import maximum, slope, value, zero

# Definitions of the units, exact.
INCH = 0.0254
POUND = 0.45359237
POUND_FORCE = POUND * 9.80665
PSI = POUND_FORCE / INCH**2
RPM = 2 * math.pi / 60

# Johnson 1956, Table 1: pin diameter and thickness over D (k2 = k3), locking radius over D (k4), wheel inertia over
# rho D^5 (k5).
JOHNSON = {4: {"k2": 0.15, "k4": 0.35, "k5": 0.00506}, 6: {"k2": 0.14, "k4": 0.17, "k5": 0.00588}}


# Hertz


def contact_modulus(first, second):
    """E* of two materials (E, nu) in plane strain: 1/E* = sum of (1 - nu^2)/E."""
    return 1 / sum((1 - nu**2) / modulus for modulus, nu in (first, second))


def relative_radius(first, second=math.inf):
    return 1 / (1 / first + 1 / second)


def hertz_line(force_per_length, radius, modulus):
    """Cylinders with parallel axes (Johnson, Contact Mechanics, 4.2): p0, b, the maximum shear and its depth.

    Below the middle the shear is p0 (s - s^2/sqrt(1 + s^2)) at the depth s b; it is greatest where
    s^2 = (sqrt(5) - 1)/2: 0.30028 p0 at 0.78615 b.
    """
    peak = math.sqrt(force_per_length * modulus / (math.pi * radius))
    width = math.sqrt(4 * force_per_length * radius / (math.pi * modulus))
    depth = math.sqrt((math.sqrt(5) - 1) / 2)
    shear = depth - depth**2 / math.sqrt(1 + depth**2)
    return {"peak_pressure": peak, "half_width": width, "max_shear": shear * peak, "max_shear_depth": depth * width}


def hertz_point(force, radius, modulus, poissons_ratio):
    """Spheres (Johnson, Contact Mechanics, 3.4): p0, a, the maximum shear on the axis and its depth."""
    width = (3 * force * radius / (4 * modulus))**(1 / 3)
    peak = 3 * force / (2 * math.pi * width**2)

    def shear(depth):
        across = -(1 + poissons_ratio) * (1 - depth * math.atan(1 / depth)) + 0.5 / (1 + depth**2)
        return abs(across + 1 / (1 + depth**2)) / 2

    depth = maximum_place(shear, 0.1, 1.0)
    return {"peak_pressure": peak, "half_width": width, "max_shear": shear(depth) * peak,
            "max_shear_depth": depth * width}


def maximum_place(function, low, high):
    """Where a function with one maximum between two places has it, by ternary search."""
    while high - low > 1e-9:
        third = (high - low) / 3
        if function(low + third) < function(high - third):
            low += third
        else:
            high -= third
    return (low + high) / 2


# Geneva


def wheel_motion(stations, driver_angle, speed):
    """Angle, speed and acceleration of the external wheel at a driver angle, both from the line of centres.

    The wheel's angle is phi = atan2(s sin(theta), 1 - s cos(theta)) with s = sin(pi/n) (ME341, Eq. 5.27); the others
    are its derivatives (Eq. 5.28, 5.29).
    """
    s = math.sin(math.pi / stations)
    square = 1 + s**2 - 2 * s * math.cos(driver_angle)
    angle = math.atan2(s * math.sin(driver_angle), 1 - s * math.cos(driver_angle))
    first = s * (math.cos(driver_angle) - s) / square
    second = -s * (1 - s**2) * math.sin(driver_angle) / square**2
    return angle, first * speed, second * speed**2


def peak_acceleration_angle(stations):
    """Driver angle before the line of centres at which the wheel's acceleration is greatest (ME341, Eq. 5.33, 5.34)."""
    s = math.sin(math.pi / stations)
    g = (1 + s**2) / (2 * s)
    return -math.acos((-g + math.sqrt(g**2 + 8)) / 2)


def integral(function, low, high):
    """Integral by the double-exponential rule, which bears square roots at the ends."""
    step = 1 / 32
    total = 0.0
    for k in range(-128, 129):
        sinh = math.pi / 2 * math.sinh(k * step)
        place = math.exp(sinh) / (2 * math.cosh(sinh))
        weight = math.pi / 4 * math.cosh(k * step) / math.cosh(sinh)**2
        total += step * weight * function(low + (high - low) * place)
    return total * (high - low)


def drawn_wheel_inertia(stations, diameter, density, proportions):
    """Moment of inertia of the wheel that is drawn by default: a disc less slots, locking arcs and bore.

    Circle by circle about the axis: the slots (as wide as the pin, with round bottoms centred at c - r) and the
    locking arcs (centred at the distance c, half-way between slots) take away known angles.
    """
    radius = diameter / 2
    slot = proportions["k2"] * diameter / 2
    locking = proportions["k4"] * diameter
    centre = radius / math.cos(math.pi / stations)
    bottom = centre - radius * math.tan(math.pi / stations)
    bore = min(0.1 * diameter, (bottom - slot) / 2)

    def half_angle(at, distance, size):
        """Half of the angle that a circle of a size at a distance from the axis covers at the radius `at`."""
        return math.acos(max(-1.0, min(1.0, (at**2 + distance**2 - size**2) / (2 * at * distance))))

    def bottom_part(at):
        return at**3 * half_angle(at, bottom, slot)

    def wall_part(at):
        return at**3 * math.asin(slot / at)

    def arc_part(at):
        return at**3 * half_angle(at, centre, locking)

    walls = math.hypot(bottom, slot)
    taken = (integral(bottom_part, bottom - slot, walls) + integral(wall_part, walls, radius) +
             integral(arc_part, centre - locking, radius))
    disc = 2 * math.pi * (radius**4 - bore**4) / 4
    return density * proportions["k2"] * diameter * (disc - 2 * stations * taken)


def mechanism(stations, diameter, speed, friction, cylinder, material, uses_johnson_inertia):
    """Load, closed-form contact and torque of a case at the wheel's maximum acceleration.

    The pin force is F = ((J_G + J_L) a + M_f)/x (Johnson, Eq. 1) with x^2 = r^2 + c^2 - 2 r c cos(theta).
    """
    modulus, poissons_ratio, density = material
    row = JOHNSON[stations]
    alpha = math.pi / stations
    crank, centre = diameter / 2 * math.tan(alpha), diameter / 2 / math.cos(alpha)
    theta = peak_acceleration_angle(stations)
    wheel_angle, wheel_speed, acceleration = wheel_motion(stations, theta, speed)
    distance = math.sqrt(crank**2 + centre**2 - 2 * crank * centre * math.cos(theta))
    drawn = drawn_wheel_inertia(stations, diameter, density, row)
    used = row["k5"] * density * diameter**5 if uses_johnson_inertia else drawn
    load_diameter, load_length, load_density = cylinder
    load_inertia = math.pi / 32 * load_density * load_length * load_diameter**4
    torque = load_inertia * acceleration + friction
    force = (used * acceleration + torque) / distance
    pin = row["k2"] * diameter
    line = hertz_line(force / pin, pin / 2, contact_modulus((modulus, poissons_ratio), (modulus, poissons_ratio)))
    return {"load.driver_angle": theta, "load.wheel_angle": wheel_angle, "load.wheel_speed": wheel_speed,
            "load.wheel_acceleration": acceleration, "load.pin_distance": distance, "load.force": force,
            "wheel.inertia_from_geometry": drawn, "wheel.inertia_used": used,
            "equilibrium.expected_bore_torque": torque, "equilibrium.bore_torque": torque, "contact.force": force,
            **contact(line)}


@dataclasses.dataclass
class Mover:
    """A mechanism that moves, what it drives, and how pin and wall touch."""
    mechanism: closed_motion.Mechanism
    motion: closed_motion.Timed
    speed: float  # by whose powers ratios are formed
    pins: tuple = (0.0,)  # driver angles of the pins midway through their engagements
    dwell_speed: float = 0.0  # of the driver between the engagements, if it is not `speed`
    inertia: float = 0.0  # of the wheel
    load_inertia: float = 0.0
    friction: float = 0.0
    pin: float = 0.0  # diameter
    thickness: float = 0.0
    modulus: float = 0.0  # E*

    def force(self, at):
        """((J_G + J_L) a + M_f)/x at any instant (Johnson 1956, Eq. 1)."""
        place = self.motion.place(at)
        return ((self.inertia + self.load_inertia) * place.acceleration + self.friction) / place.pin_distance

    def hertz(self, force):
        return hertz_line(abs(force) / self.thickness, self.pin / 2, self.modulus)

    def maximum(self, function):
        return maximum(function, self.motion.begin, self.motion.end)

    def peak_force(self):
        return self.maximum(self.force)

    def peak_acceleration(self):
        """Forwards."""
        return self.maximum(lambda at: self.motion.place(at).acceleration)


def load_values(mover, at, drawn=None):
    """Keys of summary.json for a run at a place of the motion; `drawn` is the inertia of a drawn whole wheel."""
    place = mover.motion.place(at)
    force = mover.force(at).real
    torque = mover.load_inertia * place.acceleration.real + mover.friction
    result = {"load.driver_angle": mover.motion.driver_angle(at), "load.wheel_angle": complex(place.wheel_angle).real,
              "load.wheel_speed": complex(place.speed).real,
              "load.wheel_acceleration": complex(place.acceleration).real,
              "load.pin_distance": complex(place.pin_distance).real, "load.force": force,
              "wheel.inertia_used": mover.inertia, "contact.force": force, **contact(mover.hertz(force))}
    if drawn is not None:
        result |= {"wheel.inertia_from_geometry": drawn, "equilibrium.expected_bore_torque": torque,
                   "equilibrium.bore_torque": torque}
    return result


def slip_reversals(mover):
    """Where the surface of a fixed pin turns back, on the driving wall first."""
    motion, count = mover.motion, 1000
    margin = 1e-3 * (motion.end - motion.begin)  # formulas may be 0/0 at the very ends
    grid = [motion.begin + margin + (motion.end - motion.begin - 2 * margin) * i / count for i in range(count + 1)]
    found = []
    for wall in (1, -1):
        def slip(at, wall=wall):
            return complex(motion.place(at).slip(mover.pin, wall)).real

        found += [zero(slip, before, after) for before, after in zip(grid, grid[1:]) if slip(before) * slip(after) < 0]
    return found


def kinematics_values(mover):
    """Keys of kinematics.json; the driver runs at its reference speed between the engagements."""
    motion, speed, mechanism = mover.motion, mover.speed, mover.mechanism
    place = motion.place
    wheel_speed = mover.maximum(lambda at: place(at).speed)
    peak = mover.peak_acceleration()
    force, braking = mover.peak_force(), mover.maximum(lambda at: -mover.force(at))
    forces = {at: value(mover.force, at) for at in (force, braking, peak)}
    strongest = force if forces[force] >= -forces[braking] * (1 - 1e-9) else braking

    def wear(at, sign):
        """Square of pressure times slip over a constant, on one wall."""
        return sign * mover.force(at) * place(at).slip(mover.pin, sign)**2

    walls = {sign: mover.maximum(lambda at, sign=sign: wear(at, sign)) for sign in (1, -1)}
    wall = max(walls, key=lambda sign: (round(math.log(value(lambda at: wear(at, sign), walls[sign])), 9), sign))
    worn = walls[wall]

    def pressure(at):
        return mover.hertz(value(mover.force, at))["peak_pressure"]

    def pressure_slip(at):
        wall = math.copysign(1, value(mover.force, at))
        return pressure(at) * abs(value(lambda here: place(here).slip(mover.pin, wall), at))

    per_engagement = complex(motion.time(motion.end) - motion.time(motion.begin)).real
    turn = mechanism.exit - mechanism.entry
    pins = sorted(mover.pins)
    gaps = [after - before - turn for before, after in zip(pins, pins[1:] + [pins[0] + mechanism.period])]
    dwells = [gap / (mover.dwell_speed or speed) for gap in gaps]
    motion_time = len(pins) * per_engagement
    per_time = slope(motion.time, motion.middle)
    return {"reference_speed": speed,
            "peak_speed_ratio": value(lambda at: place(at).speed, wheel_speed) / speed,
            "peak_acceleration_ratio": abs(value(lambda at: place(at).acceleration, peak)) / speed**2,
            "peak_acceleration_angle": motion.driver_angle(peak),
            "entry_acceleration_ratio": value(lambda at: place(at).acceleration, motion.begin) / speed**2,
            "jerk_ratio_at_centre": slope(lambda at: place(at).acceleration, motion.middle) / per_time / speed**3,
            "engagement_angle": turn, "motion_time": per_engagement,
            **{f"dwell_time.{i}": dwell for i, dwell in enumerate(dwells)},
            "motion_fraction": motion_time / (motion_time + sum(dwells)), "time_ratio": motion_time / sum(dwells),
            "peak_force": forces[force], "peak_force_angle": motion.driver_angle(force),
            "peak_force_ratio": forces[force] / forces[peak],
            "peak_braking_force": -forces[braking], "peak_braking_force_angle": motion.driver_angle(braking),
            "peak_hertz_pressure": pressure(strongest), "peak_hertz_pressure_angle": motion.driver_angle(strongest),
            "peak_hertz_pressure_ratio": pressure(strongest) / pressure(peak),
            "peak_pressure_times_slip": pressure_slip(worn),
            "peak_pressure_times_slip_angle": motion.driver_angle(worn),
            "peak_pressure_times_slip_ratio": pressure_slip(worn) / pressure_slip(peak),
            **{f"slip_reversals.{i}.driver_angle": motion.driver_angle(at)
               for i, at in enumerate(slip_reversals(mover))}}


def drawn_ring_inertia(stations, diameter, density, proportions):
    """Moment of inertia of the internal wheel that is drawn by default: a ring less slots and locking arcs.

    Circle by circle about the axis, from D/2 to the rim; the slots have round bottoms centred at c + r, and the locking
    arcs are centred at the distance c.
    """
    radius = diameter / 2
    slot = proportions["k2"] * diameter / 2
    locking = proportions["k4"] * diameter
    centre = radius / math.cos(math.pi / stations)
    bottom = centre + radius * math.tan(math.pi / stations)
    rim = bottom + slot + 0.15 * diameter

    def half_angle(at, distance, size):
        return math.acos(max(-1.0, min(1.0, (at**2 + distance**2 - size**2) / (2 * at * distance))))

    walls = math.hypot(bottom, slot)
    taken = (integral(lambda at: at**3 * math.asin(slot / at), radius, walls) +
             integral(lambda at: at**3 * half_angle(at, bottom, slot), walls, bottom + slot) +
             integral(lambda at: at**3 * half_angle(at, centre, locking), radius, centre + locking))
    ring = 2 * math.pi * (rim**4 - radius**4) / 4
    return density * proportions["k2"] * diameter * (ring - 2 * stations * taken)


# Cases


def contact(hertz):
    """Keys of the computed contact and of the program's closed form for the same values."""
    return {f"{section}.{name}": value for section in ("contact", "hertz") for name, value in hertz.items()}


def johnson_wheel(diameter):
    """Johnson 1956, Example 1."""
    density = 0.283 * POUND / INCH**3
    return mechanism(stations=4, diameter=diameter, speed=600 * RPM, friction=2 * POUND_FORCE * INCH,
                     cylinder=(4 * INCH, 0.25 * INCH, density), material=(30e6 * PSI, 0.3, density),
                     uses_johnson_inertia=True)


def six_stations():
    """The six-station mechanism at 360 rpm (ME341), with a steel wheel of 120 mm."""
    return mechanism(stations=6, diameter=0.12, speed=360 * RPM, friction=0.5, cylinder=(0.15, 0.02, 7850.0),
                     material=(210e9, 0.3, 7850.0), uses_johnson_inertia=False)


STEEL = (210e9, 0.3)
STEEL_DENSITY = 7850.0
LOAD_INERTIA = math.pi / 32 * STEEL_DENSITY * 0.02 * 0.15**4  # of the cylinder that the metric cases drive
SIX = JOHNSON[6]


def steel_mover(mechanism, motion, speed, pin, thickness, inertia, **more):
    """With the load of the metric cases: that cylinder, and 0.5 N m of friction."""
    return Mover(mechanism, motion, speed, inertia=inertia, load_inertia=LOAD_INERTIA, friction=0.5, pin=pin,
                 thickness=thickness, modulus=contact_modulus(STEEL, STEEL), **more)


def steady_mover(mechanism, speed, pin, thickness, inertia, **more):
    return steel_mover(mechanism, closed_motion.steady(mechanism, speed), speed, pin, thickness, inertia, **more)


def six_station_wheel():
    """The drawn steel wheel of 120 mm, its centre distance, and its inertia."""
    diameter = 0.12
    return (diameter / 2 / math.cos(math.pi / 6), SIX["k2"] * diameter,
            drawn_wheel_inertia(6, diameter, STEEL_DENSITY, SIX))


def external_mover(speed, **more):
    centre, pin, inertia = six_station_wheel()
    return steady_mover(closed_motion.external(6, centre), speed, pin, pin, inertia, **more)


def servo_mover(law):
    """The law on the cross: the carrier runs at (engagement angle)/(motion time) between the engagements."""
    centre, pin, inertia = six_station_wheel()
    mechanism = closed_motion.external(6, centre)
    motion_time = 0.05
    return steel_mover(mechanism, closed_motion.law_on_cross(6, centre, law, motion_time),
                       (mechanism.exit - mechanism.entry) / motion_time, pin, pin, inertia)


def johnson_mover(diameter):
    density = 0.283 * POUND / INCH**3
    pin = JOHNSON[4]["k2"] * diameter
    mechanism = closed_motion.external(4, diameter / 2 / math.cos(math.pi / 4))
    speed = 600 * RPM
    steel = (30e6 * PSI, 0.3)
    return Mover(mechanism, closed_motion.steady(mechanism, speed), speed,
                 inertia=JOHNSON[4]["k5"] * density * diameter**5,
                 load_inertia=math.pi / 32 * density * 0.25 * INCH * (4 * INCH)**4, friction=2 * POUND_FORCE * INCH, pin=pin,
                 thickness=pin, modulus=contact_modulus(steel, steel))


def internal_mover():
    pin = SIX["k2"] * 0.12
    return steady_mover(closed_motion.internal(6, 0.06 / math.cos(math.pi / 6)), 360 * RPM, pin, pin,
                        drawn_ring_inertia(6, 0.12, STEEL_DENSITY, SIX))


def spherical_mover():
    return steady_mover(closed_motion.spherical_right_angle(8, 0.08), 300 * RPM, 0.01, 0.012, 0.0012)


def long_dwell_mover():
    return steady_mover(closed_motion.long_dwell_along(6, 0.04, 0.12), 300 * RPM, 0.016, 0.016, 0.0012)


FOUR_BAR_LINKS = (0.04, 0.12, 0.12, 0.1, 0.12, math.pi / 2)


def four_bar_mover():
    _, mechanism = closed_motion.four_bar(6, FOUR_BAR_LINKS, math.radians(150), 0.2, 0.4)
    return steady_mover(mechanism, 200 * RPM, 0.016, 0.016, 0.0012)


def movers():
    """The mechanism cases, by name."""
    return {"johnson-optimum-wheel": johnson_mover(4.53 * INCH), "johnson-small-wheel": johnson_mover(2 * INCH),
            "johnson-large-wheel": johnson_mover(6 * INCH), "six-station-360rpm": external_mover(360 * RPM),
            "internal-six-station": internal_mover(), "spherical-eight-station": spherical_mover(),
            "irregular-two-pin": external_mover(240 * RPM, pins=(0.0, math.radians(150))),
            "long-dwell": long_dwell_mover(), "four-bar-geneva": four_bar_mover(),
            "servo-harmonic": servo_mover(closed_motion.harmonic),
            "servo-cycloidal": servo_mover(closed_motion.cycloidal)}


def kinematics():
    """Closed-form values by case and key of kinematics.json."""
    return {case: kinematics_values(mover) for case, mover in movers().items()}


def run_values(case, angle=None):
    """Keys of summary.json at a driver angle of a case with constant driver speed, or at the maximum pin force."""
    mover = movers()[case]
    is_drawn = case not in ("spherical-eight-station", "long-dwell", "four-bar-geneva")
    return load_values(mover, mover.peak_force() if angle is None else angle, mover.inertia if is_drawn else None)


def elliptic_integrals(parameter):
    """Complete elliptic integrals K and E of the parameter m = e^2 by the arithmetic-geometric mean."""
    a, b, weight = 1.0, math.sqrt(1 - parameter), 0.5
    deficit = parameter / 2
    while a - b > 1e-15 * a:
        a, b, half = (a + b) / 2, math.sqrt(a * b), (a - b) / 2
        weight *= 2
        deficit += weight * half * half
    complete = math.pi / (2 * a)
    return complete, complete * (1 - deficit)


def hertz_ellipse(force, larger, smaller, modulus):
    """Johnson, Contact Mechanics, 4.2c: peak pressure and semi-axes; the ratio of the axes by bisection (Eq. 4.28)."""
    low, high = math.log(1e-16), 0.0
    for _ in range(200):
        middle = (low + high) / 2
        square = math.exp(middle)
        first, second = elliptic_integrals(1 - square)
        if (second / square - first) / (first - second) > larger / smaller:
            low = middle
        else:
            high = middle
    square = math.exp((low + high) / 2)
    first, second = elliptic_integrals(1 - square)
    a = (3 * force * larger * (first - second) / (math.pi * modulus * (1 - square)))**(1 / 3)
    b = a * math.sqrt(square)
    return {"peak_pressure": 1.5 * force / (math.pi * a * b), "half_length": a, "half_width": b}


def in_space(hertz):
    """Keys of a contact in 3-D and of the closed form beside it; a circle has one radius."""
    hertz = {"half_length": hertz["half_width"], **hertz}
    return {f"{section}.{key}": hertz[key] for section in ("contact", "hertz")
            for key in ("peak_pressure", "half_width", "half_length", "max_shear") if key in hertz}


def cantilever(force, diameter, thickness, gap, overhang, young, poisson):
    """Timoshenko's beam under an even load: deflection of its tip and bending stress at its root."""
    bending = young * math.pi * diameter**4 / 64
    shear = 6 * (1 + poisson) / (7 + 6 * poisson) * young / (2 * (1 + poisson)) * math.pi * diameter**2 / 4
    near, far, tip, load = gap, gap + thickness, gap + thickness + overhang, force / thickness
    deflection = (load / 6 * (tip * (far**3 - near**3) - (far**4 - near**4) / 4) / bending +
                  load / 2 * (far**2 - near**2) / shear)
    stress = 32 * load / 2 * (far**2 - near**2) / (math.pi * diameter**3)
    return {"tip_deflection": deflection, "root_stress": stress}


def johnson_in_space(crown_radius=None):
    """Johnson's optimum wheel with a cantilever pin, held 0.15 in beside the wheel and 0.1 in longer."""
    plane = johnson_wheel(4.53 * INCH)
    force, diameter, young = plane["load.force"], 0.15 * 4.53 * INCH, 30e6 * PSI
    beam = cantilever(force, diameter, diameter, 0.15 * INCH, 0.1 * INCH, young, 0.3)
    hertz = ({"peak_pressure": plane["hertz.peak_pressure"]} if crown_radius is None else
             hertz_ellipse(force, crown_radius, diameter / 2, contact_modulus((young, 0.3), (young, 0.3))))
    kept = {key: plane[key] for key in ("load.force", "contact.force", "equilibrium.bore_torque")}
    return {**kept, "contact.mid_length_pressure": hertz["peak_pressure"],
            **{f"{section}.{key}": value for section in ("contact", "hertz") for key, value in hertz.items()},
            "pin.tip_deflection": beam["tip_deflection"],
            "pin.tip_deflection_beam_theory": beam["tip_deflection"],
            "pin.root_stress_beam_theory": beam["root_stress"]}


def quick_return(stations, wheel_speed, frame):
    """Lecture 4, slides 13, 14 and 23; angles of the crank from the line AD."""
    ratio = math.sin(math.pi / stations)
    crank = frame * ratio
    last = math.pi / 2 - math.pi / stations
    crank_speed = wheel_speed * (frame - crank) / crank
    extremes = {"slider_nearest": {"slider_distance": frame - crank, "rocker_speed": wheel_speed},
                "slider_farthest": {"crank_angle": math.pi, "slider_distance": frame + crank,
                                    "rocker_speed": -crank_speed * crank / (frame + crank)},
                "rocker_first": {"crank_angle": -last, "rocker_angle": -math.pi / stations},
                "rocker_last": {"crank_angle": last, "rocker_angle": math.pi / stations,
                                "slider_distance": math.sqrt(frame**2 - crank**2)}}
    return {"quick_return.crank": crank, "quick_return.frame": frame, "quick_return.crank_speed": crank_speed,
            "quick_return.k_t": (stations - 2) / (stations + 2), "quick_return.engagement_angle": 2 * last,
            **{f"quick_return.extreme_positions.{place}.{name}": value
               for place, figures in extremes.items() for name, value in figures.items()}}


def crank_rocker(swing, rocker, pivot_distance):
    """Lecture 4, slide 10, in closed form: the chord's half is the crank."""
    crank, height = rocker * math.sin(swing / 2), rocker * math.cos(swing / 2)
    frame = math.hypot(pivot_distance, height)
    extremes = {"rocker_farthest.rocker_angle": math.pi / 2 - swing / 2,
                "rocker_nearest.rocker_angle": math.pi / 2 + swing / 2, "rocker_nearest.crank_angle": math.pi}
    return {"crank_rocker.crank": crank, "crank_rocker.coupler": pivot_distance, "crank_rocker.rocker": rocker,
            "crank_rocker.frame": frame, "crank_rocker.crank_pivot_x": -pivot_distance,
            "crank_rocker.crank_pivot_y": height, "crank_rocker.swing": swing, "crank_rocker.time_ratio": 1.0,
            "crank_rocker.minimum_transmission_angle": math.acos(crank * frame / (pivot_distance * rocker)),
            **{f"crank_rocker.extreme_positions.{key}": value for key, value in extremes.items()}}


# The linkage whose coupler curve the points of synthesis-nine-points are taken from, by the keys of synthesis.json.
KNOWN_LINKAGE = {"crank_pivot_x": 0.01, "crank_pivot_y": -0.02, "rocker_pivot_x": 0.13, "rocker_pivot_y": 0.01,
                 "crank": 0.04, "coupler": 0.11, "rocker": 0.1, "point_distance": 0.09,
                 "point_angle": math.radians(35)}


def coupler_point(linkage, crank_angle):
    """Coupler point of the open linkage by the cosine rule in the triangle B C D."""
    pin = complex(linkage["crank_pivot_x"], linkage["crank_pivot_y"]) + cmath.rect(linkage["crank"], crank_angle)
    diagonal = complex(linkage["rocker_pivot_x"], linkage["rocker_pivot_y"]) - pin
    cosine = ((linkage["coupler"]**2 + abs(diagonal)**2 - linkage["rocker"]**2) /
              (2 * linkage["coupler"] * abs(diagonal)))
    coupler_angle = cmath.phase(diagonal) + math.acos(cosine)
    return pin + cmath.rect(linkage["point_distance"], coupler_angle + linkage["point_angle"])


def turning_disc(density, speed, inner, outer, nu):
    """Hoop stress at the bore of a thin disc (Timoshenko and Goodier, Theory of Elasticity, 30)."""
    return (3 + nu) / 4 * density * speed**2 * (outer**2 + (1 - nu) / (3 + nu) * inner**2)


def values():
    """Closed-form values by case and key of summary.json, or of the other command's figures."""
    steel = (210e9, 0.3)
    return {
        "johnson-optimum-wheel": johnson_wheel(4.53 * INCH),
        "johnson-small-wheel": johnson_wheel(2 * INCH),
        "johnson-large-wheel": johnson_wheel(6 * INCH),
        "johnson-optimum-3d": johnson_in_space(),
        "crowned-pin": johnson_in_space(crown_radius=120 * INCH),
        "tilted-pin": johnson_in_space(crown_radius=80 * INCH),
        "six-station-360rpm": six_stations(),
        "six-station-cycle": {},  # its README and expected.json say where the values come from
        "internal-six-station": run_values("internal-six-station", -math.pi / 2),
        "spherical-eight-station": run_values("spherical-eight-station", -math.pi / 3),
        **{case: run_values(case) for case in ("irregular-two-pin", "long-dwell", "four-bar-geneva", "servo-harmonic",
                                               "servo-cycloidal")},
        "hertz-line-contact": {"contact.force": 6.0,
                               **contact(hertz_line(6 / 1e-3, 0.01, contact_modulus(steel, steel)))},
        "hertz-dissimilar": {"contact.force": 12.0,
                             **contact(hertz_line(12 / 1e-3, relative_radius(0.01, 0.025),
                                                  contact_modulus(steel, (70e9, 0.33))))},
        "nafems-roller": {"contact.force": 35e3,
                          **contact(hertz_line(35e6, 0.05, contact_modulus(steel, (70e9, 0.3))))},
        "hertz-sphere": {"contact.force": 120.0,
                         **contact(hertz_point(120, 0.01, contact_modulus(steel, steel), 0.3))},
        "hertz-sphere-3d": {"contact.force": 30.0, **in_space(hertz_point(120, 0.01, contact_modulus(steel, steel), 0.3))},
        "hertz-sphere-step": {"contact.force": 30.0,
                              **in_space(hertz_point(120, 0.01, contact_modulus(steel, steel), 0.3))},
        "crossed-cylinders-step": {"contact.force": 50.0,
                                   **in_space(hertz_ellipse(200, 0.03, 0.01, contact_modulus(steel, steel)))},
        "crossed-cylinders": {"contact.force": 50.0,
                              **in_space(hertz_ellipse(200, 0.03, 0.01, contact_modulus(steel, steel)))},
        "mindlin-sphere": {"contact.force": 60.0, "contact.friction.force": 13.5,
                           "contact.friction.sticking_share": (1 - 27 / (0.3 * 120))**(2 / 3),
                           **{key: value for key, value in in_space(hertz_point(120, 0.01, contact_modulus(steel, steel), 0.3)).items()
                              if "shear" not in key}},
        "synthesis-quick-return": quick_return(stations=6, wheel_speed=360 * RPM, frame=0.1),
        "synthesis-crank-rocker": crank_rocker(swing=math.radians(30), rocker=0.1, pivot_distance=0.08),
        "synthesis-nine-points": {"path.solutions": KNOWN_LINKAGE},
        "plate-with-hole": {"strength.bar.tensile": 3.15591 * 50e6},
        "shaft-fillet": {},
        "indexing-table-roller": {},  # as indexing-table
        "indexing-table": {},  # its expectations are by hand: differences of the motion, Hertz, lever arms
        "rotating-disc": {"strength.disc.tensile": turning_disc(7850, 200 * math.pi, 0.02, 0.15, 0.3)},
        "flat-patch": {"contact.force": 100e6 * 0.04 * 1e-3, "contact.peak_pressure": 100e6},
        "flat-patch-3d": {"contact.force": 100e6 * 0.04 * 0.03, "contact.peak_pressure": 100e6},
    }


if __name__ == "__main__":
    print(json.dumps({"run": values(), "kinematics": kinematics()}, indent=2))
