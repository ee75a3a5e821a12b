#pragma once

#include "post/report/report_part.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// The contact without finite elements, from estimate.json and estimate.csv.
ReportPart estimate_part(const ResultsDirectory& results);

}  // namespace geneva::post
