#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "loads/drawing/mechanism_drawing.h"
#include "loads/motion/kinematics.h"

namespace geneva::post {

/// A length of the mechanism with its name.
struct NamedLength {
  std::string name;
  double value;  ///< [m]
};

/// A mechanism at one instant of its cycle.
struct MechanismStep {
  loads::KinematicsRow row;
  std::vector<loads::Place> pins;
  loads::Polyline linkage;  ///< joints of a linkage from pivot to pivot, then the pin; may be empty
};

/// Everything that a drawing of a moving mechanism needs, SI units.
struct MechanismDrawing {
  std::string name;
  std::vector<loads::Polyline> wheel;  ///< at wheel angle 0
  loads::Polyline pin_path;
  std::optional<loads::Place> driver_axis;  ///< that the pins turn about
  std::optional<double> locking_radius;     ///< of the driver's locking disc [m]
  double pin_diameter;                      ///< [m]
  std::vector<NamedLength> lengths;
  std::vector<MechanismStep> steps;       ///< over the cycle
  std::optional<MechanismStep> analysed;  ///< at which a run computes the contact
};

/// What mechanism.json says, SI units throughout.
nlohmann::json mechanism_document(const MechanismDrawing& drawing);

}  // namespace geneva::post
