#pragma once

#include <optional>
#include <string>
#include <vector>

#include "api/case.h"
#include "loads/motion/kinematics.h"
#include "post/output/cycle_output.h"
#include "post/output/limit_rows.h"

namespace geneva::api {

/// A figure and the driver angle at which it occurs.
struct PlacedValue {
  double value;
  double driver_angle;  ///< [rad]
};

/// The peak pressure of a pin's line contact beside what the case and the materials of pin and
/// wheel allow, as `geneva run` judges it.
/// @param contact of pin and wheel
std::vector<post::LimitRow> pressure_limits(const Case& given, const loads::PinContact& contact,
                                            const PlacedValue& pressure);

/// Which limits of the contact's yielding are not judged, and why; empty if none is left out.
std::string unjudged_yield(const Case& given);

/// Pressure and pressure times slip speed over the cycle by the closed forms, beside their limits.
/// @param pressure greatest of the cycle; none: no limit of a pressure is judged
std::vector<post::LimitRow> motion_limits(const Case& given, const loads::PinContact& contact,
                                          const loads::Characteristics& values,
                                          const std::optional<PlacedValue>& pressure);

/// The same of a cycle by finite elements, and the stresses outside the contact's own field.
std::vector<post::LimitRow> cycle_limits(const Case& given, const loads::PinContact& contact,
                                         const post::CycleReport& report);

}  // namespace geneva::api
