#pragma once

#include <string>
#include <vector>

#include "post/report/chart.h"

namespace geneva::post {

/// Part of a report: HTML, and the charts that belong to places in it.
struct ReportPart {
  std::string html;
  std::vector<Chart> charts;
};

}  // namespace geneva::post
