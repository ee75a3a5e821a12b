#pragma once

#include <optional>

#include "app/case_file.h"
#include "app/mechanism_motion.h"
#include "loads/driven_mechanism.h"
#include "loads/geneva_dimensions.h"
#include "loads/outline.h"
#include "loads/pin_load.h"

namespace geneva::app {

/// What the mechanism's kinematics and torque balance say, SI units.
struct MechanismState {
  loads::DrivenMechanism driven;
  loads::WheelTrain train;
  MechanismSizes sizes;
  std::optional<loads::GenevaDimensions> wheel;  ///< of the drawn wheel, if there is one
  loads::PinLoad load;                           ///< at the analysed driver angle
  double inertia_from_geometry;                  ///< [kg m^2]; 0 without a drawn wheel
  double expected_bore_torque;                   ///< J_L a + M_f + M_e [N m]
};

/// @throws std::invalid_argument if the drawn wheel's dimensions do not fit together
void check_drawing(const MechanismCase& mechanism);

/// Kinematics, dimensions and pin force of a mechanism case.
/// @throws std::invalid_argument where the loads room does, and if no force presses the pin on the
/// driving wall
MechanismState mechanism_state(const MechanismCase& mechanism);

}  // namespace geneva::app
