#pragma once

namespace geneva::loads::test::johnson_units {

// Johnson's units: inch, pound-force, second.
constexpr double inch = 0.0254;
constexpr double pound = 4.4482216152605;
constexpr double psi = pound / (inch * inch);
constexpr double moment_unit = pound * inch;   // lbf in
constexpr double inertia_unit = pound * inch;  // lbf s^2 in: the same number of SI units
constexpr double density = 0.283 / 386. * pound / (inch * inch * inch * inch);  // w/g, lbf s^2/in^4

}  // namespace geneva::loads::test::johnson_units
