#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "loads/hertz.h"
#include "loads/motion/driven_mechanism.h"
#include "loads/motion/kinematics.h"
#include "loads/motion/pin_load.h"

namespace geneva::loads {

/// Why an instant stands for an engagement.
enum class InstantRole {
  between,  ///< so that a spline through the instants gives the force
  entry,
  exit,
  greatest_force,          ///< on the driving wall
  greatest_braking_force,  ///< on the braking wall
  greatest_pressure_times_slip,
  jump  ///< beside a jump of the force: of the acceleration, or where slip turns round
};

/// "greatest force"
const char* name_of(InstantRole role);

/// An instant at which the pin presses on a wall.
struct CycleInstant {
  InstantRole role;
  std::size_t engagement;  ///< index in DrivenMechanism::engagements()
  PinLoad load;
};

/// The instants that stand for the engagements of a cycle.
struct CycleInstants {
  std::vector<CycleInstant> instants;  ///< by time, those of equal engagements once
  std::vector<double> wall_changes;    ///< driver angles [rad] at which no wall carries
  std::size_t left_out = 0;            ///< engagements that are like the first one
};

/// Chooses the instants of every engagement that differs from the first one: entry, exit, the
/// greatest forces, the greatest pressure times slip, both sides of each jump of the force, and
/// between them as many as a cubic spline of the force over time needs.
/// @param tolerance of that spline over the greatest force, > 0
/// @throws base::InputError where check() of the train does, and if the pin never presses
CycleInstants cycle_instants(const DrivenMechanism& driven, const WheelTrain& train,
                             const PinContact& contact, double tolerance);

/// A number of them at equal steps of time over each engagement, from entry to exit; those at which
/// nothing is pressed are left out.
/// @param count 3 or more
/// @throws base::InputError as above, and for a smaller count
CycleInstants even_instants(const DrivenMechanism& driven, const WheelTrain& train, int count);

}  // namespace geneva::loads
