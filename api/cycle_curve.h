#pragma once

#include <vector>

#include "loads/motion/driven_mechanism.h"
#include "loads/motion/kinematics.h"
#include "loads/motion/pin_load.h"
#include "post/output/cycle_output.h"

namespace geneva::api {

/// Force exactly, pressure by its ratio to Hertz's, at fine steps of the engagements solved.
std::vector<post::CycleCurvePoint> curve_of(const std::vector<post::CyclePoint>& points,
                                            const loads::DrivenMechanism& driven,
                                            const loads::WheelTrain& train,
                                            const loads::PinContact& contact);

/// Work and heat of the first engagement, by Simpson's rule at fine steps.
post::CycleWork work_of(const loads::DrivenMechanism& driven, const loads::WheelTrain& train);

}  // namespace geneva::api
