#pragma once

#include <vector>

#include "loads/hertz.h"
#include "loads/pin/pin_profile.h"

namespace geneva::loads {

/// Where a pin is held.
enum class PinHold {
  one_end,  ///< the upper one
  both_ends,
  core  ///< over the whole length
};

/// A round pin on the straight wall of a slot, in 3-D.
struct PinLine {
  Elastic pin;
  Elastic wheel;
  double radius;           ///< of the pin [m]
  double relative_radius;  ///< R of pin and wall [m]; the pin's on a straight wall
  PinClearance clearance;  ///< with the wheel's thickness and the pin's ends
  PinHold hold;
  double wheel_twist = 0.;   ///< by which a moment about the slot's axis turns the wheel [rad/(N
                             ///< m)], more than the block of SlabKernel
  double inner_radius = 0.;  ///< of the bore; held at the core: of that [m]
};

/// The contact of one section of the pin.
struct PinSection {
  double place;            ///< z of its middle [m], 0 in the middle of the wheel's thickness
  double width;            ///< [m]
  double line_load;        ///< q >= 0 [N/m]
  double half_width = 0.;  ///< b [m], >= 0
};

/// A pin that carries a force.
struct PinLineContact {
  std::vector<PinSection> sections;  ///< in ascending order of their places
  double peak_line_load = 0.;        ///< [N/m]
  double peak_pressure = 0.;         ///< of that [Pa], see peak_contact()
  double peak_place = 0.;            ///< [m]
  double begin = 0.;                 ///< where the contact begins [m]
  double end = 0.;                   ///< where it ends [m]
  double approach = 0.;              ///< of where the pin is held towards the wheel [m]
  double root_moment = 0.;           ///< bending moment where it is held, at the upper end [N m]
  double root_stress = 0.;           ///< M R/I there [Pa]
  double deflection = 0.;  ///< of the free end; held twice: of the wheel's middle plane [m]
  double slope = 0.;       ///< of the cross-section in the wheel's middle plane [rad]
  double error = 1.;       ///< of the sections, relative, of peak pressure and root moment
  /// Half-width at the peak where that stands on a rounded edge, see resolved_edges() [m]; 0
  /// elsewhere
  double edge_half_width = 0.;
};

/// Sections of a pin, each in Hertz's line contact, that are coupled by half-spaces (Love 1929),
/// the bending of the pin and by what a round cylinder gives way more than both
/// (doc/theory.md, "The pin in space without finite elements").
/// @param force F > 0 [N]
/// @param accuracy by which peak pressure and root moment may change when there are twice as many
/// sections, relative, > 0
/// @return with 48 sections at most where the contact reaches an end of the wall
/// @throws base::InputError if a size, modulus or force is not positive, if a Poisson's ratio is
/// below 0, if bore or core are not within the table's range, or if the sections find no balance
PinLineContact pin_line_contact(const PinLine& pin, double force, double accuracy);

/// A contact that reaches the rounded edge of the wall, with sections as fine there as the round:
/// of half of c = sqrt(2 r F/(pi t E*)), with which it falls off by F/(pi t E*), and of a quarter.
/// The width of the contact cannot follow its load there, see BendingWidths.
/// @param contact of pin_line_contact()
/// @return the contact itself where it reaches no edge, or no rounded one
PinLineContact resolved_edges(const PinLine& pin, double force, PinLineContact contact);

/// Why line contacts do not know the peak pressure.
enum class PeakDoubt {
  none,
  reaches_edge,    ///< of the wall, or where it begins to be broken, unless that is resolved
  at_profile_end,  ///< the peak is where a logarithmic profile falls within the contact's width
  not_settled      ///< it still changes with the number of sections
};

PeakDoubt peak_doubt(const PinLine& pin, const PinLineContact& contact);

/// Of the peak pressure, relative: of the sections; half of what peak_contact() adds, since no
/// contact is quite an ellipse; and of what is left, as measured beside finite elements
/// (doc/validation.md).
double expected_error(const PinLine& pin, const PinLineContact& contact);

/// The section of the peak: Hertz's line contact, of which a contact of half-length a has a greater
/// pressure by the factor sqrt((1 - k^2)/(E - k^2 K)) and is narrower by it, k = b/a, with complete
/// elliptic integrals of the modulus sqrt(1 - k^2). This makes it Hertz's ellipse, if it is one
/// (K. L. Johnson, 1985, Eq. 4.26).
HertzLine peak_contact(const PinLine& pin, const PinLineContact& contact);

/// Whether it bends as a beam where it is held: held at both ends nearer to the wheel than 1.3
/// diameters its root moment is 10 to 90 % off (doc/validation.md).
bool is_beam(const PinLine& pin);

/// Whether an end of the pin, free or held, is nearer to the contact than the pin's radius: its
/// deflection is then up to 7 % off (doc/validation.md), since it is taken as a long cylinder.
bool is_near_end(const PinLine& pin, const PinLineContact& contact);

/// q at a place [N/m]: straight between the middles of the sections; 0 beyond them.
double line_load_at(const PinLineContact& contact, double place);

}  // namespace geneva::loads
