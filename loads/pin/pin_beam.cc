#include "loads/pin/pin_beam.h"

#include <cmath>

#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

/// A ring, or a full circle.
struct CrossSection {
  double area;    ///< A [m^2]
  double second;  ///< I [m^4]
  double share;   ///< of the bore in the diameter
};

CrossSection cross_section(const PinBeam& pin) {
  const double d = pin.diameter;
  const double share = pin.bore / d;
  return {pi * d * d / 4. * (1. - share * share),
          pi * std::pow(d, 4) / 64. * (1. - std::pow(share, 4)), share};
}

struct Stiffness {
  double bending;  ///< E I [N m^2]
  double shear;    ///< kappa G A [N]
};

Stiffness stiffness_of(const PinBeam& pin) {
  const double nu = pin.poissons_ratio;
  const CrossSection section = cross_section(pin);
  return {
      pin.youngs_modulus * section.second,
      shear_coefficient(nu, section.share) * pin.youngs_modulus / (2. * (1. + nu)) * section.area};
}

/// Cantilever of length `tip` held at s = 0, loaded by w from s = a to s = b.
BeamBending cantilever(const Stiffness& stiffness, const double w, const double a, const double b,
                       const double tip) {
  const auto difference = [&](const int power) { return std::pow(b, power) - std::pow(a, power); };
  const double middle = (a + b) / 2.;
  const double bending = w / 6. * (tip * difference(3) - difference(4) / 4.) / stiffness.bending;
  const double shear = w / 2. * difference(2) / stiffness.shear;
  // cross-sections turn by the integral of the moment only
  const double slope =
      w *
      ((std::pow(middle, 3) - std::pow(a, 3)) / 6. + middle * (b * b - middle * middle) / 2. -
       middle * middle * (b - middle) / 2.) /
      stiffness.bending;
  return {bending + shear, slope, w / 2. * difference(2), 0., w * (b - a), 0.};
}

/// Both ends clamped at the distance L, loaded by w over c around the middle: simply supported
/// beam and end moments w c (3 L^2 - c^2)/(24 L).
BeamBending clamped(const Stiffness& stiffness, const double w, const double L, const double c) {
  const double force = w * c;
  const double moment = force * (3. * L * L - c * c) / (24. * L);
  const double bending =
      force * (8. * L * L * L - 4. * L * c * c + c * c * c) / (384. * stiffness.bending) -
      moment * L * L / (8. * stiffness.bending);
  const double shear = force * (2. * L - c) / (8. * stiffness.shear);
  return {bending + shear, 0., moment, 0., force / 2., 0.};
}

}  // namespace

double shear_coefficient(const double poissons_ratio, const double bore_share) {
  const double nu = poissons_ratio;
  const double m = bore_share * bore_share;
  const double around = (1. + m) * (1. + m);
  return 6. * (1. + nu) * around / ((7. + 6. * nu) * around + (20. + 12. * nu) * m);
}

BeamBending beam_bending(const PinBeam& pin, const double force) {
  require_positive_length("pin diameter", pin.diameter);
  require_positive_length("wheel thickness", pin.thickness);
  require_not_negative("root gap", pin.root_gap, "m");
  require_not_negative("overhang", pin.overhang, "m");
  require_positive("pin force", force, "N");
  require_positive("Young's modulus", pin.youngs_modulus, "Pa");
  require_not_negative("bore diameter", pin.bore, "m");
  require_positive_length("wall of the hollow pin", (pin.diameter - pin.bore) / 2.);
  const double w = force / pin.thickness;
  const double end = pin.root_gap + pin.thickness;
  const Stiffness stiffness = stiffness_of(pin);
  BeamBending bending = pin.held_at_both_ends
                            ? clamped(stiffness, w, end + pin.root_gap, pin.thickness)
                            : cantilever(stiffness, w, pin.root_gap, end, end + pin.overhang);
  const CrossSection section = cross_section(pin);
  const double s = section.share;
  bending.root_stress = bending.root_moment * pin.diameter / (2. * section.second);
  bending.root_shear =
      4. / 3. * (1. + s + s * s) / (1. + s * s) * bending.root_force / section.area;
  return bending;
}

}  // namespace geneva::loads
