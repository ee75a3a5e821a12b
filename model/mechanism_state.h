#pragma once

#include <optional>
#include <variant>

#include "loads/motion/driven_mechanism.h"
#include "loads/motion/pin_load.h"
#include "loads/wheel/geneva_dimensions.h"
#include "loads/wheel/internal_dimensions.h"
#include "model/input/case_file.h"
#include "model/mechanism_motion.h"

namespace geneva::model {

/// A mechanism that moves and has inertia, SI units.
struct MechanismDynamics {
  loads::DrivenMechanism driven;
  loads::WheelTrain train;
  MechanismSizes sizes;
  std::optional<DrawnWheel> wheel;              ///< none with mechanisms whose wheel is not drawn
  std::optional<double> inertia_from_geometry;  ///< [kg m^2]; none without a drawn wheel
};

/// A mechanism at the analysed driver angle; of a mirrored case its mirror image.
struct MechanismState : MechanismDynamics {
  loads::PinLoad load;
  double expected_bore_torque;  ///< J_L a + M_f + M_e [N m]
};

/// @throws base::InputError if the drawn wheel's dimensions do not fit together
void check_drawing(const MechanismCase& mechanism);

/// Kinematics, dimensions and inertia of a mechanism case.
/// @throws base::InputError where the loads room does
MechanismDynamics mechanism_dynamics(const MechanismCase& mechanism);

/// The same with the pin force at the angle that the case wants to be analysed.
/// @throws base::InputError where the loads room does, and if no force presses the pin on the
/// driving wall
MechanismState mechanism_state(const MechanismCase& mechanism);

}  // namespace geneva::model
