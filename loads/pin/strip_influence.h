#pragma once

namespace geneva::loads {

/// What a strip of semi-elliptic pressure does to its own middle line.
struct StripInfluence {
  double value;       ///< A(s)
  double derivative;  ///< dA/ds
};

/// The displacement [m] of a half-space on the line x = 0 under a semi-elliptic pressure of half
/// width b along x, that carries q [N/m] from z = 0 to z, is q A(z/b)/(pi E*) at z = 0 (Love 1929,
/// over x):
///
///     A(s) = (4/pi) int_0^(pi/2) asinh(s/sin t) cos^2 t dt,   dA/ds = (4/pi) sqrt(1 + s^2) (K - E)
///
/// with complete elliptic integrals of the modulus 1/sqrt(1 + s^2).
/// @param s any; A is odd
/// @return to 1e-9
StripInfluence strip_influence(double s);

}  // namespace geneva::loads
