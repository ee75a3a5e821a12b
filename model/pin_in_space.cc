#include "model/pin_in_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "loads/hertz.h"
#include "loads/pi.h"
#include "model/block_dimensions.h"
#include "model/input/parameters.h"
#include "model/wheel_twist.h"

namespace geneva::model {

namespace {

using Hold = PinHolding::Hold;
using Profile = PinCase::Profile;

/// Free lengths beside the wheel over the pin diameter, unless the case gives them.
constexpr double default_free_length = 0.25;

loads::PinProfile profile_of(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  switch (pin.profile) {
    case Profile::crown:
      return loads::Crown{pin.crown_radius};
    case Profile::table:
      return pin.table;
    case Profile::cylindrical:
      return loads::Cylinder{};
    case Profile::logarithmic:
      break;
  }
  const double length = pin.profile_length.value_or(state.sizes.thickness);
  const double modulus = contact_modulus(mechanism);
  double load = pin.profile_load.value_or(state.load.force);
  if (pin.profile_amplitude) load = *pin.profile_amplitude * loads::pi * length * modulus;
  const loads::HertzLine hertz =
      loads::hertz_line(load / length, state.sizes.pin_diameter / 2., modulus);
  return loads::logarithmic_profile(load, length, modulus, hertz.half_width);
}

loads::PinHold hold_of(const Hold hold) {
  if (hold == Hold::both_ends) return loads::PinHold::both_ends;
  return hold == Hold::core ? loads::PinHold::core : loads::PinHold::one_end;
}

}  // namespace

bool reaches_bottom(const MechanismCase& mechanism, const MechanismState& state) {
  if (mechanism.is_local || !state.wheel) return false;
  const double line_load = state.load.force / state.sizes.thickness;
  const double reach =
      loads::hertz_line(line_load, state.sizes.pin_diameter / 2., contact_modulus(mechanism))
          .half_width;
  const double from_bottom = std::visit(
      [&](const auto& wheel) {
        return std::abs(state.load.pin_distance - slot_bottom_centre(wheel));
      },
      *state.wheel);
  return from_bottom < reach;
}

double contact_modulus(const MechanismCase& mechanism) {
  const auto elastic = [](const CaseMaterial& material) {
    return loads::Elastic{material.youngs_modulus, material.poissons_ratio};
  };
  return loads::contact_modulus(elastic(mechanism.pin), elastic(mechanism.wheel));
}

PinLengths pin_lengths(const MechanismCase& mechanism, const MechanismSizes& sizes) {
  const PinHolding& holding = mechanism.pin_holding;
  const std::optional<PinCase>& pin = mechanism.space;
  const double usual = default_free_length * sizes.pin_diameter;
  const double gap = holding.root_gap.value_or(holding.hold == Hold::core ? 0. : usual);
  if (holding.hold == Hold::both_ends) return {gap, 0.};
  const double free_ends = holding.hold == Hold::core ? 2. : 1.;
  if (pin && pin->length) return {gap, (*pin->length - gap - sizes.thickness) / free_ends};
  return {gap, pin ? pin->overhang.value_or(usual) : usual};
}

bool is_half_model(const MechanismCase& mechanism) {
  return mechanism.space && mechanism.pin_holding.hold == Hold::both_ends &&
         mechanism.space->tilt == 0. && mechanism.space->profile != Profile::table;
}

loads::PinClearance pin_clearance(const MechanismCase& mechanism, const MechanismState& state) {
  const PinCase& pin = *mechanism.space;
  const PinLengths lengths = pin_lengths(mechanism, state.sizes);
  const double half = state.sizes.thickness / 2.;
  loads::PinClearance clearance;
  clearance.profile = profile_of(mechanism, state);
  clearance.tilt = mechanism.is_mirrored ? -pin.tilt : pin.tilt;
  clearance.wall_half = half;
  clearance.wall_edge = pin.slot_edge;
  const Hold hold = mechanism.pin_holding.hold;
  const bool held_twice = hold == Hold::both_ends;
  clearance.lower_end = -half - (held_twice ? lengths.root_gap : lengths.overhang);
  clearance.upper_is_free = hold == Hold::core;
  clearance.upper_end = half + (clearance.upper_is_free ? lengths.overhang : lengths.root_gap);
  clearance.pin_chamfer = held_twice ? 0. : pin.end_chamfer;
  loads::check(clearance.profile, std::max(-clearance.lower_end, clearance.upper_end));
  return clearance;
}

std::optional<loads::PinBeam> pin_beam(const MechanismCase& mechanism,
                                       const MechanismSizes& sizes) {
  const Hold hold = mechanism.pin_holding.hold;
  if (hold == Hold::core) return std::nullopt;
  const PinLengths lengths = pin_lengths(mechanism, sizes);
  const bool is_stud = mechanism.roller.has_value();
  const CaseMaterial& material = is_stud ? mechanism.stud : mechanism.pin;
  return loads::PinBeam{is_stud ? mechanism.roller->stud() - mechanism.bore_clearance.value_or(0.)
                                : sizes.pin_diameter,
                        sizes.thickness,
                        lengths.root_gap,
                        lengths.overhang,
                        hold == Hold::both_ends,
                        material.youngs_modulus,
                        material.poissons_ratio,
                        is_stud ? 0. : mechanism.pin_holding.bore_diameter.value_or(0.)};
}

loads::PinLine pin_line(const MechanismCase& mechanism, const MechanismState& state) {
  for (const CaseMaterial& material : {mechanism.pin, mechanism.wheel})
    if (material.poissons_ratio < 0.)
      throw base::InputError(
          fmt::format("Poisson's ratio {:.6g}: line contacts along the pin are known from 0 on",
                      material.poissons_ratio));
  if (reaches_bottom(mechanism, state))
    throw base::InputError(
        "the pin stands in the round bottom of its slot: line contacts along the pin are known on "
        "its straight walls");
  const double radius = state.sizes.pin_diameter / 2.;
  return {{mechanism.pin.youngs_modulus, mechanism.pin.poissons_ratio},
          {mechanism.wheel.youngs_modulus, mechanism.wheel.poissons_ratio},
          radius,
          radius,
          pin_clearance(mechanism, state),
          hold_of(mechanism.pin_holding.hold),
          wheel_twist(mechanism, state),
          mechanism.pin_holding.hold == Hold::core
              ? block_dimensions(mechanism, state.sizes).pin_core_radius
              : mechanism.pin_holding.bore_diameter.value_or(0.) / 2.};
}

std::optional<KnownPinLine> pin_line_contact(const MechanismCase& mechanism,
                                             const MechanismState& state) {
  constexpr double accuracy = 5e-4;
  if (!mechanism.space) return std::nullopt;
  try {
    const loads::PinLine pin = pin_line(mechanism, state);
    const double force = state.load.force;
    return KnownPinLine{
        pin, loads::resolved_edges(pin, force, loads::pin_line_contact(pin, force, accuracy))};
  } catch (const base::InputError&) {
    return std::nullopt;
  }
}

std::string pin_holder(const MechanismCase& mechanism) {
  return mechanism.pin_holding.hold == Hold::core ? "pin core" : "pin root";
}

}  // namespace geneva::model
