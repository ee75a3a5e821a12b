#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// Pressure, force, torque and stresses over the engagements, of cycle.json.
ReportPart cycle_part(const ResultsDirectory& results);

}  // namespace geneva::post
