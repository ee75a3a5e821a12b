#pragma once

#include <string>
#include <vector>

#include "post/report/chart.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// Part of a report: HTML, and the charts that belong to places in it.
struct ReportPart {
  std::string html;
  std::vector<Chart> charts;
};

/// What `geneva run` computed: verdict, checks, warnings, pressure, depth, convergence, in space
/// line load.
ReportPart run_part(const ResultsDirectory& results);

}  // namespace geneva::post
