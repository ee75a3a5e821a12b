#pragma once

#include "post/report/report_part.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// The best dimensions, from optimum.json.
ReportPart optimum_part(const ResultsDirectory& results);

}  // namespace geneva::post
