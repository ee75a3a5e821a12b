#pragma once

#include <optional>
#include <string>
#include <vector>

#include "loads/pin/pin_beam.h"
#include "loads/pin/pin_line.h"
#include "loads/pin/pin_profile.h"
#include "model/mechanism_state.h"

namespace geneva::model {

/// Lengths of the pin beside the wheel, whose middle plane is z = 0; the pin is held above it.
struct PinLengths {
  double root_gap;  ///< [m], >= 0
  double overhang;  ///< [m]; negative if the pin ends within the slot; 0 if held at both ends
};

PinLengths pin_lengths(const MechanismCase& mechanism, const MechanismSizes& sizes);

/// Whether one half of pin and wheel is solved, z > 0: the pin is held at both ends and nothing
/// tells them apart.
bool is_half_model(const MechanismCase& mechanism);

/// Whether the contact reaches the slot's round bottom, where the wall is not straight.
bool reaches_bottom(const MechanismCase& mechanism, const MechanismState& state);

/// E* of pin and wheel [Pa].
double contact_modulus(const MechanismCase& mechanism);

/// What profile, tilt and edge breaks add to the gap.
/// @throws base::InputError where the loads room does
loads::PinClearance pin_clearance(const MechanismCase& mechanism, const MechanismState& state);

/// The pin as a beam, in the plane a roller's stud instead; none if its core is held.
std::optional<loads::PinBeam> pin_beam(const MechanismCase& mechanism, const MechanismSizes& sizes);

/// The pin as line contacts that half-spaces and a beam couple, with the wheel's twist.
/// @throws base::InputError if the pin stands in the round bottom of its slot, or Poisson's ratio
/// of pin or wheel is negative
loads::PinLine pin_line(const MechanismCase& mechanism, const MechanismState& state);

/// Of the pin as line contacts, under the pin force.
struct KnownPinLine {
  loads::PinLine pin;
  loads::PinLineContact contact;
};

/// None where line contacts know no answer.
std::optional<KnownPinLine> pin_line_contact(const MechanismCase& mechanism,
                                             const MechanismState& state);

/// Name of the surface that holds the pin: "pin root" or "pin core".
std::string pin_holder(const MechanismCase& mechanism);

}  // namespace geneva::model
