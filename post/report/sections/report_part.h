#pragma once

#include <string>
#include <utility>
#include <vector>

#include "post/report/pictures/chart.h"

namespace geneva::post {

/// Part of a report: HTML, and the charts that belong to places in it.
struct ReportPart {
  ReportPart() = default;
  /// Moves from complete values: g++ 12 destroys the text twice where the charts beside it cannot
  /// be copied.
  ReportPart(std::string text, std::vector<Chart> its_charts)
      : html(std::move(text)), charts(std::move(its_charts)) {}

  std::string html;
  std::vector<Chart> charts;
};

/// What a command answers, and what lies behind; the inputs stand between them.
struct AnsweredPart {
  ReportPart answer;
  ReportPart details;
};

}  // namespace geneva::post
