#pragma once

#include <string>
#include <vector>

#include "post/report/results/results_directory.h"

namespace geneva::post {

/// "NAME: TITLE" of the case.
std::string page_title(const ResultsDirectory& results);

/// Title and title block of a report.
std::string page_head(const ResultsDirectory& results);

/// The same of a comparison: what its runs have in common once, and what tells them apart.
std::string comparison_head(const std::vector<ResultsDirectory>& all);

}  // namespace geneva::post
