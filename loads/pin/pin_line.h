#pragma once

#include <vector>

#include "loads/hertz.h"
#include "loads/pin/pin_profile.h"

namespace geneva::loads {

/// A solid round pin on the straight wall of a slot, in 3-D.
struct PinLine {
  Elastic pin;
  Elastic wheel;
  double radius;            ///< of the pin [m]
  double relative_radius;   ///< R of pin and wall [m]; the pin's on a straight wall
  PinClearance clearance;   ///< with the wheel's thickness and the pin's ends
  bool held_at_both_ends;   ///< held at the upper end alone otherwise
  double wheel_twist = 0.;  ///< by which a moment about the slot's axis turns the wheel [rad/(N m)]
};

/// The contact of one section of the pin.
struct PinSection {
  double place;      ///< z of its middle [m], 0 in the middle of the wheel's thickness
  double width;      ///< [m]
  double line_load;  ///< q >= 0 [N/m]
};

/// A pin that carries a force.
struct PinLineContact {
  std::vector<PinSection> sections;  ///< in ascending order of their places
  double peak_line_load = 0.;        ///< [N/m]
  double peak_pressure = 0.;         ///< sqrt(q E*/(pi R)) of that [Pa]
  double peak_place = 0.;            ///< [m]
  double begin = 0.;                 ///< where the contact begins [m]
  double end = 0.;                   ///< where it ends [m]
  double approach = 0.;              ///< of where the pin is held towards the wheel [m]
  double root_moment = 0.;           ///< bending moment where it is held, at the upper end [N m]
  double root_stress = 0.;           ///< 4 M/(pi R^3) [Pa]
  double error = 1.;                 ///< of the sections, relative, of the peak pressure
};

/// Sections of a pin, each in Hertz's line contact, that are coupled by half-spaces (Love 1929),
/// the bending of the pin and by what a round cylinder gives way more than both
/// (doc/theory.md, "The pin in space without finite elements").
/// @param force F > 0 [N]
/// @param accuracy by which the peak pressure may change when there are twice as many sections,
/// relative, > 0
/// @return with 48 sections at most where the contact reaches an end of the wall
/// @throws base::InputError if a size, modulus or force is not positive, if Poisson's ratio of the
/// pin is below 0, or if the sections find no balance
PinLineContact pin_line_contact(const PinLine& pin, double force, double accuracy);

/// Whether the contact ends before the wall, or its broken edge, does: only then it has a peak.
bool ends_inside(const PinLineContact& contact, const PinClearance& clearance);

}  // namespace geneva::loads
