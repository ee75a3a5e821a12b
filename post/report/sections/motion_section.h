#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// What `geneva kinematics` computed: characteristic values, and curves beside those of the
/// drawing.
ReportPart kinematics_part(const ResultsDirectory& results);

/// What `geneva design` computed: the wheels, and the pressure against the wheel's diameter.
AnsweredPart design_part(const ResultsDirectory& results);

}  // namespace geneva::post
