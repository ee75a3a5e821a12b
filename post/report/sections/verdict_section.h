#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The answer of a run in large type: the figure that the case is about and the nearest limit.
std::string run_answer(const ResultsDirectory& results, base::UnitSystem units);

/// What `geneva run` found: the figure that the case is about and the nearest limit, the table
/// beside closed forms and published values, warnings and limits.
ReportPart verdict_part(const ResultsDirectory& results);

/// What a run can check of itself: equilibrium, torque, work.
ReportPart checks_part(const ResultsDirectory& results);

}  // namespace geneva::post
