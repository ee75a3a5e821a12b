"""Elastic waves of pressure on round cylinders, and what their surface gives way more than a half-space and a beam
(doc/theory.md, the pin in space). Shared by scripts/cylinder_kernel and scripts/annulus_kernel.

Radius and Young's modulus are 1. Needs python3-mpmath; 40 digits, since small wave numbers cancel 20 of them.
"""

from mpmath import (besseli, besselj, euler, gammainc, j, legendre, log, lu_solve, matrix, mp, mpf, pi, sqrt, zeta)

RATIOS = 7  # Poisson's ratios: Chebyshev's points of the second kind on 0 .. 0.5
PLACES = 57  # z = sinh(0.1 i)/4
FIRST, LAST = -16, 6  # panels of wave numbers from 2^FIRST to 2^LAST
NODES = 12  # of each panel


def fields(n, k, nu, f, f1):
    """Displacements on r = 1 by the potentials of Papkovich and Neuber: grad phi, 4(1 - nu) grad' psi - grad(r dpsi/dr)
    and curl(chi e_z), each of the radial function f (I_n(k r) or K_n(k r), f1 its slope) times cos or sin(n theta)
    cos(k z), grad' without its z component. For each
    (u_r, du_r/dr, u_theta, du_theta/dr, u_z, du_z/dr, lambda/(2G) div u).

    With k a for k these are the displacements on r = a but for the factor a, and stresses but for a^2."""
    f2 = (k * k + n * n) * f - f1
    f3 = (k * k + n * n) * f1 - 2 * n * n * f - f2 + f1
    a, h, h1 = 4 * (1 - nu), k * k + n * n, k * k - n * n
    result = [(f1, f2, -n * f, -n * (f1 - f), -k * f, -k * f1, 0),
              (a * f1 - h * f, a * f2 - h1 * f - h * f1, n * f1 - a * n * f, n * f2 - a * n * (f1 - f), k * f1,
               k * (f1 + f2), 2 * nu * k * k * f)]
    if n > 0:
        result.append((n * f, n * (f1 - f), -f1, -f2, 0, 0, 0))
    return result


def tractions(n, k, field):
    """Stresses rr, rz and r theta over 2 G of a field."""
    ur, ur1, ut, ut1, _, uz1, trace = field
    return trace + ur1, (-k * ur + uz1) / 2, (ut1 - n * ur - ut) / 2


def solid_displacement(n, k, nu):
    """c_n: inward displacement of a solid cylinder's surface under the pressure cos(n theta) cos(k z)."""
    f, below = besseli(n, k), besseli(n - 1, k)
    found = fields(n, k, nu, f, k * below - n * f if n > 0 else k * besseli(1, k))
    size = len(found)
    stresses = [tractions(n, k, field) for field in found]
    system = matrix([[stresses[column][row] for column in range(size)] for row in range(size)])
    shares = lu_solve(system, matrix([-(1 + nu)] + [0] * (size - 1)))
    return -sum(shares[i] * found[i][0] for i in range(size))


def solid_compliance(k, nu):
    """D(k): of a generator under the line load cos(k z) on it, less the half-space's: the sum of c_n over n, less that of
    the half-space's 2 (1 - nu^2)/sqrt(n^2 + k^2) without its periods, which is

        D = (1/pi) [c_0/2 + sum_n (c_n - 2 (1 - nu^2)/n) + 2 (1 - nu^2) (gamma + ln(k/2))].

    The sum is followed to its end by powers of 1/n."""
    split, powers, of_plane = int(24 + 3 * k), 10, 2 * (1 - nu**2)
    total = solid_displacement(0, k, nu) / 2 + of_plane * (euler + log(k / 2))
    total += sum(solid_displacement(n, k, nu) - of_plane / n for n in range(1, split))
    numbers = [int(split * (1 + mpf(i) / 3)) for i in range(powers)]
    shares = lu_solve(matrix([[(mpf(split) / n)**p for p in range(powers)] for n in numbers]),
                      matrix([(solid_displacement(n, k, nu) - of_plane / n) * mpf(n)**2 for n in numbers]))
    total += sum(shares[p] * mpf(split)**p * zeta(p + 2, split) for p in range(powers))
    return total / pi


def curvature(nu):
    """C of D = C/k + ... for short waves, of the surface's curvature."""
    return (1 - 2 * nu)**2 * (1 + nu) / 4


class Kernel:
    """V(z), the integral from 0 to z of the local kernel v, whose transform is D less that of the beam."""

    def __init__(self, nu, compliance, beam, last=LAST):
        """
        @param compliance D by wave number
        @param beam       share of 1/k^power by power, that D has of a beam
        @param last       the panels end at the wave number 2^last"""
        self.nu, self.compliance, self.beam, self.last = nu, compliance, beam, last
        with mp.workdps(40):
            self.panels = [self.panel(mpf(2)**i, mpf(2)**(i + 1)) for i in range(FIRST, last)]
            self.tail = self.tail_powers()
            self.head = self.head_powers()

    def local(self, k):
        """v^(k); small wave numbers cancel digits."""
        with mp.workdps(40 if k > mpf("0.01") else 60):
            return self.compliance(k) - sum(share / k**power for power, share in self.beam.items())

    def panel(self, first, last):
        """Legendre's coefficients of v^(k)/k on a panel."""
        nodes = self.gauss()
        middle, half = (first + last) / 2, (last - first) / 2
        values = [self.local(k) / k for k in (middle + half * x for x, _ in nodes)]
        return middle, half, [(2 * p + 1) / mpf(2) * sum(w * v * legendre(p, x) for (x, w), v in zip(nodes, values))
                              for p in range(NODES)]

    @staticmethod
    def gauss():
        """Nodes and weights on -1 .. 1."""
        result = []
        for i in range(NODES):
            x = mp.cos(pi * (i + mpf(3) / 4) / (NODES + mpf(1) / 2))
            for _ in range(8):  # Newton's iterations
                slope = NODES * (x * legendre(NODES, x) - legendre(NODES - 1, x)) / (x * x - 1)
                x -= legendre(NODES, x) / slope
            result.append((x, 2 / ((1 - x * x) * slope**2)))
        return result

    def tail_powers(self):
        """Of D beyond the last panel, by powers of 1/k from the first on; that one is known."""
        known, ends = curvature(self.nu), [mpf(2)**self.last * (1 + mpf(i) / 4) for i in range(5)]
        system = matrix([[k**-p for p in range(2, 7)] for k in ends])
        return [known] + list(lu_solve(system, matrix([self.compliance(k) - known / k for k in ends])))

    def head_powers(self):
        """alpha, beta of v^ = alpha ln k + beta before the first panel."""
        places = [mpf(2)**FIRST, mpf(2)**(FIRST + 2)]
        values = [self.local(k) for k in places]
        slope = (values[1] - values[0]) / log(places[1] / places[0])
        return slope, values[0] - slope * log(places[0])

    def at(self, z):
        """V and v = dV/dz."""
        end = mpf(2)**self.last
        powers = [(p + 1, share) for p, share in enumerate(self.tail)]
        powers += [(power, -share) for power, share in self.beam.items()]
        total = slope = mpf(0)
        for power, share in powers:  # share/k^power beyond the end
            total += share * self.wave(end, z, power + 1).imag
            slope += share * self.wave(end, z, power).real
        for middle, half, shares in self.panels:
            bessel = [spherical(p, half * z) for p in range(NODES + 1)]
            by_k = sum(share * j**p * bessel[p] for p, share in enumerate(shares))
            total += (2 * half * mp.expj(middle * z) * by_k).imag
            slope += self.slope_of_panel(middle, half, shares, z, bessel)
        alpha, beta = self.head
        first = mpf(2)**FIRST
        begin = first * (alpha * (log(first) - 1) + beta)
        return (total + z * begin) / pi, (slope + begin) / pi

    @staticmethod
    def slope_of_panel(middle, half, shares, z, bessel):
        """The integral of v^ cos(k z): k P_p is (p + 1) P_(p+1) + p P_(p-1) over 2 p + 1 times half, and middle P_p."""
        by_k = [mpf(0)] * (NODES + 1)
        for p, share in enumerate(shares):
            by_k[p] += middle * share
            by_k[p + 1] += half * share * (p + 1) / (2 * p + 1)
            if p > 0:
                by_k[p - 1] += half * share * p / (2 * p + 1)
        total = sum(share * j**p * bessel[p] for p, share in enumerate(by_k))
        return (2 * half * mp.expj(middle * z) * total).real

    @staticmethod
    def wave(first, z, power):
        """Integral of exp(i k z)/k^power from first on."""
        if z == 0:
            return first**(1 - power) / (power - 1) if power > 1 else mp.inf
        return (-j * z)**(power - 1) * gammainc(1 - power, -j * first * z)

    def smooth(self, z):
        """V and v without their logarithm at 0: with (C/pi) z ln(z/sqrt(1 + z^2)) added."""
        share = curvature(self.nu) / pi
        if z == 0:  # V is 0 there, and v has a limit
            return mpf(0), self.smooth(mpf(10)**-8)[1]
        value, slope = self.at(z)
        part = log(z / sqrt(1 + z * z))
        return value + share * z * part, slope + share * (part + 1 - z * z / (1 + z * z))


@mp.memoize
def spherical(p, x):
    if x == 0:
        return mpf(1) if p == 0 else mpf(0)
    return sqrt(pi / (2 * x)) * besselj(p + mpf(1) / 2, x)


def ratios():
    return [mpf(1) / 4 * (1 - mp.cos(pi * i / (RATIOS - 1))) for i in range(RATIOS)]


def place(i):
    return mp.sinh(mpf(i) / 10) / 4


def line(entry, digits=15):
    """Of a table, from V and v."""
    value, slope = (mp.nstr(number, digits, strip_zeros=False) for number in entry)
    return f"    {{{value}, {slope}}},"
