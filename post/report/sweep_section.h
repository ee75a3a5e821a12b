#pragma once

#include "post/report/report_part.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// The figures of a case over some of its parameters, from sweep.json.
ReportPart sweep_part(const ResultsDirectory& results);

}  // namespace geneva::post
