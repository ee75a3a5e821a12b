#include "api/roller_choice.h"

#include <algorithm>

#include "api/mechanism_picture.h"
#include "base/errors.h"
#include "loads/pin/pin_beam.h"
#include "model/mechanism_state.h"
#include "model/pin_in_space.h"

namespace geneva::api {

namespace {

using base::Dimension;

model::MechanismCase as_fixed(model::MechanismCase mechanism) {
  mechanism.slot_friction = mechanism.roller->friction;
  mechanism.roller.reset();
  mechanism.bore_clearance.reset();
  return mechanism;
}

/// Greatest bending stress at the root over the cycle, by beam theory [Pa]; none of a pin that is
/// held at its core.
std::optional<double> root_stress(const model::MechanismCase& mechanism,
                                  const loads::Characteristics& cycle) {
  const model::MechanismDynamics dynamics = model::mechanism_dynamics(mechanism);
  const auto beam = model::pin_beam(mechanism, dynamics.sizes);
  const double force = std::max(cycle.force.value, cycle.braking_force.value);
  if (!beam || force == 0.) return std::nullopt;
  return loads::beam_bending(*beam, force).root_stress;
}

/// The duty of a bush, or the most loaded needle.
post::PinChoiceRow bearing_row(const model::MechanismCase& mechanism,
                               const loads::Characteristics& cycle) {
  const loads::RollerBore& roller = *mechanism.roller;
  if (!roller.needles)
    return {"maximum mean bore pressure x sliding speed", Dimension::pressure_times_speed,
            cycle.bore_pressure_times_speed.value, std::nullopt};
  const double force = std::max(cycle.force.value, cycle.braking_force.value);
  return {"maximum pressure, needle on stud", Dimension::stress,
          loads::needle_pressure(*roller.needles, roller.diameter, force,
                                 {mechanism.stud.youngs_modulus, mechanism.stud.poissons_ratio}),
          std::nullopt};
}

}  // namespace

std::vector<post::PinChoiceRow> roller_choice(const model::MechanismCase& mechanism,
                                              const loads::Characteristics& roller) {
  if (!mechanism.roller) return {};
  const model::MechanismCase alternative = as_fixed(mechanism);
  const model::MechanismDynamics dynamics = model::mechanism_dynamics(alternative);
  const loads::WheelTrain train = model::mechanism_dynamics(mechanism).train;
  loads::Characteristics fixed{};
  try {
    fixed = loads::characteristics(dynamics.driven, dynamics.train,
                                   pin_contact(alternative, dynamics.sizes));
  } catch (const base::InputError&) {
    return {};  // with so much friction a fixed pin would jam
  }
  std::vector<post::PinChoiceRow> rows{
      {"friction along the wall over the pin force", Dimension::dimensionless,
       loads::friction_along_wall(train), loads::friction_along_wall(dynamics.train)},
      {"maximum pin force", Dimension::force,
       std::max(roller.force.value, roller.braking_force.value),
       std::max(fixed.force.value, fixed.braking_force.value)},
      {"maximum Hertz pressure on the wall", Dimension::stress, roller.pressure.value,
       fixed.pressure.value},
      {"maximum pressure x slip on the wall", Dimension::pressure_times_speed,
       roller.pressure_times_slip.value, fixed.pressure_times_slip.value},
      bearing_row(mechanism, roller)};
  const auto stud = root_stress(mechanism, roller);
  const auto pin = root_stress(alternative, fixed);
  if (stud && pin) rows.push_back({"bending stress at the root", Dimension::stress, *stud, *pin});
  return rows;
}

}  // namespace geneva::api
