#include "loads/design/shaft.h"

#include <cmath>

#include "base/errors.h"
#include "loads/design/johnson.h"
#include "loads/pi.h"
#include "loads/require.h"

namespace geneva::loads {

namespace {

void check_segments(const Shaft& shaft) {
  if (shaft.segments.empty())
    throw base::InputError(
        "the shaft has 0 segments: it must have one at least; give a diameter and a length");
  for (const ShaftSegment& segment : shaft.segments) {
    require_positive_length("shaft diameter", segment.diameter);
    require_positive_length("shaft length", segment.length);
  }
}

}  // namespace

double equivalent_length(const Shaft& shaft, const double diameter) {
  check_segments(shaft);
  require_positive_length("diameter of the equivalent shaft", diameter);
  double length = 0.;
  for (const ShaftSegment& segment : shaft.segments)
    length += segment.length * std::pow(diameter / segment.diameter, 4);
  return length;
}

double torsional_stiffness(const Shaft& shaft) {
  check_segments(shaft);
  require_positive("shear modulus", shaft.shear_modulus, "Pa");
  // any diameter does: Johnson's J_s (Eq. 12) of the first segment, and the length that goes with
  // it
  const double diameter = shaft.segments.front().diameter;
  const double polar_moment = pi * std::pow(diameter, 4) / 32.;
  return shaft.shear_modulus * polar_moment / equivalent_length(shaft, diameter);
}

double shaft_inertia(const Shaft& shaft) {
  check_segments(shaft);
  double inertia = 0.;
  for (const ShaftSegment& segment : shaft.segments)
    inertia += solid_cylinder_inertia(segment.diameter, segment.length, shaft.density);
  return inertia;
}

TorsionalVibration torsional_vibration(const Shaft& shaft, const double load_inertia,
                                       const double exit_acceleration) {
  require_positive("load inertia", load_inertia, "kg m^2");
  require_not_negative("exit acceleration", exit_acceleration, "rad/s^2");
  TorsionalVibration result{};
  result.torque = load_inertia * exit_acceleration;
  result.stiffness = torsional_stiffness(shaft);
  result.twist = result.torque / result.stiffness;
  result.frequency = std::sqrt(result.stiffness / load_inertia) / (2. * pi);
  result.energy = result.stiffness * result.twist * result.twist / 2.;
  return result;
}

}  // namespace geneva::loads
