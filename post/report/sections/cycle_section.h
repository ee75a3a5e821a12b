#pragma once

#include <string>

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// Pressure, force, torque and stresses over the engagements, of cycle.json.
/// @param field the place of the fields on the page; may be empty
AnsweredPart cycle_part(const ResultsDirectory& results, const std::string& field);

}  // namespace geneva::post
