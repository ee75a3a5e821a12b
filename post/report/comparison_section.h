#pragma once

#include <vector>

#include "post/report/report_part.h"
#include "post/report/results_directory.h"

namespace geneva::post {

/// Runs side by side, in the units of the first: the rows of their closing tables, their curves
/// laid over each other, their pictures.
/// @param all two or more
/// @throws base::InputError if one of them holds no run
ReportPart comparison_part(const std::vector<ResultsDirectory>& all);

}  // namespace geneva::post
