#pragma once

#include <optional>

#include "loads/motion/four_bar.h"
#include "loads/motion/mechanism.h"

namespace geneva::loads {

/// Where the wheel of a four-bar Geneva stands.
struct WheelPlace {
  double direction;                ///< of the wheel's axis from the crank's, from the x axis [rad]
  std::optional<double> distance;  ///< of the two axes [m]; none: found from the tangency
};

/// A four-bar Geneva and what follows from its linkage.
struct FourBarGeneva {
  Mechanism mechanism;
  double centre_distance;  ///< of crank and wheel axis [m]
  double crank_angle;      ///< phi_2 [rad] of the linkage midway through the engagement, where the
                           ///< mechanism's driver angle is 0
};

/// Four-bar Geneva: a point of the coupler drives the slotted wheel (Lecture 4).
///
/// The pin enters where its path is tangent to the slot, so that the wheel starts without a jump,
/// and leaves when the wheel has turned by 2 pi/n; the path is tangent to the slot there as well
/// only if the wheel's axis has the right place, which is looked for along its direction if the
/// distance is not given. tangency_defect() tells what is left at the exit.
/// @param stations 3..24
/// @param linkage a crank that turns fully
/// @throws base::InputError outside of that, if the coupler point does not turn the wheel by a
/// pitch (with the maximum angle that it reaches), or if no distance along the direction does
FourBarGeneva four_bar_geneva(int stations, const FourBar& linkage, Assembly assembly,
                              const WheelPlace& place);

}  // namespace geneva::loads
