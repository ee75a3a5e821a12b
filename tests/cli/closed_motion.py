"""Motion of the family of Geneva mechanisms by the formulas of the sources, on its own: nothing here comes from the
program, and nothing is differentiated as the program does it.

A mechanism gives, at a driver angle theta per unit of driver speed, a Place: wheel angle, its first two derivatives,
the pin's distance x from the wheel's axis, the speed of its axis along the slot and the speed at which what carries it
turns against the wheel. All formulas are analytic in theta, so that a slope is the
imaginary part of the value a tiny step beside the real axis (complex step), exact to rounding.
"""

import cmath
import dataclasses
import math

STEP = 1e-20  # of the complex step; its square is nothing


@dataclasses.dataclass
class Place:
    """Wheel and pin at one place of the motion; derivatives with respect to the motion's own parameter, or to time."""
    wheel_angle: complex
    speed: complex
    acceleration: complex
    pin_distance: complex
    travel: complex
    spin: complex  # against the wheel's sense of rotation

    def slip(self, pin, wall):
        """Of the surface of a pin of that diameter on the driving (1) or the braking (-1) wall: its material point is
        d/2 ahead of the pin's axis or behind it, and goes with the turning carrier."""
        return self.travel + wall * pin / 2 * self.spin


@dataclasses.dataclass
class Mechanism:
    """A mechanism over the engagement of its first pin, driver angle 0 midway."""
    stations: int
    entry: float
    exit: float
    period: float
    place: object  # driver angle -> Place


def arctan2(y, x):
    """atan2 of numbers with a tiny imaginary part: the logarithm would lose it."""
    y, x = complex(y), complex(x)
    return complex(math.atan2(y.real, x.real), (x.real * y.imag - y.real * x.imag) / abs(complex(x.real, y.real))**2)


def external(stations, centre_distance):
    """ME341, Eq. 5.30 to 5.32; x dx/dtheta = c^2 s sin(theta)."""
    s = math.sin(math.pi / stations)

    def place(theta):
        sine, cosine = cmath.sin(theta), cmath.cos(theta)
        square = 1 + s**2 - 2 * s * cosine
        x = centre_distance * cmath.sqrt(square)
        return Place(arctan2(s * sine, 1 - s * cosine), s * (cosine - s) / square,
                     -s * (1 - s**2) * sine / square**2, x, centre_distance**2 * s * sine / x,
                     1 + s * (cosine - s) / square)

    half = math.pi / 2 - math.pi / stations
    return Mechanism(stations, -half, half, 2 * math.pi, place)


def internal(stations, centre_distance):
    """Lecture 4: the same with the pin on the far side of its circle, theta = 0 where it is farthest."""
    s = math.sin(math.pi / stations)

    def place(theta):
        sine, cosine = cmath.sin(theta), cmath.cos(theta)
        square = 1 + s**2 + 2 * s * cosine
        x = centre_distance * cmath.sqrt(square)
        return Place(arctan2(s * sine, 1 + s * cosine), s * (cosine + s) / square,
                     -s * (1 - s**2) * sine / square**2, x, -centre_distance**2 * s * sine / x,
                     s * (cosine + s) / square - 1)

    half = math.pi / 2 + math.pi / stations
    return Mechanism(stations, -half, half, 2 * math.pi, place)


def spherical_right_angle(stations, radius):
    """Lecture 4, shafts at right angles: tan(phi) = t sin(theta) with t = tan(pi/n).

    The cosine of the angle between the pin and the wheel's axis is sin(pi/n) cos(theta), that between the pin and the
    driver's axis cos(pi/n): with these shares of both speeds the driver turns against the wheel about the pin.
    """
    t, s = math.tan(math.pi / stations), math.sin(math.pi / stations)

    def place(theta):
        sine, cosine = cmath.sin(theta), cmath.cos(theta)
        square = 1 + t**2 * sine**2
        across = cmath.sqrt(1 - (s * cosine)**2)
        return Place(arctan2(t * sine, 1.0), t * cosine / square,
                     -t * sine * (1 + t**2 * sine**2 + 2 * t**2 * cosine**2) / square**2, radius * across,
                     radius * s * sine / across, t * cosine / square * s * cosine + math.sqrt(1 - s**2))

    return Mechanism(stations, -math.pi / 2, math.pi / 2, 2 * math.pi, place)


def long_dwell_along(stations, pitch_radius, spacing):
    """While the pin is in the slot it goes round the first sprocket: the external Geneva with a longer round."""
    mechanism = external(stations, pitch_radius / math.sin(math.pi / stations))
    return dataclasses.replace(mechanism, period=2 * math.pi + 2 * spacing / pitch_radius)


# Four-bar linkage


def coupler_point(links, crank_angle):
    """Place of the coupler point and its first two derivatives, from the closure a e^(i phi2) + b e^(i phi3) -
    c e^(i phi4) = f (Lecture 4) differentiated twice; C to the left of the line from B to D.

    `links`: crank a, coupler b, rocker c, frame f, point distance p and point angle. Each result is the pair x, y.
    """
    a, b, c, f, p, point_angle = links
    across, along = -a * cmath.sin(crank_angle), f - a * cmath.cos(crank_angle)  # from B to D
    square = across**2 + along**2
    coupler = arctan2(across, along) + cmath.acos((b**2 + square - c**2) / (2 * b * cmath.sqrt(square)))
    rocker = arctan2(b * cmath.sin(coupler) - across, b * cmath.cos(coupler) - along)
    dead = cmath.sin(coupler - rocker)
    first = -a * cmath.sin(crank_angle - rocker) / (b * dead)
    rocker_first = -a * cmath.sin(crank_angle - coupler) / (c * dead)
    second = (c * rocker_first**2 - a * cmath.cos(crank_angle - rocker) -
              b * first**2 * cmath.cos(coupler - rocker)) / (b * dead)
    point = coupler + point_angle
    cosine, sine = cmath.cos(point), cmath.sin(point)
    crank_cosine, crank_sine = cmath.cos(crank_angle), cmath.sin(crank_angle)
    return ((a * crank_cosine + p * cosine, a * crank_sine + p * sine),
            (-a * crank_sine - p * first * sine, a * crank_cosine + p * first * cosine),
            (-a * crank_cosine - p * (second * sine + first**2 * cosine),
             -a * crank_sine + p * (second * cosine - first**2 * sine)))


class FourBar:
    """A wheel at a distance from the crank's axis along a direction, and the engagement of the coupler point."""

    def __init__(self, links, direction, distance):
        self.links = links
        self.axis = distance * math.cos(direction), distance * math.sin(direction)

    def seen(self, crank_angle):
        """Place of the pin as seen from the wheel's axis, and its derivatives."""
        place, *derivatives = coupler_point(self.links, crank_angle)
        return ((place[0] - self.axis[0], place[1] - self.axis[1]), *derivatives)

    def turning(self, crank_angle):
        (x, y), (u, v), _ = self.seen(crank_angle)
        return (x * v - y * u).real

    def angle(self, crank_angle):
        x, y = self.seen(crank_angle)[0]
        return math.atan2(y.real, x.real)

    def tangencies(self):
        """Crank angles on both sides of the pin's nearest place where its path points at the wheel's axis."""
        grid = [2 * math.pi * i / 360 for i in range(360)]
        nearest = min(grid, key=lambda at: abs(complex(*(part.real for part in self.seen(at)[0]))))
        ends = []
        for way in (-1, 1):
            places = [nearest + way * math.pi * i / 180 for i in range(361)]
            after = next(i for i, at in enumerate(places) if self.turning(at) * self.turning(nearest) < 0)
            ends.append(zero(self.turning, places[after - 1], places[after]))
        return ends

    def swing(self, begin, end):
        """Angle by which the wheel turns, less than half a turn."""
        return math.remainder(self.angle(end) - self.angle(begin), 2 * math.pi)


def four_bar(stations, links, direction, near, far):
    """The wheel stands where the path is tangent to the slot at both ends of a turn by 2 pi/n; its distance from the
    crank's axis, which is looked for between two distances, and the mechanism."""
    pitch = 2 * math.pi / stations

    def excess(distance):
        wheel = FourBar(links, direction, distance)
        return abs(wheel.swing(*wheel.tangencies())) - pitch

    distance = zero(excess, near, far)
    wheel = FourBar(links, direction, distance)
    begin, end = wheel.tangencies()
    sign = math.copysign(1, wheel.swing(begin, end))
    middle = zero(lambda at: sign * wheel.swing(begin, at) - pitch / 2, begin + 1e-6, end - 1e-6)
    towards = wheel.angle(middle)

    def place(theta):
        (x, y), (u, v), (p, q) = wheel.seen(middle + theta)
        square = x * x + y * y
        moment, radial = x * v - y * u, x * u + y * v
        pin = links[4]
        crank = (links[0] * cmath.cos(middle + theta), links[0] * cmath.sin(middle + theta))
        arm = (x + wheel.axis[0] - crank[0], y + wheel.axis[1] - crank[1])  # from the end of the crank, which turns by 1
        coupler = (arm[0] * (v - crank[0]) - arm[1] * (u + crank[1])) / pin**2
        turned = arctan2(y * math.cos(towards) - x * math.sin(towards), x * math.cos(towards) + y * math.sin(towards))
        return Place(sign * turned, sign * moment / square,
                     sign * ((x * q - y * p) / square - 2 * moment * radial / square**2), cmath.sqrt(square),
                     radial / cmath.sqrt(square), sign * (moment / square - coupler))

    return distance, Mechanism(stations, begin - middle, end - middle, 2 * math.pi, place)


# Motion in time


@dataclasses.dataclass
class Timed:
    """One engagement as a function of a parameter: time, driver angle, and Place with derivatives in time."""
    begin: float
    middle: float  # where the driver angle is 0
    end: float
    time: object
    driver_angle: object
    place: object


def steady(mechanism, speed):
    """A driver of constant speed; the parameter is the driver angle."""

    def place(theta):
        at = mechanism.place(theta)
        return Place(at.wheel_angle, at.speed * speed, at.acceleration * speed**2, at.pin_distance, at.travel * speed,
                     at.spin * speed)

    return Timed(mechanism.entry, 0.0, mechanism.exit, lambda theta: theta / speed, lambda theta: theta, place)


def cycloidal(k):
    """A, A' and A'' of Kolomiets et al."""
    return (k - cmath.sin(2 * math.pi * k) / (2 * math.pi), 1 - cmath.cos(2 * math.pi * k),
            2 * math.pi * cmath.sin(2 * math.pi * k))


def harmonic(k):
    return ((1 - cmath.cos(math.pi * k)) / 2, math.pi / 2 * cmath.sin(math.pi * k),
            math.pi**2 / 2 * cmath.cos(math.pi * k))


def end_speed(stations, law):
    """Speed of the carrier times the motion time where the pin enters and leaves, with a law on the cross.

    The carrier is 2 sqrt(alpha cot(alpha) A) from the end there, and sqrt(A)/k tends to pi/2 (harmonic) or 0.
    """
    alpha = math.pi / stations
    return 2 * math.sqrt(alpha / math.tan(alpha)) * {harmonic: math.pi / 2, cycloidal: 0.0}[law]


def law_on_cross(stations, centre_distance, law, motion_time):
    """External Geneva whose wheel follows a law (Kolomiets et al., Eq. 4 to 7); the parameter is the relative time k.

    With sin(beta) = sin(phi)/s the carrier stands at beta - phi, and x = c cos(phi) - r cos(beta), so that dx/dphi =
    x c sin(phi)/(r cos(beta)); carrier and wheel turn against each other with dbeta/dt. The square of cos(beta) is sin(alpha - phi) sin(alpha + phi)/s^2.
    """
    alpha = math.pi / stations
    s = math.sin(alpha)
    crank = centre_distance * s

    def angles(k):
        progress = law(k)[0]
        phi = alpha * (2 * progress - 1)
        return phi, cmath.sqrt(cmath.sin(2 * alpha * (1 - progress)) * cmath.sin(2 * alpha * progress)) / s

    def driver_angle(k):
        phi, cosine = angles(k)
        return (arctan2(cmath.sin(phi) / s, cosine) - phi).real

    def place(k):
        phi, cosine = angles(k)
        _, first, second = law(k)
        speed = 2 * alpha * first / motion_time
        x = centre_distance * cmath.cos(phi) - crank * cosine
        if k in (0, 1):
            spin = end_speed(stations, law) / motion_time
            travel = math.copysign(crank * spin, k - 0.5)
        else:
            spin = speed * cmath.cos(phi) / (s * cosine)
            travel = speed * x * centre_distance * cmath.sin(phi) / (crank * cosine)
        return Place(phi, speed, 2 * alpha * second / motion_time**2, x, travel, spin)

    return Timed(0.0, 0.5, 1.0, lambda k: (k - 0.5) * motion_time, driver_angle, place)


# Extremes


def zero(function, low, high):
    """Where a function changes its sign, by bisection to the last digit."""
    below = function(low) > 0
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        if (function(middle) > 0) == below:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def slope(function, at):
    return function(complex(at, STEP)).imag / STEP


def value(function, at):
    """A function's real value."""
    return complex(function(at)).real


def maximum(function, begin, end):
    """Place of the maximum value of an analytic function, the first of several equal ones.

    The slope of a function that is greatest at an end does not change its sign beside it: then the end is the place.
    """
    count = 2400
    margin = 1e-4 * (end - begin)  # formulas may be 0/0 at the very ends
    places = [begin + margin + (end - begin - 2 * margin) * i / count for i in range(count + 1)]
    best = 0
    values = [value(function, at) for at in places]
    for i, here in enumerate(values):
        if here > values[best] + 1e-9 * abs(values[best]):
            best = i
    while best < count and values[best + 1] > values[best]:
        best += 1
    if best in (0, count):
        return begin if best == 0 else end
    return zero(lambda at: slope(function, at), places[best - 1], places[best + 1])
