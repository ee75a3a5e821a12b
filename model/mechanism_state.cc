#include "model/mechanism_state.h"

#include <fmt/format.h>

#include <utility>

#include "base/errors.h"
#include "loads/design/johnson.h"
#include "loads/pi.h"
#include "loads/wheel/internal_outline.h"
#include "loads/wheel/outline.h"
#include "model/input/parameters.h"

namespace geneva::model {

namespace {

double drawn_inertia(const DrawnWheel& wheel, const double density) {
  if (const auto* external = std::get_if<loads::GenevaDimensions>(&wheel))
    return loads::wheel_inertia(*external, density);
  return loads::internal_wheel_inertia(std::get<loads::InternalDimensions>(wheel), density);
}

double inertia_used(const MechanismCase& mechanism, const std::optional<double> from_geometry,
                    const double wheel_diameter) {
  switch (mechanism.inertia_kind) {
    case MechanismCase::InertiaKind::from_geometry:
      return from_geometry.value();
    case MechanismCase::InertiaKind::given:
      return mechanism.wheel_inertia;
    case MechanismCase::InertiaKind::johnson:
      break;
  }
  const auto k5 = loads::johnson_row(mechanism.dimensions.stations).k5;
  if (!k5)
    throw base::InputError(fmt::format(
        "'Wheel inertia' = 'Johnson': his Table 1 ends at 10 stations, the case has {}; use 'from "
        "geometry' or give a value",
        mechanism.dimensions.stations));
  return loads::johnson_wheel_inertia(*k5, mechanism.wheel.density, wheel_diameter);
}

/// The mirror image about the slot's axis: turns and moments about the wheel's axis change their
/// sign, and the walls their parts; what slides along the slot does not.
loads::PinLoad mirrored(loads::PinLoad load) {
  for (double* const value : {&load.wheel_angle, &load.wheel_speed, &load.wheel_acceleration,
                              &load.pin_turn_speed, &load.moment, &load.force})
    *value = -*value;
  std::swap(load.slip_driving, load.slip_braking);
  if (load.wall != loads::Wall::none)
    load.wall = load.wall == loads::Wall::driving ? loads::Wall::braking : loads::Wall::driving;
  return load;
}

void refuse_braking(const loads::PinLoad& load, const MechanismDynamics& dynamics) {
  const double peak_angle = loads::peak_force_angle(dynamics.driven, dynamics.train);
  const loads::PinLoad peak =
      loads::pin_load(dynamics.driven.at_engaged_angle(peak_angle), dynamics.train);
  throw base::InputError(fmt::format(
      "'Driver angle' = {:.6g} deg: the pin force there is {:.4g} N, so the pin does not press on "
      "the driving wall; {}",
      load.driver_angle / loads::degree, load.force,
      peak.force > 0.
          ? fmt::format("choose an angle with a positive force, for example '{}' ({:.6g} deg)",
                        names::at_maximum_force, peak_angle / loads::degree)
          : "nor does it anywhere else: give the wheel an inertia, a friction moment or an "
            "external torque against its motion"));
}

}  // namespace

void check_drawing(const MechanismCase& mechanism) {
  static_cast<void>(mechanism.type->drawn_wheel(mechanism.dimensions));
}

MechanismDynamics mechanism_dynamics(const MechanismCase& mechanism) {
  const MechanismSizes sizes = sizes_of(mechanism);
  const auto wheel = mechanism.type->drawn_wheel(mechanism.dimensions);
  std::optional<double> from_geometry;
  if (wheel) from_geometry = drawn_inertia(*wheel, mechanism.wheel.density);
  const loads::WheelTrain train{inertia_used(mechanism, from_geometry, sizes.wheel_diameter),
                                mechanism.load,
                                mechanism.external_torque,
                                mechanism.slot_friction,
                                sizes.pin_diameter,
                                mechanism.roller};
  return {driven_mechanism(mechanism), train, sizes, wheel, from_geometry};
}

MechanismState mechanism_state(const MechanismCase& mechanism) {
  MechanismState state{mechanism_dynamics(mechanism), {}, 0.};
  const double angle = analysed_angle(mechanism, state.driven, state.train);
  state.load = loads::pin_load(state.driven.at_engaged_angle(angle), state.train);
  if (mechanism.is_mirrored) state.load = mirrored(state.load);
  if (state.load.force <= 0.) refuse_braking(state.load, state);
  // What a roller's friction carries of the moment is not in the contact with the wall.
  const double arm =
      mechanism.roller ? state.load.pin_distance : state.load.moment / state.load.force;
  state.load.force = mechanism.pin_force.value_or(state.load.force);
  state.expected_bore_torque =
      state.load.force * arm - state.train.wheel_inertia * state.load.wheel_acceleration;
  return state;
}

}  // namespace geneva::model
