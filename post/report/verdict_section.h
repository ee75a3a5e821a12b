#pragma once

#include "post/report/report_part.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// What `geneva run` found: the figure that the case is about and the nearest limit, the table
/// beside closed forms and published values, warnings, limits, inputs and checks.
ReportPart verdict_part(const ResultsDirectory& results);

}  // namespace geneva::post
