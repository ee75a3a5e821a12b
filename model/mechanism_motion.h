#pragma once

#include <string>
#include <vector>

#include "loads/design/johnson.h"
#include "loads/motion/driven_mechanism.h"
#include "loads/motion/pin_load.h"
#include "model/input/case_file.h"

namespace geneva::model {

using loads::MechanismSizes;

/// The mechanism of a case.
/// @throws base::InputError where the loads room does
loads::Mechanism mechanism_of(const MechanismCase& mechanism);

/// Engagements of its pins.
/// @throws base::InputError where the loads room does
std::vector<loads::Engagement> engagements_of(const MechanismCase& mechanism,
                                              const loads::Mechanism& with);

/// With its pins and the motion of its driver.
/// @throws base::InputError where the loads room does
loads::DrivenMechanism driven_mechanism(const MechanismCase& mechanism);

/// Sizes that are given or follow from Johnson's proportions.
MechanismSizes sizes_of(const MechanismCase& mechanism);

/// Radius of the core at which a roller's stud is held in the plane [m].
double stud_core_radius(const MechanismCase& mechanism);

/// Where the case wants the analysis [rad].
double analysed_angle(const MechanismCase& mechanism, const loads::DrivenMechanism& driven,
                      const loads::WheelTrain& train);

/// What follows from a case without being asked for, in words: proportions beyond Johnson's table,
/// the place of a four-bar Geneva's wheel.
std::vector<std::string> notices_of(const MechanismCase& mechanism, base::UnitSystem units);

}  // namespace geneva::model
