#pragma once

#include "post/report/report_part.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// The pin as it is beside the one with the most even line load, from crown.json and crown.csv.
ReportPart crown_part(const ResultsDirectory& results);

}  // namespace geneva::post
