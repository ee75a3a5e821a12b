#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "loads/hertz.h"
#include "loads/motion/long_dwell_geneva.h"
#include "loads/motion/pin_load.h"

namespace geneva::web {

/// The mechanisms of the page.
enum class Kind { external, internal, spherical, long_dwell };

/// What the page asks for; SI units.
struct Inputs {
  Kind kind;
  int stations;
  /// Centre distance of an external or internal Geneva, radius of the sphere, or crank radius of a
  /// long-dwell Geneva [m].
  double size;
  double shaft_angle;                    ///< [rad], of a spherical Geneva
  double sprocket_spacing;               ///< [m], of a long-dwell Geneva
  loads::SprocketLine sprockets;         ///< of a long-dwell Geneva
  int pins;                              ///< equally spaced
  double driver_speed;                   ///< [rad/s], constant
  std::optional<double> pin_diameter;    ///< [m]; none: by Johnson's proportions
  std::optional<double> thickness;       ///< [m]; none: by Johnson's proportions
  std::optional<double> slot_clearance;  ///< [m], of a drawn wheel; none: 0
  std::optional<double> wheel_inertia;   ///< [kg m^2]; none: that of the drawn wheel
  loads::WheelLoad load;
  double slot_friction;
  loads::Elastic pin;
  loads::Elastic wheel;
  double wheel_density;  ///< [kg/m^3]
};

/// Reads the inputs by their names in Inputs; those that may be left away are null.
/// @throws base::InputError if stations or pins are no whole numbers
/// @throws nlohmann::json::exception if one is missing or of another kind
Inputs read_inputs(const nlohmann::json& document);

/// Motion, pin force, Hertz contact, Johnson's design and the drawing; SI units throughout, with
/// the keys of kinematics.json, design.json and mechanism.json where these have the figure. What
/// has no bound is null.
/// @throws base::InputError where the loads room does
nlohmann::json calculated(const Inputs& inputs);

}  // namespace geneva::web
