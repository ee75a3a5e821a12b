#pragma once

#include "post/report/results/results_directory.h"
#include "post/report/sections/report_part.h"

namespace geneva::post {

/// The contact without finite elements, from estimate.json and estimate.csv.
ReportPart estimate_part(const ResultsDirectory& results);

}  // namespace geneva::post
